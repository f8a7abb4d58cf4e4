//! The kinds of hubs: one file each, and their list.
//!
//! A hub has the node that turns with the shaft, and the node that carries the blades, its yoke. They
//! are one node unless the hub tilts.

use shared_geom::document::Card;

use super::base::Base;
use super::problem::RotorProblem;

mod articulated;
mod bearingless;
mod gimballed;
mod hingeless;
mod rigid;
mod teetering;

/// A kind of hub.
#[derive(Debug)]
pub(super) struct HubKind {
    /// Its word.
    pub word: &'static str,
    /// Whether it tilts against the shaft.
    pub tilts: bool,
    /// The first problem of a rotor with the hub.
    pub problem: fn(&Base) -> Option<RotorProblem>,
    /// The yoke, with the cards between it and the node of the hub.
    pub yoke: fn(&Base) -> (String, Vec<Card>),
}

/// All kinds.
pub(super) const HUBS: [HubKind; 6] = [
    rigid::KIND,
    hingeless::KIND,
    articulated::KIND,
    teetering::KIND,
    gimballed::KIND,
    bearingless::KIND,
];

/// The words of all kinds.
pub(super) const WORDS: [&str; HUBS.len()] = {
    let mut words = [""; HUBS.len()];
    let mut index = 0;
    while index < HUBS.len() {
        words[index] = HUBS[index].word;
        index += 1;
    }
    words
};
