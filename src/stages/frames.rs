//! World frames from features and targets (thesis 3.4.1), and targets brought into them.

use crate::base::message::{Message, Problems, Result};
use crate::base::pose::{Pose, Vector, centroid, cross, dot, minus, norm, unit};
use crate::campaign::{Campaign, WorldDefinition};
use crate::document::{Feature, FeaturesDocument, FramePose, FramesDocument, WorldFrame};
use crate::import::Point;
use crate::math::fit;
use crate::stages::labelled_points::LabelledPoints;
use std::collections::BTreeMap;
use toml::Spanned;

/// Pose and cycle of targets measured together.
type Key = (i64, i64);

/// Fits the features of a campaign to the points with their labels.
pub fn fit_features(campaign: &Campaign, points: &[Point]) -> Result<FeaturesDocument> {
    let labelled = LabelledPoints::new(campaign, points);
    let settings = fit::Settings::default();
    let (mut features, mut messages, mut problems) = (Vec::new(), Vec::new(), Problems::default());
    for (name, definition) in &campaign.file.features {
        let Some((element, labels)) = definition.element() else { continue };
        let chosen: Vec<Vector> = labels.iter().flat_map(|l| labelled.named([l])).collect();
        let found = match element {
            "plane" => fit::plane(&chosen, &settings),
            "line" => fit::line(&chosen, &settings),
            "circle" => fit::circle3d(&chosen, &settings),
            _ => fit::cylinder(&chosen, &settings),
        };
        let fitted = match found {
            Ok(fitted) => fitted,
            Err(more) => {
                let place = labels.first().map(|l| Box::new(campaign.place(l)));
                let named =
                    |m: Message| Message { what: format!("feature `{name}`: {}", m.what), place: place.clone(), ..m };
                problems.0.extend(more.0.into_iter().map(named));
                continue;
            }
        };
        messages.extend(
            fitted.warnings.iter().map(|w| Message { what: format!("feature `{name}`: {}", w.what), ..w.clone() }),
        );
        let direction_deg = fitted.standard_uncertainty().and_then(|u| u.direction_rad).unwrap_or(0.0).to_degrees();
        if direction_deg > DIRECTION_UNKNOWN_DEG {
            let what =
                format!("feature `{name}`: its points do not determine its direction ({direction_deg:.0} deg, k = 1)");
            let message = Message::error(what).hint("measure points farther apart, not all on one line");
            problems.0.push(labels.first().map_or(message.clone(), |l| message.at(campaign.place(l))));
        } else if direction_deg > DIRECTION_POOR_DEG {
            let what = format!("feature `{name}`: its direction is known to {direction_deg:.2} deg only (k = 1)");
            messages.push(Message::warning(what).hint("measure points farther apart"));
        }
        features.push(Feature {
            name: name.clone(),
            element: element.to_owned(),
            labels: labels.iter().map(|l| l.get_ref().clone()).collect(),
            points: chosen.len(),
            point_mm: fitted.point_mm,
            direction: fitted.direction.unwrap_or_default(),
            radius_mm: fitted.radius_mm,
            rms_mm: fitted.rms_mm(),
            max_mm: fitted.max_mm(),
            standard_uncertainty_mm: fitted.standard_uncertainty().map(|u| u.radius_mm.unwrap_or(u.point_largest_mm)),
        });
    }
    problems.check()?;
    Ok(FeaturesDocument { schema: "etalon/features/1".to_owned(), features, messages })
}

/// A direction worse known than this spoils a frame: 0.1 deg is 0.5 mm over 300 mm.
const DIRECTION_POOR_DEG: f64 = 0.1;
/// A direction worse known than this is none.
const DIRECTION_UNKNOWN_DEG: f64 = 3.0;
/// `towards` must be off the axis by this share of its distance from the origin.
const OFF_AXIS: f64 = 0.01;

/// Makes the world frame of a campaign; `planar` for robots that move in its xy plane.
pub fn make_frames(
    campaign: &Campaign,
    points: &[Point],
    features: &FeaturesDocument,
    planar: bool,
) -> Result<FramesDocument> {
    let world = match campaign.file.world().filter(|world| !world.as_exported) {
        Some(WorldDefinition { targets: Some(targets), each, .. }) => {
            from_targets(campaign, points, targets, each.is_some())?
        }
        Some(world) => from_plane(campaign, points, features, world)?,
        None => WorldFrame {
            definition: "the coordinates of the exports are those of the world".to_owned(),
            planar: false,
            poses: vec![FramePose { pose: None, cycle: None, export_T_world: Pose::identity() }],
            rms_mm: None,
            max_mm: None,
            reference_mm: Vec::new(),
        },
    };
    Ok(FramesDocument { schema: "etalon/frames/1".to_owned(), world: WorldFrame { planar, ..world } })
}

/// xy plane, origin and one axis, each projected into the plane (thesis 3.4.1).
fn from_plane(
    campaign: &Campaign,
    points: &[Point],
    features: &FeaturesDocument,
    world: &WorldDefinition,
) -> Result<WorldFrame> {
    let labelled = LabelledPoints::new(campaign, points);
    let feature = |name: &str| features.features.iter().find(|f| f.name == name);
    let wrong = |what: &str| Message::error(what.to_owned()).at(campaign.world_place());
    let plane_name = world.plane.as_ref().ok_or_else(|| wrong("the world frame has no plane"))?;
    let plane = feature(plane_name.get_ref()).ok_or_else(|| wrong("the plane of the world frame is not a feature"))?;
    let normal = plane.direction;
    let project = |p: Vector| {
        let height = dot(minus(p, plane.point_mm), normal);
        [p[0] - height * normal[0], p[1] - height * normal[1], p[2] - height * normal[2]]
    };
    let place = |name: &Spanned<String>| {
        let text = name.get_ref();
        let found = feature(text).map(|f| f.point_mm).or_else(|| centroid(&labelled.named([name])));
        found.map(project).ok_or_else(|| Message::error(format!("nothing is called `{text}`")).at(campaign.place(name)))
    };
    let origin = place(world.origin.as_ref().ok_or_else(|| wrong("the world frame has no origin"))?)?;
    let towards = place(world.towards.as_ref().ok_or_else(|| wrong("the world frame has no `towards`"))?)?;
    let (axis_name, ends) = match (&world.x_axis, &world.y_axis) {
        (Some(ends), None) => ("x", ends),
        (None, Some(ends)) => ("y", ends),
        _ => return Err(wrong("the world frame needs one of `x_axis` and `y_axis`").into()),
    };
    let along = match &ends[..] {
        [from, to] => minus(place(to)?, place(from)?),
        [one] => feature(one.get_ref()).map(|f| f.direction).unwrap_or_default(),
        _ => [0.0; 3],
    };
    let along = minus(along, normal.map(|n| n * dot(along, normal)));
    let first = unit(along).ok_or_else(|| {
        wrong("the axis of the world frame has no direction")
            .expected("two labels, from and to, or one feature with a direction")
    })?;
    let side = minus(towards, origin);
    let off_axis = minus(side, first.map(|v| v * dot(side, first)));
    let other = unit(off_axis)
        .filter(|_| norm(off_axis) > OFF_AXIS * norm(side))
        .ok_or_else(|| wrong("`towards` lies on the axis: it does not determine the side of the other one"))?;
    let (x, y) = if axis_name == "x" { (first, other) } else { (other, first) };
    let definition = format!(
        "xy plane: feature `{}`; origin: `{}`; {axis_name} axis: {}; other axis towards `{}`",
        plane_name.get_ref(),
        world.origin.as_ref().map_or("", |o| o.get_ref()),
        ends.iter().map(|e| format!("`{}`", e.get_ref())).collect::<Vec<_>>().join(" to "),
        world.towards.as_ref().map_or("", |t| t.get_ref()),
    );
    Ok(WorldFrame {
        definition,
        planar: false,
        poses: vec![FramePose { pose: None, cycle: None, export_T_world: from_axes(origin, x, y) }],
        rms_mm: None,
        max_mm: None,
        reference_mm: Vec::new(),
    })
}

/// Frame with unit axes x and y, and z = x × y.
fn from_axes(origin: Vector, x: Vector, y: Vector) -> Pose {
    let z = cross(x, y);
    Pose { rotation: [0, 1, 2].map(|i| [x[i], y[i], z[i]]), translation_mm: origin }
}

/// Origin at the first point, x towards the second, the third in the xy plane with y > 0.
fn three_two_one(p: &[Vector]) -> Option<Pose> {
    let x = unit(minus(*p.get(1)?, p[0]))?;
    let side = minus(*p.get(2)?, p[0]);
    let y = unit(minus(side, x.map(|v| v * dot(side, x))))?;
    Some(from_axes(p[0], x, y))
}

/// The frame that targets carry: their mean places in it, and each pose as the best fit to those places.
fn from_targets(campaign: &Campaign, points: &[Point], targets: &[Spanned<String>], each: bool) -> Result<WorldFrame> {
    let names: Vec<&str> = targets.iter().map(|t| t.get_ref().as_str()).collect();
    let wrong = |what: String| Message::error(what).at(campaign.world_place());
    if names.len() < 3 {
        return Err(wrong("a frame needs three targets or more".to_owned()).into());
    }
    let seen = if each {
        measured(points, &names)
    } else {
        // measured once or often, with or without a pose: the mean of all points of that name
        let of = |name: &&str| {
            let bears = |p: &&Point| p.target.as_deref() == Some(*name) || p.label == *name;
            centroid(&points.iter().filter(bears).map(|p| p.xyz_mm).collect::<Vec<_>>())
        };
        BTreeMap::from([((0, 0), names.iter().map(of).collect())])
    };
    let whole: BTreeMap<Key, Vec<Vector>> =
        seen.into_iter().filter_map(|(key, places)| Some((key, places.into_iter().collect::<Option<_>>()?))).collect();
    let local = |p: &Vec<Vector>| {
        let world = three_two_one(p)?.inverse();
        Some(p.iter().map(|p| world.apply(*p)).collect::<Vec<_>>())
    };
    let locals: Vec<Vec<Vector>> = whole.values().filter_map(local).collect();
    if locals.is_empty() {
        return Err(wrong(format!("no pose has all of the targets {} apart from each other", names.join(", "))).into());
    }
    let mean = |k: usize| centroid(&locals.iter().map(|l| l[k]).collect::<Vec<_>>());
    let reference: Vec<Vector> = (0..names.len()).filter_map(mean).collect();
    let (mut poses, mut squares, mut largest) = (Vec::new(), 0.0, 0.0f64);
    for (&(pose, cycle), places) in &whole {
        let fitted = fit::rigid(&reference, places)?;
        for r in fitted.distances_mm() {
            squares += r * r;
            largest = largest.max(r);
        }
        let (pose, cycle) = if each { (Some(pose), Some(cycle)) } else { (None, None) };
        poses.push(FramePose { pose, cycle, export_T_world: fitted.to_T_from });
    }
    let definition = format!(
        "best fit of the targets {}{}: origin at the first, x axis to the second, the third in the xy plane",
        names.join(", "),
        if each { ", measured again at every pose" } else { "" },
    );
    let rms = (squares / (poses.len() * names.len()) as f64).sqrt();
    Ok(WorldFrame {
        definition,
        planar: false,
        poses,
        rms_mm: Some(rms),
        max_mm: Some(largest),
        reference_mm: reference,
    })
}

/// Where each of the named targets was, by pose and cycle.
fn measured(points: &[Point], names: &[&str]) -> BTreeMap<Key, Vec<Option<Vector>>> {
    let mut seen: BTreeMap<Key, Vec<Option<Vector>>> = BTreeMap::new();
    for point in points {
        let target = names.iter().position(|n| Some(*n) == point.target.as_deref());
        let (Some(k), Some(pose)) = (target, point.pose) else { continue };
        let key = (pose, point.cycle.unwrap_or(1));
        seen.entry(key).or_insert_with(|| vec![None; names.len()])[k] = Some(point.xyz_mm);
    }
    seen
}
