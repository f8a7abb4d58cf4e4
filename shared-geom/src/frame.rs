//! Frames: an origin and three axes, placed in a parent frame.
//!
//! Points change by rotation and origin, vectors (forces, velocities, directions) only by
//! rotation. A node, a section on its reference line, or a ply on its wall each have one.
//!
//! # Example
//!
//! ```
//! use nalgebra::Vector3;
//! use shared_geom::frame::Frame;
//! use shared_geom::rotation::vector;
//!
//! let turn = vector::to_rotation(&Vector3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2));
//! let hub = Frame::new(Vector3::new(0.0, 0.0, 3.0), turn);
//! let tip = hub.point_to_parent(&Vector3::new(5.0, 0.0, 0.0));
//! assert!((tip - Vector3::new(0.0, 5.0, 3.0)).norm() < 1e-15);
//! assert!((hub.point_from_parent(&tip).x - 5.0).abs() < 1e-15);
//! ```

use nalgebra::{Matrix3, Vector3};

/// Position and orientation of a frame in its parent.
///
/// The rotation is not checked; see [`crate::rotation::is_rotation`].
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use shared_geom::frame::Frame;
///
/// // Axes turned by a quarter turn about z: the x axis points along the parent's y.
/// let quarter = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
/// let frame = Frame::new(Vector3::new(2.0, 0.0, 0.0), quarter);
/// assert_eq!(frame.point_to_parent(&Vector3::x()), Vector3::new(2.0, 1.0, 0.0));
/// assert_eq!(frame.vector_to_parent(&Vector3::x()), Vector3::y());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Origin, 3 components in the parent frame [m].
    pub origin: Vector3<f64>,
    /// Rotation matrix, 3x3 [-]; its columns are the axes in the parent frame.
    pub rotation: Matrix3<f64>,
}

impl Frame {
    /// The frame that coincides with its parent.
    pub fn identity() -> Self {
        Self::new(Vector3::zeros(), Matrix3::identity())
    }

    /// The frame at `origin` [m] with the columns of `rotation` as axes.
    pub fn new(origin: Vector3<f64>, rotation: Matrix3<f64>) -> Self {
        Self { origin, rotation }
    }

    /// Parent coordinates [m] of a point given in this frame: `o + R p`.
    pub fn point_to_parent(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.origin + self.rotation * point
    }

    /// Coordinates [m] in this frame of a point given in the parent: `R^T (p - o)`.
    pub fn point_from_parent(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.rotation.tr_mul(&(point - self.origin))
    }

    /// Parent components of a vector given in this frame: `R v`.
    pub fn vector_to_parent(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * vector
    }

    /// Components in this frame of a vector given in the parent: `R^T v`.
    pub fn vector_from_parent(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.rotation.tr_mul(vector)
    }

    /// The frame `inner`, whose parent is this frame, placed in the parent of this one.
    pub fn compose(&self, inner: &Frame) -> Frame {
        Frame::new(
            self.point_to_parent(&inner.origin),
            self.rotation * inner.rotation,
        )
    }

    /// The parent relative to this frame: `compose` with it gives the identity.
    pub fn inverse(&self) -> Frame {
        Frame::new(
            -self.vector_from_parent(&self.origin),
            self.rotation.transpose(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation::samples::Samples;
    use std::f64::consts::PI;

    // Numbers of order one, a few products each: roundings of some 1e-16.
    const TOLERANCE: f64 = 4e-15;

    fn frame(samples: &mut Samples) -> Frame {
        Frame::new(samples.vector(), samples.rotation(PI))
    }

    #[test]
    fn points_and_vectors_come_back_from_the_parent() {
        let mut samples = Samples::new(40);
        for _ in 0..100 {
            let (frame, p) = (frame(&mut samples), samples.vector());
            let point = frame.point_from_parent(&frame.point_to_parent(&p));
            let vector = frame.vector_to_parent(&frame.vector_from_parent(&p));
            assert!((point - p).amax() < TOLERANCE);
            assert!((vector - p).amax() < TOLERANCE);
        }
    }

    // A vector is the difference of two points, in any frame.
    #[test]
    fn vectors_are_differences_of_points() {
        let mut samples = Samples::new(41);
        for _ in 0..100 {
            let frame = frame(&mut samples);
            let (p, q) = (samples.vector(), samples.vector());
            let difference = frame.point_to_parent(&p) - frame.point_to_parent(&q);
            assert!((frame.vector_to_parent(&(p - q)) - difference).amax() < TOLERANCE);
        }
    }

    #[test]
    fn composition_applies_the_inner_frame_first_and_is_associative() {
        let mut samples = Samples::new(42);
        for _ in 0..100 {
            let (a, b) = (frame(&mut samples), frame(&mut samples));
            let (c, p) = (frame(&mut samples), samples.vector());
            let nested = a.point_to_parent(&b.point_to_parent(&p));
            assert!((a.compose(&b).point_to_parent(&p) - nested).amax() < TOLERANCE);
            let (left, right) = (a.compose(&b).compose(&c), a.compose(&b.compose(&c)));
            assert!((left.origin - right.origin).amax() < TOLERANCE);
            assert!((left.rotation - right.rotation).amax() < TOLERANCE);
        }
    }

    #[test]
    fn inverse_undoes_the_frame_from_both_sides() {
        let mut samples = Samples::new(43);
        for _ in 0..100 {
            let a = frame(&mut samples);
            for product in [a.compose(&a.inverse()), a.inverse().compose(&a)] {
                assert!(product.origin.amax() < TOLERANCE);
                assert!((product.rotation - Matrix3::identity()).amax() < TOLERANCE);
            }
        }
        assert_eq!(Frame::identity().inverse(), Frame::identity());
    }
}
