//! Finds redundant constraints before a run; reports or removes them.

use std::cmp::Ordering;

use super::failure::{TransientFailure, listed};
use super::placing::{beside, own_rates, place, position_values};
use crate::assembly::redundancy::{self, Redundant};
use crate::assembly::{Sharing, Slack, Sparse, System};
use crate::case::{self, Model, TransientSettings};
use crate::integrator::Stepping;
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, State};

/// Number of directions in which constraints are checked away from the first position.
const DIRECTIONS: usize = 2;
/// Violation of a constraint, relative to the size of the model, above which it is not redundant
/// away from the first position: positions are found to 1e-10, and at a hundredth of the size a
/// dependence of second order gives about 1e-4.
const BROKEN_BESIDE: f64 = 1e-8;
/// The same during a run, where constraints are fulfilled to the tolerance of its steps.
const BROKEN: f64 = 1e-4;
/// Contradiction of drives during a run, as a part of the fastest drive of the loop, that is not an
/// error of the steps.
const UNLIKE: f64 = 1e-5;
/// Rates below this are errors of differences \[m/s or rad/s\].
const STILL: f64 = 1e-8;
/// Number of redundant constraints of a net of loops from which on the cost of sharing their loads
/// is reported.
const MANY: usize = 100;

/// The model in which redundant constraints share their loads with the constraints from which they
/// follow; `None` if all are independent.
///
/// They are determined at the positions of the undeformed nodes after initialization. If the
/// constraints cannot be fulfilled, initialization reports it.
pub(in crate::analysis) fn independent(
    model: &Model,
    settings: &TransientSettings,
) -> Result<Option<Shared>, TransientFailure> {
    let system = &model.system;
    if system.numbering().multipliers() == 0 {
        return Ok(None);
    }
    let conditions = model.conditions_at(settings.from);
    let Ok(placed) = place(system, &system.rest(), &conditions, &model.initial) else {
        return Ok(None);
    };
    let found = redundancy::find(system, &placed, &conditions);
    if found.is_empty() {
        return Ok(None);
    }
    let rates = own_rates(system, &placed, &conditions);
    let contradicting = found.iter().filter_map(|found| {
        let off = found.contradiction(&rates)?;
        Some(found.contradicting(off))
    });
    let contradicting: Vec<_> = contradicting.collect();
    if !contradicting.is_empty() {
        return Err(TransientFailure::Contradicting {
            constraints: listed(&contradicting),
            time: settings.from,
        });
    }
    let constraints: Vec<_> = found.iter().map(|found| found.constraint).collect();
    let reduced = Model {
        system: system.without(&constraints),
        ..model.clone()
    };
    let broken = broken_beside(system, &reduced, (&placed, &conditions), &found);
    if !broken.is_empty() {
        return Err(TransientFailure::SingularPosition(listed(&broken)));
    }
    if settings.redundant == case::Redundant::Error {
        return Err(TransientFailure::Redundant(found));
    }
    let compliance = compliance(system, &placed, &conditions, settings);
    Ok(Some(Shared {
        model: Model {
            system: system.with_shared_loads(&found, compliance),
            ..model.clone()
        },
        redundant: found,
    }))
}

/// A model in which redundant constraints share loads.
pub(in crate::analysis) struct Shared {
    /// The model.
    pub model: Model,
    /// The redundant constraints.
    pub redundant: Vec<Redundant>,
}

impl Shared {
    /// The findings, as text.
    pub fn remarks(&self) -> impl Iterator<Item = String> {
        let found = self.redundant.iter();
        let found = found.map(|found| format!("{found}: they share its load"));
        let loops = self.model.system.redundant_of_loops();
        let large = loops.filter(|(count, _)| *count > MANY);
        let large = large.map(|(count, joint)| {
            format!(
                "{count} constraints of the net of closed loops with \"{joint}\" follow from \
                 others: the cost of a step grows with the cube of their number; use joints that \
                 constrain each direction once (spherical, cylindrical or in-line instead of \
                 revolute) for the cost of open chains"
            )
        });
        found.chain(large)
    }
}

/// Displacement of the largest mass per unit force in a step, or else of the largest stiffness
/// \[m/N\].
fn compliance(
    system: &System,
    placed: &State,
    conditions: &Conditions,
    settings: &TransientSettings,
) -> f64 {
    let step = match settings.stepping {
        Stepping::Constant { step } => step,
        Stepping::Variable(control) => control.first,
    };
    let nodes = NODE_UNKNOWNS * placed.nodes.len();
    let tangent = system.tangent(placed, conditions);
    let largest = |matrix: &Sparse, equation: Equation| {
        let entries = matrix.triplets().filter(|&(row, column, _)| {
            let row_of_node = row % NODE_UNKNOWNS;
            let is_of = (equation.row()..equation.row() + 3).contains(&row_of_node);
            row < nodes && column < nodes && is_of && column % NODE_UNKNOWNS < 3
        });
        entries.map(|entry| entry.2.abs()).fold(0.0, f64::max)
    };
    let mass = largest(&tangent.by_rates, Equation::Momentum);
    let stiffness = largest(&tangent.by_unknowns, Equation::Force);
    match (mass > 0.0, stiffness > 0.0) {
        (true, _) => step * step / mass,
        (false, true) => 1.0 / stiffness,
        (false, false) => 1.0,
    }
}

/// The constraints of `found`, as text, that are violated near `placed`, where all others are
/// fulfilled: they are redundant only at this position.
fn broken_beside(
    system: &System,
    reduced: &Model,
    (placed, conditions): (&State, &Conditions),
    found: &[Redundant],
) -> Vec<String> {
    let beside = (0..DIRECTIONS).filter_map(|direction| {
        let moved = beside(&reduced.system, placed, conditions, direction)?;
        place(&reduced.system, &moved, conditions, &reduced.initial).ok()
    });
    let mut broken = vec![false; found.len()];
    for state in beside {
        let off = position_values(system, &state, conditions);
        let limit = BROKEN_BESIDE * system.size();
        for (broken, found) in broken.iter_mut().zip(found) {
            *broken |= off[found.constraint].abs() > limit;
        }
    }
    let pairs = found.iter().zip(broken);
    pairs
        .filter(|pair| pair.1)
        .map(|pair| pair.0.to_string())
        .collect()
}

/// Whether a constraint with this violation is no longer redundant.
pub(super) fn is_broken(slack: &Slack) -> bool {
    !matches!(slack.part.abs().partial_cmp(&BROKEN), Some(Ordering::Less))
}

/// The constraints of `found`, as text, whose drives contradict the constraints from which they
/// follow, at a state of a run and its conditions.
pub(super) fn contradicting(
    system: &System,
    found: &[Redundant],
    (state, conditions): (&State, &Conditions),
) -> Option<String> {
    if found.is_empty() {
        return None;
    }
    let rates = own_rates(system, state, conditions);
    let driven: Vec<_> = found.iter().filter(|one| one.is_driven(&rates)).collect();
    if driven.is_empty() {
        return None;
    }
    let mut sharing = Sharing::new(system, state, conditions);
    let off: Vec<_> = sharing.contradictions(&rates).collect();
    let reported = driven.into_iter().filter_map(|found| {
        let mut off = off.iter();
        let off = off.find(|off| off.constraint == found.constraint)?;
        let counts = off.value > UNLIKE * off.size && off.value > STILL;
        counts.then(|| found.contradicting(off.value))
    });
    let reported: Vec<_> = reported.collect();
    (!reported.is_empty()).then(|| listed(&reported))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "test helpers")]

    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::analysis::transient::{TransientOutcome, transient};
    use crate::elements::Element;
    use crate::elements::bodies::{RigidBody, RigidInertia};
    use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, axes_along};
    use crate::model::Node;
    use crate::result::{AcceptedStep, Recorder};

    /// Keeps the last position of the node.
    struct Last(Vector3<f64>);

    impl Recorder for Last {
        fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
            self.0 = accepted.state.nodes[0].position;
            true
        }
    }

    /// A door that swings about z under gravity along -y, on hinges at the given heights; its
    /// position after a second.
    fn swing(hinges: &[f64], redundant: case::Redundant) -> (TransientOutcome, Vector3<f64>) {
        let door = Node {
            label: "door".to_owned(),
            position: Vector3::new(0.5, 0.0, 1.0),
            rotation: Matrix3::identity(),
        };
        let inertia = Matrix3::from_diagonal(&Vector3::new(0.3, 0.4, 0.1));
        let inertia = RigidInertia::about_node(1.0, &Vector3::zeros(), &inertia);
        let mut elements: Vec<Box<dyn Element>> =
            vec![Box::new(RigidBody::new("door", 0, inertia))];
        for height in hinges {
            let ends = JointEnds {
                a: None,
                b: (0, &door),
            };
            let at = Vector3::new(0.0, 0.0, *height);
            let at = Placing::at(&at, &axes_along(&Vector3::z()));
            let label = format!("hinge at {height}");
            let hinge = ConstraintJoint::revolute(label, &ends, &at, None);
            elements.push(Box::new(hinge));
        }
        let mut model = Model::new("door", System::new(vec![door], elements));
        model.gravity = Vector3::new(0.0, -9.81, 0.0);
        let settings = TransientSettings {
            redundant,
            ..TransientSettings::new(1.0, 0.01)
        };
        let mut last = Last(Vector3::zeros());
        let outcome = transient(&model, &settings, None, &mut last, &|| 0.0);
        (outcome, last.0)
    }

    // The other hinge does not change the motion of the door: the same numbers to the tolerance of
    // the iteration, 1e-9 a step at most, over 100 steps.
    #[test]
    fn a_door_on_two_hinges_swings_as_on_one() {
        let (refused, _) = swing(&[0.2, 1.8], case::Redundant::Error);
        let failure = refused.failure.unwrap();
        let shown = failure.to_string();
        let expected = "redundant constraints: constraint 1 (along z) of \"hinge at 1.8\" follows \
            from \"hinge at 0.2\"; constraint 2 ";
        assert!(shown.starts_with(expected), "{shown}");
        assert!(failure.remedy().contains("redundant = \"remove\""));
        let (removed, two) = swing(&[0.2, 1.8], case::Redundant::Remove);
        assert!(removed.failure.is_none(), "{:?}", removed.failure);
        assert_eq!(removed.remarks.len(), 5, "{:?}", removed.remarks);
        let (single, one) = swing(&[0.2], case::Redundant::Error);
        assert!(single.failure.is_none(), "{:?}", single.failure);
        assert!((one - two).amax() < 1e-7, "{one} {two}");
        // It has swung to the other side, on its circle.
        assert!(
            (one.xy().norm() - 0.5).abs() < 1e-9 && one.x < -0.4,
            "{one}"
        );
    }
}
