//! The mass matrix of version 2: seven numbers of a rigid slice, in the axes of BeamDyn.
//!
//! ```text
//! M11 = M22 = M33 = m          M16 = -m cm_y = -M34     M26 = m cm_x = -M35
//! M44 = i_edge   M55 = i_flap   M66 = i_plr              M45 = -i_cp
//! ```

use nalgebra::Matrix6;

use super::super::text::from_upper;

/// Names of the seven, in the order of [`values`].
pub(super) const NAMES: [&str; 7] = ["mass", "cm_x", "cm_y", "i_edge", "i_flap", "i_plr", "i_cp"];

/// The matrix of the seven numbers.
pub(super) fn matrix([m, x, y, edge, flap, polar, product]: [f64; 7]) -> Matrix6<f64> {
    from_upper(&[
        m,
        0.0,
        0.0,
        0.0,
        0.0,
        -m * y, //
        m,
        0.0,
        0.0,
        0.0,
        m * x, //
        m,
        m * y,
        -m * x,
        0.0, //
        edge,
        -product,
        0.0, //
        flap,
        0.0, //
        polar,
    ])
}

/// The seven numbers of a matrix, in the axes of BeamDyn.
pub(super) fn values(matrix: &Matrix6<f64>) -> [f64; 7] {
    let m = matrix[(0, 0)];
    let part = |value: f64| if m > 0.0 { value / m } else { 0.0 };
    [
        m,
        part(matrix[(1, 5)]),
        part(-matrix[(0, 5)]),
        matrix[(3, 3)],
        matrix[(4, 4)],
        matrix[(5, 5)],
        -matrix[(3, 4)],
    ]
}
