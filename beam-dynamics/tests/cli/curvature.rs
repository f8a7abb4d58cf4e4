//! Sections that were solved for curved beams: the beam must have the same curvature.

use nalgebra::Vector3;
use shared_geom::section::{self, InitialCurvature, SectionProperties};

use crate::{Folder, Run, strip};

/// The strip, solved for a beam of this curvature [deg/m] and slope.
fn solved_for(curvature: [f64; 3], slope: [f64; 3]) -> SectionProperties {
    SectionProperties {
        initial_curvature: Some(InitialCurvature {
            curvature: curvature.map(f64::to_radians).into(),
            slope: slope.into(),
        }),
        ..strip()
    }
}

/// A folder with the strip, solved for a twist of 20 deg/m.
fn twisted() -> Folder {
    let folder = Folder::new();
    let section = solved_for([20.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    folder.write("strip.properties.json", &section::write(&section));
    folder
}

const HEAD: &str = "units = \"SI\"\n[properties.strip]\nfile = \"strip.properties.json\"\n";
const MODES: &str = "[modes]\nspeeds = [0]\ncount = 2\n";

/// A blade of one piece of 0.5 m, whose twist increases by `degrees`; its card is on line 9.
fn piece(degrees: f64) -> String {
    format!(
        "{HEAD}[[blade]]\nname = \"b\"\nproperties = \"strip\"\n[[blade.piece]]\nlength = 0.5\n\
         twist = [3, {}]\nelements = 4\n{MODES}",
        3.0 + degrees
    )
}

fn checked(folder: &Folder, text: &str) -> Run {
    folder.write("a.dynamics.toml", text);
    folder.run(&["check", "a.dynamics.toml"])
}

#[track_caller]
fn assert_good(run: &Run) {
    assert_eq!((run.code, run.err.as_str()), (0, ""));
}

// (K55 + K66)/sqrt(K11 K44) is 0.0585839 m: 20 deg/m make 0.0204496.
#[test]
fn a_piece_without_the_twist_of_its_section_is_refused() {
    let folder = twisted();
    let expected = |line: &str, delta: &str, help: &str| {
        format!(
            "error: a.dynamics.toml:9: blade \"b\", piece 1, properties \"strip\": the section was \
             solved for a beam with curvature [20, 0, 0] deg/m, and the line has curvature {line} \
             deg/m; couplings Kij/sqrt(Kii Kjj) differ by at most {delta}; the couplings of the \
             section by curvature are up to 0.0204\n  help: {help}"
        )
    };
    let remedy = |cause: &str, line: &str| {
        format!(
            "{cause}a section for this line has [initial_curvature] with curvature = {line} in \
             deg/m and slope = [1, 0, 0]"
        )
    };
    let straight = "the line is straight there: give it the twist and the curvature of the blade, \
                    or take the section without [initial_curvature]";
    folder.refuses(&piece(0.0), &expected("[0, 0, 0]", "0.0204", straight));
    let opposite = "the signs are opposite: twist is positive nose up, from y toward z, on the \
                    way from the root to the tip; ";
    let line = "[-20, 0, 0]";
    folder.refuses(
        &piece(-10.0),
        &expected(line, "0.0409", &remedy(opposite, line)),
    );
    let line = "[14, 0, 0]";
    folder.refuses(&piece(7.0), &expected(line, "0.00613", &remedy("", line)));
}

#[test]
fn a_piece_with_that_twist_is_taken_and_a_near_one_reported() {
    let folder = twisted();
    let run = checked(&folder, &piece(10.0));
    assert_good(&run);
    assert!(!run.out.contains("solved for"), "{}", run.out);
    let run = checked(&folder, &piece(9.5));
    assert_good(&run);
    let reported = "blade \"b\", piece 1, properties \"strip\": the section was solved for a beam with \
                curvature [20, 0, 0] deg/m, and the line has curvature [19, 0, 0] deg/m; couplings \
                Kij/sqrt(Kii Kjj) differ by at most 0.00102; the couplings of the section by \
                curvature are up to 0.0204; the matrices are used as given";
    assert!(run.out.contains(reported), "{}", run.out);
}

/// Frequencies of the first modes [Hz].
fn frequencies(folder: &Folder, text: &str) -> Vec<f64> {
    folder.write("a.dynamics.toml", text);
    assert_good(&folder.run(&["modes", "a.dynamics.toml"]));
    let table = folder.read("results/a.frequencies.csv");
    let frequency = |line: &str| line.split(',').nth(3)?.parse().ok();
    table.lines().skip(1).filter_map(frequency).collect()
}

/// The same to the digits of an eigenvalue.
#[track_caller]
fn assert_same(a: &[f64], b: &[f64]) {
    let pairs = a.iter().zip(b);
    let same = pairs.fold(true, |same, (a, b)| same && (a / b - 1.0).abs() < 1e-8);
    assert!(a.len() == 2 && b.len() == 2 && same, "{a:?} {b:?}");
}

// The matrices are used unchanged: a section that states the twist for which it was solved
// gives the frequencies of the same numbers, without a remark.
#[test]
fn nothing_is_added_to_the_matrices() {
    let text = piece(10.0);
    assert_same(
        &frequencies(&twisted(), &text),
        &frequencies(&Folder::new(), &text),
    );
}

// A file with another parameter: the matrices of 1.25 units of length of the line, which is
// reported.
#[test]
fn another_parameter_becomes_the_arc_length() {
    let folder = twisted();
    let mut section = solved_for([25.0, 0.0, 0.0], [1.25, 0.0, 0.0]);
    section.stiffness /= 1.25;
    section.mass *= 1.25;
    folder.write("strip.properties.json", &section::write(&section));
    let run = checked(&folder, &piece(10.0));
    assert_good(&run);
    let reported = "properties \"strip\": the line of the section is 1.250000 long per unit of the \
                parameter of its matrices";
    assert!(run.out.contains(reported), "{}", run.out);
    let plain = twisted();
    assert_same(
        &frequencies(&folder, &piece(10.0)),
        &frequencies(&plain, &piece(10.0)),
    );
}

/// A beam of three nodes 0.5 m long, with twists at them [deg].
fn beam(twists: [f64; 3]) -> String {
    let nodes: String = [0.0, 0.25, 0.5]
        .iter()
        .zip(["n0", "n1", "n2"])
        .map(|(x, name)| format!("[[node]]\nname = \"{name}\"\nposition = [{x}, 0, 0]\n"))
        .collect();
    let [a, b, c] = twists;
    format!(
        "{HEAD}{nodes}[[beam]]\nname = \"one\"\nnodes = [\"n0\", \"n1\", \"n2\"]\n\
         section_axes = [[{a}, 0, 0], [{b}, 0, 0], [{c}, 0, 0]]\nproperties = \"strip\"\n\
         [[clamp]]\nnode = \"n0\"\n{MODES}"
    )
}

// The evaluation points are at 0.5 m (1 -+ 1/sqrt 3)/2 = 0.1057 m and 0.3943 m.
#[test]
fn beams_between_nodes_are_compared_at_their_evaluation_points() {
    let folder = twisted();
    assert_good(&checked(&folder, &beam([2.0, 7.0, 12.0])));
    let run = checked(&folder, &beam([0.0; 3]));
    assert_eq!(run.code, 2);
    let reported = "error: a.dynamics.toml:15: beam \"one\", 0.1057 m of 0.5000 m, properties \
                \"strip\": the section was solved for a beam with curvature [20, 0, 0] deg/m, and \
                the line has curvature [0, 0, 0] deg/m";
    assert!(run.err.starts_with(reported), "{}", run.err);
    // A larger twist on the outer half: only the second evaluation point is off.
    let run = checked(&folder, &beam([0.0, 5.0, 13.0]));
    assert!(
        run.err.contains("beam \"one\", 0.3943 m of 0.5000 m"),
        "{}",
        run.err
    );
}

/// A blade file of a straight line of 0.5 m with a twist that increases by `degrees`, and
/// the strip at both ends.
fn blade_file(degrees: f64, more: &str) -> String {
    let station =
        |eta: f64| format!("[[station]]\neta = {eta}\nfile = \"strip.properties.json\"\n{more}");
    format!(
        "units = \"SI\"\nframe = \"helicoid\"\nreference_point = \"line\"\n[line]\nlength = 0.5\n\
         twist = [0, {degrees}]\n{}{}",
        station(0.0),
        station(1.0)
    )
}

/// The cards of a blade from `file`.
fn of_file(file: &str) -> String {
    format!("units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"{file}\"\n{MODES}")
}

#[test]
fn stations_of_a_blade_file_are_compared_with_its_line() {
    let folder = twisted();
    folder.write("a.blade.toml", &blade_file(10.0, ""));
    assert_good(&checked(&folder, &of_file("a.blade.toml")));
    folder.write("a.blade.toml", &blade_file(-10.0, ""));
    let run = checked(&folder, &of_file("a.blade.toml"));
    assert_eq!(run.code, 2);
    for reported in [
        "error: a.blade.toml:7: station 1 at 0 m, \"strip.properties.json\": the section was \
         solved for a beam with curvature [20, 0, 0] deg/m, and the line has curvature \
         [-20, 0, 0] deg/m; couplings",
        "error: a.blade.toml:10: station 2 at 0.5 m, ",
        "\n  help: the signs are opposite: ",
    ] {
        assert!(
            run.err.contains(reported),
            "{reported} is not in\n{}",
            run.err
        );
    }
}

// About a point 50 mm above the line, and at a twist of 20 deg/m, the line of this point
// has the slope (1, -0.05 k1, 0): a section solved with a line normal to it there belongs
// to another beam, and the message states the slope that it needs.
#[test]
fn a_reference_point_off_the_line_has_a_line_of_its_own() {
    let folder = twisted();
    let side = -0.05 * 20.0_f64.to_radians();
    let c = 1.0_f64.hypot(side);
    let above = "reference_point = [0, 0.05]\n";
    folder.write("a.blade.toml", &blade_file(10.0, above));
    let run = checked(&folder, &of_file("a.blade.toml"));
    let reported = format!("deg/m and slope = [{:.6}, {:.7}, 0]", 1.0 / c, side / c);
    assert!(
        run.code == 2 && run.err.contains(&reported),
        "{reported}: {}",
        run.err
    );
    assert!(
        run.err.contains("is the reference point of the section"),
        "{}",
        run.err
    );
    let right = solved_for([20.0 / c, 0.0, 0.0], [1.0 / c, side / c, 0.0]);
    folder.write("strip.properties.json", &section::write(&right));
    assert_good(&checked(&folder, &of_file("a.blade.toml")));
}

// Between two stations of 20 deg/m the line has 32 deg/m and then 14.
#[test]
fn a_line_that_differs_between_stations_is_reported() {
    let folder = twisted();
    let points = "x = [0, 0.1, 0.2, 0.3, 0.4, 0.5]\ntwist = [0, 2, 5.2, 6.6, 8, 10]";
    let text = blade_file(10.0, "").replace("length = 0.5\ntwist = [0, 10]", points);
    folder.write(
        "a.blade.toml",
        &text.replace("[line]\n", "[line]\ncourse = \"polyline\"\n"),
    );
    let run = checked(&folder, &of_file("a.blade.toml"));
    assert_good(&run);
    let reported = "between stations, most at 0.15 m: the section was solved for a beam with curvature \
                [20, 0, 0] deg/m, and the line has curvature [32, 0, 0] deg/m";
    assert!(run.out.contains(reported), "{}", run.out);
}

#[test]
fn tables_that_name_sections_are_compared_too() {
    let folder = twisted();
    let table = |degrees: f64| {
        format!(
            "# helicoid blade table\n# units: SI\n# frame: helicoid\n# course: polyline\n\
             # interpolation: linear\n\
             # order: axial, shear y, shear z, torsion, bending y, bending z\n\
             # reference point: reference line\ntable,line\nx,y,z,twist\n0,0,0,0\n0.5,0,0,{}\n\
             table,sections\ns,file\n0,strip.properties.json\n0.5,strip.properties.json\n",
            degrees.to_radians()
        )
    };
    folder.write("a.csv", &table(10.0));
    assert_good(&checked(&folder, &of_file("a.csv")));
    folder.write("a.csv", &table(0.0));
    let run = checked(&folder, &of_file("a.csv"));
    assert!(
        run.err.starts_with("error: a.csv:14: station 1 at 0 m, "),
        "{}",
        run.err
    );
}

// A property file with a length only is the blade for which its section was solved.
#[test]
fn one_section_makes_a_blade_of_its_curvature() {
    let folder = twisted();
    let cards = of_file("strip.properties.json").replace("\n[modes]", "\nlength = 0.5\n[modes]");
    let run = checked(&folder, &cards);
    assert_good(&run);
    assert!(
        run.out
            .contains("curved and twisted as the section was solved for"),
        "{}",
        run.out
    );
    // The same by pieces, with as many elements: 20 of 5 %.
    let pieces = piece(10.0)
        .replace("twist = [3, 13]", "twist = [0, 10]")
        .replace("elements = 4", "elements = 20");
    assert_same(
        &frequencies(&folder, &cards),
        &frequencies(&folder, &pieces),
    );
    let oblique = solved_for([20.0, 0.0, 0.0], [0.96, 0.28, 0.0]);
    folder.write("strip.properties.json", &section::write(&oblique));
    let run = checked(&folder, &cards);
    assert!(
        run.err
            .contains("expected [1, 0, 0]: the sections of a blade are normal"),
        "{}",
        run.err
    );
    let curved = Vector3::new(0.0, 0.0, 40.0);
    folder.write(
        "strip.properties.json",
        &section::write(&solved_for(curved.into(), [1.0, 0.0, 0.0])),
    );
    assert_good(&checked(&folder, &cards));
}

// A line that bends toward +y by 0.5 rad/m: a section whose y points along z, turned by 90
// degrees, has the curvature about its own y.
#[test]
fn the_angle_of_a_station_turns_its_curvature() {
    let folder = Folder::new();
    let station = |eta: f64| {
        format!("[[station]]\neta = {eta}\nfile = \"strip.properties.json\"\nangle = 90\n")
    };
    let text = format!(
        "units = \"SI\"\nframe = \"helicoid\"\nreference_point = \"line\"\n[line]\ntwist = 0\n\
         [[line.arc]]\nlength = 0.5\ncurvature = [0, 0, 0.5]\ntwist_rate = 0\n{}{}",
        station(0.0),
        station(1.0)
    );
    folder.write("a.blade.toml", &text);
    let degrees = 0.5_f64.to_degrees();
    let section = |curvature| {
        let section = solved_for(curvature, [1.0, 0.0, 0.0]);
        folder.write("strip.properties.json", &section::write(&section));
        checked(&folder, &of_file("a.blade.toml"))
    };
    assert_good(&section([0.0, degrees, 0.0]));
    let run = section([0.0, 0.0, degrees]);
    let reported = "has curvature [0, 28.6479, 0] deg/m";
    assert!(run.code == 2 && run.err.contains(reported), "{}", run.err);
}
