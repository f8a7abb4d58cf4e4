//! Mach numbers of strips beyond the tables of their airfoils.

use crate::elements::strips::Air;
use crate::input::builder::ModelBuilder;

/// Remarks on the airfoils whose tables end below the Mach number of a rotor of this speed
/// [rad/s], without induction: beyond them the last table is used.
pub(in crate::input) fn remarks(builder: &ModelBuilder, air: &Air, speed: f64) -> Vec<String> {
    let wind = air.constant().map_or(0.0, |wind| wind.norm());
    let sound = air.atmosphere.sound_speed;
    let mut remarks = Vec::new();
    let blades = builder.air_blades().iter();
    for (blade, limit) in
        blades.flat_map(|blade| blade.mach_limits.iter().map(move |it| (blade, it)))
    {
        let found = (speed * limit.radius + wind) / sound;
        if found > limit.largest {
            remarks.push(format!(
                "strips of \"{}\" reach Mach {found:.2} at {:.2} m, and the table of airfoil \"{}\" \
                 ends at {}: the last curves are used beyond; give a table of higher Mach numbers",
                blade.name, limit.radius, limit.airfoil, limit.largest
            ));
        }
    }
    remarks
}

#[cfg(test)]
mod tests {
    use crate::input::parse;

    /// A blade of 5 m with NACA 0012, whose table ends at Mach 0.8: 54.4 rad/s.
    fn remarks(airfoil: &str, analysis: &str) -> Vec<String> {
        let station = |at: f64| format!("{{ at = {at}, chord = 0.3, airfoil = \"{airfoil}\" }}");
        let text = format!(
            "units = \"SI\"\n[properties.p]\nea = 7e9\ngay = 9e8\ngaz = 9e8\ngj = 8e8\neiy = 7e8\n\
             eiz = 7e8\nm = 11\niy = 0.001\niz = 0.001\n[air]\nspeed_of_sound = 340\n[airfoils.flat]\n\
             built_in = \"thin\"\ncompressible_to = 0.5\n[[inflow]]\nname = \"rotor\"\n[[blade]]\n\
             name = \"b\"\ncount = 2\nproperties = \"p\"\npiece = [{{ length = 5, elements = 2 }}]\n\
             [blade.aerodynamics]\ninflow = \"rotor\"\nstations = [{}, {}]\n{analysis}",
            station(0.5),
            station(5.0)
        );
        let input = parse(&text, "mach.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
        let remarks = input.remarks.into_iter();
        remarks.filter(|remark| remark.contains("Mach")).collect()
    }

    #[test]
    fn tables_that_end_below_the_mach_number_of_the_tip_are_reported() {
        let at = |airfoil: &str, speed: f64| {
            remarks(airfoil, &format!("[static]\nspeed = \"{speed} rad/s\"\n"))
        };
        assert!(at("naca0012", 54.0).is_empty());
        let found = at("naca0012", 55.0);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(
            found[0].contains("\"b 1\" reach Mach 0.81 at 5.00 m"),
            "{found:?}"
        );
        assert!(found[0].contains("ends at 0.8"), "{found:?}");
        assert!(at("thin", 60.0).is_empty());
        // The table with the factor of Prandtl and Glauert ends at its limit.
        assert_eq!(at("flat", 35.0).len(), 2);
        let run =
            "[transient]\nto = 0.1\nstep = 0.01\nstart = \"rotating\"\nspeed = \"60 rad/s\"\n";
        assert_eq!(remarks("naca0012", run).len(), 2);
    }
}
