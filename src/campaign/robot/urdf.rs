//! URDF files: links and joints of a robot (m, rad). Elements that the program does not need are
//! skipped.

use crate::robot_faults;
use etalon_base::error;
use etalon_base::files::shell_word;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::{Pose, Vector};
use etalon_formats::mesh::is_mesh;
use etalon_formats::xml::{Elements, Node};
use etalon_robots::{At, Fault, Faults, Link, Mimic, Tree, TreeChain, TreeJoint};
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

/// Elements without information about kinematics and masses.
const SKIPPED: [&str; 7] = ["visual", "collision", "transmission", "gazebo", "material", "sensor", "ros2_control"];

/// A URDF file.
#[derive(Debug)]
pub(crate) struct Urdf {
    /// Links and joints.
    pub tree: Arc<Tree>,
    name: String,
    /// Places of the joints.
    places: Vec<Place>,
}

impl Urdf {
    /// Place of a fault of the tree; `None` for a fault at a key of robot.toml.
    pub fn place(&self, at: &At) -> Option<Place> {
        let At::TreeJoint(name) = at else { return (*at == At::Tree).then(|| Place::file(self.name.as_str())) };
        let joint = self.tree.joints.iter().position(|joint| joint.name == *name)?;
        self.places.get(joint).cloned()
    }

    /// Chain with the most moving joints.
    pub fn longest_chain(&self) -> Result<TreeChain> {
        self.tree.longest_chain().map_err(|Faults(faults)| {
            let message = |fault: &Fault| {
                let place = self.place(&fault.at).unwrap_or_else(|| Place::file(self.name.as_str()));
                robot_faults::message(&fault.kind, &|key| vec![key.to_owned()], &self.name).at(place)
            };
            Problems(faults.iter().map(message).collect())
        })
    }
}

/// Reads links and joints of a file. A file with elements of xacro is rejected.
pub(crate) fn read(file: &str, text: &str) -> Result<Urdf> {
    // elements of xacro are found wherever they are
    let has_sign = text.contains("<xacro:");
    let xml = Elements::read(file, text, |name| !has_sign && SKIPPED.contains(&name))?;
    let root = xml.root();
    if let Some(node) = root.and_then(|root| root.all().find(|node| node.has_prefix("xacro"))) {
        let construct = format!("<xacro:{}>", node.name());
        return Err(error!("xacro-construct", construct, command = expansion(file)).at(node.place()).into());
    }
    let root = root.filter(|root| root.name() == "robot");
    let Some(root) = root else {
        return Err(error!("urdf-no-robot").at(xml.place(0)).into());
    };
    let mut problems = Problems::default();
    let (mut tree, mut places) = (Tree::default(), Vec::new());
    for node in root.children() {
        match node.name() {
            "link" => tree.links.extend(problems.keep(link(node))),
            "joint" => {
                if let Some(joint) = problems.keep(joint(node)) {
                    tree.joints.push(joint);
                    places.push(node.place());
                }
            }
            _ => {}
        }
    }
    for (i, joint) in tree.joints.iter().enumerate() {
        let place = || places[i].clone();
        if tree.joints[..i].iter().any(|other| other.name == joint.name) {
            problems.0.push(error!("urdf-joint-twice", joint = joint.name).at(place()));
        }
        for link in [&joint.parent, &joint.child] {
            if tree.links.iter().all(|l| l.name != *link) {
                let message = error!("urdf-joint-link-unknown", joint = joint.name, link).at(place());
                problems.0.push(message.hint_names(link, tree.links.iter().map(|l| l.name.as_str())));
            }
        }
    }
    problems.check().map(|_| Urdf { tree: Arc::new(tree), name: file.to_owned(), places })
}

/// Mesh of a link.
pub(crate) struct LinkMesh {
    pub link: String,
    /// Frame of the mesh in the frame of the link (mm).
    pub place: Pose,
    /// File as stated, such as `package://arm/meshes/base.stl`.
    pub file: String,
    pub scale: Vector,
}

/// Elements without information about meshes.
const SKIPPED_BESIDE_MESHES: [&str; 7] =
    ["joint", "inertial", "transmission", "gazebo", "material", "sensor", "ros2_control"];

/// Meshes of the links that can be read: those to be seen, otherwise those for collisions. What
/// does not fit is left out: pictures do without.
pub(crate) fn meshes(file: &str, text: &str) -> Vec<LinkMesh> {
    let Ok(xml) = Elements::read(file, text, |name| SKIPPED_BESIDE_MESHES.contains(&name)) else { return Vec::new() };
    let links = xml.root().into_iter().flat_map(Node::children).filter(|node| node.name() == "link");
    let mut all = Vec::new();
    for node in links {
        let Some(link) = node.attribute("name") else { continue };
        let shown = |kind: &'static str| {
            let link = link.clone();
            let elements = node.children().filter(move |child| child.name() == kind);
            elements.filter_map(move |element| mesh(element, &link)).collect::<Vec<_>>()
        };
        let visual = shown("visual");
        all.extend(if visual.is_empty() { shown("collision") } else { visual });
    }
    all
}

/// Mesh of a `<visual>` or `<collision>`, if it is one and its format is known.
fn mesh(element: Node, link: &str) -> Option<LinkMesh> {
    let mesh = element.child("geometry")?.child("mesh")?;
    let file = mesh.attribute("filename").filter(|file| is_mesh(file))?.into_owned();
    let (place, scale) = (origin(element).ok()?, vector(mesh, "scale", [1.0; 3]).ok()?);
    Some(LinkMesh { link: link.to_owned(), place, file, scale })
}

/// Command that expands a file of xacro.
fn expansion(file: &str) -> String {
    let stem = file.strip_suffix(".xacro").unwrap_or(file);
    let stem = stem.strip_suffix(".urdf").or(stem.strip_suffix(".xml")).unwrap_or(stem);
    let end = if file.ends_with(".xacro") { "" } else { "-expanded" };
    let [file, urdf] = [file, &format!("{stem}{end}.urdf")].map(|name| shell_word(Path::new(name)));
    format!("xacro {file} > {urdf}")
}

fn link(node: Node) -> Result<Link> {
    let inertial = node.child("inertial");
    let mass = inertial.and_then(|inertial| inertial.child("mass"));
    let mass_kg = mass.map_or(Ok(0.0), |mass| number(mass, "value", 0.0))?;
    let center_mm = inertial.map_or(Ok(Pose::identity()), |inertial| origin(inertial))?.translation_mm;
    Ok(Link { name: text(node, "name")?, mass_kg, center_mm })
}

fn joint(node: Node) -> Result<TreeJoint> {
    let name = text(node, "name")?;
    let of = |child: &str| {
        let missing = || error!("urdf-joint-without-link", joint = name, child).at(node.place());
        text(node.child(child).ok_or_else(missing)?, "link")
    };
    let axis = node.child("axis").map_or(Ok([1.0, 0.0, 0.0]), |axis| vector(axis, "xyz", [1.0, 0.0, 0.0]));
    let kind = text(node, "type")?;
    // limits of a continuous joint apply to its effort only
    let limited = ["revolute", "prismatic"].contains(&kind.as_str());
    let limits = node.child("limit").filter(|_| limited).map(|limit| -> Result<[f64; 2]> {
        let [lower, upper] = [number(limit, "lower", 0.0)?, number(limit, "upper", 0.0)?];
        if lower > upper {
            return Err(error!("urdf-limits-exchanged", joint = name, lower, upper).at(limit.place()).into());
        }
        Ok([lower, upper])
    });
    if node.children().filter(|child| child.name() == "mimic").count() > 1 {
        return Err(error!("urdf-mimics-several", joint = name).at(node.place()).into());
    }
    let mimic = node.child("mimic").map(|mimic| -> Result<Mimic> {
        Ok(Mimic {
            joint: text(mimic, "joint")?,
            multiplier: number(mimic, "multiplier", 1.0)?,
            offset: number(mimic, "offset", 0.0)?,
        })
    });
    Ok(TreeJoint {
        kind,
        parent: of("parent")?,
        child: of("child")?,
        origin: origin(node)?,
        axis: axis?,
        limits: limits.transpose()?,
        mimic: mimic.transpose()?,
        name,
    })
}

/// Pose of an element's `<origin xyz rpy>` (mm).
fn origin(node: Node) -> Result<Pose> {
    let Some(origin) = node.child("origin") else { return Ok(Pose::identity()) };
    let [xyz, rpy] = [vector(origin, "xyz", [0.0; 3])?, vector(origin, "rpy", [0.0; 3])?];
    if rpy.iter().any(|angle| angle.abs() > TAU + 1e-3) {
        return Err(error!("urdf-angles-beyond-turn").at(origin.place()).into());
    }
    Ok(Pose::from_xyz_rpy(xyz.map(|m| 1000.0 * m), rpy))
}

fn text(node: Node, name: &str) -> Result<String> {
    let value = node.attribute(name).filter(|value| !value.trim().is_empty());
    let missing = || error!("urdf-attribute-missing", element = node.name(), attribute = name).at(node.place());
    Ok(value.ok_or_else(missing)?.into_owned())
}

/// Numbers of an attribute, separated by blanks.
fn numbers(node: Node, name: &str) -> Result<Option<Vec<f64>>> {
    let Some(value) = node.attribute(name) else { return Ok(None) };
    let number = |word: &str| {
        let wrong = error!("urdf-not-number", attribute = name, word).at(node.place());
        word.parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(|| Problems::from(wrong))
    };
    value.split_ascii_whitespace().map(number).collect::<Result<_>>().map(Some)
}

fn number(node: Node, name: &str, absent: f64) -> Result<f64> {
    match numbers(node, name)?.as_deref() {
        None => Ok(absent),
        Some([value]) => Ok(*value),
        Some(all) => Err(other_count(node, name, all.len(), 1).into()),
    }
}

fn vector(node: Node, name: &str, absent: Vector) -> Result<Vector> {
    match numbers(node, name)?.as_deref() {
        None => Ok(absent),
        Some([x, y, z]) => Ok([*x, *y, *z]),
        Some(all) => Err(other_count(node, name, all.len(), 3).into()),
    }
}

fn other_count(node: Node, attribute: &str, count: usize, expected_count: usize) -> Message {
    error!("urdf-number-count", attribute, count, expected_count).at(node.place())
}
