//! Descriptions that no robot can have.

use super::JointRef;

/// A contradiction in the description of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Where it is.
    pub at: At,
    /// What it is.
    pub kind: FaultKind,
}

/// Place of a fault in a description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum At {
    /// Nowhere: what the fault is about comes from elsewhere.
    Nowhere,
    /// At the value of a key.
    Key(&'static str),
    /// At one of the values, or tables, of a key, counted from 0.
    Item(&'static str, usize),
    /// In the tree of links and joints.
    Tree,
    /// At a joint of that tree.
    TreeJoint(String),
}

/// What is wrong with the description of a robot. Keys are named as their [`super::Key`] names them.
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
    /// A value is stated in both of its units.
    StatedTwice(&'static str),
    /// A hexapod has another number of legs than six.
    LegCount(usize),
    /// The legs do not hold the platform at its home pose.
    SingularHome,
    /// An arm has no joints.
    NoJoints,
    /// The direction of gravity has length zero.
    GravityWithoutDirection,
    /// A reference to joints of an arm is wrong; `joints` are their names.
    Joint {
        /// What is wrong.
        what: JointFault,
        /// Names of all joints.
        joints: Vec<String>,
    },
    /// A value of a screw axis stands among Denavit-Hartenberg parameters.
    NotDenavitHartenberg(&'static str),
    /// Denavit-Hartenberg parameters stand at a screw axis.
    NotScrew,
    /// The axis of a joint has a direction of length zero.
    AxisWithoutDirection,
    /// Screw axes stand without the pose of the flange: without the value of this key.
    NoFlange(&'static str),
    /// A value of the pose of the flange stands beside Denavit-Hartenberg parameters.
    FlangeOfTable(&'static str),
    /// The tree of links and joints is wrong.
    Tree(TreeFault),
}

/// Wrong reference to a joint; joints are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JointFault {
    /// There is no such joint.
    Unknown(JointRef),
    /// The joint slides, and has no turn that a harmonic could follow.
    Slides(usize),
    /// The joint is there twice.
    Twice(usize),
    /// The joint is coupled with itself.
    WithItself(usize),
    /// The pair is there twice.
    PairTwice(usize, usize),
}

/// Wrong tree of links and joints.
#[derive(Clone, Debug, PartialEq)]
pub enum TreeFault {
    /// The joint `joint` is of a kind that no chain has.
    Kind {
        /// Name of the joint.
        joint: String,
        /// Its kind.
        kind: String,
    },
    /// The axis of this joint has length zero.
    NoDirection(String),
    /// The origin of a joint is too far from its parent.
    FarOrigin {
        /// Name of the joint.
        joint: String,
        /// Distance, mm.
        away_mm: f64,
    },
    /// A link has two parents.
    TwoParents {
        /// Name of the link.
        link: String,
        /// Names of the parents.
        parents: [String; 2],
    },
    /// The joints from this link on form a loop.
    Loop(String),
    /// There is no link of this name.
    NoLink {
        /// The name.
        link: String,
        /// Names of all links.
        links: Vec<String>,
    },
    /// No joints lead from one link to another.
    NoPath {
        /// The link that is the base.
        from: String,
        /// The link that carries the targets.
        to: String,
        /// The link that carries `to` and that no joint carries.
        root: String,
    },
    /// A joint follows one that does not exist.
    MimicsUnknown {
        /// Name of the joint.
        joint: String,
        /// Name of the joint that it follows.
        mimics: String,
        /// Names of all joints.
        joints: Vec<String>,
    },
    /// This joint follows itself.
    MimicsItself(String),
    /// No joint moves between two links.
    NothingMoves {
        /// The link that is the base.
        from: String,
        /// The link that carries the targets.
        to: String,
    },
    /// No joint of the tree moves.
    NoMovingJoint,
    /// Joints bend under gravity although joints move this link, the base.
    BendsOnMovingBase(String),
    /// No mass beyond this joint bends it.
    NoMass(String),
    /// Two parameters would have this name.
    DoubledName(String),
}

impl Fault {
    pub(super) fn new(at: At, kind: FaultKind) -> Self {
        Self { at, kind }
    }

    pub(super) fn tree(at: At, fault: TreeFault) -> Self {
        Self { at, kind: FaultKind::Tree(fault) }
    }
}

/// All faults of a description.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Faults(pub Vec<Fault>);

impl Faults {
    pub(super) fn add(&mut self, at: At, kind: FaultKind) {
        self.0.push(Fault { at, kind });
    }

    /// The value of a result, whose faults are kept.
    pub(super) fn keep<T>(&mut self, result: Result<T, Self>) -> Option<T> {
        result.map_err(|faults| self.0.extend(faults.0)).ok()
    }

    /// The value if there is no fault.
    pub(super) fn or<T>(self, value: T) -> Result<T, Self> {
        if self.0.is_empty() { Ok(value) } else { Err(self) }
    }
}

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Self {
        Self(vec![fault])
    }
}
