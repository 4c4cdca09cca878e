//! State of the server that all connections share, and its bounds.

use crate::desk::Desk;
use crate::events::Events;
use std::io;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Bounds on times, sizes and numbers.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Connections at the same time; more are rejected.
    pub connections: usize,
    /// Open pages.
    pub pages: usize,
    /// Time for the head of a request.
    pub head: Duration,
    /// Time for the body of a request, and for reading an answer.
    pub body: Duration,
    /// Largest file (bytes).
    pub file_bytes: usize,
    /// Largest other request (bytes).
    pub request_bytes: usize,
    /// Time after which the server ends when the last page is closed.
    pub closed: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            connections: 64,
            pages: 16,
            head: Duration::from_secs(3),
            body: Duration::from_secs(60),
            file_bytes: 256 << 20,
            request_bytes: 1 << 20,
            closed: Duration::from_secs(60),
        }
    }
}

/// State that all connections share.
pub(crate) struct Shared {
    pub desk: Arc<dyn Desk>,
    pub events: Events,
    pub token: String,
    pub port: u16,
    pub limits: Limits,
    pub pages: Arc<AtomicUsize>,
    pub connections: Arc<AtomicUsize>,
    /// Time since which no page is open; `None` before the first page.
    idle_since: Mutex<Option<Instant>>,
    pub ended: AtomicBool,
}

/// A count that ends with its connection or page.
pub(crate) struct Counted(Arc<AtomicUsize>);

impl Counted {
    /// Counts one more; `None` beyond the bound.
    pub fn new(count: &Arc<AtomicUsize>, most: usize) -> Option<Self> {
        let add = |n: usize| (n < most).then_some(n + 1);
        count.fetch_update(Ordering::SeqCst, Ordering::SeqCst, add).ok().map(|_| Self(count.clone()))
    }
}

impl Drop for Counted {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

impl Shared {
    pub fn new(desk: Arc<dyn Desk>, events: Events, token: String, port: u16, limits: Limits) -> Self {
        let (pages, connections) = (Arc::default(), Arc::default());
        let (idle_since, ended) = (Mutex::new(None), AtomicBool::new(false));
        Self { desk, events, token, port, limits, pages, connections, idle_since, ended }
    }

    /// Notes that a page is open now.
    pub fn note_page(&self) {
        *self.idle_since.lock().unwrap_or_else(PoisonError::into_inner) = Some(Instant::now());
    }

    /// `true` if the last page has been closed for the given time.
    pub fn is_idle(&self) -> bool {
        let since = *self.idle_since.lock().unwrap_or_else(PoisonError::into_inner);
        self.pages.load(Ordering::SeqCst) == 0 && since.is_some_and(|since| since.elapsed() >= self.limits.closed)
    }
}

/// A nonce or token: 128 random bits in hexadecimal digits.
///
/// # Errors
/// Fails if the system has no random numbers.
pub(crate) fn random() -> io::Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|e| io::Error::other(e.to_string()))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
