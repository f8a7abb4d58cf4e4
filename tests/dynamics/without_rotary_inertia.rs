//! Blades without rotary inertia, `iy = iz = 0`, and point masses: what moves no mass has no
//! part in the spectrum.
//!
//! The reference is the same blade with a rotary inertia of 1e-8 of what a square section of
//! a tenth of the length has, which changes frequencies by less than 1e-8 and is a regular
//! mass matrix.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::input;
use beam_dynamics::result::FrequencyTable;

use crate::record;
use crate::variational_beam::spectra::Random;

/// Blades, each at five speeds.
const BLADES: usize = 60;
/// Modes that are compared.
const COUNT: usize = 6;
/// Rotary inertia changes a frequency by its part of the mass of the mode, 1e-8 times a part
/// below one of each; frequencies of stiff models are known to 1e-8.
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

fn is_alarm(remark: &String) -> bool {
    ["unstable", "were found of", "digits"]
        .iter()
        .any(|word| remark.contains(word))
}

#[test]
fn blades_without_rotary_inertia_have_all_their_modes() {
    let mut random = Random(3);
    let mut between = |from: f64, to: f64| from + 0.5 * (to - from) * (1.0 + random.number());
    let mut largest = 0.0_f64;
    for case in 0..BLADES {
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
        let rotary = 1e-8 * mass * (0.1 * length).powi(2) / 12.0;
        let tip = mass * length * between(0.1, 2.0);
        let of = |rotary: f64| {
            let text = format!(
                "units = \"SI\"\n[properties.p]\nea = {ea:e}\ngay = {ga:e}\ngaz = {ga:e}\n\
                 gj = {gj:e}\neiy = {flap:e}\neiz = {lag:e}\nm = {mass:e}\niy = {rotary:e}\n\
                 iz = {rotary:e}\n\
                 [[blade]]\nname = \"b\"\nproperties = \"p\"\ninertia = \"{inertia}\"\n\
                 [[blade.piece]]\nlength = {length:e}\nelements = {elements}\n\
                 [[body]]\nnode = \"b/tip\"\nmass = {tip:e}\noffset = {offset}\n\
                 [modes]\nspeeds = {{ from = 0, to = 40, steps = 5 }}\ncount = {COUNT}\n"
            );
            table(&text)
        };
        let (without, with) = (of(0.0), of(rotary));
        let alarms: Vec<_> = without
            .remarks
            .iter()
            .filter(|remark| is_alarm(remark))
            .collect();
        assert!(alarms.is_empty(), "{case}: {alarms:?}");
        assert_eq!(without.speeds.len(), 5);
        for speed in 0..5 {
            let (found, expected) = (lowest(&without, speed), lowest(&with, speed));
            assert_eq!(found.len(), COUNT, "{case}: {found:?} {expected:?}");
            for (found, expected) in found.iter().zip(&expected) {
                let error = (found / expected - 1.0).abs();
                assert!(
                    error < TOLERANCE,
                    "{case}, speed {speed}: {found} {expected} {error:e}"
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
