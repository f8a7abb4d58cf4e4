// The whole page: stations, remarks, modes, and the choice of a station.

function link(index) {
  const made = element("button", { type: "button", class: "link" }, labelOf(stations[index]));
  made.addEventListener("click", () => select(index));
  return made;
}
function showStations() {
  const columns = [
    ["station", (one, i) => link(i)],
    ["arc length [m]", (one) => digits(one.arc_length)], ["chord [m]", (one) => digits(one.chord)], ["twist [deg]", (one) => digits(one.twist, 4)],
    ["mass [kg/m]", (one) => digits(one.mass[0][0])], ["EA [N]", (one) => digits(one.free_stiffness[0])],
    ["EI flap [N m\u00b2]", (one) => digits(one.bending[0])], ["EI edge [N m\u00b2]", (one) => digits(one.bending[1])], ["GJ [N m\u00b2]", (one) => digits(one.free_stiffness[3])],
    ["tension center y, z [mm]", (one) => one.tension_center.map(millimeters).join(", ")],
    ["shear center y, z [mm]", (one) => one.shear_center.map(millimeters).join(", ")],
    ["mass center y, z [mm]", (one) => one.mass_center.map(millimeters).join(", ")],
  ];
  byId("station-table").replaceChildren(table("Stations: EA and GJ with all other internal forces zero, EI about the principal axes", columns, stations, (_, i) => i === state.station));
}
// The meshes of the stations; the area of the layer that differs most from the given one.
function showQuality() {
  const worst = (i, count) => (one) => (one.picture.quality[i] === null ? "" : digits(one.picture.quality[i], count));
  const parts = (one) => one.layers.filter((layer) => layer.nominal > 0).map((layer) => [layer.meshed / layer.nominal, layer.name]);
  const farthest = (one) => parts(one).reduce((a, b) => (Math.abs(b[0] - 1) > Math.abs(a[0] - 1) ? b : a), [1, ""]);
  byId("quality-table").replaceChildren(table("Meshes of the stations: worst values of the cells", [
    ["station", (one, i) => link(i)],
    ["nodes", (one) => String(one.picture.mesh_nodes)], ["cells", (one) => String(one.picture.mesh_cells)],
    ["aspect ratio", worst(0, 3)], ["smallest corner [deg]", worst(1, 3)], ["largest corner [deg]", worst(2, 4)],
    ["least over largest Jacobian", worst(3, 3)], ["poor cells", (one) => String(one.picture.poor_cells)],
    ["area farthest from nominal", (one) => `${digits(100 * farthest(one)[0], 4)} %`], ["of the layer", (one) => farthest(one)[1]],
  ], stations));
}
const QUANTITIES = ["mass [kg/m]", "EA [N]", "EI flap [N m\u00b2]", "EI edge [N m\u00b2]", "GJ [N m\u00b2]"];
// The values of another blade beside the stations.
function showOther() {
  const { other } = data;
  byId("other-table").hidden = !other;
  if (!other) return;
  const columns = QUANTITIES.flatMap((name, i) => [
    [name, (_, k) => digits(other.values[k][0][i])],
    [`${other.name}, ${name}`, (_, k) => digits(other.values[k][1][i])],
    ["difference [%]", (_, k) => digits(100 * (other.values[k][0][i] / other.values[k][1][i] - 1), 3)],
  ]);
  byId("other-table").replaceChildren(table(`Beside ${other.name}, ${digits(other.length)} m long, at the same parts of the length: EA is K11, EI about the principal axes, GJ with all other internal forces zero`, [
    ["station", (_, i) => link(i)], ...columns,
  ], stations));
}
function markRow() {
  byId("station-table").querySelectorAll("tbody tr").forEach((row, i) => row.classList.toggle("current", i === state.station));
}
// Shows a station.
function select(index) {
  state.station = Math.max(0, Math.min(stations.length - 1, index));
  state.cell = -1;
  byId("tip").hidden = true;
  const station = current();
  byId("slider").value = String(state.station);
  byId("slider").setAttribute("aria-valuetext", numbered(station));
  byId("previous").disabled = state.station === 0;
  byId("next").disabled = state.station === stations.length - 1;
  byId("station-name").textContent = `${numbered(station)} (${state.station + 1} of ${stations.length})`;
  byId("viewer-title").textContent = `Section at ${numbered(station)}`;
  byId("station-facts").textContent = `Chord ${digits(station.chord)} m, twist ${digits(station.twist, 4)} deg, mass ${digits(station.mass[0][0])} kg/m, EA ${digits(station.free_stiffness[0])} N, EI flap ${digits(station.bending[0])} N m\u00b2, EI edge ${digits(station.bending[1])} N m\u00b2, GJ ${digits(station.free_stiffness[3])} N m\u00b2; ${station.cells.length} cells, ${station.layers.length} layers.`;
  setForce();
  showLoads();
  canvas.setAttribute("aria-label", `Drawing of the section at ${labelOf(station)}: ${station.layers.map((layer) => layer.name).join(", ")}`);
  fit();
  draw();
  showLegend();
  showExtremes();
  showLayers();
  showMatrices();
  moveLines();
  markRow();
}
function recolor(mode) {
  state.color = mode;
  byId("color").value = mode;
  draw();
  showLegend();
  showLayers();
}
function showHead() {
  const { blade } = data;
  const facts = [["length", `${digits(blade.length)} m`], ["stations", String(stations.length)]];
  if (blade.mass !== null) {
    facts.push(["mass", `${digits(blade.mass)} kg`], ["center of mass (x, y, z)", `${blade.center.map((x) => digits(x, 4)).join(", ")} m`], ["flap inertia about the root", `${digits(blade.flap_inertia)} kg m\u00b2`]);
  }
  facts.push(["program", `${blade.program} ${blade.version}`], ["inputs", blade.input_hash]);
  byId("facts").replaceChildren(...facts.map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value))));
  byId("footer").textContent = `Made by ${blade.program} ${blade.version}. ${data.reserves.length > 0 ? "Reserve factors are from section-analyzer strength." : "Without reserve factors: section-analyzer strength, then blade --report again, adds them."}`;
}
// Remarks that are not folded; on a narrow page the curves come first.
const SHOWN = window.innerWidth < 600 ? 0 : 3;
function showRemarks() {
  byId("remarks").hidden = data.remarks.length === 0;
  const indices = (names) => names.map((name) => stations.findIndex((one) => one.name === name)).filter((i) => i >= 0);
  const entry = ({ text, sections }) => element("li", {}, text, ...(sections.length > 0 ? [": ", ...indices(sections).map(link)] : []));
  const entries = data.remarks.map(entry);
  byId("remark-list").replaceChildren(...entries.slice(0, SHOWN));
  byId("remark-details").hidden = entries.length <= SHOWN;
  byId("remark-count").textContent = `${entries.length - SHOWN} ${SHOWN > 0 ? "more " : ""}remarks`;
  byId("more-remarks").replaceChildren(...entries.slice(SHOWN));
}
function showModes() {
  const { modes } = data;
  byId("modes").hidden = !modes;
  if (!modes) return;
  const speeds = [...new Set(modes.speeds)];
  const names = [...new Set(modes.names)];
  if (speeds.length > 1) {
    const at = (name, speed) => modes.frequencies[modes.names.findIndex((known, i) => known === name && modes.speeds[i] === speed)] ?? NaN;
    const curves = names.map((name) => [name, speeds.map((speed) => at(name, speed))]);
    byId("mode-plot").replaceChildren(plot({ title: "frequencies", unit: "Hz", across: "rotor speed [rpm]", x: speeds, curves, wide: { width: 640, height: 340 } }).figure);
  }
  const figures = modes.shapes.map(({ speed, image }) => {
    const picture = element("img", { alt: `Shapes of the lowest modes along the blade at ${speed} rpm` });
    picture.src = `data:image/svg+xml;base64,${image}`;
    return element("figure", {}, element("figcaption", {}, `shapes of the lowest modes at ${speed} rpm`), picture);
  });
  byId("mode-shapes").replaceChildren(...figures);
  const shown = (text) => (text !== "" && Number.isFinite(Number(text)) ? digits(Number(text)) : text);
  byId("mode-table").replaceChildren(table(`Modes of ${modes.file}`, modes.columns.map((name, j) => [name, (row) => shown(row[j])]), modes.rows));
}
function listen() {
  const slider = byId("slider");
  slider.max = String(stations.length - 1);
  slider.addEventListener("input", () => select(Number(slider.value)));
  byId("previous").addEventListener("click", () => select(state.station - 1));
  byId("next").addEventListener("click", () => select(state.station + 1));
  byId("color").replaceChildren(...Object.entries(COLORS).map(([key, { name }]) => element("option", { value: key }, name)));
  byId("color").addEventListener("change", (event) => recolor(event.target.value));
  byId("order").replaceChildren(...data.orders.map(({ name }, i) => element("option", { value: String(i) }, name)));
  byId("order").addEventListener("change", (event) => {
    state.order = Number(event.target.value);
    showMatrices();
  });
  for (const id of ["centers", "edges"]) byId(id).addEventListener("change", draw);
  byId("log").addEventListener("change", (event) => {
    state.log = event.target.checked;
    showPlots();
  });
  byId("zoom-in").addEventListener("click", () => zoom(1.4));
  byId("zoom-out").addEventListener("click", () => zoom(1 / 1.4));
  byId("fit").addEventListener("click", () => { fit(); draw(); });
  byId("show-all").addEventListener("click", () => { toggle([...layerNumbers.keys()], false); showLayers(); });
  byId("show-none").addEventListener("click", () => { toggle([...layerNumbers.keys()], true); showLayers(); });
  document.addEventListener("keydown", (event) => {
    const move = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const isFree = event.target === document.body || event.target === byId("viewer");
    if (!move || !isFree || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    select(state.station + move);
  });
  const refit = () => { if (stations.length > 0) { fit(); draw(); } };
  window.addEventListener("resize", refit);
  window.addEventListener("beforeprint", () => { for (const id of ["station-details", "remark-details"]) byId(id).open = true; refit(); });
  window.addEventListener("afterprint", refit);
  listenToCanvas();
  listenToLoads();
}
showHead();
showRemarks();
showModes();
if (stations.length > 0) {
  listen();
  showPlots();
  showStations();
  showQuality();
  showOther();
  fillPrint();
  select(0);
}
