//! Names of the physical groups of the plies of a blade.

use super::super::layup::cells::Names;
use super::super::layup::wall::Wall;
use super::SparPly;
use super::contour::{Contour, SIDES};
use super::problem::BladePart;
use super::shell::{Of, WebAt};

/// A part of the walls.
#[derive(Debug, Clone, Copy)]
enum WallPart {
    /// A side, and the fraction of the chord.
    Side(usize, f64),
    /// The base at the trailing edge.
    Base,
    /// A web.
    Web(BladePart),
}

/// The plies of the layers of a meshed blade.
pub(super) struct Named<'a> {
    pub contour: &'a Contour,
    pub wall: &'a Wall,
    pub plies: &'a [Of<'a>],
    pub webs: &'a [WebAt],
}

impl Named<'_> {
    /// Calls a function with the names.
    pub fn with<T>(&self, run: impl FnOnce(&Names<'_>) -> T) -> T {
        run(&Names {
            cells: &|layer, s| self.cells(layer, self.place(s)),
            lines: &|level, s| self.lines(level, s),
            web_cells: &|web, layer| self.cells(layer, WallPart::Web(self.webs[web].web)),
            web_lines: &|web, level| self.web_lines(web, level),
        })
    }

    fn place(&self, s: f64) -> WallPart {
        let outline = &self.wall.outline;
        let half = 0.5 * outline.base();
        if s < half || s > outline.perimeter() - half {
            return WallPart::Base;
        }
        WallPart::Side(usize::from(s > outline.nose()), self.contour.part_at(s))
    }

    /// The surfaces of a cell of a layer.
    fn cells(&self, layer: usize, place: WallPart) -> Vec<String> {
        let Of { ply, on_spar } = self.plies[layer];
        let replaced = on_spar.filter(|on_spar| !on_spar.is_at(place));
        let filler = replaced.and_then(|on_spar| on_spar.filler.as_ref());
        let name = filler.unwrap_or(&ply.name);
        let part = match place {
            WallPart::Side(side, _) => SIDES[side],
            WallPart::Base => "edge",
            WallPart::Web(BladePart::FrontWeb) => "front_web",
            WallPart::Web(_) if self.webs.len() > 1 => "rear_web",
            WallPart::Web(_) => "web",
        };
        vec![name.clone(), format!("{name}/{part}")]
    }

    /// The curves of a level.
    fn lines(&self, level: usize, s: f64) -> Vec<String> {
        let stack = &self.wall.stack;
        let spar = self.wall.spar.as_ref();
        let is_outer = |first: usize| level == stack.level(first) && !stack.is_beyond(s);
        let is_spar = spar.is_some_and(|spar| is_outer(spar.first));
        let whole = [(level == 0, "contour"), (is_spar, "spar")];
        let whole = whole.into_iter().filter(|(is_it, _)| *is_it);
        let mut names: Vec<String> = whole.map(|(_, name)| name.to_owned()).collect();
        let layers = (0..stack.len()).filter(|layer| stack.thickness(*layer, s) > 0.0);
        let layers = layers.map(|layer| (layer, stack.level(layer)));
        self.add_faces(layers, (level, self.place(s)), &mut names);
        names
    }

    /// The curves of a level of a web.
    fn web_lines(&self, web: usize, level: usize) -> Vec<String> {
        let mut names = Vec::new();
        names.extend((level == 0).then(|| "spar".to_owned()));
        let layers = self
            .wall
            .spar
            .iter()
            .flat_map(|spar| &spar.webs[web].layers);
        let mut inner = 0;
        let layers = layers.map(|layer| {
            let outer = inner;
            inner += self.wall.stack.cells(*layer);
            (*layer, outer)
        });
        let place = WallPart::Web(self.webs[web].web);
        self.add_faces(layers, (level, place), &mut names);
        names
    }

    /// Adds the faces on a level of the plies of layers, with their outer levels.
    fn add_faces(
        &self,
        layers: impl Iterator<Item = (usize, usize)>,
        (level, place): (usize, WallPart),
        names: &mut Vec<String>,
    ) {
        for (layer, outer) in layers {
            let Of { ply, on_spar } = self.plies[layer];
            let is_there = on_spar.is_none_or(|on_spar| on_spar.is_at(place));
            let faces = [(outer, "outer"), (outer + ply.cells.max(1), "inner")];
            let on_level = |(at, _): &(usize, &str)| ply.has_faces && is_there && *at == level;
            let faces = faces.into_iter().filter(on_level);
            names.extend(faces.map(|(_, word)| format!("{}/{word}", ply.name)));
        }
    }
}

impl SparPly {
    /// Whether the ply itself is at a place of the spar.
    fn is_at(&self, place: WallPart) -> bool {
        match place {
            WallPart::Side(side, part) => {
                let range = [self.upper, self.lower][side];
                range.is_some_and(|[from, to]| from < part && part < to)
            }
            WallPart::Web(BladePart::FrontWeb) => self.webs[0],
            WallPart::Web(_) | WallPart::Base => self.webs[1],
        }
    }
}
