//! Templates of a laboratory are programs: one that does not end, or takes all memory, is stopped.

use etalon_base::message::{Message, Result};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Pages take a second; the largest reports of thousands of poses some.
const LONGEST: Duration = Duration::from_secs(60);
/// What the process may grow by, in bytes.
const LARGEST: u64 = 2 << 30;
/// Templates may call one another deeply.
const STACK: usize = 64 << 20;

/// What `face` makes of a template named `name`; a `face` that is built in is not watched.
///
/// # Errors
/// Where it takes more than a minute or 2 GiB. It goes on until the process ends, which follows on an error.
pub(super) fn supervised<T: Send + 'static>(
    name: &str,
    own: bool,
    face: impl FnOnce() -> Result<T> + Send + 'static,
) -> Result<T> {
    if !own {
        return face();
    }
    let fail = |what: &str| Message::error(format!("the template `{name}` {what}")).hint("does a loop in it not end?");
    let (sender, receiver) = channel();
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(move || drop(sender.send(face())));
    thread.map_err(|e| fail(&format!("cannot be read: {e}")))?;
    let (begun, before) = (Instant::now(), resident());
    loop {
        match receiver.recv_timeout(Duration::from_millis(10)) {
            Ok(made) => return made,
            Err(RecvTimeoutError::Disconnected) => return Err(fail("does not work").into()),
            Err(RecvTimeoutError::Timeout) if begun.elapsed() > LONGEST => {
                return Err(fail("takes more than a minute").into());
            }
            Err(RecvTimeoutError::Timeout) if resident().saturating_sub(before) > LARGEST => {
                return Err(fail("takes more than 2 GiB of memory").into());
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

/// Bytes of memory that the process has; 0 where the system has no such number.
fn resident() -> u64 {
    let pages = std::fs::read_to_string("/proc/self/statm").ok();
    let pages = pages.and_then(|text| text.split_whitespace().nth(1)?.parse::<u64>().ok());
    pages.unwrap_or(0) * 4096
}
