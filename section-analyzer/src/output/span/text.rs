//! The summary of a blade.

use shared_geom::blade::Blade;

use crate::mesh::short;

/// Length, mass, center of mass and moment of inertia about the root of a blade, in lines.
pub fn span_text(blade: &Blade) -> String {
    let moments = blade.mass_moments();
    let [x, y, z] = moments.center.into();
    let positions: Vec<f64> = blade.stations.iter().map(|one| one.arc_length).collect();
    let (from, to) = (positions.first().copied(), positions.last().copied());
    let ends = [from, to].map(|end| short(end.unwrap_or_default()));
    format!(
        "Blade \"{}\": {} stations from {} to {} m of {} m\n  \
         mass                          {} kg\n  \
         center of mass (x, y, z)      ({}, {}, {}) m\n  \
         first moment about the root   {} kg m\n  \
         flap inertia about the root   {} kg m^2\n",
        blade.name,
        positions.len(),
        ends[0],
        ends[1],
        short(blade.length()),
        short(moments.mass),
        short(x),
        short(y),
        short(z),
        short(moments.mass * x),
        short(moments.inertia[(1, 1)]),
    )
}
