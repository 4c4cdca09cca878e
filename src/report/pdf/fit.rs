//! How well the model fits, what the poses can tell, and how the solver ended.

use super::paper::Block;
use crate::document::{ParametersDocument, ResidualSummary};
use crate::document::{ResidualKind, UncertaintyFrom};
use crate::report::facts::stated;
use crate::report::number::significant;
use crate::report::points::Picture;
use crate::report::words::Words;

pub(super) fn blocks(document: &ParametersDocument, told: Vec<Picture>, words: &Words) -> Vec<Block> {
    let facts = Block::Facts { rows: residuals(&document.residuals, words) };
    let mut blocks = vec![Block::heading(words.say("Residuals")), facts];
    if let Some(o) = &document.observability {
        let indices = [o.o1, o.o2, o.o3, o.o4, o.o5, o.condition].map(|v| significant(v, 4));
        let row: Vec<String> = indices.into_iter().chain([o.rank.to_string()]).collect();
        blocks.push(Block::heading(words.say("Observability")));
        blocks.push(Block::table(words, &["#O1", "#O2", "#O3", "#O4", "#O5", "#condition", "#rank"], [row]));
        blocks.push(Block::note(format!("{} {}", words.say("Scaling:"), o.scaling)));
        blocks.extend(Block::pictures(told));
    }
    let solver = &document.solver;
    let steps = words.fill("{0}, {1} iterations;", &[&solver.method, &solver.iterations]);
    blocks.push(Block::heading(words.say("Solver")));
    blocks.push(Block::text(format!("{steps} {}", solver.meaning)));
    blocks
}

fn residuals(r: &ResidualSummary, words: &Words) -> Vec<[String; 2]> {
    let three = |v: f64| significant(v, 3);
    let count = match r.kind {
        ResidualKind::Pose => words.fill("{0} of the pose (mm and rad)", &[&r.count]),
        ResidualKind::Targets => words.fill("{0} coordinates of targets (mm)", &[&r.count]),
    };
    let from = match r.uncertainties_from {
        UncertaintyFrom::Instrument => words.say("from the instrument"),
        UncertaintyFrom::Residuals => words.say("from the residuals, each taken as independent"),
        UncertaintyFrom::ResidualsByPose => words.say("from the residuals, those of one pose taken together"),
        UncertaintyFrom::Nothing => words.say("unknown: as many equations as parameters"),
    };
    let enlarged = match r.uncertainties_enlarged_by {
        1.0 => String::new(),
        by => format!(", {}", words.fill("{0} times what the instrument alone makes them (median)", &[&three(by)])),
    };
    let own = match (r.stated_standard_uncertainty_mm.map(stated), r.common_standard_uncertainty_mm.map(stated)) {
        (Some(own), Some(common)) => Some(words.fill("{0} mm (k = 1) for one coordinate, of each observation its own, and {1} mm common to all observations of one measured point", &[&own, &common])),
        (own, _) => own.map(|own| words.fill("{0} mm (k = 1) for one coordinate", &[&own])),
    };
    let chi_square =
        r.chi_square.map(|c| words.fill("{0} against {1} expected", &[&significant(c, 4), &r.degrees_of_freedom]));
    let facts = [
        (words.say("residuals"), Some(count)),
        (words.say("RMS and max"), Some(words.fill("{0} and {1}", &[&three(r.rms), &three(r.max)]))),
        (words.say("degrees of freedom"), Some(r.degrees_of_freedom.to_string())),
        (words.say("stated uncertainty"), own),
        (words.say("chi-square"), chi_square),
        (words.say("uncertainties"), Some(format!("{from}{enlarged}"))),
    ];
    facts.into_iter().filter_map(|(what, text)| Some([what, text?])).collect()
}
