//! A rotor of equal blades: every frequency of one blade occurs once per blade.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::result::{Direction, FrequencyTable, ModeKind, Whirl};

/// Blades on a rigid hub, 4 elements of 9 nodes each: with 4 blades the 432 unknowns
/// exceed the size for dense eigenvalues.
fn rotor(blades: usize, count: usize) -> FrequencyTable {
    let mut text = String::from(
        "units = \"SI\"\n[properties.p]\nea = 1e7\ngay = 3e6\ngaz = 3e6\ngj = 500\n\
         eiy = 1000\neiz = 4000\nm = 2.0\niy = 0.001\niz = 0.004\n",
    );
    for blade in 0..blades {
        let azimuth = 360.0 * blade as f64 / blades as f64;
        text += &format!(
            "[[blade]]\nname = \"b{blade}\"\nroot = [0.3, 0, 0]\nazimuth = {azimuth}\n\
             properties = \"p\"\n[[blade.piece]]\nlength = 3\nelements = 4\n"
        );
    }
    text += &format!("[modes]\nspeeds = [0, 300]\ncount = {count}\n");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rotor.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    let input = beam_dynamics::input::read(&file).unwrap();
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.table
}

/// Blades on a rigid hub are uncoupled, so that the frequencies are the frequencies of one blade,
/// to the round-off of the eigenvalues, and each branch continues at the second speed.
#[test]
fn every_frequency_comes_once_a_blade_and_is_followed() {
    let one = rotor(1, 8);
    for blades in [3, 4] {
        let all = rotor(blades, 6 * blades);
        for speed in 0..2 {
            let single: Vec<_> = one
                .at_speed(speed)
                .iter()
                .map(|mode| mode.1.frequency)
                .collect();
            let found = all.at_speed(speed);
            assert!(found.len() >= 6 * blades);
            for (i, (branch, mode)) in found.iter().take(6 * blades).enumerate() {
                let expected = single[i / blades];
                let error = (mode.frequency / expected - 1.0).abs();
                assert!(
                    error < 1e-8,
                    "{blades} blades, {}: {} {expected}",
                    branch.name,
                    mode.frequency
                );
                assert!(
                    speed == 0 || mode.assurance.is_some_and(|mac| mac > 0.8),
                    "{}",
                    branch.name
                );
                assert_ne!(branch.kind, ModeKind::Coupled);
            }
        }
    }
}

/// The modes of each multiple frequency on a rigid hub are the patterns of motion of the blades,
/// each once and pure: collective, progressive, regressive, and differential if the number is even.
/// The motion of blade k in mode h is `exp(-i h psi_k)` times the motion of the first, so that the
/// shares are one to round-off of the vectors.
#[test]
fn copies_are_collective_cyclic_and_differential() {
    for (blades, ways) in [(2, vec![0, 1]), (3, vec![-1, 0, 1]), (4, vec![-1, 0, 1, 2])] {
        let table = rotor(blades, 6 * blades);
        for speed in 0..2 {
            let found = table.at_speed(speed);
            for copies in found.chunks(blades).take(6) {
                let whirls: Vec<_> = copies.iter().map(|mode| mode.1.whirl.unwrap()).collect();
                let mut harmonics: Vec<_> = whirls.iter().map(|whirl| whirl.harmonic).collect();
                harmonics.sort_unstable();
                assert_eq!(harmonics, ways, "{blades} blades");
                for whirl in whirls {
                    assert!(whirl.share > 1.0 - 1e-6, "{}", whirl.share);
                }
            }
        }
        // Followed over the speeds, each keeps its pattern.
        for branch in &table.branches {
            for point in branch.points.iter().flatten() {
                let harmonic = point.whirl.map(|whirl| whirl.harmonic);
                assert_eq!(harmonic, branch.harmonic, "{}", branch.name);
            }
        }
        let names: Vec<_> = table.branches.iter().map(|branch| &branch.name).collect();
        assert!(
            names.iter().any(|name| *name == "flap 1 collective"),
            "{names:?}"
        );
    }
    // In the fixed system: 10 Hz at 3 rev/s, and 2 Hz, which is overtaken.
    let whirl = |harmonic| Whirl {
        harmonic,
        blades: 4,
        share: 1.0,
    };
    let seen = |harmonic, f| whirl(harmonic).in_fixed_system(f, 3.0);
    assert_eq!(seen(1, 10.0), (13.0, Some(Direction::Forward)));
    assert_eq!(seen(-1, 10.0), (7.0, Some(Direction::Backward)));
    assert_eq!(seen(-1, 2.0), (1.0, Some(Direction::Forward)));
    assert_eq!((seen(0, 10.0), seen(2, 10.0)), ((10.0, None), (10.0, None)));
}

/// A tip piece a million times as stiff as the blade: the result has few digits, which a remark
/// reports. Without it there is no remark.
#[test]
fn lost_digits_are_reported() {
    assert_eq!(rotor(1, 4).remarks, Vec::<String>::new());
    let text = "units = \"SI\"\n[properties.p]\nea = 1e7\ngay = 3e6\ngaz = 3e6\ngj = 500\n\
         eiy = 1000\neiz = 4000\nm = 2.0\niy = 0.001\niz = 0.004\n\
         [properties.q]\nea = 1e17\ngay = 3e16\ngaz = 3e16\ngj = 5e12\n\
         eiy = 1e13\neiz = 4e13\nm = 2.0\niy = 0.001\niz = 0.004\n\
         [[blade]]\nname = \"b\"\nroot = [0.3, 0, 0]\nproperties = \"p\"\n\
         [[blade.piece]]\nlength = 2\nelements = 4\n\
         [[blade.piece]]\nlength = 1\nelements = 4\nproperties = \"q\"\n\
         [modes]\nspeeds = [0, 100]\ncount = 4\n";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("stiff.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    let input = beam_dynamics::input::read(&file).unwrap();
    let outcome = modes(&input.model, &input.modes.unwrap());
    let reported = outcome
        .table
        .remarks
        .iter()
        .any(|remark| remark.contains("digits are lost"));
    let shown = outcome.failure.map(|failure| failure.to_string());
    println!("{:?} {shown:?}", outcome.table.remarks);
    assert!(reported || shown.is_some());
}
