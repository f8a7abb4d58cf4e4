//! Tables of the stations of a blade, and of their layers.

use nalgebra::Vector2;

use super::{SolvedSpan, SolvedStation};
use crate::output::engineering::engineering_values_of;
use crate::output::text::csv;

/// Columns of the table of stations.
const SPAN: [&str; 26] = [
    "section",
    "eta [-]",
    "arc_length [m]",
    "x [m]",
    "y [m]",
    "z [m]",
    "chord [m]",
    "twist [deg]",
    "mass [kg/m]",
    "ea [N]",
    "ei_flap [N m^2]",
    "ei_edge [N m^2]",
    "gj [N m^2]",
    "ga_y [N]",
    "ga_z [N]",
    "inertia_flap [kg m]",
    "inertia_edge [kg m]",
    "tension_center_y [m]",
    "tension_center_z [m]",
    "shear_center_y [m]",
    "shear_center_z [m]",
    "mass_center_y [m]",
    "mass_center_z [m]",
    "principal_angle [deg]",
    "inertia_angle [deg]",
    "fingerprint",
];

/// Columns of the table of layers.
const LAYERS: [&str; 11] = [
    "eta [-]",
    "section",
    "layer",
    "material",
    "from_arc [-]",
    "to_arc [-]",
    "thickness [m]",
    "nominal_area [m^2]",
    "meshed_area [m^2]",
    "cut_area [m^2]",
    "filled_area [m^2]",
];

/// Values of a station, in the axes of its section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::output) struct SpanRow {
    /// Arc length from the root \[m\].
    pub arc_length: f64,
    /// Position in root axes \[m\].
    pub position: [f64; 3],
    /// Twist of the section, nose up \[rad\].
    pub twist: f64,
    /// EA, GAy, GAz, GJ, all other internal forces zero \[N, N m^2\].
    pub stiffness: [f64; 4],
    /// Bending stiffness about the principal axes near y and z \[N m^2\].
    pub bending: [f64; 2],
}

impl SpanRow {
    pub fn new(span: &SolvedSpan<'_>, station: &SolvedStation) -> Self {
        let curve = span.line.curve();
        let arc_length = station.eta * curve.length();
        let placed = curve.at(arc_length);
        let stiffness = engineering_values_of(&station.properties);
        let stiffness = stiffness.map_or([f64::NAN; 4], |[ea, gay, gaz, gj, ..]| {
            [ea.free, gay.free, gaz.free, gj.free]
        });
        Self {
            arc_length,
            position: placed.position.into(),
            twist: placed.twist,
            stiffness,
            bending: station.properties.principal_axes.bending_stiffness,
        }
    }
}

/// One row per station, as CSV: position, engineering values (all other internal forces zero),
/// centers and principal angles in section axes.
pub fn span_csv(span: &SolvedSpan<'_>) -> String {
    let rows = span.stations.iter().map(|station| {
        let row = SpanRow::new(span, station);
        let properties = &station.properties;
        let (centers, axes) = (&properties.centers, &properties.principal_axes);
        let point = |point: Vector2<f64>| [point.x, point.y];
        let [ea, gay, gaz, gj] = row.stiffness;
        let mut values = vec![station.eta, row.arc_length];
        values.extend(row.position);
        values.extend([station.chord, row.twist.to_degrees()]);
        values.extend([properties.mass[(0, 0)], ea]);
        values.extend(row.bending);
        values.extend([gj, gay, gaz]);
        values.extend(axes.inertia);
        values.extend(
            [centers.tension, centers.shear, centers.mass]
                .map(point)
                .concat(),
        );
        values.extend([axes.bending_angle, axes.inertia_angle].map(f64::to_degrees));
        let name = std::iter::once(properties.name.clone());
        let numbers = name.chain(values.into_iter().map(exact));
        numbers.chain([station.fingerprint.clone()]).collect()
    });
    csv(std::iter::once(SPAN.map(str::to_owned).to_vec()).chain(rows))
}

/// One row per station and layer, as CSV.
pub fn layers_csv(span: &SolvedSpan<'_>) -> String {
    let rows = span.stations.iter().flat_map(|station| {
        station.layers.iter().map(|row| {
            let mut cells = vec![exact(station.eta), station.properties.name.clone()];
            cells.extend([row.layer.clone(), row.material.clone()]);
            let [from, to] = [0, 1].map(|end| row.arcs.map(|arcs| arcs[end]));
            let given =
                [from, to, row.thickness].map(|value| value.map_or_else(String::new, exact));
            cells.extend(given);
            cells.extend([row.nominal, row.meshed, row.cut, row.filled].map(exact));
            cells
        })
    });
    csv(std::iter::once(LAYERS.map(str::to_owned).to_vec()).chain(rows))
}

/// All digits of a number.
fn exact(value: f64) -> String {
    format!("{:e}", value + 0.0)
}
