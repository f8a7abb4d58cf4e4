//! `[[joint]]`: joints of every kind between two nodes, or between the frame and a node.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::KeySchema;
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::AXIS_IN;
use super::keys::{
    ANGLE, ANGULAR_VELOCITY, AT, AXES, DISPLACEMENT, DISPLACEMENTS, FREEDOMS, FROM, JOINT, KIND,
    LENGTH, LOCKED, NAME, NODES, ORIENTATION, ROTATION, SPEED, VELOCITY,
};
use super::problem::JointProblem;
use crate::elements::Signal;
use crate::elements::joints::{ConstraintJoint, Freedom, JointEnds, Placing, Turning, axes_along};
use crate::input::builder::ModelBuilder;
use crate::input::driven_joint::DrivenJoint;
use crate::input::drives;
use crate::input::ends;
use crate::input::frames::Frame;
use crate::model::{Drive, Node};

/// Other words for kinds of joints.
const OTHER_WORDS: [(&str, &str); 12] = [
    ("hinge", "revolute"),
    ("pin", "revolute"),
    ("pinned", "revolute"),
    ("ball", "spherical"),
    ("fixed", "clamp"),
    ("rigid", "clamp"),
    ("weld", "clamp"),
    ("slider", "prismatic"),
    ("cardan", "universal"),
    ("hooke", "universal"),
    ("rod", "distance"),
    ("motor", "spin"),
];
/// Sine below which axes are treated as parallel, and part of the size of the model below which
/// points coincide: digits lost in the input.
const ROUNDING: f64 = 1e-9;

/// The constraint of a joint, as in its card.
enum Holds {
    Clamp,
    Spherical,
    Revolute(Option<Turning>),
    Cylindrical(Freedom, Option<Turning>),
    Universal,
    Prismatic(Freedom),
    InLine,
    InPlane(Option<Signal>),
    PlaneRotation(Option<Turning>),
    Distance(Option<Signal>),
    Velocity([Option<Signal>; 6]),
    Spin(Turning),
    Total([Freedom; 6]),
}

impl Holds {
    /// The joint `name`, if it is driven in time.
    fn driven(&self, name: &str) -> Option<DrivenJoint> {
        fn along(freedom: &Freedom) -> Option<&Signal> {
            match freedom {
                Freedom::Driven(signal) => Some(signal),
                Freedom::Free | Freedom::Locked => None,
            }
        }
        let mut positions: Vec<&Signal> = Vec::new();
        let mut speeds = Vec::new();
        match self {
            Self::Clamp | Self::Spherical | Self::Universal | Self::InLine => {}
            Self::InPlane(signal) | Self::Distance(signal) => positions.extend(signal),
            Self::Velocity(signals) => speeds.extend(signals.iter().flatten()),
            Self::Prismatic(freedom) | Self::Cylindrical(freedom, _) => {
                positions.extend(along(freedom));
            }
            Self::Total(freedoms) => positions.extend(freedoms.iter().filter_map(along)),
            Self::Revolute(_) | Self::PlaneRotation(_) | Self::Spin(_) => {}
        }
        let turning = match self {
            Self::Revolute(turning)
            | Self::Cylindrical(_, turning)
            | Self::PlaneRotation(turning) => turning.as_ref(),
            Self::Spin(turning) => Some(turning),
            _ => None,
        };
        match turning {
            Some(Turning::Angle(angle)) => positions.push(angle),
            Some(Turning::Speed(speed)) => speeds.push(speed),
            None => {}
        }
        DrivenJoint::new(name, &positions, &speeds)
    }
}

/// Points of a card; `None` if not given.
struct Points {
    /// On the second end, and on the first unless it has its own.
    at: Option<Vector3<f64>>,
    /// On the first.
    from: Option<Vector3<f64>>,
}

/// Axes of a card.
struct Axes {
    of_ends: [Matrix3<f64>; 2],
    in_node: bool,
}

impl Points {
    /// The points of a card that is written in a frame.
    fn in_frame(&self, frame: &Frame) -> Self {
        let [at, from] = [self.at, self.from].map(|point| point.map(|point| frame.point(&point)));
        Self { at, from }
    }
}

impl Axes {
    /// The axes of a card that is written in a frame.
    fn in_frame(self, frame: &Frame) -> Self {
        if self.in_node {
            self
        } else {
            Self {
                of_ends: self.of_ends.map(|axes| frame.axes(&axes)),
                ..self
            }
        }
    }
}

/// Adds every `[[joint]]` to the model.
pub(in crate::input) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("joint").iter().enumerate() {
        let label = ends::label(table, &NAME, "joint", number);
        let is_new = builder.take_label("joint", &label, table);
        let nodes = nodes(table, builder, &format!("joint \"{label}\""));
        // The keys of an unknown kind are not checked.
        let Some(kind) = table.choice_or_meant(&JOINT, KIND[0], &OTHER_WORDS) else {
            builder.note_broken();
            continue;
        };
        let holds = holds(kind, table, builder);
        if let Some(joint) = holds.as_ref().and_then(|holds| holds.driven(&label)) {
            builder.note_driven(joint);
        }
        let frame = builder.frames().of(table);
        let points = points(kind, table).zip(frame);
        let points = points.map(|(points, frame)| points.in_frame(&frame));
        let axes = axes(kind, table).zip(frame);
        let axes = axes.map(|(axes, frame)| axes.in_frame(&frame));
        table.finish();
        let joint = match (nodes, holds, points, axes) {
            (Some(nodes), Some(holds), Some(points), Some(axes)) if is_new => joint(
                &label,
                &nodes,
                builder.nodes(),
                (holds, &points, &axes),
                table,
            ),
            _ => None,
        };
        match joint {
            Some(joint) => builder.add_joint(Box::new(joint)),
            None => builder.note_broken(),
        }
    }
}

/// One node, which is joined to the frame, or two.
fn nodes(table: &Table<'_>, builder: &mut ModelBuilder, words: &str) -> Option<Vec<usize>> {
    ends::one_or_two((table, &NODES), builder, words, |found| {
        ends::count(NODES.name(), found, "one or two")
    })
}

/// The constraint of a joint of a kind.
fn holds(kind: &str, table: &Table<'_>, builder: &ModelBuilder) -> Option<Holds> {
    let slide = || {
        let drive = drive(table, &DISPLACEMENT.schema, builder)?;
        Some(drive.map_or(Freedom::Free, Freedom::Driven))
    };
    Some(match kind {
        "clamp" => Holds::Clamp,
        "spherical" => Holds::Spherical,
        "revolute" => Holds::Revolute(turning(table, builder)?),
        "cylindrical" => {
            let (slide, turning) = (slide(), turning(table, builder));
            Holds::Cylindrical(slide?, turning?)
        }
        "universal" => Holds::Universal,
        "prismatic" => Holds::Prismatic(slide()?),
        "in-line" => Holds::InLine,
        "in-plane" => Holds::InPlane(drive(table, &DISPLACEMENT.schema, builder)?),
        "plane-rotation" => Holds::PlaneRotation(turning(table, builder)?),
        "distance" => Holds::Distance(length(table, builder)?),
        "velocity" => Holds::Velocity(velocities(table, builder)?),
        "spin" => match turning(table, builder)? {
            Some(turning) => Holds::Spin(turning),
            None => {
                table.note("", &JointProblem::NoSpin);
                return None;
            }
        },
        _ => Holds::Total(freedoms(kind, table, builder)?),
    })
}

/// The signal under a key; `Some(None)` if it is absent.
fn drive(table: &Table<'_>, key: &KeySchema, builder: &ModelBuilder) -> Option<Option<Signal>> {
    let is_speed = [Dimension::VELOCITY, Dimension::ROTATION_SPEED].contains(&key.dimension());
    match table.has(key) {
        true if is_speed => drives::read_speed(table, key, builder.drives()).map(Some),
        true => drives::read_position(table, key, builder.drives()).map(Some),
        false => Some(None),
    }
}

/// The prescribed rotation about the axis: `angle` or `speed`.
fn turning(table: &Table<'_>, builder: &ModelBuilder) -> Option<Option<Turning>> {
    let angle = drive(table, &ANGLE.schema, builder);
    let speed = drive(table, &SPEED.schema, builder);
    match (angle?, speed?) {
        (None, None) => Some(None),
        (Some(angle), None) => Some(Some(Turning::Angle(angle))),
        (None, Some(speed)) => Some(Some(Turning::Speed(speed))),
        _ => {
            table.note(&SPEED, &JointProblem::AngleAndSpeed);
            None
        }
    }
}

/// The length of a distance joint.
fn length(table: &Table<'_>, builder: &ModelBuilder) -> Option<Option<Signal>> {
    if table.has(&LENGTH) {
        drives::read_distance(table, &LENGTH.schema, builder.drives()).map(Some)
    } else {
        Some(None)
    }
}

/// Driven components: `{ x = 0, z = "= sin(t)" }`, or three numbers.
fn components(
    table: &Table<'_>,
    key: &Key<ByHand>,
    builder: &ModelBuilder,
) -> Option<[Option<Signal>; 3]> {
    let axes = key.schema.kinds[0].table()?.keys;
    if !table.has(key) {
        return Some([None, None, None]);
    }
    if !table.is_table(key) {
        let numbers = table.vector(key.name(), axes[0].dimension())?;
        return Some([0, 1, 2].map(|i| Some(Drive::Constant(numbers[i]).into())));
    }
    let inner = table.table(key)?;
    let found = [0, 1, 2].map(|i| drive(&inner, &axes[i], builder));
    inner.finish();
    let [x, y, z] = found;
    Some([x?, y?, z?])
}

fn velocities(table: &Table<'_>, builder: &ModelBuilder) -> Option<[Option<Signal>; 6]> {
    let along = components(table, &VELOCITY, builder);
    let about = components(table, &ANGULAR_VELOCITY, builder);
    let ([a, b, c], [d, e, f]) = (along?, about?);
    let all = [a, b, c, d, e, f];
    if all.iter().all(Option::is_none) {
        let keys = "\"velocity\", \"angular_velocity\"";
        table.note("", &JointProblem::NothingHeld { keys });
        return None;
    }
    Some(all)
}

/// The freedoms of a position, a rotation or a total joint.
fn freedoms(kind: &str, table: &Table<'_>, builder: &ModelBuilder) -> Option<[Freedom; 6]> {
    let driven = |of: &str, key| {
        if kind == of || kind == "total" {
            components(table, key, builder)
        } else {
            Some([None, None, None])
        }
    };
    let along = driven("position", &DISPLACEMENTS);
    let about = driven("rotation", &ROTATION);
    let locked = if kind == "total" {
        locked(table)
    } else {
        Some([false; 6])
    };
    let ([a, b, c], [d, e, f], locked) = (along?, about?, locked?);
    let all = [a, b, c, d, e, f];
    if let Some(i) = (0..6).find(|&i| all[i].is_some() && locked[i]) {
        let freedom = FREEDOMS[i];
        table.note(&LOCKED, &JointProblem::LockedAndDriven { freedom });
        return None;
    }
    if all.iter().all(Option::is_none) && locked == [false; 6] {
        let keys = match kind {
            "position" => "\"displacement\"",
            "rotation" => "\"rotation\"",
            _ => "\"locked\", \"displacement\", \"rotation\"",
        };
        table.note("", &JointProblem::NothingHeld { keys });
        return None;
    }
    let mut locked = locked.into_iter();
    Some(all.map(|drive| match (drive, locked.next()) {
        (Some(drive), _) => Freedom::Driven(drive),
        (None, Some(true)) => Freedom::Locked,
        (None, _) => Freedom::Free,
    }))
}

/// The freedoms listed in `locked`.
fn locked(table: &Table<'_>) -> Option<[bool; 6]> {
    let listed = table.get(&LOCKED)?;
    Some(std::array::from_fn(|freedom| listed.contains(&freedom)))
}

fn points(kind: &str, table: &Table<'_>) -> Option<Points> {
    let same = [
        "clamp",
        "spherical",
        "revolute",
        "universal",
        "rotation",
        "spin",
        "plane-rotation",
    ];
    let at = table.get(&AT);
    let from = if same.contains(&kind) {
        Some(None)
    } else {
        table.get(&FROM)
    };
    Some(Points {
        at: at?,
        from: from?,
    })
}

fn axes(kind: &str, table: &Table<'_>) -> Option<Axes> {
    let in_node = || table.get(&AXIS_IN).map(|word| word == 1);
    match kind {
        "clamp" | "spherical" | "distance" => Some(Axes {
            of_ends: [Matrix3::identity(); 2],
            in_node: false,
        }),
        "universal" => {
            let (of_ends, in_node) = (two_axes(table), in_node());
            Some(Axes {
                of_ends: of_ends?,
                in_node: in_node?,
            })
        }
        "position" | "rotation" | "velocity" | "total" => {
            let turned = table.get(&ORIENTATION)?;
            Some(Axes {
                of_ends: [vector::to_rotation(&turned); 2],
                in_node: false,
            })
        }
        _ => {
            let (axis, in_node) = (super::axis(table), in_node());
            Some(Axes {
                of_ends: [axes_along(&axis?); 2],
                in_node: in_node?,
            })
        }
    }
}

/// The axes of a universal joint: one on each end.
fn two_axes(table: &Table<'_>) -> Option<[Matrix3<f64>; 2]> {
    let found = table.get(&AXES)?;
    let [first, second] = found[..] else {
        table.note(&AXES, &ends::count(AXES.name(), found.len(), "two"));
        return None;
    };
    if first.amax() == 0.0 || second.amax() == 0.0 {
        table.note(&AXES, &JointProblem::NoDirection);
        return None;
    }
    let [first, second] = [first, second].map(|axis| axis / axis.amax());
    if first.cross(&second).norm() <= ROUNDING * first.norm() * second.norm() {
        table.note(&AXES, &JointProblem::ParallelAxes);
        return None;
    }
    Some([axes_along(&first), axes_along(&second)])
}

/// The points of the joint on its two ends, model's frame [m].
fn points_of(
    holds: &Holds,
    points: &Points,
    (a, b): (Option<&Node>, &Node),
    table: &Table<'_>,
) -> Option<[Vector3<f64>; 2]> {
    let on_b = b.position;
    Some(match (holds, a) {
        (Holds::Distance(_), Some(a)) => {
            [points.from.unwrap_or(a.position), points.at.unwrap_or(on_b)]
        }
        (Holds::Distance(_), None) => from_the_frame(points, &on_b, table)?,
        _ => {
            let at = points.at.unwrap_or(on_b);
            [points.from.unwrap_or(at), at]
        }
    })
}

/// The joint between known nodes.
fn joint(
    label: &str,
    numbers: &[usize],
    nodes: &[Node],
    (holds, points, axes): (Holds, &Points, &Axes),
    table: &Table<'_>,
) -> Option<ConstraintJoint> {
    let (b, a) = match numbers {
        [a, b] => (*b, Some((*a, &nodes[*a]))),
        _ => (*numbers.first()?, None),
    };
    let b_node = (b, &nodes[b]);
    let ends = JointEnds { a, b: b_node };
    let turn = if axes.in_node {
        nodes[b].rotation
    } else {
        Matrix3::identity()
    };
    let points = points_of(&holds, points, (a.map(|a| a.1), &nodes[b]), table)?;
    let placing = Placing {
        points,
        axes: axes.of_ends.map(|axes| turn * axes),
    };
    let (ends, at) = (&ends, &placing);
    Some(match holds {
        Holds::Clamp => ConstraintJoint::clamp(label, ends, at),
        Holds::Spherical => ConstraintJoint::spherical(label, ends, at),
        Holds::Revolute(turning) => ConstraintJoint::revolute(label, ends, at, turning),
        Holds::Cylindrical(slide, turning) => {
            ConstraintJoint::cylindrical(label, ends, at, slide, turning)
        }
        Holds::Universal => ConstraintJoint::universal(label, ends, at),
        Holds::Prismatic(slide) => ConstraintJoint::prismatic(label, ends, at, slide),
        Holds::InLine => ConstraintJoint::in_line(label, ends, at),
        Holds::InPlane(height) => ConstraintJoint::in_plane(label, ends, at, height),
        Holds::PlaneRotation(turning) => ConstraintJoint::plane_rotation(label, ends, at, turning),
        Holds::Distance(length) => {
            let [first, second] = at.points;
            let (now, size) = ((second - first).norm(), first.amax().max(second.amax()));
            if now <= ROUNDING * size {
                let joint = label.to_owned();
                table.note(&NODES, &JointProblem::NoDistance { joint });
                return None;
            }
            let length = length.unwrap_or(Drive::Constant(now).into());
            ConstraintJoint::distance(label, ends, at, length)
        }
        Holds::Velocity(rates) => ConstraintJoint::velocity(label, ends, at, rates),
        Holds::Spin(turning) => ConstraintJoint::spin(label, ends, at, turning),
        Holds::Total(freedoms) => ConstraintJoint::total(label, ends, at, freedoms),
    })
}

/// The points of a distance from the frame: a single one is on the frame.
fn from_the_frame(
    points: &Points,
    node: &Vector3<f64>,
    table: &Table<'_>,
) -> Option<[Vector3<f64>; 2]> {
    match (points.from, points.at) {
        (Some(from), at) => Some([from, at.unwrap_or(*node)]),
        (None, Some(at)) => Some([at, *node]),
        (None, None) => {
            let _ = table.require_item(&AT, "the point of the frame from which it is measured");
            None
        }
    }
}
