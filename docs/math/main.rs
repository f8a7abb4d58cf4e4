//! Preprocessor of the book: formulas in LaTeX become MathML, which browsers show without a
//! script, a font or a network.
//!
//! `mdbook build docs` runs it (see `docs/book.toml`): it reads and writes the book as JSON. A
//! wrong formula stops the build with its page and line.

use std::io;
use std::process::ExitCode;

use serde_json::Value;

mod render;

/// Replaces the formulas of every chapter; adds pages and lines of wrong ones to `wrong`.
fn render_chapters(value: &mut Value, wrong: &mut Vec<String>) {
    if let Value::Object(entries) = value {
        let path = entries.get("path").and_then(Value::as_str);
        let path = path.unwrap_or_default().to_owned();
        if let Some(Value::String(content)) = entries.get_mut("content") {
            match render::rendered(content) {
                Ok(page) => *content = page,
                Err(problems) => {
                    let problems = problems.iter();
                    wrong.extend(problems.map(|(line, text)| format!("{path}:{line}: {text}")));
                }
            }
        }
        entries
            .values_mut()
            .for_each(|it| render_chapters(it, wrong));
    } else if let Value::Array(items) = value {
        items.iter_mut().for_each(|it| render_chapters(it, wrong));
    }
}

fn run() -> Result<(), String> {
    let input: Value = serde_json::from_reader(io::stdin()).map_err(|it| it.to_string())?;
    // The context, then the book.
    let Value::Array(mut parts) = input else {
        return Err(String::from(
            "the input is not a list of a context and a book",
        ));
    };
    let mut book = parts.pop().ok_or("the input has no book")?;
    let mut wrong = Vec::new();
    render_chapters(&mut book, &mut wrong);
    if !wrong.is_empty() {
        return Err(wrong.join("\n"));
    }
    serde_json::to_writer(io::stdout(), &book).map_err(|it| it.to_string())
}

fn main() -> ExitCode {
    // `supports RENDERER`: MathML is part of HTML.
    let mut arguments = std::env::args().skip(1);
    if arguments.next().as_deref() == Some("supports") {
        let is_html = arguments.next().as_deref() == Some("html");
        return if is_html {
            ExitCode::SUCCESS
        } else {
            ExitCode::FAILURE
        };
    }
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}
