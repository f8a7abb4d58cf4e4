//! The section file of a model of another tool, and its tables of angles.

use std::fmt::Write;

use shared_geom::mesh_file::{Model, ModelCell, ModelLaw, ModelMaterial, ModelRegion};

/// Keys of the nine constants of an orthotropic material, in their order.
const ORTHOTROPIC: [&str; 9] = [
    "e1", "e2", "e3", "g12", "g13", "g23", "nu12", "nu13", "nu23",
];

/// Names in a section file that is made of a model.
#[derive(Debug, Clone, Copy)]
pub struct ModelNames<'a> {
    /// The file or folder of the model.
    pub model: &'a str,
    /// The mesh.
    pub mesh: &'a str,
    /// Table of fiber angles by cell.
    pub fiber_angles: &'a str,
    /// Table of plane angles by cell.
    pub plane_angles: &'a str,
    /// Units of length and of force in which the numbers of the model are consistent.
    pub units: [&'a str; 2],
}

/// An angle of a region, or of a cell.
type AngleOf<T, A> = fn(&T) -> A;

/// The section file of `model`.
pub fn model_section(model: &Model, names: &ModelNames<'_>) -> String {
    let mut text = String::new();
    // writing to a string cannot fail
    let _ = write_section(&mut text, model, names);
    text
}

/// The tables of fiber angles and of plane angles, `cell,angle` in degrees, of the cells of
/// the regions that need them; `None` for a table that no region needs.
pub fn model_angles(model: &Model) -> [Option<String>; 2] {
    let fiber: (AngleOf<ModelRegion, Option<f64>>, AngleOf<ModelCell, f64>) =
        (|region| region.fiber_angle, |cell| cell.fiber_angle);
    let plane: (AngleOf<ModelRegion, Option<f64>>, AngleOf<ModelCell, f64>) =
        (|region| region.plane_angle, |cell| cell.plane_angle);
    [fiber, plane].map(|(of_region, of_cell)| {
        let needs = |cell: &&ModelCell| {
            let region = model.regions.get(cell.region);
            region.is_some_and(|region| of_region(region).is_none())
        };
        let rows = model.cells.iter().filter(needs);
        let rows: String = rows
            .map(|cell| format!("{},{}\n", cell.tag, of_cell(cell)))
            .collect();
        (!rows.is_empty()).then(|| format!("cell,angle\n{rows}"))
    })
}

fn write_section(text: &mut String, model: &Model, names: &ModelNames<'_>) -> std::fmt::Result {
    writeln!(
        text,
        "# made by section-analyzer convert of {:?}",
        names.model
    )?;
    for note in &model.notes {
        writeln!(text, "# {note}")?;
    }
    let [length, force] = names.units;
    writeln!(
        text,
        "mesh = {:?}\n\n[units]\nlength = {length:?}\nforce = {force:?}\n",
        names.mesh
    )?;
    if let Some(curvature) = model.curvature {
        let curvature = curvature
            .map(|k| format!("\"{k:?} rad/{length}\""))
            .join(", ");
        writeln!(text, "[initial_curvature]\ncurvature = [{curvature}]")?;
    } else if model.slope.is_some() {
        writeln!(text, "[initial_curvature]\ncurvature = [0, 0, 0]")?;
    }
    if let Some(slope) = model.slope {
        writeln!(text, "slope = {slope:?}")?;
    }
    for material in &model.materials {
        write_material(text, material)?;
    }
    for region in &model.regions {
        let material = model.materials.get(region.material);
        let material = material.map_or("", |material| &*material.name);
        writeln!(
            text,
            "\n[[region]]\ngroup = {:?}\nmaterial = {material:?}",
            region.group
        )?;
        let angles = [
            ("fiber_angle", region.fiber_angle, names.fiber_angles),
            ("plane_angle", region.plane_angle, names.plane_angles),
        ];
        for (key, angle, table) in angles {
            match angle {
                Some(angle) => writeln!(text, "{key} = \"{angle:?} deg\"")?,
                None => writeln!(text, "{key} = {{ table = {table:?} }}")?,
            }
        }
    }
    Ok(())
}

fn write_material(text: &mut String, material: &ModelMaterial) -> std::fmt::Result {
    writeln!(text, "\n[material.{}]", material.name)?;
    match &material.law {
        ModelLaw::Isotropic([young, poisson]) => {
            writeln!(text, "young = {young:?}\npoisson = {poisson:?}")?;
        }
        ModelLaw::Orthotropic(constants) => {
            for (key, value) in ORTHOTROPIC.iter().zip(constants) {
                writeln!(text, "{key} = {value:?}")?;
            }
        }
        ModelLaw::Full(rows) => {
            writeln!(text, "stiffness = [")?;
            for row in rows.iter() {
                writeln!(text, "  {row:?},")?;
            }
            writeln!(text, "]")?;
        }
    }
    writeln!(text, "density = {:?}", material.density)
}
