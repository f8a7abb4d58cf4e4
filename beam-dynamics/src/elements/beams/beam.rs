//! The geometrically exact three-node beam of any section law, with electrodes or without.
//!
//! At the evaluation points I and II (xi = -+1/sqrt 3), in section axes, with the strain
//! `eps = [nu; kappa]` and its rate (see [`super::strain`]),
//!
//! ```text
//! nu = R^T l - (R^T l)_ref                kappa = T(psi)^T psi' - (T^T psi')_ref
//! q  = [F~; M~] = law(eps, eps', t) + sum_k Theta_k V_k
//! d q = C d eps + V d eps' + sum_k Theta_k d V_k          C, V: slopes of the law
//! ```
//!
//! The forces on the nodes and their variations follow from q by the formulation of the
//! beam (see [`super::formulation`]). The two points are the Gauss points of the line: the
//! elastic energy is `sum W(eps) J0`, and the beam of constant properties is exact at its ends
//! under loads at its ends.
//!
//! References: [Masarati], the three-node beam (5.2-5.4).

use std::sync::Arc;

use nalgebra::{DMatrix, Matrix6, Vector3, Vector6};

use super::attachment::{BeamGeometry, EVALUATION_POINTS, Formulation};
use super::electrodes::{BeamElectrode, Electrodes};
use super::geometry::ReferencePoint;
use super::interpolation::{LARGEST, NodalKinematics, Shape};
use crate::elements::laws::{Law, Response};
use crate::elements::{
    Charges, Element, Energetic, Energy, EnergySlope, Exchange, Growth, Local, LocalJacobian,
    LocalResidual, Motion, Observations, Reading, ReadingRow, Reports, SectionState, Signal,
    SmallMotion, Structure, has,
};
use crate::model::{Node, NodeMotion, Scalar};

mod evaluation;

/// A geometrically exact beam through three nodes.
#[derive(Debug, Clone)]
pub struct Beam {
    label: Arc<str>,
    nodes: [usize; 3],
    geometry: BeamGeometry,
    points: [Point; 2],
    electrodes: Electrodes,
    /// Signals of the laws and the electrodes.
    scalars: Vec<Scalar>,
}

#[derive(Debug, Clone)]
struct Point {
    shape: Shape,
    reference: ReferencePoint,
    law: Law<6>,
}

impl Beam {
    /// A beam on nodes number `nodes`, undeformed at `undeformed`, with the laws at the
    /// evaluation points xi = -1/sqrt 3 and 1/sqrt 3.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        laws: [Law<6>; 2],
    ) -> Self {
        let mut scalars = Vec::new();
        let [first, second] = laws.map(|mut law| {
            law.bind(&mut scalars);
            law
        });
        let point = |index: usize, law: Law<6>| Point {
            shape: Shape::at(EVALUATION_POINTS[index]),
            reference: geometry.reference_point(&undeformed, EVALUATION_POINTS[index]),
            law,
        };
        Self {
            label: Arc::from(label.into()),
            nodes,
            geometry,
            points: [point(0, first), point(1, second)],
            electrodes: Electrodes::default(),
            scalars,
        }
    }

    /// A beam of linear elastic sections, with the stiffness given at the evaluation points
    /// [N, N m, N m^2].
    pub fn elastic(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        stiffness: [Matrix6<f64>; 2],
    ) -> Self {
        let laws = stiffness.map(Law::linear);
        Self::new(label, nodes, geometry, undeformed, laws)
    }

    /// The same with electrodes, whose capacitance (electrodes x electrodes, in their order) is
    /// given at the evaluation points [F/m].
    #[must_use]
    pub fn with_electrodes(
        mut self,
        electrodes: Vec<BeamElectrode>,
        capacitance: [DMatrix<f64>; 2],
    ) -> Self {
        let lengths = self.points.each_ref().map(|point| point.reference.j0);
        let scalars = &mut self.scalars;
        self.electrodes = Electrodes::new(electrodes, capacitance, lengths, scalars);
        self
    }

    /// xi of the two evaluation points.
    pub fn evaluation_points() -> [f64; 2] {
        EVALUATION_POINTS
    }

    /// Attachment of the beam to its nodes.
    pub fn geometry(&self) -> BeamGeometry {
        self.geometry
    }

    /// Generalized strains at the two evaluation points, section axes, for the given
    /// motion of the three nodes [-, 1/m].
    pub fn strains(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        let strain = |point: &Point| {
            let reference = &point.reference;
            reference.strain(&nodal.at(&point.shape, reference.j0))
        };
        self.points.each_ref().map(strain)
    }

    /// Rates of the generalized strains at the two evaluation points, section axes, for
    /// the given motion of the three nodes [1/s, 1/(m s)].
    pub fn strain_rates(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        [0, 1].map(|index| self.strain_point(index, &nodal).rate(nodes))
    }

    /// Internal forces at the two evaluation points at a state, section axes [N, N m].
    pub fn internal_forces(&self, at: &Local<'_>) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let voltages = self.electrodes.voltages(at);
        [0, 1].map(|index| self.at(index, &nodal, at, &voltages).response.force)
    }
}

impl Element for Beam {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        let laws = self.points.iter().flat_map(|point| point.law.signals());
        laws.chain(self.electrodes.signals()).for_each(visit);
    }

    fn has_kinks(&self) -> bool {
        self.points.iter().any(|point| point.law.has_kinks())
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let voltages = self.electrodes.voltages(at);
        let points = [
            self.at(0, &nodal, at, &voltages),
            self.at(1, &nodal, at, &voltages),
        ];
        self.add_forces(&nodal, &points, out);
        if !self.electrodes.is_empty() {
            let strains = [points[0].now, points[1].now];
            self.electrodes.add_charges(&voltages, &strains, out);
        }
        if let Some(out) = jacobian {
            let sections = points.each_ref().map(|point| {
                let Response {
                    force, by_strain, ..
                } = &point.response;
                (force, by_strain)
            });
            self.add_tangent((&nodal, &points), sections, out);
            for (index, point) in points.iter().enumerate() {
                self.add_more((index, point), (&nodal, at), out);
            }
        }
    }

    has!(energetic: Energetic, growth: Growth, structure: Structure, reports: Reports);
}

impl Energetic for Beam {
    fn stored(&self, at: &Local<'_>) -> Energy {
        let strains = self.strains(at.nodes);
        let of_point = |(point, strain): (&Point, &Vector6<f64>)| {
            point.law.energy(strain, &at.instant()) * point.reference.j0
        };
        Energy {
            elastic: self.points.iter().zip(&strains).map(of_point).sum(),
            electric: self.electrodes.energy(&self.electrodes.voltages(at)),
            ..Energy::default()
        }
    }

    fn exchanged(&self) -> Exchange {
        let laws = || self.points.iter().map(|point| &point.law);
        let is_driven = !self.electrodes.is_empty() || !laws().all(Law::keeps_energy);
        Exchange::of(laws().any(Law::is_viscous), is_driven)
    }

    fn is_conservative(&self) -> bool {
        self.geometry.formulation == Formulation::Variational
    }

    fn slope(&self) -> EnergySlope {
        let mut laws = self.points.iter().map(|point| &point.law);
        let is_driven = !self.electrodes.is_empty() || !laws.all(Law::keeps_energy);
        if self.is_conservative() && !is_driven {
            EnergySlope::Forces
        } else {
            EnergySlope::Unknown
        }
    }
}

impl Growth for Beam {
    fn add_by_factor(&self, _at: &Local<'_>, _out: &mut LocalResidual) {}

    /// The part proportional to the internal forces, for their growth along the motion, with the
    /// stiffness of the section if it grows with the strain.
    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let voltages = self.electrodes.voltages(at);
        let growth = self.electrodes.growth(motion);
        let points = [
            self.at(0, &nodal, at, &voltages),
            self.at(1, &nodal, at, &voltages),
        ];
        let grown = [0, 1].map(|index| {
            let strain = (self.strain_point(index, &nodal)).along(|j| motion.nodes[j]);
            let by_strain = &points[index].response.by_strain;
            let force = by_strain * strain + self.electrodes.force(index, &growth);
            (force, self.points[index].law.growth_of_stiffness(&strain))
        });
        let sections = grown.each_ref().map(|(force, stiffer)| (force, stiffer));
        self.add_tangent((&nodal, &points), sections, out);
    }
}

impl Structure for Beam {
    fn arm(&self) -> f64 {
        let offsets = self.geometry.nodes.iter().map(|node| node.offset.norm());
        offsets.fold(0.0, f64::max)
    }

    fn is_joining(&self) -> bool {
        true
    }

    fn free_motions(&self) -> Vec<Motion> {
        Vec::new()
    }

    fn loaded_turn(&self, _at: &Local<'_>) -> Option<Vector3<f64>> {
        None
    }

    fn undefined(&self, at: &Local<'_>) -> Option<String> {
        let turn = NodalKinematics::largest_turn(&self.geometry, at.nodes);
        (turn > LARGEST).then(|| {
            format!(
                "its ends turn by {:.2} deg against its middle, one element can follow less than {:.0} deg",
                turn.to_degrees(),
                LARGEST.to_degrees()
            )
        })
    }
}

impl Reports for Beam {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let voltages = self.electrodes.voltages(at);
        let turn = NodalKinematics::largest_turn(&self.geometry, at.nodes);
        for (index, xi) in EVALUATION_POINTS.into_iter().enumerate() {
            let point = self.at(index, &nodal, at, &voltages);
            let law = &self.points[index].law;
            out.sections.push(SectionState {
                beam: Arc::clone(&self.label),
                xi,
                position: point.kinematics.p,
                axes: point.kinematics.r,
                strain: point.now,
                internal_force: point.response.force,
                change_of_stiffness: law.change_by_prestress(&point.now, &at.instant()),
                turn,
            });
        }
    }

    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        let Reading::Section {
            point,
            strain,
            component,
        } = *reading
        else {
            return None;
        };
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let voltages = self.electrodes.voltages(at);
        let found = self.at(point, &nodal, at, &voltages);
        if let Some(row) = row {
            let variation = self.strain_point(point, &nodal);
            self.add_reading(point, (&found, &variation), at, (strain, component), row);
        }
        Some(if strain {
            found.now[component]
        } else {
            found.response.force[component]
        })
    }

    fn report_charges(&self, at: &Local<'_>, out: &mut Charges) {
        if self.electrodes.is_empty() {
            return;
        }
        let rates = self.strain_rates(at.nodes);
        self.electrodes.report(&self.strains(at.nodes), &rates, out);
    }
}
