//! Effects of voltages on electrodes of a section.

use crate::failure::Failure;
use crate::section::Circuit;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn, Matrix6, Vector6};

/// The electrodes of a section, in its order: about the reference point, in section axes.
///
/// ```text
/// psi = C theta + Y_v V      theta = K psi + Theta V      q = -Theta' psi + cap V  (S-167)
/// ```
#[derive(Debug, Clone)]
pub struct PiezoSolution {
    /// The electrodes.
    pub electrodes: Vec<ElectrodeSolution>,
    /// Charge per length and volt at zero generalized strain, a row and a column for each
    /// electrode, symmetric \[F/m\].
    pub capacitance: DMatrix<f64>,
    /// As `capacitance`, at zero internal force \[F/m\].
    pub free_capacitance: DMatrix<f64>,
    /// Potential at the nodes of the mesh per unit internal force with all voltages zero,
    /// nodes x 6; zero at nodes without potential \[V/N, V/(N m)\].
    pub potential: DMatrix<f64>,
    /// Whether each node of the mesh has a potential.
    pub has_potential: Vec<bool>,
    /// Checks of the solution.
    pub checks: PiezoChecks,
}

/// One electrode at one volt, the others at zero.
#[derive(Debug, Clone)]
pub struct ElectrodeSolution {
    /// Name.
    pub name: String,
    /// Its connection to the circuit.
    pub circuit: Circuit,
    /// Whether it is a conductor; an interdigitated electrode otherwise.
    pub is_conductor: bool,
    /// Warping without internal force, rows ux, uy, uz of each node of the mesh; zero at
    /// nodes without a cell. The stress of internal forces does no work on it \[m/V\].
    pub warping: DVector<f64>,
    /// Potential at the nodes of the mesh; zero at nodes without one \[-\].
    pub potential: DVector<f64>,
    /// Y_v: generalized strain without internal force \[1/V, 1/(V m)\].
    pub free_strain: Vector6<f64>,
    /// Theta: internal force at zero generalized strain \[N/V, N m/V\].
    pub coupling: Vector6<f64>,
}

/// Self-checks of the solution; all errors are relative.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PiezoChecks {
    /// Difference of the free strains from the strains by the work on the central solutions
    /// (S-168), relative to `sqrt(C_ii cap_ee)`: strains of the energy of one volt \[-\].
    pub work: f64,
    /// Asymmetry of the capacitance, relative to its largest entry \[-\].
    pub asymmetry: f64,
    /// Sum of the free strains over all conductors, relative to the same strains, and of
    /// the charges, relative to the largest: a common voltage has no effect \[-\].
    pub common: f64,
}

/// A section for a beam model, with the electrodes that remain in a circuit.
#[derive(Debug, Clone, PartialEq)]
pub struct InCircuit {
    /// Internal force per generalized strain at zero voltage of the remaining electrodes,
    /// 6x6 \[N, N m, N m^2\].
    pub stiffness: Matrix6<f64>,
    /// Indices of the remaining electrodes.
    pub electrodes: Vec<usize>,
    /// Internal force per volt of each, 6 x remaining \[N/V, N m/V\].
    pub coupling: DMatrix<f64>,
    /// Charge per length and volt at zero generalized strain, remaining x remaining
    /// \[F/m\].
    pub capacitance: DMatrix<f64>,
}

/// Ratio of pivots to their entries below which a capacitance is singular: its electrodes
/// may have any common voltage.
const UNHELD: f64 = 1e-9;

/// The factors of a capacitance; `None` if it does not determine the voltages.
fn factored(capacitance: DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
    let diagonal = capacitance.diagonal();
    let factors = capacitance.cholesky()?;
    let factor = factors.l_dirty().diagonal();
    let mut pivots = factor.iter().zip(diagonal.iter());
    let is_held = pivots.all(|(pivot, entry)| pivot * pivot > UNHELD * entry);
    is_held.then_some(factors)
}

impl PiezoSolution {
    /// The section of the stiffness `k` at zero voltages, with each electrode as in
    /// `circuit`: grounded ones at zero voltage, floating ones at zero charge per length.
    /// `None` if floating electrodes leave a voltage undetermined.
    ///
    /// ```text
    /// q_f = 0:  V_f = cap_ff^-1 (Theta_f' psi - cap_fd V_d)
    /// K + Theta_f cap_ff^-1 Theta_f'     Theta_d - Theta_f cap_ff^-1 cap_fd
    /// cap_dd - cap_df cap_ff^-1 cap_fd                                         (S-169)
    /// ```
    pub fn in_circuit(
        &self,
        k: &Matrix6<f64>,
        circuit: impl Fn(usize) -> Circuit,
    ) -> Option<InCircuit> {
        let of_kind = |kind: Circuit| -> Vec<usize> {
            let all = 0..self.electrodes.len();
            all.filter(|&electrode| circuit(electrode) == kind)
                .collect()
        };
        let (driven, floating) = (of_kind(Circuit::Driven), of_kind(Circuit::Floating));
        let theta = |of: &[usize]| -> DMatrix<f64> {
            DMatrix::from_fn(6, of.len(), |row, column| {
                self.electrodes[of[column]].coupling[row]
            })
        };
        let part = |rows: &[usize], columns: &[usize]| {
            DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
                self.capacitance[(rows[i], columns[j])]
            })
        };
        let (theta_d, theta_f) = (theta(&driven), theta(&floating));
        if floating.is_empty() {
            return Some(InCircuit {
                stiffness: *k,
                coupling: theta_d,
                capacitance: part(&driven, &driven),
                electrodes: driven,
            });
        }
        let own = factored(part(&floating, &floating))?;
        let (by_strain, by_voltage) = (
            own.solve(&theta_f.transpose()),
            own.solve(&part(&floating, &driven)),
        );
        let stiffer: Matrix6<f64> = (&theta_f * by_strain).fixed_view::<6, 6>(0, 0).into_owned();
        let capacitance = part(&driven, &driven) - part(&driven, &floating) * &by_voltage;
        Some(InCircuit {
            stiffness: k + 0.5 * (stiffer + stiffer.transpose()),
            coupling: theta_d - theta_f * &by_voltage,
            capacitance: 0.5 * (&capacitance + capacitance.transpose()),
            electrodes: driven,
        })
    }

    /// Voltages of all electrodes under an internal force and given voltages, one for each
    /// electrode, of which only the voltages of driven electrodes are used \[V\]: floating
    /// ones have the voltage of zero charge per length. `None` as in
    /// [`PiezoSolution::in_circuit`].
    ///
    /// ```text
    /// 0 = -Theta_f' C theta + freecap_fd V_d + freecap_ff V_f
    /// ```
    pub fn voltages(
        &self,
        compliance: &Matrix6<f64>,
        force: &Vector6<f64>,
        driven: &[f64],
    ) -> Option<Vec<f64>> {
        let circuit = |electrode: usize| self.electrodes[electrode].circuit;
        let mut voltages: Vec<f64> = (0..self.electrodes.len())
            .map(|electrode| match circuit(electrode) {
                Circuit::Driven => driven.get(electrode).copied().unwrap_or(0.0),
                Circuit::Ground | Circuit::Floating => 0.0,
            })
            .collect();
        let all = 0..self.electrodes.len();
        let floating: Vec<usize> = all
            .filter(|&electrode| circuit(electrode) == Circuit::Floating)
            .collect();
        if floating.is_empty() {
            return Some(voltages);
        }
        let strain = compliance * force;
        let cap = &self.free_capacitance;
        let own = DMatrix::from_fn(floating.len(), floating.len(), |i, j| {
            cap[(floating[i], floating[j])]
        });
        let requested = DVector::from_fn(floating.len(), |i, _| {
            let electrode = floating[i];
            let by_voltage: f64 = (voltages.iter().enumerate())
                .map(|(other, voltage)| cap[(electrode, other)] * voltage)
                .sum();
            self.electrodes[electrode].coupling.dot(&strain) - by_voltage
        });
        let found = factored(own)?.solve(&requested);
        for (&electrode, voltage) in floating.iter().zip(found.iter()) {
            voltages[electrode] = *voltage;
        }
        Some(voltages)
    }

    /// Charge per length on each electrode under an internal force and `voltages` of all
    /// electrodes \[C/m\].
    ///
    /// ```text
    /// q = -Theta' C theta + freecap V
    /// ```
    pub fn charges(
        &self,
        compliance: &Matrix6<f64>,
        force: &Vector6<f64>,
        voltages: &[f64],
    ) -> Vec<f64> {
        let strain = compliance * force;
        let charge = |electrode: usize| {
            let by_voltage = voltages.iter().enumerate();
            let by_voltage: f64 = by_voltage
                .map(|(other, voltage)| self.free_capacitance[(electrode, other)] * voltage)
                .sum();
            by_voltage - self.electrodes[electrode].coupling.dot(&strain)
        };
        (0..self.electrodes.len()).map(charge).collect()
    }

    /// The largest of the parts of the sum in [`PiezoSolution::charges`] \[C/m\].
    pub fn largest_charge(
        &self,
        compliance: &Matrix6<f64>,
        force: &Vector6<f64>,
        voltages: &[f64],
    ) -> f64 {
        let strain = compliance * force;
        let parts = (0..self.electrodes.len()).flat_map(|electrode| {
            let by_strain = self.electrodes[electrode].coupling.component_mul(&strain);
            let by_voltage = voltages.iter().enumerate();
            by_voltage
                .map(move |(other, voltage)| self.free_capacitance[(electrode, other)] * voltage)
                .chain(std::iter::once(by_strain.amax()))
        });
        parts.fold(0.0, |most: f64, part| most.max(part.abs()))
    }

    /// The error that the voltages of its floating electrodes are undetermined.
    pub fn undetermined(&self) -> Failure {
        let floating = self.electrodes.iter();
        let floating = floating.filter(|known| known.circuit == Circuit::Floating);
        Failure::Undetermined {
            electrodes: floating.map(|known| known.name.clone()).collect(),
        }
    }
}
