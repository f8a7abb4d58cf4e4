//! Fifty sections of five thousand nodes on the average, of the IEA 15 MW blade from 0.1 to 0.6 of its
//! span: `blade` on one thread and on two, over the single analyses of the same section files.
//!
//! The limits: with two threads an efficiency of 85 %, and less than 1.5 times
//! the sum of the analyses; they hold on a machine without other work.

use std::ffi::OsString;
use std::path::Path;
use std::time::{Duration, Instant};
use std::{fs, io};

use section_analyzer::cli;

const BLADE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../tests/reference/layups/windio1_iea15.yaml"
);
/// Size of the cells, for which the sections have five thousand nodes on the average.
const MESH: &str = "\n[mesh]\nsize = 0.042\n";
/// Number of stations, and the first and last one.
const STATIONS: (usize, [f64; 2]) = (50, [0.1, 0.6]);
/// Runs of each kind, of which the shortest counts.
const RUNS: usize = 3;
/// Least efficiency of two threads, and largest ratio to the sum of the analyses.
const LIMITS: (f64, f64) = (0.85, 1.5);

/// Runs the program; returns its time.
fn run(words: &[&str]) -> Duration {
    let words = ["section-analyzer"].iter().chain(words);
    let words: Vec<OsString> = words.map(|word| (*word).into()).collect();
    let mut errors = Vec::new();
    let start = Instant::now();
    let code = cli::run(words, &mut io::sink(), &mut errors);
    let time = start.elapsed();
    assert!(code == 0, "{}", String::from_utf8_lossy(&errors));
    time
}

/// Solves all sections into a new folder.
fn blade(layup: &str, out: &Path, threads: &str) -> Duration {
    // a missing folder is none
    drop(fs::remove_dir_all(out));
    let (count, [from, to]) = STATIONS;
    let eta = |k: usize| from + (to - from) * k as f64 / (count - 1) as f64;
    let stations: Vec<String> = (0..count).map(|k| format!("{:.4}", eta(k))).collect();
    let out = out.display().to_string();
    let options = ["--no-figures", "--threads", threads];
    let words = [
        "blade",
        layup,
        "--out",
        &out,
        "--stations",
        &stations.join(","),
    ];
    run(&[&words[..], &options].concat())
}

/// Analyzes the section files of a blade one after the other.
fn single(sections: &Path, out: &Path) -> Duration {
    let files = fs::read_dir(sections).expect("the sections");
    let files = files.map(|file| file.expect("a file").path());
    let files = files.filter(|file| file.to_string_lossy().ends_with(".section.toml"));
    let out = out.display().to_string();
    let one = |file: std::path::PathBuf| {
        let file = file.display().to_string();
        run(&["analyze", &file, "--no-figures", "--force", "--out", &out])
    };
    files.map(one).sum()
}

fn main() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let layup = folder.path().join("fine.layup.toml").display().to_string();
    run(&["layup", BLADE, "--out", &layup]);
    let text = fs::read_to_string(&layup).expect("the layup");
    fs::write(&layup, text + MESH).expect("the layup with the size of cells");
    let (out, others) = (folder.path().join("fine"), folder.path().join("single"));
    let mut best = [Duration::MAX; 3];
    for _ in 0..RUNS {
        let times = [
            blade(&layup, &out, "1"),
            blade(&layup, &out, "2"),
            single(&out.join("sections"), &others),
        ];
        for (best, time) in best.iter_mut().zip(times) {
            *best = time.min(*best);
        }
    }
    let [one, two, sum] = best.map(|time| time.as_secs_f64());
    let (efficiency, ratio) = (0.5 * one / two, one / sum);
    println!(
        "{} sections: one thread {one:.2} s, two threads {two:.2} s, single analyses {sum:.2} s",
        STATIONS.0
    );
    println!("one thread over the single analyses    {ratio:.2}");
    println!(
        "efficiency of two threads              {:.0} %",
        100.0 * efficiency
    );
    assert!(
        efficiency > LIMITS.0 && ratio < LIMITS.1,
        "expected an efficiency above {} and a ratio below {}",
        LIMITS.0,
        LIMITS.1
    );
}
