//! Frame from three points by the rules of controllers.

use super::{CellFault, CellFrame};
use crate::judgement::bound::ASSUMED_MM;
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm, unit};
use nalgebra::{Matrix3, SMatrix};

/// Meaning of the three points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreePointRole {
    /// Origin, point on the positive x axis, point of the x-y plane with positive y.
    OriginXPlane,
    /// Two points on the x axis in its direction, and a point on the positive y axis; the origin
    /// is the foot of the third point on the axis.
    XXY,
}

/// Frame from three points.
#[derive(Clone, Debug, PartialEq)]
pub struct ThreePoints {
    /// Frame in the frame of the points.
    pub frame: CellFrame,
    /// Standard deviation of repeated readings of a point (mm), and its degrees of freedom;
    /// `None` without repeats.
    pub repeats: Option<(f64, usize)>,
    /// Standard uncertainty of a coordinate of a reading that the covariance contains; `None` if it
    /// is unknown: the covariance then contains an assumed one (0.01 mm).
    pub standard_uncertainty_mm: Option<f64>,
}

/// Mean of the readings of a point.
fn mean(points: &[Vector]) -> Vector {
    let n = points.len().max(1) as f64;
    points.iter().fold([0.0; 3], |s, p| [0, 1, 2].map(|k| s[k] + p[k] / n))
}

/// Standard deviation of repeats, with degrees of freedom.
fn repeats(points: [&[Vector]; 3]) -> Option<(f64, usize)> {
    let (mut squares, mut freedom) = (0.0, 0);
    for of_point in points {
        let centre = mean(of_point);
        squares += of_point.iter().map(|p| norm(minus(*p, centre)).powi(2)).sum::<f64>();
        freedom += 3 * (of_point.len().max(1) - 1);
    }
    (freedom > 0).then(|| ((squares / freedom as f64).sqrt(), freedom))
}

/// Distance of the third point from the x axis, relative to its distance from the first point,
/// below which the points are collinear but for rounding.
const LEAST_HEIGHT: f64 = 1e-7;

/// Frame by the rule of three points, each with one or several readings. The uncertainty of a
/// coordinate is `stated_mm` if repeats agree with it, otherwise the uncertainty from the repeats.
///
/// # Errors
/// Fails if a point has no reading, and if points coincide or are on a line.
pub fn three_points(
    points: [&[Vector]; 3],
    role: ThreePointRole,
    stated_mm: Option<f64>,
) -> Result<ThreePoints, CellFault> {
    if points.iter().any(|p| p.is_empty()) {
        return Err(CellFault::TooFew { needed: 3, readings: points.iter().filter(|p| !p.is_empty()).count() });
    }
    let [first, second, third] = points.map(mean);
    let length = norm(minus(second, first));
    let x = unit(minus(second, first)).ok_or(CellFault::Coincident)?;
    let across = cross(x, minus(third, first));
    if norm(across) <= LEAST_HEIGHT * norm(minus(third, first)) {
        return Err(CellFault::Collinear { direction: x });
    }
    let z = unit(across).ok_or(CellFault::Coincident)?;
    let y = cross(z, x);
    let rotation = [0, 1, 2].map(|i| [x[i], y[i], z[i]]);
    let (along, height) = (dot(x, minus(third, first)), dot(y, minus(third, first)));
    let foot = [0, 1, 2].map(|i| first[i] + along * x[i]);
    let origin = if role == ThreePointRole::XXY { foot } else { first };
    let repeats = repeats(points);
    let agrees = |u: f64| {
        repeats.is_none_or(|(s, freedom)| !crate::chi_square_exceeds((s / u).powi(2) * freedom as f64, freedom))
    };
    let standard_uncertainty_mm = stated_mm.filter(|u| agrees(*u)).or(repeats.map(|r| r.0)).or(stated_mm);
    let u = standard_uncertainty_mm.unwrap_or(ASSUMED_MM);
    let jacobian = derivatives(length, along, height, role);
    let variances =
        SMatrix::<f64, 9, 9>::from_diagonal(&nalgebra::SVector::from_fn(|k, _| u * u / points[k / 3].len() as f64));
    // from the axes of the frame to the axes of the points
    let turn = Matrix3::from_fn(|i, j| rotation[i][j]);
    let mut both = SMatrix::<f64, 6, 6>::zeros();
    both.fixed_view_mut::<3, 3>(0, 0).copy_from(&turn);
    both.fixed_view_mut::<3, 3>(3, 3).copy_from(&turn);
    let all = both * jacobian * variances * jacobian.transpose() * both.transpose();
    let covariance = std::array::from_fn(|i| std::array::from_fn(|j| all[(i, j)]));
    let pose = Pose { rotation, translation_mm: origin };
    Ok(ThreePoints { frame: CellFrame { pose, covariance }, repeats, standard_uncertainty_mm })
}

/// Derivatives of shift and rotation of the frame by the coordinates of the three points, all along
/// the axes of the frame.
fn derivatives(length: f64, along: f64, height: f64, role: ThreePointRole) -> SMatrix<f64, 6, 9> {
    let mut d = SMatrix::<f64, 6, 9>::zeros();
    // turns about z and y bring the x axis through the second point, a turn about x the third one
    // into the plane
    (d[(5, 4)], d[(5, 1)]) = (1.0 / length, -1.0 / length);
    (d[(4, 5)], d[(4, 2)]) = (-1.0 / length, 1.0 / length);
    d[(3, 8)] = 1.0 / height;
    d[(3, 2)] = (along / length - 1.0) / height;
    d[(3, 5)] = -along / length / height;
    match role {
        ThreePointRole::OriginXPlane => (0..3).for_each(|i| d[(i, i)] = 1.0),
        ThreePointRole::XXY => {
            d[(0, 6)] = 1.0;
            (d[(0, 4)], d[(0, 1)]) = (height / length, -height / length);
            (d[(1, 1)], d[(1, 4)]) = (1.0 - along / length, along / length);
            (d[(2, 2)], d[(2, 5)]) = (1.0 - along / length, along / length);
        }
    }
    d
}
