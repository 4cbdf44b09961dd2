//! The firmware through the real boot loaders: Optiboot, which UNOs and newer Nanos have, the one that Nanos had before, and
//! that of the Mega.

use crate::common;
use crate::common::line::{LOOK, now, talk};
use std::path::Path;
use std::time::Duration;
use unoclp_boot::{self as boot, Failure, Image, Model, Stage, Trouble, Writer};
use unoclp_cli::port::Port as SerialPort;
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::session::Event;
use unoclp_client::start::find;
use unoclp_client::upload::await_start;
use unoclp_client::watch::command;
use unoclp_client::{Client, Conversation, Next, Patience, flash};
use unoclp_lang::Lang;
use unoclp_modbus::map::{Command, State};
use unoclp_uno_sim::port::{Options, Pace, Port};
use unoclp_uno_sim::{BootLoader, CYCLES_PER_MS, Line, Program, STALL, Slot, Uno};

/// Input 01 is output 01.
const FOLLOW: &str = "0\n827301\n877901\n";

/// A chip with the boot loader of this board and a sketch, and its reset button just pressed.
fn chip(model: Model, slot: Slot) -> Uno {
    let mut uno = Uno::with_program(boot_loader(model), slot).unwrap();
    uno.reset();
    uno.set_serial_line(Line {
        baud: model.rate(),
        ..Line::default()
    });
    uno
}

fn boot_loader(model: Model) -> Program {
    let boot_loader = match model {
        Model::Uno | Model::Nano => BootLoader::Optiboot,
        Model::NanoOld => BootLoader::Old,
        Model::Mega => BootLoader::Mega,
    };
    assert_eq!(boot_loader.rate(), model.rate());
    boot_loader.program().unwrap()
}

/// The tested firmware of a board.
fn firmware(model: Model) -> Image {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware");
    let hex = folder.join(format!("unoclp-{}.hex", model.firmware().name()));
    Image::read(&std::fs::read(hex).unwrap(), model).unwrap()
}

/// Where something stands in it.
fn symbol(model: Model, name: &str) -> u32 {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware");
    let file = folder.join(format!("unoclp-{}.symbols", model.firmware().name()));
    let symbols = std::fs::read_to_string(file).unwrap();
    let line = symbols
        .lines()
        .find(|line| line.ends_with(&format!(" {name}")));
    let (address, _) = line.and_then(|line| line.split_once(' ')).unwrap();
    u32::from_str_radix(address, 16).unwrap()
}

/// A firmware of four pages: vectors, and then a loop.
fn small(model: Model) -> Image {
    let hex: &[u8] = match model {
        Model::Mega => include_bytes!("../data/loop-mega.hex"),
        _ => include_bytes!("../data/loop.hex"),
    };
    Image::read(hex, model).unwrap()
}

/// Which way a byte goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    ToBoard,
    FromBoard,
}

/// What comes of a byte on its way, and how much later; none: nothing.
type Fate<'a> = &'a mut dyn FnMut(Way, u8) -> Option<(u8, Duration)>;

/// Writes an image through the board's boot loader, on a line with this fate; the reset button is pressed where the
/// writer asks for a reset.
fn write(uno: &mut Uno, image: &Image, fate: Fate<'_>) -> Result<(), Failure> {
    let mut writer = Writer::new(image);
    uno.take_serial();
    let mut came = Vec::new();
    // What is on its way, and when it comes.
    let mut coming: Vec<(Duration, u8)> = Vec::new();
    loop {
        let step = writer.step(now(uno), &came);
        came.clear();
        if step.reset {
            uno.reset();
            uno.take_serial();
            coming.clear();
        }
        for byte in step.send {
            if let Some((byte, late)) = fate(Way::ToBoard, byte) {
                let cycles = late.as_millis() as u64 * CYCLES_PER_MS;
                uno.send_serial_at(uno.cycles() + cycles, &[byte]);
            }
        }
        let until = match step.next {
            boot::Next::Done(outcome) => return outcome,
            boot::Next::Wait(until) => until,
        };
        while came.is_empty() && now(uno) < until {
            uno.run_cycles(LOOK).unwrap();
            for sent in uno.take_serial_log() {
                let fate = fate(Way::FromBoard, sent.byte);
                coming.extend(fate.map(|(byte, late)| (now(uno) + late, byte)));
            }
            while coming.first().is_some_and(|&(at, _)| at <= now(uno)) {
                came.push(coming.remove(0).1);
            }
        }
    }
}

fn flash(uno: &mut Uno, image: &Image) -> Result<(), Failure> {
    write(uno, image, &mut |_, byte| Some((byte, Duration::ZERO)))
}

#[track_caller]
fn holds(uno: &Uno, image: &Image) {
    assert_eq!(
        uno.read_flash(0, image.bytes().len()).unwrap(),
        image.bytes()
    );
}

#[test]
fn the_firmware_goes_through_each_boot_loader_and_runs_a_program() {
    for model in Model::ALL {
        let mut uno = chip(model, Slot::Card(common::card(FOLLOW)));
        let kept = [0x5A; 16];
        uno.write_eeprom(0x3E0, &kept).unwrap();
        let image = firmware(model);
        assert_eq!(flash(&mut uno, &image), Ok(()), "{model:?}");
        holds(&uno, &image);
        assert_eq!(uno.read_eeprom(0x3E0, 16).unwrap(), kept);
        uno.set_serial_line(Line::default());
        let said = common::to_run(&mut uno);
        assert!(said.contains("unoclp 0."), "{said}");
        uno.set_inputs(1);
        uno.run_ms(50).unwrap();
        assert_eq!(uno.outputs(), 1);
        let found = talk(&mut uno, async |client| find(client, false).await);
        let product = match model {
            Model::Uno => "unoclp UNO",
            Model::Nano | Model::NanoOld => "unoclp Nano",
            Model::Mega => "unoclp Mega",
        };
        assert_eq!(found.unwrap().product, product);
    }
}

/// A scan that stands still: the reset of the watchdog leads through the boot loader, which clears the chip's record of it,
/// to a fault with the outputs off.
#[test]
fn a_reset_by_the_watchdog_is_told_after_the_boot_loader() {
    for model in [Model::Uno, Model::Mega] {
        let mut uno = chip(model, Slot::Card(common::card(FOLLOW)));
        assert_eq!(flash(&mut uno, &firmware(model)), Ok(()), "{model:?}");
        uno.set_serial_line(Line::default());
        common::to_run(&mut uno);
        uno.set_inputs(1);
        uno.run_ms(50).unwrap();
        assert_eq!(uno.outputs(), 1);
        uno.patch_flash(symbol(model, "scan_begin"), &STALL)
            .unwrap();
        let mut ms = 0;
        while uno.outputs() != 0 {
            uno.run_ms(1).unwrap();
            ms += 1;
            assert!(ms <= 150, "{model:?}: {ms} ms");
        }
        let said = common::ms_until(&mut uno, &["fault 61"]).1;
        assert!(said.contains("by the watchdog"), "{model:?}: {said:?}");
        uno.run_ms(100).unwrap();
        assert_eq!(uno.outputs(), 0, "{model:?}");
        assert_eq!(common::modbus::input(&mut uno, 19), 3, "{model:?}");
    }
}

/// Debian's boot loader for the Mega means to go on at once after a reset by the watchdog, but misses the firmware, and
/// waits as after any other reset. Each request that it hears then keeps it waiting. So the client leaves the board alone.
#[test]
fn a_board_that_was_told_to_restart_is_met_again() {
    for model in [Model::Uno, Model::Mega] {
        let mut uno = chip(model, Slot::Card(common::card(FOLLOW)));
        assert_eq!(flash(&mut uno, &firmware(model)), Ok(()), "{model:?}");
        uno.set_serial_line(Line::default());
        common::to_run(&mut uno);
        // By command, as at the end of an upload to a board in FAULT.
        let after = talk(&mut uno, async |client| {
            find(client, false).await.unwrap();
            command(client, Command::Restart).await.unwrap();
            await_start(client).await
        });
        assert_eq!(after.unwrap().state, Some(State::Run), "{model:?}");
    }
}

/// Reads the board again and again, until it has begun once more.
async fn watch(client: &mut Client) -> Diagnostics {
    let before = Diagnostics::read(client).await.unwrap().restarts;
    loop {
        match Diagnostics::read(client).await {
            Ok(told) if told.restarts != before => return told,
            _ => {}
        }
    }
}

#[test]
fn a_mega_that_is_watched_comes_back_after_its_reset_button() {
    let mut uno = chip(Model::Mega, Slot::Card(common::card(FOLLOW)));
    assert_eq!(flash(&mut uno, &firmware(Model::Mega)), Ok(()));
    uno.set_serial_line(Line::default());
    common::to_run(&mut uno);
    let mut conversation =
        Conversation::new(Default::default(), Patience::default(), async |client| {
            find(client, false).await.unwrap();
            watch(client).await
        });
    let pressed = now(&uno) + Duration::from_millis(500);
    let mut is_pressed = false;
    let mut came = Vec::new();
    let told = loop {
        let step = conversation.step(now(&uno), &came);
        came.clear();
        if !step.send.is_empty() {
            uno.send_serial(&step.send);
        }
        let until = match step.next {
            Next::Done(told) => break told,
            Next::Wait(until) => until,
        };
        while came.is_empty() && now(&uno) < until {
            uno.run_cycles(LOOK).unwrap();
            came.extend(uno.take_serial_log().iter().map(|sent| sent.byte));
            if !is_pressed && now(&uno) >= pressed {
                is_pressed = true;
                uno.reset();
            }
        }
        assert!(now(&uno) < pressed + Duration::from_secs(15), "it waits on");
    };
    assert_eq!(told.state, Some(State::Run));
}

#[test]
fn a_firmware_is_written_over_the_one_that_runs() {
    let mut uno = chip(Model::Uno, Slot::Card(common::card(FOLLOW)));
    assert_eq!(flash(&mut uno, &small(Model::Uno)), Ok(()));
    let image = firmware(Model::Uno);
    assert_eq!(flash(&mut uno, &image), Ok(()));
    common::to_run(&mut uno);
    // And from RUN back again.
    uno.run_ms(100).unwrap();
    assert_eq!(flash(&mut uno, &small(Model::Uno)), Ok(()));
    holds(&uno, &small(Model::Uno));
}

/// Its boot loader speaks another protocol: it is asked in that, and nothing is written.
#[test]
fn a_firmware_for_the_other_chip_is_refused_by_signature() {
    for [own, other] in [[Model::Uno, Model::Mega], [Model::Mega, Model::Uno]] {
        let mut uno = chip(own, Slot::Empty);
        let before = uno.read_flash(0, 0x1000).unwrap().to_vec();
        let failure = flash(&mut uno, &small(other)).unwrap_err();
        let signature = match own {
            Model::Mega => [0x1E, 0x98, 0x01],
            _ => [0x1E, 0x95, 0x0F],
        };
        let trouble = Trouble::OtherChip {
            signature,
            model: other,
        };
        let stage = Stage::Meeting;
        assert_eq!(failure, Failure { trouble, stage });
        assert_eq!(uno.read_flash(0, 0x1000).unwrap(), before);
        assert_eq!(flash(&mut uno, &small(own)), Ok(()));
    }
}

#[test]
fn a_boot_loader_at_another_rate_is_told_as_none() {
    let mut uno = chip(Model::NanoOld, Slot::Empty);
    let line = uno.serial_line();
    uno.set_serial_line(Line::default());
    let failure = flash(&mut uno, &small(Model::Uno)).unwrap_err();
    assert_eq!(failure.stage, Stage::Meeting);
    assert!(matches!(
        failure.trouble,
        Trouble::Silent | Trouble::Foreign
    ));
    uno.set_serial_line(line);
    assert_eq!(flash(&mut uno, &small(Model::NanoOld)), Ok(()));
}

/// Bytes each way of a whole conversation.
fn length(model: Model) -> usize {
    let mut count = 0;
    let mut uno = chip(model, Slot::Empty);
    let outcome = write(&mut uno, &small(model), &mut |_, byte| {
        count += 1;
        Some((byte, Duration::ZERO))
    });
    assert_eq!(outcome, Ok(()));
    count
}

#[test]
fn on_a_line_that_drops_delays_and_changes_bytes_the_next_try_works() {
    for model in [Model::Uno, Model::NanoOld] {
        let image = small(model);
        let length = length(model);
        for (round, hit) in (0..length).step_by(97).enumerate() {
            let mut uno = chip(model, Slot::Empty);
            let mut at = 0;
            let outcome = write(&mut uno, &image, &mut |_, byte| {
                let is_hit = at == hit;
                at += 1;
                match round % 4 {
                    _ if !is_hit => Some((byte, Duration::ZERO)),
                    0 => None,
                    1 => Some((byte ^ 0x10, Duration::ZERO)),
                    2 => Some((!byte, Duration::ZERO)),
                    _ => Some((byte, Duration::from_millis(1_500))),
                }
            });
            match outcome {
                Ok(()) => holds(&uno, &image),
                Err(failure) => assert!(
                    matches!(
                        failure.trouble,
                        Trouble::BrokenOff
                            | Trouble::Garbled
                            | Trouble::Differs { .. }
                            | Trouble::OtherChip { .. }
                    ),
                    "{failure:?}"
                ),
            }
            assert_eq!(flash(&mut uno, &image), Ok(()), "{model:?}, {hit}, {round}");
            holds(&uno, &image);
        }
    }
}

#[test]
fn the_firmware_goes_through_a_pseudo_terminal() {
    let options = Options {
        pace: Pace::RealTime,
        // As DTR does it on a real board; a pseudo-terminal has none.
        reset_on_open: true,
    };
    let model = Model::Uno;
    let slot = Slot::Card(common::card(FOLLOW));
    let board = Port::open(boot_loader(model), slot, options).unwrap();
    let path = board.path().to_str().unwrap().to_owned();
    // From the fifth answer on the board hears at this rate.
    let once = |image: &Image, baud: u32| {
        // Between two jobs the board looks at its port, and sees that nobody has it open.
        for _ in 0..2 {
            board
                .with(|uno| uno.set_serial_line(Line::default()))
                .unwrap();
        }
        let mut port = SerialPort::open_for_boot_loader(&path, model).unwrap();
        let mut writer = Writer::new(image);
        let mut tell = |event: Event<'_>| {
            let line = Line {
                baud,
                ..Line::default()
            };
            if matches!(event, Event::Flashing(progress) if progress.done == 5) {
                board.with(move |uno| uno.set_serial_line(line)).unwrap();
            }
        };
        port.talk(async |client| flash::flash(client, &mut writer, &mut tell).await)
    };
    // A computer that is busy may miss the second in which the boot loader waits: then one tries again.
    let write = |image: &Image, baud: u32| {
        let missed = |outcome: &Result<(), Failure>| matches!(outcome, Err(failure) if failure.stage == Stage::Meeting);
        let tries = (0..5).map(|_| once(image, baud));
        let mut tries = tries.skip_while(missed);
        tries.next().expect("the boot loader is met in five tries")
    };
    assert_eq!(write(&small(model), 115_200), Ok(()));
    let failure = write(&small(model), 57_600).unwrap_err();
    assert_eq!(failure.stage, Stage::Writing);
    let text = failure.text(Lang::En);
    assert!(text.contains("try again"), "{text}");
    let image = firmware(model);
    assert_eq!(write(&image, 115_200), Ok(()));
    board
        .with(move |uno| {
            holds(uno, &image);
            common::to_run(uno);
            uno.set_inputs(1);
            uno.run_ms(50).unwrap();
            assert_eq!(uno.outputs(), 1);
        })
        .unwrap();
    board.close().unwrap();
}
