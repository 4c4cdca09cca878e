//! Errors before and after calibration over campaigns.

use super::significance::Estimate;
use super::trend::{TrendName, trend_from_estimates};
use etalon_base::phrase;
use etalon_documents::*;

/// Mean errors of position and orientation, before and after calibration, of all sets of poses that
/// occur in every campaign.
pub(super) fn trends(all: &[&(ParametersDocument, AccuracyDocument)]) -> Vec<CompareTrend> {
    let Some(first) = all.first() else { return Vec::new() };
    let mut trends = Vec::new();
    for set in &first.1.sets {
        let kinds = [ErrorQuantity::Position, ErrorQuantity::Orientation].into_iter().chain(ErrorQuantity::OTHERS);
        for error in kinds.filter_map(|q| set.error_statistics(q)) {
            for (when, of) in [
                (phrase!("before"), (|e| e.before) as fn(&ErrorStatistics) -> Statistics),
                (phrase!("after"), |e: &ErrorStatistics| e.after),
            ] {
                let estimate = |c: &&(ParametersDocument, AccuracyDocument)| {
                    let set = c.1.sets.iter().find(|s| s.name == set.name)?;
                    mean(set.poses, &of(set.error_statistics(error.quantity)?))
                };
                let estimates: Vec<Option<Estimate>> = all.iter().map(estimate).collect();
                if estimates.iter().all(Option::is_some) {
                    let (quantity, set) = (error.quantity.phrase(), set.name.phrase());
                    let name = TrendName::Words(phrase!("mean-error-of-set", quantity, set, when));
                    trends.push(trend_from_estimates(CompareFamily::MeanError, name, &error.unit, &estimates));
                }
            }
        }
    }
    trends
}

/// Mean size with its uncertainty from the scatter. Errors at one pose have common causes, so that
/// a pose counts once.
fn mean(poses: usize, s: &Statistics) -> Option<Estimate> {
    let n = poses as f64;
    let variance = (s.rms.powi(2) - s.mean.powi(2)).max(0.0) * n / (n - 1.0);
    let estimate = Estimate { value: s.mean, standard_uncertainty: (variance / n).sqrt(), degrees: n - 1.0 };
    (poses > 1 && s.mean.is_finite() && s.rms.is_finite()).then_some(estimate)
}
