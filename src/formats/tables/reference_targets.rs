//! Compensation of the drift of the set-up by reference targets that are measured repeatedly.

use crate::table::Table;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::{error, warning};
use etalon_documents::Iso9283Epoch;
use etalon_standards::iso9283::pose::reference::{Epoch, epochs};
use etalon_standards::iso9283::pose::rotations::RotationOrder;
use etalon_standards::iso9283::pose::test::PoseTest;
use std::collections::BTreeMap;

/// Compensated drift of the set-up.
#[derive(Clone, Debug, Default)]
pub struct SetupDrift {
    /// Displacement of the set-up at each measurement of the targets.
    pub epochs: Vec<Iso9283Epoch>,
    /// `true` if orientations were compensated as well.
    pub turned: bool,
}

/// Transforms all attained poses into the frame of the first epoch of a table
/// `cycle,target,x_mm,y_mm[,z_mm]`. Targets measured in a cycle apply from this cycle until they
/// are measured again.
///
/// Orientations are compensated if the test gives the order of all angles a, b, c, or for c of a
/// planar robot. Otherwise angles are unchanged, with a warning.
pub fn compensate_setup_drift(test: &mut PoseTest, table: &Table) -> Result<SetupDrift> {
    let (cycles, epochs) = read(table)?;
    let turning = turning(test);
    let angles = test.angles.clone();
    for p in &mut test.poses {
        // of all angles of an orientation, those nearest to the commanded ones are taken
        let start_rad =
            all_three(&angles, if p.commanded_rad.is_empty() { &p.attained[0].angles_rad } else { &p.commanded_rad });
        for attained in &mut p.attained {
            let epoch = holding(&cycles, &epochs, attained.cycle).map_err(|p| table.in_file(p))?;
            attained.position_mm = epoch.first_T_now.apply(attained.position_mm);
            attained.readings_mm.iter_mut().for_each(|p| *p = epoch.first_T_now.apply(*p));
            let Some(order) = turning.filter(|_| epoch.moved_mm > 0.0) else { continue };
            let turn = |read: &mut Vec<f64>| {
                let pose = order.pose(all_three(&angles, read));
                let turned = order.angles_rad(&epoch.first_T_now.then(&pose), start_rad);
                *read = angles.iter().map(|&k| turned[k]).collect();
            };
            turn(&mut attained.angles_rad);
            attained.readings_rad.iter_mut().for_each(turn);
        }
    }
    let told = |(&cycle, e): (&i64, &Epoch)| Iso9283Epoch { cycle, moved_mm: e.moved_mm, rms_mm: e.rms_mm };
    Ok(SetupDrift { epochs: cycles.iter().zip(&epochs).map(told).collect(), turned: turning.is_some() })
}

/// Returns the order of rotations; adds a warning if there are angles and their order is unknown.
fn turning(test: &mut PoseTest) -> Option<RotationOrder> {
    let planar = !test.spatial && test.angles == [2];
    let order = match planar {
        true => RotationOrder::parse("Rz(c) Ry(b) Rx(a)"),
        false => test.order(),
    };
    if order.is_none() && !test.angles.is_empty() {
        test.warnings.push(warning!("angles-not-compensated"));
    }
    order
}

/// Returns the angles a, b, c; missing angles are zero.
fn all_three(angles: &[usize], values: &[f64]) -> Vector {
    let mut all = [0.0; 3];
    angles.iter().zip(values).for_each(|(&k, v)| all[k] = *v);
    all
}

/// Returns the epoch of a cycle.
fn holding<'a>(cycles: &[i64], epochs: &'a [Epoch], cycle: i64) -> Result<&'a Epoch> {
    cycles
        .partition_point(|c| *c <= cycle)
        .checked_sub(1)
        .map(|i| &epochs[i])
        .ok_or_else(|| error!("cycle-before-reference-targets", cycle, first = cycles[0]).into())
}

/// Returns the cycles in which the targets were measured (ascending), and their epochs.
fn read(table: &Table) -> Result<(Vec<i64>, Vec<Epoch>)> {
    let cycles = table.integers("cycle").map_err(|p| table.in_file(p))?;
    let names = table.texts("target").map_err(|p| table.in_file(p))?;
    let positions_mm = table.coordinates()?.positions_mm;
    let mut measured: BTreeMap<i64, BTreeMap<&str, Vector>> = BTreeMap::new();
    for (i, (cycle, name)) in cycles.iter().zip(&names).enumerate() {
        if measured.entry(*cycle).or_default().insert(name, positions_mm[i]).is_some() {
            return Err(error!("reference-target-twice", target = &**name, cycle).at(table.place(i)).into());
        }
    }
    let mut sets: Vec<Vec<Vector>> = Vec::new();
    let first: Vec<&str> = measured.values().next().map(|all| all.keys().copied().collect()).unwrap_or_default();
    for (cycle, targets) in &measured {
        if !targets.keys().eq(&first) {
            return Err(table.in_file(error!("reference-targets-differ", cycle, targets = first)));
        }
        sets.push(targets.values().copied().collect());
    }
    Ok((measured.keys().copied().collect(), epochs(&sets).map_err(|p| table.in_file(p))?))
}
