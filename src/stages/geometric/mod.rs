//! The geometric calibration of a campaign: from labelled points to its document.

mod labels;

pub use labels::{Gathered, gather, label, labelled};

use crate::stages::calibrate::identification::IdentifiedSolution;
use crate::stages::evaluate::sets::Sets;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::phrase;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, warning};
use etalon_campaign::{BallDefinition, Campaign, GeometricDefinition, ScaleBarDefinition, Selection};
use etalon_documents::*;
use etalon_identify::geometric::{
    self, Readings, Repeated, Scatter, Steps, Uncertain, Workspace, angle_shifts, mean_and_sd, scale_bar,
};
use etalon_identify::{Identification, Observation};
use etalon_math::statistics::rms;
use etalon_robots::{self as robots, Parameter, Platform, RailTable, Robot, Role};
use etalon_standards::iso9283::pose::repeatability::pose_repeatability;
use statrs::distribution::{ContinuousCDF, Normal};
use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;

/// Determines the robot by geometry alone, and compares it with the parameters identified from the
/// same campaign, if any; steps that are not given are omitted. `None` if the campaign has no
/// `[geometric]`.
pub fn calibrate(
    campaign: &Campaign,
    robot: &dyn Robot,
    measured: Option<Gathered>,
    identified: Option<&IdentifiedSolution>,
) -> Result<Option<GeometricDocument>> {
    let (Some(definition), Some(measured)) = (&campaign.file.geometric, measured) else { return Ok(None) };
    // the model before its reduction has no d and delta of which geometry alone gives a value
    let prexyt = robot.rail_table().filter(|_| robot.model() == "prexyt");
    let table = prexyt.ok_or_else(|| error!("geometric-other-robot"))?;
    let Gathered { robot: measured, bars, balls } = measured;
    let u_mm = campaign.file.instrument.standard_uncertainty_mm();
    let found = geometric::steps(&measured, u_mm)?;
    let quantities = quantities(&found);
    let value = |name: &str| quantities.iter().find(|q| q.0 == name).map(|q| q.1.value);
    let with = |set: &dyn Fn(&Parameter) -> Option<f64>| -> Vec<f64> {
        table.parameters().iter().map(|p| set(p).unwrap_or(p.nominal)).collect()
    };
    // all are judged in the base frame that was found first (thesis 2.7)
    let nominal = with(&|p| value(&p.name).filter(|_| p.role == Role::Base));
    // beta, gamma and epsilon_theta
    let geometric = with(&|p| if p.quantity == robots::Quantity::Angle { Some(0.0) } else { value(&p.name) });
    let by_angles = ByAngles::new(table, &geometric, definition.mid_travel_mm, identified.map(|i| &i.found));
    let tables = match identified {
        Some(i) => tables(campaign, definition, table, &i.sets, [&nominal, &geometric, &i.found.values])?,
        None => Vec::new(),
    };
    let methods = methods(&tables);
    let steps = fits(&found);
    let scale_bars = definition.scale_bar.iter().zip(&bars).filter_map(|(d, pairs)| bar_result(d, pairs, u_mm));
    let scale_bars: Vec<ScaleBarResult> = scale_bars.collect();
    let balls: Result<Vec<BallResult>> =
        definition.ball.iter().zip(&balls).map(|(d, b)| ball(campaign, d, b)).collect();
    Ok(Some(GeometricDocument {
        schema: "etalon/geometric/1".to_owned(),
        definition: phrase!("geometric-definition").into(),
        quantities: quantities
            .iter()
            .map(|q| quantity(q, &found.readings, robot, identified.map(|i| &i.found)))
            .map(|q| by_angles.added_to(q))
            .collect(),
        covariance: covariance(&quantities, &found.readings, &by_angles),
        messages: steps.iter().filter_map(scatter_message).chain(scale_bars.iter().filter_map(bar_message)).collect(),
        leads: leads(definition, &found),
        steps,
        scale_bars,
        balls: balls?,
        tables,
        methods,
        workspace: workspace(definition, table, &geometric),
    }))
}

/// Name of a parameter, its value, and its repeats, if any.
type Quantity<'a> = (&'static str, &'a Uncertain, Option<&'a Repeated>);

/// Quantities of the measured steps.
fn quantities(found: &Steps) -> Vec<Quantity<'_>> {
    let mut all: Vec<Quantity> = Vec::new();
    if let Some(base) = &found.base {
        let [x_o, y_o] = &base.origin_in_world;
        all.extend([("x_o", x_o, None), ("y_o", y_o, None)]);
    }
    if let Some(mobile) = &found.mobile {
        let [x_c, y_c] = &mobile.circle.centre;
        all.extend([("x_c", x_c, None), ("y_c", y_c, None)]);
    }
    let [d1, d3] = found.offsets.as_ref().map_or([None, None], |[d1, d3]| [Some(d1), Some(d3)]);
    let repeated = [("s", found.s.as_ref()), ("d", d1), ("d3", d3)];
    all.extend(repeated.into_iter().filter_map(|(name, r)| r.map(|r| (name, &r.mean, Some(r)))));
    let leads = ["delta", "delta2", "delta3"].into_iter().zip(&found.leads);
    all.extend(leads.filter_map(|(name, lead)| Some((name, &lead.as_ref()?.ratio, None))));
    all.extend(found.mobile.iter().map(|mobile| ("l_kl", &mobile.l_kl, None)));
    all
}

/// Residuals of every fit.
fn fits(found: &Steps) -> Vec<GeometricStep> {
    let mut steps: Vec<GeometricStep> =
        found.plane.iter().map(|plane| step(phrase!("step-plane-of-rails"), &plane.scatter, None)).collect();
    let base = found.base.as_ref().map(|base| (phrase!("step-arc", ball = "N", about = "O"), &base.arc));
    let mobile = found.mobile.as_ref().map(|mobile| (phrase!("step-arc", ball = "I", about = "C"), &mobile.circle));
    let arcs = base.into_iter().chain(mobile);
    steps.extend(arcs.map(|(name, arc)| step(name, &arc.scatter, Some(arc.coverage_deg))));
    for (i, pair) in found.shafts.iter().enumerate() {
        for (k, shaft) in pair.iter().enumerate() {
            steps.push(step(phrase!("step-shaft", repeat = i + 1, position = k + 1), &shaft.scatter, None));
        }
    }
    for (i, lead) in found.leads.iter().enumerate() {
        steps.extend(lead.iter().map(|lead| step(phrase!("step-travel", actuator = i + 1), &lead.scatter, None)));
    }
    steps
}

/// Result of a scale bar; `None` without a distance.
fn bar_result(definition: &ScaleBarDefinition, pairs: &[[Vector; 2]], u_mm: f64) -> Option<ScaleBarResult> {
    let bar = scale_bar(definition.length_mm, pairs)?;
    // a distance has the uncertainty of two points along it
    let expected = || largest_error_factor(pairs.len()) * SQRT_2 * u_mm;
    let permissible_mm = definition.permissible_error_um.map_or_else(expected, |um| um / 1e3);
    let certificate_mm = definition.length_uncertainty_um.map(|um| um / 1e3);
    let ratio = certificate_mm.map(|certificate| permissible_mm / certificate);
    let largest_error_mm =
        pairs.iter().map(|[a, b]| norm(minus(*b, *a)) - definition.length_mm).fold(0.0, |m: f64, e| m.max(e.abs()));
    let verdict = match ratio {
        None => BarVerdict::NoCertificate,
        Some(ratio) if ratio < LEAST_RATIO => BarVerdict::BarTooUncertain,
        Some(_) if largest_error_mm <= permissible_mm => BarVerdict::Conforming,
        Some(_) => BarVerdict::NotConforming,
    };
    Some(ScaleBarResult {
        name: definition.name.clone(),
        length_mm: definition.length_mm,
        count: bar.count,
        mean_error_mm: bar.mean_error_mm,
        standard_deviation_mm: bar.standard_deviation_mm,
        largest_error_mm,
        length_uncertainty_mm: certificate_mm,
        permissible_error_mm: permissible_mm,
        uncertainty_ratio: ratio,
        verdict,
    })
}

/// Minimum ratio of the permissible error to the expanded uncertainty of the certificate (the 4:1
/// rule of ANSI/NCSL Z540).
const LEAST_RATIO: f64 = 4.0;

/// Size that the largest of `count` independent normal errors exceeds with a probability of 5 %, in
/// their standard deviations (Šidák, 1967).
fn largest_error_factor(count: usize) -> f64 {
    let each = 0.95f64.powf(1.0 / count.max(1) as f64);
    Normal::standard().inverse_cdf(0.5 + 0.5 * each)
}

/// Returns a warning about the instrument or its verification.
fn bar_message(bar: &ScaleBarResult) -> Option<Message> {
    let name = &bar.name;
    let (error_mm, limit_mm) = (bar.largest_error_mm, bar.permissible_error_mm);
    let u_mm = bar.length_uncertainty_mm.unwrap_or(0.0);
    match bar.verdict {
        BarVerdict::NotConforming => Some(warning!("scale-bar-error", name, error_mm, limit_mm)),
        BarVerdict::NoCertificate | BarVerdict::BarTooUncertain if error_mm > limit_mm + u_mm => {
            Some(warning!("scale-bar-deviates", name, error_mm, limit_mm, u_mm))
        }
        BarVerdict::Conforming | BarVerdict::NoCertificate => None,
        BarVerdict::BarTooUncertain => {
            let ratio = bar.uncertainty_ratio.unwrap_or_default();
            Some(warning!("scale-bar-uncertain", name, ratio, least = LEAST_RATIO))
        }
    }
}

fn quantity(
    q: &Quantity,
    readings: &Readings,
    robot: &dyn Robot,
    identified: Option<&Identification>,
) -> GeometricQuantity {
    let &(name, x, repeated) = q;
    let i = robot.index(name).unwrap_or_default();
    let parameter = &robot.parameters()[i];
    let repeats = repeated.map(|r| (r.values.len(), r.repeats(readings)));
    GeometricQuantity {
        name: name.to_owned(),
        unit: parameter.quantity.unit().to_owned(),
        nominal: parameter.nominal,
        value: x.value,
        standard_uncertainty: match repeated {
            Some(repeated) => repeated.standard_uncertainty(readings),
            None => x.standard_uncertainty(readings.standard_uncertainties_mm()),
        },
        uncertainty_by_angles: None,
        repeats: repeats.filter(|(count, _)| *count > 1).map(|(count, r)| RepeatStatistics {
            count,
            standard_deviation: r.standard_deviation,
            expected: r.expected,
            enlarged: r.excess_variance > 0.0,
        }),
        identified: identified.map(|found| found.values[i]),
        identified_standard_uncertainty: identified.and_then(|found| found.standard_uncertainty(i)),
    }
}

/// Sizes (rad) of β, γ and ε_θ, which geometry takes as zero: the identified angle with its
/// standard uncertainty, as a known error without correction (GUM F.2.4.5), or the standard
/// uncertainty by a stated tolerance; `None` if neither is known.
fn angle_sizes(robot: &dyn RailTable, identified: Option<&Identification>) -> [Option<f64>; 3] {
    ["beta", "gamma", "epsilon_theta"].map(|name| {
        let i = robot.index(name)?;
        let p = &robot.parameters()[i];
        let identified = identified.and_then(|found| Some(found.values[i].hypot(found.standard_uncertainty(i)?)));
        identified.or_else(|| p.tolerance_is_stated.then(|| p.tolerance / 3f64.sqrt()))
    })
}

/// Effect of the angles that geometry takes as zero.
struct ByAngles {
    /// Sizes of the angles (rad), as far as they are known.
    angles: [Option<f64>; 3],
    /// Shifts (mm) of s, d and d3 by each angle.
    shifts: [[f64; 3]; 3],
}

impl ByAngles {
    /// Effect at mid-travel; none if the campaign gives no travel.
    fn new(
        robot: &dyn RailTable,
        geometric: &[f64],
        mid_travel_mm: Option<f64>,
        identified: Option<&Identification>,
    ) -> Self {
        let Some(mid_travel_mm) = mid_travel_mm else { return Self { angles: [None; 3], shifts: [[0.0; 3]; 3] } };
        let angles = angle_sizes(robot, identified);
        let shifts = angle_shifts(robot, geometric, mid_travel_mm, angles.map(Option::unwrap_or_default));
        Self { angles, shifts }
    }

    /// Covariance (mm²) that the angles cause between two quantities.
    fn covariance(&self, a: &str, b: &str) -> f64 {
        let index = |name: &str| geometric::BY_ANGLES.iter().position(|other| *other == name);
        let (Some(a), Some(b)) = (index(a), index(b)) else { return 0.0 };
        self.shifts.iter().map(|shift| shift[a] * shift[b]).sum()
    }

    /// Adds the part of the angles to the standard uncertainty of a quantity.
    fn added_to(&self, q: GeometricQuantity) -> GeometricQuantity {
        let by_angles = self.covariance(&q.name, &q.name).sqrt();
        let is_known = self.angles.iter().all(Option::is_some) && geometric::BY_ANGLES.contains(&q.name.as_str());
        GeometricQuantity {
            standard_uncertainty: q.standard_uncertainty.hypot(by_angles),
            uncertainty_by_angles: is_known.then_some(by_angles),
            ..q
        }
    }
}

fn covariance(quantities: &[Quantity], readings: &Readings, by_angles: &ByAngles) -> Vec<Vec<f64>> {
    let u = readings.standard_uncertainties_mm();
    let entry = |a: &Quantity, b: &Quantity| {
        let excess = a.2.filter(|_| a.0 == b.0).map_or(0.0, |r| r.repeats(readings).excess_variance);
        a.1.covariance(b.1, u) + excess + by_angles.covariance(a.0, b.0)
    };
    quantities.iter().map(|a| quantities.iter().map(|b| entry(a, b)).collect()).collect()
}

/// Repeatability of a single ball.
fn ball(campaign: &Campaign, definition: &BallDefinition, readings: &[Vector]) -> Result<BallResult> {
    let found = pose_repeatability(readings).map_err(|problems| problems.at(&campaign.place(&definition.label)))?;
    Ok(BallResult {
        name: definition.name.clone(),
        count: readings.len(),
        mean_mm: found.mean_radius_mm,
        standard_deviation_mm: found.sd_radius_mm,
        repeatability_mm: found.rp_mm,
    })
}

fn step(name: Phrase, scatter: &Scatter, coverage_deg: Option<f64>) -> GeometricStep {
    GeometricStep {
        name: name.into(),
        count: scatter.count,
        standard_deviation_mm: scatter.standard_deviation_mm,
        expected_mm: scatter.expected_mm,
        max_mm: scatter.max_mm,
        norm_mm: scatter.norm_mm,
        enlarged_by: scatter.inflation_factor,
        coverage_deg,
    }
}

/// Returns a warning if residuals exceed the given uncertainty of the instrument.
fn scatter_message(step: &GeometricStep) -> Option<Message> {
    let (found_mm, stated_mm) = (step.standard_deviation_mm, step.expected_mm);
    (step.enlarged_by > 1.0).then(|| warning!("step-scatters", step = step.name, found_mm, stated_mm))
}

fn leads(definition: &GeometricDefinition, found: &Steps) -> Vec<LeadResult> {
    let u = found.readings.standard_uncertainties_mm();
    let result = |actuator: usize| {
        let lead = found.leads.get(actuator.wrapping_sub(1))?.as_ref()?;
        let nominal = definition.lead.iter().find(|d| *d.actuator.get_ref() == actuator)?.lead_mm;
        let linearity = |&(commanded_mm, deviation_mm): &(f64, f64)| Linearity { commanded_mm, deviation_mm };
        Some(LeadResult {
            actuator,
            nominal_lead_mm: nominal,
            actual_lead_mm: nominal * lead.ratio.value,
            error: lead.error(),
            standard_uncertainty: lead.ratio.standard_uncertainty(u),
            linearity: lead.linearity.iter().map(linearity).collect(),
        })
    };
    (1..=3).filter_map(result).collect()
}

fn workspace(definition: &GeometricDefinition, robot: &dyn RailTable, parameters: &[f64]) -> Vec<Region> {
    let (Some(wanted), Some(reached)) = (definition.workspace, Workspace::new(robot, parameters)) else {
        return Vec::new();
    };
    let (deg, theta) = (wanted.theta_deg, wanted.theta_deg.to_radians());
    let regions = [
        (phrase!("region-of-orientation", orientation = 0), reached.at(0.0)),
        (phrase!("region-of-orientation", orientation = deg), reached.at(theta)),
        (phrase!("region-of-orientation", orientation = -deg), reached.at(-theta)),
        (phrase!("region-of-orientations", from = -deg, to = deg), reached.within(theta)),
    ];
    let region = |(name, polygon): (Phrase, Vec<[f64; 2]>)| Region {
        name: name.into(),
        area_mm2: geometric::area_mm2(&polygon),
        corners_mm: polygon.into_iter().map(|[x, y]| [x, y, 0.0]).collect(),
    };
    regions.map(region).into_iter().collect()
}

/// Tables 2.2 to 2.4, mean errors of repeated poses: one for each selection of poses. The three
/// sets of parameters are nominal, geometric and identified.
fn tables(
    campaign: &Campaign,
    definition: &GeometricDefinition,
    robot: &dyn Platform,
    sets: &Sets,
    parameters: [&[f64]; 3],
) -> Result<Vec<PoseTable>> {
    let mut poses: BTreeMap<PoseName, Vec<&Observation>> = BTreeMap::new();
    for o in sets.calibration.iter().chain(&sets.validation) {
        poses.entry(o.pose).or_default().push(o);
    }
    let mut tables = Vec::new();
    for table in &definition.table {
        let place = || campaign.place(&table.poses);
        let selection = Selection::parse(table.poses.get_ref()).map_err(|m| m.at(place()))?;
        let chosen = poses.iter().enumerate().filter(|(i, (pose, _))| selection.contains(**pose, *i, false));
        let rows: Vec<PoseRow> =
            chosen.filter_map(|(_, (pose, observed))| pose_row(robot, *pose, observed, parameters)).collect();
        if rows.is_empty() {
            return Err(error!("table-without-poses", title = table.title).at(place()).into());
        }
        tables.push(PoseTable { title: table.title.clone(), rows });
    }
    Ok(tables)
}

/// Mean errors of one pose; `None` if K and L were never measured together.
fn pose_row(
    robot: &dyn Platform,
    pose: PoseName,
    observed: &[&Observation],
    parameters: [&[f64]; 3],
) -> Option<PoseRow> {
    let errors = |p: &[f64]| -> Vec<[f64; 3]> {
        let error = |o: &&Observation| {
            let [Some(k), Some(l)] = o.targets[..] else { return None };
            // estimated minus measured, turned round
            Some(robot.pose_error(p, &o.joints, [[k[0], k[1]], [l[0], l[1]]]).map(|r| -r))
        };
        observed.iter().filter_map(error).collect()
    };
    let component = |all: &[[f64; 3]], k: usize| mean_and_sd(&all.iter().map(|e| e[k]).collect::<Vec<_>>());
    let mean = |p: &[f64]| {
        let all = errors(p);
        let [x, y, theta] = [component(&all, 0)?, component(&all, 1)?, component(&all, 2)?];
        let mean =
            MeanError { x_mm: x.0, y_mm: y.0, position_mm: x.0.hypot(y.0), orientation_deg: theta.0.to_degrees() };
        Some((mean, x.1.max(y.1), all.len()))
    };
    let [nominal, geometric, identified] = parameters;
    let command = robot.pose(&robot.nominal(), &observed.first()?.joints);
    let (geometric, standard_deviation_mm, count) = mean(geometric)?;
    Some(PoseRow {
        pose,
        command_mm: [command.x_mm, command.y_mm],
        command_deg: command.theta_rad.to_degrees(),
        count,
        nominal: mean(nominal)?.0,
        geometric,
        identified: mean(identified)?.0,
        standard_deviation_mm,
    })
}

/// Largest and root mean square of the mean errors of all tables, by method.
fn methods(tables: &[PoseTable]) -> Vec<MethodErrors> {
    let method = |name: &str, of: fn(&PoseRow) -> MeanError| {
        let errors: Vec<MeanError> = tables.iter().flat_map(|t| &t.rows).map(of).collect();
        MethodErrors {
            name: name.to_owned(),
            position_max_mm: errors.iter().fold(0.0, |m, e| m.max(e.position_mm)),
            position_rms_mm: rms(errors.iter().map(|e| e.position_mm)),
            orientation_max_deg: errors.iter().fold(0.0, |m, e| m.max(e.orientation_deg.abs())),
        }
    };
    if tables.is_empty() {
        return Vec::new();
    }
    vec![method("nominal", |r| r.nominal), method("geometric", |r| r.geometric), method("identified", |r| r.identified)]
}
