//! Stresses in the report of a blade: its data against recoveries of the program, and the sums
//! and criteria of its script in a browser.

use nalgebra::Vector6;
use section_analyzer::analysis::analyze;
use section_analyzer::input::{self, Input};
use section_analyzer::recovery::{LoadCase, Recoverer, Recovery, failure_indices};
use section_analyzer::solution::SectionSolution;
use serde_json::{Value, json};

use crate::blade_report::{REPORT, blade, data, open_in_browser};
use crate::strength::STRENGTHS;
use crate::unpacked::unpacked;
use crate::whole_blade::LAYUP;
use crate::workplace::Workplace;

/// Limits of all kinds: a ply with strengths and strain limits, an isotropic material with both,
/// one with a yield stress.
const LIMITS: &str = "
[material.glass.strain_limit]
xt = 0.018
xc = 0.012
yt = 0.005
yc = 0.02
s12 = 0.02

[material.lead.strength]
tension = 0.02
compression = 0.03
shear = 0.012

[material.lead.strain_limit]
tension = 0.001
compression = 0.002
shear = 0.001

[material.steel]
young = 210
poisson = 0.3
density = \"7850 kg/m^3\"

[material.steel.strength]
yield = 0.35
";

/// A blade with a report of two stations, with a web of steel.
fn reported() -> Workplace {
    let workplace = Workplace::new();
    let web = "{ name = \"ply\", material = \"glass\"";
    let text = LAYUP.replace(web, &web.replace("glass", "steel"));
    workplace.write("a.layup.toml", &format!("{text}\n{STRENGTHS}{LIMITS}"));
    let run = blade(&workplace, &["--stations", "0.2,0.7"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    workplace
}

/// A section of the blade, solved again, with the stresses of its report.
struct Station {
    name: String,
    input: Input,
    solution: SectionSolution,
    /// The cells in the order of the report, with their ply.
    cells: Vec<(usize, usize)>,
    /// For each ply the exponents of its steps, and the numbers of its cells.
    lists: Vec<Vec<i64>>,
    /// The first cell of each ply.
    plies: Vec<usize>,
}

fn stations(workplace: &Workplace) -> Vec<Station> {
    let page = data(workplace);
    let of = |station: &Value| {
        let name = station["name"].as_str().unwrap().to_owned();
        let file = workplace.path(&format!("b/sections/{name}.section.toml"));
        let input = input::read(&file).unwrap();
        let mesh = &input.section.mesh;
        let mut order: Vec<usize> = (0..mesh.cells.len()).collect();
        order.sort_by_key(|&cell| mesh.cells[cell].group);
        let picture = &station["picture"];
        let counts = picture["plies"].as_array().unwrap().iter();
        let (mut plies, mut cells, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        for count in counts.map(|ply| ply["cells"].as_u64().unwrap() as usize) {
            let first = cells.len();
            cells.extend(
                order[first..first + count]
                    .iter()
                    .map(|&cell| (cell, plies.len())),
            );
            plies.push(first);
            lengths.extend(std::iter::once(36).chain(vec![count; 36]));
        }
        Station {
            name,
            solution: analyze(&input.section).unwrap(),
            input,
            cells,
            lists: unpacked(picture["stress"].as_str().unwrap(), &lengths),
            plies,
        }
    };
    page["stations"]
        .as_array()
        .unwrap()
        .iter()
        .map(of)
        .collect()
}

impl Station {
    /// The stress of a cell in the report under a force, and its largest error: half of a step for
    /// each unit of force.
    fn shown(&self, cell: usize, component: usize, force: &Vector6<f64>) -> (f64, f64) {
        let ply = self.cells[cell].1;
        let lists = &self.lists[37 * ply..37 * ply + 37];
        let (mut stress, mut error) = (0.0, 0.0);
        for (i, part) in force.iter().enumerate() {
            let number = 6 * i + component;
            let step = 2.0_f64.powi(lists[0][number] as i32);
            let value = lists[1 + number][cell - self.plies[ply]];
            stress += part * step * value as f64;
            error += 0.5 * part.abs() * step;
        }
        (stress, error)
    }

    fn recovered(&self, force: &Vector6<f64>) -> Recovery {
        let load = LoadCase::at_point("load", force, [0.0; 2]);
        let recoverer = Recoverer::new(&self.input.section, &self.solution);
        recoverer.recover(&load).unwrap()
    }
}

struct Random(u64);

impl Random {
    /// From -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn below(&mut self, count: usize) -> usize {
        (0.5 * (self.next() + 1.0) * count as f64) as usize % count
    }

    /// Forces of a blade of 5 m, each of any size up to its largest.
    fn force(&mut self) -> Vector6<f64> {
        let largest = [2e4, 2e3, 4e3, 5e2, 1e4, 5e3];
        Vector6::from_fn(|i, _| largest[i] * self.next() * 10_f64.powf(self.next() - 1.0))
    }
}

/// 200 random forces on each section, all cells: the stresses are the means of a new analysis
/// and recovery, within the stated error and the round-off of the solutions (1e-9 of the largest
/// stress, since the report has them from the files of the section).
#[test]
fn stresses_are_the_ones_of_new_recoveries() {
    let workplace = reported();
    let mut random = Random(91);
    for station in &stations(&workplace) {
        let mut compared = 0;
        for _ in 0..200 {
            let force = random.force();
            let recovery = station.recovered(&force);
            for _ in 0..20 {
                let shown = random.below(station.cells.len());
                let exact = &recovery.cells[station.cells[shown].0]
                    .tensors
                    .material_stress;
                for component in 0..6 {
                    let (stress, error) = station.shown(shown, component, &force);
                    let difference = (stress - exact[component]).abs();
                    let allowed = error + 1e-9 * recovery.stress_scale;
                    assert!(
                        difference <= allowed,
                        "{} {shown}: {difference}",
                        station.name
                    );
                    compared += 1;
                }
            }
        }
        assert_eq!(compared, 200 * 20 * 6);
    }
}

/// The table of cells of `section-analyzer stress` has six digits.
#[test]
fn stresses_are_the_ones_of_the_command() {
    let workplace = reported();
    let force = Vector6::new(2e3, -150.0, 400.0, 60.0, -3e3, 700.0);
    let names = [
        "axial",
        "shear-y",
        "shear-z",
        "torsion",
        "bending-y",
        "bending-z",
    ];
    let options = names
        .iter()
        .zip(&force)
        .map(|(name, value)| format!("--{name}={value}"));
    let options: Vec<String> = options.collect();
    let options: Vec<&str> = options.iter().map(String::as_str).collect();
    for station in &stations(&workplace) {
        let name = &station.name;
        let file = format!("b/sections/{name}.section.toml");
        let command = ["stress", &file, "--out", "s", "--no-figures"];
        let run = workplace.run(&[&command[..], &options].concat());
        assert_eq!(run.code, 0, "{}", run.err);
        let table = workplace.read(&format!("s/{name}.load.stress_cells.csv"));
        let mut lines = table
            .lines()
            .map(|line| line.split(',').collect::<Vec<_>>());
        let head = lines.next().unwrap();
        let columns = ["11", "22", "33", "23", "13", "12"].map(|axes| {
            let name = format!("stress_{axes} [Pa]");
            head.iter().position(|known| *known == name).unwrap()
        });
        let rows: Vec<Vec<&str>> = lines.collect();
        assert_eq!(rows.len(), station.cells.len());
        for (shown, (cell, _)) in station.cells.iter().enumerate() {
            for (component, &column) in columns.iter().enumerate() {
                let expected: f64 = rows[*cell][column].parse().unwrap();
                let (stress, error) = station.shown(shown, component, &force);
                let allowed = error + 6e-6 * expected.abs() + 1e-3;
                assert!(
                    (stress - expected).abs() <= allowed,
                    "{name}: {stress} {expected}"
                );
            }
        }
    }
}

/// The page, with 600 random cells and forces that the program has recovered: its script finds
/// the same stresses, failure indices, reserve factors and modes.
#[test]
fn the_script_finds_stress_and_failure_as_the_program() {
    let workplace = reported();
    let mut random = Random(17);
    let mut samples = Vec::new();
    for station in &stations(&workplace) {
        for _ in 0..100 {
            let force = random.force();
            let recovery = station.recovered(&force);
            for _ in 0..3 {
                let shown = random.below(station.cells.len());
                let cell = station.cells[shown].0;
                let material = station.input.section.cells[cell].material;
                let tensors = &recovery.cells[cell].tensors;
                let found = failure_indices(&station.input.limits[material], tensors);
                let failures = found.iter().map(|one| {
                    json!([
                        one.criterion.name(),
                        one.index,
                        one.reserve_factor,
                        one.mode.name()
                    ])
                });
                samples.push(json!({
                    "section": station.name,
                    "cell": shown,
                    "force": force.as_slice(),
                    "stress": tensors.material_stress.as_slice(),
                    "round_off": 1e-9 * recovery.stress_scale,
                    "failures": failures.collect::<Vec<_>>(),
                }));
            }
        }
    }
    let criteria = samples
        .iter()
        .flat_map(|one| one["failures"].as_array().unwrap());
    let criteria: std::collections::BTreeSet<String> =
        criteria.map(|one| one[0].to_string()).collect();
    assert_eq!(criteria.len(), 5, "{criteria:?}");
    let page = workplace.read(REPORT);
    let (before, rest) = page.split_once("type=\"application/json\">").unwrap();
    let (_, after) = rest.split_once("</script>").unwrap();
    let mut data = data(&workplace);
    data["samples"] = samples.into();
    let data = data.to_string().replace('<', "\\u003c");
    let with_samples = format!("{before}type=\"application/json\">{data}</script>{after}");
    workplace.write("samples.html", &with_samples);
    open_in_browser(&workplace.path("samples.html"));
}
