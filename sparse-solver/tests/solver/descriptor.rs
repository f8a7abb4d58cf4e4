//! Small systems with closed forms.

use faer::Mat;

use sparse_solver::{Descriptor, DescriptorState, NotMinimal, minimal};

/// A system from entries `(row, column, value)` of E, K and F.
fn system(size: [usize; 2], entries: [&[(usize, usize, f64)]; 3]) -> Descriptor {
    let [n, inputs] = size;
    let matrix = |columns: usize, entries: &[(usize, usize, f64)]| {
        let mut matrix = Mat::zeros(n, columns);
        entries
            .iter()
            .for_each(|&(i, j, value)| matrix[(i, j)] = value);
        matrix
    };
    Descriptor {
        by_rates: matrix(n, entries[0]),
        by_unknowns: matrix(n, entries[1]),
        by_inputs: matrix(inputs, entries[2]),
    }
}

/// Masses 1 and 2 kg, moved together by the constraint `x_1 - x_2 = 0` against a spring of 12 N/m;
/// unknowns x_1, x_2, p_1, p_2 and the multiplier, the input a force on the second. `moved` is the
/// distance of the masses for an input of one.
fn pair(moved: f64) -> Descriptor {
    let rates = [(0, 0, -1.0), (1, 1, -2.0), (2, 2, -1.0), (3, 3, -1.0)];
    let unknowns = [
        (0, 2, 1.0),
        (1, 3, 1.0),
        (2, 0, -12.0),
        (2, 4, 1.0),
        (3, 4, -1.0),
        (4, 0, 1.0),
        (4, 1, -1.0),
    ];
    system([5, 1], [&rates, &unknowns, &[(3, 0, 1.0), (4, 0, moved)]])
}

// Frequency sqrt(12/3) = 2 rad/s; the multiplier accelerates the first mass: m_1 (f - k x)/(m_1 + m_2)
// + k x = f/3 + 8 x.
#[test]
fn a_constraint_of_positions() {
    let found = minimal(&pair(0.0), 2.0).unwrap();
    assert_eq!(found.a.nrows(), 2);
    let square = &found.a * &found.a;
    let off = square + 4.0 * Mat::<f64>::identity(2, 2);
    assert!(off.norm_max() < 1e-14, "{off:?}");
    assert!((found.by_inputs[(4, 0)] - 1.0 / 3.0).abs() < 1e-14);
    let place = |unknown| found.states.iter().position(|own| own.unknown == unknown);
    let position = place(0).or(place(1)).unwrap();
    assert!((found.by_states[(4, position)] - 8.0).abs() < 1e-14);
    assert!(found.residual < 1e-14, "{:e}", found.residual);
}

#[test]
fn an_input_that_moves_a_constraint_is_named() {
    let found = minimal(&pair(0.1), 2.0).map(|found| found.a.nrows());
    assert_eq!(found, Err(NotMinimal::Prescribed(0)));
}

// A spring k_1 = 3 N/m, a point without mass, and a damper c = 2 N s/m in parallel with k_2 = 5 N/m to
// the ground: c y' = -(k_1 + k_2) y + k_1 u for the displacement u of the other end. The force of the
// spring is an algebraic unknown: k_1 (y - u).
#[test]
fn a_point_without_mass() {
    let system = system(
        [2, 1],
        [
            &[(0, 0, 2.0)],
            &[(0, 0, 5.0), (0, 1, 1.0), (1, 0, -3.0), (1, 1, 1.0)],
            &[(1, 0, 3.0)],
        ],
    );
    let found = minimal(&system, 1.0).unwrap();
    let expected = DescriptorState {
        unknown: 0,
        is_part: false,
    };
    assert_eq!(found.states, [expected]);
    for (found, expected) in [
        (found.a[(0, 0)], -4.0),
        (found.b[(0, 0)], 1.5),
        (found.by_states[(1, 0)], 3.0),
        (found.by_inputs[(1, 0)], -3.0),
    ] {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
}

// E of rank one in two unknowns: the sum has the rate, their difference follows from the input.
#[test]
fn a_rate_of_a_sum() {
    let system = system(
        [2, 1],
        [
            &[(0, 0, 1.0), (0, 1, 1.0)],
            &[(0, 0, 2.0), (1, 0, 1.0), (1, 1, -1.0)],
            &[(1, 0, -1.0)],
        ],
    );
    // x = (s + u)/2, y = (s - u)/2, s' = -2 x = -s - u.
    let found = minimal(&system, 1.0).unwrap();
    assert!(found.states[0].is_part);
    assert!((found.a[(0, 0)] + 1.0).abs() < 1e-14);
    // The state is a multiple of s by its unknown without the input.
    let by_state = [0, 1].map(|i| found.by_states[(i, 0)]);
    assert!((by_state[0] - by_state[1]).abs() < 1e-14);
    for (i, expected) in [0.5, -0.5].into_iter().enumerate() {
        assert!((found.by_inputs[(i, 0)] - expected).abs() < 1e-14);
    }
    assert!(found.residual < 1e-14);
}

// The same constraint twice: the two multipliers are not determined; and an unknown in no equation.
#[test]
fn what_is_not_determined_is_named() {
    let pair = pair(0.0);
    let grown = |from: &Mat<f64>, columns: usize| {
        Mat::from_fn(6, columns, |i, j| match (i, j) {
            _ if i < 5 && j < from.ncols().min(5) => from[(i, j)],
            (5, _) if j < from.ncols().min(5) => from[(4, j)],
            (_, 5) => from[(i.min(4), 4)],
            _ => 0.0,
        })
    };
    let doubled = Descriptor {
        by_rates: grown(&pair.by_rates, 6),
        by_unknowns: grown(&pair.by_unknowns, 6),
        by_inputs: grown(&pair.by_inputs, 1),
    };
    let found = minimal(&doubled, 2.0).map(|found| found.a.nrows());
    assert!(
        matches!(found, Err(NotMinimal::Undetermined(4 | 5))),
        "{found:?}"
    );
    let alone = system([2, 0], [&[(0, 0, 1.0)], &[(0, 0, 1.0)], &[]]);
    let found = minimal(&alone, 1.0).map(|found| found.a.nrows());
    assert_eq!(found, Err(NotMinimal::Undetermined(1)));
}
