//! Constants that airfoils state.

use std::sync::Arc;

use crate::airfoil::{Section, UnsteadyConstants, built_in};
use crate::unsteady::{DynamicStall, Hgm, Lags, Oye, SectionModel, SeparationLag};

/// Half an airfoil with constants, half one without.
fn blend(constants: &[(&str, f64)]) -> Section {
    let mut own = UnsteadyConstants::default();
    for (name, value) in constants {
        own.set(name, *value);
    }
    let plain = built_in("naca0012").unwrap();
    let stated = plain.clone().with_unsteady(own);
    Section::weighted(&[(0.5, Arc::new(stated)), (0.5, Arc::new(plain))]).unwrap()
}

#[test]
fn models_have_the_constants_of_airfoils_in_their_parts() {
    let section = blend(&[("T_F0", 2.0), ("T_p", 1.1), ("A1", 0.3), ("T_VL", 11.0)]);
    let of = |word: &str| SectionModel::of_word(word).unwrap().of_section(&section);
    // Means of the stated value and the one of the model: 6 and 7 semichords, 1.7 and 0.165.
    let oye = SectionModel::Oye(Oye {
        separation_time: 4.0,
    });
    assert_eq!(of("oye"), oye);
    let SectionModel::DynamicStall(DynamicStall { constants, lags }) = of("dynamic_stall") else {
        panic!("another model")
    };
    assert_eq!(
        (constants.passage_time, constants.separation_time),
        (9.0, 2.5)
    );
    assert!((lags.parts[0] - 0.2325).abs() < 1e-15);
    assert_eq!(lags.rates, Lags::JONES.rates);
    let SectionModel::SeparationLag(SeparationLag { pressure_time, .. }) = of("separation_lag")
    else {
        panic!("another model")
    };
    assert!((pressure_time - 1.4).abs() < 1e-15);
    assert_eq!(
        of("quasi_steady"),
        SectionModel::of_word("quasi_steady").unwrap()
    );
}

#[test]
fn a_time_that_is_not_positive_is_not_used() {
    let section = blend(&[("T_p", -1.7), ("T_f0", f64::NAN)]);
    let found = SectionModel::Hgm(Hgm::default()).of_section(&section);
    assert_eq!(found, SectionModel::Hgm(Hgm::default()));
}

#[test]
fn used_constants_are_named() {
    let used = |word: &str| SectionModel::of_word(word).unwrap().used_constants();
    assert_eq!(used("oye"), ["T_f0", "alpha0", "C_nalpha"]);
    assert_eq!(used("lagged"), ["A1", "A2", "b1", "b2"]);
    assert!(used("quasi_steady").is_empty());
    for name in ["T_V0", "T_VL", "Cn1", "eta_e", "alpha1", "S2"] {
        assert!(used("dynamic_stall").contains(&name), "{name}");
        assert!(!used("hgm").contains(&name), "{name}");
    }
}
