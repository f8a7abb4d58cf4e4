//! Towers, nacelles, wings and pylons: places and frequencies against closed forms.

use std::f64::consts::{PI, TAU};

use nalgebra::{Matrix3, Vector3};

use super::{Run, STRIP, read, refused};
use crate::analysis::modes::modes;

/// Bending stiffness and length of towers and wings.
const EI: f64 = 4e6;
const HEIGHT: f64 = 20.0;

/// A rotor of three light blades with the keys and tables of its mount, and further cards.
fn rotor(keys: &str, mount: &str, cards: &str) -> String {
    let column = format!(
        "[properties.column]\nea = 1e11\ngay = 1e11\ngaz = 1e11\ngj = 1e11\neiy = {EI:e}\neiz = {EI:e}\n\
         m = 1e-4\niy = 1e-6\niz = 1e-6\n"
    );
    let light = STRIP.replace("m = 2\n", "m = 1e-3\n");
    format!(
        "units = \"SI\"\n{light}{column}[[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = 3\nspeed = 12\n\
         {keys}\n[rotor.blade]\nhub_radius = 0.2\nproperties = \"strip\"\n\
         piece = [{{ length = 1, elements = 1 }}]\n{mount}{cards}"
    )
}

/// Position and axes of nodes in the undeformed model.
fn places<const N: usize>(text: &str, names: [&str; N]) -> [(Vector3<f64>, Matrix3<f64>); N] {
    let input = read(text);
    names.map(|name| {
        let mut nodes = input.model.system.nodes().iter();
        let node = nodes.find(|node| node.label == name).unwrap();
        (node.position, node.rotation)
    })
}

fn assert_near(found: Vector3<f64>, expected: [f64; 3]) {
    assert!(
        (found - Vector3::from(expected)).norm() < 1e-9,
        "{found} {expected:?}"
    );
}

// A shaft raised by 5 degrees at the rotor, 4 m upwind of the tower, with a yaw of 90 degrees: downwind is
// along y then. The first blade points up, across the shaft.
#[test]
fn the_hub_of_a_turbine_is_where_tower_and_nacelle_put_it() {
    const MOUNT: &str = "[rotor.tower]\nheight = 20\nproperties = \"column\"\n[rotor.nacelle]\n\
        yaw = 90\ntilt = 5\noverhang = 4\nabove = 1.5\nmass = 900\nmass_center = [0.5, 0, 1]\n";
    let text = rotor("base = [1, 2, -3]", MOUNT, "[modes]\nspeeds = 0\n");
    let names = [
        "r/hub",
        "r/tower/root",
        "r/tower/tip",
        "r/nacelle",
        "r 1/tip",
    ];
    let [hub, root, tip, nacelle, blade] = places(&text, names);
    let (sin, cos) = 5.0_f64.to_radians().sin_cos();
    assert_near(root.0, [1.0, 2.0, -3.0]);
    assert_near(tip.0, [1.0, 2.0, 17.0]);
    assert_near(nacelle.0, [1.0, 2.0, 17.0]);
    assert_near(hub.0, [1.0, 2.0 - 4.0 * cos, 18.5 + 4.0 * sin]);
    assert_near(blade.0 - hub.0, [0.0, 1.2 * sin, 1.2 * cos]);
    // The body of the nacelle turns with the yaw.
    assert_near(nacelle.1 * Vector3::x(), [0.0, 1.0, 0.0]);
    // The sense of rotation is with the shaft, or against it.
    let turned = text.replace("speed = 12\n", "speed = 12\naxis = [0, -1, 0]\n");
    let [first, second] = [&text, &turned].map(|text| {
        let [hub, two] = places(text, ["r/hub", "r 2/tip"]);
        two.0 - hub.0
    });
    assert!(first.x * second.x < 0.0, "{first} {second}");
}

// A light tower under the mass M of the nacelle, w^2 = 3 EI / (M L^3) in both directions, to the inertia of
// the light blades.
#[test]
fn a_tower_bends_under_its_nacelle() {
    const MASS: f64 = 5e3;
    let mount = format!(
        "[rotor.tower]\nheight = {HEIGHT}\nproperties = \"column\"\nelements = 3\n\
         [rotor.nacelle]\nmass = {MASS:?}\n"
    );
    let input = read(&rotor("", &mount, "[modes]\nspeeds = 0\ncount = 2\n"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let expected = (3.0 * EI / (MASS * HEIGHT.powi(3))).sqrt() / TAU;
    for (_, point) in outcome.table.at_speed(0) {
        assert!(
            (point.frequency / expected - 1.0).abs() < 1e-4,
            "{} {expected}",
            point.frequency
        );
    }
}

/// A tower of ElastoDyn: 1 kg/m, stiffness by factors of 2 and 0.5.
const TOWER_FILE: &str = "
2  NTwInpSt - stations
1  TwrFADmp(1) - damping
1  AdjTwMa - mass
2  AdjFASt - fore-aft
0.5  AdjSSSt - side-side
HtFract TMassDen TwFAStif TwSSStif
(-) (kg/m) (Nm^2) (Nm^2)
0 1e-3 2e6 3.2e7
1 1e-3 2e6 3.2e7
";

/// A tower of HAWC2, from the ground upward along -z of its axes.
const HTC: &str = "begin new_htc_structure;
begin main_body;
name blade1 ;
begin timoschenko_input ;
filename ./hawc2_dtu10_st.dat ;
set 1 1 ;
end timoschenko_input;
begin c2_def;
nsec 2 ;
sec 1 0 0 0 0 ;
sec 2 0 0 86.4 0 ;
end c2_def ;
end main_body;
begin main_body;
name tower ;
damping_posdef 0 0 0 1e-3 1e-3 1e-3 ;
begin timoschenko_input ;
filename ./hawc2_dtu10_st.dat ;
set 1 1 ;
end timoschenko_input;
begin c2_def;
nsec 3 ;
sec 1 0 0 0 0 ;
sec 2 0 0 -10 0 ;
sec 3 0 0 -20 0 ;
end c2_def ;
end main_body;
end new_htc_structure;
";

/// A folder with files of towers.
fn tower_files() -> tempfile::TempDir {
    const ST: &str = include_str!("../../../../../tests/reference/exchange/hawc2_dtu10_st.dat");
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("tower.dat", TOWER_FILE),
        ("turbine.htc", HTC),
        ("hawc2_dtu10_st.dat", ST),
    ] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

// The tower of a file of ElastoDyn under a mass M, w^2 = 3 EI / (M L^3): EI = 4e6 fore-aft and 1.6e7
// side-side, twice the frequency. The damping c = T K of the card gives the ratio T w / 2.
#[test]
fn towers_of_elastodyn_bend_fore_aft_and_sideways() {
    const MASS: f64 = 5e3;
    let folder = tower_files();
    let mount = format!(
        "[rotor.tower]\nheight = {HEIGHT}\nfile = \"tower.dat\"\nelements = 3\n\
         damping = {{ time = 1e-2 }}\n[rotor.nacelle]\nmass = {MASS:?}\n"
    );
    let text = rotor("", &mount, "[modes]\nspeeds = 0\ncount = 2\n");
    let path = folder.path().join("a.dynamics.toml");
    let input = crate::input::parse(&text, path.display().to_string());
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let expected = (3.0 * EI / (MASS * HEIGHT.powi(3))).sqrt() / TAU;
    let points = outcome.table.at_speed(0);
    assert_eq!(points.len(), 2);
    for ((_, point), factor) in points.iter().zip([1.0, 2.0]) {
        let undamped = point.frequency / (1.0 - point.damping_ratio.powi(2)).sqrt();
        assert!(
            (undamped / (factor * expected) - 1.0).abs() < 1e-4,
            "{undamped} {expected}"
        );
        let ratio = 0.5e-2 * TAU * factor * expected;
        assert!((point.damping_ratio / ratio - 1.0).abs() < 1e-3);
    }
}

// The tower of a windIO file is a tube: under a mass M, 1 / w^2 = M (L^3 / (3 E I) + L / (G A / 2)) in both directions;
// without the name of the body the file is the one of a blade.
#[test]
fn towers_of_windio_files_are_tubes() {
    const MASS: f64 = 5e3;
    let [outer, inner] = [0.1_f64, 0.09];
    let folder = tempfile::tempdir().unwrap();
    let turbine = format!(
        "components:\n  blade:\n    outer_shape: {{}}\n  tower:\n    outer_shape:\n      outer_diameter: \
         {{grid: [0, 1], values: [{0:?}, {0:?}]}}\n    structure:\n      layers:\n      - name: wall\n        \
         material: steel\n        thickness: {{grid: [0, 1], values: [0.01, 0.01]}}\n    reference_axis:\n      \
         z: {{grid: [0, 1], values: [10, {1:?}]}}\nmaterials:\n- {{name: steel, E: 2e11, nu: 0.3, rho: 1e-2}}\n",
        2.0 * outer,
        10.0 + HEIGHT
    );
    std::fs::write(folder.path().join("turbine.yaml"), turbine).unwrap();
    let path = folder.path().join("a.dynamics.toml");
    let parsed = |body: &str| {
        let mount = format!(
            "[rotor.tower]\nheight = {HEIGHT}\nfile = \"turbine.yaml\"\n{body}elements = 3\n\
             [rotor.nacelle]\nmass = {MASS:?}\n"
        );
        let text = rotor("", &mount, "[modes]\nspeeds = 0\ncount = 2\n");
        crate::input::parse(&text, path.display().to_string())
    };
    let input = parsed("body = \"tower\"\n").unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let [e, g] = [2e11, 2e11 / 2.6];
    let area = PI * (outer * outer - inner * inner);
    let second = 0.25 * PI * (outer.powi(4) - inner.powi(4));
    let flexibility = HEIGHT.powi(3) / (3.0 * e * second) + HEIGHT / (0.5 * g * area);
    let expected = (MASS * flexibility).sqrt().recip() / TAU;
    let points = outcome.table.at_speed(0);
    assert_eq!(points.len(), 2);
    for (_, point) in points {
        assert!(
            (point.frequency / expected - 1.0).abs() < 1e-4,
            "{} {expected}",
            point.frequency
        );
    }
    let problems = parsed("").unwrap_err().to_string();
    assert!(
        problems.contains("of components.blade is missing"),
        "{problems}"
    );
}

// The body of the tower in a file of a turbine: its own line, turned upward. Other names and lengths, and
// names of bodies in other files, are errors.
#[test]
fn towers_of_htc_files_are_bodies_with_a_name() {
    let folder = tower_files();
    let path = folder.path().join("a.dynamics.toml");
    let parsed = |keys: &str| {
        let mount = format!("[rotor.tower]\n{keys}\n[rotor.nacelle]\nmass = 5e3\n");
        let text = rotor("", &mount, "[modes]\nspeeds = 0\ncount = 2\n");
        crate::input::parse(&text, path.display().to_string())
    };
    let input = parsed("height = 20\nfile = \"turbine.htc\"\nbody = \"Tower\"");
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    let mut nodes = input.model.system.nodes().iter();
    let tip = nodes.find(|node| node.label == "r/tower/tip").unwrap();
    assert_near(tip.position, [0.0, 0.0, 20.0]);
    for (keys, expected) in [
        (
            "height = 20\nfile = \"turbine.htc\"\nbody = \"towr\"",
            "the body \"towr\" among the bodies of the file",
        ),
        (
            "height = 20\nfile = \"turbine.htc\"",
            "of an htc file of HAWC2 the blade is read without body",
        ),
        (
            "height = 20\nfile = \"tower.dat\"\nbody = \"tower\"",
            "expected an htc file of HAWC2",
        ),
    ] {
        let found = parsed(keys).unwrap_err().to_string();
        assert!(found.contains(expected), "{keys}: {found}");
    }
}

// A pylon at 30 degrees, forward along -x, on a wing along y and up.
#[test]
fn the_hub_of_a_tiltrotor_is_where_wing_and_pylon_put_it() {
    const MOUNT: &str = "[rotor.pylon]\nlength = 1.4\nangle = 30\nmass = 9\nmass_center = 0.7\n\
        wing = { span = [0, 4, 3], properties = \"column\" }\n";
    let text = rotor("base = [0, 1, 0]", MOUNT, "[modes]\nspeeds = 0\n");
    let names = ["r/hub", "r/wing/tip", "r/pylon", "r 1/tip"];
    let [hub, tip, pylon, blade] = places(&text, names);
    assert_near(tip.0, [0.0, 5.0, 3.0]);
    assert_near(pylon.0, [0.0, 5.0, 3.0]);
    let root = 0.75_f64.sqrt();
    assert_near(hub.0, [-0.7, 5.0, 3.0 + 1.4 * root]);
    assert_near(blade.0 - hub.0, [1.2 * root, 0.0, 1.2 * 0.5]);
    // Sections of the wing: y is forward.
    let [wing] = places(&text, ["r/wing/1"]);
    assert_near(wing.1 * Vector3::y(), [-1.0, 0.0, 0.0]);
}

// The conversion follows its drive; the wing is stiff: the hub is on a circle about its tip.
#[test]
fn a_pylon_is_converted_by_a_drive() {
    const MOUNT: &str = "[rotor.pylon]\nlength = 1.4\nangle = \"= 40*t^2\"\nmass = 9\n\
        inertia = [1, 1, 1]\n";
    let cards = "[transient]\nto = 1\nstep = 0.02\n";
    let run = Run::new(&rotor("", MOUNT, cards));
    for (time, [hub]) in run.motions(["r/hub"]) {
        let (sin, cos) = (40.0 * time * time).to_radians().sin_cos();
        let off = hub.position - Vector3::new(-1.4 * sin, 0.0, 1.4 * cos);
        assert!(off.norm() < 1e-6, "{time} {off}");
    }
}

// The yaw follows its drive, also of a name; the tower is stiff: the hub, 4 m upwind of it and tilted, is on
// a circle about z.
#[test]
fn a_nacelle_is_turned_by_a_drive() {
    const MOUNT: &str = "[rotor.nacelle]\nyaw = \"turning\"\ntilt = 5\noverhang = 4\nmass = 9\n\
        inertia = [1, 1, 1]\n";
    let cards = "[drives.turning]\nexpression = \"40*t^2\"\n[transient]\nto = 1\nstep = 0.02\n";
    let run = Run::new(&rotor("", MOUNT, cards));
    let (rise, along) = 5.0_f64.to_radians().sin_cos();
    for (time, [hub]) in run.motions(["r/hub"]) {
        let (sin, cos) = (40.0 * time * time).to_radians().sin_cos();
        let expected = Vector3::new(-along * cos, -along * sin, rise) * 4.0;
        let off = hub.position - expected;
        assert!(off.norm() < 1e-6, "{time} {off}");
    }
}

#[test]
fn wrong_mounts_are_explained() {
    let tower = "[rotor.tower]\nheight = 20\n";
    let pylon = "[rotor.pylon]\nlength = 1\n";
    let good = format!("{tower}properties = \"column\"\n");
    for (keys, mount, expected) in [
        (
            "",
            tower.to_owned(),
            "the tower needs \"properties\" or \"file\", and not both",
        ),
        (
            "",
            format!("{good}{pylon}"),
            "rotor \"r\" has \"pylon\" and \"tower\", expected one of them",
        ),
        (
            "center = [0, 0, 1]",
            pylon.to_owned(),
            "rotor \"r\" has \"center\" and \"pylon\", expected one of them",
        ),
        (
            "base = [0, 0, 1]",
            String::new(),
            "rotor \"r\" has \"base\" without \"tower\", \"nacelle\" or \"pylon\"",
        ),
        (
            "",
            "[rotor.nacelle]\ninertia = [1, 1, 1]\n".to_owned(),
            "rotor \"r\" has \"inertia\" without \"mass\", expected both",
        ),
        (
            "",
            format!("{pylon}wing = {{ span = [2, 0, 0], properties = \"column\" }}\n"),
            "expected a wing that is not along x",
        ),
    ] {
        let shown = refused(&rotor(keys, &mount, "[modes]\nspeeds = 0\n"));
        assert!(shown.contains(expected), "{expected}: {shown}");
        assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    }
}
