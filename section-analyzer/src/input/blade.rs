//! Reads and checks blade files, and meshes their sections.
//!
//! [`read`] converts a blade file and its airfoil file, if any, to a [`BladeInput`], with
//! lengths in the declared unit, which becomes the unit of the mesh. It notes all
//! problems before it fails.

use std::path::Path;

use shared_geom::document::{Document, Table, read_text};
use shared_geom::error::Diagnostics;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::units::Dimension;

use crate::mesh::generate::blade::{
    Blade, BladePart, BladeProblem, Contour, Cores, Sizes, Spar, naca,
};

mod airfoil;
mod plies;
mod problem;

pub use problem::BladeFileProblem;

use plies::{Use, Uses};

/// Kinds of cells by name.
const CELLS: [(&str, CellKind); 3] = [
    ("quad9", CellKind::Quadrilateral9),
    ("quad8", CellKind::Quadrilateral8),
    ("quad4", CellKind::Quadrilateral4),
];
/// Largest turn of the surface along one cell \[deg\].
const TURNS: [f64; 2] = [0.5, 45.0];

/// The meshed section of a blade, and the materials of its parts.
#[derive(Debug, Clone)]
pub struct BladeInput {
    /// The mesh, in the unit of length of the file.
    pub mesh: Mesh,
    /// The physical surfaces that make up the section, in the order of the file.
    pub regions: Vec<BladeRegion>,
    /// The units that the file declares: keys and names; empty for SI.
    pub units: Vec<(String, String)>,
}

/// A physical surface of a blade, with its material and angles.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeRegion {
    /// The physical surface.
    pub group: String,
    /// Name of its material.
    pub material: String,
    /// Angle of the fiber from x toward the wall \[deg\].
    pub fiber_angle: f64,
    /// The curve that the wall follows; `None` in cores.
    pub follow: Option<&'static str>,
}

/// Reads the blade file at `path` and meshes the section.
///
/// # Errors
/// All problems of the file, of its airfoil file, and of their combination.
pub fn read(path: &Path) -> Result<BladeInput, Diagnostics> {
    parse(&read_text(path)?, path)
}

/// Reads the text of a blade file, as if it were at `path`.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: &Path) -> Result<BladeInput, Diagnostics> {
    let document = Document::parse(text, &path.display().to_string())?;
    let root = document.root();
    document.declare_units(&root);
    let reading = Reading {
        document: &document,
        unit: document.factor(Dimension::LENGTH),
    };
    let written = reading.blade(&root);
    root.finish();
    let units = units(&root);
    let input = written.and_then(|(blade, lines, regions)| {
        // the problems so far may be the reason why it cannot be meshed
        let mesh = reading.meshed(&blade, &lines)?;
        Some(BladeInput {
            mesh,
            regions,
            units,
        })
    });
    document.finish(input)
}

/// The units as declared.
fn units(root: &Table<'_>) -> Vec<(String, String)> {
    let table = root.is_table("units").then(|| root.table("units"));
    let Some(table) = table.flatten() else {
        return Vec::new();
    };
    let unit = |key: String| {
        let text = table.is_text(&key).then(|| table.text(&key))?;
        Some((key, text?))
    };
    table.keys().into_iter().filter_map(unit).collect()
}

/// Lines of the parts of a blade, for messages.
#[derive(Debug, Default)]
struct Lines {
    airfoil: usize,
    skin: usize,
    spar: usize,
    front_web: usize,
    rear_web: usize,
    /// Outermost first.
    plies: Vec<usize>,
    nose_mass: usize,
    mesh: usize,
}

impl Lines {
    fn of(&self, part: BladePart) -> usize {
        match part {
            BladePart::Airfoil => self.airfoil,
            BladePart::Skin => self.skin,
            BladePart::Spar => self.spar,
            BladePart::FrontWeb => self.front_web,
            BladePart::RearWeb => self.rear_web,
            BladePart::Ply(number) => self.plies.get(number).copied().unwrap_or(self.spar),
            BladePart::NoseMass => self.nose_mass,
            BladePart::Mesh => self.mesh,
        }
    }
}

struct Reading<'a> {
    document: &'a Document,
    /// Length of the file's unit \[m\].
    unit: f64,
}

impl Reading<'_> {
    /// Reads all parts before the first missing one ends the reading.
    fn blade(&self, root: &Table<'_>) -> Option<(Blade, Lines, Vec<BladeRegion>)> {
        let mut lines = Lines::default();
        let mut uses = Uses::default();
        let contour = self.airfoil(root, &mut lines);
        let skin = self.skin(root, &mut lines, &mut uses);
        let spar = match root.has("spar") {
            true => self.spar(root, &mut lines, &mut uses).map(Some),
            false => Some(None),
        };
        let cores = self.cores(root, &mut lines, &mut uses, spar.as_ref());
        let sizes = self.sizes(root, &mut lines);
        let (skin, is_closed) = skin?;
        let blade = Blade {
            contour: contour?,
            skin,
            is_closed,
            spar: spar?,
            cores: cores?,
            sizes: sizes?,
        };
        Some((blade, lines, uses.regions()))
    }

    fn meshed(&self, blade: &Blade, lines: &Lines) -> Option<Mesh> {
        match blade.generate() {
            Ok(mesh) => Some(mesh),
            Err(problems) => {
                self.note(&problems, lines);
                None
            }
        }
    }

    fn note(&self, problems: &[BladeProblem], lines: &Lines) {
        for problem in problems {
            self.document.note(lines.of(problem.about()), problem);
        }
    }

    /// A length in the unit of the file.
    fn length(&self, table: &Table<'_>, key: &str) -> Option<f64> {
        let length = table.require_positive(key, Dimension::LENGTH)?;
        Some(length / self.unit)
    }

    /// A part of the chord from 0 to 1.
    fn part(&self, table: &Table<'_>, key: &str) -> Option<f64> {
        let part = table.quantity(key, Dimension::NUMBER)?;
        if (0.0..=1.0).contains(&part) {
            return Some(part);
        }
        table.wrong(
            key,
            "a part of the chord, 0 at the nose to 1 at the trailing edge",
        );
        None
    }

    /// As [`Self::part`], with a default; `None` if it is wrong.
    fn part_or(&self, table: &Table<'_>, key: &str, default: f64) -> Option<f64> {
        match table.has(key) {
            true => self.part(table, key),
            false => Some(default),
        }
    }

    fn airfoil(&self, root: &Table<'_>, lines: &mut Lines) -> Option<Contour> {
        let table = root.require_table("airfoil", "a table [airfoil]")?;
        lines.airfoil = table.line();
        let chord = self.length(&table, "chord");
        let origin = self.part_or(&table, "origin", 0.25);
        let end = self.part_or(&table, "end", 1.0);
        let edge = match table.has("trailing_edge") {
            true => table.word("trailing_edge", &["blunt", "sharp"]),
            false => Some(0),
        };
        let (has_naca, has_file) = (table.has("naca"), table.has("file"));
        let points = match (has_naca, has_file) {
            (true, false) => {
                lines.airfoil = table.line_of("naca");
                let digits = table.text("naca");
                let points = digits.map(|digits| naca(&digits, edge == Some(1)));
                points
                    .and_then(|points| points.map_err(|problem| self.note(&[problem], lines)).ok())
            }
            (false, true) => {
                lines.airfoil = table.line_of("file");
                if table.has("trailing_edge") {
                    table.note("trailing_edge", &BladeFileProblem::EdgeOfFile);
                }
                self.airfoil_file(&table)
            }
            (true, true) => {
                table.note("file", &BladeFileProblem::TwoAirfoils);
                None
            }
            (false, false) => {
                table.note("", &BladeFileProblem::NoAirfoil);
                None
            }
        };
        table.finish();
        let (points, chord, origin, end) = (points?, chord?, origin?, end?);
        edge?;
        let contour = Contour::new(&points, chord, origin, end);
        contour.map_err(|problems| self.note(&problems, lines)).ok()
    }

    fn airfoil_file(&self, table: &Table<'_>) -> Option<Vec<[f64; 2]>> {
        let written = table.text("file")?;
        let path = table.existing("file", &written)?;
        let text = self.document.keep(read_text(&path))?;
        let points = airfoil::parse(&text, &path.display().to_string());
        self.document.keep(points)
    }

    fn cores(
        &self,
        root: &Table<'_>,
        lines: &mut Lines,
        uses: &mut Uses,
        spar: Option<&Option<Spar>>,
    ) -> Option<Cores> {
        let mut cores = Cores::default();
        let mut is_good = true;
        let table = root.has("core").then(|| root.table("core"));
        if let Some(table) = table {
            let table = table?;
            let has_front = spar.is_some_and(|spar| {
                let front = spar.as_ref().and_then(|spar| spar.front_web);
                front.is_some()
            });
            let has_spar = spar.is_some_and(Option::is_some);
            let needs = [
                (
                    "nose",
                    has_front,
                    "a front web: without one the space in the nose belongs to the spar",
                ),
                ("spar", has_spar, "a spar"),
                ("aft", true, ""),
            ];
            for (key, is_there, needed) in needs {
                if !table.has(key) {
                    continue;
                }
                if !is_there && spar.is_some() {
                    table.note(key, &BladeFileProblem::NoCavity { core: key, needed });
                }
                let core = table.table(key);
                let name = core.and_then(|core| {
                    let name = plies::material_of(&core, uses, None);
                    core.finish();
                    name
                });
                is_good &= name.is_some();
                match key {
                    "nose" => cores.nose = name,
                    "spar" => cores.spar = name,
                    _ => cores.aft = name,
                }
            }
            table.finish();
        }
        if root.has("nose_mass") {
            cores.nose_mass = Some(self.nose_mass(root, lines, uses)?);
        }
        is_good.then_some(cores)
    }

    fn nose_mass(
        &self,
        root: &Table<'_>,
        lines: &mut Lines,
        uses: &mut Uses,
    ) -> Option<(f64, String)> {
        let table = root.table("nose_mass")?;
        lines.nose_mass = table.line_of("to");
        let _ = table.require_item("to", "the part of the chord at which it ends");
        let to = match table.has("to") {
            true => self.part(&table, "to"),
            false => None,
        };
        let name = plies::material_of(&table, uses, None);
        table.finish();
        Some((to?, name?))
    }

    fn sizes(&self, root: &Table<'_>, lines: &mut Lines) -> Option<Sizes> {
        let table = root.require_table("mesh", "a table [mesh] with the \"size\" of cells")?;
        lines.mesh = table.line();
        let size = self.length(&table, "size");
        let core = match table.has("core_size") {
            true => self.length(&table, "core_size"),
            false => size,
        };
        let turn = match table.has("turn") {
            true => table.quantity("turn", Dimension::ANGLE),
            false => Some(Sizes::new(1.0).turn),
        };
        let turn = turn.filter(|turn| {
            let degrees = turn.to_degrees();
            let is_good = (TURNS[0]..=TURNS[1]).contains(&degrees);
            if !is_good {
                let [least, most] = TURNS;
                table.wrong("turn", &format!("an angle from {least} to {most} degrees"));
            }
            is_good
        });
        let kind = match table.has("cell") {
            true => table.word("cell", &CELLS.map(|(name, _)| name)),
            false => Some(0),
        };
        table.finish();
        Some(Sizes {
            size: size?,
            core: core?,
            turn: turn?,
            kind: CELLS[kind?].1,
        })
    }
}

impl From<Use> for BladeRegion {
    fn from(one: Use) -> Self {
        Self {
            group: one.name,
            material: one.material,
            fiber_angle: one.fiber_angle.to_degrees(),
            follow: one.follow,
        }
    }
}
