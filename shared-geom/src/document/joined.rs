//! The text of a document with the content of all files that it includes.

use super::Document;
use super::card::{Card, key_text, text};
use super::tree::{Kind, Value};

impl Document {
    /// The content of the file and of all files that it includes as the text of one file, without
    /// comments, with other text in place of each table `[[kind]]`: number k is replaced by number k
    /// of `texts`.
    pub fn joined(&self, kind: &str, texts: &[String]) -> String {
        let is_table = |value: &Value| matches!(value.kind, Kind::Table(_));
        let (mut values, mut tables) = (String::new(), Vec::new());
        for entry in &self.root {
            let line = entry.line;
            match &entry.value.kind {
                Kind::Table(entries) => {
                    let card = Card::single([entry.key.as_str()], line);
                    tables.push(card.with_entries(entries).to_string());
                }
                Kind::Array(_) if entry.key == kind => tables.extend(texts.iter().cloned()),
                Kind::Array(items) if !items.is_empty() && items.iter().all(is_table) => {
                    let entries = items.iter().filter_map(|item| match &item.kind {
                        Kind::Table(entries) => Some(entries),
                        _ => None,
                    });
                    let card = || Card::listed(&entry.key, line);
                    let cards = entries.map(|entries| card().with_entries(entries).to_string());
                    tables.extend(cards);
                }
                _ => values += &format!("{} = {}\n", key_text(&entry.key), text(&entry.value)),
            }
        }
        let head = if values.is_empty() {
            None
        } else {
            Some(values)
        };
        let parts: Vec<_> = head.into_iter().chain(tables).collect();
        parts.join("\n")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn included_content_is_in_the_text() {
        let folder = tempfile::tempdir().unwrap();
        let inner = "[a]\nx = 1\n[[r]]\nname = \"old\"\n[[b]]\nz = [1.5, 2]\n[b.c]\nd = true\n";
        std::fs::write(folder.path().join("inner.toml"), inner).unwrap();
        let file = folder.path().join("outer.toml");
        let outer = "# The file.\nunits = \"SI\"\ninclude = \"inner.toml\"\n[a]\ny = \"= 2*x\"\n[[b]]\nz = []\n";
        let document = Document::parse_with_includes(outer, &file.display().to_string()).unwrap();
        let found = document.joined("r", &["[[b]]\nnew = 1\n".to_owned()]);
        let expected = "units = \"SI\"\n\n[a]\ny = \"= 2*x\"\nx = 1\n\n[[b]]\nz = []\n\n\
                        [[b]]\nz = [1.5, 2]\nc = { d = true }\n\n[[b]]\nnew = 1\n";
        assert_eq!(found, expected);
    }
}
