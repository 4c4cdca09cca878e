//! Order of the components of a measured quaternion, by the orientations of the nominal robot.

use super::kinematics::{Reading, factor};
use super::meaning::{Evidence, Interpretation, Meaning};
use super::table::Table;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{Pose, dot};
use etalon_robots::Robot;

/// Maximum number of rows that are compared.
const MOST: usize = 40;
/// Minimum number of rows.
const FEWEST: usize = 6;
/// Largest misfit (rad, root mean square) of an order that fits: errors of a nominal robot.
const FITS_RAD: f64 = 0.1;
/// Smallest misfit (rad) of an order that does not fit.
const FITS_NOT_RAD: f64 = 0.5;

/// Returns the pose of the flange for joint values in the columns of the robot's joints.
pub(super) fn flange(robot: &dyn Robot, reading: &Reading, value: &dyn Fn(usize) -> f64) -> Option<Pose> {
    let joint = |k: usize| {
        let value = value(reading.order[k]) * factor(reading.units[k]);
        if reading.reversed[k] { -value } else { value }
    };
    let joints: Vec<f64> = (0..reading.order.len()).map(joint).collect();
    let arm = robot.free_base()?;
    joints.iter().all(|value| value.is_finite()).then(|| arm.flange(&robot.nominal(), &joints, 0))
}

/// Orders the components of a quaternion whose order is open, if the flanges of the rows fit one
/// order alone; returns the reason.
pub(super) fn order(
    flanges: &[Option<Pose>],
    base_R_world: &[[f64; 3]; 3],
    table: &Table,
    found: &mut Interpretation,
) -> Option<Phrase> {
    if !found.waits_for(Evidence::Orientations) {
        return None;
    }
    let mut columns = found.quaternion_columns();
    columns.sort_unstable();
    let columns = <[usize; 4]>::try_from(columns).ok()?;
    let four = |row: usize| columns.map(|at| table.columns[at].values.get(row).copied().unwrap_or(f64::NAN));
    let rows = flanges.iter().enumerate().filter_map(|(row, flange)| Some(((*flange)?, four(row))));
    let rows: Vec<(Pose, [f64; 4])> = rows.filter(|(_, four)| four.iter().all(|v| v.is_finite())).take(MOST).collect();
    let [first, last] = [[0, 1, 2, 3], [3, 0, 1, 2]].map(|order| misfit(&rows, order, base_R_world));
    let scalar = match (first?, last?) {
        (first, last) if first < FITS_RAD && last > FITS_NOT_RAD => "first",
        (first, last) if last < FITS_RAD && first > FITS_NOT_RAD => "last",
        _ => return None,
    };
    let meanings = if scalar == "first" { [0, 1, 2, 3] } else { [1, 2, 3, 0] };
    for (at, k) in columns.into_iter().zip(meanings) {
        found.take(at, Meaning::Quaternion(k), phrase!("why-four-of-length-one"));
    }
    found.settle(Evidence::Orientations);
    Some(phrase!("robot-orders-quaternion", scalar))
}

/// Returns the misfit (rad) of an order of the components: `order` has the place of w, x, y and z.
///
/// The body is mounted on the flange: its orientation in the frame of the flange is the same in all
/// rows. The frame of the instrument is known from the coordinates.
fn misfit(rows: &[(Pose, [f64; 4])], order: [usize; 4], base_R_world: &[[f64; 3]; 3]) -> Option<f64> {
    let base_T_world = Pose { rotation: *base_R_world, ..Pose::identity() };
    let mounted = |(flange, four): &(Pose, [f64; 4])| {
        let body = base_T_world.then(&Pose::from_quaternion(order.map(|at| four[at])));
        flange.inverse().then(&body)
    };
    let mounted: Vec<Pose> = rows.iter().map(mounted).collect();
    let first = mounted.first().filter(|_| rows.len() >= FEWEST)?;
    let squares = mounted.iter().map(|pose| {
        let turn = first.inverse().then(pose).rotation_vector_rad();
        dot(turn, turn)
    });
    Some((squares.sum::<f64>() / rows.len() as f64).sqrt())
}
