//! Fitted features and the world frame, in the coordinates of the exports.

use super::sheet::Sheet;
use crate::document::{FeaturesDocument, WorldFrame};

pub(super) fn sheets(features: &FeaturesDocument, world: &WorldFrame) -> [Sheet; 2] {
    [elements(features), frames(world)]
}

fn elements(document: &FeaturesDocument) -> Sheet {
    Sheet::of(
        "Features",
        &document.features,
        &[
            ("name", "", |f| f.name.as_str().into()),
            ("element", "", |f| f.element.as_str().into()),
            ("points", "", |f| f.points.into()),
            ("point x", "mm", |f| f.point_mm[0].into()),
            ("point y", "mm", |f| f.point_mm[1].into()),
            ("point z", "mm", |f| f.point_mm[2].into()),
            ("direction x", "", |f| f.direction[0].into()),
            ("direction y", "", |f| f.direction[1].into()),
            ("direction z", "", |f| f.direction[2].into()),
            ("radius", "mm", |f| f.radius_mm.into()),
            ("distances, RMS", "mm", |f| f.rms_mm.into()),
            ("distances, max", "mm", |f| f.max_mm.into()),
            ("u (k = 1)", "mm", |f| f.standard_uncertainty_mm.into()),
            ("labels", "", |f| f.labels.join(", ").into()),
        ],
    )
}

fn frames(world: &WorldFrame) -> Sheet {
    Sheet::of(
        "Frames",
        &world.poses,
        &[
            ("pose", "", |f| f.pose.into()),
            ("cycle", "", |f| f.cycle.into()),
            ("origin x", "mm", |f| f.export_T_world.translation_mm[0].into()),
            ("origin y", "mm", |f| f.export_T_world.translation_mm[1].into()),
            ("origin z", "mm", |f| f.export_T_world.translation_mm[2].into()),
            ("x axis, x", "", |f| f.export_T_world.rotation[0][0].into()),
            ("x axis, y", "", |f| f.export_T_world.rotation[1][0].into()),
            ("x axis, z", "", |f| f.export_T_world.rotation[2][0].into()),
            ("y axis, x", "", |f| f.export_T_world.rotation[0][1].into()),
            ("y axis, y", "", |f| f.export_T_world.rotation[1][1].into()),
            ("y axis, z", "", |f| f.export_T_world.rotation[2][1].into()),
            ("z axis, x", "", |f| f.export_T_world.rotation[0][2].into()),
            ("z axis, y", "", |f| f.export_T_world.rotation[1][2].into()),
            ("z axis, z", "", |f| f.export_T_world.rotation[2][2].into()),
        ],
    )
}
