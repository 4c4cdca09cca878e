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
    use super::super::{certificate, verdict};
    use super::*;
    use crate::model::Contents;
    use crate::number::{fixed, significant};
    use crate::tests::demo::Documents;
    use crate::tests::demo_iso9283::whole;
    use crate::tests::demo_streams::streams;
    use etalon_documents::{Language, PoseCharacteristic};
    use std::path::Path;

    /// Tests of the demo and of the samples.
    fn tests() -> Vec<(String, Characteristics)> {
        let demo = Characteristics { streams: Some(streams()), ..whole() };
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/documents/0.1");
        let sample = |name: &str| {
            let read = |file: &str| std::fs::read_to_string(folder.join(name).join(file)).ok();
            let tested = Characteristics {
                poses: read("iso9283.json").map(|text| serde_json::from_str(&text).unwrap()),
                streams: read("iso9283-streams.json").map(|text| serde_json::from_str(&text).unwrap()),
                compliance: read("iso9283-compliance.json").map(|text| serde_json::from_str(&text).unwrap()),
            };
            assert!(!tested.is_empty(), "{name}");
            (name.to_owned(), tested)
        };
        vec![("demo".to_owned(), demo), sample("pose-test"), sample("prexyt-repeatability")]
    }

    /// Numbers of a clause as documents print them.
    fn results(clause: &str, tested: &Characteristics) -> Vec<String> {
        let um = |mm: f64| fixed(1e3 * mm, 1);
        let poses = tested.poses.iter();
        let recordings = || tested.streams.iter().flat_map(|d| &d.streams).map(|named| &named.stream);
        let paths = || recordings().filter_map(|stream| stream.path.as_ref());
        let settling = || recordings().flat_map(|stream| &stream.settling);
        let of = |characteristic: PoseCharacteristic| {
            let poses = tested.poses.iter().flat_map(|d| &d.poses);
            poses.filter_map(|p| (characteristic.value)(p)).map(um).collect()
        };
        match clause {
            "7.2.1" => of(PoseCharacteristic::AP),
            "7.2.2" => of(PoseCharacteristic::RP),
            "7.2.3" => poses.flat_map(|d| &d.approaches).map(|v| um(v.vap_mm)).collect(),
            "7.3" => poses.flat_map(|d| &d.distances).flat_map(|d| [um(d.ad_mm), um(d.rd_mm)]).collect(),
            "7.4" => settling().map(|s| fixed(s.stabilisation_s, 3)).collect(),
            "7.5" => settling().map(|s| um(s.overshoot_mm)).collect(),
            "7.6" => poses.flat_map(|d| &d.drifts).flat_map(|d| [um(d.dap_mm), um(d.drp_mm)]).collect(),
            "7.7" => poses.filter_map(|d| d.robot.exchangeability_mm).map(um).collect(),
            "8.2" => paths().filter(|p| !p.reorientation).map(|p| um(p.at_mm)).collect(),
            "8.3" => paths().filter_map(|p| p.rt_mm).map(um).collect(),
            "8.4" => paths().filter(|p| p.reorientation).map(|p| um(p.at_mm)).collect(),
            "8.5" => paths().flat_map(|p| &p.corners).flat_map(|c| [um(c.cr_mm), um(c.co_mm)]).collect(),
            "8.6" => paths().filter_map(|p| p.velocity.as_ref()).map(|v| fixed(v.av_percent, 2)).collect(),
            "9" => recordings().flat_map(|s| &s.posing).map(|p| fixed(p.posing_s, 3)).collect(),
            "10" => {
                let directions = tested.compliance.iter().flat_map(|d| &d.directions);
                directions.map(|d| significant(1e3 * d.compliance_mm_n, 3)).collect()
            }
            "11" => recordings().filter_map(|s| s.weaving.as_ref()).map(|w| fixed(w.ws_percent, 2)).collect(),
            other => panic!("no results of clause {other}"),
        }
    }

    /// Report and certificate of a test, without the table of clauses.
    fn printed(tested: &Characteristics) -> [(&'static str, String); 2] {
        let mut results = Documents::demo().results();
        (results.identified, results.geometric, results.tested) = (None, None, tested.clone());
        let results = results.judged();
        let words = Words::default();
        let text = |contents: &Contents| {
            let sections = contents.sections.iter().filter(|s| s.id != "clauses");
            serde_json::to_string(&sections.collect::<Vec<_>>()).unwrap()
        };
        let report = crate::campaign::contents(&results, &words);
        let certificate = certificate::contents(&results, crate::campaign::contents(&results, &words), &words);
        [("report", text(&report)), ("certificate", text(&certificate))]
    }

    #[test]
    fn every_clause_that_is_called_tested_has_its_results_in_the_same_document() {
        for (name, tested) in tests() {
            let documents = printed(&tested);
            for clause in CLAUSES.iter().filter(|clause| (clause.is_tested)(&tested)) {
                let expected = results(clause.number, &tested);
                assert!(!expected.is_empty(), "{name}: {}", clause.number);
                for (document, text) in &documents {
                    let numbers: Vec<&str> = text
                        .split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
                        .map(|number| number.trim_end_matches('.'))
                        .collect();
                    for value in &expected {
                        assert!(numbers.contains(&value.as_str()), "{name}, {document}, {}: {value}", clause.number);
                    }
                }
            }
        }
    }

    #[test]
    fn the_title_names_what_is_tested() {
        let words = Words::default();
        for (name, tested) in tests() {
            let title = verdict::title(&tested, &words);
            for symbol in CLAUSES.iter().filter(|c| (c.is_tested)(&tested)).flat_map(|c| c.symbols) {
                let words: Vec<&str> = title.split([' ', ',']).collect();
                assert!(words.contains(symbol), "{name}: {symbol} in {title}");
            }
        }
    }

    /// The velocity of a pose test is no condition of a recorded path.
    #[test]
    fn recorded_paths_have_their_own_velocity() {
        let mut results = Documents::demo().results();
        results.campaign.conditions.motion.velocities_mm_s = Some(vec![400.0]);
        results.tested = Characteristics { streams: Some(streams()), ..whole() };
        let words = Words::default();
        let report = crate::campaign::contents(&results, &words);
        let section = |id: &str| {
            let found = report.sections.iter().find(|s| s.id == id);
            serde_json::to_string(found.unwrap_or_else(|| panic!("no section {id}"))).unwrap()
        };
        let sentence = |velocity: String| tr!(words, "velocity-sentence", velocity);
        let of_path = sentence(tr!(words, "velocity-of-recording", value = "100", name = isolated("square")));
        let of_poses = sentence("400 mm/s".to_owned());
        for (id, expected, other) in [("streams", &of_path, &of_poses), ("repeatability", &of_poses, &of_path)] {
            let text = section(id);
            assert!(text.contains(expected.as_str()) && !text.contains(other.as_str()), "{text}");
        }
    }

    /// dRP has no sign: RP of the first and the last set show whether RP has grown.
    #[test]
    fn a_drift_shows_its_first_and_last_set() {
        let (_, tested) = tests().swap_remove(1);
        let drift = super::super::drift::section(&tested, &Words::default()).unwrap();
        let text = serde_json::to_string(&drift).unwrap();
        for d in &tested.poses.as_ref().unwrap().drifts {
            let (first, last) = (d.rp_mm[0], d.rp_mm[d.rp_mm.len() - 1]);
            for mm in [first, last] {
                assert!(text.contains(&fixed(1e3 * mm, 1)), "{mm} {text}");
            }
        }
        let head = phrase!("first-set", symbol = "RP").to_string();
        assert!(text.contains(&head), "{head} {text}");
    }

    #[test]
    fn compliance_has_an_expanded_uncertainty() {
        let text = serde_json::to_string(&super::super::compliance::section(&whole(), &Words::default()).unwrap());
        // twice 0.013 µm/N
        assert!(text.unwrap().contains("0.0260"));
    }

    #[test]
    fn one_approach_is_judged_where_visits_come_from_several() {
        let words = Words::default();
        let text = serde_json::to_string(&super::super::repeatability::section(&whole(), &words).unwrap()).unwrap();
        let table = text.split("\"header\"").find(|table| table.contains("\"95 %")).unwrap();
        let row = table.split("from pose 2").nth(1).unwrap();
        assert!(row.find("11.1").unwrap() < row.find("21.7").unwrap(), "{table}");
    }

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
