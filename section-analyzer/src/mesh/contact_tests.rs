//! Overlaps, doubled nodes, hanging nodes and gaps in small meshes, on both sides of each
//! limit; no findings in sound meshes.

use nalgebra::Vector3;
use shared_geom::error::Explain;
use shared_geom::mesh::{Cell, CellKind, Mesh, Node, PhysicalGroup};

use super::super::generate::{Rectangle, Tube};
use super::super::{DoubledNodes, MeshProblem, MeshReport, SectionMesh};

/// Surfaces of a mesh assembled by hand.
#[derive(Default)]
struct Patches {
    mesh: Mesh,
}

impl Patches {
    /// Adds a structured surface with its own nodes, `cells` by `cells` bilinear
    /// quadrilaterals, as the image of the unit square under `point`, as physical surface
    /// `name`.
    fn add(
        mut self,
        name: &str,
        [columns, rows]: [u32; 2],
        kind: CellKind,
        point: impl Fn(f64, f64) -> [f64; 2],
    ) -> Self {
        let patch = Rectangle {
            width: 1.0,
            height: 1.0,
            cells_y: columns as usize,
            cells_z: rows as usize,
            kind,
            name: name.into(),
        };
        let patch = patch.generate().unwrap();
        let (nodes, cells) = (self.mesh.nodes.len() as u32, self.mesh.cells.len() as u64);
        let group = self.group(name);
        for (i, node) in (1..).zip(&patch.nodes) {
            let [x, y] = point(node.position.x + 0.5, node.position.y + 0.5);
            self.mesh.nodes.push(Node {
                tag: u64::from(nodes) + i,
                position: Vector3::new(x, y, 0.0),
            });
        }
        for (i, cell) in (1..).zip(&patch.cells) {
            let entity = group as i32 + 1;
            let mut cell = Cell::new(cells + i, cell.kind, entity, |n| nodes + cell.nodes()[n]);
            cell.groups = group.into();
            self.mesh.cells.push(cell);
        }
        self
    }

    fn square(self, name: &str, cells: [u32; 2], low: [f64; 2], high: [f64; 2]) -> Self {
        self.add(name, cells, CellKind::Quadrilateral4, |a, b| {
            [
                low[0] + a * (high[0] - low[0]),
                low[1] + b * (high[1] - low[1]),
            ]
        })
    }

    fn group(&mut self, name: &str) -> usize {
        let groups = &mut self.mesh.groups;
        let known = groups
            .iter()
            .position(|group| group.name.as_deref() == Some(name));
        known.unwrap_or_else(|| {
            groups.push(PhysicalGroup {
                dimension: 2,
                tag: groups.len() as i32 + 1,
                name: Some(name.into()),
            });
            groups.len() - 1
        })
    }

    /// Merges the two nodes at each of these positions.
    fn joined(mut self, positions: &[[f64; 2]]) -> Self {
        for position in positions {
            let at = |node: &Node| [node.position.x, node.position.y] == *position;
            let nodes = &self.mesh.nodes;
            let first = nodes.iter().position(at).unwrap() as u32;
            let doubled = nodes.iter().rposition(at).unwrap() as u32;
            assert_ne!(first, doubled);
            for cell in &mut self.mesh.cells {
                let mut moved = Cell::new(cell.tag, cell.kind, cell.entity, |n| {
                    let node = cell.nodes()[n];
                    if node == doubled { first } else { node }
                });
                moved.groups = cell.groups.clone();
                *cell = moved;
            }
        }
        self
    }

    fn accepted(&self, doubled: DoubledNodes) -> MeshReport {
        let checked = SectionMesh::checked(&self.mesh, 1.0, doubled);
        checked.unwrap_or_else(|problems| panic!("{problems:#?}")).1
    }

    fn refused(&self, doubled: DoubledNodes) -> Vec<MeshProblem> {
        SectionMesh::checked(&self.mesh, 1.0, doubled).unwrap_err()
    }

    fn messages(&self) -> Vec<String> {
        let problems = self.refused(DoubledNodes::Error);
        problems.iter().map(MeshProblem::to_string).collect()
    }
}

#[test]
fn a_seam_between_regions_is_an_error_unless_slits_are_allowed() {
    let patches = Patches::default()
        .square("web", [2, 1], [0.0, 0.0], [2.0, 1.0])
        .square("skin", [2, 1], [0.0, 1.0], [2.0, 2.0])
        .joined(&[[0.0, 1.0]]);
    // they share one corner and no side
    assert_eq!(
        patches.messages(),
        [
            "\"web\" and \"skin\" touch along 2 sides between (1, 1) and (2, 1) but share no nodes \
          there: 2 nodes are doubled, as 5 and 8 at (1, 1), 6 and 9 at (2, 1); so the section \
          falls into 2 parts"
        ]
    );
    let problems = patches.refused(DoubledNodes::Allow);
    let help = problems[0].help().unwrap();
    assert!(help.contains("\"allow\" does not join parts"), "{help}");
    let help = patches.refused(DoubledNodes::Error)[0].help().unwrap();
    for word in [
        "Coherence;",
        "BooleanFragments",
        "Geometry.Tolerance",
        "doubled_nodes = \"allow\"",
    ] {
        assert!(help.contains(word), "{word}: {help}");
    }
    // joined along one of the two sides it is a slit
    let slit = patches.joined(&[[1.0, 1.0]]);
    assert_eq!(
        slit.messages(),
        [
            "\"web\" and \"skin\" touch along 1 side between (2, 1) and (2, 1) but share no nodes \
          there: 1 node is doubled, as 6 and 9 at (2, 1)"
        ]
    );
    let report = slit.accepted(DoubledNodes::Allow);
    assert_eq!(report.seams.len(), 1);
    assert_eq!(report.seams[0].pairs, [[6, 9]]);
    assert_eq!(report.coincident_nodes, [[6, 9]]);
    // joined along both it is sound
    let sound = slit.joined(&[[2.0, 1.0]]).accepted(DoubledNodes::Error);
    assert_eq!(
        sound,
        MeshReport {
            unused_nodes: 3,
            ..MeshReport::default()
        }
    );
}

#[test]
fn a_seam_within_a_region_is_an_error_only_where_it_takes_the_section_apart() {
    let patches = |name: &str| {
        Patches::default()
            .square("web", [2, 1], [0.0, 0.0], [2.0, 1.0])
            .square(name, [2, 1], [0.0, 1.0], [2.0, 2.0])
    };
    let apart = patches("web").messages();
    assert_eq!(
        apart,
        [
            "cells of \"web\" touch along 2 sides between (0, 1) and (2, 1) but share no nodes \
          there: 3 nodes are doubled, as 4 and 7 at (0, 1), 5 and 8 at (1, 1), 6 and 9 at (2, 1); \
          so the section falls into 2 parts"
        ]
    );
    let slit = patches("web").joined(&[[0.0, 1.0], [1.0, 1.0]]);
    assert_eq!(slit.accepted(DoubledNodes::Error).seams.len(), 1);
    let border = patches("skin").joined(&[[0.0, 1.0], [1.0, 1.0]]);
    assert_eq!(border.messages().len(), 1);
}

/// Nodes of a doubled border that are off by less than a millionth of the shortest side
/// are treated as doubled; beyond, the border is a gap.
#[test]
fn doubled_nodes_end_where_gaps_begin() {
    let apart = |gap: f64| {
        Patches::default()
            .square("web", [2, 1], [0.0, 0.0], [2.0, 1.0])
            .square("skin", [2, 1], [0.0, 1.0 + gap], [2.0, 2.0 + gap])
    };
    assert!(apart(5e-7).messages()[0].contains("touch along 2 sides"));
    let messages = apart(2e-6).messages();
    assert_eq!(messages.len(), 1);
    assert!(
        messages[0]
            .contains("\n    \"web\" and \"skin\" run within 2e-6 of each other along 2 sides"),
        "{}",
        messages[0]
    );
    let help = apart(2e-6).refused(DoubledNodes::Error)[0].help().unwrap();
    assert!(help.contains("Geometry.Tolerance"), "{help}");
    // a fiftieth of the height of the cells is the limit
    assert!(apart(0.0199).messages()[0].contains("within 0.0199 of each other"));
    assert!(!apart(0.0201).messages()[0].contains("of each other"));
}

/// A ring of radii 1 and 2, open by an angle: at a quarter and three quarters of one
/// face the other is r sin(angle) away. The cells are 0.57 high.
#[test]
fn a_gap_in_a_section_of_one_part_is_a_warning() {
    let ring = |open: f64| {
        Patches::default().add("web", [16, 1], CellKind::Quadrilateral4, |a, b| {
            let (sine, cosine) = ((open - std::f64::consts::TAU) * a).sin_cos();
            [(1.0 + b) * cosine, (1.0 + b) * sine]
        })
    };
    let report = ring(0.004).accepted(DoubledNodes::Error);
    let [gap] = &report.narrow_gaps[..] else {
        panic!("{report:?}")
    };
    assert_eq!((&gap.groups, gap.sides), (&["web".into(), "web".into()], 1));
    let expected = [1.25, 1.75].map(|radius: f64| radius * 0.004_f64.sin());
    assert!((gap.narrowest - expected[0]).abs() < 1e-12, "{gap:?}");
    assert!((gap.widest - expected[1]).abs() < 1e-12, "{gap:?}");
    assert!(
        ring(0.01)
            .accepted(DoubledNodes::Error)
            .narrow_gaps
            .is_empty()
    );
    // closed it is a slit
    let report = ring(0.0).accepted(DoubledNodes::Error);
    assert_eq!((report.seams.len(), report.narrow_gaps.len()), (1, 0));
}

#[test]
fn a_hanging_node_is_named_with_its_side() {
    let patches = Patches::default()
        .square("web", [1, 1], [0.0, 0.0], [2.0, 1.0])
        .square("skin", [2, 1], [0.0, 1.0], [2.0, 2.0])
        .joined(&[[0.0, 1.0], [2.0, 1.0]]);
    assert_eq!(
        patches.messages(),
        [
            "node 6 at (1, 1), a corner of cell 2 in \"skin\", lies on the side from node 4 to \
          node 3 of cell 1 in \"web\", which has no node there: the cells are not joined"
        ]
    );
    let finer = Patches::default()
        .square("web", [1, 1], [0.0, 0.0], [2.0, 1.0])
        .square("skin", [4, 1], [0.0, 1.0], [2.0, 2.0]);
    let messages = finer.messages();
    assert_eq!(messages.len(), 1, "{messages:?}");
    let end = "the cells are not joined; likewise 2 nodes between these surfaces";
    assert!(messages[0].ends_with(end), "{messages:?}");
    let help = patches.refused(DoubledNodes::Error)[0].help().unwrap();
    assert!(help.contains("both cells need the same nodes"), "{help}");
    // here nothing else connects the two, so that no slit can be intended
    assert_eq!(patches.refused(DoubledNodes::Allow).len(), 1);
}

#[test]
fn hanging_nodes_are_slits_where_slits_are_allowed() {
    // a coarse strip next to a fine one, connected by a third strip that shares nodes
    // with both
    let patches = Patches::default()
        .square("web", [1, 1], [0.0, 0.0], [2.0, 1.0])
        .square("skin", [2, 1], [0.0, 1.0], [2.0, 2.0])
        .square("end", [1, 2], [2.0, 0.0], [3.0, 2.0])
        .joined(&[[2.0, 0.0], [2.0, 2.0]]);
    // (2, 1) exists three times
    let patches = patches.joined(&[[2.0, 1.0]]);
    let patches = Patches {
        mesh: merged(patches.mesh, [2.0, 1.0]),
    };
    let report = patches.accepted(DoubledNodes::Allow);
    assert_eq!(report.hanging_nodes.len(), 1);
    assert_eq!(report.hanging_nodes[0].position, [1.0, 1.0]);
    assert!(matches!(
        patches.refused(DoubledNodes::Error)[..],
        [MeshProblem::Hanging { allowed: false, .. }]
    ));
}

/// Merges all nodes at one position.
fn merged(mut mesh: Mesh, position: [f64; 2]) -> Mesh {
    let at = |node: &Node| [node.position.x, node.position.y] == position;
    let is_there: Vec<bool> = mesh.nodes.iter().map(at).collect();
    let first = is_there.iter().position(|is| *is).unwrap() as u32;
    for cell in &mut mesh.cells {
        let node = |n: usize| cell.nodes()[n];
        let mut moved = Cell::new(cell.tag, cell.kind, cell.entity, |n| {
            if is_there[node(n) as usize] {
                first
            } else {
                node(n)
            }
        });
        moved.groups = cell.groups.clone();
        *cell = moved;
    }
    mesh
}

#[test]
fn a_corner_that_only_pokes_at_a_side_is_no_hanging_node() {
    // a diamond whose corner is on the middle of a side: parts
    let patches = Patches::default()
        .square("web", [1, 1], [0.0, 0.0], [2.0, 1.0])
        .add("skin", [1, 1], CellKind::Quadrilateral4, |a, b| {
            [1.0 + a - b, 1.0 + a + b]
        });
    let messages = patches.messages();
    assert_eq!(messages.len(), 1);
    assert!(
        messages[0].starts_with("the section falls into 2 parts"),
        "{messages:?}"
    );
}

#[test]
fn overlapping_cells_are_named_with_a_location() {
    let overlap = |depth: f64| {
        Patches::default()
            .square("web", [1, 1], [0.0, 0.0], [1.0, 1.0])
            .square("skin", [1, 1], [1.0 - depth, 0.3], [2.0, 1.2])
    };
    assert_eq!(
        overlap(0.2).messages(),
        [
            "cells of \"web\" overlap cells of \"skin\": 1 and 2 at (1, 0.65); the area there \
             would be counted twice"
        ]
    );
    // a fiftieth of the lesser height, 0.9, is the limit; below, the sides are too close
    assert!(overlap(0.019).messages()[0].contains("overlap"));
    let messages = overlap(0.017).messages();
    assert!(
        messages[0].contains("run within 0.017 of each other"),
        "{messages:?}"
    );
}

#[test]
fn a_surface_meshed_twice_overlaps_itself() {
    // with the same nodes at the same positions
    let twice = |cells: [u32; 2], low: [f64; 2]| {
        Patches::default()
            .square("web", [3, 3], [0.0, 0.0], [3.0, 3.0])
            .square("web", cells, low, [3.0, 3.0])
    };
    let is_overlap = |patches: &Patches| {
        let problems = patches.refused(DoubledNodes::Error);
        let count = |problem: &MeshProblem| match problem {
            MeshProblem::DoubleCover(overlap) => overlap.cells.len(),
            other => panic!("{other}"),
        };
        problems.iter().map(count).sum::<usize>()
    };
    // the 8 cells of the rim, each with its copy
    assert_eq!(is_overlap(&twice([3, 3], [0.0, 0.0])), 8);
    // with cells of other sizes, and in part
    assert!(is_overlap(&twice([2, 2], [0.0, 0.0])) > 8);
    assert_eq!(is_overlap(&twice([2, 2], [1.0, 1.0])), 4);
    assert_eq!(
        twice([3, 3], [0.0, 0.0]).messages(),
        [
            "cells of \"web\" overlap: 1 and 10 at (0.37, 0.21), 2 and 11 at (1.37, 0.21), 3 and \
             12 at (2.37, 0.21) and 5 pairs like these between (0.21, 0.21) and (2.79, 2.79); the \
             area there would be counted twice"
        ]
    );
    // only the cell in the middle, whose sides coincide with its neighbors' sides
    let copy = Patches::default()
        .square("web", [3, 3], [0.0, 0.0], [3.0, 3.0])
        .square("skin", [1, 1], [1.0, 1.0], [2.0, 2.0]);
    assert_eq!(is_overlap(&copy), 1);
    // a small patch within one cell, far from the boundary
    let patch = Patches::default()
        .square("web", [3, 3], [0.0, 0.0], [3.0, 3.0])
        .square("skin", [1, 1], [1.4, 1.4], [1.6, 1.6]);
    assert_eq!(is_overlap(&patch), 1);
}

#[test]
fn a_strip_wound_over_itself_overlaps() {
    // a turn and a half of a spiral without pitch
    let wound = Patches::default().add("web", [30, 1], CellKind::Quadrilateral4, |a, b| {
        let (sine, cosine) = (-3.0 * std::f64::consts::PI * a).sin_cos();
        [(2.0 + b) * cosine, (2.0 + b) * sine]
    });
    assert!(wound.messages()[0].contains("overlap"));
}

/// Sides of concentric tubes that touch along arcs without shared nodes: the chords of
/// one would reach into the other, the arcs do not.
#[test]
fn curved_sides_that_touch_do_not_overlap() {
    for (around, kind) in [(12, CellKind::Quadrilateral9), (7, CellKind::Triangle6)] {
        let ring = |low: f64| {
            move |a: f64, b: f64| {
                let (sine, cosine) = (-1.9 * std::f64::consts::PI * a).sin_cos();
                [(low + 0.1 * b) * cosine, (low + 0.1 * b) * sine]
            }
        };
        let patches = Patches::default()
            .add("in", [around, 1], kind, ring(1.0))
            .add("out", [around, 1], kind, ring(1.1));
        let messages = patches.messages();
        assert_eq!(messages.len(), 1, "{messages:?}");
        assert!(
            messages[0].starts_with("\"in\" and \"out\" touch along"),
            "{messages:?}"
        );
    }
}

/// Thin walls, open and closed, in coarse curved cells: sides close to each other with
/// material between them are not gaps.
#[test]
fn thin_walls_are_sound() {
    for kind in CellKind::ALL {
        for thickness in [0.3, 1e-2, 1e-4] {
            let tube = Tube {
                outer_radius: 1.0,
                thickness,
                cells_around: 6,
                cells_through: 2,
                kind,
                curved: true,
            };
            let mesh = tube.generate().unwrap();
            let report = Patches { mesh }.accepted(DoubledNodes::Error);
            assert_eq!(report, MeshReport::default(), "{kind:?} {thickness}");
        }
    }
}

/// Rectangles mapped to many shapes, of all kinds of cells, with random dimensions from a
/// fixed sequence: the checks find nothing.
#[test]
fn sound_meshes_of_many_shapes_have_no_findings() {
    let mut state = 0x2545_F491_4F6C_DD1D_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % 10_001) as f64 / 10_000.0
    };
    for round in 0..60 {
        let kind = CellKind::ALL[round % CellKind::ALL.len()];
        let cells = [6 + (9.0 * next()) as u32, 1 + (5.0 * next()) as u32];
        let (bend, taper, shear) = (1.5 * next() + 0.01, 0.7 * next(), next() - 0.5);
        let (wave, slender) = (0.1 * next(), 0.1 + next());
        let turn = 6.0 * next();
        let shape = |a: f64, b: f64| {
            // a tapered, sheared and wavy strip, bent to an arc, rotated
            let height = slender * (b - 0.5) * (1.0 - taper * a);
            let along = a + shear * height + wave * slender * (3.0 * a).sin() * b;
            let (sine, cosine) = (bend * along).sin_cos();
            let radius = 1.0 / bend - 0.3 * height;
            let (y, z) = (radius * sine, 1.0 / bend - radius * cosine);
            let (sine, cosine) = turn.sin_cos();
            [cosine * y - sine * z, sine * y + cosine * z]
        };
        let patches = Patches::default().add("web", cells, kind, shape);
        let report = patches.accepted(DoubledNodes::Error);
        let expected = MeshReport {
            reversed_cells: report.reversed_cells,
            ..MeshReport::default()
        };
        assert_eq!(report, expected, "round {round}");
    }
}

/// Cells between random nodes of a coarse grid, including repeated nodes and cells: the
/// checks always end with a result.
#[test]
fn any_soup_of_cells_has_an_answer() {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = |count: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state % count
    };
    let mut refused = 0;
    for round in 0..400 {
        let mut patches = Patches::default();
        let group = patches.group("web");
        let scale = [1.0, 1e-200, 1e200, f64::NAN][usize::from(round % 20 == 0) * (round % 4)];
        for tag in 1..=12 {
            let [x, y] = [next(4), next(4)].map(|x| scale * x as f64);
            let position = Vector3::new(x, y, 0.0);
            patches.mesh.nodes.push(Node { tag, position });
        }
        for tag in 1..=1 + next(9) {
            let kind = CellKind::ALL[next(5) as usize];
            let mut cell = Cell::new(tag, kind, 1, |_| next(12) as u32);
            cell.groups = group.into();
            patches.mesh.cells.push(cell);
        }
        let checked = SectionMesh::checked(&patches.mesh, 1.0, DoubledNodes::Allow);
        refused += usize::from(checked.is_err());
    }
    assert!(refused > 300, "{refused}");
}

/// A square of two triangles, a thousand times: the search of all pairs of cells
/// or nodes would take minutes and a gigabyte.
#[test]
fn a_stack_of_copies_is_reported_in_a_short_time() {
    let mut patches = Patches::default();
    for _ in 0..1000 {
        patches = patches.add("web", [1, 1], CellKind::Triangle3, |a, b| [a, b]);
    }
    let messages = patches.messages();
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(
        messages[0].starts_with("cells of \"web\" overlap:"),
        "{messages:?}"
    );
}
