//! Operating points beyond the airfoils.

use crate::Folder;

/// A rotor of 1 m whose airfoil has tables at two Reynolds numbers, at one flight speed.
fn run(speeds: &str) -> String {
    let folder = Folder::new();
    let rows = |reynolds: &str| {
        let rows = [(-180, 0.0), (-12, -1.2), (0, 0.0), (12, 1.2), (180, 0.0)];
        rows.map(|(angle, lift)| format!("{angle},{lift},0.02,0,{reynolds}\n"))
            .concat()
    };
    let table = format!(
        "alpha [deg],cl,cd,cm,reynolds\n{}{}",
        rows("1e5"),
        rows("1e6")
    );
    folder.write("low.csv", &table);
    folder.write(
        "a.rotor.toml",
        &format!(
            "units = \"SI\"\n[airfoils.low]\nfile = \"low.csv\"\n[air]\ndensity = 1.2\nviscosity = 1.8e-5\n\
             speed_of_sound = 340\n[rotor]\nmachine = \"propeller\"\nblades = 2\nstations = [{{ r = 0.1, \
             chord = 0.1, twist = 30, airfoil = \"low\" }}, {{ r = 1, chord = 0.1, twist = 10, \
             airfoil = \"low\" }}]\n[[sweep]]\nspeed = 5\nrotor_speed = {speeds}\n"
        ),
    );
    let run = folder.run(&["performance", "a.rotor.toml", "--no-figures"]);
    assert_eq!(run.code, 0, "{}", run.err);
    run.out + &run.err
}

/// Re = rho W c / mu with W^2 = (0.75 Omega)^2 + 5^2: 4.24e4 at 50 rpm, 2.5e5 at 480 rpm, and 2.6e6 at
/// 5000 rpm, where the tip has 523.6 m/s, a Mach number of 1.54.
#[test]
fn points_beyond_the_tables_and_the_speed_of_sound_are_remarked() {
    let slow = run("[50, 480]");
    let words = "at 1 of 2 points the Reynolds number at 0.75 of the radius, 4.2";
    assert!(slow.contains(words), "{slow}");
    let words = "e4, is beyond the table of \"low\", 1.00e5 to 1.00e6, whose ends are held";
    assert!(slow.contains(words), "{slow}");
    let fast = run("[5000]");
    for words in [
        "at 1 of 1 points sections move faster than sound, up to a Mach number of 1.5",
        "at 1 of 1 points the Reynolds number at 0.75 of the radius, 2.6",
    ] {
        assert!(fast.contains(words), "{words}: {fast}");
    }
    let usual = run("[480, 900]");
    assert!(
        !usual.contains("Reynolds") && !usual.contains("sound"),
        "{usual}"
    );
}
