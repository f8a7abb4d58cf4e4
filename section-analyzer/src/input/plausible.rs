//! Numbers that are valid, but that no material and hardly a section has: likely units.
//!
//! The speed of sound of a material is `c = sqrt(E / rho)`. Metals, wood, glass, laminates
//! and fibers have 1.2 (lead) to 20 km/s (carbon fiber), plastics 0.5 to 2, foams 0.3 to 1,
//! rubber and silicone 10 to 100 m/s. The bounds are outside of all of them.

use std::fmt;

use shared_geom::figure::tick_label;

use super::materials::WrittenMaterial;
use crate::material::{ElasticLaw, Material};

/// Speed of sound below which an isotropic material is suspect: silicone of 0.1 MPa has
/// 9.5 m/s, steel of 210000 Pa (MPa forgotten) 5.2 [m/s].
const SLOW: f64 = 8.0;
/// The same for materials with directions, which are not as soft in their stiffest one:
/// the softest honeycombs have 300 m/s, plies of glass of 42 MPa (GPa forgotten) 147 [m/s].
const SLOW_ANISOTROPIC: f64 = 200.0;
/// Speed of sound above which a material is suspect: carbon fibers have at most 20 km/s
/// [m/s].
const FAST: f64 = 25_000.0;
/// Modulus below which a material without mass is suspect: gels, a fortieth of the softest
/// silicone [Pa].
const SOFT: f64 = 2.5e3;
/// Modulus above which a material is suspect: diamond and carbon fibers have up to 1.2e12
/// [Pa].
const STIFF: f64 = 2e12;
/// Densities of materials with stiffness: the lightest foams of structures have 15, osmium
/// 22 590 [kg/m^3].
const DENSITIES: (f64, f64) = (5.0, 23_000.0);
/// Size of a section above which its unit is suspect: towers of wind turbines have a
/// diameter of 10 m, blades a chord of up to 8 m [m].
const LARGE: f64 = 20.0;
/// Size above which a section has walls: solid parts are not larger than chords of blades [m].
const WALLED: f64 = 8.0;
/// The same for parts of metals and of plies: solid shafts have up to 1.5 [m].
const PLATED: f64 = 2.0;
/// Modulus above which materials are metals and carbon, which form walls: concrete has up to 50 GPa
/// [Pa].
const METALS: f64 = 55e9;
/// The same of materials with directions: wood has up to 20 GPa, plies of glass 30 or more [Pa].
const PLIES: f64 = 25e9;
/// Thickness of the thinnest cell of such a section above which its unit is suspect: walls of towers
/// of steel have up to 0.15, walls of concrete 0.3 and two or more cells [m].
const THICK: f64 = 0.2;
/// Sizes of a section below which its unit is suspect, if its coordinates are not in meters or
/// micrometers: alone, or with cells thinner than `THIN`, as of a ply of 0.1 mm in meters read as
/// millimeters [m].
const SMALL: (f64, f64) = (1e-3, 1e-2);
/// Films of 5 are made [m].
const THIN: f64 = 2e-6;
/// Factors of units in which sections are drawn by hand: mm, cm, in [m].
const DRAWN: (f64, f64) = (0.9e-3, 0.03);

/// Units in which a number may have been meant, and their factors [Pa, kg/m^3, m].
const MODULI: [(&str, f64); 3] = [("GPa", 1e9), ("MPa", 1e6), ("psi", 6_894.757_293_168)];
const HEAVY: [(&str, f64); 2] = [("g/cm^3", 1e3), ("t/mm^3", 1e12)];
/// Speeds of sound and moduli of usual materials, for proposals [m/s], [Pa].
const USUAL_SPEEDS: (f64, f64) = (200.0, 20_000.0);
const USUAL_MODULI: (f64, f64) = (1e6, 1.2e12);

/// A number that is likely in another unit.
#[derive(Debug, Clone, PartialEq)]
pub enum UnlikelyInput {
    /// A modulus that no material has, alone or with its density.
    Modulus {
        /// Name of the material.
        material: String,
        /// The largest modulus \[Pa\].
        modulus: f64,
        /// Its speed of sound; `None` without density \[m/s\].
        speed: Option<f64>,
        /// The likely mistake, as text.
        likely: Option<String>,
    },
    /// A density that no material has.
    Density {
        /// Name of the material.
        material: String,
        /// The density \[kg/m^3\].
        density: f64,
        /// The likely mistake, as text.
        likely: Option<String>,
    },
    /// A section larger or smaller than sections are, alone or for the thickness of its cells.
    Size {
        /// Its largest extent along an axis \[m\].
        size: f64,
        /// Thickness of its thinnest cell, if that makes it unlikely \[m\].
        cell: Option<f64>,
        /// Name of the unit of its mesh.
        unit: String,
    },
}

impl fmt::Display for UnlikelyInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let likely = match self {
            Self::Modulus {
                material,
                modulus,
                speed,
                likely,
            } => {
                write!(
                    f,
                    "material \"{material}\": no known material has the modulus {modulus:.3e} Pa"
                )?;
                if let Some(speed) = speed {
                    write!(f, " at its density (speed of sound {speed:.3e} m/s)")?;
                }
                likely
            }
            Self::Density {
                material,
                density,
                likely,
            } => {
                write!(
                    f,
                    "material \"{material}\": no known material with a stiffness has the density \
                     {density:.3e} kg/m^3"
                )?;
                likely
            }
            Self::Size { size, cell, unit } => {
                write!(f, "the section is {} large", length(*size))?;
                if let Some(cell) = cell {
                    write!(f, ", and its thinnest cell is {} thick", length(*cell))?;
                }
                return write!(
                    f,
                    ": check that the coordinates of the mesh are in {unit}, as \"length\" of the \
                     units states"
                );
            }
        };
        match likely {
            Some(likely) => write!(f, ": {likely}"),
            None => f.write_str(": check the units"),
        }
    }
}

/// Remark on a material.
pub(super) fn of_material(written: &WrittenMaterial) -> Option<UnlikelyInput> {
    written.material.as_ref().and_then(unlikely)
}

/// A length in m or, if it is short, in mm, as text.
fn length(value: f64) -> String {
    match value < 0.1 {
        true => format!("{} mm", tick_label(1e3 * value, 0.0)),
        false => format!("{} m", tick_label(value, 0.0)),
    }
}

/// Whether parts of a material have walls, from a certain size on: metals and plies.
pub(super) fn forms_walls(material: &Material) -> bool {
    let least = match material.law {
        ElasticLaw::Isotropic { .. } => METALS,
        _ => PLIES,
    };
    largest_modulus(&material.law).is_some_and(|modulus| modulus > least)
}

/// Remark on the extent `size` of a mesh and the thickness of its thinnest `cell` \[m\], with coordinates
/// in `unit`, of which one is `factor` \[m\]; `has_walls` if a material forms walls.
pub(super) fn of_size(
    [size, cell]: [f64; 2],
    has_walls: bool,
    (unit, factor): (&str, f64),
) -> Option<UnlikelyInput> {
    let walled = if has_walls { PLATED } else { WALLED };
    let is_drawn = (DRAWN.0..DRAWN.1).contains(&factor);
    let is_alone = size > LARGE || is_drawn && size < SMALL.0;
    let by_cell = (size > walled && cell > THICK) || (is_drawn && size < SMALL.1 && cell < THIN);
    (is_alone || by_cell).then(|| UnlikelyInput::Size {
        size,
        cell: (!is_alone).then_some(cell),
        unit: unit.to_owned(),
    })
}

/// The unlikely number of a material: its density, or its modulus.
fn unlikely(material: &Material) -> Option<UnlikelyInput> {
    let modulus = largest_modulus(&material.law)?;
    let (name, density) = (material.name.clone(), material.density);
    let speed = (density > 0.0).then(|| (modulus / density).sqrt());
    let is_light = density > 0.0 && density < DENSITIES.0;
    if is_light || density > DENSITIES.1 {
        return Some(UnlikelyInput::Density {
            material: name,
            density,
            likely: likely_density(modulus, density),
        });
    }
    let slow = match material.law {
        ElasticLaw::Isotropic { .. } => SLOW,
        _ => SLOW_ANISOTROPIC,
    };
    let is_soft = speed.map_or(modulus < SOFT, |speed| speed < slow);
    let is_fast = speed.is_some_and(|speed| speed > FAST);
    if !(is_soft || is_fast || modulus > STIFF) {
        return None;
    }
    if is_fast
        && modulus <= STIFF
        && let Some(likely) = likely_density(modulus, density)
    {
        return Some(UnlikelyInput::Density {
            material: name,
            density,
            likely: Some(likely),
        });
    }
    Some(UnlikelyInput::Modulus {
        material: name,
        modulus,
        speed,
        likely: likely_modulus(modulus, density),
    })
}

/// The largest modulus of a law; `None` for a material without stiffness \[Pa\].
fn largest_modulus(law: &ElasticLaw) -> Option<f64> {
    match law {
        ElasticLaw::Isotropic { young, .. } => Some(*young),
        ElasticLaw::Orthotropic(constants) => {
            Some(constants.e1.max(constants.e2).max(constants.e3))
        }
        ElasticLaw::Full(stiffness) => Some(stiffness.diagonal().rows(0, 3).max()),
        ElasticLaw::Absent => None,
    }
}

/// Whether a usual material has this modulus and density (zero if unknown).
fn is_usual(modulus: f64, density: f64) -> bool {
    let (low, high) = USUAL_MODULI;
    let (slow, fast) = USUAL_SPEEDS;
    let is_heavy = density > DENSITIES.1 || (density > 0.0 && density < DENSITIES.0);
    let speed = (modulus / density).sqrt();
    (low..=high).contains(&modulus)
        && !is_heavy
        && (density == 0.0 || (slow..=fast).contains(&speed))
}

/// The likely mistake in a modulus: a unit that was forgotten, or used twice.
fn likely_modulus(modulus: f64, density: f64) -> Option<String> {
    let forgotten = MODULI
        .iter()
        .find(|(_, factor)| is_usual(modulus * factor, density));
    if let Some((unit, _)) = forgotten {
        let written = tick_label(modulus, 0.0);
        let larger = Some(1e3 * modulus).filter(|larger| is_usual(*larger, density));
        return Some(match larger.filter(|_| *unit == "psi") {
            Some(larger) => format!(
                "{} Pa, a number in GPa that is read as MPa, or {written} psi would be usual",
                tick_label(larger, 0.0)
            ),
            None => format!("{written} {unit} would be usual"),
        });
    }
    let twice = MODULI
        .iter()
        .find(|(_, factor)| is_usual(modulus / factor, density));
    twice.map(|(unit, factor)| {
        let modulus = tick_label(modulus / factor, 0.0);
        format!("{modulus} Pa would be usual; is a number in Pa read as {unit}?")
    })
}

/// The likely mistake in a density: a unit that was forgotten, or used twice.
fn likely_density(modulus: f64, density: f64) -> Option<String> {
    let forgotten = HEAVY
        .iter()
        .find(|(_, factor)| is_usual(modulus, density * factor));
    if let Some((unit, _)) = forgotten {
        return Some(format!(
            "{} {unit} would be usual",
            tick_label(density, 0.0)
        ));
    }
    let twice = HEAVY
        .iter()
        .find(|(_, factor)| is_usual(modulus, density / factor));
    twice.map(|(unit, factor)| {
        let density = tick_label(density / factor, 0.0);
        format!("{density} kg/m^3 would be usual; is a number in kg/m^3 read as {unit}?")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn isotropic(young: f64, density: f64) -> Material {
        Material {
            name: "a".to_owned(),
            law: ElasticLaw::Isotropic {
                young,
                poisson: 0.3,
            },
            density,
            expansion: None,
            electric: None,
        }
    }

    fn remark(young: f64, density: f64) -> String {
        let found = unlikely(&isotropic(young, density));
        found.map_or_else(String::new, |found| found.to_string())
    }

    /// Real materials: modulus [Pa] and density [kg/m^3] of handbooks, from soft to stiff.
    #[test]
    fn real_materials_are_not_remarked() {
        for (name, young, density) in [
            ("silicone", 0.1e6, 1100.0),
            ("soft foam", 50e3, 30.0),
            ("rubber", 2e6, 1100.0),
            ("foam", 30e6, 60.0),
            ("particle foam", 5e6, 20.0),
            ("low-density polyethylene", 0.2e9, 920.0),
            ("nylon", 3e9, 1150.0),
            ("balsa", 3e9, 150.0),
            ("lead", 16e9, 11_340.0),
            ("glass laminate", 40e9, 1950.0),
            ("aluminum", 70e9, 2700.0),
            ("titanium", 114e9, 4430.0),
            ("steel", 210e9, 7850.0),
            ("beryllium", 300e9, 1850.0),
            ("carbon fiber", 900e9, 2200.0),
            ("tungsten", 411e9, 19_300.0),
            ("osmium", 560e9, 22_590.0),
            ("diamond", 1.1e12, 3515.0),
            ("without mass", 1e9, 0.0),
        ] {
            assert_eq!(remark(young, density), "", "{name}");
        }
    }

    #[test]
    fn forgotten_units_are_remarked_with_the_likely_one() {
        let reported = |young, density, words: &str| {
            let shown = remark(young, density);
            assert!(shown.contains(words), "{young} {density}: {shown}");
        };
        reported(73.1, 2780.0, "modulus 7.310e1 Pa at its density");
        reported(73.1, 2780.0, "73.1 GPa would be usual");
        reported(73_100.0, 2780.0, " MPa would be usual");
        reported(210_000.0, 7850.0, "MPa would be usual");
        reported(10.6e6 / 1e6, 2780.0, "GPa would be usual");
        reported(73.1, 0.0, "GPa would be usual");
        reported(
            73.1e18,
            2780.0,
            " Pa would be usual; is a number in Pa read as GPa?",
        );
        reported(
            73.1e9,
            2.78,
            "density 2.780e0 kg/m^3: 2.78 g/cm^3 would be usual",
        );
        reported(411e9, 19.3, "19.3 g/cm^3 would be usual");
        reported(30e6, 0.06, "g/cm^3 would be usual");
        reported(3e9, 1.15, "g/cm^3 would be usual");
        reported(
            73.1e9,
            2.78e6,
            " kg/m^3 would be usual; is a number in kg/m^3 read as g/cm^3?",
        );
        reported(210e9, 7.85e-9, "t/mm^3 would be usual");
        // both in the units of mm, N, t: the modulus is 1e-6 times the modulus of steel
        reported(2.1e5, 7.85e-9, "density");
    }

    /// A ply of carbon in MPa: 142e3 Pa, 1600 kg/m^3, 9.4 m/s.
    #[test]
    fn plies_are_not_as_soft_as_rubber() {
        let mut ply = isotropic(1.0, 1600.0);
        let constants = crate::section::samples::CARBON;
        ply.law = ElasticLaw::Orthotropic(constants);
        assert_eq!(unlikely(&ply), None);
        let soft = crate::material::EngineeringConstants {
            e1: 1e-6 * constants.e1,
            e2: 1e-6 * constants.e2,
            e3: 1e-6 * constants.e3,
            ..constants
        };
        ply.law = ElasticLaw::Orthotropic(soft);
        let shown = unlikely(&ply).unwrap().to_string();
        assert!(shown.contains("MPa would be usual"), "{shown}");
    }

    /// A ply of glass in MPa, read from a number in GPa: 147 m/s.
    #[test]
    fn plies_a_thousand_times_too_soft_are_remarked() {
        let mut ply = isotropic(1.0, 1950.0);
        let [e1, e2] = [42e6, 11e6];
        ply.law = ElasticLaw::Orthotropic(crate::material::EngineeringConstants {
            e1,
            e2,
            e3: e2,
            ..crate::section::samples::CARBON
        });
        let shown = unlikely(&ply).unwrap().to_string();
        let expected =
            "4.2e10 Pa, a number in GPa that is read as MPa, or 4.2e7 psi would be usual";
        assert!(shown.contains(expected), "{shown}");
    }

    fn size_remark(lengths: [f64; 2], has_walls: bool, unit: (&str, f64)) -> String {
        let found = of_size(lengths, has_walls, unit);
        found.map_or_else(String::new, |found| found.to_string())
    }

    /// Sections that exist [m]: a strip, a model, root of a blade, towers of steel (monopiles of 12 m,
    /// 0.15 m thick) and of concrete, solid piers of concrete, a shaft, a root of laminate, a film of
    /// 5 um on 12 mm, a beam of 2 um in meters and in micrometers.
    #[test]
    fn sections_that_exist_are_not_remarked() {
        for (size, cell, has_walls, unit) in [
            (0.02, 1e-3, true, ("m", 1.0)),
            (5.0, 0.5, false, ("m", 1.0)),
            (8.0, 1.0, false, ("m", 1.0)),
            (1.5, 0.4, true, ("m", 1.0)),
            (5.0, 0.12, true, ("m", 1.0)),
            (12.0, 0.15, true, ("m", 1.0)),
            (14.0, 0.15, false, ("m", 1.0)),
            (4.5, 1e-3, true, ("mm", 1e-3)),
            (12e-3, 5e-6, true, ("mm", 1e-3)),
            (0.063, 1e-3, true, ("in", 0.0254)),
            (2e-6, 1e-7, true, ("m", 1.0)),
            (2e-6, 1e-7, true, ("um", 1e-6)),
        ] {
            let found = size_remark([size, cell], has_walls, unit);
            assert_eq!(found, "", "{size} {cell}");
        }
    }

    /// Aluminum, steel and carbon plies; concrete and wood (largest modulus 16 GPa).
    #[test]
    fn metals_and_plies_form_walls() {
        for (young, expected) in [(70e9, true), (210e9, true), (30e9, false), (3e9, false)] {
            assert_eq!(forms_walls(&isotropic(young, 2500.0)), expected, "{young}");
        }
        let mut ply = isotropic(1.0, 1600.0);
        let carbon = crate::section::samples::CARBON;
        ply.law = ElasticLaw::Orthotropic(carbon);
        assert!(forms_walls(&ply));
        let e1 = 16e9;
        ply.law = ElasticLaw::Orthotropic(crate::material::EngineeringConstants { e1, ..carbon });
        assert!(!forms_walls(&ply));
    }

    #[test]
    fn meshes_in_another_unit_are_remarked() {
        let ends = |unit: &str| {
            format!(
                ": check that the coordinates of the mesh are in {unit}, as \"length\" of the units \
                 states"
            )
        };
        for (size, cell, has_walls, unit, words) in [
            (100.0, 0.1, false, ("m", 1.0), "the section is 100 m large"),
            // 12 mm by 3 mm with plies of 0.25 mm, and 4 mm by 1 mm
            (
                12.0,
                0.25,
                false,
                ("m", 1.0),
                "the section is 12 m large, and its thinnest cell is 0.25 m thick",
            ),
            (
                4.0,
                0.25,
                true,
                ("m", 1.0),
                "the section is 4 m large, and its thinnest cell is 0.25 m thick",
            ),
            // 0.3 m by 0.03 m
            (
                0.3e-3,
                1e-5,
                true,
                ("mm", 1e-3),
                "the section is 0.3 mm large",
            ),
            // a chord of 4 m with plies of 1 mm
            (
                4e-3,
                1e-6,
                true,
                ("mm", 1e-3),
                "the section is 4 mm large, and its thinnest cell is 0.001 mm thick",
            ),
        ] {
            let expected = words.to_owned() + &ends(unit.0);
            assert_eq!(size_remark([size, cell], has_walls, unit), expected);
        }
    }
}
