//! Where the cards of a model stand, for what is found out after they were read.

use std::collections::BTreeMap;

use shared_geom::document::Document;
use shared_geom::error::Place;

/// Places of cards by the names that they give.
#[derive(Debug, Clone, Default)]
pub struct Origins {
    nodes: BTreeMap<String, Place>,
    joints: BTreeMap<String, Place>,
}

impl Origins {
    /// Those of names with their lines in a document.
    pub(super) fn new<'a>(
        document: &Document,
        nodes: impl Iterator<Item = (&'a str, usize)>,
        joints: impl Iterator<Item = (&'a str, usize)>,
    ) -> Self {
        let place = |(name, line): (&str, usize)| (name.to_owned(), document.place(line));
        Self {
            nodes: nodes.map(place).collect(),
            joints: joints.map(place).collect(),
        }
    }

    /// Where a node has its name.
    pub fn node(&self, name: &str) -> Option<&Place> {
        self.nodes.get(name)
    }

    /// Where a joint has its name, or else its card.
    pub fn joint(&self, name: &str) -> Option<&Place> {
        self.joints.get(name)
    }
}
