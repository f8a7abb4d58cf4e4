//! Sections between airfoils.
//!
//! Coefficients are interpolated at the same angle of attack,
//!
//! ```text
//! c(alpha) = sum_k w_k c_k(alpha),   sum_k w_k = 1
//! ```
//!
//! with weights linear in the position along the span, or in the thickness over chord.

use std::sync::Arc;

use shared_geom::error::Explain;
use shared_geom::units::rounded;

use super::data::{Coefficients, Flow};
use super::evaluated::{Airfoil, FlowNumber, Profile};
use crate::real::Real;

/// A reason for which airfoils cannot be blended.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BlendProblem {
    /// No airfoil.
    #[error("a blend of no airfoils")]
    Empty,
    /// A weight below zero, above one or not a number.
    #[error("weight {weight} of airfoil \"{airfoil}\", expected 0 to 1")]
    Weight {
        /// Name.
        airfoil: String,
        /// Weight \[-\].
        weight: f64,
    },
    /// The sum of the weights is not one.
    #[error("the weights of the airfoils add up to {sum}, expected 1")]
    Sum {
        /// Sum \[-\].
        sum: f64,
    },
    /// Positions or thicknesses do not ascend.
    #[error("airfoil \"{airfoil}\" at {second} follows {first}, expected ascending positions")]
    NotAscending {
        /// Name.
        airfoil: String,
        /// Position before \[unit of the positions\].
        first: f64,
        /// Position \[unit of the positions\].
        second: f64,
    },
    /// An airfoil has no thickness.
    #[error("airfoil \"{airfoil}\" states no thickness over chord")]
    NoThickness {
        /// Name.
        airfoil: String,
    },
    /// A position is out of range.
    #[error(
        "no airfoil at {}: the airfoils are from {} to {}",
        rounded(*.at), rounded(*.from), rounded(*.to)
    )]
    OutOfRange {
        /// Requested position \[unit of the positions\].
        at: f64,
        /// First position \[unit of the positions\].
        from: f64,
        /// Last position \[unit of the positions\].
        to: f64,
    },
}

impl Explain for BlendProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Empty => "name at least one airfoil",
            Self::Weight { .. } | Self::Sum { .. } => "correct the weights",
            Self::NotAscending { .. } => "sort the airfoils, and use each position once",
            Self::NoThickness { .. } => "state its thickness, or blend along the span",
            Self::OutOfRange { .. } => "add an airfoil at the end of the range",
        };
        Some(text.to_owned())
    }
}

/// The airfoil of one station: one, or several with weights.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    first: Arc<Airfoil>,
    weight: f64,
    others: Vec<(f64, Arc<Airfoil>)>,
}

impl Section {
    /// The section of a single airfoil.
    pub fn single(airfoil: Arc<Airfoil>) -> Self {
        Self {
            first: airfoil,
            weight: 1.0,
            others: Vec::new(),
        }
    }

    /// The section of several airfoils with weights.
    ///
    /// # Errors
    /// No airfoils, a weight that is not from 0 to 1, or a sum of weights that is not one.
    pub fn weighted(parts: &[(f64, Arc<Airfoil>)]) -> Result<Self, BlendProblem> {
        for (weight, airfoil) in parts {
            if !(0.0..=1.0).contains(weight) {
                let (airfoil, weight) = (airfoil.name().to_owned(), *weight);
                return Err(BlendProblem::Weight { airfoil, weight });
            }
        }
        let sum: f64 = parts.iter().map(|part| part.0).sum();
        // The digits of a file.
        if !parts.is_empty() && (sum - 1.0).abs() > 1e-4 {
            return Err(BlendProblem::Sum { sum });
        }
        let mut used = parts.iter().filter(|part| part.0 > 0.0);
        let (weight, first) = used.next().ok_or(BlendProblem::Empty)?;
        Ok(Self {
            first: first.clone(),
            weight: weight / sum,
            others: used
                .map(|(weight, it)| (weight / sum, it.clone()))
                .collect(),
        })
    }

    /// The section between two sections, linear in the share of the second.
    pub(crate) fn between(low: &Self, high: &Self, share: f64) -> Result<Self, BlendProblem> {
        let mut parts: Vec<(f64, Arc<Airfoil>)> = Vec::new();
        for (section, factor) in [(low, 1.0 - share), (high, share)] {
            for (weight, airfoil) in section.parts() {
                let same = |part: &&mut (f64, Arc<Airfoil>)| Arc::ptr_eq(&part.1, airfoil);
                match parts.iter_mut().find(same) {
                    Some(part) => part.0 += weight * factor,
                    None => parts.push((weight * factor, airfoil.clone())),
                }
            }
        }
        // The sum of round-off.
        parts.iter_mut().for_each(|part| part.0 = part.0.min(1.0));
        Self::weighted(&parts)
    }

    /// The section with each of its airfoils replaced.
    #[must_use]
    pub(crate) fn with_each(&self, by: impl Fn(&Arc<Airfoil>) -> Arc<Airfoil>) -> Self {
        let others = self.others.iter();
        Self {
            first: by(&self.first),
            weight: self.weight,
            others: others.map(|(weight, it)| (*weight, by(it))).collect(),
        }
    }

    /// Weights and airfoils.
    pub fn parts(&self) -> impl Iterator<Item = (f64, &Arc<Airfoil>)> {
        let others = self.others.iter().map(|(weight, it)| (*weight, it));
        std::iter::once((self.weight, &self.first)).chain(others)
    }

    /// A constant of unsteady models, in the unit of files; airfoils without it have the default. `None`
    /// if no airfoil has it.
    pub fn constant(&self, name: &str, default: f64) -> Option<f64> {
        let own = |airfoil: &Airfoil| airfoil.unsteady().get(name);
        self.parts().find_map(|(_, airfoil)| own(airfoil))?;
        let parts = self.parts();
        Some(
            parts
                .map(|(weight, airfoil)| weight * own(airfoil).unwrap_or(default))
                .sum(),
        )
    }

    /// Coefficients in a flow.
    pub fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        self.sum(|airfoil| airfoil.at(flow))
    }

    /// Coefficients in a flow, and their derivatives by its numbers in their order.
    pub(crate) fn slopes(&self, flow: &Flow<f64>) -> Coefficients<FlowNumber> {
        self.sum(|airfoil| airfoil.slopes(flow))
    }

    /// The drag coefficient alone.
    pub(crate) fn drag(&self, flow: &Flow<f64>) -> f64 {
        let parts = self.parts();
        parts
            .map(|(weight, airfoil)| weight * airfoil.drag(flow))
            .sum()
    }

    /// The same with derivatives.
    pub(crate) fn drag_slopes(&self, flow: &Flow<f64>) -> FlowNumber {
        let parts = self.parts();
        parts
            .map(|(weight, airfoil)| airfoil.drag_slopes(flow) * weight)
            .sum()
    }

    /// The sum of the coefficients of all airfoils.
    fn sum<T: Real>(&self, of: impl Fn(&Airfoil) -> Coefficients<T>) -> Coefficients<T> {
        let mut sum = of(&self.first);
        if self.others.is_empty() {
            return sum;
        }
        sum = sum.scaled(self.weight);
        for (weight, airfoil) in &self.others {
            let part = of(airfoil).scaled(*weight);
            sum.lift += part.lift;
            sum.drag += part.drag;
            sum.moment += part.moment;
        }
        sum
    }
}

impl Profile for Section {
    fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        Section::at(self, flow)
    }
}

/// Sections at ascending positions, of which the sections between follow.
#[derive(Debug, Clone, PartialEq)]
pub struct Blend {
    positions: Vec<f64>,
    sections: Vec<Section>,
}

impl Blend {
    /// Sections along the span, at ascending positions of any unit.
    ///
    /// # Errors
    /// No sections, or positions that do not ascend.
    pub fn along_span(stations: Vec<(f64, Section)>) -> Result<Self, BlendProblem> {
        if stations.is_empty() {
            return Err(BlendProblem::Empty);
        }
        for pair in stations.windows(2) {
            let ((first, _), (second, section)) = (&pair[0], &pair[1]);
            if second <= first || !(second - first).is_finite() {
                return Err(BlendProblem::NotAscending {
                    airfoil: section.first.name().to_owned(),
                    first: *first,
                    second: *second,
                });
            }
        }
        let (positions, sections) = stations.into_iter().unzip();
        Ok(Self {
            positions,
            sections,
        })
    }

    /// Airfoils by their thickness over chord, in any order.
    ///
    /// # Errors
    /// No airfoils, one without thickness, or two of the same.
    pub fn by_thickness(airfoils: &[Arc<Airfoil>]) -> Result<Self, BlendProblem> {
        let mut stations = Vec::new();
        for airfoil in airfoils {
            let thickness = airfoil
                .thickness()
                .ok_or_else(|| BlendProblem::NoThickness {
                    airfoil: airfoil.name().to_owned(),
                })?;
            stations.push((thickness, Section::single(airfoil.clone())));
        }
        stations.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self::along_span(stations)
    }

    /// The section at a position along the span, or of a thickness.
    ///
    /// # Errors
    /// A position outside the range of the airfoils.
    pub fn section(&self, at: f64) -> Result<Section, BlendProblem> {
        let last = self.positions.len() - 1;
        let (from, to) = (self.positions[0], self.positions[last]);
        // The digits of a file.
        let slack = 1e-9 * (from.abs() + to.abs());
        if !(at >= from - slack && at <= to + slack) {
            return Err(BlendProblem::OutOfRange { at, from, to });
        }
        let i = super::cubic::interval(&self.positions, at);
        let Some(next) = self.positions.get(i + 1) else {
            return Ok(self.sections[i].clone());
        };
        let share = (at - self.positions[i]) / (next - self.positions[i]);
        Section::between(
            &self.sections[i],
            &self.sections[i + 1],
            share.clamp(0.0, 1.0),
        )
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use num_dual::Dual64;
    use shared_geom::error::Explain;

    use super::{Blend, BlendProblem, Section};
    use crate::airfoil::{Airfoil, Flow, Interpolation, LinearLift, built_in, naca0012};

    fn linear(slope: f64) -> Arc<Airfoil> {
        let lift = LinearLift {
            slope,
            ..LinearLift::default()
        };
        Arc::new(Airfoil::linear(lift))
    }

    fn naca() -> Arc<Airfoil> {
        Arc::new(built_in("naca0012").unwrap())
    }

    fn thick(thickness: f64) -> Arc<Airfoil> {
        let mut data = naca0012().with_scaled_lift(1.0 - thickness);
        data.thickness = Some(thickness);
        Arc::new(Airfoil::new(&data, Interpolation::Monotone).unwrap())
    }

    fn flow(alpha: f64) -> Flow<f64> {
        let (mach, reynolds, flap) = (0.2, 1e6, 0.0);
        Flow {
            alpha,
            mach,
            reynolds,
            flap,
        }
    }

    fn lift(section: &Section, alpha: f64) -> f64 {
        section.at(&flow(alpha)).lift
    }

    #[test]
    fn coefficients_are_linear_along_the_span() {
        let stations = [(0.0, linear(2.0)), (4.0, linear(4.0)), (5.0, linear(5.0))];
        let stations = stations.map(|(at, airfoil)| (at, Section::single(airfoil)));
        let blend = Blend::along_span(stations.to_vec()).unwrap();
        for (at, slope) in [(0.0, 2.0), (1.0, 2.5), (4.0, 4.0), (4.5, 4.5), (5.0, 5.0)] {
            let section = blend.section(at).unwrap();
            assert!((lift(&section, 0.1) - 0.1 * slope).abs() < 1e-14);
        }
        let parts = blend.section(4.0).unwrap();
        assert_eq!(parts.parts().count(), 1);
        for at in [-0.1, 5.1, f64::NAN] {
            let problem = blend.section(at).unwrap_err();
            assert!(matches!(problem, BlendProblem::OutOfRange { .. }) && problem.help().is_some());
        }
        // -0.30000000000000004 without rounding.
        let shown = blend.section(-0.1 - 0.2).unwrap_err().to_string();
        assert_eq!(shown, "no airfoil at -0.3: the airfoils are from 0 to 5");
    }

    /// Between 20 and 30 % of thickness, at the same angle; in any order.
    #[test]
    fn coefficients_are_linear_in_the_thickness() {
        let blend = Blend::by_thickness(&[thick(0.3), thick(0.2), thick(0.5)]).unwrap();
        let section = blend.section(0.225).unwrap();
        for alpha in [-2.0, 0.1, 0.3, 1.0] {
            let expected = naca().at(&flow(alpha)).lift * (1.0 - 0.225);
            assert!((lift(&section, alpha) - expected).abs() < 1e-12);
        }
        assert!(blend.section(0.19).is_err() && blend.section(0.51).is_err());
    }

    #[test]
    fn mixtures_between_mixtures_join_equal_airfoils() {
        let (a, b) = (linear(2.0), linear(6.0));
        let mix = |share: f64| {
            Section::weighted(&[(1.0 - share, a.clone()), (share, b.clone())]).unwrap()
        };
        let blend = Blend::along_span(vec![(0.0, mix(0.25)), (1.0, mix(0.75))]).unwrap();
        let middle = blend.section(0.5).unwrap();
        assert_eq!(middle.parts().count(), 2);
        assert!((lift(&middle, 0.1) - 0.4).abs() < 1e-14);
    }

    #[test]
    fn derivatives_of_a_blend_are_exact() {
        let section = Section::weighted(&[(0.3, naca()), (0.7, linear(5.0))]).unwrap();
        for k in -100..100 {
            let alpha = f64::from(k) * 0.0513;
            let others = [0.2, 1e6, 0.0].map(Dual64::from);
            let [mach, reynolds, flap] = others;
            let exact = section.at(&Flow {
                alpha: Dual64::new(alpha, 1.0),
                mach,
                reynolds,
                flap,
            });
            let difference = (lift(&section, alpha + 1e-6) - lift(&section, alpha - 1e-6)) / 2e-6;
            // Second derivatives of 1e3 at stall, in steps over a knot.
            assert!((exact.lift.eps - difference).abs() < 1e-3);
        }
    }

    #[test]
    fn odd_blends_are_problems() {
        let weighted = |weights: &[f64]| {
            let parts: Vec<_> = weights.iter().map(|weight| (*weight, naca())).collect();
            Section::weighted(&parts).err()
        };
        assert_eq!(weighted(&[]), Some(BlendProblem::Empty));
        assert!(matches!(
            weighted(&[0.5, 0.6]),
            Some(BlendProblem::Sum { .. })
        ));
        for weight in [-0.1, 1.1, f64::NAN] {
            assert!(matches!(
                weighted(&[weight]),
                Some(BlendProblem::Weight { .. })
            ));
        }
        assert_eq!(Blend::along_span(Vec::new()), Err(BlendProblem::Empty));
        assert_eq!(Blend::by_thickness(&[]), Err(BlendProblem::Empty));
        for second in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let stations = [0.0, second].map(|at| (at, Section::single(naca())));
            assert!(Blend::along_span(stations.to_vec()).is_err());
        }
        let mut data = naca0012();
        data.thickness = None;
        let unknown = Arc::new(Airfoil::new(&data, Interpolation::Monotone).unwrap());
        let problem = Blend::by_thickness(&[unknown]).unwrap_err();
        assert!(matches!(problem, BlendProblem::NoThickness { .. }));
    }
}
