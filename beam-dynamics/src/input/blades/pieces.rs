//! Blades of straight pieces.

use shared_geom::document::schema::ValueKind::{Count, Positive, Quantity, Tables, Text, Vector};
use shared_geom::document::schema::{Family, KeySchema};
use shared_geom::document::{Declared, NestedList, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::layout::BladeLayout;
use super::mounts::{NAME, shallow};
use super::piece_line::{Piece, PieceLine};
use crate::input::beam_properties::BeamProperties;
use crate::input::beam_section::Properties;
use crate::input::builder::ModelBuilder;
use crate::input::curved_fit;
use crate::input::heat;
use crate::input::problem::InputProblem;

/// A blade of straight pieces.
pub(in crate::input) const PIECES: Family = Family {
    name: "pieces",
    meaning: "Straight pieces.",
    keys: &[
        DEFAULT_PROPERTIES.schema,
        heat::HEAT[0],
        heat::HEAT[1],
        PIECE.schema,
    ],
};

keys! {
    /// The name of properties of the pieces that name none.
    DEFAULT_PROPERTIES: Option<String> = "properties", [Text], optional, "\"strip\"";
    /// The pieces, from the root outward.
    PIECE: NestedList = "piece", [Tables(&CARD)], required, "";
}

keys! {
    /// A straight piece of a blade.
    CARD = "[[blade.piece]]";
    /// Length of the piece.
    pub(in crate::input) LENGTH: f64 = "length", [Positive(Dimension::LENGTH)], required, "31.5";
    /// Number of beams of three nodes.
    pub(in crate::input) ELEMENTS: usize = "elements", [Count(MOST_ELEMENTS)], required, "8";
    /// Direction of the piece in the rotor plane from the span, positive aft, less than a quarter
    /// turn.
    SWEEP: f64 = "sweep", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "45";
    /// Direction out of the rotor plane, positive up, less than a quarter turn.
    DIHEDRAL: f64 = "dihedral", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "5";
    /// Nose-up angle of the sections: one, or at the inner and the outer end.
    TWIST: Twist = "twist", [Quantity(Dimension::ANGLE), Vector(2, Dimension::ANGLE)]
        as "one angle, or the angles at both ends", or "0" = Twist([0.0; 2]),
        "[10, 2]";
    /// The name of the properties; needed unless the blade has some.
    PROPERTIES: Option<String> = "properties", [Text], optional, "\"strip\"";
    with heat::HEAT[0], heat::HEAT[1];
}

/// Beams of one piece: more are treated as an error.
const MOST_ELEMENTS: usize = 1000;

/// Line and properties of a blade of pieces.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pieces {
    /// The line.
    pub line: PieceLine,
    /// Properties of each piece.
    properties: Vec<Properties>,
}

impl Pieces {
    /// Nodes and beams.
    pub fn lay(&self) -> BladeLayout {
        let words = |piece| format!(", piece {}", piece + 1);
        let properties = |piece: usize| BeamProperties::constant(&self.properties[piece]);
        self.line.lay(words, properties)
    }
}

/// Reads every `[[blade.piece]]` of the blade `name`.
pub(super) fn read(table: &Table<'_>, builder: &mut ModelBuilder, name: &str) -> Option<Pieces> {
    let words = format!("blade \"{name}\"");
    let is_named = table.has(&DEFAULT_PROPERTIES);
    let default = Fallback {
        is_named,
        properties: is_named
            .then(|| builder.find_properties(table, &DEFAULT_PROPERTIES, &words))
            .flatten(),
    };
    let (pieces, properties) = pieces(table, builder, &words, &default);
    Some(Pieces {
        line: PieceLine { pieces: pieces? },
        properties: properties?,
    })
}

/// Properties of the pieces without properties of their own.
struct Fallback {
    /// Whether the blade has any.
    is_named: bool,
    /// These properties; `None` if they are wrong.
    properties: Option<Properties>,
}

/// Geometry and properties of every piece; each is `None` if any of them is wrong.
fn pieces(
    blade: &Table<'_>,
    builder: &mut ModelBuilder,
    words: &str,
    default: &Fallback,
) -> (Option<Vec<Piece>>, Option<Vec<Properties>>) {
    let tables = blade.tables(&PIECE);
    if tables.is_empty() {
        let name = blade.given(&NAME).unwrap_or_default();
        // Pieces of another form are noted already.
        if !blade.has(&PIECE) || blade.is_list(&PIECE) {
            blade.note(&PIECE, &InputProblem::NoPieces { blade: name });
        }
        return (None, None);
    }
    let read: Vec<_> = tables
        .iter()
        .enumerate()
        .map(|(number, table)| {
            let words = format!("{words}, piece {}", number + 1);
            let properties = piece_properties(table, builder, &words, default);
            // Values of the piece replace values of the blade.
            let properties = if heat::is_given(table) {
                heat::read(table, properties, builder.drives(), &words)
            } else {
                heat::read(blade, properties, builder.drives(), &words)
            };
            let piece = piece(table);
            table.finish();
            let pair = piece.as_ref().zip(properties.as_ref());
            let suits = pair.is_none_or(|(piece, properties)| {
                let curved = properties.curved.as_ref();
                curved_fit::suits_piece(curved, piece.twist_rate(), &words, table, builder)
            });
            (piece.filter(|_| suits), properties)
        })
        .collect();
    let (pieces, properties): (Vec<_>, Vec<_>) = read.into_iter().unzip();
    (
        pieces.into_iter().collect(),
        properties.into_iter().collect(),
    )
}

fn piece_properties(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    words: &str,
    default: &Fallback,
) -> Option<Properties> {
    if table.has(&PROPERTIES) {
        return builder.find_properties(table, &PROPERTIES, words);
    }
    if !default.is_named {
        let piece = words.to_owned();
        table.note(&PROPERTIES, &InputProblem::NoProperties { piece });
    }
    default.properties.clone()
}

fn piece(table: &Table<'_>) -> Option<Piece> {
    let (length, elements) = (table.get(&LENGTH), table.get(&ELEMENTS));
    let sweep = shallow(table, &SWEEP);
    let dihedral = shallow(table, &DIHEDRAL);
    let twist = table.get(&TWIST).map(|twist| twist.0);
    Some(Piece {
        length: length?,
        elements: elements?,
        sweep: sweep?,
        dihedral: dihedral?,
        twist: twist?,
    })
}

/// Twist at both ends \[rad\].
#[derive(Debug)]
struct Twist([f64; 2]);

impl Declared for Twist {}

/// One number applies to both ends.
impl Value for Twist {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let numbers = table.quantities(key.name, key.dimension())?;
        match numbers[..] {
            [both] => Some(Self([both; 2])),
            [inner, outer] => Some(Self([inner, outer])),
            _ => {
                table.wrong(key, &key.expected());
                None
            }
        }
    }
}
