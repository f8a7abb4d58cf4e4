//! Names that the cards of a model may use in addition to the names of its parts: drives with
//! the names that expressions read, frames, and samplings.

use std::sync::Arc;

use super::ModelBuilder;
use crate::elements::strips::RotorDisk;
use crate::input::aerodynamics::{Aerodynamics, Disks, remark_on_density};
use crate::input::drives;
use crate::input::frames::Frames;

impl ModelBuilder {
    /// The air, the airfoils and the inflows.
    pub fn aerodynamics(&self) -> &Aerodynamics {
        &self.aerodynamics
    }

    /// Sets the air, the airfoils and the inflows.
    pub fn set_aerodynamics(&mut self, aerodynamics: Aerodynamics) {
        self.add_remarks(aerodynamics.airfoils.remarks.clone());
        let air = aerodynamics.air.as_ref();
        let dense = air.and_then(|air| remark_on_density(&air.atmosphere));
        self.add_remarks(dense.into_iter().collect());
        self.aerodynamics = aerodynamics;
    }

    /// The disks of rotors so far, by the names of their inflows.
    pub fn disks(&self) -> &Disks {
        &self.disks
    }

    /// Adds the disk of an inflow.
    pub fn add_disk(&mut self, inflow: &str, disk: Arc<RotorDisk>) {
        self.disks.insert(inflow.to_owned(), disk);
    }

    /// The drives by name.
    pub fn drives(&self) -> &drives::Catalog {
        &self.drives
    }

    /// Sets the named drives.
    pub fn set_drives(&mut self, drives: drives::Catalog) {
        self.drives = drives;
    }

    /// The frames in which cards may be written.
    pub fn frames(&self) -> &Frames {
        &self.frames
    }

    /// Sets the frames.
    pub fn set_frames(&mut self, frames: Frames) {
        self.frames = frames;
    }

    /// Lines of cards that sample, and their sample times \[s\].
    pub fn samplings(&self) -> &[(usize, f64)] {
        &self.samplings
    }

    /// Notes that a card samples.
    pub fn add_sampling(&mut self, line: usize, period: f64) {
        self.samplings.push((line, period));
    }
}
