//! Clauses of ISO 9283:1998: which of them a test covers, and how their evaluation is verified.

use crate::model::{Block, Columns, Section, Table, term};
use crate::words::{Words, isolated, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{Characteristics, Iso9283Document, Iso9283Path, Iso9283StreamDocument};

/// Evidence for the evaluation of a clause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verified {
    /// Formula from the text of the standard, reproduced on a published data set.
    Text,
    /// Compared with an independent program (`etalon selftest`).
    Program,
    /// Compared with simulated motions.
    Simulation,
}

/// Clause with its characteristics.
struct Clause {
    number: &'static str,
    name: fn() -> Phrase,
    symbols: &'static [&'static str],
    verified: Verified,
    is_tested: fn(&Characteristics) -> bool,
}

fn poses(tested: &Characteristics, has: impl Fn(&Iso9283Document) -> bool) -> bool {
    tested.poses.as_ref().is_some_and(has)
}

fn motions(tested: &Characteristics, has: impl Fn(&Iso9283StreamDocument) -> bool) -> bool {
    tested.streams.iter().flat_map(|document| &document.streams).any(|named| has(&named.stream))
}

fn paths(tested: &Characteristics, has: impl Fn(&Iso9283Path) -> bool) -> bool {
    motions(tested, |stream| stream.path.as_ref().is_some_and(&has))
}

/// All clauses with characteristics.
const CLAUSES: [Clause; 16] = [
    Clause {
        number: "7.2.1",
        name: || phrase!("clause-pose-accuracy"),
        symbols: &["AP"],
        verified: Verified::Program,
        is_tested: |t| poses(t, |d| d.poses.iter().any(|p| p.ap_mm.is_some())),
    },
    Clause {
        number: "7.2.2",
        name: || phrase!("clause-pose-repeatability"),
        symbols: &["RP"],
        verified: Verified::Text,
        is_tested: |t| poses(t, |d| d.poses.iter().any(|p| p.rp_mm.is_some())),
    },
    Clause {
        number: "7.2.3",
        name: || phrase!("clause-directions"),
        symbols: &["vAP"],
        verified: Verified::Program,
        is_tested: |t| poses(t, |d| !d.approaches.is_empty()),
    },
    Clause {
        number: "7.3",
        name: || phrase!("clause-distances"),
        symbols: &["AD", "RD"],
        verified: Verified::Program,
        is_tested: |t| poses(t, |d| !d.distances.is_empty()),
    },
    Clause {
        number: "7.4",
        name: || phrase!("clause-stabilisation"),
        symbols: &["t"],
        verified: Verified::Simulation,
        is_tested: |t| motions(t, |s| !s.settling.is_empty() || !s.arrivals.is_empty()),
    },
    Clause {
        number: "7.5",
        name: || phrase!("clause-overshoot"),
        symbols: &["OV"],
        verified: Verified::Simulation,
        is_tested: |t| motions(t, |s| !s.settling.is_empty() || !s.arrivals.is_empty()),
    },
    Clause {
        number: "7.6",
        name: || phrase!("clause-drift"),
        symbols: &["dAP", "dRP"],
        verified: Verified::Program,
        is_tested: |t| poses(t, |d| !d.drifts.is_empty()),
    },
    Clause {
        number: "7.7",
        name: || phrase!("clause-exchangeability"),
        symbols: &["E"],
        verified: Verified::Program,
        is_tested: |t| poses(t, |d| d.robot.exchangeability_mm.is_some()),
    },
    Clause {
        number: "8.2",
        name: || phrase!("clause-path-accuracy"),
        symbols: &["AT"],
        verified: Verified::Program,
        is_tested: |t| paths(t, |p| !p.reorientation),
    },
    Clause {
        number: "8.3",
        name: || phrase!("clause-path-repeatability"),
        symbols: &["RT"],
        verified: Verified::Program,
        is_tested: |t| paths(t, |p| p.rt_mm.is_some()),
    },
    Clause {
        number: "8.4",
        name: || phrase!("clause-reorientation"),
        symbols: &["AT"],
        verified: Verified::Simulation,
        is_tested: |t| paths(t, |p| p.reorientation),
    },
    Clause {
        number: "8.5",
        name: || phrase!("clause-cornering"),
        symbols: &["CR", "CO"],
        verified: Verified::Simulation,
        is_tested: |t| paths(t, |p| !p.corners.is_empty()),
    },
    Clause {
        number: "8.6",
        name: || phrase!("clause-velocity"),
        symbols: &["AV", "RV", "FV"],
        verified: Verified::Program,
        is_tested: |t| paths(t, |p| p.velocity.is_some()),
    },
    Clause {
        number: "9",
        name: || phrase!("clause-posing-time"),
        symbols: &[],
        verified: Verified::Simulation,
        is_tested: |t| motions(t, |s| !s.posing.is_empty()),
    },
    Clause {
        number: "10",
        name: || phrase!("clause-compliance"),
        symbols: &[],
        verified: Verified::Program,
        is_tested: |t| t.compliance.is_some(),
    },
    Clause {
        number: "11",
        name: || phrase!("clause-weaving"),
        symbols: &["WS", "WF"],
        verified: Verified::Simulation,
        is_tested: |t| motions(t, |s| s.weaving.is_some()),
    },
];

/// Table of the clauses: tested, not tested, and how verified.
pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    if tested.is_empty() {
        return None;
    }
    let verified = |clause: &Clause| match clause.verified {
        Verified::Text => tr!(words, "verified-by-text"),
        Verified::Program => tr!(words, "verified-by-program"),
        Verified::Simulation => tr!(words, "verified-by-simulation"),
    };
    let columns = Columns::<Clause>::new()
        .both(phrase!("head-clause"), "", |c| c.number)
        .both(phrase!("head-characteristic"), "", |c| words.tr(&(c.name)()))
        .both(phrase!("head-symbols"), "", |c| c.symbols.join(", "))
        .both(phrase!("head-tested"), "", |c| match (c.is_tested)(tested) {
            true => term(words, phrase!("clause-tested")),
            false => term(words, phrase!("clause-not-tested")),
        })
        .both(phrase!("head-verified"), "", verified)
        .decisive();
    let listed = |is_tested: bool| {
        let clauses = CLAUSES.iter().filter(|clause| (clause.is_tested)(tested) == is_tested);
        let named = clauses.map(|clause| match clause.symbols {
            // the point of a clause is no decimal mark
            [] => isolated(clause.number),
            symbols => format!("{} ({})", isolated(clause.number), symbols.join(", ")),
        });
        named.collect::<Vec<_>>().join(", ")
    };
    let mut section = Section::new("clauses", tr!(words, "clauses-title"));
    section.push(Block::note(tr!(words, "clauses-summary", tested = listed(true), untested = listed(false))));
    let table = Block::Table(Table::new(words, &CLAUSES, columns).on(phrase!("sheet-clauses")));
    let blocks = vec![table, Block::note(tr!(words, "clauses-note"))];
    section.push(Block::Aside { title: tr!(words, "clauses-evidence"), blocks });
    section.whole()
}

/// Characteristics that are tested, in words, for the title of a report.
pub(super) fn tested_characteristics(tested: &Characteristics, words: &Words) -> String {
    let name = |clause: &Clause| match clause.symbols {
        [] => words.tr(&(clause.name)()),
        symbols => symbols.join(", "),
    };
    let mut names: Vec<String> = CLAUSES.iter().filter(|clause| (clause.is_tested)(tested)).map(name).collect();
    names.dedup();
    names.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo_iso9283::whole;
    use etalon_documents::Language;

    #[test]
    fn numbers_of_clauses_keep_their_point_in_every_language() {
        for language in [Language::En, Language::De, Language::Fr] {
            let text = serde_json::to_string(&section(&whole(), &Words::new(language)).unwrap()).unwrap();
            assert!(text.contains("7.3") && !text.contains("7,3"), "{text}");
        }
    }

    #[test]
    fn the_title_claims_what_the_table_shows() {
        let (words, mut tested) = (Words::default(), whole());
        let rows = |tested: &Characteristics| {
            let table = serde_json::to_string(&section(tested, &Words::default()).unwrap()).unwrap();
            (table.matches("\"not tested\"").count(), CLAUSES.iter().filter(|c| (c.is_tested)(tested)).count())
        };
        let (not, are) = rows(&tested);
        assert_eq!(not + are, CLAUSES.len());
        let title = tested_characteristics(&tested, &words);
        assert!(title.starts_with("AP, RP"), "{title}");
        let document = tested.poses.as_mut().unwrap();
        document.poses.iter_mut().for_each(|p| p.ap_mm = None);
        let fewer = rows(&tested);
        assert_eq!((fewer.0, fewer.1), (not + 1, are - 1));
        assert!(tested_characteristics(&tested, &words).starts_with("RP"));
        assert!(section(&Characteristics::default(), &words).is_none());
    }
}
