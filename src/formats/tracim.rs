//! Test data and answers of TraCIM, the service with which PTB validates fits of elements.
//!
//! Structure and names: PTB, "Validation of Gaussian Algorithm Implementation", revision 1.3
//! (2015), sections 4.2 and 4.3, and the public sample data of both tests. Lengths are in mm,
//! angles in degrees.

use crate::xml::{Elements, Node};
use etalon_base::error;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose::Vector;
use etalon_tables::Decimal;
use etalon_tables::lexer;
use std::fmt::Write;

/// Test of TraCIM.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Package {
    /// Least squares.
    Gauss,
    /// Minimum zones.
    Chebyshev,
}

impl Package {
    const ALL: [Self; 2] = [Self::Gauss, Self::Chebyshev];

    /// Name in namespaces and elements.
    fn name(self) -> &'static str {
        match self {
            Self::Gauss => "gauss",
            Self::Chebyshev => "chebyshev",
        }
    }

    /// Maximum permissible errors (mm, rad) that an answer gives: the smallest ones that PTB
    /// accepts.
    fn permissible_errors(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Gauss => &[
                ("mpe_size", "0.0001"),
                ("mpe_angle", "0.0000001"),
                ("mpe_position", "0.0001"),
                ("mpe_orientation", "0.0000001"),
            ],
            Self::Chebyshev => &[
                ("mpe_size", "0.0001"),
                ("mpe_position", "0.0001"),
                ("mpe_orientation", "0.0000001"),
                ("mpe_formDeviation", "0.00001"),
            ],
        }
    }
}

/// Test data of one process.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Kind of the test.
    pub package: Package,
    /// Key of the process, which the answer repeats.
    pub process_key: String,
    /// Data sets.
    pub sets: Vec<DataSet>,
}

/// Points of one element.
#[derive(Clone, Debug, PartialEq)]
pub struct DataSet {
    /// Identification, e.g. `b01`.
    pub id: String,
    /// Kind of the element, e.g. `LINE_3D`.
    pub object: String,
    /// Points (mm).
    pub points_mm: Vec<Vector>,
}

/// Quantities of a fitted element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Quantities {
    /// Centre, or a point of line, plane or axis.
    pub position_mm: Vector,
    /// Unit vector; of a cone in the direction of decreasing radius.
    pub orientation: Option<Vector>,
    /// Radius; of a cone perpendicular to its axis at the position.
    pub radius_mm: Option<f64>,
    /// Full apex angle of a cone (deg).
    pub angle_deg: Option<f64>,
    /// Width of the minimum zone.
    pub form_mm: Option<f64>,
}

impl Request {
    /// Reads test data as the server sends them.
    ///
    /// # Errors
    /// Fails if the text is not XML, or if package, process key or points are missing.
    pub fn read(file: &str, text: &str) -> Result<Self> {
        let tree = Elements::read(file, text, |_| false)?;
        let root = tree.root().ok_or_else(|| error!("tracim-test-missing"))?;
        let test = root.children().find(|node| matches!(node.name(), "test" | "tests"));
        let test = test.ok_or_else(|| error!("tracim-test-missing").at(root.place()))?;
        let stated = test.attribute("type").unwrap_or_default();
        let is_of = |package: &&Package| stated.rsplit(':').next() == Some(&format!("{}TestPackage", package.name()));
        let package = Package::ALL.iter().find(is_of).copied();
        let unknown = || error!("tracim-package-unknown", package = stated.to_string()).at(test.place());
        let package = package.ok_or_else(unknown)?;
        let key = root.child("process").and_then(|process| process.child("key")).map_or("", Node::text);
        if key.is_empty() {
            return Err(error!("tracim-key-missing").at(root.place()).into());
        }
        let elements = test.all().filter(|node| node.name() == "testElement");
        let mut problems = Problems::default();
        let read = elements.filter_map(|element| set(element).map_err(|message| problems.0.push(message)).ok());
        let sets: Vec<DataSet> = read.collect();
        problems.check()?;
        if sets.is_empty() {
            return Err(error!("tracim-test-missing").at(test.place()).into());
        }
        Ok(Self { package, process_key: key.to_owned(), sets })
    }

    /// Answer to this test. `software` is the version of the program.
    pub fn answer(&self, customer: &str, software: &str, results: &[Quantities]) -> String {
        let name = self.package.name();
        let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        let _ = writeln!(
            text,
            "<{name}ResultPackage xmlns:tracim=\"http://tracim.ptb.de/tracim\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"http://tracim.ptb.de/{name}/test\">"
        );
        let head = [
            ("processKey", self.process_key.as_str()),
            ("customer", customer),
            ("softwareVendor", "The etalon authors"),
            ("softwareName", "etalon"),
            ("softwareVersion", software),
            ("softwareRev", "0"),
        ];
        head.iter().for_each(|(tag, value)| element(&mut text, 2, tag, value));
        text += "  <resultPackage>\n";
        for (set, found) in self.sets.iter().zip(results) {
            text += "    <results>\n";
            element(&mut text, 6, "basicID", &set.id);
            element(&mut text, 6, "computationObject", &set.object);
            text += "      <refParameter>\n";
            found.named().for_each(|(tag, value)| element(&mut text, 8, &tag, &value.to_string()));
            text += "      </refParameter>\n    </results>\n";
        }
        text += "  </resultPackage>\n";
        self.package.permissible_errors().iter().for_each(|(tag, value)| element(&mut text, 2, tag, value));
        let _ = writeln!(text, "</{name}ResultPackage>");
        text
    }
}

impl Quantities {
    /// Names and values, in the order of the schema.
    fn named(&self) -> impl Iterator<Item = (String, f64)> {
        let vector = |name: &'static str, v: Vector| {
            ["X", "Y", "Z"].into_iter().zip(v).map(move |(axis, value)| (format!("{name}{axis}"), value))
        };
        let orientation = self.orientation.into_iter().flat_map(move |v| vector("orientation", v));
        let scalars = [("radius", self.radius_mm), ("angle", self.angle_deg), ("formDeviation", self.form_mm)];
        let scalars = scalars.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?)));
        vector("position", self.position_mm).chain(orientation).chain(scalars)
    }
}

/// Reads one data set.
fn set(element: Node) -> std::result::Result<DataSet, Message> {
    let text = |name: &str| element.child(name).map_or("", Node::text).to_owned();
    let (id, object) = (text("basicID"), text("computationObject"));
    let cloud = element.child("pointCloud");
    let vectors = cloud.iter().flat_map(|cloud| cloud.children()).filter(|node| node.name() == "vectors");
    let points_mm = vectors.map(|node| point(node, &id)).collect::<std::result::Result<_, _>>()?;
    Ok(DataSet { id, object, points_mm })
}

fn point(node: Node, id: &str) -> std::result::Result<Vector, Message> {
    let mut point = [0.0; 3];
    for (coordinate, name) in point.iter_mut().zip(["x", "y", "z"]) {
        let missing = || error!("tracim-coordinate-missing", id, coordinate = name).at(node.place());
        let here = node.child(name).ok_or_else(missing)?;
        *coordinate = lexer::number(here.text(), Decimal::Point).map_err(|message| message.at(here.place()))?;
    }
    Ok(point)
}

/// Adds an element with a text.
fn element(text: &mut String, indent: usize, tag: &str, value: &str) {
    let value = quick_xml::escape::escape(value);
    let _ = writeln!(text, "{:indent$}<{tag}>{value}</{tag}>", "");
}
