//! Tests of the models of unsteady sections.

mod constants;
mod derivatives;
mod limits;
mod march;
pub(crate) mod polars;
mod stall;
mod theodorsen;
