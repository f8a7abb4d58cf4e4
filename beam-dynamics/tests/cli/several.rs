//! Several files of one command: run in parallel, reported one after the other.

use std::fs::{self, File};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::loads::{ARCH, STRIP};
use super::transient::{BEAM, beam};
use super::{BLADE, Folder, Run};

const FILES: [&str; 3] = ["a.dynamics.toml", "b.dynamics.toml", "c.dynamics.toml"];

/// Heading of the times of a run, which differ from run to run.
const TIMES: &str = "time [s]  share [%]  per iteration [us]";

/// The output without the times of runs: without the table from its heading to an empty
/// line.
fn without_times(text: &str) -> String {
    let mut is_time = false;
    let kept = text.split_inclusive('\n').filter(|line| {
        is_time = line.trim_end().ends_with(TIMES) || (is_time && !line.trim().is_empty());
        !is_time
    });
    kept.collect()
}

/// `command` on `files` with some threads.
fn prepared(folder: &Folder, command: &str, files: &[&str], threads: &str) -> Command {
    let arguments: Vec<_> = [command].into_iter().chain(files.iter().copied()).collect();
    let mut prepared = folder.command(&arguments);
    prepared.env("RAYON_NUM_THREADS", threads);
    prepared
}

/// Runs `command` on `files` with some threads; returns both streams.
fn apart(folder: &Folder, command: &str, files: &[&str], threads: &str) -> Run {
    let output = prepared(folder, command, files, threads).output().unwrap();
    Run {
        code: output.status.code().unwrap(),
        out: without_times(&String::from_utf8(output.stdout).unwrap()),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// The same with both streams written to one file: the code, and the file.
fn together(
    folder: &Folder,
    command: &str,
    files: &[&str],
    threads: &str,
) -> (Option<i32>, String) {
    let both = File::create(folder.path("both.txt")).unwrap();
    let mut together = prepared(folder, command, files, threads);
    together.stdout(both.try_clone().unwrap()).stderr(both);
    let code = together.status().unwrap().code();
    (code, without_times(&folder.read("both.txt")))
}

/// Both streams, and both in one file.
fn run(folder: &Folder, command: &str, files: &[&str], threads: &str) -> (Run, String) {
    let apart = apart(folder, command, files, threads);
    let (code, together) = together(folder, command, files, threads);
    assert_eq!(code, Some(apart.code));
    (apart, together)
}

/// Files of which the first takes longest and the middle one ends early, with the expected
/// message.
fn requested() -> Vec<(&'static str, [String; 3], &'static str)> {
    let late = "[[load]]\nname = \"late\"\nnode = \"blade/tip\"\nforce = [1, 0, 0]\n\
                drive = \"= sqrt(0.01 - t)\"\n";
    let long = BLADE.replace(
        "speeds = [0, 750]",
        "speeds = { from = 0, to = 750, steps = 4 }",
    );
    let twisted = BLADE.replace("sweep = 30", "sweep = 60\ntwist = 40");
    let pulled = |force: f64| {
        format!(
            "{STRIP}[[load]]\nnode = \"blade/tip\"\nforce = [{force}, 0, 0.001]\n[static]\n\
             [buckling]\ncount = 2\n"
        )
    };
    vec![
        (
            "transient",
            [beam(0.4), format!("{}{late}", beam(0.1)), beam(0.02)],
            "\"late\" has no value at 0.01",
        ),
        (
            "static",
            [pulled(1.0), format!("{ARCH}[static]\n"), pulled(2.0)],
            "error: b: limit point near the load factor ",
        ),
        (
            "buckling",
            [pulled(-0.1), format!("{STRIP}[buckling]\n"), pulled(-0.2)],
            "error: b: no load grows",
        ),
        (
            "modes",
            [
                long,
                twisted.replace("[0, 750]", "[0, 1e7]"),
                BLADE.to_owned(),
            ],
            "error: b: no steady equilibrium at ",
        ),
    ]
}

/// The reference is one run after the other: the text of each file alone, two empty lines
/// between them; the middle one fails, the last one is still run.
#[test]
fn what_is_printed_does_not_depend_on_the_number_of_threads() {
    for (command, texts, reported) in requested() {
        let folder = Folder::new();
        for (file, text) in FILES.iter().zip(&texts) {
            folder.write(file, text);
        }
        let alone = FILES.map(|file| apart(&folder, command, &[file], "1"));
        let codes = alone.each_ref().map(|run| run.code);
        assert_eq!(codes, [0, 1, 0], "{command}: {}", alone[1].err);
        assert!(alone[1].err.contains(reported), "{}", alone[1].err);
        let out = alone.each_ref().map(|run| run.out.as_str()).join("\n\n");
        let (one, in_one_file) = run(&folder, command, &FILES, "1");
        assert_eq!((one.code, one.err.as_str()), (1, alone[1].err.as_str()));
        assert_eq!(one.out, out, "{command}");
        // Each stream with two threads; with three threads also the order of both.
        fs::remove_dir_all(folder.path("results")).unwrap();
        let more = apart(&folder, command, &FILES, "2");
        assert_eq!((more.code, &more.err), (1, &one.err), "{command}");
        assert_eq!(more.out, one.out, "{command}");
        assert!(folder.path("results").is_dir());
        fs::remove_dir_all(folder.path("results")).unwrap();
        let reported = together(&folder, command, &FILES, "3");
        assert_eq!(reported, (Some(1), in_one_file), "{command}");
        assert!(folder.path("results").is_dir());
    }
}

/// Nothing runs if one input is wrong; all problems are reported, in order.
#[test]
fn wrong_files_are_reported_in_their_order() {
    let folder = Folder::new();
    folder.write(
        FILES[0],
        &beam(0.1).replace("mass", "mas").replace("units", "unit"),
    );
    folder.write(FILES[1], &beam(0.1));
    folder.write(FILES[2], BEAM.replace("m = 2", "mm = 2").as_str());
    let (one, together) = run(&folder, "transient", &FILES, "1");
    assert_eq!((one.code, one.out.as_str()), (2, ""));
    let [first, last] = [FILES[0], FILES[2]].map(|file| one.err.find(file).unwrap());
    assert!(first < last && !one.err.contains(FILES[1]), "{}", one.err);
    let (two, reported_together) = run(&folder, "transient", &FILES, "2");
    assert_eq!((two.code, two.out.as_str()), (2, ""));
    assert_eq!((two.err, reported_together), (one.err, together));
    assert!(!folder.path("results").exists());
}

/// `describe` describes all files, even if one is wrong.
#[test]
fn blade_files_are_described_in_their_order() {
    let folder = Folder::new();
    let files = [
        "strip.properties.json",
        "none.blade.json",
        "strip.properties.json",
    ];
    let (one, together) = run(&folder, "describe", &files, "1");
    assert_eq!(one.code, 2);
    assert!(one.err.contains("none.blade.json"), "{}", one.err);
    let (two, reported_together) = run(&folder, "describe", &files, "2");
    assert_eq!((two.code, two.out, two.err), (2, one.out, one.err));
    assert_eq!(reported_together, together);
}

/// Two runs that do not end: both write their rows.
#[test]
fn two_files_are_under_way_at_the_same_time() {
    let folder = Folder::new();
    let files = &FILES[..2];
    for file in files {
        folder.write(file, &beam(1000.0));
    }
    let mut command = folder.command(&["transient", files[0], files[1]]);
    command.env("RAYON_NUM_THREADS", "2").stdout(Stdio::null());
    let mut endless = command.spawn().unwrap();
    let rows = |table: &str| {
        let text = fs::read_to_string(folder.path(table));
        text.map_or(0, |text| text.lines().count())
    };
    let tables = ["results/a.transient.csv", "results/b.transient.csv"];
    let both = || tables.iter().all(|table| rows(table) > 20);
    let patience = Instant::now();
    while !both() && patience.elapsed() < Duration::from_secs(300) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let is_under_way = endless.try_wait().unwrap().is_none();
    endless.kill().unwrap();
    endless.wait().unwrap();
    assert!(is_under_way && both());
}

/// The same file twice would be two runs that write into the same files at the same time.
#[test]
fn one_file_in_two_ways_is_refused() {
    let folder = Folder::new();
    folder.write(FILES[0], &beam(0.1));
    let run = folder.run(&["transient", FILES[0], "./a.dynamics.toml"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    let reported = "error: \"./a.dynamics.toml\" is given twice, expected it once\n";
    assert!(run.err.starts_with(reported), "{}", run.err);
    assert!(!folder.path("results").exists());
}

/// Two runs that write the same files at the same time would mix them. A lock of a killed run is
/// none.
#[test]
fn two_runs_of_a_command_in_one_folder_are_refused() {
    let folder = Folder::new();
    folder.write(
        FILES[0],
        &format!("{ARCH}[static]\nto = 0.1\n[buckling]\ncount = 1\n"),
    );
    std::fs::create_dir(folder.path("results")).unwrap();
    for (command, other) in [("static", "buckling"), ("buckling", "static")] {
        let name = format!("results/a.{command}.lock");
        let lock = folder.path(&name);
        let held = shared_geom::run_lock::RunLock::new(&lock).unwrap();
        let run = folder.run(&[command, FILES[0]]);
        let expected = format!(
            "error: \"{name}\" is locked: the run of process {} is writing results of this name into \
             this folder\n  help: wait for its end, or use another folder with --out; a run that was \
             killed locks nothing\n",
            std::process::id()
        );
        assert_eq!((run.code, run.out, run.err), (2, String::new(), expected));
        assert_eq!(folder.run(&[other, FILES[0]]).code, 0);
        drop(held);
        folder.write(&name, "4194304999\n");
        let run = folder.run(&[command, FILES[0]]);
        assert_eq!((run.code, lock.exists()), (0, false), "{}", run.err);
    }
}

/// Results that a run removes are listed, without a report on the error stream.
#[test]
fn removed_results_are_listed() {
    const FIGURES: [&str; 2] = ["results/a.path.png", "results/a.path.svg"];
    let folder = Folder::new();
    folder.write(FILES[0], &format!("{ARCH}[static]\nto = 0.1\n"));
    let bare = ["static", FILES[0], "--no-figures"];
    let quiet = [&bare[..], &["-q"]].concat();
    for arguments in [&bare[..], &quiet] {
        assert_eq!(folder.run(&["static", FILES[0]]).code, 0);
        let run = folder.run(arguments);
        let (text, begin, end) = match run.out.is_empty() {
            true => (&run.err, "removed: ", ", of an earlier run\n"),
            false => (&run.out, "  ", "\n"),
        };
        for figure in FIGURES {
            assert!(text.contains(&format!("{begin}{figure}{end}")), "{text}");
        }
        assert_eq!(run.code, 0);
        assert!(!folder.run(arguments).err.contains("removed: "));
    }
}
