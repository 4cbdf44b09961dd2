//! A program that changes in run memory while it runs.

use crate::common::{card, firmware, to_run, uno};
use crate::diagnosis::fault_within;
use unoclp_testing::cases;
use unoclp_uno_sim::Slot;

/// Outputs 01 to 04 are on; then every instruction of the language.
const EVERYTHING: &str = "0\n877901\n877902\n877903\n877904\n787600\n827301\n-827304\n787600\n827301\n827302\n-827303\n827904\n404101\n40\n404101\n-827904\n41\n83877901\n82877902\n787600\n847978\n500\n7903\n827302\n847970\n70000\n7904\n";

/// Every bit of the program in run memory, turned while it runs. The checksum tells; but a byte
/// that is no handler's any more may lead the scan astray before, which is a fault too.
#[test]
fn a_program_that_changes_in_run_memory_is_a_fault() {
    // Run memory stands right behind the page of 512 bytes.
    let memory = firmware().symbol("PAGE").expect("the page").address + 512;
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
        "{told} turned bits of a running program told by the checksum, {astray} by where they led"
    );
    assert!(told > astray, "{told} {astray}");
}
