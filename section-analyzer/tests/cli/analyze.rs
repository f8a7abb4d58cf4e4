//! Good runs, and analyses that fail.

use std::path::Path;

use crate::workplace::Workplace;

/// A strip of aluminum, 1 x 0.063 in.
const STRIP: &str = "\
name = \"strip of aluminum\"
mesh = \"strip.msh\"
[units]
length = \"in\"
force = \"lbf\"
[material.aluminum]
young = 10.6e6
poisson = 0.325
density = \"2.51e-4 lbf*s^2/in^4\"
[material.spare]
young = 1
poisson = 0
density = 1
[[region]]
group = \"section\"
material = \"aluminum\"
";

fn strip() -> Workplace {
    let workplace = Workplace::new();
    workplace.write("strip.section.toml", STRIP);
    let size = ["mesh", "rectangle", "--width", "1", "--height", "0.063"];
    let cells = ["--cells-y", "16", "--cells-z", "2", "--out", "strip.msh"];
    let run = workplace.run(&[&size[..], &cells].concat());
    assert_eq!(
        run.out,
        "strip.msh: 165 nodes, 32 cells\n  physical surface: section\n  \
         physical curves: bottom, right, top, left\n"
    );
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    workplace
}

#[test]
fn all_files_are_written_and_listed() {
    let workplace = strip();
    let run = workplace.run(&["analyze", "strip.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let report = workplace.read("results/strip.report.txt");
    let list = "\nWritten\n  results/strip.properties.json\n  results/strip.report.txt\n  \
        results/strip.areas.csv\n  results/strip.constants.csv\n  \
        results/strip.mesh.png\n  results/strip.mesh.svg\n  results/strip.warping.png\n  \
        results/strip.warping.svg\n  \
        results/strip.warping.vtu\n  results/strip.analysis.json\n";
    assert_eq!(run.out, report + list);
    for figure in ["results/strip.mesh.png", "results/strip.warping.png"] {
        let bytes = std::fs::read(workplace.path(figure)).unwrap();
        assert_eq!(&bytes[..4], b"\x89PNG");
        // width in the header of the file
        assert_eq!(bytes[16..20], 1800_u32.to_be_bytes());
    }
    let grid = workplace.read("results/strip.warping.vtu");
    assert!(grid.starts_with("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\""));
}

/// EA = E A, EI = E I of the strip in SI: 1 in = 0.0254 m, 1 psi = 6894.757293168 Pa.
/// Biquadratic cells represent the linear strains of extension and bending exactly, so
/// that only round-off remains: 1e-11.
#[test]
fn property_file_holds_the_properties() {
    let workplace = strip();
    assert_eq!(
        workplace
            .run(&["analyze", "strip.section.toml", "--out", "deep/down"])
            .code,
        0
    );
    let properties =
        shared_geom::section::read(&workplace.path("deep/down/strip.properties.json")).unwrap();
    let (width, height, young) = (0.0254, 0.063 * 0.0254, 10.6e6 * 6_894.757_293_168_361);
    let stiffness = properties.stiffness;
    let near = |found: f64, expected: f64| {
        assert!((found / expected - 1.0).abs() < 1e-11, "{found} {expected}")
    };
    near(stiffness[(0, 0)], young * width * height);
    near(stiffness[(4, 4)], young * width * height.powi(3) / 12.0);
    near(stiffness[(5, 5)], young * width.powi(3) * height / 12.0);
    // density: 1 lbf s^2/in^4 = 4.4482216152605 / 0.0254^4 kg/m^3
    let density = 2.51e-4 * 4.448_221_615_260_5 / 0.0254_f64.powi(4);
    near(properties.mass[(0, 0)], density * width * height);
    assert_eq!(properties.name, "strip of aluminum");
    assert_eq!(
        (properties.provenance.nodes, properties.provenance.cells),
        (165, 32)
    );
}

/// One row per region and one for the sum: A = b h, Izz = h b^3/12 and so on of the strip
/// in SI, to round-off; every number with all its digits. Gamma of a strip is
/// `b^3 h^3/144` except for its ends, 4.8 (h/b)^2 = 2 % of it.
#[test]
fn tables_hold_areas_and_constants() {
    let index = strip();
    assert_eq!(index.run(&["analyze", "strip.section.toml"]).code, 0);
    let (b, h) = (0.0254_f64, 0.063 * 0.0254_f64);

    let areas = index.read("results/strip.areas.csv");
    let rows: Vec<Vec<&str>> = areas
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 3);
    assert_eq!((rows[1][0], rows[2][0]), ("section", "total"));
    assert_eq!(rows[1][1..], rows[2][1..]);
    let column = |name: &str| {
        let index = rows[0].iter().position(|heading| *heading == name);
        rows[2][index.unwrap_or_else(|| panic!("no column {name}"))]
            .parse::<f64>()
            .unwrap()
    };
    for (name, expected) in [
        ("cells", 32.0),
        ("area [m^2]", b * h),
        ("iyy [m^4]", b * h.powi(3) / 12.0),
        ("central_izz [m^4]", b.powi(3) * h / 12.0),
        ("perimeter [m]", 2.0 * (b + h)),
        ("outer_perimeter [m]", 2.0 * (b + h)),
    ] {
        let found = column(name);
        assert!((found / expected - 1.0).abs() < 1e-12, "{name}: {found}");
    }
    assert_eq!((column("holes"), column("hole_perimeter [m]")), (0.0, 0.0));

    let constants = index.read("results/strip.constants.csv");
    assert!(constants.starts_with("shear_flow_center_y [m],shear_flow_center_z [m],"));
    let rows: Vec<Vec<&str>> = constants
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    let mut columns = rows[0].iter().zip(&rows[1]);
    let gamma = columns.find(|(name, _)| **name == "warping_constant [m^6]");
    let gamma = gamma.and_then(|(_, value)| value.parse::<f64>().ok());
    let gamma = gamma.unwrap_or_else(|| panic!("{constants}"));
    let ends = 1.0 - gamma / ((b * h).powi(3) / 144.0);
    assert!((ends / (4.8 * (h / b).powi(2)) - 1.0).abs() < 0.1, "{ends}");
}

/// A ply has no constants of restrained warping: the report states the reason, and the
/// table of an earlier run is removed.
#[test]
fn anisotropic_sections_have_no_constants() {
    let workplace = strip();
    assert_eq!(workplace.run(&["analyze", "strip.section.toml"]).code, 0);
    assert!(workplace.path("results/strip.constants.csv").exists());
    let ply = "e1 = 2e7\ne2 = 1e6\ne3 = 1e6\ng12 = 7e5\ng13 = 7e5\ng23 = 4e5\n\
        nu12 = 0.3\nnu13 = 0.3\nnu23 = 0.4";
    let text = STRIP.replace("young = 10.6e6\npoisson = 0.325", ply);
    workplace.write("strip.section.toml", &text);
    let run = workplace.run(&["analyze", "strip.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(
        run.out.contains(
            "\nRestrained warping\n  not given: material \"aluminum\" is not isotropic; "
        ),
        "{}",
        run.out
    );
    let removed = "\nRemoved: results of an earlier run\n  results/strip.constants.csv\n";
    assert!(run.out.ends_with(removed), "{}", run.out);
    assert!(!workplace.path("results/strip.constants.csv").exists());
}

#[test]
fn report_says_what_went_in_and_in_which_axes() {
    let workplace = strip();
    let report = workplace.run(&["analyze", "strip.section.toml"]).out;
    for line in [
        "Section \"strip of aluminum\"",
        "  mesh      strip.msh: 165 nodes, 32 quadrilaterals with 9 nodes",
        "  remark: material \"spare\" (line 10) is used by no region",
        "  Components: axial, shear y, shear z, torsion, bending y, bending z.",
        "  section  aluminum  -            -               32  4.06451e-5   1.09027e-1",
        "  tension  0  0  an axial force here causes no bending",
        "  none above 1e-6",
    ] {
        assert!(
            report.lines().any(|found| found == line),
            "\"{line}\" is not in\n{report}"
        );
    }
    assert!(report.lines().all(|line| line.chars().count() <= 110));
}

#[test]
fn runs_repeat_to_the_last_digit_and_inputs_have_a_fingerprint() {
    let workplace = strip();
    let hash = |workplace: &Workplace| {
        let properties =
            shared_geom::section::read(&workplace.path("results/strip.properties.json"));
        properties.unwrap().provenance.input_hash
    };
    assert_eq!(workplace.run(&["analyze", "strip.section.toml"]).code, 0);
    let (first, first_hash) = (
        workplace.read("results/strip.properties.json"),
        hash(&workplace),
    );
    let again = workplace.run(&["analyze", "strip.section.toml", "--force"]);
    assert!(again.out.contains("\nWritten\n"), "{}", again.out);
    assert_eq!(workplace.read("results/strip.properties.json"), first);
    let mesh = workplace.read("strip.msh");
    workplace.write("strip.msh", &(mesh + "\n"));
    assert_eq!(workplace.run(&["analyze", "strip.section.toml"]).code, 0);
    assert_ne!(hash(&workplace), first_hash);
    assert!(first_hash.starts_with("sha256:"));
}

#[test]
fn check_prints_what_was_read_and_writes_nothing() {
    let workplace = strip();
    let run = workplace.run(&["check", "strip.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.starts_with("Section \"strip of aluminum\"\n"));
    assert!(run.out.ends_with("\nNo problem found\n"));
    assert!(!workplace.path("results").exists());
}

#[test]
fn every_shape_and_kind_of_cell_gives_a_section() {
    let workplace = Workplace::new();
    let shapes: [(&str, &[&str], &str); 3] = [
        (
            "rectangle",
            &[
                "--width",
                "2",
                "--height",
                "1",
                "--cells-y",
                "4",
                "--cells-z",
                "2",
            ],
            "section",
        ),
        (
            "tube",
            &[
                "--outer-radius",
                "2",
                "--thickness",
                "0.5",
                "--cells-around",
                "12",
                "--cells-through",
                "1",
            ],
            "wall",
        ),
        (
            "ellipse",
            &[
                "--semi-y",
                "2",
                "--semi-z",
                "1",
                "--cells",
                "1",
                "--straight",
            ],
            "section",
        ),
    ];
    for (shape, sizes, group) in shapes {
        let section = STRIP
            .replace("strip.msh", "a.msh")
            .replace("\"section\"", &format!("\"{group}\""));
        workplace.write("a.section.toml", &section);
        for cell in ["tri3", "tri6", "quad4", "quad8", "quad9"] {
            let out = ["--out", "a.msh", "--force"];
            let arguments = [&["mesh", shape, "--cell", cell], &out[..], sizes].concat();
            assert_eq!(workplace.run(&arguments).code, 0, "{shape} {cell}");
            let run = workplace.run(&["check", "a.section.toml"]);
            assert_eq!((run.code, run.err.as_str()), (0, ""), "{shape} {cell}");
        }
    }
}

/// A file instead of the results folder is reported before anything is solved.
#[test]
fn results_need_a_folder() {
    let workplace = strip();
    let run = workplace.run(&["analyze", "strip.section.toml", "--out", "strip.msh"]);
    assert_eq!(
        run.err,
        "error: folder \"strip.msh\" cannot be made: a file of this name exists\n  \
         help: name another folder with --out\n"
    );
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(Path::new(&workplace.path("strip.msh")).is_file());
}

/// A folder at the path of a result file is reported as text, for texts and figures.
#[test]
fn files_that_cannot_be_written_end_with_one() {
    for (file, what) in [
        ("strip.report.txt", "file"),
        ("strip.warping.png", "file"),
        ("strip.warping.vtu", "file"),
    ] {
        let workplace = strip();
        std::fs::create_dir_all(workplace.path("results").join(file)).unwrap();
        let run = workplace.run(&["analyze", "strip.section.toml"]);
        let expected =
            format!("error: {what} \"results/{file}\" cannot be written: it is a folder\n");
        assert_eq!((run.code, run.err), (1, expected));
    }
}

/// A wall thickness of one hundred-thousandth of the radius in 48 cells exceeds the
/// accuracy. The position is reported with few digits, and the remedy mentions thin
/// walls.
#[test]
fn a_wall_too_thin_to_solve_is_reported_with_its_remedy() {
    let workplace = Workplace::with(
        &[
            ("two.msh", "tube.msh"),
            ("\"skin\"", "\"wall\""),
            (
                "\n[[region]]\ngroup = \"web\"\nmaterial = \"steel\"\nfiber_angle = 0\nplane_angle = 0\n",
                "",
            ),
        ],
        &[],
    );
    let sizes = ["mesh", "tube", "--outer-radius", "1", "--thickness", "1e-6"];
    let cells = ["--cells-around", "48", "--cells-through", "1", "--out"];
    workplace.run(&[&sizes[..], &cells, &["tube.msh"]].concat());
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!(run.code, 1);
    assert!(
        run.err.contains("thousands of times longer than thick"),
        "{}",
        run.err
    );
    assert!(run.err.lines().all(|line| line.len() < 200), "{}", run.err);
}

/// A part with negligible stiffness attached to the rest: not an input error, but without
/// a solution. The available files are written, and results of an earlier run are
/// removed.
#[test]
fn failed_analysis_ends_with_one_and_keeps_what_there_is() {
    let workplace = Workplace::with(&[], &[]);
    assert_eq!(workplace.run(&["analyze", "a.section.toml"]).code, 0);
    assert!(workplace.path("results/a.properties.json").exists());

    let soft = "[material.air]\nyoung = 1e-20\npoisson = 0\ndensity = 1\n\n[[region]]\ngroup = \"web\"\nmaterial = \"air\"";
    let section = workplace.read("a.section.toml");
    let web = "[[region]]\ngroup = \"web\"\nmaterial = \"steel\"";
    workplace.write("a.section.toml", &section.replace(web, soft));
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!(run.code, 1);
    assert!(
        run.err
            .starts_with("error: a.section.toml: the section is loose at node "),
        "{}",
        run.err
    );
    assert!(run.err.contains("\n  help: "), "{}", run.err);
    assert_eq!(
        run.out,
        "\nWritten\n  results/a.report.txt\n  results/a.mesh.png\n  results/a.mesh.svg\n\n\
         Removed: results of an earlier run\n  results/a.analysis.json\n  results/a.areas.csv\n  \
         results/a.constants.csv\n  results/a.properties.json\n  results/a.warping.png\n  \
         results/a.warping.svg\n  results/a.warping.vtu\n"
    );
    assert!(
        workplace
            .read("results/a.report.txt")
            .contains("\nNo result\n  the section is loose at node ")
    );
    assert!(workplace.path("results/a.mesh.png").exists());
    assert!(!workplace.path("results/a.properties.json").exists());
    for file in [
        "warping.png",
        "warping.vtu",
        "areas.csv",
        "constants.csv",
        "analysis.json",
    ] {
        assert!(
            !workplace.path(&format!("results/a.{file}")).exists(),
            "{file}"
        );
    }
}

/// Electrodes to open must be electrodes of the section; all wrong names are reported
/// together.
#[test]
fn open_electrodes_are_electrodes_of_the_section() {
    let workplace = Workplace::with(&[], &[]);
    let run = workplace.run(&[
        "analyze",
        "a.section.toml",
        "--open",
        "top",
        "--open",
        "all",
    ]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert_eq!(
        run.err.lines().collect::<Vec<_>>(),
        [
            "error: a.section.toml: --open top: the section has no such electrode",
            "  help: the section has no driven electrodes",
            "error: a.section.toml: --open all: the section has no such electrode",
            "  help: the section has no driven electrodes",
        ]
    );
    assert!(!workplace.path("results").exists());
}
