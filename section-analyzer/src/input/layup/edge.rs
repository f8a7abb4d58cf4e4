//! The trailing edge: adhesive between both sides, a fill behind the line between two places.

use shared_geom::document::Table;

use super::fills::{FillBound, WrittenFill};
use super::keys::{CLOSE, EDGE, EDGE_BOND, FILLS, TO_LINE};
use super::layers::{Known, range};
use crate::mesh::generate::layup::LayupProblem;

/// The name of the fill.
pub(super) const NAME: &str = "trailing_edge_bond";

/// The adhesive at the trailing edge, and the other fills; notes problems.
pub(super) fn fills(root: &Table<'_>, known: &Known) -> Option<Vec<WrittenFill>> {
    let edge = root.nested(&EDGE, |table| read(known, table));
    let fills = root.each(&FILLS, |table| known.fill(table));
    let (edge, fills) = (edge?, fills?);
    Some(edge.flatten().into_iter().chain(fills).collect())
}

/// The fill of the trailing edge, if there is one; notes problems.
fn read(known: &Known, table: &Table<'_>) -> Option<Option<WrittenFill>> {
    let close = table.get(&CLOSE);
    let fill = table.nested(&EDGE_BOND, |bond| {
        let (material, to) = (known.material(bond), bond.get(&TO_LINE));
        let range = range(bond, NAME);
        Some(WrittenFill {
            name: NAME.to_owned(),
            material: material?,
            fiber_angle: 0.0,
            plane_angle: 0.0,
            bounds: [None, Some(FillBound::Plane(Box::new(to?.0)))],
            range: range?,
            line: bond.line(),
        })
    });
    if close == Some(1) && !table.has(&EDGE_BOND) {
        table.wrong(&CLOSE, "a table \"bond\" with material and to beside it");
        return None;
    }
    close?;
    fill
}

/// Whether the layers leave no space between both sides for the adhesive.
pub(super) fn has_no_room(problem: &LayupProblem) -> bool {
    use LayupProblem::{FillBound, NoSpace, WebInContact, WebOutside};
    let is_of_space = matches!(
        problem,
        FillBound { .. } | NoSpace { .. } | WebInContact { .. } | WebOutside { .. }
    );
    is_of_space && problem.about() == Some(NAME)
}
