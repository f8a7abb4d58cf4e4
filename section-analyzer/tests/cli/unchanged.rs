//! Sections that are not solved again, and changes after which they are.

use crate::workplace::Workplace;

const UNCHANGED: &str = "\nUnchanged since the last run (--force solves again)\n";

fn analyze(workplace: &Workplace, more: &[&str]) -> String {
    let run = workplace.run(&[&["analyze", "a.section.toml"], more].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    run.out
}

fn is_unchanged(workplace: &Workplace) -> bool {
    analyze(workplace, &[]).contains(UNCHANGED)
}

/// Sets the time of a file back, to detect whether it is written later.
fn age(workplace: &Workplace, file: &str) {
    let file = std::fs::File::options()
        .append(true)
        .open(workplace.path(file))
        .unwrap();
    file.set_modified(std::time::UNIX_EPOCH).unwrap();
}

fn is_old(workplace: &Workplace, file: &str) -> bool {
    let about = std::fs::metadata(workplace.path(file)).unwrap();
    about.modified().unwrap() == std::time::UNIX_EPOCH
}

#[test]
fn a_second_run_shows_the_report_and_writes_nothing() {
    let workplace = Workplace::with(&[], &[]);
    let first = analyze(&workplace, &[]);
    for file in [
        "a.properties.json",
        "a.report.txt",
        "a.mesh.png",
        "a.analysis.json",
    ] {
        age(&workplace, &format!("results/{file}"));
    }
    let second = analyze(&workplace, &[]);
    let (report, written) = first.split_once("\nWritten\n").unwrap();
    let (same_report, files) = second.split_once(UNCHANGED).unwrap();
    assert_eq!(report, same_report);
    assert_eq!(
        written.strip_suffix("  results/a.analysis.json\n"),
        Some(files)
    );
    for file in [
        "a.properties.json",
        "a.report.txt",
        "a.mesh.png",
        "a.analysis.json",
    ] {
        assert!(is_old(&workplace, &format!("results/{file}")), "{file}");
    }
    assert!(!analyze(&workplace, &["--force"]).contains(UNCHANGED));
    assert!(!is_old(&workplace, "results/a.properties.json"));
}

#[test]
fn what_was_read_counts() {
    let angles = ("plane_angle = 0", "plane_angle = { table = \"a.csv\" }");
    let workplace = Workplace::with(&[angles], &[]);
    workplace.write("a.csv", "cell, angle\n12, 10\n");
    analyze(&workplace, &[]);
    assert!(is_unchanged(&workplace));
    for (file, from, to) in [
        ("a.csv", "10", "20"),
        ("a.section.toml", "density = \"7850", "density = \"7851"),
        ("two.msh", "6 2 1 0", "6 2.5 1 0"),
    ] {
        let text = workplace.read(file);
        workplace.write(file, &text.replace(from, to));
        assert!(!is_unchanged(&workplace), "{file}");
        assert!(is_unchanged(&workplace), "{file}");
    }
}

#[test]
fn results_that_are_missing_or_changed_are_made_again() {
    let workplace = Workplace::with(&[], &[]);
    analyze(&workplace, &[]);
    let names = [
        "a.properties.json",
        "a.report.txt",
        "a.mesh.png",
        "a.warping.png",
        "a.warping.vtu",
    ];
    for name in names {
        let file = workplace.path(&format!("results/{name}"));
        let content = std::fs::read(&file).unwrap();
        std::fs::remove_file(&file).unwrap();
        assert!(!is_unchanged(&workplace), "{name} missing");
        assert!(std::fs::read(&file).unwrap() == content, "{name}");
        std::fs::write(&file, [&content[..], b" "].concat()).unwrap();
        assert!(!is_unchanged(&workplace), "{name} changed");
        assert!(std::fs::read(&file).unwrap() == content, "{name}");
    }
    assert!(is_unchanged(&workplace));
}

/// A record with other or no content is ignored.
#[test]
fn a_damaged_record_is_made_again() {
    let workplace = Workplace::with(&[], &[]);
    analyze(&workplace, &[]);
    let record = workplace.read("results/a.analysis.json");
    let other = record.replace("\"made_from\": \"sha256:", "\"made_from\": \"sha256:0");
    for text in ["", "{}", "null", &record[..record.len() / 2], &other] {
        workplace.write("results/a.analysis.json", text);
        assert!(!is_unchanged(&workplace), "{text}");
        assert_eq!(workplace.read("results/a.analysis.json"), record);
    }
    assert!(is_unchanged(&workplace));
}

/// Other folders have their own records; a section with a wrong file is reported as
/// wrong, regardless of its results.
#[test]
fn records_belong_to_folders_and_do_not_hide_problems() {
    let workplace = Workplace::with(&[], &[]);
    analyze(&workplace, &[]);
    assert!(!analyze(&workplace, &["--out", "other"]).contains(UNCHANGED));
    assert!(analyze(&workplace, &["--out", "other"]).contains(UNCHANGED));
    let section = workplace.read("a.section.toml");
    workplace.write(
        "a.section.toml",
        &section.replace("poisson = 0.3", "poisson = 0.7"),
    );
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
}

/// A file of an earlier run that this run no longer writes is removed; other files stay.
#[test]
fn files_that_are_no_longer_written_go() {
    let workplace = Workplace::with(&[], &[]);
    analyze(&workplace, &[]);
    let record = workplace.read("results/a.analysis.json");
    let first = "{\n      \"name\": \"a.properties.json\"";
    let more = format!("{{\"name\": \"a.old.csv\", \"content\": \"\"}},\n    {first}");
    assert_eq!(record.matches(first).count(), 1);
    workplace.write("results/a.analysis.json", &record.replacen(first, &more, 1));
    workplace.write("results/a.old.csv", "of an earlier run");
    workplace.write("results/a.notes.csv", "by hand");
    assert!(!is_unchanged(&workplace));
    assert!(!workplace.path("results/a.old.csv").exists());
    assert!(workplace.path("results/a.notes.csv").exists());
}

/// Without the record of the previous run, for example after an interruption, its files
/// are not known.
#[test]
fn constants_go_with_the_isotropic_material_also_without_a_record() {
    let workplace = Workplace::with(&[], &[]);
    analyze(&workplace, &[]);
    let constants = workplace.path("results/a.constants.csv");
    assert!(constants.exists());
    std::fs::remove_file(workplace.path("results/a.analysis.json")).unwrap();
    let plies = "e1 = 40\ne2 = 9\ne3 = 9\ng12 = 4\ng13 = 4\ng23 = 3\n\
                 nu12 = 0.3\nnu13 = 0.3\nnu23 = 0.4";
    let text = workplace.read("a.section.toml");
    let text = text.replace("young = 210\npoisson = 0.3", plies);
    workplace.write("a.section.toml", &text);
    analyze(&workplace, &[]);
    assert!(!constants.exists());
}

/// Names of the results, in order.
fn results(workplace: &Workplace) -> Vec<String> {
    let files = std::fs::read_dir(workplace.path("results")).unwrap();
    let names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

/// A run without figures differs from a run with figures: each makes its own files and
/// removes the files of the other; all files except figures are equal to the last bit.
#[test]
fn a_run_without_figures_is_another_run() {
    const BARE: &[&str] = &["--no-figures"];
    let workplace = Workplace::with(&[], &[]);
    analyze(&workplace, &[]);
    let drawn = results(&workplace);
    let field = workplace.read("results/a.warping.vtu");
    let properties = workplace.read("results/a.properties.json");
    for name in ["a.mesh.png", "a.warping.png"] {
        assert!(drawn.iter().any(|found| found == name), "{name}");
    }

    let bare = analyze(&workplace, BARE);
    let (written, removed) = bare.split_once("\nRemoved: ").unwrap();
    assert!(!bare.contains(UNCHANGED) && !written.contains(".png"));
    assert!(removed.contains("  results/a.mesh.png\n"), "{bare}");
    assert!(analyze(&workplace, BARE).contains(UNCHANGED));
    let is_figure = |name: &String| name.ends_with(".png") || name.ends_with(".svg");
    let left: Vec<_> = drawn.iter().filter(|name| !is_figure(name)).collect();
    assert_eq!(results(&workplace).iter().collect::<Vec<_>>(), left);
    assert_eq!(workplace.read("results/a.warping.vtu"), field);
    assert_eq!(workplace.read("results/a.properties.json"), properties);

    assert!(!is_unchanged(&workplace));
    assert!(is_unchanged(&workplace));
    assert_eq!(results(&workplace), drawn);
}

/// Each figure is a PNG and an SVG.
#[test]
fn each_figure_is_drawn_in_both_formats() {
    let workplace = Workplace::with(&[], &[]);
    analyze(&workplace, &[]);
    let both = results(&workplace);
    let (png, svg) = (
        both.iter().filter(|name| name.ends_with(".png")),
        both.iter().filter(|name| name.ends_with(".svg")),
    );
    let names = |name: &String| name[..name.len() - 4].to_owned();
    let png: Vec<_> = png.map(names).collect();
    assert!(png.len() > 1);
    assert_eq!(png, svg.map(names).collect::<Vec<_>>());
    let drawn = workplace.read("results/a.warping.svg");
    assert!(drawn.contains("warping per unit internal force"));
}

/// Without the record of the previous run its figures are not known.
#[test]
fn figures_go_without_a_record_too() {
    let loads = (
        "plane_angle = 0\n",
        "plane_angle = 0\n\n[load.tip]\naxial = \"1 N\"\n",
    );
    let workplace = Workplace::with(&[loads], &[]);
    analyze(&workplace, &[]);
    let figures = |names: Vec<String>| {
        let is_figure = |name: &&String| name.ends_with(".png") || name.ends_with(".svg");
        let figures = names.iter().filter(is_figure);
        figures.count()
    };
    assert!(figures(results(&workplace)) > 3);
    std::fs::remove_file(workplace.path("results/a.analysis.json")).unwrap();
    analyze(&workplace, &["--no-figures"]);
    assert_eq!(figures(results(&workplace)), 0);
    let stress = |more: &[&str]| {
        let run = workplace.run(&[&["stress", "a.section.toml"], more].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        figures(results(&workplace))
    };
    assert!(stress(&[]) > 0);
    assert_eq!(stress(&["--no-figures"]), 0);
}

/// The files are the same; only problems are printed.
#[test]
fn a_quiet_run_prints_problems_only() {
    let workplace = Workplace::with(&[], &[]);
    let run = workplace.run(&["analyze", "a.section.toml", "--quiet", "--no-figures"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", ""));
    assert!(!workplace.read("results/a.report.txt").is_empty());
    let warned = Workplace::with(&[("fiber_angle = 0", "fiber_angle = 45")], &[]);
    for _ in ["solved", "unchanged"] {
        let run = warned.run(&["analyze", "a.section.toml", "-q", "--no-figures"]);
        let warning = "warning: a.section.toml: region \"web\" has a fiber angle, but its material \
                       \"steel\" is isotropic: the angle does not change its stiffness\n";
        assert_eq!(
            (run.code, run.out.as_str(), run.err.as_str()),
            (0, "", warning)
        );
    }
    let run = workplace.run(&["stress", "a.section.toml", "-q"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(run.err.contains("has no load case"), "{}", run.err);
}

/// A run without an option removes the results of the option, and lists them without a report too.
#[test]
fn a_quiet_run_says_what_it_removes() {
    const FILE: &str = "results/a.sensitivity.json";
    let workplace = Workplace::with(&[], &[]);
    let plain = ["analyze", "a.section.toml", "--no-figures", "-q"];
    let requested = [&plain[..], &["--sensitivity"]].concat();
    let removed = format!("removed: {FILE}, of an earlier run\n");
    for (arguments, err) in [
        (&requested[..], ""),
        (&plain, removed.as_str()),
        (&plain, ""),
    ] {
        let run = workplace.run(arguments);
        let reported: Vec<_> = run.err.lines().filter(|line| line.contains(FILE)).collect();
        assert_eq!(
            (run.code, reported.concat()),
            (0, err.trim_end().to_owned())
        );
    }
}

/// The lock of a file that another run writes is named, and the one of a killed run is not a lock.
#[test]
fn two_runs_do_not_write_the_same_results() {
    let workplace = Workplace::with(&[], &[]);
    let load = ["--axial", "1"];
    let analyze = ["analyze", "a.section.toml", "--no-figures"];
    let stress = [&["stress", "a.section.toml", "--no-figures"], &load[..]].concat();
    assert_eq!(workplace.run(&analyze).code, 0);
    let lock = workplace.path("results/a.section.lock");
    let other = shared_geom::run_lock::RunLock::new(&lock).unwrap();
    for arguments in [&[&analyze[..], &["--force"]].concat(), &stress] {
        let run = workplace.run(arguments);
        let expected = format!(
            "error: \"results/a.section.lock\" is locked: the run of process {} is writing results \
             of this name into this folder\n  help: wait for its end, ",
            std::process::id()
        );
        assert!(run.err.starts_with(&expected), "{}", run.err);
        assert_eq!(run.code, 2);
    }
    drop(other);
    workplace.write("results/a.section.lock", "4194304999\n");
    assert_eq!(workplace.run(&stress).code, 0);
    assert!(!lock.exists());
}

/// Warnings are a part of the report; without a report they are on the error stream, of the
/// results of an earlier run too.
#[test]
fn a_quiet_run_hides_no_warning() {
    let workplace = Workplace::with(&[("fiber_angle = 0", "fiber_angle = 45")], &[]);
    let warning = "warning: a.section.toml: region \"web\" has a fiber angle, but its material \
                   \"steel\" is isotropic: the angle does not change its stiffness\n";
    for command in [
        &["check"][..],
        &["analyze", "--no-figures"],
        &["analyze", "--no-figures"],
    ] {
        let run = workplace.run(&[command, &["a.section.toml", "-q"]].concat());
        let found = (run.code, run.out.as_str(), run.err.as_str());
        assert_eq!(found, (0, "", warning), "{command:?}");
    }
    workplace.write("b.section.toml", &workplace.read("a.section.toml"));
    let many = [
        "analyze",
        "a.section.toml",
        "b.section.toml",
        "--no-figures",
    ];
    let run = workplace.run(&[&many[..], &["-q"]].concat());
    let both = warning.replace("a.section.toml", "a.section.toml, b.section.toml");
    let found = (run.code, run.out.as_str(), run.err.as_str());
    assert_eq!(found, (0, "", both.as_str()));
    let run = workplace.run(&many);
    assert_eq!(run.err, "");
    assert!(run.out.contains("  1 remark\n"), "{}", run.out);
}

/// The figures of a check are the ones that the options request; others are removed.
#[test]
fn a_check_draws_the_requested_figures() {
    let workplace = Workplace::with(&[], &[]);
    let is_there = |file: &str| workplace.path("o").join(file).exists();
    let check = |more: &[&str]| {
        let run = workplace.run(&[&["check", "a.section.toml", "--out", "o"], more].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        run.out
    };
    assert!(check(&[]).ends_with("Written\n  o/a.mesh.png\n  o/a.mesh.svg\n"));
    assert!(is_there("a.mesh.png") && is_there("a.mesh.svg"));
    let removed = "No problem found\n\nRemoved: results of an earlier run\n  o/a.mesh.png\n  \
                   o/a.mesh.svg\n";
    assert!(check(&["--no-figures"]).ends_with(removed));
    assert!(!is_there("a.mesh.png") && !is_there("a.mesh.svg"));
}
