//! Reads and checks blade files, and meshes their sections.
//!
//! [`read`] converts a blade file and its airfoil file, if any, to a [`BladeInput`], with
//! lengths in the declared unit, which becomes the unit of the mesh. It notes all
//! problems before it fails.

use std::path::Path;

use shared_geom::document::{Document, Key, Table, read_text};
use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::file_kind::FileKind;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::units::Dimension;

use crate::mesh::generate::blade::{
    Blade, BladePart, BladeProblem, Contour, Cores, Sizes, Spar, naca,
};

mod airfoil;
mod keys;
mod plies;
mod problem;

pub use problem::BladeFileProblem;

pub(super) use airfoil::parse as airfoil_points;
pub(super) use keys::{BLADE_FILE, Name};

use keys::{
    AFT, AIRFOIL, CELL, CHORD, CORE, CORE_SIZE, END, FILE, FRONT_WEB, IN_SPAR, MESH, NACA, NOSE,
    NOSE_MASS, NOSE_TO, ORIGIN, SIZE, SKIN, SPAR, TRAILING_EDGE, TURN,
};
use plies::{Use, Uses};

/// Kinds of cells, in the order of their words.
const CELLS: [CellKind; 3] = [
    CellKind::Quadrilateral9,
    CellKind::Quadrilateral8,
    CellKind::Quadrilateral4,
];

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
    let text = read_text(path)?;
    if FileKind::of(path, &text) == Some(FileKind::Layup) {
        let location = SourceLocation::file(path.display().to_string());
        return Err(Diagnostics::one(location, &BladeFileProblem::Layup));
    }
    parse(&text, path)
}

/// Reads the text of a blade file, as if it were at `path`.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: &Path) -> Result<BladeInput, Diagnostics> {
    let document = Document::parse(text, &path.display().to_string())?;
    let root = document.root_of(&BLADE_FILE);
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
        let contour = root.nested(&AIRFOIL, |table| self.airfoil(table, &mut lines));
        let skin = root.nested(&SKIN, |table| self.skin(table, &mut lines, &mut uses));
        let spar = root.nested(&SPAR, |table| self.spar(table, &mut lines, &mut uses));
        let cores = root.nested(&CORE, |table| Self::cores(table, &mut uses, spar.as_ref()));
        let nose_mass = root.nested(&NOSE_MASS, |table| {
            Self::nose_mass(table, &mut lines, &mut uses)
        });
        if !root.has(&SKIN) {
            Self::require_fill(root);
        }
        let sizes = root.nested(&MESH, |table| self.sizes(table, &mut lines));
        let [nose, in_spar, aft] = cores?.unwrap_or_default();
        let cores = Cores {
            nose,
            spar: in_spar,
            aft,
            nose_mass: nose_mass?,
        };
        let (skin, is_closed) = skin?.unwrap_or((Vec::new(), true));
        let blade = Blade {
            contour: contour??,
            skin,
            is_closed,
            spar: spar?,
            cores,
            sizes: sizes??,
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
    fn length(&self, table: &Table<'_>, key: &Key<f64>) -> Option<f64> {
        Some(table.get(key)? / self.unit)
    }

    fn airfoil(&self, table: &Table<'_>, lines: &mut Lines) -> Option<Contour> {
        lines.airfoil = table.line();
        let chord = self.length(table, &CHORD);
        let (origin, end) = (table.get(&ORIGIN), table.get(&END));
        let has_edge = table.has(&TRAILING_EDGE);
        let points = match (table.has(&NACA), table.has(&FILE)) {
            (true, false) => {
                lines.airfoil = table.line_of(&NACA);
                let is_sharp = table.get(&TRAILING_EDGE).map(|edge| edge == 1);
                let points = table.get(&NACA).zip(is_sharp);
                let points = points.map(|(digits, is_sharp)| naca(&digits, is_sharp));
                points
                    .and_then(|points| points.map_err(|problem| self.note(&[problem], lines)).ok())
            }
            (false, true) => {
                lines.airfoil = table.line_of(&FILE);
                if has_edge {
                    table.note(&TRAILING_EDGE, &BladeFileProblem::EdgeOfFile);
                }
                self.airfoil_file(table)
            }
            (true, true) => {
                table.note(&FILE, &BladeFileProblem::TwoAirfoils);
                None
            }
            (false, false) => {
                table.note("", &BladeFileProblem::NoAirfoil);
                None
            }
        };
        let contour = Contour::new(&points?, chord?, origin?.0, end?.0);
        contour.map_err(|problems| self.note(&problems, lines)).ok()
    }

    fn airfoil_file(&self, table: &Table<'_>) -> Option<Vec<[f64; 2]>> {
        let path = table.existing(&FILE, &table.get(&FILE)?)?;
        let text = self.document.keep(read_text(&path))?;
        let points = airfoil::parse(&text, &path.display().to_string());
        self.document.keep(points)
    }

    /// The fills; `spar` is `None` if it is wrong.
    fn cores(
        table: &Table<'_>,
        uses: &mut Uses,
        spar: Option<&Option<Spar>>,
    ) -> Option<[Option<String>; 3]> {
        let spar = spar.map(Option::as_ref);
        let has_front = spar.is_none_or(|spar| spar.is_some_and(|spar| spar.front_web.is_some()));
        let has_spar = spar.is_none_or(|spar| spar.is_some());
        let front = "a front web: without one the space in the nose belongs to the spar";
        let fills = [
            (NOSE, has_front, front),
            (IN_SPAR, has_spar, "a spar"),
            (AFT, true, ""),
        ];
        let [nose, in_spar, aft] = fills.map(|(key, is_there, needed)| {
            if table.has(&key) && !is_there {
                let core = key.name();
                table.note(&key, &BladeFileProblem::NoCavity { core, needed });
            }
            table.nested(&key, |core| plies::material_of(core, uses, None))
        });
        Some([nose?, in_spar?, aft?])
    }

    /// Without a skin, notes spaces along the contour that nothing fills.
    fn require_fill(root: &Table<'_>) {
        let fills = root.is_table(&CORE).then(|| root.table(&CORE)).flatten();
        let spar = root.is_table(&SPAR).then(|| root.table(&SPAR)).flatten();
        let has_nose = spar.is_some_and(|spar| spar.has(&FRONT_WEB));
        for (key, is_there) in [(AFT, true), (NOSE, has_nose)] {
            let is_filled = fills.as_ref().is_some_and(|fills| fills.has(&key));
            if is_there && !is_filled {
                root.note("", &BladeFileProblem::NoSkin { core: key.name() });
            }
        }
    }

    fn nose_mass(table: &Table<'_>, lines: &mut Lines, uses: &mut Uses) -> Option<(f64, String)> {
        lines.nose_mass = table.line_of(&NOSE_TO);
        let to = table.get(&NOSE_TO);
        let name = plies::material_of(table, uses, None);
        Some((to?.0, name?))
    }

    fn sizes(&self, table: &Table<'_>, lines: &mut Lines) -> Option<Sizes> {
        lines.mesh = table.line();
        let size = self.length(table, &SIZE);
        let core = table.get(&CORE_SIZE);
        let (turn, kind) = (table.get(&TURN), table.get(&CELL));
        let size = size?;
        Some(Sizes {
            size,
            core: core?.map_or(size, |core| core / self.unit),
            turn: turn?.0,
            kind: CELLS[kind?],
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
