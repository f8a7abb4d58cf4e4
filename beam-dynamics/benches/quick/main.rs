//! The quick bench: ratios of elements, factorization, steps, statics, modes, strips, maps and start-up,
//! each with a limit; the exit code is 1 if a ratio is beyond it.
//!
//! All times are processor times, the shortest of several runs, and each is divided by a time that
//! is measured alternately with it: the time of faer on the same matrix, of another size of the
//! same model, or of the [`yardstick`]. Limits of times are about twice the values of an idle
//! machine: other work on the machine changes ratios by some tenths, while pivots that are not
//! kept, a second Jacobian per step or a search through the whole model cost more. An exponent that
//! is 0.2 larger is a time that is two to three times larger at the largest size; a start-up with
//! quadratic time would have 100 instead of 10.
//!
//! `cargo bench -p beam-dynamics --bench quick`

#[path = "../common/cantilever.rs"]
mod cantilever;
mod chain;
mod elements;
mod equilibria;
#[path = "../common/factors.rs"]
mod factors;
#[path = "../common/line.rs"]
mod line;
mod maps;
#[path = "../common/one_thread.rs"]
mod one_thread;
mod operations;
mod rows;
mod runs;
mod strips;
mod table;
mod yardstick;

use std::process::ExitCode;
use std::time::Instant;

use rows::Group;
use yardstick::Yardstick;

fn main() -> ExitCode {
    let begin = Instant::now();
    let mut yardstick = Yardstick::new();
    one_thread::on_one_thread();
    let groups: [(&str, Group); 8] = [
        ("element", rows::element),
        ("LU", rows::factorization),
        ("step of beams", rows::swinging),
        ("step of bodies", rows::mechanisms),
        ("statics and modes", equilibria::equilibria),
        ("strips", strips::strips),
        ("map", maps::maps),
        ("start-up", rows::starting),
    ];
    let (mut rows, mut failed) = (Vec::new(), Vec::new());
    for (name, group) in groups {
        match group(&mut yardstick) {
            Some(of) => rows.extend(of),
            None => failed.push(format!("{name}: a run failed")),
        }
    }
    table::print(&rows);
    println!(
        "yardstick: {:.2} us, {:.1} Gflop/s; the whole bench took {:.0} s",
        1e6 * yardstick.time(),
        1e-9 * yardstick.rate(),
        begin.elapsed().as_secs_f64(),
    );
    failed.extend(table::breaches(&rows));
    for breach in &failed {
        eprintln!("{breach}");
    }
    if failed.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
