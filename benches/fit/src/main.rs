//! Geometric fits beside engeom, Ceres and SciPy: the same points and the same start in the same run, one thread each.
//!
//! etalon and the circle, sphere and plane of engeom find their start themselves; the cylinder of engeom and all of Ceres and SciPy
//! are given one near the truth. Beside the peers stands one plain sum over the same points: what reading them costs.

mod points;

use engeom::geom3::Cylinder3;
use engeom::{Circle2, Plane3, Point2, Point3, Sphere3, UnitVec3, Vector3};
use etalon::fit::{self, Element, Fit, FitSettings};
use points::{Points, START_AXIS, START_CENTER, START_RADIUS};
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

fn main() {
    let threads = |n: usize| rayon::ThreadPoolBuilder::new().num_threads(n).build().expect("threads");
    let (one, two) = (threads(1), threads(2));
    let folder = tempfile::tempdir().expect("folder");
    println!(
        "etalon in ms; a peer's time and its ratio to etalon on one thread; how far answers differ (mm, or of a unit vector)"
    );
    for count in [100_000, 10_000_000] {
        let rounds = if count > 1_000_000 { 3 } else { 21 };
        for element in [Element::Plane, Element::Circle2d, Element::Sphere, Element::Cylinder] {
            let points = Points::on(element, count);
            let file = folder.path().join("points.f64");
            std::fs::write(&file, points.bytes()).expect("points");
            let mut times: [Vec<f64>; 5] = Default::default();
            let mut answers = None;
            peak_kb();
            let before = peak_kb();
            two.install(|| etalon(element, &points));
            let memory = peak_kb().zip(before).map(|(after, before)| after - before);
            for round in 0..rounds {
                times[0].push(seconds(|| black_box(plain_sum(points.flat()))).0);
                let (time, fit) = seconds(|| one.install(|| etalon(element, &points)));
                times[1].push(time);
                times[2].push(seconds(|| two.install(|| etalon(element, &points))).0);
                times[4].push(seconds(|| two.install(|| black_box(plain_sum_in_two(points.flat())))).0);
                if count < 1_000_000 || round == 0 {
                    let (time, answer) = seconds(|| engeom(element, &points));
                    times[3].push(time);
                    answers = Some((fit, answer));
                }
            }
            let Some((fit, theirs)) = answers else { continue };
            let [read, ours, twice, engeom, read_twice] = times.map(median);
            let passes = passes(&fit);
            println!(
                "\n{element}, {count} points: etalon {:.2} ms, {:.0} million points a second; two threads {:.2} times (plain sums \
                 {:.2} times); {passes} passes take {:.1} times as long as plain sums over the points",
                ours * 1e3,
                count as f64 / ours * 1e-6,
                ours / twice,
                read / read_twice,
                ours / (passes as f64 * read),
            );
            if let Some(kb) = memory {
                println!(
                    "  peak of memory grows by {:.1} MB in a fit, points {:.1} MB",
                    kb / 1024.0,
                    points.flat().len() as f64 * 8e-6
                );
            }
            let answer = answer(&fit);
            assert!(theirs.len() == answer.len() && theirs.iter().all(|x| x.is_finite()), "engeom answers {theirs:?}");
            report("engeom 0.5", Some((engeom, theirs)), ours, &answer);
            let runs = if count > 1_000_000 { "1" } else { "5" };
            let ceres = std::env::var("CERES_FIT").unwrap_or_default();
            if element != Element::Plane {
                report("Ceres", outside(&ceres, &[], element, &file, runs), ours, &answer);
            }
            let python = std::env::var("PYTHON").unwrap_or("python3".into());
            let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("scipy_fit.py");
            report("SciPy", outside(&python, &[&script.to_string_lossy()], element, &file, runs), ours, &answer);
        }
    }
}

fn seconds<T>(run: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = run();
    (start.elapsed().as_secs_f64(), result)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// What reading the points costs: their sum, in as many running sums as fill the registers.
fn plain_sum(values: &[f64]) -> f64 {
    let mut sums = [0.0; 24];
    for chunk in values.chunks_exact(24) {
        for (sum, x) in sums.iter_mut().zip(chunk) {
            *sum += x;
        }
    }
    sums.iter().sum()
}

/// The same on two threads: what a second one is worth to memory and cores, without any arithmetic to speak of.
fn plain_sum_in_two(values: &[f64]) -> f64 {
    let (first, second) = values.split_at(values.len() / 48 * 24);
    let (a, b) = rayon::join(|| plain_sum(first), || plain_sum(second));
    a + b
}

/// Peak of this process' memory since the last question, in kB, where the system tells it: asked twice, what it holds now.
fn peak_kb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.split_whitespace().next()?.parse().ok();
    std::fs::write("/proc/self/clear_refs", "5").ok()?;
    peak
}

fn etalon(element: Element, points: &Points) -> Fit {
    let fit = match points {
        Points::Plane(points) => fit::circle2d(points, &FitSettings::default()),
        Points::Space(points) => fit::element(element, points, &FitSettings::default()),
    };
    fit.expect("fit")
}

/// How often a fit reads the points: for each step, for residuals and coverage, and for centroid and spread, which circle and
/// sphere have from a sample.
fn passes(fit: &Fit) -> usize {
    let surveyed = !matches!(fit.element, Element::Circle2d | Element::Sphere);
    usize::from(surveyed) + fit.solver.iterations + 1
}

/// The numbers that a peer's answer is held against: direction, centre, radius, where there is one; of a cylinder's
/// point, which may slide, nothing.
fn answer(fit: &Fit) -> Vec<f64> {
    let centre = matches!(fit.element, Element::Circle2d | Element::Sphere);
    let [x, y, z] = fit.geometry.point_mm;
    let place = if fit.element == Element::Circle2d { vec![x, y] } else { vec![x, y, z] };
    let direction = fit.geometry.direction.into_iter().flatten();
    direction.chain(place.into_iter().filter(|_| centre)).chain(fit.geometry.radius_mm).collect()
}

fn engeom(element: Element, points: &Points) -> Vec<f64> {
    match points {
        Points::Plane(points) => {
            let points: Vec<Point2> = points.iter().map(|p| Point2::new(p[0], p[1])).collect();
            let circle = Circle2::from_fit(&points, None).expect("circle");
            vec![circle.x(), circle.y(), circle.r()]
        }
        Points::Space(points) => {
            let points: Vec<Point3> = points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
            let [x, y, z] = START_CENTER;
            let axis = UnitVec3::new_normalize(Vector3::from(START_AXIS));
            match element {
                Element::Plane => Plane3::from_fit(&points, None).expect("plane").normal.iter().copied().collect(),
                Element::Sphere => {
                    let sphere = Sphere3::from_fit(&points, None).expect("sphere");
                    vec![sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius]
                }
                _ => {
                    let guess = Cylinder3::new(Point3::new(x, y, z), axis, START_RADIUS, 100.0);
                    let cylinder = Cylinder3::from_fit(&points, &guess, None).expect("cylinder");
                    cylinder.direction.iter().copied().chain([cylinder.radius]).collect()
                }
            }
        }
    }
}

/// Runs a peer that answers with one line: seconds, and the numbers of [`answer`].
fn outside(program: &str, arguments: &[&str], element: Element, file: &Path, runs: &str) -> Option<(f64, Vec<f64>)> {
    let start = START_CENTER.iter().chain(&START_AXIS).chain([&START_RADIUS]).map(f64::to_string);
    let mut command = Command::new(program);
    command.args(arguments).args([element.name(), &file.to_string_lossy(), runs]).args(start);
    let output = command.env("OMP_NUM_THREADS", "1").env("OPENBLAS_NUM_THREADS", "1").output().ok()?;
    if !output.status.success() {
        eprintln!("{}", String::from_utf8_lossy(&output.stderr));
        return None;
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|w| w.parse().ok()).collect();
    numbers.split_first().map(|(seconds, answer)| (*seconds, answer.to_vec()))
}

fn report(name: &str, found: Option<(f64, Vec<f64>)>, ours: f64, answer: &[f64]) {
    let Some((seconds, theirs)) = found else {
        println!("  {name:<12} left out: it is not there");
        return;
    };
    // a direction may point either way
    let off = |sign: f64| {
        let signs = [sign; 3].into_iter().chain(std::iter::repeat(1.0));
        answer.iter().zip(&theirs).zip(signs).fold(0.0f64, |m, ((a, b), s)| m.max((a - s * b).abs()))
    };
    let off = off(1.0).min(off(-1.0));
    println!("  {name:<12} {:>10.2} ms {:>8.1} times, differs by {off:.0e}", seconds * 1e3, seconds / ours);
}
