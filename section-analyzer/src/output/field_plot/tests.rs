//! Tests.
use crate::input::InputSummary;
use crate::mesh::generate::*;
use crate::output::samples::*;
use crate::output::stress_plots;
use nalgebra::Vector6;
use shared_geom::figure::save;
use shared_geom::mesh::CellKind;

fn summary(unit: &str, factor: f64) -> InputSummary {
    InputSummary {
        file: "a".into(),
        mesh_file: "a".into(),
        input_hash: String::new(),
        length_unit: unit.into(),
        length_factor: factor,
        kinds: Vec::new(),
        regions: Vec::new(),
        warnings: Vec::new(),
    }
}

fn out(
    section: &crate::section::Section,
    recovery: &crate::recovery::Recovery,
    name: &str,
    failure: &[(String, Vec<f64>)],
) {
    let t = std::time::Instant::now();
    for (word, plot) in stress_plots(section, &summary("m", 1.0), recovery, failure) {
        save(
            std::path::Path::new(&format!("/tmp/fo/{name}.{word}.png")),
            plot.size(),
            &plot,
        )
        .unwrap();
    }
    println!("{name} {:?}", t.elapsed());
}

#[test]
fn look() {
    let s = rectangle(CellKind::Quadrilateral8);
    let inertia = 0.2 * 0.1_f64.powi(3) / 12.0;
    let mut r = recovery(
        &s,
        "gust up",
        Vector6::new(0.0, 0.0, 5000.0, 0.0, 1234.5, 0.0),
        |_, [_, z]| {
            Vector6::new(
                z * 1234.5 / inertia,
                0.0,
                0.0,
                0.0,
                1.5 * 5000.0 / 0.02 * (1.0 - (z / 0.05).powi(2)),
                0.0,
            )
        },
    );
    r.load.name = "gust up".into();
    let idx: Vec<f64> = r
        .cells
        .iter()
        .map(|c| c.tensors.stress[0].abs() / 2.5e6)
        .collect();
    out(
        &s,
        &r,
        "rect",
        &[("max_stress".into(), idx.clone()), ("Tsai-Wu".into(), idx)],
    );
    for (name, thick) in [("tube_thin", 0.0003), ("tube", 0.01)] {
        let m = Tube {
            outer_radius: 0.1,
            thickness: thick,
            cells_around: 48,
            cells_through: 1,
            kind: CellKind::Quadrilateral9,
            curved: true,
        }
        .generate()
        .unwrap();
        let s = section(&m, name, false);
        let r = recovery(
            &s,
            "torque",
            Vector6::new(0.0, 0.0, 0.0, 300.0, 0.0, 0.0),
            |_, [y, z]| {
                let j = 2.0 * std::f64::consts::PI * 0.001 * thick;
                Vector6::new(1e-7 * y, 0.0, 0.0, 0.0, 300.0 * y / j, -300.0 * z / j)
            },
        );
        out(&s, &r, name, &[]);
    }
    for (name, kind) in [
        ("iso_channel", "v41"),
        ("box_CUS_45_m45", "v41"),
        ("blade_naca", "v41"),
    ] {
        let p = format!(
            "{}/../tests/reference/sections/{name}.{kind}.msh",
            env!("CARGO_MANIFEST_DIR")
        );
        let m = shared_geom::gmsh::read(&std::fs::read_to_string(&p).unwrap(), &p).unwrap();
        let mut s = section(&m, name, false);
        for n in &mut s.mesh.nodes {
            *n = n.map(|x| x * 0.0254);
        }
        println!("{} nodes {:?}", s.mesh.nodes.len(), s.mesh.groups);
        let r = recovery(
            &s,
            "bending and shear",
            Vector6::new(0.0, 0.0, 50.0, 0.0, 300.0, 10.0),
            |g, [y, z]| {
                let k = 1.0 + 0.7 * g as f64;
                Vector6::new(
                    1e9 * k * (z + 0.3 * y),
                    1e6,
                    0.0,
                    0.0,
                    2e8 * (y - 0.02),
                    -3e8 * z * k,
                )
            },
        );
        out(&s, &r, name, &[]);
    }
}
