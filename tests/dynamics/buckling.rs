//! Critical loads by linearized prestress against closed forms.

use beam_dynamics::analysis::buckling::buckling;
use beam_dynamics::case::BucklingQuestion;
use beam_dynamics::elements::loads::NodalForce;
use nalgebra::{Vector3, Vector6};

use crate::chain::{Chain, DEAD};
use crate::record;

fn factors(chain: Chain, count: usize) -> Vec<f64> {
    let question = BucklingQuestion { speed: 0.0, count };
    let outcome = buckling(&chain.model(), &question);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    println!("{:?} {:?}", outcome.result.remarks, outcome.result.modes);
    outcome
        .result
        .modes
        .iter()
        .map(|mode| mode.factor)
        .collect()
}

fn column(elements: usize, shear: f64) -> Chain {
    let stiffness = Vector6::new(1e7, shear, shear, 1.0, 1.0, 1.0);
    let mut chain = Chain::new();
    let ends = [Vector3::zeros(), Vector3::x()];
    let on = chain.straight(None, elements, &stiffness, ends, Vector3::z());
    chain.clamp(0);
    chain.load(
        on[2 * elements],
        NodalForce {
            force: -Vector3::x(),
            ..DEAD
        },
    );
    chain
}

#[test]
fn debug_buckling() {
    for shear in [1e4, 1e7] {
        for n in [1, 2, 4] {
            let f = factors(column(n, shear), 4);
            println!("{shear} {n} {f:?}");
            for f in f {
                println!(
                    "  {} {}",
                    f * (1.0 + f / shear),
                    f * (1.0 + f / shear - f / 1e7)
                );
            }
        }
    }
    println!(
        "{} {}",
        6.0 * (5.0 - 21f64.sqrt()),
        6.0 * (5.0 + 21f64.sqrt())
    );
}
