//! Systems of states.

use nalgebra::DMatrix;

use super::{Random, check, sensing};
use crate::elements::Signal;
use crate::elements::control::{Matrices, StateSpace};
use crate::model::{Drive, ScalarStart};

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
