//! What the cards of a model may use by name beside its parts: drives with what
//! expressions read, frames, and samplings.

use super::Draft;
use crate::input::drives;
use crate::input::frames::Frames;

impl Draft {
    /// The drives by name.
    pub fn drives(&self) -> &drives::Catalog {
        &self.drives
    }

    /// Says which drives have a name.
    pub fn set_drives(&mut self, drives: drives::Catalog) {
        self.drives = drives;
    }

    /// The frames in which cards may be written.
    pub fn frames(&self) -> &Frames {
        &self.frames
    }

    /// Says which frames there are.
    pub fn set_frames(&mut self, frames: Frames) {
        self.frames = frames;
    }

    /// Lines of cards that sample, and from sample to sample \[s\].
    pub fn samplings(&self) -> &[(usize, f64)] {
        &self.samplings
    }

    /// Notes that a card samples.
    pub fn add_sampling(&mut self, line: usize, period: f64) {
        self.samplings.push((line, period));
    }
}
