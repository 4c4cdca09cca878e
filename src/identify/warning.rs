//! Warnings of an identification.

use crate::model::rigid_part::Contradicted;
use etalon_base::message::Message;
use std::ops::Deref;

/// A warning and its subject. The layer that knows the keys of a campaign adds the remedy.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// The warning.
    pub message: Message,
    /// Its subject.
    pub subject: Subject,
}

/// Subject of a warning.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// Parameters that the choice of base and targets fixes are held: others could be.
    HeldByFrames,
    /// The measurements contradict the stated shape of a part.
    Shape(Contradicted),
    /// A change of the set-up explains the measurements.
    SetUp(SetUpError),
    /// Anything that the message says completely.
    Other,
}

impl From<Message> for Warning {
    fn from(message: Message) -> Self {
        Self { message, subject: Subject::Other }
    }
}

impl Deref for Warning {
    type Target = Message;

    fn deref(&self) -> &Message {
        &self.message
    }
}

/// What states the part of a set-up that is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The unit of the measured points.
    Unit,
    /// The points that define the world frame.
    WorldFrame,
    /// The change itself names it.
    Named,
}

/// The change of a set-up that explains the measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct SetUpError {
    /// The change, and others that explain the data as well: "`q7` reversed".
    pub changes: Vec<(String, Origin)>,
    /// Root mean square error (mm) after an identification with the set-up as stated; infinite if a pose is out of reach.
    pub stated_mm: f64,
    /// Root mean square error (mm) with the change.
    pub changed_mm: f64,
}

impl SetUpError {
    /// What to look for; `statement` follows a change with where its origin is stated.
    pub fn hint(&self, statement: impl Fn(Origin) -> &'static str) -> String {
        let named: Vec<String> =
            self.changes.iter().map(|(what, origin)| format!("with {what}{}", statement(*origin))).collect();
        let [first, others @ ..] = &named[..] else { return String::new() };
        let others = match others {
            [] => String::new(),
            others => format!(" (as well {})", others.join(", ")),
        };
        let stated = match self.stated_mm.is_finite() {
            true if self.stated_mm > 2.0 * self.changed_mm => format!(" instead of {:.3} mm", self.stated_mm),
            true => ", and parameters that are no longer beyond their tolerances".to_owned(),
            false => "; without that poses are out of reach".to_owned(),
        };
        let left = format!("an identification leaves {:.3} mm (root mean square){stated}", self.changed_mm);
        format!("{first}{others}, {left}: check that first")
    }
}
