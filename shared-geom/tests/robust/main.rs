//! Files of any content: readers return a value or report problems, never panic, and
//! never use more memory than a small multiple of the file.
//!
//! The seeds are the seeds of the fuzz targets, `fuzz/corpus`; mutations use a fixed
//! seed, so that every run is the same.

#![allow(
    clippy::unwrap_used,
    reason = "tests of this suite read their own seeds"
)]

mod blade_files;
mod helicoid_blades;
mod mesh_files;
mod meshes_of_others;
mod mutation;
mod property_files;

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Peak bytes of memory for each byte of a file. The worst known text, twenty thousand
/// points on lines of 19 bytes with a separate group each, takes 17: the data of an
/// element, a point, a group and the entries in the tables of tags, and lists that exist
/// twice while they grow.
const FACTOR: usize = 32;

/// Bytes for messages and names of any file, however short: twenty problems of a few
/// hundred bytes, and the same again while they are formatted.
const SLACK: usize = 16 << 10;

/// Bytes of a zlib decoder: its window of 32 KiB and its tables.
const ZLIB: usize = 44 << 10;

/// Tests that measure memory run one at a time: the count is of the process.
static ALONE: Mutex<()> = Mutex::new(());

fn alone() -> MutexGuard<'static, ()> {
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs `read` on `bytes` and checks its peak memory; returns its result.
fn within_memory<T>(what: &str, bytes: &[u8], read: impl FnOnce(&[u8]) -> T) -> T {
    within(what, bytes, SLACK, read)
}

/// As [`within_memory`], with `slack` bytes for any file.
fn within<T>(what: &str, bytes: &[u8], slack: usize, read: impl FnOnce(&[u8]) -> T) -> T {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let value = read(bytes);
    let taken = MEMORY.peak_usage().saturating_sub(before);
    let most = FACTOR * bytes.len() + slack;
    assert!(
        taken <= most,
        "{what}: {taken} bytes used for {} of the file, at most {most} expected",
        bytes.len()
    );
    value
}

/// The seeds of a fuzz target, by name.
fn seeds(target: &str) -> Vec<(String, Vec<u8>)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz/corpus");
    let folder: PathBuf = [folder, target].iter().collect();
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        (name, std::fs::read(path).unwrap())
    });
    let mut seeds: Vec<_> = entries.collect();
    seeds.sort();
    assert!(!seeds.is_empty(), "{target}");
    seeds
}
