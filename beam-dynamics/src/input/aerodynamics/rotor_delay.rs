//! Delay of stall along blades: `stall_delay` of `[blade.aerodynamics]`, `[[strip]]` and `[rotor]`.

use rotor_aero::airfoil::{RotorDelayLaw, RotorStallDelay, Section};
use shared_geom::document::schema::ValueKind::{Positive, Table as OneTable, Word};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::changes::{self, FIT};
use super::problem::StripProblem;
use crate::input::short_number;

keys! {
    /// Delay of stall by rotation along the blade, of tables of two-dimensional flow: the correction of
    /// each place by its chord and its distance from the shaft.
    pub(in crate::input) BLADE_STALL_DELAY: ByHand = "stall_delay", [OneTable(&CARD)], optional, "";
}

keys! {
    /// Delay of stall by rotation along a blade.
    CARD = "stall_delay = { ... } along a blade";
    /// Law: lift of Du and Selig with drag of Eggers, or lift of Snel.
    LAW: usize = "law", [Word(&["Du-Selig", "Snel"])], or "\"Du-Selig\"" = 0, "\"Snel\"";
    /// Speed of the tip by rotation over its speed in the air; not for Snel.
    SPEED_RATIO: Option<f64> = "speed_ratio", [Positive(Dimension::NUMBER)], or "1", "0.98";
    /// Part of the radius of the tip beyond which stall is not delayed.
    TO: f64 = "to", [Positive(Dimension::NUMBER)], or "1" = 1.0, "0.8";
    with FIT.schema;
}

/// Reads the key of a table; `Some(None)` without it, `None` if it is wrong.
pub(in crate::input) fn read(table: &Table<'_>) -> Option<Option<RotorStallDelay>> {
    if !table.has(&BLADE_STALL_DELAY) {
        return Some(None);
    }
    let inner = table.table(&BLADE_STALL_DELAY)?;
    let (law, speed, to) = (inner.get(&LAW), inner.get(&SPEED_RATIO), inner.get(&TO));
    let fit = changes::fit(&inner);
    inner.finish();
    let (law, speed, to) = (law?, speed?, to?);
    let most = [(&SPEED_RATIO.schema, speed), (&TO.schema, Some(to))];
    let is_beyond = |it: &&(_, Option<f64>)| it.1.is_some_and(|part| part > 1.0);
    if let Some((key, _)) = most.iter().find(is_beyond) {
        inner.wrong(key.name, "at most 1");
        return None;
    }
    if law == 1 && speed.is_some() {
        inner.wrong(&SPEED_RATIO, "no such key beside law = \"Snel\"");
        return None;
    }
    Some(Some(RotorStallDelay {
        law: [RotorDelayLaw::DuSelig, RotorDelayLaw::Snel][law],
        speed_ratio: speed.unwrap_or(1.0),
        to,
        fit: fit?,
    }))
}

/// Notes sections of which none has a table whose stall may be delayed; remarks on some.
pub(in crate::input) fn check<'a>(
    (table, delay): (&Table<'_>, &RotorStallDelay),
    sections: impl Iterator<Item = &'a Section>,
    user: &str,
    remarks: &mut Vec<String>,
) -> Option<()> {
    let (mut without, mut is_any) = (Vec::new(), false);
    let (mut lines, mut is_sound) = (Vec::new(), true);
    for (_, airfoil) in sections.flat_map(Section::parts) {
        is_any |= airfoil.has_stall_delay();
        if !lines.contains(&airfoil.name()) {
            lines.push(airfoil.name());
            for problem in airfoil.without_line(delay.fit) {
                table.note(&BLADE_STALL_DELAY, &problem);
                is_sound = false;
            }
        }
        let name = format!("\"{}\"", airfoil.name());
        if !airfoil.has_stall_delay() && !without.contains(&name) {
            without.push(name);
        }
    }
    let names = without.join(", ");
    if !is_any {
        table.note(&BLADE_STALL_DELAY, &StripProblem::NoStallDelay { names });
        return None;
    }
    if !without.is_empty() {
        remarks.push(format!(
            "{user}: \"stall_delay\" has no effect on {names}: airfoils without a table of stall, or with a \
             \"stall_delay\" of their own"
        ));
    }
    is_sound.then_some(())
}

/// A remark on a delay that ends before the first place of a blade, by the distances of this place and of
/// the tip from the shaft \[m\].
pub(in crate::input) fn remark_on_end(
    delay: Option<&RotorStallDelay>,
    user: &str,
    [first, tip]: [f64; 2],
) -> Option<String> {
    let delay = delay.filter(|delay| delay.to * tip < first)?;
    Some(format!(
        "{user}: \"stall_delay\" has no effect: it ends at {} of the radius of the tip, and the blade begins \
         at {}",
        short_number(delay.to, 4),
        short_number(first / tip, 4)
    ))
}

#[cfg(test)]
mod tests {
    use crate::input::parse;

    /// The problems or the remarks of a blade whose inner and outer stations have these airfoils, with a
    /// line of its strips.
    fn shown([inner, outer]: [&str; 2], line: &str) -> String {
        let text = format!(
            "units = \"SI\"\n[properties.p]\nea = 7e9\ngay = 9e8\ngaz = 9e8\ngj = 8e8\neiy = 7e8\n\
             eiz = 7e8\nm = 20\niy = 0.001\niz = 0.001\n[airfoils.own]\nbuilt_in = \"naca0012\"\n\
             stall_delay = {{ law = \"Snel\", chord_ratio = 0.1 }}\n[[inflow]]\nname = \"i\"\n[[blade]]\nname = \"b\"\n\
             properties = \"p\"\nhub_radius = 1\npiece = [{{ length = 5, elements = 2 }}]\n\
             [blade.aerodynamics]\n{line}\nstations = [{{ at = 0, chord = 0.3, airfoil = \"{inner}\" }}, \
             {{ at = 5, chord = 0.3, airfoil = \"{outer}\" }}]\n[static]\nspeed = 10\n"
        );
        match parse(&text, "delay.dynamics.toml") {
            Ok(input) => input.remarks.join("\n"),
            Err(all) => all.to_string(),
        }
    }

    #[test]
    fn wrong_laws_are_refused_and_airfoils_without_stall_are_named() {
        let naca = ["naca0012"; 2];
        for (airfoils, line, words) in [
            (
                naca,
                "law = \"Sneel\"",
                "delay.dynamics.toml:23: \"law\" is \"Sneel\"",
            ),
            (
                naca,
                "law = \"Snel\", speed_ratio = 0.9",
                "no such key beside law = \"Snel\"",
            ),
            (
                naca,
                "speed_ratio = 1.1",
                "\"speed_ratio\" is 1.1, expected at most 1",
            ),
            (naca, "to = 80", "\"to\" is 80, expected at most 1"),
            (
                naca,
                "fit = [40, 60]",
                "no positive slope of two points in the range of the fit",
            ),
            (
                naca,
                "fit = [5, -5]",
                "expected two angles, the smaller one first",
            ),
            (naca, "of = 1", "unknown key \"of\""),
            (
                ["thin", "own"],
                "",
                "\"stall_delay\" has no effect on \"linear lift\", \"NACA 0012\"",
            ),
            (
                ["naca0012", "own"],
                "",
                "blade \"b\": \"stall_delay\" has no effect on \"NACA 0012\"",
            ),
        ] {
            let found = shown(airfoils, &format!("stall_delay = {{ {line} }}"));
            assert!(found.contains(words), "{words}\n{found}");
        }
        // The blade begins at a sixth of the radius.
        for line in ["", "to = 0.17"] {
            let line = format!("stall_delay = {{ {line} }}\ninflow = \"i\"");
            assert_eq!(shown(naca, &line), "", "{line}");
        }
        let found = shown(naca, "stall_delay = { to = 0.16 }\ninflow = \"i\"");
        assert_eq!(
            found,
            "blade \"b\": \"stall_delay\" has no effect: it ends at 0.16 of the radius of the tip, and the \
             blade begins at 0.1667"
        );
    }

    /// A body has no radius without a shaft.
    #[test]
    fn strips_without_a_shaft_have_no_delay() {
        let text = "units = \"SI\"\n[[node]]\nname = \"n\"\nposition = [0, 0, 0]\n[[strip]]\nname = \"fin\"\n\
                    node = \"n\"\nfrom = [0, 0, 0]\nto = [0, 1, 0]\nforward = [1, 0, 0]\nstall_delay = {}\n\
                    stations = [{ at = 0, chord = 0.3, airfoil = \"naca0012\" }, { at = 1, chord = 0.3, \
                    airfoil = \"naca0012\" }]\n[static]\n";
        let found = parse(text, "fin.dynamics.toml")
            .map(|_| ())
            .unwrap_err()
            .to_string();
        assert!(
            found.contains("strip \"fin\" has \"stall_delay\" without \"inflow\""),
            "{found}"
        );
    }
}
