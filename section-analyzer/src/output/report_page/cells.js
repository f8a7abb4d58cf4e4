// The cells of a section, decoded from the data, and the cell at a point.

function bytes(text) {
  const binary = atob(text);
  const found = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i += 1) found[i] = binary.charCodeAt(i);
  return new DataView(found.buffer);
}
function numbers(text, size, read) {
  const view = bytes(text);
  return Array.from({ length: view.byteLength / size }, (_, i) => read(view, i * size));
}
// The cells of a station: corners, layer, ply, middle; decoded once.
function decoded(station) {
  if (station.cells) return station;
  const picture = station.picture;
  const nodes = numbers(picture.nodes, 4, (view, at) => view.getFloat32(at, true));
  const size = picture.index_bytes;
  const corners = numbers(picture.cells, size, (view, at) => (size === 2 ? view.getUint16(at, true) : view.getUint32(at, true)));
  const planes = numbers(picture.plane_angles, 2, (view, at) => view.getInt16(at, true) / 100);
  const layers = new Map(station.layers.map((layer) => [layer.name, layer]));
  const cells = [];
  for (const ply of picture.plies) {
    const layer = layers.get(ply.ply) ?? layers.get(ply.ply.replace(/@[^@]*$/, ""));
    for (let i = 0; i < ply.cells; i += 1) {
      const k = cells.length;
      const points = corners.slice(4 * k, 4 * k + 4).map((node) => [nodes[2 * node], nodes[2 * node + 1]]);
      const used = points[3] === points[2] || corners[4 * k + 3] === corners[4 * k + 2] ? 3 : 4;
      const middle = [0, 1].map((axis) => points.slice(0, used).reduce((sum, point) => sum + point[axis], 0) / used);
      cells.push({ number: k, points, middle, ply, station, plane: planes[k], layer: layer ? layer.name : ply.ply, thickness: layer ? layer.thickness : null, arcs: layer ? layer.arcs : null });
    }
  }
  station.cells = cells;
  station.box = [0, 1].map((axis) => {
    const all = nodes.filter((_, i) => i % 2 === axis);
    return [all.reduce((a, b) => Math.min(a, b), Infinity), all.reduce((a, b) => Math.max(a, b), -Infinity)];
  });
  station.grid = gridOf(station);
  return station;
}
// Cells by squares of a grid over the section.
function gridOf({ cells, box }) {
  const count = Math.ceil(Math.sqrt(cells.length)) + 1;
  const step = box.map(([from, to]) => (to - from) / count || 1);
  const squares = new Map();
  const square = (x, axis) => Math.max(0, Math.min(count - 1, Math.floor((x - box[axis][0]) / step[axis])));
  cells.forEach((cell, k) => {
    const [from, to] = [Math.min, Math.max].map((end) => [0, 1].map((axis) => square(end(...cell.points.map((p) => p[axis])), axis)));
    for (let i = from[0]; i <= to[0]; i += 1) {
      for (let j = from[1]; j <= to[1]; j += 1) {
        const key = i * count + j;
        if (!squares.has(key)) squares.set(key, []);
        squares.get(key).push(k);
      }
    }
  });
  return { at: (point) => squares.get(square(point[0], 0) * count + square(point[1], 1)) ?? [] };
}
function isInside(points, [y, z]) {
  let inside = false;
  for (let i = 0, j = points.length - 1; i < points.length; j = i, i += 1) {
    const [a, b] = [points[i], points[j]];
    if ((a[1] > z) !== (b[1] > z) && y < ((b[0] - a[0]) * (z - a[1])) / (b[1] - a[1]) + a[0]) inside = !inside;
  }
  return inside;
}
const isShown = (cell) => !state.hidden.has(cell.layer);
// The number of the visible cell at a point of the current section; -1 without one.
function pick(point) {
  const { grid, cells } = current();
  const found = grid.at(point).find((k) => isShown(cells[k]) && isInside(cells[k].points, point));
  return found ?? -1;
}
const current = () => decoded(stations[state.station]);
