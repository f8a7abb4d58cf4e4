//! A strip in the disk of its rotor: its induced velocity from the disk, and its force for the loads
//! of the disk.
//!
//! With the unknowns u of the strip and the disk's velocity U at its position b, the force f per length
//! in the airfoil axes and the shaft s in them:
//!
//! ```text
//! u - U(b, flow, states) = 0            T: - f . s ds            M_i: - f . s b_i ds
//! ```
//!
//! In a disk without a model, U follows from the mean velocity of the strip's annulus, its second
//! unknown.

use std::sync::Arc;

use rotor_aero::strip::{FLOW as STRIP_FLOW, LOADS as STRIP_LOADS, StripJacobian};

use super::disk::{LOADS, RotorDisk};
use super::kinematics::{FLOW, FlowBlock, SHAFT};
use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::{Scalar, Variable};

/// A strip in a disk.
#[derive(Debug, Clone)]
pub(super) struct InDisk {
    disk: Arc<RotorDisk>,
    /// Index of the first unknown of the disk among the scalars of the element.
    first: usize,
    /// Length of the strip [m].
    length: f64,
    /// Whether its annulus has a mean velocity, its second unknown.
    is_skewed: bool,
}

/// The strip at a state.
pub(super) struct InDiskState<'a> {
    of: &'a InDisk,
    /// Derivatives of U by the numbers of the flow at the strip and by the disk's unknowns.
    by_position: [f64; 2],
    by_scalars: Vec<f64>,
    by_mean: f64,
    position: [f64; 2],
    /// `f . s ds`.
    force: f64,
}

impl InDisk {
    /// The strip of a length [m] in a disk, whose unknowns begin at `first` among the scalars of the element.
    pub fn new(disk: Arc<RotorDisk>, first: usize, length: f64) -> Self {
        Self {
            first,
            is_skewed: disk.state_count() == 0,
            disk,
            length,
        }
    }

    /// The unknowns of the disk.
    pub fn scalars(&self) -> &[Scalar] {
        self.disk.scalars()
    }

    /// Adds the rows at the numbers of the flow, with the scalars of the element and the loads of the
    /// strip.
    pub fn at(
        &self,
        flow: &[f64; FLOW],
        scalars: &[f64],
        loads: &[f64],
        out: &mut LocalResidual,
    ) -> InDiskState<'_> {
        let position = [flow[FLOW - 2], flow[FLOW - 1]];
        let values = &scalars[self.first..];
        let mean = self.is_skewed.then_some(scalars[1]);
        let induced = self.disk.induced(&position, values, mean);
        out.add_scalar(0, -induced.value);
        let shaft = &flow[SHAFT..SHAFT + 3];
        let along = shaft.iter().zip(loads).map(|(s, f)| s * f);
        let force = self.length * along.sum::<f64>();
        let row = self.first + LOADS;
        out.add_scalar(row, -force);
        for (i, b) in position.iter().enumerate() {
            out.add_scalar(row + 1 + i, -force * b);
        }
        let count = self.disk.scalars().len();
        let states = self.disk.state_count();
        InDiskState {
            of: self,
            by_position: [induced.by[0], induced.by[1]],
            by_mean: induced.by_mean(),
            by_scalars: (0..count).map(|i| induced.by_scalar(i, states)).collect(),
            position,
            force,
        }
    }
}

impl InDiskState<'_> {
    /// The derivative of `f . s ds` by an input of the strip.
    fn along(&self, flow: &[f64; FLOW], by: &StripJacobian, input: usize) -> f64 {
        let sum: f64 = (0..3).map(|i| flow[SHAFT + i] * by.by[i][input]).sum();
        self.of.length * sum
    }

    /// Adds the derivatives by a variable of a node.
    pub fn add_rows(
        &self,
        (flow, by): (&[f64; FLOW], &StripJacobian),
        column: (usize, Variable),
        block: &FlowBlock,
        out: &mut LocalJacobian,
    ) {
        let [first, second] = [block.row(FLOW - 2), block.row(FLOW - 1)];
        let by_position = first * self.by_position[0] + second * self.by_position[1];
        out.add_scalar_row(0, column, &-by_position);
        let mut slopes = [0.0; FLOW];
        for (input, slope) in slopes.iter_mut().enumerate().take(FLOW - 2) {
            *slope = self.along(flow, by, input);
        }
        for i in 0..3 {
            slopes[SHAFT + i] += self.of.length * by.values[i];
        }
        let slopes = nalgebra::RowSVector::<f64, FLOW>::from_row_slice(&slopes);
        let force = slopes * block;
        let row = self.of.first + LOADS;
        out.add_scalar_row(row, column, &-force);
        for (i, place) in [first, second].iter().enumerate() {
            let moment = force * self.position[i] + place * self.force;
            out.add_scalar_row(row + 1 + i, column, &-moment);
        }
    }

    /// Adds the derivatives of the loads by a scalar of the strip, `input` of its kernel with the
    /// given slope.
    pub fn add_scalar(
        &self,
        (flow, by): (&[f64; FLOW], &StripJacobian),
        column: (usize, bool),
        (input, slope): (usize, f64),
        out: &mut LocalJacobian,
    ) {
        let force = slope * self.along(flow, by, input);
        let row = self.of.first + LOADS;
        let arms = [1.0, self.position[0], self.position[1]];
        for (i, arm) in arms.into_iter().enumerate() {
            out.add_scalar(row + i, column.0, -force * arm, column.1);
        }
    }

    /// Adds the derivatives of the induced velocity by the unknowns of the disk.
    pub fn add_induced(&self, out: &mut LocalJacobian) {
        for (i, slope) in self.by_scalars.iter().enumerate() {
            if !(LOADS..LOADS + 3).contains(&i) {
                out.add_scalar(0, self.of.first + i, -slope, false);
            }
        }
        if self.of.is_skewed {
            out.add_scalar(0, 1, -self.by_mean, false);
        }
    }
}

// The inputs of the kernel begin with the numbers of the flow, and its outputs with the loads.
const _: () = assert!(FLOW - 2 < STRIP_FLOW && STRIP_LOADS >= 3);
