//! Names of the unknowns and equations of a system, and their units.

use super::System;
use crate::elements::{ConstraintWords, Queries};
use crate::model::{Equation, NODE_UNKNOWNS, Name, Scalar, Variable};

const AXES: [&str; 3] = ["x", "y", "z"];

impl System {
    /// The equation at an index of the residual.
    pub fn equation(&self, index: usize) -> Name {
        if let Some((node, row)) = self.of_node(index) {
            let equation = Equation::ALL[row / 3];
            let what = format!("{} {}", equation.words(), AXES[row % 3]);
            return Name::of_node(what, node, equation.unit());
        }
        if let Some(scalar) = self.of_scalar(index) {
            let equation = &scalar.equation;
            return Name::of_element(equation.name.clone(), &scalar.owner, equation.unit.clone());
        }
        match self.of_constraint(index) {
            Some((label, words)) => Name::of_element(words.held, label, words.unit),
            None => Name::of_system(format!("equation {index}"), "-"),
        }
    }

    /// The unknown at an index.
    pub fn unknown(&self, index: usize) -> Name {
        if let Some((node, column)) = self.of_node(index) {
            let variable = Variable::UNKNOWNS[column / 3];
            let what = format!("{} {}", variable.words(), AXES[column % 3]);
            return Name::of_node(what, node, variable.unit());
        }
        if let Some(scalar) = self.of_scalar(index) {
            let unknown = &scalar.unknown;
            return Name::of_element(unknown.name.clone(), &scalar.owner, unknown.unit.clone());
        }
        match self.of_constraint(index) {
            Some((label, words)) => Name::of_element(words.reaction, label, words.reaction_unit),
            None => Name::of_system(format!("unknown {index}"), "-"),
        }
    }

    /// The name of the node to which an index belongs, and the index in its rows.
    fn of_node(&self, index: usize) -> Option<(&str, usize)> {
        let node = self.nodes.get(index / NODE_UNKNOWNS)?;
        Some((&node.label, index % NODE_UNKNOWNS))
    }

    /// The scalar at an index.
    fn of_scalar(&self, index: usize) -> Option<&Scalar> {
        self.scalars
            .get(index.checked_sub(self.numbering.first_scalar())?)
    }

    /// The label of the element to which the constraint at an index belongs, and the terms for it.
    fn of_constraint(&self, entry: usize) -> Option<(&str, ConstraintWords)> {
        let number = entry.checked_sub(NODE_UNKNOWNS * self.nodes.len())?;
        let mut elements = self.elements.iter().enumerate();
        let (index, element) =
            elements.find(|(index, _)| self.numbering.multipliers_of(*index).contains(&number))?;
        let constraint = number - self.numbering.multipliers_of(index).start;
        Some((element.label(), element.constraint_words(constraint)))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::elements::joints::clamped;
    use crate::model::Node;

    #[test]
    fn every_index_has_its_name_and_unit() {
        let node = |label: &str| Node {
            label: label.to_owned(),
            position: Vector3::zeros(),
            rotation: Matrix3::identity(),
        };
        let nodes = vec![node("root"), node("tip")];
        let clamp = clamped("hold", 1, &nodes[1]);
        let system = System::new(nodes, vec![Box::new(clamp)]);
        for (index, equation, unknown) in [
            (
                1,
                "definition of momentum along y of node \"root\" kg m/s",
                "position along y of node \"root\" m",
            ),
            (
                11,
                "moment balance about z of node \"root\" N m",
                "angular momentum about z of node \"root\" kg m^2/s",
            ),
            (
                15,
                "definition of angular momentum about x of node \"tip\" kg m^2/s",
                "rotation about x of node \"tip\" rad",
            ),
            (
                26,
                "offset along z of axes a of \"hold\" m",
                "force along z of axes a of \"hold\" N",
            ),
            (
                27,
                "rotation about x of axes a of \"hold\" rad",
                "moment about x of axes a of \"hold\" N m",
            ),
            (30, "equation 30 -", "unknown 30 -"),
        ] {
            let reported = |name: Name| format!("{name} {}", name.unit);
            assert_eq!(reported(system.equation(index)), equation);
            assert_eq!(reported(system.unknown(index)), unknown);
        }
    }
}
