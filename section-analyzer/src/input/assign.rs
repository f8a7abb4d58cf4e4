//! Material and orientation of every cell.

use std::f64::consts::PI;
use std::path::PathBuf;

use shared_geom::document::Document;
use shared_geom::mesh::Mesh;

use super::files::Files;
use super::follow::{Parabola, direction};
use super::groups;
use super::laminae::Faces;
use super::materials::WrittenMaterial;
use super::problem::InputProblem;
use super::regions::{WrittenAngle, WrittenRegion};
use super::source::parabolas;
use super::tables::Tables;
use crate::mesh::SectionMesh;
use crate::section::CellMaterial;

/// Data for the assignment of cells.
#[derive(Debug)]
pub(super) struct Assignment<'a> {
    pub document: &'a Document,
    pub mesh: &'a Mesh,
    /// The same mesh in meters, if it is sound: its cells are in the same order.
    pub section_mesh: Option<&'a SectionMesh>,
    /// Centroids of its cells \[m\]; empty without this mesh.
    pub centroids: &'a [[f64; 2]],
    pub regions: &'a [WrittenRegion],
    /// Region of each cell of the mesh, if it has one.
    pub region_of_cell: &'a [Option<usize>],
    /// The faces of laminates.
    pub faces: &'a Faces,
}

/// An angle of a region, ready to be evaluated for each cell.
enum Angle {
    Constant(f64),
    Table(PathBuf),
    Follow { curve: Vec<Parabola>, turn: f64 },
}

impl Assignment<'_> {
    /// Material and angles of each cell; `None` if a problem was noted.
    ///
    /// The angles are constant in each cell, those that follow a curve are taken
    /// at its centroid.
    pub fn cells(
        &self,
        files: &mut Files<'_>,
        materials: Option<&[usize]>,
    ) -> Option<Vec<CellMaterial>> {
        let mut tables = Tables::read(self.document, files, self.regions);
        let angles: Vec<_> = self
            .regions
            .iter()
            .enumerate()
            .map(|(index, region)| {
                let fiber = self.angle(files, &mut tables, index, region.fiber_angle.as_ref());
                let plane = self.angle(files, &mut tables, index, region.plane_angle.as_ref());
                Some((fiber?, plane?))
            })
            .collect();
        tables.check(self.document);
        let angles: Option<Vec<_>> = angles.into_iter().collect();
        let (angles, materials) = (angles?, materials?);
        let cells = self
            .region_of_cell
            .iter()
            .enumerate()
            .map(|(cell, &region)| {
                let (fiber, plane) = &angles[region?];
                Some(CellMaterial {
                    material: materials[region?],
                    fiber_angle: self.of_cell(fiber, &tables, cell)?,
                    plane_angle: self.of_cell(plane, &tables, cell)?,
                })
            });
        cells.collect()
    }

    /// For each cell of the mesh the label of the curve that its plane angle follows.
    pub fn follows(&self) -> Vec<Option<String>> {
        let of_region = self.regions.iter().map(|region| match &region.plane_angle {
            Some(WrittenAngle::Follow { curve, .. }) => groups::label_of_curve(self.mesh, curve),
            _ => None,
        });
        let of_region: Vec<_> = of_region.collect();
        let regions = self.region_of_cell.iter();
        regions
            .map(|region| of_region.get((*region)?)?.clone())
            .collect()
    }

    fn angle(
        &self,
        files: &Files<'_>,
        tables: &mut Tables,
        region: usize,
        written: Option<&WrittenAngle>,
    ) -> Option<Angle> {
        match written? {
            WrittenAngle::Constant(angle) => Some(Angle::Constant(*angle)),
            WrittenAngle::Table(name) => {
                let path = files.path(name);
                let group = self.regions[region].group.as_ref()?;
                let cells = self.mesh.cells.iter().zip(self.region_of_cell);
                let of_region = cells.filter(|(_, found)| **found == Some(region));
                let tags: Vec<_> = of_region.map(|(cell, _)| cell.tag).collect();
                tables.expect(&path, &group.text, &tags);
                Some(Angle::Table(path))
            }
            WrittenAngle::Follow { curve, .. } if self.faces.is_open(&curve.text) => None,
            WrittenAngle::Follow { curve, reverse } => {
                let group = groups::curve(self.document, self.mesh, curve)?;
                let label = self.mesh.groups[group].label();
                let curve = parabolas(self.section_mesh?, &label)?;
                let turn = if *reverse { PI } else { 0.0 };
                Some(Angle::Follow { curve, turn })
            }
        }
    }

    /// The angle of one cell \[rad\]; `None` if a table or curve does not give one.
    fn of_cell(&self, angle: &Angle, tables: &Tables, cell: usize) -> Option<f64> {
        match angle {
            Angle::Constant(angle) => Some(*angle),
            Angle::Table(path) => tables.angle(self.document, path, self.mesh.cells[cell].tag),
            Angle::Follow { curve, turn } => {
                let centroid = *self.centroids.get(cell)?;
                direction(curve, centroid).map(|angle| angle + turn)
            }
        }
    }
}

/// Index of the material of each region; unknown names are noted, with the nearest.
pub(super) fn materials_of_regions(
    document: &Document,
    regions: &[WrittenRegion],
    materials: &[WrittenMaterial],
) -> Option<Vec<usize>> {
    let of_region = |region: &WrittenRegion| {
        let written = region.material.as_ref()?;
        let found = materials
            .iter()
            .position(|known| known.name == written.text);
        if found.is_none() {
            let group = region
                .group
                .as_ref()
                .map_or("?", |group| group.text.as_str());
            let problem = InputProblem::UnknownMaterial {
                material: written.text.clone(),
                region: group.to_owned(),
                known: materials.iter().map(|known| known.name.clone()).collect(),
            };
            document.note(written.line, &problem);
        }
        found
    };
    // All regions are checked before the first unknown material ends the search.
    let found: Vec<_> = regions.iter().map(of_region).collect();
    found.into_iter().collect()
}
