//! Blades without rotary inertia, `iy = iz = 0`, and point masses: motions without mass are not in
//! the spectrum.
//!
//! The reference is the same blade with a rotary inertia of 1e-8 of a square section of a tenth of
//! the length, which changes frequencies by less than 1e-8 and is a regular mass matrix.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::input;
use beam_dynamics::result::FrequencyTable;

use crate::record;
use crate::variational_beam::spectra::Random;

/// Blades, each at five speeds.
const BLADES: usize = 30;
/// Compared modes.
const COUNT: usize = 6;
/// Rotary inertia changes a frequency by its share of the mass of the mode, 1e-8 times a share
/// below one; frequencies of stiff models are accurate to 1e-8.
const TOLERANCE: f64 = 1e-6;

fn table(text: &str) -> FrequencyTable {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("blade.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    let input = input::read(&file).unwrap_or_else(|problems| panic!("{problems}\n{text}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}\n{text}", outcome.failure);
    outcome.table
}

/// The lowest frequencies at a speed \[Hz\].
fn lowest(table: &FrequencyTable, speed: usize) -> Vec<f64> {
    let points = table
        .branches
        .iter()
        .filter_map(|branch| branch.points[speed].as_ref());
    let mut frequencies: Vec<_> = points.map(|point| point.frequency).collect();
    frequencies.sort_by(f64::total_cmp);
    frequencies.truncate(COUNT);
    frequencies
}

fn is_alarm(remark: &str) -> bool {
    ["unstable", "modes were found", "digits"]
        .iter()
        .any(|word| remark.contains(word))
}

/// The cards of a random blade with a tip mass, with and without the small rotary inertia.
fn blade(case: usize, random: &mut Random) -> impl Fn(bool) -> String {
    let mut between = |from: f64, to: f64| from + 0.5 * (to - from) * (1.0 + random.number());
    let length = between(0.5, 6.0);
    let mass = between(0.5, 8.0);
    let flap = mass * length.powi(4) * 10.0_f64.powf(between(0.0, 3.0));
    let lag = flap * between(1.0, 30.0);
    let [ea, ga] = [3e3, 1e3].map(|part| part * lag / length.powi(2));
    let inertia = match case % 3 {
        0 => "lumped",
        1 => "consistent",
        _ => "lumped\"\nformulation = \"finite-volume",
    };
    let offset = match case % 2 {
        0 => format!("[0, {:e}, 0]", 0.02 * length),
        _ => "[0, 0, 0]".to_owned(),
    };
    let gj = flap * between(0.3, 1.0);
    let elements = between(2.0, 7.99) as usize;
    let small = 1e-8 * mass * (0.1 * length).powi(2) / 12.0;
    let tip = mass * length * between(0.1, 2.0);
    move |has_rotary| {
        let rotary = if has_rotary { small } else { 0.0 };
        format!(
            "units = \"SI\"\n[properties.p]\nea = {ea:e}\ngay = {ga:e}\ngaz = {ga:e}\n\
             gj = {gj:e}\neiy = {flap:e}\neiz = {lag:e}\nm = {mass:e}\niy = {rotary:e}\n\
             iz = {rotary:e}\n\
             [[blade]]\nname = \"b\"\nproperties = \"p\"\ninertia = \"{inertia}\"\n\
             [[blade.piece]]\nlength = {length:e}\nelements = {elements}\n\
             [[body]]\nnode = \"b/tip\"\nmass = {tip:e}\noffset = {offset}\n\
             [modes]\nspeeds = {{ from = 0, to = 40, steps = 5 }}\ncount = {COUNT}\n"
        )
    }
}

#[test]
fn blades_without_rotary_inertia_have_all_their_modes() {
    let mut random = Random(3);
    let mut largest = 0.0_f64;
    for case in 0..BLADES {
        let text = blade(case, &mut random);
        let (without, with) = (table(&text(false)), table(&text(true)));
        let mut alarms = without.remarks.iter().filter(|remark| is_alarm(remark));
        assert_eq!(alarms.next(), None, "{case}");
        assert_eq!(without.speeds.len(), 5);
        for speed in 0..5 {
            let (found, expected) = (lowest(&without, speed), lowest(&with, speed));
            assert_eq!(found.len(), COUNT, "{case}: {found:?} {expected:?}");
            for (found, expected) in found.iter().zip(&expected) {
                let error = (found / expected - 1.0).abs();
                assert!(
                    error < TOLERANCE,
                    "{case}, speed {speed}: {found} {expected}"
                );
                largest = largest.max(error);
            }
        }
    }
    let case = format!("{BLADES} random blades without rotary inertia, 5 speeds");
    record::largest(
        "small rotary inertia",
        &case,
        "frequencies",
        largest,
        TOLERANCE,
    );
}

/// Point masses on free flap hinges, offset 0.1: there is no stiffness at rest, where both
/// frequencies are zero, and the other speeds are computed: 1 + 3 e / 2 (1 - e) for a uniform blade
/// becomes 1 + e / (1 - e) for a point mass.
#[test]
fn point_masses_on_hinges_are_computed_at_all_speeds() {
    let arm = |name: &str, x: f64| {
        format!(
            "[[node]]\nname = \"{name}\"\nposition = [{x}, 0, 0]\n\
             [[body]]\nnode = \"{name}\"\nmass = 20\n\
             [[hinge]]\nname = \"flap {name}\"\nnodes = [\"hub\", \"{name}\"]\n\
             axis = [0, 1, 0]\noffset = [{}, 0, 0]\n",
            -0.9 * x
        )
    };
    let text = format!(
        "units = \"SI\"\n[[node]]\nname = \"hub\"\nposition = [0, 0, 0]\n\
         [[clamp]]\nnode = \"hub\"\n{}{}[modes]\nspeeds = [0, 20, 40]\ncount = 2\n",
        arm("a", 4.0),
        arm("b", -4.0)
    );
    let table = table(&text);
    assert_eq!(lowest(&table, 0), [0.0, 0.0]);
    let per_rev = (1.0 + 0.1_f64 / 0.9).sqrt();
    for (i, speed) in table.speeds.iter().enumerate().skip(1) {
        let found = lowest(&table, i);
        assert_eq!(found.len(), 2);
        for frequency in found {
            let error = (std::f64::consts::TAU * frequency / speed / per_rev - 1.0).abs();
            assert!(error < 1e-9, "{frequency} {speed}: {error:e}");
        }
    }
}
