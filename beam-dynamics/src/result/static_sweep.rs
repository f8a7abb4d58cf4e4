//! Equilibria over a parameter.

use nalgebra::Vector3;
use shared_geom::rotation::vector;

use super::{StaticResult, StaticStep};
use crate::case::BladeNodes;
use crate::elements::RotorAir;

/// Deformation of a blade at its tip.
///
/// With the position x, the rotation R of a node and the axes B of the undeformed blade, and with
/// the motion of the root taken away, of the root r and the tip t:
///
/// ```text
/// H = R_r R_r0^T          u = B^T (H^T (x_t - x_r) - (x_t0 - x_r0))       w = B^T vect(H^T R_t R_t0^T)
/// ```
///
/// where zero denotes the undeformed state and vect the vector of a rotation.
#[derive(Debug, Clone, PartialEq)]
pub struct TipMotion {
    /// Name of the blade.
    pub blade: String,
    /// Displacement of the tip along the axis of rotation of the model, with the motion of the root
    /// [m].
    pub along_axis: f64,
    /// Third component of u: up from the blade, which turns with the pitch [m].
    pub flap: f64,
    /// Second component of u: toward the leading edge [m].
    pub edge: f64,
    /// First component of w: nose up [rad].
    pub twist: f64,
}

impl TipMotion {
    /// The deformation of a blade in an equilibrium of a model that turns about `axis`; `None` for a
    /// blade without nodes.
    pub fn of(
        blade: &BladeNodes,
        (result, step): (&StaticResult, &StaticStep),
        axis: &Vector3<f64>,
    ) -> Option<Self> {
        let (root, tip) = (*blade.nodes.first()?, *blade.nodes.last()?);
        let [root_node, tip_node] = [result.nodes.get(root)?, result.nodes.get(tip)?];
        let turn = step.rotations[root] * root_node.rotation.transpose();
        let moved = turn.transpose() * (step.positions[tip] - step.positions[root])
            - (tip_node.position - root_node.position);
        let moved = blade.axes.transpose() * moved;
        let turned = turn.transpose() * step.rotations[tip] * tip_node.rotation.transpose();
        let turned = blade.axes.transpose() * vector::from_rotation(&turned);
        Some(Self {
            blade: blade.name.clone(),
            along_axis: (step.positions[tip] - tip_node.position).dot(axis),
            flap: moved.z,
            edge: moved.y,
            twist: turned.x,
        })
    }
}

/// The equilibrium at one value of the parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticSweepPoint {
    /// Value of the parameter of the sweep \[its unit\].
    pub at: f64,
    /// All parameters of the file with their values \[unit of each\].
    pub parameters: Vec<(String, f64)>,
    /// Air on each rotor at the last load step, by its name.
    pub rotors: Vec<(String, RotorAir)>,
    /// Deformation of each blade at the last load step.
    pub tips: Vec<TipMotion>,
    /// The load path at this value; without steps if the file cannot be read or nothing was found.
    pub path: Option<StaticResult>,
    /// Reason of an end before the requested load factor, with the remedy.
    pub failure: Option<[String; 2]>,
}

/// Equilibria at all values of a parameter, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticSweep {
    /// Name of the model.
    pub name: String,
    /// Name of the parameter.
    pub parameter: String,
    /// The points.
    pub points: Vec<StaticSweepPoint>,
    /// Remarks.
    pub remarks: Vec<String>,
}

impl StaticSweep {
    /// Names of the other parameters whose values are not the same at all points.
    pub fn varying(&self) -> Vec<&str> {
        let Some(first) = self.points.iter().find(|own| !own.parameters.is_empty()) else {
            return Vec::new();
        };
        let differs = |name: &str, value: f64| {
            let mut others = self.points.iter().flat_map(|point| &point.parameters);
            others.any(|other| other.0 == name && other.1 != value)
        };
        let names = first.parameters.iter();
        let varying =
            names.filter(|(name, value)| *name != self.parameter && differs(name, *value));
        varying.map(|own| own.0.as_str()).collect()
    }

    /// Number of points whose load path is complete.
    pub fn found(&self) -> usize {
        let complete = self.points.iter().filter(|point| point.failure.is_none());
        complete.count()
    }
}
