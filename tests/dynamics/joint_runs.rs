//! Runs in time of small mechanisms defined here, and the observations of their joints.

use std::fs;

use beam_dynamics::elements::{JointState, Observations};
use nalgebra::Vector3;

use crate::in_time::Run;
use crate::record;

/// SI, with angles in radians.
const UNITS: &str =
    r#"units = { length = "m", force = "N", angle = "rad", rotation_speed = "rad/s" }"#;

/// Steps after which a run has settled: forces of the first steps are of first order. Their error
/// decays as n^3 / 6 0.6^n, both roots of the scheme being -0.6 and the forces its second
/// difference: after thirty steps it is 1e-3, which is still visible compared with the errors of
/// second order; after sixty 2e-9.
const SETTLED: usize = 60;

/// A mechanism in motion.
pub struct Mechanism {
    pub run: Run,
}

impl Mechanism {
    /// The cards, run from zero to the time `to` in equal steps. Iterations continue to round-off.
    pub fn new(cards: &str, to: f64, step: f64) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mechanism.dynamics.toml");
        let time = format!("[transient]\nto = {to}\nstep = {step}\nnewton.tolerance = 1e-12\n");
        fs::write(&path, format!("{UNITS}\n{cards}\n{time}")).unwrap();
        let run = Run::of_file(&path, 1, |_| {});
        run.check_end();
        Self { run }
    }

    /// Largest value of a measure of the observations: at the start, and after the run has settled.
    pub fn most(&self, measure: impl Fn(f64, &Observations) -> f64) -> f64 {
        let model = &self.run.model;
        let of = |(time, state): &(f64, _)| {
            let observed = model.system.observe(state, &model.conditions_at(*time));
            measure(*time, &observed)
        };
        let instants = self.run.instants.iter().enumerate();
        let observed = instants.filter(|(step, _)| *step == 0 || *step >= SETTLED);
        observed.map(|(_, instant)| of(instant)).fold(0.0, f64::max)
    }

    /// The same of one joint.
    pub fn most_of(&self, joint: &str, measure: impl Fn(f64, &JointState) -> f64) -> f64 {
        self.most(|time, observed| measure(time, find(observed, joint)))
    }
}

/// The observation of the joint called `name`.
pub fn find<'a>(observed: &'a Observations, name: &str) -> &'a JointState {
    let found = observed.joints.iter().find(|joint| joint.joint == name);
    found.unwrap_or_else(|| panic!("no joint \"{name}\""))
}

/// Largest difference of components.
pub fn off(a: Vector3<f64>, b: Vector3<f64>) -> f64 {
    (a - b).amax()
}

/// Records and checks an error that is round-off.
pub fn check(case: &str, quantity: &str, error: f64, tolerance: f64) {
    record::largest("closed form", case, quantity, error, tolerance);
    assert!(error < tolerance, "{case}, {quantity}: {error:e}");
}

/// Records and checks errors by steps h and h/2: of second order, and the finer one below
/// the tolerance.
pub fn check_order(case: &str, quantity: &str, errors: [f64; 2], tolerance: f64) {
    let order = (errors[0] / errors[1]).log2();
    record::largest("closed form", case, quantity, errors[1], tolerance);
    let of = format!("order of {quantity}");
    record::order("closed form", case, &of, order, 1.8);
    assert!(order > 1.8, "{case}, {quantity}: order {order}, {errors:?}");
    assert!(errors[1] < tolerance, "{case}, {quantity}: {errors:?}");
}
