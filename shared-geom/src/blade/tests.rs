use nalgebra::{Matrix6, Vector2, Vector3};

use super::*;
use crate::line::{Course, LinePoint, about_x};
use crate::rotation::samples::Samples;
use crate::wrench;

/// A stiffness with all couplings, and eigenvalues between 1 and some 40.
fn stiffness(samples: &mut Samples) -> Matrix6<f64> {
    let a = Matrix6::from_fn(|_, _| 2.0 * samples.scalar());
    a * a.transpose() + Matrix6::identity()
}

/// The mass of `m` at (y, z) with own moments of inertia.
fn mass(m: f64, y: f64, z: f64, iy: f64, iz: f64) -> Matrix6<f64> {
    let own = Matrix6::from_diagonal(&[m, m, m, iy + iz, iy, iz].into());
    wrench::shift(&own, &-Vector3::new(0.0, y, z))
}

fn station(arc_length: f64, m: f64, samples: &mut Samples) -> Station {
    Station {
        arc_length,
        stiffness: stiffness(samples),
        mass: mass(m, 0.2, -0.1, 0.3, 0.7),
    }
}

fn provenance() -> Provenance {
    Provenance {
        program: "test".to_owned(),
        version: "1".to_owned(),
        input_hash: String::new(),
        nodes: 0,
        cells: 0,
        history: Vec::new(),
        sections: Vec::new(),
    }
}

/// A twisted and bent blade with a jump.
pub fn blade() -> Blade {
    let mut samples = Samples::new(7);
    let point = |x: f64, y, z, twist| LinePoint {
        position: Vector3::new(x, y, z),
        twist,
    };
    let points = vec![
        point(0.0, 0.0, 0.0, 0.3),
        point(4.0, 0.2, -0.1, 0.2),
        point(10.0, -0.5, -1.0, -0.1),
    ];
    let stations = [(0.0, 8.0), (3.0, 6.0), (3.0, 4.0), (7.0, 2.0), (10.0, 1.0)];
    Blade {
        name: "sample".to_owned(),
        line: ReferenceLine::through(points, Course::Spline),
        reference_point: Vector2::zeros(),
        stations: stations.map(|(s, m)| station(s, m, &mut samples)).to_vec(),
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: provenance(),
    }
}

const POSITIONS: [f64; 6] = [0.0, 1.7, 3.0, 4.4, 9.9, 10.1];

// Trapezoids: 3 (8 + 6)/2 + 4 (4 + 2)/2 + 3 (2 + 1)/2, and 1 kg/m from 10 m to the end.
// Constant: 3 x 8 + 4 x 4 + 3 x 2 (the jump omitted), and the last to the end.
#[test]
fn mass_is_the_exact_integral() {
    let mut blade = blade();
    let rest = blade.length() - 10.0;
    assert!(rest > 0.1);
    assert!((blade.mass() - (37.5 + rest)).abs() < 1e-12);
    blade.stations.remove(1);
    blade.interpolation = Interpolation::Constant;
    assert!((blade.mass() - (46.0 + rest)).abs() < 1e-12);
    assert_eq!(blade.jumps(), [3.0, 7.0, 10.0]);
}

#[test]
fn properties_lie_between_their_stations_and_jump_where_two_are() {
    let mut blade = blade();
    let at = |blade: &Blade, s, side| blade.at(s, side).0;
    let k = blade.stations.clone().into_iter().map(|s| s.stiffness);
    let k: Vec<_> = k.collect();
    assert_eq!(
        (blade.jumps(), blade.positions()),
        (vec![3.0], vec![0.0, 3.0, 7.0, 10.0])
    );
    assert_eq!(at(&blade, 3.0, Side::Inner), k[1]);
    assert_eq!(at(&blade, 3.0, Side::Outer), k[2]);
    assert_eq!(at(&blade, 0.0, Side::Inner), k[0]);
    assert_eq!(at(&blade, 10.1, Side::Outer), k[4]);
    // A quarter of the interval; entries up to 40, a few roundings.
    let quarter = k[2] * 0.75 + k[3] * 0.25;
    assert!((at(&blade, 4.0, Side::Outer) - quarter).amax() < 1e-13);

    blade.interpolation = Interpolation::Constant;
    assert_eq!(at(&blade, 6.99, Side::Outer), k[2]);
    assert_eq!(at(&blade, 7.0, Side::Inner), k[2]);
    assert_eq!(at(&blade, 7.0, Side::Outer), k[3]);
}

// The matrices seen by a beam do not depend on the point about which the stations are
// given, at any arc length.
#[test]
fn a_moved_reference_point_changes_nothing_about_the_line() {
    let mut blade = blade();
    blade.damping = Some(BladeDamping::Times([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]));
    let moved = blade
        .shift(Vector2::new(0.4, -0.2))
        .shift(Vector2::new(-0.1, 0.5));
    assert!((moved.reference_point - Vector2::new(0.3, 0.3)).amax() < 1e-15);
    assert!((moved.stations[0].stiffness - blade.stations[0].stiffness).amax() > 1.0);
    for other in [&moved, &moved.on_line()] {
        for s in POSITIONS {
            for side in [Side::Inner, Side::Outer] {
                let (a, b) = (blade.at(s, side), other.at(s, side));
                // Intermediate entries up to 100; a few roundings.
                assert!((a.0 - b.0).amax() < 1e-12 && (a.1 - b.1).amax() < 1e-12);
                let damping = [&blade, other].map(|blade| blade.damping_at(s, side).unwrap());
                assert!((damping[0] - damping[1]).amax() < 1e-12);
            }
        }
    }
    assert_eq!(moved.on_line().reference_point, Vector2::zeros());
}

// The same in space: matrices in root axes do not depend on the section axes.
#[test]
fn turned_sections_are_the_same_in_space() {
    let mut blade = blade();
    blade.reference_point = Vector2::new(0.3, -0.1);
    blade.damping = Some(BladeDamping::Viscous(
        blade.stations.iter().map(|s| s.stiffness * 0.01).collect(),
    ));
    let turned = blade.rotate(0.8);
    for s in POSITIONS {
        let in_space = |blade: &Blade| {
            let axes = blade.line.at(s).axes.transpose();
            let (k, m) = blade.at(s, Side::Outer);
            let d = blade.damping_at(s, Side::Outer).unwrap();
            [k, m, d].map(|matrix| wrench::rotate(&matrix, &axes))
        };
        for (a, b) in in_space(&blade).iter().zip(in_space(&turned)) {
            assert!((a - b).amax() < 1e-12, "{s}");
        }
    }
    // The twist is larger, and the axes are turned with it.
    let (before, after) = (blade.line.at(4.0), turned.line.at(4.0));
    assert!((after.twist - before.twist - 0.8).abs() < 1e-14);
    assert!((before.axes * about_x(0.8) - after.axes).amax() < 1e-14);
    assert!((blade.mass() - turned.mass()).abs() < 1e-12);
}

#[test]
fn damping_is_as_its_kind_says() {
    let mut blade = blade();
    assert_eq!(blade.damping_at(1.0, Side::Inner), None);
    let k = blade.at(1.0, Side::Inner).0;
    blade.damping = Some(BladeDamping::Proportional(0.5));
    // One rounding of entries up to 40.
    assert!((blade.damping_at(1.0, Side::Inner).unwrap() - k * 0.5).amax() < 1e-14);
    blade.damping = Some(BladeDamping::Times([0.0, 0.0, 0.0, 2.0, 0.0, 0.0]));
    let twisting = blade.damping_at(1.0, Side::Inner).unwrap();
    assert!((twisting.row(3) - k.row(3) * 2.0).amax() < 1e-14);
    assert_eq!((twisting.row(0).amax(), twisting.row(5).amax()), (0.0, 0.0));
}

// Every bit is recovered, for all kinds of lines and damping.
#[test]
fn a_file_keeps_every_digit() {
    let mut blades = vec![blade()];
    let mut turned = blade().rotate(0.1).shift(Vector2::new(1.0 / 3.0, 0.1));
    turned.damping = Some(BladeDamping::Times([0.1, 1.0 / 7.0, 0.3, 0.4, 1e-300, 0.0]));
    blades.push(turned.clone());
    blades.push(turned.shift(Vector2::new(0.1, 0.0)));
    let root = LinePoint {
        position: Vector3::new(0.1, 0.2, 0.3),
        twist: 1.0 / 3.0,
    };
    let arcs = [
        (5.1, Vector3::new(0.1, 0.2, -1.0 / 3.0)),
        (5.0, Vector3::zeros()),
    ];
    let mut curved = blade();
    curved.line = ReferenceLine::curved(root, &arcs);
    curved.interpolation = Interpolation::Constant;
    curved.stations.remove(1);
    curved.damping = Some(BladeDamping::Proportional(0.003));
    blades.push(curved);
    for blade in blades {
        let text = write(&blade);
        let read = parse(&text, "a.blade.json").unwrap_or_else(|problems| panic!("{problems}"));
        assert_eq!(read.blade, blade);
        assert_eq!(write(&read.blade), text);
    }
}

fn shown(text: &str) -> String {
    match parse(text, "a.blade.json") {
        Ok(_) => String::new(),
        Err(problems) => problems.to_string(),
    }
}

#[test]
fn what_is_wrong_with_a_file_is_reported_with_its_line() {
    let text = write(&blade());
    let cases = [
        (
            text.replace("\"version\": 1", "\"version\": 2"),
            "a.blade.json:3: written in version 2 of the blade-file format, expected at most 1",
        ),
        (
            text.replace("\"units\": \"SI\"", "\"units\": \"ft\""),
            "a.blade.json:5: units are \"ft\", expected \"SI\"",
        ),
        (
            text.replace("helicoid blade", "helicoid section properties"),
            "a.blade.json:2: not a blade file: \"format\" is \"helicoid section properties\"",
        ),
        (
            text.replace("\"course\": \"spline\"", "\"course\": \"spiral\""),
            "a.blade.json:9: not a blade file: unknown variant `spiral`",
        ),
        (
            text.replace("\"interpolation\"", "\"interpolate\""),
            "not a blade file: unknown field `interpolate`",
        ),
        (
            text.replace("\"twist\": [0.3, ", "\"twist\": ["),
            "a.blade.json:8: not a blade file: \"line\" needs one entry of \"twist\" per point",
        ),
        (
            text[..text.len() / 2].to_owned(),
            "not a blade file: the file ends early",
        ),
    ];
    for (text, expected) in cases {
        let shown = shown(&text);
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
    let mut other = blade();
    other.stations[3].arc_length = 2.0;
    let text = write(&other);
    let line = 1 + text
        .lines()
        .position(|line| line.contains("\"arc_length\": 2.0"))
        .unwrap();
    let shown = shown(&text);
    let expected =
        format!("a.blade.json:{line}: station 4 lies at 2 m, and the station before at 3 m");
    assert!(shown.contains(&expected), "{expected} is not in\n{shown}");
}

fn problems(change: impl FnOnce(&mut Blade)) -> String {
    let mut blade = blade();
    change(&mut blade);
    let shown: Vec<_> = blade.problems().iter().map(ToString::to_string).collect();
    shown.join("\n")
}

#[test]
fn what_cannot_be_a_blade_is_reported() {
    assert_eq!(problems(|_| {}), "");
    let cases = [
        (problems(|b| b.stations.clear()), "the blade has no station"),
        (
            problems(|b| b.stations[4].arc_length = 12.0),
            "station 5 lies at 12 m, and the line is",
        ),
        (
            problems(|b| b.stations[3].arc_length = 3.0),
            "station 4 is the third at 3 m",
        ),
        (
            problems(|b| b.interpolation = Interpolation::Constant),
            "station 3 lies at 3 m as the one before, and with constant",
        ),
        (
            problems(|b| b.stations[1].mass[(0, 0)] = -2.0),
            "station 2 at 3 m: mass is not positive semidefinite",
        ),
        (
            problems(|b| b.stations[1].stiffness[(2, 3)] += 1.0),
            "station 2 at 3 m: stiffness is not symmetric",
        ),
        (
            problems(|b| b.reference_point.x = f64::NAN),
            "reference_point holds a number",
        ),
        (
            problems(|b| b.damping = Some(BladeDamping::Proportional(-1.0))),
            "damping is -1 s, expected zero or more",
        ),
        (
            problems(|b| b.damping = Some(BladeDamping::Viscous(vec![Matrix6::zeros()]))),
            "damping has 1 matrices, expected one for each of the 5 stations",
        ),
        (
            problems(|b| b.line.points.truncate(1)),
            "the line has 1 points",
        ),
    ];
    for (shown, expected) in cases {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
}

// K45 of 1.5 with a unit diagonal at the station at 7 m, zero at its neighbors: with the
// part v of the neighbor, 1.5 (1 - v) > 1 up to v = 1/3.
#[test]
fn a_stiffness_that_is_not_positive_definite_is_reported_with_its_reach() {
    let change = |blade: &mut Blade| {
        for station in &mut blade.stations {
            station.stiffness = Matrix6::identity();
        }
        let k = &mut blade.stations[3].stiffness;
        (k[(3, 4)], k[(4, 3)]) = (1.5, 1.5);
    };
    let shown = problems(change);
    let from = 7.0 - 4.0 / 3.0;
    let expected = format!("stiffness is not positive definite from {:.4}", from);
    assert!(
        shown.starts_with(&expected[..expected.len() - 1]),
        "{shown}"
    );
    assert!(
        shown.contains("m to 8.0000") || shown.contains("m to 7.9999"),
        "{shown}"
    );
    assert!(shown.contains("about station 4 at 7 m: there its smallest scaled eigenvalue is -5.0"));

    // The same at evaluation points: not at 5.6 m, at 5.7 m, at 7.9 m, not at 8.1 m.
    let mut blade = blade();
    change(&mut blade);
    let found = blade.problems_at(&[5.6, 5.7, 7.9, 8.1]);
    let positions: Vec<_> = found
        .iter()
        .filter_map(|problem| match problem {
            BladeProblem::Indefinite {
                position,
                inner,
                outer,
                ..
            } => Some((*position, *inner, *outer)),
            _ => None,
        })
        .collect();
    assert_eq!(positions, [(5.7, 3.0, 7.0), (7.9, 7.0, 10.0)]);
}

/// An aluminum strip of 80 x 10 mm: E = 70 GPa, 2700 kg/m^3.
fn strip() -> Blade {
    let (b, t) = (0.08, 0.01);
    let (area, flap, lag) = (b * t, b * t * t * t / 12.0, t * b * b * b / 12.0);
    let (e, g, rho) = (70e9, 26e9, 2700.0);
    let of = |s: f64| Station {
        arc_length: s,
        stiffness: Matrix6::from_diagonal(
            &[
                e * area,
                g * area,
                g * area,
                4.0 * g * flap,
                e * flap,
                e * lag,
            ]
            .into(),
        ),
        mass: mass(rho * area, 0.0, 0.0, rho * flap, rho * lag),
    };
    Blade {
        line: ReferenceLine::straight(2.0),
        stations: vec![of(0.0), of(2.0)],
        ..blade()
    }
}

// The density of the message is the strip's density times the factor: c^2 = E / rho.
#[test]
fn a_weight_instead_of_a_mass_is_remarked() {
    assert_eq!(strip().remarks(), Vec::<String>::new());
    for (factor, weight) in [(9.80665, "(N/m)"), (32.174, "(lbf/ft"), (386.09, "(lbf/in")] {
        let mut heavy = strip();
        for station in &mut heavy.stations {
            station.mass *= factor;
        }
        let remarks = heavy.remarks();
        let density = format!("would weigh {:.0} kg/m^3", 2700.0 * factor);
        let is_reported = |words: &str| remarks.iter().any(|remark| remark.contains(words));
        assert!(is_reported(&density) && is_reported("looks like a weight") && is_reported(weight));
    }
    // A factor of a thousand squared is no weight.
    let mut other = strip();
    for station in &mut other.stations {
        station.mass *= 1e6;
    }
    assert!(other.remarks()[0].contains("units of length, force and mass do not fit each other"));
    let mut light = strip();
    for station in &mut light.stations {
        station.mass /= 386.09;
    }
    assert!(light.remarks()[0].contains("lighter than any material: check the units"));
}

// Solid ellipses, a bound of airfoils, of a propeller of nylon (3 GPa, 1150 kg/m^3, 1.6 km/s) and
// of polyethylene (0.9 GPa, 950 kg/m^3): no weights. The same speeds in a chord of 3 m, which is
// hollow, and solid glass, aluminum and nylon with their weight as mass are remarked. Areas: pi a b, radii of gyration a/2 and b/2.
#[test]
fn solid_plastic_is_no_weight() {
    let remark = |[young, density]: [f64; 2], [a, b]: [f64; 2], filled: f64, offset: f64| {
        let area = filled * std::f64::consts::PI * a * b;
        let (flap, lag) = (area * b * b / 4.0, area * (a * a / 4.0 + offset * offset));
        let mut stiffness = Matrix6::from_diagonal(
            &[1.0, 0.3, 0.3, 0.1 * flap / area, flap / area, lag / area].into(),
        );
        stiffness[(0, 5)] = -offset;
        stiffness[(5, 0)] = -offset;
        let mass = mass(1.0, 0.0, 0.0, flap / area, lag / area);
        section_remark(&(young * area * stiffness), &(density * area * mass))
    };
    let (small, large) = ([0.0125, 0.0015], [1.5, 0.3]);
    for material in [[3e9, 1150.0], [0.9e9, 950.0], [3.5e9, 1240.0]] {
        for offset in [0.0, 0.006] {
            assert_eq!(remark(material, small, 1.0, offset), None);
            assert_eq!(remark(material, small, 0.8, offset), None);
        }
        assert!(remark(material, large, 1.0, 0.0).is_some());
    }
    assert!(remark([40e9, 9.80665 * 1950.0], small, 1.0, 0.0).is_some());
    assert!(remark([70e9, 9.80665 * 2700.0], small, 1.0, 0.0).is_some());
    assert!(remark([3e9, 9.80665 * 1150.0], small, 1.0, 0.0).is_some());
}

// Numbers that were written for the model may be soft: they are reported without a guess;
// values that no material has are reported as before.
#[test]
fn a_soft_inline_section_is_reported_in_a_line() {
    let (stiffness, mass) = {
        let strip = strip();
        (strip.stations[0].stiffness, strip.stations[0].mass)
    };
    assert_eq!(written_section_remark(&stiffness, &mass), None);
    let soft = written_section_remark(&stiffness, &(1e5 * mass)).unwrap();
    // 70 GPa by 2.7e8 kg/m^3.
    assert!(
        soft.starts_with("stiffness over mass is 2.593e2 m^2/s^2"),
        "{soft}"
    );
    assert!(
        soft.ends_with("ignore this if the model is meant to be soft"),
        "{soft}"
    );
    assert!(!soft.contains("weigh"), "{soft}");
    let reported = section_remark(&stiffness, &(1e5 * mass)).unwrap();
    assert!(reported.contains("do not fit each other"), "{reported}");
    let rigid = written_section_remark(&stiffness, &(1e-3 * mass)).unwrap();
    assert!(
        rigid.starts_with(
            "stiffness over mass is 2.593e10 m^2/s^2 (the smaller of EA / m and EI / I)"
        ),
        "{rigid}"
    );
    assert!(
        rigid.ends_with("for blades below 4.0e8: ignore this if the model is meant to be rigid"),
        "{rigid}"
    );
    let light = section_remark(&stiffness, &(1e-3 * mass)).unwrap();
    assert!(
        light.contains("would weigh 2.70 kg/m^3, lighter than any material"),
        "{light}"
    );
    // A bar of points has hardly any rotary inertia: its mass alone counts.
    let mut points = mass;
    points.fixed_view_mut::<3, 3>(3, 3).scale_mut(1e-6);
    assert_eq!(written_section_remark(&stiffness, &points), None);
    assert_eq!(section_remark(&stiffness, &points), None);
}

#[test]
fn other_oddities_are_remarked() {
    let remarks = |change: fn(&mut Blade)| {
        let mut strip = strip();
        change(&mut strip);
        strip.remarks().join("\n")
    };
    let cases = [
        (
            remarks(|b| b.line = ReferenceLine::straight(2.1)),
            "stations from 0 m to 2 m on a line of 2.1 m",
        ),
        (
            remarks(|b| b.stations[1].mass[(3, 3)] *= 1.1),
            "is not the sum of the two others at 1 of 2 stations, most at 2 m",
        ),
        (
            remarks(|b| *b = b.rotate(std::f64::consts::FRAC_PI_2)),
            "is 64.000 times as stiff as about z",
        ),
    ];
    for (shown, expected) in cases {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
}

// The strip is 2 m long: a table that ends at 1.7 m has 85 % of it.
#[test]
fn a_table_that_ends_before_the_line_is_remarked() {
    let mut short = strip();
    short.stations[1].arc_length = 1.7;
    let remarks = short.remarks();
    assert_eq!(remarks.len(), 1, "{remarks:?}");
    let expected = "WARNING: the last of 2 stations lies at 1.7 m, the line is 2 m long: is the \
        table of stations cut short? The last 15.0 % of the blade";
    assert!(remarks[0].starts_with(expected), "{remarks:?}");
}
