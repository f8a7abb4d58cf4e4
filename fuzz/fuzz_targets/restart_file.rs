//! Restart files of the model in `support`: a state that fits is continued for some steps.
#![no_main]

use std::path::Path;
use std::sync::LazyLock;

use beam_dynamics::analysis::transient::{difference, transient};
use beam_dynamics::input::{self, Input};
use beam_dynamics::output::parse_snapshot;
use beam_dynamics::result::{AcceptedStep, Recorder};
use libfuzzer_sys::fuzz_target;

/// Steps that are continued.
const STEPS: usize = 3;

static INPUT: LazyLock<Input> = LazyLock::new(|| {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/support/strip.dynamics.toml");
    input::read(Path::new(file)).expect("the file of this folder is sound")
});

/// Ends a run after some steps.
struct Few(usize);

impl Recorder for Few {
    fn record(&mut self, _: &AcceptedStep<'_>) -> bool {
        self.0 += 1;
        self.0 < STEPS
    }
}

fuzz_target!(|bytes: &[u8]| {
    match parse_snapshot(bytes, Path::new("a.restart.json")) {
        Ok(snapshot) => {
            let settings = INPUT.transient.as_ref().expect("the file has [transient]");
            let fits = difference(&INPUT.model, &snapshot).is_none();
            if fits && snapshot.progress.time < settings.to {
                let _ = transient(
                    &INPUT.model,
                    settings,
                    Some(&snapshot),
                    &mut Few(0),
                    &|| 0.0,
                );
            }
        }
        Err(problem) => assert!(!problem.to_string().is_empty()),
    }
});
