//! Steady flow, reverse flow, invalid input, and the list of models.

use super::polars::Smooth;
use crate::airfoil::Flow;
use crate::unsteady::{Model, Polar, SectionFlow, SectionModel, Strip};

const STRIP: Strip = Strip {
    chord: 0.4,
    density: 1.2,
};

fn models() -> impl Iterator<Item = SectionModel> {
    SectionModel::WORDS
        .iter()
        .map(|word| SectionModel::of_word(word).unwrap())
}

fn steady(angle: f64, mach: f64) -> SectionFlow<f64> {
    let (sin, cos) = angle.sin_cos();
    SectionFlow {
        mach,
        reynolds: 1e6,
        flap: 0.02,
        ..SectionFlow::rigid(60.0 * sin, 60.0 * cos, 0.0, STRIP.chord)
    }
}

#[test]
fn steady_flow_gives_static_coefficients_at_every_angle() {
    for model in models() {
        let size = model.states().len();
        for degree in -180..=180 {
            let angle = f64::from(degree).to_radians();
            let flow = steady(angle, 0.4);
            let (mut states, rates) = (vec![0.0; size], vec![0.0; size]);
            let mut rows = vec![1.0; size];
            model.start(&STRIP, &Smooth, &flow, &mut states).unwrap();
            let force = model
                .evaluate(&STRIP, &Smooth, &flow, &states, &rates, &mut rows)
                .unwrap();
            let at = Flow {
                alpha: angle,
                mach: 0.4,
                reynolds: 1e6,
                flap: 0.02,
            };
            let it = Smooth.coefficients(&at);
            let load = 0.5 * 1.2 * 3600.0 * 0.4;
            let (sin, cos) = angle.sin_cos();
            // Rounding, and the relative error of the rounded speed, (0.01 / 60)^2.
            let close = |found: f64, expected: f64| (found - expected).abs() < 1e-7 * load;
            let [word, near] = [model.word(), "steady forces"];
            assert!(
                close(force.normal, load * (it.lift * cos + it.drag * sin)),
                "{word} {near} {degree}"
            );
            assert!(
                close(force.along, load * (it.lift * sin - it.drag * cos)),
                "{word} {near} {degree}"
            );
            assert!(
                close(force.moment, load * 0.4 * it.moment),
                "{word} {near} {degree}"
            );
            // Rest differs from the static part by the rounded speed.
            let worst = rows.iter().fold(0.0_f64, |worst, it| worst.max(it.abs()));
            assert!(worst < 1e-3, "{word} {degree}: rows {rows:?}");
        }
    }
}

#[test]
fn without_flow_there_is_no_force_and_a_state_of_rest() {
    let flow = SectionFlow::rigid(0.0, 0.0, 0.0, STRIP.chord);
    for model in models() {
        let size = model.states().len();
        let (mut states, rates, mut rows) = (vec![0.0; size], vec![0.0; size], vec![0.0; size]);
        model.start(&STRIP, &Smooth, &flow, &mut states).unwrap();
        let force = model
            .evaluate(&STRIP, &Smooth, &flow, &states, &rates, &mut rows)
            .unwrap();
        assert_eq!([force.along, force.normal, force.moment], [0.0; 3]);
        // The attached part at rest is 1, at the start the static part at no angle, which is
        // nearly 1: the decay of the difference is slow.
        assert!(
            rows.iter().all(|it| it.abs() < 1e-2),
            "{}: {rows:?}",
            model.word()
        );
    }
}

#[test]
fn wrong_lengths_give_nothing_and_wrong_numbers_do_not_panic() {
    for model in models() {
        let size = model.states().len();
        let flow = steady(0.1, 0.3);
        let wrong = vec![0.0; size + 1];
        let mut rows = vec![7.0; size + 1];
        assert!(
            model
                .evaluate(&STRIP, &Smooth, &flow, &wrong, &wrong, &mut rows)
                .is_none()
        );
        assert!(rows.iter().all(|&it| it == 7.0));
        assert!(model.start(&STRIP, &Smooth, &flow, &mut rows).is_none());
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX] {
            let flow = SectionFlow {
                normal: bad,
                mach: bad,
                ..flow
            };
            let states = vec![bad; size];
            let mut rows = vec![0.0; size];
            assert!(
                model
                    .evaluate(&STRIP, &Smooth, &flow, &states, &states, &mut rows)
                    .is_some()
            );
            assert!(model.start(&STRIP, &Smooth, &flow, &mut rows).is_some());
        }
    }
}

#[test]
fn words_name_models_and_states_have_names() {
    for word in SectionModel::WORDS {
        let model = SectionModel::of_word(word).unwrap();
        assert_eq!(model.word(), *word);
        let states = model.states();
        for (i, state) in states.iter().enumerate() {
            assert!(
                states[..i].iter().all(|it| it.name != state.name),
                "{word}: {}",
                state.name
            );
        }
    }
    assert!(SectionModel::of_word("none").is_none());
    assert_eq!(SectionModel::default().word(), "separation_lag");
}
