//! Names of unknowns and equations, for messages.

use std::borrow::Cow;
use std::fmt;

/// An unknown or an equation as text: `force balance along y of node "tip"`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    /// The quantity: `force balance along y`.
    pub what: String,
    /// The owner: `node "tip"`, or the label of an element in quotes; empty for the system
    /// as a whole.
    pub owner: String,
    /// Its unit: `N`.
    pub unit: Cow<'static, str>,
}

impl Name {
    /// `what` of node `label`.
    pub fn of_node(
        what: impl Into<String>,
        label: &str,
        unit: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self {
            what: what.into(),
            owner: format!("node \"{label}\""),
            unit: unit.into(),
        }
    }

    /// `what` of the element `label`.
    pub fn of_element(
        what: impl Into<String>,
        label: &str,
        unit: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self {
            what: what.into(),
            owner: format!("\"{label}\""),
            unit: unit.into(),
        }
    }

    /// `what` of the system.
    pub fn of_system(what: impl Into<String>, unit: impl Into<Cow<'static, str>>) -> Self {
        Self {
            what: what.into(),
            owner: String::new(),
            unit: unit.into(),
        }
    }

    /// The name with its error: a part of the scale by which it is measured, and the scale
    /// \[unit of the name\].
    pub fn off_by(&self, relative: f64, scale: f64) -> String {
        if !relative.is_finite() {
            return format!("{self}, without a value");
        }
        let [off, part, scale] = [relative * scale, relative, scale].map(brief);
        let unit = match self.unit.as_ref() {
            "-" => String::new(),
            unit => format!(" {unit}"),
        };
        format!("{self}, off by {off}{unit}, {part} of its scale {scale}{unit}")
    }
}

/// A number of four digits, with a power of ten if it is large or small.
fn brief(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-2..1e5).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.owner.is_empty() {
            f.write_str(&self.what)
        } else {
            write!(f, "{} of {}", self.what, self.owner)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_report_how_far_they_are_off() {
        let name = Name::of_node("force balance along y", "tip", "N");
        let reported = "force balance along y of node \"tip\"";
        assert_eq!(name.to_string(), reported);
        let off = format!("{reported}, off by 12.35 N, 1.235e-3 of its scale 10000 N");
        assert_eq!(name.off_by(0.001_234_6, 10_000.4), off);
        let none = format!("{reported}, without a value");
        assert_eq!(name.off_by(f64::INFINITY, 1.0), none);
        let cosine = Name::of_element("cosine", "cardan", "-");
        let off = "cosine of \"cardan\", off by 0.5, 0.5 of its scale 1";
        assert_eq!(cosine.off_by(0.5, 1.0), off);
        assert_eq!(Name::of_system("equation 3", "-").to_string(), "equation 3");
    }
}
