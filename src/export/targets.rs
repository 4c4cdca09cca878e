//! Poses to measure as targets that a controller loads: JSON by name, or a C header of arrays.

use super::c_header::{comment, identifier, literal};
use crate::document::PlanDocument;
use crate::message::{Message, Result};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;

/// `etalon/targets/1`: joint values by column, one target a configuration.
#[derive(Serialize)]
struct Targets<'a> {
    schema: &'static str,
    robot: &'a str,
    targets: Vec<Target<'a>>,
    etalon: &'a str,
    /// sha256 by name
    inputs: &'a BTreeMap<String, String>,
}

#[derive(Serialize)]
struct Target<'a> {
    name: String,
    pose: i64,
    configuration: usize,
    joints: &'a BTreeMap<String, f64>,
}

/// The chosen poses of a plan, as JSON or, for a file name that ends in `.h`, as a C header.
pub fn targets(document: &PlanDocument, file_name: &str) -> Result<Vec<u8>> {
    let all = document.chosen.iter().flat_map(|planned| {
        planned.configurations.iter().enumerate().map(|(k, joints)| Target {
            name: format!("P{}_{}", planned.pose, k + 1),
            pose: planned.pose,
            configuration: k + 1,
            joints,
        })
    });
    let all: Vec<Target> = all.collect();
    if all.iter().flat_map(|t| t.joints.values()).any(|v| !v.is_finite()) {
        return Err(Message::error("a joint value of the plan is not finite: no target is written").into());
    }
    match file_name.rsplit_once('.').map(|(_, ending)| ending) {
        Some("h") => Ok(c_header(document, &all).into_bytes()),
        Some("json") => json(document, all),
        _ => {
            let message = Message::error(format!("`{file_name}` names no format of targets"));
            Err(message.expected("a name that ends in `.json` or `.h`; `--poses` writes CSV").into())
        }
    }
}

fn json(document: &PlanDocument, targets: Vec<Target>) -> Result<Vec<u8>> {
    let all = Targets {
        schema: "etalon/targets/1",
        robot: &document.robot,
        targets,
        etalon: &document.provenance.version,
        inputs: &document.provenance.inputs,
    };
    let mut bytes = serde_json::to_vec_pretty(&all)
        .map_err(|e| Message::error(format!("cannot write the targets as JSON: {e}")))?;
    bytes.push(b'\n');
    Ok(bytes)
}

/// One array a column, all of the same length: C99 and C++.
fn c_header(document: &PlanDocument, targets: &[Target]) -> String {
    let robot = identifier(&document.robot);
    let mut out = format!("/* Targets of robot {}: poses to measure.\n", comment(&document.robot));
    let _ = writeln!(out, " * Written by etalon {}.", comment(&document.provenance.version));
    for (name, sha256) in &document.provenance.inputs {
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
    for column in targets.first().iter().flat_map(|t| t.joints.keys()) {
        let values = targets.iter().filter_map(|t| t.joints.get(column)).map(|v| literal(*v)).collect();
        array("double", column, values);
    }
    let _ = write!(out, "\n#endif /* ETALON_{robot}_TARGETS_H */\n");
    out
}
