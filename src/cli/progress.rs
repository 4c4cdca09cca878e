//! Progress on the last line of a terminal during long commands: a bar if the amount of work is
//! known, otherwise a spinner.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{JoinHandle, spawn};
use std::time::Duration;

/// Shorter commands show nothing.
const PATIENCE: Duration = Duration::from_secs(2);
const TICK: Duration = Duration::from_millis(200);

static SHOWN: OnceLock<ProgressBar> = OnceLock::new();

/// Owner of the line; removes it at the end.
pub(super) struct Bar(Option<(Sender<()>, JoinHandle<()>)>);

impl Bar {
    /// Shows the line after two seconds, if stderr is a terminal.
    pub(super) fn start() -> Self {
        if !std::io::stderr().is_terminal() {
            return Self(None);
        }
        let bar = SHOWN.get_or_init(|| {
            let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
            bar.with_style(style("{spinner} {elapsed_precise}"))
        });
        let (end, ended) = channel();
        let waiting = spawn(move || {
            if ended.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                bar.set_draw_target(ProgressDrawTarget::stderr());
                bar.enable_steady_tick(TICK);
            }
        });
        Self(Some((end, waiting)))
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        if let Some((end, waiting)) = self.0.take() {
            drop(end);
            let _ = waiting.join();
            SHOWN.get().inspect(|bar| bar.finish_and_clear());
        }
    }
}

/// Shows how much of a command's work is done.
pub(super) fn progress(ended: usize, of: usize) {
    let Some(bar) = SHOWN.get() else { return };
    if bar.length() != Some(of as u64) {
        bar.set_style(style("{bar:40} {pos} of {len}, {elapsed_precise}, {eta_precise} left"));
        bar.set_length(of as u64);
    }
    bar.set_position(ended as u64);
}

/// Writes to the terminal without disturbing the line.
pub(super) fn beside<T>(write: impl FnOnce() -> T) -> T {
    match SHOWN.get() {
        Some(bar) => bar.suspend(write),
        None => write(),
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
