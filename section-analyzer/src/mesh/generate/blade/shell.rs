//! The plies of a blade as the layers of a layup: a skin, and a spar whose plies turn into its webs.
//!
//! A ply of the spar is one layer if it goes around the nose, else one on each side that has it. Where
//! it ends, its thickness drops to zero between the last two columns.

use super::super::bisect::zero;
use super::super::layup::line::Line;
use super::super::layup::{Layer, Outline, Spar as Turning, SparWeb};
use super::columns::Columns;
use super::contour::SIDES;
use super::problem::{BladePart, BladeProblem};
use super::{Blade, Ply, Spar, SparPly};

/// Fraction of the surface of a spar that a web may use at its end.
const MOST: f64 = 0.45;

/// Intersection of a web with the surfaces.
#[derive(Debug, Clone)]
pub(super) struct WebAt {
    pub web: BladePart,
    /// Its outer face.
    pub line: Line,
    /// Arc lengths of its ends on the contour.
    pub ends: [f64; 2],
    /// The column at its ends.
    pub column: usize,
}

/// The ply of a layer.
#[derive(Debug, Clone, Copy)]
pub(super) struct Of<'a> {
    pub ply: &'a Ply,
    /// The ply of the spar that it is.
    pub on_spar: Option<&'a SparPly>,
}

/// The layers of a blade.
#[derive(Debug)]
pub(super) struct Shell<'a> {
    /// From the outside in.
    pub layers: Vec<Layer>,
    /// The ply of each layer.
    pub plies: Vec<Of<'a>>,
    /// The spar, if there is one.
    pub spar: Option<Turning>,
}

/// A ply of the spar on the surfaces.
struct Laid {
    /// First and last column on each side, from the aft web forward.
    ranges: [Option<[usize; 2]>; 2],
    /// Whether it goes around the nose.
    is_around: bool,
    /// Its layer on each side.
    layers: [Option<usize>; 2],
    /// Any of its layers.
    layer: usize,
}

/// A blade, its columns and its webs.
pub(super) struct Frame<'a, 'b> {
    pub blade: &'a Blade,
    pub columns: &'b Columns,
    /// The rear one first.
    pub webs: &'b [WebAt],
}

impl<'a> Frame<'a, '_> {
    fn outline(&self) -> &'a Outline {
        self.blade.contour.outline()
    }

    /// The layers of all plies, and the spar.
    pub fn shell(&self) -> Shell<'a> {
        let skin = self.blade.skin.iter();
        let plies = skin.clone().map(|ply| Of { ply, on_spar: None });
        let mut shell = Shell {
            layers: skin.map(layer).collect(),
            plies: plies.collect(),
            spar: None,
        };
        if let Some(spar) = &self.blade.spar {
            let first = shell.layers.len();
            let laid = spar.plies.iter();
            let laid: Vec<Laid> = laid.map(|ply| self.lay(ply, &mut shell)).collect();
            let webs = self.webs.iter().map(|web| self.web(web, spar, &laid));
            let webs = webs.collect();
            shell.spar = Some(Turning { first, webs });
        }
        shell
    }

    /// Adds the layers of a ply of the spar.
    fn lay(&self, ply: &'a SparPly, shell: &mut Shell<'a>) -> Laid {
        let ranges = [ply.upper, ply.lower].map(|range| self.columns_of(ply, range));
        let nose = self.columns.nose();
        let is_around = ranges
            .iter()
            .all(|range| range.is_some_and(|[_, fore]| fore == nose));
        let mut add = |[from, to]: [End; 2]| {
            let ramps = [from.ramp, to.ramp].into_iter().flatten();
            shell.layers.push(Layer {
                from: from.s / self.outline().perimeter(),
                to: to.s / self.outline().perimeter(),
                taper: ramps.reduce(f64::min),
                ..layer(&ply.ply)
            });
            shell.plies.push(Of {
                ply: &ply.ply,
                on_spar: Some(ply),
            });
            shell.layers.len() - 1
        };
        let end = |side: usize, which: usize, [aft, fore]: [usize; 2]| {
            let (column, inner) = [(aft, aft + 1), (fore, fore.saturating_sub(1))][which];
            self.end(ply, side, [column, inner])
        };
        let layers = match ranges {
            [Some(upper), Some(lower)] if is_around => {
                let layer = add([end(0, 0, upper), end(1, 0, lower)]);
                [Some(layer); 2]
            }
            [upper, lower] => [
                upper.map(|range| add([end(0, 0, range), end(0, 1, range)])),
                lower.map(|range| add([end(1, 1, range), end(1, 0, range)])),
            ],
        };
        // of a ply that is only in webs, a layer without width
        let nowhere = End {
            s: 0.5 * self.outline().perimeter(),
            ramp: None,
        };
        let layer = layers[0].or(layers[1]);
        Laid {
            ranges,
            is_around,
            layers,
            layer: layer.unwrap_or_else(|| add([nowhere, nowhere])),
        }
    }

    /// The columns between which a ply, or its filler, lies on a side on which the ply has a range.
    fn columns_of(&self, ply: &SparPly, range: Option<[f64; 2]>) -> Option<[usize; 2]> {
        let aft = self.webs.first()?.column;
        let fore = self
            .webs
            .get(1)
            .map_or(self.columns.nose(), |web| web.column);
        if ply.filler.is_some() {
            return Some([aft, fore]);
        }
        let [from, to] = range?;
        let contour = &self.blade.contour;
        let column = |part: f64| contour.at_chord(0, part).map(|s| self.columns.nearest(s));
        let first = if to.is_finite() { column(to)? } else { aft };
        let last = if from.is_finite() {
            column(from)?
        } else {
            fore
        };
        (first < last).then_some([first, last])
    }

    /// An end of a layer on a side, at a column beside which lies another one of it.
    fn end(&self, ply: &SparPly, side: usize, [column, inner]: [usize; 2]) -> End {
        if let Some(web) = self
            .webs
            .iter()
            .find(|web| web.column == column && ply.is_in(web.web))
        {
            return End {
                s: web.ends[side],
                ramp: None,
            };
        }
        let [s, inner] = [column, inner].map(|column| self.columns.sides[side][column]);
        End {
            s: 0.5 * (s + inner),
            ramp: Some((inner - s).abs()),
        }
    }

    /// A web, with the layers that continue each of its plies on both sides.
    fn web(&self, web: &WebAt, spar: &Spar, laid: &[Laid]) -> SparWeb {
        let plies = || {
            spar.plies
                .iter()
                .zip(laid)
                .filter(|(ply, _)| ply.is_in(web.web))
        };
        let foot = |side: usize, laid: &Laid| {
            let [aft, fore] = laid.ranges[side]?;
            let reaches = aft == web.column || (fore == web.column && !laid.is_around);
            laid.layers[side].filter(|_| reaches)
        };
        let feet = [0, 1].map(|side| plies().map(|(_, laid)| foot(side, laid)).collect());
        SparWeb {
            name: web_word(web.web).into(),
            arcs: web.ends.map(|s| s / self.outline().perimeter()),
            layers: plies().map(|(_, laid)| laid.layer).collect(),
            feet: Some(feet),
        }
    }

    /// Webs that are joined to a surface along an edge only, or that use too much of it.
    pub fn check_feet(&self, shell: &Shell<'_>) -> Vec<BladeProblem> {
        let of_spar = shell.spar.iter().flat_map(|spar| &spar.webs);
        let depth: f64 = self.blade.skin.iter().map(|ply| ply.thickness).sum();
        let mut problems = Vec::new();
        for (number, (of_web, web)) in of_spar.zip(self.webs).enumerate() {
            for (side, feet) in of_web.feet.iter().flatten().enumerate() {
                let feet = feet
                    .iter()
                    .flatten()
                    .map(|foot| shell.layers[*foot].thickness);
                let surface = SIDES[side];
                let thickness: f64 = feet.sum();
                let s = self.columns.sides[side][web.column];
                let other = self
                    .webs
                    .get(1 - number.min(1))
                    .filter(|_| self.webs.len() > 1);
                let end = other.map_or(self.columns.nose(), |other| other.column);
                let end = self.columns.sides[side][end];
                let space = (end - s).abs();
                let forward = if number > 0 { -1.0 } else { 1.0 };
                // how far the inner face is inside of the inner face of the web
                let inside = |at: f64| {
                    let (p, n) = (self.outline().position(at), self.outline().inward(at));
                    let inner = [0, 1].map(|i| p[i] + (depth + thickness) * n[i]);
                    forward * web.line.offset(inner) - thickness
                };
                let need = zero([s, end], inside).map(|at| (at - s).abs());
                let web = web.web;
                if thickness == 0.0 {
                    problems.push(BladeProblem::WebLoose { web, surface });
                } else if need.is_none_or(|need| need > MOST * space) {
                    let thickness = need.unwrap_or(thickness);
                    problems.push(BladeProblem::WebThick {
                        web,
                        surface,
                        thickness,
                        space,
                    });
                }
            }
        }
        problems
    }
}

/// An end of a layer, and the length of its ramp.
#[derive(Debug, Clone, Copy)]
struct End {
    s: f64,
    ramp: Option<f64>,
}

/// A layer all around.
fn layer(ply: &Ply) -> Layer {
    Layer {
        name: ply.name.clone(),
        thickness: ply.thickness,
        from: 0.0,
        to: 1.0,
        taper: None,
        profile: Vec::new(),
    }
}

fn web_word(web: BladePart) -> &'static str {
    match web {
        BladePart::FrontWeb => "front_web",
        _ => "rear_web",
    }
}

impl SparPly {
    /// Whether it, or its filler, is in a web.
    fn is_in(&self, web: BladePart) -> bool {
        self.filler.is_some() || self.webs[usize::from(web != BladePart::FrontWeb)]
    }
}
