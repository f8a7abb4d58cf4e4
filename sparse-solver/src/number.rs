//! Numbers of a matrix, real or complex: single, and in the columns of a strip for parallel
//! arithmetic.

use std::fmt::Debug;
use std::ops::{Div, Mul, Sub, SubAssign};

use faer::c64;

/// Number of columns computed together.
pub(crate) const LANES: usize = 4;

/// A product subtracted from a sum.
pub(crate) trait Product {
    /// `c - a b`.
    fn take(c: f64, a: f64, b: f64) -> f64;
}

/// With one rounding.
pub(crate) struct Fused;

/// With two roundings.
pub(crate) struct Plain;

impl Product for Fused {
    #[inline(always)]
    fn take(c: f64, a: f64, b: f64) -> f64 {
        (-a).mul_add(b, c)
    }
}

impl Product for Plain {
    #[inline(always)]
    fn take(c: f64, a: f64, b: f64) -> f64 {
        c - a * b
    }
}

/// A real or complex number.
pub(crate) trait Number:
    Copy
    + Debug
    + Send
    + Sync
    + PartialEq
    + Mul<f64, Output = Self>
    + Mul<Output = Self>
    + Sub<Output = Self>
    + Div<Output = Self>
    + SubAssign
    + faer::traits::ComplexField
{
    /// Numbers of one row in the columns of a strip.
    type Lanes: Copy + Debug + Send + Sync;

    /// Zero.
    const ZERO: Self;
    /// Zero in each column.
    const NONE: Self::Lanes;
    /// One.
    const ONE: Self;

    /// The magnitude, or for complex numbers the sum of the magnitudes of the parts; NaN if one
    /// of them is NaN.
    fn size(self) -> f64;

    /// The number in a column.
    fn lane(lanes: &Self::Lanes, lane: usize) -> Self;

    /// Sets the number in a column.
    fn set_lane(lanes: &mut Self::Lanes, lane: usize, value: Self);

    /// `sum - factor row`.
    fn take<P: Product>(sum: &mut Self::Lanes, factor: Self, row: &Self::Lanes);

    /// The sizes of the numbers.
    fn sizes(lanes: &Self::Lanes) -> [f64; LANES];
}

impl Number for f64 {
    type Lanes = [f64; LANES];

    const ZERO: f64 = 0.0;
    const NONE: [f64; LANES] = [0.0; LANES];
    const ONE: f64 = 1.0;

    #[inline(always)]
    fn size(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn lane(lanes: &Self::Lanes, lane: usize) -> f64 {
        lanes[lane]
    }

    #[inline(always)]
    fn set_lane(lanes: &mut Self::Lanes, lane: usize, value: f64) {
        lanes[lane] = value;
    }

    #[inline(always)]
    fn take<P: Product>(sum: &mut Self::Lanes, factor: f64, row: &Self::Lanes) {
        for lane in 0..LANES {
            sum[lane] = P::take(sum[lane], factor, row[lane]);
        }
    }

    #[inline(always)]
    fn sizes(lanes: &Self::Lanes) -> [f64; LANES] {
        std::array::from_fn(|lane| lanes[lane].abs())
    }
}

/// Complex numbers of several columns: real parts, imaginary parts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ComplexLanes {
    re: [f64; LANES],
    im: [f64; LANES],
}

impl Number for c64 {
    type Lanes = ComplexLanes;

    const ZERO: c64 = c64::new(0.0, 0.0);
    const NONE: ComplexLanes = ComplexLanes {
        re: [0.0; LANES],
        im: [0.0; LANES],
    };
    const ONE: c64 = c64::new(1.0, 0.0);

    #[inline(always)]
    fn size(self) -> f64 {
        self.re.abs() + self.im.abs()
    }

    #[inline(always)]
    fn lane(lanes: &ComplexLanes, lane: usize) -> c64 {
        c64::new(lanes.re[lane], lanes.im[lane])
    }

    #[inline(always)]
    fn set_lane(lanes: &mut ComplexLanes, lane: usize, value: c64) {
        (lanes.re[lane], lanes.im[lane]) = (value.re, value.im);
    }

    #[inline(always)]
    fn take<P: Product>(sum: &mut ComplexLanes, factor: c64, row: &ComplexLanes) {
        for lane in 0..LANES {
            let (re, im) = (row.re[lane], row.im[lane]);
            sum.re[lane] = P::take(P::take(sum.re[lane], factor.re, re), -factor.im, im);
            sum.im[lane] = P::take(P::take(sum.im[lane], factor.re, im), factor.im, re);
        }
    }

    #[inline(always)]
    fn sizes(lanes: &ComplexLanes) -> [f64; LANES] {
        std::array::from_fn(|lane| lanes.re[lane].abs() + lanes.im[lane].abs())
    }
}

/// Right-hand sides of a system: one number per row, or several.
pub(crate) trait Row<T>: Copy + Send + Sync {
    /// Zero.
    const NONE: Self;

    /// `self + factor other`, rounded after each step.
    fn plus(self, factor: T, other: &Self) -> Self;

    /// `self - other`.
    fn minus(self, other: Self) -> Self;

    /// `factor self`.
    fn times(self, factor: T) -> Self;

    /// `factor self` for a real factor.
    fn scaled(self, factor: f64) -> Self;
}

macro_rules! row_of_one {
    ($number:ty, $zero:expr) => {
        impl Row<$number> for $number {
            const NONE: Self = $zero;

            #[inline(always)]
            fn plus(self, factor: $number, other: &Self) -> Self {
                self + factor * other
            }

            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self - other
            }

            #[inline(always)]
            fn times(self, factor: $number) -> Self {
                self * factor
            }

            #[inline(always)]
            fn scaled(self, factor: f64) -> Self {
                self * factor
            }
        }
    };
}

row_of_one!(f64, 0.0);
row_of_one!(c64, c64::new(0.0, 0.0));

impl Row<f64> for [f64; LANES] {
    const NONE: Self = [0.0; LANES];

    #[inline(always)]
    fn plus(self, factor: f64, other: &Self) -> Self {
        std::array::from_fn(|lane| self[lane] + factor * other[lane])
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        std::array::from_fn(|lane| self[lane] - other[lane])
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        self.map(|value| value * factor)
    }

    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        self.times(factor)
    }
}
