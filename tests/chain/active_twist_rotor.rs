//! The active-twist rotor of the thesis, chapter 13, by the files and the runner of its case.
//!
//! # References
//! - [Masarati], Tables 13.6 and 13.7: `tests/reference/rotors/active_twist_rotor_fullscale.json`.
//! - Thrust of rigid blades by strip theory: `tests/reference/theory-rotor/hover_atr.json`.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::effort::is_long;
use crate::record;
use crate::swept_tip::copy;

#[path = "../../cases/chain/active_twist_rotor/flight.rs"]
#[allow(dead_code, reason = "the runner uses the rest")]
mod flight;
#[path = "../../cases/chain/active_twist_rotor/hover.rs"]
#[allow(dead_code, reason = "the runner uses the rest")]
mod hover;
#[path = "../../cases/chain/active_twist_rotor/motion.rs"]
mod motion;
#[path = "../../cases/chain/active_twist_rotor/response.rs"]
mod response;
#[path = "../../cases/chain/active_twist_rotor/sections.rs"]
#[allow(dead_code, reason = "the runner uses the rest")]
mod sections;

use flight::{CONDITIONS, flight, over_phase, trimmed, vibration};
use hover::{MODES, SPEED, frequencies, hover};
use response::response;

type Result<T> = std::result::Result<T, String>;

const SOURCE: &str = "Masarati 1999, active-twist rotor";
const CASE: &str = "cases/chain/active_twist_rotor";
const SECTION: &str = "cases/section/active_twist_section";

/// The case in a folder of its own, with the section analyzed and the property files written.
struct Chain(tempfile::TempDir);

impl Chain {
    fn new() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = tempfile::tempdir().unwrap();
        for part in [SECTION, "cases/chain/active_twist_blade", CASE] {
            copy(&root.join(part), &folder.path().join(part));
        }
        let section = folder
            .path()
            .join(SECTION)
            .join("active_twist_section.section.toml");
        let arguments = ["section-analyzer".into(), "analyze".into(), section.into()];
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let code = section_analyzer::cli::run(arguments, &mut out, &mut err);
        assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
        let chain = Self(folder);
        sections::write(&chain.case()).unwrap();
        chain
    }

    fn case(&self) -> PathBuf {
        self.0.path().join(CASE)
    }
}

fn reference(name: &str) -> Value {
    let path = format!("{}/tests/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn check(case: &str, quantity: &str, [found, expected]: [f64; 2], tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    println!("{case}, {quantity}: {found:.5} {expected:.5} {error:.1e}");
    record::value(SOURCE, case, quantity, [found, expected], error, tolerance);
    assert!(
        error < tolerance,
        "{case}, {quantity}: {found}, expected {expected}"
    );
}

/// Table 13.6, with the beams of the thesis. The stiffness of Table 13.3 gives all of its frequencies
/// within 1 %, the stiffness of reference 90 within 2 %: the inertia about the span, which the thesis
/// does not state, is chosen by the first twist mode only. The section of the case has the bending
/// stiffness of the table, and flap modes within 1 %; its torsional stiffness is 20 % higher than in the
/// table (see the page of the section), so that the twist modes are not compared.
#[test]
fn frequencies_are_those_of_the_table() {
    let chain = Chain::new();
    let table = reference("rotors/active_twist_rotor_fullscale.json");
    let keys = ["1F", "2F", "3F", "4F", "1T", "2T"];
    let expected = |column: usize| {
        let table = &table["in_vacuo_frequencies_per_rev"];
        keys.map(|key| table[key][column].as_f64().unwrap())
    };
    for (set, column, count, tolerance) in [
        ("table_coupled", 1, 6, 0.01),
        ("reference", 0, 6, 0.02),
        ("coupled", 1, 4, 0.01),
    ] {
        let found = frequencies(&chain.case(), set).unwrap();
        let pairs = found.into_iter().zip(expected(column)).zip(MODES);
        for ((found, expected), [name, _]) in pairs.take(count) {
            let quantity = format!("{name} [1/rev]");
            check(
                &format!("blade in vacuum, {set}"),
                &quantity,
                [found, expected],
                tolerance,
            );
        }
    }
}

/// Thrust \[lb\] of rigid blades at a pitch at 75 % of the radius \[rad\], by strip theory with uniform
/// inflow and the lift of thin airfoils after Prandtl and Glauert, without tip loss:
///
/// ```text
/// T = 4 int rho/2 c a(M) (theta W^2 r^2 - lambda W R W r) dr = 2 rho pi R^2 (lambda W R)^2
/// ```
fn strip_theory(pitch: f64) -> f64 {
    let (density, radius): (f64, f64) = (0.002378, 28.0);
    let lift = |lambda: f64| {
        let strip = |k: u32| {
            let part = 0.027 + 0.973 * (f64::from(k) + 0.5) / 500.0;
            let speed = SPEED * radius * part;
            let slope = std::f64::consts::TAU / (1.0 - (speed / 1116.4).powi(2)).sqrt();
            let theta = pitch - 8.0_f64.to_radians() * (part - 0.75);
            let flow = theta * speed * speed - lambda * SPEED * radius * speed;
            2.0 * density * 0.0488 * radius * slope * flow * 0.973 * radius / 500.0
        };
        (0..500).map(strip).sum::<f64>()
    };
    let area = std::f64::consts::PI * radius * radius;
    let momentum = |lambda: f64| 2.0 * density * area * (lambda * SPEED * radius).powi(2);
    let (mut low, mut high) = (0.0, 0.1);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if lift(middle) > momentum(middle) {
            low = middle
        } else {
            high = middle
        }
    }
    lift(low)
}

/// Hover at 4 degrees. The thrust of the blades without couplings, which do not twist, is the one of
/// strip theory at the pitch of the root against the disk within 3 %: the flap hinge is inboard of the
/// lag hinge, so that flap adds to the pitch of a blade that lags. It exceeds the thrust of the
/// reference at 4 degrees with a lower slope of lift, and is below the one of the thesis, which takes
/// 4.7 to 5.1 degrees of rigid blades. Couplings reduce it by 4 to 7 % (thesis: 4.4 %) and turn the nose
/// of the tip down by 0.1 to 0.16 degrees (thesis: 0.12). The twist between -250 and 250 V of the blade
/// without couplings is the free one within 4 %: the rotation of the tip has a part by bending, as the
/// tip rises by 2.3 ft.
#[test]
fn hover_has_the_thrust_of_strip_theory_and_the_free_twist() {
    let chain = Chain::new();
    let case = chain.case();
    let at = |set: &str, volts: f64| hover(&case, set, &[("volts", volts)]).unwrap();
    let pounds = |found: f64| found / 4.448_221_615_260_5;
    let table = reference("theory-rotor/hover_atr.json");
    let low = table["thrust_lb_at_theta75_4deg"]["uniform, 5.73"]
        .as_f64()
        .unwrap();
    let diagonal = at("diagonal", 0.0);
    let collective = diagonal.pitch - 5.784_f64.to_radians();
    let pair = [pounds(diagonal.thrust), strip_theory(collective)];
    check("hover at 4 deg, diagonal", "thrust [lb]", pair, 0.03);
    assert!(pair[0] > low && pair[0] < 5133.0);
    for [with, without] in [["coupled", "diagonal"], ["table_coupled", "table_diagonal"]] {
        let [with, without] = [with, without].map(|set| at(set, 0.0));
        let (ratio, twist) = (with.thrust / without.thrust, with.twist.to_degrees());
        println!("coupled over diagonal {ratio}, twist {twist} deg");
        // Table 13.7, flap and height of the tip of the coupled blade: 2.129 deg and 1.0343 ft. At "4 deg" the
        // thrust is 14 % lower than in the table, and the height follows it.
        let (flap, tip) = (with.flap.to_degrees(), with.tip / 0.3048);
        println!("flap {flap} deg, tip {tip} ft");
        assert!((flap / 2.129 - 1.0).abs() < 0.06 && (tip / 1.0343 - 1.0).abs() < 0.075);
        assert!((0.93..0.97).contains(&ratio), "{ratio}");
        assert!(without.twist.to_degrees().abs() < 0.03 && (-0.17..-0.08).contains(&twist));
    }
    let half = 0.5 * (at("diagonal", 250.0).twist - at("diagonal", -250.0).twist);
    let file = case.join("results/diagonal.properties.json");
    let properties = shared_geom::section::read(&file).unwrap();
    let torque = 250.0 * properties.piezo.as_ref().unwrap().coupling[(3, 0)];
    let free = torque / properties.stiffness[(3, 3)] * 0.973 * 336.0 * 0.0254;
    let pair = [half.to_degrees(), free.to_degrees()];
    check(
        "hover at 4 deg, diagonal",
        "half the twist from -250 to 250 V [deg]",
        pair,
        0.04,
    );
    assert!(at("coupled", 250.0).thrust > 1.5 * at("coupled", 0.0).thrust);
}

/// Forward flight at an advance ratio of 0.2 with one beam per blade: the trim meets its targets, and a
/// voltage twice per revolution changes the vibration at the hub, which is smaller than without voltage
/// at the best phase, and larger half a turn of phase away.
#[test]
fn a_voltage_twice_per_revolution_changes_the_vibration() {
    let chain = Chain::new();
    let model = [
        ("elements", 1.0),
        ("strips", 3.0),
        ("steps", 24.0),
        ("tolerance", 3e-3),
    ];
    let (without, over_phase) = over_phase(&chain.case(), &model, CONDITIONS[0], None).unwrap();
    assert!(without.residual < 3e-3, "{}", without.residual);
    // The sensor of the target has the thrust at the stages, the column the one at the steps.
    let thrust = without.harmonics("thrust", 1).mean;
    assert!((thrust / 5133.0 - 1.0).abs() < 2e-3, "{thrust}");
    let [cosine, sine] = without.wave("flap", 1);
    assert!(cosine.hypot(sine) < 0.01, "{cosine} {sine}");
    let [collective, _, sine] = [0, 1, 2].map(|i| without.controls[i]);
    assert!(
        (3.0..5.0).contains(&collective) && sine < -1.0,
        "{collective} {sine}"
    );
    let moment = |phase: f64| over_phase.at(phase).moment;
    let (base, best) = (over_phase.without().moment, over_phase.best());
    println!("best phase {best} deg: {base} to {} lbf ft", moment(best));
    assert!(moment(best) < 0.95 * base && moment(best + 180.0) > 1.05 * base);
    // No part of the voltage at any phase has a smaller moment than the optimum.
    let [part, phase] = over_phase.optimum();
    let least = over_phase.with(part, phase).moment;
    for k in 0..360 {
        let beside = over_phase
            .with(0.02 * f64::from(k % 100), f64::from(k))
            .moment;
        assert!(beside > (1.0 - 1e-12) * least, "{k}: {beside} {least}");
    }
    assert!(least < moment(best));
}

/// Figure 13.6: the response in hover to a voltage of 1 to 6 per revolution. The twist is the one of a torsional
/// oscillator with its frequency of 3.7 per revolution: largest at 4 per revolution, where it is a quarter of a
/// turn behind the voltage, and small at 6; flap, with a frequency of 1.02 per revolution, is a quarter of a
/// turn behind the twist at 1 per revolution and falls with the square of the frequency beyond. The numbers of
/// the page at the finest model, within 5 % of each and 5 degrees.
#[test]
fn the_response_is_largest_next_to_the_first_twist_mode() {
    let chain = Chain::new();
    let model = [
        ("elements", 2.0),
        ("strips", 2.0),
        ("steps", 32.0),
        ("tolerance", 1e-4),
    ];
    let found = response(&chain.case(), (1.0, false), &model).unwrap();
    println!("{found:#?}");
    let page = [
        (2.25, -9.0),
        (3.04, -30.0),
        (2.70, -45.0),
        (3.50, -90.0),
        (1.72, -127.0),
        (0.93, -133.0),
    ];
    for (own, (twist, phase)) in found.iter().zip(page) {
        let case = format!("response in hover at {} per revolution", own.order);
        assert!((own.twist[0] / twist - 1.0).abs() < 0.05, "{case}: {own:?}");
        assert!((own.twist[1] - phase).abs() < 5.0, "{case}: {own:?}");
    }
    let flap = |order: usize| found[order - 1].flap[0];
    assert!((2..6).all(|order| flap(order) > flap(order + 1)));
    let behind = found[0].twist[1] - found[0].flap[1];
    assert!((behind - 90.0).abs() < 20.0, "{behind}");
}

/// Forward flight in all conditions with the model of the page, in the long form: trims, and the moments on
/// the mast at 4 per revolution, which a voltage at 2 per revolution at the best phase reduces by 97, 86 and
/// 81 %. The best phase hardly depends on the advance ratio: 78, 78 and 77 degrees (thesis: 131, 128 and 127 from
/// another zero, which it does not state).
#[test]
fn a_voltage_reduces_the_moments_on_the_mast_in_every_condition() {
    if !is_long() {
        return;
    }
    let chain = Chain::new();
    let model = [
        ("elements", 3.0),
        ("strips", 2.0),
        ("steps", 30.0),
        ("tolerance", 1e-5),
    ];
    let case = chain.case();
    let slow = trimmed(&case, &model, 0.14, None).unwrap();
    for (found, expected) in slow.controls.iter().zip([3.18, 0.08, -0.90]) {
        assert!((found - expected).abs() < 0.02, "{:?}", slow.controls);
    }
    let mut last = slow;
    let page = [
        (3.61, 32.5, 78.0, 0.97),
        (4.21, 57.9, 78.0, 0.86),
        (5.01, 89.4, 77.0, 0.81),
    ];
    for (condition, (collective, moment, phase, part)) in CONDITIONS.into_iter().zip(page) {
        let own = flight(&case, &model, condition, Some(&last)).unwrap();
        let without = own.vibration.without().moment;
        let with = vibration(&own.controlled).moment;
        let at = condition.advance;
        println!(
            "{at}: {:?} {without} {with} {}",
            own.without.controls,
            own.vibration.best()
        );
        assert!((own.without.controls[0] - collective).abs() < 0.02, "{at}");
        assert!((without / moment - 1.0).abs() < 0.02, "{at}: {without}");
        assert!((own.vibration.best() - phase).abs() <= 2.0, "{at}");
        assert!((1.0 - with / without - part).abs() < 0.02, "{at}: {with}");
        last = own.without;
    }
}
