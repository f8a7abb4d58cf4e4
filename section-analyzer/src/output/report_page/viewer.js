// The drawing of a section, and cells under the pointer and by the keyboard.

const canvas = byId("canvas");
function fit() {
  const { box } = current();
  const size = box.map(([from, to]) => to - from);
  const frame = [canvas.clientWidth || 600, canvas.clientHeight || 400];
  const scale = Math.min((frame[0] - 60) / size[0], (frame[1] - 60) / size[1]);
  state.view = { scale, middle: box.map(([from, to]) => (from + to) / 2) };
}
function toPixels([y, z]) {
  const { scale, middle } = state.view;
  return [canvas.clientWidth / 2 + scale * (y - middle[0]), canvas.clientHeight / 2 - scale * (z - middle[1])];
}
function toPoint([x, y]) {
  const { scale, middle } = state.view;
  return [middle[0] + (x - canvas.clientWidth / 2) / scale, middle[1] - (y - canvas.clientHeight / 2) / scale];
}
function zoom(factor, at = [canvas.clientWidth / 2, canvas.clientHeight / 2]) {
  const before = toPoint(at);
  state.view.scale *= factor;
  const after = toPoint(at);
  state.view.middle = state.view.middle.map((x, axis) => x + before[axis] - after[axis]);
  draw();
}
function outline(pen, points) {
  points.forEach((point, i) => {
    const [x, y] = toPixels(point);
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
  pen.closePath();
}
function draw() {
  const [width, height] = [canvas.clientWidth || 600, canvas.clientHeight || 400];
  const dots = Math.max(2, window.devicePixelRatio || 1);
  canvas.width = width * dots;
  canvas.height = height * dots;
  const pen = canvas.getContext("2d");
  pen.setTransform(dots, 0, 0, dots, 0, 0);
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, width, height);
  pen.lineJoin = "round";
  const station = current();
  const color = COLORS[state.color].of;
  const paths = new Map();
  for (const cell of station.cells.filter(isShown)) {
    const key = color(cell);
    if (!paths.has(key)) paths.set(key, []);
    paths.get(key).push(cell.points);
  }
  // light colors are bordered
  pen.beginPath();
  for (const cells of paths.values()) cells.forEach((points) => outline(pen, points));
  pen.strokeStyle = "#76828e";
  pen.lineWidth = 2.2;
  pen.stroke();
  for (const [key, cells] of paths) {
    pen.beginPath();
    cells.forEach((points) => outline(pen, points));
    pen.fillStyle = key;
    pen.strokeStyle = key;
    pen.lineWidth = 0.7;
    pen.fill();
    pen.stroke();
  }
  if (byId("edges").checked) {
    pen.beginPath();
    station.cells.filter(isShown).forEach((cell) => outline(pen, cell.points));
    pen.strokeStyle = "#0008";
    pen.lineWidth = 0.4;
    pen.stroke();
  }
  if (byId("centers").checked) drawCenters(pen, station);
  drawScale(pen, width, height);
  if (state.cell >= 0 && isShown(station.cells[state.cell])) {
    pen.beginPath();
    outline(pen, station.cells[state.cell].points);
    pen.strokeStyle = "#000";
    pen.lineWidth = 2.5;
    pen.stroke();
  }
}
const CENTERS = [["tension center", "tension_center", "T"], ["shear center", "shear_center", "S"], ["mass center", "mass_center", "M"]];
function drawCenters(pen, station) {
  const size = Math.max(...station.box.map(([from, to]) => to - from));
  const angle = (station.bending_angle * Math.PI) / 180;
  const center = station.tension_center;
  pen.strokeStyle = "#444";
  pen.lineWidth = 1;
  pen.setLineDash([8, 4]);
  for (const [c, s] of [[Math.cos(angle), Math.sin(angle)], [-Math.sin(angle), Math.cos(angle)]]) {
    pen.beginPath();
    pen.moveTo(...toPixels([center[0] - 0.55 * size * c, center[1] - 0.55 * size * s]));
    pen.lineTo(...toPixels([center[0] + 0.55 * size * c, center[1] + 0.55 * size * s]));
    pen.stroke();
  }
  pen.setLineDash([]);
  mark(pen, [0, 0], "O", "#000", 0);
  CENTERS.forEach(([, key, letter], i) => mark(pen, station[key], letter, ["#b2182b", "#2166ac", "#1b7837"][i], i + 1));
}
// Letters stand in different directions, since the centers are near each other.
function mark(pen, point, letter, color, direction) {
  const [x, y] = toPixels(point);
  const [dx, dy] = [[-15, 13], [13, -13], [13, 13], [-15, -13]][direction];
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + 0.7 * dx, y + 0.7 * dy);
  pen.strokeStyle = color;
  pen.lineWidth = 1.2;
  pen.stroke();
  pen.beginPath();
  pen.arc(x, y, 3.5, 0, 7);
  pen.fillStyle = color;
  pen.fill();
  pen.font = "bold 13px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineWidth = 3;
  pen.strokeStyle = "#fff";
  pen.strokeText(letter, x + 1.1 * dx, y + 1.1 * dy);
  pen.fillText(letter, x + 1.1 * dx, y + 1.1 * dy);
}
function drawScale(pen, width, height) {
  const raw = 120 / state.view.scale;
  const power = 10 ** Math.floor(Math.log10(raw));
  const length = power * ([5, 2, 1].find((part) => part * power <= raw) ?? 1);
  const [left, base] = [14, height - 14];
  pen.strokeStyle = "#1c2733";
  pen.fillStyle = "#1c2733";
  pen.lineWidth = 2;
  pen.beginPath();
  pen.moveTo(left, base);
  pen.lineTo(left + length * state.view.scale, base);
  pen.stroke();
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "left";
  pen.textBaseline = "bottom";
  pen.fillText(length >= 1 ? `${digits(length)} m` : `${millimeters(length)} mm`, left, base - 4);
  pen.lineWidth = 1.5;
  const [x, y] = [width - 60, height - 16];
  for (const [dx, dy, name] of [[30, 0, "y"], [0, -30, "z"]]) {
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + dx, y + dy);
    const [tx, ty] = [x + dx, y + dy];
    pen.moveTo(tx - dx / 5 - dy / 8, ty - dy / 5 - dx / 8);
    pen.lineTo(tx, ty);
    pen.lineTo(tx - dx / 5 + dy / 8, ty - dy / 5 + dx / 8);
    pen.stroke();
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillText(name, x + 1.35 * dx, y + 1.35 * dy);
  }
}



function describe(cell) {
  const { ply } = cell;
  const lines = [`layer ${cell.layer}`];
  if (ply.ply !== cell.layer) lines.push(`ply ${ply.ply}`);
  lines.push(`material ${ply.material}`);
  lines.push(ply.fiber_angle === null ? "isotropic" : `fiber angle ${digits(ply.fiber_angle)} deg`);
  lines.push(`wall direction ${digits(cell.plane)} deg`);
  if (cell.thickness !== null) lines.push(`thickness ${millimeters(cell.thickness)} mm, arcs ${cell.arcs.map((arc) => digits(arc, 4)).join(" to ")}`);
  lines.push(`y ${millimeters(cell.middle[0])} mm, z ${millimeters(cell.middle[1])} mm`);
  const row = reserveOf(cell.station, ply);
  lines.push(...describeStress(cell));
  if (row) lines.push(`of the ply over all loads: failure index ${digits(row.failure_index, 4)}, reserve factor ${digits(row.reserve_factor, 4)} (${criterionName(row.criterion)}, ${row.mode}, ${row.instant})`);
  return lines;
}
function point(number, spoken) {
  state.cell = number;
  const tip = byId("tip");
  tip.hidden = number < 0;
  canvas.dataset.cell = String(number);
  if (number >= 0) {
    const lines = describe(current().cells[number]);
    tip.textContent = lines.join("\n");
    const [x, y] = toPixels(current().cells[number].middle);
    tip.style.left = `${Math.max(0, Math.min(x + 14, canvas.clientWidth - tip.offsetWidth - 4))}px`;
    tip.style.top = `${y + 16 + tip.offsetHeight > canvas.clientHeight ? Math.max(0, y - 16 - tip.offsetHeight) : y + 16}px`;
    if (spoken) byId("spoken").textContent = lines.join(", ");
  }
  draw();
}
// A visible cell: the next one along its ply, or the nearest one of the next ply.
function step(along, across) {
  const { cells, picture } = current();
  const shown = picture.plies.filter((ply) => cells.some((cell) => cell.ply === ply && isShown(cell)));
  if (shown.length === 0) return;
  const cell = cells[state.cell];
  if (!cell || !isShown(cell)) {
    point(cells.findIndex((one) => one.ply === shown[0]), true);
    return;
  }
  const ofPly = (ply) => cells.map((one, k) => k).filter((k) => cells[k].ply === ply);
  if (along !== 0) {
    const own = ofPly(cell.ply);
    point(own[(own.indexOf(state.cell) + along + own.length) % own.length], true);
    return;
  }
  const ply = shown[(shown.indexOf(cell.ply) + across + shown.length) % shown.length];
  const distance = (k) => Math.hypot(cells[k].middle[0] - cell.middle[0], cells[k].middle[1] - cell.middle[1]);
  point(ofPly(ply).reduce((best, k) => (distance(k) < distance(best) ? k : best)), true);
}
function listenToCanvas() {
  const place = (event) => {
    const frame = canvas.getBoundingClientRect();
    return [event.clientX - frame.left, event.clientY - frame.top];
  };
  const pointers = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, place(event));
    point(pick(toPoint(place(event))), false);
  });
  canvas.addEventListener("pointermove", (event) => {
    const now = place(event);
    const before = pointers.get(event.pointerId);
    if (!before) {
      const found = pick(toPoint(now));
      if (found !== state.cell) point(found, false);
      return;
    }
    const others = [...pointers].filter(([id]) => id !== event.pointerId);
    pointers.set(event.pointerId, now);
    if (others.length > 0) {
      const [, other] = others[0];
      const distance = (a) => Math.hypot(a[0] - other[0], a[1] - other[1]) || 1;
      zoom(distance(now) / distance(before), other);
      return;
    }
    const { view } = state;
    view.middle = [view.middle[0] - (now[0] - before[0]) / view.scale, view.middle[1] + (now[1] - before[1]) / view.scale];
    draw();
  });
  for (const name of ["pointerup", "pointercancel", "pointerleave"]) {
    canvas.addEventListener(name, (event) => {
      pointers.delete(event.pointerId);
      if (name === "pointerleave" && event.pointerType === "mouse" && document.activeElement !== canvas) point(-1, false);
    });
  }
  canvas.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && document.activeElement !== canvas) return;
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 400), place(event));
  }, { passive: false });
  const keys = {
    ArrowRight: () => step(1, 0), ArrowLeft: () => step(-1, 0), ArrowDown: () => step(0, 1), ArrowUp: () => step(0, -1),
    "+": () => zoom(1.4), "=": () => zoom(1.4), "-": () => zoom(1 / 1.4), 0: () => { fit(); draw(); }, Escape: () => point(-1, true),
  };
  canvas.addEventListener("keydown", (event) => {
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  });
}
