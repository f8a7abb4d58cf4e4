//! Conditions that states of imposed strain must satisfy, and their change of the
//! stiffness.

use nalgebra::{Matrix4, Vector4};

use super::{FieldProblem, PropertyProblem, SYMMETRY};
use crate::section::{ImposedState, PRESTRESS_COMPONENTS, SectionProperties};

/// Unique names, finite numbers, and forces that agree with the strains.
pub(super) fn check(section: &SectionProperties, found: &mut Vec<FieldProblem>) {
    let field = "imposed";
    let root = section.stiffness.diagonal().map(f64::sqrt);
    for (i, state) in section.imposed.iter().enumerate() {
        let name = || state.name.clone();
        if section.imposed[..i]
            .iter()
            .any(|one| one.name == state.name)
        {
            found.push((field, PropertyProblem::ImposedTwice { name: name() }));
        }
        let (force, strain) = (&state.restrained_force, &state.free_strain);
        if !force.iter().chain(strain).all(|value| value.is_finite()) {
            let field = "restrained_force or free_strain";
            let problem = PropertyProblem::NotFinite { field };
            found.push(("imposed", of_state((i, state), problem)));
            continue;
        }
        if let Some(change) = &state.stiffness_change {
            let mut own = Vec::new();
            change_of_stiffness("stiffness_change", section, change, &mut own);
            let own = own.into_iter();
            found.extend(own.map(|(field, problem)| (field, of_state((i, state), problem))));
        }
        // relative to the largest force of the strain, in terms of the stiffness
        let scale = largest(
            strain.component_mul(&root).amax(),
            force.component_div(&root).amax(),
        );
        let difference = force + section.stiffness * strain;
        let worst = difference.component_div(&root).amax();
        if worst > SYMMETRY * scale {
            let error = worst / scale;
            let problem = PropertyProblem::ImposedForce {
                name: name(),
                error,
            };
            found.push((field, problem));
        }
    }
}

fn of_state((index, state): (usize, &ImposedState), problem: PropertyProblem) -> PropertyProblem {
    PropertyProblem::OfState {
        index,
        name: state.name.clone(),
        problem: Box::new(problem),
    }
}

fn largest(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// A change of the stiffness over the components of a table of prestress: finite, and
/// symmetric relative to its largest entry, entries made comparable by the stiffness.
pub(super) fn change_of_stiffness(
    field: &'static str,
    section: &SectionProperties,
    change: &Matrix4<f64>,
    found: &mut Vec<FieldProblem>,
) {
    if !change.iter().all(|value| value.is_finite()) {
        return found.push((field, PropertyProblem::NotFinite { field }));
    }
    let root = PRESTRESS_COMPONENTS.map(|component| section.stiffness[(component, component)]);
    let root = Vector4::from(root).map(f64::sqrt);
    let scaled = change.component_div(&(root * root.transpose()));
    let limit = SYMMETRY * scaled.amax();
    for i in 0..4 {
        for j in i + 1..4 {
            if (scaled[(i, j)] - scaled[(j, i)]).abs() > limit {
                let problem = PropertyProblem::Asymmetric {
                    field,
                    row: i + 1,
                    column: j + 1,
                    upper: change[(i, j)],
                    lower: change[(j, i)],
                };
                return found.push((field, problem));
            }
        }
    }
}
