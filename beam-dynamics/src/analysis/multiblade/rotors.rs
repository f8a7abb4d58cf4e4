//! Which blades are of one rotor: blades of one name without their number, or else all of them.

use nalgebra::Vector3;
use shared_geom::rotation::vector;

use crate::case::{BladeNodes, Model};

/// Difference of the rotations between successive blades, beyond which they are not equal \[-\].
const EQUAL: f64 = 1e-6;

/// Equal blades around an axis.
pub(super) struct Group<'a> {
    /// Name; empty if there are no others.
    pub name: String,
    /// By ascending azimuth.
    pub blades: Vec<&'a BladeNodes>,
    /// The axis about which each blade is turned into the next one.
    pub axis: Vector3<f64>,
}

/// Why a rotor has no multiblade coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis) struct NoCoordinates(pub &'static str);

/// The reason of rotors with one blade, or without any.
pub(in crate::analysis) const FEW: NoCoordinates =
    NoCoordinates("the rotor has fewer than three blades");

/// The rotors of a model, of two or more blades each.
pub(super) fn groups(model: &Model) -> Result<Vec<Group<'_>>, NoCoordinates> {
    if model.blades.is_empty() {
        return Err(FEW);
    }
    let mut named: Vec<(&str, Vec<&BladeNodes>)> = Vec::new();
    for blade in &model.blades {
        let name = stem(&blade.name);
        match named.iter_mut().find(|own| own.0 == name) {
            Some((_, blades)) => blades.push(blade),
            None => named.push((name, vec![blade])),
        }
    }
    let is_single = named.len() == 1;
    let of_names = named.into_iter().map(|(name, blades)| {
        let name = if is_single {
            String::new()
        } else {
            name.to_owned()
        };
        group(model, name, blades)
    });
    let of_names: Result<Vec<_>, _> = of_names.collect();
    of_names.or_else(|_| {
        let all = model.blades.iter().collect();
        Ok(vec![group(model, String::new(), all)?])
    })
}

/// The name of a blade without its number.
fn stem(name: &str) -> &str {
    name.trim_end_matches(|c: char| c.is_ascii_digit())
        .trim_end_matches([' ', '_', '-'])
}

fn group<'a>(
    model: &Model,
    name: String,
    mut blades: Vec<&'a BladeNodes>,
) -> Result<Group<'a>, NoCoordinates> {
    blades.sort_by(|a, b| a.azimuth.total_cmp(&b.azimuth));
    if blades.len() < 2 {
        return Err(FEW);
    }
    let root = |blade: &&BladeNodes| blade.nodes.first().map(|node| model.naming[*node].blade);
    let axes: Vec<_> = blades.iter().filter_map(root).collect();
    let pairs = axes.iter().zip(axes.iter().cycle().skip(1));
    let turns: Vec<_> = pairs.map(|(a, b)| b * a.transpose()).collect();
    let turn = turns.first();
    let axis = turn.and_then(|turn| vector::from_rotation(turn).try_normalize(0.0));
    let Some((turn, axis)) = turn.zip(axis) else {
        return Err(NoCoordinates("the blades are not around an axis"));
    };
    if turns.iter().any(|other| (other - turn).amax() > EQUAL) {
        return Err(NoCoordinates(
            "the blades are not at equal angles around one axis, as the ones of several rotors",
        ));
    }
    Ok(Group { name, blades, axis })
}
