//! The watchdog on the release ELF: stalls patched into the scan.

use crate::common;
use crate::common::modbus::input;
use crate::common::{card, ms_until, to_run, uno};
use std::collections::BTreeSet;
use unoclp_testing::cases;
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

/// Outputs 01 and 02 are on in every scan; a timer and contacts make the scan go through all of
/// its code.
const TEXT: &str = "0\n877901\n787600\n-827301\n404101\n40\n404101\n-827902\n41\n83877902\n787600\n827301\n847978\n500\n7903\n787600\n827302\n847970\n500\n7904\n";

/// `rjmp .-2`: forever here.
const STALL: [u8; 2] = [0xFF, 0xCF];

fn running(boot_loader: bool) -> Uno {
    let mut uno = uno(Slot::Card(card(TEXT)));
    uno.set_boot_loader(boot_loader);
    to_run(&mut uno);
    uno.run_ms(20).unwrap();
    assert_eq!(uno.outputs() & 0b11, 0b11);
    uno
}

/// Addresses that scans go through, and what goes on beside them, in some ms.
fn places() -> Vec<u32> {
    let mut uno = running(false);
    let end = uno.cycles() + 3 * CYCLES_PER_MS;
    let mut places = BTreeSet::new();
    while uno.cycles() < end {
        places.insert(uno.pc());
        uno.step().unwrap();
    }
    places.into_iter().collect()
}

/// After how many ms the outputs are off.
fn off_within_150_ms(uno: &mut Uno, case: &str) -> u32 {
    let mut ms = 0;
    while uno.outputs() != 0 {
        uno.run_ms(1).unwrap();
        ms += 1;
        assert!(
            ms <= 150,
            "{case}: outputs {:04b} after {ms} ms",
            uno.outputs()
        );
    }
    ms
}

#[test]
fn a_stalled_scan_turns_the_outputs_off_within_150_ms() {
    stall_everywhere(false);
}

#[test]
fn a_stalled_scan_turns_the_outputs_off_behind_a_boot_loader_too() {
    stall_everywhere(true);
}

fn stall_everywhere(boot_loader: bool) {
    let (mut stalls, mut shown, mut slowest) = (0, 0, 0);
    for place in cases(places()) {
        let case = format!("stall at {place:#06x}, boot loader {boot_loader}");
        let mut uno = running(boot_loader);
        uno.patch_flash(place, &STALL).unwrap();
        slowest = slowest.max(off_within_150_ms(&mut uno, &case));
        // The fault is told and stays; where the stall is in code that telling needs too, the
        // board stands still, with its outputs off.
        let told = |uno: &Uno| uno.serial().contains("fault 61: a scan took");
        let mut ms = 0;
        while ms < 400 && !told(&uno) {
            ms += 1;
            if uno.run_ms(1).is_err() {
                break;
            }
        }
        shown += u32::from(told(&uno));
        let _ = uno.run_ms(20);
        assert_eq!(uno.outputs(), 0, "{case}");
        stalls += 1;
    }
    println!(
        "{stalls} of {stalls} stalls: outputs off after at most {slowest} ms, fault 61 told {shown} times"
    );
    assert!(shown > stalls / 2, "{shown} of {stalls}");
}

/// Scans that go on, while the clock's interrupt does not come any more, and with it nothing that goes on
/// beside the scans.
#[test]
fn a_clock_that_stands_still_turns_the_outputs_off() {
    for boot_loader in [false, true] {
        let mut uno = running(boot_loader);
        uno.stop_clock();
        let before = uno.cycles();
        let scan = uno.symbol("scan_begin").unwrap().address;
        for _ in 0..1000 {
            uno.run_until(scan, 10_000).unwrap();
        }
        assert!(uno.cycles() - before > 10 * CYCLES_PER_MS);
        off_within_150_ms(&mut uno, "the clock stands still");
        // Its age is not known without the clock; after the boot loader this is a reset as any other.
        uno.run_ms(400).unwrap();
        let told = uno.serial().contains("fault 61: a scan took");
        assert_eq!(told, !boot_loader, "{}", uno.serial());
    }
}

/// The dearest loops that there are: the budget of a scan (NC-19) ends them, and not the watchdog.
#[test]
fn a_loop_without_end_is_told_before_the_watchdog_bites() {
    for (name, code) in [
        ("DIV", "68738601\n"),
        ("MOD", "77796801\n"),
        ("MUL", "77857601\n"),
        ("INT", "73788402\n"),
        ("SHL", "83727631\n"),
        ("MOV", "77798601\n6810\n15\n"),
    ] {
        for times in [1, 8, 60] {
            let text = format!(
                "0\n766800\n3\n838401\n787600\n766601\n766800\n2147483647\n{}74778001\n",
                code.repeat(times)
            );
            let mut uno = uno(Slot::Card(card(&text)));
            to_run(&mut uno);
            uno.run_ms(400).unwrap();
            let fault = input(&mut uno, 18);
            assert_eq!(fault, 75, "{times} {name}: {}", uno.serial());
        }
    }
}

/// A panic that was thought impossible; where the compiler has found every one to be so, the firmware
/// holds nothing of them.
#[test]
fn a_panic_turns_the_outputs_off_and_is_a_fault() {
    let firmware = common::firmware();
    if firmware.symbol("abort").is_none() {
        let panics = firmware.symbols().find(|(name, _)| name.contains("panic"));
        assert!(panics.is_none(), "{panics:?}");
        println!("there is no panic in the firmware");
        return;
    }
    for boot_loader in [false, true] {
        let mut uno = running(boot_loader);
        let scan = uno.symbol("scan_begin").unwrap().address;
        let [low, high] = (uno.symbol("abort").unwrap().address as u16 / 2).to_le_bytes();
        // jmp abort
        uno.patch_flash(scan, &[0x0C, 0x94, low, high]).unwrap();
        uno.run_ms(1).unwrap();
        assert_eq!(uno.outputs(), 0);
        ms_until(&mut uno, &["fault 61"]);
        uno.run_ms(500).unwrap();
        assert_eq!(uno.outputs(), 0);
    }
}

#[test]
fn the_reset_button_ends_the_fault() {
    for boot_loader in [false, true] {
        let mut uno = running(boot_loader);
        let scan = uno.symbol("scan_begin").unwrap().address;
        let whole = uno.read_flash(scan, 2).unwrap().to_vec();
        uno.patch_flash(scan, &STALL).unwrap();
        let said = ms_until(&mut uno, &["fault 61"]).1;
        assert!(
            said.contains("restart 1 since power-up, by the watchdog"),
            "{said:?}"
        );
        uno.patch_flash(scan, &whole).unwrap();
        uno.take_serial();
        uno.reset();
        let said = to_run(&mut uno);
        assert!(
            said.contains("restart 2 since power-up, by reset, 1 fault\r\n"),
            "{said:?}"
        );
        uno.run_ms(20).unwrap();
        assert_eq!(uno.outputs() & 0b11, 0b11);
    }
}

/// Neither a long start-up nor a reset in the middle of it is taken for an overdue scan.
#[test]
fn a_start_up_is_no_scan() {
    for boot_loader in [false, true] {
        let mut uno = uno(Slot::Empty);
        uno.set_boot_loader(boot_loader);
        uno.run_ms(200).unwrap();
        uno.reset();
        let said = ms_until(&mut uno, &["fault 51"]).1;
        assert!(said.contains("by reset"), "{said:?}");
        assert!(!said.contains("watchdog"), "{said:?}");
    }
}

/// Power alone is no restart, whatever memory holds.
#[test]
fn power_is_not_taken_for_a_restart() {
    let mut uno = running(true);
    for _ in 0..20 {
        uno.take_serial();
        uno.power_up();
        let said = to_run(&mut uno);
        assert!(!said.contains("restart"), "{said:?}");
    }
}
