//! The length of the blade of a windIO file, against the length of a blade that replaces it.

use super::fields::{self, Column};
use super::{Problems, is_version_1};
use crate::blade::Blade;
use crate::exchange::yaml;

/// Reference axes of a file, the first of which it has.
const AXES: [&[&str]; 3] = [
    &["components", "blade", "outer_shape_bem", "reference_axis"],
    &["components", "blade", "reference_axis"],
    &[
        "components",
        "blade",
        "elastic_properties_mb",
        "six_x_six",
        "reference_axis",
    ],
];

/// Difference of two lengths above which they belong to two blades [-]: a prebend that is or is not a
/// part of the length is below.
const OTHER: f64 = 0.05;

/// A remark if the length of `blade` differs by more than 5 % from the length of the blade in the windIO
/// file `existing`, whose other tables are given by parts of the length.
pub fn length_remark(blade: &Blade, existing: &str) -> Option<String> {
    let root = yaml::parse(existing).ok()?;
    let node = AXES.iter().find_map(|keys| root.path(keys))?;
    // problems of the file are reported where it is read
    let mut unreported = Problems::new("");
    let axis = fields::axis(node, &mut unreported)?;
    let straight = Column {
        grid: vec![0.0, 1.0],
        values: vec![0.0, 0.0],
    };
    let old = super::reference_line(&axis, &straight, existing, &mut Vec::new()).length();
    let new = blade.length();
    let kept = if is_version_1(existing) {
        "the reference axis, the shape and the layup"
    } else {
        "the shape and the layup"
    };
    ((new - old).abs() > OTHER * old).then(|| {
        format!(
            "the blade is {new:.4} m long, and the blade of the file {old:.4} m: {kept} of the file stay \
             as they are, at the same parts of the length"
        )
    })
}
