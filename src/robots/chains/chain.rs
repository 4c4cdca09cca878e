//! Chains of elementary motions that are linear in the parameters at given joint values.
//!
//! Position and Jacobian come from the same sequence: the derivative with respect to a rotation is
//! axis × lever, with respect to a translation the axis (Corke, "A simple and systematic approach
//! to assigning Denavit–Hartenberg parameters", 2007).

use crate::State;
use etalon_base::pose::{Pose, Vector, cross, minus, turning_axes};
use etalon_base::scalar::Scalar;
use std::ops::Mul;

/// Weight of a rotation by one radian in a pose (mm).
pub(crate) const TURNED_MM: f64 = 1000.0;

/// Motion relative to the frame reached by the preceding motions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Motion {
    /// Rotation about axis 0, 1 or 2 (rad).
    Turn(usize),
    /// Translation along axis 0, 1 or 2 (mm).
    Shift(usize),
    /// Component 0, 1 or 2 of a rotation vector (rad). The three components are consecutive
    /// elements with consecutive parameters; the last element moves the frame.
    Attitude(usize),
    /// Constant displacement; terms lengthen its translation by their sum, as a ratio.
    Fixed(Pose),
}

/// Factor of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Coefficient {
    /// Constant factor.
    Constant(f64),
    /// `factor` · joint value + `offset` (rad or mm).
    Joint { joint: usize, factor: f64, offset: f64 },
    /// Sine or cosine of `order` times the angle of a joint.
    Harmonic { joint: usize, factor: f64, offset: f64, order: f64, sine: bool },
    /// `factor` times the direction of approach of a joint: +1 from below, −1 from above, 0 if not
    /// given. `at` is the position of the direction behind the joint values.
    Approach { at: usize, factor: f64 },
    /// `factor` · (value − `from`) of a value that each reading gives; 0 if it is not given. `at`
    /// is the position of the value behind the joint values.
    Stated { at: usize, from: f64, factor: f64 },
    /// Load on the chain, by its index.
    Load(usize),
}

/// A parameter with its factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Term {
    pub parameter: usize,
    pub coefficient: Coefficient,
}

impl Term {
    /// A parameter with factor one.
    pub fn new(parameter: usize) -> Self {
        Self { parameter, coefficient: Coefficient::Constant(1.0) }
    }
}

/// One motion by `constant` + Σ coefficient · parameter.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Element {
    pub motion: Motion,
    pub constant: f64,
    pub terms: Vec<Term>,
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
            Coefficient::Stated { at, from, factor } => {
                self.joints.get(at).map_or(J::from(0.0), |value| (*value + -from) * factor)
            }
            Coefficient::Load(load) => self.loads.get(load).copied().unwrap_or(J::from(0.0)),
        }
    }
}

impl State<'_> {
    /// Joint on which a coefficient depends, and derivative of the coefficient with respect to that
    /// joint's value at constant loads.
    fn rate(&self, coefficient: Coefficient) -> Option<(usize, f64)> {
        match coefficient {
            Coefficient::Joint { joint, factor, .. } => Some((joint, factor)),
            Coefficient::Harmonic { joint, factor, offset, order, sine } => {
                let (sin, cos) = ((self.joints[joint] * factor + offset) * order).sin_cos();
                Some((joint, order * factor * if sine { cos } else { -sin }))
            }
            Coefficient::Constant(_)
            | Coefficient::Approach { .. }
            | Coefficient::Stated { .. }
            | Coefficient::Load(_) => None,
        }
    }
}

/// Motion of an element at given parameters.
#[derive(Clone, Copy, Debug)]
enum Step<T = f64> {
    Nothing,
    /// Rotation about an axis by the angle with this sine and cosine.
    Turn(usize, T, T),
    Shift(usize, T),
    Place(Pose<T>),
}

impl<T: Scalar> Step<T> {
    fn turn(axis: usize, angle: T) -> Self {
        if angle.is_zero() {
            return Self::Nothing;
        }
        let (sin, cos) = angle.sin_cos();
        Self::Turn(axis, sin, cos)
    }

    /// Applies the motion to a frame.
    #[inline(always)]
    fn take(&self, pose: &mut Pose<T>) {
        match *self {
            Self::Nothing => {}
            Self::Shift(_, amount) if amount.is_zero() => {}
            Self::Turn(axis, sin, cos) => pose.turn_by(axis, sin, cos),
            Self::Shift(axis, amount) => pose.shift_by(axis, amount),
            Self::Place(ref place) => *pose = pose.then(place),
        }
    }
}

/// Direction of an element's axis in the world, and a point on the axis.
pub(crate) type Axis = (Vector, Vector);

impl Element {
    /// Parameters with their factors.
    pub fn coefficients<'a, J: Scalar>(&'a self, state: State<'a, J>) -> impl Iterator<Item = (usize, J)> + 'a {
        self.terms.iter().map(move |term| (term.parameter, state.coefficient(term)))
    }

    /// Frame after this motion of `pose`.
    pub fn advance<T: Scalar + Mul<J, Output = T>, J: Scalar>(
        &self,
        mut pose: Pose<T>,
        p: &[T],
        state: State<J>,
    ) -> Pose<T> {
        self.step(p, state).take(&mut pose);
        pose
    }

    /// Motion at the given parameters.
    #[inline]
    fn step<T: Scalar + Mul<J, Output = T>, J: Scalar>(&self, p: &[T], state: State<J>) -> Step<T> {
        let amount = || {
            self.coefficients(state)
                .fold(T::from(self.constant), |sum, (parameter, factor)| sum + p[parameter] * factor)
        };
        match self.motion {
            Motion::Turn(axis) => Step::turn(axis, amount()),
            Motion::Shift(axis) => Step::Shift(axis, amount()),
            Motion::Attitude(2) => Step::Place(Pose::from_rotation_vector(self.attitude(p))),
            Motion::Attitude(_) => Step::Nothing,
            Motion::Fixed(place) if self.terms.is_empty() => Step::Place(place.constant()),
            Motion::Fixed(place) => {
                let (longer, place) = (amount(), place.constant::<T>());
                Step::Place(Pose { translation_mm: place.translation_mm.map(|v| v + v * longer), ..place })
            }
        }
    }

    /// `true` if the motion depends on joints or loads.
    fn is_moved(&self) -> bool {
        self.terms.iter().any(|term| !matches!(term.coefficient, Coefficient::Constant(_)))
    }

    /// Rotation vector of which this element is a component.
    fn attitude<T: Scalar>(&self, p: &[T]) -> Vector<T> {
        let Motion::Attitude(component) = self.motion else { return [T::from(0.0); 3] };
        let first = self.terms.first().map_or(0, |term| term.parameter - component);
        [p[first], p[first + 1], p[first + 2]]
    }

    /// Axis of a motion that starts at `before`.
    #[inline]
    fn axis(&self, p: &[f64], before: &Pose) -> Axis {
        let direction = match self.motion {
            Motion::Turn(axis) | Motion::Shift(axis) => before.axis(axis),
            Motion::Attitude(component) => before.rotate(turning_axes(self.attitude(p))[component]),
            Motion::Fixed(_) if self.terms.is_empty() => [0.0; 3],
            Motion::Fixed(place) => before.rotate(place.translation_mm),
        };
        (direction, before.translation_mm)
    }

    /// Returns the velocity of a point per unit motion of this element about or along the given
    /// axis.
    pub fn velocity(&self, (direction, origin): Axis, point: Vector) -> Vector {
        match self.motion {
            Motion::Turn(_) | Motion::Attitude(_) => cross(direction, minus(point, origin)),
            Motion::Shift(_) | Motion::Fixed(_) => direction,
        }
    }

    /// Returns the angular velocity per unit motion of this element about or along the given axis.
    pub fn angular_velocity(&self, (direction, _): Axis) -> Vector {
        if matches!(self.motion, Motion::Turn(_) | Motion::Attitude(_)) { direction } else { [0.0; 3] }
    }
}

/// Final frame of a chain.
pub(crate) fn end<T: Scalar>(elements: &[Element], p: &[T], state: State) -> Pose<T> {
    elements.iter().fold(Pose::identity(), |pose, element| element.advance(pose, p, state))
}

/// A chain with its parameters; everything independent of joints and loads is computed once.
#[derive(Clone, Debug)]
pub(crate) struct Prepared<'a> {
    elements: &'a [Element],
    p: Vec<f64>,
    /// Axes of the elements before the first joint, and the frame that these elements reach.
    before: (Vec<Axis>, Pose),
    /// Motions of the later elements that are independent of joints and loads.
    still: Vec<Option<Step>>,
}

impl<'a> Prepared<'a> {
    /// Prepares a chain for the given parameters.
    pub fn new(elements: &'a [Element], parameters: &[f64]) -> Self {
        let p = parameters.to_vec();
        let nowhere = State::<f64> { joints: &[], loads: &[] };
        let first = elements.iter().position(Element::is_moved).unwrap_or(elements.len());
        let (mut axes, mut pose) = (Vec::with_capacity(first), Pose::identity());
        for element in &elements[..first] {
            axes.push(element.axis(&p, &pose));
            pose = element.advance(pose, &p, nowhere);
        }
        let still = elements[first..].iter().map(|e| (!e.is_moved()).then(|| e.step(&p, nowhere))).collect();
        Self { elements, p, before: (axes, pose), still }
    }

    /// Returns the final frame. Calls `visit` with the index of each element from the first joint
    /// on, and the frame before the element.
    #[inline(always)]
    pub fn run(&self, state: State, mut visit: impl FnMut(usize, &Pose)) -> Pose {
        let (first, mut pose) = (self.before.0.len(), self.before.1);
        for (i, (element, still)) in (first..).zip(self.elements[first..].iter().zip(&self.still)) {
            visit(i, &pose);
            match still {
                Some(step) => step.take(&mut pose),
                None => element.step(&self.p, state).take(&mut pose),
            }
        }
        pose
    }

    /// Final frame of the chain.
    pub fn end(&self, state: State) -> Pose {
        self.run(state, |_, _| {})
    }

    /// Final frame of the chain, and the axis of each element.
    pub fn trace(&self, state: State) -> (Pose, Vec<Axis>) {
        let mut axes = Vec::with_capacity(self.elements.len());
        axes.extend_from_slice(&self.before.0);
        let end = self.run(state, |i, before| axes.push(self.elements[i].axis(&self.p, before)));
        (end, axes)
    }

    /// Parameters of the chain.
    pub fn parameters(&self) -> &[f64] {
        &self.p
    }

    /// Motions due to joints at constant loads: element, axis of the element, joint, and motion of
    /// the element per unit of the joint value.
    pub fn rates<'s>(
        &'s self,
        state: State<'s>,
        axes: &'s [Axis],
    ) -> impl Iterator<Item = (&'s Element, Axis, usize, f64)> + 's {
        let behind = self.elements.iter().zip(axes).skip(self.before.0.len());
        behind.flat_map(move |(element, &axis)| {
            let moved = element.terms.iter().filter_map(move |term| {
                let (joint, rate) = state.rate(term.coefficient)?;
                Some((joint, rate * self.p[term.parameter]))
            });
            moved.map(move |(joint, rate)| (element, axis, joint, rate))
        })
    }
}
