//! Boxes: thin walls that are mitred at four corners.

use std::f64::consts::{LN_2, PI};

use section_analyzer::analysis::{analyze, discretization_error};

use crate::closed_forms::{isotropic, layer, section};
use crate::sections::{Case, measures, model};

/// Points of each side.
const POINTS: usize = 20;

/// A box of this width and height from the rear corner of its upper side: the front corners are given
/// twice, the base is the rear wall.
fn box_of([width, height]: [f64; 2]) -> Vec<[f64; 2]> {
    let corners = [
        [-width, 0.5 * height],
        [0.0, 0.5 * height],
        [0.0, -0.5 * height],
        [-width, -0.5 * height],
    ];
    let side = |pair: &[[f64; 2]]| {
        let at = |k: usize, i: usize| {
            let part = k as f64 / POINTS as f64;
            pair[0][i] + (pair[1][i] - pair[0][i]) * part
        };
        (0..=POINTS)
            .map(|k| [at(k, 0), at(k, 1)])
            .collect::<Vec<_>>()
    };
    corners.windows(2).flat_map(side).collect()
}

fn walls([width, height]: [f64; 2], thickness: f64) -> Case {
    Case {
        name: "box".into(),
        section: section(box_of([width, height]), vec![layer("wall", thickness)]),
        materials: vec![("wall".into(), "metal".into())],
        laws: vec![isotropic("metal")],
    }
}

/// Torsion of thin boxes with walls of the lengths l between the inner corners:
///
/// ```text
/// J = 4 A^2 / (sum l/t + 4 c) + P t^3/3,    c = 1 - (2/pi) ln 2
/// ```
///
/// with the area A and the length P of the middle line. A corner of two walls of one thickness is c squares of
/// a wall (the conformal map of a bend), which Bredt's formula counts as one: GJ without it is 5e-3 lower at
/// t = 0.02. The terms that are missing are of the order of t^2/A. Cells as long as usual all around would have errors of
/// 2.7e-3 and 5.1e-3 in the second and third box, as none of them is as short as the wall is thick.
#[test]
fn torsion_of_thin_boxes() {
    let [width, height] = [1.0, 0.5];
    for t in [0.02, 0.005, 0.001] {
        let (b, h): (f64, f64) = (width - t, height - t);
        let squares = 2.0 * (b + h - 2.0 * t) / t + 4.0 * (1.0 - 2.0 / PI * LN_2);
        let exact = 4.0 * (b * h).powi(2) / squares + 2.0 * (b + h) * t.powi(3) / 3.0;
        let case = walls([width, height], t);
        let meshed = case.section.generate().expect("a mesh");
        let model = model(&case, &meshed);
        let solution = analyze(&model).expect("a solution");
        let error = measures(&solution)[4] / (70e9 / 2.6) / exact - 1.0;
        let estimate = discretization_error(&model, &solution.stiffness).expect("an estimate");
        let estimate = estimate.stiffness[(3, 3)] / solution.stiffness[(3, 3)];
        let rest = t * t / (b * h);
        println!(
            "t {t}: error {error:.2e}, estimate {estimate:.2e}, {} cells",
            model.cells.len()
        );
        assert!(error.abs() < 1e-3, "{t}: {error:e}");
        assert!(
            (error - estimate).abs() < 0.25 * estimate + rest,
            "{t}: {error:e} {estimate:e}"
        );
    }
}

/// The nose of a flat front is its middle, so that both sides of a box have the same cells.
#[test]
fn both_sides_of_a_flat_nose_are_equal() {
    let case = walls([1.0, 0.5], 0.01);
    let mesh = case.section.generate().expect("a mesh").mesh;
    let nodes = |name: &str| -> Vec<[f64; 2]> {
        let mut groups = mesh.groups.iter();
        let group = groups.position(|group| group.name.as_deref() == Some(name));
        let group = group.expect("a side");
        let cells = mesh.cells.iter();
        let cells = cells.filter(|cell| cell.groups.contains(group));
        let nodes = cells.flat_map(|cell| cell.nodes().to_vec());
        let place = |node: u32| mesh.nodes[node as usize].position;
        let mut places: Vec<[f64; 2]> = nodes.map(|node| [place(node).x, place(node).y]).collect();
        places.sort_by(|a, b| {
            a[0].total_cmp(&b[0])
                .then(a[1].abs().total_cmp(&b[1].abs()))
        });
        places
    };
    let [above, below] = ["wall@suction", "wall@pressure"].map(nodes);
    assert_eq!(above.len(), below.len());
    let sum = |places: &[[f64; 2]], i: usize| places.iter().map(|at| at[i]).sum::<f64>();
    for (i, sign) in [(0, 1.0), (1, -1.0)] {
        let [a, b] = [&above, &below].map(|places| sum(places, i));
        assert!((a - sign * b).abs() < 1e-9, "{i}: {a} {b}");
    }
}
