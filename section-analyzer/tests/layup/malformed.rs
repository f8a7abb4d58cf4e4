//! Turbine files with wrong layers: every one is meshed, or refused by the name of the layer.

use section_analyzer::input::layup::Layup;

use crate::effort;
use crate::random::Random;
use crate::windio::read;

/// Files of version 1 and 2.
const FILES: [&str; 2] = ["windio1_iea15", "windio2_iea34"];
/// Beginning of a layer.
const LAYER: &str = "        - name: ";

fn text(name: &str) -> String {
    let folder = std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let file = folder.join(format!("../tests/reference/layups/{name}.yaml"));
    std::fs::read_to_string(file).expect("a file")
}

/// Numbers of the first and last line of each layer of a text, and its name.
fn layers(lines: &[String]) -> Vec<([usize; 2], String)> {
    let start = lines.iter().position(|line| line == "      layers:");
    let start = start.expect("layers") + 1;
    let is_inside = |line: &&String| line.starts_with("        ");
    let end = start + lines[start..].iter().take_while(is_inside).count();
    let begins = (start..end).filter(|i| lines[*i].starts_with(LAYER));
    let mut begins: Vec<usize> = begins.collect();
    begins.push(end);
    let layer = |pair: &[usize]| ([pair[0], pair[1]], lines[pair[0]][LAYER.len()..].to_owned());
    begins.windows(2).map(layer).collect()
}

/// Changes the values of a table in a line.
fn change_values(line: &mut String, change: &mut dyn FnMut(Vec<String>) -> Vec<String>) {
    let Some((head, rest)) = line.split_once("values: [") else {
        return;
    };
    let Some((values, tail)) = rest.split_once(']') else {
        return;
    };
    let values = values.split(", ").map(str::to_owned).collect();
    *line = format!("{head}values: [{}]{tail}", change(values).join(", "));
}

fn scaled(values: Vec<String>, factor: f64) -> Vec<String> {
    let number = |value: &String| value.parse::<f64>().expect("a number");
    let values = values
        .iter()
        .map(|value| (number(value) * factor).to_string());
    values.collect()
}

/// The line of a key in a layer.
fn line_of<'a>(lines: &'a mut [String], layer: [usize; 2], key: &str) -> Option<&'a mut String> {
    let mut all = lines[layer[0]..layer[1]].iter_mut();
    all.find(|line| line.trim_start().starts_with(key))
}

/// Changes a layer at random; the result may be valid.
fn damage(lines: &mut [String], layer: [usize; 2], random: &mut Random) {
    let kind = (10.0 * random.unit()) as usize;
    let factor = 10.0_f64.powf(random.range(-1.5, 1.5));
    match kind {
        1 => *line_of(lines, layer, "material:").expect("one") += "_other",
        2 => lines[layer[0]] = format!("{LAYER}{}", layers(lines)[0].1),
        3 => *line_of(lines, layer, "material:").expect("one") = String::new(),
        4 => {
            let wrong = ["-0.1", ".nan", "thick"][(2.999 * random.unit()) as usize].to_owned();
            let line = line_of(lines, layer, "thickness:").expect("one");
            change_values(line, &mut |mut values| {
                values[0].clone_from(&wrong);
                values
            });
        }
        5 => {
            let line = line_of(lines, layer, "thickness:").expect("one");
            change_values(line, &mut |mut values| {
                values.pop();
                values
            });
        }
        6 => {
            for line in &mut lines[layer[0]..layer[1]] {
                *line = line.replace("start_nd_arc: ", "other: ");
                *line = line.replace("end_nd_arc: ", "start_nd_arc: ");
                *line = line.replace("other: ", "end_nd_arc: ");
            }
        }
        7 => *line_of(lines, layer, "thickness:").expect("one") = String::new(),
        8 => {
            let shift = random.range(-0.05, 0.05);
            for key in ["start_nd_arc:", "end_nd_arc:"] {
                if let Some(line) = line_of(lines, layer, key) {
                    change_values(line, &mut |values| {
                        let moved = values.iter().map(|value| {
                            (value.parse::<f64>().expect("a number") + shift).to_string()
                        });
                        moved.collect()
                    });
                }
            }
        }
        9 => *line_of(lines, layer, "thickness:").expect("one") += " wrong",
        _ => {
            let line = line_of(lines, layer, "thickness:").expect("one");
            change_values(line, &mut |values| scaled(values, factor));
        }
    }
}

/// 100 files with a changed layer: a file that is read is meshed at a random position, or the layer
/// or web that cannot be meshed is named; a file that is refused names the changed layer.
#[test]
fn changed_files_are_meshed_or_refused_by_name() {
    let texts = FILES.map(text);
    let mut counts = [0; 3];
    for seed in 0..effort::cases(100) {
        let random = &mut Random::new(31_000 + seed as u64);
        let mut lines: Vec<String> = texts[seed % 2].lines().map(str::to_owned).collect();
        let all = layers(&lines);
        let (layer, name) = &all[(all.len() as f64 * random.unit()) as usize];
        damage(&mut lines, *layer, random);
        match read(&lines.join("\n")) {
            Err(problems) => {
                // text behind a table is a mistake of the file, whose line is given
                let line = format!("a.yaml:{}", layer[0] + 1);
                let is_near = (layer[0]..=layer[1])
                    .any(|line| problems.contains(&format!("a.yaml:{}:", line + 1)));
                // a line with an anchor of the YAML text, which other layers use
                let is_anchor = problems.contains("found unknown anchor");
                let is_named = problems.contains(&format!("\"{name}\"")) || is_near || is_anchor;
                assert!(is_named, "{seed}: {name} {line}: {problems}");
                counts[0] += 1;
            }
            Ok(layup) => counts[1 + usize::from(!is_meshed(&layup, random, seed))] += 1,
        }
    }
    println!(
        "{} refused, {} meshed, {} not meshed",
        counts[0], counts[1], counts[2]
    );
    assert!(counts[0] > 25 && counts[1] > 25, "{counts:?}");
}

/// Whether a section at a random position is meshed; else the layer or web must be named.
fn is_meshed(layup: &Layup, random: &mut Random, seed: usize) -> bool {
    match layup.mesh(random.unit()) {
        Ok(_) => true,
        Err(problems) => {
            let text = problems.to_string();
            let is_named = text.contains("layer \"") || text.contains("web \"");
            assert!(is_named, "{seed}: {text}");
            false
        }
    }
}
