//! Forms of the code that hide what it says: arguments in tuples, pairs of booleans, structs of many
//! fields, and behaviour that depends on the id of a message.

use crate::architecture::{crates, modules};
use crate::catalogue::drop_tests;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::path::Path;

/// Structs with more than 12 fields: documents, and sections of files of the user, whose fields are their keys.
const LONG: [&str; 10] = [
    "AccuracyDocument",
    "BatchEntry",
    "CampaignFile",
    "FormatsDocument",
    "Iso9283Path",
    "Iso9283Pose",
    "ParameterEntry",
    "ParametersDocument",
    "StreamDefinition",
    "Truth",
];

/// Names of values whose ids are not of messages: sections, questions, and entries of the catalogue. `Message::is` compares
/// its own.
const WITH_OTHER_IDS: [&str; 7] = ["entry", "other", "question", "s", "section", "self", "sheet"];

/// Reads the tokens of all code of the program, without its tests: of each file and each group in it, however deep.
fn each_group(note: &mut dyn FnMut(&Path, &[TokenTree])) {
    fn walk(path: &Path, tokens: TokenStream, note: &mut dyn FnMut(&Path, &[TokenTree])) {
        let mut all: Vec<TokenTree> = tokens.into_iter().collect();
        drop_tests(&mut all);
        note(path, &all);
        for token in all {
            if let TokenTree::Group(group) = token {
                walk(path, group.stream(), note);
            }
        }
    }
    for path in crates().iter().flat_map(|root| modules(root).into_values()) {
        walk(&path, std::fs::read_to_string(&path).unwrap().parse().unwrap(), note);
    }
}

fn is(token: Option<&TokenTree>, text: &str) -> bool {
    token.is_some_and(|token| token.to_string() == text)
}

/// The text of tokens up to commas that are in no group and in no angle brackets.
fn split(tokens: &[TokenTree]) -> Vec<&[TokenTree]> {
    let (mut depth, mut from, mut all) = (0, 0, Vec::new());
    for (i, token) in tokens.iter().enumerate() {
        match token.to_string().as_str() {
            "<" => depth += 1,
            ">" if i == 0 || !is(tokens.get(i - 1), "-") => depth -= 1,
            "," if depth == 0 => {
                all.push(&tokens[from..i]);
                from = i + 1;
            }
            _ => {}
        }
    }
    all.push(&tokens[from..]);
    all.retain(|part| !part.is_empty());
    all
}

/// Name and parameters of a function that begins at the index `at`: the tokens of each parameter.
fn parameters(all: &[TokenTree], at: usize) -> Option<(String, Vec<TokenTree>)> {
    let TokenTree::Ident(name) = all.get(at + 1).filter(|_| is(all.get(at), "fn"))? else { return None };
    let mut depth = 0;
    for (i, token) in all.iter().enumerate().skip(at + 2) {
        match token {
            TokenTree::Group(group) if depth == 0 => {
                let is_list = group.delimiter() == Delimiter::Parenthesis;
                return is_list.then(|| (name.to_string(), group.stream().into_iter().collect()));
            }
            _ if is(Some(token), "<") => depth += 1,
            _ if is(Some(token), ">") && !is(all.get(i - 1), "-") => depth -= 1,
            _ => {}
        }
    }
    None
}

/// Tokens of the type of a parameter, behind references and lifetimes.
fn kind(parameter: &[TokenTree]) -> &[TokenTree] {
    let colon = |i: &usize| {
        let before = i.checked_sub(1).and_then(|i| parameter.get(i));
        is(parameter.get(*i), ":") && !is(parameter.get(i + 1), ":") && !is(before, ":")
    };
    let Some(mut at) = (0..parameter.len()).find(colon).map(|i| i + 1) else { return &[] };
    while is(parameter.get(at), "&") || is(parameter.get(at), "mut") || is(parameter.get(at), "'") {
        at += if is(parameter.get(at), "'") { 2 } else { 1 };
    }
    &parameter[at..]
}

/// `true` for a tuple of at least two types.
fn is_tuple(kind: &[TokenTree]) -> bool {
    let Some(TokenTree::Group(group)) = kind.first() else { return false };
    let inside: Vec<TokenTree> = group.stream().into_iter().collect();
    group.delimiter() == Delimiter::Parenthesis && split(&inside).len() > 1
}

/// A tuple hides arguments from the limit of five, and two booleans of a call cannot be told apart. A pair of coordinates and
/// the two vectors of an axis have a type with a name.
#[test]
fn an_argument_is_not_hidden_in_a_tuple_and_two_of_a_call_are_no_booleans() {
    let mut wrong = String::new();
    each_group(&mut |path, all| {
        for (name, list) in (0..all.len()).filter_map(|at| parameters(all, at)) {
            let kinds: Vec<&[TokenTree]> = split(&list).into_iter().map(kind).collect();
            let booleans = kinds.iter().filter(|kind| kind.len() == 1 && is(kind.first(), "bool")).count();
            if booleans > 1 || kinds.into_iter().any(is_tuple) {
                wrong += &format!("{}: `{name}`\n", path.display());
            }
        }
    });
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn structs_have_at_most_twelve_fields() {
    let mut long = Vec::new();
    each_group(&mut |_, all| {
        for at in (0..all.len()).filter(|at| is(all.get(*at), "struct")) {
            let Some(TokenTree::Ident(name)) = all.get(at + 1) else { continue };
            let body = all[at + 2..].iter().find(|token| is(Some(token), ";") || matches!(token, TokenTree::Group(_)));
            let Some(TokenTree::Group(group)) = body else { continue };
            let fields: Vec<TokenTree> = group.stream().into_iter().collect();
            if group.delimiter() == Delimiter::Brace && split(&fields).len() > 12 {
                long.push(name.to_string());
            }
        }
    });
    long.sort();
    assert_eq!(long, LONG);
}

/// The words of a message change, and an id with them: what the program does depends on values with a type.
#[test]
fn behaviour_does_not_depend_on_the_id_of_a_message() {
    let mut wrong = String::new();
    each_group(&mut |path, all| {
        let text = |i: usize| all.get(i).map(ToString::to_string).unwrap_or_default();
        let is_compared = |at: usize| {
            let mut before = at - 1;
            while before > 0 && ["&", "*"].contains(&&*text(before - 1)) {
                before -= 1;
            }
            let is_match = before > 0 && text(before - 1) == "match";
            let left = before > 1 && text(before - 1) == "=" && ["=", "!"].contains(&&*text(before - 2));
            left || is_match || ["=", "!"].contains(&&*text(at + 2)) && text(at + 3) == "="
        };
        let is_id = |at: &usize| *at > 0 && text(*at) == "." && text(at + 1) == "id";
        let is_of_message = |at: &usize| !WITH_OTHER_IDS.contains(&&*text(at - 1));
        let compared = (0..all.len()).filter(is_id).filter(is_of_message).filter(|at| is_compared(*at)).count();
        let asked = (0..all.len()).filter(|at| text(*at) == "." && ["is", "contains"].contains(&&*text(at + 1)));
        let asked = asked.filter(|at| {
            let Some(TokenTree::Group(group)) = all.get(at + 2) else { return false };
            let inside: Vec<String> = group.stream().into_iter().map(|token| token.to_string()).collect();
            let id = inside.windows(3).any(|w| w[1] == "." && w[2] == "id" && !WITH_OTHER_IDS.contains(&&*w[0]));
            id || text(at + 1) == "is" && inside.first().is_some_and(|first| first.starts_with('"'))
        });
        for _ in 0..compared + asked.count() {
            wrong += &format!("{}\n", path.display());
        }
    });
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn hidden_arguments_are_found() {
    let found = |code: &str| {
        let all: Vec<TokenTree> = code.parse::<TokenStream>().unwrap().into_iter().collect();
        let (_, list) = parameters(&all, 0).unwrap();
        split(&list).into_iter().map(kind).filter(|kind| is_tuple(kind)).count()
    };
    assert_eq!(found("fn a<F: Fn((f64, f64)) -> f64>(f: F, (x, y): (f64, f64), z: &'a mut (A, B<C, D>))"), 2);
    assert_eq!(found("fn b(x: (), f: &(dyn Fn(usize, usize) + Sync), all: &[(f64, f64)], p: a::Pair<A, B>)"), 0);
}
