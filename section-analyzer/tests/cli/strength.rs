//! `section-analyzer strength`: many loads on a blade, against single recoveries and the example
//! of the standard of counting.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use section_analyzer::input::span_loads::{LoadPositions, read_loads};

use crate::whole_blade::LAYUP;
use crate::workplace::{Run, Workplace};

/// Strengths of the material of the layup.
pub const STRENGTHS: &str = "\
[material.glass.strength]
xt = 1.1
xc = 0.7
yt = 0.04
yc = 0.14
s12 = 0.07
";

/// A solved blade of three stations, with strengths of one material.
fn solved() -> Workplace {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", &format!("{LAYUP}\n{STRENGTHS}"));
    let blade = ["blade", "a.layup.toml", "--out", "b", "--no-figures"];
    let run = workplace.run(&[&blade[..], &["--stations", "0.1,0.5,0.9"]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    workplace
}

fn strength(workplace: &Workplace, loads: &str, more: &[&str]) -> Run {
    workplace.write("loads.csv", loads);
    let command = ["strength", "b/a.span.csv", "--loads", "loads.csv"];
    workplace.run(&[&command[..], more].concat())
}

type Row = BTreeMap<String, String>;

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap()
}

/// The rows of a table, by the names of its columns.
fn rows(workplace: &Workplace, file: &str) -> Vec<Row> {
    let text = workplace.read(file);
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned));
    let names: Vec<String> = lines.next().unwrap().collect();
    lines
        .map(|cells| names.iter().cloned().zip(cells).collect())
        .collect()
}

/// The least reserve factor of `stress` under 400 N along z and a moment about y.
fn single(workplace: &Workplace, name: &str, moment: f64) -> f64 {
    let section = format!("b/sections/{name}.section.toml");
    let load = format!("--shear-z 400 --bending-y {moment} --out s --no-figures");
    let load: Vec<&str> = load.split(' ').collect();
    let run = workplace.run(&[&["stress", &section], &load[..]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    let points = rows(workplace, &format!("s/{name}.load.stress.csv"));
    let values = points.iter().flatten();
    let factors = values.filter(|(column, _)| column.contains("reserve_factor"));
    let factors = factors.filter_map(|(_, value)| value.parse::<f64>().ok());
    factors.fold(f64::INFINITY, f64::min)
}

/// A force at the tip in two steps, as `beam-dynamics static` writes it, in kN m: at each station
/// the second, larger step governs, and its reserve factor is the least of all points, plies and
/// criteria of `stress` under the moment there.
#[test]
fn loads_along_the_blade_are_those_of_single_recoveries() {
    let workplace = solved();
    let span = rows(&workplace, "b/a.span.csv");
    let length = number(span.last().unwrap(), "arc_length [m]") / 0.9;
    let mut table = "step,factor [-],member,arc [m],shear z [N],bending y [kN m]\n".to_owned();
    for step in 0..3 {
        let force = [100.0, 400.0, -50.0][step];
        for arc in [0.3, 2.0, 3.5, 4.8] {
            let moment = -force * (length - arc) / 1e3;
            writeln!(table, "{step},1,blade,{arc},{force},{moment}").unwrap();
        }
    }
    let run = strength(&workplace, &table, &[]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let found = rows(&workplace, "b/a.strength.csv");
    for row in &span {
        let (name, arc) = (&row["section"], number(row, "arc_length [m]"));
        let own = found.iter().filter(|one| &one["section"] == name);
        let factor = |one: &&Row| number(one, "reserve_factor [-]");
        let least = own.min_by(|a, b| factor(a).total_cmp(&factor(b))).unwrap();
        assert_eq!(
            (&*least["instant"], &*least["material"]),
            ("step 1", "glass")
        );
        let force =
            ["shear_z [N]", "bending_y [N m]", "torsion [N m]"].map(|key| number(least, key));
        let expected = [400.0, -400.0 * (length - arc), 0.0];
        let errors = force.iter().zip(expected).map(|(a, b)| (a - b).abs());
        assert!(
            errors.fold(0.0, f64::max) < 1e-9 * 2000.0,
            "{force:?} {expected:?}"
        );
        let single = single(&workplace, name, -400.0 * (length - arc));
        // six digits in the table of stresses
        let error = factor(&least) / single - 1.0;
        assert!(error.abs() < 1e-5, "{name}: {error}");
    }
    assert!(run.out.contains("Critical: ply \""), "{}", run.out);
    assert!(!workplace.path("b/a.fatigue.csv").exists());
}

/// The history of the example of ASTM E1049, figure 6, as a moment in kN m: half a range of 3, one
/// and a half of 4, half of 6, one of 8, half of 9 make the damage of 23 at the exponent 1.
#[test]
fn histories_are_counted_by_the_standard() {
    let workplace = solved();
    let history = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];
    let mut table = "time [s],root_bending_y [kN*m],root_axial [N]\n".to_owned();
    for (time, moment) in history.iter().enumerate() {
        writeln!(table, "{time},{moment},1000").unwrap();
    }
    let options = ["--at", "root=0.1", "--exponents", "1,2", "--cycles", "1"];
    let run = strength(&workplace, &table, &options);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let found = rows(&workplace, "b/a.fatigue.csv");
    let row = |component: &str, exponent: &str| {
        let is_it = |row: &&Row| {
            row["section"] == "eta_0.1000"
                && row["component"] == component
                && row["exponent [-]"] == exponent
        };
        let row = found.iter().find(is_it).unwrap();
        ["cycles [-]", "largest_range", "equivalent_range"]
            .map(|key| row[key].parse::<f64>().unwrap())
    };
    let [cycles, largest, equivalent] = row("bending y [N m]", "1e0");
    assert_eq!((cycles, largest), (4.0, 9000.0));
    assert!((equivalent / 23e3 - 1.0).abs() < 1e-12, "{equivalent}");
    let [.., equivalent] = row("bending y [N m]", "2e0");
    let squares: f64 = 0.5 * 9.0 + 1.5 * 16.0 + 0.5 * 36.0 + 64.0 + 0.5 * 81.0;
    assert!(
        (equivalent / (1e3 * squares.sqrt()) - 1.0).abs() < 1e-12,
        "{equivalent}"
    );
    assert_eq!(row("axial [N]", "1e0"), [0.0; 3]);
    // at a single position, only the station there has loads
    let stations = rows(&workplace, "b/a.strength.csv");
    assert!(stations.iter().all(|row| row["section"] == "eta_0.1000"));
    // the largest or the smallest moment governs
    let is_extreme = |row: &Row| ["time 3", "time 6"].contains(&&*row["instant"]);
    assert!(stations.iter().all(is_extreme), "{stations:?}");
}

/// Two cases over time, with the rows by position: an instant is a case at a time, and the ranges of all
/// cases are counted together, halves of 400 twice, of 1100 and of 1200.
#[test]
fn instants_are_cases_at_times_in_any_order() {
    let workplace = solved();
    let mut table = "case,time [s],eta,bending y [N m]\n".to_owned();
    for eta in [0.0, 1.0] {
        for (case, history) in [("calm", [100, -300, 100]), ("gust", [100, -1000, 200])] {
            for (time, moment) in history.iter().enumerate() {
                writeln!(table, "{case},{time},{eta},{moment}").unwrap();
            }
        }
    }
    let run = strength(&workplace, &table, &["--exponents", "1", "--cycles", "1"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let found = rows(&workplace, "b/a.strength.csv");
    let stations: BTreeSet<_> = found.iter().map(|row| row["section"].clone()).collect();
    assert_eq!(stations.len(), 3);
    for row in &found {
        assert_eq!(row["instant"], "case gust time 1");
        assert_eq!(number(row, "bending_y [N m]"), -1000.0);
    }
    let fatigue = rows(&workplace, "b/a.fatigue.csv");
    for row in &fatigue {
        let is_bending = row["component"] == "bending y [N m]";
        let expected = if is_bending { [2.0, 1550.0] } else { [0.0; 2] };
        let found = ["cycles [-]", "equivalent_range"].map(|key| number(row, key));
        let errors = [0, 1].map(|i| (found[i] - expected[i]).abs());
        assert!(errors[0] == 0.0 && errors[1] < 1e-9, "{found:?}");
    }
}

#[test]
fn wrong_tables_are_refused_with_their_line() {
    let workplace = solved();
    for (table, more, expected) in [
        (
            "arc [m],bending x [N m]\n1,2\n",
            &[][..],
            "loads.csv:1: the table has no column \"bending_y\"",
        ),
        (
            "arc [s],bending y [N m]\n1,2\n",
            &[],
            "loads.csv:1: column \"arc [s]\": ",
        ),
        (
            "arc [m],bending y [N m]\n1,2\n2,x\n",
            &[],
            "loads.csv:3: column \"bending y [N m]\": found \"x\", expected a number",
        ),
        (
            "arc,bending y\n1,nan\n",
            &[],
            "loads.csv:2: column \"bending y\": found \"nan\"",
        ),
        ("bending y [N m]\n1\n", &[], "has no column \"arc_length\""),
        (
            "arc,member,axial\n1,a,2\n1,b,2\n",
            &[],
            "the table has the members \"a\", \"b\", expected one",
        ),
        (
            "arc,member,axial\n1,a,2\n",
            &["--member", "c"],
            "no rows of member \"c\"",
        ),
        (
            "arc,axial [N],bending-y [N m]\n1,2,3\n",
            &[],
            "loads.csv:1: column \"bending-y\" is no component of the internal force",
        ),
        (
            "arc,axial [N],My [kN m]\n1,2,3\n",
            &[],
            "loads.csv:1: column \"my\" is no component",
        ),
        ("arc,axial\n", &[], "loads.csv:1: the table has no rows"),
        ("", &[], "the table has no rows"),
        (
            "time,tip_axial\n0,1\n",
            &["--at", "root=0"],
            "no column \"root_bending_y\"",
        ),
    ] {
        let run = strength(&workplace, table, more);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{table}");
        assert!(run.err.contains(expected), "{table}: {}", run.err);
    }
}

#[test]
fn a_position_needs_a_number() {
    let run = strength(&solved(), "", &["--at", "root"]);
    assert!(
        run.code == 2 && run.err.contains("expected NAME=ETA"),
        "{}",
        run.err
    );
}

/// 200 tables with a changed byte: read, or refused with the name of the file.
#[test]
fn damaged_tables_are_read_or_refused() {
    let workplace = Workplace::new();
    let table = "time [s],eta [-],axial [N],bending y [N m]\n0,0.1,1,2\n0,0.9,1,2\n1,0.1,3,4\n";
    for number in 0..200 {
        let mut bytes = table.as_bytes().to_vec();
        let at = (number * 37) % bytes.len();
        bytes[at] = b"\",[]x\n-9.# "[number % 11];
        let positions = LoadPositions {
            length: 5.0,
            member: None,
            named: Vec::new(),
        };
        workplace.write("loads.csv", &String::from_utf8(bytes).unwrap());
        let path = workplace.path("loads.csv");
        if let Err(problems) = read_loads(&path, &positions) {
            assert!(
                problems.to_string().contains("loads.csv"),
                "{number}: {problems}"
            );
        }
    }
}

/// Sections of `blade` are not solved again, until their record is gone; the reserve factors are
/// the same to the round-off of the inverse of the stiffness. The files have the warping with
/// all digits.
#[test]
fn solved_sections_are_not_solved_again() {
    let workplace = solved();
    let table = "step,eta,shear z [N],bending y [N m]\n0,0,400,-2000\n0,1,400,0\n";
    let first = strength(&workplace, table, &[]);
    assert_eq!(
        (first.code, first.out.matches(" unchanged ").count()),
        (0, 3),
        "{}",
        first.out
    );
    let known = rows(&workplace, "b/a.strength.csv");
    std::fs::remove_file(workplace.path("b/sections/eta_0.5000.analysis.json")).unwrap();
    let second = strength(&workplace, table, &[]);
    assert_eq!(second.out.matches(" solved ").count(), 1, "{}", second.out);
    for (a, b) in known.iter().zip(&rows(&workplace, "b/a.strength.csv")) {
        let factor = |row: &Row| number(row, "reserve_factor [-]");
        assert!((factor(a) / factor(b) - 1.0).abs() < 1e-9, "{a:?} {b:?}");
        assert_eq!((&a["ply"], &a["criterion"]), (&b["ply"], &b["criterion"]));
    }
    let path = |ending: &str| workplace.path(&format!("b/sections/eta_0.5000.{ending}"));
    let input = section_analyzer::input::read(&path("section.toml")).unwrap();
    let solution = section_analyzer::analysis::analyze(&input.section).unwrap();
    let warping = section_analyzer::input::read_warping(&path("warping.vtu")).unwrap();
    assert_eq!(warping, solution.warping);
    let text = workplace.read("b/sections/eta_0.5000.warping.vtu");
    let text = text.replace("Name=\"warping_torsion\"", "Name=\"w\"");
    workplace.write("b/sections/eta_0.5000.warping.vtu", &text);
    let problem = section_analyzer::input::read_warping(&path("warping.vtu")).unwrap_err();
    let expected = "the points have no array \"warping_torsion\"";
    assert!(problem.to_string().contains(expected), "{problem}");
    assert!(strength(&workplace, table, &[]).out.contains(" solved "));
}

/// A blade without strengths: fatigue loads are written, and the table that is missing is named.
#[test]
fn strengths_are_needed() {
    let workplace = solved();
    workplace.write("a.layup.toml", LAYUP);
    let blade = [
        "blade",
        "a.layup.toml",
        "--out",
        "b",
        "--no-figures",
        "--stations",
        "0.5",
    ];
    assert_eq!(workplace.run(&blade).code, 0);
    let run = strength(
        &workplace,
        "time,eta,axial\n0,0.4,1\n0,0.6,1\n1,0.4,2\n1,0.6,2\n",
        &[],
    );
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("expected [material.NAME.strength]"),
        "{}",
        run.err
    );
    assert!(workplace.path("b/a.fatigue.csv").exists());
    assert!(!workplace.path("b/a.strength.csv").exists());
}
