//! Tests of the cards of hinges, rigid connections, springs, hubs that move, and damping.

use nalgebra::Vector3;

use super::Input;
use super::test_files::{STRIP, read_beside};
use crate::model::{Conditions, Variable};

const NODES: &str = "
[[node]]
name = \"root\"
position = [0, 0, 0]
[[node]]
name = \"mid\"
position = [1, 0, 0]
[[node]]
name = \"tip\"
position = [2, 0, 0]
[[node]]
name = \"mast\"
position = [-1, 0, 0]
[[beam]]
name = \"beam\"
nodes = [\"root\", \"mid\", \"tip\"]
properties = \"strip\"
";

/// Reads the cards after the units `units` and the strip.
fn input_in(units: &str, cards: &str) -> Result<Input, String> {
    read_beside(&format!("{units}\n{STRIP}{cards}"), &[])
}

fn input(cards: &str) -> Result<Input, String> {
    input_in("units = \"SI\"", cards)
}

/// `d row / d column` of a node in the tangent at rest.
fn entry(input: &Input, row: usize, column: usize, by_rates: bool) -> f64 {
    let system = &input.model.system;
    let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
    let matrix = if by_rates {
        tangent.by_rates
    } else {
        tangent.by_unknowns
    };
    let found = matrix
        .triplets()
        .find(|(i, j, _)| (*i, *j) == (row, column));
    found.map_or(0.0, |found| found.2)
}

#[test]
fn a_hinge_joins_two_nodes_and_a_free_one_is_remarked() {
    let cards = format!(
        "{NODES}[[clamp]]\nnode = \"mast\"\n[[hinge]]\nname = \"flap\"\n\
         nodes = [\"mast\", \"root\"]\naxis = [0, 2, 0]\noffset = [-0.5, 0, 0]\n"
    );
    let free = input(&cards).unwrap();
    let remark = "joint \"flap\" can move freely: at rest this is a motion of frequency zero";
    // The strip has the density of no light metal, which is reported first.
    let [density, hinge] = &free.remarks[..] else {
        panic!("{:?}", free.remarks);
    };
    assert!(density.starts_with("properties \"strip\": stiffness over mass is 3.500e6"));
    assert_eq!(hinge, remark);
    let sprung = input(&format!("{cards}stiffness = 20\ndamping = 3\nangle = 5\n")).unwrap();
    assert_eq!(sprung.remarks, [density.as_str()]);
    // The moment about y of the root by its rotation, without the beam: the spring's
    // stiffness.
    let rotation = Variable::Rotation.column();
    let row = |node: usize, axis: usize| 12 * node + 9 + axis;
    let of = |input: &Input, rates| entry(input, row(3, 1), 12 * 3 + rotation + 1, rates);
    // The spring is relaxed at 5 deg: k about the axis, whatever the relaxed angle.
    assert!((of(&sprung, false) - of(&free, false) + 20.0).abs() < 1e-12);
    assert!((of(&sprung, true) - of(&free, true) + 3.0).abs() < 1e-12);
}

// 100 lbf in/rad and 2 lbf in s: whatever the unit of angle, per radian.
#[test]
fn units_of_hinges_and_springs_follow_the_file() {
    const LBF_IN: f64 = 4.448_221_615_260_5 * 0.0254;
    let units = "[units]\nlength = \"in\"\nforce = \"lbf\"\n";
    let cards = format!(
        "{NODES}[[clamp]]\nnode = \"mast\"\n[[hinge]]\nnodes = [\"mast\", \"root\"]\n\
         axis = [0, 0, 1]\nstiffness = 100\ndamping = 2\n\
         [[spring]]\nnode = \"mast\"\nstiffness = [1, 2, 3]\ndamping = [0, 0, 5]\n"
    );
    let found = input_in(units, &cards).unwrap();
    let at =
        |row: usize, column: usize, rates| -entry(&found, 12 * 3 + row, 12 * 3 + column, rates);
    assert!((at(11, 5, false) / (100.0 * LBF_IN) - 1.0).abs() < 1e-12);
    assert!((at(11, 5, true) / (2.0 * LBF_IN) - 1.0).abs() < 1e-12);
    let per_inch = 4.448_221_615_260_5 / 0.0254;
    assert!((at(8, 2, false) / (3.0 * per_inch) - 1.0).abs() < 1e-12);
    assert!((at(8, 2, true) / (5.0 * per_inch) - 1.0).abs() < 1e-12);
}

#[test]
fn a_rigid_connection_holds_what_it_joins() {
    let cards = format!("{NODES}[[clamp]]\nnode = \"mast\"\n");
    let loose = input(&format!("{cards}[[spring]]\nnode = \"mast\"\n")).unwrap_err();
    assert!(loose.contains("free mechanism: node \""), "{loose}");
    let held = format!("{cards}[[rigid]]\nnodes = [\"mast\", \"root\"]\n");
    assert_eq!(
        input(&held).unwrap().model.system.numbering().multipliers(),
        12
    );
}

const HUB: &str = "
[hub]
mass = 50
inertia = [2, 2, 3]
support = { in_plane = 1e4, tilt = 300 }
support_damping = { in_plane = 40 }
[[blade]]
name = \"b\"
root = [0.5, 0, 0]
properties = \"strip\"
[[blade.piece]]
length = 6
elements = 2
";

#[test]
fn a_hub_on_a_support_carries_its_blades() {
    let found = input(HUB).unwrap();
    let system = &found.model.system;
    assert_eq!(system.nodes()[0].label, "hub");
    assert_eq!(system.nodes()[0].position, Vector3::zeros());
    let joints: Vec<_> = system.elements().map(|element| element.label()).collect();
    for label in ["bearing of the hub", "support of the hub", "hub to b/root"] {
        assert!(joints.contains(&label), "{label} is not in {joints:?}");
    }
    // Axial motion and torsion are fixed, and the six rows of the rigid connection.
    assert_eq!(system.numbering().multipliers(), 2 + 6);
    assert_eq!(found.model.naming[0].blade, found.model.naming[1].blade);
    assert!((found.summary.mass - (50.0 + 12.0)).abs() < 1e-9);
    for (row, column, rates, expected) in [
        (6, 0, false, -1e4),
        (7, 1, false, -1e4),
        (8, 2, false, 0.0),
        (9, 3, false, -300.0),
        (11, 5, false, 0.0),
        (6, 0, true, -40.0),
    ] {
        let found = entry(&found, row, column, rates);
        assert!((found - expected).abs() < 1e-9, "{row} {column}: {found}");
    }
}

#[test]
fn a_spring_in_the_world_must_be_the_same_about_the_axis() {
    let spring = |node: &str, stiffness: &str| {
        let clamp = "[[clamp]]\nnode = \"root\"\n";
        format!(
            "{NODES}{clamp}[[rigid]]\nnodes = [\"mast\", \"root\"]\n[[spring]]\n\
             name = \"s\"\nnode = \"{node}\"\nstiffness = {stiffness}\nfixed_to = \"world\"\n"
        )
    };
    assert!(input(&spring("root", "[4, 4, 9]")).is_ok());
    let beside = input(&spring("mast", "[4, 4, 9]")).unwrap_err();
    let expected = "spring \"s\" has fixed_to = \"world\", but node \"mast\" is not on the axis";
    assert!(beside.contains(expected), "{beside}");
    let uneven = input(&spring("root", "[4, 5, 9]")).unwrap_err();
    assert!(
        uneven.contains("is not isotropic about the axis"),
        "{uneven}"
    );
    assert!(uneven.contains("fixed_to = \"frame\""), "{uneven}");
    let turning = spring("mast", "[4, 5, 9]").replace("\"world\"", "\"frame\"");
    assert!(input(&turning).is_ok());
}

#[test]
fn every_wrong_key_of_joints_and_supports_is_reported() {
    let cards = format!(
        "{NODES}[hub]\nmass = 3\n[[clamp]]\nnode = \"root\"\n\
         [[hinge]]\nname = \"h\"\nnodes = [\"root\", \"root\"]\naxis = [0, 0, 0]\n\
         stiffness = -1\nangel = 3\n\
         [[hinge]]\nname = \"g\"\nnodes = [\"root\"]\nangle = 3\n\
         [[rigid]]\nnodes = [\"root\", \"tipp\"]\n\
         [[spring]]\nnode = \"tip\"\nstiffness = [1, -2, 3]\n"
    );
    let shown = input(&cards).unwrap_err();
    for expected in [
        "\"mass\" is a key of a hub that moves, but this one has no \"support\"",
        "hinge \"h\" joins \"root\" to itself, expected two nodes",
        "\"axis\" has no direction",
        "\"stiffness\" is -1, expected a moment, zero or more",
        "unknown key \"angel\"",
        "\"nodes\" lists 1, expected two",
        "has no \"axis\", expected the direction of the axis",
        "\"angle\" is the angle of the relaxed spring, but the hinge has none",
        "unknown node \"tipp\" in rigid connection \"rigid connection 1\"",
        "expected an array of 3, each a force per length, zero or more",
    ] {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
    let shown = input(&cards.replace("tipp", "Ground")).unwrap_err();
    assert!(
        shown.contains("help: the frame of the model is no node"),
        "{shown}"
    );
    let held = HUB.replace("in_plane = 40", "torsion = 40");
    let shown = input(&held).unwrap_err();
    let expected = "\"torsion\" has a damping but no stiffness: the hub is fixed in this direction";
    assert!(shown.contains(expected), "{shown}");
}

/// Rows of `d force / d velocity` of the first node of the blade, for `damping`.
fn axial_viscosity(damping: &str) -> Result<f64, String> {
    let cards =
        format!("[properties.strip.damping]\n{damping}\n{NODES}[[clamp]]\nnode = \"tip\"\n");
    let cards = cards.replace("[[node]]\nname = \"mast\"\nposition = [-1, 0, 0]\n", "");
    Ok(entry(&input(&cards)?, 6, 0, true))
}

// The work of the strain rate with itself, by the velocity of the first node:
// - sum (dN_1/dxi)^2 / J0 = - 2 (1/4 + 1/3), with dN_1/dxi = xi - 1/2 and J0 = 1 m.
#[test]
fn damping_of_properties_is_a_time_or_a_matrix() {
    let slope = -7.0 / 6.0;
    let by_time = axial_viscosity("time = 2e-3").unwrap();
    assert!(
        (by_time / (slope * 2e-3 * 7e6) - 1.0).abs() < 1e-12,
        "{by_time}"
    );
    let zero = "[0, 0, 0, 0, 0, 0]";
    let rows = format!("[[5, 0, 0, 0, 0, 0], {zero}, {zero}, {zero}, {zero}, {zero}]");
    let by_matrix = axial_viscosity(&format!("matrix = {rows}")).unwrap();
    assert!(
        (by_matrix / (slope * 5.0) - 1.0).abs() < 1e-12,
        "{by_matrix}"
    );

    let both = axial_viscosity(&format!("time = 1\nmatrix = {rows}")).unwrap_err();
    assert!(
        both.contains("needs one of \"time\" and \"matrix\""),
        "{both}"
    );
    let negative = axial_viscosity("time = -1").unwrap_err();
    assert!(negative.contains("\"time\" is -1"), "{negative}");
    let indefinite = axial_viscosity(&format!("matrix = {}", rows.replace('5', "-5")));
    let indefinite = indefinite.unwrap_err();
    assert!(indefinite.contains("positive semidefinite"), "{indefinite}");
}

// The stiffness of the properties with a damper added: the viscosity is the same matrix,
// the stiffness is unchanged; both ways at once are an error.
#[test]
fn properties_carry_a_law_as_a_sum() {
    let slope = -7.0 / 6.0;
    let law = "law = [{ kind = \"section\" }, \
               { kind = \"viscous\", viscosity = [5, 0, 0, 0, 0, 0] }]\n";
    let nodes = NODES.replace("[[node]]\nname = \"mast\"\nposition = [-1, 0, 0]\n", "");
    let rest = format!("{nodes}[[clamp]]\nnode = \"tip\"\n");
    let [plain, damped] = ["", law].map(|law| input(&format!("{law}{rest}")).unwrap());
    let viscosity = entry(&damped, 6, 0, true);
    assert!(
        (viscosity / (slope * 5.0) - 1.0).abs() < 1e-12,
        "{viscosity}"
    );
    for column in 0..6 {
        let [expected, found] = [&plain, &damped].map(|input| entry(input, 6, column, false));
        assert!(
            (found - expected).abs() <= 1e-12 * expected.abs(),
            "{column}"
        );
    }
    let both = input(&format!("{law}damping = {{ time = 1 }}\n{rest}")).unwrap_err();
    assert!(
        both.contains("\"law\"") && both.contains("\"damping\""),
        "{both}"
    );
    let soft = law.replace("{ kind = \"section\" }, ", "");
    let soft = input(&format!("{soft}{rest}")).unwrap_err();
    let expected = "properties \"strip\": the law has no positive definite stiffness";
    assert!(soft.contains(expected), "{soft}");
}
