//! Comparison of two logs of the same poses: correlation of their difference with the residuals.

use crate::Observation;
use etalon_robots::Robot;

/// Relation of the residuals of one log to its difference from another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogComparison {
    /// Correlation, over all measured coordinates, of the residuals (measured − predicted with the
    /// first log) with the displacement that the second log predicts.
    pub correlation: f64,
    /// Coordinates compared.
    pub count: usize,
}

/// Compares the residuals of `observations` with the displacement that the joints of `others`
/// predict.
///
/// Observations are matched by pose and cycle; both lists must have been made for the same robot.
pub fn compare_logs(
    robot: &dyn Robot,
    values: &[f64],
    observations: &[Observation],
    others: &[Observation],
) -> Option<LogComparison> {
    let by_key: std::collections::BTreeMap<_, _> = others.iter().map(|o| ((o.pose, o.cycle), o)).collect();
    let dimension = robot.dimension();
    let (mut here, mut there) =
        (vec![0.0; dimension * robot.targets().len()], vec![0.0; dimension * robot.targets().len()]);
    let mut pairs = Vec::new();
    for o in observations {
        let Some(other) = by_key.get(&(o.pose, o.cycle)) else { continue };
        robot.positions(values, &o.joints, &mut here);
        robot.positions(values, &other.joints, &mut there);
        for (k, measured) in o.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            let both = here[k * dimension..].iter().zip(&there[k * dimension..]).take(dimension);
            pairs.extend(measured.iter().zip(both).map(|(m, (here, there))| (m - here, there - here)));
        }
    }
    Some(LogComparison { correlation: pearson(&pairs)?, count: pairs.len() })
}

/// Correlation coefficient of pairs; `None` if one side is constant.
fn pearson(pairs: &[(f64, f64)]) -> Option<f64> {
    let n = pairs.len() as f64;
    let (mx, my) = pairs.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / n, y + p.1 / n));
    let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
    for (x, y) in pairs {
        xx += (x - mx) * (x - mx);
        yy += (y - my) * (y - my);
        xy += (x - mx) * (y - my);
    }
    let r: f64 = xy / (xx * yy).sqrt();
    r.is_finite().then_some(r)
}

#[cfg(test)]
mod tests {
    use crate::{Fitted, Observation, Settings, identify};
    use etalon_robots::{Prexyt, Robot};

    #[test]
    fn a_fit_without_uncertainties_has_the_values_of_an_identification() {
        let robot = Prexyt::default();
        let truth = robot.nominal();
        let corner = |pose: i64| {
            let joints = [1, 2, 4].map(|bit| if pose & bit == 0 { 0.0 } else { 150.0 });
            let off = 0.01 * (pose % 3 - 1) as f64;
            let targets = robot.balls(&truth, &joints).map(|[x, y]| Some([x + off, y - off, 0.0])).to_vec();
            Observation { pose: pose.into(), joints: joints.into(), targets, ..Observation::default() }
        };
        let observations: Vec<Observation> = (0..8).map(corner).collect();
        let found = identify(&robot, &observations, &Settings::default()).unwrap();
        let fitted = Fitted::new(&robot, &observations, &Settings::default()).unwrap();
        assert_eq!((fitted.values, fitted.rms), (found.values, found.residuals.rms));
        assert!(fitted.rms > 1e-4, "{}", fitted.rms);
    }

    #[test]
    fn pearson_of_a_line_and_of_a_constant() {
        assert!((super::pearson(&[(1.0, 2.0), (2.0, 4.0), (3.0, 6.0)]).unwrap() - 1.0).abs() < 1e-15);
        assert!(super::pearson(&[(1.0, 2.0), (2.0, 2.0)]).is_none());
    }
}
