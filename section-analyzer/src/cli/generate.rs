//! `section-analyzer mesh`: meshes of simple shapes and of blades.

use std::path::Path;

use shared_geom::files::write_text;
use shared_geom::gmsh;
use shared_geom::mesh::{Mesh, PhysicalGroup};

use super::arguments::{BladeArguments, Common, MeshLayupArguments, Shape};
use super::{Stop, Terminal, WRONG_INPUT};
use crate::input::{blade, layup};
use crate::mesh::generate::{Ellipse, GenerateProblem, Rectangle, Tube};
use crate::output::{blade_section, layup_section};

/// Makes the mesh of `shape` and writes it.
pub(super) fn write_mesh(shape: &Shape, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let (mesh, common) = match made(shape) {
        Made::Blade(blade) => return write_blade(blade, terminal),
        Made::Layup(layup) => return write_layup(layup, terminal),
        Made::Shape(mesh, common) => (mesh, common),
    };
    let mesh = match mesh {
        Ok(mesh) => mesh,
        Err(problems) => {
            for problem in &problems {
                terminal.report(problem, WRONG_INPUT);
            }
            return Err(Stop::Reported(WRONG_INPUT));
        }
    };
    require_new([Some(&*common.out), None], common.force, terminal)?;
    write_file(&mesh, &common.out, terminal)
}

/// Writes a mesh and lists its contents.
fn write_file(mesh: &Mesh, file: &Path, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    write_text(file, &gmsh::write(mesh))
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let groups = |dimension: u8| {
        let of_dimension = mesh
            .groups
            .iter()
            .filter(|group| group.dimension == dimension);
        let names: Vec<_> = of_dimension.map(PhysicalGroup::label).collect();
        names.join(", ")
    };
    writeln!(
        terminal.out,
        "{}: {} nodes, {} {}\n  physical surface: {}\n  physical curves: {}",
        file.display(),
        mesh.nodes.len(),
        mesh.cells.len(),
        if mesh.cells.len() == 1 {
            "cell"
        } else {
            "cells"
        },
        groups(2),
        groups(1),
    )?;
    Ok(())
}

/// Meshes the section of a blade, and starts its section file.
fn write_blade(arguments: &BladeArguments, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let (out, section) = (&arguments.out, arguments.section.as_deref());
    let blade = blade::read(&arguments.file).map_err(|problems| terminal.report_all(&problems))?;
    require_new([Some(out), section], arguments.force, terminal)?;
    // both files first: nobody may read the report about them
    if let Some(section) = section {
        let text = blade_section(&blade, &name_from(section, out));
        write_text(section, &text).map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    }
    write_file(&blade.mesh, out, terminal)?;
    let Some(section) = section else {
        return Ok(());
    };
    writeln!(
        terminal.out,
        "{}: regions and angles; the constants of the materials are still to be written",
        section.display()
    )?;
    Ok(())
}

/// Refuses files that exist, without `--force`.
fn require_new(
    files: [Option<&Path>; 2],
    force: bool,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let written = files.into_iter().flatten();
    let existing = written.filter(|file| !force && file.is_file());
    let problems: Vec<_> = existing
        .map(|file| {
            format!(
                "error: \"{}\" exists already, expected the name of a new file\n  \
                 help: --force replaces it",
                file.display()
            )
        })
        .collect();
    if problems.is_empty() {
        return Ok(());
    }
    Err(terminal.report_text(&problems.join("\n"), WRONG_INPUT))
}

/// Meshes a section of a layup, and writes its section file.
fn write_layup(arguments: &MeshLayupArguments, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let (out, section) = (&arguments.out, arguments.section.as_deref());
    let treatment = super::layup::materials(arguments.repair_materials);
    let layup = layup::read_with(&arguments.file, treatment)
        .map_err(|problems| terminal.report_all(&problems))?;
    let meshed = layup.mesh(arguments.eta);
    let meshed = meshed.map_err(|problems| terminal.report_all(&problems))?;
    require_new([Some(out), section], arguments.force, terminal)?;
    // both files first: nobody may read the report about them
    if let Some(section) = section {
        let text = layup_section(&layup, &meshed, &name_from(section, out));
        write_text(section, &text).map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    }
    write_file(&meshed.mesh, out, terminal)?;
    super::layup::write_remarks(&layup, terminal)?;
    if let Some(section) = section {
        writeln!(
            terminal.out,
            "{}: materials, regions and angles",
            section.display()
        )?;
    }
    Ok(())
}

/// Name of the mesh in a section file.
fn name_from(section: &Path, mesh: &Path) -> String {
    if section.parent() == mesh.parent() {
        let name = mesh.file_name().unwrap_or_default();
        return name.to_string_lossy().into_owned();
    }
    let whole = std::path::absolute(mesh).unwrap_or_else(|_| mesh.to_owned());
    whole.display().to_string()
}

/// A file to write.
enum Made<'a> {
    Shape(Result<Mesh, Vec<GenerateProblem>>, &'a Common),
    Blade(&'a BladeArguments),
    Layup(&'a MeshLayupArguments),
}

/// The mesh and the file it goes to.
fn made(shape: &Shape) -> Made<'_> {
    match shape {
        Shape::Rectangle {
            width,
            height,
            cells_y,
            cells_z,
            name,
            common,
        } => {
            let rectangle = Rectangle {
                width: *width,
                height: *height,
                cells_y: *cells_y,
                cells_z: *cells_z,
                kind: common.cell.kind(),
                name: name.clone(),
            };
            Made::Shape(rectangle.generate(), common)
        }
        Shape::Blade(arguments) => Made::Blade(arguments),
        Shape::Layup(arguments) => Made::Layup(arguments),
        Shape::Tube {
            outer_radius,
            thickness,
            cells_around,
            cells_through,
            straight,
            common,
        } => {
            let tube = Tube {
                outer_radius: *outer_radius,
                thickness: *thickness,
                cells_around: *cells_around,
                cells_through: *cells_through,
                kind: common.cell.kind(),
                curved: !straight,
            };
            Made::Shape(tube.generate(), common)
        }
        Shape::Ellipse {
            semi_y,
            semi_z,
            cells,
            straight,
            common,
        } => {
            let ellipse = Ellipse {
                semi_y: *semi_y,
                semi_z: *semi_z,
                cells: *cells,
                kind: common.cell.kind(),
                curved: !straight,
            };
            Made::Shape(ellipse.generate(), common)
        }
    }
}
