//! Lengths: the lead error of an actuator, travel of a ball on its carriage against the commanded displacement (thesis
//! 2.5), and the instrument's error on a scale bar (thesis 2.6).

use super::uncertain::{Readings, Scatter, Uncertain, mean_and_sd, shifts, values};
use crate::base::message::{Message, Result};
use crate::base::pose::{Vector, centroid, dot, minus, norm};

/// A ball on a carriage.
#[derive(Clone, Debug, Default)]
pub struct LeadMeasurements {
    /// Commanded displacement of each reading, in mm.
    pub commanded_mm: Vec<f64>,
    /// Where the ball was, in mm.
    pub points: Vec<Vector>,
}

/// Actual over commanded displacement of one actuator.
#[derive(Clone, Debug)]
pub struct Lead {
    /// The coefficient δ of eq. 3.7.
    pub ratio: Uncertain,
    /// Each commanded displacement, and the mean deviation there from linear travel along the ball's own line, in mm.
    pub linearity: Vec<(f64, f64)>,
    /// Deviations along the line.
    pub scatter: Scatter,
}

impl Lead {
    /// The regression p = a + ρ g of the ball's place on the commanded displacement ρ: δ is the length of g.
    pub fn determine(readings: &mut Readings, measured: &LeadMeasurements) -> Result<Self> {
        let points = readings.add(&measured.points);
        let (p, rho) = (values(&points), &measured.commanded_mm);
        let n = p.len().min(rho.len());
        let mean_rho = rho.iter().sum::<f64>() / n.max(1) as f64;
        let spread: f64 = rho.iter().map(|r| (r - mean_rho).powi(2)).sum();
        let centre = centroid(&p).unwrap_or_default();
        let mut g = [0.0; 3];
        for (p, r) in p.iter().zip(rho) {
            for (g, w) in g.iter_mut().zip(minus(*p, centre)) {
                *g += (r - mean_rho) * w / spread;
            }
        }
        let ratio = norm(g);
        if n < 3 || !(ratio.is_finite() && ratio > 0.0) {
            return Err(Message::error("the lead of an actuator cannot be determined from these positions")
                .expected("three readings or more, at two commanded displacements or more")
                .into());
        }
        let along = g.map(|v| v / ratio);
        let rows: Vec<[f64; 2]> = rho.iter().map(|r| [-1.0, -(r - mean_rho)]).collect();
        let moves: Vec<Uncertain> = points.iter().map(|p| Uncertain::linear(0.0, along.into_iter().zip(p))).collect();
        let deviations: Vec<f64> =
            p.iter().zip(rho).map(|(p, r)| dot(minus(*p, centre), along) - ratio * (r - mean_rho)).collect();
        let [_, slope] = shifts(&rows, &moves)?;
        let scatter = readings.judge(&deviations, &moves, 2, &points);
        let mut positions: Vec<f64> = rho.clone();
        positions.sort_by(f64::total_cmp);
        positions.dedup();
        let mean_at = |position: f64| {
            let here: Vec<f64> = deviations.iter().zip(rho).filter(|(_, r)| **r == position).map(|(d, _)| *d).collect();
            (position, here.iter().sum::<f64>() / here.len().max(1) as f64)
        };
        Ok(Self { ratio: slope.at(ratio), linearity: positions.into_iter().map(mean_at).collect(), scatter })
    }

    /// Lead error: what is travelled too far for each millimetre commanded.
    pub fn error(&self) -> f64 {
        self.ratio.value - 1.0
    }
}

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
    let (mean_error_mm, standard_deviation_mm) = mean_and_sd(&errors)?;
    Some(ScaleBar { count: errors.len(), mean_error_mm, standard_deviation_mm })
}
