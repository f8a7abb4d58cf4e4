//! Imposed strains against closed forms: heat, gradients, turned plies, curved beams.
//!
//! # References
//! - [timoshenko] Timoshenko, *Analysis of bi-metal thermostats*, J. Opt. Soc. Am. 11
//!   (1925) 233-255: the strip of two layers.
//! - [boley] Boley, Weiner, *Theory of Thermal Stresses*, 1960, chapter 10: a temperature
//!   that is linear in the section of a free isotropic bar causes no stress.

use nalgebra::{DVector, Vector3, Vector6};
use section_analyzer::analysis::Analysis;
use section_analyzer::material::{EngineeringConstants, Material, section_strain};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::recovery::{LoadCase, Recoverer, Recovery};
use section_analyzer::section::{FreeStrain, ImposedStrain, Section, TemperatureField};
use section_analyzer::solution::ImposedSolution;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;
use shared_geom::wrench;

use crate::record;
use crate::sections::{isotropic, of_two, orthotropic, relative_error, uniform};

const TIMOSHENKO: &str = "Strip of two metals, Timoshenko (1925)";
const FREE: &str = "Free bodies without thermal stress";

/// A carbon ply with three different axes.
const PLY: EngineeringConstants = EngineeringConstants {
    e1: 142e9,
    e2: 9.8e9,
    e3: 11.2e9,
    g12: 6.0e9,
    g13: 5.5e9,
    g23: 4.8e9,
    nu12: 0.3,
    nu13: 0.34,
    nu23: 0.42,
};

/// Its expansion along its axes [1/K].
const PLY_EXPANSION: [f64; 3] = [-0.5e-6, 28e-6, 31e-6];

fn heated(material: Material, expansion: [f64; 3]) -> Material {
    Material {
        expansion: Some(expansion),
        ..material
    }
}

fn rectangle(width: f64, height: f64, cells: [usize; 2]) -> Mesh {
    let rectangle = Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind: CellKind::Quadrilateral8,
        name: "bar".into(),
    };
    rectangle.generate().expect("sound measures")
}

/// The same rise everywhere [K].
fn uniform_rise(section: &Section, rise: f64) -> ImposedStrain {
    let temperature = TemperatureField {
        rise,
        ..TemperatureField::default()
    };
    ImposedStrain::of_temperature("hot", section, &temperature)
}

fn imposed(section: &Section, state: &ImposedStrain) -> ImposedSolution {
    let analysis = Analysis::new(section).unwrap_or_else(|failure| panic!("{failure}"));
    let found = analysis.imposed(std::slice::from_ref(state));
    let mut found = found.unwrap_or_else(|failure| panic!("{failure}"));
    found.pop().expect("a solution for each state")
}

/// The stresses of a state alone.
fn recovered(section: &Section, state: &ImposedStrain) -> Recovery {
    let analysis = Analysis::new(section).expect("sound");
    let solutions = analysis
        .imposed(std::slice::from_ref(state))
        .expect("sound");
    let load = LoadCase {
        imposed: vec![state.name.clone()],
        ..LoadCase::at_point("alone", &Vector6::zeros(), [0.0; 2])
    };
    let recoverer = Recoverer::new(section, analysis.solution()).with_imposed(&solutions);
    recoverer
        .recover(&load)
        .unwrap_or_else(|failure| panic!("{failure}"))
}

/// Largest stress of a recovery [Pa].
fn largest_stress(recovery: &Recovery) -> f64 {
    let stress = recovery.points.iter().map(|p| p.tensors.stress.amax());
    stress.fold(0.0, f64::max)
}

/// The strip of the reference file: layer 1 below layer 2.
struct Bimetal {
    young: [f64; 2],
    height: [f64; 2],
    expansion: [f64; 2],
    rise: f64,
    curvature: f64,
}

impl Bimetal {
    fn read() -> Self {
        let text = include_str!("../reference/theory/bimetal.json");
        let file: serde_json::Value = serde_json::from_str(text).expect("JSON");
        let number = |key: &str| file["bimetal"][key].as_f64().expect("a number");
        Self {
            young: [number("E1"), number("E2")],
            height: [number("h1"), number("h2")],
            expansion: [number("alpha1"), number("alpha2")],
            rise: number("dT"),
            curvature: number("kappa2"),
        }
    }

    /// Bottom at z = -height/2; the cells of both layers have the same height.
    fn section(&self, width: f64) -> Section {
        let height = self.height[0] + self.height[1];
        let mesh = rectangle(width, height, [4, 5]);
        let border = self.height[0] - 0.5 * height;
        let metal = |layer: usize| {
            let expansion = [self.expansion[layer]; 3];
            heated(isotropic(self.young[layer], 0.3), expansion)
        };
        of_two(&mesh, [metal(0), metal(1)], |[_, z]| z < border)
    }

    /// Free strain at the bottom and curvature about y of two layers that stay plane: the
    /// balance of N = int E (e + z k - alpha T) and of its moment, z from the bottom.
    fn strain(&self) -> [f64; 2] {
        let ends = [
            [0.0, self.height[0]],
            [self.height[0], self.height[0] + self.height[1]],
        ];
        let moment = |order: i32| {
            let power = order + 1;
            let of = |layer: usize| {
                let [from, to] = ends[layer];
                self.young[layer] * (to.powi(power) - from.powi(power)) / f64::from(power)
            };
            [of(0), of(1)]
        };
        let [m0, m1, m2] = [0, 1, 2].map(moment);
        let heat = |m: [f64; 2]| self.rise * (m[0] * self.expansion[0] + m[1] * self.expansion[1]);
        let sum = |m: [f64; 2]| m[0] + m[1];
        let (a, b, c) = (sum(m0), sum(m1), sum(m2));
        let determinant = a * c - b * b;
        let (n, m) = (heat(m0), heat(m1));
        [(c * n - b * m) / determinant, (a * m - b * n) / determinant]
    }
}

/// Curvature and axial strain of the strip; exact for any width, since the layers have the
/// same Poisson's ratio: round-off is 1e-9 for a strip 400 times wider than the height of a
/// cell.
#[test]
fn bimetal_strip_bends_as_timoshenko_says() {
    const TOLERANCE: f64 = 1e-9;
    let bimetal = Bimetal::read();
    let [at_bottom, curvature] = bimetal.strain();
    // the closed form of the file and the balance of two layers are the same
    assert!(relative_error(curvature, bimetal.curvature) < 1e-12);
    let height = bimetal.height[0] + bimetal.height[1];
    for width in [0.002, 0.2] {
        let section = bimetal.section(width);
        let state = uniform_rise(&section, bimetal.rise);
        let found = imposed(&section, &state);
        let axial = at_bottom + 0.5 * height * curvature;
        let case = format!("width {width} m");
        for (name, found, expected) in [
            ("curvature [1/m]", found.free_strain[4], bimetal.curvature),
            ("axial strain", found.free_strain[0], axial),
        ] {
            let error = relative_error(found, expected);
            assert!(error < TOLERANCE, "{case}, {name}: {error:e}");
            record::value(TIMOSHENKO, &case, name, [found, expected], error, TOLERANCE);
        }
        // no other strain, compared with strains of 2e-3 and curvatures of 0.5 1/m
        for other in [1, 2, 3, 5] {
            assert!(
                found.free_strain[other].abs() < 1e-12,
                "{}",
                found.free_strain
            );
        }
    }
}

/// Stresses of the strip [timoshenko]. They are exactly uniaxial if the layers have equal
/// free strains across the strip but different ones along it: with the strain e along the
/// strip a layer has -nu (e - alpha T) + beta T across, the same in both for
/// `beta = c - nu alpha`. Round-off, relative to the stress of a restrained layer.
#[test]
fn bimetal_strip_has_the_stresses_of_two_plane_layers() {
    const TOLERANCE: f64 = 1e-9;
    let bimetal = Bimetal::read();
    let [at_bottom, curvature] = bimetal.strain();
    let height = bimetal.height[0] + bimetal.height[1];
    let mut section = bimetal.section(0.02);
    for (material, along) in section.materials.iter_mut().zip(bimetal.expansion) {
        let across = 1.5e-5 - 0.3 * along;
        material.expansion = Some([along, across, across]);
    }
    let recovery = recovered(&section, &uniform_rise(&section, bimetal.rise));
    let mut worst = 0.0_f64;
    for point in &recovery.points {
        let z = point.position[1] + 0.5 * height;
        let layer = usize::from(z > bimetal.height[0]);
        let strain = at_bottom + z * curvature - bimetal.expansion[layer] * bimetal.rise;
        let mut stress = point.tensors.stress;
        stress[0] -= bimetal.young[layer] * strain;
        worst = worst.max(stress.amax());
    }
    let error = worst / (bimetal.young[1] * bimetal.expansion[1] * bimetal.rise);
    assert!(error < TOLERANCE, "{error:e}");
    record::largest(
        TIMOSHENKO,
        "width 0.02 m",
        "stress, all points",
        error,
        TOLERANCE,
    );
    assert!(recovery.resultant_error < 1e-12);
}

/// A body of one anisotropic material heated evenly has its free strain and no stress:
/// round-off relative to the restrained stress E alpha T.
#[test]
fn homogeneous_sections_are_free_of_stress() {
    const TOLERANCE: f64 = 1e-12;
    let mesh = rectangle(0.03, 0.02, [5, 4]);
    for degrees in [0.0_f64, 25.0, 90.0] {
        let angle = degrees.to_radians();
        let mut section = uniform(&mesh, heated(orthotropic(PLY), PLY_EXPANSION), angle);
        for node in &mut section.mesh.nodes {
            *node = [node[0] + 0.1, node[1] - 0.04];
        }
        let state = uniform_rise(&section, 40.0);
        let found = imposed(&section, &state);
        let [a1, a2, a3] = PLY_EXPANSION;
        let (sin, cos) = angle.sin_cos();
        // a1 cos^2 + a2 sin^2, the shear 2 (a1 - a2) sin cos, and no curvature
        let axial = a1 * cos * cos + a2 * sin * sin;
        let shear = 2.0 * (a1 - a2) * sin * cos;
        let expected = 40.0 * Vector6::new(axial, shear, 0.0, 0.0, 0.0, 0.0);
        let scale = 40.0 * a3;
        // curvatures times the size of the section are strains
        let mut difference = found.free_strain - expected;
        difference.fixed_rows_mut::<3>(3).scale_mut(0.1);
        let error = difference.amax() / scale;
        let case = format!("ply at {degrees} deg, heated evenly");
        assert!(error < TOLERANCE, "{case}: {error:e}");
        record::largest(FREE, &case, "free strain", error, TOLERANCE);
        let error = largest_stress(&recovered(&section, &state)) / (PLY.e1 * scale);
        assert!(error < TOLERANCE, "{case}: {error:e}");
        record::largest(FREE, &case, "stress", error, TOLERANCE);
        // theta = K (psi - psi_T): restrained at psi = 0, heat causes compression
        assert!(degrees < 90.0 || found.restrained_force[0] < 0.0);
        assert!(found.error < TOLERANCE, "{:e}", found.error);
    }
}

/// The same on a beam that is curved and twisted: a body that expands by alpha T in all
/// directions keeps its shape, so that it has no stress, and its line l expands by
/// alpha T l. The section moves by `alpha T t`, whose rigid part belongs to the beam (S-77):
///
/// ```text
/// r = -Ph' (alpha T t)       psi_T = alpha T [l; 0] - T r
/// ```
#[test]
fn curved_and_twisted_beams_grow_evenly() {
    const TOLERANCE: f64 = 1e-12;
    let mesh = rectangle(0.03, 0.02, [5, 4]);
    let growth = 12e-6 * 40.0;
    for (curvature, slope) in [
        ([3.0, -4.0, 5.0], [1.0, 0.0, 0.0]),
        ([8.0, 2.0, -1.0], [0.95, 0.2, -0.1]),
    ] {
        let mut section = uniform(&mesh, heated(isotropic(70e9, 0.33), [12e-6; 3]), 0.0);
        section.initial_curvature = InitialCurvature {
            curvature: Vector3::from(curvature),
            slope: Vector3::from(slope),
        };
        let state = uniform_rise(&section, 40.0);
        let found = imposed(&section, &state);
        let expected = grown(&section, growth);
        let error = (found.free_strain - expected).amax() / growth;
        let case = format!("curvature {curvature:?} 1/m, heated evenly");
        assert!(
            error < TOLERANCE,
            "{case}: {error:e}\n{}",
            found.free_strain
        );
        record::largest(FREE, &case, "free strain", error, TOLERANCE);
        let error = largest_stress(&recovered(&section, &state)) / (70e9 * growth);
        assert!(error < TOLERANCE, "{case}: {error:e}");
        record::largest(FREE, &case, "stress", error, TOLERANCE);
    }
}

/// Generalized strain of a section that expands by `growth` in all directions.
fn grown(section: &Section, growth: f64) -> Vector6<f64> {
    let analysis = Analysis::new(section).expect("sound");
    let domain = analysis.domain();
    let mut moved = DVector::zeros(domain.unknowns());
    for (node, [y, z]) in domain.nodes.iter().enumerate() {
        moved[3 * node + 1] = growth * y;
        moved[3 * node + 2] = growth * z;
    }
    let r = -analysis.central().face.tr_mul(&moved);
    let line = &domain.line;
    let mut strain = -(line.equilibrium().transpose() * r);
    let mut axial = strain.rows_mut(0, 3);
    axial += growth * line.slope;
    let strain = strain.component_mul(&domain.scaling.strain());
    // from the origin of the domain to the origin of the mesh
    let [y, z] = domain.scaling.origin;
    let shift = wrench::shift_matrix(&Vector3::new(0.0, y, z));
    shift.transpose() * Vector6::from_column_slice(strain.as_slice())
}

/// A temperature linear in an isotropic section [boley]: `nu_x = alpha T0`,
/// `kappa_y = alpha T_z`, `kappa_z = -alpha T_y`, and no stress; round-off.
#[test]
fn linear_temperature_bends_and_does_not_stress() {
    const TOLERANCE: f64 = 1e-12;
    let mesh = rectangle(0.03, 0.02, [3, 4]);
    let mut section = uniform(&mesh, heated(isotropic(210e9, 0.3), [12e-6; 3]), 0.0);
    for node in &mut section.mesh.nodes {
        *node = [node[0] + 0.02, node[1] - 0.01];
    }
    let temperature = TemperatureField {
        rise: 25.0,
        gradient: [1500.0, -2600.0],
    };
    let state = ImposedStrain::of_temperature("gradient", &section, &temperature);
    let found = imposed(&section, &state).free_strain;
    let expected: Vector6<f64> = 12e-6 * Vector6::new(25.0, 0.0, 0.0, 0.0, -2600.0, -1500.0);
    let case = "rise that is linear in an isotropic section";
    for (i, name) in [(0, "axial strain"), (4, "bending y"), (5, "bending z")] {
        let error = relative_error(found[i], expected[i]);
        assert!(error < TOLERANCE, "{name}: {error:e}");
        record::value(FREE, case, name, [found[i], expected[i]], error, TOLERANCE);
    }
    assert!((found - expected).amax() < 1e-14, "{found}");
    let error = largest_stress(&recovered(&section, &state)) / (210e9 * 12e-6 * 50.0);
    assert!(error < TOLERANCE, "{error:e}");
    record::largest(FREE, case, "stress", error, TOLERANCE);
}

/// Cells with different fiber and plane angles: imposed strains that follow from a
/// displacement field (compatible ones) cause no stress, for any law of each cell.
#[test]
fn compatible_strains_do_not_stress_a_laminate() {
    let mesh = rectangle(0.03, 0.02, [3, 4]);
    let mut section = uniform(&mesh, orthotropic(PLY), 0.0);
    for (number, cell) in section.cells.iter_mut().enumerate() {
        cell.fiber_angle = 0.5 * number as f64;
        cell.plane_angle = -0.3 * number as f64;
    }
    // one strain tensor in section axes, given to each cell in its own material axes
    let strain = Vector6::new(1e-4, -2e-4, 3e-4, 1.5e-4, -0.7e-4, 2.5e-4);
    let free = |cell: &section_analyzer::section::CellMaterial| {
        // columns of the map from material to section axes, inverted
        let map = nalgebra::Matrix6::from_columns(&std::array::from_fn::<_, 6, _>(|i| {
            section_strain(&Vector6::ith(i, 1.0), cell.fiber_angle, cell.plane_angle)
        }));
        let inverse = map.try_inverse().expect("a rotation");
        FreeStrain::constant(inverse * strain)
    };
    let state = ImposedStrain {
        name: "even".into(),
        cells: section.cells.iter().map(free).collect(),
    };
    // order yz yy zz xx xy xz: the strains of the face are the strains of the beam
    let expected = Vector6::new(strain[3], strain[4], strain[5], 0.0, 0.0, 0.0);
    let found = imposed(&section, &state);
    let error = (found.free_strain - expected).amax();
    assert!(error < 1e-15, "{error:e} {}", found.free_strain);
    let stress = largest_stress(&recovered(&section, &state));
    assert!(stress / (PLY.e1 * 3e-4) < 1e-11, "{stress:e}");
}

/// States and loads superpose: strains and stresses of both together are the sums, up to
/// round-off.
#[test]
fn loads_and_states_superpose() {
    let bimetal = Bimetal::read();
    let section = bimetal.section(0.01);
    let states = [uniform_rise(&section, 30.0), {
        let strain = FreeStrain::constant(Vector6::new(1e-4, 0.0, 2e-4, 0.0, 1e-4, 0.0));
        let mut cells = vec![FreeStrain::default(); section.cells.len()];
        cells[3] = strain;
        ImposedStrain {
            name: "cure".into(),
            cells,
        }
    }];
    let analysis = Analysis::new(&section).expect("sound");
    let solutions = analysis.imposed(&states).expect("sound");
    let recoverer = Recoverer::new(&section, analysis.solution()).with_imposed(&solutions);
    let force = Vector6::new(100.0, 20.0, -10.0, 0.3, 0.2, -0.4);
    let load = |factor: f64, names: &[&str]| LoadCase {
        imposed: names.iter().map(|&name| name.to_owned()).collect(),
        ..LoadCase::at_point("load", &(force * factor), [0.0; 2])
    };
    let of = |factor: f64, names: &[&str]| recoverer.recover(&load(factor, names)).expect("sound");
    let parts = [of(1.0, &[]), of(0.0, &["hot"]), of(0.0, &["cure"])];
    let whole = of(1.0, &["hot", "cure"]);
    let scale = largest_stress(&whole);
    for (i, point) in whole.points.iter().enumerate() {
        let sum: Vector6<f64> = parts.iter().map(|p| p.points[i].tensors.stress).sum();
        assert!((sum - point.tensors.stress).amax() < 1e-12 * scale);
    }
    let sum: Vector6<f64> = parts.iter().map(|part| part.generalized_strain).sum();
    assert!((sum - whole.generalized_strain).amax() < 1e-13);
    assert!((whole.resultant - force).amax() < 1e-9 * force.amax());
    let (cell, there) = recoverer
        .at(&load(1.0, &["hot", "cure"]), [0.001, 0.0002])
        .expect("in");
    let (_, bare) = recoverer.at(&load(1.0, &[]), [0.001, 0.0002]).expect("in");
    assert!(cell < section.cells.len() && (there.stress - bare.stress).amax() > 1e-3 * scale);

    let unknown = recoverer.recover(&load(1.0, &["cold"])).unwrap_err();
    let reported = "load \"load\" acts with \"cold\", which is not an imposed state of the section";
    assert_eq!(unknown.to_string(), reported);
}

/// Strips 1e3 and 1e4 times as wide as thick that expand evenly: the axial strain is the
/// expansion, and curvature and twist times half the thickness are zero, all to a few
/// round-offs of displacements that are (width / thickness)^2 times the strains. The torsion is
/// of Saint-Venant's series, to the error of the cells at the ends.
#[test]
fn thin_strips_expand_evenly() {
    for t in [1e-3, 1e-4] {
        let mesh = rectangle(1.0, t, [1000, 1]);
        let section = uniform(&mesh, isotropic(1.0, 0.33), 0.0);
        let even = FreeStrain {
            at_origin: Vector6::new(1.0, 1.0, 1.0, 0.0, 0.0, 0.0),
            ..FreeStrain::default()
        };
        let state = ImposedStrain {
            name: "even".into(),
            cells: vec![even; section.cells.len()],
        };
        let analysis = Analysis::new(&section).expect("sound");
        let solved = &analysis.imposed(&[state]).expect("accurate")[0];
        let radii = Vector6::new(1.0, 1.0, 1.0, 0.5 * t, 0.5 * t, 0.5);
        let strain = solved.free_strain.component_mul(&radii);
        let expected = Vector6::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        let limit = 5.0 * f64::EPSILON / (t * t);
        assert!((strain - expected).amax() < limit, "{strain}");
        let torsion = t.powi(3) / 3.0 * (1.0 - 0.630 * t) / (2.0 * 1.33);
        let found = analysis.solution().stiffness[(3, 3)];
        assert!((found / torsion - 1.0).abs() < 1e-4, "{found} {torsion}");
    }
}
