//! Roots over a parameter: values, values between them where they are needed, and boundaries.
//!
//! 1. The roots at all requested values.
//! 2. Intervals in which the number of unstable roots changes by another number than the modes that
//!    were followed explain, or in which modes pass in both directions, are halved.
//! 3. Where the growth of a mode has a maximum near zero between two values, the value of the
//!    maximum is added.
//! 4. Boundaries are found between values with different numbers of unstable roots.

use super::crossing;
use super::follow::{links, number};
use super::request::{Evaluate, ScanSettings};
use super::seen::show_most;
use super::touching;
use super::votes::settle;
use crate::result::{StabilityBoundary, StabilityPoint, StabilityRoot};

/// Halvings of the smallest distance of requested values.
const HALVINGS: i32 = 6;
/// Values that are added at maxima, for each requested value.
const MAXIMA: usize = 8;

/// The outcome of a scan.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scan {
    /// The values that succeeded, ascending.
    pub points: Vec<StabilityPoint>,
    /// Names of the modes.
    pub modes: Vec<String>,
    /// The boundaries, ascending.
    pub boundaries: Vec<StabilityBoundary>,
    /// Values that failed \[unit of the parameter\], with reason and remedy.
    pub failures: Vec<(f64, [String; 2])>,
    /// Remarks.
    pub remarks: Vec<String>,
}

/// Scans the values.
pub fn scan(settings: &ScanSettings, evaluate: Evaluate<'_>) -> Scan {
    let mut scanner = Scanner {
        settings,
        evaluate: &mut *evaluate,
        scan: Scan::default(),
    };
    for &at in &settings.values {
        scanner.add(at, true);
    }
    if settings.boundaries {
        scanner.divide();
        scanner.add_maxima();
        scanner.divide();
    }
    let mut scan = scanner.scan;
    settle(&mut scan.points);
    scan.modes = number(&mut scan.points);
    show_most(&mut scan.points, scan.modes.len());
    if settings.boundaries {
        let mut found = touching::touching(settings, &scan.points, &scan.modes);
        for index in 1..scan.points.len() {
            let ends = [&scan.points[index - 1], &scan.points[index]];
            match crossing::crossings(ends, &scan.modes, settings.tolerance, &mut *evaluate) {
                Ok(own) => found.extend(own),
                Err(failure) if scan.failures.iter().any(|own| own.0 == failure.0) => {}
                Err(failure) => scan.failures.push(failure),
            }
        }
        found.sort_by(|a, b| a.at.total_cmp(&b.at));
        scan.boundaries = found;
    }
    announce(&mut scan);
    scan
}

struct Scanner<'a, 'b> {
    settings: &'a ScanSettings,
    evaluate: Evaluate<'b>,
    scan: Scan,
}

impl Scanner<'_, '_> {
    /// Adds a value in its place; returns whether it succeeded.
    fn add(&mut self, at: f64, is_requested: bool) -> bool {
        if self.scan.failures.iter().any(|failed| failed.0 == at) {
            return false;
        }
        let mut roots = match (self.evaluate)(at) {
            Ok(roots) => roots,
            Err(failure) => {
                self.scan.failures.push((at, failure));
                return false;
            }
        };
        roots.sort_by(|a, b| b.growth().total_cmp(&a.growth()));
        let point = StabilityPoint {
            at,
            is_requested,
            roots,
            modes: Vec::new(),
            controls: Vec::new(),
        };
        let points = &mut self.scan.points;
        let index = points.partition_point(|other| other.at < at);
        points.insert(index, point);
        true
    }

    /// Halves the intervals whose boundaries are not clear.
    fn divide(&mut self) {
        let values = self.settings.values.windows(2);
        let smallest = values
            .map(|pair| (pair[1] - pair[0]).abs())
            .fold(f64::INFINITY, f64::min);
        let least = smallest * 0.5_f64.powi(HALVINGS) * (1.0 + 1e-9);
        let mut index = 1;
        while index < self.scan.points.len() {
            let [a, b] = [&self.scan.points[index - 1], &self.scan.points[index]];
            let (low, high) = (a.at, b.at);
            let is_clear = high - low <= least || is_clear(a, b);
            if is_clear || !self.add(0.5 * (low + high), false) {
                index += 1;
            }
        }
    }

    /// Adds values at maxima of the growth near zero.
    fn add_maxima(&mut self) {
        for _ in 0..MAXIMA * self.settings.values.len() {
            let next = touching::next_maximum(self.settings, &self.scan.points);
            match next {
                Some(at) if self.add(at, false) => {}
                _ => return,
            }
        }
    }
}

/// Whether the modes that were followed explain the change of the number of unstable roots, and none
/// passes against the others.
fn is_clear(a: &StabilityPoint, b: &StabilityPoint) -> bool {
    let change = |from: &StabilityRoot, to: &StabilityRoot| {
        to.unstable() as isize - from.unstable() as isize
    };
    let followed = links(&a.roots, &b.roots);
    let pairs = a.roots.iter().zip(followed);
    let changes = pairs.filter_map(|(root, link)| Some(change(root, &b.roots[link?.to])));
    let changes: Vec<_> = changes.collect();
    let whole = b.unstable() as isize - a.unstable() as isize;
    let is_mixed = changes.iter().any(|one| *one > 0) && changes.iter().any(|one| *one < 0);
    !is_mixed && changes.iter().sum::<isize>() == whole
}

/// Remarks on modes that are unstable where they are first seen.
fn announce(scan: &mut Scan) {
    let mut is_known = vec![false; scan.modes.len()];
    for (index, point) in scan.points.iter().enumerate() {
        for (root, mode) in point.roots.iter().zip(&point.modes) {
            if !is_known[*mode] && index > 0 && root.is_unstable() {
                let (name, at) = (&scan.modes[*mode], point.at);
                scan.remarks.push(format!(
                    "the unstable mode \"{name}\" is new at {at}: no mode before it is like it"
                ));
            }
            is_known[*mode] = true;
        }
    }
}
