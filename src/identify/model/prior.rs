//! Nominal values with tolerances, as rows of the residuals.
//!
//! With the prior, identification minimises Σ (r/σ)² + Σ ((p − p₀)/s)²; s is the tolerance t of a
//! parameter as the half-width of a rectangular distribution, s = t/√3 (GUM 4.3.7).

use etalon_robots::Robot;

/// Weight of nominal values in an identification.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Prior {
    /// No weight: plain least squares.
    #[default]
    None,
    /// One row for each free parameter: its deviation from nominal over its standard uncertainty by
    /// its tolerance.
    Tolerances {
        /// Standard deviation of a residual, by which the rows are multiplied to have the given
        /// weight; 1 if the given uncertainty of the instrument explains the residuals.
        weight: f64,
        /// Standard uncertainties of parts of the robot relative to the ones of default tolerances,
        /// if none are given: the data may show a more accurately built robot.
        scale: f64,
    },
}

impl Prior {
    /// Tolerances together with residuals of the given uncertainty.
    pub const TOLERANCES: Self = Self::Tolerances { weight: 1.0, scale: 1.0 };

    /// Factor of the rows of nominal values.
    pub(crate) fn weight(self) -> f64 {
        match self {
            Self::None => 1.0,
            Self::Tolerances { weight, .. } => weight,
        }
    }

    /// Standard uncertainty (mm, rad, 1) of the nominal value of a parameter: its tolerance as the
    /// half-width of a rectangular distribution (GUM 4.3.7), scaled if it is a default; `None` if
    /// the parameter has no tolerance, or nominal values do not count.
    pub fn uncertainty(self, robot: &dyn Robot, parameter: usize) -> Option<f64> {
        let Self::Tolerances { scale, .. } = self else { return None };
        let p = &robot.parameters()[parameter];
        let scale = if p.scales() { scale } else { 1.0 };
        (p.tolerance.is_finite() && p.tolerance > 0.0).then(|| scale * p.tolerance / 3f64.sqrt())
    }

    /// Returns this prior for residuals of this standard deviation.
    pub(crate) fn with_weight(self, weight: f64) -> Self {
        match self {
            Self::None => Self::None,
            Self::Tolerances { scale, .. } => Self::Tolerances { weight, scale },
        }
    }
}

/// Standard uncertainties of base and targets without tolerance, relative to the uncertainties of a
/// first estimate: wide enough to count as no knowledge, and narrow enough to keep the solution
/// bounded.
pub(crate) const DIFFUSE: f64 = 10.0;

/// The row of one parameter: w (p − p₀)/s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nominal {
    /// Index of the parameter.
    pub parameter: usize,
    /// Nominal value p₀.
    pub value: f64,
    /// Factor w/s.
    factor: f64,
}

impl Nominal {
    /// Rows of the free parameters. The expected values of parameters without tolerance are those
    /// in `values`.
    pub fn rows(robot: &dyn Robot, prior: Prior, free: &[usize], values: &[f64]) -> Vec<Self> {
        let Prior::Tolerances { weight, .. } = prior else { return Vec::new() };
        let row = |&parameter: &usize| {
            let p = &robot.parameters()[parameter];
            let (value, s) = match prior.uncertainty(robot, parameter) {
                Some(s) => (p.nominal, s),
                None => (values[parameter], DIFFUSE * p.known_within()),
            };
            Self { parameter, value, factor: weight / s }
        };
        free.iter().map(row).collect()
    }

    /// Value of the row.
    pub fn residual(&self, values: &[f64]) -> f64 {
        self.factor * (values[self.parameter] - self.value)
    }

    /// Derivative of the row with respect to its parameter.
    pub fn derivative(&self) -> f64 {
        self.factor
    }
}
