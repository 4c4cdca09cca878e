//! Forked processes: the threads of the parent do not exist in them.

use std::process::id;
use std::sync::OnceLock;

/// Process that made the first call.
static FIRST: OnceLock<u32> = OnceLock::new();

/// `true` in a process that was forked since the first call: a pool of threads of its parent waits
/// there for ever.
pub fn threads_are_lost() -> bool {
    *FIRST.get_or_init(id) != id()
}
