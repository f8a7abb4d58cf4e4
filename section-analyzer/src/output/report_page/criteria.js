// Failure criteria: index, at most one if the material is safe, reserve factor and mode, of a
// stress in material axes in the order 11 22 33 23 13 12.

const AXES = ["11", "22", "33", "23", "13", "12"];
const SHEARS = ["23", "13", "12"];
// The smallest positive factor at which a t^2 + b t is one.
function quadraticReserve(a, b) {
  const denominator = b + Math.sqrt(b * b + 4 * a);
  return denominator > 0 ? 2 / denominator : Infinity;
}
// The largest of [measure, mode], each linear in the load.
function worstLinear(measures) {
  const [index, mode] = measures.reduce((worst, one) => (one[0] >= worst[0] ? one : worst));
  return { index, reserve: 1 / index, mode };
}
// Maximum stress or strain along the axes.
function directional({ tension, compression, shear }, s) {
  const normal = [0, 1, 2].map((i) => (s[i] >= 0 ? [s[i] / tension[i], `tension ${i + 1}`] : [-s[i] / compression[i], `compression ${i + 1}`]));
  return worstLinear([...normal, ...SHEARS.map((name, i) => [Math.abs(s[3 + i]) / shear[i], `shear ${name}`])]);
}
// Smallest and largest principal value of a symmetric tensor, by the angle of its cubic.
function principal([a, b, c, d, e, f]) {
  const mean = (a + b + c) / 3;
  const [x, y, z] = [a - mean, b - mean, c - mean];
  const second = (x * x + y * y + z * z) / 2 + d * d + e * e + f * f;
  const radius = Math.sqrt(second / 3);
  if (radius === 0) return [mean, mean];
  const third = x * (y * z - d * d) - f * (f * z - d * e) + e * (f * d - y * e);
  const angle = Math.acos(Math.max(-1, Math.min(1, third / (2 * radius ** 3)))) / 3;
  return [mean + 2 * radius * Math.cos(angle + (2 * Math.PI) / 3), mean + 2 * radius * Math.cos(angle)];
}
// Maximum principal stress or strain; shear is the measure of shear per difference.
function uniform({ tension, compression, shear }, tensor, factor) {
  const [low, high] = principal(tensor);
  return worstLinear([[high / tension, "tension"], [-low / compression, "compression"], [(factor * (high - low)) / shear, "shear"]]);
}
function tsaiWu({ tension, compression, shear }, [f23, f13, f12], s) {
  const coupling = [[1, f12, f13], [f12, 1, f23], [f13, f23, 1]];
  const scaled = [0, 1, 2].map((i) => s[i] / Math.sqrt(tension[i] * compression[i]));
  const linear = [0, 1, 2, 3, 4, 5].map((i) => (i < 3 ? (1 / tension[i] - 1 / compression[i]) * s[i] : 0));
  const quadratic = [0, 1, 2].map((i) => scaled[i] * coupling[i].reduce((sum, f, j) => sum + f * scaled[j], 0));
  quadratic.push(...[0, 1, 2].map((i) => (s[3 + i] / shear[i]) ** 2));
  const [a, b] = [quadratic, linear].map((parts) => parts.reduce((x, y) => x + y));
  const share = quadratic.map((part, i) => part + linear[i]);
  const largest = share.reduce((best, part, i) => (part >= share[best] ? i : best), 0);
  const mode = largest > 2 ? `shear ${SHEARS[largest - 3]}` : `${s[largest] >= 0 ? "tension" : "compression"} ${largest + 1}`;
  return { index: a + b, reserve: quadraticReserve(Math.max(a, 0), b), mode };
}
function hashin({ tension, compression, shear }, s) {
  const along = (s[5] / shear[2]) ** 2 + (s[4] / shear[1]) ** 2;
  const fiber = s[0] >= 0
    ? { index: (s[0] / tension[0]) ** 2 + along, mode: "fiber tension" }
    : { index: (s[0] / compression[0]) ** 2, mode: "fiber compression" };
  fiber.reserve = quadraticReserve(fiber.index, 0);
  const sum = s[1] + s[2];
  const across = along + (s[3] / shear[0]) ** 2;
  const matrix = {};
  if (sum >= 0) {
    const index = (sum / tension[1]) ** 2 - (s[1] * s[2]) / shear[0] ** 2 + across;
    Object.assign(matrix, { index, reserve: quadraticReserve(Math.max(index, 0), 0), mode: "matrix tension" });
  } else {
    const linear = (((compression[1] / (2 * shear[0])) ** 2 - 1) * sum) / compression[1];
    const quadratic = ((s[1] - s[2]) / (2 * shear[0])) ** 2 + across;
    Object.assign(matrix, { index: linear + quadratic, reserve: quadraticReserve(quadratic, linear), mode: "matrix compression" });
  }
  return matrix.reserve < fiber.reserve ? matrix : fiber;
}
function vonMises(s) {
  const normal = (s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2;
  return Math.sqrt(0.5 * normal + 3 * (s[3] ** 2 + s[4] ** 2 + s[5] ** 2));
}
// The results of all criteria for which a material has limits.
function failures(material, s) {
  const { strength, strain, compliance } = material;
  const found = [];
  const add = (criterion, result) => found.push({ criterion, ...result });
  if (strength && strength.ply) add("max stress", directional(strength.ply.limits, s));
  if (strength && strength.uniform) add("max stress", uniform(strength.uniform, s, 0.5));
  if (strain && compliance) {
    const e = compliance.map((row) => row.reduce((sum, entry, j) => sum + entry * s[j], 0));
    if (strain.ply) add("max strain", directional(strain.ply, e));
    else add("max strain", uniform(strain.uniform, e.map((value, i) => (i < 3 ? value : value / 2)), 1));
  }
  if (strength && strength.ply) {
    add("Tsai-Wu", tsaiWu(strength.ply.limits, strength.ply.interaction, s));
    add("Hashin", hashin(strength.ply.limits, s));
  }
  if (strength && strength.yield) {
    const index = vonMises(s) / strength.yield;
    add("von Mises", { index, reserve: 1 / index, mode: "yielding" });
  }
  return found;
}
