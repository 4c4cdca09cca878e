//! Warnings of an identification.

use crate::model::rigid_part::Contradicted;
use etalon_base::catalogue::{IntoArgument, Phrase};
use etalon_base::message::Message;
use etalon_base::phrase;
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
    /// Parameters are held that the choice of base and targets fixes; others could be held instead.
    HeldByFrames,
    /// The measurements contradict the given shape of a part.
    Shape(Contradicted),
    /// A change of the set-up explains the measurements.
    SetUp(SetUpError),
    /// Any other subject; no remedy is added to the message.
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

/// Wrong part of a set-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The unit of the measured points.
    Unit,
    /// The points that define the world frame.
    WorldFrame,
    /// The change itself names the part.
    Named,
}

/// Ratio of standard deviations that is worth telling.
const FALLS: f64 = 1.5;

/// Change of a set-up that explains the measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct SetUpError {
    /// The change, and others that explain the data equally well: "`q7` reversed".
    pub changes: Vec<(Phrase, Origin)>,
    /// Standard deviation (mm) of a coordinate at poses excluded from an identification with the
    /// set-up as given; infinite if a pose is out of reach.
    pub stated_mm: f64,
    /// Standard deviation (mm) with the change.
    pub changed_mm: f64,
    /// Standard deviations (rad) of measured orientations, as given and with the change; 0 if none
    /// are measured.
    pub angles_rad: [f64; 2],
}

impl SetUpError {
    /// Hint at the change. `statement` returns the place where the wrong part is given, if a layer
    /// above knows it.
    pub fn to_check(&self, statement: impl Fn(Origin) -> Option<Phrase>) -> Phrase {
        let named = self.changes.iter().map(|(slip, origin)| {
            let origin = statement(*origin).map_or_else(|| "none".argument(), |stated| stated.argument());
            phrase!("with-slip", slip, origin)
        });
        let named: Vec<Phrase> = named.collect();
        let (first, others) = named.split_first().map_or(("none".argument(), &named[..]), |(f, o)| (f.argument(), o));
        let others = if others.is_empty() { "none".argument() } else { others.argument() };
        let [stated_rad, changed_rad] = self.angles_rad;
        let stated = match self.stated_mm.is_finite() {
            true if stated_rad > FALLS * changed_rad => "angles",
            true if self.stated_mm > FALLS * self.changed_mm => "residuals",
            true => "tolerances",
            false => "unreachable",
        };
        let [stated_deg, changed_deg] = self.angles_rad.map(f64::to_degrees);
        phrase!(
            "set-up-slip",
            first,
            others,
            changed_mm = self.changed_mm,
            stated,
            stated_mm = self.stated_mm,
            stated_deg,
            changed_deg
        )
    }
}
