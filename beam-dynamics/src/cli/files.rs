//! Several files of one command: in parallel, on the threads of rayon, and reported in
//! their order.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use rayon::iter::{ParallelBridge, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::DONE;
use super::progress::{Overview, PARTS};
use super::terminal::{Message, Terminal};

/// Stack of a thread \[bytes\], as large as of a main thread, so that a file needs no more
/// when it runs in parallel with others.
const STACK: usize = 8 << 20;

/// Interval of the progress display.
const TICK: Duration = Duration::from_millis(200);

/// A message or the result of a job.
enum Event<R> {
    Said(usize, Message),
    Ended(usize, R),
}

/// Runs every job and prints its output, with two empty lines between the texts of two
/// jobs; returns the largest exit code.
pub(super) fn worst_of<T: Sync>(
    jobs: &[T],
    terminal: &mut Terminal<'_>,
    answer: impl Fn(&T, &mut Terminal<'_>) -> u8 + Sync,
) -> u8 {
    let numbered: Vec<_> = jobs.iter().enumerate().collect();
    let codes = each(&numbered, terminal, |(number, job), terminal| {
        if *number > 0 {
            terminal.show("\n\n");
        }
        answer(job, terminal)
    });
    codes.into_iter().max().unwrap_or(DONE)
}

/// Runs every job; returns the results in the order of the jobs.
///
/// The output is the same, in the same order, for any number of threads: messages of the
/// first unfinished job are printed immediately, messages of later jobs in their turn. One
/// job, or one thread, uses the terminal directly.
pub(super) fn each<T: Sync, R: Send>(
    jobs: &[T],
    terminal: &mut Terminal<'_>,
    answer: impl Fn(&T, &mut Terminal<'_>) -> R + Sync,
) -> Vec<R> {
    let pool = if jobs.len() > 1 { threads() } else { None };
    match pool {
        Some(pool) => side_by_side(&pool, jobs, terminal, &answer),
        None => jobs.iter().map(|job| answer(job, terminal)).collect(),
    }
}

/// Threads as set by `RAYON_NUM_THREADS`, or one per core; `None` if there is only one, or
/// if they cannot be started.
fn threads() -> Option<ThreadPool> {
    let pool = ThreadPoolBuilder::new().stack_size(STACK).build().ok()?;
    (pool.current_num_threads() > 1).then_some(pool)
}

/// Runs the jobs on the threads of `pool`; the calling thread writes to the terminal.
fn side_by_side<T: Sync, R: Send>(
    pool: &ThreadPool,
    jobs: &[T],
    terminal: &mut Terminal<'_>,
    answer: &(impl Fn(&T, &mut Terminal<'_>) -> R + Sync),
) -> Vec<R> {
    let parts: Vec<_> = jobs.iter().map(|_| AtomicU64::new(0)).collect();
    let (sender, receiver) = channel();
    let mut listener = Listener::new(&parts, terminal);
    // The scope ends when all jobs have ended, and passes on a panic.
    pool.in_place_scope(|scope| {
        scope.spawn(|_| {
            // In their order: the first texts are complete first.
            let jobs = jobs.iter().zip(&parts).enumerate().par_bridge();
            jobs.for_each_with(sender, |sender, (number, (job, part))| {
                let result = answer(job, &mut sending(sender, number, part));
                part.store(PARTS, Ordering::Relaxed);
                // The receiver exists until the last sender is dropped.
                let _ = sender.send(Event::Ended(number, result));
            });
        });
        listener.listen(&receiver);
    });
    listener.results.into_iter().flatten().collect()
}

/// The terminal of job `number`.
fn sending<'a, R>(sender: &Sender<Event<R>>, number: usize, part: &'a AtomicU64) -> Terminal<'a>
where
    R: 'a,
{
    let sender = sender.clone();
    let send = move |message| {
        let _ = sender.send(Event::Said(number, message));
    };
    Terminal::sending(Box::new(send), part)
}

/// Prints the messages of all jobs in the order of the jobs.
struct Listener<'a, 'b, R> {
    terminal: &'a mut Terminal<'b>,
    overview: Overview<'a>,
    /// Messages of each job that are not printed yet.
    waiting: Vec<Vec<Message>>,
    /// Results of the jobs that have ended.
    results: Vec<Option<R>>,
    /// The first job that has not ended; its messages are printed immediately.
    first: usize,
}

impl<'a, 'b, R> Listener<'a, 'b, R> {
    fn new(parts: &'a [AtomicU64], terminal: &'a mut Terminal<'b>) -> Self {
        Self {
            terminal,
            overview: Overview::new(parts),
            waiting: parts.iter().map(|_| Vec::new()).collect(),
            results: parts.iter().map(|_| None).collect(),
            first: 0,
        }
    }

    /// Receives until all jobs have ended.
    fn listen(&mut self, receiver: &Receiver<Event<R>>) {
        loop {
            match receiver.recv_timeout(TICK) {
                Ok(event) => self.take(event),
                Err(RecvTimeoutError::Timeout) => self.overview.show(),
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        self.overview.finish();
        // Remaining messages, if a job has panicked.
        while self.first < self.waiting.len() {
            self.report_first();
            self.first += 1;
        }
    }

    fn take(&mut self, event: Event<R>) {
        match event {
            Event::Said(number, message) => self.waiting[number].push(message),
            Event::Ended(number, result) => self.results[number] = Some(result),
        }
        self.report_first();
        while self.results.get(self.first).is_some_and(Option::is_some) {
            self.first += 1;
            self.report_first();
        }
    }

    /// Prints the waiting messages of the first job that has not ended.
    fn report_first(&mut self) {
        let Some(waiting) = self.waiting.get_mut(self.first) else {
            return;
        };
        if waiting.is_empty() {
            return;
        }
        let messages = std::mem::take(waiting);
        let terminal = &mut self.terminal;
        self.overview.above(|| {
            for message in messages {
                terminal.take(message);
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;
    use std::sync::mpsc::sync_channel;
    use std::time::Instant;

    /// Longest time for which a job waits for another one.
    const PATIENCE: Duration = Duration::from_secs(60);

    /// Both streams as one text, an error line with a mark before it.
    struct Both<'a>(&'a Mutex<String>, &'static str);

    impl std::io::Write for Both<'_> {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            let mut text = self.0.lock().unwrap();
            text.push_str(self.1);
            text.push_str(std::str::from_utf8(bytes).unwrap());
            Ok(bytes.len())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    fn pool(threads: usize) -> ThreadPool {
        ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap()
    }

    /// The text that `work` writes to both streams.
    fn written(work: impl FnOnce(&mut Terminal<'_>)) -> String {
        let text = Mutex::new(String::new());
        let (mut out, mut err) = (Both(&text, ""), Both(&text, "!"));
        work(&mut Terminal::new(&mut out, &mut err));
        text.into_inner().unwrap()
    }

    fn lines(job: usize, terminal: &mut Terminal<'_>) {
        terminal.show(&format!("{job} begins\n"));
        if job == 1 {
            terminal.report_text("wrong");
        }
        terminal.show(&format!("{job} ends\n"));
    }

    const LINES: &str = "0 begins\n0 ends\n1 begins\n!wrong!\n1 ends\n2 begins\n2 ends\n";

    /// The last job ends first, since the others wait for it.
    #[test]
    fn texts_and_results_keep_the_order_of_the_jobs() {
        let (done, waits) = sync_channel(3);
        let waits = Mutex::new(waits);
        let shown = written(|terminal| {
            let results = side_by_side(&pool(3), &[0, 1, 2], terminal, &|job: &usize, terminal| {
                match job {
                    2 => (0..2).for_each(|_| done.send(()).unwrap()),
                    _ => waits.lock().unwrap().recv_timeout(PATIENCE).unwrap(),
                }
                lines(*job, terminal);
                10 * job
            });
            assert_eq!(results, [0, 10, 20]);
        });
        assert_eq!(shown, LINES);
        let alone = written(|terminal| (0..3).for_each(|job| lines(job, terminal)));
        assert_eq!(alone, LINES);
    }

    /// The messages of the first job are printed while it runs.
    #[test]
    fn the_first_job_does_not_wait_for_its_end() {
        let text = Mutex::new(String::new());
        let (mut out, mut err) = (Both(&text, ""), Both(&text, "!"));
        let mut terminal = Terminal::new(&mut out, &mut err);
        let is_reported = || text.lock().unwrap().contains("0 begins");
        side_by_side(&pool(2), &[0, 1], &mut terminal, &|job: &i32, terminal| {
            terminal.show(&format!("{job} begins\n"));
            let start = Instant::now();
            while *job == 0 && !is_reported() && start.elapsed() < PATIENCE {
                std::thread::yield_now();
            }
            assert!(*job > 0 || is_reported());
        });
        assert_eq!(*text.lock().unwrap(), "0 begins\n1 begins\n");
    }

    #[test]
    fn a_panic_of_one_job_continues_after_the_others_are_reported() {
        let text = Mutex::new(String::new());
        let caught = std::panic::catch_unwind(|| {
            let (mut out, mut err) = (Both(&text, ""), Both(&text, "!"));
            let mut terminal = Terminal::new(&mut out, &mut err);
            let both = std::sync::Barrier::new(2);
            side_by_side(&pool(2), &[0, 1], &mut terminal, &|job: &i32, terminal| {
                terminal.show(&format!("{job} begins\n"));
                // jobs that have not begun before a panic are left out
                both.wait();
                assert_ne!(*job, 0, "a job that panics");
            });
        });
        assert!(caught.is_err());
        assert_eq!(*text.lock().unwrap(), "0 begins\n1 begins\n");
    }

    #[test]
    fn the_worst_code_counts() {
        let shown = written(|terminal| {
            let code = worst_of(&[0_u8, 2, 1], terminal, |code, terminal| {
                terminal.show(&format!("{code}\n"));
                *code
            });
            assert_eq!(code, 2);
            assert_eq!(worst_of(&[], terminal, |code: &u8, _| *code), DONE);
        });
        assert_eq!(shown, "0\n\n\n2\n\n\n1\n");
    }
}
