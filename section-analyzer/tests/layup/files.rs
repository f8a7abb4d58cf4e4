//! Layup files: all stations are meshed; scaling, units and damaged texts.

use std::path::{Path, PathBuf};

use section_analyzer::analysis::analyze;
use section_analyzer::input::{self, layup};
use section_analyzer::output::layup_section;
use shared_geom::gmsh;

use crate::random::Random;

const NAMES: [&str; 2] = ["wind_blade", "rotor_blade"];

fn path(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/layup/files");
    folder.join(format!("{name}.layup.toml"))
}

fn read(name: &str) -> layup::Layup {
    layup::read(&path(name)).unwrap_or_else(|problems| panic!("{problems}"))
}

/// The section file of a station, read again.
pub fn section(layup: &layup::Layup, eta: f64) -> input::Input {
    let meshed = layup
        .mesh(eta)
        .unwrap_or_else(|problems| panic!("{problems}"));
    section_of(layup, &meshed)
}

/// The section file of a mesh, read again.
pub fn section_of(layup: &layup::Layup, meshed: &layup::LayupMesh) -> input::Input {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.section.toml");
    std::fs::write(folder.path().join("a.msh"), gmsh::write(&meshed.mesh)).expect("a mesh");
    std::fs::write(&file, layup_section(layup, meshed, "a.msh")).expect("a section");
    input::read(&file).unwrap_or_else(|problems| panic!("{problems}"))
}

#[test]
fn all_stations_are_meshed() {
    for name in NAMES {
        let layup = read(name);
        let mut stations = layup.positions();
        stations.extend([0.02, 0.33, 0.7]);
        for eta in stations {
            let meshed = layup
                .mesh(eta)
                .unwrap_or_else(|problems| panic!("{problems}"));
            let worst = meshed
                .areas
                .iter()
                .map(|area| (area.meshed / area.nominal - 1.0).abs());
            println!(
                "{name} {eta}: {} cells, {}",
                meshed.mesh.cells.len(),
                worst.fold(0.0, f64::max)
            );
        }
    }
}

/// The sum of the masses of the layers, by their nominal areas, is the mass of the section within
/// 0.5 %, the accuracy of areas. Fibers toward the leading edge on both sides of a symmetric
/// section couple torsion and bending (K45), and leave K14 and K15 zero.
#[test]
fn sections_are_solved_with_materials_and_angles() {
    let wind = section(&read("wind_blade"), 0.4);
    let solution = analyze(&wind.section).expect("a solution");
    let densities = [("gelcoat", 1235.0), ("foam", 130.0)];
    let meshed = read("wind_blade").mesh(0.4).expect("a mesh");
    let layup = read("wind_blade");
    let mass = meshed.areas.iter().map(|area| {
        let material = layup
            .layer(&area.name)
            .map_or("", |layer| layer.material.as_str());
        let known = densities.iter().find(|one| one.0 == material);
        area.nominal * known.map_or(1940.0, |one| one.1)
    });
    let error = solution.mass[(0, 0)] / mass.sum::<f64>() - 1.0;
    assert!(error.abs() < 5e-3, "{error}");

    // without the angle of the web the section is symmetric about its chord
    let text = std::fs::read_to_string(path("rotor_blade")).expect("a file");
    let text = text.replace(", fiber_angle = -45", "");
    let rotor = layup::parse(&text, &path("rotor_blade")).expect("a layup");
    let rotor = section(&rotor, 0.0);
    let stiffness = analyze(&rotor.section).expect("a solution").stiffness;
    let relative =
        |i: usize, j: usize| stiffness[(i, j)] / (stiffness[(i, i)] * stiffness[(j, j)]).sqrt();
    // fibers toward the leading edge on both sides, mirrored about the chord: tension couples
    // neither with torsion nor with bending out of the chord, torsion couples with bending
    println!("{} {}", relative(0, 3), relative(3, 4));
    assert!(relative(3, 4).abs() > 0.02, "{}", relative(3, 4));
    assert!(
        relative(0, 3).abs() < 0.1 * relative(3, 4).abs(),
        "{}",
        relative(0, 3)
    );
    assert!(relative(0, 4).abs() < 1e-3, "{}", relative(0, 4));
}

/// Texts cut at any byte, and with changed bytes: read or refused with a message.
#[test]
fn damaged_files_are_read_or_refused() {
    let (mut good, mut bad) = (0, 0);
    let mut look = |text: &str| match layup::parse(text, Path::new("a.layup.toml")) {
        Ok(_) => good += 1,
        Err(problems) => {
            assert!(!problems.to_string().is_empty());
            bad += 1;
        }
    };
    let mut random = Random::new(11);
    let files = NAMES.map(|name| std::fs::read_to_string(path(name)).expect("a file"));
    let others = [crate::fills::TEXT, crate::spars::TEXT].map(str::to_owned);
    for text in files.into_iter().chain(others) {
        for end in (0..text.len()).step_by(7) {
            look(&text[..end]);
        }
        for _ in 0..200 {
            let mut bytes = text.clone().into_bytes();
            let at = (random.unit() * bytes.len() as f64) as usize;
            bytes[at] = b"\"[]{}=,.#-0 9az\n"[(random.unit() * 16.0) as usize];
            look(&String::from_utf8_lossy(&bytes));
        }
    }
    println!("{good} read, {bad} refused");
    assert!(good > 10 && bad > 100);
}
