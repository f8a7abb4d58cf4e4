//! The section file of a section that is meshed from a layup.

use std::fmt::Write;

use shared_geom::document::basic_string;

use crate::input::layup::{Layup, LayupMesh, Toward, table_name};

/// The section file of a meshed layup, whose mesh is called `mesh`.
pub fn layup_section(layup: &Layup, meshed: &LayupMesh, mesh: &str) -> String {
    let mut text = String::new();
    // writing to a string cannot fail
    let _ = write_section(&mut text, layup, meshed, mesh);
    text
}

/// The tables of units and of the materials of this section: another section does not depend on
/// the constants of the other materials.
fn constants(layup: &Layup, meshed: &LayupMesh) -> String {
    let layers = meshed.section.layers.iter().map(|layer| &layer.name);
    let plies = meshed.section.webs.iter().flat_map(|web| &web.plies);
    let fills = meshed.section.fills.iter().map(|fill| &fill.name);
    let names = layers.chain(plies.map(|ply| &ply.name)).chain(fills);
    let materials: Vec<&str> = names.filter_map(|name| layup.material_of(name)).collect();
    let is_used = |head: &str| match head.strip_prefix("material.") {
        Some(rest) if rest.starts_with(['"', '\'']) => {
            let quoted = |name: &&str| [basic_string(name), format!("'{name}'")];
            let mut quoted = materials.iter().flat_map(quoted);
            quoted.any(|name| rest.starts_with(&name))
        }
        Some(rest) => {
            let end = rest.find(['.', ']', ' ']).unwrap_or(rest.len());
            materials.contains(&&rest[..end])
        }
        None => true,
    };
    let mut is_kept = true;
    let mut kept = String::new();
    for line in layup.constants.lines() {
        is_kept = table_name(line).map_or(is_kept, is_used);
        if is_kept {
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}

fn write_section(
    text: &mut String,
    layup: &Layup,
    meshed: &LayupMesh,
    mesh: &str,
) -> std::fmt::Result {
    let file = basic_string(mesh);
    writeln!(text, "mesh = {file}\n{}", constants(layup, meshed))?;
    let is_there = |group: &str| {
        let mut groups = meshed.mesh.groups.iter();
        groups.any(|known| known.dimension == 2 && known.name.as_deref() == Some(group))
    };
    let mut region = |group: &str, material: &str, angle: f64, follow: &str| {
        if is_there(group) {
            let [group, material, follow] = [group, material, follow].map(basic_string);
            writeln!(
                text,
                "\n[[region]]\ngroup = {group}\nmaterial = {material}\n\
                 fiber_angle = {}\nplane_angle = {{ follow = {follow} }}",
                degrees(angle)
            )
        } else {
            Ok(())
        }
    };
    for layer in &meshed.section.layers {
        let Some(written) = layup.layer(&layer.name) else {
            continue;
        };
        let angle = written.fiber_angle.at(meshed.eta);
        let (name, material) = (&layer.name, &written.material);
        let web = written.web.as_ref().map(|(web, _)| web);
        if let Some(web) = web {
            region(&format!("{name}@{web}"), material, angle, web)?;
        }
        let is_along = angle == 0.0 || written.toward == Toward::Contour;
        if is_along && web.is_none() {
            region(name, material, angle, "contour")?;
            continue;
        }
        // the wall runs toward the leading edge on the suction side, and away from it on the other
        let below = if is_along { angle } else { -angle };
        for (side, angle) in [("suction", angle), ("pressure", below)] {
            let follow = format!("contour@{side}");
            region(&format!("{name}@{side}"), material, angle, &follow)?;
        }
    }
    for web in &meshed.section.webs {
        for ply in &web.plies {
            if let Some(written) = layup.layer(&ply.name) {
                let angle = written.fiber_angle.at(meshed.eta);
                region(&ply.name, &written.material, angle, &web.name)?;
            }
        }
    }
    write_fills(text, layup, meshed)
}

fn write_fills(text: &mut String, layup: &Layup, meshed: &LayupMesh) -> std::fmt::Result {
    for fill in &meshed.section.fills {
        if let Some(written) = layup.fill(&fill.name) {
            let angles = [written.fiber_angle, written.plane_angle].map(degrees);
            writeln!(
                text,
                "\n[[region]]\ngroup = {}\nmaterial = {}\nfiber_angle = {}\nplane_angle = {}",
                basic_string(&fill.name),
                basic_string(&written.material),
                angles[0],
                angles[1]
            )?;
        }
    }
    Ok(())
}

/// An angle in degrees: turned into degrees and back, it has round-off in its last digit.
fn degrees(angle: f64) -> String {
    format!("\"{} deg\"", (angle.to_degrees() * 1e9).round() / 1e9)
}
