//! Poses to measure as targets for a controller: JSON by name, or a C header with arrays.

use super::template::{comment, identifier, literal};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose_name::PoseName;
use etalon_documents::{Iso9283Places, PlanDocument};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Document `etalon/targets/1`: joint values or coordinates by column, with one target per
/// configuration.
#[derive(Serialize)]
struct Targets<'a> {
    schema: &'static str,
    robot: &'a str,
    targets: Vec<Target<'a>>,
    etalon: &'a str,
    /// SHA-256 by file name.
    inputs: &'a BTreeMap<String, String>,
}

#[derive(Serialize)]
struct Target<'a> {
    name: String,
    pose: PoseName,
    configuration: usize,
    #[serde(flatten)]
    values: Values<'a>,
}

#[derive(Serialize)]
#[serde(rename_all = "lowercase")]
enum Values<'a> {
    Joints(&'a BTreeMap<String, f64>),
    Coordinates(&'a BTreeMap<String, f64>),
}

impl Target<'_> {
    fn values(&self) -> &BTreeMap<String, f64> {
        match self.values {
            Values::Joints(values) | Values::Coordinates(values) => values,
        }
    }
}

/// Chosen poses of a plan as JSON or, for a file name that ends in `.h`, as a C header.
pub fn targets(document: &PlanDocument, file_name: &str) -> Result<Vec<u8>> {
    let all = document.choice.chosen.iter().flat_map(|planned| {
        planned.configurations.iter().enumerate().map(|(k, joints)| Target {
            name: format!("P{}_{}", planned.pose, k + 1),
            pose: planned.pose,
            configuration: k + 1,
            values: Values::Joints(joints),
        })
    });
    write(
        Targets {
            schema: SCHEMA,
            robot: &document.robot,
            targets: all.collect(),
            etalon: &document.provenance.version,
            inputs: &document.provenance.inputs,
        },
        file_name,
    )
}

/// Places of a test to ISO 9283 in base coordinates, as JSON or, for a file name that ends in `.h`,
/// as a C header.
pub fn places(places: &Iso9283Places, file_name: &str) -> Result<Vec<u8>> {
    let target = |(number, coordinates): (i64, _)| Target {
        name: format!("{}_{number}", places.name),
        pose: number.into(),
        configuration: 1,
        values: Values::Coordinates(coordinates),
    };
    write(
        Targets {
            schema: SCHEMA,
            robot: &format!("iso9283 {}", places.name),
            targets: (1..).zip(&places.points).map(target).collect(),
            etalon: env!("CARGO_PKG_VERSION"),
            inputs: &BTreeMap::new(),
        },
        file_name,
    )
}

const SCHEMA: &str = "etalon/targets/1";

fn write(all: Targets, file_name: &str) -> Result<Vec<u8>> {
    if all.targets.iter().flat_map(|t| t.values().values()).any(|v| !v.is_finite()) {
        return Err(error!("targets-not-finite").into());
    }
    match file_name.rsplit_once('.').map(|(_, ending)| ending) {
        Some("h") => Ok(c_header(&all).into_bytes()),
        Some("json") => {
            let mut bytes = serde_json::to_vec_pretty(&all)
                .map_err(|e| error!("cannot-encode", format = "JSON", reason = e.to_string()))?;
            bytes.push(b'\n');
            Ok(bytes)
        }
        _ => Err(error!("targets-format-unknown", file = file_name).into()),
    }
}

/// One array per column, all of equal length: C99 and C++.
fn c_header(all: &Targets) -> String {
    let (robot, targets) = (identifier(all.robot), &all.targets);
    let mut out = format!("/* Targets of robot {}: poses to measure.\n", comment(all.robot));
    let _ = writeln!(out, " * Written by etalon {}.", comment(all.etalon));
    for (name, sha256) in all.inputs {
        let _ = writeln!(out, " * sha256 {}  {}", comment(sha256), comment(name));
    }
    let _ = write!(out, " */\n#ifndef ETALON_{robot}_TARGETS_H\n#define ETALON_{robot}_TARGETS_H\n\n");
    let _ = writeln!(out, "#define ETALON_{robot}_TARGETS {}\n", targets.len());
    let mut array = |kind: &str, name: &str, cells: Vec<String>| {
        let _ = writeln!(
            out,
            "static const {kind} etalon_{}_target_{}[ETALON_{robot}_TARGETS] = {{{}}};",
            robot.to_ascii_lowercase(),
            identifier(name).to_ascii_lowercase(),
            cells.join(", ")
        );
    };
    array("long", "pose", targets.iter().map(|t| t.pose.to_string()).collect());
    for column in targets.first().iter().flat_map(|t| t.values().keys()) {
        let values = targets.iter().filter_map(|t| t.values().get(column)).map(|v| literal(*v)).collect();
        array("double", column, values);
    }
    let _ = write!(out, "\n#endif /* ETALON_{robot}_TARGETS_H */\n");
    out
}
