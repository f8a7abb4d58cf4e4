//! The analysis of a section that is given by its matrices.

use thiserror::Error;

use super::central::{Central, Limits, Named, Naming, require_connected, solve_central};
use super::decay::end_effects;
use super::si::{Frame, in_si};
use crate::assembly::{EXTERNAL_IDENTITIES, ExternalDomain, Model, Pattern, Scaling, largest};
use crate::element::Line;
use crate::failure::Failure;
use crate::section::{Blocks, ExternalSection, Slice, Through};
use crate::solution::{EndEffects, SectionSolution};
use crate::solve::{CentralSystems, FactorError, elimination_order, require_positive};
use shared_geom::error::Explain;
use sprs::{CsMat, TriMat};

/// Matrices that break an identity by more than 1e-6 of its terms are wrong or rounded to
/// less than seven digits. The number of correct digits depends on the section: see
/// [`DIGITS`]. The checks of the solution compare it with itself, to ten times that limit.
const LIMITS: Limits = Limits {
    identity: 1e-6,
    check: 1e-5,
};

/// Estimates of the error by rounding of the files above which a warning is given, and
/// above which the analysis fails. The estimate is the error of the identities times the
/// condition number. Strips of 40 by 1 from slices 5, 1 and 0.2 thick, in files of 6 to 12
/// digits, have errors of up to four times the estimate, most of them less than the
/// estimate.
const DIGITS: (f64, f64) = (1e-3, 1e-1);

/// Negative part of M, relative to its diagonal, up to which M is accepted as positive
/// semidefinite: rounding to seven digits. A slice with one point through it that is read
/// as linear gives -0.1 and less.
const SEMIDEFINITE: f64 = 1e-6;

/// The names of M and E in messages.
const M: &str = "M, the stiffness against the rate of the warping,";
const E: &str = "E, the stiffness against the warping,";

/// Warnings about given matrices.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ExternalWarning {
    /// The matrices have few digits.
    #[error(
        "the digits of the matrices leave a relative error of about {error:.0e} (identities of rigid motions {identity:.1e}, times the condition number {condition:.1e})"
    )]
    Digits {
        /// Estimate of the relative error of the result \[-\].
        error: f64,
        /// Error of the identities \[-\].
        identity: f64,
        /// Condition number \[-\].
        condition: f64,
    },
    /// A slice that looks like one of elements that are linear through it.
    #[error(
        "the slice is read as through = \"middle\", but looks like one of elements that are linear through its thickness of {thickness:e} m"
    )]
    Through {
        /// Thickness of the slice \[m\].
        thickness: f64,
    },
    /// No mass is given.
    #[error("no mass is given: the mass in the property file is zero")]
    NoMass,
}

impl Explain for ExternalWarning {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::Digits { .. } => "write the matrices with 15 digits or more",
            Self::Through { .. } => "8-node bricks with 2 x 2 x 2 points are \"linear\"",
            Self::NoMass => "give \"mass\": the beam program needs it for modes and motion in time",
        };
        Some(help.to_owned())
    }
}

/// Finds stiffness, centers and central solutions of a section given by its matrices.
///
/// # Errors
/// [`Failure`] when the matrices are inconsistent, or the section has no unique, accurate
/// solution.
pub fn analyze_matrices(section: &ExternalSection) -> Result<SectionSolution, Failure> {
    Ok(ExternalAnalysis::new(section)?.solution)
}

/// The analysis of a section that is given by its matrices, for further results.
#[derive(Debug)]
pub struct ExternalAnalysis {
    domain: ExternalDomain,
    central: Central,
    systems: CentralSystems,
    solution: SectionSolution,
    warnings: Vec<ExternalWarning>,
}

impl ExternalAnalysis {
    /// Analyzes `section`.
    ///
    /// # Errors
    /// As [`analyze_matrices`].
    pub fn new(section: &ExternalSection) -> Result<Self, Failure> {
        let count = section.nodes.len();
        let pattern = pattern(count, &section.blocks);
        let unknowns = 3 * count;
        let order = elimination_order(&pattern).ok_or(Failure::OutOfMemory { unknowns })?;
        let named = |node: usize| Named {
            tag: section.tags[order[node] as usize],
            position: section.nodes[order[node] as usize],
        };
        let blocks = renumbered(&section.blocks, &order);
        let pattern = self::pattern(count, &blocks);
        let domain = in_order(section, &order, &blocks)?;
        require_belonging(&domain, section, &order)?;
        require_connected(&pattern.parts(), &named)?;
        require_positive_face(&domain, &pattern, &named)?;
        let mut warnings = Vec::new();
        warnings.extend(looks_linear(section, &domain, &pattern)?);
        let matrices = domain.system(&pattern, 0.0)?;
        let in_words = |failure| of_given_matrices(failure, section.slice.is_some());
        let (central, systems) =
            solve_central(&domain, &pattern, matrices, &named, LIMITS).map_err(in_words)?;
        warnings.extend(digits(&central)?);
        if section.mass.iter().all(|&entry| entry == 0.0) {
            warnings.push(ExternalWarning::NoMass);
        }
        let frame = Frame {
            scaling: domain.scaling(),
            nodes: &order,
            count,
            mass: &section.mass,
        };
        let solution = in_si(&frame, &central).map_err(in_words)?;
        Ok(Self {
            domain,
            central,
            systems,
            solution,
            warnings,
        })
    }

    /// Properties and central solutions of the section.
    pub fn solution(&self) -> &SectionSolution {
        &self.solution
    }

    /// Warnings about the matrices.
    pub fn warnings(&self) -> &[ExternalWarning] {
        &self.warnings
    }

    /// The `wanted` slowest decaying solutions, as [`super::Analysis::end_effects`].
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`].
    pub fn end_effects(&self, wanted: usize) -> Result<EndEffects, Failure> {
        let solved = (&self.systems, &self.central.decoupled.face);
        let length = self.domain.scaling().length;
        end_effects(&self.domain, solved, length, wanted)
    }
}

/// Requires all identities of the matrices; the error lists every identity that is
/// violated.
fn require_belonging(
    domain: &ExternalDomain,
    section: &ExternalSection,
    order: &[u32],
) -> Result<(), Failure> {
    let between = EXTERNAL_IDENTITIES.into_iter().zip(domain.identities());
    let given = domain.compared(&section.reduced, order);
    let is_broken = |error: f64| error.is_nan() || error > LIMITS.identity;
    let broken: Vec<_> = between
        .chain(given)
        .filter(|(_, error)| is_broken(*error))
        .collect();
    if broken.is_empty() {
        Ok(())
    } else {
        Err(Failure::Matrices {
            broken,
            of_slice: section.slice.is_some(),
            limit: LIMITS.identity,
        })
    }
}

/// Requires that M gives no motion a negative energy.
fn require_positive_face(
    domain: &ExternalDomain,
    pattern: &Pattern,
    naming: Naming<'_>,
) -> Result<(), Failure> {
    let m = domain.face_matrix(pattern, SEMIDEFINITE, 0.0)?;
    require_positive(&m, pattern).map_err(|error| match error {
        FactorError::NotPositive(pivot) => {
            let Named {
                tag,
                position: [y, z],
            } = naming(pivot.node);
            Failure::NotPositive {
                matrix: M,
                node: tag,
                y,
                z,
            }
        }
        _ => Failure::OutOfMemory {
            unknowns: domain.unknowns(),
        },
    })
}

/// Whether a slice read as `middle` looks like a linear one. The M of a linear slice is
/// `M0 + a E`, a = h^2/12: then `M - a E` is positive, and `M - 2 a E` is not if the slice
/// is as thick as its cells. Thinner slices cannot be distinguished, but the difference
/// hardly matters.
fn looks_linear(
    section: &ExternalSection,
    domain: &ExternalDomain,
    pattern: &Pattern,
) -> Result<Option<ExternalWarning>, Failure> {
    let Some(Slice { thickness, through }) = section.slice else {
        return Ok(None);
    };
    if through != Through::Middle {
        return Ok(None);
    }
    let part = (thickness / domain.scaling().length).powi(2) / 12.0;
    let is_positive = |part: f64| -> Result<bool, Failure> {
        let m = domain.face_matrix(pattern, SEMIDEFINITE, part)?;
        Ok(require_positive(&m, pattern).is_ok())
    };
    let looks = is_positive(part)? && !is_positive(2.0 * part)?;
    Ok(looks.then_some(ExternalWarning::Through { thickness }))
}

/// Warning or error for the loss of digits in the matrices.
fn digits(central: &Central) -> Result<Option<ExternalWarning>, Failure> {
    let checks = &central.checks;
    let identity = checks.identities.into_iter().fold(0.0, largest);
    let condition = checks.condition;
    let error = identity * condition;
    if error.is_nan() || error > DIGITS.1 {
        return Err(Failure::Digits {
            error,
            limit: DIGITS.1,
            identity,
            condition,
        });
    }
    Ok((error > DIGITS.0).then_some(ExternalWarning::Digits {
        error,
        identity,
        condition,
    }))
}

/// A failure expressed in terms of matrices instead of cells.
fn of_given_matrices(failure: Failure, of_slice: bool) -> Failure {
    match failure {
        Failure::Identity {
            identity,
            error,
            limit,
        } => Failure::Matrices {
            broken: vec![(identity, error)],
            of_slice,
            limit,
        },
        Failure::Loose { node, y, z, .. } => Failure::NotPositive {
            matrix: E,
            node,
            y,
            z,
        },
        Failure::NoScale { .. } | Failure::ComplianceNotPositive => Failure::NoStiffness,
        other => other,
    }
}

/// Pairs of nodes that have an entry in any of the matrices.
fn pattern(count: usize, blocks: &Blocks) -> Pattern {
    let Blocks { m, c, e } = blocks;
    let entries = [m, c, e].into_iter().flat_map(|matrix| matrix.iter());
    let pairs = entries.map(|(_, (i, j))| ((i / 3) as u32, (j / 3) as u32));
    Pattern::of_pairs(count, pairs)
}

/// The section in the units of the solver, with its nodes in the order of elimination, the
/// order of `blocks`.
fn in_order(
    section: &ExternalSection,
    order: &[u32],
    blocks: &Blocks,
) -> Result<ExternalDomain, Failure> {
    let nodes = &section.nodes;
    let mean = |axis: usize| nodes.iter().map(|p| p[axis]).sum::<f64>() / nodes.len() as f64;
    let origin = [mean(0), mean(1)];
    let from_origin = |p: &[f64; 2]| [p[0] - origin[0], p[1] - origin[1]];
    let distances = nodes.iter().map(from_origin).map(|[y, z]| y.hypot(z));
    let length = distances.fold(0.0, largest);
    let size = |matrix: &CsMat<f64>| {
        let diagonal = matrix.diag();
        diagonal.iter().map(|(_, v)| v.abs()).fold(0.0, largest)
    };
    let modulus = size(&blocks.e);
    let sizes = [
        (length, "the extent of the nodes"),
        (modulus, E),
        (size(&blocks.m), M),
    ];
    for (value, what) in sizes {
        if !(value.is_normal() && value > 0.0) {
            return Err(Failure::NoSize { what });
        }
    }
    let scaling = Scaling {
        potential: 1.0,
        origin,
        length,
        modulus,
    };
    let positions = order.iter().map(|&node| {
        let [y, z] = from_origin(&nodes[node as usize]);
        [y / length, z / length]
    });
    let line = Line::through(&section.initial_curvature, origin, length);
    Ok(ExternalDomain::new(
        positions.collect(),
        line,
        scaling,
        blocks,
    ))
}

/// The matrices with their nodes in another order.
fn renumbered(blocks: &Blocks, order: &[u32]) -> Blocks {
    let mut position = vec![0; order.len()];
    for (new, &old) in order.iter().enumerate() {
        position[old as usize] = new;
    }
    let of = |matrix: &CsMat<f64>| {
        let mut moved = TriMat::new((matrix.rows(), matrix.cols()));
        for (&value, (i, j)) in matrix {
            moved.add_triplet(
                3 * position[i / 3] + i % 3,
                3 * position[j / 3] + j % 3,
                value,
            );
        }
        moved.to_csr()
    };
    Blocks {
        m: of(&blocks.m),
        c: of(&blocks.c),
        e: of(&blocks.e),
    }
}
