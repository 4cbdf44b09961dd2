//! Scans while STATE.TXT is written: whatever the card does, none takes half a millisecond longer,
//! and the outputs are right.

use crate::common::state::{
    Saved, assert_only_state_changed, image, run_to_save, running, state_card,
};
use crate::common::{card, firmware, to_run};
use std::sync::LazyLock;
use unoclp_testing::cases;
use unoclp_uno_sim::sd::{At, CardLog, Kind, SdCard, What};
use unoclp_uno_sim::{CYCLES_PER_MS, Pin, Slot, Uno};

/// Output 01 follows input 01; output 04 changes in every scan, so that there is always something
/// to save.
const TOGGLE: &str = "0\n827301\n877901\n787600\n-827904\n877904\n";

/// The longest scan of that program, cycles: what it takes beside a card without STATE.TXT, and half
/// a millisecond.
static LIMIT: LazyLock<u64> = LazyLock::new(|| {
    let mut uno = Uno::with_program(firmware(), Slot::Card(card(TOGGLE))).unwrap();
    to_run(&mut uno);
    let mut scans = Scans::default();
    scans.take(&mut uno);
    for _ in 0..50 {
        uno.run_ms(10).unwrap();
        scans.take(&mut uno);
    }
    println!("longest scan without STATE.TXT: {} cycles", scans.longest);
    scans.longest + CYCLES_PER_MS / 2
});

/// How long scans take, from edge to edge of output 04, from power-up on.
#[derive(Default)]
struct Scans {
    last: Option<u64>,
    /// Cycles.
    longest: u64,
    count: u64,
}

impl Scans {
    /// Takes the edges so far.
    fn take(&mut self, uno: &mut Uno) {
        for edge in uno.take_edges() {
            if edge.pin == Pin::Output(3) {
                let last = self.last.replace(edge.cycle).unwrap_or(edge.cycle);
                self.longest = self.longest.max(edge.cycle - last);
                self.count += 1;
            }
        }
    }

    /// Runs for a while, in which output 01 must follow input 01, and no scan be too long.
    fn watch(&mut self, uno: &mut Uno, ms: u64, case: &str) {
        for n in 0..ms.div_ceil(20) {
            uno.set_input(0, n % 2 == 0);
            let run = uno.run_ms(2);
            run.unwrap_or_else(|halt| panic!("{case}: {halt}"));
            assert_eq!(uno.outputs() & 1, uno.inputs() & 1, "{case}");
            uno.run_ms(18).unwrap();
            let before = self.count;
            self.take(uno);
            assert!(self.count > before + 10, "{case}: the scan stands still");
        }
        assert!(
            self.longest <= *LIMIT,
            "{case}: {} cycles, {} at most",
            self.longest,
            *LIMIT
        );
    }
}

fn log(uno: &Uno) -> &CardLog {
    uno.card().unwrap().log()
}

/// The card is left alone from now on, and LED L is on.
fn expect_given_up(uno: &mut Uno, scans: &mut Scans, case: &str) {
    let before = log(uno).clone();
    scans.watch(uno, 1100, case);
    assert_eq!(*log(uno), before, "{case}: the card is still asked");
    assert!(uno.led(), "{case}");
}

#[test]
fn a_busy_card_lengthens_no_scan() {
    for busy_ms in [0, 250, 450] {
        let case = format!("busy for {busy_ms} ms");
        let mut uno = running(state_card(TOGGLE).with_write_time(busy_ms * CYCLES_PER_MS));
        let mut scans = Scans::default();
        scans.watch(&mut uno, 2900, &case);
        let saves = log(&uno).count(13);
        assert_eq!(saves, 3, "{case}");
        // Start-up and the blocks themselves make for some of them.
        let asked = log(&uno).selections / saves as u64;
        println!(
            "{case}: longest scan {} cycles, the card selected {asked} times a save",
            scans.longest
        );
        assert!(asked <= busy_ms + 12, "{case}: selected {asked} times");
    }
}

#[test]
fn a_card_that_stays_busy_is_given_up_after_500_ms() {
    for busy_ms in [600, 1_000_000] {
        let case = format!("busy for {busy_ms} ms");
        let mut uno = running(state_card(TOGGLE).with_write_time(busy_ms * CYCLES_PER_MS));
        let mut scans = Scans::default();
        scans.watch(&mut uno, 560, &case);
        expect_given_up(&mut uno, &mut scans, &case);
        println!("{case}: longest scan {} cycles", scans.longest);
        assert_eq!(
            (log(&uno).writes.len(), log(&uno).count(13)),
            (1, 0),
            "{case}"
        );

        // A new start is a new beginning.
        uno.card_mut().unwrap().set_write_time(0);
        uno.power_up();
        to_run(&mut uno);
        run_to_save(&mut uno);
    }
}

/// What a fault leads to.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Then {
    /// It cannot be seen, or does no harm: the next save comes.
    Saves,
    /// No save any more.
    GivesUp,
    /// The one or the other: no sound card does so.
    Either,
}

#[test]
fn a_fault_of_the_card_in_a_save_lengthens_no_scan() {
    use Then::{Either, GivesUp, Saves};
    // At CMD24, at its data block, at CMD13.
    const FAULTS: [(What, [Then; 3]); 9] = [
        (What::NoAnswer, [GivesUp, GivesUp, GivesUp]),
        (What::WrongCrc, [GivesUp, GivesUp, GivesUp]),
        (What::WrongToken, [Saves, GivesUp, Saves]),
        (What::Garbage, [Saves, Saves, Saves]),
        (What::Removed, [GivesUp, GivesUp, GivesUp]),
        (What::Busy(20), [Either, Saves, Either]),
        (What::Busy(100_000), [Either, GivesUp, Either]),
        (What::Stuck, [GivesUp, GivesUp, Either]),
        (What::NeverReady, [Saves, Saves, Saves]),
    ];
    let before = image(TOGGLE).build().unwrap();
    let places = {
        let mut healthy = running(state_card(TOGGLE));
        run_to_save(&mut healthy);
        let log = log(&healthy);
        let command = |index| {
            let mut commands = log.commands.iter();
            At::Command(commands.position(|command| command.index == index).unwrap())
        };
        [
            command(24),
            At::Block(log.blocks_read as usize),
            command(13),
        ]
    };
    let (mut faults, mut longest) = (0, 0);
    for (what, outcomes) in cases(FAULTS) {
        for (at, then) in places.into_iter().zip(outcomes) {
            let case = format!("{what:?} at {at:?}");
            let mut uno = running(state_card(TOGGLE).with_fault(at, what));
            let mut scans = Scans::default();
            // A card that stays busy is waited for.
            let busy = matches!(what, What::Busy(_) | What::Stuck);
            scans.watch(&mut uno, if busy { 560 } else { 60 }, &case);
            match then {
                GivesUp => {
                    assert_eq!(log(&uno).count(24), 1, "{case}");
                    expect_given_up(&mut uno, &mut scans, &case);
                }
                Saves | Either => {
                    let whole = log(&uno).count(13);
                    scans.watch(&mut uno, 1100, &case);
                    assert!(then == Either || log(&uno).count(13) > whole, "{case}");
                }
            }
            assert_only_state_changed(&before, uno.card().unwrap(), &case);
            longest = longest.max(scans.longest);
            faults += 1;
        }
    }
    println!(
        "{faults} faults of a card in a save: in RUN after each, longest scan {longest} cycles"
    );
}

/// Pulled out at many moments; it comes back, or another card comes.
#[test]
fn a_card_that_is_pulled_out_in_run_is_never_written_again() {
    let mut pulled = 0;
    for after_us in (0..16_000).step_by(900).chain([100_000, 500_000]) {
        let same = pulled % 2 == 0;
        let case = format!("pulled out after {after_us} us, the same comes back: {same}");
        let mut uno = running(state_card(TOGGLE).with_write_time(5 * CYCLES_PER_MS));
        uno.run_cycles(after_us * 16).unwrap();
        let mut scans = Scans::default();
        let Slot::Card(mut card) = uno.swap_slot(Slot::Empty) else {
            unreachable!("there is a card")
        };
        scans.watch(&mut uno, 20, &case);
        if same {
            card.power_cycle();
        } else {
            card = SdCard::new(Kind::Sdhc, image("0\n").build().unwrap()).unwrap();
        }
        let (before, commands) = (card.image().to_vec(), card.log().commands.len());
        uno.swap_slot(Slot::Card(card));
        scans.watch(&mut uno, 1100, &case);
        let tries = &log(&uno).commands[commands..];
        assert!(tries.len() <= 1, "{case}: {tries:?}");
        assert!(uno.card().unwrap().image() == before, "{case}");
        assert!(uno.led(), "{case}");
        pulled += 1;
    }
    println!("{pulled} cards pulled out: in RUN after each, none written to when it came back");
}

/// Numbers of many digits take longest to write.
#[test]
fn the_longest_uptime_lengthens_no_scan() {
    // As the other program, but output 04 changes only while input 02 is closed.
    let mut uno = running(state_card(
        "0\n827301\n877901\n787600\n827302\n-827904\n877904\n",
    ));
    let mut scans = Scans::default();
    // Nothing is saved meanwhile. Only the count of seconds says 1, 2 and 3 then.
    let mut places: Vec<u32> = (uno.chip().ram_start()..uno.chip().ram_end() - 8).collect();
    for second in 1..=3u32 {
        let now = uno.cycles();
        uno.run_cycles((u64::from(second) * 1000 + 500) * CYCLES_PER_MS - now)
            .unwrap();
        let count = format!("{second:10}").into_bytes();
        places.retain(|&place| uno.read_ram(place, 10).unwrap() == count);
    }
    let [place] = places[..] else {
        panic!("a count of seconds is at {places:?}")
    };
    let longest = 9_999_999_990u64;
    uno.set_input(1, true);
    uno.write_ram(place, longest.to_string().as_bytes())
        .unwrap();
    scans.watch(&mut uno, 2500, "the longest uptime");
    let saved = Saved::last(uno.card().unwrap());
    println!(
        "uptime {} s: longest scan {} cycles",
        saved.uptime, scans.longest
    );
    assert!(saved.uptime > longest, "{saved:?}");
}
