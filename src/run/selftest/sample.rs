//! Files in a folder of this run: the embedded campaign, and descriptions of robots.

use super::embedded::SAMPLE;
use etalon_base::message::Result;
use etalon_base::{error, files};
use etalon_campaign::{Campaign, read_robot};
use etalon_documents::ParametersDocument;
use etalon_robots::{Parameter, Quantity, Robot};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

static COUNT: AtomicUsize = AtomicUsize::new(0);

/// A folder for temporary files, which is removed at the end.
pub(super) struct Scratch(PathBuf);

impl Scratch {
    /// Creates a folder with these files.
    ///
    /// # Errors
    /// Fails if the folder for temporary files cannot be written.
    pub fn with(contents: &[(&str, &str)]) -> Result<Self> {
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("etalon-selftest-{}-{number}", std::process::id()));
        let failed = |path: &Path, e: std::io::Error| {
            error!("selftest-folder-not-written", folder = path.display().to_string(), reason = e.to_string())
        };
        std::fs::create_dir(&folder).map_err(|e| failed(&folder, e))?;
        let scratch = Self(folder);
        for (name, text) in contents {
            let path = scratch.0.join(name);
            let folder = path.parent().unwrap_or(&scratch.0);
            std::fs::create_dir_all(folder).map_err(|e| failed(folder, e))?;
            files::write(&path, text.as_bytes())?;
        }
        Ok(scratch)
    }

    /// The embedded campaign.
    ///
    /// # Errors
    /// Fails like [`Self::with`].
    pub fn campaign() -> Result<Self> {
        Self::with(&SAMPLE)
    }

    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Reads the campaign in the folder.
    ///
    /// # Errors
    /// Fails if the campaign cannot be read.
    pub fn read(&self) -> Result<Campaign> {
        Campaign::read(&self.0)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        drop(std::fs::remove_dir_all(&self.0));
    }
}

/// Robot of a robot.toml, with a URDF file in its folder.
///
/// # Errors
/// Fails if the description is incomplete.
pub(super) fn robot(text: &str, urdf: &str, targets: &[&str]) -> Result<Box<dyn Robot>> {
    let scratch = Scratch::with(&[("robot.toml", text), ("arm.urdf", urdf)])?;
    let targets: Vec<String> = targets.iter().map(|name| (*name).to_owned()).collect();
    read_robot(&scratch.path().join("robot.toml"))?.build(&targets)
}

/// Joint values of a table (deg, mm), as the robot takes them (rad, mm); assembly modes follow.
pub(super) fn inward(robot: &dyn Robot, joints: &[f64]) -> Vec<f64> {
    let quantity = |i: usize| robot.joints().get(i).map_or(Quantity::Ratio, |joint| joint.quantity);
    joints.iter().enumerate().map(|(i, q)| quantity(i).inward(*q)).collect()
}

/// Positions of all targets of a robot, three coordinates each.
pub(super) fn positions(robot: &dyn Robot, parameters: &[f64], joints: &[f64]) -> Vec<f64> {
    (0..robot.targets().len()).flat_map(|target| robot.position(parameters, joints, target)).collect()
}

/// Returns the document with these parameters of a robot, which nobody identified.
///
/// # Errors
/// Fails if the document is not of its own schema.
pub(super) fn document(robot: &dyn Robot, values: &[f64]) -> Result<ParametersDocument> {
    let entry = |(p, value): (&Parameter, &f64)| {
        let [nominal, value] = [p.nominal, *value].map(|v| p.quantity.outward(v));
        json!({
            "name": p.name, "unit": p.quantity.unit(), "nominal": nominal, "before": nominal, "value": value,
            "standard_uncertainty": null, "status": "fixed", "confounded_with": []
        })
    };
    let document = json!({
        "schema": ParametersDocument::SCHEMA, "robot": robot.model(),
        "parameters": robot.parameters().iter().zip(values).map(entry).collect::<Vec<_>>(),
        "residuals": {
            "kind": "targets", "count": 1, "degrees_of_freedom": 1, "rms": 0.0, "max": 0.0,
            "uncertainties_from": "instrument", "uncertainties_enlarged_by": 1.0
        },
        "solver": { "method": "", "iterations": 0, "termination": "step_vanished", "meaning": "" },
        "covariance": [], "messages": [],
        "provenance": { "version": env!("CARGO_PKG_VERSION"), "inputs": {} }
    });
    let read = serde_json::from_value(document);
    read.map_err(|e| error!("selftest-data-unreadable", name = robot.model(), reason = e.to_string()).into())
}
