//! Chains of elementary motions, each linear in the parameters once the joints are known.
//!
//! Position and Jacobian come from the same sequence: the derivative by a rotation is axis × lever, by a translation the axis
//! (Corke, "A simple and systematic approach to assigning Denavit–Hartenberg parameters", 2007).

use crate::base::pose::{Pose, Vector, cross, minus, turning_axes};
use crate::base::scalar::Scalar;
use std::ops::Mul;

/// A motion of the frame that the motions before it have reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Motion {
    /// Rotation about axis 0, 1 or 2, in radians.
    Turn(usize),
    /// Translation along axis 0, 1 or 2, in millimetres.
    Shift(usize),
    /// Component 0, 1 or 2 of a rotation vector, in radians: three elements in this order, of three parameters in a row. The last of
    /// them moves the frame.
    Attitude(usize),
    /// To a constant place.
    Fixed(Pose),
}

/// What a parameter is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Coefficient {
    /// A number.
    Constant(f64),
    /// factor · joint value + offset (rad or mm).
    Joint { joint: usize, factor: f64, offset: f64 },
    /// Sine or cosine of `order` times the angle of a joint.
    Harmonic { joint: usize, factor: f64, offset: f64, order: f64, sine: bool },
    /// A number times the direction from which a joint came, +1 from below, -1 from above, by its place behind the joint values; 0 where
    /// it is not stated.
    Approach { at: usize, factor: f64 },
    /// A load on the chain, by its number.
    Load(usize),
}

/// A parameter and what it is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Term {
    pub parameter: usize,
    pub coefficient: Coefficient,
}

impl Term {
    /// A parameter by itself.
    pub fn of(parameter: usize) -> Self {
        Self { parameter, coefficient: Coefficient::Constant(1.0) }
    }
}

/// One motion by `constant` + Σ coefficient · parameter.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Element {
    pub motion: Motion,
    pub constant: f64,
    pub terms: Vec<Term>,
}

/// What a chain depends on beside its parameters.
#[derive(Clone, Copy)]
pub(super) struct State<'a, J = f64> {
    /// Joint values, rad or mm.
    pub joints: &'a [J],
    /// Loads.
    pub loads: &'a [J],
}

impl<J: Scalar> State<'_, J> {
    fn coefficient(&self, term: &Term) -> J {
        match term.coefficient {
            Coefficient::Constant(value) => J::from(value),
            Coefficient::Joint { joint, factor, offset } => self.joints[joint] * factor + offset,
            Coefficient::Harmonic { joint, factor, offset, order, sine } => {
                let (sin, cos) = ((self.joints[joint] * factor + offset) * order).sin_cos();
                if sine { sin } else { cos }
            }
            Coefficient::Approach { at, factor } => {
                self.joints.get(at).map_or(J::from(0.0), |direction| *direction * factor)
            }
            Coefficient::Load(load) => self.loads.get(load).copied().unwrap_or(J::from(0.0)),
        }
    }
}

impl State<'_> {
    /// The joint that moves a coefficient, and its derivative by that joint's value, loads as they are.
    pub fn rate(&self, coefficient: Coefficient) -> Option<(usize, f64)> {
        match coefficient {
            Coefficient::Joint { joint, factor, .. } => Some((joint, factor)),
            Coefficient::Harmonic { joint, factor, offset, order, sine } => {
                let (sin, cos) = ((self.joints[joint] * factor + offset) * order).sin_cos();
                Some((joint, order * factor * if sine { cos } else { -sin }))
            }
            Coefficient::Constant(_) | Coefficient::Approach { .. } | Coefficient::Load(_) => None,
        }
    }
}

/// Axis of an element in the world, and a point on it.
pub(super) type Axis = (Vector, Vector);

impl Element {
    /// Parameters and what they are multiplied by.
    pub fn coefficients<'a, J: Scalar>(&'a self, state: State<'a, J>) -> impl Iterator<Item = (usize, J)> + 'a {
        self.terms.iter().map(move |term| (term.parameter, state.coefficient(term)))
    }

    /// The frame after this motion of `pose`.
    pub fn advance<T: Scalar + Mul<J, Output = T>, J: Scalar>(
        &self,
        pose: Pose<T>,
        p: &[T],
        state: State<J>,
    ) -> Pose<T> {
        match self.motion {
            Motion::Turn(axis) | Motion::Shift(axis) => {
                let amount = self
                    .coefficients(state)
                    .fold(T::from(self.constant), |sum, (parameter, factor)| sum + p[parameter] * factor);
                match (self.motion, axis) {
                    _ if amount.is_zero() => pose,
                    (Motion::Shift(_), _) => pose.shift(axis, amount),
                    (_, 0) => pose.turn_x(amount),
                    (_, 1) => pose.turn_y(amount),
                    _ => pose.turn_z(amount),
                }
            }
            Motion::Attitude(2) => pose.then(&Pose::from_rotation_vector(self.attitude(p))),
            Motion::Attitude(_) => pose,
            Motion::Fixed(place) => pose.then(&place.constant()),
        }
    }

    /// The rotation vector that this element is a component of.
    fn attitude<T: Scalar>(&self, p: &[T]) -> Vector<T> {
        let Motion::Attitude(component) = self.motion else { return [T::from(0.0); 3] };
        let first = self.terms.first().map_or(0, |term| term.parameter - component);
        [p[first], p[first + 1], p[first + 2]]
    }

    /// Axis of the motion where it begins at `before` and ends at `after`.
    fn axis(&self, p: &[f64], before: &Pose) -> Axis {
        let direction = match self.motion {
            Motion::Turn(axis) | Motion::Shift(axis) => before.axis(axis),
            Motion::Attitude(component) => before.rotate(turning_axes(self.attitude(p))[component]),
            Motion::Fixed(_) => [0.0; 3],
        };
        (direction, before.translation_mm)
    }

    /// Velocity of a point when this element, of this axis, moves by one.
    pub fn velocity(&self, (direction, origin): Axis, point: Vector) -> Vector {
        match self.motion {
            Motion::Turn(_) | Motion::Attitude(_) => cross(direction, minus(point, origin)),
            Motion::Shift(_) => direction,
            Motion::Fixed(_) => [0.0; 3],
        }
    }

    /// Angular velocity when this element, of this axis, moves by one.
    pub fn angular_velocity(&self, (direction, _): Axis) -> Vector {
        if matches!(self.motion, Motion::Turn(_) | Motion::Attitude(_)) { direction } else { [0.0; 3] }
    }
}

/// The frame that a chain reaches.
pub(super) fn end<T: Scalar>(elements: &[Element], p: &[T], state: State) -> Pose<T> {
    elements.iter().fold(Pose::identity(), |pose, element| element.advance(pose, p, state))
}

/// The frame that a chain reaches, and the axis of each element.
pub(super) fn trace(elements: &[Element], p: &[f64], state: State, axes: &mut Vec<Axis>) -> Pose {
    axes.clear();
    elements.iter().fold(Pose::identity(), |pose, element| {
        axes.push(element.axis(p, &pose));
        element.advance(pose, p, state)
    })
}
