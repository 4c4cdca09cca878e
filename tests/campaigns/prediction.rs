//! The error to expect over the workspace: nodes, uncertainties and quantiles against draws of the parameters.

use crate::support::scratch::copy_sample;
use etalon::base::noise::Noise;
use etalon::base::pose::{minus, norm};
use etalon::campaign::Campaign;
use etalon::math::identify::ToolPoint;
use etalon::run::pipeline;
use nalgebra::{DMatrix, DVector};

const DRAWS: u64 = 4000;

#[test]
fn the_map_agrees_with_draws_of_the_parameters() {
    for (sample, planar) in [("prexyt-cmm", true), ("column-arm", false)] {
        let scratch = copy_sample(sample);
        let campaign = Campaign::read(&scratch.path()).unwrap();
        let found = pipeline::evaluate(&campaign).unwrap().identified.unwrap();
        let mut targets: Vec<String> = found.errors.iter().map(|e| e.target.clone()).filter(|t| t != "C").collect();
        targets.sort();
        targets.dedup();
        let robot = campaign.build_robot_with(&targets).unwrap();
        let map = found.accuracy.map.unwrap();
        let point = ToolPoint { point_mm: map.point_mm, frame: map.frame, standard_uncertainty_mm: 0.0 };
        assert!((20..=300).contains(&map.nodes.len()), "{sample}: {}", map.nodes.len());

        let (values, free) = (&found.found.values, &found.found.free);
        let n = free.len();
        let covariance = DMatrix::from_row_slice(n, n, found.found.covariance.as_ref().unwrap());
        let scale = DMatrix::from_diagonal(&covariance.diagonal().map(f64::sqrt));
        let correlation = DMatrix::from_fn(n, n, |i, j| covariance[(i, j)] / (scale[(i, i)] * scale[(j, j)]));
        let root = &scale * correlation.cholesky().unwrap().l();
        let (mut within, mut worst) = (Vec::new(), 0.0f64);
        for node in map.nodes.iter().step_by(map.nodes.len() / 5) {
            let joint = robot.joints().iter().zip(&node.joints);
            let joints: Vec<f64> = joint.map(|(joint, v)| joint.quantity.inward(*v)).collect();
            let at = point.in_base(robot.as_ref(), values, &joints).unwrap();
            assert!(norm(minus(at, node.at_mm)) < 1e-6, "{sample}: the node is at {at:?}, not at {:?}", node.at_mm);
            assert!(!planar || node.at_mm[2] == 0.0);
            let size = |trial: u64| {
                let mut noise = Noise::new(11, trial);
                let step = &root * DVector::from_fn(n, |_, _| noise.gaussian(1.0));
                let mut drawn = values.clone();
                free.iter().zip(step.iter()).for_each(|(&i, step)| drawn[i] += step);
                norm(minus(point.in_base(robot.as_ref(), &drawn, &joints).unwrap(), at))
            };
            let sizes: Vec<f64> = (0..DRAWS).map(size).collect();
            let rms = (sizes.iter().map(|s| s * s).sum::<f64>() / DRAWS as f64).sqrt();
            worst = worst.max((rms / node.parameters_mm - 1.0).abs());
            // where nothing else contributes, one in 20 is larger than the quantile
            if node.standard_uncertainty_mm == node.parameters_mm {
                within.push(sizes.iter().filter(|s| **s <= node.p95_mm).count() as f64 / DRAWS as f64);
            }
            assert!(node.standard_uncertainty_mm >= node.parameters_mm && node.p95_mm > node.standard_uncertainty_mm);
        }
        // an estimated standard deviation of 4,000 sizes scatters by 1.1 %
        assert!(worst < 0.04, "{sample}: draws differ by {worst} from the linear standard uncertainty");
        assert!(within.iter().all(|share| (share - 0.95).abs() < 0.012), "{sample}: {within:?}");
        assert!(!planar || within.len() == 5, "{sample}: the instrument explains all residuals, and nothing is held");
    }
}
