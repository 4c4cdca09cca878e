//! Conversion of a chain of joints into screw axes and Denavit-Hartenberg tables.
//!
//! A table row has four of the six degrees of freedom of a frame. A table therefore represents any
//! axes, but not any base frame or flange (Denavit & Hartenberg 1955; Craig 1986). The remaining
//! motions are part of the result.

use crate::{JointChain, SerialJoint};
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm, unit};

/// Twist (rad) below which two axes count as near-parallel: their common normal is too uncertain to
/// place frames by.
pub const NEAR_PARALLEL_RAD: f64 = 0.052;

/// Distance (mm) below which two axes meet, and parallel axes coincide.
const MEET_MM: f64 = 1e-6;

/// Angle (rad) of a link below which it is zero up to rounding.
const STRAIGHT_RAD: f64 = 1e-11;

/// Sine of the angle below which two axes are exactly parallel.
const EXACTLY: f64 = 1e-9;

/// Position of the link in a row of a Denavit-Hartenberg table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableConvention {
    /// Link before the joint: Rx(alpha) Tx(a) [Ry(beta)] Rz(theta + q) Tz(d) (Craig).
    Modified,
    /// Link after the joint: Rz(theta + q) Tz(d) Tx(a) Rx(alpha) [Ry(beta)].
    Standard,
}

impl TableConvention {
    /// The other table convention.
    pub(crate) fn other(self) -> Self {
        if self == Self::Modified { Self::Standard } else { Self::Modified }
    }

    /// Name of the convention.
    pub(crate) fn name(self) -> &'static str {
        if self == Self::Modified { "modified" } else { "standard" }
    }

    /// Value of the key `convention` in robot.toml.
    pub fn key(self) -> &'static str {
        if self == Self::Modified { "mdh" } else { "dh" }
    }

    /// Table of axes and flange in the base frame at joint values zero.
    pub fn table(self, axes: &[AxisLine], flange: &Pose) -> AxisTable {
        match self {
            Self::Modified => modified_table(axes, flange),
            Self::Standard => standard_table(axes, flange),
        }
    }
}

/// Axis of a joint in the base frame at joint values zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisLine {
    /// Unit direction; a positive joint value rotates about it or translates along it.
    pub direction: Vector,
    /// Point on the axis (mm); meaningless for a prismatic joint.
    pub point_mm: Vector,
    /// `true` if the joint slides.
    pub prismatic: bool,
}

/// Axes of the base along and about which a screw axis has errors: the two that are furthest from
/// its direction.
pub(crate) fn error_axes(direction: Vector) -> [usize; 2] {
    let size = |k: usize| direction[k].abs();
    let along = (0..3).fold(2, |best, k| if size(k) > size(best) { k } else { best });
    [[1, 2], [0, 2], [0, 1]][along]
}

impl AxisLine {
    /// Motion of the joint by a value (rad or mm).
    pub fn motion(&self, value: f64) -> Pose {
        if self.prismatic {
            return Pose { translation_mm: self.direction.map(|v| v * value), ..Pose::identity() };
        }
        let turn = Pose::from_rotation_vector(self.direction.map(|v| v * value));
        Pose { translation_mm: minus(self.point_mm, turn.rotate(self.point_mm)), ..turn }
    }

    /// Errors of this axis in a robot of screw axes with which it is at a near axis, to first
    /// order: two translations (mm) of a revolute axis, then two rotations (rad), in the order of
    /// the robot's parameters.
    pub fn errors_to(&self, near: &Self) -> Vec<f64> {
        let [i, j] = error_axes(self.direction);
        let along = 3 - i - j;
        let mut errors = Vec::new();
        if !self.prismatic {
            // where the near axis is at the same coordinate along
            let share = (self.point_mm[along] - near.point_mm[along]) / near.direction[along];
            errors.extend([i, j].map(|k| near.point_mm[k] + share * near.direction[k] - self.point_mm[k]));
        }
        // r × direction is the change of the direction, r has no component along
        let cyclic = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        let change = [i, j].map(|k| cyclic * (near.direction[k] - self.direction[k]) / self.direction[along]);
        errors.extend([-change[1], change[0]]);
        errors
    }

    /// The axis after a motion.
    pub fn moved(&self, by: &Pose) -> Self {
        Self { direction: by.rotate(self.direction), point_mm: by.apply(self.point_mm), ..*self }
    }

    /// Foot of the perpendicular from a point.
    pub fn foot(&self, point: Vector) -> Vector {
        let along = dot(minus(point, self.point_mm), self.direction);
        plus(self.point_mm, self.direction, along)
    }
}

impl JointChain {
    /// Axes in the base frame at joint values zero, and the flange there.
    pub fn axes(&self) -> (Vec<AxisLine>, Pose) {
        let mut pose = Pose::identity();
        let axis = |joint: &crate::ChainJoint| {
            pose = pose.then(&joint.origin);
            AxisLine { direction: pose.axis(2), point_mm: pose.translation_mm, prismatic: joint.prismatic }
        };
        let axes = self.joints.iter().map(axis).collect();
        (axes, pose.then(&self.flange))
    }

    /// Pose of the flange in the base frame at logged joint values (mm or rad).
    pub fn flange_at(&self, joints: &[f64]) -> Pose {
        self.frames(joints).last().copied().unwrap_or(Pose::identity()).then(&self.flange)
    }

    /// Chain with the frame of each joint near the arm: a frame farther along its axis
    /// than the arm reaches is moved to the foot of the perpendicular from the previous axis. The
    /// reach is the length of these perpendiculars from the base to the flange.
    pub fn near_arm(&self) -> Self {
        let (axes, flange) = self.axes();
        let (mut feet, mut reached, mut reach_mm) = (Vec::new(), Vector::default(), 0.0);
        for axis in &axes {
            let foot = axis.foot(reached);
            reach_mm += norm(minus(foot, reached));
            (reached, feet) = (foot, [feet, vec![foot]].concat());
        }
        reach_mm += norm(minus(flange.translation_mm, reached));
        let moved_mm = |(axis, foot): (&AxisLine, &Vector)| {
            let along = dot(minus(*foot, axis.point_mm), axis.direction);
            if along.abs() > reach_mm { along } else { 0.0 }
        };
        let moved: Vec<f64> = axes.iter().zip(&feet).map(moved_mm).collect();
        let mut back = Pose::identity();
        let joint = |(joint, moved): (&crate::ChainJoint, &f64)| {
            let origin = back.then(&joint.origin).shift(2, *moved);
            back = Pose::identity().shift(2, -moved);
            crate::ChainJoint { origin, ..*joint }
        };
        let joints = self.joints.iter().zip(&moved).map(joint).collect();
        Self { joints, flange: back.then(&self.flange) }
    }

    /// Frames of the joints in the base frame, moved to logged joint values (mm or rad).
    pub fn frames(&self, joints: &[f64]) -> Vec<Pose> {
        let mut pose = Pose::identity();
        let moved = |(joint, value): (&crate::ChainJoint, &f64)| {
            let at = pose.then(&joint.origin);
            let travel = joint.gain * value;
            pose = if joint.prismatic { at.shift(2, travel) } else { at.turn_z(travel) };
            pose
        };
        self.joints.iter().zip(joints).map(moved).collect()
    }
}

/// Denavit-Hartenberg table of a chain, and the motions that the table cannot represent.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisTable {
    /// Rows of the joints.
    pub joints: Vec<SerialJoint>,
    /// Frame before the first row, in the base frame: identity if the table represents the base.
    pub base: Pose,
    /// Flange in the frame after the last row: identity if the table represents the flange.
    pub flange: Pose,
    /// Angles between near-parallel axes that the rows do not represent, only Hayati's beta.
    pub tilts: Vec<LostTilt>,
}

/// Angle between two near-parallel axes about the direction that the rows do not represent: the
/// value of Hayati's beta with which the table is exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LostTilt {
    /// Index of the row with the link between the axes.
    pub row: usize,
    /// Angle (rad).
    pub angle_rad: f64,
}

/// Link between two consecutive lines.
struct Link {
    /// Direction of the common normal.
    x: Vector,
    /// Ends of the common normal.
    feet: [Vector; 2],
    alpha_rad: f64,
    a_mm: f64,
    parallel: bool,
    tilt_rad: f64,
}

impl Link {
    /// Motion from the start of the link to its end, with or without the angle that only Hayati's
    /// beta represents.
    fn motion(&self, tilt_rad: f64) -> Pose {
        Pose::identity().turn_x(self.alpha_rad).shift(0, self.a_mm).turn_y(tilt_rad)
    }

    /// Frame at the start of the link; `z` is the direction of the first line.
    fn start(&self, z: Vector) -> Pose {
        frame(self.x, z, self.feet[0])
    }

    /// Direction of x at the end of the link.
    fn end_x(&self, z: Vector) -> Vector {
        if self.tilt_rad == 0.0 { self.x } else { self.start(z).then(&self.motion(self.tilt_rad)).axis(0) }
    }

    /// Link with the sign of its normal for which the frame is turned least from `wish`:
    /// free for lines that meet, otherwise only if the other sign represents `wish` exactly.
    fn facing(self, wish: Vector) -> Self {
        let along = dot(self.x, wish);
        let turned = if self.a_mm == 0.0 { along < -EXACTLY } else { along < EXACTLY - 1.0 };
        if !turned {
            return self;
        }
        let [alpha_rad, a_mm, tilt_rad] = [self.alpha_rad, self.a_mm, self.tilt_rad].map(|v| 0.0 - v);
        Self { x: self.x.map(|v| -v), alpha_rad, a_mm, tilt_rad, ..self }
    }
}

fn plus(point: Vector, direction: Vector, length: f64) -> Vector {
    [0, 1, 2].map(|i| point[i] + direction[i] * length)
}

/// Component of `v` across a unit direction.
fn across(v: Vector, direction: Vector) -> Vector {
    plus(v, direction, -dot(v, direction))
}

/// Angle (rad) from `a` to `b` about `axis`.
fn angle(a: Vector, b: Vector, axis: Vector) -> f64 {
    dot(cross(a, b), axis).atan2(dot(a, b))
}

/// Direction perpendicular to an axis that is nearest to `wish`; any such direction if `wish` is
/// along the axis.
fn nearest_across(wish: Vector, axis: Vector) -> Vector {
    let candidates = [wish, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let far = |v: &Vector| norm(across(*v, axis)) > 1e-6;
    candidates.into_iter().find(far).and_then(|v| unit(across(v, axis))).unwrap_or([1.0, 0.0, 0.0])
}

/// `true` if the common normal of two lines is too uncertain to place frames by.
fn is_near_parallel(from: &AxisLine, to: &AxisLine) -> bool {
    norm(cross(from.direction, to.direction)) < NEAR_PARALLEL_RAD.sin()
}

/// Ends of the common normal of two lines that are not parallel.
fn common_feet(from: &AxisLine, to: &AxisLine) -> [Vector; 2] {
    let (z, next) = (from.direction, to.direction);
    let normal = cross(z, next);
    let between = minus(to.point_mm, from.point_mm);
    let scale = 1.0 / dot(normal, normal);
    let along = [dot(cross(between, next), normal) * scale, dot(cross(between, z), normal) * scale];
    [plus(from.point_mm, z, along[0]), plus(to.point_mm, next, along[1])]
}

/// Common normal of two lines. `reached` is the point on the first line at which the previous link
/// ended, `before` the previous normal; both decide cases that the data leave undetermined.
fn link(from: &AxisLine, to: &AxisLine, reached: Vector, before: Vector) -> Link {
    let (z, next) = (from.direction, to.direction);
    if is_near_parallel(from, to) {
        return parallel(from, to, reached, before);
    }
    let normal = cross(z, next);
    let sine = norm(normal);
    let feet = common_feet(from, to);
    let a_mm = dot(minus(feet[1], feet[0]), normal) / sine;
    // axes that meet leave the sign open: the frame turns as little as possible
    let sign = match a_mm.abs() < MEET_MM {
        true if dot(normal, before) < -EXACTLY => -1.0,
        false if a_mm < 0.0 => -1.0,
        _ => 1.0,
    };
    let x = normal.map(|v| v * sign / sine);
    let a_mm = if a_mm.abs() < MEET_MM { 0.0 } else { a_mm.abs() };
    Link { x, feet, alpha_rad: angle(z, next, x), a_mm, parallel: false, tilt_rad: 0.0 }
}

/// Link between near-parallel lines: it starts where the previous link ended.
fn parallel(from: &AxisLine, to: &AxisLine, reached: Vector, before: Vector) -> Link {
    let (z, next) = (from.direction, to.direction);
    // point of the second line in the plane across the first at the start
    let height = dot(minus(reached, to.point_mm), z) / dot(next, z);
    let foot = plus(to.point_mm, next, height);
    let aside = across(minus(foot, reached), z);
    let a_mm = norm(aside);
    let x = if a_mm > MEET_MM { aside.map(|v| v / a_mm) } else { nearest_across(before, z) };
    let y = cross(z, x);
    // the second direction is Rx(alpha) Ry(beta) z = (sin beta, -sin alpha cos beta, ...)
    let alpha_rad = (-dot(next, y)).atan2(dot(next, z));
    let tilt_rad = dot(next, x).clamp(-1.0, 1.0).asin();
    let clean = |v: f64| if v.abs() < STRAIGHT_RAD { 0.0 } else { v };
    let a_mm = if a_mm > MEET_MM { a_mm } else { 0.0 };
    Link { x, feet: [reached, foot], alpha_rad: clean(alpha_rad), a_mm, parallel: true, tilt_rad: clean(tilt_rad) }
}

/// Frame from its x and z axes and its origin.
pub fn frame(x: Vector, z: Vector, origin: Vector) -> Pose {
    let y = cross(z, x);
    Pose { rotation: [0, 1, 2].map(|i| [x[i], y[i], z[i]]), translation_mm: origin }
}

/// Consecutive links between lines. Returns them with the normal and the point after them. The axis
/// of a prismatic joint, whose position is arbitrary, is placed where the previous link ended.
fn links(lines: &mut [AxisLine], start: Vector, before: Vector) -> Vec<Link> {
    let (mut reached, mut before) = (start, before);
    let mut all = Vec::new();
    for k in 1..lines.len() {
        if lines[k].prismatic {
            lines[k].point_mm = reached;
        }
        let next = link(&lines[k - 1], &lines[k], reached, before);
        (reached, before) = (next.feet[1], next.x);
        all.push(next);
    }
    all
}

/// Line of the z axis of a frame.
fn z_line(pose: &Pose) -> AxisLine {
    AxisLine { direction: pose.axis(2), point_mm: pose.translation_mm, prismatic: false }
}

/// Modified Denavit-Hartenberg table (Craig): Rx(alpha) Tx(a) Rz(theta + q) Tz(d).
///
/// Axes and flange are in the base frame at joint values zero.
pub fn modified_table(axes: &[AxisLine], flange: &Pose) -> AxisTable {
    let base = Pose::identity();
    let mut lines = vec![z_line(&base)];
    lines.extend(axes);
    let mut links = links(&mut lines, base.translation_mm, base.axis(0));
    if links.is_empty() {
        return AxisTable { joints: Vec::new(), base, flange: *flange, tilts: Vec::new() };
    }
    let first = links.remove(0).facing(base.axis(0));
    let of_base = first.start(base.axis(2)).then(&first.motion(first.tilt_rad)).then(&first.motion(0.0).inverse());
    links.insert(0, first);
    let last = lines[lines.len() - 1];
    let end_x = nearest_across(flange.axis(0), last.direction);
    let end = last.foot(flange.translation_mm);
    let next = |k: usize| links.get(k + 1).map_or((end_x, end), |l| (l.x, l.feet[0]));
    let row = |(k, link): (usize, &Link)| {
        let (axis, (x, foot)) = (&lines[k + 1], next(k));
        let theta_rad = angle(link.end_x(lines[k].direction), x, axis.direction);
        let d_mm = dot(minus(foot, link.feet[1]), axis.direction);
        SerialJoint { parallel: link.parallel && k > 0, ..row(link, axis, theta_rad, d_mm) }
    };
    AxisTable {
        joints: links.iter().enumerate().map(row).collect(),
        base: rounded(of_base),
        flange: rounded(frame(end_x, last.direction, end).inverse().then(flange)),
        tilts: tilts(&links[1..], 1),
    }
}

/// Standard Denavit-Hartenberg table: Rz(theta + q) Tz(d) Tx(a) Rx(alpha).
///
/// Axes and flange are in the base frame at joint values zero.
pub fn standard_table(axes: &[AxisLine], flange: &Pose) -> AxisTable {
    let base = Pose::identity();
    let Some(&(mut first)) = axes.first() else {
        return AxisTable { joints: Vec::new(), base, flange: *flange, tilts: Vec::new() };
    };
    if first.prismatic {
        first.point_mm = base.translation_mm;
    }
    let mut lines = vec![first];
    lines.extend(&axes[1..]);
    let start_x = nearest_across(base.axis(0), first.direction);
    let start = first.foot(base.translation_mm);
    let mut links = links(&mut lines, start, start_x);
    links.push(to_flange(&lines[lines.len() - 1], flange, links.last()));
    let before = |k: usize| match k.checked_sub(1) {
        None => (start_x, start),
        Some(k) => (links[k].end_x(lines[k].direction), links[k].feet[1]),
    };
    let row = |(k, link): (usize, &Link)| {
        let (axis, (x, foot)) = (&lines[k], before(k));
        let theta_rad = angle(x, link.x, axis.direction);
        let d_mm = dot(minus(link.feet[0], foot), axis.direction);
        SerialJoint { parallel: link.parallel && k + 1 < axes.len(), ..row(link, axis, theta_rad, d_mm) }
    };
    let joints = links.iter().enumerate().map(row).collect();
    let end = links.len() - 1;
    AxisTable {
        joints,
        base: rounded(frame(start_x, first.direction, start)),
        flange: rounded(links[end].start(lines[end].direction).then(&links[end].motion(0.0)).inverse().then(flange)),
        tilts: tilts(&links[..end], 0),
    }
}

/// Link from the last axis to the z axis of the flange. A link between near-parallel lines ends at
/// the flange itself, so that the table represents its position.
fn to_flange(last: &AxisLine, flange: &Pose, before: Option<&Link>) -> Link {
    let (line, wish) = (z_line(flange), flange.axis(0));
    if is_near_parallel(last, &line) {
        return parallel(last, &line, last.foot(flange.translation_mm), wish).facing(wish);
    }
    let (reached, x) = before.map_or((last.point_mm, wish), |link| (link.feet[1], link.x));
    link(last, &line, reached, x).facing(wish)
}

/// Frames of the links behind the axes, in the base frame at joint values zero: the origin is on
/// the axis, z is its direction, and x is along the common normal to the next axis.
///
/// The frames are a function of the lines and of the flange, whatever points describe the lines.
/// They are the frames of a Denavit-Hartenberg table (Denavit & Hartenberg 1955; Craig 1986), with
/// its freedoms fixed: the origin is the foot of the common normal to the next axis; of an axis
/// near-parallel to the next one, the foot of the previous normal or, without a previous normal, of
/// the perpendicular from the next foot; of the last axis, the foot of the perpendicular from the
/// flange.
pub fn link_frames(axes: &[AxisLine], flange: &Pose) -> Vec<Pose> {
    let (Some(first), Some(last)) = (axes.first(), axes.last()) else { return Vec::new() };
    let mut lines = axes.to_vec();
    if first.prismatic {
        lines[0].point_mm = flange.translation_mm;
    }
    let crossing = |pair: &&[AxisLine]| !is_near_parallel(&pair[0], &pair[1]) && pair.iter().all(|a| !a.prismatic);
    let settled = axes.windows(2).find(crossing).map(|pair| common_feet(&pair[0], &pair[1])[0]);
    let start = lines[0].foot(settled.unwrap_or(flange.translation_mm));
    let wish = flange.axis(0);
    let links = links(&mut lines, start, nearest_across(wish, first.direction));
    let mut frames: Vec<Pose> =
        links.iter().zip(axes).map(|(link, axis)| frame(link.x, axis.direction, link.feet[0])).collect();
    let end = lines[lines.len() - 1].foot(flange.translation_mm);
    frames.push(frame(nearest_across(wish, last.direction), last.direction, end));
    frames
}

/// Row of a table of the joint about or along an axis.
fn row(link: &Link, axis: &AxisLine, theta_rad: f64, d_mm: f64) -> SerialJoint {
    let clean = |v: f64, least: f64| if v.abs() < least { 0.0 } else { v };
    SerialJoint {
        alpha_rad: clean(link.alpha_rad, 1e-12),
        a_mm: link.a_mm,
        theta_rad: clean(theta_rad, 1e-12),
        d_mm: clean(d_mm, 1e-9),
        prismatic: axis.prismatic,
        parallel: link.parallel,
    }
}

/// Angles of links that the rows from `first` on represent by Hayati's beta only.
fn tilts(links: &[Link], first: usize) -> Vec<LostTilt> {
    let lost = (first..).zip(links).filter(|(_, link)| link.tilt_rad != 0.0);
    lost.map(|(row, link)| LostTilt { row, angle_rad: link.tilt_rad }).collect()
}

/// The pose, or the identity if they differ by rounding only.
fn rounded(pose: Pose) -> Pose {
    let still = pose.angle_rad() < 1e-9 && norm(pose.translation_mm) < MEET_MM;
    if still { Pose::identity() } else { pose }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Robot, Serial};
    use etalon_base::noise::Noise;

    fn drawn(noise: &mut Noise, trial: u64) -> Vec<AxisLine> {
        let (parallel, sliding) = (trial.is_multiple_of(2), trial.is_multiple_of(3));
        let mut axes: Vec<AxisLine> = Vec::new();
        for i in 0..1 + trial as usize % 7 {
            let v = |noise: &mut Noise, size: f64| [0; 3].map(|_| noise.uniform(size));
            let direction = match axes.last() {
                Some(last) if parallel && i % 3 == 2 => last.direction,
                _ => unit(v(noise, 1.0)).unwrap(),
            };
            axes.push(AxisLine { direction, point_mm: v(noise, 800.0), prismatic: sliding && i % 4 == 1 });
        }
        axes
    }

    fn direct(axes: &[AxisLine], flange: &Pose, q: &[f64]) -> Pose {
        let chain = axes.iter().zip(q).fold(Pose::identity(), |pose, (axis, q)| pose.then(&axis.motion(*q)));
        chain.then(flange)
    }

    fn differ(a: &Pose, b: &Pose) -> f64 {
        let moved = a.inverse().then(b);
        norm(moved.translation_mm).max(1000.0 * moved.angle_rad())
    }

    #[test]
    fn tables_and_axes_move_alike() {
        for trial in 0..200 {
            let mut noise = Noise::new(5, trial);
            let axes = drawn(&mut noise, trial);
            let turn = [0; 3].map(|_| noise.uniform(2.0));
            let flange =
                Pose { translation_mm: [0; 3].map(|_| noise.uniform(900.0)), ..Pose::from_rotation_vector(turn) };
            let q: Vec<f64> = axes.iter().map(|a| noise.uniform(if a.prismatic { 200.0 } else { 3.0 })).collect();
            for convention in [TableConvention::Modified, TableConvention::Standard] {
                let table = convention.table(&axes, &flange);
                let arm = Serial::from_axis_table(convention, &table.joints, &["T".to_owned()]);
                let chain = table.base.then(&arm.direct(&arm.nominal(), &q)).then(&table.flange);
                let wrong = differ(&chain, &direct(&axes, &flange, &q));
                assert!(wrong < 1e-6, "trial {trial}, {convention:?}: {wrong} mm, {table:?}");
                assert!(table.tilts.is_empty(), "{table:?}");
            }
            // and back: the axes of the arm that the table builds
            let table = modified_table(&axes, &flange);
            let arm = Serial::from_axis_table(TableConvention::Modified, &table.joints, &["T".to_owned()]);
            let (back, _) = arm.joint_chain(&arm.nominal()).unwrap().axes();
            for (axis, back) in axes.iter().zip(&back) {
                let back = back.moved(&table.base);
                assert!(norm(minus(back.direction, axis.direction)) < 1e-9);
                assert!(axis.prismatic || norm(minus(axis.foot(back.point_mm), back.point_mm)) < 1e-6);
            }
        }
    }

    /// A base and a flange on the axes are held by the table itself.
    #[test]
    fn a_table_converts_to_itself() {
        let half = std::f64::consts::FRAC_PI_2;
        let row = |alpha_rad, a_mm, theta_rad, d_mm, parallel| SerialJoint {
            alpha_rad,
            a_mm,
            theta_rad,
            d_mm,
            prismatic: false,
            parallel,
        };
        // shape of an IRB 120: ABB's product manual 3HAC035960
        let joints = [
            row(0.0, 0.0, 0.0, 290.0, false),
            row(-half, 0.0, -half, 0.0, false),
            row(0.0, 270.0, 0.0, 0.0, true),
            row(-half, 70.0, 0.0, 302.0, false),
            row(half, 0.0, 0.0, 0.0, false),
            row(-half, 0.0, 0.0, 72.0, false),
        ];
        let arm = Serial::from_axis_table(TableConvention::Modified, &joints, &["T".to_owned()]);
        let (axes, flange) = arm.joint_chain(&arm.nominal()).unwrap().axes();
        let table = modified_table(&axes, &flange);
        assert_eq!((table.base, table.flange), (Pose::identity(), Pose::identity()));
        for (row, stated) in table.joints.iter().zip(&joints) {
            let cells = |j: &SerialJoint| [1000.0 * j.alpha_rad, j.a_mm, 1000.0 * j.theta_rad, j.d_mm];
            let wrong = cells(row).iter().zip(cells(stated)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(wrong < 1e-6 && row.parallel == stated.parallel, "{row:?} {stated:?}");
        }
    }

    #[test]
    fn the_tilt_of_near_parallel_axes_is_stated() {
        let tilted = |angle: f64| [angle.sin(), 0.0, angle.cos()];
        let axes = [
            AxisLine { direction: [0.0, 0.0, 1.0], point_mm: [0.0; 3], prismatic: false },
            AxisLine { direction: tilted(1e-3), point_mm: [400.0, 0.0, 0.0], prismatic: false },
        ];
        let table = modified_table(&axes, &Pose { translation_mm: [700.0, 0.0, 0.0], ..Pose::identity() });
        // by hand: the second axis leans by 1 mrad along the normal, which only Hayati's beta holds
        assert!(matches!(table.tilts[..], [LostTilt { row: 1, angle_rad }] if (angle_rad - 1e-3).abs() < 1e-9));
        assert!(table.joints[1].parallel && (table.joints[1].a_mm - 400.0).abs() < 1e-9);
    }

    /// An arm of screw axes with the errors to near axes is the arm of the near axes.
    #[test]
    fn errors_of_screw_axes_lead_to_near_axes() {
        let mut noise = Noise::new(45, 12);
        let home = Pose { translation_mm: [400.0, 100.0, 300.0], ..Pose::identity() };
        for trial in 0..50 {
            let mut vector = |size: f64| [0; 3].map(|_| noise.uniform(size));
            let axis = |vector: &mut dyn FnMut(f64) -> Vector, prismatic| AxisLine {
                direction: unit(vector(1.0)).unwrap(),
                point_mm: if prismatic { [0.0; 3] } else { vector(500.0) },
                prismatic,
            };
            let axes: Vec<AxisLine> = (0..6).map(|k| axis(&mut vector, (k + trial) % 5 == 0)).collect();
            let moved = |a: &AxisLine, vector: &mut dyn FnMut(f64) -> Vector| {
                let d = vector(1e-6);
                let t = vector(1e-3);
                AxisLine {
                    direction: unit([0, 1, 2].map(|i| a.direction[i] + d[i])).unwrap(),
                    point_mm: [0, 1, 2].map(|i| a.point_mm[i] + t[i] + 300.0 * a.direction[i]),
                    ..*a
                }
            };
            let near: Vec<AxisLine> = axes.iter().map(|a| moved(a, &mut vector)).collect();
            let [of, to] = [&axes, &near].map(|axes| Serial::from_axes(axes, &home, &["T".to_owned()]));
            let mut values = of.nominal();
            for (k, (axis, near)) in axes.iter().zip(&near).enumerate() {
                let own = of.parameters().iter().enumerate().filter(|(_, p)| p.joint == Some(k));
                let own = own.filter(|(_, p)| p.effect == crate::Effect::Geometry || p.effect == crate::Effect::Zeros);
                let errors = axis.errors_to(near);
                let own: Vec<usize> = own.map(|(i, _)| i).collect();
                assert_eq!(own.len(), errors.len());
                own.into_iter().zip(errors).for_each(|(i, error)| values[i] = error);
            }
            let q: Vec<f64> = axes.iter().map(|a| noise.uniform(if a.prismatic { 200.0 } else { 2.0 })).collect();
            let wrong = norm(minus(of.position(&values, &q, 0), to.position(&to.nominal(), &q, 0)));
            // second order of 1 µrad at 1 m
            assert!(wrong < 1e-8, "trial {trial}: {wrong:e} mm");
        }
    }
}
