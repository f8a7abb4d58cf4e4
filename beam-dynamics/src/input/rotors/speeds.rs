//! Speeds of rotors: their sense, and agreement with the speeds of other cards.

use shared_geom::document::Document;

use super::PlacedRotor;
use super::problem::RotorProblem;
use crate::input::analyses::Analyses;
use crate::input::rotor_speed::{RPM, SAME_SPEED, rpm};
use crate::input::schema::DYNAMICS_FILE;
use crate::input::short_number;

/// Digits of speeds.
const DIGITS: usize = 6;

/// Notes rotors that turn against their airfoils or their free wheel, or that have two speeds, and ones
/// that turn but in the equilibrium of a trim.
pub(super) fn check(document: &Document, rotors: &[PlacedRotor], analyses: &Analyses) {
    let root = document.root_of(&DYNAMICS_FILE);
    let trim = root.is_table("trim").then(|| root.table("trim")).flatten();
    let is_timeless = analyses.trimmed_equilibrium().is_some();
    let lacks_speed = is_timeless && trim.is_some_and(|trim| !trim.has("speed"));
    for rotor in rotors {
        let name = rotor.name.clone();
        let backward = rotor.speed.filter(|speed| *speed < 0.0);
        let given = rotor.initial.zip(rotor.turning);
        let turning = rotor.speed.filter(|speed| lacks_speed && *speed != 0.0);
        let problem = match (backward, given, turning) {
            (Some(speed), ..) if rotor.has_air => RotorProblem::Backward { name, speed },
            (Some(speed), ..) if rotor.has_free_wheel => RotorProblem::Overrun { name, speed },
            (_, Some((own, turning)), _) if differ(own, turning) => {
                let speeds = [own, turning];
                RotorProblem::Angle { name, speeds }
            }
            (.., Some(speed)) => RotorProblem::Still { name, speed },
            _ => continue,
        };
        document.note(rotor.line, &problem);
    }
}

fn differ(a: f64, b: f64) -> bool {
    (a - b).abs() > SAME_SPEED * a.abs().max(b.abs())
}

/// A card with its lowest and highest speed \[rad/s\].
type Card = (&'static str, [f64; 2]);

/// Remarks on rotors whose speed is another one in analyses without time or for a governor.
pub(super) fn remarks(rotors: &[PlacedRotor], analyses: &Analyses) -> Vec<String> {
    let cards = analyses.without_time();
    let of_rotor = |rotor: &PlacedRotor| {
        let own = cards.iter().filter_map(|card| of_card(rotor, *card));
        own.chain(of_governor(rotor)).collect::<Vec<_>>()
    };
    rotors.iter().flat_map(of_rotor).collect()
}

/// A remark on a rotor at a speed that is not one of a card.
fn of_card(rotor: &PlacedRotor, (card, [low, high]): Card) -> Option<String> {
    let own = rotor.speed.filter(|own| *own != 0.0)?;
    let is_between = low <= own.abs() && own.abs() <= high;
    if is_between || !differ(low, own.abs()) || !differ(high, own.abs()) {
        return None;
    }
    let (name, own) = (&rotor.name, rpm(own));
    if high == 0.0 {
        return Some(format!(
            "rotor \"{name}\" turns at {own}, but {card} has the model at rest, as at the time zero; \
             [periodic] has a rotor that turns on a support that does not, with the damping and the \
             frequencies of its motion in [periodic.floquet] and [stability]"
        ));
    }
    let speeds = if low == high {
        rpm(low)
    } else {
        format!("{} to {}", short_number(low / RPM, DIGITS), rpm(high))
    };
    Some(format!(
        "rotor \"{name}\" turns at {own}, but {card} has {speeds}: there the model turns at the speed \
         of {card}"
    ))
}

/// A remark on a start at another speed than the one of the governor.
fn of_governor(rotor: &PlacedRotor) -> Option<String> {
    let (start, required) = rotor.initial.zip(rotor.governed)?;
    differ(start, required).then(|| {
        format!(
            "rotor \"{}\" starts at {}, and its governor requires {}",
            rotor.name,
            rpm(start),
            rpm(required)
        )
    })
}
