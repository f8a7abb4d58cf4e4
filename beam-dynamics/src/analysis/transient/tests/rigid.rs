//! Rigid bodies.

use super::models::{bipendulum, pendulum, states};
use crate::case::TransientQuestion;

#[test]
fn probe_start() {
    let found = states(&pendulum(), &TransientQuestion::new(0.1, 1.0 / 150.0));
    for s in &found[..5] {
        println!("{:?} {:?}", s.multipliers, s.nodes[0].position);
    }
    let found = states(&bipendulum(), &TransientQuestion::new(0.01, 0.001));
    for s in &found[..5] {
        println!("{:?}", s.multipliers);
    }
}
