//! The error that the controller will make at the tool point is another one than that of the targets, and its prediction holds.

use crate::support::arms::{SIX_AXES, serial};
use crate::support::five_bar::settings;
use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::base::noise::Noise;
use etalon::base::pose::norm;
use etalon::campaign::Campaign;
use etalon::identify::{
    Identification, Observation, Settings, ToolFrame, ToolPoint, ToolPrediction, UncertaintyFrom, held, identify,
};
use etalon::robots::{PlanarPose, Platform, Prexyt, Robot, Role};
use etalon::run::pipeline;

/// Table 3.1, in the order of the model; the balls are 146 mm apart.
fn table_3_1(lengths: [f64; 6], beta_deg: f64) -> Vec<f64> {
    let [s, d3, d, x_c, y_c, x_o] = lengths;
    let y_o = if lengths == ACTUAL {
        -30.052
    } else if lengths == SET_2 {
        -30.054
    } else {
        -30.061
    };
    let angles = [beta_deg, -1.523, -0.954].map(f64::to_radians);
    [&angles[..], &[s, d3, d, x_c, y_c, x_o, y_o, 0.986, 0.994, 0.976, 146.0]].concat()
}

const ACTUAL: [f64; 6] = [393.564, 0.648, 120.473, 73.513, -72.822, 23.246];
const SET_2: [f64; 6] = [393.546, 0.647, 120.353, 73.398, -72.824, 23.254];
const SET_2_2: [f64; 6] = [393.537, 0.648, 120.119, 73.166, -72.826, 23.256];

/// A thousand positions evenly on a disc of 170 mm, each at 0 and ±15 degrees.
fn workspace() -> impl Iterator<Item = PlanarPose> {
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    (0..1000).flat_map(move |i| {
        let (radius, angle) = (85.0 * ((f64::from(i) + 0.5) / 1000.0).sqrt(), f64::from(i) * golden);
        [-15.0, 0.0, 15.0f64].map(|theta| PlanarPose {
            x_mm: 201.0 + radius * angle.cos(),
            y_mm: 137.5 + radius * angle.sin(),
            theta_rad: theta.to_radians(),
        })
    })
}

/// Largest and root mean square, in micrometres.
fn summary(sizes_mm: &[f64]) -> [f64; 2] {
    let mean = sizes_mm.iter().map(|v| v * v).sum::<f64>() / sizes_mm.len() as f64;
    [1e3 * sizes_mm.iter().copied().fold(0.0, f64::max), 1e3 * mean.sqrt()]
}

#[test]
fn table_3_2_is_the_error_of_the_true_centre_in_the_base_frame() {
    let robot = Prexyt::default();
    let truth = table_3_1(ACTUAL, 1.204);
    let centre = ToolPoint::centre(&robot).unwrap();
    // printed maximum and root mean square; what the balls measure, by the notes on the thesis
    for (lengths, beta_deg, printed, by_balls) in
        [(SET_2, 1.204, [125.5, 123.2], [4.0, 3.1]), (SET_2_2, 1.203, [369.2, 362.4], [15.3, 13.0])]
    {
        let identified = table_3_1(lengths, beta_deg);
        let (mut at_tool, mut measured) = (Vec::new(), Vec::new());
        for command in workspace() {
            let joints = robot.joints_at(&identified, command);
            let place = |values: &[f64]| centre.in_base(&robot, values, &joints).unwrap();
            let (commanded, reached) = (place(&identified), place(&truth));
            assert!((commanded[0] - command.x_mm).hypot(commanded[1] - command.y_mm) < 1e-9);
            at_tool.push((reached[0] - commanded[0]).hypot(reached[1] - commanded[1]));
            let [k, l] = robot.balls(&truth, &[joints[0], joints[1], joints[2]]);
            let seen = robot.measured_pose(&identified, [k, l]);
            measured.push((seen.x_mm - command.x_mm).hypot(seen.y_mm - command.y_mm));
        }
        let ([max, rms], balls) = (summary(&at_tool), summary(&measured));
        println!(
            "at C {max:.1} and {rms:.1} µm (printed {printed:?}), as the balls measure it {balls:.1?} µm ({by_balls:?})"
        );
        // parameters are printed to 0.001 mm and 0.001 deg
        assert!((max - printed[0]).abs() < 1.5 && (rms - printed[1]).abs() < 1.5, "{max} {rms}");
        assert!((balls[0] - by_balls[0]).abs() < 0.1 && (balls[1] - by_balls[1]).abs() < 0.1, "{balls:?}");
    }
}

/// Simulated calibrations of a robot whose parameters are the truth.
struct Calibrations<'a> {
    robot: &'a dyn Robot,
    truth: &'a [f64],
    settings: Settings,
}

impl Calibrations<'_> {
    /// Root mean square of the actual errors of `point` at the joint values `at`, and of these over
    /// the predicted ones, of calibrations at `poses`.
    fn actual_over_predicted(&self, poses: &[Vec<f64>], at: &[Vec<f64>], point: ToolPoint) -> [f64; 2] {
        let Self { robot, truth, ref settings } = *self;
        let (mut actual, mut predicted, mut count) = (0.0, 0.0, 0.0);
        for seed in 0..60 {
            let mut noise = Noise::new(5, seed);
            let u_mm = settings.standard_uncertainty_mm.unwrap();
            let mut see = |(pose, joints): (usize, &Vec<f64>)| {
                let mut seen = |k: usize| {
                    let mut p = robot.position(truth, joints, k);
                    p[..robot.dimension()].iter_mut().for_each(|v| *v += noise.gaussian(u_mm));
                    Some(p)
                };
                let targets = (0..robot.targets().len()).map(&mut seen).collect();
                Observation {
                    pose: (pose as i64).into(),
                    cycle: 1,
                    joints: joints.clone(),
                    targets,
                    ..Observation::default()
                }
            };
            let observations: Vec<Observation> = poses.iter().enumerate().map(&mut see).collect();
            let found: Identification = identify(robot, &observations, settings).unwrap();
            let held = held(robot, &observations, settings, &found).unwrap();
            let prediction = ToolPrediction { robot, point, before: truth, found: &found, held };
            for joints in at {
                let there = Observation { joints: joints.clone(), ..observations[0].clone() };
                if found.uncertainty.from == UncertaintyFrom::Instrument {
                    let error = prediction.error(&there.joints).unwrap().unwrap();
                    actual += norm(error.before_mm).powi(2);
                    predicted += error.parameters_mm.powi(2);
                    predicted += error.held_mm.powi(2);
                    count += 1.0;
                }
            }
        }
        assert!(count > 50.0 * at.len() as f64, "{count}");
        [f64::sqrt(actual / count), f64::sqrt(actual / predicted)]
    }
}

#[test]
fn the_prediction_covers_parameters_that_cancel_in_what_the_balls_measure() {
    let robot = Prexyt::default();
    let truth = table_3_1(ACTUAL, 1.204);
    let pose = |x_mm: f64, y_mm: f64, theta_deg: f64| {
        robot.joints_at(&truth, PlanarPose { x_mm, y_mm, theta_rad: theta_deg.to_radians() })
    };
    let corners = [(130.0, 70.0), (270.0, 70.0), (130.0, 200.0), (270.0, 200.0)];
    let poses = |turns: &[f64]| -> Vec<Vec<f64>> {
        corners.iter().flat_map(|&(x, y)| turns.iter().map(move |&theta| pose(x, y, theta))).collect()
    };
    let at = [pose(201.0, 137.5, 0.0), pose(150.0, 160.0, 10.0), pose(250.0, 100.0, -15.0)];
    let centre = ToolPoint::centre(&robot).unwrap();
    let on_platform = ToolPoint { point_mm: [20.0, -35.0, 0.0], ..centre };
    let on_balls = ToolPoint { frame: ToolFrame::Targets, ..on_platform };
    let calibrations = Calibrations { robot: &robot, truth: &truth, settings: settings(0.005) };
    for point in [centre, on_platform, on_balls] {
        // small rotations hardly tell d and x_c apart
        let [actual_mm, ratio] = calibrations.actual_over_predicted(&poses(&[12.0, 3.0, -9.0]), &at, point);
        println!("{point:?}: {:.1} µm, {ratio:.3} of the prediction", 1e3 * actual_mm);
        assert!((ratio - 1.0).abs() < 0.25, "{point:?} {ratio}");
        assert!(point == on_balls || actual_mm > 0.05, "{actual_mm}");
        // two orientations do not: one stays at its nominal value, which is as good as its tolerance
        let [actual_mm, ratio] = calibrations.actual_over_predicted(&poses(&[12.0, -9.0]), &at, point);
        println!("two orientations: {:.1} µm, {ratio:.3} of the prediction", 1e3 * actual_mm);
        assert!(ratio > 0.2 && ratio < 2.0, "{point:?} {ratio}");
        assert!(point == on_balls || actual_mm > 3.0, "{actual_mm}");
    }
}

#[test]
fn the_prediction_holds_for_a_tool_on_the_flange_and_on_the_targets_of_an_arm() {
    let robot = serial(&SIX_AXES, &["t1", "t2", "t3"], &[]);
    let mut noise = Noise::new(8, 0);
    let mut truth = robot.nominal();
    for (value, p) in truth.iter_mut().zip(robot.parameters()) {
        let held = p.name.ends_with("_1") || p.name == "theta_6" || p.name == "d_6" || p.name.starts_with("gain");
        *value += if p.role == Role::Robot && !held { noise.gaussian(1e-3) } else { 0.0 };
    }
    truth[..6].copy_from_slice(&[1500.0, -300.0, 200.0, 0.2, -0.1, 2.0]);
    truth[6..15].copy_from_slice(&[60.0, 10.0, 30.0, -50.0, 70.0, 25.0, -40.0, -80.0, 45.0]);
    let mut draw =
        |count: usize| -> Vec<Vec<f64>> { (0..count).map(|_| (0..6).map(|_| noise.uniform(1.2)).collect()).collect() };
    let (poses, at) = (draw(30), draw(5));
    let hold = vec!["gain_*".to_owned()];
    for frame in [ToolFrame::Flange, ToolFrame::Targets] {
        let point = ToolPoint { point_mm: [30.0, -10.0, 150.0], frame, standard_uncertainty_mm: 0.0 };
        let settings = Settings { hold: hold.clone(), ..settings(0.02) };
        let calibrations = Calibrations { robot: &robot, truth: &truth, settings };
        let [actual_mm, ratio] = calibrations.actual_over_predicted(&poses, &at, point);
        println!("{frame:?}: {:.1} µm, {ratio:.3} of the prediction", 1e3 * actual_mm);
        assert!((ratio - 1.0).abs() < 0.15, "{frame:?} {ratio}");
    }
}

#[test]
fn every_accuracy_figure_of_a_campaign_names_its_point() {
    let run = |tool: &str| {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", "[identify]", &format!("{tool}\n[identify]"));
        let outcome = pipeline::run(&Campaign::read(&scratch.path()).unwrap())?;
        let page = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
        Ok::<_, etalon::base::message::Problems>((outcome.results.identified.unwrap().accuracy, page))
    };
    let (accuracy, page) = run("").unwrap();
    assert_eq!(accuracy.point.english(), "platform centre (from the balls)");
    for said in ["Errors of platform centre (from the balls) before → after", "At the tool point: 51 poses"] {
        assert!(page.replace("&#39;", "'").replace("&#x27;", "'").contains(said), "{said}");
    }
    // predicted errors stand beside measured ones on page one for a stated point alone
    let headline = "tool point, RMS: nominal minus identified";
    let apart =
        run("[tool]\npoint_mm = [40, 0, 0]\nframe = \"platform\"\nexpanded_uncertainty_um = 1\ncoverage_factor = 2\n")
            .unwrap()
            .1;
    assert!(apart.contains(headline) && !page.contains(headline));
    let at_c = accuracy.tool.unwrap();
    assert_eq!((at_c.set.name(), at_c.poses, at_c.model_mm, at_c.place_mm), ("validation", 51, 0.0, 0.0));
    // a place that is known to 50 µm adds the root of two coordinates of them
    let stated = |u_um: f64, frame: &str| {
        format!(
            "[tool]\npoint_mm = [0, 0, 0]\nframe = \"{frame}\"\nexpanded_uncertainty_um = {u_um:?}\ncoverage_factor = 2\n"
        )
    };
    let wider = run(&stated(100.0, "platform")).unwrap().0.tool.unwrap();
    assert!((wider.place_mm - 0.05 * 2f64.sqrt()).abs() < 1e-12, "{}", wider.place_mm);
    assert!((wider.after.max.powi(2) - at_c.after.max.powi(2) - wider.place_mm.powi(2)).abs() < 1e-12);
    let problems = run(&stated(10.0, "flange")).unwrap_err().to_string();
    assert!(
        problems.says("[tool-part-missing] model=prexyt part=flange") && problems.contains("campaign.toml"),
        "{problems}"
    );
    let problems = run(&stated(-1.0, "platform")).unwrap_err().to_string();
    assert!(problems.says("[key-not-positive] key=expanded_uncertainty_um"), "{problems}");
}
