//! The processor time of the calling thread covers all the work only if there is no other
//! thread.

/// Makes the calling thread the only one of rayon; panics where rayon has started its threads
/// already.
pub fn on_one_thread() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    pool.use_current_thread()
        .build_global()
        .expect("no threads yet");
}
