//! The reading of a card: its node, beam, joint or drive, components and axes.

use nalgebra::Vector3;
use shared_geom::document::{DocumentProblem, Table};
use shared_geom::units::{Dimension, parse};
use shared_geom::wrench::COMPONENTS;

use super::air;
use super::keys::{ABOUT, AGAINST, IN, NODE, OF, POINT, SEQUENCE};
use super::kind::{CURVATURE, Kind, SIX, Source};
use super::problem::ReadingProblem;
use crate::case::{ElectrodeQuantity, Quantity};
use crate::elements::{
    Axes, JointMotion, NodeQuantity, NodeVector, Part, Reading as ElementReading, SpringVector,
};
use crate::input::builder::{LookUp, ModelBuilder};
use crate::input::drives;

/// Words for the parts of a vector.
const PARTS: [(&str, Part); 4] = [
    ("x", Part::Component(0)),
    ("y", Part::Component(1)),
    ("z", Part::Component(2)),
    ("magnitude", Part::Magnitude),
];
/// Words for the ends of a joint.
const ENDS: [&str; 2] = ["first", "second"];
/// Words for angles about three axes.
const TURNS: [&str; 3] = ["first", "second", "third"];

/// A quantity without a name.
#[derive(Debug)]
pub(in crate::input) struct Found {
    /// Ending of its name if there are several.
    pub word: &'static str,
    /// Its description.
    pub words: String,
    pub quantity: Quantity,
    pub dimension: Dimension,
    /// The default unit.
    pub unit: &'static str,
}

/// A card during reading.
pub(in crate::input) struct Reading<'a> {
    pub table: &'a Table<'a>,
    pub builder: &'a ModelBuilder,
    /// Description of the column or the sensor.
    pub user: &'a str,
}

/// The node that a motion is relative to, with its name; `None` for the ground.
type Against = Option<(usize, String)>;

impl Reading<'_> {
    /// The quantities of the card, one per component.
    pub fn parts(&self, kind: &Kind) -> Option<Vec<Found>> {
        let (word, source, dimension, unit) = *kind;
        let plain = word.replace('_', " ");
        let one = |quantity| {
            Some(vec![Found {
                word: "",
                words: plain.clone(),
                quantity,
                dimension,
                unit,
            }])
        };
        match source {
            Source::Node(vector) => self.of_node(kind, vector),
            Source::Momentum { is_angular } if self.table.has(OF) => {
                let vector = if is_angular {
                    NodeVector::AngularMomentum
                } else {
                    NodeVector::Momentum
                };
                self.of_node(kind, vector)
            }
            Source::Momentum { is_angular } => self.of_model(kind, is_angular),
            Source::Section { is_strain } => self.of_beam(kind, is_strain),
            Source::Reaction { is_moment } => self.of_joint(kind, is_moment),
            Source::Joint(motion) => self.of_motion(kind, motion),
            Source::Spring(vector) => self.of_spring(kind, vector),
            Source::Electrode(quantity) => self.of_electrode(kind, quantity),
            Source::Strip(quantity) => self.worded(
                kind,
                air::of_strip((self.table, self.builder), kind, quantity),
            ),
            Source::Rotor(quantity) => self.worded(
                kind,
                air::of_rotor((self.table, self.builder), kind, quantity),
            ),
            Source::Drive => self.of_drive(),
            Source::Signal => self.of_signal(),
            Source::Energy(part) => one(Quantity::Energy(part)),
            Source::StepLength => one(Quantity::StepLength),
            Source::Iterations => one(Quantity::Iterations),
        }
    }

    /// One quantity with its words.
    fn worded(&self, kind: &Kind, found: Option<(String, Quantity)>) -> Option<Vec<Found>> {
        let (words, quantity) = found?;
        Some(vec![Found {
            word: "",
            words,
            quantity,
            dimension: kind.2,
            unit: kind.3,
        }])
    }

    /// The object named under `of`, found by `find`.
    fn of<T>(&self, expected: &str, find: impl Fn(LookUp<'_>) -> Option<T>) -> Option<(String, T)> {
        let name = self.table.require_text(OF, expected)?;
        let found = find(self.look_up(OF, &name))?;
        Some((name, found))
    }

    /// A name under a key of the card.
    fn look_up<'b>(&'b self, key: &'b str, name: &'b str) -> LookUp<'b> {
        LookUp {
            builder: self.builder,
            table: self.table,
            key,
            name,
            user: self.user,
        }
    }

    /// The words under `component`; without the key, all of `known` except the magnitude.
    fn components(&self, known: &[&'static str]) -> Option<Vec<usize>> {
        let all = known.iter().filter(|word| **word != "magnitude").count();
        if !self.table.has("component") {
            return Some((0..all).collect());
        }
        let found = self.table.texts("component")?;
        let indices = found.into_iter().map(|found| {
            let index = known.iter().position(|word| *word == found);
            if index.is_none() {
                let problem = DocumentProblem::WrongWord {
                    key: "component".to_owned(),
                    found,
                    known: known.iter().map(|&word| word.to_owned()).collect(),
                    meant: None,
                };
                self.table.note("component", &problem);
            }
            index
        });
        let indices: Vec<_> = indices.collect();
        indices.into_iter().collect()
    }

    fn vector_parts(&self) -> Option<Vec<(&'static str, Part)>> {
        let indices = self.components(&PARTS.map(|part| part.0))?;
        Some(indices.into_iter().map(|index| PARTS[index]).collect())
    }

    /// Axes under `in`: of the model, of a node, of a frame of the model, or with `ends` of
    /// an end of a joint.
    fn axes(&self, ends: bool) -> Option<(Axes, String)> {
        let Some(name) = self.table.get(&IN)? else {
            return Some((Axes::Model, String::new()));
        };
        match name.as_str() {
            "model" => Some((Axes::Model, String::new())),
            name if ends && ENDS.contains(&name) => {
                let end = usize::from(name == ENDS[1]);
                Some((Axes::End(end), format!(" in the axes of its {name} end")))
            }
            name => {
                let axes = self.look_up(IN.name(), name).axes()?;
                Some((axes, format!(" in the axes of {name}")))
            }
        }
    }

    fn of_node(&self, kind: &Kind, vector: NodeVector) -> Option<Vec<Found>> {
        let (_, _, dimension, unit) = *kind;
        let plain = kind.0.replace('_', " ");
        let node = self.of("the name of a node", |name| name.node());
        let against = self.table.get(&AGAINST).and_then(|against| match against {
            Some(name) => Some(Some((self.look_up(AGAINST.name(), &name).node()?, name))),
            None => Some(None),
        });
        if let NodeVector::Euler(_) = vector {
            return self.turns(kind, (node, against));
        }
        let (parts, axes) = (self.vector_parts(), self.axes(false));
        let ((name, node), against, parts, (axes, frame)) = (node?, against?, parts?, axes?);
        // A rotation seen by a node is in the axes of this node.
        let own = match (vector, &against) {
            (NodeVector::Rotation | NodeVector::Attitude, Some((node, _))) => Axes::Node(*node),
            _ => axes,
        };
        let axes = if self.table.has(IN.name()) { axes } else { own };
        let other = match &against {
            Some((_, other)) => format!(" relative to {other}"),
            None => String::new(),
        };
        let found = parts.into_iter().map(|(word, part)| Found {
            word,
            words: format!("{plain} {word} of {name}{other}{frame}"),
            quantity: Quantity::Node(NodeQuantity {
                node,
                vector,
                part,
                against: against.as_ref().map(|other| other.0),
                axes,
            }),
            dimension,
            unit,
        });
        Some(found.collect())
    }

    /// Angles of rotations about axes in the order of `sequence`.
    fn turns(
        &self,
        kind: &Kind,
        (node, against): (Option<(String, usize)>, Option<Against>),
    ) -> Option<Vec<Found>> {
        let (sequence, indices) = (self.table.get(&SEQUENCE), self.components(&TURNS));
        let ((name, node), against, sequence) = (node?, against?, sequence?);
        let axes: Vec<_> = sequence.chars().filter_map(|c| "xyz".find(c)).collect();
        let axes = match axes[..] {
            [i, j, k] if i != j && j != k && sequence.len() == 3 => [i, j, k],
            _ => {
                let found = sequence;
                let problem = ReadingProblem::Sequence { found };
                self.table.note(&SEQUENCE, &problem);
                return None;
            }
        };
        let found = indices?.into_iter().map(|index| Found {
            word: TURNS[index],
            words: format!("{} angle {sequence} of {name}", TURNS[index]),
            quantity: Quantity::Node(NodeQuantity {
                node,
                vector: NodeVector::Euler(axes),
                part: Part::Component(index),
                against: against.as_ref().map(|other| other.0),
                axes: Axes::Model,
            }),
            dimension: kind.2,
            unit: kind.3,
        });
        Some(found.collect())
    }

    fn of_model(&self, kind: &Kind, is_angular: bool) -> Option<Vec<Found>> {
        let about = if is_angular {
            self.table.get(&ABOUT)
        } else {
            Some(Vector3::zeros())
        };
        let parts = self.vector_parts();
        let (about, plain) = (about?, kind.0.replace('_', " "));
        let found = parts?.into_iter().map(|(word, part)| Found {
            word,
            words: format!("{plain} {word} of the model"),
            quantity: if is_angular {
                Quantity::AngularMomentum { about, part }
            } else {
                Quantity::Momentum(part)
            },
            dimension: kind.2,
            unit: kind.3,
        });
        Some(found.collect())
    }

    fn of_beam(&self, kind: &Kind, strain: bool) -> Option<Vec<Found>> {
        let beam = self.of("the name of a beam", |name| name.beam().then_some(()));
        let point = self.table.get(&POINT);
        let components = self.components(&SIX);
        let (beam, point) = (beam?.0, point? - 1);
        let about = if strain {
            (CURVATURE, "1/m")
        } else {
            (Dimension::MOMENT, "N m")
        };
        let found = components?.into_iter().map(|component| {
            let (dimension, unit) = if component < 3 {
                (kind.2, kind.3)
            } else {
                about
            };
            let plain = kind.0.replace('_', " ");
            Found {
                word: SIX[component],
                words: format!(
                    "{plain} {} of {beam} in section axes",
                    COMPONENTS[component]
                ),
                quantity: Quantity::Element {
                    label: beam.clone(),
                    reading: ElementReading::Section {
                        point,
                        strain,
                        component,
                    },
                },
                dimension,
                unit,
            }
        });
        Some(found.collect())
    }

    fn of_joint(&self, kind: &Kind, moment: bool) -> Option<Vec<Found>> {
        let joint = self.of("the name of a joint", |name| name.joint());
        let on = self.table.get(&NODE);
        let (parts, axes) = (self.vector_parts(), self.axes(true));
        let (joint, nodes) = joint?;
        let node = match on? {
            Some(name) => self.node_of_joint(&joint, &nodes, name)?,
            None => *nodes.last()?,
        };
        let label = &self.builder.nodes()[node].label;
        let ((axes, frame), plain) = (axes?, kind.0.replace('_', " "));
        let found = parts?.into_iter().map(|(word, part)| Found {
            word,
            words: format!("{plain} {word} of {joint} on {label}{frame}"),
            quantity: Quantity::Element {
                label: joint.clone(),
                reading: ElementReading::Reaction {
                    node,
                    moment,
                    part,
                    axes,
                },
            },
            dimension: kind.2,
            unit: kind.3,
        });
        Some(found.collect())
    }

    fn of_motion(&self, kind: &Kind, motion: JointMotion) -> Option<Vec<Found>> {
        let joint = self.of("the name of a joint", |name| name.joint());
        let parts = match motion {
            JointMotion::Angle => Some(vec![("", Part::Component(0))]),
            _ => self.vector_parts(),
        };
        let ((joint, _), plain) = (joint?, kind.0.replace('_', " "));
        let found = parts?.into_iter().map(|(word, part)| Found {
            word,
            words: match word {
                "" => format!("{plain} of {joint}"),
                _ => format!("{plain} {word} of {joint} in its own axes"),
            },
            quantity: Quantity::Element {
                label: joint.clone(),
                reading: ElementReading::Joint { motion, part },
            },
            dimension: kind.2,
            unit: kind.3,
        });
        Some(found.collect())
    }

    fn of_spring(&self, kind: &Kind, vector: SpringVector) -> Option<Vec<Found>> {
        let spring = self.of("the name of a rod or spring", |name| name.joint());
        let (parts, plain) = (self.vector_parts(), kind.0.replace('_', " "));
        let spring = spring?.0;
        let found = parts?.into_iter().map(|(word, part)| Found {
            word,
            words: format!("{plain} {word} of {spring} in its own axes"),
            quantity: Quantity::Element {
                label: spring.clone(),
                reading: ElementReading::Spring { vector, part },
            },
            dimension: kind.2,
            unit: kind.3,
        });
        Some(found.collect())
    }

    fn of_electrode(&self, kind: &Kind, quantity: ElectrodeQuantity) -> Option<Vec<Found>> {
        let (name, electrode) = self.of("the name of an [[electrode]]", |name| name.electrode())?;
        Some(vec![Found {
            word: "",
            words: format!("{} of electrode {name}", kind.0),
            quantity: Quantity::Electrode {
                electrode,
                quantity,
            },
            dimension: kind.2,
            unit: kind.3,
        }])
    }

    /// A drive by its name, or written in the card; its numbers are in its unit.
    fn of_drive(&self) -> Option<Vec<Found>> {
        let name = self
            .table
            .require_text(OF, "the name of a drive, or \"= ...\"")?;
        let unit = if self.table.has("unit") {
            self.table.text("unit")?
        } else {
            "1".to_owned()
        };
        let dimension = match parse(&unit) {
            Ok(unit) => unit.dimension,
            Err(problem) => {
                let key = "unit".to_owned();
                let problem = DocumentProblem::Unit { key, problem };
                self.table.note("unit", &problem);
                return None;
            }
        };
        let drive = drives::read_item(&self.table.item(OF)?, dimension, self.builder.drives())?;
        Some(vec![Found {
            word: "",
            words: format!("drive {name}"),
            quantity: Quantity::Drive(drive),
            dimension,
            unit: "1",
        }])
    }

    fn of_signal(&self) -> Option<Vec<Found>> {
        let name = (self.table).require_text(OF, "the name of a signal, or \"= ...\"")?;
        let of = self.table.item(OF)?;
        let signal = drives::signal_of(&of, Dimension::NUMBER, self.builder.drives())?;
        Some(vec![Found {
            word: "",
            words: format!("signal {name}"),
            quantity: Quantity::Signal(signal),
            dimension: Dimension::NUMBER,
            unit: "1",
        }])
    }

    fn node_of_joint(&self, joint: &str, nodes: &[usize], name: String) -> Option<usize> {
        let node = self.look_up(NODE.name(), &name).node()?;
        if nodes.contains(&node) {
            return Some(node);
        }
        let labels = nodes.iter().map(|node| &self.builder.nodes()[*node].label);
        let problem = ReadingProblem::NotOfJoint {
            joint: joint.to_owned(),
            node: name,
            known: labels.cloned().collect(),
        };
        self.table.note(&NODE, &problem);
        None
    }
}
