//! What the standard does not ask for: ellipsoid, conformity with limits, RP without the instrument's noise.

use super::Settings;
use crate::base::message::Result;
use crate::base::pose::Vector;
use crate::document::{Iso9283Conformity, Iso9283Ellipsoid, Iso9283Interval, Iso9283Pose};
use crate::import::tables::visits::PoseVisits;
use crate::iso9283::conformity::{Conformity, conformity};
use crate::iso9283::ellipsoid::ellipsoid;
use crate::iso9283::interval;
use crate::iso9283::noise_free::without_noise;

/// Fills it in, where the visits and the settings tell it.
pub(super) fn beyond(pose: &mut Iso9283Pose, p: &PoseVisits, positions: &[Vector], settings: &Settings) -> Result<()> {
    // too few visits have none
    pose.ellipsoid = ellipsoid(positions).ok().map(|e| Iso9283Ellipsoid { semi_axes_mm: e.semi_axes_mm, axes: e.axes });
    let proved = |interval: Option<Iso9283Interval>, limit_mm: Option<f64>| {
        // too few visits prove nothing
        let Some(Iso9283Interval { low_mm, high_mm }) = interval else {
            return limit_mm.map(|_| Iso9283Conformity::Neither);
        };
        Some(match conformity(&interval::Interval { low_mm, high_mm }, limit_mm?) {
            Conformity::Conforming => Iso9283Conformity::Conforming,
            Conformity::NotConforming => Iso9283Conformity::NotConforming,
            Conformity::Neither => Iso9283Conformity::Neither,
        })
    };
    pose.ap_conformity = proved(pose.ap_interval, settings.ap_limit_mm);
    pose.rp_conformity = proved(pose.rp_interval, settings.rp_limit_mm);
    if p.visits.len() > 2 && p.visits.iter().any(|v| v.readings_mm.len() > 1) {
        let readings: Vec<Vec<Vector>> = p.visits.iter().map(|v| v.readings_mm.clone()).collect();
        let free = without_noise(&readings)?;
        (pose.rp_without_noise_mm, pose.noise_mm) = (Some(free.rp_mm), Some(free.noise_mm));
    }
    Ok(())
}
