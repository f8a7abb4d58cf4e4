//! Point masses on a blade.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::schema::ValueKind::{Quantity, Word};
use shared_geom::document::{Declared, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::layout::BladeLayout;
use super::problem::BladeProblem;
use super::source::Source;
use crate::elements::bodies::RigidInertia;
use crate::input::bodies::{self, Lump};
use crate::input::moments::INERTIA;
use crate::input::number::short_number;

keys! {
    /// A point mass on every blade of the card.
    pub(super) CARD = "[[blade.mass]]";
    /// Arc length from the root along the line, or the tip.
    AT: At = "at", [Quantity(Dimension::LENGTH), Word(&["tip"])], required, "\"tip\"";
    with bodies::MASS.schema, bodies::OFFSET.schema, INERTIA.schema;
}

/// A mass beyond an end of the line by less than this part of its length is at the end:
/// digits lost in the input.
const ROUNDING: f64 = 1e-6;

/// Position of a mass on the line.
#[derive(Debug, Clone, Copy, PartialEq)]
enum At {
    Tip,
    /// Arc length \[m\].
    Position(f64),
}

/// A `[[blade.mass]]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PointMass {
    at: At,
    lump: Lump,
    line: usize,
}

/// Reads every `[[blade.mass]]` of a card; `None` when one is wrong.
pub(super) fn read(blade: &Table<'_>) -> Option<Vec<PointMass>> {
    let mut number = 0;
    blade.each(&super::MASS, |table| {
        number += 1;
        let at = table.get(&AT);
        let lump = bodies::lump(table, &format!("mass {number}"));
        Some(PointMass {
            at: at?,
            lump: lump?,
            line: table.line_of(&AT),
        })
    })
}

impl Declared for At {}

impl Value for At {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if table.is_text(key) {
            let found = table.text(key.name)?;
            if found == "tip" {
                return Some(Self::Tip);
            }
            // A text that does not begin like a number is not a length with a unit.
            if !found.starts_with(|letter: char| letter.is_ascii_digit() || "+-.".contains(letter))
            {
                table.wrong(key, "a length from the root along the line, or \"tip\"");
                return None;
            }
        }
        table
            .quantity(key.name, key.dimension())
            .map(Self::Position)
    }
}

impl PointMass {
    /// Arc length on a blade of the given length; notes a position off the line.
    pub fn position(&self, length: f64, table: &Table<'_>) -> Option<f64> {
        let At::Position(found) = self.at else {
            return Some(length);
        };
        let near = ROUNDING * length;
        if (-near..=length + near).contains(&found) {
            return Some(found.clamp(0.0, length));
        }
        let document = table.document();
        document.note(self.line, &BladeProblem::OffLine { found, length });
        None
    }

    /// Remark on mass `number` (from zero) of blade `blade`, which is not at a node.
    pub fn remark(
        &self,
        position: f64,
        layout: &BladeLayout,
        number: usize,
        blade: &str,
    ) -> Option<String> {
        let nearest = layout.nearest(position);
        let there = layout.nodes[nearest].arc_length;
        let length = layout.nodes.last()?.arc_length;
        let six = |value: f64| short_number(value, 6);
        ((there - position).abs() > ROUNDING * length).then(|| {
            format!(
                "mass {} of blade \"{blade}\" is at {} m, the nearest node is at {} m: the mass is \
                 carried by a rigid arm of {} m; let a piece end there to have a node there",
                number + 1,
                six(position),
                six(there),
                six((there - position).abs())
            )
        })
    }

    /// The index of the node that carries the mass at an arc length, and the inertia
    /// about that node, in its axes.
    pub fn on_node(
        &self,
        position: f64,
        source: &Source,
        layout: &BladeLayout,
    ) -> (usize, RigidInertia) {
        let number = layout.nearest(position);
        let node = &layout.nodes[number];
        let distance = if node.arc_length == position {
            nalgebra::Vector3::zeros()
        } else {
            node.axes.transpose() * (source.position(position) - node.position)
        };
        (number, self.lump.inertia(&distance))
    }
}
