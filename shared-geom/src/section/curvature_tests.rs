use nalgebra::Matrix6;

use super::*;

/// A strip 0.1 m wide along y and 0.01 m thick, of 70 GPa and a Poisson's ratio of 0.3.
fn strip() -> Matrix6<f64> {
    let (e, b, t) = (70e9, 0.1_f64, 0.01_f64);
    let (area, g) = (b * t, e / 2.6);
    let diagonal = [
        e * area,
        g * area,
        g * area,
        g * b * t.powi(3) / 3.0,
        e * b * t.powi(3) / 12.0,
        e * t * b.powi(3) / 12.0,
    ];
    Matrix6::from_diagonal(&diagonal.into())
}

fn bent(curvature: [f64; 3]) -> InitialCurvature {
    InitialCurvature {
        curvature: curvature.map(f64::to_radians).into(),
        ..InitialCurvature::STRAIGHT
    }
}

fn agreement(section: &InitialCurvature, line: &InitialCurvature) -> Agreement {
    Agreement::of(section, [*line; 2], &strip())
}

fn reported(section: &InitialCurvature, line: &InitialCurvature) -> String {
    match agreement(section, line) {
        Agreement::Other(mismatch) => {
            format!(
                "{mismatch}; {}; {}",
                mismatch.size(),
                mismatch.help().unwrap()
            )
        }
        other => panic!("{other:?}"),
    }
}

// For the twist of a strip, delta is K14 = E k1 (Ip - J) without J, which is 4 t^2/b^2 of
// Ip or 4 % here.
#[test]
fn delta_is_the_coupling_that_the_difference_of_twist_makes() {
    let k = strip();
    let (e, b, t) = (70e9, 0.1_f64, 0.01_f64);
    let k1 = 5.0_f64.to_radians();
    let polar = b * t * (b * b + t * t) / 12.0;
    let k14 = e * k1 * (polar - b * t.powi(3) / 3.0);
    let exact = k14 / (k[(0, 0)] * k[(3, 3)]).sqrt();
    let Agreement::Other(found) = agreement(&bent([5.0, 0.0, 0.0]), &bent([0.0; 3])) else {
        panic!("a straight line is another beam's");
    };
    assert!(
        found.delta > exact && found.delta < 1.045 * exact,
        "{} {exact}",
        found.delta
    );
    assert_eq!(found.delta, found.whole);
}

// A difference of 1 % is round-off of files, one up to 10 % is reported, and more is
// refused, unless the couplings by curvature are small relative to all others: at 0.05
// deg/m they are 0.0009 here.
#[test]
fn small_differences_pass_and_large_ones_do_not() {
    let section = bent([10.0, 0.0, 0.0]);
    let of = |rate| agreement(&section, &bent([rate, 0.0, 0.0]));
    assert_eq!(of(10.0), Agreement::Same);
    assert_eq!(of(10.09), Agreement::Same);
    assert!(matches!(of(10.5), Agreement::Near(_)));
    assert!(matches!(of(9.05), Agreement::Near(_)));
    assert!(matches!(of(11.1), Agreement::Other(_)));
    assert!(matches!(of(-10.0), Agreement::Other(_)));
    let gentle = bent([0.02, 0.0, 0.0]);
    let reverse = bent([-0.02, 0.0, 0.0]);
    assert!(matches!(agreement(&gentle, &reverse), Agreement::Near(_)));
    let curvature = bent([f64::NAN, 0.0, 0.0]);
    assert!(matches!(
        agreement(&curvature, &section),
        Agreement::Other(_)
    ));
}

// At a change of the twist rate from 4 to 8 deg/m the section may have either and any
// value between them.
#[test]
fn between_two_pieces_of_a_line_both_count() {
    let ends = [bent([4.0, 0.0, 0.0]), bent([8.0, 0.0, 0.0])];
    let of = |rate| Agreement::of(&bent([rate, 0.0, 0.0]), ends, &strip());
    for rate in [4.0, 5.5, 8.0] {
        assert_eq!(of(rate), Agreement::Same, "{rate}");
    }
    assert!(matches!(of(10.0), Agreement::Other(_)));
    let Agreement::Other(mismatch) = of(3.0) else {
        panic!("3 deg/m is far from 4");
    };
    assert!((mismatch.line.curvature.x.to_degrees() - 4.0).abs() < 1e-12);
}

#[test]
fn likely_causes_are_reported() {
    let section = bent([10.0, 0.0, 0.0]);
    let straight = reported(&section, &InitialCurvature::STRAIGHT);
    assert!(
        straight.contains("curvature [10, 0, 0] deg/m, and the line has curvature [0, 0, 0]")
            && straight.contains("the line is straight there"),
        "{straight}"
    );
    let reverse = reported(&section, &bent([-10.0, 0.0, 0.0]));
    assert!(reverse.contains("the signs are opposite"), "{reverse}");
    assert!(reverse.contains("with curvature = [-10, 0, 0] in deg/m and slope = [1, 0, 0]"));
    let radians = reported(&section, &bent([10.0_f64.to_radians(), 0.0, 0.0]));
    assert!(radians.contains("degrees for radians"), "{radians}");
    let inches = reported(&bent([10.0 / 0.0254, 0.0, 0.0]), &bent([10.0, 0.0, 0.0]));
    assert!(inches.contains("units of length"), "{inches}");
    let oblique = InitialCurvature {
        slope: Vector3::new(0.9, 0.4, 0.0).normalize(),
        ..section
    };
    let slopes = reported(&oblique, &section);
    assert!(
        slopes.contains("and slope [0.913812, 0.406138, 0]"),
        "{slopes}"
    );
    assert!(
        slopes.contains("is the reference point of the section"),
        "{slopes}"
    );
}

// For a section about a point off its line, the parameter is no longer the line's arc
// length: it is |l| times as long. Energy of the same motion per length of the same
// piece: 1/2 psi K psi per unit of the parameter, psi by it.
#[test]
fn per_arc_length_keeps_the_energy_of_a_piece() {
    let mut section = crate::section::tests::section();
    section.initial_curvature = Some(InitialCurvature {
        curvature: Vector3::new(0.3, -0.2, 0.1),
        slope: Vector3::new(1.2, 0.3, -0.1),
    });
    let c = section.initial_curvature.unwrap().slope.norm();
    let by_arc = section.per_arc_length();
    let psi = nalgebra::Vector6::new(1e-3, -2e-3, 5e-4, 0.1, -0.2, 0.3);
    let energy = |k: &Matrix6<f64>, psi: &nalgebra::Vector6<f64>| 0.5 * psi.dot(&(k * psi));
    // A piece of unit parameter is c long.
    let found = energy(&by_arc.stiffness, &(psi / c)) * c;
    assert!((found / energy(&section.stiffness, &psi) - 1.0).abs() < 1e-14);
    assert!((by_arc.mass * c - section.mass).amax() < 1e-14);
    let initial = by_arc.initial_curvature.unwrap();
    assert!((initial.slope.norm() - 1.0).abs() < 1e-15);
    // By its arc length it no longer changes, to round-off; nor by moving the point there
    // and back.
    let again = by_arc.per_arc_length();
    assert!((again.stiffness - by_arc.stiffness).amax() < 1e-15 * by_arc.stiffness.amax());
    let by = Vector2::new(0.2, -0.1);
    let there = section.shift(by).per_arc_length();
    let back = there.shift(-by).per_arc_length();
    assert!((back.stiffness - by_arc.stiffness).amax() < 1e-9 * by_arc.stiffness.amax());
    assert!((back.mass - by_arc.mass).amax() < 1e-12);
    let initial = back.initial_curvature.unwrap();
    assert!((initial.curvature - by_arc.initial_curvature.unwrap().curvature).amax() < 1e-15);
}
