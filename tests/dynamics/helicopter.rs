//! The case `helicopter`: trim in free flight with main and tail rotor, and a climb in time.

use std::f64::consts::PI;

use beam_dynamics::analysis::trim::trim;
use beam_dynamics::input;

use crate::effort::is_long;
use crate::in_time::Run;
use crate::record;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/dynamics/helicopter");
const SOURCE: &str = "blade element theory";

/// A file of the case, with its path.
fn file(name: &str) -> (String, String) {
    let path = format!("{FOLDER}/{name}.dynamics.toml");
    (std::fs::read_to_string(&path).unwrap(), path)
}

/// The number of the first line of `text` that begins with a text.
fn number(text: &str, begin: &str) -> f64 {
    let line = text.lines().find_map(|line| line.strip_prefix(begin));
    let line = line.unwrap_or_else(|| panic!("{begin}"));
    let end = line.find([' ', '"']).unwrap_or(line.len());
    line[..end].parse().unwrap()
}

/// The controls of the trim at a speed \[m/s\] from the guesses of the file: all six forces and moments vanish,
/// to 1e-6 of the weight.
fn controls(speed: f64, most: usize) -> Vec<f64> {
    let (text, path) = file("helicopter");
    let (text, _) = text.split_once("[trim.sweep]").unwrap();
    let text = text.replace("speed = 30 ", &format!("speed = {speed:?} "));
    let read = |given: &[(String, f64)]| input::parse_with(&text, &path, given);
    let input = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = trim("helicopter", input.trim.as_ref().unwrap(), &read);
    let point = &outcome.result.points[0];
    assert_eq!(point.failure, None);
    assert!(point.iterations <= most, "{point:?}");
    for [found, required] in &point.targets {
        assert!((found - required).abs() < 2e-2, "{point:?}");
    }
    point.controls.clone()
}

// From guesses whose attitude is zero. At 10 m/s the induced velocity is largest: more collective pitch and
// pedal than at 30 m/s, where the nose is lower. The controls there are the numbers of the climb, of a sweep,
// which begins at another attitude. In the long form only: each trim takes 20 seconds, and `trim::two_rotors` has six forces in a
// second.
#[test]
fn six_forces_of_main_and_tail_rotor() {
    if !is_long() {
        return;
    }
    let slow = controls(10.0, 6);
    for (found, [least, most]) in slow.iter().zip([
        [4.5, 5.2],
        [1.5, 2.4],
        [-1.2, -0.5],
        [7.0, 8.6],
        [-0.3, 0.1],
        [-2.0, -1.3],
    ]) {
        assert!((least..most).contains(found), "{slow:?}");
    }
    let fast = controls(30.0, 10);
    assert!(fast[0] < slow[0] && fast[3] < slow[3] && fast[4] < slow[4]);
    let (climb, _) = file("climb");
    let commands = climb
        .lines()
        .filter_map(|line| line.strip_prefix("command = \"= "));
    let commands = commands.map(|line| number(line, ""));
    let attitude = ["pitch = ", "roll = "].map(|begin| number(&climb, begin));
    let all: Vec<_> = commands.chain(attitude).collect();
    assert_eq!(all.len(), 6);
    for (found, written) in fast.iter().zip(all) {
        assert!((found - written).abs() < 0.01, "{found} {written}");
    }
}

// A degree of collective pitch at a constant thrust: the velocity through the disk grows by 2/3 W R
// (1 + 3/2 mu^2) of it, up to the hinges, the cut-out of the root and compressibility, some percent; before,
// the aircraft rests within 0.02 m/s. In the long form only: the run takes a minute.
#[test]
fn a_degree_of_collective_pitch_is_a_climb() {
    if !is_long() {
        return;
    }
    let (text, path) = file("climb");
    let input = input::parse(&text, &path).unwrap_or_else(|problems| panic!("{problems}"));
    let settings = input.transient.unwrap();
    let run = Run::of_any(input.model, &settings, 1);
    run.check_end();
    let node = run.node("fuselage");
    let height = |at: f64| {
        let mut instants = run.instants.iter();
        let found = instants.find(|own| own.0 >= at - 1e-6);
        let (time, state) = found.unwrap_or_else(|| panic!("{at}"));
        (*time, state.nodes[node].position.z)
    };
    // The mean over a revolution, in which the blades move the fuselage.
    let climb = |at: f64| {
        let ((from, low), (to, high)) = (height(at - 0.15), height(at));
        (high - low) / (to - from)
    };
    let [before, after] = [climb(6.0), climb(14.0)];
    let tip = 400.0 * PI / 30.0 * 5.0;
    let ratio = 30.0 / tip;
    let expected = 2.0 / 3.0 * tip * (1.0 + 1.5 * ratio * ratio) * 1_f64.to_radians();
    let error = ((after - before) / expected - 1.0).abs();
    let pair = [after - before, expected];
    record::value(SOURCE, "helicopter", "climb [m/s]", pair, error, 0.04);
    assert!(before.abs() < 0.02, "{before}");
    assert!(error < 0.04, "{pair:?}");
}
