//! The speed of a hub on a gimbal of two universal joints.

use std::fs;
use std::path::Path;

use beam_dynamics::input;
use beam_dynamics::model::NodeMotion;

use super::models::run;

/// Three stiff blades from 0.2 m to 1.2 m; a joint tilts the yoke about a direction that does not turn,
/// smoothly to an angle [deg].
fn text(tilt: f64) -> String {
    format!(
        r#"
units = "SI"
[properties.strip]
ea = 7e9
gay = 2e9
gaz = 2e9
gj = 3e7
eiy = 4e7
eiz = 4e7
m = 2
iy = 1e-5
iz = 1e-5
[[rotor]]
name = "r"
hub = "gimballed"
blades = 3
speed = 300
link = 0.1
[rotor.blade]
hub_radius = 0.2
properties = "strip"
piece = [{{ length = 1, elements = 2 }}]
[[node]]
name = "tilter"
position = [0, 0, 0]
[[joint]]
kind = "total"
nodes = ["tilter"]
locked = ["x", "y", "z", "about y", "about z"]
rotation = {{ x = {{ kind = "ramp", to = {tilt:?}, end = 0.06, shape = "smooth" }} }}
[[joint]]
kind = "plane-rotation"
nodes = ["tilter", "r/yoke"]
axis = [0, 0, 1]
[transient]
to = 0.18
step = 5e-4
newton.tolerance = 1e-12
"#
    )
}

// Two universal joints in phase whose link slides: the yoke turns about its own axis with the speed
// of the mast at tilts of 2, 5, 10 and 12 degrees, where one joint would vary it by 2 % at the last.
// Accepted: 1e-6. The speed of the intermediate link varies between the cosine of half the tilt and its
// inverse, 1e-5 with extremes between two steps; the listed ones are of samples that miss the extremes by
// up to 2e-5.
#[test]
fn a_gimballed_hub_turns_at_the_speed_of_its_mast() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/theory-rotor");
    let json = fs::read_to_string(folder.join("gimbal_swashplate.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let listed = |key: &str, row: usize| json["double_cardan"][key][row].as_f64().unwrap();
    let rows = json["double_cardan"]["tilt_deg"].as_array().unwrap().len();
    assert_eq!(rows, 4);
    for row in 0..rows {
        let angle = listed("tilt_deg", row);
        let input = input::parse(&text(angle), "a.dynamics.toml").unwrap();
        let (kept, outcome) = run(&input.model, &input.transient.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let nodes = ["r/hub", "r/yoke", "r/lower link"].map(|name| {
            let mut labels = input.model.system.nodes().iter().map(|node| &node.label);
            labels.position(|label| label == name).unwrap()
        });
        let mut largest = 0.0_f64;
        let [mut tilts, mut of_link] = [[f64::INFINITY, 0.0_f64]; 2];
        let tilted = kept.times.iter().zip(&kept.states);
        for (_, state) in tilted.filter(|(time, _)| **time > 0.07) {
            let [hub, yoke, link] = nodes.map(|node| state.nodes[node]);
            let speed = |node: &NodeMotion| node.rotation.column(2).dot(&node.angular_velocity);
            let cosine = hub.rotation.column(2).dot(&yoke.rotation.column(2));
            let found = [cosine.acos().to_degrees(), speed(&link) / speed(&hub)];
            for (extremes, value) in [&mut tilts, &mut of_link].into_iter().zip(found) {
                *extremes = [extremes[0].min(value), extremes[1].max(value)];
            }
            largest = largest.max((speed(&yoke) / speed(&hub) - 1.0).abs());
        }
        let off = tilts.map(|tilt| (tilt - angle).abs());
        assert!(off.into_iter().all(|off| off < 1e-6), "{tilts:?}");
        assert!(largest < 1e-6, "{angle}: {largest:e}");
        let cosine = (0.5 * angle).to_radians().cos();
        let expected = [(cosine, "mid_shaft_min"), (1.0 / cosine, "mid_shaft_max")];
        for (found, (exact, key)) in of_link.into_iter().zip(expected) {
            assert!((found - exact).abs() < 1e-5, "{angle} {key}: {found}");
            let off = (found - listed(key, row)).abs();
            assert!(off < 3e-5, "{angle} {key}: {found}");
        }
    }
}
