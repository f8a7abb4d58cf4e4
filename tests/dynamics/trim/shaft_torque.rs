//! The speed of a rotor at a torque of its shaft, in forward flight.

use super::trimmed;

// Blades in their plane without lift, of a drag that does not depend on the angle: in the wind V their sections have
// U = W r + V sin(psi), so that the mean torque of N blades is N rho c c_d / 2 (W^2 A + V^2 B / 2) with the integrals A
// and B of r^3 and r. The speed is a parameter of the file; the blades are stiff to 1e-6, and the strips integrate r^3
// exactly.
#[test]
fn the_speed_at_a_torque_of_the_shaft() {
    const WIND: f64 = 6.0;
    let [root, tip, chord, drag, density] = [0.2_f64, 1.2, 0.05, 0.02, 1.2];
    let omega = 31.0;
    let [third, first] = [4, 2].map(|n| (tip.powi(n) - root.powi(n)) / f64::from(n));
    let part = 3.0 * 0.5 * density * chord * drag;
    let torque = part * (omega * omega * third + 0.5 * WIND * WIND * first);
    let cards = format!(
        "[parameters]\nspeed = {:?}\n[properties.strip]\nea = 7e9\ngay = 2e9\ngaz = 2e9\ngj = 3e7\neiy = 4e7\n\
         eiz = 4e7\nm = 2\niy = 1e-5\niz = 1e-5\n[air]\ndensity = {density:?}\nwind = [{WIND:?}, 0, 0]\n\
         [airfoils.plate]\nslope = 1e-9\ndrag = {drag:?}\n\
         [[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = 3\nspeed = \"= speed\"\n\
         [rotor.blade]\nhub_radius = {root:?}\nproperties = \"strip\"\npiece = [{{ length = 1, elements = 1 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 4\nstations = [\n\
         {{ at = 0, chord = {chord:?}, airfoil = \"plate\" }}, {{ at = 1, chord = {chord:?}, airfoil = \"plate\" }} ]\n\
         [sensors.torque]\nquantity = \"reaction_moment\"\nof = \"r/shaft\"\nnode = \"r/hub\"\ncomponent = \"z\"\n\
         [periodic]\nspeed = \"= speed\"\nsteps = 24\n\
         [trim]\ntolerance = 1e-8\n[[trim.control]]\nname = \"speed\"\nscale = 10\n\
         [[trim.target]]\nname = \"shaft\"\nsignal = \"= torque\"\nvalue = {torque:?}\nscale = {torque:?}\n",
        0.7 * omega
    );
    let found = trimmed(&cards)[0].controls[0];
    assert!((found / omega - 1.0).abs() < 1e-6, "{found} {omega}");
}
