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

use super::disk::{InducedSlopes, LOADS, RotorDisk};
use super::kinematics::{FLOW, SHAFT};
use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Scalar;

/// Rows of the loads of a disk.
pub(super) const OF_DISK: usize = 3;

/// A strip in a disk.
#[derive(Debug, Clone)]
pub(super) struct InDisk {
    disk: Arc<RotorDisk>,
    /// Index of the first unknown of the disk among the scalars of the element.
    first: usize,
    /// Length of the strip [m].
    length: f64,
    /// Whether its annulus has a mean velocity, its second unknown.
    has_mean: bool,
}

/// The derivatives of the strip at a state.
pub(super) struct InDiskState<'a> {
    of: &'a InDisk,
    /// Derivatives of U.
    induced: InducedSlopes,
    position: [f64; 2],
    /// `f . s ds`.
    force: f64,
}

impl InDisk {
    /// The strip of a length [m] in a disk, whose unknowns begin at `first` among the scalars of the element.
    pub fn new(disk: Arc<RotorDisk>, first: usize, length: f64) -> Self {
        Self {
            first,
            has_mean: disk.state_count() == 0,
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
    pub fn add(&self, flow: &[f64; FLOW], scalars: &[f64], loads: &[f64], out: &mut LocalResidual) {
        let position = position(flow);
        let values = &scalars[self.first..];
        let induced = self.disk.induced(&position, values, self.mean(scalars));
        out.add_scalar(0, -induced);
        let force = self.force(flow, loads);
        let row = self.first + LOADS;
        out.add_scalar(row, -force);
        for (i, b) in position.iter().enumerate() {
            out.add_scalar(row + 1 + i, -force * b);
        }
    }

    /// Its derivatives at the same state.
    pub fn at(&self, flow: &[f64; FLOW], scalars: &[f64], loads: &[f64]) -> InDiskState<'_> {
        let position = position(flow);
        let values = &scalars[self.first..];
        InDiskState {
            of: self,
            induced: self
                .disk
                .induced_slopes(&position, values, self.mean(scalars)),
            position,
            force: self.force(flow, loads),
        }
    }

    /// The mean velocity of its annulus, if it has one.
    fn mean(&self, scalars: &[f64]) -> Option<f64> {
        self.has_mean.then(|| scalars[1])
    }

    /// `f . s ds`.
    fn force(&self, flow: &[f64; FLOW], loads: &[f64]) -> f64 {
        let shaft = &flow[SHAFT..SHAFT + 3];
        self.length * shaft.iter().zip(loads).map(|(s, f)| s * f).sum::<f64>()
    }
}

/// The position in the disk.
fn position(flow: &[f64; FLOW]) -> [f64; 2] {
    [flow[FLOW - 2], flow[FLOW - 1]]
}

impl InDiskState<'_> {
    /// The derivative of `f . s ds` by an input of the strip.
    fn along(&self, flow: &[f64; FLOW], by: &StripJacobian, input: usize) -> f64 {
        let sum: f64 = (0..3).map(|i| flow[SHAFT + i] * by.by[i][input]).sum();
        self.of.length * sum
    }

    /// Adds the derivatives of the row of u by the numbers of the flow.
    pub fn add_to_first(&self, row: &mut [f64; FLOW]) {
        row[FLOW - 2] -= self.induced.by[0];
        row[FLOW - 1] -= self.induced.by[1];
    }

    /// The rows of the loads of the disk, and their derivatives by the numbers of the flow.
    pub fn rows(&self, flow: &[f64; FLOW], by: &StripJacobian) -> [(usize, [f64; FLOW]); OF_DISK] {
        let mut slopes = [0.0; FLOW];
        for (input, slope) in slopes.iter_mut().enumerate().take(FLOW - 2) {
            *slope = -self.along(flow, by, input);
        }
        for i in 0..3 {
            slopes[SHAFT + i] -= self.of.length * by.values[i];
        }
        let first = self.of.first + LOADS;
        let moment = |i: usize| {
            let mut slopes = slopes.map(|slope| slope * self.position[i]);
            slopes[FLOW - 2 + i] -= self.force;
            (first + 1 + i, slopes)
        };
        [(first, slopes), moment(0), moment(1)]
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
        let states = self.of.disk.state_count();
        let unknowns =
            (0..self.of.disk.scalars().len()).filter(|i| !(LOADS..LOADS + 3).contains(i));
        for i in unknowns {
            let slope = self.induced.by_scalar(i, states);
            out.add_scalar(0, self.of.first + i, -slope, false);
        }
        if self.of.has_mean {
            out.add_scalar(0, 1, -self.induced.by_mean(), false);
        }
    }
}

// The inputs of the kernel begin with the numbers of the flow, and its outputs with the loads.
const _: () = assert!(FLOW - 2 < STRIP_FLOW && STRIP_LOADS >= 3);
