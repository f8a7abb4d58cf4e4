//! Convergence of the active-twist section over its three meshes: prints the stiffness of
//! each, and plots its difference from a mesh twice as fine as the finest.
//!
//! ```sh
//! cargo run --release --example active_twist_section
//! ```

use std::error::Error;
use std::path::{Path, PathBuf};

use nalgebra::Matrix6;
use section_analyzer::analysis::analyze;
use section_analyzer::input::{self, blade};
use shared_geom::figure::{Anchor, BLACK, Color, Drawing, Figure, Label, TEXT, WIDTH, category};
use shared_geom::files::{make_folder, write_figure, write_text};
use shared_geom::gmsh;

/// The meshes, coarsest first.
const MESHES: [&str; 3] = ["coarse", "medium", "active_twist_section"];
/// Entries that are plotted: name, row, column.
const ENTRIES: [(&str, usize, usize); 8] = [
    ("axial", 0, 0),
    ("shear in plane", 1, 1),
    ("shear out of plane", 2, 2),
    ("torsion", 3, 3),
    ("bending out of plane", 4, 4),
    ("bending in plane", 5, 5),
    ("axial-bending in plane", 0, 5),
    ("shear-torsion", 2, 3),
];
/// Pounds and feet in SI \[N, m\].
const POUND: f64 = 4.448_221_615_260_5;
const FOOT: f64 = 0.3048;
const HEIGHT: u32 = 1100;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

fn main() -> Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = root.join("cases/section/active_twist_section");
    let results = folder.join("results");
    make_folder(&results)?;
    let mut found = Vec::new();
    for name in MESHES {
        found.push(stiffness(&folder.join(format!("{name}.section.toml")))?);
    }
    let (_, finer) = stiffness(&finer(&folder, &results)?)?;
    println!("stiffness in lb and ft, and nodes");
    for (name, row, column) in ENTRIES {
        let unit = |i: usize| if i > 2 { FOOT } else { 1.0 };
        let unit = POUND * unit(row) * unit(column);
        let values = found.iter().map(|(_, matrix)| matrix);
        let values = values.chain(std::iter::once(&finer));
        let words: Vec<_> = values
            .map(|matrix| format!("{:>13.5e}", matrix[(row, column)] / unit))
            .collect();
        println!("{name:24}{}", words.concat());
    }
    let nodes: Vec<_> = found
        .iter()
        .map(|(nodes, _)| format!("{nodes:>13}"))
        .collect();
    println!("{:24}{}", "nodes", nodes.concat());
    let plot = Convergence::new(&found, &finer);
    let file = root.join("docs/src/images/active_twist_convergence.png");
    write_figure(&file, &plot.drawing())?;
    println!("{}", file.display());
    Ok(())
}

/// Number of nodes and stiffness of a section.
fn stiffness(file: &Path) -> Result<(usize, Matrix6<f64>)> {
    let input = input::read(file)?;
    let solution = analyze(&input.section)?;
    Ok((input.section.mesh.nodes.len(), solution.stiffness))
}

/// The section on a mesh with cells half as long as the finest one.
fn finer(folder: &Path, results: &Path) -> Result<PathBuf> {
    let file = folder.join("active_twist_section.blade.toml");
    let text = std::fs::read_to_string(&file)?;
    let text = text.replace("size = 0.14", "size = 0.07");
    let text = text.replace("turn = 9", "turn = 4.5");
    let made = blade::parse(&text, &file)?;
    write_text(&results.join("finer.msh"), &gmsh::write(&made.mesh))?;
    let section = std::fs::read_to_string(folder.join("active_twist_section.section.toml"))?;
    let section = section.replace("active_twist_section.msh", "finer.msh");
    let file = results.join("finer.section.toml");
    write_text(&file, &section)?;
    Ok(file)
}

/// Differences from the finer mesh, relative to sqrt(Kii Kjj), over nodes.
struct Convergence {
    /// For each entry (nodes, difference) by mesh \[-\].
    lines: Vec<Vec<[f64; 2]>>,
}

/// The plotted data: nodes and differences as powers of ten.
const NODES: [f64; 2] = [3.3, 4.0];
const DIFFERENCES: [f64; 2] = [-6.0, -2.0];
/// The frame of the chart \[figure pixels\].
const LEFT: f64 = 170.0;
const RIGHT: f64 = 1180.0;
const TOP: f64 = 60.0;
const BOTTOM: f64 = 950.0;

impl Convergence {
    fn new(found: &[(usize, Matrix6<f64>)], finer: &Matrix6<f64>) -> Self {
        let line = |&(_, i, j): &(&str, usize, usize)| {
            let scale = (finer[(i, i)] * finer[(j, j)]).sqrt();
            let point = |(nodes, matrix): &(usize, Matrix6<f64>)| {
                let difference = (matrix[(i, j)] - finer[(i, j)]).abs() / scale;
                [*nodes as f64, difference]
            };
            found.iter().map(point).collect()
        };
        Self {
            lines: ENTRIES.iter().map(line).collect(),
        }
    }
}

fn position([nodes, difference]: [f64; 2]) -> [f64; 2] {
    let part = |value: f64, [low, high]: [f64; 2]| (value.log10() - low) / (high - low);
    [
        LEFT + (RIGHT - LEFT) * part(nodes, NODES),
        BOTTOM - (BOTTOM - TOP) * part(difference, DIFFERENCES),
    ]
}

impl Figure for Convergence {
    fn size(&self) -> (u32, u32) {
        (WIDTH, HEIGHT)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let gray = Color(215, 215, 215);
        let small = Label::new(0.8 * TEXT);
        for power in -6..=-2 {
            let at = position([2000.0, 10f64.powi(power)])[1];
            drawing.line(&[[LEFT, at], [RIGHT, at]], 1.5, gray);
            let text = format!("1e{power}");
            drawing.text(&text, [LEFT - 15.0, at], small.anchored(Anchor::End));
        }
        for nodes in [2000, 3000, 5000, 10000] {
            let at = position([f64::from(nodes), 0.01])[0];
            drawing.line(&[[at, TOP], [at, BOTTOM]], 1.5, gray);
            let below = [at, BOTTOM + 35.0];
            drawing.text(&nodes.to_string(), below, small.anchored(Anchor::Middle));
        }
        let frame = [
            [LEFT, TOP],
            [RIGHT, TOP],
            [RIGHT, BOTTOM],
            [LEFT, BOTTOM],
            [LEFT, TOP],
        ];
        drawing.line(&frame, 2.0, BLACK);
        let middle = [0.5 * (LEFT + RIGHT), BOTTOM + 95.0];
        drawing.text("nodes", middle, small.anchored(Anchor::Middle));
        let beside = [40.0, 0.5 * (TOP + BOTTOM)];
        let text = "difference from a finer mesh, of sqrt(Kii Kjj)";
        drawing.text(text, beside, small.anchored(Anchor::Middle).upward());
        for (index, line) in self.lines.iter().enumerate() {
            let color = if index < 7 { category(index) } else { BLACK };
            let points: Vec<_> = line.iter().map(|point| position(*point)).collect();
            drawing.line(&points, 4.0, color);
            for point in &points {
                drawing.disc(*point, 9.0, color);
            }
            let at = TOP + 30.0 + 60.0 * index as f64;
            drawing.line(&[[RIGHT + 40.0, at], [RIGHT + 110.0, at]], 4.0, color);
            drawing.text(ENTRIES[index].0, [RIGHT + 130.0, at], small);
        }
    }
}
