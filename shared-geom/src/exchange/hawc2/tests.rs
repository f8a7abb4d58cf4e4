//! HAWC2's files: reference data, round trips, bad input.
#![allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]

use std::path::Path;

use nalgebra::Matrix6;

use super::section::difference;
use super::*;
use crate::exchange::samples::{blade, through};
use crate::exchange::{Format, read_with, windio};
use crate::rotation::samples::Samples;

/// Fully populated: the IEA-15, see the head of the file.
const FPM: &str = include_str!("../../../../tests/reference/exchange/hawc2_iea15_fpm_st.dat");
/// Classic, with its htc file: the DTU 10 MW, see the heads of the files.
const CLASSIC: &str = include_str!("../../../../tests/reference/exchange/hawc2_dtu10_st.dat");
const HTC: &str = include_str!("../../../../tests/reference/exchange/hawc2_dtu10.htc");
/// The IEA-15 in the axes of BeamDyn.
const WINDIO: &str = include_str!("../../../../tests/reference/exchange/windio2_iea15.yaml");

fn st_blade(text: &str) -> Reading {
    read(text, Path::new("test_st.dat"), &Options::default()).unwrap()
}

/// The blade of an htc file and its st file.
fn body_blade(htc: &str, st: &str) -> Result<Reading, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("hawc2_dtu10_st.dat"), st).unwrap();
    let file = folder.path().join("test.htc");
    std::fs::write(&file, htc).unwrap();
    read_with(&file, &Options::default()).map(|(_, reading)| reading)
}

fn k_between(blade: &Blade, s: f64) -> Matrix6<f64> {
    let k = blade.at(s, crate::line::Side::Outer).0;
    Convention::Hawc2.from_ours(&k)
}

/// Coupling of two components, relative to the roots of their stiffnesses.
fn coupling(k: &Matrix6<f64>, i: usize, j: usize) -> f64 {
    k[(i, j)] / (k[(i, i)] * k[(j, j)]).sqrt()
}

// The sign of the pitch, from two descriptions of one turbine by two tools: the st file
// of DTU (BECAS) and windIO's matrices (SONATA with ANBA4). Between a fifth and a third
// of the span the principal axes are at -20 to -30 degrees. With the right sign the
// coupling of the two shears about the line is small in both (0.02 to 0.06), with the
// wrong one 0.3 to 0.5; the coupling of flap and edge has the same sign in both.
#[test]
fn pitch_of_the_iea15_has_the_sign_of_its_beamdyn_matrices() {
    let hawc2 = st_blade(FPM).blade;
    let file = Path::new("test.yaml");
    let windio = windio::read(WINDIO, file, &Options::default())
        .unwrap()
        .blade;
    for part in [0.15, 0.2, 0.25] {
        let ours = k_between(&hawc2, part * hawc2.length());
        let theirs = k_between(&windio, part * windio.length());
        assert!(
            (coupling(&ours, 0, 1) - coupling(&theirs, 0, 1)).abs() < 0.06,
            "{part}"
        );
        let about = |k: &Matrix6<f64>| PrincipalAxes::of(k).pitch;
        assert!(about(&ours) < 0.0 && about(&theirs) < 0.0);
    }
    // EA, and flap and edge stiffness at their centers, agree within the differences of
    // two blade versions.
    for part in [0.3, 0.5, 0.7] {
        let ours = k_between(&hawc2, part * hawc2.length());
        let theirs = k_between(&windio, part * windio.length());
        for i in [2, 3, 4] {
            let ratio = PrincipalAxes::of(&ours).into_principal(&ours)[(i, i)]
                / PrincipalAxes::of(&theirs).into_principal(&theirs)[(i, i)];
            assert!((0.55..1.8).contains(&ratio), "{part} {i}: {ratio}");
        }
    }
    assert!(hawc2.problems().is_empty(), "{:?}", hawc2.problems());
}

// The numbers of the first row: diagonal of K at the elastic center, in the principal
// axes; the writer recovers elastic center and pitch (its axes are a quarter turn from
// the file's, whose pitch of -83 degrees is beyond 45).
#[test]
fn a_row_of_the_file_comes_back() {
    let reading = st_blade(FPM);
    let blade = &reading.blade;
    assert_eq!(blade.stations.len(), 20);
    assert!(
        reading.remarks[0].contains("sub-set 2"),
        "{:?}",
        reading.remarks
    );
    let text = &write(blade, "a").files[1].1;
    let mut problems = Problems::new("a");
    let subs = st::sub_sets(text, &mut problems);
    let rows = st::rows(&subs[0], Some(true), &mut problems).unwrap();
    let (Row::Full(first), Row::Full(middle)) = (rows[0], rows[10]) else {
        panic!("30 columns")
    };
    assert!(
        (first[6] - (90.0 - 83.230_174_788_3)).abs() < 1e-6,
        "{}",
        first[6]
    );
    // x_e, y_e as in the file
    assert!((first[7] - 2.775110786036501e-3).abs() < 1e-12);
    assert!((first[8] + 6.4394805265e-5).abs() < 1e-12);
    // K_44 and K_55 are exchanged with the axes
    assert!((first[24] / 1.45056703575e11 - 1.0).abs() < 1e-9);
    assert!((first[27] / 1.44629966509e11 - 1.0).abs() < 1e-9);
    // r, m, x_cg, y_cg, ri_x, ri_y, pitch, x_e, y_e, K_11 of row 11 of the file
    let expected = [
        (0, 58.5744903),
        (1, 342.7),
        (2, 0.412),
        (4, 0.4532),
        (5, 1.101),
        (6, -5.677),
        (7, 0.7458),
        (9, 3.50886043113e8),
        (24, 5.12560904195e9),
    ];
    for (column, value) in expected {
        let off: f64 = middle[column] / value - 1.0;
        // to the digits given here
        assert!(off.abs() < 5e-4, "{column}: {} {value}", middle[column]);
    }
}

// Mass of the blade: 41 722 kg in table 4.1 of the report; ours is the integral between
// the rows. The line of c2_def is 0.2 % longer than the last r.
#[test]
fn the_dtu_10mw_is_read_with_its_line() {
    let reading = body_blade(HTC, CLASSIC).unwrap();
    let blade = &reading.blade;
    assert!(
        (blade.mass() / 41_722.0 - 1.0).abs() < 5e-3,
        "{}",
        blade.mass()
    );
    assert!(blade.problems().is_empty(), "{:?}", blade.problems());
    let tip = blade.line.points.last().unwrap();
    // c2_def: x -0.089894 (to the trailing edge), y -3.33685 (prebend upwind), z 86.3655
    let expected = Vector3::new(86.3655, -0.089894, -3.33685);
    assert_eq!(tip.position, expected);
    assert!((tip.twist.to_degrees() - 3.42796).abs() < 1e-12);
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.contains("scaled to the length"))
    );
    // E A of the first row, E I_x about the chord, G I_p at the shear center nearby
    let k = blade.stations[0].stiffness;
    assert!(
        (k[(0, 0)] / 1.7802e10 - 1.0).abs() < 5e-3,
        "{:e}",
        k[(0, 0)]
    );
    assert!((k[(3, 3)] / (2.5268066213700e9 * 1.0865806875700e1) - 1.0).abs() < 1e-2);
    // damping_posdef: times of edge, flap and torsion; ours are of torsion, flap and edge
    let times = [0.0, 0.0, 0.0, 3.3e-4, 2.55e-3, 1.53e-3];
    assert_eq!(blade.damping, Some(BladeDamping::Times(times)));
}

// The classic rows of Helicoid's file have the stiffness of DTU's.
#[test]
fn classic_rows_come_back() {
    let blade = body_blade(HTC, CLASSIC).unwrap().blade;
    let writing = write(&blade, "a");
    let back = st_blade(&writing.files[2].1).blade;
    assert!(
        !writing.lost.iter().any(|lost| lost.contains("classic")),
        "{:?}",
        writing.lost
    );
    for (found, expected) in back.stations.iter().zip(&blade.stations) {
        assert!(difference(&found.stiffness, &expected.stiffness) < 1e-9);
        assert!(difference(&found.mass, &expected.mass) < 1e-9);
    }
}

// Full matrices, twist, prebend and sweep: K to 1e-12 after the round trip; the mass
// except for its product of inertia, which is reported with its size.
#[test]
fn a_full_blade_comes_back_but_for_what_is_reported() {
    let mut sample = blade();
    sample.damping = None;
    let reading = through(&sample, Format::Hawc2);
    let back = &reading.blade;
    assert_eq!(back.line.course, sample.line.course);
    for (found, expected) in back.line.points.iter().zip(&sample.line.points) {
        assert_eq!(found.position, expected.position);
        assert!((found.twist - expected.twist).abs() < 1e-15);
    }
    let mut apart = 0.0_f64;
    for (found, expected) in back.stations.iter().zip(&sample.stations) {
        assert!((found.arc_length - expected.arc_length).abs() < 1e-14);
        let off = difference(&found.stiffness, &expected.stiffness);
        assert!(off < 1e-12, "{off:e}");
        apart = apart.max(difference(&found.mass, &expected.mass));
        let [m, y, z] = [(0, 0), (0, 4), (0, 5)].map(|at| found.mass[at] - expected.mass[at]);
        assert!([m, y, z].iter().all(|off| off.abs() < 1e-13));
    }
    let lost = write(&sample, "a").lost.join("\n");
    assert!(
        lost.contains(&format!("up to {apart:.2e} of the moments")),
        "{lost}"
    );
    assert!(
        lost.contains("prebend and sweep") && !lost.contains("between the rows"),
        "{lost}"
    );
    assert!(lost.contains("in the classic file alone"), "{lost}");
}

// The elastic center moves between the rows: K interpolated about it is not K
// interpolated about the line. Half way between centers a apart, 1/4 EA a^2 of bending is
// missing.
#[test]
fn the_course_between_rows_is_reported_with_its_size() {
    let mut plate = blade();
    plate.damping = None;
    let own = Matrix6::from_diagonal(&[9e8, 3e8, 3e8, 2e6, 1e6, 2e7].into());
    for (i, station) in plate.stations.iter_mut().enumerate() {
        let offset = Vector3::new(0.0, 0.0, -0.02 * i as f64);
        station.stiffness = crate::wrench::shift(&own, &offset);
    }
    let lost = write(&plate, "a").lost.join("\n");
    // 1/4 9e8 0.02^2 / (1e6 + 9e4), 0.02 m being each row's offset
    let part = 0.25 * 9e8 * 0.02_f64.powi(2) / (1e6 + 0.25 * 9e8 * 0.02_f64.powi(2));
    assert!(
        lost.contains(&format!(
            "the difference is up to {part:.2e} of the diagonal"
        )),
        "{lost}"
    );
}

// A slice whose axes of inertia are its axes of bending loses nothing.
#[test]
fn a_blade_of_rectangles_loses_no_mass_or_stiffness() {
    let mut plate = blade();
    plate.damping = None;
    for station in &mut plate.stations {
        station.stiffness = Matrix6::from_diagonal(&[9e8, 3e8, 3e8, 2e6, 1e6, 2e7].into());
        station.mass = Matrix6::from_diagonal(&[5.0, 5.0, 5.0, 0.21, 0.01, 0.2].into());
    }
    let lost = write(&plate, "a").lost;
    // only the axes of zero twist, and the chord
    assert_eq!(lost.len(), 2, "{lost:?}");
    let back = through(&plate, Format::Hawc2).blade;
    for (found, expected) in back.stations.iter().zip(&plate.stations) {
        assert!(difference(&found.mass, &expected.mass) < 1e-14);
    }
}

#[test]
fn damping_that_is_zero_is_not_lost() {
    let mut blade = blade();
    let reported = |blade: &Blade| {
        let lost = write(blade, "b").lost;
        lost.iter().any(|what| what.starts_with("damping"))
    };
    blade.damping = Some(BladeDamping::Times([0.0, 0.0, 0.0, 1e-3, 2e-3, 3e-3]));
    assert!(!reported(&blade));
    blade.damping = Some(BladeDamping::Proportional(0.0));
    assert!(!reported(&blade));
    blade.damping = Some(BladeDamping::Proportional(1e-3));
    assert!(reported(&blade));
}

#[test]
fn damping_goes_into_three_factors() {
    let sample = blade();
    let back = through(&sample, Format::Hawc2).blade;
    let time = 1.3e-3;
    let times = [0.0, 0.0, 0.0, time, time, time];
    assert_eq!(back.damping, Some(BladeDamping::Times(times)));
    assert!(
        write(&sample, "a")
            .lost
            .iter()
            .any(|lost| lost.contains("damping_posdef"))
    );
}

#[test]
fn the_heads_state_frame_order_and_point() {
    for (_, text) in write(&blade(), "a").files {
        for words in [
            "; written by Helicoid ",
            "; input: sha256:0123",
            "; frame: hawc2",
        ] {
            assert!(text.contains(words), "{words}");
        }
        assert!(text.contains("; reference point: the "));
        assert!(text.contains("; order: edge shear (x), flap shear (y), axial (z)"));
    }
}

fn st_messages(from: &str, to: &str) -> String {
    assert!(FPM.contains(from), "\"{from}\" is in the file");
    let refused = read(
        &FPM.replacen(from, to, 1),
        Path::new("st.dat"),
        &Options::default(),
    );
    refused.unwrap_err().to_string()
}

fn assert_says(messages: &str, expected: &str) {
    assert!(
        messages.contains(expected),
        "expected {expected:?} in:\n{messages}"
    );
}

#[test]
fn bad_st_files_are_reported_with_line_and_remedy() {
    let says = |from: &str, to: &str, expected: &str| assert_says(&st_messages(from, to), expected);
    says(
        "0.0 3176.5747016",
        "0.0 heavy",
        "st.dat:8: column m: expected a finite number, found \"heavy\"",
    );
    says(
        "0.0 3176.5747016 ",
        "0.0 ",
        "st.dat:8: a row of the st file: found 29 numbers, expected 19 (classic) or 30",
    );
    says(
        "$1 20",
        "$1 twenty",
        "st.dat:7: the head of a sub-set: found \"$1 twenty Flexible\", expected $, its number",
    );
    says("#1 blade", "1 blade", "expected a set (#1) before it");
    says(
        "$1 20",
        "$1 21",
        "st.dat:27: the file ends within set 1, sub-set 1, after 20 rows, expected 21 rows",
    );
    let second = FPM.lines().nth(8).unwrap();
    let (r, rest) = second.split_once(' ').unwrap();
    assert!(r.starts_with("3.5"), "{r}");
    says(
        second,
        &format!("-1.0 {rest}"),
        "st.dat:9: the distance r of a row of set 1, sub-set 1 is -1, expected at least the value of the previous station, 0",
    );
    let cut = second.rsplit_once(' ').unwrap().0;
    says(
        second,
        cut,
        "st.dat:9: a row of the st file: expected 30 numbers, found 29",
    );
}

#[test]
fn bad_htc_files_are_reported_with_line_and_remedy() {
    let says = |from: &str, to: &str, expected: &str| {
        assert!(HTC.contains(from), "\"{from}\" is in the file");
        let messages = body_blade(&HTC.replacen(from, to, 1), CLASSIC)
            .map(|_| ())
            .unwrap_err();
        assert_says(&messages.to_string(), expected);
    };
    says(
        "set 1 1",
        "set 3 2",
        "found no set 3, sub-set 2, which line 13 of the htc file names, expected one of set 1, sub-set 1",
    );
    says(
        "set 1 1",
        "FPM 1 ;\n set 1 1",
        "found 19 numbers, expected 30, since the htc file has FPM 1",
    );
    says(
        "hawc2_dtu10_st.dat",
        "none.dat",
        "test.htc:12: the st file of the body: found no file \"./none.dat\"",
    );
    says(
        "nsec 27",
        "nsec 28",
        "test.htc:16: the file ends within c2_def of \"blade1\", after 27 sections, expected 28, as nsec announces",
    );
    says(
        "sec 3 ",
        "sec ",
        "the statement sec: expected 5 numbers, found 4",
    );
    says(
        "sec 3 ",
        "sec 3 x ",
        "the statement sec: expected a finite number, found \"x\"",
    );
    says("filename", "filname", "help: did you mean \"filename\"?");
    says(
        "end c2_def",
        "end c2def",
        "the end of a block: found \"end c2def\", expected \"end c2_def\", since line 15 begins it",
    );
    says(
        "end new_htc_structure;",
        "",
        "the file ends within the block \"new_htc_structure\"",
    );
}

#[test]
fn a_body_of_another_name_is_read_when_it_is_alone() {
    let reading = body_blade(&HTC.replace("blade1", "wing"), CLASSIC).unwrap();
    assert_eq!(reading.blade.stations.len(), 51);
    let both = HTC.replace("end new_htc_structure", "") + &HTC.replace("blade1", "wing");
    let reading = body_blade(&both.replacen("structure;", "structure;\n", 1), CLASSIC);
    assert!(reading.is_err());
}

// HAWC2 runs above the folder of the htc file, and the name is relative to that folder.
#[test]
fn the_st_file_is_found_from_the_folders_above() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::create_dir_all(path("htc")).unwrap();
    std::fs::create_dir_all(path("data")).unwrap();
    std::fs::write(path("data/b_st.dat"), CLASSIC).unwrap();
    let text = HTC.replace("hawc2_dtu10_st.dat", "data\\b_st.dat");
    std::fs::write(path("htc/a.htc"), text).unwrap();
    let (format, reading) = read_with(&path("htc/a.htc"), &Options::default()).unwrap();
    assert_eq!(format, Format::Hawc2);
    assert_eq!(reading.blade.stations.len(), 51);
}

#[test]
fn rows_beyond_the_line_are_cut_and_reported() {
    let longer = CLASSIC.replace("\n86.366 ", "\n100.0 ");
    assert_ne!(longer, CLASSIC);
    let reading = body_blade(HTC, &longer).unwrap();
    let blade = &reading.blade;
    let last = blade.stations.last().unwrap().arc_length;
    assert!((last - blade.length()).abs() < 1e-12);
    assert!(blade.problems().is_empty(), "{:?}", blade.problems());
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.contains("not used"))
    );
}

// A radius smaller than the distance of the centers: the moment is set to zero, with a
// remark.
#[test]
fn radii_about_another_point_are_reported() {
    let second = FPM.lines().nth(7).unwrap();
    let mut words: Vec<_> = second.split(' ').collect();
    words[2] = "2.0";
    let reading = st_blade(&FPM.replace(second, &words.join(" ")));
    let reported = reading
        .remarks
        .iter()
        .any(|remark| remark.contains("radii of gyration at 1 of 20"));
    assert!(reported, "{:?}", reading.remarks);
}

#[test]
fn a_file_that_is_cut_off_is_refused() {
    // Only the first sub-set is read; the file may end after it.
    let whole = FPM.find("\n$2").unwrap();
    for end in (0..whole - 30).step_by(37) {
        let cut = &FPM[..end];
        assert!(
            read(cut, Path::new("st.dat"), &Options::default()).is_err(),
            "cut at byte {end}"
        );
    }
    for end in (0..HTC.trim_end().len() - 1).step_by(41) {
        assert!(
            body_blade(&HTC[..end], CLASSIC).is_err(),
            "cut at byte {end}"
        );
    }
}

#[test]
fn no_changed_byte_makes_the_readers_panic() {
    let mut samples = Samples::new(6);
    for i in 0..200 {
        let text = if i % 2 == 0 { FPM } else { HTC };
        let mut bytes = text.as_bytes().to_vec();
        let at = (samples.scalar().abs() * bytes.len() as f64) as usize % bytes.len();
        bytes[at] = b"0-9#$;e \n\t.xE"[at % 13];
        let Ok(text) = std::str::from_utf8(&bytes) else {
            continue;
        };
        let file = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/tests/reference/exchange/test.htc"
        );
        if let Ok(reading) = read(text, Path::new(file), &Options::default()) {
            let _ = write(&reading.blade, "a");
        }
    }
}
