//! Differences of two blades.

use super::tests::blade;
use super::{Blade, BladeDamping, BladeDifference};

fn of<'a>(all: &'a [BladeDifference], name: &str) -> &'a BladeDifference {
    all.iter()
        .find(|one| one.name == name)
        .unwrap_or_else(|| panic!("{name} in {all:?}"))
}

#[test]
fn a_blade_equals_itself_about_another_point() {
    let a = blade();
    assert!(a.compare(&a).iter().all(|one| one.relative == 0.0));
    let b = a.shift(nalgebra::Vector2::new(0.3, -0.2));
    let worst = a
        .compare(&b)
        .iter()
        .map(|one| one.relative)
        .fold(0.0, f64::max);
    // Two shifts by a third of a meter of numbers up to 40.
    assert!(worst > 0.0 && worst < 1e-13, "{worst:e}");
}

// The fourth station, at 7 m, is changed: 2 % of an entry, relative to the diagonal.
#[test]
fn each_difference_is_found_at_its_position() {
    let a = blade();
    let mut b = a.clone();
    let k = a.stations[3].stiffness;
    let change = 0.02 * f64::sqrt(k[(0, 0)] * k[(4, 4)]);
    b.stations[3].stiffness[(0, 4)] += change;
    b.stations[3].stiffness[(4, 0)] += change;
    b.stations[3].mass *= 1.1;
    b.line.points[1].twist += 0.01;
    let all = a.compare(&b);
    let coupling = of(&all, "stiffness axial, bending y");
    assert!((coupling.relative - 0.02).abs() < 1e-12, "{coupling:?}");
    assert!((coupling.at.unwrap() - 7.0).abs() < 1e-12 && coupling.unit == "N m");
    let mass = of(&all, "mass axial");
    assert!((mass.relative - 0.1).abs() < 1e-12 && (mass.b - 2.2).abs() < 1e-12);
    // Linear to zero at 3 m and at 10 m: 0.2 kg/m over 7 m, halved.
    let total = of(&all, "mass");
    assert!((total.b - total.a - 0.7).abs() < 1e-12, "{total:?}");
    let twist = of(&all, "twist");
    assert!((twist.relative - 0.01).abs() < 1e-12 && twist.unit == "rad");
    assert_eq!(of(&all, "stiffness torsion").relative, 0.0);
}

// A file that replaces the jump at 3 m by a ramp of 1e-8 of the length has the same
// properties on both sides: next to it they differ by some 1e-6 of the change over 1 m.
#[test]
fn a_jump_and_its_ramp_are_equal_and_a_moved_jump_is_not() {
    let a = blade();
    let moved = |by: f64| -> f64 {
        let mut b: Blade = a.clone();
        b.stations[2].arc_length += by;
        let all = a.compare(&b);
        of(&all, "mass axial").relative
    };
    assert!(moved(1e-7) < 1e-6, "{:e}", moved(1e-7));
    assert!(moved(0.1) > 0.1, "{:e}", moved(0.1));
}

#[test]
fn damping_of_one_blade_alone_is_a_difference() {
    let a = blade();
    let mut b = a.clone();
    b.damping = Some(BladeDamping::Proportional(0.01));
    let all = a.compare(&b);
    assert_eq!(of(&all, "damping torsion").relative, 1.0);
    assert!(
        a.compare(&a)
            .iter()
            .all(|one| !one.name.starts_with("damping"))
    );
}
