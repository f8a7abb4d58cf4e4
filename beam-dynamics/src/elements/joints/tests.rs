//! Joints against what statics says of them.
#![allow(clippy::unwrap_used, reason = "a failing helper fails the test")]
