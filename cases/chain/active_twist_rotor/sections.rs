//! Property files of the blade: the stiffness and the torque per volt of the section, or of the
//! thesis, with the mass of the rotor, which a section of load-carrying plies does not have.

use std::path::Path;

use nalgebra::{DMatrix, Matrix6, Vector2, Vector6};
use shared_geom::files::{make_folder, write_text};
use shared_geom::section::{self, Centers, SectionProperties};

use super::Result;

/// The section of the case, by the folder of this case.
const OWN: &str = "../../section/active_twist_section/results/active_twist_section.properties.json";
/// Table 13.3 of the thesis, by the folder of this case.
const TABLE: &str = "../active_twist_blade/table_13_3.properties.json";
/// Names of the property files that [`write`] makes: the section of the case with its couplings and
/// without them, Table 13.3 with and without them, and the stiffness of reference 90.
pub const SETS: [&str; 5] = [
    "coupled",
    "diagonal",
    "table_coupled",
    "table_diagonal",
    "reference",
];

const POUND: f64 = 4.448_221_615_260_5;
const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
/// Mass per length, Table 13.4: 1.03e-3 lbf s^2/in^2 \[kg/m\].
const MASS: f64 = 1.03e-3 * POUND / (INCH * INCH);
/// Inertia per length about the span, 0.0163 slug ft, by which the first twist mode of the thesis
/// follows from its stiffness \[kg m\].
const TORSIONAL: f64 = 0.0163 * POUND;
/// Torsional and out-of-plane bending stiffness of reference 90 [N m^2].
const REFERENCE: [f64; 2] = [2.61e4 * POUND * FOOT * FOOT, 9.16e4 * POUND * FOOT * FOOT];

/// Writes `results/NAME.properties.json` of the folder `case` for each of [`SETS`].
///
/// # Errors
/// A property file that cannot be read or written.
pub fn write(case: &Path) -> Result<()> {
    let read =
        |file: &str| section::read(&case.join(file)).map_err(|problems| problems.to_string());
    let (own, table) = (read(OWN)?, read(TABLE)?);
    let mut reference = diagonal(&table);
    reference.stiffness[(3, 3)] = REFERENCE[0];
    reference.stiffness[(4, 4)] = REFERENCE[1];
    let all = [diagonal(&own), own, diagonal(&table), table, reference];
    let names = [1, 0, 3, 2, 4].map(|index| SETS[index]);
    let folder = case.join("results");
    make_folder(&folder).map_err(|problem| problem.to_string())?;
    for (name, properties) in names.into_iter().zip(all) {
        let file = folder.join(format!("{name}.properties.json"));
        let text = section::write(&massive(name, properties)?);
        write_text(&file, &text).map_err(|problem| problem.to_string())?;
    }
    Ok(())
}

/// Without couplings, and with the torque of the electrode only.
fn diagonal(of: &SectionProperties) -> SectionProperties {
    let mut properties = of.clone();
    properties.stiffness = Matrix6::from_diagonal(&of.stiffness.diagonal());
    if let Some(piezo) = properties.piezo.as_mut() {
        let rows = piezo.coupling.nrows();
        piezo.coupling = DMatrix::from_fn(rows, piezo.coupling.ncols(), |i, j| match i {
            3 => piezo.coupling[(i, j)],
            _ => 0.0,
        });
    }
    properties
}

/// With the mass of the rotor, and the centers of both matrices.
fn massive(name: &str, mut properties: SectionProperties) -> Result<SectionProperties> {
    // Equal parts about y and z: the blades of the thesis have no propeller moment, as the second
    // twist mode and the elastic twist in hover show.
    let part = 0.5 * TORSIONAL;
    let of_mass = [MASS, MASS, MASS, TORSIONAL, part, part];
    properties.name = name.to_owned();
    properties.mass = Matrix6::from_diagonal(&Vector6::from(of_mass));
    let centers = Centers::of(&properties.stiffness, &properties.mass);
    properties.centers = centers.ok_or_else(|| format!("{name}: its stiffness is singular"))?;
    properties.centers.mass = Vector2::zeros();
    // Symmetric in z: the axes of bending and inertia are y and z.
    let compliance = properties.stiffness.try_inverse();
    let compliance = compliance.ok_or_else(|| format!("{name}: its stiffness is singular"))?;
    let axes = &mut properties.principal_axes;
    (axes.bending_angle, axes.inertia_angle) = (0.0, 0.0);
    axes.bending_stiffness = [1.0 / compliance[(4, 4)], 1.0 / compliance[(5, 5)]];
    axes.inertia = [part; 2];
    Ok(properties)
}
