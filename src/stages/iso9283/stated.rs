//! Statements of a command or a campaign about a recorded motion, checked in the same way for both.

use etalon_base::error;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::phrase;
use etalon_standards::iso9283::motion::MotionSettings;
use etalon_standards::iso9283::motion::standstill::Stillness;
use etalon_standards::iso9283::path::PathSettings;
use etalon_standards::iso9283::path::commanded::CommandedPath;
use etalon_standards::iso9283::path::weaving::Weave;
use etalon_standards::iso9283::pose::test::CommandedPose;

/// Statements, named by their keys in `campaign.toml`; options of the command have the same names.
#[derive(Clone, Debug)]
pub struct TestStatement<'a> {
    /// Sampling rate, instead of time stamps.
    pub rate_hz: Option<f64>,
    /// Radius of a standstill: largest distance (mm) of its positions from their mean.
    pub still_mm: f64,
    /// Minimum duration of a standstill (s).
    pub still_s: f64,
    /// Largest distance (mm) of a standstill from its pose, and of an attained path from the
    /// commanded one.
    pub near_mm: f64,
    /// Limit band.
    pub band_mm: Option<f64>,
    /// `true` if a commanded path is given.
    pub path: bool,
    /// Number of command points on it.
    pub path_points: usize,
    /// Commanded velocity on it.
    pub velocity_mm_s: Option<f64>,
    /// Central part of it in which velocities are compared.
    pub central_percent: f64,
    /// Stroke of the weave from side to side, whose centre line is the path.
    pub weave_stroke_mm: Option<f64>,
    /// Frequency of the weave in full swings.
    pub weave_hz: Option<f64>,
    /// Direction of the weave: x, y and z; empty if not given.
    pub weave_across: &'a [f64],
}

impl TestStatement<'_> {
    /// Meaningless statements; `name` converts a key to the notation of its reader.
    pub fn check(&self, name: impl Fn(&str) -> String) -> Result<()> {
        let numbers = [
            ("rate_hz", self.rate_hz),
            ("still_mm", Some(self.still_mm)),
            ("still_s", Some(self.still_s)),
            ("near_mm", Some(self.near_mm)),
            ("band_mm", self.band_mm),
            ("velocity_mm_s", self.velocity_mm_s),
            ("central_percent", Some(self.central_percent)),
            ("weave_stroke_mm", self.weave_stroke_mm),
            ("weave_hz", self.weave_hz),
        ];
        let wrong = numbers.iter().filter(|(_, value)| value.is_some_and(|v| !(v > 0.0 && v.is_finite())));
        let wrong = wrong.map(|(key, _)| error!("option-not-positive", option = name(key)));
        let mut problems = Problems(wrong.collect());
        let mut add = |message: Message| problems.0.push(message);
        if self.central_percent > 100.0 {
            add(error!("central-part-too-large", option = name("central_percent")));
        }
        if !(2..=100_000).contains(&self.path_points) {
            add(error!("path-points-out-of-range", option = name("path_points")));
        }
        let weave = [
            ("weave_stroke_mm", self.weave_stroke_mm.is_some()),
            ("weave_hz", self.weave_hz.is_some()),
            ("weave_across", !self.weave_across.is_empty()),
        ];
        let of_a_path = weave.into_iter().chain([("velocity_mm_s", self.velocity_mm_s.is_some())]);
        for (key, _) in of_a_path.filter(|(_, stated)| *stated && !self.path) {
            add(error!("path-not-stated", option = name(key), path = name("path")));
        }
        if weave.iter().any(|(_, stated)| *stated) {
            for (key, _) in weave.iter().filter(|(_, stated)| !stated) {
                add(error!("weave-incomplete", option = name(key)));
            }
        }
        let across = self.weave_across;
        if !(across.is_empty() || across.len() == 3 && across.iter().all(|v| v.is_finite())) {
            add(error!("weave-direction-count", option = name("weave_across")));
        }
        problems.check().map(|_| ())
    }

    /// Settings from the statements, with the poses and the path that were read.
    pub fn settings(
        &self,
        poses: Option<Vec<CommandedPose>>,
        path: Option<CommandedPath>,
        seed: u64,
    ) -> MotionSettings {
        let weave = match (self.weave_stroke_mm, self.weave_hz, self.weave_across) {
            (Some(stroke_mm), Some(frequency_hz), &[x, y, z]) => {
                Some(Weave { across: [x, y, z], stroke_mm, frequency_hz })
            }
            _ => None,
        };
        let path = path.map(|path| PathSettings {
            path,
            points: self.path_points,
            velocity_mm_s: self.velocity_mm_s,
            central: self.central_percent / 100.0,
            weave,
        });
        MotionSettings {
            still: Stillness { radius_mm: self.still_mm, duration_s: self.still_s },
            near_mm: self.near_mm,
            band_mm: self.band_mm,
            poses,
            path,
            time: match self.rate_hz {
                Some(rate) => phrase!("convention-times-by-rate", rate),
                None => phrase!("convention-times-as-stamped"),
            },
            seed,
        }
    }
}
