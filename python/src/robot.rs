//! Robots: from robot.toml, a URDF, or the table of known ones.

use crate::errors::{failed, json, refused};
use etalon::tasks::{Inputs, Prediction, Table, Twists, default_chain, known_names, known_text, urdf_text};
use etalon_base::files;
use etalon_base::message::{Message, Problems};
use etalon_campaign::{RobotFile, parse_robot, parse_robot_with};
use etalon_documents::ParametersDocument;
use etalon_robots::{JointRange, Kinematics, Robot as Model};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A robot file that is read and checked.
#[pyclass(frozen, module = "etalon")]
pub struct Robot {
    file: RobotFile,
    /// Name of the file, for messages.
    name: String,
    text: String,
}

impl Robot {
    fn of(path: &Path, text: String) -> PyResult<Self> {
        let file = parse_robot(path, &text).map_err(refused)?;
        Self::new(file, path, text)
    }

    /// The robot of a text whose URDF file, if there is one, has been read.
    fn with_description(path: &Path, text: String, description: Option<&str>) -> PyResult<Self> {
        let Some(description) = description else { return Self::of(path, text) };
        let file = parse_robot_with(path, &text, description).map_err(refused)?;
        Self::new(file, path, text)
    }

    fn new(file: RobotFile, path: &Path, text: String) -> PyResult<Self> {
        let robot = Self { file, name: path.display().to_string(), text };
        robot.model()?;
        Ok(robot)
    }

    /// The model with the targets whose positions are stated; otherwise with one at the flange's
    /// origin.
    pub fn model(&self) -> PyResult<Box<dyn Model>> {
        self.file.build(&self.file.targets_or("tool")).map_err(refused)
    }

    /// The robot with a target and identified parameters.
    pub fn prediction(&self, document: &ParametersDocument, target: &str) -> Result<Prediction, Problems> {
        Prediction::new(&self.file, document, target)
    }

    /// Motion of the flange by its joints, with parameters.
    pub fn twists(&self, parameters: Option<&str>) -> PyResult<Twists> {
        Twists::new(&self.file, parameters).map_err(refused)
    }

    /// The robot and a table.
    pub fn inputs<'a>(&'a self, table: Table<'a>) -> Inputs<'a> {
        Inputs { robot: &self.file, stated: Table::Text { name: &self.name, text: &self.text }, table }
    }
}

/// The kinematics of a model.
pub fn kinematics(model: &dyn Model) -> PyResult<&dyn Kinematics> {
    etalon::tasks::whole_pose(model).map_err(refused)
}

#[pymethods]
impl Robot {
    /// Reads a robot.toml.
    #[staticmethod]
    fn read(path: PathBuf) -> PyResult<Self> {
        let text = files::read_text(&path).map_err(refused)?;
        Self::of(&path, text)
    }

    /// Reads the text of a robot.toml.
    #[staticmethod]
    fn parse(text: String) -> PyResult<Self> {
        Self::of(Path::new("robot.toml"), text)
    }

    /// Takes a robot of the table.
    #[staticmethod]
    fn named(name: &str) -> PyResult<Self> {
        let text = known_text(name).map_err(refused)?;
        Self::of(Path::new("robot.toml"), text)
    }

    /// Takes a chain of a URDF file, by default the one with the most moving joints; returns the
    /// robot, base and tool link, and messages about the choice as JSON.
    #[staticmethod]
    fn urdf(
        path: PathBuf,
        base_link: Option<String>,
        tool_link: Option<String>,
    ) -> PyResult<(Self, String, String, String)> {
        let (mut chain, message) = default_chain(&path).map_err(refused)?;
        let messages: Vec<Message> = message.filter(|_| tool_link.is_none()).into_iter().collect();
        chain.base_link = base_link.unwrap_or(chain.base_link);
        chain.tool_link = tool_link.unwrap_or(chain.tool_link);
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let robot = Self::of(&path.with_file_name("robot.toml"), urdf_text(&name, &chain))?;
        Ok((robot, chain.base_link, chain.tool_link, json(&messages)?))
    }

    /// The robot of the text of a robot file, and of the text of its URDF file.
    #[staticmethod]
    fn restore(text: String, description: Option<&str>) -> PyResult<Self> {
        Self::with_description(Path::new("robot.toml"), text, description)
    }

    /// Text of the URDF file, if there is one.
    #[getter]
    fn description(&self) -> Option<&str> {
        Some(self.file.description()?.1)
    }

    /// Name of the URDF file as in the robot file, if there is one.
    #[getter]
    fn description_name(&self) -> Option<&str> {
        Some(self.file.description()?.0)
    }

    /// Text of the robot file with another name of the URDF file.
    fn text_beside(&self, name: &str) -> String {
        self.file.text_beside(name)
    }

    /// Lower and upper limit (deg or mm) of each joint; infinite without a limit.
    #[getter]
    fn limits(&self) -> PyResult<Vec<[f64; 2]>> {
        // without the rounding error of the conversion to radians and back
        let rounded = |value: f64| (value * 1e9).round() / 1e9;
        let model = self.model()?;
        let joints = model.joints().iter().enumerate();
        let limits = joints.map(|(i, joint)| match model.joint_range(i) {
            JointRange::Limits(ends) => ends.map(|q| rounded(joint.quantity.outward(q))),
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        });
        Ok(limits.collect())
    }

    /// The robot with the nominal positions (mm) of targets.
    fn with_targets(&self, positions: BTreeMap<String, Vec<f64>>) -> PyResult<Self> {
        let text = self.file.text_with_targets(&positions);
        let text = text.ok_or_else(|| {
            let message = Message::error("a target has another number of coordinates than the points of this robot");
            refused(message.hint("give x, y and z (mm) of each target at the flange; of planar robots x and y").into())
        })?;
        Self::with_description(Path::new(&self.name), text, self.description())
    }

    /// Name of the model: serial, urdf, five_bar ...
    #[getter(model)]
    fn model_name(&self) -> PyResult<String> {
        Ok(self.model()?.model().to_owned())
    }

    /// Columns of the joint values, with their units.
    #[getter]
    pub fn joints(&self) -> PyResult<Vec<String>> {
        Ok(self.model()?.joints().iter().map(|joint| joint.column()).collect())
    }

    /// Name, unit and nominal value of every parameter.
    #[getter]
    fn parameters(&self) -> PyResult<Vec<(String, &'static str, f64)>> {
        let model = self.model()?;
        let row = |p: &etalon_robots::Parameter| (p.name.clone(), p.quantity.unit(), p.quantity.outward(p.nominal));
        Ok(model.parameters().iter().map(row).collect())
    }

    /// Text of the robot.toml.
    #[getter]
    fn toml(&self) -> &str {
        &self.text
    }
}

/// Names of the robots of the table.
#[pyfunction]
pub fn robot_names() -> PyResult<Vec<String>> {
    known_names().map_err(|problems: Problems| failed(problems.into()))
}
