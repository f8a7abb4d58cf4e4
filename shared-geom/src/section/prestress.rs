//! Stiffness of a section that is already loaded: the cubic part of its energy.
//!
//! Over the four generalized strains `p = [nu1, k1, k2, k3]` (axial, torsion, bending y,
//! bending z), with the shear forces zero,
//!
//! ```text
//! U(p) = 1/2 K_ij p_i p_j + 1/6 T_ijk p_i p_j p_k                         (S-80)
//! force_i = K_ij p_j + 1/2 T_ijk p_j p_k       stiffness_ij = K_ij + T_ijk p_k
//! ```
//!
//! T is symmetric in all its indices: twenty numbers. The strains of another point or
//! other axes are linear in these, `p = V p'`, since the frame of the section is the
//! same, so that the table is transformed exactly:
//!
//! ```text
//! T'_abc = T_ijk V_ia V_jb V_kc                                            (S-86)
//! ```
//!
//! Heat and other imposed strains add a matrix for each of their states, which is
//! transformed as the stiffness, and T applies to the strain that is not free:
//!
//! ```text
//! q = p - sum c_i psi_i       force_j = K_jk q_k + 1/2 T_jkl q_k q_l + sum c_i T_ijk q_k  (S-150)
//! K(F, c) = K + T . (C F) + sum c_i T_i                                    (S-151)
//! ```

use nalgebra::{DMatrix, Matrix4, Matrix6, Vector2, Vector3, Vector4, Vector6};

use super::SectionProperties;

/// The components of a table, by their index among the six of
/// [`crate::wrench::COMPONENTS`]: axial, torsion, bending y, bending z.
pub const PRESTRESS_COMPONENTS: [usize; 4] = [0, 3, 4, 5];

/// Number of independent entries of a symmetric table over four components.
const ENTRIES: usize = 20;

/// Second-order measure of strain; it changes a table by the size of the stiffness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrainMeasure {
    /// `U - I`, with U the right stretch: the change of lengths.
    Biot,
    /// `1/2 (F'F - I)`.
    Green,
}

impl StrainMeasure {
    /// All measures, the usual one first.
    pub const ALL: [Self; 2] = [Self::Biot, Self::Green];
    /// Their names in files, in the same order.
    pub const NAMES: [&str; 2] = ["biot", "green"];

    /// The name in files.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }
}

/// First-order effect of the internal forces on the stiffness of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prestress {
    /// The measure of strain to which the elastic law of the materials applies.
    pub strain_measure: StrainMeasure,
    /// Third derivatives of the energy.
    pub third: CubicTable,
    /// Change of the stiffness of the section without internal force, per kelvin of an
    /// even rise of temperature, over the components of the table, 4x4 symmetric
    /// [N/K, N m/K, N m^2/K]; `None` if it was not computed.
    pub per_kelvin: Option<Matrix4<f64>>,
}

/// A table `T_ijk` that is symmetric in its three indices, over axial, torsion, bending
/// y, bending z; the unit is N m^n, with n the number of indices that are not axial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CubicTable([f64; ENTRIES]);

impl CubicTable {
    /// The table without effect.
    pub const ZERO: Self = Self([0.0; ENTRIES]);

    /// The indices of the independent entries, ascending.
    pub fn indices() -> impl Iterator<Item = [usize; 3]> {
        (0..4).flat_map(|i| (i..4).flat_map(move |j| (j..4).map(move |k| [i, j, k])))
    }

    /// The table with `entry` of each ascending triple of indices.
    pub fn from_fn(mut entry: impl FnMut([usize; 3]) -> f64) -> Self {
        let mut table = Self::ZERO;
        for (value, indices) in table.0.iter_mut().zip(Self::indices()) {
            *value = entry(indices);
        }
        table
    }

    /// `T_ijk`, the indices below four and in any order.
    pub fn at(&self, mut indices: [usize; 3]) -> f64 {
        indices.sort_unstable();
        let [i, j, k] = indices;
        // entries with a smaller first index, then entries of i with a smaller second
        // index than j
        let first: [usize; 4] = [0, 10, 16, 19];
        let size = 4 - i;
        let second = (j - i) * size - (j - i) * (j - i).saturating_sub(1) / 2;
        self.0[first[i] + second + k - j]
    }

    /// The independent entries with their indices.
    pub fn entries(&self) -> impl Iterator<Item = ([usize; 3], f64)> {
        Self::indices().zip(self.0)
    }

    /// `T_ijk p_k`, 4x4 symmetric: the change of the stiffness [N, N m, N m^2].
    pub fn along(&self, p: &Vector4<f64>) -> Matrix4<f64> {
        Matrix4::from_fn(|i, j| (0..4).map(|k| self.at([i, j, k]) * p[k]).sum())
    }

    /// `1/6 T_ijk p_i p_j p_k`, the cubic part of the energy per length [N].
    pub fn energy(&self, p: &Vector4<f64>) -> f64 {
        p.dot(&(self.along(p) * p)) / 6.0
    }

    /// The sum of two tables, entry by entry.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    /// All entries times a factor.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self(self.0.map(|value| factor * value))
    }

    /// The table over the strains p' with `p = V p'`.
    #[must_use]
    pub fn transformed(&self, v: &Matrix4<f64>) -> Self {
        // one index at a time
        let by_first: [Matrix4<f64>; 4] = std::array::from_fn(|a| {
            let along = self.along(&v.column(a).into_owned());
            v.transpose() * along * v
        });
        Self::from_fn(|[a, b, c]| by_first[a][(b, c)])
    }

    /// The table about the reference point moved by `by` = (y, z) [m].
    ///
    /// With d = (0, y, z): `nu = nu' - k x d`, whose first component is linear in the
    /// four strains, and k' = k.
    #[must_use]
    pub fn shifted(&self, by: Vector2<f64>) -> Self {
        self.transformed(&strains_of_moved(by))
    }

    /// The table in axes turned by `angle` about +x [rad].
    #[must_use]
    pub fn rotated(&self, angle: f64) -> Self {
        self.transformed(&strains_of_turned(angle))
    }

    /// The table in axes that follow the tangent of the reference line, as often in the
    /// literature, of a section of the 6x6 `compliance`: with the shears (nu2, nu3) of
    /// the linear solution and the turn `r = (0, -nu3, nu2)`,
    ///
    /// ```text
    /// p' - p = [ 1/2 (nu2^2 + nu3^2) ; - r x kappa ] ,   U3' = U3 - (K4 p) . (p' - p)   (S-87)
    /// ```
    ///
    /// without the mean turn of the warping about x, which is not in a property file.
    /// `None` for a compliance that has no inverse.
    pub fn along_tangent(&self, compliance: &Matrix6<f64>) -> Option<Self> {
        let [four, shears] = [&PRESTRESS_COMPONENTS[..], &[1, 2]].map(|rows| {
            DMatrix::from_fn(rows.len(), 4, |i, j| {
                compliance[(rows[i], PRESTRESS_COMPONENTS[j])]
            })
        });
        let stiffness = four.try_inverse()?;
        let shears = shears * &stiffness;
        // the change of the strains, bilinear in two states
        let second = |j: usize, k: usize| {
            let turn = |state: usize| Vector3::new(0.0, -shears[(1, state)], shears[(0, state)]);
            let curvature = |state: usize| match state {
                0 => Vector3::zeros(),
                _ => Vector3::ith(state - 1, 1.0),
            };
            let both = turn(j).cross(&curvature(k)) + turn(k).cross(&curvature(j));
            let stretch = 0.5 * shears.column(j).dot(&shears.column(k));
            Vector4::new(stretch, -0.5 * both.x, -0.5 * both.y, -0.5 * both.z)
        };
        let s = |i: usize, j: usize, k: usize| -stiffness.column(i).dot(&second(j, k));
        let change = Self::from_fn(|[i, j, k]| 2.0 * (s(i, j, k) + s(j, i, k) + s(k, i, j)));
        Some(self.plus(&change))
    }

    /// Whether all entries are finite.
    pub fn is_finite(&self) -> bool {
        self.0.iter().all(|value| value.is_finite())
    }
}

/// V of `p = V p'`, with p' about the reference point moved by `by` = (y, z) [m].
pub fn strains_of_moved(by: Vector2<f64>) -> Matrix4<f64> {
    let mut v = Matrix4::identity();
    v[(0, 2)] = -by.y;
    v[(0, 3)] = by.x;
    v
}

/// V of `p = V p'`, with p' in axes turned by `angle` about +x [rad].
pub(super) fn strains_of_turned(angle: f64) -> Matrix4<f64> {
    let (s, c) = angle.sin_cos();
    let mut v = Matrix4::identity();
    v[(2, 2)] = c;
    v[(2, 3)] = -s;
    v[(3, 2)] = s;
    v[(3, 3)] = c;
    v
}

/// A 4x4 matrix over the components of a table among the six; zero for the shears.
pub fn among_six(four: &Matrix4<f64>) -> Matrix6<f64> {
    let mut all = Matrix6::zeros();
    for (i, row) in PRESTRESS_COMPONENTS.into_iter().enumerate() {
        for (j, column) in PRESTRESS_COMPONENTS.into_iter().enumerate() {
            all[(row, column)] = four[(i, j)];
        }
    }
    all
}

/// The four strains or forces of a table among six.
pub fn prestress_part(all: &Vector6<f64>) -> Vector4<f64> {
    Vector4::from_fn(|i, _| all[PRESTRESS_COMPONENTS[i]])
}

impl Prestress {
    /// `dK_ij/dF_k = T_ijl C_lk`: change of the stiffness per unit of the internal force
    /// number `k` of the table, 4x4, for a section of the 6x6 `compliance`
    /// [-, m, m^2 and per m].
    pub fn by_force(&self, compliance: &Matrix6<f64>, k: usize) -> Matrix4<f64> {
        let strain = compliance.column(PRESTRESS_COMPONENTS[k]).into_owned();
        self.third.along(&prestress_part(&strain))
    }

    /// The change of the 6x6 stiffness at a generalized strain; zero for the shears
    /// [N, N m, N m^2].
    pub fn at_strain(&self, strain: &Vector6<f64>) -> Matrix6<f64> {
        among_six(&self.third.along(&prestress_part(strain)))
    }
}

impl SectionProperties {
    /// Stiffness at the internal force `force`, to first order, 6x6 [N, N m, N m^2]:
    ///
    /// ```text
    /// K(F) = K + T . (C F)                                                 (S-85)
    /// ```
    ///
    /// `None` without a table, and for a stiffness that has no inverse.
    pub fn stiffness_at(&self, force: &Vector6<f64>) -> Option<Matrix6<f64>> {
        let prestress = self.prestress.as_ref()?;
        let strain = self.stiffness.cholesky()?.solve(force);
        Some(self.stiffness + prestress.at_strain(&strain))
    }

    /// The change of the 6x6 stiffness by the imposed states of these names at the factor
    /// one, to first order: the sum of T_i of (S-151) [N, N m, N m^2]; `None` if the
    /// properties lack the change of one of them.
    pub fn change_by_imposed(&self, names: &[String]) -> Option<Matrix6<f64>> {
        let of_state = |name: &String| {
            let state = self.imposed.iter().find(|state| state.name == *name)?;
            Some(among_six(&state.stiffness_change?))
        };
        names.iter().map(of_state).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distinct entries, so that an exchanged index has an effect.
    fn table() -> CubicTable {
        CubicTable::from_fn(|[i, j, k]| (1 + i + 5 * j + 25 * k) as f64)
    }

    #[test]
    fn entries_are_found_in_any_order_of_their_indices() {
        assert_eq!(CubicTable::indices().count(), ENTRIES);
        let table = table();
        for [i, j, k] in CubicTable::indices() {
            let expected = (1 + i + 5 * j + 25 * k) as f64;
            for order in [
                [i, j, k],
                [k, j, i],
                [j, k, i],
                [j, i, k],
                [k, i, j],
                [i, k, j],
            ] {
                assert_eq!(table.at(order), expected);
            }
        }
    }

    /// The energy is the same from the moved table and the moved strains. Sums of 64
    /// terms up to 100: 1e-13 of the energy covers their round-off.
    #[test]
    fn the_energy_does_not_depend_on_point_or_axes() {
        let (table, by, angle) = (table(), Vector2::new(0.3, -0.7), 0.6_f64);
        let p = Vector4::new(0.7, -0.3, 0.4, 0.9);
        let energy = table.energy(&p);
        // nu at P = O + d is nu + k x d
        let moved = Vector4::new(p[0] + p[2] * by.y - p[3] * by.x, p[1], p[2], p[3]);
        let (s, c) = angle.sin_cos();
        let turned = Vector4::new(p[0], p[1], c * p[2] + s * p[3], c * p[3] - s * p[2]);
        assert!((table.shifted(by).energy(&moved) / energy - 1.0).abs() < 1e-13);
        assert!((table.rotated(angle).energy(&turned) / energy - 1.0).abs() < 1e-13);
    }

    /// Slope of the energy: `1/2 T p p`; its slope: `T p`. Central differences of a cubic
    /// are exact except h^2 T/6 of the first: with h = 1e-4 and entries up to 100 about
    /// 1e-6.
    #[test]
    fn energy_force_and_stiffness_belong_together() {
        let table = table();
        let p = Vector4::new(0.7, -0.3, 0.4, 0.9);
        let stiffness = table.along(&p);
        let force = 0.5 * stiffness * p;
        let h = 1e-4;
        for i in 0..4 {
            let step = h * Vector4::ith(i, 1.0);
            let slope = (table.energy(&(p + step)) - table.energy(&(p - step))) / (2.0 * h);
            assert!((slope - force[i]).abs() < 1e-6, "{i}");
            let force = |p: Vector4<f64>| 0.5 * table.along(&p) * p;
            let slope = (force(p + step) - force(p - step)) / (2.0 * h);
            assert!((slope - stiffness.column(i)).amax() < 1e-8, "{i}");
        }
    }
}
