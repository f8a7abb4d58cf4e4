//! Numbers with derivatives.

use num_dual::{DualNum, DualNumCopy};

/// A number, or a number with its derivatives by some variables (`num_dual`).
///
/// A kernel that is generic over it gives values for `f64`, and exact derivatives for dual
/// numbers. Branches compare values alone: `x.re()`.
pub trait Real: DualNumCopy + DualNum<Primitive = f64> {}

impl<T: DualNumCopy + DualNum<Primitive = f64>> Real for T {}
