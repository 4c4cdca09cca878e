//! The step of a linear least-squares problem that stays in a region about zero: a ball, a box or both.

use super::run::{norm, sum_of_squares};
use super::{Factor, Side};

/// The scaled step of at most `radius` (to a tenth) that lowers the linear model most, and its damping λ
/// (Moré 1978, algorithm 5.5); `None` if no damping makes the factor regular.
pub(crate) fn trust_region_step(factor: &Factor, radius: f64, last_damping: f64) -> Option<(Vec<f64>, f64)> {
    let direction = |f: &Factor, p: &[f64], length: f64| {
        f.forward_substitute(p.iter().map(|p| p / length).collect()).map(|w| sum_of_squares(&w))
    };
    let mut lower = 0.0;
    if let Some(p) = factor.solve() {
        let length = norm(&p);
        if length <= 1.1 * radius {
            return Some((p, 0.0));
        }
        if let Some(w) = direction(factor, &p, length) {
            lower = (length - radius) / radius / w;
        }
    }
    let mut upper = norm(&factor.multiply_transposed(&factor.qtb)) / radius;
    if upper == 0.0 {
        upper = f64::MIN_POSITIVE / radius.min(0.1);
    }
    let mut damping = last_damping.clamp(lower.min(upper), upper);
    if damping == 0.0 {
        damping = (0.001 * upper).max((lower * upper).sqrt());
    }
    for attempt in 0..12 {
        let damped = factor.damped(damping.sqrt());
        let p = damped.solve()?;
        let length = norm(&p);
        let off = length - radius;
        if off.abs() <= 0.1 * radius || attempt == 11 {
            return Some((p, damping));
        }
        let correction = off / radius / direction(&damped, &p, length)?;
        if off > 0.0 {
            lower = f64::max(lower, damping)
        } else {
            upper = upper.min(damping)
        }
        damping = (damping + correction).max(lower);
        if damping > upper || damping <= 0.0 {
            damping = (lower * upper).sqrt().max(0.001 * upper);
        }
    }
    None
}

/// Minimises ‖R p − Qᵀb‖ in the box lower ≤ p ≤ upper, which holds zero; with the side that each element lies on.
///
/// Bounded-variable least squares by an active set (Stark & Parker 1995), from zero: every change lowers the norm, so
/// no set comes back. `None` where the free columns are dependent.
pub(super) fn in_box(factor: &Factor, lower: &[f64], upper: &[f64]) -> Option<(Vec<f64>, Vec<Side>)> {
    let n = factor.n;
    let mut p = vec![0.0; n];
    let mut sides: Vec<Side> =
        (0..n).map(|i| Side::outward(-descent(factor, &p, i), lower[i], upper[i], 0.0)).collect();
    // rounding could let a set come back; far fewer changes are ever needed
    for _ in 0..10 * n + 10 {
        let free: Vec<usize> = (0..n).filter(|&i| sides[i] == Side::Free).collect();
        let best = factor.columns(&free, &p).solve()?;
        let whole = free.iter().zip(&best).map(|(&i, &b)| (reach(p[i], b, lower[i], upper[i]), i));
        match whole.filter(|(t, _)| *t < 1.0).min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((t, first)) => {
                for (&i, b) in free.iter().zip(&best) {
                    p[i] = (p[i] + t * (b - p[i])).clamp(lower[i], upper[i]);
                }
                let position = free.iter().position(|&i| i == first)?;
                let down = best[position] < lower[first];
                sides[first] = if down { Side::Lower } else { Side::Upper };
                p[first] = if down { lower[first] } else { upper[first] };
            }
            None => {
                free.iter().zip(&best).for_each(|(&i, b)| p[i] = *b);
                let pulled = (0..n).map(|i| (inward(factor, &p, i, sides[i]), i));
                let limit = 1e-14 * norm(&factor.qtb);
                match pulled
                    .filter(|(pull, i)| *pull > limit && lower[*i] < upper[*i])
                    .max_by(|a, b| a.0.total_cmp(&b.0))
                {
                    Some((_, i)) => sides[i] = Side::Free,
                    None => break,
                }
            }
        }
    }
    Some((p, sides))
}

/// Half the rate at which the squared norm falls as element `i` of `p` grows.
fn descent(factor: &Factor, p: &[f64], i: usize) -> f64 {
    let left: Vec<f64> = factor.qtb.iter().zip(factor.multiply(p)).map(|(c, r)| c - r).collect();
    (0..=i).map(|k| factor.r(k, i) * left[k]).sum()
}

/// How strongly element `i` is pulled from its bound into the box.
fn inward(factor: &Factor, p: &[f64], i: usize, side: Side) -> f64 {
    match side {
        Side::Free => 0.0,
        Side::Lower => descent(factor, p, i),
        Side::Upper => -descent(factor, p, i),
    }
}

/// Part of the way from `from` to `to` that lies between the bounds; 1 for all of it.
fn reach(from: f64, to: f64, lower: f64, upper: f64) -> f64 {
    if to < lower {
        ((lower - from) / (to - from)).max(0.0)
    } else if to > upper {
        ((upper - from) / (to - from)).max(0.0)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_step_in_a_box_is_the_best_of_all_choices_of_sides() {
        // every choice of lower, free, upper for each element: the best one inside the box is the answer
        let mut noise = crate::base::noise::Noise::new(7, 0);
        for _ in 0..200 {
            let n = 4;
            let mut numbers = |k: usize| (0..k).map(|_| noise.gaussian(1.0)).collect::<Vec<f64>>();
            let (a, b) = (numbers(n * 6), numbers(6));
            let (lower, upper): (Vec<f64>, Vec<f64>) =
                numbers(n).iter().map(|w| if *w > 1.0 { (0.0, *w) } else { (-0.3 * w.abs(), 0.2 * w.abs()) }).unzip();
            let factor = Factor::new(&a, &b, &vec![1.0; n]);
            let norm_at = |p: &[f64]| {
                let off = |(row, b): (&[f64], &f64)| (row.iter().zip(p).map(|(a, p)| a * p).sum::<f64>() - b).powi(2);
                a.chunks_exact(n).zip(&b).map(off).sum::<f64>()
            };
            let mut least = f64::INFINITY;
            for choice in 0..3usize.pow(n as u32) {
                let side = |i: usize| choice / 3usize.pow(i as u32) % 3;
                let mut p: Vec<f64> = (0..n).map(|i| [0.0, lower[i], upper[i]][side(i)]).collect();
                let free: Vec<usize> = (0..n).filter(|&i| side(i) == 0).collect();
                let best = factor.columns(&free, &p).solve().unwrap();
                free.iter().zip(&best).for_each(|(&i, b)| p[i] = *b);
                if (0..n).all(|i| p[i] >= lower[i] && p[i] <= upper[i]) {
                    least = least.min(norm_at(&p));
                }
            }
            let (p, sides) = in_box(&factor, &lower, &upper).unwrap();
            assert!((norm_at(&p) - least).abs() < 1e-13 * least.max(1.0), "{} {least}", norm_at(&p));
            for i in 0..n {
                assert!(p[i] >= lower[i] && p[i] <= upper[i]);
                assert!(sides[i] != Side::Lower || p[i] == lower[i]);
                assert!(sides[i] != Side::Upper || p[i] == upper[i]);
            }
        }
    }
}
