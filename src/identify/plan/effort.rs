//! Effort of a search: as much as given, or as much as the problem deserves.
//!
//! Small problems are searched from many starts, and proved. A large problem ends as soon as its
//! choice is within one per cent of the bound.

use super::Request;
use super::bound::{BELOW, Proven, Root};
use super::criterion::Pool;
use super::search::{Choice, exchange_from_many};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Number of random starts, unless given.
const STARTS: u64 = 10;
/// Maximum number of nodes of branch and bound, unless given.
const NODES: usize = 4000;
/// Share of the index below the bound that is enough for a large problem.
const ENOUGH: f64 = 0.01;
/// Number of products in a step of the relaxation of the largest problem that is not large: a
/// hundred candidates with thirty parameters.
const LARGE: usize = 150_000;
/// Number of products that branch and bound of a large problem may take, unless given otherwise.
const BUDGET: usize = 4_000_000_000;

/// The best choice found, with its proof if a bound is known.
pub(super) struct Searched {
    pub(super) best: Choice,
    pub(super) proven: Option<Proven>,
}

/// Improves the choices `first`, and bounds the best one. `check` judges the improved choice before
/// more effort is spent on it.
pub(super) fn search<E>(
    pool: &Pool,
    first: &[Choice],
    request: &Request,
    progress: &(dyn Fn(usize, usize) + Sync),
    check: impl Fn(&Choice) -> Result<(), E>,
) -> Result<Searched, E> {
    let count = first.first().map_or(0, |c| c.chosen.len());
    let starts = first.len() + request.starts.unwrap_or(STARTS) as usize;
    let steps = starts + request.nodes.unwrap_or(NODES);
    let exchanged = AtomicUsize::new(0);
    let ended = || progress(exchanged.fetch_add(1, Ordering::Relaxed) + 1, steps);
    let improve = || exchange_from_many(pool, first, 0, request.seed, ended);
    let (found, root) = rayon::join(improve, || Root::new(pool, count));
    check(&found)?;
    let products = pool.products();
    let is_large = products > LARGE;
    let enough = |found: &Choice| {
        let is_close = |root: &Root| (found.value / root.bound()).sqrt() >= 1.0 - ENOUGH;
        is_large && root.as_ref().is_some_and(is_close)
    };
    let more = request.starts.unwrap_or(if enough(&found) { 0 } else { STARTS });
    let found = match more {
        0 => found,
        _ => exchange_from_many(pool, &[found], more, request.seed, ended),
    };
    let affordable = if is_large { BUDGET / (products * BELOW.steps) } else { NODES };
    let nodes = request.nodes.unwrap_or(if enough(&found) { 0 } else { NODES.min(affordable) });
    let looked = |nodes: usize| progress((starts + nodes).min(steps - 1), steps);
    let proven = root.map(|root| root.prove(pool, found.clone(), nodes, looked));
    progress(steps, steps);
    let best = proven.as_ref().map_or(found, |p| p.best.clone());
    Ok(Searched { best, proven })
}
