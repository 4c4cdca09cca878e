//! Geometric method with balls, a shaft and an arm (thesis, chapter 2).
//!
//! Nothing is optimised over the robot's model. Each step finds one quantity from points that were
//! measured for it, in the order of the thesis; every result carries its derivatives by all
//! measured coordinates, so that what shares points or frames is correlated. On a robot with all
//! thirteen errors of chapter 3, O, C and the axis of revolute joint 3 are still found where they
//! are, but γ, β and ε_θ are taken as zero, which shifts s, d and d3 ([`angle_shifts`]).

mod frames;
mod lengths;
mod uncertain;
mod workspace;

pub use frames::{Axes, Base, BaseMeasurements, FittedArc, FittedPlane, Mobile, Turned};
pub use lengths::{
    Lead, LeadMeasurements, OffsetMeasurements, ScaleBar, Shaft, ShaftMeasurements, intersection, scale_bar,
};
pub use uncertain::{Flat, Readings, Repeated, Repeats, Scatter, Uncertain, UncertainPoint, mean_and_sd};
pub use workspace::{Polygon, Workspace, area_mm2};

use etalon_base::message::{Problems, Result};
use etalon_base::{error, phrase};
use etalon_robots::RailTable;

/// All measurements for the geometric calibration.
#[derive(Clone, Debug, Default)]
pub struct Measurements {
    /// For the lead of actuators 1, 2 and 3; a lead that is not measured is assumed correct.
    pub leads: [Option<LeadMeasurements>; 3],
    /// For the base frame.
    pub base: BaseMeasurements,
    /// For the mobile frame.
    pub turned: Vec<Turned>,
    /// For s, each repeat.
    pub shafts: Vec<ShaftMeasurements>,
    /// For d1 and d3, each homing.
    pub offsets: Vec<OffsetMeasurements>,
}

/// The robot as determined by geometry alone.
#[derive(Clone, Debug)]
pub struct Geometry {
    /// Actuators 1, 2 and 3.
    pub leads: [Option<Lead>; 3],
    /// The base frame.
    pub base: Base,
    /// The mobile frame.
    pub mobile: Mobile,
    /// Every cylinder fitted to the shaft.
    pub shafts: Vec<[Shaft; 2]>,
    /// Distance of revolute joint 3 from the y axis.
    pub s: Repeated,
    /// Offset of actuator 1.
    pub d1: Repeated,
    /// Offset of actuator 3.
    pub d3: Repeated,
    /// Every coordinate with the standard uncertainty that was used.
    pub readings: Readings,
}

/// Results of the measured steps, each as far as it can be evaluated.
#[derive(Clone, Debug)]
pub struct Steps {
    /// Actuators 1, 2 and 3.
    pub leads: [Option<Lead>; 3],
    /// The plane of the rails, if an arc or a turn was measured.
    pub plane: Option<FittedPlane>,
    /// The base frame, if the arc of ball N was measured.
    pub base: Option<Base>,
    /// The mobile frame, if balls were measured while the platform rotated.
    pub mobile: Option<Mobile>,
    /// Every cylinder fitted to the shaft.
    pub shafts: Vec<[Shaft; 2]>,
    /// Distance of revolute joint 3 from the y axis, if the shaft was measured.
    pub s: Option<Repeated>,
    /// Offsets of actuators 1 and 3, if they were measured.
    pub offsets: Option<[Repeated; 2]>,
    /// Every coordinate with the standard uncertainty that was used.
    pub readings: Readings,
}

/// Names of the quantities that depend on angles taken as zero, in the order of [`angle_shifts`].
pub const BY_ANGLES: [&str; 3] = ["s", "d", "d3"];

/// Shifts (mm) of [`BY_ANGLES`] by each angle β, γ and ε_θ of this size (rad), which geometry takes
/// as zero; `mid_travel_mm` is the travel of actuators 2 and 3 at these measurements.
///
/// The axis of revolute joint 3 and C are found where they are (eq. 3.8 and 3.11 at ρ1 = 0), and d3
/// follows from the slope of the guide (eq. 2.11).
pub fn angle_shifts(
    robot: &dyn RailTable,
    parameters: &[f64],
    mid_travel_mm: f64,
    angles_rad: [f64; 3],
) -> [[f64; 3]; 3] {
    let found = |p: &[f64]| {
        let joints = [0.0, mid_travel_mm, mid_travel_mm];
        let (pose, [_, pivot]) = (robot.pose(p, &joints), robot.pivots(p, &joints));
        let [s, _] = robot.in_base(p, pivot);
        [s, pose.x_mm, s * pose.theta_rad.tan() - mid_travel_mm * (p[DELTA3] - p[DELTA2])]
    };
    let straight = found(&parameters.iter().enumerate().map(|(i, p)| if i < 3 { 0.0 } else { *p }).collect::<Vec<_>>());
    [0, 1, 2].map(|angle| {
        let leaning: Vec<f64> = parameters
            .iter()
            .enumerate()
            .map(|(i, p)| if i >= 3 { *p } else { angles_rad[i] * f64::from(u8::from(i == angle)) })
            .collect();
        let there = found(&leaning);
        std::array::from_fn(|k| there[k] - straight[k])
    })
}

/// Indices of the leads of actuators 2 and 3 in the parameters of a PreXYT.
const DELTA2: usize = 11;
const DELTA3: usize = 12;

/// Evaluates each measured step, with an instrument of this standard uncertainty of one coordinate
/// (mm).
///
/// The arc and the turn need the rails and ball R, the shaft the arc too, the offsets all of them:
/// an error where they are not measured.
pub fn steps(measured: &Measurements, standard_uncertainty_mm: f64) -> Result<Steps> {
    let mut readings = Readings::new(standard_uncertainty_mm);
    let [one, two, three] = &measured.leads;
    let mut lead = |run: &Option<LeadMeasurements>, name: &str| -> Result<Option<Lead>> {
        run.as_ref().map(|run| Lead::determine(&mut readings, run)).transpose().map_err(at_step(name))
    };
    let leads = [lead(one, "lead-1")?, lead(two, "lead-2")?, lead(three, "lead-3")?];
    let (has_arc, has_turn) = (!measured.base.arc.is_empty(), !measured.turned.is_empty());
    let axes = (has_arc || has_turn).then(|| Axes::determine(&mut readings, &measured.base));
    let axes = axes.transpose().map_err(at_step("base"))?;
    let plane = axes.as_ref().map(|axes| axes.plane.clone());
    let base = axes.filter(|_| has_arc).map(|axes| Base::about(&mut readings, axes, &measured.base.arc));
    let base = base.transpose().map_err(at_step("base"))?;
    let mobile = plane.as_ref().filter(|_| has_turn).map(|p| Mobile::determine(&mut readings, p, &measured.turned));
    let mobile = mobile.transpose().map_err(at_step("mobile"))?;
    let (mut shafts, mut s) = (Vec::new(), Vec::new());
    for run in &measured.shafts {
        let base = base.as_ref().ok_or_else(|| Problems::from(error!("geometric-step-alone", step = "shaft")))?;
        let mut shaft = |i: usize| Shaft::through(&mut readings, base, &run.positions[i]).map_err(at_step("shaft"));
        let pair = [shaft(0)?, shaft(1)?];
        let [x, _] = intersection(&pair[0], &pair[1]).map_err(at_step("shaft"))?;
        s.push(x);
        shafts.push(pair);
    }
    let s = (!s.is_empty()).then(|| Repeated::new(s));
    let right = Uncertain::exact(1.0);
    let ratio = |i: usize| leads[i].as_ref().map_or(&right, |lead| &lead.ratio);
    let (mut d1, mut d3) = (Vec::new(), Vec::new());
    for run in &measured.offsets {
        let (Some(base), Some(mobile), Some(s)) = (&base, &mobile, &s) else {
            return Err(error!("geometric-step-alone", step = "offsets").into());
        };
        let [k, l, k_end] = run.project(&mut readings, base);
        let [one, _] = base.express(&mobile.centre(&k, &l));
        let three = run.d3(&base.express(&k), &base.express(&k_end), &s.mean, [ratio(1), ratio(2)]);
        d1.push(one);
        d3.push(three.map_err(at_step("offsets"))?);
    }
    let offsets = (!d1.is_empty()).then(|| [Repeated::new(d1), Repeated::new(d3)]);
    Ok(Steps { leads, plane, base, mobile, shafts, s, offsets, readings })
}

/// Determines the whole geometry, with an instrument of this standard uncertainty of one coordinate
/// (mm).
pub fn determine(measured: &Measurements, standard_uncertainty_mm: f64) -> Result<Geometry> {
    let found = steps(measured, standard_uncertainty_mm)?;
    let (Some(base), Some(mobile), Some(s), Some([d1, d3])) = (found.base, found.mobile, found.s, found.offsets) else {
        return Err(error!("geometry-incomplete").into());
    };
    Ok(Geometry { leads: found.leads, base, mobile, shafts: found.shafts, s, d1, d3, readings: found.readings })
}

/// Names the step of the problems.
fn at_step(step: &str) -> impl Fn(Problems) -> Problems + '_ {
    move |problems| problems.within(&phrase!("at-geometric-step", step))
}
