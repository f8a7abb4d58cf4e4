//! Points and lines of the file by their names, in the axes z of the file.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use shared_geom::document::read_text;
use shared_geom::exchange::text::{lines as rows, number};

use super::Points;
use super::files::{Element, Notes};
use crate::mesh::distance;

mod airfoil;
mod arcs;
mod lines;

/// Largest number of points and lines that refer to each other in a row.
const DEEPEST: usize = 60;

/// The map from the axes z of the file to the axes x of the section.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placement {
    translate: [f64; 2],
    scale: f64,
    /// Cosine and sine of the rotation.
    turn: [f64; 2],
}

impl Placement {
    /// The placement of `<general>`; notes problems.
    pub fn read(main: Element<'_>, notes: &mut Notes) -> Option<Self> {
        let general = main.child("general");
        let given = |name: &str| general?.child(name).filter(|one| !one.text().is_empty());
        let translate = match given("translate") {
            Some(one) => one.numbers::<2>(notes),
            None => Some([0.0; 2]),
        };
        let scale = match given("scale") {
            Some(one) => positive(one, notes),
            None => Some(1.0),
        };
        let rotate = match given("rotate") {
            Some(one) => one.numbers::<1>(notes).map(|one| one[0]),
            None => Some(0.0),
        };
        let (sine, cosine) = rotate?.to_radians().sin_cos();
        Some(Self {
            translate: translate?,
            scale: scale?,
            turn: [cosine, sine],
        })
    }

    /// A point in the axes x.
    pub fn at(&self, point: [f64; 2]) -> [f64; 2] {
        let [a, b] = [0, 1].map(|i| self.scale * (point[i] + self.translate[i]));
        let [cosine, sine] = self.turn;
        [cosine * a - sine * b, sine * a + cosine * b]
    }
}

/// A positive number; notes another text.
pub(super) fn positive(at: Element<'_>, notes: &mut Notes) -> Option<f64> {
    let [value] = at.numbers::<1>(notes)?;
    if value > 0.0 {
        return Some(value);
    }
    let help = "lengths, factors and moduli are positive";
    notes.wrong(
        at,
        [&at.shown(), &format!("{value}"), "a positive number", help],
    );
    None
}

/// The kind of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Straight lines between points.
    Straight,
    /// Points of a curve.
    Curve,
    /// A straight line without ends.
    Endless,
}

/// A line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    pub points: Points,
    pub kind: Kind,
}

impl Line {
    /// Whether its last point is its first one.
    pub fn is_closed(&self) -> bool {
        let (first, last) = (self.points[0], self.points[self.points.len() - 1]);
        self.points.len() > 2 && distance(first, last) <= 1e-9 * extent(&self.points)
    }
}

/// The diagonal of the rectangle around points.
pub(super) fn extent(points: &[[f64; 2]]) -> f64 {
    let width = |i: usize| {
        let values = || points.iter().map(|point| point[i]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    width(0).hypot(width(1))
}

/// A point, and its place on a line: the name of the line and the number of the segment with the
/// part of it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spot {
    pub at: [f64; 2],
    pub on: Option<(String, f64)>,
}

/// A point as written.
#[derive(Debug, Clone, Copy)]
enum Written<'x> {
    Given([f64; 2]),
    Element(Element<'x>),
}

impl Written<'_> {
    /// Whether another one is not the same row of a file; rows may repeat a point.
    fn differs(&self, other: &Self) -> bool {
        !matches!((self, other), (Self::Given(a), Self::Given(b)) if a == b)
    }
}

/// All points and lines of the files.
pub(super) struct Geometry<'x> {
    points: Vec<(String, Written<'x>)>,
    lines: Vec<(&'x str, Element<'x>)>,
    /// The folder of the main file.
    pub folder: PathBuf,
    spots: HashMap<String, Option<Spot>>,
    known: HashMap<String, Option<Rc<Line>>>,
    /// Names that are being read.
    path: Vec<String>,
}

impl<'x> Geometry<'x> {
    /// The points and lines of `<baselines>`; notes files of points that cannot be read.
    pub fn new(parts: &[Element<'x>], path: &Path, notes: &mut Notes) -> Self {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let (mut points, mut all) = (Vec::new(), Vec::new());
        for part in parts {
            if let Some(name) = part.attribute("basepoints").filter(|name| !name.is_empty()) {
                points.extend(points_of_file(*part, name, (folder.as_path(), 1.0), notes));
            }
            let groups = part.named("basepoints");
            for include in groups.flat_map(|group| group.named("include")) {
                let scale = include.attribute("scale").map_or(Some(1.0), number);
                if scale.is_none() {
                    let found = include.attribute("scale").unwrap_or_default();
                    let help = "the coordinates of the file are multiplied by it";
                    notes.wrong(
                        include,
                        ["scale", &format!("\"{found}\""), "a number", help],
                    );
                }
                let name = include.text();
                let from = (folder.as_path(), scale.unwrap_or(1.0));
                points.extend(points_of_file(include, &name, from, notes));
            }
            let groups = part
                .named("basepoints")
                .flat_map(|group| group.named("point"));
            for point in groups.chain(part.named("point")) {
                let name = point.required_name(notes).map(str::to_owned);
                points.extend(name.map(|name| (name, Written::Element(point))));
            }
            let lines = part.children();
            for line in lines.filter(|one| matches!(one.name(), "line" | "baseline")) {
                all.extend(line.required_name(notes).map(|name| (name, line)));
            }
        }
        Self {
            points,
            lines: all,
            folder,
            spots: HashMap::new(),
            known: HashMap::new(),
            path: Vec::new(),
        }
    }

    /// The line of a name, which the element `at` uses; notes problems.
    pub fn line(&mut self, name: &str, at: Element<'_>, notes: &mut Notes) -> Option<Rc<Line>> {
        if let Some(known) = self.known.get(name) {
            return known.clone();
        }
        let Some((_, element)) = self.lines.iter().rev().find(|one| one.0 == name).copied() else {
            let names: Vec<&str> = self.lines.iter().map(|one| one.0).collect();
            notes.unknown(at, ["the base line", name], &names);
            return None;
        };
        let count = self.lines.iter().filter(|one| one.0 == name).count();
        notes.again(element, count > 1);
        self.enter(name, at, notes)?;
        let made = self.made(name, element, notes);
        self.path.pop();
        let made = made
            .and_then(|line| checked(line, element, notes))
            .map(Rc::new);
        self.known.insert(name.to_owned(), made.clone());
        made
    }

    /// Begins to read a name; notes names that refer to themselves.
    fn enter(&mut self, name: &str, at: Element<'_>, notes: &mut Notes) -> Option<()> {
        let is_circle = self.path.iter().any(|known| known == name);
        if is_circle || self.path.len() >= DEEPEST {
            let found = if is_circle {
                format!("{} -> {name}", self.path.join(" -> "))
            } else {
                format!("more than {DEEPEST} names that refer to each other")
            };
            let help = "define one of them by coordinates";
            let what = "points and base lines";
            notes.wrong(
                at,
                [what, &found, "names that do not refer to themselves", help],
            );
            return None;
        }
        self.path.push(name.to_owned());
        Some(())
    }

    fn made(&mut self, name: &str, element: Element<'x>, notes: &mut Notes) -> Option<Line> {
        let method = element.attribute("method").unwrap_or("direct");
        let kind = element.attribute("type").unwrap_or("straight");
        match (method, kind) {
            ("join", _) => lines::joined(self, element, notes),
            ("direct", "straight" | "") => lines::straight(self, element, notes),
            ("direct", "arc") => arcs::arc(self, element, notes),
            ("direct", "circle") => arcs::circle(self, element, notes),
            ("direct", "airfoil") => airfoil::read(&self.folder, element, notes),
            _ => {
                let what = format!("type of base line \"{name}\"");
                let found = format!("\"{kind}\" with method \"{method}\"");
                let expected = "type straight, arc, circle or airfoil, method direct or join";
                let help = "other curves are lines through their points";
                notes.wrong(element, [&what, &found, expected, help]);
                None
            }
        }
    }

    /// The point of a name, which the element `at` uses; notes problems.
    pub fn point(&mut self, name: &str, at: Element<'_>, notes: &mut Notes) -> Option<Spot> {
        if let Some(known) = self.spots.get(name) {
            return known.clone();
        }
        let found = self
            .points
            .iter()
            .find(|one| one.0 == name)
            .map(|one| one.1);
        let Some(found) = found else {
            let edge = self.edge(name, notes);
            if edge.is_none() {
                let names: Vec<&str> = self.points.iter().map(|one| one.0.as_str()).collect();
                notes.unknown(at, ["the point", name], &names);
            }
            return edge;
        };
        let mut others = self.points.iter().filter(|one| one.0 == name).skip(1);
        if others.any(|other| other.1.differs(&found)) {
            notes.remarks.push(format!(
                "the point \"{name}\" is defined twice, and the first one is used"
            ));
        }
        self.enter(name, at, notes)?;
        let spot = match found {
            Written::Given(at) => Some(Spot { at, on: None }),
            Written::Element(element) => lines::spot(self, element, notes),
        };
        self.path.pop();
        self.spots.insert(name.to_owned(), spot.clone());
        spot
    }

    /// The leading or trailing edge of an airfoil by its name: `LINE_le`, `LINE_te`, or the name
    /// that the file gives it.
    fn edge(&mut self, name: &str, notes: &mut Notes) -> Option<Spot> {
        let of = |(line, element): &(&'x str, Element<'x>)| {
            let edges = [("leading_edge", "_le"), ("trailing_edge", "_te")];
            let is_it = |(key, ending): &(&str, &str)| {
                let given = element.child(key).and_then(|one| one.attribute("name"));
                given.map_or_else(|| format!("{line}{ending}") == name, |given| given == name)
            };
            let edge = edges.iter().position(is_it)?;
            let is_airfoil = element.attribute("type") == Some("airfoil");
            is_airfoil.then_some(((*line).to_owned(), *element, edge))
        };
        let (line, element, edge) = self.lines.iter().find_map(of)?;
        let points = self.line(&line, element, notes)?;
        let points = &points.points;
        let far = |i: &usize| distance(points[*i], points[0]);
        let index = match edge {
            0 => (0..points.len()).max_by(|a, b| far(a).total_cmp(&far(b)))?,
            _ => 0,
        };
        let on = Some((line, index as f64));
        Some(Spot {
            at: points[index],
            on,
        })
    }

    /// The points of the list from one name to another, both included.
    pub fn range(
        &mut self,
        names: [&str; 2],
        at: Element<'_>,
        notes: &mut Notes,
    ) -> Option<Points> {
        let [from, to] = names.map(|name| self.points.iter().position(|one| one.0 == name));
        let (Some(from), Some(to)) = (from, to) else {
            let known: Vec<&str> = self.points.iter().map(|one| one.0.as_str()).collect();
            let absent = if from.is_none() { names[0] } else { names[1] };
            notes.unknown(at, ["the point", absent], &known);
            return None;
        };
        if to < from {
            let what = format!("the points {}:{}", names[0], names[1]);
            let help = "points of a range are in the order in which they are defined";
            notes.wrong(
                at,
                [
                    &what,
                    "the second one before the first one",
                    "its order",
                    help,
                ],
            );
            return None;
        }
        let names: Vec<String> = self.points[from..=to]
            .iter()
            .map(|one| one.0.clone())
            .collect();
        let mut points = Vec::with_capacity(names.len());
        for (name, index) in names.iter().zip(from..) {
            // names of points between may be equal
            let spot = match self.points[index].1 {
                Written::Given(at) => at,
                Written::Element(_) => self.point(name, at, notes)?.at,
            };
            points.push(spot);
        }
        Some(points)
    }
}

/// Notes lines without two different points.
fn checked(line: Line, element: Element<'_>, notes: &mut Notes) -> Option<Line> {
    let mut points = line.points;
    let least = 1e-12 * extent(&points);
    points.dedup_by(|a, b| distance(*a, *b) <= least);
    let size = extent(&points);
    if points.len() < 2 || !(size > 0.0 && size.is_finite()) {
        let found = format!("{} different points", points.len().min(1));
        let help = "a base line has two points or more";
        notes.wrong(element, [&element.shown(), &found, "two or more", help]);
        return None;
    }
    Some(Line { points, ..line })
}

/// The points of a file of three columns; notes problems.
fn points_of_file<'x>(
    at: Element<'x>,
    name: &str,
    (folder, scale): (&Path, f64),
    notes: &mut Notes,
) -> Vec<(String, Written<'x>)> {
    let mut file = folder.join(format!("{name}.dat"));
    if folder.join(name).is_file() {
        file = folder.join(name);
    }
    notes.problems.turn_to(at.file);
    let is_there = notes
        .problems
        .finds(&file, "the file of points", name, at.line());
    let text = if is_there {
        notes.problems.keep(read_text(&file))
    } else {
        None
    };
    let mut points = Vec::new();
    for line in rows(text.as_deref().unwrap_or_default()) {
        let words: Vec<&str> = line.words().collect();
        let values: Vec<f64> = words
            .iter()
            .skip(1)
            .filter_map(|word| number(word))
            .collect();
        match values[..] {
            [y, z] if words.len() == 3 => {
                let at = [scale * y, scale * z];
                points.push((words[0].to_owned(), Written::Given(at)));
            }
            _ => {
                let help = "a row is the name of a point and its two coordinates";
                let found = format!("\"{}\"", shared_geom::error::shortened(line.text));
                let expected = "a name and two numbers";
                notes.wrong_on(&file, line.number, ["the row", &found, expected, help]);
            }
        }
    }
    points
}
