//! Equilibria over a parameter: against closed forms, and against equilibria one by one.

use beam_dynamics::analysis::static_sweep::static_sweep;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::case::Sweep;
use beam_dynamics::input;
use beam_dynamics::output::sweep_csv;
use beam_dynamics::result::StaticSweep;

use crate::record;

const FILE: &str = "sweep.dynamics.toml";

/// A blade of 2 m with pitch and precone, its root on the axis, and a force f normal to it and a moment
/// m about it at the tip.
const BLADE: &str = "units = \"SI\"\n[parameters]\nf = 0\nm = { of = \"f\", rows = [[-1, -2], [0, 0], \
    [2, 4]] }\npitch = 20\n[properties.p]\nea = 2.8e7\ngay = 9e6\ngaz = 9e6\ngj = 300\neiy = 240\n\
    eiz = 3700\nm = 1\niy = 1e-6\niz = 1e-6\n[[blade]]\nname = \"b\"\nproperties = \"p\"\nprecone = 3\n\
    pitch = \"= pitch\"\npiece = [{ length = 2, elements = 4 }]\n[[load]]\nnode = \"b/tip\"\n\
    axes = \"node\"\nforce = [0, 0, \"= f\"]\nmoment = [\"= m/100\", 0, 0]\n[static]\n";

/// The sweep of a text.
fn swept(text: &str) -> StaticSweep {
    let input = input::parse(text, FILE).unwrap_or_else(|problems| panic!("{problems}"));
    let sweep = input.statics.unwrap().sweep.unwrap();
    let read = |given: &[(String, f64)]| input::parse_with(text, FILE, given);
    static_sweep("sweep", &sweep, &read, &mut |_| {})
}

// F L^3 / 3 EI + F L / GA and M L / GJ, in the axes of the pitched blade. The squares of the slopes,
// 1e-5, are neglected.
#[test]
fn tips_are_in_the_axes_of_the_pitched_blade() {
    let text = format!("{BLADE}[static.sweep]\nparameter = \"f\"\n");
    let sweep = swept(&text);
    // Without values: the rows of the table over the parameter.
    let values: Vec<_> = sweep.points.iter().map(|point| point.at).collect();
    assert_eq!(values, [-1.0, 0.0, 2.0]);
    assert_eq!(sweep.varying(), ["m"]);
    for point in &sweep.points {
        assert_eq!(point.failure, None);
        let (f, tip) = (point.at, &point.tips[0]);
        let flap = f * (8.0 / (3.0 * 240.0) + 2.0 / 9e6);
        let twist = 0.02 * f * 2.0 / 300.0;
        let close = |found: f64, expected: f64| (found - expected).abs() < 2e-6 * f.abs() + 1e-12;
        assert!(close(tip.flap, flap), "{tip:?} {flap}");
        assert!((tip.twist - twist).abs() < 1e-6, "{tip:?} {twist}");
        assert!(tip.edge.abs() < 1e-6 * f.abs() + 1e-15, "{tip:?}");
        // The blade gets shorter by 3/5 of the square of the deflection over its length, of which the sine
        // of the cone is along the axis.
        let cone = 3f64.to_radians();
        let shorter = 0.6 * flap * flap / 2.0 * cone.sin();
        let along = flap * 20f64.to_radians().cos() * cone.cos() - shorter;
        assert!(close(tip.along_axis, along), "{tip:?} {along}");
    }
    let table = sweep_csv(&sweep);
    let first = table.lines().next().unwrap();
    let expected = "f,m,b_tip_along_axis [m],b_tip_flap [m],b_tip_edge [m],b_tip_twist [deg],\
                    iterations,residual [-],status";
    assert_eq!(first, expected);
}

#[test]
fn a_value_without_a_model_leaves_the_others() {
    // The table of m ends at 2.
    let text = format!("{BLADE}[static.sweep]\nparameter = \"f\"\nvalues = [1, 3, 2]\n");
    let sweep = swept(&text);
    let failed: Vec<_> = sweep
        .points
        .iter()
        .map(|point| point.failure.is_some())
        .collect();
    assert_eq!(failed, [false, true, false]);
    let [reason, _] = sweep.points[1].failure.as_ref().unwrap();
    assert!(reason.contains("expected a value from -1 to 2"), "{reason}");
    assert_eq!(sweep.found(), 2);
    let table = sweep_csv(&sweep);
    let row = table.lines().nth(2).unwrap();
    assert_eq!(row, "3,,,,,,,,not found");
}

#[test]
fn wrong_sweeps_are_reported() {
    for (sweep, expected) in [
        ("parameter = \"g\"", "\"g\" is not one of the [parameters]"),
        (
            "parameter = \"pitch\"",
            "the values of the sweep are given by nothing",
        ),
        ("parameter = \"f\"\nvalues = []", "an empty list"),
        ("values = [1, 2]", "has no \"parameter\""),
    ] {
        let text = format!("{BLADE}[static.sweep]\n{sweep}\n");
        let problems = input::parse(&text, FILE).unwrap_err().to_string();
        assert!(problems.contains(expected), "{problems}");
    }
}

/// The case by its own file: power, thrust and tips of the sweep are the ones of equilibria from rest, to
/// the round-off of the iterations; the powers are the ones of HAWCStab2 within 3 %.
#[test]
fn the_iea15_rotor_over_the_wind() {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/dynamics/iea15_steady/iea15_steady.dynamics.toml"
    );
    let read = |given: &[(String, f64)]| input::read_with(file.as_ref(), given);
    let sweep = read(&[]).unwrap().statics.unwrap().sweep.unwrap();
    assert_eq!(sweep.values.len(), 12);
    let few = Sweep {
        values: vec![7.0, 11.0, 15.0, 25.0],
        ..sweep
    };
    let found = static_sweep("IEA 15 MW", &few, &read, &mut |_| {});
    let published = [4654.279, 15663.83, 15666.72, 15662.42];
    for (point, published) in found.points.iter().zip(published) {
        assert_eq!(point.failure, None);
        let power = 1e-3 * point.rotors[0].1.power();
        let error = (power / published - 1.0).abs();
        let case = format!("IEA 15 MW by one sweep, {} m/s", point.at);
        record::value(
            "HAWCStab2",
            &case,
            "power [kW]",
            [power, published],
            error,
            0.03,
        );
        assert!(error < 0.03, "{case}: {power} {published}");
    }
    // The last point, from rest.
    let input = read(&[("wind".to_owned(), 25.0)]).unwrap();
    let alone = statics(&input.model, input.statics.as_ref().unwrap());
    let alone = alone.result.steps[0].positions.iter();
    let last = found.points[3].path.as_ref().unwrap().steps[0]
        .positions
        .iter();
    let apart = alone
        .zip(last)
        .map(|(a, b)| (a - b).norm())
        .fold(0.0, f64::max);
    assert!(apart < 1e-6, "{apart}");
}
