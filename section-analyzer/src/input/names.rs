//! Names that become parts of file names.

/// Whether a load case can have this name, which becomes part of file names.
pub fn is_load_name(name: &str) -> bool {
    let fits = |letter: char| letter.is_alphanumeric() || letter == '-' || letter == '_';
    !name.is_empty() && name.chars().all(fits)
}
