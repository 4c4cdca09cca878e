//! Observability of the parameters: its indices, and parameters that are weakly identifiable.

use crate::error::quoted;
use crate::model::residuals::Residuals;
use etalon_base::catalogue::{Argument, IntoArgument, Phrase};
use etalon_base::message::Message;
use etalon_base::{phrase, warning};
use etalon_math::statistics::mean;
use etalon_math::{Factor, Problem, Svd, svd};
use etalon_robots::{Quantity, Robot};
use std::collections::BTreeSet;

/// Singular values of the Jacobian and the indices computed from them (eq. 1.19 to 1.25).
///
/// The indices follow from the Jacobian in mm per mm and mm per rad, without weights. The condition
/// number follows from the Jacobian with its columns divided by their norms.
#[derive(Clone, Debug, PartialEq)]
pub struct Observability {
    /// O1 to O5. O1 is (σ1…σm)^(1/m) / √n with m parameters and n poses (Sun & Hollerbach 2008).
    pub indices: [f64; 5],
    /// Condition number with scaled columns.
    pub condition: f64,
    /// Number of parameters that are separately identifiable.
    pub rank: usize,
    /// Number of coordinates of unknown points that were eliminated because of their large number:
    /// indices and singular values belong to the reduced Jacobian.
    pub eliminated: usize,
    /// Singular values of the Jacobian with its columns divided by their norms, descending: the
    /// first over the last is the condition number.
    pub singular_values: Vec<SingularValue>,
    /// Smallest singular values of the Jacobian with all parameters to be identified, as many as
    /// are held: unobservable directions. Empty if none is held, and before a measurement.
    pub held_singular_values: Vec<SingularValue>,
}

/// Response of the residuals to a direction of the parameters, and the main parameters of this
/// direction.
#[derive(Clone, Debug, PartialEq)]
pub struct SingularValue {
    /// The singular value.
    pub value: f64,
    /// Indices of parameters with a share of more than 0.3 in its right singular vector, the
    /// largest first.
    pub parameters: Vec<usize>,
}

/// Parameters that are weakly identifiable: their uncertainties are large and cancel each other.
#[derive(Clone, Debug, PartialEq)]
pub struct WeakGroup {
    /// Indices of the parameters.
    pub parameters: Vec<usize>,
    /// Their predicted standard uncertainties (mm, rad, 1).
    pub standard_uncertainties: Vec<f64>,
    /// Largest absolute correlation among them.
    pub correlation: f64,
}

/// Limit of weakly identifiable parameters: their uncertainty alone moves the targets by more than
/// this multiple of the instrument's resolution (root mean square over the residuals, each pose
/// measured once).
const WEAK_EFFECT: f64 = 10.0;
/// Minimum share of a parameter in a singular vector.
const MEMBER: f64 = 0.3;
/// Minimum absolute correlation that binds two parameters.
const BOUND: f64 = 0.9;

/// Observability at `x`, where the Jacobian with its columns divided by `scale` has this factor,
/// and the groups of parameters that are weakly identifiable there.
pub(crate) fn observe(
    problem: &Residuals,
    x: &[f64],
    factor: &Factor,
    scale: &[f64],
    covariance: Option<&[f64]>,
) -> Option<(Observability, Vec<WeakGroup>)> {
    let plain = (problem.is_whitened() || problem.is_weighted()).then(|| plain(problem, x));
    let (factor, scale) = plain.as_ref().map_or((factor, scale), |(factor, scale)| (factor, scale.as_slice()));
    let (all, common) = (factor.columns(), factor.common());
    let (n, free) = (common.len(), common_parameters(problem, factor));
    let scaled = svd(factor);
    let scale: Vec<f64> = common.iter().map(|&j| scale[j]).collect();
    let unscaled = svd(&unscale(factor, &scale, problem.unit));
    let observability = Observability {
        indices: indices(&unscaled, problem.observation_count())?,
        condition: Some(scaled.condition()).filter(|c| c.is_finite())?,
        rank: all,
        eliminated: all - n,
        singular_values: singular_values(&scaled, &free),
        held_singular_values: Vec::new(),
    };
    let Some(covariance) = covariance else { return Some((observability, Vec::new())) };
    let of = |i: usize, j: usize| covariance[common[i] * all + common[j]];
    let u = |k: usize| of(k, k).sqrt();
    let correlation = |i: usize, j: usize| of(i, j) / (u(i) * u(j));
    // repeats make every parameter better known, not better separable
    let mut poses = problem.poses();
    let rows = poses.len() as f64;
    poses.dedup();
    let repeated = poses.len() as f64;
    poses.sort_unstable();
    poses.dedup();
    let rows = rows * poses.len() as f64 / repeated;
    let mut weak: Vec<WeakGroup> = Vec::new();
    for k in (0..n).filter(|&k| 1.0 / (scaled.values[k] * rows.sqrt()) > WEAK_EFFECT) {
        let members: Vec<usize> = (0..n).filter(|&j| scaled.vectors[k][j].abs() > MEMBER).collect();
        for bound in bind(&members, &correlation) {
            let parameters: Vec<usize> = bound.iter().map(|&j| free[j]).collect();
            if weak.iter().any(|w| w.parameters == parameters) {
                continue;
            }
            let pairs = bound.iter().flat_map(|&i| bound.iter().filter(move |&&j| j > i).map(move |&j| (i, j)));
            let stronger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
            weak.push(WeakGroup {
                standard_uncertainties: bound.iter().map(|&j| u(j)).collect(),
                parameters,
                correlation: pairs.map(|(i, j)| correlation(i, j)).fold(0.0, stronger),
            });
        }
    }
    Some((observability, weak))
}

/// The smallest singular values with all parameters of `problem`, as many as are not among the
/// `identified` ones.
pub(crate) fn held_singular_values(
    problem: &Residuals,
    values: &[f64],
    identified: &Observability,
) -> Vec<SingularValue> {
    if problem.free.len() == identified.rank {
        return Vec::new();
    }
    let x: Vec<f64> = problem.free.iter().map(|&i| values[i]).collect();
    let factor = plain(problem, &x).0;
    let mut all = singular_values(&svd(&factor), &common_parameters(problem, &factor));
    all.split_off(identified.singular_values.len().min(all.len()))
}

/// The parameters of the common columns.
fn common_parameters(problem: &Residuals, factor: &Factor) -> Vec<usize> {
    factor.common().into_iter().map(|j| problem.free[j]).collect()
}

fn singular_values(svd: &Svd, free: &[usize]) -> Vec<SingularValue> {
    let of = |(&value, vector): (&f64, &Vec<f64>)| {
        let mut members: Vec<usize> = (0..free.len()).filter(|&j| vector[j].abs() > MEMBER).collect();
        members.sort_by(|&i, &j| vector[j].abs().total_cmp(&vector[i].abs()));
        SingularValue { value, parameters: members.into_iter().map(|j| free[j]).collect() }
    };
    svd.values.iter().zip(&svd.vectors).map(of).collect()
}

/// Factor and column norms of the Jacobian before whitening.
fn plain(problem: &Residuals, x: &[f64]) -> (Factor, Vec<f64>) {
    let mut jacobian = vec![0.0; problem.residual_count() * problem.width()];
    problem.plain_jacobian(x, &mut jacobian);
    let rows = problem.jacobian_rows(&jacobian);
    let scale = rows.norms();
    (rows.factor(&vec![0.0; problem.residual_count()], &scale), scale)
}

/// Splits `members` into sets bound by correlation, because vectors of nearly equal singular values
/// mix unrelated parameters. If no two are bound, all are weakly identifiable together.
fn bind(members: &[usize], correlation: &dyn Fn(usize, usize) -> f64) -> Vec<Vec<usize>> {
    let mut sets: Vec<Vec<usize>> = Vec::new();
    for &j in members {
        let near = |set: &Vec<usize>| set.iter().any(|&i| correlation(i, j).abs() >= BOUND);
        let (mut joined, rest): (Vec<_>, Vec<_>) = sets.into_iter().partition(near);
        joined.push(vec![j]);
        sets = rest;
        let mut set = joined.concat();
        set.sort_unstable();
        sets.push(set);
    }
    sets.retain(|set| set.len() > 1);
    if sets.is_empty() { vec![members.to_vec()] } else { sets }
}

/// The factor of the Jacobian without column scaling and weights.
fn unscale(factor: &Factor, scale: &[f64], unit: f64) -> Factor {
    let n = scale.len();
    let rows: Vec<f64> = (0..n * n).map(|k| factor.r(k / n, k % n) * unit).collect();
    let inverse: Vec<f64> = scale.iter().map(|s| 1.0 / s).collect();
    Factor::new(&rows, &vec![0.0; n], &inverse)
}

/// O1 to O5 from the singular values (eq. 1.19, 1.20, 1.22, 1.23, 1.25).
fn indices(svd: &Svd, poses: usize) -> Option<[f64; 5]> {
    let (&largest, &smallest) = (svd.values.first()?, svd.values.last()?);
    let mean_log = mean(svd.values.iter().map(|s| s.ln()));
    let harmonic: f64 = svd.values.iter().map(|s| 1.0 / s).sum();
    let all = [
        mean_log.exp() / (poses as f64).sqrt(),
        smallest / largest,
        smallest,
        smallest * smallest / largest,
        1.0 / harmonic,
    ];
    all.iter().all(|o| o.is_finite()).then_some(all)
}

/// One message of all parameters that are weakly identifiable.
pub(crate) fn weak_message(robot: &dyn Robot, weak: &[WeakGroup]) -> Option<Message> {
    let parameters = robot.parameters();
    let u = |(&i, &u): (&usize, &f64)| {
        let (parameter, quantity) = (&parameters[i].name, parameters[i].quantity);
        match (quantity, parameters[i].full_unit()) {
            (Quantity::Ratio, None) => phrase!("uncertainty-of-ratio", parameter, u),
            _ => {
                let unit = parameters[i].printed_unit();
                phrase!("uncertainty-of-parameter", parameter, u = quantity.outward(u), unit)
            }
        }
    };
    let group = |w: &WeakGroup| {
        let names = quoted(&w.parameters.iter().map(|&i| &parameters[i].name).collect::<Vec<_>>());
        let rest = names.split_last().filter(|(_, rest)| !rest.is_empty());
        rest.map_or_else(
            || names.argument(),
            |(second, first)| phrase!("parameter-group", first = first.to_vec(), second).argument(),
        )
    };
    let groups: Vec<Argument> = weak.iter().map(group).collect();
    let message = match weak {
        [] => return None,
        [w] => {
            let uncertainties: Vec<Phrase> = w.parameters.iter().zip(&w.standard_uncertainties).map(u).collect();
            warning!("parameters-weakly-identifiable", groups, uncertainties, correlation = w.correlation)
        }
        several => {
            // members of a group are separated by commas
            let joined = |others: Argument, first: Argument| phrase!("parameter-groups", first, others).argument();
            let groups = groups.into_iter().rev().reduce(joined);
            let uncertainties: Vec<Phrase> = largest(robot, several).iter().map(|(i, value)| u((i, value))).collect();
            warning!("parameter-groups-weakly-identifiable", count = several.len(), groups, uncertainties)
        }
    };
    let mut remedies: Vec<Phrase> = weak.iter().filter_map(|w| robot.remedy(&w.parameters)).collect();
    remedies.dedup();
    let hint = remedies.into_iter().next().unwrap_or_else(|| wider(robot, weak));
    Some(message.hint(hint))
}

/// Parameters with the largest standard uncertainty, one of each quantity.
fn largest(robot: &dyn Robot, weak: &[WeakGroup]) -> Vec<(usize, f64)> {
    let all = weak.iter().flat_map(|w| w.parameters.iter().copied().zip(w.standard_uncertainties.iter().copied()));
    let of = |quantity: Quantity| {
        let all = all.clone().filter(move |(i, _)| robot.parameters()[*i].quantity == quantity);
        all.max_by(|a, b| a.1.total_cmp(&b.1))
    };
    [Quantity::Angle, Quantity::Length, Quantity::Ratio].into_iter().filter_map(of).collect()
}

/// Hint at poses that separate the parameters of each group: a held parameter keeps its error.
fn wider(robot: &dyn Robot, weak: &[WeakGroup]) -> Phrase {
    let of = weak.iter().flat_map(|w| &w.parameters).filter_map(|&i| robot.parameters()[i].joint);
    let joints: BTreeSet<usize> = of.collect();
    let joints: Vec<&str> = joints.iter().filter_map(|&j| Some(robot.joints().get(j)?.name.as_str())).collect();
    if joints.is_empty() {
        return phrase!("separate-parameters");
    }
    phrase!("separate-parameters-by-joints", joints = quoted(&joints))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_robots::{Serial, SerialJoint};

    fn arm() -> Serial {
        let row = |(alpha_rad, a_mm, d_mm)| SerialJoint {
            alpha_rad,
            a_mm,
            theta_rad: 0.0,
            d_mm,
            prismatic: false,
            parallel: false,
        };
        let rows = [(0.0, 0.0, 400.0), (-1.57, 50.0, 10.0), (1.2, 300.0, 20.0), (-1.4, 40.0, 200.0)].map(row);
        Serial::new(&rows, &["ball".to_owned()], [0.0, 0.0, -1.0], &[], &[])
    }

    fn weak(robot: &Serial, members: &[(&str, f64)]) -> WeakGroup {
        WeakGroup {
            parameters: members.iter().map(|(name, _)| robot.index(name).unwrap()).collect(),
            standard_uncertainties: members.iter().map(|(_, u)| *u).collect(),
            correlation: 0.99,
        }
    }

    #[test]
    fn groups_are_separated_by_semicolons_and_state_their_largest_uncertainties() {
        let robot = arm();
        let groups = [
            weak(&robot, &[("d_2", 4.0), ("alpha_3", 0.02)]),
            weak(&robot, &[("base_rz", 0.01), ("theta_1", 0.05), ("a_4", 1.5)]),
            weak(&robot, &[("base_x", 7.25), ("base_rx", 0.01)]),
        ];
        let message = weak_message(&robot, &groups).unwrap();
        assert!(message.is("parameter-groups-weakly-identifiable", &[("count", &3)]), "{message:?}");
        assert!(message.what.contains("u(theta_1) = 2.865 deg, u(base_x) = 7.250 mm"), "{message:?}");
        let Argument::Phrase(listed) = &message.arguments["groups"] else { panic!("{message:?}") };
        assert_eq!(listed.text("en"), "`d_2` and `alpha_3`; `base_rz`, `theta_1` and `a_4`; `base_x` and `base_rx`");
        assert_eq!(listed.text("de"), "`d_2` und `alpha_3`; `base_rz`, `theta_1` und `a_4`; `base_x` und `base_rx`");
        assert_eq!(listed.text("fr").matches("\u{202f}; ").count(), 2);
        // the hint names the joints of the parameters, and holds nothing
        let expected = phrase!("separate-parameters-by-joints", joints = ["`q1`", "`q2`", "`q3`", "`q4`"]);
        assert_eq!(wider(&robot, &groups), expected);
        assert_eq!(wider(&robot, &groups[2..]), phrase!("separate-parameters"));
    }
}
