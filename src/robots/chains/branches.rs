//! Robots in space with several branches: chains from one base that share their first joints and
//! end at different links, such as the two hands of a torso.
//!
//! The chains are [`Serial`] arms that number the parameters, joints and targets of the whole
//! robot. A parameter of a common joint is therefore one parameter.

use crate::serial::{Serial, WithParameters};
use crate::{
    Circumstance, Definition, FreeBase, JointRange, Loads, OptionalParameter, Outline, Parametrised, Robot, State,
};
use etalon_base::catalogue::Phrase;
use etalon_base::pose::{Pose, Vector};
use etalon_base::sketch::Sketch;

/// A robot with several branches.
#[derive(Clone, Debug)]
pub(crate) struct Branches {
    definition: Definition,
    /// Chains of the branches. Their nominal values are taken from the description: later values
    /// are in `definition` alone.
    arms: Vec<Serial>,
    /// Link at the end of each branch.
    links: Vec<String>,
    /// Branch of each target.
    of_target: Vec<usize>,
}

impl Branches {
    /// Joins chains with the same definition that end at `links`; `of_target` has the branch of
    /// each target.
    pub fn new(arms: Vec<Serial>, links: Vec<String>, of_target: Vec<usize>) -> Option<Self> {
        let definition = arms.first()?.definition().clone();
        Some(Self { definition, arms, links, of_target })
    }

    /// The chains with the present nominal values.
    fn present(&self) -> impl Iterator<Item = Serial> + '_ {
        self.arms.iter().cloned().map(|mut arm| {
            *arm.definition_mut() = self.definition.clone();
            arm
        })
    }

    /// Loads of all branches at joint values.
    fn loads_at(&self, nominal: &[f64], joints: &[f64]) -> Vec<f64> {
        self.arms.iter().flat_map(|arm| arm.loads_with_parameters(nominal, joints)).collect()
    }

    /// State of a branch: the joint values of the robot with the loads of the branch.
    fn branch_state<'s>(&self, branch: usize, state: State<'s>) -> State<'s> {
        let first: usize = self.arms[..branch].iter().map(Serial::load_count).sum();
        State { loads: &state.loads[first..][..self.arms[branch].load_count()], ..state }
    }

    fn with(&self, parameters: &[f64]) -> Bound<'_> {
        Bound { robot: self, arms: self.arms.iter().map(|arm| arm.with(parameters)).collect() }
    }

    /// Calls `evaluate` with the arm that carries a target, at these parameters and joint values.
    fn at<T>(
        &self,
        parameters: &[f64],
        joints: &[f64],
        target: usize,
        evaluate: impl FnOnce(&WithParameters, State) -> T,
    ) -> T {
        let branch = self.target_branch(target);
        let arm = &self.arms[branch];
        let loads = if arm.load_count() == 0 { Vec::new() } else { arm.loads_with_parameters(&self.nominal(), joints) };
        evaluate(&arm.with(parameters), State { joints, loads: &loads })
    }
}

impl Robot for Branches {
    fn definition(&self) -> &Definition {
        &self.definition
    }
    fn definition_mut(&mut self) -> &mut Definition {
        &mut self.definition
    }
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        self.with(parameters).positions(State { joints, loads: &self.loads_at(&self.nominal(), joints) }, out);
    }
    fn position(&self, parameters: &[f64], joints: &[f64], target: usize) -> Vector {
        self.at(parameters, joints, target, |arm, state| arm.target(&arm.flange(state), target))
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        self.with(parameters).jacobian(State { joints, loads: &self.loads_at(&self.nominal(), joints) }, out);
    }
    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let state = State { joints, loads: &self.loads_at(&self.nominal(), joints) };
        self.with(parameters).joint_jacobian(state, &mut vec![0.0; 3 * self.of_target.len()], out);
    }
    fn loads(&self) -> Option<Loads<'_>> {
        let any = self.arms.iter().any(|arm| arm.load_count() > 0);
        let nominal = self.nominal();
        any.then(|| -> Loads<'_> { Box::new(move |joints| self.loads_at(&nominal, joints)) })
    }
    fn parametrised<'a>(&'a self, parameters: &'a [f64]) -> Box<dyn Parametrised + 'a> {
        Box::new(self.with(parameters))
    }
    fn approached(&self) -> &[usize] {
        self.arms[0].approached()
    }
    fn circumstances(&self) -> &[Circumstance] {
        self.arms[0].circumstances()
    }
    fn reference_temperature_c(&self) -> Option<f64> {
        self.arms.iter().find_map(|arm| arm.reference_temperature_c())
    }
    fn branches(&self) -> &[String] {
        &self.links
    }
    fn target_branch(&self, target: usize) -> usize {
        self.of_target.get(target).copied().unwrap_or(0)
    }
    fn joints_of_base(&self) -> &[String] {
        self.arms[0].joints_of_base()
    }
    fn limit_violation(&self, parameters: &[f64], joints: &[f64]) -> Option<Phrase> {
        self.arms[0].limit_violation(parameters, joints)
    }
    fn joint_range(&self, joint: usize) -> JointRange {
        self.arms[0].joint_range(joint)
    }
    fn nominal_gain(&self, joint: usize) -> f64 {
        let nominal = self.nominal();
        self.arms.iter().find_map(|arm| arm.joint_gain(joint, &nominal)).unwrap_or(1.0)
    }
    fn free_base(&self) -> Option<&dyn FreeBase> {
        Some(self)
    }
    fn sketches(&self) -> Vec<Sketch> {
        self.present().flat_map(|arm| arm.sketches()).collect()
    }
    fn outline(&self, parameters: &[f64], joints: &[f64]) -> Outline {
        let loads = self.loads_at(&self.nominal(), joints);
        let mut all = Outline::default();
        for (branch, arm) in self.arms.iter().enumerate() {
            let lines = arm.outline_under(parameters, self.branch_state(branch, State { joints, loads: &loads })).lines;
            // the common joints are in each branch
            let new: Vec<_> = lines.into_iter().filter(|line| !all.lines.contains(line)).collect();
            all.lines.extend(new);
        }
        all
    }
    fn part_frames(&self, parameters: &[f64], joints: &[f64]) -> Vec<(String, Pose)> {
        let loads = self.loads_at(&self.nominal(), joints);
        let mut all: Vec<(String, Pose)> = Vec::new();
        for (branch, arm) in self.arms.iter().enumerate() {
            let state = self.branch_state(branch, State { joints, loads: &loads });
            for part in arm.part_frames_under(parameters, state) {
                // the common joints are in each branch
                if all.iter().all(|(name, _)| *name != part.0) {
                    all.push(part);
                }
            }
        }
        all
    }
    fn optional_parameters(&self) -> Vec<OptionalParameter> {
        let mut all: Vec<OptionalParameter> = Vec::new();
        for parameter in self.arms.iter().flat_map(Robot::optional_parameters) {
            if all.iter().all(|known| known.name != parameter.name) {
                all.push(parameter);
            }
        }
        all
    }
}

impl FreeBase for Branches {
    fn flange(&self, parameters: &[f64], joints: &[f64], target: usize) -> Pose {
        self.at(parameters, joints, target, |arm, state| arm.flange(state))
    }
    fn joint_value(
        &self,
        parameters: &[f64],
        joints: &[f64],
        joint: usize,
        write: &mut dyn FnMut(usize, f64),
    ) -> Option<f64> {
        let nominal = self.nominal();
        self.arms.iter().find_map(|arm| arm.joint_value_about([&nominal, parameters], joints, joint, write))
    }
    fn flange_turns(&self, parameters: &[f64], joints: &[f64], target: usize, out: &mut [f64]) {
        self.at(parameters, joints, target, |arm, state| arm.flange_turns(state, out));
    }
}

/// A robot with bound parameters.
struct Bound<'a> {
    robot: &'a Branches,
    arms: Vec<WithParameters<'a>>,
}

impl Bound<'_> {
    /// Branches with their states and with the targets that they carry.
    fn parts<'s>(
        &'s self,
        state: State<'s>,
        targets: &'s [usize],
    ) -> impl Iterator<Item = (&'s WithParameters<'s>, State<'s>, Vec<usize>)> + 's {
        let of = move |branch: usize| targets.iter().copied().filter(move |&k| self.robot.target_branch(k) == branch);
        let parts = self.arms.iter().enumerate();
        let parts = parts.map(move |(i, arm)| (arm, self.robot.branch_state(i, state), of(i).collect::<Vec<_>>()));
        parts.filter(|(.., targets)| !targets.is_empty())
    }

    fn all(&self) -> Vec<usize> {
        (0..self.robot.of_target.len()).collect()
    }
}

impl Parametrised for Bound<'_> {
    fn positions(&self, state: State, out: &mut [f64]) {
        for (arm, state, targets) in self.parts(state, &self.all()) {
            let flange = arm.flange(state);
            targets.iter().for_each(|&k| out[3 * k..][..3].copy_from_slice(&arm.target(&flange, k)));
        }
    }
    fn jacobian(&self, state: State, out: &mut [f64]) {
        let n = out.len() / (3 * self.robot.of_target.len()).max(1);
        out.fill(0.0);
        self.target_derivatives(state, &self.all(), &mut |target, parameter, moved| {
            (0..3).for_each(|i| out[(3 * target + i) * n + parameter] += moved[i]);
        });
    }
    fn joint_jacobian(&self, state: State, positions: &mut [f64], out: &mut [f64]) {
        out.fill(0.0);
        for (arm, state, targets) in self.parts(state, &self.all()) {
            arm.joint_derivatives(state, &targets, positions, out);
        }
    }
    fn target_derivatives(&self, state: State, targets: &[usize], write: &mut dyn FnMut(usize, usize, Vector)) {
        for (arm, state, targets) in self.parts(state, targets) {
            arm.target_derivatives(state, &targets, write);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Link, Quantity, Tree, TreeJoint, Value, Values};
    use etalon_base::noise::Noise;
    use std::sync::Arc;

    /// A torso that turns and rises, with a hand of three joints at either side; the last joint of
    /// the left hand mimics the torso.
    fn tree() -> Tree {
        let mut tree = Tree::default();
        let mut links = vec!["base", "column", "torso"];
        let mut joint = |name: &str, kind: &str, ends: [&'static str; 2], xyz_mm: Vector, axis: Vector| {
            let [parent, child] = ends.map(str::to_owned);
            let origin = Pose { translation_mm: xyz_mm, ..Pose::from_rotation_vector(xyz_mm.map(|v| 1e-3 * v)) };
            let (name, kind) = (name.to_owned(), kind.to_owned());
            tree.joints.push(TreeJoint { name, kind, parent, child, origin, axis, limits: None, mimic: None });
        };
        joint("turn", "revolute", ["base", "column"], [10.0, 0.0, 300.0], [0.0, 0.0, 1.0]);
        joint("rise", "prismatic", ["column", "torso"], [0.0, 20.0, 400.0], [0.1, 0.0, 1.0]);
        for (y, [a, b, c, hand]) in
            [(200.0, ["l1", "l2", "l3", "left_hand"]), (-200.0, ["r1", "r2", "r3", "right_hand"])]
        {
            joint(a, "revolute", ["torso", a], [0.0, y, 100.0], [0.0, 1.0, 0.2]);
            joint(b, "revolute", [a, b], [250.0, 0.1 * y, 0.0], [1.0, 0.0, 0.0]);
            joint(c, "revolute", [b, c], [0.0, 0.5 * y, 50.0], [0.0, 1.0, 1.0]);
            joint(&format!("{hand}_mount"), "fixed", [c, hand], [0.0, 0.0, 120.0], [0.0, 0.0, 1.0]);
            links.extend([a, b, c, hand]);
        }
        let link = |name: &str| Link { name: name.to_owned(), mass_kg: 2.0, center_mm: [30.0, 10.0, 50.0] };
        tree.links = links.into_iter().map(link).collect();
        tree
    }

    fn words(all: &[&str]) -> Value {
        Value::Words(all.iter().map(|word| (*word).to_owned()).collect())
    }

    fn text(word: &str) -> Value {
        Value::Text(word.to_owned())
    }

    fn names(all: &[&str]) -> Vec<String> {
        all.iter().map(|name| (*name).to_owned()).collect()
    }

    fn joints(all: &[&str]) -> Value {
        Value::Joints(all.iter().map(|name| crate::JointRef::Name((*name).to_owned())).collect())
    }

    fn values(branches: &[(&str, &[&str])]) -> Values {
        let branch =
            |(link, targets): &(&str, &[&str])| Values::from([("tool_link", text(link)), ("targets", words(targets))]);
        Values::from([
            ("file", Value::Tree(Arc::new(tree()))),
            ("base_link", text("base")),
            ("branch", Value::Tables(branches.iter().map(branch).collect())),
            ("harmonics", joints(&["turn", "r2"])),
            ("backlash", joints(&["rise", "l1", "r3"])),
            ("bending", joints(&["l1", "r2"])),
        ])
    }

    fn two_hands() -> Box<dyn Robot> {
        let both = values(&[("left_hand", &["L1", "L2"]), ("right_hand", &["R1"])]);
        crate::urdf::MODEL.build(&both, &names(&["R1", "L1", "L2"])).unwrap()
    }

    /// Values of all parameters (mm, rad, 1) near nominal.
    fn drawn(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
        let mut near = |p: &crate::Parameter| {
            let size = if p.quantity == Quantity::Length { 30.0 } else { 0.05 };
            p.nominal + noise.uniform(size)
        };
        robot.parameters().iter().map(&mut near).collect()
    }

    /// Joint values (rad, mm), followed by directions of approach.
    fn drawn_joints(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
        let size = |quantity| if quantity == Quantity::Length { 100.0 } else { 1.5 };
        let mut all: Vec<f64> = robot.joints().iter().map(|joint| noise.uniform(size(joint.quantity))).collect();
        all.extend(robot.approached().iter().map(|_| noise.uniform(1.0).signum()));
        all
    }

    fn positions(robot: &dyn Robot, values: &[f64], joints: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; 3 * robot.targets().len()];
        robot.positions(values, joints, &mut out);
        out
    }

    #[test]
    fn jacobians_are_numeric_derivatives() {
        let robot = two_hands();
        let robot = robot.as_ref();
        let mut noise = Noise::new(45, 8);
        let (values, n) = (drawn(robot, &mut noise), robot.parameters().len());
        let joints = drawn_joints(robot, &mut noise);
        let mut exact = vec![0.0; 9 * n];
        robot.jacobian(&values, &joints, &mut exact);
        for (j, p) in robot.parameters().iter().enumerate() {
            let h = if p.quantity == Quantity::Length { 1e-3 } else { 1e-6 };
            let moved = |by: f64| {
                let mut values = values.clone();
                values[j] += by;
                positions(robot, &values, &joints)
            };
            for (i, (plus, minus)) in moved(h).into_iter().zip(moved(-h)).enumerate() {
                let numeric = (plus - minus) / (2.0 * h);
                assert!((numeric - exact[i * n + j]).abs() < 1e-5 * (1.0 + numeric.abs()), "{} {numeric}", p.name);
            }
        }
        // joints without bending, which is evaluated at the joint values themselves
        let mut stiff = values;
        let bends = |p: &crate::Parameter| p.effect == crate::Effect::Bending;
        robot.parameters().iter().zip(&mut stiff).filter(|(p, _)| bends(p)).for_each(|(_, value)| *value = 0.0);
        let m = robot.joints().len();
        let mut exact = vec![0.0; 9 * m];
        robot.joint_jacobian(&stiff, &joints, &mut exact);
        for j in 0..m {
            let moved = |by: f64| {
                let mut joints = joints.clone();
                joints[j] += by;
                positions(robot, &stiff, &joints)
            };
            for (i, (plus, minus)) in moved(1e-5).into_iter().zip(moved(-1e-5)).enumerate() {
                let numeric = (plus - minus) / 2e-5;
                assert!((numeric - exact[i * m + j]).abs() < 1e-4 * (1.0 + numeric.abs()), "{j} {numeric}");
            }
        }
    }

    /// Each hand is where the chain to it alone is, and turns alike.
    #[test]
    fn a_branch_is_the_chain_to_its_link() {
        let both = two_hands();
        let mut noise = Noise::new(45, 9);
        let all = drawn(both.as_ref(), &mut noise);
        let q = drawn_joints(both.as_ref(), &mut noise);
        for (link, targets) in [("left_hand", &["L1", "L2"][..]), ("right_hand", &["R1"])] {
            let mut description = values(&[(link, targets)]);
            let own = |names: &[&'static str]| {
                let of_side = |name: &&&str| !name.starts_with(if link == "left_hand" { 'r' } else { 'l' });
                joints(&names.iter().filter(|name| of_side(name) || **name == "rise").copied().collect::<Vec<_>>())
            };
            description.insert("harmonics", own(&["turn", "r2"]));
            description.insert("backlash", own(&["rise", "l1", "r3"]));
            description.insert("bending", own(&["l1", "r2"]));
            let one = crate::urdf::MODEL.build(&description, &names(targets)).unwrap();
            assert!(one.branches().is_empty() && one.kinematics().is_some() && both.kinematics().is_none());
            let value = |p: &crate::Parameter| all[both.index(&p.name).unwrap()];
            let own: Vec<f64> = one.parameters().iter().map(value).collect();
            let index = |name: &str| both.joints().iter().position(|joint| joint.name == name).unwrap();
            let mut own_q: Vec<f64> = one.joints().iter().map(|joint| q[index(&joint.name)]).collect();
            let m = both.joints().len();
            own_q.extend(one.approached().iter().map(|&j| {
                let joint = index(&one.joints()[j].name);
                q[m + both.approached().iter().position(|&k| k == joint).unwrap()]
            }));
            for (k, target) in targets.iter().enumerate() {
                let there = both.targets().iter().position(|name| name == target).unwrap();
                let (a, b) = (both.position(&all, &q, there), one.position(&own, &own_q, k));
                assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-9), "{a:?} {b:?}");
                let n = one.parameters().len();
                let (mut turns, mut turns_of_all) = (vec![0.0; 3 * n], vec![0.0; 3 * all.len()]);
                one.free_base().unwrap().flange_turns(&own, &own_q, k, &mut turns);
                both.free_base().unwrap().flange_turns(&all, &q, there, &mut turns_of_all);
                for (j, p) in one.parameters().iter().enumerate() {
                    let of_all = both.index(&p.name).unwrap();
                    assert!((0..3).all(|i| (turns[i * n + j] - turns_of_all[i * all.len() + of_all]).abs() < 1e-12));
                }
            }
            for (j, joint) in one.joints().iter().enumerate() {
                let (a, b) = (one.joint_travel(&own, &own_q, j), both.joint_travel(&all, &q, index(&joint.name)));
                assert!((a.unwrap() - b.unwrap()).abs() < 1e-12, "{}: {a:?} {b:?}", joint.name);
            }
        }
    }

    #[test]
    fn common_joints_have_one_set_of_parameters() {
        let robot = two_hands();
        let count = |name: &str| robot.parameters().iter().filter(|p| p.name == name).count();
        for name in ["base_x", "turn_x", "turn_rx", "gain_turn", "rise_ry", "harmonic_turn_sin1", "backlash_rise"] {
            assert_eq!(count(name), 1, "{name}");
        }
        let joints: Vec<&str> = robot.joints().iter().map(|joint| joint.name.as_str()).collect();
        assert_eq!(joints, ["turn", "rise", "l1", "l2", "l3", "r1", "r2", "r3"]);
        assert_eq!((robot.target_branch(0), robot.target_branch(1), robot.target_branch(2)), (1, 0, 0));
        // nominal values that are set later apply
        let mut robot = robot;
        let mut nominal = robot.nominal();
        nominal[robot.index("gain_r1").unwrap()] = 0.5;
        robot.definition_mut().set_nominal(&nominal);
        assert_eq!(robot.nominal_gain(5), 0.5);
    }
}
