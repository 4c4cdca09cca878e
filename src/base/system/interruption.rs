//! Computations that end early because their caller asks for it.
//!
//! A library has no process of its own to stop. Its caller requests the end with [`Interruption`],
//! and the loops of long computations call [`checkpoint`], which unwinds the stack to the caller.
//! The program makes no requests: Ctrl-C ends its process.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};

static REQUESTS: AtomicUsize = AtomicUsize::new(0);

/// Payload of the unwinding; the caller recognises it behind `catch_unwind`.
#[derive(Debug)]
pub struct Interrupted;

/// Request that all computations of the process end, until it is dropped.
#[derive(Debug)]
pub struct Interruption(());

impl Interruption {
    /// Requests the end of all computations of the process.
    pub fn request() -> Self {
        REQUESTS.fetch_add(1, Ordering::Relaxed);
        Self(())
    }
}

impl Drop for Interruption {
    fn drop(&mut self) {
        REQUESTS.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Unwinds to the caller if the end is requested; loops of long computations call it.
pub fn checkpoint() {
    if REQUESTS.load(Ordering::Relaxed) > 0 {
        interrupt();
    }
}

/// Unwinds to the caller, without the message of a panic.
pub fn interrupt() -> ! {
    resume_unwind(Box::new(Interrupted))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::catch_unwind;

    #[test]
    fn a_request_ends_computations_until_it_is_dropped() {
        checkpoint();
        let request = Interruption::request();
        let ended = catch_unwind(checkpoint).unwrap_err();
        assert!(ended.is::<Interrupted>());
        drop(request);
        checkpoint();
    }
}
