//! Critical loads of random columns against dense eigenvalues, none lost and none invented.
//!
//! The reference takes K_0 and K_1 of the program as dense matrices of the motions that are not
//! clamped, and counts the negative eigenvalues of `K_0 +- lambda K_1` just below and just above
//! each load (Sylvester's law of inertia): the k-th load is the k-th one. It is independent of the
//! method of the program. With the table of prestress every evaluation point loses its torsional
//! stiffness at one load, whose multiplicity is the number of these points.

use beam_dynamics::analysis::buckling::buckling;
use beam_dynamics::assembly::Sparse;
use beam_dynamics::case::Model;
use beam_dynamics::input;
use nalgebra::{DMatrix, DVector, Vector2};
use shared_geom::section::{
    self, Centers, CubicTable, Engineering, Prestress, Provenance, SectionProperties, StrainMeasure,
};

use crate::record;
use crate::variational_beam::spectra::Random;

/// Columns, each without and with the table.
const COLUMNS: usize = 100;
/// Round-off of dense eigenvalues, 1e-16 of the largest, relative to the change of the lowest,
/// about 1e-9 of the largest.
const TOLERANCE: f64 = 1e-6;

/// An aluminum strip of width b and thickness t \[m\].
fn strip([b, t]: [f64; 2], has_table: bool) -> SectionProperties {
    let (young, shear, density) = (70e9, 26.9e9, 2700.0);
    let area = b * t;
    let (iy, iz) = (b * t.powi(3) / 12.0, t * b.powi(3) / 12.0);
    let written = Engineering {
        stiffness: [
            young * area,
            0.83 * shear * area,
            0.83 * shear * area,
            shear * 4.0 * iy,
            young * iy,
            young * iz,
        ],
        mass: [density * area, density * iy, density * iz],
        centers: Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let table = Prestress {
        strain_measure: StrainMeasure::Biot,
        third: CubicTable::from_fn(|at| match at {
            [0, 1, 1] => young * (iy + iz),
            _ => 0.0,
        }),
        per_kelvin: None,
    };
    SectionProperties {
        prestress: has_table.then_some(table),
        ..written.section("strip", Provenance::default())
    }
}

/// A clamped strip under a tip force of 1 N against it, with some moment.
fn column(section: &SectionProperties, length: f64, elements: usize, count: usize) -> input::Input {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("strip.properties.json");
    std::fs::write(file, section::write(section)).unwrap();
    let key = match section.prestress {
        Some(_) => "prestress = true",
        None => "",
    };
    let text = format!(
        "units = \"SI\"\n[properties.strip]\nfile = \"strip.properties.json\"\n{key}\n\
         [[blade]]\nname = \"strip\"\nproperties = \"strip\"\n\
         [[blade.piece]]\nlength = {length}\nelements = {elements}\n\
         [[load]]\nnode = \"strip/tip\"\nforce = [-1, 0, 0]\n\
         [buckling]\ncount = {count}\n"
    );
    let file = folder.path().join("strip.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    input::read(&file).unwrap_or_else(|problems| panic!("{problems}"))
}

/// `K_0` and `K_1` of the motions of all nodes except the clamped one, symmetric and scaled to a
/// unit diagonal of the first.
struct Dense {
    stiffness: DMatrix<f64>,
    growth: DMatrix<f64>,
}

impl Dense {
    fn new(model: &Model) -> Self {
        let system = &model.system;
        let conditions = model.conditions(0.0, 1.0, 0.0);
        let state = system.rest();
        let n = system.pattern().size();
        let full = |entries: &Sparse| {
            let mut matrix = DMatrix::zeros(n, n);
            entries.triplets().for_each(|(i, j, x)| matrix[(i, j)] += x);
            matrix
        };
        let tangent = full(&system.tangent(&state, &conditions).by_unknowns);
        let load = DVector::from_vec(system.by_factor(&state, &conditions));
        let along = -tangent.clone().lu().solve(&load).unwrap();
        let growth = full(&system.prestress(&state, &conditions, along.as_slice()));
        let positions: Vec<_> = (1..system.nodes().len())
            .flat_map(|node| (0..6).map(move |i| 12 * node + i))
            .collect();
        let own = |matrix: &DMatrix<f64>| {
            let half = DMatrix::from_fn(positions.len(), positions.len(), |i, j| {
                matrix[(positions[i] + 6, positions[j])]
            });
            0.5 * (&half + half.transpose())
        };
        let (stiffness, growth) = (own(&tangent), own(&growth));
        let sign = stiffness.trace().signum();
        let scale = stiffness.diagonal().map(|value| 1.0 / value.abs().sqrt());
        let scaled = |matrix: &DMatrix<f64>| {
            DMatrix::from_fn(positions.len(), positions.len(), |i, j| {
                sign * scale[i] * matrix[(i, j)] * scale[j]
            })
        };
        Self {
            stiffness: scaled(&stiffness),
            growth: scaled(&growth),
        }
    }

    /// Critical factors of a magnitude below `limit`, by Sylvester's law: each makes one
    /// eigenvalue of `K_0 + limit K_1`, or of `K_0 - limit K_1`, negative.
    fn below(&self, limit: f64) -> usize {
        let negative = |factor: f64| {
            let matrix = &self.stiffness + factor * &self.growth;
            let values = matrix.symmetric_eigenvalues();
            values.iter().filter(|value| **value < 0.0).count()
        };
        negative(limit) + negative(-limit)
    }
}

#[test]
fn columns_give_way_at_the_dense_eigenvalues() {
    let mut random = Random(17);
    let mut between = |from: f64, to: f64| from + 0.5 * (to - from) * (1.0 + random.number());
    let mut largest = [0.0_f64; 2];
    for case in 0..COLUMNS {
        let width = between(0.02, 0.1);
        let shape = [width, width / between(3.0, 40.0)];
        let length = width * between(3.0, 20.0);
        let elements = between(3.0, 6.999) as usize;
        let count = between(1.0, 8.999) as usize;
        for has_table in [false, true] {
            let input = column(&strip(shape, has_table), length, elements, count);
            let dense = Dense::new(&input.model);
            let outcome = buckling(&input.model, &input.buckling.unwrap());
            let at =
                format!("column {case}, table {has_table}: {elements} elements, {count} requested");
            assert!(outcome.failure.is_none(), "{at}: {:?}", outcome.failure);
            let found: Vec<_> = outcome
                .result
                .modes
                .iter()
                .map(|mode| mode.factor)
                .collect();
            assert_eq!(found.len(), count, "{at}: {found:?}");
            for (k, mode) in outcome.result.modes.iter().enumerate() {
                let limits = [1.0 - TOLERANCE, 1.0 + TOLERANCE].map(|by| by * mode.factor.abs());
                let [below, above] = limits.map(|limit| dense.below(limit));
                assert!(
                    below <= k && k < above,
                    "{at}: {k}, {below} {above} of {found:?}"
                );
                let own = &mut largest[usize::from(has_table)];
                *own = own.max(mode.residual);
            }
        }
    }
    for (error, case) in largest.into_iter().zip(["without", "with"]) {
        let case = format!("{COLUMNS} random columns {case} a table of prestress");
        record::largest(
            "dense eigenvalues",
            &case,
            "critical loads",
            error,
            TOLERANCE,
        );
    }
}

/// The cases in which values were lost and invented: strips of 0.3 m and 8 elements whose 16
/// evaluation points lose their torsional stiffness together, for any count.
#[test]
fn the_count_does_not_change_what_is_found() {
    let section = strip([0.1, 0.01], true);
    let of = |count: usize| -> Vec<f64> {
        let input = column(&section, 0.3, 8, count);
        let outcome = buckling(&input.model, &input.buckling.unwrap());
        assert!(outcome.failure.is_none(), "{count}: {:?}", outcome.failure);
        outcome
            .result
            .modes
            .iter()
            .map(|mode| mode.factor)
            .collect()
    };
    let all = of(24);
    assert_eq!(all.len(), 24);
    for count in 1..24 {
        let found = of(count);
        assert_eq!(found.len(), count);
        for (found, all) in found.iter().zip(&all) {
            assert!(
                (found / all - 1.0).abs() < TOLERANCE,
                "{count}: {found} {all}"
            );
        }
    }
}
