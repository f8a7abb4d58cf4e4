//! windIO files: round trips, reference data, bad input.
