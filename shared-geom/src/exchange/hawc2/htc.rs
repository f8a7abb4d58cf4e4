//! The parts of an htc file that describe a body: its st file and its line.

use crate::error::nearest_name;
use crate::exchange::problem::{ExchangeProblem, Problems, shortened};
use crate::exchange::text::{Line, lines, not_a_number, number};

/// A body with properties and a line.
#[derive(Debug, Clone, Default)]
pub(super) struct Body {
    pub name: String,
    /// The st file as named, and the line that names it.
    pub st_file: Option<(String, usize)>,
    /// Numbers of set and sub-set, and their line.
    pub set: Option<(usize, usize, usize)>,
    pub is_full: bool,
    /// Points of `c2_def`: x, y, z [m] and twist [deg].
    pub points: Vec<[f64; 4]>,
    /// Points that `nsec` announces, and its line.
    announced: Option<(usize, usize)>,
    /// Mass factors [1/s] and stiffness factors [s] of the damping.
    pub damping: Option<[f64; 6]>,
    pub masses: usize,
}

impl Body {
    fn is_complete(&self) -> bool {
        self.st_file.is_some() && !self.points.is_empty()
    }
}

/// Whether `text` looks like an htc file, or a part of one, with a body.
pub(super) fn recognize(text: &str) -> bool {
    let begins = |name: &str| {
        let mut statements = text.lines().map(words);
        statements.any(|words| {
            let word = |i: usize| words.get(i).copied().unwrap_or_default();
            word(0).eq_ignore_ascii_case("begin") && word(1).eq_ignore_ascii_case(name)
        })
    };
    begins("main_body") && (begins("timoschenko_input") || begins("c2_def"))
}

/// Words of a statement, which a semicolon ends.
fn words(line: &str) -> Vec<&str> {
    let code = line.split(';').next().unwrap_or_default();
    code.split_whitespace().collect()
}

/// The body that is the blade: the first one whose name begins so, else the only one.
/// Notes what is wrong with it; remarks tell of the others.
pub(super) fn blade(
    text: &str,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<Body> {
    let bodies: Vec<_> = bodies(text, problems)?
        .into_iter()
        .filter(Body::is_complete)
        .collect();
    let is_blade = |body: &&Body| body.name.to_lowercase().starts_with("blade");
    let body = bodies.iter().find(is_blade);
    let body = body.or(if bodies.len() == 1 {
        bodies.first()
    } else {
        None
    });
    let Some(body) = body else {
        let names: Vec<_> = bodies.iter().map(|body| body.name.as_str()).collect();
        problems.push(0, &no_blade(&names, text));
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
    if let Some((announced, line)) = body.announced
        && announced != body.points.len()
    {
        let problem = ExchangeProblem::CutShort {
            what: format!(
                "c2_def of \"{}\", after {} sections",
                body.name,
                body.points.len()
            ),
            expected: format!("{announced}, as nsec announces"),
        };
        problems.push(line, &problem);
        return None;
    }
    Some(body.clone())
}

fn no_blade(names: &[&str], text: &str) -> ExchangeProblem {
    let continued = text
        .lines()
        .any(|line| line.trim_start().starts_with("continue_in_file"));
    ExchangeProblem::Other {
        what: "the blade among the bodies of the file".to_owned(),
        found: match names {
            [] => "no main_body with timoschenko_input and c2_def".to_owned(),
            _ => names.join(", "),
        },
        expected: "a main_body whose name begins with \"blade\"".to_owned(),
        help: match continued {
            true => "give the file that continue_in_file names".to_owned(),
            false => {
                "keep the main_body of the blade alone in the file, or name it blade1".to_owned()
            }
        },
    }
}

/// All bodies; `None` when a block is not closed.
fn bodies(text: &str, problems: &mut Problems) -> Option<Vec<Body>> {
    let mut reader = Reader {
        blocks: Vec::new(),
        bodies: Vec::new(),
        is_good: true,
    };
    for line in lines(text) {
        reader.take(&line, problems);
    }
    if let Some((name, line)) = reader.blocks.last() {
        let problem = ExchangeProblem::CutShort {
            what: format!("the block \"{name}\""),
            expected: format!("\"end {name}\""),
        };
        problems.push(*line, &problem);
        return None;
    }
    reader.is_good.then_some(reader.bodies)
}

struct Reader {
    /// Names of the open blocks, lower case, and their lines.
    blocks: Vec<(String, usize)>,
    bodies: Vec<Body>,
    is_good: bool,
}

impl Reader {
    fn take(&mut self, line: &Line<'_>, problems: &mut Problems) {
        let words = words(line.text);
        let Some((first, rest)) = words.split_first() else {
            return;
        };
        match first.to_lowercase().as_str() {
            "begin" => {
                let name = rest.first().copied().unwrap_or_default().to_lowercase();
                if name == "main_body" {
                    self.bodies.push(Body::default());
                }
                self.blocks.push((name, line.number));
            }
            "end" => self.end(line, rest, problems),
            "exit" => {}
            key => {
                let good = self.statement(key, line, rest, problems);
                self.is_good &= good.is_some();
            }
        }
    }

    fn end(&mut self, line: &Line<'_>, rest: &[&str], problems: &mut Problems) {
        let name = rest.first().copied().unwrap_or_default().to_lowercase();
        let open = self.blocks.pop();
        if open.as_ref().is_some_and(|(open, _)| *open == name) {
            return;
        }
        self.is_good = false;
        let expected = match open {
            Some((open, at)) => format!("\"end {open}\", since line {at} begins it"),
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
    }

    /// A statement inside of a body; `None` where it is wrong.
    fn statement(
        &mut self,
        key: &str,
        line: &Line<'_>,
        rest: &[&str],
        problems: &mut Problems,
    ) -> Option<()> {
        let block = self.blocks.last().map(|(name, _)| name.as_str())?;
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
            ("timoschenko_input", "filename") => {
                body.st_file = Some((rest.join(" "), at));
            }
            ("timoschenko_input", "fpm") => body.is_full = rest.first() == Some(&"1"),
            ("timoschenko_input", "set") => {
                let [set, sub_set] = wholes("set", at, rest, problems)?;
                body.set = Some((set, sub_set, at));
            }
            ("c2_def", "nsec") => {
                let [count] = wholes("nsec", at, rest, problems)?;
                body.announced = Some((count, at));
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

/// Exactly `N` numbers behind a key; more may follow as a comment.
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

/// Exactly `N` whole numbers behind a key.
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
