//! A stream whose reader may have gone.

use std::fmt;
use std::io::{ErrorKind, Result, Write};

/// Passes everything on to a stream. A closed pipe discards it without an error, so that the work
/// continues, all files are written, and the work decides on the exit code.
pub struct Stream<'a>(
    /// The stream.
    pub &'a mut dyn Write,
);

impl fmt::Debug for Stream<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Stream")
    }
}

impl Write for Stream<'_> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        unless_closed(self.0.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> Result<()> {
        unless_closed(self.0.flush(), ())
    }
}

/// The result of writing, or `done` to a closed pipe.
fn unless_closed<T>(result: Result<T>, done: T) -> Result<T> {
    match result {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(done),
        other => other,
    }
}
