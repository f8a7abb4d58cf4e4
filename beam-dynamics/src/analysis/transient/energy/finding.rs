//! Unexplained gain of energy, as text: time, amount, location, and cause.

use super::EnergyWatch;
use crate::case::{Model, TransientSettings};
use crate::elements::{Element, Queries};
use crate::integrator::Scheme;

/// Radius above which a scheme hardly damps unresolved motion.
const HARDLY_DAMPS: f64 = 0.95;
/// Input of energy up to this part of its growth is round-off [-].
const NO_INPUT: f64 = 1e-9;

/// Unexplained gain of energy.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis::transient) struct Finding {
    /// Time, amount and location, as text.
    pub words: String,
    /// The likely cause, as text.
    pub cause: &'static str,
    /// Remedies, the most likely first.
    pub remedies: Vec<&'static str>,
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let remedies = self.remedies.join("; or ");
        let Self { words, cause, .. } = self;
        write!(f, "{words}; likely cause: {cause}: {remedies}")
    }
}

/// A number of four digits, with a power of ten if it is far from one.
fn short(value: f64) -> String {
    let rounded = format!("{value:.3e}");
    match value.abs() {
        1e-4..1e6 => rounded
            .parse()
            .map_or(rounded, |value: f64| value.to_string()),
        _ => rounded,
    }
}

/// The part of a growth of energy that is input, as text; round-off is none [J].
fn of_input(input: f64, growth: f64) -> String {
    if input.abs() > NO_INPUT * growth.abs() {
        format!("of which {} J are", short(input))
    } else {
        "none of which is".to_owned()
    }
}

/// Elements that belong together.
struct Group<'a> {
    name: &'a str,
    elements: Vec<&'a dyn Element>,
    /// Growth of their energy [J].
    growth: f64,
}

/// The blade of an element by its label, or the label itself.
fn group_of<'a>(model: &Model, label: &'a str) -> &'a str {
    let blade = label.split_once('/').map(|(blade, _)| blade);
    let is_blade = |name: &&str| model.blades.iter().any(|blade| blade.name == *name);
    blade.filter(is_blade).unwrap_or(label)
}

impl Group<'_> {
    fn words(&self, model: &Model) -> String {
        let has_beams = self.elements.iter().any(|one| one.joins_nodes());
        let is_blade = model.blades.iter().any(|blade| blade.name == self.name);
        match (is_blade, has_beams) {
            (true, true) => format!("the beams of blade \"{}\"", self.name),
            (true, false) => format!("blade \"{}\"", self.name),
            (false, true) => format!("beam \"{}\"", self.name),
            (false, false) => format!("\"{}\"", self.name),
        }
    }
}

/// Whether a scheme damps motion that its steps do not resolve.
pub(super) fn damps(scheme: Scheme) -> bool {
    match scheme {
        Scheme::CrankNicolson | Scheme::CubicGauss => false,
        Scheme::TwoStep { radius } | Scheme::Cubic { radius } => radius <= HARDLY_DAMPS,
        Scheme::Parabolic { zeta } => zeta < -0.5,
        Scheme::ImplicitEuler | Scheme::Bdf2 => true,
    }
}

/// The likely cause of a gain, and remedies.
fn cause(
    group: Option<&Group<'_>>,
    scheme: Scheme,
    [turns_far, has_kinks]: [bool; 2],
) -> (&'static str, Vec<&'static str>) {
    let makes_energy = |one: &&dyn Element| !one.keeps_energy();
    if group.is_some_and(|group| group.elements.iter().any(makes_energy)) {
        return (
            "beams of the finite-volume formulation have high modes with negative damping, which \
             steps this short resolve",
            vec!["use formulation = \"variational\""],
        );
    }
    if !damps(scheme) {
        let cause = if turns_far {
            "this scheme has no damping, and nodes turn too far in its steps"
        } else {
            "this scheme has no damping, and motion that the steps do not resolve gains energy"
        };
        return (
            cause,
            vec![
                "use scheme = \"two-step\" with the radius 0.6",
                "take shorter steps",
            ],
        );
    }
    if turns_far {
        return (
            "steps in which nodes turn too far",
            vec!["take shorter steps"],
        );
    }
    if has_kinks {
        return (
            "steps too long for the fastest motion, or for a law that jumps or has a kink, as a \
             contact has",
            vec!["take shorter steps", "smooth the law"],
        );
    }
    (
        "steps too long for the fastest motion",
        vec!["take shorter steps"],
    )
}

impl EnergyWatch {
    /// The finding to be reported, if any; `turns_far` if a node turned far in a step.
    pub fn finding(
        &self,
        model: &Model,
        settings: &TransientSettings,
        turns_far: bool,
    ) -> Option<Finding> {
        let since = self.since.filter(|_| self.is_found)?;
        let mut groups: Vec<Group<'_>> = Vec::new();
        let energies = self.start.iter().zip(&self.then);
        for (element, (start, then)) in model.system.elements().zip(energies) {
            let growth = then.total() - start.total();
            // Balances of nodes have none.
            if growth == 0.0 {
                continue;
            }
            let name = group_of(model, element.label());
            match groups.iter_mut().find(|group| group.name == name) {
                Some(group) => {
                    group.elements.push(element);
                    group.growth += growth;
                }
                None => groups.push(Group {
                    name,
                    elements: vec![element],
                    growth,
                }),
            }
        }
        let most = groups.iter().max_by(|a, b| a.growth.total_cmp(&b.growth));
        let (cause, remedies) = cause(most, settings.scheme, [turns_far, model.has_kinks()]);
        let index = most.map_or_else(String::new, |group| {
            format!("; most of it is in {}", group.words(model))
        });
        let balance = self.largest.balance;
        let words = format!(
            "from t = {} s on the energy grows by more than the input: until {} s by {} J, {} the \
             input by loads and drives{index}",
            short(since),
            short(self.largest.time),
            short(balance.growth),
            of_input(balance.put_in, balance.growth)
        );
        Some(Finding {
            words,
            cause,
            remedies,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_off_is_no_input() {
        assert_eq!(of_input(0.5, 2.0), "of which 0.5 J are");
        assert_eq!(of_input(-0.5, 2.0), "of which -0.5 J are");
        for none in [0.0, 1e-12, -1e-12] {
            assert_eq!(of_input(none, 2.0), "none of which is");
        }
    }
}
