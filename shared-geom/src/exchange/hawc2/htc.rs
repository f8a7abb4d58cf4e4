//! The parts of an htc file that describe a body: its st file and its line.
//!
//! `exit` ends a file; `continue_in_file` reads another one and returns.

use std::path::{Path, PathBuf};

use crate::document::read_text;
use crate::error::{SourceLocation, nearest_name, shortened};
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, lines, not_a_number, number};

/// Most files that one may include: files that name each other twice would multiply.
const MOST_FILES: usize = 100;
/// Most numbers of a statement of damping that are shown.
const MOST_FACTORS: usize = 8;
/// Most statements outside of all blocks that a remark names.
const OUTSIDE_SHOWN: usize = 3;

/// A file that is named somewhere.
#[derive(Debug, Clone)]
pub(super) struct Named {
    pub name: String,
    /// The file that names it, and the line.
    pub by: PathBuf,
    pub line: usize,
}

impl Named {
    /// Its path: HAWC2 runs in a folder above the folder of the htc file, and names are
    /// relative to it.
    pub fn find(&self) -> Option<PathBuf> {
        let name = self.name.trim_matches('"').replace('\\', "/");
        // The parent folders of a single file name come from its full path.
        let paths = [Some(self.by.clone()), self.by.canonicalize().ok()];
        let folders = paths.iter().flatten();
        let folders = folders.flat_map(|path| path.ancestors().skip(1).take(3));
        let mut candidates = folders.map(|folder| folder.join(&name));
        candidates.find(|candidate| candidate.is_file())
    }

    /// The problem that the file does not exist; `what` describes it.
    pub fn missing(&self, what: &str) -> ExchangeProblem {
        ExchangeProblem::Other {
            what: what.to_owned(),
            found: format!("no file \"{}\"", self.name),
            expected: "a file relative to the folder of the htc file or one of the two above"
                .to_owned(),
            help: "correct the name, or put the file there".to_owned(),
        }
    }
}

/// A body with properties and a line.
#[derive(Debug, Clone, Default)]
pub(super) struct Body {
    pub name: String,
    /// The st file.
    pub st_file: Option<Named>,
    /// Numbers of set and sub-set, and their line.
    pub set: Option<(usize, usize, usize)>,
    pub is_full: bool,
    /// Points of `c2_def`: x, y, z [m] and twist [deg].
    pub points: Vec<[f64; 4]>,
    /// Points that `nsec` announces, and its file and line.
    announced: Option<(usize, PathBuf, usize)>,
    /// Mass factors [1/s] and stiffness factors [s] of the damping.
    pub damping: Option<[f64; 6]>,
    /// Other statements of damping, with their numbers as text.
    pub other_damping: Vec<String>,
    pub masses: usize,
}

impl Body {
    fn is_complete(&self) -> bool {
        self.st_file.is_some() && !self.points.is_empty()
    }
}

/// Whether `text` looks like an htc file, or a part of one, with a body or the name of
/// another file.
pub(super) fn recognize(text: &str) -> bool {
    let has = |first: &str, second: &str| {
        let mut statements = text.lines().map(words);
        statements.any(|words| {
            let word = |i: usize| words.get(i).copied().unwrap_or_default();
            let is_second = second.is_empty() || word(1).eq_ignore_ascii_case(second);
            word(0).eq_ignore_ascii_case(first) && is_second
        })
    };
    let begins = |name: &str| has("begin", name);
    has("continue_in_file", "")
        || begins("main_body") && (begins("timoschenko_input") || begins("c2_def"))
}

/// Words of a statement, which a semicolon ends.
fn words(line: &str) -> Vec<&str> {
    let code = line.split(';').next().unwrap_or_default();
    code.split_whitespace().collect()
}

/// The body of the `wanted` name, or the blade: the first one whose name begins with "blade", else the only
/// one; and the texts of all files that were read. Notes problems; remarks name the other
/// bodies.
pub(super) fn body(
    text: &str,
    (file, wanted): (&Path, Option<&str>),
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> (Option<Body>, Vec<String>) {
    let mut reader = Reader::default();
    reader.file(text, file, problems);
    remarks.extend(reader.outside());
    let texts = std::mem::take(&mut reader.texts);
    let bodies = reader.finish(problems);
    let body = bodies.and_then(|bodies| chosen(bodies, wanted, remarks, problems));
    (body, texts)
}

fn chosen(
    bodies: Vec<Body>,
    wanted: Option<&str>,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<Body> {
    let bodies: Vec<_> = bodies.into_iter().filter(Body::is_complete).collect();
    let is_it = |body: &&Body| match wanted {
        Some(name) => body.name.eq_ignore_ascii_case(name),
        None => body.name.to_lowercase().starts_with("blade"),
    };
    let only = || {
        bodies
            .first()
            .filter(|_| wanted.is_none() && bodies.len() == 1)
    };
    let Some(body) = bodies.iter().find(is_it).or_else(only) else {
        let names: Vec<_> = bodies.iter().map(|body| body.name.as_str()).collect();
        problems.push(0, &not_found(wanted, &names));
        return None;
    };
    if bodies.len() > 1 {
        let others = bodies.iter().map(|body| body.name.as_str());
        let others: Vec<_> = others.filter(|name| *name != body.name).collect();
        remarks.push(format!(
            "main_body \"{}\" is read; not {}",
            body.name,
            others.join(", ")
        ));
    }
    if let Some((announced, file, line)) = &body.announced
        && *announced != body.points.len()
    {
        let problem = ExchangeProblem::CutShort {
            what: format!(
                "c2_def of \"{}\", after {} sections",
                body.name,
                body.points.len()
            ),
            expected: format!("{announced}, as nsec announces"),
        };
        problems.turn_to(file);
        problems.push(*line, &problem);
        return None;
    }
    Some(body.clone())
}

fn not_found(wanted: Option<&str>, names: &[&str]) -> ExchangeProblem {
    let found = match names {
        [] => "no main_body with timoschenko_input and c2_def".to_owned(),
        _ => names.join(", "),
    };
    match wanted {
        Some(name) => ExchangeProblem::Other {
            what: format!("the body \"{name}\" among the bodies of the file"),
            found,
            expected: "the name of one of these main_body".to_owned(),
            help: "correct the name of the body".to_owned(),
        },
        None => ExchangeProblem::Other {
            what: "the blade among the bodies of the file".to_owned(),
            found,
            expected: "a main_body whose name begins with \"blade\"".to_owned(),
            help: "give the name of the body in the model (body = \"NAME\"), or keep the main_body of the \
                   blade alone in the file"
                .to_owned(),
        },
    }
}

/// State of the reader.
#[derive(Default)]
struct Reader {
    /// The files that are being read, each named by the one before.
    files: Vec<PathBuf>,
    /// Texts of all files so far.
    texts: Vec<String>,
    /// Names of the open blocks, lower case, and their beginnings: file and line.
    blocks: Vec<(String, PathBuf, usize)>,
    bodies: Vec<Body>,
    /// Statements outside of all blocks, and their locations.
    outside: Vec<(String, SourceLocation)>,
    is_wrong: bool,
}

impl Reader {
    /// Reads a file up to its end, or to `exit`.
    fn file(&mut self, text: &str, path: &Path, problems: &mut Problems) {
        self.texts.push(text.to_owned());
        self.files.push(path.to_owned());
        problems.turn_to(path);
        for line in lines(text) {
            let words = words(line.text);
            let Some((first, rest)) = words.split_first() else {
                continue;
            };
            let key = first.to_lowercase();
            if key == "exit" {
                break;
            }
            self.is_wrong |= self.take(&key, &line, rest, problems).is_none();
        }
        self.files.pop();
    }

    /// Processes a statement; `None` if it is wrong.
    fn take(
        &mut self,
        key: &str,
        line: &Line<'_>,
        rest: &[&str],
        problems: &mut Problems,
    ) -> Option<()> {
        let file = self.files.last().cloned().unwrap_or_default();
        match key {
            "begin" => {
                let name = rest.first().copied().unwrap_or_default().to_lowercase();
                if name == "main_body" {
                    self.bodies.push(Body::default());
                }
                self.blocks.push((name, file, line.number));
                Some(())
            }
            "end" => self.end(line, rest, problems),
            "continue_in_file" => {
                let (name, by) = (rest.join(" "), file);
                let line = line.number;
                self.go_on(&Named { name, by, line }, problems)
            }
            key => self.statement(key, line, rest, problems),
        }
    }

    /// Reads the file that `continue_in_file` names.
    fn go_on(&mut self, named: &Named, problems: &mut Problems) -> Option<()> {
        let what = "the file of continue_in_file";
        let Some(path) = named.find() else {
            problems.push(named.line, &named.missing(what));
            return None;
        };
        let same = |other: &PathBuf| match (other.canonicalize(), path.canonicalize()) {
            (Ok(other), Ok(path)) => other == path,
            _ => *other == path,
        };
        let found = match self.files.iter().any(same) {
            true => format!("\"{}\", which is being read", named.name),
            false if self.texts.len() == MOST_FILES => format!("more than {MOST_FILES} files"),
            false => {
                let text = problems.keep(read_text(&path))?;
                self.file(&text, &path, problems);
                problems.turn_to(&named.by);
                return Some(());
            }
        };
        let problem = ExchangeProblem::Other {
            what: what.to_owned(),
            found,
            expected: "files that do not lead back to themselves".to_owned(),
            help: "remove the statement".to_owned(),
        };
        problems.push(named.line, &problem);
        None
    }

    /// Remark on statements outside of all blocks.
    fn outside(&self) -> Option<String> {
        let shown = self.outside.iter().take(OUTSIDE_SHOWN);
        let shown: Vec<_> = shown
            .map(|(key, location)| format!("\"{}\" ({location})", shortened(key)))
            .collect();
        let more = match self.outside.len() - shown.len() {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        (!shown.is_empty()).then(|| {
            format!(
                "statements outside of all blocks are not read: {}{more}",
                shown.join(", ")
            )
        })
    }

    /// All bodies; `None` if something is wrong.
    fn finish(self, problems: &mut Problems) -> Option<Vec<Body>> {
        if let Some((name, file, line)) = self.blocks.last() {
            let problem = ExchangeProblem::CutShort {
                what: format!("the block \"{name}\""),
                expected: format!("\"end {name}\""),
            };
            problems.turn_to(file);
            problems.push(*line, &problem);
            return None;
        }
        (!self.is_wrong).then_some(self.bodies)
    }

    fn end(&mut self, line: &Line<'_>, rest: &[&str], problems: &mut Problems) -> Option<()> {
        let name = rest.first().copied().unwrap_or_default().to_lowercase();
        let open = self.blocks.pop();
        if open.as_ref().is_some_and(|(open, ..)| *open == name) {
            return Some(());
        }
        let expected = match open {
            Some((open, _, at)) => format!("\"end {open}\", since line {at} begins it"),
            None => "no end, since no block is open".to_owned(),
        };
        problems.push(
            line.number,
            &ExchangeProblem::Other {
                what: "the end of a block".to_owned(),
                found: format!("\"end {}\"", shortened(&name)),
                expected,
                help: "every begin needs its end, in the reverse order".to_owned(),
            },
        );
        None
    }

    /// Processes a statement of a block; `None` if it is wrong.
    fn statement(
        &mut self,
        key: &str,
        line: &Line<'_>,
        rest: &[&str],
        problems: &mut Problems,
    ) -> Option<()> {
        let file = self.files.last().cloned().unwrap_or_default();
        let Some((block, ..)) = self.blocks.last() else {
            let location = SourceLocation::line(file.display().to_string(), line.number);
            self.outside.push((key.to_owned(), location));
            return Some(());
        };
        let block = block.as_str();
        let Some(body) = self.bodies.last_mut() else {
            return Some(());
        };
        let at = line.number;
        match (block, key) {
            ("main_body", "name") => body.name = rest.first().copied().unwrap_or("body").to_owned(),
            ("main_body", "concentrated_mass") => body.masses += 1,
            ("main_body", "damping_posdef") => {
                body.damping = Some(numbers("damping_posdef", at, rest, problems)?);
            }
            ("main_body", other) if other.starts_with("damping") => {
                let statement = [&[other], &rest[..rest.len().min(MOST_FACTORS)]].concat();
                body.other_damping.push(statement.join(" "));
            }
            ("timoschenko_input", "filename") => {
                let (name, by) = (rest.join(" "), file);
                body.st_file = Some(Named { name, by, line: at });
            }
            ("timoschenko_input", "fpm") => body.is_full = rest.first() == Some(&"1"),
            ("timoschenko_input", "set") => {
                let [set, sub_set] = wholes("set", at, rest, problems)?;
                body.set = Some((set, sub_set, at));
            }
            ("c2_def", "nsec") => {
                let [count] = wholes("nsec", at, rest, problems)?;
                body.announced = Some((count, file, at));
            }
            ("c2_def", "sec") => {
                let [_, x, y, z, twist] = numbers("sec", at, rest, problems)?;
                body.points.push([x, y, z, twist]);
            }
            ("c2_def" | "timoschenko_input", other) => {
                return unknown(block, other, at, problems);
            }
            _ => {}
        }
        Some(())
    }
}

/// Notes a statement that looks like a known one.
fn unknown(block: &str, key: &str, line: usize, problems: &mut Problems) -> Option<()> {
    let known: &[&str] = match block {
        "c2_def" => &["nsec", "sec"],
        _ => &["filename", "fpm", "set"],
    };
    let near = nearest_name(key, known.iter().copied());
    let Some(near) = near else {
        return Some(());
    };
    problems.push(
        line,
        &ExchangeProblem::Other {
            what: format!("a statement of {block}"),
            found: format!("\"{}\"", shortened(key)),
            expected: format!("one of {}", known.join(", ")),
            help: format!("did you mean \"{near}\"?"),
        },
    );
    None
}

/// Exactly `N` numbers after a key; more may follow as a comment.
fn numbers<const N: usize>(
    what: &str,
    line: usize,
    words: &[&str],
    problems: &mut Problems,
) -> Option<[f64; N]> {
    let mut values = [0.0; N];
    if words.len() < N {
        let (what, found) = (format!("the statement {what}"), words.len());
        let problem = ExchangeProblem::Count {
            what,
            expected: N,
            found,
            separator: "blanks",
        };
        problems.push(line, &problem);
        return None;
    }
    let mut good = true;
    for (value, word) in values.iter_mut().zip(words) {
        match number(word) {
            Some(found) => *value = found,
            None => {
                problems.push(line, &not_a_number(&format!("the statement {what}"), word));
                good = false;
            }
        }
    }
    good.then_some(values)
}

/// Exactly `N` whole numbers after a key.
fn wholes<const N: usize>(
    what: &str,
    line: usize,
    words: &[&str],
    problems: &mut Problems,
) -> Option<[usize; N]> {
    let values: [f64; N] = numbers(what, line, words, problems)?;
    let mut whole = [0; N];
    for ((whole, value), word) in whole.iter_mut().zip(values).zip(words) {
        match word.parse() {
            Ok(found) => *whole = found,
            Err(_) => {
                problems.push(
                    line,
                    &ExchangeProblem::Other {
                        what: format!("the statement {what}"),
                        found: value.to_string(),
                        expected: "a whole number".to_owned(),
                        help: format!("write {what} 1 1"),
                    },
                );
                return None;
            }
        }
    }
    Some(whole)
}
