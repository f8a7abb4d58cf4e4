//! Effect of voltages on a section, as a report and as a table.

use nalgebra::Vector6;
use shared_geom::section::SectionProperties;
use shared_geom::wrench::COMPONENTS;

use super::round_off::without_round_off;
use super::text::{ZERO, csv, number, table};
use crate::properties::radius_of_gyration;
use crate::section::Circuit;
use crate::solution::{ElectrodeSolution, PiezoChecks, PiezoSolution, SectionSolution};

/// Names of circuits in reports.
fn circuit(electrode: &ElectrodeSolution) -> &'static str {
    match electrode.circuit {
        Circuit::Driven => "driven",
        Circuit::Ground => "ground",
        Circuit::Floating => "open",
    }
}

/// The part of the report on voltages; empty without electrodes. `solution` is at
/// constant voltage, `properties` are the properties as written.
pub fn piezo_report(solution: &SectionSolution, properties: &SectionProperties) -> String {
    let Some(piezo) = &solution.piezo else {
        return String::new();
    };
    let length = radius_of_gyration(properties);
    let parts = [
        in_circuit(piezo, solution),
        per_volt(piezo, length),
        capacitances(piezo),
        stiffnesses(piezo, solution),
        checks(&piezo.checks),
    ];
    let parts: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join("\n")
}

/// The open electrodes and their effect; empty without open electrodes.
fn in_circuit(piezo: &PiezoSolution, solution: &SectionSolution) -> String {
    if !solution.has_open_electrodes() {
        return String::new();
    }
    let open = piezo.electrodes.iter().filter(|known| known.is_open());
    let open: Vec<_> = open.map(|known| known.name.as_str()).collect();
    format!(
        "Circuit\n  open, at no charge: {}\n  stiffness, engineering values, centers and axes \
         above and in the property file are with\n  these open; the following is at constant \
         voltage, one volt at one electrode at a time\n",
        open.join(", ")
    )
}

/// Electrodes that are not at ground, with their indices.
fn free_electrodes(piezo: &PiezoSolution) -> Vec<(usize, &ElectrodeSolution)> {
    let all = piezo.electrodes.iter().enumerate();
    all.filter(|(_, known)| known.circuit != Circuit::Ground)
        .collect()
}

/// Coupling and free strain; moments divided by `length`, the size of the section \[m\], are
/// comparable with forces.
fn per_volt(piezo: &PiezoSolution, length: f64) -> String {
    let electrodes = free_electrodes(piezo);
    let block = |title: &str, column: &dyn Fn(&ElectrodeSolution) -> Vector6<f64>| {
        let names = electrodes.iter().map(|(_, known)| known.name.clone());
        let mut rows = vec![std::iter::once(String::new()).chain(names).collect()];
        let columns: Vec<_> = electrodes.iter().map(|(_, known)| column(known)).collect();
        for (i, component) in COMPONENTS.iter().enumerate() {
            let values = columns.iter().map(|values| number(values[i]));
            let name = std::iter::once((*component).to_owned());
            rows.push(name.chain(values).collect::<Vec<_>>());
        }
        format!("{title}\n{}", table(&rows, "lr"))
    };
    let coupling = block(
        "Coupling, internal force per volt at zero generalized strain [N/V, N m/V]",
        &|known| without_round_off(&known.coupling, 1.0 / length, 0.0),
    );
    let strain = block(
        "Free strain, generalized strain per volt without internal force [1/V, 1/(V m)]",
        &|known| without_round_off(&known.free_strain, length, 0.0),
    );
    format!("{coupling}\n{strain}")
}

/// Both capacitances, one below the other.
fn capacitances(piezo: &PiezoSolution) -> String {
    let electrodes = free_electrodes(piezo);
    let block = |title: &str, matrix: &nalgebra::DMatrix<f64>| {
        let names = electrodes.iter().map(|(_, known)| known.name.clone());
        let mut rows = vec![std::iter::once(String::new()).chain(names).collect()];
        for (i, known) in &electrodes {
            let values = electrodes.iter().map(|(j, _)| {
                let value = matrix[(*i, *j)];
                let scale = (matrix[(*i, *i)] * matrix[(*j, *j)]).abs().sqrt();
                number(if value.abs() <= ZERO * scale {
                    0.0
                } else {
                    value
                })
            });
            let name = std::iter::once(known.name.clone());
            rows.push(name.chain(values).collect::<Vec<_>>());
        }
        format!("{title}\n{}", table(&rows, "lr"))
    };
    let held = block(
        "Capacitance, charge per length and volt at zero generalized strain [F/m]",
        &piezo.capacitance,
    );
    let free = block(
        "The same at zero internal force [F/m]",
        &piezo.free_capacitance,
    );
    format!("{held}\n{free}")
}

/// Stiffness at constant voltage, and with all electrodes except those at ground open.
fn stiffnesses(piezo: &PiezoSolution, solution: &SectionSolution) -> String {
    let open = piezo.in_circuit(&solution.stiffness, |electrode| {
        match piezo.electrodes[electrode].circuit {
            Circuit::Ground => Circuit::Ground,
            _ => Circuit::Floating,
        }
    });
    let title = "Stiffness at constant voltage (short circuit) and with all electrodes except \
                 those at ground open\n";
    let Some(open) = open else {
        return format!(
            "{title}  not given: no electrode is at ground, so a voltage common to all is undetermined\n"
        );
    };
    let heading = ["", "", "short", "open", "1 - short/open"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for (i, component) in COMPONENTS.iter().enumerate() {
        let (short, open) = (solution.stiffness[(i, i)], open.stiffness[(i, i)]);
        let factor = 1.0 - short / open;
        rows.push(vec![
            (*component).to_owned(),
            format!("K{0}{0}", i + 1),
            number(short),
            number(open),
            match factor.abs() {
                ..=ZERO => "0".to_owned(),
                ..1e-6 => format!("{factor:.1e}"),
                _ => format!("{factor:.6}"),
            },
        ]);
    }
    format!(
        "{title}{}  (the last column is the square of the coupling factor, other generalized \
         strains zero)\n",
        table(&rows, "llr")
    )
}

fn checks(checks: &PiezoChecks) -> String {
    let row = |name: &str, value: f64| vec![name.to_owned(), format!("{value:.1e}")];
    let rows = [
        row("free strains by the work on the six solutions", checks.work),
        row("symmetry of the capacitance", checks.asymmetry),
        row(
            "no effect of a voltage common to all conductors",
            checks.common,
        ),
    ];
    format!(
        "Checks of the voltages (relative errors)\n{}",
        table(&rows, "lr")
    )
}

/// A row per electrode, at constant voltage of the others: circuit, coupling, free
/// strain, and both capacitances with each electrode.
pub fn electrodes_csv(piezo: &PiezoSolution) -> String {
    let with_unit = |what: &str, units: [&str; 2]| {
        let names = COMPONENTS.iter().enumerate();
        let names = names.map(|(i, name)| {
            let unit = units[usize::from(i >= 3)];
            format!("{what}_{} [{unit}]", name.replace(' ', "_"))
        });
        names.collect::<Vec<_>>()
    };
    let of_each = |what: &str| {
        let names = piezo.electrodes.iter();
        names
            .map(|known| format!("{what}_{} [F/m]", known.name))
            .collect::<Vec<_>>()
    };
    let heading = [
        vec!["electrode".to_owned(), "circuit".to_owned()],
        with_unit("coupling", ["N/V", "N m/V"]),
        with_unit("free_strain", ["1/V", "1/(V m)"]),
        of_each("capacitance"),
        of_each("free_capacitance"),
    ];
    let rows = piezo.electrodes.iter().enumerate().map(|(row, known)| {
        let [held, free] = [&piezo.capacitance, &piezo.free_capacitance]
            .map(|matrix| matrix.row(row).into_owned());
        let values = known.coupling.iter().chain(&known.free_strain);
        let values = values.chain(held.iter()).chain(free.iter());
        let names = [known.name.clone(), circuit(known).to_owned()];
        let shown = values.map(|value| format!("{value:.8e}"));
        names.into_iter().chain(shown).collect()
    });
    csv(std::iter::once(heading.concat()).chain(rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::output::properties;
    use crate::section::piezo_samples::{bimorph, k31, layer};
    use crate::solution::ImposedSolutions;

    /// EA of the layer stiffens by `1 / (1 - k31^2)`; the table has a row per electrode.
    #[test]
    fn report_and_table_say_what_the_solution_holds() {
        let section = layer();
        let solution = analyze(&section).unwrap();
        let written = properties(&section, &solution, &ImposedSolutions::default(), "");
        let text = piezo_report(&solution, &written);
        let axial = text.lines().filter(|line| line.starts_with("  axial"));
        let axial: Vec<Vec<_>> = axial.map(|l| l.split_whitespace().collect()).collect();
        let coupling = solution.piezo.as_ref().unwrap().electrodes[1].coupling[0];
        assert_eq!(axial[0], ["axial", &number(coupling)]);
        assert_eq!(axial[2][4], format!("{:.6}", k31()));
        assert!(!text.contains("Circuit") && !text.contains("bottom"));
        assert!(text.contains("no effect of a voltage common to all conductors"));

        let table = electrodes_csv(solution.piezo.as_ref().unwrap());
        let rows: Vec<Vec<_>> = table.lines().map(|l| l.split(',').collect()).collect();
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0][2], "coupling_axial [N/V]");
        assert_eq!(rows[0][16], "free_capacitance_bottom [F/m]");
        assert_eq!(rows[2][..3], ["top", "driven", &format!("{coupling:.8e}")]);
        assert_eq!(
            piezo_report(
                &SectionSolution {
                    piezo: None,
                    ..solution
                },
                &written
            ),
            ""
        );
    }

    /// With an open electrode, properties and report refer to the circuit: the driven
    /// electrode remains, with its coupling by (S-169).
    #[test]
    fn open_electrodes_are_condensed_in_properties_and_reported() {
        let mut section = bimorph();
        let held = analyze(&section).unwrap();
        let none = ImposedSolutions::default();
        let all = properties(&section, &held, &none, "").piezo.unwrap();
        assert_eq!(all.electrodes, ["top", "bottom"]);
        section.electrodes[2].circuit = Circuit::Floating;
        let solution = analyze(&section).unwrap();
        let written = properties(&section, &solution, &none, "");
        assert_eq!(written.problems(), []);
        let piezo = written.piezo.as_ref().unwrap();
        assert_eq!(piezo.electrodes, ["top"]);
        let lower = all.coupling.column(1).into_owned();
        let (mutual, own) = (all.capacitance[(0, 1)], all.capacitance[(1, 1)]);
        let expected = all.coupling.column(0) - &lower * (mutual / own);
        assert!((piezo.coupling.column(0) - &expected).amax() < 1e-12 * expected.amax());
        let more = &lower * lower.transpose() / own;
        let found = written.stiffness - held.stiffness;
        for (found, expected) in found.iter().zip(more.iter()) {
            assert!((found - expected).abs() < 1e-12 * held.stiffness.amax());
        }
        let text = piezo_report(&solution, &written);
        assert!(
            text.starts_with("Circuit\n  open, at no charge: bottom\n"),
            "{text}"
        );
    }
}
