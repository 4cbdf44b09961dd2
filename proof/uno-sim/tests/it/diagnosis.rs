//! Self-diagnosis while the program runs: each anomaly turns the outputs off and is told.

use crate::common;
use crate::common::modbus::{input, words};
use crate::common::{card, to_run, to_run_or_fault, uno};
use unoclp_testing::cases;
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
fn fault_within(limit: u64, mut uno: Uno, case: &str) -> (String, u16) {
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

/// Outputs 01 to 04 are on; then every instruction of the language.
const EVERYTHING: &str = "0\n877901\n877902\n877903\n877904\n787600\n827301\n-827304\n787600\n827301\n827302\n-827303\n827904\n404101\n40\n404101\n-827904\n41\n83877901\n82877902\n787600\n847978\n500\n7903\n827302\n847970\n70000\n7904\n";

/// Every bit of the program in run memory, turned while it runs. The check sum tells; but a byte
/// that is no handler's any more may lead the scan astray before, which is a fault too.
#[test]
fn a_program_that_changes_in_run_memory_is_a_fault() {
    // Run memory stands right behind the page of 512 bytes.
    let memory = common::firmware().symbol("PAGE").expect("the page").address + 512;
    let (mut told, mut astray) = (0, 0);
    // Not the coils in front, whose change may turn the outputs off before the check sees it.
    for (place, bit) in cases((4..24).flat_map(|place| (0..8).map(move |bit| (place, bit)))) {
        let case = format!("byte {place}, bit {bit}");
        let mut uno = uno(Slot::Card(card(EVERYTHING)));
        to_run(&mut uno);
        uno.run_ms(5).unwrap();
        let byte = uno.read_ram(memory + place, 1).unwrap()[0];
        uno.write_ram(memory + place, &[byte ^ 1 << bit]).unwrap();
        let (said, fault) = fault_within(150, uno, &case);
        if said.contains("restart 1") {
            let hung = said.contains("by the watchdog") && said.contains("fault 61: a scan");
            let began_anew = said.contains("without a reset") && said.contains("fault 62: ");
            assert!(
                hung && fault == 61 || began_anew && fault == 62,
                "{case}: {said:?}"
            );
            astray += 1;
        } else {
            assert_eq!((said.as_str(), fault), ("", 62), "{case}");
            told += 1;
        }
    }
    println!(
        "{told} turned bits of a running program told by the check sum, {astray} by where they led"
    );
    assert!(told > astray, "{told} {astray}");
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
