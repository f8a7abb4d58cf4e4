//! The program; see `beam_dynamics::cli`.

fn main() -> std::process::ExitCode {
    let (mut out, mut err) = (std::io::stdout().lock(), std::io::stderr().lock());
    beam_dynamics::cli::run(std::env::args_os(), &mut out, &mut err).into()
}
