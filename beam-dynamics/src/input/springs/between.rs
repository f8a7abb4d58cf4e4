//! Springs with laws, between two nodes or between the frame and a node.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::Family;
use shared_geom::document::schema::ValueKind::{Table as OneTable, Tables, Text, Texts, Vector};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::{DAMPERS, FIXED_TO, ORIENTATION, STIFFNESSES, six};
use crate::elements::laws::{Law, LawKind};
use crate::elements::springs::{Spring, SpringLaw};
use crate::input::builder::ModelBuilder;
use crate::input::ends;
use crate::input::laws::{self, Components, LawProblem};

/// Keys of a spring between two nodes.
pub(super) const OF_TWO_NODES: Family = Family {
    name: "two nodes",
    meaning: "Between two nodes: the displacement and rotation of the second relative to the \
              first, in whose axes the spring acts.",
    keys: &[
        NODES.schema,
        AT.schema,
        LAW.schema,
        ROTATIONAL_LAW.schema,
        COUPLED_LAW.schema,
    ],
};

/// Keys of a spring with a law between the frame and a node.
pub(super) const OF_ONE_NODE: Family = Family {
    name: "law",
    meaning: "Between a node and the frame, with at least one law.",
    keys: &[
        NODE.schema,
        AT.schema,
        LAW.schema,
        ROTATIONAL_LAW.schema,
        COUPLED_LAW.schema,
    ],
};

keys! {
    /// The names of two nodes.
    NODES: Vec<String> = "nodes", [Texts], required, "[\"hub\", \"gearbox\"]";
    /// The name of a node.
    NODE: String = "node", [Text], required, "\"engine\"";
    /// Position of the spring in the undeformed model; without it the last node.
    AT: Option<Vector3<f64>> = "at", [Vector(3, Dimension::LENGTH)], optional, "[0, 0, 1]";
    /// Law of the displacement, in place of `stiffness` and `damping`.
    LAW: ByHand = "law",
        [OneTable(&laws::DISPLACEMENT), Tables(&laws::DISPLACEMENT)], optional, "";
    /// Law of the rotation vector, in place of `rotational_stiffness` and `rotational_damping`.
    ROTATIONAL_LAW: ByHand = "rotational_law",
        [OneTable(&laws::DISPLACEMENT), Tables(&laws::DISPLACEMENT)], optional, "";
    /// Law of displacement and rotation together, in place of all others.
    COUPLED_LAW: ByHand = "coupled_law", [OneTable(&laws::BOTH), Tables(&laws::BOTH)], optional, "";
}

/// Keys of laws: for the displacement, for the rotation, and for both.
const LAWS: [&str; 3] = [LAW.name(), ROTATIONAL_LAW.name(), COUPLED_LAW.name()];

/// Whether a `[[spring]]` has two nodes or a law.
pub(super) fn is_one(table: &Table<'_>) -> bool {
    table.has(&NODES) || LAWS.iter().any(|key| table.has(key))
}

/// The spring of a card.
pub(super) fn read(table: &Table<'_>, builder: &mut ModelBuilder, label: &str) -> Option<Spring> {
    let words = format!("spring \"{label}\"");
    let nodes = nodes(table, builder, &words);
    if table.has(&FIXED_TO) {
        table.note(&FIXED_TO, &LawProblem::SupportFrame);
    }
    let (turn, position) = (table.get(&ORIENTATION), table.get(&AT));
    let frame = builder.frames().of(table);
    let law = spring_law(table, builder, &words);
    let (nodes, frame) = (nodes?, frame?);
    let axes = frame.axes(&vector::to_rotation(&turn?));
    let all = builder.nodes();
    let last = nodes.last().map(|&node| all[node].position)?;
    let position = position?.map_or(last, |position| frame.point(&position));
    Some(Spring::new(label, (&nodes, all), &position, &axes, law?))
}

/// The nodes under `nodes`, or the node under `node`.
fn nodes(table: &Table<'_>, builder: &mut ModelBuilder, words: &str) -> Option<Vec<usize>> {
    if !table.has(&NODE) {
        return ends::nodes((table, &NODES), builder, words, true);
    }
    if table.has(&NODES) {
        let (first, second) = (NODE.name(), NODES.name());
        table.note(second, &LawProblem::Twice { first, second });
    }
    let Some(name) = table.get(&NODE) else {
        builder.note_loose_end();
        return None;
    };
    let node = builder.find_node(&name, table, NODE.name(), words);
    Some(vec![node?])
}

/// The laws of a card: each as a law, or as `stiffness` and `damping` along the axes.
fn spring_law(table: &Table<'_>, builder: &ModelBuilder, words: &str) -> Option<SpringLaw> {
    const SHORT: [[&str; 2]; 2] = [
        [STIFFNESSES[0].name(), DAMPERS[0].name()],
        [STIFFNESSES[1].name(), DAMPERS[1].name()],
    ];
    if table.has(LAWS[2]) {
        let law = laws::read(table, LAWS[2], &Components::BOTH, builder.drives());
        let others = [LAWS[0], LAWS[1]]
            .into_iter()
            .chain(SHORT.into_iter().flatten());
        for second in others.filter(|key| table.has(key)) {
            let first = LAWS[2];
            table.note(second, &LawProblem::Twice { first, second });
        }
        return law.map(SpringLaw::Together);
    }
    for (first, short) in LAWS.into_iter().zip(SHORT) {
        let doubled = short.into_iter().filter(|key| table.has(key));
        for second in doubled.filter(|_| table.has(first)) {
            table.note(second, &LawProblem::Twice { first, second });
        }
    }
    let (stiffness, damping) = (six(table, STIFFNESSES), six(table, DAMPERS));
    let (stiffness, damping) = (stiffness?, damping?);
    let of = |i: usize, components: &Components<3>| -> Option<Option<Law<3>>> {
        if table.has(LAWS[i]) {
            return laws::read(table, LAWS[i], components, builder.drives()).map(Some);
        }
        let is_there = SHORT[i].iter().any(|key| table.has(key));
        let part = |six: &[f64; 6]| Vector3::new(six[3 * i], six[3 * i + 1], six[3 * i + 2]);
        Some(is_there.then(|| diagonal(&part(&stiffness), &part(&damping))))
    };
    let displacement = of(0, &Components::DISPLACEMENT);
    let rotation = of(1, &Components::ROTATION);
    let (displacement, rotation) = (displacement?, rotation?);
    if displacement.is_none() && rotation.is_none() {
        let spring = words.to_owned();
        table.note("", &LawProblem::NoLaw { spring });
        return None;
    }
    Some(SpringLaw::Apart {
        displacement,
        rotation,
    })
}

/// Springs and dampers along the axes.
fn diagonal(stiffness: &Vector3<f64>, damping: &Vector3<f64>) -> Law<3> {
    let [stiffness, viscosity] = [stiffness, damping].map(Matrix3::from_diagonal);
    if viscosity == Matrix3::zeros() {
        Law::linear(stiffness)
    } else {
        LawKind::Viscoelastic {
            stiffness,
            viscosity,
        }
        .into()
    }
}
