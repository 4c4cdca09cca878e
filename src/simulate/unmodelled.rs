//! Errors of a simulated robot that no parameter of its model describes, so that they remain after
//! calibration.

use super::Scene;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Stream of the noise of homing, distinct from the streams of files.
const ZEROS: u64 = 1 << 35;

/// `[unmodelled]` of a truth. Joints are given by name, with values in mm or deg.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Unmodelled {
    /// Lost motion of a joint: difference between its positions after an upward and after a
    /// downward move.
    pub backlash: BTreeMap<String, f64>,
    /// Periodic error of an encoder.
    pub interpolation: BTreeMap<String, Interpolation>,
    /// Standard deviation of the zero of a joint, which is drawn once per campaign.
    pub homing: BTreeMap<String, f64>,
    /// Growth of all distances from the base per hour of the log (µm per metre).
    pub growth_um_per_m_h: f64,
    /// Deflection of a spatial robot at a distance of one metre from its base (µm); at other
    /// distances it grows with the third power (cantilever).
    pub bending_um_at_1_m: f64,
}

/// Periodic error of an encoder between the lines of its scale: a sine of its value.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interpolation {
    /// Amplitude of the error.
    pub amplitude: f64,
    /// Period of the error.
    pub period: f64,
}

impl Unmodelled {
    /// Description of the added errors, for readers of the simulated files.
    pub fn stated(&self) -> Vec<Phrase> {
        let plain = |joints: &BTreeMap<String, f64>| -> Vec<String> {
            joints.iter().map(|(name, v)| format!("{name} {v}")).collect()
        };
        let every = |(joint, i): (&String, &Interpolation)| {
            phrase!("unmodelled-every", joint, amplitude = i.amplitude, period = i.period)
        };
        let periodic: Vec<Phrase> = self.interpolation.iter().map(every).collect();
        let (growth, bending) = (self.growth_um_per_m_h, self.bending_um_at_1_m);
        let all = [
            (!self.backlash.is_empty()).then(|| phrase!("unmodelled-backlash", joints = plain(&self.backlash))),
            (!periodic.is_empty()).then(|| phrase!("unmodelled-interpolation", joints = periodic)),
            (!self.homing.is_empty()).then(|| phrase!("unmodelled-homing", joints = plain(&self.homing))),
            (growth != 0.0).then(|| phrase!("unmodelled-growth", growth)),
            (bending != 0.0).then(|| phrase!("unmodelled-bending", bending)),
        ];
        all.into_iter().flatten().collect()
    }

    /// Rejects unknown joints, and periods of zero.
    pub(super) fn check(&self, scene: &Scene) -> Result<()> {
        let names = || scene.robot.joints().iter().map(|j| j.name.as_str());
        let stated = self.backlash.keys().chain(self.interpolation.keys()).chain(self.homing.keys());
        if let Some(name) = stated.into_iter().find(|name| names().all(|n| n != name.as_str())) {
            let message = error!("unmodelled-joint-unknown", joint = name);
            return Err(message.hint_names(name, names()).into());
        }
        if let Some((name, _)) = self.interpolation.iter().find(|(_, i)| i.period <= 0.0 || i.period.is_nan()) {
            return Err(error!("unmodelled-period", joint = name).into());
        }
        Ok(())
    }

    /// True minus given joint values (mm or rad) at `stated`, when the robot comes from `before`.
    pub(super) fn joint_errors(&self, scene: &Scene, stated: &[f64], before: &[f64]) -> Vec<f64> {
        let mut zeros = Noise::new(scene.truth.seed, ZEROS);
        let joints = scene.robot.joints().iter().zip(stated.iter().zip(before));
        let error = |(joint, (q, from)): (_, (&f64, &f64))| {
            let joint: &etalon_robots::Joint = joint;
            let of = |all: &BTreeMap<String, f64>| all.get(&joint.name).map_or(0.0, |v| joint.quantity.inward(*v));
            let lag = if q == from { 0.0 } else { -0.5 * (q - from).signum() * of(&self.backlash) };
            let wave = self.interpolation.get(&joint.name).map_or(0.0, |i| {
                let phase = TAU * joint.quantity.outward(*q) / i.period;
                joint.quantity.inward(i.amplitude) * phase.sin()
            });
            lag + wave + zeros.gaussian(of(&self.homing))
        };
        joints.map(error).collect()
    }

    /// Position of a point in the world after displacement by heat and weight (mm), `hours` after
    /// the start.
    pub(super) fn moved(&self, scene: &Scene, point: Vector, hours: f64) -> Vector {
        let base = scene.robot.kinematics().and_then(|k| k.base_in_world(&scene.values));
        let base = base.map_or([0.0; 3], |base| base.translation_mm);
        let growth = 1e-6 * self.growth_um_per_m_h * hours;
        let mut p = [0, 1, 2].map(|k| point[k] + growth * (point[k] - base[k]));
        if scene.robot.dimension() == 3 {
            let reach_m = (point[0] - base[0]).hypot(point[1] - base[1]) / 1e3;
            p[2] -= 1e-3 * self.bending_um_at_1_m * reach_m.powi(3);
        }
        p
    }
}
