//! The cards of the controls, and controls that no expression uses.

use shared_geom::document::Table;
use shared_geom::error::{Diagnostics, SourceLocation};

use super::keys::{CONTROL, NAME};
use super::problem::TrimProblem;
use crate::case::Model;
use crate::elements::Element;

/// The cards of the controls with their names, without those that have none.
pub(super) fn named_cards<'a>(root: &Table<'a>) -> Vec<(String, Table<'a>)> {
    let cards = root.listed("trim", CONTROL.name());
    let named = |card: Table<'a>| {
        let name = card
            .is_text(NAME.name())
            .then(|| card.text(NAME.name()))??;
        Some((name, card))
    };
    cards.into_iter().filter_map(named).collect()
}

/// Names and locations of the controls.
pub(in crate::input) fn locations(root: &Table<'_>) -> Vec<(String, SourceLocation)> {
    let cards = named_cards(root).into_iter();
    cards
        .map(|(name, card)| (name, card.document().location(card.line())))
        .collect()
}

/// Problems of the controls whose unknown no other element reads: nothing determines them.
pub(in crate::input) fn problems(
    model: &Model,
    controls: &[(String, SourceLocation)],
) -> Diagnostics {
    let mut problems = Diagnostics::new();
    for (name, location) in controls {
        let label = format!("control {name}");
        let is_own = |element: &&dyn Element| element.label() == label;
        let own = model.system.elements().find(is_own);
        // Parameters have no element.
        let Some(control) = own.and_then(|element| element.scalars().first()) else {
            continue;
        };
        let mut others = model.system.elements().filter(|element| !is_own(element));
        if !others.any(|element| element.scalars().contains(control)) {
            let name = name.clone();
            problems.push(location.clone(), &TrimProblem::Unused { name });
        }
    }
    problems
}
