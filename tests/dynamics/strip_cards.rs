//! `[[strip]]` with the inflow of a rotor, as blades of bodies and in copies, compared with
//! `[blade.aerodynamics]`; readings of strips without a rotor.

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::elements::RotorAir;
use beam_dynamics::input;

use crate::air_output::rows;

const STATIONS: &str = "stations = [\n\
    { at = 0, chord = 0.3, twist = 9, airfoil = \"naca0012\" },\n\
    { at = 4, chord = 0.25, twist = 6, airfoil = \"naca0012\" },\n]\n\
    section = \"quasi_steady\"\nstrips = 4\n";

/// Thrust and torque of a rotor of two blades at 300 rpm in hover [N, N m].
fn rotor(inflow: &str, blades: &str) -> RotorAir {
    let text = format!(
        "units = \"SI\"\n[air]\ndensity = 1.2\n[[inflow]]\nname = \"lift\"\n{inflow}\n{blades}\n\
         [static]\nspeed = 300\n"
    );
    let input = input::parse(&text, "rotor.dynamics.toml").unwrap();
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let air = &outcome.result.steps[0].air;
    assert!(
        air.iter()
            .all(|one| one.location.rotor.as_deref() == Some("lift"))
    );
    RotorAir::of(air).unwrap()
}

/// Two rigid blades from 0.5 m to 4.5 m as beams, with the strips of `aerodynamics` in the table of
/// the blades.
fn of_beams(aerodynamics: &str) -> String {
    format!(
        "[properties.p]\nea = 1e12\ngay = 1e12\ngaz = 1e12\ngj = 1e11\neiy = 1e12\neiz = 1e12\n\
         m = 1\niy = 0.001\niz = 0.001\n[[blade]]\nname = \"b\"\ncount = 2\nhub_radius = 0.5\n\
         properties = \"p\"\npiece = [{{ length = 4, elements = 1 }}]\n{aerodynamics}"
    )
}

/// The same blades as bodies, made by copies about the axis.
fn of_bodies() -> String {
    format!(
        "[[repeat]]\nname = \"arm\"\ncount = 2\n\
         [[repeat.node]]\nname = \"root\"\nposition = [0.5, 0, 0]\n\
         [[repeat.node]]\nname = \"arm\"\nposition = [2.5, 0, 0]\n\
         [[repeat.body]]\nnode = \"arm\"\nmass = 1\ninertia = [1, 1, 1]\n\
         [[repeat.clamp]]\nnode = \"root\"\n\
         [[repeat.rigid]]\nnodes = [\"root\", \"arm\"]\n\
         [[repeat.strip]]\nname = \"b\"\nnode = \"arm\"\nfrom = [-2, 0, 0]\nto = [2, 0, 0]\n\
         forward = [0, 1, 0]\ninflow = \"lift\"\n{STATIONS}"
    )
}

/// The same blades as beams, whose strips are cards; `forward` is the direction of motion.
fn of_cards() -> String {
    let strips = [(1, 1.0), (2, -1.0)].map(|(blade, forward)| {
        format!(
            "[[strip]]\nname = \"s{blade}\"\nbeams = [\"b {blade}/beam 1\"]\n\
             forward = [0, {forward}, 0]\ninflow = \"lift\"\n{STATIONS}"
        )
    });
    of_beams(&strips.concat())
}

/// The beams bend and twist by less than 1e-7 rad of an angle of attack of about 0.05 rad.
#[test]
fn blades_of_cards_have_the_thrust_of_blades() {
    for inflow in [
        "blades = 2\n",
        "kind = \"uniform\"\neffective_radius = 0.97\n",
        "kind = \"Drees\"\n",
        "kind = \"Pitt-Peters\"\nradius = 5\nground = -4\n",
    ] {
        let table = format!("[blade.aerodynamics]\ninflow = \"lift\"\n{STATIONS}");
        let expected = rotor(inflow, &of_beams(&table));
        assert!(expected.thrust > 50.0 && expected.torque < -1.0);
        for blades in [of_cards(), of_bodies()] {
            let found = rotor(inflow, &blades);
            let thrust = (found.thrust / expected.thrust - 1.0).abs();
            let torque = (found.torque / expected.torque - 1.0).abs();
            assert!(thrust < 1e-5, "{inflow}: {found:?} {expected:?}");
            assert!(torque < 1e-5, "{inflow}: {found:?} {expected:?}");
            assert!((found.radius - expected.radius).abs() < 1e-5);
        }
    }
}

/// Stations by thickness: from .2 to .3 the mixture changes where the thickness is .25, in the middle, where
/// strips by names are cut and these are not: 8 Gauss points over the bend of the slope have 1e-3 of the
/// thrust. Without the airfoil in the middle the thrust would be 10 % less. Equal mixtures of equal strips
/// are equal.
#[test]
fn stations_have_airfoils_by_their_thickness() {
    let airfoils = "[airfoils.a]\nslope = 5\ndrag = 0.01\nthickness = 0.2\n[airfoils.b]\nslope = 6\n\
                    drag = 0.02\nthickness = 0.25\n[airfoils.c]\nslope = 4\ndrag = 0.03\nthickness = 0.3\n";
    let of = |stations: &str| {
        let table = format!(
            "{airfoils}{}",
            of_beams(&format!(
                "[blade.aerodynamics]\ninflow = \"lift\"\nsection = \"quasi_steady\"\nstrips = 8\n{stations}"
            ))
        );
        rotor("tip_loss = false\nhub_loss = false\n", &table)
    };
    let station = |at: f64, key: &str| format!("{{ at = {at}, chord = 0.3, twist = 8, {key} }}");
    let list = |stations: &[(f64, &str)]| {
        let all: Vec<_> = stations.iter().map(|(at, key)| station(*at, key)).collect();
        format!("stations = [{}]\n", all.join(", "))
    };
    let family = "family = [\"c\", \"a\", \"b\"]\n";
    for (by_thickness, by_name, within) in [
        (
            list(&[(0.0, "thickness = 0.2"), (4.0, "thickness = 0.3")]),
            list(&[
                (0.0, "airfoil = \"a\""),
                (2.0, "airfoil = \"b\""),
                (4.0, "airfoil = \"c\""),
            ]),
            3e-3,
        ),
        (
            list(&[
                (0.0, "thickness = 0.22"),
                (3.0, "airfoil = \"b\""),
                (4.0, "thickness = 0.25"),
            ]),
            format!(
                "{family}{}",
                list(&[
                    (0.0, "thickness = 0.22"),
                    (3.0, "thickness = 0.25"),
                    (4.0, "airfoil = \"b\"")
                ])
            ),
            1e-9,
        ),
    ] {
        let found = of(&format!("{family}{by_thickness}"));
        let expected = of(&by_name);
        let error = (found.thrust / expected.thrust - 1.0).abs();
        assert!(error < within, "{found:?} {expected:?}");
        assert!((found.torque / expected.torque - 1.0).abs() < 5.0 * within);
    }
}

#[test]
fn annuli_need_the_number_of_blades() {
    let text = format!(
        "units = \"SI\"\n[[inflow]]\nname = \"lift\"\n{}[static]\n",
        of_bodies()
    );
    let problems = input::parse(&text, "rotor.dynamics.toml").unwrap_err();
    let shown = problems.to_string();
    assert!(shown.contains("has no \"blades\""), "{shown}");
    assert!(shown.contains("rotor.dynamics.toml:"), "{shown}");
    let text = text.replace("inflow = \"lift\"", "inflow = \"left\"");
    let shown = input::parse(&text, "rotor.dynamics.toml").unwrap_err();
    assert!(shown.to_string().contains("unknown inflow \"left\""));
}

/// A wing on a body that a hinge with a spring holds, in a wind: sensors have the values of columns
/// and follow the twist; normal and tangential load are along the axes of the chord.
#[test]
fn strips_without_a_rotor_have_readings() {
    let station = |at: f64| format!("{{ at = {at}, chord = 0.4, airfoil = \"naca0012\" }}");
    let text = format!(
        "units = \"SI\"\n[air]\ndensity = 1.225\nwind = [20, 0, 0]\n\
         [[node]]\nname = \"ground\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"body\"\nposition = [0, 0, 0]\norientation = [0, 0, 5]\n\
         [[clamp]]\nnode = \"ground\"\n\
         [[body]]\nnode = \"body\"\nmass = 1\ninertia = [3, 3, 3]\n\
         [[hinge]]\nname = \"pivot\"\nnodes = [\"ground\", \"body\"]\naxis = [0, 0, 1]\n\
         stiffness = 100\n\
         [[strip]]\nname = \"fin\"\nnode = \"body\"\nfrom = [0.5, 0, -1]\nto = [0.5, 0, 1]\n\
         forward = [-1, 0, 0]\nstations = [{}, {}]\n\
         [sensors.alpha]\nquantity = \"angle_of_attack\"\nof = \"fin\"\nat = 0.4\n\
         unit = \"rad\"\n[sensors.lift]\nquantity = \"lift_load\"\nof = \"fin\"\nstrip = 2\n\
         [transient]\nto = 0.2\nstep = 0.005\n\
         [output]\ncolumn = [\n\
         {{ name = \"a\", quantity = \"angle_of_attack\", of = \"fin\", at = 0.4, unit = \"rad\" }},\n\
         {{ name = \"s\", quantity = \"signal\", of = \"alpha\" }},\n\
         {{ name = \"l\", quantity = \"lift_load\", of = \"fin\", strip = 2 }},\n\
         {{ name = \"m\", quantity = \"signal\", of = \"lift\" }},\n\
         {{ name = \"d\", quantity = \"drag_load\", of = \"fin\", strip = 2 }},\n\
         {{ name = \"n\", quantity = \"normal_load\", of = \"fin\", strip = 2 }},\n\
         {{ name = \"t\", quantity = \"tangential_load\", of = \"fin\", strip = 2 }},\n]\n",
        station(0.0),
        station(2.0)
    );
    let input = input::parse(&text, "fin.dynamics.toml").unwrap();
    let rows = rows(input);
    let first = rows[0][0];
    assert!(first.abs() > 0.05, "{first}");
    for row in &rows {
        let [a, s, l, m, d, n, t] = row[..] else {
            panic!("seven columns")
        };
        // The tolerance of Newton's method.
        assert!((a - s).abs() < 1e-6, "{a} {s}");
        assert!((l - m).abs() < 1e-5 * l.abs().max(1.0), "{l} {m}");
        assert!((l.hypot(d) - n.hypot(t)).abs() < 1e-9 * n.abs().max(1.0));
    }
    let last = &rows[rows.len() - 1];
    assert!((last[0] - first).abs() > 0.01, "{first} {}", last[0]);
    let text = text.replace(
        "quantity = \"lift_load\"\nof",
        "quantity = \"tangential_load\"\nof",
    );
    let shown = input::parse(&text, "fin.dynamics.toml").unwrap_err();
    assert!(
        shown
            .to_string()
            .contains("\"tangential_load\" cannot be sensed")
    );
}
