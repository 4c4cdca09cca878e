//! A table of a loaded robot: read and evaluated.

use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_documents::Iso9283ComplianceDocument;
use etalon_formats::table::Table;
use etalon_formats::tables::observations::FORCE;
use etalon_standards::iso9283::load::{self, DIRECTIONS, LoadReading};

/// Compliance from a table `direction,cycle,force_n,x_mm,y_mm[,z_mm]`.
pub fn evaluate(table: &Table) -> Result<Iso9283ComplianceDocument> {
    let found = load::evaluate(&readings(table)?).map_err(|more| table.in_file(more))?;
    let mut document = Iso9283ComplianceDocument::new(found);
    document.messages.extend(table.unread(&["direction", "cycle", FORCE]));
    Ok(document)
}

fn readings(table: &Table) -> Result<Vec<LoadReading>> {
    let in_file = |problems| table.in_file(problems);
    table.require(["direction", "cycle", FORCE]).map_err(in_file)?;
    let names = table.texts("direction").map_err(in_file)?;
    let forces = table.numbers(FORCE).map_err(in_file)?;
    let cycles = table.integers("cycle").map_err(in_file)?;
    let all = table.coordinates()?;
    let (positions_mm, spatial) = (all.positions_mm, all.spatial);
    let mut problems = Problems::default();
    let mut all = Vec::new();
    for (i, position_mm) in positions_mm.into_iter().enumerate() {
        let direction = DIRECTIONS.iter().position(|(known, _)| *known == names[i]);
        if direction.is_none() {
            problems.0.push(error!("load-direction-unknown", direction = &*names[i]).at(table.place(i)));
        }
        if !spatial && names[i].ends_with('z') {
            problems.0.push(error!("load-direction-unmeasured", direction = &*names[i]).at(table.place(i)));
        }
        let force_n = Some(forces[i]).filter(|f| f.is_finite() && *f >= 0.0);
        if force_n.is_none() {
            let text = if forces[i].is_nan() { String::new() } else { forces[i].to_string() };
            problems.0.push(error!("force-not-a-number", text).at(table.place(i)));
        }
        if let (Some(direction), Some(force_n)) = (direction, force_n) {
            all.push(LoadReading { direction, cycle: cycles[i], force_n, position_mm });
        }
    }
    problems.0.truncate(20);
    problems.check()?;
    Ok(all)
}
