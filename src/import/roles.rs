//! What the columns of a text may hold: by their names, or by what stands in them.

use super::guess::Guess;
use super::lexer::marked;
use crate::import::format::Decimal;
use crate::import::format::Role;
use std::borrow::Cow;

/// Roles by the names of the header, where it names every column and x and y; else by position: leading texts are the
/// label, the first numbers x, y, z, and a direction behind them i, j, k. A whole number before numbers with a decimal mark is
/// none of them.
pub(super) fn roles(guess: &Guess) -> Vec<Role> {
    let named: Vec<Role> = names(guess).into_iter().flatten().map(role_of).collect();
    let once = |role| named.iter().filter(|r| **r == role).count() == 1;
    match once(Role::X) && once(Role::Y) {
        true => single(named),
        false => by_position(guess),
    }
}

/// Roles of which each but the label is there once; what is there again is not read.
fn single(roles: Vec<Role>) -> Vec<Role> {
    let again = |i: usize| roles[..i].contains(&roles[i]) && roles[i] != Role::Skip;
    let axes = [Role::I, Role::J, Role::K].iter().all(|r| roles.contains(r));
    let partial = |role: Role| matches!(role, Role::I | Role::J | Role::K) && !axes;
    (0..roles.len()).map(|i| if again(i) || partial(roles[i]) { Role::Skip } else { roles[i] }).collect()
}

/// The names of all columns, if the header has as many as the data.
pub(super) fn names<'g>(guess: &'g Guess) -> Option<Vec<&'g str>> {
    let names = guess.names.as_ref()?.fields.iter().map(AsRef::as_ref);
    let names: Vec<&str> = names.collect();
    // a header of words, not of numbers
    (names.len() >= guess.numeric.len() && names.iter().any(|n| n.contains(char::is_alphabetic)))
        .then(|| names[..guess.numeric.len()].to_vec())
}

/// A name without its unit, in small letters: `X [mm]`, `x_mm` and `X` are one.
fn plain(name: &str) -> String {
    let name = name.split(['[', '(']).next().unwrap_or("").trim().to_lowercase();
    let name = ["_mm", "_m", "_inch", " mm"].iter().find_map(|unit| name.strip_suffix(unit)).unwrap_or(&name);
    name.to_owned()
}

fn role_of(name: &str) -> Role {
    match plain(name).as_str() {
        "x" => Role::X,
        "y" => Role::Y,
        "z" => Role::Z,
        "i" | "nx" => Role::I,
        "j" | "ny" => Role::J,
        "k" | "nz" => Role::K,
        "label" | "name" | "point" | "point_name" | "point name" | "id" => Role::Label,
        "target" => Role::Target,
        "pose" => Role::Pose,
        "cycle" | "run" | "repeat" => Role::Cycle,
        "time_s" => Role::TimeS,
        _ => Role::Skip,
    }
}

fn by_position(guess: &Guess) -> Vec<Role> {
    let count = guess.numeric.iter().filter(|n| **n).count();
    let directed = count == 6 && direction(guess);
    let mut axes =
        [Role::X, Role::Y, Role::Z].iter().chain(if directed { &[Role::I, Role::J, Role::K][..] } else { &[] });
    let mut before = usize::from(count % 3 == 1 && counted(guess));
    let leading = guess.numeric.iter().position(|n| *n).unwrap_or(0);
    let role = |(i, numeric): (usize, &bool)| match numeric {
        true if before > 0 => {
            before -= 1;
            Role::Skip
        }
        true => axes.next().copied().unwrap_or(Role::Skip),
        false if i < leading && !guess.first.fields.get(i).is_some_and(|field| is_time(field)) => Role::Label,
        false => Role::Skip,
    };
    guess.numeric.iter().enumerate().map(role).collect()
}

/// Whether the first number is whole, and the next three are not.
fn counted(guess: &Guess) -> bool {
    let mark = if guess.dialect.decimal == Decimal::Point { '.' } else { ',' };
    let numbers = guess.first.fields.iter().zip(&guess.numeric).filter(|(_, numeric)| **numeric);
    let marked: Vec<bool> = numbers.map(|(field, _)| field.contains(mark)).take(4).collect();
    marked == [false, true, true, true]
}

/// A date or a time of day.
fn is_time(cell: &str) -> bool {
    let digits = cell.bytes().filter(u8::is_ascii_digit).count();
    digits >= 4
        && cell.bytes().all(|b| b.is_ascii_digit() || matches!(b, b':' | b'-' | b'.' | b'/' | b' ' | b'T' | b'Z'))
}

/// Whether the last three numbers of the first row are a direction.
fn direction(guess: &Guess) -> bool {
    let number = |field: &Cow<str>| marked(field, guess.dialect.decimal, guess.dialect.thousands).ok();
    let numbers: Vec<f64> = guess.first.fields.iter().filter_map(number).collect();
    let [.., i, j, k] = numbers[..] else { return false };
    (crate::base::pose::norm([i, j, k]) - 1.0).abs() < 0.01
}

/// Whether the rows are joint values rather than points, and by what one sees it.
pub(super) fn looks_like_a_log(guess: &Guess) -> Option<String> {
    let names = names(guess).unwrap_or_default();
    let joints: Vec<&str> = names.iter().copied().filter(|name| is_joint(name)).collect();
    if joints.len() >= 2 {
        return Some(format!("the header names joints: {}", joints[..joints.len().min(6)].join(", ")));
    }
    let only_numbers = guess.numeric.iter().all(|n| *n) && names.is_empty();
    match guess.numeric.len() {
        n @ (6 | 7) if only_numbers && !direction(guess) => {
            Some(format!("every row is {n} numbers, and no direction among them"))
        }
        _ => None,
    }
}

/// `q1`, `J2`, `A3`, `joint_4`, `lbr_joint_0`, `actual_q_5`, `RP1`, `theta1`, `enc 2` and the like.
pub(super) fn is_joint(name: &str) -> bool {
    let name = name.split(['[', '(']).next().unwrap_or("").trim().to_lowercase();
    let name = ["_deg", "_rad", "_mm"].iter().find_map(|unit| name.strip_suffix(unit)).unwrap_or(&name);
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let word = stem.trim_end_matches(['_', ' ', '-', '.']);
    let stems = ["q", "j", "a", "rp", "rho", "theta", "axis", "enc", "encoder", "motor"];
    stem.len() < name.len() && (stems.contains(&word) || word.ends_with("joint") || word.ends_with("_q"))
}
