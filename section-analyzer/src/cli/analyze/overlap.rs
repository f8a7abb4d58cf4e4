//! Sections that would write the same result files: reported before the run.

use std::collections::HashMap;
use std::path::PathBuf;

use shared_geom::error::Explain;
use shared_geom::files::true_path;

use super::Job;

/// Two sections with the same result files.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "\"{first}\" and \"{second}\" would both write \"{file}\", expected other result files for each section"
)]
pub(super) struct Overlap {
    first: String,
    second: String,
    /// One of the files.
    file: String,
}

impl Explain for Overlap {
    fn help(&self) -> Option<String> {
        Some(if self.first == self.second {
            "name each section file once".to_owned()
        } else {
            "give one of the section files another name, or remove --out".to_owned()
        })
    }
}

/// All sections whose files an earlier one writes too.
pub(super) fn overlaps(jobs: &[Job]) -> Vec<Overlap> {
    let mut first_of: HashMap<(PathBuf, &str), &Job> = HashMap::new();
    let mut found = Vec::new();
    for job in jobs {
        let key = (true_path(&job.folder), job.name.as_str());
        match first_of.get(&key) {
            Some(first) => found.push(Overlap {
                first: first.file.display().to_string(),
                second: job.file.display().to_string(),
                file: properties_of(job),
            }),
            None => {
                first_of.insert(key, job);
            }
        }
    }
    found
}

fn properties_of(job: &Job) -> String {
    let file = job.folder.join(format!("{}.properties.json", job.name));
    file.display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn jobs(files: &[&str], out: Option<&str>) -> Vec<Job> {
        let job = |file: &&str| Job::new(Path::new(file), out.map(Path::new));
        files.iter().map(job).collect()
    }

    #[test]
    fn sections_of_one_name_need_folders_of_their_own() {
        let files = ["a/x.section.toml", "b/x.section.toml", "./a/x.section.toml"];
        let found = overlaps(&jobs(&files, None));
        assert_eq!(found.len(), 1);
        assert_eq!(
            found[0].to_string(),
            "\"a/x.section.toml\" and \"./a/x.section.toml\" would both write \
             \"./a/results/x.properties.json\", expected other result files for each section"
        );
        assert_eq!(overlaps(&jobs(&files, Some("out"))).len(), 2);
        assert_eq!(overlaps(&jobs(&files[..2], None)), []);
    }
}
