//! Solvers by their public interface, on systems with known solutions.

// A failed unwrap fails the test, with its line.
#![allow(clippy::unwrap_used)]

mod arnoldi;
mod cholesky;
mod descriptor;
mod gmres;
mod linear;
mod newton;
mod pattern;
mod step;
