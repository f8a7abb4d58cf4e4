//! Findings on the curves of a table: a fault that lift, drag and moment have in common is one finding.

use std::fmt::Display;

use super::problem::{AirfoilProblem, AirfoilRemark};

/// A finding that may be about a curve.
pub(super) trait Finding: Clone + Display {
    /// The name of its curve, "coefficient of \"airfoil\"" and the conditions, if it is about one.
    fn curve(&mut self) -> Option<&mut String>;
}

impl Finding for AirfoilProblem {
    fn curve(&mut self) -> Option<&mut String> {
        match self {
            Self::Absent { .. } | Self::HasMach { .. } => None,
            Self::Lengths { curve, .. }
            | Self::Few { curve, .. }
            | Self::NotFinite { curve, .. }
            | Self::NotAscending { curve, .. }
            | Self::Repeated { curve, .. }
            | Self::Gap { curve, .. }
            | Self::Incomplete { curve, .. }
            | Self::Beyond { curve, .. }
            | Self::EndsDiffer { curve, .. }
            | Self::Mixed { curve, .. }
            | Self::Shared { curve, .. }
            | Self::Condition { curve, .. }
            | Self::Absurd { curve, .. }
            | Self::Transformation { curve, .. } => Some(curve),
        }
    }
}

impl Finding for AirfoilRemark {
    fn curve(&mut self) -> Option<&mut String> {
        match self {
            Self::NoMoment { .. } => None,
            Self::Repeated { curve, .. }
            | Self::Closed { curve, .. }
            | Self::EndsDiffer { curve, .. }
            | Self::SingleMach { curve }
            | Self::WideStep { curve, .. }
            | Self::Skipped { curve, .. }
            | Self::NegativeDrag { curve, .. } => Some(curve),
        }
    }
}

/// The findings in their order, with one in place of several that differ only in their coefficient; it
/// names all of these: "lift, drag, moment of ...".
pub(super) fn merged<F: Finding>(findings: Vec<F>) -> Vec<F> {
    let mut groups: Vec<Group<F>> = Vec::new();
    for finding in findings {
        let (coefficient, text) = parts(&finding);
        match groups.iter_mut().find(|group| group.text == text) {
            Some(group) => group.coefficients.extend(coefficient),
            None => groups.push(Group {
                finding,
                text,
                coefficients: coefficient.into_iter().collect(),
            }),
        }
    }
    groups.into_iter().map(Group::named).collect()
}

/// Findings that differ only in their coefficient.
struct Group<F> {
    /// The first of them.
    finding: F,
    /// Its text without the coefficient.
    text: String,
    coefficients: Vec<String>,
}

impl<F: Finding> Group<F> {
    fn named(mut self) -> F {
        if let Some(curve) = self.finding.curve()
            && let Some((_, rest)) = curve.split_once(OF)
        {
            *curve = format!("{}{OF}{rest}", self.coefficients.join(", "));
        }
        self.finding
    }
}

/// Between the coefficient and the airfoil.
const OF: &str = " of ";

/// The coefficient of a finding, and its text without it.
fn parts<F: Finding>(finding: &F) -> (Option<String>, String) {
    let mut other = finding.clone();
    let mut coefficient = None;
    if let Some(curve) = other.curve()
        && let Some((first, rest)) = curve.split_once(OF)
    {
        coefficient = Some(first.to_owned());
        *curve = rest.to_owned();
    }
    (coefficient, other.to_string())
}
