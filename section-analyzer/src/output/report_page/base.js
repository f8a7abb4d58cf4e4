"use strict";
// The data of the page, its state, texts, tables and colors.

const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
const stations = data.stations;
const state = { station: 0, color: "layer", hidden: new Set(), view: null, cell: -1, log: false, order: 0,
  load: { kind: "instant", value: "" }, force: [0, 0, 0, 0, 1, 0] };


function element(name, attributes = {}, ...content) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...content);
  return made;
}
function digits(value, count = 5) {
  if (value === null || !Number.isFinite(value)) return "none";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return String(Number(value.toPrecision(count)));
  const [mantissa, power] = value.toExponential(count - 1).split("e");
  return `${Number(mantissa)}e${Number(power)}`;
}
const millimeters = (value) => digits(value * 1e3, 4);
function labelOf(station) {
  const side = /_(inner|outer)$/.exec(station.name);
  return `eta ${digits(station.eta)}${side ? ` ${side[1]}` : ""}`;
}
function numbered(station) {
  return `${labelOf(station)}, ${digits(station.arc_length)} m`;
}
// Columns are [heading, function of a row]; the first one heads its row.
function table(caption, columns, rows, mark) {
  const head = element("tr", {}, ...columns.map(([name]) => element("th", { scope: "col" }, name)));
  const body = rows.map((row, i) => {
    const cells = columns.map(([, value], j) => {
      const content = value(row, i);
      if (j === 0) return element("th", { scope: "row" }, content);
      const isText = typeof content !== "string" || !/^[-+\d]/.test(content);
      return element("td", isText ? { class: "text" } : {}, content);
    });
    return element("tr", mark && mark(row, i) ? { class: "current" } : {}, ...cells);
  });
  return element("table", {}, element("caption", {}, caption),
    element("thead", {}, head), element("tbody", {}, ...body));
}



const PALETTE = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#999933",
  "#ee7733", "#33bbaa", "#882255", "#88aadd", "#bb9977", "#117733", "#ddaacc"];
// Names of one kind in the order in which the stations have them.
function ordered(names) {
  return new Map([...new Set(names)].map((name, i) => [name, i]));
}
const layerNumbers = ordered(stations.flatMap((one) => one.layers.map((layer) => layer.name)));
const materialNumbers = ordered(stations.flatMap((one) => one.layers.map((layer) => layer.material)));
function numberedColor(number) {
  const turn = Math.floor(number / PALETTE.length);
  if (turn === 0) return PALETTE[number];
  return `hsl(${(number * 137.5) % 360} 55% ${45 + 12 * (turn % 3)}%)`;
}
function mixed(a, b, part) {
  return `rgb(${a.map((x, i) => Math.round(x + (b[i] - x) * part)).join(" ")})`;
}
const BLUE = [33, 102, 172], WHITE = [247, 247, 247], RED = [178, 24, 43], YELLOW = [255, 237, 160];
const PLAIN = "#b8c0c8";
const diverging = (t) => mixed(WHITE, t < 0 ? BLUE : RED, Math.min(1, Math.abs(t)));
const sequential = (t) => (t < 0.5 ? mixed(WHITE, YELLOW, 2 * t) : mixed(YELLOW, RED, Math.min(1, 2 * t - 1)));
const cyclic = (degrees) => `hsl(${(2 * degrees + 720) % 360} 65% 60%)`;

const reserves = new Map(data.reserves.map((row) => [`${row.section}/${row.ply}`, row]));
const criterionName = (key) => ({ tsai_wu: "Tsai-Wu", hashin: "Hashin", von_mises: "von Mises" })[key] ?? key.replace("_", " ");
const reserveOf = (station, ply) => reserves.get(`${station.name}/${ply.ply}`);
const largestIndex = Math.max(1e-30, ...data.reserves.map((row) => row.failure_index));
const angles = stations.flatMap((one) => one.picture.plies.map((ply) => Math.abs(lineAngle(ply.fiber_angle ?? 0))));
const largestAngle = [15, 30, 60, 90].find((end) => Math.max(0, ...angles) <= end + 1e-6) ?? 90;

// The angle of a line, from -90 to 90 degrees.
function lineAngle(angle) {
  const turned = angle - 180 * Math.round(angle / 180);
  return turned < -90 + 1e-6 ? 90 : turned;
}
const COLORS = {
  layer: { name: "layer", of: (cell) => numberedColor(layerNumbers.get(cell.layer)) },
  material: { name: "material", of: (cell) => numberedColor(materialNumbers.get(cell.ply.material)) },
  fiber: {
    name: "fiber angle",
    of: ({ ply }) => (ply.fiber_angle === null ? PLAIN : diverging(lineAngle(ply.fiber_angle) / largestAngle)),
    bar: [-largestAngle, largestAngle, "deg, fiber angle from x toward the wall direction; gray: isotropic", (t) => diverging(2 * t - 1)],
  },
  plane: {
    name: "wall direction",
    isOfCell: true,
    of: (cell) => cyclic(cell.plane),
    bar: [0, 180, "deg, wall direction from y toward z", (t) => cyclic(180 * t)],
  },
};
if (data.reserves.length > 0) {
  COLORS.failure = {
    name: "largest failure index of the ply",
    of: ({ ply, station }) => {
      const row = reserveOf(station, ply);
      return row ? sequential(row.failure_index / largestIndex) : PLAIN;
    },
    bar: [0, largestIndex, "largest failure index of the ply over all loads; gray: none", sequential],
  };
}
