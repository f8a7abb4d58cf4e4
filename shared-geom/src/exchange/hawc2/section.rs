//! The row of a HAWC2 st file and its 6x6 matrices.
//!
//! Axes of the section: x to the leading edge, y to the suction side, z to the tip,
//! origin on the line of `c2_def`; matrices in the order of their three axes. The K of a
//! fully populated row is about the elastic center, in the principal axes of bending,
//! which are the axes of the section turned by `pitch`, positive about +z. With
//! `Q = Rz(pitch)`, `d = (x_e, y_e, 0)`, and shift and rotation as in [`crate::wrench`],
//!
//! ```text
//! K_e = S^T U(d) K U(d)^T S        K = U(-d) S K_e S^T U(-d)^T        S = diag(Q, Q)
//! ```
//!
//! The classic row is a beam with elastic center e and shear center s,
//!
//! ```text
//! K = at e: diag(0, 0, E A, E I_x, E I_y, 0)  +  at s: diag(k_x G A, k_y G A, 0, 0, 0, G I_p)
//! ```
//!
//! both in the principal axes. Mass: `m`, the mass center, and the radii of gyration
//! about the elastic center along the principal axes of bending, as HAWC2's columns are
//! documented and as the converter of BECAS computes them. A product of inertia is not
//! stated: the axes of the slice at its mass center are assumed parallel to the axes of
//! bending.
//!
//! # Symbols
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `x_e, y_e` | elastic (tension) center | m |
//! | `pitch` | from the x axis of the section to the first principal axis, about +z | rad |
//! | `ri_x, ri_y` | radii of gyration for rotation about the principal axes | m |
//! | `Y` | `-K_FF^-1 K_FM` of the 3x3 blocks of K: centers | m |

use nalgebra::{Matrix2, Matrix3, Matrix6, Vector2, Vector3};

use crate::wrench;

/// Bending stiffnesses that differ by less, relative, have no principal axes.
const ROUND: f64 = 1e-6;

/// Reference point and axes of the properties of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::exchange) struct PrincipalAxes {
    /// Elastic center [m].
    pub elastic: Vector2<f64>,
    /// Angle of the principal axes [rad].
    pub pitch: f64,
}

/// Mass properties of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::exchange) struct Inertia {
    /// Mass per length [kg/m].
    pub mass: f64,
    /// Mass center [m].
    pub center: Vector2<f64>,
    /// Radii of gyration [m].
    pub radii: Vector2<f64>,
}

/// The stiffnesses of a classic row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::exchange) struct Classic {
    /// Axial stiffness [N].
    pub axial: f64,
    /// Bending stiffness about the principal axes [N m^2].
    pub bending: Vector2<f64>,
    /// Torsional stiffness [N m^2].
    pub torsion: f64,
    /// Shear stiffness along the principal axes [N].
    pub shear: Vector2<f64>,
    /// Shear center [m].
    pub shear_center: Vector2<f64>,
}

impl PrincipalAxes {
    /// Elastic center and principal axes of a stiffness in HAWC2's axes.
    ///
    /// The first axis is the one that lies nearest to the x axis.
    pub fn of(k: &Matrix6<f64>) -> Self {
        let Some(Blocks { centers, free }) = Blocks::of(k) else {
            return Self {
                elastic: Vector2::zeros(),
                pitch: 0.0,
            };
        };
        Self {
            elastic: Vector2::new(centers[(2, 1)], -centers[(2, 0)]),
            pitch: principal_angle(&free.fixed_view::<2, 2>(0, 0).into_owned()),
        }
    }

    /// A matrix about the line, at the elastic center and in the principal axes.
    pub fn into_principal(self, matrix: &Matrix6<f64>) -> Matrix6<f64> {
        wrench::rotate(
            &wrench::shift(matrix, &flat(self.elastic)),
            &about_z(self.pitch),
        )
    }

    /// A matrix at the elastic center in the principal axes, about the line.
    pub fn to_line(self, matrix: &Matrix6<f64>) -> Matrix6<f64> {
        self.to_line_from(matrix, self.elastic)
    }

    /// A matrix at `point` in the principal axes, about the line.
    fn to_line_from(self, matrix: &Matrix6<f64>, point: Vector2<f64>) -> Matrix6<f64> {
        let turned = wrench::rotate(matrix, &about_z(-self.pitch));
        wrench::shift(&turned, &flat(-point))
    }
}

impl Inertia {
    /// The row's numbers for a mass matrix about the line.
    pub fn of(matrix: &Matrix6<f64>, axes: PrincipalAxes) -> Self {
        let mass = matrix[(2, 2)];
        let part = |value: f64| if mass > 0.0 { value / mass } else { 0.0 };
        let about = axes.into_principal(matrix);
        let radius = |i: usize| part(about[(i, i)]).max(0.0).sqrt();
        Self {
            mass,
            center: Vector2::new(part(-matrix[(2, 4)]), part(matrix[(2, 3)])),
            radii: Vector2::new(radius(3), radius(4)),
        }
    }

    /// The mass matrix about the line, and whether a radius of gyration is smaller than
    /// the distance of the two centers: the moment about the mass center is then zero.
    ///
    /// ```text
    /// I_x = m (ri_x^2 - g_y^2)     I_y = m (ri_y^2 - g_x^2)     g from elastic to mass center
    /// ```
    pub fn matrix(&self, axes: PrincipalAxes) -> (Matrix6<f64>, bool) {
        let g = about_z(axes.pitch).tr_mul(&flat(self.center - axes.elastic));
        let squares = self.radii.component_mul(&self.radii);
        let own = Vector2::new(squares.x - g.y * g.y, squares.y - g.x * g.x);
        // A thin slice has no moment about its length: allows for round-off.
        let too_small = own.min() < -1e-9 * squares.max();
        let [x, y] = [own.x.max(0.0), own.y.max(0.0)];
        let m = self.mass;
        let diagonal = [m, m, m, m * x, m * y, m * (x + y)];
        let own = Matrix6::from_diagonal(&diagonal.into());
        (axes.to_line_from(&own, self.center), too_small)
    }
}

impl Classic {
    /// The classic row's numbers for a stiffness.
    pub fn of(k: &Matrix6<f64>, axes: PrincipalAxes) -> Self {
        let blocks = Blocks::of(k);
        let center = blocks.as_ref().map_or(Vector2::zeros(), |blocks| {
            let y = &blocks.centers;
            Vector2::new(-y[(1, 2)], y[(0, 2)])
        });
        let principal = axes.into_principal(k);
        let free = blocks.map_or(Matrix3::zeros(), |blocks| {
            about_z(axes.pitch).tr_mul(&blocks.free) * about_z(axes.pitch)
        });
        Self {
            axial: principal[(2, 2)],
            bending: Vector2::new(free[(0, 0)], free[(1, 1)]),
            torsion: free[(2, 2)],
            shear: Vector2::new(principal[(0, 0)], principal[(1, 1)]),
            shear_center: center,
        }
    }

    /// The stiffness about the line.
    pub fn matrix(&self, axes: PrincipalAxes) -> Matrix6<f64> {
        let (bending, shear) = (self.bending, self.shear);
        let at_elastic = [0.0, 0.0, self.axial, bending.x, bending.y, 0.0];
        let at_shear = [shear.x, shear.y, 0.0, 0.0, 0.0, self.torsion];
        let at = |diagonal: [f64; 6], point| {
            axes.to_line_from(&Matrix6::from_diagonal(&diagonal.into()), point)
        };
        at(at_elastic, axes.elastic) + at(at_shear, self.shear_center)
    }
}

/// The greatest entry of `found - expected`, each relative to the roots of the diagonal
/// entries of `expected` [-].
pub(super) fn difference(found: &Matrix6<f64>, expected: &Matrix6<f64>) -> f64 {
    let size = |i: usize, j: usize| (expected[(i, i)] * expected[(j, j)]).abs().sqrt();
    let entry = |i: usize, j: usize| {
        let off = (found[(i, j)] - expected[(i, j)]).abs();
        if off > 0.0 { off / size(i, j) } else { 0.0 }
    };
    let pairs = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
    pairs.map(|(i, j)| entry(i, j)).fold(0.0, f64::max)
}

/// Centers, and the rotational stiffness without a force.
struct Blocks {
    centers: Matrix3<f64>,
    free: Matrix3<f64>,
}

impl Blocks {
    fn of(k: &Matrix6<f64>) -> Option<Self> {
        let block = |i, j| k.fixed_view::<3, 3>(i, j).into_owned();
        let (forces, coupling, moments) = (block(0, 0), block(0, 3), block(3, 3));
        let centers = -(forces.lu().solve(&coupling)?);
        Some(Self {
            free: moments + coupling.transpose() * centers,
            centers,
        })
    }
}

/// The angle of the principal axis nearest to the first one, in (-45, 45] degrees [rad].
fn principal_angle(bending: &Matrix2<f64>) -> f64 {
    let (sum, difference) = (bending.trace(), bending[(0, 0)] - bending[(1, 1)]);
    let product = 2.0 * bending[(0, 1)];
    if difference.hypot(product) <= ROUND * sum {
        return 0.0;
    }
    let angle = 0.5 * product.atan2(difference);
    let quarter = std::f64::consts::FRAC_PI_2;
    angle - (angle / quarter).round() * quarter
}

fn flat(point: Vector2<f64>) -> Vector3<f64> {
    Vector3::new(point.x, point.y, 0.0)
}

/// Rotation about z.
fn about_z(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation::samples::Samples;

    // A rectangle 0.4 m along the chord, 0.1 m thick, E = 70e9, G = 27e9, rho = 2700:
    // flap E b h^3/12 about x, edge E h b^3/12 about y; k = 5/6. GJ is any number here.
    const E: f64 = 70e9;
    const G: f64 = 27e9;
    const RHO: f64 = 2700.0;
    const WIDE: f64 = 0.4;
    const THICK: f64 = 0.1;
    const GJ: f64 = 3.0e6;

    fn rectangle() -> (Matrix6<f64>, Matrix6<f64>) {
        let area = WIDE * THICK;
        let [flap, edge] = [WIDE * THICK.powi(3) / 12.0, THICK * WIDE.powi(3) / 12.0];
        let shear = 5.0 / 6.0 * G * area;
        let k = [shear, shear, E * area, E * flap, E * edge, GJ];
        let m = [area, area, area, flap, edge, flap + edge].map(|value| RHO * value);
        (
            Matrix6::from_diagonal(&k.into()),
            Matrix6::from_diagonal(&m.into()),
        )
    }

    /// The rectangle with its own axes turned by `angle` about +z and its center at
    /// `center`, about the line by hand: bending by the axial force at a distance.
    fn placed(angle: f64, center: Vector2<f64>) -> (Matrix6<f64>, Matrix6<f64>) {
        let (k, m) = rectangle();
        let (s, c) = angle.sin_cos();
        let about_line = |own: &Matrix6<f64>| {
            let (axial, flap, edge) = (own[(2, 2)], own[(3, 3)], own[(4, 4)]);
            let (shear, polar) = (own[(0, 0)], own[(5, 5)]);
            let (x, y) = (center.x, center.y);
            let mut all = Matrix6::zeros();
            all[(0, 0)] = shear;
            all[(1, 1)] = shear;
            all[(2, 2)] = axial;
            // Moments of the area turned by the angle, and Steiner's parts.
            all[(3, 3)] = flap * c * c + edge * s * s + axial * y * y;
            all[(4, 4)] = flap * s * s + edge * c * c + axial * x * x;
            all[(3, 4)] = (flap - edge) * s * c - axial * x * y;
            all[(5, 5)] = polar + shear * (x * x + y * y);
            // M_x = y F, M_y = -x F, M_z = x F_y - y F_x
            all[(2, 3)] = axial * y;
            all[(2, 4)] = -axial * x;
            all[(0, 5)] = -shear * y;
            all[(1, 5)] = shear * x;
            all.fill_lower_triangle_with_upper_triangle();
            all
        };
        (about_line(&k), about_line(&m))
    }

    // The sign of the angle, physically: the long side of the rectangle points from the
    // leading edge up (angle > 0, nose up: positive about +z, to the tip). The row has
    // the flap stiffness first and the edge stiffness second in its own axes, the pitch
    // is the angle, and the elastic center is as given.
    #[test]
    fn a_turned_and_offset_rectangle_has_its_pitch_center_and_stiffnesses() {
        let (own, own_mass) = rectangle();
        for degrees in [0.0, 20.0, -35.0, 44.0_f64] {
            let (angle, center) = (degrees.to_radians(), Vector2::new(0.15, -0.04));
            let (k, m) = placed(angle, center);
            let axes = PrincipalAxes::of(&k);
            assert!((axes.pitch - angle).abs() < 1e-12, "{degrees}");
            assert!((axes.elastic - center).amax() < 1e-14);
            let row = axes.into_principal(&k);
            assert!(difference(&row, &own) < 1e-12, "{row:e}");
            assert!(row[(4, 4)] > 10.0 * row[(3, 3)]);
            assert!(difference(&axes.to_line(&row), &k) < 1e-14);
            // the wrong sign of the angle gives another section
            if degrees != 0.0 {
                let wrong = PrincipalAxes {
                    pitch: -axes.pitch,
                    ..axes
                };
                assert!(difference(&wrong.to_line(&row), &k) > 0.1);
            }

            let inertia = Inertia::of(&m, axes);
            assert!((inertia.mass - own_mass[(0, 0)]).abs() < 1e-11);
            assert!((inertia.center - center).amax() < 1e-14);
            // radii of a rectangle: h/sqrt(12), b/sqrt(12)
            let radii = Vector2::new(THICK, WIDE) / 12.0_f64.sqrt();
            assert!((inertia.radii - radii).amax() < 1e-13);
            let (back, too_small) = inertia.matrix(axes);
            assert!(difference(&back, &m) < 1e-12 && !too_small);

            let classic = Classic::of(&k, axes);
            assert!((classic.axial / own[(2, 2)] - 1.0).abs() < 1e-14);
            assert!((classic.shear_center - center).amax() < 1e-13);
            assert!(difference(&classic.matrix(axes), &k) < 1e-11);
        }
    }

    // Any positive definite K, of any coupling, is recovered from its row.
    #[test]
    fn full_matrices_come_back_from_the_elastic_center() {
        let mut samples = Samples::new(31);
        for _ in 0..200 {
            let a = Matrix6::from_fn(|_, _| samples.scalar());
            let k = 1e8 * (a * a.transpose() + 0.2 * Matrix6::identity());
            let axes = PrincipalAxes::of(&k);
            assert!(axes.pitch.abs() <= std::f64::consts::FRAC_PI_4 + 1e-12);
            let row = axes.into_principal(&k);
            // Forces at the elastic center do not bend: Y is zero there.
            let again = PrincipalAxes::of(&row);
            assert!(again.elastic.amax() < 1e-10 && again.pitch.abs() < 1e-6);
            assert!(difference(&axes.to_line(&row), &k) < 1e-12);
        }
    }

    // Mass center off the elastic center: the radii are about the elastic center, so that
    // a point mass has its distances as radii, and none about itself.
    #[test]
    fn radii_are_about_the_elastic_center() {
        let axes = PrincipalAxes {
            elastic: Vector2::new(0.3, 0.1),
            pitch: 0.4,
        };
        let (m, center) = (2.0, Vector2::new(0.1, 0.25));
        let mut point = Matrix6::zeros();
        point.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(m);
        let about_line = wrench::shift(&point, &flat(-center));
        let inertia = Inertia::of(&about_line, axes);
        let (s, c) = 0.4_f64.sin_cos();
        let (dx, dy) = (-0.2, 0.15);
        let g = Vector2::new(c * dx + s * dy, -s * dx + c * dy);
        let radii = Vector2::new(g.y.abs(), g.x.abs());
        assert!((inertia.radii - radii).amax() < 1e-14);
        let (back, too_small) = inertia.matrix(axes);
        assert!((back - about_line).amax() < 1e-14 && !too_small);
        let short = Inertia {
            radii: 0.9 * inertia.radii,
            ..inertia
        };
        assert!(short.matrix(axes).1);
    }

    // A round root has no principal axes: the angle is zero, for any last digits.
    #[test]
    fn a_round_section_keeps_the_axes_of_the_section() {
        let mut k = Matrix6::from_diagonal(&[3.0, 3.0, 9.0, 5.0, 5.0, 4.0].into());
        k[(3, 4)] = 1e-9;
        k[(4, 3)] = 1e-9;
        assert_eq!(PrincipalAxes::of(&k).pitch, 0.0);
    }
}
