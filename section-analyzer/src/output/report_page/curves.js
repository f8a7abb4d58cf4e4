// Curves over the span and over the rotor speed, as SVG.

const space = document.createElement("template");
space.innerHTML = "<svg></svg>";
const SVG = space.content.firstChild.namespaceURI;
function shape(name, attributes, ...content) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...content);
  return made;
}
function ticks(from, to, most) {
  const raw = (to - from) / most || 1;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((part) => part * power >= raw * (1 - 1e-9));
  const found = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; i += 1) found.push(i * step);
  return found;
}
const LINES = [["#0b5cad", ""], ["#b2182b", "7 3"], ["#1b7837", "2 3"], ["#7a4a00", "8 3 2 3"]];
const PLOT = { width: 340, height: 200, left: 62, right: 10, top: 8, bottom: 34 };
// Curves are [name, values over x]; null values are left out.
function plot({ title, unit, across, x, curves, wide }) {
  const size = { ...PLOT, ...wide };
  const all = curves.flatMap(([, values]) => values).filter((value) => Number.isFinite(value));
  const isLog = state.log && all.every((value) => value > 0);
  const f = isLog ? Math.log10 : (value) => value;
  let [low, high] = [Math.min(...all.map(f)), Math.max(...all.map(f))];
  if (!isLog && low > 0 && low < 0.7 * high) low = 0;
  const margin = 0.05 * (high - low) || 0.05 * Math.abs(high) || 1;
  [low, high] = [low === 0 ? 0 : low - margin, high + margin];
  const [from, to] = [Math.min(...x), Math.max(...x)];
  const px = (value) => size.left + ((value - from) / (to - from || 1)) * (size.width - size.left - size.right);
  const py = (value) => size.height - size.bottom - ((f(value) - low) / (high - low)) * (size.height - size.top - size.bottom);
  const grid = [];
  const marks = isLog ? ticks(low, high, 4).map((power) => 10 ** power) : ticks(low, high, 4);
  for (const value of marks) {
    grid.push(shape("line", { x1: size.left, x2: size.width - size.right, y1: py(value), y2: py(value), stroke: "#e2e6ea" }));
    grid.push(shape("text", { x: size.left - 5, y: py(value) + 4, "text-anchor": "end" }, digits(Math.abs(value) < 1e-9 * (high - low) && !isLog ? 0 : value, 3)));
  }
  for (const value of ticks(from, to, 6)) {
    grid.push(shape("text", { x: px(value), y: size.height - size.bottom + 15, "text-anchor": "middle" }, digits(value, 4)));
  }
  grid.push(shape("text", { x: (size.left + size.width) / 2, y: size.height - 4, "text-anchor": "middle" }, across));
  grid.push(shape("rect", { x: size.left, y: size.top, width: size.width - size.left - size.right, height: size.height - size.top - size.bottom, fill: "none", stroke: "#8a949e" }));
  curves.forEach(([, values], i) => {
    const [color, dash] = LINES[i % LINES.length];
    const points = values.map((value, k) => [value, x[k]]).filter(([value]) => Number.isFinite(value)).map(([value, at]) => [px(at), py(value)]);
    grid.push(shape("polyline", { points: points.map((point) => point.map((c) => c.toFixed(1)).join(",")).join(" "), fill: "none", stroke: color, "stroke-width": 1.8, "stroke-dasharray": dash }));
    points.forEach(([cx, cy]) => grid.push(shape("circle", { cx, cy, r: 2, fill: color })));
  });
  const ends = curves.map(([name, values]) => `${name || title} from ${digits(values[0], 4)} to ${digits(values[values.length - 1], 4)}`);
  const picture = shape("svg", { viewBox: `0 0 ${size.width} ${size.height}`, role: "img", "aria-label": `${title} [${unit}] over ${across}: ${ends.join("; ")}` }, ...grid);
  const names = curves.length > 1 && curves.length <= LINES.length ? curves.map(([name], i) => `${name} ${["solid", "dashed", "dotted", "dash-dotted"][i]}`).join(", ") : "";
  return { figure: element("figure", {}, element("figcaption", {}, `${title} [${unit}]${names ? `: ${names}` : ""}`), picture), picture, px, size, from, to };
}
function spanPlots() {
  const values = (value) => stations.map(value);
  const x = values((one) => one.arc_length);
  const across = "arc length from the root [m]";
  const centers = (axis) => CENTERS.map(([name, key]) => [name, values((one) => one[key][axis])]);
  // the curve of a quantity of another blade
  const beside = (name, number) => (data.other ? [[`${data.other.name}${name}`, data.other.values.map(([, others]) => others[number])]] : []);
  const own = data.other ? data.blade.name : "";
  const all = [
    ["mass", "kg/m", [[own, values((one) => one.mass[0][0])], ...beside("", 0)]],
    ["EA", "N", data.other ? [[own, data.other.values.map(([numbers]) => numbers[1])], ...beside("", 1)] : [["", values((one) => one.free_stiffness[0])]]],
    ["EI", "N m\u00b2", [["flap", values((one) => one.bending[0])], ["edge", values((one) => one.bending[1])], ...beside(" flap", 2), ...beside(" edge", 3)]],
    ["GJ", "N m\u00b2", [[own, values((one) => one.free_stiffness[3])], ...beside("", 4)]],
    ["GA", "N", [["along y", values((one) => one.free_stiffness[1])], ["along z", values((one) => one.free_stiffness[2])]]],
    ["centers, y", "m", centers(0)],
    ["centers, z", "m", centers(1)],
    ["angle of the principal axes with twist", "deg", [["", values((one) => one.twist + one.bending_angle)]]],
    ["chord", "m", [["", values((one) => one.chord)]]],
  ];
  if (data.reserves.length > 0) {
    const least = (one) => Math.min(Infinity, ...data.reserves.filter((row) => row.section === one.name && row.reserve_factor !== null).map((row) => row.reserve_factor));
    all.push(["smallest reserve factor", "-", [["", values(least)]]]);
  }
  return all.map(([title, unit, curves]) => plot({ title, unit, across, x, curves }));
}
let drawnPlots = [];
function showPlots() {
  drawnPlots = spanPlots();
  for (const one of drawnPlots) {
    one.line = shape("line", { y1: one.size.top, y2: one.size.height - one.size.bottom, stroke: "#1c2733", "stroke-width": 1, "stroke-dasharray": "3 2" });
    one.picture.append(one.line);
    one.picture.addEventListener("click", (event) => {
      const frame = one.picture.getBoundingClientRect();
      const at = ((event.clientX - frame.left) / frame.width) * one.size.width;
      const distance = (station) => Math.abs(one.px(station.arc_length) - at);
      select(stations.reduce((best, station, i) => (distance(station) < distance(stations[best]) ? i : best), 0));
    });
  }
  byId("plots").replaceChildren(...drawnPlots.map((one) => one.figure));
  moveLines();
}
function moveLines() {
  for (const one of drawnPlots) {
    const x = one.px(stations[state.station].arc_length);
    one.line.setAttribute("x1", x);
    one.line.setAttribute("x2", x);
  }
}
