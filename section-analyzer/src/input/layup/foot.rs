//! Feet of webs: flanges of their outer plies and bond lines, as layers inside of all others.

use shared_geom::document::Table;

use super::course::Course;
use super::keys::{BOND_THICKNESS, FOOT, FOOT_BOND, REACH, TURNED, WAY, WAYS};
use super::layers::Known;
use super::place::{Place, SIDES};
use super::problem::LayupFileProblem;
use super::{WrittenLayer, WrittenWeb};

/// A web, and the layers of its feet; notes problems.
pub(super) fn web(known: &Known, table: &Table<'_>) -> Option<(WrittenWeb, Vec<WrittenLayer>)> {
    // known also if the web is wrong
    table.has(&FOOT);
    let web = known.web(table)?;
    let feet = table.nested(&FOOT, |foot| read(known, foot, &web))?;
    Some((web, feet.unwrap_or_default()))
}

/// The layers of the feet of a web, from the outside in; notes problems.
fn read(known: &Known, table: &Table<'_>, web: &WrittenWeb) -> Option<Vec<WrittenLayer>> {
    let (width, way, turned) = (table.get(&REACH), table.get(&WAY), table.get(&TURNED));
    let bond = table.nested(&FOOT_BOND, |bond| {
        let (material, thickness) = (known.material(bond), bond.get(&BOND_THICKNESS));
        Some((material?, thickness?))
    });
    let (width, way, turned, bond) = (width?, way?, turned?.is_some(), bond?);
    if !turned && bond.is_none() {
        let web = web.name.clone();
        table.note("", &LayupFileProblem::Foot { web });
        return None;
    }
    if turned && web.plies.is_empty() {
        table.wrong(&TURNED, "a web with plies");
        return None;
    }
    let foot = |side: usize| Sides {
        web,
        side,
        width: &width,
        line: table.line(),
    };
    let mut layers = Vec::new();
    for foot in [0, 1].map(foot) {
        if let Some((material, thickness)) = &bond {
            let places = foot.between(way);
            layers.push(foot.layer("bond", (material, thickness, Course::constant(0.0)), places));
        }
        if turned {
            layers.extend(foot.flanges(way));
        }
    }
    Some(layers)
}

/// The foot of a web on a side.
struct Sides<'a> {
    web: &'a WrittenWeb,
    side: usize,
    width: &'a Course,
    line: usize,
}

impl Sides<'_> {
    fn layer(
        &self,
        kind: &str,
        (material, thickness, fiber_angle): (&str, &Course, Course),
        reach: [Place; 2],
    ) -> WrittenLayer {
        let name = format!("{}_{kind}_{}", self.web.name, SIDES[self.side]);
        let named = (name, material.to_owned());
        WrittenLayer {
            fiber_angle,
            ..WrittenLayer::plain(named, thickness.clone(), reach, self.line)
        }
    }

    /// The flange of the outermost ply on a side of the web, or of both plies, which then abut in the
    /// middle.
    fn flanges(&self, way: usize) -> Vec<WrittenLayer> {
        let ends = [self.web.plies.first(), self.web.plies.last()];
        let flange = |(number, ply): (usize, Option<&WrittenLayer>)| {
            let ply = ply?;
            let of_ply = (
                ply.material.as_str(),
                &ply.thickness,
                ply.fiber_angle.clone(),
            );
            match WAYS[way] {
                "both" => {
                    let kind = ["fore_flange", "aft_flange"][number];
                    Some(self.layer(kind, of_ply, self.half(number == 0)))
                }
                word if word == WAYS[number] => {
                    Some(self.layer("flange", of_ply, self.between(way)))
                }
                _ => None,
            }
        };
        ends.into_iter().enumerate().filter_map(flange).collect()
    }

    /// A place of the web, moved by the width fore (1), aft (-1) or not.
    fn at(&self, word: &str, way: f64) -> Place {
        let name = format!("{}.{}{word}", self.web.name, SIDES[self.side]);
        let place = Place::of_name(name, self.line);
        // arcs grow fore on the suction side
        let sign = way * [1.0, -1.0][self.side];
        match sign {
            0.0 => place,
            _ => place.shifted(&self.width.map(|_, width| sign * width), 1.0),
        }
    }

    /// In the order of arcs.
    fn in_order(&self, aft: Place, fore: Place) -> [Place; 2] {
        match SIDES[self.side] {
            "suction" => [aft, fore],
            _ => [fore, aft],
        }
    }

    /// From face to face, and beyond it by the width on the sides of `way`.
    fn between(&self, way: usize) -> [Place; 2] {
        let reach = |other: &str| f64::from(u8::from(WAYS[way] != other));
        self.in_order(
            self.at(".aft", -reach("fore")),
            self.at(".fore", reach("aft")),
        )
    }

    /// From the middle of the web beyond its fore or its aft face.
    fn half(&self, is_fore: bool) -> [Place; 2] {
        if is_fore {
            self.in_order(self.at("", 0.0), self.at(".fore", 1.0))
        } else {
            self.in_order(self.at(".aft", -1.0), self.at("", 0.0))
        }
    }
}
