//! Input folders of BECAS: four tables, separated by lines of `====`.
#![no_main]

use libfuzzer_sys::fuzz_target;
use shared_geom::mesh_file;

fuzz_target!(|text: &str| {
    let mut parts = text.split("====\n");
    let files = mesh_file::BECAS_FILES.map(|name| (name, parts.next().unwrap_or("")));
    match mesh_file::read_becas(files) {
        Ok(model) => assert_eq!(model.mesh.cells.len(), model.cells.len()),
        Err(problems) => assert!(!problems.to_string().is_empty()),
    }
});
