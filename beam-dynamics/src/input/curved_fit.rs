//! Whether a beam has the curvature for which its section was solved, (D-230).

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::section::{Agreement, InitialCurvature};

use super::beam_card::Beam;
use super::builder::ModelBuilder;
use super::curved::Curved;
use super::problem::InputProblem;
use crate::elements::beams;

/// Whether a straight piece, described by `words`, with a twist that grows by `rate`
/// \[1/m\] has the curvature for which its section was solved.
pub(super) fn suits_piece(
    curved: Option<&Curved>,
    rate: f64,
    words: &str,
    table: &Table<'_>,
    builder: &mut ModelBuilder,
) -> bool {
    let line = InitialCurvature {
        curvature: Vector3::new(rate, 0.0, 0.0),
        ..InitialCurvature::STRAIGHT
    };
    curved.is_none_or(|curved| is_on(curved, &line, words, (table, "twist"), builder))
}

/// Whether a beam has the curvature for which its section was solved at both evaluation
/// points.
pub(super) fn suits_beam(beam: &Beam, table: &Table<'_>, builder: &mut ModelBuilder) -> bool {
    let Some(curved) = &beam.properties.curved else {
        return true;
    };
    let (geometry, names) = (beam.geometry, beam.nodes);
    beams::Beam::evaluation_points().into_iter().all(|xi| {
        let nodes = names.map(|node| &builder.nodes()[node]);
        let line = geometry.initial_curvature(&nodes, xi);
        let (position, length) = (geometry.arc_length(&nodes, xi), geometry.length(&nodes));
        let user = format!("beam \"{}\", {position:.4} m of {length:.4} m", beam.label);
        is_on(curved, &line, &user, (table, "nodes"), builder)
    })
}

/// Compares a section with a line: notes on `table` that they belong to different beams,
/// and adds a remark to `builder` if they differ a little. `user` describes the user of the
/// properties and the position. True unless they belong to different beams.
fn is_on(
    curved: &Curved,
    line: &InitialCurvature,
    user: &str,
    (table, key): (&Table<'_>, &str),
    builder: &mut ModelBuilder,
) -> bool {
    match Agreement::of(&curved.initial, [*line; 2], &curved.stiffness) {
        Agreement::Same => true,
        Agreement::Near(mismatch) => {
            builder.add_remarks(vec![curved.remark(user, &mismatch)]);
            true
        }
        Agreement::Other(mismatch) => {
            let problem = InputProblem::OtherCurvature {
                user: user.to_owned(),
                name: curved.name.clone(),
                mismatch: Box::new(mismatch),
            };
            table.note(key, &problem);
            false
        }
    }
}
