//! Definitions of parameters and joints.

/// Physical quantity, which decides the unit outside the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Length, in millimetres inside and outside.
    Length,
    /// Angle, in radians inside and degrees outside.
    Angle,
    /// Dimensionless ratio.
    Ratio,
}

impl Quantity {
    /// Outside unit: `mm`, `deg` or `1`.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Length => "mm",
            Self::Angle => "deg",
            Self::Ratio => "1",
        }
    }

    /// Converts a value to the outside unit.
    pub fn outward(self, value: f64) -> f64 {
        if self == Self::Angle { value.to_degrees() } else { value }
    }

    /// Converts a value from the outside unit.
    pub fn inward(self, value: f64) -> f64 {
        if self == Self::Angle { value.to_radians() } else { value }
    }
}

/// Owner of a parameter, which decides whether it is fitted before the calibration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// Pose of the base in the world.
    Base,
    /// Positions of the targets on the moving part.
    Target,
    /// Points and planes fixed in the world that targets touch or are measured from.
    Fixture,
    /// Geometry, joint offsets, gains and compliance of the robot itself.
    #[default]
    Robot,
}

/// Effect that a parameter of the robot itself describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// Zeros of the joints.
    Zeros,
    /// Lengths and angles of the parts.
    Geometry,
    /// Gains: leads and transmission ratios.
    Gains,
    /// Harmonics of the transmissions.
    Harmonics,
    /// Backlash of the joints.
    Backlash,
    /// Coupling between joints.
    Coupling,
    /// Bending of joints and links under their own loads.
    Bending,
    /// Bending of joints under a payload that each reading gives.
    Payload,
    /// Bending of joints under their torques, which each reading gives.
    Torque,
    /// Common expansion of all lengths with the temperature that each reading gives.
    Expansion,
    /// Drift of the zeros of joints with the temperature that each reading gives.
    Drift,
    /// Tilt of revolute joints across their axes under the moment of masses and payload.
    Lateral,
    /// Tilt and torsion of the base under the moment of masses and payload.
    Pedestal,
}

impl Effect {
    /// All effects, the simpler ones first.
    pub const ALL: [Self; 13] = [
        Self::Zeros,
        Self::Geometry,
        Self::Gains,
        Self::Harmonics,
        Self::Backlash,
        Self::Coupling,
        Self::Bending,
        Self::Payload,
        Self::Torque,
        Self::Expansion,
        Self::Drift,
        Self::Lateral,
        Self::Pedestal,
    ];

    /// `true` for zeros, geometry and gains: the effects of rigid joints and links.
    pub fn is_rigid(self) -> bool {
        matches!(self, Self::Zeros | Self::Geometry | Self::Gains)
    }

    /// `true` for effects that are identified only on request, because the data must support them.
    pub fn needs_proof(self) -> bool {
        matches!(self, Self::Lateral | Self::Pedestal) || self.follows_readings()
    }

    /// `true` for effects that depend on values of a reading other than the joint values: load,
    /// torques, temperature.
    pub fn follows_readings(self) -> bool {
        matches!(self, Self::Payload | Self::Torque) || self.is_thermal()
    }

    /// `true` for effects that depend on the temperature of a reading.
    pub fn is_thermal(self) -> bool {
        matches!(self, Self::Expansion | Self::Drift)
    }
}

// `Effect::ALL` has every effect once: the last one closes the list
const _: () = {
    let mut i = 0;
    while i < Effect::ALL.len() {
        assert!(Effect::ALL[i] as usize == i);
        i += 1;
    }
    assert!(Effect::Pedestal as usize + 1 == Effect::ALL.len());
};

/// Value that each reading gives besides its joint values and directions of approach.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Circumstance {
    /// Mass of the payload (kg).
    PayloadMass,
    /// Coordinate 0, 1 or 2 of the payload's centre of mass in the flange (mm).
    PayloadCentre(usize),
    /// Torque of a joint, by its index (N·m).
    Torque(usize),
    /// Temperature of the robot (°C).
    Temperature,
}

/// One parameter of a model.
///
/// # Examples
///
/// ```
/// use etalon_robots::{Parameter, Quantity, Role};
///
/// // an encoder offset: degrees outside, radians inside
/// let mut offset = Parameter::new("delta1", Quantity::Angle, Role::Robot, 0.0);
/// assert_eq!(offset.quantity.unit(), "deg");
///
/// offset.state_tolerance(180.0);
/// assert_eq!(offset.tolerance, std::f64::consts::PI);
/// assert!(offset.tolerance_is_stated);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Name as in the thesis, e.g. `x_c`.
    pub name: String,
    /// Length, angle or ratio.
    pub quantity: Quantity,
    /// Owner of the parameter.
    pub role: Role,
    /// Effect of a parameter of the robot itself. The zero of a joint counts as geometry here.
    pub effect: Effect,
    /// Index of the joint or leg of the parameter.
    pub joint: Option<usize>,
    /// Index of the joint that causes the effect: it moves a coupled joint or a joint that mimics
    /// it, or the link behind it bends a joint.
    pub by: Option<usize>,
    /// Axis of the world (base) or of the flange (targets) along or about which the parameter acts:
    /// 0, 1 or 2.
    pub axis: Option<usize>,
    /// Nominal value (mm, rad or 1).
    pub nominal: f64,
    /// Largest plausible deviation from nominal by manufacture and mounting (mm, rad or 1); a
    /// larger result indicates a wrong set-up. Infinite for parameters without a nominal value:
    /// base and targets of an arm.
    pub tolerance: f64,
    /// `true` if the tolerance is given for this robot, `false` if it is the default of the kind.
    pub tolerance_is_stated: bool,
    /// Id of the sentence on meaning and sign, which is common to all parameters of the kind.
    pub meaning: &'static str,
}

/// Meaning of a parameter, or title of a drawing, by its id in the catalogue.
pub const fn meaning(id: &'static str) -> &'static str {
    id
}

impl Parameter {
    /// Creates a parameter with its nominal value (mm, rad or 1) and the default tolerance of its
    /// kind.
    pub fn new(name: impl Into<String>, quantity: Quantity, role: Role, nominal: f64) -> Self {
        let tolerance = usual_tolerance(quantity, role);
        Self {
            name: name.into(),
            quantity,
            role,
            effect: if quantity == Quantity::Ratio { Effect::Gains } else { Effect::Geometry },
            joint: None,
            by: None,
            axis: None,
            nominal,
            tolerance,
            tolerance_is_stated: false,
            meaning: usual_meaning(quantity, role),
        }
    }

    /// Creates a coordinate, along or about `axis`, of a base or target without a nominal value.
    pub fn free(name: impl Into<String>, quantity: Quantity, role: Role, axis: usize) -> Self {
        Self { axis: Some(axis), tolerance: f64::INFINITY, ..Self::new(name, quantity, role, 0.0) }
    }

    /// Assigns the parameter to a joint, by its index.
    pub fn with_joint(self, joint: usize) -> Self {
        Self { joint: Some(joint), ..self }
    }

    /// Sets the meaning.
    pub fn meaning(self, meaning: &'static str) -> Self {
        Self { meaning, ..self }
    }

    /// Sets a given tolerance (mm, deg or 1).
    pub fn state_tolerance(&mut self, value: f64) {
        (self.tolerance, self.tolerance_is_stated) = (self.quantity.inward(value), true);
    }

    /// Unit outside with the load or temperature to which the value refers: `deg/(100 N·m)`; `None`
    /// if the value refers to neither.
    pub fn full_unit(&self) -> Option<String> {
        let unit = self.quantity.unit();
        match self.effect {
            Effect::Payload | Effect::Torque | Effect::Lateral | Effect::Pedestal => Some(format!("{unit}/(100 N·m)")),
            Effect::Drift => Some(format!("{unit}/(10 K)")),
            Effect::Expansion => Some("mm/(m·K)".to_owned()),
            _ => None,
        }
    }

    /// Unit outside as messages print it.
    pub fn printed_unit(&self) -> String {
        self.full_unit().unwrap_or_else(|| self.quantity.unit().to_owned())
    }

    /// `true` if the effect of the parameter depends on this value of a reading.
    pub fn depends_on(&self, value: Circumstance) -> bool {
        match value {
            Circumstance::PayloadMass | Circumstance::PayloadCentre(_) => {
                matches!(self.effect, Effect::Payload | Effect::Lateral | Effect::Pedestal)
            }
            Circumstance::Torque(joint) => self.effect == Effect::Torque && self.joint == Some(joint),
            Circumstance::Temperature => self.effect.is_thermal(),
        }
    }

    /// `true` if the default tolerance of a robot part applies, which says nothing about the
    /// quality of the part: it is scaled to the spread of all parts. Coefficients of loads and
    /// temperatures have sizes of their own.
    pub fn scales(&self) -> bool {
        self.role == Role::Robot && !self.tolerance_is_stated && !self.effect.needs_proof()
    }

    /// Initial uncertainty before identification (mm, rad or 1): the default tolerance, independent
    /// of the given tolerance. For parameters without a nominal value, the uncertainty of a rough
    /// estimate of base and targets.
    pub fn known_within(&self) -> f64 {
        usual_tolerance(self.quantity, if self.tolerance.is_finite() { self.role } else { Role::Base })
    }
}

/// Default meaning of base, target and fixture parameters, which are alike in all models.
fn usual_meaning(quantity: Quantity, role: Role) -> &'static str {
    match (role, quantity) {
        (Role::Base, Quantity::Angle) => meaning("meaning-base-orientation"),
        (Role::Base, _) => meaning("meaning-base-origin"),
        (Role::Target, Quantity::Angle) => meaning("meaning-target-orientation"),
        (Role::Target, _) => meaning("meaning-target-place"),
        (Role::Fixture, Quantity::Angle) => meaning("meaning-surface-direction"),
        (Role::Fixture, _) => meaning("meaning-fixture-place"),
        (Role::Robot, _) => "",
    }
}

/// Default tolerance: at least ten times the deviations of real robots (IRB 120: 0.3 mm, 0.1 deg;
/// DexTAR: 0.4 mm, 0.4 deg; PreXYT: 1 mm), and far below the effect of a wrong sign, unit or order.
fn usual_tolerance(quantity: Quantity, role: Role) -> f64 {
    match (quantity, role) {
        (Quantity::Length, Role::Robot) => 10.0,
        (Quantity::Length, _) => 100.0,
        (Quantity::Angle, Role::Robot) => 2f64.to_radians(),
        (Quantity::Angle, _) => 0.2,
        (Quantity::Ratio, _) => 0.05,
    }
}

/// A joint as logged by the controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Joint {
    /// Name, e.g. `rho1` or `q1`.
    pub name: String,
    /// Length or angle.
    pub quantity: Quantity,
}

impl Joint {
    /// Joint q`number` of an arm.
    pub(crate) fn numbered(number: usize, prismatic: bool) -> Self {
        let quantity = if prismatic { Quantity::Length } else { Quantity::Angle };
        Self { name: format!("q{number}"), quantity }
    }

    /// Name of the column in a table of observations: `rho1_mm`, `q1_deg`.
    pub fn column(&self) -> String {
        format!("{}_{}", self.name, self.quantity.unit())
    }

    /// Name of the column of the direction of approach: +1 from below, −1 from above.
    pub fn direction_column(&self) -> String {
        format!("{}_direction", self.name)
    }

    /// Name of the column of the torque of the joint: `tau1_nm` of joint q1, otherwise `NAME_nm`.
    pub fn torque_column(&self) -> String {
        let number = self.name.strip_prefix('q').filter(|rest| rest.parse::<usize>().is_ok());
        number.map_or_else(|| format!("{}_nm", self.name), |number| format!("tau{number}_nm"))
    }

    /// Returns the factor that converts a column of this joint to mm or rad: `q1_deg`, `q1_rad`,
    /// `rho1_mm`, `rho1_m`, `rho1_inch`. `None` if the column does not belong to this joint.
    pub fn factor(&self, column: &str) -> Option<f64> {
        match (self.quantity, column.strip_prefix(&self.name)?) {
            (Quantity::Angle, "_deg") => Some(1f64.to_radians()),
            (Quantity::Angle, "_rad") | (Quantity::Length, "_mm") => Some(1.0),
            (Quantity::Length, "_m") => Some(1000.0),
            (Quantity::Length, "_inch") => Some(25.4),
            _ => None,
        }
    }
}

/// Common data of every robot: parameters, joints and targets, in the order of all slices.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// Short name of the model: `prexyt`, `five_bar`, `serial` ...
    pub model: &'static str,
    /// Number of coordinates measured per target: 2 for planar robots (x, y), otherwise 3.
    pub dimension: usize,
    /// Parameters.
    pub parameters: Vec<Parameter>,
    /// Joints.
    pub joints: Vec<Joint>,
    /// Names of the targets on the moving part.
    pub targets: Vec<String>,
}

impl Definition {
    /// Replaces the nominal values.
    pub fn set_nominal(&mut self, values: &[f64]) {
        for (parameter, value) in self.parameters.iter_mut().zip(values) {
            parameter.nominal = *value;
        }
    }
}
