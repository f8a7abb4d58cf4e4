//! Modes while they are followed over the speeds, and their names.

use std::f64::consts::TAU;

use crate::case::ModesSettings;
use crate::modes::ModeMotion;
use crate::result::{ModeBranch, ModeKind, ModePoint};

/// Branches that grow by one speed after the other.
#[derive(Default)]
pub(super) struct Branches {
    all: Vec<ModeBranch>,
    /// Branch of each mode at the last speed.
    current: Vec<usize>,
    speeds: usize,
}

impl Branches {
    /// Adds the modes of one more speed; `links` leads from the modes before, with the
    /// assurance. Their shapes are kept if `with_shapes`.
    pub fn add(
        &mut self,
        modes: &[(&ModePoint, &ModeMotion)],
        links: Option<&[Option<(usize, f64)>]>,
        with_shapes: bool,
    ) {
        let mut branch_of = vec![None; modes.len()];
        for (i, link) in links.unwrap_or(&[]).iter().enumerate() {
            if let Some((j, mac)) = link {
                branch_of[*j] = Some((self.current[i], *mac));
            }
        }
        let added = modes.iter().zip(branch_of).map(|((point, motion), link)| {
            let branch = link.map_or_else(|| self.begin(), |(branch, _)| branch);
            let mut point = (*point).clone();
            point.assurance = link.map(|(_, mac)| mac);
            point.shape = with_shapes.then(|| motion.shape());
            self.all[branch].points.resize(self.speeds, None);
            self.all[branch].points.push(Some(point));
            branch
        });
        self.current = added.collect();
        self.speeds += 1;
    }

    /// A branch without a point and a name.
    fn begin(&mut self) -> usize {
        self.all.push(ModeBranch {
            name: String::new(),
            kind: ModeKind::Coupled,
            harmonic: None,
            points: Vec::new(),
        });
        self.all.len() - 1
    }

    /// The branches that are among the lowest modes requested by `settings` at some of the
    /// `speeds` \[rad/s\], with names; rigid modes of a free model are not counted.
    pub fn into_table(mut self, speeds: &[f64], settings: &ModesSettings) -> Vec<ModeBranch> {
        for branch in &mut self.all {
            branch.points.resize(speeds.len(), None);
        }
        name(&mut self.all, speeds, settings);
        let rank = |branch: &ModeBranch, speed: usize| -> Option<usize> {
            let own = branch.points[speed].as_ref()?.frequency;
            let below = self
                .all
                .iter()
                .filter_map(|other| other.points[speed].as_ref());
            Some(below.filter(|point| point.frequency < own).count())
        };
        let rigid = self.all.iter().filter(|b| b.kind == ModeKind::Rigid);
        let count = settings.count + rigid.count();
        let kept: Vec<_> = self
            .all
            .iter()
            .map(|b| (0..speeds.len()).any(|speed| rank(b, speed).is_some_and(|r| r < count)))
            .collect();
        let mut kept = kept.into_iter();
        self.all.retain(|_| kept.next().unwrap_or(false));
        self.all
    }
}

/// Index of the speed nearest to `wanted` among those that were reached.
fn nearest(speeds: &[f64], wanted: f64) -> usize {
    let distance = |speed: f64| (speed - wanted).abs();
    let numbered = speeds.iter().enumerate();
    numbered
        .min_by(|a, b| distance(*a.1).total_cmp(&distance(*b.1)))
        .map_or(0, |found| found.0)
}

/// Names the branches by their kind at the speed of names, or else at their first speed, by
/// their number among alike ones, and on a rotor by the pattern of the blades: first those with
/// a mode at that speed, by ascending frequency, then the others in their order. Modes of
/// frequency zero of a free model are rigid.
fn name(branches: &mut [ModeBranch], speeds: &[f64], settings: &ModesSettings) {
    let words = settings.style.words;
    let reference = nearest(speeds, settings.style.name_at.unwrap_or(0.0));
    let at = |branch: &ModeBranch| -> Option<(ModePoint, f64)> {
        let is_known = |index: &usize| branch.points[*index].is_some();
        let first = || (0..branch.points.len()).find(is_known);
        let index = Some(reference).filter(is_known).or_else(first)?;
        Some((branch.points[index].clone()?, speeds[index]))
    };
    let height = |branch: &ModeBranch| -> f64 {
        let own = branch.points.get(reference).and_then(Option::as_ref);
        own.map_or(f64::INFINITY, |point| point.frequency)
    };
    let mut order: Vec<_> = (0..branches.len()).collect();
    order.sort_by(|a, b| height(&branches[*a]).total_cmp(&height(&branches[*b])));
    let mut named: Vec<(ModeKind, Option<i32>)> = Vec::with_capacity(order.len());
    for index in order {
        let Some((point, speed)) = at(&branches[index]) else {
            continue;
        };
        let is_rigid = settings.free && point.frequency == 0.0;
        let whirl = point.whirl.filter(|whirl| !is_rigid && whirl.is_pure());
        // Motion of a shaft along and about its axis has no pattern to name.
        let whirl = whirl.filter(|whirl| whirl.blades > 0 || whirl.harmonic != 0);
        let whirl = whirl.map(|whirl| whirl.named(point.frequency, speed / TAU));
        let kind = if is_rigid {
            ModeKind::Rigid
        } else {
            point.kind()
        };
        let key = (kind, whirl.map(|whirl| whirl.harmonic));
        let number = 1 + named.iter().filter(|other| **other == key).count();
        let pattern = whirl.map_or_else(String::new, |w| format!(" {}", w.word_in(words)));
        let kind = kind.word_in(words);
        let branch = &mut branches[index];
        branch.name = format!("{kind} {number}{pattern}");
        (branch.kind, branch.harmonic) = key;
        named.push(key);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{ModeStyle, Words};

    fn point(frequency: f64, shares: [f64; 4]) -> Option<ModePoint> {
        Some(ModePoint {
            frequency,
            damping_ratio: 0.0,
            growth: 0.0,
            shares,
            lateral: 0.0,
            tower: [0.0; 2],
            whirl: None,
            assurance: None,
            shape: None,
        })
    }

    // Two modes that exchange their characters between the speeds, and one that begins late.
    #[test]
    fn names_are_those_of_the_chosen_speed() {
        let [flap, lag] = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]];
        let points = [
            [point(1.0, flap), point(2.0, lag)],
            [point(1.5, lag), point(2.5, flap)],
            [None, point(1.0, flap)],
        ];
        let names = |name_at, words| {
            let mut settings = ModesSettings::new(Vec::new(), 9);
            settings.style = ModeStyle {
                name_at,
                words,
                ..ModeStyle::default()
            };
            let all = points.iter().map(|points| ModeBranch {
                name: String::new(),
                kind: ModeKind::Coupled,
                harmonic: None,
                points: points.to_vec(),
            });
            let branches = Branches {
                all: all.collect(),
                ..Branches::default()
            };
            let named = branches.into_table(&[0.0, 10.0], &settings);
            let last = named.iter().map(|branch| {
                let point = branch.points[1].as_ref().unwrap();
                branch.name_at(point, words)
            });
            last.collect::<Vec<_>>()
        };
        let first = names(None, Words::Rotor);
        assert_eq!(first, ["flap 1 (now lag)", "lag 1 (now flap)", "flap 2"]);
        let last = names(Some(10.0), Words::Wind);
        assert_eq!(last, ["edge 1", "flap 2", "flap 1"]);
    }
}
