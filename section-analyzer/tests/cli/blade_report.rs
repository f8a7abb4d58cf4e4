//! The report of a blade: its data against the property files and the mesh, its HTML, its size,
//! and its own checks in a browser.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use section_analyzer::input::result_tables::{read_modes, read_reserves};
use serde_json::Value;

use crate::effort;
use crate::strength::STRENGTHS;
use crate::unpacked::unpacked;
use crate::whole_blade::{LAYUP, failing};
use crate::workplace::{Run, Workplace};

/// Largest size of a report of 30 stations \[bytes\].
const LIMIT: usize = 5_000_000;
pub const REPORT: &str = "b/a.report.html";

pub fn blade(workplace: &Workplace, more: &[&str]) -> Run {
    let command = [
        "blade",
        "a.layup.toml",
        "--out",
        "b",
        "--no-figures",
        "--report",
    ];
    workplace.run(&[&command[..], more].concat())
}

/// A blade with a report, of cells as long as by default, and strengths.
fn reported(more: &[&str]) -> Workplace {
    let workplace = Workplace::new();
    let text = LAYUP.replace("[mesh]\nsize = 80\n", "") + "\n" + STRENGTHS;
    workplace.write("a.layup.toml", &text);
    let run = blade(&workplace, more);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    workplace
}

/// The block of data of the report.
pub fn data(workplace: &Workplace) -> Value {
    let page = workplace.read(REPORT);
    let (_, rest) = page.split_once("type=\"application/json\">").unwrap();
    let (data, _) = rest.split_once("</script>").unwrap();
    serde_json::from_str(data).unwrap()
}

fn json(workplace: &Workplace, file: &str) -> Value {
    serde_json::from_str(&workplace.read(file)).unwrap()
}

/// The elements of a page that are not closed in order, and tags that are not as in XML.
fn problems_of_tags(page: &str) -> Vec<String> {
    let (mut open, mut problems): (Vec<&str>, Vec<String>) = (Vec::new(), Vec::new());
    let mut rest = page.strip_prefix("<!DOCTYPE html>").unwrap();
    while let Some((_, after)) = rest.split_once('<') {
        let (tag, after) = after.split_once('>').unwrap();
        rest = after;
        let name = tag.split([' ', '/']).find(|name| !name.is_empty()).unwrap();
        if tag.matches('"').count() % 2 != 0 {
            problems.push(format!("<{tag}>: quotes"));
        }
        if tag.starts_with('/') {
            if open.pop() != Some(name) {
                problems.push(format!("</{name}> closes another element"));
            }
        } else if !tag.ends_with('/') {
            open.push(name);
        }
        // the text of these elements has no tags
        if ["style", "script"].contains(&name) && !tag.starts_with('/') {
            rest = &rest[rest.find(&format!("</{name}>")).unwrap()..];
        }
    }
    problems.extend(open.iter().map(|name| format!("<{name}> is not closed")));
    problems
}

/// Neither network nor other files; one page of balanced tags and unique names.
#[test]
fn the_page_is_one_sound_file() {
    let workplace = reported(&["--stations", "0.2,0.7"]);
    let page = workplace.read(REPORT);
    for word in [
        "http:", "https:", "src=", "@import", "url(", "fetch(", "XMLHttp", "eval(",
    ] {
        assert!(!page.contains(word), "{word}");
    }
    let links: Vec<&str> = page.split("href=\"").skip(1).collect();
    assert!(!links.is_empty() && links.iter().all(|link| link.starts_with('#')));
    assert_eq!(problems_of_tags(&page), [""; 0]);
    let (before, _) = page.split_once("<script id=\"data\"").unwrap();
    let mut names: Vec<&str> = before
        .split(" id=\"")
        .skip(1)
        .map(|rest| rest.split('"').next().unwrap())
        .collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
    let run = workplace.run(&["blade", "a.layup.toml", "--out", "b", "--no-figures"]);
    assert_eq!(run.code, 0);
    assert!(!workplace.path(REPORT).exists());
}

/// Matrices have all digits of the property files; cells are as many as in the mesh, and layers
/// and plies those that it has.
#[test]
fn data_are_the_numbers_of_the_result_files() {
    let workplace = reported(&["--stations", "0.2,0.7,1"]);
    let data = data(&workplace);
    let stations = data["stations"].as_array().unwrap();
    assert_eq!(stations.len(), 3);
    let layers = workplace.read("b/a.layers.csv");
    for station in stations {
        let name = station["name"].as_str().unwrap();
        let file = json(&workplace, &format!("b/sections/{name}.properties.json"));
        for matrix in ["stiffness", "mass"] {
            assert_eq!(station[matrix], file[matrix], "{name} {matrix}");
        }
        assert_eq!(station["tension_center"], file["centers"]["tension"]);
        let picture = &station["picture"];
        assert_eq!(picture["mesh_cells"], file["provenance"]["cells"]);
        assert_eq!(picture["mesh_nodes"], file["provenance"]["nodes"]);
        let plies = picture["plies"].as_array().unwrap();
        let cells: u64 = plies.iter().map(|ply| ply["cells"].as_u64().unwrap()).sum();
        assert_eq!(picture["mesh_cells"].as_u64(), Some(cells));
        let section = workplace.read(&format!("b/sections/{name}.section.toml"));
        for ply in plies {
            let group = format!("group = {}", ply["ply"]);
            assert!(section.contains(&group), "{name} {group}");
        }
        assert_eq!(section.matches("[[region]]").count(), plies.len());
        let listed = layers
            .lines()
            .filter(|line| line.split(',').nth(1) == Some(name));
        let listed: Vec<&str> = listed.map(|line| line.split(',').nth(2).unwrap()).collect();
        let shown = station["layers"].as_array().unwrap().iter();
        let shown: Vec<&str> = shown.map(|layer| layer["name"].as_str().unwrap()).collect();
        assert_eq!(shown, listed);
    }
    let angle = |ply: &str| {
        let plies = stations[0]["picture"]["plies"].as_array().unwrap().iter();
        let found = plies.clone().find(|known| known["ply"] == ply).unwrap();
        found["fiber_angle"].as_f64()
    };
    assert_eq!(angle("skin@suction"), Some(30.0));
    assert_eq!(angle("skin@pressure"), Some(-30.0));
}

/// The orders of other programs turn the matrices of the page as conversions do: without tolerance,
/// each entry is one of Helicoid's with a sign. The values of another blade are the ones of the table.
#[test]
fn matrices_have_the_orders_of_programs_and_another_blade_is_beside() {
    use nalgebra::Matrix6;
    use shared_geom::exchange::Convention;

    let workplace = reported(&["--stations", "0.2,1"]);
    let other = workplace.read("b/a.blade.json");
    workplace.write(
        "other.blade.json",
        &other.replace("\"name\": \"a\"", "\"name\": \"b\""),
    );
    let run = blade(
        &workplace,
        &["--stations", "0.2,1", "--compare", "other.blade.json"],
    );
    assert_eq!(run.code, 0, "{}", run.err);
    let data = data(&workplace);
    let matrix = |value: &Value| Matrix6::from_fn(|i, j| value[i][j].as_f64().unwrap());
    let known = [
        ("Helicoid", Convention::Helicoid),
        ("BeamDyn", Convention::BeamDyn),
        ("HAWC2", Convention::Hawc2),
        ("VABS", Convention::Vabs),
    ];
    for station in data["stations"].as_array().unwrap() {
        let own = matrix(&station["stiffness"]);
        for (order, (name, convention)) in data["orders"].as_array().unwrap().iter().zip(known) {
            assert_eq!(order["name"], name);
            let index = |i: usize| order["index"][i].as_u64().unwrap() as usize;
            let sign = |i: usize| order["sign"][i].as_f64().unwrap();
            let shown = Matrix6::from_fn(|i, j| sign(i) * sign(j) * own[(index(i), index(j))]);
            assert_eq!(shown, convention.from_ours(&own), "{name}");
        }
        let quality = station["picture"]["quality"].as_array().unwrap();
        let [aspect, least, most, jacobian] = [0, 1, 2, 3].map(|i| quality[i].as_f64().unwrap());
        assert!(aspect >= 1.0 && least > 0.0 && least <= 90.0 && (60.0..=180.0).contains(&most));
        assert!(jacobian > 0.0 && jacobian <= 1.0);
    }
    open_in_browser(&workplace.path(REPORT));
    assert_eq!(data["other"]["name"], "b");
    for values in data["other"]["values"].as_array().unwrap() {
        assert_eq!(values[0], values[1]);
    }
}

/// Corners and wall directions of all cells against the section that the program reads: corners
/// within half a step of 2^-22 of the chord of at most 0.5 m, angles within half of 0.01 deg.
#[test]
fn cells_are_the_cells_of_the_mesh_in_the_order_of_plies() {
    let workplace = reported(&["--stations", "0.2,0.7"]);
    let (mut quadrilaterals, mut triangles) = (0, 0);
    for station in data(&workplace)["stations"].as_array().unwrap() {
        let name = station["name"].as_str().unwrap();
        let file = workplace.path(&format!("b/sections/{name}.section.toml"));
        let section = section_analyzer::input::read(&file).unwrap().section;
        let (mesh, picture) = (&section.mesh, &station["picture"]);
        let mut order: Vec<usize> = (0..mesh.cells.len()).collect();
        order.sort_by_key(|&cell| mesh.cells[cell].group);
        let count = order.len();
        let corners = picture["corners"].as_u64().unwrap() as usize;
        let lengths = [corners, corners, count, count, count, count, count];
        let lists = unpacked(picture["geometry"].as_str().unwrap(), &lengths);
        let step = picture["step"].as_f64().unwrap();
        assert!(step <= 0.51 / f64::from(1 << 22), "{step}");
        let place = |axis: usize, corner: i64| {
            let origin = picture["origin"][axis].as_f64().unwrap();
            origin + step * lists[axis][corner as usize] as f64
        };
        for (number, &cell) in order.iter().enumerate() {
            let corners = [2, 3, 4, 5].map(|list| lists[list][number]);
            let angle = lists[6][number] as f64 / 100.0;
            let expected = mesh.cells[cell].corners();
            match expected.len() {
                4 => quadrilaterals += 1,
                _ => triangles += 1,
            }
            for (i, corner) in corners.iter().enumerate() {
                let node = expected[i.min(expected.len() - 1)] as usize;
                for axis in 0..2 {
                    let error = place(axis, *corner) - mesh.nodes[node][axis];
                    assert!(error.abs() < 0.501 * step, "{name} {cell}: {error}");
                }
            }
            let turned = angle.to_radians() - section.cells[cell].plane_angle;
            assert!(
                turned.sin().abs() < 1e-4 && turned.cos() > 0.0,
                "{name} {cell}: {turned}"
            );
        }
    }
    assert!(
        quadrilaterals > 200 && triangles > 0,
        "{quadrilaterals} {triangles}"
    );
}

/// A name cannot end the block of data or become a tag.
#[test]
fn names_cannot_break_the_page() {
    let workplace = Workplace::new();
    workplace.write("<b>&.layup.toml", LAYUP);
    let options = [
        "--out",
        "b",
        "--no-figures",
        "--report",
        "--stations",
        "0.2",
    ];
    let run = workplace.run(&[&["blade", "<b>&.layup.toml"], &options[..]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let page = workplace.read("b/<b>&.report.html");
    assert!(!page.contains("<b>") && page.contains("<h1>&lt;b&gt;&amp;: report"));
    assert_eq!(problems_of_tags(&page), [""; 0]);
    let (_, rest) = page.split_once("type=\"application/json\">").unwrap();
    let data: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    assert_eq!(data["blade"]["name"], "<b>&");
}

const MODES: &str =
    "rotor_speed [rpm],mode,name,frequency [Hz]\n0,1,flap 1,1.25\n60,1,\"flap, 1\",\n";
const RESERVES: &str = "eta [-],section,ply,material,reserve_factor [-],failure_index [-],criterion,mode,\
                        instant,y [m],z [m],axial [N],shear_y [N],shear_z [N],torsion [N m],\
                        bending_y [N m],bending_z [N m],fingerprint\n\
                        0.1,eta_0.1000,cap,foam,inf,0,max_stress,fiber,load,0.1,-0.02,1,2,3,4,5,-6e3,0123\n";

/// Quotes, empty frequencies and infinite factors are read; wrong tables are refused with line and
/// remedy.
#[test]
fn tables_of_other_commands_are_read_or_refused() {
    let workplace = Workplace::new();
    let path = workplace.path("a.csv");
    let modes = |text: &str| {
        workplace.write("a.csv", text);
        read_modes(&path).map_err(|problems| problems.to_string())
    };
    let read = modes(MODES).unwrap();
    assert_eq!(
        (read.speeds, read.frequencies),
        (vec![0.0, 60.0], vec![Some(1.25), None])
    );
    assert_eq!(read.names, ["flap 1", "flap, 1"]);
    for (from, to, expected) in [
        ("name", "nam", "a.csv:1: the table has no column \"name\""),
        ("name", "nam", "did you mean \"nam\"?"),
        ("rotor_speed [rpm]", "u", "name the table NAME.modes.csv"),
        (
            "1.25",
            "x",
            "a.csv:2: column \"frequency [Hz]\": found \"x\", expected a number",
        ),
        ("60,", "", "a.csv:3: the row has 3 cells, expected 4"),
    ] {
        let text = modes(&MODES.replacen(from, to, 1)).unwrap_err();
        assert!(text.contains(expected), "{text}");
    }
    assert!(
        modes("name\n")
            .unwrap_err()
            .contains("the table has no rows")
    );
    workplace.write("a.csv", RESERVES);
    let reserve = read_reserves(&path).unwrap().remove(0);
    assert_eq!(
        (reserve.reserve_factor, reserve.position),
        (f64::INFINITY, [0.1, -0.02])
    );
    assert_eq!(reserve.force, [1.0, 2.0, 3.0, 4.0, 5.0, -6e3]);
    assert_eq!(reserve.fingerprint, "0123");
    workplace.write("a.csv", &RESERVES.replace("inf", "nan"));
    let text = read_reserves(&path).unwrap_err().to_string();
    assert!(
        text.contains("a.csv:2: column \"reserve_factor [-]\""),
        "{text}"
    );
}

/// Layers that are cut and a section that fails are remarks; the other sections are shown.
#[test]
fn remarks_name_sections_that_are_missing() {
    let workplace = reported(&["--stations", "0.2,0.7"]);
    let thick = failing(&workplace.read("a.layup.toml"));
    workplace.write("a.layup.toml", &thick);
    let run = blade(&workplace, &["--stations", "0.2,0.7"]);
    assert_eq!(run.code, 1);
    let data = data(&workplace);
    assert_eq!(data["stations"].as_array().unwrap().len(), 1);
    let remarks = data["remarks"].as_array().unwrap().iter();
    let texts: Vec<&str> = remarks
        .map(|remark| remark["text"].as_str().unwrap())
        .collect();
    let expected = "no section at eta 0.7: the messages of the run have the reason";
    assert!(texts.contains(&expected), "{texts:?}");
    workplace.write(
        "a.layup.toml",
        &thick.replace("thickness = 1.5", "thickness = 150"),
    );
    assert_eq!(blade(&workplace, &["--stations", "0.7"]).code, 1);
    assert!(!workplace.path(REPORT).exists());
}

fn reserves(data: &Value) -> BTreeMap<(String, String), f64> {
    let rows = data["reserves"].as_array().unwrap().iter();
    let text = |row: &Value, key: &str| row[key].as_str().unwrap().to_owned();
    rows.map(|row| {
        let key = (text(row, "section"), text(row, "ply"));
        (key, row["reserve_factor"].as_f64().unwrap())
    })
    .collect()
}

/// Writes figures of shapes at three speeds.
fn write_shapes(workplace: &Workplace) {
    for rpm in ["0", "50", "100"] {
        let circle = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\"><text>{rpm}</text></svg>"
        );
        workplace.write(&format!("a.shapes_at_{rpm}_rpm.svg"), &circle);
    }
}

/// The figures at the first and the last speed are in the report, byte by byte.
fn check_shapes(workplace: &Workplace, shown: &Value) {
    let shapes = shown["modes"]["shapes"].as_array().unwrap();
    let speeds: Vec<&str> = shapes
        .iter()
        .map(|one| one["speed"].as_str().unwrap())
        .collect();
    assert_eq!(speeds, ["0", "100"]);
    let image = STANDARD
        .decode(shapes[1]["image"].as_str().unwrap())
        .unwrap();
    assert_eq!(
        image,
        workplace.read("a.shapes_at_100_rpm.svg").into_bytes()
    );
}

/// Modes with the fingerprint of the blade file have no remark, and others have one; the column is not shown.
fn check_blade_of_modes(workplace: &Workplace, options: &[&str]) {
    let file = workplace.read("b/a.blade.json");
    let hash = shared_geom::hash::sha256_of_content(file.as_bytes());
    let own = shared_geom::hash::fingerprint(&hash);
    let remark = "a.modes.csv does not name the file of its blade";
    assert!(data(workplace)["remarks"].to_string().contains(remark));
    for (fingerprint, is_own) in [(own, true), ("0123456789abcdef", false)] {
        let table = format!(
            "rotor_speed [rpm],name,frequency [Hz],blade_files\n\
             0,flap 1,2.5,a.blade.json {fingerprint}\n100,flap 1,3.5,a.blade.json {fingerprint}\n"
        );
        workplace.write("b.modes.csv", &table);
        let options = options.iter().map(|one| one.replace("a.modes", "b.modes"));
        let options: Vec<String> = options.collect();
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        assert_eq!(blade(workplace, &options).code, 0);
        let shown = data(workplace);
        let columns = ["rotor_speed [rpm]", "name", "frequency [Hz]"];
        assert_eq!(shown["modes"]["columns"], serde_json::json!(columns));
        let remarks = shown["remarks"].to_string();
        assert_eq!(remarks.contains("b.modes.csv"), !is_own, "{remarks}");
        let other = "has the modes of another blade, or of this one before a change (a.blade.json 0123456789abcdef)";
        assert_eq!(remarks.contains(other), !is_own, "{remarks}");
    }
}

/// Reserve factors are the ones of `strength` as long as the sections have the content that it read,
/// whenever they were solved; modes the ones of
/// their file, and a wrong file is refused before a section is solved.
#[test]
fn strengths_and_modes_are_shown_if_they_are_given() {
    let options = ["--stations", "0.2,0.7"];
    let workplace = reported(&options);
    assert!(reserves(&data(&workplace)).is_empty() && data(&workplace)["modes"].is_null());
    workplace.write("loads.csv", "eta,bending y [N m]\n0,-3000\n1,0\n");
    let run = workplace.run(&["strength", "b/a.span.csv", "--loads", "loads.csv"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let table = "rotor_speed [rpm],mode,name,frequency [Hz]\n0,1,flap 1,2.5\n100,1,flap 1,3.5\n";
    workplace.write("a.modes.csv", table);
    write_shapes(&workplace);
    let with_modes = [&options[..], &["--modes", "a.modes.csv"]].concat();
    assert_eq!(blade(&workplace, &with_modes).code, 0);
    let shown = data(&workplace);
    assert_eq!(shown["modes"]["frequencies"], serde_json::json!([2.5, 3.5]));
    check_shapes(&workplace, &shown);
    check_blade_of_modes(&workplace, &with_modes);
    let found = reserves(&shown);
    let strength = workplace.read("b/a.strength.csv");
    assert_eq!(found.len(), strength.lines().count() - 1);
    for line in strength.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let key = (cells[1].to_owned(), cells[2].to_owned());
        assert_eq!(found[&key], cells[4].parse::<f64>().unwrap(), "{line}");
    }
    // the moment at eta 0.2, on the line from the root to the tip
    let rows = shown["reserves"].as_array().unwrap();
    let force = rows
        .iter()
        .find(|row| row["section"] == "eta_0.2000")
        .unwrap()["force"]
        .clone();
    assert_eq!(force, serde_json::json!([0.0, 0.0, 0.0, 0.0, -2400.0, 0.0]));
    open_in_browser(&workplace.path(REPORT));

    let layup = workplace.read("a.layup.toml");
    workplace.write("a.layup.toml", &layup.replace("\"1900 kg", "\"1901 kg"));
    assert_eq!(blade(&workplace, &options).code, 0);
    let shown = data(&workplace);
    assert!(reserves(&shown).is_empty() && shown["modes"].is_null());
    let remark =
        "a.strength.csv is not shown, sections have changed since (eta_0.2000, eta_0.7000): run";
    assert!(
        shown["remarks"].to_string().contains(remark),
        "{}",
        shown["remarks"]
    );
    // solved later than the table was written, with the content as it was then
    workplace.write("a.layup.toml", &layup);
    assert_eq!(blade(&workplace, &options).code, 0);
    assert_eq!(reserves(&data(&workplace)), found);

    workplace.write("a.modes.csv", &table.replace("2.5", "two"));
    let run = blade(&workplace, &with_modes);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    let expected = "error: a.modes.csv:2: column \"frequency [Hz]\": found \"two\"";
    assert!(run.err.starts_with(expected), "{}", run.err);
    let run = workplace.run(&["blade", "a.layup.toml", "--modes", "a.modes.csv"]);
    assert_eq!(run.code, 2);
}

/// The size grows with the stations: from three of them, or of all 30 in the long form.
#[test]
fn thirty_stations_are_under_five_megabytes() {
    let count = if effort::is_long() { 30 } else { 3 };
    // with both sides of the jump at the end of the cap
    let workplace = reported(&["--count", &count.to_string()]);
    let stations = data(&workplace)["stations"].as_array().unwrap().len();
    let size = workplace.read(REPORT).len();
    let code = size - data(&workplace).to_string().len();
    let each = (size - code) / stations;
    println!("{stations} stations: {size} bytes, {code} without data, {each} each");
    assert!(code + 30 * each < LIMIT);
    open_in_browser(&workplace.path(REPORT));
}

/// A program of the search path.
fn program(names: &[&str]) -> Option<PathBuf> {
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let mut files = names
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    files.find(|file| file.is_file())
}

/// Runs the checks of the page in a browser. Without a browser this is an error in the long form
/// only.
pub fn open_in_browser(page: &Path) {
    let browsers = ["chromium", "chromium-browser", "google-chrome", "chrome"];
    let (Some(browser), Some(python)) = (program(&browsers), program(&["python3"])) else {
        assert!(
            !effort::is_long(),
            "the long form needs Chromium and python3"
        );
        println!("without Chromium and python3, the page is not opened");
        return;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/browser/report.py");
    let done = Command::new(python)
        .arg(script)
        .arg(browser)
        .arg(page)
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(
        done.status.success(),
        "{text}{}",
        String::from_utf8_lossy(&done.stderr)
    );
    assert!(text.starts_with("PASS "), "{text}");
}
