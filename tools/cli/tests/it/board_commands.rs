//! The commands that speak to a board: exit codes, messages and what the board gets.

use crate::portuguese::assert_portuguese;
use crate::pty::{Board, FAULT, Fake, Fate, RUN, STOP, kept};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

const FOLLOW: &str = "0\n787600\n827301\n877901\n";

/// A file for one test.
fn file(name: &str, content: &str) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, content).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Runs `unoclp` without a terminal: exit code, standard output and standard error.
fn unoclp(arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
    let output = command
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let code = output.status.code().unwrap();
    (code, text(output.stdout), text(output.stderr))
}

/// The command on this board.
fn on(fake: &Fake, arguments: &[&str]) -> (i32, String, String) {
    let port = ["--port", fake.path()];
    unoclp(&[arguments, &port].concat())
}

#[test]
fn an_upload_says_what_it_does() {
    let program = file("follow.txt", FOLLOW);
    let crc = kept(FOLLOW).sum;
    let fake = Fake::new(Board::default());
    let (code, out, err) = on(&fake, &["upload", &program]);
    let path = fake.path();
    let expected = format!(
        "unoclp UNO 0.1.0 at {path}, address 1\nSTOP\nstored: 3 bytes, checksum {crc:04X}\nRUN\n"
    );
    assert!(
        out.starts_with(&format!("{program}: OK: 4 codes, ")),
        "{out}"
    );
    assert!(out.ends_with(&expected), "{out}");
    assert_eq!((code, err.as_str()), (0, ""));
    assert_eq!(fake.board().text, FOLLOW.as_bytes());
    assert_eq!(fake.board().state, RUN);
}

/// The codes of a program, without what else stands in their lines.
fn codes(text: &str) -> Vec<&str> {
    let lines = text
        .lines()
        .map(|line| line.split('/').next().unwrap_or_default().trim());
    lines.filter(|code| !code.is_empty()).collect()
}

#[test]
fn every_language_is_uploaded_as_what_it_is_compiled_to() {
    for (name, text) in [
        ("sent.st", "VAR n : DINT; END_VAR\nn := n + 1;\n"),
        ("sent.scl", "VAR n : DINT; END_VAR\n#n := #n + 1;\n"),
        (
            "sent.iscl",
            "BLOCO INT n; n := n + 1; PRINT(n); END_BLOCK\n",
        ),
        ("sent.lce", "clp x\nV0 := V0 + 1;\nfim\n"),
        ("sent-st.txt", "VAR n : DINT; END_VAR\nn := n + 1;\n"),
    ] {
        let program = file(name, text);
        let (_, compiled, _) = unoclp(&["compile", &program]);
        let fake = Fake::new(Board::default());
        let (code, out, err) = on(&fake, &["upload", &program]);
        assert_eq!((code, err.as_str()), (0, ""), "{name}: {out}");
        assert!(out.ends_with("\nRUN\n"), "{name}: {out}");
        let sent = String::from_utf8(fake.board().text.clone()).unwrap();
        assert_eq!(codes(&sent), codes(&compiled), "{name}");
    }
    // Nothing is sent of what is wrong, nor of what the board cannot do.
    let fake = Fake::new(Board::default());
    for (name, text, told) in [
        (
            "wrong.st",
            "VAR n : DINT; END_VAR\nn := m;\n",
            "error[ST-130]",
        ),
        (
            "large.st",
            "VAR s : STRING; END_VAR\ns := 'a';\n",
            "error[ST-201]",
        ),
        ("wrong.iscl", "BLOCO INT n; n := m; END_BLOCK\n", "error["),
        ("wrong.lce", "5 := V0;\n", "error[LCE-403]"),
    ] {
        let (code, out, _) = on(&fake, &["upload", &file(name, text)]);
        assert!(code == 1 && out.starts_with(told), "{name}: {out}");
    }
    assert_eq!(fake.board().state, RUN);
    assert!(fake.board().text.is_empty());
}

#[test]
fn an_upload_to_a_board_with_another_stored_form_is_no_failure() {
    let program = file("form.txt", FOLLOW);
    for state in [STOP, FAULT] {
        let fake = Fake::new(Board::of_version(3, Board::in_state(state)));
        let (code, out, err) = on(&fake, &["upload", &program]);
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        let told = fake.board().kept.sum;
        assert_ne!(told, kept(FOLLOW).sum);
        let says = format!("stored: 3 bytes, checksum {told:04X}\nRUN\n");
        assert!(out.ends_with(&says), "{out}");
    }
}

#[test]
fn a_program_that_an_older_board_does_not_know_is_not_sent() {
    let program = file("newer.txt", "0\n827301\n7370\n877901\n697868\n");
    let fake = Fake::new(Board::of_version(1, Board::default()));
    let (code, out, err) = on(&fake, &["upload", &program]);
    assert!(code == 2 && !out.contains("STOP"), "{out}{err}");
    assert!(
        err.contains("stores programs in form 1") && err.contains("needs form 2"),
        "{err}"
    );
    assert_eq!(fake.board().state, RUN);
    // What it knows is sent.
    let program = file("older.txt", FOLLOW);
    assert_eq!(on(&fake, &["upload", &program]).0, 0);
}

#[test]
fn an_upload_ends_as_the_board_lets_it() {
    let program = file("ends.txt", FOLLOW);
    let switched = Board {
        switch: true,
        ..Board::in_state(STOP)
    };
    let faulty = Board {
        fault: 62,
        ..Board::in_state(FAULT)
    };
    for (board, more, says, state) in [
        (Board::default(), &["--stop"][..], "\nin STOP\n", STOP),
        (
            switched,
            &[],
            "in STOP until the STOP switch is opened\n",
            STOP,
        ),
        (faulty, &[], "RUN\n", RUN),
    ] {
        let fake = Fake::new(board);
        let (code, out, err) = on(&fake, &[&["upload", &program], more].concat());
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        assert!(out.ends_with(says), "{out}");
        assert_eq!(fake.board().state, state);
    }
}

#[test]
fn a_fault_that_the_board_finds_is_shown_as_check_does() {
    let program = file("differs.txt", FOLLOW);
    let fake = Fake::new(Board {
        second_differs: true,
        ..Board::default()
    });
    let (code, out, err) = on(&fake, &["upload", &program]);
    assert_eq!((code, err.as_str()), (1, ""));
    let says = "the board rejects the program and keeps the old one:\nerror[57]: ";
    assert!(out.contains(says), "{out}");
    assert_eq!(fake.board().state, STOP, "it does not run");
}

#[test]
fn a_program_with_a_fault_does_not_reach_the_board() {
    let program = file("faulty-upload.txt", "0\n827333\n");
    for command in ["upload", "monitor"] {
        let (code, out, err) = unoclp(&[command, &program, "--port", "/dev/no-such-port"]);
        assert_eq!((code, err.as_str()), (1, ""));
        assert!(
            out.starts_with("error[25]: this board has no such input\n"),
            "{out}"
        );
    }
}

#[test]
fn a_card_with_another_program_has_the_last_word() {
    let program = file("board-card.txt", FOLLOW);
    let fake = Fake::new(Board {
        card: Some(b"0\n877901\n".to_vec()),
        ..Board::in_state(FAULT)
    });
    let (code, _, err) = on(&fake, &["upload", &program]);
    assert_eq!(code, 2);
    assert!(err.contains("it loaded another PROGRAM.TXT"), "{err}");
}

#[test]
fn settings_are_shown_and_set() {
    let fake = Fake::new(Board::default());
    let (code, out, _) = on(&fake, &["settings"]);
    let shown = "\naddress 1, 115200 baud, no parity, direction pin off, nothing locked\n";
    assert_eq!(code, 0);
    assert!(out.ends_with(shown), "{out}");
    let board = fake.board();
    assert_eq!((board.restarts, board.state), (0, RUN));
}

#[test]
fn new_settings_are_kept_and_used() {
    let fake = Fake::new(Board::default());
    let set = ["settings", "--set-address", "7", "--set-rate", "9600"];
    let more = ["--set-parity", "even", "--set-direction", "on"];
    let (code, out, err) = on(&fake, &[&set[..], &more].concat());
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let says = "address 7, 9600 baud, even parity, direction pin on, nothing locked; restarting\n\
        the board answers: address 7 at 9600 baud, even parity\n";
    assert!(out.ends_with(says), "{out}");
    let board = fake.board();
    assert_eq!(board.settings, [7, 96, 1, 1, 0]);
    assert_eq!((board.restarts, board.state), (1, RUN));
}

#[test]
fn settings_that_are_not_kept_are_no_success() {
    let fake = Fake::new(Board {
        eeprom_fails: true,
        ..Board::default()
    });
    let (code, _, err) = on(&fake, &["settings", "--set-address", "7"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("the board could not store the settings"),
        "{err}"
    );
    let board = fake.board();
    assert_eq!((board.restarts, board.state), (0, RUN));
}

/// What is said after the settings that the board had.
fn said_of_settings(fake: &Fake, more: &[&str]) -> String {
    let (code, out, err) = on(fake, &[&["settings"], more].concat());
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    out.lines()
        .skip(2)
        .map(|line| format!("{line}\n"))
        .collect()
}

const TO_UNLOCK: &str = "; to unlock, reset the board with the STOP pin (A5 on a UNO) and inputs 01 to 04 connected to GND, then write any \
                         setting\n";

#[test]
fn a_lock_grows_and_needs_no_restart() {
    let fake = Fake::new(Board::default());
    let says = format!("now locked: upload, writing{TO_UNLOCK}RUN\n");
    assert_eq!(said_of_settings(&fake, &["--lock", "writing,upload"]), says);
    // What is locked already, in RUN, is nothing to do.
    assert_eq!(said_of_settings(&fake, &["--lock", "upload"]), "");
    let (_, out, _) = on(&fake, &["settings"]);
    assert!(out.ends_with("pin off, locked: upload, writing\n"), "{out}");
    let says = format!("now locked: upload, settings, writing{TO_UNLOCK}RUN\n");
    assert_eq!(said_of_settings(&fake, &["--lock", "settings"]), says);
    {
        let board = fake.board();
        assert_eq!(board.settings, [1, 1152, 0, 0, 0b1011]);
        assert_eq!((board.restarts, board.state), (0, RUN));
    }
    // Then nothing more is set, and the board is not stopped for it.
    let (code, _, err) = on(&fake, &["settings", "--lock", "all"]);
    let says = format!("error: the settings of the board are locked{TO_UNLOCK}");
    assert_eq!((code, err), (2, says));
    let board = fake.board();
    assert!(board.state == RUN && !board.stopped);
}

#[test]
fn a_lock_leaves_a_board_in_stop_or_fault_where_it_was() {
    for state in [STOP, FAULT] {
        let fake = Fake::new(Board::in_state(state));
        let says = format!("now locked: commands{TO_UNLOCK}");
        assert_eq!(said_of_settings(&fake, &["--lock", "commands"]), says);
        let board = fake.board();
        assert_eq!((board.restarts, board.state), (0, state));
    }
}

#[test]
fn behind_a_lock_of_commands_a_reset_is_asked_for() {
    let fake = Fake::new(Board::default());
    let all = "now locked: upload, settings, commands, writing";
    let says = format!(
        "{all}{TO_UNLOCK}in STOP: commands are locked, so only a reset brings the board back to RUN\n"
    );
    assert_eq!(said_of_settings(&fake, &["--lock", "all"]), says);
    assert_eq!(fake.board().state, STOP);

    let fake = Fake::new(Board::default());
    let says = format!(
        "now locked: commands{TO_UNLOCK}\
         address 1, 9600 baud, no parity, direction pin off, locked: commands\n\
         commands are locked: reset the board to apply these settings\n"
    );
    let set = ["--set-rate", "9600", "--lock", "commands"];
    assert_eq!(said_of_settings(&fake, &set), says);
    let board = fake.board();
    assert_eq!((board.settings, board.restarts), ([1, 96, 0, 0, 4], 0));
}

#[test]
fn another_address_and_a_lock_are_used_from_a_restart_on() {
    let fake = Fake::new(Board::default());
    let says = format!(
        "now locked: upload{TO_UNLOCK}\
         address 7, 115200 baud, no parity, direction pin off, locked: upload; restarting\n\
         the board answers: address 7 at 115200 baud, no parity\n"
    );
    let set = ["--set-address", "7", "--lock", "upload"];
    assert_eq!(said_of_settings(&fake, &set), says);
    let board = fake.board();
    assert_eq!(
        (board.settings[4], board.restarts, board.state),
        (1, 1, RUN)
    );
}

#[test]
fn a_board_without_a_lock_is_not_stopped_for_one() {
    let fake = Fake::new(Board {
        is_of_version_1: true,
        ..Board::default()
    });
    let (code, out, err) = on(&fake, &["settings", "--lock", "upload"]);
    let says = "error: the board has no lock; install newer firmware\n";
    assert_eq!((code, err.as_str()), (2, says));
    assert!(out.ends_with(", direction pin off\n"), "{out}");
    assert!(!fake.board().stopped);
    // Its settings are set as ever.
    let says = "address 7, 115200 baud, no parity, direction pin off; restarting\n\
                the board answers: address 7 at 115200 baud, no parity\n";
    assert_eq!(said_of_settings(&fake, &["--set-address", "7"]), says);
}

/// The defaults stand in the place of what is kept, and writing one of them keeps them: so a lock is lifted.
#[test]
fn defaults_that_the_pins_have_brought_back_are_kept_by_setting_one() {
    let defaults = || Board {
        has_defaults: true,
        switch: true,
        ..Board::in_state(STOP)
    };
    let fake = Fake::new(defaults());
    assert_eq!(said_of_settings(&fake, &[]), "");
    assert!(fake.board().has_defaults, "nothing was set");
    let says = "the board keeps these settings\n";
    assert_eq!(said_of_settings(&fake, &["--set-address", "1"]), says);
    let board = fake.board();
    assert_eq!((board.has_defaults, board.restarts), (false, 0));
}

#[test]
fn settings_that_change_too_often_are_refused_and_the_board_runs_on() {
    let fake = Fake::new(Board {
        changes_left: 0,
        ..Board::default()
    });
    let (code, out, err) = on(&fake, &["settings", "--set-address", "7"]);
    let says = "error: the board rejected the settings: the board is busy; if it has stored settings or programs too \
                often, try again in an hour, or after a power cycle\n";
    assert_eq!((code, err.as_str()), (2, says));
    assert!(out.ends_with("nothing locked\nRUN\n"), "{out}");
    assert_eq!(fake.board().state, RUN);
}

#[test]
fn a_locked_board_is_not_stopped_for_an_upload() {
    let program = file("locked.txt", FOLLOW);
    let fake = Fake::new(locked(0b1));
    let (code, _, err) = on(&fake, &["upload", &program]);
    let says = format!("error: uploads are locked on this board{TO_UNLOCK}");
    assert_eq!((code, err), (2, says));
    assert!(fake.board().state == RUN && !fake.board().stopped);
}

#[test]
fn a_board_whose_commands_are_locked_is_stopped_by_a5_only() {
    let program = file("commands.txt", FOLLOW);
    for command in [
        &["upload", &program][..],
        &["settings", "--set-address", "7"],
    ] {
        let fake = Fake::new(locked(0b100));
        let (code, _, err) = on(&fake, command);
        let says = "error: commands are locked, so only the STOP pin can stop the board: connect it to GND (A5 on a UNO) and try again\n";
        assert_eq!((code, err.as_str()), (2, says));
    }
    let fake = Fake::new(Board {
        state: STOP,
        switch: true,
        ..locked(0b100)
    });
    let (code, out, err) = on(&fake, &["upload", &program]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let says = "in STOP until the STOP switch is opened\n";
    assert!(out.ends_with(says), "{out}");

    let fake = Fake::new(Board {
        state: STOP,
        ..locked(0b100)
    });
    let (code, _, err) = on(&fake, &["upload", &program]);
    let says = "error: the program is stored, but the board does not start it: \
                this operation is locked on the board\n";
    assert_eq!((code, err.as_str()), (2, says));
}

#[test]
fn what_cannot_be_done_is_exit_code_2_and_says_what_to_do() {
    let program = file("nobody.txt", FOLLOW);
    let port = ["--port", "/dev/no-such-port"];
    let missing = "error: there is no port /dev/no-such-port; this PC has ";
    #[rustfmt::skip]
    let cases: &[(&[&str], &str)] = &[
        (&["upload"], "error: the following required arguments were not provided:"),
        (&["monitor"], "error: the following required arguments were not provided:"),
        (&["settings"], "error: the following required arguments were not provided:"),
        (&["upload", &program], "error: the following required arguments were not provided:"),
        (&["upload", "no-such.txt", port[0], port[1]], "error: no-such.txt cannot be read ("),
        (&["monitor", "no-such.txt", port[0], port[1]], "error: no-such.txt cannot be read ("),
        (&["upload", &program, port[0], port[1]], missing),
        (&["settings", port[0], port[1]], missing),
        (&["monitor", port[0], port[1]], "error: the monitor needs a terminal"),
        (&["settings", port[0], port[1], "--set-rate", "1234"], "error: the board does not support 1234 baud; it supports 2400, "),
        (&["settings", port[0], port[1], "--address", "0"], "error: invalid value '0' for '--address"),
        (&["monitor", port[0], port[1], "--end-forcing", "0"], "error: invalid value '0' for '--end-forcing <SECONDS>': 0 is not in 1..=254"),
        (&["monitor", port[0], port[1], "--end-forcing", "255"], "error: invalid value '255' for '--end-forcing <SECONDS>'"),
        (&["settings", port[0], port[1], "--lock", "upload,x"], "error: invalid value 'x' for '--lock <WHAT>'"),
        (&["settings", port[0], port[1], "--set-address", "248"], "error: invalid value '248' for '--set-address"),
    ];
    for (arguments, message) in cases {
        let (code, _, err) = unoclp(arguments);
        assert_eq!(code, 2, "{arguments:?}");
        assert!(err.starts_with(message), "{arguments:?}: {err}");
    }
}

#[test]
fn a_board_that_fails_in_its_first_second_is_not_said_to_run() {
    let program = file("fails.il", "(* waits *)\nagain:\nLD I1\nST Q1\nJMP again\n");
    let (_, code, _) = unoclp(&["compile", &program]);
    let jump = code.lines().position(|line| line.contains("JMP")).unwrap();
    let fake = Fake::new(Board {
        fault_in_run: Some((75, jump as u32 + 1)),
        ..Board::default()
    });
    let (code, out, err) = on(&fake, &["upload", &program]);
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    let says = format!(
        "in FAULT, within the first 1000 ms of scanning:\n\
         {program}:5: fault 75: too many backward jumps in one scan (NC-19)\n  JMP again\n"
    );
    assert!(out.ends_with(&says), "{out}");
    assert!(!out.contains("\nRUN\n"), "{out}");
}

/// A board in RUN with this lock.
fn locked(lock: u16) -> Board {
    Board {
        settings: [1, 1152, 0, 0, lock],
        ..Board::default()
    }
}

#[test]
fn a_board_is_told_of_in_portuguese() {
    let program = file("placa.txt", FOLLOW);
    let upload: &[&str] = &["upload", &program];
    let settings: &[&str] = &["settings", "--set-address", "7", "--set-parity", "odd"];
    let faulty = |fault| Board {
        fault,
        line: 7,
        ..Board::in_state(FAULT)
    };
    let switched = Board {
        switch: true,
        ..Board::in_state(STOP)
    };
    let differs = Board {
        second_differs: true,
        forces: [0b1, 0b1, 0b10, 0, 0],
        ..Board::default()
    };
    let failing = Board {
        fault_in_run: Some((75, 3)),
        ..Board::default()
    };
    let unreliable = Board {
        eeprom_fails: true,
        ..Board::default()
    };
    let worn = Board {
        changes_left: 0,
        ..Board::default()
    };
    let card = Board {
        card: Some(b"0\n877901\n".to_vec()),
        ..faulty(62)
    };
    for (board, command, says) in [
        (Board::default(), upload, " em /dev/"),
        (
            Board::default(),
            settings,
            "endereço 7, 115200 baud, paridade ímpar, pino de direção inativo, nada bloqueado; reiniciando\n",
        ),
        (
            Board::default(),
            settings,
            "a placa responde: endereço 7 a 115200 baud, paridade ímpar\n",
        ),
        (
            unreliable,
            settings,
            "a placa não conseguiu guardar os ajustes: a EEPROM dela está falhando",
        ),
        (
            faulty(24),
            upload,
            "em FAULT, falha 24, linha 7: código inexistente\n",
        ),
        (
            faulty(99),
            upload,
            "falha 99, linha 7: desconhecida por esta versão do unoclp\n",
        ),
        (switched, upload, "em STOP até a chave STOP ser aberta"),
        (
            differs,
            upload,
            "a placa recusa o programa e mantém o antigo:\nerro[57]",
        ),
        (
            Board::default(),
            &["settings", "--lock", "all"],
            "agora bloqueado: envio, ajustes, comandos, escrita; para desbloquear, faça o reset com o pino STOP",
        ),
        (
            Board::default(),
            &["settings", "--lock", "commands", "--set-rate", "9600"],
            "os comandos estão bloqueados: faça o reset da placa para ela usar esses ajustes\n",
        ),
        (
            locked(0b10),
            settings,
            "erro: os ajustes da placa estão bloqueados; para desbloquear",
        ),
        (
            locked(0b1),
            upload,
            "erro: os envios estão bloqueados nesta placa; para desbloquear",
        ),
        (
            locked(0b100),
            upload,
            "erro: os comandos estão bloqueados; só o pino STOP pode parar a placa",
        ),
        (
            worn,
            settings,
            "se gravou ajustes ou programas vezes demais, tente de novo",
        ),
        (failing, upload, "falha 75: desvios demais para trás"),
        (card, upload, "leu outro PROGRAM.TXT"),
    ] {
        let fake = Fake::new(board);
        let (_, out, err) = on(&fake, &[command, &["--lang", "pt"]].concat());
        let said = out + &err;
        assert!(said.contains(says), "{says}\n{said}");
        assert_portuguese(&said);
    }
    let gone = Fake::with(Board::default(), |_, _| Fate::Unplugged);
    assert_portuguese(&on(&gone, &["settings", "--lang", "pt"]).2);
}

#[test]
fn an_upload_lets_go_what_is_forced_unless_it_is_told_not_to() {
    let program = file("forced.txt", FOLLOW);
    let forced = || Board {
        forces: [0b1, 0b1, 0b10, 0, 0],
        ..Board::default()
    };
    let fake = Fake::new(forced());
    let (code, out, _) = on(&fake, &["upload", &program]);
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("\nforced: I1=1 Q2=0\n"), "{out}");
    assert!(
        out.ends_with("\nno longer forced: I1=1 Q2=0\nRUN\n"),
        "{out}"
    );
    assert_eq!(fake.board().forces, [0; 5]);

    let fake = Fake::new(forced());
    let (_, out, _) = on(&fake, &["upload", &program, "--keep-forces"]);
    assert!(out.contains("RUN\nstill forced: I1=1 Q2=0; "), "{out}");
    assert_eq!(fake.board().forces, forced().forces);

    let fake = Fake::new(Board {
        forces: [1, 1, 2, 0, 30],
        ..Board::default()
    });
    let (_, out, _) = on(&fake, &["upload", &program, "--keep-forces"]);
    let says =
        "RUN\nstill forced: I1=1 Q2=0; the board releases them 30 s after the last request. ";
    assert!(out.contains(says), "{out}");

    // What is refused changes nothing, and says so.
    let fake = Fake::new(Board {
        second_differs: true,
        ..forced()
    });
    let (_, out, _) = on(&fake, &["upload", &program]);
    assert!(out.contains("\nstill forced: I1=1 Q2=0; "), "{out}");
}

#[test]
fn an_upload_that_is_interrupted_ends_in_order() {
    let program = file(
        "interrupted.txt",
        &format!("{FOLLOW}/{}\n", "x".repeat(4_000)),
    );
    let begun = Arc::new(AtomicBool::new(false));
    let seen = begun.clone();
    // The board holds the second block until Ctrl-C has come.
    let fake = Fake::with(Board::default(), move |board, _| {
        match board.is_uploading() && !seen.swap(true, Ordering::SeqCst) {
            true => Fate::Lost,
            false => Fate::Answered,
        }
    });
    let child = Command::new(env!("CARGO_BIN_EXE_unoclp"))
        .args(["upload", &program, "--port", fake.path()])
        .env("LC_ALL", "C")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while !begun.load(Ordering::SeqCst) {
        std::thread::yield_now();
    }
    let pid = rustix::process::Pid::from_child(&child);
    rustix::process::kill_process(pid, rustix::process::Signal::INT).unwrap();
    let output = child.wait_with_output().unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{err}");
    let says = "error: interrupted; the board is in STOP and keeps its old program\n";
    assert_eq!(err, says);
    let board = fake.board();
    assert!(!board.is_uploading() && board.state == STOP);
}
