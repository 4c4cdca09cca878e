//! From a table of a loaded robot to its static compliance by ISO 9283.

use crate::base::message::{Message, Problems, Result};
use crate::base::pose::{Vector, centroid};
use crate::base::table;
use crate::document::{Iso9283Compliance, Iso9283ComplianceDocument};
use crate::import::tables::coordinates::NamedTable;
use crate::iso9283::compliance::{Loaded, compliance};

/// Directions that a table may name.
const DIRECTIONS: [(&str, Vector); 6] = [
    ("+x", [1.0, 0.0, 0.0]),
    ("-x", [-1.0, 0.0, 0.0]),
    ("+y", [0.0, 1.0, 0.0]),
    ("-y", [0.0, -1.0, 0.0]),
    ("+z", [0.0, 0.0, 1.0]),
    ("-z", [0.0, 0.0, -1.0]),
];
/// Repeats that the standard asks for (unverified).
const CYCLES: usize = 3;

/// One row.
struct Reading {
    direction: usize,
    cycle: i64,
    force_n: f64,
    position_mm: Vector,
}

/// Compliance from a table `direction,cycle,force_n,x_mm,y_mm[,z_mm]`: in each direction and cycle a row without force, the
/// position that the others are compared with, and rows under load.
pub fn evaluate(table: NamedTable) -> Result<Iso9283ComplianceDocument> {
    let readings = readings(table)?;
    let strange = table.unread(&["direction", "cycle", "force_n"]);
    let mut directions = Vec::new();
    for (k, (name, direction)) in DIRECTIONS.iter().enumerate() {
        let of: Vec<&Reading> = readings.iter().filter(|r| r.direction == k).collect();
        let mut loaded = Vec::new();
        for r in of.iter().filter(|r| r.force_n > 0.0) {
            let without = of.iter().filter(|o| o.cycle == r.cycle && o.force_n == 0.0).map(|o| o.position_mm);
            let Some(unloaded_mm) = centroid(&without.collect::<Vec<_>>()) else {
                let what = format!("direction {name}, cycle {}: no row without force", r.cycle);
                return Err(table.place(Message::error(what).hint("record the unloaded position, force 0")));
            };
            loaded.push(Loaded { force_n: r.force_n, position_mm: r.position_mm, unloaded_mm });
        }
        if loaded.is_empty() {
            continue;
        }
        let found = compliance(&loaded, *direction)?;
        let mut cycles: Vec<i64> = of.iter().filter(|r| r.force_n > 0.0).map(|r| r.cycle).collect();
        cycles.sort_unstable();
        cycles.dedup();
        directions.push(Iso9283Compliance {
            direction: (*name).to_owned(),
            readings: loaded.len(),
            cycles: cycles.len(),
            force_n: loaded.iter().map(|l| l.force_n).fold(0.0, f64::max),
            compliance_mm_n: found.compliance_mm_n,
            standard_uncertainty_mm_n: Some(found.standard_uncertainty_mm_n).filter(|u| u.is_finite()),
            largest_mm: found.largest_mm,
            off_line_mm: found.off_line_mm,
        });
    }
    if directions.is_empty() {
        return Err(table.place(Message::error("no row has a force")));
    }
    let short = directions.iter().filter(|d| d.cycles < CYCLES).map(|d| d.direction.as_str()).collect::<Vec<_>>();
    let warning = || Message::warning(format!("fewer than {CYCLES} cycles in direction {}", short.join(", ")));
    Ok(Iso9283ComplianceDocument {
        schema: "etalon/iso9283-compliance/1".to_owned(),
        conventions: vec![
            "compliance: displacement along the force by force, least squares through the unloaded position".to_owned(),
            "clause 10 was not compared with a bought copy of the standard".to_owned(),
        ],
        messages: (!short.is_empty()).then(warning).into_iter().chain(strange).collect(),
        directions,
    })
}

fn readings(table: NamedTable) -> Result<Vec<Reading>> {
    let columns = ["direction", "cycle", "force_n"].map(str::to_owned);
    table::require(table.frame, &columns).map_err(|p| table.place(p))?;
    let (names, forces) = (table.texts("direction")?, table.texts("force_n")?);
    let cycles = table.integers("cycle")?;
    let all = table.coordinates()?;
    let (positions_mm, spatial) = (all.positions_mm, all.spatial);
    let mut problems = Problems::default();
    let mut all = Vec::new();
    for (i, position_mm) in positions_mm.into_iter().enumerate() {
        let direction = DIRECTIONS.iter().position(|(known, _)| *known == names[i]);
        if direction.is_none() {
            let message = Message::error(format!("`{}` is not a direction", names[i]));
            problems.0.push(table.at_row(message, i).expected("+x, -x, +y, -y, +z or -z"));
        }
        if !spatial && names[i].ends_with('z') {
            let message =
                Message::error(format!("direction `{}` without z_mm: no displacement is measured there", names[i]));
            problems.0.push(table.at_row(message, i).hint("add the column z_mm, or take the row out"));
        }
        let force_n = forces[i].parse().ok().filter(|f: &f64| f.is_finite() && *f >= 0.0);
        if force_n.is_none() {
            let message = Message::error(format!("`{}` is not a force", forces[i]));
            problems.0.push(table.at_row(message, i).expected("newtons, zero or more: the direction gives the sign"));
        }
        if let (Some(direction), Some(force_n)) = (direction, force_n) {
            all.push(Reading { direction, cycle: cycles[i], force_n, position_mm });
        }
    }
    problems.0.truncate(20);
    problems.check()?;
    Ok(all)
}
