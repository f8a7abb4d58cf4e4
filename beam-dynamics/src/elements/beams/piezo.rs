//! The piezoelectric three-node finite-volume beam: what voltages of electrodes add to a
//! beam of any law, and the charge that they find there.
//!
//! At the evaluation points of [`super::ElasticBeam`], in section axes, with the columns
//! `Theta_k` of the coupling and the voltages `V_k` of the electrodes,
//!
//! ```text
//! [F~; M~] = law(eps, eps', t) + sum_k Theta_k V_k                             (D-260)
//! Q_k      = sum_points J0 ( -Theta_k . eps + sum_l C_kl V_l )                 (D-261)
//! E        = 1/2 sum_points J0 sum_kl V_k C_kl V_l                             (D-262)
//! ```
//!
//! The two points are the Gauss points of the beam, which integrate the strains of a beam
//! without loads between its nodes exactly. The forces on the nodes, by node and by portion
//! as those of the law, do on a motion of the nodes the work of a coupling that is the same
//! at both points,
//!
//! ```text
//! sum_nodes ( dF_k . v + dM_k . omega ) / d V_k = d Q_k / d t  at constant V  (D-263)
//! ```
//!
//! exactly for stretch, twist and bending, and for shear up to the square of the turning
//! within the beam: as near as its elastic energy is to the work of its forces.
//!
//! The variations by positions and rotations are those of [`super::LawBeam`] for forces
//! that do not depend on the strain; by the voltage they are the forces for one volt.
//!
//! References: [Masarati], piezoelectric beams.

use nalgebra::{DMatrix, Matrix3, Matrix6x3, RowVector3, Vector6};
use shared_geom::rotation::skew_times;

use super::elastic::ElasticBeam;
use super::geometry::{BeamGeometry, ReferencePoint};
use super::interpolation::{NodalKinematics, Shape};
use super::portions::{ByNode, Internal, NEIGHBORS};
use super::strain_rate::{ByNodes, StrainPoint};
use crate::elements::{
    Along, Charges, Element, Energy, Local, LocalJacobian, LocalResidual, Observations,
};
use crate::model::Equation::{Force, Moment};
use crate::model::{Drive, Node, NodeMotion, Variable};

/// Where the voltage of an electrode comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Potential {
    /// It is given over time [V].
    Held(Drive),
    /// It is an unknown of the model.
    Free {
        /// Number of the electric unknown.
        unknown: usize,
    },
}

/// An electrode on a beam.
#[derive(Debug, Clone, PartialEq)]
pub struct BeamElectrode {
    /// Its number among the electrodes of the model.
    pub number: usize,
    /// Its voltage.
    pub potential: Potential,
    /// Internal force for one volt at the two evaluation points, section axes
    /// [N/V, N m/V].
    pub coupling: [Vector6<f64>; 2],
    /// Capacitance of the whole electrode, by which the equation of its charge is divided
    /// [F].
    pub capacitance: f64,
}

/// A beam through three nodes with electrodes.
#[derive(Debug)]
pub struct PiezoBeam {
    /// The beam without its electrodes.
    beam: Box<dyn Element>,
    geometry: BeamGeometry,
    points: [PiezoPoint; 2],
    electrodes: Vec<BeamElectrode>,
    /// The electric unknowns, in the order of the electrodes that have one.
    unknowns: Vec<usize>,
}

#[derive(Debug)]
struct PiezoPoint {
    shape: Shape,
    reference: ReferencePoint,
    /// Electrodes x electrodes [F/m].
    capacitance: DMatrix<f64>,
}

/// A voltage, and its place among the rows of the element where it is unknown.
struct Voltage {
    value: f64,
    row: Option<usize>,
}

impl PiezoBeam {
    /// The `beam` on the `undeformed` nodes with `electrodes`, the capacitance of which
    /// (electrodes x electrodes, in their order) is given at the evaluation points [F/m].
    pub fn new(
        beam: Box<dyn Element>,
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        electrodes: Vec<BeamElectrode>,
        capacitance: [DMatrix<f64>; 2],
    ) -> Self {
        let places = ElasticBeam::evaluation_points();
        let [first, second] = capacitance;
        let point = |xi: f64, capacitance: DMatrix<f64>| PiezoPoint {
            shape: Shape::at(xi),
            reference: geometry.reference_point(&undeformed, xi),
            capacitance,
        };
        let unknown = |electrode: &BeamElectrode| match electrode.potential {
            Potential::Held(_) => None,
            Potential::Free { unknown } => Some(unknown),
        };
        Self {
            beam,
            geometry,
            points: [point(places[0], first), point(places[1], second)],
            unknowns: electrodes.iter().filter_map(unknown).collect(),
            electrodes,
        }
    }

    /// Capacitance of a beam whose capacitance per length is given at the evaluation points
    /// [F].
    pub fn capacitance(
        geometry: &BeamGeometry,
        undeformed: [&Node; 3],
        per_length: [f64; 2],
    ) -> f64 {
        let places = ElasticBeam::evaluation_points().into_iter();
        let points = places.map(|xi| geometry.reference_point(&undeformed, xi).j0);
        points.zip(per_length).map(|(j0, value)| j0 * value).sum()
    }

    fn voltages(&self, at: &Local<'_>) -> Vec<Voltage> {
        let mut rows = self.beam.multipliers()..;
        let of = |electrode: &BeamElectrode| match &electrode.potential {
            Potential::Held(drive) => Voltage {
                value: at.loading.voltages * drive.at(at.loading.time).value,
                row: None,
            },
            Potential::Free { unknown } => Voltage {
                value: at.electric.values[*unknown],
                row: rows.next(),
            },
        };
        self.electrodes.iter().map(of).collect()
    }

    /// Force of all electrodes at an evaluation point, section axes.
    fn force(&self, point: usize, voltages: &[Voltage]) -> Vector6<f64> {
        let pairs = self.electrodes.iter().zip(voltages);
        pairs
            .map(|(electrode, voltage)| electrode.coupling[point] * voltage.value)
            .sum()
    }

    fn strains(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        self.points.each_ref().map(|point| {
            let reference = &point.reference;
            reference.strain(&nodal.at(&point.shape, reference.j0))
        })
    }

    /// The terms of the charge of the electrode number `k` of the beam that hang on the
    /// strains, and that of each voltage.
    fn charge(&self, k: usize, voltages: &[Voltage], strains: &[Vector6<f64>; 2]) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for (i, (point, strain)) in self.points.iter().zip(strains).enumerate() {
            let j0 = point.reference.j0;
            sums[0] -= j0 * self.electrodes[k].coupling[i].dot(strain);
            for (l, voltage) in voltages.iter().enumerate() {
                sums[1] += j0 * point.capacitance[(k, l)] * voltage.value;
            }
        }
        sums
    }

    /// Derivatives by positions and rotations of the forces at a point and of the charges.
    fn add_by_nodes(
        &self,
        i: usize,
        nodal: &NodalKinematics,
        voltages: &[Voltage],
        out: &mut LocalJacobian,
    ) {
        let point = &self.points[i];
        let strain = StrainPoint::new(nodal, &point.shape, point.reference.j0);
        let internal = internal(&strain, &self.force(i, voltages));
        let by = turning(&strain, &internal);
        internal.add_tangent(nodal, &point.shape, &by, NEIGHBORS[i], out);
        let variation = strain.variation();
        for (k, voltage) in voltages.iter().enumerate() {
            let Some(row) = voltage.row else { continue };
            let weight = point.reference.j0 / self.electrodes[k].capacitance;
            add_rows(
                row,
                &(weight * self.electrodes[k].coupling[i]),
                &variation,
                out,
            );
        }
    }

    /// Derivatives by the voltages of the forces at a point and of the charges.
    fn add_by_voltages(
        &self,
        i: usize,
        nodal: &NodalKinematics,
        voltages: &[Voltage],
        out: &mut LocalJacobian,
    ) {
        let point = &self.points[i];
        let strain = StrainPoint::new(nodal, &point.shape, point.reference.j0);
        for (k, voltage) in voltages.iter().enumerate() {
            let Some(column) = voltage.row else { continue };
            let of_volt = internal(&strain, &self.electrodes[k].coupling[i]);
            let (plus, minus) = NEIGHBORS[i];
            for (node, sign) in [(plus, 1.0), (minus, -1.0)] {
                let arm = of_volt.point.p - nodal.x[node];
                let moment = sign * (of_volt.moment + arm.cross(&of_volt.force));
                out.add_multiplier((node, Force), column, &(sign * of_volt.force));
                out.add_multiplier((node, Moment), column, &moment);
            }
            for (l, other) in voltages.iter().enumerate() {
                let Some(row) = other.row else { continue };
                let charge = point.reference.j0 * point.capacitance[(l, k)];
                out.add_electric(row, column, -charge / self.electrodes[l].capacitance, false);
            }
        }
    }
}

/// Force and moment in the model's axes of a force in section axes.
fn internal(strain: &StrainPoint<'_>, section: &Vector6<f64>) -> Internal {
    let point = strain.point;
    Internal {
        point,
        force: point.r * section.fixed_rows::<3>(0),
        moment: point.r * section.fixed_rows::<3>(3),
    }
}

/// `d F = -[F]x theta`, `d M = -[M]x theta` by position and rotation of each node.
fn turning(strain: &StrainPoint<'_>, at: &Internal) -> [ByNode; 3] {
    let zero = Matrix3::zeros();
    std::array::from_fn(|j| ByNode {
        force: [zero, -skew_times(&at.force, &strain.theta[j])],
        moment: [zero, -skew_times(&at.moment, &strain.theta[j])],
    })
}

/// Adds `column . d eps` to an equation.
fn add_rows(row: usize, column: &Vector6<f64>, variation: &ByNodes, out: &mut LocalJacobian) {
    const UNKNOWNS: [Variable; 2] = [Variable::Position, Variable::Rotation];
    for (node, by) in variation.iter().enumerate() {
        for (variable, by) in UNKNOWNS.into_iter().zip(by) {
            let by: &Matrix6x3<f64> = by;
            let values: RowVector3<f64> = column.transpose() * by;
            out.add_constraint(row, (node, variable), &values);
        }
    }
}

impl Element for PiezoBeam {
    fn label(&self) -> &str {
        self.beam.label()
    }

    fn nodes(&self) -> &[usize] {
        self.beam.nodes()
    }

    fn electric(&self) -> &[usize] {
        &self.unknowns
    }

    fn joins_nodes(&self) -> bool {
        self.beam.joins_nodes()
    }

    fn domain(&self) -> [f64; 2] {
        let own = Drive::common_domain(self.held());
        let of_beam = self.beam.domain();
        [own[0].max(of_beam[0]), own[1].min(of_beam[1])]
    }

    fn next_corner(&self, time: f64) -> f64 {
        let corners = self.held().map(|drive| drive.next_corner(time));
        corners.fold(self.beam.next_corner(time), f64::min)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let mut energy = self.beam.energy(at);
        let voltages = self.voltages(at);
        for k in 0..voltages.len() {
            let [_, charge] = self.charge(k, &voltages, &[Vector6::zeros(); 2]);
            energy.electric += 0.5 * voltages[k].value * charge;
        }
        energy
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.beam.residual(at, out);
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let voltages = self.voltages(at);
        for (i, neighbors) in NEIGHBORS.into_iter().enumerate() {
            let point = &self.points[i];
            let strain = StrainPoint::new(&nodal, &point.shape, point.reference.j0);
            internal(&strain, &self.force(i, &voltages)).add_forces(&nodal, neighbors, out);
        }
        let strains = self.strains(at.nodes);
        for (k, voltage) in voltages.iter().enumerate() {
            let Some(row) = voltage.row else { continue };
            for part in self.charge(k, &voltages, &strains) {
                out.add_constraint(row, -part / self.electrodes[k].capacitance);
            }
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        self.beam.jacobian(at, out);
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let voltages = self.voltages(at);
        for i in 0..self.points.len() {
            self.add_by_nodes(i, &nodal, &voltages, out);
            self.add_by_voltages(i, &nodal, &voltages, out);
        }
    }

    /// What the beam says, and the turning of the forces of voltages that grow along the
    /// motion.
    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        self.beam.prestress(at, along, out);
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let growth = self.electrodes.iter().map(|electrode| {
            let unknown = match electrode.potential {
                Potential::Held(_) => None,
                Potential::Free { unknown } => Some(unknown),
            };
            let place = self.unknowns.iter().position(|own| Some(*own) == unknown);
            place.map_or(0.0, |place| along.electric[place])
        });
        let growth: Vec<_> = growth.map(|value| Voltage { value, row: None }).collect();
        for (i, neighbors) in NEIGHBORS.into_iter().enumerate() {
            let point = &self.points[i];
            let strain = StrainPoint::new(&nodal, &point.shape, point.reference.j0);
            let grown = internal(&strain, &self.force(i, &growth));
            let by = turning(&strain, &grown);
            grown.add_tangent(&nodal, &point.shape, &by, neighbors, out);
        }
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let first = out.sections.len();
        self.beam.observe(at, out);
        let voltages = self.voltages(at);
        for (i, section) in out.sections[first..].iter_mut().enumerate() {
            section.internal_force += self.force(i, &voltages);
        }
    }

    fn charges(&self, at: &Local<'_>, out: &mut Charges) {
        let voltages = self.voltages(at);
        let strains = self.strains(at.nodes);
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let rates = self.points.each_ref().map(|point| {
            let strain = StrainPoint::new(&nodal, &point.shape, point.reference.j0);
            StrainPoint::rate(&strain.variation(), at.nodes)
        });
        for (k, electrode) in self.electrodes.iter().enumerate() {
            let number = electrode.number;
            let [by_strain, _] = self.charge(k, &voltages, &strains);
            let [rate, _] = self.charge(k, &voltages, &rates);
            out.by_strain.push((number, by_strain, rate));
            for (l, other) in self.electrodes.iter().enumerate() {
                let points = self.points.iter();
                let sum = points.map(|point| point.reference.j0 * point.capacitance[(k, l)]);
                out.capacitance.push((number, other.number, sum.sum()));
            }
        }
    }
}

impl PiezoBeam {
    /// The drives of voltages that are given.
    fn held(&self) -> impl Iterator<Item = &Drive> {
        let electrodes = self.electrodes.iter();
        electrodes.filter_map(|electrode| match &electrode.potential {
            Potential::Held(drive) => Some(drive),
            Potential::Free { .. } => None,
        })
    }
}
