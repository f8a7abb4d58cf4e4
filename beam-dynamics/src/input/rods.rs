//! Rods: `[[rod]]`.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{
    Drive, Table as OneTable, Tables, Text, Texts, Vector, Vectors, Word,
};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::laws::{self, Components, LawProblem};
use super::{drives, ends};
use crate::elements::springs::{End, Measure, Rod};
use crate::elements::{Element, Smoothness};
use crate::model::NodeMotion;

keys! {
    /// A straight rod between two nodes, or between a point of the frame and a node.
    pub(super) CARD = "[[rod]]";
    /// Its name, for messages and output.
    NAME: Option<String> = "name", [Text], or "`rod` and its number", "\"stay\"";
    /// The names of two nodes, or of one with `at`.
    NODES: Vec<String> = "nodes", [Texts], required, "[\"foot\", \"hook\"]";
    /// With one node: the first end of the rod, a point of the frame.
    AT: Option<Vector3<f64>> = "at", [Vector(3, Dimension::LENGTH)], optional, "[0, 0, 3]";
    /// Offset of each end from its node, in the node's axes.
    OFFSETS: Option<Vec<Vector3<f64>>> = "offsets", [Vectors(3, Dimension::LENGTH), Vector(3, Dimension::LENGTH)],
        or "zero", "[[0, 0, 0], [0.1, 0, 0]]";
    /// Relaxed length, above zero at all times.
    LENGTH: ByHand = "length", [Drive(Dimension::LENGTH)], or "the undeformed length", "2.5";
    /// Deformation of the law: strain, or elongation.
    MEASURE: usize = "measure", [Word(&["strain", "elongation"])], or "\"strain\"" = 0,
        "\"elongation\"";
    /// The law of the tension.
    LAW: ByHand = "law", [OneTable(&laws::ROD), Tables(&laws::ROD)], required, "";
}

/// Part of the largest coordinate below which a length is treated as zero: digits lost in
/// the input.
const NO_LENGTH: f64 = 1e-9;

/// Adds every `[[rod]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("rod").iter().enumerate() {
        let label = ends::label(table, &NAME, "rod", number);
        let is_new = builder.take_label("spring", &label, table);
        let rod = rod(table, builder, &label);
        table.finish();
        match rod {
            Some(rod) if is_new => builder.add_joint(Box::new(rod)),
            _ => builder.note_broken(),
        }
    }
}

fn rod(table: &Table<'_>, builder: &mut ModelBuilder, label: &str) -> Option<Rod> {
    let words = format!("rod \"{label}\"");
    let nodes = ends::nodes((table, &NODES), builder, &words, true);
    let ends = match nodes.as_deref() {
        Some(&[a, b]) => ends::points(table, &OFFSETS, [a, b]),
        Some(&[node]) => ends::frame_and_point((table, &AT), &OFFSETS, node, &words),
        _ => None,
    };
    let measure = table.get(&MEASURE);
    let relaxed = if table.has(&LENGTH) {
        drives::read_length(table, &LENGTH.schema, builder.drives()).map(Some)
    } else {
        Some(None)
    };
    let of = match measure {
        Some(1) => Components::ELONGATION,
        _ => Components::STRAIN,
    };
    let law = laws::read(table, LAW.name(), &of, builder.drives());
    let measure = [Measure::Strain, Measure::Elongation][measure?];
    let (ends, relaxed, law) = (ends?, relaxed?, law?);
    if let (Some(item), Some(relaxed)) = (table.item(&LENGTH), &relaxed)
        && law.is_viscous()
        && !drives::is_smooth(&item, relaxed, Smoothness::Rate)
    {
        return None;
    }
    let rod = Rod::new(label, ends, builder.nodes(), relaxed, (measure, law));
    let rest: Vec<_> = builder.nodes().iter().map(NodeMotion::at_rest).collect();
    let of_rod: Vec<_> = rod.nodes().iter().map(|&node| rest[node]).collect();
    if rod.length(&of_rod) <= NO_LENGTH * size(&ends, builder) {
        table.note(&NODES, &LawProblem::NoLength { rod: words });
        return None;
    }
    Some(rod)
}

/// The largest coordinate of the ends \[m\].
fn size(ends: &[End; 2], builder: &ModelBuilder) -> f64 {
    let of_end = |end: &End| match end {
        End::Node { node, offset } => builder.nodes()[*node].position.amax().max(offset.amax()),
        End::Frame { position } => position.amax(),
    };
    ends.iter().map(of_end).fold(0.0, f64::max)
}
