//! Planes of a turbulence box, in memory or read from files when they are needed.
//!
//! A box may be larger than the memory: of a file only the planes that were used last are kept,
//! at most a given number. Values do not depend on the order in which planes are read.

use std::collections::HashMap;
use std::ffi::OsStr;
use std::fmt::{self, Debug};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use super::problem::WindProblem;
use super::scale::Scale;

/// Bytes of planes that are kept by default.
const CACHE_BYTES: usize = 64 << 20;

/// Least number of planes that are kept: two are needed by one point.
const LEAST: usize = 2;

/// Velocities of a plane, in the order of the grid \[m/s\].
pub(super) type Plane = Arc<[f64]>;

/// Numbers of a cache, since the box was opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CacheCount {
    /// Planes that were read from the file, some of them repeatedly.
    pub read: u64,
    /// Planes in memory now.
    pub held: usize,
    /// Largest number of planes in memory.
    pub most: usize,
    /// Largest number of planes that is allowed.
    pub limit: usize,
}

/// Bytes of a plane as velocities: a format of files.
pub(super) trait Decode: Debug + Send + Sync {
    /// Number of values of a plane.
    fn values(&self) -> usize;

    /// Fills `values` from the bytes of each file.
    fn decode(&self, bytes: &[Vec<u8>], values: &mut [f64]);
}

/// Bytes of a plane as scaled velocities.
#[derive(Debug)]
struct Scaled {
    decode: Box<dyn Decode>,
    scale: Scale,
}

impl Decode for Scaled {
    fn values(&self) -> usize {
        self.decode.values()
    }

    fn decode(&self, bytes: &[Vec<u8>], values: &mut [f64]) {
        self.decode.decode(bytes, values);
        self.scale.apply(values);
    }
}

/// A file of planes of equal size.
#[derive(Debug)]
pub(super) struct PlaneFile {
    /// Its name, for messages.
    pub name: String,
    /// The open file.
    pub file: File,
    /// Byte at which the first plane begins.
    pub start: u64,
    /// Bytes of a plane.
    pub bytes: usize,
}

/// Planes of a box.
#[derive(Debug)]
pub(super) enum Planes {
    /// All in memory.
    Memory(Vec<Plane>),
    /// In files.
    Files(FilePlanes),
}

/// Planes in files, and the ones that are kept.
pub(super) struct FilePlanes {
    decode: Box<dyn Decode>,
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    files: Vec<PlaneFile>,
    /// Plane, and the last use.
    kept: HashMap<usize, (Plane, u64)>,
    uses: u64,
    count: CacheCount,
}

impl Planes {
    /// Planes that are in memory.
    pub fn memory(planes: Vec<Vec<f64>>) -> Self {
        Self::Memory(planes.into_iter().map(Plane::from).collect())
    }

    /// Planes in `files`; at most `limit` are kept, by default 64 MB of them.
    pub fn files(files: Vec<PlaneFile>, decode: Box<dyn Decode>, limit: Option<usize>) -> Self {
        let bytes = (decode.values() * size_of::<f64>()).max(1);
        let limit = limit.unwrap_or(CACHE_BYTES / bytes).max(LEAST);
        let state = Mutex::new(State {
            files,
            kept: HashMap::new(),
            uses: 0,
            count: CacheCount {
                limit,
                ..CacheCount::default()
            },
        });
        Self::Files(FilePlanes { decode, state })
    }

    /// The same planes with scaled deviations from their mean.
    pub fn scaled(self, scale: Scale) -> Self {
        match self {
            Self::Memory(planes) => {
                let scaled = |plane: &Plane| {
                    let mut values = plane.to_vec();
                    scale.apply(&mut values);
                    Plane::from(values)
                };
                Self::Memory(planes.iter().map(scaled).collect())
            }
            Self::Files(FilePlanes { decode, state }) => {
                let mut state = state.into_inner().unwrap_or_else(PoisonError::into_inner);
                state.kept.clear();
                state.count.held = 0;
                Self::Files(FilePlanes {
                    decode: Box::new(Scaled { decode, scale }),
                    state: Mutex::new(state),
                })
            }
        }
    }

    /// The plane `index` of the file.
    ///
    /// # Errors
    /// The file can no longer be read.
    pub fn plane(&self, index: usize) -> Result<Plane, WindProblem> {
        match self {
            Self::Memory(planes) => planes.get(index).cloned().ok_or_else(|| WindProblem::Read {
                file: "the box in memory".to_owned(),
                plane: index,
                reason: "it has fewer planes".to_owned(),
            }),
            Self::Files(files) => files.plane(index),
        }
    }

    /// Numbers of the cache; zeros for a box in memory.
    pub fn count(&self) -> CacheCount {
        match self {
            Self::Memory(_) => CacheCount::default(),
            Self::Files(files) => files.lock(|state| state.count),
        }
    }
}

/// Files and format, without the planes in memory: the text identifies the wind of a model.
impl Debug for FilePlanes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let files = self.lock(|state| {
            let of = |file: &PlaneFile| {
                let name = Path::new(&file.name).file_name().map(OsStr::to_owned);
                let length = file.file.metadata().map_or(0, |metadata| metadata.len());
                (name, file.start, file.bytes, length)
            };
            state.files.iter().map(of).collect::<Vec<_>>()
        });
        f.debug_struct("FilePlanes")
            .field("decode", &self.decode)
            .field("files", &files)
            .finish()
    }
}

impl FilePlanes {
    fn lock<T>(&self, action: impl FnOnce(&mut State) -> T) -> T {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        action(&mut state)
    }

    fn plane(&self, index: usize) -> Result<Plane, WindProblem> {
        self.lock(|state| {
            state.uses += 1;
            let now = state.uses;
            if let Some((plane, used)) = state.kept.get_mut(&index) {
                *used = now;
                return Ok(plane.clone());
            }
            let bytes = state.read(index)?;
            let mut values = vec![0.0; self.decode.values()];
            self.decode.decode(&bytes, &mut values);
            let plane = Plane::from(values);
            state.keep(index, plane.clone());
            Ok(plane)
        })
    }
}

impl State {
    /// The bytes of a plane in each file.
    fn read(&mut self, index: usize) -> Result<Vec<Vec<u8>>, WindProblem> {
        self.count.read += 1;
        let mut all = Vec::with_capacity(self.files.len());
        for file in &mut self.files {
            let mut bytes = vec![0; file.bytes];
            let start = file.start + index as u64 * file.bytes as u64;
            let sought = file.file.seek(SeekFrom::Start(start));
            let read = sought.and_then(|_| file.file.read_exact(&mut bytes));
            read.map_err(|error| WindProblem::Read {
                file: file.name.clone(),
                plane: index,
                reason: error.to_string(),
            })?;
            all.push(bytes);
        }
        Ok(all)
    }

    /// Keeps a plane; the one that was not used for the longest time makes way for it.
    fn keep(&mut self, index: usize, plane: Plane) {
        while self.kept.len() >= self.count.limit {
            let oldest = self.kept.iter().min_by_key(|(_, (_, used))| *used);
            let Some(oldest) = oldest.map(|(index, _)| *index) else {
                break;
            };
            self.kept.remove(&oldest);
        }
        self.kept.insert(index, (plane, self.uses));
        self.count.held = self.kept.len();
        self.count.most = self.count.most.max(self.count.held);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    #[derive(Debug)]
    struct Bytes;

    impl Decode for Bytes {
        fn values(&self) -> usize {
            4
        }

        fn decode(&self, bytes: &[Vec<u8>], values: &mut [f64]) {
            for (value, byte) in values.iter_mut().zip(&bytes[0]) {
                *value = f64::from(*byte);
            }
        }
    }

    fn planes(limit: usize) -> Planes {
        let mut file = tempfile::tempfile().unwrap();
        file.write_all(&[9]).unwrap();
        for plane in 0..50_u8 {
            file.write_all(&[plane; 4]).unwrap();
        }
        let file = PlaneFile {
            name: "bytes".to_owned(),
            file,
            start: 1,
            bytes: 4,
        };
        Planes::files(vec![file], Box::new(Bytes), Some(limit))
    }

    #[test]
    fn the_memory_is_bounded_and_the_last_planes_are_kept() {
        let planes = planes(3);
        for index in [7, 8, 9, 8, 10, 8] {
            assert_eq!(planes.plane(index).unwrap()[3], index as f64);
        }
        // 7, 8, 9 and 10 were read, 7 was given up for 10
        let count = planes.count();
        assert_eq!((count.read, count.held, count.most), (4, 3, 3));
        planes.plane(7).unwrap();
        planes.plane(10).unwrap();
        assert_eq!(planes.count().read, 5);
    }

    #[test]
    fn a_plane_beyond_the_end_is_an_error() {
        let planes = planes(0);
        assert!(matches!(
            planes.plane(50),
            Err(WindProblem::Read { plane: 50, .. })
        ));
        assert_eq!(planes.count().limit, 2);
        assert!(Planes::memory(vec![]).plane(0).is_err());
    }

    #[test]
    fn threads_read_the_same_values() {
        let planes = planes(4);
        std::thread::scope(|scope| {
            for start in 0..4 {
                let planes = &planes;
                scope.spawn(move || {
                    for i in 0..500 {
                        let index = (start * 13 + i * 7) % 50;
                        assert_eq!(planes.plane(index).unwrap()[0], index as f64);
                    }
                });
            }
        });
        assert_eq!(planes.count().most, 4);
    }
}
