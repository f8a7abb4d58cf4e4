//! Report of voltages, charges and electric fields of a recovery.

use super::round_off::size;
use super::text::{ZERO, coordinate, number, table};
use crate::recovery::{ElectricRecovery, Recovery};
use crate::section::Section;

/// The part of the report; empty without electrodes.
pub(super) fn electrodes(section: &Section, recovery: &Recovery) -> String {
    let Some(electric) = &recovery.electric else {
        return String::new();
    };
    let voltages = voltages(section, electric);
    let fields = fields(section, recovery, electric);
    format!("{voltages}\n{fields}")
}

fn voltages(section: &Section, electric: &ElectricRecovery) -> String {
    let heading = ["electrode", "voltage [V]", "charge per length [C/m]"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let shown = |value: f64, scale: f64| {
        number(if value.abs() <= ZERO * scale {
            0.0
        } else {
            value
        })
    };
    let scale = largest(&electric.voltages);
    for (index, electrode) in section.electrodes.iter().enumerate() {
        let charge = electric
            .charges
            .as_ref()
            .map_or_else(String::new, |charges| {
                shown(charges[index], electric.charge_scale)
            });
        rows.push(vec![
            electrode.name.clone(),
            shown(electric.voltages[index], scale),
            charge,
        ]);
    }
    let note = match electric.charges {
        Some(_) => "",
        None => "  (charges under imposed strains and loads along the beam are not known)\n",
    };
    format!("Electrodes\n{}{note}", table(&rows, "lr"))
}

/// The largest field of each region that has a field.
fn fields(section: &Section, recovery: &Recovery, electric: &ElectricRecovery) -> String {
    let heading = [
        "region",
        "largest field [V/m]",
        "cell",
        "y [m]",
        "z [m]",
        "mean",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let size = size(section);
    for (group, name) in section.mesh.groups.iter().enumerate() {
        let points = recovery.points.iter().zip(&electric.points);
        let in_region = points.filter(|(point, _)| {
            electric.has_field[point.cell] && section.mesh.cells[point.cell].group == group
        });
        let (mut sum, mut area, mut most) = (0.0, 0.0, None);
        for (point, state) in in_region {
            let field = state.field.norm();
            sum += point.area * field;
            area += point.area;
            if most.is_none_or(|(known, _)| field > known) {
                most = Some((field, point));
            }
        }
        let Some((field, point)) = most else {
            continue;
        };
        let mut row = vec![name.clone()];
        if field <= ZERO * electric.field_scale {
            row.extend(["0", "", "", "", "0"].map(str::to_owned));
        } else {
            let [y, z] = point.position.map(|x| coordinate(x, size));
            let tag = section.mesh.cells[point.cell].tag.to_string();
            row.extend([number(field), tag, y, z, number(sum / area)]);
        }
        rows.push(row);
    }
    format!(
        "Electric field, its size at integration points\n{}",
        table(&rows, "lr")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::recovery::{LoadCase, recover};
    use crate::section::Circuit;
    use crate::section::piezo_samples::layer;
    use nalgebra::Vector6;

    /// A layer in tension. Held: a charge and no voltage; open: a voltage, and charges of
    /// exactly zero instead of round-off.
    #[test]
    fn open_electrodes_have_no_charge() {
        let mut section = layer();
        let load = LoadCase::at_point("pull", &Vector6::ith(0, 5.0), [0.0; 2]);
        let mut words = |circuit| {
            section.electrodes[1].circuit = circuit;
            let recovery = recover(&section, &analyze(&section).unwrap(), &load).unwrap();
            let text = electrodes(&section, &recovery);
            let row = text.lines().find(|line| line.starts_with("  top")).unwrap();
            let row: Vec<_> = row.split_whitespace().map(str::to_owned).collect();
            (row[1].clone(), row[2].clone(), text)
        };
        let (voltage, charge, text) = words(Circuit::Driven);
        assert_eq!(voltage, "0");
        // -d31 F / h: on the upper conductor, whose normal into the layer is -z
        assert_eq!(charge, "1.37000e-6");
        assert!(
            text.contains("Electric field, its size at integration points"),
            "{text}"
        );
        let (voltage, charge, _) = words(Circuit::Floating);
        assert!(voltage.parse::<f64>().unwrap() < 0.0);
        assert_eq!(charge, "0");
    }
}
