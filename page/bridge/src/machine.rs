//! A machine beside the board: what a page draws of it, and what passes between the two.
//!
//! Owns the one that a page has. Must not know which board it is wired to: its outputs come from outside, its inputs go there.

use crate::answer::answer;
use crate::words::{self, Both, both};
use self_cell::self_cell;
use unoclp_core::{Board, Image, Inputs};
use unoclp_exercise::find::{Hidden, Search};
use unoclp_plant::{Broken, Change, Fault, Live, Outputs, Plant, Run, live, picture, read};
use unoclp_program::Lang;

/// What chance begins with.
const SEED: u64 = 1;
/// A request lets it go on for no longer, ms.
pub const MOST: u32 = 250;
/// A point's number has two digits.
pub const NUMBERS: usize = 100;

self_cell!(
    struct Moving {
        owner: Plant,
        #[covariant]
        dependent: Run,
    }
);

/// A machine in motion, and how a page has seen it last.
pub struct Machine {
    moving: Moving,
    /// Who looks for its fault, where that is the task.
    search: Option<Search>,
    /// What a person there can change, by part and value.
    hands: Vec<(usize, usize)>,
    shown: Live,
    lang: Lang,
}

answer! {
    /// A machine as a page gets to know it.
    pub struct Known as "MachineFacts" {
        title: Both,
        about: Both,
        /// The board that it is wired to.
        board: &'static str,
        svg: String,
        /// What a person there can change.
        hands: Vec<Hand>,
        /// What people call its parts, and how the file names them.
        parts: Vec<Both>,
        names: Vec<String>,
        /// How they can fail: the part, the fault, and what to call it.
        faults: Vec<(usize, &'static str, Both)>,
        /// What must never be, and what must come to be.
        rules: Vec<Both>,
        /// The inputs that it switches, the analogue inputs that it sets, the outputs that drive it.
        uses: [Vec<u8>; 3],
        /// Whether it is driven by PWM.
        dims: bool,
    }
}

answer! {
    /// What a person there can change of a part.
    pub struct Hand as "Hand" {
        part: usize,
        value: usize,
        /// The part's name, by which its symbol is found.
        name: String,
        label: Both,
        /// What it is: `pressed`, `turned`.
        what: &'static str,
        /// Whether it goes back as soon as nobody holds it.
        is_held: bool,
        low: i32,
        high: i32,
    }
}

/// What passes between a board and its machine besides levels: a page writes and reads it where it lies.
#[derive(Debug)]
pub struct Wires {
    /// Of the output with each number, what share of 255 it was high; number 0 is none.
    pub shares: [u8; NUMBERS],
    /// The readings of A 00 and those after it, 0 to 1023.
    pub readings: [u16; NUMBERS],
}

impl Default for Wires {
    fn default() -> Wires {
        Wires {
            shares: [0; NUMBERS],
            readings: [0; NUMBERS],
        }
    }
}

/// A change of a picture: the element, its attribute or null for its text, and what that is now.
pub type Shown = (String, Option<&'static str>, String);

answer! {
    /// How far somebody is who looks for its fault.
    pub struct Searched as "Searched" {
        steps: u32,
        tries: u32,
        found: bool,
    }
}

answer! {
    /// What has changed of it.
    pub struct Look as "MachineLook" {
        /// ms since it began.
        at: u64,
        changes: Vec<Shown>,
        /// The rules that broke, by number, and when.
        broken: Vec<(usize, u64)>,
        /// How often each goal was met.
        met: Vec<u32>,
        /// What can be changed by hand, as it stands.
        hands: Vec<i32>,
        /// How far somebody is who looks for its fault, where that is the task.
        search: Option<Searched>,
    }
}

impl Machine {
    /// The machine of this file, wired to this board where it names none, and drawn in this language. What is hidden in it
    /// is to be found.
    ///
    /// # Errors
    /// The first mistake in it, with its line; that it cannot fail so.
    pub fn open(
        name: &str,
        text: &str,
        board: Board,
        lang: Lang,
        hidden: Option<&Hidden>,
    ) -> Result<Machine, Both> {
        let plant = plant(name, text, board)?;
        let hands = hands(&plant);
        let search = match hidden {
            Some(hidden) => {
                let told = || both(|lang| words::cannot_fail(lang, name));
                Some(Search::new(&plant, hidden).ok_or_else(told)?)
            }
            None => None,
        };
        let mut moving = Moving::new(plant, |plant| Run::new(plant, SEED).by_hand());
        if let Some(search) = &search {
            moving.with_dependent_mut(|_, run| search.begin(run));
        }
        Ok(Machine {
            hands: hands.iter().map(|hand| (hand.part, hand.value)).collect(),
            shown: live(moving.borrow_dependent(), lang),
            lang,
            moving,
            search,
        })
    }

    fn run(&self) -> &Run<'_> {
        self.moving.borrow_dependent()
    }

    /// What a page gets to know of it; it is drawn in this language from then on.
    pub fn known(&mut self, lang: Lang) -> Known {
        self.lang = lang;
        self.shown = live(self.run(), lang);
        let svg = picture(self.run(), lang).svg();
        let plant = self.run().plant();
        let nevers = plant.nevers.iter().map(|never| &never.text);
        let rules = nevers.chain(plant.goals.iter().map(|goal| &goal.text));
        let faults = plant.parts.iter().enumerate().flat_map(|(part, own)| {
            own.kind
                .faults
                .iter()
                .map(move |fault| (part, fault.name(), both(|lang| words::fails(lang, *fault))))
        });
        Known {
            title: (&plant.title).into(),
            about: (&plant.about).into(),
            board: plant.board.id(),
            svg,
            hands: hands(plant),
            parts: plant.parts.iter().map(|own| (&own.label).into()).collect(),
            names: plant.parts.iter().map(|own| own.name.clone()).collect(),
            faults: faults.collect(),
            rules: rules.map(Both::from).collect(),
            uses: plant.uses(),
            dims: plant.dims(),
        }
    }

    /// The next milliseconds with these outputs.
    pub fn step(&mut self, outputs: &Outputs, ms: u32) {
        self.moving.with_dependent_mut(|_, run| {
            for _ in 0..ms.min(MOST) {
                run.step(outputs);
            }
        });
    }

    /// The inputs that it gives.
    pub fn inputs(&self) -> &Inputs {
        self.run().inputs()
    }

    /// The next milliseconds as a board lives them: `levels` has a bit for each output, and the answer one for each input
    /// that is 1.
    pub fn pass(&mut self, levels: u32, wires: &mut Wires, ms: u32) -> u32 {
        let outputs = Outputs {
            points: Image(levels.into()),
            pwm: wires.shares,
        };
        self.step(&outputs, ms);
        let inputs = self.inputs();
        for (place, reading) in wires.readings.iter_mut().zip(inputs.analogue) {
            *place = reading;
        }
        inputs.points.0 as u32
    }

    /// What has changed since the last look.
    pub fn look(&mut self) -> Look {
        let now = live(self.run(), self.lang);
        let changes = now.changes(&self.shown, self.run().plant());
        self.shown = now;
        let run = self.run();
        Look {
            at: run.now(),
            changes: changes.into_iter().map(shown).collect(),
            search: self.searched(),
            broken: run
                .verdict()
                .broken
                .iter()
                .map(|Broken { rule, at }| (*rule, *at))
                .collect(),
            met: run.verdict().met.clone(),
            hands: self
                .hands
                .iter()
                .map(|&(part, value)| run.value(part, value))
                .collect(),
        }
    }

    /// A person there changes something.
    pub fn hand(&mut self, part: usize, value: usize, to: i32) {
        let search = &mut self.search;
        self.moving.with_dependent_mut(|plant, run| {
            run.hand(part, value, to);
            if let Some(search) = search {
                search.touched(plant, part, value, to);
            }
        });
    }

    /// A person forces a point of the board.
    pub fn forced(&mut self) {
        if let Some(search) = &mut self.search {
            search.forced();
        }
    }

    /// A person names the fault that is hidden; how far they are then. None where none is hidden.
    pub fn name(&mut self, part: usize, fault: &str) -> Option<Searched> {
        if let (Some(search), Some(fault)) = (&mut self.search, Fault::named(fault)) {
            search.name(part, fault);
        }
        self.searched()
    }

    fn searched(&self) -> Option<Searched> {
        self.search.as_ref().map(|search| Searched {
            steps: search.steps(),
            tries: search.tries(),
            found: search.is_found(),
        })
    }

    /// A part fails, or is mended; one whose fault is to be found is mended by nobody.
    pub fn fault(&mut self, part: usize, fault: &str, is: bool) {
        let is_free = self.search.as_ref().is_none_or(Search::is_found);
        if let Some(fault) = Fault::named(fault).filter(|_| is_free) {
            self.moving
                .with_dependent_mut(|_, run| run.fault(part, fault, is));
        }
    }

    /// As it was before it moved; what has failed is mended, but for what is to be found.
    pub fn reset(&mut self) {
        let search = self.search.as_ref();
        self.moving.with_dependent_mut(|_, run| {
            run.reset();
            if let Some(search) = search {
                search.begin(run);
            }
        });
    }
}

/// A change of a picture as a page takes it.
pub fn shown(change: Change) -> Shown {
    let Change {
        id,
        attribute,
        value,
    } = change;
    (id, attribute, value)
}

/// The picture of a machine that stands, in this language.
///
/// # Errors
/// The first mistake in it, with its line.
pub fn standing(name: &str, text: &str, board: Board, lang: Lang) -> Result<String, Both> {
    let plant = plant(name, text, board)?;
    Ok(picture(&Run::new(&plant, plant.seed), lang).svg())
}

/// The plant of this file, for this board where it names none.
///
/// # Errors
/// The first mistake in it, with its line.
pub fn plant(name: &str, text: &str, board: Board) -> Result<Plant, Both> {
    read(text, board).map_err(|mistakes| match mistakes.first() {
        Some(mistake) => both(|lang| mistake.text(name, lang)),
        None => both(words::no_machine),
    })
}

fn hands(plant: &Plant) -> Vec<Hand> {
    let mut hands = Vec::new();
    for (part, own) in plant.parts.iter().enumerate() {
        for (value, slot) in own
            .kind
            .values
            .iter()
            .enumerate()
            .filter(|(_, slot)| slot.by_hand)
        {
            let (low, high) = own.range(value);
            hands.push(Hand {
                part,
                value,
                name: own.name.clone(),
                label: (&own.label).into(),
                what: slot.name,
                is_held: own.kind.name == "button",
                low,
                high,
            });
        }
    }
    hands
}
