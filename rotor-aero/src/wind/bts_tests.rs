//! Tests of `.bts` files: our own file with the values of an independent script, round trips,
//! wrong files.

use std::path::PathBuf;

use super::super::grid::tests::{Lcg, random, small};
use super::*;
use crate::wind::TurbulenceBox;

fn folder() -> PathBuf {
    PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/aero/boxes"
    ))
}

fn expected() -> serde_json::Value {
    let text = std::fs::read_to_string(folder().join("expected.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn indices(value: &serde_json::Value) -> Vec<usize> {
    let list = value.as_array().unwrap().iter();
    list.map(|index| index.as_u64().unwrap() as usize).collect()
}

/// Half a step of the integers of u, about 1.3e-4 m/s, and the digits of the file.
const TOLERANCE: f64 = 1.6e-4;

fn compare(plane: &[f64], index: usize, point: &serde_json::Value) {
    for c in 0..3 {
        let value = point["u"][c].as_f64().unwrap();
        let found = plane[index + c];
        assert!((found - value).abs() < TOLERANCE, "{found} {value}");
    }
}

/// The text of a box, by which restarts recognize the wind, does not depend on the planes in
/// memory, nor on the folder.
#[test]
fn the_text_of_a_box_is_the_same_at_all_times() {
    let path = folder().join("own.bts");
    let turbulence = read_bts(&path, None).unwrap();
    let before = format!("{turbulence:?}");
    turbulence.plane(0).unwrap();
    assert_eq!(format!("{turbulence:?}"), before);
    let copy = tempfile::tempdir().unwrap();
    let copy = copy.path().join("own.bts");
    std::fs::copy(path, &copy).unwrap();
    assert_eq!(format!("{:?}", read_bts(&copy, None).unwrap()), before);
}

#[test]
fn points_of_the_reference_file() {
    let turbulence = read_bts(&folder().join("own.bts"), None).unwrap();
    let (grid, json) = (*turbulence.grid(), expected());
    assert_eq!(
        (grid.planes, grid.lateral, grid.vertical, grid.tower),
        (20, 5, 7, 3)
    );
    assert_eq!(
        (grid.time_step, grid.lateral_step, grid.vertical_step),
        (0.25, 10.0, 8.0)
    );
    assert_eq!(
        (grid.speed, grid.hub_height, grid.bottom),
        (12.0, 90.0, 60.0)
    );
    assert!(!grid.periodic);
    for point in json["points"].as_array().unwrap() {
        let [t, y, z] = indices(&point["index"]).try_into().unwrap();
        compare(&turbulence.plane(t).unwrap(), grid.index(y, z), point);
    }
    for point in json["tower_points"].as_array().unwrap() {
        let [t, k] = ["time", "k"].map(|key| point[key].as_u64().unwrap() as usize);
        compare(&turbulence.plane(t).unwrap(), grid.tower_index(k), point);
    }
}

/// Largest difference of a box in memory and of a file.
fn difference(values: &BoxValues, read: &TurbulenceBox) -> f64 {
    let mut worst = 0.0_f64;
    for (index, plane) in values.planes.iter().enumerate() {
        let found = read.plane(index).unwrap();
        assert_eq!(found.len(), plane.len());
        for (a, b) in plane.iter().zip(found.iter()) {
            worst = worst.max((a - b).abs());
        }
    }
    worst
}

#[test]
fn round_trips_of_random_boxes() {
    let folder = tempfile::tempdir().unwrap();
    for seed in 0..20 {
        let mut lcg = Lcg(seed);
        let mut count = |least: usize, most: usize| least + (lcg.next() * most as f64) as usize;
        let mut grid = small(count(1, 9), seed % 2 == 0);
        (grid.lateral, grid.vertical, grid.tower) = (count(1, 6), count(1, 6), count(0, 3));
        let values = random(grid, seed);
        let path = folder.path().join("a.bts");
        write_bts(&path, &values).unwrap();
        let read = read_bts(&path, Some(3)).unwrap();
        assert_eq!(*read.grid(), grid);
        // half a step of the integers, 4 m/s over 65500 steps, and single precision of the offset
        let worst = difference(&values, &read);
        assert!(worst < 0.52 * 4.0 / 65_500.0 + 1e-6, "{worst}");
        assert!(read.cache().most <= 3);
    }
}

#[test]
fn constant_components_are_kept() {
    let mut values = random(small(4, true), 3);
    for plane in &mut values.planes {
        plane.iter_mut().skip(1).step_by(3).for_each(|v| *v = -3.25);
    }
    let file = tempfile::NamedTempFile::new().unwrap();
    write_bts(file.path(), &values).unwrap();
    let read = read_bts(file.path(), None).unwrap();
    assert_eq!(read.plane(2).unwrap()[1], -3.25);
}

#[test]
fn wrong_files_are_refused() {
    let sound = std::fs::read(folder().join("own.bts")).unwrap();
    let file = tempfile::NamedTempFile::new().unwrap();
    let problems = |bytes: &[u8]| {
        std::fs::write(file.path(), bytes).unwrap();
        read_bts(file.path(), None).unwrap_err()
    };
    let cut = problems(&sound[..sound.len() - 1]);
    let text = format!("{cut}");
    assert!(
        text.contains("4646 bytes") && text.contains("4647 bytes"),
        "{text}"
    );
    assert_eq!(problems(&sound[..40]).iter().count(), 1);
    assert_eq!(problems(&[]).iter().count(), 1);
    let mut other = sound.clone();
    other[0] = 9; // identification
    other[2..6].fill(0); // no points along z, and so another size
    other[18..22].copy_from_slice(&f32::NAN.to_le_bytes()); // dz
    assert_eq!(problems(&other).iter().count(), 4);
    assert!(read_bts(&folder().join("missing.bts"), None).is_err());
    assert!(read_bts(&folder(), None).is_err());
}

/// Random headers neither panic nor reserve memory.
#[test]
fn random_bytes_do_not_panic() {
    let sound = std::fs::read(folder().join("own.bts")).unwrap();
    let file = tempfile::NamedTempFile::new().unwrap();
    let mut lcg = Lcg(7);
    for _ in 0..500 {
        let mut bytes = sound.clone();
        for _ in 0..3 {
            bytes[(lcg.next() * 80.0) as usize] = (lcg.next() * 256.0) as u8;
        }
        std::fs::write(file.path(), &bytes).unwrap();
        if let Ok(read) = read_bts(file.path(), None) {
            let _ = read.velocity(&[0.0, 0.0, 90.0], 1.0);
        }
    }
}

/// Writes a file plane by plane: u = 12 + plane/1000 everywhere.
fn write_large(path: &std::path::Path, planes: usize, points: usize) {
    let mut grid = small(planes, true);
    (grid.lateral, grid.vertical, grid.tower) = (points, points, 0);
    let scale = Scale {
        slope: 1000.0,
        offset: 0.0,
    };
    let mut out = BufWriter::new(std::fs::File::create(path).unwrap());
    write_header(&mut out, &grid, &[scale; 3]).unwrap();
    for plane in 0..planes {
        let integer = (12_000 + plane % 1000) as i16;
        let point = [integer, 0, 0].map(i16::to_le_bytes).concat();
        out.write_all(&point.repeat(points * points)).unwrap();
    }
    out.flush().unwrap();
}

fn runs_through(planes: usize, points: usize) {
    let file = tempfile::NamedTempFile::new().unwrap();
    write_large(file.path(), planes, points);
    let turbulence = read_bts(file.path(), Some(8)).unwrap();
    for plane in 0..planes {
        let time = 0.25 * plane as f64;
        let [u, ..] = turbulence.velocity(&[0.0, 0.0, 70.0], time).unwrap();
        assert!((u - 12.0 - 1e-3 * (plane % 1000) as f64).abs() < 1e-9);
    }
    let count = turbulence.cache();
    // each plane once, the first also as the successor of the last
    assert_eq!(count.read, planes as u64 + 1);
    assert_eq!((count.held, count.most), (8, 8));
}

#[test]
fn memory_is_bounded() {
    runs_through(300, 12);
}

#[test]
#[ignore = "writes 100 MB"]
fn memory_is_bounded_for_a_large_file() {
    runs_through(4200, 64);
}
