//! Layers of any width have their area: random layers on a straight wall.

use section_analyzer::mesh::generate::blade::naca;
use section_analyzer::mesh::generate::layup::{Layer, LayupSection, Web, WebPly};

use crate::effort;
use crate::random::Random;

const LENGTH: f64 = 4.0;
const HEIGHT: f64 = 1.0;
const SIZE: f64 = 0.1;

/// A rectangle, 4 m long and 1 m high, from the middle of its rear side over the suction side;
/// corners are given twice.
fn contour() -> Vec<[f64; 2]> {
    let side = |z: f64, from: f64, to: f64| {
        (0..=8).map(move |i| [from + (to - from) * f64::from(i) / 8.0, z])
    };
    let half = 0.5 * HEIGHT;
    let mut points = vec![[0.0, half]];
    points.extend(side(half, 0.0, LENGTH));
    points.extend([[LENGTH, half], [LENGTH, 0.0], [LENGTH, -half]]);
    points.extend(side(-half, LENGTH, 0.0));
    points.push([0.0, -half]);
    points
}

fn skin() -> Layer {
    Layer {
        name: "skin".into(),
        thickness: 0.004,
        from: 0.0,
        to: 1.0,
        taper: None,
        profile: Vec::new(),
    }
}

/// Layers of 0.01 to 5 cells width on the middle 2.4 m of the suction side, with drops from
/// 1e-5 cells to one cell or without a given one, and a web in every other section, whose feet
/// they reach under or end at.
fn section(random: &mut Random, has_web: bool) -> LayupSection {
    let perimeter = 2.0 * (LENGTH + HEIGHT);
    // the side begins behind half of the base
    let arc = |y: f64| (0.5 * HEIGHT + y) / perimeter;
    let mut layers = vec![skin()];
    let mut before: Option<f64> = None;
    for number in 0..6 {
        let width = SIZE * 10.0_f64.powf(random.range(-2.0, 0.7));
        let start = match before {
            // abuts the one before
            Some(end) if random.unit() < 0.3 && end + width < 3.2 => end,
            _ => random.range(0.8, 3.2 - width),
        };
        let taper = SIZE * 10.0_f64.powf(random.range(-5.0, 0.0));
        layers.push(Layer {
            name: format!("layer{number}"),
            thickness: 10.0_f64.powf(random.range(-3.0, -1.7)),
            from: arc(start),
            to: arc(start + width),
            taper: Some(taper).filter(|_| random.unit() < 0.6),
            profile: Vec::new(),
        });
        before = Some(start + width);
    }
    let at = random.range(1.0, 3.0);
    let ply = |name: &str, thickness: f64| WebPly {
        name: name.into(),
        thickness,
    };
    let web = Web {
        name: "web".into(),
        arcs: [arc(at), 1.0 - arc(at)],
        plies: vec![ply("fore", 0.002), ply("core", 0.05), ply("aft", 0.002)],
    };
    LayupSection {
        contour: contour(),
        layers,
        webs: Some(web).filter(|_| has_web).into_iter().collect(),
        spar: None,
        fills: Vec::new(),
        size: Some(SIZE),
    }
}

/// The area of the cells of 300 layers is their width times their thickness within 0.5 %: a
/// layer is not lost or widened by cells that are longer than it or than its drops.
#[test]
fn layers_of_any_width_have_their_area() {
    let perimeter = 2.0 * (LENGTH + HEIGHT);
    let mut worst: f64 = 0.0;
    for seed in 0..effort::cases(50) as u64 {
        let section = section(&mut Random::new(seed), seed % 2 == 0);
        let meshed = section.generate();
        let meshed = meshed.unwrap_or_else(|problem| panic!("{seed}: {problem}"));
        for (layer, area) in section.layers.iter().zip(&meshed.areas).skip(1) {
            let width = (layer.to - layer.from) * perimeter;
            let exact = width * layer.thickness;
            let errors = [area.meshed, area.nominal].map(|found| found / exact - 1.0);
            let error = errors.map(f64::abs).into_iter().fold(0.0, f64::max);
            let of_cell = width / SIZE;
            assert!(
                error < 5e-3,
                "{seed}: {layer:?}, {of_cell} cells: {errors:?}"
            );
            worst = worst.max(error);
        }
    }
    println!("largest error of an area {worst:.1e}");
}

/// An airfoil of 1 m chord with six layers of 0.013 to 3 cells width anywhere between edge and edge,
/// and a web.
fn on_airfoil(seed: u64) -> LayupSection {
    let random = &mut Random::new(900 + seed);
    let digits = ["0012", "4415", "2421"][seed as usize % 3];
    let points = naca(digits, seed.is_multiple_of(2)).expect("an airfoil");
    let mut layers = vec![skin()];
    for number in 0..6 {
        let width = 10.0_f64.powf(random.range(-1.9, 0.5)) / 120.0;
        let start = random.range(0.02, 0.98 - width);
        layers.push(Layer {
            name: format!("layer{number}"),
            thickness: 10.0_f64.powf(random.range(-3.3, -2.3)),
            from: start,
            to: start + width,
            taper: None,
            profile: Vec::new(),
        });
    }
    let arc = random.range(0.2, 0.4);
    let ply = WebPly {
        name: "ply".into(),
        thickness: 0.01,
    };
    LayupSection {
        contour: points.iter().map(|[x, z]| [0.3 - x, *z]).collect(),
        layers,
        webs: vec![Web {
            name: "web".into(),
            arcs: [arc, 1.0 - arc],
            plies: vec![ply],
        }],
        spar: None,
        fills: Vec::new(),
        size: None,
    }
}

/// All are meshed, and layers away from the edge, where the layers of both sides meet and the
/// innermost one fills the rest, have their area on the curved surface within 1 %, or 3 % at the nose,
/// whose radius is a few thicknesses, and under the web: columns of a web that is not normal to the
/// surface cross in a steep drop.
#[test]
fn narrow_layers_on_airfoils_have_their_area() {
    let (mut worst, mut compared) = (0.0_f64, 0);
    let count = effort::cases(40);
    for seed in 0..count as u64 {
        let section = on_airfoil(seed);
        let meshed = section.generate();
        let meshed = meshed.unwrap_or_else(|problem| panic!("{seed}: {problem}"));
        let feet = section.webs[0].arcs;
        for (layer, area) in section.layers.iter().zip(&meshed.areas).skip(1) {
            if layer.from < 0.12 || layer.to > 0.88 {
                continue;
            }
            compared += 1;
            let error = (area.meshed / area.nominal - 1.0).abs();
            let mut feet = feet.iter();
            let is_under = feet.any(|foot| layer.from < foot + 0.005 && layer.to > foot - 0.005);
            let is_at_nose = layer.from < 0.53 && layer.to > 0.47;
            let limit = if is_under || is_at_nose { 0.03 } else { 0.01 };
            assert!(error < limit, "{seed}: {layer:?}: {area:?}");
            worst = worst.max(error);
        }
    }
    println!("largest error of {compared} areas {worst:.1e}");
    assert!(compared > 3 * count);
}
