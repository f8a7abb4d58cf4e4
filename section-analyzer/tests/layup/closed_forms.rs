//! Sections with closed forms, of `tests/reference/layups/simple.json`.

use std::f64::consts::{PI, TAU};

use section_analyzer::material::{ElasticLaw, EngineeringConstants, Material};
use section_analyzer::mesh::generate::layup::{Layer, LayupSection, Web, WebPly};

use crate::sections::{Case, number, reference, solved};

pub fn layer(name: &str, thickness: f64) -> Layer {
    Layer {
        name: name.into(),
        thickness,
        from: 0.0,
        to: 1.0,
        taper: None,
        profile: Vec::new(),
    }
}

pub fn ellipse(a: f64, b: f64, count: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| {
        let angle = TAU * i as f64 / count as f64;
        [-a * angle.cos(), b * angle.sin()]
    };
    (0..=count).map(at).collect()
}

pub fn section(contour: Vec<[f64; 2]>, layers: Vec<Layer>) -> LayupSection {
    LayupSection {
        contour,
        layers,
        webs: Vec::new(),
        spar: None,
        fills: Vec::new(),
        size: None,
    }
}

fn material(name: &str, law: ElasticLaw) -> Material {
    Material {
        name: name.into(),
        law,
        density: 2000.0,
        expansion: None,
        electric: None,
    }
}

pub fn isotropic(name: &str) -> Material {
    material(
        name,
        ElasticLaw::Isotropic {
            young: 70e9,
            poisson: 0.3,
        },
    )
}

/// Areas to 1e-6, as a spline through 360 points of a circle is exact to its fourth order. EA,
/// EI and GJ leave out the coupling of the two plies by Poisson's ratios, of 1e-4 at most.
#[test]
fn tube_of_two_plies() {
    let expected = &reference("simple.json")["tube"];
    let section = section(
        ellipse(1.0, 1.0, 360),
        vec![layer("outer", 0.02), layer("inner", 0.03)],
    );
    let meshed = section.generate().expect("a mesh");
    for (area, exact) in meshed
        .areas
        .iter()
        .zip([0, 1].map(|i| number(&expected["A"][i])))
    {
        assert!(
            (area.meshed / exact - 1.0).abs() < 1e-6,
            "{}: {}",
            area.name,
            area.meshed
        );
        assert!(
            (area.nominal / exact - 1.0).abs() < 1e-6,
            "{}: {}",
            area.name,
            area.nominal
        );
    }
    let fibers = ElasticLaw::Orthotropic(EngineeringConstants {
        e1: 140e9,
        e2: 10e9,
        e3: 10e9,
        g12: 5e9,
        g13: 5e9,
        g23: 10e9 / 2.6,
        nu12: 0.3,
        nu13: 0.3,
        nu23: 0.3,
    });
    let case = Case {
        name: "tube".into(),
        section,
        materials: ["outer", "inner"]
            .map(|name| (name.into(), name.into()))
            .to_vec(),
        laws: vec![material("outer", fibers), isotropic("inner")],
    };
    let [_, axial, flap, edge, torsion] = solved(&case, &meshed);
    for (found, key) in [(axial, "EA"), (flap, "EI"), (edge, "EI"), (torsion, "GJ")] {
        let exact = number(&expected[key]);
        assert!((found / exact - 1.0).abs() < 2e-4, "{key}: {found} {exact}");
    }
}

/// Two isotropic plies of one Poisson's ratio contract alike, so that the sums over the plies are exact:
/// EA = sum E A, EI = sum E I, GJ = sum G J with J = 2 I of rings. Tolerance 1e-6, of the spline through
/// 360 points.
#[test]
fn tube_of_two_plies_of_one_ratio() {
    let walls = [0.02, 0.03];
    let section = section(
        ellipse(1.0, 1.0, 360),
        vec![layer("outer", walls[0]), layer("inner", walls[1])],
    );
    let meshed = section.generate().expect("a mesh");
    let (young, poisson) = ([140e9, 10e9], 0.3);
    let law = |young: f64| ElasticLaw::Isotropic { young, poisson };
    let names = ["outer", "inner"];
    let case = Case {
        name: "tube of one ratio".into(),
        section,
        materials: names.map(|name| (name.into(), name.into())).to_vec(),
        laws: [0, 1].map(|i| material(names[i], law(young[i]))).to_vec(),
    };
    let radii = [1.0, 1.0 - walls[0], 1.0 - walls[0] - walls[1]];
    let ring = |i: usize, power: i32| radii[i].powi(power) - radii[i + 1].powi(power);
    let sum = |power: i32| young[0] * ring(0, power) + young[1] * ring(1, power);
    let (axial, bending) = (PI * sum(2), PI * sum(4) / 4.0);
    let expected = [axial, bending, bending, bending / (1.0 + poisson)];
    let [_, found @ ..] = solved(&case, &meshed);
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    }
}

/// A wall at the rear, mitred at both corners: areas of the plies to 5e-6; the spline through the
/// points deviates by 3e-6 where straight sides become an arc, with a jump of the curvature.
#[test]
fn stadium_with_a_wall() {
    let (radius, length) = (0.3, 1.7);
    let part = |i: usize| i as f64 / 200.0;
    let upper = (0..200).map(|i| [length * (part(i) - 1.0), radius]);
    let nose = (0..=200).map(|i| {
        let angle = PI * part(i);
        [radius * angle.sin(), radius * angle.cos()]
    });
    let lower = (1..=200).map(|i| [-length * part(i), -radius]);
    let contour = upper.chain(nose).chain(lower).collect();
    let layers = vec![layer("outer", 0.02), layer("inner", 0.03)];
    let meshed = section(contour, layers).generate().expect("a mesh");
    let exact = &reference("simple.json")["stadium_wall"]["A"];
    for (i, area) in meshed.areas.iter().enumerate() {
        let error = area.meshed / number(&exact[i]) - 1.0;
        assert!(error.abs() < 5e-6, "{}: {error}", area.name);
    }
}

/// A thin ellipse with a web, by Bredt's theory of two cells: 0.13 % for walls of 1.3 % of the
/// height is the order of the neglected terms; mass: corners of the web, 2e-4.
#[test]
fn thin_ellipse_with_a_web() {
    let expected = &reference("simple.json")["ellipse_web"];
    let mut section = section(ellipse(1.0, 0.3, 720), vec![layer("wall", 0.004)]);
    let plies = vec![WebPly {
        name: "ply".into(),
        thickness: 0.004,
    }];
    section.webs = vec![Web {
        name: "web".into(),
        arcs: [0.25, 0.75],
        plies,
    }];
    let meshed = section.generate().expect("a mesh");
    let case = Case {
        name: "ellipse".into(),
        section,
        materials: ["wall", "ply"]
            .map(|name| (name.into(), "metal".into()))
            .to_vec(),
        laws: vec![isotropic("metal")],
    };
    let [mass, .., torsion] = solved(&case, &meshed);
    let errors = [
        mass / number(&expected["m"]) - 1.0,
        torsion / number(&expected["GJ"]) - 1.0,
    ];
    println!("mass and torsion: {errors:?}");
    assert!(
        errors[0].abs() < 5e-4 && errors[1].abs() < 1.3e-3,
        "{errors:?}"
    );
}
