//! Derivatives of a system by the factor of the proportional loads.

use std::sync::Arc;

use nalgebra::Vector3;

use super::System;
use super::layout::Within;
use crate::assembly::Sparse;
use crate::elements::{Local, LocalJacobian, LocalResidual, LocalSize, Queries, SmallMotion};
use crate::model::{Conditions, NODE_UNKNOWNS, State};

impl System {
    /// Derivative of the residual by the factor of the proportional loads.
    pub fn by_factor(&self, state: &State, conditions: &Conditions) -> Vec<f64> {
        let mut sum = vec![0.0; self.numbering.unknowns()];
        for (index, element) in self.elements.iter().enumerate() {
            let mut local = LocalResidual::new(LocalSize::of(element.as_ref()));
            let call = |at: &Local<'_>| element.by_factor(at, &mut local);
            self.seen(index, state, conditions, call);
            self.layouts[index].add_vector(local.values(), Within::ALL, &mut sum);
        }
        sum
    }

    /// Growth of the Jacobian by the unknowns with the factor of the proportional
    /// loads, at fixed geometry: with internal forces and multipliers that change along
    /// the motion `motion` (in the order of the unknowns), and with the loads.
    pub fn prestress(&self, state: &State, conditions: &Conditions, motion: &[f64]) -> Sparse {
        let mut sum = Sparse::zero(Arc::clone(&self.pattern));
        for (index, element) in self.elements.iter().enumerate() {
            let layout = &self.layouts[index];
            let indices = &layout.rows;
            let size = LocalSize::of(element.as_ref());
            let moved: Vec<_> = (0..size.nodes)
                .map(|node| {
                    let first = indices[NODE_UNKNOWNS * node];
                    let part = |i| Vector3::from_column_slice(&motion[first + i..first + i + 3]);
                    [part(0), part(3)]
                })
                .collect();
            let own = &indices[NODE_UNKNOWNS * size.nodes..];
            let own: Vec<_> = own.iter().map(|&entry| motion[entry]).collect();
            let (multipliers, scalars) = own.split_at(size.multipliers);
            let motion = SmallMotion {
                nodes: &moved,
                multipliers,
                scalars,
            };
            let mut local = LocalJacobian::new(size);
            let call = |at: &Local<'_>| element.prestress(at, &motion, &mut local);
            self.seen(index, state, conditions, call);
            let kind = &self.kinds[layout.kind];
            let to = (Within::ALL, sum.values_mut());
            layout.add_weighted(kind, &local, [1.0, 0.0, 1.0], to);
        }
        sum
    }
}
