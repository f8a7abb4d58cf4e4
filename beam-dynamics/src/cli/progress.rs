//! Progress of a run in time, or of several files in parallel: bars, only on a terminal.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicU64, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::input::short_number;

/// Number of parts of a run that a bar distinguishes.
pub(super) const PARTS: u64 = 10_000;

/// Progress of one run.
pub(super) enum Progress<'a> {
    /// A bar for the only run.
    Alone(ProgressBar),
    /// Parts done of a run in parallel with others, shown by the overview.
    Beside(&'a AtomicU64),
}

impl<'a> Progress<'a> {
    /// Of a run in parallel with others, whose parts done are `beside`, or with a bar of
    /// its own.
    pub fn new(beside: Option<&'a AtomicU64>) -> Self {
        let alone = || bar(PARTS, "{bar:40} {percent:>3} %  at {msg} s  {eta} left");
        beside.map_or_else(|| Self::Alone(alone()), Self::Beside)
    }

    /// Of a search, whose place is a text.
    pub fn of_search(beside: Option<&'a AtomicU64>) -> Self {
        let alone = || bar(PARTS, "{bar:40} {percent:>3} %  {msg}");
        beside.map_or_else(|| Self::Alone(alone()), Self::Beside)
    }

    /// Shows that `part` of a search, between zero and one, is done, with its place.
    pub fn note(&self, part: f64, place: &str) {
        let position = (part * PARTS as f64) as u64;
        match self {
            Self::Alone(bar) if bar.is_hidden() => {}
            Self::Alone(bar) => {
                bar.set_position(position);
                bar.set_message(place.to_owned());
            }
            Self::Beside(parts) => parts.store(position, Ordering::Relaxed),
        }
    }

    /// Shows that `part` of the run, between zero and one, is done, up to `time` \[s\].
    pub fn show(&self, part: f64, time: f64) {
        // A part of a run is between zero and one.
        let position = (part * PARTS as f64) as u64;
        match self {
            Self::Alone(bar) if bar.is_hidden() => {}
            Self::Alone(bar) => {
                bar.set_position(position);
                bar.set_message(short_number(time, 6));
            }
            Self::Beside(parts) => parts.store(position, Ordering::Relaxed),
        }
    }

    /// Starts the clock for the time left.
    pub fn begin(&self) {
        if let Self::Alone(bar) = self {
            bar.reset_eta();
        }
    }

    /// Removes the bar.
    pub fn finish(&self) {
        if let Self::Alone(bar) = self {
            bar.finish_and_clear();
        }
    }
}

/// Progress of all files, in one bar drawn by the calling thread.
pub(super) struct Overview<'a> {
    bar: ProgressBar,
    parts: &'a [AtomicU64],
}

impl<'a> Overview<'a> {
    /// Of files whose parts done are `parts`.
    pub fn new(parts: &'a [AtomicU64]) -> Self {
        let length = PARTS * parts.len() as u64;
        Self {
            bar: bar(length, "{bar:40} {percent:>3} %  {msg}  {eta} left"),
            parts,
        }
    }

    /// Shows the present progress.
    pub fn show(&self) {
        if self.bar.is_hidden() {
            return;
        }
        let parts = || self.parts.iter().map(|part| part.load(Ordering::Relaxed));
        let done = parts().filter(|part| *part == PARTS).count();
        self.bar
            .set_message(format!("{done} of {} files", self.parts.len()));
        self.bar.set_position(parts().sum());
    }

    /// Runs `work`, which writes to the terminal, while the bar is hidden.
    pub fn above(&self, work: impl FnOnce()) {
        self.bar.suspend(work);
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A bar of `length` on a terminal, invisible elsewhere.
fn bar(length: u64, template: &str) -> ProgressBar {
    let target = if std::io::stderr().is_terminal() {
        ProgressDrawTarget::stderr()
    } else {
        ProgressDrawTarget::hidden()
    };
    let bar = ProgressBar::with_draw_target(Some(length), target);
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
