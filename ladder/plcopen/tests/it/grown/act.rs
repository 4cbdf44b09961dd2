//! What has become of a drawing by one act, beside what the act means.

use super::sheet::{Pin, Sheet, Wire};
use unoclp_plcopen::Where;

/// What has become of a drawing by one act.
pub(super) struct Act<'t> {
    before: &'t Sheet,
    after: Sheet,
    text: &'t str,
}

impl<'t> Act<'t> {
    /// The act that made this text of a drawing.
    pub(super) fn of(before: &'t Sheet, text: &'t str, unit: &str) -> Act<'t> {
        let after = Sheet::of(text, unit);
        Act {
            before,
            after,
            text,
        }
    }

    /// What no act changes; `changed`: the element that says something else.
    pub(super) fn keeps(&self, changed: Option<&String>) {
        let Act {
            before,
            after,
            text,
        } = self;
        assert!(before.around == after.around, "beside the unit\n{text}");
        assert_eq!(before.comments, after.comments, "{text}");
        let is_old = |id: &&String| before.said.contains_key(*id) && after.said.contains_key(*id);
        for id in before.said.keys().filter(is_old) {
            if changed != Some(id) {
                assert_eq!(before.said[id], after.said[id], "{text}");
            }
        }
        let order =
            |sheet: &Sheet| -> Vec<String> { sheet.order.iter().filter(is_old).cloned().collect() };
        assert_eq!(order(before), order(after), "places\n{text}");
    }

    /// The number of what is new: the largest.
    pub(super) fn added(&self) -> String {
        let is_new = |id: &&String| !self.before.said.contains_key(*id);
        let new = self.after.said.keys().filter(is_new);
        let new = new.max_by_key(|id| id.parse::<u64>().unwrap());
        new.unwrap_or_else(|| panic!("nothing new\n{}", self.text))
            .clone()
    }

    /// The wires of all that was there are these.
    pub(super) fn wires(&self, expected: impl Fn(&Pin, &[Wire]) -> Vec<Wire>) {
        for (pin, wires) in &self.before.wires {
            let Some(now) = self.after.wires.get(pin) else {
                panic!("{pin:?} is gone\n{}", self.text);
            };
            let mut expected = expected(pin, wires);
            let mut now = now.clone();
            expected.sort();
            now.sort();
            assert_eq!(expected, now, "{pin:?}\n{}", self.text);
        }
    }

    /// What leads to `at` and what leads from it, once something has been drawn there.
    pub(super) fn drawn(&self, place: Where, at: &str, what: &str) {
        let new = self.added();
        let of_new = self.after.wires.iter().filter(|((id, _), _)| *id == new);
        let of_new: Vec<&Wire> = of_new.flat_map(|(_, wires)| wires).collect();
        let is_old = |wire: &&&Wire| self.before.said.contains_key(&wire.0);
        let from: Vec<&Wire> = of_new.iter().filter(is_old).copied().collect();
        let is_from =
            |wire: &Wire, output: &str| wire.0 == at && (wire.1.is_empty() || wire.1 == output);
        let is_new = |wire: &Wire| wire.0 == new;
        // The output of what is new, as its readers have it.
        let wires = self.after.wires.values().flatten();
        let gives: Vec<&Wire> = wires.filter(|wire| is_new(wire)).collect();
        assert!(
            gives.iter().all(|wire| wire.1 == gives[0].1),
            "{}",
            self.text
        );
        let given = gives.first().map(|wire| (*wire).clone());
        match (place, what) {
            (Where::Below, _) => {
                assert!(from.is_empty(), "{}", self.text);
                self.wires(|_, wires| wires.to_vec());
            }
            (_, "value") => {
                let added = self.after.wires.iter();
                let added = added.filter(|(_, wires)| wires.iter().any(is_new));
                let pins: Vec<_> = added.map(|(pin, _)| pin).collect();
                assert!(pins.len() == 1 && pins[0].0 == at, "{}", self.text);
                self.wires(|pin, wires| match pin == pins[0] {
                    true => self.after.wires[pin].clone(),
                    false => wires.to_vec(),
                });
            }
            (Where::After, "variable") => {
                assert!(from.len() == 1 && from[0].0 == at, "{}", self.text);
                self.wires(|_, wires| wires.to_vec());
            }
            (Where::After, _) => {
                assert!(from.len() == 1 && from[0].0 == at, "{}", self.text);
                let output = &from[0].1;
                self.wires(|_, wires| {
                    let to = |wire: &Wire| match is_from(wire, output) {
                        true => given.clone().unwrap(),
                        false => wire.clone(),
                    };
                    wires.iter().map(to).collect()
                });
            }
            (Where::Before, _) => {
                let given = given.unwrap();
                let mut led = None;
                for (pin, now) in &self.after.wires {
                    if pin.0 == at && now.contains(&given) {
                        assert_eq!(now.len(), 1, "{}", self.text);
                        assert!(led.replace(pin).is_none(), "{}", self.text);
                    }
                }
                let led = led.unwrap_or_else(|| panic!("{}", self.text));
                let sorted = |mut wires: Vec<Wire>| {
                    wires.sort();
                    wires
                };
                let from = sorted(from.into_iter().cloned().collect());
                let was = sorted(self.before.wires[led].clone());
                assert_eq!(from, was, "{}", self.text);
                self.wires(|pin, wires| match pin == led {
                    true => vec![given.clone()],
                    false => wires.to_vec(),
                });
            }
            (Where::Beside, _) => self.wires(|pin, wires| {
                let mut wires = wires.to_vec();
                if self.after.wires[pin].iter().any(is_new) {
                    assert!(wires.iter().any(|wire| wire.0 == at), "{}", self.text);
                    wires.extend(given.clone());
                }
                wires
            }),
        }
    }

    /// What led to an element leads on, or nothing does.
    pub(super) fn erased(&self, at: &str) {
        assert!(!self.after.said.contains_key(at), "{}", self.text);
        let own = self.before.wires.iter().filter(|((id, _), _)| id == at);
        let own: Vec<&Wire> = own.flat_map(|(_, wires)| wires).collect();
        for (pin, wires) in &self.before.wires {
            let Some(now) = self.after.wires.get(pin) else {
                continue;
            };
            let stays = |wire: &&Wire| wire.0 != at;
            let kept: Vec<&Wire> = wires.iter().filter(stays).collect();
            assert!(kept.iter().all(|wire| now.contains(wire)), "{}", self.text);
            let mut more = now.iter().filter(|wire| !kept.contains(wire));
            let is_led = wires.iter().any(|wire| wire.0 == at);
            assert!(
                more.all(|wire| is_led && own.contains(&wire)),
                "{}",
                self.text
            );
        }
    }
}
