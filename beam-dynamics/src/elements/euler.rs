//! Angles of turns about three axes, one after the other.

use nalgebra::{Matrix3, Vector3};

/// Angles a, b, c of `R = R_i(a) R_j(b) R_k(c)`, turns about the axes i, j, k that the
/// turns before have moved. With l the axis that is neither i nor j, and e = 1 where
/// i, j, l follow each other (else -1), the entries of the product are
///
/// ```text
/// k = i:  R_ii = cos b,  R_ji = sin a sin b,  R_li = -e cos a sin b,
///         R_ij = sin b sin c,  R_il = e sin b cos c
/// k = l:  R_il = e sin b,  R_jl = -e sin a cos b,  R_ll = cos a cos b,
///         R_ij = -e cos b sin c,  R_ii = cos b cos c
/// ```
///
/// If the first and the last axis coincide, the last angle is zero.
pub(super) fn euler_angles(r: &Matrix3<f64>, [i, j, k]: [usize; 3]) -> Vector3<f64> {
    /// Sine below which two axes are treated as one.
    const LOCKED: f64 = 1e-9;
    let l = 3 - i - j;
    let e = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    let (side, middle) = if k == i {
        let side = r[(j, i)].hypot(r[(l, i)]);
        (side, side.atan2(r[(i, i)]))
    } else {
        let side = r[(i, i)].hypot(r[(i, j)]);
        (side, (e * r[(i, l)]).atan2(side))
    };
    if side < LOCKED {
        return Vector3::new((e * r[(l, j)]).atan2(r[(j, j)]), middle, 0.0);
    }
    if k == i {
        Vector3::new(
            r[(j, i)].atan2(-e * r[(l, i)]),
            middle,
            r[(i, j)].atan2(e * r[(i, l)]),
        )
    } else {
        Vector3::new(
            (-e * r[(j, l)]).atan2(r[(l, l)]),
            middle,
            (-e * r[(i, j)]).atan2(r[(i, i)]),
        )
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use approx::assert_relative_eq;
    use shared_geom::rotation::vector;

    use super::*;

    // The rotations of these angles, one after the other about axes that move along.
    #[test]
    fn euler_angles_rebuild_the_attitude() {
        let turn = |axis: usize, angle: f64| {
            let mut phi = Vector3::zeros();
            phi[axis] = angle;
            vector::to_rotation(&phi)
        };
        for sequence in [
            [2, 1, 0],
            [2, 0, 2],
            [0, 1, 2],
            [1, 0, 2],
            [0, 2, 0],
            [1, 2, 1],
        ] {
            let [i, j, k] = sequence;
            let middle = if i == k { 1.2 } else { -0.7 };
            let angles = Vector3::new(-2.1, middle, 0.4);
            let attitude = turn(i, angles[0]) * turn(j, angles[1]) * turn(k, angles[2]);
            let found = euler_angles(&attitude, sequence);
            assert_relative_eq!(found, angles, epsilon = 1e-14);
            // If the first and the last axis coincide, only their sum is defined.
            let middle = if i == k { 0.0 } else { FRAC_PI_2 };
            let locked = turn(i, 0.3) * turn(j, middle) * turn(k, 0.4);
            let [a, b, c] = euler_angles(&locked, sequence).into();
            assert_eq!(c, 0.0);
            let rebuilt = turn(i, a) * turn(j, b) * turn(k, c);
            assert_relative_eq!(rebuilt, locked, epsilon = 1e-9);
        }
    }
}
