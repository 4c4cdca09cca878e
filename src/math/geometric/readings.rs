//! Points as they were measured, and how well their coordinates are known.

use super::uncertain::Uncertain;
use crate::base::message::{Message, Result};
use crate::base::pose::Vector;
use crate::math::identify::chi_square_exceeds;
use crate::math::solve::Factor;

/// A measured point.
pub type Point = [Uncertain; 3];

/// A point in a plane.
pub type Flat = [Uncertain; 2];

/// All measured coordinates with their standard uncertainties.
#[derive(Clone, Debug)]
pub struct Readings {
    stated_mm: f64,
    standard_uncertainties_mm: Vec<f64>,
}

/// What the residuals of one fit say.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Number of residuals.
    pub count: usize,
    /// Residuals less what was fitted.
    pub degrees_of_freedom: usize,
    /// Root of the sum of their squares over the degrees of freedom.
    pub standard_deviation_mm: f64,
    /// Largest, without its sign.
    pub max_mm: f64,
    /// Root of the sum of squares, as the thesis tells it (2.6.1).
    pub norm_mm: f64,
    /// What the stated uncertainty makes of the standard deviation.
    pub expected_mm: f64,
    /// By how much the points' uncertainties were enlarged because the residuals scatter more than that; else 1.
    pub enlarged_by: f64,
}

impl Readings {
    /// Readings of an instrument with this standard uncertainty of one coordinate, in mm.
    pub fn new(stated_mm: f64) -> Self {
        Self { stated_mm, standard_uncertainties_mm: Vec::new() }
    }

    /// Adds points (mm).
    pub fn add(&mut self, points: &[Vector]) -> Vec<Point> {
        points.iter().map(|&p| self.add_one(p)).collect()
    }

    /// Adds a point (mm).
    pub fn add_one(&mut self, p: Vector) -> Point {
        let first = self.standard_uncertainties_mm.len();
        self.standard_uncertainties_mm.extend([self.stated_mm; 3]);
        [0, 1, 2].map(|k| Uncertain::coordinate(p[k], first + k))
    }

    /// Standard uncertainty of every coordinate, in mm.
    pub fn standard_uncertainties_mm(&self) -> &[f64] {
        &self.standard_uncertainties_mm
    }

    /// Judges residuals whose uncertainties are those of `moves`: where chi-square rejects the stated uncertainty,
    /// that of `points` is enlarged to what the residuals say.
    pub fn judge(&mut self, residuals_mm: &[f64], moves: &[Uncertain], fitted: usize, points: &[Point]) -> Scatter {
        let u = &self.standard_uncertainties_mm;
        let variances: Vec<f64> = moves.iter().map(|m| m.covariance(m, u)).collect();
        let squares: f64 = residuals_mm.iter().map(|r| r * r).sum();
        let chi_square: f64 = residuals_mm.iter().zip(&variances).map(|(r, v)| r * r / v).sum();
        let dof = residuals_mm.len().saturating_sub(fitted);
        let rejected = dof > 0 && chi_square_exceeds(chi_square, dof);
        let enlarged_by = if rejected { (chi_square / dof as f64).sqrt() } else { 1.0 };
        for i in points.iter().flatten().flat_map(|x| x.coordinates()) {
            if let Some(u) = self.standard_uncertainties_mm.get_mut(i) {
                *u *= enlarged_by;
            }
        }
        Scatter {
            count: residuals_mm.len(),
            degrees_of_freedom: dof,
            standard_deviation_mm: if dof > 0 { (squares / dof as f64).sqrt() } else { 0.0 },
            max_mm: residuals_mm.iter().fold(0.0, |m, r| m.max(r.abs())),
            norm_mm: squares.sqrt(),
            expected_mm: (variances.iter().sum::<f64>() / variances.len().max(1) as f64).sqrt(),
            enlarged_by,
        }
    }
}

/// The values of points.
pub(super) fn values<const N: usize>(points: &[[Uncertain; N]]) -> Vec<[f64; N]> {
    points.iter().map(|p| p.each_ref().map(|x| x.value)).collect()
}

/// How the solution x of min Σ d² moves with the points: −(JᵀJ)⁻¹Jᵀ δ, with `rows` of J = ∂d/∂x and `moves` δ of each
/// distance d at fixed x. First order in the points, and in residuals that are small against the element.
pub(super) fn shifts<const N: usize>(rows: &[[f64; N]], moves: &[Uncertain]) -> Result<[Uncertain; N]> {
    let factor = Factor::new(rows.as_flattened(), &vec![0.0; rows.len()], &[1.0; N]);
    let undetermined = || {
        Message::error("these points do not determine what is to be found from them")
            .hint("spread the positions over the whole travel or turn")
    };
    let inverse = factor.inverse_normal().filter(|v| v.iter().all(|v| v.is_finite())).ok_or_else(undetermined)?;
    let gain = |k: usize, row: &[f64; N]| -> f64 {
        -row.iter().enumerate().map(|(j, r)| inverse.get(k * N + j).copied().unwrap_or(0.0) * r).sum::<f64>()
    };
    let mut index = 0;
    Ok([(); N].map(|()| {
        index += 1;
        Uncertain::linear(0.0, rows.iter().map(|row| gain(index - 1, row)).zip(moves))
    }))
}
