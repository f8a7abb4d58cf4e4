//! Forces that read the energy of the model.

use std::fs;

use beam_dynamics::elements::EnergyPart;
use beam_dynamics::model::State;

use crate::in_time::Run;

fn run(cards: &str) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sensed.dynamics.toml");
    fs::write(&path, format!("units = \"SI\"\n{cards}")).unwrap();
    Run::of_file(&path, 1, |_| ())
}

fn sensed(run: &Run, name: &str) -> impl Fn(&State) -> f64 {
    let scalars = run.model.system.scalars();
    let index = scalars.iter().position(|scalar| scalar.owner == name);
    let index = index.unwrap();
    move |state| state.scalars[index]
}

// A push along the velocity proportional to the missing energy: `E' = 2 k E (E_0 - E) / m`, the
// logistic curve. The energy is exact except for the error of the schemes, of order two: (h E_0
// k/m)^2, and of the velocity, which enters with its square.
#[test]
fn a_force_by_the_energy_follows_the_logistic_curve() {
    let run = run("
[[node]]
name = \"cart\"
position = [0, 0, 0]
velocity = [1, 0, 0]
[[body]]
node = \"cart\"
mass = 2
inertia = [1, 1, 1]
[sensors.energy]
quantity = \"kinetic_energy\"
[sensors.speed]
quantity = \"velocity\"
of = \"cart\"
component = \"x\"
[[load]]
node = \"cart\"
force = [1, 0, 0]
drive = \"= 1.5*(4 - energy)*speed\"
[transient]
to = 2
step = 0.001
");
    assert!(run.outcome.failure.is_none(), "{:?}", run.outcome.failure);
    let energy = sensed(&run, "energy");
    for (time, state) in &run.instants {
        let exact = 4.0 / (1.0 + 3.0 * (-6.0 * time).exp());
        let off = (energy(state) - exact).abs();
        assert!(off < 1e-5, "{time}: {} {exact}", energy(state));
    }
}

const SHAKEN: &str = "
[gravity]
acceleration = [0, -1, -9.81]
[properties.p]
ea = 1e6
gay = 1e5
gaz = 1.2e5
gj = 10
eiy = 11
eiz = 30
m = 1.1
iy = 1e-3
iz = 2e-3
damping = { time = 1e-3 }
[[blade]]
name = \"b\"
properties = \"p\"
[[blade.piece]]
length = 1
elements = 3
[[body]]
node = \"b/tip\"
mass = 0.3
inertia = [0.01, 0.02, 0.02]
[[spring]]
node = \"b/tip\"
stiffness = [50, 60, 70]
[sensors.moving]
quantity = \"kinetic_energy\"
[sensors.bent]
quantity = \"elastic_energy\"
[sensors.high]
quantity = \"gravity_energy\"
[sensors.all]
quantity = \"energy\"
unit = \"J\"
[[load]]
node = \"b/tip\"
force = [0, 1, 2]
drive = \"= 3*sin(t) - moving + 0.5*bent + 0.1*high - 0.05*all\"
[transient]
to = 0.5
step = 0.005
";

// A soft beam with a body on a spring at its tip, pushed by a force that follows all energies: the
// values of sensors agree with the model, and the steps take few Newton iterations.
#[test]
fn sensors_have_the_energies_of_the_model() {
    let run = run(SHAKEN);
    assert!(run.outcome.failure.is_none(), "{:?}", run.outcome.failure);
    assert!(
        run.outcome.effort.iterations < 400,
        "{:?}",
        run.outcome.effort
    );
    let sensors = [
        ("moving", EnergyPart::Kinetic),
        ("bent", EnergyPart::Elastic),
        ("high", EnergyPart::Gravity),
        ("all", EnergyPart::Total),
    ];
    for (name, part) in sensors {
        let sensor = sensed(&run, name);
        let mut largest = 0.0_f64;
        for (time, state) in &run.instants {
            let conditions = run.model.conditions_at(*time);
            let energy = run.model.system.energy(state, &conditions).part(part);
            let off = (sensor(state) - energy).abs();
            assert!(off < 1e-8, "{name} {time}: {} {energy}", sensor(state));
            largest = largest.max(energy.abs());
        }
        assert!(largest > 0.1, "{name}: {largest}");
    }
}
