//! Recovered strains and stresses as CSV: a row for each integration point, cell, or
//! node of a region. All values are in SI units, named in the headings of the columns.

use crate::material::MaterialLimits;
use crate::recovery::{
    ElectricRecovery, ElectricState, FailureIndex, Recovery, Tensors, criteria_of, failure_indices,
};
use crate::section::Section;

const SECTION_AXES: [&str; 6] = ["xx", "yy", "zz", "yz", "xz", "xy"];
const MATERIAL_AXES: [&str; 6] = ["11", "22", "33", "23", "13", "12"];

/// The integration points: cell, region, position, area, stress and strain in section and
/// in material axes, von Mises stress, and index, reserve factor and mode of each
/// criterion that any of `limits` (parallel to the materials) allows.
pub fn stress_points_csv(
    section: &Section,
    limits: &[MaterialLimits],
    recovery: &Recovery,
) -> String {
    let criteria = criteria_of(limits);
    let electric = recovery.electric.as_ref();
    let mut heading: Vec<String> = ["cell", "region", "y [m]", "z [m]", "area [m^2]"]
        .map(str::to_owned)
        .to_vec();
    heading.extend(tensor_columns());
    heading.extend(electric.into_iter().flat_map(|_| electric_columns()));
    heading.extend(criteria.iter().flat_map(|criterion| {
        let key = criterion.key();
        [
            format!("{key}_index [-]"),
            format!("{key}_reserve_factor [-]"),
            format!("{key}_mode"),
        ]
    }));
    let rows = recovery.points.iter().enumerate().map(|(index, point)| {
        let cell = &section.mesh.cells[point.cell];
        let mut row = position_columns(cell.tag, &section.mesh.groups[cell.group], point.position);
        row.push(number(point.area));
        row.extend(tensor_values(&point.tensors));
        row.extend(
            electric
                .into_iter()
                .flat_map(|e| electric_values(&e.points[index])),
        );
        let material = section.cells[point.cell].material;
        let found = failure_indices(&limits[material], &point.tensors);
        row.extend(criteria.iter().flat_map(|criterion| {
            let index = found.iter().find(|index| index.criterion == *criterion);
            failure_columns(index)
        }));
        row
    });
    table(heading, rows)
}

/// The means of the cells: cell, region, centroid, stress and strain in section and in
/// material axes, von Mises stress of the mean.
pub fn stress_cells_csv(section: &Section, recovery: &Recovery) -> String {
    let electric = recovery.electric.as_ref();
    let cells = section.mesh.cells.iter().zip(&recovery.cells).enumerate();
    let rows = cells.map(|(index, (cell, state))| {
        let region = &section.mesh.groups[cell.group];
        let mut row = position_columns(cell.tag, region, state.centroid);
        row.extend(tensor_values(&state.tensors));
        row.extend(
            electric
                .into_iter()
                .flat_map(|e| electric_values(&e.cells[index])),
        );
        row
    });
    table(heading("cell", electric), rows)
}

/// The smoothed nodes, repeated for each region on a border: node, region, position,
/// stress and strain in section and in material axes, von Mises stress. With
/// electrodes all tables have electric field and displacement, and this table the potential.
pub fn stress_nodes_csv(section: &Section, recovery: &Recovery) -> String {
    let electric = recovery.electric.as_ref();
    let rows = recovery.nodes.iter().enumerate().map(|(index, state)| {
        let mesh = &section.mesh;
        let region = &mesh.groups[state.group];
        let mut row = position_columns(mesh.node_tag(state.node), region, mesh.nodes[state.node]);
        row.extend(tensor_values(&state.tensors));
        row.extend(
            electric
                .into_iter()
                .flat_map(|e| electric_values(&e.nodes[index])),
        );
        row.extend(electric.map(|electric| number(electric.potential[state.node])));
        row
    });
    let potential = electric.map(|_| "potential [V]".to_owned());
    let heading = heading("node", electric).into_iter().chain(potential);
    table(heading.collect(), rows)
}

fn heading(what: &str, electric: Option<&ElectricRecovery>) -> Vec<String> {
    let position = [what, "region", "y [m]", "z [m]"].map(str::to_owned);
    let electric = electric.into_iter().flat_map(|_| electric_columns());
    position
        .into_iter()
        .chain(tensor_columns())
        .chain(electric)
        .collect()
}

/// Electric field and displacement in section and in material axes.
fn electric_columns() -> Vec<String> {
    let mut names = Vec::new();
    for axes in [["x", "y", "z"], ["1", "2", "3"]] {
        names.extend(axes.map(|axis| format!("electric_field_{axis} [V/m]")));
        names.extend(axes.map(|axis| format!("electric_displacement_{axis} [C/m^2]")));
    }
    names
}

fn electric_values(state: &ElectricState) -> impl Iterator<Item = String> {
    let parts = [
        state.field,
        state.displacement,
        state.material_field,
        state.material_displacement,
    ];
    parts
        .into_iter()
        .flat_map(|part| [part.x, part.y, part.z].map(number))
}

fn tensor_columns() -> Vec<String> {
    let columns = |what: &str, axes: [&str; 6], unit: &str| {
        axes.map(|axis| format!("{what}_{axis} [{unit}]"))
    };
    let mut names = Vec::new();
    for axes in [SECTION_AXES, MATERIAL_AXES] {
        names.extend(columns("stress", axes, "Pa"));
        names.extend(columns("strain", axes, "-"));
    }
    names.push("von_mises [Pa]".to_owned());
    names
}

fn position_columns(tag: u64, region: &str, [y, z]: [f64; 2]) -> Vec<String> {
    vec![tag.to_string(), region.to_owned(), number(y), number(z)]
}

fn tensor_values(tensors: &Tensors) -> impl Iterator<Item = String> {
    let parts = [
        tensors.stress,
        tensors.strain,
        tensors.material_stress,
        tensors.material_strain,
    ];
    let mut values: Vec<f64> = parts.iter().flat_map(|part| part.iter().copied()).collect();
    values.push(tensors.von_mises());
    values.into_iter().map(number)
}

/// Empty if the criterion does not apply to the material; an infinite reserve factor is
/// empty too.
fn failure_columns(index: Option<&FailureIndex>) -> [String; 3] {
    let Some(index) = index else {
        return Default::default();
    };
    let reserve = if index.reserve_factor.is_finite() {
        number(index.reserve_factor)
    } else {
        String::new()
    };
    [number(index.index), reserve, index.mode.name().to_owned()]
}

/// Nine digits: more than the accuracy of any stress, enough to compare two runs.
fn number(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:.8e}")
    }
}

fn table(heading: Vec<String>, rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in std::iter::once(heading).chain(rows) {
        writer
            .write_record(&row)
            .expect("rows of equal length, written to memory");
    }
    let bytes = writer.into_inner().expect("writing to memory cannot fail");
    String::from_utf8(bytes).expect("only valid text was written")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::material::Strength;
    use crate::recovery::{LoadCase, recover};
    use crate::section::samples::of_quadrilaterals;
    use nalgebra::Vector6;

    /// Two unit squares under an axial force of 4 N, area 2 m^2: 2 Pa, 2/E everywhere,
    /// von Mises stress 2 Pa, index 0.5 of a yield stress of 4 Pa.
    #[test]
    fn rows_hold_what_the_columns_say() {
        let nodes = [0, 1, 2].map(|y| [[f64::from(y), 0.0], [f64::from(y), 1.0]]);
        let cells = [[0, 2, 3, 1], [2, 4, 5, 3]];
        let mut section = of_quadrilaterals(nodes.as_flattened(), &cells);
        section.mesh.groups = vec!["with, comma".into()];
        let load = LoadCase::at_point("pull", &Vector6::ith(0, 4.0), [1.0, 0.5]);
        let recovery = recover(&section, &analyze(&section).unwrap(), &load).unwrap();
        let limits = [MaterialLimits {
            strength: Some(Strength::Yield(4.0)),
            ..MaterialLimits::default()
        }];

        let points = stress_points_csv(&section, &limits, &recovery);
        let rows = rows_of(&points);
        assert_eq!(rows.len(), 8);
        let column = |name: &str| {
            let heading = csv::Reader::from_reader(points.as_bytes())
                .headers()
                .unwrap()
                .clone();
            heading.iter().position(|known| known == name).unwrap()
        };
        for row in &rows {
            let value = |name: &str| row[column(name)].parse::<f64>().unwrap();
            assert_eq!(&row[1], "with, comma");
            for (name, expected) in [
                ("area [m^2]", 0.25),
                ("stress_xx [Pa]", 2.0),
                ("strain_xx [-]", 2.0),
                ("von_mises [Pa]", 2.0),
                ("von_mises_index [-]", 0.5),
                ("von_mises_reserve_factor [-]", 2.0),
            ] {
                // the digits that are written
                assert!((value(name) - expected).abs() < 1e-8, "{name}");
            }
            assert_eq!(&row[column("von_mises_mode")], "yielding");
        }
        assert_eq!(rows_of(&stress_cells_csv(&section, &recovery)).len(), 2);
        let nodes = rows_of(&stress_nodes_csv(&section, &recovery));
        assert_eq!(nodes.len(), 6);
        assert_eq!(&nodes[5][0], "6");
    }

    fn rows_of(text: &str) -> Vec<csv::StringRecord> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        reader.records().map(Result::unwrap).collect()
    }
}
