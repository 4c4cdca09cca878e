//! World frames from features and targets (thesis 3.4.1), and targets transformed into them.

use crate::stages::gather::used_labels;
use crate::stages::observe::labelled_points::LabelledPoints;
use crate::stages::observe::repeats;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result, Severity};
use etalon_base::pattern::matches_pattern;
use etalon_base::pose::{Pose, Vector, centroid, cross, dot, minus, norm, unit};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, FeatureElement, WorldDefinition};
use etalon_documents::{Feature, FeaturesDocument, FramePose, FramesDocument, WorldFrame};
use etalon_formats::Point;
use std::collections::{BTreeMap, BTreeSet};
use toml::Spanned;

/// Pose and cycle of targets measured together.
type Key = (PoseName, i64);

/// Fits the features of a campaign to the points with their labels.
pub fn fit_features(campaign: &Campaign, points: &[Point]) -> Result<FeaturesDocument> {
    let mut document = elements(campaign, points)?;
    let repeated = repeats::fixed_points(campaign, points, &used_labels(campaign));
    let (errors, warnings): (Vec<Message>, Vec<Message>) =
        repeated.into_iter().partition(|message| message.severity == Severity::Error);
    Problems(errors).check()?;
    document.messages.splice(0..0, warnings);
    Ok(document)
}

fn elements(campaign: &Campaign, points: &[Point]) -> Result<FeaturesDocument> {
    let labelled = LabelledPoints::new(campaign, points);
    let settings = etalon_fit::FitSettings::default();
    let (mut features, mut messages, mut problems) = (Vec::new(), Vec::new(), Problems::default());
    for (name, definition) in &campaign.file.features {
        let Some((element, labels)) = definition.element() else { continue };
        let chosen: Vec<Vector> = match labels {
            // a scan may have millions of points
            [label] => labelled.named([label]),
            labels => labels.iter().flat_map(|l| labelled.named([l])).collect(),
        };
        let fitted = match fitted(element, &chosen, &settings) {
            Ok(fitted) => fitted,
            Err(more) => {
                let place = labels.first().map(|l| Box::new(campaign.place(l)));
                let named = |m: Message| Message { place: place.clone(), ..m.within(phrase!("in-feature", name)) };
                problems.0.extend(more.0.into_iter().map(named));
                continue;
            }
        };
        let all = etalon_fit::warnings(&fitted, &etalon_fit::Source::from(&chosen), &settings);
        messages.extend(all.into_iter().map(|warning| warning.within(phrase!("in-feature", name))));
        let direction_deg = fitted.standard_uncertainty().and_then(|u| u.direction_rad).unwrap_or(0.0).to_degrees();
        if direction_deg > DIRECTION_UNKNOWN_DEG {
            let message = error!("direction-undetermined", direction_deg, limit_deg = DIRECTION_UNKNOWN_DEG);
            let message = message.within(phrase!("in-feature", name));
            problems.0.push(labels.first().map_or(message.clone(), |l| message.at(campaign.place(l))));
        } else if direction_deg > DIRECTION_POOR_DEG {
            let message = warning!("direction-uncertain", direction_deg, limit_deg = DIRECTION_POOR_DEG);
            messages.push(message.within(phrase!("in-feature", name)));
        }
        features.push(Feature {
            name: name.clone(),
            element: element.name().to_owned(),
            labels: labels.iter().map(|l| l.get_ref().clone()).collect(),
            points: chosen.len(),
            point_mm: fitted.geometry.point_mm,
            direction: fitted.geometry.direction.unwrap_or_default(),
            radius_mm: fitted.geometry.radius_mm,
            rms_mm: fitted.rms_mm(),
            max_mm: fitted.max_mm(),
            standard_uncertainty_mm: fitted.standard_uncertainty().map(|u| u.radius_mm.unwrap_or(u.point_largest_mm)),
        });
    }
    problems.check()?;
    Ok(FeaturesDocument { schema: "etalon/features/1".to_owned(), features, messages })
}

fn fitted(element: FeatureElement, points: &[Vector], settings: &etalon_fit::FitSettings) -> Result<etalon_fit::Fit> {
    match element {
        FeatureElement::Plane => etalon_fit::plane(points, settings),
        FeatureElement::Line => etalon_fit::line(points, settings),
        FeatureElement::Circle => etalon_fit::circle3d(points, settings),
        FeatureElement::Cylinder => etalon_fit::cylinder(points, settings),
    }
}

/// Standard uncertainty (deg) of a direction above which a warning is given: 0.1 deg is 0.5 mm over
/// 300 mm.
const DIRECTION_POOR_DEG: f64 = 0.1;
/// Maximum standard uncertainty (deg) of a direction that may define a frame.
const DIRECTION_UNKNOWN_DEG: f64 = 3.0;
/// Minimum distance of `towards` from the axis, as a share of its distance from the origin.
const OFF_AXIS: f64 = 0.01;

/// Computes the world frame of a campaign; `planar` for robots that move in its xy plane.
pub fn make_frames(
    campaign: &Campaign,
    points: &[Point],
    features: &FeaturesDocument,
    planar: bool,
) -> Result<FramesDocument> {
    let mut world = placed(campaign, points, features)?;
    if let Some(stated) = campaign.file.world().filter(|world| !world.as_exported && world.targets.is_none()) {
        world.poses[0].covariance = Some(covariance(campaign, points, stated, &world.poses[0].export_T_world)?);
    }
    if planar {
        at_height(&mut world, points);
    }
    Ok(FramesDocument {
        schema: "etalon/frames/1".to_owned(),
        world: WorldFrame { planar, ..world },
        not_controlled: Vec::new(),
    })
}

/// Returns the poses of the world frame from these points alone, without the covariance of a frame
/// defined by features.
pub fn place(campaign: &Campaign, points: &[Point]) -> Result<Vec<FramePose>> {
    let features = elements(campaign, points)?;
    match campaign.file.world() {
        Some(world) if !world.as_exported && world.targets.is_none() => {
            let geometry = Geometry::new(campaign, points, &features, world);
            Ok(vec![for_all_poses(plane_pose(campaign, &geometry, world)?)])
        }
        _ => Ok(placed(campaign, points, &features)?.poses),
    }
}

/// The points that define the world frame.
pub fn defining(campaign: &Campaign, points: &[Point]) -> Vec<Point> {
    let Some(world) = campaign.file.world().filter(|world| !world.as_exported) else { return Vec::new() };
    let of_target = |p: &Point| {
        let is = |t: &Spanned<String>| p.target.as_deref() == Some(t.get_ref()) || *p.label == **t.get_ref();
        world.targets.iter().flatten().any(is)
    };
    let labels = used_labels(campaign);
    let used = |p: &&Point| {
        of_target(p) || world.targets.is_none() && labels.iter().any(|name| matches_pattern(name, &p.label))
    };
    points.iter().filter(used).cloned().collect()
}

fn placed(campaign: &Campaign, points: &[Point], features: &FeaturesDocument) -> Result<WorldFrame> {
    Ok(match campaign.file.world().filter(|world| !world.as_exported) {
        Some(WorldDefinition { targets: Some(targets), each, .. }) => {
            from_targets(campaign, points, targets, each.is_some())?
        }
        Some(world) => {
            let pose = plane_pose(campaign, &Geometry::new(campaign, points, features, world), world)?;
            fixed(plane_definition(world), pose)
        }
        None => fixed(phrase!("frame-as-exported"), Pose::identity()),
    })
}

/// A world frame for all poses.
fn fixed(definition: Phrase, export_T_world: Pose) -> WorldFrame {
    WorldFrame {
        definition: definition.into(),
        planar: false,
        poses: vec![for_all_poses(export_T_world)],
        common_covariance: None,
        rms_mm: None,
        max_mm: None,
        reference_mm: Vec::new(),
    }
}

fn for_all_poses(export_T_world: Pose) -> FramePose {
    FramePose { pose: None, cycle: None, export_T_world, covariance: None }
}

/// Features and labels that define a world frame, by name.
#[derive(Default)]
struct Geometry {
    /// Point and direction of the features.
    features: BTreeMap<String, (Vector, Vector)>,
    /// Positions of the labels that are not features.
    places: BTreeMap<String, Vector>,
}

impl Geometry {
    fn new(campaign: &Campaign, points: &[Point], features: &FeaturesDocument, world: &WorldDefinition) -> Self {
        let labelled = LabelledPoints::new(campaign, points);
        let features: BTreeMap<_, _> =
            features.features.iter().map(|f| (f.name.clone(), (f.point_mm, f.direction))).collect();
        let labels = world.names().filter(|name| !features.contains_key(name.get_ref()));
        let place = |name: &Spanned<String>| Some((name.get_ref().clone(), centroid(&labelled.named([name]))?));
        Self { places: labels.filter_map(place).collect(), features }
    }
}

/// Pose of a frame by its xy plane, origin and one axis, each projected into the plane (thesis
/// 3.4.1).
fn plane_pose(campaign: &Campaign, geometry: &Geometry, world: &WorldDefinition) -> Result<Pose> {
    let lacks = || error!("plane-frame-incomplete").at(campaign.world_place());
    let plane_name = world.plane.as_ref().ok_or_else(lacks)?;
    let (on_plane, normal) = *(geometry.features.get(plane_name.get_ref())).ok_or_else(lacks)?;
    let project = |p: Vector| {
        let height = dot(minus(p, on_plane), normal);
        [p[0] - height * normal[0], p[1] - height * normal[1], p[2] - height * normal[2]]
    };
    let place = |name: &Spanned<String>| {
        let text = name.get_ref();
        let found = geometry.features.get(text).map(|(point, _)| *point).or_else(|| geometry.places.get(text).copied());
        found.map(project).ok_or_else(|| error!("point-or-feature-unknown", name = text).at(campaign.place(name)))
    };
    let origin = place(world.origin.as_ref().ok_or_else(lacks)?)?;
    let towards = place(world.towards.as_ref().ok_or_else(lacks)?)?;
    let (axis_name, ends) = match (&world.x_axis, &world.y_axis) {
        (Some(ends), None) => ("x", ends),
        (None, Some(ends)) => ("y", ends),
        _ => return Err(lacks().into()),
    };
    let along = match &ends[..] {
        [from, to] => minus(place(to)?, place(from)?),
        [one] => geometry.features.get(one.get_ref()).map(|(_, direction)| *direction).unwrap_or_default(),
        _ => [0.0; 3],
    };
    let along = minus(along, normal.map(|n| n * dot(along, normal)));
    let first = unit(along).ok_or_else(|| error!("frame-axis-without-direction").at(campaign.world_place()))?;
    let side = minus(towards, origin);
    let off_axis = minus(side, first.map(|v| v * dot(side, first)));
    let other = unit(off_axis)
        .filter(|_| norm(off_axis) > OFF_AXIS * norm(side))
        .ok_or_else(|| error!("world-side-undetermined").at(campaign.world_place()))?;
    let (x, y) = if axis_name == "x" { (first, other) } else { (other, first) };
    Ok(from_axes(origin, x, y))
}

/// Definition of a frame by a plane, in words.
fn plane_definition(world: &WorldDefinition) -> Phrase {
    let (axis, ends) = match (&world.x_axis, &world.y_axis) {
        (Some(ends), _) => ("x", &ends[..]),
        (None, ends) => ("y", ends.as_deref().unwrap_or_default()),
    };
    let name = |name: Option<&Spanned<String>>| name.map_or_else(String::new, |name| name.get_ref().clone());
    phrase!(
        "frame-from-plane",
        plane = name(world.plane.as_ref()),
        origin = name(world.origin.as_ref()),
        axis,
        from = name(ends.first()),
        to = name(ends.last()),
        towards = name(world.towards.as_ref()),
    )
}

/// Covariance of a world frame from the uncertainty of each point that defines it: Z = (f(x + u) −
/// f(x − u)) / 2 for each coordinate (GUM 5.1.3, note 2), and the sum of Z Zᵀ.
fn covariance(campaign: &Campaign, points: &[Point], world: &WorldDefinition, nominal: &Pose) -> Result<[[f64; 6]; 6]> {
    let mut basis = Basis::new(campaign, points, world);
    let mut sum = [[0.0; 6]; 6];
    for i in 0..basis.points.len() {
        for axis in 0..3 {
            let (at, u_mm) = (basis.points[i][axis], basis.u_mm[i][axis]);
            let mut moved = |by: f64| {
                basis.points[i][axis] = at + by;
                let pose = plane_pose(campaign, &basis.geometry()?, world)?;
                Ok::<_, Problems>(twist(&nominal.inverse().then(&pose)))
            };
            let (up, down) = (moved(u_mm)?, moved(-u_mm)?);
            basis.points[i][axis] = at;
            add_outer(&mut sum, &std::array::from_fn(|k| 0.5 * (up[k] - down[k])));
        }
    }
    Ok(sum)
}

/// Maximum number of points whose uncertainty is propagated one by one.
const FEW: usize = 300;
/// Golden-section steps, which avoid aliasing with patterns of the measured points.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Points that define a world frame. Some points of each label represent many: each has the weight
/// of the points that it represents, and the uncertainty of their mean.
struct Basis {
    points: Vec<Vector>,
    weights: Vec<f64>,
    u_mm: Vec<Vector>,
    /// Elements by name, and the points of each.
    features: Vec<(String, FeatureElement, Vec<usize>)>,
    /// Labels that are not features, and their points.
    places: Vec<(String, Vec<usize>)>,
}

impl Basis {
    fn new(campaign: &Campaign, points: &[Point], world: &WorldDefinition) -> Self {
        let named: Vec<&str> = world.plane.iter().chain(world.names()).map(|n| n.get_ref().as_str()).collect();
        let elements = campaign.file.features.iter().filter(|(name, _)| named.contains(&name.as_str()));
        let elements: Vec<_> = elements.filter_map(|(name, f)| f.element().map(|found| (name, found))).collect();
        let is_label = |name: &&str| !elements.iter().any(|(feature, _)| feature.as_str() == *name);
        let mut labels: Vec<&str> =
            elements.iter().flat_map(|(_, (_, labels))| labels.iter().map(|l| l.get_ref().as_str())).collect();
        labels.extend(named.iter().copied().filter(is_label));
        let mut seen = BTreeSet::new();
        labels.retain(|label| seen.insert(*label));
        let mut of_label = vec![Vec::new(); labels.len()];
        for point in points {
            if let Some(k) = labels.iter().position(|label| matches_pattern(label, &point.label)) {
                of_label[k].push(point);
            }
        }
        let all: usize = of_label.iter().map(Vec::len).sum();
        let mut basis = Self {
            points: Vec::new(),
            weights: Vec::new(),
            u_mm: Vec::new(),
            features: Vec::new(),
            places: Vec::new(),
        };
        let mut kept = Vec::new();
        for group in of_label {
            let few = if all <= FEW { group.len() } else { group.len().min((FEW / labels.len()).max(1)) };
            let share = few as f64 / group.len().max(1) as f64;
            let is_kept = |i: usize| few == group.len() || (i as f64 * GOLDEN).fract() < share;
            let chosen: Vec<&Point> = (0..group.len()).filter(|i| is_kept(*i)).map(|i| group[i]).collect();
            let weight = group.len() as f64 / chosen.len().max(1) as f64;
            for point in chosen {
                let instrument = || campaign.file.instrument.standard_uncertainties_mm(point.xyz_mm);
                let u_mm = point.standard_uncertainty_mm.unwrap_or_else(instrument);
                basis.points.push(point.xyz_mm);
                basis.weights.push(weight);
                basis.u_mm.push(u_mm.map(|u| u / weight.sqrt()));
                kept.push(&*point.label);
            }
        }
        let of = |label: &str| (0..kept.len()).filter(|i| matches_pattern(label, kept[*i])).collect::<Vec<_>>();
        let all_of = |labels: &[Spanned<String>]| labels.iter().flat_map(|l| of(l.get_ref())).collect();
        basis.features = elements.iter().map(|(name, (element, l))| ((*name).clone(), *element, all_of(l))).collect();
        basis.places = named.iter().filter(|name| is_label(name)).map(|name| ((*name).to_owned(), of(name))).collect();
        basis
    }

    fn geometry(&self) -> Result<Geometry> {
        let mut geometry = Geometry::default();
        for (name, element, of) in &self.features {
            let points: Vec<Vector> = of.iter().map(|i| self.points[*i]).collect();
            let weights: Vec<f64> = of.iter().map(|i| self.weights[*i]).collect();
            let weights = weights.iter().any(|w| *w != 1.0).then_some(weights);
            let fit = fitted(
                *element,
                &points,
                &etalon_fit::FitSettings { weights: weights.as_deref(), ..Default::default() },
            )?;
            geometry.features.insert(name.clone(), (fit.geometry.point_mm, fit.geometry.direction.unwrap_or_default()));
        }
        for (name, of) in &self.places {
            let total: f64 = of.iter().map(|i| self.weights[*i]).sum();
            let sum =
                of.iter().fold([0.0; 3], |sum, i| [0, 1, 2].map(|k| sum[k] + self.weights[*i] * self.points[*i][k]));
            if !of.is_empty() {
                geometry.places.insert(name.clone(), sum.map(|s| s / total));
            }
        }
        Ok(geometry)
    }
}

/// Shift and small rotation of a pose near identity.
fn twist(pose: &Pose) -> [f64; 6] {
    let (t, r) = (pose.translation_mm, pose.rotation);
    [t[0], t[1], t[2], 0.5 * (r[2][1] - r[1][2]), 0.5 * (r[0][2] - r[2][0]), 0.5 * (r[1][0] - r[0][1])]
}

fn combined(a: &[[f64; 6]; 6], b: &[[f64; 6]; 6], of: impl Fn(f64, f64) -> f64) -> [[f64; 6]; 6] {
    std::array::from_fn(|i| std::array::from_fn(|j| of(a[i][j], b[i][j])))
}

fn add_outer(sum: &mut [[f64; 6]; 6], z: &[f64; 6]) {
    for (row, a) in sum.iter_mut().zip(z) {
        row.iter_mut().zip(z).for_each(|(s, b)| *s += a * b);
    }
}

/// Covariance of a best fit to points at `places`, each with the standard uncertainty `u_mm` of its
/// coordinates.
fn rigid_covariance(places: &[Vector], u_mm: &[f64]) -> Option<[[f64; 6]; 6]> {
    let mut normal = nalgebra::Matrix6::<f64>::zeros();
    for (p, u_mm) in places.iter().zip(u_mm) {
        let rows = nalgebra::Matrix3x6::new(
            1.0, 0.0, 0.0, 0.0, p[2], -p[1], 0.0, 1.0, 0.0, -p[2], 0.0, p[0], 0.0, 0.0, 1.0, p[1], -p[0], 0.0,
        );
        normal += rows.transpose() * rows / (u_mm * u_mm);
    }
    let inverse = normal.try_inverse()?;
    Some(std::array::from_fn(|i| std::array::from_fn(|j| inverse[(i, j)])))
}

/// Covariance of a frame with its origin at the first of `places`, x towards the second and the
/// third in the xy plane.
fn three_two_one_covariance(places: &[Vector], u_mm: &[f64]) -> Option<[[f64; 6]; 6]> {
    let ([_, second, third, ..], [_, _, _, ..]) = (places, u_mm) else { return None };
    let mut sum = [[0.0; 6]; 6];
    for (k, axis) in (0..3).flat_map(|k| (0..3).map(move |axis| (k, axis))) {
        let mut moved = [[0.0; 3]; 3];
        moved[k][axis] = u_mm[k];
        let off = |k: usize, axis: usize| moved[k][axis] - moved[0][axis];
        let (about_y, about_z) = (-off(1, 2) / second[0], off(1, 1) / second[0]);
        let about_x = (off(2, 2) + about_y * third[0]) / third[1];
        let [x, y, z] = moved[0];
        add_outer(&mut sum, &[x, y, z, about_x, about_y, about_z]);
    }
    Some(sum)
}

/// Mean height of the targets in the world (mm); 0 without targets.
pub(crate) fn target_height_mm(world: &WorldFrame, points: &[Point]) -> f64 {
    let Some(frame) = world.poses.first() else { return 0.0 };
    let world_T_export = frame.export_T_world.inverse();
    let moving = points.iter().filter(|p| p.pose.is_some() && p.target.is_some());
    let heights: Vec<Vector> = moving.map(|p| world_T_export.apply(p.xyz_mm)).collect();
    centroid(&heights).map_or(0.0, |middle| middle[2])
}

/// Moves the covariance of the frame of a planar robot to the mean height of its targets, where a
/// tilt acts as a shift.
fn at_height(world: &mut WorldFrame, points: &[Point]) {
    let height_mm = target_height_mm(world, points);
    // shift in x and y at this height, and the turn about z
    let mut planar = [[0.0; 6]; 6];
    planar[0][0] = 1.0;
    planar[0][4] = height_mm;
    planar[1][1] = 1.0;
    planar[1][3] = -height_mm;
    planar[5][5] = 1.0;
    let product = |a: &[[f64; 6]; 6], b: &[[f64; 6]; 6]| -> [[f64; 6]; 6] {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| a[i][k] * b[j][k]).sum()))
    };
    let covariances = world.poses.iter_mut().map(|frame| &mut frame.covariance).chain([&mut world.common_covariance]);
    for covariance in covariances.flatten() {
        *covariance = product(&product(&planar, covariance), &planar);
    }
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

/// Frame defined by targets: their mean positions define it, and each pose is the best fit to these
/// positions.
fn from_targets(campaign: &Campaign, points: &[Point], targets: &[Spanned<String>], each: bool) -> Result<WorldFrame> {
    let names: Vec<&str> = targets.iter().map(|t| t.get_ref().as_str()).collect();
    if names.len() < 3 {
        return Err(error!("frame-few-targets", count = names.len()).at(campaign.world_place()).into());
    }
    let u_at = |p: &Vector| campaign.file.instrument.standard_uncertainty_at_mm(*p);
    let mut u_of = Vec::new();
    let seen = if each {
        measured(points, &names)
    } else {
        // measured once or often, with or without a pose: the mean of all points of that name
        let bearing = |name: &&str| -> Vec<Vector> {
            let bears = |p: &&Point| p.target.as_deref() == Some(*name) || *p.label == **name;
            points.iter().filter(bears).map(|p| p.xyz_mm).collect()
        };
        let all: Vec<Vec<Vector>> = names.iter().map(bearing).collect();
        let mean = |of: &Vec<Vector>| of.first().map_or(0.0, u_at) / (of.len().max(1) as f64).sqrt();
        u_of = all.iter().map(mean).collect();
        BTreeMap::from([((PoseName::default(), 0), all.iter().map(|of| centroid(of)).collect())])
    };
    let whole: BTreeMap<Key, Vec<Vector>> =
        seen.into_iter().filter_map(|(key, places)| Some((key, places.into_iter().collect::<Option<_>>()?))).collect();
    let local = |p: &Vec<Vector>| {
        let world = three_two_one(p)?.inverse();
        Some(p.iter().map(|p| world.apply(*p)).collect::<Vec<_>>())
    };
    let locals: Vec<Vec<Vector>> = whole.values().filter_map(local).collect();
    if locals.is_empty() {
        return Err(error!("frame-never-complete", targets = names).at(campaign.world_place()).into());
    }
    let mean = |k: usize| centroid(&locals.iter().map(|l| l[k]).collect::<Vec<_>>());
    let reference: Vec<Vector> = (0..names.len()).filter_map(mean).collect();
    if let (true, Some(places)) = (each, whole.values().next()) {
        u_of = places.iter().map(u_at).collect();
    }
    // Each pose is a best fit to the mean places, which define the world by its origin and axes.
    // Errors of the mean places are common to all poses and independent of the errors of the fits:
    // the covariance of that definition minus the covariance of a fit.
    let fitted = rigid_covariance(&reference, &u_of);
    let excess = three_two_one_covariance(&reference, &u_of).zip(fitted).map(|(defined, fitted)| {
        let share = 1.0 / locals.len() as f64;
        combined(&defined, &fitted, |defined, fitted| share * (defined - fitted))
    });
    let covariance = fitted.zip(excess).map(|(fitted, excess)| combined(&fitted, &excess, |a, b| a + b));
    let (mut poses, mut squares, mut largest) = (Vec::new(), 0.0, 0.0f64);
    for (&(pose, cycle), places) in &whole {
        let fitted = etalon_fit::rigid(&reference, places)?;
        for r in fitted.distances_mm() {
            squares += r * r;
            largest = largest.max(r);
        }
        let (pose, cycle) = if each { (Some(pose), Some(cycle)) } else { (None, None) };
        poses.push(FramePose { pose, cycle, export_T_world: fitted.to_T_from, covariance });
    }
    let definition = match each {
        true => phrase!("frame-from-targets-each", targets = names),
        false => phrase!("frame-from-targets", targets = names),
    };
    // targets measured once define the positions that they are compared with
    let is_compared = poses.len() > 1;
    let rms = (squares / (poses.len() * names.len()) as f64).sqrt();
    Ok(WorldFrame {
        definition: definition.into(),
        planar: false,
        poses,
        common_covariance: excess.filter(|_| each),
        rms_mm: is_compared.then_some(rms),
        max_mm: is_compared.then_some(largest),
        reference_mm: reference,
    })
}

/// Positions of the named targets, by pose and cycle.
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
