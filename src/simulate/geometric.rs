//! Points of the geometric calibration (thesis, chapter 2).

use super::Scene;
use crate::stages::geometric::{self, Gathered};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::Vector;
use etalon_formats::Export;

/// Stream of the noise of homing, distinct from the streams of files.
const HOMING: u64 = 1 << 32;

/// Labelled points for `export`; `measure` returns the reading of a point in the world.
pub(super) fn points(
    scene: &Scene,
    export: &Export,
    mut measure: impl FnMut(Vector) -> Vector,
) -> Vec<(String, Vector)> {
    let (truth, definition) = (scene.truth, &scene.campaign.file.geometric);
    let here = truth.geometric_export.as_ref() == Some(export.file.get_ref());
    let (true, Some(setup), Some(definition), Some(table)) =
        (here, &truth.geometric, definition, scene.robot.rail_table())
    else {
        return Vec::new();
    };
    let mut homing = Noise::new(truth.seed, HOMING);
    let found = setup.measure(table, &scene.values, &mut homing, &mut measure);
    let (bars, balls) = (setup.bars(&mut measure), setup.balls(&mut measure));
    geometric::labelled(definition, &Gathered { robot: found, bars, balls })
}

/// Rejects a truth that the campaign cannot name.
pub(super) fn check(scene: &Scene) -> Result<()> {
    let definition = scene.campaign.file.geometric.as_ref();
    let table = scene.robot.rail_table();
    if scene.truth.geometric.is_some() && (definition.is_none() || table.is_none()) {
        return Err(error!("truth-geometric-without-campaign").into());
    }
    Ok(())
}
