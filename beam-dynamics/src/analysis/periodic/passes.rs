//! The passes of a search for a periodic motion, which are shown as they are made.

use crate::result::PeriodicPass;

/// Passes so far, and the observer of each new one.
pub(super) struct Passes<'a> {
    list: &'a mut Vec<PeriodicPass>,
    watch: &'a mut dyn FnMut(&PeriodicPass),
}

impl<'a> Passes<'a> {
    /// Passes that are added to a list.
    pub fn new(list: &'a mut Vec<PeriodicPass>, watch: &'a mut dyn FnMut(&PeriodicPass)) -> Self {
        Self { list, watch }
    }

    /// All so far.
    pub fn list(&self) -> &[PeriodicPass] {
        self.list
    }

    /// Adds a pass and shows it.
    pub fn push(&mut self, pass: PeriodicPass) {
        (self.watch)(&pass);
        self.list.push(pass);
    }

    /// The last pass.
    pub fn last_mut(&mut self) -> Option<&mut PeriodicPass> {
        self.list.last_mut()
    }
}
