//! Conditions that no test has.

use crate::base::message::{Message, Problems};
use crate::campaign::Campaign;

/// Numbers of `[conditions]` that mean nothing.
pub(super) fn check(campaign: &Campaign, problems: &mut Problems) {
    let conditions = &campaign.file.conditions;
    let mut wrong = |key: &str, must: &str| {
        let message = Message::error(format!("`{key}` must {must}"));
        problems.0.push(message.at(campaign.place_of(&["conditions", key])));
    };
    for (key, value) in conditions.positive() {
        if value <= 0.0 {
            wrong(key, "be positive");
        } else if key == "humidity_percent" && value > 100.0 {
            wrong(key, "be at most 100");
        }
    }
    for (key, value) in conditions.not_negative() {
        if value < 0.0 {
            wrong(key, "not be negative");
        }
    }
}
