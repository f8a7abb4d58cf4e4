//! Joints that are constraints and nothing else.

/// Makes an element of a type with a `joint`: all is told by that.
macro_rules! is_a_joint {
    ($name:ident) => {
        impl crate::elements::Element for $name {
            fn label(&self) -> &str {
                self.joint.label()
            }

            fn nodes(&self) -> &[usize] {
                self.joint.nodes()
            }

            fn multipliers(&self) -> usize {
                self.joint.multipliers()
            }

            fn level(&self, constraint: usize) -> crate::elements::Level {
                self.joint.level(constraint)
            }

            fn constraint_words(&self, constraint: usize) -> crate::elements::ConstraintWords {
                self.joint.constraint_words(constraint)
            }

            fn constraint_rates(
                &self,
                at: &crate::elements::Local<'_>,
                out: &mut crate::elements::ConstraintRates<'_>,
            ) -> bool {
                self.joint.constraint_rates(at, out)
            }

            fn reach(&self) -> f64 {
                self.joint.reach()
            }

            fn scalars(&self) -> &[crate::model::Scalar] {
                self.joint.scalars()
            }

            fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a crate::elements::Signal)) {
                self.joint.each_signal(visit);
            }

            fn jump(
                &self,
                between: [&crate::model::Loading; 2],
                scalars: crate::model::Scalars<'_>,
            ) -> Option<crate::elements::PlaceJump> {
                self.joint.jump(between, scalars)
            }

            fn is_turned_over(&self, at: &crate::elements::Local<'_>) -> bool {
                self.joint.is_turned_over(at)
            }

            fn residual(
                &self,
                at: &crate::elements::Local<'_>,
                out: &mut crate::elements::LocalResidual,
            ) {
                self.joint.residual(at, out);
            }

            fn jacobian(
                &self,
                at: &crate::elements::Local<'_>,
                out: &mut crate::elements::LocalJacobian,
            ) {
                self.joint.jacobian(at, out);
            }

            fn by_factor(
                &self,
                at: &crate::elements::Local<'_>,
                out: &mut crate::elements::LocalResidual,
            ) {
                self.joint.by_factor(at, out);
            }

            fn observe(
                &self,
                at: &crate::elements::Local<'_>,
                out: &mut crate::elements::Observations,
            ) {
                self.joint.observe(at, out);
            }
        }
    };
}

pub(crate) use is_a_joint;
