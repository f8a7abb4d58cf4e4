//! Joints that guide points: reactions and relative motions of bodies on guides, planes and
//! strings against closed forms.
//!
//! For constant accelerations the integration scheme, of second order, is exact. The error of
//! positions is then some 1e-15, and of forces, which balance their second derivative, 1e-15 m /
//! h^2, 1e-11 N for steps of 10 ms: 1e-9 allows for growth over the steps. Otherwise errors are of
//! second order, and the tolerance is three times the local error constant of the motion: about 0.1
//! (omega h)^2 of the force.

use nalgebra::Vector3;

use crate::joint_runs::{Mechanism, check, check_order, find, off};

const GRAVITY: f64 = 9.81;
const MASS: f64 = 2.0;
/// Slope of guides and planes.
const SLOPE: f64 = 0.5;
const STEP: f64 = 0.01;
const EXACT: f64 = 1e-9;

/// Down the slope, and away from it.
fn slope() -> [Vector3<f64>; 2] {
    let (sine, cosine) = SLOPE.sin_cos();
    [
        Vector3::new(cosine, 0.0, -sine),
        Vector3::new(sine, 0.0, cosine),
    ]
}

fn list(v: &Vector3<f64>) -> String {
    format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z)
}

/// A body of mass 2 kg with its center at `offset` from its node, under gravity.
fn body(offset: &Vector3<f64>, motion: &str) -> String {
    let offset = list(offset);
    format!(
        "[gravity]\nacceleration = [0, 0, -{GRAVITY}]\n\
         [[node]]\nname = \"body\"\nposition = [0.1, 0.2, 0.3]\n{motion}\n\
         [[body]]\nname = \"body\"\nnode = \"body\"\nmass = {MASS}\n\
         offset = {offset}\ninertia = [1, 1, 1]\n"
    )
}

// Down a smooth guide: a = g sin(slope) along h. The guide exerts m (a - g), across h, and the
// moment that prevents rotation of the body, whose center is at c from the point: c x F.
#[test]
fn a_body_slides_down_a_guide() {
    let ([h, _], c) = (slope(), Vector3::new(0.3, 0.2, -0.4));
    let axis = list(&h);
    let guide = format!(
        "[[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"body\"]\naxis = {axis}\n"
    );
    let run = Mechanism::new(&(body(&c, "") + &guide), 1.0, STEP);
    let a = GRAVITY * SLOPE.sin();
    let force = MASS * (a * h + GRAVITY * Vector3::z());
    let case = "prismatic joint, slope";
    let found = run.most_of("guide", |_, observed| off(observed.force, force));
    check(case, "force [N]", found, EXACT);
    let found = run.most_of("guide", |_, observed| off(observed.moment, c.cross(&force)));
    check(case, "moment [N m]", found, EXACT);
    let found = run.most_of("guide", |t, observed| {
        let slid = Vector3::new(0.5 * a * t * t, 0.0, 0.0);
        off(observed.displacement, slid).max(off(observed.velocity, Vector3::new(a * t, 0.0, 0.0)))
    });
    check(case, "displacement and velocity [m, m/s]", found, EXACT);
}

// The guide on a carrier that is lifted with 1.2 m/s^2, the body driven along it with
// 0.8 m/s^2: F = m (0.8 h + (g + 1.2) z) on the body, and the opposite on the carrier.
#[test]
fn a_driven_guide_on_a_lift() {
    let ([h, _], c) = (slope(), Vector3::new(0.3, 0.2, -0.4));
    let axis = list(&h);
    let cards = format!(
        "{}[[node]]\nname = \"lift\"\nposition = [0, 0, 0]\n\
         [[joint]]\nname = \"hoist\"\nkind = \"total\"\nnodes = [\"lift\"]\n\
         displacement = {{ z = \"= 0.6*t^2\" }}\n\
         locked = [\"x\", \"y\", \"about x\", \"about y\", \"about z\"]\n\
         [[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"lift\", \"body\"]\n\
         axis = {axis}\ndisplacement = \"= 0.2*t + 0.4*t^2\"\n",
        body(&c, "")
    );
    let run = Mechanism::new(&cards, 1.0, STEP);
    let force = MASS * (0.8 * h + (GRAVITY + 1.2) * Vector3::z());
    let case = "driven prismatic joint on a lift";
    let found = run.most_of("guide", |_, observed| off(observed.force, force));
    check(case, "force [N]", found, EXACT);
    let found = run.most_of("guide", |_, observed| off(observed.moment, c.cross(&force)));
    check(case, "moment [N m]", found, EXACT);
    // The hoist carries the whole force, with its moment about the hoist's point. The lift has no
    // mass: for its acceleration at the start 1e-9 of the largest mass is added.
    let lift = 1.2 * 1e-9 * MASS;
    let found = run.most(|t, observed| {
        let arm = Vector3::new(0.1, 0.2, 0.3) + (0.2 * t + 0.4 * t * t) * h + c;
        let hoist = find(observed, "hoist");
        off(hoist.force, force).max(off(hoist.moment, arm.cross(&force)))
    });
    check(
        case,
        "reaction of the total joint [N, N m]",
        found,
        EXACT + lift,
    );
}

// A puck on a smooth slope: N = m g cos(slope) across it, a parabola in it.
#[test]
fn a_puck_on_a_slope() {
    let [down, normal] = slope();
    let start = 0.5 * down + 1.5 * Vector3::y();
    let motion = format!("velocity = {}\nangular_velocity = [1, 2, 3]", list(&start));
    let plane = format!(
        "[[joint]]\nname = \"plane\"\nkind = \"in-plane\"\nnodes = [\"body\"]\naxis = {}\n",
        list(&normal)
    );
    let cards = body(&Vector3::zeros(), &motion) + &plane;
    let run = Mechanism::new(&cards, 1.0, STEP);
    let force = MASS * GRAVITY * SLOPE.cos() * normal;
    let case = "in-plane joint, puck on a slope";
    let found = run.most_of("plane", |_, observed| off(observed.force, force));
    check(case, "force [N]", found, EXACT);
    let found = run.most_of("plane", |_, observed| observed.moment.amax());
    check(case, "moment [N m]", found, EXACT);
    let found = run.most_of("plane", |t, observed| {
        let gone = start * t + 0.5 * GRAVITY * SLOPE.sin() * t * t * down;
        off(observed.displacement, observed.axes[0].transpose() * gone)
    });
    check(case, "displacement [m]", found, EXACT);
}

// A plane that is lifted under the puck: N = m (g + 1.2).
#[test]
fn a_puck_on_a_driven_plane() {
    let plane = "[[joint]]\nname = \"plane\"\nkind = \"in-plane\"\nnodes = [\"body\"]\n\
                 axis = [0, 0, 1]\ndisplacement = \"= 0.6*t^2\"\n";
    let cards = body(&Vector3::zeros(), "velocity = [1, 0, 0]") + plane;
    let run = Mechanism::new(&cards, 1.0, STEP);
    let force = MASS * (GRAVITY + 1.2) * Vector3::z();
    let found = run.most_of("plane", |_, observed| off(observed.force, force));
    check("driven in-plane joint", "force [N]", found, EXACT);
}

// A bead on a straight wire that turns with W: r'' = W^2 r, r = r_0 cosh(W t), and the wire pushes
// it sideways by 2 m W r'; the motor of the wire exerts r times this force.
#[test]
fn a_bead_on_a_turning_wire() {
    const TURN: f64 = 2.0;
    const START: f64 = 0.5;
    let cards = format!(
        "[[node]]\nname = \"wire\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"bead\"\nposition = [{START}, 0, 0]\n\
         velocity = [0, {}, 0]\nangular_velocity = [0.4, 0.3, {TURN}]\n\
         [[body]]\nname = \"bead\"\nnode = \"bead\"\nmass = {MASS}\ninertia = [1, 1, 1]\n\
         [[joint]]\nname = \"motor\"\nkind = \"revolute\"\nnodes = [\"wire\"]\naxis = [0, 0, 1]\n\
         angle = \"= {TURN}*t\"\n\
         [[joint]]\nname = \"wire\"\nkind = \"in-line\"\nnodes = [\"wire\", \"bead\"]\n\
         from = [0, 0, 0]\naxis = [1, 0, 0]\n",
        TURN * START
    );
    let runs = [STEP, STEP / 2.0].map(|step| Mechanism::new(&cards, 1.0, step));
    let push = |t: f64| 2.0 * MASS * TURN * TURN * START * (TURN * t).sinh();
    let radius = |t: f64| START * (TURN * t).cosh();
    let case = "in-line joint, bead on a turning wire";
    let errors = [0, 1].map(|i: usize| {
        runs[i].most_of("wire", |t, observed| {
            let sideways = Vector3::z().cross(&observed.axes[0].column(0));
            off(observed.force, push(t) * sideways)
        })
    });
    check_order(case, "force, of 29 N [N]", errors, 5e-3);
    let errors = [0, 1].map(|i: usize| {
        runs[i].most_of("wire", |t, observed| {
            off(observed.displacement, Vector3::new(radius(t), 0.0, 0.0))
        })
    });
    check_order(case, "displacement [m]", errors, 5e-4);
    let errors = [0, 1].map(|i: usize| {
        let turning = |t: f64| push(t) * radius(t) * Vector3::z();
        runs[i].most_of("motor", |t, observed| off(observed.moment, turning(t)))
    });
    check_order(case, "moment of the motor, of 55 N m [N m]", errors, 3e-2);
}

// A mass on a string that is wound in with 0.2 m/s: l^2 times the angular velocity is constant, the
// tension is m H^2 / l^3, and the angle H/v (1/l - 1/l_0).
#[test]
fn a_mass_on_a_string_that_is_wound_in() {
    const SPEED: f64 = 1.5;
    const WOUND: f64 = 0.2;
    let cards = format!(
        "[[node]]\nname = \"mass\"\nposition = [1, 0, 0]\nvelocity = [-{WOUND}, {SPEED}, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = {MASS}\ninertia = [1, 1, 1]\n\
         [[joint]]\nname = \"string\"\nkind = \"distance\"\nnodes = [\"mass\"]\nat = [0, 0, 0]\n\
         length = \"= 1 - {WOUND}*t\"\n"
    );
    let runs = [STEP, STEP / 2.0].map(|step| Mechanism::new(&cards, 2.0, step));
    let length = |t: f64| 1.0 - WOUND * t;
    let along = |t: f64| {
        let angle: f64 = SPEED / WOUND * (1.0 / length(t) - 1.0);
        Vector3::new(angle.cos(), angle.sin(), 0.0)
    };
    let case = "distance joint, mass on a string that is wound in";
    let errors = [0, 1].map(|i: usize| {
        runs[i].most_of("string", |t, observed| {
            off(
                observed.force,
                -MASS * SPEED * SPEED / length(t).powi(3) * along(t),
            )
        })
    });
    check_order(case, "force, of 21 N [N]", errors, 3e-2);
    let errors = [0, 1].map(|i: usize| {
        runs[i].most_of("string", |t, observed| {
            off(observed.displacement, length(t) * along(t))
        })
    });
    check_order(case, "displacement [m]", errors, 1e-3);
}

// Velocities of 0.4 t along x and of 0.6 t about z are imposed: m 0.4 and J 0.6; the body falls
// along z. Of a position, x is held to 0.2 t^2: the same force.
#[test]
fn imposed_velocities_and_positions() {
    let velocity = "[[joint]]\nname = \"pull\"\nkind = \"velocity\"\nnodes = [\"body\"]\n\
                    velocity = { x = \"= 0.4*t\" }\nangular_velocity = { z = \"= 0.6*t\" }\n";
    let position = "[[joint]]\nname = \"pull\"\nkind = \"position\"\nnodes = [\"body\"]\n\
                    displacement = { x = \"= 0.2*t^2\" }\n";
    for (kind, card, moment) in [("velocity", velocity, 0.6), ("position", position, 0.0)] {
        let run = Mechanism::new(&(body(&Vector3::zeros(), "") + card), 1.0, STEP);
        let case = format!("{kind} joint");
        let force = Vector3::new(0.4 * MASS, 0.0, 0.0);
        let found = run.most_of("pull", |_, observed| off(observed.force, force));
        check(&case, "force [N]", found, EXACT);
        let moment = Vector3::new(0.0, 0.0, moment);
        let found = run.most_of("pull", |_, observed| off(observed.moment, moment));
        check(&case, "moment [N m]", found, EXACT);
        let found = run.most_of("pull", |t, observed| {
            let gone = Vector3::new(0.2, 0.0, -0.5 * GRAVITY) * t * t;
            off(observed.displacement, gone)
        });
        check(&case, "displacement [m]", found, EXACT);
    }
}

// A rod of 200 N/m whose relaxed length grows by v = 0.3 m/s pushes a mass of 2 kg: x = 1 + v t -
// (v/w) sin(w t), and the tension is -k (v/w) sin(w t).
#[test]
fn a_rod_that_grows_pushes_a_mass() {
    let cards = format!(
        "[[node]]\nname = \"mass\"\nposition = [1, 0, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = {MASS}\ninertia = [1, 1, 1]\n\
         [[rod]]\nname = \"jack\"\nnodes = [\"mass\"]\nat = [0, 0, 0]\nlength = \"= 1 + 0.3*t\"\n\
         measure = \"elongation\"\nlaw = {{ kind = \"linear\", stiffness = 200 }}\n"
    );
    let errors = [STEP / 2.0, STEP / 4.0].map(|step| {
        let run = Mechanism::new(&cards, 1.0, step);
        run.most(|t, observed| {
            let tension = -200.0 * 0.03 * (10.0 * t).sin();
            (observed.springs[0].force.x - tension).abs()
        })
    });
    let case = "rod with a driven length";
    check_order(case, "tension, of 6 N [N]", errors, 2e-2);
}
