//! A recorded motion as text.

use crate::document::{Iso9283Interval, Iso9283Path, Iso9283StreamDocument};
use std::fmt::Write;

/// What a terminal shows; with `all`, a row for each standstill.
pub(in crate::cli) fn as_text(document: &Iso9283StreamDocument, all: bool) -> String {
    let mut text = format!("{} samples, {:.3} s\n", document.samples, document.duration_s);
    let number = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| format!("{v:.4}"));
    let whole = |v: Option<i64>| v.map_or_else(|| "-".to_owned(), |v| v.to_string());
    let standstills = if all { &document.standstills[..] } else { &[] };
    if !standstills.is_empty() {
        let _ = writeln!(
            text,
            "{:>5} {:>6} {:>10} {:>10} {:>9} {:>12} {:>12} {:>9}",
            "pose", "cycle", "from s", "to s", "noise mm", "settles s", "overshoot mm", "posing s"
        );
    }
    for s in standstills {
        let _ = writeln!(
            text,
            "{:>5} {:>6} {:>10.3} {:>10.3} {:>9} {:>12} {:>12} {:>9}",
            whole(s.pose),
            whole(s.cycle),
            s.from_s,
            s.to_s,
            number(s.noise_mm),
            number(s.stabilisation_s),
            number(s.overshoot_mm),
            number(s.posing_s)
        );
    }
    for s in &document.settling {
        let _ = writeln!(
            text,
            "pose {}: stabilisation time {:.4} s, overshoot {:.4} mm, {} arrivals",
            s.pose, s.stabilisation_s, s.overshoot_mm, s.arrivals
        );
    }
    for p in &document.posing {
        let _ = writeln!(
            text,
            "pose {} to {}: {:.3} mm in {:.4} s, {} moves",
            p.from, p.to, p.distance_mm, p.posing_s, p.moves
        );
    }
    if let Some(path) = &document.path {
        path_lines(&mut text, path);
    }
    if let Some(w) = &document.weaving {
        let _ = writeln!(
            text,
            "weaving: stroke {:.4} mm (WS {:+.3} %), frequency {:.4} Hz (WF {:+.3} %), {} passes",
            w.stroke_mm, w.ws_percent, w.frequency_hz, w.wf_percent, w.passes
        );
    }
    text
}

fn interval(i: &Option<Iso9283Interval>) -> String {
    i.map_or_else(String::new, |i| format!(" [{:.4}, {:.4}]", i.low_mm, i.high_mm))
}

fn path_lines(text: &mut String, path: &Iso9283Path) {
    let clause = if path.reorientation { " on reorientation" } else { "" };
    let left = if path.incomplete > 0 { format!(" ({} more not ended)", path.incomplete) } else { String::new() };
    let _ = write!(
        text,
        "path of {:.3} mm, {} passes{left}: AT{clause} {:.4} mm{} at {:.3} mm",
        path.length_mm,
        path.passes,
        path.at_mm,
        interval(&path.at_interval),
        path.at_along_mm
    );
    if let (Some(rt), Some(along)) = (path.rt_mm, path.rt_along_mm) {
        let _ = write!(text, ", RT {rt:.4} mm{} at {along:.3} mm", interval(&path.rt_interval));
    }
    text.push('\n');
    for (name, angles) in [("AT", &path.at_angles_deg), ("RT", &path.rt_angles_deg)] {
        if !angles.is_empty() {
            let angles: Vec<String> = angles.iter().map(|a| format!("{a:.5}")).collect();
            let _ = writeln!(text, "  {name} of angles: {} deg", angles.join(", "));
        }
    }
    if let Some(v) = &path.velocity {
        let rv = v.rv_percent.map(|rv| format!(", RV {rv:.3} %")).unwrap_or_default();
        let _ = writeln!(
            text,
            "  velocity {:.3} mm/s: AV {:+.3} %{rv}, FV {:.3} mm/s",
            v.mean_mm_s, v.av_percent, v.fv_mm_s
        );
    }
    for c in &path.corners {
        let at: Vec<String> = c.position_mm.iter().map(|x| format!("{x:.3}")).collect();
        let stable = c.stabilisation_mm.map(|s| format!(", stable after {s:.3} mm")).unwrap_or_default();
        let _ =
            writeln!(text, "  corner {}: round-off {:.4}, overshoot {:.4} mm{stable}", at.join(" "), c.cr_mm, c.co_mm);
    }
}
