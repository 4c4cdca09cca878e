//! Goodness of fit, observability by the poses, and termination of the solver.

use crate::Report;
use crate::model::{Block, Cell, Columns, Figure, Section, Table, Text, significant as digits};
use crate::number::{derived, significant};
use crate::plots::{points, residuals as plots, singular};
use crate::words::Words;
use etalon_documents::{
    ObservabilitySummary, ParametersDocument, ResidualKind, ResidualSummary, SingularValueEntry, UncertaintyFrom,
};

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    let identified = report.identified?;
    let drawable = points::drawable(identified.errors);
    let planar = points::planar(&drawable, report.frames.world.planar);
    Some(of(identified.parameters, plots::pictures(&drawable, planar, words), words))
}

/// Section of a fit, with figures of its residuals.
pub(crate) fn of(document: &ParametersDocument, pictures: Vec<Figure>, words: &Words) -> Section {
    let mut section = Section::new("fit", words.say("Fit and observability"));
    section.push(Block::heading(words.say("Residuals")));
    section.push(Block::facts(residuals(&document.residuals, words)));
    section.figures(pictures);
    if let Some(o) = &document.observability {
        section.push(Block::heading(words.say("Observability")));
        section.push(Block::Table(indices(o, words)));
        section.push(Block::note(Text::from(words.say("Scaling:") + " ").and(Text::document(&o.scaling, words))));
        section.push(Block::Table(singular_values(o, words)));
        section.figures(singular::picture(o, words));
    }
    let solver = &document.solver;
    let steps = words.fill("{0}, {1} iterations;", &[&solver.method, &solver.iterations]) + " ";
    let ended = Text::from(steps).and(Text::document(&solver.meaning, words));
    section.push(Block::heading(words.say("Solver")));
    section.push(Block::text(ended.clone()));
    let r = &document.residuals;
    section.summarise(words.say("model of the robot"), document.robot.as_str(), "");
    section.summarise(words.say("residuals"), r.count, "");
    section.summarise(words.say("residuals, RMS"), r.rms, "");
    section.summarise(words.say("residuals, max"), r.max, "");
    section.summarise(words.say("degrees of freedom"), r.degrees_of_freedom, "");
    section.summarise(words.say("chi-square"), r.chi_square, "");
    section.summarise(words.say("uncertainties enlarged by"), r.uncertainties_enlarged_by, "");
    section.summarise(words.say("condition"), document.observability.as_ref().map(|o| o.condition), "");
    section.summarise(words.say("Solver"), ended, "");
    section
}

fn indices(o: &ObservabilitySummary, words: &Words) -> Table {
    let columns = Columns::<ObservabilitySummary>::new()
        .page("O1", "", |o| digits(o.o1, 4))
        .page("O2", "", |o| digits(o.o2, 4))
        .page("O3", "", |o| digits(o.o3, 4))
        .page("O4", "", |o| digits(o.o4, 4))
        .page("O5", "", |o| digits(o.o5, 4))
        .page("condition", "", |o| digits(o.condition, 4))
        .page("rank", "", |o| o.rank);
    Table::of(words, [o], columns)
}

/// Singular values in descending order, followed by those of held parameters.
fn singular_values(o: &ObservabilitySummary, words: &Words) -> Table {
    let all = o.singular_values.iter().map(|s| ("identified", s));
    let all = all.chain(o.held_singular_values.iter().map(|s| ("held", s)));
    let rows: Vec<(usize, &str, &SingularValueEntry)> =
        all.enumerate().map(|(i, (direction, s))| (i + 1, direction, s)).collect();
    let columns = Columns::<(usize, &str, &SingularValueEntry)>::new()
        .sheet("number", "", |(i, ..)| *i)
        .sheet("singular value (columns divided by their norms)", "", |(.., s)| s.value)
        .sheet("direction", "", |(_, direction, _)| *direction)
        .sheet("parameters", "", |(.., s)| s.parameters.join(", "));
    Table::of(words, &rows, columns).on("Singular values")
}

fn residuals(r: &ResidualSummary, words: &Words) -> Vec<(String, Cell)> {
    let three = |v: f64| significant(v, 3);
    let count = match r.kind {
        ResidualKind::Pose => words.fill("{0} of the pose (mm and rad)", &[&r.count]),
        ResidualKind::Targets => words.fill("{0} coordinates of targets (mm)", &[&r.count]),
    };
    let from = match r.uncertainties_from {
        UncertaintyFrom::Instrument => words.say("from the instrument"),
        UncertaintyFrom::Residuals => words.say("from the residuals, each taken as independent"),
        UncertaintyFrom::ResidualsByPose => words.say("from the residuals, those of one pose taken together"),
        UncertaintyFrom::ResidualsByRegion => {
            words.say("from the residuals, those of one region of the workspace taken together")
        }
        UncertaintyFrom::Nothing => words.say("unknown: as many equations as parameters"),
    };
    let enlarged = match r.uncertainties_enlarged_by {
        1.0 => String::new(),
        by => format!(", {}", words.fill("{0} times what the instrument alone makes them (median)", &[&three(by)])),
    };
    let own = match (r.stated_standard_uncertainty_mm.map(derived), r.common_standard_uncertainty_mm.map(derived)) {
        (Some(own), Some(common)) => Some(words.fill("{0} mm (k = 1) for one coordinate, of each observation its own, and {1} mm common to all observations of one measured point", &[&own, &common])),
        (own, _) => own.map(|own| words.fill("{0} mm (k = 1) for one coordinate", &[&own])),
    };
    let chi_square =
        r.chi_square.map(|c| words.fill("{0} against {1} expected", &[&significant(c, 4), &r.degrees_of_freedom]));
    vec![
        (words.say("residuals"), count.into()),
        (words.say("RMS and max"), words.fill("{0} and {1}", &[&three(r.rms), &three(r.max)]).into()),
        (words.say("degrees of freedom"), r.degrees_of_freedom.into()),
        (words.say("stated uncertainty"), own.into()),
        (words.say("chi-square"), chi_square.into()),
        (words.say("uncertainties"), format!("{from}{enlarged}").into()),
    ]
}
