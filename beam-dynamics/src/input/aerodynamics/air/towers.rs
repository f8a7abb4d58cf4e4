//! Influence of towers on the wind: `[[air.tower]]`.

use nalgebra::Vector3;
use rotor_aero::wind::{Tower, TowerPotential, TowerShadow, WindFrame};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{NotNegative, Positive, Quantities, Vector, Word};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::AirProblem;

keys! {
    /// A vertical tower that changes the wind around it.
    pub(super) CARD = "[[air.tower]]";
    /// A point of its axis.
    FOOT: Option<Vector3<f64>> = "foot", [Vector(3, Dimension::LENGTH)], or "`ground` of the wind",
        "[5, 0, 0]";
    /// Heights above the ground, ascending.
    HEIGHTS: Vec<f64> = "heights", [Quantities(Dimension::LENGTH)], required, "[0, 87.6]";
    /// Diameters at these heights; linear between them.
    DIAMETERS: Vec<f64> = "diameters", [Quantities(Dimension::LENGTH)], required, "[6, 3.87]";
    /// Coefficient of drag, of the shadow and of the correction by Bak.
    DRAG: Option<f64> = "drag", [NotNegative(Dimension::NUMBER)], optional, "0.5";
    /// Flow upwind and beside it.
    POTENTIAL: usize = "potential", [Word(&["none", "cylinder", "Bak"])], or "\"cylinder\"" = 1,
        "\"Bak\"";
    /// Deficit downwind.
    SHADOW: usize = "shadow", [Word(&["none", "Powles", "Eames"])], or "\"none\"" = 0,
        "\"Powles\"";
    /// Turbulence intensity around the tower, of the shadow by Eames.
    INTENSITY: Option<f64> = "intensity", [Positive(Dimension::NUMBER)], optional, "0.1";
}

/// Reads every `[[air.tower]]`; `None` if one is wrong. Without a frame, only the keys are
/// checked.
pub(super) fn read(tables: &[Table<'_>], frame: Option<&WindFrame>) -> Option<Vec<Tower>> {
    let read = tables.iter().map(|table| tower(table, frame));
    let towers: Vec<_> = read.collect();
    towers.into_iter().collect()
}

fn tower(table: &Table<'_>, frame: Option<&WindFrame>) -> Option<Tower> {
    let foot = table.get(&FOOT);
    let (heights, diameters) = (table.get(&HEIGHTS), table.get(&DIAMETERS));
    let (potential, shadow) = (table.get(&POTENTIAL), table.get(&SHADOW));
    let (drag, intensity) = (table.get(&DRAG), table.get(&INTENSITY));
    table.finish();
    let (heights, diameters) = (heights?, diameters?);
    if heights.len() != diameters.len() {
        let problem = AirProblem::Value {
            key: DIAMETERS.name(),
            found: format!("a list of {}", diameters.len()),
            expected: format!("{}, one for each height", heights.len()),
            help: "give a diameter for each height",
        };
        table.note(&DIAMETERS, &problem);
        return None;
    }
    let models = (potential?, shadow?);
    let (intensity, drag) = (intensity?, drag?);
    let is_complete = is_complete(table, models, (drag, intensity));
    let (potential, shadow) = models;
    let frame = frame.filter(|_| is_complete)?;
    let foot = foot?.map_or([0.0; 3], |foot| frame.point(&foot.into()));
    let halves = heights.iter().zip(&diameters);
    let tower = Tower::new(
        [foot[0], foot[1]],
        halves
            .map(|(height, diameter)| [*height, 0.5 * diameter])
            .collect(),
        drag.unwrap_or(0.0),
        [
            TowerPotential::None,
            TowerPotential::Cylinder,
            TowerPotential::Bak,
        ][potential],
        match (shadow, intensity) {
            (2, Some(intensity)) => TowerShadow::Eames { intensity },
            (0, _) => TowerShadow::None,
            _ => TowerShadow::Powles,
        },
    );
    match tower {
        Ok(tower) => Some(tower),
        Err(problems) => {
            for problem in &problems {
                table.note(&HEIGHTS, problem);
            }
            None
        }
    }
}

/// Whether a tower has the numbers that its potential and its shadow need; absent ones are noted.
fn is_complete(
    table: &Table<'_>,
    (potential, shadow): (usize, usize),
    (drag, intensity): (Option<f64>, Option<f64>),
) -> bool {
    let mut is_complete = true;
    for (key, is_missing, user) in [
        (
            DRAG.name(),
            drag.is_none() && (potential == 2 || shadow != 0),
            "a shadow or the correction by Bak",
        ),
        (
            INTENSITY.name(),
            intensity.is_none() && shadow == 2,
            "the shadow by Eames",
        ),
    ] {
        if is_missing {
            table.note(key, &AirProblem::Missing { key, user });
            is_complete = false;
        }
    }
    is_complete
}
