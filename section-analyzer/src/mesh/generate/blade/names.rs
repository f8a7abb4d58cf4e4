//! Names of the physical groups of the plies of a blade.

use super::super::layup::cells::Names;
use super::super::layup::wall::Wall;
use super::contour::SIDES;
use super::problem::BladePart;
use super::shell::{Of, WebAt};
use super::{Blade, Ply, SparPly};

/// A place in a wall or a web.
#[derive(Debug, Clone, Copy)]
enum Place {
    /// A side, and the fraction of the chord.
    Side(usize, f64),
    /// The base at the trailing edge.
    Base,
    /// A web.
    Web(BladePart),
}

/// The plies of the layers of a meshed blade.
pub(super) struct Named<'a> {
    pub blade: &'a Blade,
    pub wall: &'a Wall,
    pub plies: &'a [Of],
    pub webs: &'a [WebAt],
}

/// Cells of one ply along a column: the ply, and the levels of its faces.
struct Faces<'a> {
    ply: &'a Ply,
    levels: [usize; 2],
    is_there: bool,
}

impl Named<'_> {
    /// Calls a function with the names.
    pub fn with<T>(&self, run: impl FnOnce(&Names<'_>) -> T) -> T {
        run(&Names {
            cells: &|layer, s| self.cells(layer, self.place(s)),
            lines: &|level, s| self.lines(level, s),
            web_cells: &|web, layer| self.cells(layer, Place::Web(self.webs[web].web)),
            web_lines: &|web, level| self.web_lines(web, level),
        })
    }

    fn place(&self, s: f64) -> Place {
        let outline = &self.wall.outline;
        let half = 0.5 * outline.base();
        if s < half || s > outline.perimeter() - half {
            return Place::Base;
        }
        Place::Side(
            usize::from(s > outline.nose()),
            self.blade.contour.part_at(s),
        )
    }

    /// The ply of the spar of a layer.
    fn of_spar(&self, layer: usize) -> Option<&SparPly> {
        match (self.plies[layer], &self.blade.spar) {
            (Of::Spar(number), Some(spar)) => spar.plies.get(number),
            _ => None,
        }
    }

    /// The surfaces of a cell of a layer.
    fn cells(&self, layer: usize, place: Place) -> Vec<String> {
        let of_spar = self.of_spar(layer);
        let filler = of_spar.filter(|ply| !ply.is_at(place));
        let filler = filler.and_then(|ply| ply.filler.clone());
        let name = filler.unwrap_or_else(|| self.wall.stack.name(layer).to_owned());
        let part = match place {
            Place::Side(side, _) => SIDES[side],
            Place::Base => "edge",
            Place::Web(BladePart::FrontWeb) => "front_web",
            Place::Web(_) if self.webs.len() > 1 => "rear_web",
            Place::Web(_) => "web",
        };
        let of_part = format!("{name}/{part}");
        vec![name, of_part]
    }

    /// The ply of a layer, of which all or nothing is at a place, and its levels.
    fn faces(&self, layer: usize, place: Place) -> Option<Faces<'_>> {
        let (ply, is_there) = match (self.plies[layer], self.of_spar(layer)) {
            (Of::Skin(number), _) => (self.blade.skin.get(number)?, true),
            (Of::Spar(_), of_spar) => of_spar.map(|one| (&one.ply, one.is_at(place)))?,
        };
        let outer = self.wall.stack.level(layer);
        Some(Faces {
            ply,
            levels: [outer, outer + self.wall.stack.cells(layer)],
            is_there,
        })
    }

    /// The curves of a level.
    fn lines(&self, level: usize, s: f64) -> Vec<String> {
        let (stack, place) = (&self.wall.stack, self.place(s));
        let mut names = Vec::new();
        if level == 0 {
            names.push("contour".to_owned());
        }
        let spar = self.wall.spar.as_ref();
        let is_outer = |first: usize| level == stack.level(first) && !stack.is_beyond(s);
        if spar.is_some_and(|spar| is_outer(spar.first)) {
            names.push("spar".to_owned());
        }
        let present = (0..stack.len()).filter(|layer| stack.thickness(*layer, s) > 0.0);
        let faces = present.filter_map(|layer| self.faces(layer, place));
        add_faces(faces, level, &mut names);
        names
    }

    /// The curves of a level of a web.
    fn web_lines(&self, web: usize, level: usize) -> Vec<String> {
        let mut names = Vec::new();
        if level == 0 {
            names.push("spar".to_owned());
        }
        let place = Place::Web(self.webs[web].web);
        let layers = self
            .wall
            .spar
            .iter()
            .flat_map(|spar| &spar.webs[web].layers);
        let mut outer = 0;
        let faces = layers.filter_map(|layer| {
            let cells = self.wall.stack.cells(*layer);
            outer += cells;
            let levels = [outer - cells, outer];
            Some(Faces {
                levels,
                ..self.faces(*layer, place)?
            })
        });
        add_faces(faces, level, &mut names);
        names
    }
}

/// Adds the faces of plies that lie on a level.
fn add_faces<'a>(faces: impl Iterator<Item = Faces<'a>>, level: usize, names: &mut Vec<String>) {
    for one in faces.filter(|one| one.ply.has_faces && one.is_there) {
        for (at, word) in one.levels.into_iter().zip(["outer", "inner"]) {
            if at == level {
                names.push(format!("{}/{word}", one.ply.name));
            }
        }
    }
}

impl SparPly {
    /// Whether the ply itself is at a place of the spar.
    fn is_at(&self, place: Place) -> bool {
        match place {
            Place::Side(side, part) => {
                let range = [self.upper, self.lower][side];
                range.is_some_and(|[from, to]| from < part && part < to)
            }
            Place::Web(BladePart::FrontWeb) => self.webs[0],
            Place::Web(_) | Place::Base => self.webs[1],
        }
    }
}
