// Layers, materials and reserve factors of a station; stiffness and mass with their meaning.

// Layers of the station with their mass and the color of their first cell.
function layerRows() {
  const station = current();
  return station.layers.map((layer) => {
    const cells = station.cells.filter((cell) => cell.layer === layer.name);
    const density = cells.length > 0 ? cells[0].ply.density : 0;
    const fibers = [...new Set(cells.map((cell) => cell.ply.fiber_angle))];
    return { layer, fibers, mass: layer.meshed * density, first: cells[0] };
  });
}
function swatch(cell) {
  if (COLORS[state.color].isOfCell) return "";
  const style = cell ? `background: ${COLORS[state.color].of(cell)}` : "";
  return element("span", { class: "swatch", style, "aria-hidden": "true" });
}
function toggle(names, isHidden) {
  names.forEach((name) => (isHidden ? state.hidden.add(name) : state.hidden.delete(name)));
  if (state.cell >= 0 && !isShown(current().cells[state.cell])) point(-1, false);
  refresh();
}
// Sums over the cells of each layer: the axial force under a unit axial strain, and the bending moments y
// and z about the tension center under these moments alone; as parts of the sums of all layers.
function layerShares(station) {
  const units = unitStresses(station);
  if (!units) return null;
  if (station.shares) return station.shares;
  const [y0, z0] = station.tension_center;
  const unit = (i) => [0, 1, 2, 3, 4, 5].map((j) => (i === j ? 1 : 0));
  const loads = [
    [station.stiffness.map((row) => row[0]), () => 1],
    [unit(4), ([, z]) => z - z0],
    [unit(5), ([y]) => y0 - y],
  ];
  const found = new Map(station.layers.map(({ name }) => [name, [0, 0, 0]]));
  const sums = [0, 0, 0];
  station.cells.forEach((cell, k) => loads.forEach(([force, arm], i) => {
    const part = Math.abs(area(cell.points)) * onSection(cell, superposed(units[k], force))[0] * arm(cell.middle);
    sums[i] += part;
    if (found.has(cell.layer)) found.get(cell.layer)[i] += part;
  }));
  station.shares = new Map([...found].map(([name, parts]) => [name, parts.map((part, i) => part / sums[i])]));
  return station.shares;
}
function showLayers() {
  const rows = layerRows();
  const shares = layerShares(current());
  const shareOf = (i) => ({ layer }) => percent(shares.get(layer.name)[i]);
  const total = rows.reduce((sum, row) => sum + row.mass, 0);
  const percent = (part) => `${digits(100 * part, 3)} %`;
  const choice = ({ layer, first }) => {
    const box = element("input", { type: "checkbox" });
    box.checked = !state.hidden.has(layer.name);
    box.dataset.layer = layer.name;
    box.addEventListener("change", () => toggle([layer.name], !box.checked));
    return element("label", {}, box, " ", swatch(first), layer.name);
  };
  byId("layer-table").replaceChildren(table(`Layers at ${labelOf(current())}`, [
    ["layer, shown", choice],
    ["material", (row) => row.layer.material],
    ["fiber angle [deg]", (row) => row.fibers.map((angle) => (angle === null ? "isotropic" : digits(angle))).join(", ")],
    ["thickness [mm]", (row) => (row.layer.thickness === null ? "" : millimeters(row.layer.thickness))],
    ["from arc [-]", (row) => (row.layer.arcs ? digits(row.layer.arcs[0], 4) : "")],
    ["to arc [-]", (row) => (row.layer.arcs ? digits(row.layer.arcs[1], 4) : "")],
    ["area [mm\u00b2]", (row) => digits(row.layer.meshed * 1e6, 4)],
    ["of the nominal area", (row) => percent(row.layer.meshed / row.layer.nominal)],
    ["mass [kg/m]", (row) => digits(row.mass, 4)],
    ["of the mass", (row) => percent(row.mass / total)],
    ...(shares ? [["of EA", shareOf(0)], ["of EI about y", shareOf(1)], ["of EI about z", shareOf(2)]] : []),
  ], rows));
  const materials = [...new Set(rows.map((row) => row.layer.material))].map((name) => {
    const own = rows.filter((row) => row.layer.material === name);
    const sum = (value) => own.reduce((all, row) => all + value(row), 0);
    return { name, area: sum((row) => row.layer.meshed), mass: sum((row) => row.mass) };
  });
  byId("material-table").replaceChildren(table(`Materials at ${labelOf(current())}`, [
    ["material", (row) => row.name],
    ["area [mm\u00b2]", (row) => digits(row.area * 1e6, 4)],
    ["mass [kg/m]", (row) => digits(row.mass, 4)],
    ["of the mass", (row) => percent(row.mass / total)],
  ], materials));
  showReserves();
}
function showReserves() {
  const rows = data.reserves.filter((row) => row.section === current().name);
  if (data.reserves.length === 0) return;
  rows.sort((a, b) => (a.reserve_factor ?? Infinity) - (b.reserve_factor ?? Infinity));
  byId("reserve-table").replaceChildren(table(`Smallest reserve factors over all loads at ${labelOf(current())}`, [
    ["ply", (row) => row.ply],
    ["reserve factor [-]", (row) => digits(row.reserve_factor)],
    ["failure index [-]", (row) => digits(row.failure_index)],
    ["criterion", (row) => criterionName(row.criterion)],
    ["mode", (row) => row.mode],
    ["instant, load of the stresses", (row) => {
      const made = element("button", { type: "button", class: "link" }, row.instant);
      made.addEventListener("click", () => load({ kind: "instant", value: row.instant }));
      return made;
    }],
    ["y [mm]", (row) => millimeters(row.position[0])],
    ["z [mm]", (row) => millimeters(row.position[1])],
  ], rows));
}
function showLegend() {
  const { bar } = COLORS[state.color];
  const parts = [];
  if (bar) {
    const [from, to, text, color] = bar;
    const stops = Array.from({ length: 13 }, (_, i) => color(i / 12)).join(", ");
    parts.push(element("div", { class: "bar" }, digits(from, 4), element("i", { style: `background: linear-gradient(to right, ${stops})` }), `${digits(to, 4)} ${text}`));
  } else {
    const key = state.color === "layer" ? (cell) => cell.layer : (cell) => cell.ply.material;
    const firsts = new Map();
    current().cells.forEach((cell) => firsts.has(key(cell)) || firsts.set(key(cell), cell));
    parts.push(element("ul", {}, ...[...firsts].map(([name, cell]) => element("li", {}, swatch(cell), name))));
  }
  const places = CENTERS.map(([name, key, letter]) => `${letter} ${name} (${current()[key].map(millimeters).join(", ")}) mm`);
  parts.push(element("p", {}, `O reference line, ${places.join(", ")}; dashed: principal axes of bending at ${digits(current().bending_angle, 4)} deg`));
  byId("legend").replaceChildren(...parts);
}



const FORCES = ["axial force", "shear force y", "shear force z", "torque", "bending moment y", "bending moment z"];
const STRAINS = ["axial strain", "shear strain y", "shear strain z", "twist rate", "curvature about y", "curvature about z"];
const MOMENTA = ["momentum along x", "momentum along y", "momentum along z", "angular momentum about x", "angular momentum about y", "angular momentum about z"];
const VELOCITIES = ["velocity along x", "velocity along y", "velocity along z", "angular velocity about x", "angular velocity about y", "angular velocity about z"];
const MATRICES = {
  stiffness: { letter: "K", title: "Stiffness K", units: ["N", "N m", "N m\u00b2"], rows: FORCES, columns: STRAINS },
  mass: { letter: "M", title: "Mass per length M", units: ["kg/m", "kg", "kg m"], rows: MOMENTA, columns: VELOCITIES },
};
const unitOf = (kind, i, j) => MATRICES[kind].units[Math.floor(i / 3) + Math.floor(j / 3)];
function share(matrix, i, j) {
  const scale = Math.sqrt(Math.abs(matrix[i][i] * matrix[j][j]));
  return scale > 0 ? Math.abs(matrix[i][j]) / scale : 0;
}
function meaning(kind, i, j, order) {
  const { letter, rows, columns } = MATRICES[kind];
  return `${letter}${i + 1}${j + 1}: ${named(rows, order)[i]} per ${named(columns, order)[j]} [${unitOf(kind, i, j)}]`;
}
// A matrix in the axes and order of another program: a component may be the negative of another one.
function inOrder(matrix, { index, sign }) {
  return index.map((i, row) => index.map((j, column) => sign[row] * sign[column] * matrix[i][j]));
}
// The words of components in an order.
function named(words, { index, sign }) {
  return index.map((i, row) => (sign[row] < 0 ? `negative ${words[i]}` : words[i]));
}
function matrixTable(station, kind, caption, order = data.orders[0]) {
  const matrix = inOrder(station[kind], order);
  const { letter } = MATRICES[kind];
  const [rows, columns] = [named(MATRICES[kind].rows, order), named(MATRICES[kind].columns, order)];
  const head = element("tr", {}, element("td", {}), ...order.components.map((name, j) => element("th", { scope: "col", title: columns[j] }, name)));
  const body = matrix.map((row, i) => element("tr", {}, element("th", { scope: "row", title: rows[i] }, order.components[i]),
    ...row.map((value, j) => {
      const part = share(matrix, i, j);
      const look = part < 1e-6 ? "small" : i !== j && part > 0.01 ? "coupled" : "";
      const cell = element("td", { class: look, title: meaning(kind, i, j, order) }, digits(value));
      Object.assign(cell.dataset, { kind, row: String(i), column: String(j), letter });
      return cell;
    })));
  return element("table", {}, element("caption", {}, caption), element("thead", {}, head), element("tbody", {}, ...body));
}
function explain(cell) {
  const { kind, row, column } = cell.dataset;
  const [i, j] = [Number(row), Number(column)];
  const order = data.orders[state.order];
  const matrix = inOrder(stations[state.station][kind], order);
  const part = i === j ? "" : `, ${digits(100 * share(matrix, i, j), 3)} % of the root of the product of the diagonal entries`;
  byId("entry").textContent = `${meaning(kind, i, j, order)}: ${matrix[i][j]}${part}`;
}
// One cell of a table is in the order of the tab key; arrows move it.
function listenToMatrix(made) {
  const cells = [...made.querySelectorAll("td[data-row]")];
  cells.forEach((cell, k) => cell.setAttribute("tabindex", k === 0 ? "0" : "-1"));
  made.addEventListener("pointerover", (event) => event.target.dataset.row && explain(event.target));
  made.addEventListener("focusin", (event) => event.target.dataset.row && explain(event.target));
  made.addEventListener("keydown", (event) => {
    const move = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: 6, ArrowUp: -6 }[event.key];
    const from = cells.indexOf(event.target);
    if (!move || from < 0) return;
    event.preventDefault();
    event.stopPropagation();
    const to = cells[from + move];
    const isSameRow = Math.floor((from + move) / 6) === Math.floor(from / 6);
    if (!to || (Math.abs(move) === 1 && !isSameRow)) return;
    cells[from].setAttribute("tabindex", "-1");
    to.setAttribute("tabindex", "0");
    to.focus();
    // A window without the focus has no focus events.
    explain(to);
  });
}
// The couplings of a matrix above 1 %, as text.
function couplings(station, kind) {
  const found = [];
  const [{ letter }, matrix] = [MATRICES[kind], station[kind]];
  const at = (key, axis) => `${["y", "z"][axis]} = ${millimeters(station[key][axis])} mm`;
  const center = kind === "mass" ? ["mass center", "mass_center"] : ["tension center", "tension_center"];
  const causes = {
    "0,4": `the ${center[0]} is at ${at(center[1], 1)}`, "0,5": `the ${center[0]} is at ${at(center[1], 0)}`,
    "1,3": `the ${kind === "mass" ? "mass" : "shear"} center is at ${at(kind === "mass" ? "mass_center" : "shear_center", 1)}`,
    "2,3": `the ${kind === "mass" ? "mass" : "shear"} center is at ${at(kind === "mass" ? "mass_center" : "shear_center", 0)}`,
    "4,5": `the principal axes are turned by ${digits(kind === "mass" ? station.inertia_angle : station.bending_angle, 4)} deg, or their center is off the reference line`,
    "1,2": "the principal axes of shear are turned",
    "0,3": "layers of one fiber angle around the section", "3,4": "fiber angles that differ between the upper and the lower side", "3,5": "fiber angles that differ between front and rear",
  };
  for (let i = 0; i < 6; i += 1) {
    for (let j = i + 1; j < 6; j += 1) {
      const part = share(matrix, i, j);
      if (part <= 0.01) continue;
      const cause = causes[`${i},${j}`];
      found.push(`${letter}${i + 1}${j + 1}, ${data.components[i]} and ${data.components[j]}: ${digits(100 * part, 3)} %${cause ? `; ${cause}` : ""}`);
    }
  }
  return found;
}
function showMatrices() {
  const station = current();
  const order = data.orders[state.order];
  byId("order-text").textContent = `Axes and order: ${order.words}; about the reference line.`;
  const made = Object.entries(MATRICES).map(([kind, { title }]) => {
    const caption = `${title} at ${labelOf(station)}, [${MATRICES[kind].units.join(", ")}], in the order of ${order.name}`;
    const one = matrixTable(station, kind, caption, order);
    listenToMatrix(one);
    return element("div", {}, one);
  });
  byId("matrix-tables").replaceChildren(...made);
  byId("entry").textContent = "\u00a0";
  const all = Object.keys(MATRICES).flatMap((kind) => couplings(station, kind));
  byId("couplings").replaceChildren(element("h3", {}, "Couplings above 1 %"),
    all.length > 0 ? element("ul", {}, ...all.map((text) => element("li", {}, text))) : element("p", {}, "none"));
}
// The components of forces, strains, momenta and velocities.
function meaningTable() {
  const unit = (kind, i) => `[${unitOf(kind, 0, i)}]`;
  const rows = data.components.map((name, i) => ({ name, i }));
  return table("Components; an entry has the unit of its row divided by the unit of its column", [
    ["component", ({ name, i }) => `${i + 1} ${name}`],
    ["row of K: internal force", ({ i }) => `${FORCES[i]} ${unit("stiffness", i)}`],
    ["column of K: generalized strain", ({ i }) => `${STRAINS[i]} ${i < 3 ? "[-]" : "[1/m]"}`],
    ["row of M: momentum per length", ({ i }) => `${MOMENTA[i]} ${i < 3 ? "[kg/s]" : "[kg m/s]"}`],
    ["column of M: velocity", ({ i }) => `${VELOCITIES[i]} ${i < 3 ? "[m/s]" : "[1/s]"}`],
  ], rows);
}
function fillPrint() {
  const parts = stations.map((station) => element("div", {},
    ...Object.entries(MATRICES).map(([kind, { title, units }]) => matrixTable(station, kind, `${title} at ${numbered(station)}, [${units.join(", ")}]`))));
  byId("print-tables").replaceChildren(meaningTable(), ...parts);
  byId("meaning").replaceChildren(meaningTable());
}
