//! `model = "urdf"`: a chain of joints, or several, from a tree in the Unified Robot Description
//! Format.
//!
//! Small errors precede each moving joint of the chain, in the frame of its origin: two rotations
//! and, for a revolute joint, two translations. They are complete and minimal for any directions
//! of the axes, so that parallel axes need no special parameters.

use crate::branches::Branches;
use crate::conventions::EffectKeys;
use crate::keys::{Description, Reader};
use crate::serial::{ArmBuilder, Body, Drive, Effects, Serial, ThermalEffects};
use crate::{At, Fault, FaultKind, Faults, Joint, Key, Model, Quantity, Robot, TreeFault, wrong_targets};
use etalon_base::pose::{Pose, Vector, cross, norm, unit};
use std::sync::Arc;

/// Robot described by a tree of links and joints.
pub(crate) const MODEL: Model = Model::new::<Keys>("urdf");

/// Maximum plausible distance of origins; larger distances indicate a unit other than metres (mm).
const FURTHEST_MM: f64 = 20_000.0;

/// Sine of the angle below which two axes are nominally parallel.
const PARALLEL: f64 = 1e-6;

/// Description of a robot by chains of a tree.
struct Keys {
    tree: Arc<Tree>,
    base_link: String,
    tool_link: Option<String>,
    branches: Vec<BranchKeys>,
    effects: EffectKeys,
}

const TOOL_LINK: &str = "Link of the URDF that carries the targets: their coordinates are in its frame.";

/// Description of a branch.
struct BranchKeys {
    tool_link: String,
    targets: Vec<String>,
}

impl BranchKeys {
    fn read(keys: &mut Reader) -> Self {
        Self {
            tool_link: keys.required(Key::plain("tool_link", TOOL_LINK)),
            targets: keys.required(Key::plain("targets", "Names of the targets on this link.")),
        }
    }
}

/// A branch: a chain of the tree, and the targets that it carries.
struct Branch<'a> {
    link: &'a str,
    /// Place of the link in the description.
    at: At,
    chain: Vec<Step<'a>>,
    /// Indices of the targets.
    targets: Vec<usize>,
}

impl<'a> Branch<'a> {
    /// Moving joints, from the base.
    fn moving(&self) -> impl Iterator<Item = &'a TreeJoint> + '_ {
        self.chain.iter().map(|step| step.joint).filter(|joint| joint.kind != "fixed")
    }

    /// Effects at the axes of this branch, by their place in it; `effects` counts the axes `axes`
    /// of all branches.
    fn branch_effects(&self, effects: &Effects, axes: &[Joint]) -> Effects {
        let place = |k: &usize| self.moving().position(|joint| joint.name == axes[*k].name);
        let places = |all: &[usize]| all.iter().filter_map(place).collect();
        Effects {
            gravity: effects.gravity,
            bending: places(&effects.bending),
            payload: places(&effects.payload),
            torque: places(&effects.torque),
            thermal: ThermalEffects { drift: places(&effects.thermal.drift), ..effects.thermal },
            lateral: places(&effects.lateral),
            pedestal: effects.pedestal,
            bodies: Vec::new(),
            coupling: effects.coupling.iter().filter_map(|(k, by)| Some((place(k)?, place(by)?))).collect(),
            harmonics: places(&effects.harmonics),
            backlash: places(&effects.backlash),
        }
    }
}

/// Joints whose values move a robot, and their limits (mm or rad).
#[derive(Default)]
struct Drivers {
    joints: Vec<Joint>,
    limits: Vec<Option<[f64; 2]>>,
}

/// Links and joints of a URDF (mm, rad).
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// Links.
    pub links: Vec<Link>,
    /// Joints.
    pub joints: Vec<TreeJoint>,
}

/// A link.
#[derive(Clone, Debug)]
pub struct Link {
    /// Name of the link.
    pub name: String,
    /// Mass (kg); 0 if not given.
    pub mass_kg: f64,
    /// Centre of mass in the frame of the link.
    pub center_mm: Vector,
}

/// A joint between two links.
#[derive(Clone, Debug)]
pub struct TreeJoint {
    /// Name of the joint.
    pub name: String,
    /// Type: `fixed`, `revolute`, `continuous`, `prismatic` or another.
    pub kind: String,
    /// Link that carries the joint.
    pub parent: String,
    /// Link that the joint moves; its frame is the frame of the joint.
    pub child: String,
    /// Frame of the joint in the frame of its parent.
    pub origin: Pose,
    /// Direction of the axis in the frame of the joint, not normalised.
    pub axis: Vector,
    /// Lower and upper limit (m or rad).
    pub limits: Option<[f64; 2]>,
    /// Joint that this joint mimics.
    pub mimic: Option<Mimic>,
}

/// Coupling of a joint's value to another: multiplier · value of the other + offset (m, rad).
#[derive(Clone, Debug)]
pub struct Mimic {
    /// The other joint.
    pub joint: String,
    /// Multiplier (1, m/rad or rad/m).
    pub multiplier: f64,
    /// Offset (m or rad).
    pub offset: f64,
}

impl TreeJoint {
    fn quantity(&self) -> Quantity {
        if self.kind == "prismatic" { Quantity::Length } else { Quantity::Angle }
    }

    /// Conversion factor from units of the file to mm or rad.
    fn scale(&self) -> f64 {
        if self.kind == "prismatic" { 1000.0 } else { 1.0 }
    }

    fn fault(&self, fault: TreeFault) -> Fault {
        Fault::tree(At::TreeJoint(self.name.clone()), fault)
    }

    /// Faults of the joint that prevent its use in a chain.
    fn faults(&self) -> Vec<Fault> {
        let joint = self.name.clone();
        let mut faults = Vec::new();
        if !["fixed", "revolute", "continuous", "prismatic"].contains(&self.kind.as_str()) {
            faults.push(self.fault(TreeFault::Kind { joint: joint.clone(), kind: self.kind.clone() }));
        }
        if self.kind != "fixed" && unit(self.axis).is_none() {
            faults.push(self.fault(TreeFault::NoDirection(joint.clone())));
        }
        let away_mm = norm(self.origin.translation_mm);
        if away_mm > FURTHEST_MM {
            faults.push(self.fault(TreeFault::FarOrigin { joint, away_mm }));
        }
        faults
    }
}

/// A joint of a chain, and whether the chain passes it upward, from child to parent.
#[derive(Clone, Copy, Debug)]
struct Step<'a> {
    joint: &'a TreeJoint,
    upward: bool,
}

/// Chain of a URDF from its root to a link.
#[derive(Clone, Debug)]
pub struct TreeChain {
    /// Root link, which no joint carries.
    pub base_link: String,
    /// Link at the end of the chain.
    pub tool_link: String,
    /// `true` if the link carries no joint.
    pub is_end: bool,
    /// Joints whose values move the chain.
    pub joints: Vec<Joint>,
}

impl Tree {
    /// Part that carries a link, and the frame of the link in the frame of that part: the joint of
    /// `moving` behind which the link lies, or none for the base. Other joints are at zero.
    pub fn carrying_part(&self, link: &str, base_link: &str, moving: &[&str]) -> Option<(Option<&str>, Pose)> {
        let mut place = Pose::identity();
        let mut link = link;
        for _ in 0..=self.joints.len() {
            if link == base_link {
                return Some((None, place));
            }
            let Some(joint) = self.above(link).ok()? else {
                // a pedestal below the base
                let base = self.upward(base_link).ok()?.iter().rev().fold(Pose::identity(), |at, j| at.then(&j.origin));
                return Some((None, base.inverse().then(&place)));
            };
            if moving.contains(&joint.name.as_str()) {
                return Some((Some(&joint.name), place));
            }
            place = joint.origin.then(&place);
            link = &joint.parent;
        }
        None
    }

    /// Finds the chain with the most moving joints, the first of the file in case of ties.
    pub fn longest_chain(&self) -> Result<TreeChain, Faults> {
        let is_parent = |link: &&Link| self.joints.iter().any(|joint| joint.parent == link.name);
        let mut longest: Option<(usize, TreeChain)> = None;
        for leaf in self.links.iter().filter(|link| !is_parent(link)) {
            let base = self.upward(&leaf.name)?.last().map_or(leaf.name.as_str(), |joint| joint.parent.as_str());
            let chain = self.chain([base, &leaf.name])?;
            let moving: Vec<&TreeJoint> =
                chain.iter().map(|step| step.joint).filter(|joint| joint.kind != "fixed").collect();
            let joints = self.drivers(&moving)?;
            let count = moving.len();
            if longest.as_ref().is_none_or(|(most, _)| count > *most) {
                let chain =
                    TreeChain { base_link: base.to_owned(), tool_link: leaf.name.clone(), is_end: true, joints };
                longest = Some((count, chain));
            }
        }
        if longest.is_none() {
            // without a leaf the joints form a loop, which is reported here
            self.links.iter().try_for_each(|link| self.upward(&link.name).map(drop))?;
        }
        let moving = longest.filter(|(count, _)| *count > 0);
        Ok(moving.ok_or_else(|| Fault::tree(At::Tree, TreeFault::NoMovingJoint))?.1)
    }

    /// Returns a chain from the root for each list of moving joints, to a link without joints of
    /// its own where there is one. Chains that cannot be a robot are omitted.
    pub fn chains(&self) -> Vec<TreeChain> {
        let is_parent = |link: &&Link| self.joints.iter().any(|joint| joint.parent == link.name);
        let (inner, ends): (Vec<&Link>, Vec<&Link>) = self.links.iter().partition(is_parent);
        let mut found: Vec<(Vec<&str>, TreeChain)> = Vec::new();
        for (link, is_end) in
            ends.into_iter().map(|link| (link, true)).chain(inner.into_iter().map(|link| (link, false)))
        {
            let Ok(upward) = self.upward(&link.name) else { continue };
            let base = upward.last().map_or(link.name.as_str(), |joint| joint.parent.as_str());
            let Ok(chain) = self.chain([base, &link.name]) else { continue };
            let moving: Vec<&TreeJoint> =
                chain.iter().map(|step| step.joint).filter(|joint| joint.kind != "fixed").collect();
            let names: Vec<&str> = moving.iter().map(|joint| joint.name.as_str()).collect();
            let Ok(joints) = self.drivers(&moving) else { continue };
            if !names.is_empty() && found.iter().all(|(known, _)| *known != names) {
                let (base_link, tool_link) = (base.to_owned(), link.name.clone());
                found.push((names, TreeChain { base_link, tool_link, is_end, joints }));
            }
        }
        found.into_iter().map(|(_, chain)| chain).collect()
    }

    /// Returns the joints whose values move these joints.
    fn drivers(&self, moving: &[&TreeJoint]) -> Result<Vec<Joint>, Faults> {
        let mut joints: Vec<Joint> = Vec::new();
        for joint in moving {
            let (driver, ..) = self.driven_by(joint)?;
            if joints.iter().all(|known| known.name != driver.name) {
                joints.push(Joint { name: driver.name.clone(), quantity: driver.quantity() });
            }
        }
        Ok(joints)
    }

    fn joint(&self, name: &str) -> Option<&TreeJoint> {
        self.joints.iter().find(|joint| joint.name == name)
    }

    /// Joint that moves a link; an error if there are two.
    fn above(&self, link: &str) -> Result<Option<&TreeJoint>, Faults> {
        let mut all = self.joints.iter().filter(|joint| joint.child == link);
        let first = all.next();
        match (first, all.next()) {
            (Some(first), Some(second)) => {
                let parents = [first, second].map(|joint| joint.parent.clone());
                Err(second.fault(TreeFault::TwoParents { link: link.to_owned(), parents }).into())
            }
            _ => Ok(first),
        }
    }

    /// Joints from a link up to the root of the tree.
    fn upward<'a>(&'a self, mut link: &'a str) -> Result<Vec<&'a TreeJoint>, Faults> {
        let mut chain = Vec::new();
        while let Some(joint) = self.above(link)? {
            if chain.len() > self.joints.len() {
                return Err(joint.fault(TreeFault::Loop(joint.child.clone())).into());
            }
            chain.push(joint);
            link = &joint.parent;
        }
        Ok(chain)
    }

    /// Joints from one link to another by way of their common ancestor: up from the base link,
    /// which may move (the flange of another arm, or the table of a positioner), and down to the
    /// tool link.
    fn chain<'a>(&'a self, ends: [&'a str; 2]) -> Result<Vec<Step<'a>>, Faults> {
        let [base_link, tool_link] = ends;
        for (key, link) in [("base_link", base_link), ("tool_link", tool_link)] {
            if self.links.iter().all(|l| l.name != *link) {
                let links = self.links.iter().map(|l| l.name.clone()).collect();
                return Err(Fault::tree(At::Key(key), TreeFault::NoLink { link: link.to_owned(), links }).into());
            }
        }
        let (mut up, mut down) = (self.upward(base_link)?, self.upward(tool_link)?);
        let root = |chain: &[&TreeJoint], link: &str| chain.last().map_or(link.to_owned(), |j| j.parent.clone());
        let (carries_base, carries_tool) = (root(&up, base_link), root(&down, tool_link));
        while let (Some(a), Some(b)) = (up.last(), down.last())
            && std::ptr::eq(*a, *b)
        {
            up.pop();
            down.pop();
        }
        if carries_base != carries_tool || (down.is_empty() && !up.is_empty()) {
            let (from, to) = (base_link.to_owned(), tool_link.to_owned());
            let fault = TreeFault::NoPath { from, to, root: carries_tool };
            return Err(Fault::tree(At::Key("tool_link"), fault).into());
        }
        let upward = up.into_iter().map(|joint| Step { joint, upward: true });
        let chain: Vec<Step> =
            upward.chain(down.into_iter().rev().map(|joint| Step { joint, upward: false })).collect();
        Faults(chain.iter().flat_map(|step| step.joint.faults()).collect()).or(chain)
    }

    /// Joint that drives a joint, with factor and offset (mm, rad).
    fn driven_by<'a>(&'a self, joint: &'a TreeJoint) -> Result<(&'a TreeJoint, f64, f64), Faults> {
        let (mut at, mut factor, mut offset) = (joint, 1.0, 0.0);
        for _ in 0..=self.joints.len() {
            let Some(mimic) = &at.mimic else { return Ok((at, factor, offset)) };
            let other = self.joint(&mimic.joint).ok_or_else(|| {
                let joints = self.joints.iter().map(|j| j.name.clone()).collect();
                let (joint, mimics) = (at.name.clone(), mimic.joint.clone());
                at.fault(TreeFault::MimicsUnknown { joint, mimics, joints })
            })?;
            offset += factor * mimic.offset * at.scale();
            factor *= mimic.multiplier * at.scale() / other.scale();
            at = other;
        }
        Err(joint.fault(TreeFault::MimicsItself(joint.name.clone())).into())
    }

    /// Mass and centre of mass of a link and all links fixed to it, in the frame of the link.
    fn body(&self, link: &str) -> Body {
        let mut open = vec![(link, Pose::identity())];
        let (mut mass_kg, mut sum) = (0.0, [0.0; 3]);
        let mut seen = 0;
        while let Some((name, pose)) = open.pop() {
            for l in self.links.iter().filter(|l| l.name == name) {
                let center = pose.apply(l.center_mm);
                mass_kg += l.mass_kg;
                sum = [0, 1, 2].map(|i| sum[i] + l.mass_kg * center[i]);
            }
            let fixed = self.joints.iter().filter(|j| j.parent == name && j.kind == "fixed");
            open.extend(fixed.map(|j| (j.child.as_str(), pose.then(&j.origin))));
            seen += 1;
            if seen > self.links.len() {
                break;
            }
        }
        let center_mm = if mass_kg > 0.0 { sum.map(|v| v / mass_kg) } else { [0.0; 3] };
        Body { mass_kg, center_mm }
    }
}

/// Joints of a chain that move its base.
fn base_joints(chain: &[Step]) -> Vec<String> {
    let moving = chain.iter().filter(|step| step.upward && step.joint.kind != "fixed");
    moving.map(|step| step.joint.name.clone()).collect()
}

impl Description for Keys {
    fn read(keys: &mut Reader) -> Self {
        Self {
            tree: keys.required(Key::plain("file", "URDF file of the robot, in the folder of robot.toml.")),
            base_link: keys.required(Key::plain(
                "base_link",
                "Link of the URDF that is the base: a stationary link. Without an external instrument it may be the flange of another arm or a part on a positioner.",
            )),
            tool_link: keys.optional(Key::plain("tool_link", TOOL_LINK).essential()),
            branches: keys.tables(
                Key::plain(
                    "branch",
                    "Branches of a tree of which several links carry targets, such as two hands of one torso, instead of `tool_link`. Parameters of their common joints are identified once.",
                ),
                "Link at the end of a branch, and its targets.",
                BranchKeys::read,
            ),
            effects: EffectKeys::read(keys),
        }
    }

    fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        let branches = self.branches(targets)?;
        let mut faults = wrong_targets(targets);
        for branch in branches.iter().filter(|branch| branch.moving().next().is_none()) {
            let (from, to) = (self.base_link.clone(), branch.link.to_owned());
            faults.add(branch.at.clone(), FaultKind::Tree(TreeFault::NothingMoves { from, to }));
        }
        let mut axes: Vec<Joint> = Vec::new();
        for joint in branches.iter().flat_map(Branch::moving) {
            if axes.iter().all(|known| known.name != joint.name) {
                axes.push(Joint { name: joint.name.clone(), quantity: joint.quantity() });
            }
        }
        let effects = faults.keep(self.effects.among(&axes));
        let mut of_base: Vec<String> = Vec::new();
        for joint in branches.iter().flat_map(|branch| base_joints(&branch.chain)) {
            if !of_base.contains(&joint) {
                of_base.push(joint);
            }
        }
        let elastic = &self.effects;
        for (key, is_stated) in [
            ("bending", !elastic.bending.is_empty()),
            ("payload", !elastic.payload.is_empty()),
            ("lateral", !elastic.lateral.is_empty()),
            ("pedestal", elastic.pedestal),
        ] {
            if is_stated && !of_base.is_empty() {
                let fault = TreeFault::BendsOnMovingBase(self.base_link.clone());
                faults.add(At::Key(key), FaultKind::Tree(fault));
            }
        }
        if let Some(effects) = &effects {
            faults.0.extend(wrong_effects(effects, &axes, &branches));
        }
        let Some(effects) = effects.filter(|_| faults.0.is_empty()) else { return Err(faults) };
        let Drivers { joints, limits } = self.drivers(&branches)?;
        let mut arms: Vec<ArmBuilder> = Vec::new();
        for branch in &branches {
            let mut arm = arms.last().map_or_else(|| ArmBuilder::new(targets), ArmBuilder::branch);
            let own = branch.branch_effects(&effects, &axes);
            arm.elastic(&own);
            arm.sag(&own.bending);
            self.assemble(&mut arm, branch, &joints)?;
            faults.0.extend(add_effects(&mut arm, &own, joints.len()));
            arms.push(arm);
        }
        if let Some(name) = arms.last().and_then(ArmBuilder::doubled) {
            faults.add(At::Nowhere, FaultKind::Tree(TreeFault::DoubledName(name.to_owned())));
        }
        faults.or(())?;
        let last = arms.last().map(ArmBuilder::branch);
        let built = arms.into_iter().map(|mut arm| {
            last.iter().for_each(|last| arm.complete(last));
            let arm = arm.build("urdf", joints.clone(), effects.gravity);
            arm.with_limits(limits.clone()).on_moving_base(of_base.clone())
        });
        let mut built: Vec<Serial> = built.collect();
        if built.len() == 1 {
            return Ok(Box::new(built.remove(0)));
        }
        let of_target = |k: usize| branches.iter().position(|branch| branch.targets.contains(&k)).unwrap_or(0);
        let links = branches.iter().map(|branch| branch.link.to_owned()).collect();
        let of_target = (0..targets.len()).map(of_target).collect();
        let robot = Branches::new(built, links, of_target);
        robot.map_or_else(
            || Err(Fault::tree(At::Tree, TreeFault::NoMovingJoint).into()),
            |robot| Ok(Box::new(robot) as _),
        )
    }
}

impl Keys {
    /// The given branches with their chains; a single one without `branch`.
    fn branches(&self, targets: &[String]) -> Result<Vec<Branch<'_>>, Faults> {
        let tree_fault = |at, fault| Err(Fault::tree(at, fault).into());
        match (&self.tool_link, &self.branches[..]) {
            (Some(link), []) => {
                let chain = self.tree.chain([&self.base_link, link])?;
                let targets = (0..targets.len()).collect();
                return Ok(vec![Branch { link, at: At::Key("tool_link"), chain, targets }]);
            }
            (None, []) => return tree_fault(At::Nowhere, TreeFault::NoToolLink),
            (Some(_), _) => return tree_fault(At::Key("tool_link"), TreeFault::ToolLinkBesideBranches),
            (None, _) => {}
        }
        let mut faults = Faults::default();
        let mut all: Vec<Branch> = Vec::new();
        for (i, keys) in self.branches.iter().enumerate() {
            let (link, at) = (keys.tool_link.as_str(), At::Item("branch", i));
            let chain = self.tree.chain([&self.base_link, link]).map_err(|mut faults| {
                let of_link = |fault: &&mut Fault| fault.at == At::Key("tool_link");
                faults.0.iter_mut().filter(of_link).for_each(|fault| fault.at = at.clone());
                faults
            });
            let own = (0..targets.len()).filter(|&k| keys.targets.contains(&targets[k])).collect();
            all.extend(faults.keep(chain).map(|chain| Branch { link, at, chain, targets: own }));
        }
        for target in targets {
            let on: Vec<usize> =
                (0..self.branches.len()).filter(|&i| self.branches[i].targets.contains(target)).collect();
            let target = target.clone();
            match on[..] {
                [] => {
                    let known = self.branches.iter().flat_map(|branch| branch.targets.iter().cloned()).collect();
                    let fault = TreeFault::TargetOnNoBranch { target, known };
                    faults.add(At::Key("branch"), FaultKind::Tree(fault));
                }
                [first, second, ..] => {
                    let links = [first, second].map(|i| self.branches[i].tool_link.clone());
                    let fault = TreeFault::TargetOnTwoBranches { target, links };
                    faults.add(At::Item("branch", second), FaultKind::Tree(fault));
                }
                _ => {}
            }
        }
        faults.or(all)
    }

    /// Joints whose values move the branches, in the order of the chains.
    fn drivers(&self, branches: &[Branch]) -> Result<Drivers, Faults> {
        let mut all = Drivers::default();
        for joint in branches.iter().flat_map(Branch::moving) {
            let (driver, ..) = self.tree.driven_by(joint)?;
            if all.joints.iter().all(|known| known.name != driver.name) {
                all.joints.push(Joint { name: driver.name.clone(), quantity: driver.quantity() });
                let endless = (driver.kind == "continuous").then_some([f64::NEG_INFINITY, f64::INFINITY]);
                all.limits.push(driver.limits.or(endless).map(|l| l.map(|v| v * driver.scale())));
            }
        }
        Ok(all)
    }

    /// Adds the axes of a branch to an arm.
    fn assemble(&self, arm: &mut ArmBuilder, branch: &Branch, joints: &[Joint]) -> Result<(), Faults> {
        let tree = &self.tree;
        // preceding sliding axis, in the frame of the joint, and the joint that drives it
        let mut before: Option<(Vector, &str)> = None;
        for Step { joint, upward } in &branch.chain {
            let pass = |arm: &mut ArmBuilder, before: &mut Option<(Vector, &str)>, origin: Pose| {
                arm.place(origin);
                *before = before.map(|(axis, driver)| (origin.inverse().rotate(axis), driver));
            };
            if !upward {
                pass(arm, &mut before, joint.origin);
            }
            if joint.kind == "fixed" {
                if *upward {
                    pass(arm, &mut before, joint.origin.inverse());
                }
                continue;
            }
            let (driver, factor, offset) = tree.driven_by(joint)?;
            let index = joints.iter().position(|j| j.name == driver.name).unwrap_or_default();
            let prismatic = joint.kind == "prismatic";
            let name = joint.name.clone();
            let mimics = joint.mimic.is_some();
            let drive = Drive { label: name.clone(), name, joint: index, factor, offset, prismatic, mimics };
            // a joint that is passed upward moves in the opposite direction
            let axis = unit(joint.axis).unwrap_or_default().map(|v| if *upward { -v } else { v });
            let parallel = |along: Vector| norm(cross(along, axis)) < PARALLEL;
            let follows = prismatic && before.is_some_and(|(along, by)| by == driver.name && parallel(along));
            arm.screw(axis, drive, follows);
            before = prismatic.then_some((axis, driver.name.as_str()));
            arm.carry(tree.body(&joint.child));
            if *upward {
                pass(arm, &mut before, joint.origin.inverse());
            }
        }
        Ok(())
    }
}

/// Adds gains and effects to an arm with `joints` joint values; returns faults.
fn add_effects(arm: &mut ArmBuilder, effects: &Effects, joints: usize) -> Vec<Fault> {
    let mut faults = Vec::new();
    arm.complete_axes();
    arm.harmonics(&effects.harmonics);
    arm.backlash(&effects.backlash, joints);
    arm.payload(&effects.payload);
    arm.torque(&effects.torque);
    arm.temperature(effects);
    arm.tilts(effects.gravity);
    for &k in &effects.bending {
        if !arm.is_loaded(k) {
            faults.push(Fault::tree(At::Key("bending"), TreeFault::NoMass(arm.name(k).to_owned())));
        }
        arm.bending_by_masses(k);
    }
    arm.coupling(&effects.coupling);
    faults
}

/// Faults of effects that one branch alone does not describe.
fn wrong_effects(effects: &Effects, axes: &[Joint], branches: &[Branch]) -> Vec<Fault> {
    let has = |branch: &Branch, k: usize| branch.moving().any(|joint| joint.name == axes[k].name);
    let name = |k: usize| axes[k].name.clone();
    let mut faults = Vec::new();
    for &k in &effects.bending {
        if branches.iter().filter(|branch| has(branch, k)).count() > 1 {
            faults.push(Fault::tree(At::Key("bending"), TreeFault::BendsInBranches(name(k))));
        }
    }
    // each hand would have a payload of its own
    for &k in effects.payload.iter().filter(|_| branches.len() > 1) {
        faults.push(Fault::tree(At::Key("payload"), TreeFault::PayloadInBranches(name(k))));
    }
    for (key, is_stated) in [("lateral", !effects.lateral.is_empty()), ("pedestal", effects.pedestal)] {
        if is_stated && branches.len() > 1 {
            faults.push(Fault::tree(At::Key(key), TreeFault::ElasticInBranches(key)));
        }
    }
    for &(k, by) in &effects.coupling {
        if let Some(branch) = branches.iter().find(|branch| has(branch, k) && !has(branch, by)) {
            let (joint, by, link) = (name(k), name(by), branch.link.to_owned());
            faults.push(Fault::tree(At::Key("coupling"), TreeFault::CoupledAcrossBranches { joint, by, link }));
        }
    }
    faults
}
