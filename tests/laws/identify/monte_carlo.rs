//! Distributions by draws and by resampling beside linear propagation.

use crate::support::scratch::copy_sample;
use etalon::campaign::Campaign;
use etalon::documents::UncertaintyDocument;
use etalon::run::validation::uncertainty;
use etalon::stages::uncertainty::monte_carlo::Draws;

fn found(sample: &str, end: &str, draws: Draws) -> UncertaintyDocument {
    let scratch = copy_sample(sample);
    let path = scratch.path().join("campaign.toml");
    std::fs::write(&path, std::fs::read_to_string(&path).unwrap() + end).unwrap();
    uncertainty(&Campaign::read(&path).unwrap(), draws, &mut |_, _| ()).unwrap()
}

/// A campaign whose readings have the stated uncertainty alone: three ways to one standard uncertainty.
#[test]
fn linear_propagation_draws_and_bootstrap_agree_where_they_should() {
    let more = "\n[expansion]\nexpanded_temperature_uncertainty_c = 1.0\ncoverage_factor = 2\nrobot_per_c = 11.5e-6\n\n\
        [homing]\nexpanded_uncertainty_um = 2\ncoverage_factor = 2\n";
    let document = found("prexyt-cmm", more, Draws { most: 20_000, resamples: 0, seed: 5 });
    for p in &document.parameters {
        let (linear, drawn) = (p.linear.unwrap(), p.standard_deviation);
        println!("{}: {linear:.3e} {drawn:.3e}", p.name);
        assert!((drawn / linear - 1.0).abs() < 0.04, "{}: {linear} {drawn}", p.name);
        assert!((p.mean.unwrap() - p.value).abs() < 0.05 * drawn, "{}", p.name);
        assert_eq!(p.agrees, Some(true), "{}", p.name);
    }
    // the largest error is that of one reading: repeated, it scatters by its budget; mean and root mean square are
    // linear at errors of the size of the noise, where their budgets are too large
    for e in &document.errors {
        let ratio = e.standard_deviation / e.standard_uncertainty.unwrap();
        println!("{}: {ratio:.2}", e.name);
        assert!((if e.name == "max" { 0.9..1.1 } else { 0.6..1.1 }).contains(&ratio), "{}: {ratio}", e.name);
        assert_eq!(e.agrees, Some(true), "{}", e.name);
    }
    // of many poses that scatter by more than the instrument, the uncertainty of the report is that of the bootstrap
    let document = found("column-arm", "", Draws { most: 200, resamples: 200, seed: 5 });
    assert_eq!(document.resamples, 200);
    let ratios = document.parameters.iter().filter_map(|p| Some(p.bootstrap? / p.standard_uncertainty?));
    let mut ratios: Vec<f64> = ratios.collect();
    ratios.sort_by(f64::total_cmp);
    println!("bootstrap over report: {ratios:.2?}");
    assert!((0.7..1.4).contains(&ratios[ratios.len() / 2]), "{ratios:?}");
}

/// A ball of the plate is measured once and touched many times: each draw moves it for all of its touches.
#[test]
fn draws_agree_where_one_reading_is_common_to_many_poses() {
    let document = found("dextar", "", Draws { most: 4000, resamples: 0, seed: 3 });
    for p in &document.parameters {
        let (linear, drawn) = (p.linear.unwrap(), p.standard_deviation);
        assert!((drawn / linear - 1.0).abs() < 0.05, "{}: {linear} {drawn}", p.name);
        assert!((p.mean.unwrap() - p.value).abs() < 0.06 * drawn, "{}", p.name);
    }
}

#[test]
fn the_same_numbers_come_out_on_any_number_of_threads() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| found("prexyt-cmm", "", Draws { most: 300, resamples: 50, seed: 2 }))
    };
    assert_eq!(run(1), run(3));
}

/// What a certificate states of a part is one more reading: it is drawn too.
#[test]
fn draws_of_a_stated_shape_agree() {
    let shape = "\n[[rigid]]\ntargets = [\"K\", \"L\"]\ntolerance_mm = 1.0\nexpanded_uncertainty_um = 0.2\ncoverage_factor = 2\n\
        places_mm = { K = [0.0, 0.0, 0.0], L = [146.0217, 0.0, 0.0] }\n";
    let document = found("prexyt-cmm", shape, Draws { most: 4000, resamples: 0, seed: 6 });
    let length = document.parameters.iter().find(|p| p.name == "l_kl").unwrap();
    let (linear, drawn) = (length.linear.unwrap(), length.standard_deviation);
    assert!((drawn / linear - 1.0).abs() < 0.05, "{linear} {drawn}");
}

/// Of contacts, distances, surfaces, poses and second encoders too: what is stated of them is drawn.
#[test]
fn draws_of_every_kind_agree() {
    for sample in ["contacts", "draw-wire", "surfaces", "probe-poses", "second-encoders"] {
        let document = found(sample, "", Draws { most: 2000, resamples: 10, seed: 4 });
        assert_eq!(document.resamples, 0, "{sample}: conditions are not resampled");
        let ratios = document.parameters.iter().filter_map(|p| Some((&p.name, p.standard_deviation / p.linear?)));
        let worst = ratios.max_by(|a, b| (a.1 - 1.0).abs().total_cmp(&(b.1 - 1.0).abs())).unwrap();
        println!("{sample}: {worst:?}");
        assert!((worst.1 - 1.0).abs() < 0.08, "{sample}: {worst:?}");
    }
    let scratch = copy_sample("contacts");
    let path = scratch.path().join("campaign.toml");
    let homing = "\n[homing]\nexpanded_uncertainty_deg = 0.002\ncoverage_factor = 2\n";
    std::fs::write(&path, std::fs::read_to_string(&path).unwrap() + homing).unwrap();
    let draws = Draws { most: 100, resamples: 0, seed: 1 };
    let refused = uncertainty(&Campaign::read(&path).unwrap(), draws, &mut |_, _| ()).unwrap_err();
    assert!(refused.to_string().contains("homing"), "{refused}");
}
