//! What the solver did, step by step.

/// One step that was tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Steps taken before this one.
    pub iteration: usize,
    /// What it was, and whether it was taken.
    pub kind: StepKind,
    /// Sum of squares (or of losses) before it.
    pub cost: f64,
    /// Its length relative to the parameters, both in the scale of the Jacobian's columns.
    pub step: f64,
    /// Cosine between the residuals and the free columns of the Jacobian before it; NaN where no factor was formed.
    pub gradient: f64,
    /// Radius of the trust region in the scale of the Jacobian's columns; infinite for a Gauss-Newton step.
    pub radius: f64,
    /// Damping λ; zero for a Gauss-Newton step.
    pub damping: f64,
}

/// What a step was, and whether it was taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// In the trust region, taken.
    Damped,
    /// In the trust region, but it did not lower the cost.
    Refused,
    /// Undamped, on a fresh factor of the Jacobian.
    GaussNewton,
    /// Undamped, on the factor of an earlier point.
    FactorTakenOver,
}
