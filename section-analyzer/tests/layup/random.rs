//! Random layups: valid ones are meshed, wrong ones are meshed soundly or refused with the name
//! of a layer or web.

use section_analyzer::mesh::generate::blade::naca;
use section_analyzer::mesh::generate::layup::{
    Bound, Fill, Layer, LayupProblem, LayupSection, Spar, Web, WebPly,
};

use crate::effort;
use crate::sections::cases;

/// Numbers from 0 to 1 (xorshift64*, Vigna 2016).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count - 1)
    }
}

fn layer(name: &str, thickness: f64, arcs: [f64; 2]) -> Layer {
    let [from, to] = arcs;
    Layer {
        name: name.to_owned(),
        thickness,
        from,
        to,
        taper: None,
        profile: Vec::new(),
    }
}

/// A contour of an airfoil, and its chord.
fn contour(random: &mut Random) -> (Vec<[f64; 2]>, f64) {
    let digits = [
        "0012", "2412", "4415", "0018", "4418", "2421", "0024", "4424", "0030",
    ];
    let points = naca(digits[random.below(9)], random.unit() < 0.3).expect("an airfoil");
    let chord = 10.0_f64.powf(random.range(-1.0, 0.8));
    let place = |[x, z]: &[f64; 2]| [(0.3 - x) * chord, z * chord];
    (points.iter().map(place).collect(), chord)
}

/// One or two webs under the caps.
fn webs(random: &mut Random, cap: [f64; 2], skin: f64) -> Vec<Web> {
    let web = |i: usize| {
        let arc = cap[0] + (cap[1] - cap[0]) * (0.25 + 0.5 * i as f64);
        let ply = |name: &str, thickness: f64| WebPly {
            name: format!("web{i}_{name}"),
            thickness,
        };
        let plies = [("fore", 0.5), ("core", 4.0), ("aft", 0.5)];
        Web {
            name: format!("web{i}"),
            arcs: [arc, 1.0 - arc],
            plies: plies.map(|(name, part)| ply(name, part * skin)).to_vec(),
        }
    };
    (0..=random.below(2)).map(web).collect()
}

/// A spar around the nose inside of all layers, whose web stands behind the caps.
fn add_spar(section: &mut LayupSection, random: &mut Random, cap: f64, thickness: f64) {
    let arc = cap - random.range(0.01, 0.04);
    let arcs = [arc, 1.0 - arc];
    let layers = vec![section.layers.len(), section.layers.len() + 1];
    section.spar = Some(Spar::around_nose("spar_web".into(), arcs, layers));
    section.layers.extend([
        layer("spar", thickness, arcs),
        layer("spar_inner", 0.5 * thickness, arcs),
    ]);
}

/// A mass in the nose, a core ahead of the first web, and one of the rest, or some of them.
fn add_fills(section: &mut LayupSection, random: &mut Random) {
    let web = Bound::Web(section.webs[0].name.clone());
    let nose = random.range(0.46, 0.48);
    let nose = Bound::Line([nose, 1.0 - nose]);
    let fills = [
        ("mass", Some(nose), None),
        ("core", Some(web.clone()), None),
        ("rest", None, Some(web)),
    ];
    for (name, ahead_of, aft_of) in fills {
        if random.unit() < 0.7 {
            section.fills.push(Fill {
                name: name.into(),
                ahead_of,
                aft_of,
            });
        }
    }
}

/// A layup that can be built: skins, caps, panels and a reinforcement of the nose that fill at
/// most two thirds of the space at the nose, and one or two webs under the caps; some have a spar
/// around the nose, some have fills.
pub fn valid(seed: u64) -> LayupSection {
    let mut random = Random::new(seed);
    let (contour, chord) = contour(&mut random);
    let thick = |random: &mut Random, low: f64, high: f64| {
        chord * 10.0_f64.powf(random.range(f64::log10(low), f64::log10(high)))
    };
    let cap = [random.range(0.26, 0.32), random.range(0.36, 0.40)];
    let skin = thick(&mut random, 2e-4, 1.2e-3);
    let caps = [0, 1].map(|_| thick(&mut random, 1e-3, 1e-2));
    let mut layers = vec![
        layer("coat", 0.2 * skin, [0.0, 1.0]),
        layer("outer", skin, [0.0, 1.0]),
        layer("cap_suction", caps[0], cap),
        layer("cap_pressure", caps[1], [1.0 - cap[1], 1.0 - cap[0]]),
    ];
    if random.unit() < 0.7 {
        let arcs = [random.range(0.44, 0.48), random.range(0.52, 0.56)];
        layers.push(layer("nose", thick(&mut random, 2e-4, 1e-3), arcs));
    }
    if random.unit() < 0.7 {
        let from = random.range(0.02, 0.15);
        let panel = thick(&mut random, 1e-3, 8e-3);
        layers.push(layer("panel", panel, [from, cap[0]]));
        let core = thick(&mut random, 1e-3, 5e-3);
        layers.push(layer("panel_lower", core, [1.0 - cap[0], 1.0 - from]));
    }
    if random.unit() < 0.5 {
        let reach = random.range(0.02, 0.08);
        layers.push(layer("edge", thick(&mut random, 3e-4, 3e-3), [0.0, reach]));
    }
    layers.push(layer("inner", skin * random.range(0.5, 1.5), [0.0, 1.0]));
    let webs = webs(&mut random, cap, skin);
    let mut section = LayupSection {
        contour,
        webs,
        layers,
        spar: None,
        fills: Vec::new(),
        size: None,
    };
    // drawn last, so that the layups without them remain
    if random.unit() < 0.3 {
        let thickness = skin * random.range(0.5, 2.0);
        add_spar(&mut section, &mut random, cap[0], thickness);
    }
    if random.unit() < 0.5 {
        add_fills(&mut section, &mut random);
    }
    section
}

/// At least 99.5 % of the layups that can be built are meshed, and the area of a cap, which
/// nothing cuts, is within 2 % of its nominal area (cells of 1/120 of the contour).
#[test]
fn layups_that_can_be_built_are_meshed() {
    let count = effort::cases(100);
    let mut failed = Vec::new();
    for seed in 0..count {
        match valid(seed as u64).generate() {
            Ok(meshed) => {
                let cap = meshed.areas.iter().find(|area| area.name == "cap_suction");
                let cap = cap.expect("a cap");
                let error = (cap.meshed / cap.nominal - 1.0).abs();
                assert!(error < 0.02, "{seed}: {error}");
            }
            Err(problem) => failed.push(format!("{seed}: {problem}")),
        }
    }
    println!(
        "{} of {count} meshed\n{}",
        count - failed.len(),
        failed.join("\n")
    );
    assert!(failed.len() as f64 <= 0.005 * count as f64, "{failed:#?}");
}

/// Changes a layer at random; the result may be valid.
fn damage_layer(layer: &mut Layer, random: &mut Random) {
    match random.below(7) {
        0 => layer.thickness *= 10.0_f64.powf(random.range(-1.5, 1.5)),
        1 => layer.from += random.range(-0.04, 0.04),
        2 => std::mem::swap(&mut layer.from, &mut layer.to),
        3 => layer.to = random.range(0.5, 1.5),
        4 => layer.from = [f64::NAN, layer.to][random.below(2)],
        5 => layer.thickness = [0.0, -1.0, f64::NAN, f64::INFINITY][random.below(4)],
        _ => layer.to = layer.from + 2e-3,
    }
}

/// Makes all layers from one on a spar with a web at any place.
fn turn_into_spar(section: &mut LayupSection, first: usize, random: &mut Random) {
    let arcs = [random.range(0.02, 0.5), random.range(0.5, 0.98)];
    let layers = (first..section.layers.len()).collect();
    section.spar = Some(Spar::around_nose("spar_web".into(), arcs, layers));
    for layer in &mut section.layers[first..] {
        [layer.from, layer.to] = arcs;
    }
}

/// Adds a fill with any bounds.
fn fill_somewhere(section: &mut LayupSection, web: usize, random: &mut Random) {
    let arcs = [random.range(-0.1, 0.5), random.range(0.5, 1.1)];
    let bound = |web: &Web| Bound::Web(web.name.clone());
    section.fills.push(Fill {
        name: format!("fill{}", section.fills.len()),
        ahead_of: Some(Bound::Line(arcs)).filter(|_| random.unit() < 0.6),
        aft_of: section.webs.get(web).map(bound),
    });
}

/// Changes a layup at random; the result may be valid.
fn damage(section: &mut LayupSection, random: &mut Random) {
    let layer = random.below(section.layers.len());
    let web_number = random.below(section.webs.len().max(1));
    let point = random.below(section.contour.len());
    match random.below(14) {
        0..=4 => damage_layer(&mut section.layers[layer], random),
        5 => {
            let factor = random.range(0.3, 1.5);
            section
                .contour
                .iter_mut()
                .for_each(|point| point[1] *= factor);
        }
        6 => section.contour.reverse(),
        7 => {
            let copy = section.contour[point];
            section.contour.insert(point, copy);
        }
        8 => section.contour[point][1] += random.range(-0.3, 0.3),
        9 => {
            let name = section.layers[0].name.clone();
            section.layers[layer].name = name;
        }
        10 => {
            let thin = |i: usize| self::layer(&format!("thin{i}"), 1e-4, [0.0, 1.0]);
            let factor = [1e-3, 1.0, 1e3][random.below(3)];
            section.layers.extend((0..60).map(thin));
            section
                .contour
                .iter_mut()
                .flatten()
                .for_each(|x| *x *= factor);
        }
        11 => fill_somewhere(section, web_number, random),
        12 => turn_into_spar(section, layer, random),
        _ => {
            let moved = [random.range(-0.1, 1.1), random.range(-0.1, 1.1)];
            section
                .webs
                .get_mut(web_number)
                .into_iter()
                .for_each(|web| web.arcs = moved);
        }
    }
}

/// Whether a problem names the layer or web, where there is one.
fn is_named(problem: &LayupProblem) -> bool {
    let of_all = matches!(
        problem,
        LayupProblem::Contour { .. }
            | LayupProblem::Open
            | LayupProblem::NoLayers
            | LayupProblem::Size { .. }
            | LayupProblem::TooManyCells { .. }
            | LayupProblem::Unsound { layer: None, .. }
    );
    of_all || problem.about().is_some_and(|name| !name.is_empty())
}

/// 200 layups of public blades with one or two random changes: a mesh that passes all checks, or
/// a message that names the layer or web. The counts show changes of the rules.
#[test]
fn damaged_layups_are_meshed_or_refused() {
    let cases = cases();
    let (mut meshed, mut refused) = (0, 0);
    let mut kinds: std::collections::BTreeMap<String, usize> = std::collections::BTreeMap::new();
    for seed in 0..effort::cases(200) {
        let mut random = Random::new(7000 + seed as u64);
        let mut section = cases[random.below(cases.len())].section.clone();
        for _ in 0..=random.below(2) {
            damage(&mut section, &mut random);
        }
        println!("{seed}");
        match section.generate() {
            Ok(_) => meshed += 1,
            Err(problem) => {
                refused += 1;
                assert!(is_named(&problem), "{seed}: {problem}");
                let kind = format!("{problem:?}");
                let end = kind.find(' ').unwrap_or(kind.len());
                *kinds.entry(kind[..end].to_owned()).or_default() += 1;
            }
        }
    }
    println!("{meshed} meshed, {refused} refused: {kinds:?}");
    assert!(meshed > refused / 4 && refused > 10);
}
