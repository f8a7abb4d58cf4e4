//! The two streams of the program.

use std::io::{ErrorKind, Result, Write};

use shared_geom::error::Explain;

/// Output and error stream. A stream that no one reads any more (a closed pipe) takes
/// everything in silence; the work goes on.
pub(super) struct Terminal<'a> {
    out: &'a mut dyn Write,
    err: &'a mut dyn Write,
    /// Whether something was lost for another reason.
    failed: bool,
}

impl<'a> Terminal<'a> {
    pub fn new(out: &'a mut dyn Write, err: &'a mut dyn Write) -> Self {
        Self {
            out,
            err,
            failed: false,
        }
    }

    /// Writes `text` as it stands.
    pub fn show(&mut self, text: &str) {
        let result = self.out.write_all(text.as_bytes());
        self.note(&result);
    }

    /// Shows what was written so far, before a long work.
    pub fn flush(&mut self) {
        let result = self.out.flush();
        self.note(&result);
    }

    /// Writes a line to the error stream, below all that was shown before.
    pub fn tell_text(&mut self, text: &str) {
        let shown = self.out.flush();
        self.note(&shown);
        let told = writeln!(self.err, "{text}");
        self.note(&told);
    }

    /// Tells a problem, with its remedy.
    pub fn tell(&mut self, problem: &impl Explain) {
        let help = problem
            .help()
            .map_or_else(String::new, |help| format!("\n  help: {help}"));
        self.tell_text(&format!("error: {problem}{help}"));
    }

    /// Whether both streams took everything, or closed.
    pub fn finish(mut self) -> bool {
        let result = self.out.flush().and_then(|()| self.err.flush());
        self.note(&result);
        !self.failed
    }

    fn note(&mut self, result: &Result<()>) {
        if let Err(error) = result
            && error.kind() != ErrorKind::BrokenPipe
            && !self.failed
        {
            self.failed = true;
            // If this fails too, there is no one left to tell.
            let _ = writeln!(self.err, "error: the output cannot be written: {error}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Error;

    /// A stream that fails with an error of some kind.
    struct Failing(ErrorKind);

    impl Write for Failing {
        fn write(&mut self, _: &[u8]) -> Result<usize> {
            Err(Error::from(self.0))
        }

        fn flush(&mut self) -> Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_closed_pipe_is_no_failure_and_a_full_disk_is() {
        for (kind, good) in [
            (ErrorKind::BrokenPipe, true),
            (ErrorKind::StorageFull, false),
        ] {
            let (mut out, mut err) = (Failing(kind), Vec::new());
            let mut terminal = Terminal::new(&mut out, &mut err);
            terminal.show("a");
            terminal.show("b");
            assert_eq!(terminal.finish(), good);
            let told = String::from_utf8(err).unwrap();
            assert_eq!(told.lines().count(), usize::from(!good), "{told}");
        }
    }
}
