//! Several sections in one run.

use std::collections::BTreeMap;

use crate::workplace::{SECTION, TWO_CELLS, Workplace};

/// Different sections, in two folders; their names alone would not distinguish them.
const FILES: [&str; 4] = [
    "one/a.section.toml",
    "one/b.section.toml",
    "two/a.section.toml",
    "c.section.toml",
];

/// Four sections of [`TWO_CELLS`], each with another modulus of elasticity.
fn four() -> Workplace {
    let workplace = Workplace::new();
    for folder in ["one", "two", ""] {
        std::fs::create_dir_all(workplace.path(folder)).unwrap();
        workplace.write(
            format!("{folder}/two.msh").trim_start_matches('/'),
            TWO_CELLS,
        );
    }
    for (number, file) in FILES.iter().enumerate() {
        let young = format!("young = {}", 100 + number);
        workplace.write(file, &SECTION.replace("young = 210", &young));
    }
    workplace
}

/// All files of the results with their contents.
fn results(workplace: &Workplace) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for folder in ["one/results", "two/results", "results"] {
        for entry in std::fs::read_dir(workplace.path(folder)).unwrap() {
            let path = entry.unwrap().path();
            let name = format!("{folder}/{}", path.file_name().unwrap().to_string_lossy());
            found.insert(name, std::fs::read(&path).unwrap());
        }
    }
    found
}

/// EA of the two squares of 1 mm: 2e-6 m^2 times 100, 101, ... GPa; both cells represent
/// the linear field of extension exactly.
#[test]
fn each_section_has_a_line_in_the_order_given() {
    let workplace = four();
    let run = workplace.run(&[&["analyze"], &FILES[..]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let lines: Vec<_> = run.out.lines().collect();
    assert_eq!(
        lines[0].split_whitespace().collect::<Vec<_>>().join(" "),
        "section status nodes EA [N] GJ [N m^2] mass [kg/m]"
    );
    for (number, file) in FILES.iter().enumerate() {
        let words: Vec<_> = lines[number + 1].split_whitespace().collect();
        assert_eq!(&words[..3], &[*file, "solved", "6"]);
        let expected = 2e-6 * (100 + number) as f64 * 1e9;
        assert_eq!(words[3], format!("{expected:.5e}"));
        assert_eq!(words[5], "1.57000e-2");
    }
    assert_eq!(&lines[5..], ["", "4 sections: 4 solved"]);
    assert_eq!(results(&workplace).len(), 4 * 10);
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let workplace = four();
    let run = |threads: &str| {
        let rest = ["--threads", threads, "--force"];
        let run = workplace.run(&[&["analyze"], &FILES[..], &rest].concat());
        assert_eq!(run.code, 0);
        (run.out, results(&workplace))
    };
    let (one, two) = (run("1"), run("2"));
    assert_eq!(one.0, two.0);
    assert!(one.1.contains_key("one/results/a.warping.png"));
    for (name, content) in &one.1 {
        assert!(two.1[name] == *content, "{name}");
    }
    assert_eq!(one.1.len(), two.1.len());
}

/// The files of a section are the same alone and among others.
#[test]
fn results_do_not_depend_on_the_company() {
    let (workplace, alone) = (four(), four());
    assert_eq!(workplace.run(&[&["analyze"], &FILES[..]].concat()).code, 0);
    for file in FILES {
        assert_eq!(alone.run(&["analyze", file]).code, 0);
    }
    assert!(results(&workplace) == results(&alone));
}

/// One file is missing, one has two mistakes, one cannot be solved: all is reported in
/// the order of the sections, and the good one is written.
#[test]
fn problems_of_all_sections_are_reported_and_the_others_are_written() {
    let workplace = four();
    let wrong = SECTION.replace("0.3", "0.7").replace("\"web\"", "\"wib\"");
    workplace.write("one/a.section.toml", &wrong);
    let soft = "[material.air]\nyoung = 1e-20\npoisson = 0\ndensity = 1\n\n[[region]]\ngroup = \"web\"\nmaterial = \"air\"";
    let web = "[[region]]\ngroup = \"web\"\nmaterial = \"steel\"";
    workplace.write("one/b.section.toml", &SECTION.replace(web, soft));
    let files = [
        "one/b.section.toml",
        "none.section.toml",
        FILES[0],
        FILES[3],
    ];
    let run = workplace.run(&[&["analyze"], &files[..]].concat());
    assert_eq!(run.code, 2);
    let reported: Vec<_> = run
        .err
        .lines()
        .filter(|line| line.starts_with("error: "))
        .collect();
    let starts = [
        "error: one/b.section.toml: the section is loose at node ",
        "error: none.section.toml: cannot be read: no such file",
        "error: one/a.section.toml:1: physical surface \"web\"",
        "error: one/a.section.toml:9: material \"steel\": poisson is 0.7",
        "error: one/a.section.toml:17: the mesh has no physical surface \"wib\"",
    ];
    assert_eq!(reported.len(), starts.len(), "{}", run.err);
    for (line, start) in reported.iter().zip(starts) {
        assert!(line.starts_with(start), "{line}");
    }
    let lines: Vec<_> = run.out.lines().map(str::trim_end).collect();
    assert_eq!(
        lines[1],
        "one/b.section.toml  failed             6  1 remark"
    );
    assert_eq!(lines[2], "none.section.toml   wrong input");
    assert_eq!(lines[6], "4 sections: 1 solved, 1 failed, 2 wrong input");
    assert!(workplace.path("results/c.properties.json").exists());
    assert!(workplace.path("one/results/b.report.txt").exists());
    assert!(!workplace.path("one/results/b.properties.json").exists());

    let run = workplace.run(&["analyze", "one/b.section.toml", "c.section.toml"]);
    assert_eq!(run.code, 1);
}

#[test]
fn sections_with_the_same_results_are_refused_before_anything_runs() {
    let workplace = four();
    let run = workplace.run(&[&["analyze"], &FILES[..], &["--out", "all"]].concat());
    assert_eq!(
        run.err,
        "error: \"one/a.section.toml\" and \"two/a.section.toml\" would both write \
         \"all/a.properties.json\", expected other result files for each section\n  help: give \
         one of the section files another name, or remove --out\n"
    );
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(!workplace.path("all").exists());

    let run = workplace.run(&["analyze", "c.section.toml", "./c.section.toml"]);
    assert_eq!(run.code, 2);
    let run = workplace.run(&["analyze", "c.section.toml", "c.section.toml"]);
    assert!(
        run.err.ends_with("help: name each section file once\n"),
        "{}",
        run.err
    );
}

#[test]
fn threads_are_one_or_more() {
    let workplace = four();
    for count in ["0", "-1", "many", "1.5"] {
        let run = workplace.run(&["analyze", FILES[0], FILES[1], "--threads", count]);
        assert_eq!((run.code, run.out.as_str()), (2, ""));
        assert!(
            run.err.contains("expected a whole number, 1 or more"),
            "{}",
            run.err
        );
    }
    assert!(!workplace.path("one/results").exists());
}
