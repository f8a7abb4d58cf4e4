//! The elements that are read, those that do not change the layup, and those that are refused.

use std::collections::HashSet;

use super::files::{Element, Notes};

/// The elements and attributes that an element may have.
struct Rule {
    /// The name of the element in which it is, and its own; lines are `line`.
    path: [&'static str; 2],
    /// Elements that are read.
    read: &'static [&'static str],
    /// Elements of the mesh and the analysis of PreVABS, which are not read.
    unread: &'static [&'static str],
    attributes: &'static [&'static str],
}

const fn rule(
    path: [&'static str; 2],
    read: &'static [&'static str],
    unread: &'static [&'static str],
    attributes: &'static [&'static str],
) -> Rule {
    Rule {
        path,
        read,
        unread,
        attributes,
    }
}

const NONE: &[&str] = &[];
const NAME: &[&str] = &["name"];

/// Elements that are not here have text, and no attributes.
static RULES: [Rule; 31] = [
    rule(
        ["", "cross_section"],
        &[
            "include",
            "analysis",
            "general",
            "baselines",
            "layups",
            "materials",
            "component",
        ],
        &["global", "recover", "settings"],
        &["name", "format", "fromat", "type"],
    ),
    rule(
        ["cross_section", "include"],
        &["baseline", "layup", "material"],
        NONE,
        NONE,
    ),
    rule(
        ["cross_section", "analysis"],
        &[
            "initial_twist",
            "initial_curvature_2",
            "initial_curvature_3",
            "oblique_y1",
            "oblique_y2",
            "thermal",
        ],
        &[
            "model_dim",
            "model",
            "damping",
            "trapeze",
            "vlasov",
            "physics",
        ],
        NONE,
    ),
    rule(
        ["cross_section", "general"],
        &["translate", "scale", "rotate"],
        &[
            "mesh_size",
            "element_type",
            "element_shape",
            "tolerance",
            "omega",
            "transfinite_auto",
            "transfinite_corner_angle",
            "transfinite_recombine",
            "recombine",
            "recombine_angle",
            "track_interface",
            "interface_theta1_diff_threshold",
            "interface_theta3_diff_threshold",
        ],
        NONE,
    ),
    rule(
        ["*", "baselines"],
        &["basepoints", "point", "line", "baseline"],
        NONE,
        &["basepoints"],
    ),
    rule(
        ["baselines", "basepoints"],
        &["include", "point"],
        NONE,
        NONE,
    ),
    rule(["basepoints", "include"], NONE, NONE, &["scale"]),
    rule(
        ["*", "point"],
        NONE,
        NONE,
        &["name", "on", "by", "which", "constraint", "loc"],
    ),
    rule(
        ["baselines", "line"],
        &[
            "points",
            "point",
            "angle",
            "center",
            "start",
            "end",
            "radius",
            "curvature",
            "side",
            "direction",
            "line",
            "baseline",
            "flip",
            "reverse",
            "leading_edge",
            "trailing_edge",
            "normalize",
        ],
        &["discrete"],
        &["name", "type", "method"],
    ),
    rule(
        ["line", "points"],
        NONE,
        NONE,
        &["data", "format", "header", "direction"],
    ),
    rule(["line", "discrete"], NONE, NONE, &["by"]),
    rule(["line", "flip"], NONE, NONE, &["axis", "loc"]),
    rule(["line", "leading_edge"], NONE, NONE, NAME),
    rule(["line", "trailing_edge"], NONE, NONE, NAME),
    rule(["line", "line"], NONE, NONE, NONE),
    rule(["*", "materials"], &["material", "lamina"], NONE, NONE),
    rule(
        ["materials", "material"],
        &["density", "elastic", "strength", "failure_criterion"],
        &["cte", "specific_heat", "thermal", "characteristic_length"],
        &["name", "type"],
    ),
    rule(["material", "elastic"], CONSTANTS, NONE, &["type"]),
    rule(["material", "strength"], STRENGTHS, NONE, NONE),
    rule(
        ["materials", "lamina"],
        &["material", "thickness"],
        NONE,
        NAME,
    ),
    rule(["*", "layups"], &["layup"], NONE, NONE),
    rule(
        ["layups", "layup"],
        &["layer", "lamina", "code"],
        NONE,
        &["name", "method"],
    ),
    rule(["layup", "layer"], NONE, NONE, &["lamina", "layup"]),
    rule(
        ["cross_section", "component"],
        &[
            "segment",
            "segments",
            "material",
            "baseline",
            "location",
            "theta1",
            "theta3",
            "mesh_size",
        ],
        &["joint"],
        &["name", "type", "depend"],
    ),
    rule(["component", "joint"], NONE, NONE, &["style"]),
    rule(["component", "mesh_size"], NONE, NONE, &["at"]),
    rule(["component", "baseline"], NONE, NONE, &["fillside"]),
    rule(
        ["component", "segment"],
        &["baseline", "layup"],
        &["split"],
        &["name", "free"],
    ),
    rule(
        ["component", "segments"],
        &["baseline", "layup", "layup_side"],
        NONE,
        NAME,
    ),
    rule(["*", "segment baseline"], NONE, NONE, &["position"]),
    rule(
        ["*", "segment layup"],
        NONE,
        NONE,
        &["direction", "begin", "end"],
    ),
];

/// Constants of elastic laws.
const CONSTANTS: &[&str] = &[
    "e", "nu", "e1", "e2", "e3", "g12", "g13", "g23", "nu12", "nu13", "nu23", "c11", "c12", "c13",
    "c14", "c15", "c16", "c22", "c23", "c24", "c25", "c26", "c33", "c34", "c35", "c36", "c44",
    "c45", "c46", "c55", "c56", "c66",
];

/// Strengths and their other names.
const STRENGTHS: &[&str] = &[
    "xt", "yt", "zt", "xc", "yc", "zc", "s", "t", "r", "x", "y", "z", "t1", "t2", "t3", "c1", "c2",
    "c3", "s12", "s13", "s23",
];

/// The names by which an element is found in the rules: of its parent and its own.
fn path<'x>(element: Element<'x>) -> [&'x str; 2] {
    let plain = |name: &'x str, parent: &str| match name {
        "sg" => "cross_section",
        "baseline" if matches!(parent, "baselines" | "line" | "baseline") => "line",
        _ => name,
    };
    let Some(parent) = element.parent() else {
        return ["", plain(element.name(), "")];
    };
    let above = parent.parent().map_or("", |above| above.name());
    let parent = plain(parent.name(), above);
    match (parent, element.name()) {
        ("segment" | "segments", "baseline") => ["*", "segment baseline"],
        ("segment" | "segments", "layup") => ["*", "segment layup"],
        (_, name) => [parent, plain(name, parent)],
    }
}

/// Notes elements and attributes that are not known, and reports those that are not read.
pub(super) fn check(root: Element<'_>, notes: &mut Notes) {
    let mut unread: Vec<String> = Vec::new();
    let mut skipped = HashSet::new();
    for element in root.all() {
        if let Some(parent) = element.parent() {
            let (read, not_read) = match rule_of(parent) {
                Some(rule) => (rule.read, rule.unread),
                None => (NONE, NONE),
            };
            let name = element.name();
            if skipped.contains(&parent.id()) || !read.contains(&name) {
                if not_read.contains(&name) {
                    unread.push(format!("<{name}>"));
                } else if !skipped.contains(&parent.id()) {
                    let what = format!("<{name}> in {}", parent.shown());
                    refuse_name(element, [&what, "an element that is not read"], read, notes);
                }
                skipped.insert(element.id());
                continue;
            }
        }
        let attributes = rule_of(element).map_or(NONE, |rule| rule.attributes);
        for name in element.attributes() {
            if !attributes.contains(&name) {
                let what = format!("{name} of {}", element.shown());
                refuse_name(
                    element,
                    [&what, "an attribute that is not read"],
                    attributes,
                    notes,
                );
            }
        }
    }
    unread.sort();
    unread.dedup();
    if !unread.is_empty() {
        notes
            .remarks
            .push(format!("not read: {}", unread.join(", ")));
    }
}

/// The rule of an element.
fn rule_of(element: Element<'_>) -> Option<&'static Rule> {
    let [parent, name] = path(element);
    let is_it =
        |rule: &&Rule| rule.path[1] == name && (rule.path[0] == parent || rule.path[0] == "*");
    RULES.iter().find(is_it)
}

/// Notes an element or attribute that is not known.
fn refuse_name(at: Element<'_>, [what, found]: [&str; 2], known: &[&str], notes: &mut Notes) {
    let expected = if known.is_empty() {
        "none".to_owned()
    } else {
        format!("one of {}", known.join(", "))
    };
    let help = "remove it, or correct its name; see the page on layups of PreVABS";
    notes.wrong(at, [what, found, &expected, help]);
}

/// Values that change the analysis and that a layup cannot have; each is 0 or its default.
const DEFAULTS: [(&str, f64); 6] = [
    ("initial_twist", 0.0),
    ("initial_curvature_2", 0.0),
    ("initial_curvature_3", 0.0),
    ("oblique_y1", 1.0),
    ("oblique_y2", 0.0),
    ("thermal", 0.0),
];

/// Notes settings of the analysis that a layup does not have, and the kinds of sections that are
/// not read.
pub(super) fn refuse(main: Element<'_>, notes: &mut Notes) {
    let kind = main.attribute("type").unwrap_or("general");
    if !kind.is_empty() && kind != "general" {
        let found = format!("\"{kind}\"");
        let help = "write its base lines, layups and components out";
        notes.wrong(
            main,
            ["type of <cross_section>", &found, "\"general\"", help],
        );
    }
    for analysis in main.named("analysis") {
        for (name, default) in DEFAULTS {
            let Some(one) = analysis.child(name).filter(|one| !one.text().is_empty()) else {
                continue;
            };
            let Some([value]) = one.numbers::<1>(notes) else {
                continue;
            };
            if value != default {
                let help = "remove it here; the section file has \"curvature\" and \"expansion\"";
                let (found, expected) = (format!("{value}"), format!("{default}"));
                notes.wrong(one, [&one.shown(), &found, &expected, help]);
            }
        }
    }
}
