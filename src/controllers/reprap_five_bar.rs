//! RepRapFirmware's `M669 K9` for a five-bar, with angles from the x axis of the world.

use super::template::render;
use super::{About, ExportInput, Exporter, value};
use etalon_base::message::{Message, Result};
use etalon_base::phrase;
use etalon_base::pose::Pose;
use etalon_robots::{Robot, Role};
use minijinja::context;
use minijinja::value::Serde;

/// G-code.
pub(super) struct RepRapFiveBar;

/// Name of the angle between the tool and its link.
const GAMMA: &str = "gamma";

impl Exporter for RepRapFiveBar {
    fn about(&self) -> About<'_> {
        About {
            frame: "world of the campaign: the base of the robot is in X, Y and B",
            // The tool is on the line of its link.
            holds: |parameter| parameter.name != GAMMA,
            ..About::controller("reprap-five-bar", "reprap_five_bar.g")
        }
    }

    fn unsuited_robot(&self, robot: &dyn Robot) -> Option<Message> {
        (robot.model() != "five_bar").then(|| super::other_robot(self.name(), robot, phrase!("kind-five-bar")))
    }

    /// A tool short of the joint between the distal links is moved to that joint.
    fn written(&self, _given: &ExportInput, robot: &dyn Robot, values: &[f64]) -> Vec<f64> {
        let mut written = values.to_vec();
        if let [Some(gamma), Some(l22), Some(l23)] = [GAMMA, "l22", "l23"].map(|name| robot.index(name)) {
            written[l23] = (values[l23] * values[gamma].cos()).max(values[l22]);
            written[gamma] = 0.0;
        }
        written
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        // angles are relative to the world, so the base must be identified
        let base = robot.parameters().iter().filter(|p| p.role == Role::Base);
        base.map(|p| given.entry(&p.name)).collect::<Result<Vec<_>>>()?;
        let of = |name: &str| value(robot, &values, name);
        let base = robot.kinematics().and_then(|arm| arm.base_in_world(&values)).unwrap_or(Pose::identity());
        let ([x, y, _], along) = (base.translation_mm, base.axis(0));
        let half = 0.5 * of("d")?;
        let motors = |i: usize| Serde([-half, half].map(|side| [x, y][i] + side * along[i]));
        let phi_deg = along[1].atan2(along[0]).to_degrees();
        let (gamma, l22, l23) = (of(GAMMA)?, of("l22")?, of("l23")?);
        let beyond = l23 * gamma.cos() - l22;
        let values = context! {
            header => given.header("mm, deg")?,
            gamma,
            beside => l23 * gamma.sin(),
            before => -beyond,
            beyond => beyond.max(0.0),
            x => motors(0),
            y => motors(1),
            proximal => Serde([of("l11")?, of("l21")?]),
            distal => Serde([of("l12")?, l22]),
            home => Serde([of("delta1")?, of("delta2")?].map(|delta| delta.to_degrees() + phi_deg)),
        };
        render(include_str!("templates/reprap_five_bar.g.j2"), values).map(String::into_bytes)
    }
}
