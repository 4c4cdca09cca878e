//! ISO 9283: poses, recorded motions, compliance, and the layout of a test.

mod load;
mod motion;
mod path;
mod plan;
mod pose;

pub use load::*;
pub use motion::*;
pub use path::*;
pub use plan::*;
pub use pose::*;

use crate::LimitVerdict;
use etalon_base::message::Message;

/// Converts angles to degrees.
fn degrees(angles_rad: &[f64]) -> Vec<f64> {
    angles_rad.iter().map(|angle| angle.to_degrees()).collect()
}

/// Converts plain results to their document forms.
fn all<T, D: From<T>>(results: Vec<T>) -> Vec<D> {
    results.into_iter().map(Into::into).collect()
}

/// Results of all kinds of tests in a campaign.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Characteristics {
    /// Attained poses: iso9283.json.
    pub poses: Option<Iso9283Document>,
    /// Recorded motions: iso9283-streams.json.
    pub streams: Option<Iso9283StreamsDocument>,
    /// Static compliance: iso9283-compliance.json.
    pub compliance: Option<Iso9283ComplianceDocument>,
}

impl Characteristics {
    /// Messages of all documents.
    pub fn messages(&self) -> impl Iterator<Item = &Message> {
        let poses = self.poses.iter().flat_map(|d| &d.messages);
        let streams = self.streams.iter().flat_map(Iso9283StreamsDocument::messages);
        poses.chain(streams).chain(self.compliance.iter().flat_map(|d| &d.messages))
    }

    /// Judged limits.
    pub fn limits(&self) -> impl Iterator<Item = &LimitVerdict> {
        self.poses.iter().flat_map(|d| &d.limits)
    }

    /// `true` if nothing was tested.
    pub fn is_empty(&self) -> bool {
        self.poses.is_none() && self.streams.is_none() && self.compliance.is_none()
    }
}
