//! Straight lines of beams that carry a rotor: towers and wings.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::{Card, Content, Table};
use shared_geom::rotation::vector;

use super::keys::{ELEMENTS, FILE, PROPERTIES};
use crate::input::blades::{BODY, TOWER};
use crate::input::damping;
use crate::input::rotors::base::{Base, angles, lengths};
use crate::input::rotors::problem::RotorProblem;

/// A straight line of beams.
#[derive(Debug, Clone)]
pub(in crate::input::rotors) struct Column {
    /// First end \[m\].
    pub foot: Vector3<f64>,
    /// Axes (columns): along the line, toward the leading edge, and up.
    pub axes: Matrix3<f64>,
    /// Length \[m\].
    pub length: f64,
    /// Its name among parts: a tower or a wing.
    part: &'static str,
    /// Keys of its card.
    keys: Vec<(&'static str, Content)>,
}

impl Column {
    /// Reads the elasticity of the `part` of a length \[m\] from its table.
    pub fn read(
        table: &Table<'_>,
        part: &'static str,
        (foot, axes, length): (Vector3<f64>, Matrix3<f64>, f64),
    ) -> Option<Self> {
        let (properties, file) = (table.get(&PROPERTIES), table.get(&FILE));
        let elements = table.get(&ELEMENTS);
        let (body, damping) = (table.get(&BODY), damping::read_of_file(table));
        let (properties, file, elements) = (properties?, file?, elements?);
        let (body, _) = (body?, damping?);
        let length_text = || Content::quantity(length, "m");
        let mut keys = match (properties, file) {
            (Some(properties), None) => {
                let piece = [("length", length_text()), ("elements", elements.into())];
                let piece = Content::table(piece);
                vec![
                    ("properties", properties.into()),
                    ("piece", Content::list([piece])),
                ]
            }
            (None, Some(file)) => vec![
                ("file", file.into()),
                ("length", length_text()),
                ("elements", elements.into()),
            ],
            _ => {
                table.note("", &RotorProblem::OneElasticity { part });
                return None;
            }
        };
        keys.extend(body.map(|body| (BODY.name(), body.into())));
        keys.extend(damping::copied(table));
        Some(Self {
            foot,
            axes,
            length,
            part,
            keys,
        })
    }

    /// The other end \[m\].
    pub fn end(&self) -> Vector3<f64> {
        self.foot + self.axes.column(0) * self.length
    }

    /// The cards of a column that may be absent, called `name`, on the node `holder` or clamped, and the
    /// node at its end; without a column the holder.
    pub fn mounted(
        column: Option<&Self>,
        base: &Base,
        name: &str,
        holder: Option<&str>,
    ) -> (Vec<Card>, Option<String>) {
        match column {
            Some(column) => (
                column.cards(base, name, holder),
                Some(format!("{name}/tip")),
            ),
            None => (Vec::new(), holder.map(str::to_owned)),
        }
    }

    /// The cards of a line called `name`, whose first end is on the node `holder`, or clamped.
    fn cards(&self, base: &Base, name: &str, holder: Option<&str>) -> Vec<Card> {
        let frame = name.replace('/', " ");
        let orientation = vector::from_rotation(&self.axes);
        let blade = base
            .listed("blade")
            .with("name", name)
            .with("in", frame.as_str())
            .with("hub_radius", Content::quantity(0.0, "m"))
            .with("clamp_root", holder.is_none())
            .with(
                "part",
                match self.part {
                    TOWER => Content::from(TOWER),
                    _ => Content::from(true),
                },
            )
            .with_all(
                self.keys
                    .iter()
                    .map(|(key, value)| ((*key).to_owned(), value.clone())),
            );
        let mut cards = vec![
            base.listed("frame")
                .with("name", frame)
                .with("position", lengths(&self.foot))
                .with("orientation", angles(&orientation)),
            blade,
        ];
        cards.extend(holder.map(|holder| {
            base.listed("rigid")
                .with("name", format!("{name} attachment"))
                .with("nodes", Content::texts([holder, &format!("{name}/root")]))
        }));
        cards
    }
}
