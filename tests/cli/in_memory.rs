//! Commands on robots and tables in memory.

use etalon::tasks::{self, IdentifyOptions, Inputs, PlanOptions, Prediction, Table, parse_options};

/// The robot.toml of an arm of three joints, and synthetic observations of its target.
fn three_axes() -> (String, String) {
    let text = "model = \"serial\"\n\
        [[joint]]\nalpha_deg = 0\na_mm = 0\ntheta_deg = 0\nd_mm = 300\n\
        [[joint]]\nalpha_deg = -90\na_mm = 50\ntheta_deg = 0\nd_mm = 0\n\
        [[joint]]\nalpha_deg = 40\na_mm = 250\ntheta_deg = 0\nd_mm = 120\n";
    let robot = etalon::campaign::parse_robot("robot.toml".as_ref(), text).unwrap().build(&["SMR".to_owned()]).unwrap();
    let mut truth = robot.nominal();
    for (name, at) in [("SMR_x", 80.0), ("SMR_y", -15.0), ("SMR_z", 25.0)] {
        truth[robot.index(name).unwrap()] = at;
    }
    let mut table = "pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm\n".to_owned();
    for i in 0..40 {
        let q = [0.7, 1.1, 1.7].map(|step: f64| 100.0 * (step * f64::from(i)).sin());
        let [x, y, z] = robot.position(&truth, &q.map(f64::to_radians), 0);
        // an error of the readings, without which there is no covariance
        let noise = [3.1, 4.7, 5.9].map(|step: f64| 0.02 * (step * f64::from(i)).sin());
        let [x, y, z] = [x + noise[0], y + noise[1], z + noise[2]];
        table += &format!("{i},1,SMR,{},{},{},{x},{y},{z}\n", q[0], q[1], q[2]);
    }
    (text.to_owned(), table)
}

#[test]
fn a_predicted_position_has_the_covariance_of_its_parameters() {
    let (text, table) = three_axes();
    let file = etalon::campaign::parse_robot("robot.toml".as_ref(), &text).unwrap();
    let given = Inputs {
        robot: &file,
        stated: Table::Text { name: "robot.toml", text: &text },
        table: Table::Text { name: "observations", text: &table },
    };
    let options = IdentifyOptions { standard_uncertainty_um: Some(15.0), ..IdentifyOptions::default() };
    let document = tasks::identify(&given, &options).unwrap().document;
    let prediction = Prediction::new(&file, &document, "SMR").unwrap();
    let joints = [0.3, -0.4, 0.9];
    let found = prediction.at(&joints);
    // numeric derivatives with respect to the identified parameters, in the units of the document
    let robot = prediction.robot();
    let mut values = robot.nominal();
    for entry in &document.parameters {
        let i = robot.index(&entry.name).unwrap();
        values[i] = robot.parameters()[i].quantity.inward(entry.value);
    }
    let position = robot.position(&values, &joints, 0);
    let derivative = |name: &String| {
        let i = robot.index(name).unwrap();
        let step = robot.parameters()[i].quantity.inward(1e-3);
        let at = |by: f64| {
            let mut values = values.clone();
            values[i] += by;
            robot.position(&values, &joints, 0)
        };
        let [more, less] = [at(step), at(-step)];
        std::array::from_fn::<f64, 3, _>(|c| (more[c] - less[c]) / 2e-3)
    };
    let columns: Vec<[f64; 3]> = document.identified().map(|entry| derivative(&entry.name)).collect();
    let covariance = |i: usize, j: usize| -> f64 {
        let terms = columns.iter().zip(&document.covariance);
        terms.flat_map(|(a, row)| columns.iter().zip(row).map(move |(b, c)| a[i] * c * b[j])).sum()
    };
    for (i, position) in position.iter().enumerate() {
        assert!((found.position_mm[i] - position).abs() < 1e-9, "{found:?}");
        assert!(found.covariance_mm2[i][i] > 1e-6, "{found:?}");
        for j in 0..3 {
            let (ours, expected) = (found.covariance_mm2[i][j], covariance(i, j));
            assert!((ours - expected).abs() < 1e-4 * covariance(i, i), "{i} {j}: {ours} {expected}");
        }
    }
    assert!(Prediction::new(&file, &document, "other").is_err(), "a target without an identified position");
}

#[test]
fn candidates_in_memory_have_commas_and_points_beside_files_with_other_marks() {
    let (text, table) = three_axes();
    let file = etalon::campaign::parse_robot("robot.toml".as_ref(), &text).unwrap();
    let comma = table.replace(',', ";").replace('.', ",");
    let plan = |table: &str, options: &str| {
        let (stated, table) =
            (Table::Text { name: "robot.toml", text: &text }, Table::Text { name: "candidates", text: table });
        let options: PlanOptions = parse_options(options).unwrap();
        tasks::plan(&Inputs { robot: &file, stated, table }, &options, &|_, _| {})
    };
    let twelve = r#"{"positions": 12, "starts": 1}"#;
    let marks = r#"{"positions": 12, "starts": 1, "delimiter": ";", "decimal": ","}"#;
    let [first, second] = [plan(&table, twelve), plan(&table, marks)].map(|plan| plan.unwrap());
    assert_eq!(first.optimality.value, second.optimality.value);
    assert!(plan(&comma, twelve).is_err());
}

/// A target at the flange's origin does not show the zero of the last joint; where it is stated, the plan counts with it.
#[test]
fn a_plan_counts_with_the_stated_position_of_a_target() {
    let (text, table) = three_axes();
    let file = etalon::campaign::parse_robot("robot.toml".as_ref(), &text).unwrap();
    let position = ("SMR".to_owned(), vec![80.0, -15.0, 25.0]);
    let stated = file.text_with_targets(&[position].into()).unwrap();
    let identifiable = |text: &str| {
        let file = etalon::campaign::parse_robot("robot.toml".as_ref(), text).unwrap();
        let (stated, table) =
            (Table::Text { name: "robot.toml", text }, Table::Text { name: "candidates", text: &table });
        let options = parse_options(r#"{"positions": 12, "starts": 1, "hold": ["SMR_*"]}"#).unwrap();
        let plan = tasks::plan(&Inputs { robot: &file, stated, table }, &options, &|_, _| {}).unwrap();
        plan.prediction.parameters.iter().find(|p| p.name == "theta_3").unwrap().identifiable
    };
    assert_eq!([&text, &stated].map(|text| identifiable(text)), [false, true]);
}
