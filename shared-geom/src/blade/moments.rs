//! Mass moments of a blade about its root.

use nalgebra::{Matrix3, Vector3};

use super::{Blade, Side};
use crate::quadrature;
use crate::rotation::skew;

/// Gauss points of a piece between stations of the line and of the blade: the integrand
/// is cubic on straight pieces.
const POINTS: usize = 4;

/// Mass moments about the origin of the root axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassMoments {
    /// Mass [kg].
    pub mass: f64,
    /// Center of mass, in root axes [m].
    pub center: Vector3<f64>,
    /// Moment of inertia, 3x3 symmetric, in root axes [kg m^2].
    pub inertia: Matrix3<f64>,
}

impl Blade {
    /// Mass, center and moment of inertia, from the masses on and off the line:
    ///
    /// ```text
    /// int m ds,   int (m p + Q m c) ds,   int (-m [p]x[p]x - [p]x [Q m c]x - [Q m c]x [p]x + Q J Q^T) ds
    /// ```
    ///
    /// with p and Q the position and axes of the section, m c its static moment and J its
    /// moment of inertia about the line; by Gauss points between all stations and points.
    pub fn mass_moments(&self) -> MassMoments {
        let curve = self.line.curve();
        let mut ends: Vec<f64> = curve.arc_lengths().to_vec();
        let inside = |s: &f64| *s > 0.0 && *s < curve.length();
        ends.extend(self.positions().into_iter().filter(inside));
        ends.sort_by(f64::total_cmp);
        let (mut mass, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
        for pair in ends.windows(2) {
            let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
            for &(at, weight) in quadrature::line(POINTS) {
                let s = middle + half * at;
                let (_, matrix) = self.at(s, Side::Outer);
                let placed = curve.at(s);
                let m = matrix[(0, 0)];
                let beside = Vector3::new(0.0, matrix[(2, 3)], -matrix[(1, 3)]);
                let (p, beside) = (skew(&placed.position), placed.axes * beside);
                let own = matrix.fixed_view::<3, 3>(3, 3).into_owned();
                let own = placed.axes * own * placed.axes.transpose();
                let offset = skew(&beside);
                mass += half * weight * m;
                first += half * weight * (m * placed.position + beside);
                second += half * weight * (own - m * p * p - p * offset - offset * p);
            }
        }
        MassMoments {
            mass,
            center: if mass > 0.0 {
                first / mass
            } else {
                Vector3::zeros()
            },
            inertia: second,
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix6, Vector2};

    use super::*;
    use crate::blade::{Interpolation, Station};
    use crate::line::{Course, LinePoint, ReferenceLine};
    use crate::section::Provenance;
    use crate::wrench;

    // A uniform rod of 3 kg/m and 4 m, its masses 0.2 m ahead of a line along x, twisted
    // by a right angle nose up, so that "ahead" is up: m = 12 kg, center at (2, 0, 0.2),
    // inertia about y m (L^2/3 + 0.2^2), about z m L^2/3, about x m 0.2^2; product
    // -m 2 0.2 in (x, z).
    #[test]
    fn rod_beside_its_line() {
        let (m, length, ahead) = (3.0, 4.0, 0.2);
        let mut own = Matrix6::zeros();
        own.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(m);
        let mass = wrench::shift(&own, &Vector3::new(0.0, -ahead, 0.0));
        let point = |x| LinePoint {
            position: Vector3::new(x, 0.0, 0.0),
            twist: std::f64::consts::FRAC_PI_2,
        };
        let station = |arc_length| Station {
            arc_length,
            stiffness: Matrix6::identity(),
            mass,
        };
        let blade = Blade {
            name: String::new(),
            line: ReferenceLine::through(vec![point(0.0), point(length)], Course::Polyline),
            reference_point: Vector2::zeros(),
            stations: vec![station(0.0), station(length)],
            interpolation: Interpolation::Linear,
            damping: None,
            provenance: Provenance::default(),
        };
        let found = blade.mass_moments();
        let total = m * length;
        assert!((found.mass - total).abs() < 1e-13);
        assert!((found.center - Vector3::new(2.0, 0.0, ahead)).norm() < 1e-14);
        let (own, long) = (total * ahead * ahead, total * length * length / 3.0);
        let product = -total * 2.0 * ahead;
        let exact = Matrix3::new(own, 0.0, product, 0.0, long + own, 0.0, product, 0.0, long);
        assert!((found.inertia - exact).amax() < 1e-12, "{}", found.inertia);
    }
}
