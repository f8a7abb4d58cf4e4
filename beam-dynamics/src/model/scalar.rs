//! Scalar unknowns: numbers that elements add to the unknowns of nodes and constraints, for
//! example voltages, states of controllers, inflow or pressures.
//!
//! An element lists the scalars that it uses in [`crate::elements::Element::scalars`];
//! elements that list the same [`Scalar`] share one unknown and one equation, to which each
//! of them adds its part. The system numbers them in the order in which the elements list
//! them.

use std::ops::Deref;
use std::sync::Arc;

/// A quantity by its name and its unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Name, for example "voltage".
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Size above which errors are relative to the value: below, they are relative to this
    /// size [unit].
    pub scale: f64,
}

impl Quantity {
    /// The quantity `name` in `unit`; values below `scale` are measured relative to it.
    pub fn new(name: impl Into<String>, unit: impl Into<String>, scale: f64) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
            scale,
        }
    }
}

/// Value of a scalar at the start of a run that begins from a given motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScalarStart {
    /// Given, or an initial guess for a scalar without rate [unit of the scalar].
    Value(f64),
    /// Given, and constant in time: its rate and its second derivative are zero [unit of the scalar].
    Constant(f64),
    /// At rest: its equation holds with a rate of zero.
    Settled,
}

/// A scalar unknown, and its equation.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarSpec {
    /// Name of the element to which it belongs.
    pub owner: String,
    /// The unknown.
    pub unknown: Quantity,
    /// The equation.
    pub equation: Quantity,
    /// Whether its rate appears in an equation. Without, it may jump.
    pub has_rate: bool,
    /// The scalar that the equation sets equal to its rate, if any. Then its rate does not
    /// jump.
    pub rate: Option<Scalar>,
    /// Its value at the start.
    pub start: ScalarStart,
}

/// A scalar unknown that elements share: clones are the same unknown.
#[derive(Debug, Clone)]
pub struct Scalar(Arc<ScalarSpec>);

impl Scalar {
    /// A new unknown.
    pub fn new(spec: ScalarSpec) -> Self {
        Self(Arc::new(spec))
    }

    /// The index of each scalar of `used` among the different ones, which are returned in
    /// the order in which they first appear.
    pub fn number<'a>(used: impl Iterator<Item = &'a Self>) -> (Vec<usize>, Vec<Self>) {
        let mut known = std::collections::HashMap::new();
        let mut different: Vec<Self> = Vec::new();
        let number = |scalar: &Self| {
            *known.entry(Arc::as_ptr(&scalar.0)).or_insert_with(|| {
                different.push(scalar.clone());
                different.len() - 1
            })
        };
        let numbers = used.map(number).collect();
        (numbers, different)
    }
}

impl PartialEq for Scalar {
    /// Whether it is the same unknown; another one of the same name is not.
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Deref for Scalar {
    type Target = ScalarSpec;

    fn deref(&self) -> &ScalarSpec {
        &self.0
    }
}

/// Values and rates of scalar unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Scalars<'a> {
    /// Values [unit of each].
    pub values: &'a [f64],
    /// Rates of the scalars that have one, else zero [unit of each/s].
    pub rates: &'a [f64],
}

impl Scalars<'_> {
    /// No scalars.
    pub const NONE: Self = Self {
        values: &[],
        rates: &[],
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scalar(owner: &str) -> Scalar {
        Scalar::new(ScalarSpec {
            owner: owner.to_owned(),
            unknown: Quantity::new("voltage", "V", 1.0),
            equation: Quantity::new("charge", "C", 1.0),
            has_rate: false,
            rate: None,
            start: ScalarStart::Settled,
        })
    }

    // The third is another unknown of the same name.
    #[test]
    fn clones_are_one_unknown() {
        let (a, b, c) = (scalar("a"), scalar("b"), scalar("a"));
        let used = [b.clone(), a.clone(), b.clone(), c.clone(), a.clone()];
        let (numbers, different) = Scalar::number(used.iter());
        assert_eq!(numbers, [0, 1, 0, 2, 1]);
        assert_eq!(different, [b, a.clone(), c.clone()]);
        assert_ne!(a, c);
    }
}
