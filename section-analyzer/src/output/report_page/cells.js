// The cells of a section, decoded from the data, and the cell at a point.

function bytes(text) {
  const binary = atob(text);
  const found = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i += 1) found[i] = binary.charCodeAt(i);
  return new DataView(found.buffer);
}
// Lists of integers of some lengths from one text: Rice codes of the errors of a prediction.
function unpacked(text, lengths) {
  const [long, whole] = [20, 40];
  const view = bytes(text);
  let at = 0;
  const bit = () => {
    const found = (view.getUint8(at >> 3) >> (7 - (at & 7))) & 1;
    at += 1;
    return found;
  };
  const number = (count) => {
    let found = 0;
    for (let i = 0; i < count; i += 1) found = 2 * found + bit();
    return found;
  };
  const code = (low) => {
    let high = 0;
    while (high < long && bit() === 1) high += 1;
    return high === long ? number(whole) : high * 2 ** low + number(low);
  };
  return lengths.map((length) => {
    const [order, low] = [number(2), number(5)];
    let [last, before] = [0, 0];
    return Array.from({ length }, () => {
      const error = code(low);
      const found = [0, last, 2 * last - before][order] + (error % 2 === 0 ? error / 2 : -(error + 1) / 2);
      [before, last] = [last, found];
      return found;
    });
  });
}
// The cells of a station: corners, layer, ply, middle; decoded once.
function decoded(station) {
  if (station.cells) return station;
  const picture = station.picture;
  const count = picture.mesh_cells;
  const [y, z, ...lists] = unpacked(picture.geometry, [picture.corners, picture.corners, count, count, count, count, count]);
  const [planes, corners] = [lists.pop(), lists];
  const place = (node) => [y[node], z[node]].map((number, axis) => picture.origin[axis] + number * picture.step);
  const layers = new Map(station.layers.map((layer) => [layer.name, layer]));
  const cells = [];
  for (const ply of picture.plies) {
    const layer = layers.get(ply.ply) ?? layers.get(ply.ply.replace(/@[^@]*$/, ""));
    for (let i = 0; i < ply.cells; i += 1) {
      const k = cells.length;
      const points = corners.map((list) => place(list[k]));
      const used = corners[3][k] === corners[2][k] ? 3 : 4;
      const middle = [0, 1].map((axis) => points.slice(0, used).reduce((sum, point) => sum + point[axis], 0) / used);
      cells.push({ number: k, points, middle, ply, station, plane: planes[k] / 100, layer: layer ? layer.name : ply.ply, thickness: layer ? layer.thickness : null, arcs: layer ? layer.arcs : null });
    }
  }
  station.cells = cells;
  station.box = [y, z].map((all, axis) => [0, all.reduce((a, b) => Math.max(a, b), 0)].map((number) => picture.origin[axis] + number * picture.step));
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
