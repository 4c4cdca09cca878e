//! Effects that robot.toml does not describe, and that the held-out poses prove.

use crate::stages::calibrate::cross_validation::{CrossValidated, LeftOut, gain, would_prove};
use etalon_campaign::RobotFile;
use etalon_documents::EffectProof;
use etalon_identify::{Effects, Identification, Settings, chi_square_exceeds};
use etalon_robots::{Effect, Quantity, Robot};

/// Number of joints whose bending is tried: the first that carry a moment.
const BENDING: usize = 2;
/// Minimum load of a joint that carries a moment, relative to its largest possible load.
const LOADED: f64 = 0.1;

/// Solution whose model may be incomplete.
#[derive(Clone, Copy)]
pub(crate) struct Undescribed<'a> {
    pub robot_file: &'a RobotFile,
    pub robot: &'a dyn Robot,
    pub left_out: &'a LeftOut,
    pub found: &'a Identification,
}

/// Effect of these joints, by number from 1, under a key of robot.toml.
struct Addition {
    key: &'static str,
    effect: Effect,
    joints: Vec<usize>,
}

/// An effect with what left-out poses show of it: each set of joints is fitted once.
struct Tried {
    addition: Addition,
    with: CrossValidated,
}

impl Undescribed<'_> {
    /// Bending and harmonics of the joints of an arm, if robot.toml lacks them, chi-square rejects
    /// the model and the positions prove them.
    pub fn effects(self) -> Vec<EffectProof> {
        let LeftOut { settings, .. } = self.left_out;
        let residuals = &self.found.residuals;
        let is_explained = residuals.chi_square.is_some_and(|c| !chi_square_exceeds(c, residuals.degrees_of_freedom));
        if is_explained || !settings.conditions.is_empty() || !settings.known.is_empty() {
            return Vec::new();
        }
        let additions = [self.bending(), self.harmonics()];
        additions.into_iter().flatten().filter_map(|tried| self.proof(&tried)).collect()
    }

    fn bending(self) -> Option<Tried> {
        let addition = |joints| Addition { key: "bending", effect: Effect::Bending, joints };
        let carries = |joint: &usize| {
            let alone = self.robot_with(&addition(vec![*joint]));
            let loads = alone.as_ref().and_then(|bending| bending.loads());
            let calibration = &self.left_out.sets.calibration;
            loads.is_some_and(|loads| calibration.iter().any(|o| loads(&o.joints).iter().any(|l| l.abs() > LOADED)))
        };
        let joints: Vec<usize> = self.revolute().filter(carries).take(BENDING).collect();
        if self.robot.loads().is_some() || joints.is_empty() {
            return None;
        }
        self.tried(addition(joints))
    }

    /// Harmonics of the joints whose own harmonics predict left-out poses better: alone, and in
    /// addition to the harmonics of the other joints.
    fn harmonics(self) -> Option<Tried> {
        let tried = |joints| self.tried(Addition { key: "harmonics", effect: Effect::Harmonics, joints });
        let gains = |without: &CrossValidated, with: &CrossValidated| {
            let [gain, u] = gain(&without.left_out, &with.left_out);
            gain > u
        };
        let is_better = |alone: &Tried| gains(&self.left_out.identified, &alone.with);
        let mut alone: Vec<Tried> = self.revolute().filter_map(|joint| tried(vec![joint])).filter(is_better).collect();
        let joints: Vec<usize> = alone.iter().flat_map(|alone| alone.addition.joints.clone()).collect();
        let mut best = if alone.len() > 1 { tried(joints.clone())? } else { return alone.pop() };
        for joint in joints {
            let others: Vec<usize> = best.addition.joints.iter().copied().filter(|j| *j != joint).collect();
            let without = match others[..] {
                [] => break,
                [one] => alone.swap_remove(alone.iter().position(|alone| alone.addition.joints == [one])?),
                _ => tried(others)?,
            };
            if !gains(&without.with, &best.with) {
                best = without;
            }
        }
        Some(best)
    }

    /// Numbers of the revolute joints, from 1.
    fn revolute(self) -> impl Iterator<Item = usize> {
        let joints = self.robot.joints();
        (1..=joints.len()).filter(move |&j| joints[j - 1].quantity == Quantity::Angle)
    }

    fn robot_with(self, addition: &Addition) -> Option<Box<dyn Robot>> {
        self.robot_file.build_with(addition.key, &addition.joints, self.robot.targets())
    }

    /// Returns the values of the solution, and nominal values for parameters that the solution does
    /// not contain.
    fn start(self, robot: &dyn Robot) -> Vec<f64> {
        let value = |name: &str| Some(self.found.values[self.robot.index(name)?]);
        robot.parameters().iter().map(|p| value(&p.name).unwrap_or(p.nominal)).collect()
    }

    /// Returns the settings with `effect` added to the identified effects.
    fn settings(self, effect: Effect) -> Settings {
        let mut settings = self.left_out.settings.clone();
        if let Effects::These(chosen) = &mut settings.effects {
            chosen.push(effect);
        }
        settings
    }

    fn tried(self, addition: Addition) -> Option<Tried> {
        let robot = self.robot_with(&addition)?;
        let start = self.start(robot.as_ref());
        let with = self.left_out.trial(robot.as_ref(), &start).cross_validate(&self.settings(addition.effect))?;
        Some(Tried { addition, with })
    }

    fn proof(self, Tried { addition, with }: &Tried) -> Option<EffectProof> {
        let Addition { key, effect, joints } = addition;
        let (left_out, more) = (self.left_out, self.settings(*effect));
        let robot = self.robot_with(addition)?;
        let start = self.start(robot.as_ref());
        let names = joints.iter().map(|j| self.robot.joints()[j - 1].name.clone()).collect();
        let alone = left_out.trial(self.robot, &self.found.values);
        let both =
            || Some([alone.identify(&left_out.settings)?, left_out.trial(robot.as_ref(), &start).identify(&more)?]);
        let proof = would_prove([&left_out.identified, with], both, *effect, names)?;
        let numbers: Vec<String> = joints.iter().map(usize::to_string).collect();
        Some(EffectProof { robot_key: Some(format!("{key} = [{}]", numbers.join(", "))), ..proof })
    }
}

/// Leaves of the effects that are not identified the one that predicts held-out poses best: others
/// may gain only because it is missing.
pub(crate) fn best_alone(effects: &mut Vec<EffectProof>) {
    let open = effects.iter().filter(|proof| !proof.is_identified).map(|proof| proof.with_mm);
    let least_mm = open.fold(f64::INFINITY, f64::min);
    effects.retain(|proof| proof.is_identified || proof.with_mm <= least_mm);
}
