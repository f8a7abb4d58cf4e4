//! Field files read back: counts, types, order of nodes, values.

use shared_geom::mesh::CellKind;
use shared_geom::vtk::FieldFile;
use vtkio::model::{Attribute, DataSet, Piece, UnstructuredGridPiece, Vtk};
use vtkio::xml::VTKFile;

use super::*;
use crate::analysis::analyze;
use crate::output::samples::{bending, rectangle};
use crate::recovery::{LoadCase, recover};
use crate::section::piezo_samples::{LAYER, layer};

/// Rounding to single precision: half of 2^-23.
const SHORT: f64 = 6e-8;

/// The grid of a file, after it has been written and parsed again.
fn read_back(file: FieldFile) -> UnstructuredGridPiece {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vtu");
    file.write(&path).unwrap();
    let text = std::fs::read(&path).unwrap();
    let grid: Vtk = VTKFile::parse(&text[..]).unwrap().try_into().unwrap();
    let DataSet::UnstructuredGrid { mut pieces, .. } = grid.data else {
        panic!("no unstructured grid");
    };
    match pieces.remove(0) {
        Piece::Inline(piece) => *piece,
        other => panic!("{other:?}"),
    }
}

/// The values and the number of components of an array.
fn values(attributes: &[Attribute], name: &str) -> (usize, Vec<f64>) {
    let found = attributes.iter().find_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => Some(array),
        _ => None,
    });
    let array = found.unwrap_or_else(|| panic!("no array {name}"));
    (array.num_comp(), array.data.clone().cast_into().unwrap())
}

#[test]
fn cells_have_the_type_and_the_order_of_their_kind() {
    // numbers of VTK: vtkCellType.h
    let types = [5, 22, 9, 23, 28];
    for (kind, number) in CellKind::ALL.into_iter().zip(types) {
        let section = rectangle(kind);
        let solution = analyze(&section).unwrap();
        let grid = read_back(warping_vtu(&section, &solution));
        assert_eq!(grid.cells.types.len(), section.mesh.cells.len());
        assert!(grid.cells.types.iter().all(|found| *found as u8 == number));
        let (connectivity, offsets) = grid.cells.cell_verts.into_xml();
        let count = kind.node_count();
        assert_eq!(offsets[1] as usize, 2 * count);
        let nodes: Vec<u32> = connectivity[count..2 * count]
            .iter()
            .map(|&n| n as u32)
            .collect();
        assert_eq!(nodes, section.mesh.cells[1].nodes());
        let points: Vec<f64> = grid.points.cast_into().unwrap();
        let [y, z] = section.mesh.nodes[7];
        assert_eq!(points[21..24], [0.0, y, z]);
    }
}

#[test]
fn warping_is_that_of_the_solution_and_per_strain_of_its_stiffness() {
    let section = rectangle(CellKind::Quadrilateral9);
    let solution = analyze(&section).unwrap();
    let grid = read_back(warping_vtu(&section, &solution));
    let (components, found) = values(&grid.data.point, "warping_torsion");
    assert_eq!((components, found.len()), (3, solution.warping.nrows()));
    assert_eq!(found, solution.warping.column(3).as_slice());

    // under a unit rate of twist: the torsional stiffness times the warping of a unit torque
    let (_, twisted) = values(&grid.data.point, "warping_per_strain_torsion");
    let expected = &solution.warping * solution.stiffness.column(3);
    let scale = expected.amax();
    for (found, expected) in twisted.iter().zip(expected.iter()) {
        assert!((found - expected).abs() < 1e-14 * scale);
    }
    assert_eq!(values(&grid.data.cell, "density").1, vec![2700.0; 8]);
    let (components, fibers) = values(&grid.data.cell, "fiber_direction");
    assert_eq!((components, &fibers[..3]), (3, &[1.0, 0.0, 0.0][..]));
    assert_eq!(
        values(&grid.data.cell, "plane_direction").1[..3],
        [0.0, 1.0, 0.0]
    );
    let tags = section.mesh.cells.iter().map(|cell| cell.tag as f64);
    assert_eq!(values(&grid.data.cell, "tag").1, tags.collect::<Vec<_>>());
}

/// Bending of 0.2 by 0.1: I = 0.2 0.1^3 / 12, stress at the upper edge M h / 2I.
#[test]
fn stress_has_a_point_for_each_state_and_its_values() {
    let section = rectangle(CellKind::Quadrilateral8);
    let solution = analyze(&section).unwrap();
    let inertia = 0.2 * 0.1_f64.powi(3) / 12.0;
    let recovery = bending(&section, 1000.0, inertia);
    // cells without strengths have no index
    let mut indices = vec![0.25; section.mesh.cells.len()];
    indices[3] = f64::NAN;
    let index = ("hashin".to_owned(), indices);
    let grid = read_back(stress_vtu(&section, &solution, &recovery, &[index]));

    // two halves meet in 4 cells of 8 nodes: 9 nodes occur twice
    let points: Vec<f64> = grid.points.clone().cast_into().unwrap();
    assert_eq!(points.len(), 3 * (section.mesh.nodes.len() + 9));
    let data = &grid.data;
    let (_, stress) = values(&data.point, "stress_xx");
    assert_eq!(stress.len(), recovery.nodes.len());
    for (point, stress) in points.chunks(3).zip(&stress) {
        let expected = point[2] * 1000.0 / inertia;
        assert!(
            (stress - expected).abs() <= 1e-9 * 3e6,
            "{stress} {expected}"
        );
    }
    let (_, equivalent) = values(&data.point, "von_mises");
    let (components, tensor) = values(&data.point, "stress");
    assert_eq!(components, 6);
    for (k, stress) in stress.iter().enumerate() {
        assert!((equivalent[k] - stress.abs()).abs() <= SHORT * stress.abs());
        assert_eq!(tensor[6 * k..6 * k + 2], [*stress, 0.0]);
    }
    let indices = values(&data.cell, "failure_hashin").1;
    assert_eq!(indices.iter().filter(|index| **index == 0.25).count(), 7);
    assert!(indices[3].is_nan());
    let means = values(&data.cell, "mean_stress_xx").1;
    for (mean, cell) in means.iter().zip(&recovery.cells) {
        let expected = cell.tensors.stress[0];
        assert!((mean - expected).abs() <= SHORT * expected.abs());
    }

    let displacement = values(&data.point, "displacement").1;
    let expected = 1000.0 * solution.warping[(3 * recovery.nodes[5].node + 1, 4)];
    assert!((displacement[3 * 5 + 1] - expected).abs() <= 1e-14 * expected.abs());
    let regions = values(&data.point, "region").1;
    assert_eq!(
        regions.iter().filter(|region| **region == 1.0).count(),
        recovery.nodes.len() / 2
    );
}

/// One array per name, which contains the number of the cells with that name.
#[test]
fn regions_and_materials_are_named() {
    let section = rectangle(CellKind::Quadrilateral4);
    let solution = analyze(&section).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vtu");
    warping_vtu(&section, &solution).write(&path).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let (fields, rest) = text.split_once("</FieldData><Piece").unwrap();
    assert!(!rest.contains("FieldData"));
    for (number, name) in section.mesh.groups.iter().enumerate() {
        let array = format!(
            "<DataArray type=\"Int64\" Name=\"region {name}\" NumberOfTuples=\"1\" \
             format=\"ascii\">{number}</DataArray>"
        );
        assert!(fields.contains(&array), "{array}");
    }
    let material = format!("Name=\"material {}\"", section.materials[0].name);
    assert!(fields.contains(&material));
}

/// The six components of a symmetric tensor of VTK: xx yy zz xy yz xz.
#[test]
fn tensors_are_in_the_order_of_vtk_with_half_the_engineering_shears() {
    let section = rectangle(CellKind::Quadrilateral4);
    let solution = analyze(&section).unwrap();
    let mut recovery = bending(&section, 1.0, 1.0);
    let six = nalgebra::Vector6::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    recovery.cells[0].tensors.stress = six;
    recovery.cells[0].tensors.strain = six;
    recovery.cells[0].tensors.material_stress = 10.0 * six;
    let grid = read_back(stress_vtu(&section, &solution, &recovery, &[]));
    let cell = &grid.data.cell;
    assert_eq!(
        values(cell, "mean_stress").1[..6],
        [1.0, 2.0, 3.0, 6.0, 4.0, 5.0]
    );
    assert_eq!(
        values(cell, "mean_strain").1[..6],
        [1.0, 2.0, 3.0, 3.0, 2.0, 2.5]
    );
    assert_eq!(values(cell, "mean_stress_xy").1[0], 6.0);
    assert_eq!(values(cell, "mean_strain_xz").1[0], 5.0);
    assert_eq!(values(cell, "mean_stress_23").1[0], 40.0);
}

/// Potential, field and displacement of a layer at two volts: V/h everywhere, and the
/// potential between 0 and 2.
#[test]
fn electric_fields_are_vectors_beside_the_stresses() {
    let section = layer();
    let solution = analyze(&section).unwrap();
    let load = LoadCase {
        voltages: vec![("top".into(), 2.0)],
        ..LoadCase::at_point("volts", &nalgebra::Vector6::zeros(), [0.0; 2])
    };
    let recovery = recover(&section, &solution, &load).unwrap();
    let grid = read_back(stress_vtu(&section, &solution, &recovery, &[]));
    let (components, fields) = values(&grid.data.point, "electric_field");
    assert_eq!(components, 3);
    for field in fields.chunks(3) {
        assert!((field[2] * LAYER / -2.0 - 1.0).abs() < SHORT, "{field:?}");
        assert!(field[0].abs().max(field[1].abs()) < 1e-9 / LAYER);
    }
    let (_, means) = values(&grid.data.cell, "mean_electric_displacement");
    assert_eq!(means.len(), 3 * section.mesh.cells.len());
    let (_, potential) = values(&grid.data.point, "potential");
    for (state, potential) in recovery.nodes.iter().zip(&potential) {
        let z = section.mesh.nodes[state.node][1];
        assert!((potential - (1.0 + 2.0 * z / LAYER)).abs() < 1e-11);
    }
    let (_, displacement) = values(&grid.data.point, "displacement");
    let expected = 2.0
        * solution.piezo.as_ref().unwrap().electrodes[1].warping[3 * recovery.nodes[3].node + 1];
    assert!((displacement[3 * 3 + 1] - expected).abs() <= 1e-14 * expected.abs());

    let grid = read_back(warping_vtu(&section, &solution));
    let (_, unit) = values(&grid.data.point, "potential_per_volt_top");
    let size = section
        .mesh
        .nodes
        .iter()
        .zip(&unit)
        .map(|([_, z], v)| (v - 0.5 - z / LAYER).abs());
    assert!(size.fold(0.0, f64::max) < 1e-11);
    assert_eq!(values(&grid.data.point, "warping_per_volt_bottom").0, 3);
    assert_eq!(values(&grid.data.point, "potential_bending_y").0, 1);
}
