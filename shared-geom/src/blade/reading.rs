//! A blade as a file gives it.

use super::Blade;
use crate::error::Place;

/// A blade as read, and what its file left open.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The blade.
    pub blade: Blade,
    /// What the reader must know: defaults that were taken, plausibility.
    pub remarks: Vec<String>,
    /// Where each station is written; empty where the reader does not tell.
    pub places: Vec<Place>,
    /// The frame that the file declares, in words; `None` for that of its format.
    pub frame: Option<String>,
}

impl Reading {
    /// A blade whose file tells no more.
    pub(crate) fn new(blade: Blade, remarks: Vec<String>) -> Self {
        Self {
            blade,
            remarks,
            places: Vec::new(),
            frame: None,
        }
    }
}
