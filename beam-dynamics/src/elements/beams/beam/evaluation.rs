//! The evaluation points of a beam at a state: their forces on the nodes, with derivatives.

use nalgebra::{Matrix6, RowVector6, Vector3, Vector6};

use super::Beam;
use crate::elements::beams::attachment::Formulation;
use crate::elements::beams::electrodes::Voltage;
use crate::elements::beams::forces::{Test, add_column, add_forces, add_tangent};
use crate::elements::beams::gradient::{self, EvaluationPoint};
use crate::elements::beams::interpolation::{NodalKinematics, PointKinematics};
use crate::elements::beams::portions;
use crate::elements::beams::strain::{StrainPoint, Variation};
use crate::elements::laws::Response;
use crate::elements::{Local, LocalJacobian, LocalResidual, ReadingRow};
use crate::model::Variable;

/// An evaluation point at a state.
pub(super) struct At {
    pub kinematics: PointKinematics,
    pub now: Vector6<f64>,
    /// Its rate, zero if the law does not depend on it.
    pub rate: Vector6<f64>,
    /// Forces of the law and of the electrodes.
    pub response: Response<6>,
}

impl Beam {
    /// An evaluation point at a state.
    pub(super) fn at(
        &self,
        index: usize,
        nodal: &NodalKinematics,
        at: &Local<'_>,
        voltages: &[Voltage],
    ) -> At {
        let point = &self.points[index];
        let kinematics = nodal.at(&point.shape, point.reference.j0);
        let rate = if point.law.is_viscous() {
            self.strain_point(index, nodal).rate(at.nodes)
        } else {
            Vector6::zeros()
        };
        let mut found = At {
            now: point.reference.strain(&kinematics),
            kinematics,
            rate,
            response: Response::zero(),
        };
        let response = &mut found.response;
        (point.law).add(&found.now, &found.rate, &at.instant(), response);
        if !self.electrodes.is_empty() {
            response.force += self.electrodes.force(index, voltages);
        }
        found
    }

    /// An evaluation point with the variation of its strain.
    pub(super) fn strain_point<'a>(
        &'a self,
        index: usize,
        nodal: &'a NodalKinematics,
    ) -> StrainPoint<'a> {
        let point = &self.points[index];
        StrainPoint::new(nodal, &point.shape, point.reference.j0)
    }

    /// W of an evaluation point (D-23).
    fn test(&self, index: usize, strain: &StrainPoint<'_>) -> Test {
        match self.geometry.formulation {
            Formulation::Variational => strain.j0() * strain.variation,
            Formulation::FiniteVolume(_) => portions::test(index, &strain.section),
        }
    }

    /// Evaluation point of index `index` of a variational beam.
    fn evaluation_point<'a>(&'a self, index: usize, point: &'a At) -> EvaluationPoint<'a> {
        EvaluationPoint {
            shape: &self.points[index].shape,
            j0: self.points[index].reference.j0,
            point: &point.kinematics,
        }
    }

    /// Adds the forces on the nodes.
    pub(super) fn add_forces(
        &self,
        nodal: &NodalKinematics,
        points: &[At; 2],
        out: &mut LocalResidual,
    ) {
        let force = |index: usize| &points[index].response.force;
        if self.geometry.formulation == Formulation::Variational {
            let of = |index: usize| (self.evaluation_point(index, &points[index]), force(index));
            gradient::add_forces(nodal, &[of(0), of(1)], out);
            return;
        }
        for index in [0, 1] {
            let test = self.test(index, &self.strain_point(index, nodal));
            add_forces(&test, force(index), out);
        }
    }

    /// Adds the derivatives of the forces on the nodes, for section forces with the given slopes
    /// with respect to the strain at both points.
    pub(super) fn add_tangent(
        &self,
        (nodal, points): (&NodalKinematics, &[At; 2]),
        sections: [(&Vector6<f64>, &Matrix6<f64>); 2],
        out: &mut LocalJacobian,
    ) {
        let strains = [self.strain_point(0, nodal), self.strain_point(1, nodal)];
        let of = |index: usize| {
            let strain = &strains[index];
            (
                self.test(index, strain),
                sections[index].1 * strain.variation,
            )
        };
        add_tangent(&[of(0), of(1)], false, out);
        if self.geometry.formulation == Formulation::Variational {
            let of = |index: usize| {
                (
                    self.evaluation_point(index, &points[index]),
                    sections[index].0,
                )
            };
            gradient::add_geometric(nodal, &[of(0), of(1)], out);
            return;
        }
        for (index, (force, _)) in sections.into_iter().enumerate() {
            let [force, moment] = [0, 3].map(|row| force.fixed_rows::<3>(row).into_owned());
            portions::add_geometric(index, &strains[index].section, &force, &moment, out);
        }
    }

    /// Adds the derivatives of viscous forces, of forces by scalars, and of charges at an
    /// evaluation point.
    pub(super) fn add_more(
        &self,
        (index, point): (usize, &At),
        (nodal, at): (&NodalKinematics, &Local<'_>),
        out: &mut LocalJacobian,
    ) {
        let law = &self.points[index].law;
        if !law.is_viscous() && self.scalars.is_empty() {
            return;
        }
        let strain = self.strain_point(index, nodal);
        let test = self.test(index, &strain);
        if law.is_viscous() {
            let by_rate = &point.response.by_rate;
            let by_unknowns = by_rate * strain.rate_variation(at.nodes);
            add_tangent(&[(test, by_unknowns)], false, out);
            add_tangent(&[(test, by_rate * strain.variation)], true, out);
        }
        if self.scalars.is_empty() {
            return;
        }
        let (now, rate) = (&point.now, &point.rate);
        law.by_scalars(now, rate, &at.instant(), |scalar, q, of_rate| {
            add_column(&test, q, (scalar, of_rate), out);
        });
        self.electrodes.by_scalars(at, |k, scalar, slope| {
            let q = slope * self.electrodes.coupling(k, index);
            add_column(&test, &q, (scalar, false), out);
        });
        let variation = (&strain.variation, at);
        self.electrodes.add_charge_rows(index, variation, out);
    }

    /// Adds the derivatives of a component of the strain, or of the internal force, at an
    /// evaluation point.
    pub(super) fn add_reading(
        &self,
        index: usize,
        (point, variation): (&At, &StrainPoint<'_>),
        at: &Local<'_>,
        (strain, component): (bool, usize),
        row: &mut ReadingRow<'_>,
    ) {
        let mut add =
            |slopes: &RowVector6<f64>, variation: &Variation, variables: [Variable; 2]| {
                let product = slopes * variation;
                for (node, k) in (0..3).flat_map(|node| [(node, 0), (node, 1)]) {
                    let first = 6 * node + 3 * k;
                    let slope = Vector3::from_fn(|i, _| product[first + i]);
                    row.by_node(node, variables[k], &slope);
                }
            };
        const DISPLACEMENTS: [Variable; 2] = [Variable::Position, Variable::Rotation];
        const RATES: [Variable; 2] = [Variable::Velocity, Variable::AngularVelocity];
        let rates = variation;
        let variation = &variation.variation;
        if strain {
            let alone = RowVector6::from_fn(|_, j| f64::from(u8::from(j == component)));
            add(&alone, variation, DISPLACEMENTS);
            return;
        }
        let Response {
            by_strain, by_rate, ..
        } = &point.response;
        add(
            &by_strain.row(component).into_owned(),
            variation,
            DISPLACEMENTS,
        );
        let law = &self.points[index].law;
        if law.is_viscous() {
            let slopes = by_rate.row(component).into_owned();
            add(&slopes, &rates.rate_variation(at.nodes), DISPLACEMENTS);
            add(&slopes, variation, RATES);
        }
        law.by_scalars(
            &point.now,
            &point.rate,
            &at.instant(),
            |scalar, q, of_rate| {
                row.by_scalar((scalar, of_rate), q[component]);
            },
        );
        self.electrodes.by_scalars(at, |k, scalar, slope| {
            let coupling = self.electrodes.coupling(k, index)[component];
            row.by_scalar((scalar, false), slope * coupling);
        });
    }
}
