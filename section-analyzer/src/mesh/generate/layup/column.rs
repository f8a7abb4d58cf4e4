//! The columns of cells through the layers of a wall.
//!
//! The direction of a column is the normal, except where the layers of both sides meet:
//!
//! ```text
//! v = u / (u . n)                            on the line u of a pair in a contact,
//! v = (1 - w) n + w u / (u . n)              before and behind the contact,
//! ```
//!
//! all with v . n = 1; ahead, u goes to the center of the circle of the pair. At a web at the trailing edge, u is the base. Beside corners columns lean along
//! the surface.

use super::bend::{Bend, Lean};
use super::pairs::Pair;
use super::wall::{Edge, Wall};

/// Part of the thickness of a layer below which nothing of it is left where it is cut.
pub(super) const THIN: f64 = 0.03;

/// The lean of a column toward the other side.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Toward {
    /// Part of the direction of the pair in its direction: 1 in a contact.
    pub weight: f64,
    /// The shift of the pair at the end of the contact, beside it.
    pub shift: Option<f64>,
}

impl Toward {
    /// No lean.
    pub const NONE: Self = Self {
        weight: 0.0,
        shift: None,
    };
}

/// A column of cells.
#[derive(Debug, Clone, PartialEq)]
pub(in super::super) struct Column {
    /// Its point on the contour.
    pub point: [f64; 2],
    /// Its direction, of unit component along the normal.
    pub direction: [f64; 2],
    /// Depths of the faces of layers and of the cells in them, from 0.
    pub depths: Vec<f64>,
    /// Its lean beside a corner.
    pub bend: Option<Bend>,
    /// Whether it ends at a contact.
    pub is_closed: bool,
}

impl Wall {
    /// The column at an arc length.
    pub fn column(&self, s: f64) -> Column {
        let s = if self.edge.is_ring() {
            s.rem_euclid(self.outline.perimeter())
        } else {
            s
        };
        let point = self.outline.position(s);
        let side = usize::from(s > self.outline.nose());
        let x = match self.edge {
            Edge::Smooth | Edge::Open => 0.0,
            _ => self.pairs.x(side, s).min(1.0),
        };
        let Some(lean) = self.toward(s, x) else {
            let fan = self.pairs.to_center(side, s);
            return Column {
                point,
                direction: fan.unwrap_or_else(|| self.outline.inward(s)),
                depths: self.depths(self.stack.depths(s)),
                bend: self.bend(s),
                is_closed: false,
            };
        };
        let partner = self.pairs.at(1 - side, x);
        let pair = self.pairs.between(if side == 0 {
            [s, partner]
        } else {
            [partner, s]
        });
        self.leaned(&pair, side, lean)
    }

    /// The lean of the column at an arc length along the contour, M; 0 beside a corner of a spar.
    pub fn lean(&self, s: f64) -> f64 {
        let column = self.column(s);
        match &column.bend {
            Some(bend) => match bend.lean {
                Lean::Along(lean) => lean,
                Lean::Part(..) => 0.0,
            },
            None => {
                let n = self.outline.inward(s);
                n[0] * column.direction[1] - n[1] * column.direction[0]
            }
        }
    }

    /// The depth at which layers are cut, where the layers of both sides meet; `None`
    /// elsewhere.
    pub fn cut_at(&self, s: f64) -> Option<f64> {
        if self.contacts.is_empty() {
            return None;
        }
        let column = self.column(s);
        let depth = column.depths.last().copied();
        depth.filter(|_| column.is_closed)
    }

    /// The column of a side of a pair.
    pub fn leaned(&self, pair: &Pair, side: usize, Toward { weight, shift }: Toward) -> Column {
        let s = pair.s[side];
        let n = self.outline.inward(s);
        let lean = pair.direction(side, &self.stack, shift);
        let direction = [0, 1].map(|i| (1.0 - weight) * n[i] + weight * lean[i]);
        let is_closed = weight >= 1.0 && !self.is_on_base(s);
        let mut faces = self.stack.depths(s);
        if is_closed {
            let limit = pair.limit(side, &self.stack);
            match pair.is_fan() {
                true => self.cut_in_fan(&mut faces, limit),
                false => self.cut(&mut faces, limit),
            }
        }
        Column {
            point: self.outline.position(s),
            direction,
            depths: self.depths(faces),
            bend: None,
            is_closed,
        }
    }

    /// Whether a column is at a web at the trailing edge, where it does not meet a column of the other
    /// side.
    fn is_on_base(&self, s: f64) -> bool {
        let near = 1e-9 * self.outline.perimeter();
        let mut ends = self.ends.into_iter();
        self.edge == Edge::Butt && ends.any(|end| (end - s).abs() < near)
    }

    /// The lean of the column at an arc length beside a corner.
    fn bend(&self, s: f64) -> Option<Bend> {
        let of_spar = self.spar.as_ref();
        let of_spar = of_spar.and_then(|spar| spar.bend(&self.outline, &self.stack, s));
        of_spar.or_else(|| {
            let lean = self.mitres.iter().find_map(|one| one.part(s))?;
            let normal = self.outline.inward(s);
            Some(Bend {
                depth: 0.0,
                normal,
                direction: [-normal[1], normal[0]],
                bend: self.outline.bend(s),
                lean: Lean::Along(lean),
            })
        })
    }

    /// The lean of a column at an arc length, whose pair is at x; `None` far from contacts.
    fn toward(&self, s: f64, x: f64) -> Option<Toward> {
        if self.zones.is_empty() || self.outline.is_smooth() {
            return None;
        }
        let corners = self.outline.corners();
        if self.edge == Edge::Wall && (s < corners[0] || s > corners[1]) {
            return None;
        }
        self.toward_at(x)
    }

    /// The same for a pair at x.
    pub fn toward_at(&self, x: f64) -> Option<Toward> {
        const SAME: f64 = 1e-9;
        let zone = self
            .zones
            .iter()
            .find(|zone| x >= zone[0] && x <= zone[1] + SAME)?;
        let mut most = (0.0_f64, None);
        let both = self.contacts.iter().zip(&self.shifts);
        for (contact, shifts) in both.filter(|(one, _)| one[0] >= zone[0] && one[1] <= zone[1]) {
            let (part, shift) = if x < contact[0] - SAME {
                let from = zone[0];
                ((x - from) / (contact[0] - from), Some(shifts[0]))
            } else if x > contact[1] + SAME {
                ((zone[1] - x) / (zone[1] - contact[1]), Some(shifts[1]))
            } else {
                (1.0, None)
            };
            if part >= most.0 {
                most = (part.min(1.0), shift);
            }
        }
        let (part, shift) = most;
        let weight = match part >= 1.0 {
            true => 1.0,
            false => part * part * (3.0 - 2.0 * part),
        };
        Some(Toward { weight, shift })
    }

    /// Depths of the cells in layers with these inner faces, and of the faces.
    fn depths(&self, faces: Vec<f64>) -> Vec<f64> {
        let mut depths = vec![0.0];
        let mut outer = 0.0;
        for (layer, inner) in faces.into_iter().enumerate() {
            let cells = self.stack.cells(layer);
            let part = |i: usize| outer + (inner - outer) * i as f64 / cells as f64;
            depths.extend((1..cells).map(part));
            depths.push(inner);
            outer = inner;
        }
        depths
    }

    /// Cuts layers at a depth, and stretches the innermost one to it.
    fn cut(&self, faces: &mut [f64], limit: f64) {
        let count = faces.len();
        for face in faces.iter_mut() {
            *face = face.min(limit);
        }
        for layer in (0..count).rev() {
            let outer = if layer == 0 { 0.0 } else { faces[layer - 1] };
            let rest = faces[layer] - outer;
            if layer > 0
                && faces[layer] >= limit
                && rest > 0.0
                && rest < THIN * self.stack.full(layer)
            {
                faces[layer - 1] = limit;
            }
        }
        let outer = |layer: usize, faces: &[f64]| if layer == 0 { 0.0 } else { faces[layer - 1] };
        let last = (0..count)
            .rev()
            .find(|layer| faces[*layer] > outer(*layer, faces));
        for face in &mut faces[last.unwrap_or(0)..] {
            *face = limit;
        }
    }
}

impl Column {
    /// The point at a depth.
    pub fn at(&self, depth: f64) -> [f64; 2] {
        let bend = self.bend.as_ref().filter(|bend| depth > bend.depth);
        let along = bend.map_or(0.0, |bend| bend.along(depth - bend.depth));
        self.beside(depth, along)
    }

    /// The point at a depth with a distance along the surface.
    pub fn beside(&self, depth: f64, along: f64) -> [f64; 2] {
        let bend = self.bend.as_ref().filter(|bend| depth > bend.depth);
        let outer = bend.map_or(depth, |bend| bend.depth);
        let beyond = bend.map_or([0.0; 2], |bend| bend.beyond(depth - bend.depth, along));
        [0, 1].map(|i| self.point[i] + outer * self.direction[i] + beyond[i])
    }

    /// Its inner end.
    pub fn inner(&self) -> [f64; 2] {
        self.at(self.depths.last().copied().unwrap_or(0.0))
    }
}
