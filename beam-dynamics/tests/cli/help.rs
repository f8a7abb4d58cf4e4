//! Completion scripts and manual pages.

use super::*;

#[test]
fn completions_know_commands_and_options() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = folder.run(&["completions", shell]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{shell}");
        for word in ["transient", "hub-radius", "restart"] {
            assert!(run.out.contains(word), "{shell}: {word}");
        }
    }
    assert_eq!(folder.run(&["completions", "cmd"]).code, 2);
}

/// A page for each command, with the file name that `man` expects and the text of the help.
#[test]
fn the_manual_has_a_page_for_each_command() {
    let folder = Folder::new();
    let run = folder.run(&["manual", "--out", "man1"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for (page, word) in [
        ("beam-dynamics", "beam\\-dynamics\\-modes(1)"),
        ("beam-dynamics-transient", "restart.json"),
        ("beam-dynamics-manual", "one for each command"),
    ] {
        let text = folder.read(&format!("man1/{page}.1"));
        let heading = format!(
            ".TH {page} 1  \"beam-dynamics {}\"",
            env!("CARGO_PKG_VERSION")
        );
        assert!(text.contains(&heading), "{text}");
        assert!(text.contains(word), "{page}: {text}");
    }
    let pages = fs::read_dir(folder.path("man1")).unwrap().count();
    let printed = folder.run(&["manual"]).out;
    assert_eq!(printed.matches("\n.TH ").count(), pages);
    let listed = run.out.lines().filter(|line| line.ends_with(".1")).count();
    assert_eq!(listed, pages);
    folder.write("file", "");
    let run = folder.run(&["manual", "--out", "file/man1"]);
    assert_eq!(run.code, 2);
    let message = "error: folder \"file/man1\" cannot be made";
    assert!(run.err.starts_with(message), "{}", run.err);
}
