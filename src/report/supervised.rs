//! Supervision of a laboratory's templates: a template that does not terminate, or exhausts memory,
//! is stopped.

use etalon_base::error;
use etalon_base::message::Result;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Time limit; pages take a second, the largest reports with thousands of poses several.
const LONGEST: Duration = Duration::from_secs(60);
/// Limit of memory growth of the process (bytes).
const LARGEST: u64 = 2 << 30;
/// Stack size (bytes), as templates may be deeply nested.
const STACK: usize = 64 << 20;

/// Runs `render` with the template `name`; built-in templates are not supervised.
///
/// # Errors
///
/// Fails after a minute or beyond 2 GiB. The template continues until the process ends, which
/// follows an error.
pub(super) fn supervised<T: Send + 'static>(
    name: &str,
    own: bool,
    render: impl FnOnce() -> Result<T> + Send + 'static,
) -> Result<T> {
    if !own {
        return render();
    }
    let fail = |fault: &str| error!("template-failed", template = name, fault);
    let (sender, receiver) = channel();
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(move || drop(sender.send(render())));
    thread.map_err(|e| fail(&e.to_string()))?;
    let (begun, before) = (Instant::now(), resident());
    loop {
        match receiver.recv_timeout(Duration::from_millis(10)) {
            Ok(made) => return made,
            Err(RecvTimeoutError::Disconnected) => return Err(fail("ended").into()),
            Err(RecvTimeoutError::Timeout) if begun.elapsed() > LONGEST => {
                return Err(fail("time").into());
            }
            Err(RecvTimeoutError::Timeout) if resident().saturating_sub(before) > LARGEST => {
                return Err(fail("memory").into());
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

/// Resident memory of the process (bytes); 0 if the system does not report it.
fn resident() -> u64 {
    let pages = std::fs::read_to_string("/proc/self/statm").ok();
    let pages = pages.and_then(|text| text.split_whitespace().nth(1)?.parse::<u64>().ok());
    pages.unwrap_or(0) * 4096
}
