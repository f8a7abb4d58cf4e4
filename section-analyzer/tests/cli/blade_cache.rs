//! The cache of `section-analyzer blade`: a changed number of the layup is a changed section.

use crate::effort;
use crate::whole_blade::LAYUP;
use crate::workplace::{Run, Workplace};

/// Solves the section at 0.7, where all layers are.
fn blade(workplace: &Workplace) -> Run {
    let command = ["blade", "a.layup.toml", "--out", "b", "--no-figures"];
    workplace.run(&[&command[..], &["--stations", "0.7"]].concat())
}

/// Byte ranges of the numbers of shape, layers, web, mesh and materials that are not part of a name. The
/// line of the blade is no part of its sections.
fn numbers() -> Vec<std::ops::Range<usize>> {
    let start = LAYUP.find("[shape]").expect("the shape");
    let is_part = |byte: u8| byte.is_ascii_digit() || byte == b'.';
    let bytes = LAYUP.as_bytes();
    let mut found = Vec::new();
    let mut at = start;
    while at < bytes.len() {
        let length = bytes[at..]
            .iter()
            .take_while(|byte| is_part(**byte))
            .count();
        let before = bytes[at - 1];
        let is_name = before.is_ascii_alphanumeric() || [b'_', b'^'].contains(&before);
        if length > 0 && !is_name {
            found.push(at..at + length);
        }
        at += length.max(1);
    }
    found
}

/// Another number in the place of one: the airfoil another one, others larger by a thousandth; positions
/// along the span too, up to 1.
fn changed(number: &std::ops::Range<usize>) -> String {
    let text = &LAYUP[number.clone()];
    let value: f64 = text.parse().expect("a number");
    let new = match text {
        "0018" => "0017".to_owned(),
        "0" if LAYUP[..number.start].ends_with("eta = [") => "0.001".to_owned(),
        "1" => "0.999".to_owned(),
        "0" => "0.001".to_owned(),
        _ => (value * 1.001).to_string(),
    };
    [&LAYUP[..number.start], &new, &LAYUP[number.end..]].concat()
}

/// The largest length of cells divides the contour into a whole number of cells: it is changed by half.
fn is_of_mesh(number: &std::ops::Range<usize>) -> bool {
    LAYUP[..number.start].ends_with("size = ")
}

/// Every number of the layup, changed by a thousandth, solves the section again, and as it was, not: its
/// results are found, with the same bytes. All of them in the long form, every sixth one else.
#[test]
fn a_changed_number_is_a_changed_section() {
    let workplace = Workplace::new();
    let all = numbers();
    assert!(all.len() > 30, "{}", all.len());
    let step = if effort::is_long() { 1 } else { 6 };
    let properties = "b/sections/eta_0.7000.properties.json";
    for (i, number) in all.iter().enumerate().step_by(step) {
        let mut text = changed(number);
        if is_of_mesh(number) {
            text = LAYUP.replace("size = 80", "size = 40");
        }
        // without a line that has no effect, so that the first run solves
        workplace.write("a.layup.toml", LAYUP);
        let run = blade(&workplace);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{i}");
        let before = workplace.read(properties);
        let run = blade(&workplace);
        assert!(run.out.contains("1 unchanged"), "{i}: {}", run.out);
        assert_eq!(workplace.read(properties), before);
        workplace.write("a.layup.toml", &text);
        let run = blade(&workplace);
        let line = LAYUP[..number.start]
            .rsplit('\n')
            .next()
            .unwrap_or_default();
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{i}: {line}");
        assert!(run.out.contains("1 solved"), "{i} {line}: {}", run.out);
    }
}

/// A change of strengths solves no section again: results name the new input, and have the same bytes as
/// solved ones, report and record too. A change of stiffness beside it does solve.
#[test]
fn changed_strengths_solve_no_section_again() {
    let workplace = Workplace::new();
    let isotropic = |strength: f64| {
        let limits = format!("strength = {{ tension = {strength}, compression = 30, shear = 20 }}");
        LAYUP.replace("young = 16\n", &format!("young = 16\n{limits}\n"))
    };
    let blade = |text: &str, more: &[&str]| {
        workplace.write("a.layup.toml", text);
        let command = ["blade", "a.layup.toml", "--out", "b", "--no-figures"];
        let stations = ["--stations", "0.7,0.72"];
        let run = workplace.run(&[&command[..], &stations, more].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        run.out
    };
    // from none to some, other ones, and none again
    let texts = [LAYUP.to_owned(), isotropic(20.0), isotropic(25.0)];
    assert!(blade(&texts[0], &[]).contains("2 solved"));
    for (i, text) in [&texts[1], &texts[2], &texts[0]].into_iter().enumerate() {
        let out = blade(text, &[]);
        assert!(out.contains("2 sections: 2 renewed"), "{i}: {out}");
        assert!(blade(text, &[]).contains("2 sections: 2 unchanged"));
        let sections = [
            "properties.json",
            "report.txt",
            "analysis.json",
            "warping.vtu",
        ];
        let sections = sections.map(|ending| format!("b/sections/eta_0.7000.{ending}"));
        let of_blade = ["b/a.span.csv", "b/a.blade.json"].map(str::to_owned);
        let files = [&sections[..], &of_blade].concat();
        let read = || files.iter().map(|file| workplace.read(file));
        let renewed: Vec<String> = read().collect();
        assert!(blade(text, &["--force"]).contains("2 solved"));
        for ((file, renewed), solved) in files.iter().zip(&renewed).zip(read()) {
            assert!(*renewed == solved, "{i} {file}");
        }
        let section = workplace.read("b/sections/eta_0.7000.section.toml");
        assert_eq!(section.contains("strength"), i < 2, "{i}");
    }
    let stiffer = texts[2].replace("young = 16", "young = 17");
    assert!(blade(&stiffer, &[]).contains("2 solved"));
}
