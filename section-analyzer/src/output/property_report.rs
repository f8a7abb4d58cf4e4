//! The report of a property file: its origin, its axes, and the properties of the
//! section.

use nalgebra::DMatrix;
use shared_geom::section::{self, Change, Damping, Piezo, SectionProperties};
use shared_geom::wrench::COMPONENTS;

use super::engineering::engineering_values_of;
use super::imposed::imposed_report;
use super::parts;
use super::prestress::prestress_report;
use super::text::{coordinate, matrix, number, table};
use super::undeformed::undeformed_beam;
use crate::properties::{Centers, PrincipalAxes, radius_of_gyration};

const CONVENTION: &str = "\
Convention
  Axes: x along the beam, y and z in the section, right-handed.
  Components: axial, shear y, shear z, torsion, bending y, bending z.
  Internal forces act on the face whose normal is +x, moments are about the reference
  point; axial strain is nu_x + z kappa_y - y kappa_z.
  SI units: N, m, kg, rad.
";

/// The report of the property file called `file`.
pub fn property_report(file: &str, properties: &SectionProperties) -> String {
    let values = engineering_values_of(properties);
    let parts = [
        head(file, properties),
        CONVENTION.to_owned(),
        curvature(properties),
        format!(
            "Stiffness, internal force per generalized strain [N, N m, N m^2]\n{}",
            matrix(&properties.stiffness)
        ),
        format!(
            "Mass per length, momentum per velocity [kg/m, kg, kg m]\n{}",
            matrix(&properties.mass)
        ),
        "  (entries below 1e-12 of sqrt(Kii Kjj) are shown as 0)\n".to_owned(),
        values.map_or_else(String::new, |values| parts::engineering(&values)),
        property_centers(properties),
        property_axes(properties),
        parts::couplings(&properties.stiffness),
        properties.piezo.as_ref().map_or_else(String::new, piezo),
        imposed_report(properties),
        damping(properties),
        prestress_report(properties, &[]),
    ];
    parts::joined(&parts)
}

/// The origin of the numbers.
fn head(file: &str, properties: &SectionProperties) -> String {
    let source = &properties.provenance;
    let mesh = match source.nodes {
        0 => "none".to_owned(),
        nodes => format!("{nodes} nodes, {} cells", source.cells),
    };
    let input = match source.input_hash.as_str() {
        "" => "unknown",
        hash => hash,
    };
    let program = match source.program.as_str() {
        "" => "unknown".to_owned(),
        program => format!("{program} {}", source.version),
    };
    let mut text = format!(
        "Section \"{}\"\n  file      {file}\n  mesh      {mesh}\n  input     {input}\n  \
         program   {program}\n",
        properties.name,
    );
    for (number, step) in source.history.iter().enumerate() {
        let label = if number == 0 { "history" } else { "" };
        text += &format!(
            "  {label:<9} {} by {} {}\n",
            step.change, step.program, step.version
        );
    }
    let [y, z] = [properties.reference_point.x, properties.reference_point.y];
    let turned = |step: &section::Step| matches!(step.change, Change::Rotate(_));
    let axes = if source.history.iter().any(turned) {
        "mesh axes turned likewise"
    } else {
        "mesh axes"
    };
    let scale = radius_of_gyration(properties);
    let (y, z) = (coordinate(y, scale), coordinate(z, scale));
    text + &format!("  point     reference point at ({y}, {z}) m in {axes}\n")
}

/// The centers of a property file.
pub fn property_centers(properties: &SectionProperties) -> String {
    let centers = &properties.centers;
    let massive = properties.mass[(0, 0)] > 0.0;
    let centers = Centers {
        tension: centers.tension.into(),
        shear: centers.shear.into(),
        mass: massive.then(|| centers.mass.into()),
    };
    parts::centers(radius_of_gyration(properties), &centers)
}

/// The principal axes of a property file.
pub fn property_axes(properties: &SectionProperties) -> String {
    let axes = &properties.principal_axes;
    let of = |angle: f64, [first, second]: [f64; 2]| PrincipalAxes {
        angle,
        first,
        second,
    };
    let bending = of(axes.bending_angle, axes.bending_stiffness);
    let inertia = of(axes.inertia_angle, axes.inertia);
    let massive = properties.mass[(0, 0)] > 0.0;
    parts::principal_axes(&bending, massive.then_some(&inertia))
}

fn curvature(properties: &SectionProperties) -> String {
    let initial = properties.initial_curvature;
    initial.map_or_else(String::new, |initial| undeformed_beam(&initial))
}

fn piezo(piezo: &Piezo) -> String {
    let with_names = |names: &[&str], columns: &[String], matrix: &DMatrix<f64>| {
        let heading = std::iter::once(String::new()).chain(columns.iter().cloned());
        let mut rows = vec![heading.collect::<Vec<_>>()];
        for (name, row) in names.iter().zip(matrix.row_iter()) {
            let values = row.iter().map(|value| number(*value));
            rows.push(std::iter::once((*name).to_owned()).chain(values).collect());
        }
        table(&rows, "lr")
    };
    let electrodes = &piezo.electrodes;
    let names: Vec<_> = electrodes.iter().map(String::as_str).collect();
    format!(
        "Electrodes, internal force per voltage [N/V, N m/V]\n{}\
         Electrodes, charge per length per voltage [F/m]\n{}",
        with_names(&COMPONENTS, electrodes, &piezo.coupling),
        with_names(&names, electrodes, &piezo.capacitance),
    )
}

fn damping(properties: &SectionProperties) -> String {
    match &properties.damping {
        None => String::new(),
        Some(Damping::StiffnessProportional(time)) => {
            format!("Damping\n  the stiffness times {} s\n", number(*time))
        }
        Some(Damping::Viscous(viscous)) => format!(
            "Damping, internal force per rate of strain [N s, N m s, N m^2 s]\n{}",
            matrix(viscous)
        ),
    }
}
