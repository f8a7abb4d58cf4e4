// With #selftest in the address the page checks itself, and writes PASS or the failures.
(() => {
if (location.hash !== "#selftest") return;
const failures = [];
let checks = 0;
function check(isTrue, text) {
  checks += 1;
  if (!isTrue) failures.push(text);
}
window.addEventListener("error", (event) => failures.push(`error: ${event.message}`));

// Number of colored dots of the drawing.
function colored() {
  const { data: dots } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < dots.length; i += 4) {
    if (dots[i] < 245 || dots[i + 1] < 245 || dots[i + 2] < 245) count += 1;
  }
  return count;
}
function key(target, name) {
  target.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
}
// Gauss-Jordan elimination with pivots.
function inverse(matrix) {
  const n = matrix.length;
  const rows = matrix.map((row, i) => [...row, ...row.map((_, j) => (i === j ? 1 : 0))]);
  for (let k = 0; k < n; k += 1) {
    const pivot = rows.slice(k).reduce((best, row, i) => (Math.abs(row[k]) > Math.abs(rows[best][k]) ? k + i : best), k);
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    rows[k] = rows[k].map((value) => value / rows[k][k]);
    rows.forEach((row, i) => {
      if (i !== k) rows[i] = row.map((value, j) => value - row[k] * rows[k][j]);
    });
  }
  return rows.map((row) => row.slice(n));
}
// Stiffness and mass: K K^-1 = 1 in entries over the root of the diagonal, both symmetric.
function checkMatrices(station) {
  const { stiffness: k, mass: m, name } = station;
  const root = k.map((row, i) => Math.sqrt(row[i]));
  const scaled = k.map((row, i) => row.map((value, j) => value / root[i] / root[j]));
  const other = inverse(scaled);
  let worst = 0;
  scaled.forEach((row, i) => row.forEach((_, j) => {
    const product = row.reduce((sum, value, l) => sum + value * other[l][j], 0);
    worst = Math.max(worst, Math.abs(product - (i === j ? 1 : 0)));
  }));
  check(worst < 1e-9, `${name}: K times its inverse is off by ${worst}`);
  for (const matrix of [k, m]) {
    check(matrix.every((row, i) => row.every((value, j) => value === matrix[j][i])), `${name}: a matrix is not symmetric`);
  }
  data.orders.forEach((order, i) => {
    byId("order").value = String(i);
    byId("order").dispatchEvent(new Event("change"));
    const shown = [...byId("matrix-tables").querySelectorAll("td[data-row]")];
    check(shown.length === 72, `${name}: ${shown.length} entries of matrices`);
    check(shown.every((cell) => {
      const { kind, row, column } = cell.dataset;
      const [p, q] = [Number(row), Number(column)];
      const value = order.sign[p] * order.sign[q] * station[kind][order.index[p]][order.index[q]];
      return Math.abs(Number(cell.textContent) - value) <= 1e-4 * Math.abs(value);
    }), `${name}: shown entries differ from the data in the order of ${order.name}`);
    // the axial stiffness is where each program has it
    const axial = { Helicoid: 0, VABS: 0, BeamDyn: 2, HAWC2: 2 }[order.name];
    check(inOrder(k, order)[axial][axial] === k[0][0], `${name}: EA is not entry ${axial + 1} of ${order.name}`);
  });
  byId("order").value = "0";
  byId("order").dispatchEvent(new Event("change"));
}
// Layers with cells: one that is cut as a whole has none.
const drawn = (station) => station.layers.filter((layer) => layer.meshed > 0);
// Cells in the whole section are found at their middles; mitred ones may be slivers.
function checkPicking(station) {
  const { cells, name } = station;
  check(cells.length === station.picture.mesh_cells, `${name}: ${cells.length} cells are drawn, the mesh has ${station.picture.mesh_cells}`);
  const step = Math.max(1, Math.floor(cells.length / 50));
  for (let k = 0; k < cells.length; k += step) {
    const found = pick(cells[k].middle);
    check(found >= 0 && cells[found].layer === cells[k].layer, `${name}: cell ${k} is not found at its middle`);
  }
  const names = new Set(cells.map((cell) => cell.layer));
  const layers = drawn(station);
  check(layers.every((layer) => names.has(layer.name)) && names.size === layers.length, `${name}: layers of the table and of the cells differ`);
}
// Areas of layers against their cells with straight sides, mass against the mass matrix.
function checkAreas(station) {
  const [areas, rounded] = [new Map(), new Map()];
  for (const cell of station.cells) {
    const { points, layer } = cell;
    const sides = points.map((a, i) => Math.hypot(a[0] - points[(i + 1) % 4][0], a[1] - points[(i + 1) % 4][1]));
    areas.set(layer, (areas.get(layer) ?? 0) + area(points));
    // corners are drawn at whole steps
    rounded.set(layer, (rounded.get(layer) ?? 0) + station.picture.step * Math.max(...sides));
  }
  for (const { name, meshed } of drawn(station)) {
    check(Math.abs(areas.get(name) - meshed) < 0.02 * meshed + rounded.get(name), `${station.name}: area of ${name} is ${areas.get(name)}, expected ${meshed}`);
  }
  const mass = layerRows().reduce((sum, row) => sum + row.mass, 0);
  check(Math.abs(mass / station.mass[0][0] - 1) < 2e-3, `${station.name}: masses of the layers are ${mass}, expected ${station.mass[0][0]}`);
}
// The widest cell of each layer is filled with its color.
function checkColors(station) {
  const pen = canvas.getContext("2d");
  const dots = canvas.width / canvas.clientWidth;
  const width = ({ points }) => {
    const sides = points.map((a, i) => Math.hypot(a[0] - points[(i + 1) % 4][0], a[1] - points[(i + 1) % 4][1]));
    return (area(points) / Math.max(...sides)) * state.view.scale;
  };
  for (const { name } of drawn(station)) {
    const cells = station.cells.filter((cell) => cell.layer === name);
    const widest = cells.reduce((best, cell) => (width(cell) > width(best) ? cell : best));
    if (width(widest) < 3) continue;
    const found = pen.getImageData(...toPixels(widest.middle).map((x) => Math.round(x * dots)), 1, 1).data;
    const expected = document.createElement("canvas").getContext("2d");
    expected.fillStyle = COLORS.layer.of(widest);
    expected.fillRect(0, 0, 1, 1);
    const color = expected.getImageData(0, 0, 1, 1).data;
    check(found.every((value, i) => Math.abs(value - color[i]) < 4), `${station.name}: ${name} has the color ${found}, expected ${color}`);
  }
}
// Hidden layers are not drawn, colors change the drawing.
function checkLayers(station) {
  byId("centers").checked = false;
  recolor("layer");
  const all = colored();
  check(all > 500, `${station.name}: ${all} colored dots`);
  checkColors(station);
  for (const box of byId("layer-table").querySelectorAll("input")) {
    box.checked = false;
    box.dispatchEvent(new Event("change"));
    check(state.hidden.has(box.dataset.layer), `${station.name}: ${box.dataset.layer} is not hidden`);
  }
  const none = colored();
  check(none < 0.5 * all, `${station.name}: ${none} colored dots of ${all} without layers`);
  byId("show-all").click();
  check(colored() === all, `${station.name}: another drawing with all layers again`);
  for (const mode of Object.keys(COLORS)) {
    recolor(mode);
    check(byId("legend").textContent.length > 10, `${station.name}: no legend of ${mode}`);
  }
  recolor("layer");
  byId("centers").checked = true;
  select(state.station);
  check(colored() > all, `${station.name}: centers are not drawn`);
}
function checkKeys() {
  select(0);
  key(document.body, "ArrowRight");
  check(state.station === Math.min(1, stations.length - 1), "the right arrow does not select the next station");
  key(document.body, "ArrowLeft");
  check(state.station === 0, "the left arrow does not select the station before");
  byId("next").click();
  byId("slider").value = "0";
  byId("slider").dispatchEvent(new Event("input"));
  check(state.station === 0, "the slider does not select a station");
  canvas.focus();
  key(canvas, "ArrowRight");
  check(state.cell >= 0 && !byId("tip").hidden, "the keyboard does not select a cell");
  const { layer } = stations[0].cells[state.cell];
  check(byId("spoken").textContent.includes(`layer ${layer}`), "the cell is not spoken");
  key(canvas, "ArrowDown");
  const plies = stations[0].picture.plies.length;
  check(plies === 1 || stations[0].cells[state.cell].ply !== stations[0].picture.plies[0], "the down arrow does not go to the next ply");
  const { scale } = state.view;
  key(canvas, "+");
  check(state.view.scale > scale, "plus does not zoom");
  key(canvas, "0");
  check(Math.abs(state.view.scale / scale - 1) < 1e-9, "0 does not show the whole section");
  key(canvas, "Escape");
  check(byId("tip").hidden, "Escape does not end");
  const first = byId("matrix-tables").querySelector("td[data-row]");
  first.focus();
  key(first, "ArrowRight");
  check(document.activeElement.dataset.column === "1", "arrows do not move in the matrix");
  check(byId("entry").textContent.startsWith("K12: axial force per shear strain y [N]: "), "the meaning of an entry is not shown");
}
// Names and descriptions for screen readers.
function checkAccess() {
  for (const one of document.querySelectorAll("button, input, select, canvas")) {
    const label = one.getAttribute("aria-label") || one.textContent || (one.labels && one.labels.length > 0 && one.labels[0].textContent);
    check(label, `a control without a name: ${one.outerHTML}`);
  }
  for (const one of document.querySelectorAll("table")) {
    check(one.caption && one.caption.textContent, "a table without a caption");
    check([...one.querySelectorAll("th")].every((head) => head.scope), "a heading of a table without its scope");
  }
  for (const one of document.querySelectorAll("svg")) check(one.getAttribute("aria-label"), "a curve without a description");
  const ids = [...document.querySelectorAll("[id]")].map((one) => one.id);
  check(new Set(ids).size === ids.length, "an id is used twice");
  check(byId("print-tables").querySelectorAll("table").length === 2 * stations.length + 1, "tables for printing are missing");
  const curves = byId("plots").querySelectorAll("polyline");
  check([...curves].every((one) => one.getAttribute("points").split(" ").length === stations.length || data.reserves.length > 0), "a curve without all stations");
  check(curves.length >= 14, `${curves.length} curves`);
}
// Shapes of modes are pictures with a description; another blade has a curve in each plot of its quantities.
function checkBeside() {
  const pictures = [...byId("mode-shapes").querySelectorAll("img")];
  check(pictures.length === (data.modes ? data.modes.shapes.length : 0), `${pictures.length} pictures of shapes`);
  check(pictures.every((one) => one.src.startsWith("data:image/svg+xml;base64,") && one.alt.includes("rpm")), "a picture of shapes without content or description");
  if (!data.other) return;
  const labels = [...byId("plots").querySelectorAll("svg")].map((one) => one.getAttribute("aria-label"));
  for (const title of ["mass", "EA", "EI", "GJ"]) {
    const found = labels.find((text) => text.startsWith(`${title} [`));
    check(found && found.includes(data.other.name), `no curve of ${data.other.name} in the plot of ${title}`);
  }
}
try {
  stations.forEach((_, i) => {
    select(i);
    checkMatrices(stations[i]);
    checkPicking(stations[i]);
    checkAreas(stations[i]);
    checkLayers(stations[i]);
    checkStresses(check, stations[i]);
  });
  checkSamples(check, data.samples ?? []);
  checkKeys();
  checkAccess();
  checkBeside();
} catch (error) {
  failures.push(`error: ${error.message}`);
}
const text = failures.length === 0 ? `PASS ${checks}` : `FAIL ${failures.length} of ${checks}\n${failures.join("\n")}`;
byId("selftest").hidden = false;
byId("selftest").textContent = text;
document.title = text.split("\n")[0];
})();
