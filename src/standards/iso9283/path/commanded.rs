//! Commanded path: a polyline through corners; a curve is given by as many points as it needs.

use crate::iso9283::statistics::sample::followed;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, dot, minus, norm, unit};

/// A path in space or in the plane, with the angles commanded along it.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandedPath {
    points_mm: Vec<Vector>,
    /// Values at all points of each commanded angle.
    angles_rad: Vec<Vec<f64>>,
    /// Length from the first point to each point.
    along_mm: Vec<f64>,
}

/// A point of the commanded path with its normal plane, in which passes are compared.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandPoint {
    /// Length of the path up to this point.
    pub along_mm: f64,
    /// Position of the point.
    pub position_mm: Vector,
    /// Unit tangent of the path, normal to the plane.
    pub tangent: Vector,
    /// Commanded angles at the point.
    pub angles_rad: Vec<f64>,
}

/// A corner between two legs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Commanded corner.
    pub position_mm: Vector,
    /// Unit vector of the incoming leg.
    pub incoming: Vector,
    /// Unit vector of the outgoing leg.
    pub outgoing: Vector,
    /// Lengths of the path up to the middle of the incoming leg, the corner, and the middle of the
    /// outgoing leg.
    pub along_mm: [f64; 3],
}

impl CommandedPath {
    /// Creates a path from at least two points, each different from the previous one; angles turn
    /// the shorter way.
    pub fn new(points_mm: Vec<Vector>, angles_rad: &[Vec<f64>]) -> Result<Self> {
        crate::iso9283::statistics::sample::positions(&points_mm, 2, "commanded-path")?;
        let n = points_mm.len();
        if angles_rad.iter().any(|a| a.len() != n || a.iter().any(|v| !v.is_finite())) {
            return Err(error!("commanded-angle-missing").into());
        }
        let mut along_mm = vec![0.0];
        for (i, pair) in points_mm.windows(2).enumerate() {
            let leg = norm(minus(pair[1], pair[0]));
            if leg == 0.0 {
                return Err(error!("commanded-point-repeated", first = i + 1, second = i + 2).into());
            }
            along_mm.push(along_mm[i] + leg);
        }
        Ok(Self { points_mm, angles_rad: angles_rad.iter().map(|a| followed(a)).collect(), along_mm })
    }

    /// Length of the whole path.
    pub fn length_mm(&self) -> f64 {
        self.along_mm.last().copied().unwrap_or_default()
    }

    /// Largest change of each angle along the path.
    pub fn turned_rad(&self) -> Vec<f64> {
        let turned = |a: &Vec<f64>| {
            let (low, high) = a.iter().fold((f64::MAX, f64::MIN), |(l, h), &v| (l.min(v), h.max(v)));
            high - low
        };
        self.angles_rad.iter().map(turned).collect()
    }

    /// Midpoints of `count` equal parts of the path; the ends are excluded because a robot that
    /// stops may not reach them.
    pub fn command_points(&self, count: usize) -> Vec<CommandPoint> {
        (0..count).map(|i| self.at((i as f64 + 0.5) / count as f64 * self.length_mm())).collect()
    }

    /// Like [`Self::command_points`], without the points near a corner that turns by more than
    /// `least_rad`: within `near_mm`, but at most a quarter of the leg. A robot that rounds the
    /// corner passes their planes in another order, or not at all.
    pub fn command_points_beside(&self, count: usize, least_rad: f64, near_mm: f64) -> Vec<CommandPoint> {
        let corners = self.corners(least_rad);
        let mut points = self.command_points(count);
        let beside = |p: &CommandPoint, c: &Corner| {
            let [before, at, after] = c.along_mm;
            let half_leg_mm = if p.along_mm < at { at - before } else { after - at };
            (p.along_mm - at).abs() > near_mm.min(0.5 * half_leg_mm)
        };
        points.retain(|p| corners.iter().all(|c| beside(p, c)));
        points
    }

    fn at(&self, along_mm: f64) -> CommandPoint {
        let after = self.along_mm.partition_point(|&s| s <= along_mm).clamp(1, self.points_mm.len() - 1);
        let (a, b) = (self.points_mm[after - 1], self.points_mm[after]);
        let share = (along_mm - self.along_mm[after - 1]) / (self.along_mm[after] - self.along_mm[after - 1]);
        let between = |a: f64, b: f64| a + share * (b - a);
        CommandPoint {
            along_mm,
            position_mm: [0, 1, 2].map(|k| between(a[k], b[k])),
            tangent: unit(minus(b, a)).unwrap_or_default(),
            angles_rad: self.angles_rad.iter().map(|v| between(v[after - 1], v[after])).collect(),
        }
    }

    /// Points at which the path turns by more than `least_rad`; smaller turns belong to curves that
    /// are given by points.
    pub fn corners(&self, least_rad: f64) -> Vec<Corner> {
        let corner = |i: usize| {
            let (a, e, b) = (self.points_mm[i - 1], self.points_mm[i], self.points_mm[i + 1]);
            let (incoming, outgoing) = (unit(minus(e, a))?, unit(minus(b, e))?);
            let turn = dot(incoming, outgoing).clamp(-1.0, 1.0).acos();
            let [from, at, to] = [i - 1, i, i + 1].map(|j| self.along_mm[j]);
            let along_mm = [0.5 * (from + at), at, 0.5 * (at + to)];
            (turn > least_rad).then_some(Corner { position_mm: e, incoming, outgoing, along_mm })
        };
        (1..self.points_mm.len() - 1).filter_map(corner).collect()
    }
}
