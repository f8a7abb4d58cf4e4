//! Meshes of other tools, by their content: Abaqus, VTK (legacy and XML), VABS. The name has
//! the ending of Abaqus for files with a keyword at first.
#![no_main]

use libfuzzer_sys::fuzz_target;
use shared_geom::mesh_file;

fuzz_target!(|bytes: &[u8]| {
    let name = if bytes.starts_with(b"*") { "a.inp" } else { "a.mesh" };
    if let Err(problems) = mesh_file::read(bytes, name) {
        assert!(!problems.to_string().is_empty());
    }
});
