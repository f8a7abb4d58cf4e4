//! Distributed loads of a three-node beam.
//!
//! With the force q and the moment m per undeformed length, times the load's factor, the
//! nodes of a variational beam get the work-equivalent
//!
//! ```text
//! force on node j    int N_j q ds
//! moment on node j   int [N_j f_j x q + T_j^T m] ds
//! ```
//!
//! (see [`super::variational`]), and the nodes of finite volumes the resultants on their portions
//! (see [`super::portions`]). A uniform load bends either beam exactly at its nodes.
//!
//! A dead load keeps the direction of q and m, a follower one turns with the section, `q = R R_0^T
//! q_0`, `d q = -[q]x theta`, `d m = -[m]x theta`. The load may be multiplied by a signal, which
//! depends on time and on sensors.
//!
//! References: [Masarati], the three-node finite-volume beam: external loads.

use nalgebra::{Matrix3, Vector3};
use shared_geom::quadrature;
use shared_geom::rotation::skew_times;

use super::attachment::BeamGeometry;
use super::forces::LineForce;
use super::interpolation::{NodalKinematics, Shape};
use super::mass::{intervals, portion_of};
use super::strain::SectionPoint;
use crate::elements::loads::{Add, Head, Load, LoadFactor, Turning};
use crate::elements::{Local, LocalJacobian, Signal};
use crate::model::Node;

/// Gauss points between two neighboring limits: exact for a load of the fifth degree
/// on a straight beam, whose arm and shape functions are quadratic.
const POINTS: usize = 4;

/// Force [N/m] and moment [N m/m] per undeformed length at xi on the undeformed beam, model's axes.
pub type LineLoad = [Vector3<f64>; 2];

/// A load along a beam.
#[derive(Debug, Clone)]
pub struct DistributedLoad {
    head: Head,
    geometry: BeamGeometry,
    turning: Turning,
    points: Vec<LoadPoint>,
}

/// A piece of the load.
#[derive(Debug, Clone)]
struct LoadPoint {
    /// Portion, hence node, on which it acts.
    portion: usize,
    shape: Shape,
    /// Undeformed length per unit of xi [m].
    j0: f64,
    /// Force [N] and moment [N m] of the piece; of a follower in section axes.
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

impl DistributedLoad {
    /// The load `load(xi)` on a beam on nodes number `nodes`, undeformed at `undeformed`. `kinks`
    /// are the positions xi where the load is not smooth.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        (turning, factor): (Turning, LoadFactor),
        kinks: &[f64],
        load: impl Fn(f64) -> LineLoad,
    ) -> Self {
        let mut points = Vec::new();
        for [from, to] in intervals(geometry.formulation, kinks) {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            for (abscissa, weight) in quadrature::line(POINTS) {
                let xi = middle + half * abscissa;
                let reference = geometry.reference_point(&undeformed, xi);
                let length = weight * half * reference.j0;
                let into = match turning {
                    Turning::Dead => Matrix3::identity(),
                    Turning::Follower => reference.r.transpose(),
                };
                let [force, moment] = load(xi).map(|value| length * (into * value));
                points.push(LoadPoint {
                    portion: portion_of(middle),
                    shape: Shape::at(xi),
                    j0: reference.j0,
                    force,
                    moment,
                });
            }
        }
        Self {
            head: Head::new(label, nodes.to_vec(), factor),
            geometry,
            turning,
            points,
        }
    }

    /// The load times a signal.
    #[must_use]
    pub fn driven(mut self, signal: Signal) -> Self {
        self.head.drive(signal);
        self
    }

    /// A piece of the load at the current state, times a factor.
    fn acting(&self, piece: &LoadPoint, at: &SectionPoint<'_>, factor: f64) -> LineForce {
        let is_follower = self.turning == Turning::Follower;
        let [force, moment] = [&piece.force, &piece.moment].map(|of| {
            if is_follower {
                factor * (at.point.r * of)
            } else {
                factor * of
            }
        });
        let turned = |of: &Vector3<f64>| at.theta.map(|theta| -skew_times(of, &theta));
        LineForce {
            by_rotation: is_follower.then(|| [turned(&force), turned(&moment)]),
            force,
            moment,
        }
    }

    /// Calls `user` with every piece of the load, times a factor.
    fn each(
        &self,
        at: &Local<'_>,
        factor: f64,
        mut user: impl FnMut(usize, &SectionPoint<'_>, &LineForce),
    ) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for piece in &self.points {
            let section = SectionPoint::new(&nodal, &piece.shape, piece.j0);
            user(
                piece.portion,
                &section,
                &self.acting(piece, &section, factor),
            );
        }
    }
}

impl Load for DistributedLoad {
    fn head(&self) -> &Head {
        &self.head
    }

    fn add(&self, size: f64, at: &Local<'_>, add: &mut Add<'_>) {
        let formulation = self.geometry.formulation;
        self.each(at, size, |portion, section, load| {
            formulation.add_on_line(portion, section, load, &mut *add);
        });
    }

    fn add_variation(&self, size: f64, at: &Local<'_>, out: &mut LocalJacobian) {
        let formulation = self.geometry.formulation;
        self.each(at, size, |portion, section, load| {
            formulation.add_on_line_variation(portion, section, load, out);
        });
    }
}
