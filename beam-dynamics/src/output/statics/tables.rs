//! Tables of a load path for programs: displacements, internal forces, reactions,
//! electrodes.

use shared_geom::rotation::vector;

use crate::output::air::air_csv;
use crate::output::rows::{csv_text, number, numbers};
use crate::output::structure::Structure;
use crate::result::{StaticResult, StaticStep};

const DISPLACEMENTS: &str = "step,factor [-],node,x [m],y [m],z [m],displacement x [m],\
    displacement y [m],displacement z [m],rotation x [deg],rotation y [deg],rotation z [deg]";
const FORCES: &str = "step,factor [-],member,beam,xi [-],arc [m],x [m],y [m],z [m],axial [N],\
    shear y [N],shear z [N],torsion [N m],bending y [N m],bending z [N m],strain axial [-],\
    strain shear y [-],strain shear z [-],strain torsion [1/m],strain bending y [1/m],\
    strain bending z [1/m]";
const REACTIONS: &str = "step,factor [-],joint,node,force x [N],force y [N],force z [N],\
    moment x [N m],moment y [N m],moment z [N m]";
const ELECTRODES: &str = "step,factor [-],electrode,voltage [V],charge [C]";

/// Number and factor of each step, with the step.
fn steps(result: &StaticResult) -> impl Iterator<Item = ([String; 2], &StaticStep)> {
    let steps = result.steps.iter().enumerate();
    steps.map(|(index, step)| ([index.to_string(), number(step.factor)], step))
}

/// One row per step and node: position, displacement, and the rotation vector from the undeformed
/// attitude in degrees, all in the axes of the model.
pub fn displacement_csv(result: &StaticResult) -> String {
    let rows = steps(result).flat_map(|(lead, step)| {
        result.nodes.iter().enumerate().map(move |(k, node)| {
            let moved = step.positions[k] - node.position;
            let turned = step.rotations[k] * node.rotation.transpose();
            let degrees = vector::from_rotation(&turned).map(f64::to_degrees);
            let mut row = lead.to_vec();
            row.push(node.label.clone());
            row.extend(numbers(&step.positions[k]));
            row.extend(numbers(&moved));
            row.extend(numbers(&degrees));
            row
        })
    });
    csv_text(DISPLACEMENTS, rows)
}

/// One row per step and evaluation point: beam and position in it, arc position along the blade or
/// line of beams, position in the axes of the model, internal force and generalized strain in
/// section axes.
pub fn force_csv(result: &StaticResult) -> String {
    let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
    let rows = steps(result).flat_map(|(lead, step)| {
        let along = structure.along(&step.sections);
        let row = |(section, (member, arc)): (&crate::elements::SectionState, (usize, f64))| {
            let mut row = lead.to_vec();
            row.push(structure.members[member].name.clone());
            row.extend([section.beam.to_string(), number(section.xi), number(arc)]);
            row.extend(numbers(&section.position));
            row.extend(numbers(&section.internal_force));
            row.extend(numbers(&section.strain));
            row
        };
        step.sections.iter().zip(along).map(row).collect::<Vec<_>>()
    });
    csv_text(FORCES, rows)
}

/// One row per step and joint: force and moment on its node, about the node, in the axes of the
/// model.
pub fn reaction_csv(result: &StaticResult) -> String {
    let rows = steps(result).flat_map(|(lead, step)| {
        step.reactions.iter().map(move |reaction| {
            let mut row = lead.to_vec();
            row.push(reaction.joint.clone());
            row.push(result.nodes[reaction.node].label.clone());
            row.extend(numbers(&reaction.force));
            row.extend(numbers(&reaction.moment));
            row
        })
    });
    csv_text(REACTIONS, rows)
}

/// One row per step and electrode: its voltage relative to ground and its free charge.
pub fn electrode_csv(result: &StaticResult) -> String {
    let rows = steps(result).flat_map(|(lead, step)| {
        step.electrodes.iter().map(move |electrode| {
            let mut row = lead.to_vec();
            row.push(electrode.name.clone());
            row.extend([electrode.voltage, electrode.charge].map(number));
            row
        })
    });
    csv_text(ELECTRODES, rows)
}

/// One row per step and strip in the air: flow, coefficients and loads.
pub fn static_air_csv(result: &StaticResult) -> String {
    let groups = steps(result).map(|(lead, step)| (lead.to_vec(), &step.air[..]));
    air_csv("step,factor [-]", groups)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    fn lines(text: &str) -> Vec<&str> {
        text.lines().collect()
    }

    // At 60 degrees over 10 m the tip is at (L / a) (sin a, 0, 1 - cos a), with
    // 0.002 (100 + 100) m toward y.
    #[test]
    fn displacements_of_every_node_at_every_step() {
        let text = displacement_csv(&samples::bent(&[0.0, 1.0]));
        let lines = lines(&text);
        assert_eq!(lines.len(), 1 + 2 * 10);
        assert_eq!(
            lines[0],
            "step,factor [-],node,x [m],y [m],z [m],displacement_x [m],displacement_y [m],\
             displacement_z [m],rotation_x [deg],rotation_y [deg],rotation_z [deg]"
        );
        assert_eq!(lines[9], "0,0,n8,10,0,0,0,0,0,0,0,0");
        assert_eq!(
            lines[19],
            "1,1,n8,8.269933431,0.4,4.774648293,-1.730066569,0.4,4.774648293,0,-60,0"
        );
    }

    // The last evaluation point of made-up xi 0.5: 10 m / 8 * 7.5 along the blade.
    #[test]
    fn internal_forces_at_every_evaluation_point() {
        let text = force_csv(&samples::bent(&[0.0, 0.5]));
        let lines = lines(&text);
        assert_eq!(lines.len(), 1 + 2 * 8);
        assert_eq!(lines[0].split(',').count(), 21);
        let last: Vec<_> = lines[16].split(',').collect();
        assert_eq!(last[..6], ["1", "0.5", "blade", "blade/4", "0.5", "9.375"]);
        assert_eq!(last[9..15], ["40", "-2.5", "500", "10", "-312.5", "1.5625"]);
        assert_eq!(last[15..18], ["4e-5", "-2.5e-6", "5e-4"]);
    }

    #[test]
    fn reactions_of_every_joint() {
        let text = reaction_csv(&samples::bent(&[0.0, 1.0]));
        let expected = "\
step,factor [-],joint,node,force_x [N],force_y [N],force_z [N],moment_x [N m],moment_y [N m],moment_z [N m]
0,0,clamp of n0,n0,0,0,0,0,0,0
1,1,clamp of n0,n0,-80,5,-1000,-20,10000,-50
";
        assert_eq!(text, expected);
    }
}
