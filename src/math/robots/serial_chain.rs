//! A serial chain as a sequence of elementary motions, each linear in the parameters once the joints are known.
//!
//! Position and Jacobian come from the same sequence: the derivative by a rotation is axis × lever, by a translation
//! the axis (Corke, "A simple and systematic approach to assigning Denavit–Hartenberg parameters", 2007).

use crate::base::pose::{Pose, Vector, cross, minus};
use crate::base::scalar::Scalar;

/// A rotation about, or a translation along, an axis of the moving frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Motion {
    /// Rotation about axis 0, 1 or 2, in radians.
    Turn(usize),
    /// Translation along axis 0, 1 or 2, in millimetres.
    Shift(usize),
}

/// One motion by `constant` + Σ coefficient · parameter.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub motion: Motion,
    pub constant: f64,
    /// Range of this step in [`Chain::terms`].
    pub terms: std::ops::Range<usize>,
}

/// The motions from the world to the flange for one set of joint values.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain {
    pub steps: Vec<Step>,
    /// (parameter, coefficient)
    pub terms: Vec<(usize, f64)>,
}

impl Chain {
    /// Adds a motion by `constant` + Σ coefficient · parameter.
    pub fn push(&mut self, motion: Motion, constant: f64, terms: impl IntoIterator<Item = (usize, f64)>) {
        let first = self.terms.len();
        self.terms.extend(terms);
        self.steps.push(Step { motion, constant, terms: first..self.terms.len() });
    }

    /// Amount of a step.
    fn amount<T: Scalar>(&self, step: &Step, p: &[T]) -> T {
        let start = T::from(step.constant);
        self.terms[step.terms.clone()].iter().fold(start, |sum, &(i, c)| sum + p[i] * c)
    }

    /// Pose of the flange in the world.
    pub fn flange<T: Scalar>(&self, p: &[T]) -> Pose<T> {
        self.steps.iter().fold(Pose::identity(), |pose, step| advance(pose, step.motion, self.amount(step, p)))
    }

    /// Pose of the flange, and of each step its axis in the world with a point on it before the motion.
    pub fn trace(&self, p: &[f64], axes: &mut Vec<(Vector, Vector)>) -> Pose {
        axes.clear();
        self.steps.iter().fold(Pose::identity(), |pose, step| {
            let (Motion::Turn(axis) | Motion::Shift(axis)) = step.motion;
            axes.push((pose.axis(axis), pose.translation_mm));
            advance(pose, step.motion, self.amount(step, p))
        })
    }
}

fn advance<T: Scalar>(pose: Pose<T>, motion: Motion, amount: T) -> Pose<T> {
    match motion {
        Motion::Turn(0) => pose.turn_x(amount),
        Motion::Turn(1) => pose.turn_y(amount),
        Motion::Turn(_) => pose.turn_z(amount),
        Motion::Shift(axis) => pose.shift(axis, amount),
    }
}

/// Velocity of a point of the flange when a step moves by one.
pub(super) fn velocity(motion: Motion, (axis, origin): (Vector, Vector), point: Vector) -> Vector {
    match motion {
        Motion::Turn(_) => cross(axis, minus(point, origin)),
        Motion::Shift(_) => axis,
    }
}
