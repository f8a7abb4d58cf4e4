//! Tests of rotors: their expansion, kinematics and frequencies, and the problems reported.

use std::path::Path;

use crate::analysis::transient::transient;
use crate::case::Model;
use crate::input::{Input, parse};
use crate::model::{NodeMotion, State};
use crate::result::{AcceptedStep, Recorder};

mod bearingless;
mod dampers;
mod expansion;
mod frequencies;
mod motion;
mod mounts;
mod problems;
mod restraints;
mod steady;
mod train;

/// A stiff, light strip.
const STRIP: &str = "
[properties.strip]
ea = 7e9
gay = 2e9
gaz = 2e9
gj = 3e7
eiy = 4e7
eiz = 4e7
m = 2
iy = 1e-5
iz = 1e-5
";

/// The blade of all rotors: from 0.2 m to 1.2 m.
const BLADE: &str = "
[rotor.blade]
hub_radius = 0.2
properties = \"strip\"
piece = [{ length = 1, elements = 2 }]
";

/// An input with a rotor of a kind, 3 blades, the keys of the rotor and further cards.
fn text(kind: &str, keys: &str, cards: &str) -> String {
    let blades = if kind == "teetering" { 2 } else { 3 };
    format!(
        "units = \"SI\"\n{STRIP}[[rotor]]\nname = \"r\"\nhub = \"{kind}\"\nblades = {blades}\n\
         {keys}\n{BLADE}{cards}"
    )
}

/// The input of a text.
fn read(text: &str) -> Input {
    parse(text, "a.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}\n{text}"))
}

/// The problems of a text, with the ones of the analyses of a period.
fn refused(text: &str) -> String {
    match parse(text, "a.dynamics.toml").and_then(Input::repeating) {
        Err(problems) => problems.to_string(),
        Ok(_) => panic!("accepted: {text}"),
    }
}

/// The expanded text of a text.
fn expanded(text: &str) -> String {
    super::expanded(text, "a.dynamics.toml").unwrap()
}

/// All steps of a run.
struct Run {
    model: Model,
    instants: Vec<(f64, State)>,
    remarks: Vec<String>,
}

impl Recorder for Run {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        self.instants.push((accepted.time, accepted.state.clone()));
        true
    }
}

impl Run {
    fn new(text: &str) -> Self {
        let input = read(text);
        let settings = input.transient.expect("a run");
        let mut run = Self {
            model: input.model.clone(),
            instants: Vec::new(),
            remarks: Vec::new(),
        };
        let outcome = transient(&input.model, &settings, None, &mut run, &|| 0.0);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        run.remarks = outcome.remarks;
        run
    }

    fn index(&self, name: &str) -> usize {
        let nodes = self.model.system.nodes();
        let found = nodes.iter().position(|node| node.label == name);
        found.unwrap_or_else(|| panic!("no node \"{name}\""))
    }

    /// Times and motions of nodes.
    fn motions<const N: usize>(&self, names: [&str; N]) -> Vec<(f64, [NodeMotion; N])> {
        let nodes = names.map(|name| self.index(name));
        let instants = self.instants.iter();
        instants
            .map(|(time, state)| (*time, nodes.map(|node| state.nodes[node])))
            .collect()
    }
}

/// A file of the workspace.
fn reference(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference");
    std::fs::read_to_string(folder.join(name)).unwrap()
}

#[test]
fn the_example_of_the_page_is_read() {
    let page = reference("../../docs/src/rotors.md");
    let example = page.split("```toml\n").nth(1).unwrap();
    let example = example.split("```").next().unwrap();
    let input = read(example);
    assert_eq!(input.model.blades.len(), 4);
    assert_eq!(
        read(&expanded(example)).model.fingerprint(),
        input.model.fingerprint()
    );
}
