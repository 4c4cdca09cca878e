//! Robots in space as a single chain: base, targets, and the parameters of the chain in any
//! convention.
//!
//! A convention pushes its motions and parameters into an [`ArmBuilder`]; gains, coupling and
//! bending are common to all conventions.

use super::chain::{self, Coefficient, Element, Motion, Prepared, TURNED_MM, Term};
use super::tables::{AxisLine, TableConvention, error_axes, link_frames};
use super::{
    AXES, ChainJoint, Circumstance, Definition, Effect, FreeBase, Joint, JointChain, JointRange, Kinematics, Loads,
    OptionalParameter, Outline, Parameter, Parametrised, Quantity, Robot, Role, State, base_and_targets, meaning,
    pose_outputs,
};
use super::{limit_violation, normal_equations, square};
use etalon_base::catalogue::Phrase;
use etalon_base::expression::{Formula, Recorded, derivatives};
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm};
use etalon_base::scalar::Scalar;
use etalon_base::sketch::{Sketch, StrokeKind};
use nalgebra::{Matrix6, Vector6};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

/// Mass of the links between a joint and the next joint, and its centre in the frame that the joint
/// moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Body {
    pub mass_kg: f64,
    pub center_mm: Vector,
}

/// Names of a joint, and the joint value that moves it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Drive {
    /// Number or name in the names of gains.
    pub label: String,
    /// Name in the names of small errors.
    pub name: String,
    /// Index of the joint value that moves it by factor · value + offset.
    pub joint: usize,
    pub factor: f64,
    /// Offset (rad or mm).
    pub offset: f64,
    pub prismatic: bool,
    /// `true` if the joint value follows from another joint, which this joint mimics.
    pub mimics: bool,
}

/// Non-geometric effects of joints, by their indices, and direction of gravity in the base frame.
#[derive(Debug, Default)]
pub(super) struct Effects {
    pub gravity: Vector,
    pub bending: Vec<usize>,
    pub coupling: Vec<(usize, usize)>,
    pub harmonics: Vec<usize>,
    pub backlash: Vec<usize>,
    pub payload: Vec<usize>,
    pub torque: Vec<usize>,
    pub thermal: ThermalEffects,
    pub lateral: Vec<usize>,
    /// `true` if the base tilts under the moments of the arm.
    pub pedestal: bool,
    /// Given masses of the links behind the joints; empty if none is given.
    pub bodies: Vec<Body>,
}

/// Effects of the temperature.
#[derive(Clone, Debug, Default)]
pub(super) struct ThermalEffects {
    /// Joints whose zeros drift with the temperature, by their indices.
    pub drift: Vec<usize>,
    /// `true` if all lengths expand with the temperature.
    pub expansion: bool,
    /// Temperature (°C) to which lengths and zeros refer.
    pub reference_c: f64,
}

/// A moving joint of the chain.
#[derive(Clone, Debug)]
struct Axis {
    drive: Drive,
    /// Element that the joint moves.
    element: usize,
    /// Position of the joint value among the terms of the element.
    at: usize,
    /// Number of elements up to the frame behind the joint, whose z axis is the axis of the joint.
    frame: usize,
    /// Transformation from the frame of the joint to the frame behind it.
    aligned: Pose,
    /// Frame of the link ([`link_frames`]) in the frame behind the joint: levers start at its
    /// origin, and tilts are about its axes.
    link: Pose,
    body: Body,
    /// Index of the gain.
    gain: Option<usize>,
}

/// Source of the bending moment at a joint.
#[derive(Clone, Copy, Debug)]
enum Load {
    /// Weight of a link about an axis, as a fraction of its maximum: 1 if the link is level. The
    /// link is the line from the origin of its frame to the origin of the next one. Axes are given
    /// by index.
    Link { axis: usize, link: usize },
    /// Moment of all masses beyond an axis about a direction of the frame that the axis moves, as a
    /// fraction of its maximum: 1 if the arm is stretched out level.
    Moment { axis: usize, about: Vector, largest_kg_mm: f64 },
    /// Moment of the payload of a reading about an axis, in multiples of 100 N·m.
    Payload { axis: usize },
    /// Moment of masses beyond an axis and of the payload about direction 0, 1 or 2 of the frame of
    /// the link that the axis moves, in multiples of 100 N·m; without an axis, the moment of all
    /// masses about a direction of the base.
    Across { axis: Option<usize>, about: usize },
}

/// Standard gravity (3rd CGPM 1901), in multiples of 100 N·m for a mass of 1 kg on a lever of 1 mm.
const PAYLOAD: f64 = 9.806_65e-5;

/// Length (mm) of a link below which it has no direction.
const SHORTEST_MM: f64 = 1e-6;

/// Torque in multiples of 100 N·m, per N·m.
const PER_TORQUE: f64 = 0.01;
/// Difference of temperature in multiples of 10 K, per kelvin.
const PER_KELVIN: f64 = 0.1;
/// Share of gravity along an axis of the base at which no moment acts about the axis.
const ALONG: f64 = 1.0 - 1e-9;
/// Ratio of lengths for an expansion of 1 mm per metre and kelvin, per kelvin.
const EXPANDED: f64 = 1e-3;

const GAIN: &str = meaning("meaning-gain");
const BENDING: &str = meaning("meaning-bending");
const COUPLING: &str = meaning("meaning-coupling");
const HARMONIC: &str = meaning("meaning-harmonic");
const BACKLASH: &str = meaning("meaning-backlash");
const BY_PAYLOAD: &str = meaning("meaning-payload");
const BY_TORQUE: &str = meaning("meaning-torque");
const EXPANSION: &str = meaning("meaning-expansion");
const DRIFT: &str = meaning("meaning-drift");
const LATERAL: &str = meaning("meaning-lateral");
const PEDESTAL: &str = meaning("meaning-pedestal");
const TILT: &str = meaning("meaning-axis-rotation");
const ASIDE: &str = meaning("meaning-axis-displacement");

/// Orders of harmonics, endings of their names, and `true` for a sine.
const ORDERS: [(f64, &str, bool); 4] =
    [(1.0, "sin1", true), (1.0, "cos1", false), (2.0, "sin2", true), (2.0, "cos2", false)];

fn harmonic_name(label: &str, part: &str) -> String {
    format!("harmonic_{label}_{part}")
}

fn backlash_name(label: &str) -> String {
    format!("backlash_{label}")
}

/// Name of the compliance about an axis: under a link, or of the joint itself.
fn compliance_name(label: &str, by: Option<&str>) -> String {
    by.map_or_else(|| format!("compliance_{label}"), |by| format!("compliance_{label}_{by}"))
}

fn coupling_name(label: &str, by: &str) -> String {
    format!("coupling_{label}_{by}")
}

/// Small error of an axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallError {
    pub motion: Motion,
    /// Parameter; `None` if another axis has the same error.
    pub parameter: Option<usize>,
}

/// Parameter of an effect at a joint, with nominal value zero.
fn joint_error(name: String, quantity: Quantity, effect: Effect, joint: usize) -> Parameter {
    let meaning = match effect {
        Effect::Harmonics => HARMONIC,
        Effect::Backlash => BACKLASH,
        Effect::Coupling => COUPLING,
        Effect::Payload => BY_PAYLOAD,
        Effect::Torque => BY_TORQUE,
        Effect::Drift => DRIFT,
        Effect::Lateral => LATERAL,
        _ => BENDING,
    };
    let own = Parameter::new(name, quantity, Role::Robot, 0.0).meaning(meaning).with_joint(joint);
    Parameter { effect, ..own }
}

/// Scale of a joint value.
#[derive(Clone, Copy, Debug)]
pub(super) struct JointScale {
    /// Joint value that moves the axis by 1 rad or 1 m.
    pub unit: f64,
    /// Joint value of a full turn; `None` if the joint slides or moves several axes.
    pub turn: Option<f64>,
    /// Finite limits (rad or mm).
    pub limits: Option<[f64; 2]>,
}

/// Builder of a chain: collects motions and parameters, starting with base and targets.
#[derive(Debug)]
pub(super) struct ArmBuilder {
    parameters: Vec<Parameter>,
    elements: Vec<Element>,
    axes: Vec<Axis>,
    loads: Vec<Load>,
    /// Number of elements of the base.
    based: usize,
    targets: Vec<String>,
    /// Terms of each axis in addition to its gain.
    moved: Vec<Vec<Term>>,
    /// Joints with direction of approach.
    approached: Vec<usize>,
    /// Values that each reading gives; they follow the directions of approach.
    circumstances: Vec<Circumstance>,
    /// Term of the common expansion of all lengths.
    expansion: Option<Term>,
    lateral: LateralCompliance,
    /// Number of parameters that other branches of the robot have already added.
    shared: usize,
}

/// Axes and base that tilt across their direction of motion.
#[derive(Debug, Default)]
struct LateralCompliance {
    /// Axes that tilt, by their indices.
    tilting: Vec<usize>,
    /// First of the two elements by which each of these axes tilts. The elements before and behind
    /// the two lead to the frame of the link and back.
    tilts: Vec<(usize, usize)>,
    /// Sliding axes that tilt under masses, by their indices.
    sagging: Vec<usize>,
    /// First of the two elements by which each of these axes tilts, between elements that lead to
    /// the frame of the link and back.
    sags: Vec<(usize, usize)>,
    /// First of the three elements by which the base tilts.
    pedestal: Option<usize>,
}

impl ArmBuilder {
    /// Creates a chain that starts with its base and carries the targets.
    pub fn new(targets: &[String]) -> Self {
        let mut arm = Self {
            parameters: base_and_targets(targets),
            elements: Vec::new(),
            axes: Vec::new(),
            loads: Vec::new(),
            based: 0,
            targets: targets.to_vec(),
            moved: Vec::new(),
            approached: Vec::new(),
            circumstances: Vec::new(),
            expansion: None,
            lateral: LateralCompliance::default(),
            shared: 0,
        };
        arm.place_base();
        arm
    }

    /// Starts another branch of the same robot. Both branches share the parameters, the directions
    /// of approach of their common joints, and what each reading gives.
    pub fn branch(&self) -> Self {
        let mut branch = Self::new(&self.targets);
        branch.parameters = self.parameters.clone();
        branch.approached = self.approached.clone();
        branch.circumstances = self.circumstances.clone();
        branch.shared = self.parameters.len();
        branch
    }

    /// Takes over the parameters, the directions of approach and the values of each reading of the
    /// last branch.
    pub fn complete(&mut self, last: &Self) {
        self.parameters = last.parameters.clone();
        self.approached = last.approached.clone();
        self.circumstances = last.circumstances.clone();
    }

    /// Adds the motions of the base.
    fn place_base(&mut self) {
        for axis in 0..3 {
            self.push(Motion::Shift(axis), 0.0, &[axis]);
        }
        (0..3).for_each(|axis| self.push(Motion::Attitude(axis), 0.0, &[3 + axis]));
        self.based = self.elements.len();
    }

    /// Prepares the tilts of axes and base; to be called before the first axis is added.
    pub fn elastic(&mut self, effects: &Effects) {
        self.lateral.tilting.clone_from(&effects.lateral);
        if effects.pedestal {
            self.lateral.pedestal = Some(self.elements.len());
            (0..3).for_each(|axis| self.push(Motion::Turn(axis), 0.0, &[]));
        }
    }

    /// Prepares the tilts of sliding axes under masses; to be called before the first axis is
    /// added.
    pub fn sag(&mut self, axes: &[usize]) {
        self.lateral.sagging = axes.to_vec();
    }

    /// Adds the tilts of the last axis at the frame of its link; the current frame is the frame
    /// behind the axis.
    pub fn tilt(&mut self) {
        let axis = self.axes.len() - 1;
        if self.lateral.tilting.contains(&axis) {
            let first = self.turns_at_link([0, 1]);
            self.lateral.tilts.push((axis, first));
        }
    }

    /// Adds rotations about two axes at the frame of a link, which [`Self::settle_links`] places
    /// when all axes are known, and returns the element of the first rotation.
    fn turns_at_link(&mut self, about: [usize; 2]) -> usize {
        self.push(Motion::Fixed(Pose::identity()), 0.0, &[]);
        about.into_iter().for_each(|k| self.push(Motion::Turn(k), 0.0, &[]));
        self.push(Motion::Fixed(Pose::identity()), 0.0, &[]);
        self.elements.len() - 3
    }

    /// [`nominal_axes`] of the axes so far.
    fn nominal_axes(&self) -> (Vec<AxisLine>, Vec<Pose>, Pose) {
        nominal_axes(&self.elements, self.based, &self.axes, &self.parameters)
    }

    /// Origins of the link frames in the base frame at joint values zero.
    pub fn link_origins(&self) -> Vec<Vector> {
        let (axes, _, flange) = self.nominal_axes();
        link_frames(&axes, &flange).iter().map(|frame| frame.translation_mm).collect()
    }

    /// Places the frames of the links, and the tilts at them; to be called when all axes are known.
    fn settle_links(&mut self) {
        let (lines, frames, flange) = self.nominal_axes();
        let springs = self.springs();
        settle(&mut self.elements, &mut self.axes, &springs, &links_behind(&lines, &frames, &flange));
    }

    /// All rotations at frames of links.
    fn springs(&self) -> Vec<Spring> {
        let spring = |at_axes| move |&(axis, first): &(usize, usize)| Spring { axis, first, at_axes };
        self.lateral.tilts.iter().map(spring(true)).chain(self.lateral.sags.iter().map(spring(false))).collect()
    }

    /// Adds the parameters of the tilts: angles under 100 N·m about the same direction. Known
    /// masses and the payload cause the moment; without known masses, the payload alone.
    pub fn tilts(&mut self, gravity: Vector) {
        if self.lateral.tilts.is_empty() && self.lateral.pedestal.is_none() {
            return;
        }
        if self.axes.iter().all(|axis| axis.body.mass_kg == 0.0) {
            self.stated_payload();
        }
        for (axis, first) in self.lateral.tilts.clone() {
            let Drive { label, joint, .. } = self.axes[axis].drive.clone();
            for (k, about) in AXES.iter().enumerate().take(2) {
                let name = format!("lateral_{label}_{about}");
                let own = joint_error(name, Quantity::Angle, Effect::Lateral, joint);
                self.bend(first + k, own, Load::Across { axis: Some(axis), about: k });
            }
        }
        let Some(first) = self.lateral.pedestal else { return };
        // gravity has no moment about its own direction
        for k in (0..3).filter(|&k| gravity[k].abs() < ALONG) {
            let own = Parameter::new(format!("pedestal_{}", AXES[k]), Quantity::Angle, Role::Robot, 0.0);
            let own = Parameter { effect: Effect::Pedestal, ..own.meaning(PEDESTAL) };
            self.bend(first + k, own, Load::Across { axis: None, about: k });
        }
    }

    /// Lets an element turn by a parameter times a load.
    fn bend(&mut self, element: usize, own: Parameter, load: Load) {
        let parameter = self.add(own);
        self.loads.push(load);
        let coefficient = Coefficient::Load(self.loads.len() - 1);
        self.elements[element].terms.push(Term { parameter, coefficient });
    }

    /// Adds a parameter, unless another branch has it, and returns its index.
    pub fn add(&mut self, parameter: Parameter) -> usize {
        if let Some(known) = self.parameters[..self.shared].iter().position(|p| *p == parameter) {
            return known;
        }
        self.parameters.push(parameter);
        self.parameters.len() - 1
    }

    /// Adds a motion by `constant` + Σ parameters.
    pub fn push(&mut self, motion: Motion, constant: f64, parameters: &[usize]) {
        let terms = parameters.iter().copied().map(Term::new).collect();
        self.elements.push(Element { motion, constant, terms });
    }

    /// Adds the inverse motion of a small error.
    pub fn push_back(&mut self, error: &SmallError) {
        let term = |parameter| Term { parameter, coefficient: Coefficient::Constant(-1.0) };
        let terms = error.parameter.map(term).into_iter().collect();
        self.elements.push(Element { motion: error.motion, constant: 0.0, terms });
    }

    /// Adds a constant displacement; consecutive displacements are merged.
    pub fn place(&mut self, place: Pose) {
        match self.elements.last_mut().map(|e| &mut e.motion) {
            Some(Motion::Fixed(last)) => *last = last.then(&place),
            _ if place == Pose::identity() => {}
            _ => self.push(Motion::Fixed(place), 0.0, &[]),
        }
    }

    /// Makes a joint move the last element; `first` puts the joint value before the other terms.
    pub fn drive(&mut self, drive: Drive, first: bool) {
        let element = self.elements.len() - 1;
        let at = if first { 0 } else { self.elements[element].terms.len() };
        self.axes.push(Axis {
            drive,
            element,
            at,
            frame: element + 1,
            aligned: Pose::identity(),
            link: Pose::identity(),
            body: Body::default(),
            gain: None,
        });
        self.moved.push(Vec::new());
    }

    /// Declares the current frame to be the frame after the last axis.
    pub fn frame(&mut self) {
        let frame = self.elements.len();
        if let Some(axis) = self.axes.last_mut() {
            axis.frame = frame;
        }
    }

    /// Sets the body that the last axis carries.
    pub fn carry(&mut self, body: Body) {
        if let Some(axis) = self.axes.last_mut() {
            axis.body = body;
        }
    }

    /// Name of an axis.
    pub fn name(&self, axis: usize) -> &str {
        &self.axes[axis].drive.name
    }

    /// `true` if an axis or any axis beyond it carries a mass.
    pub fn is_loaded(&self, axis: usize) -> bool {
        self.axes[axis..].iter().any(|axis| axis.body.mass_kg > 0.0)
    }

    /// Completes the axes: places the frames of the links and adds a gain for each axis.
    pub fn complete_axes(&mut self) {
        self.settle_links();
        for k in 0..self.axes.len() {
            let Drive { ref label, joint, factor, offset, mimics, .. } = self.axes[k].drive;
            let gain = Parameter::new(format!("gain_{label}"), Quantity::Ratio, Role::Robot, 1.0);
            let by = mimics.then_some(joint);
            let parameter = self.add(Parameter { by, ..gain.meaning(GAIN).with_joint(joint) });
            self.axes[k].gain = Some(parameter);
            self.moved[k].push(Term { parameter, coefficient: Coefficient::Joint { joint, factor, offset } });
        }
    }

    /// Adds first and second harmonics of axes, as caused by gears or encoders.
    pub fn harmonics(&mut self, axes: &[usize]) {
        for &k in axes {
            let Drive { label, joint, factor, offset, .. } = self.axes[k].drive.clone();
            for (order, part, sine) in ORDERS {
                let name = harmonic_name(&label, part);
                let parameter = self.add(joint_error(name, Quantity::Angle, Effect::Harmonics, joint));
                let coefficient = Coefficient::Harmonic { joint, factor, offset, order, sine };
                self.moved[k].push(Term { parameter, coefficient });
            }
        }
    }

    /// Adds backlash to axes of a chain with `joints` joints: half of the backlash on either side.
    pub fn backlash(&mut self, axes: &[usize], joints: usize) {
        for &k in axes {
            let Drive { label, joint, factor, prismatic, .. } = self.axes[k].drive.clone();
            let known = self.approached.iter().position(|j| *j == joint);
            let at = joints + known.unwrap_or(self.approached.len());
            self.approached.extend(known.is_none().then_some(joint));
            let quantity = if prismatic { Quantity::Length } else { Quantity::Angle };
            let parameter = self.add(joint_error(backlash_name(&label), quantity, Effect::Backlash, joint));
            let coefficient = Coefficient::Approach { at, factor: -0.5 * factor.signum() };
            self.moved[k].push(Term { parameter, coefficient });
        }
    }

    /// Position of a value that each reading gives, behind the directions of approach.
    fn stated(&mut self, value: Circumstance) -> usize {
        self.circumstances.iter().position(|known| *known == value).unwrap_or_else(|| {
            self.circumstances.push(value);
            self.circumstances.len() - 1
        })
    }

    /// Declares that each reading gives the payload.
    fn stated_payload(&mut self) {
        self.stated(Circumstance::PayloadMass);
        for k in 0..3 {
            self.stated(Circumstance::PayloadCentre(k));
        }
    }

    /// Adds bending of revolute axes under the payload of a reading.
    pub fn payload(&mut self, axes: &[usize]) {
        for &axis in axes {
            self.stated_payload();
            let Drive { ref label, joint, .. } = self.axes[axis].drive;
            let name = compliance_name(label, Some("load"));
            let own = joint_error(name, Quantity::Angle, Effect::Payload, joint);
            let parameter = self.add(Parameter { by: Some(joint), ..own });
            self.loads.push(Load::Payload { axis });
            let coefficient = Coefficient::Load(self.loads.len() - 1);
            self.moved[axis].push(Term { parameter, coefficient });
        }
    }

    /// Adds bending of revolute axes in proportion to the torques of their joints:
    /// Δq = c · τ / 100 N·m.
    pub fn torque(&mut self, axes: &[usize]) {
        for &axis in axes {
            let Drive { label, joint, factor, .. } = self.axes[axis].drive.clone();
            let name = compliance_name(&label, Some("torque"));
            let own = joint_error(name, Quantity::Angle, Effect::Torque, joint);
            let parameter = self.add(Parameter { by: Some(joint), ..own });
            let at = self.stated(Circumstance::Torque(joint));
            let coefficient = Coefficient::Stated { at, from: 0.0, factor: PER_TORQUE * factor.signum() };
            self.moved[axis].push(Term { parameter, coefficient });
        }
    }

    /// Adds the effects of the temperature of a reading.
    pub fn temperature(&mut self, effects: &Effects) {
        self.drift(&effects.thermal.drift, effects.thermal.reference_c);
        if effects.thermal.expansion {
            self.expansion(effects.thermal.reference_c);
        }
    }

    /// Adds the drift of zeros of axes with the temperature: Δq = c · (T − reference) / 10 K.
    pub fn drift(&mut self, axes: &[usize], reference_c: f64) {
        for &axis in axes {
            let Drive { label, joint, factor, prismatic, .. } = self.axes[axis].drive.clone();
            let quantity = if prismatic { Quantity::Length } else { Quantity::Angle };
            let parameter = self.add(joint_error(format!("drift_{label}"), quantity, Effect::Drift, joint));
            let at = self.stated(Circumstance::Temperature);
            let coefficient = Coefficient::Stated { at, from: reference_c, factor: PER_KELVIN * factor.signum() };
            self.moved[axis].push(Term { parameter, coefficient });
        }
    }

    /// Adds the common expansion of all lengths of the arm: L = L₀ (1 + α (T − reference)), with α
    /// in mm per metre and kelvin.
    pub fn expansion(&mut self, reference_c: f64) {
        let own = Parameter::new("expansion", Quantity::Ratio, Role::Robot, 0.0).meaning(EXPANSION);
        let parameter = self.add(Parameter { effect: Effect::Expansion, ..own });
        let at = self.stated(Circumstance::Temperature);
        let coefficient = Coefficient::Stated { at, from: reference_c, factor: EXPANDED };
        self.expansion = Some(Term { parameter, coefficient });
    }

    /// Lets all lengths expand: displacements by a ratio, lengths of parameters by their nominal
    /// values.
    fn expand(&mut self) {
        let Some(Term { parameter, coefficient: Coefficient::Stated { at, from, factor } }) = self.expansion else {
            return;
        };
        let nominal: Vec<f64> = self.parameters.iter().map(|p| p.nominal).collect();
        for element in &mut self.elements[self.based..] {
            let own = |term: &Term| match term.coefficient {
                Coefficient::Constant(times) => times * nominal[term.parameter],
                _ => 0.0,
            };
            let length = match element.motion {
                Motion::Shift(_) => element.constant + element.terms.iter().map(own).sum::<f64>(),
                Motion::Fixed(place) if norm(place.translation_mm) > 0.0 => 1.0,
                _ => 0.0,
            };
            if length != 0.0 {
                let coefficient = Coefficient::Stated { at, from, factor: factor * length };
                element.terms.push(Term { parameter, coefficient });
            }
        }
    }

    /// Adds bending of the axes `bending`, in their order, under the links behind them.
    pub fn bending(&mut self, bending: &[usize]) {
        for &axis in bending {
            for &link in bending.iter().filter(|&&link| link >= axis) {
                let name = compliance_name(&self.axes[axis].drive.label, Some(&self.axes[link].drive.label));
                let by = self.axes[link].drive.joint;
                let term = self.load(name, Load::Link { axis, link }, axis, Some(by));
                self.moved[axis].push(term);
            }
        }
    }

    /// Adds bending of an axis under all masses beyond it, as the angle at their largest moment:
    /// about a revolute axis itself, or about the axes of the small rotations of a sliding axis,
    /// through the origin of its link. The moment is largest where the links up to a mass are
    /// stretched out level.
    pub fn bending_by_masses(&mut self, axis: usize) {
        let Drive { ref label, prismatic, .. } = self.axes[axis].drive;
        let label = label.clone();
        let (_, frames, _) = self.nominal_axes();
        let (origins, levers) = (self.link_origins(), self.axes[axis..].iter().zip(&frames[axis..]));
        let (mut stretched, mut largest_kg_mm) = (0.0, 0.0);
        for (k, (Axis { aligned, body, .. }, frame)) in (axis..).zip(levers) {
            let centre = frame.apply(aligned.inverse().rotate(body.center_mm));
            largest_kg_mm += body.mass_kg * (stretched + norm(minus(centre, origins[k])));
            stretched += origins.get(k + 1).map_or(0.0, |next| norm(minus(*next, origins[k])));
        }
        if !prismatic {
            let about = self.axes[axis].aligned.axis(2);
            let load = Load::Moment { axis, about, largest_kg_mm };
            let term = self.load(compliance_name(&label, None), load, axis, None);
            return self.moved[axis].push(term);
        }
        let sags: Vec<usize> = self.lateral.sags.iter().filter(|sag| sag.0 == axis).map(|sag| sag.1).collect();
        for element in sags.into_iter().flat_map(|first| [first, first + 1]) {
            let Motion::Turn(k) = self.elements[element].motion else { continue };
            let name = compliance_name(&label, Some(&format!("r{}", AXES[k])));
            let load = Load::Moment { axis, about: Pose::identity().axis(k), largest_kg_mm };
            let term = self.load(name, load, axis, None);
            self.elements[element].terms.push(term);
        }
    }

    fn load(&mut self, name: String, load: Load, axis: usize, by: Option<usize>) -> Term {
        let joint = self.axes[axis].drive.joint;
        let parameter = self.add(Parameter { by, ..joint_error(name, Quantity::Angle, Effect::Bending, joint) });
        self.loads.push(load);
        Term { parameter, coefficient: Coefficient::Load(self.loads.len() - 1) }
    }

    /// Adds coupling: pairs of an axis and the joint that moves it.
    pub fn coupling(&mut self, pairs: &[(usize, usize)]) {
        for &(axis, by) in pairs {
            let name = coupling_name(&self.axes[axis].drive.label, &self.axes[by].drive.label);
            let [moved, joint] = [axis, by].map(|k| self.axes[k].drive.joint);
            let parameter = joint_error(name, Quantity::Ratio, Effect::Coupling, moved);
            let parameter = self.add(Parameter { by: Some(joint), ..parameter });
            let coefficient = Coefficient::Joint { joint, factor: 1.0, offset: 0.0 };
            let moved = &mut self.moved[axis];
            let before = moved.iter().take_while(|t| !matches!(t.coefficient, Coefficient::Load(_))).count();
            moved.insert(before, Term { parameter, coefficient });
        }
    }

    /// Adds an axis with the given direction in the current frame, preceded by its small errors:
    /// two rotations and, for a revolute axis, two translations. The errors act about and along the
    /// coordinate axes that are farthest from the direction, transversely to it. They are complete
    /// and minimal: motions along the axis belong to later axes or targets.
    ///
    /// An axis that slides along the preceding axis with the same joint has no errors of its own.
    pub fn screw(&mut self, direction: Vector, drive: Drive, follows: bool) -> Vec<SmallError> {
        let mut errors = Vec::new();
        for (turn, quantity) in [(false, Quantity::Length), (true, Quantity::Angle)] {
            for k in error_axes(direction).into_iter().filter(|_| turn || !drive.prismatic) {
                let name = format!("{}_{}{}", drive.name, if turn { "r" } else { "" }, AXES[k]);
                let error = Parameter::new(name, quantity, Role::Robot, 0.0).with_joint(drive.joint);
                let parameter = (!follows).then(|| self.add(error.meaning(if turn { TILT } else { ASIDE })));
                let motion = if turn { Motion::Turn(k) } else { Motion::Shift(k) };
                self.push(motion, 0.0, parameter.as_slice());
                errors.push(SmallError { motion, parameter });
            }
        }
        let aligned = z_to(direction);
        if drive.prismatic && self.lateral.sagging.contains(&self.axes.len()) {
            let first = self.turns_at_link(error_axes(direction));
            self.lateral.sags.push((self.axes.len(), first));
        }
        self.place(aligned);
        self.push(if drive.prismatic { Motion::Shift(2) } else { Motion::Turn(2) }, 0.0, &[]);
        self.drive(drive, false);
        if let Some(axis) = self.axes.last_mut() {
            axis.aligned = aligned;
        }
        self.tilt();
        self.place(aligned.inverse());
        errors
    }

    /// Adds gains, harmonics, backlash, bending and coupling, and builds the robot with joints
    /// named q1, q2, ...
    pub fn finish(mut self, prismatic: impl Iterator<Item = bool>, effects: &Effects) -> Serial {
        self.complete_axes();
        self.harmonics(&effects.harmonics);
        self.backlash(&effects.backlash, self.axes.len());
        self.payload(&effects.payload);
        self.torque(&effects.torque);
        self.temperature(effects);
        self.tilts(effects.gravity);
        self.bending(&effects.bending);
        self.coupling(&effects.coupling);
        let joints = (1..).zip(prismatic).map(|(i, prismatic)| Joint::numbered(i, prismatic));
        self.build("serial", joints.collect(), effects.gravity)
    }

    /// Name of a duplicate parameter, if any.
    pub fn doubled(&self) -> Option<&str> {
        let names = || self.parameters.iter().map(|p| p.name.as_str());
        names().enumerate().find(|(i, name)| names().take(*i).any(|n| n == *name)).map(|(_, name)| name)
    }

    /// Builds the robot with these joints and this direction of gravity in the base frame.
    pub fn build(mut self, model: &'static str, joints: Vec<Joint>, gravity: Vector) -> Serial {
        let moved = std::mem::take(&mut self.moved);
        for (axis, moved) in self.axes.iter().zip(moved) {
            self.elements[axis.element].terms.splice(axis.at..axis.at, moved);
        }
        self.expand();
        // values of the reading follow the directions of all joints with backlash
        let first = joints.len() + self.approached.len();
        for term in self.elements.iter_mut().flat_map(|element| &mut element.terms) {
            if let Coefficient::Stated { at, .. } = &mut term.coefficient {
                *at += first;
            }
        }
        let mass = self.circumstances.iter().position(|value| *value == Circumstance::PayloadMass);
        let springs = self.springs();
        Serial {
            springs,
            limits: vec![None; joints.len()],
            definition: Definition { model, dimension: 3, parameters: self.parameters, joints, targets: self.targets },
            elements: self.elements,
            axes: self.axes,
            loads: self.loads,
            based: self.based,
            stated: StatedValues {
                approached: self.approached,
                payload: mass.map(|at| first + at),
                circumstances: self.circumstances,
            },
            gravity,
            of_base: Vec::new(),
            link: None,
            alternatives: Arc::new([]),
        }
    }
}

/// Two rotations at the frame of the link of an axis, between elements that lead there and back.
#[derive(Clone, Copy, Debug)]
struct Spring {
    axis: usize,
    /// Element of the first rotation.
    first: usize,
    /// `true` if the rotations are about the axes of the link frame, `false` if they are about the
    /// axes of the frame of the joint, through the origin of the link frame.
    at_axes: bool,
}

impl Spring {
    /// Frame of the rotations in the current frame before them.
    fn place(&self, axis: &Axis) -> Pose {
        match self.at_axes {
            true => axis.link,
            false => Pose { translation_mm: axis.aligned.rotate(axis.link.translation_mm), ..Pose::identity() },
        }
    }
}

/// Axes in the base frame at joint values zero, frames behind them, and the flange, at nominal
/// parameters.
fn nominal_axes(
    elements: &[Element],
    based: usize,
    axes: &[Axis],
    parameters: &[Parameter],
) -> (Vec<AxisLine>, Vec<Pose>, Pose) {
    let nominal: Vec<f64> = parameters.iter().map(|p| p.nominal).collect();
    let zero = vec![0.0; axes.iter().map(|axis| axis.drive.joint + 1).max().unwrap_or(0)];
    let (frames, flange) = frames(elements, based, axes, &nominal, State { joints: &zero, loads: &[] });
    let line = |(axis, frame): (&Axis, &Pose)| AxisLine {
        direction: frame.axis(2),
        point_mm: frame.translation_mm,
        prismatic: axis.drive.prismatic,
    };
    (axes.iter().zip(&frames).map(line).collect(), frames, flange)
}

/// Frames of the links in the frames behind the axes. A first joint that turns stands on the base:
/// its link starts at the foot of the perpendicular from the origin of the base, so that base and
/// joint tilt alike.
fn links_behind(lines: &[AxisLine], frames: &[Pose], flange: &Pose) -> Vec<Pose> {
    let mut links = link_frames(lines, flange);
    if let (Some(link), Some(line)) = (links.first_mut(), lines.first().filter(|line| !line.prismatic)) {
        link.translation_mm = line.foot([0.0; 3]);
    }
    frames.iter().zip(links).map(|(behind, link)| behind.inverse().then(&link)).collect()
}

/// Places the frames of the links and the rotations at them.
fn settle(elements: &mut [Element], axes: &mut [Axis], springs: &[Spring], links: &[Pose]) {
    let before: Vec<Pose> = springs.iter().map(|spring| spring.place(&axes[spring.axis])).collect();
    axes.iter_mut().zip(links).for_each(|(axis, link)| axis.link = *link);
    for (spring, before) in springs.iter().zip(before) {
        let place = spring.place(&axes[spring.axis]);
        elements[spring.first - 1].motion = Motion::Fixed(place);
        if let Motion::Fixed(back) = &mut elements[spring.first + 2].motion {
            *back = place.inverse().then(&before.then(back));
        }
    }
}

/// Frames after all axes, and the flange, in the base frame under these loads.
fn frames<T: Scalar>(
    elements: &[Element],
    based: usize,
    axes: &[Axis],
    parameters: &[T],
    state: State<T>,
) -> (Vec<Pose<T>>, Pose<T>) {
    let (mut frames, mut pose) = (Vec::with_capacity(axes.len()), Pose::identity());
    for (i, element) in elements.iter().enumerate().skip(based) {
        pose = element.advance(pose, parameters, state);
        if axes.get(frames.len()).is_some_and(|axis| axis.frame == i + 1) {
            frames.push(pose);
        }
    }
    (frames, pose)
}

/// Rotation that brings z to a direction; exact for coordinate axes.
fn z_to(direction: Vector) -> Pose {
    let [x, y, z] = direction;
    if z < 0.0 {
        let flipped = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], ..Pose::identity() };
        return flipped.then(&z_to([x, -y, -z]));
    }
    // Rodrigues' formula about z × direction
    let c = 1.0 / (1.0 + z);
    let rotation = [[1.0 - c * x * x, -c * x * y, x], [-c * x * y, 1.0 - c * y * y, y], [-x, -y, z]];
    Pose { rotation, ..Pose::identity() }
}

/// Drawing of a link between two joints with its Denavit-Hartenberg parameters, exaggerated for
/// visibility.
pub(super) fn drawn_link(convention: TableConvention, parallel: bool) -> Sketch {
    const TWIST: f64 = 0.9;
    const OFFSET: f64 = 0.7;
    let (a, d, arc) = (160.0, 90.0, 45.0);
    let modified = convention == TableConvention::Modified;
    let title = match modified {
        true => meaning("sketch-link-mdh"),
        false => meaning("sketch-link-dh"),
    };
    let mut sketch = Sketch::new(title, false);
    let axis = |sketch: &mut Sketch, name: &str, frame: &Pose, ends: [f64; 2]| {
        let ends = ends.map(|end| frame.shift(2, end).translation_mm);
        sketch.add(StrokeKind::Axis, name, &ends);
    };
    let length = |sketch: &mut Sketch, name: &str, frame: Pose, k: usize, by: f64| {
        let to = frame.shift(k, by);
        sketch.add(StrokeKind::Part, "", &[frame.translation_mm, to.translation_mm]);
        sketch.add(StrokeKind::Length, name, &[frame.translation_mm, to.translation_mm]);
        to
    };
    // about x from z; about y from z
    let twisted = |sketch: &mut Sketch, frame: &Pose| {
        sketch.add(StrokeKind::Axis, "", &[frame.translation_mm, frame.shift(2, 80.0).translation_mm]);
        sketch.angle("alpha_i", &frame.turn_y(-FRAC_PI_2), 70.0, -TWIST);
        let to = frame.turn_x(TWIST);
        if parallel {
            sketch.angle("beta_i", &to.turn_x(-FRAC_PI_2).turn_z(-FRAC_PI_2), 100.0, 0.4);
        }
        to
    };
    // rotated so that no axis is seen end-on
    let mut frame = Pose::identity().turn_z(1.2);
    if modified {
        axis(&mut sketch, "z i−1", &frame, [-50.0, 130.0]);
        frame = length(&mut sketch, "a_i", frame, 0, a);
        frame = twisted(&mut sketch, &frame);
    } else {
        axis(&mut sketch, "z i", &frame, [-50.0, 130.0]);
    }
    if modified {
        axis(&mut sketch, "z i", &frame, [-60.0, 170.0]);
    }
    sketch.add(StrokeKind::Axis, "", &[frame.translation_mm, frame.shift(0, 60.0).translation_mm]);
    sketch.angle("theta_i", &frame, arc, OFFSET);
    frame = length(&mut sketch, "d_i", frame.turn_z(OFFSET), 2, d);
    if !modified {
        frame = length(&mut sketch, "a_i", frame, 0, a);
        frame = twisted(&mut sketch, &frame);
        axis(&mut sketch, "z i+1", &frame, [-60.0, 140.0]);
    }
    sketch.frame("", &frame, 60.0);
    sketch
}

/// A robot in space whose joints follow each other, with its targets and the non-geometric effects
/// that are modelled.
///
/// # Examples
///
/// ```
/// use etalon_robots::{Robot, Serial, SerialJoint};
/// use std::f64::consts::FRAC_PI_2;
///
/// // three parallel axes, 400 mm and 300 mm apart (modified Denavit-Hartenberg parameters)
/// let (alpha_rad, theta_rad, d_mm) = (0.0, 0.0, 0.0);
/// let joints = [0.0, 400.0, 300.0].map(|a_mm| SerialJoint {
///     alpha_rad, a_mm, theta_rad, d_mm, prismatic: false, parallel: true,
/// });
/// let gravity = [0.0, 0.0, -1.0];
/// let arm = Serial::new(&joints, &["SMR".to_owned()], gravity, &[], &[]);
///
/// // the elbow at 90°
/// let flange = arm.direct(&arm.nominal(), &[0.0, FRAC_PI_2, 0.0]);
/// let [x_mm, y_mm, _] = flange.translation_mm;
/// assert!((x_mm - 400.0).abs() < 1e-9 && (y_mm - 300.0).abs() < 1e-9);
/// ```
#[derive(Clone, Debug)]
pub struct Serial {
    definition: Definition,
    elements: Vec<Element>,
    axes: Vec<Axis>,
    loads: Vec<Load>,
    /// Rotations at frames of links.
    springs: Vec<Spring>,
    /// Number of elements of the base.
    based: usize,
    pub(super) stated: StatedValues,
    gravity: Vector,
    /// Limits of each joint (rad or mm).
    limits: Vec<Option<[f64; 2]>>,
    /// Joints that move the base.
    of_base: Vec<String>,
    /// Drawing of a link with its Denavit-Hartenberg parameters.
    link: Option<Sketch>,
    /// Robots that may be meant instead, with their descriptions.
    alternatives: Arc<[(Phrase, Self)]>,
}

/// Values that each reading gives in addition to the joint values.
#[derive(Clone, Debug)]
pub(super) struct StatedValues {
    /// Joints whose direction of approach follows the joint values.
    approached: Vec<usize>,
    /// Position of the payload behind the joint values.
    pub payload: Option<usize>,
    /// Circumstances; they follow the directions of approach.
    circumstances: Vec<Circumstance>,
}

impl Serial {
    /// Sets the limits of the joints (rad or mm).
    pub(super) fn with_limits(self, limits: Vec<Option<[f64; 2]>>) -> Self {
        Self { limits, ..self }
    }

    /// Gain of an axis: motion per unit of its joint value, without the factor.
    fn gain(&self, axis: &Axis, parameters: &[f64]) -> f64 {
        axis.gain.map_or(1.0, |i| parameters[i])
    }

    /// Declares the joints that move the base.
    pub(super) fn on_moving_base(self, of_base: Vec<String>) -> Self {
        Self { of_base, ..self }
    }

    /// Sets the drawing of one of the links.
    pub(super) fn with_link(self, link: Sketch) -> Self {
        Self { link: Some(link), ..self }
    }

    /// Sets the robots that may be meant instead.
    pub(super) fn with_alternatives(self, alternatives: Vec<(Phrase, Self)>) -> Self {
        Self { alternatives: alternatives.into(), ..self }
    }

    /// Frames after all axes, and the flange, in the base frame under these loads.
    fn frames<T: Scalar>(&self, parameters: &[T], state: State<T>) -> (Vec<Pose<T>>, Pose<T>) {
        frames(&self.elements, self.based, &self.axes, parameters, state)
    }

    /// Loads at joint values, on nominal geometry.
    fn loads_at<T: Scalar>(&self, joints: &[T]) -> Vec<T> {
        if self.loads.is_empty() {
            return Vec::new();
        }
        let nominal: Vec<T> = self.parameters().iter().map(|p| T::from(p.nominal)).collect();
        let (frames, flange) = self.frames(&nominal, State { joints, loads: &[] });
        self.loads_on(&frames, &flange, joints)
    }

    /// Loads at the given frames behind all axes and the flange; the payload follows the joint
    /// values.
    fn loads_on<T: Scalar>(&self, frames: &[Pose<T>], flange: &Pose<T>, joints: &[T]) -> Vec<T> {
        let gravity = self.gravity.map(T::from);
        let stated = |k: usize| self.stated.payload.and_then(|at| joints.get(at + k).copied()).unwrap_or(T::from(0.0));
        let [mass_kg, x, y, z] = [0, 1, 2, 3].map(stated);
        let origin = |k: usize| frames[k].apply(self.axes[k].link.translation_mm.map(T::from));
        let size = |load: &Load| match *load {
            Load::Link { axis, link } => {
                let next = if link + 1 < frames.len() { link + 1 } else { link };
                let along = minus(origin(next), origin(link));
                let length = dot(along, along).sqrt();
                let along =
                    if length.value() < SHORTEST_MM { along.map(|v| v * 0.0) } else { along.map(|v| v / length) };
                dot(frames[axis].axis(2), cross(along, gravity))
            }
            Load::Moment { axis, about, largest_kg_mm } => {
                let in_joint = |k: usize, v: Vector| self.axes[k].aligned.inverse().rotate(v).map(T::from);
                let (pivot, about) = (origin(axis), frames[axis].rotate(in_joint(axis, about)));
                let beyond = frames.iter().zip(&self.axes).enumerate().skip(axis);
                let moment = |(k, (frame, a)): (usize, (&Pose<T>, &Axis))| {
                    let lever = minus(frame.apply(in_joint(k, a.body.center_mm)), pivot);
                    dot(about, cross(lever, gravity)) * a.body.mass_kg
                };
                beyond.map(moment).fold(T::from(0.0), |sum, m| sum + m) * (1.0 / largest_kg_mm)
            }
            Load::Payload { axis } => {
                let lever = minus(flange.apply([x, y, z]), frames[axis].translation_mm);
                dot(frames[axis].axis(2), cross(lever, gravity)) * mass_kg * PAYLOAD
            }
            Load::Across { axis, about } => {
                let in_link = |axis: usize| frames[axis].then(&self.axes[axis].link.constant());
                let frame = axis.map_or_else(Pose::identity, in_link);
                let of = |point: Vector<T>, mass_kg: T| {
                    dot(frame.axis(about), cross(minus(point, frame.translation_mm), gravity)) * mass_kg * PAYLOAD
                };
                let link = |(frame, a): (&Pose<T>, &Axis)| {
                    let centre = a.aligned.inverse().rotate(a.body.center_mm).map(T::from);
                    of(frame.apply(centre), T::from(a.body.mass_kg))
                };
                let beyond = frames.iter().zip(&self.axes).skip(axis.unwrap_or(0));
                beyond.map(link).fold(of(flange.apply([x, y, z]), mass_kg), |sum, moment| sum + moment)
            }
        };
        self.loads.iter().map(size).collect()
    }

    /// Units, full turns and limits of the joint values.
    pub(super) fn joint_scales(&self, parameters: &[f64]) -> Vec<JointScale> {
        let scale = |(j, joint): (usize, &Joint)| {
            let mut axes = self.axes.iter().filter(|axis| axis.drive.joint == j);
            let (first, single) = (axes.next(), axes.next().is_none());
            let rate = first.map_or(1.0, |axis| (self.gain(axis, parameters) * axis.drive.factor).abs());
            let rate = if rate > 0.0 && rate.is_finite() { rate } else { 1.0 };
            let revolute = joint.quantity == Quantity::Angle;
            let stated = |ends: &[f64; 2]| ends.iter().all(|end| end.is_finite());
            JointScale {
                unit: if revolute { 1.0 } else { TURNED_MM } / rate,
                turn: (revolute && single).then_some(TAU / rate),
                limits: self.limits.get(j).copied().flatten().filter(stated),
            }
        };
        self.joints().iter().enumerate().map(scale).collect()
    }

    /// Place of the first moved element in the world (mm), and the largest distance (mm) of the
    /// flange from it; `None` if a slide has no limits.
    pub(super) fn extent(&self, parameters: &[f64]) -> (Vector, Option<f64>) {
        let first = self.axes.iter().map(|axis| axis.element).min().unwrap_or(0);
        let end = |k: usize| self.limits.iter().map(|ends| ends.map_or(f64::NAN, |ends| ends[k])).collect::<Vec<f64>>();
        let ends = [end(0), end(1)];
        let origin = chain::end(&self.elements[..first], parameters, State { joints: &ends[0], loads: &[] });
        let length = |element: &Element| {
            let length = |joints: &Vec<f64>| match element.motion {
                Motion::Turn(_) | Motion::Attitude(_) => 0.0,
                _ => norm(element.advance(Pose::identity(), parameters, State { joints, loads: &[] }).translation_mm),
            };
            let [lower, upper] = ends.each_ref().map(length);
            if lower.is_nan() || upper.is_nan() { f64::NAN } else { lower.max(upper) }
        };
        let reach_mm: f64 = self.elements[first..].iter().map(length).sum();
        // rounding, and play of slides
        (origin.translation_mm, (!reach_mm.is_nan()).then_some(reach_mm * (1.0 + 1e-9) + 1.0))
    }

    /// Drawing of the arm in its base at joint values zero, with all lengths that are nominally
    /// non-zero.
    fn drawn(&self) -> Sketch {
        let mut sketch = Sketch::new(meaning("sketch-arm"), false);
        let (p, joints) = (self.nominal(), vec![0.0; self.joints().len()]);
        let state = State { joints: &joints[..], loads: &[] };
        let mut pose = Pose::identity();
        for element in &self.elements[self.based..] {
            let next = element.advance(pose, &p, state);
            let ends = [pose.translation_mm, next.translation_mm];
            if norm(minus(ends[1], ends[0])) > 1e-6 {
                sketch.add(StrokeKind::Part, "", &ends);
                let own = element.terms.iter().find(|term| term.coefficient == Coefficient::Constant(1.0));
                if let Some(term) = own.filter(|_| matches!(element.motion, Motion::Shift(_))) {
                    sketch.add(StrokeKind::Length, &self.parameters()[term.parameter].name, &ends);
                }
            }
            pose = next;
        }
        let size = sketch.extent_mm();
        for (axis, frame) in self.axes.iter().zip(self.frames(&p, state).0) {
            let ends = [-0.09, 0.13].map(|share| frame.shift(2, share * size).translation_mm);
            sketch.add(StrokeKind::Axis, &axis.drive.name, &ends);
        }
        sketch.frame("base", &Pose::identity(), 0.15 * size);
        sketch.frame("flange", &pose, 0.1 * size);
        sketch
    }

    /// The arm as lines in the world, under these loads. A rail belongs to the part in front of it.
    pub(super) fn outline_under(&self, parameters: &[f64], state: State) -> Outline {
        let base = chain::end(&self.elements[..self.based], parameters, state);
        let (mut outline, mut pose, mut body) = (Outline::default(), Pose::identity(), "base");
        for (i, element) in self.elements.iter().enumerate().skip(self.based) {
            let next = element.advance(pose, parameters, state);
            if norm(minus(next.translation_mm, pose.translation_mm)) > SHORTEST_MM {
                outline.link(body, &[pose.translation_mm, next.translation_mm]);
            }
            let moved = self.axes.iter().find(|axis| axis.element == i);
            body = moved.map_or(body, |axis| &self.joints()[axis.drive.joint].name);
            pose = next;
        }
        let size = outline.extent_mm();
        for (axis, frame) in self.axes.iter().zip(self.frames(parameters, state).0) {
            let ends = [-0.04, 0.06].map(|share| frame.shift(2, share * size).translation_mm);
            outline.axis(&self.joints()[axis.drive.joint].name, &ends);
        }
        outline.moved(&base)
    }

    /// Frames of base and moving parts in the world, under these loads.
    pub(super) fn part_frames_under(&self, parameters: &[f64], state: State) -> Vec<(String, Pose)> {
        let base = chain::end(&self.elements[..self.based], parameters, state);
        let frames = self.frames(parameters, state).0;
        let behind = self.axes.iter().zip(frames).map(|(axis, frame)| {
            let part = base.then(&frame).then(&axis.aligned.inverse());
            (axis.drive.name.clone(), part)
        });
        std::iter::once(("base".to_owned(), base)).chain(behind).collect()
    }

    /// Direct kinematics: pose of the flange in the world.
    pub fn direct(&self, parameters: &[f64], q: &[f64]) -> Pose {
        chain::end(&self.elements, parameters, State { joints: q, loads: &self.loads_at(q) })
    }

    /// Generic form of [`Robot::positions`]: positions of all targets in the world.
    pub fn target_positions<T: Scalar>(&self, parameters: &[T], q: &[f64]) -> Vec<Vector<T>> {
        let flange = chain::end(&self.elements, parameters, State { joints: q, loads: &self.loads_at(q) });
        (0..self.targets().len())
            .map(|k| {
                let place = self.target_place(k);
                flange.apply([parameters[place], parameters[place + 1], parameters[place + 2]])
            })
            .collect()
    }

    /// [`FreeBase::joint_value`] for changes of all parameters from nominal.
    fn joint_motion(
        &self,
        changes: &[f64],
        state: State,
        joint: usize,
        write: &mut dyn FnMut(usize, f64),
    ) -> Option<f64> {
        let axis = self.axes.iter().find(|axis| axis.drive.joint == joint)?;
        let mut value = state.joints[joint];
        // motion of the element minus its motion at nominal parameters
        for (parameter, coefficient) in self.elements[axis.element].coefficients(state) {
            write(parameter, coefficient / axis.drive.factor);
            value += coefficient / axis.drive.factor * changes[parameter];
        }
        Some(value)
    }

    /// Number of loads.
    pub(super) fn load_count(&self) -> usize {
        self.loads.len()
    }

    /// Loads at joint values on a geometry with these parameters.
    pub(super) fn loads_with_parameters(&self, nominal: &[f64], joints: &[f64]) -> Vec<f64> {
        if self.loads.is_empty() {
            return Vec::new();
        }
        let (frames, flange) = self.frames(nominal, State { joints, loads: &[] });
        self.loads_on(&frames, &flange, joints)
    }

    /// Value of a joint with nominal and present parameters, as [`FreeBase::joint_value`] has it.
    pub(super) fn joint_value_about(
        &self,
        [nominal, parameters]: [&[f64]; 2],
        joints: &[f64],
        joint: usize,
        write: &mut dyn FnMut(usize, f64),
    ) -> Option<f64> {
        let changes: Vec<f64> = parameters.iter().zip(nominal).map(|(value, nominal)| value - nominal).collect();
        self.joint_motion(&changes, State { joints, loads: &self.loads_with_parameters(nominal, joints) }, joint, write)
    }

    /// Returns the gain of a joint with these parameters, without the factor of its drive; `None`
    /// if the joint does not move the arm.
    pub(super) fn joint_gain(&self, joint: usize, parameters: &[f64]) -> Option<f64> {
        let axis = self.axes.iter().find(|axis| axis.drive.joint == joint)?;
        Some(self.gain(axis, parameters))
    }

    /// Binds parameters to the arm.
    pub(super) fn with(&self, parameters: &[f64]) -> WithParameters<'_> {
        WithParameters { arm: self, chain: Prepared::new(&self.elements, parameters) }
    }
}

impl Robot for Serial {
    fn definition(&self) -> &Definition {
        &self.definition
    }
    fn definition_mut(&mut self) -> &mut Definition {
        &mut self.definition
    }
    fn sketches(&self) -> Vec<Sketch> {
        let mut all = vec![self.drawn()];
        all.extend(self.link.clone());
        all
    }
    fn outline(&self, parameters: &[f64], joints: &[f64]) -> Outline {
        self.outline_under(parameters, State { joints, loads: &self.loads_at(joints) })
    }
    fn part_frames(&self, parameters: &[f64], joints: &[f64]) -> Vec<(String, Pose)> {
        self.part_frames_under(parameters, State { joints, loads: &self.loads_at(joints) })
    }
    fn remedy(&self, parameters: &[usize]) -> Option<Phrase> {
        let all = || parameters.iter().map(|&i| &self.parameters()[i]);
        let first = all().find(|p| p.effect == Effect::Lateral && p.joint == Some(0));
        let joint = first.and_then(|_| self.axes.first()).map(|axis| axis.drive.label.clone())?;
        all().any(|p| p.effect == Effect::Pedestal).then(|| phrase!("pedestal-or-first-joint", joint))
    }
    fn optional_parameters(&self) -> Vec<OptionalParameter> {
        let labels = || self.axes.iter().map(|axis| axis.drive.label.as_str());
        let mut all = Vec::new();
        let mut add = |key, name: String, joints: &[&str]| {
            let joints = joints.iter().map(|joint| (*joint).to_owned()).collect();
            all.push(OptionalParameter { name, key, joints, is_pair: key == "coupling" });
        };
        for label in labels() {
            add("bending", compliance_name(label, None), &[label]);
            AXES.iter().for_each(|a| add("bending", compliance_name(label, Some(&format!("r{a}"))), &[label]));
            ORDERS.iter().for_each(|(_, part, _)| add("harmonics", harmonic_name(label, part), &[label]));
            add("backlash", backlash_name(label), &[label]);
            add("payload", compliance_name(label, Some("load")), &[label]);
            add("torque", compliance_name(label, Some("torque")), &[label]);
            add("drift", format!("drift_{label}"), &[label]);
            AXES[..2].iter().for_each(|a| add("lateral", format!("lateral_{label}_{a}"), &[label]));
            for by in labels() {
                let joints = if by == label { vec![label] } else { vec![label, by] };
                add("bending", compliance_name(label, Some(by)), &joints);
                add("coupling", coupling_name(label, by), &[label, by]);
            }
        }
        all
    }
    fn alternatives(&self) -> Vec<(Phrase, Box<dyn Robot>)> {
        self.alternatives.iter().map(|(what, other)| (what.clone(), Box::new(other.clone()) as _)).collect()
    }
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        out.copy_from_slice(self.target_positions(parameters, joints).as_flattened());
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        self.with(parameters).jacobian(State { joints, loads: &self.loads_at(joints) }, out);
    }
    fn position(&self, parameters: &[f64], joints: &[f64], target: usize) -> Vector {
        let place = self.target_place(target);
        let flange = chain::end(&self.elements, parameters, State { joints, loads: &self.loads_at(joints) });
        flange.apply([parameters[place], parameters[place + 1], parameters[place + 2]])
    }
    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let state = State { joints, loads: &self.loads_at(joints) };
        self.with(parameters).joint_jacobian(state, &mut vec![0.0; 3 * self.targets().len()], out);
    }
    fn loads(&self) -> Option<Loads<'_>> {
        if self.loads.is_empty() {
            return None;
        }
        let nominal = Prepared::new(&self.elements[self.based..], &self.nominal());
        Some(Box::new(move |joints| {
            let mut frames = Vec::with_capacity(self.axes.len());
            let end = nominal.run(State { joints, loads: &[] }, |i, before| {
                if self.axes.get(frames.len()).is_some_and(|axis| axis.frame == self.based + i) {
                    frames.push(*before);
                }
            });
            frames.resize(self.axes.len(), end);
            self.loads_on(&frames, &end, joints)
        }))
    }
    fn parametrised<'a>(&'a self, parameters: &'a [f64]) -> Box<dyn Parametrised + 'a> {
        Box::new(self.with(parameters))
    }
    fn joints_of_base(&self) -> &[String] {
        &self.of_base
    }
    fn settle(&mut self) {
        let (lines, frames, flange) = nominal_axes(&self.elements, self.based, &self.axes, self.parameters());
        settle(&mut self.elements, &mut self.axes, &self.springs, &links_behind(&lines, &frames, &flange));
    }
    fn approached(&self) -> &[usize] {
        &self.stated.approached
    }
    fn circumstances(&self) -> &[Circumstance] {
        &self.stated.circumstances
    }
    fn reference_temperature_c(&self) -> Option<f64> {
        let known = self.stated.circumstances.iter().position(|value| *value == Circumstance::Temperature)?;
        let own = self.joints().len() + self.stated.approached.len() + known;
        self.elements.iter().flat_map(|element| &element.terms).find_map(|term| match term.coefficient {
            Coefficient::Stated { at, from, .. } if at == own => Some(from),
            _ => None,
        })
    }
    fn limit_violation(&self, _parameters: &[f64], joints: &[f64]) -> Option<Phrase> {
        limit_violation(self.joints(), &self.limits, joints)
    }
    fn joint_range(&self, joint: usize) -> JointRange {
        JointRange::from_limits(self.limits.get(joint).copied().flatten())
    }
    fn nominal_gain(&self, joint: usize) -> f64 {
        self.joint_gain(joint, &self.nominal()).unwrap_or(1.0)
    }
    fn free_base(&self) -> Option<&dyn FreeBase> {
        Some(self)
    }
    fn kinematics(&self) -> Option<&dyn Kinematics> {
        Some(self)
    }
    fn joint_chain(&self, parameters: &[f64]) -> Option<JointChain> {
        let zero = vec![0.0; self.joints().len()];
        let (mut frames, flange) = self.frames(parameters, State { joints: &zero, loads: &[] });
        frames.insert(0, Pose::identity());
        let joint = |(axis, pair): (&Axis, &[Pose])| ChainJoint {
            origin: pair[0].inverse().then(&pair[1]),
            prismatic: axis.drive.prismatic,
            gain: self.gain(axis, parameters) * axis.drive.factor,
        };
        let joints = self.axes.iter().zip(frames.windows(2)).map(joint).collect();
        Some(JointChain { joints, flange: frames.last()?.inverse().then(&flange) })
    }
}

/// Newton step towards a pose (x, y, z and the rotation matrix row by row) from linearised
/// kinematics; long steps are shortened to half a radian or millimetre. Also returns the size of
/// the step, the errors of position (mm) and orientation (rad times [`TURNED_MM`]) before the step,
/// and the trace of the relative rotation, which is 3 if the orientations agree and negative at
/// half a turn.
fn correction<T: Scalar>(pose: &[T], linearised: &[T]) -> (Vec<T>, [T; 4]) {
    let (at, columns) = linearised.split_at(12);
    let gap: Vec<T> = (0..3).map(|i| pose[i] - at[i]).collect();
    let axis = |of: &[T], j: usize| [of[3 + j], of[6 + j], of[9 + j]];
    let sum = |a: Vector<T>, b: Vector<T>| [0, 1, 2].map(|i| a[i] + b[i]);
    let turn =
        (0..3).map(|j| cross(axis(at, j), axis(pose, j))).fold([T::from(0.0); 3], sum).map(|v| v * (0.5 * TURNED_MM));
    let agreement = (3..12).fold(T::from(0.0), |sum, i| sum + at[i] * pose[i]);
    let scale = |row: usize| if row < 3 { 1.0 } else { TURNED_MM };
    let right = gap.iter().chain(&turn).enumerate();
    let row = |(row, right): (usize, &T)| columns.chunks(6).map(|c| c[row] * scale(row)).chain([*right]).collect();
    let step: Vec<T> = normal_equations(&right.map(row).collect::<Vec<_>>(), SINGULAR).collect();
    let shorter = T::from(1.0) / (square(&step) * 4.0 + 1.0).sqrt();
    let errors = [square(&step).sqrt(), square(&gap).sqrt(), square(&turn).sqrt(), agreement];
    (step.into_iter().map(|v| v * shorter).collect(), errors)
}

/// Damping for joints without effect in redundant arms and singular poses, as a share of the effect
/// of all joints.
const SINGULAR: f64 = 1e-14;

impl Serial {
    /// Direct kinematics, without and with derivatives with respect to the joint values: of the
    /// position, and of the rotation as vectors in the base frame.
    pub(super) fn pose_formulas(&self, parameters: &[f64]) -> Vec<Formula> {
        let joints: Vec<String> = self.joints().iter().map(|joint| joint.name.clone()).collect();
        let record = |name, with_derivatives| {
            Formula::record(name, &joints, |q| {
                let p: Vec<Recorded> = parameters.iter().map(|&v| Recorded::from(v)).collect();
                let flange = self.frames(&p, State { joints: q, loads: &self.loads_at(q) }).1;
                let mut outputs = pose_outputs(&flange);
                let numbers: Vec<Recorded> = outputs.iter().map(|(_, v)| *v).collect();
                for (q, joint) in q.iter().zip(&joints).filter(|_| with_derivatives) {
                    let by = derivatives(&numbers, *q);
                    let column = |of: &[Recorded], j: usize| [of[3 + j], of[6 + j], of[9 + j]];
                    let turns = (0..3).map(|j| cross(column(&numbers, j), column(&by, j)));
                    let turn = turns.fold([Recorded::from(0.0); 3], |sum, t| [0, 1, 2].map(|i| sum[i] + t[i] * 0.5));
                    let rows = by[..3].iter().chain(&turn).zip(["x", "y", "z", "rx", "ry", "rz"]);
                    outputs.extend(rows.map(|(v, row)| (format!("{row}_by_{joint}"), *v)));
                }
                outputs
            })
        };
        let pose = || pose_outputs(&Pose::<f64>::identity()).into_iter().map(|(name, _)| name);
        let linearised = record("linearised", true);
        let reached = linearised.outputs.iter().map(|(name, _)| format!("reached_{name}"));
        let inputs: Vec<String> = pose().chain(reached).collect();
        let correction = Formula::record("correction", &inputs, |v| {
            let (by, measures) = correction(&v[..12], &v[12..]);
            let measures =
                ["size", "position", "orientation", "agreement"].map(str::to_owned).into_iter().zip(measures);
            joints.iter().map(|joint| format!("by_{joint}")).zip(by).chain(measures).collect()
        });
        vec![record("direct", false), linearised, correction]
    }

    /// Determinant of the Jacobian, for six joints.
    pub(super) fn jacobian_determinant(&self, parameters: &[f64], joints: &[f64]) -> Vec<f64> {
        if joints.len() != 6 {
            return Vec::new();
        }
        let units: Vec<f64> = self.joint_scales(parameters).iter().map(|joint| joint.unit / TURNED_MM).collect();
        let jacobian = Matrix6::from_row_slice(&self.with(parameters).flange_jacobian(joints).1);
        vec![(jacobian * Matrix6::from_diagonal(&Vector6::from_column_slice(&units))).determinant()]
    }
}

impl FreeBase for Serial {
    fn flange(&self, parameters: &[f64], joints: &[f64], _target: usize) -> Pose {
        self.direct(parameters, joints)
    }
    fn joint_value(
        &self,
        parameters: &[f64],
        joints: &[f64],
        joint: usize,
        write: &mut dyn FnMut(usize, f64),
    ) -> Option<f64> {
        self.joint_value_about([&self.nominal(), parameters], joints, joint, write)
    }
    fn flange_turns(&self, parameters: &[f64], joints: &[f64], _target: usize, out: &mut [f64]) {
        self.with(parameters).flange_turns(State { joints, loads: &self.loads_at(joints) }, out);
    }
}

/// An arm with bound parameters.
pub(super) struct WithParameters<'a> {
    arm: &'a Serial,
    chain: Prepared<'a>,
}

impl WithParameters<'_> {
    /// Pose of the flange in the world.
    pub fn flange(&self, state: State) -> Pose {
        self.chain.end(state)
    }

    /// Writes like [`FreeBase::flange_turns`].
    pub fn flange_turns(&self, state: State, out: &mut [f64]) {
        let n = self.chain.parameters().len();
        out.fill(0.0);
        let (_, axes) = self.chain.trace(state);
        for (element, &axis) in self.arm.elements.iter().zip(&axes) {
            let turn = element.angular_velocity(axis);
            for (parameter, coefficient) in element.coefficients(state) {
                (0..3).for_each(|i| out[i * n + parameter] += turn[i] * coefficient);
            }
        }
    }

    /// Position of a target on a flange.
    pub fn target(&self, flange: &Pose, target: usize) -> Vector {
        let place = self.arm.target_place(target);
        flange.apply([0, 1, 2].map(|k| self.chain.parameters()[place + k]))
    }

    /// Pose of the flange in the world, and its derivatives with respect to the joint values at
    /// constant loads: three rows for the position, three for the orientation (rad times
    /// [`TURNED_MM`]).
    pub fn flange_jacobian(&self, q: &[f64]) -> (Pose, Vec<f64>) {
        let state = State { joints: q, loads: &self.arm.loads_at(q) };
        let (reached, axes) = self.chain.trace(state);
        let mut a = vec![0.0; 6 * q.len()];
        for (element, axis, joint, rate) in self.chain.rates(state, &axes) {
            let linear = element.velocity(axis, reached.translation_mm);
            let angular = element.angular_velocity(axis);
            for i in 0..3 {
                a[i * q.len() + joint] += linear[i] * rate;
                a[(3 + i) * q.len() + joint] += angular[i] * rate * TURNED_MM;
            }
        }
        (reached, a)
    }

    /// Writes positions and joint Jacobian of some targets into the rows of all targets.
    pub fn joint_derivatives(&self, state: State, targets: &[usize], positions: &mut [f64], out: &mut [f64]) {
        let n = self.arm.joints().len();
        let (flange, axes) = self.chain.trace(state);
        for &k in targets {
            let (rows, point) = (&mut out[3 * n * k..][..3 * n], self.target(&flange, k));
            positions[3 * k..][..3].copy_from_slice(&point);
            for (element, axis, joint, rate) in self.chain.rates(state, &axes) {
                let v = element.velocity(axis, point);
                (0..3).for_each(|i| rows[i * n + joint] += v[i] * rate);
            }
        }
    }

    /// Calls `write` with the derivatives of target positions with respect to parameters, target by
    /// target.
    fn derivatives(
        &self,
        state: State,
        targets: impl Iterator<Item = usize>,
        mut write: impl FnMut(usize, usize, Vector),
    ) {
        let (flange, axes) = self.chain.trace(state);
        for k in targets {
            let point = self.target(&flange, k);
            for (element, &axis) in self.arm.elements.iter().zip(&axes).filter(|(e, _)| !e.terms.is_empty()) {
                let v = element.velocity(axis, point);
                for (parameter, coefficient) in element.coefficients(state) {
                    write(k, parameter, [v[0] * coefficient, v[1] * coefficient, v[2] * coefficient]);
                }
            }
            let place = self.arm.target_place(k);
            (0..3).for_each(|axis| write(k, place + axis, flange.axis(axis)));
        }
    }
}

impl Parametrised for WithParameters<'_> {
    fn positions(&self, state: State, out: &mut [f64]) {
        let flange = self.chain.end(state);
        out.chunks_exact_mut(3).enumerate().for_each(|(k, out)| out.copy_from_slice(&self.target(&flange, k)));
    }
    fn jacobian(&self, state: State, out: &mut [f64]) {
        let n = self.chain.parameters().len();
        out.fill(0.0);
        self.derivatives(state, 0..self.arm.targets().len(), |target, parameter, moved| {
            (0..3).for_each(|i| out[(3 * target + i) * n + parameter] += moved[i]);
        });
    }
    fn joint_jacobian(&self, state: State, positions: &mut [f64], out: &mut [f64]) {
        out.fill(0.0);
        let targets: Vec<usize> = (0..self.arm.targets().len()).collect();
        self.joint_derivatives(state, &targets, positions, out);
    }
    fn target_derivatives(&self, state: State, targets: &[usize], write: &mut dyn FnMut(usize, usize, Vector)) {
        self.derivatives(state, targets.iter().copied(), write);
    }
}
