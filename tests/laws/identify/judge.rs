//! The judge of a set-up on robots whose model is incomplete: sound data are neither refused nor accused, a mistake of the set-up is named,
//! and no other is. Everything is drawn (synthetic). `ETALON_CAMPAIGNS` states how many campaigns of each kind.

use super::drawn::{number, whole};
use super::regional::Measured::{self, Contacts, Poses, Positions, Targets};
use super::regional::{Campaign, LEFT_OUT, Twin};
use super::set_ups::messages_alone;
use etalon::base::catalogue::Argument;
use etalon::base::message::{Message, Problems, Severity};
use etalon::base::noise::Noise;
use etalon::base::phrase;
use etalon::base::pose::{Pose, Vector};
use etalon::identify::{Kind, OrientationReading, judge};
use etalon::robots::Robot;
use etalon::stages::calibrate::solution::{Basis, Solution};
use etalon::stages::evaluate::sets::Sets;
use rayon::prelude::*;

/// Words of a message that names a cause.
const NAMES_A_CAUSE: &str = "check that first";
/// Joints of the twins.
const JOINTS: usize = 6;

/// A mistake of the set-up: what it is, what a message contains that names it (all parts between `&`), and what it does to the data.
struct Mistake {
    what: String,
    named: Vec<String>,
    make: Box<dyn Fn(&mut Campaign) + Sync>,
}

fn mistake(what: &str, named: &[&str], make: impl Fn(&mut Campaign) + Sync + 'static) -> Mistake {
    let named = named.iter().map(|text| (*text).to_owned()).collect();
    Mistake { what: what.to_owned(), named, make: Box::new(make) }
}

fn change_joints(campaign: &mut Campaign, how: &dyn Fn(&mut Vec<f64>)) {
    campaign.observations.iter_mut().for_each(|o| how(&mut o.joints));
    campaign.settings.conditions.iter_mut().for_each(|c| how(&mut c.joints));
}

fn change_points(campaign: &mut Campaign, how: &dyn Fn(&mut Vector)) {
    campaign.observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(how);
}

/// Mistakes in the joints, each drawn once.
fn mistakes_of_joints(noise: &mut Noise) -> Vec<Mistake> {
    let names: Vec<String> = (1..=JOINTS).map(|k| format!("`q{k}`")).collect();
    let mut all = Vec::new();
    let (i, j) = (whole(noise, 0, JOINTS - 1), whole(noise, 0, JOINTS - 2));
    let reversed = format!("{} reversed", names[i]);
    all.push(mistake(&reversed, &[&reversed], move |c| change_joints(c, &|q| q[i] = -q[i])));
    let exchanged = format!("{} and {} swapped", names[j], names[j + 1]);
    all.push(mistake(&exchanged, &[&exchanged], move |c| change_joints(c, &|q| q.swap(j, j + 1))));
    // an offset of the first joint is that of the base, of the last one that of the targets
    let k = whole(noise, 1, JOINTS - 2);
    let offset = [format!("deg added to {}", names[k]), format!("`theta_{}`", k + 1)];
    let [added, theta] = offset.each_ref().map(String::as_str);
    all.push(mistake("90 deg", &[added, theta], move |c| change_joints(c, &|q| q[k] += 90f64.to_radians())));
    let scaled = |factor: f64| move |c: &mut Campaign| change_joints(c, &|q| q.iter_mut().for_each(|v| *v *= factor));
    all.push(mistake("degrees", &["in degrees instead of radians"], scaled(1f64.to_degrees())));
    all.push(mistake("radians", &["in radians instead of degrees"], scaled(1f64.to_radians())));
    let rotated = phrase!("slip-joint-order", order = "right").to_string();
    all.push(mistake("rotated order", &[&rotated], |c| change_joints(c, &|q| q.rotate_left(1))));
    all
}

/// Two mistakes at once, and a wrong transmission ratio.
fn mistakes_of_pairs(noise: &mut Noise) -> Vec<Mistake> {
    // the direction of the first and the last joint may be one of base and targets
    let (i, k) = (whole(noise, 1, 2), whole(noise, 3, JOINTS - 2));
    let reversed = [i, k].map(|i| format!("`q{}` reversed", i + 1));
    let [first, second] = reversed.each_ref().map(String::as_str);
    let gain = format!("`gain_{}`", i + 1);
    vec![
        mistake("two reversed", &[&format!("{first}&{second}")], move |c| {
            change_joints(c, &|q| (q[i], q[k]) = (-q[i], -q[k]));
        }),
        mistake("degrees, one reversed", &[&format!("degrees instead of radians&{first}")], move |c| {
            change_joints(c, &|q| {
                q[i] = -q[i];
                q.iter_mut().for_each(|v| *v = v.to_degrees());
            });
        }),
        mistake("inches, one reversed", &[&format!("points in inches&{second}")], move |c| {
            change_joints(c, &|q| q[k] = -q[k]);
            change_points(c, &|p| *p = p.map(|v| v / 25.4));
        }),
        mistake("transmission ratio", &[&gain], move |c| change_joints(c, &|q| q[i] *= 1.1)),
    ]
}

/// Mistakes in the points.
fn mistakes_of_points() -> Vec<Mistake> {
    let scaled = |factor: f64| move |c: &mut Campaign| change_points(c, &|p| *p = p.map(|v| v * factor));
    vec![
        mistake("metres", &["points in metres"], scaled(1e-3)),
        mistake("inches", &["points in inches"], scaled(1.0 / 25.4)),
        mistake("left-handed", &["mirrored"], |c| change_points(c, &|p| p[2] = -p[2])),
        mistake("x and y exchanged", &["mirrored"], |c| change_points(c, &|p| p.swap(0, 1))),
    ]
}

/// Mistakes at some poses.
fn mistakes_of_poses(noise: &mut Noise, poses: usize) -> Vec<Mistake> {
    let k = whole(noise, 3, poses / 2 - 4);
    let neighbours = ["previous", "next"].map(|neighbour| phrase!("slip-neighbour", neighbour).to_string());
    let [previous, next] = neighbours.each_ref().map(String::as_str);
    vec![
        mistake("rows shifted", &[previous, next], |c| {
            let rows = c.observations.len();
            (1..rows).rev().for_each(|k| c.observations[k].joints = c.observations[k - 1].joints.clone());
        }),
        mistake("one reading off", &["[outliers]", "outliers"], move |c| {
            c.observations[k].targets[0].as_mut().expect("measured")[0] += 300.0;
        }),
        mistake("two poses exchanged", &["are swapped"], move |c| {
            let other = c.observations[k + 3].joints.clone();
            c.observations[k + 3].joints = std::mem::replace(&mut c.observations[k].joints, other);
        }),
        mistake("moved by 2 mm", &["from pose"], move |c| {
            let late = &mut c.observations[k + 3..];
            late.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(|p| {
                *p = [p[0] + 1.2, p[1] - 1.6, p[2]];
            });
        }),
    ]
}

/// What is said of a campaign, as a run says it.
fn messages(twin: &Twin, campaign: &Campaign) -> Vec<Message> {
    let Campaign { observations, settings } = campaign.clone();
    let sets = Sets { calibration: observations, ..Sets::default() };
    match Solution::new(&twin.robot, Basis { sets, settings, ..Basis::default() }) {
        Ok(solution) => messages_alone(&twin.robot, &solution),
        Err(Problems(problems)) => problems,
    }
}

/// Number of mistakes that are noticed, named, and named wrongly.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    all: usize,
    noticed: usize,
    named: usize,
    wrong: usize,
}

impl std::iter::Sum for Tally {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, other| Self {
            all: sum.all + other.all,
            noticed: sum.noticed + other.noticed,
            named: sum.named + other.named,
            wrong: sum.wrong + other.wrong,
        })
    }
}

impl Tally {
    /// At least 97 % are noticed and 93 % named; at most 0.5 % are named wrongly.
    fn assert_reached(&self) {
        println!("{self:?}");
        assert!(100 * self.noticed >= 97 * self.all, "{self:?}");
        assert!(100 * self.named >= 93 * self.all, "{self:?}");
        assert!(200 * self.wrong <= self.all, "{self:?}");
    }
}

fn tally(twin: &Twin, campaign: &Campaign, mistakes: Vec<Mistake>, label: &str) -> Tally {
    let mut tally = Tally::default();
    for Mistake { what, named, make } in mistakes {
        let mut changed = campaign.clone();
        make(&mut changed);
        let said = messages(twin, &changed);
        let text: String = said.iter().map(|m| format!("{m}\n")).collect();
        let is_named = named.iter().any(|words| words.split('&').all(|part| text.contains(part)));
        let is_wrong = !is_named && text.contains(NAMES_A_CAUSE);
        let is_noticed = is_named || said.iter().any(|m| m.severity == Severity::Error);
        tally.all += 1;
        tally.noticed += usize::from(is_noticed);
        tally.named += usize::from(is_named);
        tally.wrong += usize::from(is_wrong);
        if !is_named {
            println!("{label}: {what}: {}\n{text}", if is_noticed { "noticed, not named" } else { "IN SILENCE" });
        }
    }
    tally
}

/// Campaigns of a kind.
#[derive(Clone, Copy, Debug)]
struct Series {
    measured: Measured,
    poses: usize,
    /// Misfit of the model over the noise.
    ratio: f64,
}

fn series(measured: Measured, poses: usize, ratio: f64) -> Series {
    Series { measured, poses, ratio }
}

/// Messages that accuse sound campaigns.
const ACCUSING: [&str; 6] =
    ["reference-moved", "target-shifted", "joint-zero-shifted", "poses-exchanged", "coordinates-wrong", "outliers"];

/// A sound campaign, which no message may accuse, and `choose` of its mistakes.
fn judged(series: Series, seed: u64, choose: impl Fn(Vec<Mistake>) -> Vec<Mistake>) -> Tally {
    let Series { measured, poses, ratio } = series;
    let twin = Twin::drawn(measured, LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, 700 + seed);
    let mut noise = Noise::new(70, seed);
    let campaign = twin.observed(poses, 1.0, &mut noise);
    let label = format!("{measured:?}, {poses} poses, misfit {ratio} × noise, {seed}");
    let sound = messages(&twin, &campaign);
    let accuses = |m: &&Message| {
        let is_named = ACCUSING.iter().any(|id| m.id == *id);
        is_named || m.severity == Severity::Error || m.to_string().contains(NAMES_A_CAUSE)
    };
    let accused: Vec<&Message> = sound.iter().filter(accuses).collect();
    assert!(accused.is_empty(), "{label}: {accused:?}");
    let mut mistakes = mistakes_of_joints(&mut noise);
    mistakes.extend(mistakes_of_points());
    // each takes as long as all single ones
    if seed.is_multiple_of(2) {
        mistakes.extend(mistakes_of_pairs(&mut noise));
    }
    // contacts are half of the rows: a shift of the others alone is no shift of the log
    mistakes.extend(mistakes_of_poses(&mut noise, poses / if measured == Contacts { 2 } else { 1 }));
    if matches!(measured, Poses | Contacts) {
        mistakes.retain(|mistake| mistake.what != "rows shifted");
    }
    tally(&twin, &campaign, choose(mistakes), &label)
}

#[test]
#[ignore = "a long law: make laws"]
fn robots_with_incomplete_models_are_judged_by_what_their_model_leaves() {
    let count = number("ETALON_CAMPAIGNS", 2);
    let mut total = Tally::default();
    for series in [
        series(Positions, 60, 5.0),
        series(Positions, 120, 20.0),
        series(Positions, 400, 10.0),
        series(Targets, 60, 10.0),
        series(Targets, 120, 20.0),
        series(Poses, 60, 10.0),
        series(Poses, 120, 20.0),
        series(Contacts, 120, 10.0),
    ] {
        let one = |seed| judged(series, seed, |all| all);
        let all: Vec<Tally> = (0..count).into_par_iter().map(one).collect();
        let found: Tally = all.into_iter().sum();
        println!("{series:?}: {found:?}");
        total = [total, found].into_iter().sum();
    }
    total.assert_reached();
}

/// The same on four small campaigns, which share the single mistakes.
#[test]
fn small_campaigns_with_incomplete_models_are_judged_alike() {
    let all =
        [series(Positions, 60, 10.0), series(Targets, 60, 5.0), series(Poses, 60, 10.0), series(Contacts, 80, 5.0)];
    let turns: Vec<(usize, Series)> = all.into_iter().enumerate().collect();
    let one = |(turn, series): (usize, Series)| {
        let choose = |mistakes: Vec<Mistake>| mistakes.into_iter().skip(turn).step_by(all.len()).collect();
        judged(series, 2 * turn as u64 + 1, choose)
    };
    turns.into_par_iter().map(one).collect::<Vec<Tally>>().into_iter().sum::<Tally>().assert_reached();
}

/// Base or measuring system that moved by 0.5 to 3 mm at any time, on robots whose model leaves up to 0.7 mm.
#[test]
#[ignore = "a long law: make laws"]
fn a_moved_set_up_is_found_by_size_and_time() {
    let count = number("ETALON_CAMPAIGNS", 6);
    let (mut all, mut right, mut accused, mut sound) = (0, 0, 0, 0);
    for (measured, poses, ratio) in [
        (Measured::Positions, 60, 5.0),
        (Measured::Positions, 60, 20.0),
        (Measured::Positions, 120, 10.0),
        (Measured::Positions, 400, 20.0),
        (Measured::Targets, 60, 10.0),
    ] {
        let one = |seed: u64| {
            let twin = Twin::drawn(measured, LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, 800 + seed);
            let mut noise = Noise::new(71, seed);
            let campaign = twin.observed(poses, 1.0, &mut noise);
            let moved = |shift_mm: f64, at: usize| -> Option<(f64, usize)> {
                let mut campaign = campaign.clone();
                let late = &mut campaign.observations[at..];
                late.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(|p| {
                    *p = [p[0] + 0.6 * shift_mm, p[1], p[2] - 0.8 * shift_mm];
                });
                let said = messages(&twin, &campaign);
                let found = said.iter().find(|m| ACCUSING[..3].contains(&&*m.id))?;
                let Some(Argument::Number(mm)) = found.arguments.get("shift_mm") else { return None };
                let is_there = |o: &etalon::identify::Observation| found.is(&found.id.clone(), &[("pose", &o.pose)]);
                Some((*mm, campaign.observations.iter().position(is_there)?))
            };
            let named = moved(0.0, poses / 2).is_some();
            let mut right = 0;
            for shift_mm in [0.5, 1.0, 3.0] {
                let at = whole(&mut noise, 6, poses - 7);
                let is_right = |(mm, pose): (f64, usize)| (mm / shift_mm - 1.0).abs() < 0.2 && pose.abs_diff(at) <= 2;
                right += usize::from(moved(shift_mm, at).is_some_and(is_right));
            }
            (right, named)
        };
        let found: Vec<(usize, bool)> = (0..count).into_par_iter().map(one).collect();
        let (of, named) = (found.iter().map(|f| f.0).sum::<usize>(), found.iter().filter(|f| f.1).count());
        println!(
            "{measured:?}, {poses} poses, misfit {ratio} × noise: {of} of {}, {named} sound ones named",
            3 * count
        );
        (all, right) = (all + 3 * found.len(), right + of);
        (sound, accused) = (sound + found.len(), accused + named);
    }
    println!("{right} of {all} right; {accused} of {sound} sound campaigns named");
    assert!(100 * right >= 90 * all, "{right} of {all}");
    assert!(accused == 0, "{accused} of {sound}");
}

/// A zero that one joint lost at any time, on robots whose model leaves up to 0.7 mm. If the measurements agree as well with a motion of base or target,
/// the message has the other cause too.
#[test]
#[ignore = "a long law: make laws"]
fn a_lost_zero_is_found_by_joint_size_and_time() {
    let count = number("ETALON_CAMPAIGNS", 6);
    let (mut all, mut right, mut wrong) = (0, 0, 0);
    for (measured, poses, ratio) in [
        (Measured::Positions, 60, 5.0),
        (Measured::Positions, 60, 20.0),
        (Measured::Positions, 120, 10.0),
        (Measured::Targets, 60, 10.0),
    ] {
        let one = |seed: u64| {
            let twin = Twin::drawn(measured, LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, 900 + seed);
            let mut noise = Noise::new(72, seed);
            let campaign = twin.observed(poses, 1.0, &mut noise);
            let mut verdicts = Vec::new();
            for lost_deg in [0.5, 1.5] {
                let joint = whole(&mut noise, 0, twin.robot.joints().len() - 1);
                let at = whole(&mut noise, 6, poses - 7);
                let mut campaign = campaign.clone();
                campaign.observations[at..].iter_mut().for_each(|o| o.joints[joint] -= f64::to_radians(lost_deg));
                let said = messages(&twin, &campaign);
                let found = said.iter().find(|m| ACCUSING[..3].contains(&&*m.id));
                let name = &twin.robot.joints()[joint].name;
                let is_right = found.is_some_and(|m| {
                    let is_near = |pose: usize| m.is(&m.id.clone(), &[("pose", &campaign.observations[pose].pose)]);
                    (at - 2..=at + 2).any(is_near) && m.what.contains(&format!("joint `{name}`"))
                });
                let is_found = found.is_some();
                if !is_right {
                    println!("{seed}, {name} by {lost_deg} deg from {at} on: {:?}", found.map(|m| &m.what));
                }
                verdicts.push((is_right, is_found && !is_right));
            }
            verdicts
        };
        let found: Vec<(bool, bool)> = (0..count).into_par_iter().flat_map_iter(one).collect();
        let [of, off] = [found.iter().filter(|f| f.0).count(), found.iter().filter(|f| f.1).count()];
        println!("{measured:?}, {poses} poses, misfit {ratio} × noise: {of} of {}, {off} wrong", found.len());
        (all, right, wrong) = (all + found.len(), right + of, wrong + off);
    }
    println!("{right} of {all} right, {wrong} wrong");
    assert!(100 * right >= 85 * all, "{right} of {all}");
    assert!(wrong == 0, "{wrong} of {all}");
}

/// Orientations that are off by 46 to 174 deg, and a position that is off by 30 mm: each is excluded by the misfit of its own quantity, and named
/// with its pose. Sound orientations stay.
#[test]
fn readings_of_every_quantity_are_excluded_by_the_misfit_of_their_own() {
    let (measured, seed) = (Measured::Poses, 910);
    let twin = Twin::drawn(measured, LEFT_OUT[1], 10.0, seed);
    let campaign = twin.observed(160, 1.0, &mut Noise::new(73, seed));
    let excluded = |campaign: &Campaign| {
        let Campaign { observations: calibration, settings } = campaign.clone();
        let calibration_conditions = settings.conditions.clone();
        let sets = Sets { calibration, calibration_conditions, ..Sets::default() };
        let solution = Solution::new(&twin.robot, Basis { sets, settings, ..Basis::default() }).expect("identified");
        solution.without_outliers(&twin.robot).expect("few outliers")
    };
    let (clean, _) = excluded(&campaign);
    let mut spoilt = campaign.clone();
    let mut names: Vec<String> = Vec::new();
    let off = [(7, 46.0), (19, 90.0), (33, 174.0)];
    for (k, degrees) in off {
        let c = &mut spoilt.settings.conditions[k];
        let pose = c.pose;
        let Kind::Orientation(observed) = &mut c.kind else { panic!("an orientation") };
        let by = Pose::identity().turn_x(f64::to_radians(degrees));
        observed.frame_T_body = observed.frame_T_body.then(&by);
        names.push(format!("deg in orientation ({}, pose {pose},", twin.robot.targets()[0]));
    }
    let seen = &mut spoilt.observations[11];
    seen.targets[0].as_mut().expect("measured")[2] += 30.0;
    names.push(format!("mm ({}, pose {},", twin.robot.targets()[0], seen.pose));
    let (found, said) = excluded(&spoilt);
    let text: String = said.iter().map(|m| format!("{m}\n")).collect();
    assert!(said.iter().all(|m| m.is("outliers-excluded", &[])), "{text}");
    for name in &names {
        assert!(text.contains(name), "{name}: {text}");
    }
    let conditions = |solution: &Solution| {
        let Basis { sets, settings, .. } = &solution.basis;
        assert_eq!(sets.calibration_conditions, settings.conditions);
        settings.conditions.len()
    };
    let all = campaign.settings.conditions.len();
    assert_eq!([conditions(&clean), conditions(&found)], [all, all - 3], "{text}");
    // what a wrong reading would leave
    let rms = |solution: &Solution| solution.found.residuals.conditions.iter().map(|c| c.rms).fold(0.0, f64::max);
    assert!(rms(&found) < 1.2 * rms(&clean), "{measured:?}: {} {}", rms(&found), rms(&clean));
}

/// Conventions of orientations compete with the mistakes of the joints on the same data.
#[test]
#[ignore = "a long law: make laws"]
fn a_convention_of_orientations_is_told_from_a_joint() {
    let twin = Twin::drawn(Measured::Poses, LEFT_OUT[1], 10.0, 900);
    let campaign = twin.observed(60, 1.0, &mut Noise::new(72, 1));
    let turned = |campaign: &Campaign, how: &dyn Fn(Pose) -> Pose| -> Vec<Option<Pose>> {
        let body = |kind: &Kind| if let Kind::Orientation(o) = kind { Some(how(o.frame_T_body)) } else { None };
        campaign.settings.conditions.iter().map(|c| body(&c.kind)).collect()
    };
    let negated = |pose: Pose| {
        let [x, y, z] = pose.rpy_rad();
        Pose::identity().turn_z(-z).turn_y(-y).turn_x(-x)
    };
    let inverse = |pose: Pose| pose.inverse();
    let readings = |campaign: &Campaign| {
        let named = |slip: &str, how: &dyn Fn(Pose) -> Pose| OrientationReading {
            what: phrase!("orientation-slip", slip, name = ""),
            bodies: turned(campaign, how),
        };
        vec![named("negated", &negated), named("inverse", &inverse)]
    };
    let judged = |campaign: &Campaign| {
        let found = judge(&twin.robot, &campaign.observations, &campaign.settings, &readings(campaign));
        found.named.map(|found| found.changes[0].0.clone())
    };
    assert_eq!(judged(&campaign), None);
    for (slip, how) in [("negated", &negated as &dyn Fn(Pose) -> Pose), ("inverse", &inverse)] {
        let mut changed = campaign.clone();
        let bodies = turned(&campaign, how);
        for (c, body) in changed.settings.conditions.iter_mut().zip(bodies) {
            if let Kind::Orientation(o) = &mut c.kind {
                o.frame_T_body = body.expect("an orientation");
            }
        }
        assert_eq!(judged(&changed), Some(phrase!("orientation-slip", slip, name = "")));
    }
    let mut reversed = campaign.clone();
    change_joints(&mut reversed, &|q| q[4] += 90f64.to_radians());
    let name = format!("`{}`", twin.robot.joints()[4].name);
    assert_eq!(judged(&reversed), Some(phrase!("slip-offset", degrees = "-90", joint = name)));
}
