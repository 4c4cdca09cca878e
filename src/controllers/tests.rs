//! All formats with the same parameters: written values read back bit for bit.

mod certificates;
mod field;
#[path = "../../tests/support/skipped.rs"]
mod skipped;

use super::*;
use etalon_base::catalogue::IntoArgument;
use etalon_documents::ResidualKind;
use etalon_documents::Termination;
use etalon_documents::{ObservabilitySummary, Provenance, ResidualSummary, SolverSummary};
use skipped::skipped;
use std::process::Command;

const NUMBERS: [f64; 8] =
    [300.000_000_000_000_06, -0.1, 1.0 / 3.0, 5e-324, -1.797_693_134_862_315_7e308, 0.0, -0.0, 123_456_789.123_456_79];

fn parameter(name: &str, unit: &str, value: f64) -> ParameterEntry {
    ParameterEntry {
        name: name.to_owned(),
        unit: unit.to_owned(),
        full_unit: None,
        role: Default::default(),
        meaning: String::new(),
        meaning_id: None,
        tolerance: None,
        nominal: value,
        before: value,
        value,
        standard_uncertainty: Some(1e-7),
        degrees_of_freedom: None,
        determined: None,
        status: ParameterStatus::Identified,
        confounded_with: vec![],
    }
}

fn document(parameters: Vec<ParameterEntry>) -> ParametersDocument {
    let termination = Termination::StepVanished;
    ParametersDocument {
        schema: ParametersDocument::SCHEMA.to_owned(),
        robot: "prexyt".to_owned(),
        valid_until: None,
        synthetic: None,
        links: None,
        parameters,
        reference_temperature_c: None,
        reference_poses: Vec::new(),
        sketches: vec![],
        covariance: vec![],
        covariance_without: vec![],
        budget: vec![],
        residuals: ResidualSummary {
            position: etalon_documents::PositionResiduals::default(),
            kind: ResidualKind::Targets,
            count: 0,
            rms: 0.0,
            max: 0.0,
            degrees_of_freedom: 0,
            effective_degrees_of_freedom: None,
            test: etalon_documents::ResidualTest::default(),
            uncertainties_from: etalon_documents::UncertaintyFrom::Instrument,
            uncertainties_enlarged_by: 1.0,
            conditions: Vec::new(),
            between_series: None,
        },
        known: Vec::new(),
        reliability: None,
        robust: None,
        observability: Some(ObservabilitySummary {
            o1: 0.0,
            o2: 0.0,
            o3: 0.0,
            o4: 0.0,
            o5: 0.0,
            condition: 1.0,
            rank: 0,
            scaling: etalon_base::worded::Worded::default(),
            singular_values: vec![],
            held_singular_values: vec![],
            rank_cut: 1e-9,
        }),
        untested: Vec::new(),
        solver: SolverSummary { method: "lm".into(), iterations: 3, termination, meaning: termination.to_string() },
        messages: vec![],
        provenance: Provenance {
            version: "0.1.0".to_owned(),
            inputs: [("campaign.toml".to_owned(), "ab".repeat(32))].into(),
            seed: None,
        },
    }
}

fn numbers() -> ParametersDocument {
    let units = ["mm", "deg", "1", "mm", "mm", "deg", "1", "mm"];
    document((0..8).map(|i| parameter(&format!("p{i}"), units[i], NUMBERS[i])).collect())
}

fn text(name: &str, document: &ParametersDocument) -> String {
    String::from_utf8(by_name(name).unwrap().write(&ExportInput::parameters(document)).unwrap()).unwrap()
}

/// Values under a load or at a temperature have their unit in every kind of file.
#[test]
fn units_by_load_and_temperature_are_in_headers_and_columns() {
    let mut drift = parameter("drift_2", "deg", 0.015);
    drift.full_unit = Some("deg/(10 K)".to_owned());
    let mut document = document(vec![parameter("d", "mm", 300.0), drift]);
    document.reference_temperature_c = Some(21.5);
    for (format, parts) in [
        ("siemens-scl", &["// in deg per (10 K): drift_2", "// deg per (10 K)", "21.5 degC"][..]),
        ("c-header", &["in deg per (10 K): drift_2", "deg per (10 K) */"]),
        ("galil", &["drift_2 in 1E-6 deg per (10 K)", "REM d in um"]),
        ("json", &["\"full_unit\": \"deg/(10 K)\"", "\"reference_temperature_c\": 21.5"]),
        ("csv", &[",full_unit\n", ",deg/(10 K)\n", ",mm\n"]),
    ] {
        let text = text(format, &document);
        parts.iter().for_each(|part| assert!(text.contains(part), "{format}: {part}\n{text}"));
    }
}

#[test]
fn every_name_has_a_format_with_one_file() {
    let files: BTreeSet<_> = names().map(|n| by_name(n).unwrap().file_name()).collect();
    assert_eq!(files.len(), names().count());
    assert!(by_name("JSON ").is_err());
}

#[test]
fn json_reads_back_bit_for_bit() {
    let json: serde_json::Value = serde_json::from_str(&text("json", &numbers())).unwrap();
    for (i, number) in NUMBERS.iter().enumerate() {
        let read = json["parameters"][format!("p{i}")]["value"].as_f64().unwrap();
        assert_eq!(read.to_bits(), number.to_bits());
    }
    assert_eq!(json["schema"], "etalon/controller/1");
    assert_eq!(json["parameters"]["p1"]["unit"], "deg");
    assert_eq!(json["parameters"]["p1"]["standard_uncertainty"], 1e-7);
    assert_eq!(json["parameters"]["p1"]["status"], "identified");
    assert_eq!(json["inputs"]["campaign.toml"], "ab".repeat(32));
}

#[test]
fn csv_reads_back_bit_for_bit() {
    let written = text("csv", &numbers());
    let mut reader = ::csv::Reader::from_reader(written.as_bytes());
    let rows: Vec<_> = reader.records().map(|r| r.unwrap()).collect();
    assert_eq!(rows.len(), NUMBERS.len());
    for (row, number) in rows.iter().zip(NUMBERS) {
        for column in [2, 3] {
            assert_eq!(row[column].parse::<f64>().unwrap().to_bits(), number.to_bits());
        }
        assert_eq!((row[4].parse::<f64>().unwrap(), &row[5]), (1e-7, "identified"));
    }
}

#[test]
fn a_spreadsheet_sees_no_formula() {
    let names = ["=1+1", "+1", "-1", "@sum", "\tx", "a\"b,c\nd"];
    let written = text("csv", &document(names.iter().map(|n| parameter(n, "mm", -1.0)).collect()));
    let mut reader = ::csv::Reader::from_reader(written.as_bytes());
    let read: Vec<_> = reader.records().map(|r| r.unwrap()).map(|r| (r[0].to_owned(), r[3].to_owned())).collect();
    let safe = ["'=1+1", "'+1", "'-1", "'@sum", "'\tx", "a\"b,c\nd"];
    assert_eq!(read, safe.map(|name| (name.to_owned(), "-1.0".to_owned())));
}

#[test]
fn a_c_header_reads_back_bit_for_bit() {
    let header = text("c-header", &numbers());
    let value = |name: &str| -> f64 {
        let line = header.lines().find_map(|l| l.strip_prefix(&format!("#define {name} "))).unwrap();
        line.trim_matches(['(', ')']).parse().unwrap()
    };
    let suffixes = ["MM", "DEG", "RATIO", "MM", "MM", "DEG", "RATIO", "MM"];
    for (i, number) in NUMBERS.iter().enumerate() {
        assert_eq!(value(&format!("ETALON_PREXYT_P{i}_{}", suffixes[i])).to_bits(), number.to_bits());
    }
    assert_eq!(value("ETALON_PREXYT_P1_RAD"), (-0.1f64).to_radians());
}

/// Python itself reads the module, and our own reader the MATLAB function, independent of the
/// names.
#[test]
fn matlab_and_python_read_back_bit_for_bit() {
    let hostile = "%} ' \"\"\" # */ \n\\ \u{202e}\u{e9}";
    let mut document = numbers();
    document.parameters.push(parameter(hostile, "mm", 1.0));
    document.covariance = (0..9).map(|i| (0..9).map(|j| f64::from(u8::from(i == j)) * 1e-14).collect()).collect();
    let matlab = text("matlab", &document);
    assert!(matlab.starts_with("function p = etalon_parameters()\n") && matlab.is_ascii());
    for (i, number) in NUMBERS.iter().enumerate() {
        let line = matlab.lines().find_map(|l| l.strip_prefix(&format!("p.p{i} = struct('value', "))).unwrap();
        assert_eq!(line.split(',').next().unwrap().parse::<f64>().unwrap().to_bits(), number.to_bits());
    }
    // every line is a comment or a complete statement
    let ends = |l: &str| l.starts_with('%') || l.ends_with(';') || l.starts_with("function") || l == "end";
    assert!(matlab.lines().all(ends), "{matlab}");
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("etalon_parameters.py"), text("python", &document)).unwrap();
    let script = "import etalon_parameters as e\nfor p in e.parameters.values(): print(repr(p[0]))\n\
                  assert len(e.identified) == len(e.covariance) == 9 and list(e.parameters)[8] == e.identified[8]\n\
                  print(ascii(e.identified[8]))";
    let Ok(output) = Command::new("python3").args(["-B", "-c", script]).current_dir(folder.path()).output() else {
        return skipped("python3");
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = String::from_utf8(output.stdout).unwrap();
    for (line, number) in read.lines().zip(NUMBERS) {
        assert_eq!(line.parse::<f64>().unwrap().to_bits(), number.to_bits());
    }
    assert!(read.contains("202e"), "{read}");
}

/// NumPy, SciPy and Octave read the arrays, independent of the names.
#[test]
fn arrays_read_back_bit_for_bit() {
    let mut document = numbers();
    document.parameters.push(parameter("\u{e9}' \"%s\n\u{5d0}", "mm", 1.0));
    (document.parameters[1].status, document.parameters[1].standard_uncertainty) = (ParameterStatus::Fixed, None);
    document.covariance = (0..8u32).map(|i| (0..8u32).map(|j| f64::from(i * j + 1) / 3.0).collect()).collect();
    let folder = tempfile::tempdir().unwrap();
    for format in ["numpy", "mat"] {
        let exporter = by_name(format).unwrap();
        let bytes = exporter.write(&ExportInput::parameters(&document)).unwrap();
        std::fs::write(folder.path().join(exporter.file_name()), bytes).unwrap();
    }
    let numpy = "import numpy as n\na = n.load('etalon_parameters.npz')\nfirst = 0\n";
    let scipy = "import scipy.io, numpy as n\na = {k: v if k == 'covariance' else v.ravel() for k, v in scipy.io.loadmat('etalon_parameters.mat').items() \
                 if k[0] != '_'}\na = {k: n.array([str(t[0]) for t in v]) if v.dtype == object else v for k, v in a.items()}\nfirst = 1\n";
    let print = "print(*[float(v).hex() for v in a['value']])\nprint(*[float(v).hex() for v in a['nominal']])\n\
                 print(*[int(v) - first for v in a['identified']])\nprint(*[int(v) - first for v in a['covariance_of']])\n\
                 assert a['covariance'].shape == (8, 8) and list(a['standard_uncertainty']) == [1e-7] * 8\n\
                 assert all(a['covariance'][i, j] == (i * j + 1) / 3 for i in range(8) for j in range(8))\n\
                 assert a['name'][8] == '\\xe9\\' \"%s\\n\\u05d0' and a['unit'][1] == 'deg' and any('sha256' in t for t in a['about'])\n";
    // numbers as printed by Python
    let expected = NUMBERS.iter().chain(&[1.0]).map(|v| format!("{v:?}")).collect::<Vec<_>>().join(",");
    for (reader, needs, script) in [("numpy", "numpy", numpy), ("scipy", "scipy.io", scipy)] {
        let run = |script: &str| Command::new("python3").args(["-c", script]).current_dir(folder.path()).output();
        if !run(&format!("import {needs}")).is_ok_and(|output| output.status.success()) {
            skipped(reader);
            continue;
        }
        let check = format!("{script}{print}e = [float(v).hex() for v in [{expected}]]\nprint(*e)\n");
        let output = run(&check).unwrap();
        assert!(output.status.success(), "{reader}: {}", String::from_utf8_lossy(&output.stderr));
        let read = String::from_utf8(output.stdout).unwrap();
        let lines: Vec<&str> = read.lines().collect();
        assert!(lines[0] == lines[4] && lines[1] == lines[4], "{reader}: {read}");
        assert_eq!((lines[2], lines[3]), ("0 2 3 4 5 6 7 8", "0 2 3 4 5 6 7 8"), "{reader}");
    }
    let script = "load etalon_parameters.mat; printf('%.17g ', value); printf('%d ', size(covariance)); printf('%s ', name{1}, unit{2}, about{end});";
    match Command::new("octave-cli").args(["--quiet", "--eval", script]).current_dir(folder.path()).output() {
        Ok(output) => {
            let read = String::from_utf8_lossy(&output.stdout).into_owned();
            let values: Vec<f64> = read.split(' ').take(8).map(|v| v.parse().unwrap()).collect();
            assert_eq!(values, NUMBERS, "{read}");
            assert!(read.contains("8 8 p0 deg ") && read.contains("sha256 of parameters.json"), "{read}");
        }
        Err(_) => skipped("octave-cli"),
    }
}

#[test]
fn names_that_are_one_in_c_are_refused() {
    let two = document(vec![parameter("d-2", "mm", 1.0), parameter("d_2", "mm", 2.0)]);
    let refused = by_name("c-header").unwrap().write(&ExportInput::parameters(&two)).unwrap_err();
    let names: [(&str, &dyn IntoArgument); 3] =
        [("first", &"d-2"), ("second", &"d_2"), ("name", &"ETALON_PREXYT_D_2_MM")];
    assert!(refused.0[0].is("parameter-names-collide", &names), "{refused}");
}

#[test]
fn what_a_machine_must_not_run_is_refused() {
    let mut lost = numbers();
    lost.solver.termination = Termination::IterationLimit;
    let nan = document(vec![parameter("d", "mm", f64::NAN)]);
    let twice = document(vec![parameter("d", "mm", 1.0), parameter("d", "mm", 1.0)]);
    let cases = [(lost, "parameters-not-converged"), (nan, "parameter-not-finite"), (twice, "parameter-twice")];
    for (document, id) in cases {
        for name in names() {
            let refused = by_name(name).unwrap().write(&ExportInput::parameters(&document)).unwrap_err();
            assert!(refused.0.iter().any(|m| m.is(id, &[])), "{name}: {refused}");
        }
    }
}

/// A variable of a Galil controller is a multiple of 1/65536 in µm and 1E-6 deg; each reads back
/// within the rounding that it gives.
#[test]
fn a_galil_controller_holds_values_within_a_tenth_of_their_uncertainty() {
    let with = |u: f64| {
        let mut all = vec![
            parameter("l11", "mm", 300.012_345_678_9),
            parameter("epsilon_theta", "deg", -70.731_234_567_89),
            parameter("delta2", "1", 1.000_023_1),
        ];
        all.iter_mut().for_each(|p| p.standard_uncertainty = Some(u));
        document(all)
    };
    let written = text("galil", &with(1e-6));
    for (name, value, scale) in
        [("KVL11", 300.012_345_678_9, 1e3), ("KVEPSILO", -70.731_234_567_89, 1e6), ("KVDELTA2", 1.000_023_1, 1e6)]
    {
        let line = written.lines().find_map(|l| l.strip_prefix(&format!("{name}="))).unwrap();
        let held: f64 = line.parse().unwrap();
        assert_eq!(held * 65_536.0, (held * 65_536.0).round(), "{line}");
        assert!((held - value * scale).abs() <= 0.5 / 65_536.0, "{line}");
    }
    assert!(
        written.lines().all(|l| l.is_ascii() && (l.len() <= 80 || l.starts_with("REM")))
            && written.contains("rounding "),
        "{written}"
    );
    let refused = by_name("galil").unwrap().write(&ExportInput::parameters(&with(1e-11))).unwrap_err();
    assert!(refused.0[0].is("galil-rounding", &[("parameter", &"l11"), ("uncertainty", &1e-11)]), "{refused}");
}

#[test]
fn a_list_of_twincat_reads_back_bit_for_bit() {
    let written = text("twincat", &numbers());
    let declaration = written.split("<![CDATA[").nth(1).unwrap().split("]]>").next().unwrap();
    for (i, number) in NUMBERS.iter().enumerate() {
        let literal = declaration.split(&format!("c_p{i} : LREAL := ")).nth(1).unwrap().split(';').next().unwrap();
        assert!(literal.split('E').next().unwrap().contains('.'), "{literal}");
        assert_eq!(literal.parse::<f64>().unwrap().to_bits(), number.to_bits());
    }
    let hostile = text("twincat", &document(vec![parameter("]]> ' */ END_VAR", "mm", 1.0)]));
    assert_eq!((hostile.matches("]]>").count(), hostile.matches("END_VAR").count()), (1, 1), "{hostile}");
}

/// An independent reader of XML, and lines of a data block.
#[test]
fn constants_of_plcs_read_back_bit_for_bit() {
    let hostile = "*) // \" ' END_STRUCT; <x> --> & \n";
    let mut document = numbers();
    document.parameters.push(parameter(hostile, "mm", 1.0));
    let scl = text("siemens-scl", &document);
    let values =
        scl.lines().filter_map(|line| line.split_once(" : LReal := ")).map(|(_, v)| v.split(';').next().unwrap());
    let values: Vec<&str> = values.collect();
    assert!(values.iter().all(|v| v.split('E').next().unwrap().contains('.')), "{values:?}");
    assert!(scl.is_ascii() && scl.matches("END_STRUCT;").count() == 1, "{scl}");
    let read: Vec<u64> = values.iter().map(|v| v.parse::<f64>().unwrap().to_bits()).collect();
    let expected: Vec<u64> = NUMBERS.iter().chain(&[1.0]).map(|v| v.to_bits()).collect();
    assert_eq!(read, expected);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("plc.xml"), text("plcopen", &document)).unwrap();
    let script = "import xml.etree.ElementTree as E\nn = '{http://www.plcopen.org/xml/tc6_0200}'\nr = E.parse('plc.xml').getroot()\n\
                  for v in r.iter(n + 'variable'): print(v.find('.//' + n + 'simpleValue').get('value'))";
    let Ok(output) = Command::new("python3").args(["-c", script]).current_dir(folder.path()).output() else {
        return skipped("python3");
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = String::from_utf8(output.stdout).unwrap();
    let read: Vec<u64> = read.lines().map(|v| v.parse::<f64>().unwrap().to_bits()).collect();
    assert_eq!(read, expected);
}

/// Parameters of a solver that did not converge, and of an implausible result: each
/// file says so, or is not written.
#[test]
fn what_failed_its_checks_is_written_by_force_alone_and_says_so() {
    let arm = etalon_robots::Serial::new(
        &[
            [0.0; 4],
            [90.0, 10.0, 0.0, 0.0],
            [0.0, 300.0, 0.0, 0.0],
            [90.0, 50.0, 0.0, 300.0],
            [-90.0, 0.0, 0.0, 0.0],
            [90.0, 0.0, 0.0, 70.0],
        ]
        .map(|[alpha, a_mm, theta, d_mm]| etalon_robots::SerialJoint {
            alpha_rad: f64::to_radians(alpha),
            a_mm,
            theta_rad: theta,
            d_mm,
            prismatic: false,
            parallel: alpha == 0.0,
        }),
        &["tool".to_owned()],
        [0.0, 0.0, -1.0],
        &[],
        &[],
    );
    let entries = arm.parameters().iter().map(|p| parameter(&p.name, p.quantity.unit(), p.quantity.outward(p.nominal)));
    let whole = document(entries.collect());
    let mut lost = whole.clone();
    lost.solver.termination = Termination::IterationLimit;
    let mut wrong = whole.clone();
    wrong.messages.push(Message::error("*/ joint 2 turns the other way \n"));
    let summary = certificates::summary();
    // formats of other robots reject this robot, and a recording needs measured points
    let others =
        ["urdf", "linuxcnc-hexapod", "linuxcnc-delta", "klipper-delta", "reprap-delta", "reprap-five-bar", "mcap"];
    for name in names().filter(|name| !others.contains(name)) {
        let exporter = by_name(name).unwrap();
        let given = |parameters, force| ExportInput {
            robot: Some(&arm),
            summary: Some(&summary),
            force,
            ..ExportInput::parameters(parameters)
        };
        let fit = exporter.write(&given(&whole, false)).unwrap();
        assert_eq!(fit, exporter.write(&given(&whole, true)).unwrap(), "{name}");
        for (document, why) in [(&lost, "not converged"), (&wrong, "joint 2 turns the other way")] {
            let refused = exporter.write(&given(document, false)).unwrap_err().to_string();
            assert!(refused.contains(why), "{name}: {refused}");
            // characters of arrays have more than one byte
            let forced = exporter.write(&given(document, true)).unwrap();
            let forced = String::from_utf8_lossy(&forced).replace('\0', "");
            let head: String = forced.lines().take(8).collect();
            assert!(head.contains("NOT FIT FOR A CONTROLLER") && head.contains(why), "{name}: {head}");
        }
        // parameters of synthetic data, given by the document or by the campaign, say so
        let mut synthetic = whole.clone();
        synthetic.synthetic = Some("made with seed 7".to_owned());
        let mut simulated = summary.clone();
        simulated.measurements.synthetic.clone_from(&synthetic.synthetic);
        let by_campaign = ExportInput { summary: Some(&simulated), ..given(&whole, false) };
        for (given, is_synthetic) in
            [(given(&whole, false), false), (given(&synthetic, false), true), (by_campaign, true)]
        {
            let written = exporter.write(&given).unwrap();
            let written = String::from_utf8_lossy(&written).replace('\0', "");
            let is_stated = written.contains("SYNTHETIC DATA, not of a measured robot: made with seed 7");
            assert_eq!(is_stated, is_synthetic, "{name}: {written}");
        }
        // NaN is never written
        let mut nan = whole.clone();
        nan.parameters[0].value = f64::NAN;
        assert!(exporter.write(&given(&nan, true)).is_err(), "{name}");
    }
}

#[test]
fn compilers_read_the_same_numbers_whatever_the_names() {
    let hostile = "*/ int x; /* ??/ \\\n// \u{202e}\u{e9}\u{5d0}";
    let mut document = numbers();
    document.parameters.push(parameter(hostile, "mm", 1.0));
    document.provenance.inputs.insert(hostile.to_owned(), hostile.to_owned());
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name);
    std::fs::write(file("p.h"), text("c-header", &document)).unwrap();
    let suffixes = ["MM", "DEG", "RATIO", "MM", "MM", "DEG", "RATIO", "MM"];
    let prints: String =
        (0..8).map(|i| format!("printf(\"%.17g\\n\", 0-ETALON_PREXYT_P{i}_{});\n", suffixes[i])).collect();
    let source =
        format!("#include \"p.h\"\n#include \"p.h\"\n#include <stdio.h>\nint main(void) {{\n{prints}return 0;\n}}\n");
    std::fs::write(file("p.c"), &source).unwrap();
    std::fs::write(file("p.cpp"), &source).unwrap();
    for (compiler, standard, name) in [("cc", "-std=c99", "p.c"), ("c++", "-std=c++11", "p.cpp")] {
        if Command::new(compiler).arg("--version").output().is_err() {
            skipped(compiler);
            continue;
        }
        let program = file("p.out");
        let flags = [standard, "-Wall", "-Wextra", "-Werror", "-pedantic", "-o"];
        let compiled = Command::new(compiler).args(flags).arg(&program).arg(file(name)).output().unwrap();
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        let output = String::from_utf8(Command::new(&program).output().unwrap().stdout).unwrap();
        let read: Vec<f64> = output.lines().map(|l| l.parse().unwrap()).collect();
        assert_eq!(read, NUMBERS.map(|n| 0.0 - n));
    }
}

/// The error of a file decides: its root mean square, its maximum, or both.
#[test]
fn a_file_that_is_not_clearly_better_than_nominal_is_warned_of() {
    let errors = |rms_mm, max_mm| etalon_documents::PositionErrors { rms_mm, max_mm };
    let nominal = errors(0.5, 1.0);
    let statement = |written| {
        let (set, identified) = (etalon_documents::PoseSet::Validation, errors(0.1, 0.2));
        let mut statement = Statement::default();
        statement.errors = Some(etalon_documents::ControllerErrors { set, nominal, identified, written });
        statement
    };
    for (written, case) in [
        (errors(0.47, 1.0), None),
        (errors(0.48, 0.9), Some("rms")),
        (errors(0.2, 1.01), Some("maximum")),
        (errors(0.48, 1.01), Some("both")),
    ] {
        let statement = statement(written);
        let reason = statement.near_nominal();
        let found = reason.as_ref().map(|reason| reason.arguments["case"].clone());
        assert_eq!(found, case.map(|case| case.argument()), "{written:?}");
        let warning = statement.warning(&["csv", "json"]);
        assert_eq!(warning.is_some_and(|w| w.is("file-near-nominal", &[("formats_count", &2usize)])), case.is_some());
        // a line of the header, and a key where a format has none
        let line = reason.map(|reason| reason.to_string());
        assert_eq!(statement.lines().last().filter(|line| line.contains("maximum")).cloned(), line);
        let parameters = numbers();
        let given = ExportInput { file: Some((&statement, &parameters)), ..ExportInput::parameters(&parameters) };
        assert_eq!(given.caution(), line);
    }
}

#[test]
fn effects_that_a_format_cannot_hold_are_named() {
    // a coupling in the nominal values counts too
    let text =
        "model = \"serial\"\nbending = [2]\ncoupling = [[3, 2]]\nbacklash = [1]\n[nominal]\ncoupling_3_2 = 0.01\n";
    let joint = "[[joint]]\nalpha_deg = 90.0\na_mm = 100.0\ntheta_deg = 0.0\nd_mm = 290.0\n";
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), text.to_owned() + &joint.repeat(3)).unwrap();
    let file = etalon_campaign::read_robot(&folder.path().join("robot.toml")).unwrap();
    let robot = file.build(&["tool".to_owned()]).unwrap();
    let with = |value: f64| {
        let names =
            [("a_2", "mm"), ("gain_2", "1"), ("compliance_2_2", "deg"), ("coupling_3_2", "1"), ("backlash_1", "deg")];
        let document = document(names.map(|(name, unit)| parameter(name, unit, value)).into());
        assert!(document.parameters.iter().all(|p| robot.index(&p.name).is_some()), "{:?}", robot.parameters());
        let given = ExportInput { robot: Some(robot.as_ref()), ..ExportInput::parameters(&document) };
        [given.header_of_geometry("m, rad"), given.header_of_code("m, rad")].map(|lines| lines.unwrap().join("\n"))
    };
    let [geometry, code] = with(0.01);
    assert!(geometry.ends_with("not in this format: compliance_2_2, coupling_3_2, backlash_1"), "{geometry}");
    assert!(code.ends_with("not in this code: backlash_1"), "{code}");
    assert!(with(0.0).iter().all(|header| !header.contains("not in this")));
}
