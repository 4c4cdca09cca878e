//! Tables of a test of poses: read, compensated for the drift of the set-up, and evaluated.

use crate::stages::table_file::{CampaignTables, TableFile};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::{error, phrase, warning};
use etalon_campaign::{PosesDefinition, TableDefinition};
use etalon_documents::{Iso9283Document, Iso9283Epoch, Iso9283Visit, SourceKind};
use etalon_formats::tables::pose_test::pose_test;
use etalon_formats::tables::reference_targets::{SetupDrift, compensate_setup_drift};
use etalon_standards::iso9283::pose::PoseTestSettings;
use etalon_standards::iso9283::pose::drift::drifts;
use etalon_standards::iso9283::pose::rotations::RotationOrder;
use etalon_standards::iso9283::pose::test::{AttainedPose, PoseTest, TestedPose};

/// Tables of a test of poses: attained poses, commanded poses, and stationary targets.
pub(crate) struct PoseTables {
    attained: TableFile,
    commanded: Option<TableFile>,
    reference: Option<TableFile>,
}

/// A test of poses, compensated for the drift of the set-up if it has reference targets.
#[derive(Clone, Debug)]
pub(crate) struct PreparedTest {
    test: PoseTest,
    drift: SetupDrift,
}

impl PoseTables {
    /// Tables that have been read before.
    pub fn new(attained: TableFile, commanded: Option<TableFile>, reference: Option<TableFile>) -> Self {
        Self { attained, commanded, reference }
    }

    /// Tables of a campaign; all unreadable tables are reported.
    pub fn from_campaign(files: &mut CampaignTables, definition: &PosesDefinition) -> Result<Self> {
        if let Some(key) = definition.layout.form.meaningless_beside_sheet() {
            let place = files.campaign.key_place(&["poses", key]);
            return Err(error!("key-of-text-table", key).at(place).into());
        }
        let mut problems = Problems::default();
        let mut read = |table: &TableDefinition, holds: Phrase, attained: bool| {
            let table = files.read_in(table, &definition.reading(attained), SourceKind::Table, holds);
            table.map_err(|more| problems.0.extend(more.0)).ok()
        };
        let attained = read(&definition.attained, phrase!("table-of-attained-poses"), true);
        let commanded = read(&definition.commanded, phrase!("table-of-commanded-poses"), false);
        let reference = definition.reference.as_ref();
        let reference = reference.map(|file| read(file, phrase!("table-of-reference-targets"), false));
        let (Some(attained), Some(commanded)) = (attained, commanded) else { return Err(problems) };
        problems.check()?;
        Ok(Self { attained, commanded: Some(commanded), reference: reference.flatten() })
    }

    /// The test in these tables; all errors in them are reported with their lines.
    pub fn test(&self, order: Option<RotationOrder>) -> Result<PreparedTest> {
        let (attained, commanded) = (&self.attained, self.commanded.as_ref());
        let in_texts = |problems: Problems| {
            let problems = attained.place(problems);
            if let Some(commanded) = commanded { commanded.place(problems) } else { problems }
        };
        let mut test = pose_test(&attained.table, commanded.map(|file| &file.table), order).map_err(in_texts)?;
        test.settle_solutions();
        let drift = match &self.reference {
            None => SetupDrift::default(),
            Some(targets) => {
                let before_mm = scatter_mm(&test);
                let drift = compensate_setup_drift(&mut test, &targets.table).map_err(|p| targets.place(p))?;
                test.warnings.extend(worse(before_mm, scatter_mm(&test)));
                drift
            }
        };
        Ok(PreparedTest { test, drift })
    }
}

/// Order of the rotations a, b, c in a text like `Rz(c) Ry(b) Rx(a)`.
///
/// # Errors
/// Fails for other texts, and for orders that do not reach every orientation.
pub(crate) fn parse_order(text: &str) -> Result<RotationOrder> {
    let hint = order_hint(text);
    Ok(RotationOrder::parse(text).ok_or_else(|| error!("rotation-order-unknown", text).hint(hint))?)
}

/// Hint for an order that does not read. Names of `orientation`, such as `zyx`, give the axes of
/// the first, second and third angle; by ISO 9283 the angles a, b, c are about x, y, z.
fn order_hint(text: &str) -> Phrase {
    let name = text.trim().to_lowercase();
    let axes: Vec<char> = name.trim_start_matches("fixed ").chars().filter(|c| "xyz".contains(*c)).collect();
    let Ok([i, j, k]) = <[char; 3]>::try_from(axes) else { return phrase!("rotation-orders") };
    let by_place = match name.starts_with("fixed ") {
        true => format!("R{k}(c) R{j}(b) R{i}(a)"),
        false => format!("R{i}(a) R{j}(b) R{k}(c)"),
    };
    let letter = |axis: char| ['a', 'b', 'c'][['x', 'y', 'z'].iter().position(|other| *other == axis).unwrap_or(0)];
    let by_axis = [i, j, k].map(|axis| format!("R{axis}({})", letter(axis))).join(" ");
    let orders = [by_axis, by_place].map(|order| (RotationOrder::parse(&order).is_some(), order));
    match orders {
        [(true, by_axis), (true, by_place)] => phrase!("rotation-orders-of-axes", by_axis, by_place),
        _ => phrase!("rotation-orders"),
    }
}

/// Root mean square distance of attained positions from the mean of their pose, mm.
fn scatter_mm(test: &PoseTest) -> f64 {
    let (mut squares, mut count) = (0.0, 0.0);
    for pose in &test.poses {
        let attained: Vec<Vector> = pose.attained.iter().map(|v| v.position_mm).collect();
        let Some(middle) = centroid(&attained) else { continue };
        squares += attained.iter().map(|p| norm(minus(*p, middle)).powi(2)).sum::<f64>();
        count += attained.len() as f64;
    }
    (squares / f64::max(count, 1.0)).sqrt()
}

/// Maximum increase of the scatter of poses by a compensation that follows the set-up.
const WORSE: f64 = 1.1;

/// Returns a warning if the compensation of the set-up's drift increases the scatter of poses.
fn worse(before_mm: f64, after_mm: f64) -> Option<Message> {
    (after_mm > WORSE * before_mm).then(|| warning!("compensation-scatters", before_mm, after_mm))
}

/// Maximum change of the shape of the reference targets, in expanded uncertainties, without a wrong
/// measurement.
const MISSHAPEN: f64 = 2.0;

/// Returns a warning if the relative positions of reference targets have changed.
fn misshapen(epoch: &Iso9283Epoch, expanded_mm: f64) -> Option<Message> {
    let Iso9283Epoch { cycle, rms_mm, .. } = epoch;
    (*rms_mm > MISSHAPEN * expanded_mm).then(|| warning!("reference-targets-misshapen", cycle, rms_mm, expanded_mm))
}

impl PreparedTest {
    /// All characteristics.
    pub fn evaluate(&self, settings: &PoseTestSettings) -> Result<Iso9283Document> {
        let Self { test, drift } = self;
        let mut document = Iso9283Document::evaluate(test, settings)?;
        document.frame = Some(phrase!("frame-of-tables").into());
        if !drift.epochs.is_empty() {
            document.frame = Some(phrase!("frame-of-reference-targets").into());
            let convention = match (drift.turned, test.angles.is_empty()) {
                (true, _) => phrase!("convention-drift-compensated"),
                (false, true) => phrase!("convention-positions-drift-compensated"),
                (false, false) => phrase!("convention-angles-not-drift-compensated"),
            };
            document.agree(convention);
        }
        document.recorded.reference.clone_from(&drift.epochs);
        let epochs = drift.epochs.iter();
        document.messages.extend(epochs.filter_map(|e| misshapen(e, settings.expanded_uncertainty_mm?)));
        Ok(document)
    }

    /// Checks that there are enough cycles for the drift over sets of this size.
    pub fn drifts(&self, set: usize) -> Result<()> {
        drifts(&self.test, set).map(|_| ())
    }

    /// Every attained pose, pose by pose.
    pub fn visits(&self) -> Vec<Iso9283Visit> {
        let of_pose = |p: &TestedPose| {
            let pose = p.pose;
            let visit = move |v: &AttainedPose| Iso9283Visit {
                pose,
                cycle: v.cycle,
                approach: v.approach.clone(),
                attained_mm: v.position_mm,
            };
            p.attained.iter().map(visit).collect::<Vec<_>>()
        };
        self.test.first_robot_test().poses.iter().flat_map(of_pose).collect()
    }
}
