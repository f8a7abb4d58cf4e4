//! Section axes of other tools, and their change to Helicoid's.
//!
//! A convention is a 3x3 matrix `Q` whose columns are its axes in Helicoid's. Forces and
//! moments of all tools are components along their axes 1, 2, 3, so that one matrix
//! changes axes and order at once: with `S = diag(Q, Q)`,
//!
//! ```text
//! K = S K' S^T        K' = S^T K S
//! ```

use nalgebra::{Matrix3, Matrix6};

use crate::wrench;

/// The section axes of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Convention {
    /// Helicoid's: x to the tip, y to the leading edge, z to the upper (suction) side.
    Helicoid,
    /// BeamDyn: x to the suction side, y to the trailing edge, z to the tip.
    BeamDyn,
    /// HAWC2: x to the leading edge, y to the suction side, z to the tip.
    Hawc2,
    /// VABS and DYMORE: x1 to the tip, x2 to the leading edge, x3 to the upper side.
    Vabs,
    /// ANBA4: as HAWC2.
    Anba4,
}

impl Convention {
    /// All conventions.
    pub const ALL: [Self; 5] = [
        Self::Helicoid,
        Self::BeamDyn,
        Self::Hawc2,
        Self::Vabs,
        Self::Anba4,
    ];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Helicoid => "helicoid",
            Self::BeamDyn => "beamdyn",
            Self::Hawc2 => "hawc2",
            Self::Vabs => "vabs",
            Self::Anba4 => "anba4",
        }
    }

    /// Its axes in Helicoid's, as columns.
    pub fn axes(self) -> Matrix3<f64> {
        match self {
            Self::Helicoid | Self::Vabs => Matrix3::identity(),
            Self::BeamDyn => Matrix3::new(0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0),
            Self::Hawc2 | Self::Anba4 => Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0),
        }
    }

    /// A 6x6 matrix of this convention in Helicoid's axes and order; exact.
    pub fn to_ours(self, matrix: &Matrix6<f64>) -> Matrix6<f64> {
        wrench::rotate(matrix, &self.axes().transpose())
    }

    /// A 6x6 matrix of Helicoid in the axes and order of this convention; exact.
    pub fn from_ours(self, matrix: &Matrix6<f64>) -> Matrix6<f64> {
        wrench::rotate(matrix, &self.axes())
    }

    /// Six numbers, one for each component, in Helicoid's order; no signs.
    pub fn values_to_ours(self, values: &[f64; 6]) -> [f64; 6] {
        self.component_indices().map(|index| values[index])
    }

    /// Six numbers, one for each component, in the order of this convention; no signs.
    pub fn values_from_ours(self, values: &[f64; 6]) -> [f64; 6] {
        let mut theirs = [0.0; 6];
        for (&index, &value) in self.component_indices().iter().zip(values) {
            theirs[index] = value;
        }
        theirs
    }

    /// Index of each of Helicoid's components in this convention.
    fn component_indices(self) -> [usize; 6] {
        let axes = self.axes();
        let index = |i: usize| (0..3).find(|&j| axes[(i, j)] != 0.0).unwrap_or(i);
        [0, 1, 2, 3, 4, 5].map(|i| if i < 3 { index(i) } else { index(i - 3) + 3 })
    }

    /// The axes as text.
    pub fn axes_in_words(self) -> &'static str {
        match self {
            Self::Helicoid => {
                "helicoid (x along the blade to the tip, y to the leading edge, z to the upper \
                 side; section axes, twist included)"
            }
            Self::BeamDyn => {
                "beamdyn (x to the suction side, y to the trailing edge, z along the blade to \
                 the tip; section axes, twist included)"
            }
            Self::Hawc2 => {
                "hawc2 (x to the leading edge, y to the suction side, z along the blade to the \
                 tip; section axes, twist included)"
            }
            Self::Vabs => {
                "vabs (x1 along the blade to the tip, x2 to the leading edge, x3 to the upper \
                 side; section axes, twist included)"
            }
            Self::Anba4 => {
                "anba4 (x to the leading edge, y to the suction side, z along the blade to the \
                 tip; section axes, twist included)"
            }
        }
    }

    /// The six components in the order of its matrices.
    pub fn order(self) -> [&'static str; 6] {
        match self {
            Self::Helicoid => wrench::COMPONENTS,
            Self::BeamDyn => [
                "flap shear (x)",
                "edge shear (y)",
                "axial (z)",
                "edge bending (x)",
                "flap bending (y)",
                "torsion (z)",
            ],
            Self::Hawc2 | Self::Anba4 => [
                "edge shear (x)",
                "flap shear (y)",
                "axial (z)",
                "flap bending (x)",
                "edge bending (y)",
                "torsion (z)",
            ],
            Self::Vabs => [
                "axial (1)",
                "shear 2",
                "shear 3",
                "torsion (1)",
                "bending 2 (flap)",
                "bending 3 (edge)",
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twenty-one different primes: six on the diagonal, fifteen off it.
    fn primes() -> Matrix6<f64> {
        let primes = [
            101.0, 2.0, 3.0, 5.0, 7.0, 11.0, 103.0, 13.0, 17.0, 19.0, 23.0, 107.0, 29.0, 31.0,
            37.0, 109.0, 41.0, 43.0, 113.0, 47.0, 127.0,
        ];
        super::super::text::from_upper(&primes)
    }

    // The matrices are permutations with signs: nothing is rounded.
    #[test]
    fn every_pair_of_conventions_and_back_is_exact() {
        let k = primes();
        for a in Convention::ALL {
            assert_eq!(a.axes().determinant(), 1.0);
            for b in Convention::ALL {
                let there = b.from_ours(&a.to_ours(&k));
                assert_eq!(a.from_ours(&b.to_ours(&there)), k, "{a:?} {b:?}");
                let diagonal: [f64; 6] = std::array::from_fn(|i| k[(i, i)]);
                let moved = b.values_from_ours(&a.values_to_ours(&diagonal));
                assert_eq!(moved, std::array::from_fn(|i| there[(i, i)]));
            }
        }
    }

    // A strip wider (along the chord) than thick: the bending stiffness that moves the
    // strip in its plane (edge) is larger. Known indices (0-based): BeamDyn edge 3, flap
    // 4; HAWC2 flap 3, edge 4; VABS flap 4, edge 5; torsion after or before them.
    #[test]
    fn edge_flap_and_torsion_are_where_each_tool_has_them() {
        let (axial, shear_edge, shear_flap, torsion, flap, edge) = (1e6, 4e5, 3e5, 2.0, 5.0, 90.0);
        let diagonal = [axial, shear_edge, shear_flap, torsion, flap, edge];
        let k = Matrix6::from_diagonal(&diagonal.into());
        let of = |convention: Convention| -> [f64; 6] {
            let theirs = convention.from_ours(&k);
            std::array::from_fn(|i| theirs[(i, i)])
        };
        let beamdyn = [shear_flap, shear_edge, axial, edge, flap, torsion];
        assert_eq!(of(Convention::BeamDyn), beamdyn);
        let hawc2 = [shear_edge, shear_flap, axial, flap, edge, torsion];
        assert_eq!(of(Convention::Hawc2), hawc2);
        assert_eq!(of(Convention::Vabs), diagonal);
    }

    // A mass at y_c toward the leading edge and z_c up. BeamDyn's own form of its mass
    // matrix (OpenFAST, BeamDyn theory): M16 = -m Ycm, M26 = m Xcm, M34 = m Ycm,
    // M35 = -m Xcm with Xcm = z_c and Ycm = -y_c.
    #[test]
    fn center_of_mass_has_the_signs_of_beamdyn() {
        let (m, y_c, z_c) = (2.0, 0.3, 0.1);
        let mut own = Matrix6::zeros();
        own.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(m);
        let about_line = wrench::shift(&own, &nalgebra::Vector3::new(0.0, -y_c, -z_c));
        let theirs = Convention::BeamDyn.from_ours(&about_line);
        let (x_cm, y_cm) = (z_c, -y_c);
        assert_eq!(theirs[(0, 5)], -m * y_cm);
        assert_eq!(theirs[(1, 5)], m * x_cm);
        assert_eq!(theirs[(2, 3)], m * y_cm);
        assert_eq!(theirs[(2, 4)], -m * x_cm);
    }
}
