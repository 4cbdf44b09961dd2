//! A random chart: sequences, selections, simultaneous sequences and loops, and sometimes anything.

use super::{Body, Chart, Condition, Transition};
use crate::Random;

const QUALIFIERS: [&str; 11] = ["N", "R", "S", "L", "D", "P", "SD", "DS", "SL", "P1", "P0"];

/// The chart of a seed.
pub fn sketch(seed: u64) -> Chart {
    let mut maker = Maker {
        random: Random(seed),
        chart: Chart::default(),
    };
    maker.chart();
    maker.chart
}

struct Maker {
    random: Random,
    chart: Chart,
}

impl Maker {
    fn below(&mut self, most: usize) -> usize {
        self.random.below(most.max(1))
    }

    fn chart(&mut self) {
        self.chart.variables = 1 + self.below(4);
        for _ in 0..self.below(5) {
            let body = match self.below(7) {
                0 => Body::Counts,
                1 => Body::Shows,
                2 => Body::Edge,
                3 => Body::Timer,
                4 => Body::Copies(self.below(4)),
                _ => Body::Shares,
            };
            self.chart.bodies.push(body);
        }
        let first = self.step();
        self.chart.initial.push(first);
        if self.random.percent(70) {
            let last = self.block(first, 3);
            self.join(vec![last], vec![first]);
        } else {
            self.anything();
        }
        if self.random.percent(15) {
            // Another chart beside it.
            let first = self.step();
            self.chart.initial.push(first);
            let last = self.block(first, 1);
            self.join(vec![last], vec![first]);
        }
        for number in 0..self.chart.transitions.len() {
            let condition = self.condition(number, 2);
            self.chart.transitions[number].condition = condition;
        }
    }

    fn step(&mut self) -> usize {
        let mut does: Vec<super::Does> = Vec::new();
        for _ in 0..self.below(3) {
            let actions = self.chart.variables + self.chart.bodies.len();
            let action = self.below(actions);
            let qualifier = match self.random.percent(40) {
                true => "N",
                false => QUALIFIERS[self.below(QUALIFIERS.len())],
            };
            let time = [10, 20, 35, 60, 100][self.below(5)];
            does.push((action, qualifier, time));
        }
        self.chart.steps.push(does);
        self.chart.steps.len() - 1
    }

    fn join(&mut self, from: Vec<usize>, to: Vec<usize>) {
        let priority = self.random.percent(20).then(|| self.random.below(4) as u32);
        self.chart.transitions.push(Transition {
            priority,
            from,
            to,
            condition: Condition::True,
        });
    }

    /// A part that begins in this step: the step in which it ends.
    fn block(&mut self, begin: usize, deep: usize) -> usize {
        let mut last = begin;
        for _ in 0..1 + self.below(3) {
            if self.chart.steps.len() > 14 {
                break;
            }
            last = match self.below(if deep == 0 { 1 } else { 4 }) {
                0 | 1 => {
                    let next = self.step();
                    self.join(vec![last], vec![next]);
                    if self.random.percent(15) {
                        self.join(vec![next], vec![last]);
                    }
                    if self.random.percent(10) {
                        self.join(vec![next], vec![next]);
                    }
                    next
                }
                2 => {
                    let branches = 2 + self.below(2);
                    let end = self.step();
                    for _ in 0..branches {
                        let first = self.step();
                        self.join(vec![last], vec![first]);
                        let exit = self.block(first, deep - 1);
                        self.join(vec![exit], vec![end]);
                    }
                    end
                }
                _ => {
                    let branches = 2 + self.below(2);
                    let firsts: Vec<usize> = (0..branches).map(|_| self.step()).collect();
                    self.join(vec![last], firsts.clone());
                    let exits = firsts.iter().map(|first| self.block(*first, deep - 1));
                    let exits = exits.collect();
                    let end = self.step();
                    self.join(exits, vec![end]);
                    end
                }
            };
        }
        last
    }

    /// Steps and transitions without any order.
    fn anything(&mut self) {
        for _ in 0..2 + self.below(7) {
            self.step();
        }
        for _ in 0..2 + self.below(12) {
            let (from, to) = (self.some(), self.some());
            self.join(from, to);
        }
        // So that all of them are one chart.
        for step in 1..self.chart.steps.len() {
            self.join(vec![step - 1], vec![step]);
        }
    }

    fn some(&mut self) -> Vec<usize> {
        let count = 1 + usize::from(self.random.percent(30));
        let steps = self.chart.steps.len();
        let mut all: Vec<usize> = (0..count).map(|_| self.below(steps)).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn condition(&mut self, transition: usize, deep: usize) -> Condition {
        let steps = self.chart.steps.len();
        match self.below(if deep == 0 { 8 } else { 12 }) {
            0..=3 => Condition::Input(self.below(4), self.random.percent(50)),
            4 => Condition::Active(self.below(steps), self.random.percent(50)),
            5 => Condition::Time(self.below(steps), 10 + self.random.below(60) as i64),
            6 => {
                let from = self.chart.transitions[transition].from[0];
                Condition::Time(from, 10 + self.random.below(60) as i64)
            }
            7 if !self.chart.bodies.is_empty() => {
                let bodies = self.chart.bodies.len();
                Condition::Count(self.below(bodies), 1 + self.random.below(5) as i64)
            }
            7 => Condition::True,
            8 | 9 => {
                let both = [0; 2].map(|_| Box::new(self.condition(transition, deep - 1)));
                let [a, b] = both;
                Condition::And(a, b)
            }
            _ => {
                let both = [0; 2].map(|_| Box::new(self.condition(transition, deep - 1)));
                let [a, b] = both;
                Condition::Or(a, b)
            }
        }
    }
}
