//! Circles of files that import each other.
//!
//! A file imports another if it uses a name that the other defines, also if a third file
//! re-exports the name. Two rules apply:
//!
//! 1. Without the imports that files take from modules above them, there is no circle.
//! 2. A circle with these imports has only one module and files below it.

use std::collections::{BTreeMap, BTreeSet};

use crate::source::{is_word, words};
use crate::tree::{File, Tree};

/// The crates to which the rules apply.
const HELD: [&str; 5] = [
    "shared-geom",
    "section-analyzer",
    "rotor-aero",
    "sparse-solver",
    "beam-dynamics",
];

/// Most re-exports between a name and the file that defines it.
const MOST_STEPS: usize = 16;

/// The circles of the crates in [`HELD`] that break a rule.
pub fn circles(tree: &Tree) -> Vec<String> {
    HELD.iter()
        .flat_map(|folder| Graph::of(tree, folder).forbidden())
        .collect()
}

/// The names of the modules from the root of the crate to a module.
type Module = Vec<String>;

/// The imports of one file.
struct Source {
    /// Path of the file.
    path: String,
    /// Names that its `use` lines bring into the module.
    taken: Vec<Taken>,
    /// Paths elsewhere in its code.
    written: Vec<Vec<String>>,
}

/// A name that a `use` line brings into a module.
struct Taken {
    /// The whole path.
    path: Vec<String>,
    /// The name in the module.
    name: String,
}

/// The target of a path.
enum Target {
    /// A module of the crate.
    Module(Module),
    /// A name, with the module that defines it.
    Name(Module, String),
    /// A name that this crate does not define.
    Outside,
}

/// The imports of a crate.
struct Graph {
    /// The files of the crate by their modules.
    sources: BTreeMap<Module, Source>,
    /// For each module that uses names of another, the names.
    arrows: BTreeMap<Module, BTreeMap<Module, BTreeSet<String>>>,
}

impl Graph {
    /// The imports of the crate in `folder`, without the imports for tests.
    fn of(tree: &Tree, folder: &str) -> Self {
        let folder = format!("{folder}/src");
        let files = tree.rust_below(&folder);
        let files = files.filter(|file| file.is_test.contains(&false));
        let sources = files.map(|file| (module_of(&file.path[folder.len() + 1..]), source(file)));
        let mut graph = Self {
            sources: sources.collect(),
            arrows: BTreeMap::new(),
        };
        let modules: Vec<Module> = graph.sources.keys().cloned().collect();
        for module in modules {
            let arrows = graph.arrows_from(&module);
            graph.arrows.insert(module, arrows);
        }
        graph
    }

    /// The names that `module` uses from other modules.
    fn arrows_from(&self, module: &Module) -> BTreeMap<Module, BTreeSet<String>> {
        let source = &self.sources[module];
        let taken = source.taken.iter().map(|taken| &taken.path);
        let mut arrows: BTreeMap<Module, BTreeSet<String>> = BTreeMap::new();
        for path in taken.chain(&source.written) {
            if let Target::Name(defining, name) = self.target(module, path, MOST_STEPS)
                && defining != *module
                && self.sources.contains_key(&defining)
            {
                arrows.entry(defining).or_default().insert(name);
            }
        }
        arrows
    }

    /// The target of a path in `module`.
    fn target(&self, module: &Module, path: &[String], steps: usize) -> Target {
        let mut at = module.clone();
        for (number, word) in path.iter().enumerate() {
            let is_last = number + 1 == path.len();
            match word.as_str() {
                "crate" => at.clear(),
                "self" => {}
                "super" => drop(at.pop()),
                _ => match self.member(&at, word, is_last, steps) {
                    Some(Target::Module(next)) => at = next,
                    Some(found) => return found,
                    None if number == 0 => return Target::Outside,
                    None => return Target::Name(at, word.clone()),
                },
            }
        }
        Target::Module(at)
    }

    /// The target of `name` if it is a module below `module` or a name that `module`
    /// imports; at the end of a path the name comes first.
    fn member(&self, module: &Module, name: &str, is_last: bool, steps: usize) -> Option<Target> {
        let mut below = module.clone();
        below.push(name.to_owned());
        let is_module = self.sources.contains_key(&below);
        let taken = self.sources.get(module).map(|source| &source.taken);
        let mut taken = taken.into_iter().flatten();
        match taken.find(|taken| taken.name == name) {
            Some(taken) if steps > 0 && (is_last || !is_module) => {
                Some(self.target(module, &taken.path, steps - 1))
            }
            _ => is_module.then_some(Target::Module(below)),
        }
    }

    /// The circles that the rules forbid, one message each.
    fn forbidden(&self) -> Vec<String> {
        let is_not_above = |from: &Module, to: &Module| !from.starts_with(to);
        let circles = self.circles(is_not_above);
        if !circles.is_empty() {
            let reported = circles
                .iter()
                .map(|circle| self.reported(circle, is_not_above));
            return reported.collect();
        }
        // the first of a circle is the shortest: the module that may hold the others
        let is_one_module =
            |circle: &[&Module]| circle.iter().all(|module| module.starts_with(circle[0]));
        let circles = self.circles(|_, _| true);
        let circles = circles.iter().filter(|circle| !is_one_module(circle));
        circles
            .map(|circle| self.reported(circle, |_, _| true))
            .collect()
    }

    /// The circles of the imports for which `counts` holds, each in the order of its
    /// modules.
    fn circles(&self, counts: impl Fn(&Module, &Module) -> bool) -> BTreeSet<Vec<&Module>> {
        let modules = self.arrows.keys();
        let reached: BTreeMap<&Module, BTreeSet<&Module>> = modules
            .map(|module| (module, self.reached(module, &counts)))
            .collect();
        let mut circles = BTreeSet::new();
        for (module, beyond) in &reached {
            if beyond.contains(module) {
                let returns = |other: &&Module| reached[*other].contains(module);
                circles.insert(beyond.iter().copied().filter(returns).collect());
            }
        }
        circles
    }

    /// The modules that `module` imports, directly or through others.
    fn reached<'a>(
        &'a self,
        module: &'a Module,
        counts: &impl Fn(&Module, &Module) -> bool,
    ) -> BTreeSet<&'a Module> {
        let mut reached = BTreeSet::new();
        let mut waiting = vec![module];
        while let Some(from) = waiting.pop() {
            let imported = self.arrows[from].keys().filter(|to| counts(from, to));
            waiting.extend(imported.filter(|to| reached.insert(*to)));
        }
        reached
    }

    /// The files of a circle, and the names that each uses from the others.
    fn reported(&self, circle: &[&Module], counts: impl Fn(&Module, &Module) -> bool) -> String {
        let path = |module: &Module| self.sources[module].path.as_str();
        let mut text = format!("{} files import each other in a circle:", circle.len());
        for from in circle {
            let arrows = self.arrows[*from].iter();
            for (to, names) in arrows.filter(|(to, _)| circle.contains(to) && counts(from, to)) {
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                let (from, to) = (path(from), path(to));
                text += &format!("\n    {from} takes from {to}: {}", names.join(", "));
            }
        }
        text
    }
}

/// The module of a file, from its path below `src`.
fn module_of(path: &str) -> Module {
    let path = path.trim_end_matches(".rs").trim_end_matches("/mod");
    match path {
        "lib" => Module::new(),
        _ => path.split('/').map(str::to_owned).collect(),
    }
}

/// The imports of a file, without the imports for tests.
fn source(file: &File) -> Source {
    let lines = file.code.lines().zip(&file.is_test);
    let lines: Vec<&str> = lines
        .map(|(line, is_test)| if *is_test { "" } else { line })
        .collect();
    let mut code = lines.join("\n");
    let mut taken = Vec::new();
    let starts: Vec<usize> = words(&code, "use").collect();
    for start in starts.into_iter().rev() {
        let start = start + "use".len();
        if code[start..].starts_with('<') {
            continue;
        }
        let end = code[start..].find(';').map_or(code.len(), |n| start + n);
        names_of(&[], &code[start..end], &mut taken);
        code.replace_range(start..end, "");
    }
    Source {
        path: file.path.clone(),
        taken,
        written: written(&code),
    }
}

/// Adds the names of one branch of a `use` line, with the path `before` it.
fn names_of(before: &[String], branch: &str, taken: &mut Vec<Taken>) {
    let (head, group) = match branch.split_once('{') {
        Some((head, group)) => (head, group.trim_end().strip_suffix('}')),
        None => (branch, None),
    };
    let (head, alias) = match head.split_once(" as ") {
        Some((head, alias)) => (head, Some(alias.trim())),
        None => (head, None),
    };
    let words = head
        .split("::")
        .map(str::trim)
        .filter(|word| !word.is_empty());
    let mut path = before.to_vec();
    path.extend(words.map(str::to_owned));
    if let Some(group) = group {
        for branch in branches(group) {
            names_of(&path, branch, taken);
        }
        return;
    }
    if path.len() > 1 && path.last().is_some_and(|word| word == "self") {
        path.pop();
    }
    if let Some(name) = alias.or(path.last().map(String::as_str)) {
        let name = name.to_owned();
        taken.push(Taken { path, name });
    }
}

/// The parts of a group, inner groups whole.
fn branches(group: &str) -> Vec<&str> {
    let mut depth = 0;
    let parts = group.split(|c| {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        c == ',' && depth == 0
    });
    parts.filter(|part| !part.trim().is_empty()).collect()
}

/// The paths of two words or more in code without `use` lines.
fn written(code: &str) -> Vec<Vec<String>> {
    let of_path = |c: char| is_word(c) || c == ':' || c == '$';
    let paths = code
        .split(|c| !of_path(c))
        .filter(|path| path.contains("::"));
    let paths = paths.map(|path| path.split("::").map(str::to_owned).collect());
    paths
        .filter(|path: &Vec<String>| path.iter().all(|word| word.chars().all(is_word)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The circles of a crate with these files, by their paths below `src`.
    fn found(files: &[(&str, &str)]) -> Vec<String> {
        let paths = files
            .iter()
            .map(|(path, _)| format!("{}/src/{path}", HELD[0]));
        let paths: Vec<String> = paths.collect();
        let texts = files.iter().map(|(_, text)| *text);
        let files: Vec<_> = paths.iter().map(String::as_str).zip(texts).collect();
        circles(&Tree::of(&files))
    }

    #[test]
    fn a_circle_is_reported_with_its_files_and_names() {
        let circles = found(&[
            ("lib.rs", "mod a;\nmod b;\nmod c;\n"),
            (
                "a.rs",
                "use crate::{b::{self, Cell as Box}, c};\nfn f() { b::open() }\n",
            ),
            ("b.rs", "fn g() { crate::c::Near::new() }\n"),
            ("c.rs", "use super::a::Axis;\nuse nalgebra::Matrix3;\n"),
            ("d.rs", "use crate::a::Axis;\n"),
        ]);
        let folder = HELD[0];
        let expected = format!(
            "3 files import each other in a circle:\n    \
             {folder}/src/a.rs takes from {folder}/src/b.rs: Cell, open\n    \
             {folder}/src/b.rs takes from {folder}/src/c.rs: Near\n    \
             {folder}/src/c.rs takes from {folder}/src/a.rs: Axis"
        );
        assert_eq!(circles, [expected]);
    }

    #[test]
    fn a_name_counts_for_the_file_that_defines_it() {
        let through = |parent: &str| {
            found(&[
                ("p.rs", parent),
                ("p/a.rs", "use super::Name;\n"),
                ("p/b.rs", "use super::a::f;\n"),
            ])
        };
        assert_eq!(through("mod a;\nmod b;\npub struct Name;\n").len(), 0);
        assert_eq!(through("mod a;\nmod b;\npub use b::Name;\n").len(), 1);
        assert_eq!(
            through("mod a;\nmod b;\nuse self::b::{Other, Name};\n").len(),
            1
        );
    }

    #[test]
    fn a_module_and_its_parts_may_use_each_other() {
        let parts = [
            (
                "p/mod.rs",
                "mod a;\nmod b;\npub use a::f;\npub struct Name;\n",
            ),
            ("p/a.rs", "use super::{Name, b::g};\n"),
            ("p/b.rs", "use crate::p::Name;\n"),
        ];
        assert_eq!(found(&parts).len(), 0);
    }

    #[test]
    fn a_circle_over_a_module_above_has_no_other_module() {
        let circles = |user: &str| {
            found(&[
                ("p.rs", "mod a;\nuse crate::q::Q;\npub struct Name;\n"),
                ("p/a.rs", "use super::Name;\n"),
                ("q.rs", user),
            ])
        };
        assert_eq!(circles("pub struct Q;\n").len(), 0);
        let reported = circles("use crate::p::a::f;\n");
        assert_eq!(reported.len(), 1);
        assert!(reported[0].contains("p/a.rs takes from"), "{}", reported[0]);
    }

    #[test]
    fn tests_comments_and_other_crates_are_free() {
        let test = "#[cfg(test)]\nmod tests {\n use crate::a::A;\n}\n// crate::a::A\n";
        let files = [
            ("a.rs", "use crate::b::B;\n"),
            ("b.rs", test),
            ("b_tests.rs", "use crate::a::A;\n"),
        ];
        assert_eq!(found(&files).len(), 0);
        let tree = Tree::of(&[
            ("other/src/a.rs", "use crate::b::B;\n"),
            ("other/src/b.rs", "use crate::a::A;\n"),
        ]);
        assert_eq!(circles(&tree).len(), 0);
    }
}
