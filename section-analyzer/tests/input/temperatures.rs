//! Temperatures by table, from the file to the free strain, in units that are not SI.

use std::fmt::Write;

use section_analyzer::analysis::Analysis;
use section_analyzer::input;
use section_analyzer::mesh::generate::Rectangle;
use shared_geom::gmsh;
use shared_geom::mesh::CellKind;

const SECTION: &str = r#"
mesh = "a.msh"
[units]
length = "mm"
temperature = "degF"
[material.metal]
young = "70 GPa"
poisson = 0.3
density = "2700 kg/m^3"
expansion = 1e-5
[[region]]
group = "bar"
material = "metal"
[temperature.gradient]
rise = 36
gradient = [0, 1.8]
[temperature.map]
table = "rises.csv"
"#;

/// Temperature rises that equal a gradient in the middle of each cell: 20 K and 1000 K/m,
/// and 1.8e-5 1/K. The axial strain equals the strain of the gradient; the bending of a
/// rectangle of n uniformly heated cells is `1 - 1/n^2` of its bending, as the moments of
/// inertia of the cells about their own centers are missing.
#[test]
fn a_table_of_the_rises_of_a_gradient_strains_as_it() {
    let (cells_y, cells_z) = (3, 4);
    let mesh = Rectangle {
        width: 30.0,
        height: 20.0,
        cells_y,
        cells_z,
        kind: CellKind::Quadrilateral8,
        name: "bar".into(),
    };
    let mesh = mesh.generate().unwrap();
    let mut rises = "cell,rise\n".to_owned();
    // in another order than in the mesh
    for cell in mesh.cells.iter().rev() {
        let corners = &cell.nodes()[..4];
        let heights = corners
            .iter()
            .map(|&node| mesh.nodes[node as usize].position[1]);
        let rise = 36.0 + 1.8 * heights.sum::<f64>() / 4.0;
        writeln!(rises, "{},{rise}", cell.tag).unwrap();
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.section.toml");
    std::fs::write(folder.path().join("a.msh"), gmsh::write(&mesh)).unwrap();
    std::fs::write(folder.path().join("rises.csv"), rises).unwrap();
    std::fs::write(&file, SECTION).unwrap();

    let input = input::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
    let analysis = Analysis::new(&input.section).unwrap();
    let found = analysis.imposed(&input.imposed).unwrap();
    let shown = (cells_z * cells_z) as f64;
    for (state, bending) in found.iter().zip([1.8e-2, 1.8e-2 * (1.0 - 1.0 / shown)]) {
        let strain = &state.free_strain;
        let name = &state.state.name;
        // round-off, compared with curvatures of 1e-2 1/m
        assert!((strain[0] / 3.6e-4 - 1.0).abs() < 1e-11, "{name} {strain}");
        assert!((strain[4] / bending - 1.0).abs() < 1e-11, "{name} {strain}");
        for other in [1, 2, 3, 5] {
            assert!(strain[other].abs() < 1e-13, "{name} {strain}");
        }
    }
    assert_eq!(found.len(), 2);
}
