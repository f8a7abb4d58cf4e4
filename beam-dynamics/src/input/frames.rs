//! Reference frames in which cards are written: `[[frame]]`, and the frames of the copies
//! of `[[repeat]]`.
//!
//! A point p of a frame at x with the axes A is at `x + A p`, a direction d points along
//! `A d`; frames may be in frames.

use shared_geom::document::schema::ValueKind::{Count, Quantity, Text, Vector};
use shared_geom::keys;
use std::cell::RefCell;
use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::{Document, Table};
use shared_geom::error::{Explain, nearest_name};
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::problem::InputProblem;

keys! {
    /// A frame in which cards are written; fixed in the undeformed model.
    pub(super) CARD = "[[frame]]";
    /// The name of the frame.
    NAME: String = "name", [Text], required, "\"nacelle\"";
    /// Position of its origin.
    POSITION: Vector3<f64> = "position", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 80]";
    /// Rotation vector of its axes.
    ORIENTATION: Vector3<f64> = "orientation", [Vector(3, Dimension::ANGLE)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, -5, 0]";
    /// Rotation about an axis, in place of `orientation`.
    TURN: Option<f64> = "turn", [Quantity(Dimension::ANGLE)], optional, "30";
    with AXIS.schema, CENTER.schema, IN.schema;
}

keys! {
    /// The name of the frame in which the card is written.
    pub(super) IN: Option<String> = "in", [Text], or "the frame of the model", "\"rotor\"";
    /// Axis of the rotation, of any length.
    pub(super) AXIS: Vector3<f64> = "axis", [Vector(3, Dimension::NUMBER)],
        or "[0, 0, 1]" = Vector3::z(), "[1, 0, 0]";
    /// A point on the axis.
    pub(super) CENTER: Vector3<f64> = "center", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 80]";
    /// The name of the copies' frames.
    pub(super) REPEAT_NAME: Option<String> = "name", [Text], or "`repeat` and its number", "\"arm\"";
    /// Number of copies, evenly spaced over a turn.
    pub(super) COPIES: usize = "count", [Count(usize::MAX)], required, "3";
}

/// Cards that may be written in a frame.
pub(super) const FRAMED: [&str; 11] = [
    "node",
    "load",
    "distributed_load",
    "imposed",
    "internal_force",
    "hinge",
    "joint",
    "spring",
    "strip",
    "frame",
    "repeat",
];

/// A frame in the model's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    position: Vector3<f64>,
    rotation: Matrix3<f64>,
}

impl Default for Frame {
    fn default() -> Self {
        Self {
            position: Vector3::zeros(),
            rotation: Matrix3::identity(),
        }
    }
}

impl Frame {
    /// A point of the frame.
    pub fn point(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.position + self.rotation * point
    }

    /// A direction of the frame.
    pub fn direction(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * direction
    }

    /// Axes that are written in the frame.
    pub fn axes(&self, axes: &Matrix3<f64>) -> Matrix3<f64> {
        self.rotation * axes
    }

    fn inner(&self, inner: &Self) -> Self {
        Self {
            position: self.point(&inner.position),
            rotation: self.axes(&inner.rotation),
        }
    }
}

/// A problem of a frame.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FrameProblem {
    /// A frame that does not exist.
    #[error("unknown frame \"{name}\"")]
    Unknown {
        /// The name.
        name: String,
        /// The frames of the input.
        known: Vec<String>,
    },
    /// Frames that contain each other.
    #[error("the frame \"{}\" is in itself: {}", .chain[0], .chain.join(" in "))]
    Cycle {
        /// The frames, from one back to it.
        chain: Vec<String>,
    },
    /// An orientation that is given twice.
    #[error("the frame has \"orientation\" and \"turn\", expected one of them")]
    TwoTurns,
}

impl Explain for FrameProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unknown { name, known } => {
                let near = nearest_name(name, known.iter().map(String::as_str));
                Some(match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None if known.is_empty() => "add it: [[frame]]".to_owned(),
                    None => format!("frames: {}", known.join(", ")),
                })
            }
            Self::Cycle { .. } | Self::TwoTurns => None,
        }
    }
}

/// The frames of an input by name; wrong frames are `None`.
#[derive(Debug, Clone, Default)]
pub(super) struct Frames(BTreeMap<String, Option<Frame>>);

impl Frames {
    /// The frame of a card: the frame under `in`, else the model's. `None` if it is wrong.
    pub fn of(&self, table: &Table<'_>) -> Option<Frame> {
        let Some(name) = table.get(&IN)? else {
            return Some(Frame::default());
        };
        let Some(found) = self.0.get(&name) else {
            let known = self.0.keys().cloned().collect();
            table.note(&IN, &FrameProblem::Unknown { name, known });
            return None;
        };
        *found
    }

    /// The axes (columns) of the frame called `name`, in the model's frame: `None` if there
    /// is no frame of this name, `Some(None)` if it is wrong, which has been noted.
    pub fn axes_of(&self, name: &str) -> Option<Option<Matrix3<f64>>> {
        let found = self.0.get(name)?;
        Some(found.map(|frame| frame.rotation))
    }

    /// Names of the frames.
    pub fn names(&self) -> impl Iterator<Item = &String> {
        self.0.keys()
    }
}

/// Makes the copies of `[[repeat]]`; `false` if there are too many.
pub(super) fn repeat(document: &mut Document) -> bool {
    document.repeat(&FRAMED)
}

/// Reads every `[[frame]]`, and the remaining keys of each `[[repeat]]`.
pub(super) fn read(root: &Table<'_>) -> Frames {
    for table in root.tables("repeat") {
        let _ = table.has(&IN);
        let _ = table.get(&REPEAT_NAME);
        let _ = table.get(&COPIES);
        let _ = axis(&table);
        let _ = table.get(&CENTER);
        table.finish();
    }
    let tables = root.tables("frame");
    let reader = Reader {
        tables: named(&tables),
        done: RefCell::default(),
        open: RefCell::default(),
    };
    for name in reader.tables.keys() {
        reader.find(name);
    }
    Frames(reader.done.into_inner())
}

/// The tables by their names; notes duplicate names.
fn named<'a, 'd>(tables: &'a [Table<'d>]) -> BTreeMap<String, &'a Table<'d>> {
    let mut named: BTreeMap<String, &Table<'_>> = BTreeMap::new();
    for table in tables {
        let Some(name) = table.get(&NAME) else {
            continue;
        };
        if let Some(first) = named.get(&name) {
            let kind = "frame";
            let line = table.document().line_words(first.line_of(&NAME));
            table.note(&NAME, &InputProblem::DoubledName { kind, name, line });
            continue;
        }
        named.insert(name, table);
    }
    named
}

/// Frames during reading.
struct Reader<'a, 'd> {
    tables: BTreeMap<String, &'a Table<'d>>,
    done: RefCell<BTreeMap<String, Option<Frame>>>,
    /// Names that are being read, each in the next.
    open: RefCell<Vec<String>>,
}

impl Reader<'_, '_> {
    fn find(&self, name: &str) -> Option<Frame> {
        if let Some(found) = self.done.borrow().get(name) {
            return *found;
        }
        let table = self.tables.get(name)?;
        self.open.borrow_mut().push(name.to_owned());
        let own = frame(table);
        let outer = self.outer(table);
        table.finish();
        let frame = own.zip(outer).map(|(own, outer)| outer.inner(&own));
        self.open.borrow_mut().pop();
        self.done.borrow_mut().insert(name.to_owned(), frame);
        frame
    }

    /// The frame that contains a frame.
    fn outer(&self, table: &Table<'_>) -> Option<Frame> {
        let Some(name) = table.get(&IN)? else {
            return Some(Frame::default());
        };
        let open = self.open.borrow().clone();
        if let Some(first) = open.iter().position(|own| *own == name) {
            let chain = open[first..].iter().cloned().chain([name]).collect();
            table.note(&IN, &FrameProblem::Cycle { chain });
            return None;
        }
        if !self.tables.contains_key(&name) {
            let known = self.tables.keys().cloned().collect();
            table.note(&IN, &FrameProblem::Unknown { name, known });
            return None;
        }
        self.find(&name)
    }
}

/// The frame of a card, in the frame that contains it: at `position` with `orientation`,
/// or turned by `turn` about an `axis` through a `center`.
fn frame(table: &Table<'_>) -> Option<Frame> {
    let (position, orientation) = (table.get(&POSITION), table.get(&ORIENTATION));
    if !table.has(&TURN) {
        return Some(Frame {
            position: position?,
            rotation: vector::to_rotation(&orientation?),
        });
    }
    if table.has(&ORIENTATION) {
        table.note(&TURN, &FrameProblem::TwoTurns);
        return None;
    }
    let (turn, axis, center) = (table.get(&TURN), axis(table), table.get(&CENTER));
    let (turn, center) = (turn??, center?);
    let rotation = if turn == 0.0 {
        Matrix3::identity()
    } else {
        vector::to_rotation(&(turn * axis?))
    };
    // p -> c + A (p - c), then moved.
    let position = position? + center - rotation * center;
    Some(Frame { position, rotation })
}

/// The axis of the turn, of unit length: z by default.
fn axis(table: &Table<'_>) -> Option<Vector3<f64>> {
    let unit = table.get(&AXIS)?.try_normalize(0.0);
    if unit.is_none() {
        table.note(&AXIS, &InputProblem::NoAxis);
    }
    unit
}
