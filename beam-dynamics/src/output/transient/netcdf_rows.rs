//! The table of a run in binary: NetCDF-3, a record for each row.
//!
//! The header is written by the library; it names the columns with their units and contains the
//! number of records. The records follow it, here the 8-byte numbers of one row each. A row is
//! appended before it is counted, so that the file is whole if the run is killed.
//!
//! # References
//! - Unidata, "NetCDF file format specifications": classic and 64-bit offset formats.

use std::fs::{File, OpenOptions};
use std::io::{Cursor, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use netcdf3::{DataSet, FileWriter, InvalidDataSet, Version};

use super::problem::RunFileProblem;
use super::writer::{Heading, RowWriter, cannot_read, cannot_write};

/// Offset of the number of records, four bytes.
const COUNT: std::ops::Range<usize> = 4..8;
/// Bytes of a number.
const NUMBER: usize = 8;

/// Attribute for all columns.
const AXES: &str = "components are in the axes of the model unless long_name states otherwise";

/// A NetCDF file that grows by one record per row.
#[derive(Debug)]
pub(super) struct NetcdfRows {
    path: PathBuf,
    file: File,
    /// Records so far.
    count: u32,
    record: Vec<u8>,
}

impl NetcdfRows {
    /// A new file without records.
    pub fn create(path: &Path, title: &str, headings: &[Heading]) -> Result<Self, RunFileProblem> {
        let header = header(path, title, headings)?;
        let make = || {
            let mut file = File::create(path)?;
            file.write_all(&header)?;
            Ok(file)
        };
        Ok(Self {
            path: path.to_owned(),
            file: make().map_err(|error| cannot_write(path, &error))?,
            count: 0,
            record: Vec::new(),
        })
    }

    /// The file of an earlier part of the run, without its records after `time` \[s\]; a new one if
    /// it does not exist.
    pub fn resume(
        path: &Path,
        title: &str,
        headings: &[Heading],
        time: f64,
    ) -> Result<Self, RunFileProblem> {
        if !path.exists() {
            return Self::create(path, title, headings);
        }
        let header = header(path, title, headings)?;
        let mut bytes = Vec::new();
        let mut file = OpenOptions::new()
            .read(true)
            .write(true)
            .open(path)
            .map_err(|error| cannot_write(path, &error))?;
        file.read_to_end(&mut bytes)
            .map_err(|error| cannot_read(path, &error))?;
        let is_same = bytes.len() >= header.len()
            && bytes[..COUNT.start] == header[..COUNT.start]
            && bytes[COUNT.end..header.len()] == header[COUNT.end..];
        if !is_same {
            let file = path.display().to_string();
            return Err(RunFileProblem::OtherColumns { file });
        }
        let size = NUMBER * headings.len();
        let counted = u32::from_be_bytes([bytes[4], bytes[5], bytes[6], bytes[7]]);
        let records = bytes[header.len()..].chunks_exact(size);
        let is_before = |record: &&[u8]| {
            let first = record.first_chunk().copied().map(f64::from_be_bytes);
            first.is_some_and(|found| found <= time)
        };
        let count = records.take(counted as usize).take_while(is_before).count();
        let mut rows = Self {
            path: path.to_owned(),
            file,
            // Not more than fit into as many bits.
            count: count as u32,
            record: Vec::new(),
        };
        let end = (header.len() + count * size) as u64;
        rows.file
            .set_len(end)
            .and_then(|()| rows.write_count())
            .map_err(|error| cannot_write(path, &error))?;
        Ok(rows)
    }

    fn write_count(&mut self) -> std::io::Result<()> {
        self.file.seek(SeekFrom::Start(COUNT.start as u64))?;
        self.file.write_all(&self.count.to_be_bytes())?;
        self.file.seek(SeekFrom::End(0))?;
        Ok(())
    }

    fn append(&mut self) -> std::io::Result<()> {
        self.file.seek(SeekFrom::End(0))?;
        self.file.write_all(&self.record)?;
        self.count += 1;
        self.write_count()
    }
}

impl RowWriter for NetcdfRows {
    fn path(&self) -> &Path {
        &self.path
    }

    fn write(&mut self, row: &[f64]) -> Result<(), RunFileProblem> {
        self.record.clear();
        let bytes = row.iter().flat_map(|value| value.to_be_bytes());
        self.record.extend(bytes);
        self.append()
            .map_err(|error| cannot_write(&self.path, &error))
    }
}

/// Bytes written by the library, to be taken when it is done.
#[derive(Debug, Clone, Default)]
struct Memory(Arc<Mutex<Cursor<Vec<u8>>>>);

impl Write for Memory {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let mut inner = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        inner.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Seek for Memory {
    fn seek(&mut self, offset: SeekFrom) -> std::io::Result<u64> {
        let mut inner = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        inner.seek(offset)
    }
}

/// The header of a file without records.
fn header(path: &Path, title: &str, headings: &[Heading]) -> Result<Vec<u8>, RunFileProblem> {
    let failed = |reason: String| RunFileProblem::Unreadable {
        file: path.display().to_string(),
        reason,
        remedy: "leave the file out with netcdf = false of [output]",
    };
    let set = data_set(title, headings).map_err(|error| failed(format!("{error:?}")))?;
    let memory = Memory::default();
    let sink = Box::new(memory.clone());
    let mut writer = FileWriter::open_seek_write("", sink).map_err(|e| failed(format!("{e:?}")))?;
    writer
        .set_def(&set, Version::Offset64Bit, 0)
        .map_err(|error| failed(format!("{error:?}")))?;
    drop(writer);
    let bytes = memory.0.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(bytes.get_ref().clone())
}

/// Names, units and meaning of the columns.
fn data_set(title: &str, headings: &[Heading]) -> Result<DataSet, InvalidDataSet> {
    let mut set = DataSet::new();
    set.add_global_attr_string("title", title)?;
    set.add_global_attr_string(
        "source",
        concat!("beam-dynamics ", env!("CARGO_PKG_VERSION")),
    )?;
    set.add_global_attr_string("comment", AXES)?;
    set.set_unlimited_dim("time", 0)?;
    for heading in headings {
        set.add_var_f64(&heading.name, &["time"])?;
        set.add_var_attr_string(&heading.name, "units", &heading.unit)?;
        set.add_var_attr_string(&heading.name, "long_name", &heading.words)?;
    }
    // The convention for axes of time ("CF").
    set.add_var_attr_string("time", "axis", "T")?;
    Ok(set)
}
