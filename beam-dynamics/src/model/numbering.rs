//! Indices of unknowns and equations in the vectors of the system, and their names.

/// Unknowns, and equations, of a node.
pub const NODE_UNKNOWNS: usize = 12;

/// The six motions of a node, in the order of its unknowns.
pub const MOTION_WORDS: [&str; 6] = [
    "displacement along x",
    "displacement along y",
    "displacement along z",
    "rotation about x",
    "rotation about y",
    "rotation about z",
];

/// Vector equations of a node, in the order of its rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Equation {
    /// Definition of the momentum [kg m/s].
    Momentum,
    /// Definition of the angular momentum about the node [kg m^2/s].
    AngularMomentum,
    /// Balance of forces [N].
    Force,
    /// Balance of moments about the node [N m].
    Moment,
}

impl Equation {
    /// All four, in order.
    pub const ALL: [Self; 4] = [
        Self::Momentum,
        Self::AngularMomentum,
        Self::Force,
        Self::Moment,
    ];

    /// First row of the equation among the rows of its node.
    pub fn row(self) -> usize {
        3 * self as usize
    }

    /// Description of the equation, without its axis.
    pub fn words(self) -> &'static str {
        match self {
            Self::Momentum => "definition of momentum along",
            Self::AngularMomentum => "definition of angular momentum about",
            Self::Force => "force balance along",
            Self::Moment => "moment balance about",
        }
    }

    /// Unit of the equation.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Momentum => "kg m/s",
            Self::AngularMomentum => "kg m^2/s",
            Self::Force => "N",
            Self::Moment => "N m",
        }
    }
}

/// Vector variables of a node with respect to which a residual is differentiated. Rotation is
/// the spatial rotation `theta` of `dR = [theta]x R`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variable {
    /// Position [m].
    Position,
    /// Rotation [rad].
    Rotation,
    /// Momentum [kg m/s].
    Momentum,
    /// Angular momentum [kg m^2/s].
    AngularMomentum,
    /// Velocity relative to the frame [m/s].
    Velocity,
    /// Angular velocity relative to the frame [rad/s].
    AngularVelocity,
    /// Rate of the momentum [N].
    MomentumRate,
    /// Rate of the angular momentum [N m].
    AngularMomentumRate,
}

impl Variable {
    /// All eight: four variables, then their rates in the same order.
    pub const ALL: [Self; 8] = [
        Self::Position,
        Self::Rotation,
        Self::Momentum,
        Self::AngularMomentum,
        Self::Velocity,
        Self::AngularVelocity,
        Self::MomentumRate,
        Self::AngularMomentumRate,
    ];

    /// First column of the variable among the columns of its node.
    pub fn column(self) -> usize {
        3 * (self as usize % 4)
    }

    /// The unknowns of a node, in the order of their columns.
    pub const UNKNOWNS: [Self; 4] = [
        Self::Position,
        Self::Rotation,
        Self::Momentum,
        Self::AngularMomentum,
    ];

    /// Description of the variable, without its axis.
    pub fn words(self) -> &'static str {
        match self {
            Self::Position => "position along",
            Self::Rotation => "rotation about",
            Self::Momentum => "momentum along",
            Self::AngularMomentum => "angular momentum about",
            Self::Velocity => "velocity along",
            Self::AngularVelocity => "angular velocity about",
            Self::MomentumRate => "rate of momentum along",
            Self::AngularMomentumRate => "rate of angular momentum about",
        }
    }

    /// Unit of the variable.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Position => "m",
            Self::Rotation => "rad",
            Self::Momentum => "kg m/s",
            Self::AngularMomentum => "kg m^2/s",
            Self::Velocity => "m/s",
            Self::AngularVelocity => "rad/s",
            Self::MomentumRate => "N",
            Self::AngularMomentumRate => "N m",
        }
    }

    /// Whether it is a rate.
    pub fn is_rate(self) -> bool {
        self as usize >= 4
    }
}

/// Order of the unknowns: twelve per node (position, rotation, momentum, angular momentum),
/// then the multipliers of each element in turn, then the scalars. The equations are in the
/// same order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Numbering {
    nodes: usize,
    /// First multiplier of each element, and the end.
    first_multiplier: Vec<usize>,
    /// First use of a scalar by each element, and the end.
    first_use: Vec<usize>,
    /// The scalar of each use.
    used: Vec<usize>,
    scalars: usize,
    /// Elements with memory, with the range of each in the memory.
    remembering: Vec<(usize, std::ops::Range<usize>)>,
}

impl Numbering {
    /// Numbers `nodes` nodes and elements with the given numbers of multipliers.
    pub fn new(nodes: usize, multipliers_of_elements: impl Iterator<Item = usize>) -> Self {
        Self {
            nodes,
            first_multiplier: firsts(multipliers_of_elements),
            first_use: Vec::new(),
            used: Vec::new(),
            scalars: 0,
            remembering: Vec::new(),
        }
    }

    /// The same with the scalars of the elements, in their order: the number of scalars of
    /// each element, and the index of each scalar used.
    #[must_use]
    pub fn with_scalars(self, counts: impl Iterator<Item = usize>, used: Vec<usize>) -> Self {
        Self {
            scalars: used.iter().max().map_or(0, |last| last + 1),
            first_use: firsts(counts),
            used,
            ..self
        }
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        NODE_UNKNOWNS * self.nodes + self.multipliers() + self.scalars
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// Number of multipliers.
    pub fn multipliers(&self) -> usize {
        self.first_multiplier.last().copied().unwrap_or(0)
    }

    /// Number of scalar unknowns.
    pub fn scalars(&self) -> usize {
        self.scalars
    }

    /// The scalars of an element in its own order, as indices among the scalars.
    pub fn scalars_of(&self, element: usize) -> &[usize] {
        &self.used[self.first_use[element]..self.first_use[element + 1]]
    }

    /// The same with the memory of the elements, given by the number of values of each.
    #[must_use]
    pub fn with_memory(self, counts: impl Iterator<Item = usize>) -> Self {
        let mut end = 0;
        let ranges = counts.enumerate().map(|(element, count)| {
            end += count;
            (element, end - count..end)
        });
        let remembering = ranges.filter(|(_, range)| !range.is_empty()).collect();
        Self {
            remembering,
            ..self
        }
    }

    /// Length of the memory of all elements.
    pub fn memory(&self) -> usize {
        self.remembering.last().map_or(0, |last| last.1.end)
    }

    /// Elements with memory, with their parts of it.
    pub fn remembering(&self) -> &[(usize, std::ops::Range<usize>)] {
        &self.remembering
    }

    /// The part of the memory that belongs to an element.
    pub fn memory_of(&self, element: usize) -> std::ops::Range<usize> {
        let index = self.remembering.binary_search_by_key(&element, |own| own.0);
        index.map_or(0..0, |index| self.remembering[index].1.clone())
    }

    /// Index of the first multiplier among the unknowns.
    pub fn first_multiplier(&self) -> usize {
        NODE_UNKNOWNS * self.nodes
    }

    /// Index of the first scalar unknown.
    pub fn first_scalar(&self) -> usize {
        self.first_multiplier() + self.multipliers()
    }

    /// Index of the first unknown of a node.
    pub fn node(&self, node: usize) -> usize {
        NODE_UNKNOWNS * node
    }

    /// Multipliers of an element, as indices among the multipliers.
    pub fn multipliers_of(&self, element: usize) -> std::ops::Range<usize> {
        self.first_multiplier[element]..self.first_multiplier[element + 1]
    }

    /// Index of the first multiplier of an element among the unknowns.
    pub fn first_multiplier_of(&self, element: usize) -> usize {
        self.first_multiplier() + self.first_multiplier[element]
    }
}

/// The first index of each range of the given lengths, and the end.
fn firsts(counts: impl Iterator<Item = usize>) -> Vec<usize> {
    let ends = counts.scan(0, |end, count| {
        *end += count;
        Some(*end)
    });
    std::iter::once(0).chain(ends).collect()
}
