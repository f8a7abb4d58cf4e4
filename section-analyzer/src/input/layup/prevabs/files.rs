//! The files of a section, and their elements with file and line.

use std::path::{Path, PathBuf};

use roxmltree::{Document, Node, NodeId, ParsingOptions};
use shared_geom::document::read_text;
use shared_geom::error::{nearest_name, quoted, shortened};
use shared_geom::exchange::problem::{ExchangeProblem, Problems};
use shared_geom::exchange::text::number;

/// Largest number of elements, texts and attributes of a file.
const LARGEST: u32 = 2_000_000;
/// The kinds of included files, and the roots of their elements.
const INCLUDED: [[&str; 2]; 3] = [
    ["baseline", "baselines"],
    ["layup", "layups"],
    ["material", "materials"],
];

/// Problems, and remarks on choices.
#[derive(Debug)]
pub(super) struct Notes {
    pub problems: Problems,
    pub remarks: Vec<String>,
}

impl Notes {
    pub fn new(path: &Path) -> Self {
        Self {
            problems: Problems::new(&path.display().to_string()),
            remarks: Vec::new(),
        }
    }

    /// Remarks that an element with a name takes the place of an earlier one.
    pub fn again(&mut self, at: Element<'_>, is_again: bool) {
        if is_again {
            self.remarks.push(format!(
                "{} is defined twice, and the second one is used",
                at.shown()
            ));
        }
    }

    /// Notes a problem at an element: its name, the value found, the expected one, and the remedy.
    pub fn wrong(&mut self, at: Element<'_>, [what, found, expected, help]: [&str; 4]) {
        self.wrong_on(at.file, at.line(), [what, found, expected, help]);
    }

    /// As [`Notes::wrong`], on a line of a file.
    pub fn wrong_on(&mut self, file: &Path, line: usize, texts: [&str; 4]) {
        let [what, found, expected, help] = texts.map(str::to_owned);
        let problem = ExchangeProblem::Other {
            what,
            found,
            expected,
            help,
        };
        self.problems.turn_to(file);
        self.problems.push(line, &problem);
    }

    /// Notes a name that is none of the known ones.
    pub fn unknown(&mut self, at: Element<'_>, [what, found]: [&str; 2], known: &[&str]) {
        let help = match nearest_name(found, known.iter().copied()) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None if known.is_empty() => "none is defined in the files".to_owned(),
            None => {
                let shown = &known[..known.len().min(12)];
                format!("there are {}", quoted(shown))
            }
        };
        let found = format!("\"{}\"", shortened(found));
        self.wrong(at, [what, &found, "a name of the files", &help]);
    }
}

/// An element of a file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element<'x> {
    node: Node<'x, 'x>,
    pub file: &'x Path,
}

impl<'x> Element<'x> {
    /// Its id in the document.
    pub fn id(&self) -> NodeId {
        self.node.id()
    }

    pub fn name(&self) -> &'x str {
        self.node.tag_name().name()
    }

    /// Its line, counted from one.
    pub fn line(&self) -> usize {
        let document = self.node.document();
        document.text_pos_at(self.node.range().start).row as usize
    }

    /// Its text without the blanks around it; comments inside are left out.
    pub fn text(&self) -> String {
        let texts = self.node.children().filter(Node::is_text);
        let all: String = texts.filter_map(|part| part.text()).collect();
        all.trim().to_owned()
    }

    /// An attribute without the blanks around it.
    pub fn attribute(&self, name: &str) -> Option<&'x str> {
        self.node.attribute(name).map(str::trim)
    }

    /// The names of its attributes.
    pub fn attributes(&self) -> Vec<&'x str> {
        self.node.attributes().map(|one| one.name()).collect()
    }

    /// Its elements.
    pub fn children(&self) -> impl Iterator<Item = Self> + use<'x> {
        let file = self.file;
        let elements = self.node.children().filter(Node::is_element);
        elements.map(move |node| Self { node, file })
    }

    /// Its elements of a name.
    pub fn named(&self, name: &str) -> impl Iterator<Item = Self> + use<'x> {
        let name = name.to_owned();
        self.children().filter(move |one| one.name() == name)
    }

    /// Its first element of a name.
    pub fn child(&self, name: &str) -> Option<Self> {
        self.named(name).next()
    }

    /// The element in which it is.
    pub fn parent(&self) -> Option<Self> {
        let node = self.node.parent_element()?;
        Some(Self { node, ..*self })
    }

    /// All elements below it, and itself.
    pub fn all(&self) -> impl Iterator<Item = Self> + use<'x> {
        let file = self.file;
        let elements = self.node.descendants().filter(Node::is_element);
        elements.map(move |node| Self { node, file })
    }

    /// The element and its name for messages.
    pub fn shown(&self) -> String {
        match self.attribute("name") {
            Some(name) => format!("<{}> \"{}\"", self.name(), shortened(name)),
            None => format!("<{}>", self.name()),
        }
    }

    /// The text of a required element; notes an absent or empty one.
    pub fn required(&self, name: &str, notes: &mut Notes) -> Option<(Self, String)> {
        let found = self.child(name).map(|one| (one, one.text()));
        let found = found.filter(|one| !one.1.is_empty());
        if found.is_none() {
            let expected = format!("<{name}> with its value");
            let help = format!("write <{name}>...</{name}> in it");
            notes.wrong(*self, [&self.shown(), "no value", &expected, &help]);
        }
        found
    }

    /// The name of the element; notes an absent one.
    pub fn required_name(&self, notes: &mut Notes) -> Option<&'x str> {
        let name = self.attribute("name").filter(|name| !name.is_empty());
        if name.is_none() {
            let help = "give it a name of its own";
            notes.wrong(*self, [&self.shown(), "no name", "name=\"...\"", help]);
        }
        name
    }

    /// The numbers of its text, `N` of them; notes others.
    pub fn numbers<const N: usize>(&self, notes: &mut Notes) -> Option<[f64; N]> {
        let text = self.text();
        let words = text.split(|letter: char| letter == ',' || letter.is_whitespace());
        let words = words.filter(|word| !word.is_empty());
        let values: Option<Vec<f64>> = words.map(number).collect();
        let values = values.and_then(|list| <[f64; N]>::try_from(list).ok());
        if values.is_none() {
            let found = format!("\"{}\"", shortened(&text));
            let expected = match N {
                1 => "a number".to_owned(),
                _ => format!("{N} numbers"),
            };
            let help = "numbers are separated by blanks";
            notes.wrong(*self, [&self.shown(), &found, &expected, help]);
        }
        values
    }
}

/// The texts of the files of a section, the main file last.
#[derive(Debug)]
pub(super) struct Files {
    all: Vec<(PathBuf, String, &'static str)>,
}

impl Files {
    /// The main file and the files that it includes; notes problems.
    pub fn load(text: &str, path: &Path, notes: &mut Notes) -> Option<Self> {
        let mut all = Vec::new();
        let document = parsed(text, path, notes)?;
        let root = Element {
            node: document.root_element(),
            file: path,
        };
        let mut is_complete = true;
        for include in root.named("include").flat_map(|include| include.children()) {
            let Some([_, content]) = INCLUDED.iter().find(|one| one[0] == include.name()) else {
                continue;
            };
            let name = include.text();
            if name.is_empty() {
                continue;
            }
            let mut file = path.with_file_name(&name);
            if !file.is_file() {
                file = path.with_file_name(format!("{name}.xml"));
            }
            notes.problems.turn_to(path);
            let what = format!("<{}> of <include>", include.name());
            let read = if notes.problems.finds(&file, &what, &name, include.line()) {
                notes.problems.keep(read_text(&file))
            } else {
                None
            };
            match read {
                Some(text) => all.push((file, text, *content)),
                None => is_complete = false,
            }
        }
        all.push((path.to_owned(), text.to_owned(), "cross_section"));
        is_complete.then_some(Self { all })
    }

    /// Calls `then` with the root of the main file and the roots of all files.
    pub fn parsed<T>(
        &self,
        notes: &mut Notes,
        then: impl for<'x> FnOnce(Element<'x>, &[Element<'x>], &mut Notes) -> Option<T>,
    ) -> Option<T> {
        let documents = self.all.iter();
        let documents = documents.map(|(path, text, _)| parsed(text, path, notes));
        let documents: Vec<Option<Document<'_>>> = documents.collect();
        let documents: Option<Vec<Document<'_>>> = documents.into_iter().collect();
        let documents = documents?;
        let mut roots = Vec::new();
        let mut is_complete = true;
        for (document, (file, _, content)) in documents.iter().zip(&self.all) {
            let node = document.root_element();
            let root = Element {
                node,
                file: file.as_path(),
            };
            let is_main = *content == "cross_section" && root.name() == "sg";
            if root.name() != *content && !is_main {
                let found = format!("<{}>", root.name());
                let expected = format!("<{content}>");
                let help = "compare the names of the files in <include>";
                notes.wrong(root, ["the first element", &found, &expected, help]);
                is_complete = false;
            }
            roots.push(root);
        }
        let main = *roots.last().filter(|_| is_complete)?;
        then(main, &roots, notes)
    }
}

/// The document of a text; notes a text that is no XML, and one with declarations of entities.
fn parsed<'t>(text: &'t str, path: &Path, notes: &mut Notes) -> Option<Document<'t>> {
    let text = text.trim_start_matches('\u{feff}');
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: LARGEST,
        ..ParsingOptions::default()
    };
    let problem = match Document::parse_with_options(text, options) {
        Ok(document) => return Some(document),
        Err(problem) => problem,
    };
    let found = shortened(&problem.to_string());
    let help = "the file may have been cut off, or a tag is not closed; declarations (<!DOCTYPE>) \
                are not read";
    let line = problem.pos().row as usize;
    notes.wrong_on(path, line, ["the text", &found, "XML", help]);
    None
}

/// The elements of a name in files of their own and in the main file.
pub(super) fn parts<'x>(all: &[Element<'x>], name: &str) -> Vec<Element<'x>> {
    let of = |root: &Element<'x>| {
        if root.name() == name {
            vec![*root]
        } else {
            root.named(name).collect()
        }
    };
    all.iter().flat_map(of).collect()
}

/// A word of a list; notes others.
pub(super) fn word(
    at: Element<'_>,
    what: &str,
    text: &str,
    known: &[&str],
    notes: &mut Notes,
) -> Option<usize> {
    let text = text.trim().to_lowercase();
    let found = known.iter().position(|known| *known == text);
    if found.is_none() {
        let shown = format!("\"{}\"", shortened(&text));
        let expected = known.join(" or ");
        notes.wrong(at, [what, &shown, &expected, "correct the word"]);
    }
    found
}

/// Whether a text is a true word or 1; notes others.
pub(super) fn is_true(at: Element<'_>, notes: &mut Notes) -> Option<bool> {
    let text = at.text();
    if number(&text).is_some() {
        return Some(number(&text) != Some(0.0));
    }
    let found = word(
        at,
        &at.shown(),
        &text,
        &["", "false", "no", "true", "yes"],
        notes,
    )?;
    Some(found > 2)
}
