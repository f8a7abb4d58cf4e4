//! Growth of the tangent with the internal forces, at fixed geometry.
//!
//! Along a small motion of the nodes the internal forces grow by `R d F~` and
//! `R d M~`. The part of the tangent that is proportional to them is
//!
//! ```text
//! d F = -[F]x theta        d M = -[M]x theta
//! d[(P - x) x F] = [P - x]x d F - [F]x (d P - d x)
//! ```
//!
//! which is what the beam contributes to `K_1` of linearized buckling.
//!
//! References: [Masarati], the prestress matrix of the finite-volume beam.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew_times;

use super::{ElasticBeam, EvaluationPoint};
use crate::elements::beams::interpolation::NodalKinematics;
use crate::elements::beams::portions::{ByNode, Internal, NEIGHBORS};
use crate::elements::{Along, Local, LocalJacobian};

impl ElasticBeam {
    pub(super) fn add_prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (evaluation, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let internal = evaluation.internal(&nodal);
            let growth = evaluation.growth(&nodal, &internal, along);
            let variation = evaluation.prestress(&nodal, &growth);
            growth.add_tangent(&nodal, &evaluation.shape, &variation, neighbors, out);
        }
    }
}

impl EvaluationPoint {
    /// `R d F~` and `R d M~` along a motion.
    fn growth(&self, nodal: &NodalKinematics, at: &Internal, along: &Along<'_>) -> Internal {
        let relative = nodal.relative_variation();
        let theta = nodal.rotation_variation(&self.shape, &at.point, &relative);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        let mut turned = Vector3::zeros();
        for (j, by) in self.variation(nodal, &relative, at).iter().enumerate() {
            let [displacement, rotation] = &along.nodes[j];
            force += by.force[0] * displacement + by.force[1] * rotation;
            moment += by.moment[0] * displacement + by.moment[1] * rotation;
            turned += theta[j] * rotation;
        }
        // Without the turning of what there is already.
        Internal {
            point: at.point,
            force: force - turned.cross(&at.force),
            moment: moment - turned.cross(&at.moment),
        }
    }

    /// The variations that are proportional to the internal forces `at`.
    fn prestress(&self, nodal: &NodalKinematics, at: &Internal) -> [ByNode; 3] {
        let relative = nodal.relative_variation();
        let theta = nodal.rotation_variation(&self.shape, &at.point, &relative);
        let zero = Matrix3::zeros();
        std::array::from_fn(|j| ByNode {
            force: [zero, -skew_times(&at.force, &theta[j])],
            moment: [zero, -skew_times(&at.moment, &theta[j])],
        })
    }
}
