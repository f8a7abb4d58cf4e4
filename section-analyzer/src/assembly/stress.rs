//! The forces of a given state of the section, by integration of its stresses.
//!
//! ```text
//! eps   = B1 u' + B0 u + Bpsi psi
//! P     = int B1' D eps J dA   = M u' + C u + L psi      forces on the face
//! Q     = int B0' D eps J dA   = C' u' + E u + R psi     forces within the section
//! theta = int Bpsi' D eps J dA = L' u' + R' u + A psi    internal force
//! W     = int eps' D eps J dA                            work
//! ```
//!
//! Equal to products with the six matrices (S-11), but with the round-off of the strain
//! instead of the displacement. This is important in a thin wall that bends: the terms of
//! the product E u are (size/thickness)^3 times their sum.

use super::cell::DomainCell;
use super::domain::Domain;
use super::forces::{Rate, SectionForces, State};
use super::model::Model;
use crate::element::{
    CASES, CaseLoop, CellCharges, CellField, CellForces, CellPotential, CellState, PotentialState,
    Product, Row, add_coupled, in_widest_registers, rows_of, rule_points,
};
use nalgebra::{DMatrix, Matrix6};

/// The forces of `state`; cases that it does not have are zero.
pub fn section_forces(domain: &Domain, state: State<'_>) -> SectionForces {
    let mut forces = SectionForces::none(domain);
    forces.measure(domain, state);
    forces
}

impl SectionForces {
    /// No forces.
    pub fn none(model: &impl Model) -> Self {
        let n = model.unknowns();
        Self {
            within: DMatrix::zeros(n, 6),
            face: DMatrix::zeros(n, 6),
            resultant: Matrix6::zeros(),
            work: Matrix6::zeros(),
        }
    }

    /// Replaces the forces by the forces of `state`.
    pub fn measure(&mut self, domain: &Domain, state: State<'_>) {
        self.measure_in(domain, state, None);
    }

    /// Replaces the forces by the forces of `state` in the cells marked in `only`, by their
    /// index in the domain; in all cells without it.
    pub fn measure_in(&mut self, domain: &Domain, state: State<'_>, only: Option<&[bool]>) {
        let target = self;
        in_widest_registers(Summation {
            domain,
            state,
            only,
            target,
        });
    }
}

/// The sum over the cells.
struct Summation<'a> {
    domain: &'a Domain,
    state: State<'a>,
    only: Option<&'a [bool]>,
    target: &'a mut SectionForces,
}

impl CaseLoop for Summation<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Product>(self) {
        sum::<P>(self.domain, (self.state, self.only), self.target);
    }
}

#[inline(always)]
fn sum<P: Product>(
    domain: &Domain,
    (state, only): (State<'_>, Option<&[bool]>),
    target: &mut SectionForces,
) {
    target.within.fill(0.0);
    target.face.fill(0.0);
    let laws: Vec<[[f64; 6]; 6]> = domain
        .laws
        .iter()
        .map(|law| law.transpose().into())
        .collect();
    let strain = rows_of(state.strain);
    let mut of_cell = CellState::NONE;
    let line = (!domain.line.is_straight()).then_some(&domain.line);
    let along = line.map(|line| rows_of(&line.equilibrium().transpose()));
    let coupled = domain
        .electric
        .laws
        .iter()
        .map(|law| law.transpose().into());
    let coupled: Vec<[[f64; 9]; 9]> = coupled.collect();
    let mut potentials = PotentialState::NONE;
    let mut forces = CellForces::NONE;
    for (index, cell) in domain.cells.iter().enumerate() {
        if only.is_some_and(|only| !only[index]) {
            continue;
        }
        gather(cell, state, along.as_ref(), &mut of_cell);
        let positions = domain.positions(cell);
        let geometry = (rule_points(cell.kind), &positions[..cell.kind.node_count()]);
        let law = &laws[cell.law as usize];
        forces.clear_nodes();
        if let Some(law) = cell.coupled {
            let unknowns = potential_unknowns(domain, cell);
            gather_potentials(&unknowns, state, along.as_ref(), &mut potentials);
            let (law, mut charges) = (&coupled[law as usize], CellCharges::NONE);
            let (targets, states) = ((&mut forces, &mut charges), (&of_cell, &potentials));
            add_coupled::<P>(targets, &domain.line, geometry, law, states, &strain);
            scatter_potentials(&unknowns, &charges.within, &mut target.within);
            scatter_potentials(&unknowns, &charges.face, &mut target.face);
        } else if let Some(line) = line {
            forces.add_along::<P>(line, geometry, law, &of_cell, &strain);
        } else {
            forces.add::<P>(geometry, law, &of_cell, &strain);
        }
        scatter(cell, &forces.within, &mut target.within);
        scatter(cell, &forces.face, &mut target.face);
    }
    let work = forces.work();
    target.work = 0.5 * (work + work.transpose());
    target.resultant = forces.resultant();
}

/// The state at the nodes of `cell`; `along` is T, by rows, of a line other than a straight
/// beam's.
#[inline(always)]
fn gather(cell: &DomainCell, state: State<'_>, along: Option<&[Row; 6]>, of_cell: &mut CellState) {
    if let Some(warping) = state.warping {
        take_columns(cell, warping, &mut of_cell.warping);
    }
    match state.rate {
        Rate::Zero => {}
        Rate::Given(rate) => take_columns(cell, rate, &mut of_cell.rate),
        Rate::Central => {
            for (rate, warping) in of_cell.rate.iter_mut().zip(&of_cell.warping) {
                for (rate, warping) in rate.iter_mut().zip(warping) {
                    central_rate(along, warping, rate);
                }
            }
        }
    }
}

/// The unknowns of the potentials at the nodes of a cell.
struct PotentialUnknowns {
    count: usize,
    unknowns: [usize; 9],
}

/// The unknowns of a dielectric cell.
#[inline(always)]
fn potential_unknowns(domain: &Domain, cell: &DomainCell) -> PotentialUnknowns {
    let mut of_cell = PotentialUnknowns {
        count: 0,
        unknowns: [0; 9],
    };
    // all nodes of a dielectric cell have a potential
    let unknowns = cell.nodes().iter();
    for unknown in unknowns.filter_map(|&node| domain.potential_unknown(node as usize)) {
        of_cell.unknowns[of_cell.count] = unknown;
        of_cell.count += 1;
    }
    of_cell
}

impl PotentialUnknowns {
    #[inline(always)]
    fn list(&self) -> &[usize] {
        &self.unknowns[..self.count]
    }
}

/// The potentials at the nodes of a cell; `along` as in [`gather`].
#[inline(always)]
fn gather_potentials(
    unknowns: &PotentialUnknowns,
    state: State<'_>,
    along: Option<&[Row; 6]>,
    of_cell: &mut PotentialState,
) {
    if let Some(warping) = state.warping {
        take_potentials(unknowns, warping, &mut of_cell.potential);
    }
    match state.rate {
        Rate::Zero => {}
        Rate::Given(rate) => take_potentials(unknowns, rate, &mut of_cell.rate),
        Rate::Central => {
            for (rate, potential) in of_cell.rate.iter_mut().zip(&of_cell.potential) {
                central_rate(along, potential, rate);
            }
        }
    }
}

/// `X T'` of one unknown; T as in [`gather`].
#[inline(always)]
fn central_rate(along: Option<&[Row; 6]>, warping: &Row, rate: &mut Row) {
    match along {
        None => {
            rate[1] = -warping[5];
            rate[2] = warping[4];
        }
        Some(rows) => {
            for (rate, row) in rate.iter_mut().zip(rows) {
                *rate = (0..6).map(|k| warping[k] * row[k]).sum();
            }
        }
    }
}

/// The columns of `field` (n x k), at most [`CASES`], at the nodes of `cell`.
#[inline(always)]
pub fn take_columns(cell: &DomainCell, field: &DMatrix<f64>, of_cell: &mut CellField) {
    let columns = field.as_slice().chunks_exact(field.nrows());
    for (k, column) in columns.take(CASES).enumerate() {
        for (target, &node) in of_cell.iter_mut().zip(cell.nodes()) {
            let first = 3 * node as usize;
            for (target, value) in target.iter_mut().zip(&column[first..first + 3]) {
                target[k] = *value;
            }
        }
    }
}

/// The potentials in the columns of `field` (n x k) at the nodes of a cell.
#[inline(always)]
fn take_potentials(
    unknowns: &PotentialUnknowns,
    field: &DMatrix<f64>,
    of_cell: &mut CellPotential,
) {
    let columns = field.as_slice().chunks_exact(field.nrows());
    for (k, column) in columns.take(CASES).enumerate() {
        for (target, &unknown) in of_cell.iter_mut().zip(unknowns.list()) {
            target[k] = column[unknown];
        }
    }
}

/// Adds the charges of a cell at its nodes to `field` (n x 6).
#[inline(always)]
fn scatter_potentials(
    unknowns: &PotentialUnknowns,
    of_cell: &CellPotential,
    field: &mut DMatrix<f64>,
) {
    let rows = field.nrows();
    for (k, column) in field.as_mut_slice().chunks_exact_mut(rows).enumerate() {
        for (part, &unknown) in of_cell.iter().zip(unknowns.list()) {
            column[unknown] += part[k];
        }
    }
}

/// Adds the values of `cell` at its nodes to `field` (n x 6).
#[inline(always)]
fn scatter(cell: &DomainCell, of_cell: &CellField, field: &mut DMatrix<f64>) {
    let rows = field.nrows();
    for (k, column) in field.as_mut_slice().chunks_exact_mut(rows).enumerate() {
        for (part, &node) in of_cell.iter().zip(cell.nodes()) {
            let first = 3 * node as usize;
            for (value, part) in column[first..first + 3].iter_mut().zip(part) {
                *value += part[k];
            }
        }
    }
}
