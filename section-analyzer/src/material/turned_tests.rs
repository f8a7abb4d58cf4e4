use super::*;
use crate::material::samples::pzt_5h;
use approx::assert_relative_eq;
use nalgebra::{Matrix3x6, Rotation3};

/// Tensor indices of a pair in the order 11 22 33 23 13 12.
fn pair(i: usize, j: usize) -> usize {
    let is_it = |known: &(usize, usize)| *known == (i.min(j), i.max(j));
    MATERIAL_ORDER.iter().position(is_it).unwrap()
}

/// `c_abcd = q_ai q_bj q_ck q_dl c'_ijkl`, index by index.
fn fourth_order(q: &Matrix3<f64>, c: &Matrix6<f64>) -> Matrix6<f64> {
    Matrix6::from_fn(|row, column| {
        let ((a, b), (d, f)) = (MATERIAL_ORDER[row], MATERIAL_ORDER[column]);
        let mut sum = 0.0;
        for index in 0..81 {
            let [i, j, k, l] = [index / 27, index / 9 % 3, index / 3 % 3, index % 3];
            sum += q[(a, i)] * q[(b, j)] * q[(d, k)] * q[(f, l)] * c[(pair(i, j), pair(k, l))];
        }
        sum
    })
}

/// `e_abc = q_ai q_bj q_ck e'_ijk`, index by index.
fn third_order(q: &Matrix3<f64>, e: &Matrix3x6<f64>) -> Matrix3x6<f64> {
    Matrix3x6::from_fn(|a, column| {
        let (b, c) = MATERIAL_ORDER[column];
        let mut sum = 0.0;
        for index in 0..27 {
            let [i, j, k] = [index / 9, index / 3 % 3, index % 3];
            sum += q[(a, i)] * q[(b, j)] * q[(c, k)] * e[(i, pair(j, k))];
        }
        sum
    })
}

/// Constants without any symmetry, rotated arbitrarily, equal the tensors computed index
/// by index, to rounding.
#[test]
fn constants_turn_as_tensors() {
    let q = *Rotation3::from_euler_angles(0.3, -1.1, 2.2).matrix();
    let c = Matrix6::from_fn(|i, j| 1.0 / (1 + i + j) as f64 + if i == j { 2.0 } else { 0.0 });
    let e = Matrix3x6::from_fn(|i, j| ((7 * i + 3 * j) % 5) as f64 - 1.5);
    let permittivity = Matrix3::new(3.0, 0.2, 0.1, 0.2, 2.0, -0.3, 0.1, -0.3, 1.0);
    let ElasticLaw::Full(turned) = ElasticLaw::Full(c).turned(&q) else {
        panic!("a full stiffness");
    };
    assert_relative_eq!(turned, fourth_order(&q, &c), epsilon = 1e-13);
    let law = ElectricLaw {
        coupling: e,
        permittivity,
    };
    let turned = law.turned(&q);
    assert_relative_eq!(turned.coupling, third_order(&q, &e), epsilon = 1e-13);
    let back = turned.turned(&q.transpose());
    assert_relative_eq!(back.coupling, e, epsilon = 1e-13);
    assert_relative_eq!(back.permittivity, permittivity, epsilon = 1e-13);
}

/// Poled along the fiber, e33 is e11 and e31 is e12 and e13, by the meaning of the axes:
/// a field along the poling extends along it and contracts across.
#[test]
fn poling_along_material_axes_permutes_the_constants() {
    let e = pzt_5h().electric.unwrap().coupling;
    let poled = |axis: f64, along: usize| {
        let mut poling = Vector3::zeros();
        poling[along] = axis;
        let q = data_axes(&poling, None).unwrap();
        assert_eq!(q.determinant(), 1.0);
        pzt_5h().turned(&q).unwrap()
    };
    for along in 0..3 {
        for sign in [1.0, -1.0] {
            let turned = poled(sign, along).electric.unwrap().coupling;
            for j in 0..3 {
                let own = if j == along { e[(2, 2)] } else { e[(2, 0)] };
                assert_relative_eq!(turned[(along, j)], sign * own, max_relative = 1e-14);
            }
        }
    }
    assert_eq!(poled(1.0, 2), pzt_5h());
    // less stiff along the poling than across: c33 < c11
    let ElasticLaw::Full(c) = poled(1.0, 0).law else {
        panic!("a full stiffness")
    };
    let own = pzt_5h().law.stiffness();
    assert_relative_eq!(c[(0, 0)], own[(2, 2)], max_relative = 1e-14);
    assert_relative_eq!(c[(1, 1)], own[(0, 0)], max_relative = 1e-14);
    assert_relative_eq!(c[(3, 3)], own[(5, 5)], max_relative = 1e-14);
}

#[test]
fn directions_need_not_be_of_unit_length_but_at_a_right_angle() {
    let axes = |poling: [f64; 3], across: Option<[f64; 3]>| {
        data_axes(&poling.into(), across.map(Vector3::from).as_ref())
    };
    let q = axes([0.0, 3e-200, 3e-200], Some([2.0, 0.0, 0.0])).unwrap();
    assert_relative_eq!(q * q.transpose(), Matrix3::identity(), epsilon = 1e-15);
    assert_relative_eq!(q[(1, 2)], 0.5_f64.sqrt(), max_relative = 1e-15);
    // four written digits
    assert!(axes([0.6, 0.8, 0.0], Some([0.8, -0.6001, 0.0])).is_ok());
    let problem = axes([0.0, 0.0, 1.0], Some([1.0, 0.0, 1.0])).unwrap_err();
    assert_eq!(
        problem.to_string(),
        "\"poling\" and \"across\" are at 45.000 deg, expected a right angle"
    );
    let parallel = axes([0.0, 0.0, 1.0], Some([0.0, 0.0, -2.0])).unwrap_err();
    assert!(matches!(parallel, AxesProblem::NotOrthogonal { angle } if angle == 180.0));
    let zero = axes([0.0; 3], None).unwrap_err();
    assert_eq!(zero, AxesProblem::NoDirection { key: "poling" });
    let open = axes([1.0, 1.0, 0.0], None).unwrap_err();
    assert_eq!(open, AxesProblem::NoAcross);
}

#[test]
fn expansions_turn_with_the_axes_or_are_refused() {
    let expanding = Material {
        expansion: Some([1e-6, 2e-6, 3e-6]),
        ..pzt_5h()
    };
    let q = data_axes(&Vector3::x(), None).unwrap();
    // 1' is along 2, 2' along 3, 3' along 1
    let turned = expanding.turned(&q).unwrap().expansion.unwrap();
    assert_eq!(turned, [3e-6, 1e-6, 2e-6]);
    let q = data_axes(&Vector3::new(1.0, 0.0, 1.0), Some(&Vector3::y())).unwrap();
    assert!(matches!(
        expanding.turned(&q),
        Err(AxesProblem::ShearedExpansion { .. })
    ));
    let even = Material {
        expansion: Some([1e-6; 3]),
        ..expanding
    };
    assert_eq!(even.turned(&q).unwrap().expansion, Some([1e-6; 3]));
}
