//! From a section to its properties: the method, one call per stage.
//!
//! # References
//! - Giavotto, Borri, Mantegazza, Ghiringhelli, Carmaschi, Maffioli, Mussi,
//!   *Anisotropic beam theory and applications*, Computers & Structures 16
//!   (1983) 403-413.

mod central;
mod decay;
mod discretization;
mod distributed;
mod external;
mod imposed;
mod piezo;
mod si;

pub use discretization::discretization_error;
pub use external::{ExternalAnalysis, ExternalWarning, analyze_matrices};

use crate::assembly::{Domain, Pattern, SectionMatrices, mass_per_length, structural_parts};
use crate::failure::Failure;
use crate::section::Section;
use crate::sensitivity::{self, Derivative, Parameter, SensitivityProblem};
use crate::solution::SectionSolution;
use crate::solve::{CentralSystems, Decoupled, Load, ParticularSolution, in_elimination_order};
use central::{Central, Named, OF_CELLS, require_connected, require_small, solve_central};
use nalgebra::{DMatrix, DVector};
use piezo::Voltages;
use si::{Frame, in_si};

/// Finds stiffness, mass, centers and central solutions of `section`.
///
/// # Errors
/// [`Failure`] when the section has no unique, accurate solution: it is not connected, has
/// inverted or folded cells, or is too badly conditioned.
pub fn analyze(section: &Section) -> Result<SectionSolution, Failure> {
    let (solved, systems) = Solved::new(section)?;
    // the factors are the largest part of the memory
    drop(systems);
    solved.solution()
}

/// An analysis that keeps its factored systems: a further result of the same section needs
/// a solution, not a factorization.
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

    /// The section as solved: units, nodes and cells.
    pub fn domain(&self) -> &Domain {
        &self.solved.domain
    }

    /// The central solutions in the units of the domain.
    pub fn central(&self) -> &Decoupled {
        &self.solved.central.decoupled
    }

    /// The states of up to six cases of given forces, in the units of the domain.
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`].
    pub fn particular(&self, load: &Load<'_>) -> Result<ParticularSolution, Failure> {
        let domain = self.domain();
        let unknowns = domain.unknowns();
        ParticularSolution::solve(domain, self.systems.steady(), &self.central().face, load)
            .ok_or(Failure::OutOfMemory { unknowns })
    }

    /// Derivatives of stiffness, compliance, mass and centers with respect to `parameters`,
    /// all at once: the number of solutions does not depend on the number of parameters.
    ///
    /// # Errors
    /// [`SensitivityProblem`] for the first parameter that the section does not have, or if
    /// memory is insufficient.
    pub fn sensitivities(
        &self,
        parameters: &[Parameter],
    ) -> Result<Vec<Derivative>, SensitivityProblem> {
        sensitivity::all_at_once(self.parts(), parameters)
    }

    /// As [`Analysis::sensitivities`], by a solution for each parameter: an independent
    /// computation of the same numbers.
    ///
    /// # Errors
    /// As [`Analysis::sensitivities`].
    pub fn sensitivities_direct(
        &self,
        parameters: &[Parameter],
    ) -> Result<Vec<Derivative>, SensitivityProblem> {
        sensitivity::direct(self.parts(), parameters)
    }

    /// Requires that a generalized strain and its second computation, by `check`, agree
    /// within the limit.
    fn require_work(&self, check: &'static str, error: f64) -> Result<(), Failure> {
        let node = self.systems.smallest_pivot().node;
        let weakest = named(self.section(), self.domain(), node);
        require_small((check, error), OF_CELLS.check, weakest)
    }

    /// Input of the derivatives.
    pub(crate) fn parts(&self) -> sensitivity::Solved<'_> {
        sensitivity::Solved {
            section: self.solved.section,
            domain: &self.solved.domain,
            systems: &self.systems,
            central: &self.solved.central.decoupled,
            compliance: &self.solved.central.compliance,
        }
    }
}

/// The central solutions of a section, solved and checked.
#[derive(Debug)]
struct Solved<'a> {
    section: &'a Section,
    domain: Domain,
    central: Central,
    /// Effects of voltages; `None` without electrodes.
    voltages: Option<Voltages>,
    /// Node of the smallest pivot.
    weakest: usize,
}

impl<'a> Solved<'a> {
    /// Computes the decoupled central solutions and the solutions of voltages; returns
    /// their factored systems, too.
    fn new(section: &'a Section) -> Result<(Self, CentralSystems), Failure> {
        let domain = Domain::new(section)?;
        let pattern = Pattern::new(&domain);
        let parts = if domain.electric.is_all_structural() {
            pattern.parts()
        } else {
            structural_parts(&domain)
        };
        require_connected(&parts, &|node| named(section, &domain, node))?;
        let unknowns = domain.unknowns();
        let (domain, pattern) =
            in_elimination_order(domain, &pattern).ok_or(Failure::OutOfMemory { unknowns })?;

        let matrices = SectionMatrices::assemble(&domain, &pattern)?;
        let naming = |node| named(section, &domain, node);
        let (central, systems) = solve_central(&domain, &pattern, matrices, &naming, OF_CELLS)?;
        let solved = Self {
            section,
            voltages: Voltages::solve(&domain, &systems, &central)?,
            weakest: systems.smallest_pivot().node,
            domain,
            central,
        };
        Ok((solved, systems))
    }

    /// A column of a field of the domain at the nodes of the mesh.
    fn on_mesh(&self, field: &DMatrix<f64>, column: usize) -> DVector<f64> {
        let mut on_mesh = DVector::zeros(3 * self.section.mesh.nodes.len());
        for (node, &mesh_node) in self.domain.mesh_nodes.iter().enumerate() {
            let mut at_node = on_mesh.fixed_rows_mut::<3>(3 * mesh_node as usize);
            at_node.copy_from(&field.fixed_view::<3, 1>(3 * node, column));
        }
        on_mesh
    }

    /// The result in SI, about the origin of the mesh.
    fn solution(&self) -> Result<SectionSolution, Failure> {
        let frame = Frame {
            scaling: &self.domain.scaling,
            nodes: &self.domain.mesh_nodes,
            count: self.section.mesh.nodes.len(),
            mass: &mass_per_length(&self.domain),
        };
        let mut solution = in_si(&frame, &self.central)?;
        solution.piezo = self.piezo(&solution)?;
        Ok(solution)
    }
}

/// Tag and position of a node of the domain in the mesh.
fn named(section: &Section, domain: &Domain, node: usize) -> Named {
    let mesh_node = domain.mesh_nodes[node] as usize;
    // without tags, nodes are numbered from one
    let tag = section.mesh.node_tags.get(mesh_node).copied();
    Named {
        tag: tag.unwrap_or(mesh_node as u64 + 1),
        position: section.mesh.nodes[mesh_node],
    }
}

#[cfg(test)]
mod tests;
