use super::models::{bipendulum, run};
use crate::analysis::transient::TransientFailure;
use crate::case::TransientQuestion;
use crate::integrator::Scheme;

#[test]
fn probe() {
    for radius in [0.0, 0.3, 0.6, 0.9] {
        for h in [0.0005, 0.001, 0.002, 0.003, 0.005] {
            let mut question = TransientQuestion::new(0.6, h);
            question.scheme = Scheme::TwoStep { radius };
            let model = bipendulum();
            let (kept, outcome) = run(&model, &question);
            let last = kept.states.last().unwrap();
            let spin: f64 = kept
                .states
                .iter()
                .map(|s| {
                    s.nodes
                        .iter()
                        .map(|n| (n.rotation.transpose() * n.angular_velocity).y.abs())
                        .fold(0.0, f64::max)
                })
                .fold(0.0, f64::max);
            let TransientFailure::Step(_) = outcome
                .failure
                .as_ref()
                .unwrap_or(&TransientFailure::Structure)
            else {
                println!(
                    "{radius} {h}: t {} spin {spin:.3e} x {:?} lam {:?} rejected {} it {}",
                    outcome.time,
                    last.nodes[1].position,
                    last.multipliers,
                    outcome.effort.rejected,
                    outcome.effort.iterations as f64 / outcome.effort.steps as f64
                );
                continue;
            };
            println!(
                "{radius} {h}: FAIL t {} spin {spin:.3e} {}",
                outcome.time,
                outcome.failure.unwrap()
            );
        }
    }
}
