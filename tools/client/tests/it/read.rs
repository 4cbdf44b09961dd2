//! What is read of a board, and written to it.

use crate::fake::{Board, FAULT, Fate, RUN, STOP, kept};
use crate::line::Wire;
use unoclp_client::diagnostics::{Diagnostics, Kept};
use unoclp_client::event::{Again, Unsettled};
use unoclp_client::lock;
use unoclp_client::map::{Command, Parity, State, cause, holding, input};
use unoclp_client::order::{Done, Order, Undone};
use unoclp_client::settings::{Settings, read_lock};
use unoclp_client::settle::{go_on, may_settle, settle};
use unoclp_client::watch::{Forces, Meter, Reading, Scope, Side};
use unoclp_client::{Client, Failure};
use unoclp_modbus::Exception;

fn read(wire: &mut Wire, scope: Scope) -> Reading {
    wire.talk(async |client| Reading::read(client, scope).await)
        .unwrap()
}

fn fulfil(wire: &mut Wire, order: Order) -> Result<Done, Undone> {
    wire.talk(async |client| order.fulfil(client, None, &mut |_| ()).await)
}

#[test]
fn every_read_has_its_shape() {
    let (i, h) = (input::ANALOGUE.table as u16, holding::SETTINGS.table as u16);
    let words = [
        (i, input::ANALOGUE.first, 1023),
        (i, input::ANALOGUE.first + 4, 7),
        (h, holding::FIRST_REGISTERS.end() - 2, 0xFFFF),
        (h, holding::FIRST_REGISTERS.end() - 1, 0xFFFE),
        (i, input::TIMERS.first, 1),
        (i, input::TIMERS.first + 1, 2),
        (h, holding::TIMERS.first, 3),
        (h, holding::TIMERS.first + 1, 4),
        (i, input::TIMERS.end() - 1, 9),
        (i, input::COUNTERS.end() - 1, 5),
        (h, holding::COUNTERS.end() - 1, 6),
        (i, input::CAUSE.first, 5),
        (i, input::UPTIME.first, 1),
        (i, input::SCAN_TIMES.first, 300),
        (i, input::SCAN_TIMES.first + 2, 400),
        (i, input::FREE_STACK.first, 120),
        (i, input::SUPPLY.first, 225),
        (i, input::RESTARTS.first, 2),
        (i, input::FAULTS.first, 1),
    ];
    let mut wire = Wire::new(Board {
        inputs: 0b1000_0101,
        outputs: 0b0110,
        markers: 0x8000_0000_0000_0005,
        words: words
            .map(|(table, address, word)| ((table, address), word))
            .into(),
        ..Board::in_state(STOP)
    });
    let scope = Scope {
        registers: 64,
        timers: 87,
        counters: 16,
    };
    let reading = read(&mut wire, scope);
    let board = reading.diagnostics;
    assert_eq!(board.state, Some(State::Stop));
    assert_eq!((cause(board.cause), board.uptime), ("command", 65_536));
    assert_eq!((board.scan_times, board.free_stack), ([300, 0, 400], 120));
    assert_eq!((board.supply, board.restarts, board.faults), (5006, 2, 1));
    assert_eq!(board.program, wire.board.kept);
    assert_eq!((reading.inputs, reading.outputs), (0b1000_0101, 0b0110));
    assert_eq!(reading.markers, Some(0x8000_0000_0000_0005));
    assert_eq!(reading.analogue, [1023, 0, 0, 0, 7]);
    assert_eq!((reading.registers.len(), reading.registers[63]), (64, -2));
    assert_eq!((reading.timers.len(), reading.counters.len()), (87, 16));
    let meter = |value, preset| Meter { value, preset };
    assert_eq!(reading.timers[0], meter(0x1_0002, 0x3_0004));
    assert_eq!(reading.timers[86], meter(9, 0));
    assert_eq!(reading.counters[15], meter(5, 6));
}

#[test]
fn a_board_without_markers_and_registers_is_read_too() {
    let mut wire = Wire::new(Board {
        is_of_version_1: true,
        ..Board::default()
    });
    let scope = Scope {
        registers: 32,
        timers: 2,
        counters: 1,
    };
    let reading = read(&mut wire, scope);
    assert_eq!(reading.markers, None);
    assert!(reading.analogue.is_empty() && reading.registers.is_empty());
    assert!(reading.timers.is_empty() && reading.counters.is_empty());
}

#[test]
fn points_are_forced_and_let_go() {
    let mut wire = Wire::new(Board::default());
    let mut wish = |order: Order| {
        fulfil(&mut wire, order).unwrap();
        (read(&mut wire, Scope::default()), wire.board.forces)
    };
    let (reading, _) = wish(Order::Force(Side::Inputs, 7, Some(true)));
    assert_eq!((reading.inputs, reading.forced_inputs.points), (0x80, 0x80));
    let (reading, _) = wish(Order::Force(Side::Inputs, 0, Some(false)));
    let both = Forces {
        points: 0x81,
        to: 0x80,
    };
    assert_eq!(reading.forced_inputs, both);
    wish(Order::Force(Side::Inputs, 7, None));
    let (_, forces) = wish(Order::Force(Side::Outputs, 3, Some(true)));
    assert_eq!(forces, [1, 0, 8, 8, 0]);
    let (_, forces) = wish(Order::Release);
    assert_eq!(forces, [0; 5]);
}

#[test]
fn commands_reach_the_board() {
    let mut wire = Wire::new(Board::default());
    let mut command = |command| {
        let outcome = fulfil(&mut wire, Order::Command(command));
        let Board {
            state,
            single_scans,
            restarts,
            ..
        } = wire.board;
        (outcome, state, single_scans, restarts)
    };
    assert_eq!(command(Command::Stop), (Ok(Done::Plainly), STOP, 0, 0));
    assert_eq!(
        command(Command::SingleScan),
        (Ok(Done::Plainly), STOP, 1, 0)
    );
    assert_eq!(command(Command::Run), (Ok(Done::Plainly), RUN, 1, 0));
    assert_eq!(
        command(Command::SingleScan),
        (Ok(Done::Plainly), STOP, 2, 0)
    );
    assert_eq!(command(Command::Restart), (Ok(Done::Plainly), RUN, 2, 1));
}

#[test]
fn a_command_whose_answer_is_lost_is_repeated() {
    let mut lost = true;
    let mut wire = Wire::with(Board::default(), move |_, _| {
        match std::mem::take(&mut lost) {
            true => Fate::AnswerLost,
            false => Fate::Answered,
        }
    });
    assert_eq!(
        fulfil(&mut wire, Order::Command(Command::Stop)),
        Ok(Done::Plainly)
    );
    assert_eq!((wire.board.state, wire.sent.len()), (STOP, 2));
}

#[test]
fn settings_are_read_and_written() {
    let mut wire = Wire::new(Board {
        settings: [3, 96, 2, 1, 4],
        ..Board::in_state(STOP)
    });
    let read = async |client: &mut Client| Settings::read(client).await;
    let old = wire.talk(read).unwrap();
    let kept = Settings {
        address: 3,
        rate: 9600,
        parity: Parity::Odd,
        direction: true,
        lock: Some(lock::COMMANDS),
    };
    assert_eq!(old, kept);
    let mut new = old;
    (new.address, new.rate) = (247, 2400);
    (new.parity, new.direction) = (Parity::Even, false);
    new.lock = Some(lock::COMMANDS | lock::WRITING);
    wire.talk(async |client| new.write(old, client).await)
        .unwrap();
    assert_eq!(wire.board.settings, [247, 24, 1, 0, 12]);
    assert_eq!(wire.talk(read_lock), Ok(12));
    // None of this version.
    for settings in [[256, 96, 0, 0, 0], [1, 96, 3, 0, 0], [1, 1152, 0, 0, 0x100]] {
        wire.board.settings = settings;
        assert_eq!(wire.talk(read), Err(Failure::Garbled));
    }
}

#[test]
fn a_board_without_a_lock_has_four_settings() {
    let mut wire = Wire::new(Board {
        is_of_version_1: true,
        ..Board::in_state(STOP)
    });
    let old = wire.talk(Settings::read).unwrap();
    assert_eq!((old.address, old.lock), (1, None));
    assert_eq!(wire.talk(read_lock), Ok(0));
    let new = Settings { address: 9, ..old };
    wire.talk(async |client| new.write(old, client).await)
        .unwrap();
    assert_eq!(wire.board.settings[..2], [9, 1152]);
}

/// They are sent again, and the board refuses that: by the lock that they have set, or since they were one too many.
#[test]
fn settings_whose_answer_is_lost_are_taken_once() {
    for (bits, changes_left) in [(lock::SETTINGS, 16), (lock::UPLOAD, 1)] {
        let mut writes = 0;
        let board = Board {
            changes_left,
            ..Board::in_state(STOP)
        };
        let mut wire = Wire::with(board, move |_, request| {
            writes += u32::from(request[1] == 16);
            match request[1] == 16 && writes == 1 {
                true => Fate::AnswerLost,
                false => Fate::Answered,
            }
        });
        let old = wire.talk(Settings::read).unwrap();
        let lock = Some(bits);
        let new = Settings { lock, ..old };
        let written = wire.talk(async |client| new.write(old, client).await);
        assert_eq!(written, Ok(()));
        assert_eq!(wire.board.changes_left, changes_left - 1);
        // What is refused as it is sent is not taken for that.
        let newer = Settings { address: 9, ..new };
        let refused = wire.talk(async |client| newer.write(new, client).await);
        assert!(matches!(refused, Err(Failure::Refused(_))), "{refused:?}");
    }
}

/// Nothing differs then, so nothing shows whether they are kept.
#[test]
fn defaults_that_cannot_be_kept_are_not_taken_for_kept() {
    let mut wire = Wire::new(Board {
        has_defaults: true,
        changes_left: 0,
        ..Board::in_state(STOP)
    });
    let old = wire.talk(Settings::read).unwrap();
    let written = wire.talk(async |client| old.write(old, client).await);
    assert_eq!(written, Err(Failure::Refused(Exception::ServerDeviceBusy)));
}

#[test]
fn a_diagnosis_is_complete() {
    let mut wire = Wire::new(Board {
        fault: 24,
        line: 70_000,
        switch: true,
        ..Board::in_state(FAULT)
    });
    let board = wire.talk(Diagnostics::read).unwrap();
    let trouble = board.trouble.unwrap();
    assert_eq!((trouble.number, trouble.line), (24, Some(70_000)));
    assert!(trouble.fault().is_some());
    assert!(board.is_switched_off());
}

#[test]
fn a_board_tells_the_version_of_its_stored_form() {
    let mut wire = Wire::new(Board::of_version(9, Board::default()));
    let told = wire.talk(Diagnostics::read).unwrap().program;
    assert_eq!(told, wire.board.kept);
    assert_eq!(told.version, 9);
    let here: Kept = kept("0\n877901\n");
    assert!(!told.differs(here), "nothing can be said of it");
}

#[test]
fn a_lock_holds_at_once_and_an_address_from_the_next_start() {
    let mut wire = Wire::new(Board::default());
    let old = wire.talk(Settings::read).unwrap();
    for (new, is_for_next) in [
        (
            Settings {
                lock: Some(lock::UPLOAD),
                ..old
            },
            false,
        ),
        (
            Settings {
                address: 9,
                lock: Some(lock::UPLOAD),
                ..old
            },
            true,
        ),
    ] {
        let settled = wire.talk(async |client| settle(client, new).await).unwrap();
        assert_eq!(settled.is_for_next, is_for_next, "{new:?}");
        assert_eq!(wire.talk(Settings::read), Ok(new));
    }
}

#[test]
fn settings_that_no_board_would_keep_are_not_sent() {
    let open = Settings {
        address: 1,
        rate: 9_600,
        parity: Parity::None,
        direction: false,
        lock: Some(0),
    };
    let with = |lock| Settings {
        lock: Some(lock),
        ..open
    };
    let slow = Settings { rate: 300, ..open };
    assert_eq!(may_settle(slow, open), Err(Unsettled::Rate(300)));
    let (less, more) = (with(lock::UPLOAD), with(lock::UPLOAD | lock::WRITING));
    assert_eq!(may_settle(less, more), Err(Unsettled::LockShrinks));
    let locked = with(lock::SETTINGS);
    assert_eq!(may_settle(locked, locked), Err(Unsettled::Locked));
    assert_eq!(may_settle(more, less), Ok(()));
}

#[test]
fn a_board_runs_again_after_settings_if_it_ran_before() {
    for (before, again, is) in [
        (Some(State::Run), Again::Runs, RUN),
        (Some(State::Stop), Again::WasNot, STOP),
        (None, Again::WasNot, STOP),
    ] {
        let mut wire = Wire::new(Board::in_state(STOP));
        let came = wire.talk(async |client| go_on(client, before).await);
        assert_eq!((came, wire.board.state), (Ok(again), is));
    }
}
