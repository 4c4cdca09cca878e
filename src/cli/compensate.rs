//! Command `etalon compensate`.

use super::export::Exported;
use super::kinematics::{cell, joint_names, poses, starts};
use super::{Output, Verdict};
use crate::run::documents::read_field;
use crate::stages::table_file::TableFile;
use crate::stages::uncertainty::bounds::poses_beyond_bound;
use crate::tasks::kinematics::identified;
use crate::tasks::{BoundOption, whole_pose};
use clap::ValueEnum;
use etalon_base::bounds::option_at_most;
use etalon_base::catalogue::Phrase;
use etalon_base::files;
use etalon_base::message::{Message, Place, Problems, Rank, Result, Severity};
use etalon_base::pose::{Pose, minus, norm};
use etalon_base::{error, phrase, warning};
use etalon_controllers::ExportInput;
use etalon_controllers::commands::{
    self, Command, CommandLanguage, Configuration, DECIMALS, Freedoms, Galil, Program, ProgramTarget,
};
use etalon_documents::{CompensatedTarget, CompensationDocument, ParametersDocument, UnreachableTarget, to_json};
use etalon_formats::table::{QUATERNION, XYZ};
use etalon_identify::UncertaintyBound;
use etalon_robots::{Calibrated, Correction, Kinematics};
use std::path::PathBuf;

/// Compute commands with which the identified robot reaches its targets.
///
/// The controller computes with nominal geometry. The pose to command is the pose of the nominal
/// robot at the joint values that bring the identified robot to the target. In a program, only the
/// targets are replaced.
#[derive(Debug, clap::Args)]
#[command(after_help = "Targets:
  table    pose, x_mm, y_mm, z_mm, qw, qx, qy, qz, and joint values that select the solution; or pose and joint values of the nominal
           robot only
  program  RAPID (.mod, .prg), KRL (.src, .dat), URScript (.script), G-code (.ngc, .nc, .gcode), Mecaprol (.mp), Galil (.dmc): printed with
           compensated targets

Exit code 1 if a target is out of reach or in another configuration. A program or list with such a target is not written (exit code 2).")]
pub struct Compensate {
    /// Table of targets (CSV), or a program.
    targets: PathBuf,
    /// Robot file.
    #[arg(long, value_name = "FILE")]
    robot: PathBuf,
    /// Identified parameters: parameters.json of a run.
    #[arg(long, value_name = "FILE")]
    parameters: PathBuf,
    /// Residual field: field.json of the run that identified the parameters.
    #[arg(long, value_name = "FILE")]
    field: Option<PathBuf>,
    /// Format to write; by default a table, or the language of the given program.
    #[arg(long, value_enum)]
    format: Option<Format>,
    #[command(flatten)]
    placement: FrameOptions,
    /// Joint values at the start of a program (mm or deg), followed by the assembly mode; they
    /// select the working mode of a five-bar.
    #[arg(long, value_name = "N,N", value_delimiter = ',', allow_hyphen_values = true)]
    start: Vec<f64>,
    /// Counts of each axis per mm or deg of its joint, for `galil`.
    #[arg(long, value_name = "N,N", value_delimiter = ',', allow_hyphen_values = true)]
    counts_per_unit: Vec<f64>,
    /// Decimals of lengths in mm; other quantities are written with the decimals for the same
    /// resolution.
    #[arg(long, value_name = "N", default_value_t = DECIMALS, value_parser = option_at_most::<17>)]
    decimals: usize,
    #[command(flatten)]
    bound: BoundOption,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

/// Frames of the targets.
#[derive(Clone, Debug, clap::Args)]
struct FrameOptions {
    /// Frame of the targets in a table.
    #[arg(long, value_enum, default_value_t = Frame::Base)]
    frame: Frame,
    /// Tool centre point in the flange (or tool link, platform): x,y,z or x,y,z,qw,qx,qy,qz in mm.
    #[arg(long, value_name = "POSE", value_parser = pose_argument, allow_hyphen_values = true)]
    tool: Option<Pose>,
    /// Frame of the targets (work object) in the robot's base: x,y,z or x,y,z,qw,qx,qy,qz in mm.
    #[arg(long, value_name = "POSE", value_parser = pose_argument, allow_hyphen_values = true)]
    object: Option<Pose>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// Poses to command, joint values and residuals.
    Csv,
    /// Joint values to command.
    Joints,
    /// G-code: X Y Z A B C.
    Gcode,
    /// Galil: positions in counts.
    Galil,
    /// DexTAR: MoveC.
    Mecaprol,
    /// ABB: robtarget.
    Rapid,
    /// KUKA: POS.
    Krl,
    /// Universal Robots: p[...].
    Urscript,
}

impl Format {
    fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

/// Name of the language with targets in counts.
const GALIL: &str = "galil";

/// Frame of the targets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Frame {
    /// Base of the robot, or the frame of `--object`.
    Base,
    /// World of the measurements, in which the base was identified.
    World,
}

/// A target.
struct Target {
    name: String,
    /// Pose of the tool in the frame of the targets.
    pose: Pose,
    /// Joint values near which the target is to be reached.
    near: Option<Vec<f64>>,
    configuration: Option<Configuration>,
}

/// Targets and their origin.
struct Input {
    targets: Vec<Target>,
    program: Option<ProgramSource>,
}

struct ProgramSource {
    language: &'static str,
    bytes: Vec<u8>,
    program: Program,
}

/// A command as a controller carries it out.
struct Executed {
    /// Command as written.
    command: Pose,
    /// Joint values of the controller.
    joints: Vec<f64>,
    /// Pose of the identified robot.
    pose: Pose,
}

/// Converter of targets to commands.
struct Compensator<'a> {
    robot: Calibrated<'a>,
    freedoms: Freedoms,
    /// Frame of the targets in the base, and frame of the commands.
    frames: [Pose; 2],
    tool: Pose,
    format: Format,
    language: Option<(&'static str, &'static dyn CommandLanguage)>,
    galil: Galil,
    /// Joint values at the start.
    start: Vec<f64>,
    decimals: usize,
}

impl Compensate {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let exported = Exported::read(&self.parameters, Some(&self.robot), false, out)?;
        let given = exported.input(false);
        given.check()?;
        let arm = given.robot.map_or_else(|| Err(Problems::default()), whole_pose)?;
        let identified = identified(arm, given.parameters, &self.parameters)?;
        let field = self.field.as_deref().map(|field| read_field(field, &self.parameters)).transpose()?;
        let field = field.map(|field| field.field(arm)).transpose().map_err(Problems::from)?;
        let correction = field.as_ref().map(|field| field as &dyn Correction);
        let robot = Calibrated { arm, nominal: arm.nominal(), identified, field: correction };
        let source = self.read(&robot)?;
        let written = source.program.as_ref().map_or("csv", |program| program.language);
        let format = self.format.map_or_else(|| Format::from_str(written, false), Ok).map_err(anyhow::Error::msg)?;
        let compensator = self.compensator(robot, format)?;
        let (commands, answer) = compensator.answer(&source.targets);
        let changed = answer.targets.iter().filter(|t| !t.same_configuration);
        let changed = changed.map(|t| error!("configuration-changed", target = t.target));
        let refused: Vec<Message> = answer.unreachable.iter().map(unreachable).chain(changed).collect();
        let uncertain = compensator.beyond_bound(given.parameters, &answer, self.bound.stated()?);
        let data = match (self.json, format, &source.program) {
            (true, ..) => to_json(&answer)?,
            (_, Format::Csv | Format::Joints, _) => csv(&answer, format).into_bytes(),
            _ => {
                let refused = refused.iter().cloned();
                let refused = refused.map(|m| Message { severity: Severity::Error, rank: Rank::Decide, ..m });
                Problems(refused.collect()).check()?;
                compensator.program(&given, &commands, &answer, source.program.as_ref())?
            }
        };
        out.remark(&refused);
        out.remark(&compensator.beyond_field(&answer).into_iter().collect::<Vec<_>>());
        out.remark(uncertain.as_slice());
        if compensator.language.is_some_and(|(_, language)| language.is_calibrated()) {
            out.remark(&[warning!("controller-calibrated", robot = self.robot.display().to_string())]);
        }
        if let Some(ProgramSource { program, .. }) = &source.program {
            out.say(phrase!("targets-compensated", count = answer.targets.len(), left = program.joint_targets));
            if !program.computed.is_empty() {
                let names: Vec<&String> = program.computed.iter().collect();
                out.remark(&[warning!("poses-computed-by-program", names)]);
            }
        }
        out.print_with(data, Verdict::new(refused.is_empty() && uncertain.is_none()))
    }

    /// Reads the targets of the table or program.
    fn read(&self, robot: &Calibrated) -> Result<Input> {
        let ending = self.targets.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        match commands::language_by_extension(ending) {
            Some((name, language)) => {
                if self.start.is_empty() && robot.arm.has_assembly_modes() {
                    return Err(error!("working-mode-missing").into());
                }
                self.read_program(name, language, freedoms(robot.arm))
            }
            None if ending.eq_ignore_ascii_case("dmc") => self.read_galil(robot),
            None => self.read_table(robot),
        }
    }

    fn read_program(&self, name: &'static str, language: &dyn CommandLanguage, freedoms: Freedoms) -> Result<Input> {
        let bytes = files::read(&self.targets)?;
        let text = String::from_utf8_lossy(&bytes);
        let found = language.targets(&bytes, freedoms);
        let program = found.map_err(|problems| problems.in_text(&self.targets.display().to_string(), &text))?;
        self.check_frames(&program)?;
        if self.placement.frame == Frame::World {
            return Err(error!("program-in-world").into());
        }
        let target = |t: &ProgramTarget| Target {
            name: t.name.clone(),
            pose: language.pose(&t.numbers, freedoms),
            near: None,
            configuration: t.configuration,
        };
        let targets = program.targets.iter().map(target).collect();
        Ok(Input { targets, program: Some(ProgramSource { language: name, bytes, program }) })
    }

    /// Rejects a program whose tool or work object is unknown or changes, or whose tool differs
    /// from the option. Frames of a program may be relative to a world in which the base is not at
    /// the origin.
    fn check_frames(&self, program: &Program) -> Result<()> {
        let place = Place::file(self.targets.display().to_string());
        for (option, stated, names) in
            [("tool", self.placement.tool, &program.tools), ("object", self.placement.object, &program.objects)]
        {
            let all: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            let known = names.first().filter(|_| names.len() == 1).and_then(|name| program.known.get(name));
            let is_null = known.is_some_and(|pose| is_same(pose, &Pose::identity()));
            if all.len() > 1 || (all.len() == 1 && stated.is_none() && !is_null) {
                let hint = match all.len() {
                    1 => phrase!("state-pose-option", option),
                    _ => phrase!("one-program-each"),
                };
                return Err(error!("program-frames", names = all).at(place).hint(hint).into());
            }
            let other = known.zip(stated).filter(|(known, stated)| option == "tool" && !is_same(known, stated));
            if let Some((known, _)) = other {
                let (frame, pose) = (all.concat(), pose_text(known));
                return Err(error!("program-frame-other", frame, option, pose).at(place).into());
            }
        }
        Ok(())
    }

    /// Reads positions of a Galil program: joint values commanded to the nominal robot.
    fn read_galil(&self, robot: &Calibrated) -> Result<Input> {
        let bytes = files::read(&self.targets)?;
        let text = String::from_utf8_lossy(&bytes);
        let galil = self.galil(robot)?;
        let found = galil.targets(&bytes);
        let program = found.map_err(|problems| problems.in_text(&self.targets.display().to_string(), &text))?;
        let target = |t: &ProgramTarget| -> Result<Target> {
            let mut joints = self.start(robot);
            let stated = robot.arm.joints().iter().zip(galil.joints(&t.numbers));
            joints.iter_mut().zip(stated).for_each(|(q, (joint, v))| *q = joint.quantity.inward(v));
            let pose = self.nominal_pose(robot, &joints)?;
            Ok(Target { name: t.name.clone(), pose, near: Some(joints), configuration: None })
        };
        let targets = program.targets.iter().map(target).collect::<Result<_>>()?;
        Ok(Input { targets, program: Some(ProgramSource { language: GALIL, bytes, program }) })
    }

    /// Joint values at the start of a program (rad or mm); zero by default.
    fn start(&self, robot: &Calibrated) -> Vec<f64> {
        let joints = robot.arm.joints();
        let value = |(i, v): (usize, &f64)| joints.get(i).map_or(*v, |joint| joint.quantity.inward(*v));
        let mut all: Vec<f64> = self.start.iter().enumerate().map(value).collect();
        all.resize(joints.len() + usize::from(robot.arm.has_assembly_modes()), 0.0);
        all
    }

    fn galil(&self, robot: &Calibrated) -> Result<Galil> {
        let axes = robot.arm.joints().len();
        if self.counts_per_unit.len() != axes || self.counts_per_unit.contains(&0.0) {
            return Err(error!("counts-missing", axes).into());
        }
        Ok(Galil { counts_per_unit: self.counts_per_unit.clone() })
    }

    fn read_table(&self, robot: &Calibrated) -> Result<Input> {
        let file = TableFile::read(&self.targets)?;
        let read = || -> Result<Vec<Target>> {
            let names = file.table.poses()?;
            let near = starts(robot.arm, &file)?;
            let stated = match (&near, file.table.has(XYZ[0])) {
                (Some(joints), false) => joints.iter().map(|q| self.nominal_pose(robot, q)).collect::<Result<_>>()?,
                _ => poses(robot.arm, &file)?,
            };
            let near = near.map_or_else(|| vec![None; names.len()], |all| all.into_iter().map(Some).collect());
            let all = names.into_iter().zip(stated).zip(near);
            Ok(all
                .map(|((name, pose), near)| Target { name: name.to_string(), pose, near, configuration: None })
                .collect())
        };
        Ok(Input { targets: read().map_err(|problems| file.place(problems))?, program: None })
    }

    /// Pose of the nominal robot's tool in the frame of the targets.
    fn nominal_pose(&self, robot: &Calibrated, joints: &[f64]) -> Result<Pose> {
        if self.placement.frame == Frame::World {
            return Err(error!("joints-in-world").into());
        }
        let flange = robot.arm.tool_pose(&robot.nominal, joints);
        let flange = flange.ok_or_else(|| error!("nominal-pose-unreachable"))?;
        Ok(self
            .placement
            .object
            .unwrap_or(Pose::identity())
            .inverse()
            .then(&flange)
            .then(&self.placement.tool.unwrap_or(Pose::identity())))
    }

    fn compensator<'a>(&self, robot: Calibrated<'a>, format: Format) -> Result<Compensator<'a>> {
        let freedoms = freedoms(robot.arm);
        let object = self.placement.object.unwrap_or(Pose::identity());
        let targets_in_base = match self.placement.frame {
            Frame::Base => object,
            Frame::World => {
                let base = robot.arm.base_in_world(&robot.identified);
                base.ok_or_else(|| error!("base-not-in-world", model = robot.arm.model()))?.inverse()
            }
        };
        let galil = (format == Format::Galil).then(|| self.galil(&robot)).transpose()?.unwrap_or_default();
        let start = self.start(&robot);
        if format == Format::Mecaprol && freedoms != Freedoms::Point {
            return Err(error!("mecaprol-other-robot", model = robot.arm.model()).into());
        }
        let language = commands::language(&format.name());
        let tool = self.placement.tool.unwrap_or(Pose::identity());
        let frames = [targets_in_base, object];
        Ok(Compensator { robot, freedoms, frames, tool, format, language, galil, start, decimals: self.decimals })
    }
}

impl Compensator<'_> {
    /// Commands of the reachable targets, and the document.
    fn answer(&self, targets: &[Target]) -> (Vec<Command>, CompensationDocument) {
        let arm = self.robot.arm;
        let mut document = CompensationDocument {
            schema: "etalon/compensation/1".to_owned(),
            robot: arm.model().to_owned(),
            joints: joint_names(arm),
            targets: Vec::new(),
            unreachable: Vec::new(),
            joint_targets: 0,
        };
        let (mut commands, mut last) = (Vec::new(), self.start.clone());
        for target in targets {
            match self.target(target, &mut last) {
                Ok((command, entry)) => {
                    commands.push(Command { name: target.name.clone(), pose: command });
                    document.targets.push(entry);
                }
                Err(reason) => {
                    document.unreachable.push(UnreachableTarget { target: target.name.clone(), reason: reason.into() });
                }
            }
        }
        (commands, document)
    }

    /// Returns an error about the command with the largest uncertainty of the attained pose, if it
    /// exceeds its bound.
    fn beyond_bound(
        &self,
        document: &ParametersDocument,
        answer: &CompensationDocument,
        bound: UncertaintyBound,
    ) -> Option<Message> {
        let joints = self.robot.arm.joints();
        let inward = |t: &CompensatedTarget| {
            let value = |(i, q): (usize, &f64)| joints.get(i).map_or(*q, |joint| joint.quantity.inward(*q));
            (t.target.clone(), t.joints.iter().enumerate().map(value).collect::<Vec<f64>>())
        };
        let all: Vec<_> = answer.targets.iter().map(inward).collect();
        poses_beyond_bound(self.robot.arm, document, &self.robot.identified, &all, bound)
    }

    /// Returns a warning if targets are beyond the field, where it fades out.
    fn beyond_field(&self, answer: &CompensationDocument) -> Option<Message> {
        let (field, joints) = (self.robot.field?, self.robot.arm.joints());
        let inward = |t: &&CompensatedTarget| {
            let q: Vec<f64> = joints.iter().zip(&t.joints).map(|(joint, q)| joint.quantity.inward(*q)).collect();
            field.share(&q) < 1.0
        };
        let beyond: Vec<&String> = answer.targets.iter().filter(inward).map(|t| &t.target).collect();
        (!beyond.is_empty()).then(|| warning!("targets-beyond-field", count = beyond.len(), targets = beyond))
    }

    /// Command for a target in the controller's form; `last` holds the joint values before the
    /// motion.
    fn target(&self, target: &Target, last: &mut Vec<f64>) -> std::result::Result<(Pose, CompensatedTarget), Phrase> {
        let [targets, commands] = self.frames;
        let mut wanted = targets.then(&target.pose).then(&self.tool.inverse());
        if self.freedoms == Freedoms::Point {
            wanted = Pose { translation_mm: wanted.translation_mm, ..Pose::identity() };
        }
        let (arm, near) = (self.robot.arm, target.near.as_ref().unwrap_or(last));
        let from = self.configured(&wanted, target.configuration, near);
        let from = from.map_or_else(|| self.robot.uncompensated(&wanted, near), Ok)?;
        let found = self.robot.compensate(&wanted, &from)?;
        let deg = |q: &[f64]| -> Vec<f64> { arm.joints().iter().zip(q).map(|(j, &q)| j.quantity.outward(q)).collect() };
        let seen = commands.inverse().then(&found.command).then(&self.tool);
        let Executed { command, joints, pose: attained } = self.carried_out(&seen, &found.joints, &from)?;
        // the command as written, and the joint values in it, give the configuration
        let kept = target.configuration.is_none_or(|c| c.fits(&deg(&joints)) || !c.fits(&deg(&from)));
        let same_configuration =
            kept && [&joints, &found.joints].iter().all(|to| self.robot.same_configuration(&from, to));
        let angle = if self.freedoms == Freedoms::Point { 0.0 } else { wanted.inverse().then(&attained).angle_rad() };
        let modes = found.joints.get(arm.joints().len()).copied();
        last.clone_from(&found.joints);
        Ok((
            seen,
            CompensatedTarget {
                target: target.name.clone(),
                xyz_mm: target.pose.translation_mm,
                quaternion: target.pose.quaternion(),
                command_xyz_mm: command.translation_mm,
                command_quaternion: command.quaternion(),
                joints: deg(&found.joints).into_iter().chain(modes).collect(),
                residual_mm: norm(minus(attained.translation_mm, wanted.translation_mm)),
                residual_deg: angle.to_degrees(),
                same_configuration,
            },
        ))
    }

    /// Nearest joint values of the nominal robot with the configuration data of a target.
    fn configured(&self, wanted: &Pose, configuration: Option<Configuration>, near: &[f64]) -> Option<Vec<f64>> {
        let (configuration, arm, nominal) = (configuration?, self.robot.arm, &self.robot.nominal);
        let distance = |q: &[f64]| q.iter().zip(near).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        let fits = |q: &Vec<f64>| configuration.fits(&q.iter().map(|q| q.to_degrees()).collect::<Vec<_>>());
        let all = arm.all_joints(nominal, wanted).into_iter().filter(fits);
        let within = all.filter(|q| arm.limit_violation(nominal, q).is_none());
        within.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// Execution of a command as written by a controller at the joint values `from`; `joints` are
    /// the joint values of the command.
    fn carried_out(&self, command: &Pose, joints: &[f64], from: &[f64]) -> std::result::Result<Executed, Phrase> {
        // the pose of a redundant arm does not determine its joints: they are commanded too
        let from = if self.robot.arm.joints().len() > 6 { joints } else { from };
        let units = |q: &[f64], out: bool| -> Vec<f64> {
            let joint = |(i, &q): (usize, &f64)| match self.robot.arm.joints().get(i) {
                Some(joint) if out => joint.quantity.outward(q),
                Some(joint) => joint.quantity.inward(q),
                None => q,
            };
            q.iter().enumerate().map(joint).collect()
        };
        match (self.format, self.language) {
            (Format::Galil, _) => {
                let mut rounded = units(&self.galil.joints(&self.galil.counts(&units(joints, true))), false);
                rounded.extend(joints.get(rounded.len()));
                self.executed(*command, rounded)
            }
            (Format::Joints, _) => self.executed(*command, joints.to_vec()),
            (_, Some((_, language))) => {
                let numbers = commands::written(language, command, self.freedoms, self.decimals);
                let command = commands::stated(language, &numbers, self.freedoms);
                self.executed(command, self.commanded(&command, from)?)
            }
            _ => self.executed(*command, self.commanded(command, from)?),
        }
    }

    fn executed(&self, command: Pose, joints: Vec<f64>) -> std::result::Result<Executed, Phrase> {
        let pose = self.robot.at_joints(&joints)?;
        Ok(Executed { command, joints, pose })
    }

    /// Joint values of the controller at the joint values `from`.
    fn commanded(&self, command: &Pose, from: &[f64]) -> std::result::Result<Vec<f64>, Phrase> {
        self.robot.commanded(&self.frames[1].then(command).then(&self.tool.inverse()), from)
    }

    /// Program with new targets, or list of commands.
    fn program(
        &self,
        given: &ExportInput,
        commands: &[Command],
        answer: &CompensationDocument,
        source: Option<&ProgramSource>,
    ) -> Result<Vec<u8>> {
        let Some((name, language)) = self.language else {
            if let Some(ProgramSource { bytes, program, .. }) = source.filter(|source| source.language == GALIL) {
                let counts = answer.targets.iter().map(|t| self.galil.counts(&t.joints));
                let counts: Vec<Vec<String>> = counts.map(|all| all.iter().map(f64::to_string).collect()).collect();
                return Ok(stating(given, '\'', commands::rewritten(bytes, &program.targets, &counts)));
            }
            let joints = answer.targets.iter().map(|t| (t.target.clone(), t.joints.clone()));
            return self.galil.list(given, &joints.collect::<Vec<_>>()).map(String::into_bytes);
        };
        match source.filter(|source| source.language == name) {
            Some(ProgramSource { bytes, program, .. }) => {
                let written = |c: &Command| commands::written(language, &c.pose, self.freedoms, self.decimals);
                let numbers: Vec<Vec<String>> = commands.iter().map(written).collect();
                let new = commands::rewritten(bytes, &program.targets, &numbers);
                Ok(stating(given, language.comment_mark(), new))
            }
            None => commands::list(language, given, commands, self.freedoms, self.decimals).map(String::into_bytes),
        }
    }
}

fn freedoms(arm: &dyn Kinematics) -> Freedoms {
    match arm.dimension() {
        2 if arm.platform().is_none() => Freedoms::Point,
        2 => Freedoms::Plane,
        _ => Freedoms::Space,
    }
}

fn unreachable(target: &UnreachableTarget) -> Message {
    warning!("target-unreachable", target = target.target, reason = target.reason)
}

/// Program with a comment, which begins with `mark`, if the parameters are synthetic.
fn stating(given: &ExportInput, mark: char, program: Vec<u8>) -> Vec<u8> {
    match given.synthetic() {
        Some(why) => commands::with_comment(&program, mark, &why),
        None => program,
    }
}

/// `true` if two poses are equal within the digits that people write.
fn is_same(a: &Pose, b: &Pose) -> bool {
    norm(minus(a.translation_mm, b.translation_mm)) < 1e-3 && a.inverse().then(b).angle_rad() < 1e-5
}

/// Text of a pose that [`pose_argument`] parses.
fn pose_text(pose: &Pose) -> String {
    let numbers = pose.translation_mm.into_iter().chain(pose.quaternion());
    numbers.map(|v| format!("{}", (v * 1e9).round() / 1e9 + 0.0)).collect::<Vec<_>>().join(",")
}

/// Parses x,y,z or x,y,z,qw,qx,qy,qz.
fn pose_argument(text: &str) -> std::result::Result<Pose, String> {
    let numbers: Vec<f64> =
        text.split(',').filter_map(|v| v.trim().parse().ok()).filter(|v: &f64| v.is_finite()).collect();
    match (numbers[..].len() == text.split(',').count()).then_some(&numbers[..]) {
        Some(&[x, y, z]) => Ok(Pose { translation_mm: [x, y, z], ..Pose::identity() }),
        Some(&[x, y, z, ref q @ ..]) if q.len() == 4 && (norm([q[0].hypot(q[1]), q[2], q[3]]) - 1.0).abs() < 1e-3 => {
            Ok(Pose { translation_mm: [x, y, z], ..Pose::from_quaternion([q[0], q[1], q[2], q[3]]) })
        }
        _ => Err(phrase!("pose-argument-expected").to_string()),
    }
}

/// Answer as a table: commands with joint values, or joint values only.
fn csv(document: &CompensationDocument, format: Format) -> String {
    let poses = XYZ.iter().chain(&QUATERNION).filter(|_| format == Format::Csv);
    let columns = poses.copied().chain(document.joints.iter().map(String::as_str));
    let columns = columns.chain(["residual_mm", "residual_deg", "same_configuration"]);
    let mut out = format!("pose,{}\n", columns.collect::<Vec<_>>().join(","));
    for t in &document.targets {
        let pose = t.command_xyz_mm.iter().chain(&t.command_quaternion).filter(|_| format == Format::Csv);
        let numbers = pose.chain(&t.joints).chain([&t.residual_mm, &t.residual_deg]);
        let numbers: Vec<String> = numbers.map(|v| format!("{v:?}")).collect();
        out += &format!("{},{},{}\n", cell(&t.target), numbers.join(","), t.same_configuration);
    }
    out
}
