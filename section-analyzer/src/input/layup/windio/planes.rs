//! Planes of a windIO blade along the span, by which webs and caps are placed.
//!
//! With the twist T (nose down), the axis (x, y, z), x toward the suction side and y toward the
//! trailing edge, a plane turned by an angle R about z has the normal
//!
//! ```text
//! n = cos(R) y + sin(R) x = cos(T - R) t - sin(T - R) u
//! ```
//!
//! in the directions t of the chord, aft, and u toward the suction side. A plane of version 2
//! through the points 1 and 2 of the axis, shifted by o, is at the distance
//!
//! ```text
//! d = e_1 + (e_2 - e_1) (z - z_1)/(z_2 - z_1) - e + o sqrt(1 + ((e_2 - e_1)/(z_2 - z_1))^2),
//! e = cos(R) y + sin(R) x
//! ```
//!
//! behind the axis. In version 1, R is the opposite of `rotation`, and d = `offset_y_pa`. Before version 1.0,
//! d = `offset_x_pa` along the chord turned by `rotation`, T - R: webs that are straight along the span have
//! the twist as their rotation.

use shared_geom::exchange::reference_line;
use shared_geom::exchange::windio_fields::{Column, axis, column, numbers};
use shared_geom::exchange::yaml::Node;
use shared_geom::line::ReferenceLine;

use super::super::course::Course;
use super::super::place::PlaceForm;
use super::angles::{self, Angle};
use super::version::Version;
use super::{Notes, course, remark_on_ends, required};

/// Distance of a plane from the axis in version 1.
pub(super) const OFFSET: &str = "offset_y_pa";
/// The same in files before version 1.0, along the chord turned by the rotation.
pub(super) const FORMER: &str = "offset_x_pa";

/// The key that has the distance of the plane of a web or layer of version 1.
pub(super) fn offset_key(item: &Node) -> Option<&'static str> {
    let mut keys = [OFFSET, FORMER].into_iter();
    keys.find(|key| item.entry(key).is_some())
}

/// Notes an axis that does not lead from the root to the tip, and remarks on columns that end before it.
fn outward(axis: &[Column; 3], line: usize, notes: &mut Notes) -> Option<()> {
    for (column, key) in axis.iter().zip(["x", "y", "z"]) {
        let what = format!("{key} of reference_axis");
        remark_on_ends((&what, line), &column.grid, notes);
    }
    let Column { grid, values } = &axis[2];
    let (root, tip) = (values.first()?, values.last()?);
    let back = (1..values.len()).find(|i| values[*i] <= values[*i - 1]);
    let [found, help] = match back {
        None => return Some(()),
        Some(_) if tip <= root => [
            format!("z from {root} at the root to {tip} at the tip"),
            "turn the signs of z, or the order of the values".to_owned(),
        ],
        Some(i) => [
            format!(
                "z = {} at {} after {} at {}",
                values[i],
                grid[i],
                values[i - 1],
                grid[i - 1]
            ),
            "correct the values of z there".to_owned(),
        ],
    };
    let expected = "z that grows from root to tip";
    notes.wrong(line, ["reference_axis", &found, expected, &help]);
    None
}

/// The directions of the sections of a blade.
pub(super) struct Tilt {
    twist: Course,
    axis: [Course; 3],
    version: Version,
    /// The reference line, in our axes.
    pub line: ReferenceLine,
}

impl Tilt {
    /// Reads the twist and the axis of a blade from the text of a file.
    pub fn read(
        blade: &Node,
        outer: &Node,
        (version, text): (Version, &str),
        notes: &mut Notes,
    ) -> Option<Self> {
        let twist = required(outer, "the outer shape", "twist", notes)
            .and_then(|at| column(at, "twist", &mut notes.problems));
        let holder = match version {
            Version::One => outer,
            Version::Two => blade,
        };
        let node = required(holder, "the blade", "reference_axis", notes);
        let columns = node.and_then(|at| axis(at, &mut notes.problems));
        let (mut twist, columns) = (twist?, columns?);
        let place = outer.entry("twist").map_or(outer.line, |node| node.line);
        let pairs = twist.grid.iter().copied().zip(twist.values.iter().copied());
        angles::check(version, ("twist", place), pairs, Angle::Small, notes)?;
        for angle in &mut twist.values {
            *angle *= version.angle();
        }
        remark_on_ends(("twist", place), &twist.grid, notes);
        outward(&columns, node.map_or(0, |node| node.line), notes)?;
        let line = reference_line(&columns, &twist, text, &mut notes.remarks);
        let problems = line.problems();
        if let Some(problem) = problems.first() {
            let (found, help) = (problem.to_string(), "correct the axis");
            let place = node.map_or(0, |node| node.line);
            notes.wrong(
                place,
                ["reference_axis", &found, "a line from root to tip", help],
            );
            return None;
        }
        Some(Self {
            twist: Course::monotone(twist.grid, twist.values),
            axis: columns.map(|column| Course::monotone(column.grid, column.values)),
            version,
            line,
        })
    }

    /// The plane of `offset_y_pa` and `rotation` of a web or layer of version 1.
    pub fn version_1(
        &self,
        item: &Node,
        of: &str,
        side: usize,
        notes: &mut Notes,
    ) -> Option<PlaceForm> {
        let key = offset_key(item).unwrap_or(OFFSET);
        let is_former = key == FORMER;
        let offset = required(item, of, key, notes)
            .and_then(|at| course(at, &format!("{key} of {of}"), notes));
        let angle = match item.entry("rotation") {
            Some(node) if node.entry("fixed").is_some() && is_former => Some(self.twist.clone()),
            // "twist" is a plane normal to the chord
            Some(node) if node.entry("fixed").is_some() => Some(Course::constant(0.0)),
            Some(node) => {
                let what = format!("rotation of {of}");
                let rotation = course(node, &what, notes)?;
                let at = (what.as_str(), node.line);
                angles::check(self.version, at, rotation.points(), Angle::Any, notes)?;
                Some(match is_former {
                    true => rotation,
                    false => self.twist.plus(&rotation, 1.0),
                })
            }
            None if is_former => Some(Course::constant(0.0)),
            None => Some(self.twist.clone()),
        };
        Some(PlaceForm::Plane(offset?, angle?, side))
    }

    /// The plane of `plane_intersection` of an anchor of version 2.
    pub fn version_2(
        &self,
        rule: &Node,
        of: &str,
        side: usize,
        notes: &mut Notes,
    ) -> Option<PlaceForm> {
        let what = format!("plane_intersection of {of}");
        let offset = required(rule, &what, "offset", notes)
            .and_then(|at| course(at, &format!("offset of {what}"), notes));
        let curve = rule.entry("plane_type2");
        let plane = match curve {
            Some(node) => node,
            None => required(rule, &what, "plane_type1", notes)?,
        };
        let name = plane.entry("anchor_curve").and_then(Node::text);
        if name.is_some_and(|name| name != "reference_axis") {
            let found = format!("\"{}\"", name.unwrap_or_default());
            let help = "give the arcs of the anchor";
            notes.wrong(
                plane.line,
                ["anchor_curve", &found, "\"reference_axis\"", help],
            );
            return None;
        }
        let turn = match plane.entry("rotation") {
            Some(node) => {
                let turn = node.text().and_then(shared_geom::exchange::text::number);
                if turn.is_none() {
                    let what = format!("rotation of {what}");
                    notes.wrong(
                        node.line,
                        [&what, &node.kind(), "an angle", "write a number"],
                    );
                }
                self.version.angle() * turn?
            }
            None => 0.0,
        };
        let distance = match curve {
            Some(_) => offset?,
            None => {
                let ends = match plane.entry("anchors_nd_grid") {
                    Some(node) => numbers(node, "anchors_nd_grid", &mut notes.problems)?,
                    None => vec![0.0, 1.0],
                };
                self.shifted(&offset?, turn, [ends.first(), ends.last()])
            }
        };
        let angle = self.twist.map(|_, twist| twist - turn);
        Some(PlaceForm::Plane(distance, angle, side))
    }

    /// Distance behind the axis of the plane through two of its points, shifted by an offset.
    fn shifted(&self, offset: &Course, turn: f64, ends: [Option<&f64>; 2]) -> Course {
        let (sine, cosine) = turn.sin_cos();
        let [x, y, z] = &self.axis;
        let point = |eta: f64| [z.at(eta), cosine * y.at(eta) + sine * x.at(eta)];
        let [first, second] = ends.map(|end| point(end.copied().unwrap_or(0.0)));
        let slope = match second[0] - first[0] {
            run if run.abs() > 1e-9 => (second[1] - first[1]) / run,
            _ => 0.0,
        };
        let both = offset.plus(&y.plus(x, sine), 0.0);
        let distance = both.map(|eta, offset| {
            let [z, e] = point(eta);
            first[1] + slope * (z - first[0]) - e + offset * slope.hypot(1.0)
        });
        match offset.positions() {
            [from, .., to] => distance.within([*from, *to]),
            _ => distance,
        }
    }
}
