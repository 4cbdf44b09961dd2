//! The stack at its deepest, measured on the release ELF.

use crate::BOARD;
use crate::common;
use crate::modbus_upload;
use unoclp_card::image::{Fat, Image};
use unoclp_core::{Inputs, Needs};
use unoclp_host_sim::engine::Engine;
use unoclp_host_sim::random::{Random, random_inputs, random_program};
use unoclp_uno_sim::engine::{Clock, UnoEngine};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{Slot, Uno};

/// What must stay free at least, bytes.
const RESERVE: u32 = 64;

/// Bytes between static RAM and the deepest point of the stack so far.
fn free(uno: &Uno) -> u32 {
    (u32::from(uno.min_sp()) + 1).saturating_sub(uno.static_ram_end())
}

/// The longest program.
fn largest() -> String {
    "0\n".to_owned()
        + &"787600\n827301\n827302\n877901\n".repeat(usize::from(BOARD.stored_bytes) / 4)
}

#[test]
fn peak_stack_leaves_a_reserve() {
    let firmware = common::firmware();
    let mut engine = UnoEngine::new(firmware, Clock::Running).unwrap();
    let (mut load, mut run, mut fault) = (u32::MAX, u32::MAX, u32::MAX);
    let random = &mut Random::new(1);
    for n in 0..24 {
        let mut text = random_program(random);
        if n % 6 == 5 {
            text += "\n5 / no such code\n";
        }
        let fat = if n % 4 == 0 { Fat::Fat32 } else { Fat::Fat16 };
        let image = (0..20)
            .fold(Image::new(fat), |image, n| {
                image.file(format!("long file name {n}"), "x")
            })
            .fragmented_file("PROGRAM.TXT", text)
            .build()
            .unwrap();
        let card = SdCard::new([Kind::SdV1, Kind::SdscV2, Kind::Sdhc][n % 3], image).unwrap();
        let started = engine.start(Slot::Card(card)).unwrap();
        let uno = engine.uno().unwrap();
        if started.is_err() {
            fault = fault.min(free(uno));
            continue;
        }
        load = load.min(free(uno));
        uno.reset_min_sp();
        let mut inputs = Inputs::default();
        for now in 0..40 {
            inputs = random_inputs(random, Needs::default(), inputs);
            // A scan that ends in a fault is the last.
            if engine.scan(&inputs, now).unwrap().is_err() {
                break;
            }
        }
        run = run.min(free(engine.uno().unwrap()));
    }
    // STOP, by the switch, in a scan of the largest program.
    let mut uno = common::uno(Slot::Card(common::card(&largest())));
    common::to_run(&mut uno);
    uno.run_ms(20).unwrap();
    uno.reset_min_sp();
    uno.set_stop(true);
    uno.run_ms(1500).unwrap();
    let stop = free(&uno);
    // An upload, in STOP: the loader lies inside it.
    let mut upload = u32::MAX;
    let texts = (0..4).map(|_| random_program(random));
    for text in texts.chain([largest(), "0\n787600\n40\n123\n".to_owned()]) {
        let mut uno = modbus_upload::stopped();
        uno.reset_min_sp();
        let _ = modbus_upload::upload(&mut uno, [&text, &text], 244);
        uno.run_ms(20).unwrap();
        upload = upload.min(free(&uno));
    }
    let uno = engine.uno().unwrap();
    let room = uno.chip().ram_end() + 1 - uno.static_ram_end();
    for (when, free) in [
        ("load", load),
        ("run", run),
        ("fault", fault),
        ("stop", stop),
        ("upload", upload),
    ] {
        println!(
            "stack, {when}: peak {} of {room} bytes, {free} free",
            room - free
        );
        assert!(
            free >= RESERVE,
            "{when}: {free} bytes of stack free, at least {RESERVE} wanted"
        );
    }
}
