//! Formulas of the book, LaTeX in the source, as MathML.
//!
//! A displayed formula is a fence `math`, as GitHub shows it too: one formula, or rows of an
//! `align` environment. A row may end with its number, `\tag{D-1}`. A formula in a line of text
//! is `` $`...`$ ``.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::mathml::push_mathml;
use pulldown_latex::{Parser, Storage};

const FENCE: &str = "```";
const MATH: &str = "```math";
const ALIGN: [&str; 2] = ["\\begin{align}", "\\end{align}"];
const INLINE: [&str; 2] = ["$`", "`$"];

/// A page with its formulas as MathML; or all wrong formulas with their lines (from one).
pub fn rendered(page: &str) -> Result<String, Vec<(usize, String)>> {
    let mut out = String::with_capacity(2 * page.len());
    let mut wrong = Vec::new();
    let mut lines = page.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        let found = if line.trim_start().starts_with(MATH) {
            let is_inside = |line: &&str| !line.trim_start().starts_with(FENCE);
            let body = lines.by_ref().map(|(_, line)| line);
            let body: Vec<_> = body.take_while(is_inside).collect();
            // A formula in an item of a list stays in it.
            let indent = &line[..line.len() - line.trim_start().len()];
            displayed(&body.join("\n")).map(|formula| format!("{indent}{formula}"))
        } else if line.trim_start().starts_with(FENCE) {
            let mut fence = format!("{line}\n");
            for (_, line) in lines.by_ref() {
                fence.push_str(line);
                fence.push('\n');
                if line.trim_start().starts_with(FENCE) {
                    break;
                }
            }
            Ok(fence)
        } else {
            in_text(line).map(|text| text + "\n")
        };
        match found {
            Ok(text) => out.push_str(&text),
            Err(problem) => wrong.push((number + 1, problem)),
        }
    }
    if wrong.is_empty() {
        Ok(out)
    } else {
        Err(wrong)
    }
}

/// A displayed formula, its numbers in a column on the right.
fn displayed(tex: &str) -> Result<String, String> {
    let body = tex.trim();
    let inside = body.strip_prefix(ALIGN[0]);
    let inside = inside.and_then(|body| body.strip_suffix(ALIGN[1]));
    let rows = outside_of_environments(inside.unwrap_or(body), "\\\\");
    let most = rows.iter().map(|row| columns(row)).max().unwrap_or(0);
    let row = |row: &&str| {
        let (formula, number) = match row.split_once("\\tag{") {
            Some((formula, rest)) => (formula, rest.split_once('}').map(|(number, _)| number)),
            None => (*row, None),
        };
        let filled = "&".repeat(most - columns(row));
        let number = number.map_or_else(String::new, |it| format!("&\\qquad\\text{{({it})}}"));
        format!("{} {filled}{number}", formula.trim())
    };
    let rows: Vec<_> = rows.iter().map(row).collect();
    let tex = format!("\\begin{{aligned}}{}\\end{{aligned}}", rows.join("\\\\"));
    let math = mathml(&tex, DisplayMode::Block)?;
    // An empty line ends the block of HTML, as the rest is Markdown again.
    Ok(format!("<div class=\"formula\">{math}</div>\n\n"))
}

/// A line of text with its formulas as MathML.
fn in_text(line: &str) -> Result<String, String> {
    let mut pieces = line.split(INLINE[0]);
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let Some((tex, text)) = piece.split_once(INLINE[1]) else {
            return Err(format!("formula \"{piece}\" has no end {}", INLINE[1]));
        };
        out.push_str(&mathml(tex, DisplayMode::Inline)?);
        out.push_str(text);
    }
    Ok(out)
}

fn mathml(tex: &str, display_mode: DisplayMode) -> Result<String, String> {
    let storage = Storage::new();
    if let Some(Err(problem)) = Parser::new(tex, &storage).find(Result::is_err) {
        return Err(format!("{problem}"));
    }
    let mut out = String::new();
    let config = RenderConfig {
        display_mode,
        ..RenderConfig::default()
    };
    push_mathml(&mut out, Parser::new(tex, &storage), config)
        .map_err(|problem| problem.to_string())?;
    Ok(escaped(&out.replace('\n', " ")))
}

/// MathML with its text in character references where HTML or Markdown would take it for a tag, a
/// cell of a table or a mark of emphasis.
fn escaped(math: &str) -> String {
    let mut out = String::with_capacity(math.len());
    let mut rest = math;
    while let Some(first) = rest.chars().next() {
        let is_tag = rest.starts_with("</")
            || first == '<' && rest[1..].starts_with(|c: char| c.is_ascii_alphabetic());
        let end = rest.find('>').filter(|_| is_tag);
        let length = end.map_or(first.len_utf8(), |end| end + 1);
        match first {
            '<' | '>' | '|' | '*' | '_' | '~' | '`' | '\\' | '[' | ']' if !is_tag => {
                out.push_str(&format!("&#{};", u32::from(first)));
            }
            _ => out.push_str(&rest[..length]),
        }
        rest = &rest[length..];
    }
    out
}

/// Number of column separators of a row.
fn columns(row: &str) -> usize {
    outside_of_environments(row, "&").len() - 1
}

/// Pieces of LaTeX between separators that are in no environment.
fn outside_of_environments<'a>(tex: &'a str, separator: &str) -> Vec<&'a str> {
    let mut pieces = Vec::new();
    let (mut start, mut depth, mut at) = (0, 0, 0);
    while let Some(rest) = tex.get(at..).filter(|rest| !rest.is_empty()) {
        if rest.starts_with("\\begin") {
            depth += 1;
        } else if rest.starts_with("\\end") {
            depth -= 1;
        } else if depth == 0 && rest.starts_with(separator) {
            pieces.push(&tex[start..at]);
            start = at + separator.len();
        }
        // A backslash includes the next character, so that "\&" is not a separator.
        let characters = if rest.starts_with('\\') { 2 } else { 1 };
        at += rest
            .chars()
            .take(characters)
            .map(char::len_utf8)
            .sum::<usize>();
    }
    pieces.push(&tex[start..]);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_mathml_and_all_else_stays() {
        let page = "A $`\\omega`$ b.\n```text\n$`x`$\n```\n```math\na = b \\tag{D-1}\n```\nend\n";
        let found = rendered(page).unwrap();
        assert!(found.contains("ω") && found.contains("(D-1)"), "{found}");
        assert!(found.contains("```text\n$`x`$\n```\n") && found.ends_with("end\n"));
        assert!(!found.contains("\\tag") && !found.contains("```math"));
    }

    #[test]
    fn signs_are_no_tags_and_no_marks() {
        let found = rendered("| $`a < \\vert \\tilde b\\vert * c`$ | $`d_e`$ |\n").unwrap();
        let text: String = found
            .split('<')
            .filter_map(|it| it.split_once('>'))
            .map(|it| it.1)
            .collect();
        assert!(text.contains("&#60;") && text.contains("&#124;"), "{found}");
        assert_eq!(found.matches('|').count(), 3, "{found}");
        assert!(!found.contains(['~', '*', '_']), "{found}");
    }

    // Without its empty lines a page is one paragraph, and after a formula all is HTML.
    #[test]
    fn empty_lines_stay_and_follow_formulas() {
        let page = "a\n\n# b\n\n- c\n\n  ```math\n  d\n  ```\n  e\n";
        let found = rendered(page).unwrap();
        assert!(found.starts_with("a\n\n# b\n\n- c\n\n  <div"), "{found}");
        assert!(found.ends_with("</div>\n\n  e\n"), "{found}");
    }

    #[test]
    fn rows_are_split_outside_of_environments_only() {
        let tex = "a &= \\begin{bmatrix} 1 & 2 \\\\ 3 & 4 \\end{bmatrix} \\\\ b &= c \\& d";
        let rows = outside_of_environments(tex, "\\\\");
        assert_eq!(rows.len(), 2);
        assert_eq!([columns(rows[0]), columns(rows[1])], [1, 1]);
    }

    #[test]
    fn wrong_formulas_are_reported_with_their_lines() {
        let page = "text\n```math\n\\frak{\n```\n$`\\omega\n";
        let lines: Vec<_> = rendered(page).unwrap_err().iter().map(|it| it.0).collect();
        assert_eq!(lines, [2, 5]);
    }
}
