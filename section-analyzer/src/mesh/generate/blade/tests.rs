//! Areas, thicknesses, symmetry and groups of meshed blades.

use std::f64::consts::PI;

use shared_geom::error::{Explain, SourceLocation};
use shared_geom::mesh::{Cell, CellKind, Mesh};

use super::super::super::{SectionMesh, distance, short};
use super::super::layup::area::area_of;
use super::*;

const CHORD: f64 = 100.0;
const SKIN: f64 = 0.1;
const SPAR: f64 = 2.0;

fn ply(name: &str, thickness: f64) -> Ply {
    Ply {
        name: name.into(),
        thickness,
        cells: 1,
        has_faces: false,
    }
}

/// A ply around the whole spar.
fn around(name: &str, thickness: f64) -> SparPly {
    let all = Some([f64::NEG_INFINITY, f64::INFINITY]);
    SparPly {
        ply: ply(name, thickness),
        upper: all,
        lower: all,
        webs: [true; 2],
        filler: None,
    }
}

/// A skin alone.
fn skin(digits: &str, is_sharp: bool) -> Blade {
    let points = naca(digits, is_sharp).unwrap();
    Blade {
        contour: Contour::new(&points, CHORD, 0.25, 1.0).unwrap(),
        skin: vec![ply("skin", 0.5 * SKIN), ply("inner", 0.5 * SKIN)],
        is_closed: true,
        spar: None,
        cores: Cores::default(),
        sizes: Sizes::new(2.0),
    }
}

/// A skin on a box-spar, completely filled.
fn full(digits: &str) -> Blade {
    Blade {
        spar: Some(Spar {
            front_web: Some(0.15),
            rear_web: 0.45,
            plies: vec![around("outer", 0.5 * SPAR), around("inside", 0.5 * SPAR)],
        }),
        cores: Cores {
            nose: Some("foam".into()),
            spar: Some("core".into()),
            aft: Some("foam".into()),
            nose_mass: Some((0.05, "mass".into())),
        },
        ..skin(digits, true)
    }
}

/// A skin on a D-spar.
fn d_spar() -> Blade {
    Blade {
        spar: Some(Spar {
            front_web: None,
            rear_web: 0.4,
            plies: vec![around("spar", SPAR)],
        }),
        sizes: Sizes::new(1.0),
        // the radius of a nose is 1.1 t^2: here 3.6
        ..skin("0018", false)
    }
}

/// Area of the cells in a group, or of all.
fn area(mesh: &Mesh, name: Option<&str>) -> f64 {
    let group = name.map(|name| mesh.group(2, name).unwrap());
    let cells = mesh.cells.iter();
    let cells = cells.filter(|cell| group.is_none_or(|group| cell.groups.contains(group)));
    cells.map(|cell| area_of(mesh, cell)).sum()
}

/// The points of an airfoil in the unit of the mesh, as a polygon.
fn polygon(digits: &str, is_sharp: bool) -> Vec<[f64; 2]> {
    let points = naca(digits, is_sharp).unwrap().into_iter();
    points
        .map(|[x, z]| [(0.25 - x) * CHORD, z * CHORD])
        .collect()
}

fn polygon_area(points: &[[f64; 2]]) -> f64 {
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    let area: f64 = pairs.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    0.5 * area.abs()
}

fn is_sound(mesh: &Mesh) -> bool {
    SectionMesh::from_mesh(mesh, 1.0, &SourceLocation::file("test")).is_ok()
}

/// The area of a strip inside of a convex contour of perimeter P is
///
/// ```text
/// A = P t - t^2 (pi - sum theta/2 + sum tan(theta/2))
/// ```
/// with the turns theta of its corners: the smooth rest turns by 2 pi - sum theta, and a
/// mitred corner removes t^2 tan(theta/2). The polygon of 480 points is shorter than the
/// contour by 1e-5, and the error of the cells, parabolas of 12 degrees, is smaller.
#[test]
fn the_skin_has_the_area_of_a_strip_with_mitred_corners() {
    for (digits, is_sharp) in [("0012", false), ("0012", true), ("0030", false)] {
        let mesh = skin(digits, is_sharp).generate().unwrap();
        let points = polygon(digits, is_sharp);
        let pairs = points.iter().zip(points.iter().cycle().skip(1));
        let perimeter: f64 = pairs.map(|(a, b)| distance(*a, *b)).sum();
        let last = points.len() - 1;
        let slope = (points[0][1] - points[1][1]).atan2(points[0][0] - points[1][0]);
        // direction into the trailing edge on the upper surface, relative to the chord
        let dip = PI - slope.abs();
        let turns = if is_sharp {
            vec![PI - 2.0 * dip]
        } else {
            vec![0.5 * PI - dip; 2]
        };
        assert!(distance(points[0], points[last]) < 1e-9 || !is_sharp);
        let corners: f64 = turns
            .iter()
            .map(|turn| (0.5 * turn).tan() - 0.5 * turn)
            .sum();
        let expected = perimeter * SKIN - SKIN * SKIN * (PI + corners);
        let error = area(&mesh, None) / expected - 1.0;
        assert!(error.abs() < 3e-5, "{digits} {is_sharp}: {error:e}");
        assert!(is_sound(&mesh));
    }
}

/// A completely filled section has the area of the airfoil: its polygon is smaller by
/// 1e-5.
#[test]
fn filled_blades_have_the_area_of_the_airfoil() {
    for digits in ["0015", "4415"] {
        let mesh = full(digits).generate().unwrap();
        assert!(is_sound(&mesh), "{digits}");
        let expected = polygon_area(&polygon(digits, true));
        let error = area(&mesh, None) / expected - 1.0;
        assert!(error.abs() < 3e-5, "{digits}: {error:e}");
        let parts = ["skin", "inner", "outer", "inside", "foam", "core", "mass"];
        let sum: f64 = parts.map(|part| area(&mesh, Some(part))).iter().sum();
        assert!((sum / area(&mesh, None) - 1.0).abs() < 1e-12);
    }
}

/// Distance from a fine polygon, whose chords lie 1e-5 of a unit inside of the contour.
fn depth(position: [f64; 2], contour: &[[f64; 2]]) -> f64 {
    let to_line = |pair: &[[f64; 2]]| {
        let [a, b] = [pair[0], pair[1]];
        let line = [b[0] - a[0], b[1] - a[1]];
        let from = [position[0] - a[0], position[1] - a[1]];
        let length = line[0] * line[0] + line[1] * line[1];
        let part = ((from[0] * line[0] + from[1] * line[1]) / length).clamp(0.0, 1.0);
        distance(position, [a[0] + part * line[0], a[1] + part * line[1]])
    };
    contour
        .windows(2)
        .map(to_line)
        .fold(f64::INFINITY, f64::min)
}

/// Every corner of every cell of a wall lies at the depth of a face of its ply; the inner
/// corners of the spar are at the depth of both walls.
#[test]
fn plies_keep_their_thickness_up_to_the_mitre() {
    let blade = d_spar();
    let mesh = blade.generate().unwrap();
    let contour = polygon("0018", false);
    let web = blade.contour.at_part(0.4);
    let group = |name: &str| mesh.group(2, name).unwrap();
    let near = |a: f64, b: f64| (a - b).abs() < 2e-3;
    let (mut mitred, mut on_web) = (0, 0);
    for cell in &mesh.cells {
        for &node in cell.corners() {
            let position = mesh.nodes[node as usize].position;
            let (inside, ahead) = (depth([position.x, position.y], &contour), position.x - web);
            if cell.groups.contains(group("spar/web")) {
                assert!(near(ahead, 0.0) || near(ahead, SPAR), "{position}");
                on_web += 1;
            } else if cell.groups.contains(group("spar")) {
                assert!(
                    near(inside, SKIN) || near(inside, SKIN + SPAR),
                    "{position}: {inside}"
                );
            }
            let is_inner = near(inside, SKIN + SPAR) && near(ahead, SPAR);
            mitred += usize::from(is_inner);
        }
    }
    // two corners, each with a cell of the wall and one of the web
    assert_eq!(mitred, 4);
    assert!(on_web >= 16);
    assert!(is_sound(&mesh));
}

/// The mirror image of a symmetric blade equals the blade: nodes and cells.
#[test]
fn symmetric_airfoils_have_symmetric_meshes() {
    let mut blade = full("0015");
    blade.sizes.size = 3.0;
    let mesh = blade.generate().unwrap();
    let key = |y: f64, z: f64| [y, z].map(|x| (1e6 * x / CHORD).round() as i64);
    let nodes = |sign: f64| {
        let of_cell = |cell: &Cell| {
            let position = |node: &u32| mesh.nodes[*node as usize].position;
            let positions = cell.nodes().iter().map(position);
            let mut keys: Vec<_> = positions.map(|p| key(p.x, sign * p.y)).collect();
            keys.sort_unstable();
            keys
        };
        let mut cells: Vec<_> = mesh.cells.iter().map(of_cell).collect();
        cells.sort();
        cells
    };
    assert_eq!(nodes(1.0), nodes(-1.0));
}

#[test]
fn every_kind_of_cell_and_every_edge_gives_a_sound_mesh() {
    for kind in [
        CellKind::Quadrilateral4,
        CellKind::Quadrilateral8,
        CellKind::Quadrilateral9,
    ] {
        for is_closed in [true, false] {
            let mut blade = full("2415");
            blade.sizes.kind = kind;
            blade.is_closed = is_closed;
            if !is_closed {
                blade.contour = skin("2415", false).contour;
            }
            let mesh = blade.generate().unwrap();
            assert!(is_sound(&mesh), "{kind:?} {is_closed}");
        }
    }
    let sizes = [4.0, 2.0, 1.0].map(|size| {
        let mut blade = d_spar();
        blade.sizes.size = size;
        blade.generate().unwrap().cells.len()
    });
    assert!(sizes[0] < sizes[1] && sizes[1] < sizes[2], "{sizes:?}");
}

/// A ply that ends tapers over one cell: its area equals the area of a ply shortened by
/// half a cell at each end.
#[test]
fn plies_end_where_they_are_reported_to() {
    let mut blade = d_spar();
    blade.spar.as_mut().unwrap().plies.push(SparPly {
        upper: Some([0.1, 0.3]),
        lower: None,
        webs: [false; 2],
        ..around("pad", 0.1)
    });
    let mesh = blade.generate().unwrap();
    assert!(is_sound(&mesh));
    // 20 % of the chord less one cell, on a surface bent by less than 2 %
    let expected = 0.1 * (0.2 * CHORD - 1.0);
    let error = area(&mesh, Some("pad")) / expected - 1.0;
    assert!(error.abs() < 0.03, "{error}");
    assert!(mesh.group(2, "pad/lower").is_none());

    let filled = blade.spar.as_mut().unwrap().plies.last_mut().unwrap();
    filled.filler = Some("filler".into());
    filled.ply.has_faces = true;
    let mesh = blade.generate().unwrap();
    let error = area(&mesh, Some("pad")) / (0.1 * 0.2 * CHORD) - 1.0;
    assert!(error.abs() < 0.02, "{error}");
    for name in ["filler/web", "filler/upper", "filler/lower"] {
        assert!(mesh.group(2, name).is_some(), "{name}");
    }
    for face in ["pad/outer", "pad/inner", "contour", "spar"] {
        assert!(mesh.group(1, face).is_some(), "{face}");
    }
}

/// The curves run clockwise, so that the left of each line is outside of the section.
#[test]
fn curves_run_clockwise() {
    let mesh = full("0015").generate().unwrap();
    for name in ["contour", "spar"] {
        let group = mesh.group(1, name).unwrap();
        let lines = mesh.lines.iter().filter(|line| line.groups.contains(group));
        let twice: f64 = lines
            .map(|line| {
                let [a, b] = [0, 1].map(|i| mesh.nodes[line.nodes()[i] as usize].position);
                a.x * b.y - b.x * a.y
            })
            .sum();
        assert!(twice < 0.0, "{name}");
    }
}

#[test]
fn what_does_not_fit_is_reported_where() {
    let reported = |blade: Blade| blade.generate().unwrap_err();
    let mut thick = d_spar();
    thick.skin[0].thickness = 1.5;
    assert!(
        matches!(&reported(thick)[..], [BladeProblem::EdgeThick { ahead: Some(ahead), .. }]
            if (0.5..1.0).contains(ahead))
    );
    let with = |change: &dyn Fn(&mut Spar)| {
        let mut blade = d_spar();
        change(blade.spar.as_mut().unwrap());
        reported(blade)
    };
    let radius = with(&|spar| spar.plies[0].ply.thickness = 4.0);
    assert!(
        matches!(radius[..], [BladeProblem::Tight { radius, .. }] if (radius / 3.57 - 1.0).abs() < 0.02)
    );
    let collision = with(&|spar| {
        spar.plies[0].ply.thickness = 9.5;
        spar.front_web = Some(0.1);
    });
    assert!(
        matches!(
            collision[..],
            [BladeProblem::Collision {
                about: BladePart::Spar,
                ..
            }] | [BladeProblem::Tight { .. }]
        ),
        "{collision:?}"
    );
    let order = with(&|spar| spar.front_web = Some(0.6));
    assert!(matches!(order[0], BladeProblem::WebOrder { .. }));
    let outside = with(&|spar| spar.rear_web = 0.9999);
    assert!(matches!(outside[..], [BladeProblem::WebOutside { .. }]));
    let narrow = with(&|spar| spar.front_web = Some(0.37));
    assert!(
        matches!(narrow[0], BladeProblem::WebThick { .. }),
        "{narrow:?}"
    );
    let range = with(&|spar| spar.plies[0].upper = Some([0.1, 0.5]));
    assert!(matches!(
        range[..],
        [BladeProblem::PlyRange { number: 0, .. }]
    ));
    let mut mass = d_spar();
    mass.cores.nose_mass = Some((0.5, "mass".into()));
    assert!(matches!(
        reported(mass)[..],
        [BladeProblem::NoseMass { .. }]
    ));
    let mut tiny = d_spar();
    tiny.sizes.size = 1e-9;
    assert!(matches!(
        reported(tiny)[..],
        [BladeProblem::TooManyCells { .. }]
    ));
}

/// Ordinates of NACA Report 460, in percent of the chord with three decimals: 0012 at
/// 30 % and at the trailing edge, 4412 near its highest point at 40 %.
#[test]
fn airfoils_are_those_of_the_report() {
    let at = |digits: &str, is_closed: bool, side: usize, part: f64| {
        let points = naca(digits, is_closed).unwrap();
        let contour = Contour::new(&points, 100.0, 0.0, 1.0).unwrap();
        contour
            .outline()
            .position(contour.at_chord(side, part).unwrap())[1]
    };
    for (digits, side, part, expected) in [
        ("0012", 0, 0.3, 6.002),
        ("0012", 1, 0.3, -6.002),
        ("0012", 0, 0.05, 3.555),
        ("0012", 0, 0.4, 5.803),
        ("4412", 0, 0.4, 9.80),
        ("4412", 1, 0.4, -1.80),
    ] {
        let found = at(digits, false, side, part);
        // half of the last digit
        let half_digit = if digits == "0012" { 6e-4 } else { 6e-3 };
        assert!(
            (found - expected).abs() < half_digit,
            "{digits} {part}: {found}"
        );
    }
    let edge = |is_closed: bool| naca("0012", is_closed).unwrap()[0][1];
    assert!((edge(false) - 0.00126).abs() < 1e-9 && edge(true).abs() < 1e-9);
}

#[test]
fn airfoils_that_are_none_are_reported() {
    for digits in ["12", "00120", "0a12", "0000", "2012", "0412"] {
        assert!(naca(digits, false).is_err(), "{digits}");
    }
    let reported = |points: &[[f64; 2]]| Contour::new(points, 1.0, 0.25, 1.0).unwrap_err();
    let good = naca("0012", false).unwrap();
    let backward: Vec<_> = good.iter().rev().copied().collect();
    assert!(matches!(
        reported(&backward)[..],
        [BladeProblem::LowerFirst]
    ));
    let large: Vec<_> = good.iter().map(|point| point.map(|x| 100.0 * x)).collect();
    assert!(matches!(reported(&large)[..], [BladeProblem::Range { .. }]));
    assert!(matches!(
        reported(&good[..5])[..],
        [BladeProblem::FewPoints { .. }]
    ));
    let shifted = [&good[200..], &good[..200]].concat();
    assert!(matches!(
        reported(&shifted)[..],
        [BladeProblem::Order { .. }]
    ));
    let twice = [&good[..7], &good[6..]].concat();
    assert!(matches!(
        reported(&twice)[..],
        [BladeProblem::Doubled { number: 8 }]
    ));
    let crossed: Vec<_> = good
        .iter()
        .map(|&[x, z]| [x, z - 0.5 * x * (1.0 - x) * z.signum()])
        .collect();
    assert!(matches!(
        reported(&crossed)[..],
        [BladeProblem::Crossed { .. } | BladeProblem::LowerFirst, ..]
    ));
}

/// Cells of cores that are far higher than the cells of a spar are long fold at the corners of its
/// webs; longer ones do not.
#[test]
fn a_size_of_cells_without_folds_is_recommended() {
    let ending = SparPly {
        lower: None,
        webs: [true, false],
        ..around("ending", 0.5)
    };
    let points = naca("2415", false).unwrap();
    let blade = Blade {
        contour: Contour::new(&points, CHORD, 0.25, 0.95).unwrap(),
        skin: vec![ply("skin", 0.2)],
        is_closed: false,
        spar: Some(Spar {
            front_web: Some(0.15),
            rear_web: 0.4,
            plies: vec![around("spar", 0.5), ending],
        }),
        cores: Cores {
            nose: Some("foam".into()),
            spar: Some("foam".into()),
            ..Cores::default()
        },
        sizes: Sizes {
            core: 2.5,
            ..Sizes::new(0.5)
        },
    };
    let Err(problems) = blade.generate() else {
        panic!("cells of this size do not fold");
    };
    let [problem @ BladeProblem::Folded { unfolded, .. }] = &problems[..] else {
        panic!("{problems:?}");
    };
    let size = unfolded.unwrap();
    let help = problem.help().unwrap();
    assert_eq!(
        help,
        format!("no cell folds with [mesh] size = {}", short(size))
    );
    let sizes = Sizes {
        size,
        ..blade.sizes.clone()
    };
    assert!(Blade { sizes, ..blade }.generate().is_ok());
}
