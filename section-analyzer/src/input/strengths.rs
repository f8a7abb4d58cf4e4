//! Strengths as written: `[material.NAME.strength]` and `[material.NAME.strain_limit]`.

use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::problem::InputProblem;
use crate::material::{
    DEFAULT_INTERACTION, DirectionalLimits, ElasticLaw, MaterialLimits, StrainLimit, Strength,
    StrengthProblem, UniformLimits,
};

const PLY: [&str; 9] = ["xt", "xc", "yt", "yc", "zt", "zc", "s12", "s13", "s23"];
const INTERACTION: [&str; 3] = ["f23", "f13", "f12"];
const UNIFORM: [&str; 3] = ["tension", "compression", "shear"];
const YIELD: [&str; 1] = ["yield"];

/// The keys of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Family {
    Ply,
    Uniform,
    Yield,
}

impl Family {
    fn fits(self, law: &ElasticLaw) -> bool {
        matches!(law, ElasticLaw::Isotropic { .. }) == (self != Self::Ply)
    }
}

/// Quantity of the limits in a table.
#[derive(Debug, Clone, Copy)]
struct Measure {
    /// Key of the table in the material's table.
    key: &'static str,
    dimension: Dimension,
    /// Default of the shear limit in the plane 23, as a fraction of `yc`.
    shear_23: f64,
    families: &'static [(Family, &'static [&'static str])],
}

/// The shear stress in the plane of 2 and 3 under transverse compression at its limit is
/// half of this limit.
const STRENGTH: Measure = Measure {
    key: "strength",
    dimension: Dimension::STRESS,
    shear_23: 0.5,
    families: &[
        (Family::Ply, &PLY),
        (Family::Ply, &INTERACTION),
        (Family::Uniform, &UNIFORM),
        (Family::Yield, &YIELD),
    ],
};

/// The engineering shear strain in this state is the compression plus the Poisson
/// contribution, which is neglected.
const STRAIN_LIMIT: Measure = Measure {
    key: "strain_limit",
    dimension: Dimension::NUMBER,
    shear_23: 1.0,
    families: &[(Family::Ply, &PLY), (Family::Uniform, &UNIFORM)],
};

/// The limits in the table of a material whose law is `law`; problems are noted, and the
/// limits omitted.
pub(super) fn read(name: &str, table: &Table<'_>, law: Option<&ElasticLaw>) -> MaterialLimits {
    let read = |measure: Measure| {
        let table = table
            .has(measure.key)
            .then(|| table.table(measure.key))
            .flatten()?;
        let limits = Limits {
            material: name,
            table: &table,
            measure,
        };
        let read = limits.family(law).and_then(|family| limits.read(family));
        table.finish();
        read
    };
    MaterialLimits {
        strength: read(STRENGTH),
        strain: read(STRAIN_LIMIT).and_then(|strength| match strength {
            Strength::Ply { limits, .. } => Some(StrainLimit::Ply(limits)),
            Strength::Uniform(limits) => Some(StrainLimit::Uniform(limits)),
            // not among the families of a strain limit
            Strength::Yield(_) => None,
        }),
    }
}

/// One of the two tables.
struct Limits<'a> {
    material: &'a str,
    table: &'a Table<'a>,
    measure: Measure,
}

impl Limits<'_> {
    /// The kind of limits that the keys determine, if it suits the law.
    fn family(&self, law: Option<&ElasticLaw>) -> Option<Family> {
        // All keys are read, so that none of them is reported as unknown.
        let mut found: Vec<(Family, &'static str)> = Vec::new();
        for (family, keys) in self.measure.families {
            let present: Vec<_> = keys.iter().filter(|key| self.table.has(key)).collect();
            if let Some(key) = present.first() {
                found.push((*family, key));
            }
        }
        let Some(&(family, first)) = found.first() else {
            self.note("", |material, table| InputProblem::NoStrength {
                material,
                table,
            });
            return None;
        };
        if let Some(&(_, second)) = found.iter().find(|(other, _)| *other != family) {
            self.note(second, |material, table| InputProblem::MixedStrength {
                material,
                table,
                first,
                second,
            });
            return None;
        }
        if law.is_some_and(|law| !family.fits(law)) {
            let is_isotropic = family == Family::Ply;
            self.note(first, |material, table| InputProblem::StrengthOfOtherLaw {
                material,
                table,
                key: first,
                is_isotropic,
            });
            return None;
        }
        Some(family)
    }

    fn note(&self, key: &str, problem: impl FnOnce(String, &'static str) -> InputProblem) {
        let problem = problem(self.material.to_owned(), self.measure.key);
        self.table.note(key, &problem);
    }

    /// The values, if all required ones are present and admissible.
    fn read(&self, family: Family) -> Option<Strength> {
        let require = |key| self.table.require_quantity(key, self.measure.dimension);
        let strength = match family {
            Family::Ply => Strength::Ply {
                limits: self.directional()?,
                interaction: self.interaction()?,
            },
            Family::Uniform => {
                let [tension, compression, shear] = UNIFORM.map(require);
                Strength::Uniform(UniformLimits {
                    tension: tension?,
                    compression: compression?,
                    shear: shear?,
                })
            }
            Family::Yield => Strength::Yield(require("yield")?),
        };
        let mut is_sound = true;
        for problem in strength.check() {
            is_sound = false;
            let key = match &problem {
                StrengthProblem::NotPositive { key, .. }
                | StrengthProblem::Extreme { key, .. }
                | StrengthProblem::InteractionOutOfRange { key, .. } => key,
                StrengthProblem::OpenSurface { .. } => "f12",
            };
            // A default that is another value has been reported with that value.
            let is_written = self.table.has(key);
            if is_written || matches!(problem, StrengthProblem::OpenSurface { .. }) {
                let material = self.material.to_owned();
                self.table
                    .note(key, &InputProblem::Strength { material, problem });
            }
        }
        is_sound.then_some(strength)
    }

    fn directional(&self) -> Option<DirectionalLimits> {
        let dimension = self.measure.dimension;
        // All keys are read before the first missing one ends the reading.
        let [xt, xc, yt, yc, s12] =
            ["xt", "xc", "yt", "yc", "s12"].map(|key| self.table.require_quantity(key, dimension));
        // absent or wrong, which has been noted
        let optional = |key, default| self.table.quantity(key, dimension).unwrap_or(default);
        let zt = optional("zt", yt.unwrap_or(1.0));
        let zc = optional("zc", yc.unwrap_or(1.0));
        let s13 = optional("s13", s12.unwrap_or(1.0));
        let s23 = optional("s23", self.measure.shear_23 * yc.unwrap_or(1.0));
        Some(DirectionalLimits {
            tension: [xt?, yt?, zt],
            compression: [xc?, yc?, zc],
            shear: [s23, s13, s12?],
        })
    }

    /// Interactions 23, 13, 12; the default for strains.
    fn interaction(&self) -> Option<[f64; 3]> {
        if self.measure.key != STRENGTH.key {
            return Some([DEFAULT_INTERACTION; 3]);
        }
        let number = |key| self.table.quantity(key, Dimension::NUMBER);
        let f12 = number("f12").unwrap_or(DEFAULT_INTERACTION);
        Some(["f23", "f13", "f12"].map(|key| number(key).unwrap_or(f12)))
    }
}
