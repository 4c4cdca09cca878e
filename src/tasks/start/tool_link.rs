//! Tool link of a URDF, by the files of measurements: the chain whose joints the files have, and
//! whose kinematics the measured points fit.

use super::branches::{BETTER, branches, names};
use super::{DescribedRobot, joint_keys};
use crate::tasks::urdf_text;
use etalon_base::catalogue::Phrase;
use etalon_base::message::printable;
use etalon_base::phrase;
use etalon_campaign::{parse_robot, read_urdf_chains};
use etalon_documents::FormatsDocument;
use etalon_formats::{FilesProposal, heading_without_unit, propose_files};
use etalon_robots::TreeChain;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Maximum number of chains that are tried.
const TRIED: usize = 24;

/// Evidence of the files for a chain.
struct Evidence {
    /// `true` if the files name the joints of the chain.
    named: bool,
    /// `true` if a file has as many columns of joints.
    counted: bool,
    /// Residual of the nominal kinematics (mm), where joined rows test them.
    rms_mm: Option<f64>,
    /// Number of joints at the end of the chain that do not move in the files.
    still: usize,
}

/// Decision between chains.
enum Choice {
    /// Index of a chain, and its reason.
    Chain(usize, Phrase),
    /// Indices of chains that fit the files alike.
    Open(Vec<usize>),
}

/// Describes the robot of a URDF file by the chain that fits files of measurements.
pub(super) fn described(path: &Path, files: &[PathBuf]) -> anyhow::Result<DescribedRobot> {
    let (chains, urdf) = read_urdf_chains(path)?;
    let (longest, _) = etalon_campaign::read_urdf(path)?;
    if chains.len() < 2 || chains.len() > TRIED {
        return super::described(path);
    }
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let beside = path.with_file_name("robot.toml");
    if let Some(branches) = branches(&beside, &name, &chains, files)? {
        let (robot, text) = (branches.text.into_bytes(), urdf.into_bytes());
        return Ok(DescribedRobot { name, robot, text, joints: branches.joints, targets: branches.targets });
    }
    let evidence: Vec<Evidence> =
        chains.iter().map(|chain| evidence(&beside, &name, chain, files)).collect::<anyhow::Result<_>>()?;
    let (robot, joints) = match choice(&chains, &evidence, &longest) {
        Choice::Chain(at, reason) => {
            let remark = format!("# tool_link: {}\n", printable(&reason.to_string()));
            (remark + &urdf_text(&name, &chains[at]), joint_keys(&chains[at]))
        }
        Choice::Open(fit) => (open(&name, &chains, &fit), Vec::new()),
    };
    let (robot, text) = (robot.into_bytes(), urdf.into_bytes());
    Ok(DescribedRobot { name, robot, text, joints, targets: Vec::new() })
}

/// Returns robot.toml with the tool link as a question, and the links that fit.
fn open(name: &str, chains: &[TreeChain], fit: &[usize]) -> String {
    let mut text = String::new();
    for at in fit {
        let TreeChain { tool_link, joints, .. } = &chains[*at];
        let joints: Vec<&str> = joints.iter().map(|joint| joint.name.as_str()).collect();
        let line = phrase!("tool-link-fits", link = tool_link, joints);
        let _ = writeln!(text, "# {}", printable(&line.to_string()));
    }
    let chain = TreeChain { tool_link: "?".to_owned(), ..chains[fit[0]].clone() };
    text + &urdf_text(name, &chain)
}

/// Tests a chain against the files.
fn evidence(beside: &Path, name: &str, chain: &TreeChain, files: &[PathBuf]) -> anyhow::Result<Evidence> {
    let text = urdf_text(name, chain);
    let robot = parse_robot(beside, &text).and_then(|robot| robot.build(&["target".to_owned()])).ok();
    let FilesProposal { documents, still, .. } = propose_files(files, robot.as_deref())?;
    let joints: Vec<&str> = chain.joints.iter().map(|joint| joint.name.as_str()).collect();
    let headings = |document: &FormatsDocument| {
        let named = |joint: &&str| {
            let is_joint = |heading: &String| heading_without_unit(heading) == *joint;
            document.columns.iter().any(|column| column.heading.as_ref().is_some_and(is_joint))
        };
        joints.iter().all(named)
    };
    let count = |document: &FormatsDocument| document.columns.iter().filter(|column| column.joint.is_some()).count();
    let rms_mm = documents.iter().filter_map(|document| document.facts.reproduced_mm).reduce(f64::max);
    Ok(Evidence {
        named: documents.iter().any(|document| document.facts.joints_named || headings(document)),
        counted: documents.iter().any(|document| count(document) == joints.len()),
        rms_mm,
        still: joints.iter().rev().take_while(|joint| still.iter().any(|name| name == *joint)).count(),
    })
}

/// Chooses between chains with the same names or numbers of joints as the files, if no rows test
/// the kinematics: the longest, or the chains that end in a link without joints. Joints at the end
/// that do not move are omitted.
fn untested(chains: &[TreeChain], evidence: &[Evidence], fit: &[usize], by_name: bool) -> Choice {
    let longer = |at: &usize| {
        let own = names(&chains[*at]);
        // fingers with one joint, of which one mimics the other, are equally long
        let is_longer = |names: &[&str]| names.len() > own.len() && names.starts_with(&own);
        fit.iter().any(|other| is_longer(&names(&chains[*other])))
    };
    let moves = |at: &usize| evidence[*at].still == 0;
    let ends = |at: &&usize| chains[**at].is_end && moves(at) || !longer(at);
    let candidates: Vec<usize> = fit.iter().filter(ends).copied().collect();
    // of a chain whose last joints stand still, the part that moves
    let part = |at: usize| {
        let own = names(&chains[at]);
        if evidence[at].still == 0 {
            return at;
        }
        let moving = &own[..own.len() - evidence[at].still];
        fit.iter().copied().find(|other| names(&chains[*other]) == moving).unwrap_or(at)
    };
    let mut parts: Vec<usize> = candidates.iter().map(|at| part(*at)).collect();
    parts.sort_unstable();
    parts.dedup();
    match parts[..] {
        [at] if !candidates.contains(&at) || candidates.len() > 1 => Choice::Chain(at, phrase!("tool-link-moves")),
        [at] if by_name => Choice::Chain(at, phrase!("tool-link-by-names")),
        [at] => Choice::Chain(at, phrase!("tool-link-by-count", count = chains[at].joints.len())),
        _ => Choice::Open(parts),
    }
}

/// Chooses by the names and the count of joints, then by the residual; of chains that fit equally
/// well, the one with the fewest joints, if the others only add joints to it.
fn choice(chains: &[TreeChain], evidence: &[Evidence], longest: &TreeChain) -> Choice {
    let all: Vec<usize> = (0..chains.len()).collect();
    let of = |fits: &dyn Fn(&Evidence) -> bool| -> Vec<usize> {
        all.iter().copied().filter(|at| fits(&evidence[*at])).collect()
    };
    let named = of(&|evidence| evidence.named);
    let counted = of(&|evidence| evidence.counted);
    let (fit, by_name) = match (named.is_empty(), counted.is_empty()) {
        (false, _) => (named, true),
        (true, false) => (counted, false),
        // the files have no joints
        (true, true) => {
            let at = chains.iter().position(|chain| chain.tool_link == longest.tool_link).unwrap_or(0);
            return Choice::Chain(at, phrase!("tool-link-longest"));
        }
    };
    if let [at] = fit[..] {
        let count = chains[at].joints.len();
        let reason = if by_name { phrase!("tool-link-by-names") } else { phrase!("tool-link-by-count", count) };
        return Choice::Chain(at, reason);
    }
    let mut tested: Vec<(f64, usize)> = fit.iter().filter_map(|at| Some((evidence[*at].rms_mm?, *at))).collect();
    tested.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Some((best, _)) = tested.first().copied() else { return untested(chains, evidence, &fit, by_name) };
    let mut alike: Vec<usize> =
        tested.iter().filter(|(rms_mm, _)| *rms_mm < BETTER * best.max(f64::MIN_POSITIVE)).map(|(_, at)| *at).collect();
    alike.sort_by_key(|at| chains[*at].joints.len());
    let shortest = alike[0];
    let begins = |at: &usize| *at == shortest || names(&chains[*at]).starts_with(&names(&chains[shortest]));
    let rms_mm = evidence[shortest].rms_mm.unwrap_or(best);
    match alike.iter().all(begins) {
        true if alike.len() == 1 => Choice::Chain(shortest, phrase!("tool-link-by-residual", rms_mm)),
        true => Choice::Chain(shortest, phrase!("tool-link-shortest", rms_mm)),
        false => Choice::Open(alike),
    }
}
