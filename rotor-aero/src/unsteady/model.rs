//! The list of the models of unsteady sections.

use crate::real::Real;

use super::dynamic_stall::DynamicStall;
use super::hgm::Hgm;
use super::lagged::Lagged;
use super::oye::Oye;
use super::polar::Polar;
use super::quasi_steady::QuasiSteady;
use super::section::{Model, SectionFlow, SectionForce, StateName, Strip};
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

impl Default for SectionModel {
    fn default() -> Self {
        Self::SeparationLag(SeparationLag::default())
    }
}
