//! A composite box of 24 plies at three sizes, from the section file to the
//! properties: time of each stage, then the shares and the growth of the total as ratios
//! within the run.
//!
//! The mesh is `tests/reference/sections/box_CUS_45_m45.v41.msh` with each triangle
//! cut into r x r: 2 000, 7 600 and 46 000 nodes for r = 1, 2, 5.

use std::ffi::OsString;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fs, io};

use cpu_time::ThreadTime;
use nalgebra::{Matrix3, Matrix3x6, Matrix6xX, Vector3};
use peak_alloc::PeakAlloc;
use section_analyzer::analysis::{Analysis, analyze};
use section_analyzer::assembly::{Domain, Pattern, SectionMatrices};
use section_analyzer::material::ElectricLaw;
use section_analyzer::recovery::{LoadCase, Recoverer};
use section_analyzer::section::{Circuit, Electrode, ElectrodeShape, Section};
use section_analyzer::sensitivity::{Cells, Parameter};
use section_analyzer::solve::{
    CentralSolution, CentralSystems, Factor, Pins, elimination_order, in_elimination_order,
};
use section_analyzer::{cli, input};
use shared_geom::gmsh;
use shared_geom::mesh::Mesh;

mod refine;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

const MESH: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../tests/reference/sections/box_CUS_45_m45.v41.msh"
);

/// Number of fiber angles that derivatives are taken with respect to.
const ANGLES: usize = 100;

const MATERIAL: &str = "\
[material.graphite]
e1 = 141.96304663e9
e2 = 9.79055494e9
e3 = 9.79055494e9
g12 = 5.99843859e9
g13 = 5.99843859e9
g23 = 4.798750872e9
nu12 = 0.3
nu13 = 0.3
nu23 = 0.34
density = 1550.0
";

/// Writes the box refined by `r` into `folder`; returns its section file.
fn write_case(mesh: &Mesh, r: usize, folder: &Path) -> PathBuf {
    let mesh_name = format!("box_{r}.msh");
    let refined = refine::refined(mesh, r);
    fs::write(folder.join(&mesh_name), gmsh::write(&refined)).expect("a folder to write to");

    let mut text = format!("units = \"SI\"\nmesh = \"{mesh_name}\"\n{MATERIAL}");
    for group in &mesh.groups {
        // groups 10 to 15 are the plies of the upper wall, from the outside; each wall
        // adds 10 and turns by 90 deg; the inner two plies of six run the other way
        let plane = 90 * (group.tag / 10 - 1);
        let fiber = if group.tag % 10 < 4 { 45 } else { -45 };
        text += &format!(
            "[[region]]\ngroup = \"{}\"\nmaterial = \"graphite\"\n\
             fiber_angle = \"{fiber} deg\"\nplane_angle = \"{plane} deg\"\n",
            group.label()
        );
    }
    let file = folder.join(format!("box_{r}.section.toml"));
    fs::write(&file, text).expect("a folder to write to");
    file
}

/// The mesh of a section file of [`write_case`].
fn mesh_of(file: &Path) -> PathBuf {
    file.with_extension("").with_extension("msh")
}

fn section(file: &Path) -> Section {
    input::read(file)
        .unwrap_or_else(|problems| panic!("{problems}"))
        .section
}

/// The domain and pattern of the section, in the order of elimination.
fn prepared(section: &Section) -> Option<(Domain, Pattern)> {
    let domain = Domain::new(section).ok()?;
    let pattern = Pattern::new(&domain);
    in_elimination_order(domain, &pattern)
}

/// The shortest processor time of the runs within a second, at least five: the most
/// repeatable figure on a machine that is shared.
fn shortest<T>(mut work: impl FnMut() -> T) -> Duration {
    let (begin, mut best, mut runs) = (Instant::now(), Duration::MAX, 0);
    while runs < 5 || begin.elapsed() < Duration::from_secs(1) {
        let start = ThreadTime::now();
        black_box(work());
        best = best.min(start.elapsed());
        runs += 1;
    }
    best
}

/// The fiber angles of [`ANGLES`] groups of cells, which hold all cells.
fn angles(section: &Section) -> Vec<Parameter> {
    let cells: Vec<usize> = (0..section.mesh.cells.len()).collect();
    let groups = cells.chunks(cells.len().div_ceil(ANGLES));
    groups
        .map(|group| Parameter::FiberAngle(Cells::List(group.to_vec())))
        .collect()
}

/// Peak memory of `work`, beyond the memory in use before \[byte\].
fn peak<T>(work: impl FnOnce() -> T) -> usize {
    let before = ALLOCATOR.current_usage();
    ALLOCATOR.reset_peak_usage();
    black_box(work());
    ALLOCATOR.peak_usage() - before
}

/// Shortest times of the parts of one case.
struct Times {
    nodes: usize,
    /// The mesh file alone, and everything up to the checked section.
    mesh_file: Duration,
    read: Duration,
    prepare: Duration,
    assemble: Duration,
    bare: Duration,
    solve: Duration,
    central: Duration,
    analyze: Duration,
    /// Derivatives with respect to [`ANGLES`] fiber angles, without the analysis.
    sensitivities: Duration,
    total: Duration,
    /// The same section on a beam of general curvature.
    curved: Duration,
    /// The same section of piezoelectric plies, with two electrodes.
    piezo: Duration,
    /// Stresses of a hundred load cases.
    loads: Duration,
    /// Full recoveries (strains, means and smoothed values) of ten load cases.
    recoveries: Duration,
    /// Peak memory over the memory of the factor [-].
    memory: f64,
}

impl Times {
    fn of(file: &Path) -> Self {
        let read = shortest(|| section(file));
        let section = section(file);
        let unordered = Pattern::new(&Domain::new(&section).expect("a sound section"));
        let order = elimination_order(&unordered).expect("memory");
        let (domain, pattern) = prepared(&section).expect("a sound section");
        let matrices = SectionMatrices::assemble(&domain, &pattern).expect("sound cells");
        let pins = Pins::choose(&domain.nodes).expect("a plane section");
        let factor =
            Factor::new(matrices.e.clone(), &pattern, pins.clone()).expect("a connected section");
        let system = CentralSystems::new(&domain, &pattern, matrices.clone(), pins.clone())
            .expect("a connected section");
        let analysis = Analysis::new(&section).expect("a sound section");
        let angles = angles(&section);
        let poled = piezoelectric(&section);
        let memory = peak(|| analyze(&input::read(file).expect("a sound file").section));
        Self {
            nodes: domain.nodes.len(),
            memory: memory as f64 / (8 * factor.entries()) as f64,
            mesh_file: shortest(|| gmsh::read_file(&mesh_of(file))),
            read,
            prepare: shortest(|| {
                let domain = Domain::new(&section).ok()?;
                let pattern = Pattern::new(&domain);
                let domain = domain.renumbered(&order);
                Some((Pattern::new(&domain), pattern))
            }),
            assemble: shortest(|| SectionMatrices::assemble(&domain, &pattern)),
            // the ordering is included
            bare: shortest(|| elimination_order(&unordered))
                + shortest(|| Factor::new(matrices.e.clone(), &pattern, pins.clone())),
            solve: shortest(|| {
                let mut right = matrices.r.clone();
                factor.solve(right.as_mut_slice())
            }),
            central: shortest(|| CentralSolution::solve(&domain, &system)),
            analyze: shortest(|| analyze(&section)),
            sensitivities: shortest(|| analysis.sensitivities(&angles)),
            total: shortest(|| analyze(&input::read(file).expect("a sound file").section)),
            curved: shortest(|| analyze(&curved(&section))),
            piezo: shortest(|| analyze(&poled)),
            loads: hundred_loads(&section),
            recoveries: ten_recoveries(&section),
        }
    }
}

/// The section on a beam with a curvature of about half a radian per size of the section,
/// about all axes.
fn curved(section: &Section) -> Section {
    let nodes = section.mesh.nodes.iter();
    let size = nodes.map(|[y, z]| y.hypot(*z)).fold(0.0, f64::max);
    let mut curved = section.clone();
    curved.initial_curvature.curvature = Vector3::new(0.4, -0.2, 0.2) / size;
    curved
}

/// The section with all plies piezoelectric: every node has a potential, and the outer faces
/// of the upper and lower wall are electrodes.
fn piezoelectric(section: &Section) -> Section {
    let mut section = section.clone();
    for material in &mut section.materials {
        let mut coupling = Matrix3x6::zeros();
        (coupling[(2, 0)], coupling[(2, 1)], coupling[(2, 2)]) = (-6.6, -6.6, 23.2);
        (coupling[(1, 3)], coupling[(0, 4)]) = (17.0, 17.0);
        material.electric = Some(ElectricLaw {
            coupling,
            permittivity: Matrix3::identity() * 1.4e-8,
        });
    }
    let heights = section.mesh.nodes.iter().map(|[_, z]| *z);
    let (low, high) = heights.fold((f64::MAX, f64::MIN), |(low, high), z| {
        (low.min(z), high.max(z))
    });
    let face = |height: f64| {
        let there = |&node: &u32| {
            (section.mesh.nodes[node as usize][1] - height).abs() < 1e-9 * (high - low)
        };
        ElectrodeShape::Conductor {
            nodes: (0..section.mesh.nodes.len() as u32).filter(there).collect(),
        }
    };
    section.electrodes = [(low, Circuit::Ground), (high, Circuit::Driven)]
        .map(|(height, circuit)| Electrode {
            name: format!("{circuit:?}"),
            circuit,
            shape: face(height),
        })
        .to_vec();
    section
}

/// A hundred internal forces.
fn forces() -> Matrix6xX<f64> {
    Matrix6xX::from_fn(100, |k, i| ((i + 1) * (k + 3) % 17) as f64 - 8.0)
}

/// Time to find the stresses at all integration points under a hundred internal forces.
fn hundred_loads(section: &Section) -> Duration {
    let solution = analyze(section).expect("a sound section");
    let forces = forces();
    shortest(|| {
        Recoverer::new(section, &solution).each_stress(&forces, |block| {
            black_box(block.stress());
        });
    })
}

/// Time of ten full recoveries: strains and stresses in both axes at points, in cells and
/// at nodes.
fn ten_recoveries(section: &Section) -> Duration {
    let solution = analyze(section).expect("a sound section");
    let forces = forces();
    shortest(|| {
        let recoverer = Recoverer::new(section, &solution);
        for force in forces.column_iter().take(10) {
            let force = force.into_owned();
            let name = String::new();
            black_box(
                recoverer
                    .recover(&LoadCase::at_point(name, &force, [0.0; 2]))
                    .is_ok(),
            );
        }
    })
}

/// Prints the times and their ratios.
fn ratios(files: &[PathBuf]) {
    let times: Vec<Times> = files.iter().map(|file| Times::of(file)).collect();
    println!(
        "\n nodes |  mesh file   read prepare assemble factor solve6 central | analyze  total [ms]"
    );
    for t in &times {
        let ms = |time: Duration| time.as_secs_f64() * 1e3;
        println!(
            "{:6} | {:10.1} {:6.1} {:7.1} {:8.1} {:6.1} {:6.1} {:7.1} | {:7.1} {:6.1}",
            t.nodes,
            ms(t.mesh_file),
            ms(t.read),
            ms(t.prepare),
            ms(t.assemble),
            ms(t.bare),
            ms(t.solve),
            ms(t.central),
            ms(t.analyze),
            ms(t.total)
        );
    }
    println!(
        "\n nodes | (factor+solves)/total  mesh file/total  total/(factor+solves)  peak/factor memory  \
         curved/straight  piezoelectric/elastic  100 loads/straight  10 recoveries/straight"
    );
    for t in &times {
        // fifteen right-hand sides: seven, six and two
        let core = t.bare.as_secs_f64() + 15.0 / 6.0 * t.solve.as_secs_f64();
        let total = t.total.as_secs_f64();
        println!(
            "{:6} | {:20.2} {:16.2} {:22.2} {:19.2} {:16.2} {:22.2} {:19.2} {:23.2}",
            t.nodes,
            core / total,
            t.mesh_file.as_secs_f64() / total,
            total / core,
            t.memory,
            t.curved.as_secs_f64() / t.analyze.as_secs_f64(),
            t.piezo.as_secs_f64() / t.analyze.as_secs_f64(),
            t.loads.as_secs_f64() / t.analyze.as_secs_f64(),
            t.recoveries.as_secs_f64() / t.analyze.as_secs_f64()
        );
    }
    println!("\n nodes | sensitivities to {ANGLES} angles [ms]  over analyze");
    for t in &times {
        let [of_angles, analyze] = [t.sensitivities, t.analyze].map(|time| time.as_secs_f64());
        println!(
            "{:6} | {:31.1} {:13.2}",
            t.nodes,
            of_angles * 1e3,
            of_angles / analyze
        );
    }
    commands(files, &times);
    if let [first, .., last] = &times[..] {
        let growth = (last.total.as_secs_f64() / first.total.as_secs_f64()).ln()
            / (last.nodes as f64 / first.nodes as f64).ln();
        println!("\ngrowth exponent of the total: {growth:.2}");
    }
}

/// Prints the times of the whole command `analyze`, with its files, over the time of
/// reading and analyzing.
fn commands(files: &[PathBuf], times: &[Times]) {
    println!("\n nodes | analyze --no-figures  with figures [ms]  both over total");
    for (file, t) in files.iter().zip(times) {
        let of = |option: &str| {
            let words = ["section-analyzer", "analyze", "--force", option];
            let words = words
                .iter()
                .filter(|word| !word.is_empty())
                .map(OsString::from);
            let words: Vec<_> = words.chain([file.into()]).collect();
            shortest(|| cli::run(words.clone(), &mut io::sink(), &mut io::sink()))
        };
        let [bare, drawn, total] =
            [of("--no-figures"), of(""), t.total].map(|time| time.as_secs_f64());
        println!(
            "{:6} | {:20.1} {:18.1} {:9.2} {:.2}",
            t.nodes,
            bare * 1e3,
            drawn * 1e3,
            bare / total,
            drawn / total
        );
    }
}

fn main() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mesh = gmsh::read_file(Path::new(MESH)).expect("the reference mesh");
    let files = [1, 2, 5].map(|r| write_case(&mesh, r, folder.path()));

    ratios(&files);
}
