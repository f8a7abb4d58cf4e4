//! Airfoils whose tables end at a Mach number.

use rotor_aero::airfoil::Section;

/// An airfoil whose table ends at a Mach number.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) struct MachLimit {
    /// Its name.
    pub airfoil: String,
    /// Mach numbers of its table \[-\].
    pub range: [f64; 2],
    /// Largest distance from the shaft with this airfoil \[m\].
    pub radius: f64,
}

/// The limits of sections at distances from the shaft \[m\], one for each airfoil with a table over
/// the Mach number.
pub(in crate::input) fn mach_limits<'a>(
    sections: impl Iterator<Item = (f64, &'a Section)>,
) -> Vec<MachLimit> {
    let mut limits: Vec<MachLimit> = Vec::new();
    for (radius, section) in sections {
        for (_, airfoil) in section.parts() {
            let Some(range) = airfoil.mach_range() else {
                continue;
            };
            let known = limits
                .iter_mut()
                .find(|known| known.airfoil == airfoil.name());
            match known {
                Some(known) => known.radius = known.radius.max(radius),
                None => limits.push(MachLimit {
                    airfoil: airfoil.name().to_owned(),
                    range,
                    radius,
                }),
            }
        }
    }
    limits
}

#[cfg(test)]
mod tests {
    use crate::input::parse;

    /// Problems of a blade of 5 m; the table of NACA 0012 ends at Mach 0.8, which is 54.4 rad/s at
    /// 340 m/s.
    fn shown(airfoil: &str, more: &str) -> String {
        let station = |at: f64| format!("{{ at = {at}, chord = 0.3, airfoil = \"{airfoil}\" }}");
        let text = format!(
            "units = \"SI\"\n[properties.p]\nea = 7e9\ngay = 9e8\ngaz = 9e8\ngj = 8e8\neiy = 7e8\n\
             eiz = 7e8\nm = 11\niy = 0.001\niz = 0.001\n[airfoils.flat]\n\
             built_in = \"thin\"\ncompressible_to = 0.5\n[[inflow]]\nname = \"rotor\"\n[[blade]]\n\
             name = \"b\"\ncount = 2\nproperties = \"p\"\npiece = [{{ length = 5, elements = 2 }}]\n\
             [blade.aerodynamics]\ninflow = \"rotor\"\nstations = [{}, {}]\n[air]\n\
             speed_of_sound = 340\n{more}",
            station(0.5),
            station(5.0)
        );
        match parse(&text, "mach.dynamics.toml") {
            Ok(_) => String::new(),
            Err(all) => all.to_string(),
        }
    }

    #[test]
    fn tables_that_end_below_the_mach_number_of_the_tip_are_refused() {
        let at = |airfoil: &str, speed: f64, air: &str| {
            shown(
                airfoil,
                &format!("{air}[static]\nspeed = \"{speed} rad/s\"\n"),
            )
        };
        assert_eq!(at("naca0012", 54.0, ""), "");
        let found = at("naca0012", 55.0, "outside_mach = \"refuse\"\n");
        for words in [
            "mach.dynamics.toml:27: strips of \"b 1\" reach Mach 0.809 at 5 m, and the table of airfoil \
             \"NACA 0012\" is for Mach numbers from 0.15 to 0.8",
            "help: add tables of larger Mach numbers to its file, or outside_mach = \"hold\" to [air]",
        ] {
            assert!(found.contains(words), "{words}\n{found}");
        }
        // Two equal blades are one problem.
        assert_eq!(found.matches("reach Mach").count(), 1, "{found}");
        assert_eq!(at("naca0012", 55.0, "outside_mach = \"hold\"\n"), "");
        assert_eq!(at("thin", 60.0, ""), "");
        // The table with the factor of Prandtl and Glauert ends at its limit.
        assert!(at("flat", 35.0, "").contains("to 0.5"));
        // Along the axis, 200 m/s and 270 m/s are Mach 0.99.
        assert!(at("naca0012", 54.0, "wind = [0, 0, 200]\n").contains("Mach 0.988"));
        let run =
            "[transient]\nto = 0.1\nstep = 0.01\nstart = \"rotating\"\nspeed = \"60 rad/s\"\n";
        assert!(shown("naca0012", run).contains("Mach 0.882"));
    }
}
