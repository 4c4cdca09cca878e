//! Visited poses: table 2.1 of the thesis, uncertainty of RP, the 25 % rule, approaches,
//! coplanarity.

use crate::model::{Block, Cell, Columns, Section, Table, Text, fixed, numbers, strong_term, term, um};
use crate::number;
use crate::plots::multiples;
use crate::plots::visits::{self, Approaches, pose_visits};
use crate::words::{Words, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{Vector, centroid, minus};
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use etalon_documents::{
    Characteristics, Conformity, Iso9283Approach, Iso9283Document, Iso9283Ellipsoid, Iso9283Interval,
    Iso9283OutOfPlane, Iso9283Pose, Iso9283Variation, Iso9283Visit, PoseCharacteristic,
};

pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.poses.as_ref()?;
    let poses = named(document, words);
    let mut section = Section::new("repeatability", tr!(words, "repeatability-title"));
    let conventions: Vec<&str> = document.conventions.iter().map(Worded::english).collect();
    section.summarise(tr!(words, "conventions"), conventions.join("; "), "");
    section.figures(multiples::picture(document, words));
    let note = tr!(words, "definition-rp");
    section.table(tr!(words, "uncertainty-of-rp"), note, intervals(&poses, words));
    section.blocks.extend(unknown_approaches(document, words));
    let rule = quarter_rule(&poses, words);
    if !rule.is_empty() {
        // the verdict has the sentence
        section.table(tr!(words, "instrument-good-enough"), tr!(words, "definition-quarter-rule"), rule);
    }
    let all = Table::new(words, &poses, columns(words).in_workbook()).on(phrase!("sheet-iso9283-poses"));
    section.push(Block::Table(all.without_empty_columns()));
    section.table("vAP", tr!(words, "definition-vap"), variation(document, words));
    section.push(Block::Aside { title: tr!(words, "by-approach"), blocks: approach_tables(document, words) });
    let frame = document.frame.iter().map(|frame| tr!(words, "frame-sentence", frame = words.worded(frame)));
    let figures = Block::Figures { figures: visits::pictures(document, words) };
    let blocks = frame.map(Block::note).chain([figures]).collect();
    section.push(Block::Aside { title: tr!(words, "visits-by-plane"), blocks });
    let details = vec![
        Block::note(Text::conventions(&document.conventions, words)),
        Block::Table(spheres(&poses, words).detail()),
    ];
    section.push(Block::Aside { title: tr!(words, "spheres-and-conventions"), blocks: details });
    section.table(tr!(words, "coplanarity"), "", coplanarity(document, words));
    section.push(Block::Table(robot_characteristics(document, words)));
    section.push(Block::Table(attained(document, words)));
    section.on_terminal().whole()
}

/// Distances of the mean positions of four poses from the plane of the other three.
pub(super) fn coplanarity(document: &Iso9283Document, words: &Words) -> Table {
    let columns = Columns::<Iso9283OutOfPlane>::new().page(phrase!("pose"), "", |p| p.pose).page(
        phrase!("coplanarity-of-pose"),
        "µm",
        |p| um(p.distance_mm),
    );
    Table::new(words, &document.robot.coplanarity_of_four, columns)
}

/// Angles of a pose, in order.
const ANGLES: [&str; 3] = ["a", "b", "c"];

/// Measured angles of the poses, in order.
pub(super) fn angles(document: &Iso9283Document) -> Vec<&'static str> {
    let of: [fn(&Iso9283Pose) -> Option<f64>; 3] = [|p| p.ap_a_deg, |p| p.ap_b_deg, |p| p.ap_c_deg];
    let has = |angle: &fn(&Iso9283Pose) -> Option<f64>| document.poses.iter().any(|p| angle(p).is_some());
    ANGLES.into_iter().zip(&of).filter(|(_, angle)| has(angle)).map(|(name, _)| name).collect()
}

/// Interval (µm).
pub(super) fn interval(of: Option<Iso9283Interval>, words: &Words) -> Cell {
    let um = |mm: f64| number::fixed(1e3 * mm, 1);
    numbers(of.map(|i| tr!(words, "range", from = um(i.low_mm), to = um(i.high_mm))))
}

/// Conformity with a given limit, by the interval.
pub(super) fn conformity(of: Option<Conformity>, words: &Words) -> Cell {
    of.map_or(Cell::Missing, |c| match c {
        Conformity::Conforming => term(words, phrase!("conforming")),
        Conformity::NotConforming => strong_term(words, phrase!("not-conforming")),
        Conformity::Neither | Conformity::NotAssessable => term(words, phrase!("undecided")),
    })
}

/// A pose with its number, or homing with its name, and the visits that are judged.
pub(super) struct Named<'a> {
    pub name: Cell,
    pub pose: &'a Iso9283Pose,
    pub ap: JudgedVisits,
    pub rp: JudgedVisits,
    /// 25 % rule of each characteristic.
    pub rules: Vec<QuarterRule>,
}

/// Visits to which interval and verdict of a characteristic apply.
pub(super) struct JudgedVisits {
    /// Value of the characteristic (mm).
    pub value_mm: Option<f64>,
    /// Number of visits.
    pub visits: usize,
    /// Approach, if the visits of the pose come from several.
    pub approach: Option<String>,
    /// Mean minus commanded position.
    pub deviation_mm: [Option<f64>; 3],
    /// RP of these visits without the instrument's noise (mm).
    rp_without_noise_mm: Option<f64>,
    /// Ellipsoid of these visits.
    ellipsoid: Option<Iso9283Ellipsoid>,
}

/// 25 % rule of a characteristic of a pose. If visits come from several approaches, it applies to
/// the approach with the smallest value.
pub(super) struct QuarterRule {
    symbol: &'static str,
    approach: Option<String>,
    /// Expanded uncertainty of a position (mm).
    expanded_mm: f64,
    /// Expanded uncertainty over the characteristic; `None` if the characteristic is zero.
    ratio: Option<f64>,
}

impl QuarterRule {
    /// Rules of a pose; empty if the uncertainty of the instrument is unknown.
    fn all(pose: &Iso9283Pose, approaches: Approaches) -> Vec<Self> {
        let Some(expanded_mm) = pose.expanded_uncertainty_mm() else { return Vec::new() };
        let measured = PoseCharacteristic::ALL.into_iter().filter(|of| (of.value)(pose).is_some());
        let rule = |of: PoseCharacteristic| Self {
            symbol: of.symbol,
            approach: (of.smallest)(pose).map(|smallest| approaches.name(&smallest.name)),
            expanded_mm,
            ratio: (of.uncertainty_ratio)(pose),
        };
        measured.map(rule).collect()
    }
}

impl JudgedVisits {
    fn new(characteristic: PoseCharacteristic, pose: &Iso9283Pose, document: &Iso9283Document, words: &Words) -> Self {
        let value_mm = (characteristic.value)(pose);
        let all = [pose.ap_x_mm, pose.ap_y_mm, pose.ap_z_mm];
        let Some(judged) = (characteristic.approach)(pose) else {
            return Self {
                value_mm,
                visits: pose.cycles,
                approach: None,
                deviation_mm: all,
                rp_without_noise_mm: pose.rp_without_noise_mm,
                ellipsoid: pose.ellipsoid,
            };
        };
        let of_pose = document.approaches.iter().filter(|v| v.pose == pose.pose).flat_map(|v| &v.approaches);
        let deviation = of_pose.filter(|a| a.name == judged.name).find_map(|a| a.deviation_mm);
        // coordinates that the robot does not have are absent
        let deviation_mm = [0, 1, 2].map(|axis| deviation.map(|d| d[axis]).filter(|_| all[axis].is_some()));
        let approach = Some(Approaches::new(document, words).name(&judged.name));
        Self {
            value_mm,
            visits: judged.cycles,
            approach,
            deviation_mm,
            rp_without_noise_mm: judged.rp_without_noise_mm,
            ellipsoid: judged.ellipsoid,
        }
    }

    /// Name of the approach.
    pub fn approach(&self) -> Cell {
        approach(self.approach.as_deref())
    }
}

/// Name of an approach.
fn approach(name: Option<&str>) -> Cell {
    name.map_or(Cell::Missing, |name| Text::name(name).into())
}

/// Poses of a document, and homing.
pub(super) fn named<'a>(document: &'a Iso9283Document, words: &Words) -> Vec<Named<'a>> {
    let judged = |name: Cell, pose: &'a Iso9283Pose| Named {
        name,
        pose,
        ap: JudgedVisits::new(PoseCharacteristic::AP, pose, document, words),
        rp: JudgedVisits::new(PoseCharacteristic::RP, pose, document, words),
        rules: QuarterRule::all(pose, Approaches::new(document, words)),
    };
    let poses = document.poses.iter().map(|pose| judged(pose.pose.into(), pose));
    let homing = document.robot.homing.iter().map(|pose| judged(term(words, phrase!("report-homing")), pose));
    poses.chain(homing).collect()
}

/// Table 2.1 of the thesis.
fn spheres(poses: &[Named], words: &Words) -> Table {
    let columns = Columns::<Named>::new()
        .page(phrase!("pose"), "", |n| n.name.clone())
        .page(phrase!("visits"), "", |n| n.pose.cycles)
        .page(phrase!("sphere-x-y-z"), "", |n| um(n.pose.enclosing_radius_mm))
        .page(phrase!("circle-x-y"), "", |n| um(n.pose.enclosing_circle_radius_mm))
        .below(2, phrase!("smallest-sphere-and-circle"))
        .page(phrase!("x-y-z-rp"), "", |n| um(n.pose.rp_mm))
        .page("x, y", "", |n| um(n.pose.rp_xy_mm))
        .page("x", "", |n| um(n.pose.rp_along_x_mm))
        .page("y", "", |n| um(n.pose.rp_along_y_mm))
        .page("z", "", |n| um(n.pose.rp_along_z_mm))
        .below(5, phrase!("mean-plus-3s-of-distance"));
    Table::new(words, poses, columns)
}

/// RP with its intervals and further assessments.
pub(super) fn intervals(poses: &[Named], words: &Words) -> Table {
    let axes = |n: &Named| {
        let um = |mm: f64| number::fixed(1e3 * mm, 1);
        numbers(n.rp.ellipsoid.map(|e| e.semi_axes_mm.map(um).join(" × ")))
    };
    let columns = Columns::<Named>::new()
        .page(phrase!("pose"), "", |n| n.name.clone())
        .page(phrase!("approached"), "", |n| n.rp.approach())
        .page(phrase!("visits"), "", |n| n.rp.visits)
        .page("RP", "µm", |n| um(n.rp.value_mm))
        .page("95 %", "µm", |n| interval(n.pose.rp_interval, words))
        .page(phrase!("rp-without-noise"), "µm", |n| um(n.rp.rp_without_noise_mm))
        .page(phrase!("ellipsoid-semi-axes"), "µm", axes)
        .page(phrase!("verdict"), "", |n| conformity(n.pose.rp_conformity, words))
        .decisive();
    let known = poses.iter().filter(|n| n.pose.rp_interval.is_some());
    Table::new(words, known, columns).without_empty_columns()
}

/// Table of the 25 % rule by pose and characteristic.
pub(super) fn quarter_rule(poses: &[Named], words: &Words) -> Table {
    struct Row<'a> {
        name: &'a Cell,
        rule: &'a QuarterRule,
    }
    let rows: Vec<Row> = poses.iter().flat_map(|n| n.rules.iter().map(|rule| Row { name: &n.name, rule })).collect();
    let value_mm = |rule: &QuarterRule| rule.ratio.map_or(0.0, |ratio| rule.expanded_mm / ratio);
    let is_met = |rule: &QuarterRule| rule.ratio.is_some_and(|ratio| ratio <= QUARTER);
    let columns = Columns::<Row>::new()
        .page(phrase!("pose"), "", |r| r.name.clone())
        .page(phrase!("head-characteristic"), "", |r| r.rule.symbol)
        .page(phrase!("approached"), "", |r| approach(r.rule.approach.as_deref()))
        .page(phrase!("value"), "µm", move |r| um(value_mm(r.rule)))
        .page(phrase!("u-of-position"), "µm", |r| um(r.rule.expanded_mm))
        .page(phrase!("u-over-value"), "", |r| match r.rule.ratio {
            Some(ratio) => fixed(ratio, 2),
            None => term(words, phrase!("nothing-to-verify")),
        })
        .page(phrase!("u-allowed"), "µm", move |r| um(QUARTER * value_mm(r.rule)))
        .page(phrase!("quarter-rule"), "", move |r| {
            term(words, if is_met(r.rule) { phrase!("met") } else { phrase!("not-met") })
        });
    Table::new(words, &rows, columns).without_empty_columns()
}

/// Notes on visits without a known approach at poses with several approaches: values of one
/// approach do not contain these visits.
pub(super) fn unknown_approaches(document: &Iso9283Document, words: &Words) -> Vec<Block> {
    let note = |v: &Iso9283Variation| {
        let unknown: Vec<&Iso9283Visit> =
            pose_visits(document, v.pose).filter(|visit| visit.approach.is_none()).collect();
        let cycles: Vec<String> = unknown.iter().take(CYCLES).map(|visit| visit.cycle.to_string()).collect();
        let (count, pose) = (unknown.len(), v.pose);
        (count > 0).then(|| Block::text(tr!(words, "approaches-unknown", count, pose, cycles = cycles.join(", "))))
    };
    document.approaches.iter().filter(|v| v.approaches.len() > 1).filter_map(note).collect()
}

/// Largest permissible ratio of the measurement uncertainty to a characteristic (ISO 9283:1998, 6).
const QUARTER: f64 = 0.25;
/// Maximum number of cycles that a sentence lists.
const CYCLES: usize = 5;

/// Sentence on the 25 % rule.
pub(super) fn quarter_sentence(document: &Iso9283Document, words: &Words) -> String {
    let of =
        |met: bool| document.poses.iter().filter(move |p| p.quarter_rule_met == Some(met)).map(|p| p.pose.to_string());
    let (met, missed): (Vec<String>, Vec<String>) = (of(true).collect(), of(false).collect());
    let tested = match document.poses.iter().any(|p| p.ap_mm.is_some()) {
        true => "accuracy",
        false => "repeatability",
    };
    let sentence = match (met.is_empty(), missed.is_empty()) {
        (true, true) => return String::new(),
        (_, true) => tr!(words, "instrument-good-for-all", tested),
        (true, _) => tr!(words, "instrument-good-for-none", tested),
        _ => tr!(words, "instrument-good-for-some", tested, good = met.join(", "), poor = missed.join(", ")),
    };
    // the rule of 25 % is applied to positions
    match document.poses.iter().any(|p| p.rp_a_deg.is_some()) {
        true => format!("{sentence} {}", tr!(words, "orientations-without-quarter-rule")),
        false => sentence,
    }
}

/// All columns of poses for the workbook; pages show some of them.
pub(super) fn columns<'a>(words: &'a Words) -> Columns<'a, Named<'a>> {
    let proved = |c: Option<Conformity>| {
        c.map(|c| match c {
            Conformity::Conforming => term(words, phrase!("conformity-proved")),
            Conformity::NotConforming => term(words, phrase!("conformity-disproved")),
            Conformity::Neither | Conformity::NotAssessable => term(words, phrase!("conformity-neither")),
        })
    };
    Columns::<Named>::new()
        .both(phrase!("pose"), "", |n| n.name.clone())
        .both(phrase!("visits"), "", |n| n.pose.cycles)
        .micrometres("AP", |n| n.pose.ap_mm)
        .micrometres("AP x", |n| n.pose.ap_x_mm)
        .micrometres("AP y", |n| n.pose.ap_y_mm)
        .micrometres("AP z", |n| n.pose.ap_z_mm)
        .micrometres("RP", |n| n.pose.rp_mm)
        .sheet(phrase!("rp-interval-from"), "mm", |n| n.pose.rp_interval.map(|i| i.low_mm))
        .sheet(phrase!("rp-interval-to"), "mm", |n| n.pose.rp_interval.map(|i| i.high_mm))
        .sheet(phrase!("rp-of-judged-approach"), "mm", |n| n.pose.rp_approach.as_ref().map(|a| a.value_mm))
        .sheet(phrase!("ap-of-judged-approach"), "mm", |n| n.pose.ap_approach.as_ref().map(|a| a.value_mm))
        .micrometres(phrase!("rp-without-noise"), |n| n.pose.rp_without_noise_mm)
        .sheet(phrase!("rp-in-plane"), "mm", |n| n.pose.rp_xy_mm)
        .sheet(phrase!("rp-along-x"), "mm", |n| n.pose.rp_along_x_mm)
        .sheet(phrase!("rp-along-y"), "mm", |n| n.pose.rp_along_y_mm)
        .sheet(phrase!("rp-along-z"), "mm", |n| n.pose.rp_along_z_mm)
        .sheet(phrase!("three-s-of-x"), "mm", |n| n.pose.rp_x_mm)
        .sheet(phrase!("three-s-of-y"), "mm", |n| n.pose.rp_y_mm)
        .sheet(phrase!("three-s-of-z"), "mm", |n| n.pose.rp_z_mm)
        .sheet(phrase!("mean-distance-from-barycentre"), "mm", |n| n.pose.mean_radius_mm)
        .sheet(phrase!("deviation-of-mean-value"), "mm", |n| n.pose.sd_radius_mm)
        .sheet(phrase!("enclosing-sphere-radius"), "mm", |n| n.pose.enclosing_radius_mm)
        .sheet(phrase!("enclosing-circle-radius"), "mm", |n| n.pose.enclosing_circle_radius_mm)
        .sheet(phrase!("ap-interval-from"), "mm", |n| n.pose.ap_interval.map(|i| i.low_mm))
        .sheet(phrase!("ap-interval-to"), "mm", |n| n.pose.ap_interval.map(|i| i.high_mm))
        .both("AP a", "deg", |n| fixed(n.pose.ap_a_deg, 4))
        .both("AP b", "deg", |n| fixed(n.pose.ap_b_deg, 4))
        .both("AP c", "deg", |n| fixed(n.pose.ap_c_deg, 4))
        .both("RP a", "deg", |n| fixed(n.pose.rp_a_deg, 4))
        .both("RP b", "deg", |n| fixed(n.pose.rp_b_deg, 4))
        .both("RP c", "deg", |n| fixed(n.pose.rp_c_deg, 4))
        .both("AP rx", "deg", |n| fixed(n.pose.ap_rotation_deg.map(|v| v[0]), 4))
        .both("AP ry", "deg", |n| fixed(n.pose.ap_rotation_deg.map(|v| v[1]), 4))
        .both("AP rz", "deg", |n| fixed(n.pose.ap_rotation_deg.map(|v| v[2]), 4))
        .both("RP rx", "deg", |n| fixed(n.pose.rp_rotation_deg.map(|v| v[0]), 4))
        .both("RP ry", "deg", |n| fixed(n.pose.rp_rotation_deg.map(|v| v[1]), 4))
        .both("RP rz", "deg", |n| fixed(n.pose.rp_rotation_deg.map(|v| v[2]), 4))
        .sheet(phrase!("noise-of-reading-x"), "mm", |n| n.pose.noise_mm.map(|n| n[0]))
        .sheet(phrase!("noise-of-reading-y"), "mm", |n| n.pose.noise_mm.map(|n| n[1]))
        .sheet(phrase!("noise-of-reading-z"), "mm", |n| n.pose.noise_mm.map(|n| n[2]))
        .sheet(phrase!("ellipsoid-semi-axis-1"), "mm", |n| n.pose.ellipsoid.map(|e| e.semi_axes_mm[0]))
        .sheet(phrase!("ellipsoid-semi-axis-2"), "mm", |n| n.pose.ellipsoid.map(|e| e.semi_axes_mm[1]))
        .sheet(phrase!("ellipsoid-semi-axis-3"), "mm", |n| n.pose.ellipsoid.map(|e| e.semi_axes_mm[2]))
        .sheet(phrase!("ap-within-limit"), "", move |n| proved(n.pose.ap_conformity))
        .sheet(phrase!("rp-within-limit"), "", move |n| proved(n.pose.rp_conformity))
        .sheet(phrase!("u-over-ap"), "", |n| n.pose.uncertainty_over_ap)
        .sheet(phrase!("u-over-rp"), "", |n| n.pose.uncertainty_over_rp)
        .sheet(phrase!("quarter-rule"), "", |n| n.pose.quarter_rule_met.map(|met| if met { "met" } else { "not met" }))
}

/// An approach of a pose, and the mean of all visits of the pose, if known.
struct OfApproach<'a> {
    pose: PoseName,
    approach: &'a Iso9283Approach,
    middle: Option<Vector>,
    spatial: bool,
}

/// vAP of each pose, and the approaches with the largest distance.
pub(super) fn variation(document: &Iso9283Document, words: &Words) -> Table {
    let named = Approaches::new(document, words);
    let between = move |v: &Iso9283Variation, i: usize| Text::name(&named.name(&v.between[i]));
    let columns = Columns::<Iso9283Variation>::new()
        .both(phrase!("pose"), "", |v| v.pose)
        .micrometres("vAP", |v| v.vap_mm)
        .page(phrase!("head-between"), "", move |v| between(v, 0))
        .page(phrase!("head-and"), "", move |v| between(v, 1))
        .sheet(phrase!("head-between"), "", |v| v.between[0].as_str())
        .sheet(phrase!("head-and"), "", |v| v.between[1].as_str())
        .sheet_xyz(["a", "b", "c"].map(|axis| phrase!("angle-vap", axis)), "deg", |v| &v.vap_angles_deg)
        .both("vAP r", "deg", |v| fixed(v.vap_rotation_deg, 4));
    Table::new(words, &document.approaches, columns).on(phrase!("sheet-iso9283-variation")).without_empty_columns()
}

/// Tables of the approaches, and of vAP of the angles.
pub(super) fn approach_tables(document: &Iso9283Document, words: &Words) -> Vec<Block> {
    if document.approaches.is_empty() {
        return Vec::new();
    }
    vec![Block::Table(approaches(document, words).detail()), Block::Table(turned(document, words))]
}

fn approaches(document: &Iso9283Document, words: &Words) -> Table {
    let mut rows = Vec::new();
    for v in &document.approaches {
        let all: Vec<Vector> = pose_visits(document, v.pose).map(|v| v.attained_mm).collect();
        let middle = v.mean_mm.or_else(|| centroid(&all));
        let spatial = document.poses.iter().any(|p| p.pose == v.pose && p.rp_z_mm.is_some());
        rows.extend(v.approaches.iter().map(|approach| OfApproach { pose: v.pose, approach, middle, spatial }));
    }
    let named = Approaches::new(document, words);
    let off = |r: &OfApproach, axis: usize| r.middle.map(|middle| um(minus(r.approach.mean_mm, middle)[axis]));
    let columns = Columns::<OfApproach>::new()
        .both(phrase!("pose"), "", |r| r.pose)
        .page(phrase!("approached"), "", move |r| Text::name(&named.name(&r.approach.name)))
        .sheet(phrase!("approached"), "", |r| r.approach.name.as_str())
        .both(phrase!("visits"), "", |r| r.approach.cycles)
        .page("x", "", move |r| off(r, 0))
        .page("y", "", move |r| off(r, 1))
        .page("z", "", move |r| off(r, 2).filter(|_| r.spatial))
        .below(3, phrase!("mean-from-overall-mean"))
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-mean", axis)), "mm", |r| &r.approach.mean_mm)
        .micrometres("RP", |r| r.approach.rp_mm)
        .micrometres(phrase!("enclosing-sphere-radius"), |r| r.approach.enclosing_radius_mm);
    Table::new(words, &rows, columns).on(phrase!("sheet-iso9283-approaches"))
}

/// Table of vAP of the angles, if measured.
fn turned(document: &Iso9283Document, words: &Words) -> Table {
    let titles: Vec<String> = angles(document).iter().map(|a| format!("vAP {a}")).collect();
    if titles.is_empty() {
        return Table::default();
    }
    let columns = Columns::<Iso9283Variation>::new().page(phrase!("pose"), "", |v| v.pose);
    let columns = columns.page_angles(&titles, |v| &v.vap_angles_deg);
    Table::new(words, &document.approaches, columns)
}

/// A characteristic of the whole robot.
struct Whole {
    what: Phrase,
    pose: Option<PoseName>,
    mm: f64,
}

fn robot_characteristics(document: &Iso9283Document, words: &Words) -> Table {
    let one = |what, pose, mm| Whole { what, pose, mm };
    let mut rows = Vec::new();
    rows.extend(document.robot.exchangeability_mm.map(|v| one(phrase!("head-exchangeability"), None, v)));
    rows.extend(document.robot.coplanarity_mm.map(|v| one(phrase!("coplanarity-peak-to-valley"), None, v)));
    let four = document.robot.coplanarity_of_four.iter();
    rows.extend(four.map(|p| one(phrase!("mean-from-plane"), Some(p.pose), p.distance_mm)));
    let columns = Columns::<Whole>::new()
        .sheet(phrase!("head-characteristic"), "", |r| term(words, r.what.clone()))
        .sheet(phrase!("pose"), "", |r| r.pose)
        .sheet(phrase!("value"), "mm", |r| r.mm);
    Table::new(words, &rows, columns).on(phrase!("sheet-iso9283-robot"))
}

fn attained(document: &Iso9283Document, words: &Words) -> Table {
    let columns = Columns::<Iso9283Visit>::new()
        .sheet(phrase!("pose"), "", |v| v.pose)
        .sheet(phrase!("cycle"), "", |v| v.cycle)
        .sheet(phrase!("approached"), "", |v| v.approach.as_deref())
        .sheet_xyz(["x", "y", "z"], "mm", |v| &v.attained_mm);
    Table::new(words, &document.recorded.visits, columns).on(phrase!("sheet-iso9283-visits"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo_iso9283::{iso9283, whole};

    /// Texts of the rows of a table.
    fn rows(table: &Table) -> Vec<String> {
        let page = serde_json::to_value(table).unwrap();
        page["rows"].as_array().unwrap().iter().map(ToString::to_string).collect()
    }

    /// Pose 1 has two approaches, pose 2 has one.
    #[test]
    fn a_row_of_one_approach_has_the_ellipsoid_of_its_visits() {
        let (tested, words) = (whole(), Words::default());
        let found = rows(&intervals(&named(tested.poses.as_ref().unwrap(), &words), &words));
        let (all, of_approach) = ("17.0 × 9.0 × 6.0", "14.2 × 8.3 × 5.5");
        assert!(found[0].contains(of_approach) && !found[0].contains(all), "{found:?}");
        assert!(found[0].contains("10.7") && !found[0].contains("20.1"), "{found:?}");
        assert!(found[1].contains(all) && found[1].contains("20.1"), "{found:?}");
    }

    /// RP of the judged approach is 11.1 µm, and RP of the other one 10.9 µm.
    #[test]
    fn the_quarter_rule_has_the_approach_with_the_smallest_value() {
        let words = Words::default();
        let found = rows(&quarter_rule(&named(&iso9283(), &words), &words));
        let [several, one] = &found[..] else { panic!("{found:?}") };
        for part in ["from pose 3", "10.9", "2.7", "0.25"] {
            assert!(several.contains(part), "{part}: {several}");
        }
        assert!(!several.contains("from pose 2") && !several.contains("11.1"), "{several}");
        assert!(!one.contains("from pose") && one.contains("21.7") && one.contains("0.12"), "{one}");
        // a characteristic of zero verifies nothing
        let mut document = iso9283();
        document.poses[0].uncertainty_over_rp = None;
        let found = rows(&quarter_rule(&named(&document, &words), &words));
        let (nothing, not_met) = (tr!(words, "nothing-to-verify"), tr!(words, "not-met"));
        assert!(found[0].contains(&nothing) && found[0].contains(&not_met), "{found:?}");
    }

    /// The first visit of the demo has no approach.
    #[test]
    fn a_visit_without_approach_is_named() {
        let (mut document, words) = (iso9283(), Words::default());
        let text = |document: &Iso9283Document| {
            serde_json::to_string(&unknown_approaches(document, &Words::default())).unwrap()
        };
        let expected = tr!(words, "approaches-unknown", count = 1, pose = 1, cycles = "1");
        assert!(text(&document).contains(&expected), "{}", text(&document));
        document.recorded.visits[0].approach = Some("from pose 2".to_owned());
        assert_eq!(text(&document), "[]");
    }
}
