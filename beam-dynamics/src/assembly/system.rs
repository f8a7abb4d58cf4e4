//! The sum of all elements.

use crate::elements::{Element, Local, LocalJacobian, LocalSize, Observations, Queries};
use std::sync::Arc;

use kind::{Kind, Kinds};
pub use layout::Workspace;
use layout::{Gathered, Layout};
pub use loops::Loop;
use parts::Task;
pub use scalars::ScalarScales;
pub use sharing::{Contradiction, Sharing, Slack};
use size::Lengths;

use super::{Combination, Pattern, Sparse};
use crate::elements::bodies::NodeBalance;
use crate::model::{Conditions, Node, Numbering, Scalar, State};

mod constraints;
mod energy;
mod growth;
mod kind;
mod layout;
mod loops;
mod memory;
mod names;
mod observe;
mod parts;
mod rates;
mod removal;
mod scalars;
mod sharing;
mod size;
mod step;

/// A model as a system of equations `F(y, y') = 0`.
#[derive(Debug, Clone)]
pub struct System {
    nodes: Vec<Node>,
    elements: Vec<Arc<dyn Element>>,
    numbering: Numbering,
    /// Scalar unknowns by their numbers.
    scalars: Vec<Scalar>,
    pattern: Arc<Pattern>,
    /// Indices of the unknowns and equations of each element.
    layouts: Vec<Layout>,
    /// The different kinds of elements.
    kinds: Vec<Kind>,
    /// Loops in which constraints share their loads, and their compliance [m/N].
    loops: Vec<Loop>,
    compliance: f64,
    /// Size of the model [m].
    size: f64,
}

/// Residual, and the terms relative to which each equation is measured.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Residual {
    /// The residual [unit of each equation].
    pub values: Vec<f64>,
    /// Sum of the absolute values of the terms [unit of each equation].
    pub sizes: Vec<f64>,
}

/// Jacobian of a system: `F_y` and `F_y'` on one pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct Tangent {
    /// Derivatives by the unknowns.
    pub by_unknowns: Sparse,
    /// Derivatives by the rates of the unknowns.
    pub by_rates: Sparse,
}

impl System {
    /// The system of `nodes` and `elements`. The balance of momentum of every node
    /// is added here.
    pub fn new(nodes: Vec<Node>, elements: Vec<Box<dyn Element>>) -> Self {
        let balances = nodes.iter().enumerate().map(|(i, node)| {
            let balance: Box<dyn Element> = Box::new(NodeBalance::new(&node.label, i));
            balance
        });
        let elements = balances.chain(elements).map(Arc::from).collect();
        Self::of(nodes, elements)
    }

    /// The system of all elements, the balances of the nodes first.
    fn of(nodes: Vec<Node>, elements: Vec<Arc<dyn Element>>) -> Self {
        let counts = elements.iter().map(|element| element.multipliers());
        let used = elements.iter().flat_map(|element| element.scalars());
        let (used, scalars) = Scalar::number(used);
        let uses = elements.iter().map(|element| element.scalars().len());
        let memory = elements.iter().map(|element| element.memory_size());
        let numbering = Numbering::new(nodes.len(), counts)
            .with_scalars(uses, used)
            .with_memory(memory);
        let mut system = Self {
            pattern: Arc::new(Pattern::new(0, Vec::new())),
            layouts: Vec::new(),
            kinds: Vec::new(),
            loops: Vec::new(),
            compliance: 0.0,
            size: 1.0,
            nodes,
            elements,
            numbering,
            scalars,
        };
        system.find_pattern();
        system
    }

    /// Adds the Jacobian of every element once, and stores the indices of its entries.
    fn find_pattern(&mut self) {
        let state = State::at_rest(&self.nodes, &self.numbering);
        let conditions = Conditions::at_rest();
        let n = self.numbering.unknowns() + self.surpluses();
        let mut indices = Vec::with_capacity(self.elements.len());
        let (mut lengths, mut kinds) = (Lengths::default(), Kinds::default());
        for (index, element) in self.elements.iter().enumerate() {
            let mut jacobian = LocalJacobian::new(LocalSize::of(element.as_ref()));
            let mut gathered = Gathered::default();
            let at = self.gather(index, (&state, &conditions), None, &mut gathered);
            element.jacobian(&at, &mut jacobian);
            lengths.add(element.as_ref(), &jacobian);
            let own = self.numbering.scalars_of(index).iter();
            let has_rate = own.map(|&i| self.scalars[i].has_rate).collect();
            let kind = kinds.index(&jacobian, has_rate);
            let rows = Layout::rows(element.as_ref(), index, &self.numbering);
            indices.push((rows, kind));
        }
        self.size = self.size_with(&lengths);
        let pattern = Pattern::of(n, |add| {
            // The diagonal is always stored: the factorization may shift it.
            (0..n).for_each(|i| add(i, i));
            for (rows, kind) in &indices {
                let own = kinds.all[*kind].entries();
                own.for_each(|(i, j)| add(rows[i], rows[j]));
            }
            self.shared_entries()
                .for_each(|(row, column)| add(row, column));
        });
        let layout = |(rows, kind)| Layout::new(rows, (kind, &kinds.all[kind]), &pattern);
        self.layouts = indices.into_iter().map(layout).collect();
        self.kinds = kinds.all;
        self.pattern = Arc::new(pattern);
    }

    /// Nodes of the model.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Order of the unknowns.
    pub fn numbering(&self) -> &Numbering {
        &self.numbering
    }

    /// The pattern of the Jacobian, found once: the unknowns, then the surpluses (see
    /// [`Self::surpluses`]).
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Elements, the balances of the nodes first.
    pub fn elements(&self) -> impl Iterator<Item = &dyn Element> {
        self.elements.iter().map(AsRef::as_ref)
    }

    /// The undeformed state at rest.
    pub fn rest(&self) -> State {
        State::at_rest(&self.nodes, &self.numbering)
    }

    /// The residual at a state.
    pub fn residual(&self, state: &State, conditions: &Conditions) -> Residual {
        let mut residual = Residual::default();
        self.residual_into(state, conditions, &mut residual, &mut self.workspace());
        residual
    }

    /// The Jacobian at a state, with respect to the spatial variations of the unknowns.
    pub fn tangent(&self, state: &State, conditions: &Conditions) -> Tangent {
        let [mut by_unknowns, mut by_rates] =
            [(); 2].map(|()| Sparse::zero(Arc::clone(&self.pattern)));
        let mut out = [
            Combination::by_unknowns(&mut by_unknowns),
            Combination::by_rates(&mut by_rates),
        ];
        self.sum_tangent(state, conditions, &mut out);
        Tangent {
            by_unknowns,
            by_rates,
        }
    }

    /// The part of [`Self::tangent`] with respect to the unknowns, `F_y`.
    pub fn by_unknowns(&self, state: &State, conditions: &Conditions) -> Sparse {
        let mut by_unknowns = Sparse::zero(Arc::clone(&self.pattern));
        let mut out = [Combination::by_unknowns(&mut by_unknowns)];
        self.sum_tangent(state, conditions, &mut out);
        by_unknowns
    }

    fn sum_tangent(&self, state: &State, conditions: &Conditions, out: &mut [Combination<'_>]) {
        let task = Task {
            at: (state, conditions),
            derivatives: Some(&[]),
        };
        self.sum_all(&task, out, None, &mut self.workspace());
    }

    /// Observations of the elements at a state.
    pub fn observe(&self, state: &State, conditions: &Conditions) -> Observations {
        let mut observations = Observations::default();
        for (index, element) in self.elements.iter().enumerate() {
            let call = |at: &Local<'_>| element.observe(at, &mut observations);
            self.seen(index, state, conditions, call);
        }
        observations
    }
}
