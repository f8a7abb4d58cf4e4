//! Rotors in multiblade coordinates: the coordinates, and the names of modes in them.

mod coordinates;
mod names;
mod rotors;
mod support;

pub(super) use coordinates::{Coordinates, Factors, Slot, SlotKind};
pub(super) use names::{Named, Names, SIX, pattern};
pub(super) use rotors::{FEW, NoCoordinates};
