//! Modes of beams whose electrodes lose their charges slowly.

use nalgebra::{DMatrix, Matrix6, Vector2, Vector6};
use shared_geom::section::{self, Centers, Engineering, Piezo, Provenance, SectionProperties};

use super::modes::modes;
use crate::input;

/// A soft beam all of whose electrodes couple with all strains.
fn coupled() -> SectionProperties {
    let stiffness = [2.4e5_f64, 9e4, 8e4, 0.3, 0.5, 20.0];
    let written = Engineering {
        stiffness,
        mass: [0.05, 1e-6, 2e-5],
        centers: Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let sizes = Vector6::from(stiffness).map(f64::sqrt);
    let wave = |i: usize| (1.7 + 2.3 * i as f64).sin();
    let unit = Matrix6::from_fn(|i, j| wave(6 * i + j));
    let unit = Matrix6::identity() + 0.08 * (unit + unit.transpose());
    SectionProperties {
        stiffness: Matrix6::from_fn(|i, j| sizes[i] * unit[(i, j)] * sizes[j]),
        piezo: Some(Piezo {
            electrodes: ["pull", "bend", "twist"].map(str::to_owned).to_vec(),
            coupling: DMatrix::from_fn(6, 3, |i, j| 3e-4 * sizes[i] * wave(40 + 6 * j + i)),
            capacitance: DMatrix::from_diagonal_element(3, 3, 1.5e-6),
        }),
        ..written.section("beam", Provenance::default())
    }
}

/// Charges that leak away in days or years are not modes: the modes are equal to the modes of the
/// open circuit, with all their names, also with a motion without stiffness about a hinge, and with
/// a damper of it. The slowest modes turn through 1e8 of their radians in the shortest of these
/// times.
#[test]
fn charges_that_leak_slowly_are_no_modes() {
    let found = |circuits: [&str; 3], root: &str| {
        let names = ["pull", "bend", "twist"].into_iter().zip(circuits);
        let circuit = |(name, circuit): (&str, &str)| {
            format!("[[electrode]]\nname = \"{name}\"\nblade = \"beam\"\n{circuit}\n")
        };
        let circuits: String = names.map(circuit).collect();
        let text = format!(
            "units = \"SI\"\n[properties.beam]\nfile = \"beam.properties.json\"\n[[blade]]\n\
             name = \"beam\"\nproperties = \"beam\"\n{root}[[blade.piece]]\nlength = 1\n\
             elements = 3\n{circuits}[modes]\nspeeds = [0]\ncount = 6\n"
        );
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            path
        };
        write("beam.properties.json", &section::write(&coupled()));
        let input = input::read(&write("a.dynamics.toml", &text));
        let input = input.unwrap_or_else(|problems| panic!("{problems}"));
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let branches = outcome.table.branches.into_iter();
        branches
            .map(|branch| (branch.name, branch.points[0].as_ref().unwrap().frequency))
            .collect::<Vec<_>>()
    };
    let lag = |damping: f64| format!("hinges = [{{ kind = \"lag\", damping = {damping} }}]\n");
    for (root, free) in [(String::new(), 0), (lag(0.0), 1), (lag(1e-3), 1)] {
        let open = found(["charge = 0"; 3], &root);
        assert_eq!(open.iter().filter(|mode| mode.1 == 0.0).count(), free);
        for resistance in ["1e12", "1e15", "1e18"] {
            let circuit = format!("resistance = {resistance}");
            let leaking = found([&circuit, "charge = 0", &circuit], &root);
            assert_eq!(leaking.len(), open.len());
            for ((name, found), (expected_name, expected)) in leaking.iter().zip(&open) {
                assert_eq!(name, expected_name, "{resistance} ohm");
                assert!(
                    (found - expected).abs() <= 1e-6 * expected,
                    "{name}: {found} {expected}"
                );
            }
        }
    }
}
