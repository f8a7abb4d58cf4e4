//! `--no-figures`: all other output is the same to the last bit.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::loads::STRIP;
use super::transient::beam;
use super::{BLADE, Folder};

/// Files that contain run times.
const TIMED: [&str; 2] = ["results/a.restart.json", "results/a.transient.txt"];

/// The files in a folder and its subfolders, with their contents.
fn contents(folder: &Folder, below: &str) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder.path(below)).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let path = format!("{below}/{name}");
        if folder.path(&path).is_dir() {
            found.extend(contents(folder, &path))
        } else {
            found.insert(path.clone(), fs::read(folder.path(&path)).unwrap());
        }
    }
    found
}

fn is_figure(path: &str) -> bool {
    let ending = Path::new(path).extension().unwrap();
    ending == "png" || ending == "svg"
}

/// Each command, its file, and its number of figures.
fn commands() -> [(&'static str, Vec<&'static str>, String, usize); 4] {
    let loaded = format!(
        "{STRIP}[[load]]\nnode = \"blade/tip\"\nforce = [-0.1, 0, 0.001]\n[static]\n\
         steps = 3\n[buckling]\ncount = 2\n"
    );
    [
        ("static", vec![], loaded.clone(), 6),
        ("buckling", vec![], loaded, 2),
        ("modes", vec!["--vtu"], BLADE.to_owned(), 6),
        ("transient", vec![], beam(0.1), 2),
    ]
}

/// Figures of the previous run are removed; a run without the option draws them again.
#[test]
fn a_run_without_figures_writes_all_else() {
    for (command, more, text, figures) in commands() {
        let folder = Folder::new();
        folder.write("a.dynamics.toml", &text);
        let run = |more: &[&str]| {
            let run = folder.run(&[&[command, "a.dynamics.toml"], more].concat());
            assert_eq!((run.code, run.err.as_str()), (0, ""), "{command}");
            run.out
        };
        run(&more);
        let drawn = contents(&folder, "results");
        let count = drawn.keys().filter(|path| is_figure(path)).count();
        assert_eq!(count, figures, "{command}: {:?}", drawn.keys());

        let shown = run(&[&more[..], &["--no-figures"]].concat());
        let (shown, removed) = shown.split_once("\nRemoved: results of").unwrap();
        assert!(
            !shown.contains(".png") && !shown.contains(".svg"),
            "{shown}"
        );
        assert_eq!(removed.lines().count(), 1 + figures, "{removed}");
        assert!(!shown.contains("fan plot"), "{shown}");
        let bare = contents(&folder, "results");
        let left = drawn.iter().filter(|(path, _)| !is_figure(path));
        let names: Vec<_> = left.clone().map(|(path, _)| path).collect();
        assert_eq!(bare.keys().collect::<Vec<_>>(), names, "{command}");
        for (path, content) in left.filter(|(path, _)| !TIMED.contains(&path.as_str())) {
            assert!(bare[path] == *content, "{command}: {path} is another");
        }

        run(&more);
        assert!(contents(&folder, "results").keys().eq(drawn.keys()));
    }
}

/// The first run in a folder, of two files, also draws none.
#[test]
fn several_files_without_figures() {
    let folder = Folder::new();
    for name in ["a", "b"] {
        folder.write(&format!("{name}.dynamics.toml"), &beam(0.02));
    }
    let files = ["a.dynamics.toml", "b.dynamics.toml"];
    let run = folder.run(&["transient", files[0], files[1], "--no-figures"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let found = contents(&folder, "results");
    assert!(found.contains_key("results/b.transient.csv"));
    assert!(
        !found.keys().any(|path| is_figure(path)),
        "{:?}",
        found.keys()
    );
}

#[test]
fn the_help_reports_it() {
    let folder = Folder::new();
    for (command, ..) in commands() {
        let help = folder.run(&[command, "--help"]).out;
        let words =
            "--no-figures\n          Draw no figures; removes the figures of an earlier run";
        assert!(help.contains(words), "{help}");
    }
}
