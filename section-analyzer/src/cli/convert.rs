//! `section-analyzer convert`: section files of models of other tools.

use std::path::{Path, PathBuf};

use shared_geom::files::{name_without, write_text};
use shared_geom::gmsh;
use shared_geom::mesh_file::Model;

use super::arguments::ConvertArguments;
use super::{Stop, Terminal, WRONG_INPUT};
use crate::input::model;
use crate::mesh::{DoubledNodes, MeshProblem, SectionMesh};
use crate::output::{ModelNames, model_angles, model_section};

/// A file to write: its path, its text, and a description of its content.
type Written = (PathBuf, String, String);

/// Reads a model, and writes its section file, mesh and tables, none of which may exist.
pub(super) fn convert_model(
    arguments: &ConvertArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let model = model::read(&arguments.model).map_err(|problems| terminal.report_all(&problems))?;
    let files = files_of(&model, arguments);
    if let Some((file, _, _)) = files.iter().find(|(file, _, _)| file.exists()) {
        let text = format!(
            "error: \"{}\" exists already, expected the name of a new section file\n  help: \
             give another name, or remove the file",
            file.display()
        );
        return Err(terminal.report_text(&text, WRONG_INPUT));
    }
    for (file, text, _) in &files {
        write_text(file, text).map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    }
    for (file, _, content) in &files {
        writeln!(terminal.out, "{}: {content}", file.display())?;
    }
    let checked = SectionMesh::checked(&model.mesh, 1.0, DoubledNodes::Allow);
    let problems: Vec<String> = checked.map_or_else(
        |problems| problems.iter().map(words_of_mesh).collect(),
        |_| Vec::new(),
    );
    terminal.warn(&arguments.model, &problems)?;
    for note in &model.notes {
        writeln!(terminal.out, "  remark: {note}")?;
    }
    Ok(())
}

/// A problem of the mesh of a model, which is written with it.
fn words_of_mesh(problem: &MeshProblem) -> String {
    format!("the section cannot be analyzed: {problem}")
}

/// The files of a model: the section file, the mesh, and the tables that it needs.
fn files_of(model: &Model, arguments: &ConvertArguments) -> Vec<Written> {
    let section = &arguments.section;
    let folder = section.parent().unwrap_or(Path::new(""));
    let name = name_without(section, ".section.toml");
    let [mesh, fiber_angles, plane_angles] =
        [".msh", ".fiber_angles.csv", ".plane_angles.csv"].map(|ending| name.clone() + ending);
    let names = ModelNames {
        model: &arguments.model.display().to_string(),
        mesh: &mesh,
        fiber_angles: &fiber_angles,
        plane_angles: &plane_angles,
        units: [&arguments.length, &arguments.force],
    };
    let counted = |count: usize, one: &str| {
        let plural = if count == 1 { "" } else { "s" };
        format!("{count} {one}{plural}")
    };
    let mut files = vec![
        (
            section.clone(),
            model_section(model, &names),
            format!(
                "{}, {}",
                counted(model.materials.len(), "material"),
                counted(model.regions.len(), "region")
            ),
        ),
        (
            folder.join(&mesh),
            gmsh::write(&model.mesh),
            format!(
                "{}, {}",
                counted(model.mesh.nodes.len(), "node"),
                counted(model.mesh.cells.len(), "cell")
            ),
        ),
    ];
    let tables = [(fiber_angles, "fiber"), (plane_angles, "plane")];
    for ((name, kind), table) in tables.iter().zip(model_angles(model)) {
        if let Some(table) = table {
            let rows = table.lines().count() - 1;
            let content = format!("{kind} angles of {}", counted(rows, "cell"));
            files.push((folder.join(name), table, content));
        }
    }
    files
}
