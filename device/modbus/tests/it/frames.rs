//! The requests and replies of `frames.toml`.

use std::collections::BTreeSet;

use crate::common::uno::Uno;
use crate::common::{answer, bytes};
use serde::Deserialize;

#[derive(Deserialize)]
struct Table {
    case: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    /// Requests and their replies.
    frames: Vec<[String; 2]>,
}

fn cases() -> Vec<Case> {
    let table: Table = toml::from_str(include_str!("../frames.toml")).unwrap();
    table.case
}

#[test]
fn each_request_gets_its_reply() {
    let mut uno = Uno::default();
    for case in cases() {
        for [request, reply] in &case.frames {
            let expected = Some(bytes(reply)).filter(|reply| !reply.is_empty());
            let actual = answer(&mut uno, &bytes(request));
            assert_eq!(actual, expected, "{}: {request}", case.name);
        }
    }
}

#[test]
fn the_table_has_every_function_and_every_refusal_of_each() {
    let mut answered = BTreeSet::new();
    let mut refused = BTreeSet::new();
    for [_, reply] in cases().iter().flat_map(|case| &case.frames) {
        match *bytes(reply) {
            [_, function @ 0x80..=0xFF, code] => refused.insert((function & 0x7F, code)),
            [_, function, ..] => answered.insert(function),
            _ => false,
        };
    }
    let functions = [1, 2, 3, 4, 5, 6, 15, 16, 43];
    assert_eq!(answered, BTreeSet::from(functions));
    for function in functions {
        for code in [2, 3] {
            assert!(refused.contains(&(function, code)), "{function}, {code}");
        }
    }
}
