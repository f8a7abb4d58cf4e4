//! Index of a tag: fast for nearly consecutive tags, as numbered by gmsh, but correct for
//! any others.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// An index for each tag.
#[derive(Debug, Default)]
pub(super) struct TagTable {
    /// By tag: the index, or [`NONE`].
    dense: Vec<u32>,
    /// Indices of larger tags.
    sparse: HashMap<u64, u32>,
}

const NONE: u32 = u32::MAX;

impl TagTable {
    /// Reserves space for `count` tags; an empty table then has a dense array for tags up
    /// to twice that number.
    pub(super) fn reserve(&mut self, count: usize) {
        if self.dense.is_empty() && self.sparse.is_empty() {
            self.dense.resize(2 * count + 1, NONE);
        }
    }

    /// Adds a tag; returns whether it is new.
    pub(super) fn insert(&mut self, tag: u64, index: u32) -> bool {
        let slot = usize::try_from(tag).ok();
        match slot.and_then(|slot| self.dense.get_mut(slot)) {
            Some(entry) if *entry == NONE => {
                *entry = index;
                true
            }
            Some(_) => false,
            None => match self.sparse.entry(tag) {
                Entry::Vacant(entry) => {
                    entry.insert(index);
                    true
                }
                Entry::Occupied(_) => false,
            },
        }
    }

    /// The index of a tag.
    pub(super) fn get(&self, tag: u64) -> Option<u32> {
        let entry = usize::try_from(tag).ok();
        match entry.and_then(|entry| self.dense.get(entry)) {
            Some(&NONE) => None,
            Some(&index) => Some(index),
            None => self.sparse.get(&tag).copied(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_and_far_tags_are_found_once() {
        let mut table = TagTable::default();
        table.reserve(3);
        let tags = [0, 6, 7, 900_000_000_000, u64::MAX];
        for (tag, index) in tags.into_iter().zip(0..) {
            assert_eq!(table.get(tag), None);
            assert!(table.insert(tag, index));
            assert!(!table.insert(tag, 99));
            assert_eq!(table.get(tag), Some(index));
        }
        // a table with tags is not enlarged
        table.reserve(100);
        assert_eq!((table.get(7), table.get(8)), (Some(2), None));
    }
}
