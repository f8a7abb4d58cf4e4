//! Files of PreVABS that are refused: messages, and damaged files.

use crate::effort;
use crate::prevabs::{changed, read, text};
use crate::random::Random;

/// A file, a text in it, the text in its place, and a part of the message.
const REFUSED: [(&str, &str, &str, &str); 26] = [
    (
        "box.xml",
        "</cross_section>",
        "<component name=\"core\" type=\"fill\"><material>mat_1</material></component></cross_section>",
        "location",
    ),
    (
        "box.xml",
        "</cross_section>",
        "<component type=\"fill\"><location>tl</location><baseline>around</baseline>\
         <material>mat_1</material></component></cross_section>",
        "found <baseline>, expected <location> and <material>\n  help: change the [[fill]] of the written",
    ),
    (
        "box.xml",
        "</cross_section>",
        "<component type=\"fill\"><location>tl</location><material>mat_2</material></component>\
         </cross_section>",
        "did you mean \"mat_1\"?",
    ),
    (
        "box.xml",
        "</cross_section>",
        "<component type=\"filler\"></component></cross_section>",
        "expected type \"laminate\" or \"fill\"",
    ),
    (
        "box.xml",
        "tl,tr,br,bl,tl",
        "tl,tr,br,bl",
        "found no segments that close a contour",
    ),
    (
        "box.xml",
        "direction=\"right\"",
        "",
        "direction left, expected right, into the section",
    ),
    (
        "box.xml",
        "direction=\"right\"",
        "direction=\"up\"",
        "found \"up\", expected left or right or both",
    ),
    (
        "box.xml",
        ">around</baseline>",
        ">arund</baseline>",
        "did you mean \"around\"?",
    ),
    (
        "box.xml",
        ">wall</layup>",
        ">wal</layup>",
        "did you mean \"wall\"?",
    ),
    (
        "box.xml",
        "lamina=\"la\"",
        "lamina=\"lo\"",
        "did you mean \"la\"?",
    ),
    (
        "box.xml",
        "<points>tl",
        "<points>tx",
        "did you mean \"tl\"?",
    ),
    ("box.xml", "-15:6", "-15:6.5", "expected angle:count"),
    (
        "box.xml",
        "<general>",
        "<general><scale>-1</scale>",
        "expected a positive number",
    ),
    (
        "box.xml",
        "<general>",
        "<general><rotation>1</rotation>",
        "<rotation> in <general>",
    ),
    (
        "box.xml",
        "<general>",
        "<analysis><initial_twist>0.1</initial_twist></analysis><general>",
        "\"curvature\" and \"expansion\"",
    ),
    (
        "box.xml",
        "name=\"box\"",
        "name=\"box\" type=\"airfoil\"",
        "type of <cross_section>",
    ),
    (
        "box.xml",
        "<e1>20.59e+06</e1>",
        "",
        "expected <e1> with its value",
    ),
    (
        "box.xml",
        "<nu12>0.30</nu12>",
        "<nu12>4.5</nu12>",
        "correct the constants of the material",
    ),
    (
        "box.xml",
        "<segment name",
        "<segment free=\"head\" name",
        "no free end",
    ),
    (
        "box.xml",
        "<cross_section",
        "<!DOCTYPE a [<!ENTITY b \"c\">]><cross_section",
        "DTD",
    ),
    ("box.xml", "</layups>", "", "found "),
    (
        "pipe.xml",
        "<angle>180</angle>\n      <direction>cw</direction>\n    </line>",
        "<direction>cw</direction></line>",
        "expected <angle> with its value",
    ),
    (
        "pipe.xml",
        "\"lr\">1.0 -0.5<",
        "\"lr\">1.0 -0.6<",
        "equal distances of start and end",
    ),
    (
        "mh104.xml",
        "mh104_lines",
        "mh104_line",
        "no file \"mh104_line\"",
    ),
    (
        "mh104.xml",
        "<baseline>web_1</baseline>",
        "<baseline>upper_2</baseline>",
        "a curved line",
    ),
    (
        "mh104.xml",
        "<segment name=\"web_1\">",
        "<segment name=\"web_1\"><joint/>",
        "<joint> in <segment> \"web_1\"",
    ),
];

/// Everything that is not carried is refused with its line, its name and the remedy.
#[test]
fn other_sections_are_refused() {
    for (name, from, to, expected) in REFUSED {
        let problems = read(&changed(name, &[(from, to)])).expect_err(to);
        assert!(problems.contains(expected), "{name} {to}: {problems}");
        assert!(
            problems.contains("error: a.dat:") || problems.contains("error: mh104"),
            "{problems}"
        );
        assert!(problems.contains("help: "), "{problems}");
    }
    // all problems at once
    let many = [
        ("<points>tl", "<points>tx"),
        ("lamina=\"la\"", "lamina=\"lo\""),
        ("-0.265<", "x<"),
    ];
    let problems = read(&changed("box.xml", &many)).expect_err("problems");
    assert!(problems.matches("error: ").count() == 4, "{problems}");
}

/// Names that are defined twice, and the one that is used.
#[test]
fn names_defined_twice_are_remarks() {
    let point = "<point name=\"bl\">-0.4765 -0.265</point>";
    let around =
        "<baseline name=\"around\" type=\"straight\"><points>bl,tl,tr,br,bl</points></baseline>";
    let other = point.replace("-0.265<", "-0.3<");
    for (from, to, expected) in [
        (
            point,
            format!("{point}{other}"),
            "the point \"bl\" is defined twice, and the first one is used",
        ),
        (
            "</baselines>",
            format!("{around}</baselines>"),
            "<baseline> \"around\" is defined twice, and the second one is used",
        ),
    ] {
        let layup = read(&changed("box.xml", &[(from, to.as_str())]));
        let remarks = layup
            .unwrap_or_else(|problems| panic!("{problems}"))
            .remarks;
        assert_eq!(
            remarks.iter().filter(|one| *one == expected).count(),
            1,
            "{remarks:?}"
        );
    }
}

/// Changes a text at random.
fn damaged(text: &str, random: &mut Random) -> String {
    let mut text = text.to_owned();
    let pick = |count: usize, random: &mut Random| (random.unit() * count as f64) as usize;
    for _ in 0..=pick(3, random) {
        let marks: Vec<usize> = text.match_indices('<').map(|one| one.0).collect();
        let numbers: Vec<usize> = text
            .match_indices(|one: char| one.is_ascii_digit())
            .map(|one| one.0)
            .collect();
        if marks.len() < 3 || numbers.is_empty() {
            break;
        }
        let (mark, digit) = (
            marks[pick(marks.len(), random)],
            numbers[pick(numbers.len(), random)],
        );
        let end = text[mark..]
            .find('>')
            .map_or(text.len(), |end| mark + end + 1);
        match pick(7, random) {
            0 => text.truncate(mark),
            1 => text.replace_range(mark..end, ""),
            2 => {
                let copy = text[mark..end].to_owned();
                text.insert_str(mark, &copy);
            }
            3 => {
                let value = ["-", "9", "e9", "1e300", "x", "0 0", ":", "1e-300"][pick(8, random)];
                text.replace_range(digit..=digit, value);
            }
            4 => {
                let letters = "\"'[]{}=,.#- 0a/:&;<>";
                let at = pick(letters.len(), random);
                text.replace_range(digit..=digit, &letters[at..=at]);
            }
            5 => {
                // two names are exchanged
                let other = marks[pick(marks.len(), random)];
                let name = |at: usize| {
                    let end = text[at..]
                        .find([' ', '>', '/'])
                        .map_or(text.len(), |end| at + end);
                    text[at..end.max(at + 1)].to_owned()
                };
                let (name, new) = (name(mark), name(other));
                text.replace_range(mark..mark + name.len(), &new);
            }
            _ => {
                let lines: Vec<&str> = text.lines().collect();
                let (a, b) = (pick(lines.len(), random), pick(lines.len(), random));
                let mut lines: Vec<String> = lines.into_iter().map(str::to_owned).collect();
                lines.swap(a, b);
                text = lines.join("\n");
            }
        }
    }
    text
}

/// Files with one to three random changes are read, or refused with a location and a remedy; a
/// section that is read is meshed or refused with its line.
#[test]
fn damaged_files_are_read_or_refused() {
    let (mut read_ones, mut refused, mut meshed) = (0, 0, 0);
    for seed in 0..effort::cases(400) {
        let mut random = Random::new(900 + seed as u64);
        let name = ["box.xml", "pipe.xml", "mh104.xml"][seed % 3];
        let text = damaged(&text(name), &mut random);
        if !text.trim_start().starts_with('<') || !text.contains("<cross_section") {
            continue;
        }
        match read(&text) {
            Ok(layup) => {
                read_ones += 1;
                match layup.mesh(0.0) {
                    Ok(_) => meshed += 1,
                    Err(problems) => assert!(problems.to_string().contains("a.dat:"), "{seed}"),
                }
            }
            Err(problems) => {
                refused += 1;
                assert!(problems.contains("error: "), "{seed}: {problems}");
                let has_line =
                    problems.contains("error: a.dat:") || problems.contains("error: mh104");
                assert!(has_line, "{seed}: {problems}");
            }
        }
    }
    println!("{read_ones} read, {meshed} of them meshed, {refused} refused");
    assert!(meshed > 15 && refused > 100);
}

/// Nested elements and circles of names end with a message.
#[test]
fn deep_files_are_refused() {
    let deep = format!("<cross_section name=\"a\">{}", "<general>".repeat(20_000));
    assert!(read(&deep).expect_err("not closed").contains("help: "));
    let lines: String = (0..200)
        .map(|i| {
            format!(
                "<line name=\"l{i}\" method=\"join\"><line>l{}</line></line>",
                (i + 1) % 200
            )
        })
        .collect();
    let circle = [
        ("</baselines>", format!("{lines}</baselines>")),
        (">around<", ">l0<".to_owned()),
    ];
    let circle: Vec<(&str, &str)> = circle.iter().map(|(a, b)| (*a, b.as_str())).collect();
    let problems = read(&changed("box.xml", &circle)).expect_err("a circle");
    assert!(problems.contains("refer to"), "{problems}");
}
