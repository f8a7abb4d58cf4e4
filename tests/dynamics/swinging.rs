//! The swinging cantilever, in `cases/dynamics/swinging_cantilever`.
//!
//! Sources: two other programs, one with the same elements and the same step, the other
//! with two-node elements, 200 of them: their tips agree within 4e-7.

use nalgebra::Vector3;

use crate::in_time::Run;
use crate::record;

/// After 0.2 s at 1 ms.
#[test]
fn the_tip_after_a_fifth_of_a_second() {
    let file = "swinging_cantilever.dynamics.toml";
    let run = Run::new("swinging_cantilever", file, 100, |question| {
        question.to = 0.2
    });
    let found = run.motion("beam/tip", 0.2).position;
    let expected = Vector3::new(0.839_347_753_6, 0.413_019_030_8, -0.266_564_889_7);
    let error = (found - expected).norm();
    let source = "the same elements in another program";
    record::largest(
        source,
        "swinging cantilever",
        "tip at 0.2 s [m]",
        error,
        1e-6,
    );
    assert!(error < 1e-6, "{found} {error:e}");
}
