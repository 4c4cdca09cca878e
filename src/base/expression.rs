//! Formulas as data: a number type that records its computation, with common subexpressions merged,
//! and derivatives.

use super::scalar::Scalar;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// One step of a formula; its operands are the numbers of preceding steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Operation {
    /// Constant, by its bit pattern.
    Constant(u64),
    /// Input, by its number.
    Input(usize),
    /// Sum a + b.
    Add(usize, usize),
    /// Difference a − b.
    Subtract(usize, usize),
    /// Product a b.
    Multiply(usize, usize),
    /// Quotient a / b.
    Divide(usize, usize),
    /// Negation −a.
    Negate(usize),
    /// Square root.
    Sqrt(usize),
    /// Sine of an angle (rad).
    Sin(usize),
    /// Cosine of an angle (rad).
    Cos(usize),
    /// Angle of the vector (second, first) (rad).
    Atan2(usize, usize),
    /// Angle wrapped to (−π, π] (rad).
    Wrap(usize),
}

impl Operation {
    /// Operands of the operation.
    pub fn operands(self) -> impl Iterator<Item = usize> {
        let (a, b) = match self {
            Self::Constant(_) | Self::Input(_) => (None, None),
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) | Self::Atan2(a, b) => {
                (Some(a), Some(b))
            }
            Self::Negate(a) | Self::Sqrt(a) | Self::Sin(a) | Self::Cos(a) | Self::Wrap(a) => (Some(a), None),
        };
        a.into_iter().chain(b)
    }
}

/// A function without branches.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Name of the function: `direct`, `inverse`, ...
    pub name: &'static str,
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Steps, each after its operands.
    pub steps: Vec<Operation>,
    /// Names of the outputs, and numbers of their steps.
    pub outputs: Vec<(String, usize)>,
}

#[derive(Default)]
struct Recorder {
    steps: Vec<Operation>,
    known: BTreeMap<Operation, usize>,
}

thread_local! {
    static RECORDER: RefCell<Recorder> = RefCell::default();
}

/// A number that records its computation within [`Formula::record`] on the same thread.
#[derive(Clone, Copy, Debug)]
pub struct Recorded(usize);

impl Formula {
    /// Records `function`, which must not branch on the values of its inputs.
    pub fn record(
        name: &'static str,
        inputs: &[String],
        function: impl FnOnce(&[Recorded]) -> Vec<(String, Recorded)>,
    ) -> Self {
        RECORDER.take();
        let variables: Vec<Recorded> = (0..inputs.len()).map(|i| step(Operation::Input(i))).collect();
        let outputs: Vec<(String, usize)> = function(&variables).into_iter().map(|(name, v)| (name, v.0)).collect();
        let steps = RECORDER.take().steps;
        Self { name, inputs: inputs.to_vec(), steps, outputs }.without_unused()
    }

    fn without_unused(self) -> Self {
        let mut used = vec![false; self.steps.len()];
        self.outputs.iter().for_each(|(_, i)| used[*i] = true);
        for (i, step) in self.steps.iter().enumerate().rev() {
            if used[i] {
                step.operands().for_each(|operand| used[operand] = true);
            }
        }
        let mut place = vec![0; used.len()];
        let mut steps = Vec::new();
        for (i, step) in self.steps.into_iter().enumerate().filter(|(i, _)| used[*i]) {
            place[i] = steps.len();
            let at = |i: usize| place[i];
            steps.push(match step {
                Operation::Add(a, b) => Operation::Add(at(a), at(b)),
                Operation::Subtract(a, b) => Operation::Subtract(at(a), at(b)),
                Operation::Multiply(a, b) => Operation::Multiply(at(a), at(b)),
                Operation::Divide(a, b) => Operation::Divide(at(a), at(b)),
                Operation::Atan2(a, b) => Operation::Atan2(at(a), at(b)),
                Operation::Negate(a) => Operation::Negate(at(a)),
                Operation::Sqrt(a) => Operation::Sqrt(at(a)),
                Operation::Sin(a) => Operation::Sin(at(a)),
                Operation::Cos(a) => Operation::Cos(at(a)),
                Operation::Wrap(a) => Operation::Wrap(at(a)),
                other => other,
            });
        }
        let outputs = self.outputs.into_iter().map(|(name, i)| (name, place[i])).collect();
        Self { steps, outputs, ..self }
    }
}

/// Recorded derivatives of numbers with respect to an input.
pub fn derivatives(of: &[Recorded], by: Recorded) -> Vec<Recorded> {
    let steps = RECORDER.with_borrow(|recorder| recorder.steps.clone());
    let mut all: Vec<Recorded> = Vec::with_capacity(steps.len());
    for (i, operation) in steps.into_iter().enumerate() {
        let (this, n) = (Recorded(i), Recorded);
        let one = |a: usize, slope: Recorded| all[a] * slope;
        let next = match operation {
            Operation::Constant(_) | Operation::Input(_) => Recorded::from(f64::from(u8::from(i == by.0))),
            Operation::Add(a, b) => all[a] + all[b],
            Operation::Subtract(a, b) => all[a] - all[b],
            Operation::Multiply(a, b) => all[a] * n(b) + n(a) * all[b],
            Operation::Divide(a, b) => (all[a] - this * all[b]) / n(b),
            Operation::Negate(a) => -all[a],
            Operation::Sqrt(a) => all[a] / (this * 2.0),
            Operation::Sin(a) => one(a, n(a).sin_cos().1),
            Operation::Cos(a) => one(a, -n(a).sin_cos().0),
            Operation::Atan2(y, x) => (n(x) * all[y] - n(y) * all[x]) / (n(x) * n(x) + n(y) * n(y)),
            Operation::Wrap(a) => all[a],
        };
        all.push(next);
    }
    of.iter().map(|v| all[v.0]).collect()
}

/// Number of an operation: an earlier equal step, or the constant it evaluates to.
fn step(operation: Operation) -> Recorded {
    RECORDER.with_borrow_mut(|recorder| {
        let next = recorder.steps.len();
        let number = *recorder.known.entry(operation).or_insert(next);
        if number == next {
            recorder.steps.push(operation);
        }
        Recorded(number)
    })
}

impl Recorded {
    fn constant(self) -> Option<f64> {
        RECORDER.with_borrow(|recorder| match recorder.steps[self.0] {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        })
    }

    /// Applies a unary operation.
    fn one(self, operation: fn(usize) -> Operation, value: fn(f64) -> f64) -> Self {
        self.constant().map_or_else(|| step(operation(self.0)), |v| Self::from(value(v)))
    }
}

impl From<f64> for Recorded {
    fn from(value: f64) -> Self {
        step(Operation::Constant(value.to_bits()))
    }
}

impl Add for Recorded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match (self.constant(), other.constant()) {
            (Some(a), Some(b)) => Self::from(a + b),
            (Some(0.0), _) => other,
            (_, Some(0.0)) => self,
            _ => step(Operation::Add(self.0.min(other.0), self.0.max(other.0))),
        }
    }
}

impl Sub for Recorded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        match (self.constant(), other.constant()) {
            (Some(a), Some(b)) => Self::from(a - b),
            (Some(0.0), _) => -other,
            (_, Some(0.0)) => self,
            _ => step(Operation::Subtract(self.0, other.0)),
        }
    }
}

impl Mul for Recorded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match (self.constant(), other.constant()) {
            (Some(a), Some(b)) => Self::from(a * b),
            (Some(0.0), _) | (_, Some(1.0)) => self,
            (_, Some(0.0)) | (Some(1.0), _) => other,
            (Some(-1.0), _) => -other,
            (_, Some(-1.0)) => -self,
            _ => step(Operation::Multiply(self.0.min(other.0), self.0.max(other.0))),
        }
    }
}

impl Div for Recorded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        match (self.constant(), other.constant()) {
            (Some(a), Some(b)) => Self::from(a / b),
            (Some(0.0), _) | (_, Some(1.0)) => self,
            _ => step(Operation::Divide(self.0, other.0)),
        }
    }
}

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        let negated = RECORDER.with_borrow(|recorder| match recorder.steps[self.0] {
            Operation::Negate(a) => Some(Self(a)),
            _ => None,
        });
        negated.unwrap_or_else(|| self.one(Operation::Negate, |v| -v))
    }
}

impl Mul<f64> for Recorded {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self * Self::from(factor)
    }
}

impl Add<f64> for Recorded {
    type Output = Self;
    fn add(self, term: f64) -> Self {
        self + Self::from(term)
    }
}

impl Scalar for Recorded {
    /// Value of a constant; NaN for numbers that depend on inputs.
    fn value(self) -> f64 {
        self.constant().unwrap_or(f64::NAN)
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.one(Operation::Sin, f64::sin), self.one(Operation::Cos, f64::cos))
    }
    fn atan2(self, x: Self) -> Self {
        match (self.constant(), x.constant()) {
            (Some(y), Some(x)) => Self::from(y.atan2(x)),
            _ => step(Operation::Atan2(self.0, x.0)),
        }
    }
    fn sqrt(self) -> Self {
        self.one(Operation::Sqrt, f64::sqrt)
    }
    fn wrapped(self) -> Self {
        self.one(Operation::Wrap, Scalar::wrapped)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Evaluates a formula.
    fn evaluate(formula: &Formula, inputs: &[f64]) -> Vec<f64> {
        let mut all: Vec<f64> = Vec::new();
        for step in &formula.steps {
            let v = |i: usize| all[i];
            let next = match *step {
                Operation::Constant(bits) => f64::from_bits(bits),
                Operation::Input(i) => inputs[i],
                Operation::Add(a, b) => v(a) + v(b),
                Operation::Subtract(a, b) => v(a) - v(b),
                Operation::Multiply(a, b) => v(a) * v(b),
                Operation::Divide(a, b) => v(a) / v(b),
                Operation::Negate(a) => -v(a),
                Operation::Sqrt(a) => v(a).sqrt(),
                Operation::Sin(a) => v(a).sin(),
                Operation::Cos(a) => v(a).cos(),
                Operation::Atan2(y, x) => v(y).atan2(v(x)),
                Operation::Wrap(a) => Scalar::wrapped(v(a)),
            };
            all.push(next);
        }
        formula.outputs.iter().map(|(_, i)| all[*i]).collect()
    }

    fn sample<T: Scalar>(x: T, y: T) -> T {
        let (sin, cos) = (x * y).sin_cos();
        let same = (x * y).sin_cos().0 * 1.0 + T::from(0.0);
        ((sin / (cos + 2.0) - x.tan()).atan2(y) * 5.0).wrapped() + (x * x + y * y * 3.0).sqrt() + (-x) - same
    }

    #[test]
    fn what_is_recorded_is_computed_once_and_its_derivatives_are_limits_of_differences() {
        let names = ["x", "y"].map(str::to_owned);
        let formula = Formula::record("sample", &names, |v| {
            let f = sample(v[0], v[1]);
            let by = v.iter().map(|v| derivatives(&[f], *v)[0]).collect::<Vec<_>>();
            vec![("f".to_owned(), f), ("by_x".to_owned(), by[0]), ("by_y".to_owned(), by[1])]
        });
        let (x, y, h) = (0.3, 1.7, 1e-6);
        let [f, by_x, by_y] = evaluate(&formula, &[x, y])[..] else { panic!("{formula:?}") };
        assert_eq!(f, sample(x, y));
        assert!((by_x - (sample(x + h, y) - sample(x - h, y)) / (2.0 * h)).abs() < 1e-8);
        assert!((by_y - (sample(x, y + h) - sample(x, y - h)) / (2.0 * h)).abs() < 1e-8);
        let sines = formula.steps.iter().filter(|step| matches!(step, Operation::Sin(_))).count();
        assert_eq!(sines, 2, "of x y and of x: {:?}", formula.steps);
        let constant = Formula::record("constant", &names, |v| {
            vec![("c".to_owned(), v[0] * 0.0 + sample(v[0] * 0.0 + 0.3, 1.7.into()))]
        });
        assert_eq!(constant.steps.len(), 1, "{constant:?}");
    }
}
