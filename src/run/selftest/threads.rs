//! Equal files, byte for byte, on one and on many threads.

use super::data::Data;
use super::row::{Rows, Subject, not_made};
use super::sample::Scratch;
use crate::run::pipeline::{Wanted, run_for};
use etalon_base::folder::Durability;
use etalon_base::message::{Message, Result};
use etalon_base::{error, files, phrase};
use std::collections::BTreeMap;
use std::path::Path;

pub(super) const SUBJECT: Subject =
    Subject { id: "threads", requirement: || phrase!("selftest-threads"), rows, slips: &[] };

/// Number of threads that is compared with one thread.
const MANY: usize = 4;

fn rows(_data: &Data) -> Vec<Rows> {
    let mut rows = Rows::new("prexyt-cmm");
    // in one folder: the second run replaces the files of the first one
    let both = Scratch::campaign().and_then(|scratch| Ok([written(&scratch, 1)?, written(&scratch, MANY)?]));
    match both {
        Ok([one, many]) => {
            let differing = one.iter().filter(|(name, hash)| many.get(*name) != Some(hash)).count();
            let others = many.keys().filter(|name| !one.contains_key(*name)).count();
            let test = phrase!("selftest-same-bytes", files = one.len(), threads = MANY);
            rows.add(test, "", [0.0, (differing + others) as f64], 0.0);
            rows.add(phrase!("selftest-files-written"), "", [1.0, f64::from(u8::from(one.len() > 10))], 0.0);
        }
        Err(problems) => rows.failed(not_made("prexyt-cmm", &problems)),
    }
    vec![rows]
}

/// SHA-256 of the files that a run of the embedded campaign writes, by name.
fn written(scratch: &Scratch, threads: usize) -> Result<BTreeMap<String, String>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let failed = |e: rayon::ThreadPoolBuildError| -> Message { error!("threads-failed", reason = e.to_string()) };
    let hash = |folder: &Path, file: &String| {
        let name = file.rsplit(['/', '\\']).next().unwrap_or_default();
        Ok((name.to_owned(), files::sha256(&files::read(&folder.join(name))?)))
    };
    pool.map_err(failed)?.install(|| {
        let campaign = scratch.read()?;
        let outcome = run_for(&campaign, Wanted::Reports, Durability::Later)?;
        let folder = campaign.output()?;
        outcome.written.iter().map(|file| hash(&folder, file)).collect()
    })
}
