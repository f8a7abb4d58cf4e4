//! Maximum stress and maximum strain along the material axes.
//!
//! ```text
//! index = max_i ( s_i / X_t,i  or  -s_i / X_c,i ;  |s_jk| / S_jk )                (S-53)
//! ```
//!
//! Linear in the load: the reserve factor is the inverse of the index.

use super::{Mode, Verdict, worst_linear};
use crate::material::DirectionalLimits;
use nalgebra::Vector6;

/// Index of a stress or strain in material axes, order 11 22 33 23 13 12.
pub(super) fn index(limits: &DirectionalLimits, s: &Vector6<f64>) -> Verdict {
    let normal = (0..3).map(|axis| {
        if s[axis] >= 0.0 {
            (s[axis] / limits.tension[axis], Mode::Tension(axis))
        } else {
            (-s[axis] / limits.compression[axis], Mode::Compression(axis))
        }
    });
    let shear = (0..3).map(|pair| (s[3 + pair].abs() / limits.shear[pair], Mode::Shear(pair)));
    worst_linear(normal.chain(shear))
}
