//! Mesh files: versions 2.2 and 4.1, ascii and binary, through the one entry. Meshes that
//! are read can be written, and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use shared_geom::gmsh;

fuzz_target!(|bytes: &[u8]| {
    match gmsh::read(bytes, "a.msh") {
        Ok(mesh) => drop(gmsh::read(&gmsh::write(&mesh), "again.msh")),
        Err(problems) => assert!(!problems.to_string().is_empty()),
    }
});
