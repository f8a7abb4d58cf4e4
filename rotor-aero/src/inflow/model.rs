//! The list of the inflow models.

use crate::real::Real;
use crate::unsteady::StateName;

use super::drees::Drees;
use super::mangler_squire::ManglerSquire;
use super::pitt_peters::PittPeters;
use super::rotor::{Inflow, RotorFlow, RotorLoads};
use super::uniform::Uniform;
use super::without::Without;

/// Makes the list of models: each is a type with [`Inflow`], a word for files, and a sentence.
macro_rules! models {
    ($($word:literal $name:ident $about:literal)*) => {
        /// A model of the inflow, chosen at run time.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum InflowModel {
            $(#[doc = $about] $name($name),)*
        }

        impl InflowModel {
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

        impl Inflow for InflowModel {
            fn states(&self) -> &'static [StateName] {
                match self {
                    $(Self::$name(it) => it.states(),)*
                }
            }

            fn gradients(&self) -> Option<[usize; 2]> {
                match self {
                    $(Self::$name(it) => it.gradients(),)*
                }
            }

            fn start(
                &self,
                flow: &RotorFlow<f64>,
                thrust: f64,
                states: &mut [f64],
            ) -> Option<()> {
                match self {
                    $(Self::$name(it) => it.start(flow, thrust, states),)*
                }
            }

            fn rows<T: Real>(
                &self,
                flow: &RotorFlow<T>,
                loads: &RotorLoads<T>,
                states: &[T],
                rates: &[T],
                rows: &mut [T],
            ) -> Option<()> {
                match self {
                    $(Self::$name(it) => it.rows(flow, loads, states, rates, rows),)*
                }
            }

            fn induced<T: Real>(
                &self,
                flow: &RotorFlow<T>,
                states: &[T],
                position: &[T; 2],
            ) -> Option<T> {
                match self {
                    $(Self::$name(it) => it.induced(flow, states, position),)*
                }
            }
        }
    };
}

models! {
    "none" Without "No induced velocity."
    "uniform" Uniform "Uniform inflow with the lag of the air."
    "drees" Drees "The same with a linear distribution."
    "mangler_squire" ManglerSquire "The same with a distribution of disk theory."
    "pitt_peters" PittPeters "Mean and two gradients, with the lag of the air."
}
