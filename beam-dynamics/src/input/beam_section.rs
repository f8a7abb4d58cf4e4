//! The section of a beam: its matrices, its law, and the heat and imposed strains that act.

use nalgebra::{Matrix4, Matrix6, Vector6};
use shared_geom::document::Table;
use shared_geom::section::{CubicTable, Damping, ImposedState, Piezo, SectionProperties};

use super::curved::Curved;
use super::problem::InputProblem;
use crate::elements::laws::{Driven, Law};

/// Name of a uniform rise of temperature.
pub(super) const TEMPERATURE: &str = "temperature";

/// Section data of a beam, in section axes about the reference line.
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
    /// Effects of heat and imposed strains on the section.
    pub heat: Heat,
    /// Effect of prestress on the stiffness; `None` if it is not requested.
    pub prestress: Option<CubicTable>,
    /// Reason why critical loads ignore torsional buckling, as text; `None` if they include
    /// it, and for numbers in the card.
    pub torsional_buckling: Option<&'static str>,
    /// Electrodes; `None` without.
    pub piezo: Option<Piezo>,
    /// Curvature for which the section was solved; `None` for a straight beam.
    pub curved: Option<Curved>,
}

/// Effects of heat and imposed strains on a section.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Heat {
    /// Internal force per kelvin of the restrained section \[N/K, N m/K\]; `None` if unknown.
    pub thermal_force: Option<Vector6<f64>>,
    /// Named states.
    pub imposed: Vec<ImposedState>,
    /// Change of the stiffness per kelvin \[N/K, N m/K, N m^2/K\]; `None` if unknown.
    pub stiffness_per_kelvin: Option<Matrix4<f64>>,
    /// The acting states, of the card that was read last.
    pub acting: Vec<Acting>,
}

/// An acting state of heat or imposed strain.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Acting {
    /// The card that defines it, as text.
    pub card: String,
    /// Its name: "temperature", or the name of the state.
    pub name: String,
    /// Force of the restrained section \[N, N m\], multiplied by its drive.
    pub force: Driven<6>,
    /// Change of the stiffness for the drive one, in the components of a table of prestress
    /// \[N, N m, N m^2\]; `None` if unknown.
    pub stiffness: Option<Matrix4<f64>>,
}

impl Heat {
    /// The data of a section.
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

    /// States without an effect on the stiffness in the property file.
    pub fn without_stiffness(&self) -> Vec<&str> {
        let kelvin = self.thermal_force.is_some() && self.stiffness_per_kelvin.is_none();
        let kelvin = kelvin.then_some(TEMPERATURE);
        let states = self.imposed.iter();
        let states = states.filter(|state| state.stiffness_change.is_none());
        let states = states.map(|state| state.name.as_str());
        kelvin.into_iter().chain(states).collect()
    }

    /// The acting states: restrained forces, multiplied by drives.
    pub fn acting(&self) -> &[Acting] {
        &self.acting
    }
}

/// The matrices of valid properties; notes problems under `key`.
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
