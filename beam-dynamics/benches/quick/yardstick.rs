//! The unit of time of the quick bench: the dense LU factorization with partial pivoting of
//! a fixed 36 x 36 matrix by nalgebra.
//!
//! It contains none of our code, so that it is independent of changes of our code. It is compiled
//! for the same processor as our elements, whereas a library that chooses wider registers at run
//! time would change the ratios from machine to machine. Its 10 KB remain in the L1 cache, like the
//! matrices of an element: three other processes with continuous memory traffic changed it by 4 %,
//! and the factorization and the product of faer by 14 %.

use std::hint::black_box;
use std::time::{Duration, Instant};

use cpu_time::ThreadTime;
use nalgebra::SMatrix;

use crate::factors::Scattered;

const SIZE: usize = 36;
/// Factorizations between two readings of the clock: some tenths of a millisecond.
const REPEATS: u32 = 16;
/// Repetitions of the yardstick for one of the work.
const TURNS: usize = 4;

pub struct Yardstick {
    matrix: SMatrix<f64, SIZE, SIZE>,
    /// Shortest time of a factorization so far.
    shortest: Duration,
}

impl Yardstick {
    pub fn new() -> Self {
        let mut scattered = Scattered(3);
        Self {
            matrix: SMatrix::from_fn(|_, _| scattered.next()),
            shortest: Duration::MAX,
        }
    }

    #[inline(never)]
    fn run(&mut self) {
        let begin = ThreadTime::now();
        for _ in 0..REPEATS {
            black_box(black_box(self.matrix).lu());
        }
        self.shortest = self.shortest.min(begin.elapsed() / REPEATS);
    }

    /// Shortest time so far [s].
    pub fn time(&self) -> f64 {
        self.shortest.as_secs_f64()
    }

    /// Operations a second [1/s].
    pub fn rate(&self) -> f64 {
        2.0 / 3.0 * (SIZE as f64).powi(3) / self.time()
    }

    /// Repeats `work`, which returns its own time, alternately with the yardstick for the time
    /// `span`, at least three times; returns the shortest time, `None` if `work` fails once.
    pub fn beside(&mut self, span: Duration, mut work: impl FnMut() -> Option<f64>) -> Option<f64> {
        let (begin, mut best, mut runs) = (Instant::now(), f64::INFINITY, 0);
        while runs < 3 || begin.elapsed() < span {
            (0..TURNS).for_each(|_| self.run());
            best = best.min(work()?);
            runs += 1;
        }
        Some(best)
    }
}
