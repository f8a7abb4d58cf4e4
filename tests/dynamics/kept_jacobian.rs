//! A Jacobian that is kept over the steps of a run and turns with the model.

use beam_dynamics::input;
use beam_dynamics::integrator::Jacobians;

use crate::in_time::Run;

/// Steps of a half revolution at 300 rpm, 256 to a revolution.
const STEPS: usize = 128;
/// Against the default with strips.
const FULL: &str = "newton = { method = \"full\" }\n";

/// Four blades on flap hinges, with lagged sections and the inflow of Pitt and Peters, in a wind of
/// `advance` times the speed of the tips across the shaft.
fn rotor(advance: f64, method: &str) -> String {
    let wind = advance * 5.0 * 300.0_f64.to_radians() * 6.0;
    format!(
        "units = {{ length = \"m\", force = \"N\", angle = \"deg\", rotation_speed = \"rpm\" }}\n\
         [properties.spar]\nea = 7e7\ngay = 2e7\ngaz = 2e7\ngj = 3e5\neiy = 2e5\neiz = 4e5\n\
         m = 6\niy = 1e-3\niz = 1e-2\n\
         [air]\ndensity = 1.225\nwind = [{wind}, 0, -2]\n\
         [[rotor]]\nname = \"main\"\nhub = \"articulated\"\nblades = 4\nspeed = 300\nmass = 80\n\
         inertia = [1, 1, 2]\n[rotor.inflow]\nkind = \"Pitt-Peters\"\n\
         [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\n\
         piece = [{{ length = 4.8, elements = 2 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"lagged\"\nstrips = 2\nstations = [\n\
         {{ at = 0.6, chord = 0.3, twist = 6, airfoil = \"naca0012\" }},\n\
         {{ at = 4.8, chord = 0.3, twist = 0, airfoil = \"naca0012\" }}]\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\n\
         [rotor.swashplate]\ncollective = \"= 3*deg\"\ncosine = \"= 0.5*deg\"\nsine = \"= 0\"\n\
         [transient]\nto = 0.1\nstep = 0.00078125\n{method}"
    )
}

fn run(advance: f64, method: &str) -> Run {
    let input = input::parse(&rotor(advance, method), "rotor.dynamics.toml");
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    let settings = input.transient.unwrap();
    let expected = match method {
        "" => Jacobians::Modified,
        _ => Jacobians::Full,
    };
    assert_eq!(settings.newton.jacobians, expected);
    let run = Run::of_any(input.model, &settings, STEPS);
    run.check_end();
    run
}

/// Without wind across the shaft the Jacobian of the turning rotor is nearly the same in all steps;
/// with it, the speeds of the air at the blades change around the azimuth. Both end where a run with a
/// Jacobian in each step does: the error that is left in each of 128 steps is 1e-12 of a size of the
/// model of 5 m.
#[test]
fn a_turning_rotor_keeps_its_jacobian() {
    for (advance, most) in [(0.0, STEPS / 10), (0.2, STEPS / 4)] {
        let [full, kept] = [FULL, ""].map(|method| run(advance, method));
        let efforts = [&full, &kept].map(|run| run.outcome.effort);
        assert!(efforts[0].jacobians >= STEPS, "{:?}", efforts[0]);
        assert!(efforts[1].jacobians < most, "{advance} {:?}", efforts[1]);
        assert!(
            efforts[1].iterations < 5 * STEPS,
            "{advance} {:?}",
            efforts[1]
        );
        let [full, kept] = [&full, &kept].map(|run| &run.instants[run.instants.len() - 1].1);
        for (full, kept) in full.nodes.iter().zip(&kept.nodes) {
            let apart = (full.position - kept.position).norm();
            assert!(apart < 1e-9, "{advance} {apart:.1e} m");
        }
    }
}
