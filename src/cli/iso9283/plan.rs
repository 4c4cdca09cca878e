//! Command `etalon iso9283 plan`.

use super::super::{Output, Verdict, pose_table};
use etalon_base::files;
use etalon_base::message::Problems;
use etalon_base::{error, phrase, warning};
use etalon_campaign::read_robot;
use etalon_documents::{Iso9283Places, Iso9283PlanDocument, Iso9283Unreached, to_json};
use etalon_formats::table::{ANGLES, XYZ};
use etalon_standards::iso9283::plan::{PlanError, TestRequest, UnknownReachability, plan, reachability};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Options of the layout of a test.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Plan of a test")]
pub(super) struct PlanOptions {
    /// Workspace: smallest x,y,z, then largest x,y,z; for planar robots x,y, then x,y.
    #[arg(long, value_name = "MM,...", value_delimiter = ',', allow_hyphen_values = true)]
    workspace_mm: Vec<f64>,
    /// Test plane: C1-C2-C7-C8 (default), C2-C3-C8-C5, C3-C4-C5-C6 or C4-C1-C6-C7.
    #[arg(long, value_name = "CORNERS", requires = "workspace_mm")]
    test_plane: Option<String>,
    /// Commanded angles a,b,c; for planar robots c.
    #[arg(long, value_name = "DEG,...", value_delimiter = ',', allow_hyphen_values = true, requires = "workspace_mm")]
    orientation_deg: Vec<f64>,
    /// Change of the angles along the path with reorientation, there and back.
    #[arg(long, value_name = "DEG,...", value_delimiter = ',', allow_hyphen_values = true, requires = "workspace_mm")]
    reorientation_deg: Vec<f64>,
    /// Robot file, to check that the robot reaches all places within its limits; if one cannot be
    /// reached, the exit code is 1. Joint values are reported.
    #[arg(long, value_name = "FILE", requires = "workspace_mm")]
    robot: Option<PathBuf>,
    /// Folder for the lists of places as CSV and as targets of a controller (.json, .h), and for
    /// the programme.
    #[arg(long, value_name = "FOLDER", requires = "workspace_mm")]
    write: Option<PathBuf>,
}

impl PlanOptions {
    pub fn run(&self, json: bool, out: &Output) -> anyhow::Result<Verdict> {
        let workspace_mm = match self.workspace_mm[..] {
            [x0, y0, x1, y1] => [[x0, y0, 0.0], [x1, y1, 0.0]],
            [x0, y0, z0, x1, y1, z1] => [[x0, y0, z0], [x1, y1, z1]],
            _ => {
                return Err(Problems::from(error!("workspace-numbers", count = self.workspace_mm.len())).into());
            }
        };
        let plan = plan(&TestRequest {
            workspace_mm,
            plane: self.test_plane.clone(),
            orientation_deg: self.orientation_deg.clone(),
            reorientation_deg: self.reorientation_deg.clone(),
        })
        .map_err(without_plan)?;
        let document = match &self.robot {
            None => Iso9283PlanDocument::new(&plan, None),
            Some(file) => {
                let robot = read_robot(file)?;
                let robot = robot.build(&robot.targets_or("target"))?;
                let reach = reachability(&plan, robot.as_ref())
                    .map_err(|UnknownReachability| unknown_reachability(robot.model()))?;
                Iso9283PlanDocument::new(&plan, Some((robot.as_ref(), &reach)))
            }
        };
        let unreached = |u: &Iso9283Unreached| {
            warning!("test-point-unreached", list = u.places, point = u.point, reason = u.reason)
        };
        out.remark(&document.unreached.iter().map(unreached).collect::<Vec<_>>());
        let verdict = if document.unreached.is_empty() { Verdict::Met } else { Verdict::LimitNotMet };
        if let Some(folder) = &self.write {
            let written = write(folder, &document)?;
            if !json {
                out.print_written(written, false)?;
                return Ok(verdict);
            }
        }
        out.print(if json { to_json(&document)? } else { as_text(&document).into_bytes() })?;
        Ok(verdict)
    }
}

fn without_plan(error: PlanError) -> Problems {
    match error {
        PlanError::ReorientationAlone => error!("reorientation-alone").into(),
        PlanError::Other(problems) => problems,
    }
}

fn unknown_reachability(model: &str) -> Problems {
    error!("reach-unknown", model).into()
}

fn write(folder: &Path, document: &Iso9283PlanDocument) -> anyhow::Result<Vec<String>> {
    let mut all = vec![("programme.csv".to_owned(), programme(document).into_bytes())];
    for places in &document.places {
        all.push((format!("{}.csv", places.name), csv(places).into_bytes()));
        if places.joints.iter().any(Option::is_some) {
            all.push((format!("{}-joints.csv", places.name), joints(places).into_bytes()));
        }
        for ending in ["json", "h"] {
            let name = format!("{}.{ending}", places.name);
            all.push((name.clone(), etalon_controllers::places(places, &name)?));
        }
    }
    Ok(files::write_new(folder, &all)?)
}

/// List of places as a table: commanded poses, or a commanded path.
fn csv(places: &Iso9283Places) -> String {
    let there = |name: &&str| places.points.first().is_some_and(|p| p.contains_key(*name));
    let columns: Vec<&str> = XYZ.into_iter().chain(ANGLES).filter(there).collect();
    pose_table(&columns, (1..).zip(&places.points))
}

/// Joint values of a list of places, without places out of reach.
fn joints(places: &Iso9283Places) -> String {
    let rows = (1..).zip(&places.joints).filter_map(|(pose, joints)| Some((pose, joints.as_ref()?)));
    let columns = places.joints.iter().flatten().next().into_iter().flat_map(|joints| joints.keys());
    pose_table(&columns.map(String::as_str).collect::<Vec<_>>(), rows)
}

fn programme(document: &Iso9283PlanDocument) -> String {
    let list = |all: &[u32]| all.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
    let mut text = "characteristic,clause,visits,velocities_percent,cycles,read_in_the_standard\n".to_owned();
    for item in &document.programme {
        let quoted = [&item.characteristic, &item.clause, &item.visits].map(|cell| format!("\"{cell}\""));
        let (velocities, read) = (list(&item.velocities_percent), if item.read { "yes" } else { "no" });
        let _ = writeln!(text, "{},{velocities},{},{read}", quoted.join(","), item.cycles);
    }
    text
}

fn as_text(document: &Iso9283PlanDocument) -> String {
    let mut text = format!("{}\n", phrase!("plan-side", side = document.side_mm, plane = document.test_plane));
    for (k, [x, y, z]) in (1..).zip(&document.corners_mm) {
        let _ = writeln!(text, "C{k} {x:.3} {y:.3} {z:.3}");
    }
    for places in &document.places {
        let _ = writeln!(text, "{}: {}, {} points", places.name, places.purpose, places.points.len());
    }
    for (k, point) in document.places.iter().take(1).flat_map(|poses| (1..).zip(&poses.points)) {
        let cells = XYZ.into_iter().chain(ANGLES).filter_map(|name| Some(format!("{:.3}", point.get(name)?)));
        let _ = writeln!(text, "P{k} {}", cells.collect::<Vec<_>>().join(" "));
    }
    text + &programme(document)
}
