//! Fills: components of one material in a space between the shell and webs.
//!
//! `<location>` is a point of the space, whose bounds are the nearest web ahead of it and the nearest one
//! behind it.

use super::super::fills::{FillBound, WrittenFill};
use super::components::Segment;
use super::files::{Element, Notes};
use super::geometry::{Geometry, Placement};
use super::materials::Known;
use crate::mesh::is_within;

/// A web with less height than this part of its length has no side ahead of it.
const FLAT: f64 = 1e-3;

/// A component of the type "fill".
#[derive(Debug, Clone)]
pub(super) struct Fill<'x> {
    name: String,
    /// A point of its space.
    at: [f64; 2],
    pub material: String,
    element: Element<'x>,
}

/// The fills of a main file; notes problems.
pub(super) fn read<'x>(
    main: Element<'x>,
    geometry: &mut Geometry<'x>,
    known: &Known<'_>,
    notes: &mut Notes,
) -> Option<Vec<Fill<'x>>> {
    let components = main.named("component");
    let elements = components.filter(|one| one.attribute("type") == Some("fill"));
    let read: Vec<_> = elements
        .enumerate()
        .map(|(i, element)| fill(element, i, geometry, known, notes))
        .collect();
    read.into_iter().collect()
}

fn fill<'x>(
    element: Element<'x>,
    index: usize,
    geometry: &mut Geometry<'x>,
    known: &Known<'_>,
    notes: &mut Notes,
) -> Option<Fill<'x>> {
    let mut is_read = true;
    for name in ["baseline", "theta1", "theta3", "segment", "segments"] {
        if let Some(child) = element.child(name) {
            let expected = "<location> and <material>";
            let help = "change the [[fill]] of the written layup file, which has bounds and angles";
            notes.wrong(child, [&element.shown(), &child.shown(), expected, help]);
            is_read = false;
        }
    }
    let location = element.required("location", notes);
    let material = element.required("material", notes);
    let spot = location.and_then(|(at, name)| geometry.point(&name, at, notes));
    let (at, material) = material?;
    let is_known = known.has(&material, at, notes);
    let name = element.attribute("name").filter(|name| !name.is_empty());
    let fill = Fill {
        name: name.map_or_else(|| format!("fill_{}", index + 1), str::to_owned),
        at: spot?.at,
        material,
        element,
    };
    (is_read && is_known).then_some(fill)
}

impl Fill<'_> {
    /// The fill with its point in the axes of the section.
    pub fn placed(mut self, placement: &Placement) -> Self {
        self.at = placement.at(self.at);
        self
    }

    /// The fill between its webs; notes a point that is in no space.
    pub fn written(
        self,
        contour: &[[f64; 2]],
        webs: &[&Segment<'_>],
        notes: &mut Notes,
    ) -> Option<WrittenFill> {
        if !is_within(contour, self.at) {
            let found = format!("the point ({}, {})", self.at[0], self.at[1]);
            let expected = "a <location> inside of the contour";
            let help = "name a point of the space that is filled";
            notes.wrong(
                self.element,
                [&self.element.shown(), &found, expected, help],
            );
            return None;
        }
        let [mut behind, mut ahead]: [Option<(f64, &Segment<'_>)>; 2] = [None, None];
        for web in webs {
            let Some(distance) = ahead_by(web, self.at) else {
                continue;
            };
            let side = if distance > 0.0 {
                &mut ahead
            } else {
                &mut behind
            };
            if side.is_none_or(|known| distance.abs() < known.0.abs()) {
                *side = Some((distance, web));
            }
        }
        let bound = |side: Option<(f64, &Segment<'_>)>| {
            side.map(|(_, web)| FillBound::Web(web.name.clone(), web.element.line()))
        };
        Some(WrittenFill {
            name: self.name,
            material: self.material,
            fiber_angle: 0.0,
            plane_angle: 0.0,
            bounds: [bound(behind), bound(ahead)],
            range: [0.0, 1.0],
            line: self.element.line(),
        })
    }
}

/// The distance along y from a point to the line of a web; `None` for a web along y.
fn ahead_by(web: &Segment<'_>, at: [f64; 2]) -> Option<f64> {
    let (first, last) = (web.points[0], web.points[web.points.len() - 1]);
    let [dy, dz] = [last[0] - first[0], last[1] - first[1]];
    (dz.abs() > FLAT * dy.hypot(dz)).then(|| first[0] + (at[1] - first[1]) * dy / dz - at[0])
}
