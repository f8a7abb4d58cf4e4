//! Readings and tables of the air of elastic blades.

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::elements::{RotorAir, RotorSum};
use beam_dynamics::input;
use beam_dynamics::result::{AcceptedStep, ColumnValues, Recorder};

use crate::record;

/// A rotor of three elastic blades in climb, without gravity.
const ROTOR: &str = r#"
name = "climb"
units = "SI"
[properties.p]
ea = 7e8
gay = 9e7
gaz = 9e7
gj = 8e4
eiy = 2e4
eiz = 7e5
m = 4
iy = 0.01
iz = 0.03
[air]
density = 1.225
wind = [0, 0, -5]
[[inflow]]
name = "lift"
[[blade]]
name = "b"
count = 3
hub_radius = 0.4
precone = 3
pitch = 7
properties = "p"
piece = [{ length = 4, elements = 4 }]
[blade.aerodynamics]
inflow = "lift"
section = "quasi_steady"
stations = [
  { at = 0, chord = 0.35, twist = 6, airfoil = "naca0012" },
  { at = 4, chord = 0.25, airfoil = "naca0012" },
]
"#;

fn read(cards: &str) -> Result<input::Input, String> {
    let found = input::parse(&format!("{ROTOR}{cards}"), "climb.dynamics.toml");
    found.map_err(|problems| problems.to_string())
}

/// Centrifugal forces are radial: along the axis and about it the reactions balance the air.
/// Newton's iteration ends at a residual of 1e-12 of the largest force, the centrifugal one, which
/// is some hundred times the thrust.
#[test]
fn thrust_and_torque_are_the_reactions_of_the_hub() {
    let input = read("[static]\nspeed = 400\n").unwrap();
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let step = &outcome.result.steps[0];
    let rotor = RotorAir::of(&step.air).unwrap();
    let (mut force, mut moment) = (0.0, 0.0);
    for reaction in &step.reactions {
        let at = step.positions[reaction.node];
        force -= reaction.force.z;
        moment -= reaction.moment.z + at.cross(&reaction.force).z;
    }
    for (name, found, expected) in [
        ("thrust [N]", rotor.thrust, force),
        ("torque [N m]", rotor.torque, moment),
    ] {
        let error = (found / expected - 1.0).abs();
        let source = "reactions of the hub";
        let case = "three elastic blades in climb";
        record::value(source, case, name, [found, expected], error, 1e-9);
        assert!(error < 1e-9, "{name}: {found} {expected}");
    }
    assert!(rotor.thrust > 100.0 && rotor.torque < -10.0, "{rotor:?}");
    assert!((rotor.turning * 30.0 / std::f64::consts::PI - 400.0).abs() < 1e-9);
    assert!((rotor.climb - 5.0).abs() < 1e-12);
    let sum: f64 = step
        .air
        .iter()
        .map(|strip| RotorSum::Thrust.share(strip))
        .sum();
    assert_eq!(sum, rotor.thrust);
    assert_eq!(step.air.len(), 3 * 8);
}

/// Records the columns of a run.
struct Columns<'a> {
    values: ColumnValues<'a>,
    rows: Vec<Vec<f64>>,
}

impl Recorder for Columns<'_> {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        let mut row = vec![0.0; self.values.columns().len()];
        self.values.evaluate(accepted, &mut row);
        self.rows.push(row);
        true
    }
}

/// The columns of a run at each step.
pub fn rows(input: input::Input) -> Vec<Vec<f64>> {
    let mut columns = Columns {
        values: ColumnValues::new(&input.model, &input.output),
        rows: Vec::new(),
    };
    let settings = input.transient.unwrap();
    let outcome = transient(&input.model, &settings, None, &mut columns, &|| 0.0);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    columns.rows
}

/// Sensors of thrust, torque and an angle of attack have the values of the columns at every step of a run in which the
/// blades, clamped at rest, are bent by a wind; a position between two strips is interpolated.
#[test]
fn sensors_and_columns_in_time() {
    let cards = r#"
[transient]
to = 0.05
step = 0.001
[sensors.T]
quantity = "thrust"
[sensors.Q]
quantity = "torque"
of = "lift"
[sensors.A]
quantity = "angle_of_attack"
of = "b 1"
at = 0.4
unit = "deg"
[output]
column = [
  { name = "t", quantity = "thrust" },
  { name = "q", quantity = "torque" },
  { name = "t_sensed", quantity = "signal", of = "T" },
  { name = "q_sensed", quantity = "signal", of = "Q" },
  { name = "a3", quantity = "angle_of_attack", of = "b 1", strip = 3 },
  { name = "a4", quantity = "angle_of_attack", of = "b 1", strip = 4 },
  { name = "a", quantity = "angle_of_attack", of = "b 1", at = 0.4 },
  { name = "a_sensed", quantity = "signal", of = "A" },
  { name = "ct", quantity = "thrust_coefficient", definition = "wind" },
]
"#;
    let rows = rows(read(cards).unwrap());
    assert!(rows.len() > 50);
    for row in &rows {
        let [t, q, sensed_t, sensed_q, a3, a4, a, sensed_a, ct] = row[..] else {
            panic!("nine columns")
        };
        assert!(
            t.abs() > 1.0 && (sensed_t - t).abs() < 1e-7 * t.abs(),
            "{t} {sensed_t}"
        );
        assert!(
            (sensed_q - q).abs() < 1e-7 * q.abs().max(1.0),
            "{q} {sensed_q}"
        );
        assert!(
            (a - sensed_a).abs() < 1e-6 * a.abs().max(1.0),
            "{a} {sensed_a}"
        );
        assert!((a - a3) * (a - a4) <= 1e-12, "{a3} {a} {a4}");
        assert!(ct.is_finite());
    }
}

#[test]
fn wrong_names_and_positions_are_reported() {
    for (column, expected) in [
        (
            "quantity = \"mach\", of = \"b 1\", strip = 9",
            "\"strip\" is 9, expected 1 to 8",
        ),
        (
            "quantity = \"mach\", of = \"b 1\", at = 0.001",
            "between the first and the last strip of \"b 1\"",
        ),
        (
            "quantity = \"mach\", of = \"b 1\"",
            "expected one of \"at\" and \"strip\", found none",
        ),
        (
            "quantity = \"mach\", of = \"c\", strip = 1",
            "\"c\" has no strips",
        ),
        (
            "quantity = \"thrust\", of = \"left\"",
            "\"left\" is not a rotor in the air",
        ),
        (
            "quantity = \"efficiency\", definition = \"wind\"",
            "the definition \"wind\" has no \"efficiency\"",
        ),
    ] {
        let cards = format!(
            "[transient]\nto = 1\nstep = 0.1\n[output]\ncolumn = [{{ name = \"x\", {column} }}]\n"
        );
        let shown = read(&cards).unwrap_err();
        assert!(shown.contains(expected), "{shown}");
        assert!(shown.contains("climb.dynamics.toml:"), "{shown}");
    }
    let sensor = "[sensors.a]\nquantity = \"tangential_load\"\nof = \"b 1\"\nstrip = 1\n";
    let shown = read(sensor).unwrap_err();
    assert!(
        shown.contains("\"tangential_load\" cannot be sensed"),
        "{shown}"
    );
    let shown = read("[sensors.a]\nquantity = \"power_coefficient\"\n").unwrap_err();
    assert!(
        shown.contains("\"power_coefficient\" cannot be sensed"),
        "{shown}"
    );
}
