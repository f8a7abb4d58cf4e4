//! Tests of Mann boxes: our own file, a public one, round trips, wrong files.

use super::super::grid::tests::{random, small};
use super::*;

fn folder() -> PathBuf {
    PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/aero/boxes"
    ))
}

fn json(name: &str) -> serde_json::Value {
    let text = std::fs::read_to_string(folder().join(name)).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn input(name: &str, points: [usize; 3]) -> MannInput {
    MannInput {
        files: [Some(folder().join(name)), None, None],
        points,
        steps: [3.0, 10.0, 8.0],
        speed: 12.0,
        hub_height: 90.0,
        sigma: None,
        order: PlaneOrder::FirstArrives,
        cache: None,
    }
}

fn indices(point: &serde_json::Value) -> [usize; 3] {
    [0, 1, 2].map(|i| point["index"][i].as_u64().unwrap() as usize)
}

/// The file has u of the box of the `.bts` file with its mean.
#[test]
fn points_of_the_reference_file() {
    let turbulence = read_mann(&input("own_20x5x7.u", [20, 5, 7])).unwrap();
    let grid = *turbulence.grid();
    assert_eq!(
        (grid.time_step, grid.bottom, grid.periodic),
        (0.25, 66.0, true)
    );
    for point in json("expected.json")["points"].as_array().unwrap() {
        let [t, y, z] = indices(point);
        let found = turbulence.plane(t).unwrap()[grid.index(y, z)];
        let expected = point["u"][0].as_f64().unwrap();
        // single precision of numbers below 16
        assert!((found - expected).abs() < 1e-6, "{found} {expected}");
    }
}

/// A box of openfast_toolbox (Apache-2.0), read by the toolbox.
#[test]
fn points_and_statistics_of_a_public_file() {
    let name = "public_MannBox_32x4x8.bin";
    let mut input = input(name, [32, 4, 8]);
    let turbulence = read_mann(&input).unwrap();
    let (grid, json) = (*turbulence.grid(), json("public_MannBox_expected.json"));
    for point in json["points"].as_array().unwrap() {
        let [t, y, z] = indices(point);
        let found = turbulence.plane(t).unwrap()[grid.index(y, z)];
        assert!((found - point["u"].as_f64().unwrap()).abs() < 1e-6);
    }
    let path = folder().join(name);
    let sigma = deviation(&mut open(&path).unwrap(), 128).unwrap();
    // the sum of the toolbox is in single precision
    let expected = json["std"].as_f64().unwrap();
    assert!(
        (sigma - expected).abs() < 1e-6 * expected,
        "{sigma} {expected}"
    );
    // scaled to half of it
    input.sigma = Some([0.5 * sigma, 1.0, 1.0]);
    let scaled = read_mann(&input).unwrap();
    let pair = [&scaled, &turbulence].map(|it| it.plane(5).unwrap()[grid.index(3, 7)]);
    assert!((pair[0] - 0.5 * pair[1]).abs() < 1e-12);
    // the other end of the file arrives first
    input.order = PlaneOrder::LastArrives;
    let reversed = read_mann(&input).unwrap();
    assert_eq!(reversed.plane(0).unwrap(), scaled.plane(31).unwrap());
}

#[test]
fn round_trips_of_random_boxes() {
    let folder = tempfile::tempdir().unwrap();
    let paths = ["u", "v", "w"].map(|name| folder.path().join(name));
    for seed in 0..10 {
        let mut grid = small(3 + seed as usize, true);
        grid.tower = 0;
        let values = random(grid, seed);
        write_mann(&paths, &values, 12.0).unwrap();
        let mut input = input("", [grid.planes, grid.lateral, grid.vertical]);
        input.files = paths.clone().map(Some);
        input.hub_height = grid.hub_height;
        input.cache = Some(2);
        let read = read_mann(&input).unwrap();
        assert_eq!(*read.grid(), grid);
        for (index, plane) in values.planes.iter().enumerate() {
            let found = read.plane(index).unwrap();
            for (i, (a, b)) in plane.iter().zip(found.iter()).enumerate() {
                let mean = if i % 3 == 0 { 12.0 } else { 0.0 };
                // single precision of numbers below 2
                assert!((a - mean - b).abs() < 1.3e-7);
            }
        }
    }
    let tower = random(small(3, true), 1);
    assert!(write_mann(&paths, &tower, 0.0).is_err());
}

#[test]
fn wrong_files_and_numbers_are_refused() {
    let problems = |input: &MannInput| format!("{}", read_mann(input).unwrap_err());
    let text = problems(&input("own_20x5x7.u", [20, 5, 8]));
    assert!(
        text.contains("2800 bytes") && text.contains("3200 bytes"),
        "{text}"
    );
    let mut none = input("own_20x5x7.u", [0, 5, 7]);
    none.speed = 0.0;
    none.files = [None, None, None];
    none.sigma = Some([f64::NAN; 3]);
    let found = read_mann(&none).unwrap_err();
    // planes, time step, speed, files, and the deviations, which are equal
    assert_eq!(found.iter().count(), 5, "{found}");
    assert!(read_mann(&input("missing", [20, 5, 7])).is_err());
    let file = tempfile::NamedTempFile::new().unwrap();
    let mut numbers = [0.0_f32; 8];
    let mut own = input("", [2, 2, 2]);
    own.files[0] = Some(file.path().to_owned());
    let mut write = |index: usize, value: f32| {
        numbers[index] = value;
        let bytes: Vec<u8> = numbers.iter().flat_map(|v| v.to_le_bytes()).collect();
        std::fs::write(file.path(), bytes).unwrap();
    };
    write(0, 0.0);
    own.sigma = Some([1.0; 3]);
    assert!(problems(&own).contains("standard deviation"));
    write(5, f32::NAN);
    let text = problems(&own);
    assert!(
        text.contains("1 that are not finite") && text.contains("20"),
        "{text}"
    );
}
