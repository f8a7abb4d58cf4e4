//! Strengths as written: `[material.NAME.strength]` and `[material.NAME.strain_limit]`.

use shared_geom::document::schema::ValueKind::{Quantity, Table as OneTable};
use shared_geom::document::schema::{KeySchema, TableSchema};
use shared_geom::document::{Key, Nested, Table, schema};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::InputProblem;
use crate::material::{
    DEFAULT_INTERACTION, DirectionalLimits, ElasticLaw, Fatigue, MaterialLimits, Slopes,
    StrainLimit, Strength, StrengthProblem, UniformLimits,
};

keys! {
    /// Limits for the failure indices.
    pub(super) UNIFORM_STRENGTH: Nested = "strength", [OneTable(&UNIFORM_STRENGTHS)], optional, "";
    /// Limits for the failure indices.
    pub(super) UNIFORM_STRAIN: Nested = "strain_limit", [OneTable(&UNIFORM_STRAINS)], optional, "";
    /// Limits for the failure indices.
    pub(super) PLY_STRENGTH: Nested = "strength", [OneTable(&PLY_STRENGTHS)], optional, "";
    /// Limits for the failure indices.
    pub(super) PLY_STRAIN: Nested = "strain_limit", [OneTable(&PLY_STRAINS)], optional, "";
    /// Slope m of the S-N line N = (S / S_a)^m, for damage by `strength`; of a ply along the fiber.
    M: Option<f64> = "m", [Quantity(Dimension::NUMBER)], optional, "10";
    /// Slope of the S-N lines across the fiber and in shear.
    M_MATRIX: Option<f64> = "m_matrix", [Quantity(Dimension::NUMBER)], or "m", "8";
    /// Yield stress.
    YIELD: f64 = "yield", [Quantity(Dimension::STRESS)], required, "\"350 MPa\"";
    /// In tension.
    TENSION: f64 = "tension", [Quantity(Dimension::STRESS)], required, "\"400 MPa\"";
    /// In compression.
    COMPRESSION: f64 = "compression", [Quantity(Dimension::STRESS)], required, "\"380 MPa\"";
    /// In shear.
    SHEAR: f64 = "shear", [Quantity(Dimension::STRESS)], required, "\"220 MPa\"";
}

const UNIFORM_STRENGTHS: TableSchema = TableSchema {
    title: "[material.NAME.strength], isotropic",
    meaning: "Largest stresses of an isotropic material, all positive.",
    keys: &[M.schema],
    families: &[
        schema::Family {
            name: "yield",
            meaning: "For the index of von Mises.",
            keys: &[YIELD.schema],
        },
        schema::Family {
            name: "principal",
            meaning: "For the principal stresses.",
            keys: &[TENSION.schema, COMPRESSION.schema, SHEAR.schema],
        },
    ],
};

keys! {
    /// Largest principal strains of an isotropic material, all positive.
    UNIFORM_STRAINS = "[material.NAME.strain_limit], isotropic";
    /// In tension.
    TENSION_STRAIN: f64 = "tension", [Quantity(Dimension::NUMBER)], required, "0.012";
    /// In compression.
    COMPRESSION_STRAIN: f64 = "compression", [Quantity(Dimension::NUMBER)], required, "0.012";
    /// In shear, an engineering strain.
    SHEAR_STRAIN: f64 = "shear", [Quantity(Dimension::NUMBER)], required, "0.018";
    with M.schema;
}

keys! {
    /// Largest stresses in the axes of the material, all positive, also in compression.
    PLY_STRENGTHS = "[material.NAME.strength]";
    /// Tension along 1.
    XT: f64 = "xt", [Quantity(Dimension::STRESS)], required, "\"1100 MPa\"";
    /// Compression along 1.
    XC: f64 = "xc", [Quantity(Dimension::STRESS)], required, "\"700 MPa\"";
    /// Tension along 2.
    YT: f64 = "yt", [Quantity(Dimension::STRESS)], required, "\"40 MPa\"";
    /// Compression along 2.
    YC: f64 = "yc", [Quantity(Dimension::STRESS)], required, "\"140 MPa\"";
    /// Shear in the plane of 1 and 2.
    S12: f64 = "s12", [Quantity(Dimension::STRESS)], required, "\"70 MPa\"";
    /// Tension along 3.
    ZT: Option<f64> = "zt", [Quantity(Dimension::STRESS)], or "yt", "\"40 MPa\"";
    /// Compression along 3.
    ZC: Option<f64> = "zc", [Quantity(Dimension::STRESS)], or "yc", "\"140 MPa\"";
    /// Shear in the plane of 1 and 3.
    S13: Option<f64> = "s13", [Quantity(Dimension::STRESS)], or "s12", "\"70 MPa\"";
    /// Shear in the plane of 2 and 3.
    S23: Option<f64> = "s23", [Quantity(Dimension::STRESS)], or "half of yc", "\"70 MPa\"";
    /// Interaction of 1 and 2 in Tsai-Wu, F12 / sqrt(F11 F22).
    F12: f64 = "f12", [Quantity(Dimension::NUMBER)], or "-0.5" = DEFAULT_INTERACTION, "-0.4";
    /// Interaction of 1 and 3 in Tsai-Wu.
    F13: Option<f64> = "f13", [Quantity(Dimension::NUMBER)], or "f12", "-0.4";
    /// Interaction of 2 and 3 in Tsai-Wu.
    F23: Option<f64> = "f23", [Quantity(Dimension::NUMBER)], or "f12", "-0.4";
    with M.schema, M_MATRIX.schema;
}

keys! {
    /// Largest strains in the axes of the material, all positive, also in compression; shear
    /// strains are engineering strains.
    PLY_STRAINS = "[material.NAME.strain_limit]";
    /// Tension along 1.
    XT_STRAIN: f64 = "xt", [Quantity(Dimension::NUMBER)], required, "0.018";
    /// Compression along 1.
    XC_STRAIN: f64 = "xc", [Quantity(Dimension::NUMBER)], required, "0.012";
    /// Tension along 2.
    YT_STRAIN: f64 = "yt", [Quantity(Dimension::NUMBER)], required, "0.005";
    /// Compression along 2.
    YC_STRAIN: f64 = "yc", [Quantity(Dimension::NUMBER)], required, "0.02";
    /// Shear in the plane of 1 and 2.
    S12_STRAIN: f64 = "s12", [Quantity(Dimension::NUMBER)], required, "0.02";
    /// Tension along 3.
    ZT_STRAIN: Option<f64> = "zt", [Quantity(Dimension::NUMBER)], or "yt", "0.005";
    /// Compression along 3.
    ZC_STRAIN: Option<f64> = "zc", [Quantity(Dimension::NUMBER)], or "yc", "0.02";
    /// Shear in the plane of 1 and 3.
    S13_STRAIN: Option<f64> = "s13", [Quantity(Dimension::NUMBER)], or "s12", "0.02";
    /// Shear in the plane of 2 and 3.
    S23_STRAIN: Option<f64> = "s23", [Quantity(Dimension::NUMBER)], or "yc", "0.02";
    with M.schema, M_MATRIX.schema;
}

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

/// The declarations of the limits in a table.
struct Measure {
    /// The table in the material's table.
    table: &'static Key<Nested>,
    /// The limits `xt`, `xc`, `yt`, `yc` and `s12`.
    ply: [&'static Key<f64>; 5],
    /// The limits that follow from others: `zt`, `zc`, `s13` and `s23`.
    rest: [&'static Key<Option<f64>>; 4],
    /// Default of the shear limit in the plane 23, as a fraction of `yc`.
    shear_23: f64,
    /// The limits in tension, compression and shear.
    uniform: [&'static Key<f64>; 3],
    families: &'static [(Family, &'static [KeySchema])],
}

/// The shear stress in the plane of 2 and 3 under transverse compression at its limit is
/// half of this limit.
const STRENGTH: Measure = Measure {
    table: &PLY_STRENGTH,
    ply: [&XT, &XC, &YT, &YC, &S12],
    rest: [&ZT, &ZC, &S13, &S23],
    shear_23: 0.5,
    uniform: [&TENSION, &COMPRESSION, &SHEAR],
    families: &[
        (Family::Ply, PLY_STRENGTHS.keys),
        (Family::Uniform, UNIFORM_STRENGTHS.families[1].keys),
        (Family::Yield, UNIFORM_STRENGTHS.families[0].keys),
    ],
};

/// The engineering shear strain in this state is the compression plus the Poisson
/// contribution, which is neglected.
const STRAIN_LIMIT: Measure = Measure {
    table: &PLY_STRAIN,
    ply: [&XT_STRAIN, &XC_STRAIN, &YT_STRAIN, &YC_STRAIN, &S12_STRAIN],
    rest: [&ZT_STRAIN, &ZC_STRAIN, &S13_STRAIN, &S23_STRAIN],
    shear_23: 1.0,
    uniform: [&TENSION_STRAIN, &COMPRESSION_STRAIN, &SHEAR_STRAIN],
    families: &[
        (Family::Ply, PLY_STRAINS.keys),
        (Family::Uniform, UNIFORM_STRAINS.keys),
    ],
};

/// The limits in the table of a material whose law is `law`; problems are noted, and the
/// limits omitted.
pub(super) fn read(name: &str, table: &Table<'_>, law: Option<&ElasticLaw>) -> MaterialLimits {
    let read = |measure: Measure| {
        let has_table = table.has(measure.table);
        let table = has_table.then(|| table.table(measure.table)).flatten()?;
        let limits = Limits {
            material: name,
            table: &table,
            measure,
        };
        let read = limits.family(law).and_then(|family| {
            let slopes = limits.slopes(family);
            Some((limits.read(family)?, slopes))
        });
        table.finish();
        read
    };
    let (strength, strain) = (read(STRENGTH), read(STRAIN_LIMIT));
    let slopes = |read: &Option<(Strength, Option<Slopes>)>| read.as_ref().and_then(|read| read.1);
    MaterialLimits {
        fatigue: Fatigue {
            stress: slopes(&strength),
            strain: slopes(&strain),
        },
        strength: strength.map(|read| read.0),
        strain: strain.and_then(|(strength, _)| match strength {
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
            // the slope is a key of all of them
            let own = keys.iter().filter(|key| key.name != M.name());
            let given: Vec<_> = own.filter(|key| self.table.has(key)).collect();
            if let Some(key) = given.first() {
                found.push((*family, key.name));
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
        let problem = problem(self.material.to_owned(), self.measure.table.name());
        self.table.note(key, &problem);
    }

    /// The values, if all required ones are present and admissible.
    fn read(&self, family: Family) -> Option<Strength> {
        let strength = match family {
            Family::Ply => Strength::Ply {
                limits: self.directional()?,
                interaction: self.interaction()?,
            },
            Family::Uniform => {
                let found = self.measure.uniform.map(|key| self.table.get(key));
                let [tension, compression, shear] = found;
                Strength::Uniform(UniformLimits {
                    tension: tension?,
                    compression: compression?,
                    shear: shear?,
                })
            }
            Family::Yield => Strength::Yield(self.table.get(&YIELD)?),
        };
        self.is_sound(strength.check()).then_some(strength)
    }

    /// The slopes of the S-N lines, if they are given and admissible; wrong ones are noted.
    fn slopes(&self, family: Family) -> Option<Slopes> {
        let fiber = self.table.get(&M);
        let matrix = match family {
            Family::Ply => self.table.get(&M_MATRIX).flatten(),
            Family::Uniform | Family::Yield => None,
        };
        let fiber = fiber?;
        let slopes = Slopes {
            fiber,
            matrix: matrix.or(fiber)?,
        };
        self.is_sound(slopes.check()).then_some(slopes)
    }

    /// Whether there are no problems, which are noted.
    fn is_sound(&self, problems: Vec<StrengthProblem>) -> bool {
        let mut is_sound = true;
        for problem in problems {
            is_sound = false;
            let key = match &problem {
                StrengthProblem::NotPositive { key, .. }
                | StrengthProblem::Extreme { key, .. }
                | StrengthProblem::SlopeOutOfRange { key, .. }
                | StrengthProblem::InteractionOutOfRange { key, .. } => key,
                StrengthProblem::OpenSurface { .. } => F12.name(),
            };
            // A default that is another value has been reported with that value.
            let is_written = self.table.has(key);
            if is_written || matches!(problem, StrengthProblem::OpenSurface { .. }) {
                let material = self.material.to_owned();
                self.table
                    .note(key, &InputProblem::Strength { material, problem });
            }
        }
        is_sound
    }

    fn directional(&self) -> Option<DirectionalLimits> {
        // All keys are read before the first missing one ends the reading.
        let [xt, xc, yt, yc, s12] = self.measure.ply.map(|key| self.table.get(key));
        // absent or wrong, which has been noted
        let [zt, zc, s13, s23] = self.measure.rest.map(|key| self.table.get(key).flatten());
        Some(DirectionalLimits {
            tension: [xt?, yt?, zt.unwrap_or(yt?)],
            compression: [xc?, yc?, zc.unwrap_or(yc?)],
            shear: [
                s23.unwrap_or(self.measure.shear_23 * yc?),
                s13.unwrap_or(s12?),
                s12?,
            ],
        })
    }

    /// Interactions 23, 13, 12; the default for strains, which do not have their keys.
    fn interaction(&self) -> Option<[f64; 3]> {
        if self.measure.table.name() != STRENGTH.table.name() {
            return Some([DEFAULT_INTERACTION; 3]);
        }
        let [f23, f13] = [&F23, &F13].map(|key| self.table.get(key).flatten());
        // a wrong one has been noted
        let f12 = self.table.get(&F12).unwrap_or(DEFAULT_INTERACTION);
        Some([f23.unwrap_or(f12), f13.unwrap_or(f12), f12])
    }
}
