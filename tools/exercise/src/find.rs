//! To find a fault: the program is right, and the machine is not.
//!
//! Owns what is hidden, and how far somebody is who looks for it. Must not know how the machine is shown, nor who presses.

use serde::Deserialize;
use unoclp_plant::{Fault, Plant, Run};

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
#[derive(Clone, Debug)]
pub struct Search {
    hidden: (usize, Fault),
    /// The value that was changed last.
    last: Option<(usize, usize)>,
    steps: u32,
    tries: u32,
    is_found: bool,
}

impl Search {
    /// Of this fault; none where the machine cannot fail so.
    pub fn new(plant: &Plant, hidden: &Hidden) -> Option<Search> {
        Some(Search {
            hidden: hidden.of(plant)?,
            last: None,
            steps: 0,
            tries: 0,
            is_found: false,
        })
    }

    /// The machine begins: it fails from its first step on, until the fault has been found, which is mended then.
    pub fn begin(&self, run: &mut Run<'_>) {
        let (part, fault) = self.hidden;
        run.fault(part, fault, !self.is_found);
    }

    /// Somebody presses, turns or opens something there: a step of the search. To let go of a button is none, and a knob
    /// that is turned on is still the same step.
    pub fn touched(&mut self, plant: &Plant, part: usize, value: usize, to: i32) {
        let Some(own) = plant.parts.get(part) else {
            return;
        };
        let (low, high) = own.range(value);
        let is_let_go = own.kind.name == "button" && to <= low;
        let is_same = high.saturating_sub(low) > 1 && self.last == Some((part, value));
        if is_let_go || is_same {
            return;
        }
        self.last = Some((part, value));
        self.steps = self.steps.saturating_add(1);
    }

    /// Somebody forces a point of the board: a step too.
    pub fn forced(&mut self) {
        self.last = None;
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

    /// How often somebody has touched the machine or forced a point.
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
