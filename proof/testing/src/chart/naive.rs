//! A chart as the standard describes it (IEC 61131-3, 2.6): what each rule says, in the order of the rules.

use super::text::is_timed;
use super::{Body, Chart, Condition};

/// A TON.
#[derive(Clone, Copy, Debug, Default)]
struct Ton {
    since: Option<i64>,
}

impl Ton {
    fn call(&mut self, on: bool, preset: i64, now: i64) -> bool {
        if !on {
            self.since = None;
            return false;
        }
        now - *self.since.get_or_insert(now) >= preset
    }
}

/// What ACTION_CONTROL keeps of one association.
#[derive(Clone, Copy, Debug, Default)]
struct Cause {
    was_active: bool,
    stored: bool,
    timer: Ton,
}

/// A chart that runs.
#[derive(Debug)]
pub struct Naive<'c> {
    chart: &'c Chart,
    /// X of each step.
    pub active: Vec<bool>,
    /// T of each step, ms.
    pub time: Vec<i64>,
    since: Vec<i64>,
    begun: bool,
    causes: Vec<Vec<Cause>>,
    /// S of each action, and whether something lasted at the end of the scan before.
    stored: Vec<bool>,
    lasted: Vec<bool>,
    /// The variables that are actions.
    pub variables: Vec<bool>,
    /// What bodies count.
    pub counts: Vec<i64>,
    /// What they show.
    pub shows: Vec<bool>,
    /// What they share.
    pub shared: i64,
    edges: Vec<bool>,
    timers: Vec<Ton>,
}

impl<'c> Naive<'c> {
    /// Before the first scan.
    pub fn new(chart: &'c Chart) -> Naive<'c> {
        let (steps, bodies) = (chart.steps.len(), chart.bodies.len());
        let actions = chart.variables + bodies;
        Naive {
            chart,
            active: (0..steps).map(|s| chart.initial.contains(&s)).collect(),
            time: vec![0; steps],
            since: vec![0; steps],
            begun: false,
            causes: chart
                .steps
                .iter()
                .map(|does| vec![Cause::default(); does.len()])
                .collect(),
            stored: vec![false; actions],
            lasted: vec![false; actions],
            variables: vec![false; chart.variables],
            counts: vec![0; bodies],
            shows: vec![false; bodies],
            shared: 0,
            edges: vec![false; bodies],
            timers: vec![Ton::default(); bodies],
        }
    }

    /// One scan, at this time in ms.
    pub fn scan(&mut self, inputs: [bool; 4], now: i64) {
        if !std::mem::replace(&mut self.begun, true) {
            self.since.fill(now);
        }
        for step in (0..self.active.len()).filter(|step| self.active[*step]) {
            self.time[step] = now - self.since[step];
        }
        self.evolve(inputs, now);
        self.act(inputs, now);
    }

    fn holds(&self, condition: &Condition, inputs: [bool; 4]) -> bool {
        match condition {
            Condition::Input(input, is) => inputs[*input] == *is,
            Condition::Active(step, is) => self.active[*step] == *is,
            Condition::Time(step, ms) => self.time[*step] >= *ms,
            Condition::Count(body, count) => self.counts[*body] >= *count,
            Condition::And(a, b) => self.holds(a, inputs) && self.holds(b, inputs),
            Condition::Or(a, b) => self.holds(a, inputs) || self.holds(b, inputs),
            Condition::True => true,
        }
    }

    fn evolve(&mut self, inputs: [bool; 4], now: i64) {
        let mut turns: Vec<usize> = (0..self.chart.transitions.len()).collect();
        turns.sort_by_key(|turn| match self.chart.transitions[*turn].priority {
            Some(priority) => u64::from(priority),
            None => u64::MAX,
        });
        let mut left = vec![false; self.active.len()];
        let mut entered = left.clone();
        for turn in turns {
            let transition = &self.chart.transitions[turn];
            let ready = transition
                .from
                .iter()
                .all(|step| self.active[*step] && !left[*step]);
            if ready && self.holds(&transition.condition, inputs) {
                transition.from.iter().for_each(|step| left[*step] = true);
                transition.to.iter().for_each(|step| entered[*step] = true);
            }
        }
        for step in 0..self.active.len() {
            let was = self.active[step];
            self.active[step] = was && !left[step] || entered[step];
            if self.active[step] && !was {
                self.since[step] = now;
                self.time[step] = 0;
            }
        }
    }

    fn act(&mut self, inputs: [bool; 4], now: i64) {
        // The order in which steps name the actions.
        let mut order: Vec<usize> = Vec::new();
        for (action, ..) in self.chart.steps.iter().flatten() {
            if !order.contains(action) {
                order.push(*action);
            }
        }
        let (mut last, mut run) = (Vec::new(), Vec::new());
        for action in order {
            let (lasts, with, without) = self.control(action, now);
            let lasted = std::mem::replace(&mut self.lasted[action], lasts);
            let runs = lasts || with || without;
            match action.checked_sub(self.chart.variables) {
                None => self.variables[action] = runs,
                Some(body) if runs => run.push((body, lasts || with)),
                Some(body) if lasted => last.push((body, false)),
                Some(_) => {}
            }
        }
        for (body, q) in last.into_iter().chain(run) {
            self.body(body, q, inputs, now);
        }
    }

    /// Q of an action but for pulses, and the pulses with Q and without.
    fn control(&mut self, action: usize, now: i64) -> (bool, bool, bool) {
        let chart = self.chart;
        let all = || {
            let steps = chart.steps.iter().enumerate();
            steps.flat_map(|(step, does)| {
                let does = does.iter().enumerate();
                does.map(move |(nth, does)| (step, nth, does))
            })
        };
        let own = || all().filter(move |(_, _, does)| does.0 == action);
        let reset = own().any(|(step, _, does)| does.1 == "R" && self.active[step]);
        let (mut lasts, mut with, mut without) = (false, false, false);
        for (step, nth, (_, qualifier, time)) in own() {
            let x = self.active[step];
            let cause = &mut self.causes[step][nth];
            let (rises, falls) = (x && !cause.was_active, !x && cause.was_active);
            cause.was_active = x;
            let time = if is_timed(qualifier) { *time } else { 0 };
            match *qualifier {
                "N" => lasts |= x,
                "S" => self.stored[action] |= x,
                "L" => lasts |= x && !cause.timer.call(x, time, now),
                "D" => lasts |= cause.timer.call(x, time, now),
                "P" => with |= rises && !reset,
                "P1" => without |= rises,
                "P0" => without |= falls,
                "SD" => {
                    cause.stored = (cause.stored || x) && !reset;
                    lasts |= cause.timer.call(cause.stored, time, now);
                }
                "DS" => {
                    let over = cause.timer.call(x, time, now);
                    cause.stored = (cause.stored || over) && !reset;
                    lasts |= cause.stored;
                }
                "SL" => {
                    cause.stored = (cause.stored || x) && !reset;
                    lasts |= cause.stored && !cause.timer.call(cause.stored, time, now);
                }
                _ => {}
            }
            // L measures while it is not active too.
            if *qualifier == "L" && !x || *qualifier == "SL" && !cause.stored {
                cause.timer.call(false, time, now);
            }
        }
        self.stored[action] &= !reset;
        ((lasts || self.stored[action]) && !reset, with, without)
    }

    fn body(&mut self, body: usize, q: bool, inputs: [bool; 4], now: i64) {
        match self.chart.bodies[body] {
            Body::Counts => self.counts[body] += 1,
            Body::Shows => self.shows[body] = q,
            Body::Edge => {
                let was = std::mem::replace(&mut self.edges[body], q);
                self.counts[body] += i64::from(q && !was);
            }
            Body::Timer => self.shows[body] = self.timers[body].call(q, 30, now),
            Body::Shares => self.shared = (self.shared * 3 + body as i64 + 1) % 1000,
            Body::Copies(input) => self.shows[body] = inputs[input],
        }
    }
}
