//! Errors as a table: the file `residuals` of an output folder.

use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_documents::{ErrorQuantity, PointError, PoseSet, ReadingReliability};
use etalon_formats::table::{self, XYZ};
use polars::prelude::{Column, DataFrame};

/// The errors as a table: `set pose cycle target x_mm y_mm z_mm before_* after_*`, the columns
/// `joints`, `own_redundancy`, and `redundancy w detectable_mm`.
pub fn to_table(errors: &[PointError], joints: &[String]) -> Result<DataFrame> {
    let text =
        |name: &str, f: fn(&PointError) -> &str| Column::new(name.into(), errors.iter().map(f).collect::<Vec<_>>());
    let whole =
        |name: &str, f: fn(&PointError) -> i64| Column::new(name.into(), errors.iter().map(f).collect::<Vec<_>>());
    let mut columns = vec![
        text("set", |e| e.set.name()),
        table::pose_column("pose", &errors.iter().map(|e| Some(e.pose)).collect::<Vec<_>>()),
        whole("cycle", |e| e.cycle),
        text("target", |e| &e.target),
        text(QUANTITY, |e| e.quantity.as_ref()),
    ];
    for (prefix, of) in VECTORS {
        for (axis, name) in XYZ.iter().enumerate() {
            let values: Vec<f64> = errors.iter().map(|e| of(e)[axis]).collect();
            columns.push(Column::new(format!("{prefix}{name}").into(), values));
        }
    }
    columns.push(Column::new("before_deg".into(), errors.iter().map(|e| e.before_deg).collect::<Vec<_>>()));
    columns.push(Column::new("after_deg".into(), errors.iter().map(|e| e.after_deg).collect::<Vec<_>>()));
    for (k, name) in joints.iter().enumerate() {
        let values: Vec<f64> = errors.iter().map(|e| e.joints.get(k).copied().unwrap_or(f64::NAN)).collect();
        columns.push(Column::new(name.as_str().into(), values));
    }
    let own: Vec<Option<f64>> = errors.iter().map(|e| e.own_redundancy).collect();
    columns.push(Column::new(OWN_REDUNDANCY.into(), own));
    for (name, of) in RELIABILITY {
        columns.push(Column::new(name.into(), errors.iter().map(|e| e.reliability.map(of)).collect::<Vec<_>>()));
    }
    table::frame(errors.len(), columns)
}

/// Column of the quantities of errors.
const QUANTITY: &str = "quantity";

/// Column of the redundancy of readings that locate their own target.
const OWN_REDUNDANCY: &str = "own_redundancy";

/// Name of a column, and the number in it.
type ReliabilityColumn = (&'static str, fn(ReadingReliability) -> f64);

const RELIABILITY: [ReliabilityColumn; 3] =
    [("redundancy", |r| r.redundancy), ("w", |r| r.w), ("detectable_mm", |r| r.detectable_mm)];

/// Prefix of three columns, and the vector in them.
type VectorColumns = (&'static str, fn(&PointError) -> Vector);

const VECTORS: [VectorColumns; 3] = [("", |e| e.at_mm), ("before_", |e| e.before_mm), ("after_", |e| e.after_mm)];

/// The errors from such a table.
pub fn from_table(frame: &DataFrame) -> Result<Vec<PointError>> {
    let set = |name: &String| -> Result<PoseSet> {
        let unknown = || error!("pose-set-unknown", name);
        Ok(PoseSet::ALL.into_iter().find(|set| set.name() == name).ok_or_else(unknown)?)
    };
    let sets = table::texts(frame, "set")?.iter().map(set).collect::<Result<Vec<_>>>()?;
    let targets = table::texts(frame, "target")?;
    let (poses, cycles) = (table::poses(frame)?, table::integers(frame, "cycle")?);
    let vectors = |prefix: &str| -> Result<Vec<Vector>> {
        let [x, y, z] = XYZ.map(|axis| table::numbers(frame, &format!("{prefix}{axis}")));
        Ok(x?.into_iter().zip(y?).zip(z?).map(|((x, y), z)| [x, y, z]).collect())
    };
    let (at, before, after) = (vectors("")?, vectors("before_")?, vectors("after_")?);
    let (before_deg, after_deg) = (table::numbers(frame, "before_deg")?, table::numbers(frame, "after_deg")?);
    let quantity = |name: &String| name.parse().map_err(|_| error!("error-quantity-unknown", name));
    let quantities: Vec<ErrorQuantity> =
        table::texts(frame, QUANTITY)?.iter().map(quantity).collect::<std::result::Result<_, _>>()?;
    let known = ["set", "pose", "cycle", "target", QUANTITY, "before_deg", "after_deg"];
    let of_reading = |name: &str| name == OWN_REDUNDANCY || RELIABILITY.iter().any(|column| column.0 == name);
    let is_joint =
        |name: &str| !known.contains(&name) && !of_reading(name) && !XYZ.iter().any(|axis| name.ends_with(axis));
    let names = frame.get_column_names().into_iter().map(|name| name.as_str()).filter(|name| is_joint(name));
    let joints = names.map(|name| table::numbers(frame, name)).collect::<Result<Vec<_>>>()?;
    let [redundancy, w, detectable] = RELIABILITY.map(|(name, _)| table::numbers(frame, name).unwrap_or_default());
    let own = table::numbers(frame, OWN_REDUNDANCY).unwrap_or_default();
    let reliability = |i: usize| {
        let redundancy = *redundancy.get(i).filter(|r| r.is_finite())?;
        Some(ReadingReliability { redundancy, w: *w.get(i)?, detectable_mm: *detectable.get(i)? })
    };
    let error = |i: usize| PointError {
        set: sets[i],
        pose: poses[i],
        cycle: cycles[i],
        target: targets[i].clone(),
        quantity: quantities[i],
        at_mm: at[i],
        before_mm: before[i],
        after_mm: after[i],
        before_deg: Some(before_deg[i]).filter(|d| d.is_finite()),
        after_deg: Some(after_deg[i]).filter(|d| d.is_finite()),
        joints: joints.iter().map(|values| values[i]).collect(),
        reliability: reliability(i),
        own_redundancy: own.get(i).copied().filter(|r| r.is_finite()),
    };
    Ok((0..frame.height()).map(error).collect())
}
