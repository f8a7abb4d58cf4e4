//! Layers and webs as written.

use shared_geom::document::{Item, Key, Table};
use shared_geom::units::Dimension;

use super::angle::{WITHIN_A_TURN, is_within_a_turn};
use super::course::Course;
use super::fills::WrittenFill;
use super::keys::{
    AFT_OF, AHEAD_OF, ANGLES, AROUND, COUNT, FIBER_ANGLE, FILL_FIBER_ANGLE, FROM, LAYERS, MATERIAL,
    NAME, PLANE_ANGLE, PLANE_OF_WEB, PLIES, PRESSURE, PROFILE, RANGE, ROUND, SUCTION, TAPER,
    THICKNESS, TO, TOWARD, WEB_NAME, WEB_OF_LAYER, WIDTH,
};
use super::place::{Place, SIDES};
use super::problem::LayupFileProblem;
use super::{Toward, WrittenLayer, WrittenWeb};
use crate::input::materials::WrittenMaterial;

impl WrittenLayer {
    /// Its thickness at a position along the span; 0 outside of its table \[m\].
    pub(super) fn thickness_at(&self, eta: f64) -> f64 {
        if self.thickness.covers(eta) {
            self.thickness.at(eta)
        } else {
            0.0
        }
    }

    /// A layer with its name and material between two places: its fibers are along x, and it has
    /// neither a taper nor a profile nor a web.
    pub(super) fn plain(
        (name, material): (String, String),
        thickness: Course,
        [from, to]: [Place; 2],
        line: usize,
    ) -> Self {
        Self {
            name,
            material,
            thickness,
            fiber_angle: Course::constant(0.0),
            toward: Toward::LeadingEdge,
            from,
            to,
            taper: None,
            profile: Vec::new(),
            web: None,
            line,
        }
    }
}

/// The thickness of a layer.
enum Stack {
    Thickness(Course),
    /// Plies of this thickness \[m\] with these angles of their fibers \[rad\].
    Plies(f64, Vec<f64>),
}

/// The materials of a file.
pub(super) struct Known {
    names: Vec<String>,
    /// Thickness of a ply of each, if known \[m\].
    plies: Vec<Option<f64>>,
}

impl Known {
    pub fn new(materials: Vec<WrittenMaterial>) -> Self {
        let materials = materials.into_iter();
        let (names, plies) = materials.map(|one| (one.name, one.ply_thickness)).unzip();
        Self { names, plies }
    }

    /// The layers of the shell, each with its plies; notes problems.
    pub fn shell(&self, root: &Table<'_>) -> Option<Vec<Vec<WrittenLayer>>> {
        let layers = root.each(&LAYERS, |table| self.layers(table));
        let is_none = layers.as_ref().is_some_and(Vec::is_empty) && root.is_list(&LAYERS);
        if is_none {
            root.wrong(&LAYERS, &LAYERS.schema.expected());
        }
        layers
    }

    /// A layer of the shell, or each of its plies; notes problems.
    fn layers(&self, table: &Table<'_>) -> Option<Vec<WrittenLayer>> {
        let name = table.get(&NAME);
        let places = (table.get(&FROM), table.get(&TO));
        let (taper, toward) = (table.get(&TAPER), table.get(&TOWARD));
        let (material, stack) = (self.material(table), self.stack(table, true));
        let angle = table.get(&FIBER_ANGLE);
        let profile = table.get(&PROFILE);
        let profile = profile.map(|found| found.map_or_else(Vec::new, |found| found.0));
        has_ramp(table, profile.as_deref().unwrap_or_default());
        let web = table.get(&WEB_OF_LAYER)?;
        let line = table.line_of(&WEB_OF_LAYER);
        let of_web = |key: &Key<Place>, given: Place, side: &str| match &web {
            Some(web) if !table.has(key) => Place::of_name(format!("{web}.{side}"), line),
            _ => given,
        };
        let from = of_web(&FROM, places.0?, SIDES[0]);
        let to = of_web(&TO, places.1?, SIDES[1]);
        let [from, to] = by_width(table, [from, to])?;
        if table.get(&AROUND)?.is_some() && web.is_none() {
            let layer = text(table, NAME.name());
            table.note(&AROUND, &LayupFileProblem::Around { layer });
            return None;
        }
        let web = web.map(|web| (web, line));
        let layer = |name: String, thickness: Course, fiber_angle: Course| {
            Some(WrittenLayer {
                name,
                material: material.clone()?,
                thickness,
                fiber_angle,
                toward: [Toward::LeadingEdge, Toward::Contour][toward?],
                from: from.clone(),
                to: to.clone(),
                taper: taper?,
                profile: profile.clone()?,
                web: web.clone(),
                line: table.line(),
            })
        };
        let name = name?.0;
        if web.is_some() && taper.flatten().is_some() && !table.has(&FROM) && !table.has(&TO) {
            let layer = name.clone();
            table.note(&TAPER, &LayupFileProblem::RampOfSpar { layer });
        }
        match stack? {
            Stack::Thickness(thickness) => Some(vec![layer(name, thickness, angle?)?]),
            Stack::Plies(ply, angles) => {
                let plies = angles.iter().zip(1..).map(|(angle, number)| {
                    let angle = Course::constant(*angle);
                    layer(format!("{name}/{number}"), Course::constant(ply), angle)
                });
                plies.collect()
            }
        }
    }

    fn ply(&self, table: &Table<'_>) -> Option<WrittenLayer> {
        let name = table.get(&NAME);
        let (material, stack) = (self.material(table), self.stack(table, false));
        let angle = table.get(&FIBER_ANGLE);
        let thickness = match stack? {
            Stack::Thickness(thickness) => thickness,
            // not of webs
            Stack::Plies(ply, _) => Course::constant(ply),
        };
        let (named, whole) = ((name?.0, material?), [0.0, 1.0].map(Place::arc));
        Some(WrittenLayer {
            fiber_angle: angle?,
            ..WrittenLayer::plain(named, thickness, whole, table.line())
        })
    }

    /// A web; notes problems.
    pub fn web(&self, table: &Table<'_>) -> Option<WrittenWeb> {
        let name = table.get(&WEB_NAME);
        let has_places = table.has(&SUCTION) || table.has(&PRESSURE);
        let places = match table.has(&PLANE_OF_WEB) {
            true if has_places => {
                let web = text(table, WEB_NAME.name());
                table.note("", &LayupFileProblem::WebPlaces { web });
                None
            }
            true => table.get(&PLANE_OF_WEB).map(|plane| plane.0),
            false => {
                let (suction, pressure) = (table.get(&SUCTION), table.get(&PRESSURE));
                suction
                    .zip(pressure)
                    .map(|(suction, pressure)| [suction, pressure])
            }
        };
        let plies = table.each(&PLIES, |ply| self.ply(ply));
        let name = name?.0;
        let range = range(table, &name);
        Some(WrittenWeb {
            name,
            places: places?,
            range: range?,
            plies: plies?,
            line: table.line(),
        })
    }

    /// A fill; notes problems.
    pub fn fill(&self, table: &Table<'_>) -> Option<WrittenFill> {
        let (name, material) = (table.get(&NAME), self.material(table));
        let bounds = (table.get(&AHEAD_OF), table.get(&AFT_OF));
        let angles = (table.get(&FILL_FIBER_ANGLE), table.get(&PLANE_ANGLE));
        let name = name?.0;
        Some(WrittenFill {
            range: range(table, &name)?,
            name,
            material: material?,
            fiber_angle: angles.0?.0,
            plane_angle: angles.1?.0,
            bounds: [bounds.0?, bounds.1?],
            line: table.line(),
        })
    }

    /// The name of the material, also if it is unknown, which is noted.
    pub fn material(&self, table: &Table<'_>) -> Option<String> {
        if !table.has(&MATERIAL) && table.has(&NAME) {
            let (layer, key) = (text(table, NAME.name()), "material");
            table.note("", &LayupFileProblem::Lacks { layer, key });
            return None;
        }
        let material = table.get(&MATERIAL)?;
        if !self.names.contains(&material) {
            let problem = LayupFileProblem::Unknown {
                kind: "material",
                found: material.clone(),
                known: self.names.clone(),
            };
            table.note(&MATERIAL, &problem);
        }
        Some(material)
    }

    fn stack(&self, table: &Table<'_>, of_shell: bool) -> Option<Stack> {
        let layer = text(table, NAME.name());
        let angles = of_shell && table.has(&ANGLES);
        let given = [table.has(&THICKNESS), table.has(&COUNT), angles];
        let found = given.into_iter().filter(|given| *given).count();
        if found != 1 {
            table.note("", &LayupFileProblem::Stack { layer, found });
            return None;
        }
        if table.has(&THICKNESS) {
            return table.get(&THICKNESS).map(Stack::Thickness);
        }
        let (count, round) = if table.has(&COUNT) {
            let (count, round) = (table.get(&COUNT), table.get(&ROUND));
            (Some(count?), round?)
        } else {
            (None, true)
        };
        let angles = if angles {
            Some(angles_of_plies(table)?)
        } else {
            None
        };
        if angles.is_some() && table.has(&FIBER_ANGLE) {
            table.note(&FIBER_ANGLE, &LayupFileProblem::Angles { layer });
            return None;
        }
        let material = text(table, MATERIAL.name());
        let known = self.names.iter().position(|name| *name == material)?;
        let Some(ply) = self.plies[known] else {
            table.note("", &LayupFileProblem::NoPly { layer, material });
            return None;
        };
        match (count, angles) {
            (Some(count), _) => Some(Stack::Thickness(if round {
                count.rounded(ply)
            } else {
                count.map(|_, plies| plies * ply)
            })),
            (None, angles) => angles.map(|angles| Stack::Plies(ply, angles)),
        }
    }
}

/// Notes a ramp beside a profile that is zero at both ends, where no ramp is.
fn has_ramp(table: &Table<'_>, profile: &[[f64; 2]]) {
    let ends = [profile.first(), profile.last()];
    let are_zero = ends.iter().all(|end| end.is_some_and(|end| end[1] == 0.0));
    if are_zero && table.has(&TAPER) {
        let layer = text(table, NAME.name());
        table.note(&TAPER, &LayupFileProblem::Ramp { layer });
    }
}

/// The ends of a layer, of which one follows from its width if that is given; notes problems.
fn by_width(table: &Table<'_>, [from, to]: [Place; 2]) -> Option<[Place; 2]> {
    let Some(width) = table.get(&WIDTH)? else {
        return Some([from, to]);
    };
    match [table.has(&FROM), table.has(&TO)] {
        [true, false] => {
            let end = from.clone().shifted(&width, 1.0);
            Some([from, end])
        }
        [false, true] => Some([to.clone().shifted(&width, -1.0), to]),
        _ => {
            let layer = text(table, NAME.name());
            table.note(&WIDTH, &LayupFileProblem::Width { layer });
            None
        }
    }
}

/// First and last position along the span of a web or fill; notes problems.
pub(super) fn range(table: &Table<'_>, name: &str) -> Option<[f64; 2]> {
    if !table.has(&RANGE) {
        return Some([0.0, 1.0]);
    }
    let positions = table.quantities(RANGE.name(), Dimension::NUMBER)?;
    match positions[..] {
        [from, to] if from >= 0.0 && from < to && to <= 1.0 => Some([from, to]),
        _ => {
            let (name, list) = (name.to_owned(), table.is_list(&RANGE));
            let found = match positions[..] {
                [one] if !list => one.to_string(),
                _ => format!("{positions:?}"),
            };
            table.note(&RANGE, &LayupFileProblem::Range { name, found });
            None
        }
    }
}

/// The angles of single plies \[rad\]; notes problems.
fn angles_of_plies(table: &Table<'_>) -> Option<Vec<f64>> {
    let item = table.item(&ANGLES);
    let written = item.as_ref().and_then(Item::text);
    if written.is_some_and(|text| text.contains('/')) {
        let expected = "a list of angles, as [45, -45], the outermost ply first";
        table.wrong(&ANGLES, expected);
        return None;
    }
    let angles = table.quantities(ANGLES.name(), Dimension::ANGLE)?;
    if angles.is_empty() {
        table.wrong(&ANGLES, "one angle or more");
        return None;
    }
    if !angles.iter().all(|angle| is_within_a_turn(*angle)) {
        table.wrong(&ANGLES, &format!("for each ply {WITHIN_A_TURN}"));
        return None;
    }
    Some(angles)
}

/// A text, empty if it is none, which has been noted.
fn text(table: &Table<'_>, key: &str) -> String {
    let text = table.is_text(key).then(|| table.text(key));
    text.flatten().unwrap_or_default()
}
