//! The progress display of many sections, on the error stream if it is a terminal.

use std::fmt::Write;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use super::Job;

/// Progress of a run with the time left, and the sections being solved.
///
/// It draws in the calling thread only.
pub(super) struct Progress {
    bar: ProgressBar,
    under_way: Vec<String>,
}

impl Progress {
    /// The display of `count` sections; hidden if the stream is not a terminal.
    pub fn new(count: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(count as u64), ProgressDrawTarget::stderr());
        let style =
            ProgressStyle::with_template("[{elapsed}{left}] {bar:24} {pos}/{len} {wide_msg}");
        let left = |state: &ProgressState, text: &mut dyn Write| {
            // a text that cannot be written is not shown
            let _ = text.write_str(&left(state.pos(), state.eta()));
        };
        let style = style.map(|style| style.with_key("left", left));
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self {
            bar,
            under_way: Vec::new(),
        }
    }

    /// Marks a section as being solved.
    pub fn begun(&mut self, job: &Job) {
        self.under_way.push(job.name.clone());
        self.bar.set_message(self.under_way.join(", "));
    }

    /// Marks a section as finished.
    pub fn ended(&mut self, job: &Job) {
        if let Some(position) = self.under_way.iter().position(|name| *name == job.name) {
            self.under_way.remove(position);
        }
        self.bar.set_message(self.under_way.join(", "));
        self.bar.inc(1);
    }

    /// Updates the elapsed time.
    pub fn tick(&self) {
        self.bar.tick();
    }

    /// Runs `work`, which writes to the terminal, while the display is hidden.
    pub fn above<T>(&self, work: impl FnOnce() -> T) -> T {
        self.bar.suspend(work)
    }

    /// Removes the display.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// The time left as the display shows it; unknown until a section is finished.
fn left(finished: u64, time: Duration) -> String {
    match finished {
        0 => String::new(),
        _ => format!(", {:#} left", HumanDuration(time)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_left_is_shown_from_the_first_finished_section() {
        assert_eq!(left(0, Duration::ZERO), "");
        assert_eq!(left(1, Duration::from_secs(60)), ", 60s left");
    }
}
