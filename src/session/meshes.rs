//! Meshes of a robot's links where they are in the folder of the campaign: nothing outside it is
//! read.

use etalon_base::files;
use etalon_base::pose::{Pose, Vector};
use etalon_campaign::{Campaign, PartMesh};
use etalon_formats::mesh::{self, Packed, Triangle};
use etalon_robots::Robot;
use etalon_view::Mesh;
use std::path::{Component, Path, PathBuf};

/// Maximum size of a mesh file (bytes).
const LARGEST: u64 = 32 << 20;
/// Triangles that are drawn of a robot, and at least of a part: meshes with more are drawn
/// coarsely.
const MOST: usize = 60_000;
const LEAST: usize = 2_000;
/// Millimetres of a metre, the unit of URDF.
const METRE_MM: f64 = 1000.0;

/// A mesh of a part, and the file that contains it.
#[derive(Clone, Debug)]
pub(super) struct FoundMesh {
    mesh: PartMesh,
    path: PathBuf,
}

/// Moving parts with meshes whose files are in the folder of the campaign.
#[derive(Clone, Debug, Default)]
pub(super) struct Meshes(Vec<FoundMesh>);

impl Meshes {
    /// Finds the files; none of them is read yet.
    pub fn new(campaign: &Campaign, robot: &dyn Robot, values: &[f64]) -> Self {
        let folder = if campaign.folder.as_os_str().is_empty() { Path::new(".") } else { &campaign.folder };
        let (Some(urdf), Ok(root)) = (campaign.robot.description_path(), folder.canonicalize()) else {
            return Self::default();
        };
        let Some(beside) = urdf.canonicalize().ok().and_then(|urdf| urdf.parent().map(Path::to_owned)) else {
            return Self::default();
        };
        let zero = vec![0.0; robot.joints().len()];
        let frames = robot.part_frames(values, &zero);
        let parts: Vec<&str> = frames.iter().map(|(name, _)| name.as_str()).collect();
        let stated = campaign.robot.meshes(robot, &parts);
        let found = stated.into_iter().filter_map(|mesh| {
            let path = file(&root, &beside, &mesh.file)?;
            Some(FoundMesh { mesh, path })
        });
        Self(found.collect())
    }

    /// Names of the parts with meshes, each once.
    pub fn parts(&self) -> Vec<String> {
        let mut all: Vec<String> = Vec::new();
        for FoundMesh { mesh, .. } in &self.0 {
            if !all.contains(&mesh.part) {
                all.push(mesh.part.clone());
            }
        }
        all
    }

    /// The meshes of each part as one, coarse if they are large. A part whose files cannot be read
    /// is left out.
    pub fn read(&self) -> Vec<Mesh> {
        let parts = self.parts();
        let most = (MOST / parts.len().max(1)).max(LEAST);
        let packed = |part: String| {
            let own = self.0.iter().filter(|found| found.mesh.part == part);
            let triangles: Vec<[Vector; 3]> = own.filter_map(FoundMesh::triangles).flatten().collect();
            let Packed { low, size, points, triangles } = Packed::new(&triangles, most)?;
            Some(Mesh::new(part, low, size, &points, &triangles))
        };
        parts.into_iter().filter_map(packed).collect()
    }
}

impl FoundMesh {
    /// Triangles (mm) in the frame of the part.
    fn triangles(&self) -> Option<Vec<[Vector; 3]>> {
        std::fs::metadata(&self.path).ok().filter(|file| file.is_file() && file.len() <= LARGEST)?;
        let read = mesh::read(&self.path.display().to_string(), &files::read(&self.path).ok()?)?;
        let PartMesh { place, scale, .. } = &self.mesh;
        Some(read.iter().map(|triangle| placed(triangle, place, *scale)).collect())
    }
}

/// A triangle of a mesh in the frame of its part.
fn placed(triangle: &Triangle, place: &Pose, scale: Vector) -> [Vector; 3] {
    triangle.map(|p| place.apply([0, 1, 2].map(|i| f64::from(p[i]) * scale[i] * METRE_MM)))
}

/// File of a mesh that a URDF in the folder `beside` states, inside `root`. The packages of ROS are
/// looked for as folders, with their names and without, from the folder of the URDF upwards;
/// at last, the file itself is looked for beside the URDF and in `root`.
fn file(root: &Path, beside: &Path, stated: &str) -> Option<PathBuf> {
    let (scheme, rest) = stated.split_once("://").unwrap_or(("", stated));
    // what a path of another system or a query would name is no name of a file
    let rest = rest.split(['?', '#']).next().unwrap_or_default().replace('\\', "/");
    let rest = rest.trim_start_matches('/');
    let without_package = rest.split_once('/').map(|(_, rest)| rest).filter(|_| !["", "file"].contains(&scheme));
    let folders = || beside.ancestors().take_while(|folder| folder.starts_with(root));
    let name = Path::new(rest).components().next_back().filter(|part| matches!(part, Component::Normal(_)))?;
    let named = [Some(rest), without_package].into_iter().flatten();
    let inside = named.flat_map(|name| folders().map(move |folder| folder.join(name)));
    let alone = [beside, root].map(|folder| folder.join(name));
    let found = |path: PathBuf| path.canonicalize().ok().filter(|path| path.starts_with(root) && path.is_file());
    inside.chain(alone).find_map(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_found_inside_the_folder_alone() {
        let outer = tempfile::tempdir().unwrap();
        let root = outer.path().canonicalize().unwrap().join("campaign");
        for name in ["arm/urdf", "arm/meshes", "other"] {
            std::fs::create_dir_all(root.join(name)).unwrap();
        }
        for name in ["arm/meshes/base.stl", "loose.stl", "other/link.stl"] {
            std::fs::write(root.join(name), "solid").unwrap();
        }
        std::fs::write(outer.path().join("secret.stl"), "solid").unwrap();
        let beside = root.join("arm/urdf");
        let at = |stated: &str| {
            file(&root, &beside, stated).map(|path| path.strip_prefix(&root).unwrap().display().to_string())
        };
        let base = Some("arm/meshes/base.stl".to_owned());
        for stated in [
            "package://arm/meshes/base.stl",
            "package://arm_description/meshes/base.stl",
            "../meshes/base.stl",
            "meshes/base.stl",
            "model://x/meshes/base.stl",
        ] {
            assert_eq!(at(stated), base, "{stated}");
        }
        // a file that was dropped beside the URDF
        assert_eq!(at("package://arm/meshes/visual/loose.stl"), Some("loose.stl".to_owned()));
        let secret = outer.path().join("secret.stl").display().to_string();
        for stated in [
            "../../../secret.stl",
            "package://../../secret.stl",
            "package://arm/../../../secret.stl",
            &secret,
            &format!("file://{secret}"),
            "package://arm/meshes/none.stl",
            "package://",
            "..",
            "",
        ] {
            assert_eq!(at(stated), None, "{stated}");
        }
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(outer.path().join("secret.stl"), root.join("linked.stl")).unwrap();
            assert_eq!(at("linked.stl"), None, "a link leads outside");
        }
    }
}
