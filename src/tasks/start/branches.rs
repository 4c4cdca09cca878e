//! Branches of a URDF, by the files of measurements: the links whose chains reproduce the points of
//! the targets, where these are on several links.

use super::joint_keys;
use crate::tasks::urdf_text;
use etalon_base::message::printable;
use etalon_base::{error, phrase};
use etalon_campaign::parse_robot;
use etalon_formats::{TargetFit, fit_targets};
use etalon_robots::{Robot, TreeChain};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Factor by which the residual of a chain has to be smaller than the residual of another one.
pub(super) const BETTER: f64 = 3.0;
/// Target that stands for the targets of a chain.
const TARGET: &str = "target";

/// Branches that carry the targets of the files.
pub(super) struct Branches {
    /// robot.toml.
    pub text: String,
    /// Keys of the joints of all branches, with their units.
    pub joints: Vec<String>,
    /// Targets of all branches.
    pub targets: Vec<String>,
}

/// A target with the chains that reproduce its points about equally well, the shortest first.
struct Placed {
    target: String,
    chains: Vec<usize>,
    rms_mm: f64,
}

/// Proposes `[[branch]]` where the points of the targets show several links; `None` where one link
/// may carry all of them.
pub(super) fn branches(
    beside: &Path,
    name: &str,
    chains: &[TreeChain],
    files: &[PathBuf],
) -> anyhow::Result<Option<Branches>> {
    let build = |chain: &TreeChain| parse_robot(beside, &urdf_text(name, chain)).ok()?.build(&[TARGET.to_owned()]).ok();
    let robots: Vec<(usize, Box<dyn Robot>)> =
        chains.iter().enumerate().filter_map(|(at, chain)| Some((at, build(chain)?))).collect();
    let nominal: Vec<&dyn Robot> = robots.iter().map(|(_, robot)| robot.as_ref()).collect();
    let fits = fit_targets(files, &nominal)?;
    let at: Vec<usize> = robots.iter().map(|(at, _)| *at).collect();
    let placed: Vec<Placed> = fits.iter().filter_map(|(target, fits)| placed(target, &at, fits, chains)).collect();
    let links = links(&placed, chains);
    let bases: Vec<&str> = links.keys().map(|at| chains[*at].base_link.as_str()).collect();
    if links.len() < 2 || bases.iter().any(|base| *base != bases[0]) {
        return Ok(None);
    }
    let open: Vec<&str> =
        fits.keys().map(String::as_str).filter(|name| placed.iter().all(|placed| placed.target != **name)).collect();
    let mut joints: Vec<String> = Vec::new();
    for key in links.keys().flat_map(|at| joint_keys(&chains[*at])) {
        if !joints.contains(&key) {
            joints.push(key);
        }
    }
    let text = text(name, chains, &links, &open);
    let targets = placed.iter().map(|placed| placed.target.clone()).collect();
    Ok(Some(Branches { text, joints, targets }))
}

/// The chains that reproduce the points of a target; `None` if no chain does, or if two chains that
/// end differently do.
fn placed(target: &str, at: &[usize], fits: &[TargetFit], chains: &[TreeChain]) -> Option<Placed> {
    let rms = |fit: &TargetFit| if let TargetFit::Reproduced(rms_mm) = fit { Some(*rms_mm) } else { None };
    let best = fits.iter().filter_map(rms).fold(f64::INFINITY, f64::min);
    let is_alike = |fit: &TargetFit| rms(fit).is_some_and(|rms_mm| rms_mm < BETTER * best.max(f64::MIN_POSITIVE));
    let mut alike: Vec<usize> = at.iter().zip(fits).filter(|(_, fit)| is_alike(fit)).map(|(at, _)| *at).collect();
    alike.sort_by_key(|at| chains[*at].joints.len());
    let shortest = names(&chains[*alike.first()?]);
    let is_one = alike.windows(2).all(|pair| names(&chains[pair[1]]).starts_with(&names(&chains[pair[0]])));
    (is_one && !shortest.is_empty()).then(|| Placed { target: target.to_owned(), chains: alike, rms_mm: best })
}

/// The links that carry targets, each with its targets: as few links as the points allow.
fn links<'p>(placed: &'p [Placed], chains: &[TreeChain]) -> BTreeMap<usize, Vec<&'p Placed>> {
    let shortest: Vec<usize> = placed.iter().map(|placed| placed.chains[0]).collect();
    let mut links: BTreeMap<usize, Vec<&Placed>> = BTreeMap::new();
    for placed in placed {
        let farther = placed.chains.iter().copied().filter(|at| shortest.contains(at));
        let at = farther.max_by_key(|at| chains[*at].joints.len()).unwrap_or(placed.chains[0]);
        links.entry(at).or_default().push(placed);
    }
    links
}

/// Returns robot.toml with a branch for each link, and a question for each target that fits none.
fn text(name: &str, chains: &[TreeChain], links: &BTreeMap<usize, Vec<&Placed>>, open: &[&str]) -> String {
    let quoted = |text: &str| toml::Value::from(text).to_string();
    let base = links.keys().next().map_or("", |at| chains[*at].base_link.as_str());
    let mut text = format!("model = \"urdf\"\nfile = {}\nbase_link = {}\n", quoted(name), quoted(base));
    for (at, targets) in links {
        let rms_mm = targets.iter().map(|placed| placed.rms_mm).fold(0.0, f64::max);
        let reason = phrase!("tool-link-by-residual", rms_mm);
        let names: Vec<String> = targets.iter().map(|placed| quoted(&placed.target)).collect();
        let (link, names) = (quoted(&chains[*at].tool_link), names.join(", "));
        let reason = printable(&reason.to_string());
        let _ = write!(text, "\n[[branch]]\n# tool_link: {reason}\ntool_link = {link}\ntargets = [{names}]\n");
    }
    for target in open {
        let question = error!("target-on-no-branch", target);
        let _ = write!(text, "\n# QUESTION: {}\n", printable(&question.what));
    }
    text
}

/// Returns the names of the joints of a chain.
pub(super) fn names(chain: &TreeChain) -> Vec<&str> {
    chain.joints.iter().map(|joint| joint.name.as_str()).collect()
}
