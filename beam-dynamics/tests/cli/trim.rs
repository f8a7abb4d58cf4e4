//! `trim`: files, reports and exit codes.

use crate::Folder;

/// A mass on a spring of 900 N/m that a force pulls, with a parameter.
fn model(trim: &str) -> String {
    format!(
        "units = \"SI\"\n[parameters]\nplace = 1.5\n\
         [[node]]\nname = \"mass\"\nposition = [1, 0, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
         [[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"mass\"]\naxis = [1, 0, 0]\n\
         [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [900, 0, 0]\n\
         [sensors.x]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"x\"\n\
         [[load]]\nnode = \"mass\"\nforce = [1, 0, 0]\ndrive = \"= pull\"\n{trim}"
    )
}

const TRIM: &str = "[trim]\nmethod = \"equilibrium\"\n\
    [[trim.control]]\nname = \"pull\"\nguess = 10\nscale = 100\nupper = 1000\n\
    [[trim.target]]\nname = \"place of the mass\"\nsignal = \"x\"\nvalue = \"= place\"\n";

#[test]
fn controls_of_a_sweep() {
    let folder = Folder::new();
    let sweep = "[trim.sweep]\nparameter = \"place\"\nfrom = 1\nto = 2\nsteps = 5\n";
    folder.write("mass.dynamics.toml", &model(&format!("{TRIM}{sweep}")));
    let run = folder.run(&["trim", "mass.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    for words in ["at 5 of 5 points", "mass.trim.csv", "mass.trim.svg"] {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
    let table = folder.read("results/mass.trim.csv");
    for (k, row) in table.lines().skip(1).enumerate() {
        let number = |column: usize| row.split(',').nth(column).unwrap().parse::<f64>().unwrap();
        // F = k (x - 1), to the residual of the equilibrium.
        assert!((number(1) - 225.0 * k as f64).abs() < 1e-5, "{table}");
    }
    assert_eq!(table.lines().count(), 6);
    // A mass beyond the reach of the force ends the sweep and keeps the points before.
    let far = sweep.replace("to = 2", "to = 3");
    folder.write("mass.dynamics.toml", &model(&format!("{TRIM}{far}")));
    let run = folder.run(&["trim", "mass.dynamics.toml"]);
    assert_eq!(run.code, 1, "{}", run.err);
    for words in [
        "mass at place = 2.5",
        "beyond its bound 1000",
        "help: move the bound",
    ] {
        assert!(run.err.contains(words), "{words}: {}", run.err);
    }
    assert!(run.out.contains("at 3 of 5 points"), "{}", run.out);
    assert_eq!(folder.read("results/mass.trim.csv").lines().count(), 5);
}

/// The points of the results, by their parameter, status and control.
fn points(folder: &Folder) -> Vec<(Option<f64>, String, Option<f64>)> {
    let file = folder.read("results/mass.trim.json");
    let file: serde_json::Value = serde_json::from_str(&file).unwrap();
    assert_eq!(file["format"], "helicoid trim");
    let points = file["points"].as_array().unwrap().iter();
    let point = |point: &serde_json::Value| {
        let status = point["status"].as_str().unwrap().to_owned();
        (
            point["at"].as_f64(),
            status,
            point["controls"]["pull"].as_f64(),
        )
    };
    points.map(point).collect()
}

// F = k (x - 1), to the residual of the equilibrium.
#[test]
fn results_for_other_programs() {
    let folder = Folder::new();
    folder.write("mass.dynamics.toml", &model(TRIM));
    let run = folder.run(&["trim", "mass.dynamics.toml", "--json"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("mass.trim.json"), "{}", run.out);
    let found = points(&folder);
    let [(None, status, Some(pull))] = found.as_slice() else {
        panic!("{found:?}");
    };
    assert_eq!(status, "met");
    assert!((pull - 450.0).abs() < 1e-5, "{pull}");
    // A sweep whose last point is beyond the bound of the force.
    let sweep = "[trim.sweep]\nparameter = \"place\"\nvalues = [1.5, 2, 3]\n";
    folder.write("mass.dynamics.toml", &model(&format!("{TRIM}{sweep}")));
    let run = folder.run(&["trim", "mass.dynamics.toml", "--json"]);
    assert_eq!(run.code, 1, "{}", run.err);
    let found = points(&folder);
    let named: Vec<_> = found.iter().map(|one| (one.0, one.1.as_str())).collect();
    let expected = [(1.5, "met"), (2.0, "met"), (3.0, "not met")];
    assert_eq!(named, expected.map(|(at, status)| (Some(at), status)));
    // Without the option the file is removed.
    folder.run(&["trim", "mass.dynamics.toml"]);
    assert!(!folder.path("results/mass.trim.json").exists());
}

/// 100 N move the mass by 1/9 m, to half a meter less than required: the reached value is shown, and
/// no harmonics of a motion that does not meet the targets.
#[test]
fn a_failed_trim_shows_the_values_that_are_reached() {
    let folder = Folder::new();
    let trim = TRIM
        .replace(
            "[trim]\nmethod = \"equilibrium\"\n",
            "[periodic]\nperiod = 1\nsteps = 8\n[trim]\n",
        )
        .replace("upper = 1000", "upper = 100");
    let output = "[output]\ncolumn = [{ name = \"x\", quantity = \"signal\", of = \"x\" }]\n";
    folder.write("mass.dynamics.toml", &model(&format!("{trim}{output}")));
    let run = folder.run(&["trim", "mass.dynamics.toml"]);
    assert_eq!(run.code, 1, "{}", run.err);
    assert!(
        run.err.contains("\"pull\" reaches its bound 100"),
        "{}",
        run.err
    );
    for words in [
        "place of the mass = 1.1",
        ", required 1.5",
        "the targets are not met",
    ] {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
    assert!(!folder.path("results/mass.harmonics.csv").exists());
    // The report has the reason and the remedy of the terminal.
    let report = folder.read("results/mass.trim.txt");
    for words in [
        "error: the control \"pull\" reaches its bound 100",
        "  help: move",
    ] {
        assert!(report.contains(words), "{words}: {report}");
    }
    let sound = trim.replace("upper = 100", "upper = 1000");
    folder.write("mass.dynamics.toml", &model(&format!("{sound}{output}")));
    let run = folder.run(&["trim", "mass.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(folder.path("results/mass.harmonics.csv").exists());
}

#[test]
fn a_single_trim_and_wrong_files() {
    let folder = Folder::new();
    folder.write("mass.dynamics.toml", &model(TRIM));
    let run = folder.run(&["trim", "mass.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("pull = 450"), "{}", run.out);
    assert!(run.out.contains("the targets are met"), "{}", run.out);
    folder.write("without.dynamics.toml", &model("").replace("= pull", "= 1"));
    let run = folder.run(&["trim", "without.dynamics.toml"]);
    assert_eq!(run.code, 2, "{}", run.err);
    assert!(run.err.contains("[[trim.control]]"), "{}", run.err);
    let wrong = model(&TRIM.replace("signal = \"x\"", "signal = \"y\""));
    folder.write("wrong.dynamics.toml", &wrong);
    let run = folder.run(&["trim", "wrong.dynamics.toml"]);
    assert_eq!(run.code, 2, "{}", run.err);
    assert!(run.err.contains("wrong.dynamics.toml:"), "{}", run.err);
}

/// A rigid rotor in the air, whose collective pitch is found for a thrust.
const ROTOR: &str = "\
units = \"SI\"
[air]
density = 1.2
[airfoils.lin]
slope = 5.7
drag = 0.01
[properties.b]
ea = 1e9
gay = 1e8
gaz = 1e8
gj = 1e7
eiy = 1e5
eiz = 1e7
m = 5
iy = 1e-5
iz = 1e-5
[[rotor]]
name = \"m\"
hub = \"rigid\"
center = [0, 0, 0]
blades = 3
speed = 350
[rotor.blade]
hub_radius = 0.3
properties = \"b\"
piece = [{ length = 5, elements = 3 }]
[rotor.blade.aerodynamics]
section = \"quasi_steady\"
stations = [
  { at = 0, chord = 0.25, twist = 0, airfoil = \"lin\" },
  { at = 5, chord = 0.25, twist = 0, airfoil = \"lin\" },
]
[rotor.swashplate]
collective = \"collective\"
[sensors.thrust]
quantity = \"thrust\"
[periodic]
speed = 350
steps = 24
[trim]
[[trim.control]]
name = \"collective\"
guess = 6
[[trim.target]]
name = \"T\"
signal = \"thrust\"
value = 10000
scale = 1e4
";

/// The trim by shooting does not depend on the state from which its first period begins: one collective
/// pitch, to the tolerance of Newton's method.
#[test]
fn trims_begin_from_given_and_rotating_starts() {
    let folder = Folder::new();
    let pitch = |start: &str| {
        let text = ROTOR.replace("steps = 24\n", &format!("steps = 24\n{start}"));
        folder.write("a.dynamics.toml", &text);
        let run = folder.run(&["trim", "a.dynamics.toml", "--no-figures"]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
        let table = folder.read("results/a.trim.csv");
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        let titles = reader.headers().unwrap().clone();
        let column = titles
            .iter()
            .position(|title| title.starts_with("collective"));
        let row = reader.records().next().unwrap().unwrap();
        row[column.unwrap()].parse::<f64>().unwrap()
    };
    let expected = pitch("");
    // Blade elements without induced velocity and compression: T = rho a c 3 theta int (Omega r)^2 dr / 2.
    let turns = 350.0 * std::f64::consts::PI / 30.0;
    let cube = (5.3f64.powi(3) - 0.3f64.powi(3)) / 3.0;
    let rigid = 1e4 / (0.5 * 1.2 * 5.7 * 0.25 * 3.0 * turns * turns * cube);
    assert!(
        (expected / rigid.to_degrees() - 1.0).abs() < 0.05,
        "{expected}"
    );
    let found = pitch("start = \"rotating\"\n");
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
}
