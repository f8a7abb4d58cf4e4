//! Many sections: in parallel, with one line each in the order in which they were
//! given.

use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::Duration;

use rayon::iter::{ParallelBridge, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::Job;
use super::alike::Alike;
use super::lines::Lines;
use super::outcome::Outcome;
use super::progress::Progress;
use crate::cli::{NOT_REACHED, Stop, Terminal, list_removed};

/// Stack of a thread \[bytes\]: as large as the stack of a main thread, so that a section
/// that can be solved alone can also be solved with others.
const STACK: usize = 8 << 20;

/// Interval at which the progress display updates its clock.
const TICK: Duration = Duration::from_millis(200);

/// Message of a thread about the section of a given index.
enum Event {
    Begun(usize),
    Ended(usize, Box<Outcome>),
}

/// Solves a section, of a given index.
type Solve<'a> = &'a (dyn Fn(usize, &Job) -> Outcome + Sync);

/// The end of a run with many sections.
#[derive(Debug)]
pub(in crate::cli) struct Ended {
    /// The exit code of the worst section.
    pub worst: u8,
    /// Reason for which the terminal accepts no more output.
    pub closed: Option<std::io::Error>,
}

impl Ended {
    /// The result of the command.
    pub fn result(self) -> Result<(), Stop> {
        match (self.worst, self.closed) {
            (0, None) => Ok(()),
            (0, Some(error)) => Err(Stop::Closed(error)),
            (code, _) => Err(Stop::Reported(code)),
        }
    }
}

/// Solves all sections by `solve`, each on one of `threads` threads, and reports the outcome of
/// each.
///
/// The terminal belongs to the calling thread; the others only send it their outcomes. A
/// section depends only on its own files, so that the results do not depend on the number
/// of threads.
pub(in crate::cli) fn solve_all(
    jobs: &[Job],
    threads: Option<NonZeroUsize>,
    solve: Solve<'_>,
    terminal: &mut Terminal<'_>,
) -> Result<Ended, Stop> {
    let threads = threads.or_else(|| std::thread::available_parallelism().ok());
    let threads = threads.map_or(1, NonZeroUsize::get).min(jobs.len());
    let pool = ThreadPoolBuilder::new()
        .num_threads(threads)
        .stack_size(STACK)
        .build();
    let pool = pool.map_err(|error| {
        terminal.report_text(
            &format!("error: {threads} threads cannot be started: {error}"),
            NOT_REACHED,
        )
    })?;
    let (sender, receiver) = channel();
    std::thread::scope(|scope| {
        scope.spawn(|| send_outcomes(&pool, jobs, solve, sender));
        let mut listener = Listener::new(jobs, terminal);
        loop {
            match receiver.recv_timeout(TICK) {
                Ok(event) => listener.take(event),
                Err(RecvTimeoutError::Timeout) => listener.progress.tick(),
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        Ok(listener.finish())
    })
}

/// Solves the sections in the order of the list, as threads become free.
fn send_outcomes(pool: &ThreadPool, jobs: &[Job], solve: Solve<'_>, sender: Sender<Event>) {
    pool.install(|| {
        let jobs = jobs.iter().enumerate().par_bridge();
        jobs.for_each_with(sender, |sender, (number, job)| {
            // The receiver exists until the last sender is dropped.
            let _ = sender.send(Event::Begun(number));
            let outcome = Box::new(solve(number, job));
            let _ = sender.send(Event::Ended(number, outcome));
        });
    });
}

/// Reports outcomes in the order of the sections, each as soon as all previous ones are
/// reported.
struct Listener<'a, 'b> {
    jobs: &'a [Job],
    terminal: &'a mut Terminal<'b>,
    lines: Lines,
    progress: Progress,
    waiting: BTreeMap<usize, Box<Outcome>>,
    reported: usize,
    /// Problems, of which the first of a kind is shown at once.
    problems: Alike,
    /// Warnings, which reports contain.
    warnings: Alike,
    /// Removed results.
    removed: BTreeSet<PathBuf>,
    /// Reason for which the terminal accepts no more output. The run continues.
    closed: Option<std::io::Error>,
}

impl<'a, 'b> Listener<'a, 'b> {
    fn new(jobs: &'a [Job], terminal: &'a mut Terminal<'b>) -> Self {
        let mut listener = Self {
            jobs,
            terminal,
            lines: Lines::new(jobs),
            progress: Progress::new(jobs.len()),
            waiting: BTreeMap::new(),
            reported: 0,
            problems: Alike::default(),
            warnings: Alike::default(),
            removed: BTreeSet::new(),
            closed: None,
        };
        let heading = listener.lines.heading();
        listener.show(&heading, None);
        listener
    }

    fn take(&mut self, event: Event) {
        match event {
            Event::Begun(number) => self.progress.begun(&self.jobs[number]),
            Event::Ended(number, outcome) => {
                self.progress.ended(&self.jobs[number]);
                self.waiting.insert(number, outcome);
            }
        }
        while let Some(outcome) = self.waiting.remove(&self.reported) {
            self.removed.extend(outcome.removed.iter().cloned());
            let line = self.lines.of(&self.jobs[self.reported], &outcome);
            let label = &self.jobs[self.reported].label;
            if outcome.lists_warnings() {
                for text in &outcome.warnings {
                    self.warnings.add(text, label);
                }
            }
            // sections may share a problem
            let messages = outcome
                .messages(label, false)
                .filter(|text| self.problems.add(text, label));
            self.show(&line, messages.as_deref());
            self.reported += 1;
        }
    }

    /// Shows a line, followed by its problems, above the progress display.
    fn show(&mut self, line: &str, problems: Option<&str>) {
        if self.closed.is_some() {
            return;
        }
        let terminal = &mut self.terminal;
        let shown = self.progress.above(|| {
            writeln!(terminal.out, "{line}")?;
            terminal.out.flush()?;
            match problems {
                Some(problems) => writeln!(terminal.err, "{problems}"),
                None => Ok(()),
            }
        });
        self.closed = shown.err();
    }

    /// Shows the totals.
    fn finish(mut self) -> Ended {
        self.progress.finish();
        let mut sum = self.lines.sum();
        let mut problems: Vec<String> = self.problems.others().collect();
        if self.terminal.is_quiet {
            let warnings = self.warnings.texts();
            problems.extend(warnings.map(|text| format!("warning: {text}")));
        } else {
            let warnings = self.warnings.texts();
            sum.extend(warnings.map(|text| format!("\n  remark: {text}")));
        }
        let problems = Some(problems.join("\n")).filter(|all| !all.is_empty());
        self.show(&sum, problems.as_deref());
        let removed: Vec<_> = self.removed.into_iter().collect();
        let unlisted = list_removed(&removed, self.terminal).err();
        Ended {
            worst: self.lines.worst(),
            closed: self.closed.or(unlisted),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::analyze::outcome::Status;
    use std::io::{self, Write};
    use std::path::Path;

    fn jobs() -> Vec<Job> {
        let files = ["a.section.toml", "b.section.toml", "c.section.toml"];
        let job = |file: &str| Job::new(Path::new(file), None);
        files.map(job).to_vec()
    }

    fn ended(number: usize, status: Status) -> Event {
        let outcome = Outcome {
            problems: (status == Status::NotReached).then(|| format!("error: {number}")),
            ..Outcome::new(status)
        };
        Event::Ended(number, Box::new(outcome))
    }

    /// The last section ends first: its line waits for the others.
    #[test]
    fn lines_keep_the_order_of_the_sections() {
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let mut terminal = Terminal {
            out: &mut out,
            err: &mut err,
            is_quiet: false,
        };
        let jobs = jobs();
        let mut listener = Listener::new(&jobs, &mut terminal);
        (0..3).for_each(|number| listener.take(Event::Begun(number)));
        listener.take(ended(2, Status::NotReached));
        listener.take(ended(0, Status::Unchanged));
        assert_eq!((listener.reported, listener.waiting.len()), (1, 1));
        listener.take(ended(1, Status::Solved));
        assert!(matches!(
            listener.finish().result(),
            Err(Stop::Reported(NOT_REACHED))
        ));
        let out = String::from_utf8(out).unwrap();
        let lines: Vec<_> = out.lines().skip(1).collect();
        let expected = [
            "a.section.toml  unchanged",
            "b.section.toml  solved",
            "c.section.toml  failed",
            "",
            "3 sections: 1 solved, 1 unchanged, 1 failed",
        ];
        assert_eq!(lines, expected);
        assert_eq!(err, b"error: 2\n");
    }

    /// A stream on a full disk.
    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::Error::from(io::ErrorKind::StorageFull))
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    /// The run continues without output, and its exit code applies.
    #[test]
    fn lost_output_hides_no_failure() {
        for (status, code) in [(Status::Solved, None), (Status::WrongInput, Some(2))] {
            let mut err = Vec::new();
            let mut terminal = Terminal {
                out: &mut Full,
                err: &mut err,
                is_quiet: false,
            };
            let jobs = jobs();
            let mut listener = Listener::new(&jobs, &mut terminal);
            (0..3).for_each(|number| listener.take(ended(number, status)));
            assert_eq!(listener.reported, 3);
            match (listener.finish().result(), code) {
                (Err(Stop::Closed(error)), None) => {
                    assert_eq!(error.kind(), io::ErrorKind::StorageFull);
                }
                (Err(Stop::Reported(found)), Some(code)) => assert_eq!(found, code),
                (other, _) => panic!("{other:?}"),
            }
        }
    }
}
