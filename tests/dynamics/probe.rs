use beam_dynamics::assembly::System;
use beam_dynamics::case::{InitialMotion, Model, TransientQuestion};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{ConstraintJoint, JointEnds, Placing, axes_along};
use beam_dynamics::integrator::Scheme;
use beam_dynamics::model::{Drive, Node};
use nalgebra::{Matrix3, Vector3};

use crate::in_time::{Run, Table, json, numbers};

struct B {
    nodes: Vec<Node>,
    init: Vec<InitialMotion>,
    elements: Vec<Box<dyn Element>>,
}
type V = Vector3<f64>;
fn v(x: f64, y: f64, z: f64) -> V {
    Vector3::new(x, y, z)
}
impl B {
    fn new() -> Self {
        Self {
            nodes: vec![],
            init: vec![],
            elements: vec![],
        }
    }
    fn node(&mut self, name: &str, p: V, r: Matrix3<f64>, vel: V, om: V) -> usize {
        self.nodes.push(Node {
            label: name.into(),
            position: p,
            rotation: r,
        });
        self.init.push(InitialMotion {
            velocity: Some(vel),
            angular_velocity: Some(om),
            ..InitialMotion::default()
        });
        self.nodes.len() - 1
    }
    fn body(&mut self, n: usize, m: f64, c: V, j: V) {
        let i = RigidInertia::about_node(m, &c, &Matrix3::from_diagonal(&j));
        self.elements.push(Box::new(RigidBody::new("body", n, i)));
    }
    fn joint(
        &mut self,
        f: impl FnOnce(&JointEnds<'_>) -> ConstraintJoint,
        a: Option<usize>,
        b: usize,
    ) {
        let ends = JointEnds {
            a: a.map(|a| (a, &self.nodes[a])),
            b: (b, &self.nodes[b]),
        };
        let j = f(&ends);
        self.elements.push(Box::new(j));
    }
    fn model(self, g: V) -> Model {
        let mut m = Model::new("probe", System::new(self.nodes, self.elements));
        m.initial = self.init;
        m.gravity = g;
        m
    }
}
fn spherical(b: &mut B, name: &str, a: Option<usize>, n: usize, p: V) {
    b.joint(
        |e| ConstraintJoint::spherical(name, e, &Placing::at(&p, &Matrix3::identity())),
        a,
        n,
    );
}

#[test]
fn probe_pendulum() {
    let table = json("pendulum.json");
    for run in table["runs"].as_array().unwrap() {
        let [radius, step] = ["rho", "h"].map(|key| run[key].as_f64().unwrap());
        let mut b = B::new();
        let n = b.node(
            "mass",
            v(1., 0., 0.),
            Matrix3::identity(),
            v(0., -1., 0.),
            v(0., 0., 0.),
        );
        b.body(n, 1.0, v(0., 0., 0.), v(1., 1., 1.));
        b.joint(
            |e| {
                let at = Placing {
                    points: [v(0., 0., 0.), v(1., 0., 0.)],
                    axes: [Matrix3::identity(); 2],
                };
                ConstraintJoint::distance("link", e, &at, Drive::Constant(1.0))
            },
            None,
            n,
        );
        let mut q = TransientQuestion::new(1.0, step);
        q.scheme = Scheme::TwoStep { radius };
        let r = Run::of(b.model(v(0., -1., 0.)), &q, 1);
        r.check_end();
        let m = r.motion("mass", 1.0);
        let lam = r.reaction("link", "mass", 1.0)[0];
        let f = [
            m.position.x,
            m.position.y,
            m.velocity.x,
            m.velocity.y,
            -lam.dot(&m.position),
        ];
        let e = [
            0.13499492612777,
            -0.99084628975425,
            -1.71095158228585,
            -0.23310354476491,
            3.97253886926265,
        ];
        let er: Vec<_> = (0..5)
            .map(|k| format!("{:.3e}", (f[k] / e[k] - 1.0f64).abs()))
            .collect();
        println!(
            "{radius} {step} {er:?} expected {:?} lam0 {:?} lam1 {:?}",
            numbers(&run["consistent"]),
            r.reaction("link", "mass", 0.0)[0].x,
            r.reaction("link", "mass", step)[0].norm()
        );
        println!("{:?}", r.outcome.effort);
    }
}

#[test]
fn probe_top() {
    for (case, om, h) in [
        (1, v(0., 0.9888, 7.5167), 1e-3),
        (3, v(0., 0., 6.3794), 1e-3),
        (3, v(0., 0., 6.3794), 5e-3),
    ] {
        let r0 =
            *nalgebra::Rotation3::from_axis_angle(&Vector3::x_axis(), 10f64.to_radians()).matrix();
        let p = r0 * v(0., 0., 0.2);
        let w = r0 * om;
        let mut b = B::new();
        let n = b.node("top", p, r0, w.cross(&p), w);
        b.body(n, 1.0, v(0., 0., 0.), v(0.75, 0.75, 0.4));
        spherical(&mut b, "point", None, n, v(0., 0., 0.));
        let q = TransientQuestion::new(10.0, h);
        let r = Run::of(b.model(v(0., 0., -3.)), &q, (0.05 / h).round() as usize);
        r.check_end();
        let t = Table::new(&format!("spinning_top_case{case}.csv"));
        let e = t
            .rows
            .iter()
            .map(|row| (r.motion("top", row[0]).position - t.vector(row, "x")).norm())
            .fold(0.0, f64::max);
        println!("top {case} {h} {e:e} {:?}", r.outcome.effort);
    }
}

#[test]
fn probe_bipendulum() {
    for (h, to) in [
        (1e-3, 5.0),
        (5e-4, 5.0),
        (2e-3, 2.0),
        (3e-3, 2.0),
        (5e-3, 2.0),
    ] {
        let mut b = B::new();
        let one = Matrix3::identity();
        let a = b.node("link 1", v(0., -0.5, 0.), one, v(2., 0., 0.), v(0., 0., 4.));
        let c = b.node("link 2", v(0., -1.5, 0.), one, v(6., 0., 0.), v(0., 0., 4.));
        for n in [a, c] {
            b.body(n, 0.4565, v(0., 0., 0.), v(0.0308, 0.0001, 0.0308));
        }
        spherical(&mut b, "joint 1", None, a, v(0., 0., 0.));
        spherical(&mut b, "joint 2", Some(a), c, v(0., -1., 0.));
        let q = TransientQuestion::new(to, h);
        let r = Run::of(b.model(v(0., 0., -32.175)), &q, 1);
        let t = Table::new("bipendulum.csv");
        let (mut e1, mut e2, mut spin) = (0f64, 0f64, 0f64);
        for row in t.rows.iter().filter(|row| row[0] <= r.outcome.time + 1e-9) {
            if !r.instants.iter().any(|(t, _)| (t - row[0]).abs() < 1e-9) {
                continue;
            }
            for (n, f) in [("link 1", "x1"), ("link 2", "x2")] {
                e1 = e1.max((r.motion(n, row[0]).position - t.vector(row, f)).norm());
                spin = spin.max(
                    (r.motion(n, row[0]).rotation.transpose()
                        * r.motion(n, row[0]).angular_velocity)
                        .y
                        .abs(),
                );
            }
            for (j, n, f) in [("joint 1", "link 1", "F0x"), ("joint 2", "link 2", "F1x")] {
                e2 = e2.max((r.reaction(j, n, row[0])[0] - t.vector(row, f)).norm());
            }
        }
        println!(
            "bip {h} pos {e1:e} force {e2:e} spin {spin:e} end {} {:?} {:?}",
            r.outcome.time,
            r.outcome.failure.as_ref().map(|f| f.to_string()),
            r.outcome.effort
        );
    }
}

#[test]
fn probe_squeezer() {
    let d = json("squeezer.json");
    let f = |x: &serde_json::Value| x.as_f64().unwrap();
    let q0 = numbers(&d["start"]);
    let pi = std::f64::consts::PI;
    let att = |q: &[f64]| {
        [
            q[0],
            q[0] + q[1] + pi,
            q[2] - pi / 2.,
            q[3] + q[4] - pi / 2.,
            q[4],
            q[5] + q[6],
            q[6] - pi / 2.,
        ]
    };
    let an = att(&q0);
    let ground = |k: &str| {
        let p = numbers(&d["ground"][k]);
        v(p[0], p[1], 0.)
    };
    let (aa, bb) = (ground("A"), ground("B"));
    let bodies = d["bodies"].as_array().unwrap();
    let rot = |a: f64| *nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), a).matrix();
    let tip = |k: usize, root: V| root + rot(an[k]) * v(f(&bodies[k]["length"]), 0., 0.);
    let o = v(0., 0., 0.);
    let ft = tip(0, o);
    let gt = tip(4, aa);
    let ht = tip(6, aa);
    let roots = [o, ft, bb, gt, aa, ht, aa];
    let e = tip(2, bb);
    for h in [2e-5, 1e-5] {
        let mut b = B::new();
        for k in 0..7 {
            let n = b.node(
                bodies[k]["name"].as_str().unwrap(),
                roots[k],
                rot(an[k]),
                o,
                o,
            );
            let c = numbers(&bodies[k]["center"]);
            let i = f(&bodies[k]["inertia"]);
            b.body(
                n,
                f(&bodies[k]["mass"]),
                v(c[0], c[1], 0.),
                v(i / 2., i / 2., i),
            );
        }
        let z = axes_along(&Vector3::z());
        for (name, a, n, p) in [
            ("O", None, 0, o),
            ("F", Some(0), 1, ft),
            ("B", None, 2, bb),
            ("A4", None, 4, aa),
            ("G", Some(4), 3, gt),
            ("A6", None, 6, aa),
            ("H", Some(6), 5, ht),
        ] {
            b.joint(
                |e| ConstraintJoint::revolute(name, e, &Placing::at(&p, &z), None),
                a,
                n,
            );
        }
        for (name, n) in [("E1", 1), ("E4", 3), ("E6", 5)] {
            b.joint(
                |x| ConstraintJoint::in_line(name, x, &Placing::at(&e, &z)),
                Some(2),
                n,
            );
        }
        let load = beam_dynamics::elements::loads::NodalForce {
            moment: v(0., 0., 0.033),
            ..crate::chain::DEAD
        };
        let load = beam_dynamics::elements::loads::NodalLoad::new("m", 0, &b.nodes[0], load);
        b.elements.push(Box::new(load));
        use beam_dynamics::elements::springs::{End, Measure, Rod};
        let ends = [
            End::Frame {
                position: ground("C"),
            },
            End::Node {
                node: 2,
                offset: v(0.018, 0.02, 0.),
            },
        ];
        let law = beam_dynamics::elements::laws::Law::linear(nalgebra::SMatrix::<f64, 1, 1>::new(
            4530.0 * 0.07785,
        ));
        b.elements.push(Box::new(Rod::new(
            "spring",
            ends,
            &b.nodes,
            Some(0.07785),
            (Measure::Strain, law),
        )));
        let r = Run::of(b.model(o), &TransientQuestion::new(0.03, h), 1);
        let (qa, qr) = (
            numbers(&d["published"]["angles"]),
            numbers(&d["published"]["rates"]),
        );
        let (pa, pr) = (
            att(&qa),
            [
                qr[0],
                qr[0] + qr[1],
                qr[2],
                qr[3] + qr[4],
                qr[4],
                qr[5] + qr[6],
                qr[6],
            ],
        );
        let last = &r.instants.last().unwrap().1;
        for k in 0..7 {
            let m = &last.nodes[k];
            let a = m.rotation[(1, 0)].atan2(m.rotation[(0, 0)]);
            let da = (a - pa[k] + pi).rem_euclid(2. * pi) - pi;
            println!(
                "   {k} {da:e} {:e} of {}",
                m.angular_velocity.z - pr[k],
                pr[k]
            );
        }
        println!(
            "squeezer {h} end {} {:?} {:?} remarks {:?}",
            r.outcome.time,
            r.outcome.failure.as_ref().map(|f| f.to_string()),
            r.outcome.effort,
            r.outcome.remarks
        );
    }
}

#[test]
fn probe_bathe() {
    use beam_dynamics::elements::springs::{End, Measure, Rod};
    for (case, l0, ea, m, g, p, vel, to, h, file) in [
        (
            "bathe",
            3.0443,
            1e10,
            10.,
            9.8,
            v(3.0443, 0., 0.),
            v(0., 0., 0.),
            10.,
            5e-3,
            "bathe_pendulum.csv",
        ),
        (
            "unstretched",
            1.0,
            9.81e4,
            1.,
            9.81,
            v(0., -1., 0.),
            v(6.3, 0., 0.),
            1.,
            2.5e-4,
            "deformable_pendulum_unstretched.csv",
        ),
        (
            "balanced",
            1.0,
            9.81e4,
            1.,
            9.81,
            v(0., -1.000504383191882, 0.),
            v(6.3, 0., 0.),
            1.,
            2.5e-4,
            "deformable_pendulum_balanced.csv",
        ),
        (
            "coarse",
            1.0,
            9.81e4,
            1.,
            9.81,
            v(0., -1., 0.),
            v(6.3, 0., 0.),
            1.,
            2e-2,
            "deformable_pendulum_unstretched.csv",
        ),
    ] {
        let mut b = B::new();
        let n = b.node("mass", p, Matrix3::identity(), vel, v(0., 0., 0.));
        b.body(n, m, v(0., 0., 0.), v(1., 1., 1.));
        let ends = [
            End::Frame {
                position: v(0., 0., 0.),
            },
            End::Node {
                node: n,
                offset: v(0., 0., 0.),
            },
        ];
        let law =
            beam_dynamics::elements::laws::Law::linear(nalgebra::SMatrix::<f64, 1, 1>::new(ea));
        b.elements.push(Box::new(Rod::new(
            "rod",
            ends,
            &b.nodes,
            Some(l0),
            (Measure::Strain, law),
        )));
        let r = Run::of(b.model(v(0., -g, 0.)), &TransientQuestion::new(to, h), 1);
        let t = Table::new(file);
        let mut e = [0f64; 2];
        for row in t.rows.iter().filter(|row| row[0] <= r.outcome.time + 1e-9) {
            if !r.instants.iter().any(|(t, _)| (t - row[0]).abs() < 1e-9) {
                continue;
            }
            let x = r.motion("mass", row[0]).position;
            if case == "bathe" {
                e[0] = e[0].max((x.x.atan2(-x.y).to_degrees() - row[1]).abs());
            } else {
                e[0] = e[0].max((x.x - row[1]).hypot(x.y - row[2]));
                e[1] = e[1].max((x.norm() - 1.0 - row[5]).abs());
            }
        }
        let first: Vec<_> = r
            .instants
            .iter()
            .take(6)
            .map(|(_, s)| s.nodes[0].position.norm() - l0)
            .collect();
        println!(
            "{case} {e:?} end {} {:?} {first:?} {:?}",
            r.outcome.time,
            r.outcome.failure.as_ref().map(|f| f.to_string()),
            r.outcome.effort
        );
    }
}
