//! QIF 2.0, 2.1 and 3.0 (ISO 23952): measured features with their points, units and probe.
//!
//! Statements about a feature are taken unchanged: measured values, nominal values, and the points
//! with their probe compensation. Broken references, lists with a wrong count and unusable points
//! are reported with their place; such a feature has no points.

mod geometry;
mod points;
mod rows;
mod units;

pub use geometry::FeatureGeometry;
use rows::rows;

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, head, not_this_format};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use crate::xml::{Elements, Node};
use etalon_base::message::{Message, Place, Problems, Result, Severity};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase, warning};
use etalon_fit::Element;
use points::PointSets;
use std::collections::BTreeMap;
use units::Units;

/// Measured features of QIF.
pub(super) struct Qif;

impl ExportFormat for Qif {
    fn about(&self) -> About {
        About { name: "qif", title: "QIF", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(is_xml(text) && head(text).contains("QIFDocument"), 1.0, phrase!("is-qif"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text.file, text.whole, unit)
    }

    fn write(&self, _rows: &[ExportRow], _how: &Writing) -> std::result::Result<String, WriteError> {
        Err(WriteError::Unsupported(error!("format-not-simulated", kind = "qif")))
    }
}

/// Maximum number of reported messages of one file; further ones are counted.
const MOST_MESSAGES: usize = 50;

/// Parts of a document that hold no measured feature and may be large.
const NOT_READ: [&str; 9] = [
    "Product",
    "Characteristics",
    "MeasuredCharacteristics",
    "Statistics",
    "MeasurementResources",
    "Plans",
    "Rules",
    "Attributes",
    "Signature",
];

/// Measured features of a QIF file.
#[derive(Clone, Debug)]
pub struct MeasuredFeatures {
    /// `versionQIF`.
    pub version: String,
    /// In the order of the file.
    pub features: Vec<MeasuredFeature>,
    /// Number of points in the file, including points that no feature uses.
    pub points: usize,
    /// Warnings.
    pub messages: Vec<Message>,
}

/// A measured feature.
#[derive(Clone, Debug)]
pub struct MeasuredFeature {
    /// QIF id.
    pub id: String,
    /// Kind in the notation of QIF: `Plane`, `Circle`, `Point`...
    pub kind: String,
    /// Name of the feature, if given.
    pub name: Option<String>,
    /// Its points, in millimetres.
    pub points_mm: Vec<Vector>,
    /// Kind of the points.
    pub touch: Touch,
    /// Measured values given in the file.
    pub stated: FeatureGeometry,
    /// Nominal values.
    pub nominal: FeatureGeometry,
    /// `true` for a bore (`INTERNAL`), `false` for a shaft (`EXTERNAL`), if given.
    pub internal: Option<bool>,
    /// Place in the file.
    pub place: Place,
}

/// Kind of a measured point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Touch {
    /// A point of the surface.
    #[default]
    Contact,
    /// The centre of a probe.
    Centre {
        /// Radius of the probe, if given.
        radius_mm: Option<f64>,
    },
}

impl MeasuredFeature {
    /// Element to fit; `None` for points and for features that are not a single element.
    pub fn element(&self) -> Option<Element> {
        Some(match self.kind.as_str() {
            "Line" => Element::Line,
            "Plane" => Element::Plane,
            "Circle" | "CircularArc" => Element::Circle3d,
            "Sphere" | "SphericalSegment" => Element::Sphere,
            "Cylinder" | "CylindricalSegment" => Element::Cylinder,
            "Cone" | "ConicalSegment" => Element::Cone,
            "Torus" | "ToroidalSegment" => Element::Torus,
            _ => return None,
        })
    }

    /// Name, or else id.
    pub fn label(&self) -> &str {
        self.name.as_deref().unwrap_or(&self.id)
    }
}

/// `true` if a text is XML, like QIF; no other format that is read begins like XML.
pub fn is_xml(text: &str) -> bool {
    text.trim_start().starts_with('<')
}

/// Reads a QIF file; `mm_in_unit` is the unit of length of a file without units.
///
/// # Errors
/// Fails if the file is not a well-formed QIF 2.x or 3.x document, has no unit, or holds an invalid
/// number.
pub fn read(file: &str, text: &str, mm_in_unit: Option<f64>) -> Result<MeasuredFeatures> {
    let tree = Elements::read(file, text, |name| NOT_READ.contains(&name))?;
    let Some(root) = tree.root().filter(|r| r.name() == "QIFDocument") else {
        let signature = phrase!("root-element", name = "QIFDocument");
        return Err(not_this_format("qif", &signature).at(tree.place(0)).into());
    };
    let version = root.attribute("versionQIF").unwrap_or_default().into_owned();
    if !(version.starts_with("2.") || version.starts_with("3.")) {
        let message = error!("version-unsupported", format = "QIF", version, versions = ["2.0", "2.1", "3.0"]);
        return Err(message.at(root.place()).into());
    }
    let mut units = Units::read(root)?;
    if let (Some(own), Some(stated)) = (units.mm_in_primary(), mm_in_unit)
        && (own / stated - 1.0).abs() > 1e-9
    {
        let [of_file, stated] = [own, stated].map(units::name);
        return Err(error!("unit-differs", of_file, how = "FileUnits", stated).at(root.place()).into());
    }
    units.or_length(mm_in_unit);
    let mut messages = Vec::new();
    let nodes = nodes_with_id(root, &mut messages);
    let sets = PointSets::read(&nodes, &units);
    let mut document = QifDocument { nodes, units, sets, messages };
    let mut inline = 0;
    let mut features = Vec::new();
    for node in root.all() {
        let name = node.name();
        let kind = name.strip_suffix("FeatureMeasurement").or_else(|| name.strip_suffix("FeatureActual"));
        if let Some(kind) = kind.filter(|k| !k.is_empty()) {
            features.push(document.feature(kind, node));
        }
        inline += usize::from(name == "MeasurePoint");
    }
    let QifDocument { sets, mut messages, .. } = document;
    for (id, node) in sets.unused() {
        messages.push(warning!("point-set-unused", id).at(node.place()));
    }
    let points = sets.count() + inline;
    let (mut errors, warnings): (Vec<_>, Vec<_>) = messages.into_iter().partition(|m| m.severity == Severity::Error);
    if !errors.is_empty() {
        cut(&mut errors, |count| error!("further-messages", count));
        return Err(Problems(errors));
    }
    let mut messages = warnings;
    cut(&mut messages, |count| warning!("further-messages", count));
    Ok(MeasuredFeatures { version, features, points, messages })
}

/// Keeps the first messages and shows how many further ones there were.
fn cut(messages: &mut Vec<Message>, further: impl Fn(usize) -> Message) {
    let count = messages.len();
    if count > MOST_MESSAGES {
        messages.truncate(MOST_MESSAGES);
        messages.push(further(count - MOST_MESSAGES));
    }
}

/// All elements with an id; ids are unique in a file.
fn nodes_with_id<'t, 'a>(root: Node<'t, 'a>, messages: &mut Vec<Message>) -> BTreeMap<&'t str, Node<'t, 'a>> {
    let mut nodes = BTreeMap::new();
    for node in root.all() {
        let Some(id) = node.id() else { continue };
        match nodes.get(id) {
            // many copies of one id state it once
            Some(_) if messages.len() > MOST_MESSAGES => {}
            Some(first) => {
                let line = Node::place(*first).line.unwrap_or(0);
                messages.push(warning!("id-repeated", id, line).at(node.place()));
            }
            None => {
                nodes.insert(id, node);
            }
        }
    }
    nodes
}

/// A document during the reading of its features.
struct QifDocument<'t, 'a> {
    /// Elements with an id.
    nodes: BTreeMap<&'t str, Node<'t, 'a>>,
    units: Units,
    sets: PointSets<'t, 'a>,
    messages: Vec<Message>,
}

impl<'t, 'a> QifDocument<'t, 'a> {
    /// Returns the measured feature of this kind at `node`.
    fn feature(&mut self, kind: &str, node: Node<'t, 'a>) -> MeasuredFeature {
        let Self { nodes, units, sets, messages } = self;
        let mut refer = |from: Option<Node<'t, 'a>>, name: &str, kind: &str| -> Option<Node<'t, 'a>> {
            let reference = from?.child(name).filter(|r| r.attribute("xId").is_none())?;
            let found = nodes.get(reference.text()).copied().filter(|n| n.name().ends_with(kind));
            if found.is_none() {
                messages.push(warning!("reference-broken", name, id = reference.text(), kind).at(reference.place()));
            }
            found
        };
        let item = refer(Some(node), "FeatureItemId", "FeatureItem");
        let nominal = refer(item, "FeatureNominalId", "FeatureNominal");
        let definition = refer(nominal.or(item), "FeatureDefinitionId", "FeatureDefinition");
        let name = item.and_then(|i| i.child("FeatureName")).map(|n| n.text().to_owned()).filter(|n| !n.is_empty());
        let internal = definition.and_then(|d| d.child("InternalExternal")).and_then(|n| match n.text() {
            "INTERNAL" => Some(true),
            "EXTERNAL" => Some(false),
            _ => None,
        });
        let read = |nodes: &[Option<Node>], messages: &mut Vec<Message>| {
            FeatureGeometry::read(kind, nodes.iter().flatten().copied(), units).unwrap_or_else(|message| {
                messages.push(message);
                FeatureGeometry::default()
            })
        };
        let stated = read(&[Some(node)], messages);
        let nominal = read(&[nominal, definition], messages);
        let listed = node.child("PointList").map(|list| sets.list(list, units)).transpose();
        let (points_mm, touch) = listed.map(Option::unwrap_or_default).unwrap_or_else(|message| {
            let feature = name.as_deref().or(node.id()).unwrap_or("");
            messages.push(message.within(phrase!("feature-without-points", feature)));
            Default::default()
        });
        MeasuredFeature {
            id: node.id().unwrap_or_default().to_owned(),
            kind: kind.to_owned(),
            name,
            points_mm,
            touch,
            stated,
            nominal,
            internal,
            place: node.place(),
        }
    }
}
