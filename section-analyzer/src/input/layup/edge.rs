//! The trailing edge: adhesive between both sides, a fill behind the line between two places.

use shared_geom::document::Nested;
use shared_geom::document::Table;
use shared_geom::document::schema::TableSchema;
use shared_geom::document::schema::ValueKind::{Table as OneTable, Word};
use shared_geom::keys;

use super::fills::{FillBound, WrittenFill};
use super::keys::{MATERIAL, RANGE};
use super::layers::{Known, range};
use super::place::{BOTH, BothSides};
use crate::mesh::generate::layup::LayupProblem;

keys! {
    /// The trailing edge, which the layers of the shell close, or an adhesive.
    EDGE_KEYS = "[trailing_edge]";
    /// Whether layers alone close it, or the adhesive `bond` too.
    CLOSE: usize = "close", [Word(&["auto", "bond"])], or "\"auto\"" = 0, "\"bond\"";
    /// The adhesive.
    BOND: Nested = "bond", [OneTable(&BOND_TABLE)], optional, "";
}
keys! {
    /// An adhesive from the trailing edge to a line between both sides: the first fill, by the name
    /// `trailing_edge_bond`; absent where the layers leave no space for it.
    BOND_TABLE = "bond";
    /// The line at which it ends.
    TO_LINE: BothSides = "to", [OneTable(&BOTH)], required, "{ distance = \"0.1 m\" }";
    with MATERIAL.schema, RANGE.schema;
}
/// The table of the trailing edge.
pub(super) const EDGE_TABLE: TableSchema = EDGE_KEYS;
/// The name of the fill.
pub(super) const NAME: &str = "trailing_edge_bond";

/// The fill of the trailing edge, if there is one; notes problems.
pub(super) fn read(known: &Known, table: &Table<'_>) -> Option<Option<WrittenFill>> {
    let close = table.get(&CLOSE);
    let fill = table.nested(&BOND, |bond| {
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
    if close == Some(1) && !table.has(&BOND) {
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
