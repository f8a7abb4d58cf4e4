//! Strain and stress of a load case as a field file.

use nalgebra::{Vector3, Vector6};
use shared_geom::vtk::FieldFile;

use super::grid::section_grid;
use crate::recovery::{ElectricState, Recovery, Tensors};
use crate::section::Section;
use crate::solution::SectionSolution;

/// Names of the components in section axes, order of [`Tensors`].
const SECTION_AXES: [&str; 6] = ["xx", "yy", "zz", "yz", "xz", "xy"];
/// Names of the components in material axes, order of [`Tensors`].
const MATERIAL_AXES: [&str; 6] = ["11", "22", "33", "23", "13", "12"];
/// Index in the order of [`Tensors`] of each component of a symmetric tensor of VTK
/// (xx yy zz xy yz xz).
const SYMMETRIC: [usize; 6] = [0, 1, 2, 5, 3, 4];

/// Strain, stress and displacement of `recovery` on the mesh of `section`, and the means
/// of the cells. Points on the borders of regions, where stresses jump, are repeated for
/// each region. `failure` has for each criterion its name and the index of each cell, not
/// a number in cells without strengths.
///
/// The displacement is the warping under the internal force and voltages,
/// `u = X theta + X_V V`, without the rigid motion of the section, which belongs to the beam.
/// Sections with electrodes also have potential, electric field and electric displacement.
pub fn stress_vtu(
    section: &Section,
    solution: &SectionSolution,
    recovery: &Recovery,
    failure: &[(String, Vec<f64>)],
) -> FieldFile {
    let mesh = &section.mesh;
    let positions = recovery.nodes.iter().map(|state| mesh.nodes[state.node]);
    let mut file = section_grid(section, positions, |cell| recovery.cell_nodes[cell].clone());

    let tag = |node: usize| mesh.node_tags.get(node).map_or(-1, |tag| *tag as i64);
    let states = || recovery.nodes.iter();
    file.point_numbers("tag", states().map(|state| tag(state.node)).collect());
    file.point_numbers("region", states().map(|state| state.group as i64).collect());
    let mut displacement = &solution.warping * recovery.load.force;
    if let (Some(piezo), Some(electric)) = (&solution.piezo, &recovery.electric) {
        for (electrode, voltage) in piezo.electrodes.iter().zip(&electric.voltages) {
            displacement.axpy(*voltage, &electrode.warping, 1.0);
        }
    }
    let of_node = |node: usize| [0, 1, 2].map(|axis| displacement[3 * node + axis]);
    let vectors = states().flat_map(|state| of_node(state.node)).collect();
    file.point_values("displacement", 3, vectors);

    let tensors: Vec<_> = states().map(|state| state.tensors).collect();
    let add = |name: &str, components, values| file.point_values_short(name, components, values);
    add_tensors(&tensors, "", add);
    let means: Vec<_> = recovery.cells.iter().map(|cell| cell.tensors).collect();
    let add = |name: &str, components, values| file.cell_values_short(name, components, values);
    add_tensors(&means, "mean_", add);
    if let Some(electric) = &recovery.electric {
        let potential = states().map(|state| electric.potential[state.node]);
        file.point_values("potential", 1, potential.collect());
        let add = |name: &str, values| file.point_values_short(name, 3, values);
        add_fields(&electric.nodes, "", add);
        let add = |name: &str, values| file.cell_values_short(name, 3, values);
        add_fields(&electric.cells, "mean_", add);
    }
    for (criterion, indices) in failure {
        file.cell_values(&format!("failure_{criterion}"), 1, indices.clone());
    }
    file
}

/// Adds electric field and displacement as vectors x y z.
fn add_fields(states: &[ElectricState], prefix: &str, mut add: impl FnMut(&str, Vec<f32>)) {
    type Take = fn(&ElectricState) -> Vector3<f64>;
    let kinds: [(&str, Take); 2] = [
        ("electric_field", |state| state.field),
        ("electric_displacement", |state| state.displacement),
    ];
    for (name, take) in kinds {
        let vector = |state| -> [f32; 3] { take(state).map(|value| value as f32).into() };
        let values = states.iter().flat_map(vector);
        add(&format!("{prefix}{name}"), values.collect());
    }
}

/// Adds each component of stress and strain in both systems of axes, the tensors in
/// section axes, and the von Mises stress: about sixty numbers per point, in single
/// precision, which exceeds the accuracy of the mesh.
fn add_tensors(tensors: &[Tensors], prefix: &str, mut add: impl FnMut(&str, u32, Vec<f32>)) {
    type Take = fn(&Tensors) -> Vector6<f64>;
    let kinds: [(&str, Take, [&str; 6]); 4] = [
        ("stress", |t| t.stress, SECTION_AXES),
        ("stress", |t| t.material_stress, MATERIAL_AXES),
        ("strain", |t| t.strain, SECTION_AXES),
        ("strain", |t| t.material_strain, MATERIAL_AXES),
    ];
    let equivalent = tensors.iter().map(|t| t.von_mises() as f32);
    add(&format!("{prefix}von_mises"), 1, equivalent.collect());
    for (kind, take, names) in kinds {
        for (component, name) in names.iter().enumerate() {
            let values = tensors.iter().map(|t| take(t)[component] as f32);
            add(&format!("{prefix}{kind}_{name}"), 1, values.collect());
        }
    }
    let tensor = |stress: Vector6<f64>| SYMMETRIC.map(|component| stress[component] as f32);
    let stresses = tensors.iter().flat_map(|t| tensor(t.stress));
    add(&format!("{prefix}stress"), 6, stresses.collect());
    // the shears of a tensor are half of the engineering shears
    let whole = Vector6::new(1.0, 1.0, 1.0, 0.5, 0.5, 0.5);
    let strains = tensors
        .iter()
        .flat_map(|t| tensor(t.strain.component_mul(&whole)));
    add(&format!("{prefix}strain"), 6, strains.collect());
}
