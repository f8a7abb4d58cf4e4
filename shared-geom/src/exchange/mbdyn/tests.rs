//! The model for MBDyn: its bodies, laws and text.
#![allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]

use nalgebra::{Matrix3, Vector2};

use super::*;
use crate::blade::{BladeDamping, Interpolation, Station};
use crate::exchange::samples::{blade, mass, stiffness};
use crate::exchange::{Format, Options, read_with};
use crate::line::ReferenceLine;
use crate::wrench;

/// A uniform straight blade of length 3 m, of rigid slices of 2 kg/m off the line.
fn uniform() -> Blade {
    let station = |arc_length| Station {
        arc_length,
        stiffness: stiffness(1.0),
        mass: mass(2.0),
    };
    Blade {
        line: ReferenceLine::straight(3.0),
        stations: vec![station(0.0), station(1.0), station(3.0)],
        interpolation: Interpolation::Linear,
        reference_point: Vector2::zeros(),
        damping: None,
        ..blade()
    }
}

fn of(blade: &Blade) -> Model {
    model(blade, &blade.line.curve())
}

// A body between the evaluation points of an element of length h has h/sqrt(3) of the
// mass, the slices at its ends the rest. A rod of mass m and length l has m l^2/12 about
// axes across it, and the moments of its slices in addition: closed form.
#[test]
fn bodies_are_rods_of_slices() {
    let model = of(&uniform());
    assert_eq!((model.nodes.len(), model.elements.len()), (5, 2));
    let third = 1.0 / 3.0_f64.sqrt();
    let lengths = [
        0.5 * (1.0 - third),
        third,
        0.5 * (1.0 - third) + (1.0 - third),
        2.0 * third,
        1.0 - third,
    ];
    let slice = mass(1.0);
    let center = Vector2::new(-slice[(0, 5)], slice[(0, 4)]);
    for (body, length) in model.bodies.iter().zip(lengths) {
        assert!((body.mass - 2.0 * length).abs() < 1e-14);
        assert!((body.center.y - center.x).abs() < 1e-14);
        assert!((body.center.z - center.y).abs() < 1e-14);
        let own = wrench::shift(&slice, &Vector3::new(0.0, center.x, center.y));
        let rod = Matrix3::from_diagonal(&Vector3::new(0.0, 1.0, 1.0)) * length * length / 12.0;
        let inertia = (own.fixed_view::<3, 3>(3, 3) + rod) * body.mass;
        assert!(
            (body.inertia - inertia).amax() < 1e-13,
            "{:e}",
            body.inertia - inertia
        );
        assert!(body.beyond < 1e-14);
    }
    // the middle one lies at its node, the first after it
    assert!(model.bodies[1].center.x.abs() < 1e-15);
    assert!((model.bodies[0].center.x - 0.5 * lengths[0]).abs() < 1e-15);
}

// Mass, static moment and moments of inertia of the whole blade about the root agree with
// its slices, summed by a finer rule.
#[test]
fn the_bodies_together_have_the_inertia_of_a_full_blade() {
    let blade = blade();
    let model = of(&blade);
    let about_root = |at: &Placed, matrix: &Matrix6<f64>| {
        let turned = wrench::rotate(matrix, &at.axes.transpose());
        wrench::shift(&turned, &-at.position)
    };
    let mut bodies = Matrix6::zeros();
    for body in &model.bodies {
        let mut own = Matrix6::zeros();
        own.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(body.mass);
        own.fixed_view_mut::<3, 3>(3, 3).copy_from(&body.inertia);
        let about_node = wrench::shift(&own, &-body.center);
        bodies += about_root(&model.nodes[body.node], &about_node);
    }
    let curve = blade.line.curve();
    let mut slices = Matrix6::zeros();
    for two in model
        .elements
        .iter()
        .map(|element| [element.from, element.to])
    {
        let pieces = 40;
        let half = 0.5 * (two[1] - two[0]) / f64::from(pieces);
        for i in 0..pieces {
            for xi in [-EVALUATION, EVALUATION] {
                let s = two[0] + half * (2.0 * f64::from(i) + 1.0 + xi);
                let matrix = blade.at(s, Side::Outer).1 * half;
                slices += about_root(&curve.at(s), &matrix);
            }
        }
    }
    assert!((bodies[(0, 0)] / blade.mass() - 1.0).abs() < 1e-14);
    // The splined line: both rules are off by some 1e-8 of the moments.
    let off = (bodies - slices).amax() / slices.amax();
    assert!(off < 1e-7, "{off:e}");
}

// The laws agree with the blade at -+1/sqrt 3 of each element, in the axes there.
#[test]
fn laws_are_at_the_evaluation_points() {
    let blade = blade();
    let model = of(&blade);
    assert_eq!(model.elements.len(), 4);
    let curve = blade.line.curve();
    for element in &model.elements {
        for (section, xi) in element.sections.iter().zip([-1.0, 1.0]) {
            let half = 0.5 * (element.to - element.from);
            let s = element.from + half * (1.0 + xi / 3.0_f64.sqrt());
            assert!((section.stiffness - blade.at(s, Side::Outer).0).amax() < 1e-6);
            assert!((section.placed.axes - curve.at(s).axes).amax() < 1e-13);
        }
    }
}

/// The statements of a text: without comments, up to their semicolons.
fn statements(text: &str) -> Vec<String> {
    let code: Vec<_> = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or(""))
        .collect();
    let code = code.join(" ");
    let words = |part: &str| part.split_whitespace().collect::<Vec<_>>().join(" ");
    code.split(';')
        .map(words)
        .filter(|part| !part.is_empty())
        .collect()
}

// The grammar of the manual: blocks open and close; the counts of the control data are
// the numbers of cards; each card has the number of arguments that its form takes.
#[test]
fn the_text_has_the_form_of_the_input_language() {
    let sample = blade();
    let writing = write(&sample, "a");
    assert_eq!(writing.files[0].0, PathBuf::from("a.mbd"));
    let statements = statements(&writing.files[0].1);
    let mut open = Vec::new();
    for statement in &statements {
        if let Some(name) = statement.strip_prefix("begin: ") {
            open.push(name.to_owned());
        } else if let Some(name) = statement.strip_prefix("end: ") {
            assert_eq!(open.pop().as_deref(), Some(name));
        }
    }
    assert!(open.is_empty());
    let cards = |kind: &str| -> Vec<&String> {
        statements
            .iter()
            .filter(|statement| statement.starts_with(kind))
            .collect()
    };
    let (nodes, bodies, beams) = (cards("structural: "), cards("body: "), cards("beam3: "));
    for (name, count) in [
        ("structural nodes", nodes.len()),
        ("rigid bodies", bodies.len()),
        ("beams", beams.len()),
        ("joints", 1),
    ] {
        assert!(statements.contains(&format!("{name}: {count}")), "{name}");
    }
    let arguments = |card: &str| card.split(',').count();
    // label, dynamic, 3, matr, 9, null, null
    assert!(nodes.iter().all(|card| arguments(card) == 17));
    // label, node, mass, 3, sym, 6
    assert!(bodies.iter().all(|card| arguments(card) == 13));
    // label, 3 x (node, null), 2 x (reference, global, matr, 9, law, sym, 21, proportional, 1)
    assert!(
        beams.iter().all(|card| arguments(card) == 7 + 2 * 37),
        "{}",
        arguments(beams[0])
    );
    assert_eq!(
        beams[0].matches("linear viscoelastic generic, sym").count(),
        2
    );
    assert_eq!(beams[0].matches("proportional, ").count(), 2);
}

#[test]
fn laws_follow_the_damping() {
    let mut sample = blade();
    sample.damping = None;
    let text = &write(&sample, "a").files[0].1;
    assert!(text.contains("linear elastic generic") && !text.contains("viscoelastic"));
    sample.damping = Some(BladeDamping::Times([1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3]));
    let text = &write(&sample, "a").files[0].1;
    let beams = statements(text);
    let beam = beams
        .iter()
        .find(|card| card.starts_with("beam3: "))
        .unwrap();
    // matr and 36 instead of proportional and 1
    assert_eq!(beam.split(',').count(), 7 + 2 * (37 + 35));
}

#[test]
fn what_is_lost_is_reported_with_its_size() {
    let lost = write(&uniform(), "a").lost;
    assert_eq!(lost.len(), 1, "{lost:?}");
    // 2 h/sqrt 3 with h = 1 of 3 m is 38.5 %
    let expected = "5 bodies at the nodes of 2 elements, the heaviest of 38.5 % of the blade";
    assert!(lost[0].contains(expected), "{lost:?}");
    let lost = write(&blade(), "a").lost.join("\n");
    for words in [
        "consistent inertia",
        "interpolation between stations",
        "parabolas",
    ] {
        assert!(lost.contains(words), "{words}: {lost}");
    }
    let mut odd = uniform();
    for station in &mut odd.stations {
        station.mass[(0, 0)] *= 1.03;
    }
    let lost = write(&odd, "a").lost;
    assert!(
        lost[1].contains("that no rigid body has: up to 1.9e-2"),
        "{lost:?}"
    );
}

#[test]
fn a_model_is_recognized_and_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.mbd");
    std::fs::write(&file, &write(&blade(), "a").files[0].1).unwrap();
    let refused = read_with(&file, &Options::default())
        .unwrap_err()
        .to_string();
    assert!(
        refused.contains("this format is written, but cannot be read"),
        "{refused}"
    );
    assert!(Format::MbDyn.is_written() && !Format::MbDyn.is_read());
}

#[test]
fn the_head_states_frame_order_and_point() {
    let text = &write(&blade(), "a").files[0].1;
    for words in [
        "# written by Helicoid ",
        "# input: sha256:0123",
        "# frame: helicoid (x along the blade",
        "# order: axial, shear y, shear z, torsion, bending y, bending z",
        "# reference point: the reference line",
    ] {
        assert!(text.contains(words), "{words}");
    }
}
