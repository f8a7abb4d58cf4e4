//! Fingerprints of inputs, by which results can be traced to them.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use sha2::{Digest, Sha256};

/// Size of the pieces in which a file is read [byte].
const PIECE: usize = 1 << 16;
/// The text before the digits of a hash.
const KIND: &str = "sha256:";
/// Digits of a fingerprint.
const DIGITS: usize = 16;

/// The SHA-256 of all `parts`, as `sha256:` and 64 hexadecimal digits.
///
/// The length of each part is included, so that moving bytes from one part to the next
/// changes the result.
pub fn sha256_of(parts: &[&[u8]]) -> String {
    let mut hasher = Sha256::new();
    for part in parts {
        hasher.update((part.len() as u64).to_le_bytes());
        hasher.update(part);
    }
    named(&hasher.finalize())
}

/// The SHA-256 of the content of a file, `sha256:` and the digits of `sha256sum`.
pub fn sha256_of_content(bytes: &[u8]) -> String {
    named(&Sha256::digest(bytes))
}

/// As [`sha256_of_content`], of the file at `path`, which is read piece by piece.
///
/// # Errors
/// Errors of the system.
pub fn sha256_of_file(path: &Path) -> io::Result<String> {
    let mut file = File::open(path)?;
    let mut hasher = Sha256::new();
    let mut piece = vec![0; PIECE];
    loop {
        match file.read(&mut piece) {
            Ok(0) => return Ok(named(&hasher.finalize())),
            Ok(count) => hasher.update(&piece[..count]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

/// The first digits of a hash, by which tables name the content of a file.
pub fn fingerprint(hash: &str) -> &str {
    let digits = hash.strip_prefix(KIND).unwrap_or(hash);
    digits.get(..DIGITS).unwrap_or(digits)
}

fn named(digits: &[u8]) -> String {
    let hexadecimal: String = digits.iter().map(|byte| format!("{byte:02x}")).collect();
    format!("{KIND}{hexadecimal}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// SHA-256 of the count 3 in eight bytes (lowest first) and "abc", by sha256sum.
    #[test]
    fn hash_is_that_of_length_and_bytes() {
        assert_eq!(
            sha256_of(&[b"abc"]),
            "sha256:ce91dc5eec0139adf091900d225971d6ad246a845bad791b5693a9d0d55dd391"
        );
    }

    /// SHA-256 of "abc": the example of FIPS 180-4.
    #[test]
    fn hash_of_a_file_is_that_of_its_bytes() {
        assert_eq!(
            sha256_of_content(b"abc"),
            "sha256:ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
    }

    /// A file of several pieces, the last one not full.
    #[test]
    fn hash_of_a_file_does_not_depend_on_its_pieces() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        for count in [0, PIECE, 2 * PIECE + 7] {
            let content: Vec<u8> = (0..count).map(|k| (k % 251) as u8).collect();
            std::fs::write(&path, &content).unwrap();
            assert_eq!(sha256_of_file(&path).unwrap(), sha256_of_content(&content));
        }
        assert!(sha256_of_file(&folder.path().join("none")).is_err());
    }

    #[test]
    fn a_fingerprint_is_the_first_digits() {
        assert_eq!(fingerprint(&sha256_of_content(b"abc")), "ba7816bf8f01cfea");
        assert_eq!(fingerprint("short"), "short");
    }

    #[test]
    fn parts_are_kept_apart() {
        assert_ne!(sha256_of(&[b"ab", b"c"]), sha256_of(&[b"a", b"bc"]));
        assert_ne!(sha256_of(&[b"ab"]), sha256_of(&[b"ab", b""]));
        assert_eq!(sha256_of(&[]).len(), "sha256:".len() + 64);
    }
}
