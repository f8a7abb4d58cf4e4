//! Messages about wrong files and failing runs: the examples of the book, causes of
//! failures, and files that nobody writes on purpose.

use super::Folder;

/// A page of the book.
pub fn page(name: &str) -> String {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/src/");
    std::fs::read_to_string(format!("{root}{name}")).unwrap()
}

/// The block of a page that begins with `head`, and the next block.
fn blocks(page: &str, head: &str) -> [String; 2] {
    let from = page.find(&format!("\n{head}")).unwrap() + 1;
    let (first, rest) = page[from..].split_once("\n```\n").unwrap();
    let (_, second) = rest.split_once("```text\n").unwrap();
    let (second, _) = second.split_once("\n```").unwrap();
    [format!("{first}\n"), second.to_owned()]
}

/// A text with each number as `#`: their last digits depend on the machine.
fn without_numbers(text: &str) -> String {
    let mut found = String::new();
    for word in text.split_inclusive([' ', '\n', ',', ';']) {
        let end = word.trim_end_matches([' ', '\n', ',', ';', 's', ':']);
        match end.parse::<f64>() {
            Ok(_) => found += &format!("#{}", &word[end.len()..]),
            Err(_) => found += word,
        }
    }
    found
}

#[test]
fn ten_mistakes_of_the_book_are_reported_at_once() {
    let folder = Folder::new();
    let [file, reported] = blocks(&page("dynamics-input.md"), "# ten mistakes");
    folder.write("crane.dynamics.toml", &file);
    let run = folder.run(&["check", "crane.dynamics.toml"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert_eq!(run.err.trim_end(), reported.trim_end());
    assert_eq!(reported.matches("error: crane.dynamics.toml:").count(), 10);
    // All problems with a similar known name suggest it.
    assert!(reported.matches("did you mean").count() >= 3, "{reported}");
}

#[test]
fn the_failure_of_the_book_is_reported() {
    let folder = Folder::new();
    let [file, reported] = blocks(&page("start-up.md"), "# a rod");
    folder.write("rod.dynamics.toml", &file);
    let run = folder.run(&["transient", "rod.dynamics.toml"]);
    assert_eq!(run.code, 1);
    // When the mechanism is locked, the outcome of the iteration is random.
    let comparable = |text: &str| -> Vec<String> {
        let text = text.replace("the iteration diverged", "the iteration did not converge");
        let lines = text.trim_end().lines().map(without_numbers);
        let lines = lines.map(|line| match line.split_once("and correction: ") {
            Some((head, _)) => head.to_owned(),
            None => line,
        });
        lines.collect()
    };
    assert_eq!(comparable(&run.err), comparable(&reported), "{}", run.err);
}

/// A cart of 1 kg on a rail along x at 1 m/s, and the name of its position.
const CART: &str = "units = \"SI\"
[[node]]
name = \"cart\"
position = [0, 0, 0]
velocity = [1, 0, 0]
[[node]]
name = \"mast\"
position = [1, 0, 0]
[[clamp]]
node = \"mast\"
[[body]]
node = \"cart\"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = \"rail\"
kind = \"total\"
nodes = [\"cart\"]
locked = [\"y\", \"z\", \"about x\", \"about y\", \"about z\"]
[[rigid]]
name = \"foot\"
nodes = [\"mast\", \"stone\"]
[[node]]
name = \"stone\"
position = [2, 0, 0]
[sensors.place]
quantity = \"position\"
of = \"cart\"
component = \"x\"
";

/// Loads and run of the cart, and the expected messages.
const FAILURES: &[(&str, &str, &[&str])] = &[
    (
        "[[load]]\nname = \"push\"\nnode = \"cart\"\nforce = [1, 0, 0]\ndrive = \"= place^2 + 1\"",
        "to = 10\nstep = 0.01",
        &[
            "the motion has grown beyond the model: node \"cart\"",
            "\"push\" acts on sensed quantities and feeds the motion",
            "the sign and the gain of the drive",
        ],
    ),
    (
        "[[load]]\nnode = \"cart\"\nforce = [1, 0, 0]\ndrive = \"= 1000*place\"",
        "to = 10\nstep = { first = 0.01, least = 1e-4 }",
        &[
            "the motion has grown beyond the model",
            "\"load 1\" acts on sensed quantities",
        ],
    ),
    (
        "[[load]]\nname = \"pull\"\nnode = \"cart\"\nforce = [1, 0, 0]\ndrive = \"= sqrt(0.5 - place)\"",
        "to = 2\nstep = 0.01",
        &[
            "without a value",
            "\"pull\" has no value at the sensed quantities there",
            "sqrt(max(0, ...))",
        ],
    ),
    (
        "[[load]]\nname = \"late\"\nnode = \"cart\"\nforce = [1, 0, 0]\ndrive = \"= sqrt(0.5 - t)\"",
        "to = 2\nstep = 0.01",
        &[
            "\"late\" has no value at 0.5",
            "at any position of the nodes",
            "end the run before",
        ],
    ),
    (
        "[[spring]]\nname = \"stop\"\nnode = \"cart\"\nlaw = { kind = \"table\", \
         points = { x = [[-1, -1], [0, 0], [0.3, 2]] }, outside = \"error\" }",
        "to = 2\nstep = 0.01",
        &[
            "\"stop\" has no value at the strain or rate there",
            "outside = \"extend\" or \"hold\"",
        ],
    ),
    (
        "[[load]]\nnode = \"cart\"\nforce = [1, 0, 0]\ndrive = \"= sin(1e4*sin(100*t))\"",
        "to = 2\nstep = { first = 0.01, least = 0.01, tolerance = 1e-8 }",
        &[
            "largest error: position along x of node \"cart\", off by",
            "the least step, 1.000e-2 s, is too long",
            "set \"least\" to",
        ],
    ),
    (
        "[[spring]]\nnode = \"cart\"\nlaw = { kind = \"cubic\", stiffness = [100, 1, 1], \
         cubic = [1e7, 1, 1] }",
        "to = 1\nstep = { first = 0.05, least = 0.05, tolerance = 1 }\nnewton = { iterations = 2 }",
        &[
            "worst equation: force balance along x of node \"cart\", off by",
            "was still converging when its 2 iterations were used up",
            "newton = { iterations = 15 }",
        ],
    ),
    (
        "[[load]]\nnode = \"cart\"\nforce = [1, 0, 0]\ndrive = \"= if(place > 0.3, -1e5, 1)\"",
        "to = 1\nstep = { first = 0.01, least = 0.002, tolerance = 1e-9 }",
        &[
            "the iteration oscillates",
            "\"load 1\"",
            "make the law smoother",
        ],
    ),
    (
        "[[load]]\nnode = \"cart\"\nforce = [1, 0, 0]\ndrive = \"= if(place > 0.3, -1000, 1)\"",
        "to = 1\nstep = { first = 0.01, least = 0.0005, tolerance = 1e-10 }",
        &[
            "a force or a stiffness jumps within the step",
            "\"load 1\" acts on sensed quantities",
        ],
    ),
    (
        "[[strip]]\nname = \"fin\"\nnode = \"cart\"\nfrom = [0, 0, 0]\nto = [0, 0, 1]\n\
         forward = [-1, 0, 0]\nsection = \"quasi_steady\"\nstations = [{ at = 0, chord = 0.1, \
         airfoil = \"naca0012\" }, { at = 1, chord = 0.1, airfoil = \"naca0012\" }]\n\
         [air.wind]\nspeed = \"= 260 + 2000*t\"",
        "to = 0.1\nstep = 0.001",
        &[
            "without a value",
            "\"fin/strip 1\" has no value: the flow has Mach 0.80",
            "and the table of airfoil \"NACA 0012\" is for Mach numbers from 0.15 to 0.8; add tables \
             of larger Mach numbers to its file, or outside_mach = \"hold\" to [air]",
        ],
    ),
    (
        "[[load]]\nnode = \"cart\"\nforce = [1e100, 0, 0]",
        "to = 1\nstep = 0.01",
        &["a mass, a load or another number of the model is unreasonably large"],
    ),
];

#[test]
fn failures_are_reported_with_their_cause_and_what_to_try() {
    let folder = Folder::new();
    for (acting, requested, expected) in FAILURES {
        folder.write(
            "a.dynamics.toml",
            &format!("{CART}{acting}\n[transient]\n{requested}\nredundant = \"remove\"\n"),
        );
        let run = folder.run(&["transient", "a.dynamics.toml"]);
        assert_eq!(run.code, 1, "{acting}\n{}{}", run.out, run.err);
        for part in *expected {
            assert!(run.err.contains(part), "{acting}\n{part}\n{}", run.err);
        }
        assert!(run.err.contains("\n  help: "), "{}", run.err);
    }
}

/// A pendulum.
const BOB: &str = "units = \"SI\"
[[node]]
name = \"bob\"
position = [1, 0, 0]
[[body]]
node = \"bob\"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = \"pin\"
kind = \"spherical\"
nodes = [\"bob\"]
at = [0, 0, 0]
[gravity]
acceleration = [0, 0, -9.81]
[transient]
to = 1
step = 0.01
[output]
every = 10
[[output.column]]
name = \"p\"
quantity = \"position\"
of = \"bob\"
";

/// A change of the pendulum, and the expected message.
const SLIPS: &[(&str, &str, &str)] = &[
    (
        "mass = 1",
        "mass = nan",
        ":7: \"mass\" is NaN, expected a mass, finite",
    ),
    (
        "mass = 1",
        "mass = \"NaN kg\"",
        ":7: \"mass\": \"NaN kg\" cannot be read, expected a number and a unit",
    ),
    (
        "mass = 1",
        "mass = -1",
        ":7: \"mass\" is -1, expected a mass greater than zero",
    ),
    ("mass = 1", "mass = \"1 kgg\"", "did you mean \"kg\"?"),
    (
        "to = 1\n",
        "from = 2\nto = 1\n",
        "\"to\" is 1 s, expected later than \"from\", which is 2 s",
    ),
    (
        "step = 0.01",
        "step = -0.01",
        "\"step\" is -0.01, expected a time greater than zero",
    ),
    (
        "step = 0.01",
        "step = 0",
        "\"step\" is 0, expected a time greater than zero",
    ),
    (
        "step = 0.01",
        "step = 1e-12",
        "the run would take 1e12 steps of 1e-12 s",
    ),
    (
        "to = 1\nstep = 0.01\n[output]\nevery = 10",
        "to = 1e6\nstep = 2e-3\n[output]",
        "the run would write 5e8 rows of 4 numbers, some 56 GB",
    ),
    (
        "every = 10",
        "every = 10\nvtu = 1\ncsv = false\nnetcdf = false",
        "accepted",
    ),
    ("to = 1\n", "to = 1e5\n", "accepted"),
    (
        "[transient]\n",
        "[transient]\nevery = 10\n",
        "did you mean \"every\" in [output]?",
    ),
    (
        "[transient]\n",
        "[transient]\nduration = 2\n",
        "did you mean \"to\", the last instant?",
    ),
    (
        "[transient]\n",
        "[transient]\ndt = 1e-3\n",
        "did you mean \"step\"?",
    ),
    (
        "[gravity]\n",
        "[gravity]\ng = 9.81\n",
        "did you mean acceleration = [0, 0, -9.81]?",
    ),
    (
        "[transient]\n",
        "[transient]\ntolerance = 1\n",
        "did you mean step = { first = ..., tolerance",
    ),
    (
        "[[joint]]\n",
        "[[node]]\nname = \"a\"\nat = [1, 0, 0]\n[[joint]]\n",
        "unknown key \"at\" in [[node]]",
    ),
    (
        "[[joint]]\n",
        "[[node]]\nname = \"a\"\nat = [1, 0, 0]\n[[joint]]\n",
        "did you mean \"position\"?",
    ),
    (
        "every = 10",
        "restart_every = 0.005",
        "\"restart_every\" is 0.005, expected a time above zero with its unit, or a number of steps",
    ),
    (
        "[[output.column]]",
        "[[column]]",
        "did you mean [[output.column]]?",
    ),
    (
        "[[joint]]",
        "[joint]",
        "\"joint\" is a table, expected tables [[joint]]",
    ),
    ("[[joint]]", "[[joints]]", "did you mean \"joint\"?"),
    (
        "[gravity]",
        "[sensor.a]\nquantity = \"position\"\n[gravity]",
        "did you mean [sensors.NAME]?",
    ),
    (
        "[gravity]",
        "[[repeat]]\nname = \"r\"\ncount = 1000000\naxis = [0, 0, 1]\n\
      [[repeat.node]]\nname = \"n\"\nposition = [1, 0, 0]\n[gravity]",
        "the copies of \"r\" come to more than 200000 cards",
    ),
    (
        "inertia = [1, 1, 1]\n",
        "",
        "a.dynamics.toml:3: node \"bob\" has no inertia",
    ),
];

#[test]
fn slips_are_reported_where_they_are_and_nothing_else() {
    let folder = Folder::new();
    for (old, new, expected) in SLIPS {
        assert!(BOB.contains(old), "{old}");
        folder.write("a.dynamics.toml", &BOB.replace(old, new));
        let run = folder.run(&["check", "a.dynamics.toml"]);
        if *expected == "accepted" {
            assert_eq!(run.code, 0, "{new}: {}", run.err);
            continue;
        }
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{new}: {}", run.err);
        assert!(run.err.contains(expected), "{new}: {}", run.err);
        assert!(run.err.matches("error:").count() <= 2, "{new}: {}", run.err);
    }
}

// Line ends of another system, a byte order mark, no end of the last line, letters that are
// not ASCII: the same numbers. An empty file, and one that is not text.
#[test]
fn files_may_be_written_elsewhere() {
    let folder = Folder::new();
    let rows = |text: &str| {
        folder.write("a.dynamics.toml", text);
        let run = folder.run(&["transient", "a.dynamics.toml"]);
        assert_eq!(run.code, 0, "{}", run.err);
        folder.read("results/a.transient.csv")
    };
    let expected = rows(BOB);
    for text in [
        BOB.replace('\n', "\r\n"),
        format!("\u{feff}{BOB}"),
        BOB.trim_end().to_owned(),
        BOB.replace("bob", "the b\u{f6}b of the pendulum"),
    ] {
        assert_eq!(rows(&text), expected, "{text}");
    }
    folder.write("a.dynamics.toml", "");
    let run = folder.run(&["transient", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("the file has no \"units\""), "{}", run.err);
    std::fs::write(folder.path("a.dynamics.toml"), [0xff, 0xfe, 0]).unwrap();
    let run = folder.run(&["transient", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("not a text file"), "{}", run.err);
}

// A pin removes the velocity along the arm and gives the bob the rotation that belongs to
// the other component; weights of 1e-8 of unspecified velocities leave an error of the same
// size.
#[test]
fn changes_of_a_start_that_does_not_fit_are_reported() {
    let folder = Folder::new();
    let thrown = BOB.replace("[[body]]", "velocity = [1, -1, 0]\n[[body]]");
    folder.write("a.dynamics.toml", &thrown);
    let run = folder.run(&["transient", "a.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    for part in [
        "\nChanged at the start to fulfill the joints\n",
        "  velocity of node \"bob\" along x: from 1 to 0 m/s\n",
        "  angular velocity of node \"bob\" about z: from 0 to -0.99999",
    ] {
        assert!(run.out.contains(part), "{part}\n{}", run.out);
    }
}

/// Mistakes that point to the right table, number or drive.
#[test]
fn near_mistakes_are_reported_with_their_remedy() {
    let folder = Folder::new();
    let reported = |cards: &str| {
        let text = super::loads::STRIP.to_owned() + cards;
        folder.write("a.dynamics.toml", &text);
        folder.run(&["check", "a.dynamics.toml"]).err
    };
    let mode = reported("[mode]\nspeeds = 0\n");
    let expected = "unknown key \"mode\" in the file\n  help: did you mean [modes]?";
    assert!(mode.contains(expected), "{mode}");
    let ramp = reported("[modes]\nspeeds = 0\n[drives.up]\nkind = \"ramp\"\nto = 1\n");
    let expected = "drives \"up\" has none of \"end\" and \"duration\", expected one";
    assert!(ramp.contains(expected), "{ramp}");
    let run = folder.run(&["modes", "a.json", "--speeds", "0-8"]);
    assert_eq!(run.code, 2);
    let expected = "expected rotation speeds with commas between, as in 0,4,8";
    assert!(run.err.contains(expected), "{}", run.err);
}

/// A swept, twisted blade under a follower load.
pub const SWEPT: &str = "\
units = \"SI\"
[properties.p]
ea = 1e6
gay = 1e5
gaz = 1.2e5
gj = 100
eiy = 110
eiz = 300
m = 1.1
iy = 1e-3
iz = 2e-3
damping = { time = 5e-3 }
[[blade]]
name = \"b\"
properties = \"p\"
precone = 5
[[blade.piece]]
length = 1.5
elements = 4
sweep = 10
twist = [0, 20]
[[load]]
node = \"b/tip\"
force = [5, 10, 20]
offset = [0, 0.05, 0]
follower = true
[gravity]
acceleration = [0, 0, -9.81]
[transient]
to = 0.2
step = 1e-3
scheme = \"gauss\"
";

// Before the run and by `check`, since the iteration would diverge at every step.
#[test]
fn a_scheme_that_cannot_enforce_constraints_is_refused() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", SWEPT);
    for command in ["transient", "check"] {
        let run = folder.run(&[command, "a.dynamics.toml"]);
        assert_eq!(run.code, 2, "{}{}", run.out, run.err);
        let expected = "\"scheme\" is \"gauss\", which cannot enforce constraints";
        assert!(run.err.contains(expected), "{}", run.err);
    }
}

/// Each file of another kind names the program that reads it, or the name that it needs.
#[test]
fn files_of_another_kind_name_their_program() {
    let folder = Folder::new();
    folder.write("e.section.toml", "units = \"SI\"\nmesh = \"r.msh\"\n");
    folder.write("r.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    let blade = "units = \"SI\"\nframe = \"helicoid\"\n[line]\nlength = 1\n";
    folder.write("blade.toml", blade);
    for (file, found, help) in [
        (
            "e.section.toml",
            "a section file",
            "use \"section-analyzer analyze\"",
        ),
        (
            "r.msh",
            "a mesh",
            "name the mesh in a section file, NAME.section.toml",
        ),
        ("blade.toml", "a blade file", "call it NAME.blade.toml"),
    ] {
        let run = folder.run(&["modes", file]);
        assert_eq!(run.code, 2, "{}", run.err);
        let start = format!("error: {file}: this is {found}, expected a ");
        assert!(run.err.starts_with(&start), "{}", run.err);
        assert!(
            run.err.contains(&format!("\n  help: {help}")),
            "{}",
            run.err
        );
        assert_eq!(run.err.lines().count(), 2, "{}", run.err);
    }
}

/// A file with keys of no dynamics file is one problem, not one for each key.
#[test]
fn a_file_without_a_key_of_dynamics_files_is_reported_as_such() {
    let folder = Folder::new();
    folder.write(
        "expected.toml",
        "# results\n[[value]]\ncolumn = \"x\"\n[run]\n",
    );
    let run = folder.run(&["modes", "expected.toml"]);
    assert_eq!(
        (run.code, run.err.as_str()),
        (
            2,
            "error: expected.toml:2: this is no dynamics file: it has no key of one, and begins \
             with \"value\"\n"
        )
    );
}

/// Wrong values of options are reported with the names of the options.
#[test]
fn options_of_blade_files_are_named() {
    let folder = Folder::new();
    let file = "strip.properties.json";
    for (options, expected) in [
        (
            ["--count", "all"],
            "invalid value 'all' for '--count <N>': expected a whole number, 1 or more",
        ),
        (
            ["--blades", "0"],
            "invalid value '0' for '--blades <N>': expected a whole number, 1 or more",
        ),
        (
            ["--hub-radius", "-3"],
            "strip.properties.json: --hub-radius is -3, expected",
        ),
        (
            ["--count", "20000"],
            "strip.properties.json: --count is 20000, expected at most",
        ),
        (
            ["--speeds", "5,5"],
            "strip.properties.json: --speeds has the speed 5 rpm twice",
        ),
    ] {
        let all = [&["modes", file, "--length", "1"][..], &options].concat();
        let run = folder.run(&all);
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(
            run.err.contains(expected),
            "{expected} is not in\n{}",
            run.err
        );
    }
    folder.write("a.dynamics.toml", SWEPT);
    let run = folder.run(&["transient", "a.dynamics.toml", "./a.dynamics.toml"]);
    let expected = "\"./a.dynamics.toml\" is given twice, expected it once";
    assert!(run.err.contains(expected), "{}", run.err);
}

/// Mistakes with a known meaning, each with its remedy.
#[test]
fn meanings_of_mistakes_are_reported() {
    let folder = Folder::new();
    for (old, new, expected) in [
        (
            "damping = { time = 5e-3 }",
            "damping = 0.01",
            "\"damping\" is 0.01, expected a table with one of \"time\" and \"matrix\", as in { time = 1e-3 }",
        ),
        (
            "[gravity]",
            "[hub]\nspeed = 100\n[gravity]",
            "unknown key \"speed\" in [hub]\n  help: did you mean \"speeds\" in [modes], or \
             \"speed\" in [static] or [transient]?",
        ),
        (
            "force = [5, 10, 20]",
            "force = [5, 10, 1e300]",
            "expected a force, at most 1e100 in magnitude",
        ),
        (
            "[gravity]",
            "[[joint]]\nnodes = [\"b/tip\"]\nkind = \"hinge\"\n[gravity]",
            "  help: did you mean \"revolute\"?",
        ),
        (
            "ea = ",
            "file = \"r.json\"\n# ",
            "properties \"p\" has \"file\" and \"gay\", expected a file or numbers in the card",
        ),
    ] {
        let changed = SWEPT.replacen(old, new, 1);
        assert_ne!(changed, SWEPT);
        folder.write("a.dynamics.toml", &changed);
        let run = folder.run(&["check", "a.dynamics.toml"]);
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(
            run.err.contains(expected),
            "{expected} is not in\n{}",
            run.err
        );
    }
}

/// A property file that is something else names the card.
#[test]
fn the_card_of_a_wrong_property_file_is_named() {
    let folder = Folder::new();
    folder.write("r.json", "$MeshFormat\n");
    let text = "units = \"SI\"\n[properties.q]\nfile = \"r.json\"\n";
    folder.write("a.dynamics.toml", text);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    let expected = "error: r.json:1: not a property file: it is not JSON (named by \"file\" of \
                    properties \"q\", a.dynamics.toml:3)\n";
    assert!(run.err.contains(expected), "{}", run.err);
}

/// A table without time, and missing files with near names.
#[test]
fn tables_and_files_are_recognized() {
    let folder = Folder::new();
    folder.write("fan.csv", "speed_rpm,frequency_hz\n0,1\n100,2\n");
    let run = folder.run(&["plot", "fan.csv"]);
    let expected = "error: \"fan.csv\" is not a table of a run: it has no column \"time\"\n  help: \
                    name a table that \"beam-dynamics transient\" wrote";
    assert!(run.err.starts_with(expected), "{}", run.err);
    folder.write("blade.dynamics.toml", SWEPT);
    let run = folder.run(&["check", "blad.dynamics.toml"]);
    let expected = "blad.dynamics.toml: cannot be read: no such file\n  help: did you mean \
                    \"blade.dynamics.toml\"?\n";
    assert!(run.err.ends_with(expected), "{}", run.err);
}

/// A pendulum: one node in a summary, its joint and its spring.
#[test]
fn summaries_count_joints_and_springs() {
    let folder = Folder::new();
    let text = "units = \"SI\"\n[[node]]\nname = \"m\"\nposition = [1, 0, 0]\n[[body]]\n\
                node = \"m\"\nmass = 2\ninertia = [1, 1, 1]\n[[joint]]\nnodes = [\"m\"]\nkind = \"spherical\"\n\
                at = [0, 0, 0]\n[transient]\nto = 0.01\nstep = 1e-3\n[gravity]\n\
                acceleration = [0, 0, -9.81]\n";
    folder.write("a.dynamics.toml", text);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    let expected = "a.dynamics.toml: 1 node, 0 beams, 1 body, 1 joint, mass 2 kg\n";
    assert!(run.out.starts_with(expected), "{}{}", run.out, run.err);
    let run = folder.run(&["transient", "a.dynamics.toml", "--no-figures"]);
    assert!(
        run.out.contains("\n1 node, 15 unknowns, 3 of them"),
        "{}{}",
        run.out,
        run.err
    );
}
