//! Motion of a mode, and the kinetic energy of each direction.
//!
//! The mass matrix is read off the linearized definitions of the momenta, `M = -dr/dq'`
//! with r the rows of momentum and angular momentum and q' velocities and angular
//! velocities. For the complex motion q of a mode the energy of direction d of a node
//! is `Re(conj(q_d) (M q)_d)`; the shares of all directions sum to one.

use nalgebra::{Complex, Matrix3, Vector3};

use super::Eigenpair;
use crate::assembly::{Entry, Sparse};
use crate::model::{Equation, NODE_UNKNOWNS, NamingAxes, Variable};
use crate::result::{ModeShape, Shares};

/// Motion of a mode: translation and rotation of each node.
#[derive(Debug, Clone)]
pub struct ModeMotion {
    /// Six complex entries a node: displacement [m] and rotation [rad], of unit energy.
    pub(super) motion: Vec<Complex<f64>>,
    /// `M` times the motion.
    pub(super) momentum: Vec<Complex<f64>>,
}

/// Six rows or columns a node, of the twelve of the system.
const SIX: usize = 6;

impl ModeMotion {
    /// The motion of an eigenpair, scaled to unit energy `Re(q^H M q) = 1` and with the
    /// largest entry real.
    pub fn new(pair: &Eigenpair, mass: &MassMatrix) -> Self {
        let nodes = pair.real.len() / NODE_UNKNOWNS;
        let index = |k: usize| NODE_UNKNOWNS * (k / SIX) + k % SIX;
        let motion: Vec<_> = (0..SIX * nodes)
            .map(|k| Complex::new(pair.real[index(k)], pair.imaginary[index(k)]))
            .collect();
        let momentum = mass.times(&motion);
        Self { motion, momentum }.scaled()
    }

    /// Of a motion and its momentum, six entries a node, scaled alike.
    pub fn from_parts(motion: Vec<Complex<f64>>, momentum: Vec<Complex<f64>>) -> Self {
        Self { motion, momentum }.scaled()
    }

    /// The motion of the nodes.
    pub fn shape(&self) -> ModeShape {
        let part = |first: usize| -> Vec<_> {
            let nodes = self.motion.chunks(SIX);
            nodes
                .map(|node| std::array::from_fn(|i| node[first + i]))
                .collect()
        };
        ModeShape {
            displacements: part(0),
            rotations: part(3),
        }
    }

    /// The motion, six complex entries a node, and its momentum.
    pub fn parts(&self) -> [&[Complex<f64>]; 2] {
        [&self.motion, &self.momentum]
    }

    /// The conjugate motion, of the eigenvalue with the opposite frequency.
    pub fn conjugate(&self) -> Self {
        let conjugate = |values: &[Complex<f64>]| values.iter().map(Complex::conj).collect();
        Self {
            motion: conjugate(&self.motion),
            momentum: conjugate(&self.momentum),
        }
    }

    /// `q_a^H M q_b`.
    pub(super) fn product(&self, other: &Self) -> Complex<f64> {
        self.along(&other.momentum)
    }

    /// Shares of flap, lag, torsion and axial motion, by the axes of each node.
    pub fn shares(&self, axes: &[NamingAxes]) -> Shares {
        let mut shares = self.energies(self, axes).map(|energy| energy.re);
        let total: f64 = shares.iter().sum();
        if total > 0.0 {
            shares.iter_mut().for_each(|share| *share /= total);
        }
        shares
    }

    /// Share of flap and lag of the central nodes: motion across the axis of rotation of nodes
    /// that belong to no blade.
    pub fn lateral(&self, axes: &[NamingAxes]) -> f64 {
        let total: f64 = self.energies(self, axes).iter().map(|e| e.re).sum();
        let central = |node: usize| f64::from(u8::from(axes[node].is_central));
        let [flap, lag, ..] = self.weighted_energies(self, axes, central);
        if total > 0.0 {
            (flap.re + lag.re) / total
        } else {
            0.0
        }
    }

    /// Shares of the motion fore-aft and from side to side of the nodes that belong to no blade, in a
    /// model with a tower: displacements and rotations about the other direction.
    pub fn of_tower(&self, axes: &[NamingAxes]) -> [f64; 2] {
        let total: f64 = self.energies(self, axes).iter().map(|e| e.re).sum();
        let as_tower = axes.iter().map(|own| match own.tower {
            Some(tower) => NamingAxes {
                blade: tower,
                section: tower,
                ..*own
            },
            None => *own,
        });
        let as_tower: Vec<_> = as_tower.collect();
        let of_tower = |node: usize| f64::from(u8::from(axes[node].tower.is_some()));
        let [fore_aft, side, ..] = self.weighted_energies(self, &as_tower, of_tower);
        match total > 0.0 {
            true => [fore_aft.re / total, side.re / total],
            false => [0.0; 2],
        }
    }

    /// `q_a^H P M q_b` with P the projection on flap, lag, torsion and axial motion:
    /// displacements along the blade axes, rotations about the section axes.
    pub(super) fn energies(&self, other: &Self, axes: &[NamingAxes]) -> [Complex<f64>; 4] {
        self.weighted_energies(other, axes, |_| 1.0)
    }

    /// These energies, with a weight for each node.
    pub(super) fn weighted_energies(
        &self,
        other: &Self,
        axes: &[NamingAxes],
        weight: impl Fn(usize) -> f64,
    ) -> [Complex<f64>; 4] {
        let mut energies = [Complex::new(0.0, 0.0); 4];
        for (k, axes) in axes.iter().enumerate() {
            for (first, frame, kinds) in halves(k, axes) {
                let at = |values: &[Complex<f64>]| {
                    Vector3::new(values[first], values[first + 1], values[first + 2])
                };
                let (motion, momentum) = (at(&self.motion), at(&other.momentum));
                for (axis, kind) in kinds.into_iter().enumerate() {
                    let direction = frame.column(axis).map(Complex::from);
                    let energy = direction.dot(&motion).conj() * direction.dot(&momentum);
                    energies[kind] += energy * weight(k);
                }
            }
        }
        energies
    }

    /// `W p` with p the momentum and W the projection on flap, lag, torsion and axial motion, each
    /// times its weight, and times the weight of each node.
    pub(super) fn weighted_momentum(
        &self,
        axes: &[NamingAxes],
        kinds: [f64; 4],
        nodes: &[f64],
    ) -> Vec<Complex<f64>> {
        let mut result = vec![Complex::new(0.0, 0.0); self.momentum.len()];
        for (k, (axes, weight)) in axes.iter().zip(nodes).enumerate() {
            for (first, frame, order) in halves(k, axes) {
                let momentum = &self.momentum[first..][..3];
                for (axis, kind) in order.into_iter().enumerate() {
                    let direction = frame.column(axis);
                    let along = direction.iter().zip(momentum).map(|(d, p)| p * *d);
                    let along = along.sum::<Complex<f64>>() * kinds[kind] * *weight;
                    let entries = result[first..][..3].iter_mut().zip(&direction);
                    entries.for_each(|(entry, d)| *entry += along * *d);
                }
            }
        }
        result
    }

    /// `q^H x` for six entries a node.
    pub(super) fn along(&self, x: &[Complex<f64>]) -> Complex<f64> {
        let terms = self.motion.iter().zip(x);
        terms.map(|(q, x)| q.conj() * x).sum()
    }

    /// The sum of `modes`, each times its factor.
    pub(super) fn combined(modes: &[Self], factors: &[Complex<f64>]) -> Self {
        let sum = |pick: fn(&Self) -> &Vec<Complex<f64>>| {
            let length = modes.first().map_or(0, |mode| pick(mode).len());
            let entry = |i: usize| modes.iter().zip(factors).map(|(m, f)| pick(m)[i] * f).sum();
            (0..length).map(entry).collect()
        };
        Self {
            motion: sum(|mode| &mode.motion),
            momentum: sum(|mode| &mode.momentum),
        }
        .scaled()
    }

    /// The same mode with unit energy and its largest entry real.
    fn scaled(mut self) -> Self {
        let largest = self
            .motion
            .iter()
            .max_by(|a, b| a.norm().total_cmp(&b.norm()));
        let turn = largest
            .filter(|z| z.norm() > 0.0)
            .map(|z| z.conj() / z.norm());
        let energy = self.product(&self).re;
        let scale = if energy > 0.0 {
            1.0 / energy.sqrt()
        } else {
            1.0
        };
        let factor = turn.unwrap_or(Complex::new(1.0, 0.0)) * scale;
        let values = self.motion.iter_mut().chain(&mut self.momentum);
        values.for_each(|z| *z *= factor);
        self
    }
}

/// Displacement and rotation of node `k`: the first entry, the axes, and the kind of motion along or
/// about each.
fn halves(k: usize, axes: &NamingAxes) -> [(usize, &Matrix3<f64>, [usize; 3]); 2] {
    const AXIAL_LAG_FLAP: [usize; 3] = [3, 1, 0];
    const TORSION_FLAP_LAG: [usize; 3] = [2, 0, 1];
    [
        (SIX * k, &axes.blade, AXIAL_LAG_FLAP),
        (SIX * k + 3, &axes.section, TORSION_FLAP_LAG),
    ]
}

/// The mass matrix, six rows and columns a node.
#[derive(Debug, Clone)]
pub struct MassMatrix {
    entries: Vec<Entry>,
}

impl MassMatrix {
    /// The mass matrix of the first `nodes` nodes of a system with these derivatives by rates,
    /// `F_y'`.
    pub fn new(by_rates: &Sparse, nodes: usize) -> Self {
        let force = Equation::Force.row();
        let momentum = Variable::Momentum.column();
        let entry = |(row, column, value): Entry| {
            let (i, j) = (row % NODE_UNKNOWNS, column % NODE_UNKNOWNS);
            let of_nodes = row.max(column) < NODE_UNKNOWNS * nodes;
            let index = |line: usize, own: usize| SIX * (line / NODE_UNKNOWNS) + own;
            (of_nodes && i < force && j < momentum && value != 0.0)
                .then(|| (index(row, i), index(column, j), -value))
        };
        Self {
            entries: by_rates.triplets().filter_map(entry).collect(),
        }
    }

    /// `M q`.
    pub fn times(&self, motion: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let mut momentum = vec![Complex::new(0.0, 0.0); motion.len()];
        for &(row, column, value) in &self.entries {
            momentum[row] += value * motion[column];
        }
        momentum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_has_displacements_and_rotations_of_each_node() {
        let motion: Vec<_> = (0..12).map(|k| Complex::new(f64::from(k), 1.0)).collect();
        let momentum = motion.clone();
        let shape = ModeMotion { motion, momentum }.shape();
        let three = |first: f64| [0.0, 1.0, 2.0].map(|k| Complex::new(first + k, 1.0));
        assert_eq!(shape.displacements, [three(0.0), three(6.0)]);
        assert_eq!(shape.rotations, [three(3.0), three(9.0)]);
    }
}
