//! Random models of two bodies with a joint and springs: number of states, remainder of all equations,
//! transfer functions against a direct solution of all equations.

use nalgebra::Complex;

use super::{direct, linear, off, response};
use crate::effort::cases;
use crate::periodic::Random;

/// Kinds of joints with their keys and the number of their constraints.
const KINDS: [(&str, &str, usize); 6] = [
    ("spherical", "at = POINT", 3),
    ("revolute", "at = POINT\naxis = AXIS", 5),
    ("cylindrical", "at = POINT\naxis = AXIS", 4),
    ("prismatic", "at = POINT\naxis = AXIS", 5),
    ("in-plane", "at = POINT\naxis = AXIS", 1),
    ("clamp", "at = POINT", 6),
];

fn three(random: &mut Random, around: f64, size: f64) -> String {
    let numbers = [(); 3].map(|()| around + size * random.next());
    format!("{numbers:?}")
}

/// Two bodies, of which springs and dampers hold all motions, at random speed under random forces.
fn model(random: &mut Random, kind: &str, keys: &str) -> String {
    let keys = keys.replace("POINT", &three(random, 0.0, 0.5));
    let keys = keys.replace(
        "AXIS",
        &format!("[{:?}, 0.8, {:?}]", random.next(), random.next()),
    );
    let mut text = format!(
        "[[joint]]\nname = \"joint\"\nkind = \"{kind}\"\nnodes = [\"a\", \"b\"]\n{keys}\n\
         [[load]]\nnode = \"b\"\nforce = {}\nmoment = {}\ndrive = \"push\"\n\
         [drives.push]\nkind = \"constant\"\nvalue = 1\n\
         [[output.column]]\nname = \"reaction\"\nquantity = \"reaction_force\"\nof = \"joint\"\n\
         node = \"b\"\n\
         [sensors.speed]\nquantity = \"velocity\"\nof = \"b\"\ncomponent = \"z\"\n",
        three(random, 0.0, 20.0),
        three(random, 0.0, 10.0),
    );
    for (name, x) in [("a", 0.0), ("b", 1.0)] {
        text += &format!(
            "[[node]]\nname = \"{name}\"\nposition = [{x:?}, {:?}, 0.2]\n\
             [[body]]\nname = \"{name}\"\nnode = \"{name}\"\nmass = {:?}\ninertia = {}\n\
             offset = {}\n\
             [[spring]]\nname = \"spring {name}\"\nnode = \"{name}\"\nstiffness = {}\n\
             rotational_stiffness = {}\ndamping = {}\nrotational_damping = {}\n",
            0.3 * random.next(),
            2.0 + random.next(),
            three(random, 1.0, 0.2),
            three(random, 0.0, 0.2),
            three(random, 3000.0, 1000.0),
            three(random, 3000.0, 1000.0),
            three(random, 9.0, 8.0),
            three(random, 9.0, 8.0),
        );
    }
    text
}

// 100 models, and the transfer functions of every fifth, so of each kind: the error of both solutions is
// the round-off of some fifty equations, with frequencies of 10 to 100 rad/s: 1e-9 is far above. Outputs
// are a velocity and the reactions.
#[test]
fn all_motions_are_those_of_all_equations() {
    let mut random = Random(7);
    for number in 0..cases(100) {
        let (kind, keys, constraints) = KINDS[number % KINDS.len()];
        let text = model(&mut random, kind, keys);
        let outputs = ["speed", "reaction_x", "reaction_y", "reaction_z"];
        let asked = (&["push"][..], &outputs[..], 3.0 * random.next().abs());
        let found = linear(&text, asked);
        assert_eq!(found.states.len(), 2 * (12 - constraints), "{kind}");
        let s = Complex::new(5.0 * random.next(), 60.0 * random.next());
        if number % 5 > 0 {
            continue;
        }
        let off = off(&response(&found, s), &direct(&text, asked, s));
        assert!(off < 1e-9, "{kind}: {off:e}\n{text}");
    }
}
