//! Counts, numbers and positions as text.

pub(crate) use shared_geom::error::counted;

/// A number with at most six digits.
pub(crate) fn short(value: f64) -> String {
    let rounded = format!("{value:.5e}").parse().unwrap_or(value);
    let text = format!("{rounded:?}");
    text.strip_suffix(".0").unwrap_or(&text).to_string()
}

/// A position in the mesh file, `(1, 2.5)`.
pub(super) fn coordinates([x, y]: [f64; 2]) -> String {
    format!("({}, {})", short(x), short(y))
}
