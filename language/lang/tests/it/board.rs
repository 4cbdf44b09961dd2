//! A compiled program beside the interpreter: the same values after each scan, on the core and on the PC.

use unoclp_checked::Checked;
use unoclp_core::Board;
use unoclp_core::{Image, Inputs, Plc};
use unoclp_lang::run::Machine;
use unoclp_lang::typed::{Base, Holds, Symbol, Tree, Value};
use unoclp_lang::{CompiledText, Severity, TextLanguage, compile_text};
use unoclp_testing::{Random, least};

/// A board with room for anything, so that it is not room that is compared.
pub fn large() -> Board {
    Board {
        stored_bytes: 30_000,
        linked_bytes: 30_000,
        ..Board::UNO
    }
}

/// Why a text does not run on the board; none if it does.
pub fn errors(made: &CompiledText) -> Option<String> {
    let errors = made.diagnostics.iter();
    let errors = errors.filter(|d| d.severity() == Severity::Error);
    let all: Vec<String> = errors
        .map(|d| format!("{} {}", d.code, d.message(unoclp_lang::Lang::En)))
        .collect();
    (!all.is_empty() || made.program.is_none()).then(|| all.join("; "))
}

/// What the board holds at a place.
fn held(plc: &Plc<'_>, place: &str, base: Base, now: u32) -> Option<Value> {
    let (letter, number) = place.split_once(' ')?;
    let number: u8 = number.parse().ok()?;
    let at = usize::from(number).checked_sub(1);
    let bit = |bit: bool| Value::Int(bit.into());
    Some(match letter {
        "M" => bit(plc.markers() >> at? & 1 != 0),
        "Q" if base == Base::Bool => bit(plc.outputs().0 >> at? & 1 != 0),
        "Q" if number == 0 => Value::Int((plc.outputs().0 & 0xFF) as i128),
        "Q" => Value::Int(plc.pwm(number).into()),
        "D" => {
            let raw = *plc.registers().get(at?)?;
            match base {
                Base::Real => Value::Real(f32::from_bits(raw.cast_unsigned()).into()),
                Base::Udint | Base::Dword | Base::Date | Base::Dt => {
                    Value::Int(raw.cast_unsigned().into())
                }
                _ => Value::Int(raw.into()),
            }
        }
        "T" if base == Base::Bool => bit(plc.timers(now).nth(at?)?.q),
        "T" => Value::Int(plc.timers(now).nth(at?)?.elapsed.into()),
        "C" if base == Base::Udint => {
            Value::Int(plc.counters().nth(at?)?.value.cast_unsigned().into())
        }
        "C" if base != Base::Bool => Value::Int(plc.counters().nth(at?)?.value.into()),
        _ => return None,
    })
}

/// Both, scan by scan.
pub struct Twins<'t> {
    pub machine: Machine<'t>,
    tree: &'t Tree,
    places: &'t [Option<String>],
    inputs: Inputs,
}

impl<'t> Twins<'t> {
    pub fn new(tree: &'t Tree, places: &'t [Option<String>]) -> Twins<'t> {
        Twins {
            machine: Machine::new(tree).with_steps(2_000_000),
            tree,
            places,
            inputs: Inputs::default(),
        }
    }

    /// Sets a symbol on both; false where the board has no place for it.
    pub fn set(&mut self, plc: &mut Plc<'_>, at: usize, value: &Value) -> bool {
        let Some(symbol) = self.tree.symbols.get(at) else {
            return false;
        };
        let (_, base) = self.machine.value(symbol);
        let Holds::Cell(cell) = symbol.holds else {
            return false;
        };
        self.machine.set_cell(cell, value.clone());
        let Some(place) = self.places.get(at).and_then(Option::as_deref) else {
            return true;
        };
        let Some((letter, number)) = place.split_once(' ') else {
            return false;
        };
        let number: u8 = number.parse().unwrap_or(1);
        let is = value.int() != 0;
        match letter {
            "I" => {
                let bit = 1 << (number - 1);
                self.inputs.points = Image(match is {
                    true => self.inputs.points.0 | bit,
                    false => self.inputs.points.0 & !bit,
                });
            }
            "A" => self.inputs.analogue[usize::from(number)] = value.int() as u16,
            "M" => plc.set_marker(number, is),
            "D" => {
                let raw = match value {
                    Value::Real(real) => (*real as f32).to_bits().cast_signed(),
                    other if base == Base::Real => (other.real() as f32).to_bits().cast_signed(),
                    other => other.int() as i32,
                };
                plc.set_register(number, raw);
            }
            _ => return false,
        }
        true
    }

    /// Changes some inputs, and seldom some variables, as a person at the board and one at the monitor do.
    pub fn stir(&mut self, plc: &mut Plc<'_>, random: &mut Random) {
        let tree = self.tree;
        for (at, symbol) in tree.symbols.iter().enumerate() {
            let value = match &*symbol.name {
                "%IW4" if random.percent(20) => random.below(1024) as i128,
                name if name.starts_with("%IX") && random.percent(30) => random.below(2) as i128,
                "b0" | "b1" | "b2" | "b3" if random.percent(2) => random.below(2) as i128,
                "i0" if random.percent(20) => random.below(9) as i128 - 2,
                _ => continue,
            };
            self.set(plc, at, &Value::Int(value));
        }
    }

    /// What stands at the pins.
    #[allow(dead_code, reason = "the firmware's pins are set so, in its own tests")]
    pub fn inputs(&self) -> Inputs {
        self.inputs
    }

    /// One scan of both, and what differs after it.
    pub fn scan(&mut self, plc: &mut Plc<'_>, now: u32) -> Result<(), String> {
        let ended = self.machine.scan(now.into());
        let ran = plc.scan(self.inputs, now);
        match (ended, ran) {
            (Ok(()), Ok(_)) => {}
            // Too many turns for the board.
            (_, Err(_)) => return Err("stopped".to_owned()),
            (Err(_), Ok(_)) => return Err("the interpreter alone does not end".to_owned()),
        }
        for (symbol, place) in self.tree.symbols.iter().zip(self.places) {
            let Some(place) = place else { continue };
            let (wanted, base) = self.machine.value(symbol);
            // A pin takes what fits it of what its variable holds.
            let wanted = match (&wanted, place.starts_with("Q ") && base != Base::Bool) {
                (Value::Int(level), true) => Value::Int((*level).clamp(0, 255)),
                _ => wanted,
            };
            if let Some(value) = held(plc, place, base, now)
                && !same(&value, &wanted)
            {
                let Symbol { name, .. } = symbol;
                return Err(format!(
                    "{name} ({place}) is {value:?} on the board, {wanted:?} on the PC"
                ));
            }
        }
        Ok(())
    }
}

fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Real(a), Value::Real(b)) => {
            a == b || (*a as f32).to_bits() == (*b as f32).to_bits()
        }
        (a, b) => a == b,
    }
}

/// Compiles a text for the large board.
pub fn compiled(text: &str, language: TextLanguage) -> CompiledText {
    compile_text(text, language, large())
}

/// Lends the program to a PLC.
pub fn with_plc<T>(checked: &mut Checked, run: impl FnOnce(&mut Plc<'_>) -> T) -> T {
    let mut plc = Plc::new(checked.lend());
    run(&mut plc)
}

/// Compares the programs of as many seeds, the first of which `UNOCLP_SEED` may say. More than so many per cent of them must
/// run, and none may differ: `compared` says whether a program ran, or how it differs.
pub fn none_differs(count: u32, percent: u64, compared: impl Fn(u64) -> Result<bool, String>) {
    let first = std::env::var("UNOCLP_SEED").map_or(1, |seed| seed.parse().expect("a number"));
    let count = u64::from(count);
    let (mut ran, mut wrong) = (0, Vec::new());
    for seed in first..first + count {
        match compared(seed) {
            Ok(did) => ran += u64::from(did),
            Err(why) => wrong.push((why, seed)),
        }
    }
    wrong.sort_by_key(|(why, _)| why.len());
    println!("{ran} of {count} ran, {} differ", wrong.len());
    if let Some((shortest, seed)) = wrong.first() {
        let first = wrong.iter().filter_map(|(why, _)| why.lines().next());
        let first: Vec<&str> = first.take(30).collect();
        let least = least(|| compared(*seed)).err();
        panic!(
            "{} differ:\n{}\nthe least of the shortest:\n{}",
            wrong.len(),
            first.join("\n"),
            least.as_ref().unwrap_or(shortest)
        );
    }
    assert!(ran * 100 > count * percent, "only {ran} of {count} ran");
}
