//! Temperatures that the rows of exports contain.

use etalon_base::message::Message;
use etalon_base::warning;
use etalon_campaign::Campaign;
use etalon_formats::Point;

/// Difference (°C) from the given temperature without a remark, if the campaign contains no
/// uncertainty of the temperature.
const CLOSE_C: f64 = 1.0;

/// Lowest and highest temperature (°C) of the points, if rows contain temperatures.
pub fn range(points: &[Point]) -> Option<[f64; 2]> {
    let all = points.iter().filter_map(|point| point.temperature_c).filter(|t| t.is_finite());
    all.map(|t| [t; 2]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

/// Warnings about temperatures of rows that contradict the campaign: a different temperature, or a
/// larger range than given.
pub(super) fn contradicted(campaign: &Campaign, points: &[Point]) -> Vec<Message> {
    let Some([lowest_c, highest_c]) = range(points) else { return Vec::new() };
    let expansion = campaign.file.expansion;
    let expanded_c = expansion.map(|expansion| expansion.expanded_temperature_uncertainty_c);
    let mut messages = Vec::new();
    if let Some(stated_c) = campaign.file.temperature_c {
        let off_c = (lowest_c - stated_c).max(stated_c - highest_c);
        if off_c > expanded_c.unwrap_or(CLOSE_C) {
            let place = campaign.key_place(&["temperature_c"]);
            messages.push(warning!("temperature-elsewhere", stated_c, lowest_c, highest_c).at(place));
        }
    }
    if let Some(expanded_c) = expanded_c.filter(|expanded_c| highest_c - lowest_c > 2.0 * expanded_c) {
        let place = campaign.key_place(&["expansion", "expanded_temperature_uncertainty_c"]);
        messages.push(warning!("temperature-varies", lowest_c, highest_c, expanded_c).at(place));
    }
    messages
}
