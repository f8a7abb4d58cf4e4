//! Heated beams against closed forms: held, free, near buckling, in time.
//!
//! # References
//! - [timoshenko] Timoshenko, Young, Weaver, *Vibration Problems in Engineering*, 4th ed.
//!   1974, chapter 5: bending vibrations of a bar under an axial force.

use std::f64::consts::PI;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::case::Model;
use beam_dynamics::input::{self, Input};
use beam_dynamics::result::StaticStep;

use crate::in_time::Run;
use crate::record;

const CLOSED: &str = "Heated beams, closed forms";

/// A bar along x of 2 m: EA = 7e6 N, EI = 50 and 80 N m^2, that would push with 150 N/K.
const BAR: &str = r#"
units = "SI"
[properties.bar]
ea = 7e6
gay = 7e6
gaz = 7e6
gj = 60
eiy = 50
eiz = 80
m = 0.3
iy = 1e-7
iz = 1e-7
thermal_force = [-150, 0, 0, 0, 0, 0]
HEAT_OF_PROPERTIES
[[blade]]
name = "bar"
properties = "bar"
HEAT_OF_BLADE
[[blade.piece]]
length = 2
elements = 12
"#;

fn read(text: &str) -> Input {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    input::read(&file).unwrap_or_else(|problems| panic!("{problems}"))
}

/// The bar with a line of heat on its properties and one on its blade.
fn bar(of_properties: &str, of_blade: &str, rest: &str) -> String {
    let text = BAR.replace("HEAT_OF_PROPERTIES", of_properties);
    text.replace("HEAT_OF_BLADE", of_blade) + rest
}

fn last_step(text: &str) -> (Model, StaticStep) {
    let input = read(text);
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let step = outcome.result.last().unwrap().clone();
    (input.model, step)
}

/// Held at both ends the bar pushes with EA alpha T and does not strain; held at one it grows by
/// alpha T. A card overrides the properties, and without a card nothing is heated.
#[test]
fn held_bars_push_and_free_ones_grow() {
    const TOLERANCE: f64 = 1e-12;
    let held = "[[clamp]]\nnode = \"bar/tip\"\n[static]\n";
    let heats = [
        ("temperature = 20", "", 20.0),
        ("temperature = 20", "temperature = \"= 5*8\"", 40.0),
        ("", "temperature = \"36 degF\"", 20.0),
        ("", "", 0.0),
    ];
    for (of_properties, of_blade, rise) in heats {
        let (_, step) = last_step(&bar(of_properties, of_blade, held));
        for section in &step.sections {
            let difference = (section.internal_force[0] + 150.0 * rise).abs();
            assert!(difference < 1e-9, "{rise}: {}", section.internal_force);
            assert!(section.strain.amax() < 1e-14);
        }
        let (_, step) = last_step(&bar(of_properties, of_blade, "[static]\n"));
        let tip = step.positions.last().unwrap();
        let expected = 2.0 * (1.0 + 150.0 / 7e6 * rise);
        let error = (tip.x / expected - 1.0).abs();
        assert!(error < TOLERANCE, "{rise}: {error:e}");
        let case = format!("bar held at one end, {rise} K");
        record::value(
            CLOSED,
            &case,
            "length [m]",
            [tip.x, expected],
            error,
            TOLERANCE,
        );
    }
}

/// First frequency [Hz] of a bar clamped at both ends under the compression `force`
/// [timoshenko]: with `a^2 = sqrt(g^2 + k^4) - g`, `b^2 = sqrt(g^2 + k^4) + g`,
/// `g = P/2EI`, `k^4 = m w^2/EI`,
/// `2 - 2 cosh aL cos bL + (a^2 - b^2)/(ab) sinh aL sin bL = 0`.
fn frequency(force: f64, bending: f64, mass: f64, length: f64) -> f64 {
    let g = 0.5 * force / bending;
    let lack = |w: f64| {
        let root = (g * g + mass * w * w / bending).sqrt();
        let (a, b) = ((root - g).sqrt(), (root + g).sqrt());
        let (x, y) = (a * length, b * length);
        2.0 - 2.0 * x.cosh() * y.cos() + (a * a - b * b) / (a * b) * x.sinh() * y.sin()
    };
    // 22.4 without force; the second root is near 61.7
    let unit = (bending / mass).sqrt() / (length * length);
    let (mut low, mut high) = (0.1 * unit, 30.0 * unit);
    assert!(lack(low) * lack(high) < 0.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if lack(low) * lack(middle) <= 0.0 {
            high = middle
        } else {
            low = middle
        }
    }
    0.5 * (low + high) / (2.0 * PI)
}

/// Heat lowers the frequencies of a bar that is held at both ends. Shear takes P/GA of the buckling
/// load, 7e-5, and twelve elements about as much; at 0.9 of the load a relative error of the load
/// is multiplied by five in the frequency: below 1e-3.
#[test]
fn held_bars_ring_lower_when_heated() {
    const TOLERANCE: f64 = 1e-3;
    let buckling = 4.0 * PI * PI * 50.0 / 4.0;
    for part in [0.0, 0.5, 0.9] {
        let heat = format!("temperature = {}", part * buckling / 150.0);
        let rest = "[[clamp]]\nnode = \"bar/tip\"\n[modes]\nspeeds = [0]\ncount = 4\n";
        let input = read(&bar(&heat, "", rest));
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let points = outcome.table.branches.iter();
        let points = points.filter_map(|branch| branch.points[0].as_ref());
        let lowest = points
            .map(|point| point.frequency)
            .fold(f64::INFINITY, f64::min);
        let expected = frequency(part * buckling, 50.0, 0.3, 2.0);
        let error = (lowest / expected - 1.0).abs();
        let case = format!("bar held at both ends, {part} of the buckling heat");
        println!("{case}: {lowest} {expected} {error:e}");
        record::value(
            CLOSED,
            &case,
            "frequency [Hz]",
            [lowest, expected],
            error,
            TOLERANCE,
        );
        assert!(error < TOLERANCE, "{case}: {error:e}");
    }
}

/// A ramp of temperature by a drive, slow compared with the waves of the bar (a period of 2 ms):
/// its tip follows alpha T(t) L.
#[test]
fn a_ramp_of_temperature_moves_the_tip() {
    let rest = r#"
[drives.warming]
kind = "ramp"
to = 60
end = 0.5
shape = "smooth"
[transient]
to = 0.6
step = 1e-3
"#;
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.dynamics.toml");
    std::fs::write(&file, bar("", "temperature = \"warming\"", rest)).unwrap();
    let run = Run::of_file(&file, 50, |_| {});
    run.check_end();
    let mut worst = 0.0_f64;
    for (time, state) in &run.instants {
        let s = (time / 0.5).clamp(0.0, 1.0);
        let rise = 60.0 * s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
        let growth = 2.0 * 150.0 / 7e6 * rise;
        let tip = state.nodes.last().unwrap().position.x - 2.0;
        worst = worst.max((tip - growth).abs());
    }
    // relative to the growth at the end; the rest are waves, (period / ramp)^2
    let error = worst / (2.0 * 150.0 / 7e6 * 60.0);
    const TOLERANCE: f64 = 1e-4;
    println!("{error:e}");
    assert!(error < TOLERANCE, "{error:e}");
    record::largest(
        CLOSED,
        "bar warmed in half a second",
        "tip",
        error,
        TOLERANCE,
    );
}

/// Heat without a known expansion is an error with its remedy.
#[test]
fn heat_without_thermal_force_is_reported() {
    let text = bar("", "temperature = 20", "[static]\n");
    let text = text.replace("thermal_force = [-150, 0, 0, 0, 0, 0]\n", "");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    let reported = input::read(&file).unwrap_err().to_string();
    for expected in [
        "blade \"bar\", piece 1 has a \"temperature\", but its properties have no \"thermal_force\"",
        "help: give the materials of the section an \"expansion\" and analyze it again",
    ] {
        assert!(reported.contains(expected), "{reported}");
    }
}

/// The active heat is reported, with its card, once for beams that are heated equally.
#[test]
fn what_is_heated_is_reported() {
    let reported = |of_properties, of_blade| {
        let mut remarks = read(&bar(of_properties, of_blade, "[static]\n")).remarks;
        // the bar is lighter than any material, which is reported too
        remarks.retain(|remark| remark.starts_with("heat"));
        remarks
    };
    assert_eq!(reported("", ""), Vec::<String>::new());
    assert_eq!(
        reported("temperature = \"36 degF\"", ""),
        ["heat and imposed strains of properties \"bar\": temperature 20 K"]
    );
    assert_eq!(
        reported("temperature = 20", "temperature = \"= 40 + t\""),
        ["heat and imposed strains of blade \"bar\", piece 1: temperature 40 K at time zero"]
    );
}
