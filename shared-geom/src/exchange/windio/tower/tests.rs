//! Towers against the published tables of a turbine, and wrong ones.

use std::path::Path;

use crate::exchange::{Options, parse};

/// Parts of the height, mass per length \[kg/m\] and bending stiffness \[N m^2\] of the tower file of ElastoDyn of
/// IEA-15-240-RWT on its monopile (IEAWindTask37/IEA-15-240-RWT, commit 179c0e51fda0, Apache-2.0).
const ELASTODYN: [[f64; 3]; 20] = [
    [0.000000000000e+00, 9.701836644154e+03, 3.065446681731e+12],
    [1.003225756664e-01, 9.701836644154e+03, 3.065446681731e+12],
    [1.003302927876e-01, 8.957821168193e+03, 2.832084716093e+12],
    [2.006451513327e-01, 8.891290748250e+03, 2.769450452003e+12],
    [2.006528684540e-01, 8.240624558496e+03, 2.568166429175e+12],
    [3.009677269991e-01, 7.838265809965e+03, 2.210055981076e+12],
    [3.009754441203e-01, 7.471269484996e+03, 2.107286870485e+12],
    [4.012903026655e-01, 6.986988604348e+03, 1.723500010955e+12],
    [4.012980197867e-01, 6.666023383428e+03, 1.644879215977e+12],
    [5.016128783319e-01, 6.149541091373e+03, 1.291405296743e+12],
    [5.016205954531e-01, 5.828878823766e+03, 1.224548874057e+12],
    [6.019354539982e-01, 5.282728621100e+03, 9.115849751112e+11],
    [6.019431711194e-01, 4.941265480348e+03, 8.530980440239e+11],
    [7.022580296646e-01, 4.618459904681e+03, 6.965892589609e+11],
    [7.022657467858e-01, 4.076589466231e+03, 6.154309947960e+11],
    [8.025806053310e-01, 3.981261686709e+03, 5.732589718113e+11],
    [8.025883224522e-01, 3.455079577071e+03, 4.979639354642e+11],
    [9.029031809974e-01, 3.364685898304e+03, 4.598937820987e+11],
    [9.029108981186e-01, 3.875282630890e+03, 5.291723868158e+11],
    [1.000000000000e+00, 3.832671106119e+03, 5.119078821629e+11],
];
/// Diameters at the eleven ends of the cans, and the thickness of each can, of the same tower \[m\].
const DIAMETERS: [f64; 11] = [
    10.0, 10.0, 9.926, 9.443, 8.833, 8.151, 7.390, 6.909, 6.748, 6.572, 6.5,
];
const THICKNESSES: [f64; 10] = [
    0.039496, 0.036456, 0.033779, 0.032192, 0.030708, 0.029101, 0.027213, 0.024009, 0.020826,
    0.023998,
];
/// Height of the tower \[m\].
const HEIGHT: f64 = 129.582;

/// A file of a version with a grid, diameters and thicknesses, and the keys of the steel.
fn file(version: u8, [grid, diameters, thicknesses]: [&[f64]; 3], steel: &str) -> String {
    let axis = format!(
        "reference_axis:\n  x: {{grid: [0, 1], values: [0, 0]}}\n  y: {{grid: [0, 1], values: [0, 0]}}\n  \
         z: {{grid: [0, 1], values: [15, {:?}]}}\n",
        15.0 + HEIGHT
    );
    let indented = |text: &str, by: usize| -> String {
        let lines = text.lines();
        lines.map(|line| format!("{:by$}{line}\n", "")).collect()
    };
    let (shape, structure) = match version {
        1 => ("outer_shape_bem", "internal_structure_2d_fem"),
        _ => ("outer_shape", "structure"),
    };
    let (in_shape, in_tower) = match version {
        1 => (indented(&axis, 6), String::new()),
        _ => (String::new(), indented(&axis, 4)),
    };
    format!(
        "name: turbine\ncomponents:\n  blade:\n    {shape}: {{}}\n  tower:\n{in_tower}    {shape}:\n{in_shape}\
         \x20     outer_diameter: {{grid: {grid:?}, values: {diameters:?}}}\n    {structure}:\n\
         \x20     outfitting_factor: 1.0\n      layers:\n      - name: wall\n        material: steel\n\
         \x20       thickness: {{grid: {grid:?}, values: {thicknesses:?}}}\nmaterials:\n- {{name: steel, {steel}}}\n"
    )
}

/// Steel of the tower.
const STEEL: &str = "E: 2.0e11, nu: 0.3, rho: 7850.0";

fn tower() -> Options {
    Options {
        body: Some("tower".to_owned()),
        ..Options::default()
    }
}

// Published diameters and thicknesses in both versions, against the published masses and stiffnesses: to their 12
// digits. The shear area is half of the area, the polar moment twice the other.
#[test]
fn the_tower_of_a_turbine_has_its_published_sections() {
    let grid = ELASTODYN.map(|row| row[0]);
    let diameters: Vec<f64> = (0..20_usize)
        .map(|row| DIAMETERS[row.div_ceil(2)])
        .collect();
    let thicknesses: Vec<f64> = (0..20).map(|row| THICKNESSES[row / 2]).collect();
    for version in [1, 2] {
        let text = file(version, [&grid, &diameters, &thicknesses], STEEL);
        let found = parse(&text, Path::new("turbine.yaml"), &tower());
        let (_, reading) = found.unwrap_or_else(|problems| panic!("{problems}\n{text}"));
        let blade = &reading.blade;
        assert!((blade.length() / HEIGHT - 1.0).abs() < 1e-12);
        for [part, mass, bending] in ELASTODYN {
            let mut stations = blade.stations.iter();
            let station = stations
                .find(|own| (own.arc_length - part * HEIGHT).abs() < 1e-9)
                .unwrap();
            let of = |i: usize| [station.mass[(i, i)], station.stiffness[(i, i)]];
            let area = mass / 7850.0;
            for (i, expected) in [
                [mass, 2e11 * area],
                [mass, 2e11 / 2.6 * 0.5 * area],
                [mass, 2e11 / 2.6 * 0.5 * area],
                [7850.0 * bending / 1e11, 2.0 * bending / 2.6],
                [7850.0 * bending / 2e11, bending],
                [7850.0 * bending / 2e11, bending],
            ]
            .into_iter()
            .enumerate()
            {
                for (found, expected) in of(i).into_iter().zip(expected) {
                    assert!(
                        (found / expected - 1.0).abs() < 1e-11,
                        "{part} {i}: {found} {expected}"
                    );
                }
            }
        }
    }
}

// Two layers of one material are one of both; the outfitting factor is one of the mass only.
#[test]
fn layers_are_stacked_inward() {
    let one = file(2, [&[0.0, 1.0], &[8.0, 6.0], &[0.05, 0.02]], STEEL);
    let two = one
        .replace("outfitting_factor: 1.0", "outfitting_factor: 1.07")
        .replace("values: [0.05, 0.02]", "values: [0.03, 0.015]")
        .replace(
            "materials:",
            "      - {name: inner, material: steel, thickness: {grid: [0, 1], values: [0.02, 0.005]}}\nmaterials:",
        );
    let [one, two] = [one, two].map(|text| {
        let found = parse(&text, Path::new("turbine.yaml"), &tower());
        found
            .unwrap_or_else(|problems| panic!("{problems}\n{text}"))
            .1
            .blade
    });
    for (one, two) in one.stations.iter().zip(&two.stations) {
        for i in 0..6 {
            assert!((two.stiffness[(i, i)] / one.stiffness[(i, i)] - 1.0).abs() < 1e-12);
            assert!((two.mass[(i, i)] / one.mass[(i, i)] - 1.07).abs() < 1e-12);
        }
    }
}

#[test]
fn wrong_towers_are_explained() {
    let sound = file(1, [&[0.0, 1.0], &[8.0, 6.0], &[0.05, 0.02]], STEEL);
    let refused = |text: &str, body: &str| {
        let options = Options {
            body: Some(body.to_owned()),
            ..Options::default()
        };
        match parse(text, Path::new("turbine.yaml"), &options) {
            Err(problems) => problems.to_string(),
            Ok(_) => panic!("accepted: {text}"),
        }
    };
    for (from, to, expected) in [
        (
            "values: [0.05, 0.02]",
            "values: [50, 20]",
            "m thick, with the radius 4 m",
        ),
        ("material: steel", "material: stel", "the material \"stel\""),
        (
            "E: 2.0e11",
            "E: [2.0e11, 1e11, 1e11]",
            "E of material \"steel\"",
        ),
        (
            "values: [15, 144.582]",
            "values: [144.582, 15]",
            "expected more than zero",
        ),
        (
            "x: {grid: [0, 1], values: [0, 0]}",
            "x: {grid: [0, 1], values: [0, 2]}",
            "the same value along the tower",
        ),
        ("rho: 7850.0", "rho: -1", "expected one number above zero"),
        ("outer_diameter", "diameter", "outer_diameter"),
        ("materials:", "materials: steel\nothers:", "expected a list"),
    ] {
        assert!(sound.contains(from), "{from}");
        let found = refused(&sound.replace(from, to), "tower");
        assert!(found.contains(expected), "{found}");
    }
}
