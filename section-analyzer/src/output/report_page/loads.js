// The internal force under which the stresses of a section are shown.

const UNITS = ["N", "N", "N", "N m", "N m", "N m"];
// The instants that govern plies of a station, the smallest reserve factor first.
function instantsOf(station) {
  const rows = data.reserves.filter((row) => row.section === station.name);
  rows.sort((a, b) => (a.reserve_factor ?? Infinity) - (b.reserve_factor ?? Infinity));
  const found = new Map();
  for (const row of rows) if (!found.has(row.instant)) found.set(row.instant, row);
  return [...found.values()];
}
function loadName() {
  const { kind, value } = state.load;
  if (kind === "instant") return value;
  if (kind === "unit") return `${data.components[value]} 1 ${UNITS[value]}`;
  const parts = state.force.map((part, i) => (part === 0 ? "" : `${data.components[i]} ${digits(part)} ${UNITS[i]}`));
  return parts.filter((part) => part).join(", ") || "no load";
}
// The force of the chosen load at the current station.
function setForce() {
  const instants = instantsOf(current());
  if (state.load.kind === "instant") {
    const known = instants.find((row) => row.instant === state.load.value) ?? instants[0];
    state.load = known ? { kind: "instant", value: known.instant } : { kind: "unit", value: 4 };
    if (known) state.force = [...known.force];
  }
  if (state.load.kind === "unit") state.force = data.components.map((_, i) => (i === state.load.value ? 1 : 0));
}
function showLoads() {
  const option = (value, text) => element("option", { value }, text);
  const instants = instantsOf(current());
  const groups = [];
  if (instants.length > 0) {
    groups.push(element("optgroup", { label: "governing instants of strength" },
      ...instants.map((row) => option(`instant/${row.instant}`, `${row.instant}: reserve factor ${digits(row.reserve_factor, 4)} of ${row.ply}`))));
  }
  groups.push(element("optgroup", { label: "unit loads" }, ...data.components.map((name, i) => option(`unit/${i}`, `${name}, 1 ${UNITS[i]}`))));
  groups.push(option("typed/", "as typed"));
  byId("load").replaceChildren(...groups);
  byId("load").value = `${state.load.kind}/${state.load.value}`;
  state.force.forEach((value, i) => {
    const field = byId(`force-${i}`);
    if (field !== document.activeElement) field.value = String(Number(value.toPrecision(7)));
  });
  const shown = state.force.map((value, i) => `${data.components[i]} ${digits(value)} ${UNITS[i]}`).join(", ");
  byId("load-text").textContent = `Internal force at ${labelOf(current())}, at the origin: ${shown}.`;
}
// Shows the stresses under another load.
function load(chosen, force) {
  state.load = chosen;
  if (force) state.force = force;
  setForce();
  showLoads();
  refresh();
  byId("spoken").textContent = `Stresses under ${loadName()}`;
}
// Drawing, legend and tables of the stresses.
function refresh() {
  if (COLORS[state.color].isUnderLoad) showLegend();
  showExtremes();
  point(state.cell, false);
}
function listenToLoads() {
  const fields = data.components.map((name, i) => {
    const field = element("input", { type: "number", step: "any", id: `force-${i}` });
    field.addEventListener("input", () => load({ kind: "typed", value: "" }, state.force.map((old, j) => (j === i ? Number(field.value) || 0 : old))));
    return element("label", {}, `${name} [${UNITS[i]}] `, field);
  });
  byId("forces").replaceChildren(...fields);
  byId("load").addEventListener("change", (event) => {
    const [kind, ...rest] = event.target.value.split("/");
    const value = rest.join("/");
    load({ kind, value: kind === "unit" ? Number(value) : value });
  });
}
