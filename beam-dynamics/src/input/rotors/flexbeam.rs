//! Bearingless blades: flexbeam, torque tube and snubber.
//!
//! ```text
//!            snubber           torque tube
//!   hub   ____(o)_____________________________________
//!   [##]~~~~~~~~~~~~~~~~~~~~~~ flexbeam ~~~~~~~~~~~~~~[#]======== blade
//!         ----|---------------------------------------'root
//!             o horn, with the pitch
//! ```
//!
//! Flexbeam and elastic torque tubes are `[[blade]]` cards that are parts of the blades; a rigid tube
//! is a node on the root, with a body. The tube is on the root at its outer end; its inner end, the
//! node `pitch` of each blade, has the horn and the snubber.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::arms;
use super::base::{Base, Local, Lump, lengths};
use super::controls::Sum;
use super::damper;
use super::damper_law::DamperLaw;
use super::pitch::{self, Control};

/// The flexbeam, the torque tube and the snubber of every blade.
#[derive(Debug)]
pub(super) struct Bearingless {
    /// The flexbeam.
    pub beam: Line,
    /// The torque tube.
    pub tube: Tube,
    /// The snubber.
    pub snubber: Option<Snubber>,
}

/// A line of beams along every blade.
#[derive(Debug)]
pub(super) struct Line {
    /// Distance of its inner end from the center \[m\].
    pub offset: f64,
    /// Distances of its nodes from the center \[m\]; empty if it has a file.
    pub nodes: Vec<f64>,
    /// Keys of its card.
    pub keys: Vec<(String, Content)>,
}

/// A torque tube.
#[derive(Debug)]
pub(super) enum Tube {
    /// Rigid, from a distance \[m\], with the distance of its center \[m\] and its mass, if it has
    /// one.
    Rigid(f64, Option<(f64, Lump)>),
    /// Of beams.
    Elastic(Line),
}

impl Tube {
    /// Distance of its inner end from the center \[m\].
    pub fn offset(&self) -> f64 {
        match self {
            Self::Rigid(offset, _) => *offset,
            Self::Elastic(line) => line.offset,
        }
    }
}

impl Line {
    /// The name in the line of the node at a distance from the center \[m\], if there is one.
    pub fn node_at(&self, offset: f64) -> Option<String> {
        let last = self.nodes.len().saturating_sub(1);
        let is_there = |node: &f64| (node - offset).abs() <= SAME_PLACE * offset.abs();
        let number = self.nodes.iter().position(is_there)?;
        Some(match number {
            0 => "root".to_owned(),
            _ if number == last => "tip".to_owned(),
            _ => number.to_string(),
        })
    }
}

/// Part of a distance below which places are the same: digits lost in the input.
const SAME_PLACE: f64 = 1e-6;

/// A snubber between hub or flexbeam and torque tube.
#[derive(Debug)]
pub(super) struct Snubber {
    /// Distance from the center along the blade \[m\].
    pub offset: f64,
    /// The node of the flexbeam that holds it; `None` for the hub.
    pub holder: Option<String>,
    /// Its law; `None` for a pin that slides along the blade.
    pub law: Option<SnubberLaw>,
}

/// The law of a snubber along the blade, forward and up.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum SnubberLaw {
    /// Stiffness \[N/m\] and damping \[N s/m\].
    Linear([Vector3<f64>; 2]),
    /// Elastomers that relax; `None` without stiffness.
    Relaxing([Option<DamperLaw>; 3]),
}

/// Name of the node of blade `k` that has the pitch: the inner end of the torque tube.
pub(super) fn pitch_node(base: &Base, k: usize) -> String {
    base.of_blade(k, "pitch")
}

impl Bearingless {
    /// The cards of the flexbeams of all blades, and of elastic torque tubes.
    pub fn lines(&self, base: &Base) -> Vec<Card> {
        let tube = match &self.tube {
            Tube::Rigid(..) => None,
            Tube::Elastic(line) => Some(("torque tube", line)),
        };
        let lines = [("flexbeam", &self.beam)].into_iter().chain(tube);
        let card = |(part, line): (&str, &Line)| {
            let names: Vec<_> = (0..base.count).map(|k| base.of_blade(k, part)).collect();
            arms::line(base, &base.part(part), &line.keys)
                .with("names", Content::texts(names.iter().map(String::as_str)))
                .with("hub_radius", Content::quantity(line.offset, "m"))
                .with("precone", Content::quantity(base.precone, "rad"))
                .with("part", true)
        };
        lines.map(card).collect()
    }

    /// The parts between the yoke and the root of blade `k`.
    pub fn cards(
        &self,
        base: &Base,
        (k, yoke): (usize, &str),
        (control, command): (&Control, &Sum),
    ) -> Vec<Card> {
        let (arm, node) = (base.arm(k), pitch_node(base, k));
        let [beam, root] = ["flexbeam", "root"].map(|part| base.of_blade(k, part));
        let rigid = |name: &str, nodes: [&str; 2]| {
            base.listed("rigid")
                .with("name", base.of_blade(k, name))
                .with("nodes", Content::texts(nodes))
        };
        let mut cards = vec![
            base.frame(&arm),
            base.node(&node, &arm, Vector3::x() * self.tube.offset()),
            rigid("flexbeam attachment", [yoke, &format!("{beam}/root")]),
            rigid("root attachment", [&format!("{beam}/tip"), &root]),
        ];
        match &self.tube {
            Tube::Rigid(offset, lump) => {
                cards.push(rigid("torque tube", [&root, &node]));
                cards.extend(lump.as_ref().map(|(center, lump)| {
                    let center = Vector3::x() * (center - offset);
                    base.body(&node, lump).with("offset", lengths(&center))
                }));
            }
            Tube::Elastic(_) => {
                let [inner, outer] =
                    ["root", "tip"].map(|end| base.of_blade(k, &format!("torque tube/{end}")));
                cards.push(rigid("torque tube attachment", [&root, &outer]));
                cards.push(rigid("horn", [&inner, &node]));
            }
        }
        let hub = base.hub();
        let nodes = [hub.as_str(), &node];
        let snubber = self.snubber.as_ref();
        let snubber = snubber.map(|snubber| snubber.cards(base, (k, nodes), &arm));
        cards.extend(snubber.into_iter().flatten());
        cards.extend(match control {
            Control::Free => None,
            Control::Prescribed => Some(
                base.joint(&node, "rotation", &nodes)
                    .with("in", arm.name.as_str())
                    .with(
                        "rotation",
                        Content::table([("x", command.on_side(base.side()).content())]),
                    ),
            ),
            Control::Bearing(link) | Control::Coupled(link) => {
                Some(pitch::coupled(base, (k, &node), &arm, (link, command)))
            }
        });
        cards
    }
}

impl Snubber {
    fn cards(&self, base: &Base, (k, nodes): (usize, [&str; 2]), arm: &Local) -> Vec<Card> {
        let name = base.of_blade(k, "snubber");
        let of_beam = |end: &String| base.of_blade(k, &format!("flexbeam/{end}"));
        let holder = self.holder.as_ref().map(of_beam);
        let nodes = [holder.as_deref().unwrap_or(nodes[0]), nodes[1]];
        let place = Vector3::x() * self.offset;
        let at = lengths(&place);
        let card = match &self.law {
            Some(SnubberLaw::Relaxing(laws)) => {
                let words = ["along", "forward", "up"];
                let laws = laws.iter().enumerate();
                let cards = laws.filter_map(|(axis, law)| {
                    let name = format!("{name} {}", words[axis]);
                    let spring = (axis, law.as_ref()?);
                    Some(damper::along(base, (&name, nodes), (arm, place), spring))
                });
                return cards.flatten().collect();
            }
            None => base
                .joint(&name, "in-line", &nodes)
                .with("in", arm.name.as_str())
                .with("at", at)
                .with("axis", Content::numbers([1.0, 0.0, 0.0])),
            Some(SnubberLaw::Linear([stiffness, damping])) => base
                .listed("spring")
                .with("name", name)
                .with("nodes", Content::texts(nodes))
                .with("in", arm.name.as_str())
                .with("at", at)
                .with(
                    "stiffness",
                    Content::quantities(stiffness.iter().copied(), "N/m"),
                )
                .with(
                    "damping",
                    Content::quantities(damping.iter().copied(), "N*s/m"),
                ),
        };
        vec![card]
    }
}
