//! Reads layup files, and meshes the sections that they describe.

use std::path::Path;

use shared_geom::document::{Document, Table, read_text};
use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::exchange::{self, Format};
use shared_geom::file_kind::FileKind;
use shared_geom::line::ReferenceLine;
use shared_geom::mesh::Mesh;
use shared_geom::units::Dimension;

use super::materials::{self, MATERIALS};
use crate::mesh::generate::layup::{LayerArea, LayupProblem, LayupSection};

mod angle;
mod constants;
mod course;
mod edge;
mod faded;
mod fills;
mod foot;
mod keys;
mod layers;
mod line;
mod names;
mod outliers;
mod place;
mod prevabs;
mod problem;
mod resolve;
mod shape;
mod slips;
mod span;
mod swapped;
mod taper;
mod unlikely;
mod windio;

pub use constants::table_name;
pub use course::Course;
pub use fills::{FillBound, WrittenFill};
pub use place::{Place, PlaceForm, SIDES};
pub use problem::LayupFileProblem;
pub use shape::Shape;
pub use span::{MissedLayer, Selection, SpanStation};
pub use taper::Taper;

pub(super) use keys::LAYUP_FILE;

use constants::constants;
use keys::{BLADE_NAME, LINE, MESH, PLACES, SHAPE, SIZE, WEBS};
use layers::Known;
use names::wrong_names;
use resolve::Resolver;

/// A layup along the span, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Layup {
    /// Name of the blade, if the file gives it.
    pub name: Option<String>,
    /// The contours.
    pub shape: Shape,
    /// Places on the contour by their names.
    pub places: Vec<(String, Place)>,
    /// The layers of the shell, from the outside in.
    pub layers: Vec<WrittenLayer>,
    /// The webs.
    pub webs: Vec<WrittenWeb>,
    /// Materials that fill the spaces between shell and webs.
    pub fills: Vec<WrittenFill>,
    /// Largest length of cells \[m\].
    pub size: Option<f64>,
    /// The reference line of the blade.
    pub line: Option<ReferenceLine>,
    /// Positions along the span at which the blade is to be solved; empty if they are chosen
    /// [-].
    pub stations: Vec<f64>,
    /// The tables of units and materials as written.
    pub constants: String,
    /// The unit of length of the file \[m\].
    pub unit: f64,
    /// Choices that the reader of a file of another tool made.
    pub remarks: Vec<String>,
    file: String,
    shape_line: usize,
    /// The line of the size of cells, or of the shape without one.
    size_line: usize,
}

/// A layer of the shell, or a ply of a web.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenLayer {
    /// Its name.
    pub name: String,
    /// Name of its material.
    pub material: String,
    /// Its thickness \[m\].
    pub thickness: Course,
    /// Angle of its fiber from x along the span, in the sense of `toward`; in webs toward the suction
    /// side \[rad\].
    pub fiber_angle: Course,
    /// The sense of the angle of the fiber in the shell.
    pub toward: Toward,
    /// Where it starts.
    pub from: Place,
    /// Where it ends.
    pub to: Place,
    /// The drop of its thickness at its ends.
    pub taper: Option<Taper>,
    /// Parts of its thickness over parts of its width; the whole one without them [-].
    pub profile: Vec<[f64; 2]>,
    /// The web along which it continues, and the line of the file.
    pub web: Option<(String, usize)>,
    /// Its line in the file.
    pub line: usize,
}

/// Direction toward which angles of fibers in the shell are positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Toward {
    /// The leading edge, on both sides.
    #[default]
    LeadingEdge,
    /// Along the contour, from the trailing edge over the suction side.
    Contour,
}

/// Words of the directions of positive angles, in their order.
pub const TOWARDS: [&str; 2] = ["leading_edge", "contour"];

/// A web.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenWeb {
    /// Its name.
    pub name: String,
    /// Its places on the suction and the pressure side.
    pub places: [Place; 2],
    /// First and last position along the span [-].
    pub range: [f64; 2],
    /// Its plies, from the leading edge aft.
    pub plies: Vec<WrittenLayer>,
    /// Its line in the file.
    pub line: usize,
}

/// The mesh of a section of a layup.
#[derive(Debug, Clone)]
pub struct LayupMesh {
    /// The position along the span [-].
    pub eta: f64,
    /// The section, lengths \[m\].
    pub section: LayupSection,
    /// The mesh, in the unit of the file.
    pub mesh: Mesh,
    /// Areas of the layers \[m^2\].
    pub areas: Vec<LayerArea>,
}

/// Treatment of materials of other tools' files that no material can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Materials {
    /// They are errors.
    #[default]
    AsGiven,
    /// Poisson's ratios are reduced until they are possible, which is a remark.
    Repaired,
}

/// Reads the layup file, the turbine file of windIO, or the section of PreVABS, at `path`.
///
/// # Errors
/// All problems of the file and of its airfoil files.
pub fn read(path: &Path) -> Result<Layup, Diagnostics> {
    read_with(path, Materials::AsGiven)
}

/// As [`read`], with a treatment of impossible materials of windIO files.
///
/// # Errors
/// As [`read`].
pub fn read_with(path: &Path, materials: Materials) -> Result<Layup, Diagnostics> {
    let text = read_text(path)?;
    if windio::recognize(&text, path) {
        return windio::read(&text, path, materials);
    }
    if prevabs::recognize(&text) {
        return prevabs::read(&text, path, materials);
    }
    if path.extension().is_none_or(|ending| ending != "toml") {
        let format = exchange::recognize(&text).map(Format::title);
        let location = SourceLocation::file(path.display().to_string());
        let problem = LayupFileProblem::Format { format };
        return Err(Diagnostics::one(location, &problem));
    }
    FileKind::Layup.require(path, &text)?;
    parse(&text, path)
}

/// Reads the text of a layup file, as if it were at `path`.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: &Path) -> Result<Layup, Diagnostics> {
    let document = Document::parse(text, &path.display().to_string())?;
    let root = root(&document);
    let known = Known::new(materials::read(&root));
    let mut shape_line = 1;
    let shape = root.nested(&SHAPE, |table| {
        shape_line = table.line();
        Shape::read(&document, table)
    });
    let (layers, webs) = layers_and_webs(&root, &known);
    let fills = edge::fills(&root, &known);
    let places = root.each_by_name(&PLACES, |_, table| Place::of_table(table));
    let mut size_line = None;
    let size = root.nested(&MESH, |table| {
        size_line = table.has(&SIZE).then(|| table.line_of(&SIZE));
        table.get(&SIZE)
    });
    let line = root.nested(&LINE, line::read);
    let stations = span::stations(&root);
    let name = root.get(&BLADE_NAME);
    root.finish();
    let mut has_names = true;
    if let (Some(layers), Some(webs), Some(fills)) = (&layers, &webs, &fills) {
        for (line, problem) in wrong_names(layers, webs, fills) {
            document.note(line, &problem);
            has_names = false;
        }
    }
    let rest = (places.zip(fills), size.zip(line).zip(stations));
    let mut layup = match (shape, layers, webs, rest) {
        (Some(Some(shape)), Some(layers), Some(webs), (Some((places, fills)), Some(rest))) => {
            let ((size, line), stations) = rest;
            Some(Layup {
                name: name.flatten(),
                shape,
                places,
                layers,
                webs,
                fills,
                size: size.flatten(),
                line,
                stations,
                constants: constants(text),
                unit: document.factor(Dimension::LENGTH),
                remarks: Vec::new(),
                file: path.display().to_string(),
                shape_line,
                size_line: size_line.unwrap_or(shape_line),
            })
        }
        _ => None,
    };
    if let Some(layup) = &mut layup {
        check(layup, &document, has_names);
    }
    document.finish(layup)
}

/// Notes the problems of a layup as a whole, and adds its remarks; places only if the names are right.
fn check(layup: &mut Layup, document: &Document, has_names: bool) {
    let mut problems: Vec<problem::Located> = layup.divide_lengths().err().into_iter().collect();
    problems.extend(layup.coarse());
    if has_names {
        layup.remarks = layup.idle_places();
        layup.remarks.extend(layup.slips());
        layup.remarks.extend(layup.odd_shape());
        problems.extend(layup.wrong_ends());
    }
    for (line, problem) in &problems {
        document.note(*line, problem);
    }
}

/// The layers of the shell, then the layers of the feet of webs, which are inside of them, and the webs.
fn layers_and_webs(
    root: &Table<'_>,
    known: &Known,
) -> (Option<Vec<WrittenLayer>>, Option<Vec<WrittenWeb>>) {
    let layers = known.shell(root);
    let webs = root.each(&WEBS, |table| foot::web(known, table));
    let webs = webs.map(|webs| webs.into_iter().unzip());
    let (webs, feet): (_, Option<Vec<Vec<WrittenLayer>>>) = webs.unzip();
    let layers = layers.zip(feet).map(|(mut layers, feet)| {
        layers.extend(feet);
        layers.concat()
    });
    (layers, webs)
}

/// The outermost table of a layup file, with its units.
fn root(document: &Document) -> Table<'_> {
    let root = document.root_of(&LAYUP_FILE);
    document.declare_units(&root);
    let _ = root.require_item(&MATERIALS, &MATERIALS.schema.expected());
    root
}

impl Layup {
    /// The section at a position along the span, 0 at the root to 1 at the tip; lengths in
    /// meters.
    ///
    /// # Errors
    /// All places that do not exist there, or a contour that does not.
    pub fn section(&self, eta: f64) -> Result<LayupSection, Diagnostics> {
        let resolver = Resolver::new(self, eta);
        let resolver = resolver.map_err(|(line, problem)| self.problem(line, &problem))?;
        resolver.section().map_err(|problems| {
            let mut all = Diagnostics::new();
            let one = |(line, problem)| all.append(self.problem(line, &problem));
            problems.into_iter().for_each(one);
            all
        })
    }

    /// The mesh of the section at a position along the span.
    ///
    /// # Errors
    /// As [`Layup::section`], and a section that cannot be meshed, with the line of its layer.
    pub fn mesh(&self, eta: f64) -> Result<LayupMesh, Diagnostics> {
        let mut section = self.section(eta)?;
        let mut made = section.generate();
        if made.as_ref().is_err_and(edge::has_no_room) {
            // the layers of both sides leave no space for the adhesive at the trailing edge
            section.fills.retain(|fill| fill.name != edge::NAME);
            made = section.generate();
        }
        let made = made.map_err(|problem| {
            let line = self.line_of(&problem);
            self.problem(line, &LayupFileProblem::Section { eta, problem })
        })?;
        let mut mesh = made.mesh;
        for node in &mut mesh.nodes {
            node.position /= self.unit;
        }
        Ok(LayupMesh {
            eta,
            section,
            mesh,
            areas: made.areas,
        })
    }

    /// Positions along the span at which a quantity of the file has a value; 0 if all are
    /// constant.
    pub fn positions(&self) -> Vec<f64> {
        let mut all = self.shape.positions();
        let plies = self.webs.iter().flat_map(|web| &web.plies);
        for layer in self.layers.iter().chain(plies) {
            all.extend(layer.thickness.positions());
            all.extend(layer.fiber_angle.positions());
            all.extend(layer.from.positions());
            all.extend(layer.to.positions());
        }
        all.extend(self.places.iter().flat_map(|place| place.1.positions()));
        let of_fills = self.fills.iter().flat_map(WrittenFill::places);
        all.extend(of_fills.flat_map(Place::positions));
        if all.is_empty() {
            all.push(0.0);
        }
        all.sort_by(f64::total_cmp);
        all.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        all
    }

    /// The layer or ply of this name.
    pub fn layer(&self, name: &str) -> Option<&WrittenLayer> {
        let plies = self.webs.iter().flat_map(|web| &web.plies);
        self.layers
            .iter()
            .chain(plies)
            .find(|layer| layer.name == name)
    }

    /// Whether layers continue along a web.
    fn is_of_spar(&self, web: &WrittenWeb) -> bool {
        let mut webs = self.layers.iter().filter_map(|layer| layer.web.as_ref());
        webs.any(|(name, _)| *name == web.name)
    }

    /// The material of the layer, ply or fill of this name.
    pub fn material_of(&self, name: &str) -> Option<&str> {
        let layer = self.layer(name).map(|layer| layer.material.as_str());
        let fill = || Some(self.fill(name)?.material.as_str());
        layer.or_else(fill)
    }

    /// The fill of this name.
    pub fn fill(&self, name: &str) -> Option<&WrittenFill> {
        self.fills.iter().find(|fill| fill.name == name)
    }

    /// Makes positions along the span that are lengths parts of the length of the line.
    fn divide_lengths(&mut self) -> Result<(), problem::Located> {
        let length = self.line.as_ref().map(ReferenceLine::length);
        let mut courses = self.shape.courses_mut();
        let mut plies: Vec<&mut WrittenLayer> = self.layers.iter_mut().collect();
        let mut places: Vec<&mut Place> =
            self.places.iter_mut().map(|place| &mut place.1).collect();
        for web in &mut self.webs {
            plies.extend(&mut web.plies);
            places.extend(&mut web.places);
        }
        places.extend(self.fills.iter_mut().flat_map(WrittenFill::places_mut));
        for layer in plies {
            courses.extend([&mut layer.thickness, &mut layer.fiber_angle]);
            places.extend([&mut layer.from, &mut layer.to]);
        }
        courses.extend(places.into_iter().flat_map(Place::courses_mut));
        for course in courses {
            let Some(line) = course.lengths() else {
                continue;
            };
            let length = length.ok_or((line, LayupFileProblem::NoLine))?;
            let found = course.points().last().map_or(0.0, |(at, _)| at);
            if found > length * (1.0 + 1e-9) {
                return Err((line, LayupFileProblem::Beyond { found, length }));
            }
            course.divide_lengths(length);
        }
        Ok(())
    }

    fn line_of(&self, problem: &LayupProblem) -> usize {
        if let LayupProblem::Size { .. } | LayupProblem::TooManyCells { .. } = problem {
            return self.size_line;
        }
        let name = problem.about().unwrap_or_default();
        let web = || {
            self.webs
                .iter()
                .find(|web| web.name == name)
                .map(|web| web.line)
        };
        let fill = || self.fill(name).map(|fill| fill.line);
        let line = self.layer(name).map(|layer| layer.line);
        line.or_else(web).or_else(fill).unwrap_or(self.shape_line)
    }

    fn problem(&self, line: usize, problem: &LayupFileProblem) -> Diagnostics {
        Diagnostics::one(SourceLocation::line(&self.file, line), problem)
    }
}
