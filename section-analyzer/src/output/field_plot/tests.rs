//! Figures of fields: their texts, units, colors and positions.

use nalgebra::Vector6;
use shared_geom::figure::Color;
use shared_geom::mesh::CellKind;

use super::*;
use crate::input::InputSummary;
use crate::mesh::generate::Tube;
use crate::mesh::quality::MeshQuality;
use crate::output::samples::{bending, recovery, rectangle, section};
use crate::output::stress_plots;
use crate::properties::AreaTable;
use crate::recovery::Recovery;

/// The summary of a section declared in millimeters.
fn summary(section: &Section) -> InputSummary {
    InputSummary {
        file: "a.section.toml".into(),
        mesh_file: "a.msh".into(),
        input_hash: String::new(),
        length_unit: "mm".into(),
        length_factor: 1e-3,
        kinds: Vec::new(),
        regions: Vec::new(),
        areas: AreaTable::by_group(section),
        electrodes: Vec::new(),
        quality: MeshQuality::default(),
        warnings: Vec::new(),
    }
}

/// The texts in the figures of a load case.
fn drawn(
    section: &Section,
    recovery: &Recovery,
    failure: &[(String, Vec<f64>)],
) -> Vec<(&'static str, String)> {
    let plots = stress_plots(section, &summary(section), recovery, failure);
    let drawn = plots.into_iter().map(|(word, plot)| {
        let texts: Vec<_> = plot.drawing().texts().map(str::to_owned).collect();
        (word, texts.join("\n"))
    });
    drawn.collect()
}

/// Bending of 0.2 by 0.1 m with 1 kN m: M h / 2I = 3 MPa at the edges.
#[test]
fn bending_is_reported_with_its_extremes_and_their_positions() {
    let section = rectangle(CellKind::Quadrilateral8);
    let recovery = bending(&section, 1000.0, 0.2 * 0.1_f64.powi(3) / 12.0);
    let drawn = drawn(&section, &recovery, &[]);
    let words: Vec<_> = drawn.iter().map(|(word, _)| *word).collect();
    assert_eq!(words, ["stress_xx", "shear", "von_mises"]);

    let holds = |plot: usize, text: &str| assert!(drawn[plot].1.contains(text), "{text}");
    holds(0, "bar: axial stress xx");
    holds(0, "load case \"bending\": bending y 1000 N m");
    holds(0, "axial stress xx [MPa]");
    holds(0, "max 3 MPa at (y, z) = (-50, 50) mm, region upper");
    holds(0, "min -3 MPa at (y, z) = (-100, -50) mm, region lower");
    // shear is exactly zero here, and the magnitude has no sign
    holds(1, "zero in the whole section, up to round-off");
    holds(2, "min 0 MPa at (y, z) = (-50, 0) mm, region lower");
    holds(2, "max 3 MPa at (y, z) = (-100, -50) mm, region lower");
}

/// The largest of two criteria; cells without strengths have no index.
#[test]
fn largest_failure_index_is_shown_where_there_is_one() {
    let section = rectangle(CellKind::Triangle3);
    let recovery = bending(&section, 1000.0, 1e-5);
    let mut first = vec![0.5; section.mesh.cells.len()];
    let mut second = vec![0.25; section.mesh.cells.len()];
    (first[3], second[3], second[5]) = (f64::NAN, f64::NAN, 1.5);
    let failure = [("max_stress".into(), first), ("tsai_wu".into(), second)];
    let drawn = drawn(&section, &recovery, &failure);
    let (word, text) = &drawn[3];
    assert_eq!(*word, "failure");
    assert!(text.contains("largest failure index [-] (at most 1 means safe)"));
    assert!(text.contains(
        "of each cell, by its mean stress: max stress, Tsai-Wu; white: without strengths"
    ));
    let cell = &section.mesh.cells[5];
    let corners = cell.nodes().iter().map(|&n| section.mesh.nodes[n as usize]);
    let [y, z] = corners.fold([0.0; 2], |sum, p| {
        [sum[0] + p[0] / 3.0, sum[1] + p[1] / 3.0]
    });
    let shown = |value: f64| tick_label((1e5 * value).round() / 100.0, 0.0);
    let position = format!("max 1.5 at (y, z) = ({}, {}) mm", shown(y), shown(z));
    assert!(text.contains(&position), "{position}");
    assert!(text.contains("min 0.5 at"));
    assert!(text.contains("above 1: fails"));
}

/// An index has the same color for any largest index, and all that fail have another.
#[test]
fn indices_are_shown_from_0_to_1() {
    let color = |highest: f64, value: f64| {
        let scale = Scale::new(Quantity::Index, [0.1, highest], 0.0);
        scale.color(scale.drawn(value))
    };
    assert_eq!(color(0.2, 0.17), color(0.98, 0.17));
    assert_eq!(color(0.2, 0.17), shared_geom::figure::sequential(0.17));
    assert_eq!(color(1.0, 1.0), shared_geom::figure::sequential(1.0));
    assert_eq!(color(50.0, 1.001), color(50.0, 50.0));
    assert_ne!(color(50.0, 1.001), color(50.0, 1.0));
}

/// A stress that is the same everywhere has no position; one that is round-off of another is
/// zero.
#[test]
fn uniform_stress_is_reported_as_such() {
    let section = rectangle(CellKind::Quadrilateral4);
    let force = Vector6::new(2e5, 0.0, 0.0, 0.0, 0.0, 0.0);
    let recovery = recovery(&section, "pull", force, |_, [y, _]| {
        Vector6::new(1e7, 0.0, 0.0, 0.0, 1e-4 * y, 0.0)
    });
    let drawn = drawn(&section, &recovery, &[]);
    assert!(drawn[0].1.contains("10 MPa in the whole section"));
    assert!(
        drawn[1]
            .1
            .contains("zero in the whole section, up to round-off")
    );
    assert!(!drawn[0].1.contains("max "));
}

#[test]
fn unit_follows_the_largest_value() {
    let shown = |value: f64| Scale::new(Quantity::SignedStress, [-value, 0.0], 0.0).shown(value);
    let cases = [
        (12.0, "12 Pa"),
        (0.0125, "0.0125 Pa"),
        (1500.0, "1.5 kPa"),
        (1.234_56e6, "1.235 MPa"),
        (1.2e9, "1200 MPa"),
        (3e10, "30 GPa"),
    ];
    for (value, expected) in cases {
        assert_eq!(shown(value), expected);
    }
    assert_eq!(
        Scale::new(Quantity::Index, [0.0, 2.0], 0.0).shown(0.5),
        "0.5"
    );
}

/// Zero has the same color in any range, and equal magnitudes are equally far from it.
#[test]
fn colors_of_signed_values_are_centered_at_zero() {
    let color = |range, value| Scale::new(Quantity::SignedStress, range, 0.0).color(value);
    assert_eq!(color([-1.0, 9.0], 0.0), Color(238, 238, 238));
    assert_eq!(color([2.0, 9.0], 9.0), color([-9.0, 1.0], 9.0));
    assert_eq!(color([-3.0, 9.0], -3.0), color([-9.0, 9.0], -3.0));
    let zero = Scale::new(Quantity::SignedStress, [-1e-9, 1e-9], 1e-8);
    assert!(zero.is_zero() && zero.color(1e-9) == zero.color(0.0));
}

/// A tube of 1 mm wall on 200 mm: the band on both sides widens it to 14 pixels, and has the
/// stress of the adjacent surface.
#[test]
fn thin_walls_are_drawn_thicker_on_both_sides() {
    let tube = Tube {
        outer_radius: 0.1,
        thickness: 0.001,
        cells_around: 24,
        cells_through: 1,
        kind: CellKind::Quadrilateral9,
        curved: true,
    };
    let section = section(&tube.generate().unwrap(), "tube", false);
    let radius = |[y, z]: [f64; 2]| y.hypot(z);
    let recovery = recovery(&section, "torque", Vector6::zeros(), |_, position| {
        Vector6::new(1e9 * (radius(position) - 0.0995), 0.0, 0.0, 0.0, 0.0, 0.0)
    });
    let mut plots = stress_plots(&section, &summary(&section), &recovery, &[]);
    let (_, plot) = plots.remove(0);
    let scale = plot.plane.scale;
    let swelling = plot.swelling();
    // wall of 1 mm up to the chords of the parabolas
    assert!((swelling - 0.5 * (THINNEST - 0.001 * scale)).abs() < 0.01);
    let rim = Rim::new(&section, &plot.plane, &plot.field, &plot.sides, swelling);
    let center = plot.plane.position([0.0; 2]);
    let mut seen = [false; 2];
    for triangle in rim.triangles() {
        for ([x, y], value) in triangle.corners.into_iter().zip(triangle.values) {
            let radius = (x - center[0]).hypot(y - center[1]);
            let inner = radius < 0.0995 * scale;
            let surface = if inner { 0.099 } else { 0.1 } * scale;
            // parabolas leave the circle by 2e-5 of the radius on 24 cells
            let off = (radius - surface).abs();
            assert!(
                off < 0.1 || (off - swelling).abs() < 0.1,
                "{off} {swelling}"
            );
            assert_eq!(value > 0.0, !inner);
            seen[usize::from(inner)] = true;
        }
    }
    assert_eq!(seen, [true; 2]);
    assert_eq!(rim.outlines.len(), 2 * 24);
    assert!(
        plot.words[1].contains("walls (about 1 mm) drawn"),
        "{}",
        plot.words[1]
    );
}
