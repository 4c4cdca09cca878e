//! Messages of functions that programs call with values in memory: commands check these values before.

use super::ran;
use etalon::base::message::{Message, Problems};
use etalon::documents::{FieldDocument, Iso9283Places, ParametersDocument};
use etalon::fit::{Element, FitSettings, Probe, Side, Source, element, rigid};
use etalon::formats::table::Values;
use etalon::identify::geometric::{self, BaseMeasurements, LeadMeasurements, Measurements, ShaftMeasurements};
use etalon::identify::{Comparison, IdentifiedParameters, Misfit, Observation, Settings, ToolFrame, ToolPoint};
use etalon::robots::{Prexyt, Robot};
use etalon::standards::iso9283::load::{Loaded, compliance};
use etalon::standards::iso9283::motion::standstill::{Stillness, standstills};
use etalon::standards::iso9283::motion::stream::Stream;
use etalon::standards::iso9283::path::accuracy::{path_accuracy, path_accuracy_on_reorientation};
use etalon::standards::iso9283::path::commanded::{CommandedPath, Corner};
use etalon::standards::iso9283::path::cornering::cornering;
use etalon::standards::iso9283::path::passes::passes;
use etalon::standards::iso9283::path::repeatability::path_repeatability;
use etalon::standards::iso9283::path::velocity::path_velocity;
use etalon::standards::iso9283::path::weaving::{Weave, weaving};
use etalon::standards::iso9283::pose::coplanarity::coplanarity;
use etalon::standards::iso9283::pose::distance::distance;
use etalon::standards::iso9283::pose::ellipsoid::ellipsoid;
use etalon::standards::iso9283::pose::exchangeability::exchangeability;
use etalon::standards::iso9283::pose::noise_free::without_noise;
use polars::prelude::Column;

const O: [f64; 3] = [0.0; 3];
const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const FAR: [f64; 3] = [100.0, 0.0, 0.0];

/// A field of a robot, and its inconsistency.
#[test]
fn of_residual_fields() {
    let field = |robot: &str, covariance: &str| -> FieldDocument {
        let text = format!(
            "{{\"schema\": \"etalon/field/1\", \"robot\": \"{robot}\", \"parameters_sha256\": \"\", \"joints\": [], \"components\": [], \
             \"parameters\": [], \"covariance\": {covariance}, \"covariance_of\": [], \"factor\": 1, \"noise_mm\": 0.02, \
             \"provenance\": {{\"version\": \"0.1.0\", \"inputs\": {{}}, \"seed\": null}}}}"
        );
        serde_json::from_str(&text).unwrap()
    };
    let robot = Prexyt::default();
    let refused = |robot_named: &str, covariance: &str| vec![field(robot_named, covariance).field(&robot).unwrap_err()];
    assert!(field(robot.model(), "[]").field(&robot).is_ok());
    hold(vec![
        ("field-of-other-robot", refused("serial", "[]")),
        ("field-inconsistent", refused(robot.model(), "[[1]]")),
    ]);
}

#[test]
fn of_files_names_and_missing_data() {
    let unknown = etalon::tasks::parse_options::<etalon::tasks::PlanOptions>(r#"{"nothing": 1}"#).unwrap_err();
    let large = tempfile::NamedTempFile::new().unwrap();
    large.as_file().set_len(17 << 20).unwrap();
    let robot = etalon::robots::Prexyt::default();
    let unreached = etalon::identify::plan::candidates::within_limits(&robot, Vec::new());
    let unreached = unreached.err().map(|error| error.messages()).unwrap_or_default();
    let nothing = etalon::identify::identify(&robot, &[], &etalon::identify::Settings::default()).unwrap_err();
    hold(vec![
        ("not-utf8", of(etalon::base::files::text("campaign.toml".as_ref(), vec![b'a', 0xfc]))),
        ("pose-name-too-long", of(etalon::base::pose_name::PoseName::new(&"x".repeat(300)))),
        ("one-campaign", of(etalon::compare::compare(&[]))),
        ("no-candidates", unreached),
        ("no-observations", nothing.messages()),
        ("option-of-call-refused", unknown.0),
        ("cannot-read-file", of(etalon::base::files::read("no/such/file".as_ref()))),
        ("file-too-large", of(etalon::base::files::read_text(large.path()))),
    ]);
}

/// The messages of a failure.
fn of<T>(result: Result<T, impl Into<Problems>>) -> Vec<Message> {
    result.err().map(Into::into).unwrap_or_default().0
}

/// The only message of these has the id.
fn hold(cases: Vec<(&str, Vec<Message>)>) {
    for (id, messages) in cases {
        assert!(messages.len() == 1 && messages[0].is(id, &[]), "{id}: {messages:?}");
    }
}

#[test]
fn of_elements_and_transforms() {
    let points = [O, X, Y, [1.0, 1.0, 0.1]];
    let fit = |kind, settings: &FitSettings| of(element(kind, Source::from(&points[..]), settings));
    let plain = FitSettings::default();
    let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let mirrored = corners.map(|corner| corner.map(|v| -v));
    hold(vec![
        ("held-axis-unsupported", fit(Element::Sphere, &FitSettings { axis: Some(X), ..plain })),
        ("held-axis-zero", fit(Element::Plane, &FitSettings { axis: Some(O), ..plain })),
        ("held-radius-not-positive", fit(Element::Sphere, &FitSettings { radius_mm: Some(0.0), ..plain })),
        ("held-radius-unsupported", fit(Element::Plane, &FitSettings { radius_mm: Some(10.0), ..plain })),
        ("weights-unusable", fit(Element::Plane, &FitSettings { weights: Some(&[1.0, 0.0, 1.0, 1.0]), ..plain })),
        ("point-counts-differ", of(rigid(&points, &points[..3]))),
        ("rotation-ambiguous", of(rigid(&corners, &mirrored))),
    ]);
}

#[test]
fn of_characteristics_of_poses() {
    let loaded = |force_n| Loaded { force_n, position_mm: X, unloaded_mm: O };
    hold(vec![
        ("force-not-positive", of(compliance(&[loaded(-50.0)], X))),
        ("distance-counts-differ", of(distance(&[O; 30], &[X; 29], [O, X]))),
        ("robots-at-other-poses", of(exchangeability(&[vec![vec![O; 3]; 5], vec![vec![O; 3]; 4]]))),
        ("visits-read-once", of(without_noise(&[vec![O], vec![X], vec![Y]]))),
        ("too-few-positions", of(ellipsoid(&[O]))),
        ("position-not-finite", of(ellipsoid(&[O, [f64::NAN, 0.0, 0.0], X, Y]))),
        ("too-few-of", of(coplanarity(&[vec![O], vec![X]]))),
    ]);
}

#[test]
fn of_characteristics_of_paths() {
    let time_s: Vec<f64> = (0..101).map(|i| 0.01 * f64::from(i)).collect();
    let straight: Vec<[f64; 3]> = (0..101).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    let stream = Stream::new(time_s, straight, &[]).ok().unwrap();
    let path = CommandedPath::new(vec![O, FAR], &[]).unwrap();
    let points = path.command_points(10);
    let driven = passes(&stream, &points, 5.0).unwrap().complete;
    let still = |radius_mm, duration_s| of(standstills(&stream, &Stillness { radius_mm, duration_s }));
    // both legs end before the next point of the path
    let corner = Corner { position_mm: O, incoming: X, outgoing: Y, along_mm: [1.0, 2.0, 3.0] };
    let weave = |stroke_mm, frequency_hz| Weave { stroke_mm, frequency_hz, across: Y };
    hold(vec![
        ("standstill-thresholds", still(0.0, 0.2)),
        ("passes-need-points", of(passes(&stream, &points, 0.0))),
        ("commanded-angle-missing", of(CommandedPath::new(vec![O, FAR], &[vec![0.0, f64::NAN]]))),
        ("path-without-reorientation", of(path_accuracy_on_reorientation(&driven, &points, &path))),
        ("passes-of-other-path", of(path_accuracy(&driven, &path.command_points(50)))),
        ("too-few-passes", of(path_repeatability(&driven, &points))),
        ("corner-without-points", of(cornering(&stream, &driven, &points, &corner, None))),
        ("velocity-not-positive", of(path_velocity(&driven, &points, 0.0, 0.5))),
        ("velocity-too-few-points", of(path_velocity(&driven, &points, 100.0, 0.1))),
        ("weave-command", of(weaving(&stream, 0..101, X, &weave(10.0, 0.0)))),
        ("weave-without-samples", of(weaving(&stream, 101..101, X, &weave(10.0, 1.0)))),
        ("weave-too-few-turns", of(weaving(&stream, 0..101, X, &weave(10.0, 1.0)))),
    ]);
}

#[test]
fn of_samples_probes_and_transforms() {
    let unusable = Stream::new(vec![0.0, 1.0], vec![O, [f64::NAN, 0.0, 0.0]], &[]).err().unwrap();
    let sphere =
        [X, [-1.0, 0.0, 0.0], Y, [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]].map(|p| p.map(|v| 10.0 * v));
    let probe = Some(Probe { radius_mm: 2.0, side: Side::Outside });
    let fit = element(Element::Sphere, Source::from(&sphere[..]), &FitSettings { probe, ..FitSettings::default() });
    let exchanged = rigid(&[O, FAR, [0.0, 100.0, 0.0]], &[O, FAR, [0.0, 130.0, 0.0]]).unwrap();
    let places = Iso9283Places {
        name: "P".to_owned(),
        purpose: String::new(),
        points: vec![[("x_mm".to_owned(), f64::NAN)].into()],
        joints: Vec::new(),
    };
    hold(vec![
        ("stream-value-missing", vec![unusable.message]),
        ("compensated-twice", of(fit.unwrap().compensated(probe))),
        ("rotation-uncertain", exchanged.warnings),
        ("targets-not-finite", of(etalon::controllers::places(&places, "p.json"))),
    ]);
}

/// Balls R and N and the rails of a table in the plane z = 0, with ball N on an arc about the origin.
fn base() -> BaseMeasurements {
    let arc = [0.0, 0.4, 0.8, 1.2, 1.6].map(|a: f64| [50.0 * a.cos(), 50.0 * a.sin(), 0.0]);
    BaseMeasurements {
        rails: vec![O, FAR, [0.0, 100.0, 0.0], [100.0, 100.0, 0.0]],
        towards: FAR,
        arc: arc.to_vec(),
        r_home: vec![O],
        r_end: vec![[0.0, 100.0, 0.0]],
    }
}

#[test]
fn of_the_geometric_method() {
    let steps = |measured: Measurements| of(geometric::steps(&measured, 0.001));
    let shaft = |direction: usize| -> Vec<[f64; 3]> {
        let ring = |i: usize| {
            let (sin, cos) = (0.7 * i as f64).sin_cos();
            let mut p = [200.0 + 10.0 * cos, 150.0 + 10.0 * cos, 10.0 * sin];
            p[direction] = 100.0 + 3.0 * i as f64;
            p
        };
        (0..30).map(ring).collect()
    };
    let shafts = |positions| vec![ShaftMeasurements { positions }];
    let still = LeadMeasurements { commanded_mm: vec![5.0; 3], points: vec![O, O, O] };
    hold(vec![
        ("lead-undetermined", steps(Measurements { leads: [Some(still), None, None], ..Measurements::default() })),
        (
            "ball-unmoved",
            steps(Measurements { base: BaseMeasurements { r_end: vec![O], ..base() }, ..Measurements::default() }),
        ),
        (
            "geometric-step-alone",
            steps(Measurements { shafts: shafts([shaft(0), shaft(1)]), ..Measurements::default() }),
        ),
        (
            "shaft-positions-parallel",
            steps(Measurements { base: base(), shafts: shafts([shaft(0), shaft(0)]), ..Measurements::default() }),
        ),
        ("geometry-incomplete", of(geometric::determine(&Measurements::default(), 0.001))),
    ]);
    assert!(
        steps(Measurements { base: base(), shafts: shafts([shaft(0), shaft(1)]), ..Measurements::default() })
            .is_empty()
    );
}

/// Messages of an error of the identification.
fn refused<T>(result: Result<T, etalon::identify::Error>) -> Vec<Message> {
    result.err().map(|error| error.messages()).unwrap_or_default()
}

#[test]
fn of_given_parameters_and_tools() {
    let robot = Prexyt::default();
    let observed =
        |joints: [f64; 3]| Observation { joints: joints.to_vec(), targets: vec![Some(O); 2], ..Observation::default() };
    let (near, nowhere) = ([observed([10.0, 150.0, 150.0])], [observed([10.0, f64::NAN, 0.0])]);
    let plain = Settings::default();
    let settings = Settings { standard_uncertainty_mm: Some(0.01), ..Settings::default() };
    let given =
        IdentifiedParameters { values: robot.nominal(), free: vec![0, 1], covariance: vec![1.0, 2.0, 2.0, 1.0] };
    let sound = IdentifiedParameters { covariance: vec![1.0, 0.0, 0.0, 1.0], ..given.clone() };
    let compare = |observations, settings, given| {
        let misfit = &Misfit::default();
        refused(Comparison { robot: &robot, observations, settings, given, misfit }.most_probable())
    };
    let tool = |frame| {
        let point = ToolPoint { point_mm: X, frame, standard_uncertainty_mm: 0.01 };
        refused(point.in_base(&robot, &robot.nominal(), &[10.0, 150.0, 150.0]))
    };
    let common = Settings { common_uncertainty_mm: Some(0.01), ..Settings::default() };
    hold(vec![
        ("comparison-without-uncertainty", compare(&near, &plain, &sound)),
        ("covariance-not-positive-definite", compare(&near, &settings, &given)),
        ("robot-not-at-joints", compare(&nowhere, &settings, &sound)),
        ("tool-part-missing", tool(ToolFrame::Flange)),
        ("common-uncertainty-alone", refused(etalon::identify::identify(&robot, &near, &common))),
    ]);
    assert!(tool(ToolFrame::Platform).is_empty() && compare(&near, &settings, &sound).is_empty());
}

/// A robot of a program's own, which has no inverse kinematics.
struct Forward(Prexyt);

impl Robot for Forward {
    fn definition(&self) -> &etalon::robots::Definition {
        self.0.definition()
    }
    fn definition_mut(&mut self) -> &mut etalon::robots::Definition {
        self.0.definition_mut()
    }
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        self.0.positions(parameters, joints, out);
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        self.0.jacobian(parameters, joints, out);
    }
    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        self.0.joint_jacobian(parameters, joints, out);
    }
}

#[test]
fn of_robots_and_tables_of_programs() {
    let robot = Forward(Prexyt::default());
    let point = ToolPoint { point_mm: X, frame: ToolFrame::Targets, standard_uncertainty_mm: 0.01 };
    let joints = [10.0, 150.0, 150.0];
    // targets K and L at one place
    let mut parameters = robot.nominal();
    parameters[robot.index("l_kl").unwrap()] = 0.0;
    let uneven = vec![Column::new("a".into(), [1.0]), Column::new("b".into(), [1.0, 2.0])];
    hold(vec![
        ("no-whole-pose", of(etalon::tasks::whole_pose(&robot).map(|_| ()))),
        ("tool-targets-collinear", refused(point.in_base(&robot, &parameters, &joints))),
        ("table-failed", of(etalon::formats::parquet::frame(2, uneven))),
    ]);
    assert!(refused(point.in_base(&robot, &robot.nominal(), &joints)).is_empty());
}

#[test]
fn of_stored_errors_and_parameters() {
    let out = ran("prexyt-cmm").join("out");
    let stored = std::fs::read(out.join("residuals.parquet")).unwrap();
    // 59 poses, five repeats
    let stored = etalon::formats::parquet::from_parquet(stored, 295).unwrap();
    let with = |column: &str, word: &str| {
        let mut table = stored.clone();
        table.set(column, Values::Texts(vec![Some(word.to_owned()); stored.height()]));
        of(etalon::stages::evaluate::error_table::from_table(&table))
    };
    let mut document: ParametersDocument = crate::support::document(&out.join("parameters.json"));
    let given = |document: &ParametersDocument| {
        of(etalon::stages::verify::earlier_parameters::parameters_from_document(&Prexyt::default(), document))
    };
    assert!(given(&document).is_empty() && with("set", "validation").is_empty());
    document.covariance.clear();
    hold(vec![
        ("pose-set-unknown", with("set", "control")),
        ("error-quantity-unknown", with("quantity", "velocity")),
        ("given-without-covariance", given(&document)),
    ]);
}
