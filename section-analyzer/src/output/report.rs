//! The text report of an analysis: input, conventions, results, and checks of the run.

use super::areas::areas;
use super::electric::{electric_law, electrodes};
use super::engineering::engineering_values;
use super::parts::{self, couplings, joined};
use super::quality::{quality_by_region, quality_in_short};
use super::restrained::restrained_warping;
use super::text::{matrix, number, table};
use super::undeformed::undeformed_beam;
use crate::failure::Failure;
use crate::input::{AngleSource, InputSummary};
use crate::material::{ElasticLaw, Material};
use crate::properties::{NoRestrainedWarping, RestrainedWarping};
use crate::section::Section;
use crate::solution::{Checks, SectionSolution};
use shared_geom::error::Explain;

const CONVENTION: &str = "\
Convention
  Axes: x along the beam, y and z in the section, right-handed; mesh x is y, mesh y is z.
  Components: axial, shear y, shear z, torsion, bending y, bending z.
  Internal forces act on the face whose normal is +x, moments are about the reference
  point, which is the origin of the mesh; axial strain is nu_x + z kappa_y - y kappa_z.
  SI units: N, m, kg, rad.
";

/// The report of a successful analysis; `on_request` are the parts on temperature,
/// prestress and derivatives, empty if not requested.
pub fn report(
    section: &Section,
    summary: &InputSummary,
    solution: &SectionSolution,
    restrained: &Result<RestrainedWarping, NoRestrainedWarping>,
    on_request: &[String],
) -> String {
    let unknowns = format!("  unknowns  {} of warping\n", solution.unknowns);
    let parts = [
        head(section, summary) + &unknowns,
        warnings(summary),
        CONVENTION.to_owned(),
        curvature(section),
        materials(&section.materials),
        regions(section, summary),
        electrodes(section, summary),
        quality_in_short(summary),
        format!(
            "Stiffness, internal force per generalized strain [N, N m, N m^2]\n{}",
            matrix(&solution.stiffness)
        ),
        format!(
            "Mass per length, momentum per velocity [kg/m, kg, kg m]\n{}",
            matrix(&solution.mass)
        ),
        "  (entries below 1e-12 of sqrt(Kii Kjj) are shown as 0)\n".to_owned(),
        engineering(solution),
        centers(summary, solution),
        principal_axes(solution),
        couplings(&solution.stiffness),
        areas(&summary.areas),
        restrained_warping(restrained, solution, &summary.areas),
        joined(on_request),
        checks(&solution.checks),
    ];
    joined(&parts)
}

/// The report of an analysis that failed: its input and the failure.
pub fn failure_report(section: &Section, summary: &InputSummary, failure: &Failure) -> String {
    let help = failure
        .help()
        .map_or_else(String::new, |help| format!("  help: {help}\n"));
    let parts = [
        head(section, summary),
        warnings(summary),
        curvature(section),
        materials(&section.materials),
        regions(section, summary),
        electrodes(section, summary),
        format!("No result\n  {failure}\n{help}"),
    ];
    joined(&parts)
}

/// The report of the input, for a check without analysis.
pub fn input_report(section: &Section, summary: &InputSummary) -> String {
    let parts = [
        head(section, summary),
        warnings(summary),
        curvature(section),
        materials(&section.materials),
        regions(section, summary),
        electrodes(section, summary),
        areas(&summary.areas),
        quality_by_region(summary),
    ];
    joined(&parts)
}

fn head(section: &Section, summary: &InputSummary) -> String {
    let kinds = summary.kinds.iter().map(|(kind, count)| {
        let name = kind.name();
        match (count, name.split_once(' ')) {
            (1, _) => format!("1 {name}"),
            (_, Some((shape, rest))) => format!("{count} {shape}s {rest}"),
            (_, None) => format!("{count} {name}"),
        }
    });
    let kinds: Vec<_> = kinds.collect();
    format!(
        "Section \"{}\"\n  file      {}\n  mesh      {}: {} nodes, {}\n  input     {}\n  program   {} {}\n",
        section.name,
        summary.file,
        summary.mesh_file,
        section.mesh.nodes.len(),
        kinds.join(", "),
        summary.input_hash,
        env!("CARGO_PKG_NAME"),
        env!("CARGO_PKG_VERSION"),
    )
}

/// The undeformed beam; empty if it is straight.
fn curvature(section: &Section) -> String {
    let initial = &section.initial_curvature;
    if initial.is_straight() {
        String::new()
    } else {
        undeformed_beam(initial)
    }
}

fn warnings(summary: &InputSummary) -> String {
    let lines = summary
        .warnings
        .iter()
        .map(|warning| format!("  remark: {warning}\n"));
    let lines: String = lines.collect();
    if lines.is_empty() {
        String::new()
    } else {
        format!("Remarks\n{lines}")
    }
}

fn materials(materials: &[Material]) -> String {
    let entry = |material: &Material| {
        let (kind, constants) = law(&material.law);
        let density = Digits(material.density);
        let expansion = expansion(material.expansion);
        let constants = if constants.is_empty() {
            constants
        } else {
            format!("      {constants}\n")
        };
        let electric = material.electric.as_ref();
        let electric = electric.map_or_else(String::new, electric_law);
        format!(
            "  {}: {kind}, {density} kg/m^3\n{constants}{expansion}{electric}",
            material.name
        )
    };
    let entries: String = materials.iter().map(entry).collect();
    format!("Materials\n{entries}")
}

/// The line of the expansion of a material, if it expands.
fn expansion(coefficients: Option<[f64; 3]>) -> String {
    let line = |[a1, a2, a3]: [f64; 3]| {
        let shown = [a1, a2, a3].map(|a| Digits(a).to_string());
        let shown = if a1 == a2 && a2 == a3 {
            shown[0].clone()
        } else {
            shown.join(", ")
        };
        format!("      expansion {shown} 1/K\n")
    };
    coefficients.map_or_else(String::new, line)
}

/// Kind and constants of a law.
fn law(law: &ElasticLaw) -> (&'static str, String) {
    match law {
        ElasticLaw::Isotropic { young, poisson } => {
            let constants = format!("E {}, nu {}", in_gpa(&[*young]), Digits(*poisson));
            ("isotropic", constants)
        }
        ElasticLaw::Orthotropic(k) => {
            let constants = format!(
                "E1, E2, E3 {}; G12, G13, G23 {}; nu12, nu13, nu23 {}, {}, {}",
                in_gpa(&[k.e1, k.e2, k.e3]),
                in_gpa(&[k.g12, k.g13, k.g23]),
                Digits(k.nu12),
                Digits(k.nu13),
                Digits(k.nu23),
            );
            ("orthotropic", constants)
        }
        ElasticLaw::Full(c) => {
            let diagonal: Vec<_> = c.diagonal().iter().copied().collect();
            (
                "full stiffness",
                format!("C11 to C66 {}", in_gpa(&diagonal)),
            )
        }
        ElasticLaw::Absent => ("no stiffness", String::new()),
    }
}

/// The regions. Zero angles of isotropic materials without electric law are shown as `-`.
fn regions(section: &Section, summary: &InputSummary) -> String {
    let is_isotropic = |name: &str| {
        let mut materials = section.materials.iter();
        let found = materials.find(|material| material.name == name);
        found.is_some_and(|material| {
            let is_electric = material.electric.is_some();
            matches!(material.law, ElasticLaw::Isotropic { .. }) && !is_electric
        })
    };
    let heading = [
        "region",
        "material",
        "fiber angle",
        "plane angle",
        "cells",
        "area [m^2]",
        "mass [kg/m]",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for (region, area) in summary.regions.iter().zip(&summary.areas.regions) {
        let angle = |angle: &AngleSource| {
            let is_zero = *angle == AngleSource::Constant(0.0);
            if is_zero && is_isotropic(&region.material) {
                "-".to_owned()
            } else {
                angle.to_string()
            }
        };
        rows.push(vec![
            region.group.clone(),
            region.material.clone(),
            angle(&region.fiber_angle),
            angle(&region.plane_angle),
            area.cells.to_string(),
            number(area.area),
            number(area.mass),
        ]);
    }
    let total = &summary.areas.total;
    let mut row = vec![total.name.clone()];
    row.resize(4, String::new());
    row.push(total.cells.to_string());
    row.extend([total.area, total.mass].map(number));
    rows.push(row);
    format!("Regions\n{}", table(&rows, "llllr"))
}

fn engineering(solution: &SectionSolution) -> String {
    parts::engineering(&engineering_values(solution))
}

fn centers(summary: &InputSummary, solution: &SectionSolution) -> String {
    let scale = summary.areas.total.area.sqrt();
    let centers = &solution.centers;
    parts::centers(scale, centers)
}

fn principal_axes(solution: &SectionSolution) -> String {
    parts::principal_axes(
        &solution.principal_bending,
        solution.principal_inertia.as_ref(),
    )
}

/// Relative error of the checks from which the report states the number of digits.
const FEW_DIGITS: f64 = 1e-9;

/// The checks of the run.
pub fn checks(checks: &Checks) -> String {
    let worst = checks
        .identities
        .iter()
        .fold(0.0_f64, |worst, error| worst.max(*error));
    let row = |name: &str, value: f64| vec![name.to_owned(), format!("{value:.1e}")];
    let rows = [
        row("rigid-body identities of the assembled matrices", worst),
        row("last correction of the linear systems", checks.correction),
        row("internal force of the six solutions", checks.equilibrium),
        row("symmetry of the compliance", checks.asymmetry),
        row("energy against mean strain", checks.decoupling),
        row("condition number, lower bound", checks.condition),
        row(
            "smallest pivot (1e-16: a part can move freely)",
            checks.smallest_pivot,
        ),
    ];
    let errors = [checks.equilibrium, checks.asymmetry, checks.decoupling];
    let error = errors.into_iter().fold(0.0, f64::max);
    let lost = if error > FEW_DIGITS {
        format!(
            "  remark: {:.0} digits of the result are significant: walls thousands of times \
             longer than thick, and moduli many orders of magnitude apart, lose the others\n",
            -error.log10().ceil()
        )
    } else {
        String::new()
    };
    format!(
        "Checks of this run (relative errors, except the last two)\n{}{lost}",
        table(&rows, "lr")
    )
}

/// Moduli in GPa.
fn in_gpa(moduli: &[f64]) -> String {
    let shown: Vec<_> = moduli
        .iter()
        .map(|value| Digits(value / 1e9).to_string())
        .collect();
    format!("{} GPa", shown.join(", "))
}

/// A number with at most six digits, without trailing zeros.
struct Digits(f64);

impl std::fmt::Display for Digits {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&shared_geom::figure::tick_label(self.0, 0.0))
    }
}
