//! How far a run in time is, or several files side by side are: bars on a terminal alone.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicU64, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::input::short_number;

/// Parts of a run that a bar tells apart.
pub(super) const PARTS: u64 = 10_000;

/// How far one run is.
pub(super) enum Progress<'a> {
    /// Of the only run: a bar of its own.
    Alone(ProgressBar),
    /// Of a run beside others: its parts, which the overview shows.
    Beside(&'a AtomicU64),
}

impl<'a> Progress<'a> {
    /// Of a run whose parts are `beside` those of others, or which has a bar of its own.
    pub fn new(beside: Option<&'a AtomicU64>) -> Self {
        let alone = || bar(PARTS, "{bar:40} {percent:>3} %  at {msg} s  {eta} left");
        beside.map_or_else(|| Self::Alone(alone()), Self::Beside)
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

    /// The time left is counted from here on.
    pub fn begin(&self) {
        if let Self::Alone(bar) = self {
            bar.reset_eta();
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Self::Alone(bar) = self {
            bar.finish_and_clear();
        }
    }
}

/// How far all files are, in one bar that the calling thread draws.
pub(super) struct Overview<'a> {
    bar: ProgressBar,
    parts: &'a [AtomicU64],
}

impl<'a> Overview<'a> {
    /// Of files of which `parts` are done.
    pub fn new(parts: &'a [AtomicU64]) -> Self {
        let length = PARTS * parts.len() as u64;
        Self {
            bar: bar(length, "{bar:40} {percent:>3} %  {msg}  {eta} left"),
            parts,
        }
    }

    /// Shows how far they are now.
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

    /// Does `work`, which writes to the terminal, while the bar is away.
    pub fn above(&self, work: impl FnOnce()) {
        self.bar.suspend(work);
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A bar of `length` on a terminal, which no one sees elsewhere.
fn bar(length: u64, template: &str) -> ProgressBar {
    let target = match std::io::stderr().is_terminal() {
        true => ProgressDrawTarget::stderr(),
        false => ProgressDrawTarget::hidden(),
    };
    let bar = ProgressBar::with_draw_target(Some(length), target);
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
