//! The programs that are measured: as numeric code for the firmware and the thesis's interpreter, as C for the compiler.

use unoclp_host_sim::random::Random;

/// Codes of the language, one to a line, operands included.
pub type Codes = Vec<i64>;

/// A new rung: `NL 00`.
pub const NEW_RUNG: i64 = 787_600;
/// The codes in front of the point: `RI`, `RO`, `WO`, and a timer's output.
pub const INPUT: i64 = 827_300;
const OUTPUT: i64 = 827_900;
const COIL: i64 = 877_900;
const TIMED: i64 = 7_900;

/// The output that is inverted in every scan: 04.
pub const TOGGLING: u8 = 4;
/// The outputs that the measured logic drives: 01 to 03.
pub const DRIVEN: usize = 3;
/// Rungs, and timers, of the largest program.
pub const FULL_RUNGS: usize = 100;
/// See [`FULL_RUNGS`].
pub const FULL_TIMERS: usize = 32;
/// Bytes of a program in its stored form that the EEPROM has room for.
pub const FULL_STORE: usize = 900;

/// Contacts in series, and a coil.
#[derive(Clone, Debug)]
pub struct Rung {
    contacts: Vec<Contact>,
    coil: u8,
}

/// A contact of a point, 01 to 04.
#[derive(Clone, Copy, Debug)]
struct Contact {
    output: bool,
    point: u8,
    closed: bool,
}

/// With this seed each of the outputs 01 to 03 is on for some inputs and off for others, in the programs measured.
const SEED: u64 = 209;

/// Rungs of four contacts and a coil. Points and polarity vary, and no point comes twice in a rung. A contact of an
/// output comes after that output's coil, so the outputs follow from the inputs of the same scan alone.
pub fn rungs(count: usize) -> Vec<Rung> {
    let mut random = Random::new(SEED);
    let rung = |n| {
        let (mut inputs, mut outputs) = (vec![1, 2, 3, 4], vec![1, 2, 3]);
        let contacts = (0..4).map(|_| {
            let output = n >= DRIVEN && random.percent(33) && !outputs.is_empty();
            let points = if output { &mut outputs } else { &mut inputs };
            Contact {
                output,
                point: points.remove(random.below(points.len() as u32) as usize),
                closed: random.percent(50),
            }
        });
        Rung {
            contacts: contacts.collect(),
            coil: (n % DRIVEN) as u8 + 1,
        }
    };
    (0..count).map(rung).collect()
}

/// Two contacts and a coil.
pub fn small() -> Vec<Rung> {
    let input = |point| Contact {
        output: false,
        point,
        closed: false,
    };
    vec![Rung {
        contacts: vec![input(1), input(2)],
        coil: 1,
    }]
}

/// The rung that inverts output 04.
fn toggling() -> Rung {
    Rung {
        contacts: vec![Contact {
            output: true,
            point: TOGGLING,
            closed: true,
        }],
        coil: TOGGLING,
    }
}

impl Contact {
    fn code(self) -> i64 {
        let code = if self.output { OUTPUT } else { INPUT } + i64::from(self.point);
        if self.closed { -code } else { code }
    }

    fn c(self) -> String {
        let image = if self.output { 'q' } else { 'i' };
        let bit = format!("{image}[{}]", self.point - 1);
        if self.closed {
            format!("NOT({bit})")
        } else {
            bit
        }
    }
}

impl Rung {
    fn codes(&self) -> impl Iterator<Item = i64> {
        let contacts = self.contacts.iter().map(|contact| contact.code());
        let coil = COIL + i64::from(self.coil);
        [NEW_RUNG].into_iter().chain(contacts).chain([coil])
    }

    fn c(&self) -> String {
        let contacts: Vec<String> = self.contacts.iter().map(|contact| contact.c()).collect();
        format!("q[{}] = {};\n", self.coil - 1, contacts.join(" & "))
    }
}

/// These codes as a whole program, with the toggling rung as its last.
pub fn toggled(body: impl IntoIterator<Item = i64>) -> Codes {
    let body = [0].into_iter().chain(body);
    body.chain(toggling().codes()).collect()
}

/// These rungs, likewise.
pub fn program(rungs: &[Rung]) -> Codes {
    toggled(rungs.iter().flat_map(Rung::codes))
}

/// The same rungs as statements in C.
pub fn c(rungs: &[Rung]) -> String {
    rungs.iter().chain([&toggling()]).map(Rung::c).collect()
}

/// A program as a file on a card.
pub fn text(codes: &[i64]) -> String {
    codes.iter().map(|code| format!("{code}\n")).collect()
}

/// `count` rungs with a contact of input 01; with a timer block each where there is one.
pub fn timer_rungs(count: usize, timer: Option<(i64, u32)>) -> Codes {
    let rung = |n| {
        [NEW_RUNG, INPUT + 1]
            .into_iter()
            .chain(timer_block(timer, n))
    };
    toggled((0..count).flat_map(rung))
}

/// A timer block, its output being one of 01 to 03; nothing where there is none.
fn timer_block(timer: Option<(i64, u32)>, n: usize) -> impl Iterator<Item = i64> {
    let output = TIMED + (n % DRIVEN) as i64 + 1;
    timer
        .into_iter()
        .flat_map(move |(code, preset)| [code, preset.into(), output])
}

/// All that must fit at once: 100 rungs of four contacts and a coil, 32 of which go on with a timer.
pub fn full() -> Codes {
    const TON_TOF: [i64; 2] = [847_978, 847_970];
    let timer = |n| (n < FULL_TIMERS).then_some((TON_TOF[n % 2], 7 + 3 * n as u32));
    let rungs = rungs(FULL_RUNGS);
    let body = rungs.iter().enumerate();
    toggled(body.flat_map(|(n, rung)| rung.codes().chain(timer_block(timer(n), n))))
}

/// A program that fills the store to its last byte: six bytes a rung, then contacts.
pub fn full_store() -> Codes {
    let count = FULL_STORE / 6 - 1;
    let rungs = rungs(count);
    // The toggling rung takes three bytes.
    let rest = FULL_STORE - 6 * count - 3;
    let body = rungs.iter().flat_map(Rung::codes);
    toggled(body.chain([NEW_RUNG]).chain((1..rest).map(|_| INPUT + 1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_core::{Board, Image, Loader, Plc};

    /// Takes a program as the firmware does; gives its stored bytes and timers.
    fn load(codes: &[i64], then: impl FnOnce(Plc<'_>)) -> (usize, usize) {
        let mut memory = [0; 960];
        let mut loader = Loader::new(&mut memory, Board::UNO);
        for byte in text(codes).bytes() {
            loader.push(byte).unwrap();
        }
        let program = loader.finish().unwrap();
        let size = (program.stored().len(), program.timers());
        then(Plc::new(program));
        size
    }

    #[test]
    fn the_programs_are_as_large_as_they_claim() {
        let rungs = program(&rungs(FULL_RUNGS));
        assert_eq!(load(&rungs, |_| ()), (603, 0));
        assert_eq!(load(&full(), |_| ()), (795, FULL_TIMERS));
        assert_eq!(load(&full_store(), |_| ()), (FULL_STORE, 0));
        assert_eq!(
            load(&timer_rungs(5, Some((847_978, 9))), |_| ()),
            (5 * 8 + 3, 5)
        );
        assert_eq!(load(&timer_rungs(5, None), |_| ()), (5 * 2 + 3, 0));
    }

    /// Every output takes both values, and depends on nothing but the inputs.
    #[test]
    fn the_rungs_are_a_function_of_the_inputs() {
        for count in [10, 50, FULL_RUNGS] {
            let (mut on, mut off) = (0, 0);
            load(&program(&rungs(count)), |mut plc| {
                for inputs in (0..16).chain((0..16).rev()) {
                    let mut logic = || plc.scan(Image(inputs), 0).unwrap_or_default().0 & 0b0111;
                    let outputs = logic();
                    assert_eq!(outputs, logic());
                    (on, off) = (on | outputs, off | !outputs);
                }
            });
            assert_eq!((on & 0b0111, off & 0b0111), (0b0111, 0b0111), "{count}");
        }
    }

    #[test]
    fn a_rung_is_the_same_in_c() {
        let rung = Rung {
            contacts: vec![
                Contact {
                    output: false,
                    point: 1,
                    closed: false,
                },
                Contact {
                    output: true,
                    point: 2,
                    closed: true,
                },
            ],
            coil: 3,
        };
        assert_eq!(
            rung.codes().collect::<Codes>(),
            [787_600, 827_301, -827_902, 877_903]
        );
        assert_eq!(c(&[rung]), "q[2] = i[0] & NOT(q[1]);\nq[3] = NOT(q[3]);\n");
    }
}
