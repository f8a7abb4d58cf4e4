//! The section of a beam: its matrices, its law, and the heat and imposed strains that act.

use nalgebra::{Matrix4, Matrix6, Vector6};
use shared_geom::document::Table;
use shared_geom::section::{CubicTable, Damping, ImposedState, Piezo, SectionProperties};

use super::curved::Curved;
use super::problem::InputProblem;
use crate::elements::laws::{Driven, Law};

/// What an even rise of temperature is called.
pub(super) const TEMPERATURE: &str = "temperature";

/// What a beam needs of its section, in section axes about the reference line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Properties {
    /// 6x6 stiffness \[N, N m, N m^2\].
    pub stiffness: Matrix6<f64>,
    /// 6x6 mass per length \[kg/m, kg, kg m\].
    pub mass: Matrix6<f64>,
    /// 6x6 viscosity; `None` without internal damping \[N s, N m s, N m^2 s\].
    pub damping: Option<Matrix6<f64>>,
    /// Law in place of stiffness and viscosity; `None` for these.
    pub law: Option<Law<6>>,
    /// What heat and imposed strains do to the section.
    pub heat: Heat,
    /// Effect of prestress on the stiffness; `None` where it is not asked for.
    pub prestress: Option<CubicTable>,
    /// Why critical loads know nothing of torsional buckling, in words; `None` where they
    /// do, and for numbers in place.
    pub torsional_buckling: Option<&'static str>,
    /// Electrodes; `None` without.
    pub piezo: Option<Piezo>,
    /// What the section was solved for; `None` for a straight beam.
    pub curved: Option<Curved>,
}

/// What heat and imposed strains do to a section.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Heat {
    /// Internal force per kelvin when held \[N/K, N m/K\]; `None` where it is not known.
    pub thermal_force: Option<Vector6<f64>>,
    /// Named states.
    pub imposed: Vec<ImposedState>,
    /// Change of the stiffness per kelvin \[N/K, N m/K, N m^2/K\]; `None` where it is not
    /// known.
    pub stiffness_per_kelvin: Option<Matrix4<f64>>,
    /// What acts, of the card that was read last.
    pub acting: Vec<Acting>,
}

/// A state of heat or imposed strain that acts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Acting {
    /// The card that says it, in words.
    pub card: String,
    /// What it is called: "temperature", or the name of the state.
    pub name: String,
    /// Force of the section that is held \[N, N m\], times its drive.
    pub force: Driven<6>,
    /// Change of the stiffness for the drive one, over the components of a table of
    /// prestress \[N, N m, N m^2\]; `None` where it is not known.
    pub stiffness: Option<Matrix4<f64>>,
}

impl Heat {
    /// What is known of a section.
    pub fn of(properties: &SectionProperties) -> Self {
        Self {
            thermal_force: properties.thermal_force,
            imposed: properties.imposed.clone(),
            stiffness_per_kelvin: properties
                .prestress
                .and_then(|prestress| prestress.per_kelvin),
            acting: Vec::new(),
        }
    }

    /// States whose effect on the stiffness the property file does not have.
    pub fn without_stiffness(&self) -> Vec<&str> {
        let kelvin = self.thermal_force.is_some() && self.stiffness_per_kelvin.is_none();
        let kelvin = kelvin.then_some(TEMPERATURE);
        let states = self.imposed.iter();
        let states = states.filter(|state| state.stiffness_change.is_none());
        let states = states.map(|state| state.name.as_str());
        kelvin.into_iter().chain(states).collect()
    }

    /// What acts: forces that are held, times drives.
    pub fn acting(&self) -> &[Acting] {
        &self.acting
    }
}

/// The matrices of sound properties; notes under `key` what is unsound.
pub(super) fn usable(
    name: &str,
    table: &Table<'_>,
    key: &str,
    properties: &SectionProperties,
) -> Option<Properties> {
    let problems = properties.problems();
    for problem in &problems {
        let (name, problem) = (name.to_owned(), problem.clone());
        table.note(key, &InputProblem::Unsound { name, problem });
    }
    problems.is_empty().then(|| Properties {
        curved: None,
        stiffness: properties.stiffness,
        mass: properties.mass,
        damping: properties.damping.as_ref().map(|damping| match damping {
            Damping::StiffnessProportional(time) => *time * properties.stiffness,
            Damping::Viscous(matrix) => *matrix,
        }),
        law: None,
        heat: Heat::of(properties),
        prestress: None,
        torsional_buckling: None,
        piezo: properties.piezo.clone(),
    })
}
