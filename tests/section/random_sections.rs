//! Random sections: convex and not, with holes, of one to three materials at random angles,
//! of all kinds of cells, mixed, with curved sides and shifted nodes.
//!
//! Properties of each of them: a section that is moved and turned has the moved and turned
//! stiffness and mass; another order of nodes and cells has no effect; lengths and moduli
//! enter as powers. Comparisons are relative to `sqrt(K_ii K_jj)`.
//!
//! The sections are drawn from a fixed seed, so that every run uses the same; a failure is
//! reported with the smallest recipe that reproduces it.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use proptest::collection::vec;
use proptest::prelude::{Just, Strategy, any, prop_oneof};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use section_analyzer::assembly::{Domain, Pattern, SectionMatrices};
use section_analyzer::material::{ElasticLaw, EngineeringConstants, Material};
use section_analyzer::mesh::{SectionCell, SectionMesh};
use section_analyzer::properties::{AreaTable, RestrainedWarping};
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::SectionSolution;
use section_analyzer::solve::{CentralSolution, CentralSystems, Decoupled, Pins};
use shared_geom::mesh::CellKind;
use shared_geom::section::InitialCurvature;
use shared_geom::wrench;

use crate::effort::cases;
use crate::quads::{Quads, steps};
use crate::record;
use crate::sections::{scaled_error, section_mesh, solved};

/// Number of sections for each property.
const CASES: usize = 100;

/// Tolerance for a moved and turned section: the errors of positions at three sizes from
/// the origin, 1e-15, as amplified in sections down to 1:10 with moduli up to 1:2000.
const TRANSPORT: f64 = 1e-9;

/// Tolerance for another order: sums in another order, other elimination, other pins for
/// nodes at equal distances, some hundred roundings of 1e-16.
const ORDER: f64 = 1e-12;

/// Tolerance for other units. All arithmetic is dimensionless; only the positions of the
/// nodes and the laws are rounded again.
const UNITS: f64 = 1e-11;

/// Tolerance for other pins: two decoupled solutions, each with the round-off of the rigid
/// motions removed by decoupling.
const PINS: f64 = 1e-10;

#[derive(Debug, Clone)]
enum Outline {
    /// Distances of the corners from the center of a star-shaped polygon.
    Star(Vec<f64>),
    Rectangle,
    Ell,
    Tee,
    Channel,
    Notched,
    /// A frame with a hole.
    Frame,
}

impl Outline {
    fn quads(&self) -> Quads {
        let (y, z) = (steps(-1.0, 1.0, 7), steps(-0.6, 0.6, 5));
        let keep = |inside: fn(f64, f64) -> bool| {
            Quads::lattice(&y, &z, |[y, z]| inside(y, z).then_some(0))
        };
        match self {
            Self::Star(radii) => {
                let turn = std::f64::consts::TAU / radii.len() as f64;
                let corner = |(i, radius): (usize, &f64)| {
                    let (s, c) = (turn * i as f64).sin_cos();
                    [radius * c, radius * s]
                };
                let corners: Vec<_> = radii.iter().enumerate().map(corner).collect();
                Quads::star(&corners, 2)
            }
            Self::Rectangle => keep(|_, _| true),
            Self::Ell => keep(|y, z| y < -0.4 || z < -0.1),
            Self::Tee => keep(|y, z| y.abs() < 0.2 || z > 0.1),
            Self::Channel => keep(|y, z| y < -0.7 || z.abs() > 0.3),
            Self::Notched => keep(|y, z| y.abs() > 0.2 || z < 0.1),
            Self::Frame => keep(|y, z| y.abs() > 0.7 || z.abs() > 0.3),
        }
    }
}

/// All data of a section; lists are used cyclically.
#[derive(Debug, Clone)]
struct Recipe {
    outline: Outline,
    is_quadratic: bool,
    /// Choice of the kind of each quadrilateral.
    kinds: Vec<usize>,
    /// Shift of the nodes, relative to the largest permitted shift.
    shifts: Vec<f64>,
    /// Height over width, a power of ten.
    slenderness: f64,
    /// Curvature of the straight sides.
    bend: [f64; 2],
    materials: Vec<Material>,
    /// Choice of material, fiber angle, plane angle of each cell.
    cells: Vec<(usize, f64, f64)>,
}

/// Largest shift of a node, relative to the shortest side at it: no angle of a cell becomes
/// straight.
const SHIFT: f64 = 0.06;

impl Recipe {
    fn section(&self) -> Section {
        let mut shape = self.outline.quads();
        let space = shortest_sides(&shape);
        for (i, (point, space)) in shape.points.iter_mut().zip(space).enumerate() {
            for axis in 0..2 {
                let shift = self.shifts[(2 * i + axis) % self.shifts.len()];
                point[axis] += SHIFT * space * shift;
            }
        }
        let kinds: &[CellKind] = if self.is_quadratic {
            &[
                CellKind::Triangle6,
                CellKind::Quadrilateral8,
                CellKind::Quadrilateral9,
            ]
        } else {
            &[CellKind::Triangle3, CellKind::Quadrilateral4]
        };
        let mesh = shape.mesh(|i| kinds[self.kinds[i % self.kinds.len()] % kinds.len()]);
        let mut mesh = section_mesh(&mesh);
        let [a, b] = self.bend;
        let height = 10f64.powf(self.slenderness);
        for [y, z] in &mut mesh.nodes {
            (*y, *z) = (*y + height * a * *z * *z, height * *z + b * *y * *y);
        }
        let cell = |index: usize| {
            let (material, fiber_angle, plane_angle) = self.cells[index % self.cells.len()];
            CellMaterial {
                material: material % self.materials.len(),
                fiber_angle,
                plane_angle,
            }
        };
        Section {
            name: format!("{self:?}"),
            cells: (0..mesh.cells.len()).map(cell).collect(),
            materials: self.materials.clone(),
            mesh,
            initial_curvature: InitialCurvature::STRAIGHT,
            electrodes: Vec::new(),
        }
    }
}

/// The shortest side at each point.
fn shortest_sides(shape: &Quads) -> Vec<f64> {
    let mut shortest = vec![f64::INFINITY; shape.points.len()];
    for (quad, _) in &shape.quads {
        for side in 0..4 {
            let ends = [quad[side], quad[(side + 1) % 4]];
            let [a, b] = ends.map(|point| shape.points[point]);
            let length = (a[0] - b[0]).hypot(a[1] - b[1]);
            for end in ends {
                shortest[end] = shortest[end].min(length);
            }
        }
    }
    shortest
}

fn outlines() -> impl Strategy<Value = Outline> {
    prop_oneof![
        3 => vec(0.6..1.0, 5..9).prop_map(Outline::Star),
        1 => Just(Outline::Rectangle),
        1 => Just(Outline::Ell),
        1 => Just(Outline::Tee),
        1 => Just(Outline::Channel),
        1 => Just(Outline::Notched),
        1 => Just(Outline::Frame),
    ]
}

/// Laws that are admissible: softer across the fiber than along it, and Poisson ratios up
/// to 0.35 between two of these.
fn laws() -> impl Strategy<Value = ElasticLaw> {
    // from a foam to a metal
    let isotropic = (-1.0..2.3_f64, 0.0..0.45).prop_map(|(power, poisson)| {
        let young = 10f64.powf(power);
        ElasticLaw::Isotropic { young, poisson }
    });
    let shear = || 0.5..8.0;
    let poisson = || 0.05..0.35;
    let orthotropic = (
        20.0..200.0,
        5.0..12.0,
        5.0..12.0,
        (shear(), shear(), shear()),
        (poisson(), poisson(), poisson()),
    );
    let orthotropic = orthotropic.prop_map(|(e1, e2, e3, g, nu)| {
        ElasticLaw::Orthotropic(EngineeringConstants {
            e1,
            e2,
            e3,
            g12: g.0,
            g13: g.1,
            g23: g.2,
            nu12: nu.0,
            nu13: nu.1,
            nu23: nu.2,
        })
    });
    prop_oneof![isotropic, orthotropic]
}

fn materials() -> impl Strategy<Value = Vec<Material>> {
    let material = (laws(), 0.1..10.0).prop_map(|(law, density)| Material {
        name: "material".into(),
        law,
        density,
        expansion: None,
        electric: None,
    });
    vec(material, 1..4)
}

fn recipes() -> impl Strategy<Value = Recipe> {
    let angle = || -3.0..3.0;
    (
        outlines(),
        any::<bool>(),
        vec(0..6_usize, 17),
        vec(-1.0..1.0, 41),
        (-1.0..0.0, [-0.15..0.15, -0.15..0.15]),
        materials(),
        vec((0..6_usize, angle(), angle()), 23),
    )
        .prop_map(
            |(outline, is_quadratic, kinds, shifts, (slenderness, bend), materials, cells)| {
                Recipe {
                    outline,
                    is_quadratic,
                    kinds,
                    shifts,
                    slenderness,
                    bend,
                    materials,
                    cells,
                }
            },
        )
}

/// Runs `property` on [`CASES`] recipes (ten times as many in the long form), each with additional data drawn by `more`.
fn check<M: Strategy>(
    name: &str,
    more: M,
    property: impl Fn(&Section, M::Value) -> f64,
    limit: f64,
) {
    let config = Config {
        cases: cases(CASES) as u32,
        failure_persistence: None,
        max_shrink_iters: 50,
        ..Config::default()
    };
    let seed = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let worst = std::cell::Cell::new(0.0_f64);
    let outcome = TestRunner::new_with_rng(config, seed).run(&(recipes(), more), |(recipe, m)| {
        let error = property(&recipe.section(), m);
        worst.set(worst.get().max(error));
        if error < limit {
            Ok(())
        } else {
            Err(TestCaseError::fail(format!("{name}: {error:e}")))
        }
    });
    let count = cases(CASES);
    println!("{name}: {count} sections, at most {:.1e}", worst.get());
    let case = format!("{count} random sections");
    record::largest("Invariance of the results", &case, name, worst.get(), limit);
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
}

fn moved(section: &Section, position: impl Fn([f64; 2]) -> [f64; 2]) -> Section {
    let mut moved = section.clone();
    for node in &mut moved.mesh.nodes {
        *node = position(*node);
    }
    moved
}

fn largest(errors: impl IntoIterator<Item = f64>) -> f64 {
    // NaN is treated as larger than any number
    errors
        .into_iter()
        .fold(0.0, |most, error| match error > most {
            true => error,
            false if error.is_nan() => f64::INFINITY,
            false => most,
        })
}

/// Constants of restrained warping, if all materials are isotropic.
fn restrained(section: &Section, solution: &SectionSolution) -> Option<RestrainedWarping> {
    RestrainedWarping::new(section, &solution.warping, &solution.strain).ok()
}

/// `p' = Q p + d`, with the angles of the walls turned: `K' = U(-d) V' K V U(-d)'`, and the
/// same for the mass; centers move with the mesh, second moments about the centroid turn.
fn transport_error(section: &Section, (phi, d): (f64, [f64; 2])) -> f64 {
    let (s, c) = phi.sin_cos();
    let position = |[y, z]: [f64; 2]| [c * y - s * z + d[0], s * y + c * z + d[1]];
    let mut there = moved(section, position);
    for cell in &mut there.cells {
        cell.plane_angle += phi;
    }
    let (plain, found) = (solved(section), solved(&there));
    // old axes in the new ones
    let q = Matrix3::new(1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c);
    let back = -Vector3::new(0.0, d[0], d[1]);
    let transported = |matrix: &Matrix6<f64>| wrench::shift(&wrench::rotate(matrix, &q), &back);
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);

    let mut errors = vec![
        scaled_error(&found.stiffness, &transported(&plain.stiffness)),
        scaled_error(&found.mass, &transported(&plain.mass)),
        apart(found.centers.tension, position(plain.centers.tension)),
        apart(found.centers.shear, position(plain.centers.shear)),
    ];
    let (one, two) = (
        AreaTable::by_group(section).total,
        AreaTable::by_group(&there).total,
    );
    let (i, j) = (one.central, two.central);
    let turned = [
        c * c * i.yy + s * s * i.zz + 2.0 * s * c * i.yz,
        s * s * i.yy + c * c * i.zz - 2.0 * s * c * i.yz,
        (c * c - s * s) * i.yz + s * c * (i.zz - i.yy),
    ];
    let second = [j.yy, j.zz, j.yz].into_iter().zip(turned);
    errors.extend(second.map(|(found, expected)| (found - expected).abs()));
    errors.push(apart(two.centroid, position(one.centroid)));
    errors.push((one.perimeter.length() - two.perimeter.length()).abs());
    // two computations of one mass: by sides and by the rules of the cells
    errors.push((two.mass / found.mass[(0, 0)] - 1.0).abs());
    if let (Some(one), Some(two)) = (restrained(section, &plain), restrained(&there, &found)) {
        let size = plain.stiffness[(0, 0)] * i.yy.max(i.zz);
        errors.push((one.stiffness - two.stiffness).abs() / size);
        errors.push(apart(two.center, position(one.center)));
    }
    largest(errors)
}

#[test]
fn moved_and_turned_sections_have_the_transported_matrices() {
    let motion = (-3.0..3.0, [-3.0..3.0, -3.0..3.0]);
    check(
        "moved and turned: matrices, centers, areas, warping",
        motion,
        transport_error,
        TRANSPORT,
    );
}

/// The indices below `count` in an order given by `keys`.
fn order(count: usize, keys: &[u32]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    let key = |i: usize| keys[i % keys.len()].wrapping_mul(2 * (i / keys.len()) as u32 + 1);
    order.sort_by_key(|&i| key(i));
    order
}

/// The cell that begins with corner `turn` of `cell`.
fn turned_cell(cell: &SectionCell, turn: usize, new_node: &[u32]) -> SectionCell {
    let corners = cell.kind.corner_count();
    SectionCell::new(cell.tag, cell.kind, cell.group, |i| {
        // corners, then sides, then the middle
        let local = if i < 2 * corners {
            i / corners * corners + (i + turn) % corners
        } else {
            i
        };
        new_node[cell.nodes()[local] as usize]
    })
}

fn order_error(section: &Section, keys: Vec<u32>) -> f64 {
    let mesh = &section.mesh;
    let node_order = order(mesh.nodes.len(), &keys);
    let cell_order = order(mesh.cells.len(), &keys[1..]);
    let mut new_node = vec![0; node_order.len()];
    for (new, &old) in node_order.iter().enumerate() {
        new_node[old] = new as u32;
    }
    let cells = cell_order.iter().map(|&old| {
        let turn = keys[old % keys.len()] as usize % 4;
        turned_cell(&mesh.cells[old], turn, &new_node)
    });
    let shuffled = Section {
        mesh: SectionMesh {
            nodes: node_order.iter().map(|&old| mesh.nodes[old]).collect(),
            node_tags: node_order.iter().map(|&old| mesh.node_tags[old]).collect(),
            cells: cells.collect(),
            ..mesh.clone()
        },
        cells: cell_order.iter().map(|&old| section.cells[old]).collect(),
        ..section.clone()
    };
    let (plain, found) = (solved(section), solved(&shuffled));
    largest([
        scaled_error(&found.stiffness, &plain.stiffness),
        scaled_error(&found.mass, &plain.mass),
    ])
}

#[test]
fn another_order_of_nodes_and_cells_changes_nothing() {
    check(
        "renumbered: stiffness and mass",
        vec(any::<u32>(), 29),
        order_error,
        ORDER,
    );
}

/// Lengths times l and moduli times e: `K_ij` by `e l^2`, one more l for each moment;
/// mass by `l^2` and the same.
fn units_error(section: &Section, (length, modulus): (f64, f64)) -> f64 {
    let (length, modulus) = (10f64.powf(length), 10f64.powf(modulus));
    let mut scaled = moved(section, |position| position.map(|x| length * x));
    for material in &mut scaled.materials {
        material.law = ElasticLaw::Full(modulus * material.law.stiffness());
    }
    let (plain, found) = (solved(section), solved(&scaled));
    let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length);
    let unit = length * length * (unit * unit.transpose());
    let mut errors = vec![
        scaled_error(
            &found.stiffness,
            &(modulus * plain.stiffness.component_mul(&unit)),
        ),
        scaled_error(&found.mass, &plain.mass.component_mul(&unit)),
    ];
    let both = (restrained(section, &plain), restrained(&scaled, &found));
    if let (Some(one), Some(two)) = both {
        let expected = one.stiffness * modulus * length.powi(6);
        let size = plain.stiffness[(0, 0)] * modulus * length.powi(6);
        errors.push((two.stiffness - expected).abs() / size);
        errors.push((two.decay_length - length * one.decay_length).abs() / length);
    }
    largest(errors)
}

#[test]
fn lengths_and_moduli_enter_as_powers() {
    check(
        "other units: matrices, warping",
        (-4.0..2.0, -3.0..12.0),
        units_error,
        UNITS,
    );
}

/// Strains and warping of the decoupled central solutions with these pins, in the units of
/// the solver; the strains before decoupling.
fn with_pins(domain: &Domain, pins: Pins) -> (Decoupled, Matrix6<f64>) {
    let pattern = Pattern::new(domain);
    let matrices = SectionMatrices::assemble(domain, &pattern).expect("sound");
    let systems = CentralSystems::new(domain, &pattern, matrices, pins).expect("sound");
    let central = CentralSolution::solve(domain, &systems).expect("memory");
    let coupled = central.y;
    (Decoupled::new(domain, central), coupled)
}

/// Three nodes that span a triangle of a minimum size: the nodes `random`, or the next
/// after them.
fn triangle(nodes: &[[f64; 2]], random: [usize; 3]) -> Pins {
    let [a, b, c] = random.map(|node| node % nodes.len());
    let from_a = |i: usize| [nodes[i][0] - nodes[a][0], nodes[i][1] - nodes[a][1]];
    let least = 1e-3;
    let after = |first: usize| (0..nodes.len()).map(move |i| (first + i) % nodes.len());
    for b in after(b) {
        let ab = from_a(b);
        for c in after(c) {
            let ac = from_a(c);
            if (ab[0] * ac[1] - ab[1] * ac[0]).abs() > least {
                return Pins::at(nodes, [a, b, c]);
            }
        }
    }
    panic!("no triangle")
}

/// The choice of pins has no influence, on straight and on curved beams: for any three
/// nodes that are not on a line the decoupled solutions are the same; round-off times a
/// condition of about 1e5, with moduli up to 1:2000, times the condition of narrow pins.
#[test]
fn pins_do_not_matter() {
    let curved = prop_oneof![
        Just([0.0; 3]),
        [-0.2..0.2, -0.2..0.2, -0.2..0.2].prop_map(|k: [f64; 3]| k)
    ];
    let nodes = [0..100_000_usize, 0..100_000_usize, 0..100_000_usize];
    let undecoupled = std::cell::Cell::new(0_usize);
    let property = |section: &Section, (curvature, random): ([f64; 3], [usize; 3])| {
        let mut section = section.clone();
        section.initial_curvature.curvature = curvature.into();
        let domain = Domain::new(&section).expect("sound");
        let own = Pins::choose(&domain.nodes).expect("wide");
        let (expected, coupled) = with_pins(&domain, own);
        let (found, before) = with_pins(&domain, triangle(&domain.nodes, random));
        let strains = scaled_error(&found.y, &expected.y);
        let warping = (&found.x - &expected.x).amax() / expected.x.amax();
        if scaled_error(&before, &coupled) > 1e-3 {
            undecoupled.set(undecoupled.get() + 1);
        }
        largest([strains, warping])
    };
    check("random pins", (curved, nodes), property, PINS);
    // before decoupling, the strains of nearly all sections depend on the pins
    assert!(undecoupled.get() > cases(CASES) * 9 / 10, "{undecoupled:?}");
}
