//! Validation of this installation (ISO/IEC 17025:2017, 7.11.2): comparisons with reference values
//! that are part of the program, one subject a file. To add one: its file, and a line of
//! `SUBJECTS`.

mod certified;
mod comparisons;
mod data;
mod embedded;
mod formats;
pub mod performance;
mod row;
mod sample;
mod threads;

use comparisons::{
    code, coverage, exports, fits, frames, identification, kinematics, nist, solver, standards, uncertainty,
};

use data::{Data, Slip};
use etalon_base::files;
use etalon_base::message::Result;
use etalon_documents::{
    LockedPackage, Machine, Provenance, SelftestDocument, SelftestMustFail, SelftestProgram, SelftestRequirement,
};
use row::{Comparison, Subject, requirement_result};
use sample::Scratch;
use std::collections::BTreeMap;

/// All requirements, in the order of the record.
const SUBJECTS: [&Subject; 12] = [
    &fits::SUBJECT,
    &solver::SUBJECT,
    &frames::SUBJECT,
    &kinematics::SUBJECT,
    &identification::SUBJECT,
    &certified::SUBJECT,
    &uncertainty::SUBJECT,
    &standards::SUBJECT,
    &coverage::SUBJECT,
    &formats::SUBJECT,
    &exports::SUBJECT,
    &threads::SUBJECT,
];

/// Validates this installation. `expected_sha256` is the hash of the program file, if it is known;
/// `report` is called with the number of finished requirements and of all.
///
/// # Errors
/// Fails if the reference data cannot be read, or no temporary folder can be written.
pub fn selftest(expected_sha256: Option<&str>, report: &mut dyn FnMut(usize, usize)) -> Result<SelftestDocument> {
    let data = Data::embedded()?;
    // fails before anything is computed if no temporary file can be written
    drop(Scratch::with(&[])?);
    let mut requirements = Vec::new();
    let mut must_fail = Vec::new();
    for (i, subject) in SUBJECTS.iter().enumerate() {
        let tested = requirement(subject, &data);
        let already = tested.checks.iter().filter(|check| !check.pass).count();
        must_fail.extend(subject.slips.iter().map(|slip| slipped(subject, slip, &data, already)));
        requirements.push(tested);
        report(i + 1, SUBJECTS.len());
    }
    let nist = nist::requirement();
    let reference_folder = nist.is_some();
    requirements.extend(nist);
    let program = program(expected_sha256);
    let reference = data::files();
    let passes = program.pass
        && reference.iter().all(|file| file.pass)
        && requirements.iter().all(|r: &SelftestRequirement| r.pass)
        && must_fail.iter().all(|m: &SelftestMustFail| m.pass);
    Ok(SelftestDocument {
        schema: SelftestDocument::SCHEMA.to_owned(),
        pass: passes,
        program,
        machine: machine(),
        reference,
        reference_folder,
        requirements,
        must_fail,
        performance: None,
        packages: packages(),
        provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs: BTreeMap::new(), seed: None },
    })
}

fn requirement(subject: &Subject, data: &Data) -> SelftestRequirement {
    let requirement = (subject.requirement)();
    requirement_result(subject.id, requirement, (subject.rows)(data))
}

/// Repeats the tests of a subject with a seeded fault in its reference data. The fault is noticed
/// if more tests fail than the number that fail `already`.
fn slipped(subject: &Subject, slip: &Slip, data: &Data, already: usize) -> SelftestMustFail {
    let rows: Vec<Comparison> = (subject.rows)(&slip.applied(data)).into_iter().flat_map(|rows| rows.all).collect();
    let failed = rows.iter().filter(|row| !row.passes()).count();
    SelftestMustFail {
        id: subject.id.to_owned(),
        slip: slip.phrase().into(),
        checks: rows.len(),
        failed,
        pass: failed > already,
    }
}

/// The program file and its hash.
fn program(expected_sha256: Option<&str>) -> SelftestProgram {
    let path = std::env::current_exe().ok();
    let sha256 = path.as_deref().and_then(|path| files::sha256_of_file(path).ok());
    let expected_sha256 = expected_sha256.map(str::to_lowercase);
    SelftestProgram {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        pass: sha256.is_some() && (expected_sha256.is_none() || expected_sha256 == sha256),
        sha256,
        expected_sha256,
    }
}

fn machine() -> Machine {
    Machine {
        system: std::env::consts::OS.to_owned(),
        architecture: std::env::consts::ARCH.to_owned(),
        threads: std::thread::available_parallelism().map_or(1, usize::from),
    }
}

/// Packages of Cargo.lock, of which program, build scripts and tests are built.
fn packages() -> Vec<LockedPackage> {
    let lock: toml::Table = include_str!("../../../Cargo.lock").parse().unwrap_or_default();
    let text = |package: &toml::Value, key: &str| Some(package.get(key)?.as_str()?.to_owned());
    let package = |p: &toml::Value| {
        Some(LockedPackage { name: text(p, "name")?, version: text(p, "version")?, sha256: text(p, "checksum") })
    };
    let all = lock.get("package").and_then(toml::Value::as_array);
    all.into_iter().flatten().filter_map(package).collect()
}
