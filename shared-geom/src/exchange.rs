//! Blade files of other tools, read and written.
//!
//! Every format is a file of this folder with the same three functions: `recognize`,
//! `read` and `write`; none for what the format cannot do.

use std::path::PathBuf;

use crate::blade::Blade;

/// A blade as read, and what its file left open.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The blade.
    pub blade: Blade,
    /// What the reader must know: defaults that were taken, plausibility.
    pub remarks: Vec<String>,
}

/// Files of a blade in another format, and what they cannot carry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Writing {
    /// Names of the files, relative to that of the first, and their texts.
    pub files: Vec<(PathBuf, String)>,
    /// What was lost, in words, with its size.
    pub lost: Vec<String>,
}
