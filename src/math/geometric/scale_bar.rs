//! The instrument looked at with a scale bar (thesis 2.6).

use crate::base::pose::{Vector, minus, norm};

/// Distance errors of a scale bar in one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleBar {
    /// Number of distances.
    pub count: usize,
    /// Mean of measured minus nominal distance, in mm.
    pub mean_error_mm: f64,
    /// Standard deviation of the distances, in mm; zero for a single one.
    pub standard_deviation_mm: f64,
}

/// Distances of the two balls of a bar of `length_mm`, each pair measured together; `None` without any.
pub fn scale_bar(length_mm: f64, pairs: &[[Vector; 2]]) -> Option<ScaleBar> {
    let errors: Vec<f64> = pairs.iter().map(|[a, b]| norm(minus(*b, *a)) - length_mm).collect();
    let (mean_error_mm, standard_deviation_mm) = super::repeated::mean_and_deviation(&errors)?;
    Some(ScaleBar { count: errors.len(), mean_error_mm, standard_deviation_mm })
}
