//! Timers that are called in more places than one. A loop may come to each of them as often as it likes.
//!
//! Owns which of them the board calls again (NC-30), and what takes the place of the others: calls that only reset a TON
//! become its reset; what is left of several calls becomes steps that keep the timer in cells, by the time stamp of the
//! scan. Must not know markers, registers and instructions.

use super::codes::is_timer;
use super::flat::{Does, Flat, Step, both, compare, constant, not, place, read, whole, within};
use super::ranges::bounds;
use super::uses::Uses;
use std::collections::{HashMap, HashSet};
use unoclp_core::isa;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Cell, Compare, Expr, ExprKind, Order, Standard, Store, Value};

// The parts of a timer.
const IN: u32 = 0;
const PT: u32 = 1;
const Q: u32 = 2;
const ET: u32 = 3;
/// IN of the call before.
const BEFORE: u32 = 4;
/// When its time began to run.
const BEGAN: u32 = 5;

/// A call of a TON with IN = FALSE makes it what it was before it ever started, as `RWT` does, whatever PT is.
pub(super) fn reset(flat: &mut Flat) {
    let mut calls = HashMap::new();
    count(&flat.body, &mut calls);
    calls.retain(|_, calls: &mut Calls| calls.resets > 0 && calls.others > 0 && calls.gives);
    if calls.is_empty() {
        return;
    }
    let uses = Uses::of(flat);
    let body = std::mem::take(&mut flat.body);
    flat.body = with_resets(body, &calls, &uses);
}

/// The calls of a TON: those that only reset it, and the others.
#[derive(Default)]
struct Calls {
    resets: u32,
    others: u32,
    /// Whether each of those gives IN.
    gives: bool,
    /// Whether each of those gives a preset that is known.
    sets: bool,
}

/// What the steps right before a call give it: the part and the value of each.
fn given(before: &[Step], cell: u32) -> impl Iterator<Item = (u32, &Expr)> {
    let members = cell..cell + Standard::Ton.cells();
    before.iter().rev().map_while(move |step| match &step.does {
        Does::Assign(to, value, Store::Narrow(_))
            if to.indices.is_empty() && members.contains(&to.offset) =>
        {
            Some((to.offset - cell, value))
        }
        _ => None,
    })
}

fn known(expr: &Expr) -> Option<&Value> {
    match &expr.kind {
        ExprKind::Constant(value) => Some(value),
        _ => None,
    }
}

/// Whether IN is FALSE for certain.
fn resets(before: &[Step], cell: u32) -> bool {
    let on = given(before, cell).find(|(part, _)| *part == IN);
    on.and_then(|(_, on)| known(on))
        .is_some_and(|on| !on.is_true())
}

fn count(steps: &[Step], calls: &mut HashMap<u32, Calls>) {
    for (at, step) in steps.iter().enumerate() {
        if let Does::Standard(Standard::Ton, cell, _) = step.does {
            let (calls, before) = (calls.entry(cell).or_default(), &steps[..at]);
            if resets(before, cell) {
                calls.resets += 1;
            } else {
                let of = |part| given(before, cell).find(|(is, _)| *is == part);
                let is_only = calls.others == 0;
                calls.others += 1;
                calls.gives = of(IN).is_some() && (is_only || calls.gives);
                let preset = of(PT).and_then(|(_, preset)| known(preset));
                calls.sets = preset.is_some() && (is_only || calls.sets);
            }
        }
        for inner in within(&step.does) {
            count(inner, calls);
        }
    }
}

fn with_resets(steps: Vec<Step>, calls: &HashMap<u32, Calls>, uses: &Uses) -> Vec<Step> {
    let mut out: Vec<Step> = Vec::with_capacity(steps.len());
    for mut step in steps {
        if let Does::Standard(Standard::Ton, cell, _) = step.does
            && let Some(calls) = calls.get(&cell)
            && resets(&out, cell)
        {
            let gives = given(&out, cell).count();
            let is_needed = |step: &Step| match &step.does {
                Does::Assign(to, ..) => {
                    let is_read = uses.get(to.offset).is_some_and(|of| of.reads > 0);
                    is_read || to.offset == cell + PT && !calls.sets
                }
                _ => true,
            };
            let inputs = out.split_off(out.len() - gives);
            out.extend(inputs.into_iter().filter(is_needed));
            step.does = Does::Order(Order::Reset, Standard::Ton, cell);
        }
        step.does = step
            .does
            .with_inner(&mut |steps| with_resets(steps, calls, uses));
        out.push(step);
    }
    out
}

/// Keeps the timers that are still called again in cells of their own; gives what is done with each cell then.
pub(super) fn keep(flat: &mut Flat, uses: Uses) -> Uses {
    let again = uses.blocks.iter();
    let again = again.filter(|(_, called)| called.block.is_timer() && called.count > 1);
    let mut again: HashSet<u32> = again.map(|(cell, _)| *cell).collect();
    boards(flat, &uses, &mut again);
    if again.is_empty() {
        return uses;
    }
    let now = flat.now();
    let held = [Base::Dint, Base::Bool].map(|base| {
        flat.cells.push(Cell::own(base));
        flat.cells.len() as u32 - 1
    });
    for timer in &again {
        if let Some(began) = flat.cells.get_mut((timer + BEGAN) as usize) {
            *began = Cell::own(Base::Dint);
        }
    }
    let body = std::mem::take(&mut flat.body);
    let mut timers: Vec<(u32, Standard)> = uses
        .blocks
        .iter()
        .filter(|(timer, _)| again.contains(timer))
        .map(|(timer, called)| (*timer, called.block))
        .collect();
    timers.sort_unstable_by_key(|(timer, _)| *timer);
    let mut within_loops = HashSet::new();
    looped(&body, &mut within_loops);
    let mut keeper = Keeper {
        again,
        uses,
        now,
        held,
        follows: HashSet::new(),
        looped: within_loops,
    };
    let mut steps: Vec<Step> = timers
        .into_iter()
        .filter_map(|(timer, block)| {
            let at = Span::default();
            let does = keeper.timer(timer, at).stands(block)?;
            let shown = false;
            Some(Step { does, at, shown })
        })
        .collect();
    steps.extend(keeper.steps(body));
    flat.body = steps;
    Uses::of(flat)
}

/// Takes those away that the board can call again: each call gives IN, and a preset that is known. What an off-delay shows
/// as its time is by an edge, which knows one call; and what is kept over a power cut is no timer of the board.
fn boards(flat: &Flat, uses: &Uses, again: &mut HashSet<u32>) {
    let timers = uses
        .blocks
        .values()
        .filter(|called| called.block.is_timer());
    if timers.count() + written(&flat.body) > isa::CALLED_AGAIN.into() {
        return;
    }
    let mut fit = again.clone();
    fit.retain(|cell| {
        let is_kept = flat.cells.get(*cell as usize).is_none_or(|of| of.retain);
        let shows = uses.get(cell + ET).is_some_and(|of| of.reads > 0);
        let is_off = uses
            .blocks
            .get(cell)
            .is_some_and(|of| of.block == Standard::Tof);
        !(is_kept || shows && is_off || uses.preset.contains(cell))
    });
    each_call(&flat.body, &mut |cell, inputs| {
        let given = |part: u32| inputs.iter().find(|(of, _)| *of == part);
        let is_known = |(_, value): &(u32, Expr)| known(value).is_some();
        if given(IN).is_none() || !given(PT).is_some_and(is_known) {
            fit.remove(&cell);
        }
    });
    again.retain(|cell| !fit.contains(cell));
}

/// How many timers the text writes by their codes.
fn written(steps: &[Step]) -> usize {
    let of = |step: &Step| {
        let own = match &step.does {
            Does::Codes(_, codes, _) => codes.first().is_some_and(|(code, _)| is_timer(*code)),
            _ => false,
        };
        let inner = within(&step.does).into_iter().map(written);
        usize::from(own) + inner.sum::<usize>()
    };
    steps.iter().map(of).sum()
}

fn each_call(steps: &[Step], found: &mut impl FnMut(u32, &[(u32, Expr)])) {
    for step in steps {
        if let Does::Standard(_, cell, inputs) = &step.does {
            found(*cell, inputs);
        }
        for inner in within(&step.does) {
            each_call(inner, found);
        }
    }
}

struct Keeper {
    again: HashSet<u32>,
    uses: Uses,
    /// The cell of the time stamp of the scan.
    now: u32,
    /// Those of a preset and of IN while a call works.
    held: [u32; 2],
    /// The timers that may be called again in this scan, behind where it is.
    follows: HashSet<u32>,
    /// Those that are called within a loop.
    looped: HashSet<u32>,
}

impl Keeper {
    /// From the last step to the first.
    fn steps(&mut self, steps: Vec<Step>) -> Vec<Step> {
        let mut out = Vec::with_capacity(steps.len());
        for mut step in steps.into_iter().rev() {
            let at = step.at;
            let made = match &step.does {
                Does::Standard(block, cell, inputs) if self.again.contains(cell) => {
                    let made = self.timer(*cell, at).call(*block, inputs);
                    self.follows.insert(*cell);
                    made
                }
                Does::Order(order, block, cell) if self.again.contains(cell) => {
                    self.timer(*cell, at).order(order, *block)
                }
                _ => {
                    let behind = self.follows.clone();
                    let mut all = behind.clone();
                    step.does = step.does.with_inner(&mut |steps| {
                        self.follows.clone_from(&behind);
                        let steps = self.steps(steps);
                        all.extend(&self.follows);
                        steps
                    });
                    self.follows = all;
                    out.push(step);
                    continue;
                }
            };
            let step = |does| Step {
                does,
                at,
                shown: false,
            };
            out.extend(made.into_iter().rev().map(step));
        }
        out.reverse();
        out
    }

    fn timer(&self, cell: u32, at: Span) -> Timer {
        Timer {
            cell,
            now: self.now,
            held: self.held,
            at,
            shows: self.uses.get(cell + ET).is_some_and(|of| of.reads > 0),
            follows: self.follows.contains(&cell) || self.looped.contains(&cell),
        }
    }
}

/// The timers that are called between a label and a jump back to it.
fn looped(steps: &[Step], all: &mut HashSet<u32>) {
    for (at, step) in steps.iter().enumerate() {
        within(&step.does)
            .into_iter()
            .for_each(|inner| looped(inner, all));
        let Does::Label(label) = step.does else {
            continue;
        };
        let last = steps.iter().rposition(|step| leads_to(step, label));
        if let Some(turn) = last.and_then(|last| steps.get(at..=last)) {
            turn.iter().for_each(|step| called(step, all));
        }
    }
}

fn leads_to(step: &Step, label: u32) -> bool {
    matches!(step.does, Does::Jump(_, to, _) if to == label)
        || within(&step.does)
            .into_iter()
            .flatten()
            .any(|step| leads_to(step, label))
}

fn called(step: &Step, all: &mut HashSet<u32>) {
    if let Does::Standard(_, cell, _) = step.does {
        all.insert(cell);
    }
    let inner = within(&step.does).into_iter().flatten();
    inner.for_each(|step| called(step, all));
}

/// A timer in cells, at one of its calls.
struct Timer {
    cell: u32,
    now: u32,
    held: [u32; 2],
    at: Span,
    /// Whether something reads ET.
    shows: bool,
    /// Whether it may be called again in this scan.
    follows: bool,
}

impl Timer {
    fn bit(&self, part: u32) -> Expr {
        read(self.cell + part, Base::Bool, self.at)
    }

    fn number(&self, part: u32) -> Expr {
        read(self.cell + part, Base::Dint, self.at)
    }

    fn now(&self) -> Expr {
        read(self.now, Base::Dint, self.at)
    }

    /// ms since its time began to run.
    fn elapsed(&self) -> Expr {
        both(Binary::Subtract, self.now(), self.number(BEGAN))
    }

    fn set(&self, part: u32, value: Expr) -> Does {
        self.store(self.cell + part, value)
    }

    fn store(&self, cell: u32, value: Expr) -> Does {
        let base = value.base;
        Does::Assign(place(cell, self.at), value, Store::Narrow(base))
    }

    fn put(&self, part: u32, truth: bool) -> Does {
        let value = constant(Value::truth(truth), Base::Bool, self.at);
        self.set(part, value)
    }

    /// ET, where something reads it.
    fn show(&self, value: Expr) -> Option<Does> {
        self.shows.then(|| self.set(ET, value))
    }

    fn none(&self) -> Expr {
        whole(0, Base::Dint, self.at)
    }

    fn when(&self, condition: Expr, then: Vec<Does>, otherwise: Vec<Does>) -> Does {
        let steps = |all: Vec<Does>| {
            let step = |does| Step {
                does,
                at: self.at,
                shown: false,
            };
            all.into_iter().map(step).collect()
        };
        Does::If(condition, steps(then), steps(otherwise))
    }

    /// Or the steps of one side alone, where the condition is known.
    fn either(&self, condition: Expr, then: Vec<Does>, otherwise: Vec<Does>) -> Vec<Does> {
        match known(&condition).map(Value::is_true) {
            Some(true) => then,
            Some(false) => otherwise,
            None => vec![self.when(condition, then, otherwise)],
        }
    }

    /// A call, as the interpreter's `blocks` do it.
    fn call(&self, block: Standard, inputs: &[(u32, Expr)]) -> Vec<Does> {
        let input = |part| inputs.iter().find(|(of, _)| *of == part);
        let mut does = Vec::new();
        let preset = match input(PT) {
            Some((_, preset)) if known(preset).is_some() => Expr {
                base: Base::Dint,
                ..preset.clone()
            },
            Some((_, preset)) => {
                let [held, _] = self.held;
                does.push(self.store(held, preset.clone()));
                read(held, Base::Dint, self.at)
            }
            None => self.number(PT),
        };
        let on = input(IN).map_or_else(|| self.bit(IN), |(_, on)| on.clone());
        let is_asked_again = matches!(block, Standard::Tp | Standard::Tonr);
        let on = match is_asked_again && input(IN).is_some() && known(&on).is_none() {
            true => {
                let [_, held] = self.held;
                does.push(self.store(held, on));
                read(held, Base::Bool, self.at)
            }
            false => on,
        };
        let over = compare(Compare::GreaterEqual, self.elapsed(), preset.clone());
        let preset = match bounds(&preset).0 < 0 {
            true => both(Binary::Max, preset, self.none()),
            false => preset,
        };
        does.extend(match block {
            Standard::Tof => self.off_delay(on, over, preset),
            Standard::Tp => self.pulse(on, over, preset),
            Standard::Tonr => self.retentive(on, over, preset),
            _ => self.on_delay(on, over, preset),
        });
        does
    }

    /// Its time would begin now, where the next call may follow in this scan; each scan begins with that anyway.
    fn begins_anew(&self) -> Option<Does> {
        self.follows.then(|| self.set(BEGAN, self.now()))
    }

    /// What each scan begins with: while its time stands, it would begin now.
    fn stands(&self, block: Standard) -> Option<Does> {
        let stands = match block {
            Standard::Ton => not(self.bit(BEFORE)),
            Standard::Tof => self.bit(BEFORE),
            _ => return None,
        };
        let now = vec![self.set(BEGAN, self.now())];
        Some(self.when(stands, now, Vec::new()))
    }

    fn on_delay(&self, on: Expr, over: Expr, preset: Expr) -> Vec<Does> {
        if known(&on).is_none() && !self.shows {
            let is_over = both(Binary::And, self.bit(BEFORE), over);
            let mut stands = vec![self.put(Q, false)];
            stands.extend(self.begins_anew());
            return vec![
                self.set(BEFORE, on),
                self.when(is_over, vec![self.put(Q, true)], Vec::new()),
                self.when(not(self.bit(BEFORE)), stands, Vec::new()),
            ];
        }
        let mut runs = vec![self.put(BEFORE, true)];
        let mut done = vec![self.put(Q, true)];
        let over = match self.shows {
            true => {
                runs.extend(self.show(self.elapsed()));
                done.extend(self.show(preset));
                both(Binary::Or, self.bit(Q), over)
            }
            false => over,
        };
        runs.push(self.when(over, done, Vec::new()));
        let mut stands = vec![self.put(BEFORE, false), self.put(Q, false)];
        stands.extend(self.begins_anew());
        stands.extend(self.show(self.none()));
        self.either(on, runs, stands)
    }

    fn off_delay(&self, on: Expr, over: Expr, preset: Expr) -> Vec<Does> {
        let mut stands = vec![self.put(BEFORE, true), self.put(Q, true)];
        stands.extend(self.begins_anew());
        stands.extend(self.show(self.none()));
        let mut falls = vec![self.put(BEFORE, false)];
        let mut done = vec![self.put(Q, false)];
        falls.push(match self.shows {
            true => {
                done.extend(self.show(preset));
                let runs = self.show(self.elapsed()).into_iter().collect();
                let looks = vec![self.when(over, done, runs)];
                self.when(self.bit(Q), looks, Vec::new())
            }
            false => self.when(over, done, Vec::new()),
        });
        self.either(on, stands, falls)
    }

    fn pulse(&self, on: Expr, over: Expr, preset: Expr) -> Vec<Does> {
        let rises = both(Binary::And, on.clone(), not(self.bit(BEFORE)));
        let begins = both(Binary::And, rises, not(self.bit(Q)));
        let begun = vec![self.set(BEGAN, self.now()), self.put(Q, true)];
        let runs = both(Binary::And, self.bit(Q), not(over));
        let running = self.show(self.elapsed()).into_iter().collect();
        let mut done = vec![self.put(Q, false)];
        if self.shows {
            let (held, none) = (self.set(ET, preset), self.set(ET, self.none()));
            done.extend(self.either(on.clone(), vec![held], vec![none]));
        }
        vec![
            self.when(begins, begun, Vec::new()),
            self.set(BEFORE, on),
            self.when(runs, running, done),
        ]
    }

    /// `BEGAN` is when IN rose, less what was gathered before; where IN is 0, what has been gathered.
    fn retentive(&self, on: Expr, over: Expr, preset: Expr) -> Vec<Does> {
        let changes = both(Binary::Xor, on.clone(), self.bit(BEFORE));
        let changed = vec![
            self.set(BEGAN, self.elapsed()),
            self.set(BEFORE, on.clone()),
        ];
        let full = both(Binary::And, on.clone(), over);
        let mut gathers = vec![self.when(changes, changed, Vec::new())];
        gathers.push(self.when(full, vec![self.put(Q, true)], Vec::new()));
        if self.shows {
            let most = |gathered| both(Binary::Min, gathered, preset.clone());
            let runs = vec![self.set(ET, most(self.elapsed()))];
            let stands = vec![self.set(ET, most(self.number(BEGAN)))];
            gathers.extend(self.either(on, runs, stands));
        }
        let full = self.show(preset).into_iter().collect();
        vec![self.when(not(self.bit(Q)), gathers, full)]
    }

    /// What an instruction of the board does to it.
    fn order(&self, order: &Order, block: Standard) -> Vec<Does> {
        match order {
            Order::Preset(value) => vec![self.set(PT, value.clone())],
            Order::Reset => {
                let mut all = vec![self.put(BEFORE, false), self.put(Q, false)];
                match block {
                    Standard::Ton => all.extend(self.begins_anew()),
                    Standard::Tonr => all.push(self.set(BEGAN, self.none())),
                    _ => {}
                }
                all.extend(self.show(self.none()));
                all
            }
            Order::Look => self.look(block),
            Order::Load | Order::Number(_) => Vec::new(),
        }
    }

    /// ET at this moment (NC-14).
    fn look(&self, block: Standard) -> Vec<Does> {
        let preset = || both(Binary::Max, self.number(PT), self.none());
        let (on, q) = (|| self.bit(BEFORE), || self.bit(Q));
        let runs = match block {
            Standard::Tof => both(Binary::And, q(), not(on())),
            Standard::Tp => q(),
            _ => both(Binary::And, on(), not(q())),
        };
        let running = both(Binary::Min, self.elapsed(), preset());
        let (is_held, held) = match block {
            Standard::Tp => (on(), self.none()),
            Standard::Tof => (
                constant(Value::truth(false), Base::Bool, self.at),
                self.none(),
            ),
            Standard::Tonr => (q(), both(Binary::Min, self.number(BEGAN), preset())),
            _ => (q(), self.none()),
        };
        let stands = self.either(
            is_held,
            vec![self.set(ET, preset())],
            vec![self.set(ET, held)],
        );
        vec![self.when(runs, vec![self.set(ET, running)], stands)]
    }
}
