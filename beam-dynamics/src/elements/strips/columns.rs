//! Derivatives of a strip: of its loads on the nodes of its carrier and of its rows, by the motion of
//! the nodes and by its scalars.
//!
//! Q and g vary with the nodes of the carrier (see [`super::kinematics`]), so that all columns of a
//! node follow from the derivatives K of the loads and rows by Q, g, theta and omega:
//!
//! ```text
//! K_X = K_Q + K_g ([Omega]x - grad V)          K_T = K_theta - K_X [a]x - K_g [omega]x [a]x
//! by x_j          N_j K_X                      by x'_j       N_j K_g
//! by omega_j      N_j (K_omega - K_g [f_j + a]x)
//! by theta_j      K_T T_j - N_j (K_X [f_j]x + K_g [omega_j]x [f_j]x)
//! ```
//!
//! A vector load of the carried point acts on node j as in [`crate::elements::carried`].

use nalgebra::{Matrix3, RowVector3, Vector3};
use rotor_aero::strip::{FLOW as STRIP_FLOW, LOADS, STATES, StripJacobian};
use shared_geom::rotation::{product, skew, skew_skew, skew_times, times_skew};

use super::in_disk::{InDiskState, OF_DISK};
use super::kinematics::{FLOW, Flow};
use crate::elements::{Local, LocalJacobian};
use crate::model::Equation::{Force, Moment};
use crate::model::Variable;

/// Numbers of the flow that the kernel takes, before the radius of the tip.
pub(super) const OWN: usize = STRIP_FLOW - 2;
/// Index of the radius of the tip.
pub(super) const TIP: usize = OWN;
/// Index of the deflection of the flap.
pub(super) const FLAP: usize = TIP + 1;
/// Most rows: of the states, and of the loads of a disk.
const ROWS: usize = STATES + OF_DISK;
/// Blocks of the loads: force and moment on each of three nodes.
const OF_NODES: usize = 6;
/// Blocks of three rows each.
const BLOCKS: usize = OF_NODES + ROWS.div_ceil(3);

/// Derivatives of all loads and rows by one vector.
type Stack = [Matrix3<f64>; BLOCKS];

/// Forces of a strip at a state: F and M at the carried point [N, N m].
pub(super) struct Loads {
    /// F.
    pub force: Vector3<f64>,
    /// M.
    pub moment: Vector3<f64>,
    /// The moment about the quarter chord [N m].
    pub own: Vector3<f64>,
}

/// The derivatives of a strip at a state.
pub(super) struct Columns<'a> {
    /// Its flow.
    pub flow: &'a Flow<'a>,
    /// Its loads.
    pub loads: &'a Loads,
    /// Derivatives of its kernel.
    pub by: &'a StripJacobian,
    /// Its rows in a disk.
    pub in_disk: Option<&'a InDiskState<'a>>,
    /// Its length \[m\].
    pub length: f64,
    /// Number of its states.
    pub states: usize,
}

/// Rows of scalars: their indices, and their derivatives by the numbers of the flow.
struct Rows {
    indices: [usize; ROWS],
    by: [[f64; FLOW]; ROWS],
    count: usize,
}

impl Columns<'_> {
    /// Adds the derivatives by the motion of the nodes, with the index of the one of the shaft.
    pub fn add_nodes(&self, at: &Local<'_>, hub: Option<usize>, out: &mut LocalJacobian) {
        let rows = self.rows();
        let loads: [_; LOADS] = std::array::from_fn(|i| self.flow.slopes(&of_load(self.by, i)));
        let own: [_; ROWS] = std::array::from_fn(|i| {
            if i < rows.count {
                self.flow.slopes(&rows.by[i])
            } else {
                [RowVector3::zeros(); 4]
            }
        });
        let stack = |k: usize| self.stack(loads.map(|it| it[k]), &own[..rows.count], k, k == 2);
        let [mut by_position, by_velocity, mut by_axes, by_omega] = [0, 1, 2, 3].map(stack);
        let (arm, gradient) = (&self.flow.arm, self.flow.gradient());
        let turned = skew_skew(self.flow.turning(), arm);
        // K_X and K_T.
        for b in 0..OF_NODES + rows.count.div_ceil(3) {
            by_position[b] += product(&by_velocity[b], gradient);
            by_axes[b] -= times_skew(&by_position[b], arm) + product(&by_velocity[b], &turned);
        }
        for j in 0..self.flow.point.count {
            let share = &self.flow.point.shares[j];
            let (n, offset) = (share.weight, share.offset);
            let reach = offset + arm;
            let turned = n * skew_skew(&at.nodes[j].angular_velocity, &offset);
            let weighted = n * offset;
            self.add(&rows, (j, Variable::Position), out, |b| n * by_position[b]);
            self.add(&rows, (j, Variable::Velocity), out, |b| n * by_velocity[b]);
            self.add(&rows, (j, Variable::AngularVelocity), out, |b| {
                n * (by_omega[b] - times_skew(&by_velocity[b], &reach))
            });
            self.add(&rows, (j, Variable::Rotation), out, |b| {
                product(&by_axes[b], &share.turn)
                    - times_skew(&by_position[b], &weighted)
                    - product(&by_velocity[b], &turned)
            });
        }
        if let Some(hub) = hub {
            self.add_hub(&rows, hub, out);
        }
    }

    /// Adds the derivatives by the motion of the node of the shaft.
    fn add_hub(&self, rows: &Rows, hub: usize, out: &mut LocalJacobian) {
        let by_turn = self.flow.by_turn_of_hub();
        let slopes = |by: &[f64; FLOW]| self.flow.slopes_by_hub(by, &by_turn);
        let loads: [_; LOADS] = std::array::from_fn(|i| slopes(&of_load(self.by, i)));
        let own: [_; ROWS] = std::array::from_fn(|i| {
            if i < rows.count {
                slopes(&rows.by[i])
            } else {
                [RowVector3::zeros(); 2]
            }
        });
        for (k, variable) in [Variable::Position, Variable::Rotation]
            .into_iter()
            .enumerate()
        {
            let stack = self.stack(loads.map(|it| it[k]), &own[..rows.count], k, false);
            self.add(rows, (hub, variable), out, |b| stack[b]);
        }
    }

    /// The rows of the scalars.
    fn rows(&self) -> Rows {
        let mut rows = Rows {
            indices: std::array::from_fn(|i| i),
            by: [[0.0; FLOW]; ROWS],
            count: self.states,
        };
        for (row, by) in rows
            .by
            .iter_mut()
            .zip(&self.by.by[LOADS..])
            .take(self.states)
        {
            row[..OWN].copy_from_slice(&by[..OWN]);
        }
        let Some(in_disk) = self.in_disk else {
            return rows;
        };
        in_disk.add_to_first(&mut rows.by[0]);
        for (index, by) in in_disk.rows(&self.flow.numbers, self.by) {
            rows.indices[rows.count] = index;
            rows.by[rows.count] = by;
            rows.count += 1;
        }
        rows
    }

    /// The blocks of the loads and rows by vector `k` of their slopes, in theta with the turn of the
    /// loads.
    fn stack<const N: usize>(
        &self,
        loads: [RowVector3<f64>; LOADS],
        rows: &[[RowVector3<f64>; N]],
        k: usize,
        is_turn: bool,
    ) -> Stack {
        let axes = &self.flow.axes;
        let [x, y, z, m] = loads;
        let mut force = product(axes, &Matrix3::from_rows(&[x, y, z])) * self.length;
        let mut own = axes.column(2) * (m * self.length);
        if is_turn {
            force -= skew(&self.loads.force);
            own -= skew(&self.loads.own);
        }
        let mut moment = skew_times(&self.flow.arm, &force) + own;
        if is_turn {
            moment += skew_skew(&self.loads.force, &self.flow.arm);
        }
        let mut stack = [Matrix3::zeros(); BLOCKS];
        for (j, load) in self.flow.point.loads() {
            stack[2 * j] = load.force * force;
            stack[2 * j + 1] =
                product(&load.moment_by_force, &force) + product(&load.moment_by_moment, &moment);
        }
        for (i, row) in rows.iter().enumerate() {
            stack[OF_NODES + i / 3].set_row(i % 3, &row[k]);
        }
        stack
    }

    /// Adds blocks to the columns of a vector.
    fn add(
        &self,
        rows: &Rows,
        column: (usize, Variable),
        out: &mut LocalJacobian,
        of: impl Fn(usize) -> Matrix3<f64>,
    ) {
        for (j, _) in self.flow.point.loads() {
            out.add((j, Force), column, &of(2 * j));
            out.add((j, Moment), column, &of(2 * j + 1));
        }
        for (b, indices) in rows.indices[..rows.count].chunks(3).enumerate() {
            out.add_scalar_rows(indices, column, &of(OF_NODES + b));
        }
    }

    /// Adds column `input` of the kernel, times the slope of the input, as the derivatives by a
    /// scalar or its rate.
    pub fn add_scalar(
        &self,
        column: (usize, bool),
        (input, slope): (usize, f64),
        out: &mut LocalJacobian,
    ) {
        let of = |i: usize| slope * self.length * self.by.by[i][input];
        let force = self.flow.axes * Vector3::new(of(0), of(1), of(2));
        let moment = self.flow.arm.cross(&force) + self.flow.axes.column(2) * of(3);
        self.flow.point.add_by_scalar(column, &[force, moment], out);
        for row in 0..self.states {
            let by = slope * self.by.by[LOADS + row][input];
            out.add_scalar(row, column.0, by, column.1);
        }
        if let Some(in_disk) = self.in_disk {
            let by = (&self.flow.numbers, self.by);
            in_disk.add_scalar(by, column, (input, slope), out);
        }
    }
}

/// Derivatives of a load of the kernel by the numbers of the flow.
fn of_load(by: &StripJacobian, load: usize) -> [f64; FLOW] {
    let mut row = [0.0; FLOW];
    row[..OWN].copy_from_slice(&by.by[load][..OWN]);
    row
}
