use std::path::PathBuf;

use nalgebra::{Matrix6, Vector2, Vector3};

use super::*;
use crate::blade::{Side, parse, read};
use crate::line::about_x;
use crate::section;
use crate::wrench;

fn case(name: &str) -> Reading {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cases/dynamics");
    let read = read(&folder.join(name).join(format!("{name}.blade.toml")));
    read.unwrap_or_else(|problems| panic!("{problems}"))
}

fn good(text: &str) -> Blade {
    parse(text, "a.blade.toml").map_or_else(|p| panic!("{p}"), |reading| reading.blade)
}

// Masses and arc lengths of the same tables by an independent script (six digits of the
// masses, six of the lengths): `wind_blade_standstill_modes` of the reference data. Of
// the NREL 5 MW, BeamDyn prints 16844.752 kg (`bd_primary.inp.sum` of OpenFAST's r-test).
#[test]
fn wind_blades_have_their_published_masses_and_lengths() {
    for (name, mass, length) in [("nrel5mw", 16844.752, 61.5), ("iea15", 66996.86, 117.149)] {
        let Reading { blade, remarks, .. } = case(name);
        assert!((blade.mass() / mass - 1.0).abs() < 1e-6, "{}", blade.mass());
        assert!((blade.length() - length).abs() < 5e-4, "{}", blade.length());
        assert_eq!(remarks, Vec::<String>::new());
        // Twist reduces toward the tip; BeamDyn's is nose down.
        let root = blade.line.points[0].twist.to_degrees();
        assert!(root < -13.0, "{root}");
    }
    // BeamDyn's flap and edge bending of the first station, rows 5 and 4.
    let k = case("nrel5mw").blade.at(0.0, Side::Outer).0;
    assert_eq!(
        (k[(4, 4)], k[(5, 5)], k[(3, 3)]),
        (1.811e10, 1.81136e10, 5.5644e9)
    );
    // Prebend to the pressure side.
    assert!(case("iea15").blade.line.points.last().unwrap().position.z < -3.0);
}

// With ballast (TM 4760) and with carbon spars (IEA 15 MW): weights are distinguished
// from masses in both.
#[test]
fn weights_are_distinguished_from_masses_of_real_blades() {
    for name in ["nrel5mw", "iea15", "tm4760"] {
        let mut blade = case(name).blade;
        for station in &mut blade.stations {
            station.mass *= 9.80665;
        }
        let remarks = blade.remarks();
        let is_reported = remarks.iter().any(|remark| remark.contains("weight (N/m)"));
        assert!(is_reported, "{name}: {remarks:?}");
    }
}

// By hand from the table: sum of the weights per inch times the lengths, 4.13270 lb.
#[test]
fn a_helicopter_blade_in_inches_and_pounds_is_read_in_si() {
    let Reading { blade, remarks, .. } = case("tm4760");
    let (inch, pound, psi) = (0.0254, 0.453_592_37, 6_894.757_293_168_361);
    let rows = [
        (3.0, 0.4251),
        (6.87, 0.1938),
        (8.87, 0.04086),
        (10.625, 0.15113),
        (12.5, 0.14048),
        (13.0, 0.03134),
        (15.375, 0.04376),
        (17.85, 0.04123),
        (23.75, 0.04),
        (28.25, 0.03903),
        (51.0, 0.03903),
        (52.75, 0.04125),
        (53.0, 0.07867),
        (54.0, 0.0607),
        (54.25, 0.01101),
        (55.0, 0.0),
    ];
    let pieces = rows.windows(2).map(|row| (row[1].0 - row[0].0) * row[0].1);
    let mass = pieces.sum::<f64>() * pound;
    assert!(
        (blade.mass() / mass - 1.0).abs() < 1e-14,
        "{} {mass}",
        blade.mass()
    );
    assert!((blade.length() - 52.0 * inch).abs() < 1e-15);
    // r = 20 in: EI flap 1e7 psi 0.00231 in^4, GA = 5/6 E/2.6 0.278 in^2.
    let (k, m) = blade.at(17.0 * inch, Side::Inner);
    let (eiy, ga) = (
        1e7 * 0.00231 * psi * inch.powi(4),
        1e7 / 2.6 * 0.278 * psi * inch * inch,
    );
    assert!((k[(4, 4)] / eiy - 1.0).abs() < 1e-12);
    assert!((k[(1, 1)] / (ga * 5.0 / 6.0) - 1.0).abs() < 1e-12);
    assert!((m[(3, 3)] / (0.02888 * pound * inch) - 1.0).abs() < 1e-12);
    // The tip's center of mass is 0.94 in aft of the line.
    let m = blade.at(blade.length(), Side::Inner).1;
    assert!((m[(5, 0)] / (0.94 * inch * 0.01101 * pound / inch) - 1.0).abs() < 1e-12);
    assert_eq!(blade.jumps().len(), 14);
    assert_eq!(remarks, Vec::<String>::new());
    assert!(blade.provenance.input_hash.starts_with("sha256:"));
}

/// A symmetric matrix of 21 different numbers, positive definite.
fn full() -> Matrix6<f64> {
    let mut k = Matrix6::from_fn(|i, j| 0.1 * (1.0 + (i.min(j) * 6 + i.max(j)) as f64 / 7.0));
    k.fill_diagonal(0.0);
    k + Matrix6::from_diagonal(&[9.0, 8.0, 7.0, 6.0, 5.0, 10.0].into())
}

/// A mass at (y, z).
fn mass() -> Matrix6<f64> {
    let own = Matrix6::from_diagonal(&[2.0, 2.0, 2.0, 0.5, 0.2, 0.3].into());
    wrench::shift(&own, &Vector3::new(0.0, -0.4, 0.1))
}

fn upper(matrix: &Matrix6<f64>) -> String {
    let numbers: Vec<_> = matrix::upper()
        .map(|(i, j)| matrix[(i, j)].to_string())
        .collect();
    format!("[{}]", numbers.join(", "))
}

fn rows(matrix: &Matrix6<f64>) -> String {
    let row = |i: usize| -> String {
        let numbers: Vec<_> = (0..6).map(|j| matrix[(i, j)].to_string()).collect();
        format!("[{}]", numbers.join(", "))
    };
    let rows: Vec<_> = (0..6).map(row).collect();
    format!("[{}]", rows.join(", "))
}

/// A blade of two stations with `k` and `m`, as a file in the axes of `frame`.
fn written(frame: &str, line: &str, point: &str, k: &str, m: &str) -> String {
    let station = |eta: f64| format!("[[station]]\neta = {eta}\nstiffness = {k}\nmass = {m}\n");
    format!(
        "units = \"SI\"\n{frame}\nreference_point = {point}\n[line]\ncourse = \"spline\"\n{line}\n\
         {}{}",
        station(0.0),
        station(1.0)
    )
}

/// The line of one blade in the axes of HAWC2, in the axes of BeamDyn, and as words.
const LINES: [&str; 3] = [
    "x = [0, 0.2, -0.1]\ny = [0, 0.3, 0.4]\nz = [0, 5, 10]\ntwist = [10, 5, 0]",
    "x = [0, 0.3, 0.4]\ny = [0, -0.2, 0.1]\nz = [0, 5, 10]\ntwist = [-10, -5, 0]",
    "span = [0, 5, 10]\nsweep = [0, -0.2, 0.1]\nprebend = [0, 0.3, 0.4]\ntwist = [10, 5, 0]",
];

/// Declaration of a frame; its line; its reference point; the indices of its components
/// among Helicoid's, by hand: BeamDyn's x is our z, its y our -y, its z our x.
type Written = (&'static str, usize, &'static str, [usize; 6]);

const WRITTEN: [Written; 6] = [
    ("\"vabs\"", 2, "[0.2, 0.1]", [0, 1, 2, 3, 4, 5]),
    ("\"sonata\"", 2, "[0.2, 0.1]", [0, 1, 2, 3, 4, 5]),
    ("\"hawc2\"", 0, "[0.2, 0.1]", [1, 2, 0, 4, 5, 3]),
    ("\"anba4\"", 0, "[0.2, 0.1]", [1, 2, 0, 4, 5, 3]),
    ("\"beamdyn\"", 1, "[0.1, -0.2]", [2, 1, 0, 5, 4, 3]),
    (
        "[\"upper\", \"trailing edge\", \"tip\"]\n\
         order = [\"Fz\", \"Mz\", \"Fx\", \"Fy\", \"Mx\", \"My\"]\n\
         twist_positive = \"nose down\"",
        1,
        "[0.1, -0.2]",
        [0, 3, 2, 1, 5, 4],
    ),
];

// One blade, written in the axes and signs of each tool: the same numbers are read.
#[test]
fn a_blade_is_the_same_from_every_frame() {
    let (k, m) = (full(), mass());
    let ours = good(&written(
        "frame = \"helicoid\"",
        "x = [0, 5, 10]\ny = [0, 0.2, -0.1]\nz = [0, 0.3, 0.4]\ntwist = [10, 5, 0]",
        "[0.2, 0.1]",
        &rows(&k),
        &rows(&m),
    ));
    assert_eq!(ours.stations[0].stiffness, k);
    assert_eq!(ours.reference_point, Vector2::new(0.2, 0.1));
    for (frame, line, point, indices) in WRITTEN {
        // In the second line, an axis points against our y: the components along and
        // about it, shear y and bending y, have the other sign.
        let sign = |index: usize| match (line, indices[index]) {
            (1, 1 | 4) => -1.0,
            _ => 1.0,
        };
        let theirs = |matrix: &Matrix6<f64>| {
            Matrix6::from_fn(|i, j| sign(i) * sign(j) * matrix[(indices[i], indices[j])])
        };
        let frame = format!("frame = {frame}");
        let (k, m) = (upper(&theirs(&k)), rows(&theirs(&m)));
        let mut read = good(&written(&frame, LINES[line], point, &k, &m));
        // Of another text.
        read.provenance = ours.provenance.clone();
        assert_eq!(read, ours, "{frame}");
    }
}

// Units: K of 1 lbf, lbf in, lbf in^2; M of 1 lb/in, lb, lb in; positions in inches.
#[test]
fn matrices_are_in_declared_units() {
    let eye = rows(&(Matrix6::identity() * 2.0));
    let text = written(
        "frame = \"helicoid\"",
        "x = [0, 10]",
        "\"line\"",
        &eye,
        &eye,
    );
    let text = text.replace(
        "units = \"SI\"",
        "units = { length = \"in\", force = \"lbf\", mass = \"lb\" }",
    );
    let blade = good(&text.replace("[[station]]\neta = 1", "[[station]]\narc_length = 10"));
    let (inch, lbf, lb) = (0.0254, 4.448_221_615_260_5, 0.453_592_37);
    let (k, m) = (blade.stations[1].stiffness, blade.stations[1].mass);
    let found = [
        blade.stations[1].arc_length,
        k[(1, 1)],
        k[(5, 5)],
        m[(1, 1)],
        m[(5, 5)],
    ];
    let expected = [
        10.0 * inch,
        2.0 * lbf,
        2.0 * lbf * inch * inch,
        2.0 * lb / inch,
        2.0 * lb * inch,
    ];
    for (found, expected) in found.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-15, "{found} {expected}");
    }
}

const ENGINEERING: &str = "units = \"SI\"\nframe = \"helicoid\"\nreference_point = \"line\"\n\
    [line]\nlength = 10\n[[station]]\narc_length = 0\nea = 7e6\ngay = 2e6\ngaz = 1e6\ngj = 30\n\
    eiy = 40\neiz = 900\nm = 2\niy = 0.01\niz = 0.04\ntension_center = [0.3, -0.1]\n\
    stiffness_angle = 90\n";

#[test]
fn engineering_properties_give_matrices() {
    let blade = good(ENGINEERING);
    let k = blade.stations[0].stiffness;
    // Turned by 90 degrees; Steiner's part of EA at (0.3, -0.1).
    assert!((k[(4, 4)] - (900.0 + 7e6 * 0.01)).abs() < 1e-9, "{k}");
    assert!((k[(5, 5)] - (40.0 + 7e6 * 0.09)).abs() < 1e-9);
    assert!((k[(4, 0)] + 7e6 * 0.1).abs() < 1e-9 && (k[(1, 1)] - 1e6).abs() < 1e-9);
    assert!((blade.mass() - 20.0).abs() < 1e-12);
    // Mass as a matrix with them.
    let text = ENGINEERING.replace("m = 2\niy = 0.01\niz = 0.04\n", "");
    let text = format!("{text}mass = {}\n", rows(&mass()));
    assert_eq!(good(&text).stations[0].mass, mass());
}

// Three equivalent ways: a separate reference point, separate axes, both.
#[test]
fn a_station_may_be_elsewhere() {
    let text = |point: &str, angle: &str, k: &Matrix6<f64>, m: &Matrix6<f64>| {
        let station = format!(
            "[[station]]\narc_length = 0\nreference_point = {point}\nangle = {angle}\n\
             stiffness = {}\nmass = {}\n",
            rows(k),
            rows(m)
        );
        format!(
            "units = \"SI\"\nframe = \"helicoid\"\nreference_point = \"line\"\n[line]\n\
             length = 10\n{station}"
        )
    };
    let (k, m) = (full(), mass());
    let plain = good(&text("[0, 0]", "0", &k, &m));
    // Axes of the properties turned nose up by 30 degrees, point at (0.2, -0.3).
    let to_point = Vector3::new(0.0, 0.2, -0.3);
    let away = |matrix: &Matrix6<f64>| {
        wrench::rotate(
            &wrench::shift(matrix, &to_point),
            &about_x(30f64.to_radians()),
        )
    };
    let other = good(&text("[0.2, -0.3]", "30", &away(&k), &away(&m)));
    let (a, b) = (&plain.stations[0], &other.stations[0]);
    assert!((a.stiffness - b.stiffness).amax() < 1e-13);
    assert!((a.mass - b.mass).amax() < 1e-14);
}

// A line by points, moved half a meter toward the leading edge and 0.2 m up in the
// section axes: without twist along y and z; at 90 degrees nose up, y is up.
#[test]
fn lines_are_given_in_many_ways() {
    let station = &ENGINEERING[ENGINEERING.find("[[station]]").unwrap()..];
    let with = |line: &str| {
        let head = "units = \"SI\"\nframe = \"helicoid\"\nreference_point = \"line\"\n[line]\n";
        good(&format!("{head}{line}\n{station}")).line
    };
    let straight = with("length = 4\ntwist = [10, 2]");
    assert!((straight.at(1.0).twist - 8f64.to_radians()).abs() < 1e-15);
    let offsets = "x = [0, 4]\noffset_forward = [0.5, 0.5]\noffset_up = [0.2, 0.2]";
    let moved = with(&format!("course = \"polyline\"\n{offsets}"));
    assert!((moved.at(1.0).position - Vector3::new(1.0, 0.5, 0.2)).amax() < 1e-15);
    let turned = with(&format!(
        "course = \"polyline\"\ntwist = [90, 90]\n{offsets}"
    ));
    assert!((turned.at(1.0).position - Vector3::new(1.0, -0.2, 0.5)).amax() < 1e-15);
    // Half a circle of radius 2 to the left, and a straight piece.
    let arcs = "twist = 5\n[[line.arc]]\nlength = 6.283185307179586\ncurvature = [0, 0, 0.5]\n\
        [[line.arc]]\nlength = 3\ntwist_rate = 2";
    let bent = with(&arcs.replace("twist = 5\n", ""));
    assert!((bent.at(bent.length()).position - Vector3::new(-3.0, 4.0, 0.0)).amax() < 1e-14);
    assert!((bent.points[2].twist - 6f64.to_radians()).abs() < 1e-15);
    assert!((with(arcs).points[0].twist - 5f64.to_radians()).abs() < 1e-15);
    // The same curvature with units: of a radius, and of an angle as in section files.
    for curvature in [
        "0.5 1/m",
        "0.5 rad/m",
        "28.64788975654116 deg/m",
        "0.0005 rad/mm",
    ] {
        let same = with(&arcs.replace("0.5]", &format!("\"{curvature}\"]")));
        let error = (same.curvature[0] - with(arcs).curvature[0]).amax();
        assert!(error < 1e-15, "{curvature}: {error:e}");
    }
}

// Two property files, of sections with damping of their own.
#[test]
fn stations_are_made_of_property_files() {
    let folder = tempfile::tempdir().unwrap();
    let written = |name: &str, time: f64| {
        let blade = good(ENGINEERING);
        let engineering = section::Engineering {
            stiffness: [7e6, 2e6, 1e6, 30.0, 40.0, 900.0],
            mass: [2.0, 0.01, 0.04],
            centers: section::Centers {
                tension: Vector2::zeros(),
                shear: Vector2::zeros(),
                mass: Vector2::new(0.1, 0.0),
            },
            stiffness_angle: 0.0,
            inertia_angle: 0.0,
        };
        let mut section = engineering.section(name, blade.provenance);
        section.damping = Some(section::Damping::StiffnessProportional(time));
        std::fs::write(folder.path().join(name), section::write(&section)).unwrap();
        section
    };
    let sections = [written("a.json", 0.01), written("b.json", 0.02)];
    let text = "units = \"SI\"\nframe = \"beamdyn\"\nreference_point = \"line\"\n[line]\n\
        length = 10\n[[station]]\neta = 0\nfile = \"a.json\"\n[[station]]\neta = 1\n\
        file = \"b.json\"\nangle = 90\n";
    let file = folder.path().join("c.blade.toml");
    std::fs::write(&file, text).unwrap();
    let blade = read(&file).unwrap().blade;
    assert_eq!(blade.name, "c");
    assert_eq!(blade.stations[0].stiffness, sections[0].stiffness);
    // BeamDyn's angles are nose down, and a quarter turn exchanges the bendings.
    assert!((blade.stations[1].stiffness[(4, 4)] - 900.0).abs() < 1e-10);
    assert!(blade.stations[1].mass[(4, 0)].abs() > 0.19);
    // Property files have an origin: the point need not be declared.
    let open = text.replace("reference_point = \"line\"\n", "");
    std::fs::write(&file, &open).unwrap();
    let reading = read(&file).unwrap_or_else(|p| panic!("{p}"));
    assert_eq!(reading.blade.stations, blade.stations);
    let remark = "reference_point is not declared";
    assert!(
        reading
            .remarks
            .iter()
            .any(|found| found.starts_with(remark))
    );
    std::fs::write(&file, text).unwrap();
    let Some(BladeDamping::Viscous(damping)) = &blade.damping else {
        panic!("{:?}", blade.damping);
    };
    assert!((damping[1] - blade.stations[1].stiffness * 0.02).amax() < 1e-9);
    // One time for all is proportional damping; together with [damping] it is one too
    // many.
    written("b.json", 0.01);
    let damping = read(&file).unwrap().blade.damping;
    assert_eq!(damping, Some(BladeDamping::Proportional(0.01)));
    std::fs::write(&file, format!("{text}[damping]\nproportional = 0.1\n")).unwrap();
    let shown = read(&file).unwrap_err().to_string();
    assert!(shown.contains("has damping of its own"), "{shown}");
}

// Property files state their axes and their point: both keys are then optional. Zero stiffness of
// a broken one names the station's key.
#[test]
fn property_files_need_no_frame() {
    let folder = tempfile::tempdir().unwrap();
    let engineering = section::Engineering {
        stiffness: [7e6, 2e6, 1e6, 30.0, 40.0, 900.0],
        mass: [2.0, 0.01, 0.04],
        centers: section::Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::new(0.1, 0.0),
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let section = engineering.section("a", good(ENGINEERING).provenance);
    std::fs::write(folder.path().join("a.json"), section::write(&section)).unwrap();
    let file = folder.path().join("c.blade.toml");
    let declared = "frame = \"helicoid\"\nreference_point = \"line\"\n";
    let stations = "[line]\nlength = 10\ntwist = [0, 5]\n[[station]]\neta = 0\nfile = \"a.json\"\n\
                    [[station]]\neta = 1\nfile = \"a.json\"\nangle = 30\n";
    let blade = |head: &str, stations: &str| {
        std::fs::write(&file, format!("units = \"SI\"\n{head}{stations}")).unwrap();
        read(&file).map(|reading| (reading.blade.line, reading.blade.stations))
    };
    assert_eq!(
        blade("", stations).unwrap(),
        blade(declared, stations).unwrap()
    );
    let written = stations.replacen("file = \"a.json\"", "ea = 1", 1);
    let shown = blade("", &written).unwrap_err().to_string();
    assert!(shown.contains("declares no \"frame\""), "{shown}");
    assert!(shown.contains("declares no \"reference_point\""), "{shown}");
    std::fs::write(folder.path().join("b.json"), "$MeshFormat\n").unwrap();
    let broken = stations.replacen("a.json", "b.json", 1);
    let shown = blade("", &broken).unwrap_err().to_string();
    let expected = "b.json:1: not a property file: it is not JSON (named by \"file\" of \
                    [[station]] number 1, ";
    assert!(shown.contains(expected), "{shown}");
    assert!(shown.contains("c.blade.toml:7)"), "{shown}");
}

#[test]
fn damping_is_in_the_order_of_the_frame() {
    let (eye, none) = (rows(&Matrix6::identity()), rows(&Matrix6::zeros()));
    let text = written("frame = \"beamdyn\"", "z = [0, 1]", "\"line\"", &eye, &none);
    let blade = good(&format!("{text}[damping]\ntimes = [1, 2, 3, 4, 5, 6]\n"));
    assert_eq!(
        blade.damping,
        Some(BladeDamping::Times([3.0, 2.0, 1.0, 6.0, 5.0, 4.0]))
    );
}

// The example of the page of the blade file, with a file of its tip section.
#[test]
fn the_example_of_the_book_is_a_blade() {
    let page = include_str!("../../../../docs/src/blade-file.md");
    let text = page
        .split("```")
        .find_map(|block| block.strip_prefix("toml\n"));
    let folder = tempfile::tempdir().unwrap();
    let tip = good(ENGINEERING);
    let engineering = section::Engineering {
        stiffness: [7e6, 2e6, 1e6, 30.0, 40.0, 900.0],
        mass: [0.3, 0.01, 0.04],
        centers: section::Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let tip = section::write(&engineering.section("tip", tip.provenance));
    std::fs::write(folder.path().join("tip.properties.json"), tip).unwrap();
    let file = folder.path().join("demo.blade.toml");
    std::fs::write(&file, text.unwrap()).unwrap();
    let Reading { blade, remarks, .. } = read(&file).unwrap_or_else(|p| panic!("{p}"));
    assert_eq!(remarks, Vec::<String>::new());
    let jump = 0.8 * blade.length();
    assert_eq!((blade.stations.len(), blade.jumps()), (4, vec![jump]));
    // Swept aft and bent up at the tip, where the twist is zero.
    let tip = blade.line.at(blade.length());
    assert!(tip.position.y < -0.15 && tip.position.z > 0.02 && tip.twist.abs() < 1e-12);
}
