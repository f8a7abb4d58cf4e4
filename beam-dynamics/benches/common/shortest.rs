//! Processor time of work that is repeated.

use std::hint::black_box;
use std::time::{Duration, Instant};

use cpu_time::ThreadTime;

/// The shortest processor time of the runs within `span`, three at least: on a machine
/// that does other things as well it is the steadiest figure.
pub fn shortest<T>(span: Duration, mut work: impl FnMut() -> T) -> Duration {
    let (begin, mut best, mut runs) = (Instant::now(), Duration::MAX, 0);
    while runs < 3 || begin.elapsed() < span {
        let start = ThreadTime::now();
        black_box(work());
        best = best.min(start.elapsed());
        runs += 1;
    }
    best
}
