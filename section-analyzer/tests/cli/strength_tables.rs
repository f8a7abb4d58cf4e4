//! Tables of loads for `section-analyzer strength`: units, cases, positions, errors and
//! warnings.

use crate::strength::{Row, number, rows, solved, strength};
use crate::whole_blade::LAYUP;
use crate::workplace::{Run, Workplace};

/// The warnings of a run.
fn warnings(run: &Run) -> Vec<&str> {
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let lines = run.out.lines();
    lines
        .filter_map(|line| line.strip_prefix("  remark: "))
        .collect()
}

/// All tables of loads that a run wrote.
fn written(workplace: &Workplace) -> [String; 3] {
    ["strength", "fatigue", "damage"].map(|name| workplace.read(&format!("b/a.{name}.csv")))
}

/// A cycle and a half in 3 s, as 3000 ms too, by rows of positions and by rows of times: the same
/// tables, and a life of 3 s / 3600 times its factor. One hour has 1200 such histories.
#[test]
fn times_have_units() {
    let workplace = solved();
    let long = |unit: &str, second: f64| {
        let row = |(i, moment): (usize, f64)| {
            let time = second * i as f64;
            format!("0,{time},{moment}\n1,{time},{moment}\n")
        };
        let moments = [500.0, -500.0, 500.0, -500.0].into_iter().enumerate();
        let all: String = moments.map(row).collect();
        format!("eta,time{unit},bending y [N m]\n{all}")
    };
    let wide = "time [ms],r_bending_y,t_bending_y\n0,500,500\n1000,-500,-500\n2000,500,500\n\
                3000,-500,-500\n";
    assert!(warnings(&strength(&workplace, &long("", 1.0), &[])).is_empty());
    let known = written(&workplace);
    for row in rows(&workplace, "b/a.damage.csv") {
        let life = number(&row, "life_factor [-]") * 3.0 / 3600.0;
        assert!((number(&row, "life [h]") / life - 1.0).abs() < 1e-12);
    }
    strength(&workplace, &long(" [ms]", 1e3), &[]);
    assert_eq!(written(&workplace), known);
    strength(&workplace, wide, &["--at", "r=0", "--at", "t=1"]);
    assert_eq!(written(&workplace), known);
    let cases = |table: String| {
        let rows = table.lines().map(|line| match line.starts_with("eta") {
            true => format!("case,{line}\n"),
            false => format!("a,{line}\n"),
        });
        rows.collect::<String>()
    };
    workplace.write("life.csv", "case,duration [min]\na,60\n");
    let once = number(&rows(&workplace, "b/a.damage.csv")[0], "damage [-]");
    let durations = ["--durations", "life.csv"];
    strength(&workplace, &cases(long(" [ms]", 1e3)), &durations);
    let hour = number(&rows(&workplace, "b/a.damage.csv")[0], "damage [-]");
    assert!((hour / once / 1200.0 - 1.0).abs() < 1e-12, "{hour} {once}");
}

/// A row for each time, of two cases and two members: the same tables as with a row for each
/// position of the wanted member, and instants written as 0 and 0.0 are one.
#[test]
fn rows_of_times_have_cases_and_members() {
    let workplace = solved();
    let wide = "member,case,time [s],r_bending_y,t_bending_y\n\
                one,a,0,100,10\none,a,1,-100,-10\none,b,0,200,20\none,b,1,-200,-20\n\
                two,a,0,9e9,9e9\n";
    let options = ["--at", "r=0", "--at", "t=1", "--member", "one"];
    assert!(warnings(&strength(&workplace, wide, &options)).is_empty());
    let known = written(&workplace);
    let long = "case,eta,time [s],step,bending y [N m]\n\
                a,0,0,1,100\na,1,0.0,1.0,10\na,0,1,2,-100\na,1,1.0,2,-10\n\
                b,0,0,1,200\nb,1,0,1,20\nb,0,1,2,-200\nb,1,1,2,-20\n";
    assert!(warnings(&strength(&workplace, long, &[])).is_empty());
    let [reserves, fatigue, damage] = written(&workplace);
    let steps = reserves.replace(" step 1", "").replace(" step 2", "");
    assert_eq!([steps, fatigue, damage], known);
}

/// Tables, options, and the warnings.
const WARNED: &[(&str, &[&str], &[&str])] = &[
    (
        "eta [%],bending y [N m]\n0,5\n50,5\n",
        &[],
        &[
            "forces at eta 0.9 are extrapolated by up to 0.4 of the length, beyond the positions eta 0 \
           to 0.5",
        ],
    ),
    (
        "case,eta,axial [N]\na,0,5\na,1,5\nb,0.25,6\n",
        &[],
        &["no station is at the only position of the force, eta 0.25, in case \"b\""],
    ),
    (
        "time,eta,axial [N]\n0,0,5\n0,1,5\n1,0.5,6\n",
        &[],
        &[
            "the stations at eta 0.1, 0.9 have no force at 1 of 2 instants: the only position is eta \
           0.5",
        ],
    ),
    (
        "time,r_axial,mid_axial,tip_x [m]\n0,5,6,7\n1,6,7,8\n",
        &["--at", "r=0.1"],
        &[
            "the stations at eta 0.5, 0.9 have no force: the only position is eta 0.1",
            "columns that are not used: \"mid_axial\", \"tip_x [m]\"",
        ],
    ),
    (
        "eta,axial,remark\n0,0,x\n1,0,x\n",
        &[],
        &[
            "all forces are zero",
            "columns that are not used: \"remark\"",
        ],
    ),
    // the table of an equilibrium
    (
        "step,factor [-],member,beam,xi [-],arc [m],x [m],axial [N],strain axial [-]\n\
         0,1,m,b,0,0,0,5,0\n0,1,m,b,0,5,0,5,0\n",
        &[],
        &[],
    ),
];

#[test]
fn loads_without_effect_are_reported() {
    let workplace = solved();
    for (table, more, expected) in WARNED {
        let run = strength(&workplace, table, more);
        assert_eq!(warnings(&run), *expected, "{table}");
    }
    // at one position, fatigue loads are there only
    strength(&workplace, WARNED[3].0, WARNED[3].1);
    let fatigue = rows(&workplace, "b/a.fatigue.csv");
    assert!(!fatigue.is_empty() && fatigue.iter().all(|row| row["section"] == "eta_0.1000"));
    let command = [
        "strength",
        "b/a.span.csv",
        "--loads",
        "loads.csv",
        "--quiet",
    ];
    workplace.write("loads.csv", WARNED[4].0);
    let run = workplace.run(&command);
    assert!(
        run.err
            .starts_with("warning: loads.csv: all forces are zero\n"),
        "{}",
        run.err
    );
}

/// Tables, options, and the message.
const REFUSED: &[(&str, &[&str], &str)] = &[
    (
        "eta,time [m],axial\n0,1,2\n",
        &[],
        "loads.csv:1: column \"time [m]\": ",
    ),
    (
        "time,r_axial\n0,1\n1,2\n0,3\n",
        &["--at", "r=0"],
        "loads.csv:4: the second row for time 0, expected one for each time of a case",
    ),
    (
        "time,r_axial,t_axial\n0,1,2\n",
        &["--at", "r=0.5", "--at", "t=0.5"],
        "loads.csv:1: the columns of \"r\" and \"t\" are both at eta 0.5, expected one",
    ),
    (
        "eta,axial\n0,1\n",
        &["--member", "zz"],
        "loads.csv:1: the table has no column \"member\", and member \"zz\" is requested",
    ),
    (
        "time,r_axial,member\n0,1,a\n1,1,b\n",
        &["--at", "r=0"],
        "the table has the members \"a\", \"b\", expected one",
    ),
    (
        "eta,axial,bending_x\n0,1,2\n",
        &[],
        "loads.csv:1: column \"bending_x\" is no component",
    ),
    (
        "eta,axial,moment z\n0,1,2\n",
        &[],
        "loads.csv:1: column \"moment_z\" is no component",
    ),
    (
        "time,r_axial,r_my\n0,1,2\n",
        &["--at", "r=0"],
        "loads.csv:1: column \"r_my\" is no component",
    ),
    (
        "eta,axial max,axial min,shear z maximum [N]\n0,1,0,9\n",
        &[],
        "loads.csv:1: column \"shear_z_maximum\" is no component",
    ),
    (
        "eta,axial,shear z (kN)\n0,1,2\n",
        &[],
        "loads.csv:1: column \"shear z (kN)\" has its unit in round brackets, expected square \
         brackets\n  help: write \"shear z [kN]\"",
    ),
    (
        "eta;axial\n0;1\n",
        &[],
        "loads.csv:1: semicolons separate the cells of \"eta;axial\", expected commas",
    ),
    (
        "eta,axial\n0,5,1\n",
        &[],
        "loads.csv:2: the row has 3 cells, expected 2, one for each column\n  help: commas separate \
         cells: write decimals with a point",
    ),
    (
        "eta,axial\n0,1\n100,2\n",
        &[],
        "loads.csv:3: column \"eta\": found \"100\", which is eta 100, expected 0 at the root",
    ),
    (
        "eta,arc [m],axial\n0,0,1\n",
        &[],
        "loads.csv:1: the table has the positions \"eta\", \"arc\", expected one of them",
    ),
    (
        "eta,axial [-]\n0,1\n",
        &[],
        "loads.csv:1: column \"axial [-]\": ",
    ),
    (
        "eta,time [s],time [h],axial\n0,1,1,1\n",
        &[],
        "loads.csv:1: 2 columns are called \"time\", expected one",
    ),
];

#[test]
fn doubtful_tables_are_refused() {
    let workplace = solved();
    for (table, more, expected) in REFUSED {
        let run = strength(&workplace, table, more);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{table}");
        assert!(run.err.contains(expected), "{table}: {}", run.err);
    }
}

/// Another layup with the same stations overwrites the sections: the first table is refused.
#[test]
fn sections_belong_to_their_table() {
    let workplace = solved();
    workplace.write(
        "c.layup.toml",
        &LAYUP.replace("thickness = 1.5", "thickness = 1.6"),
    );
    let blade = ["blade", "c.layup.toml", "--out", "b", "--no-figures"];
    let run = workplace.run(&[&blade[..], &["--stations", "0.1,0.9"]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let run = strength(&workplace, "eta,axial\n0,1\n1,1\n", &[]);
    let expected = "error: b/a.span.csv: sections have changed since the blade was solved: \
                    \"eta_0.1000\", \"eta_0.9000\"\n  help: run \"section-analyzer blade\" again, for \
                    each layup into a folder of its own by --out\n";
    assert_eq!((run.code, run.err.as_str()), (2, expected));
    let table = workplace.read("b/a.span.csv");
    let rows = table
        .lines()
        .map(|line| line.rsplit_once(',').unwrap().0.to_owned() + "\n");
    workplace.write("b/a.span.csv", &rows.collect::<String>());
    let run = strength(&workplace, "eta,axial\n0,1\n1,1\n", &[]);
    let expected = "the table has no column \"fingerprint\": whether its sections have changed since is \
                    unknown";
    assert_eq!(warnings(&run), [expected]);
}

/// A layup in the place of the table that `blade` makes of it.
#[test]
fn a_layup_is_no_table_of_stations() {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", LAYUP);
    workplace.write("l.csv", "eta,axial\n0,1\n1,1\n");
    let run = workplace.run(&["strength", "a.layup.toml", "--loads", "l.csv"]);
    let expected = "error: a.layup.toml: this is a layup, expected a table with named columns\n  help: name the \
                    table NAME.span.csv that \"section-analyzer blade\" wrote\n";
    assert_eq!((run.code, run.err.as_str()), (2, expected));
}

/// The layer "tip" is there between eta 0.6 and 0.75 only.
#[test]
fn layers_between_stations_are_reported() {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", LAYUP);
    let check = |stations: &str| {
        workplace.run(&["blade", "a.layup.toml", "--check", "--stations", stations])
    };
    let tip = "line 29: layer \"tip\" is there from eta 0.6 to 0.75, and at no station";
    assert_eq!(warnings(&check("0.1,0.5,0.9")), [tip]);
    assert!(warnings(&check("0.1,0.7,0.9")).is_empty());
    // a web, once for all of its plies, and a fill
    let more = "[[web]]\nname = \"rib\"\nat = { x = 0.6 }\neta = [0.62, 0.74]\nplies = [\
                { name = \"fore\", material = \"glass\", thickness = 1 },\
                { name = \"aft\", material = \"glass\", thickness = 1 }]\n\
                [[fill]]\nname = \"core\"\nmaterial = \"lead\"\nahead_of = \"web\"\n\
                eta = [0.61, 0.72]\n[mesh]";
    workplace.write("a.layup.toml", &LAYUP.replace("[mesh]", more));
    let web = "line 42: web \"rib\" is there from eta 0.62 to 0.74, and at no station";
    let fill = "line 47: fill \"core\" is there from eta 0.61 to 0.72, and at no station";
    assert_eq!(warnings(&check("0.1,0.5,0.9")), [tip, web, fill]);
    assert!(warnings(&check("0.1,0.7,0.9")).is_empty());
}

/// Under a shear force the stress beside the foot of a web changes much within cells of 80 mm: the ply is named with
/// the factors of the point and of the mean stress of its cell, the ones of the table. Under an axial force with
/// fibers of one direction in each layer no stress changes much, and there is no such remark.
#[test]
fn factors_that_depend_on_the_cells_are_named() {
    let workplace = solved();
    let words = "Not converged with the mesh: the reserve factor is more than 10 % below the one of the mean stress \
                 of the cell (both in brackets)";
    let run = strength(&workplace, "eta,shear z [N]\n0,900\n1,900\n", &[]);
    assert_eq!(run.code, 0, "{}", run.err);
    println!("{}", run.out);
    assert!(run.out.contains(words), "{}", run.out);
    let line = run
        .out
        .lines()
        .find(|line| line.contains(words))
        .expect("the remark");
    let rows = rows(&workplace, "b/a.strength.csv");
    for part in line.split("ply \"").skip(1) {
        let (ply, rest) = part.split_once("\" (").expect("factors");
        let (factors, _) = rest.split_once(')').expect("factors");
        let (point, cell) = factors.split_once(", ").expect("two factors");
        let [point, cell] = [point, cell].map(|text| text.parse::<f64>().expect("a number"));
        assert!(point < 0.9 * cell, "{part}");
        let is_it = |row: &&Row| {
            row["ply"] == ply && (number(row, "reserve_factor [-]") - point).abs() < 1e-3
        };
        let row = rows.iter().find(is_it).expect("the row of the table");
        assert!(
            (number(row, "reserve_factor_of_cell [-]") - cell).abs() < 1e-3,
            "{part}"
        );
    }
    let run = strength(&workplace, "eta,axial [N]\n0,900\n1,900\n", &[]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(!run.out.contains("Not converged"), "{}", run.out);
}
