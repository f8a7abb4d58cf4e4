//! Warnings about valid but unusual materials.

use super::electric::ElectricWarning;
use super::electrodes::WrittenElectrodes;
use super::materials::WrittenMaterial;
use super::plausible;
use super::summary::{AngleSource, InputWarning, RegionSummary};
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

/// Warnings about fiber angles of isotropic materials that expand equally along all axes;
/// `of_region` has the material of each of `regions`.
pub(super) fn idle_angles(
    regions: &[RegionSummary],
    materials: &[WrittenMaterial],
    of_region: &[usize],
) -> Vec<InputWarning> {
    let is_isotropic = |&index: &usize| {
        let material = materials[index].material.as_ref();
        material.is_some_and(|known| {
            let is_uniform = |[a, b, c]: [f64; 3]| a == b && b == c;
            matches!(known.law, ElasticLaw::Isotropic { .. })
                && known.electric.is_none()
                && known.expansion.is_none_or(is_uniform)
        })
    };
    let has_angle = |region: &RegionSummary| region.fiber_angle != AngleSource::Constant(0.0);
    let regions = regions.iter().zip(of_region);
    let idle = regions.filter(|(region, index)| has_angle(region) && is_isotropic(index));
    let warning = |region: &RegionSummary| InputWarning::IdleAngle {
        region: region.group.clone(),
        material: region.material.clone(),
    };
    idle.map(|(region, _)| warning(region)).collect()
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
