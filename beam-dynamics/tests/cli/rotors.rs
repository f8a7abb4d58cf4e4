//! `expand`: a rotor, the cards to which it expands, and equal results.

use super::Folder;

const ROTOR: &str = "\
units = \"SI\"
# a rotor
[[rotor]]
name = \"r\"
hub = \"articulated\"
blades = 2
speed = 300
[rotor.blade]
hub_radius = 0.2
properties = \"strip\"
piece = [{ length = 1, elements = 2 }]
[[rotor.hinge]]
kind = \"flap\"
stiffness = 3
# of the blades
[properties.strip]
ea = 7e6
gay = 2e6
gaz = 1e6
gj = 30
eiy = 40
eiz = 900
m = 2
iy = 0.01
iz = 0.04
[modes]
speeds = [300]
count = 4
";

#[test]
fn an_expanded_file_has_the_same_results() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", ROTOR);
    let run = folder.run(&["expand", "a.dynamics.toml", "--out", "b.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let text = std::fs::read_to_string(folder.path("b.dynamics.toml")).unwrap();
    assert!(
        text.starts_with("units = \"SI\"\n# a rotor\n[hub]\n"),
        "{text}"
    );
    assert!(
        text.contains("# of the blades\n[properties.strip]\n"),
        "{text}"
    );
    let shown = folder.run(&["expand", "a.dynamics.toml"]);
    assert_eq!(shown.out, text);
    let tables = ["a", "b"].map(|name| {
        let file = format!("{name}.dynamics.toml");
        let run = folder.run(&["modes", &file, "--out", name, "--quiet"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let table = folder.path(&format!("{name}/{name}.frequencies.csv"));
        std::fs::read_to_string(table).unwrap()
    });
    assert_eq!(tables[0], tables[1]);
}

#[test]
fn an_expanded_file_stays_in_its_folder() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", ROTOR);
    folder.write("other/c.txt", "");
    let run = folder.run(&[
        "expand",
        "a.dynamics.toml",
        "--out",
        "other/b.dynamics.toml",
    ]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("is in another folder than"), "{}", run.err);
    folder.write(
        "a.dynamics.toml",
        "units = \"SI\"\nrotor = [{ name = \"r\" }]\n",
    );
    let run = folder.run(&["expand", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("has no \"hub\""), "{}", run.err);
}
