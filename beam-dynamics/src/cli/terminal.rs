//! The two streams of the program.

use std::io::{Result, Write};
use std::sync::atomic::AtomicU64;

use shared_geom::error::Explain;
use shared_geom::stream::Stream;

/// A piece of output that stays together.
pub(super) enum Message {
    /// Text for the output stream, unchanged.
    Shown(String),
    /// Makes all output so far visible.
    Flush,
    /// A line for the error stream.
    Report(String),
    /// A remark of a report, for the error stream if the report is not shown.
    Remark(String),
}

/// Output and error stream. A closed pipe discards everything without an error; the work
/// continues.
pub(super) struct Terminal<'a> {
    sink: Sink<'a>,
    /// Whether output was lost for another reason than a closed pipe.
    failed: bool,
    /// Whether the output stream takes nothing.
    quiet: bool,
    /// Remarks on units that are likely wrong, each with the name of the result: causes of failures.
    suspects: Vec<(String, String)>,
}

/// Destination of messages.
enum Sink<'a> {
    Streams {
        out: Stream<'a>,
        err: Stream<'a>,
    },
    /// To the thread that has the streams; with the progress of the work.
    Other {
        send: Box<dyn Fn(Message) + 'a>,
        part: &'a AtomicU64,
    },
}

impl<'a> Terminal<'a> {
    pub fn new(out: &'a mut dyn Write, err: &'a mut dyn Write) -> Self {
        Self {
            sink: Sink::Streams {
                out: Stream(out),
                err: Stream(err),
            },
            failed: false,
            quiet: false,
            suspects: Vec::new(),
        }
    }

    /// A terminal that sends its messages to the thread that has the streams. `part` is the
    /// progress of the work, out of `PARTS`.
    pub fn sending(send: Box<dyn Fn(Message) + 'a>, part: &'a AtomicU64) -> Self {
        Self {
            sink: Sink::Other { send, part },
            failed: false,
            quiet: false,
            suspects: Vec::new(),
        }
    }

    /// The progress to update, if the work runs in parallel with other work.
    pub fn part(&self) -> Option<&'a AtomicU64> {
        match &self.sink {
            Sink::Streams { .. } => None,
            Sink::Other { part, .. } => Some(part),
        }
    }

    /// Writes nothing more to the output stream, if `quiet`.
    pub fn set_quiet(&mut self, quiet: bool) {
        self.quiet = quiet;
    }

    /// Writes `text` unchanged.
    pub fn show(&mut self, text: &str) {
        self.take(Message::Shown(text.to_owned()));
    }

    /// Flushes the output so far, before a long computation.
    pub fn flush(&mut self) {
        self.take(Message::Flush);
    }

    /// Writes a line to the error stream, below all that was shown before. The error of a result names
    /// its remarks on units.
    pub fn report_text(&mut self, text: &str) {
        let own = |(name, _): &&(String, String)| {
            let rest = text.strip_prefix(&format!("error: {name}"));
            rest.is_some_and(|rest| rest.starts_with(':') || rest.starts_with(" at "))
        };
        let suspects = self.suspects.iter().filter(own);
        let cause =
            |(_, remark): &(String, String)| format!("; the cause may be a remark: {remark}");
        let causes: String = suspects.map(cause).collect();
        self.take(Message::Report(format!("{text}{causes}")));
    }

    /// Writes the remarks of a result to the error stream, if its report, which has them, is not
    /// shown.
    pub fn remark(&mut self, name: &str, remarks: &[String]) {
        for remark in remarks {
            let suspect = (name.to_owned(), remark.clone());
            if remark.contains("check the unit") && !self.suspects.contains(&suspect) {
                self.suspects.push(suspect);
            }
            self.take(Message::Remark(format!("warning: {name}: {remark}")));
        }
    }

    /// Writes a message, or passes it on.
    pub fn take(&mut self, message: Message) {
        let (out, err) = match &mut self.sink {
            Sink::Streams { out, err } => (out, err),
            Sink::Other { send, .. } => return send(message),
        };
        let results = match message {
            Message::Shown(_) if self.quiet => [Ok(()), Ok(())],
            Message::Shown(text) => [out.write_all(text.as_bytes()), Ok(())],
            Message::Flush => [out.flush(), Ok(())],
            Message::Report(text) => [out.flush(), writeln!(err, "{text}")],
            Message::Remark(text) if self.quiet => [Ok(()), writeln!(err, "{text}")],
            Message::Remark(_) => [Ok(()), Ok(())],
        };
        results.iter().for_each(|result| self.note(result));
    }

    /// Reports a problem, with its remedy.
    pub fn report(&mut self, problem: &impl Explain) {
        let help = problem
            .help()
            .map_or_else(String::new, |help| format!("\n  help: {help}"));
        self.report_text(&format!("error: {problem}{help}"));
    }

    /// Whether both streams took everything.
    pub fn finish(mut self) -> bool {
        if let Sink::Streams { out, err } = &mut self.sink {
            let result = out.flush().and_then(|()| err.flush());
            self.note(&result);
        }
        !self.failed
    }

    fn note(&mut self, result: &Result<()>) {
        if let Err(error) = result
            && !self.failed
        {
            self.failed = true;
            if let Sink::Streams { err, .. } = &mut self.sink {
                // If this fails too, there is no way to report it.
                let _ = writeln!(err, "error: the output cannot be written: {error}");
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Error, ErrorKind};

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
    fn failures_name_the_remarks_on_units() {
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let mut terminal = Terminal::new(&mut out, &mut err);
        for _ in 0..2 {
            let remarks = ["the chord is 391 m: check the unit", "another"].map(str::to_owned);
            terminal.remark("a", &remarks);
        }
        for text in ["error: ab: no step", "error: a at v = 3: no step"] {
            terminal.report_text(&format!("{text}\n  help: more steps"));
        }
        terminal.finish();
        let expected = "error: ab: no step\n  help: more steps\nerror: a at v = 3: no step\n  help: more steps; \
                        the cause may be a remark: the chord is 391 m: check the unit\n";
        assert_eq!(String::from_utf8(err).unwrap(), expected);
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
            let reported = String::from_utf8(err).unwrap();
            assert_eq!(reported.lines().count(), usize::from(!good), "{reported}");
        }
    }
}
