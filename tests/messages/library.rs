//! Messages of functions that programs call with values in memory: commands check these values before.

use etalon::base::message::{Message, Problems};
use etalon::fit::{Element, FitSettings, Source, element, rigid};
use etalon::standards::iso9283::load::{Loaded, compliance};
use etalon::standards::iso9283::motion::standstill::{Stillness, standstills};
use etalon::standards::iso9283::motion::stream::Stream;
use etalon::standards::iso9283::path::accuracy::{path_accuracy, path_accuracy_on_reorientation};
use etalon::standards::iso9283::path::commanded::CommandedPath;
use etalon::standards::iso9283::path::passes::passes;
use etalon::standards::iso9283::path::repeatability::path_repeatability;
use etalon::standards::iso9283::path::velocity::path_velocity;
use etalon::standards::iso9283::path::weaving::{Weave, weaving};
use etalon::standards::iso9283::pose::coplanarity::coplanarity;
use etalon::standards::iso9283::pose::distance::distance;
use etalon::standards::iso9283::pose::ellipsoid::ellipsoid;
use etalon::standards::iso9283::pose::exchangeability::exchangeability;
use etalon::standards::iso9283::pose::noise_free::without_noise;

const O: [f64; 3] = [0.0; 3];
const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const FAR: [f64; 3] = [100.0, 0.0, 0.0];

#[test]
fn of_files_names_and_missing_data() {
    let refused = etalon::cli::in_memory::iso9283([None, None, None], &[]).unwrap_err();
    let robot = etalon::robots::Prexyt::default();
    let nothing = etalon::identify::identify(&robot, &[], &etalon::identify::Settings::default()).unwrap_err();
    hold(vec![
        ("not-utf8", of(etalon::base::files::text("campaign.toml".as_ref(), vec![b'a', 0xfc]))),
        ("pose-name-too-long", of(etalon::base::pose_name::PoseName::new(&"x".repeat(300)))),
        ("one-campaign", of(etalon::compare::compare(&[]))),
        ("table-to-evaluate-missing", refused.downcast::<Problems>().unwrap().0),
        ("no-observations", nothing.messages()),
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
    let weave = |stroke_mm, frequency_hz| Weave { stroke_mm, frequency_hz, across: Y };
    hold(vec![
        ("standstill-thresholds", still(0.0, 0.2)),
        ("passes-need-points", of(passes(&stream, &points, 0.0))),
        ("commanded-angle-missing", of(CommandedPath::new(vec![O, FAR], &[vec![0.0, f64::NAN]]))),
        ("path-without-reorientation", of(path_accuracy_on_reorientation(&driven, &points, &path))),
        ("passes-of-other-path", of(path_accuracy(&driven, &path.command_points(50)))),
        ("too-few-passes", of(path_repeatability(&driven, &points))),
        ("velocity-not-positive", of(path_velocity(&driven, &points, 0.0, 0.5))),
        ("velocity-too-few-points", of(path_velocity(&driven, &points, 100.0, 0.1))),
        ("weave-command", of(weaving(&stream, 0..101, X, &weave(10.0, 0.0)))),
        ("weave-without-samples", of(weaving(&stream, 101..101, X, &weave(10.0, 1.0)))),
        ("weave-too-few-turns", of(weaving(&stream, 0..101, X, &weave(10.0, 1.0)))),
    ]);
}
