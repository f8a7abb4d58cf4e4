//! Binary headers, little-endian.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::exchange::problem::ExchangeProblem;
use shared_geom::files::{names_beside, nearest_file};

/// Bytes that a header may have.
const HEADER: u64 = 1 << 16;

/// An open file: its name, its size, and its first bytes.
#[derive(Debug)]
pub(super) struct Opened {
    pub name: String,
    pub file: File,
    pub size: u64,
    pub head: Vec<u8>,
}

/// Opens a file.
///
/// # Errors
/// The file is missing or cannot be read.
pub(super) fn open(path: &Path) -> Result<Opened, Diagnostics> {
    let name = path.display().to_string();
    let opened = File::open(path).and_then(|mut file| {
        let size = file.metadata()?.len();
        let mut head = Vec::new();
        (&mut file).take(HEADER).read_to_end(&mut head)?;
        file.seek(SeekFrom::Start(0))?;
        Ok((file, size, head))
    });
    match opened {
        Ok((file, size, head)) => Ok(Opened {
            name,
            file,
            size,
            head,
        }),
        Err(error) => Err(unreadable(path, &error)),
    }
}

fn unreadable(path: &Path, error: &std::io::Error) -> Diagnostics {
    let name = path.display().to_string();
    let (found, help) = if error.kind() == std::io::ErrorKind::NotFound {
        let help = nearest_file(&name, &names_beside(path));
        ("no such file".to_owned(), help)
    } else {
        (
            error.to_string(),
            "check the path and its permissions".to_owned(),
        )
    };
    let problem = ExchangeProblem::Other {
        what: "turbulence box".to_owned(),
        found,
        expected: "a file that can be read".to_owned(),
        help,
    };
    Diagnostics::one(SourceLocation::file(name), &problem)
}

/// The problem that a file cannot be written.
pub(super) fn unwritten(path: &Path, error: &std::io::Error) -> Diagnostics {
    let problem = ExchangeProblem::Other {
        what: "turbulence box".to_owned(),
        found: error.to_string(),
        expected: "a file that can be written".to_owned(),
        help: "check the folder, its permissions, and the free space".to_owned(),
    };
    Diagnostics::one(SourceLocation::file(path.display().to_string()), &problem)
}

/// Reads numbers one after the other; beyond the end they are zero, and the end is noted.
#[derive(Debug)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Cursor<'a> {
    /// At the begin of `bytes`.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    /// The index of the next byte.
    pub fn at(&self) -> usize {
        self.at
    }

    /// Whether more bytes were requested than there are.
    pub fn is_beyond(&self) -> bool {
        self.at > self.bytes.len()
    }

    fn take<const N: usize>(&mut self) -> [u8; N] {
        let start = self.at.min(self.bytes.len());
        self.at = self.at.saturating_add(N);
        let rest = self.bytes.get(start..self.at);
        rest.and_then(|rest| rest.try_into().ok()).unwrap_or([0; N])
    }

    /// The next bytes are not used.
    pub fn skip(&mut self, bytes: usize) {
        self.at = self.at.saturating_add(bytes);
    }

    pub fn i16(&mut self) -> i16 {
        i16::from_le_bytes(self.take())
    }

    pub fn i32(&mut self) -> i32 {
        i32::from_le_bytes(self.take())
    }

    /// A single-precision number.
    pub fn f32(&mut self) -> f64 {
        f64::from(f32::from_le_bytes(self.take()))
    }

    /// A count; negative numbers are zero, which the check of the grid reports.
    pub fn count(&mut self) -> usize {
        usize::try_from(self.i32()).unwrap_or(0)
    }
}

/// The problem of a file that is shorter than its header.
pub(super) fn short_header(name: &str, size: u64) -> Diagnostics {
    let problem = ExchangeProblem::CutShort {
        what: "its header".to_owned(),
        expected: format!("more than its {size} bytes"),
    };
    Diagnostics::one(SourceLocation::file(name), &problem)
}

/// Compares the size of a file with the size that its header implies.
pub(super) fn size_problem(found: u64, expected: Option<u64>) -> Option<ExchangeProblem> {
    if expected == Some(found) {
        return None;
    }
    let expected = expected.map_or_else(
        || "a size that can be addressed".to_owned(),
        |expected| format!("{expected} bytes, as the numbers of planes and points imply"),
    );
    Some(ExchangeProblem::Other {
        what: "size of the turbulence box".to_owned(),
        found: format!("{found} bytes"),
        expected,
        help: "the file may be cut off or of another format, or the dimensions given for it are \
               wrong"
            .to_owned(),
    })
}

/// `header + planes * points * bytes`, if it can be addressed.
pub(super) fn total(header: usize, factors: &[usize]) -> Option<u64> {
    let product = |all: u64, factor: &usize| all.checked_mul(*factor as u64);
    let body = factors.iter().try_fold(1_u64, product)?;
    body.checked_add(header as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_the_end() {
        let mut cursor = Cursor::new(&[1, 2, 0, 0, 128, 63, 255, 255, 255, 255, 9]);
        assert_eq!((cursor.i16(), cursor.f32(), cursor.count()), (513, 1.0, 0));
        assert!(!cursor.is_beyond());
        assert_eq!(cursor.i32(), 0);
        assert!(cursor.is_beyond());
        assert_eq!(cursor.i16(), 0);
    }

    #[test]
    fn sizes_that_overflow_are_a_problem() {
        assert_eq!(total(5, &[2, 3]), Some(11));
        assert_eq!(total(5, &[usize::MAX, 3]), None);
        assert!(size_problem(11, Some(11)).is_none());
        assert!(size_problem(11, None).is_some());
        assert!(
            size_problem(11, Some(12))
                .unwrap()
                .to_string()
                .contains("12 bytes")
        );
    }

    #[test]
    fn a_missing_file_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("wind.bts"), [0]).unwrap();
        let problems = open(&folder.path().join("wint.bts")).unwrap_err();
        assert!(format!("{problems}").contains("wind.bts"), "{problems}");
        assert_eq!(open(&folder.path().join("wind.bts")).unwrap().size, 1);
    }
}
