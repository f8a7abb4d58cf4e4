//! Circular tubes.

use std::f64::consts::TAU;

use shared_geom::mesh::{CellKind, Mesh};

use super::builder::{self, Shape, block, border, build, cells_per_quad};
use super::problem::{self, GenerateProblem};

/// A circular tube, centered at the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    /// Outer radius [unit of the mesh].
    pub outer_radius: f64,
    /// Thickness of the wall, less than the radius [unit of the mesh].
    pub thickness: f64,
    /// Cells around, at least 3; triangles come in pairs.
    pub cells_around: usize,
    /// Cells through the wall; triangles come in pairs.
    pub cells_through: usize,
    /// Kind of the cells.
    pub kind: CellKind,
    /// Whether the side middles of quadratic cells lie on the circle; otherwise the tube
    /// is a polygon, as for linear cells.
    pub curved: bool,
}

impl Tube {
    /// The mesh, with the physical surface `wall` and physical curves `inner` and
    /// `outer`, which both run clockwise from +y.
    ///
    /// # Errors
    /// All invalid dimensions.
    pub fn generate(&self) -> Result<Mesh, Vec<GenerateProblem>> {
        self.check()?;
        let step = builder::step(self.kind);
        let (around, through) = (self.cells_around * step, self.cells_through * step);
        // i runs clockwise, j outward, to its left
        let point = |i: usize, j: usize| j * around + i % around;
        let mut points = Vec::with_capacity(around * (through + 1));
        for j in 0..=through {
            let inward = 1.0 - j as f64 / through as f64;
            let radius = self.outer_radius - self.thickness * inward;
            for i in 0..around {
                let (sine, cosine) = (TAU * i as f64 / around as f64).sin_cos();
                points.push([radius * cosine, -radius * sine]);
            }
        }
        let borders = vec![
            border("inner", self.cells_around, step, |i| point(i, 0)),
            border("outer", self.cells_around, step, |i| point(i, through)),
        ];
        let shape = Shape {
            points,
            quads: block([self.cells_around, self.cells_through], step, point),
            borders,
            surface: "wall".into(),
        };
        Ok(build(shape, self.kind, self.curved))
    }

    fn check(&self) -> Result<(), Vec<GenerateProblem>> {
        let mut problems = Vec::new();
        problem::check_length("outer radius", self.outer_radius, &mut problems);
        problem::check_length("thickness", self.thickness, &mut problems);
        if problems.is_empty() && self.thickness >= self.outer_radius {
            problems.push(GenerateProblem::NoHole {
                thickness: self.thickness,
                outer_radius: self.outer_radius,
            });
        }
        problem::check_cells("cells around", self.cells_around, 3, &mut problems);
        problem::check_cells(
            "cells through the wall",
            self.cells_through,
            1,
            &mut problems,
        );
        let factors = [
            self.cells_around,
            self.cells_through,
            cells_per_quad(self.kind),
        ];
        problem::check_total(&factors, &mut problems);
        problem::outcome(problems)
    }
}
