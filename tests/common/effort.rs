//! Number of random cases of a property, and the long form of slow tests.

/// Environment variable that requests the long form of random tests.
const LONG: &str = "HELICOID_LONG_TESTS";

/// How much longer the long form is.
const FACTOR: usize = 10;

/// Number of random cases: `usual`, or ten times as many if `HELICOID_LONG_TESTS` is set, as
/// before a release.
pub fn cases(usual: usize) -> usize {
    if is_long() { FACTOR * usual } else { usual }
}

/// Whether the long form is requested.
pub fn is_long() -> bool {
    std::env::var_os(LONG).is_some()
}
