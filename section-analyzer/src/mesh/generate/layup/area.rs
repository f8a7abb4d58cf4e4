//! Areas of the layers: as given on the curved surface, and of their cells.

use shared_geom::mesh::{Cell, Mesh};

use super::super::super::distance;
use super::problem::LayupProblem;
use super::spar::{SparWall, WebWall};
use super::types::{LayerArea, LayupSection};
use super::wall::Wall;

/// Samples of the integral along the contour.
const SAMPLES: usize = 2000;
/// Distance of the first and last columns from a corner, in samples.
const INSIDE: f64 = 1e-8;

/// Areas of the layers, of the plies of webs, and of fills.
pub(super) fn areas(section: &LayupSection, wall: &Wall, mesh: &Mesh) -> Vec<LayerArea> {
    let mut areas: Vec<LayerArea> = Vec::new();
    for (layer, of_layer) in section.layers.iter().zip(Given::all(wall)) {
        areas.push(LayerArea {
            name: layer.name.clone(),
            nominal: of_layer.nominal,
            meshed: 0.0,
            cut: of_layer.cut,
            filled: of_layer.filled,
        });
    }
    let plies = section.webs.iter().flat_map(|web| &web.plies);
    let fills = section.fills.iter().map(|fill| &fill.name);
    areas.extend(
        plies
            .map(|ply| &ply.name)
            .chain(fills)
            .map(|name| LayerArea {
                name: name.clone(),
                nominal: f64::NAN,
                meshed: 0.0,
                cut: 0.0,
                filled: 0.0,
            }),
    );
    for cell in &mesh.cells {
        let group = cell.groups.first().and_then(|first| mesh.groups.get(first));
        let name = group
            .and_then(|group| group.name.as_deref())
            .unwrap_or_default();
        if let Some(area) = areas.iter_mut().find(|area| area.name == name) {
            area.meshed += area_of(mesh, cell);
        }
    }
    for area in areas.iter_mut().filter(|area| area.nominal.is_nan()) {
        area.nominal = area.meshed;
    }
    areas
}

/// Largest area of the cells of all layers in their areas; parts that fill an edge have more than
/// their own.
const MOST: f64 = 1.2;

/// Checks that the cells are not more than the layers.
///
/// # Errors
/// The layer with the largest part.
pub(super) fn check(areas: &[LayerArea]) -> Result<(), LayupProblem> {
    let sum = |of: fn(&LayerArea) -> f64| areas.iter().map(of).sum::<f64>();
    if sum(|area| area.meshed) <= MOST * sum(|area| area.nominal) {
        return Ok(());
    }
    let part = |area: &&LayerArea| area.meshed / area.nominal;
    let present = areas.iter().filter(|area| area.nominal > 0.0);
    let worst = present.max_by(|a, b| part(a).total_cmp(&part(b)));
    worst.map_or(Ok(()), |area| {
        Err(LayupProblem::Area {
            layer: area.name.clone(),
            part: part(&area),
        })
    })
}

/// Area of a layer of the shell.
#[derive(Debug, Clone, Copy, Default)]
struct Given {
    /// On the curved surface.
    nominal: f64,
    /// The part that is cut where both sides meet, and behind, where the edge is too thin.
    cut: f64,
    /// The area that it fills in addition, as the innermost layer between both sides.
    filled: f64,
}

impl Given {
    /// Of all layers.
    fn all(wall: &Wall) -> Vec<Self> {
        let mut all = along_surface(wall);
        for (one, area) in all.iter_mut().zip(behind(wall)) {
            one.nominal += area;
            one.cut += area;
        }
        if let Some(spar) = &wall.spar {
            add_spar(wall, spar, &mut all);
        }
        add_ahead(wall, &mut all);
        all
    }
}

/// Areas between the ends of both sides, or all around. Between two columns whose lean M along the contour changes, a
/// layer between the depths d1 and d2 has more by `(d2^2 - d1^2) M' / 2` per length: at a mitre, and at an oblique end.
fn along_surface(wall: &Wall) -> Vec<Given> {
    let [from, to] = if wall.edge.is_ring() {
        [0.0, wall.outline.perimeter()]
    } else {
        wall.ends
    };
    let mut all = vec![Given::default(); wall.stack.len()];
    // the layers of a spar end without a ramp
    let webs = wall.spar.iter().flat_map(|spar| &spar.webs);
    let corners = webs.flat_map(|web| web.corners);
    let corners = corners.chain(wall.mitres.iter().map(|mitre| mitre.s));
    let kinks = wall.stack.kinks().into_iter().map(|kink| kink.s);
    let inside = corners.chain(kinks).filter(|s| *s > from && *s < to);
    let mut ends: Vec<f64> = [from, to].into_iter().chain(inside).collect();
    ends.sort_by(f64::total_cmp);
    for pair in ends.windows(2).filter(|pair| pair[1] > pair[0]) {
        let count = (SAMPLES as f64 * (pair[1] - pair[0]) / (to - from)).ceil();
        let step = (pair[1] - pair[0]) / count;
        // the lean jumps at a corner
        let inside = |s: f64| s.clamp(pair[0] + INSIDE * step, pair[1] - INSIDE * step);
        let mut lean = wall.lean(inside(pair[0]));
        for i in 0..count as usize {
            let s = pair[0] + step * (i as f64 + 0.5);
            let next = wall.lean(inside(pair[0] + step * (i as f64 + 1.0)));
            let bend = wall.outline.bend(s) - (next - lean) / step;
            lean = next;
            let area = |[outer, inner]: [f64; 2]| {
                (inner - outer) * (1.0 - 0.5 * bend * (inner + outer)) * step
            };
            let end = wall.cut_at(s);
            let limit = end.unwrap_or(f64::MAX);
            let (mut outer, mut innermost) = (0.0_f64, None);
            for (layer, inner) in wall.stack.given_depths(s).into_iter().enumerate() {
                // beyond the contact there is no surface: thickness times length
                let beyond = (inner.max(limit) - outer.max(limit)) * step;
                all[layer].nominal += area([outer.min(limit), inner.min(limit)]) + beyond;
                all[layer].cut += beyond;
                innermost = Some(layer).filter(|_| inner > outer).or(innermost);
                outer = inner;
            }
            if let (Some(layer), Some(end)) = (innermost, end.filter(|end| *end > outer)) {
                all[layer].filled += area([outer, end]);
            }
        }
    }
    all
}

/// Areas ahead of contacts that begin with a gap: there the innermost layer of each side is stretched more and more.
fn add_ahead(wall: &Wall, all: &mut [Given]) {
    for [from, _] in &wall.contacts {
        let Some(before) = wall.stretched_from(*from) else {
            continue;
        };
        let pair = wall.pairs.pair(*from);
        for side in 0..2 {
            let s = pair.s[side];
            let depths = wall.stack.given_depths(s);
            let more = pair.limit(side, &wall.stack) - depths.last().unwrap_or(&0.0);
            let length = (s - wall.pairs.at(side, before)).abs();
            if let Some(layer) = wall.stack.innermost(s).filter(|_| more > 0.0) {
                all[layer].filled += 0.5 * more * length;
            }
        }
    }
}

/// Areas of the layers along an edge that is too thin for the first of them, thickness times length.
fn behind(wall: &Wall) -> Vec<f64> {
    let [first, last] = wall.outline.corners();
    let mut sums = vec![0.0; wall.stack.len()];
    for [from, to] in [[first, wall.ends[0]], [wall.ends[1], last]] {
        let step = (to - from) / SAMPLES as f64;
        if wall.edge.is_ring() || step <= 0.0 {
            continue;
        }
        for i in 0..SAMPLES {
            let mut outer = 0.0;
            let depths = wall.stack.given_depths(from + step * (i as f64 + 0.5));
            for (sum, inner) in sums.iter_mut().zip(depths) {
                *sum += (inner - outer) * step;
                outer = inner;
            }
        }
    }
    sums
}

/// The parts along the webs of a spar; each of their mitres takes of both surfaces.
fn add_spar(wall: &Wall, spar: &SparWall, all: &mut [Given]) {
    for web in &spar.webs {
        add_web(wall, (spar, web), all);
    }
}

/// The parts along a web of a spar.
fn add_web(wall: &Wall, (spar, web): (&SparWall, &WebWall), all: &mut [Given]) {
    let faces = web.corners.map(|s| {
        let (p, n) = (wall.outline.position(s), wall.outline.inward(s));
        let depth = wall.stack.before(spar.first, s);
        [0, 1].map(|i| p[i] + depth * n[i])
    });
    let length = distance(faces[0], faces[1]);
    for (side, s) in web.corners.into_iter().enumerate() {
        let mut outer = 0.0;
        for (layer, one) in all.iter_mut().enumerate().skip(spar.first) {
            let inner = outer + wall.stack.thickness(layer, s);
            one.nominal -= 0.5 * (inner * inner - outer * outer) * web.leans[side];
            outer = inner;
        }
    }
    let lean = web.leans[0] + web.leans[1];
    let mut outer = 0.0;
    for layer in &web.layers {
        let inner = outer + wall.stack.full(*layer);
        all[*layer].nominal += (inner - outer) * (length - 0.5 * (inner + outer) * lean);
        outer = inner;
    }
}

/// Area of a cell.
pub(in super::super) fn area_of(mesh: &Mesh, cell: &Cell) -> f64 {
    let positions = || {
        cell.nodes()
            .iter()
            .map(|node| mesh.nodes[*node as usize].position)
    };
    let at = |point: &shared_geom::quadrature::PlanePoint| {
        let shape = cell.kind.shape(point.r, point.s);
        let mut j = [[0.0; 2]; 2];
        for (n, position) in positions().enumerate() {
            for i in 0..2 {
                j[i][0] += shape.dr[n] * position[i];
                j[i][1] += shape.ds[n] * position[i];
            }
        }
        point.weight * (j[0][0] * j[1][1] - j[0][1] * j[1][0])
    };
    cell.kind.rule().iter().map(at).sum()
}
