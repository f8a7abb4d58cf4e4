//! `prestress` in the section file, in reports and in property files.

use shared_geom::section::{self, StrainMeasure};

use crate::workplace::Workplace;

/// Requests the table, with a load.
fn prestressed(measure: &str) -> Workplace {
    let load =
        format!("mesh = \"two.msh\"\nprestress = \"{measure}\"\n\n[load.pull]\naxial = \"4 kN\"\n");
    Workplace::with(&[("mesh = \"two.msh\"\n", &load)], &[])
}

#[test]
fn the_table_is_in_the_report_and_in_the_property_file() {
    for measure in StrainMeasure::ALL {
        let workplace = prestressed(measure.name());
        let run = workplace.run(&["analyze", "a.section.toml"]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let head = format!(
            "\nPrestress, third derivatives T of the energy by strain ({} strain)\n  T1",
            measure.name()
        );
        for expected in [
            head.as_str(),
            "\n  (per axial force at the tension center torsion gains ",
            "\nPrestress, change of the stiffness per moment of torsion [1/m, -, m]\n",
            "\nPrestress, change of the stiffness per moment of bending z [1/m, -, m]\n",
            "\nStiffness under load \"pull\", to first order [N, N m, N m^2]\n",
        ] {
            assert!(run.out.contains(expected), "{expected}\n{}", run.out);
        }
        let file = workplace.path("results/a.properties.json");
        let properties = section::read(&file).unwrap();
        assert_eq!(properties.prestress.unwrap().strain_measure, measure);
        // the report of the file has the same table, and no loads
        let report = workplace.run(&["report", "results/a.properties.json"]);
        let from = |text: &str| {
            let part = &text[text.find("Prestress").unwrap()..];
            part.split("\nStiffness")
                .next()
                .unwrap()
                .trim_end()
                .to_owned()
        };
        assert_eq!(from(&report.out), from(&run.out));
    }
}

#[test]
fn without_the_request_nothing_changes() {
    let workplace = Workplace::with(&[], &[]);
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!(run.code, 0);
    assert!(!run.out.contains("Prestress"));
    let text = workplace.read("results/a.properties.json");
    assert!(text.contains("\"version\": 1,") && !text.contains("prestress"));
}

#[test]
fn an_unknown_measure_is_reported() {
    let run = prestressed("biott").run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.err,
        "error: a.section.toml:2: \"prestress\" is \"biott\", expected one of \"biot\", \
         \"green\"\n  help: did you mean \"biot\"?\n"
    );
}

#[test]
fn curved_beams_are_refused() {
    let workplace = prestressed("biot");
    let text = workplace.read("a.section.toml");
    let curved = format!("{text}\n[initial_curvature]\ncurvature = [\"5 deg/m\", 0, 0]\n");
    workplace.write("a.section.toml", &curved);
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.err,
        "error: a.section.toml:2: \"prestress\": the effect of prestress is known for straight \
         beams only, and this one has an initial curvature\n  help: remove \"prestress\" or \
         [initial_curvature]\n"
    );
}

#[test]
fn oblique_lines_are_refused_by_their_name() {
    let workplace = prestressed("biot");
    let text = workplace.read("a.section.toml");
    let lines = "[initial_curvature]\ncurvature = [0, 0, 0]\nslope = [1, 0.1, 0]\n";
    workplace.write("a.section.toml", &format!("{text}\n{lines}"));
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.err,
        "error: a.section.toml:2: \"prestress\": the effect of prestress is known for beams whose \
         line is normal to the section only, and the slope of this one is oblique\n  help: remove \
         \"prestress\" or [initial_curvature]\n"
    );
}

/// Moved, rotated and moved back: equal to round-off; another measure of strain is not
/// compared.
#[test]
fn the_table_is_moved_and_compared() {
    let workplace = prestressed("biot");
    assert_eq!(workplace.run(&["analyze", "a.section.toml"]).code, 0);
    let moved = ["--to", "3 mm, -2 mm", "--out", "b.json"];
    let file = "results/a.properties.json";
    assert_eq!(
        workplace.run(&[&["shift", file], &moved[..]].concat()).code,
        0
    );
    let turned = ["rotate", "b.json", "--angle", "30 deg", "--out", "c.json"];
    assert_eq!(workplace.run(&turned).code, 0);
    let run = workplace.run(&["compare", file, "c.json", "--tolerance", "1e-9"]);
    assert_eq!(run.code, 0, "{}", run.out);
    let run = workplace.run(&["compare", file, "b.json", "--as-given"]);
    assert!(run.out.contains("prestress 146"), "{}", run.out);

    let mut green = section::read(&workplace.path("b.json")).unwrap();
    let mut prestress = green.prestress.unwrap();
    prestress.strain_measure = StrainMeasure::Green;
    green.prestress = Some(prestress);
    workplace.write("d.json", &section::write(&green));
    let run = workplace.run(&["compare", "b.json", "d.json"]);
    let words =
        "the prestress of A uses the strain of biot, the prestress of B the strain of green";
    assert!(run.code == 1 && run.out.contains(words), "{}", run.out);
}

/// A load with an initial strain has the stiffness of its stresses; for a distributed
/// load the report states the neglected part.
#[test]
fn what_a_load_imposes_is_in_its_stiffness() {
    let workplace = prestressed("biot");
    let text = workplace.read("a.section.toml");
    let more = "\n[initial_strain.cure]\n[[initial_strain.cure.region]]\ngroup = \"skin\"\n\
        strain = [1e-3, 0, 0, 0, 0, 0]\n\
        [load.cured]\naxial = \"4 kN\"\ninitial_strain = \"cure\"\n\
        [load.pressed]\naxial = \"4 kN\"\n\
        [[load.pressed.traction]]\ncurve = \"edge\"\npressure = \"1 kPa\"\n";
    workplace.write("a.section.toml", &format!("{text}{more}"));
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    println!("{}", &run.out[run.out.find("Prestress").unwrap()..]);
    let under = |name: &str| {
        let head = format!("Stiffness under load \"{name}\", to first order [N, N m, N m^2]\n");
        let rest = &run.out[run.out.find(&head).unwrap() + head.len()..];
        rest.split("\n\n").next().unwrap().to_owned()
    };
    let [pull, cured, pressed] = ["pull", "cured", "pressed"].map(under);
    assert!(
        cured.contains("  (with the effect of \"cure\" on the section)"),
        "{cured}"
    );
    assert_ne!(pull.lines().nth(1), cured.lines().nth(1));
    assert!(pressed.contains("  (of the load along the beam only the internal force is included"));
    assert!(pressed.starts_with(pull.trim_end()), "{pull} {pressed}");
    let title = "Prestress, change of the stiffness by the imposed state \"cure\", without internal \
        force [N, N m, N m^2]\n";
    assert!(run.out.contains(title), "{}", run.out);
    let file = workplace.path("results/a.properties.json");
    let properties = section::read(&file).unwrap();
    let change = properties.change_by_imposed(&["cure".to_owned()]).unwrap();
    assert!(change[(3, 3)] != 0.0 && properties.imposed[0].stiffness_change.is_some());
}
