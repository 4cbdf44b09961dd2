//! Self-diagnosis while the program runs: each anomaly turns the outputs off and is told.

mod common;

use common::{card, ms_until, to_run, to_run_or_fault, uno};
use unoclp_uno_sim::{Slot, Space, Uno};

/// Outputs 01 to 04 are on.
const TEXT: &str = "0\n877901\n877902\n877903\n877904\n787600\n827301\n827302\n827303\n-827301\n-827302\n787600\n827304\n";

fn running() -> Uno {
    let mut uno = uno(Slot::Card(card(TEXT)));
    to_run(&mut uno);
    uno.run_ms(10).unwrap();
    assert_eq!(uno.outputs(), 0b1111);
    uno
}

fn expect_fault(mut uno: Uno, case: &str, fault: &str) {
    let mut ms = 0;
    while uno.outputs() != 0 {
        uno.run_ms(1).unwrap();
        ms += 1;
        assert!(
            ms <= 20,
            "{case}: outputs {:04b} after {ms} ms",
            uno.outputs()
        );
    }
    let said = ms_until(&mut uno, &["reset\r\n", "supply\r\n"]).1;
    assert!(said.contains(fault), "{case}: {said:?}");
    uno.run_ms(500).unwrap();
    assert_eq!(uno.outputs(), 0, "{case}");
}

/// Every bit of the program in run memory, turned while it runs.
#[test]
fn a_program_that_changes_in_run_memory_is_a_fault() {
    let at = {
        let uno = running();
        let mut memories = uno.program().symbols().filter(|(name, symbol)| {
            symbol.space == Space::Data && symbol.size == 960 && name.contains("MEMORY")
        });
        let memory = memories.next().expect("the run memory").1.address;
        assert_eq!(memories.next(), None);
        memory
    };
    let mut turned = 0;
    // Not the coils themselves, whose change may turn the outputs off before the check sees it.
    for place in 4..12 {
        for bit in 0..8 {
            let mut uno = running();
            let byte = uno.read_ram(at + place, 1).unwrap()[0];
            uno.write_ram(at + place, &[byte ^ 1 << bit]).unwrap();
            expect_fault(uno, &format!("byte {place}, bit {bit}"), "fault 62");
            turned += 1;
        }
    }
    println!("{turned} of {turned} turned bits of a running program found");
}

#[test]
fn a_stack_that_grows_too_far_is_a_fault() {
    let mut uno = running();
    let guard = uno.symbol("GUARD").unwrap();
    uno.write_ram(guard.address + 1, &[0]).unwrap();
    expect_fault(uno, "guard", "fault 63");
}

#[test]
fn a_low_supply_is_a_fault_and_a_weak_one_a_warning() {
    let mut uno = running();
    uno.set_supply(4400);
    uno.run_ms(100).unwrap();
    assert_eq!(uno.outputs(), 0b1111);
    uno.set_supply(4200);
    expect_fault(uno, "4.2 V", "fault 64");

    let mut weak = common::uno(Slot::Card(card(TEXT)));
    weak.set_supply(4500);
    let said = to_run(&mut weak);
    assert!(said.contains("warning: the supply is weak, 4"), "{said:?}");
    weak.set_stop(true);
    let said = ms_until(&mut weak, &[" faults\r\n"]).1;
    assert!(
        said.contains("\r\nsupply: 4") && said.contains(" mV, weak; "),
        "{said:?}"
    );
    weak.set_stop(false);
    to_run(&mut weak);
    weak.set_supply(5000);
    weak.run_ms(10).unwrap();
    weak.set_stop(true);
    let said = ms_until(&mut weak, &[" faults\r\n"]).1;
    assert!(!said.contains("weak"), "{said:?}");

    let mut low = common::uno(Slot::Card(card(TEXT)));
    low.set_supply(4000);
    let said = to_run_or_fault(&mut low);
    assert!(said.contains("fault 64"), "{said:?}");
    assert_eq!(low.outputs(), 0);
}

#[test]
fn scan_times_are_those_of_the_chip() {
    let mut uno = running();
    // What the chip really takes from scan to scan, without the interrupt.
    let scan = uno.symbol("scan_begin").unwrap().address;
    uno.run_until(scan, 1_000_000).unwrap();
    let begun = uno.cycles();
    uno.run_until(scan, 1_000_000).unwrap();
    let cycles = uno.cycles() - begun;
    uno.set_stop(true);
    let said = ms_until(&mut uno, &[" us\r\n"]).1;
    let numbers: Vec<u64> = said
        .split(|c: char| !c.is_ascii_digit())
        .filter_map(|number| number.parse().ok())
        .collect();
    let [last, least, most] = numbers[..] else {
        panic!("{said:?}")
    };
    println!("a scan of {cycles} cycles; told: last {last}, least {least}, most {most} us");
    assert!(least <= last && last <= most);
    // The figure leaves out what the loop does around the scan, some 15 us, and an interrupt there.
    assert!(
        least * 16 <= cycles && cycles < (most + 40) * 16,
        "{cycles} cycles: {said:?}"
    );
}
