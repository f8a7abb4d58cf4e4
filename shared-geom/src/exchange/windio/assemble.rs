//! A blade from the tables of either version.

use nalgebra::{Matrix6, Vector2, Vector3};

use super::super::Reading;
use super::super::frame::Convention;
use super::super::plain::{stated_course, turns};
use super::super::stations::provenance;
use super::fields::{Column, SAME, interval};
use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::line::{Course, LinePoint, ReferenceLine};

/// Matrices on a grid of parts of the length.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Matrices {
    pub grid: Vec<f64>,
    pub matrices: Vec<Matrix6<f64>>,
}

impl Matrices {
    fn at(&self, part: f64) -> Matrix6<f64> {
        let (i, v) = interval(&self.grid, part);
        let matrix = |i: usize| self.matrices.get(i).copied().unwrap_or_default();
        match v {
            // The matrices at the positions of the grid are the file's, to the digit.
            v if v <= 0.0 => matrix(i),
            v if v >= 1.0 => matrix(i + 1),
            v => matrix(i) * (1.0 - v) + matrix(i + 1) * v,
        }
    }
}

/// Content of both versions, in the axes and with the signs of BeamDyn.
#[derive(Debug)]
pub(super) struct Tables {
    pub version: u32,
    pub axis: [Column; 3],
    /// Twist [rad].
    pub twist: Column,
    pub stiffness: Matrices,
    pub inertia: Matrices,
    /// Damping times [s].
    pub times: Option<[f64; 6]>,
    pub remarks: Vec<String>,
}

/// The blade of `tables` in Helicoid's axes.
pub(super) fn reading(tables: Tables, name: String, text: &str) -> Reading {
    let mut remarks = tables.remarks.clone();
    let line = line(&tables.axis, &tables.twist, text, &mut remarks);
    let length = line.length();
    let (stiff, mass) = (&tables.stiffness, &tables.inertia);
    let parts = union(&[&stiff.grid, &mass.grid]);
    if parts.len() != stiff.grid.len() || parts.len() != mass.grid.len() {
        remarks.push(
            "the grids of stiffness and inertia differ: stations at the positions of both"
                .to_owned(),
        );
    }
    let convention = Convention::BeamDyn;
    let station = |&part: &f64| Station {
        arc_length: part * length,
        stiffness: convention.to_ours(&stiff.at(part)),
        mass: convention.to_ours(&mass.at(part)),
    };
    let blade = Blade {
        name,
        line,
        reference_point: Vector2::zeros(),
        stations: parts.iter().map(station).collect(),
        interpolation: Interpolation::Linear,
        damping: tables.times.as_ref().and_then(damping),
        provenance: provenance(&format!("windIO {}", tables.version), &[text]),
    };
    Reading::new(blade, remarks)
}

fn damping(times: &[f64; 6]) -> Option<BladeDamping> {
    let ours = Convention::BeamDyn.values_to_ours(times);
    if ours.iter().all(|&time| time == 0.0) {
        return None;
    }
    let equal = ours.iter().all(|&time| time == ours[0]);
    Some(if equal {
        BladeDamping::Proportional(ours[0])
    } else {
        BladeDamping::Times(ours)
    })
}

/// The line of a reference axis \[m\] and its twist, positive nose down \[rad\]; its interpolation is the
/// one that `text` states, else a remark states which is taken.
pub fn line(
    [x, y, z]: &[Column; 3],
    twist: &Column,
    text: &str,
    remarks: &mut Vec<String>,
) -> ReferenceLine {
    let grids = [&x.grid, &y.grid, &z.grid, &twist.grid];
    let parts = union(&grids);
    let axes = Convention::BeamDyn.axes();
    let point = |&part: &f64| LinePoint {
        position: axes * Vector3::new(x.at(part), y.at(part), z.at(part)),
        twist: 0.0,
    };
    let points: Vec<_> = parts.iter().map(point).collect();
    let course = stated_course(text).unwrap_or_else(|| {
        let grows = points
            .windows(2)
            .all(|two| two[1].position.x > two[0].position.x);
        let (course, words) = if grows {
            (Course::Spline, "a cubic spline")
        } else {
            (Course::Polyline, "straight lines")
        };
        remarks.push(format!(
            "the interpolation between the {} points of the reference axis is not stated: {words}",
            points.len()
        ));
        course
    });
    let mut line = ReferenceLine::through(points, course);
    let twists: Vec<_> = turns(&line).into_iter().zip(&parts).collect();
    for (point, (turn, &part)) in line.points.iter_mut().zip(twists) {
        point.twist = turn - twist.at(part);
    }
    line
}

/// All positions of the grids, increasing; positions that differ by round-off are one.
fn union(grids: &[&Vec<f64>]) -> Vec<f64> {
    let mut all: Vec<f64> = grids.iter().flat_map(|grid| grid.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, kept| *next - *kept <= SAME);
    all
}
