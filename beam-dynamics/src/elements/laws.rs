//! Constitutive laws: the force of a spring, a rod or a beam section from its strain.
//!
//! Of dimension N = 1 (rods), 3 (displacement, or rotation) or 6 (both, and beam
//! sections). A law is a sum of terms. With the strain eps, its rate and the time t, each
//! term gives
//!
//! ```text
//! f = g( eps - eps_0(t), eps' - eps_0'(t) ) + f_0(t)
//! ```
//!
//! with a prestrain eps_0 and a prestress f_0, each a constant vector times a drive, and
//! one of the functions g of [`LawKind`].

mod curve;
mod expression;
mod kind;
mod per_component;
mod quadratic;

#[cfg(test)]
mod tests;

use std::sync::Arc;

use nalgebra::{Matrix6, SMatrix, SVector, Vector6};

pub use curve::{Between, Curve, Extrapolation};
pub use expression::ExpressionLaw;
pub use kind::LawKind;
pub use per_component::{Bilinear, Cubic};
pub use quadratic::{Imposed, Quadratic};

use crate::elements::{Instant, Signal};
use crate::model::Scalar;

/// A force, with its derivatives by strain and by rate of strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response<const N: usize> {
    /// The force [N, N m].
    pub force: SVector<f64, N>,
    /// Its derivative by the strain [unit of force / unit of strain].
    pub by_strain: SMatrix<f64, N, N>,
    /// Its derivative by the rate of strain [unit of force s / unit of strain].
    pub by_rate: SMatrix<f64, N, N>,
}

impl<const N: usize> Response<N> {
    /// No force.
    pub fn zero() -> Self {
        Self {
            force: SVector::zeros(),
            by_strain: SMatrix::zeros(),
            by_rate: SMatrix::zeros(),
        }
    }
}

/// A constant vector times a signal.
#[derive(Debug, Clone, PartialEq)]
pub struct Driven<const N: usize> {
    /// The vector for the signal one [unit of strain or force].
    pub vector: SVector<f64, N>,
    /// Its factor [-].
    pub signal: Signal,
}

/// One term of a law.
#[derive(Debug, Clone, PartialEq)]
pub struct Term<const N: usize> {
    /// The function.
    pub kind: LawKind<N>,
    /// Strain at which the function vanishes.
    pub prestrain: Option<Driven<N>>,
    /// Force in addition to the function.
    pub prestress: Option<Driven<N>>,
}

impl<const N: usize> From<LawKind<N>> for Term<N> {
    fn from(kind: LawKind<N>) -> Self {
        Self {
            kind,
            prestrain: None,
            prestress: None,
        }
    }
}

impl<const N: usize> Term<N> {
    /// Strain and rate of strain less those without force.
    fn elastic(
        &self,
        strain: &SVector<f64, N>,
        rate: &SVector<f64, N>,
        now: &Instant<'_>,
    ) -> (SVector<f64, N>, SVector<f64, N>) {
        match &self.prestrain {
            None => (*strain, *rate),
            Some(Driven { vector, signal }) => {
                let free = signal.at(now);
                (strain - vector * free.value, rate - vector * free.rate)
            }
        }
    }
}

/// A constitutive law: the sum of its terms. A clone shares them.
#[derive(Debug, Clone, PartialEq)]
pub struct Law<const N: usize> {
    terms: Arc<Vec<Term<N>>>,
}

impl<const N: usize> From<LawKind<N>> for Law<N> {
    fn from(kind: LawKind<N>) -> Self {
        Self::sum(vec![kind.into()])
    }
}

impl<const N: usize> Law<N> {
    /// The sum of `terms`.
    pub fn sum(terms: Vec<Term<N>>) -> Self {
        Self {
            terms: Arc::new(terms),
        }
    }

    /// The same with further prestresses.
    pub fn prestressed(mut self, prestresses: impl IntoIterator<Item = Driven<N>>) -> Self {
        let stiffness = SMatrix::zeros();
        let term = |prestress| Term {
            kind: LawKind::Linear { stiffness },
            prestrain: None,
            prestress: Some(prestress),
        };
        let terms = Arc::make_mut(&mut self.terms);
        terms.extend(prestresses.into_iter().map(term));
        self
    }

    /// A linear law.
    pub fn linear(stiffness: SMatrix<f64, N, N>) -> Self {
        LawKind::Linear { stiffness }.into()
    }

    /// Localizes the indices of its signals in the `scalars` of an element.
    pub fn bind(&mut self, scalars: &mut Vec<Scalar>) {
        let has_signals = |term: &Term<N>| {
            let is_quadratic = matches!(term.kind, LawKind::Quadratic(_));
            is_quadratic || term.prestrain.is_some() || term.prestress.is_some()
        };
        if !self.terms.iter().any(has_signals) {
            return;
        }
        for term in Arc::make_mut(&mut self.terms) {
            let driven = [&mut term.prestrain, &mut term.prestress];
            for driven in driven.into_iter().flatten() {
                driven.signal.bind(scalars);
            }
            if let LawKind::Quadratic(law) = &mut term.kind {
                let imposed = law.imposed.iter_mut();
                imposed.for_each(|state| state.signal.bind(scalars));
            }
        }
    }

    /// The force at a strain, a rate of strain and an instant.
    pub fn at(
        &self,
        strain: &SVector<f64, N>,
        rate: &SVector<f64, N>,
        now: &Instant<'_>,
    ) -> Response<N> {
        let mut sum = Response::zero();
        self.add(strain, rate, now, &mut sum);
        sum
    }

    /// Adds the force at a strain, a rate of strain and an instant to `sum`.
    pub fn add(
        &self,
        strain: &SVector<f64, N>,
        rate: &SVector<f64, N>,
        now: &Instant<'_>,
        sum: &mut Response<N>,
    ) {
        for term in self.terms.iter() {
            let (strain, rate) = term.elastic(strain, rate, now);
            term.kind.add(&strain, &rate, now, sum);
            if let Some(Driven { vector, signal }) = &term.prestress {
                sum.force += vector * signal.value(now);
            }
        }
    }

    /// Calls `add` with the derivatives of the force by scalars: index of the scalar in the
    /// element, derivative, whether it is by the rate of the scalar.
    pub fn by_scalars(
        &self,
        strain: &SVector<f64, N>,
        rate: &SVector<f64, N>,
        now: &Instant<'_>,
        mut add: impl FnMut(usize, &SVector<f64, N>, bool),
    ) {
        for term in self.terms.iter() {
            let (strain, rate) = term.elastic(strain, rate, now);
            if let Some(Driven { vector, signal }) = &term.prestress {
                signal.gradient(now, |scalar, slope| add(scalar, &(slope * vector), false));
            }
            if let Some(Driven { vector, signal }) = &term.prestrain
                && signal.senses()
            {
                let mut response = Response::zero();
                term.kind.add(&strain, &rate, now, &mut response);
                let by_value = -response.by_strain * vector;
                signal.gradient(now, |scalar, slope| add(scalar, &(slope * by_value), false));
                if term.kind.is_viscous() {
                    let by_rate = -response.by_rate * vector;
                    signal.gradient_of_rate(now, |scalar, slope, of_rate| {
                        add(scalar, &(slope * by_rate), of_rate);
                    });
                }
            }
            if let LawKind::Quadratic(law) = &term.kind {
                law.by_scalars(&strain, now, &mut add);
            }
        }
    }

    /// Elastic energy at a strain: the energies of the terms that have one, and of the prestresses,
    /// `f_0 . eps` [J, or J per unit length].
    pub fn energy(&self, strain: &SVector<f64, N>, now: &Instant<'_>) -> f64 {
        let of_term = |term: &Term<N>| {
            let value = |driven: &Option<Driven<N>>| match driven {
                Some(driven) => driven.vector * driven.signal.value(now),
                None => SVector::zeros(),
            };
            let elastic = strain - value(&term.prestrain);
            term.kind.energy(&elastic, now) + value(&term.prestress).dot(strain)
        };
        self.terms.iter().map(of_term).sum()
    }

    /// Growth of the stiffness with a growth of the strain, by the terms whose force is
    /// quadratic.
    pub fn growth_of_stiffness(&self, growth: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        let mut sum = SMatrix::zeros();
        for term in self.terms.iter() {
            term.kind.add_growth(growth, &mut sum);
        }
        sum
    }

    /// Stiffness without strain, at the time zero, all scalars being zero.
    pub fn stiffness_at_rest(&self) -> SMatrix<f64, N, N> {
        let zero = SVector::zeros();
        self.at(&zero, &zero, &Instant::START).by_strain
    }

    /// Whether the force depends on the rate of strain.
    pub fn is_viscous(&self) -> bool {
        self.terms.iter().any(|term| term.kind.is_viscous())
    }

    /// Whether the force may have a kink or a jump.
    pub fn has_kinks(&self) -> bool {
        self.terms.iter().any(|term| term.kind.has_kinks())
    }

    /// Whether its forces without rates are the derivatives of an energy that does not change
    /// with the time.
    pub fn keeps_energy(&self) -> bool {
        let has_energy = |term: &Term<N>| !matches!(term.kind, LawKind::Expression(_));
        let mut signals = self.signals();
        self.terms.iter().all(has_energy) && signals.all(|signal| signal.constant().is_some())
    }

    /// The signals of prestrains, prestresses and imposed states.
    pub fn signals(&self) -> impl Iterator<Item = &Signal> {
        let terms = self.terms.iter();
        let driven = terms.flat_map(|term| [&term.prestrain, &term.prestress]);
        let driven = driven.flatten().map(|driven| &driven.signal);
        driven.chain(self.imposed().map(|state| &state.signal))
    }

    /// The imposed states of the terms whose force is quadratic.
    fn imposed(&self) -> impl Iterator<Item = &Imposed<N>> {
        self.terms.iter().flat_map(|term| match &term.kind {
            LawKind::Quadratic(law) => law.imposed.as_slice(),
            _ => &[],
        })
    }
}

impl Law<6> {
    /// Least and largest change of the stiffness by prestress, as parts of the stiffness itself
    /// \[-\]: the eigenvalues of its change by quadratic forces, compared with the rest. `None` for
    /// a law without quadratic force, or without stiffness.
    pub fn change_by_prestress(
        &self,
        strain: &Vector6<f64>,
        now: &Instant<'_>,
    ) -> Option<[f64; 2]> {
        let mut change = None;
        let zero = Vector6::zeros();
        let mut rest = Response::zero();
        for term in self.terms.iter() {
            match &term.kind {
                LawKind::Quadratic(law) => {
                    let mut response = Response::zero();
                    law.add(strain, now, &mut response);
                    let sum = change.get_or_insert_with(Matrix6::zeros);
                    *sum += response.by_strain;
                }
                kind => kind.add(&zero, &zero, now, &mut rest),
            }
        }
        let factor = rest.by_strain.cholesky()?.l();
        let half = factor.solve_lower_triangular(&change?)?;
        let whole = factor.solve_lower_triangular(&half.transpose())?;
        let parts = (0.5 * (whole + whole.transpose())).symmetric_eigenvalues();
        Some([parts.min(), parts.max()])
    }
}
