//! A blade as read from a file.

use super::Blade;
use crate::error::SourceLocation;

/// A blade as read, and remarks.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The blade.
    pub blade: Blade,
    /// Remarks for the user: defaults that were used, plausibility.
    pub remarks: Vec<String>,
    /// Location of each station in the file; empty if the reader does not record it.
    pub locations: Vec<SourceLocation>,
    /// The frame that the file declares, as text; `None` for the frame of its format.
    pub frame: Option<String>,
    /// Whether the file has damping that is not converted, which a remark describes.
    pub has_other_damping: bool,
}

impl Reading {
    /// A blade without remarks.
    pub(crate) fn new(blade: Blade, remarks: Vec<String>) -> Self {
        Self {
            blade,
            remarks,
            locations: Vec::new(),
            frame: None,
            has_other_damping: false,
        }
    }
}
