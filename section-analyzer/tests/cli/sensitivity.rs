//! `analyze --sensitivity`: the file, the table, and refused requests.

use crate::workplace::Workplace;

const FILE: &str = "results/a.sensitivity.json";

/// One of the two cells is a ply, so that there are angles.
fn workplace() -> Workplace {
    let ply = "[material.ply]\ne1 = 140\ne2 = 9\ne3 = 9\ng12 = 5\ng13 = 5\ng23 = 3\n\
               nu12 = 0.3\nnu13 = 0.3\nnu23 = 0.4\ndensity = \"1600 kg/m^3\"\n\n[[region]]\n\
               group = \"skin\"\nmaterial = \"ply\"\nfiber_angle = 20\n";
    let steel = "[[region]]\ngroup = \"skin\"\nmaterial = \"steel\"\n";
    Workplace::with(&[(steel, ply)], &[])
}

fn json(workplace: &Workplace) -> serde_json::Value {
    serde_json::from_str(&workplace.read(FILE)).unwrap()
}

#[test]
fn the_file_has_all_constants_and_angles() {
    let workplace = workplace();
    let run = workplace.run(&["analyze", "a.section.toml", "--sensitivity"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.contains(&format!("\n  {FILE}\n")), "{}", run.out);
    let file = json(&workplace);
    let parameters = file["parameters"].as_array().unwrap();
    let names: Vec<_> = parameters
        .iter()
        .map(|parameter| parameter["name"].as_str().unwrap())
        .collect();
    let ply = [
        "e1", "e2", "e3", "g12", "g13", "g23", "nu12", "nu13", "nu23", "density",
    ];
    let mut expected: Vec<_> = ply.iter().map(|name| format!("{name} of ply")).collect();
    let steel = ["young", "poisson", "density"];
    expected.extend(steel.iter().map(|name| format!("{name} of steel")));
    expected.extend(["fiber angle of skin", "plane angle of skin"].map(str::to_owned));
    let sorted = |mut list: Vec<String>| {
        list.sort();
        list
    };
    let found = names.iter().map(|&name| name.to_owned()).collect();
    assert_eq!(sorted(found), sorted(expected));

    let of = |name: &str| {
        let at = names.iter().position(|&known| known == name).unwrap();
        &parameters[at]
    };
    // a cell of 1 mm by 1 mm about (1.5, 0.5) mm adds its own area to the mass
    let density = of("density of steel");
    let mass = density["mass"][0][0].as_f64().unwrap();
    assert!((mass / 1e-6 - 1.0).abs() < 1e-12, "{mass}");
    assert_eq!(density["value"].as_f64(), Some(7850.0));
    assert_eq!(density["unit"], "kg/m^3");
    let angle = of("fiber angle of skin");
    let value = angle["value"].as_f64().unwrap();
    assert!((value - 20f64.to_radians()).abs() < 1e-15);
    // all moduli together scale the stiffness: K = sum p dK/dp
    let sum: f64 = parameters
        .iter()
        .filter(|parameter| parameter["unit"] == "Pa")
        .map(|p| p["value"].as_f64().unwrap() * p["stiffness"][0][0].as_f64().unwrap())
        .sum();
    let properties: serde_json::Value =
        serde_json::from_str(&workplace.read("results/a.properties.json")).unwrap();
    let stiffness = properties["stiffness"][0][0].as_f64().unwrap();
    assert!((sum / stiffness - 1.0).abs() < 1e-10, "{sum} {stiffness}");
}

#[test]
fn the_table_is_in_the_report() {
    let workplace = workplace();
    let run = workplace.run(&["analyze", "a.section.toml", "--sensitivity"]);
    let report = workplace.read("results/a.report.txt");
    assert!(run.out.starts_with(&report));
    assert!(
        report.contains("\nSensitivities: change by 1 %"),
        "{report}"
    );
    let line = |name: &str| {
        let found = report.lines().find(|line| line.contains(name));
        found
            .unwrap_or_else(|| panic!("{name}: {report}"))
            .to_owned()
    };
    // densities do not change the stiffness
    let words: Vec<_> = line("density of steel")
        .split_whitespace()
        .map(str::to_owned)
        .collect();
    assert_eq!(words[3..9], ["0", "0", "0", "0", "0", "0"]);
    assert!(words[9].parse::<f64>().unwrap() > 0.1);
}

#[test]
fn nodes_are_parameters_where_requested() {
    let workplace = workplace();
    let run = workplace.run(&[
        "analyze",
        "a.section.toml",
        "--sensitivity",
        "--sensitivity-nodes",
        "3,6",
    ]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let file = json(&workplace);
    let parameters = file["parameters"].as_array().unwrap();
    let last: Vec<_> = parameters[parameters.len() - 4..]
        .iter()
        .map(|parameter| parameter["name"].as_str().unwrap())
        .collect();
    assert_eq!(
        last,
        ["y of node 3", "z of node 3", "y of node 6", "z of node 6"]
    );
    // moving the right side out by 1 m adds 1 m times its height of steel
    let mass: f64 = [0, 2]
        .map(|i| {
            parameters[parameters.len() - 4 + i]["mass"][0][0]
                .as_f64()
                .unwrap()
        })
        .iter()
        .sum();
    assert!((mass / (7850.0 * 1e-3) - 1.0).abs() < 1e-10, "{mass}");
}

/// A constant of zero has its own row; torsion and bending do not depend on the position
/// of the origin; a section without mass has no mass center.
#[test]
fn the_table_is_about_the_centers() {
    let zero = (
        "poisson = 0.3\ndensity = \"7850 kg/m^3\"",
        "poisson = 0\ndensity = 0",
    );
    let row = |workplace: &Workplace, name: &str, part: usize| -> Vec<String> {
        let run = workplace.run(&["analyze", "a.section.toml", "--sensitivity"]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let report = workplace.read("results/a.report.txt");
        let lines: Vec<_> = report.lines().filter(|line| line.contains(name)).collect();
        let words = lines[part].split_whitespace().skip(3);
        words.map(str::to_owned).collect()
    };
    let near = Workplace::with(&[zero], &[]);
    let poisson = row(&near, "poisson of steel", 0);
    assert!(
        poisson[3].parse::<f64>().unwrap().abs() > 1e-3,
        "{poisson:?}"
    );
    assert_eq!(row(&near, "poisson of steel", 1)[4..], ["-", "-"]);
    assert_eq!(row(&near, "poisson of steel", 0)[6], "-");

    // the same section 1 m away
    let nodes = [
        ("1 0 0 0\n2 1 0 0", "1 1000 0 0\n2 1001 0 0"),
        ("3 2 0 0", "3 1002 0 0"),
        ("4 0 1 0\n5 1 1 0", "4 1000 1 0\n5 1001 1 0"),
        ("6 2 1 0", "6 1002 1 0"),
    ];
    let far = Workplace::with(&[zero], &nodes);
    for (near, far) in poisson.iter().zip(row(&far, "poisson of steel", 0)).take(6) {
        let [near, far] = [near, &far].map(|text| text.parse::<f64>().unwrap());
        assert!(
            (near - far).abs() < 2e-3 * near.abs() + 1e-6,
            "{near} {far}"
        );
    }
}

/// The file belongs to the run that requested it.
#[test]
fn a_run_without_the_option_removes_the_file() {
    let workplace = workplace();
    let requested = ["analyze", "a.section.toml", "--sensitivity"];
    workplace.run(&requested);
    assert!(
        workplace
            .run(&requested)
            .out
            .contains("Unchanged since the last run")
    );
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert!(!run.out.contains("Unchanged"), "{}", run.out);
    assert!(!run.out.contains("Sensitivities"));
    assert!(!workplace.path(FILE).exists());
    let removed = format!("\nRemoved: results of an earlier run\n  {FILE}\n");
    assert!(run.out.ends_with(&removed), "{}", run.out);
    let run = workplace.run(&["analyze", "a.section.toml", "--force"]);
    assert!(!run.out.contains("Removed"), "{}", run.out);
    assert!(!workplace.run(&requested).out.contains("Unchanged"));
    assert!(workplace.path(FILE).exists());
}

#[test]
fn nodes_that_are_not_there() {
    let workplace = workplace();
    let run = workplace.run(&[
        "analyze",
        "a.section.toml",
        "--sensitivity",
        "--sensitivity-nodes",
        "1,9,77",
    ]);
    let expected = "\
error: a.section.toml: --sensitivity-nodes 9: the mesh \"two.msh\" has no node 9
  help: the nearest number in the file is 6
error: a.section.toml: --sensitivity-nodes 77: the mesh \"two.msh\" has no node 77
  help: the nearest number in the file is 6
";
    assert_eq!((run.code, run.err.as_str()), (2, expected));
    assert!(!workplace.path("results").exists());

    let run = workplace.run(&["analyze", "a.section.toml", "--sensitivity-nodes", "1"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("--sensitivity"), "{}", run.err);
    let rest = ["--sensitivity", "--sensitivity-nodes", "one"];
    let run = workplace.run(&[&["analyze", "a.section.toml"][..], &rest].concat());
    assert_eq!(run.code, 2);
    assert!(run.err.contains("'one'"), "{}", run.err);
    for wrong in ["-1", "1.5"] {
        let rest = ["--sensitivity", "--sensitivity-nodes", wrong];
        let run = workplace.run(&[&["analyze", "a.section.toml"][..], &rest].concat());
        assert_eq!(run.code, 2);
        assert!(run.err.contains("separated by commas"), "{}", run.err);
    }
    let rest = ["--sensitivity", "--sensitivity-nodes", "1, 3"];
    let run = workplace.run(&[&["analyze", "a.section.toml"][..], &rest].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
}
