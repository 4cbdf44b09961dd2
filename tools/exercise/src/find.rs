//! To find a fault: the program is right, and the machine is not.
//!
//! Owns what is hidden, and how far somebody is who looks for it. Must not know how the machine is shown, nor who presses.

use serde::Deserialize;
use unoclp_plant::{Fault, Outputs, Plant, Run};

/// The fault that is to be found.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hidden {
    /// The name of the part.
    pub part: String,
    /// How it fails, as a file of a machine says it.
    pub is: String,
}

impl Hidden {
    /// The part's number and its fault; none where the machine has no such part, or the part cannot fail so.
    pub fn of(&self, plant: &Plant) -> Option<(usize, Fault)> {
        let part = plant.part(&self.part)?;
        let fault = Fault::named(&self.is)?;
        let kind = plant.parts.get(part)?.kind;
        kind.faults.contains(&fault).then_some((part, fault))
    }
}

/// Somebody looks for the fault: how often they have touched the machine, and what they have named.
#[derive(Debug)]
pub struct Search<'p> {
    run: Run<'p>,
    hidden: (usize, Fault),
    steps: u32,
    tries: u32,
    is_found: bool,
}

impl<'p> Search<'p> {
    /// A machine with this fault from its first step on; none where it cannot fail so.
    pub fn new(plant: &'p Plant, hidden: &Hidden) -> Option<Search<'p>> {
        let hidden = hidden.of(plant)?;
        let mut run = Run::new(plant, plant.seed).by_hand();
        run.fault(hidden.0, hidden.1, true);
        Some(Search {
            run,
            hidden,
            steps: 0,
            tries: 0,
            is_found: false,
        })
    }

    /// The machine, to be watched.
    pub fn run(&self) -> &Run<'p> {
        &self.run
    }

    /// The next millisecond with these outputs.
    pub fn step(&mut self, outputs: &Outputs) {
        self.run.step(outputs);
    }

    /// Somebody presses, turns or opens something there: a step of the search.
    pub fn hand(&mut self, part: usize, value: usize, to: i32) {
        self.run.hand(part, value, to);
        self.steps = self.steps.saturating_add(1);
    }

    /// Somebody names a fault; whether that is it. A try, until it is found.
    pub fn name(&mut self, part: usize, fault: Fault) -> bool {
        if !self.is_found {
            self.tries = self.tries.saturating_add(1);
            self.is_found = self.hidden == (part, fault);
        }
        self.hidden == (part, fault)
    }

    /// How often somebody has touched the machine.
    pub fn steps(&self) -> u32 {
        self.steps
    }

    /// How many faults somebody has named, up to the right one.
    pub fn tries(&self) -> u32 {
        self.tries
    }

    /// Whether the fault has been named.
    pub fn is_found(&self) -> bool {
        self.is_found
    }
}

/// What an answer that is handed in comes to: a part and its fault in each line, `low stuck`, each line a try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Answer {
    /// How many lines name something, up to the right one.
    pub tries: u32,
    /// Whether one of them is right.
    pub is_found: bool,
}

impl Answer {
    /// That of a text. Letters may be small or great.
    pub fn of(text: &str, hidden: &Hidden) -> Answer {
        let right = [hidden.part.as_str(), hidden.is.as_str()];
        let mut answer = Answer {
            tries: 0,
            is_found: false,
        };
        for line in text.lines().filter(|line| !line.trim().is_empty()) {
            answer.tries = answer.tries.saturating_add(1);
            let words: Vec<&str> = line.split_whitespace().collect();
            let same = words.len() == right.len()
                && words
                    .iter()
                    .zip(right)
                    .all(|(word, right)| word.eq_ignore_ascii_case(right));
            if same {
                answer.is_found = true;
                break;
            }
        }
        answer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_is_found_at_its_line() {
        let hidden = Hidden {
            part: "low".to_owned(),
            is: "stuck".to_owned(),
        };
        let of = |text| Answer::of(text, &hidden);
        let answer = |tries, is_found| Answer { tries, is_found };
        assert_eq!(of(""), answer(0, false));
        assert_eq!(of("low open\n\nhigh stuck\n"), answer(2, false));
        assert_eq!(of("low open\r\n  LOW   Stuck\nhigh open"), answer(2, true));
        assert_eq!(of("low"), answer(1, false));
        assert_eq!(of("low stuck now"), answer(1, false));
    }
}
