//! Kinds of rows in a table of observations: the properties common to all kinds.

use super::{Cells, Row};
use crate::stages::orientations::AngleOrder;
use etalon_base::error;
use etalon_base::message::{Message, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::Vector;
use etalon_formats::table::XYZ;
use etalon_identify::{Fixture, Kind, Known};
use etalon_robots::Robot;

/// Facts that are common to all rows of a kind.
#[derive(Default)]
pub struct Facts {
    /// Name in the column `kind`.
    pub name: &'static str,
    /// Columns of numbers in addition to positions and uncertainties.
    pub numbers: Vec<&'static str>,
    /// Columns of numbers given by a truth; the others are simulated.
    pub stated: &'static [&'static str],
    /// `true` if a row contains the position of its target.
    pub has_position: bool,
    /// A row is the position of its target: single coordinates are possible.
    pub is_position: bool,
    /// A row may be measured by a further station of the instrument.
    pub has_stations: bool,
    /// A row may be without a target.
    pub is_of_robot: bool,
    /// A row without a pose is about targets, not about fixed points.
    pub is_of_targets: bool,
}

/// A kind of rows: its columns, the conditions in a row, and the simulation of a row.
pub trait RowKind: Sync {
    /// Facts that are common to all rows of the kind.
    fn facts(&self) -> Facts;

    /// Conditions of a row with a pose, in addition to a position in the world, each with a
    /// standard uncertainty (mm or rad); NaN for the uncertainty of the row.
    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>>;

    /// Statement of a row without a pose about fixed points and surfaces, with its standard
    /// uncertainty (mm).
    fn known(&self, _row: &Row, _u_mm: f64, _robot: &mut dyn Robot) -> Result<Known> {
        Err(error!("row-without-pose", kind = self.facts().name).into())
    }

    /// Simulation of a row with a pose; its fixed points and surfaces become parameters of `robot`.
    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated>;

    /// Simulation of a row without a pose; `near_mm` is near the point on a surface.
    fn known_simulated(&self, _: &Cells, _near_mm: Option<Vector>, _: &mut dyn Robot) -> Result<Simulated> {
        Err(no_known(self.facts().name).into())
    }
}

/// The error about a `[[known]]` of a kind that does not support it.
pub fn no_known(kind: &str) -> Message {
    error!("known-unsupported", kind)
}

/// Numbers of a row by column, in mm or deg.
pub type Numbers = Vec<(&'static str, f64)>;
type Measure = dyn Fn(&mut Measurement) -> Result<Numbers>;

/// Simulation of a row.
pub struct Simulated {
    /// The condition for the joint values, if the target touches something.
    pub touches: Option<Kind>,
    /// The numbers of the row at a state of the robot.
    pub numbers: Box<Measure>,
}

impl Simulated {
    /// A row that is measured at any position of the target.
    pub(super) fn anywhere(numbers: impl Fn(&mut Measurement) -> Result<Numbers> + 'static) -> Self {
        Self { touches: None, numbers: Box::new(numbers) }
    }

    /// A row about the fixed point that is its target, measured like a target.
    pub(super) fn fixed(
        kind: &dyn RowKind,
        cells: &Cells,
        near_mm: Option<Vector>,
        robot: &mut dyn Robot,
    ) -> Result<Self> {
        if near_mm.is_some() {
            return Err(error!("near-without-surface").into());
        }
        let point = Fixture::Point(&cells.target).add_to(robot);
        let numbers = kind.simulated(cells, robot)?.numbers;
        Ok(Self::anywhere(move |at| {
            at.position = at.point(point);
            numbers(at)
        }))
    }
}

/// The true robot at a measurement, and the noise of the measurement.
pub struct Measurement<'a> {
    /// The robot.
    pub robot: &'a dyn Robot,
    /// True parameters, in mm, rad and 1.
    pub values: &'a [f64],
    /// Joint values, in mm and rad.
    pub joints: &'a [f64],
    /// Index of the target.
    pub target: usize,
    /// Position of the target, mm.
    pub position: Vector,
    /// Stream of the noise.
    pub noise: &'a mut Noise,
    /// Standard deviation of a length, mm.
    pub sigma_mm: f64,
    /// Standard deviation of an angle (rad); the error if none is given.
    pub sigma_rad: std::result::Result<f64, Message>,
    /// The order of the three angles of an orientation, if it is written as angles.
    pub order: Option<AngleOrder>,
    /// `true` if an orientation without an order of angles is written as a rotation vector instead
    /// of a quaternion.
    pub is_vector: bool,
}

impl Measurement<'_> {
    /// The first three parameters of a fixed point or surface.
    pub(super) fn point(&self, first: usize) -> Vector {
        [0, 1, 2].map(|i| self.values[first + i])
    }

    /// A length with noise.
    pub(super) fn length(&mut self, length_mm: f64) -> f64 {
        length_mm + self.noise.gaussian(self.sigma_mm)
    }

    /// A point with noise of each coordinate.
    pub(super) fn place(&mut self, place_mm: Vector) -> Vector {
        place_mm.map(|v| self.length(v))
    }
}

/// The cells of a position.
pub(super) fn xyz(place_mm: Vector) -> Numbers {
    XYZ.into_iter().zip(place_mm).collect()
}

/// Error about a kind of rows (`joints` or `poses`) that needs a spatial arm.
pub(super) fn spatial_arm_message(kind: &str, robot: &dyn Robot) -> Message {
    error!("kind-of-arms", kind, model = robot.model())
}
