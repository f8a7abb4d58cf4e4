use super::*;
use crate::analysis::{Analysis, analyze};
use crate::section::samples::{Random, coupled_rectangle, random_strain};
use crate::solution::ImposedSolution;
use shared_geom::mesh::CellKind;
use shared_geom::section::prestress_part;

#[path = "prestress_energy.rs"]
mod energy;
use energy::LargeStrain;

fn of(section: &Section, measure: StrainMeasure) -> CubicTable {
    let solution = analyze(section).expect("sound");
    prestress(section, &solution.warping, &solution.strain, measure)
        .expect("straight")
        .third
}

/// Largest difference of two tables, with entries relative to
/// `sqrt(K_ii K_jj K_kk / K_11)`.
fn difference(section: &Section, a: &CubicTable, b: &CubicTable) -> f64 {
    let k = analyze(section).expect("sound").stiffness;
    let root = |i: usize| k[(PRESTRESS_COMPONENTS[i], PRESTRESS_COMPONENTS[i])].sqrt();
    let relative = |([i, j, l], value): ([usize; 3], f64)| {
        (value - b.at([i, j, l])).abs() * root(0) / (root(i) * root(j) * root(l))
    };
    a.entries().map(relative).fold(0.0, f64::max)
}

/// A section without symmetry, with shear strains in all its states, moved: the table of
/// the moved mesh equals the moved table, to the accuracy of the moved analysis.
#[test]
fn the_table_moves_with_the_mesh() {
    let section = coupled_rectangle(CellKind::Quadrilateral9);
    for measure in StrainMeasure::ALL {
        let table = of(&section, measure);
        let by = [1.7, -0.9];
        let mut moved = section.clone();
        for node in &mut moved.mesh.nodes {
            *node = [node[0] + by[0], node[1] + by[1]];
        }
        // the mesh moves by +d: its reference point is at the former -d
        let expected = table.shifted(-Vector2::from(by));
        assert!(difference(&moved, &expected, &table) > 1e-2);
        let error = difference(&moved, &expected, &of(&moved, measure));
        assert!(error < 1e-12, "{measure:?} {error:e}");
    }
}

/// The same in axes turned by 40 degrees.
#[test]
fn the_table_turns_with_the_axes() {
    let section = coupled_rectangle(CellKind::Quadrilateral9);
    let angle = 40.0_f64.to_radians();
    let (s, c) = angle.sin_cos();
    let mut turned = section.clone();
    for node in &mut turned.mesh.nodes {
        *node = [c * node[0] + s * node[1], c * node[1] - s * node[0]];
    }
    for made_of in &mut turned.cells {
        made_of.plane_angle -= angle;
    }
    for measure in StrainMeasure::ALL {
        let expected = of(&section, measure).rotated(angle);
        assert!(difference(&turned, &expected, &of(&section, measure)) > 1e-2);
        let error = difference(&turned, &expected, &of(&turned, measure));
        assert!(error < 1e-12, "{measure:?} {error:e}");
    }
}

/// A mesh far from its origin loses no more digits than its stiffness does.
#[test]
fn far_from_the_origin_the_digits_are_kept() {
    let section = coupled_rectangle(CellKind::Quadrilateral8);
    let mut far = section.clone();
    for node in &mut far.mesh.nodes {
        *node = [node[0] + 1e2, node[1] - 2e2];
    }
    let solution = analyze(&far).expect("sound");
    let found = Fields::new(&far, &solution.warping, &solution.strain).expect("sound");
    let near = analyze(&section).expect("sound");
    let here = Fields::new(&section, &near.warping, &near.strain).expect("sound");
    let tables = [found, here].map(|fields| fields.table(StrainMeasure::Green));
    let error = difference(&section, &tables[0], &tables[1]);
    // the forces of each state about the origin cancel by the square of the distance, 1e5
    assert!(error < 1e-9, "{error:e}");
}

#[test]
fn curved_beams_have_no_table() {
    let mut section = coupled_rectangle(CellKind::Triangle6);
    let solution = analyze(&section).expect("sound");
    section.initial_curvature.curvature.x = 0.1;
    let found = prestress(
        &section,
        &solution.warping,
        &solution.strain,
        StrainMeasure::Biot,
    );
    assert_eq!(found, Err(NoPrestress::Curved));
    assert!(
        NoPrestress::Curved
            .to_string()
            .contains("initial curvature")
    );
}

/// The cubic form `-force . second(p)` as a table, `second` being quadratic.
fn form(stiffness: &Matrix4<f64>, second: impl Fn(&Vector4<f64>) -> Vector4<f64>) -> CubicTable {
    let unit = |i: usize| Vector4::ith(i, 1.0);
    let bilinear =
        |j: usize, k: usize| 0.25 * (second(&(unit(j) + unit(k))) - second(&(unit(j) - unit(k))));
    let s = |i: usize, j: usize, k: usize| -stiffness.column(i).dot(&bilinear(j, k));
    CubicTable::from_fn(|[i, j, k]| 2.0 * (s(i, j, k) + s(j, i, k) + s(k, i, j)))
}

/// Converts the table from the axes of the section to axes that follow the tangent of the
/// reference line and the mean turn of the warping. With the small turn
/// `r = (s, -nu3, nu2)` from the former to the latter axes,
///
/// ```text
/// nu = nu1 + 1/2 (nu2^2 + nu3^2)      kappa' = kappa - r x kappa
/// U3'(p) = U3(p) - (K4 p) . second-order part of (p' - p)                   (S-87)
/// ```
pub(super) fn along_tangent(fields: &Fields<'_>, compliance: &Matrix6<f64>) -> CubicTable {
    let pick = |i: usize, j: usize| compliance[(PRESTRESS_COMPONENTS[i], PRESTRESS_COMPONENTS[j])];
    let stiffness = inverse(&Matrix4::from_fn(pick)).expect("sound");
    let turn = fields.mean_turn();
    form(&stiffness, |p| {
        let strain = fields.strain * p;
        let r = Vector3::new(turn.dot(p), -strain[2], strain[1]);
        let kappa = strain.fixed_rows::<3>(3).into_owned();
        let change = -r.cross(&kappa);
        let stretch = 0.5 * (strain[1].powi(2) + strain[2].powi(2));
        Vector4::new(stretch, change.x, change.y, change.z)
    })
}

impl Fields<'_> {
    /// Mean turn of the warping about x per unit p, about the centroid.
    fn mean_turn(&self) -> Vector4<f64> {
        let (mut moment, mut sum) = (0.0, Vector4::zeros());
        for cell in &self.section.mesh.cells {
            for point in self.points(cell) {
                moment += point.area * (point.y.powi(2) + point.z.powi(2));
                for (&node, n) in cell.nodes().iter().zip(&point.n) {
                    let warping = &self.warping[node as usize];
                    let turn = point.y * warping.row(2) - point.z * warping.row(1);
                    sum += n * point.area * turn.transpose();
                }
            }
        }
        sum / moment
    }
}

/// The table against second differences of the forces of the section in large strain, on a
/// section without symmetry: all terms follow from the exact kinematics, also the terms of
/// the moving axes. A step of 2e-3 has the error of its square times fifth derivatives,
/// about 1e-5 of the largest entry, and round-off of the forces over its square, 1e-9.
#[test]
fn the_table_begins_the_energy_of_large_strain() {
    let mut section = coupled_rectangle(CellKind::Quadrilateral9);
    let center = centroid(&section);
    for node in &mut section.mesh.nodes {
        *node = [node[0] - center[0], node[1] - center[1]];
    }
    let solution = analyze(&section).expect("sound");
    let fields = Fields::new(&section, &solution.warping, &solution.strain).expect("sound");
    let own = fields.table(StrainMeasure::Green);
    let change = along_tangent(&fields, &solution.compliance);
    let expected = own.plus(&change);

    let large = LargeStrain::new(&section);
    let h = 2e-3;
    let unit = |i: usize| h * Vector4::ith(i, 1.0);
    let mixed = |j: usize, k: usize| {
        if j == k {
            (large.force(&unit(j)) + large.force(&-unit(j))) / (h * h)
        } else {
            let (sum, difference) = (unit(j) + unit(k), unit(j) - unit(k));
            let even = large.force(&sum) + large.force(&-sum);
            (even - large.force(&difference) - large.force(&-difference)) / (4.0 * h * h)
        }
    };
    let mut table = [[Vector4::zeros(); 4]; 4];
    for j in 0..4 {
        for k in j..4 {
            table[j][k] = mixed(j, k);
            table[k][j] = table[j][k];
        }
    }
    let found = CubicTable::from_fn(|[i, j, k]| table[j][k][i]);
    let error = difference(&section, &expected, &found);
    let without = difference(&section, &own, &found);
    println!("{error:e}, in the axes of the section {without:e}");
    for (at, value) in expected.entries() {
        println!("{at:?} {value} {} {}", found.at(at), own.at(at));
    }
    assert!(without > 1e-2, "the axes do not matter here: {without:e}");
    assert!(error < 1e-4, "{error:e}");
}

fn free_state(solved: &ImposedSolution) -> FreeState<'_> {
    FreeState {
        imposed: &solved.state,
        warping: &solved.warping,
        strain: &solved.free_strain,
    }
}

/// Applies (S-87) to the change by an imposed state: the part of the quadratic change of
/// the strains that is linear in the state,
///
/// ```text
/// T_0jk' = T_0jk - 2 ( K_j . second(k, 0) + K_k . second(j, 0) )
/// ```
fn change_along_tangent(
    fields: &Fields<'_>,
    compliance: &Matrix6<f64>,
    solved: &ImposedSolution,
) -> Matrix4<f64> {
    let pick = |i: usize, j: usize| compliance[(PRESTRESS_COMPONENTS[i], PRESTRESS_COMPONENTS[j])];
    let stiffness = inverse(&Matrix4::from_fn(pick)).expect("sound");
    let own_turn = fields.turn_of(&solved.warping);
    // turn r, curvature and shears of a state
    let parts = |strain: &Vector6<f64>, turn: f64| {
        let r = Vector3::new(turn, -strain[2], strain[1]);
        (
            r,
            strain.fixed_rows::<3>(3).into_owned(),
            Vector2::new(strain[1], strain[2]),
        )
    };
    let own = parts(&solved.free_strain, own_turn);
    let mean_turn = fields.mean_turn();
    let with_own: [Vector4<f64>; 4] = std::array::from_fn(|k| {
        let strain: Vector6<f64> = fields.strain.column(k).into_owned();
        let of = parts(&strain, mean_turn[k]);
        let change = -0.5 * (of.0.cross(&own.1) + own.0.cross(&of.1));
        Vector4::new(0.5 * of.2.dot(&own.2), change.x, change.y, change.z)
    });
    Matrix4::from_fn(|j, k| {
        let of = |a: usize, b: usize| stiffness.column(a).dot(&with_own[b]);
        -2.0 * (of(j, k) + of(k, j))
    })
}

impl Fields<'_> {
    /// Mean turn about x of a warping, rows of each node, about the centroid.
    fn turn_of(&self, warping: &DVector<f64>) -> f64 {
        let (mut moment, mut sum) = (0.0, 0.0);
        for cell in &self.section.mesh.cells {
            for point in self.points(cell) {
                moment += point.area * (point.y.powi(2) + point.z.powi(2));
                for (&node, n) in cell.nodes().iter().zip(&point.n) {
                    let at = |axis: usize| warping[3 * node as usize + axis];
                    sum += n * point.area * (point.y * at(2) - point.z * at(1));
                }
            }
        }
        sum / moment
    }
}

/// The change by a state of random strains, on a section without symmetry, against
/// differences of the forces in large strain: of the stiffness about the free strain, by
/// the factor of the state. Steps of 1e-3 have the error of their square times fifth
/// derivatives, about 1e-5 of the largest entry, and round-off of the forces over the
/// product of the steps, 1e-9.
#[test]
fn the_change_by_imposed_strains_begins_the_energy_of_large_strain() {
    let mut section = coupled_rectangle(CellKind::Quadrilateral9);
    let center = centroid(&section);
    for node in &mut section.mesh.nodes {
        *node = [node[0] - center[0], node[1] - center[1]];
    }
    let analysis = Analysis::new(&section).expect("sound");
    let solution = analysis.solution();
    let state = random_strain(&section, "any", &mut Random(11));
    let solved = &analysis.imposed(&[state]).expect("sound")[0];
    let fields = Fields::new(&section, &solution.warping, &solution.strain).expect("sound");
    let own = fields.change_by(&free_state(solved), StrainMeasure::Green);
    let expected = own + change_along_tangent(&fields, &solution.compliance, solved);

    let large = LargeStrain::new(&section);
    let (h, c) = (1e-3, 1e-3);
    let psi = prestress_part(&solved.free_strain);
    let stiffness = |factor: f64| {
        let held = large.under(&section, &solved.state, factor);
        let columns: [_; 4] = std::array::from_fn(|k| {
            let step = h * Vector4::ith(k, 1.0);
            let base = factor * psi;
            (held.force(&(base + step)) - held.force(&(base - step))) / (2.0 * h)
        });
        Matrix4::from_columns(&columns)
    };
    let found = (stiffness(c) - stiffness(-c)) / (2.0 * c);
    let root = prestress_part(&solution.stiffness.diagonal().map(f64::sqrt));
    let scale = root * root.transpose();
    let largest = expected.component_div(&scale).amax();
    let off = |a: &Matrix4<f64>| (a - found).component_div(&scale).amax() / largest;
    println!(
        "{:e}, in the axes of the section {:e}",
        off(&expected),
        off(&own)
    );
    assert!(off(&own) > 1e-2, "the axes do not matter here");
    assert!(off(&expected) < 1e-4, "{expected} {found}");
}

/// The change moves with the mesh and turns with its axes, as the stiffness does.
#[test]
fn the_change_by_imposed_strains_moves_with_the_mesh() {
    let section = coupled_rectangle(CellKind::Quadrilateral9);
    let state = random_strain(&section, "any", &mut Random(11));
    let of = |section: &Section, state: &ImposedStrain| {
        let analysis = Analysis::new(section).expect("sound");
        let solution = analysis.solution();
        let solved = &analysis
            .imposed(std::slice::from_ref(state))
            .expect("sound")[0];
        let (warping, strain) = (&solution.warping, &solution.strain);
        let states = [free_state(solved)];
        prestress_of_imposed(section, warping, strain, StrainMeasure::Biot, &states)
            .expect("straight")[0]
    };
    let by = [1.7, -0.9];
    let mut moved = section.clone();
    for node in &mut moved.mesh.nodes {
        *node = [node[0] + by[0], node[1] + by[1]];
    }
    let mut moved_state = state.clone();
    for free in &mut moved_state.cells {
        free.at_origin -= by[0] * free.by_y + by[1] * free.by_z;
    }
    let v = strains_of_moved(-Vector2::from(by));
    let expected = v.transpose() * of(&section, &state) * v;
    let found = of(&moved, &moved_state);
    assert!(
        (found - expected).amax() < 1e-11 * expected.amax(),
        "{found} {expected}"
    );
}
