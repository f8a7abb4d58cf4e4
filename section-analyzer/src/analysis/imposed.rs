//! Imposed strains: the free strain of an unloaded section, and its restrained force.
//!
//! ```text
//! E x + R y = f0      R' x + A y = fp      r = -Ph' x      x <- x + H r      psi_T = y - T r    (S-92)
//! theta_T = -K psi_T                                                              (S-93)
//! ```
//!
//! psi_T is found a second time, by the work of the imposed stresses on the central
//! solutions (S-94), and must be the same:
//!
//! ```text
//! psi_T = X' f0 + Y' fp + T X' (C x + L psi_T)     on dielectrics less T Ph_V' x_V
//! ```

use super::Analysis;
use crate::assembly::{ImposedForces, Rate, State, imposed_forces, largest, section_forces};
use crate::failure::Failure;
use crate::section::{ImposedStrain, TemperatureField};
use crate::solution::{ImposedSolution, ImposedSolutions};
use crate::solve::{Load, ParticularSolution, electric_work};
use nalgebra::{Matrix6, Vector3, Vector6};
use shared_geom::wrench;

/// States that are solved together.
const TOGETHER: usize = 6;

impl Analysis<'_> {
    /// Effect of one kelvin on the section, if it expands, and of each of `states`.
    ///
    /// # Errors
    /// As [`Analysis::imposed`].
    pub fn all_imposed(&self, states: &[ImposedStrain]) -> Result<ImposedSolutions, Failure> {
        let section = self.section();
        if states.is_empty() && !section.expands() {
            return Ok(ImposedSolutions::default());
        }
        let kelvin = TemperatureField {
            rise: 1.0,
            ..TemperatureField::default()
        };
        let kelvin =
            (section.expands()).then(|| ImposedStrain::of_temperature("", section, &kelvin));
        let all: Vec<_> = kelvin.into_iter().chain(states.iter().cloned()).collect();
        let mut solved = self.imposed(&all)?;
        let states = solved.split_off(usize::from(section.expands()));
        Ok(ImposedSolutions {
            per_kelvin: solved.pop(),
            states,
        })
    }

    /// Warping, free strain and restrained force of each of `states`, one solution for six
    /// states.
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`]; [`Failure::Inaccurate`] when the free strain from the work
    /// on the central solutions differs.
    pub fn imposed(&self, states: &[ImposedStrain]) -> Result<Vec<ImposedSolution>, Failure> {
        let mut found = Vec::with_capacity(states.len());
        for states in states.chunks(TOGETHER) {
            let forces = imposed_forces(self.section(), self.domain(), states);
            let load = Load {
                within: &forces.within,
                resultant: &forces.resultant,
                rate: Rate::Zero,
            };
            let solved = self.particular(&load)?;
            let errors = self.errors(&forces, &solved);
            for (case, state) in states.iter().enumerate() {
                self.require_work("the work of the imposed strains", errors[case])?;
                found.push(self.imposed_in_si(state, &solved, case, errors[case]));
            }
        }
        Ok(found)
    }

    /// The difference of the free strains from (S-94), relative to the largest imposed
    /// strain \[-\]. Each component counts by its stiffness, as in the checks of the central
    /// solutions: `d_i sqrt(C11 / Cii)`, a curvature times a radius of gyration. Otherwise
    /// strips would fail, whose flat curvature loses as many digits as they are thin, and
    /// strains their points by a thousandth of it.
    fn errors(&self, forces: &ImposedForces, solved: &ParticularSolution) -> Vector6<f64> {
        let (domain, central) = (self.domain(), self.central());
        let c = &self.solved.central.compliance;
        let natural = c.diagonal().map(|own| (c[(0, 0)] / own).sqrt());
        let state = State {
            rate: Rate::Zero,
            warping: Some(&solved.x),
            strain: &solved.y,
        };
        let face = section_forces(domain, state).face;
        let tt = domain.line.equilibrium();
        let product = |columns| -> Matrix6<f64> {
            let product = central.x.tr_mul(columns);
            product.fixed_view::<6, 6>(0, 0).into_owned()
        };
        let on_face = product(&face) - electric_work(domain, &central.face, &solved.x);
        let work = product(&forces.within)
            + central.y.transpose() * forces.resultant
            + tt.transpose() * on_face;
        Vector6::from_fn(|case, _| {
            let difference = (solved.y - work).column(case).component_mul(&natural);
            let difference = difference.amax();
            match forces.largest[case] {
                0.0 => difference,
                strain => difference / strain,
            }
        })
    }

    /// Converts from the units of the domain to SI and from its origin to the origin of the
    /// mesh, as the generalized strains of the central solutions.
    fn imposed_in_si(
        &self,
        state: &ImposedStrain,
        solved: &ParticularSolution,
        case: usize,
        error: f64,
    ) -> ImposedSolution {
        let domain = self.domain();
        let scaling = &domain.scaling;
        let [y, z] = scaling.origin;
        let v = wrench::shift_matrix(&Vector3::new(0.0, y, z));
        let strain = solved.y.column(case).component_mul(&scaling.strain());
        let free_strain: Vector6<f64> = v.transpose() * strain;
        ImposedSolution {
            state: state.clone(),
            warping: scaling.length * self.solved.on_mesh(&solved.x, case),
            potential: scaling.potential * self.solved.potential_on_mesh(&solved.x, case),
            free_strain,
            restrained_force: -(self.solution.stiffness * free_strain),
            error: largest(error, 0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::{Domain, Pattern, SectionMatrices, add_rigid_motions};
    use crate::section::samples::{Random, coupled_rectangle, random_strain};
    use crate::section::{FreeStrain, Section};
    use crate::solve::{CentralSolution, CentralSystems, Decoupled, Pins};
    use nalgebra::{DMatrix, DVector};
    use shared_geom::mesh::CellKind;
    use shared_geom::section::InitialCurvature;

    /// A section off its axes, of plies in all directions; straight and curved.
    fn sections() -> [Section; 2] {
        let straight = coupled_rectangle(CellKind::Quadrilateral8);
        let mut curved = straight.clone();
        curved.initial_curvature = InitialCurvature {
            curvature: Vector3::new(0.2, -0.15, 0.1),
            slope: Vector3::new(0.95, 0.1, -0.05),
        };
        [straight, curved]
    }

    /// `H' f0 = T' fp`: the work of imposed stresses on rigid motions of the section
    /// follows from their resultant. Round-off of forces of order one.
    #[test]
    fn imposed_forces_know_of_rigid_motions() {
        for section in sections() {
            let state = random_strain(&section, "any", &mut Random(3));
            let analysis = Analysis::new(&section).expect("sound");
            let domain = analysis.domain();
            let forces = imposed_forces(&section, domain, &[state]);
            let mut rigid = DMatrix::zeros(domain.unknowns(), 6);
            add_rigid_motions(domain, &Matrix6::identity(), &mut rigid);
            let found = rigid.tr_mul(&forces.within);
            let expected = domain.line.equilibrium() * forces.resultant;
            let difference = (found - DMatrix::from_column_slice(6, 6, expected.as_slice())).amax();
            assert!(
                difference < 1e-12 * forces.resultant.amax(),
                "{difference:e}"
            );
        }
    }

    /// A body that expands evenly, (S-133), of any material; a condition of about 1e4 times
    /// round-off.
    #[test]
    fn a_curved_beam_that_grows_evenly_moves_by_the_mean_of_its_positions() {
        for section in sections() {
            let even = FreeStrain {
                at_origin: Vector6::new(1.0, 1.0, 1.0, 0.0, 0.0, 0.0),
                ..FreeStrain::default()
            };
            let state = ImposedStrain {
                name: "even".into(),
                cells: vec![even; section.cells.len()],
            };
            let analysis = Analysis::new(&section).expect("sound");
            let solved = &analysis.imposed(&[state]).expect("sound")[0];
            let domain = analysis.domain();
            let mut positions = DVector::zeros(domain.unknowns());
            for (node, [y, z]) in domain.nodes.iter().enumerate() {
                positions[3 * node + 1] = *y;
                positions[3 * node + 2] = *z;
            }
            let mean = analysis.central().face.tr_mul(&positions);
            let mean: Vector6<f64> = mean.fixed_rows::<6>(0).into();
            let mut growth = domain.line.equilibrium().transpose() * mean;
            for axis in 0..3 {
                growth[axis] += domain.line.slope[axis];
            }
            let [y, z] = domain.scaling.origin;
            let v = wrench::shift_matrix(&Vector3::new(0.0, y, z));
            let expected = v.transpose() * growth.component_mul(&domain.scaling.strain());
            let difference = (solved.free_strain - expected).amax();
            assert!(difference < 1e-11, "{difference:e}");
            let is_straight = section.initial_curvature.is_straight();
            // the free strain is the expansion of the line on the straight beam only, up to
            // the error of the mesh
            let line = section.initial_curvature.slope;
            let off = (solved.free_strain.fixed_rows::<3>(0) - line).amax();
            assert_eq!(off < 1e-4, is_straight, "{off:e}");
        }
    }

    /// Both computations of the free strain agree, and each of seven states, solved in two
    /// batches, equals the state solved alone; a condition of about 1e4 times round-off.
    #[test]
    fn random_states_have_the_free_strain_of_their_work() {
        for section in sections() {
            let analysis = Analysis::new(&section).expect("sound");
            let mut seed = Random(17);
            let states: Vec<_> = (0..7)
                .map(|k| random_strain(&section, &k.to_string(), &mut seed))
                .collect();
            let together = analysis.imposed(&states).expect("sound");
            assert_eq!(together.len(), 7);
            for (state, solved) in states.iter().zip(&together) {
                assert!(solved.error < 1e-11, "{:e}", solved.error);
                let alone = analysis.imposed(std::slice::from_ref(state));
                let alone = &alone.expect("sound")[0];
                let difference = (alone.free_strain - solved.free_strain).amax();
                assert!(difference < 1e-11, "{difference:e}");
                let force = analysis.solution().stiffness * solved.free_strain;
                assert_eq!(solved.restrained_force, -force);
            }
        }
    }

    /// The strains of a state with the unknowns of `pins` at zero, `y - T r` with
    /// `x + H r = 0` there, as before decoupling.
    fn of_pins(domain: &Domain, pins: &Pins, state: &ParticularSolution) -> Matrix6<f64> {
        let mut rigid = DMatrix::zeros(domain.unknowns(), 6);
        add_rigid_motions(domain, &Matrix6::identity(), &mut rigid);
        let held = |field: &DMatrix<f64>| Matrix6::from_fn(|i, j| field[(pins.unknowns()[i], j)]);
        let r = held(&rigid).try_inverse().expect("pins hold") * -held(&state.x);
        state.y - domain.line.equilibrium().transpose() * r
    }

    /// Random strains have the same state for any pins, to round-off times a condition of
    /// about 1e4; before decoupling their generalized strains depend on the pins, with
    /// relative differences above 1e-3.
    #[test]
    fn random_states_do_not_depend_on_the_pins() {
        for section in sections() {
            let analysis = Analysis::new(&section).expect("sound");
            let domain = analysis.domain();
            let mut seed = Random(23);
            let states = [(); 6].map(|()| random_strain(&section, "any", &mut seed));
            let forces = imposed_forces(&section, domain, &states);
            let load = Load {
                within: &forces.within,
                resultant: &forces.resultant,
                rate: Rate::Zero,
            };
            let own = Pins::choose(&domain.nodes).expect("wide");
            let expected = analysis.particular(&load).expect("sound");
            let coupled = of_pins(domain, &own, &expected);
            let pattern = Pattern::new(domain);
            let last = domain.nodes.len() - 1;
            for triple in [[0, last / 2, last], [3, 11, last - 4], [last, 7, 1]] {
                let pins = Pins::at(&domain.nodes, triple);
                let matrices = SectionMatrices::assemble(domain, &pattern).expect("sound");
                let systems = CentralSystems::new(domain, &pattern, matrices, pins.clone());
                let systems = systems.expect("sound");
                let found = CentralSolution::solve(domain, &systems).expect("memory");
                let face = Decoupled::new(domain, found).face;
                let found = ParticularSolution::solve(domain, systems.steady(), &face, &load);
                let found = found.expect("memory");
                let error = (found.y - expected.y).amax() / expected.y.amax();
                assert!(error < 1e-10, "{triple:?}: {error:e}");
                let error = (&found.x - &expected.x).amax() / expected.x.amax();
                assert!(error < 1e-10, "{triple:?}: {error:e}");
                let difference = (of_pins(domain, &pins, &found) - coupled).amax();
                let difference = difference / coupled.amax();
                assert!(difference > 1e-3, "{triple:?}: {difference:e}");
            }
        }
    }
}
