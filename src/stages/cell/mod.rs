//! `etalon cell`: tool, work object, hand and eye, external axes from a table of controller poses
//! and measurements.

mod bounds;
mod changes;
mod judgement;
mod readings;

use super::orientations::AngleOrder;
use super::table_file::TableFile;
use bounds::Region;
use etalon_base::angle::Turn;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result, Severity};
use etalon_base::pose::{Pose, Vector, centroid, norm};
use etalon_base::{error, phrase, warning};
use etalon_documents::{
    CellAxisEntry, CellDocument, CellFrameEntry, CellNoise, CellPointEntry, CellResidualEntry, Provenance,
};
use etalon_identify::MeasuredRatio;
use etalon_identify::UncertaintyBound;
use etalon_identify::cell::{
    AlternativeFit, AxisReading, AxisRole, CellFault, CellFrame, CellPoint, CellResidual, Component, Measure, Mounting,
    ObjectSlip, Quality, RotaryAxis, Size, Stated, ThreePointRole, explained, hand_eye, linear_axis, object_frame,
    object_slips, reflector, rotary_axis, three_points, tool_axes, tool_point,
};
use etalon_robots::Quantity;
use rayon::prelude::*;
use readings::{WrittenPoses, both, coordinates};
use std::collections::BTreeMap;

/// Problem that is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CellKind {
    /// Tool centre point from orientations about one fixed point.
    ToolPoint,
    /// Point of a reflector on the tool, and base of the robot, from its measured positions.
    ToolReflector,
    /// Tool frame from contacts of a fixed point with the tool centre point and its axes.
    ToolAxes,
    /// Hand and eye from poses on both sides (AX = YB).
    HandEye,
    /// Work object or base frame from points with known coordinates.
    Object,
    /// Work object or base frame from three points (origin, x, xy or x1, x2, y1).
    ThreePoints,
    /// External linear axis: direction and scale.
    LinearAxis,
    /// External rotary axis: frame and ratio.
    RotaryAxis,
}

impl CellKind {
    /// Name on the command line and in the document.
    pub fn name(self) -> &'static str {
        match self {
            Self::ToolPoint => "tool-point",
            Self::ToolReflector => "tool-reflector",
            Self::ToolAxes => "tool-axes",
            Self::HandEye => "hand-eye",
            Self::Object => "object",
            Self::ThreePoints => "three-points",
            Self::LinearAxis => "linear-axis",
            Self::RotaryAxis => "rotary-axis",
        }
    }
}

/// Place of the measuring system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CellMounting {
    /// The target is on the robot, the measuring system stands.
    Target,
    /// The sensor is on the robot, its target stands.
    Sensor,
}

/// Data of the user that the table does not contain.
#[derive(Clone, Debug)]
pub(crate) struct CellStated {
    pub solve: CellKind,
    /// Order of the angles of the flange.
    pub order: Option<AngleOrder>,
    /// Order of the angles of measured poses.
    pub measured_order: Option<AngleOrder>,
    pub mounting: Option<CellMounting>,
    /// Standard uncertainty of a coordinate (mm).
    pub position_mm: Option<f64>,
    /// Standard uncertainty of an orientation about any axis (rad).
    pub rotation_rad: Option<f64>,
    /// Columns whose source is given.
    pub columns: Vec<String>,
    /// Given bound of the uncertainties of the answer.
    pub bound: UncertaintyBound,
}

/// Maximum number of changes in a message.
const NAMED: usize = 4;

/// Answer of one kind.
#[derive(Default)]
struct Found {
    frames: Vec<CellFrameEntry>,
    points: Vec<CellPointEntry>,
    axis: Option<CellAxisEntry>,
    quality: Option<Quality>,
    /// Measured region, relative to which uncertainties are bounded.
    region: Region,
    /// Size of tool and motion.
    size: Size,
    messages: Vec<Message>,
}

impl Found {
    /// Removes uncertainties that nothing shows.
    fn withhold_uncertainties(&mut self) {
        for frame in &mut self.frames {
            (frame.standard_uncertainty_mm, frame.standard_uncertainty_deg, frame.covariance) = (None, None, None);
        }
        for point in &mut self.points {
            (point.standard_uncertainty_mm, point.covariance_mm2) = (None, None);
        }
        if let Some(axis) = &mut self.axis {
            (axis.direction_covariance, axis.scale_standard_uncertainty) = (None, None);
        }
    }
}

fn positions(poses: &[Pose]) -> Vec<Vector> {
    poses.iter().map(|pose| pose.translation_mm).collect()
}

/// Solves a problem of a cell.
pub(crate) fn cell(file: &TableFile, stated: &CellStated) -> Result<CellDocument> {
    solve(file, stated).map_err(|problems| file.place(problems))
}

/// Warning of given columns without an effect on the problem.
fn unused(stated: &CellStated) -> Option<Message> {
    let unused = stated.columns.iter().filter(|column| !readings::is_read(stated.solve, column));
    let columns: Vec<String> = unused.map(|column| format!("`{column}`")).collect();
    let (count, solve) = (columns.len(), stated.solve.name());
    (count > 0).then(|| warning!("cell-columns-unused", count, columns, solve))
}

fn solve(file: &TableFile, stated: &CellStated) -> Result<CellDocument> {
    let task = Task {
        file,
        stated,
        uncertain: Stated {
            position_mm: stated.position_mm,
            rotation_rad: stated.rotation_rad,
            measured_mm: readings::uncertainties(file)?,
        },
    };
    let mut found = match stated.solve {
        CellKind::ToolPoint => task.tool_point(),
        CellKind::ToolReflector => task.tool_reflector(),
        CellKind::ToolAxes => task.tool_axes(),
        CellKind::HandEye => task.hand_eye(),
        CellKind::Object => task.object(),
        CellKind::ThreePoints => task.three_points(),
        CellKind::LinearAxis | CellKind::RotaryAxis => task.axis(),
    }?;
    found.messages.extend(unused(stated));
    let quality = found.quality.take();
    if let Some(quality) = &quality {
        found.messages.extend(task.remarks(quality, found.size));
    }
    // uncertainties of refuted data mean nothing
    if found.messages.iter().all(|message| message.severity != Severity::Error) {
        let beyond = task.beyond_bounds(&found, quality.as_ref());
        found.messages.extend(beyond);
    }
    let is_known = quality.as_ref().map_or(found.region.coordinate_mm.is_some(), Quality::has_uncertainty);
    if !is_known {
        found.withhold_uncertainties();
    }
    let inputs = BTreeMap::from([(file.name.clone(), etalon_base::files::sha256(file.text().as_bytes()))]);
    Ok(CellDocument {
        schema: "etalon/cell/1".to_owned(),
        provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs, seed: None },
        solve: stated.solve.name().to_owned(),
        readings: file.table.height(),
        frames: found.frames,
        points: found.points,
        axis: found.axis,
        noise: quality.iter().flat_map(|q| &q.components).map(noise).collect(),
        residuals: quality.iter().flat_map(|q| &q.residuals).map(|r| task.residual(r)).collect(),
        messages: found.messages,
    })
}

fn unit(measure: Measure) -> (&'static str, f64) {
    match measure {
        Measure::Position => ("position", 1.0),
        Measure::Orientation => ("orientation", 1f64.to_degrees()),
    }
}

fn noise(component: &Component) -> CellNoise {
    let (measure, factor) = unit(component.measure);
    CellNoise {
        measure: measure.to_owned(),
        equations: component.equations,
        redundancy: component.redundancy,
        standard_deviation: (component.redundancy > 0.5).then_some(component.deviation * factor),
        uncertainties_from: if component.agrees { "stated" } else { "residuals" }.to_owned(),
    }
}

fn frame_entry(name: &str, reference: &str, frame: &CellFrame) -> CellFrameEntry {
    let (of_position, of_rotation) = frame.standard_uncertainties();
    CellFrameEntry {
        name: name.to_owned(),
        reference: reference.to_owned(),
        xyz_mm: frame.pose.translation_mm,
        quaternion: frame.pose.quaternion(),
        standard_uncertainty_mm: Some(of_position),
        standard_uncertainty_deg: Some(of_rotation.map(f64::to_degrees)),
        covariance: Some(frame.covariance),
    }
}

fn point_entry(name: &str, reference: &str, point: &CellPoint) -> CellPointEntry {
    let u = |i: usize| point.covariance_mm2[i][i].max(0.0).sqrt();
    CellPointEntry {
        name: name.to_owned(),
        reference: reference.to_owned(),
        xyz_mm: point.at_mm,
        standard_uncertainty_mm: Some([u(0), u(1), u(2)]),
        covariance_mm2: Some(point.covariance_mm2),
    }
}

/// A task: the table of readings, and the values that the user gives.
struct Task<'a> {
    file: &'a TableFile,
    stated: &'a CellStated,
    uncertain: Stated,
}

impl Task<'_> {
    fn residual(&self, residual: &CellResidual) -> CellResidualEntry {
        let (measure, factor) = unit(residual.measure);
        let value = residual.value.map(|v| v * factor);
        CellResidualEntry {
            line: readings::line(self.file, residual.reading),
            measure: measure.to_owned(),
            residual: value,
            length: norm(value),
            probability: residual.probability,
        }
    }

    /// Message of data that do not determine the answer.
    fn fault(&self, fault: CellFault) -> Problems {
        let solve = self.stated.solve.name();
        let shown = |d: Vector| d.map(|v| format!("{v:.3}")).join(" ");
        match fault {
            CellFault::TooFew { needed, readings } => error!("cell-few", solve, needed, readings),
            CellFault::AtRest { readings } => error!("cell-axis-at-rest", readings),
            CellFault::SameOrientation => error!("cell-same-orientation"),
            CellFault::OneAxis { direction } => error!("cell-one-axis", direction = shown(direction)),
            CellFault::Coincident => error!("cell-points-coincide"),
            CellFault::Collinear { direction } => error!("cell-points-collinear", direction = shown(direction)),
            CellFault::Undetermined => error!("cell-undetermined"),
        }
        .into()
    }

    /// Rejects data that a change explains, and which cannot be explained as they are.
    fn refuse_slips(&self, found: &Quality, changes: Vec<AlternativeFit<Phrase>>) -> Result<()> {
        let explaining = explained(found, changes);
        let Some(best) = explaining.first() else { return Ok(()) };
        let deviation = |q: &Quality, k: Measure| q.components.iter().find(|c| c.measure == k).map(|c| c.deviation);
        let stated_mm = deviation(found, Measure::Position).unwrap_or(0.0);
        let left_mm = deviation(&best.quality, Measure::Position).unwrap_or(0.0);
        let count = explaining.len();
        let changes: Vec<Phrase> = explaining.iter().take(NAMED).map(|a| a.change.clone()).collect();
        Err(error!("cell-slip", count, changes, stated_mm, left_mm).into())
    }

    fn flange(&self) -> Result<WrittenPoses> {
        readings::flange(self.file, self.stated.order)
    }

    fn tool_point(&self) -> Result<Found> {
        let written = self.flange()?;
        let poses = written.poses();
        let uncertain = Stated { measured_mm: Vec::new(), ..self.uncertain.clone() };
        let fit = tool_point(&poses, &uncertain).map_err(|fault| self.fault(fault))?;
        let own = changes::orientation_changes(&written, "flange")
            .into_iter()
            .chain(changes::axis_changes(&written, "flange"));
        let changes = own.filter_map(|(change, poses)| {
            Some(AlternativeFit { change, quality: tool_point(&poses, &uncertain).ok()?.quality })
        });
        self.refuse_slips(&fit.quality, changes.collect())?;
        let known = fit.quality.has_uncertainty();
        let unit = judgement::judge_unit(&poses, fit.tool.at_mm);
        let messages = unit.into_iter().chain(judgement::judge_active_tool(&fit.tool, known)).collect();
        let size = Size::from_poses(&poses, fit.tool.at_mm);
        Ok(Found {
            points: vec![point_entry("tool", "flange", &fit.tool), point_entry("fixed", "base", &fit.fixed)],
            region: Region::from_points_and_tool(&positions(&poses), fit.tool.at_mm),
            quality: Some(fit.quality),
            size,
            messages,
            ..Found::default()
        })
    }

    fn tool_reflector(&self) -> Result<Found> {
        let (written, measured) = both(self.flange(), coordinates(self.file, ""))?;
        let poses = written.poses();
        let fit = reflector(&poses, &measured, &self.uncertain).map_err(|fault| self.fault(fault))?;
        let few = Few::new(poses.len(), &self.uncertain);
        let points = few.rows(&measured);
        let solved = |poses: &[Pose], points: &[Vector]| {
            reflector(&few.rows(poses), points, &few.uncertain).ok().map(|fit| fit.quality)
        };
        let own = changes::orientation_changes(&written, "flange").into_iter();
        let own = own.chain(changes::unit_changes(&written, "flange"));
        let changed: Vec<_> = own.chain(changes::axis_changes(&written, "flange")).collect();
        let mut all = explaining(changed, |poses| solved(poses, &points));
        for (factor, unit) in changes::UNITS {
            let scaled: Vec<Vector> = points.iter().map(|p| p.map(|v| v * factor)).collect();
            if let Some(quality) = solved(&poses, &scaled) {
                let change = phrase!("cell-change-unit", side = "measured", unit);
                all.push(AlternativeFit { change, quality: quality.in_unit(factor) });
            }
        }
        // all swaps and signs of measured coordinates are equal up to a rotation
        let mirrored: Vec<Vector> = points.iter().map(|p| [p[0], p[1], -p[2]]).collect();
        let mirrored = solved(&poses, &mirrored);
        let change = || phrase!("cell-change-measured-mirrored");
        all.extend(mirrored.map(|quality| AlternativeFit { change: change(), quality }));
        self.refuse_slips(&few.quality(&fit.quality, || solved(&poses, &points)), all)?;
        if fit.ambiguous {
            return Err(error!("cell-ambiguous").into());
        }
        Ok(Found {
            points: vec![point_entry("tool", "flange", &fit.tool)],
            frames: vec![frame_entry("base", "world", &fit.world_T_base)],
            region: Region::from_points_and_tool(&measured, fit.tool.at_mm).with_centres([centroid(&measured)]),
            messages: judgement::judge_unit(&poses, fit.tool.at_mm).into_iter().collect(),
            size: Size::from_poses(&poses, fit.tool.at_mm),
            quality: Some(fit.quality),
            ..Found::default()
        })
    }

    fn hand_eye(&self) -> Result<Found> {
        let mounting = match self.stated.mounting {
            Some(CellMounting::Target) => Ok(Mounting::Target),
            Some(CellMounting::Sensor) => Ok(Mounting::Sensor),
            None => Err(error!("cell-mounting-missing").into()),
        };
        let seen = readings::poses(self.file, "", self.stated.measured_order);
        let (mounting, (written, seen)) = both(mounting, both(self.flange(), seen))?;
        let (poses, measured) = (written.poses(), seen.poses());
        let fit = hand_eye(&poses, &measured, mounting, &self.uncertain).map_err(|fault| self.fault(fault))?;
        let few = Few::new(poses.len(), &self.uncertain);
        let solved = |poses: &[Pose], measured: &[Pose]| {
            let fit = hand_eye(&few.rows(poses), &few.rows(measured), mounting, &few.uncertain);
            fit.ok().map(|fit| fit.quality)
        };
        let of_flange = changes::orientation_changes(&written, "flange").into_iter();
        let of_flange = of_flange.chain(changes::unit_changes(&written, "flange"));
        let of_flange: Vec<_> = of_flange.chain(changes::axis_changes(&written, "flange")).collect();
        let mut all = explaining(of_flange, |poses| solved(poses, &measured));
        let of_seen = changes::orientation_changes(&seen, "measured").into_iter();
        let of_seen: Vec<_> = of_seen.chain(changes::axis_changes(&seen, "measured")).collect();
        all.extend(explaining(of_seen, |measured| solved(&poses, measured)));
        for ((change, measured), (factor, _)) in
            changes::unit_changes(&seen, "measured").into_iter().zip(changes::UNITS)
        {
            let quality = solved(&poses, &measured).map(|quality| quality.in_unit(factor));
            all.extend(quality.map(|quality| AlternativeFit { change, quality }));
        }
        self.refuse_slips(&few.quality(&fit.quality, || solved(&poses, &measured)), all)?;
        if fit.ambiguous {
            return Err(error!("cell-ambiguous").into());
        }
        let hand_mm = fit.flange_T_hand.pose.translation_mm;
        let hands: Vec<Vector> = poses.iter().map(|pose| pose.apply(hand_mm)).collect();
        let [hand, other] = if mounting == Mounting::Target { ["tool", "world"] } else { ["sensor", "target"] };
        Ok(Found {
            frames: vec![
                frame_entry(hand, "flange", &fit.flange_T_hand),
                frame_entry(other, "base", &fit.base_T_world),
            ],
            region: Region::from_points_and_tool(&hands, hand_mm).with_centres([None, centroid(&hands)]),
            messages: judgement::judge_unit(&poses, hand_mm).into_iter().collect(),
            size: Size::from_poses(&poses, hand_mm),
            quality: Some(fit.quality),
            ..Found::default()
        })
    }

    fn object(&self) -> Result<Found> {
        let (known, measured) = both(coordinates(self.file, "nominal_"), coordinates(self.file, ""))?;
        let fit = object_frame(&known, &measured, &self.uncertain).map_err(|fault| self.fault(fault))?;
        let line = |i: usize| readings::line(self.file, i);
        let described = |slip: ObjectSlip| match slip {
            ObjectSlip::Unit(factor) => phrase!("cell-change-scale", factor),
            ObjectSlip::Mirrored(_) => phrase!("cell-change-mirrored"),
            ObjectSlip::Exchanged([a, b]) => phrase!("cell-change-exchanged", first = line(a), second = line(b)),
        };
        let slips = object_slips(&known, &measured, &self.uncertain, &fit.quality).into_iter();
        let changes = slips.map(|a| AlternativeFit { change: described(a.change), quality: a.quality }).collect();
        self.refuse_slips(&fit.quality, changes)?;
        Ok(Found {
            frames: vec![frame_entry("object", "points", &fit.frame)],
            region: Region::from_points(&measured).with_centres([centroid(&measured)]),
            size: Size::from_points(&measured),
            quality: Some(fit.quality),
            ..Found::default()
        })
    }

    /// Indices of the rows by the names in the column `point`.
    fn roles(&self, known: &[&str]) -> Result<Vec<usize>> {
        self.file.table.require(["point"])?;
        let names = self.file.table.texts("point")?;
        let mut problems = Problems::default();
        let mut roles = Vec::new();
        for (i, name) in names.iter().enumerate() {
            match known.iter().position(|role| *role == name.trim()) {
                Some(role) => roles.push(role),
                None => {
                    let message = error!("cell-point-unknown", name = &**name, known = known.join(", "));
                    problems.0.push(message.at(self.file.table.place(i)));
                }
            }
        }
        problems.check()?;
        Ok(roles)
    }

    fn three_points(&self) -> Result<Found> {
        const NAMES: [&str; 6] = ["origin", "x", "xy", "x1", "x2", "y1"];
        let (roles, points) = both(self.roles(&NAMES), coordinates(self.file, ""))?;
        if roles.iter().any(|r| *r < 3) && roles.iter().any(|r| *r >= 3) {
            return Err(error!("cell-roles-mixed").into());
        }
        let first = if roles.iter().any(|r| *r >= 3) { 3 } else { 0 };
        let role = if first == 3 { ThreePointRole::XXY } else { ThreePointRole::OriginXPlane };
        let of = |k: usize| -> Vec<Vector> {
            roles.iter().zip(&points).filter(|(r, _)| **r == first + k).map(|(_, p)| *p).collect()
        };
        let all = [of(0), of(1), of(2)];
        let fit = three_points([&all[0], &all[1], &all[2]], role, self.uncertain.position_mm)
            .map_err(|fault| self.fault(fault))?;
        let mut messages = Vec::new();
        if fit.standard_uncertainty_mm.is_none() {
            messages.push(warning!("cell-no-uncertainty"));
        }
        if let (Some(stated), Some((found, _))) = (self.uncertain.position_mm, fit.repeats)
            && fit.standard_uncertainty_mm != Some(stated)
        {
            messages.push(warning!("cell-noise-larger", found_um = 1000.0 * found));
        }
        Ok(Found {
            frames: vec![frame_entry("object", "points", &fit.frame)],
            region: Region::from_points(&points).with_uncertainty(fit.standard_uncertainty_mm),
            messages,
            ..Found::default()
        })
    }

    fn tool_axes(&self) -> Result<Found> {
        let (roles, written) = both(self.roles(&["tip", "z", "x"]), self.flange())?;
        let role = |r: &usize| [AxisRole::Tip, AxisRole::Z, AxisRole::X][*r];
        let with = |poses: Vec<Pose>| -> Vec<(AxisRole, Pose)> { roles.iter().map(role).zip(poses).collect() };
        let uncertain = Stated { measured_mm: Vec::new(), ..self.uncertain.clone() };
        let poses = written.poses();
        let fit = tool_axes(&with(poses.clone()), &uncertain).map_err(|fault| self.fault(fault))?;
        let own = changes::orientation_changes(&written, "flange")
            .into_iter()
            .chain(changes::axis_changes(&written, "flange"));
        let changes = own.filter_map(|(change, poses)| {
            Some(AlternativeFit { change, quality: tool_axes(&with(poses), &uncertain).ok()?.quality })
        });
        self.refuse_slips(&fit.quality, changes.collect())?;
        Ok(Found {
            frames: vec![frame_entry("tool", "flange", &fit.tool)],
            points: vec![point_entry("fixed", "base", &fit.fixed)],
            region: Region::from_points_and_tool(&positions(&poses), fit.tool.pose.translation_mm),
            messages: judgement::judge_unit(&poses, fit.tool.pose.translation_mm).into_iter().collect(),
            size: Size::from_poses(&poses, fit.tool.pose.translation_mm),
            quality: Some(fit.quality),
            ..Found::default()
        })
    }

    fn axis(&self) -> Result<Found> {
        let prismatic = self.stated.solve == CellKind::LinearAxis;
        let quantity = if prismatic { Quantity::Length } else { Quantity::Angle };
        let values = readings::values(&self.file.table, "axis", quantity).and_then(|found| {
            let column = if prismatic { "axis_mm" } else { "axis_deg" };
            found.ok_or_else(|| error!("cell-axis-missing", column).into())
        });
        let (values, points) = both(values, coordinates(self.file, ""))?;
        let mut targets: Vec<&str> = Vec::new();
        let mut all = Vec::new();
        for (i, (value, position_mm)) in values.iter().zip(points).enumerate() {
            if !value.is_finite() {
                return Err(error!("table-value-missing").at(self.file.table.place(i)).into());
            }
            let name = self.file.table.text(i, "target").unwrap_or_default();
            let target = targets.iter().position(|target| *target == name).unwrap_or_else(|| {
                targets.push(name);
                targets.len() - 1
            });
            all.push(AxisReading { target, value: *value, position_mm });
        }
        if prismatic { self.linear(&all) } else { self.rotary(&all) }
    }

    fn linear(&self, readings: &[AxisReading]) -> Result<Found> {
        let fit = linear_axis(readings, &self.uncertain).map_err(|fault| self.fault(fault))?;
        let points: Vec<Vector> = readings.iter().map(|r| r.position_mm).collect();
        Ok(Found {
            region: Region::from_points(&points),
            axis: Some(CellAxisEntry {
                prismatic: true,
                direction: fit.direction,
                direction_covariance: Some(fit.direction_covariance),
                scale: fit.scale,
                scale_standard_uncertainty: Some(fit.scale_standard_uncertainty),
                radius_mm: None,
            }),
            messages: scale_warning(fit.scale, fit.scale_standard_uncertainty, &fit.quality).into_iter().collect(),
            size: Size::from_points(&points),
            quality: Some(fit.quality),
            ..Found::default()
        })
    }

    /// Rotary axis of values as they are, or without the jumps of a controller that wraps them,
    /// whichever leaves the smaller residuals.
    fn rotary_fit(&self, readings: &[AxisReading]) -> std::result::Result<RotaryAxis, CellFault> {
        let stated = rotary_axis(readings, &self.uncertain);
        let values: Vec<f64> = readings.iter().map(|r| r.value).collect();
        let unwound = Turn::RADIANS.unwound(&values);
        if unwound == values {
            return stated;
        }
        let changed: Vec<AxisReading> =
            readings.iter().zip(unwound).map(|(r, value)| AxisReading { value, ..*r }).collect();
        let deviation = |fit: &RotaryAxis| fit.quality.components.iter().map(|c| c.deviation).fold(0.0, f64::max);
        match (stated, rotary_axis(&changed, &self.uncertain)) {
            (Ok(stated), Ok(unwound)) if deviation(&unwound) < deviation(&stated) => Ok(unwound),
            (Err(_), Ok(unwound)) => Ok(unwound),
            (stated, _) => stated,
        }
    }

    fn rotary(&self, readings: &[AxisReading]) -> Result<Found> {
        let fit = self.rotary_fit(readings).map_err(|fault| self.fault(fault))?;
        let points: Vec<Vector> = readings.iter().map(|r| r.position_mm).collect();
        Ok(Found {
            frames: vec![frame_entry("axis", "points", &fit.frame)],
            region: Region::from_points(&points),
            axis: Some(CellAxisEntry {
                prismatic: false,
                direction: fit.frame.pose.axis(2),
                direction_covariance: None,
                scale: fit.ratio,
                scale_standard_uncertainty: Some(fit.ratio_standard_uncertainty),
                radius_mm: Some(fit.radius_mm),
            }),
            messages: scale_warning(fit.ratio, fit.ratio_standard_uncertainty, &fit.quality).into_iter().collect(),
            size: Size::from_points(&points),
            quality: Some(fit.quality),
            ..Found::default()
        })
    }
}

/// Maximum number of readings by which changes are judged.
const MOST_READINGS: usize = 24;

/// Readings by which changes are judged, evenly over the table.
struct Few {
    rows: Vec<usize>,
    all: usize,
    uncertain: Stated,
}

impl Few {
    fn new(all: usize, uncertain: &Stated) -> Self {
        let count = all.min(MOST_READINGS);
        let rows: Vec<usize> = (0..count).map(|k| k * all / count.max(1)).collect();
        let measured_mm = rows.iter().filter_map(|&i| uncertain.measured_mm.get(i).copied()).collect();
        Self { all, uncertain: Stated { measured_mm, ..uncertain.clone() }, rows }
    }

    fn rows<T: Copy>(&self, of: &[T]) -> Vec<T> {
        if of.len() < self.all { of.to_vec() } else { self.rows.iter().map(|&i| of[i]).collect() }
    }

    /// Residuals of these readings as they are; of all readings if there are few.
    fn quality(&self, of_all: &Quality, solved: impl FnOnce() -> Option<Quality>) -> Quality {
        let own = if self.rows.len() < self.all { solved() } else { None };
        own.unwrap_or_else(|| of_all.clone())
    }
}

/// Residuals after each change that can be solved.
fn explaining<T: Send>(
    changed: Vec<(Phrase, T)>,
    solved: impl Fn(&T) -> Option<Quality> + Sync,
) -> Vec<AlternativeFit<Phrase>> {
    let fits = changed.into_par_iter().filter_map(|(change, input)| {
        let quality = solved(&input)?;
        Some(AlternativeFit { change, quality })
    });
    fits.collect()
}

/// Deviation of the scale of an axis from one that causes no warning, in addition to its
/// uncertainty: errors of racks and belts are smaller, and the scale is part of the answer.
const SCALE: f64 = 0.005;
/// Deviation without an uncertainty: a confusion of units is more than a factor of two.
const SCALE_ALONE: f64 = 1.0;

/// Warning of an axis that moves otherwise than its values say.
fn scale_warning(scale: f64, u: f64, quality: &Quality) -> Option<Message> {
    let of_positions = quality.components.iter().find(|c| c.measure == Measure::Position)?;
    let degrees_of_freedom = if of_positions.agrees { f64::INFINITY } else { of_positions.redundancy };
    let measured = MeasuredRatio { value: scale, standard_uncertainty: u, degrees_of_freedom };
    let differs = match quality.has_uncertainty() {
        true => measured.differs(1.0, SCALE),
        false => {
            let value = scale.max(1.0 / scale.max(f64::MIN_POSITIVE));
            MeasuredRatio { value, standard_uncertainty: 0.0, degrees_of_freedom: f64::INFINITY }
                .differs(1.0, SCALE_ALONE)
        }
    };
    differs.then(|| warning!("cell-scale", scale, u))
}
