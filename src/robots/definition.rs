//! What a parameter and a joint are.

/// What is measured: decides the unit at the door.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Millimetres inside and outside.
    Length,
    /// Radians inside, degrees outside.
    Angle,
    /// A number without unit.
    Ratio,
}

impl Quantity {
    /// Unit outside: `mm`, `deg` or `1`.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Length => "mm",
            Self::Angle => "deg",
            Self::Ratio => "1",
        }
    }

    /// A value in the unit outside.
    pub fn outward(self, value: f64) -> f64 {
        if self == Self::Angle { value.to_degrees() } else { value }
    }

    /// A value from the unit outside.
    pub fn inward(self, value: f64) -> f64 {
        if self == Self::Angle { value.to_radians() } else { value }
    }
}

/// What a parameter describes: decides what is fitted "before" the calibration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// Pose of the base in the world.
    Base,
    /// Places of the targets on the moving part.
    Target,
    /// What targets touch or are measured from: points and planes that are fixed in the world.
    Fixture,
    /// Geometry, joint offsets, gains and compliance of the robot itself.
    #[default]
    Robot,
}

/// What a parameter of the robot itself describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// Zeros of the joints.
    Zeros,
    /// Lengths and angles of the parts.
    Geometry,
    /// Gains: leads, ratios of the transmissions.
    Gains,
    /// Harmonics of the transmissions.
    Harmonics,
    /// Backlash of the joints.
    Backlash,
    /// Coupling of one joint to another.
    Coupling,
    /// Bending of joints and links under loads.
    Bending,
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
    /// What it describes.
    pub role: Role,
    /// Effect of a parameter of the robot itself; a zero of a joint is geometry here.
    pub effect: Effect,
    /// Index of the joint, or leg, that it belongs to.
    pub joint: Option<usize>,
    /// Index of the joint behind the effect: it moves a coupled joint, or the link behind it bends a joint.
    pub by: Option<usize>,
    /// Axis of the world (base) or of the flange (targets) along or about which it is: 0, 1 or 2.
    pub axis: Option<usize>,
    /// Nominal value, in mm, rad or 1.
    pub nominal: f64,
    /// How far from nominal the part may be as it is drawn and mounted, in mm, rad or 1: a result beyond it is that of a wrong
    /// set-up. Infinite for base and targets without a nominal value: those of an arm.
    pub tolerance: f64,
    /// `true` if the tolerance is stated for this robot, and is not that of its kind.
    pub tolerance_is_stated: bool,
    /// What it is and which sign it has, in a sentence that is the same for parameters of a kind.
    pub meaning: &'static str,
}

/// Marks what a parameter means, or what a drawing shows: the report translates it.
pub const fn meaning(text: &'static str) -> &'static str {
    text
}

impl Parameter {
    /// A parameter with its nominal value in mm, rad or 1, and the tolerance of its kind.
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

    /// A coordinate, along or about `axis`, of a base or target without a nominal value.
    pub fn free(name: impl Into<String>, quantity: Quantity, role: Role, axis: usize) -> Self {
        Self { axis: Some(axis), tolerance: f64::INFINITY, ..Self::new(name, quantity, role, 0.0) }
    }

    /// The same of a joint, by its index.
    pub fn of_joint(self, joint: usize) -> Self {
        Self { joint: Some(joint), ..self }
    }

    /// The same with its meaning.
    pub fn meaning(self, meaning: &'static str) -> Self {
        Self { meaning, ..self }
    }

    /// Takes a tolerance that is stated, in mm, deg or 1.
    pub fn state_tolerance(&mut self, value: f64) {
        (self.tolerance, self.tolerance_is_stated) = (self.quantity.inward(value), true);
    }

    /// `true` if the usual tolerance of a part of the robot counts, which says nothing of how well this one is made.
    pub fn scales(&self) -> bool {
        self.role == Role::Robot && !self.tolerance_is_stated
    }

    /// How well it is known before anything is identified (mm, rad, 1): as drawings have it, whatever tolerance is stated, or, where it
    /// has no nominal value, as a look at base and targets shows it.
    pub fn known_within(&self) -> f64 {
        usual_tolerance(self.quantity, if self.tolerance.is_finite() { self.role } else { Role::Base })
    }
}

/// Meaning where a model has no other: base, targets and fixtures are alike in all.
fn usual_meaning(quantity: Quantity, role: Role) -> &'static str {
    match (role, quantity) {
        (Role::Base, Quantity::Angle) => {
            meaning("Orientation of the base in the world, as a rotation vector; counterclockwise positive.")
        }
        (Role::Base, _) => meaning("Origin of the base in the world, along the axis that the name ends with."),
        (Role::Target, Quantity::Angle) => {
            meaning("Orientation on the flange of the body that carries the target, as a rotation vector.")
        }
        (Role::Target, _) => meaning(
            "Place of the target in the frame of the flange or platform, along the axis that the name ends with.",
        ),
        (Role::Fixture, Quantity::Angle) => meaning(
            "Direction of a surface that is fixed in the world: slope of its trace along the axis that the name ends with.",
        ),
        (Role::Fixture, _) => meaning(
            "Place or size of what is fixed in the world: coordinate along the axis that the name ends with, or radius.",
        ),
        (Role::Robot, _) => "",
    }
}

/// Tolerance where none is stated: ten times and more of what robots show (IRB 120: 0.3 mm, 0.1 deg; DexTAR 0.4 mm, 0.4 deg;
/// PreXYT 1 mm), and far below what a wrong sign, unit or order makes of it.
fn usual_tolerance(quantity: Quantity, role: Role) -> f64 {
    match (quantity, role) {
        (Quantity::Length, Role::Robot) => 10.0,
        (Quantity::Length, _) => 100.0,
        (Quantity::Angle, Role::Robot) => 2f64.to_radians(),
        (Quantity::Angle, _) => 0.2,
        (Quantity::Ratio, _) => 0.05,
    }
}

/// One joint as the controller logs it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Joint {
    /// Name, e.g. `rho1` or `q1`.
    pub name: String,
    /// Length or angle.
    pub quantity: Quantity,
}

impl Joint {
    /// Joint q`number` of an arm.
    pub(super) fn numbered(number: usize, prismatic: bool) -> Self {
        let quantity = if prismatic { Quantity::Length } else { Quantity::Angle };
        Self { name: format!("q{number}"), quantity }
    }

    /// Name of the column in a table of observations: `rho1_mm`, `q1_deg`.
    pub fn column(&self) -> String {
        format!("{}_{}", self.name, self.quantity.unit())
    }

    /// Name of the column of the direction from which it came: +1 from below, -1 from above.
    pub fn direction_column(&self) -> String {
        format!("{}_direction", self.name)
    }

    /// What the values of a column of this joint are multiplied by to be in mm or rad: `q1_deg`, `q1_rad`, `rho1_mm`, `rho1_m`; `None`
    /// where the column is not this joint's.
    pub fn factor(&self, column: &str) -> Option<f64> {
        match (self.quantity, column.strip_prefix(&self.name)?) {
            (Quantity::Angle, "_deg") => Some(1f64.to_radians()),
            (Quantity::Angle, "_rad") | (Quantity::Length, "_mm") => Some(1.0),
            (Quantity::Length, "_m") => Some(1000.0),
            _ => None,
        }
    }
}

/// What every robot has: its parameters, joints and targets, each in the order in which slices of them come.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// Short name of the model: `prexyt`, `five_bar`, `serial` ...
    pub model: &'static str,
    /// Coordinates measured per target: 2 for planar robots (x, y), 3 in space.
    pub dimension: usize,
    /// The parameters.
    pub parameters: Vec<Parameter>,
    /// The joints.
    pub joints: Vec<Joint>,
    /// Names of the targets on the moving part.
    pub targets: Vec<String>,
}

impl Definition {
    /// Takes other nominal values.
    pub fn set_nominal(&mut self, values: &[f64]) {
        for (parameter, value) in self.parameters.iter_mut().zip(values) {
            parameter.nominal = *value;
        }
    }
}
