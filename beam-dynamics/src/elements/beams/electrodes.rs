//! Electrodes of a beam: forces of their voltages, and their charges.
//!
//! At the evaluation points, in section axes, with the columns `Theta_k` of the coupling and
//! the voltages `V_k` of the electrodes,
//!
//! ```text
//! [F~; M~] = law(eps, eps', t) + sum_k Theta_k V_k                             (D-260)
//! Q_k      = sum_points J0 ( -Theta_k . eps + sum_l C_kl V_l )                 (D-261)
//! E        = 1/2 sum_points J0 sum_kl V_k C_kl V_l                             (D-262)
//! ```
//!
//! The forces of a voltage on the nodes of a variational beam are `-J0 B^T Theta_k`, so that their
//! work on any motion of the nodes is the work of the charges:
//!
//! ```text
//! sum_nodes ( dF_k . v + dM_k . omega ) / d V_k = d Q_k / d t  at constant V  (D-263)
//! ```
//!
//! Finite volumes fulfill it for stretch, twist and bending of a coupling that is the same at both
//! points, and for shear up to the square of the rotation within the beam.
//!
//! References: [Masarati], piezoelectric beams.

use nalgebra::{DMatrix, RowVector3, Vector6};

use super::attachment::{BeamGeometry, EVALUATION_POINTS};
use super::strain::Variation;
use crate::elements::signal::index_in;
use crate::elements::{Charges, Local, LocalJacobian, LocalResidual, Signal, SmallMotion};
use crate::model::{Node, Scalar, Variable};

/// Source of the voltage of an electrode.
#[derive(Debug, Clone, PartialEq)]
pub enum Potential {
    /// It is given [V].
    Held(Signal),
    /// It is an unknown of the model.
    Free(Scalar),
}

/// An electrode on a beam.
#[derive(Debug, Clone, PartialEq)]
pub struct BeamElectrode {
    /// Its index among the electrodes of the model.
    pub number: usize,
    /// Its voltage.
    pub potential: Potential,
    /// Internal force for one volt at the two evaluation points, section axes
    /// [N/V, N m/V].
    pub coupling: [Vector6<f64>; 2],
    /// Capacitance of the whole electrode, the divisor of the equation of its charge [F].
    pub capacitance: f64,
}

impl BeamElectrode {
    /// Capacitance of a beam whose capacitance per length is given at the evaluation points
    /// [F].
    pub fn capacitance(
        geometry: &BeamGeometry,
        undeformed: [&Node; 3],
        per_length: [f64; 2],
    ) -> f64 {
        let points = EVALUATION_POINTS.into_iter().zip(per_length);
        points
            .map(|(xi, value)| geometry.reference_point(&undeformed, xi).j0 * value)
            .sum()
    }
}

/// The electrodes of one beam.
#[derive(Debug, Clone, Default)]
pub(super) struct Electrodes {
    list: Vec<BeamElectrode>,
    /// Indices of the unknown voltages among the scalars of the beam.
    indices: Vec<Option<usize>>,
    /// J0 at the evaluation points [m].
    lengths: [f64; 2],
    /// Electrodes x electrodes at the evaluation points [F/m].
    capacitance: Vec<DMatrix<f64>>,
}

/// A voltage, and its index among the scalars of the element if it is unknown.
pub(super) struct Voltage {
    pub value: f64,
    pub scalar: Option<usize>,
}

impl Electrodes {
    /// The electrodes of a beam with the given scalars, to which their scalars are added.
    pub fn new(
        mut list: Vec<BeamElectrode>,
        capacitance: [DMatrix<f64>; 2],
        lengths: [f64; 2],
        scalars: &mut Vec<Scalar>,
    ) -> Self {
        let index = |electrode: &mut BeamElectrode| match &mut electrode.potential {
            Potential::Held(signal) => {
                signal.bind(scalars);
                None
            }
            Potential::Free(scalar) => Some(index_in(scalars, scalar)),
        };
        Self {
            indices: list.iter_mut().map(index).collect(),
            list,
            lengths,
            capacitance: capacitance.into(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Coupling of electrode `k` of the beam at an evaluation point.
    pub fn coupling(&self, k: usize, index: usize) -> &Vector6<f64> {
        &self.list[k].coupling[index]
    }

    /// The signals of given voltages.
    pub fn signals(&self) -> impl Iterator<Item = &Signal> {
        self.list
            .iter()
            .filter_map(|electrode| match &electrode.potential {
                Potential::Held(signal) => Some(signal),
                Potential::Free(_) => None,
            })
    }

    pub fn voltages(&self, at: &Local<'_>) -> Vec<Voltage> {
        self.each(
            |signal| at.loading.voltages * signal.value(&at.instant()),
            |scalar| at.scalars.values[scalar],
        )
    }

    /// Change of the voltages along a motion; given voltages do not change.
    pub fn growth(&self, motion: &SmallMotion<'_>) -> Vec<Voltage> {
        self.each(|_| 0.0, |scalar| motion.scalars[scalar])
    }

    fn each(&self, held: impl Fn(&Signal) -> f64, free: impl Fn(usize) -> f64) -> Vec<Voltage> {
        let value = |electrode: &BeamElectrode, index: Option<usize>| match &electrode.potential {
            Potential::Held(signal) => held(signal),
            Potential::Free(_) => index.map_or(0.0, &free),
        };
        let indices = self.list.iter().zip(&self.indices);
        let voltage = indices.map(|(electrode, &scalar)| Voltage {
            value: value(electrode, scalar),
            scalar,
        });
        voltage.collect()
    }

    /// Calls `add` with the derivatives of all voltages by scalars: index of the electrode of the
    /// beam, index of the scalar, derivative.
    pub fn by_scalars(&self, at: &Local<'_>, mut add: impl FnMut(usize, usize, f64)) {
        let electrodes = self.list.iter().zip(&self.indices).enumerate();
        for (k, (electrode, index)) in electrodes {
            match (&electrode.potential, index) {
                (Potential::Held(signal), _) => {
                    let size = at.loading.voltages;
                    signal.gradient(&at.instant(), |scalar, slope| add(k, scalar, size * slope));
                }
                (Potential::Free(_), Some(scalar)) => add(k, *scalar, 1.0),
                (Potential::Free(_), None) => {}
            }
        }
    }

    /// Force of all voltages at an evaluation point, section axes.
    pub fn force(&self, index: usize, voltages: &[Voltage]) -> Vector6<f64> {
        let pairs = self.list.iter().zip(voltages);
        pairs
            .map(|(electrode, voltage)| electrode.coupling[index] * voltage.value)
            .sum()
    }

    /// The part of the charge of electrode `k` of the beam that depends on the strains.
    fn by_strain(&self, k: usize, strains: &[Vector6<f64>; 2]) -> f64 {
        let of = |index: usize| -self.lengths[index] * self.coupling(k, index).dot(&strains[index]);
        of(0) + of(1)
    }

    /// Charge of electrode `k` for one volt on electrode `l` of the beam [F].
    fn mutual(&self, k: usize, l: usize) -> f64 {
        let points = self.lengths.iter().zip(&self.capacitance);
        points.map(|(j0, matrix)| j0 * matrix[(k, l)]).sum()
    }

    /// The part of the charge of electrode `k` that depends on the voltages.
    fn by_voltages(&self, k: usize, voltages: &[Voltage]) -> f64 {
        let terms = voltages.iter().enumerate();
        terms
            .map(|(l, voltage)| self.mutual(k, l) * voltage.value)
            .sum()
    }

    pub fn energy(&self, voltages: &[Voltage]) -> f64 {
        let terms = voltages.iter().enumerate();
        terms
            .map(|(k, voltage)| 0.5 * voltage.value * self.by_voltages(k, voltages))
            .sum()
    }

    /// Adds minus the charges to their equations.
    pub fn add_charges(
        &self,
        voltages: &[Voltage],
        strains: &[Vector6<f64>; 2],
        out: &mut LocalResidual,
    ) {
        for (k, voltage) in voltages.iter().enumerate() {
            let Some(row) = voltage.scalar else { continue };
            for part in [self.by_strain(k, strains), self.by_voltages(k, voltages)] {
                out.add_scalar(row, -part / self.list[k].capacitance);
            }
        }
    }

    /// Adds the variations of the terms of [`Self::add_charges`] at an evaluation point.
    pub fn add_charge_rows(
        &self,
        index: usize,
        (variation, at): (&Variation, &Local<'_>),
        out: &mut LocalJacobian,
    ) {
        const UNKNOWNS: [Variable; 2] = [Variable::Position, Variable::Rotation];
        for (k, row) in self.indices.iter().enumerate() {
            let Some(row) = *row else { continue };
            let weight = self.lengths[index] / self.list[k].capacitance;
            let values = weight * self.coupling(k, index).transpose() * variation;
            for (node, variable) in (0..3).flat_map(|node| [(node, 0), (node, 1)]) {
                let first = 6 * node + 3 * variable;
                let values = RowVector3::from_fn(|_, i| values[first + i]);
                out.add_scalar_row(row, (node, UNKNOWNS[variable]), &values);
            }
            self.by_scalars(at, |l, column, slope| {
                let charge = weight * self.capacitance[index][(k, l)];
                out.add_scalar(row, column, -charge * slope, false);
            });
        }
    }

    /// Reports charges by strains and their rates, and capacitances.
    pub fn report(
        &self,
        strains: &[Vector6<f64>; 2],
        rates: &[Vector6<f64>; 2],
        out: &mut Charges,
    ) {
        for (k, electrode) in self.list.iter().enumerate() {
            let number = electrode.number;
            let [charge, rate] = [strains, rates].map(|of| self.by_strain(k, of));
            out.by_strain.push((number, charge, rate));
            for (l, other) in self.list.iter().enumerate() {
                out.capacitance
                    .push((number, other.number, self.mutual(k, l)));
            }
        }
    }
}
