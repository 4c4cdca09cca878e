//! Starting values of sockets, fixed points, planes and orientations of bodies, each in closed form
//! at the current base and joints.

use crate::model::kinds::{
    Condition, Contact, Kind, fit_surfaces, locate_contacts, locate_stations, mount, onto, places, point, span,
    trilaterate_points,
};
use crate::{Observation, Settings};
use etalon_base::pose::Vector;
use etalon_robots::FreeBase;
use std::collections::{BTreeMap, BTreeSet};

/// Writes starting values of the free (`wanted`) fixtures, and of free targets without measured
/// positions; also of the base, if only known positions of sockets determine it.
pub(crate) fn place_fixtures(
    arm: &dyn FreeBase,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    values: &mut [f64],
) {
    let seen = observations.iter().flat_map(|o| (0..o.targets.len()).filter(|&k| o.targets[k].is_some())).collect();
    place_seen(arm, &seen, settings, wanted, values);
}

/// [`place_fixtures`] with the measured targets `seen` at their positions.
pub(crate) fn place_seen(
    arm: &dyn FreeBase,
    seen: &BTreeSet<usize>,
    settings: &Settings,
    wanted: &[usize],
    values: &mut [f64],
) {
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
    locate_contacts(arm, &contacts, &unknown.into_iter().collect::<Vec<_>>(), values);
    if free_base {
        move_base(&known, values);
    }
    locate_stations(arm, settings, seen, wanted, values);
    mount(arm, &settings.conditions, wanted, values);
    let is_unknown = |first| wanted.contains(&first) && !known.contains_key(&first) && !sockets.contains(&first);
    trilaterate_points(arm, &settings.conditions, is_unknown, values);
    span(arm, &settings.conditions, |length| wanted.contains(&length), values);
    fit_surfaces(arm, settings, wanted, values);
}

/// The base, initially at the world's origin, for which the sockets are at their known positions.
fn move_base(known: &BTreeMap<usize, Vector>, values: &mut [f64]) {
    let pairs: Vec<(Vector, Vector)> = known.iter().map(|(&first, &place)| (point(values, first), place)).collect();
    let Some(moved) = onto(&pairs) else { return };
    values[..3].copy_from_slice(&moved.translation_mm);
    values[3..6].copy_from_slice(&moved.rotation_vector_rad());
    for (&first, place) in known {
        values[first..first + 3].copy_from_slice(place);
    }
}
