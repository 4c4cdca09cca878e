//! Linear Chebyshev problem: a and b that minimise the spread of z + a x + b y over all rows.
//!
//! The problem is solved for a few rows; the extreme rows are added and the rows that determine the
//! level are kept (exchange algorithm: Stiefel 1959). The level of a subset never exceeds the level
//! of all rows, so it is a bound at every step. The analogous problem for points in the plane is
//! the narrowest enclosing strip, which is parallel to an edge of their convex hull.

/// Smallest spread, its slope and the rows that determine it.
pub(crate) struct Level {
    /// Coefficients a and b.
    pub slope: [f64; 2],
    /// Largest minus smallest value of the rows in the subset: a lower bound for all rows, exact on
    /// convergence.
    pub spread: f64,
}

/// Maximum number of swaps; tens suffice in practice.
const EXCHANGES: usize = 300;
/// Maximum number of rows in the subset.
const TOGETHER: usize = 10;

/// Solves the problem for rows (x, y, z). Stops as soon as the spread is known to be at least
/// `enough`. `None` if all (x, y) are collinear.
pub(crate) fn least_spread(rows: &[[f64; 3]], enough: f64) -> Option<Level> {
    let mut set = first_rows(rows)?;
    let mut reached = f64::NEG_INFINITY;
    let size = |k: usize| rows.iter().fold(0.0f64, |m, row| m.max(row[k].abs()));
    let sizes = [size(0), size(1), size(2)];
    for _ in 0..EXCHANGES {
        let (level, holding) = solve_subset(rows, &set)?;
        if level.spread >= enough {
            return Some(level);
        }
        let [a, b] = level.slope;
        let rounding = 4.0 * f64::EPSILON * (sizes[2] + a.abs() * sizes[0] + b.abs() * sizes[1]);
        let (low, high) = extremes(rows, level.slope);
        let spread = value(&rows[high], level.slope) - value(&rows[low], level.slope);
        if spread <= level.spread + rounding || (set.contains(&low) && set.contains(&high)) {
            return Some(level);
        }
        // if the level does not rise, a removed row might return, so none is removed
        if level.spread > reached || set.len() > TOGETHER {
            set = holding.to_vec();
        }
        reached = reached.max(level.spread);
        set.extend([low, high]);
        set.sort_unstable();
        set.dedup();
    }
    solve_subset(rows, &set).map(|(level, _)| level)
}

/// Four additional rows that keep the slope within `reach`. The rows lie between the extremes if
/// |a| and |b| are at most `reach`, and beyond the extremes otherwise. Empty if the extremes can
/// change places within `reach`.
pub(crate) fn fence(rows: &[[f64; 3]], reach: f64) -> Vec<[f64; 3]> {
    let (low, high) = extremes(rows, [0.0; 2]);
    let [x, y, z] = rows[high];
    // relative to the highest row, which is fixed
    let rise = 2f64.sqrt() * reach * (rows[low][0] - x).hypot(rows[low][1] - y);
    let steep = (z - rows[low][2] - rise) / (2.0 * reach);
    let aside = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].into_iter().filter(|_| steep > 0.0);
    aside.map(|[i, j]| [x + i * steep, y + j * steep, z - reach * steep]).collect()
}

pub(crate) fn value(row: &[f64; 3], slope: [f64; 2]) -> f64 {
    row[2] + slope[0] * row[0] + slope[1] * row[1]
}

/// Indices of the rows with the smallest and the largest value.
pub(crate) fn extremes(rows: &[[f64; 3]], slope: [f64; 2]) -> (usize, usize) {
    let mut low = (0, f64::INFINITY);
    let mut high = (0, f64::NEG_INFINITY);
    for (i, row) in rows.iter().enumerate() {
        let v = value(row, slope);
        if v < low.1 {
            low = (i, v);
        }
        if v > high.1 {
            high = (i, v);
        }
    }
    (low.0, high.0)
}

/// Three rows that span a triangle, and the two rows of extreme z.
fn first_rows(rows: &[[f64; 3]]) -> Option<Vec<usize>> {
    let flat = |i: usize| [rows[i][0], rows[i][1]];
    let largest = |f: &dyn Fn(usize) -> f64| (0..rows.len()).max_by(|&i, &j| f(i).total_cmp(&f(j)));
    let distance = |i: usize, j: usize| {
        let [x, y] = between(flat(i), flat(j));
        x.hypot(y)
    };
    let one = largest(&|i| flat(i)[0])?;
    let two = largest(&|i| distance(one, i))?;
    let edge = between(flat(one), flat(two));
    let area = |i: usize| cross(edge, between(flat(one), flat(i))).abs();
    let three = largest(&area)?;
    if area(three) <= 0.0 {
        return None;
    }
    let (low, high) = extremes(rows, [0.0; 2]);
    let mut set = vec![one, two, three, low, high];
    set.sort_unstable();
    set.dedup();
    Some(set)
}

/// Solution for the rows in `set`, and the four rows that determine it (three if there are no
/// more).
///
/// At the minimum four rows are at the upper or lower level. Each choice of four rows and of their
/// levels gives a slope, which is judged by its spread over the whole set.
fn solve_subset(rows: &[[f64; 3]], set: &[usize]) -> Option<(Level, Vec<usize>)> {
    let mut best: Option<(Level, Vec<usize>)> = None;
    let mut consider = |slope: [f64; 2], holding: &[usize]| {
        let (low, high) = set.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &i| {
            let v = value(&rows[i], slope);
            (low.min(v), high.max(v))
        });
        let spread = high - low;
        if spread.is_finite() && best.as_ref().is_none_or(|b| spread < b.0.spread) {
            best = Some((Level { slope, spread }, holding.to_vec()));
        }
    };
    let less = |i: usize, j: usize| [0, 1, 2].map(|k| rows[i][k] - rows[j][k]);
    if let [i, j, k] = *set {
        let (u, v) = (less(j, i), less(k, i));
        let area = u[0] * v[1] - u[1] * v[0];
        consider([(v[2] * u[1] - u[2] * v[1]) / area, (u[2] * v[0] - v[2] * u[0]) / area], set);
    }
    for (p, &i) in set.iter().enumerate() {
        for (q, &j) in set.iter().enumerate().skip(p + 1) {
            for (r, &k) in set.iter().enumerate().skip(q + 1) {
                for &l in &set[r + 1..] {
                    let edges = [less(j, i), less(k, i), less(l, i)];
                    // each bit is set if the row is on the opposite level to row i
                    for sides in 1..8u8 {
                        if let Some(slope) = level_slope(&edges, sides) {
                            consider(slope, &[i, j, k, l]);
                        }
                    }
                }
            }
        }
    }
    best
}

/// Solves dz + a dx + b dy + s w = 0 for a and b, for three edges, where s = 1 if the bit is set
/// (Cramer's rule).
fn level_slope(edges: &[[f64; 3]; 3], sides: u8) -> Option<[f64; 2]> {
    let s = [0, 1, 2].map(|k| f64::from(sides >> k & 1));
    let minor = |k: usize, l: usize, m: usize, n: usize| edges[k][m] * edges[l][n] - edges[l][m] * edges[k][n];
    let by_sides = |m: usize, n: usize| s[0] * minor(1, 2, m, n) - s[1] * minor(0, 2, m, n) + s[2] * minor(0, 1, m, n);
    let determinant = by_sides(0, 1);
    let slope = [by_sides(1, 2) / determinant, -by_sides(0, 2) / determinant];
    slope.iter().all(|x| x.is_finite()).then_some(slope)
}

/// Smallest growth of the spread per unit length of the slope, over all directions; negative if the
/// spread decreases in a direction. `upper` and `lower` are the (x, y) of the rows at the two
/// levels.
///
/// The growth is the distance from zero to the boundary of the polygon upper − lower, whose edges
/// are edges of the two hulls.
pub(crate) fn growth(upper: &[[f64; 2]], lower: &[[f64; 2]]) -> f64 {
    let mut least = f64::NEG_INFINITY;
    let farthest = |points: &[[f64; 2]], n: [f64; 2]| {
        points.iter().fold(f64::NEG_INFINITY, |m, p| m.max(n[0] * p[0] + n[1] * p[1]))
    };
    for (points, sign) in [(upper, 1.0), (lower, -1.0)] {
        let corners = hull(points);
        let count = corners.len();
        for k in 0..if count < 2 { 0 } else { count } {
            let [x, y] = between(points[corners[k]], points[corners[(k + 1) % count]]);
            let length = sign * x.hypot(y);
            let outward = [y / length, -x / length];
            let reach = farthest(upper, outward) + farthest(lower, outward.map(|x| -x));
            least = if least == f64::NEG_INFINITY { reach } else { least.min(reach) };
        }
    }
    least
}

/// Indices of the corners of the convex hull, anticlockwise; two for collinear points, one for
/// identical points.
///
/// Monotone chain algorithm (Andrew 1979).
pub(crate) fn hull(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| points[i][0].total_cmp(&points[j][0]).then(points[i][1].total_cmp(&points[j][1])));
    order.dedup_by(|i, j| points[*i] == points[*j]);
    if order.len() < 3 {
        return order;
    }
    let mut corners = half(points, order.iter().copied());
    corners.extend(half(points, order.into_iter().rev()));
    corners
}

/// One side of the hull without its last corner.
fn half(points: &[[f64; 2]], order: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for i in order {
        while let [.., a, b] = chain[..]
            && cross(between(points[a], points[b]), between(points[a], points[i])) <= 0.0
        {
            chain.pop();
        }
        chain.push(i);
    }
    chain.pop();
    chain
}

/// Narrowest enclosing strip.
pub(crate) struct Strip {
    /// Ends of the hull edge on one side.
    pub edge: [usize; 2],
    pub width: f64,
}

/// Finds the narrowest enclosing strip. One side of it is an edge of the hull (Houle & Toussaint
/// 1988), so every edge is tried while the opposite corner advances. `None` for identical points.
pub(crate) fn narrowest_strip(points: &[[f64; 2]]) -> Option<Strip> {
    let corners = hull(points);
    let count = corners.len();
    let corner = |k: usize| points[corners[k % count]];
    let mut best: Option<Strip> = None;
    let mut far = 1;
    for k in 0..if count < 2 { 0 } else { count } {
        let edge = between(corner(k), corner(k + 1));
        far = far.max(k + 1);
        while far < k + count && cross(edge, between(corner(far), corner(far + 1))) > 0.0 {
            far += 1;
        }
        let width = cross(edge, between(corner(k), corner(far))) / edge[0].hypot(edge[1]);
        if best.as_ref().is_none_or(|b| width < b.width) {
            let index = |k: usize| corners[k % count];
            best = Some(Strip { edge: [index(k), index(k + 1)], width });
        }
    }
    best
}

pub(crate) fn between(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [b[0] - a[0], b[1] - a[1]]
}

pub(crate) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    #[test]
    fn the_level_is_the_largest_of_all_fours() {
        // de la Vallée Poussin: the smallest spread is the largest of the smallest spreads of four
        // rows
        for trial in 0..200 {
            let mut noise = Noise::new(3, trial);
            let rows: Vec<[f64; 3]> = (0..11).map(|_| [0; 3].map(|_| noise.gaussian(1.0))).collect();
            let mut largest = 0.0f64;
            for l in 3..rows.len() {
                for k in 2..l {
                    for j in 1..k {
                        for i in 0..j {
                            // the linear dependence of (1, x, y): Σ c = Σ c x = Σ c y = 0
                            let four = [i, j, k, l].map(|i| rows[i]);
                            let c = [0, 1, 2, 3].map(|m| {
                                let o: Vec<[f64; 3]> = (0..4).filter(|n| *n != m).map(|n| four[n]).collect();
                                let area = (o[1][0] - o[0][0]) * (o[2][1] - o[0][1])
                                    - (o[2][0] - o[0][0]) * (o[1][1] - o[0][1]);
                                if m % 2 == 0 { area } else { -area }
                            });
                            let z: f64 = c.iter().zip(four).map(|(c, row)| c * row[2]).sum();
                            let size: f64 = c.iter().map(|c| c.abs()).sum();
                            largest = largest.max(2.0 * z.abs() / size);
                        }
                    }
                }
            }
            let level = least_spread(&rows, f64::INFINITY).unwrap();
            assert!((level.spread / largest - 1.0).abs() < 1e-12, "{} {largest}", level.spread);
        }
    }

    #[test]
    fn the_growth_of_crossing_segments() {
        // upper (±1, 0), lower (0, ±1): upper − lower is the square with corners (±1, ±1)
        let found = growth(&[[1.0, 0.0], [-1.0, 0.0]], &[[0.0, 1.0], [0.0, -1.0]]);
        assert!((found - 1.0).abs() < 1e-15, "{found}");
        assert!(growth(&[[1.0, 0.0], [2.0, 0.0]], &[[0.0, 1.0], [0.0, -1.0]]) < 0.0);
        assert_eq!(growth(&[[1.0, 0.0]], &[[0.0, 0.0]]), f64::NEG_INFINITY);
    }
}
