//! Size of a model.

use nalgebra::DMatrix;

use super::System;
use crate::elements::{Element, LocalJacobian, Queries};
use crate::model::{Equation, NODE_UNKNOWNS, Variable};

/// Offsets below this fraction of the radius of gyration are round-off.
const ROUND_OFF: f64 = 1e-12;

/// Lengths known from the elements.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Lengths {
    /// The longest arm or distance [m].
    arm: f64,
    /// The largest radius of gyration about a node [m].
    gyration: f64,
}

impl Lengths {
    /// Includes the lengths of an element with the derivatives `jacobian` in the undeformed model.
    pub fn add(&mut self, element: &dyn Element, jacobian: &LocalJacobian) {
        let longer = |known: f64, own: f64| {
            if own.is_finite() {
                known.max(own)
            } else {
                known
            }
        };
        self.arm = longer(self.arm, element.reach());
        for node in 0..element.nodes().len() {
            let [offset, gyration] = of_mass(jacobian.by_rates(), NODE_UNKNOWNS * node);
            self.gyration = longer(self.gyration, gyration);
            if offset > ROUND_OFF * gyration {
                self.arm = longer(self.arm, offset);
            }
        }
    }
}

/// First moment over mass, and radius of gyration, of the mass that an element adds to a node whose
/// unknowns begin at `first` \[m\]; zero without mass.
fn of_mass(by_rates: &DMatrix<f64>, first: usize) -> [f64; 2] {
    let block = |row: Equation, column: Variable| {
        let index = (first + row.row(), first + column.column());
        by_rates.fixed_view::<3, 3>(index.0, index.1).amax()
    };
    let mass = block(Equation::Momentum, Variable::Position);
    if mass == 0.0 {
        return [0.0; 2];
    }
    let moment = block(Equation::Momentum, Variable::Rotation);
    let inertia = block(Equation::AngularMomentum, Variable::Rotation);
    [moment / mass, (inertia / mass).sqrt()]
}

impl System {
    /// Size of the model, the reference of displacements and the scale of rotations: the largest
    /// distance of an undeformed node from the first, or the longest arm of a joint, a spring, a
    /// load or an eccentric mass. If there is none, the size is the largest radius of gyration, and
    /// one meter for points without arms \[m\].
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The same, with the known lengths of the elements.
    pub(super) fn size_with(&self, lengths: &Lengths) -> f64 {
        let indices = || self.nodes.iter().map(|node| node.position);
        let first = indices().next().unwrap_or_default();
        let apart = indices().map(|index| (index - first).norm());
        let farthest = indices().map(|index| index.amax()).fold(0.0, f64::max);
        let size = apart.fold(lengths.arm, f64::max);
        // Less is round-off of the positions.
        match size > 4.0 * f64::EPSILON * farthest {
            true => size,
            false if lengths.gyration > 0.0 => lengths.gyration,
            false => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::elements::bodies::{RigidBody, RigidInertia};
    use crate::model::Node;

    fn of(positions: &[[f64; 3]], bodies: &[(f64, [f64; 3], f64)]) -> f64 {
        let nodes = positions.iter().map(|point| Node {
            label: String::new(),
            position: Vector3::from(*point),
            rotation: Matrix3::identity(),
        });
        let bodies = bodies.iter().map(|(mass, offset, inertia)| {
            let central = *inertia * Matrix3::identity();
            let inertia = RigidInertia::about_node(*mass, &Vector3::from(*offset), &central);
            let body: Box<dyn Element> = Box::new(RigidBody::new("body", 0, inertia));
            body
        });
        System::new(nodes.collect(), bodies.collect()).size()
    }

    // 3, 4, 12 and 13; nodes in one position, exactly and with the round-off of a position far
    // away.
    #[test]
    fn a_model_is_as_large_as_its_nodes_are_apart() {
        let far = [[7.0, 0.0, 0.0], [10.0, 4.0, 12.0], [8.0, 1.0, 0.0]];
        assert!((of(&far, &[]) - 13.0).abs() < 1e-14);
        assert_eq!(of(&[], &[]), 1.0);
        assert_eq!(of(&[[2.0, 1.0, 0.0]], &[]), 1.0);
        assert_eq!(of(&[[1e8, 0.0, 0.0], [1e8 + 1.5e-8, 0.0, 0.0]], &[]), 1.0);
        let apart = of(&[[1e8, 0.0, 0.0], [1e8, 2.0, 0.0]], &[]);
        assert!((apart - 2.0).abs() < 1e-14);
    }

    // A mass of 2 kg, 3 mm off in y; one with 8 kg m^2, whose radius of gyration is 2 m, and the
    // two together: an arm has priority over a radius of gyration.
    #[test]
    fn one_node_is_as_large_as_its_mass_is_eccentric_or_extended() {
        let position = [[5.0, 0.0, 0.0]];
        let eccentric = (2.0, [0.0, 3e-3, 0.0], 0.0);
        assert!((of(&position, &[eccentric]) - 3e-3).abs() < 1e-15);
        let extended = (2.0, [0.0; 3], 8.0);
        assert!((of(&position, &[extended]) - 2.0).abs() < 1e-14);
        assert!((of(&position, &[eccentric, extended]) - 3e-3).abs() < 1e-15);
        assert_eq!(of(&position, &[(2.0, [0.0; 3], 0.0)]), 1.0);
    }
}
