//! Permitted imports.

use crate::source::{is_word, line_of, words};
use crate::tree::{File, Tree};

/// The stages of a crate, in the order of the flow.
pub struct Stages {
    /// Folder of the crate.
    pub folder: &'static str,
    /// Top-level modules: each may import only those before it.
    pub order: &'static [&'static str],
}

/// The order of the stages, one entry per program. A stage that the tree does not have
/// yet is ignored; a module missing in the order is a breach.
pub const CRATES: [Stages; 4] = [
    Stages {
        folder: "section-analyzer",
        order: &[
            "failure",
            "material",
            "mesh",
            "section",
            "element",
            "assembly",
            "solve",
            "properties",
            "solution",
            "sensitivity",
            "recovery",
            "input",
            "output",
        ],
    },
    Stages {
        folder: "rotor-aero",
        order: &[
            "real", "airfoil", "unsteady", "momentum", "wake", "inflow", "wind", "strip", "rotor",
        ],
    },
    Stages {
        folder: "sparse-solver",
        order: &[
            "pattern",
            "number",
            "scales",
            "lu",
            "general",
            "linear",
            "step",
            "newton",
            "gmres",
            "cholesky",
            "dense",
            "descriptor",
            "arnoldi",
        ],
    },
    Stages {
        folder: "beam-dynamics",
        order: &[
            "model",
            "elements",
            "assembly",
            "solver",
            "integrator",
            "case",
            "result",
            "modes",
            "input",
            "output",
        ],
    },
];

/// Modules that may import every stage and that no stage may import.
const ABOVE: [&str; 4] = ["analysis", "cli", "main", "lib"];

/// Modules that every stage may import: the errors of the crate.
const BELOW: [&str; 1] = ["error"];

/// Crates that must not name each other, nor the drawing library, which figures hide.
const APART: [(&str, &[&str]); 5] = [
    (
        "section-analyzer",
        &["beam-dynamics", "rotor-aero", "plotters"],
    ),
    (
        "rotor-aero",
        &["beam-dynamics", "section-analyzer", "plotters"],
    ),
    (
        "sparse-solver",
        &[
            "beam-dynamics",
            "section-analyzer",
            "rotor-aero",
            "shared-geom",
            "plotters",
        ],
    ),
    ("beam-dynamics", &["section-analyzer", "plotters"]),
    (
        "shared-geom",
        &[
            "section-analyzer",
            "beam-dynamics",
            "rotor-aero",
            "sparse-solver",
        ],
    ),
];

/// Breaches of the order of the stages.
pub fn order(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for stages in &CRATES {
        let folder = format!("{}/src", stages.folder);
        for file in tree.rust_below(&folder) {
            let module = module_path(&file.path[folder.len() + 1..]);
            check_file(stages, file, &module, &mut breaches);
        }
    }
    breaches
}

fn check_file(stages: &Stages, file: &File, module: &[&str], breaches: &mut Vec<String>) {
    let own = module[0];
    if ABOVE.contains(&own) {
        return;
    }
    let rank = |name: &str| stages.order.iter().position(|stage| *stage == name);
    let own_rank = rank(own);
    if own_rank.is_none() && !BELOW.contains(&own) {
        let message = format!("module \"{own}\" is not in the order of the stages in tests/tidy");
        breaches.push(file.breach(0, &message));
        return;
    }
    for (line, target) in imported(file, module) {
        let allowed = target == own || BELOW.contains(&target) || rank(target) < own_rank;
        if file.is_test[line] || (allowed && (rank(target).is_some() || BELOW.contains(&target))) {
            continue;
        }
        let reason = match (ABOVE.contains(&target), rank(target)) {
            (true, _) => "which no stage may import",
            (false, Some(_)) => "which comes after it in the flow",
            (false, None) => "which is not a stage: name the module that defines it",
        };
        breaches.push(file.breach(line, &format!("\"{own}\" imports \"{target}\", {reason}")));
    }
}

/// The modules on the path to a file, from its path below `src`.
fn module_path(path: &str) -> Vec<&str> {
    let mut module: Vec<&str> = path.trim_end_matches(".rs").split('/').collect();
    if module.len() > 1 && module.last() == Some(&"mod") {
        module.pop();
    }
    module
}

/// Top-level names that the file uses through `crate::` or `super::` paths, with their
/// lines.
fn imported<'a>(file: &'a File, module: &[&str]) -> Vec<(usize, &'a str)> {
    let code = file.code.as_str();
    let mut found = Vec::new();
    for at in words(code, "crate").filter(|at| !code[..*at].ends_with('$')) {
        take(code, at + "crate".len(), &mut found);
    }
    for at in words(code, "super").filter(|at| !code[..*at].ends_with("super::")) {
        let mut depth = 0;
        let mut end = at;
        while let Some(rest) = code[end..].strip_prefix("super") {
            depth += 1;
            end = code.len() - rest.len();
            if rest.starts_with("::super") {
                end += 2;
            }
        }
        if depth >= module.len() {
            take(code, end, &mut found);
        }
    }
    found
}

/// The names after the path that ends at byte `at`: one, or a brace group.
fn take<'a>(code: &'a str, at: usize, found: &mut Vec<(usize, &'a str)>) {
    let Some(rest) = code[at..].strip_prefix("::") else {
        return;
    };
    let start = code.len() - rest.len();
    if !rest.starts_with('{') {
        let name = leading_word(rest);
        if !name.is_empty() {
            found.push((line_of(code, start), name));
        }
        return;
    }
    let (mut depth, mut expects_name) = (0, false);
    for (offset, c) in rest.char_indices() {
        match c {
            '{' => (depth, expects_name) = (depth + 1, depth == 0),
            '}' => depth -= 1,
            ',' => expects_name = depth == 1,
            _ if expects_name && is_word(c) => {
                let name = leading_word(&rest[offset..]);
                found.push((line_of(code, start + offset), name));
                expects_name = false;
            }
            _ => {}
        }
        if depth == 0 {
            return;
        }
    }
}

fn leading_word(text: &str) -> &str {
    let end = text.find(|c: char| !is_word(c)).unwrap_or(text.len());
    &text[..end]
}

/// Breaches of the separation of the programs: in sources and in manifests.
pub fn separation(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for (folder, others) in APART {
        for other in others {
            let name = other.replace('-', "_");
            let message = format!("\"{folder}\" must not use \"{other}\"");
            for file in tree.rust_below(folder) {
                let uses = words(&file.code, &name);
                breaches.extend(uses.map(|at| file.breach(line_of(&file.code, at), &message)));
            }
            if let Some(manifest) = tree.file(&format!("{folder}/Cargo.toml")) {
                let lines = manifest.text.lines().enumerate();
                let named = lines.filter(|(_, text)| text.starts_with(other));
                breaches.extend(named.map(|(line, _)| manifest.breach(line, &message)));
            }
        }
    }
    breaches
}

#[cfg(test)]
mod tests {
    use super::*;

    fn breaches(path: &str, text: &str) -> usize {
        order(&Tree::of(&[(path, text)])).len()
    }

    #[test]
    fn a_stage_may_look_back_but_not_ahead() {
        let path = "section-analyzer/src/element/strain.rs";
        assert_eq!(
            breaches(path, "use crate::mesh::Cell;\nuse super::Block;\n"),
            0
        );
        assert_eq!(breaches(path, "use crate::assembly::Blocks;\n"), 1);
        assert_eq!(breaches(path, "use super::super::solve::factor;\n"), 1);
        assert_eq!(
            breaches(path, "use crate::{mesh::{Cell, Node}, output};\n"),
            1
        );
        assert_eq!(breaches(path, "fn a() { crate::analysis::run() }\n"), 1);
        assert_eq!(breaches(path, "use crate::error::Problem;\n"), 0);
        assert_eq!(breaches(path, "use crate::Reexported;\n"), 1);
    }

    #[test]
    fn tests_comments_and_the_analysis_are_free() {
        let path = "beam-dynamics/src/model.rs";
        assert_eq!(breaches(path, "// crate::output\n"), 0);
        assert_eq!(
            breaches(
                path,
                "#[cfg(test)]\nmod tests {\n use crate::output::A;\n}\n"
            ),
            0
        );
        assert_eq!(
            breaches("beam-dynamics/src/analysis.rs", "use crate::output::A;\n"),
            0
        );
    }

    #[test]
    fn a_module_out_of_the_order_is_reported() {
        assert_eq!(breaches("beam-dynamics/src/helper.rs", ""), 1);
    }

    #[test]
    fn a_module_file_reaches_its_crate_by_one_super() {
        assert_eq!(
            breaches("beam-dynamics/src/model/mod.rs", "use super::output::A;\n"),
            1
        );
        assert_eq!(
            breaches("beam-dynamics/src/model.rs", "use super::output::A;\n"),
            1
        );
    }

    #[test]
    fn the_programs_stay_apart() {
        let tree = Tree::of(&[
            ("section-analyzer/src/cli.rs", "use beam_dynamics::run;\n"),
            ("shared-geom/Cargo.toml", "beam-dynamics.workspace = true\n"),
        ]);
        assert_eq!(separation(&tree).len(), 2);
    }
}
