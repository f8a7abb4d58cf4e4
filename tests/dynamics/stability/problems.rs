//! Wrong cards of `[stability]` are reported with their remedy.

use beam_dynamics::case::Words;

/// The problems of a mass on springs with these analyses.
fn problems(analyses: &str) -> String {
    let text = format!(
        "units = \"SI\"\n[parameters]\nk = 50\nspeed = 0\n\
         [[node]]\nname = \"mass\"\nposition = [0, 0, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
         [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [\"= k\", 50, 50]\n\
         rotational_stiffness = [1, 1, 1]\n{analyses}"
    );
    let parsed = beam_dynamics::input::parse(&text, "model.dynamics.toml");
    parsed.unwrap_err().to_string()
}

const MODES: &str = "[modes]\nspeeds = [0]\n";
const K: &str = "[modes]\nspeeds = [0]\n[stability]\nparameter = \"k\"\n";
const VALUES: &str = "values = [1, 2]\n";

#[test]
fn wrong_cards_are_reported() {
    let trim = "[trim]\nmethod = \"equilibrium\"\nspeed = 30\n[[trim.control]]\nname = \"k\"\n\
                [[trim.target]]\nname = \"one\"\nsignal = \"= 1\"\nvalue = 1\n";
    let cases = [
        (
            format!("{MODES}[stability]\nparameter = \"kk\"\n{VALUES}"),
            "\"kk\" is not one of the [parameters]\n  help: did you mean \"k\"?",
        ),
        (K.to_owned(), "the values of the sweep are given by nothing"),
        (
            format!("{MODES}[stability]\nparameter = \"k\"\nvalues = [1, 3, 2]\n"),
            "the values are 3 and then 2, expected values that all increase or all decrease\n  \
             help: sort the values",
        ),
        (
            format!("[stability]\nparameter = \"k\"\n{VALUES}{MODES}")
                .replace("[modes]", "[static]")
                .replace("speeds = [0]\n", ""),
            "\"by\" is \"modes\", which needs [modes]\n  help: add [modes]",
        ),
        (
            format!("{MODES}[stability]\nparameter = \"k\"\nby = \"Floquet\"\n{VALUES}"),
            "\"by\" is \"Floquet\", which needs [periodic]\n  help: add [periodic]",
        ),
        (
            format!("[modes]\nspeeds = [0, 9]\n[stability]\nparameter = \"k\"\n{VALUES}"),
            "[modes] has 2 speeds, expected one\n  help: write one speed",
        ),
        (
            format!("{trim}{MODES}[stability]\nparameter = \"speed\"\n{VALUES}")
                .replace("speed = 30", "speed = \"= 30 + 0*speed\""),
            "[modes] has the speed 0 rpm, but the equilibrium of [trim] has 30 rpm, expected the \
             same\n  help: write one speed in both",
        ),
        (
            format!("{trim}{MODES}[stability]\nparameter = \"k\"\n{VALUES}"),
            "the parameter \"k\" is a control of [trim] too\n  help: remove the control",
        ),
        (format!("{K}{VALUES}tolerance = 0\n"), "\"tolerance\" is 0"),
        (
            format!("{K}{VALUES}by = \"floquet\"\n"),
            "\"by\" is \"floquet\"",
        ),
        (
            format!("{trim}{MODES}"),
            "beside [modes], which does not find the controls",
        ),
    ];
    for (analyses, expected) in cases {
        let shown = problems(&analyses);
        assert!(shown.contains(expected), "{analyses}\n{shown}");
        assert!(shown.contains("model.dynamics.toml:"), "{shown}");
    }
}

// A motion with a period needs no modes, but words for their names; eigenvalues about an equilibrium need their
// speed.
#[test]
fn modes_of_a_period_may_have_words_alone() {
    let text = |by: &str, keys: &str| {
        format!(
            "units = \"SI\"\n[parameters]\nk = 50\n[[node]]\nname = \"mass\"\nposition = [0, 0, 0]\n\
             [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
             [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [\"= k\", 50, 50]\n\
             rotational_stiffness = [1, 1, 1]\n[periodic]\nspeed = 30\n[modes]\n{keys}\
             [stability]\nparameter = \"k\"\nby = \"{by}\"\n{VALUES}"
        )
    };
    let read = |by: &str, keys: &str| {
        beam_dynamics::input::parse(&text(by, keys), "model.dynamics.toml")
            .map_err(|it| it.to_string())
    };
    let input = read("Floquet", "words = \"wind\"\n").unwrap();
    assert_eq!(input.words(), Words::Wind);
    assert!(input.modes.is_none());
    // The words are accepted here too, but the model has no rotor.
    let shown = read("averaged", "words = \"wind\"\n").unwrap_err();
    let expected = "but the model has 0 blades, expected at least three";
    assert!(
        shown.contains(expected) && !shown.contains("speeds"),
        "{shown}"
    );
    for (by, keys) in [
        ("modes", "words = \"wind\"\n"),
        ("averaged", "words = \"wind\"\ncount = 3\n"),
    ] {
        let shown = read(by, keys).unwrap_err();
        assert!(shown.contains("[modes] has no \"speeds\""), "{shown}");
    }
}
