use super::*;
use crate::analysis::analyze;
use crate::material::{EngineeringConstants, Material};
use crate::section::samples::{PLY, of_quadrilaterals};

fn square() -> Section {
    let node = |n: usize| [(n % 5) as f64, (n / 5) as f64];
    let nodes: Vec<_> = (0..25).map(node).collect();
    let cell = |n: usize| {
        let first = (5 * (n / 4) + n % 4) as u32;
        [first, first + 1, first + 6, first + 5]
    };
    let cells: Vec<_> = (0..16).map(cell).collect();
    of_quadrilaterals(&nodes, &cells)
}

fn restrained(section: &Section) -> Result<RestrainedWarping, NoRestrainedWarping> {
    let solution = analyze(section).expect("sound");
    RestrainedWarping::new(section, &solution.warping, &solution.strain)
}

#[test]
fn an_anisotropic_material_is_named_and_an_unused_one_is_not() {
    let mut section = square();
    section.materials.push(Material {
        name: "ply".into(),
        law: ElasticLaw::Orthotropic(PLY),
        density: 1.0,
        expansion: None,
        electric: None,
    });
    assert!(restrained(&section).is_ok());
    section.cells[3].material = 1;
    let reason = restrained(&section).expect_err("not isotropic");
    assert!(
        reason
            .to_string()
            .starts_with("material \"ply\" is not isotropic")
    );
}

/// The same material written in three ways: the same constants to round-off.
#[test]
fn an_isotropic_law_is_known_however_it_is_written() {
    let plain = square();
    let (young, nu) = (1.0, 0.3);
    let shear = young / (2.0 * (1.0 + nu));
    let law = plain.materials[0].law.stiffness();
    let orthotropic = EngineeringConstants {
        e1: young,
        e2: young,
        e3: young,
        g12: shear,
        g13: shear,
        g23: shear,
        nu12: nu,
        nu13: nu,
        nu23: nu,
    };
    let expected = restrained(&plain).expect("isotropic");
    for law in [ElasticLaw::Orthotropic(orthotropic), ElasticLaw::Full(law)] {
        let mut section = plain.clone();
        section.materials[0].law = law;
        let found = restrained(&section).expect("isotropic");
        assert!((found.stiffness / expected.stiffness - 1.0).abs() < 1e-11);
        let constant = found.constant.expect("one material") * young;
        assert!((constant / expected.stiffness - 1.0).abs() < 1e-11);
    }
}

/// The weighted mean of omega vanishes, here by the mean of the corners of each square,
/// which is exact for bilinear functions. Two moduli leave no single constant.
#[test]
fn two_moduli_have_a_stiffness_but_no_constant() {
    let mut section = square();
    section.materials.push(Material {
        name: "stiff".into(),
        law: ElasticLaw::Isotropic {
            young: 10.0,
            poisson: 0.3,
        },
        density: 1.0,
        expansion: None,
        electric: None,
    });
    for cell in section.cells.iter_mut().skip(9) {
        cell.material = 1;
    }
    let found = restrained(&section).expect("isotropic");
    assert_eq!(found.constant, None);
    let mut mean = 0.0;
    for (cell, of) in section.mesh.cells.iter().zip(&section.cells) {
        let young = if of.material == 1 { 10.0 } else { 1.0 };
        let corners = cell
            .nodes()
            .iter()
            .map(|&node| found.function[node as usize]);
        mean += young * corners.sum::<f64>() / 4.0;
    }
    assert!(mean.abs() < 1e-12 * found.stiffness.sqrt(), "{mean:e}");
    let length = (found.stiffness / found.torsional_stiffness).sqrt();
    assert_eq!(found.decay_length, length);
}

/// The assumption of (S-62): under a torque the section is only sheared, also with
/// different Poisson ratios and without symmetry; to round-off, relative to
/// `sqrt(C_ii C_44)`. The shear center is then not quite the shear-flow center.
#[test]
fn torsion_of_isotropic_materials_shears_only() {
    let mut section = square();
    section.materials.push(Material {
        name: "rubber".into(),
        law: ElasticLaw::Isotropic {
            young: 3.0,
            poisson: 0.45,
        },
        density: 1.0,
        expansion: None,
        electric: None,
    });
    for cell in section.cells.iter_mut().skip(9) {
        cell.material = 1;
    }
    let solution = analyze(&section).expect("sound");
    let scale = |i: usize| (solution.strain[(i, i)] * solution.strain[(3, 3)]).sqrt();
    for i in [0, 4, 5] {
        let relative = solution.strain[(i, 3)] / scale(i);
        assert!(relative.abs() < 1e-13, "{i}: {relative:e}");
    }
    let found = restrained(&section).expect("isotropic");
    let shear = solution.centers.shear;
    let apart = (found.center[0] - shear[0]).hypot(found.center[1] - shear[1]);
    println!("centers are {apart:e} apart");
    assert!(apart > 1e-5 && apart < 0.1, "{apart:e}");
}
