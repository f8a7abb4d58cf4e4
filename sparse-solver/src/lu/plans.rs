//! Plans of earlier choices of pivots, in the order in which their matrices recur.

use std::sync::Arc;

use super::{Lu, Plan};
use crate::number::Number;
use crate::pattern::Pattern;

/// Smallest and largest number of stored plans: a factorization by a plan takes a fiftieth of the time
/// of a choice of pivots.
const MOST: [usize; 2] = [4, 16];
/// Entries of all matrices up to which more than the smallest number of plans is stored.
const ENTRIES: usize = 1_000_000;

/// Stored plans, and the one used last. Matrices often recur in an order, as the matrices of a rotor in
/// each revolution: after a plan, the plan of the next choice is tried first.
#[derive(Debug, Clone, Default)]
pub(crate) struct Plans {
    /// A ring in the order of choices.
    all: Vec<Arc<Plan>>,
    last: usize,
}

impl Plans {
    /// Factorizes by the first plan that suits and whose factors are accurate, from the last one on;
    /// not by `failed`.
    pub fn factorize<T: Number>(
        &mut self,
        values: &[T],
        failed: Option<&Arc<Plan>>,
    ) -> Option<Lu<T>> {
        let count = self.all.len();
        (0..count).find_map(|step| {
            let index = (self.last + step) % count;
            let plan = &self.all[index];
            if failed.is_some_and(|failed| Arc::ptr_eq(plan, failed)) {
                return None;
            }
            let lu = Lu::by_plan(plan, values).filter(Lu::is_trusted)?;
            self.last = index;
            Some(lu)
        })
    }

    /// Stores a plan for matrices on a pattern behind the last one. Of too many, the one before the last
    /// is removed: it would be needed latest.
    pub fn store(&mut self, plan: &Arc<Plan>, pattern: &Pattern) {
        let most = (ENTRIES / pattern.entries().max(1)).clamp(MOST[0], MOST[1]);
        if self.all.len() >= most {
            let before = (self.last + self.all.len() - 1) % self.all.len();
            self.all.remove(before);
            self.last -= usize::from(before < self.last);
        }
        let index = (self.last + 1).min(self.all.len());
        self.all.insert(index, Arc::clone(plan));
        self.last = index;
    }

    /// Removes all plans.
    pub fn clear(&mut self) {
        *self = Self::default();
    }
}
