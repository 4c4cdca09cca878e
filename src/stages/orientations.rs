//! Measured orientations of a table: quaternions, rotation vectors, or three angles in a given
//! order.

pub use etalon_base::angle_order::AngleOrder;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, Vector, norm};
use etalon_base::{error, phrase};
use etalon_formats::table::{ANGLE_ORDER, MATRIX, QUATERNION, Table, Values};
use etalon_identify::{Condition, Kind, Observation, Orientation, Settings, fit_frames, mounted_misfit_rad};
use etalon_robots::Robot;

/// Columns of a rotation vector.
pub const ROTATION_VECTOR: [&str; 3] = ["rx_deg", "ry_deg", "rz_deg"];
/// Columns of three angles.
const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];
/// Columns of rotation vectors and of angles, their unit (rad), and `true` for angles.
const TRIPLES: [([&str; 3], f64, bool); 4] = [
    (ROTATION_VECTOR, DEG, false),
    (["rx_rad", "ry_rad", "rz_rad"], 1.0, false),
    (ANGLES, DEG, true),
    (["a_rad", "b_rad", "c_rad"], 1.0, true),
];
const DEG: f64 = std::f64::consts::PI / 180.0;
/// Maximum deviation of the length of a measured quaternion from one: quaternions in files have a
/// few decimals.
const LENGTH_ONE: f64 = 1e-3;
/// Maximum number of orders in a message.
const NAMED: usize = 4;
/// Orders whose misfit is at most this multiple of the smallest are named beside it.
const AS_GOOD: f64 = 3.0;
/// Maximum misfit (deg) of an order of angles that fits the robot.
const MISFIT_DEG: f64 = 10.0;

/// An orientation in the form of the row of a table.
#[derive(Clone, Copy)]
pub struct Written {
    pub(super) form: Form,
    /// Numbers of the form (rad); unused ones are 0.
    pub(super) numbers: [f64; 9],
    /// Order of angles that the row contains.
    pub(super) order: Option<AngleOrder>,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Form {
    None,
    Quaternion,
    Matrix,
    Vector,
    Angles,
}

/// Columns of orientations, in every form.
pub fn columns() -> impl Iterator<Item = &'static str> {
    QUATERNION.into_iter().chain(MATRIX).chain(TRIPLES.iter().flat_map(|t| t.0))
}

/// `true` if a table has a column of an orientation.
pub fn are_in(table: &Table) -> bool {
    columns().any(|name| table.has(name))
}

/// Adds the order of the angles to the rows of a table that have no order, if the table has such
/// angles.
pub fn state_order(table: &mut Table, order: &str) {
    let mut angles = TRIPLES.iter().filter(|(_, _, are_angles)| *are_angles).flat_map(|(names, ..)| names);
    if angles.any(|name| table.has(name)) {
        let own = |row| Some(table.text(row, ANGLE_ORDER).unwrap_or(order).to_owned());
        let orders = (0..table.height()).map(own).collect();
        table.set(ANGLE_ORDER, Values::Texts(orders));
    }
}

/// An orientation by column: angles in an order, a rotation vector, or a quaternion.
pub fn numbers(body: &Pose, order: Option<AngleOrder>, is_vector: bool) -> Vec<(&'static str, f64)> {
    let degrees = |names: [&'static str; 3], rad: [f64; 3]| names.into_iter().zip(rad.map(f64::to_degrees)).collect();
    match order {
        Some(order) => degrees(ANGLES, order.angles(body)),
        None if is_vector => degrees(ROTATION_VECTOR, body.rotation_vector_rad()),
        None => QUATERNION.into_iter().zip(body.quaternion()).collect(),
    }
}

/// The orientations of a table, row by row.
///
/// # Errors
/// Reports missing columns, and columns of two forms.
pub fn written(table: &Table) -> Result<Vec<Written>> {
    let has = |name: &&str| table.has(name);
    let forms = [(&QUATERNION[..], 1.0, Form::Quaternion), (&MATRIX[..], 1.0, Form::Matrix)].into_iter().chain(
        TRIPLES
            .iter()
            .map(|(names, unit, angles)| (&names[..], *unit, if *angles { Form::Angles } else { Form::Vector })),
    );
    let mut given = forms.filter(|(names, ..)| names.iter().any(&has));
    let Some((names, unit, form)) = given.next() else {
        return Ok(vec![Written { form: Form::None, numbers: [f64::NAN; 9], order: None }; table.height()]);
    };
    if let Some((others, ..)) = given.next() {
        return Err(error!("orientations-twice", first = *names, second = *others).at(table.header()).into());
    }
    let missing: Vec<&str> = names.iter().copied().filter(|name| !has(name)).collect();
    if !missing.is_empty() {
        return Err(error!("orientation-columns-missing", missing, columns = *names).at(table.header()).into());
    }
    let mut rows = vec![Written { form, numbers: [0.0; 9], order: None }; table.height()];
    for (k, name) in names.iter().enumerate() {
        rows.iter_mut().zip(table.numbers(name)?).for_each(|(row, v)| row.numbers[k] = v * unit);
    }
    if form == Form::Angles && has(&ANGLE_ORDER) {
        for (i, row) in rows.iter_mut().enumerate() {
            let order = table.text(i, ANGLE_ORDER).map(str::parse::<AngleOrder>).transpose();
            row.order = order.map_err(|m: Message| m.at(table.place(i)))?;
        }
    }
    Ok(rows)
}

impl Written {
    /// `true` if the row contains any of its numbers.
    pub fn is_stated(&self) -> bool {
        let count = match self.form {
            Form::Quaternion => 4,
            Form::Matrix => 9,
            _ => 3,
        };
        self.form != Form::None && self.numbers[..count].iter().any(|v| !v.is_nan())
    }

    /// The angles (rad), if they need their order.
    pub fn angles(&self) -> Option<[f64; 3]> {
        let [a, b, c, ..] = self.numbers;
        (self.form == Form::Angles).then_some([a, b, c])
    }

    /// The orientation of a quaternion as exports of three numbers contain it: angles in the order
    /// of the row, or a rotation vector.
    fn as_in_export(&self) -> Self {
        let Ok(body) = self.pose(None) else { return *self };
        let (form, [a, b, c]) = match self.order {
            Some(order) => (Form::Angles, order.angles(&body)),
            None => (Form::Vector, body.rotation_vector_rad()),
        };
        Self { form, numbers: [a, b, c, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], ..*self }
    }

    /// Orientation of the body in the world; angles in this order, or in the order of their row.
    /// Without both the order is arbitrary.
    ///
    /// # Errors
    /// Fails if a number is missing, or if a quaternion has a length other than one.
    pub fn pose(&self, order: Option<AngleOrder>) -> Result<Pose> {
        let [a, b, c, d, ..] = self.numbers;
        if !self.numbers.iter().sum::<f64>().is_finite() {
            return Err(error!("orientation-missing").into());
        }
        let any = AngleOrder::default();
        let length = (a * a + b * b + c * c + d * d).sqrt();
        match self.form {
            Form::Vector => Ok(Pose::from_rotation_vector([a, b, c])),
            Form::Matrix => Ok(Pose::from_rotation(self.numbers)?),
            Form::Angles => Ok(order.or(self.order).unwrap_or(any).pose([a, b, c])),
            _ if (length - 1.0).abs() > LENGTH_ONE => Err(error!("table-quaternion-length", length).into()),
            _ => Ok(Pose::from_quaternion([a, b, c, d])),
        }
    }
}

/// Other ways of reading the orientations of a table, each with its description; `order` is the
/// order of angles of rows without their own.
pub(super) fn readings(written: &[Written], order: Option<AngleOrder>) -> Vec<(Phrase, Vec<Option<Pose>>)> {
    let Some(form) = written.first().map(|row| row.form) else { return Vec::new() };
    let mut all = number_slips(written, order);
    if form == Form::Quaternion {
        let of_export: Vec<Written> = written.iter().map(Written::as_in_export).collect();
        all.extend(number_slips(&of_export, order));
    }
    all.push((phrase!("orientation-slip", slip = "inverse", name = ""), turned(written, order, |v| v.map(|v| -v))));
    all
}

/// Orientations of a table in a left-handed frame, with one axis reversed.
pub(super) fn mirrored(written: &[Written]) -> Vec<(Phrase, Vec<Option<Pose>>)> {
    let axes = ["x", "y", "z"].into_iter().enumerate();
    let reversed = |(axis, name): (usize, &str)| {
        // a mirror turns the axis of a rotation over, and keeps its part along the normal
        let bodies = turned(written, None, |v| [0, 1, 2].map(|i| if i == axis { v[i] } else { -v[i] }));
        (phrase!("orientation-slip", slip = "left-handed", name), bodies)
    };
    axes.map(reversed).collect()
}

/// Orientations with other rotation vectors (rad).
fn turned(written: &[Written], order: Option<AngleOrder>, how: impl Fn(Vector) -> Vector) -> Vec<Option<Pose>> {
    let turn = |row: &Written| Some(Pose::from_rotation_vector(how(row.pose(order).ok()?.rotation_vector_rad())));
    written.iter().map(turn).collect()
}

/// Other meanings of the numbers of orientations: another order, unit or sign.
fn number_slips(written: &[Written], order: Option<AngleOrder>) -> Vec<(Phrase, Vec<Option<Pose>>)> {
    let mut all = Vec::new();
    let Some(form) = written.first().map(|row| row.form) else { return all };
    let mut add = |slip: &str, name: &str, bodies| all.push((phrase!("orientation-slip", slip, name), bodies));
    let numbers = |how: &dyn Fn([f64; 9]) -> Option<Pose>| written.iter().map(|row| how(row.numbers)).collect();
    let three = |n: [f64; 9]| [n[0], n[1], n[2]];
    match form {
        // three numbers of an export became quaternions
        Form::Quaternion if written.iter().any(|row| row.order.is_some()) => {}
        Form::Quaternion => {
            let by = |at: [usize; 4]| numbers(&|n| quaternion(at.map(|k| n[k])));
            add("scalar-last", "", by([3, 0, 1, 2]));
            add("scalar-first", "", by([1, 2, 3, 0]));
            let inverse = |at: [usize; 4]| numbers(&|n| Some(quaternion(at.map(|k| n[k]))?.inverse()));
            add("scalar-last-inverse", "", inverse([3, 0, 1, 2]));
        }
        Form::Angles => {
            let is_other = |other: &AngleOrder| written.iter().any(|row| order.or(row.order) != Some(*other));
            for other in AngleOrder::all().into_iter().filter(is_other) {
                add("order", &other.to_string(), numbers(&|n| Some(other.pose(three(n)))));
            }
            add("vectors", "", numbers(&|n| Some(Pose::from_rotation_vector(three(n)))));
            let negated = |row: &Written| Written { numbers: row.numbers.map(|v| -v), ..*row }.pose(order).ok();
            add("negated", "", written.iter().map(negated).collect());
        }
        Form::Vector => {
            for order in AngleOrder::all() {
                add("order-of-vectors", &order.to_string(), numbers(&|n| Some(order.pose(three(n)))));
            }
        }
        Form::None | Form::Matrix => {}
    }
    if matches!(form, Form::Angles | Form::Vector) {
        for (factor, unit) in [(1.0 / DEG, "radians"), (DEG, "degrees")] {
            let scaled = |row: &Written| Written { numbers: row.numbers.map(|v| factor * v), ..*row }.pose(order).ok();
            add(unit, "", written.iter().map(scaled).collect());
        }
    }
    all
}

/// The rotation of a quaternion, the scalar first; `None` if its length is zero.
fn quaternion(numbers: [f64; 4]) -> Option<Pose> {
    let length = norm([numbers[1], numbers[2], numbers[3]]).hypot(numbers[0]);
    (length > 0.5).then(|| Pose::from_quaternion(numbers))
}

/// The error about angles without a given order, with the orders that fit the nominal robot
/// located by positions: `angles` belong to the orientations among the conditions of `settings`, in
/// their order.
pub fn unstated(robot: &dyn Robot, observations: &[Observation], settings: &Settings, angles: &[[f64; 3]]) -> Message {
    let message = error!("angle-order-missing");
    let conditions: Vec<&Condition> = settings.conditions.iter().filter(|c| c.kind.is_world_orientation()).collect();
    let positions = Settings { conditions: Vec::new(), known: Vec::new(), ..settings.clone() };
    let Ok(values) = fit_frames(robot, observations, &positions) else { return message };
    let misfit = |order: AngleOrder| {
        let turned = conditions.iter().zip(angles).map(|(c, angles)| match c.kind {
            Kind::Orientation(observed) => Condition {
                kind: Kind::Orientation(Orientation { frame_T_body: order.pose(*angles), ..observed }),
                ..(*c).clone()
            },
            _ => (*c).clone(),
        });
        (mounted_misfit_rad(robot, &turned.collect::<Vec<_>>(), &values).to_degrees(), order)
    };
    let mut all: Vec<(f64, AngleOrder)> =
        AngleOrder::all().into_iter().map(misfit).filter(|m| m.0.is_finite()).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Some(&(least, best)) = all.first() else { return message };
    if least > MISFIT_DEG {
        return message.hint(phrase!("angle-orders-unfit", order = best.to_string(), left_deg = least));
    }
    let fits = all.iter().take_while(|m| m.0 <= AS_GOOD * least).take(NAMED);
    let order =
        |(left_deg, order): &(f64, AngleOrder)| phrase!("angle-order-leaves", order = order.to_string(), left_deg);
    let orders: Vec<_> = fits.map(order).collect();
    message.hint(phrase!("angle-orders-fit", order = best.to_string(), orders))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Angles of an export in another order than its `rotation` states, and rotation vectors that
    /// are angles: among the readings is the right one.
    #[test]
    fn another_order_of_an_export_is_a_reading() {
        let angles = [0.4, -0.7, 1.1];
        let order = |text: &str| text.parse::<AngleOrder>().expect("an order");
        let read = |stated: Option<AngleOrder>| {
            let body = stated.map_or(Pose::from_rotation_vector(angles), |stated| stated.pose(angles));
            let [w, x, y, z] = body.quaternion();
            Written { form: Form::Quaternion, numbers: [w, x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0], order: stated }
        };
        let right = order("xyz").pose(angles);
        for (stated, slip) in [(Some(order("zyx")), "order"), (None, "order-of-vectors")] {
            let what = phrase!("orientation-slip", slip, name = "xyz");
            let found = readings(&[read(stated)], None);
            let (_, bodies) = found.iter().find(|(other, _)| *other == what).expect("the order");
            let body = bodies[0].expect("an orientation");
            let apart_rad = right.inverse().then(&body).rotation_vector_rad();
            assert!(apart_rad.iter().all(|v| v.abs() < 1e-12), "{slip}: {apart_rad:?}");
        }
    }
}
