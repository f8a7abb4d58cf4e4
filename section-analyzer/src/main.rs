//! The program; see `section_analyzer::cli`.

fn main() -> std::process::ExitCode {
    let (mut out, mut err) = (std::io::stdout().lock(), std::io::stderr().lock());
    section_analyzer::cli::run(std::env::args_os(), &mut out, &mut err).into()
}
