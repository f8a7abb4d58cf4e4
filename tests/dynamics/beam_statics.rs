//! The tangent of a chain of beams as a static stiffness.
//!
//! Source: `tests/reference/dynamics/beam_static.json`, case `tip_force`: a cantilever
//! of three-node finite-volume beams has the exact tip deflection and slope for any
//! mesh (2e-11 there).

use beam_dynamics::model::{Conditions, Equation};
use beam_dynamics::solver::LinearSolver;
use nalgebra::Vector6;

use crate::record;
use crate::uniform_beam::{Inertia, UniformBeam};

/// L = 1, EI = 3, GA = 50: w = P L^3 / 3 EI + P L / GA, slope P L^2 / 2 EI. Round-off of a
/// few hundred operations on a matrix of condition 1e5: 1e-10.
#[test]
fn a_tip_force_is_exact_for_any_mesh() {
    for elements in [1, 2, 5] {
        let mut beam = UniformBeam::slender(elements, Inertia::Lumped);
        beam.stiffness = Vector6::new(1e3, 50.0, 50.0, 2.0, 3.0, 3.0);
        let system = beam.system();
        let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
        let solver = LinearSolver::new(tangent.by_unknowns.pattern());
        let factorization = solver.factorize(tangent.by_unknowns).unwrap();
        let tip = system.numbering().node(2 * elements);
        // J dy = -residual, and a load adds to the force balance.
        let mut solution = vec![0.0; system.numbering().unknowns()];
        solution[tip + Equation::Force.row() + 2] = -1.0;
        factorization.solve(&mut solution).unwrap();
        let deflection = 1.0 / (3.0 * 3.0) + 1.0 / 50.0;
        // A force along +z turns the section about -y.
        let slope = -1.0 / (2.0 * 3.0);
        for (row, quantity, expected) in
            [(2, "tip deflection", deflection), (4, "tip slope", slope)]
        {
            let (found, source) = (solution[tip + row], "Timoshenko beam, closed form");
            let error = (found / expected - 1.0).abs();
            let case = format!("cantilever of {elements} elements");
            record::value(source, &case, quantity, [found, expected], error, 1e-10);
            assert!(error < 1e-10, "{elements} {quantity}");
        }
    }
}
