//! Computations without the GIL: on threads that exist in this process, and until the caller
//! interrupts them.

use etalon_base::fork::threads_are_lost;
use etalon_base::interruption::{Interrupted, Interruption, checkpoint, interrupt};
use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::process::id;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread::Builder;
use std::time::Duration;

/// Stack of a thread that computes, as of the main thread.
const STACK: usize = 8 << 20;
/// Time between two looks for Ctrl-C.
const LOOK: Duration = Duration::from_millis(50);

/// Threads of a forked process, with its number.
static FORKED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Remembers the process in which the module was imported; in its children other threads compute.
pub fn remember_process() {
    threads_are_lost();
}

/// Runs a short computation without the GIL.
pub fn compute<R: Send>(py: Python<'_>, work: impl FnOnce() -> R + Send) -> PyResult<R> {
    py.detach(|| on_threads(work))
}

/// Runs a computation without the GIL, until Ctrl-C or an exception of `progress` ends it.
pub fn compute_long<R: Send>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    work: impl FnOnce(&Progress) -> R + Send,
) -> PyResult<R> {
    let progress = Progress { call: progress, raised: Mutex::new(None) };
    let reporter = &progress;
    let (ended, end) = channel::<()>();
    let outcome = py.detach(move || {
        std::thread::scope(|scope| {
            let run = move || {
                let outcome = catch_unwind(AssertUnwindSafe(|| on_threads(|| work(reporter))));
                drop(ended);
                outcome
            };
            let thread = Builder::new().stack_size(STACK).spawn_scoped(scope, run);
            let thread = thread.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
            let mut request = None;
            while end.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {
                if request.is_none()
                    && let Err(raised) = Python::attach(|py| py.check_signals())
                {
                    reporter.raise(raised);
                    request = Some(Interruption::request());
                }
            }
            Ok::<_, PyErr>(thread.join())
        })
    })?;
    if let Some(raised) = progress.raised() {
        return Err(raised);
    }
    match outcome.flatten() {
        Ok(outcome) => outcome,
        // by Ctrl-C during the computation of another thread
        Err(payload) if payload.is::<Interrupted>() => Err(PyKeyboardInterrupt::new_err(())),
        Err(payload) => resume_unwind(payload),
    }
}

/// Function of the caller that is told how much of the work is done.
pub struct Progress {
    call: Option<Py<PyAny>>,
    /// Exception that ends the computation.
    raised: Mutex<Option<PyErr>>,
}

impl Progress {
    /// Calls the function; ends the computation if it raises an exception.
    pub fn report(&self, done: usize, whole: usize) {
        checkpoint();
        let Some(call) = &self.call else { return };
        if let Err(raised) = Python::attach(|py| call.call1(py, (done, whole)).map(drop)) {
            self.raise(raised);
            interrupt();
        }
    }

    /// Keeps the first exception.
    fn raise(&self, raised: PyErr) {
        if let Ok(mut first) = self.raised.lock() {
            first.get_or_insert(raised);
        }
    }

    fn raised(&self) -> Option<PyErr> {
        self.raised.lock().ok()?.take()
    }
}

/// Runs work on threads of this process.
fn on_threads<R: Send>(work: impl FnOnce() -> R + Send) -> PyResult<R> {
    match threads_are_lost() {
        false => Ok(work()),
        true => Ok(forked_pool()?.install(work)),
    }
}

/// Threads of this forked process. If another thread of the parent held the lock during the fork,
/// the lock is never released here: the computation then has threads of its own.
fn forked_pool() -> PyResult<Arc<ThreadPool>> {
    let failed = |error: rayon::ThreadPoolBuildError| PyRuntimeError::new_err(error.to_string());
    let build = || ThreadPoolBuilder::new().stack_size(STACK).build().map(Arc::new).map_err(failed);
    let Ok(mut kept) = FORKED.try_lock() else { return build() };
    if let Some((process, pool)) = &*kept
        && *process == id()
    {
        return Ok(Arc::clone(pool));
    }
    let pool = build()?;
    // the threads of the parent's pool do not exist here: there is nothing to end
    std::mem::forget(kept.replace((id(), Arc::clone(&pool))));
    Ok(pool)
}
