//! Reads and checks section files.
//!
//! [`read`] converts a section file, its mesh and its tables to a checked [`Section`] in
//! SI units. It notes all problems before it fails, each with file, line and remedy.
//!
//! An angle that follows a curve is the direction of the curve (the direction of its
//! lines, from the first node to the second) at the point nearest to the cell's centroid;
//! on lines with three nodes it is the tangent at this point. Like every angle it is
//! constant in a cell.

use std::path::Path;

use shared_geom::document::{Document, Table, read_text};
use shared_geom::error::Diagnostics;
use shared_geom::file_kind::FileKind;
use shared_geom::files::name_without;
use shared_geom::mesh::CellKind;
use shared_geom::section::StrainMeasure;
use shared_geom::units::Dimension;

use crate::material::{Material, MaterialLimits};
use crate::mesh::quality::MeshQuality;
use crate::mesh::{DoubledNodes, Laminated, SectionMesh};
use crate::properties::{AreaMoments, AreaTable, NoPrestress};
use crate::recovery::LoadCase;
use crate::section::{CellMaterial, DistributedLoad, ImposedStrain, Section};

mod assign;
pub mod blade;
pub mod case_durations;
mod cell_table;
mod column_table;
mod curvature;
mod distributed;
mod electric;
mod electrodes;
mod extent;
pub mod external;
mod files;
mod follow;
mod groups;
mod imposed;
mod laminae;
pub mod layup;
mod loads;
mod material_warnings;
mod materials;
mod meshed;
pub mod model;
mod names;
mod plausible;
mod problem;
mod regions;
mod requests;
pub mod result_tables;
pub mod schema;
mod source;
pub mod span_loads;
mod stiffness;
mod strengths;
mod summary;
mod tables;
mod warping;

pub use column_table::ColumnProblem;
pub use distributed::DistributedProblem;
pub use electric::{ElectricDataProblem, ElectricWarning};
pub use electrodes::{ElectrodeProblem, circuit_word};
pub use external::MatrixProblem;
pub use imposed::ImposedProblem;
pub use loads::{LoadProblem, checked_load};
pub use names::is_load_name;
pub use plausible::UnlikelyInput;
pub use problem::InputProblem;
pub use source::{NodeProblem, Source};
pub use stiffness::StiffnessProblem;
pub use summary::{AngleSource, InputSummary, InputWarning, RegionSummary};
pub use warping::read_warping;

use assign::{Assignment, materials_of_regions};
use curvature::WrittenCurvature;
use distributed::{Lookup, WrittenDistribution};
use electrodes::WrittenElectrodes;
use files::Files;
use imposed::WrittenStates;
use laminae::WrittenLamina;
use material_warnings::{idle_angles, warnings_of};
use materials::WrittenMaterial;
use meshed::Meshed;
use regions::{Written, WrittenAngle, WrittenRegion};
use requests::{END_EFFECTS, PRESTRESS};

/// A section ready for analysis, and its origin.
#[derive(Debug, Clone)]
pub struct Input {
    /// The section, checked and in SI units.
    pub section: Section,
    /// Strengths of its materials, parallel to them.
    pub limits: Vec<MaterialLimits>,
    /// The imposed states of its file: temperatures, then initial strains.
    pub imposed: Vec<ImposedStrain>,
    /// The load cases to recover stresses for.
    pub loads: Vec<LoadCase>,
    /// The distributed loads of these load cases, parallel to them.
    pub distributed: Vec<DistributedLoad>,
    /// Descriptions of the distributed loads.
    pub distributed_words: Vec<Vec<String>>,
    /// Number of end effects to find.
    pub end_effects: Option<usize>,
    /// The measure of strain for the effect of prestress, if requested.
    pub prestress: Option<StrainMeasure>,
    /// Summary of the input.
    pub summary: InputSummary,
    /// Data from which its nodes and plane angles are made.
    pub source: Source,
}

/// The ending of the name of a section file.
const ENDING: &str = ".section.toml";

/// Reads and checks the section file at `path`, its mesh and its tables.
///
/// # Errors
/// All problems of these files, with file and line.
pub fn read(path: &Path) -> Result<Input, Diagnostics> {
    let text = read_text(path)?;
    FileKind::Section.require(path, &text)?;
    parse(&text, path)
}

/// Reads and checks the text of a section file, as if it were at `path`: the paths of its
/// mesh and tables are relative to it.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: &Path) -> Result<Input, Diagnostics> {
    let document = Document::parse(text, &path.display().to_string())?;
    let written = WrittenSection::read(&document);
    let mut files = Files::new(&document, text);
    let input = written.checked(&document, &mut files);
    document.finish(input)
}

/// The name of `path` without its ending: `blade` for `blade.section.toml`.
pub fn name_of(path: &Path) -> String {
    name_without(path, ENDING)
}

/// The file as written.
#[derive(Debug)]
struct WrittenSection {
    name: String,
    mesh: Option<Written>,
    length_unit: String,
    doubled_nodes: DoubledNodes,
    materials: Vec<WrittenMaterial>,
    regions: Vec<WrittenRegion>,
    states: WrittenStates,
    laminae: Vec<WrittenLamina>,
    electrodes: WrittenElectrodes,
    curvature: Option<WrittenCurvature>,
    loads: Vec<(Option<LoadCase>, WrittenDistribution)>,
    end_effects: Option<usize>,
    prestress: Option<StrainMeasure>,
    /// Line of the key.
    prestress_line: usize,
}

impl WrittenSection {
    fn read(document: &Document) -> Self {
        let root = document.root_of(&schema::SECTION_FILE);
        document.declare_units(&root);
        let name = name(&root).unwrap_or_else(|| name_of(Path::new(document.file())));
        let mesh = root.get(&schema::MESH);
        let states = imposed::read(&root);
        let electrodes = electrodes::read(&root);
        let prestress = root.get(&PRESTRESS);
        let written = Self {
            name,
            mesh,
            length_unit: length_unit(&root),
            // An unknown word has been reported; then slits are assumed to be intended.
            doubled_nodes: match root.get(&schema::DOUBLED_NODES) {
                Some(0) => DoubledNodes::Error,
                _ => DoubledNodes::Allow,
            },
            materials: materials::read(&root),
            regions: regions::read(&root),
            laminae: laminae::read(&root),
            curvature: curvature::read(&root),
            loads: loads::read(&root, &states, &electrodes),
            electrodes,
            states,
            end_effects: root.get(&END_EFFECTS).flatten(),
            prestress: prestress.flatten().map(|word| StrainMeasure::ALL[word]),
            prestress_line: root.line_of(&PRESTRESS),
        };
        root.finish();
        written
    }

    /// Compares the parts with each other and with the mesh; `None` if a noted problem
    /// prevents a section.
    fn checked(&self, document: &Document, files: &mut Files<'_>) -> Option<Input> {
        let regions = [&self.regions[..], &laminae::regions(&self.laminae)].concat();
        let of_region = materials_of_regions(document, &regions, &self.materials);
        let (states, laminae) = (&self.states, &self.laminae);
        let strains = states.strains_of_regions(document, &regions, laminae);
        let meshed = self.meshed(document, files)?;
        let section_mesh = meshed.checked.as_ref().map(|(mesh, _)| mesh);
        let mut odd = Vec::new();
        let beam = self.curvature.as_ref().zip(section_mesh);
        let beam = beam.and_then(|(line, mesh)| curvature::checked(line, mesh, document, &mut odd));
        let (cells, follows) = self.assigned(document, files, &meshed, of_region.as_deref());
        let loads = self.loads(document, &meshed);
        let electrodes = self.electrodes.on_mesh(self.lookup(document, &meshed));
        let rises = states.rises(document, files, &meshed.rows());
        let (materials, of_region, (loads, distributed)) = (self.laws()?, of_region?, loads?);
        let (section_mesh, mut report) = meshed.checked?;
        let (mut cells, made) = (cells?, meshed.added.cells?);
        let laminated = made.laminated;
        let of_plies = &of_region[self.regions.len()..];
        cells.extend(laminae::cells(laminae, &laminated, of_plies)?);
        report.unused_nodes = report.unused_nodes.saturating_sub(laminated.bare_nodes);
        let region_of_cell = self.region_of_cell(meshed.region_of_cell, &laminated)?;
        let mut section = Section {
            name: self.name.clone(),
            mesh: section_mesh,
            materials,
            cells,
            initial_curvature: beam?,
            electrodes: Vec::new(),
        };
        self.note_prestress(document, &section);
        stiffness::check(document, self.line_of_mesh(), &section);
        let electrodes = self.with_electrodes(document, &mut section, electrodes);
        let of_regions = (strains?, &region_of_cell[..]);
        let imposed = states.states(document, &section, rises?, of_regions);
        let (lookup, loose) = electrodes?;
        let mut summary = self.summary(document, &section, &regions, &of_region, &region_of_cell);
        summary.electrodes = lookup;
        let of_mesh = InputWarning::of_mesh(&report);
        summary.warnings.extend([odd, of_mesh, loose].concat());
        summary.rate(&section);
        summary.input_hash = files.hash();
        Some(Input {
            section,
            limits: self.materials.iter().map(|known| known.limits).collect(),
            imposed,
            loads,
            distributed,
            distributed_words: self.loads.iter().map(|(_, load)| load.words()).collect(),
            end_effects: self.end_effects,
            prestress: self.prestress,
            summary,
            source: Source::new(
                document,
                meshed.bare.unwrap_or(meshed.mesh),
                (made.found, laminae::names_of(laminae)),
                follows,
            ),
        })
    }

    /// Adds the electrodes to the section; returns their locations as text, and warnings.
    fn with_electrodes(
        &self,
        document: &Document,
        section: &mut Section,
        found: Option<Vec<electrodes::Found>>,
    ) -> Option<(Vec<String>, Vec<InputWarning>)> {
        let electrodes = &self.electrodes;
        let (placed, odd) = electrodes.checked(document, section, &found?, &self.materials)?;
        let placed = placed.into_iter().map(|one| (one.electrode, one.location));
        let (electrodes, lookup) = placed.unzip();
        section.electrodes = electrodes;
        Some((lookup, odd))
    }

    /// The materials and angles of the cells of the mesh file, and the curves that their
    /// plane angles follow.
    fn assigned(
        &self,
        document: &Document,
        files: &mut Files<'_>,
        meshed: &Meshed,
        of_region: Option<&[usize]>,
    ) -> (Option<Vec<CellMaterial>>, Vec<Option<String>>) {
        let section_mesh = meshed.checked.as_ref().map(|(mesh, _)| mesh);
        let centroids = section_mesh.map_or_else(Vec::new, centroids);
        let assignment = Assignment {
            document,
            mesh: &meshed.mesh,
            section_mesh,
            centroids: &centroids,
            regions: &self.regions,
            region_of_cell: &meshed.region_of_cell,
            faces: &meshed.added.faces,
        };
        let cells = assignment.cells(files, of_region);
        (cells, assignment.follows())
    }

    /// The region of each cell, the cells of laminates last.
    fn region_of_cell(
        &self,
        of_mesh: Vec<Option<usize>>,
        laminated: &Laminated,
    ) -> Option<Vec<usize>> {
        let mut regions = of_mesh.into_iter().collect::<Option<Vec<_>>>()?;
        let of_laminae = laminae::region_of_cells(&self.laminae, laminated).into_iter();
        regions.extend(of_laminae.map(|region| self.regions.len() + region));
        Some(regions)
    }

    /// Notes prestress that is requested but not known.
    fn note_prestress(&self, document: &Document, section: &Section) {
        let straight = NoPrestress::require_straight(&section.initial_curvature);
        if let (Some(_), Err(reason)) = (self.prestress, straight) {
            document.note(self.prestress_line, &InputProblem::Prestress { reason });
        }
    }

    /// The materials, if all of them could be read.
    fn laws(&self) -> Option<Vec<Material>> {
        let materials = self.materials.iter();
        materials.map(|known| known.material.clone()).collect()
    }

    /// Data in which names are looked up.
    fn lookup<'a>(&'a self, document: &'a Document, meshed: &'a Meshed) -> Lookup<'a> {
        Lookup {
            document,
            mesh: &meshed.mesh,
            section_mesh: meshed.checked.as_ref().map(|(mesh, _)| mesh),
            laminae: &self.laminae,
            faces: &meshed.added.faces,
        }
    }

    fn line_of_mesh(&self) -> usize {
        self.mesh.as_ref().map_or(1, |mesh| mesh.line)
    }

    /// The load cases, and the distributed loads of each; `None` if one of them has a
    /// problem.
    fn loads(
        &self,
        document: &Document,
        meshed: &Meshed,
    ) -> Option<(Vec<LoadCase>, Vec<DistributedLoad>)> {
        let lookup = self.lookup(document, meshed);
        let loads = self.loads.iter();
        let loads = loads.map(|(_, load)| load.on_mesh(lookup));
        // all loads are checked before the first wrong one ends the search
        let distributed: Vec<_> = loads.collect();
        let distributed: Option<Vec<_>> = distributed.into_iter().collect();
        let loads = self.loads.iter().map(|(load, _)| load.clone());
        Some((loads.collect::<Option<_>>()?, distributed?))
    }

    /// Summary of the input; regions, including plies, have the materials `of_region`.
    fn summary(
        &self,
        document: &Document,
        section: &Section,
        regions: &[WrittenRegion],
        of_region: &[usize],
        region_of_cell: &[usize],
    ) -> InputSummary {
        let summaries = regions
            .iter()
            .zip(of_region)
            .map(|(region, &material)| RegionSummary {
                group: text_of(&region.group),
                material: self.materials[material].name.clone(),
                fiber_angle: source_of(&region.fiber_angle),
                plane_angle: source_of(&region.plane_angle),
            });
        let summaries: Vec<_> = summaries.collect();
        let mut warnings = warnings_of(&self.materials, of_region, &self.electrodes);
        // Initial strains have the axes of the material.
        if self.states.names("initial_strain").is_empty() {
            warnings.extend(idle_angles(&summaries, &self.materials, of_region));
        }
        let cells = &section.mesh.cells;
        let count = |kind: CellKind| cells.iter().filter(|cell| cell.kind == kind).count();
        let kinds = CellKind::ALL.map(|kind| (kind, count(kind)));
        let names = regions.iter().map(|region| text_of(&region.group));
        let names: Vec<_> = names.collect();
        InputSummary {
            file: document.file().to_owned(),
            mesh_file: text_of(&self.mesh),
            input_hash: String::new(),
            length_unit: self.length_unit.clone(),
            length_factor: document.factor(Dimension::LENGTH),
            kinds: kinds.into_iter().filter(|(_, count)| *count > 0).collect(),
            areas: AreaTable::by_region(section, &names, region_of_cell),
            warnings,
            regions: summaries,
            electrodes: Vec::new(),
            quality: MeshQuality::default(),
        }
    }
}

fn centroids(mesh: &SectionMesh) -> Vec<[f64; 2]> {
    let centroid = |cell| AreaMoments::of_cell(mesh, cell, [0.0; 2]).centroid();
    mesh.cells.iter().map(centroid).collect()
}

/// The name of the section, which appears in lines of reports.
fn name(root: &Table<'_>) -> Option<String> {
    let is_right = |name: &Option<Written>| name.as_ref().is_none_or(Written::is_line);
    let expected = "a text of one line, without control characters";
    let name = root.get_if(&schema::NAME, is_right, expected)?;
    name.map(|name| name.text)
}

/// The name of the declared unit of length.
fn length_unit(root: &Table<'_>) -> String {
    let has_table = root.is_table(&schema::UNITS_KEY);
    let units = has_table.then(|| root.table(&schema::UNITS_KEY)).flatten();
    // A value that is not a text was reported when the units were read.
    let declared = units.filter(|units| units.is_text("length"));
    declared
        .and_then(|units| units.text("length"))
        .unwrap_or_else(|| "m".to_owned())
}

fn text_of(written: &Option<Written>) -> String {
    written
        .as_ref()
        .map_or_else(String::new, |written| written.text.clone())
}

fn source_of(angle: &Option<WrittenAngle>) -> AngleSource {
    match angle {
        None => AngleSource::Constant(0.0),
        Some(WrittenAngle::Constant(angle)) => AngleSource::Constant(*angle),
        Some(WrittenAngle::Table(written)) => AngleSource::Table(written.text.clone()),
        Some(WrittenAngle::Follow { curve, reverse }) => AngleSource::Curve {
            name: curve.text.clone(),
            reverse: *reverse,
        },
    }
}
