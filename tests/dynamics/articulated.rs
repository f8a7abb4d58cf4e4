//! Articulated blades under weight, with dampers, and strongly damped blades: the correct
//! equilibrium, and all modes.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::result::FrequencyTable;

use super::effort::cases;
use super::variational_beam::spectra::Random;

const STRIP: &str = "units = \"SI\"\n[properties.p]\nea = 7e7\ngay = 9e6\ngaz = 5e6\n\
    gj = 8e3\neiy = 7e3\neiz = 1e5\nm = 11\niy = 0.001\niz = 0.018\n";

const BLADE: &str = "[[blade]]\nname = \"b\"\nprecone = 3\nhub_radius = 0.5\n\
    properties = \"p\"\n[[blade.piece]]\nlength = 5\nelements = 6\n";

fn table(cards: &str) -> FrequencyTable {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.dynamics.toml");
    std::fs::write(&file, cards).unwrap();
    let input = beam_dynamics::input::read(&file).unwrap();
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.table
}

fn hinged(hinges: &str, rest: &str) -> FrequencyTable {
    let blade = BLADE.replace(
        "[[blade.piece]]",
        &format!("hinges = {hinges}\n[[blade.piece]]"),
    );
    table(&format!("{STRIP}{blade}{rest}"))
}

/// A blade on free hinges with weight: in rotation it straightens out, for any previous speeds. The
/// weight is 0.2 % of the centrifugal force at 300 rpm (9.81 m/s^2 against 986 m/s^2 times 3 m), so
/// that the frequencies agree with the frequencies without weight within 1 %; a rigid blade on a
/// hinge at 0.3 m of 5.5 m lags with sqrt(1.5 e / (L - e)) = 0.294 of the speed.
#[test]
fn weight_does_not_fold_a_blade_on_free_hinges() {
    const FREE: &str = "[{ kind = \"flap\", offset = 0.15 }, { kind = \"lag\", offset = 0.3 }]";
    let gravity = "[gravity]\nacceleration = [0, 0, -9.81]\n";
    let at_300 = |table: &FrequencyTable| -> Vec<f64> {
        let last = table.speeds.len() - 1;
        assert!(!table.remarks.iter().any(|remark| remark.contains("folded")));
        let points = table.at_speed(last).into_iter().take(4);
        points.map(|(_, point)| point.frequency).collect()
    };
    let weightless = hinged(FREE, "[modes]\nspeeds = [300]\ncount = 4\n");
    let expected = at_300(&weightless);
    let lag = (1.5 * 0.3 / 5.2_f64).sqrt() * 5.0;
    assert!(
        (expected[0] / lag - 1.0).abs() < 0.02,
        "{} {lag}",
        expected[0]
    );
    for speeds in ["[300]", "[50, 150, 300]", "[0, 50, 150, 300]"] {
        let cards = format!("{gravity}[modes]\nspeeds = {speeds}\ncount = 4\n");
        for (found, expected) in at_300(&hinged(FREE, &cards)).iter().zip(&expected) {
            assert!(
                (found / expected - 1.0).abs() < 0.01,
                "{speeds}: {found} {expected}"
            );
        }
    }
}

/// Free hinges, one with a damper: at rest the damped one has a simple zero in addition to its
/// decay, the other a double one, and both are motions of frequency zero.
#[test]
fn a_damped_free_hinge_is_a_motion_too() {
    let hinges = "[{ kind = \"flap\", offset = 0.15 }, \
        { kind = \"lag\", offset = 0.3, damping = 900 }]";
    let found = hinged(hinges, "[modes]\nspeeds = [0]\ncount = 4\n");
    let zeros = found
        .at_speed(0)
        .into_iter()
        .filter(|mode| mode.1.frequency == 0.0);
    let mut kinds: Vec<_> = zeros.map(|(branch, _)| branch.name.clone()).collect();
    kinds.sort();
    assert_eq!(kinds, ["flap 1", "lag 1"]);
}

/// A body on two free hinges at the radius e, its center at the distance l from both: with the
/// moment of inertia I about all axes, squares of the frequencies over the squared speed are
/// `m (e + l) l / (m l^2 + I)` in flap and `m e l / (m l^2 + I)` in lag. Straight out is an
/// equilibrium at any speed, and no iteration may leave it. The eigenvalue solver is good to 1e-8.
#[test]
fn a_body_on_two_hinges_stays_straight_at_any_speed() {
    let mut random = Random(3);
    for _ in 0..cases(100) {
        let [e, l] = [random.between(0.05, 2.0), random.between(0.1, 4.0)];
        let [m, inertia] = [random.between(0.1, 50.0), random.between(1e-4, 0.5)];
        let speed = 10_f64.powf(random.between(0.0, 3.0));
        let found = table(&format!(
            "units = \"SI\"\n[[node]]\nname = \"root\"\nposition = [{e}, 0, 0]\n\
            [[clamp]]\nnode = \"root\"\n\
            [[node]]\nname = \"middle\"\nposition = [{e}, 0, 0]\n\
            [[node]]\nname = \"body\"\nposition = [{}, 0, 0]\n\
            [[hinge]]\nname = \"flap\"\nnodes = [\"root\", \"middle\"]\naxis = [0, 1, 0]\n\
            [[hinge]]\nname = \"lag\"\nnodes = [\"middle\", \"body\"]\naxis = [0, 0, 1]\n\
            offset = [{}, 0, 0]\n\
            [[body]]\nnode = \"body\"\nmass = {m}\ninertia = [{inertia}, {inertia}, {inertia}]\n\
            [modes]\nspeeds = [{speed}]\ncount = 2\n",
            e + l,
            -l,
        ));
        let hertz = speed / 60.0;
        let about = m * l * l + inertia;
        let expected = [m * e * l / about, m * (e + l) * l / about].map(f64::sqrt);
        let modes = found.at_speed(0);
        assert_eq!(modes.len(), 2, "{:?}", found.remarks);
        for ((_, point), expected) in modes.iter().zip(expected) {
            let off = point.frequency / hertz / expected - 1.0;
            assert!(off.abs() < 1e-7, "{off:e} e {e} l {l} {:?}", found.remarks);
        }
    }
}

/// D = tau K with tau omega / 2 = 1 at 11.5 Hz: the modes above do not oscillate and their values
/// crowd around -1 / tau; the five below are still found, with their ratios tau omega / 2 of the
/// natural frequency, and a remark reports the others.
#[test]
fn overdamped_motions_do_not_crowd_out_modes() {
    let tau = 1.0 / (std::f64::consts::PI * 11.5);
    let damped = STRIP.replace("ea = ", &format!("damping = {{ time = {tau} }}\nea = "));
    let rest = "[modes]\nspeeds = [0]\ncount = 12\n";
    let undamped = table(&format!("{STRIP}{BLADE}{rest}"));
    let found = table(&format!("{damped}{BLADE}{rest}"));
    let natural: Vec<_> = undamped
        .at_speed(0)
        .iter()
        .map(|mode| mode.1.frequency)
        .filter(|f| *f < 11.0)
        .collect();
    assert!(natural.len() >= 3, "{natural:?}");
    for natural in natural {
        let ratio = natural / 11.5;
        let expected = natural * (1.0 - ratio * ratio).sqrt();
        let modes = found.at_speed(0);
        let near = modes
            .iter()
            .find(|mode| (mode.1.damping_ratio - ratio).abs() < 1e-6);
        let point = near.unwrap_or_else(|| panic!("{natural}: {modes:?}")).1;
        assert!((point.frequency / expected - 1.0).abs() < 1e-6);
    }
    assert!(
        found
            .remarks
            .iter()
            .any(|remark| remark.contains("too damped to oscillate: ")),
        "{:?}",
        found.remarks
    );
}
