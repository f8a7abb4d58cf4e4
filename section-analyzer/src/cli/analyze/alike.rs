//! Texts about many sections: those whose first lines differ by their numbers alone are one.

/// Largest number of sections that are listed; the others are counted.
const LISTED: usize = 8;

/// The texts of a kind.
#[derive(Debug)]
struct Kind {
    key: String,
    /// The first text.
    text: String,
    /// The sections with this text.
    same: Vec<String>,
    /// The sections with other numbers in it.
    similar: Vec<String>,
}

/// Texts, in the order in which they were found first.
#[derive(Debug, Default)]
pub(super) struct Alike(Vec<Kind>);

impl Alike {
    /// Adds the text of a section; whether it is the first of its kind.
    pub fn add(&mut self, text: &str, section: &str) -> bool {
        let key = without_numbers(first_line(text));
        let Some(kind) = self.0.iter_mut().find(|kind| kind.key == key) else {
            self.0.push(Kind {
                key,
                text: text.to_owned(),
                same: vec![section.to_owned()],
                similar: Vec::new(),
            });
            return true;
        };
        let is_same = kind.text == text;
        let sections = if is_same {
            &mut kind.same
        } else {
            &mut kind.similar
        };
        sections.push(section.to_owned());
        false
    }

    /// Each text once, with its sections; of texts with other numbers the first line.
    pub fn texts(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|kind| {
            let sections = shown(&kind.same);
            match &kind.similar[..] {
                [] => format!("{sections}: {}", kind.text),
                others => format!(
                    "{sections}: {}; the same but for the numbers: {}",
                    first_line(&kind.text),
                    shown(others)
                ),
            }
        })
    }

    /// The sections of the texts that are not the first of their kind, with the first one.
    pub fn others(&self) -> impl Iterator<Item = String> {
        self.0.iter().filter_map(|kind| {
            let first = first_line(&kind.text);
            let others: Vec<&str> = kind.same[1..]
                .iter()
                .chain(&kind.similar)
                .map(String::as_str)
                .collect();
            let how = match &kind.similar[..] {
                [] => "",
                _ => ", but for the numbers",
            };
            let all = others.join(", ");
            let known = &kind.same[0];
            (!others.is_empty()).then(|| format!("{all}: the same as {known}{how}: {first}"))
        })
    }
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

fn shown(sections: &[String]) -> String {
    if sections.len() <= LISTED {
        return sections.join(", ");
    }
    let listed = LISTED - 1;
    let more = sections.len() - listed;
    format!("{} and {more} more", sections[..listed].join(", "))
}

/// The text with `#` in the place of each word that is a number.
fn without_numbers(text: &str) -> String {
    let words = text.split_inclusive(char::is_whitespace).map(|word| {
        let number = word.trim_matches(|letter: char| !letter.is_alphanumeric());
        match number.parse::<f64>() {
            Ok(_) => word.replace(number, "#").replace("-#", "#"),
            Err(_) => word.to_owned(),
        }
    });
    words.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_with_other_numbers_are_one() {
        let mut all = Alike::default();
        let texts = [
            ("web1: 3 of 9 cells, (aspect 113)", "eta 0"),
            ("web1: 3 of 9 cells, (aspect 113)", "eta 0.1"),
            ("web1: 4 of 9 cells, (aspect -1.5e3)", "eta 0.2"),
            ("web2: 4 of 9 cells, (aspect 113)", "eta 0.2"),
        ];
        let first = texts.map(|(text, section)| all.add(text, section));
        assert_eq!(first, [true, false, false, true]);
        let found: Vec<_> = all.texts().collect();
        let expected = [
            "eta 0, eta 0.1: web1: 3 of 9 cells, (aspect 113); the same but for the numbers: eta 0.2",
            "eta 0.2: web2: 4 of 9 cells, (aspect 113)",
        ];
        assert_eq!(found, expected);
        let others: Vec<_> = all.others().collect();
        assert_eq!(
            others,
            [
                "eta 0.1, eta 0.2: the same as eta 0, but for the numbers: web1: 3 of 9 cells, \
                 (aspect 113)"
            ]
        );
        for i in 0..9 {
            all.add("web3", &i.to_string());
        }
        let last = all.texts().last();
        assert_eq!(
            last.as_deref(),
            Some("0, 1, 2, 3, 4, 5, 6 and 2 more: web3")
        );
        // those that have no result are all listed
        let last = all.others().last();
        assert_eq!(
            last.as_deref(),
            Some("1, 2, 3, 4, 5, 6, 7, 8: the same as 0: web3")
        );
    }
}
