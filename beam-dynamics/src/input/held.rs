//! The problem of a node that two cards hold.

use shared_geom::document::Document;
use shared_geom::error::Explain;

/// A node that is held twice.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("node \"{node}\" is held on {line} already, expected one [[clamp]] or root of a blade")]
pub(super) struct HeldTwice {
    node: String,
    /// Line of the card that holds it, as text.
    line: String,
}

impl HeldTwice {
    /// A node that a card on `line` of a file holds already.
    pub fn new(node: &str, line: usize, document: &Document) -> Self {
        Self {
            node: node.to_owned(),
            line: document.line_words(line),
        }
    }
}

impl Explain for HeldTwice {
    fn help(&self) -> Option<String> {
        let text = "remove one of the two cards: the root of a blade is held without a [[clamp]], \
                    unless the hub moves";
        Some(text.to_owned())
    }
}
