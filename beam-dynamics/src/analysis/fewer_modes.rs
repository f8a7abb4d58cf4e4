//! Reasons for fewer modes than requested.

use crate::modes::Lowest;

/// The reason as text. It states that the model has no more modes only if all modes of the
/// model were found and confirmed.
pub(super) fn why_no_more(lowest: &Lowest) -> String {
    let overdamped = lowest.real.iter().filter(|growth| **growth < 0.0).count();
    match (lowest.unconfirmed, overdamped) {
        (0, 0) if lowest.is_all => "the model has no more".to_owned(),
        (0, 0) => {
            "the other frequencies are too high to be distinguished from infinite ones".to_owned()
        }
        (0, n) => format!("motions too damped to oscillate: {n}"),
        (n, _) => format!(
            "{n} more frequencies were seen, but no vector confirmed them, as where \
             stiffnesses, masses or lengths of very different size meet in the model"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_model_has_no_more_only_where_that_is_known() {
        let of = |unconfirmed, is_all, real: &[f64]| {
            let real = real.to_vec();
            let pairs = Vec::new();
            why_no_more(&Lowest {
                pairs,
                real,
                unconfirmed,
                is_all,
            })
        };
        assert_eq!(of(0, true, &[]), "the model has no more");
        for other in [of(0, false, &[]), of(3, false, &[]), of(0, true, &[-2.0])] {
            assert!(!other.contains("has no more"), "{other}");
        }
        assert!(of(3, false, &[-1.0]).starts_with("3 more frequencies were seen"));
    }
}
