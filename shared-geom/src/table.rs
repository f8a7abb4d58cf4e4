//! Columns of the tables that both programs write as CSV.

/// The line of columns `heading` in the one style of all tables, `name [unit]` with underscores
/// within the name: each space outside of brackets becomes `_`, except before a bracket.
///
/// ```
/// use shared_geom::table::column_names;
/// assert_eq!(column_names("rotor speed [rad/s],mode"), "rotor_speed [rad/s],mode");
/// ```
pub fn column_names(heading: &str) -> String {
    let mut names = String::with_capacity(heading.len());
    let mut is_unit = false;
    let mut letters = heading.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '[' => is_unit = true,
            ']' => is_unit = false,
            _ => {}
        }
        let is_within = letter == ' ' && !is_unit && letters.peek() != Some(&'[');
        names.push(if is_within { '_' } else { letter });
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Units keep their spaces, and names in the style remain as they are.
    #[test]
    fn names_have_underscores_and_units_have_spaces() {
        let heading = "step,displacement x [m],moment y [N m],multiplier real part [-],state";
        let expected = "step,displacement_x [m],moment_y [N m],multiplier_real_part [-],state";
        assert_eq!(column_names(heading), expected);
        assert_eq!(column_names(expected), expected);
    }
}
