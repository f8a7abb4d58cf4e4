//! From a section to its properties: the method, one call a stage.
//!
//! # References
//! - Giavotto, Borri, Mantegazza, Ghiringhelli, Carmaschi, Maffioli, Mussi,
//!   *Anisotropic beam theory and applications*, Computers & Structures 16
//!   (1983) 403-413.

use crate::assembly::{
    ASSEMBLED_IDENTITIES, Domain, Pattern, SectionMatrices, check_assembled_identities, largest,
    mass_per_length,
};
use crate::failure::Failure;
use crate::properties::{Centers, PrincipalAxes, invert_symmetric, scaled_difference};
use crate::section::Section;
use crate::solution::{Checks, SectionSolution};
use crate::solve::{
    CentralSolution, CentralSystems, Decoupled, FactorError, Load, ParticularSolution, Pins, Pivot,
    SystemError, in_elimination_order,
};
use nalgebra::{DMatrix, Matrix6, Vector3};
use shared_geom::wrench;

mod decay;
mod distributed;

/// Largest relative error of a rigid-body identity. Round-off gives 1e-15; a
/// node in the wrong place of a cell gives 1e-3 or more.
const IDENTITY_LIMIT: f64 = 1e-10;

/// Largest relative error of the solution's own checks. Sound sections reach
/// 1e-13; sections of extreme slenderness or contrast of moduli lose digits.
const CHECK_LIMIT: f64 = 1e-9;

/// Smallest pivot relative to its diagonal entry: below it no digit of the
/// pivot is significant.
const PIVOT_LIMIT: f64 = 1e-14;

/// Finds stiffness, mass, centers and central solutions of `section`.
///
/// # Errors
/// [`Failure`] when the section has no unique, accurate solution: it falls
/// apart, has inverted or folded cells, or is too badly conditioned.
pub fn analyze(section: &Section) -> Result<SectionSolution, Failure> {
    let (solved, systems) = Solved::new(section)?;
    // the factors are the largest part of the memory
    drop(systems);
    solved.solution()
}

/// An analysis that keeps its factored systems: further questions to the same section
/// cost a solution each, not a factorization.
#[derive(Debug)]
pub struct Analysis<'a> {
    solved: Solved<'a>,
    systems: CentralSystems,
    solution: SectionSolution,
}

impl<'a> Analysis<'a> {
    /// Analyzes `section`.
    ///
    /// # Errors
    /// As [`analyze`].
    pub fn new(section: &'a Section) -> Result<Self, Failure> {
        let (solved, systems) = Solved::new(section)?;
        let solution = solved.solution()?;
        Ok(Self {
            solved,
            systems,
            solution,
        })
    }

    /// Properties and central solutions of the section.
    pub fn solution(&self) -> &SectionSolution {
        &self.solution
    }

    /// The section.
    pub fn section(&self) -> &'a Section {
        self.solved.section
    }

    /// The section as it was solved: units, nodes and cells.
    pub fn domain(&self) -> &Domain {
        &self.solved.domain
    }

    /// The central solutions in the units of the domain.
    pub fn central(&self) -> &Decoupled {
        &self.solved.decoupled
    }

    /// The states of up to six cases of given forces, in the units of the domain.
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`].
    pub fn particular(&self, load: &Load<'_>) -> Result<ParticularSolution, Failure> {
        let Solved {
            domain, decoupled, ..
        } = &self.solved;
        let unknowns = domain.unknowns();
        ParticularSolution::solve(domain, self.systems.steady(), &decoupled.face, load)
            .ok_or(Failure::OutOfMemory { unknowns })
    }
}

/// The central solutions of a section in the units of its domain, checked.
#[derive(Debug)]
struct Solved<'a> {
    section: &'a Section,
    domain: Domain,
    decoupled: Decoupled,
    compliance: Matrix6<f64>,
    checks: Checks,
}

impl<'a> Solved<'a> {
    /// The method up to the decoupled central solutions, and the systems that found
    /// them.
    fn new(section: &'a Section) -> Result<(Self, CentralSystems), Failure> {
        let domain = Domain::new(section)?;
        let pattern = Pattern::new(&domain);
        check_connected(section, &domain, &pattern)?;
        let unknowns = domain.unknowns();
        let (domain, pattern) =
            in_elimination_order(domain, &pattern).ok_or(Failure::OutOfMemory { unknowns })?;

        let matrices = SectionMatrices::assemble(&domain, &pattern)?;
        let identities = check_assembled_identities(&domain, &matrices);
        require_identities(&identities)?;

        let pins = Pins::choose(&domain.nodes)?;
        let systems = CentralSystems::new(&domain, &pattern, matrices, pins)
            .map_err(|error| system_failure(section, &domain, error))?;
        let weakest = systems.smallest_pivot();
        require_pivot(section, &domain, weakest)?;
        let central = CentralSolution::solve(&domain, &systems)
            .ok_or_else(|| factor_failure(section, &domain, FactorError::OutOfMemory))?;

        let (compliance, resultant) = (central.work, central.resultant);
        let correction = central.correction;
        let decoupled = Decoupled::new(&domain, central);
        let checks = Checks {
            identities,
            correction,
            condition: systems.condition(),
            smallest_pivot: weakest.ratio,
            ..check_solution(&decoupled, &compliance, &resultant)
        };
        require_checks(section, &domain, &checks, weakest)?;
        let solved = Self {
            section,
            domain,
            decoupled,
            compliance,
            checks,
        };
        Ok((solved, systems))
    }

    /// The result in SI, about the origin of the mesh.
    fn solution(&self) -> Result<SectionSolution, Failure> {
        let Self {
            section, domain, ..
        } = self;
        let solution = in_si(
            section,
            domain,
            &self.decoupled,
            &self.compliance,
            self.checks,
        )?;
        require_sound(&solution)?;
        Ok(solution)
    }
}

fn system_failure(section: &Section, domain: &Domain, error: SystemError) -> Failure {
    match error {
        SystemError::Matrices(failure) => failure,
        SystemError::Factor(error) => factor_failure(section, domain, error),
    }
}

/// The checks that compare the solution with itself; the others are left at zero.
fn check_solution(
    decoupled: &Decoupled,
    compliance: &Matrix6<f64>,
    resultant: &Matrix6<f64>,
) -> Checks {
    let y = &decoupled.y;
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

/// One part, joined node by node.
fn check_connected(section: &Section, domain: &Domain, pattern: &Pattern) -> Result<(), Failure> {
    let parts = pattern.parts();
    match parts[..] {
        [first, second, ..] => Err(Failure::Disconnected {
            parts: parts.len(),
            node: tag_of(section, domain, first),
            other: tag_of(section, domain, second),
        }),
        _ => Ok(()),
    }
}

fn require_identities(errors: &[f64; 2]) -> Result<(), Failure> {
    for (&error, identity) in errors.iter().zip(ASSEMBLED_IDENTITIES) {
        if error.is_nan() || error > IDENTITY_LIMIT {
            return Err(Failure::Identity {
                identity,
                error,
                limit: IDENTITY_LIMIT,
            });
        }
    }
    Ok(())
}

fn factor_failure(section: &Section, domain: &Domain, error: FactorError) -> Failure {
    match error {
        FactorError::NotPositive(pivot) => loose(section, domain, pivot),
        FactorError::NoStiffness => Failure::ComplianceNotPositive,
        FactorError::OutOfMemory => Failure::OutOfMemory {
            unknowns: domain.unknowns(),
        },
    }
}

fn require_pivot(section: &Section, domain: &Domain, pivot: Pivot) -> Result<(), Failure> {
    if pivot.ratio > PIVOT_LIMIT {
        Ok(())
    } else {
        Err(loose(section, domain, pivot))
    }
}

fn loose(section: &Section, domain: &Domain, pivot: Pivot) -> Failure {
    let [y, z] = place_of(section, domain, pivot.node);
    Failure::Loose {
        node: tag_of(section, domain, pivot.node),
        y,
        z,
        ratio: pivot.ratio,
        limit: PIVOT_LIMIT,
    }
}

fn require_checks(
    section: &Section,
    domain: &Domain,
    checks: &Checks,
    weakest: Pivot,
) -> Result<(), Failure> {
    let measured = [
        ("the internal force of the solutions", checks.equilibrium),
        ("the symmetry of the compliance", checks.asymmetry),
        ("the energy of the solutions", checks.decoupling),
    ];
    for (check, error) in measured {
        if error.is_nan() || error > CHECK_LIMIT {
            let [y, z] = place_of(section, domain, weakest.node);
            return Err(Failure::Inaccurate {
                check,
                error,
                limit: CHECK_LIMIT,
                node: tag_of(section, domain, weakest.node),
                y,
                z,
            });
        }
    }
    Ok(())
}

/// Finite matrices, a stiffness that stores energy: in SI and about the origin of the
/// mesh, which may be out of range though all is well in the units of the domain.
fn require_sound(solution: &SectionSolution) -> Result<(), Failure> {
    let SectionSolution {
        stiffness, mass, ..
    } = solution;
    let finite = |matrix: &Matrix6<f64>| matrix.iter().all(|value| value.is_finite());
    if !finite(stiffness) || !finite(&solution.compliance) {
        return Err(Failure::NoScale { what: "stiffness" });
    }
    if !finite(mass) {
        return Err(Failure::NoScale { what: "mass" });
    }
    let down = stiffness.diagonal().map(|value| 1.0 / value.sqrt());
    let scaled = stiffness.component_mul(&(down * down.transpose()));
    match scaled.cholesky() {
        Some(_) => Ok(()),
        None => Err(Failure::ComplianceNotPositive),
    }
}

/// From the units of the domain to SI, from its origin to that of the mesh.
///
/// ```text
/// psi_i = p_i psi^_i, theta_j = f_j theta^_j:  C = diag(p) C^ diag(1/f),  K = diag(f) K^ diag(1/p)
/// at O = c - t:  K_O = U K_c U',  C_O = V' C_c V,  X_O = X_c V    with U = U(-t), V = U(t)
/// ```
fn in_si(
    section: &Section,
    domain: &Domain,
    decoupled: &Decoupled,
    compliance: &Matrix6<f64>,
    checks: Checks,
) -> Result<SectionSolution, Failure> {
    let scaling = &domain.scaling;
    let stiffness = invert_symmetric(compliance).ok_or(Failure::ComplianceNotPositive)?;
    let (p, f) = (scaling.strain(), scaling.force());
    let per_force = f.map(|unit| 1.0 / unit);
    let compliance_unit = p * per_force.transpose();
    let stiffness_unit = f * p.map(|unit| 1.0 / unit).transpose();

    let [y, z] = scaling.origin;
    let t = Vector3::new(0.0, y, z);
    let v = wrench::shift_matrix(&t);
    let about_origin = |c: &Matrix6<f64>| v.transpose() * c.component_mul(&compliance_unit) * v;

    let mass = mass_per_length(domain);
    let centroidal_mass = wrench::shift(&mass, &t);
    let centers = Centers::new(
        &compliance.component_mul(&compliance_unit),
        &centroidal_mass,
    );
    Ok(SectionSolution {
        stiffness: symmetric(&wrench::shift(
            &stiffness.component_mul(&stiffness_unit),
            &-t,
        )),
        compliance: symmetric(&about_origin(compliance)),
        principal_bending: PrincipalAxes::of_bending(&compliance.component_mul(&compliance_unit)),
        principal_inertia: PrincipalAxes::of_mass(&centroidal_mass, centers.mass),
        centers: centers.placed(scaling.origin),
        mass: symmetric(&mass),
        warping: warping_of_mesh(
            section,
            domain,
            &decoupled.x,
            &(Matrix6::from_diagonal(&per_force) * v),
        ),
        strain: about_origin(&decoupled.y),
        checks,
        unknowns: domain.unknowns(),
    })
}

/// Warping in meters at all nodes of the mesh per unit of the forces that `forces`
/// takes to those of the domain; zero at nodes without a cell.
fn warping_of_mesh(
    section: &Section,
    domain: &Domain,
    x: &DMatrix<f64>,
    forces: &Matrix6<f64>,
) -> DMatrix<f64> {
    let mut warping = DMatrix::zeros(3 * section.mesh.nodes.len(), 6);
    for (node, &mesh_node) in domain.mesh_nodes.iter().enumerate() {
        let at_node = domain.scaling.length * x.fixed_view::<3, 6>(3 * node, 0) * forces;
        warping
            .fixed_view_mut::<3, 6>(3 * mesh_node as usize, 0)
            .copy_from(&at_node);
    }
    warping
}

fn symmetric(matrix: &Matrix6<f64>) -> Matrix6<f64> {
    0.5 * (matrix + matrix.transpose())
}

fn tag_of(section: &Section, domain: &Domain, node: usize) -> u64 {
    let mesh_node = domain.mesh_nodes[node] as usize;
    // a mesh made without tags counts its nodes from one
    section
        .mesh
        .node_tags
        .get(mesh_node)
        .copied()
        .unwrap_or(mesh_node as u64 + 1)
}

fn place_of(section: &Section, domain: &Domain, node: usize) -> [f64; 2] {
    section.mesh.nodes[domain.mesh_nodes[node] as usize]
}

#[cfg(test)]
mod tests;
