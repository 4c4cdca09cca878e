//! Visits of a test carried back by reference targets, which a table measures from time to time.

use crate::coordinates::{at_row, coordinates, in_file};
use crate::document::Iso9283Epoch;
use crate::iso9283::reference::{Epoch, epochs};
use crate::message::{Message, Result};
use crate::pose::Vector;
use crate::table;
use crate::visits::Visits;
use polars::prelude::DataFrame;
use std::collections::BTreeMap;

/// Carries every visit back to the first epoch of a table `cycle,target,x_mm,y_mm[,z_mm]`: the targets measured in a cycle
/// hold from this cycle on, until the next time. Gives what they say. Angles are not turned.
pub fn carry_back(visits: &mut Visits, (file, frame): (&str, &DataFrame)) -> Result<Vec<Iso9283Epoch>> {
    let (cycles, epochs) = read((file, frame))?;
    for visit in visits.poses.iter_mut().flat_map(|p| &mut p.visits) {
        let Some(epoch) = cycles.partition_point(|c| *c <= visit.cycle).checked_sub(1).map(|i| &epochs[i]) else {
            let what = format!("cycle {} was measured before any reference target", visit.cycle);
            let hint = format!("the first are of cycle {}; measure them before the test", cycles[0]);
            return Err(in_file(Message::error(what).hint(hint).into(), file));
        };
        visit.position_mm = epoch.first_T_now.apply(visit.position_mm);
        visit.readings_mm.iter_mut().for_each(|p| *p = epoch.first_T_now.apply(*p));
    }
    let told = |(&cycle, e): (&i64, &Epoch)| Iso9283Epoch { cycle, moved_mm: e.moved_mm, rms_mm: e.rms_mm };
    Ok(cycles.iter().zip(&epochs).map(told).collect())
}

/// Cycles in which the targets were measured, ascending, and what they say.
fn read((file, frame): (&str, &DataFrame)) -> Result<(Vec<i64>, Vec<Epoch>)> {
    let cycles = table::integers(frame, "cycle").map_err(|p| in_file(p, file))?;
    let names = table::texts(frame, "target").map_err(|p| in_file(p, file))?;
    let positions_mm = coordinates((file, frame))?.positions_mm;
    let mut measured: BTreeMap<i64, BTreeMap<&str, Vector>> = BTreeMap::new();
    for (i, (cycle, name)) in cycles.iter().zip(&names).enumerate() {
        if measured.entry(*cycle).or_default().insert(name, positions_mm[i]).is_some() {
            let message = Message::error(format!("target `{name}` is there twice in cycle {cycle}"));
            return Err(at_row(message, (file, frame), i).into());
        }
    }
    let mut sets: Vec<Vec<Vector>> = Vec::new();
    let first: Vec<&str> = measured.values().next().map(|all| all.keys().copied().collect()).unwrap_or_default();
    for (cycle, targets) in &measured {
        if !targets.keys().eq(&first) {
            let message = Message::error(format!("reference targets of cycle {cycle} are others than the first"));
            return Err(in_file(message.expected(first.join(", ")).into(), file));
        }
        sets.push(targets.values().copied().collect());
    }
    Ok((measured.keys().copied().collect(), epochs(&sets).map_err(|p| in_file(p, file))?))
}
