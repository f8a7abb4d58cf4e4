//! Loads along a three-node beam: resultants on its portions.
//!
//! Portion k reaches between the evaluation points around node k, as for inertia. With
//! the force q and the moment m per undeformed length, times the load's factor,
//!
//! ```text
//! force on node k    int_k q ds
//! moment on node k   int_k [(p - x_k) x q + m] ds        p = N_j p_j
//! ```
//!
//! A dead load keeps the direction of q and m, a follower one turns with the section,
//! `q = R R_0^T q_0`. Variations (see [`super::interpolation`] for theta and d p):
//!
//! ```text
//! d q = -[q]x theta,   d m = -[m]x theta                 (follower)
//! d[(p - x_k) x q] = [p - x_k]x d q - [q]x (d p - d x_k)
//! ```
//!
//! A signal, a number that depends on time and on what is sensed, multiplies all of it.
//!
//! References: [Masarati], the three-node finite-volume beam: external loads.

use nalgebra::{Matrix3, Vector3};
use shared_geom::quadrature;
use shared_geom::rotation::skew;

use super::elastic::ElasticBeam;
use super::geometry::BeamGeometry;
use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use crate::elements::loads::{Head, Load, LoadFactor, Turning};
use crate::elements::{Local, LocalJacobian, LocalResidual, Signal};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, Variable};

/// Gauss points between two neighboring limits: exact for a load of the fifth degree
/// on a straight beam, whose arm is quadratic.
const POINTS: usize = 4;

/// Force [N/m] and moment [N m/m] per undeformed length at a place xi of the undeformed
/// beam, model's axes.
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

/// A piece of the load now, for the factor one.
struct Acting {
    point: PointKinematics,
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

impl DistributedLoad {
    /// The load `load(xi)` on a beam on nodes number `nodes`, undeformed at
    /// `undeformed`. `kinks` are the places xi where the load is not smooth.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        (turning, factor): (Turning, LoadFactor),
        kinks: &[f64],
        load: impl Fn(f64) -> LineLoad,
    ) -> Self {
        let [first, second] = ElasticBeam::evaluation_points();
        let mut limits = vec![-1.0, first, second, 1.0];
        limits.extend(kinks.iter().filter(|xi| xi.abs() < 1.0));
        limits.sort_by(f64::total_cmp);
        let mut points = Vec::new();
        for pair in limits.windows(2).filter(|pair| pair[1] > pair[0]) {
            let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
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
                    portion: usize::from(middle > first) + usize::from(middle > second),
                    shape: Shape::at(xi),
                    j0: reference.j0,
                    force,
                    moment,
                });
            }
        }
        Self {
            head: Head {
                label: label.into(),
                nodes: nodes.to_vec(),
                factor,
                signal: Signal::default(),
            },
            geometry,
            turning,
            points,
        }
    }

    /// The load times a signal.
    #[must_use]
    pub fn driven(mut self, signal: Signal) -> Self {
        self.head.signal = signal.seated(&mut self.head.nodes);
        self
    }

    fn acting(&self, piece: &LoadPoint, nodal: &NodalKinematics) -> Acting {
        let point = nodal.at(&piece.shape, piece.j0);
        let turn = match self.turning {
            Turning::Dead => Matrix3::identity(),
            Turning::Follower => point.r,
        };
        Acting {
            point,
            force: turn * piece.force,
            moment: turn * piece.moment,
        }
    }

    /// Adds what the change of the signal does.
    fn add_signal(
        &self,
        at: &Local<'_>,
        load_factor: f64,
        nodal: &NodalKinematics,
        out: &mut LocalJacobian,
    ) {
        let mut sums = [[Vector3::zeros(); 2]; 3];
        for piece in &self.points {
            let acting = self.acting(piece, nodal);
            let arm = acting.point.p - nodal.x[piece.portion];
            let [force, moment] = &mut sums[piece.portion];
            *force += acting.force;
            *moment += acting.moment + arm.cross(&acting.force);
        }
        self.head.signal.gradient(at, |place, variable, row| {
            let row = load_factor * row.transpose();
            for (node, [force, moment]) in sums.iter().enumerate() {
                out.add((node, Force), (place, variable), &(force * row));
                out.add((node, Moment), (place, variable), &(moment * row));
            }
        });
    }
}

impl Load for DistributedLoad {
    fn head(&self) -> &Head {
        &self.head
    }

    fn add(&self, factor: f64, at: &Local<'_>, out: &mut LocalResidual) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let factor = factor * self.head.signal.value(at);
        for piece in &self.points {
            let node = piece.portion;
            let acting = self.acting(piece, &nodal);
            let arm = acting.point.p - nodal.x[node];
            out.add(node, Force, &(factor * acting.force));
            out.add(node, Moment, &(factor * acting.moment));
            out.add(node, Moment, &(factor * arm.cross(&acting.force)));
        }
    }

    fn add_variation(&self, load_factor: f64, at: &Local<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let factor = load_factor * self.head.signal.value(at);
        let relative = nodal.relative_variation();
        let offset = nodal.offset_skew();
        for piece in &self.points {
            let node = piece.portion;
            let acting = self.acting(piece, &nodal);
            let force = skew(&acting.force);
            let arm = skew(&(acting.point.p - nodal.x[node]));
            let theta = nodal.rotation_variation(&piece.shape, &acting.point, &relative);
            for j in 0..3 {
                let n = piece.shape.n[j];
                let own = if j == node { 1.0 } else { 0.0 };
                let lever = (n - own) * Matrix3::identity();
                let mut moment = force * offset[j] * n;
                if self.turning == Turning::Follower {
                    let turned = force * theta[j];
                    let column = (j, Variable::Rotation);
                    out.add((node, Force), column, &(-factor * turned));
                    moment -= arm * turned + skew(&acting.moment) * theta[j];
                }
                let row = (node, Moment);
                out.add(row, (j, Variable::Position), &(-factor * force * lever));
                out.add(row, (j, Variable::Rotation), &(factor * moment));
            }
        }
        self.add_signal(at, load_factor, &nodal, out);
    }
}
