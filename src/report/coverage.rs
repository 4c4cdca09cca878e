//! Errors of a robot without the noise of their readings: interval, from errors as measured and
//! their uncertainty.
//!
//! An error is the size of a deviation between a reading and a prediction. Noise of the reading
//! adds to it, so that mean, root mean square and maximum are too large on average. The error
//! without noise is below the value + U: along its direction, noise is as often positive as
//! negative. It differs from the value by at most the size of the noise (triangle inequality).

use crate::words::{Words, tr};
use etalon_documents::{
    AccuracyDocument, AccuracySet, ErrorQuantity, ErrorStatistics, Figure, UncertaintySource as Source,
};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Probability with which the size of the noise is below its bound.
const PROBABILITY: f64 = 0.975;

/// Noise of the readings of a quantity (mm or deg).
struct ReadingNoise {
    /// Standard uncertainty of a coordinate, by the errors of each reading alone.
    own: f64,
    /// Standard uncertainty of a coordinate, by the errors that readings share.
    shared: f64,
    /// Number of coordinates of an error.
    coordinates: f64,
}

impl ReadingNoise {
    /// Noise by the budget of the largest error; `None` without a budget.
    fn new(accuracy: &AccuracyDocument, quantity: ErrorQuantity) -> Option<Self> {
        if quantity == ErrorQuantity::Orientation {
            // of the whole rotation, which may be about one axis alone: planar robots
            let own = accuracy.orientation_budget.as_ref()?.standard_uncertainty_deg;
            return Some(Self { own, shared: 0.0, coordinates: 1.0 });
        }
        let largest = accuracy.budget.iter().find(|b| b.quantity == quantity && b.figure == Figure::Max)?;
        let is_own = |source| {
            matches!(source, Source::Instrument | Source::Contact | Source::SingleCoordinates | Source::Encoders)
        };
        let squares = largest.contributions.iter().filter(|c| is_own(c.source));
        let own: f64 = squares.map(|c| c.standard_uncertainty_mm.powi(2)).sum();
        let shared = (largest.standard_uncertainty_mm.powi(2) - own).max(0.0).sqrt();
        let coordinates = match quantity {
            ErrorQuantity::Position | ErrorQuantity::Contact => 3.0,
            _ => 1.0,
        };
        Some(Self { own: own.sqrt(), shared, coordinates })
    }

    /// Bound of the noise in a figure of `count` errors; `None` without errors.
    fn bound(&self, figure: Figure, count: usize) -> Option<f64> {
        let (n, d) = (count as f64, self.coordinates);
        let chi = |degrees: f64, p: f64| ChiSquared::new(degrees).ok().map(|law| law.inverse_cdf(p));
        let own = match figure {
            Figure::Max => chi(d, PROBABILITY.powf(1.0 / n))?,
            Figure::Mean | Figure::Rms => chi(d * n, PROBABILITY)? / n,
        };
        Some(self.own * own.sqrt() + self.shared * chi(d, PROBABILITY)?.sqrt())
    }
}

/// Ends of an interval that contains the error of the robot without noise with a probability of at
/// least 95 %; `None` if the uncertainty of the readings is unknown.
pub(crate) fn interval(
    accuracy: &AccuracyDocument,
    errors: &ErrorStatistics,
    figure: Figure,
    expanded_uncertainty: f64,
) -> Option<[f64; 2]> {
    let value = figure.value_in(&errors.after);
    let noise = ReadingNoise::new(accuracy, errors.quantity)?.bound(figure, errors.count)?;
    Some([(value - noise).max(0.0), value + expanded_uncertainty])
}

/// Sentences on the noise in the errors of a set; empty if its size is unknown.
pub(crate) fn sentences(accuracy: &AccuracyDocument, set: &AccuracySet, words: &Words) -> String {
    let largest = |errors: &ErrorStatistics| {
        let ends = interval(accuracy, errors, Figure::Max, errors.expanded_uncertainty?)?;
        Some((errors.quantity, ends))
    };
    let whole = set.errors.iter().filter(|errors| !ErrorQuantity::AXES.contains(&errors.quantity));
    let known: Vec<(ErrorQuantity, [f64; 2])> = whole.filter_map(largest).collect();
    if known.is_empty() {
        return String::new();
    }
    let by_noise = known.iter().filter(|(_, [from, _])| *from <= 0.0);
    let quantities: Vec<String> = by_noise.map(|(quantity, _)| words.tr(&quantity.phrase())).collect();
    let contained = tr!(words, "errors-contain-noise");
    match quantities.is_empty() {
        true => contained,
        false => format!("{contained} {}", tr!(words, "errors-of-noise-alone", quantities = quantities.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;
    use etalon_base::noise::Noise;
    use etalon_base::pose::{Vector, norm};
    use etalon_documents::{FigureBudget, FigureContribution, OrientationBudget, Statistics};

    /// Mean, root mean square and maximum of sizes.
    fn statistics(errors: &[Vector]) -> Statistics {
        let sizes: Vec<f64> = errors.iter().map(|e| norm(*e)).collect();
        let n = sizes.len() as f64;
        let rms = (sizes.iter().map(|v| v * v).sum::<f64>() / n).sqrt();
        let max = sizes.iter().copied().fold(0.0, f64::max);
        Statistics { mean: sizes.iter().sum::<f64>() / n, rms, p95: max, max }
    }

    /// Accuracy with this standard uncertainty of a coordinate: own and shared part.
    fn accuracy([own, shared]: [f64; 2]) -> AccuracyDocument {
        let contribution = |(source, standard_uncertainty_mm)| FigureContribution { source, standard_uncertainty_mm };
        let contributions = [(Source::Instrument, own), (Source::Frame, shared)].map(contribution).to_vec();
        let quantity = ErrorQuantity::Position;
        let standard_uncertainty_mm = own.hypot(shared);
        let largest = FigureBudget { quantity, figure: Figure::Max, standard_uncertainty_mm, contributions };
        AccuracyDocument { budget: vec![largest], ..Documents::demo().accuracy }
    }

    fn statistics_of_positions(count: usize, after: Statistics) -> ErrorStatistics {
        let errors = Documents::demo().accuracy.sets[1].errors[0].clone();
        ErrorStatistics { count, after, ..errors }
    }

    /// Standard uncertainty of a figure by linear propagation (GUM 5.2.2).
    fn propagated(errors: &[Vector], figure: Figure, [own, shared]: [f64; 2]) -> f64 {
        let (n, rms) = (errors.len() as f64, statistics(errors).rms);
        let sensitivity = |e: &Vector| -> Vector {
            let weight = match figure {
                Figure::Max => 0.0,
                Figure::Mean => 1.0 / (n * norm(*e)),
                Figure::Rms => 1.0 / (n * rms),
            };
            e.map(|v| weight * v)
        };
        if figure == Figure::Max {
            return own.hypot(shared);
        }
        let all: Vec<Vector> = errors.iter().map(sensitivity).collect();
        let squares: f64 = all.iter().flatten().map(|v| v * v).sum();
        let sums: f64 = (0..3).map(|axis| all.iter().map(|v| v[axis]).sum::<f64>().powi(2)).sum();
        (own * own * squares + shared * shared * sums).sqrt()
    }

    /// Known errors with noise of known size: the interval contains the error without noise in at
    /// least 95 % of the draws. The value ± U does not, if noise is as large as the error.
    #[test]
    fn intervals_contain_the_error_without_noise() {
        const DRAWS: usize = 400;
        let mut trial = 0;
        for size in [0.0, 0.5, 2.0, 10.0] {
            for (count, u) in [(5, [1.0, 0.0]), (20, [1.0, 0.6]), (120, [1.0, 0.0]), (40, [0.2, 1.0])] {
                let document = accuracy(u);
                let (mut within, mut about) = ([0; 3], [0; 3]);
                let figures = [Figure::Mean, Figure::Rms, Figure::Max];
                for _ in 0..DRAWS {
                    trial += 1;
                    let mut noise = Noise::new(3, trial);
                    let mut drawn = |u: f64| -> Vector { std::array::from_fn(|_| noise.gaussian(u)) };
                    let truth: Vec<Vector> = (0..count).map(|_| drawn(size)).collect();
                    let shared = drawn(u[1]);
                    let read = |e: &Vector| -> Vector {
                        let own = drawn(u[0]);
                        std::array::from_fn(|i| e[i] + own[i] + shared[i])
                    };
                    let measured: Vec<Vector> = truth.iter().map(read).collect();
                    let found = statistics_of_positions(count, statistics(&measured));
                    for (k, figure) in figures.into_iter().enumerate() {
                        let expanded = 2.0 * propagated(&measured, figure, u);
                        let [from, to] = interval(&document, &found, figure, expanded).unwrap();
                        let [true_error, value] = [statistics(&truth), found.after].map(|s| figure.value_in(&s));
                        within[k] += usize::from((from..=to).contains(&true_error));
                        about[k] += usize::from((value - true_error).abs() <= expanded);
                    }
                }
                // three standard deviations of the count below 95 %
                let least = 0.95 - 3.0 * (0.95 * 0.05 / DRAWS as f64).sqrt();
                let share = |count: usize| count as f64 / DRAWS as f64;
                assert!(within.iter().all(|n| share(*n) >= least), "{size}, {count}, {u:?}: {within:?}");
                let is_noise = size < 0.1 && count >= 20 && u[1] < 1.0;
                assert!(!is_noise || share(about[2]) < 0.5, "{count}, {u:?}: {about:?}");
            }
        }
    }

    #[test]
    fn noise_that_explains_an_error_is_named() {
        let words = Words::default();
        // 1.7 × 0.026 mm against noise of 1 µm, and of 50 µm
        let set = |accuracy: &AccuracyDocument| accuracy.sets.last().unwrap().clone();
        let said = |accuracy: &AccuracyDocument| sentences(accuracy, &set(accuracy), &words);
        let contained = tr!(words, "errors-contain-noise");
        assert_eq!(said(&accuracy([0.001, 0.0])), contained);
        let alone = |quantities: &str| format!("{contained} {}", tr!(words, "errors-of-noise-alone", quantities));
        assert_eq!(said(&accuracy([0.05, 0.0])), alone("position"));
        let mut turned = accuracy([0.001, 0.0]);
        turned.orientation_budget =
            Some(OrientationBudget { standard_uncertainty_deg: 0.01, contributions: Vec::new() });
        let orientation = turned.sets.last_mut().unwrap().errors.last_mut().unwrap();
        orientation.expanded_uncertainty = Some(0.02);
        assert_eq!(said(&turned), alone("orientation"));
        assert_eq!(said(&Documents::demo().accuracy), "");
    }
}
