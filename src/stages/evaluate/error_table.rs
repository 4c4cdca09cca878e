//! Errors as a table: the file `residuals` of an output folder.

use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_documents::{ErrorQuantity, PointError, PoseSet, ReadingControl, ReadingReliability};
use etalon_formats::table::{Table, Values, XYZ};
use std::borrow::Cow;

/// The errors as a table: `set pose cycle target x_mm y_mm z_mm before_* after_*`, the columns
/// `joints`, `own_redundancy`, and `redundancy w detectable_mm`.
pub fn to_table(errors: &[PointError], joints: &[String]) -> Table {
    let all = || errors.iter();
    let text = |text: fn(&PointError) -> &str| Values::Texts(all().map(|e| Some(text(e).to_owned())).collect());
    let real = |number: &dyn Fn(&PointError) -> Option<f64>| Values::Numbers(all().map(number).collect());
    let mut table = Table::default();
    table.set("set", text(|e| e.set.name()));
    table.set("pose", Values::Poses(all().map(|e| Some(e.pose)).collect()));
    table.set("cycle", Values::Whole(all().map(|e| Some(e.cycle)).collect()));
    table.set("target", text(|e| &e.target));
    table.set(QUANTITY, text(|e| e.quantity.as_ref()));
    for (prefix, vector) in VECTORS {
        for (axis, name) in XYZ.iter().enumerate() {
            table.set(format!("{prefix}{name}"), real(&|e| Some(vector(e)[axis])));
        }
    }
    table.set("before_deg", real(&|e| e.before_deg));
    table.set("after_deg", real(&|e| e.after_deg));
    for (k, name) in joints.iter().enumerate() {
        table.set(name, real(&|e| Some(e.joints.get(k).copied().unwrap_or(f64::NAN))));
    }
    table.set(OWN_REDUNDANCY, real(&|e| e.control.own_redundancy));
    for (name, number) in RELIABILITY {
        table.set(name, real(&|e| e.control.reliability.map(number)));
    }
    table
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
pub fn from_table(table: &Table) -> Result<Vec<PointError>> {
    let set = |name: &Cow<str>| -> Result<PoseSet> {
        let unknown = || error!("pose-set-unknown", name = &**name);
        Ok(PoseSet::ALL.into_iter().find(|set| set.name() == name).ok_or_else(unknown)?)
    };
    let sets = table.texts("set")?.iter().map(set).collect::<Result<Vec<_>>>()?;
    let targets = table.texts("target")?;
    let (poses, cycles) = (table.poses()?, table.integers("cycle")?);
    let vectors = |prefix: &str| -> Result<Vec<Vector>> {
        let [x, y, z] = XYZ.map(|axis| table.numbers(&format!("{prefix}{axis}")));
        Ok(x?.into_iter().zip(y?).zip(z?).map(|((x, y), z)| [x, y, z]).collect())
    };
    let (at, before, after) = (vectors("")?, vectors("before_")?, vectors("after_")?);
    let (before_deg, after_deg) = (table.numbers("before_deg")?, table.numbers("after_deg")?);
    let quantity = |name: &Cow<str>| name.parse().map_err(|_| error!("error-quantity-unknown", name = &**name));
    let quantities: Vec<ErrorQuantity> =
        table.texts(QUANTITY)?.iter().map(quantity).collect::<std::result::Result<_, _>>()?;
    let known = ["set", "pose", "cycle", "target", QUANTITY, "before_deg", "after_deg"];
    let of_reading = |name: &str| name == OWN_REDUNDANCY || RELIABILITY.iter().any(|column| column.0 == name);
    let is_joint =
        |name: &str| !known.contains(&name) && !of_reading(name) && !XYZ.iter().any(|axis| name.ends_with(axis));
    let names = table.names().filter(|name| is_joint(name));
    let joints = names.map(|name| table.numbers(name)).collect::<Result<Vec<_>>>()?;
    let [redundancy, w, detectable] = RELIABILITY.map(|(name, _)| table.numbers(name).unwrap_or_default());
    let own = table.numbers(OWN_REDUNDANCY).unwrap_or_default();
    let reliability = |i: usize| {
        let redundancy = *redundancy.get(i).filter(|r| r.is_finite())?;
        Some(ReadingReliability { redundancy, w: *w.get(i)?, detectable_mm: *detectable.get(i)? })
    };
    let error = |i: usize| PointError {
        set: sets[i],
        pose: poses[i],
        cycle: cycles[i],
        target: targets[i].to_string(),
        quantity: quantities[i],
        at_mm: at[i],
        before_mm: before[i],
        after_mm: after[i],
        before_deg: Some(before_deg[i]).filter(|d| d.is_finite()),
        after_deg: Some(after_deg[i]).filter(|d| d.is_finite()),
        joints: joints.iter().map(|values| values[i]).collect(),
        control: ReadingControl {
            reliability: reliability(i),
            own_redundancy: own.get(i).copied().filter(|r| r.is_finite()),
        },
    };
    Ok((0..table.height()).map(error).collect())
}
