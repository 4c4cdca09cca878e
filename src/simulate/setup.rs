//! Positions of balls, shaft and carriages of a table on rails, for campaigns with a known truth.

use etalon_base::bounds::{MOST, at_most};
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, unit};
use etalon_identify::geometric::{LeadMeasurements, Measurements, OffsetMeasurements, ShaftMeasurements, Turned};
use etalon_robots::{PlanarPose, RailTable};
use schemars::JsonSchema;
use serde::Deserialize;

/// Balls and probed points, and the displacements at which they are measured. Positions are in the
/// world, lengths in mm.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Setup {
    /// Ball N.
    pub arc: Arc,
    /// Ball I, rotated with the platform.
    pub turn: Turn,
    /// Shaft.
    pub shaft: ShaftSetup,
    /// Repeats of d1 and d3.
    pub offsets: OffsetSetup,
    /// Balls on the carriages.
    #[serde(default)]
    pub lead: Vec<LeadSetup>,
    /// Scale bars.
    #[serde(default)]
    pub scale_bar: Vec<BarSetup>,
    /// Single balls.
    #[serde(default)]
    pub ball: Vec<BallSetup>,
}

/// Ball N on the shaft, rotated by actuator 3 alone.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Arc {
    /// Position of the ball: along the shaft from revolute joint 2, to its left, and above the
    /// plane.
    pub ball_mm: Vector,
    /// Last displacement of actuator 3; the first is zero.
    pub rho3_end_mm: f64,
    /// Number of positions, in equal increments.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub count: usize,
}

/// Rotation of the platform about C, commanded through the nominal inverse kinematics.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Turn {
    /// Position of ball I relative to C in the world, and above the plane.
    pub ball_mm: Vector,
    /// Height of balls K and L above the plane.
    pub target_height_mm: f64,
    /// Commanded position of C in the base frame.
    pub at_mm: [f64; 2],
    /// Largest orientation; orientations range from minus to plus this value.
    pub theta_deg: f64,
    /// Number of orientations.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub count: usize,
}

/// Shaft, probed on rings all around.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaftSetup {
    /// Radius of the shaft.
    pub radius_mm: f64,
    /// Height of the shaft's axis above the plane.
    pub height_mm: f64,
    /// Positions of the first and the last ring along the shaft from revolute joint 2.
    pub rings_mm: [f64; 2],
    /// Number of rings.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub rings: usize,
    /// Number of points per ring.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub points: usize,
    /// Two displacements of actuator 2.
    pub rho2_mm: [f64; 2],
    /// Displacement of actuator 3.
    pub rho3_mm: f64,
    /// Number of determinations of s.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub repeats: usize,
}

/// Motions from home: actuators 2 and 3 to mid-travel, actuator 1 to its end.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OffsetSetup {
    /// Commanded displacement of actuators 2 and 3.
    pub rho23_mm: f64,
    /// Displacement of actuator 1 at its end.
    pub rho1_end_mm: f64,
    /// Number of repeats, each after homing.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub repeats: usize,
    /// Standard deviation of the homing of each actuator (µm).
    #[serde(default)]
    pub homing_um: f64,
}

/// A ball on the carriage of an actuator.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeadSetup {
    /// Number of the actuator, 1 to 3.
    pub actuator: usize,
    /// Position of the ball in the world with the actuator at home.
    pub ball_mm: Vector,
    /// Commanded displacements.
    pub positions_mm: Vec<f64>,
    /// Number of passes through the positions.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub passes: usize,
}

/// A scale bar in one position.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BarSetup {
    /// Position of one ball in the world.
    pub from_mm: Vector,
    /// Direction of the bar, not normalised.
    pub direction: Vector,
    /// Distance of the balls.
    pub length_mm: f64,
    /// Number of measurements of both balls.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub repeats: usize,
}

/// A stationary ball.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallSetup {
    /// Position in the world.
    pub at_mm: Vector,
    /// Number of measurements.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub repeats: usize,
}

impl Setup {
    /// Simulates the measurements on a robot with these parameters; `measure` returns the reading
    /// of a point in the world. Rails and ball R do not belong to the robot and are left empty.
    pub fn measure(
        &self,
        robot: &dyn RailTable,
        parameters: &[f64],
        homing: &mut Noise,
        mut measure: impl FnMut(Vector) -> Vector,
    ) -> Measurements {
        let mut found = Measurements::default();
        for lead in &self.lead {
            let run = found.leads.get_mut(lead.actuator.wrapping_sub(1));
            let Some(run) = run else { continue };
            let travel = robot.travel(parameters, lead.actuator);
            let mut measured = LeadMeasurements::default();
            for rho in (0..lead.passes).flat_map(|_| &lead.positions_mm) {
                let [x, y, z] = lead.ball_mm;
                measured.points.push(measure([x + rho * travel[0], y + rho * travel[1], z]));
                measured.commanded_mm.push(*rho);
            }
            *run = Some(measured);
        }
        let on_shaft = |rho: [f64; 3], along: f64, across: f64, height: f64| {
            let [from, to] = robot.pivots(parameters, &rho);
            let (sin, cos) = (to[1] - from[1]).atan2(to[0] - from[0]).sin_cos();
            [from[0] + along * cos - across * sin, from[1] + along * sin + across * cos, height]
        };
        let arc = self.arc;
        for i in 0..arc.count {
            let rho3 = arc.rho3_end_mm * i as f64 / arc.count.saturating_sub(1).max(1) as f64;
            let [along, across, height] = arc.ball_mm;
            found.base.arc.push(measure(on_shaft([0.0, 0.0, rho3], along, across, height)));
        }
        let balls = |rho: [f64; 3]| {
            [0, 1].map(|target| {
                let [x, y, _] = robot.position(parameters, &rho, target);
                [x, y, self.turn.target_height_mm]
            })
        };
        let turn = self.turn;
        for i in 0..turn.count {
            let part = 2.0 * i as f64 / turn.count.saturating_sub(1).max(1) as f64 - 1.0;
            let theta_rad = part * turn.theta_deg.to_radians();
            let command = PlanarPose { x_mm: turn.at_mm[0], y_mm: turn.at_mm[1], theta_rad };
            let rho = robot.joints_at(&robot.nominal(), command);
            let &[rho1, rho2, rho3] = &rho[..] else { continue };
            let rho = [rho1, rho2, rho3];
            let [k, l] = balls(rho);
            let c = robot.centre(parameters, &rho);
            let i = [c[0] + turn.ball_mm[0], c[1] + turn.ball_mm[1], turn.ball_mm[2]];
            found.turned.push(Turned { k: measure(k), l: measure(l), i: measure(i) });
        }
        for _ in 0..self.shaft.repeats {
            let positions = self.shaft.rho2_mm.map(|rho2| {
                let at = |along, across, height| on_shaft([0.0, rho2, self.shaft.rho3_mm], along, across, height);
                self.shaft.points_around(at).into_iter().map(&mut measure).collect()
            });
            found.shafts.push(ShaftMeasurements { positions });
        }
        let OffsetSetup { rho23_mm, rho1_end_mm, repeats, homing_um } = self.offsets;
        for _ in 0..repeats {
            let homed = [(); 3].map(|()| homing.gaussian(homing_um / 1000.0));
            let at = |rho1: f64| balls([rho1 + homed[0], rho23_mm + homed[1], rho23_mm + homed[2]]);
            let [k, l] = at(0.0).map(&mut measure);
            let [k_end, _] = at(rho1_end_mm);
            found.offsets.push(OffsetMeasurements {
                rho2_mm: rho23_mm,
                rho3_mm: rho23_mm,
                k,
                l,
                k_end: measure(k_end),
            });
        }
        found
    }

    /// Readings of the balls of every scale bar.
    pub fn bars(&self, mut measure: impl FnMut(Vector) -> Vector) -> Vec<Vec<[Vector; 2]>> {
        let bar = |bar: &BarSetup| {
            let along = unit(bar.direction).unwrap_or_default();
            let [a, d] = [bar.from_mm, along.map(|v| v * bar.length_mm)];
            let b = [a[0] + d[0], a[1] + d[1], a[2] + d[2]];
            (0..bar.repeats).map(|_| [measure(a), measure(b)]).collect()
        };
        self.scale_bar.iter().map(bar).collect()
    }

    /// Readings of every single ball.
    pub fn balls(&self, mut measure: impl FnMut(Vector) -> Vector) -> Vec<Vec<Vector>> {
        self.ball.iter().map(|ball| (0..ball.repeats).map(|_| measure(ball.at_mm)).collect()).collect()
    }
}

impl ShaftSetup {
    /// Points all around the shaft; `at` returns a position from its coordinates along the shaft,
    /// to the left, and in height.
    fn points_around(&self, at: impl Fn(f64, f64, f64) -> Vector) -> Vec<Vector> {
        let [first, last] = self.rings_mm;
        let mut points = Vec::new();
        for ring in 0..self.rings {
            let along = first + (last - first) * ring as f64 / self.rings.saturating_sub(1).max(1) as f64;
            for i in 0..self.points {
                let (sin, cos) = (std::f64::consts::TAU * i as f64 / self.points as f64).sin_cos();
                points.push(at(along, self.radius_mm * cos, self.height_mm + self.radius_mm * sin));
            }
        }
        points
    }
}
