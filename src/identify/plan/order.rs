//! Order of poses that shortens the motion of the joints.
//!
//! All joints of a motion from pose to pose start and end together, so that its length is the
//! largest motion of a joint as a share of the joint's span.

/// Number of poses at which the search starts.
const STARTS: usize = 64;
/// Maximum number of points whose paths are all improved; of more, the shortest path is.
const FEW: usize = 200;
/// Minimum shortening that counts, as a share of the span of a joint.
const SHORTER: f64 = 1e-9;
/// Maximum number of points that are ordered; more remain in the given order.
pub const MOST: usize = 2000;

/// Order of points, and its length.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// Indices of the points in the order of motion.
    pub points: Vec<usize>,
    /// Length of the motion: sum over its legs of the largest motion of a joint, as a share of the
    /// joint's span.
    pub length: f64,
}

/// Orders points by the nearest neighbour from several starts, then by swaps of two legs
/// (2-opt; Croes 1958).
///
/// The path is open. A point is its joint values at arrival and at departure; joints without a span
/// do not count.
///
/// # Examples
///
/// ```
/// use etalon_identify::plan::order::order;
///
/// // one joint of span 10: 0, 9, 1, 8 is 9 + 8 + 7 = 24 long, 0, 1, 8, 9 only 9
/// let points = [0.0, 9.0, 1.0, 8.0].map(|q| [vec![q], vec![q]]);
/// let best = order(&points, &[10.0]);
/// assert!(best.points == [0, 2, 3, 1] || best.points == [1, 3, 2, 0]);
/// assert!((best.length - 0.9).abs() < 1e-12);
/// ```
pub fn order(points: &[[Vec<f64>; 2]], spans: &[f64]) -> Order {
    let n = points.len();
    let given: Vec<usize> = (0..n).collect();
    if n > MOST {
        return Order { points: given, length: length_as_listed(points, spans) };
    }
    let lengths: Vec<f64> = points.iter().flat_map(|a| points.iter().map(|b| leg(&a[1], &b[0], spans))).collect();
    let length = |a: usize, b: usize| lengths[a * n + b];
    let total = |path: &[usize]| path.windows(2).map(|w| length(w[0], w[1])).sum::<f64>();
    let starts = (0..n.min(STARTS)).map(|start| nearest(start, n, length));
    let mut paths: Vec<Vec<usize>> = std::iter::once(given).chain(starts).collect();
    paths.sort_by(|a, b| total(a).total_cmp(&total(b)));
    if n > FEW {
        paths.truncate(1);
    }
    paths.iter_mut().for_each(|path| exchange(path, length));
    let path = paths.into_iter().min_by(|a, b| total(a).total_cmp(&total(b))).unwrap_or_default();
    Order { length: total(&path), points: path }
}

/// Length of the motion through points in the order of their list.
pub fn length_as_listed(points: &[[Vec<f64>; 2]], spans: &[f64]) -> f64 {
    points.windows(2).map(|pair| leg(&pair[0][1], &pair[1][0], spans)).sum()
}

/// Largest motion of a joint, as a share of its span.
fn leg(from: &[f64], to: &[f64], spans: &[f64]) -> f64 {
    let share = |((a, b), span): ((&f64, &f64), &f64)| if *span > 0.0 { (a - b).abs() / span } else { 0.0 };
    from.iter().zip(to).zip(spans).map(share).fold(0.0, f64::max)
}

/// Path from a start to the nearest point that is left.
fn nearest(start: usize, n: usize, length: impl Fn(usize, usize) -> f64) -> Vec<usize> {
    let mut left: Vec<usize> = (0..n).filter(|&i| i != start).collect();
    let (mut path, mut at) = (vec![start], start);
    while let Some(next) = (0..left.len()).min_by(|&a, &b| length(at, left[a]).total_cmp(&length(at, left[b]))) {
        at = left.remove(next);
        path.push(at);
    }
    path
}

/// Reverses parts of the path as long as that shortens it.
fn exchange(path: &mut [usize], length: impl Fn(usize, usize) -> f64) {
    let n = path.len();
    let is_symmetric = (0..n).all(|a| (0..a).all(|b| length(a, b) == length(b, a)));
    loop {
        let mut improved = false;
        for i in 0..n {
            for j in i + 1..n {
                let outer = |first: usize, last: usize| {
                    let before = i.checked_sub(1).map_or(0.0, |k| length(path[k], first));
                    before + path.get(j + 1).map_or(0.0, |next| length(last, *next))
                };
                let mut gain = outer(path[i], path[j]) - outer(path[j], path[i]);
                if !is_symmetric {
                    gain += path[i..=j].windows(2).map(|w| length(w[0], w[1]) - length(w[1], w[0])).sum::<f64>();
                }
                if gain > SHORTER {
                    path[i..=j].reverse();
                    improved = true;
                }
            }
        }
        if !improved {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    /// Length of the shortest of all orders.
    fn shortest(points: &[[Vec<f64>; 2]], spans: &[f64], path: &mut Vec<usize>) -> f64 {
        if path.len() == points.len() {
            return path.windows(2).map(|w| leg(&points[w[0]][1], &points[w[1]][0], spans)).sum();
        }
        let mut best = f64::INFINITY;
        for next in 0..points.len() {
            if !path.contains(&next) {
                path.push(next);
                best = best.min(shortest(points, spans, path));
                path.pop();
            }
        }
        best
    }

    #[test]
    fn orders_are_permutations_within_a_tenth_of_the_shortest_of_all() {
        let spans = [10.0, 300.0, 0.0];
        for trial in 0..20 {
            let mut noise = Noise::new(11, trial);
            let points: Vec<[Vec<f64>; 2]> = (0..7)
                .map(|_| {
                    let q = vec![noise.uniform(5.0), noise.uniform(150.0), noise.uniform(1e6)];
                    let other = q.iter().map(|v| v + if trial % 2 == 0 { 0.0 } else { noise.uniform(2.0) }).collect();
                    [q, other]
                })
                .collect();
            let found = order(&points, &spans);
            let mut sorted = found.points.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, (0..7).collect::<Vec<_>>());
            let best = shortest(&points, &spans, &mut Vec::new());
            assert!(found.length >= best - 1e-12 && found.length <= 1.1 * best, "{} {best}", found.length);
            assert!(found.length <= length_as_listed(&points, &spans) + 1e-12);
        }
        assert_eq!(order(&[], &[]).points, Vec::<usize>::new());
    }
}
