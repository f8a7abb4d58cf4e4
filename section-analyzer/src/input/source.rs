//! The data from which a section was made, and everything that moves with a node of the
//! mesh file: nodes of laminates, and plane angles.

use std::f64::consts::{PI, TAU};

use shared_geom::document::Document;
use shared_geom::error::Explain;
use shared_geom::mesh::Mesh;
use shared_geom::units::Dimension;
use thiserror::Error;

use super::follow::{Parabola, direction};
use super::laminae::add_with_faces;
use crate::mesh::{CurveLine, Lamina, SectionMesh};
use crate::properties::AreaMoments;
use crate::section::Section;
use crate::sensitivity::{Axis, CellTurn, MeshNode, Motion, NodeVelocity};

/// Step of the differences, relative to the distance of the node's nearest neighbor.
/// Their error is the square of the step times the cube of the stretch at sharp corners,
/// plus 1e-16 of the size of the section divided by the step: 1e-8 if neighbors are a
/// thousandth of the size apart.
const STEP: f64 = 1e-5;

/// Largest change of a rate within a step, relative to the rate. For smooth motions it is
/// [`STEP`] times the curvature of the result, a few hundred at the sharpest corner. If a
/// decision of the laminates or the nearest line of a curve changes, it is one or more.
const SMOOTH: f64 = 2e-2;

/// The mesh of the file, with the data of its laminates and angles.
#[derive(Debug, Clone, Default)]
pub struct Source {
    /// The mesh of the file, without laminates.
    mesh: Mesh,
    /// Its unit of length \[m\].
    meters_per_unit: f64,
    /// The laminates along its lines.
    laminae: Vec<Lamina>,
    /// Their names.
    names: Vec<Option<String>>,
    /// For each of its cells the curve that the plane angle follows: label of a physical
    /// curve.
    follows: Vec<Option<String>>,
}

/// Reasons for which a node of the mesh file cannot be a parameter.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum NodeProblem {
    /// A node that the file does not have.
    #[error("the mesh \"{mesh}\" has no node {node}")]
    Missing {
        /// Tag of the node.
        node: u64,
        /// Name of the mesh file.
        mesh: String,
        /// The nearest tag of the file.
        nearest: Option<u64>,
    },
    /// A node made by a laminate.
    #[error("node {node} is not in the mesh \"{mesh}\": a laminate has made it")]
    Made {
        /// Tag of the node.
        node: u64,
        /// Name of the mesh file.
        mesh: String,
    },
    /// A node on which the section does not depend.
    #[error(
        "node {node} of the mesh \"{mesh}\" belongs to no cell and to no line that a laminate or an angle follows"
    )]
    Free {
        /// Tag of the node.
        node: u64,
        /// Name of the mesh file.
        mesh: String,
    },
    /// The section changes by a jump as the node moves.
    #[error(
        "as node {node} moves, {what} at y = {y:.6e} m, z = {z:.6e} m changes by a jump: there is no derivative"
    )]
    Jump {
        /// Tag of the node.
        node: u64,
        /// The quantity with the jump.
        what: &'static str,
        /// Its y coordinate \[m\].
        y: f64,
        /// Its z coordinate \[m\].
        z: f64,
    },
}

impl Explain for NodeProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::Missing { nearest, .. } => {
                return nearest.map(|node| format!("the nearest number in the file is {node}"));
            }
            Self::Made { .. } => {
                "name nodes of the lines with laminates: the nodes of laminates move with them"
            }
            Self::Free { .. } => "give a node of a cell, or of a line with a laminate",
            Self::Jump { what, .. } if *what == ANGLE => {
                "two lines of the curve that its plane angle follows are equally near: move a node a little"
            }
            Self::Jump { .. } => {
                "the lines meet at 15 degrees there, or at the limit of another rule of laminates: move a node a little"
            }
        };
        Some(help.to_owned())
    }
}

const NODE: &str = "the node of a laminate";
const ANGLE: &str = "the plane angle of the cell";

/// Positions of all nodes, and plane angles of all moving cells, for one position of a
/// node.
struct Shape {
    mesh: SectionMesh,
    /// Angles of the cells that [`Source::turning`] lists, then of the cells of laminates
    /// \[rad\].
    angles: Vec<f64>,
}

impl Source {
    /// A mesh in the unit of length of `document`, the laminates along its lines, and the
    /// curve that each of its cells follows.
    pub(super) fn new(
        document: &Document,
        mesh: Mesh,
        (laminae, names): (Vec<Lamina>, Vec<Option<String>>),
        follows: Vec<Option<String>>,
    ) -> Self {
        Self {
            mesh,
            meters_per_unit: document.factor(Dimension::LENGTH),
            laminae,
            names,
            follows,
        }
    }

    /// The coordinate along `axis` of the node `tag`, with everything that moves with it.
    ///
    /// ```text
    /// dx/dp = (x(p + h) - x(p - h)) / 2h
    /// ```
    /// for the nodes and plane angles that laminates and curves add to the mesh.
    ///
    /// # Errors
    /// [`NodeProblem`]; `name` is the name of the mesh file.
    pub fn coordinate(
        &self,
        section: &Section,
        name: &str,
        tag: u64,
        axis: Axis,
    ) -> Result<MeshNode, NodeProblem> {
        let mesh = || name.to_owned();
        let nodes = &self.mesh.nodes;
        let own = section.mesh.node_tags.iter().position(|&of| of == tag);
        let Some(index) = nodes.iter().position(|node| node.tag == tag) else {
            let tags = nodes.iter().map(|node| node.tag);
            let nearest = tags.min_by_key(|known| known.abs_diff(tag));
            return Err(match own {
                Some(_) => NodeProblem::Made {
                    node: tag,
                    mesh: mesh(),
                },
                None => NodeProblem::Missing {
                    node: tag,
                    mesh: mesh(),
                    nearest,
                },
            });
        };
        let position = nodes[index].position;
        let (value, way) = match axis {
            Axis::Y => (position.x, [1.0, 0.0]),
            Axis::Z => (position.y, [0.0, 1.0]),
        };
        let mut motion = self.made_by(section, index as u32, way)?;
        motion.nodes.retain(|at| Some(at.node) != own);
        let [y, z] = way;
        motion
            .nodes
            .extend(own.map(|node| NodeVelocity { node, y, z }));
        if motion == Motion::default() {
            return Err(NodeProblem::Free {
                node: tag,
                mesh: mesh(),
            });
        }
        Ok(MeshNode {
            tag,
            axis,
            value: self.meters_per_unit * value,
            motion,
        })
    }

    /// Everything that moves with a node of the mesh, except the node itself.
    fn made_by(&self, section: &Section, node: u32, way: [f64; 2]) -> Result<Motion, NodeProblem> {
        let turning = self.turning(node);
        let is_laminated = self.laminae.iter().any(|lamina| {
            let lines = self.mesh.lines.iter();
            let mut lines = lines.filter(|line| line.groups.contains(lamina.curve));
            lines.any(|line| line.nodes().contains(&node))
        });
        if !is_laminated && turning.is_empty() {
            return Ok(Motion::default());
        }
        let tag = self.mesh.nodes[node as usize].tag;
        let neighbor = self.neighbor(node);
        let step = STEP * neighbor;
        let at = |steps: f64| {
            let by = way.map(|x| steps * step * x);
            let position = self.mesh.nodes[node as usize].position;
            self.shape(section, (node, by), &turning)
                .ok_or(NodeProblem::Jump {
                    node: tag,
                    what: NODE,
                    y: self.meters_per_unit * position.x,
                    z: self.meters_per_unit * position.y,
                })
        };
        let shapes = [at(-1.0)?, at(0.0)?, at(1.0)?];
        let jump = |what, [y, z]: [f64; 2]| NodeProblem::Jump {
            node: tag,
            what,
            y,
            z,
        };
        let meters = self.meters_per_unit;
        let mut motion = Motion::default();
        for node in 0..section.mesh.nodes.len() {
            let positions = shapes.each_ref().map(|shape| shape.mesh.nodes[node]);
            let rate =
                [0, 1].map(|i| rate(positions.map(|position| position[i]), meters * step, 1.0));
            let [Some(y), Some(z)] = rate else {
                return Err(jump(NODE, positions[1]));
            };
            if y != 0.0 || z != 0.0 {
                motion.nodes.push(NodeVelocity { node, y, z });
            }
        }
        let of_laminae = self.mesh.cells.len()..section.cells.len();
        for (index, cell) in turning.into_iter().chain(of_laminae).enumerate() {
            let angles = shapes.each_ref().map(|shape| shape.angles[index]);
            let angles = angles.map(|angle| nearest_turn(angle, angles[1]));
            let Some(rate) = rate(angles, meters * step, 1.0 / (meters * neighbor)) else {
                let position = section.mesh.middle(&section.mesh.cells[cell]);
                return Err(jump(ANGLE, position));
            };
            if rate != 0.0 {
                motion.turns.push(CellTurn { cell, rate });
            }
        }
        Ok(motion)
    }

    /// The cells of the mesh whose plane angle may change with a node: its own cells, and
    /// all cells that follow one of its curves.
    fn turning(&self, node: u32) -> Vec<usize> {
        let mut moved: Vec<String> = Vec::new();
        for line in self
            .mesh
            .lines
            .iter()
            .filter(|line| line.nodes().contains(&node))
        {
            let groups = line.groups.iter();
            moved.extend(groups.filter_map(|group| Some(self.mesh.groups.get(group)?.label())));
        }
        let cells = self.mesh.cells.iter().zip(&self.follows).enumerate();
        let turns = cells.filter(|(_, (cell, follows))| {
            let follows = follows.as_ref();
            // a curve that is not in the file is the face of a laminate
            let is_made = |label: &String| self.mesh.groups.iter().all(|of| of.label() != *label);
            follows.is_some_and(|label| {
                moved.contains(label) || is_made(label) || cell.nodes().contains(&node)
            })
        });
        turns.map(|(index, _)| index).collect()
    }

    /// Distance to the nearest node of the same cell or line [mesh unit].
    fn neighbor(&self, node: u32) -> f64 {
        let cells = self.mesh.cells.iter().map(|cell| cell.nodes());
        let lines = self.mesh.lines.iter().map(|line| line.nodes());
        let position = |node: u32| self.mesh.nodes[node as usize].position.xy();
        let beside = cells.chain(lines).filter(|nodes| nodes.contains(&node));
        let others = beside.flatten().filter(|&&other| other != node);
        let distances = others.map(|&other| (position(other) - position(node)).norm());
        distances.filter(|&d| d > 0.0).fold(f64::INFINITY, f64::min)
    }

    /// The section with a node of the mesh moved by `by` [mesh unit]; `None` if the
    /// laminates fail or have other cells.
    fn shape(
        &self,
        section: &Section,
        (node, by): (u32, [f64; 2]),
        turning: &[usize],
    ) -> Option<Shape> {
        let mut mesh = self.mesh.clone();
        let position = &mut mesh.nodes[node as usize].position;
        position.x += by[0];
        position.y += by[1];
        let (laminated, _) = add_with_faces(&mut mesh, &self.names, &self.laminae).ok()?;
        let mesh = section
            .mesh
            .with_positions_of(&mesh, self.meters_per_unit)?;
        let mut angles = Vec::with_capacity(turning.len() + laminated.cells.len());
        let mut known: Option<(&str, Vec<Parabola>)> = None;
        for &cell in turning {
            let label = self.follows[cell].as_deref()?;
            let curve = match known.take() {
                Some(curve) if curve.0 == label => curve,
                _ => (label, parabolas(&mesh, label)?),
            };
            let centroid = AreaMoments::of_cell(&mesh, &mesh.cells[cell], [0.0; 2]).centroid();
            angles.push(direction(&curve.1, centroid)?);
            known = Some(curve);
        }
        angles.extend(laminated.cells.iter().map(|cell| cell.direction));
        Some(Shape { mesh, angles })
    }
}

/// The lines of a physical curve.
pub(super) fn parabolas(mesh: &SectionMesh, label: &str) -> Option<Vec<Parabola>> {
    let curve = mesh.curves.iter().find(|curve| curve.label == label)?;
    let line = |line: &CurveLine| Parabola::new(line.first, line.second, line.middle);
    Some(curve.lines.iter().map(line).collect())
}

/// The central difference; `None` if its two sides differ.
fn rate([before, here, behind]: [f64; 3], step: f64, unit: f64) -> Option<f64> {
    let rate = (behind - before) / (2.0 * step);
    let change = (behind - 2.0 * here + before) / step;
    let is_smooth = change.abs() <= SMOOTH * rate.abs().max(unit);
    is_smooth.then_some(rate)
}

/// `angle` plus whole turns, nearest to another angle.
fn nearest_turn(angle: f64, other: f64) -> f64 {
    other + (angle - other + PI).rem_euclid(TAU) - PI
}
