//! Messages of the steps of an identification, in the order of `parameters.json`.

use etalon_base::message::{Message, Severity};
use etalon_identify::Warning;

/// Messages of each step.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// An uncertainty beyond its bound.
    pub bound: Option<Message>,
    /// Implausible parameters, and readings to check first.
    pub plausibility: Vec<Message>,
    /// Remarks on the observations: selected, excluded, of other logs, commanded, or of validation
    /// alone.
    pub observations: Vec<Message>,
    /// Correlation of the residuals with the differences between logs.
    pub logs: Vec<Message>,
    /// Remarks on errors, effects and limits.
    pub evaluation: Vec<Message>,
    /// Remarks on the residual field.
    pub field: Vec<Message>,
    /// Difference from the robust fit.
    pub robust: Option<Message>,
}

impl Findings {
    /// `true` if a step or the solver reports an error.
    pub fn has_error(&self, solver: &[Warning]) -> bool {
        let steps = self.before_solver().chain(self.after_solver());
        steps.chain(solver.iter().map(|warning| &warning.message)).any(|message| message.severity == Severity::Error)
    }

    /// All messages, with the messages of the solver.
    ///
    /// A reader stops at the first message that explains the result, so causes precede
    /// consequences: first the reasons not to load the parameters, then faults of the observations,
    /// then actions of the solver, and last the consequences for errors and predictions.
    pub fn ordered(&self, solver: &[Warning]) -> Vec<Warning> {
        let before = self.before_solver().cloned().map(Into::into);
        let after = self.after_solver().cloned().map(Into::into);
        before.chain(solver.iter().cloned()).chain(after).collect()
    }

    fn before_solver(&self) -> impl Iterator<Item = &Message> {
        self.bound.iter().chain(&self.plausibility).chain(&self.observations)
    }

    fn after_solver(&self) -> impl Iterator<Item = &Message> {
        self.logs.iter().chain(&self.evaluation).chain(&self.field).chain(&self.robust)
    }
}
