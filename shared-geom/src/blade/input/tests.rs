use std::path::PathBuf;

use super::*;
use crate::blade::{Side, read};

fn case(name: &str) -> Reading {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../cases/dynamics");
    let read = read(&folder.join(name).join(format!("{name}.blade.toml")));
    read.unwrap_or_else(|problems| panic!("{problems}"))
}

#[test]
fn probe() {
    for name in ["nrel5mw", "iea15", "tm4760"] {
        let Reading { blade, remarks } = case(name);
        println!("{name} mass {} length {}", blade.mass(), blade.length());
        println!("{remarks:?}");
        println!("{}", blade.at(0.3 * blade.length(), Side::Inner).0);
        let mut c: Vec<f64> = blade
            .stations
            .iter()
            .map(|s| (s.stiffness[(0, 0)] / s.mass[(0, 0)]).sqrt())
            .collect();
        let d: Vec<f64> = blade
            .stations
            .iter()
            .map(|s| {
                ((s.stiffness[(4, 4)] + s.stiffness[(5, 5)]) / (s.mass[(4, 4)] + s.mass[(5, 5)]))
                    .sqrt()
            })
            .collect();
        c.sort_by(f64::total_cmp);
        println!("{:?} {:?}", c, d);
        let p: Vec<f64> = blade
            .stations
            .iter()
            .map(|s| s.mass[(3, 3)] / (s.mass[(4, 4)] + s.mass[(5, 5)]) - 1.0)
            .collect();
        println!("{:?}", p);
    }
}
