//! Sections from files against sections whose cells are known in closed form.

// A failed unwrap fails the test, with its line.
#![allow(clippy::unwrap_used)]

mod follow;
mod schema;
