//! Starting values of what conditions refer to: sockets, fixed points, planes and the orientations of bodies, each in closed form
//! at the present base and joints.

use super::condition::{Condition, Kind, Known, point, station_pose};
use super::surface::Surface;
use super::{Observation, Settings};
use etalon_base::pose::{Pose, Vector, centroid, dot, minus};
use etalon_fit::rotation_onto;
use etalon_math::Factor;
use etalon_math::statistics::mean;
use etalon_robots::{FreeBase, Robot};
use std::collections::{BTreeMap, BTreeSet};

/// Weight that brings the shortest solution where several are equally good, of rows of size one.
const SHORTEST: f64 = 1e-6;

/// Writes starting values of the fixtures and of the targets that no position shows, where they are `wanted`; of the base too, where
/// only known places of sockets show it.
pub(super) fn place_fixtures(
    arm: &dyn FreeBase,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    values: &mut [f64],
) {
    let seen: BTreeSet<usize> =
        observations.iter().flat_map(|o| (0..o.targets.len()).filter(|&k| o.targets[k].is_some())).collect();
    let known = places(&settings.known);
    let free_base = seen.is_empty() && !known.is_empty() && (0..6).all(|i| wanted.contains(&i));
    if free_base {
        values[..6].fill(0.0);
    }
    for (&first, place_mm) in known.iter().filter(|_| !free_base) {
        values[first..first + 3].copy_from_slice(place_mm);
    }
    let contacts = |c: &&Condition| matches!(c.kind, Kind::Contact { .. });
    let contacts: Vec<&Condition> = settings.conditions.iter().filter(contacts).collect();
    let unseen = |&&first: &&usize| wanted.contains(&first);
    let targets: BTreeSet<usize> =
        contacts.iter().filter(|c| !seen.contains(&c.target)).map(|c| arm.target_place(c.target)).collect();
    let socket = |c: &&Condition| match c.kind {
        Kind::Contact { socket } => Some(socket),
        _ => None,
    };
    let sockets: BTreeSet<usize> = contacts.iter().filter_map(socket).collect();
    let to_find = sockets.iter().filter(|socket| free_base || !known.contains_key(socket));
    let unknown: BTreeSet<usize> = targets.iter().chain(to_find).filter(unseen).copied().collect();
    meet(arm, &contacts, &unknown.into_iter().collect::<Vec<_>>(), values);
    if free_base {
        move_base(&known, values);
    }
    stand(arm, settings, &seen, wanted, values);
    mount(arm, &settings.conditions, wanted, values);
    let is_unknown = |first| wanted.contains(&first) && !known.contains_key(&first) && !sockets.contains(&first);
    reach(arm, &settings.conditions, is_unknown, values);
    lay(arm, settings, wanted, values);
}

/// Known places, by the first parameter of their point.
fn places(known: &[Known]) -> BTreeMap<usize, Vector> {
    let place = |k: &Known| match *k {
        Known::Place { point, place_mm, .. } => Some((point, place_mm)),
        Known::Distance { .. } | Known::Seen { .. } | Known::On { .. } | Known::Length { .. } => None,
    };
    known.iter().filter_map(place).collect()
}

/// Targets and sockets, by their first parameters, that bring contacts together: linear in both at given joints.
fn meet(arm: &dyn FreeBase, contacts: &[&Condition], unknown: &[usize], values: &mut [f64]) {
    if unknown.is_empty() {
        return;
    }
    let column = |first: usize| unknown.iter().position(|&u| u == first);
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for c in contacts {
        let Kind::Contact { socket } = c.kind else { continue };
        let (flange, target) = (arm.flange(values, &c.joints), arm.target_place(c.target));
        for i in 0..3 {
            let mut row = vec![0.0; 3 * unknown.len()];
            let mut rest = -flange.translation_mm[i];
            match column(target) {
                Some(k) => row[3 * k..][..3].copy_from_slice(&flange.rotation[i]),
                None => rest -= dot(flange.rotation[i], point(values, target)),
            }
            match column(socket) {
                Some(k) => row[3 * k + i] = -1.0,
                None => rest += values[socket + i],
            }
            a.extend(row);
            b.push(rest);
        }
    }
    let factor = Factor::new(&a, &b, &vec![1.0; 3 * unknown.len()]);
    let Some(found) = factor.damped(SHORTEST).solve() else { return };
    for (k, &first) in unknown.iter().enumerate() {
        values[first..first + 3].copy_from_slice(&found[3 * k..][..3]);
    }
}

/// The base, which is at the world's origin, where the sockets come to their known places.
fn move_base(known: &BTreeMap<usize, Vector>, values: &mut [f64]) {
    let pairs: Vec<(Vector, Vector)> = known.iter().map(|(&first, &place)| (point(values, first), place)).collect();
    let Some(moved) = onto(&pairs) else { return };
    values[..3].copy_from_slice(&moved.translation_mm);
    values[3..6].copy_from_slice(&moved.rotation_vector_rad());
    for (&first, place) in known {
        values[first..first + 3].copy_from_slice(place);
    }
}

/// Stations where what they see of targets and points comes to where the world has it; then targets and points that only they see.
fn stand(arm: &dyn FreeBase, settings: &Settings, seen: &BTreeSet<usize>, wanted: &[usize], values: &mut [f64]) {
    let known = places(&settings.known);
    let mut stations: BTreeMap<usize, Vec<(Vector, Vector)>> = BTreeMap::new();
    for c in settings.conditions.iter().filter(|c| seen.contains(&c.target)) {
        if let Kind::Seen { station, at_mm } = c.kind {
            stations.entry(station).or_default().push((at_mm, place(arm, c, values)));
        }
    }
    for k in &settings.known {
        if let Known::Seen { station, point, at_mm, .. } = *k
            && let Some(place) = known.get(&point)
        {
            stations.entry(station).or_default().push((at_mm, *place));
        }
    }
    for (first, pairs) in stations.into_iter().filter(|s| wanted.contains(&s.0)) {
        let Some(pose) = onto(&pairs) else { continue };
        values[first..first + 3].copy_from_slice(&pose.translation_mm);
        values[first + 3..first + 6].copy_from_slice(&pose.rotation_vector_rad());
    }
    let mut alone: BTreeMap<usize, Vec<Vector>> = BTreeMap::new();
    for c in settings.conditions.iter().filter(|c| !seen.contains(&c.target)) {
        if let Kind::Seen { station, at_mm } = c.kind {
            let at = arm.flange(values, &c.joints).inverse().apply(station_pose(values, station).apply(at_mm));
            alone.entry(arm.target_place(c.target)).or_default().push(at);
        }
    }
    for k in &settings.known {
        if let Known::Seen { station, point, at_mm, .. } = *k
            && !known.contains_key(&point)
        {
            alone.entry(point).or_default().push(station_pose(values, station).apply(at_mm));
        }
    }
    for (first, all) in alone.into_iter().filter(|a| wanted.contains(&a.0)) {
        values[first..first + 3].copy_from_slice(&centroid(&all).unwrap_or_default());
    }
}

/// The motion that brings the first of each pair to the second, by least squares.
fn onto(pairs: &[(Vector, Vector)]) -> Option<Pose> {
    let (from, to): (Vec<Vector>, Vec<Vector>) = pairs.iter().copied().unzip();
    let (here, there) = (centroid(&from)?, centroid(&to)?);
    let rotation = rotation_onto(pairs.iter().map(|(p, q)| (minus(*p, here), minus(*q, there))));
    let turn = Pose { rotation, translation_mm: [0.0; 3] };
    Some(Pose { translation_mm: minus(there, turn.rotate(here)), ..turn })
}

/// Orientations of bodies on the flange: the mean of what their observed orientations show.
fn mount(arm: &dyn FreeBase, conditions: &[Condition], wanted: &[usize], values: &mut [f64]) {
    let mut bodies: BTreeMap<usize, Vec<(Vector, Vector)>> = BTreeMap::new();
    for c in conditions {
        if let Kind::Orientation { world_T_body, mounting } = c.kind {
            let body = arm.flange(values, &c.joints).inverse().then(&world_T_body);
            let axes = (0..3).map(|k| (Pose::identity().axis(k), body.axis(k)));
            bodies.entry(mounting).or_default().extend(axes);
        }
    }
    for (mounting, all) in bodies.into_iter().filter(|body| wanted.contains(&body.0)) {
        // the least sum of squares of the chordal distances (Moakher 2002)
        let mean = Pose { rotation: rotation_onto(all.into_iter()), translation_mm: [0.0; 3] };
        values[mounting..mounting + 3].copy_from_slice(&mean.rotation_vector_rad());
    }
}

/// Root mean square angle that observed orientations are from those of the robot with `values`, with their bodies mounted where they
/// explain these best, rad; not a number where there are none.
pub fn mounted_misfit_rad(robot: &dyn Robot, conditions: &[Condition], values: &[f64]) -> f64 {
    let Some(arm) = robot.free_base() else { return f64::NAN };
    let mut values = values.to_vec();
    let all: Vec<usize> = (0..values.len()).collect();
    mount(arm, conditions, &all, &mut values);
    let squares = conditions.iter().map(|c| dot(c.error(robot, &values), c.error(robot, &values)));
    (squares.sum::<f64>() / conditions.len() as f64).sqrt()
}

/// Points from their distances to targets: differences of squares are linear in the point.
fn reach(arm: &dyn FreeBase, conditions: &[Condition], is_unknown: impl Fn(usize) -> bool, values: &mut [f64]) {
    let mut points: BTreeMap<usize, Vec<(Vector, f64)>> = BTreeMap::new();
    for c in conditions {
        if let Kind::Distance { to, distance_mm } = c.kind {
            points.entry(to).or_default().push((place(arm, c, values), distance_mm));
        }
    }
    for (to, all) in points.into_iter().filter(|p| is_unknown(p.0)) {
        let places: Vec<Vector> = all.iter().map(|p| p.0).collect();
        let Some(centre) = centroid(&places) else { continue };
        let square = |(p, d): &(Vector, f64)| {
            let p = minus(*p, centre);
            0.5 * (dot(p, p) - d * d)
        };
        let mean = mean(all.iter().map(square));
        let rows: Vec<f64> = places.iter().flat_map(|p| minus(*p, centre)).collect();
        let right: Vec<f64> = all.iter().map(|p| square(p) - mean).collect();
        if let Some(found) = Factor::new(&rows, &right, &[1.0; 3]).damped(SHORTEST).solve() {
            (0..3).for_each(|i| values[to + i] = centre[i] + found[i]);
        }
    }
}

/// Planes, lines and spheres through the targets that touch them, and the places that are known to be on them.
fn lay(arm: &dyn FreeBase, settings: &Settings, wanted: &[usize], values: &mut [f64]) {
    type Touches = Vec<(Vector, f64)>;
    let mut touched: Vec<(Surface, [usize; 4], Touches)> = Vec::new();
    let touching = |c: &Condition| match c.kind {
        Kind::On { surface, unknowns, offset_mm } => Some((surface, unknowns, place(arm, c, values), offset_mm)),
        _ => None,
    };
    let known = |k: &Known| match *k {
        Known::On { surface, unknowns, place_mm, .. } => Some((surface, unknowns, place_mm, 0.0)),
        _ => None,
    };
    let all = settings.conditions.iter().filter_map(touching).chain(settings.known.iter().filter_map(known));
    for (surface, unknowns, at, offset_mm) in all.filter(|touch| wanted.contains(&touch.1[0])) {
        match touched.iter_mut().find(|other| other.1 == unknowns) {
            Some(other) => other.2.push((at, offset_mm)),
            None => touched.push((surface, unknowns, vec![(at, offset_mm)])),
        }
    }
    let solved =
        |rows: Vec<f64>, right: Vec<f64>, n: usize| Factor::new(&rows, &right, &vec![1.0; n]).damped(SHORTEST).solve();
    for (surface, unknowns, at) in touched {
        let found = match surface {
            Surface::Plane { axis } => {
                let rows = at.iter().flat_map(|(p, _)| [p[(axis + 1) % 3], p[(axis + 2) % 3], 1.0]).collect();
                let found = solved(rows, at.iter().map(|(p, offset)| p[axis] - offset).collect(), 3);
                found.map(|f| vec![f[0].atan(), f[1].atan(), f[2]])
            }
            Surface::Line { axis } => {
                let of = |k: usize| {
                    let rows = at.iter().flat_map(|(p, _)| [p[axis], 1.0]).collect();
                    solved(rows, at.iter().map(|(p, _)| p[(axis + k) % 3]).collect(), 2)
                };
                of(1).zip(of(2)).map(|(i, j)| vec![i[0].atan(), j[0].atan(), i[1], j[1]])
            }
            // of a sphere |p|² is linear in the centre, and in |c|² − r²
            Surface::Sphere => {
                let centre = centroid(&at.iter().map(|(p, _)| *p).collect::<Vec<_>>()).unwrap_or_default();
                let off: Vec<Vector> = at.iter().map(|(p, _)| minus(*p, centre)).collect();
                let rows = off.iter().flat_map(|p| [p[0], p[1], p[2], 1.0]).collect();
                let offset = mean(at.iter().map(|(_, offset)| *offset));
                solved(rows, off.iter().map(|p| 0.5 * dot(*p, *p)).collect(), 4).map(|f| {
                    let radius = (2.0 * f[3] + f[0] * f[0] + f[1] * f[1] + f[2] * f[2]).max(0.0).sqrt();
                    vec![centre[0] + f[0], centre[1] + f[1], centre[2] + f[2], radius - offset]
                })
            }
        };
        let known = |i: usize| {
            settings.known.iter().any(|k| matches!(k, Known::Place { point, .. } if (*point..point + 3).contains(&i)))
        };
        for (&i, value) in unknowns.iter().zip(found.into_iter().flatten()).filter(|(i, _)| !known(**i)) {
            values[i] = value;
        }
    }
}

/// Where the target of a condition is.
fn place(arm: &dyn FreeBase, c: &Condition, values: &[f64]) -> Vector {
    arm.flange(values, &c.joints).apply(point(values, arm.target_place(c.target)))
}
