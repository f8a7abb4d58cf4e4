//! Multiblade coordinates of all unknowns of a rotor that turns in a frame at rest.
//!
//! An unknown x_k of blade k of N, at the azimuth `psi_k = Omega t + psi_k0`, is
//!
//! ```text
//! x_k = B_k(t) sum_j c_j(psi_k) eta_j ,     c = (1, cos psi, sin psi, cos 2 psi, ..., (-1)^k)      (D-338)
//! ```
//!
//! with B_k for vectors of nodes, and one for other numbers; the last coordinate is only of an even
//! number of blades. Unknowns of parts that no blade has stay as they are. Equations have the same
//! coordinates as the unknowns of their number.
//!
//! `B_k = R(t) R(0)^T B_k(0)` turns with the node along the motion, with R of the node and `B_k(0)` the
//! axes of the blade without deformation. In axes that only turn with the rotor the stiffness along a
//! blade that flaps by `b_1 cos psi` has the mean `EA b_1^2 / 2` across the blade, which is not small
//! beside its centrifugal stiffness; in axes that flap with the nodes it has none.
//!
//! References: [ColemanFeingold1958].

use std::collections::BTreeMap;

use nalgebra::Matrix3;
use shared_geom::rotation::vector;

use crate::case::{BladeNodes, Model};
use crate::model::{NODE_UNKNOWNS, NodeMotion, State};

/// Difference of the rotations between successive blades, beyond which they are not equal \[-\].
const EQUAL: f64 = 1e-6;
/// Distance of the numbers of slots of elements of one name: more than an element has.
const SAME_NAME: usize = 1 << 20;

/// Successive unknowns.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Slot {
    /// The first of them.
    pub first: usize,
    /// Their number.
    pub size: usize,
    /// Their kind.
    pub kind: SlotKind,
    /// Blade, and index of its family; `None` for other parts.
    pub of_blade: Option<(usize, usize)>,
}

/// Kind of the unknowns of a slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SlotKind {
    /// The components of a vector in the axes of the model.
    Vector,
    /// A number.
    Number,
    /// The multipliers of an element; its constraints may be combined at will.
    Multipliers,
}

/// The coordinates of a model.
#[derive(Debug)]
pub(super) struct Coordinates {
    /// All unknowns.
    pub slots: Vec<Slot>,
    /// Index of the slot of each unknown.
    pub slot_of: Vec<usize>,
    /// Slots of the same part of all blades, by ascending azimuth.
    pub families: Vec<Vec<usize>>,
    /// Azimuth of each blade at the time zero \[rad\].
    azimuths: Vec<f64>,
    /// Axes of each blade at the time zero (columns), of the root.
    blades: Vec<Matrix3<f64>>,
    /// Axes of the blade in the axes of each node of a blade, without deformation.
    in_nodes: Vec<Option<Matrix3<f64>>>,
    /// Speed of the rotor \[rad/s\].
    speed: f64,
}

/// Factors of the coordinates at an instant, and their rates.
#[derive(Debug)]
pub(super) struct Factors {
    /// For each node of a blade B and its rate.
    turns: Vec<Option<[Matrix3<f64>; 2]>>,
    /// For each blade c_j and their rates.
    pub harmonics: Vec<Vec<[f64; 2]>>,
}

/// Why a rotor has no multiblade coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct NoCoordinates(pub &'static str);

impl Coordinates {
    /// The coordinates of a model whose rotor turns with a speed \[rad/s\].
    pub fn new(model: &Model, speed: f64) -> Result<Self, NoCoordinates> {
        let mut order: Vec<&BladeNodes> = model.blades.iter().collect();
        order.sort_by(|a, b| a.azimuth.total_cmp(&b.azimuth));
        if order.len() < 3 {
            return Err(NoCoordinates("the rotor has fewer than three blades"));
        }
        let root = |blade: &&BladeNodes| blade.nodes.first().map(|node| model.naming[*node].blade);
        let blades: Vec<_> = order.iter().filter_map(root).collect();
        let pairs = blades.iter().zip(blades.iter().cycle().skip(1));
        let turns: Vec<_> = pairs.map(|(a, b)| b * a.transpose()).collect();
        let turn = turns.first();
        let turn = turn.filter(|turn| vector::from_rotation(turn).norm() != 0.0);
        let Some(turn) = turn else {
            return Err(NoCoordinates("the blades are not around an axis"));
        };
        if turns.iter().any(|other| (other - turn).amax() > EQUAL) {
            return Err(NoCoordinates(
                "the blades are not at equal angles around one axis, as the ones of several rotors",
            ));
        }
        let mut coordinates = Self {
            slots: Vec::new(),
            slot_of: Vec::new(),
            families: Vec::new(),
            azimuths: order.iter().map(|blade| blade.azimuth).collect(),
            blades,
            in_nodes: Vec::new(),
            speed,
        };
        coordinates.find(model, &order);
        coordinates.in_nodes = coordinates.in_nodes(model);
        Ok(coordinates)
    }

    /// Number of blades.
    pub fn count(&self) -> usize {
        self.blades.len()
    }

    /// Coordinate `j` as a word.
    pub fn word(&self, j: usize) -> String {
        let waves = j.div_ceil(2);
        let several = |word: &str| match waves {
            1 => word.to_owned(),
            _ => format!("{word} x{waves}"),
        };
        match j {
            0 => "collective".to_owned(),
            _ if self.count().is_multiple_of(2) && j == self.count() - 1 => {
                "differential".to_owned()
            }
            _ if j.is_multiple_of(2) => several("sine"),
            _ => several("cosine"),
        }
    }

    /// Axes of a blade at the time zero.
    pub fn blade(&self, blade: usize) -> &Matrix3<f64> {
        &self.blades[blade]
    }

    /// Finds the slots, and the families of those that all blades have.
    fn find(&mut self, model: &Model, order: &[&BladeNodes]) {
        let system = &model.system;
        let numbering = system.numbering();
        let mut named = Named::default();
        let mut add = |slots: &mut Vec<Slot>, label: &str, number: usize, slot: Slot| {
            if let Some((blade, rest)) = of_blade(label, order) {
                named.add((rest, number), (blade, order.len()), slots.len());
            }
            slots.push(slot);
        };
        let slot = |first: usize, size: usize, kind: SlotKind| Slot {
            first,
            size,
            kind,
            of_blade: None,
        };
        for (node, own) in system.nodes().iter().enumerate() {
            for part in 0..NODE_UNKNOWNS / 3 {
                let first = NODE_UNKNOWNS * node + 3 * part;
                let label = format!("{} node", own.label);
                add(
                    &mut self.slots,
                    &label,
                    part,
                    slot(first, 3, SlotKind::Vector),
                );
            }
        }
        let mut is_known = vec![false; numbering.scalars()];
        for (index, element) in system.elements().enumerate() {
            let (first, count) = (
                numbering.first_multiplier_of(index),
                numbering.multipliers_of(index).len(),
            );
            if count > 0 {
                let own = slot(first, count, SlotKind::Multipliers);
                add(&mut self.slots, element.label(), 0, own);
            }
            for (place, &scalar) in numbering.scalars_of(index).iter().enumerate() {
                if !std::mem::replace(&mut is_known[scalar], true) {
                    let own = slot(numbering.first_scalar() + scalar, 1, SlotKind::Number);
                    add(&mut self.slots, element.label(), 1 + place, own);
                }
            }
        }
        self.slot_of = vec![0; numbering.unknowns()];
        for (index, slot) in self.slots.iter().enumerate() {
            self.slot_of[slot.first..slot.first + slot.size].fill(index);
        }
        for members in named.0.into_values() {
            let members: Option<Vec<_>> = members.into_iter().collect();
            let Some(members) = members else { continue };
            for (blade, slot) in members.iter().enumerate() {
                self.slots[*slot].of_blade = Some((blade, self.families.len()));
            }
            self.families.push(members);
        }
    }

    /// Axes of the blade in the axes of each node of a blade, without deformation.
    fn in_nodes(&self, model: &Model) -> Vec<Option<Matrix3<f64>>> {
        let rest = model.system.rest();
        let of_node = |(index, node): (usize, &NodeMotion)| {
            let (blade, _) = self.slots[self.slot_of[NODE_UNKNOWNS * index]].of_blade?;
            Some(node.rotation.transpose() * self.blades[blade])
        };
        rest.nodes.iter().enumerate().map(of_node).collect()
    }

    /// The factors at a time \[s\] and the state then.
    pub fn at(&self, time: f64, state: &State) -> Factors {
        let turned = self.speed * time;
        let of_node = |(node, in_node): (&NodeMotion, &Option<Matrix3<f64>>)| {
            in_node.map(|in_node| {
                let axes = node.rotation * in_node;
                [axes, node.angular_velocity.cross_matrix() * axes]
            })
        };
        let n = self.count();
        let harmonics = self.azimuths.iter().enumerate().map(|(k, azimuth)| {
            let psi = azimuth + turned;
            let mut factors = vec![[1.0, 0.0]];
            for order in 1..=(n - 1) / 2 {
                let order = order as f64;
                let (sin, cos) = (order * psi).sin_cos();
                let rate = order * self.speed;
                factors.extend([[cos, -rate * sin], [sin, rate * cos]]);
            }
            if n.is_multiple_of(2) {
                factors.push([if k.is_multiple_of(2) { 1.0 } else { -1.0 }, 0.0]);
            }
            factors
        });
        Factors {
            turns: state
                .nodes
                .iter()
                .zip(&self.in_nodes)
                .map(of_node)
                .collect(),
            harmonics: harmonics.collect(),
        }
    }
}

/// Slots of all blades by the name of their part without the blade, and their number in it.
#[derive(Default)]
struct Named(BTreeMap<(String, usize), Vec<Option<usize>>>);

impl Named {
    /// Adds the slot of one of several blades; elements of different kinds may have one name.
    fn add(
        &mut self,
        (rest, number): (String, usize),
        (blade, count): (usize, usize),
        slot: usize,
    ) {
        let mut number = number;
        loop {
            let all = self.0.entry((rest.clone(), number));
            let all = all.or_insert_with(|| vec![None; count]);
            if all[blade].is_none() {
                all[blade] = Some(slot);
                return;
            }
            number += SAME_NAME;
        }
    }
}

impl Factors {
    /// B of a vector of a blade and its rate.
    pub fn turn(&self, slot: &Slot) -> Option<&[Matrix3<f64>; 2]> {
        let is_vector = slot.kind == SlotKind::Vector && slot.of_blade.is_some();
        let node = is_vector.then_some(slot.first / NODE_UNKNOWNS)?;
        self.turns.get(node)?.as_ref()
    }
}

/// Blade of a part and the rest of its name, which may be one of expressions; `None` if no blade has
/// it.
fn of_blade(label: &str, order: &[&BladeNodes]) -> Option<(usize, String)> {
    order.iter().enumerate().find_map(|(number, blade)| {
        let letter = |letter: char| {
            if letter.is_ascii_alphanumeric() {
                letter
            } else {
                '_'
            }
        };
        let written: String = blade.name.chars().map(letter).collect();
        let names = [
            (blade.name.as_str(), &['/', ' '][..]),
            (&written, &['_'][..]),
        ];
        let rest = names.into_iter().find_map(|(name, ends)| {
            let rest = label.strip_prefix(name)?;
            rest.starts_with(ends).then_some(rest)
        });
        rest.map(|rest| (number, rest.to_owned()))
    })
}
