//! `section-analyzer blade`: stations, resumption, failures, formats, damaged files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde_json::Value;
use shared_geom::exchange;

use crate::effort;
use crate::workplace::{Run, Workplace};

/// A blade of 5 m with few cells. Lines are counted in the tests.
pub const LAYUP: &str = "\
[units]
length = \"mm\"
stress = \"GPa\"

[line]
course = \"spline\"
span = [0, 2500, 5000]
prebend = [0, 10, 80]
twist = [\"8 deg\", \"3 deg\", \"0 deg\"]

[shape]
chord = { eta = [0, 1], value = [500, 300], course = \"linear\" }
origin = 0.3
naca = \"0018\"

[[layer]]
name = \"skin\"
material = \"glass\"
thickness = 1.5
fiber_angle = \"30 deg\"

[[layer]]
name = \"cap\"
material = \"glass\"
thickness = { eta = [0, 0.8], value = [4, 2] }
from = { x = 0.45, side = \"suction\" }
to = { x = 0.2, side = \"suction\" }

[[layer]]
name = \"tip\"
material = \"lead\"
thickness = { eta = [0.6, 0.75], value = [0, 2] }
from = { x = 0.2, side = \"suction\" }
to = { x = 0.2, side = \"pressure\" }

[[web]]
name = \"web\"
suction = { x = 0.4, side = \"suction\" }
pressure = { x = 0.4, side = \"pressure\" }
plies = [{ name = \"ply\", material = \"glass\", thickness = 3 }]

[mesh]
size = 80

[material.glass]
e1 = 40
e2 = 10
g12 = 4
nu12 = 0.28
nu23 = 0.4
density = \"1900 kg/m^3\"

[material.lead]
young = 16
poisson = 0.4
density = \"11340 kg/m^3\"
";

const SECTIONS: [&str; 3] = ["eta_0.2000", "eta_0.7000", "eta_1.0000"];

fn workplace(text: &str) -> Workplace {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", text);
    workplace
}

fn blade(workplace: &Workplace, more: &[&str]) -> Run {
    workplace.run(&[&["blade", "a.layup.toml", "--out", "b"], more].concat())
}

fn json(workplace: &Workplace, file: &str) -> Value {
    serde_json::from_str(&workplace.read(file)).unwrap()
}

/// All files below a folder, with their contents.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            found.insert(path.clone(), std::fs::read(path).unwrap());
        }
    }
    found
}

/// The same, by their paths from the folder.
fn results(workplace: &Workplace) -> BTreeMap<PathBuf, Vec<u8>> {
    let folder = workplace.path("b");
    let all = files(&folder).into_iter();
    all.map(|(path, content)| (path.strip_prefix(&folder).unwrap().to_owned(), content))
        .collect()
}

/// A millionth of the length inside and outside of the end of the cap, and a station between:
/// the numbers of the blade file are the numbers of `mesh layup` and `analyze`, digit by digit.
#[test]
fn stations_are_the_sections_that_are_solved_alone() {
    let workplace = workplace(LAYUP);
    let run = blade(&workplace, &["--stations", "0.3,0.8", "--no-figures"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let blade = json(&workplace, "b/a.blade.json");
    let stations = blade["stations"].as_array().unwrap();
    assert_eq!(stations.len(), 3);
    let positions = [0.3, 0.8 - 1e-6, 0.8 + 1e-6];
    for (station, eta) in stations.iter().zip(positions) {
        let eta = eta.to_string();
        let name = format!("at_{eta}");
        let (mesh, section) = (format!("{name}.msh"), format!("{name}.section.toml"));
        let at = ["--eta", &eta, "--out", &mesh, "--section", &section];
        let run = workplace.run(&[&["mesh", "layup", "a.layup.toml"], &at[..]].concat());
        assert_eq!(run.code, 0, "{}", run.err);
        let run = workplace.run(&["analyze", &section, "--no-figures"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let alone = json(&workplace, &format!("results/{name}.properties.json"));
        for matrix in ["stiffness", "mass"] {
            assert_eq!(station[matrix], alone[matrix], "{eta} {matrix}");
        }
    }
    let length = |at: usize| stations[at]["arc_length"].as_f64().unwrap();
    assert_eq!(length(1), length(2));
    assert!((length(0) / length(1) - 0.375).abs() < 1e-15);
    assert!(length(1) > 4.0 && length(1) < 4.01, "{}", length(1));
    assert_ne!(stations[1]["mass"], stations[2]["mass"]);
}

/// Lead in the nose from 0.6 to 0.75: its thickness and its density change the section at 0.7,
/// a remark none.
#[test]
fn a_change_solves_the_sections_that_it_touches() {
    let workplace = workplace(LAYUP);
    let stations = ["--stations", "0.2,0.7,1", "--no-figures"];
    let last = |run: &Run| {
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let sum = run.out.lines().find(|line| line.contains(" sections: "));
        sum.unwrap().to_owned()
    };
    assert_eq!(last(&blade(&workplace, &stations)), "3 sections: 3 solved");
    assert_eq!(
        last(&blade(&workplace, &stations)),
        "3 sections: 3 unchanged"
    );
    for (from, to, expected) in [
        (
            "value = [0, 2]",
            "value = [0, 1.9]",
            "3 sections: 1 solved, 2 unchanged",
        ),
        ("11340", "11341", "3 sections: 1 solved, 2 unchanged"),
        ("[[web]]", "# a web\n[[web]]", "3 sections: 3 unchanged"),
        ("\"1900 kg", "\"1901 kg", "3 sections: 3 solved"),
    ] {
        let text = workplace.read("a.layup.toml");
        assert_eq!(text.matches(from).count(), 1, "{from}");
        workplace.write("a.layup.toml", &text.replace(from, to));
        assert_eq!(last(&blade(&workplace, &stations)), expected, "{to}");
    }
    assert_eq!(
        last(&blade(&workplace, &[&stations[..], &["--force"]].concat())),
        "3 sections: 3 solved"
    );
}

/// The program is ended when one, two, four sections are complete; the next run solves the others
/// only, and writes the bytes of a run that nothing stopped.
#[test]
fn a_run_that_was_killed_continues() {
    let options = ["--count", "6", "--format", "beamdyn"];
    let whole = workplace(LAYUP);
    let run = blade(&whole, &options);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let expected = results(&whole);
    for least in [1, 2, 4] {
        let workplace = workplace(LAYUP);
        let command = [
            &["blade", "a.layup.toml", "--out", "b", "--threads", "1"],
            &options[..],
        ];
        let mut command = workplace.command(&command.concat());
        let mut child = command.stdout(std::process::Stdio::null()).spawn().unwrap();
        let start = Instant::now();
        let complete = || {
            let folder = std::fs::read_dir(workplace.path("b/sections"));
            let names = folder
                .into_iter()
                .flatten()
                .map(|entry| entry.unwrap().file_name());
            names
                .filter(|name| name.to_string_lossy().ends_with(".analysis.json"))
                .count()
        };
        while complete() < least && start.elapsed() < Duration::from_secs(120) {
            std::thread::sleep(Duration::from_millis(2));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        let kept = complete();
        assert!(kept >= least);
        let run = blade(&workplace, &options);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let unchanged = run
            .out
            .lines()
            .filter(|line| line.contains("  unchanged "))
            .count();
        assert_eq!(unchanged, kept, "{}", run.out);
        assert!(results(&workplace) == expected, "{least}");
    }
}

/// Result files that are cut anywhere, as by a full disk, and files that are missing.
#[test]
fn damaged_results_are_made_again() {
    let workplace = workplace(LAYUP);
    let options = ["--stations", "0.2,0.7,1", "--no-figures"];
    assert_eq!(blade(&workplace, &options).code, 0);
    let expected = results(&workplace);
    let mut random = Random(5);
    for round in 0..6 {
        for _ in 0..3 {
            let names: Vec<_> = expected.keys().collect();
            let file = workplace.path("b").join(names[random.below(names.len())]);
            let content = std::fs::read(&file).unwrap_or_default();
            match round % 2 {
                0 => std::fs::write(&file, &content[..random.below(content.len() + 1)]).unwrap(),
                _ => drop(std::fs::remove_file(&file)),
            }
        }
        assert_eq!(blade(&workplace, &options).code, 0);
        assert!(results(&workplace) == expected, "{round}");
    }
}

/// At 0.7 the tip layer is so thick that both sides meet behind the web: the others are written, a blade of
/// an earlier run is removed, and on request the blade is written without the section.
#[test]
fn a_section_that_fails_is_named_and_leaves_the_others() {
    let workplace = workplace(LAYUP);
    let options = ["--stations", "0.2,0.7,1", "--no-figures", "--format", "csv"];
    assert_eq!(blade(&workplace, &options).code, 0);
    let csv: Vec<_> = results(&workplace)
        .into_keys()
        .filter(|path| path.starts_with("csv"))
        .collect();
    assert!(!csv.is_empty());
    workplace.write("a.layup.toml", &failing(LAYUP));
    let run = blade(&workplace, &options);
    assert_eq!(run.code, 1, "{}", run.err);
    let lines: Vec<_> = run
        .err
        .lines()
        .filter(|line| line.starts_with("error"))
        .collect();
    assert_eq!(lines.len(), 2, "{}", run.err);
    assert!(
        lines[0].starts_with("error: a.layup.toml:36: eta 0.7: web \"web\" stands at arc"),
        "{}",
        lines[0]
    );
    assert_eq!(lines[1], "error: 1 of 3 sections are missing: eta 0.7");
    assert_eq!(workplace.read("b/a.span.csv").lines().count(), 3);
    let exists = |file: &str| workplace.path("b").join(file).exists();
    assert!(!exists("a.blade.json") && !exists("sections/eta_0.7000.properties.json"));
    assert!(
        csv.iter()
            .all(|file| !workplace.path("b").join(file).exists())
    );

    let run = blade(&workplace, &[&options[..], &["--skip-failed"]].concat());
    assert_eq!(run.code, 1, "{}", run.err);
    assert_eq!(
        json(&workplace, "b/a.blade.json")["stations"]
            .as_array()
            .unwrap()
            .len(),
        2
    );
    assert!(
        csv.iter()
            .all(|file| workplace.path("b").join(file).exists())
    );
}

/// A name that no section has is found before them, and reported once.
#[test]
fn an_unknown_place_is_reported_once() {
    let text = LAYUP.replace("{ x = 0.45, side = \"suction\" }", "\"web.sution\"");
    let run = blade(&workplace(&text), &["--count", "3", "--no-figures"]);
    assert_eq!(run.code, 2);
    let expected = "error: a.layup.toml:26: place \"web.sution\" is not in the file\n  help: did you \
                    mean \"web.suction\"?\n";
    assert_eq!(run.err, expected);
}

/// The layup with a web at 0.15 of the chord, where both sides of a thick tip layer meet at 0.7.
pub fn failing(text: &str) -> String {
    text.replace("{ x = 0.4, side", "{ x = 0.15, side")
        .replace("value = [0, 2]", "value = [0, 90]")
}

#[test]
fn figures_and_formats_are_written_on_request() {
    let workplace = workplace(LAYUP);
    let run = blade(&workplace, &["--count", "3", "--format", "all", "--quiet"]);
    // also no walls that touch in a single node at the trailing edge, which is thinner than the skin of both sides
    assert_eq!((run.code, run.out.as_str()), (0, ""));
    let cut = "a.layup.toml: layer \"skin\" is cut by up to 1.5 % of its area";
    assert!(run.err.contains(cut), "{}", run.err);
    assert_eq!(run.err.lines().count(), 1, "{}", run.err);
    for name in ["span", "shear", "centers"] {
        assert!(
            workplace.path(&format!("b/a.{name}.png")).exists(),
            "{name}"
        );
        assert!(
            workplace.read(&format!("b/a.{name}.svg")).contains("<svg"),
            "{name}"
        );
    }
    let own = exchange::read(&workplace.path("b/a.blade.json"))
        .unwrap()
        .blade;
    let beamdyn = exchange::read(&workplace.path("b/beamdyn/a.inp"))
        .unwrap()
        .blade;
    // BeamDyn has no jumps: a short ramp replaces them
    let error = beamdyn.mass() / own.mass() - 1.0;
    assert!(error.abs() < 1e-3, "{error}");
    let folders = [
        "beamdyn4", "hawc2", "windio1", "windio2", "dymore", "vabs", "mbdyn", "csv",
    ];
    for folder in folders {
        assert!(workplace.path(&format!("b/{folder}")).is_dir(), "{folder}");
    }
    let run = blade(&workplace, &["--count", "3", "--no-figures"]);
    assert_eq!(run.code, 0);
    assert!(!workplace.path("b/a.span.png").exists() && !workplace.path("b/a.span.svg").exists());
}

/// EA, mass and areas of the table against the property file and the sum over the layers.
#[test]
fn tables_have_the_stations_and_layers() {
    let workplace = workplace(LAYUP);
    let run = blade(&workplace, &["--stations", "0.2,0.7,1", "--no-figures"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let rows = |file: &str| -> Vec<BTreeMap<String, String>> {
        let text = workplace.read(file);
        let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned));
        let names: Vec<String> = lines.next().unwrap().collect();
        lines
            .map(|cells| names.iter().cloned().zip(cells).collect())
            .collect()
    };
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    let layers = rows("b/a.layers.csv");
    for (row, name) in rows("b/a.span.csv").iter().zip(SECTIONS) {
        assert_eq!(row["section"], name);
        let properties = json(&workplace, &format!("b/sections/{name}.properties.json"));
        let mass = number(row, "mass [kg/m]");
        assert_eq!(properties["mass"][0][0].as_f64(), Some(mass));
        let flap = number(row, "ei_flap [N m^2]");
        assert!(flap < number(row, "ei_edge [N m^2]") && flap > 0.0);
        let own = layers.iter().filter(|layer| layer["section"] == name);
        let of_layers = own.map(|layer| {
            let density = [1900.0, 11340.0][usize::from(layer["material"] == "lead")];
            density * number(layer, "meshed_area [m^2]")
        });
        let sum: f64 = of_layers.sum();
        // areas of curved cells by two routes
        assert!((sum / mass - 1.0).abs() < 1e-3, "{name}: {sum} {mass}");
    }
    let tips = layers.iter().filter(|layer| layer["layer"] == "tip");
    assert_eq!(tips.count(), 1);
}

#[test]
fn wrong_requests_are_refused() {
    let workplace = workplace(LAYUP);
    for (more, expected) in [
        (
            &["--stations", "0.2,1.5"][..],
            "expected positions from 0 at the root to 1 at the tip",
        ),
        (&["--stations", "x"], "expected positions from 0"),
        (&["--count", "1"], "expected a whole number, 2 to 10000"),
        (
            &["--count", "3", "--stations", "0.2"],
            "cannot be used with",
        ),
        (&["--format", "hawk2"], "did you mean \"hawc2\"?"),
        (
            &["--format", "qblade"],
            "expected \"all\" or some of beamdyn",
        ),
    ] {
        let run = blade(&workplace, more);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{more:?}");
        assert!(run.err.contains(expected), "{more:?}: {}", run.err);
    }
    let (line, rest) = LAYUP.split_once("[line]").unwrap();
    let (_, rest) = rest.split_once("[shape]").unwrap();
    workplace.write("a.layup.toml", &format!("{line}[shape]{rest}"));
    let run = blade(&workplace, &[]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("expected a table [line]"), "{}", run.err);
    workplace.write(
        "a.layup.toml",
        &LAYUP.replace("[0, 2500, 5000]", "[0, 2500, 2500]"),
    );
    let run = blade(&workplace, &[]);
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("error: a.layup.toml:5: point 3 of the line"),
        "{}",
        run.err
    );
    assert!(!workplace.path("b").exists());
}

/// Numbers from a seed (xorshift64*, Vigna 2016).
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % count.max(1)
    }
}

/// A text with one of the mistakes that people and disks make.
fn damaged(random: &mut Random) -> String {
    let lines: Vec<&str> = LAYUP.lines().collect();
    let at = random.below(lines.len());
    let replaced = |line: String| {
        let mut lines: Vec<String> = lines.iter().map(|&line| line.to_owned()).collect();
        lines[at] = line;
        lines.join("\n")
    };
    match random.below(6) {
        0 => LAYUP[..random.below(LAYUP.len())].to_owned(),
        1 => replaced(String::new()),
        2 => replaced(lines[at].replacen(['e', 'a', 'i'], "q", 1)),
        3 => replaced(lines[at].replace(['0', '2'], "nan")),
        4 => replaced(lines[at].replacen(['=', '"', ']'], "", 1)),
        _ => replaced(format!("{0}\n{0}", lines[at])),
    }
}

/// A hundred damaged files: done, or refused with a message that names the file; nothing panics, and a
/// file that is refused makes no blade.
#[test]
fn damaged_files_are_solved_or_refused() {
    let mut random = Random(77);
    let workplace = Workplace::new();
    let (mut solved, mut refused) = (0, 0);
    let count = effort::cases(100);
    for number in 0..count {
        workplace.write("a.layup.toml", &damaged(&mut random));
        let run = blade(&workplace, &["--stations", "0.1,0.7", "--no-figures"]);
        match run.code {
            0 => solved += 1,
            1 | 2 => {
                refused += 1;
                assert!(
                    run.err.contains("error: a.layup.toml"),
                    "{number}: {}",
                    run.err
                );
                assert!(!run.err.contains("panicked"), "{number}: {}", run.err);
            }
            code => panic!("{number}: {code} {}", run.err),
        }
        let exists = workplace.path("b/a.blade.json").exists();
        assert!(run.code != 1 || !exists, "{number}");
    }
    println!("{solved} solved, {refused} refused");
    assert!(
        20 * solved > count && 2 * refused > count,
        "{solved} {refused}"
    );
}
