//! The wall of a section: its layers, mitres and contacts.

use super::super::super::distance;
use super::super::bisect::bisect;
use super::front::Front;
use super::mitre::{MOST_OF_WAY, Mitre, mitres};
use super::outline::Outline;
use super::pairs::{FOREMOST, JOINED, Pair, Pairs};
use super::problem::{LayupProblem, Upright};
use super::remedies::Remedies;
use super::spar::SparWall;
use super::stack::Stack;
use super::types::{Layer, LayupSection, SIDES, Spar, Web};

/// Reach of a contact, in sizes of cells and in thicknesses.
const REACH: [f64; 2] = [2.5, 1.5];

/// Least part of the base between the layers of both sides at a web.
const LEAST_GAP: f64 = 0.05;
/// Gap before a contact from which layers are stretched ahead of it, in sizes of cells.
const STRETCHED: f64 = 1e-3;
/// Least height of an edge, of the length of the contour.
const LEAST_HEIGHT: f64 = 5e-4;
/// The foremost place at which an edge is cut off, of the chord.
const FOREMOST_CUT: f64 = 0.5;

/// Shape of the wall at its rear end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Edge {
    /// No corner.
    Smooth,
    /// The base is a wall of the same layers.
    Wall,
    /// Both sides end, and meet.
    Face,
    /// Both sides end on a web.
    Butt,
    /// Both sides end, apart from each other.
    Open,
}

impl Edge {
    /// Whether the layers run through the trailing edge.
    pub fn is_ring(self) -> bool {
        matches!(self, Self::Smooth | Self::Wall)
    }
}

/// Layers and spar of a section.
fn of(section: &LayupSection) -> (&[Layer], Option<&Spar>) {
    (&section.layers, section.spar.as_ref())
}

/// A contour, and the circles ahead if layers meet there.
type Shape<'a> = (&'a Outline, Option<&'a Front>);

/// The wall of a section.
#[derive(Debug, Clone)]
pub(in super::super) struct Wall {
    pub outline: Outline,
    pub stack: Stack,
    pub pairs: Pairs,
    pub edge: Edge,
    /// Ends of both sides.
    pub ends: [f64; 2],
    /// Intervals of x in which the layers meet.
    pub contacts: Vec<[f64; 2]>,
    /// Shifts of the pairs at their ends.
    pub shifts: Vec<[f64; 2]>,
    /// Intervals of x with stations in pairs.
    pub zones: Vec<[f64; 2]>,
    /// Parts of the length of cells along the contour that they have in the zones.
    fineness: Vec<f64>,
    /// Intervals of the arc length with shorter cells.
    fine: Vec<[f64; 2]>,
    /// Length of cells along the contour.
    pub size: f64,
    /// Mitres at its corners.
    pub mitres: Vec<Mitre>,
    /// Its spar that turns into a web.
    pub spar: Option<SparWall>,
    /// The circles ahead, if layers meet there.
    front: Option<Front>,
    /// Whether something of each layer is left in the fan ahead, if it is full.
    pub in_fan: Vec<bool>,
    /// The layer that is cut ahead, as a problem if that cannot be meshed.
    pub tight: Option<LayupProblem>,
}

impl Wall {
    /// The wall of a section.
    pub fn new(
        section: &LayupSection,
        outline: &Outline,
        size: f64,
        remedies: &Remedies,
    ) -> Result<Self, LayupProblem> {
        let made = |shape: Shape<'_>| match section.at_edge().next() {
            Some(web) => Self::ended((section, web), shape, size, remedies),
            None => Self::closed(section, shape, size, remedies),
        };
        let wall = made((outline, None))?;
        wall.check_spar()?;
        wall.check_closed()?;
        let Some(tight) = wall.tight_space() else {
            return Ok(wall);
        };
        let can_meet = wall.edge != Edge::Smooth && wall.spar.is_none();
        let front = can_meet.then(|| Front::new(outline)).flatten();
        let Some(front) = front else {
            return Err(tight);
        };
        let outline = outline.with_nose(front.nose);
        let wall = made((&outline, Some(&front)));
        wall.map(|wall| Self {
            tight: Some(tight),
            ..wall
        })
    }

    /// The wall that a web at the trailing edge closes.
    fn ended(
        (section, web): (&LayupSection, &Web),
        shape: Shape<'_>,
        size: f64,
        remedies: &Remedies,
    ) -> Result<Self, LayupProblem> {
        let mut wall = Self {
            edge: Edge::Butt,
            ..Self::of_kind(of(section), shape, size, false)?
        };
        let outline = shape.0;
        if wall.ends.iter().any(|s| wall.stack.total(*s) <= 0.0) {
            return Err(LayupProblem::Open);
        }
        let (web, base) = (web.name.clone(), outline.base());
        let pair = wall.pairs.pair(1.0);
        let taken = pair.need(0, &wall.stack) + pair.need(1, &wall.stack);
        if base - taken < LEAST_GAP * base || base <= 0.0 {
            return Err(LayupProblem::NoRoomAtEdge { web, base, taken });
        }
        wall.find_contacts(remedies);
        let at_end = wall.contacts.last().filter(|one| one[1] >= 1.0);
        if let Some([from, to]) = at_end.filter(|one| one[0] < 1.0) {
            let arc = |x: &f64| wall.pairs.at(0, *x) / outline.perimeter();
            let contact = [arc(to), arc(from)];
            return Err(LayupProblem::ContactAtEdge { web, contact });
        }
        Ok(wall)
    }

    /// The wall whose layers close the trailing edge.
    fn closed(
        section: &LayupSection,
        shape: Shape<'_>,
        size: f64,
        remedies: &Remedies,
    ) -> Result<Self, LayupProblem> {
        let ring = Self::of_kind(of(section), shape, size, true)?;
        let mut wall = match shape.0.is_smooth() {
            true => Self {
                edge: Edge::Smooth,
                ..ring
            },
            false if ring.has_wall() => ring,
            false => Self::of_kind(of(section), shape, size, false)?,
        };
        if wall.edge == Edge::Wall {
            wall.find_contacts(&Remedies::default());
            let fade = wall.rear().map(Mitre::reach).fold(0.0, f64::max);
            let meets = |zone: &[f64; 2]| zone[1] >= 1.0 - fade / wall.chord();
            if wall.zones.iter().any(meets) {
                wall = Self::of_kind(of(section), shape, size, false)?;
            } else {
                wall.find_contacts(remedies);
            }
        }
        if wall.edge == Edge::Face {
            wall.cut_thin_edge()?;
            wall.find_contacts(remedies);
        }
        wall.fine = remedies.fine.clone();
        Ok(wall)
    }

    /// The wall of layers and a spar whose sides do not meet: its trailing edge is mitred if
    /// `is_ring`, without a base too, else both sides end.
    pub fn apart(
        layers: (&[Layer], Option<&Spar>),
        outline: &Outline,
        size: f64,
        is_ring: bool,
    ) -> Result<Self, LayupProblem> {
        let edge = match (is_ring, outline.is_smooth()) {
            (true, true) => Edge::Smooth,
            (true, false) => Edge::Wall,
            (false, _) => Edge::Open,
        };
        Ok(Self {
            edge,
            ..Self::of_kind(layers, (outline, None), size, is_ring)?
        })
    }

    fn of_kind(
        layers: (&[Layer], Option<&Spar>),
        (outline, front): Shape<'_>,
        size: f64,
        is_ring: bool,
    ) -> Result<Self, LayupProblem> {
        let ends = outline.corners();
        let seam = if outline.is_smooth() {
            f64::INFINITY
        } else {
            0.8 * outline.base()
        };
        let kind = (is_ring, ends, seam);
        let mut stack = Stack::new(layers, outline.perimeter(), size, kind);
        let spar = layers
            .1
            .map(|spar| SparWall::new(spar, outline, &mut stack));
        let spar = spar.transpose()?;
        let webs = spar.iter().flat_map(|spar| &spar.webs);
        let stops: Vec<f64> = webs.flat_map(|web| web.corners).collect();
        let has_rear = is_ring && !outline.is_smooth();
        Ok(Self {
            mitres: mitres(outline, &stack, has_rear, &stops),
            spar,
            stack,
            pairs: Pairs::new(outline, front, ends),
            outline: outline.clone(),
            edge: if is_ring { Edge::Wall } else { Edge::Face },
            ends,
            contacts: Vec::new(),
            shifts: Vec::new(),
            zones: Vec::new(),
            fineness: Vec::new(),
            fine: Vec::new(),
            size,
            front: front.cloned(),
            in_fan: Vec::new(),
            tight: None,
        })
    }

    /// Refuses a spar whose corners are where columns lean toward a contact.
    fn check_spar(&self) -> Result<(), LayupProblem> {
        let Some(spar) = &self.spar else {
            return Ok(());
        };
        let sides = spar.webs.iter().flat_map(|web| [(web, 0), (web, 1)]);
        for (web, side) in sides {
            let s = web.corners[side];
            let x = match self.edge {
                Edge::Smooth => 0.0,
                _ => self.pairs.x(side, s),
            };
            let zone = self.zones.iter().find(|zone| x >= zone[0] && x <= zone[1]);
            if let Some(zone) = zone {
                let perimeter = self.outline.perimeter();
                let mut contact = zone.map(|x| self.pairs.at(side, x) / perimeter);
                contact.sort_by(f64::total_cmp);
                return Err(LayupProblem::WebInContact {
                    web: Upright::Web(web.name.clone()),
                    side: SIDES[side],
                    arc: web.arcs[side],
                    contact,
                    thickest: self.stack.thickest(s),
                });
            }
        }
        Ok(())
    }

    /// Part of the length of cells along the contour that they have in a zone.
    pub fn fineness(&self, zone: [f64; 2]) -> f64 {
        let known = self.zones.iter().position(|one| *one == zone);
        known.map_or(1.0, |number| self.fineness[number])
    }

    /// Whether cells at an arc length are shorter.
    pub fn is_fine(&self, s: f64) -> bool {
        self.fine.iter().any(|[from, to]| s > *from && s < *to)
    }

    fn chord(&self) -> f64 {
        distance(
            self.outline.position(self.outline.nose()),
            self.outline.middle(),
        )
    }

    /// The mitres at the base.
    fn rear(&self) -> impl Iterator<Item = &Mitre> {
        self.mitres.iter().filter(|one| one.is_rear)
    }

    /// Whether the base is long enough for a wall.
    fn has_wall(&self) -> bool {
        let lengths = || self.rear().map(|one| one.length);
        let both: f64 = lengths().sum();
        let taken = if self.outline.is_round_behind() {
            both
        } else {
            2.0 * lengths().fold(0.0, f64::max)
        };
        MOST_OF_WAY * self.outline.base() > taken && both > 0.0
    }

    /// Cuts off an edge that is too thin for the first layer of both sides.
    fn cut_thin_edge(&mut self) -> Result<(), LayupProblem> {
        let needs = |pair: &Pair| {
            [0, 1].map(|side| {
                let first = self.stack.outermost(pair.s[side]);
                let thickness =
                    first.map_or(0.0, |layer| self.stack.thickness(layer, pair.s[side]));
                thickness / pair.cosines[side]
            })
        };
        let excess = |x: f64| {
            let pair = self.pairs.pair(x);
            let least = needs(&pair).iter().sum::<f64>();
            pair.length - least.max(LEAST_HEIGHT * self.outline.perimeter())
        };
        if self.ends.iter().any(|s| self.stack.total(*s) <= 0.0) {
            return Err(LayupProblem::Open);
        }
        if excess(1.0) >= 0.0 {
            return Ok(());
        }
        let at = |i: usize| 1.0 - (1.0 - FOREMOST_CUT) * i as f64 / 400.0;
        let Some(i) = (1..=400).find(|i| excess(at(*i)) >= 0.0) else {
            return Err(self.thin_everywhere(needs(&self.pairs.pair(FOREMOST_CUT))));
        };
        let cut = bisect([at(i), at(i - 1)], true, |x| excess(x) >= 0.0);
        self.ends = [0, 1].map(|side| self.pairs.at(side, cut));
        self.pairs = Pairs::new(&self.outline, self.front.as_ref(), self.ends);
        Ok(())
    }

    /// The problem of a section that is too thin at the foremost cut, where the first layers need
    /// these lengths.
    fn thin_everywhere(&self, needs: [f64; 2]) -> LayupProblem {
        let pair = self.pairs.pair(FOREMOST_CUT);
        let side = usize::from(needs[1] > needs[0]);
        match self.stack.outermost(pair.s[side]) {
            Some(layer) if needs[0] + needs[1] > pair.length => LayupProblem::Tight {
                layer: self.stack.name(layer).into(),
                arc: pair.s[side] / self.outline.perimeter(),
                thickness: needs[side],
                radius: pair.length * needs[side] / (needs[0] + needs[1]),
                thickest: self.stack.thickest(pair.s[side]),
            },
            _ => LayupProblem::Contour {
                why: "is thinner than 5e-4 of its length in all of its rear half".into(),
            },
        }
    }

    /// Intervals of x in which the layers meet, searched closely or not.
    fn found_contacts(&self, closely: bool) -> Vec<[f64; 2]> {
        // also the columns at a web lean onto the base
        let is_face = !self.edge.is_ring();
        let points = self.samples();
        let is_thick = |s: f64| self.stack.total(s) > self.radius(s, &points);
        let can_meet = |pair: &Pair| is_face || pair.s.into_iter().any(is_thick);
        let how = [is_face, closely];
        self.pairs.contacts(&self.stack, self.size, how, &can_meet)
    }

    /// Whether a closer search finds other contacts.
    pub fn has_other_contacts(&self) -> bool {
        self.edge != Edge::Smooth && self.found_contacts(true) != self.found_contacts(false)
    }

    /// Finds where the layers meet, and the zones around.
    fn find_contacts(&mut self, remedies: &Remedies) {
        self.contacts = self.found_contacts(remedies.is_close);
        if self.edge == Edge::Face {
            self.close_edge();
        }
        self.in_fan = self.found_in_fan();
        let chord = self.chord();
        let mut zones: Vec<[f64; 2]> = Vec::new();
        let mut fineness: Vec<f64> = Vec::new();
        let shift = |x: f64| self.pairs.pair(x).shift(&self.stack);
        self.shifts = self.contacts.iter().map(|ends| ends.map(shift)).collect();
        for (number, [from, to]) in self.contacts.iter().copied().enumerate() {
            let (factor, part) = remedies.of(number);
            let reach = |x: f64| self.reach_at(x) * factor / chord;
            // a zone begins at the nose or behind the fan
            let fan = self.pairs.fan().filter(|_| from > 0.0);
            let first = fan.unwrap_or(self.pairs.foremost());
            let zone = [(from - reach(from)).max(first), (to + reach(to)).min(1.0)];
            match zones.last_mut().filter(|last| last[1] >= zone[0]) {
                Some(last) => {
                    last[1] = zone[1];
                    fineness[zones.len() - 1] = part.min(fineness[zones.len() - 1]);
                }
                None => {
                    zones.push(zone);
                    fineness.push(part);
                }
            }
        }
        (self.zones, self.fineness) = (zones, fineness);
    }

    /// Lets the sides meet over the thickness of the layers ahead of the edge, as the wall across the
    /// base would be thick: they do not meet in one node.
    fn close_edge(&mut self) {
        let thick = self.ends.map(|s| self.stack.total(s));
        let from = 1.0 - thick[0].max(thick[1]) / self.pairs.scale();
        let from = from.max(FOREMOST);
        let mut last = [from, 1.0];
        let gap = JOINED * self.size / self.pairs.scale();
        while let Some(one) = self.contacts.pop_if(|one| one[1] >= last[0] - gap) {
            last[0] = last[0].min(one[0]);
        }
        self.contacts.push(last);
    }

    /// The x from which the innermost layers are stretched to a contact that begins with a gap; `None` without
    /// one. Layers are stretched over the length of the gap.
    pub fn stretched_from(&self, contact: f64) -> Option<f64> {
        let gap = self.pairs.pair(contact).gap(&self.stack);
        let before = contact - gap / self.pairs.scale();
        let is_in =
            |zone: &&[f64; 2]| contact >= zone[0] && contact <= zone[1] && before >= zone[0];
        let is_stretched = gap > STRETCHED * self.size && self.zones.iter().find(is_in).is_some();
        is_stretched.then_some(before)
    }

    fn reach_at(&self, x: f64) -> f64 {
        let pair = self.pairs.pair(x);
        let thick = pair.s.map(|s| self.stack.total(s));
        (REACH[0] * self.size).max(REACH[1] * thick[0].max(thick[1]))
    }
}
