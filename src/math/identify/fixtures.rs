//! Starting values of what conditions refer to: sockets, fixed points, planes and the orientations of bodies, each in closed form
//! at the present base and joints.

use super::condition::{Condition, Kind, Known, point};
use super::{Observation, Settings};
use crate::base::pose::{Pose, Vector, centroid, dot, minus};
use crate::math::fit::rotation_onto;
use crate::math::robots::FreeBase;
use crate::math::solve::Factor;
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
        values[..3].fill(0.0);
        values[3..6].copy_from_slice(&arm.base_angles(&Pose::identity()));
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
        move_base(arm, &known, values);
    }
    mount(arm, &settings.conditions, wanted, values);
    let is_unknown = |first| wanted.contains(&first) && !known.contains_key(&first) && !sockets.contains(&first);
    reach(arm, &settings.conditions, is_unknown, values);
    lay(arm, &settings.conditions, wanted, values);
}

/// Known places, by the first parameter of their point.
fn places(known: &[Known]) -> BTreeMap<usize, Vector> {
    let place = |k: &Known| match *k {
        Known::Place { point, place_mm, .. } => Some((point, place_mm)),
        Known::Distance { .. } => None,
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
fn move_base(arm: &dyn FreeBase, known: &BTreeMap<usize, Vector>, values: &mut [f64]) {
    let pairs: Vec<(Vector, Vector)> = known.iter().map(|(&first, &place)| (point(values, first), place)).collect();
    let (from, to): (Vec<Vector>, Vec<Vector>) = pairs.iter().copied().unzip();
    let (Some(here), Some(there)) = (centroid(&from), centroid(&to)) else { return };
    let rotation = rotation_onto(pairs.iter().map(|(p, q)| (minus(*p, here), minus(*q, there))));
    let turn = Pose { rotation, translation_mm: [0.0; 3] };
    let moved = Pose { translation_mm: minus(there, turn.rotate(here)), ..turn };
    values[..3].copy_from_slice(&moved.translation_mm);
    values[3..6].copy_from_slice(&arm.base_angles(&moved));
    for (&first, place) in known {
        values[first..first + 3].copy_from_slice(place);
    }
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
        let mean = all.iter().map(square).sum::<f64>() / all.len() as f64;
        let rows: Vec<f64> = places.iter().flat_map(|p| minus(*p, centre)).collect();
        let right: Vec<f64> = all.iter().map(|p| square(p) - mean).collect();
        if let Some(found) = Factor::new(&rows, &right, &[1.0; 3]).damped(SHORTEST).solve() {
            (0..3).for_each(|i| values[to + i] = centre[i] + found[i]);
        }
    }
}

/// Planes through the targets that touch them.
fn lay(arm: &dyn FreeBase, conditions: &[Condition], wanted: &[usize], values: &mut [f64]) {
    let mut planes: BTreeMap<(usize, usize), Vec<Vector>> = BTreeMap::new();
    for c in conditions {
        if let Kind::Plane { plane, axis, offset_mm } = c.kind {
            let mut touched = place(arm, c, values);
            touched[axis] -= offset_mm;
            planes.entry((plane, axis)).or_default().push(touched);
        }
    }
    for ((first, axis), all) in planes.into_iter().filter(|plane| wanted.contains(&plane.0.0)) {
        let rows: Vec<f64> = all.iter().flat_map(|p| [p[(axis + 1) % 3], p[(axis + 2) % 3], 1.0]).collect();
        let right: Vec<f64> = all.iter().map(|p| p[axis]).collect();
        if let Some(found) = Factor::new(&rows, &right, &[1.0; 3]).damped(SHORTEST).solve() {
            values[first..first + 3].copy_from_slice(&[found[0].atan(), found[1].atan(), found[2]]);
        }
    }
}

/// Where the target of a condition is.
fn place(arm: &dyn FreeBase, c: &Condition, values: &[f64]) -> Vector {
    arm.flange(values, &c.joints).apply(point(values, arm.target_place(c.target)))
}
