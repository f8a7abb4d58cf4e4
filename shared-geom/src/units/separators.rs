//! Remedies for numbers with separators, which programs and people write in several ways.

/// Separators of thousands; the comma is the decimal sign of many languages too.
const SEPARATORS: [char; 4] = [',', ' ', '_', '\''];

/// The remedy for a number with separators, `70,000 MPa` or `210,5GPa`; `None` for other texts.
pub(super) fn without_separators(text: &str) -> Option<String> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.' || SEPARATORS.contains(&c);
    let end = text.find(|c| !is_part(c)).unwrap_or(text.len());
    let number = text[..end].trim_end();
    let unit = &text[number.len()..];
    let groups: Vec<_> = number.split(SEPARATORS).collect();
    let [first, others @ ..] = &groups[..] else {
        return None;
    };
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let last = others.last()?.split('.').next().unwrap_or_default();
    let between = &others[..others.len() - 1];
    let is_grouped = is_digits(first)
        && between
            .iter()
            .chain([&last])
            .all(|group| group.len() == 3 && is_digits(group));
    let is_decimal =
        number.contains(',') && others.len() == 1 && groups.iter().all(|it| is_digits(it));
    let whole = format!("\"{}{unit}\"", groups.concat());
    let decimal = format!("\"{}{unit}\"", number.replace(',', "."));
    match (is_grouped, is_decimal) {
        (true, true) => Some(format!("write {whole}, or with a decimal point {decimal}")),
        (true, false) => Some(format!("write {whole}, without separators of thousands")),
        (false, true) => Some(format!("write {decimal}, with a decimal point")),
        (false, false) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separators_are_removed_or_replaced() {
        let help = |text| without_separators(text).unwrap_or_default();
        assert_eq!(
            help("70,000 MPa"),
            "write \"70000 MPa\", or with a decimal point \"70.000 MPa\""
        );
        assert_eq!(help("210,5GPa"), "write \"210.5GPa\", with a decimal point");
        for number in [
            "1,234,567.5 N",
            "1 234 567.5 N",
            "1'234'567.5 N",
            "1_234_567.5 N",
        ] {
            assert_eq!(
                help(number),
                "write \"1234567.5 N\", without separators of thousands"
            );
        }
        for other in [
            "", "N", "5 N", "0-8", "5 5 N", "1,2,3 N", ",5 N", "5, N", "é5,000",
        ] {
            assert_eq!(help(other), "", "{other}");
        }
    }
}
