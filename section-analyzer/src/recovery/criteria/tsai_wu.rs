//! The tensor polynomial of Tsai and Wu, in three dimensions.
//!
//! ```text
//! index = sum_i F_i s_i + sum_ij F_ij s_i s_j                                    (S-55)
//!
//! F_i  = 1/X_t,i - 1/X_c,i      F_ii = 1/(X_t,i X_c,i)       i = 1, 2, 3
//! F_jk = f_jk sqrt(F_jj F_kk)   shears: F = 1/S^2
//! ```
//!
//! With t times the load the index is `a t^2 + b t`, from the quadratic and the linear
//! part; its root is the reserve factor. The mode is the component with the largest share
//! in the index, with half of each product for each of its two factors.
//!
//! # References
//! - \[TsaiWu1971\]

use super::{Mode, Verdict, quadratic_reserve};
use crate::material::DirectionalLimits;
use nalgebra::Vector6;

/// Index of a stress in material axes, order 11 22 33 23 13 12; `interaction` is f of 23,
/// 13, 12.
pub(super) fn index(
    limits: &DirectionalLimits,
    interaction: &[f64; 3],
    s: &Vector6<f64>,
) -> Verdict {
    let [f23, f13, f12] = *interaction;
    let coupling = [[1.0, f12, f13], [f12, 1.0, f23], [f13, f23, 1.0]];
    let (xt, xc) = (&limits.tension, &limits.compression);
    // stresses over the geometric means of their strengths
    let scaled: [f64; 3] = std::array::from_fn(|i| s[i] / (xt[i] * xc[i]).sqrt());

    let mut linear = [0.0; 6];
    let mut quadratic = [0.0; 6];
    for i in 0..3 {
        linear[i] = (1.0 / xt[i] - 1.0 / xc[i]) * s[i];
        let row = (0..3).map(|j| coupling[i][j] * scaled[j]);
        quadratic[i] = scaled[i] * row.sum::<f64>();
        quadratic[3 + i] = (s[3 + i] / limits.shear[i]).powi(2);
    }
    let (a, b) = (quadratic.iter().sum::<f64>(), linear.iter().sum::<f64>());
    let largest = (0..6).max_by(|&i, &j| {
        let share = |k: usize| linear[k] + quadratic[k];
        share(i).total_cmp(&share(j))
    });
    let mode = match largest.unwrap_or(0) {
        axis @ 0..3 if s[axis] >= 0.0 => Mode::Tension(axis),
        axis @ 0..3 => Mode::Compression(axis),
        shear => Mode::Shear(shear - 3),
    };
    // a is a sum of squares, up to round-off
    (a + b, quadratic_reserve(a.max(0.0), b), mode)
}
