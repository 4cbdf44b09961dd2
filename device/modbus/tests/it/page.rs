//! `docs/modbus.md` says what the map says, row by row.

use unoclp_core::Board;
use unoclp_modbus::eeprom::program::{VERSION, head};
use unoclp_modbus::map::{
    ALL, BLOCK_BYTES, Command, MEGA, NANO, PRODUCT, Rights, Span, State, VENDOR, Width, cause,
    coil, flag, form, holding, input, setting,
};
use unoclp_modbus::{Exception, Table, map};

const PAGE: &str = include_str!("../../../../docs/modbus.md");
const TRANSLATION: &str = include_str!("../../../../docs/modbus.pt-BR.md");

/// The rows of the tables under this heading, cell by cell, without their heads.
fn rows(heading: &str) -> Vec<Vec<String>> {
    rows_of(PAGE, heading)
}

/// The same of a page.
fn rows_of(page: &str, heading: &str) -> Vec<Vec<String>> {
    let section = page.split(&format!("\n## {heading}\n")).nth(1).unwrap();
    let section = section.split("\n## ").next().unwrap();
    let rows = section.lines().filter(|line| line.starts_with('|'));
    let cells = |row: &str| -> Vec<String> {
        let row = row.trim().trim_start_matches('|').trim_end_matches('|');
        row.split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    let rows = rows.map(cells);
    rows.filter(|row| row[0].starts_with(|first: char| first.is_ascii_digit()))
        .collect()
}

/// The row that begins with this cell.
fn row(heading: &str, first: &str) -> Vec<String> {
    let found = rows(heading).into_iter().find(|row| row[0] == first);
    found.unwrap_or_else(|| panic!("{heading} has no {first}"))
}

/// Addresses as the page shows them: `16`, `20, 21`, `0–4`.
fn addresses(span: Span) -> String {
    let all: Vec<_> = (span.first..span.end()).map(|at| at.to_string()).collect();
    match &all[..] {
        [first, _, _, .., last] if all.len() > 3 => format!("{first}–{last}"),
        all => all.join(", "),
    }
}

const TABLES: [(&str, &[Table]); 3] = [
    (
        "Coils and discrete inputs",
        &[Table::Coils, Table::DiscreteInputs],
    ),
    ("Input registers", &[Table::InputRegisters]),
    ("Holding registers", &[Table::HoldingRegisters]),
];

#[test]
fn the_page_has_every_address_and_no_other() {
    for (heading, tables) in TABLES {
        let spans = tables.iter().flat_map(|table| {
            let spans = ALL.iter().filter(move |span| span.table == *table);
            spans.copied()
        });
        let spans: Vec<Span> = spans.collect();
        let rows = rows(heading);
        let told: Vec<_> = rows.iter().map(|row| row[0].clone()).collect();
        let here: Vec<_> = spans.iter().map(|&span| addresses(span)).collect();
        assert_eq!(told, here, "{heading}");
        for (row, span) in rows.iter().zip(spans) {
            assert!(row[1].starts_with(span.name), "{row:?} is not {span:?}");
            let long = row.iter().any(|cell| cell.contains("32 bits"));
            assert_eq!(long, span.width == Width::Long, "{row:?}");
        }
    }
}

/// What a Mega has that an UNO has not, or more of.
#[test]
fn the_page_has_what_a_mega_has_more() {
    let more = map::of(&Board::MEGA).filter(|span| !ALL.contains(span));
    let here: Vec<_> = more.map(|span| (span.table, addresses(span))).collect();
    let rows = rows("The Arduino Mega 2560");
    for (table, addresses) in here {
        let name = match table {
            Table::Coils => "coils",
            Table::DiscreteInputs => "discrete inputs",
            Table::InputRegisters => "input registers",
            Table::HoldingRegisters => "holding registers",
        };
        let is_there = rows.iter().any(|row| row[0] == addresses && row[1] == name);
        assert!(is_there, "{name} {addresses}: {rows:?}");
    }
    // All else is the UNO's, where it was.
    for span in ALL {
        let same = map::of(&Board::MEGA)
            .find(|other| other.name == span.name && other.first == span.first);
        let same = same.unwrap();
        assert!(
            same.addresses() >= span.addresses() && same.table == span.table,
            "{span:?}"
        );
    }
    assert!(map::of(&Board::UNO).eq(ALL.iter().copied()));
}

/// Its headings, and their translations.
const TRANSLATED: [(&str, &str); 8] = [
    ("The Arduino Mega 2560", "O Arduino Mega 2560"),
    ("Coils and discrete inputs", "Bobinas e entradas discretas"),
    ("Input registers", "Registradores de entrada"),
    ("Holding registers", "Registradores de retenção"),
    ("Exceptions", "Exceções"),
    ("RUN, STOP and commands", "RUN, STOP e comandos"),
    ("Settings", "Ajustes"),
    ("The lock", "O bloqueio"),
];

/// The translation has the same addresses, commands, exceptions, settings and bits, with the same numbers.
#[test]
fn the_translation_has_the_same_rows() {
    for (heading, translated) in TRANSLATED {
        let (rows, translations) = (rows(heading), rows_of(TRANSLATION, translated));
        let first = |rows: &[Vec<String>]| -> Vec<String> {
            rows.iter().map(|row| row[0].clone()).collect()
        };
        assert_eq!(first(&rows), first(&translations), "{heading}");
        for (row, translation) in rows.iter().zip(&translations) {
            let numbers = |row: &[String]| -> Vec<String> {
                let text = row.join(" ").replace([',', '.'], "");
                let parts = text.split(|c: char| !c.is_ascii_digit());
                let mut numbers: Vec<_> = parts.map(str::to_owned).collect();
                numbers.retain(|number| !number.is_empty());
                numbers.sort_unstable();
                numbers
            };
            assert_eq!(
                numbers(row),
                numbers(translation),
                "{row:?}\n{translation:?}"
            );
        }
    }
}

#[test]
fn spans_are_in_order_and_apart() {
    for pair in ALL.windows(2) {
        let [before, after] = pair else {
            unreachable!("windows of two")
        };
        assert!(
            before.table != after.table || before.end() <= after.first,
            "{before:?} {after:?}"
        );
    }
    for span in ALL {
        let bits = matches!(span.table, Table::Coils | Table::DiscreteInputs);
        assert_eq!(bits, span.width == Width::Bit, "{span:?}");
        assert!(
            span.width != Width::Long || span.first % 2 == 0,
            "{span:?} would be torn"
        );
        let read_only = matches!(span.table, Table::DiscreteInputs | Table::InputRegisters);
        assert_eq!(read_only, span.rights == Rights::Read, "{span:?}");
    }
    // One request reads the diagnostics.
    let diagnostics = ALL.iter().filter(|span| {
        span.table == Table::InputRegisters
            && (input::STATE.first..input::FAULTS.end()).contains(&span.first)
    });
    let count: u16 = diagnostics.map(|span| span.addresses()).sum();
    assert_eq!(count, input::FAULTS.end() - input::STATE.first);
}

#[test]
fn the_page_has_the_states_bits_and_causes() {
    let cell = |span: Span| row("Input registers", &addresses(span))[2].clone();
    let states: Vec<_> = [State::Run, State::Stop, State::Fault]
        .into_iter()
        .map(|state| {
            assert_eq!(State::of(state as u16), Some(state));
            format!("{} {}", state as u8, state.name())
        })
        .collect();
    assert_eq!(cell(input::STATE), states.join(", "));
    assert_eq!((State::of(0), State::of(4)), (None, None));

    let bits = cell(input::FLAGS);
    let flags = [
        (flag::STOP_SWITCH, "A5 is connected to GND"),
        (flag::STOPPED, "STOP by command"),
        (flag::FORCED, "something is forced"),
        (flag::UPLOAD, "an upload is in progress"),
        (flag::CARD_FAILED, "the card failed"),
    ];
    for (flag, text) in flags {
        let bit = flag.trailing_zeros();
        assert!(bits.contains(&format!("{bit}: {text}")), "{bits}");
    }
    let lowest = form::bits(2).trailing_zeros();
    assert!(bits.contains(&format!("{lowest}–15: ")), "{bits}");
    assert!(flags.iter().all(|(flag, _)| *flag < 1 << lowest));

    let causes: Vec<_> = (1..=5)
        .map(|word| format!("{word} {}", cause(word)))
        .collect();
    assert_eq!(cell(input::CAUSE), causes.join(", "));
    assert_eq!((cause(0), cause(6)), ("unknown", "unknown"));
}

#[test]
fn the_page_has_the_commands_and_exceptions() {
    let commands: Vec<_> = [
        (Command::Run, "RUN"),
        (Command::Stop, "STOP"),
        (Command::SingleScan, "a single scan"),
        (Command::Restart, "restart"),
        (Command::Upload, "begin an upload"),
    ]
    .map(|(command, text)| (command as u8, text))
    .into();
    let told = rows("RUN, STOP and commands");
    assert_eq!(told.len(), commands.len());
    for (row, (number, text)) in told.iter().zip(commands) {
        assert_eq!(row[0], number.to_string());
        let command = Command::of(number.into());
        assert_eq!(command.map(|command| command as u8), Some(number));
        assert!(row[1].starts_with(text), "{row:?}");
    }
    assert_eq!((Command::of(0), Command::of(6)), (None, None));
    for row in rows("Exceptions") {
        let code = row[0].parse().unwrap();
        assert_eq!(Exception::of(code).map(|known| known as u8), Some(code));
    }
}

#[test]
fn the_page_has_the_settings() {
    let told = rows("Settings");
    assert_eq!(told.len(), setting::ALL.len());
    let registers = holding::SETTINGS.first..holding::SETTINGS.end();
    for ((row, setting), register) in told.iter().zip(setting::ALL).zip(registers) {
        assert_eq!(row[0], register.to_string());
        assert!(row[1].starts_with(setting.name), "{row:?}");
        assert_eq!(row[2], setting.default.to_string());
        assert_eq!(row[3], format!("{}–{}", setting.least, setting.most));
        assert!((setting.least..=setting.most).contains(&setting.default));
    }
}

#[test]
fn the_page_has_the_window_and_the_stored_form() {
    assert!(PAGE.contains(&format!("1 to {BLOCK_BYTES}; the text follows")));
    let window = row("Holding registers", &addresses(holding::UPLOAD));
    let only = format!(
        "only with function 16, and only starting at register {}",
        holding::UPLOAD.first
    );
    assert!(window[1].contains(&only), "{window:?}");

    let products = format!("product `{PRODUCT}`, `{NANO}` or `{MEGA}`");
    assert!(PAGE.contains(&format!("vendor `{VENDOR}`, {products}")));

    let sum = &row("Input registers", &addresses(input::PROGRAM_SUM))[2];
    let bytes = input::PROGRAM_BYTES.first;
    let of = format!("of {VERSION}, register {bytes} (low byte first), 0, 0 and the stored form");
    assert!(sum.contains(&of), "{sum}");
    assert_eq!(head(0x0203), [VERSION, 3, 2, 0, 0]);
}

#[test]
fn a_version_of_the_stored_form_is_told_in_the_bits() {
    assert_eq!(form::bits(1), 0, "which older firmware tells");
    for version in 0..=u8::MAX {
        let flags = form::bits(version) | flag::FORCED | flag::STOPPED;
        assert_eq!(form::version(flags), version);
    }
}

#[test]
fn what_exists_is_what_the_spans_say() {
    use unoclp_modbus::map::has;
    for span in ALL {
        let is_there = span.rights.has_addresses();
        assert_eq!(has(span.table, span.first, span.addresses()), is_there);
        assert!(
            !has(span.table, span.end(), 1)
                || ALL
                    .iter()
                    .any(|other| { other.table == span.table && other.first == span.end() })
        );
    }
    let (coils, inputs) = (coil::OUTPUTS.table, input::STATE.table);
    assert!(has(inputs, 16, 17) && !has(inputs, 15, 2) && !has(inputs, 32, 2));
    assert!(!has(coils, 3, 2) && !has(coils, u16::MAX, 2) && has(coils, 79, 1));
}
