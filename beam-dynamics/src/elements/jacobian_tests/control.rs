//! Systems of states.

use nalgebra::DMatrix;

use super::{Random, check, sensing};
use crate::elements::Signal;
use crate::elements::control::{Balanced, Kept, Matrices, StateSpace, Wave};
use crate::model::{Drive, ScalarStart};

#[test]
fn controls_and_targets() {
    let mut random = Random(71);
    let of = |start| Kept::state("trim", "number", start, 0.3);
    let control = of(ScalarStart::Constant(0.4));
    check(&Kept::control(control, 0.4), &[], &mut random);
    let wave = |is_sine| Wave {
        frequency: 2.3,
        from: 0.2,
        is_sine,
    };
    for wave in [None, Some(wave(false)), Some(wave(true))] {
        let signals = vec![sensing::sensing()];
        let integral = Kept::integral(of(ScalarStart::Value(0.0)), signals, wave);
        check(&integral, &[], &mut random);
    }
    let control = Balanced::control("trim", "number", 0.4, 0.3);
    let quantity = StateSpace::output("target", "y");
    let balanced = Balanced::new((control, 0.4), quantity, [2.0, 0.7]);
    check(&balanced, &[], &mut random);
}

#[test]
fn systems_of_states() {
    let mut random = Random(70);
    for [states, outputs] in [[0, 2], [1, 1], [3, 2], [2, 0]] {
        let inputs = vec![
            sensing::sensing(),
            Signal::Drive(Drive::Constant(0.3)),
            sensing::sensing(),
        ];
        let mut matrix = |rows, columns| DMatrix::from_fn(rows, columns, |_, _| random.number());
        let matrices = Matrices {
            a: matrix(states, states),
            b: matrix(states, 3),
            c: matrix(outputs, states),
            d: matrix(outputs, 3),
        };
        assert_eq!(matrices.sizes(), [states, 3, outputs]);
        let outputs = (0..outputs).map(|i| StateSpace::output("law", &format!("y{i}")));
        let start = vec![ScalarStart::Settled; states];
        let system = StateSpace::new("law", matrices, inputs, outputs.collect(), &start);
        assert_eq!(system.states().len(), states);
        check(&system, &[], &mut random);
    }
}
