//! The forces and charges of a given state of one dielectric cell.
//!
//! ```text
//! g   = grad V = (V,y  V,z  (V' - a V,y - b V,z)/J)         no turn of the section in it  (S-163)
//! [sigma; D] = law [eps; g]
//! Q_V = int (N,y Dy + N,z Dz - (a N,y + b N,z) Dx/J) J dA   at the nodes, within the section
//! P_V = int N Dx dA                                         at the nodes, on the face
//! W   = int (eps' sigma + g' D) J dA
//! ```
//!
//! Strains, stresses and their forces are computed as in [`super::forces`]. Minus Q_V is
//! the free charge per length that maintains the potential.
//!
//! # References
//! - [Masarati], appendix G: the section matrices of piezoelectric beams.

use super::cases::{CASES, CellState, Product, Row, add_work, strain_along, strain_in_cases};
use super::forces::CellForces;
use super::line::{Line, Metric};
use super::point::{CellPoint, RulePoint};

/// A potential at the nodes of a cell, `[node][case]`.
pub type CellPotential = [Row; 9];

/// Potential and its rate along the beam in six cases.
#[derive(Debug, Clone, Copy)]
pub struct PotentialState {
    /// V': rate along the beam.
    pub rate: CellPotential,
    /// V.
    pub potential: CellPotential,
}

impl PotentialState {
    /// No potential at any node.
    pub const NONE: Self = Self {
        rate: [[0.0; CASES]; 9],
        potential: [[0.0; CASES]; 9],
    };
}

/// Charges of a cell's electric displacements, in six cases.
#[derive(Debug, Clone)]
pub struct CellCharges {
    /// Q_V: `[node][case]`.
    pub within: CellPotential,
    /// P_V: `[node][case]`.
    pub face: CellPotential,
}

impl CellCharges {
    /// No charges.
    pub const NONE: Self = Self {
        within: [[0.0; CASES]; 9],
        face: [[0.0; CASES]; 9],
    };
}

/// Adds the stresses of `state` and `potentials` with the generalized strain `psi` in a
/// dielectric cell of the coupled law `law` to `forces`, and their charges to `charges`.
#[inline(always)]
pub fn add_coupled<P: Product>(
    (forces, charges): (&mut CellForces, &mut CellCharges),
    line: &Line,
    (rule, nodes): (&[RulePoint], &[[f64; 2]]),
    law: &[[f64; 9]; 9],
    (state, potentials): (&CellState, &PotentialState),
    psi: &[Row; 6],
) {
    let is_straight = line.is_straight();
    let difference = state.differences();
    let mut potential = potentials.potential;
    for node in (0..9).rev() {
        for k in 0..CASES {
            potential[node][k] -= potentials.potential[0][k];
        }
    }
    for point in rule {
        let point = point.of_cell(nodes);
        let metric = line.metric(point.y, point.z);
        let strain = if is_straight {
            strain_in_cases::<P>(&point, &state.rate, &difference, psi)
        } else {
            strain_along::<P>((line, &metric), &point, state, &difference, psi)
        };
        let gradient = gradient::<P>(&point, &metric, &potentials.rate, &potential);
        let volume = point.area * metric.volume;
        let (stress, flux) = answers::<P>(law, &strain, &gradient, volume);
        if is_straight {
            forces.add_point::<P>(&point, &strain, &stress)
        } else {
            forces.add_turned::<P>(&point, (line, &metric), &strain, &stress)
        }
        add_work::<P, 6, 3>(&mut forces.work, &gradient, &flux);
        charges.add::<P>(&point, &metric, &flux);
    }
}

/// The gradient y z x of a potential, by its differences from the first node.
#[inline(always)]
fn gradient<P: Product>(
    point: &CellPoint,
    metric: &Metric,
    rate: &CellPotential,
    potential: &CellPotential,
) -> [Row; 3] {
    let [mut along_y, mut along_z, mut along] = [[0.0; CASES]; 3];
    for node in 0..point.count {
        let (n, dy, dz) = (point.n[node], point.dy[node], point.dz[node]);
        for k in 0..CASES {
            along_y[k] = P::add(dy, potential[node][k], along_y[k]);
            along_z[k] = P::add(dz, potential[node][k], along_z[k]);
            along[k] = P::add(n, rate[node][k], along[k]);
        }
    }
    let [a, b] = metric.tilt;
    for k in 0..CASES {
        along[k] = (along[k] - a * along_y[k] - b * along_z[k]) / metric.volume;
    }
    [along_y, along_z, along]
}

/// Stress and electric displacement of a coupled law, times `volume`.
#[inline(always)]
fn answers<P: Product>(
    law: &[[f64; 9]; 9],
    strain: &[Row; 6],
    gradient: &[Row; 3],
    volume: f64,
) -> ([Row; 6], [Row; 3]) {
    let [yz, yy, zz, xx, xy, xz] = *strain;
    let [gy, gz, gx] = *gradient;
    let state = [yz, yy, zz, xx, xy, xz, gy, gz, gx];
    let mut answers = [[0.0; CASES]; 9];
    for (answer, law) in answers.iter_mut().zip(law) {
        for (row, entry) in state.iter().zip(law) {
            let entry = volume * entry;
            for k in 0..CASES {
                answer[k] = P::add(entry, row[k], answer[k]);
            }
        }
    }
    let [yz, yy, zz, xx, xy, xz, dy, dz, dx] = answers;
    ([yz, yy, zz, xx, xy, xz], [dy, dz, dx])
}

impl CellCharges {
    /// Adds the charges of an electric displacement, times the volume of the point.
    #[inline(always)]
    fn add<P: Product>(&mut self, point: &CellPoint, metric: &Metric, flux: &[Row; 3]) {
        let [of_y, of_z, of_x] = flux;
        let [a, b] = metric.tilt;
        let mut along = [0.0; CASES];
        for k in 0..CASES {
            along[k] = of_x[k] / metric.volume;
        }
        for node in 0..point.count {
            let (n, dy, dz) = (point.n[node], point.dy[node], point.dz[node]);
            let slid = -(a * dy + b * dz);
            let (within, face) = (&mut self.within[node], &mut self.face[node]);
            for k in 0..CASES {
                let in_plane = P::add(dy, of_y[k], P::add(dz, of_z[k], within[k]));
                within[k] = P::add(slid, along[k], in_plane);
                face[k] = P::add(n, along[k], face[k]);
            }
        }
    }
}
