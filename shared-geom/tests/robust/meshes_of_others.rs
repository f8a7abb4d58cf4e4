//! Meshes and section models of other tools: Abaqus, VTK, VABS, BECAS.

use shared_geom::mesh_file::{self, BECAS_FILES, read_becas};

use crate::mutation::{Random, mutated};
use crate::{SLACK, ZLIB, alone, seeds, within};

const MUTATIONS: usize = 500;

/// Whether a mesh file is read; it has problems otherwise.
fn is_read(name: &str, bytes: &[u8]) -> bool {
    match mesh_file::read(bytes, name) {
        Ok(mesh) => {
            let count = mesh.nodes.len();
            let nodes = mesh.cells.iter().flat_map(|cell| cell.nodes());
            assert!(nodes.into_iter().all(|&node| (node as usize) < count));
            true
        }
        Err(problems) => {
            assert!(!problems.is_empty());
            false
        }
    }
}

/// Whether a folder of BECAS is read, whose files are separated by lines of `====`.
fn is_becas(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    let mut parts = text.split("====\n");
    let files = BECAS_FILES.map(|name| (name, parts.next().unwrap_or("")));
    match read_becas(files) {
        Ok(model) => {
            assert_eq!(model.mesh.cells.len(), model.cells.len());
            true
        }
        Err(problems) => {
            assert!(!problems.is_empty());
            false
        }
    }
}

/// Each seed is read; cut and changed ones are read or refused, within the memory of all
/// readers.
fn check(target: &str, is_read: impl Fn(&str, &[u8]) -> bool) {
    let (mut good, mut bad) = (0, 0);
    for (number, (name, bytes)) in seeds(target).into_iter().enumerate() {
        assert!(is_read(&name, &bytes), "{name}");
        let mut random = Random::new(number as u64);
        let mut check = |what: String, bytes: &[u8]| {
            let read = |bytes: &[u8]| is_read(&name, bytes);
            if within(&what, bytes, SLACK + ZLIB, read) {
                good += 1
            } else {
                bad += 1
            }
        };
        for end in (0..bytes.len()).step_by(7) {
            check(format!("{name} cut at byte {end}"), &bytes[..end]);
        }
        for mutation in 0..MUTATIONS {
            let changed = mutated(&bytes, &mut random);
            check(format!("{name}, mutation {mutation}"), &changed);
        }
    }
    println!("{target}: {good} read, {bad} refused");
    assert!(good > 10 && bad > 10);
}

#[test]
fn changed_meshes_are_read_or_refused() {
    let _alone = alone();
    check("mesh_file", is_read);
}

#[test]
fn changed_folders_of_becas_are_read_or_refused() {
    let _alone = alone();
    check("becas", |_, bytes| is_becas(bytes));
}
