//! The section file of a generated blade, without the constants of its materials.

use std::fmt::Write;

use crate::input::blade::BladeInput;

/// A section file with the regions and angles of a blade, whose mesh is called `mesh`;
/// the materials have names and no constants yet.
pub fn blade_section(blade: &BladeInput, mesh: &str) -> String {
    let mut text = String::new();
    // writing to a string cannot fail
    let _ = write_section(&mut text, blade, mesh);
    text
}

fn write_section(text: &mut String, blade: &BladeInput, mesh: &str) -> std::fmt::Result {
    writeln!(text, "mesh = {mesh:?}\n")?;
    if blade.units.is_empty() {
        writeln!(text, "units = \"SI\"\n")?;
    } else {
        writeln!(text, "[units]")?;
        for (key, unit) in &blade.units {
            writeln!(text, "{key} = {unit:?}")?;
        }
        writeln!(text)?;
    }
    writeln!(
        text,
        "# Each material needs its constants: \"young\" and \"poisson\"; or \"e1\", \"e2\", \"e3\",\n\
         # \"g12\", \"g13\", \"g23\", \"nu12\", \"nu13\", \"nu23\"; or \"stiffness\"."
    )?;
    let mut known: Vec<&str> = Vec::new();
    for region in &blade.regions {
        if !known.contains(&region.material.as_str()) {
            known.push(&region.material);
            writeln!(text, "[material.{}]\n# density =\n", key(&region.material))?;
        }
    }
    for region in &blade.regions {
        writeln!(text, "[[region]]\ngroup = {:?}", region.group)?;
        writeln!(text, "material = {:?}", region.material)?;
        if let Some(follow) = region.follow {
            // turned into degrees and back, an angle has round-off in its last digit
            let angle = (region.fiber_angle * 1e9).round() / 1e9;
            writeln!(text, "fiber_angle = \"{angle} deg\"")?;
            writeln!(text, "plane_angle = {{ follow = {follow:?} }}")?;
        }
        writeln!(text)?;
    }
    Ok(())
}

/// A key of TOML, in quotes where it needs them.
fn key(name: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "-_".contains(letter);
    if name.chars().all(is_plain) {
        name.to_owned()
    } else {
        format!("{name:?}")
    }
}
