//! The analysis of a section that is given by its matrices.

use super::central::{Limits, Named, require_connected, solve_central};
use super::si::{Frame, in_si};
use crate::assembly::{OUTSIDE_IDENTITIES, OutsideDomain, Pattern, Scaling, largest};
use crate::element::Line;
use crate::failure::Failure;
use crate::section::{Blocks, OutsideSection};
use crate::solution::SectionSolution;
use crate::solve::elimination_order;
use sprs::{CsMat, TriMat};

/// Files of other programs have seven digits or more: an identity that they break by
/// more than 1e-6 of its terms is broken, and the solution of sound ones passes its own
/// checks to ten times that.
const LIMITS: Limits = Limits {
    identity: 1e-6,
    check: 1e-5,
};

/// Finds stiffness, centers and central solutions of a section given by its matrices.
///
/// # Errors
/// [`Failure`] when the matrices do not belong together, or the section has no unique,
/// accurate solution.
pub fn analyze_matrices(section: &OutsideSection) -> Result<SectionSolution, Failure> {
    let count = section.nodes.len();
    let pattern = pattern(count, &section.blocks);
    let unknowns = 3 * count;
    let order = elimination_order(&pattern).ok_or(Failure::OutOfMemory { unknowns })?;
    let named = |node: usize| Named {
        tag: section.tags[order[node] as usize],
        place: section.nodes[order[node] as usize],
    };
    let domain = in_order(section, &order)?;
    let pattern = self::pattern(count, &renumbered(&section.blocks, &order));
    require_belonging(&domain, section, &order)?;
    require_connected(&pattern, &named)?;
    let matrices = domain.system(&pattern, 0.0)?;
    let (central, systems) = solve_central(&domain, &pattern, matrices, &named, LIMITS)?;
    drop(systems);
    let frame = Frame {
        scaling: domain.scaling(),
        nodes: &order,
        count,
        mass: &section.mass,
    };
    in_si(&frame, &central)
}

/// All identities of the matrices hold; every one that does not is told.
fn require_belonging(
    domain: &OutsideDomain,
    section: &OutsideSection,
    order: &[u32],
) -> Result<(), Failure> {
    let between = OUTSIDE_IDENTITIES.into_iter().zip(domain.identities());
    let given = domain.compared(&section.reduced, order);
    let is_broken = |error: f64| error.is_nan() || error > LIMITS.identity;
    let broken: Vec<_> = between
        .chain(given)
        .filter(|(_, error)| is_broken(*error))
        .collect();
    match broken.is_empty() {
        true => Ok(()),
        false => Err(Failure::Matrices {
            broken,
            limit: LIMITS.identity,
        }),
    }
}

/// Which nodes meet in any of the matrices.
fn pattern(count: usize, blocks: &Blocks) -> Pattern {
    let Blocks { m, c, e } = blocks;
    let entries = [m, c, e].into_iter().flat_map(|matrix| matrix.iter());
    let pairs = entries.map(|(_, (i, j))| ((i / 3) as u32, (j / 3) as u32));
    Pattern::of_pairs(count, pairs)
}

/// The section in the units of the solver, its nodes in the order of elimination.
fn in_order(section: &OutsideSection, order: &[u32]) -> Result<OutsideDomain, Failure> {
    let nodes = &section.nodes;
    let mean = |axis: usize| nodes.iter().map(|p| p[axis]).sum::<f64>() / nodes.len() as f64;
    let origin = [mean(0), mean(1)];
    let from_origin = |p: &[f64; 2]| [p[0] - origin[0], p[1] - origin[1]];
    let distances = nodes.iter().map(from_origin).map(|[y, z]| y.hypot(z));
    let length = distances.fold(0.0, largest);
    let diagonal = section.blocks.e.diag();
    let modulus = diagonal.iter().map(|(_, v)| v.abs()).fold(0.0, largest);
    for (value, what) in [(length, "size"), (modulus, "stiffness")] {
        if !(value.is_normal() && value > 0.0) {
            return Err(Failure::NoScale { what });
        }
    }
    let scaling = Scaling {
        origin,
        length,
        modulus,
    };
    let places = order.iter().map(|&node| {
        let [y, z] = from_origin(&nodes[node as usize]);
        [y / length, z / length]
    });
    let line = Line::through(&section.initial_curvature, origin, length);
    let blocks = renumbered(&section.blocks, order);
    Ok(OutsideDomain::new(places.collect(), line, scaling, &blocks))
}

/// The matrices with their nodes in another order.
fn renumbered(blocks: &Blocks, order: &[u32]) -> Blocks {
    let mut place = vec![0; order.len()];
    for (new, &old) in order.iter().enumerate() {
        place[old as usize] = new;
    }
    let of = |matrix: &CsMat<f64>| {
        let mut moved = TriMat::new((matrix.rows(), matrix.cols()));
        for (&value, (i, j)) in matrix {
            moved.add_triplet(3 * place[i / 3] + i % 3, 3 * place[j / 3] + j % 3, value);
        }
        moved.to_csr()
    };
    Blocks {
        m: of(&blocks.m),
        c: of(&blocks.c),
        e: of(&blocks.e),
    }
}
