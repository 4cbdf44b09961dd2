//! A run through a text, from its declarations to its end; a second one where the first finds calls again.

use super::again::{Again, Calls};
use super::{Acc, Label, Lower};
use crate::ast::Unit;
use crate::diagnostics::{Found, Span};
use crate::names::Names;
use crate::rung::{Rungs, Step};
use std::collections::{HashMap, HashSet};

/// What has been compiled, before it is written as codes.
pub(crate) struct Lowered<'a> {
    pub steps: Vec<Step>,
    pub labels: Vec<Label>,
    pub names: Names<'a>,
    /// Whether the program stores anything.
    pub writes: bool,
}

/// Runs through a text, and once more where it calls an edge or a counter again.
pub(crate) fn lower<'a>(
    units: &'a [Unit],
    names: impl Fn() -> Names<'a>,
    found: &mut Found,
) -> Lowered<'a> {
    let before = found.clone();
    let (lowered, again) = run(units, names(), Again::default(), found);
    if again.is_empty() {
        return lowered;
    }
    *found = before;
    run(units, names(), again, found).0
}

fn run<'a>(
    units: &'a [Unit],
    names: Names<'a>,
    again: Again,
    found: &mut Found,
) -> (Lowered<'a>, Again) {
    let rungs = Rungs::new(names.temps);
    let mut lower = Lower {
        units,
        names,
        rungs,
        found,
        labels: Vec::new(),
        acc: Acc::Empty,
        links: 0,
        frames: Vec::new(),
        lost: 0,
        waiting: 0,
        scopes: Vec::new(),
        block: None,
        kept: Vec::new(),
        unused: None,
        unreachable: false,
        invert_load: false,
        called: HashSet::new(),
        calls: 0,
        functions: HashMap::new(),
        function_instances: HashMap::new(),
        coils: HashMap::new(),
        again,
        counted: Calls::default(),
        writes: false,
        told_open: None,
        ifs: Vec::new(),
        pushed: 0,
        full: false,
    };
    lower.declare_all();
    lower.initials();
    lower.renew(0, 0, &HashSet::new(), Span::default());
    lower.unit_body(0, 0, None, None);
    let again = std::mem::take(&mut lower.counted).again();
    lower.check_uncalled();
    lower.finish();
    let lowered = Lowered {
        steps: lower.rungs.steps,
        labels: lower.labels,
        names: lower.names,
        writes: lower.writes,
    };
    (lowered, again)
}
