//! Motions that are damped beyond oscillation.

// A bar on a hinge with a damper beyond the critical one, I s^2 + c s + k = 0 with I = 1 kg m^2, and a mass
// on springs that oscillates faster; the constraints of the hinge add nothing.
#[test]
fn overdamped_motions_have_their_time_constants() {
    const DAMPING: f64 = 15.0;
    const STIFFNESS: f64 = 20.0;
    let text = format!(
        "units = \"SI\"\n[[node]]\nname = \"base\"\nposition = [0, 0, 0]\n[[clamp]]\nnode = \"base\"\n\
         [[node]]\nname = \"bar\"\nposition = [0, 0, 0.5]\n[[body]]\nnode = \"bar\"\nmass = 1\n\
         inertia = [0.5, 0.75, 0.5]\n[[hinge]]\nname = \"hinge\"\nnodes = [\"base\", \"bar\"]\n\
         axis = [0, 1, 0]\noffset = [0, 0, -0.5]\nstiffness = {STIFFNESS:?}\ndamping = {DAMPING:?}\n\
         [[node]]\nname = \"mass\"\nposition = [1, 0, 0]\n[[body]]\nnode = \"mass\"\nmass = 2\n\
         inertia = [1, 1, 1]\n[[spring]]\nnode = \"mass\"\nstiffness = [2e3, 3e3, 4e3]\n\
         rotational_stiffness = [5e3, 6e3, 7e3]\n[modes]\nspeeds = 0\ncount = 6\n"
    );
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bar.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    let table = crate::case_files::table(&file);
    let root = (DAMPING * DAMPING - 4.0 * STIFFNESS).sqrt();
    let expected = [0.5 * (root - DAMPING), -0.5 * (root + DAMPING)];
    assert_eq!(table.decaying[0].len(), 2, "{:?}", table.decaying);
    for (motion, expected) in table.decaying[0].iter().zip(expected) {
        assert!(
            (motion.growth / expected - 1.0).abs() < 1e-8,
            "{motion:?} {expected}"
        );
        assert!((motion.time_constant() * expected + 1.0).abs() < 1e-8);
    }
}
