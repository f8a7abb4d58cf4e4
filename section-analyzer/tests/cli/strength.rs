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
m = 10
m_matrix = 8
";

/// A solved blade of three stations, with strengths of one material.
pub fn solved() -> Workplace {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", &format!("{LAYUP}\n{STRENGTHS}"));
    let blade = ["blade", "a.layup.toml", "--out", "b", "--no-figures"];
    let run = workplace.run(&[&blade[..], &["--stations", "0.1,0.5,0.9"]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    workplace
}

pub fn strength(workplace: &Workplace, loads: &str, more: &[&str]) -> Run {
    workplace.write("loads.csv", loads);
    let command = ["strength", "b/a.span.csv", "--loads", "loads.csv"];
    workplace.run(&[&command[..], more].concat())
}

pub type Row = BTreeMap<String, String>;

pub fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap()
}

/// The rows of a table, by the names of its columns.
pub fn rows(workplace: &Workplace, file: &str) -> Vec<Row> {
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
    stresses_are_those_of_single_recoveries(&workplace, &found[0]);
    assert!(!workplace.path("b/a.fatigue.csv").exists());
    // the table of stations is found beside the blade
    let table = workplace.read("b/a.strength.csv");
    let by_blade = ["strength", "b/a.blade.json", "--loads", "loads.csv"];
    let again = workplace.run(&by_blade);
    assert_eq!((again.code, again.err.as_str()), (0, ""));
    assert_eq!(workplace.read("b/a.strength.csv"), table);
}

/// The stresses of a row equal the ones of `stress` at its position, whose table has six digits.
fn stresses_are_those_of_single_recoveries(workplace: &Workplace, row: &Row) {
    let section = format!("b/sections/{}.section.toml", row["section"]);
    let [shear, moment] = ["shear_z [N]", "bending_y [N m]"].map(|key| &*row[key]);
    let load = [
        "--shear-z",
        shear,
        "--bending-y",
        moment,
        "--out",
        "s",
        "--no-figures",
    ];
    let run = workplace.run(&[&["stress", &section], &load[..]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    let points = rows(workplace, &format!("s/{}.load.stress.csv", row["section"]));
    let distance = |point: &Row| {
        let parts = ["y [m]", "z [m]"].map(|key| (number(point, key) - number(row, key)).powi(2));
        parts.iter().sum::<f64>()
    };
    let nearest = points
        .iter()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap();
    let axes = ["11", "22", "33", "23", "13", "12"];
    let [single, own] =
        [nearest, row].map(|row| axes.map(|axes| number(row, &format!("stress_{axes} [Pa]"))));
    let largest = own
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    for (a, b) in single.iter().zip(own) {
        assert!((a - b).abs() < 1e-5 * largest, "{single:?} {own:?}");
    }
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

/// Two cases of ten cycles in 20 s.
fn two_cases() -> String {
    let mut table = "case,time [s],eta,bending y [N m]\n".to_owned();
    for eta in [0.0, 1.0] {
        for (case, moments) in [("calm", [-500, 500]), ("gust", [-1000, 1000])] {
            // ten cycles in 20 s
            for time in 0..=20 {
                writeln!(table, "{case},{time},{eta},{}", moments[time % 2]).unwrap();
            }
        }
    }
    table
}

/// Two cases of constant cycles, one of which lasts 2000 hours: each row is Miner's sum of both by its
/// own numbers, the second range is the half of the first. The life is the whole time over it.
#[test]
fn damage_is_the_sum_of_the_cycles_of_all_cases() {
    let workplace = solved();
    let table = two_cases();
    workplace.write("life.csv", "case,duration [h]\ngust,1\ncalm,2000\n");
    let run = strength(&workplace, &table, &["--durations", "life.csv"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.contains("Damage of 2001 h"), "{}", run.out);
    assert!(
        run.out.contains("Critical in fatigue: ply \""),
        "{}",
        run.out
    );
    let found = rows(&workplace, "b/a.damage.csv");
    let plies = |name: &str| {
        let rows = rows(&workplace, name).into_iter();
        rows.map(|row| (row["section"].clone(), row["ply"].clone()))
            .collect::<BTreeSet<_>>()
    };
    assert_eq!(plies("b/a.damage.csv"), plies("b/a.strength.csv"));
    for row in &found {
        let [range, mean, limit, slope] = [
            "largest_range",
            "mean_of_largest",
            "limit_amplitude",
            "slope [-]",
        ]
        .map(|key| number(row, key));
        let limits: [f64; 3] = match &*row["component"] {
            "stress 11 [Pa]" => [1.1e9, 0.7e9, 10.0],
            "stress 22 [Pa]" => [0.04e9, 0.14e9, 8.0],
            "stress 12 [Pa]" => [0.07e9, 0.07e9, 8.0],
            other => panic!("{other}"),
        };
        assert!(mean.abs() < 1e-9 * range, "{row:?}");
        let expected = limits[0].min(limits[1]);
        assert!((limit / expected - 1.0).abs() < 1e-6 && slope == limits[2]);
        let ratio = 0.5 * range / limit;
        // 180 and 360 000 periods of 20 s
        let damage = 1800.0 * ratio.powf(slope) + 3.6e6 * (0.5 * ratio).powf(slope);
        let error = number(row, "damage [-]") / damage - 1.0;
        assert!(error.abs() < 1e-6, "{row:?}");
        assert_eq!(number(row, "cycles [-]"), 3_601_800.0);
        let life = number(row, "life [h]") * damage / 2001.0 - 1.0;
        let factor = number(row, "reserve_factor [-]") / damage.powf(-1.0 / slope) - 1.0;
        assert!(life.abs() < 1e-6 && factor.abs() < 1e-6, "{row:?}");
    }
}

#[test]
fn durations_are_of_all_cases() {
    let workplace = solved();
    let table = two_cases();
    for (durations, expected) in [
        (
            "case,duration [h]\ngust,1\ncalmm,-1\ngust,2\n",
            &[
                "life.csv:3: column \"duration [h]\" of case \"calmm\": found -1",
                "life.csv:4: case \"gust\" is there twice",
                "life.csv:1: the table has no duration of \"calm\"",
            ][..],
        ),
        (
            "case,duration [m]\ngust,1\n",
            &["life.csv:1: column \"duration [m]\""],
        ),
        (
            "case,duration\ncalmm,1\ncalm,1\ngust,1\n",
            &["did you mean \"calm\"?"],
        ),
    ] {
        workplace.write("life.csv", durations);
        let run = strength(&workplace, &table, &["--durations", "life.csv"]);
        assert_eq!(run.code, 2);
        assert!(
            expected.iter().all(|text| run.err.contains(text)),
            "{}",
            run.err
        );
    }
    let run = strength(
        &workplace,
        "eta,axial\n0,1\n1,1\n",
        &["--durations", "life.csv"],
    );
    assert!(
        run.err.contains("the loads have no cases over time"),
        "{}",
        run.err
    );
}

/// An envelope is its corners: the smallest reserve factors equal the ones of the table of all four
/// combinations of two components, with the stresses of the governing one.
#[test]
fn envelopes_are_the_loads_of_their_corners() {
    let workplace = solved();
    let envelope = "eta,shear z max [N],shear z min [N],bending y max [kN m],bending y min [kN m]\n\
                    0,300,-100,0.2,-2\n1,100,-50,0.1,-0.1\n";
    let run = strength(&workplace, envelope, &[]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let known = rows(&workplace, "b/a.strength.csv");
    let mut table = "case,eta,shear z [N],bending y [kN m]\n".to_owned();
    for corner in 0..4 {
        let [shear, bending] = [corner % 2, corner / 2];
        for (eta, shears, moments) in [(0, [300, -100], [0.2, -2.0]), (1, [100, -50], [0.1, -0.1])]
        {
            writeln!(
                table,
                "{corner},{eta},{},{}",
                shears[shear], moments[bending]
            )
            .unwrap();
        }
    }
    assert_eq!(strength(&workplace, &table, &[]).code, 0);
    let single = rows(&workplace, "b/a.strength.csv");
    assert_eq!(known.len(), single.len());
    let names = [
        "shear_z max bending_y max",
        "shear_z min bending_y max",
        "shear_z max bending_y min",
        "shear_z min bending_y min",
    ];
    for (a, b) in known.iter().zip(&single) {
        let corner: usize = b["instant"].strip_prefix("case ").unwrap().parse().unwrap();
        assert_eq!(a["instant"], names[corner]);
        for (column, value) in a.iter().filter(|(column, _)| *column != "instant") {
            assert_eq!(*value, b[column], "{column}");
        }
    }
    let run = strength(&workplace, "eta,axial max\n0,1\n1,1\n", &[]);
    assert!(
        run.code == 2 && run.err.contains("no column \"axial_min\""),
        "{}",
        run.err
    );
}

/// Tables, options, and the expected message.
const WRONG_TABLES: &[(&str, &[&str], &str)] = &[
    (
        "arc [m],bending x [N m]\n1,2\n",
        &[],
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
    (
        "bending y [N m]\n1\n",
        &[],
        "the table has no positions along the blade, expected a column \"eta\"",
    ),
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
    (
        "eta,case,time,axial\n0,a,1,5\n1,a,1,5\n0,a,1,1\n",
        &[],
        "loads.csv:4: the second row for eta 0 of case a time 1, expected one",
    ),
    (
        "eta,axial [N],axial [kN]\n0,1,2\n",
        &[],
        "loads.csv:1: 2 columns are called \"axial\", expected one",
    ),
    (
        "eta,axial max,axial min\n0,5,0\n1,5,0\n0,1,0\n",
        &[],
        "loads.csv:4: the second row for eta 0 of the envelope",
    ),
    (
        "eta,axial max,axial min\n0,-1,1\n",
        &[],
        "loads.csv:2: the largest value of axial is less than the smallest",
    ),
    (
        "eta,time [s],axial max,axial min\n0,0,5,0\n",
        &[],
        "loads.csv:1: column \"time\" beside columns of largest and smallest values",
    ),
    (
        "eta,axial max,axial min,bending y\n0,5,0,1\n",
        &[],
        "loads.csv:1: column \"bending_y\" beside columns of largest",
    ),
    ("arc,axial\n", &[], "loads.csv:1: the table has no rows"),
    ("", &[], "the table has no rows"),
    (
        "time,tip_axial\n0,1\n",
        &["--at", "root=0"],
        "no column \"root_bending_y\"",
    ),
];

#[test]
fn wrong_tables_are_refused_with_their_line() {
    let workplace = solved();
    for (table, more, expected) in WRONG_TABLES {
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
    // the folder may be moved, and be used from another one, by its blade file
    std::fs::create_dir_all(workplace.path("c/d")).unwrap();
    std::fs::rename(workplace.path("b"), workplace.path("c/b")).unwrap();
    let mut moved = workplace.command(&[
        "strength",
        "../b/a.blade.json",
        "--loads",
        "../../loads.csv",
    ]);
    let moved = moved.current_dir(workplace.path("c/d")).output().unwrap();
    let shown = String::from_utf8(moved.stdout).unwrap();
    assert_eq!(shown.matches(" unchanged ").count(), 3, "{shown}");
    assert_eq!(rows(&workplace, "c/b/a.strength.csv"), known);
    std::fs::rename(workplace.path("c/b"), workplace.path("b")).unwrap();
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

/// Plies without a row are named with the key that their material lacks.
#[test]
fn plies_that_are_not_assessed_are_named() {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", &format!("{LAYUP}\n{STRENGTHS}"));
    let blade = ["blade", "a.layup.toml", "--out", "b", "--no-figures"];
    let run = workplace.run(&[&blade[..], &["--stations", "0.7"]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out.contains("  remark: the blade file has one station"),
        "{}",
        run.out
    );
    let loads = "time,eta,bending y\n0,0.6,1\n0,0.8,1\n1,0.6,2\n1,0.8,2\n";
    let run = strength(&workplace, loads, &[]);
    assert_eq!(run.code, 0, "{}", run.err);
    for key in ["[material.NAME.strength]", "\"m\" beside the strengths"] {
        let expected = format!("\nNot assessed, without {key}: \"lead\" (");
        let text = run.out.split(&expected).nth(1);
        let plies = text.and_then(|text| text.split(')').next());
        assert_eq!(plies, Some("tip"), "{}", run.out);
    }
}
