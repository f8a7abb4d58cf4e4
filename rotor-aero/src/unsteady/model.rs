//! The list of the models of unsteady sections.

use crate::airfoil::Section;
use crate::real::Real;

use super::dynamic_stall::DynamicStall;
use super::hgm::Hgm;
use super::lagged::Lagged;
use super::oye::Oye;
use super::polar::Polar;
use super::quasi_steady::QuasiSteady;
use super::section::{Adjustable, Constant, Model, SectionFlow, SectionForce, StateName, Strip};
use super::separation_lag::SeparationLag;

/// Makes the list of models: each is a type with [`Model`], a word for files, and a sentence.
macro_rules! models {
    ($($word:literal $name:ident $about:literal)*) => {
        /// A model of an unsteady section, chosen at run time.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum SectionModel {
            $(#[doc = $about] $name($name),)*
        }

        impl SectionModel {
            /// Words of the models, as files name them.
            pub const WORDS: &'static [&'static str] = &[$($word),*];

            /// The model of a word with its usual constants.
            pub fn of_word(word: &str) -> Option<Self> {
                match word {
                    $($word => Some(Self::$name($name::default())),)*
                    _ => None,
                }
            }

            fn constants(&mut self) -> Vec<Constant<'_>> {
                match self {
                    $(Self::$name(it) => it.constants(),)*
                }
            }

            /// The word of the model.
            pub fn word(&self) -> &'static str {
                match self {
                    $(Self::$name(_) => $word,)*
                }
            }
        }

        impl Model for SectionModel {
            fn states(&self) -> &'static [StateName] {
                match self {
                    $(Self::$name(it) => it.states(),)*
                }
            }

            fn needs_start(&self) -> bool {
                match self {
                    $(Self::$name(it) => it.needs_start(),)*
                }
            }

            fn start<P: Polar>(
                &self,
                strip: &Strip,
                polar: &P,
                flow: &SectionFlow<f64>,
                states: &mut [f64],
            ) -> Option<()> {
                match self {
                    $(Self::$name(it) => it.start(strip, polar, flow, states),)*
                }
            }

            fn evaluate<T: Real, P: Polar>(
                &self,
                strip: &Strip,
                polar: &P,
                flow: &SectionFlow<T>,
                states: &[T],
                rates: &[T],
                rows: &mut [T],
            ) -> Option<SectionForce<T>> {
                match self {
                    $(Self::$name(it) => {
                        it.evaluate(strip, polar, flow, states, rates, rows)
                    })*
                }
            }
        }
    };
}

models! {
    "quasi_steady" QuasiSteady "Static coefficients."
    "lagged" Lagged "Lag of circulation and added mass."
    "separation_lag" SeparationLag "The same and a lag of separation."
    "dynamic_stall" DynamicStall "The same, a lag of pressure and a vortex."
    "oye" Oye "Lag of separation alone."
    "hgm" Hgm "Lags of circulation, pressure and separation."
}

/// Constants of the split of lift, which models with separation use.
pub(crate) const OF_SPLIT: [&str; 2] = ["alpha0", "C_nalpha"];

/// Constants of the attached part by a formula, which the model with a vortex uses.
pub(crate) const OF_FORMULA: [&str; 3] = ["alpha1", "S1", "S2"];

impl SectionModel {
    /// The model with the constants that an airfoil or a blend of airfoils states. Times and rates that
    /// are not positive are left as they are.
    #[must_use]
    pub fn of_section(mut self, section: &Section) -> Self {
        for (name, value) in self.constants() {
            let is_free = name.starts_with('A') || name.starts_with('K');
            let is_usable = |own: &f64| own.is_finite() && (is_free || *own > 0.0);
            if let Some(own) = section.constant(name, *value).filter(is_usable) {
                *value = own;
            }
        }
        self
    }

    /// Whether its attached part may be given by a formula.
    pub(crate) fn has_formula(&self) -> bool {
        matches!(self, Self::DynamicStall(_))
    }

    /// Names of the constants of airfoils that the model uses.
    pub fn used_constants(mut self) -> Vec<&'static str> {
        let mut all: Vec<_> = self.constants().into_iter().map(|(name, _)| name).collect();
        if !matches!(self, Self::QuasiSteady(_) | Self::Lagged(_)) {
            all.extend(OF_SPLIT);
        }
        if self.has_formula() {
            all.extend(OF_FORMULA);
        }
        all
    }
}

impl Default for SectionModel {
    fn default() -> Self {
        Self::SeparationLag(SeparationLag::default())
    }
}
