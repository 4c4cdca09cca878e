//! A plan for people and as a table.

use crate::base::table::ASSEMBLY;
use crate::document::PlanDocument;
use crate::math::robots::Robot;
use std::fmt::Write;

/// The chosen configurations as a table: candidates again, or targets of a controller.
pub(super) fn csv(robot: &dyn Robot, document: &PlanDocument) -> String {
    let mut columns: Vec<String> = robot.joints().iter().map(|j| j.column()).collect();
    columns.extend(robot.has_assembly_modes().then(|| ASSEMBLY.to_owned()));
    let mut text = format!("pose,{}\n", columns.join(","));
    for planned in &document.chosen {
        for configuration in &planned.configurations {
            let cells: Vec<String> = columns.iter().filter_map(|c| Some(configuration.get(c)?.to_string())).collect();
            let _ = writeln!(text, "{},{}", planned.pose, cells.join(","));
        }
    }
    text
}

/// What a terminal shows.
pub(super) fn as_text(document: &PlanDocument) -> String {
    let list = |poses: &[i64]| poses.iter().map(i64::to_string).collect::<Vec<_>>().join(", ");
    let chosen: Vec<i64> = document.chosen.iter().map(|p| p.pose).collect();
    let count: usize = document.chosen.iter().map(|p| p.configurations.len()).sum();
    let mut text = format!("poses: {} ({count} configurations)\n", list(&chosen));
    let _ = writeln!(text, "{} = {:.6} ({})", document.index, document.value, document.definition);
    let _ = match document.at_most_below_percent {
        _ if document.proven_optimal => {
            writeln!(
                text,
                "proven: no other choice of {} of {} candidates is better",
                chosen.len(),
                document.candidates
            )
        }
        Some(below) => writeln!(
            text,
            "at most {below:.2} % below the best possible choice of {} of {} candidates",
            chosen.len(),
            document.candidates
        ),
        None => writeln!(text, "no bound is known for this index: another choice may be better"),
    };
    let greedy = &document.greedy;
    let _ =
        writeln!(text, "one after the other: {} = {:.6}, poses {}", document.index, greedy.value, list(&greedy.poses));
    if let Some(c) = &document.compared {
        let _ = writeln!(
            text,
            "poses {}: {} = {:.6}; the plan is {:.1} % better",
            list(&c.poses),
            document.index,
            c.value,
            c.better_by_percent
        );
    }
    if let Some(o) = &document.observability {
        let _ = writeln!(text, "condition {:.1}", o.condition);
    }
    if let Some(w) = &document.workspace {
        let _ = writeln!(text, "predicted uncertainty of position: rms {:.4} mm, max {:.4} mm", w.rms_mm, w.max_mm);
        for p in &document.parameters {
            let u = p.standard_uncertainty.map_or("not told".to_owned(), |u| format!("{u:.2e}"));
            let _ = writeln!(text, "  {:<16} {u:>10} {}", p.name, p.unit);
        }
    }
    text
}
