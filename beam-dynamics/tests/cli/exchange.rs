//! `describe` and `convert`.

use shared_geom::exchange::Format;
use shared_geom::section;

use crate::{Folder, strip};

/// A straight blade of the strip in a table of our own, 2 m long, nose up 5.7 degrees.
fn table() -> String {
    table_of(&strip())
}

/// The same of another section.
pub fn table_of(section: &section::SectionProperties) -> String {
    let upper = |matrix: &nalgebra::Matrix6<f64>| {
        let pairs = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
        let entries = pairs.map(|pair| format!("{:e}", matrix[pair]));
        entries.collect::<Vec<_>>().join(",")
    };
    let matrices = format!("{},{}", upper(&section.stiffness), upper(&section.mass));
    let names = |letter: &str| {
        let pairs = (1..=6).flat_map(|i| (i..=6).map(move |j| (i, j)));
        let names = pairs.map(|(i, j)| format!("{letter}{i}{j}"));
        names.collect::<Vec<_>>().join(",")
    };
    format!(
        "# helicoid blade table\n# units: SI\n# frame: helicoid\n# order: axial, shear y, shear z, \
         torsion, bending y, bending z\n# reference point: reference line\n# damping: \
         proportional 0.002\ntable,line\nx,y,z,twist\n0,0,0,0.1\n1,0,0,0.1\n2,0,0,0.1\n\
         table,stations\ns,{},{}\n0,{matrices}\n2,{matrices}\n",
        names("K"),
        names("M"),
    )
}

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("strip.csv", &table());
    folder
}

// 0.109 kg/m over 2 m, uniform: 0.218 kg with the center at 1 m; EA 2.97e6 N.
#[test]
fn describe_says_what_a_file_holds() {
    let folder = folder();
    let run = folder.run(&["describe", "strip.csv"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for expected in [
        "strip.csv: Helicoid blade table (CSV)\n",
        "axes of the file helicoid (x along the blade",
        "order            axial, shear y, shear z, torsion, bending y, bending z\n",
        "straight pieces through 3 points, 2.000000 m long",
        "twist            5.7296 deg at the root, 5.7296 deg at the tip, positive nose up",
        "stations         2 from 0.000000 to 2.000000 m",
        "mass             0.2180 kg\n",
        "mass center      (1.0000, 0.0000, 0.0000) m from the root\n",
        "mass moment      2.180000e-1 kg m",
        "damping          proportional to stiffness, time 2.000000e-3 s",
        "positive definite at all stations",
        "axial [N] ",
        "2.9700e6",
        "tension center y [m]",
    ] {
        assert!(run.out.contains(expected), "{expected:?} in:\n{}", run.out);
    }
}

#[test]
fn describe_continues_behind_a_file_that_is_wrong() {
    let folder = folder();
    folder.write("notes.txt", "dear colleague\n");
    let run = folder.run(&["describe", "notes.txt", "strip.csv"]);
    assert_eq!(run.code, 2);
    assert!(run.err.starts_with(
        "error: notes.txt: the format of the file is not known: it begins with \"dear colleague\""
    ));
    assert!(run.out.contains("strip.csv: Helicoid blade table"));
}

// A stiffness with a coupling larger than the root of the diagonals is indefinite:
// described, with the position, and marked.
#[test]
fn describe_marks_a_stiffness_that_is_not_positive_definite() {
    let folder = folder();
    let bad = table().replacen("2.97e6,0e0", "2.97e6,9e9", 1);
    folder.write("bad.csv", &bad);
    let run = folder.run(&["describe", "bad.csv"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("NOT positive definite"), "{}", run.out);
    assert!(run.out.contains("\nWrong\n"), "{}", run.out);
}

#[test]
fn a_section_is_described_and_made_a_blade_with_a_length() {
    let folder = folder();
    let run = folder.run(&["describe", "strip.properties.json"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(
        run.out
            .contains("one section: a blade of it needs --length METERS")
    );
    let run = folder.run(&["convert", "strip.properties.json", "a.csv"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(
        run.err.contains("help: give --length METERS"),
        "{}",
        run.err
    );
    let run = folder.run(&["convert", "strip.properties.json", "a.csv", "--length", "3"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("straight and uniform, 3 m long"));
    let run = folder.run(&["convert", "strip.properties.json", "a.csv", "--length=-3"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("expected a number of meters above zero"));
}

/// Each format has a folder, and its blade equals a single conversion.
#[test]
fn all_formats_are_written_at_once() {
    let folder = folder();
    let run = folder.run(&["convert", "strip.csv", "out", "--to", "all"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for format in Format::ALL.into_iter().filter(|one| one.is_written()) {
        let texts = ["out/{}/", "{} is not written"].map(|text| text.replace("{}", format.name()));
        assert!(
            texts.iter().any(|text| run.out.contains(text)),
            "{}",
            run.out
        );
    }
    let run = folder.run(&["convert", "strip.csv", "one/strip.blade.json"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let compared = folder.run(&[
        "compare",
        "one/strip.blade.json",
        "out/helicoid/strip.blade.json",
    ]);
    assert_eq!(compared.code, 0, "{}", compared.out);
}

// csv -> BeamDyn -> DYMORE -> VABS -> JSON -> csv: the stations return letter by letter,
// since every number keeps all its digits.
#[test]
fn a_chain_of_conversions_loses_no_digit() {
    let folder = folder();
    let first = folder.run(&["convert", "strip.csv", "out/first.csv"]);
    assert_eq!(first.code, 0, "{}", first.err);
    let chain = [
        "out/first.csv",
        "b.inp",
        "c.dym",
        "d.K",
        "e.blade.json",
        "out/last.csv",
    ];
    for pair in chain.windows(2) {
        let from = if pair[0] == "d.K" {
            "d.sections.csv"
        } else {
            pair[0]
        };
        let run = folder.run(&["convert", from, pair[1]]);
        assert_eq!(run.code, 0, "{from}: {}", run.err);
        assert!(run.out.contains("\nWritten\n"));
    }
    let stations = |name: &str| {
        let text = folder.read(name);
        text[text.find("table,stations").unwrap()..].to_owned()
    };
    assert_eq!(stations("out/first.csv"), stations("out/last.csv"));
    assert!(folder.read("b_blade.dat").contains("station_total"));
    assert!(folder.read("c.dym").contains("# line: c.line.csv"));
}

#[test]
fn exports_state_the_hash_of_what_was_read() {
    let folder = folder();
    folder.run(&["convert", "strip.csv", "b.inp"]);
    let hash = shared_geom::hash::sha256_of_content(table().as_bytes());
    assert!(folder.read("b.inp").contains(&format!("input: {hash}")));
}

// Six damping times become one in a DYMORE table: 1 to 6 ms have the mean 3.5 ms.
#[test]
fn what_cannot_be_carried_is_reported_with_its_size() {
    let folder = folder();
    let times = table().replace("proportional 0.002", "times 1e-3 2e-3 3e-3 4e-3 5e-3 6e-3");
    folder.write("times.csv", &times);
    let run = folder.run(&["convert", "times.csv", "times.dym"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out
            .contains("Cannot be represented\n  six damping times become one")
    );
    assert!(
        run.out
            .contains("3.500e-3 s: they differ from it by up to 2.50e-3 s"),
        "{}",
        run.out
    );
    let run = folder.run(&["convert", "times.csv", "times.inp"]);
    assert!(run.out.contains("Everything is converted"), "{}", run.out);
}

/// The name that OpenFAST's examples have; the blade file beside it ends in `.dat` too.
#[test]
fn names_of_beamdyn_files_are_known() {
    let folder = folder();
    for (format, to) in [
        (&[][..], "y_BeamDyn.dat"),
        (&["--to", "beamdyn4"], "z_BeamDyn.dat"),
    ] {
        let run = folder.run(&[&["convert", "strip.csv", to], format].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let blade = to.replace(".dat", "_blade.dat");
        let written = format!("\nWritten\n  {to}\n  {blade}\n");
        assert!(run.out.ends_with(&written), "{}", run.out);
        let run = folder.run(&["compare", "strip.csv", to]);
        assert_eq!(run.code, 0, "{}", run.out);
    }
}

#[test]
fn a_turbine_of_another_size_is_remarked() {
    let folder = folder();
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../tests/reference/exchange/windio2_iea15.yaml"
    );
    let run = folder.run(&["convert", "strip.csv", "a.yaml", "--into", file]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let remark = "\nRemarks\n  the blade is 2.0000 m long, and the blade of the file 117.";
    assert!(run.out.contains(remark), "{}", run.out);
}

#[test]
fn convert_refuses_to_overwrite_what_it_reads() {
    let folder = folder();
    folder.run(&["convert", "strip.csv", "b.inp"]);
    let before = [folder.read("b.inp"), folder.read("b_blade.dat")];
    for (from, to, file) in [
        ("strip.csv", "./strip.csv", "./strip.csv"),
        ("b.inp", "b.inp", "b.inp"),
        // The primary file has another name, but its blade file has not.
        ("b.inp", "b.dat", "b_blade.dat"),
    ] {
        let run = folder.run(&["convert", from, to, "--to", "beamdyn4"]);
        let run = if to.ends_with(".csv") {
            folder.run(&["convert", from, to])
        } else {
            run
        };
        assert_eq!((run.code, run.out.as_str()), (2, ""));
        let expected = format!("error: \"{file}\" would be overwritten, but it is the input");
        assert!(run.err.starts_with(&expected), "{}", run.err);
    }
    assert_eq!(before, [folder.read("b.inp"), folder.read("b_blade.dat")]);
    assert_eq!(folder.read("strip.csv"), table());
}

#[test]
fn formats_that_are_not_known_are_reported_with_those_that_are() {
    let folder = folder();
    let run = folder.run(&["convert", "strip.csv", "a.dat"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("the ending of \"a.dat\" belongs to no format")
    );
    assert!(
        run.err
            .contains("help: give the format with --to: helicoid, beamdyn")
    );
    let run = folder.run(&["convert", "strip.csv", "a.dat", "--to", "beamdin"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("help: did you mean \"beamdyn\"?"));
    assert!(!folder.path("a.dat").exists());
}

// Sections at arc lengths in a file of people become a blade of any format.
#[test]
fn several_sections_become_a_blade() {
    let folder = folder();
    let mut half = strip();
    half.stiffness *= 0.5;
    folder.write("half.properties.json", &section::write(&half));
    folder.write(
        "both.csv",
        &(table().split("table,stations").next().unwrap().to_owned()
            + "table,sections\ns,file\n0,strip.properties.json\n2,half.properties.json\n"),
    );
    let run = folder.run(&["convert", "both.csv", "both.inp"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let run = folder.run(&["describe", "both.inp"]);
    assert!(run.out.contains("  1.4850e6  2.000"), "{}", run.out);
}

// The table of the page on formats, with two sections of the tests.
#[test]
fn the_table_of_the_book_is_read() {
    let folder = folder();
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let page = std::fs::read_to_string(format!("{root}/docs/src/formats.md")).unwrap();
    let from = page.find("# helicoid blade table").unwrap();
    let table = page[from..].split("```").next().unwrap();
    folder.write("book.csv", table);
    folder.write("root.properties.json", &section::write(&strip()));
    let tip = std::fs::read_to_string(format!("{root}/tests/reference/exchange/strip.K")).unwrap();
    folder.write("tip.K", &tip);
    let run = folder.run(&["describe", "book.csv"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(
        run.out.contains("a spline through 3 points, 61.0"),
        "{}",
        run.out
    );
}

#[test]
fn toml_is_not_written_and_the_first_of_several_files_is_reported() {
    let folder = folder();
    let run = folder.run(&["convert", "strip.csv", "y.blade.toml"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    let reported = "error: \"y.blade.toml\": blade files in TOML are written by people, expected one \
        in JSON\n  help: convert to \"y.blade.json\"";
    assert!(run.err.starts_with(reported), "{}", run.err);
    assert!(!folder.path("y.blade.json").exists());
    let run = folder.run(&["convert", "strip.csv", "y.K"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let reported = "y.sections.csv is the file for modes and describe: it refers to the others\n";
    assert!(run.out.ends_with(reported), "{}", run.out);
    // A single file has the name as given, with any ending of its format.
    let run = folder.run(&["convert", "strip.csv", "y.yml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.ends_with("\nWritten\n  y.yml\n"), "{}", run.out);
}

#[test]
fn describe_reports_the_frame_that_a_file_declares() {
    let folder = folder();
    let matrix = "[[3e6,0,0,0,0,0],[0,3e6,0,0,0,0],[0,0,3e6,0,0,0],[0,0,0,9,0,0],[0,0,0,0,2,0],\
        [0,0,0,0,0,4]]";
    let station =
        |s: f64| format!("[[station]]\narc_length = {s}\nstiffness = {matrix}\nmass = {matrix}\n");
    let head =
        "units = \"SI\"\nframe = \"beamdyn\"\nreference_point = \"line\"\n[line]\nlength = 2\n";
    let text = format!("{head}{}{}", station(0.0), station(2.0));
    folder.write("a.blade.toml", &text);
    let run = folder.run(&["describe", "a.blade.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out
            .contains("the file declares a frame of its own: beamdyn"),
        "{}",
        run.out
    );
    assert!(!run.out.contains("-0.0000"), "{}", run.out);
    let run = folder.run(&["describe", "strip.csv", "--length", "-3"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("expected a number of meters above zero"),
        "{}",
        run.err
    );
}
