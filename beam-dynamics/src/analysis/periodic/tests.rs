//! Periodic motion of small models.

#![allow(
    clippy::unwrap_used,
    reason = "tests end when a model cannot be analyzed"
)]
