//! Variables of the environment that bound or date the work of a command.

use etalon_base::date::source_date_epoch;
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use std::num::NonZero;

/// Threads beyond the number of cores that a variable may set: more take longer to start than they
/// save.
const MOST_THREADS: usize = 64;

/// Rejects values that no command can use, by the name of the variable, and starts at most as many
/// threads as are of use. Results do not depend on the number of threads.
pub(super) fn check() -> Result<()> {
    let mut problems = Problems::default();
    if let Err(wrong) = source_date_epoch() {
        problems.0.extend(wrong.0);
    }
    let most = MOST_THREADS.max(std::thread::available_parallelism().map_or(1, NonZero::get));
    if stated("RAYON_NUM_THREADS").is_some_and(|threads| threads > most) {
        // a second command of one process finds the threads of the first
        let _ = rayon::ThreadPoolBuilder::new().num_threads(most).build_global();
    }
    // the library of tables reads its variable itself
    let name = "POLARS_MAX_THREADS";
    if let Some(threads) = stated(name).filter(|threads| *threads > most) {
        problems.0.push(error!("environment-threads", name, threads, most));
    }
    problems.check().map(drop)
}

/// Number in a variable.
fn stated(name: &str) -> Option<usize> {
    let text = std::env::var(name).ok()?;
    let text = text.trim();
    // more digits than a number holds are still a number
    text.parse().ok().or_else(|| (!text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())).then_some(usize::MAX))
}
