//! The cavities of a meshed blade, between the nodes of its walls, and their cores.

use super::super::grid::Grid;
use super::super::layup::cells::Row;
use super::Blade;
use super::columns::Columns;
use super::fill;
use super::shell::WebAt;

/// Nodes of the inner faces of skin and spar.
#[derive(Debug)]
pub(super) struct Inside {
    /// Inner face of the skin: the columns on the upper and the lower side.
    pub skin: [Vec<u32>; 2],
    /// Inner face of the skin at the rear end, upward.
    pub edge: Vec<u32>,
    /// Inner face of the spar: the columns from the rear web forward; of the whole without a spar.
    pub spar: [Vec<u32>; 2],
    /// Nodes of the webs by level, each from the upper to the lower side; the rear web first.
    pub webs: Vec<Vec<Vec<u32>>>,
}

/// The nodes inside of the walls; `knee` is the level of the inner face of the skin.
pub(super) fn inside(
    columns: &Columns,
    rows: &[Row],
    (webs, nodes): (&[WebAt], Vec<Vec<Vec<u32>>>),
    (knee, is_closed): (usize, bool),
) -> Inside {
    let at = |s: f64| rows.partition_point(|row| row.s < s);
    let skin = columns.sides.each_ref().map(|side| {
        let node = |s: &f64| rows[at(*s).min(rows.len() - 1)].nodes[knee];
        side.iter().map(node).collect::<Vec<u32>>()
    });
    let [upper, lower] = columns.sides.each_ref().map(|side| at(side[0]));
    let mut edge = vec![skin[1][0], skin[0][0]];
    if is_closed {
        let around = rows[lower..].iter().chain(&rows[..=upper]);
        edge = around.map(|row| row.nodes[knee]).collect();
        edge.dedup();
    }
    let from = webs.first().map_or(0, |web| web.column);
    let to = webs.get(1).map_or(columns.nose(), |web| web.column);
    let spar = columns.sides.each_ref().map(|side| {
        let node = |s: &f64| {
            // of both columns at a corner the one with the spar
            let here = rows[at(*s)..].iter().take_while(|row| row.s == *s);
            let inner = here.map(|row| row.nodes[row.nodes.len() - 1]);
            inner.reduce(|a, b| if rows[at(*s)].nodes[knee] == a { b } else { a })
        };
        side[from..=to]
            .iter()
            .filter_map(node)
            .collect::<Vec<u32>>()
    });
    Inside {
        skin,
        edge,
        spar,
        webs: nodes,
    }
}

impl Blade {
    /// Fills the cavities with their cores and the nose mass.
    pub(super) fn fill(&self, grid: &mut Grid, columns: &Columns, webs: &[WebAt], inside: &Inside) {
        let nose = columns.nose();
        let nose_node = vec![inside.skin[0][nose]];
        let mark = self.cores.nose_mass.as_ref().and_then(|(to, _)| {
            let s = self.contour.at_chord(0, *to)?;
            Some(columns.nearest(s))
        });
        let cores = &self.cores;
        let upward = |web: usize, is_inner: bool| -> Option<Vec<u32>> {
            let lines = inside.webs.get(web)?;
            let line = if is_inner {
                lines.last()
            } else {
                lines.first()
            };
            Some(line?.iter().rev().copied().collect())
        };
        let (Some(rear), Some(aft_end)) = (webs.first(), upward(0, false)) else {
            let walls = [&inside.skin[0][..], &inside.skin[1]];
            let ends = [inside.edge.clone(), nose_node];
            return self.fill_cavity(grid, (walls, ends), cores.aft.as_ref(), mark);
        };
        let walls = [0, 1].map(|side| &inside.skin[side][..=rear.column]);
        let ends = [inside.edge.clone(), aft_end];
        self.fill_cavity(grid, (walls, ends), cores.aft.as_ref(), None);
        let front = webs.get(1);
        let tip = || inside.spar[0].last().copied().into_iter().collect();
        let walls = [&inside.spar[0][..], &inside.spar[1]];
        let ends = [
            upward(0, true).unwrap_or_default(),
            upward(1, true).unwrap_or_else(tip),
        ];
        let after = |column: usize| mark.map(|mark| mark.saturating_sub(column));
        let of_spar = after(rear.column).filter(|_| front.is_none());
        self.fill_cavity(grid, (walls, ends), cores.spar.as_ref(), of_spar);
        if let (Some(front), Some(line)) = (front, upward(1, false)) {
            let walls = [0, 1].map(|side| &inside.skin[side][front.column..]);
            let ends = [line, nose_node];
            self.fill_cavity(
                grid,
                (walls, ends),
                cores.nose.as_ref(),
                after(front.column),
            );
        }
    }

    /// Fills a cavity between two walls, with lines at its first and its last column upward, with its
    /// core, and from the column `mark` of it on with the mass.
    fn fill_cavity(
        &self,
        grid: &mut Grid,
        (walls, ends): ([&[u32]; 2], [Vec<u32>; 2]),
        core: Option<&String>,
        mark: Option<usize>,
    ) {
        if core.is_none() && mark.is_none() {
            return;
        }
        let mass = self.cores.nose_mass.as_ref().map(|(_, name)| name);
        let lines = fill::lines(grid, walls, ends, self.sizes.core);
        for (index, pair) in lines.windows(2).enumerate() {
            let is_mass = mark.is_some_and(|mark| index >= mark);
            if let Some(name) = if is_mass { mass } else { core } {
                fill::strip(grid, &pair[0], &pair[1], std::slice::from_ref(name));
            }
        }
    }
}
