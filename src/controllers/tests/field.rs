//! Code of a residual field in three languages beside the definition in `field.json`, at 1,000
//! drawn poses.

use super::skipped;
use crate::field_code;
use etalon_base::noise::Noise;
use etalon_documents::{FieldCentre, FieldComponent, FieldDocument, FieldInputEntry, FieldParameter};
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};

const JOINTS: [&str; 3] = ["q1_deg", "rail_mm", "q3_deg"];

/// Components of one and two joints with joints that turn and slide, drawn.
fn drawn(noise: &mut Noise) -> FieldDocument {
    let input = |k: usize| FieldInputEntry {
        joint: JOINTS[k].to_owned(),
        scale: [57.3, 300.0, 57.3][k],
        range: [[-80.0, 75.5], [-250.0, 310.0], [-90.0, 1e-5]][k],
        fade: [17.2, 90.0, 17.2][k],
    };
    let mut component = |joint: usize, inputs: &[usize], count: usize| FieldComponent {
        joint: JOINTS[joint].to_owned(),
        inputs: inputs.iter().map(|&k| input(k)).collect(),
        radius: 3.0 / inputs.len() as f64,
        prior: 0.05,
        centres: (0..count)
            .map(|i| FieldCentre {
                at: inputs.iter().map(|&k| noise.uniform(100.0 + 200.0 * f64::from(u8::from(k == 1)))).collect(),
                // the literal of a small weight has an exponent
                weight: noise.uniform(if i == 0 { 1e-7 } else { 0.1 }),
            })
            .collect(),
    };
    FieldDocument {
        schema: "etalon/field/1".to_owned(),
        robot: "serial".to_owned(),
        parameters_sha256: "0".repeat(64),
        joints: JOINTS.map(str::to_owned).to_vec(),
        components: vec![component(0, &[0], 7), component(2, &[1, 2], 12), component(1, &[2], 5)],
        parameters: vec![FieldParameter {
            // a comment of Structured Text that would end early
            name: "a*)_2".to_owned(),
            unit: "mm".to_owned(),
            role: Default::default(),
            value: 270.1,
            shift: -0.1,
        }],
        covariance: vec![],
        covariance_of: vec![],
        factor: 1.0,
        noise_mm: 0.02,
        synthetic: None,
        provenance: super::document(vec![]).provenance,
    }
}

/// Corrected joint values and the share, by the definition in the document.
fn by_definition(field: &FieldDocument, q: &[f64]) -> Vec<f64> {
    let index = |name: &String| JOINTS.iter().position(|joint| joint == name).unwrap();
    let share = |input: &FieldInputEntry| {
        let q = q[index(&input.joint)];
        let beyond = if q < input.range[0] { input.range[0] - q } else { (q - input.range[1]).max(0.0) } / input.fade;
        if beyond < 1.0 { 1.0 - 3.0 * beyond.powi(2) + 2.0 * beyond.powi(3) } else { 0.0 }
    };
    let share = field.components.iter().flat_map(|c| &c.inputs).map(share).fold(1.0, f64::min);
    let mut corrected = q.to_vec();
    for component in &field.components {
        for centre in &component.centres {
            let of = |(input, at): (&FieldInputEntry, &f64)| {
                ((q[index(&input.joint)] - at) / (input.scale * component.radius)).powi(2)
            };
            let d = component.inputs.iter().zip(&centre.at).map(of).sum::<f64>().sqrt();
            if d < 1.0 {
                corrected[index(&component.joint)] += share * centre.weight * (1.0 - d).powi(4) * (4.0 * d + 1.0);
            }
        }
    }
    corrected.push(share);
    corrected
}

/// Lines of numbers of a program that reads lines of joint values.
fn lines(command: &mut Command, input: &str) -> Option<Vec<Vec<f64>>> {
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().ok()?;
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{command:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    Some(text.lines().map(|line| line.split_whitespace().map(|v| v.parse().unwrap()).collect()).collect())
}

const MAIN: &str = "#include <stdio.h>\ndouble etalon_field(const double *, double *);\nint main(void) { double q[3], c[3];\n\
    while (scanf(\"%lf %lf %lf\", q, q + 1, q + 2) == 3) { double s = etalon_field(q, c);\n\
    printf(\"%.17g %.17g %.17g %.17g\\n\", c[0], c[1], c[2], s); } return 0; }\n";

#[test]
fn the_code_of_a_field_is_its_definition() {
    let mut noise = Noise::new(45, 3);
    let field = drawn(&mut noise);
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in field_code(&field, None).unwrap() {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    // in the range, in its border, and beyond
    let poses: Vec<Vec<f64>> =
        (0..1000).map(|_| [110.0, 400.0, 130.0].map(|size| noise.uniform(size)).to_vec()).collect();
    let line = |q: &Vec<f64>| format!("{:?} {:?} {:?}\n", q[0], q[1], q[2]);
    let input: String = poses.iter().map(line).collect();
    let expected: Vec<Vec<f64>> = poses.iter().map(|q| by_definition(&field, q)).collect();
    let shares = |of: fn(f64) -> bool| expected.iter().filter(|row| of(row[3])).count();
    assert!(shares(|s| s == 1.0) > 100 && shares(|s| s == 0.0) > 100 && shares(|s| s > 0.0 && s < 1.0) > 100);

    let python = "import sys, etalon_field as f\n\
        for line in sys.stdin:\n    q = [float(v) for v in line.split()]\n    print(*f.corrected(q), f.share(q))\n";
    let interpreter =
        PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap()).join("../../tests/support/structured_text.py");
    let mut by_python = Command::new("python3");
    by_python.args(["-B", "-c", python]);
    let mut by_interpreter = Command::new("python3");
    by_interpreter.arg("-B").arg(interpreter).args(["etalon_field.st", "FB_EtalonField"]);
    std::fs::write(folder.path().join("main.c"), MAIN).unwrap();
    let mut cc = Command::new("cc");
    cc.args(["-std=c99", "-Wall", "-Werror", "-ffp-contract=off", "-o", "field", "main.c", "etalon_field.c", "-lm"]);
    match cc.current_dir(folder.path()).status() {
        Ok(status) => assert!(status.success()),
        Err(_) => return skipped("cc"),
    }
    let by_c = Command::new(folder.path().join("field"));
    for (language, mut program) in [("Python", by_python), ("Structured Text", by_interpreter), ("C", by_c)] {
        let Some(found) = lines(program.current_dir(folder.path()), &input) else { return skipped("python3") };
        assert_eq!(found.len(), expected.len(), "{language}");
        let apart = found.iter().zip(&expected).map(|(a, b)| {
            assert_eq!(a.len(), b.len(), "{language}");
            a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        });
        let apart = apart.fold(0.0, f64::max);
        // rounding of 400 mm
        assert!(apart < 1e-12, "{language}: {apart:e}");
    }
}

#[test]
fn code_of_a_synthetic_field_says_so() {
    let measured = drawn(&mut Noise::new(45, 3));
    let synthetic = FieldDocument { synthetic: Some("drawn */ *) \nwith seed 7".to_owned()), ..measured.clone() };
    for (field, expected) in [(measured, 0), (synthetic, 1)] {
        for (name, bytes) in field_code(&field, None).unwrap() {
            let text = String::from_utf8(bytes).unwrap();
            let head: String = text.lines().take(4).collect();
            assert_eq!(
                head.matches("SYNTHETIC DATA, not of a measured robot: drawn").count(),
                expected,
                "{name}: {text}"
            );
        }
    }
}
