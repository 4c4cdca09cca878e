//! Statistics of samples: mean, root mean square, standard deviation, quantiles.

use std::collections::BTreeMap;

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
    let (at, part) = rank(values.len(), share)?;
    let (_, &mut low, above) = values.select_nth_unstable_by(at, f64::total_cmp);
    let high = above.iter().copied().min_by(f64::total_cmp).unwrap_or(low);
    Some(low + part * (high - low))
}

/// Index of the order statistic at or below a quantile of `count` values, and the weight of the
/// next one; `None` without values.
fn rank(count: usize, share: f64) -> Option<(usize, f64)> {
    let rank = share * count.saturating_sub(1) as f64;
    let at = rank.floor() as usize;
    (at < count).then(|| (at, rank.fract()))
}

/// Values about a quantile of sizes, and the largest size.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UpperTail {
    /// Order statistic at or below the quantile.
    pub low: f64,
    /// Next order statistic.
    pub high: f64,
    /// Weight of `high` in the quantile.
    pub part: f64,
    /// Largest size.
    pub max: f64,
}

impl UpperTail {
    /// Tail of the sizes (absolute values) of values in any order, as [`quantile`]; `None` without
    /// values. Rearranges the values and removes their signs.
    pub fn from_sizes(values: &mut [f64], share: f64) -> Option<Self> {
        let (at, part) = rank(values.len(), share)?;
        // bits of non-negative numbers are in the order of the numbers
        values.iter_mut().for_each(|v| *v = v.abs());
        let (_, &mut low, above) = values.select_nth_unstable_by_key(at, |v| v.to_bits());
        let bits = || above.iter().map(|v| v.to_bits());
        let of = |bits: Option<u64>| bits.map_or(low, f64::from_bits);
        Some(Self { low, high: of(bits().min()), part, max: of(bits().max()) })
    }

    /// The quantile.
    pub fn quantile(&self) -> f64 {
        self.low + self.part * (self.high - self.low)
    }
}

/// Sums of sizes, for their mean and root mean square.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SizeSums {
    count: usize,
    sum: f64,
    squares: f64,
}

impl SizeSums {
    /// Adds the size of a value.
    pub fn add(&mut self, value: f64) {
        self.count += 1;
        self.sum += value.abs();
        self.squares += value * value;
    }

    /// Adds other sums.
    pub fn join(&mut self, other: &Self) {
        self.count += other.count;
        self.sum += other.sum;
        self.squares += other.squares;
    }

    /// Statistics of the sizes whose upper tail is `tail`.
    pub fn statistics(&self, tail: UpperTail) -> SizeStatistics {
        let count = self.count.max(1) as f64;
        let (mean, rms) = (self.sum / count, (self.squares / count).sqrt());
        SizeStatistics { mean, rms, p95: tail.quantile(), max: tail.max }
    }
}

/// Mean, root mean square, 95th percentile and maximum of sizes; zeros without values.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SizeStatistics {
    /// Mean.
    pub mean: f64,
    /// Root mean square.
    pub rms: f64,
    /// 95th percentile, as [`quantile`].
    pub p95: f64,
    /// Maximum.
    pub max: f64,
}

impl SizeStatistics {
    /// Statistics of the sizes of values in any order; rearranges the values and removes their
    /// signs.
    pub fn new(values: &mut [f64]) -> Self {
        let mut sums = SizeSums::default();
        values.iter().for_each(|value| sums.add(*value));
        sums.statistics(UpperTail::from_sizes(values, 0.95).unwrap_or_default())
    }
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

/// Interval score of a central prediction interval of probability 1 − `alpha` (Gneiting & Raftery
/// 2007, J. Am. Stat. Assoc. 102, 359, eq. 43): the width, and 2 / α times the distance of a value
/// outside. In the mean the quantiles α/2 and 1 − α/2 have the smallest score.
pub fn interval_score([low, high]: [f64; 2], value: f64, alpha: f64) -> f64 {
    high - low + 2.0 / alpha * ((low - value).max(0.0) + (value - high).max(0.0))
}

/// Standard uncertainty of a ratio Σ a / Σ b of sums over independent clusters (Cochran 1977,
/// Sampling Techniques, eq. 6.13, of few clusters among many); infinite with fewer than two.
pub fn ratio_uncertainty(clusters: impl IntoIterator<Item = [f64; 2]> + Clone) -> f64 {
    let (mut above, mut below, mut count) = (0.0, 0.0, 0usize);
    clusters.clone().into_iter().for_each(|[a, b]| (above, below, count) = (above + a, below + b, count + 1));
    if count < 2 {
        return f64::INFINITY;
    }
    let squares: f64 = clusters.into_iter().map(|[a, b]| (a - above / below * b).powi(2)).sum();
    (squares * count as f64 / (count - 1) as f64).sqrt() / below
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

/// Smallest numbers of repeated and of different rows, and of coordinates that vary, among which
/// repeats are told from rounding.
const REPEATS: usize = 3;
const DIFFERENT: usize = 4;
const VARYING: usize = 2;
/// Maximum number of pairs of rows that are equal in one coordinate only, as a share of the pairs
/// that are equal in all.
const ROUNDED: f64 = 0.1;

/// Rows that repeat an earlier row digit for digit: index of the row, and of the first such row.
///
/// Empty if rounding explains repeats. Coordinates of few digits are often equal in other pairs of
/// rows as well.
pub fn repeated_rows<const N: usize>(rows: &[[f64; N]]) -> Vec<[usize; 2]> {
    let pairs = |count: usize| 0.5 * count as f64 * (count as f64 - 1.0);
    // the sum makes −0 equal to 0
    let bits = |v: f64| (v + 0.0).to_bits();
    let mut groups: BTreeMap<[u64; N], (usize, usize)> = BTreeMap::new();
    let mut repeats = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let (first, count) = groups.entry(row.map(bits)).or_insert((i, 0));
        *count += 1;
        if *count > 1 {
            repeats.push([i, *first]);
        }
    }
    if repeats.len() < REPEATS || groups.len() < DIFFERENT {
        return Vec::new();
    }
    let equal: f64 = groups.values().map(|(_, count)| pairs(*count)).sum();
    let equal_in = |k: usize| {
        let mut counts: BTreeMap<u64, usize> = BTreeMap::new();
        rows.iter().for_each(|row| *counts.entry(bits(row[k])).or_default() += 1);
        (counts.len() > 1).then(|| counts.into_values().map(pairs).sum::<f64>())
    };
    let varying: Vec<f64> = (0..N).filter_map(equal_in).collect();
    let is_fine = |of_one: &f64| of_one - equal <= ROUNDED * equal;
    if varying.len() >= VARYING && varying.iter().all(is_fine) { repeats } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    #[test]
    fn sizes_have_the_quantile_of_their_absolute_values() {
        let sign = |k: u32| if k.is_multiple_of(3) { -1.0 } else { 1.0 };
        let s = SizeStatistics::new(&mut (1..=21u32).rev().map(|k| sign(k) * f64::from(k)).collect::<Vec<_>>());
        assert_eq!((s.mean, s.rms, s.p95, s.max), (11.0, (3311.0f64 / 21.0).sqrt(), 20.0, 21.0));
        assert_eq!(SizeStatistics::new(&mut []), SizeStatistics::default());
        for count in 1..40u32 {
            let values: Vec<f64> = (0..count).map(|k| sign(k) * f64::from(k * 7919 % 31)).collect();
            let mut sizes: Vec<f64> = values.iter().map(|v| v.abs()).collect();
            let tail = UpperTail::from_sizes(&mut values.clone(), 0.95).unwrap();
            assert_eq!(Some(tail.quantile()), quantile(&mut sizes, 0.95), "{count}");
            assert_eq!(Some(tail.max), sizes.into_iter().max_by(f64::total_cmp));
        }
    }

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
    fn interval_scores_by_hand() {
        // a width of 2; outside by 0.5 with 2 / 0.05 = 40
        assert_eq!(interval_score([-1.0, 1.0], 1.0, 0.05), 2.0);
        assert_eq!(interval_score([-1.0, 1.0], 1.5, 0.05), 22.0);
        assert_eq!(interval_score([-1.0, 1.0], -1.5, 0.5), 4.0);
        // of a standard normal the score of its own quantiles is 2 φ(z) · 2 / α
        // (scipy.stats.norm.expect: 4.675 for α = 0.05), less than that of other intervals
        let expected = |half: f64| {
            let (step, alpha) = (1e-3, 0.05);
            let density = |x: f64| (-x * x / 2.0).exp() / (2.0 * std::f64::consts::PI).sqrt();
            let values = (-8000..=8000).map(|k| f64::from(k) * step);
            values.map(|x| step * density(x) * interval_score([-half, half], x, alpha)).sum::<f64>()
        };
        let own = expected(1.959_963_985);
        assert!((own - 4.675_536_8).abs() < 1e-4, "{own}");
        assert!(expected(1.7) > own && expected(2.2) > own);
    }

    #[test]
    fn uncertainties_of_ratios_by_hand() {
        // one of two in each cluster: no scatter; all or nothing of pairs: a mean of 1 and 0
        assert_eq!(ratio_uncertainty([[1.0, 2.0], [1.0, 2.0]]), 0.0);
        assert_eq!(ratio_uncertainty([[2.0, 2.0], [0.0, 2.0]]), 0.5);
        assert_eq!(ratio_uncertainty([[1.0, 2.0]]), f64::INFINITY);
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

    #[test]
    fn repeated_rows_are_told_from_rounded_ones() {
        let mut noise = Noise::new(5, 0);
        let points: Vec<[f64; 3]> = (0..40).map(|_| [0; 3].map(|_| noise.gaussian(1.0))).collect();
        assert!(repeated_rows(&points).is_empty());
        let mut some = points.clone();
        some.extend([7, 3, 7].map(|i| points[i]));
        assert_eq!(repeated_rows(&some), [[40, 7], [41, 3], [42, 7]]);
        let twice = [points.clone(), points.clone()].concat();
        assert_eq!(repeated_rows(&twice).len(), 40);
        // rounded: points are equal by chance, also if they scatter along a line
        let rounded = |p: [f64; 3]| p.map(|v| (10.0 * v).round() / 10.0);
        let coarse: Vec<[f64; 3]> = (0..400).map(|_| rounded([0; 3].map(|_| noise.gaussian(1.0)))).collect();
        assert!(repeated_rows(&coarse).is_empty());
        let mut along = || {
            let t = noise.gaussian(1.0);
            rounded([t, 0.9 * t + 0.03, -0.7 * t])
        };
        let line: Vec<[f64; 3]> = (0..60).map(|_| along()).collect();
        assert!(repeated_rows(&line).is_empty());
        // points without scatter, two places by turns, and one coordinate alone show nothing
        assert!(repeated_rows(&[[1.0, 2.0, 3.0]; 30]).is_empty());
        let turns: Vec<[f64; 2]> = (0..30).map(|i| [f64::from(i % 2), -f64::from(i % 2)]).collect();
        assert!(repeated_rows(&turns).is_empty());
        assert!(repeated_rows(&twice.iter().map(|p| [p[0]]).collect::<Vec<_>>()).is_empty());
        assert!(repeated_rows::<3>(&[]).is_empty());
    }
}
