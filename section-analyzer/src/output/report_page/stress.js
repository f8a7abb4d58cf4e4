// Stresses of the cells of a section under a load: the sum of six unit loads.

const materials = new Map(data.materials.map((one) => [one.name, one]));
const hasLimits = data.materials.some(({ strength, strain }) => strength || strain);
// For each cell its 36 stresses per unit force; also the steps of these numbers, by ply.
function unitStresses(station) {
  const { stress, plies } = station.picture;
  if (station.units || !stress) return station.units;
  const lists = unpacked(stress, plies.flatMap(({ cells }) => [36, ...Array(36).fill(cells)]));
  const ofPly = (ply) => lists.slice(37 * ply, 37 * ply + 37);
  station.steps = plies.map((_, ply) => ofPly(ply)[0].map((exponent) => 2 ** exponent));
  station.units = plies.flatMap(({ cells }, ply) => {
    const [, ...all] = ofPly(ply);
    return Array.from({ length: cells }, (_, i) => all.map((list, number) => list[i] * station.steps[ply][number]));
  });
  return station.units;
}
// The stress of a cell, from its 36 stresses per unit force.
function superposed(unit, force) {
  return AXES.map((_, c) => force.reduce((sum, value, load) => sum + value * unit[6 * load + c], 0));
}
// The area of a polygon, positive if its corners are counterclockwise.
function area(points) {
  return points.reduce((sum, [y, z], i) => {
    const [v, w] = points[(i + 1) % points.length];
    return sum + 0.5 * (y * w - v * z);
  }, 0);
}
// The stress of a cell on the plane of the section, along x, y and z, from its stress in material axes.
function onSection({ ply, plane }, [s11, s22, s33, s23, s13, s12]) {
  const [fiber, wall] = [ply.axis_angle, plane].map((angle) => (angle * Math.PI) / 180);
  const [c, s, cw, sw] = [Math.cos(fiber), Math.sin(fiber), Math.cos(wall), Math.sin(wall)];
  const across = [[s11, s12, s13], [s12, s22, s23], [s13, s23, s33]].map((row) => row[0] * c - row[1] * s);
  const axes = [[c, s * cw, s * sw], [-s, c * cw, c * sw], [0, -sw, cw]];
  return [0, 1, 2].map((i) => axes.reduce((sum, axis, j) => sum + axis[i] * across[j], 0));
}
// Stress, von Mises stress and governing failure of each cell under the chosen load; null if
// the station has no stresses.
function stressed(station) {
  const units = unitStresses(station);
  if (!units) return null;
  const key = state.force.join();
  if (station.stressed && station.stressed.key === key) return station.stressed.cells;
  const cells = decoded(station).cells.map(({ ply }, k) => {
    const stress = superposed(units[k], state.force);
    const all = failures(materials.get(ply.material) ?? {}, stress);
    const worst = all.length > 0 ? all.reduce((least, one) => (one.reserve < least.reserve ? one : least)) : null;
    return { values: [...stress, vonMises(stress)], worst };
  });
  station.stressed = { key, cells };
  return cells;
}
const STRESSES = [
  "along the fiber", "across the fiber in the ply", "normal to the ply", "shear across the fiber",
  "shear along the fiber, normal to the ply", "shear in the ply", "",
].map((meaning, i) => (i < 6 ? `stress ${AXES[i]}, ${meaning}` : "von Mises stress"));
// The largest size of some of the values over the cells that are shown.
function largestOf(value) {
  const station = current();
  const all = stressed(station);
  if (!all) return 0;
  return station.cells.reduce((most, cell, k) => (isShown(cell) ? Math.max(most, Math.abs(value(all[k]))) : most), 0);
}
// MPa, or Pa for the small stresses of unit loads; one unit for all stresses of a section.
function stressUnit() {
  const largest = largestOf(({ values }) => Math.max(...values.map(Math.abs)));
  return largest > 0 && largest < 1e4 ? { name: "Pa", factor: 1 } : { name: "MPa", factor: 1e-6 };
}
// Colors by a value of the cells under the load, over the range of the cells that are shown.
function underLoad(name, valueOf, isSigned, describe) {
  let known = { key: "", end: 1 };
  const end = () => {
    const key = [state.station, ...state.force, ...state.hidden].join("/");
    if (known.key !== key) known = { key, end: largestOf((one) => valueOf(one) ?? 0) || 1e-30 };
    return known.end;
  };
  return {
    name,
    isOfCell: true,
    isUnderLoad: true,
    of: (cell) => {
      const all = stressed(cell.station);
      const value = all && valueOf(all[cell.number]);
      if (value === null) return PLAIN;
      return isSigned ? diverging(value / end()) : sequential(value / end());
    },
    get bar() {
      const { text, factor } = describe();
      const to = end() * factor;
      const all = `${text}; range of the layers shown; under ${loadName()}`;
      return isSigned ? [-to, to, all, (t) => diverging(2 * t - 1)] : [0, to, all, sequential];
    },
  };
}
STRESSES.forEach((name, i) => {
  const describe = () => {
    const unit = stressUnit();
    return { text: `${unit.name}, ${name}`, factor: unit.factor };
  };
  COLORS[`stress${i}`] = underLoad(name, ({ values }) => values[i], i < 6, describe);
});
if (hasLimits) {
  const describe = () => ({ text: "(1 / reserve factor, 1 is failure; gray: no strength)", factor: 1 });
  COLORS.effort = underLoad("1 / reserve factor under the load", ({ worst }) => (worst ? 1 / worst.reserve : null), false, describe);
}
// The lines of a cell in the drawing.
function describeStress(cell) {
  const all = stressed(cell.station);
  if (!all) return [];
  const { values, worst } = all[cell.number];
  const unit = stressUnit();
  const list = (from, to) => values.slice(from, to).map((value, i) => `${AXES[from + i]} ${digits(value * unit.factor, 4)}`).join(", ");
  const lines = [`stress ${list(0, 3)} ${unit.name}`, `shear ${list(3, 6)} ${unit.name}`, `von Mises ${digits(values[6] * unit.factor, 4)} ${unit.name}, under ${loadName()}`];
  if (worst) lines.push(`failure index of the cell ${digits(worst.index, 4)}, reserve factor ${digits(worst.reserve, 4)} (${worst.criterion}, ${worst.mode})`);
  return lines;
}
// Buttons that show a cell in the drawing.
function placeOf(k) {
  const { ply, middle } = current().cells[k];
  const made = element("button", { type: "button", class: "link" }, `${ply.ply} at ${middle.map(millimeters).join(", ")}`);
  made.addEventListener("click", () => { canvas.focus(); point(k, true); });
  return made;
}
function showExtremes() {
  const station = current();
  const all = stressed(station);
  byId("extreme-table").hidden = !all;
  if (!all) return;
  const shown = station.cells.map((_, k) => k).filter((k) => isShown(station.cells[k]));
  if (shown.length === 0) {
    byId("extreme-table").replaceChildren(element("p", {}, "No layer is shown."));
    return;
  }
  const unit = stressUnit();
  const best = (isBetter) => shown.reduce((a, b) => (isBetter(b, a) ? b : a));
  const rows = STRESSES.map((name, i) => {
    const value = (k) => all[k].values[i];
    return { name, value, least: best((a, b) => value(a) < value(b)), most: best((a, b) => value(a) > value(b)) };
  });
  const place = (row, k) => (row.value(row.least) === row.value(row.most) ? "all cells" : placeOf(k));
  const shownValue = (value) => digits(value * unit.factor, 5);
  const parts = [table(`Extreme stresses of the cells at ${labelOf(station)} under ${loadName()}`, [
    [`stress [${unit.name}]`, (row) => row.name],
    ["smallest", (row) => shownValue(row.value(row.least))], ["in the ply, at y, z [mm]", (row) => place(row, row.least)],
    ["largest", (row) => shownValue(row.value(row.most))], ["in the ply, at y, z [mm]", (row) => place(row, row.most)],
  ], rows)];
  const limited = shown.filter((k) => all[k].worst);
  if (limited.length > 0) parts.push(criticalCells(station, all, limited));
  byId("extreme-table").replaceChildren(...parts);
}
// The critical cell of each ply, the smallest reserve factor first.
function criticalCells(station, all, limited) {
  const worst = new Map();
  for (const k of limited) {
    const { ply } = station.cells[k].ply;
    if (!worst.has(ply) || all[k].worst.reserve < all[worst.get(ply)].worst.reserve) worst.set(ply, k);
  }
  const rows = [...worst.values()].sort((a, b) => all[a].worst.reserve - all[b].worst.reserve);
  return table(`Critical cell of each ply at ${labelOf(station)} under ${loadName()}`, [
    ["in the ply, at y, z [mm]", placeOf],
    ["reserve factor [-]", (k) => digits(all[k].worst.reserve)], ["failure index [-]", (k) => digits(all[k].worst.index)],
    ["criterion", (k) => all[k].worst.criterion], ["mode", (k) => all[k].worst.mode],
  ], rows);
}
