//! Tests of the interpolation: reference points, a linear field, ends and sides, sizes.

use std::path::PathBuf;

use super::super::bts::read_bts;
use super::super::coverage::Extent;
use super::super::grid::tests::{Lcg, random, small};
use super::*;

/// A box whose velocity is linear in step, y and z.
fn linear(periodic: bool) -> (BoxValues, impl Fn(f64, f64, f64) -> [f64; 3]) {
    let grid = small(12, periodic);
    let at = move |step: f64, y: f64, z: f64| {
        [
            12.0 + 0.1 * step + 0.02 * y - 0.03 * z,
            -0.2 * step + 0.01 * y,
            0.05 * z,
        ]
    };
    let mut values = random(grid, 1);
    for (step, plane) in values.planes.iter_mut().enumerate() {
        for y in 0..grid.lateral {
            for z in 0..grid.vertical {
                let (py, pz) = (10.0 * y as f64 - 20.0, 60.0 + 8.0 * z as f64);
                let index = grid.index(y, z);
                plane[index..index + 3].copy_from_slice(&at(step as f64, py, pz));
            }
        }
        for k in 0..grid.tower {
            let index = grid.tower_index(k);
            let pz = 60.0 - 8.0 * k as f64;
            plane[index..index + 3].copy_from_slice(&at(step as f64, 0.0, pz));
        }
    }
    (values, at)
}

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    let worst = [0, 1, 2].map(|i| (a[i] - b[i]).abs());
    assert!(worst.iter().all(|w| *w <= tolerance), "{a:?} {b:?}");
}

/// Values of an independent script; the integers of the file give 1e-4.
#[test]
fn reference_points() {
    let folder = PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/aero/boxes"
    ));
    let file = read_bts(&folder.join("own.bts"), None).unwrap();
    let mut grid = *file.grid();
    grid.periodic = true;
    let plane = |index| file.plane(index).unwrap().to_vec();
    let planes = (0..grid.planes).map(plane).collect();
    let turbulence = TurbulenceBox::from_values("box", BoxValues { grid, planes }).unwrap();
    let text = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    for point in json["taylor"].as_array().unwrap() {
        let number = |key: &str| point[key].as_f64().unwrap();
        let at = ["x", "y", "z"].map(number);
        let expected = [0, 1, 2].map(|i| point["u"][i].as_f64().unwrap());
        close(
            turbulence.velocity(&at, number("t")).unwrap(),
            expected,
            1e-4,
        );
    }
}

#[test]
fn a_linear_field_is_exact() {
    let (values, at) = linear(false);
    let turbulence = TurbulenceBox::from_values("box", values).unwrap();
    assert_eq!(turbulence.shift(), 20.0);
    let mut lcg = Lcg(5);
    for _ in 0..500 {
        let (y, z) = (lcg.between(-20.0, 20.0), lcg.between(60.0, 84.0));
        let (x, step) = (lcg.between(-30.0, 30.0), lcg.between(0.0, 11.0));
        let time = 0.25 * step - (20.0 - x) / 12.0;
        let found = turbulence.velocity(&[x, y, z], time).unwrap();
        // rounding of numbers of the order of 10: 1e-14 of the value
        close(found, at(step, y, z), 1e-13);
    }
    // tower points: linear in z below the grid, the same at all y
    let found = turbulence.velocity(&[20.0, 7.0, 50.0], 0.25).unwrap();
    close(found, at(1.0, 0.0, 50.0), 1e-13);
    // to zero between the last tower point, at 44 m, and the ground
    let found = turbulence.velocity(&[20.0, 7.0, 11.0], 0.25).unwrap();
    close(found, at(1.0, 0.0, 44.0).map(|u| 0.25 * u), 1e-13);
    assert!(turbulence.velocity(&[20.0, 7.0, -1.0], 0.25).is_err());
}

#[test]
fn a_periodic_box_repeats_and_closes() {
    let values = random(small(12, true), 4);
    let turbulence = TurbulenceBox::from_values("box", values).unwrap();
    let mut lcg = Lcg(6);
    for _ in 0..200 {
        let at = [0.0, lcg.between(-20.0, 20.0), lcg.between(60.0, 84.0)];
        let time = lcg.between(0.0, 3.0);
        let first = turbulence.velocity(&at, time).unwrap();
        for turns in [-4.0, 1.0, 100.0] {
            let found = turbulence.velocity(&at, time + 3.0 * turns).unwrap();
            close(found, first, 1e-10);
        }
    }
    // between the last plane and the first
    let at = [0.0, -20.0, 60.0];
    let found = turbulence.velocity(&at, 2.875).unwrap()[0];
    let ends = [11, 0].map(|index| turbulence.plane(index).unwrap()[0]);
    assert!((found - 0.5 * (ends[0] + ends[1])).abs() < 1e-13);
    // rounding to the whole period
    let found = turbulence.velocity(&at, -1e-17).unwrap()[0];
    assert!((found - ends[1]).abs() < 1e-13);
    // downwind the wind arrives later
    let later = turbulence.velocity(&[6.0, 3.0, 70.0], 1.5).unwrap();
    close(
        later,
        turbulence.velocity(&[0.0, 3.0, 70.0], 1.0).unwrap(),
        1e-12,
    );
}

#[test]
fn outside_is_refused_or_extended() {
    let (values, at) = linear(false);
    let turbulence = TurbulenceBox::from_values("box", values).unwrap();
    let corner = turbulence.velocity(&[20.0, 20.0, 84.0], 0.0).unwrap();
    close(corner, at(0.0, 20.0, 84.0), 1e-13);
    for [y, z] in [[20.1, 70.0], [-20.1, 70.0], [0.0, 84.1], [f64::NAN, 70.0]] {
        let problem = turbulence.velocity(&[20.0, y, z], 0.0);
        assert!(
            matches!(problem, Err(WindProblem::Outside { .. })),
            "{y} {z}"
        );
    }
    for time in [-0.01, 2.76, f64::NAN, f64::INFINITY] {
        let problem = turbulence.velocity(&[20.0, 0.0, 70.0], time);
        assert!(matches!(problem, Err(WindProblem::Time { .. })), "{time}");
    }
    let extended = turbulence.with_outside(OutsideGrid::Extend);
    close(
        extended.velocity(&[20.0, 1e9, 1e9], 0.0).unwrap(),
        corner,
        1e-13,
    );
    assert!(extended.velocity(&[20.0, f64::NAN, 70.0], 0.0).is_err());
    assert_eq!(
        extended.velocity(&[20.0, 0.0, -5.0], 0.0).unwrap(),
        [0.0; 3]
    );
    assert!(extended.velocity(&[20.0, 0.0, 70.0], -0.01).is_err());
    let shifted = extended.with_shift(0.0);
    close(
        shifted.velocity(&[0.0, 0.0, 70.0], 0.0).unwrap(),
        at(0.0, 0.0, 70.0),
        1e-13,
    );
}

#[test]
fn one_point_and_one_plane_are_enough() {
    let mut grid = small(1, true);
    (grid.lateral, grid.vertical, grid.tower) = (1, 1, 0);
    let turbulence = TurbulenceBox::from_values("box", random(grid, 1)).unwrap();
    let found = turbulence.velocity(&[0.0, 0.0, 60.0], 3.3).unwrap();
    close(
        found,
        turbulence.plane(0).unwrap()[..3].try_into().unwrap(),
        1e-15,
    );
}

/// Sizes and remedies are named: half width 20 m, top 84 m, 2.75 s.
#[test]
fn boxes_that_are_too_small_for_a_rotor() {
    let rotor = |radius| Extent::ball("the rotor", [0.0, 0.0, 72.0], radius);
    let (mut values, _) = linear(false);
    values.grid.tower = 0;
    let size = values.grid.values();
    values
        .planes
        .iter_mut()
        .for_each(|plane| plane.truncate(size));
    let turbulence = TurbulenceBox::from_values("box", values).unwrap();
    assert!(turbulence.uncovered(&rotor(10.0), 0.1).is_empty());
    let problems = turbulence.uncovered(&rotor(25.0), 10.0);
    // width, top, bottom, duration, first plane
    assert_eq!(problems.len(), 5, "{problems:?}");
    let lines = problems
        .iter()
        .map(|problem| format!("{problem}; {problem:?}"));
    let text = lines.collect::<Vec<_>>().join("\n");
    for number in ["20", "25", "84", "97", "47", "2.75", "13.75", "wider"] {
        assert!(text.contains(number), "{number}: {text}");
    }
    let (periodic, _) = linear(true);
    let turbulence = TurbulenceBox::from_values("box", periodic).unwrap();
    // tower points cover the wind below
    assert!(turbulence.uncovered(&rotor(12.0), 1e9).is_empty());
}
