//! Tests of `.wnd` files: our own file with the values of an independent script, round trips,
//! types without intensities, wrong files.

use std::path::PathBuf;

use super::super::grid::tests::{Lcg, random, small};
use super::*;

fn folder() -> PathBuf {
    PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/aero/boxes"
    ))
}

fn own() -> Vec<u8> {
    std::fs::read(folder().join("own.wnd")).unwrap()
}

fn read(bytes: &[u8], input: &BladedInput) -> Result<TurbulenceBox, Diagnostics> {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), bytes).unwrap();
    read_bladed(file.path(), input)
}

fn summary() -> BladedSummary {
    BladedSummary {
        clockwise: false,
        hub_height: 100.0,
        speed: 12.0,
        intensities: [30.0, 24.0, 16.0],
        height_offset: 4.0,
        periodic: true,
    }
}

#[test]
fn points_of_the_reference_file() {
    let turbulence = read_bladed(&folder().join("own.wnd"), &BladedInput::default()).unwrap();
    let grid = *turbulence.grid();
    assert_eq!((grid.planes, grid.lateral, grid.vertical), (20, 5, 7));
    assert_eq!(
        (grid.time_step, grid.bottom, grid.speed),
        (0.25, 66.0, 12.0)
    );
    let text = std::fs::read_to_string(folder().join("expected.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    for point in json["points"].as_array().unwrap() {
        let [t, y, z] = [0, 1, 2].map(|i| point["index"][i].as_u64().unwrap() as usize);
        let plane = turbulence.plane(t).unwrap();
        for c in 0..3 {
            let expected = point["u"][c].as_f64().unwrap();
            let found = plane[grid.index(y, z) + c];
            // half a step of the integers of u: 0.9e-3
            assert!((found - expected).abs() < 1e-3, "{found} {expected}");
        }
    }
}

#[test]
fn round_trips_of_random_boxes() {
    let file = tempfile::NamedTempFile::new().unwrap();
    for seed in 0..10 {
        let mut grid = small(2 * (1 + seed as usize), false);
        grid.tower = 0;
        let values = random(grid, seed);
        write_bladed(file.path(), &values).unwrap();
        let turbulence = read_bladed(file.path(), &BladedInput::default()).unwrap();
        assert_eq!(*turbulence.grid(), grid);
        for (index, plane) in values.planes.iter().enumerate() {
            let found = turbulence.plane(index).unwrap();
            for (a, b) in plane.iter().zip(found.iter()) {
                // half of a thousandth of the standard deviation, which is below 1.5
                assert!((a - b).abs() < 0.75e-3, "{a} {b}");
            }
        }
    }
}

#[test]
fn what_the_format_does_not_have_is_not_written() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let mut values = random(small(3, false), 1);
    values.grid.hub_height += 1.0;
    let problems = write_bladed(file.path(), &values).unwrap_err();
    // tower points, odd number, middle
    assert_eq!(problems.iter().count(), 3, "{problems}");
}

/// The first bytes of type 3, which has no intensities and no height.
fn without_intensities() -> Vec<u8> {
    let own = own();
    let mut bytes = own[..2].to_vec();
    bytes.extend(3_i16.to_le_bytes());
    // i32 and six f32 of type 4 are left out
    bytes.extend(&own[32..]);
    bytes
}

#[test]
fn intensities_and_height_of_the_summary() {
    let bytes = without_intensities();
    let problems = read(&bytes, &BladedInput::default()).unwrap_err();
    // intensities, height
    assert_eq!(problems.iter().count(), 2, "{problems}");
    let mut input = BladedInput {
        summary: Some(summary()),
        ..BladedInput::default()
    };
    let own = read(&own(), &BladedInput::default()).unwrap();
    let summed = read(&bytes, &input).unwrap();
    let grid = *summed.grid();
    // the middle of the grid is 4 m below the hub at 100 m
    assert_eq!((grid.bottom, grid.periodic), (72.0, true));
    let at = |turbulence: &TurbulenceBox, index: usize| turbulence.plane(3).unwrap()[index];
    let [one, mirror] = [grid.index(1, 2), grid.index(3, 2)];
    // twice the intensities
    for c in 0..3 {
        let mean = if c == 0 { 12.0 } else { 0.0 };
        let ratio = (at(&summed, one + c) - mean) / (at(&own, one + c) - mean);
        assert!((ratio - 2.0).abs() < 1e-6, "{c}: {ratio}");
    }
    input.summary = Some(BladedSummary {
        clockwise: true,
        ..summary()
    });
    input.left_handed = true;
    let mirrored = read(&bytes, &input).unwrap();
    assert_eq!(at(&mirrored, mirror), at(&summed, one));
    assert_eq!(at(&mirrored, mirror + 1), -at(&summed, one + 1));
    input.summary = Some(BladedSummary {
        speed: 10.0,
        ..summary()
    });
    assert!(read(&bytes, &input).is_err());
}

#[test]
fn given_intensities_have_precedence() {
    let input = BladedInput {
        summary: Some(summary()),
        intensities: Some([0.0, 1.0, 2.0]),
        hub_height: Some(50.0),
        periodic: Some(false),
        ..BladedInput::default()
    };
    let turbulence = read(&own(), &input).unwrap();
    assert_eq!(turbulence.plane(0).unwrap()[0], 12.0);
    assert_eq!(
        (turbulence.grid().bottom, turbulence.grid().periodic),
        (22.0, false)
    );
}

#[test]
fn wrong_files_are_refused() {
    let own = own();
    let problems = |bytes: &[u8]| read(bytes, &BladedInput::default()).unwrap_err();
    let text = format!("{}", problems(&own[..own.len() - 2]));
    assert!(
        text.contains("4302 bytes") && text.contains("4304 bytes"),
        "{text}"
    );
    assert_eq!(problems(&own[..20]).iter().count(), 1);
    let mut other = own.clone();
    other[0] = 0;
    assert!(format!("{}", problems(&other)).contains("-99"));
    other[0] = own[0];
    other[2] = 6;
    assert!(format!("{}", problems(&other)).contains("type"));
    let mut lcg = Lcg(3);
    for _ in 0..300 {
        let mut bytes = own.clone();
        for _ in 0..3 {
            bytes[(lcg.next() * 110.0) as usize] = (lcg.next() * 256.0) as u8;
        }
        if let Ok(turbulence) = read(&bytes, &BladedInput::default()) {
            let _ = turbulence.velocity(&[0.0, 0.0, 90.0], 2.0);
        }
    }
}
