//! Warnings about valid but unusual materials.

use super::electric::ElectricWarning;
use super::electrodes::WrittenElectrodes;
use super::materials::WrittenMaterial;
use super::plausible;
use super::summary::InputWarning;
use crate::material::{ElasticLaw, Material, VACUUM_PERMITTIVITY};

/// Warnings about `materials`; `of_region` has the material of each region.
pub(super) fn warnings_of(
    materials: &[WrittenMaterial],
    of_region: &[usize],
    electrodes: &WrittenElectrodes,
) -> Vec<InputWarning> {
    let mut warnings = electric_warnings(materials, of_region, electrodes);
    let expansion = |&index: &usize| {
        let material = materials[index].material.as_ref();
        material.and_then(|known| known.expansion)
    };
    let is_heated = of_region.iter().any(|index| expansion(index).is_some());
    for (index, written) in materials.iter().enumerate() {
        let material = written.name.clone();
        if !of_region.contains(&index) {
            let line = written.line;
            warnings.push(InputWarning::UnusedMaterial { material, line });
        } else if written
            .material
            .as_ref()
            .is_some_and(|known| known.density == 0.0 && known.law != ElasticLaw::Absent)
        {
            warnings.push(InputWarning::NoDensity { material });
        }
        if of_region.contains(&index) {
            let unlikely = plausible::of_material(written);
            warnings.extend(unlikely.map(InputWarning::Unlikely));
        }
        let is_stiff = |known: &Material| known.law != ElasticLaw::Absent;
        let is_stiff = written.material.as_ref().is_some_and(is_stiff);
        if is_heated && is_stiff && of_region.contains(&index) && expansion(&index).is_none() {
            let material = written.name.clone();
            warnings.push(InputWarning::NoExpansion { material });
        }
    }
    warnings
}

/// Warnings about electric laws.
fn electric_warnings(
    materials: &[WrittenMaterial],
    of_region: &[usize],
    electrodes: &WrittenElectrodes,
) -> Vec<InputWarning> {
    let mut warnings = Vec::new();
    for (index, written) in materials.iter().enumerate() {
        let Some(electric) = &written.electric else {
            continue;
        };
        let material = written.name.clone();
        for constants in electric.alone.iter().cloned() {
            let material = material.clone();
            warnings.push(ElectricWarning::AloneConstant {
                material,
                constants,
            });
        }
        let smallest = electric.law.permittivity.symmetric_eigenvalues().min();
        let relative = smallest / VACUUM_PERMITTIVITY;
        if relative < 1.0 - 1e-6 {
            let material = material.clone();
            warnings.push(ElectricWarning::BelowVacuum { material, relative });
        }
        let is_used = of_region.contains(&index) && electric.law.is_piezoelectric();
        if is_used && electrodes.is_empty() {
            warnings.push(ElectricWarning::NoElectrodes { material });
        }
    }
    warnings.into_iter().map(InputWarning::Electric).collect()
}
