//! The variational three-node beam against its reference, `tests/reference/dynamics/
//! variational_beam`: one general element in every number, spectra that must not grow,
//! large deflections, frequencies, and energy in free flight. See the README there.

mod acceptance;
mod flight;
mod frequencies;
pub mod spectra;
mod unit_element;

use nalgebra::{Matrix3, Matrix6, Vector3};
use serde_json::Value;

fn reference(name: &str) -> Value {
    let folder = env!("CARGO_MANIFEST_DIR");
    let file = format!("{folder}/tests/reference/dynamics/variational_beam/{name}.json");
    serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap()
}

/// All numbers of nested lists, in their order.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(list) => list.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().unwrap()],
    }
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_column_slice(&numbers(value))
}

fn matrix(value: &Value) -> Matrix3<f64> {
    Matrix3::from_row_slice(&numbers(value))
}

fn stiffness(value: &Value) -> Matrix6<f64> {
    Matrix6::from_row_slice(&numbers(value))
}

/// The row of the acceptance list of a case, for the quantity with this beginning.
fn row(case: &str, quantity: &str) -> Value {
    let list = reference("acceptance");
    let rows = list["cases"].as_array().unwrap();
    let is_it = |row: &&Value| {
        row["case"].as_str() == Some(case)
            && row["quantity"].as_str().unwrap().starts_with(quantity)
    };
    rows.iter().find(is_it).unwrap().clone()
}

/// 6x6 mass of a section: mass, first moment, inertia about the reference line.
fn mass(mass: f64, s: &Vector3<f64>, inertia: &Matrix3<f64>) -> Matrix6<f64> {
    let mut out = Matrix6::from_diagonal_element(mass);
    let skew = Matrix3::new(0.0, -s.z, s.y, s.z, 0.0, -s.x, -s.y, s.x, 0.0);
    out.fixed_view_mut::<3, 3>(0, 3).copy_from(&-skew);
    out.fixed_view_mut::<3, 3>(3, 0).copy_from(&skew);
    out.fixed_view_mut::<3, 3>(3, 3).copy_from(inertia);
    out
}
