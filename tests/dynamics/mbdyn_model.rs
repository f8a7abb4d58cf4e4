//! The model described by a file for MBDyn, built from its text.
//!
//! The model of the file differs from the blade: mass in bodies at the nodes, one stiffness for
//! each half of an element, parabolas for the line. The same elements and bodies here show the
//! effect on the frequencies.

use std::collections::BTreeMap;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, ModesSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{Beam, BeamGeometry, BeamNode};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::model::Node;
use nalgebra::{Matrix3, Matrix6, Vector3};

use crate::chain::VOLUMES;

/// Statements by their keyword, each as its items between commas.
struct Statements(BTreeMap<String, Vec<Vec<String>>>);

impl Statements {
    fn parse(text: &str) -> Self {
        let lines = text.lines().map(|line| line.split('#').next().unwrap());
        let text = lines.collect::<Vec<_>>().join(" ");
        let mut found: BTreeMap<String, Vec<Vec<String>>> = BTreeMap::new();
        for statement in text.split(';') {
            if let Some((keyword, rest)) = statement.split_once(':') {
                let words = rest.split(',').map(|word| word.trim().to_owned()).collect();
                found
                    .entry(keyword.trim().to_owned())
                    .or_default()
                    .push(words);
            }
        }
        Self(found)
    }

    fn of(&self, keyword: &str) -> &[Vec<String>] {
        &self.0[keyword]
    }
}

/// Numbers after the item `at`.
fn numbers<const N: usize>(words: &[String], at: usize) -> [f64; N] {
    std::array::from_fn(|k| words[at + k].parse().unwrap())
}

/// A symmetric matrix from its upper triangle, row by row.
fn symmetric(upper: &[f64; 21]) -> Matrix6<f64> {
    let mut entries = upper.iter();
    let mut matrix = Matrix6::zeros();
    for i in 0..6 {
        for j in i..6 {
            matrix[(i, j)] = *entries.next().unwrap();
            matrix[(j, i)] = matrix[(i, j)];
        }
    }
    matrix
}

fn nodes(file: &Statements) -> Vec<Node> {
    let node = |words: &Vec<String>| {
        assert_eq!(words[1], "dynamic");
        assert_eq!(words[5], "matr");
        Node {
            label: words[0].clone(),
            position: Vector3::from(numbers::<3>(words, 2)),
            rotation: Matrix3::from_row_slice(&numbers::<9>(words, 6)),
        }
    };
    file.of("structural").iter().map(node).collect()
}

fn body(words: &[String]) -> (usize, RigidInertia) {
    assert_eq!(words[6], "sym");
    let [mass] = numbers::<1>(words, 2);
    let [xx, xy, xz, yy, yz, zz] = numbers::<6>(words, 7);
    let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let center = Vector3::from(numbers::<3>(words, 3));
    let node = words[1].parse::<usize>().unwrap() - 1;
    (node, RigidInertia::about_node(mass, &center, &inertia))
}

/// A beam whose nodes have the section axes, with the stiffness at both points.
fn beam(words: &[String], nodes: &[Node]) -> Beam {
    let on = [1, 3, 5].map(|k| words[k].parse::<usize>().unwrap() - 1);
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]).formulated(VOLUMES);
    let mut at = 7;
    let stiffness = [0, 1].map(|_| {
        assert_eq!(words[at + 2], "matr");
        assert_eq!(words[at + 12], "linear elastic generic");
        let matrix = symmetric(&numbers::<21>(words, at + 14));
        at += 35;
        matrix
    });
    Beam::elastic(&words[0], on, geometry, on.map(|i| &nodes[i]), stiffness)
}

/// The lowest frequencies of the model of `text`, clamped and at rest \[Hz\].
pub fn frequencies(text: &str, count: usize) -> Vec<f64> {
    let file = Statements::parse(text);
    let nodes = nodes(&file);
    let mut elements: Vec<Box<dyn Element>> = vec![Box::new(clamped("root", 0, &nodes[0]))];
    for words in file.of("beam3") {
        elements.push(Box::new(beam(words, &nodes)));
    }
    for words in file.of("body") {
        let (node, inertia) = body(words);
        elements.push(Box::new(RigidBody::new("body", node, inertia)));
    }
    let model = Model::new("model of MBDyn", System::new(nodes, elements));
    let outcome = modes(&model, &ModesSettings::new(vec![0.0], count));
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let found = outcome.table.at_speed(0);
    found
        .iter()
        .take(count)
        .map(|mode| mode.1.frequency)
        .collect()
}
