//! World frame and features, in the coordinates of the exports.

use crate::model::{Block, Cell, Columns, Section, Table, Text, fixed, number_cell, numbers, term};
use crate::number::fixed as number;
use crate::words::{Words, names, tr};
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_documents::{Feature, FramePose, Results, Uncontrolled, WorldFrame};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let (features, world) = (&results.features.features, &results.frames.world);
    let mut section = Section::new("frames", tr!(words, "frames-and-features"));
    section.push(Block::heading(tr!(words, "world-frame-title")));
    section.push(Block::facts(frame(world, words)));
    section.push(Block::Table(poses(world, words)));
    section.push(Block::heading(tr!(words, "features")));
    if features.is_empty() {
        section.push(Block::text(tr!(words, "the-campaign-fits-no-features")));
    }
    section.push(Block::Table(elements(features, words)));
    let open = &results.frames.not_controlled;
    if !open.is_empty() {
        section.push(Block::heading(tr!(words, "not-controlled-by-the-data")));
        section.push(Block::Table(uncontrolled(open, words)));
    }
    section.whole()
}

fn frame(world: &WorldFrame, words: &Words) -> Vec<(String, Cell)> {
    let seen = if world.planar { tr!(words, "projected-into-xy") } else { tr!(words, "in-space") };
    let um = |v: f64| format!("{} µm", words.fixed(1e3 * v, 2));
    let (what, said) = match &world.poses[..] {
        [only] => (
            tr!(words, "origin-in-the-exports"),
            format!("{} mm", only.export_T_world.translation_mm.map(|v| words.fixed(v, 4)).join(", ")),
        ),
        poses => (tr!(words, "measured"), tr!(words, "times-for-each-cycle", count = poses.len())),
    };
    vec![
        (tr!(words, "definition"), Text::worded(&world.definition, words).into()),
        (tr!(words, "observations"), seen.into()),
        (tr!(words, "targets-from-their-places"), world.rms_mm.map(|v| format!("RMS {}", um(v))).into()),
        (tr!(words, "largest-distance"), world.max_mm.map(um).into()),
        (what, said.into()),
    ]
}

fn elements(features: &[Feature], words: &Words) -> Table {
    let um = |mm: f64| number(1e3 * mm, 2);
    let columns = Columns::<Feature>::new()
        .both(phrase!("name"), "", |f| f.name.as_str())
        .both(phrase!("report-element"), "", |f| {
            names::element(&f.element).map_or_else(|| Cell::from(&f.element), |element| term(words, element))
        })
        .both(phrase!("points"), "", |f| f.points)
        .page(phrase!("point"), "mm", |f| numbers(triple(f.point_mm, 4)))
        .page(phrase!("direction"), "", |f| numbers(triple(f.direction, 6)))
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-point", axis)), "mm", |f| &f.point_mm)
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-direction", axis)), "", |f| &f.direction)
        .both(phrase!("radius"), "mm", |f| fixed(f.radius_mm, 4))
        .both(phrase!("distances-rms"), "mm", |f| number_cell(f.rms_mm, um))
        .in_unit("µm")
        .both(phrase!("distances-max"), "mm", |f| number_cell(f.max_mm, um))
        .in_unit("µm")
        .both("u (k = 1)", "mm", |f| number_cell(f.standard_uncertainty_mm, um))
        .in_unit("µm")
        .sheet(phrase!("head-labels"), "", |f| f.labels.join(", "));
    Table::new(words, features, columns).on(phrase!("features"))
}

/// World frame at each measurement.
fn poses(world: &WorldFrame, words: &Words) -> Table {
    let first = Columns::<FramePose>::new()
        .sheet(phrase!("pose"), "", |f| f.pose)
        .sheet(phrase!("cycle"), "", |f| f.cycle)
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-origin", axis)), "mm", |f| {
            &f.export_T_world.translation_mm
        });
    let titles = [
        ["x axis, x", "x axis, y", "x axis, z"],
        ["y axis, x", "y axis, y", "y axis, z"],
        ["z axis, x", "z axis, y", "z axis, z"],
    ];
    let titles = titles.into_iter().flatten().enumerate();
    let columns = titles
        .fold(first, |columns, (i, title)| columns.sheet(title, "", move |f| f.export_T_world.rotation[i % 3][i / 3]));
    Table::new(words, &world.poses, columns).on(phrase!("sheet-frames"))
}

/// Errors that no reading can detect.
fn uncontrolled(all: &[Uncontrolled], words: &Words) -> Table {
    let columns = Columns::<Uncontrolled>::new()
        .page(phrase!("what-no-reading-shows"), "", |u| Text::worded(&u.what, words))
        .sheet(phrase!("what-no-reading-shows"), "", |u| u.what.english())
        .both(phrase!("points"), "", |u| Text::name(&u.points.join(", ")))
        .both(phrase!("controlled-by"), "", |u| Text::name(&u.keys.join(", ")));
    Table::new(words, all, columns).on(phrase!("sheet-not-controlled"))
}

fn triple(v: Vector, decimals: usize) -> String {
    v.map(|v| number(v, decimals)).join(", ")
}
