//! Table of the changes of a set-up that a judgement compares: each is a mistake that people make,
//! and the data without it. Every change applies to observations of all kinds.

use super::data::Data;
use crate::Kind;
use crate::warning::Origin;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector};
use etalon_robots::{Joint, Quantity, Robot};
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

const MM_PER_INCH: f64 = 25.4;
/// 400 gon are a turn.
const DEG_PER_GON: f64 = 0.9;
/// Factors between units of length, with the mistake that each corrects.
const LENGTHS: [(f64, &str); 4] =
    [(1000.0, "m-mm"), (0.001, "mm-m"), (MM_PER_INCH, "inch-mm"), (1.0 / MM_PER_INCH, "mm-inch")];
/// Minimum number of readings of a target whose unit is questioned: its place has three unknown
/// coordinates, which fewer readings fit in any unit.
const FEWEST_READINGS: usize = 4;
/// Maximum number of targets, or groups of targets, whose unit or exchange is questioned, and of
/// joints whose columns are shifted.
const MOST_GROUPS: usize = 12;
/// Minimum number of joints whose columns are shifted: two are swapped.
const FEWEST_OF_BLOCK: usize = 3;

/// Other orientations that the rows of a table may contain.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The way of reading them: "angles in the order `zyx`".
    pub what: Phrase,
    /// Orientation of each condition; `None` where it gives none.
    pub bodies: Vec<Option<Pose>>,
}

/// A change, and the data with it.
pub(crate) struct Change {
    /// The mistake: "`q7` reversed".
    pub what: Phrase,
    /// Wrong part of the set-up.
    pub origin: Origin,
    /// The data without it.
    pub data: Data,
    /// `true` if the base of a planar robot may be beyond its tolerances without the mistake.
    pub anywhere: bool,
    /// Place among the changes that the data do not show.
    pub listing: Listing,
}

/// Place of a change in the list of changes that the data do not show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Listing {
    /// Before others.
    First,
    /// After others: zeros absorb most offsets.
    Last,
    /// Not listed: a wrong unit of one joint is detected like its sign.
    Never,
}

/// Collects the changes of some data.
struct Table<'a> {
    robot: &'a dyn Robot,
    data: &'a Data,
    all: Vec<Change>,
}

/// All changes of the data, one at a time.
pub(crate) fn changes(robot: &dyn Robot, data: &Data, readings: &[Reading]) -> Vec<Change> {
    let mut table = Table { robot, data, all: Vec::new() };
    table.joints();
    // joints that hardly move leave every length that is not measured as it is
    if data.has_lengths() {
        table.units_of_joints();
    }
    table.points();
    table.units();
    table.targets();
    table.fixtures();
    table.inverse_poses();
    table.orientations(readings);
    table.all
}

/// Every pair of joints with the opposite sign: the most frequent pair of mistakes.
pub(crate) fn reversed_pairs(robot: &dyn Robot, data: &Data) -> Vec<Change> {
    let mut table = Table { robot, data, all: Vec::new() };
    let n = robot.joints().len().min(MOST_GROUPS);
    for (i, j) in (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))) {
        let [first, second] = [i, j].map(|joint| phrase!("slip-reversed", joint = table.joint(joint)));
        let both = |q: &mut [f64]| [i, j].iter().for_each(|&joint| q[joint] = -q[joint]);
        table.add(phrase!("slip-pair", first, second), |data| data.change_joints(&both));
    }
    table.all
}

impl Table<'_> {
    fn add(&mut self, what: Phrase, how: impl Fn(&mut Data)) {
        let mut data = self.data.clone();
        how(&mut data);
        self.all.push(Change { what, origin: Origin::Named, data, anywhere: false, listing: Listing::First });
    }

    fn joint(&self, i: usize) -> String {
        format!("`{}`", self.robot.joints()[i].name)
    }

    /// Signs, order and offsets of joints.
    fn joints(&mut self) {
        let joints = self.robot.joints();
        let n = joints.len();
        let mut change = |what: Phrase, how: &dyn Fn(&mut [f64])| self.add(what, |data| data.change_joints(how));
        let name = |i: usize| format!("`{}`", joints[i].name);
        for i in 0..n {
            change(phrase!("slip-reversed", joint = name(i)), &|q| q[i] = -q[i]);
            for j in (i + 1..n).filter(|&j| joints[i].quantity == joints[j].quantity) {
                change(phrase!("slip-exchanged", first = name(i), second = name(j)), &|q| q.swap(i, j));
            }
        }
        if n > 2 && joints.iter().all(|j| j.quantity == joints[0].quantity) {
            change(phrase!("slip-joint-order", order = "reversed"), &|q| q[..n].reverse());
            change(phrase!("slip-joint-order", order = "left"), &|q| q[..n].rotate_left(1));
            change(phrase!("slip-joint-order", order = "right"), &|q| q[..n].rotate_right(1));
        }
        let added = self.all.len();
        self.blocks();
        self.list(added, Listing::Never);
        let first = self.all.len();
        let mut change = |what: Phrase, how: &dyn Fn(&mut [f64])| self.add(what, |data| data.change_joints(how));
        for i in (0..n).filter(|&i| joints[i].quantity == Quantity::Angle) {
            for (offset, degrees) in [(FRAC_PI_2, "90"), (-FRAC_PI_2, "-90"), (2.0 * FRAC_PI_2, "180")] {
                change(phrase!("slip-offset", degrees, joint = name(i)), &|q| q[i] += offset);
            }
        }
        self.list(first, Listing::Last);
    }

    /// Columns of some neighbouring joints, shifted by one position among themselves.
    fn blocks(&mut self) {
        let joints = self.robot.joints();
        let n = joints.len().min(MOST_GROUPS);
        let blocks = (0..n).flat_map(|first| (first + FEWEST_OF_BLOCK - 1..n).map(move |last| first..last + 1));
        let is_block = |block: &Range<usize>| {
            let is_alike = |joint: &Joint| joint.quantity == joints[block.start].quantity;
            block.len() < joints.len() && joints[block.clone()].iter().all(is_alike)
        };
        for block in blocks.filter(is_block) {
            let (first, last) = (self.joint(block.start), self.joint(block.end - 1));
            for (order, by) in [("left", 1), ("right", block.len() - 1)] {
                let what = phrase!("slip-joint-block", first = first.clone(), last = last.clone(), order);
                self.add(what, |data| data.change_joints(&|q| q[block.clone()].rotate_left(by)));
            }
        }
    }

    /// Lists the changes from `first` on elsewhere.
    fn list(&mut self, first: usize, listing: Listing) {
        self.all[first..].iter_mut().for_each(|change| change.listing = listing);
    }

    /// Units of all joints of a kind, and of single joints.
    fn units_of_joints(&mut self) {
        let joints = self.robot.joints();
        let n = joints.len();
        let rad = 1f64.to_degrees();
        let first = self.all.len();
        for quantity in [Quantity::Angle, Quantity::Length] {
            let alike: Vec<usize> = (0..n).filter(|&i| joints[i].quantity == quantity).collect();
            let factors: &[(f64, &str)] = match quantity {
                Quantity::Angle => &[
                    (rad, "rad-deg"),
                    (1.0 / rad, "deg-rad"),
                    (DEG_PER_GON, "gon-deg"),
                    (1.0 / DEG_PER_GON, "deg-gon"),
                ],
                _ => &LENGTHS,
            };
            let single = if alike.len() > 1 { alike.clone() } else { Vec::new() };
            for which in std::iter::once(alike).chain(single.into_iter().map(|i| vec![i])) {
                let quantity = match which[..] {
                    [] => continue,
                    [one] => self.joint(one),
                    _ if which.len() == n => "all-joints".to_owned(),
                    _ => "joints-of-kind".to_owned(),
                };
                for &(factor, slip) in factors {
                    let what = phrase!("slip-unit", quantity = quantity.clone(), slip);
                    self.add(what, |data| data.change_joints(&|q| which.iter().for_each(|&i| q[i] *= factor)));
                }
            }
        }
        self.list(first, Listing::Never);
    }

    /// Handedness and order of the coordinates of all points.
    fn points(&mut self) {
        let is_spatial = self.robot.dimension() == 3;
        let has_orientations = self.data.settings.conditions.iter().any(|c| c.kind.is_world_orientation());
        let is_tied = has_orientations || !self.data.settings.known.is_empty();
        let mut points = |change: &str, how: &dyn Fn(&mut Vector)| {
            self.add(phrase!("slip-points", change), |data| data.change_points(how));
        };
        if is_spatial {
            // alike for positions alone: the base turns
            let axes = if is_tied { 3 } else { 1 };
            (0..axes).for_each(|axis| points("mirrored", &|p| p[axis] = -p[axis]));
            if is_tied {
                [(0, 1), (0, 2), (1, 2)].iter().for_each(|&(i, j)| points("mirrored", &|p| p.swap(i, j)));
            }
        } else {
            points("exchanged", &|p| p.swap(0, 1));
            points("x", &|p| p[0] = -p[0]);
            points("y", &|p| p[1] = -p[1]);
        }
    }

    /// Unit of all lengths, and of points and distances alone; the frame may be in the right unit,
    /// and then lies elsewhere.
    fn units(&mut self) {
        if !self.data.has_lengths() {
            return;
        }
        let dimension = self.robot.dimension();
        let first = self.all.len();
        let has_both = self.data.has_positions() && self.data.has_distances();
        for (factor, slip) in LENGTHS {
            let of = |quantity: &str| phrase!("slip-unit", quantity, slip);
            if has_both {
                self.add(of("lengths"), |data| data.scale_lengths(dimension, factor));
                self.add(of("distances"), |data| data.scale_distances(factor));
                self.add(of("points"), |data| data.scale_places(dimension, factor));
            } else {
                self.add(of("points"), |data| data.scale_lengths(dimension, factor));
            }
        }
        for added in &mut self.all[first..] {
            (added.origin, added.anywhere) = (Origin::Unit, true);
        }
        self.units_of_targets();
    }

    /// Unit of each target alone, and of all targets but one: exports of a measuring system hold
    /// targets of their own.
    fn units_of_targets(&mut self) {
        let seen = self.data.readings(self.robot);
        let often: Vec<usize> = seen.iter().filter(|(_, count)| *count >= FEWEST_READINGS).map(|(k, _)| *k).collect();
        if seen.len() < 2 {
            return;
        }
        let mut groups: Vec<Vec<usize>> = often.iter().map(|&k| vec![k]).collect();
        if seen.len() > 2 && often.len() == seen.len() {
            groups.extend(often.iter().map(|k| often.iter().copied().filter(|other| other != k).collect()));
        }
        for group in groups.into_iter().take(MOST_GROUPS) {
            let names: Vec<String> = group.iter().map(|&k| format!("`{}`", self.robot.targets()[k])).collect();
            for (factor, slip) in LENGTHS {
                let (what, dimension) =
                    (phrase!("slip-unit-of-targets", targets = names.clone(), slip), self.robot.dimension());
                self.add(what, |data| data.scale_points(&group, dimension, factor));
            }
        }
    }

    /// Exchanged targets: in pairs for a robot with a place of its own, and the targets of two
    /// branches in their order. Targets of an arm on a free base are names for unknown places.
    fn targets(&mut self) {
        let links = self.robot.branches();
        let seen = self.data.readings(self.robot);
        let on = |branch: usize| -> Vec<usize> {
            seen.iter().map(|(k, _)| *k).filter(|&k| self.robot.target_branch(k) == branch).collect()
        };
        let mut exchanges: Vec<(Phrase, Vec<(usize, usize)>)> = Vec::new();
        for (a, b) in (0..links.len()).flat_map(|b| (0..b).map(move |a| (a, b))) {
            let (first, second) = (on(a), on(b));
            if !first.is_empty() && first.len() == second.len() {
                let [one, other] = [a, b].map(|branch| format!("`{}`", links[branch]));
                let what = phrase!("slip-branches-exchanged", first = one, second = other);
                exchanges.push((what, first.into_iter().zip(second).collect()));
            }
        }
        if self.robot.free_base().is_none() {
            // of many targets those with the most readings: the pairs of all grow with their square
            let mut often = seen.clone();
            often.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
            let mut some: Vec<usize> = often.into_iter().map(|(k, _)| k).take(MOST_GROUPS).collect();
            some.sort_unstable();
            let targets = self.robot.targets();
            for (i, j) in some.iter().enumerate().flat_map(|(at, &i)| some[at + 1..].iter().map(move |&j| (i, j))) {
                exchanges.push((phrase!("slip-targets", first = targets[i], second = targets[j]), vec![(i, j)]));
            }
        }
        for (what, pairs) in exchanges {
            self.add(what, |data| data.exchange_targets(&pairs));
        }
    }

    /// Swapped names of known points and surfaces of one kind.
    fn fixtures(&mut self) {
        let known: Vec<(usize, Kind)> = self.data.known_fixtures().into_iter().take(MOST_GROUPS).collect();
        let name = |(first, kind): &(usize, Kind)| {
            let name = self.robot.parameters().get(*first).map_or("", |p| p.name.as_str());
            let end = if matches!(kind, Kind::On(_)) { "_slope" } else { "_" };
            format!("`{}`", name.rsplit_once(end).map_or(name, |(name, _)| name))
        };
        let pairs =
            known.iter().enumerate().flat_map(|(at, one)| known[at + 1..].iter().map(move |other| (one, other)));
        let alike = pairs.filter(|(one, other)| std::mem::discriminant(&one.1) == std::mem::discriminant(&other.1));
        let exchanges: Vec<(Phrase, [Kind; 2])> = alike
            .map(|(one, other)| {
                (phrase!("slip-fixtures-exchanged", first = name(one), second = name(other)), [one.1, other.1])
            })
            .collect();
        for (what, [one, other]) in exchanges {
            self.add(what, |data| data.exchange_fixtures([&one, &other]));
        }
    }

    /// Measured poses the other way round: the instrument in the frame of the target.
    fn inverse_poses(&mut self) {
        if self.robot.dimension() == 3 && self.data.has_poses() {
            let first = self.all.len();
            self.add(phrase!("slip-poses-inverse"), Data::invert_poses);
            self.list(first, Listing::Never);
        }
    }

    /// Other ways of reading the given orientations.
    fn orientations(&mut self, readings: &[Reading]) {
        for reading in readings {
            self.add(reading.what.clone(), |data| {
                for (c, &number) in data.settings.conditions.iter_mut().zip(&data.numbers) {
                    if let Kind::Orientation(observed) = &mut c.kind
                        && let Some(Some(body)) = reading.bodies.get(number)
                    {
                        observed.frame_T_body = *body;
                    }
                }
            });
        }
    }
}
