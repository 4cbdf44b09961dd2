//! Self-diagnosis while the program runs: each anomaly turns the outputs off and is told.

use crate::common;
use crate::common::modbus::{input, words};
use crate::common::{card, to_run, to_run_or_fault, uno};
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

/// Outputs 01 to 04 are on.
const TEXT: &str = "0\n877901\n877902\n877903\n877904\n787600\n827301\n827302\n827303\n-827301\n-827302\n787600\n827304\n";

fn running() -> Uno {
    let mut uno = uno(Slot::Card(card(TEXT)));
    to_run(&mut uno);
    uno.run_ms(10).unwrap();
    assert_eq!(uno.outputs(), 0b1111);
    uno
}

fn expect_fault(uno: Uno, case: &str, fault: u16) {
    assert_eq!(
        fault_within(20, uno, case),
        (String::new(), fault),
        "{case}"
    );
}

/// The fault that turns the outputs off within this time, for good; and what the serial port says, where the
/// board has begun again.
pub fn fault_within(limit: u64, mut uno: Uno, case: &str) -> (String, u16) {
    let mut ms = 0;
    while uno.outputs() != 0 {
        uno.run_ms(1).unwrap();
        ms += 1;
        assert!(
            ms <= limit,
            "{case}: outputs {:04b} after {ms} ms",
            uno.outputs()
        );
    }
    uno.run_ms(200).unwrap();
    assert_eq!(uno.outputs(), 0, "{case}");
    let said = String::from_utf8(uno.take_serial()).unwrap();
    assert_eq!(input(&mut uno, 16), 3, "{case}: {said:?}");
    (said, input(&mut uno, 18))
}

#[test]
fn a_stack_that_grows_too_far_is_a_fault() {
    let mut uno = running();
    let guard = uno.symbol("GUARD").unwrap();
    uno.write_ram(guard.address + 1, &[0]).unwrap();
    expect_fault(uno, "guard", 63);
}

#[test]
fn a_low_supply_is_a_fault_and_a_weak_one_a_warning() {
    let mut uno = running();
    uno.set_supply(4400);
    uno.run_ms(100).unwrap();
    assert_eq!(uno.outputs(), 0b1111);
    uno.set_supply(4200);
    expect_fault(uno, "4.2 V", 64);

    let mut weak = common::uno(Slot::Card(card(TEXT)));
    weak.set_supply(4500);
    let said = to_run(&mut weak);
    assert!(said.contains("warning: the supply is weak, 4"), "{said:?}");
    for supply in [4500, 5000] {
        weak.set_supply(supply);
        weak.run_ms(10).unwrap();
        let told = 1_126_400 / u32::from(input(&mut weak, 30));
        assert!(told.abs_diff(supply.into()) < 50, "{supply}: {told}");
    }

    let mut low = common::uno(Slot::Card(card(TEXT)));
    low.set_supply(4000);
    let said = to_run_or_fault(&mut low);
    assert!(said.contains("fault 64"), "{said:?}");
    assert_eq!(low.outputs(), 0);
}

/// Over many milliseconds, with scans that an end of one falls into at any place.
#[test]
fn scan_times_are_those_of_the_chip() {
    let mut uno = uno(Slot::Card(card(TEXT)));
    let scan = uno.symbol("scan_begin").unwrap().address;
    uno.run_until(scan, 8000 * CYCLES_PER_MS).unwrap();
    let (mut shortest, mut longest, mut begun) = (u64::MAX, 0, uno.cycles());
    for _ in 0..20_000 {
        uno.run_until(scan, 1_000_000).unwrap();
        let cycles = uno.cycles() - begun;
        (shortest, longest) = (shortest.min(cycles), longest.max(cycles));
        begun = uno.cycles();
    }
    uno.set_stop(true);
    uno.run_ms(2).unwrap();
    let [last, least, most] = words(&mut uno, 4, 24, 3)[..] else {
        panic!("three words")
    };
    println!(
        "scans of {shortest} to {longest} cycles; told: last {last}, least {least}, most {most} us"
    );
    assert!(least <= last && last <= most);
    // The moment is taken a little after the symbol; the interrupt may fall in between.
    for (told, cycles) in [(least, shortest), (most, longest)] {
        assert!(
            (u64::from(told) * 16).abs_diff(cycles) <= 60,
            "{cycles}: {told}"
        );
    }
}
