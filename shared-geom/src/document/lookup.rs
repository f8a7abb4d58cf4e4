//! Parameters by tables: values over another parameter, on straight pieces between rows.
//!
//! ```text
//! y = y_k + (x - x_k) (y_(k+1) - y_k) / (x_(k+1) - x_k) ,     x_k <= x <= x_(k+1)
//! ```

use super::schema::ValueKind::{Lines, Numbers, Text, Texts};
use super::tree::Entry;
use super::{ByHand, Document, DocumentProblem, Table, read_text};
use crate::error::{Diagnostics, SourceLocation, quoted};
use crate::keys;

/// Description of the rows in the table.
const PAIRS: &str = "rows of two numbers, as in [[3, 6.97], [11, 11.89]]";

keys! {
    /// A parameter by a table over another one: straight pieces between the rows, and an error
    /// outside.
    pub PARAMETER_TABLE = "[parameters.NAME]";
    /// The other parameter.
    pub(super) OF: String = "of", [Text], required, "\"wind\"";
    /// Rows of a value of the other parameter and a value of this one, in place of `file`; the first
    /// ones rise.
    ROWS: ByHand = "rows", [Lines(2)], optional, "[[3, 6.97], [11, 11.89]]";
    /// A file of columns between commas or blanks, in place of `rows`; lines that begin with `#` are
    /// comments.
    FILE: Option<String> = "file", [Text], optional, "\"schedule.csv\"";
    /// Columns of the file, of the other parameter and of this one: two titles of its first line, or
    /// two numbers from one, with which a first line of titles is passed over.
    COLUMNS: ByHand = "columns", [Texts, Numbers(2)], or "[1, 2]",
        "[\"speed [m/s]\", \"pitch [deg]\"]";
}

/// A row and its line.
type Row = (usize, [f64; 2]);

/// Values over another parameter.
#[derive(Debug)]
pub(super) struct Lookup {
    rows: Vec<[f64; 2]>,
}

impl Lookup {
    /// First and last value of the other parameter.
    pub fn range(&self) -> [f64; 2] {
        let at = |row: Option<&[f64; 2]>| row.map_or(f64::NAN, |row| row[0]);
        [at(self.rows.first()), at(self.rows.last())]
    }

    /// Values of the other parameter at the rows.
    pub fn values(&self) -> Vec<f64> {
        self.rows.iter().map(|row| row[0]).collect()
    }

    /// The value at `x`; `None` outside of the rows.
    pub fn at(&self, x: f64) -> Option<f64> {
        let after = self.rows.iter().position(|row| row[0] >= x)?;
        let [x1, y1] = self.rows[after];
        if x1 == x {
            return Some(y1);
        }
        let [x0, y0] = *self.rows.get(after.checked_sub(1)?)?;
        Some(y0 + (x - x0) * (y1 - y0) / (x1 - x0))
    }
}

/// Reads the table of the parameter `name` on `line`: the name of the other parameter, and the rows.
pub(super) fn read(
    document: &Document,
    (name, line): (&str, usize),
    entries: &[Entry],
) -> Option<(String, Lookup)> {
    let title = format!("the parameter \"{name}\"");
    let table = Table::new(document, entries, title, line).described(&PARAMETER_TABLE);
    let (of, file) = (table.get(&OF), table.get(&FILE)?);
    let rows = match (file, table.has(&ROWS)) {
        (Some(file), false) => from_file(&table, &file),
        (None, true) => {
            let rows = table.item(&ROWS).and_then(|item| item.pairs(PAIRS));
            rows.map(|rows| (None, rows))
        }
        (file, _) => {
            let _ = table.has(&COLUMNS);
            let found = file.map_or("neither", |_| "both");
            let expected = "either \"rows\" or \"file\"".to_owned();
            document.note(line, &wrong(name, found.to_owned(), expected));
            None
        }
    };
    table.finish();
    let (file, rows) = rows?;
    let falls = rows.windows(2).find(|pair| pair[1].1[0] <= pair[0].1[0]);
    let problem = match (falls, rows.len()) {
        (Some(pair), _) => Some((
            pair[1].0,
            pair[1].1[0].to_string(),
            "a larger value than before",
        )),
        (None, 0) => Some((line, "a table without rows".to_owned(), "2 rows or more")),
        (None, 1) => Some((line, "a table of 1 row".to_owned(), "2 rows or more")),
        _ => None,
    };
    if let Some((at, found, expected)) = problem {
        let key = match &file {
            Some(_) if rows.len() < 2 => FILE.name(),
            _ => ROWS.name(),
        };
        let problem = wrong(key, found, expected.to_owned());
        match file.filter(|_| rows.len() > 1) {
            Some(file) => {
                let location = SourceLocation::line(&file, at);
                let _: Option<()> = document.keep(Err(Diagnostics::one(location, &problem)));
            }
            None => document.note(at, &problem),
        }
        return None;
    }
    let rows = rows.into_iter().map(|row| row.1).collect();
    Some((of?, Lookup { rows }))
}

fn wrong(key: &str, found: String, expected: String) -> DocumentProblem {
    let key = key.to_owned();
    DocumentProblem::WrongValue {
        key,
        found,
        expected,
    }
}

/// The two columns of a file.
enum Columns {
    Titles([String; 2]),
    /// From zero.
    Numbers([usize; 2]),
}

/// The columns of the file, by `columns`.
fn columns(table: &Table<'_>) -> Option<Columns> {
    const EXPECTED: &str = "two titles, or two numbers from one, as in [1, 3]";
    let Some(item) = table.item(&COLUMNS) else {
        return Some(Columns::Numbers([0, 1]));
    };
    let Some(list) = item.list() else {
        return item.wrong(EXPECTED);
    };
    let [one, other] = &list[..] else {
        return item.wrong(EXPECTED);
    };
    if let (Some(one), Some(other)) = (one.text(), other.text()) {
        return Some(Columns::Titles([one.to_owned(), other.to_owned()]));
    }
    match (one.whole_number(), other.whole_number()) {
        (Some(one), Some(other)) => {
            let from_zero = |number: u64| usize::try_from(number - 1).unwrap_or(usize::MAX);
            Some(Columns::Numbers([from_zero(one), from_zero(other)]))
        }
        _ => item.wrong(EXPECTED),
    }
}

/// The shown name of the file `written`, and its rows.
fn from_file(table: &Table<'_>, written: &str) -> Option<(Option<String>, Vec<Row>)> {
    let (path, columns) = (table.existing(&FILE, written), columns(table));
    let (path, columns) = (path?, columns?);
    let text = table.keep_file(FILE.name(), read_text(&path))?;
    let file = path.display().to_string();
    let rows = rows(&text, &file, &columns);
    Some((Some(file), table.keep_file(FILE.name(), rows)?))
}

/// The cells of a line: between commas, or without any between blanks.
fn cells(line: &str) -> Vec<&str> {
    if line.contains(',') {
        line.split(',').map(str::trim).collect()
    } else {
        line.split_whitespace().collect()
    }
}

fn number(cells: &[&str], column: usize) -> Option<f64> {
    let number = cells.get(column)?.parse::<f64>().ok();
    number.filter(|number| number.is_finite())
}

/// Indices of the columns, and the number of lines of titles, which counts the first of the `lines`.
fn indices(
    lines: &[(usize, &str)],
    file: &str,
    columns: &Columns,
) -> Result<([usize; 2], usize), Diagnostics> {
    let (line, first) = lines.first().copied().unwrap_or((1, ""));
    let titles = match columns {
        Columns::Numbers(indices) => {
            let cells = cells(first);
            let are_numbers = indices
                .iter()
                .all(|column| number(&cells, *column).is_some());
            return Ok((*indices, usize::from(!are_numbers)));
        }
        Columns::Titles(titles) => titles,
    };
    let known: Vec<_> = first.split(',').map(str::trim).collect();
    let mut problems = Diagnostics::new();
    let found = titles.each_ref().map(|title| {
        let found = known.iter().position(|own| own == title);
        if found.is_none() {
            let expected = format!("one of the columns {}", quoted(&known));
            let problem = wrong("columns", format!("\"{title}\""), expected);
            problems.push(SourceLocation::line(file, line), &problem);
        }
        found.unwrap_or(0)
    });
    problems.into_result((found, 1))
}

/// The rows of a text.
fn rows(text: &str, file: &str, columns: &Columns) -> Result<Vec<Row>, Diagnostics> {
    let lines = (1..).zip(text.lines());
    let counts = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let lines: Vec<(usize, &str)> = lines.filter(|(_, line)| counts(line)).collect();
    let (indices, titles) = indices(&lines, file, columns)?;
    let lines = &lines[titles.min(lines.len())..];
    let mut columns = indices.to_vec();
    columns.dedup();
    let mut problems = Diagnostics::new();
    for column in columns {
        no_numbers(lines, column, file, &mut problems);
    }
    let row = |&(line, text): &(usize, &str)| {
        let cells = cells(text);
        let [x, y] = indices.map(|column| number(&cells, column));
        Some((line, [x?, y?]))
    };
    problems.into_result(lines.iter().filter_map(row).collect())
}

/// Notes the first of the lines without a number in a column, with the number of the others.
fn no_numbers(lines: &[(usize, &str)], column: usize, file: &str, problems: &mut Diagnostics) {
    let mut failed = lines
        .iter()
        .map(|(line, text)| (*line, cells(text)))
        .filter(|(_, cells)| number(cells, column).is_none());
    let Some((line, cells)) = failed.next() else {
        return;
    };
    let found = cells.get(column).map(|cell| format!("\"{cell}\""));
    let found = found.unwrap_or_else(|| "absent".to_owned());
    let others = match failed.count() {
        0 => String::new(),
        1 => ", and no number in 1 more row".to_owned(),
        others => format!(", and no number in {others} more rows"),
    };
    let column = format!("column {}", column + 1);
    let problem = wrong(&column, found + &others, "a number".to_owned());
    problems.push(SourceLocation::line(file, line), &problem);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number of a parameter of a file, or the messages.
    fn parameter(
        text: &str,
        file: &str,
        name: &str,
        given: &[(String, f64)],
    ) -> Result<f64, String> {
        let document = Document::parse(text, file).unwrap();
        document.declare_parameters_as(&document.root(), given);
        let known = document.parameters().clone();
        let found = known.iter().find(|own| own.0 == name).map(|own| own.1);
        let found = document.finish(found);
        found.map_err(|problems| problems.to_string())
    }

    const FILE_NAME: &str = "a.toml";

    // Pieces with the slopes 2 and -1, at rows, between them, and by other parameters that are declared
    // before and after.
    #[test]
    fn a_table_is_straight_between_its_rows() {
        let text = "[parameters]\nx = \"= wind\"\n\
                    a = { of = \"x\", rows = [[3, 1], [5, 5], [7, 3]] }\n\
                    b = \"= 10*a\"\nwind = 3\n";
        for (wind, expected) in [(3.0, 1.0), (4.0, 3.0), (5.0, 5.0), (6.5, 3.5), (7.0, 3.0)] {
            let given = [("wind".to_owned(), wind)];
            assert_eq!(parameter(text, FILE_NAME, "a", &given), Ok(expected));
            assert_eq!(parameter(text, FILE_NAME, "b", &given), Ok(10.0 * expected));
        }
        // A given value replaces the table.
        let given = [("a".to_owned(), 8.0)];
        assert_eq!(parameter(text, FILE_NAME, "b", &given), Ok(80.0));
    }

    // Titles and numbers, commas and blanks, with and without a first line of titles.
    #[test]
    fn columns_of_files_are_found_by_titles_and_numbers() {
        let folder = tempfile::tempdir().unwrap();
        let name = folder.path().join("a.toml").display().to_string();
        std::fs::write(
            folder.path().join("a.csv"),
            "# source\nspeed [m/s],rpm,pitch\n3,7,0.5\n5,8,1.5\n",
        )
        .unwrap();
        std::fs::write(folder.path().join("a.opt"), "  3.0e0 0.5  7\n 5.0 1.5 8\n").unwrap();
        std::fs::write(folder.path().join("b.opt"), "2 speed pitch\n3 0.5\n5 1.5\n").unwrap();
        for source in [
            "file = \"a.csv\", columns = [\"speed [m/s]\", \"pitch\"]",
            "file = \"a.csv\", columns = [1, 3]",
            "file = \"a.opt\"",
            "file = \"b.opt\"",
        ] {
            let text = format!("[parameters]\nv = 4.5\np = {{ of = \"v\", {source} }}\n");
            assert_eq!(parameter(&text, &name, "p", &[]), Ok(1.25), "{source}");
        }
        let wrong = |source: &str| {
            let text = format!("[parameters]\nv = 4\np = {{ of = \"v\", {source} }}\n");
            parameter(&text, &name, "p", &[]).unwrap_err()
        };
        let title = wrong("file = \"a.csv\", columns = [\"speed\", \"pitch\"]");
        assert!(
            title.contains("a.csv:2: \"columns\" is \"speed\", expected one of"),
            "{title}"
        );
        // One message a column, with the number of its wrong rows.
        std::fs::write(folder.path().join("c.csv"), "3,1\n5,x\n5\ny\n").unwrap();
        let cells = wrong("file = \"c.csv\"");
        for expected in [
            "c.csv:4: \"column 1\" is \"y\", expected a number",
            "c.csv:2: \"column 2\" is \"x\", and no number in 2 more rows, expected a number",
        ] {
            assert!(cells.contains(expected), "{cells}");
        }
        assert_eq!(cells.matches("c.csv:").count(), 2, "{cells}");
        std::fs::write(folder.path().join("d.csv"), "3,1\n5,2\n5,3\n").unwrap();
        let falls = wrong("file = \"d.csv\"");
        assert!(
            falls.contains("d.csv:3: \"rows\" is 5, expected a larger value"),
            "{falls}"
        );
        std::fs::write(folder.path().join("f.csv"), "3,1\n").unwrap();
        let short = wrong("file = \"f.csv\"");
        assert!(
            short.contains("a.toml:3: \"file\" is a table of 1 row, expected 2 rows or more"),
            "{short}"
        );
        let absent = wrong("file = \"e.csv\"");
        assert!(absent.contains("a.toml:3"), "{absent}");
    }

    #[test]
    fn wrong_tables_are_reported() {
        for (source, expected) in [
            (
                "of = \"w\", rows = [[3, 1], [5, 2]]",
                "\"of\" is \"w\", expected one of",
            ),
            ("rows = [[3, 1], [5, 2]]", "has no \"of\""),
            (
                "of = \"v\"",
                "neither, expected either \"rows\" or \"file\"",
            ),
            (
                "of = \"v\", rows = [[3, 1]]",
                "\"rows\" is a table of 1 row, expected 2 rows or more",
            ),
            (
                "of = \"v\", rows = [[3, 1], [5]]",
                "expected rows of two numbers",
            ),
            (
                "of = \"v\", rows = [[3, 1], [2, 4]]",
                "\"rows\" is 2, expected a larger value",
            ),
            (
                "of = \"v\", rows = [[3, 1], [5, 4]]",
                "\"v\" is 9, expected a value from 3 to 5",
            ),
            (
                "of = \"p\", rows = [[3, 1], [5, 4]]",
                "depends on itself: p -> p",
            ),
            ("of = \"v\", row = [[3, 1], [5, 4]]", "unknown key \"row\""),
        ] {
            let text = format!("[parameters]\nv = 9\np = {{ {source} }}\n");
            let shown = parameter(&text, FILE_NAME, "p", &[]).unwrap_err();
            assert!(
                shown.contains(expected) && shown.contains("a.toml:3"),
                "{shown}"
            );
        }
    }
}
