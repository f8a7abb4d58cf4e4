//! The central solutions of a section, solved and checked.

use crate::assembly::{
    ASSEMBLED_IDENTITIES, Model, Pattern, SectionMatrices, check_assembled_identities, largest,
};
use crate::failure::Failure;
use crate::properties::scaled_difference;
use crate::solution::Checks;
use crate::solve::{
    CentralSolution, CentralSystems, Decoupled, FactorError, Pins, Pivot, SystemError,
};
use nalgebra::Matrix6;

/// Smallest pivot relative to its diagonal entry: a smaller pivot has no significant digit.
const PIVOT_LIMIT: f64 = 1e-14;

/// Errors above which the analysis fails.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Largest relative error of a rigid-body identity.
    pub identity: f64,
    /// Largest relative error of the solution's own checks.
    pub check: f64,
}

/// Limits of sections of cells. Round-off of the identities is 1e-15; a node at a wrong
/// index of a cell gives 1e-3 or more. The checks of valid sections are about 1e-13.
///
/// Sections of extreme slenderness or contrast of moduli lose digits: a strain is a difference
/// of displacements, `e = B x`, and its round-off follows from the terms that cancel. Strips of
/// stretched cells up to 1e4 times wider than thick have up to 1e-8, far less than the error of
/// their cells; the report then states the number of digits. Strips whose factor has lost all
/// digits have 1e-1 or more.
pub(super) const OF_CELLS: Limits = Limits {
    identity: 1e-10,
    check: 1e-7,
};

/// A node as named in messages.
#[derive(Debug, Clone, Copy)]
pub(super) struct Named {
    pub tag: u64,
    /// Position (y, z) [m].
    pub position: [f64; 2],
}

/// The names of the nodes of a model.
pub(super) type Naming<'a> = &'a dyn Fn(usize) -> Named;

/// The decoupled central solutions in the units of the solver, with their checks.
#[derive(Debug)]
pub(super) struct Central {
    pub decoupled: Decoupled,
    pub compliance: Matrix6<f64>,
    pub checks: Checks,
}

/// Solves `model`, whose steady matrices are `matrices`, and checks the solution; returns
/// the factored systems, too.
pub(super) fn solve_central(
    model: &impl Model,
    pattern: &Pattern,
    matrices: SectionMatrices<f64>,
    naming: Naming<'_>,
    limits: Limits,
) -> Result<(Central, CentralSystems), Failure> {
    let identities = check_assembled_identities(model, &matrices);
    require_identities(&identities, &ASSEMBLED_IDENTITIES, limits.identity)?;

    let unknowns = model.unknowns();
    let pins = Pins::of_model(model)?;
    let systems = CentralSystems::new(model, pattern, matrices, pins)
        .map_err(|error| system_failure(error, naming, unknowns))?;
    let weakest = systems.smallest_pivot();
    require_pivot(naming, weakest)?;
    let central =
        CentralSolution::solve(model, &systems).ok_or(Failure::OutOfMemory { unknowns })?;

    let (compliance, resultant) = (central.work, central.resultant);
    let correction = central.correction;
    let decoupled = Decoupled::new(model, central);
    let checks = Checks {
        identities,
        correction,
        condition: systems.condition(),
        smallest_pivot: weakest.ratio,
        ..check_solution(&decoupled, &compliance, &resultant)
    };
    require_checks(&checks, limits.check, naming(weakest.node))?;
    let central = Central {
        decoupled,
        compliance,
        checks,
    };
    Ok((central, systems))
}

/// The checks that compare the solution with itself; the others are left at zero.
fn check_solution(
    decoupled: &Decoupled,
    compliance: &Matrix6<f64>,
    resultant: &Matrix6<f64>,
) -> Checks {
    let y = &decoupled.of_work;
    let up = compliance.diagonal().map(f64::sqrt);
    let down = up.map(|value| 1.0 / value);
    let off_unit = |forces| scaled_difference(forces, &Matrix6::identity(), &up, &down);
    Checks {
        equilibrium: largest(off_unit(&decoupled.internal_force), off_unit(resultant)),
        asymmetry: scaled_difference(y, &y.transpose(), &down, &down),
        decoupling: scaled_difference(y, compliance, &down, &down),
        ..Checks::default()
    }
}

/// Requires one part, connected by nodes.
pub(super) fn require_connected(parts: &[usize], naming: Naming<'_>) -> Result<(), Failure> {
    match *parts {
        [first, second, ..] => Err(Failure::Disconnected {
            parts: parts.len(),
            node: naming(first).tag,
            other: naming(second).tag,
        }),
        _ => Ok(()),
    }
}

/// Requires that all identities hold within `limit`.
fn require_identities(
    errors: &[f64],
    identities: &[&'static str],
    limit: f64,
) -> Result<(), Failure> {
    for (&error, &identity) in errors.iter().zip(identities) {
        if error.is_nan() || error > limit {
            return Err(Failure::Identity {
                identity,
                error,
                limit,
            });
        }
    }
    Ok(())
}

fn system_failure(error: SystemError, naming: Naming<'_>, unknowns: usize) -> Failure {
    match error {
        SystemError::Matrices(failure) => failure,
        SystemError::Factor(FactorError::NotPositive(pivot)) => loose(naming, pivot),
        SystemError::Factor(FactorError::NoStiffness) => Failure::ComplianceNotPositive,
        SystemError::Factor(FactorError::OutOfMemory) => Failure::OutOfMemory { unknowns },
    }
}

fn require_pivot(naming: Naming<'_>, pivot: Pivot) -> Result<(), Failure> {
    if pivot.ratio > PIVOT_LIMIT {
        Ok(())
    } else {
        Err(loose(naming, pivot))
    }
}

fn loose(naming: Naming<'_>, pivot: Pivot) -> Failure {
    let Named {
        tag,
        position: [y, z],
    } = naming(pivot.node);
    Failure::Loose {
        node: tag,
        y,
        z,
        ratio: pivot.ratio,
        limit: PIVOT_LIMIT,
    }
}

fn require_checks(checks: &Checks, limit: f64, weakest: Named) -> Result<(), Failure> {
    let measured = [
        ("the internal force of the solutions", checks.equilibrium),
        ("the symmetry of the compliance", checks.asymmetry),
        ("the energy of the solutions", checks.decoupling),
    ];
    for check in measured {
        require_small(check, limit, weakest)?;
    }
    Ok(())
}

/// Requires the error of a check to be within `limit`; `weakest` is the node of the
/// smallest pivot.
pub(super) fn require_small(
    (check, error): (&'static str, f64),
    limit: f64,
    weakest: Named,
) -> Result<(), Failure> {
    if error <= limit {
        return Ok(());
    }
    let [y, z] = weakest.position;
    Err(Failure::Inaccurate {
        check,
        error,
        limit,
        node: weakest.tag,
        y,
        z,
    })
}
