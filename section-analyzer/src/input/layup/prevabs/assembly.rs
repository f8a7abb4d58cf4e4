//! The layup of the components: one of them is the shell, the others are webs.

use super::super::course::Course;
use super::super::fills::WrittenFill;
use super::super::shape::Shape;
use super::super::{WrittenLayer, WrittenWeb, wrong_names};
use super::components::{List, Segment};
use super::contour::{self, Chain, Contour};
use super::files::Notes;
use super::fills::Fill;
use super::geometry::extent;
use super::{Points, stack, webs};

/// Shape, layers, webs and fills of a section.
pub(super) struct Made {
    pub shape: Shape,
    pub layers: Vec<WrittenLayer>,
    pub webs: Vec<WrittenWeb>,
    pub fills: Vec<WrittenFill>,
    /// Line of the first segment of the shell.
    pub line: usize,
}

/// The layup of components and fills whose points are in the axes of the section; notes problems.
pub(super) fn assemble(list: List<'_>, fills: Vec<Fill<'_>>, notes: &mut Notes) -> Option<Made> {
    let shell = shell(&list, notes)?;
    let Shell {
        segments,
        chain,
        rest,
    } = shell;
    let first = segments[chain[0].0].element;
    let contour = contour::contour(&segments, chain, notes);
    let contour = contour?;
    let depth = segments
        .iter()
        .map(|one| one.plies.iter().map(|ply| ply.thickness).sum::<f64>());
    let depth = depth.fold(0.0, f64::max);
    let made: Vec<Option<WrittenWeb>> = rest
        .iter()
        .map(|segment| webs::web(segment, &contour, depth, notes))
        .collect();
    let webs: Option<Vec<WrittenWeb>> = made.into_iter().collect();
    let layers = stack::layers(&segments, &contour.pieces);
    let fills: Vec<Option<WrittenFill>> = fills
        .into_iter()
        .map(|fill| fill.written(&contour.points, &rest, notes))
        .collect();
    let fills: Option<Vec<WrittenFill>> = fills.into_iter().collect();
    let (webs, fills) = (webs?, fills?);
    if let Some((line, problem)) = wrong_names(&layers, &webs, &fills).into_iter().next() {
        let found = problem.to_string();
        let help = "give the segments names of their own";
        notes.wrong_on(
            first.file,
            line,
            ["the names", &found, "different names", help],
        );
        return None;
    }
    let shape = shape(&contour)?;
    notes.remarks.push(format!(
        "y is x2, z is x3; the contour starts at ({}, {}) and runs clockwise: the suction side is \
         its first part, up to the point farthest from there",
        rounded(contour.points[0][0]),
        rounded(contour.points[0][1])
    ));
    Some(Made {
        shape,
        layers,
        webs,
        fills,
        line: first.line(),
    })
}

/// A number with five digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.4e}").parse().unwrap_or(value)
}

/// The segments of the shell, their closed chain, and the other segments.
struct Shell<'s, 'x> {
    segments: Vec<&'s Segment<'x>>,
    chain: Chain,
    rest: Vec<&'s Segment<'x>>,
}

/// The closed chain of the largest area, within one component or, if there is none, of all
/// segments of components that do not depend on others; notes its absence.
fn shell<'s, 'x>(list: &'s List<'x>, notes: &mut Notes) -> Option<Shell<'s, 'x>> {
    let groups = list
        .components
        .iter()
        .map(|one| one.segments.iter().collect::<Vec<_>>());
    let mut groups: Vec<Vec<&Segment<'_>>> = groups.filter(|group| !group.is_empty()).collect();
    let is_free = |depend: Option<&str>| depend.is_none_or(str::is_empty);
    let free = list
        .components
        .iter()
        .filter(|one| is_free(one.element.attribute("depend")));
    groups.push(free.flat_map(|one| &one.segments).collect());
    let mut best: Option<(f64, usize, Chain)> = None;
    for (number, group) in groups.iter().enumerate() {
        let Some(chain) = contour::chained(group) else {
            continue;
        };
        let area = contour::area(group, &chain).abs();
        let is_last = number + 1 == groups.len() && best.is_some();
        if !is_last && best.as_ref().is_none_or(|known| area > known.0) {
            best = Some((area, number, chain));
        }
    }
    let Some((_, number, chain)) = best else {
        let element = list.components[0].element;
        let help = "open sections are meshed in gmsh; a closed one needs base lines that meet at \
                    equal points";
        let found = "no segments that close a contour";
        let expected = "a component whose base lines close a contour";
        notes.wrong(element, ["the section", found, expected, help]);
        return None;
    };
    let segments: Vec<&Segment<'_>> = groups.swap_remove(number);
    let used = |one: &Segment<'_>| chain.iter().any(|(i, _)| std::ptr::eq(segments[*i], one));
    let all = list.components.iter().flat_map(|one| &one.segments);
    let rest = all.filter(|one| !used(one)).collect();
    Some(Shell {
        segments,
        chain,
        rest,
    })
}

/// The shape of a contour: chord and origin from the range of y.
fn shape(contour: &Contour) -> Option<Shape> {
    let points: &Points = &contour.points;
    let high = points
        .iter()
        .map(|point| point[0])
        .fold(f64::NEG_INFINITY, f64::max);
    let low = points
        .iter()
        .map(|point| point[0])
        .fold(f64::INFINITY, f64::min);
    let chord = (high - low).max(1e-3 * extent(points));
    let part = |[y, z]: &[f64; 2]| [(high - y) / chord, z / chord];
    let relative = points.iter().map(part).collect();
    let courses = [chord, high / chord, 0.0].map(Course::constant);
    Shape::new(courses, None, vec![(0.0, relative)]).ok()
}
