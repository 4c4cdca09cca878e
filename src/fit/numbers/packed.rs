//! Lossless storage of scans in half the memory: decimal numbers as integers of their last digit.

use etalon_base::pose::Vector;

/// Maximum number of decimals; other numbers are kept as doubles.
const MOST_DECIMALS: i32 = 9;

/// Points (mm) in the order of addition.
#[derive(Clone, Debug, Default)]
pub struct PackedPoints {
    blocks: Vec<Block>,
    /// Cumulative number of points up to each block.
    ends: Vec<usize>,
}

#[derive(Clone, Debug)]
enum Block {
    /// Integers to be divided by `tens`, then multiplied by `in_mm`.
    Decimal { whole: Vec<[i32; 3]>, tens: f64, in_mm: f64 },
    /// Values that are not decimals of at most nine digits.
    Real(Vec<Vector>),
}

impl Block {
    fn at(&self, i: usize) -> Vector {
        match self {
            Self::Decimal { whole, tens, in_mm } => whole[i].map(|n| f64::from(n) / tens * in_mm),
            Self::Real(points) => points[i],
        }
    }
}

impl PackedPoints {
    /// Stores points with these coordinates in a unit of `in_mm` millimetres. Retrieved values
    /// equal `coordinate * in_mm` to the last bit, except for the sign of zero.
    pub fn new([x, y, z]: &[Vec<f64>; 3], in_mm: f64) -> Self {
        let points = || x.iter().zip(y).zip(z).map(|((x, y), z)| [*x, *y, *z]);
        let packed = (0..=MOST_DECIMALS).find_map(|decimals| {
            let tens = 10f64.powi(decimals);
            let whole = |v: f64| {
                let n = (v * tens).round();
                (n.abs() <= f64::from(i32::MAX) && n / tens == v).then_some(n as i32)
            };
            points().map(|p| Some([whole(p[0])?, whole(p[1])?, whole(p[2])?])).collect::<Option<Vec<_>>>().map(
                |mut whole| {
                    whole.shrink_to_fit();
                    Block::Decimal { whole, tens, in_mm }
                },
            )
        });
        let block = packed.unwrap_or_else(|| Block::Real(points().map(|p| p.map(|v| v * in_mm)).collect()));
        Self { blocks: vec![block], ends: vec![x.len()] }
    }

    /// Appends the points of `other`.
    pub fn append(&mut self, other: Self) {
        let before = self.len();
        self.ends.extend(other.ends.iter().map(|end| before + end));
        self.blocks.extend(other.blocks);
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.ends.last().copied().unwrap_or_default()
    }

    /// `true` if there are no points.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Point `i`.
    pub fn at(&self, i: usize) -> Vector {
        let block = self.ends.partition_point(|end| *end <= i);
        self.blocks[block].at(i - block.checked_sub(1).map_or(0, |before| self.ends[before]))
    }

    /// Points of a range.
    pub fn range(&self, range: std::ops::Range<usize>) -> Vec<Vector> {
        let mut points = Vec::with_capacity(range.len());
        let mut block = self.ends.partition_point(|end| *end <= range.start);
        while points.len() < range.len() {
            let start = block.checked_sub(1).map_or(0, |before| self.ends[before]);
            let (from, to) = (range.start + points.len() - start, range.end.min(self.ends[block]) - start);
            match &self.blocks[block] {
                Block::Decimal { whole, tens, in_mm } => {
                    points.extend(whole[from..to].iter().map(|p| p.map(|n| f64::from(n) / tens * in_mm)));
                }
                Block::Real(all) => points.extend_from_slice(&all[from..to]),
            }
            block += 1;
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_come_back_to_the_last_bit() {
        let column = |values: &[&str]| values.iter().map(|v| v.parse().unwrap()).collect::<Vec<f64>>();
        let cases = [
            (["1.25", "-1234.567", "0"], true),
            (["0.1", "0.2", "0.30000000000000004"], false),
            (["-0", "-0.25", "2"], true),
            (["2147483.647", "-0.001", "7"], true),
            (["2147483.6471", "1", "1"], false),
            (["1e300", "nan", "inf"], false),
        ];
        let (mut all, mut expected) = (PackedPoints::default(), Vec::new());
        for in_mm in [1.0, 25.4, 1000.0] {
            for (row, decimal) in cases {
                let [x, y, z] = row.map(|v| column(&[v, "3.5"]));
                let packed = PackedPoints::new(&[x.clone(), y.clone(), z.clone()], in_mm);
                assert_eq!(matches!(packed.blocks[0], Block::Decimal { .. }), decimal, "{row:?}");
                expected.extend((0..2).map(|i| [x[i] * in_mm, y[i] * in_mm, z[i] * in_mm]));
                all.append(packed);
            }
        }
        // ignores the sign of zero
        let bits = |p: &Vector| p.map(|v| (v + 0.0).to_bits());
        assert_eq!(all.len(), expected.len());
        assert!((0..all.len()).all(|i| bits(&all.at(i)) == bits(&expected[i])));
        for from in 0..all.len() {
            for to in from..=all.len() {
                let range: Vec<_> = all.range(from..to).iter().map(bits).collect();
                assert_eq!(range, expected[from..to].iter().map(bits).collect::<Vec<_>>());
            }
        }
        assert!(PackedPoints::default().is_empty() && PackedPoints::default().range(0..0).is_empty());
    }

    #[test]
    fn a_fit_has_the_same_bits_packed_or_not() {
        use crate::{Element, FitSettings, element};
        let angle = |i: usize| i as f64 * 0.7;
        let round = |v: f64| (v * 1e4).round() / 1e4;
        let points: Vec<Vector> = (0..20_000)
            .map(|i| [50.0 * angle(i).cos() + 300.0, 50.0 * angle(i).sin() - 20.0, i as f64 / 100.0].map(round))
            .collect();
        let column = |k: usize| points.iter().map(|p| p[k]).collect::<Vec<f64>>();
        // parts that end within a block of the sums
        let mut packed = PackedPoints::default();
        for from in (0..points.len()).step_by(3000) {
            let to = points.len().min(from + 3000);
            packed.append(PackedPoints::new(&[0, 1, 2].map(|k| column(k)[from..to].to_vec()), 1.0));
        }
        for kind in [Element::Cylinder, Element::Plane, Element::Sphere, Element::Circle2d] {
            let (a, b) =
                (element(kind, &points, &FitSettings::default()), element(kind, &packed, &FitSettings::default()));
            assert_eq!(format!("{a:?}"), format!("{b:?}"));
        }
    }
}
