//! `section-analyzer mesh blade`: correct files, and messages about wrong ones.

use crate::workplace::{Run, Workplace};

/// A box-spar with everything. Lines are counted in the tests: keep them.
const BLADE: &str = "\
[units]
length = \"mm\"

[airfoil]
naca = \"4415\"
trailing_edge = \"sharp\"
chord = 300

[skin]
plies = [{ name = \"skin\", material = \"glass\", fiber_angle = 45, thickness = 0.5 }]

[spar]
front_web = 0.12
rear_web = 0.45
plies = [
  { name = \"cap\", material = \"carbon\", thickness = 1.5, on = [\"upper\", \"lower\"], faces = true },
  { name = \"pad\", material = \"carbon\", thickness = 0.5, on = \"upper\", from = 0.2, to = 0.35 },
  { name = \"web\", material = \"glass\", fiber_angle = -45, thickness = 0.5, count = 3 },
]

[core.aft]
name = \"foam\"

[nose_mass]
name = \"lead\"
to = 0.03

[mesh]
size = 6
";

/// Meshes the file of a workplace, with a new section file.
fn mesh(workplace: &Workplace) -> Run {
    workplace.run(&[
        "mesh",
        "blade",
        "a.blade.toml",
        "--out",
        "a.msh",
        "--section",
        "a.section.toml",
        "--force",
    ])
}

/// Runs the file with replacements.
fn run(changes: &[(&str, &str)]) -> (Workplace, i32, String, String) {
    let mut text = BLADE.to_owned();
    for (from, to) in changes {
        assert_eq!(text.matches(from).count(), 1, "\"{from}\"");
        text = text.replacen(from, to, 1);
    }
    let workplace = Workplace::new();
    workplace.write("a.blade.toml", &text);
    let run = mesh(&workplace);
    (workplace, run.code, run.out, run.err)
}

/// Checks the reported lines: the beginnings of all of them.
fn is_refused(changes: &[(&str, &str)], expected: &[&str]) {
    let (workplace, code, out, err) = run(changes);
    let lines: Vec<&str> = err.lines().collect();
    assert_eq!(lines.len(), expected.len(), "{err}");
    for (line, expected) in lines.iter().zip(expected) {
        assert!(line.starts_with(expected), "{line}\n{expected}");
    }
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(!workplace.path("a.msh").exists() && !workplace.path("a.section.toml").exists());
}

#[test]
fn a_blade_and_its_section_file_are_written() {
    let (workplace, code, out, err) = run(&[]);
    assert_eq!((code, err.as_str()), (0, ""));
    for name in [
        "cap/upper",
        "web/front_web",
        "foam",
        "lead",
        "cap/outer",
        "a.section.toml: ",
    ] {
        assert!(out.contains(name), "{name}: {out}");
    }
    let section = workplace.read("a.section.toml");
    for part in [
        "mesh = \"a.msh\"\n\n[units]\nlength = \"mm\"\n",
        "[material.glass]\n",
        "group = \"skin\"\nmaterial = \"glass\"\nfiber_angle = \"45 deg\"\nplane_angle = { follow = \"contour\" }\n",
        "group = \"web\"\nmaterial = \"glass\"\nfiber_angle = \"-45 deg\"\nplane_angle = { follow = \"spar\" }\n",
        "group = \"lead\"\nmaterial = \"lead\"\n\n",
    ] {
        assert!(section.contains(part), "{part}\n{section}");
    }
    // only the constants of the four materials are missing
    let check = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(check.err.matches("has no elastic constants").count(), 4);
    assert_eq!(check.err.matches("error:").count(), 8, "{}", check.err);
    let constants = "young = 1e4\npoisson = 0.3\ndensity = 1e-9\n";
    let solid = section.replace("# density =\n", constants);
    workplace.write("b.section.toml", &solid);
    let check = workplace.run(&["check", "b.section.toml"]);
    assert_eq!((check.code, check.err.as_str()), (0, ""));
    assert!(check.out.contains("No problem found"), "{}", check.out);
}

#[test]
fn a_section_file_is_not_written_over() {
    let workplace = Workplace::new();
    workplace.write("a.blade.toml", BLADE);
    workplace.write("a.section.toml", "mine");
    let all = ["mesh", "blade", "a.blade.toml", "--out", "a.msh"];
    let run = workplace.run(&[&all[..], &["--section", "a.section.toml"]].concat());
    assert_eq!(run.code, 2);
    assert!(run.err.contains("exists already"), "{}", run.err);
    assert_eq!(workplace.read("a.section.toml"), "mine");
    assert_eq!(workplace.run(&all).code, 0);
    let again = workplace.run(&[&all[..], &["--section", "a.section.toml"]].concat());
    let expected = ["a.msh", "a.section.toml"].map(|file| {
        format!(
            "error: \"{file}\" exists already, expected the name of a new file\n  help: --force \
             replaces it\n"
        )
    });
    assert_eq!((again.code, again.err), (2, expected.concat()));
    let forced = ["--section", "a.section.toml", "--force"];
    assert_eq!(workplace.run(&[&all[..], &forced].concat()).code, 0);
    assert_ne!(workplace.read("a.section.toml"), "mine");
}

#[test]
fn all_that_is_wrong_is_reported_at_once() {
    is_refused(
        &[
            ("front_web", "fornt_web"),
            ("\"4415\"", "\"4a15\""),
            ("thickness = 1.5", "thickness = -1.5"),
            ("on = \"upper\"", "on = \"uper\""),
            ("to = 0.03", "to = 3"),
            ("size = 6", "size = 0\nturn = 90"),
        ],
        &[
            "error: a.blade.toml:5: \"4a15\" is not a NACA airfoil: expected four digits",
            "error: a.blade.toml:13: unknown key \"fornt_web\" in [spar]",
            "  help: did you mean \"front_web\"?",
            "error: a.blade.toml:16: \"thickness\" is -1.5, expected a length greater than zero",
            "error: a.blade.toml:17: \"on\" is \"uper\", expected one of \"upper\", \"lower\", \"web\", \"front_web\", \"rear_web\"",
            "  help: did you mean \"upper\"?",
            "error: a.blade.toml:26: \"to\" is 3, expected a part of the chord",
            "error: a.blade.toml:29: \"size\" is 0, expected a length greater than zero",
            "error: a.blade.toml:30: \"turn\" is 90, expected an angle from 0.5 to 45 degrees",
        ],
    );
    is_refused(
        &[(BLADE, "name = \"nothing\"\n")],
        &[
            "error: a.blade.toml:1: the file has no \"units\"",
            "error: a.blade.toml:1: the file has no \"airfoil\"",
            "error: a.blade.toml:1: the file has no \"skin\", and no [core.aft]",
            "  help: [skin] plies = [{ name = \"skin\", thickness = ... }], or [core.aft]",
            "error: a.blade.toml:1: the file has no \"mesh\"",
            "error: a.blade.toml:1: unknown key \"name\"",
            "  help: known keys: units, airfoil, skin, spar, core, nose_mass, mesh",
        ],
    );
}

#[test]
fn what_does_not_fit_is_reported_where_it_is_written() {
    let skin = "fiber_angle = 45, thickness = 0.5";
    is_refused(
        &[(skin, "thickness = 0.5"), ("\"sharp\"", "\"blunt\"")],
        &[
            "error: a.blade.toml:10: the skin, 0.5 thick, cannot be closed at a trailing edge 0.945 thick",
            "  help: there is enough space ahead of x/c = 0.99",
        ],
    );
    is_refused(
        &[(skin, "thickness = 9")],
        &[
            "error: a.blade.toml:10: the plies are 9 thick at x/c = ",
            "  help: plies of [skin] less than 7.27 thick together, by \"thickness\" or \"count\"; no [skin], but [core.aft] up to the contour",
        ],
    );
    is_refused(
        &[("thickness = 1.5", "thickness = 22")],
        &[
            "error: a.blade.toml:15: the plies of both surfaces intersect at x/c = ",
            "  help: the plies of both surfaces together less than ",
        ],
    );
    is_refused(
        &[("count = 3", "count = 3, on = \"rear_web\"")],
        &[
            "error: a.blade.toml:13: no ply continues from the front web into the upper surface",
            "  help: let a ply of the web continue along the surface",
            "error: a.blade.toml:13: no ply continues from the front web into the lower surface",
            "  help: let a ply of the web continue along the surface",
            "error: a.blade.toml:14: no ply continues from the rear web into the upper surface",
            "  help: let a ply of the web continue along the surface",
            "error: a.blade.toml:14: no ply continues from the rear web into the lower surface",
            "  help: let a ply of the web continue along the surface",
        ],
    );
    let web = |line: usize, which: &str| {
        [
            format!("error: a.blade.toml:{line}: the plies of the {which} need "),
            "  help: thinner plies in the web, or a longer spar".to_owned(),
        ]
    };
    let [front, rear] = [web(13, "front web"), web(14, "rear web")];
    let expected = [&front[..], &front, &rear, &rear].concat();
    let expected: Vec<&str> = expected.iter().map(String::as_str).collect();
    is_refused(
        &[("thickness = 0.5, count = 3", "thickness = 50")],
        &expected,
    );
}

#[test]
fn fractions_out_of_order_are_reported() {
    is_refused(
        &[("front_web = 0.12", "front_web = 0.62")],
        &[
            "error: a.blade.toml:13: the front web at x/c = 0.62 is not ahead of the rear one at x/c = 0.45",
            "error: a.blade.toml:17: ply \"pad\" runs from x/c = 0.2 to 0.35, expected a range within the spar",
        ],
    );
    is_refused(
        &[
            ("from = 0.2, to = 0.35", "from = 0.35, to = 0.2"),
            ("to = 0.03", "to = 0.2"),
        ],
        &[
            "error: a.blade.toml:17: ply \"pad\" runs from x/c = 0.35 to 0.2",
            "error: a.blade.toml:26: the nose mass reaches back to x/c = 0.2, expected between 0 and 0.12",
        ],
    );
    is_refused(
        &[("rear_web = 0.45", "rear_web = 0.9999")],
        &["error: a.blade.toml:14: there is no space for a web at x/c = 0.9999 inside of the skin"],
    );
}

#[test]
fn names_mean_one_thing_and_cores_need_their_space() {
    is_refused(
        &[
            ("\"pad\"", "\"web\""),
            ("[core.aft]", "[core.aft]\nname = \"web\"\n[core.nose]"),
        ],
        &[
            "error: a.blade.toml:18: \"web\" has another material, angle or position on line 17",
            "  help: give it a name of its own",
            "error: a.blade.toml:22: \"web\" has another material, angle or position on line 17",
            "  help: give it a name of its own",
        ],
    );
    is_refused(
        &[("front_web = 0.12\n", ""), ("[core.aft]", "[core.nose]")],
        &["error: a.blade.toml:20: [core.nose] needs a front web: without one"],
    );
}

/// Runs the blade on a file of coordinates.
fn run_on(foil: &str) -> Run {
    let from_file = [
        ("naca = \"4415\"\n", "file = \"foil.dat\"\n"),
        ("trailing_edge = \"sharp\"\n", ""),
        ("fiber_angle = 45, thickness = 0.5", "thickness = 0.1"),
    ];
    let mut text = BLADE.to_owned();
    for (from, to) in from_file {
        text = text.replacen(from, to, 1);
    }
    let workplace = Workplace::new();
    workplace.write("a.blade.toml", &text);
    workplace.write("foil.dat", foil);
    workplace.run(&["mesh", "blade", "a.blade.toml", "--out", "a.msh"])
}

/// NACA 0015 around, and both surfaces from the nose on.
fn coordinates() -> [String; 2] {
    let half = |x: f64| {
        0.75 * (0.2969 * x.sqrt() - 0.126 * x - 0.3516 * x * x + 0.2843 * x.powi(3)
            - 0.1015 * x.powi(4))
    };
    let xs: Vec<f64> = (0..=40).map(|i| (f64::from(i) / 40.0).powi(2)).collect();
    let upper: Vec<String> = xs.iter().map(|x| format!("{x} {}\n", half(*x))).collect();
    let lower: Vec<String> = xs.iter().map(|x| format!("{x} {}\n", -half(*x))).collect();
    let around: String = upper.iter().rev().chain(&lower[1..]).cloned().collect();
    let from_nose: String = upper.iter().chain(&lower).cloned().collect();
    [around, from_nose]
}

#[test]
fn layups_are_meshed_by_another_command() {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", "[line]\nlength = 3\n");
    let run = workplace.run(&["mesh", "blade", "a.layup.toml", "--out", "a.msh"]);
    assert_eq!(
        (run.code, run.err.as_str()),
        (
            2,
            "error: a.layup.toml: the file is a layup, expected a section of plies that are given for \
             parts of a blade\n  help: use \"section-analyzer mesh layup\"\n"
        )
    );
}

#[test]
fn airfoil_files_are_read_in_all_their_forms() {
    let [around, from_nose] = coordinates();
    let titled = run_on(&format!("NACA 0015\n{around}"));
    assert_eq!((titled.code, titled.err.as_str()), (0, ""));
    let columns = format!(
        "i;x/c;z/c\n{}",
        around.replace(' ', ";").replace('\n', "\n7;")
    );
    let columns = columns
        .trim_end_matches("7;")
        .replacen("z/c\n", "z/c\n7;", 1);
    for text in [&around, &format!("NACA\n 41. 41.\n\n{from_nose}"), &columns] {
        assert_eq!(run_on(text).out, titled.out, "{text}");
    }
    for (foil, expected) in [
        (
            "",
            "foil.dat: the file has no points, expected rows of x/c and z/c",
        ),
        (
            "t\n1 0\n0.5 0.1 3\nx\n",
            "foil.dat:3: \"0.5 0.1 3\" is not a point, expected x/c and z/c",
        ),
        ("t\n1 0\n0.5 0.1 3\nx\n", "foil.dat:4: \"x\" is not a point"),
        (
            "x,w\n1,0\n",
            "foil.dat:1: the columns are \"x,w\", expected one called \"x\" and one called \"z\" or \"y\"",
        ),
        (
            "41 41\n0 0\n1 0\n",
            "foil.dat: the file announces 41 and 41 points, and has 2",
        ),
        (
            "1 0\n0 0\n1 0\n",
            "a.blade.toml:5: the airfoil has 3 points, expected 9 or more",
        ),
        (
            &from_nose,
            "a.blade.toml:5: the points of the airfoil begin at x/c = 0 and end at x/c = 1",
        ),
    ] {
        let run = run_on(foil);
        assert_eq!(run.code, 2);
        assert!(run.err.contains(expected), "{}\n{expected}", run.err);
    }
}

/// The example of the help text, as typed by a new user.
#[test]
fn the_example_of_the_help_text_runs() {
    let workplace = Workplace::new();
    let help = workplace.run(&["mesh", "blade", "--help"]).out;
    let (_, example) = help.split_once("<<'END'\n").unwrap();
    let (blade, command) = example.split_once("  END\n").unwrap();
    workplace.write("blade.toml", &blade.replace("\n  ", "\n"));
    let words: Vec<&str> = command.split_whitespace().skip(1).collect();
    let run = workplace.run(&words);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{words:?}");
    assert!(workplace.path("blade.section.toml").exists());
}

/// Without skin and spar a core fills the airfoil: the area of NACA 0012 with its blunt edge
/// follows from the formula of its thickness [Jacobs1933], to the splines through its points.
#[test]
fn an_airfoil_without_skin_is_solid() {
    let workplace = Workplace::new();
    let solid = "units = \"SI\"\n[airfoil]\nnaca = \"0012\"\nchord = 2\n[core.aft]\nname = \"foam\"\n\
                 [mesh]\nsize = 0.04\n";
    workplace.write("a.blade.toml", solid);
    let run = mesh(&workplace);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let section = workplace.read("a.section.toml");
    let constants = "young = 1e9\npoisson = 0.3\ndensity = 1000\n";
    workplace.write(
        "b.section.toml",
        &section.replace("# density =\n", constants),
    );
    let run = workplace.run(&["analyze", "b.section.toml", "--no-figures"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let properties: serde_json::Value =
        serde_json::from_str(&workplace.read("results/b.properties.json")).unwrap();
    let found = properties["mass"][0][0].as_f64().unwrap();
    let half = 0.2969 * 2.0 / 3.0 - 0.1260 / 2.0 - 0.3516 / 3.0 + 0.2843 / 4.0 - 0.1015 / 5.0;
    let area = 2.0 * 5.0 * 0.12 * half * 4.0;
    assert!(
        (found / (1000.0 * area) - 1.0).abs() < 1e-4,
        "{found} {area}"
    );

    // with a spar on the contour, all spaces along the contour are filled
    let spar = "[spar]\nfront_web = 0.1\nrear_web = 0.4\n\
                plies = [{ name = \"cap\", thickness = 0.01 }]\n";
    workplace.write("a.blade.toml", &format!("{solid}{spar}"));
    let run = mesh(&workplace);
    let expected = "the file has no \"skin\", and no [core.nose] that fills the section";
    assert!(run.code == 2 && run.err.contains(expected), "{}", run.err);
    workplace.write(
        "a.blade.toml",
        &format!("{solid}{spar}[core.nose]\nname = \"foam\"\n"),
    );
    let run = mesh(&workplace);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
}
