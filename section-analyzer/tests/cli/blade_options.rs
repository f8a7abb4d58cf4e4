//! `section-analyzer blade --check` and `--compare`.

use serde_json::Value;

use crate::whole_blade::LAYUP;
use crate::workplace::{Run, Workplace};

fn workplace(text: &str) -> Workplace {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", text);
    workplace
}

fn blade(workplace: &Workplace, more: &[&str]) -> Run {
    workplace.run(&[&["blade", "a.layup.toml", "--out", "b"], more].concat())
}

/// Nothing is written; a station that cannot be meshed is reported as in a run that solves.
#[test]
fn check_meshes_and_writes_nothing() {
    let place = workplace(LAYUP);
    let check = ["blade", "a.layup.toml", "--stations", "0.2,0.8", "--check"];
    let run = place.run(&check);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert_eq!(run.out.matches(" sound ").count(), 3, "{}", run.out);
    assert!(!place.path("results").exists());
    let thick = LAYUP.replace(
        "thickness = 1.5",
        "thickness = { eta = [0, 1], value = [1.5, 60] }",
    );
    place.write("a.layup.toml", &thick);
    let run = place.run(&check);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("eta 0.8"), "{}", run.err);
    let run = place.run(&[&check[..], &["--report"]].concat());
    assert_eq!(run.code, 2);
}

/// Materials that are likely in another unit are remarked as in a run that solves, also if nothing else is
/// shown.
#[test]
fn check_has_the_remarks_on_materials() {
    let place = workplace(&LAYUP.replace("stress = \"GPa\"", "stress = \"MPa\""));
    let stations = ["--stations", "0.2,0.7"];
    let run = ["blade", "a.layup.toml", "--check"];
    let run_check = |more: &[&str]| place.run(&[&run[..], &stations, more].concat());
    let remarks = |run: &Run| -> Vec<String> {
        let lines = run.out.lines().filter(|line| line.contains("material"));
        lines.map(str::to_owned).collect()
    };
    let check = run_check(&[]);
    assert_eq!((check.code, check.err.as_str()), (0, ""));
    let solved = blade(&place, &[&stations[..], &["--no-figures"]].concat());
    let found = remarks(&check);
    assert_eq!(found, remarks(&solved));
    let expected = "remark: eta 0.2, eta 0.7: material \"glass\": no known material has the modulus 4.000e7 Pa";
    assert!(found.len() == 1 && found[0].contains(expected), "{found:?}");
    let quiet = run_check(&["--quiet"]);
    assert!(quiet.err.contains("warning: eta 0.2"), "{}", quiet.err);
}

/// A blade beside itself in another format, and beside the same with a thicker cap.
#[test]
fn differences_from_another_blade_are_listed() {
    let place = workplace(LAYUP);
    let stations = ["--stations", "0.2,0.7", "--no-figures"];
    let run = blade(&place, &[&stations[..], &["--format", "beamdyn"]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    std::fs::rename(place.path("b/beamdyn"), place.path("other")).unwrap();
    let other = std::fs::read_dir(place.path("other")).unwrap();
    let mut other = other.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let main = other
        .find(|name| !name.contains("blade"))
        .unwrap_or_default();
    let other = format!("other/{main}");
    let same = blade(&place, &[&stations[..], &["--compare", &other]].concat());
    assert_eq!((same.code, same.err.as_str()), (0, ""));
    let differences = |column: &str| -> Vec<f64> {
        let text = place.read("b/a.compare.csv");
        let mut lines = text.lines();
        let names = lines.next().unwrap().split(',');
        let at = names.clone().position(|name| name == column).unwrap();
        lines
            .map(|line| line.split(',').nth(at).unwrap().parse().unwrap())
            .collect()
    };
    for column in ["mass", "ea", "ei_flap", "ei_edge", "gj"] {
        let found = differences(&format!("{column}_difference [%]"));
        assert!(
            found.len() == 2 && found.iter().all(|part| part.abs() < 1e-8),
            "{found:?}"
        );
    }
    place.write(
        "a.layup.toml",
        &LAYUP.replace("value = [4, 2]", "value = [5, 3]"),
    );
    let changed = blade(&place, &[&stations[..], &["--compare", &other]].concat());
    assert_eq!(changed.code, 0);
    assert!(
        differences("ei_flap_difference [%]")
            .iter()
            .all(|part| *part > 1.0)
    );
    assert!(changed.out.contains("Differences from"), "{}", changed.out);
    // without the option the table is removed
    assert_eq!(blade(&place, &stations).code, 0);
    assert!(!place.path("b/a.compare.csv").exists());
}

/// The figure of mass and stiffness has a further curve for each quantity that is compared, and the names of
/// both blades; the figures without another blade have no names.
#[test]
fn another_blade_is_in_the_figures() {
    let place = workplace(LAYUP);
    let stations = ["--stations", "0.2,0.7"];
    assert_eq!(blade(&place, &stations).code, 0);
    let figure = || place.read("b/a.span.svg");
    let curves = |text: &str| text.matches("<polyline").count();
    let alone = figure();
    assert!(!alone.contains("published"));
    let other = place.read("b/a.blade.json");
    let other = other.replacen("\"name\": \"a\"", "\"name\": \"published\"", 1);
    place.write("other.blade.json", &other);
    let compared = [&stations[..], &["--compare", "other.blade.json"]].concat();
    assert_eq!(blade(&place, &compared).code, 0);
    let both = figure();
    // five curves, and two lines of the legend of each of the six panels
    assert_eq!(curves(&both), curves(&alone) + 5 + 6 * 2);
    assert!(both.contains("published"));
}

/// A blade without shear stiffness is compared as one that is rigid in shear: mass and EA are the values of the
/// file, and EI and GJ the values of
///
/// ```text
/// EI = eigenvalues of inverse(D[2..3, 2..3]),  GJ = 1/D11,  D = inverse(K[1,4,5,6])[4..6]
/// ```
///
/// to the round-off of an inverse, as rigid shear does not couple.
#[test]
fn a_blade_without_shear_is_compared() {
    use nalgebra::{Matrix2, Matrix4};

    let place = workplace(LAYUP);
    let stations = ["--stations", "0.2,0.7", "--no-figures"];
    assert_eq!(blade(&place, &stations).code, 0);
    let mut other: Value = serde_json::from_str(&place.read("b/a.blade.json")).unwrap();
    let mut expected = Vec::new();
    for station in other["stations"].as_array_mut().unwrap() {
        let k = &mut station["stiffness"];
        let rest = [0, 3, 4, 5];
        let entry = |i: usize, j: usize| k[rest[i]][rest[j]].as_f64().unwrap();
        let d = Matrix4::from_fn(entry).try_inverse().unwrap();
        let bending = Matrix2::from_fn(|i, j| d[(i + 2, j + 2)]);
        let values = bending.symmetric_eigenvalues();
        expected.push([
            entry(0, 0),
            1.0 / values.max(),
            1.0 / values.min(),
            1.0 / d[(1, 1)],
        ]);
        for i in 0..6 {
            for j in [1, 2] {
                k[i][j] = 0.0.into();
                k[j][i] = 0.0.into();
            }
        }
    }
    place.write("bare.blade.json", &other.to_string());
    let run = blade(
        &place,
        &[&stations[..], &["--compare", "bare.blade.json"]].concat(),
    );
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    let text = place.read("b/a.compare.csv");
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().unwrap();
    for (row, expected) in lines.zip(expected) {
        let of = |column: &str| -> f64 {
            let at = names.iter().position(|name| *name == column).unwrap();
            row[at].parse().unwrap()
        };
        assert_eq!(of("mass_difference [%]"), 0.0);
        let columns = [
            "ea_other [N]",
            "ei_flap_other [N m^2]",
            "ei_edge_other [N m^2]",
            "gj_other [N m^2]",
        ];
        for (column, expected) in columns.iter().zip(expected) {
            let error = of(column) / expected - 1.0;
            println!("{column} {error:e}");
            assert!(error.abs() < 1e-9, "{column}: {error}");
        }
    }
}
