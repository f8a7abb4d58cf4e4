// Checks of the stresses, of the page itself and against samples that its program has computed.

// Internal force of the stresses of a section, from means of its cells, and the sums of their sizes.
function resultantOf(station) {
  const units = unitStresses(station);
  const [sums, sizes] = [[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]];
  station.cells.forEach((cell, k) => {
    const { points, middle } = cell;
    const size = Math.abs(area(points));
    const [x, y, z] = onSection(cell, superposed(units[k], state.force)).map((stress) => size * stress);
    const terms = [[x], [y], [z], [middle[0] * z, -middle[1] * y], [middle[1] * x], [-middle[0] * x]];
    terms.forEach((parts, i) => parts.forEach((part) => {
      sums[i] += part;
      sizes[i] += Math.abs(part);
    }));
  });
  return { sums, sizes };
}
// Under each unit load the stresses add up to it, to the areas of cells with straight sides.
// Means of cells omit the moment of the stress about the middle of each cell, which is a tenth
// for webs of few tall cells.
function checkResultants(check, station) {
  data.components.forEach((name, i) => {
    load({ kind: "unit", value: i });
    const { sums, sizes } = resultantOf(station);
    sums.forEach((sum, j) => {
      const expected = i === j ? 1 : 0;
      check(Math.abs(sum - expected) <= (j < 3 ? 0.01 : 0.2) * sizes[j] + 1e-3, `${station.name}: ${name} of 1 makes ${sum} of ${data.components[j]}`);
    });
  });
}
// Shares of the layers add up to one; the axial force under a unit axial strain is K11.
function checkShares(check, station) {
  const shares = [...layerShares(station).values()];
  for (const i of [0, 1, 2]) {
    const sum = shares.reduce((all, parts) => all + parts[i], 0);
    check(Math.abs(sum - 1) < 1e-9, `${station.name}: shares of the layers add up to ${sum}`);
  }
  load({ kind: "unit", value: 0 });
  state.force = station.stiffness.map((row) => row[0]);
  const axial = resultantOf(station).sums[0];
  check(Math.abs(axial / station.stiffness[0][0] - 1) < 0.01, `${station.name}: EA of the layers is ${axial}`);
  const heads = [...byId("layer-table").querySelectorAll("th")].map((head) => head.textContent);
  check(["of EA", "of EI about y", "of EI about z"].every((head) => heads.includes(head)), `${station.name}: no shares of stiffness`);
  load({ kind: "unit", value: 5 });
}
// Sums of loads, extremes and colors.
function checkStresses(check, station) {
  if (!station.picture.stress) return;
  check(unitStresses(station).length === station.cells.length, `${station.name}: cells without stress`);
  checkResultants(check, station);
  checkShares(check, station);
  const before = state.load;
  const field = byId("force-4");
  field.value = "-2.5e6";
  field.dispatchEvent(new Event("input"));
  byId("force-0").value = "1e5";
  byId("force-0").dispatchEvent(new Event("input"));
  check(state.load.kind === "typed" && state.force[4] === -2.5e6 && state.force[0] === 1e5, `${station.name}: typed loads are not used`);
  const all = stressed(station);
  const units = unitStresses(station);
  const exact = (k, c) => 1e5 * units[k][c] - 2.5e6 * units[k][24 + c] + state.force[5] * units[k][30 + c];
  check(all.every(({ values }, k) => AXES.every((_, c) => Math.abs(values[c] - exact(k, c)) <= 1e-9 * (1e5 * Math.abs(units[k][c]) + 2.5e6 * Math.abs(units[k][24 + c]) + Math.abs(state.force[5] * units[k][30 + c])))), `${station.name}: stresses are not the sums of unit loads`);
  const unit = stressUnit();
  const rows = [...byId("extreme-table").querySelector("tbody").rows];
  check(rows.length === STRESSES.length, `${station.name}: ${rows.length} extreme stresses`);
  rows.forEach((row, i) => {
    const values = all.map((one) => one.values[i] * unit.factor);
    for (const [column, find] of [[1, Math.min], [3, Math.max]]) {
      const expected = values.reduce((a, b) => find(a, b));
      check(Math.abs(Number(row.cells[column].textContent) - expected) <= 1e-4 * Math.abs(expected), `${station.name}: ${STRESSES[i]} has the extreme ${row.cells[column].textContent}, expected ${expected}`);
    }
  });
  for (const button of rows[0].querySelectorAll("button")) {
    button.click();
    check(byId("tip").textContent.includes("stress 11 ") && byId("spoken").textContent.includes("von Mises"), `${station.name}: the cell of an extreme is not shown`);
  }
  for (const { instant, force } of instantsOf(station)) {
    byId("load").value = `instant/${instant}`;
    byId("load").dispatchEvent(new Event("change"));
    check(loadName() === instant && state.force.every((value, i) => value === force[i]), `${station.name}: the force of ${instant} is not used`);
    check(byId("extreme-table").textContent.includes(instant), `${station.name}: the table does not have the load`);
  }
  load(before);
}
// Samples of the program: stresses within the error of short numbers, failure to round-off.
function checkSamples(check, samples) {
  for (const sample of samples) {
    const station = decoded(stations.find((one) => one.name === sample.section));
    const { ply } = station.cells[sample.cell];
    const found = superposed(unitStresses(station)[sample.cell], sample.force);
    const steps = station.steps[station.picture.plies.indexOf(ply)];
    found.forEach((value, c) => {
      const error = sample.force.reduce((sum, force, i) => sum + 0.5 * Math.abs(force) * steps[6 * i + c], 0);
      check(Math.abs(value - sample.stress[c]) <= error + sample.round_off, `${sample.section}, cell ${sample.cell}: stress ${AXES[c]} is ${value}, expected ${sample.stress[c]}`);
    });
    const results = failures(materials.get(ply.material), sample.stress);
    check(results.length === sample.failures.length, `${sample.section}, cell ${sample.cell}: ${results.length} criteria`);
    results.forEach((one, i) => {
      const [criterion, index, reserve, mode] = sample.failures[i];
      const isNear = (a, b) => (b === null ? a === Infinity : Math.abs(a - b) <= 1e-8 * Math.abs(b) + 1e-12);
      check(one.criterion === criterion && one.mode === mode && isNear(one.index, index) && isNear(one.reserve, reserve), `${sample.section}, cell ${sample.cell}: ${Object.values(one).join(", ")}, expected ${sample.failures[i].join(", ")}`);
    });
  }
}
