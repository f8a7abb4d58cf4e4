//! The stiffness of a section and of its mirror image, through layup files, meshes and section files.

use std::fmt::Write;
use std::path::Path;

use nalgebra::{Matrix6, Vector6};
use section_analyzer::analysis::analyze;
use section_analyzer::input::layup::parse;
use section_analyzer::mesh::generate::layup::LayupSection;

use crate::effort;
use crate::files::section;
use crate::mirrored::mirrored;
use crate::random::{Random, valid};

/// Materials of the layers.
const MATERIALS: &str = "
[material.ud]
e1 = 40e9
e2 = 10e9
e3 = 9e9
g12 = 4e9
g13 = 3.8e9
g23 = 3.5e9
nu12 = 0.28
nu13 = 0.3
nu23 = 0.4
density = 1900
[material.foam]
young = 100e6
poisson = 0.3
density = 80
";

/// The layup file of a section, with the angle of each layer and web ply \[deg\].
fn text(section: &LayupSection, angles: &[f64], of_webs: f64) -> String {
    let y = section.contour.iter().map(|point| point[0]);
    let (low, high) = y.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| {
        (a.min(y), b.max(y))
    });
    let chord = high - low;
    let points = section
        .contour
        .iter()
        .map(|[y, z]| [(high - y) / chord, z / chord]);
    let points: Vec<[f64; 2]> = points.collect();
    let mut text = format!(
        "units = \"SI\"\n[shape]\nchord = {chord:?}\norigin = {:?}\npoints = {points:?}\n",
        high / chord
    );
    for (layer, angle) in section.layers.iter().zip(angles) {
        let material = ["ud", "foam"][usize::from(layer.name.starts_with("panel"))];
        let _ = write!(
            text,
            "[[layer]]\nname = {:?}\nmaterial = {material:?}\nthickness = {:?}\nfrom = {:?}\nto = {:?}\n\
             fiber_angle = \"{angle} deg\"\n",
            layer.name, layer.thickness, layer.from, layer.to
        );
    }
    for web in &section.webs {
        let plies = web.plies.iter().map(|ply| {
            let material = ["ud", "foam"][usize::from(ply.name.ends_with("core"))];
            format!(
                "{{ name = {:?}, material = {material:?}, thickness = {:?}, fiber_angle = \"{of_webs} deg\" }}",
                ply.name, ply.thickness
            )
        });
        let plies: Vec<String> = plies.collect();
        let _ = write!(
            text,
            "[[web]]\nname = {:?}\nsuction = {:?}\npressure = {:?}\nplies = [{}]\n",
            web.name,
            web.arcs[0],
            web.arcs[1],
            plies.join(", ")
        );
    }
    text + MATERIALS
}

/// The stiffness of the section of a layup file; `None` if it is refused.
fn stiffness(text: &str) -> Option<Matrix6<f64>> {
    let layup = parse(text, Path::new("a.layup.toml"))
        .unwrap_or_else(|problems| panic!("{problems}\n{text}"));
    layup.mesh(0.0).ok()?;
    Some(
        analyze(&section(&layup, 0.0).section)
            .expect("a solution")
            .stiffness,
    )
}

/// The largest difference of entries, over the roots of the diagonal.
fn difference(a: &Matrix6<f64>, b: &Matrix6<f64>) -> f64 {
    let of = |i: usize, j: usize| (a[(i, j)] - b[(i, j)]).abs() / (a[(i, i)] * a[(j, j)]).sqrt();
    let all = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
    all.map(|(i, j)| of(i, j)).fold(0.0, f64::max)
}

/// z to -z: forces along x and y remain, the one along z turns around; moments, whose sense is the one of a
/// screw, turn around about x and y, and remain about z. Angles of fibers toward the leading edge remain, as
/// it is where it was; in webs they are toward the suction side, which is now the other one. So
///
/// ```text
/// K' = T K T,   T = diag(1, 1, -1, -1, -1, 1)
/// ```
///
/// to the round-off of two solutions, 1e-9, where the meshes are mirror images, as they are for equal areas; one
/// nose in a hundred has stations of which round-off leaves one out, and 1e-3 there. The layups couple
/// tension and torsion, so that wrong signs would be seen.
#[test]
fn mirror_images_have_the_mirrored_stiffness() {
    let flip = Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, -1.0, -1.0, -1.0, 1.0));
    let (mut exact, mut compared, mut coupled) = (0, 0, 0);
    let count = effort::cases(12);
    for seed in 0..count as u64 {
        let mut random = Random::new(9_000 + seed);
        let mut one = valid(seed);
        one.layers.retain(|layer| !layer.name.starts_with("spar"));
        (one.spar, one.fills) = (None, Vec::new());
        let angles: Vec<f64> = one
            .layers
            .iter()
            .map(|_| random.range(-60.0, 60.0).round())
            .collect();
        let of_webs = random.range(-60.0, 60.0).round();
        let own = stiffness(&text(&one, &angles, of_webs));
        let image = stiffness(&text(&mirrored(&one), &angles, -of_webs));
        assert_eq!(own.is_some(), image.is_some(), "{seed}");
        let Some((own, image)) = own.zip(image) else {
            continue;
        };
        let error = difference(&(flip * own * flip), &image);
        let coupling = own[(0, 3)].abs() / (own[(0, 0)] * own[(3, 3)]).sqrt();
        println!("{seed}: {error:.2e}, coupling {coupling:.3}");
        assert!(error < 1e-3, "{seed}: {error:e}");
        compared += 1;
        exact += usize::from(error < 1e-9);
        coupled += usize::from(coupling > 1e-3);
    }
    assert!(
        10 * compared >= 9 * count && 20 * exact >= 19 * compared,
        "{exact} of {compared}"
    );
    assert!(2 * coupled > compared, "{coupled} of {compared}");
}
