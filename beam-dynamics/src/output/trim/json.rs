//! The points of a trim as JSON, for other programs.

use serde_json::{Map, Value, json};

use crate::result::{TrimPoint, TrimResult};

/// Version of the format.
const VERSION: u32 = 1;

/// The names of controls and targets, and all points in their order: value of the parameter of the
/// sweep, controls and targets by their names, iterations, residual, status, and the reason of a
/// failure. Numbers have all digits and the units of `trim.csv`; missing ones are `null`.
pub fn trim_json(result: &TrimResult) -> String {
    let points = result.points.iter().map(|point| of_point(result, point));
    let file = json!({
        "format": "helicoid trim",
        "version": VERSION,
        "name": result.name,
        "program": format!("{} {}", env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION")),
        "method": result.method,
        "parameter": result.sweep,
        "controls": result.controls,
        "targets": result.targets,
        "requested": result.requested,
        "met": result.met().count(),
        "points": points.collect::<Vec<_>>(),
        "remarks": result.remarks,
    });
    // Texts, numbers and lists always have a JSON form.
    serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
}

fn of_point(result: &TrimResult, point: &TrimPoint) -> Value {
    let target = |pair: Option<&[f64; 2]>| match pair {
        Some([found, required]) => {
            json!({ "found": found, "required": required, "error": found - required })
        }
        None => Value::Null,
    };
    let (reason, remedy) = match &point.failure {
        Some([reason, remedy]) => (Some(reason), Some(remedy)),
        None => (None, None),
    };
    json!({
        "at": point.at,
        "status": if reason.is_none() { "met" } else { "not met" },
        "controls": by_name(&result.controls, |i| json!(point.controls.get(i))),
        "targets": by_name(&result.targets, |i| target(point.targets.get(i))),
        "iterations": point.iterations,
        "residual": point.residual,
        "reason": reason,
        "remedy": remedy,
    })
}

/// The value of each index under its name.
fn by_name(names: &[String], value: impl Fn(usize) -> Value) -> Map<String, Value> {
    let named = names.iter().enumerate();
    named.map(|(i, name)| (name.clone(), value(i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(at: Option<f64>) -> TrimPoint {
        TrimPoint {
            at,
            controls: vec![1.0 / 3.0],
            targets: vec![[700.0, 701.0]],
            iterations: 3,
            residual: 2e-12,
            failure: None,
        }
    }

    fn read(sweep: Option<&str>, points: Vec<TrimPoint>) -> Value {
        let result = TrimResult {
            name: "x".to_owned(),
            method: "shooting",
            sweep: sweep.map(str::to_owned),
            requested: 3,
            controls: vec!["collective".to_owned()],
            targets: vec!["lift \"N\"".to_owned()],
            points,
            remarks: vec!["a remark".to_owned()],
        };
        serde_json::from_str(&trim_json(&result)).unwrap()
    }

    #[test]
    fn one_point_has_its_numbers_by_name_with_all_digits() {
        let found = read(None, vec![point(None)]);
        assert_eq!(found["format"], "helicoid trim");
        assert_eq!(found["controls"], json!(["collective"]));
        assert_eq!(
            (&found["parameter"], &found["met"]),
            (&Value::Null, &json!(1))
        );
        assert_eq!(
            found["points"],
            json!([{
                "at": null,
                "status": "met",
                "controls": { "collective": 1.0 / 3.0 },
                "targets": { "lift \"N\"": { "found": 700.0, "required": 701.0, "error": -1.0 } },
                "iterations": 3,
                "residual": 2e-12,
                "reason": null,
                "remedy": null,
            }])
        );
    }

    #[test]
    fn points_of_a_sweep_have_their_parameter_and_failed_ones_their_reason() {
        let failed = TrimPoint {
            targets: Vec::new(),
            residual: f64::NAN,
            failure: Some(["why".to_owned(), "how".to_owned()]),
            ..point(Some(0.2))
        };
        let found = read(Some("mu"), vec![point(Some(0.1)), failed]);
        assert_eq!(found["parameter"], "mu");
        assert_eq!((&found["met"], &found["requested"]), (&json!(1), &json!(3)));
        let [first, last] = [0, 1].map(|i| &found["points"][i]);
        assert_eq!((&first["at"], &last["at"]), (&json!(0.1), &json!(0.2)));
        assert_eq!(
            (&first["status"], &last["status"]),
            (&json!("met"), &json!("not met"))
        );
        assert_eq!(
            (&last["reason"], &last["remedy"]),
            (&json!("why"), &json!("how"))
        );
        assert!(last["residual"].is_null() && last["targets"]["lift \"N\""].is_null());
    }
}
