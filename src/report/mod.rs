//! stub
use crate::document::*;
pub struct Report<'a> { pub campaign: &'a CampaignSummary, pub import: &'a ImportDocument, pub features: &'a FeaturesDocument, pub frames: &'a FramesDocument, pub parameters: &'a ParametersDocument, pub accuracy: &'a AccuracyDocument, pub errors: &'a [PointError] }
pub fn html(_r:&Report)->crate::message::Result<String>{Ok(String::new())}
