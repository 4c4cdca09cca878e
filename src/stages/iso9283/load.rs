//! A table of a loaded robot: read and evaluated.

use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_documents::Iso9283ComplianceDocument;
use etalon_formats::table;
use etalon_formats::tables::coordinates::NamedTable;
use etalon_formats::tables::observations::FORCE;
use etalon_standards::iso9283::load::{self, DIRECTIONS, LoadReading};

/// Compliance from a table `direction,cycle,force_n,x_mm,y_mm[,z_mm]`.
pub fn evaluate(table: NamedTable) -> Result<Iso9283ComplianceDocument> {
    let found = load::evaluate(&readings(table)?).map_err(|more| table.place(more))?;
    let mut document = Iso9283ComplianceDocument::new(found);
    document.messages.extend(table.unread(&["direction", "cycle", FORCE]));
    Ok(document)
}

fn readings(table: NamedTable) -> Result<Vec<LoadReading>> {
    let columns = ["direction", "cycle", FORCE].map(str::to_owned);
    table::require(table.frame, &columns).map_err(|p| table.place(p))?;
    let names = table.texts("direction")?;
    let forces = table::numbers(table.frame, FORCE).map_err(|p| table.place(p))?;
    let cycles = table.integers("cycle")?;
    let all = table.coordinates()?;
    let (positions_mm, spatial) = (all.positions_mm, all.spatial);
    let mut problems = Problems::default();
    let mut all = Vec::new();
    for (i, position_mm) in positions_mm.into_iter().enumerate() {
        let direction = DIRECTIONS.iter().position(|(known, _)| *known == names[i]);
        if direction.is_none() {
            problems.0.push(table.at_row(error!("load-direction-unknown", direction = names[i]), i));
        }
        if !spatial && names[i].ends_with('z') {
            problems.0.push(table.at_row(error!("load-direction-unmeasured", direction = names[i]), i));
        }
        let force_n = Some(forces[i]).filter(|f| f.is_finite() && *f >= 0.0);
        if force_n.is_none() {
            let text = if forces[i].is_nan() { String::new() } else { forces[i].to_string() };
            problems.0.push(table.at_row(error!("force-not-a-number", text), i));
        }
        if let (Some(direction), Some(force_n)) = (direction, force_n) {
            all.push(LoadReading { direction, cycle: cycles[i], force_n, position_mm });
        }
    }
    problems.0.truncate(20);
    problems.check()?;
    Ok(all)
}
