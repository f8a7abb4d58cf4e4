//! The section properties in the form of the property file, common to both programs.

use nalgebra::Vector2;
use shared_geom::section::{
    Centers, ImposedState, InitialCurvature, Piezo, PrincipalAxes, Provenance, SectionProperties,
    StrainMeasure,
};

use crate::properties::{FreeState, NoPrestress, prestress, prestress_of_imposed};
use crate::section::Section;
use crate::solution::{ImposedSolution, ImposedSolutions, SectionSolution};

/// Section and input of the properties.
#[derive(Debug)]
pub(super) struct Source<'a> {
    pub name: &'a str,
    pub nodes: usize,
    pub cells: usize,
    pub initial_curvature: InitialCurvature,
    pub input_hash: &'a str,
}

/// The properties of `section` in the circuit of its electrodes,
/// [`SectionSolution::in_circuit`], with the fingerprint of the input. Voltages of floating
/// electrodes that the circuit leaves undetermined are set to zero.
///
/// Thermal forces and imposed states of a section with floating electrodes are unknown and
/// omitted. The reference point is the origin of the mesh. The mass center of a section
/// without mass, which has no effect, is set to the reference point.
pub fn properties(
    section: &Section,
    solution: &SectionSolution,
    imposed: &ImposedSolutions,
    input_hash: &str,
) -> SectionProperties {
    let source = Source {
        name: &section.name,
        nodes: section.mesh.nodes.len(),
        cells: section.mesh.cells.len(),
        initial_curvature: section.initial_curvature,
        input_hash,
    };
    let known = if solution.has_open_electrodes() {
        &ImposedSolutions::default()
    } else {
        imposed
    };
    SectionProperties {
        thermal_force: known.per_kelvin.as_ref().map(|one| one.restrained_force),
        imposed: known.states.iter().map(imposed_state).collect(),
        piezo: piezo(solution),
        ..properties_of(
            &source,
            &solution.in_circuit().unwrap_or_else(|_| solution.clone()),
        )
    }
}

/// Driven electrodes, with the others at ground or open; `None` without driven electrodes.
fn piezo(solution: &SectionSolution) -> Option<Piezo> {
    let piezo = solution.piezo.as_ref()?;
    let circuit = |electrode: usize| piezo.electrodes[electrode].circuit;
    let driven = piezo.in_circuit(&solution.stiffness, circuit)?;
    let names = driven.electrodes.iter();
    let names: Vec<_> = names.map(|&k| piezo.electrodes[k].name.clone()).collect();
    (!names.is_empty()).then_some(Piezo {
        electrodes: names,
        coupling: driven.coupling,
        capacitance: driven.capacitance,
    })
}

/// Adds to `properties` of `section` the changes of the stiffness by internal forces and
/// imposed states.
///
/// # Errors
/// [`NoPrestress`].
pub fn add_prestress(
    properties: &mut SectionProperties,
    section: &Section,
    solution: &SectionSolution,
    imposed: &ImposedSolutions,
    measure: StrainMeasure,
) -> Result<(), NoPrestress> {
    let (warping, strain) = (&solution.warping, &solution.strain);
    let mut found = prestress(section, warping, strain, measure)?;
    let free = |solved| free_state(solved);
    let states: Vec<_> = imposed
        .per_kelvin
        .iter()
        .chain(&imposed.states)
        .map(free)
        .collect();
    let changes = prestress_of_imposed(section, warping, strain, measure, &states)?;
    let mut changes = changes.into_iter();
    if imposed.per_kelvin.is_some() {
        found.per_kelvin = changes.next();
    }
    for (state, change) in properties.imposed.iter_mut().zip(changes) {
        state.stiffness_change = Some(change);
    }
    properties.prestress = Some(found);
    Ok(())
}

fn free_state(solved: &ImposedSolution) -> FreeState<'_> {
    FreeState {
        imposed: &solved.state,
        warping: &solved.warping,
        strain: &solved.free_strain,
    }
}

/// The properties of `source`.
pub(super) fn properties_of(source: &Source<'_>, solution: &SectionSolution) -> SectionProperties {
    let centers = &solution.centers;
    let bending = &solution.principal_bending;
    let inertia = solution.principal_inertia.as_ref();
    SectionProperties {
        name: source.name.to_owned(),
        reference_point: Vector2::zeros(),
        stiffness: solution.stiffness,
        mass: solution.mass,
        centers: Centers {
            tension: Vector2::from(centers.tension),
            shear: Vector2::from(centers.shear),
            mass: centers.mass.map_or_else(Vector2::zeros, Vector2::from),
        },
        principal_axes: PrincipalAxes {
            bending_angle: bending.angle,
            bending_stiffness: [bending.first, bending.second],
            inertia_angle: inertia.map_or(0.0, |axes| axes.angle),
            inertia: inertia.map_or([0.0; 2], |axes| [axes.first, axes.second]),
        },
        initial_curvature: (!source.initial_curvature.is_straight())
            .then_some(source.initial_curvature),
        piezo: None,
        thermal_force: None,
        imposed: Vec::new(),
        damping: None,
        prestress: None,
        provenance: Provenance {
            program: env!("CARGO_PKG_NAME").to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            input_hash: source.input_hash.to_owned(),
            nodes: source.nodes,
            cells: source.cells,
            history: Vec::new(),
            sections: Vec::new(),
        },
    }
}

fn imposed_state(solved: &ImposedSolution) -> ImposedState {
    ImposedState {
        name: solved.state.name.clone(),
        restrained_force: solved.restrained_force,
        free_strain: solved.free_strain,
        stiffness_change: None,
    }
}
