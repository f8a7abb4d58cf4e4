//! `section-analyzer mesh`: meshes of simple shapes.

use std::path::Path;

use shared_geom::files::write_text;
use shared_geom::gmsh;
use shared_geom::mesh::{Mesh, PhysicalGroup};

use super::arguments::Shape;
use super::{Stop, Terminal, WRONG_INPUT};
use crate::mesh::generate::{Ellipse, GenerateProblem, Rectangle, Tube};

/// Makes the mesh of `shape` and writes it.
pub(super) fn write_mesh(shape: &Shape, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let (mesh, file) = made(shape);
    let mesh = match mesh {
        Ok(mesh) => mesh,
        Err(problems) => {
            for problem in &problems {
                terminal.tell(problem, WRONG_INPUT);
            }
            return Err(Stop::Told(WRONG_INPUT));
        }
    };
    write_text(file, &gmsh::write(&mesh))
        .map_err(|problem| terminal.tell(&problem, WRONG_INPUT))?;
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

/// The mesh and the file it goes to.
fn made(shape: &Shape) -> (Result<Mesh, Vec<GenerateProblem>>, &Path) {
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
            (rectangle.generate(), &common.out)
        }
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
            (tube.generate(), &common.out)
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
            (ellipse.generate(), &common.out)
        }
    }
}
