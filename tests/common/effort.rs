//! Number of random cases of a property.

/// Setting of the environment that asks for the long form of random tests.
const LONG: &str = "HELICOID_LONG_TESTS";

/// How much longer the long form is.
const FACTOR: usize = 10;

/// Number of random cases: `usual`, or ten times as many if `HELICOID_LONG_TESTS` is set, as
/// before a release.
pub fn cases(usual: usize) -> usize {
    match std::env::var_os(LONG) {
        Some(_) => FACTOR * usual,
        None => usual,
    }
}
