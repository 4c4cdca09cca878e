//! The documents of tests by ISO 9283 together, as a campaign has them.

use super::{Iso9283ComplianceDocument, Iso9283Document, Iso9283StreamsDocument, LimitVerdict};
use crate::base::message::Message;

/// One of each kind of test that there is.
#[derive(Clone, Debug, Default)]
pub struct Characteristics {
    /// Poses that were visited: iso9283.json.
    pub poses: Option<Iso9283Document>,
    /// Recorded motions: iso9283-streams.json.
    pub streams: Option<Iso9283StreamsDocument>,
    /// Static compliance: iso9283-compliance.json.
    pub compliance: Option<Iso9283ComplianceDocument>,
}

impl Characteristics {
    /// Everything that is remarked of them.
    pub fn messages(&self) -> impl Iterator<Item = &Message> {
        let poses = self.poses.iter().flat_map(|d| &d.messages);
        let streams = self.streams.iter().flat_map(Iso9283StreamsDocument::messages);
        poses.chain(streams).chain(self.compliance.iter().flat_map(|d| &d.messages))
    }

    /// Limits that are judged.
    pub fn limits(&self) -> impl Iterator<Item = &LimitVerdict> {
        self.poses.iter().flat_map(|d| &d.limits)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.poses.is_none() && self.streams.is_none() && self.compliance.is_none()
    }
}
