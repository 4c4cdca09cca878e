//! Parameters over campaigns.

use super::significance::{Estimate, LEVEL};
use super::trend::{TrendName, pairs, trend_from_estimates};
use etalon_base::message::Message;
use etalon_base::warning;
use etalon_documents::*;
use nalgebra::{Cholesky, DMatrix, DVector};
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};
use std::collections::BTreeSet;

type Calibration<'a> = &'a (ParametersDocument, AccuracyDocument);

/// Degrees of freedom of a parameter's standard uncertainty; infinite if it follows from given
/// uncertainties.
fn parameter_degrees_of_freedom(entry: &ParameterEntry, residuals: &ResidualSummary) -> f64 {
    match residuals.uncertainties_from {
        UncertaintyFrom::Instrument | UncertaintyFrom::Nothing => f64::INFINITY,
        _ => entry.degrees_of_freedom.unwrap_or(residuals.degrees_of_freedom as f64),
    }
}

/// Degrees of freedom of the covariance: the smallest of all parameters.
pub(super) fn degrees(parameters: &ParametersDocument) -> f64 {
    let identified = parameters.parameters.iter().filter(|p| p.status == ParameterStatus::Identified);
    identified.map(|p| parameter_degrees_of_freedom(p, &parameters.residuals)).fold(f64::INFINITY, f64::min)
}

/// All parameters that at least one campaign identified.
pub(super) fn trends(all: &[Calibration], messages: &mut Vec<Message>) -> Vec<CompareTrend> {
    let Some(first) = all.first() else { return Vec::new() };
    let mut trends = Vec::new();
    let mut held = Vec::new();
    let mut redrawn = BTreeSet::new();
    for p in &first.0.parameters {
        let entries: Vec<Option<&ParameterEntry>> =
            all.iter().map(|c| c.0.parameters.iter().find(|e| e.name == p.name)).collect();
        if entries.iter().flatten().any(|e| e.nominal != p.nominal) {
            redrawn.insert(p.name.clone());
        }
        let estimate = |(entry, c): (&Option<&ParameterEntry>, &Calibration)| {
            let entry = entry.filter(|e| e.status == ParameterStatus::Identified)?;
            let standard_uncertainty = entry.standard_uncertainty.unwrap_or(f64::NAN);
            Some(Estimate {
                value: entry.value,
                standard_uncertainty,
                degrees: parameter_degrees_of_freedom(entry, &c.0.residuals),
            })
        };
        let estimates: Vec<Option<Estimate>> = entries.iter().zip(all).map(estimate).collect();
        match estimates.iter().flatten().count() {
            0 => continue,
            count if count < all.len() => held.push(p.name.clone()),
            _ => {}
        }
        // only base and targets are fitted before the calibration
        let set_up = entries.iter().flatten().any(|e| e.before != e.nominal);
        let family = if set_up { CompareFamily::SetUp } else { CompareFamily::Robot };
        trends.push(trend_from_estimates(family, TrendName::Parameter(p.name.clone()), &p.unit, &estimates));
    }
    if !held.is_empty() {
        messages.push(warning!("parameters-not-in-all", parameters = held));
    }
    if !redrawn.is_empty() {
        let names: Vec<String> = redrawn.into_iter().collect();
        messages.push(warning!("nominal-values-differ", parameters = names));
    }
    trends.sort_by_key(|t| t.family);
    trends
}

/// `true` if residuals exceed the instrument's uncertainty. Parameters then absorb unmodelled
/// errors at the measured poses.
fn misfits(parameters: &ParametersDocument) -> bool {
    parameters.misfits()
}

/// Removes the probabilities of changes of parameters and mean errors between campaigns if the
/// model does not fit one of the campaigns: the changes then depend on the choice of poses rather
/// than on noise. Intervals of parameters are enlarged by the difference between both series;
/// intervals of mean errors, which contain the scatter of poses only, are removed. `names` are the
/// names of the campaigns.
pub(super) fn without_evidence(
    all: &[Calibration],
    trends: &mut [CompareTrend],
    names: &[&str],
) -> (Vec<CompareBetween>, Option<Message>) {
    let wrong: Vec<usize> = (0..all.len()).filter(|&i| misfits(&all[i].0)).collect();
    if wrong.is_empty() {
        return (Vec::new(), None);
    }
    let touched = |&[from, to]: &[usize; 2]| wrong.contains(&from) || wrong.contains(&to);
    let between: Vec<CompareBetween> =
        pairs(all.len()).into_iter().filter(touched).map(|pair| between(all, trends, pair)).collect();
    for trend in trends.iter_mut() {
        let parameter = matches!(trend.family, CompareFamily::Robot | CompareFamily::SetUp);
        for change in &mut trend.changes {
            let Some(of_pair) = between.iter().find(|b| (b.from, b.to) == (change.from, change.to)) else { continue };
            change.p = None;
            let enlarged = |end: Option<f64>| {
                let enlarged = end.map(|end| change.change + of_pair.birge_ratio * (end - change.change));
                enlarged.filter(|_| parameter)
            };
            (change.low, change.high) = (enlarged(change.low), enlarged(change.high));
        }
    }
    let named: Vec<String> = wrong.iter().map(|&i| format!("`{}`", names[i])).collect();
    let largest = between.iter().map(|b| b.birge_ratio).fold(1.0, f64::max);
    let message = warning!("model-misfits", campaigns = named, birge = format!("{largest:.1}"));
    (between, Some(message))
}

/// Birge ratio of all changes of the robot's parameters to their uncertainties, at least 1 (Birge
/// 1932, Phys. Rev. 40, 207; for correlated values √(Δᵀ (C₁ + C₂)⁻¹ Δ / m)); 1 if covariances are
/// unknown.
fn between(all: &[Calibration], trends: &[CompareTrend], [from, to]: [usize; 2]) -> CompareBetween {
    let robot = trends.iter().filter(|t| t.family == CompareFamily::Robot);
    let names: Vec<&str> = robot.map(|t| t.name.english()).collect();
    let change = change(all, &names, [from, to]);
    let squares =
        |c: &Change| Some(c.sizes.dot(&Cholesky::new(c.correlation())?.solve(&c.sizes)) / c.sizes.len() as f64);
    let ratio = change.as_ref().and_then(squares).filter(|f| f.is_finite()).map_or(1.0, |f| f.max(1.0).sqrt());
    CompareBetween { from: from + 1, to: to + 1, parameters: change.map_or(0, |c| c.sizes.len()), birge_ratio: ratio }
}

/// Joint test of all robot parameters, Δᵀ (C₁ + C₂)⁻¹ Δ. It detects changes in directions that are
/// hidden by the large uncertainties of strongly correlated parameters.
pub(super) fn together(all: &[Calibration], trends: &[CompareTrend]) -> Vec<CompareTogether> {
    let robot = |t: &&CompareTrend| t.family == CompareFamily::Robot;
    let names: Vec<&str> = trends.iter().filter(robot).map(|t| t.name.english()).collect();
    let fits = |&[from, to]: &[usize; 2]| !misfits(&all[from].0) && !misfits(&all[to].0);
    pairs(all.len()).into_iter().filter(fits).filter_map(|pair| pair_together(all, &names, pair)).collect()
}

/// Changes of parameters between two campaigns, relative to their standard uncertainties, and
/// covariances in these units.
pub(super) struct Change {
    sizes: DVector<f64>,
    earlier: DMatrix<f64>,
    later: DMatrix<f64>,
}

impl Change {
    /// Correlation of the changes.
    pub fn correlation(&self) -> DMatrix<f64> {
        &self.earlier + &self.later
    }
}

/// Changes of the parameters in `names` that both campaigns identified; `None` if a covariance is
/// missing.
pub(super) fn change(all: &[Calibration], names: &[&str], [from, to]: [usize; 2]) -> Option<Change> {
    let identified = |c: Calibration| c.0.identified().map(|p| (p.name.clone(), p.value)).collect::<Vec<_>>();
    let (a, b) = (identified(all[from]), identified(all[to]));
    let place = |all: &[(String, f64)], name: &str| all.iter().position(|p| p.0 == name);
    let both: Vec<(usize, usize)> = names.iter().filter_map(|n| Some((place(&a, n)?, place(&b, n)?))).collect();
    let m = both.len();
    let block = |c: Calibration, of: &dyn Fn(&(usize, usize)) -> usize| -> Option<DMatrix<f64>> {
        let rows: Option<Vec<f64>> = both
            .iter()
            .flat_map(|i| both.iter().map(move |j| (i, j)))
            .map(|(i, j)| c.0.covariance.get(of(i))?.get(of(j)).copied())
            .collect();
        Some(DMatrix::from_row_slice(m, m, &rows?))
    };
    let (first, second) = (block(all[from], &|i| i.0)?, block(all[to], &|i| i.1)?);
    // mm and degrees differ by powers of ten: in units of their uncertainties
    let u: Vec<f64> = (0..m).map(|i| (first[(i, i)] + second[(i, i)]).sqrt()).collect();
    if m == 0 || !u.iter().all(|u| *u > 0.0 && u.is_finite()) {
        return None;
    }
    let scaled = |c: &DMatrix<f64>| DMatrix::from_fn(m, m, |i, j| c[(i, j)] / (u[i] * u[j]));
    let sizes = DVector::from_fn(m, |k, _| (b[both[k].1].1 - a[both[k].0].1) / u[k]);
    Some(Change { sizes, earlier: scaled(&first), later: scaled(&second) })
}

fn pair_together(all: &[Calibration], names: &[&str], [from, to]: [usize; 2]) -> Option<CompareTogether> {
    let change = change(all, names, [from, to])?;
    let m = change.sizes.len();
    let inverse = Cholesky::new(change.correlation())?.inverse();
    let f = change.sizes.dot(&(&inverse * &change.sizes)) / m as f64;
    // shares of the two campaigns in the sum, as weights of their degrees of freedom (Welch and
    // Satterthwaite)
    let share = (&inverse * &change.earlier).trace() / m as f64;
    let degrees = 1.0 / (share.powi(2) / degrees(&all[from].0) + (1.0 - share).powi(2) / degrees(&all[to].0));
    let degrees = Some(degrees).filter(|d| d.is_finite());
    let p = match degrees {
        Some(degrees) => FisherSnedecor::new(m as f64, degrees).ok()?.sf(f),
        None => ChiSquared::new(m as f64).ok()?.sf(f * m as f64),
    };
    let significant = p < LEVEL;
    f.is_finite().then_some(CompareTogether {
        from: from + 1,
        to: to + 1,
        parameters: m,
        f,
        degrees_of_freedom: degrees,
        p,
        significant,
    })
}
