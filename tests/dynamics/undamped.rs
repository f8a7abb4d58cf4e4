//! Damping ratios of undamped and of hardly damped modes.

use beam_dynamics::analysis::modes::modes;

/// A body on a spring and a damper, zeta = c / (2 sqrt(k m)), c = 20 zeta: a weak damper is not treated as
/// round-off, to the digits that a sum of k and c leaves (1e-16 / zeta); beyond zeta = 1 the motion
/// decays. Without a damper the ratio of every mode, of this body and of a swept blade with
/// bending, torsion and offsets, is zero.
#[test]
fn weak_dampers_remain_and_undamped_modes_have_no_damping() {
    let of = |text: &str| {
        let input = beam_dynamics::input::parse(text, "a.dynamics.toml").unwrap();
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        outcome.table
    };
    let body = |damping: f64| {
        of(&format!(
            "units = \"SI\"\n[[node]]\nname = \"a\"\nposition = [0, 0, 0]\n[[body]]\nnode = \"a\"\n\
             mass = 1\ninertia = [1, 1, 1]\n[[spring]]\nnode = \"a\"\nstiffness = [100, 200, 300]\n\
             rotational_stiffness = [900, 900, 900]\ndamping = [{damping}, 0, 0]\n\
             [modes]\nspeeds = 0\ncount = 4\n"
        ))
    };
    let ratios = |table: &beam_dynamics::result::FrequencyTable| -> Vec<f64> {
        let points = table.branches.iter().flat_map(|branch| &branch.points);
        points.flatten().map(|point| point.damping_ratio).collect()
    };
    for zeta in [1e-8, 1e-6, 0.02, 0.9] {
        let found = ratios(&body(20.0 * zeta)).into_iter().fold(0.0, f64::max);
        assert!((found / zeta - 1.0).abs() < 1e-6, "{zeta}: {found}");
    }
    let overdamped = body(60.0);
    // s = -30 + sqrt(800), the slow one of the two.
    let slow = -30.0 + 800_f64.sqrt();
    assert!((overdamped.decaying[0][0].growth / slow - 1.0).abs() < 1e-9);
    assert!(ratios(&overdamped).iter().all(|ratio| *ratio == 0.0));
    assert!(ratios(&body(0.0)).iter().all(|ratio| *ratio == 0.0));
    let swept = of(
        "units = \"SI\"\n[properties.p]\nea = 2.8e7\ngay = 8.974e6\ngaz = 8.974e6\ngj = 302.4\n\
         eiy = 233.3\neiz = 3733\nm = 1.08\niy = 9e-6\niz = 1.44e-4\nmass_center = [0.01, 0.002]\n\
         [[blade]]\nname = \"b\"\nroot = [0.1, 0, 0]\nproperties = \"p\"\n\
         [[blade.piece]]\nlength = 2\nelements = 6\n[[blade.piece]]\nlength = 0.5\nelements = 2\n\
         sweep = 30\n[modes]\nspeeds = [0, 300, 600]\ncount = 10\n",
    );
    assert!(
        ratios(&swept).iter().all(|ratio| *ratio == 0.0),
        "{:?}",
        ratios(&swept)
    );
}
