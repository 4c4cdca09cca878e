//! Starting values of what conditions refer to: sockets, fixed points, planes and the orientations of bodies, each in closed form
//! at the present base and joints.

use super::kinds::{Condition, Contact, Kind, lay, meet, mount, point, reach, stand};
use super::known::Known;
use super::{Observation, Settings};
use etalon_base::pose::{Pose, Vector, centroid, minus};
use etalon_fit::rotation_onto;
use etalon_robots::FreeBase;
use std::collections::{BTreeMap, BTreeSet};

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
    let contacts = |c: &&Condition| matches!(c.kind, Kind::Contact(_));
    let contacts: Vec<&Condition> = settings.conditions.iter().filter(contacts).collect();
    let unseen = |&&first: &&usize| wanted.contains(&first);
    let targets: BTreeSet<usize> =
        contacts.iter().filter(|c| !seen.contains(&c.target)).map(|c| arm.target_place(c.target)).collect();
    let socket = |c: &&Condition| match c.kind {
        Kind::Contact(Contact { socket }) => Some(socket),
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
pub(super) fn places(known: &[Known]) -> BTreeMap<usize, Vector> {
    let place = |k: &Known| match *k {
        Known::Place { point, place_mm, .. } => Some((point, place_mm)),
        Known::Distance { .. } | Known::Seen { .. } | Known::On { .. } | Known::Length { .. } => None,
    };
    known.iter().filter_map(place).collect()
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

/// The motion that brings the first of each pair to the second, by least squares.
pub(super) fn onto(pairs: &[(Vector, Vector)]) -> Option<Pose> {
    let (from, to): (Vec<Vector>, Vec<Vector>) = pairs.iter().copied().unzip();
    let (here, there) = (centroid(&from)?, centroid(&to)?);
    let rotation = rotation_onto(pairs.iter().map(|(p, q)| (minus(*p, here), minus(*q, there))));
    let turn = Pose { rotation, translation_mm: [0.0; 3] };
    Some(Pose { translation_mm: minus(there, turn.rotate(here)), ..turn })
}
