//! Jumps in a list, and what the accumulator holds where they come.

use super::List;
use super::lines::Line;
use super::operators::Value;
use crate::st::sentences::piece;
use unoclp_lang::Span;

/// No more labels are jumped to in one body.
const MOST_JUMPS: usize = 32;

impl List<'_> {
    /// A jump to a label below; none where there is none, which is told.
    pub(super) fn jump(&mut self, line: &Line<'_>, word: &str) -> Option<()> {
        let at = self.span(line);
        let Some((label, _)) = line.operands.first() else {
            return self.lacks(line);
        };
        let key = label.to_uppercase();
        let places = self.labels.get(&key).map_or(&[][..], |places| places);
        let below = places.partition_point(|place| *place < self.at);
        let Some(&below) = places.get(below) else {
            let what = match places.is_empty() {
                true => (
                    format!("a jump to `{label}`, which is not a label,"),
                    format!("um desvio a `{label}`, que não é um rótulo,"),
                ),
                false => (
                    format!("a jump back to `{label}`"),
                    format!("um desvio para trás, a `{label}`,"),
                ),
            };
            return self.refuse(at, what.into());
        };
        self.carry(below, at);
        let mut value = match word {
            "JMP" => Value::plain("TRUE", at),
            _ => self.condition(line, Some(""))?,
        };
        if word == "JMP" {
            self.holds = None;
            self.has_left = true;
        } else if word.ends_with('N') {
            value = value.inverted(at);
        }
        let name = match self.jumps.get(&key) {
            Some(name) => name.clone(),
            None if self.jumps.len() >= MOST_JUMPS => {
                let en = format!("a jump to more than {MOST_JUMPS} labels");
                let pt = format!("um desvio a mais de {MOST_JUMPS} rótulos");
                return self.refuse(at, (en, pt).into());
            }
            None => {
                let name = self.own("jump", "BOOL", at);
                self.jumps.insert(key, name.clone());
                name
            }
        };
        let mut jumps = vec![piece(&format!("{name} := "), at)];
        jumps.extend(value.pieces);
        self.sentences.add(jumps);
        self.sentences.jump(&name);
        Some(())
    }

    /// Keeps what the accumulator holds for a label below, where what stands there says of which type that is.
    fn carry(&mut self, label: usize, at: Span) {
        let mut behind = self.lines[label..].iter();
        let Some(next) = behind.find(|line| !line.is_label) else {
            return;
        };
        let kind = match &*next.word.to_uppercase() {
            "ST" | "STN" => {
                let target = next.operands.first().map(|(text, _)| text.to_uppercase());
                target.and_then(|name| self.kinds.get(&name).cloned())
            }
            "S" | "R" | "JMPC" | "JMPCN" | "CALC" | "CALCN" | "RETC" | "RETCN" => {
                Some("BOOL".to_owned())
            }
            _ => None,
        };
        let (Some(kind), Some(value)) = (kind, self.holds.clone()) else {
            self.lost.insert(label);
            return;
        };
        let name = match self.carried.get(&label) {
            Some(name) => name.clone(),
            None => self.own("acc", &kind, at),
        };
        let mut stores = vec![piece(&format!("{name} := "), at)];
        stores.extend(value.pieces);
        self.sentences.add(stores);
        let own = Value::plain(&name, at);
        self.carried.insert(label, name);
        self.holds = Some(own);
    }

    /// A label: what jumps here has come.
    pub(super) fn land(&mut self, line: &Line<'_>, label: &str) {
        let at = self.span(line);
        let has_left = std::mem::take(&mut self.has_left);
        let Some(jump) = self.jumps.remove(label) else {
            return;
        };
        if !has_left {
            self.carry(self.at, at);
        }
        let is_lost = self.lost.contains(&self.at);
        let name = self.carried.get(&self.at).filter(|_| !is_lost);
        self.holds = name.map(|name| Value::plain(name, at));
        self.sentences.land(&jump);
        let lands = vec![piece(&format!("{jump} := FALSE"), at)];
        self.sentences.add(lands);
    }
}
