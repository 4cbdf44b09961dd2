//! All alarms of a site, from values and time to turns.
//!
//! While a value that a condition reads is not known, the condition is not judged: the alarm stays as it was. How long a
//! condition has held is counted by a clock that nobody sets.

use crate::state::{State, Turn};
use std::collections::BTreeMap;
use std::time::Duration;
use unoclp_lang::Judge;
use unoclp_lang::typed::Value;
use unoclp_site::{Alarm, Sort, UP};

/// An alarm that is judged.
struct Judged<'a> {
    alarm: &'a Alarm,
    judge: Judge<'a>,
    /// The values that its condition reads, each by its number there.
    reads: BTreeMap<usize, usize>,
    state: State,
    /// Since when its condition has held, while it has not come.
    since: Option<Duration>,
}

/// All of them.
pub(crate) struct Engine<'a> {
    alarms: Vec<Judged<'a>>,
    /// What the points are; of what is not known, nothing.
    values: Vec<Option<Value>>,
    /// Which of them are BOOL, whole numbers, REAL.
    sorts: Vec<Sort>,
    /// The number of each value, by board and point,
    places: BTreeMap<String, BTreeMap<String, usize>>,
    /// and the alarms that read it.
    readers: Vec<Vec<usize>>,
}

impl<'a> Engine<'a> {
    /// These alarms, each in the state that it had.
    pub fn new(alarms: &'a [Alarm], state: impl Fn(&str) -> State) -> Engine<'a> {
        let mut engine = Engine {
            alarms: Vec::new(),
            values: Vec::new(),
            sorts: Vec::new(),
            places: BTreeMap::new(),
            readers: Vec::new(),
        };
        for (index, alarm) in alarms.iter().enumerate() {
            let mut reads = BTreeMap::new();
            for (number, reading) in &alarm.when.reads {
                let place = engine.place(&reading.board, &reading.point, reading.sort);
                reads.insert(*number, place);
                if let Some(readers) = engine.readers.get_mut(place) {
                    readers.push(index);
                }
            }
            engine.alarms.push(Judged {
                alarm,
                judge: Judge::new(&alarm.when.condition),
                reads,
                state: state(&alarm.name),
                since: None,
            });
        }
        engine
    }

    fn place(&mut self, board: &str, point: &str, sort: Sort) -> usize {
        let next = self.values.len();
        let board = self.places.entry(board.to_owned()).or_default();
        let place = *board.entry(point.to_owned()).or_insert(next);
        if place == next {
            self.values.push(None);
            self.sorts.push(sort);
            self.readers.push(Vec::new());
        }
        place
    }

    /// Points of a board are these now. Gives what becomes of alarms: their numbers, and how.
    pub fn changed<'v>(
        &mut self,
        values: impl Iterator<Item = (&'v str, &'v str, Option<f64>)>,
        now: Duration,
    ) -> Vec<(usize, Turn)> {
        let mut touched = Vec::new();
        for (board, point, value) in values {
            let place = self.places.get(board).and_then(|board| board.get(point));
            let Some(&place) = place else {
                continue;
            };
            if self.sorts.get(place) == Some(&Sort::Up) {
                // A point of the board's own program is called so, and that program is another one now.
                continue;
            }
            touched.extend(self.set(place, value));
        }
        self.judge_all(touched, now)
    }

    /// A board is there, or away.
    pub fn presence(&mut self, board: &str, up: bool, now: Duration) -> Vec<(usize, Turn)> {
        let place = self.places.get(board).and_then(|board| board.get(UP));
        let place = place.filter(|&&place| self.sorts.get(place) == Some(&Sort::Up));
        let touched = match place.copied() {
            Some(place) => self.set(place, Some(f64::from(up))),
            None => Vec::new(),
        };
        self.judge_all(touched, now)
    }

    /// Sets a value; gives the alarms that read it.
    fn set(&mut self, place: usize, value: Option<f64>) -> Vec<usize> {
        let sort = self.sorts.get(place).copied();
        let value = value.map(|value| match sort {
            Some(Sort::Real) => Value::Real(value),
            // Values of 32 bits are whole here.
            _ => Value::Int(value as i128),
        });
        match self.values.get_mut(place) {
            Some(now) if *now != value => *now = value,
            _ => return Vec::new(),
        }
        self.readers.get(place).cloned().unwrap_or_default()
    }

    fn judge_all(&mut self, mut touched: Vec<usize>, now: Duration) -> Vec<(usize, Turn)> {
        touched.sort_unstable();
        touched.dedup();
        let turn = |alarm: usize| Some((alarm, self.judge(alarm, now)?));
        touched.into_iter().filter_map(turn).collect()
    }

    /// Time has passed. Gives what becomes of alarms.
    pub fn tick(&mut self, now: Duration) -> Vec<(usize, Turn)> {
        let waiting: Vec<usize> = (0..self.alarms.len())
            .filter(|&alarm| {
                let of = self.alarms.get(alarm);
                of.is_some_and(|of| of.since.is_some())
            })
            .collect();
        self.judge_all(waiting, now)
    }

    /// When an alarm comes, if nothing changes until then.
    pub fn due(&self) -> Option<Duration> {
        let due = |of: &Judged<'_>| Some(of.since? + of.alarm.lasts);
        self.alarms.iter().filter_map(due).min()
    }

    /// Somebody acknowledges an alarm; none where there is nothing to acknowledge.
    pub fn acknowledge(&mut self, alarm: usize) -> Option<Turn> {
        self.turn(alarm, Turn::Acknowledged)
    }

    /// How an alarm stands.
    pub fn state(&self, alarm: usize) -> State {
        self.alarms.get(alarm).map_or(State::Normal, |of| of.state)
    }

    fn judge(&mut self, alarm: usize, now: Duration) -> Option<Turn> {
        let of = self.alarms.get_mut(alarm)?;
        let values = &self.values;
        let value = |number: usize| values.get(*of.reads.get(&number)?)?.clone();
        if !of.reads.keys().all(|&number| value(number).is_some()) {
            of.since = None;
            return None;
        }
        let holds = of
            .judge
            .holds_of(|number| value(number).unwrap_or(Value::Int(0)));
        if !holds {
            of.since = None;
            return self.turn(alarm, Turn::Gone);
        }
        if of.state.holds() {
            return None;
        }
        let since = *of.since.get_or_insert(now);
        if now < since + of.alarm.lasts {
            return None;
        }
        of.since = None;
        self.turn(alarm, Turn::Came)
    }

    fn turn(&mut self, alarm: usize, turn: Turn) -> Option<Turn> {
        let of = self.alarms.get_mut(alarm)?;
        of.state = of.state.after(turn)?;
        Some(turn)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::Turn::{Came, Gone};
    use unoclp_site::{Files, Site};

    struct Folder;

    impl Files for Folder {
        fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
            let text = "PROGRAM p VAR fan AT %QX0.0 : BOOL; heat AT %MD1 : REAL; step : INT; END_VAR \
                fan := heat > 5.0; step := step + 1; END_PROGRAM\n";
            Ok(text.into())
        }
    }

    fn site(alarms: &str) -> Site {
        let text = format!(
            "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"oven\"\nprogram = \"oven.st\"\n\
             [[line.board]]\naddress = 2\nunit = 2\nname = \"tank\"\n{alarms}"
        );
        unoclp_site::read(&text, &Folder).unwrap_or_else(|wrong| panic!("{wrong:?}"))
    }

    fn s(seconds: u64) -> Duration {
        Duration::from_secs(seconds)
    }

    #[test]
    fn an_alarm_comes_once_its_condition_has_held_for_its_time() {
        let site = site(
            "[[alarm]]\nname = \"hot\"\nwhen = \"oven.heat > 80.0 AND NOT Oven.Fan\"\nfor = \"5s\"\ntext = \"x\"\n",
        );
        let mut engine = Engine::new(&site.alarms, |_| State::Normal);
        let mut set = |point, value, at| {
            let turns = engine.changed([("oven", point, value)].into_iter(), s(at));
            (turns, engine.due())
        };
        let quiet = |due| (Vec::new(), due);
        assert_eq!(set("heat", Some(90.0), 0), quiet(None), "fan is not known");
        assert_eq!(set("fan", Some(0.0), 1), quiet(Some(s(6))));
        // It holds no more for a moment, and its time begins anew.
        assert_eq!(set("fan", Some(1.0), 3), quiet(None));
        assert_eq!(set("fan", Some(0.0), 4), quiet(Some(s(9))));
        assert_eq!(set("heat", Some(95.5), 8), quiet(Some(s(9))));
        // Nobody knows meanwhile whether it holds.
        assert_eq!(set("heat", None, 8), quiet(None));
        assert_eq!(set("heat", Some(95.5), 10), quiet(Some(s(15))));
        assert_eq!(set("step", Some(7.0), 20), quiet(Some(s(15))));
        assert_eq!(engine.tick(s(14)), []);
        assert_eq!(engine.tick(s(15)), [(0, Came)]);
        assert_eq!(engine.tick(s(99)), []);
        let mut set = |value, at| {
            let turns = engine.changed([("oven", "heat", value)].into_iter(), s(at));
            (turns, engine.state(0))
        };
        // What is not known ends no alarm.
        assert_eq!(set(None, 100), (Vec::new(), State::Active));
        assert_eq!(set(Some(80.0), 101), (vec![(0, Gone)], State::Gone));
        assert_eq!(set(Some(80.0), 102), (Vec::new(), State::Gone));
    }

    #[test]
    fn a_board_that_is_away_is_a_condition_too() {
        let site = site(
            "[[alarm]]\nname = \"away\"\nwhen = \"NOT tank.up\"\ntext = \"x\"\n\
             [[alarm]]\nname = \"level\"\nwhen = \"tank.A0 > 900 OR NOT oven.up\"\ntext = \"x\"\n",
        );
        let mut engine = Engine::new(&site.alarms, |_| State::Normal);
        assert_eq!(engine.presence("tank", true, s(0)), []);
        assert_eq!(engine.presence("tank", false, s(1)), [(0, Came)]);
        assert_eq!(engine.presence("oven", false, s(2)), []);
        let level = [("tank", "A0", Some(5.0))];
        assert_eq!(engine.changed(level.into_iter(), s(3)), [(1, Came)]);
        assert_eq!(engine.presence("nobody", false, s(4)), []);
        assert_eq!(engine.presence("tank", true, s(5)), [(0, Gone)]);
    }

    #[test]
    fn an_alarm_that_was_there_before_a_restart_is_gone_once_its_condition_says_so() {
        let site = site("[[alarm]]\nname = \"hot\"\nwhen = \"oven.heat > 80.0\"\ntext = \"x\"\n");
        let heat = |value| [("oven", "heat", Some(value))].into_iter();
        let mut engine = Engine::new(&site.alarms, |_| State::Acknowledged);
        assert_eq!(engine.changed(heat(81.0), s(0)), [], "it is there already");
        assert_eq!(engine.changed(heat(80.0), s(1)), [(0, Gone)]);
        assert_eq!(engine.state(0), State::Normal);
        let mut engine = Engine::new(&site.alarms, |_| State::Gone);
        assert_eq!(engine.changed(heat(81.0), s(0)), [(0, Came)]);
        assert_eq!(engine.acknowledge(0), Some(Turn::Acknowledged));
        assert_eq!(engine.acknowledge(0), None);
        assert_eq!(engine.acknowledge(9), None);
    }
}
