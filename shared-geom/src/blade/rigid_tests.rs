//! Shear stiffness that is absent, and problems that many stations share.

use super::tests::blade;
use super::{Blade, Reading, parse, parse_with, write};

/// The sample without shear stiffness.
fn without_shear() -> Blade {
    let mut blade = blade();
    for station in &mut blade.stations {
        for i in 0..6 {
            for shear in [1, 2] {
                station.stiffness[(shear, i)] = 0.0;
                station.stiffness[(i, shear)] = 0.0;
            }
        }
    }
    blade
}

fn shown(blade: &Blade) -> Vec<String> {
    let problems = blade.summarized_problems();
    problems.iter().map(ToString::to_string).collect()
}

#[test]
fn absent_shear_becomes_rigid_and_other_entries_stay() {
    let before = without_shear();
    assert_eq!(before.problems().len(), before.stations.len());
    let mut blade = before.clone();
    assert_eq!(blade.make_shear_rigid(), blade.stations.len());
    assert!(blade.problems().is_empty(), "{:?}", blade.problems());
    for (station, old) in blade.stations.iter().zip(&before.stations) {
        let (k, old) = (station.stiffness, old.stiffness);
        let bending = f64::max(old[(4, 4)], old[(5, 5)]);
        // One division instead of a square and a division: a few roundings.
        let expected = 1e6 * bending / blade.length().powi(2);
        assert!((k[(1, 1)] / expected - 1.0).abs() < 1e-14);
        assert_eq!([k[(2, 2)], k[(1, 2)]], [k[(1, 1)], 0.0]);
        for i in [0, 3, 4, 5] {
            for j in 0..6 {
                assert_eq!((k[(i, j)], k[(j, i)]), (old[(i, j)], old[(j, i)]));
            }
        }
    }
}

// A zero with couplings is a mistake in the file, not the absence of shear.
#[test]
fn present_shear_and_coupled_zeros_stay() {
    let mut blade = blade();
    blade.stations[0].stiffness[(1, 1)] = 0.0;
    let before = blade.clone();
    assert_eq!(blade.make_shear_rigid(), 0);
    assert_eq!(blade, before);
}

#[test]
fn the_substitute_is_remarked() {
    let remark = |blade: Blade| {
        let mut reading = Reading::new(blade, Vec::new());
        reading.make_shear_rigid();
        reading.remarks.remove(0)
    };
    let text = remark(without_shear());
    assert!(
        text.contains("zero at 5 of 5 stations, is replaced by 1e6 max(EIy, EIz) / L^2"),
        "{text}"
    );
    assert!(remark(blade()).starts_with("rigid shear has no effect"));
}

// The readers of Helicoid's files check the blade: they replace absent shear before.
#[test]
fn helicoid_files_become_rigid_in_shear_on_request() {
    let mut expected = without_shear();
    expected.make_shear_rigid();
    let json = write(&without_shear());
    assert!(parse(&json, "a.blade.json").is_err());
    let read = parse_with(&json, "a.blade.json", true).unwrap();
    assert_eq!(read.blade.stations, expected.stations);
    assert!(
        read.remarks
            .iter()
            .any(|remark| remark.starts_with("rigid in shear"))
    );
    let station = |eta: f64| {
        format!(
            "[[station]]\neta = {eta}\nea = 1e9\ngay = 0\ngaz = 0\ngj = 1e6\neiy = 2e6\n\
             eiz = 8e6\nm = 5\niy = 0.1\niz = 0.4\ntension_center = [0.1, 0]\n"
        )
    };
    let head = "units = \"SI\"\nframe = \"helicoid\"\nreference_point = \"line\"\n[line]\n\
                course = \"polyline\"\nspan = [0, 4]\n";
    let toml = format!("{head}{}{}", station(0.0), station(1.0));
    assert!(parse(&toml, "a.blade.toml").is_err());
    let read = parse_with(&toml, "a.blade.toml", true).unwrap_or_else(|all| panic!("{all}"));
    // About the line, EIz has EA times the square of the offset.
    let k = read.blade.stations[1].stiffness;
    let expected = 1e6 * (8e6 + 1e9 * 0.01) / 16.0;
    assert!((k[(1, 1)] / expected - 1.0).abs() < 1e-14, "{k}");
    assert!(
        read.remarks
            .iter()
            .any(|remark| remark.starts_with("rigid in shear"))
    );
}

#[test]
fn one_kind_at_many_stations_is_one_problem() {
    let mut blade = blade();
    for station in &mut blade.stations {
        station.stiffness[(1, 1)] = 0.0;
    }
    let text = "stiffness has 0e0 at (2, 2) (shear y), expected more than zero";
    assert_eq!(shown(&blade), [format!("all 5 stations: {text}")]);
    // Another value at the second station, and a good one at the third.
    blade.stations[1].stiffness[(1, 1)] = -2.0;
    blade.stations[2].stiffness = blade.stations[3].stiffness;
    blade.stations[2].stiffness[(1, 1)] = 1e3;
    assert_eq!(
        shown(&blade),
        [format!("stations 1, 2, 4, 5: {text} (station 1)")]
    );
    for station in &mut blade.stations {
        station.stiffness[(1, 1)] = 0.0;
        station.stiffness[(2, 2)] = 0.0;
    }
    let both = "all 5 stations: stiffness has 0 at (2, 2) (shear y) and at (3, 3) (shear z), \
                expected more than zero";
    assert_eq!(shown(&blade), [both]);
}

#[test]
fn two_stations_are_reported_one_by_one() {
    let mut blade = blade();
    for station in [0, 3] {
        blade.stations[station].stiffness[(1, 1)] = 0.0;
    }
    assert_eq!(blade.summarized_problems(), blade.problems());
}
