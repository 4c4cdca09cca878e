//! Bound of the uncertainty of an answer that may be loaded.
//!
//! An answer may be loaded if the expanded uncertainty U (k = 2, GUM 6.2.1) of each component is
//! at most a bound. The user gives it, or it is a share of the measured extent L:
//!
//! share = 10 u / L, for lengths and ratios at least 2 % and for angles at least 0.5 %, at most 5
//! %, with the standard uncertainty u of a measured coordinate.
//!
//! A length is bounded by share · L, an angle by share in radians, a ratio by share. A
//! well-conditioned set-up has U near 2 u, so that ten times u rejects bad geometry only. The lower
//! ends admit bad geometry of a precise instrument (a short arc, a tool point by small turns),
//! whose answer is good enough all the same; an angle acts beyond the measured region, so its end
//! is lower. The upper end rejects results that are no larger than the noise, even for a coarse
//! instrument.

use crate::cell::upright;
use crate::{Identification, Observation, Settings};
use etalon_base::error;
use etalon_base::message::{Message, Problems};
use etalon_base::pose::{Vector, centroid, minus, norm, unit};
use etalon_robots::{Kinematics, Quantity, Robot, Role};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Coverage factor of U.
pub const COVERAGE: f64 = 2.0;
/// Standard uncertainties of a measured coordinate in the bound of a length.
const MULTIPLE: f64 = 10.0;
/// Minimum share of the measured extent for lengths and ratios.
const LEAST_OF_LENGTHS: f64 = 0.02;
/// Minimum share for angles (rad).
const LEAST_OF_ANGLES: f64 = 0.005;
/// Maximum share.
const MOST: f64 = 0.05;
/// Standard uncertainty (mm) of a coordinate that is assumed if nothing shows it: the order of
/// coordinate measuring systems. Touches by a robot are less accurate. An answer that is rejected
/// with this uncertainty is therefore also rejected with the true one.
pub const ASSUMED_MM: f64 = 0.01;
/// Standard uncertainty (rad) of an orientation that is assumed if nothing shows it.
pub const ASSUMED_RAD: f64 = 1e-4;
/// Part of the scaled eigenvector above which a component belongs to the open combination.
const INVOLVED: f64 = 0.3;

/// Measured extent, with the uncertainty of the measurement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// Diameter of the sphere about the centroid that contains all measured positions, or another
    /// measured length of the object (mm).
    pub length_mm: f64,
    /// Standard uncertainty of a measured coordinate (mm).
    pub coordinate_mm: f64,
    /// Standard uncertainty of a measured orientation (rad); 0 without orientations.
    pub orientation_rad: f64,
}

impl Extent {
    /// Extent of positions, whose coordinates have this standard uncertainty (mm).
    pub fn from_points(points: &[Vector], coordinate_mm: f64) -> Self {
        let from = centroid(points).unwrap_or_default();
        let radius_mm = points.iter().map(|p| norm(minus(*p, from))).fold(0.0, f64::max);
        Self { length_mm: 2.0 * radius_mm, coordinate_mm, orientation_rad: 0.0 }
    }

    /// Share of the extent that ten times the uncertainty of a coordinate is.
    fn noise(&self) -> f64 {
        if self.length_mm > 0.0 { MULTIPLE * self.coordinate_mm / self.length_mm } else { f64::INFINITY }
    }

    /// Share of the extent that bounds lengths and ratios.
    fn share(&self) -> f64 {
        self.noise().clamp(LEAST_OF_LENGTHS, MOST)
    }

    /// Share (rad) that bounds angles.
    fn angle(&self) -> f64 {
        self.noise().max(MULTIPLE * self.orientation_rad).clamp(LEAST_OF_ANGLES, MOST)
    }
}

/// Given bounds of the expanded uncertainty; a quantity without a bound has the default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UncertaintyBound {
    /// Bound of lengths (mm).
    pub length_mm: Option<f64>,
    /// Bound of angles (rad).
    pub angle_rad: Option<f64>,
}

impl std::str::FromStr for UncertaintyBound {
    type Err = Problems;

    /// Reads a length, an angle, or both: `0.5 mm, 0.1 deg`.
    fn from_str(text: &str) -> Result<Self, Problems> {
        let wrong = || -> Message { error!("uncertainty-bound-unreadable", text) };
        let mut bound = Self::default();
        for part in text.split(',') {
            let part = part.trim();
            let split = part.find(|c: char| c.is_ascii_alphabetic() && c != 'e' && c != 'E').ok_or_else(wrong)?;
            let (number, unit) = part.split_at(split);
            let value: f64 = number.trim().parse().map_err(|_| wrong())?;
            let (place, factor) = match unit {
                "mm" => (&mut bound.length_mm, 1.0),
                "um" => (&mut bound.length_mm, 1e-3),
                "deg" => (&mut bound.angle_rad, 1f64.to_radians()),
                "rad" => (&mut bound.angle_rad, 1.0),
                _ => return Err(wrong().into()),
            };
            if place.is_some() || !(value > 0.0 && value.is_finite()) {
                return Err(wrong().into());
            }
            *place = Some(value * factor);
        }
        Ok(bound)
    }
}

/// A component whose expanded uncertainty exceeds its bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Excess {
    /// Index of the component with the largest ratio of both.
    pub component: usize,
    /// Expanded uncertainty (k = 2; mm, rad, 1).
    pub expanded: f64,
    /// Bound (mm, rad, 1).
    pub bound: f64,
    /// `true` if the bound is given.
    pub is_stated: bool,
    /// Change of all components (mm, rad, 1) along the eigenvector of the largest uncertainty
    /// relative to the bounds: the combination that stays open. Its largest component is positive.
    pub open: Vec<f64>,
    /// Indices of the components that have an essential part in this combination.
    pub involved: Vec<usize>,
}

impl UncertaintyBound {
    /// Bound of a component (mm, rad, 1), and `true` if it is given.
    pub fn bound(&self, quantity: Quantity, extent: &Extent) -> (f64, bool) {
        let (stated, default) = match quantity {
            Quantity::Length => (self.length_mm, extent.share() * extent.length_mm),
            Quantity::Angle => (self.angle_rad, extent.angle()),
            // an error of the ratio acts over the extent
            Quantity::Ratio => {
                (self.length_mm.map(|mm| mm / extent.length_mm).filter(|share| share.is_finite()), extent.share())
            }
        };
        (stated.unwrap_or(default), stated.is_some())
    }

    /// Component that exceeds its bound most; `None` if each is within its bound. `covariance` is
    /// the covariance of components of these quantities (mm, rad, 1), row by row. An uncertainty
    /// that is not a number exceeds every bound.
    pub fn exceeded(&self, quantities: &[Quantity], covariance: &[f64], extent: &Extent) -> Option<Excess> {
        let n = quantities.len();
        let bounds: Vec<(f64, bool)> = quantities.iter().map(|q| self.bound(*q, extent)).collect();
        let expanded = |i: usize| {
            let variance = covariance[i * n + i];
            if variance.is_finite() { COVERAGE * variance.max(0.0).sqrt() } else { f64::INFINITY }
        };
        // a bound of zero belongs to coinciding points, of which nothing is known
        let ratio = |i: usize| if bounds[i].0 > 0.0 { expanded(i) / bounds[i].0 } else { f64::INFINITY };
        let component = (0..n).max_by(|a, b| ratio(*a).total_cmp(&ratio(*b)))?;
        if ratio(component) <= 1.0 {
            return None;
        }
        let (bound, is_stated) = bounds[component];
        let scale = |i: usize| bounds[i].0.max(f64::MIN_POSITIVE);
        let scaled = DMatrix::from_fn(n, n, |i, j| covariance[i * n + j] / scale(i) / scale(j));
        let alone = DVector::from_fn(n, |i, _| f64::from(u8::from(i == component)));
        let largest = if scaled.iter().all(|v| v.is_finite()) { eigenvector(scaled) } else { alone };
        let sign = if largest[largest.iamax()] < 0.0 { -1.0 } else { 1.0 };
        Some(Excess {
            component,
            expanded: expanded(component),
            bound,
            is_stated,
            open: (0..n).map(|i| sign * largest[i] * scale(i)).collect(),
            involved: (0..n).filter(|i| largest[*i].abs() > INVOLVED).collect(),
        })
    }

    /// [`Self::exceeded`] of a frame whose covariance contains its position (mm) and of a small
    /// rotation (rad).
    pub fn frame_exceeded(&self, covariance: &[[f64; 6]; 6], extent: &Extent) -> Option<Excess> {
        let [length, angle] = [Quantity::Length, Quantity::Angle];
        self.exceeded(&[length, length, length, angle, angle, angle], covariance.as_flattened(), extent)
    }
}

/// Unit eigenvector of the largest eigenvalue.
fn eigenvector(matrix: DMatrix<f64>) -> DVector<f64> {
    let eigen = SymmetricEigen::new(matrix);
    let largest = eigen.eigenvalues.imax();
    eigen.eigenvectors.column(largest).into_owned()
}

/// Motion of a frame that stays open, by its unit direction, whose largest component is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OpenMotion {
    /// Rotation about a line.
    Rotation(Vector),
    /// Translation.
    Translation(Vector),
}

impl Excess {
    /// Open motion of a frame, whose components are a position and a small rotation, or of a point.
    pub fn motion(&self) -> OpenMotion {
        let part =
            |first: usize| unit([0, 1, 2].map(|k| self.open.get(first + k).copied().unwrap_or(0.0))).map(upright);
        let turns = self.component >= 3 || self.involved.iter().any(|i| *i >= 3);
        match part(3).filter(|_| turns) {
            Some(direction) => OpenMotion::Rotation(direction),
            None => OpenMotion::Translation(part(0).unwrap_or_default()),
        }
    }
}

/// Set-up that the data leave open.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenSetUp {
    /// Indices of the judged parameters, in the order of the components.
    pub parameters: Vec<usize>,
    /// Parameter that exceeds its bound, and the combination that stays open.
    pub excess: Excess,
    /// Measured extent.
    pub extent: Extent,
}

impl Identification {
    /// Compares the uncertainties of the parameters that nothing limits but the data with their
    /// bounds: base and targets, and without tolerances the parameters of the robot; `None` if all
    /// are within their bounds, or the covariance is unknown.
    ///
    /// Parameters with a tolerance cannot leave it, so their uncertainty is bounded. The covariance
    /// of the others is conditioned on them: a base that cannot be told from a joint offset within
    /// its tolerance is a matter of convention.
    pub fn open_set_up(
        &self,
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        bound: UncertaintyBound,
    ) -> Option<OpenSetUp> {
        let all = self.uncertainty.covariance.as_ref()?;
        let n = self.free.len();
        let is_open = |k: &usize| {
            let i = self.free[*k];
            match robot.parameters()[i].role {
                Role::Base | Role::Target => true,
                Role::Fixture => false,
                Role::Robot => self.prior.uncertainty(robot, i).is_none(),
            }
        };
        if all.len() != n * n {
            return None;
        }
        let (open, limited): (Vec<usize>, Vec<usize>) = (0..n).partition(is_open);
        let covariance = conditional(all, n, &open, &limited);
        let quantities: Vec<Quantity> = open.iter().map(|&k| robot.parameters()[self.free[k]].quantity).collect();
        let extent = self.extent(robot, observations, settings);
        let excess = bound.exceeded(&quantities, &covariance, &extent)?;
        Some(OpenSetUp { parameters: open.iter().map(|&k| self.free[k]).collect(), excess, extent })
    }

    /// Extent of the targets at the measured poses, or of the moving part and the base of the robot
    /// if that is larger. Base and targets of a far set-up do not add to it.
    pub fn extent(&self, robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Extent {
        let seen = observations.iter().flat_map(|o| {
            let targets = o.targets.iter().enumerate().filter(|(_, at)| at.is_some());
            targets.map(|(target, _)| (&o.joints, target)).collect::<Vec<_>>()
        });
        let conditions = settings.conditions.iter().map(|c| (&c.joints, c.target));
        let places = seen.chain(conditions).map(|(joints, target)| robot.position(&self.values, joints, target));
        let all_joints = observations.iter().map(|o| &o.joints).chain(settings.conditions.iter().map(|c| &c.joints));
        let part = |k: &dyn Kinematics| -> Vec<Vector> {
            let moved = all_joints.filter_map(|q| Some(k.tool_pose(&self.values, q)?.translation_mm));
            moved.chain([[0.0; 3]]).collect()
        };
        let part = robot.kinematics().map(part).unwrap_or_default();
        let coordinate_mm = settings.coordinate_uncertainty_mm().max(self.residuals.rms);
        let [targets, part] = [places.collect(), part].map(|points| {
            let finite: Vec<Vector> = points.into_iter().filter(|p| p.iter().all(|v| v.is_finite())).collect();
            Extent::from_points(&finite, coordinate_mm)
        });
        if part.length_mm > targets.length_mm { part } else { targets }
    }
}

/// Covariance of the `open` components if the `limited` ones were known (Schur complement).
fn conditional(all: &[f64], n: usize, open: &[usize], limited: &[usize]) -> Vec<f64> {
    let part = |rows: &[usize], columns: &[usize]| {
        DMatrix::from_fn(rows.len(), columns.len(), |i, j| all[rows[i] * n + columns[j]])
    };
    let own = part(open, open);
    let scale: Vec<f64> = limited.iter().map(|&k| all[k * n + k].sqrt()).collect();
    let mut known = part(limited, limited);
    known.iter_mut().enumerate().for_each(|(at, v)| {
        let (i, j) = (at % limited.len(), at / limited.len());
        *v /= scale[i] * scale[j];
    });
    let mut across = part(limited, open);
    across.row_iter_mut().zip(&scale).for_each(|(mut row, s)| row /= *s);
    let solved = nalgebra::Cholesky::new(known).map(|root| across.transpose() * root.solve(&across));
    let rest = solved.map_or_else(|| own.clone(), |explained| &own - explained);
    // symmetric, so that rows and columns are alike
    (0..open.len() * open.len()).map(|at| rest[(at / open.len(), at % open.len())]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::pose::cross;

    const LENGTH: Quantity = Quantity::Length;
    const ANGLE: Quantity = Quantity::Angle;

    #[test]
    fn a_bound_is_read_with_its_units() {
        let read = |text: &str| text.parse::<UncertaintyBound>();
        let both = read("0.5 mm, 0.1 deg").expect("both");
        assert_eq!(both, UncertaintyBound { length_mm: Some(0.5), angle_rad: Some(0.1f64.to_radians()) });
        assert_eq!(read("20um").expect("one").length_mm, Some(0.02));
        assert_eq!(read("1e-3 rad").expect("one").angle_rad, Some(1e-3));
        for wrong in ["", "0.5", "mm", "-1 mm", "0 deg", "1 m", "1 mm, 2 mm", "1 mm 2 deg", "nan mm", "inf mm"] {
            let problems = read(wrong).expect_err(wrong);
            assert!(problems.0[0].is("uncertainty-bound-unreadable", &[]), "{wrong}");
        }
    }

    #[test]
    fn the_default_is_a_share_of_the_extent_between_two_limits() {
        let bound = UncertaintyBound::default();
        let at = |length_mm: f64, coordinate_mm: f64| Extent { length_mm, coordinate_mm, orientation_rad: 0.0 };
        let near = |(value, stated): (f64, bool), expected: f64| (value - expected).abs() < 1e-12 && !stated;
        // a precise instrument: 2 % and 0.5 %; 10 u between; a coarse one: 5 %
        assert!(near(bound.bound(LENGTH, &at(1000.0, 0.01)), 20.0));
        assert!(near(bound.bound(ANGLE, &at(1000.0, 0.01)), 0.005));
        assert!(near(bound.bound(LENGTH, &at(100.0, 0.3)), 3.0));
        assert!(near(bound.bound(ANGLE, &at(100.0, 0.2)), 0.02));
        assert!(near(bound.bound(LENGTH, &at(100.0, 3.0)), 5.0));
        assert!(near(bound.bound(ANGLE, &Extent { orientation_rad: 0.004, ..at(1000.0, 0.01) }), 0.04));
        let stated = UncertaintyBound { length_mm: Some(0.1), angle_rad: None };
        assert_eq!(stated.bound(LENGTH, &at(1000.0, 0.01)), (0.1, true));
        assert!(near(stated.bound(ANGLE, &at(1000.0, 0.01)), 0.005));
    }

    #[test]
    fn the_open_motion_is_the_rotation_about_the_line_of_the_points() {
        // a frame whose rotation about a line parallel to y through (50, 0, 0) has u = 0.1 rad
        let (about, through) = ([0.0, 1.0, 0.0], [50.0, 0.0, 0.0]);
        let shift = cross(through, about).map(|v| 0.1 * v);
        let motion: Vec<f64> = shift.into_iter().chain(about.map(|v| 0.1 * v)).collect();
        let noise = 1e-6;
        let covariance: [[f64; 6]; 6] =
            std::array::from_fn(|i| std::array::from_fn(|j| motion[i] * motion[j] + if i == j { noise } else { 0.0 }));
        let extent = Extent { length_mm: 200.0, coordinate_mm: 0.01, orientation_rad: 0.0 };
        let excess = UncertaintyBound::default().frame_exceeded(&covariance, &extent).expect("beyond");
        assert!((excess.expanded - 0.2).abs() < 1e-3 && excess.component == 4, "{excess:?}");
        let OpenMotion::Rotation(direction) = excess.motion() else { panic!("{excess:?}") };
        assert!(norm(minus(direction, about)) < 1e-3, "{excess:?}");
        // the same with u = 0.001 rad is within 0.5 %
        let small = covariance.map(|row| row.map(|v| 1e-4 * v));
        assert_eq!(UncertaintyBound::default().frame_exceeded(&small, &extent), None);
    }

    #[test]
    fn an_uncertainty_that_is_not_a_number_exceeds_every_bound() {
        let extent = Extent { length_mm: 100.0, coordinate_mm: 0.01, orientation_rad: 0.0 };
        let stated = UncertaintyBound { length_mm: Some(1e6), angle_rad: None };
        let excess = stated.exceeded(&[LENGTH, LENGTH], &[1.0, 0.0, 0.0, f64::NAN], &extent).expect("beyond");
        assert_eq!((excess.component, excess.expanded), (1, f64::INFINITY));
        assert!(UncertaintyBound::default().exceeded(&[ANGLE], &[1.0], &Extent::default()).is_some());
        assert!(stated.exceeded(&[], &[], &extent).is_none());
    }
}
