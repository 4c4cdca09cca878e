//! Plans: the proven optimum is that of enumeration, bounds hold, and seven planned positions give the thesis' accuracy.

use crate::support::five_bar::{SEVEN, holes, measure, robot, settings, truth};
use etalon::base::noise::Noise;
use etalon::base::pose_name::PoseName;
use etalon::identify::plan::bound::Root;
use etalon::identify::plan::candidates::Candidates;
use etalon::identify::plan::search::{exchange_from_many, greedy};
use etalon::identify::plan::{Choice, Criterion, Plan, Pool, Request, candidate_pool, plan};
use etalon::identify::{Observation, identify_from};
use etalon::math::{Factor, Svd, svd};
use etalon::robots::{FiveBar, Robot, WORKING_MODES};
use etalon::stages::candidates::configurations;

pub const ALL: [Criterion; 9] = [
    Criterion::O1,
    Criterion::O2,
    Criterion::O3,
    Criterion::O4,
    Criterion::O5,
    Criterion::D,
    Criterion::A,
    Criterion::E,
    Criterion::I,
];

fn request(positions: usize, criterion: Criterion) -> Request {
    Request { positions, criterion, single: false, start: Vec::new(), starts: Some(10), seed: 1, nodes: Some(5000) }
}

/// The two outer rings of holes, in all working modes that reach them: candidates of section 4.5.
fn periphery(robot: &FiveBar) -> Vec<Observation> {
    let outer = |i: usize| !(2..22).contains(&i);
    let nominal = robot.nominal();
    let mut all = Vec::new();
    for (pose, (_, _, p)) in holes().into_iter().filter(|(i, j, _)| outer(*i) || outer(*j)).enumerate() {
        let reached = robot.inverse_all(&nominal, [p[0], p[1], 0.0]).unwrap();
        for (mode, joints) in reached.into_iter().enumerate() {
            let targets = vec![Some([p[0], p[1], 0.0])];
            all.push(Observation {
                pose: (pose as i64).into(),
                cycle: mode as i64 + 1,
                joints,
                targets,
                ..Observation::default()
            });
        }
    }
    all
}

fn poses(all: &[Observation]) -> Vec<PoseName> {
    let mut poses: Vec<PoseName> = all.iter().map(|o| o.pose).collect();
    poses.dedup();
    poses
}

/// Every eighth of the periphery's positions: few enough to try all choices.
fn fifteen(robot: &FiveBar) -> Vec<Observation> {
    let all = periphery(robot);
    let kept: Vec<PoseName> = poses(&all).into_iter().step_by(8).take(15).collect();
    all.into_iter().filter(|o| kept.contains(&o.pose)).collect()
}

/// All choices of `k` of `0..n`.
fn subsets(n: usize, k: usize) -> Vec<Vec<usize>> {
    let chosen = |mask: u32| (0..n).filter(move |i| mask >> i & 1 == 1).collect::<Vec<_>>();
    (0..1u32 << n).filter(|m| m.count_ones() as usize == k).map(chosen).collect()
}

/// Singular values and vectors of the stacked Jacobian, with nothing of the planner's.
fn decompose(pool: &Pool, chosen: &[usize]) -> Svd {
    let m = pool.parameters;
    let row = |c: usize| pool.candidates[c].rows.transpose().as_slice().to_vec();
    let rows: Vec<f64> = chosen.iter().flat_map(|&c| row(c)).collect();
    svd(&Factor::new(&rows, &vec![0.0; rows.len() / m], &vec![1.0; m]))
}

/// The index of them (eq. 1.19 to 1.25).
fn index_of(s: &Svd, pool: &Pool, criterion: Criterion, chosen: &[usize]) -> f64 {
    let m = pool.parameters;
    let (least, most) = (s.values[m - 1], s.values[0]);
    let mean = (s.values.iter().map(|s| s.ln()).sum::<f64>() / m as f64).exp();
    match criterion {
        Criterion::O1 => mean / (pool.configurations(chosen) as f64).sqrt(),
        Criterion::O2 => least / most,
        Criterion::O3 | Criterion::E => least,
        Criterion::O4 => least * least / most,
        Criterion::O5 => 1.0 / s.values.iter().map(|s| 1.0 / s).sum::<f64>(),
        Criterion::D => mean,
        Criterion::A => 1.0 / s.values.iter().map(|s| s.powi(-2)).sum::<f64>().sqrt(),
        Criterion::I => {
            // tr(W V S⁻² Vᵀ)
            let variance = |k: usize| {
                let v = nalgebra::DVector::from_column_slice(&s.vectors[k]);
                (v.transpose() * &pool.workspace * &v)[0] / s.values[k].powi(2)
            };
            1.0 / (0..m).map(variance).sum::<f64>().sqrt()
        }
    }
}

fn index_by_svd(pool: &Pool, criterion: Criterion, chosen: &[usize]) -> f64 {
    index_of(&decompose(pool, chosen), pool, criterion, chosen)
}

fn pool(robot: &FiveBar, observations: &[Observation], criterion: Criterion) -> Pool {
    let known = etalon::identify::sensitivity(robot, observations, &settings(0.01)).expect("sensitivity");
    let mut members: Vec<Vec<usize>> = Vec::new();
    for (k, o) in observations.iter().enumerate() {
        match members.last_mut() {
            Some(last) if observations[last[0]].pose == o.pose => last.push(k),
            _ => members.push(vec![k]),
        }
    }
    candidate_pool(&known, &members, criterion)
}

#[test]
fn the_proven_optimum_of_five_of_fifteen_is_that_of_enumeration() {
    let robot = robot();
    let observations = fifteen(&robot);
    // one decomposition for all criteria of the same scaling
    let choices = subsets(15, 5);
    let decomposed = [Criterion::O1, Criterion::O2].map(|c| {
        let pool = pool(&robot, &observations, c);
        choices.iter().map(|s| decompose(&pool, s)).collect::<Vec<_>>()
    });
    for criterion in ALL {
        let pool = pool(&robot, &observations, criterion);
        assert_eq!(pool.candidates.len(), 15);
        let decomposed = &decomposed[usize::from(!criterion.scales_columns())];
        let indices = decomposed.iter().zip(&choices).map(|(s, c)| index_of(s, &pool, criterion, c));
        let best = indices.fold(0.0, f64::max);
        let thesis = greedy(&pool, &[], 5);
        let found = exchange_from_many(&pool, std::slice::from_ref(&thesis), 10, 1, || {});
        assert!(found.value >= thesis.value);
        let reached = index_by_svd(&pool, criterion, &found.chosen);
        assert!((reached / found.value.sqrt() - 1.0).abs() < 1e-6, "{criterion:?} {reached} {}", found.value.sqrt());
        assert!(reached <= best * (1.0 + 1e-9));
        let Some(root) = Root::new(&pool, thesis.chosen.len()) else {
            assert_eq!(criterion, Criterion::O4, "no bound is known of this one alone");
            println!("{criterion:?}: no bound, exchange {reached:.6} of {best:.6}");
            continue;
        };
        let proven = root.prove(&pool, thesis.clone(), 5000, |_| {});
        let bound = proven.relaxation.sqrt();
        println!(
            "{criterion:?}: best {best:.6}, exchange {reached:.6}, greedy {:.6}, relaxation {:.3} % above, {} nodes",
            thesis.value.sqrt(),
            100.0 * (bound / best - 1.0),
            proven.nodes
        );
        assert!(bound >= best * (1.0 - 1e-9), "{criterion:?}: the bound {bound} is below {best}");
        let chosen = index_by_svd(&pool, criterion, &proven.best.chosen);
        assert!((chosen / best - 1.0).abs() < 1e-8, "{criterion:?} {chosen} {best}");
        assert!((proven.bound / proven.best.value - 1.0).abs() < 1e-8, "{criterion:?} not closed");
    }
}

#[test]
fn greedy_by_updates_chooses_what_greedy_by_singular_values_does() {
    let robot = robot();
    let observations = fifteen(&robot);
    for criterion in ALL {
        let pool = pool(&robot, &observations, criterion);
        let mut chosen = vec![0, 4, 7, 11];
        while chosen.len() < 8 {
            let free = (0..15).filter(|i| !chosen.contains(i));
            let with = |i: usize| index_by_svd(&pool, criterion, &[&chosen[..], &[i]].concat());
            let next = free.max_by(|&a, &b| with(a).total_cmp(&with(b))).unwrap();
            chosen.push(next);
        }
        assert_eq!(greedy(&pool, &[0, 4, 7, 11], 8).chosen, chosen, "{criterion:?}");
    }
}

fn planned(robot: &FiveBar, observations: &[Observation], positions: usize, nodes: usize) -> Plan {
    let request = Request { nodes: Some(nodes), ..request(positions, Criterion::O1) };
    plan(robot, observations, &settings(0.01), &request, &|_, _| {}).expect("plan")
}

#[test]
fn seven_of_the_periphery_come_with_a_bound() {
    let robot = robot();
    let observations = periphery(&robot);
    println!("{} positions, {} configurations", poses(&observations).len(), observations.len());
    for (positions, limit) in [(5, 2.5), (7, 1.3), (10, 0.6)] {
        let found = planned(&robot, &observations, positions, 0);
        let below = found.at_most_below_percent().expect("bound");
        println!(
            "{positions}: O1 {:.5} (greedy {:.5}), at most {below:.3} % below the best",
            found.index, found.greedy_index
        );
        assert!(found.index >= found.greedy_index);
        assert!(below < limit, "{positions}: {below}");
    }
}

#[test]
fn five_and_seven_of_the_periphery_are_proven_to_be_the_best() {
    let robot = robot();
    let observations = periphery(&robot);
    for (positions, nodes) in [(5, 4000), (7, 4000)] {
        let found = planned(&robot, &observations, positions, nodes);
        println!(
            "{positions}: O1 {:.6}, {} nodes, {:?} % below at most",
            found.index,
            found.nodes,
            found.at_most_below_percent()
        );
        assert!(found.at_most_below_percent().expect("bound") < 1e-6);
    }
}

#[test]
fn the_proven_optimum_of_four_of_sixty_five_is_that_of_enumeration() {
    let robot = robot();
    let all = periphery(&robot);
    let kept: Vec<PoseName> = poses(&all).into_iter().step_by(2).collect();
    let observations: Vec<Observation> = all.into_iter().filter(|o| kept.contains(&o.pose)).collect();
    let pool = pool(&robot, &observations, Criterion::O1);
    let n = pool.candidates.len();
    assert_eq!(n, 65);
    let m = pool.parameters as f64;
    let information: Vec<nalgebra::SMatrix<f64, 12, 12>> =
        (0..n).map(|i| nalgebra::SMatrix::from_column_slice(pool.information(&[i]).as_slice())).collect();
    let mut best = (0.0, [0; 4]);
    for a in 0..n {
        for b in a + 1..n {
            let two = information[a] + information[b];
            for c in b + 1..n {
                let three = two + information[c];
                for (d, last) in information.iter().enumerate().skip(c + 1) {
                    let Some(factor) = (three + last).cholesky() else { continue };
                    let log: f64 = factor.l_dirty().diagonal().iter().map(|v| 2.0 * v.ln()).sum();
                    let value = (log / m).exp() / pool.configurations(&[a, b, c, d]) as f64;
                    if value > best.0 {
                        best = (value, [a, b, c, d]);
                    }
                }
            }
        }
    }
    let thesis = greedy(&pool, &[], 4);
    let proven = Root::new(&pool, thesis.chosen.len()).expect("bound").prove(&pool, thesis, 20_000, |_| {});
    let mut chosen = proven.best.chosen.clone();
    chosen.sort_unstable();
    println!("{chosen:?} {:?}, {} nodes", best, proven.nodes);
    assert_eq!(chosen, best.1);
    assert!((proven.bound / proven.best.value - 1.0).abs() < 1e-8 && (proven.best.value / best.0 - 1.0).abs() < 1e-8);
}

#[test]
fn planned_positions_in_one_working_mode_alone_leave_parameters_that_are_named() {
    let robot = robot();
    let (nominal, truth) = (robot.nominal(), truth());
    let observations = periphery(&robot);
    let found = planned(&robot, &observations, 7, 0);
    let places: Vec<[f64; 2]> = found
        .chosen
        .iter()
        .filter_map(|&c| observations[found.members[c][0]].targets[0])
        .map(|p| [p[0], p[1]])
        .collect();
    let told = |measured: &[Observation]| -> Vec<usize> {
        let found = identify_from(&robot, measured, &settings(0.01), &nominal).expect("identified");
        let held = found.identifiability.groups.iter().flat_map(|g| g.with.iter().chain([&g.held]).copied());
        let mut all: Vec<usize> =
            held.chain(found.identifiability.weak.iter().flat_map(|w| w.parameters.clone())).collect();
        all.sort_unstable();
        all.dedup();
        let said = found.warnings.iter().any(|w| w.what.contains("identifiable"));
        assert_eq!(said, !all.is_empty(), "what is found is said: {:?}", found.warnings);
        all
    };
    let mut noise = Noise::new(12, 0);
    let all_modes = measure(&robot, &truth, &places, &mut || noise.gaussian(0.01));
    assert_eq!(told(&all_modes), Vec::<usize>::new(), "with all working modes every parameter is told");
    for branches in WORKING_MODES {
        let reached = |o: &&Observation| {
            let at = o.targets[0].map_or([0.0; 2], |p| [p[0], p[1]]);
            let q = robot.inverse(&truth, robot.to_base(&truth, at), branches);
            q.iter().zip(&o.joints).all(|(q, j)| (q - j).abs() < 0.01)
        };
        let one: Vec<Observation> = all_modes.iter().filter(reached).cloned().collect();
        let told = told(&one);
        let name = |i: &usize| robot.parameters()[*i].name.clone();
        println!("{branches:?}: {} positions, {:?}", one.len(), told.iter().map(name).collect::<Vec<_>>());
        assert!(told.len() >= 2, "{branches:?}");
        // the combination that the data tell least: its largest share is among those named
        let n = nominal.len();
        let mut rows = nalgebra::DMatrix::zeros(2 * one.len(), n);
        for (k, o) in one.iter().enumerate() {
            let mut block = vec![0.0; 2 * n];
            robot.jacobian(&truth, &o.joints, &mut block);
            rows.rows_mut(2 * k, 2).copy_from(&nalgebra::DMatrix::from_row_slice(2, n, &block));
        }
        rows.column_iter_mut().for_each(|mut c| c /= c.norm());
        let eigen = nalgebra::SymmetricEigen::new(rows.tr_mul(&rows));
        let least = eigen.eigenvectors.column(eigen.eigenvalues.imin());
        assert!(told.contains(&least.iamax()), "{branches:?}: {least}");
    }
}

/// Root mean square and largest error over all holes and working modes, in um.
fn errors_um(robot: &FiveBar, found: &[f64], everywhere: &[Observation]) -> (f64, f64) {
    let error = |o: &Observation| {
        let (p, at) = (robot.position(found, &o.joints, 0), o.targets[0].expect("position"));
        1000.0 * (p[0] - at[0]).hypot(p[1] - at[1])
    };
    let errors: Vec<f64> = everywhere.iter().map(error).collect();
    let mean = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
    (mean.sqrt(), errors.into_iter().fold(0.0, f64::max))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    0.5 * (values[(values.len() - 1) / 2] + values[values.len() / 2])
}

/// Medians of root mean square and largest error over `seeds`, each the mean of five identifications (section 4.6).
fn study(robot: &FiveBar, positions: &[[f64; 2]], seeds: u64) -> (f64, f64) {
    let truth = truth();
    let mut everywhere = Vec::new();
    for (_, _, p) in holes() {
        let at = [p[0], p[1], 0.0];
        let reached = robot.inverse_all(&truth, at).unwrap().into_iter();
        everywhere.extend(reached.map(|joints| Observation {
            pose: 0.into(),
            cycle: 0,
            joints,
            targets: vec![Some(at)],
            ..Observation::default()
        }));
    }
    let trial = |seed: u64| {
        let mut mean = vec![0.0; truth.len()];
        for run in 0..5 {
            let mut noise = Noise::new(11, 5 * seed + run);
            let measured = measure(robot, &truth, positions, &mut || noise.gaussian(0.01));
            let found = identify_from(robot, &measured, &settings(0.01), &robot.nominal()).expect("identified");
            mean.iter_mut().zip(&found.values).for_each(|(m, v)| *m += v / 5.0);
        }
        errors_um(robot, &mean, &everywhere)
    };
    let (rms, max): (Vec<f64>, Vec<f64>) = (0..seeds).map(trial).unzip();
    (median(rms), median(max))
}

#[test]
fn seven_planned_positions_give_the_accuracy_of_table_4_2_and_fewer_less_in_the_order_of_table_4_3() {
    let robot = robot();
    let observations = periphery(&robot);
    for criterion in [Criterion::O1, Criterion::I] {
        let request = Request { nodes: Some(0), ..request(7, criterion) };
        let found = plan(&robot, &observations, &settings(0.01), &request, &|_, _| {}).expect("plan");
        let pool = pool(&robot, &observations, Criterion::D);
        let mut order: Vec<usize> = Vec::new();
        while order.len() < 7 {
            let with = |i: usize| Choice::new(&pool, [&order[..], &[i]].concat()).value;
            let free = found.chosen.iter().copied().filter(|i| !order.contains(i));
            order.push(free.max_by(|&a, &b| with(a).total_cmp(&with(b))).unwrap());
        }
        let place = |c: &usize| observations[found.members[*c][0]].targets[0].map(|p| [p[0], p[1]]).expect("position");
        let positions: Vec<[f64; 2]> = order.iter().map(place).collect();
        let table: Vec<(f64, f64)> =
            (3..=7).map(|count| study(&robot, &positions[..count], if count == 7 { 100 } else { 20 })).collect();
        for (count, (rms, max)) in (3..).zip(&table) {
            println!("{criterion:?}, {count} positions: rms {rms:.2} um, max {max:.2} um");
        }
        assert!(table.windows(2).all(|w| w[1].0 < w[0].0), "{criterion:?}: the order of table 4.3");
        let (rms, max) = table[4];
        assert!(rms <= 3.5 && max <= 10.1, "{criterion:?}, table 4.2: {rms} {max}");
    }
}

#[test]
fn positions_alone_become_all_working_modes() {
    let robot = robot();
    let csv = SEVEN
        .iter()
        .enumerate()
        .fold("pose,x_mm,y_mm\n".to_owned(), |t, (k, p)| t + &format!("{k},{},{}\n", p[0], p[1]));
    let table = etalon::formats::tables::observations::observations("c.csv", &csv).unwrap();
    let Candidates { observations: all, limit_violations } = configurations(&robot, &table).unwrap();
    assert_eq!(limit_violations, None);
    let expected = measure(&robot, &robot.nominal(), &SEVEN, &mut || 0.0);
    assert_eq!(all.len(), expected.len());
    let near = |a: &Observation, e: &Observation| a.joints.iter().zip(&e.joints).all(|(a, e)| (a - e).abs() < 1e-9);
    assert!(all.iter().zip(&expected).all(|(a, e)| a.pose == e.pose && near(a, e)));
}
