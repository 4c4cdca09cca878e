//! Commanded coordinates are refused as measurements, by name, and measured ones of a good robot are not.

use super::program;
use etalon::base::noise::Noise;
use std::fmt::Write;

#[test]
fn coordinates_that_the_nominal_robot_computes_are_no_measurements() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    assert_eq!(program(at, &["init", "c", "--robot", "ur5e"]).0, Some(0));
    let arm = etalon::campaign::read_robot(&at.join("c/robot.toml")).unwrap().build(&["tcp".to_owned()]).unwrap();
    let values = arm.nominal();
    let joints: Vec<String> = (1..=6).map(|i| format!("q{i}_deg = \"J{i}\"")).collect();
    let run = |digits: i32, noise_mm: f64, synthetic: &str| {
        let mut noise = Noise::new(3, 0);
        let mut text = "J1,J2,J3,J4,J5,J6,X,Y,Z\n".to_owned();
        for _ in 0..40 {
            let q: Vec<f64> = (0..6).map(|_| (noise.uniform(80.0) * 1e4).round() / 1e4).collect();
            let rad: Vec<f64> = q.iter().map(|v| v.to_radians()).collect();
            let step = 10f64.powi(-digits);
            let p = arm.position(&values, &rad, 0).map(|v| ((v + noise.gaussian(noise_mm)) / step).round() * step);
            let cells: Vec<String> = q.iter().map(f64::to_string).chain(p.map(|v| format!("{v:.6}"))).collect();
            let _ = writeln!(text, "{}", cells.join(","));
        }
        std::fs::write(at.join("c/all.csv"), text).unwrap();
        let campaign = format!(
            "name = \"c\"\nrobot = \"robot.toml\"\n{synthetic}[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 50\ncoverage_factor = 2\n\
             [[export]]\nfile = \"all.csv\"\nunit = \"mm\"\ntarget = \"tcp\"\n\
             format = {{ delimiter = \",\", header = 1, columns = {{ x = \"X\", y = \"Y\", z = \"Z\" }} }}\njoints = {{ {} }}\n\
             [frame.world]\nas_exported = true\n[identify]\ncalibration = \"all\"\n",
            joints.join(", ")
        );
        std::fs::write(at.join("c/campaign.toml"), campaign).unwrap();
        program(at, &["run", "c"])
    };
    let part = "[coordinates-commanded]";
    for digits in [1, 3, 6] {
        let (code, said) = run(digits, 0.0, "");
        assert!(code == Some(1) && said.contains(part) && said.contains("`tcp`"), "{digits}: {code:?} {said}");
    }
    // a robot that is as good as its drawing, as an instrument measures it, and data that state what they are
    for (digits, noise_mm, synthetic) in [(3, 0.01, ""), (1, 0.1, ""), (4, 0.0, "synthetic = \"computed\"\n")] {
        let (_, said) = run(digits, noise_mm, synthetic);
        assert!(!said.contains(part), "{digits} {noise_mm}: {said}");
    }
}
