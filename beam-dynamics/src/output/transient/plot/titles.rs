//! Titles of vertical axes: the quantity of the columns, and its unit.

use shared_geom::figure::{Label, TEXT, text_width};

/// Units and the quantities that they measure, for columns whose meaning is not known.
const QUANTITIES: [(&str, &[&str]); 13] = [
    ("length", &["m", "mm", "cm", "um", "km", "in", "ft"]),
    ("angle", &["rad", "deg", "rev", "mrad"]),
    ("speed", &["m/s", "mm/s", "km/h", "ft/s", "in/s"]),
    ("angular velocity", &["rad/s", "deg/s", "rpm", "rev/s"]),
    ("acceleration", &["m/s^2", "mm/s^2", "ft/s^2"]),
    ("angular acceleration", &["rad/s^2", "deg/s^2"]),
    ("force", &["N", "kN", "MN", "mN", "lbf"]),
    (
        "moment",
        &["N m", "kN m", "MN m", "N mm", "lbf ft", "lbf in"],
    ),
    ("energy", &["J", "kJ", "mJ", "MJ"]),
    ("power", &["W", "kW", "mW", "MW"]),
    ("voltage", &["V", "kV", "mV"]),
    ("current", &["A", "mA", "uA"]),
    ("charge", &["C", "mC", "uC", "nC"]),
];
/// Components at the end of the name of a quantity.
const COMPONENTS: [&str; 4] = [" x", " y", " z", " magnitude"];
/// Largest length of a title beyond its axis \[figure pixels\].
const BEYOND: f64 = 2.0 * TEXT;

/// Title for columns of a unit, as long as the length `space` of the axis allows
/// \[figure pixels\]: `position y of tip [m]`, `position of tip [m]`, `position [m]`, or by the
/// unit alone `length [m]`. `meanings` are texts such as `position y of tip`, empty if unknown; the
/// name of a single one of the columns `names` is the title if its meaning is unknown, or does not fit,
/// as an expression, while its unit does not state the quantity.
pub(super) fn title(names: &[String], meanings: &[String], unit: &str, space: f64) -> String {
    let unit = unit.replace('*', " ");
    if let ([name], true) = (names, meanings.iter().all(String::is_empty)) {
        return format!("{name} [{unit}]");
    }
    let candidates = [
        common(meanings.iter().map(String::as_str)),
        common(meanings.iter().map(|text| without_component(text))),
        common(meanings.iter().map(|text| split(text).0)),
        common(meanings.iter().map(|text| bare(split(text).0).to_owned())),
    ];
    let titles = candidates.into_iter().flatten();
    let titles: Vec<_> = titles
        .map(|quantity| format!("{quantity} [{unit}]"))
        .collect();
    let fits = |title: &&String| text_width(title, Label::new(TEXT)) <= space + BEYOND;
    if let Some(title) = titles.iter().find(fits) {
        return title.clone();
    }
    match (quantity(&unit), titles.last(), names) {
        (Some(quantity), ..) => format!("{quantity} [{unit}]"),
        (None, _, [name]) => format!("{name} [{unit}]"),
        (None, Some(long), _) => long.clone(),
        _ if unit == "-" => "number [-]".to_owned(),
        _ => format!("value [{unit}]"),
    }
}

/// The text that all share, unless it is empty.
fn common<T: PartialEq + Into<String>>(mut texts: impl Iterator<Item = T>) -> Option<String> {
    let first = texts.next()?;
    let is_common = texts.all(|text| text == first);
    let first = first.into();
    (is_common && !first.is_empty()).then_some(first)
}

/// Quantity and owner of `position y of tip`.
fn split(meaning: &str) -> (&str, Option<&str>) {
    match meaning.split_once(" of ") {
        Some((quantity, owner)) => (quantity, Some(owner)),
        None => (meaning, None),
    }
}

/// The quantity without its component.
fn bare(quantity: &str) -> &str {
    let mut found = COMPONENTS.iter();
    found
        .find_map(|component| quantity.strip_suffix(component))
        .unwrap_or(quantity)
}

fn without_component(meaning: &str) -> String {
    match split(meaning) {
        (quantity, Some(owner)) => format!("{} of {owner}", bare(quantity)),
        (quantity, None) => bare(quantity).to_owned(),
    }
}

fn quantity(unit: &str) -> Option<&'static str> {
    let of_unit = |known: &&(&str, &[&str])| known.1.contains(&unit);
    QUANTITIES.iter().find(of_unit).map(|known| known.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_state_their_quantities() {
        let titles = ["N m", "mm", "rpm", "J", "-", "Pa"].map(|unit| title(&[], &[], unit, 1e3));
        let expected = [
            "moment [N m]",
            "length [mm]",
            "angular velocity [rpm]",
            "energy [J]",
            "number [-]",
            "value [Pa]",
        ];
        assert_eq!(titles, expected);
        let names = ["count".to_owned()];
        assert_eq!(title(&names, &[String::new()], "-", 1e3), "count [-]");
        assert_eq!(title(&names, &[], "mm", 1e3), "count [mm]");
        let long = ["the way of a point".to_owned()];
        assert_eq!(title(&names, &long, "mm", 100.0), "length [mm]");
        let expression = ["signal = 0.8*tilt + 0.25*rate".to_owned()];
        assert_eq!(title(&names, &expression, "-", 150.0), "count [-]");
    }

    #[test]
    fn meanings_are_given_as_far_as_they_are_common_and_fit() {
        let title = |meanings: &[&str], space: f64| {
            let meanings: Vec<_> = meanings.iter().map(|text| (*text).to_owned()).collect();
            title(&[], &meanings, "m", space)
        };
        let [y, z] = ["position y of tip", "position z of tip"];
        assert_eq!(title(&[y], 1e3), "position y of tip [m]");
        assert_eq!(title(&[y, z], 1e3), "position of tip [m]");
        assert_eq!(title(&[y, "position y of root"], 1e3), "position y [m]");
        assert_eq!(title(&[y, "position z of root"], 1e3), "position [m]");
        assert_eq!(title(&[y, "elongation of rod"], 1e3), "length [m]");
        assert_eq!(title(&[y, ""], 1e3), "length [m]");
        assert_eq!(title(&[y], 200.0), "position y [m]");
        assert_eq!(
            title(&["a long meaning without an owner"], 200.0),
            "length [m]"
        );
    }
}
