//! The section file of a section that is meshed from a layup.

use std::fmt::Write;

use crate::input::layup::{Layup, LayupMesh};

/// The section file of a meshed layup, whose mesh is called `mesh`.
pub fn layup_section(layup: &Layup, meshed: &LayupMesh, mesh: &str) -> String {
    let mut text = String::new();
    // writing to a string cannot fail
    let _ = write_section(&mut text, layup, meshed, mesh);
    text
}

fn write_section(
    text: &mut String,
    layup: &Layup,
    meshed: &LayupMesh,
    mesh: &str,
) -> std::fmt::Result {
    writeln!(text, "mesh = {mesh:?}\n{}", layup.constants)?;
    let is_there = |group: &str| {
        let mut groups = meshed.mesh.groups.iter();
        groups.any(|known| known.dimension == 2 && known.name.as_deref() == Some(group))
    };
    let mut region = |group: &str, material: &str, angle: f64, follow: &str| {
        // turned into degrees and back, an angle has round-off in its last digit
        let angle = (angle.to_degrees() * 1e9).round() / 1e9;
        match is_there(group) {
            true => writeln!(
                text,
                "\n[[region]]\ngroup = {group:?}\nmaterial = {material:?}\n\
                 fiber_angle = \"{angle} deg\"\nplane_angle = {{ follow = {follow:?} }}"
            ),
            false => Ok(()),
        }
    };
    for layer in &meshed.section.layers {
        let Some(written) = layup.layer(&layer.name) else {
            continue;
        };
        let (name, material, angle) = (&layer.name, &written.material, written.fiber_angle);
        if angle == 0.0 {
            region(name, material, 0.0, "contour")?;
            continue;
        }
        // the wall runs toward the leading edge on the suction side, and away from it on the other
        for (side, angle) in [("suction", angle), ("pressure", -angle)] {
            let follow = format!("contour@{side}");
            region(&format!("{name}@{side}"), material, angle, &follow)?;
        }
    }
    for web in &meshed.section.webs {
        for ply in &web.plies {
            if let Some(written) = layup.layer(&ply.name) {
                region(&ply.name, &written.material, written.fiber_angle, &web.name)?;
            }
        }
    }
    Ok(())
}
