//! A separate folder for each test, and runs of the program in it.

use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

/// Two adjacent square cells, each in its own surface, and a line.
///
/// ```text
///   4 ---- 5 ---- 6      cell 11 (nodes 1 2 5 4) in "skin"
///   |  11  |  12  |      cell 12 (nodes 2 3 6 5) in "web"
///   1 ---- 2 ---- 3      line 13 (nodes 1 2) in "edge"
/// ```
pub const TWO_CELLS: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
2 1 \"skin\"
2 2 \"web\"
1 3 \"edge\"
1 4 \"bare\"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
$EndNodes
$Elements
3
11 3 2 1 1 1 2 5 4
12 3 2 2 2 2 3 6 5
13 1 2 3 1 1 2
$EndElements
";

/// A section of [`TWO_CELLS`] without any problem. Lines are counted in the tests: keep
/// them.
pub const SECTION: &str = "\
mesh = \"two.msh\"

[units]
length = \"mm\"
stress = \"GPa\"

[material.steel]
young = 210
poisson = 0.3
density = \"7850 kg/m^3\"

[[region]]
group = \"skin\"
material = \"steel\"

[[region]]
group = \"web\"
material = \"steel\"
fiber_angle = 0
plane_angle = 0
";

/// A folder with the files of one test.
pub struct Workplace {
    folder: TempDir,
}

/// Results of a run of the program.
pub struct Run {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Workplace {
    pub fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        Self { folder }
    }

    /// A folder with [`TWO_CELLS`] and [`SECTION`] as `two.msh` and `a.section.toml`, in
    /// which each pair of texts has been replaced.
    pub fn with(section_changes: &[(&str, &str)], mesh_changes: &[(&str, &str)]) -> Self {
        let workplace = Self::new();
        workplace.write("a.section.toml", &changed(SECTION, section_changes));
        workplace.write("two.msh", &changed(TWO_CELLS, mesh_changes));
        workplace
    }

    pub fn path(&self, file: &str) -> PathBuf {
        self.folder.path().join(file)
    }

    pub fn write(&self, file: &str, text: &str) {
        std::fs::write(self.path(file), text).unwrap();
    }

    pub fn read(&self, file: &str) -> String {
        std::fs::read_to_string(self.path(file)).unwrap()
    }

    /// The program in this folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_section-analyzer"));
        command.current_dir(self.folder.path()).args(arguments);
        command.stdin(Stdio::null());
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Run {
        let Output {
            status,
            stdout,
            stderr,
        } = self.command(arguments).output().unwrap();
        Run {
            code: status.code().unwrap(),
            out: String::from_utf8(stdout).unwrap(),
            err: String::from_utf8(stderr).unwrap(),
        }
    }

    /// Checks that the section is refused with exactly these lines, by `check` and
    /// by `analyze` alike, and that nothing is written.
    pub fn is_refused(&self, expected: &[&str]) {
        for command in ["check", "analyze"] {
            let run = self.run(&[command, "a.section.toml"]);
            assert_eq!(run.err.lines().collect::<Vec<_>>(), expected, "{command}");
            assert_eq!((run.code, run.out.as_str()), (2, ""), "{command}");
        }
        assert!(!self.path("results").exists());
    }
}

/// The text with replacements, each of which must apply exactly once.
fn changed(text: &str, changes: &[(&str, &str)]) -> String {
    let mut text = text.to_owned();
    for (from, to) in changes {
        assert_eq!(text.matches(from).count(), 1, "\"{from}\"");
        text = text.replacen(from, to, 1);
    }
    text
}
