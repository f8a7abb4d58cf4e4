//! Requests of linear models that are refused, with the reason.

use beam_dynamics::input::{self, LinearChoice};

use super::{attempt, request, text};

pub(super) const BODY: &str = "[[node]]\nname = \"a\"\nposition = [0, 0, 0]\n\
    [[body]]\nname = \"a\"\nnode = \"a\"\nmass = 1\ninertia = [1, 1, 1]\n\
    [[spring]]\nname = \"s\"\nnode = \"a\"\nstiffness = [10, 20, 30]\n\
    rotational_stiffness = [1, 2, 3]\n\
    [[load]]\nnode = \"a\"\nforce = [1, 0, 0]\ndrive = \"push\"\n\
    [drives.push]\nkind = \"constant\"\nvalue = 0\n\
    [sensors.place]\nquantity = \"position\"\nof = \"a\"\ncomponent = \"x\"\n";

fn refused(cards: &str, inputs: &[&str], outputs: &[&str], about: Option<LinearChoice>) -> String {
    let mut request = request((inputs, outputs, 0.0));
    request.about = about;
    match input::parse_linear(&text(cards), "model.dynamics.toml", &request, &[]) {
        Ok(_) => panic!("accepted"),
        Err(problems) => problems.to_string(),
    }
}

fn check(shown: &str, parts: &[&str]) {
    for part in parts {
        assert!(shown.contains(part), "no \"{part}\" in\n{shown}");
    }
}

// All at once, with the nearest names.
#[test]
fn unknown_names() {
    let shown = refused(BODY, &["pusch", "push", "push"], &["plaze"], None);
    check(
        &shown,
        &[
            "\"pusch\" of --input is not a drive",
            "did you mean \"push\"?",
            "\"push\" of --input is given twice",
        ],
    );
    let shown = refused(BODY, &["push"], &["plaze"], None);
    check(
        &shown,
        &["\"plaze\" of --output", "did you mean \"place\"?"],
    );
    // A column of three components.
    let column = "[[output.column]]\nname = \"way\"\nquantity = \"displacement\"\nof = \"a\"\n";
    let shown = refused(&format!("{BODY}{column}"), &["push"], &["way"], None);
    check(&shown, &["\"way\" of --output", "did you mean \"way_x\"?"]);
}

#[test]
fn drives_that_must_be_functions_of_time() {
    let summed = BODY.replace("drive = \"push\"", "drive = \"both\"")
        + "[drives.both]\nkind = \"sum\"\nterms = [\"push\", \"push\"]\n";
    let shown = refused(&summed, &["push"], &["place"], None);
    check(&shown, &["uses \"push\", an input of the linear model"]);
    let weight = format!("{BODY}[gravity]\nacceleration = [0, 0, -9.81]\ndrive = \"push\"\n");
    let shown = refused(&weight, &["push"], &["place"], None);
    check(&shown, &["uses \"push\", an input of the linear model"]);
}

#[test]
fn equilibria_that_the_file_does_not_have() {
    let shown = refused(BODY, &["push"], &["place"], Some(LinearChoice::Static));
    check(&shown, &["--about static needs [static]"]);
    let several = format!("{BODY}[modes]\nspeeds = [0, 1]\n");
    let shown = refused(&several, &["push"], &["place"], None);
    check(&shown, &["[modes] has 2 speeds", "--speed"]);
    let euler = format!(
        "{BODY}[[output.column]]\nname = \"turn\"\nquantity = \"euler_angles\"\nof = \"a\"\n"
    );
    let shown = refused(&euler, &["push"], &["turn_first"], None);
    check(&shown, &["the derivatives of these angles are not known"]);
}

// Two hinges on one axis hold five motions twice: the reactions of the second one are zero.
#[test]
fn redundant_joints_are_named() {
    let door = BODY.replace("rotational_stiffness = [1, 2, 3]\n", "")
        + "[[joint]]\nname = \"low\"\nkind = \"revolute\"\nnodes = [\"a\"]\naxis = [0, 0, 1]\n\
           at = [0, 0.2, 0]\n\
           [[joint]]\nname = \"high\"\nkind = \"revolute\"\nnodes = [\"a\"]\naxis = [0, 0, 1]\n\
           at = [0, 0.2, 1]\n";
    let model = attempt(&door, (&["push"], &["place"], 0.0));
    let model = model.unwrap_or_else(|failure| panic!("{failure}"));
    assert_eq!(model.states.len(), 2, "{:?}", model.states);
    let of_high = |remark: &&String| remark.contains("\"high\" follows from");
    assert_eq!(
        model.remarks.iter().filter(of_high).count(),
        5,
        "{:?}",
        model.remarks
    );
}
