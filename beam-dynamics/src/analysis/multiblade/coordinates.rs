//! Multiblade coordinates of all unknowns of rotors that turn in a frame at rest.
//!
//! An unknown x_k of blade k of the N blades of a rotor, at the azimuth `psi_k = Omega t + psi_k0`, is
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
use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};

use super::rotors::{self, Group, NoCoordinates};
use crate::case::{BladeNodes, Model};
use crate::model::{NODE_UNKNOWNS, NodeMotion, State};

/// Distance of the numbers of slots of elements of one name: more than an element has.
const SAME_NAME: usize = 1 << 20;

/// Successive unknowns.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis) struct Slot {
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
pub(in crate::analysis) enum SlotKind {
    /// The components of a vector in the axes of the model.
    Vector,
    /// A number.
    Number,
    /// The multipliers of an element; its constraints may be combined at will.
    Multipliers,
}

/// Equal blades that turn around one axis.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis) struct RotorBlades {
    /// Name; empty if it is the only one.
    pub name: String,
    /// Index of its first blade.
    pub first: usize,
    /// Number of its blades.
    pub count: usize,
    /// Axis about which each blade is turned into the next one, without deformation.
    pub axis: Vector3<f64>,
    /// Speed about it \[rad/s\].
    pub speed: f64,
}

impl RotorBlades {
    /// Its blades.
    pub fn blades(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.count
    }

    /// Numbers of waves with two coordinates, cosine and sine.
    pub fn waves(&self) -> usize {
        (self.count - 1) / 2
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
            _ if self.count.is_multiple_of(2) && j == self.count - 1 => "differential".to_owned(),
            _ if j.is_multiple_of(2) => several("sine"),
            _ => several("cosine"),
        }
    }
}

/// The coordinates of a model.
#[derive(Debug)]
pub(in crate::analysis) struct Coordinates {
    /// All unknowns.
    pub slots: Vec<Slot>,
    /// Index of the slot of each unknown.
    pub slot_of: Vec<usize>,
    /// Slots of the same part of all blades, by ascending azimuth.
    pub families: Vec<Vec<usize>>,
    /// The rotors.
    pub rotors: Vec<RotorBlades>,
    /// Index of the rotor of each blade.
    rotor_of: Vec<usize>,
    /// Azimuth of each blade at the time zero \[rad\].
    pub azimuths: Vec<f64>,
    /// Axes of each blade at the time zero (columns), of the root.
    pub blades: Vec<Matrix3<f64>>,
    /// The first node of each blade.
    roots: Vec<usize>,
    /// Axes of the blade in the axes of each node of a blade, without deformation.
    in_nodes: Vec<Option<Matrix3<f64>>>,
}

/// Factors of the coordinates at an instant, and their rates.
#[derive(Debug)]
pub(in crate::analysis) struct Factors {
    /// For each node of a blade B and its rate.
    turns: Vec<Option<[Matrix3<f64>; 2]>>,
    /// For each blade c_j and their rates.
    pub harmonics: Vec<Vec<[f64; 2]>>,
}

impl Coordinates {
    /// The coordinates of the rotors of a model, at rest.
    pub fn new(model: &Model) -> Result<Self, NoCoordinates> {
        let groups = rotors::groups(model)?;
        let mut rotors = Vec::new();
        let mut order: Vec<&BladeNodes> = Vec::new();
        for Group { name, blades, axis } in groups {
            rotors.push(RotorBlades {
                name,
                first: order.len(),
                count: blades.len(),
                axis,
                speed: 0.0,
            });
            order.extend(blades);
        }
        let numbers = rotors.iter().enumerate();
        let rotor_of = numbers.flat_map(|(number, own)| std::iter::repeat_n(number, own.count));
        let roots: Vec<_> = order
            .iter()
            .filter_map(|blade| blade.nodes.first().copied())
            .collect();
        let mut coordinates = Self {
            slots: Vec::new(),
            slot_of: Vec::new(),
            families: Vec::new(),
            rotor_of: rotor_of.collect(),
            rotors,
            azimuths: order.iter().map(|blade| blade.azimuth).collect(),
            blades: roots.iter().map(|node| model.naming[*node].blade).collect(),
            roots,
            in_nodes: Vec::new(),
        };
        coordinates.find(model, &order);
        coordinates.in_nodes = coordinates.in_nodes(model);
        Ok(coordinates)
    }

    /// The same with the speeds of the rotors in a state: whole turns in a period \[s\].
    pub fn turning(mut self, state: &State, period: f64) -> Self {
        let turned = self.turned(state);
        for (rotor, turned) in self.rotors.iter_mut().zip(turned) {
            let axis = turned * rotor.axis;
            let speeds = self.roots[rotor.blades()]
                .iter()
                .map(|node| state.nodes[*node].angular_velocity.dot(&axis));
            let mean = speeds.sum::<f64>() / rotor.count as f64;
            rotor.speed = (mean * period / TAU).round() * TAU / period;
        }
        self
    }

    /// The rotation of each rotor from the time zero to a state: the mean of its blades.
    pub fn turned(&self, state: &State) -> Vec<Matrix3<f64>> {
        let of_blade = |blade: usize| -> Matrix3<f64> {
            let node = self.roots[blade];
            let axes = self.in_nodes[node].map(|in_node| state.nodes[node].rotation * in_node);
            axes.unwrap_or(self.blades[blade]) * self.blades[blade].transpose()
        };
        let of_rotor = |rotor: &RotorBlades| {
            let sum: Matrix3<f64> = rotor.blades().map(of_blade).sum();
            let parts = sum.svd(true, true);
            let turn = parts.u.zip(parts.v_t).map(|(u, v)| u * v);
            turn.filter(|turn| turn.determinant() > 0.0)
                .unwrap_or_else(Matrix3::identity)
        };
        self.rotors.iter().map(of_rotor).collect()
    }

    /// The rotor of a blade.
    pub fn rotor_of(&self, blade: usize) -> &RotorBlades {
        &self.rotors[self.rotor_of[blade]]
    }

    /// The families of a rotor.
    pub fn families_of(&self, rotor: usize) -> impl Iterator<Item = &Vec<usize>> {
        let is_own = move |family: &&Vec<usize>| {
            let blade = family.first().and_then(|slot| self.slots[*slot].of_blade);
            blade.is_some_and(|(blade, _)| self.rotor_of[blade] == rotor)
        };
        self.families.iter().filter(is_own)
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
        let (rotors, rotor_of) = (&self.rotors, &self.rotor_of);
        let mut add = |slots: &mut Vec<Slot>, label: &str, number: usize, slot: Slot| {
            if let Some((blade, rest)) = of_blade(label, order) {
                let rotor = rotor_of[blade];
                let own = &rotors[rotor];
                named.add(
                    (rotor, rest, number),
                    (blade - own.first, own.count),
                    slots.len(),
                );
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
        self.add_families(named);
    }

    /// Adds the families of the slots that all blades of a rotor have.
    fn add_families(&mut self, named: Named) {
        for ((rotor, ..), members) in named.0 {
            let members: Option<Vec<_>> = members.into_iter().collect();
            let Some(members) = members else { continue };
            let first = self.rotors[rotor].first;
            for (blade, slot) in members.iter().enumerate() {
                self.slots[*slot].of_blade = Some((first + blade, self.families.len()));
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
        let of_node = |(node, in_node): (&NodeMotion, &Option<Matrix3<f64>>)| {
            in_node.map(|in_node| {
                let axes = node.rotation * in_node;
                [axes, node.angular_velocity.cross_matrix() * axes]
            })
        };
        let harmonics = self.azimuths.iter().enumerate().map(|(k, azimuth)| {
            let rotor = self.rotor_of(k);
            let psi = azimuth + rotor.speed * time;
            let mut factors = vec![[1.0, 0.0]];
            for order in 1..=rotor.waves() {
                let order = order as f64;
                let (sin, cos) = (order * psi).sin_cos();
                let rate = order * rotor.speed;
                factors.extend([[cos, -rate * sin], [sin, rate * cos]]);
            }
            if rotor.count.is_multiple_of(2) {
                let is_even = (k - rotor.first).is_multiple_of(2);
                factors.push([if is_even { 1.0 } else { -1.0 }, 0.0]);
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

/// Slots of all blades by their rotor, the name of their part without the blade, and their number in it.
#[derive(Default)]
struct Named(BTreeMap<(usize, String, usize), Vec<Option<usize>>>);

impl Named {
    /// Adds the slot of one of several blades; elements of different kinds may have one name.
    fn add(
        &mut self,
        (rotor, rest, number): (usize, String, usize),
        (blade, count): (usize, usize),
        slot: usize,
    ) {
        let mut number = number;
        loop {
            let all = self.0.entry((rotor, rest.clone(), number));
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
