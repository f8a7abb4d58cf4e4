//! Help, wrong command lines, and streams that close.

use std::io::Read;
use std::process::Stdio;

use crate::workplace::Workplace;

/// Command lines that request help, and an example in the help.
const EXAMPLES: &[(&[&str], &str)] = &[
    (&["--help"], "section-analyzer analyze strip.section.toml"),
    (
        &["analyze", "--help"],
        "section-analyzer analyze blade/root.section.toml --out",
    ),
    (
        &["check", "--help"],
        "section-analyzer check blade/root.section.toml",
    ),
    (
        &["stress", "--help"],
        "section-analyzer stress blade/root.section.toml --axial 1e3",
    ),
    (
        &["matrices", "--help"],
        "section-analyzer matrices slice.matrices.toml",
    ),
    (
        &["report", "--help"],
        "section-analyzer report blade/results/root.properties.json",
    ),
    (
        &["compare", "--help"],
        "section-analyzer compare fine.properties.json coarse",
    ),
    (
        &["shift", "--help"],
        "section-analyzer shift a.properties.json --to \"25 mm, 0\" --out",
    ),
    (
        &["rotate", "--help"],
        "section-analyzer rotate a.properties.json --angle \"3.5 deg\" --out",
    ),
    (
        &["convert", "--help"],
        "section-analyzer convert box.sg box.section.toml --length in",
    ),
    (
        &["layup", "--help"],
        "section-analyzer layup blade.layup.toml --eta 0.2,0.4",
    ),
    (
        &["blade", "--help"],
        "section-analyzer blade rotor.layup.toml --out rotor",
    ),
    (
        &["strength", "--help"],
        "section-analyzer strength rotor/rotor.span.csv --loads",
    ),
    (
        &["mesh", "layup", "--help"],
        "section-analyzer mesh layup blade.layup.toml --eta 0.4",
    ),
    (
        &["mesh", "rectangle", "--help"],
        "section-analyzer mesh rectangle --width 1",
    ),
    (
        &["mesh", "tube", "--help"],
        "plane_angle = { follow = \"outer\" }",
    ),
    (&["schema", "--help"], "#:schema ./section.schema.json"),
    (
        &["completions", "--help"],
        "section-analyzer completions bash >",
    ),
    (&["manual", "--help"], "section-analyzer manual | man -l -"),
    (
        &["mesh", "blade", "--help"],
        "section-analyzer mesh blade blade.toml --out blade.msh",
    ),
    (
        &["mesh", "ellipse", "--help"],
        "section-analyzer mesh ellipse --semi-y 10",
    ),
];

#[test]
fn help_teaches_with_an_example() {
    let workplace = Workplace::new();
    for (arguments, example) in EXAMPLES {
        let run = workplace.run(arguments);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{arguments:?}");
        assert!(run.out.contains(example), "{arguments:?}: {}", run.out);
        assert!(
            run.out.lines().all(|line| line.len() < 200),
            "{arguments:?}"
        );
    }
}

/// The example of the help text, as typed by a new user.
#[test]
fn example_of_the_help_text_runs() {
    let workplace = Workplace::new();
    let help = workplace.run(&["--help"]).out;
    let (_, example) = help.split_once("strip of aluminum:\n").unwrap();
    let (_, section) = example.split_once("<<'END'\n").unwrap();
    let (section, _) = section.split_once("  END\n").unwrap();
    workplace.write("strip.section.toml", &section.replace("\n  ", "\n"));
    let mesh = [
        "mesh",
        "rectangle",
        "--width",
        "1",
        "--height",
        "0.063",
        "--cells-y",
        "40",
    ];
    let mesh = [&mesh[..], &["--cells-z", "4", "--out", "strip.msh"]].concat();
    assert!(
        example.replace("\\\n    ", "").contains(&mesh.join(" ")),
        "{example}"
    );
    assert_eq!(workplace.run(&mesh).code, 0);
    assert_eq!(workplace.run(&["analyze", "strip.section.toml"]).code, 0);
}

#[test]
fn wrong_command_lines_end_with_two() {
    let workplace = Workplace::new();
    for arguments in [
        &[][..],
        &["solve", "a.section.toml"],
        &["analyze"],
        &["mesh", "rectangle", "--width", "wide"],
    ] {
        let run = workplace.run(arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
        assert!(
            run.err.contains("Usage:") || run.err.contains("--help"),
            "{}",
            run.err
        );
    }
    let run = workplace.run(&["analyse", "a.section.toml"]);
    assert!(run.err.contains("analyze"), "{}", run.err);
}

#[test]
fn wrong_measures_of_a_mesh_are_reported_together() {
    let workplace = Workplace::new();
    let sizes = ["mesh", "tube", "--outer-radius", "5", "--thickness", "-5"];
    let cells = [
        "--cells-around",
        "2",
        "--cells-through",
        "1",
        "--out",
        "x.msh",
    ];
    let run = workplace.run(&[&sizes[..], &cells].concat());
    assert_eq!(
        run.err,
        "error: thickness: expected a positive length, found -5\n\
         error: cells around: expected at least 3, found 2\n"
    );
    assert_eq!(run.code, 2);
    assert!(!workplace.path("x.msh").exists());
}

#[test]
fn names_that_no_mesh_file_can_hold_and_negative_counts_are_refused() {
    let workplace = Workplace::new();
    let mesh = |name: &str, cells: &str| {
        let sizes = ["mesh", "rectangle", "--width", "1", "--height", "1"];
        let cells = ["--cells-y", cells, "--cells-z", "1", "--out", "x.msh"];
        workplace.run(&[&sizes[..], &cells, &["--name", name]].concat())
    };
    for name in ["", " ", "a\"b", "a\nb"] {
        let run = mesh(name, "1");
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{name:?}");
        assert!(run.err.contains("--name <NAME>"), "{}", run.err);
    }
    let run = mesh("skin", "-1");
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("invalid value '-1' for '--cells-y"),
        "{}",
        run.err
    );
    assert!(!workplace.path("x.msh").exists());
    let run = mesh("my skin", "1");
    assert_eq!(
        run.out,
        "x.msh: 9 nodes, 1 cell\n  physical surface: my skin\n  \
         physical curves: bottom, right, top, left\n"
    );
}

/// As in `section-analyzer check ... | head -0`: the reader of the output has ended.
#[test]
fn a_closed_pipe_is_no_error() {
    let workplace = Workplace::with(&[], &[]);
    for arguments in [["check", "a.section.toml"], ["analyze", "a.section.toml"]] {
        let mut command = workplace.command(&arguments);
        let mut child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut err = String::new();
        child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut err)
            .unwrap();
        assert_eq!((child.wait().unwrap().code(), err.as_str()), (Some(0), ""));
    }
}

/// As in `section-analyzer check bad.section.toml 2>&1 | head -0`: the work decides on the exit code.
#[test]
fn a_closed_pipe_hides_no_error() {
    let workplace = Workplace::with(&[("two.msh", "tow.msh")], &[]);
    for arguments in [["check", "a.section.toml"], ["analyze", "a.section.toml"]] {
        let mut command = workplace.command(&arguments);
        let piped = command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = piped.spawn().unwrap();
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(child.wait().unwrap().code(), Some(2));
    }
}

#[test]
fn a_mesh_is_not_written_over() {
    let workplace = Workplace::new();
    let sizes = ["mesh", "rectangle", "--width", "1", "--height", "1"];
    let rest = ["--cells-y", "1", "--cells-z", "1", "--out", "x.msh"];
    let mesh = [&sizes[..], &rest].concat();
    assert_eq!(workplace.run(&mesh).code, 0);
    workplace.write("x.msh", "mine");
    let run = workplace.run(&mesh);
    assert_eq!(
        run.err,
        "error: \"x.msh\" exists already, expected the name of a new file\n  help: --force replaces it\n"
    );
    assert_eq!((run.code, workplace.read("x.msh").as_str()), (2, "mine"));
    assert_eq!(workplace.run(&[&mesh[..], &["--force"]].concat()).code, 0);
    assert_ne!(workplace.read("x.msh"), "mine");
}

#[test]
fn a_mesh_that_cannot_be_written_is_wrong_usage() {
    let workplace = Workplace::new();
    let sizes = ["mesh", "rectangle", "--width", "1", "--height", "1"];
    let rest = ["--cells-y", "1", "--cells-z", "1", "--out", "no/such.msh"];
    let run = workplace.run(&[&sizes[..], &rest].concat());
    assert_eq!(
        run.err,
        "error: file \"no/such.msh\" cannot be written: its folder does not exist\n"
    );
    assert_eq!(run.code, 2);
}

/// A page for each command, with the file name that `man` expects and the text of the
/// help.
#[test]
fn manual_has_a_page_for_each_command() {
    let workplace = Workplace::new();
    let run = workplace.run(&["manual", "--out", "man1"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for (page, word) in [
        ("section-analyzer", "section\\-analyzer\\-analyze(1)"),
        ("section-analyzer-analyze", "properties.json"),
        ("section-analyzer-mesh-tube", "outer\\-radius"),
        ("section-analyzer-manual", "one for each command"),
    ] {
        let text = workplace.read(&format!("man1/{page}.1"));
        let heading = format!(
            ".TH {page} 1  \"section-analyzer {}\"",
            env!("CARGO_PKG_VERSION")
        );
        assert!(text.contains(&heading), "{text}");
        assert!(text.contains(word), "{page}: {text}");
    }
    let pages = std::fs::read_dir(workplace.path("man1")).unwrap().count();
    let printed = workplace.run(&["manual"]).out;
    assert_eq!(printed.matches("\n.TH ").count(), pages);
    assert_eq!(
        run.out.lines().filter(|line| line.ends_with(".1")).count(),
        pages
    );
    workplace.write("file", "");
    let run = workplace.run(&["manual", "--out", "file/man1"]);
    assert!(
        run.err
            .starts_with("error: folder \"file/man1\" cannot be made"),
        "{}",
        run.err
    );
    assert_eq!(run.code, 2);
}

#[test]
fn completions_know_commands_and_options() {
    let workplace = Workplace::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = workplace.run(&["completions", shell]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{shell}");
        for word in ["analyze", "rectangle", "cells-through"] {
            assert!(run.out.contains(word), "{shell}: {word}");
        }
    }
    assert_eq!(workplace.run(&["completions", "cmd"]).code, 2);
}

#[test]
fn schema_is_printed_or_written() {
    let workplace = Workplace::new();
    let printed = workplace.run(&["schema"]);
    assert_eq!((printed.code, printed.err.as_str()), (0, ""));
    assert!(printed.out.contains("\"$schema\""), "{}", printed.out);
    let run = workplace.run(&["schema", "--out", "section.schema.json"]);
    assert_eq!((run.code, run.out.as_str()), (0, "section.schema.json\n"));
    assert_eq!(workplace.read("section.schema.json"), printed.out);
    let page = workplace.run(&["schema", "--format", "markdown"]).out;
    assert!(page.starts_with("# Section input reference"), "{page}");
    let run = workplace.run(&["schema", "--out", "no/such.json"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("its folder does not exist"), "{}", run.err);
}
