//! Feet of webs: flanges of their outer plies and bond lines, as layers inside of all others.

use shared_geom::document::schema::TableSchema;
use shared_geom::document::schema::ValueKind::{NotNegative, Positive, Table as OneTable, Word};
use shared_geom::document::{Nested, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::course::{COURSE, Course};
use super::keys::MATERIAL;
use super::layers::Known;
use super::place::{Place, SIDES};
use super::problem::LayupFileProblem;
use super::{Toward, WrittenLayer, WrittenWeb};

keys! {
    /// Flanges and bond lines on both sides of a web.
    FOOT_KEYS = "foot";
    /// Length along the contour beyond the faces of the web.
    WIDTH: Course = "width", [NotNegative(Dimension::LENGTH), OneTable(&COURSE)], required, "\"80 mm\"";
    /// The sides of the web to which the foot extends.
    SIDE: usize = "side", [Word(&WAYS)], or "\"both\"" = 2, "\"aft\"";
    /// The plies that turn into flanges: the outermost ply of the web on each of these sides, the layer
    /// `WEB_flange_SIDE`.
    TURNED: Option<usize> = "plies", [Word(&["outer"])], optional, "\"outer\"";
    /// The bond line below, the layer `WEB_bond_SIDE`.
    BOND: Nested = "bond", [OneTable(&BOND_TABLE)], optional, "";
}
keys! {
    /// A bond line.
    BOND_TABLE = "bond";
    /// Its thickness.
    BOND_THICKNESS: Course = "thickness", [Positive(Dimension::LENGTH), OneTable(&COURSE)], required,
        "\"5 mm\"";
    with MATERIAL.schema;
}
/// The table of a foot.
pub(super) const FOOT_TABLE: TableSchema = FOOT_KEYS;
/// Words of the sides of a web.
const WAYS: [&str; 3] = ["fore", "aft", "both"];

/// The layers of the feet of a web, from the outside in; notes problems.
pub(super) fn read(
    known: &Known,
    table: &Table<'_>,
    web: &WrittenWeb,
) -> Option<Vec<WrittenLayer>> {
    let (width, way, turned) = (table.get(&WIDTH), table.get(&SIDE), table.get(&TURNED));
    let bond = table.nested(&BOND, |bond| {
        let (material, thickness) = (known.material(bond), bond.get(&BOND_THICKNESS));
        Some((material?, thickness?))
    });
    let (width, way, turned, bond) = (width?, way?, turned?, bond?);
    if turned.is_none() && bond.is_none() {
        let web = web.name.clone();
        table.note("", &LayupFileProblem::Foot { web });
        return None;
    }
    let ends = [web.plies.first(), web.plies.last()];
    if turned.is_some() && ends[0].is_none() {
        table.wrong(&TURNED, "a web with plies");
        return None;
    }
    let line = table.line();
    let mut layers = Vec::new();
    for side in 0..SIDES.len() {
        let place = Sides {
            web: &web.name,
            side,
            width: &width,
            line,
        };
        let layer = |kind: &str, [from, to]: [Place; 2]| WrittenLayer {
            name: format!("{}_{kind}_{}", web.name, SIDES[side]),
            material: String::new(),
            thickness: Course::constant(0.0),
            fiber_angle: 0.0,
            toward: Toward::LeadingEdge,
            from,
            to,
            taper: None,
            profile: Vec::new(),
            web: None,
            line,
        };
        if let Some((material, thickness)) = &bond {
            layers.push(WrittenLayer {
                material: material.clone(),
                thickness: thickness.clone(),
                ..layer("bond", place.between(way != 1, way != 0))
            });
        }
        for (number, ply) in ends.iter().enumerate().filter(|_| turned.is_some()) {
            let Some(ply) = ply.filter(|_| way == 2 || way == number) else {
                continue;
            };
            let (kind, reach) = match (way, number) {
                (2, 0) => ("fore_flange", place.half(true)),
                (2, _) => ("aft_flange", place.half(false)),
                _ => ("flange", place.between(way != 1, way != 0)),
            };
            layers.push(WrittenLayer {
                material: ply.material.clone(),
                thickness: ply.thickness.clone(),
                fiber_angle: ply.fiber_angle,
                ..layer(kind, reach)
            });
        }
    }
    Some(layers)
}

/// Places of the foot of a web on a side.
struct Sides<'a> {
    web: &'a str,
    side: usize,
    width: &'a Course,
    line: usize,
}

impl Sides<'_> {
    /// A place of the web, moved by the width fore (1), aft (-1) or not.
    fn at(&self, word: &str, way: f64) -> Place {
        let name = format!("{}.{}{word}", self.web, SIDES[self.side]);
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

    /// From face to face, and beyond it by the width on the sides that are asked for.
    fn between(&self, fore: bool, aft: bool) -> [Place; 2] {
        let way = |is_there: bool| f64::from(u8::from(is_there));
        self.in_order(self.at(".aft", -way(aft)), self.at(".fore", way(fore)))
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
