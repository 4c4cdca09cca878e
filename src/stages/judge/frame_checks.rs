//! Checks of the frames of a campaign: nominal positions of their points, and errors that the data
//! cannot detect.

use etalon_base::message::{Message, Problems, Result};
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, centroid, minus, norm};
use etalon_base::{error, warning};
use etalon_campaign::{Campaign, WorldDefinition};
use etalon_documents::{FeaturesDocument, FramesDocument, Uncontrolled};
use etalon_fit::rotation_onto;
use etalon_formats::Point;
use etalon_robots::{Parameter, Quantity, Robot, Role};
use std::f64::consts::FRAC_PI_2;

/// Iterations of the minimax fit.
const STEPS: usize = 300;
/// Coverage factor of an expanded uncertainty (GUM 6.3.3).
const COVERAGE: f64 = 2.0;
/// Maximum distance (mm) and rotation (rad) of a base from its nominal position in robot.toml, if
/// robot.toml gives no tolerance.
const BASE: (f64, f64) = (100.0, 0.2);

/// A point with a nominal position.
struct Nominal<'a> {
    name: &'a str,
    nominal_mm: Vector,
    measured_mm: Vector,
    /// Expanded uncertainty of a coordinate.
    expanded_mm: f64,
}

/// Rejects points farther from their nominal positions than their given tolerance and uncertainty
/// allow.
///
/// # Errors
/// Reports names without a measurement, and the point that is off.
pub fn check_nominal(campaign: &Campaign, points: &[Point], frames: &FramesDocument) -> Result<()> {
    let Some(world) = campaign.file.world().filter(|world| !world.nominal_mm.is_empty()) else { return Ok(()) };
    let place = || campaign.world_place();
    let tolerance_mm = world.tolerance_mm.unwrap_or(0.0);
    let known = with_nominal(campaign, points, world, frames).map_err(|more| more.at(&place()))?;
    let pairs = |mirror: f64, without: Option<usize>| -> Vec<(Vector, Vector)> {
        let kept = known.iter().enumerate().filter(|(i, _)| Some(*i) != without);
        kept.map(|(_, p)| ([p.nominal_mm[0], p.nominal_mm[1], mirror * p.nominal_mm[2]], p.measured_mm)).collect()
    };
    let expanded_mm = known.iter().map(|p| p.expanded_mm).fold(0.0, f64::max);
    let allowed_mm = tolerance_mm + 3f64.sqrt() * expanded_mm;
    let off_mm = farthest(&pairs(1.0, None)).1;
    if off_mm <= allowed_mm {
        return Ok(());
    }
    if farthest(&pairs(-1.0, None)).1 <= allowed_mm {
        return Err(error!("frame-points-mirrored", off_mm, limit_mm = allowed_mm).at(place()).into());
    }
    let without = |i: usize| {
        let others = pairs(1.0, Some(i));
        let (pose, left_mm) = farthest(&others);
        (i, left_mm, norm(minus(pose.apply(known[i].nominal_mm), known[i].measured_mm)))
    };
    let explains = (0..known.len()).filter(|_| known.len() > 3).map(without).filter(|(_, left, _)| *left <= allowed_mm);
    let message = match explains.min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((i, _, off_mm)) => error!("frame-point-off", point = known[i].name, off_mm, tolerance_mm, expanded_mm),
        None => {
            let (first, second, measured_mm, nominal_mm) = worst_pair(&known);
            error!("frame-points-off", first, second, measured_mm, nominal_mm, tolerance_mm, expanded_mm)
        }
    };
    Err(message.at(place()).into())
}

/// The points with a nominal position, if they were measured.
fn with_nominal<'c>(
    campaign: &'c Campaign,
    points: &[Point],
    world: &'c WorldDefinition,
    frames: &FramesDocument,
) -> Result<Vec<Nominal<'c>>> {
    let mut problems = Problems::default();
    let labels = || points.iter().map(|p| &*p.label).chain(points.iter().filter_map(|p| p.target.as_deref()));
    let mut known = Vec::new();
    for (name, nominal_mm) in &world.nominal_mm {
        let of_frame = world.targets.iter().flatten().position(|target| target.get_ref() == name);
        let of_frame = of_frame.filter(|_| world.each.is_some());
        let all: Vec<Vector> = match of_frame.and_then(|k| frames.world.reference_mm.get(k)) {
            Some(place) => vec![*place],
            None => {
                let bears = |p: &&Point| *p.label == **name || p.target.as_deref() == Some(name.as_str());
                points.iter().filter(bears).map(|p| p.xyz_mm).collect()
            }
        };
        match centroid(&all) {
            Some(measured_mm) => {
                let u_mm = campaign.file.instrument.standard_uncertainty_at_mm(measured_mm);
                let expanded_mm = COVERAGE * u_mm / (all.len() as f64).sqrt();
                known.push(Nominal { name, nominal_mm: *nominal_mm, measured_mm, expanded_mm });
            }
            None => {
                problems.0.push(error!("nominal-point-unmeasured", point = name).hint_names(name, labels()));
            }
        }
    }
    problems.check()?;
    if known.len() < 3 {
        return Err(error!("nominal-few-points").into());
    }
    Ok(known)
}

/// Names, measured and nominal distance of the two points with the largest deviation of their
/// distance.
fn worst_pair<'a>(known: &[Nominal<'a>]) -> (&'a str, &'a str, f64, f64) {
    let pairs = (0..known.len()).flat_map(|b| (0..b).map(move |a| (&known[a], &known[b])));
    let distances = pairs.map(|(a, b)| {
        let of = |place: fn(&Nominal) -> Vector| norm(minus(place(a), place(b)));
        (a.name, b.name, of(|p| p.measured_mm), of(|p| p.nominal_mm))
    });
    let off = |d: &(&str, &str, f64, f64)| (d.2 - d.3).abs();
    distances.max_by(|x, y| off(x).total_cmp(&off(y))).unwrap_or(("", "", f64::NAN, f64::NAN))
}

/// Returns the motion from the first to the second point of each pair with the smallest maximum
/// distance, and that distance: weighted least squares whose weights grow with the distances
/// (Lawson 1961).
fn farthest(pairs: &[(Vector, Vector)]) -> (Pose, f64) {
    let mut weights = vec![1.0 / pairs.len() as f64; pairs.len()];
    let mut best = (Pose::identity(), f64::INFINITY);
    for _ in 0..STEPS {
        let middle = |of: fn(&(Vector, Vector)) -> Vector| {
            pairs.iter().zip(&weights).fold([0.0; 3], |sum, (pair, w)| [0, 1, 2].map(|i| sum[i] + w * of(pair)[i]))
        };
        let (here, there) = (middle(|p| p.0), middle(|p| p.1));
        let weighted = pairs.iter().zip(&weights).map(|((p, q), w)| (minus(*p, here).map(|v| w * v), minus(*q, there)));
        let turn = Pose { rotation: rotation_onto(weighted), translation_mm: [0.0; 3] };
        let pose = Pose { translation_mm: minus(there, turn.rotate(here)), ..turn };
        let distances: Vec<f64> = pairs.iter().map(|(p, q)| norm(minus(pose.apply(*p), *q))).collect();
        let largest = distances.iter().copied().fold(0.0, f64::max);
        if largest < best.1 {
            best = (pose, largest);
        }
        let total: f64 = weights.iter().zip(&distances).map(|(w, d)| w * d).sum();
        if total <= 0.0 {
            break;
        }
        weights.iter_mut().zip(&distances).for_each(|(w, d)| *w *= d / total);
    }
    best
}

/// Returns the errors of the frames that no reading of a campaign can detect, with the keys that
/// would control them.
pub fn not_controlled(
    campaign: &Campaign,
    robot: Option<&dyn Robot>,
    features: &FeaturesDocument,
) -> Vec<Uncontrolled> {
    let mut all = Vec::new();
    if let Some(world) = campaign.file.world().filter(|world| !world.as_exported) {
        let nominal = |name: &String| world.nominal_mm.contains_key(name);
        let points: Vec<String> = once_measured(world, features).into_iter().filter(|name| !nominal(name)).collect();
        if !points.is_empty() {
            all.push(Uncontrolled {
                what: phrase!("unshown-frame-points").into(),
                points,
                keys: ["nominal_mm", "tolerance_mm"].map(|key| format!("[frame.world] {key}")).to_vec(),
            });
        }
        if world.nominal_mm.is_empty() && world.each.is_some() {
            all.push(Uncontrolled {
                what: phrase!("unshown-frame-targets").into(),
                points: world.targets.iter().flatten().map(|target| target.get_ref().clone()).collect(),
                keys: ["nominal_mm", "tolerance_mm"].map(|key| format!("[frame.world] {key}")).to_vec(),
            });
        }
    }
    let Some(robot) = robot.filter(|_| campaign.identifies()) else { return all };
    let absorbs_scale = robot.joints().iter().enumerate().all(|(k, joint)| {
        let is_gain = |p: &Parameter| p.joint == Some(k) && p.quantity == Quantity::Ratio;
        joint.quantity == Quantity::Angle || robot.parameters().iter().any(is_gain)
    });
    if absorbs_scale && campaign.file.instrument.expanded_scale_uncertainty_um_per_m.is_none() {
        all.push(Uncontrolled {
            what: phrase!("unshown-scale").into(),
            points: Vec::new(),
            keys: vec!["[instrument] expanded_scale_uncertainty_um_per_m".to_owned()],
        });
    }
    if robot.free_base().is_none() {
        return all;
    }
    let missing: Vec<&str> = base(robot).filter(|name| !campaign.robot.states_nominal(name)).collect();
    if !missing.is_empty() {
        all.push(Uncontrolled {
            what: phrase!("unshown-shift").into(),
            points: Vec::new(),
            keys: vec![format!("robot.toml: [nominal] {}", missing.join(", "))],
        });
    }
    all
}

/// Names of the parameters of the base.
fn base(robot: &dyn Robot) -> impl Iterator<Item = &str> {
    robot.parameters().iter().filter(|p| p.role == Role::Base).map(|p| p.name.as_str())
}

/// Labels and features that define a frame, each as often as needed and no more.
fn once_measured(world: &WorldDefinition, features: &FeaturesDocument) -> Vec<String> {
    if world.each.is_some() {
        return Vec::new();
    }
    if let Some(targets) = &world.targets {
        return targets.iter().map(|target| target.get_ref().clone()).collect();
    }
    let fewest = |element: &str| match element {
        "line" => 2,
        "cylinder" => 5,
        _ => 3,
    };
    let mut names: Vec<String> = Vec::new();
    for name in world.plane.iter().chain(world.names()).map(|name| name.get_ref()) {
        let labels = match features.features.iter().find(|f| f.name == *name) {
            // repeats of a point are no other points
            Some(f) if f.labels.len() > fewest(&f.element) || f.labels.iter().any(|label| label.contains('*')) => &[],
            Some(f) => &f.labels[..],
            None => std::slice::from_ref(name),
        };
        for label in labels {
            if !names.contains(label) {
                names.push(label.clone());
            }
        }
    }
    names
}

/// Returns a warning if the identified base is far from its position in robot.toml, which gives no
/// tolerance.
pub fn base_elsewhere(campaign: &Campaign, robot: &dyn Robot, values: &[f64]) -> Option<Message> {
    let stated = base(robot).all(|name| campaign.robot.states_nominal(name)) && robot.free_base().is_some();
    if !stated || robot.parameters().iter().any(|p| p.role == Role::Base && p.tolerance.is_finite()) {
        return None;
    }
    let pose = |values: &[f64]| {
        let of = |quantity: Quantity| -> Vec<f64> {
            let own = robot.parameters().iter().zip(values);
            own.filter(|(p, _)| p.role == Role::Base && p.quantity == quantity).map(|(_, v)| *v).collect()
        };
        let (place, turn) = (of(Quantity::Length), of(Quantity::Angle));
        let turned = Pose::from_rotation_vector([*turn.first()?, *turn.get(1)?, *turn.get(2)?]);
        Some(Pose { translation_mm: [*place.first()?, *place.get(1)?, *place.get(2)?], ..turned })
    };
    let (nominal, found) = (pose(&robot.nominal())?, pose(values)?);
    let moved = nominal.inverse().then(&found);
    let (off_mm, off_rad) = (norm(moved.translation_mm), moved.angle_rad());
    if off_mm <= BASE.0 && off_rad <= BASE.1 {
        return None;
    }
    // axes of the world that are swapped carry the nominal base to the identified one
    let exchanged = cube().into_iter().find(|turn| {
        let carried = turn.then(&nominal);
        let left = carried.inverse().then(&found);
        left.angle_rad() <= BASE.1 && norm(minus(carried.translation_mm, found.translation_mm)) <= BASE.0
    });
    let off_deg = off_rad.to_degrees();
    let message = match exchanged {
        Some(turn) => {
            let axis = |k: usize| {
                let to = turn.axis(k);
                let along = (0..3).max_by(|&a, &b| to[a].abs().total_cmp(&to[b].abs())).unwrap_or(0);
                format!("{}{}", if to[along] < 0.0 { "-" } else { "" }, ["x", "y", "z"][along])
            };
            warning!("world-axes-exchanged", off_mm, off_deg, axes = [axis(0), axis(1), axis(2)])
        }
        None => warning!("base-off-nominal", off_mm, off_deg, limit_mm = BASE.0, limit_deg = BASE.1.to_degrees()),
    };
    Some(message.to_decide())
}

/// The rotations that map a cube onto itself, without the identity.
fn cube() -> Vec<Pose> {
    let about = |axis: usize, k: u8| match axis {
        0 => Pose::identity().turn_x(f64::from(k) * FRAC_PI_2),
        _ => Pose::identity().turn_y(f64::from(k) * FRAC_PI_2),
    };
    let up = [about(0, 0), about(0, 1), about(0, 2), about(0, 3), about(1, 1), about(1, 3)];
    let all = up.iter().flat_map(|tilt| (0..4u8).map(move |k| tilt.turn_z(f64::from(k) * FRAC_PI_2)));
    all.filter(|pose| pose.angle_rad() > 0.5).collect()
}
