//! Areas of the layers: as given on the curved surface, and of their cells.

use shared_geom::mesh::{Cell, Mesh};

use super::super::super::distance;
use super::problem::LayupProblem;
use super::spar::{SparWall, WebWall};
use super::types::{LayerArea, LayupSection};
use super::wall::{Edge, Wall};

/// Samples of the integral along the contour.
const SAMPLES: usize = 2000;

/// Areas of the layers, of the plies of webs, and of fills.
pub(super) fn areas(section: &LayupSection, wall: &Wall, mesh: &Mesh) -> Vec<LayerArea> {
    let mut areas: Vec<LayerArea> = Vec::new();
    let (nominal, cut) = nominal(wall);
    let found = nominal.into_iter().zip(cut);
    for (layer, (nominal, cut)) in section.layers.iter().zip(found) {
        areas.push(LayerArea {
            name: layer.name.clone(),
            nominal,
            meshed: 0.0,
            cut,
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

/// Areas of the layers of the shell on the curved surface, and their parts that are cut where both
/// sides meet, and behind, where the edge is too thin.
fn nominal(wall: &Wall) -> (Vec<f64>, Vec<f64>) {
    let [from, to] = if wall.edge.is_ring() {
        [0.0, wall.outline.perimeter()]
    } else {
        wall.ends
    };
    let mut sums = vec![0.0; wall.stack.len()];
    let mut cut = sums.clone();
    // the layers of a spar end without a ramp
    let webs = wall.spar.iter().flat_map(|spar| &spar.webs);
    let corners = webs.flat_map(|web| web.corners);
    let kinks = wall.stack.kinks().into_iter().map(|kink| kink.s);
    let inside = corners.chain(kinks).filter(|s| *s > from && *s < to);
    let mut ends: Vec<f64> = [from, to].into_iter().chain(inside).collect();
    ends.sort_by(f64::total_cmp);
    for pair in ends.windows(2).filter(|pair| pair[1] > pair[0]) {
        let count = (SAMPLES as f64 * (pair[1] - pair[0]) / (to - from)).ceil();
        let step = (pair[1] - pair[0]) / count;
        for i in 0..count as usize {
            let s = pair[0] + step * (i as f64 + 0.5);
            let bend = wall.outline.bend(s);
            let area = |[outer, inner]: [f64; 2]| {
                (inner - outer) * (1.0 - 0.5 * bend * (inner + outer)) * step
            };
            let limit = wall.cut_at(s).unwrap_or(f64::MAX);
            let mut outer = 0.0_f64;
            for (layer, inner) in wall.stack.given_depths(s).into_iter().enumerate() {
                // beyond the contact there is no surface: thickness times length
                let beyond = (inner.max(limit) - outer.max(limit)) * step;
                sums[layer] += area([outer.min(limit), inner.min(limit)]) + beyond;
                cut[layer] += beyond;
                outer = inner;
            }
        }
    }
    if matches!(wall.edge, Edge::Face | Edge::Butt) {
        add_ends(wall, &mut sums);
    }
    for (layer, area) in behind(wall).into_iter().enumerate() {
        sums[layer] += area;
        cut[layer] += area;
    }
    // a mitre takes of both sides
    for corner in &wall.mitres {
        let mut outer = 0.0;
        for (layer, inner) in wall.stack.depths(corner.s).into_iter().enumerate() {
            sums[layer] -= (inner * inner - outer * outer) * corner.tangent;
            outer = inner;
        }
    }
    if let Some(spar) = &wall.spar {
        add_spar(wall, spar, &mut sums);
    }
    (sums, cut)
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

/// Parts of the layers between their ends on the base, which may be oblique, and the normals there: with
/// the lean M of the column on the base, along the contour, `M (d2^2 - d1^2) / 2` between depths.
fn add_ends(wall: &Wall, sums: &mut [f64]) {
    for (s, sign) in wall.ends.into_iter().zip([-1.0, 1.0]) {
        let (column, n) = (wall.column(s), wall.outline.inward(s));
        let lean = n[0] * column.direction[1] - n[1] * column.direction[0];
        let limit = column.depths.last().copied().unwrap_or(0.0);
        let mut outer = 0.0;
        for (sum, inner) in sums.iter_mut().zip(wall.stack.given_depths(s)) {
            let inner = inner.min(limit);
            *sum += 0.5 * sign * lean * (inner * inner - outer * outer);
            outer = inner;
        }
    }
}

/// The parts along the webs of a spar; each of their mitres takes of both surfaces.
fn add_spar(wall: &Wall, spar: &SparWall, sums: &mut [f64]) {
    for web in &spar.webs {
        add_web(wall, (spar, web), sums);
    }
}

/// The parts along a web of a spar.
fn add_web(wall: &Wall, (spar, web): (&SparWall, &WebWall), sums: &mut [f64]) {
    let faces = web.corners.map(|s| {
        let (p, n) = (wall.outline.position(s), wall.outline.inward(s));
        let depth = wall.stack.before(spar.first, s);
        [0, 1].map(|i| p[i] + depth * n[i])
    });
    let length = distance(faces[0], faces[1]);
    for (side, s) in web.corners.into_iter().enumerate() {
        let mut outer = 0.0;
        for (layer, sum) in sums.iter_mut().enumerate().skip(spar.first) {
            let inner = outer + wall.stack.thickness(layer, s);
            *sum -= 0.5 * (inner * inner - outer * outer) * web.leans[side];
            outer = inner;
        }
    }
    let lean = web.leans[0] + web.leans[1];
    let mut outer = 0.0;
    for layer in &web.layers {
        let inner = outer + wall.stack.full(*layer);
        sums[*layer] += (inner - outer) * (length - 0.5 * (inner + outer) * lean);
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
