//! The processor time of the calling thread covers all the work only if there is no other
//! thread.

/// Lets rayon have one thread; panics where it has started its threads already.
pub fn on_one_thread() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    pool.build_global().expect("no threads yet");
}
