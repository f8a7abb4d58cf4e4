//! Mass along a three-node beam: integration points, and rigid bodies.
//!
//! With the mass m, the first moment S and the inertia J per length, about the reference line
//! and turned into the axes of node j, the body of a variational beam at that node is
//!
//! ```text
//! m_j = int N_j m ds
//! s_j = m_j f_j + int N_j S ds
//! J_j = int N_j J ds - m_j [f_j]x[f_j]x - [f_j]x[S_j]x - [S_j]x[f_j]x ,  S_j = int N_j S ds
//! ```
//!
//! by which a uniform beam gives 1/6, 4/6 and 1/6 of its mass to its nodes. Mass and center are
//! exact, on straight elements with a centered middle node the second moment too, and frequencies
//! are of fourth order. If the mass jumps and the weights belong to no physical body, hat
//! functions replace N_j in that element, and the order is two.
//!
//! The body of a finite volume is the rigid portion between the evaluation points, with
//! arms `b = p - x_j`.

use nalgebra::{Matrix3, Matrix6, Vector3};
use shared_geom::quadrature;
use shared_geom::rotation::skew;

use super::attachment::{BeamGeometry, EVALUATION_POINTS, Formulation};
use super::interpolation::{NodalKinematics, Shape};
use crate::elements::bodies::RigidInertia;
use crate::model::{Node, NodeMotion};

/// Gauss points of bodies: products of two quadratic shape functions, an arm and a varying
/// property are integrated exactly on straight beams.
const BODY_POINTS: usize = 4;
/// Inertia relative to the largest of its node below which it is treated as zero, of either sign.
const NO_INERTIA: f64 = 1e-12;

/// Mass per length along a beam.
#[derive(Clone, Copy)]
pub struct MassAlong<'a> {
    /// 6x6 mass per length at xi, section axes [kg/m, kg, kg m].
    pub at: &'a dyn Fn(f64) -> Matrix6<f64>,
    /// Positions xi between -1 and 1, ascending, where the mass has a kink or a jump: the integrals
    /// are split there [-].
    pub breaks: &'a [f64],
    /// Length of the line that the beam represents, evenly along xi; `None` for the length of the
    /// curve through the nodes [m].
    pub length: Option<f64>,
}

impl std::fmt::Debug for MassAlong<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("MassAlong")
            .field("breaks", &self.breaks)
            .field("length", &self.length)
            .finish_non_exhaustive()
    }
}

impl<'a> MassAlong<'a> {
    /// A mass that is smooth in xi, on the curve through the nodes.
    pub fn smooth(at: &'a dyn Fn(f64) -> Matrix6<f64>) -> Self {
        Self {
            at,
            breaks: &[],
            length: None,
        }
    }
}

/// Mass, first moment and inertia of the length that a point of the undeformed beam represents.
#[derive(Debug, Clone)]
pub(super) struct MassPoint {
    /// Position along the beam [-].
    pub xi: f64,
    /// Portion, hence node, to which the point belongs.
    pub portion: usize,
    pub shape: Shape,
    /// Undeformed length per unit of xi [m].
    pub j0: f64,
    /// Mass [kg].
    pub mass: f64,
    /// First moment, section axes [kg m].
    pub first_moment: Vector3<f64>,
    /// Moment of inertia about the reference line, section axes [kg m^2].
    pub inertia: Matrix3<f64>,
}

/// Portion in which xi lies: number of evaluation points before it.
pub(super) fn portion_of(xi: f64) -> usize {
    EVALUATION_POINTS
        .iter()
        .filter(|position| xi > **position)
        .count()
}

/// Points and weights between -1, 1, the `breaks` and, in finite volumes, the evaluation
/// points.
pub(super) fn intervals(formulation: Formulation, breaks: &[f64]) -> Vec<[f64; 2]> {
    let mut limits = vec![-1.0, 1.0];
    limits.extend(breaks.iter().filter(|xi| xi.abs() < 1.0));
    if let Formulation::FiniteVolume(_) = formulation {
        limits.extend(EVALUATION_POINTS);
    }
    limits.sort_by(f64::total_cmp);
    let pairs = limits.windows(2).map(|pair| [pair[0], pair[1]]);
    pairs.filter(|[from, to]| to > from).collect()
}

/// The points at which the mass is integrated, `number` between two limits.
pub(super) fn mass_points(
    geometry: &BeamGeometry,
    undeformed: &[&Node; 3],
    mass: &MassAlong<'_>,
    number: usize,
) -> Vec<MassPoint> {
    let mut points = Vec::new();
    for [from, to] in intervals(geometry.formulation, mass.breaks) {
        let half = 0.5 * (to - from);
        let middle = 0.5 * (to + from);
        for (abscissa, weight) in quadrature::line(number) {
            let xi = middle + half * abscissa;
            let j0 = geometry.reference_point(undeformed, xi).j0;
            let length = weight * half * mass.length.map_or(j0, |length| 0.5 * length);
            let m = length * (mass.at)(xi);
            points.push(MassPoint {
                xi,
                portion: portion_of(middle),
                shape: Shape::at(xi),
                j0,
                mass: m[(0, 0)],
                // The momentum of a rotation is omega x S = -[S]x omega.
                first_moment: Vector3::new(0.5 * (m[(1, 5)] - m[(2, 4)]), -m[(0, 5)], m[(0, 4)]),
                inertia: m.fixed_view::<3, 3>(3, 3).into_owned(),
            });
        }
    }
    points
}

/// Lumped inertia of a beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LumpedMass {
    /// A rigid inertia for each of the three nodes, about the node and in its axes.
    pub bodies: [RigidInertia; 3],
    /// Whether hat functions replace the shape functions, because the mass jumps within the
    /// element.
    pub by_hats: bool,
}

/// The mass of a beam as rigid bodies at its nodes.
pub fn lumped_bodies(
    geometry: &BeamGeometry,
    undeformed: [&Node; 3],
    mass: &MassAlong<'_>,
) -> LumpedMass {
    let points = mass_points(geometry, &undeformed, mass, BODY_POINTS);
    let sum =
        |weights: &dyn Fn(&MassPoint) -> [f64; 3]| bodies(geometry, undeformed, &points, weights);
    if let Formulation::FiniteVolume(_) = geometry.formulation {
        let own =
            |point: &MassPoint| std::array::from_fn(|j| f64::from(u8::from(j == point.portion)));
        return LumpedMass {
            bodies: sum(&own),
            by_hats: false,
        };
    }
    let by_shape = sum(&|point| point.shape.n);
    if by_shape.iter().all(is_body) {
        return LumpedMass {
            bodies: by_shape,
            by_hats: false,
        };
    }
    let hats = |point: &MassPoint| {
        let xi = point.xi;
        [(-xi).max(0.0), 1.0 - xi.abs(), xi.max(0.0)]
    };
    LumpedMass {
        bodies: sum(&hats),
        by_hats: true,
    }
}

fn bodies(
    geometry: &BeamGeometry,
    undeformed: [&Node; 3],
    points: &[MassPoint],
    weights: &dyn Fn(&MassPoint) -> [f64; 3],
) -> [RigidInertia; 3] {
    let motion = undeformed.map(NodeMotion::at_rest);
    let nodal = NodalKinematics::new(geometry, &motion);
    let mut bodies = [RigidInertia::zero(); 3];
    for point in points {
        let position = nodal.at(&point.shape, point.j0);
        for (j, weight) in weights(point).into_iter().enumerate() {
            let into_node = undeformed[j].rotation.transpose();
            let at = match geometry.formulation {
                Formulation::Variational => nodal.p[j],
                Formulation::FiniteVolume(_) => position.p,
            };
            let b = into_node * (at - undeformed[j].position);
            let r = into_node * position.r;
            let s = r * point.first_moment;
            let (arm, moment) = (skew(&b), skew(&s));
            bodies[j].mass += weight * point.mass;
            bodies[j].first_moment += weight * (point.mass * b + s);
            // int -[b + r]x [b + r]x dm, with int r dm = S and -int [r]x [r]x dm = J.
            let about_node = r * point.inertia * r.transpose()
                - point.mass * arm * arm
                - arm * moment
                - moment * arm;
            bodies[j].inertia += weight * about_node;
        }
    }
    bodies
}

/// Whether an inertia is physical: no negative mass, no negative moment about the center of mass.
fn is_body(body: &RigidInertia) -> bool {
    let inertia = 0.5 * (body.inertia + body.inertia.transpose());
    let arm = skew(&body.first_moment);
    let about_center = if body.mass > 0.0 {
        inertia + arm * arm / body.mass
    } else {
        inertia
    };
    let is_mass = body.mass > 0.0 || (body.mass == 0.0 && body.first_moment.norm() == 0.0);
    let least = -NO_INERTIA * inertia.symmetric_eigenvalues().amax();
    is_mass && about_center.symmetric_eigenvalues().min() >= least
}
