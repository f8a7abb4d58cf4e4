//! Parts of messages about laminates.

use std::fmt;

use super::super::words::short;

/// A part that touches a laminate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Wall {
    /// The laminate of a curve.
    Curve(String),
    /// Cells of a surface, if they are in one.
    Cells(Option<String>),
}

impl fmt::Display for Wall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Curve(curve) => write!(f, "the laminate of curve \"{curve}\""),
            Self::Cells(Some(group)) => write!(f, "the surface \"{group}\""),
            Self::Cells(None) => f.write_str("a surface"),
        }
    }
}

impl Wall {
    /// Name next to another part, which may be the same.
    pub(super) fn as_other(&self, one: &Self) -> String {
        match (self == one, self) {
            (true, _) => "itself".to_owned(),
            (false, Self::Curve(curve)) => format!("the laminate of curve \"{curve}\""),
            (false, _) => self.to_string(),
        }
    }
}

pub(super) fn position_count(count: usize) -> String {
    match count {
        1 => String::new(),
        2 => " and 1 more position".to_owned(),
        _ => format!(" and {} more positions", count - 1),
    }
}

pub(super) fn more(count: usize) -> String {
    match count {
        1 => String::new(),
        _ => format!(", as do {} more", count - 1),
    }
}

pub(super) fn order(has_middle: bool) -> &'static str {
    if has_middle {
        "has a node in its middle that the side of the cell there does not have"
    } else {
        "lacks the node in its middle that the side of the cell there has"
    }
}

pub(super) fn both([one, other]: &[String; 2]) -> String {
    if one == other {
        format!("curve \"{one}\"")
    } else {
        format!("curves \"{one}\" and \"{other}\"")
    }
}

pub(super) fn twice([one, other]: &[String; 2]) -> String {
    if one == other {
        format!("curve \"{one}\" has two laminates")
    } else {
        format!("curves \"{one}\" and \"{other}\" both have a laminate")
    }
}

pub(super) fn fold(length: f64, radius: Option<f64>) -> String {
    match radius {
        Some(radius) => format!(
            "and the line of length {} has a radius of curvature of {}",
            short(length),
            short(radius)
        ),
        None => format!("and the line is {} long", short(length)),
    }
}
