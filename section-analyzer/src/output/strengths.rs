//! Report of the strengths of materials.

use crate::material::{
    DirectionalLimits, Material, MaterialLimits, Slopes, StrainLimit, Strength, UniformLimits,
};

/// Strengths and strain limits of each material that has any, with values derived from
/// others; empty if no material has any.
pub(super) fn strengths(materials: &[Material], limits: &[MaterialLimits]) -> String {
    let mut text = String::new();
    for (material, limits) in materials.iter().zip(limits) {
        let name = &material.name;
        if let Some(strength) = &limits.strength {
            let slopes = of_slopes(limits.fatigue.stress);
            text += &format!("  {name}: {}{slopes}\n", of_stress(strength));
        }
        if let Some(limit) = &limits.strain {
            let slopes = of_slopes(limits.fatigue.strain);
            text += &format!("  {name}: {}{slopes}\n", of_strain(limit));
        }
    }
    if text.is_empty() {
        text
    } else {
        format!("Strengths\n{text}")
    }
}

fn of_stress(strength: &Strength) -> String {
    let unit = (1e-6, " MPa");
    match strength {
        Strength::Yield(stress) => format!("yield {}", listed(&[*stress], unit)),
        Strength::Uniform(limits) => uniform("stress", limits, unit),
        Strength::Ply {
            limits,
            interaction,
        } => format!(
            "{}\n      f23, f13, f12 {}",
            directional("stress", limits, unit),
            listed(interaction, (1.0, ""))
        ),
    }
}

fn of_strain(limit: &StrainLimit) -> String {
    match limit {
        StrainLimit::Ply(limits) => directional("strain", limits, (1.0, "")),
        StrainLimit::Uniform(limits) => uniform("strain", limits, (1.0, "")),
    }
}

fn of_slopes(slopes: Option<Slopes>) -> String {
    slopes.map_or_else(String::new, |slopes| {
        let key = if slopes.fiber.is_some() {
            "m"
        } else {
            "m_matrix"
        };
        let mut values: Vec<f64> = slopes.fiber.into_iter().chain([slopes.matrix]).collect();
        values.dedup();
        format!("; {key} {}", listed(&values, (1.0, "")))
    })
}

fn uniform(what: &str, limits: &UniformLimits, unit: (f64, &str)) -> String {
    let values = [limits.tension, limits.compression, limits.shear];
    format!(
        "{what} in tension, compression, shear {}",
        listed(&values, unit)
    )
}

fn directional(what: &str, limits: &DirectionalLimits, unit: (f64, &str)) -> String {
    format!(
        "{what} xt, yt, zt {}; xc, yc, zc {}; s23, s13, s12 {}",
        listed(&limits.tension, unit),
        listed(&limits.compression, unit),
        listed(&limits.shear, unit)
    )
}

/// Values times a factor, in at most six digits, with the resulting unit.
fn listed(values: &[f64], (factor, unit): (f64, &str)) -> String {
    let shown: Vec<_> = values
        .iter()
        .map(|value| shared_geom::figure::tick_label(factor * value, 0.0))
        .collect();
    format!("{}{unit}", shown.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{ElasticLaw, Fatigue};

    #[test]
    fn every_limit_is_shown() {
        let material = |name: &str| Material {
            name: name.into(),
            law: ElasticLaw::Isotropic {
                young: 1.0,
                poisson: 0.0,
            },
            density: 1.0,
            expansion: None,
            electric: None,
        };
        let ply = DirectionalLimits {
            tension: [1500e6, 50e6, 40e6],
            compression: [1200e6, 200e6, 160e6],
            shear: [100e6, 60e6, 70e6],
        };
        let slopes = |fiber, matrix| Some(Slopes { fiber, matrix });
        let limits = [
            MaterialLimits {
                strength: Some(Strength::Ply {
                    limits: ply,
                    interaction: [-0.5, -0.5, -0.25],
                }),
                strain: None,
                fatigue: Fatigue {
                    stress: slopes(Some(10.0), 8.0),
                    strain: None,
                },
            },
            MaterialLimits {
                strength: Some(Strength::Yield(250e6)),
                strain: Some(StrainLimit::Uniform(UniformLimits {
                    tension: 0.01,
                    compression: 0.02,
                    shear: 0.015,
                })),
                fatigue: Fatigue {
                    stress: None,
                    strain: slopes(Some(4.5), 4.5),
                },
            },
        ];
        let shown = strengths(&[material("ply"), material("steel")], &limits);
        let expected = "\
Strengths
  ply: stress xt, yt, zt 1500, 50, 40 MPa; xc, yc, zc 1200, 200, 160 MPa; s23, s13, s12 100, 60, 70 MPa
      f23, f13, f12 -0.5, -0.5, -0.25; m 10, 8
  steel: yield 250 MPa
  steel: strain in tension, compression, shear 0.01, 0.02, 0.015; m 4.5
";
        assert_eq!(shown, expected);
        assert_eq!(
            strengths(&[material("ply")], &[MaterialLimits::default()]),
            ""
        );
    }
}
