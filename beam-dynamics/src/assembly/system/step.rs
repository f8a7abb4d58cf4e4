//! Residual and Jacobian of a system for time integration, without allocation.

use super::layout::{Buffers, Gathered, Part, Within, Workspace};
use super::parts::{Sums, Task};
use super::{Residual, System};
use crate::assembly::{Combination, Variation};
use crate::elements::{Local, LocalJacobian, Queries};
use crate::model::{Conditions, Scalars, State};

impl System {
    /// Buffers for [`Self::residual_into`] and [`Self::combine`], which sum large systems on all
    /// threads of rayon.
    pub fn workspace(&self) -> Workspace {
        Workspace::of(self)
    }

    /// Writes the residual at a state to `out`, which is resized to the system.
    pub fn residual_into(
        &self,
        state: &State,
        conditions: &Conditions,
        out: &mut Residual,
        work: &mut Workspace,
    ) {
        self.clear(out);
        let task = Task {
            at: (state, conditions),
            derivatives: None,
        };
        self.sum(&task, &mut [], Some(out), work);
    }

    fn clear(&self, out: &mut Residual) {
        for sums in [&mut out.values, &mut out.sizes] {
            sums.clear();
            sums.resize(self.numbering.unknowns(), 0.0);
        }
    }

    /// Sums of the derivatives at a state, by the unknowns of a formula, and the residual if it is
    /// requested: the nodes move by `variations`, one per node. With G and W of [`Variation`],
    ///
    /// ```text
    /// F_theta theta + F_omega d omega = (F_theta G + F_omega W) du + F_omega G du'   (D-130)
    /// ```
    pub fn combine(
        &self,
        state: &State,
        conditions: &Conditions,
        variations: &[Variation],
        (out, residual): (&mut [Combination<'_>], Option<&mut Residual>),
        work: &mut Workspace,
    ) {
        let task = Task {
            at: (state, conditions),
            derivatives: Some(variations),
        };
        self.sum_all(&task, out, residual, work);
    }

    /// Clears the sums, and adds all elements.
    pub(super) fn sum_all(
        &self,
        task: &Task<'_>,
        out: &mut [Combination<'_>],
        mut residual: Option<&mut Residual>,
        work: &mut Workspace,
    ) {
        for sum in out.iter_mut() {
            sum.matrix.values_mut().fill(0.0);
        }
        if let Some(residual) = residual.as_deref_mut() {
            self.clear(residual);
        }
        self.sum(task, out, residual, work);
    }

    /// Adds the elements of a part to its sums.
    pub(super) fn sum_part<S: Sums + ?Sized>(
        &self,
        task: &Task<'_>,
        part: &mut Part,
        sums: &mut S,
        mut residual: Option<[&mut [f64]; 2]>,
    ) {
        let Part {
            unknowns,
            elements,
            buffers,
        } = part;
        let all = (0..self.elements.len()).map(|index| (index, true));
        let some = elements.as_deref().unwrap_or_default().iter();
        let some = some.map(|&(index, is_whole)| (index as usize, is_whole));
        let count = if elements.is_none() { usize::MAX } else { 0 };
        for (index, is_whole) in all.take(count).chain(some) {
            let Buffers { gathered, of_kinds } = &mut *buffers;
            let layout = &self.layouts[index];
            let (kind, buffer) = (&self.kinds[layout.kind], &mut of_kinds[layout.kind]);
            let (local, forces) = (&mut buffer.jacobian, &mut buffer.residual);
            let at = self.placed(index, task.at.0, task.at.1, gathered);
            let element = &self.elements[index];
            if let Some([values, sizes]) = &mut residual {
                forces.clear();
                match task.derivatives {
                    None => element.residual(&at, forces),
                    Some(_) => {
                        kind.clear(local);
                        element.evaluate(&at, forces, Some(local));
                    }
                }
                let within = Within {
                    first: unknowns.start,
                    is_whole,
                };
                layout.add_vector(forces.values(), within, values);
                layout.add_vector(forces.sizes(), within, sizes);
            } else {
                kind.clear(local);
                element.jacobian(&at, local);
            }
            let Some(variations) = task.derivatives else {
                continue;
            };
            if !variations.is_empty() {
                for (i, &node) in element.nodes().iter().enumerate() {
                    kind.turn(i, &variations[node], local);
                }
            }
            sums.add(layout, (kind, local), is_whole);
        }
    }

    /// The Jacobian of an element, in its buffer.
    pub(super) fn local_jacobian<'a>(
        &self,
        index: usize,
        state: &State,
        conditions: &Conditions,
        work: &'a mut Workspace,
    ) -> &'a mut LocalJacobian {
        let Buffers { gathered, of_kinds } = &mut work.buffers;
        let kind = self.layouts[index].kind;
        let local = &mut of_kinds[kind].jacobian;
        self.kinds[kind].clear(local);
        let at = self.placed(index, state, conditions, gathered);
        self.elements[index].jacobian(&at, local);
        local
    }

    /// The data of a state visible to an element; `gathered` holds copies of data that are not
    /// consecutive in the state.
    pub(super) fn placed<'a>(
        &self,
        index: usize,
        state: &'a State,
        conditions: &'a Conditions,
        gathered: &'a mut Gathered,
    ) -> Local<'a> {
        let consecutive = self.layouts[index].consecutive;
        self.gather(index, (state, conditions), consecutive, gathered)
    }

    /// The same, given the first node if the element's nodes are consecutive.
    pub(super) fn gather<'a>(
        &self,
        index: usize,
        (state, conditions): (&'a State, &'a Conditions),
        consecutive: Option<usize>,
        gathered: &'a mut Gathered,
    ) -> Local<'a> {
        let nodes = self.elements[index].nodes();
        let Gathered {
            motions,
            scalars,
            rates,
        } = gathered;
        let motions = match consecutive {
            Some(first) => &state.nodes[first..first + nodes.len()],
            None => {
                motions.clear();
                motions.extend(nodes.iter().map(|&node| state.nodes[node]));
                &motions[..]
            }
        };
        let own = self.numbering.scalars_of(index);
        for (copies, numbers) in [
            (&mut *scalars, &state.scalars),
            (&mut *rates, &state.scalar_rates),
        ] {
            copies.clear();
            copies.extend(own.iter().map(|&i| numbers[i]));
        }
        Local {
            nodes: motions,
            multipliers: &state.multipliers[self.numbering.multipliers_of(index)],
            scalars: Scalars {
                values: scalars,
                rates,
            },
            memory: (state.memory)
                .get(self.numbering.memory_of(index))
                .unwrap_or_default(),
            frame: &conditions.frame,
            loading: &conditions.loading,
        }
    }

    /// Calls with the data of a state visible to an element.
    pub(super) fn seen<T>(
        &self,
        index: usize,
        state: &State,
        conditions: &Conditions,
        call: impl FnOnce(&Local<'_>) -> T,
    ) -> T {
        call(&self.placed(index, state, conditions, &mut Gathered::default()))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

    use super::*;
    use crate::assembly::{Sparse, Variation};
    use crate::elements::Element;
    use crate::elements::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
    use crate::elements::joints::clamped;
    use crate::model::{NODE_UNKNOWNS, Node, TurningFrame};

    fn system() -> System {
        let nodes: Vec<_> = (0..3)
            .map(|i| Node {
                label: format!("n{i}"),
                position: Vector3::new(f64::from(i), 0.1 * f64::from(i * i), 0.0),
                rotation: Matrix3::identity(),
            })
            .collect();
        let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let stiffness = Matrix6::from_diagonal(&Vector6::new(9.0, 8.0, 7.0, 3.0, 2.0, 4.0));
        let mass = Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 0.3, 0.1, 0.2));
        let on = [0, 1, 2];
        let beam = Beam::elastic("beam", on, geometry, undeformed, [stiffness; 2]);
        let mass = |_| mass;
        let mass = MassAlong::smooth(&mass);
        let inertia = BeamInertia::new("beam", on, geometry, undeformed, &mass);
        let elements: Vec<Box<dyn Element>> = vec![
            Box::new(clamped("root", 0, &nodes[0])),
            Box::new(beam),
            Box::new(inertia),
        ];
        System::new(nodes, elements)
    }

    /// Pseudorandom numbers between -1 and 1.
    fn scattered(count: usize) -> Vec<f64> {
        (0..count)
            .map(|i| (2.3 * i as f64 + 0.7 * (i * i) as f64).sin())
            .collect()
    }

    fn moving(system: &System) -> (State, Conditions) {
        let mut state = system.rest();
        let change: Vec<_> = scattered(system.numbering().unknowns());
        state.correct(&change.iter().map(|x| 0.2 * x).collect::<Vec<_>>());
        for (node, values) in state.nodes.iter_mut().zip(change.chunks(NODE_UNKNOWNS)) {
            node.velocity = Vector3::from_column_slice(&values[1..4]);
            node.angular_velocity = Vector3::from_column_slice(&values[4..7]);
        }
        let frame = TurningFrame {
            angular_velocity: Vector3::new(0.1, -0.3, 0.6),
            ..TurningFrame::at_rest()
        };
        (state, Conditions::turning(frame))
    }

    /// `A x` for the sum of derivatives against `F_y [theta; ...] + F_y' [d omega; ...]`.
    #[test]
    fn sums_of_derivatives_turn_the_nodes_by_the_unknowns_of_the_formula() {
        let system = system();
        let (state, conditions) = moving(&system);
        let n = system.numbering().unknowns();
        let numbers = scattered(18 * 3);
        let variations: Vec<_> = numbers
            .chunks_exact(18)
            .map(|part| Variation {
                turn: Matrix3::identity() + 0.3 * Matrix3::from_column_slice(&part[..9]),
                rate_by_turn: Matrix3::from_column_slice(&part[9..]),
                axes: None,
            })
            .collect();
        let weights = [0.7, 2.0, 3.0];
        let mut matrix = Sparse::zero(Arc::clone(system.pattern()));
        let mut out = [Combination {
            by_unknowns: weights[0],
            by_rates: weights[1],
            by_algebraic: weights[2],
            matrix: &mut matrix,
        }];
        let mut work = system.workspace();
        // The second evaluation reuses the buffers, and computes the residual as well.
        let mut residual = Residual::default();
        for both in [None, Some(&mut residual)] {
            let out = (&mut out[..], both);
            system.combine(&state, &conditions, &variations, out, &mut work);
        }
        let mut alone = Residual::default();
        system.residual_into(&state, &conditions, &mut alone, &mut work);
        assert_eq!(residual.values, alone.values);
        assert_eq!(residual.sizes, alone.sizes);
        let x = scattered(n);
        let mut found = vec![0.0; n];
        matrix.multiply_add(&x, &mut found);

        let first_multiplier = NODE_UNKNOWNS * system.nodes().len();
        let (mut change, mut rate) = (vec![0.0; n], vec![0.0; n]);
        for index in 0..n {
            let algebraic = index >= first_multiplier;
            change[index] = if algebraic { weights[2] } else { weights[0] } * x[index];
            rate[index] = if algebraic { 0.0 } else { weights[1] } * x[index];
        }
        for (node, variation) in variations.iter().enumerate() {
            let rotation = NODE_UNKNOWNS * node + 3..NODE_UNKNOWNS * node + 6;
            let u = Vector3::from_column_slice(&change[rotation.clone()]);
            let u_rate = Vector3::from_column_slice(&rate[rotation.clone()]);
            change[rotation.clone()].copy_from_slice((variation.turn * u).as_slice());
            let omega = variation.turn * u_rate + variation.rate_by_turn * u;
            rate[rotation].copy_from_slice(omega.as_slice());
        }
        let tangent = system.tangent(&state, &conditions);
        let mut expected = vec![0.0; n];
        tangent.by_unknowns.multiply_add(&change, &mut expected);
        tangent.by_rates.multiply_add(&rate, &mut expected);
        // Sums of some twenty terms of size ten: rounding stays below 1e-12.
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }

    #[test]
    fn a_residual_in_a_used_buffer_is_that_in_a_new_one() {
        let system = system();
        let (state, conditions) = moving(&system);
        let mut work = system.workspace();
        let mut out = Residual::default();
        system.residual_into(&system.rest(), &conditions, &mut out, &mut work);
        system.residual_into(&state, &conditions, &mut out, &mut work);
        assert_eq!(out, system.residual(&state, &conditions));
        assert!(out.values.iter().any(|value| *value != 0.0));
    }
}
