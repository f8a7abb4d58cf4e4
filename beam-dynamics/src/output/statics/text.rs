//! A load path as text for a report.

use nalgebra::Vector3;
use shared_geom::rotation::vector;
use shared_geom::wrench::COMPONENTS;

use super::floors::{Floors, ROUND_OFF, clean, clean_vector};
use crate::elements::{ElectrodeState, SectionState};
use crate::input::short_number;
use crate::output::air::rotor_text;
use crate::output::structure::Structure;
use crate::output::text::{RPM, aligned};
use crate::result::{StaticResult, StaticStep};

/// Steps listed; the tables for programs contain all.
const MOST_STEPS: usize = 20;
/// Nodes listed; of more nodes, the ends of blades and lines of beams.
const MOST_NODES: usize = 12;
/// Digits of quantities.
const DIGITS: usize = 6;
const UNITS: [&str; 6] = ["N", "N", "N", "N m", "N m", "N m"];

/// Meaning of the numbers of the report.
pub const STATIC_CONVENTION: &str = "\
Convention
  axes            axes of the model; for internal forces axes of the section: x along the
                  beam, y toward the leading edge, z up
  factor          of the proportional loads; constant loads and gravity act in full
  displacement    from the undeformed position
  rotation        rotation vector from the undeformed attitude
  internal force  force of the outer part of the beam on the inner one
  reaction        force of a joint on its node, moments about the node
  voltage         of an electrode relative to ground
  charge          free charge of an electrode
  air             thrust along the axis of the hub, torque about it and power, of the air on
                  the blades; coefficients of torque and power of rotors and propellers are
                  of the torque that the shaft provides
  s               arc position along the undeformed blade or line of beams, from its root
";

/// Steps, displacements, largest internal forces, electrodes, reactions, remarks; see
/// [`STATIC_CONVENTION`].
pub fn static_text(result: &StaticResult) -> String {
    let at_speed = match result.speed {
        0.0 => String::new(),
        speed => format!(" at {} rpm", short_number(speed * RPM, DIGITS)),
    };
    let mut text = format!("{}\n\nEquilibria{at_speed}\n\n", result.name);
    let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
    text.push_str(&step_table(result, &structure));
    if let Some(last) = result.last() {
        let at = loads_of(last, DIGITS);
        let floors = Floors::new(last, structure.size(), ROUND_OFF);
        let (title, table) = displacement_table(result, &structure, (last, &floors));
        text.push_str(&format!("\n{title} {at}\n\n{table}"));
        if !last.sections.is_empty() {
            let table = force_table(&structure, (last, &floors));
            text.push_str(&format!("\nLargest internal forces {at}\n\n{table}"));
        }
        if !last.electrodes.is_empty() {
            let table = electrode_table(&last.electrodes);
            text.push_str(&format!("\nElectrodes {at}\n\n{table}"));
        }
        text.push_str(&rotor_text(&last.air));
        if !last.reactions.is_empty() {
            let table = reaction_table(result, (last, &floors));
            text.push_str(&format!("\nReactions {at}\n\n{table}"));
        }
    }
    if !result.remarks.is_empty() {
        text.push_str("\nRemarks\n");
        for remark in &result.remarks {
            text.push_str(&format!("  {remark}\n"));
        }
    }
    text
}

fn cells(cells: &[&str]) -> Vec<String> {
    cells.iter().map(|&cell| cell.to_owned()).collect()
}

fn short(value: f64) -> String {
    short_number(value, DIGITS)
}

/// Node of the largest displacement in a step, and this displacement \[m\].
pub(super) fn most_displaced(result: &StaticResult, step: &StaticStep) -> (usize, f64) {
    let moved = result.nodes.iter().zip(&step.positions).enumerate();
    moved
        .map(|(k, (node, position))| (k, (position - node.position).norm()))
        // The first of equal ones.
        .rev()
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or((0, 0.0))
}

/// The loads of a step as the end of a title, with a number of digits.
pub(super) fn loads_of(step: &StaticStep, digits: usize) -> String {
    match step.factor {
        0.0 => "under the constant loads".to_owned(),
        factor => format!("at factor {}", short_number(factor, digits)),
    }
}

fn step_table(result: &StaticResult, structure: &Structure) -> String {
    if result.steps.is_empty() {
        return "  no equilibrium was reached\n".to_owned();
    }
    let mut rows = vec![
        cells(&[
            "step",
            "factor",
            "iterations",
            "residual",
            "largest displacement",
            "of node",
        ]),
        cells(&["", "[-]", "", "[-]", "[m]", ""]),
    ];
    let count = result.steps.len();
    let every = count.div_ceil(MOST_STEPS);
    for (index, step) in result.steps.iter().enumerate() {
        if index % every != 0 && index + 1 != count {
            continue;
        }
        let (node, moved) = most_displaced(result, step);
        let moved = clean(moved, ROUND_OFF * structure.size());
        let node = result.nodes.get(node).filter(|_| moved > 0.0);
        let label = node.map_or("-", |node| &node.label);
        rows.push(vec![
            index.to_string(),
            short(step.factor),
            step.iterations.to_string(),
            format!("{:.1e}", step.residual),
            short(moved),
            label.to_owned(),
        ]);
    }
    let shown = match every {
        1 => String::new(),
        _ => format!("\none in {every} of {count} steps\n"),
    };
    aligned(&rows) + &shown
}

/// All nodes, or the ends of members if there are many; with a title.
fn displacement_table(
    result: &StaticResult,
    structure: &Structure,
    (step, floors): (&StaticStep, &Floors),
) -> (&'static str, String) {
    let all: Vec<_> = (0..result.nodes.len()).collect();
    let (title, nodes) = if all.len() <= MOST_NODES {
        ("Displacements", all)
    } else {
        let ends = structure.members.iter().flat_map(|member| {
            let stations = structure.stations(member);
            let ends = [stations.first(), stations.last()];
            ends.map(|end| end.map(|end| end.1))
        });
        let mut ends: Vec<_> = ends.flatten().collect();
        ends.sort_unstable();
        ends.dedup();
        ("Displacements of ends", ends)
    };
    let mut rows = vec![
        cells(&["node", "", "displacement", "", "", "rotation", ""]),
        cells(&[
            "", "x [m]", "y [m]", "z [m]", "x [deg]", "y [deg]", "z [deg]",
        ]),
    ];
    for node in nodes {
        let undeformed = &result.nodes[node];
        let moved = clean_vector(
            &(step.positions[node] - undeformed.position),
            floors.displacement,
        );
        let turned = step.rotations[node] * undeformed.rotation.transpose();
        let turned = clean_vector(&vector::from_rotation(&turned), floors.rotation);
        let degrees = turned.map(f64::to_degrees);
        let mut row = vec![undeformed.label.clone()];
        row.extend(moved.iter().map(|value| short(*value)));
        row.extend(degrees.iter().map(|value| short(*value)));
        rows.push(row);
    }
    (title, aligned(&rows))
}

/// The largest value by magnitude for each member and component, and its position.
fn force_table(structure: &Structure, (step, floors): (&StaticStep, &Floors)) -> String {
    let along = structure.along(&step.sections);
    let mut rows = vec![cells(&["component", "largest", "", "s [m]", "beam", "of"])];
    for (number, member) in structure.members.iter().enumerate() {
        let own = || {
            let positions = along.iter().zip(&step.sections);
            positions.filter(|((of, _), _)| *of == number)
        };
        for (component, name) in COMPONENTS.iter().enumerate() {
            let floor = floors.of_component(component);
            let value = |section: &SectionState| clean(section.internal_force[component], floor);
            let size = |section: &SectionState| value(section).abs();
            // The first of equal ones.
            let largest = own().rev().max_by(|a, b| size(a.1).total_cmp(&size(b.1)));
            let Some(((_, arc), section)) = largest else {
                continue;
            };
            rows.push(vec![
                (*name).to_owned(),
                short(value(section)),
                UNITS[component].to_owned(),
                short(*arc),
                section.beam.to_string(),
                member.name.clone(),
            ]);
        }
    }
    aligned(&rows)
}

fn electrode_table(electrodes: &[ElectrodeState]) -> String {
    let mut rows = vec![
        cells(&["electrode", "voltage", "charge"]),
        cells(&["", "[V]", "[C]"]),
    ];
    rows.extend(electrodes.iter().map(|electrode| {
        let numbers = [electrode.voltage, electrode.charge].map(short);
        [vec![electrode.name.clone()], numbers.to_vec()].concat()
    }));
    aligned(&rows)
}

fn reaction_table(result: &StaticResult, (step, floors): (&StaticStep, &Floors)) -> String {
    let mut rows = vec![
        cells(&["joint", "", "force", "", "", "moment", ""]),
        cells(&[
            "", "x [N]", "y [N]", "z [N]", "x [N m]", "y [N m]", "z [N m]",
        ]),
    ];
    for reaction in &step.reactions {
        let label = result
            .nodes
            .get(reaction.node)
            .map_or("", |node| &node.label);
        let name = if reaction.joint.contains(label) {
            reaction.joint.clone()
        } else {
            format!("{} on {label}", reaction.joint)
        };
        let mut row = vec![name];
        let both: [Vector3<f64>; 2] = [
            clean_vector(&reaction.force, floors.force),
            clean_vector(&reaction.moment, floors.moment),
        ];
        row.extend(
            both.iter()
                .flat_map(|v| v.iter().map(|value| short(*value))),
        );
        rows.push(row);
    }
    aligned(&rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn the_report_has_steps_displacements_forces_and_reactions() {
        let text = static_text(&samples::bent(&[0.0, 1.0]));
        let expected = "\
bent blade

Equilibria

step  factor  iterations  residual  largest displacement  of node
         [-]                   [-]                   [m]
0          0           4   2.0e-13                     0        -
1          1           4   2.0e-13               5.09415       n8

Displacements at factor 1

node               displacement                      rotation
            x [m]         y [m]      z [m]  x [deg]   y [deg]  z [deg]
n0              0             0          0        0         0        0
n1    -0.00356668      0.028125  0.0816956        0      -7.5        0
n2     -0.0284602        0.0625   0.325384        0       -15        0
n3     -0.0956424      0.103125   0.726897        0     -22.5        0
n4      -0.225352          0.15    1.27936        0       -30        0
n5      -0.436757      0.203125    1.97333        0     -37.5        0
n6      -0.747628        0.2625    2.79692        0       -45        0
n7       -1.17403      0.328125    3.73605        0     -52.5        0
n8       -1.73007           0.4    4.77465        0       -60        0
n9              0             0          0        0         0        0

Largest internal forces at factor 1

component  largest       s [m]     beam     of
axial           80    N  0.625  blade/1  blade
shear y         -5    N  0.625  blade/1  blade
shear z       1000    N  0.625  blade/1  blade
torsion         20  N m  0.625  blade/1  blade
bending y    -9375  N m  0.625  blade/1  blade
bending z   46.875  N m  0.625  blade/1  blade

Reactions at factor 1

joint               force                   moment
             x [N]  y [N]  z [N]  x [N m]  y [N m]  z [N m]
clamp of n0    -80      5  -1000      -20    10000      -50

Remarks
  made up
";
        assert_eq!(text, expected);
        assert!(STATIC_CONVENTION.lines().all(|line| line.len() <= 96));
    }

    #[test]
    fn many_steps_are_thinned_and_many_nodes_are_ends() {
        let factors: Vec<_> = (0..=100).map(|k| f64::from(k) / 100.0).collect();
        let mut result = samples::bent(&factors);
        let text = static_text(&result);
        assert!(text.contains("\none in 6 of 101 steps\n"), "{text}");
        assert!(text.contains("\n100 "), "{text}");
        for k in 0..3 {
            let mut node = result.nodes[9].clone();
            node.label = format!("m{k}");
            result.nodes.push(node);
            for step in &mut result.steps {
                step.positions.push(step.positions[9]);
                step.rotations.push(step.rotations[9]);
            }
        }
        let text = static_text(&result);
        assert!(text.contains("Displacements of ends at factor 1"), "{text}");
        assert!(text.contains("\nn8 ") && !text.contains("\nn4 "), "{text}");
    }

    // Residues of zero after the iteration: 1e-13 of 1 kN, 5e-40 m.
    #[test]
    fn round_off_is_reported_as_zero() {
        let clean = samples::bent(&[0.0, 1.0]);
        let mut noisy = clean.clone();
        let last = noisy.steps.last_mut().unwrap();
        last.positions[9].y += 1e-13;
        last.positions[0].z += 5.05e-40;
        last.rotations[9] = vector::to_rotation(&Vector3::new(3e-15, 0.0, 0.0));
        last.reactions[0].force.y += 1e-10;
        assert_eq!(static_text(&noisy), static_text(&clean));
        for step in &mut noisy.steps {
            for section in &mut step.sections {
                section.internal_force[1] = 4e-10;
            }
        }
        let text = static_text(&noisy);
        assert!(text.contains("shear y          0    N"), "{text}");
    }

    #[test]
    fn nothing_reached_is_said() {
        let mut result = samples::bent(&[]);
        result.speed = 10.0 / RPM;
        let text = static_text(&result);
        assert!(
            text.contains("Equilibria at 10 rpm\n\n  no equilibrium was reached"),
            "{text}"
        );
    }
}
