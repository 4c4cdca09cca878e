//! Faults in the description of a robot.

use crate::JointRef;

/// A contradiction in the description of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Place of the fault.
    pub at: At,
    /// Kind of the fault.
    pub kind: FaultKind,
}

/// Place of a fault in a description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum At {
    /// Outside the description.
    Nowhere,
    /// At the value of a key.
    Key(&'static str),
    /// At one of the values or tables of a key, counted from 0.
    Item(&'static str, usize),
    /// In the tree of links and joints.
    Tree,
    /// At a joint of the tree.
    TreeJoint(String),
}

/// Kind of a fault in the description of a robot. Keys are named by their [`crate::Key`].
#[derive(Clone, Debug, PartialEq)]
pub enum FaultKind {
    /// A robot in space has no target.
    NoTarget,
    /// A target has the name of the robot's base.
    TargetCalledBase,
    /// A length is zero, negative or not finite.
    NotPositive(&'static str),
    /// A value that the other values require is missing.
    Missing(&'static str),
    /// A value is given in both of its units.
    StatedTwice(&'static str),
    /// A twist or offset of a joint is in another unit than its key: degrees in a key of radians,
    /// or a multiple of a quarter turn in radians in a key of degrees.
    AngleUnit {
        /// Key of the angle.
        key: &'static str,
        /// Angle as the key gives it.
        angle_rad: f64,
    },
    /// A hexapod does not have six legs.
    LegCount(usize),
    /// The legs do not hold the platform at its home pose (singular configuration).
    SingularHome,
    /// An arm has no joints.
    NoJoints,
    /// The direction of gravity has zero length.
    GravityWithoutDirection,
    /// A reference to joints of an arm is wrong.
    Joint {
        /// Kind of the wrong reference.
        what: JointFault,
        /// Names of all joints.
        joints: Vec<String>,
    },
    /// A value of a screw axis is given among Denavit-Hartenberg parameters.
    NotDenavitHartenberg(&'static str),
    /// Denavit-Hartenberg parameters are given for a screw axis.
    NotScrew,
    /// The axis of a joint has zero length.
    AxisWithoutDirection,
    /// Screw axes are given without the pose of the flange (value of this key).
    NoFlange(&'static str),
    /// The pose of the flange is given together with Denavit-Hartenberg parameters.
    FlangeOfTable(&'static str),
    /// Limits are given for the wrong kind of joint (sliding or revolute).
    RangeOfOtherMotion {
        /// Key of the given limits.
        key: &'static str,
        /// Key of the limits that apply to the joint.
        own: &'static str,
    },
    /// The lower limit is not below the upper limit.
    NoRange {
        /// Key of the given limits.
        key: &'static str,
        /// Lower and upper limit (mm or rad).
        ends: [f64; 2],
    },
    /// The tree of links and joints is wrong.
    Tree(TreeFault),
}

/// Wrong reference to a joint; joints are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JointFault {
    /// The joint does not exist.
    Unknown(JointRef),
    /// The joint slides; harmonics need a revolute joint.
    Slides(usize),
    /// The joint is listed twice.
    Twice(usize),
    /// The joint is coupled to itself.
    WithItself(usize),
    /// The pair is listed twice.
    PairTwice(usize, usize),
}

/// Wrong tree of links and joints.
#[derive(Clone, Debug, PartialEq)]
pub enum TreeFault {
    /// The type of a joint is not supported.
    Kind {
        /// Name of the joint.
        joint: String,
        /// Type of the joint.
        kind: String,
    },
    /// The axis of this joint has zero length.
    NoDirection(String),
    /// The origin of a joint is implausibly far from its parent.
    FarOrigin {
        /// Name of the joint.
        joint: String,
        /// Distance (mm).
        away_mm: f64,
    },
    /// A link has two parents.
    TwoParents {
        /// Name of the link.
        link: String,
        /// Names of the parents.
        parents: [String; 2],
    },
    /// The joints below this link form a loop.
    Loop(String),
    /// A link does not exist.
    NoLink {
        /// Name of the missing link.
        link: String,
        /// Names of all links.
        links: Vec<String>,
    },
    /// No joints lead from one link to another.
    NoPath {
        /// Link of the base.
        from: String,
        /// Link of the targets.
        to: String,
        /// Root of the tree that contains `to`.
        root: String,
    },
    /// A joint mimics a joint that does not exist.
    MimicsUnknown {
        /// Name of the joint.
        joint: String,
        /// Name of the mimicked joint.
        mimics: String,
        /// Names of all joints.
        joints: Vec<String>,
    },
    /// This joint mimics itself.
    MimicsItself(String),
    /// No joint moves between two links.
    NothingMoves {
        /// Link of the base.
        from: String,
        /// Link of the targets.
        to: String,
    },
    /// No joint of the tree moves.
    NoMovingJoint,
    /// Joints bend under gravity although this link, the base, is moved by joints.
    BendsOnMovingBase(String),
    /// No mass beyond this joint can bend it.
    NoMass(String),
    /// Two parameters have the same name.
    DoubledName(String),
    /// Neither a link of the targets nor branches are given.
    NoToolLink,
    /// A link of all targets is given together with branches.
    ToolLinkBesideBranches,
    /// A target is on two branches.
    TargetOnTwoBranches {
        /// Name of the target.
        target: String,
        /// Links of the branches.
        links: [String; 2],
    },
    /// A target is on no branch.
    TargetOnNoBranch {
        /// Name of the target.
        target: String,
        /// Targets on all branches.
        known: Vec<String>,
    },
    /// A joint that several branches share bends: the masses of one branch do not tell its load.
    BendsInBranches(String),
    /// A joint of a robot with several branches bends under a payload.
    PayloadInBranches(String),
    /// Joints or the base of a robot with several branches tilt (this key): the moment of one
    /// branch is not the moment of all branches.
    ElasticInBranches(&'static str),
    /// A joint is coupled to a joint of another branch.
    CoupledAcrossBranches {
        /// Name of the coupled joint.
        joint: String,
        /// Name of the joint that moves it.
        by: String,
        /// Link of a branch that has the coupled joint alone.
        link: String,
    },
}

impl Fault {
    pub(crate) fn new(at: At, kind: FaultKind) -> Self {
        Self { at, kind }
    }

    pub(crate) fn tree(at: At, fault: TreeFault) -> Self {
        Self { at, kind: FaultKind::Tree(fault) }
    }
}

/// All faults of a description.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Faults(pub Vec<Fault>);

impl Faults {
    pub(crate) fn add(&mut self, at: At, kind: FaultKind) {
        self.0.push(Fault { at, kind });
    }

    /// Returns the value of a result, or collects its faults.
    pub(crate) fn keep<T>(&mut self, result: Result<T, Self>) -> Option<T> {
        result.map_err(|faults| self.0.extend(faults.0)).ok()
    }

    /// Returns the value if there are no faults.
    pub(crate) fn or<T>(self, value: T) -> Result<T, Self> {
        if self.0.is_empty() { Ok(value) } else { Err(self) }
    }
}

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Self {
        Self(vec![fault])
    }
}
