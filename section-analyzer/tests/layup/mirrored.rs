//! A section and its mirror image, suction side for pressure side, have mirrored meshes.

use section_analyzer::mesh::generate::layup::{
    Bound, Layer, LayupProblem, LayupSection, MeshedLayup,
};

use crate::effort;
use crate::nose::thick_nose;
use crate::random::valid;

/// The section with suction and pressure side exchanged.
pub fn mirrored(section: &LayupSection) -> LayupSection {
    let mut image = section.clone();
    image.contour.reverse();
    image.contour.iter_mut().for_each(|point| point[1] *= -1.0);
    let both = |[suction, pressure]: [f64; 2]| [1.0 - pressure, 1.0 - suction];
    for layer in &mut image.layers {
        [layer.from, layer.to] = both([layer.from, layer.to]);
        layer.profile.reverse();
        layer
            .profile
            .iter_mut()
            .for_each(|one| one[0] = 1.0 - one[0]);
    }
    for web in &mut image.webs {
        web.arcs = both(web.arcs);
    }
    for web in image.spar.iter_mut().flat_map(|spar| &mut spar.webs) {
        web.arcs = both(web.arcs);
        web.feet.iter_mut().for_each(|feet| feet.reverse());
    }
    for fill in &mut image.fills {
        for bound in [&mut fill.ahead_of, &mut fill.aft_of].into_iter().flatten() {
            if let Bound::Line(arcs) = bound {
                *arcs = both(*arcs);
            }
        }
    }
    image
}

/// The largest difference of areas, relative to the largest area; the areas by name.
fn difference(one: &MeshedLayup, other: &MeshedLayup) -> f64 {
    let largest = one.areas.iter().map(|area| area.meshed).fold(0.0, f64::max);
    let pairs = one.areas.iter().zip(&other.areas);
    let off = pairs.map(|(a, b)| {
        assert_eq!(a.name, b.name);
        (a.meshed - b.meshed).abs().max((a.cut - b.cut).abs())
    });
    off.fold(0.0, f64::max) / largest
}

/// Whether both problems are the same, with mirrored arcs.
fn is_same(one: &LayupProblem, other: &LayupProblem) -> bool {
    use LayupProblem::{Crowded, Meeting, Tight};
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * a.abs().max(b.abs());
    match (one, other) {
        (Crowded { space: a, .. }, Crowded { space: b, .. }) => is_same(a, b),
        (
            Tight {
                layer,
                arc,
                thickness,
                radius,
                ..
            },
            Tight {
                layer: l,
                arc: a,
                thickness: t,
                radius: r,
                ..
            },
        ) => {
            layer == l
                && near(*thickness, *t)
                && near(*radius, *r)
                && (near(*arc, 1.0 - a) || near(*arc, *a))
        }
        (
            Meeting { taken, length, .. },
            Meeting {
                taken: t,
                length: l,
                ..
            },
        ) => near(*taken, *t) && near(*length, *l),
        (a, b) => std::mem::discriminant(a) == std::mem::discriminant(b) && a.about() == b.about(),
    }
}

/// The difference of the areas of a section and of its mirror image; `None` if both are refused.
fn difference_of_images(section: &LayupSection, of: &str) -> Option<f64> {
    match (section.generate(), mirrored(section).generate()) {
        (Ok(one), Ok(other)) => Some(difference(&one, &other)),
        (Err(one), Err(other)) => {
            assert!(is_same(&one, &other), "{of}:\n{one}\n{other}");
            None
        }
        (one, other) => {
            let text = |made: Result<_, LayupProblem>| made.err().map(|one| one.to_string());
            panic!("{of}: {:?}\n{:?}", text(one), text(other));
        }
    }
}

/// Sections are meshed if and only if their mirror images are, with the same areas: noses in which the
/// layers meet, and layups with caps, webs, spars and fills. Areas are equal to round-off, but for a nose in
/// a hundred with two stations that are equally near, of which round-off leaves one out, with up to 2e-4 of
/// the largest area. Refusals have the same reason, layer and numbers.
#[test]
fn mirror_images_have_the_same_areas() {
    let (mut refused, mut inexact) = (0, 0);
    let count = effort::cases(40);
    for seed in 0..count as u64 {
        for (section, of) in [(thick_nose(seed), "nose"), (valid(seed), "layup")] {
            match difference_of_images(&section, &format!("{of} {seed}")) {
                Some(difference) => {
                    assert!(difference < 2e-4, "{of} {seed}: {difference:e}");
                    inexact += usize::from(difference > 1e-9);
                }
                None => refused += 1,
            }
        }
    }
    assert!(
        refused <= count / 10 && inexact <= count / 50,
        "{refused} {inexact}"
    );
}

/// A layer behind the nose has the same area whatever the layers of the nose need: other reaches of
/// contacts and shorter cells are used where cells fail only. One in fifty may have an end of its ramp
/// beside a station that the contact of the nose brings, which changes its area by less than 1e-3.
#[test]
fn remedies_at_the_nose_do_not_change_the_rest() {
    let (mut compared, mut inexact) = (0, 0);
    for seed in 0..effort::cases(30) as u64 {
        let mut thick = thick_nose(seed);
        let rear = Layer {
            name: "rear".into(),
            from: 0.1,
            to: 0.2,
            ..thick.layers[3].clone()
        };
        thick.layers.push(rear);
        let mut thin = thick.clone();
        thin.layers[2].thickness *= 1e-2;
        let (Ok(thick), Ok(thin)) = (thick.generate(), thin.generate()) else {
            continue;
        };
        compared += 1;
        let area = |made: &MeshedLayup| {
            let found = made.areas.iter().find(|area| area.name == "rear");
            found.expect("the layer").meshed
        };
        let [thick, thin] = [area(&thick), area(&thin)];
        // where the outer layers fill the section it has none
        let difference = (thick - thin).abs();
        assert!(difference <= 1e-3 * thin, "{seed}: {thick} {thin}");
        inexact += usize::from(difference > 1e-9 * thin);
    }
    assert!(compared > 20, "{compared}");
    assert!(inexact <= compared / 50, "{inexact} of {compared}");
}
