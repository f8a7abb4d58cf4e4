//! Sections of curved and twisted beams: their input, and the messages and reports.

use shared_geom::section;

use crate::workplace::{SECTION, TWO_CELLS, Workplace};

/// [`SECTION`] with a table of the undeformed beam, whose first key is on line 22.
fn with(table: &str) -> Workplace {
    let workplace = Workplace::new();
    let text = format!("{SECTION}\n[initial_curvature]\n{table}\n");
    workplace.write("a.section.toml", &text);
    workplace.write("two.msh", TWO_CELLS);
    workplace
}

#[test]
fn wrong_tables_are_reported() {
    with("slope = [1, 0, 0]").is_refused(&[
        "error: a.section.toml:22: [initial_curvature] has no \"curvature\", expected an array of \
         3: twist about x, curvature about y and z",
    ]);
    with("curvature = [1, 0]").is_refused(&[
        "error: a.section.toml:23: \"curvature\" is an array of 2, expected an array of 3, each a \
         curvature (angle per length), as in [\"5 deg/m\", 0, 0]",
    ]);
    with("curvature = 1").is_refused(&[
        "error: a.section.toml:23: \"curvature\" is 1, expected an array of 3, each a curvature \
         (angle per length), as in [\"5 deg/m\", 0, 0]",
    ]);
    with("curvature = [\"1 1/m\", 0, 0]").is_refused(&[
        "error: a.section.toml:23: \"curvature\": \"1/m\" measures a quantity in m^-1, expected a \
         curvature (angle per length)",
        "  help: units of it: deg/m, rad/m; the inverse of a radius in m is in rad/m",
    ]);
    with("curvature = [\"five\", 0, 0]").is_refused(&[
        "error: a.section.toml:23: \"curvature\": \"five\" cannot be read, expected a number \
         and a unit, as in \"5 deg/m\"",
    ]);
    with("curvature = [0, 0, 0]\nslop = [1, 0, 0]").is_refused(&[
        "error: a.section.toml:24: unknown key \"slop\" in [initial_curvature]",
        "  help: did you mean \"slope\"?",
    ]);
    let slope = "expected a direction [x, y, z] whose first number is greater than zero: [1, 0, \
                 0] if the line is normal to the section";
    for wrong in ["[0, 1, 0]", "[-1, 0, 0]", "[0, 0, 0]"] {
        let text = format!("curvature = [0, 0, 0]\nslope = {wrong}");
        let workplace = with(&text);
        let run = workplace.run(&["check", "a.section.toml"]);
        assert_eq!(run.code, 2, "{wrong}");
        let reported = run
            .err
            .starts_with("error: a.section.toml:24: \"slope\" is");
        assert!(reported && run.err.contains(slope), "{}", run.err);
    }
    let both = with("curvature = [1]\nslope = [1, 0]");
    let run = both.run(&["check", "a.section.toml"]);
    assert_eq!(run.err.matches("error:").count(), 2, "{}", run.err);
}

// The section is 2 mm by 1 mm with its origin at the lower left corner: with k3 the least
// J is 1 - 0.002 k3; for 0.6 rad/mm, a plain number, it is -0.2. 1/0.002 rad/m are
// 28647.9 deg/m.
#[test]
fn a_section_that_reaches_its_center_of_curvature_is_refused() {
    with("curvature = [0, 0, \"600 rad/m\"]").is_refused(&[
        "error: a.section.toml:23: the beam is curved by 34377.5 deg/m, and the section reaches \
         its center of curvature: at node 3 of cell 12, (2, 0) in the mesh, J = l1 + k2 z - k3 y \
         is -0.2, expected more than 0 everywhere, which requires less than 28647.9 deg/m",
        "  help: a plain number is in units of 1000 deg/m here: check the unit (as in \"5 \
         deg/m\"; 1/R in 1/m is in \"rad/m\"), the signs (k3 > 0 bends the beam toward +y, k2 > 0 \
         toward -z), and that the origin of the mesh is on the reference line (the farthest node \
         is 2.23607 away)",
    ]);
    // Bent in the opposite direction the fibers are longer everywhere.
    let workplace = with("curvature = [0, 0, \"-600 rad/m\"]");
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(
        run.out
            .contains("  remark: curvature times size is 1.34164: "),
        "{}",
        run.out
    );
}

// Plain numbers are in the declared units, here degrees per millimeter: 0.005 deg/mm are
// 5 deg/m or 0.0872665 rad/m. A slope of any length is a direction.
#[test]
fn the_beam_is_reported_and_written() {
    let workplace = with("curvature = [0.005, 0, \"0.02 rad/m\"]\nslope = [2, 0.2, 0]");
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for words in [
        "\nUndeformed beam, curved or twisted\n",
        "  twist and curvature [1/m]        8.72665e-2           0  2.00000e-2\n",
        "  the same [deg/m]                  5.00000e0           0   1.14592e0\n",
        "  slope of the reference line [-]  9.95037e-1  9.95037e-2           0\n",
        "  stiffness and mass apply to this beam, per length of the reference line\n",
        "\nRestrained warping\n  not given: the beam is curved or twisted; ",
    ] {
        assert!(run.out.contains(words), "{words} is not in\n{}", run.out);
    }
    assert!(!run.out.contains("constants.csv"));
    let file = workplace.path("results/a.properties.json");
    let found = section::read(&file).unwrap().initial_curvature.unwrap();
    assert!((found.curvature.x - 5.0_f64.to_radians()).abs() < 1e-16);
    assert_eq!((found.curvature.y, found.curvature.z), (0.0, 0.02));
    assert!((found.slope.norm() - 1.0).abs() < 1e-15);
    assert!((found.slope.y / found.slope.x - 0.1).abs() < 1e-15);
    // From another point the line has another length: the report states the unit of
    // length of the matrices.
    let shift = [
        "shift",
        "results/a.properties.json",
        "--to",
        "0, 1 m",
        "--out",
        "b.json",
    ];
    let run = workplace.run(&shift);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let moved = section::read(&workplace.path("b.json")).unwrap();
    let slope = moved.initial_curvature.unwrap().slope;
    // l + k x d with d = (0, 0, 1): k x d = (k2, -k1, 0).
    assert!((slope.y - (found.slope.y - found.curvature.x)).abs() < 1e-15);
    let report = workplace.run(&["report", "b.json"]).out;
    let per = "  stiffness and mass apply to this beam, per unit of the parameter by which \
               the line has this slope: 9.95";
    assert!(report.contains(per), "{report}");
}

// A straight beam given by its table is a straight beam: the same results, and it is not
// mentioned.
#[test]
fn no_curvature_is_a_straight_beam() {
    let (straight, plain) = (with("curvature = [0, 0, 0]\nslope = [3, 0, 0]"), with(""));
    plain.write("a.section.toml", SECTION);
    let properties = [straight, plain].map(|workplace| {
        let run = workplace.run(&["analyze", "a.section.toml"]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        assert!(!run.out.contains("Undeformed"), "{}", run.out);
        section::read(&workplace.path("results/a.properties.json")).unwrap()
    });
    let [a, b] = properties;
    assert_eq!(a.stiffness, b.stiffness);
    assert_eq!(a.initial_curvature, None);
}

// A section that was solved from another point is the same section: the line there has
// the slope l + k x d, and both are divided by its length, to be per arc length.
// Tolerance: round-off of a solution with the section a few sizes off the origin, 1e-10.
#[test]
fn the_line_may_be_given_at_another_point() {
    let workplace = with("curvature = [0.5, 0, 1]");
    let far = SECTION.replace("two.msh", "far.msh");
    // The origin 3 mm below: d = (0, 0, -3 mm), k x d = (0, 3 mm k1, 0).
    let mesh = TWO_CELLS
        .replace(" 0 0\n", " 3 0\n")
        .replace(" 1 0\n", " 4 0\n");
    workplace.write("far.msh", &mesh);
    let side = 3.0 * 0.5_f64.to_radians();
    let c = 1.0_f64.hypot(side);
    let table = format!(
        "\n[initial_curvature]\ncurvature = [{}, 0, {}]\nslope = [1, {side}, 0]\n",
        0.5 / c,
        1.0 / c
    );
    workplace.write("b.section.toml", &(far + &table));
    for name in ["a.section.toml", "b.section.toml"] {
        let run = workplace.run(&["analyze", name]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{name}");
    }
    let [a, b] = ["a", "b"].map(|name| {
        let file = workplace.path(&format!("results/{name}.properties.json"));
        section::read(&file).unwrap()
    });
    let back = b.shift([0.0, 0.003].into()).per_arc_length();
    for (found, expected) in [(back.stiffness, a.stiffness), (back.mass, a.mass)] {
        let difference = (found - expected).amax() / expected.amax();
        assert!(difference < 1e-10, "{difference}");
    }
    let [found, given] = [&back, &a].map(|section| section.initial_curvature.unwrap());
    assert!((found.slope - given.slope).amax() < 1e-12, "{found:?}");
    let difference = (found.curvature - given.curvature).norm() / given.curvature.norm();
    assert!(difference < 1e-12, "{difference}");
}
