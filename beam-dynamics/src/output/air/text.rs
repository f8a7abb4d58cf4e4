//! Thrust, torque and power of rotors as text for a report.

use crate::elements::{AirState, Definition, RotorAir, RotorQuantity};
use crate::input::short_number;
use crate::output::text::{RPM, aligned};

/// Digits of quantities.
const DIGITS: usize = 6;
/// Names of the definitions.
const DEFINITIONS: [(&str, Definition); 3] = [
    ("rotor", Definition::Rotor),
    ("wind", Definition::Wind),
    ("propeller", Definition::Propeller),
];
/// Quantities of one definition: name, definition, quantity.
const OTHERS: [(&str, Definition, RotorQuantity); 5] = [
    (
        "figure of merit",
        Definition::Rotor,
        RotorQuantity::FigureOfMerit,
    ),
    (
        "edgewise advance ratio",
        Definition::Rotor,
        RotorQuantity::AdvanceRatio,
    ),
    (
        "tip speed ratio",
        Definition::Wind,
        RotorQuantity::TipSpeedRatio,
    ),
    (
        "propeller advance ratio",
        Definition::Propeller,
        RotorQuantity::AdvanceRatio,
    ),
    (
        "propeller efficiency",
        Definition::Propeller,
        RotorQuantity::Efficiency,
    ),
];

/// Sums and coefficients of each rotor; values that are not finite are left out.
pub(in crate::output) fn rotor_text(states: &[AirState]) -> String {
    let mut text = String::new();
    for (name, rotor) in RotorAir::all(states) {
        text.push_str(&format!("\nAir on \"{name}\"\n\n"));
        text.push_str(&sums(&rotor));
        text.push_str(&format!("\n{}", coefficients(&rotor)));
    }
    text
}

fn short(value: f64) -> String {
    if value.is_finite() {
        short_number(value, DIGITS)
    } else {
        "-".to_owned()
    }
}

/// Whether a definition suits a rotor: the one of wind turbines if the air drives it, else the others.
fn suits(definition: Definition, rotor: &RotorAir) -> bool {
    (definition == Definition::Wind) == (rotor.power() > 0.0)
}

/// Thrust, torque, power and speeds.
fn sums(rotor: &RotorAir) -> String {
    let rows = [
        ("thrust [N]", rotor.thrust),
        ("torque [N m]", rotor.torque),
        ("power [W]", rotor.power()),
        ("speed [rpm]", rotor.turning * RPM),
        ("climb [m/s]", rotor.climb),
        ("radius [m]", rotor.radius),
    ];
    let others = OTHERS.iter().filter(|other| suits(other.1, rotor));
    let others = others.map(|(name, definition, of)| (*name, rotor.value(*of, *definition)));
    let others = others.filter(|(_, value)| value.is_finite() && *value != 0.0);
    let rows = rows.into_iter().chain(others);
    let rows: Vec<_> = rows
        .map(|(name, value)| vec![name.to_owned(), short(value)])
        .collect();
    aligned(&rows)
}

/// Coefficients by the definitions that suit the rotor and have finite ones.
fn coefficients(rotor: &RotorAir) -> String {
    let mut rows = vec![["definition", "CT", "CQ", "CP"].map(str::to_owned).to_vec()];
    for (name, definition) in DEFINITIONS {
        let found = rotor.coefficients(definition);
        let is_finite = found.iter().all(|value| value.is_finite());
        if suits(definition, rotor) && is_finite {
            let mut row = vec![name.to_owned()];
            row.extend(found.map(short));
            rows.push(row);
        }
    }
    match rows.len() {
        1 => String::new(),
        _ => aligned(&rows),
    }
}
