//! Form of a measured orientation, by the orientations of the nominal robot: the order of the
//! components of a quaternion, or of three angles.

use crate::dialect::ROTATION_VECTOR;
use crate::propose::kinematics::{Reading, factor};
use crate::propose::meaning::{Evidence, Interpretation, Meaning, RotationForm};
use crate::propose::table::Table;
use etalon_base::angle_order::AngleOrder;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{Pose, dot};
use etalon_robots::Robot;

/// Maximum number of rows that are compared.
const MOST: usize = 40;
/// Minimum number of rows.
const FEWEST: usize = 6;
/// Maximum misfit (rad, root mean square) of an order that fits: errors of a nominal robot.
const FITS_RAD: f64 = 0.1;
/// Minimum misfit (rad) of an order that does not fit.
const FITS_NOT_RAD: f64 = 0.5;

/// Returns the pose of the flange for joint values in the columns of the robot's joints.
pub(crate) fn flange(robot: &dyn Robot, reading: &Reading, value: &dyn Fn(usize) -> f64) -> Option<Pose> {
    let joint = |k: usize| {
        let value = value(reading.order[k]) * factor(reading.units[k]);
        if reading.reversed[k] { -value } else { value }
    };
    let joints: Vec<f64> = (0..reading.order.len()).map(joint).collect();
    let arm = robot.free_base()?;
    joints.iter().all(|value| value.is_finite()).then(|| arm.flange(&robot.nominal(), &joints, 0))
}

/// Finds the form of a measured orientation that is open, the order of the components of a
/// quaternion or of three angles, if the flanges of the rows fit one form alone; returns the
/// reason.
pub(crate) fn order(
    flanges: &[Option<Pose>],
    base_R_world: &[[f64; 3]; 3],
    table: &Table,
    found: &mut Interpretation,
) -> Option<Phrase> {
    if !found.waits_for(Evidence::Orientations) {
        return None;
    }
    let world = Measured { flanges, base_R_world, table };
    let mut quaternion = found.quaternion_columns();
    quaternion.sort_unstable();
    match (<[usize; 4]>::try_from(quaternion), <[usize; 3]>::try_from(found.rotation_columns())) {
        (Ok(columns), _) => world.order_quaternion(columns, found),
        (_, Ok(columns)) => world.order_angles(columns, found),
        _ => None,
    }
}

/// Orientations of the rows of a table, and the flanges of the same rows.
struct Measured<'a> {
    flanges: &'a [Option<Pose>],
    base_R_world: &'a [[f64; 3]; 3],
    table: &'a Table,
}

impl Measured<'_> {
    fn order_quaternion(&self, columns: [usize; 4], found: &mut Interpretation) -> Option<Phrase> {
        let rows = self.rows(columns);
        let of =
            |order: [usize; 4]| self.misfit(&rows, &|four: &[f64; 4]| Pose::from_quaternion(order.map(|at| four[at])));
        let scalar = match [of([0, 1, 2, 3])?, of([3, 0, 1, 2])?] {
            [first, last] if first < FITS_RAD && last > FITS_NOT_RAD => "first",
            [first, last] if last < FITS_RAD && first > FITS_NOT_RAD => "last",
            _ => return None,
        };
        let meanings = if scalar == "first" { [0, 1, 2, 3] } else { [1, 2, 3, 0] };
        for (at, k) in columns.into_iter().zip(meanings) {
            found.take(at, Meaning::Quaternion(k), phrase!("why-four-of-length-one"));
        }
        found.settle(Evidence::Orientations);
        Some(phrase!("robot-orders-quaternion", scalar))
    }

    /// Tries a rotation vector and all orders of angles, in each unit that the headings allow.
    fn order_angles(&self, columns: [usize; 3], found: &mut Interpretation) -> Option<Phrase> {
        let rows = self.rows(columns);
        let forms = std::iter::once(None).chain(AngleOrder::all().into_iter().map(Some));
        let units = [("deg", 1f64.to_radians()), ("rad", 1.0)];
        let units =
            units.into_iter().filter(|(unit, _)| found.orientations.rotation.unit.is_none_or(|stated| stated == *unit));
        let tried = units.flat_map(|unit| forms.clone().map(move |form| (unit, form)));
        let misfit = |((unit, factor), form): ((&'static str, f64), Option<AngleOrder>)| {
            let body = |three: &[f64; 3]| {
                let rad = three.map(|value| value * factor);
                form.map_or_else(|| Pose::from_rotation_vector(rad), |order| order.pose(rad))
            };
            Some((self.misfit(&rows, &body)?, unit, form))
        };
        let mut all: Vec<(f64, &'static str, Option<AngleOrder>)> = tried.map(misfit).collect::<Option<_>>()?;
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [(best, unit, form), (next, ..), ..] = all[..] else { return None };
        if best > FITS_RAD || next < FITS_NOT_RAD {
            return None;
        }
        let order = form.map_or_else(|| ROTATION_VECTOR.to_owned(), |order| order.to_string());
        found.orientations.rotation = RotationForm { order: Some(order.clone()), unit: Some(unit) };
        found.settle(Evidence::Orientations);
        let kind = if form.is_some() { "angles" } else { "vector" };
        Some(phrase!("robot-orders-angles", kind, order, unit, misfit_deg = best.to_degrees()))
    }

    /// Rows with a flange and all numbers of these columns.
    fn rows<const N: usize>(&self, columns: [usize; N]) -> Vec<(Pose, [f64; N])> {
        let value = |at: usize, row: usize| self.table.columns[at].values.get(row).copied().unwrap_or(f64::NAN);
        let numbered = self.flanges.iter().enumerate();
        let rows = numbered.filter_map(|(row, flange)| Some(((*flange)?, columns.map(|at| value(at, row)))));
        rows.filter(|(_, values)| values.iter().all(|v| v.is_finite())).take(MOST).collect()
    }

    /// Returns the misfit (rad, root mean square) of a form of the measured orientation.
    ///
    /// The body is mounted on the flange: its orientation in the frame of the flange is the same in
    /// all rows. The frame of the instrument is known from the coordinates.
    fn misfit<const N: usize>(&self, rows: &[(Pose, [f64; N])], body: &dyn Fn(&[f64; N]) -> Pose) -> Option<f64> {
        let base_T_world = Pose { rotation: *self.base_R_world, ..Pose::identity() };
        let mounted = |(flange, values): &(Pose, [f64; N])| flange.inverse().then(&base_T_world.then(&body(values)));
        let mounted: Vec<Pose> = rows.iter().map(mounted).collect();
        let first = mounted.first().filter(|_| rows.len() >= FEWEST)?;
        let squares = mounted.iter().map(|pose| {
            let turn = first.inverse().then(pose).rotation_vector_rad();
            dot(turn, turn)
        });
        Some((squares.sum::<f64>() / rows.len() as f64).sqrt())
    }
}
