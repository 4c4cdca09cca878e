//! Statistics of samples: mean, root mean square, standard deviation, quantiles.

/// Mean; zero without values.
pub fn mean(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut count = 0usize;
    let sum: f64 = values.into_iter().inspect(|_| count += 1).sum();
    sum / count.max(1) as f64
}

/// Root mean square; zero without values.
pub fn rms(values: impl IntoIterator<Item = f64>) -> f64 {
    mean(values.into_iter().map(|v| v * v)).sqrt()
}

/// Variance about the mean, with n − 1 degrees of freedom (GUM 4.2.2); zero for fewer than two
/// values.
pub fn variance(values: &[f64]) -> f64 {
    let mean = mean(values.iter().copied());
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    squares / values.len().saturating_sub(1).max(1) as f64
}

/// Standard deviation about the mean, with n − 1 degrees of freedom (GUM 4.2.2); zero for fewer
/// than two values.
pub fn standard_deviation(values: &[f64]) -> f64 {
    variance(values).sqrt()
}

/// Quantile of values in any order, interpolated linearly between order statistics (definition 7 of
/// Hyndman & Fan 1996, as in spreadsheets); `None` without values. Rearranges the values.
pub fn quantile(values: &mut [f64], share: f64) -> Option<f64> {
    let rank = share * values.len().saturating_sub(1) as f64;
    let at = rank.floor() as usize;
    if at >= values.len() {
        return None;
    }
    let (_, &mut low, above) = values.select_nth_unstable_by(at, f64::total_cmp);
    let high = above.iter().copied().min_by(f64::total_cmp).unwrap_or(low);
    Some(low + rank.fract() * (high - low))
}

/// The two middle values in ascending order, equal for an odd number of values; `None` without
/// values.
pub fn middle_pair(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let mut values: Vec<f64> = values.into_iter().collect();
    if values.is_empty() {
        return None;
    }
    let (middle, is_even) = (values.len() / 2, values.len().is_multiple_of(2));
    let (below, &mut upper, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let lower = below.iter().copied().max_by(f64::total_cmp).filter(|_| is_even);
    Some([lower.unwrap_or(upper), upper])
}

/// Spearman's rank correlation; ties have the mean of their ranks. Zero if all values of a list are
/// equal.
pub fn rank_correlation(a: &[f64], b: &[f64]) -> f64 {
    let centred = |values: &[f64]| -> Vec<f64> {
        let ranks = ranks(values);
        let middle = mean(ranks.iter().copied());
        ranks.into_iter().map(|r| r - middle).collect()
    };
    let (a, b) = (centred(a), centred(b));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let size = (dot(&a, &a) * dot(&b, &b)).sqrt();
    if size > 0.0 { dot(&a, &b) / size } else { 0.0 }
}

/// Ranks from 0; equal values have the mean of their ranks.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let rank = |v: &f64| {
        let below = sorted.partition_point(|other| other.total_cmp(v).is_lt());
        let up_to = sorted.partition_point(|other| other.total_cmp(v).is_le());
        0.5 * (below + up_to) as f64 - 0.5
    };
    values.iter().map(rank).collect()
}

/// Median as one of the values: the larger one of the middle pair for an even number; `None`
/// without values.
pub fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    middle_pair(values).map(|[_, upper]| upper)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_by_hand() {
        assert_eq!((middle_pair([]), median([])), (None, None));
        assert_eq!((middle_pair([3.0]), median([3.0, 1.0, 2.0])), (Some([3.0, 3.0]), Some(2.0)));
        assert_eq!((middle_pair([4.0, 1.0, 3.0, 2.0]), median([4.0, 1.0, 3.0, 2.0])), (Some([2.0, 3.0]), Some(3.0)));
    }

    #[test]
    fn rank_correlations_of_a_published_example_and_by_hand() {
        // intelligence quotient and hours of television: -29/165 (Wikipedia, Spearman correlation)
        let quotients = [106.0, 100.0, 86.0, 101.0, 99.0, 103.0, 97.0, 113.0, 112.0, 110.0];
        let hours = [7.0, 27.0, 2.0, 50.0, 28.0, 29.0, 20.0, 12.0, 6.0, 17.0];
        assert!((rank_correlation(&quotients, &hours) + 29.0 / 165.0).abs() < 1e-15);
        // ties: 4.5 / sqrt(4.5 * 5)
        let tied = rank_correlation(&[1.0, 2.0, 2.0, 3.0], &[1.0, 2.0, 3.0, 4.0]);
        assert!((tied - 0.9f64.sqrt()).abs() < 1e-15);
        assert_eq!(rank_correlation(&[1.0, 1.0], &[1.0, 2.0]), 0.0);
    }

    #[test]
    fn moments_by_hand() {
        let values = [2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0];
        assert_eq!(mean(values), 5.0);
        assert_eq!(variance(&values), 32.0 / 7.0);
        assert_eq!(standard_deviation(&values), (32.0f64 / 7.0).sqrt());
        assert_eq!(rms([3.0, -4.0]), 12.5f64.sqrt());
        assert_eq!((mean([]), rms([]), variance(&[]), standard_deviation(&[1.0])), (0.0, 0.0, 0.0, 0.0));
    }

    #[test]
    fn quantiles_by_hand() {
        assert_eq!(quantile(&mut [], 0.5), None);
        assert_eq!(quantile(&mut [4.0, 2.0, 1.0], 0.0), Some(1.0));
        assert_eq!(quantile(&mut [1.0, 4.0, 2.0], 0.75), Some(3.0));
        assert_eq!(quantile(&mut [2.0, 1.0, 4.0], 1.0), Some(4.0));
        // 0 to 100 in another order
        let mut values: Vec<f64> = (0..101).map(|i| f64::from(i * 37 % 101)).collect();
        assert_eq!([0.3, 0.625, 0.95].map(|share| quantile(&mut values, share)), [Some(30.0), Some(62.5), Some(95.0)]);
    }
}
