//! Random programs, and what runs them beside each other.

use super::writer::{MARKERS, POINTS, REGISTERS, Writer};
use unoclp_checked::Checked;
use unoclp_codegen::{CompiledText, compile};
use unoclp_core::{Board, Image, Inputs, Plc};
use unoclp_lang::run::Machine;
use unoclp_lang::typed::{Tree, Value};
use unoclp_lang::{Severity, TextLanguage, Told, compile_text};
use unoclp_testing::{Random, least, rounds};
use unoclp_text::diagnostics::Found;

const PROGRAMS: u32 = 1500;
const SCANS: u32 = 40;

pub(super) const LARGE: Board = Board {
    stored_bytes: 30_000,
    linked_bytes: 30_000,
    ..Board::UNO
};

/// The program of a tree, as if it were of this text.
pub(super) fn compiled_of(text: &str, tree: &Tree) -> CompiledText {
    compile(text, Some(tree.clone()).into(), LARGE, Found::default())
}

fn listing(lines: &[unoclp_lang::CodeLine]) -> String {
    let lines = lines.iter();
    lines
        .map(|line| format!("{} {}\n", line.code, line.letters))
        .collect()
}

/// What a program shows behind a scan: outputs, markers and registers.
type Shown = (u32, u128, [i32; POINTS as usize]);

fn shown(plc: &Plc<'_>) -> Shown {
    let registers = plc.registers().first_chunk().copied().unwrap();
    (plc.outputs().0 as u32 & 15, plc.markers() & 15, registers)
}

fn of_machine(machine: &Machine<'_>) -> Shown {
    let bits = |first: u32| {
        let bit = |at: u32| u32::from(machine.cell(first + at).is_true()) << at;
        (0..POINTS).map(bit).sum::<u32>()
    };
    let mut registers = [0; POINTS as usize];
    for (at, register) in (0..).zip(&mut registers) {
        *register = machine.cell(REGISTERS + at).int() as i32;
    }
    (bits(POINTS), bits(MARKERS).into(), registers)
}

/// The bytes of both, where they do the same.
///
/// # Errors
/// What differs.
fn compared(seed: u64) -> Result<(u16, u16), String> {
    let mut writer = Writer::new(seed);
    for _ in 0..3 + seed % 12 {
        writer.instruction();
    }
    writer.above();
    let (text, tree) = writer.finish();
    let older = compile_text(&text, TextLanguage::Il, LARGE);
    let made = compiled_of("", &tree);
    let told = |told: &Told| {
        let errors = told.iter().filter(|d| d.severity() == Severity::Error);
        errors
            .map(|d| d.message(unoclp_lang::Lang::En) + "\n")
            .collect::<String>()
    };
    let both = format!(
        "{text}\n{}\n{}",
        listing(&older.lines),
        listing(&made.lines)
    );
    let (Some((mut older, _)), Some((mut newer, _))) = (older.program, made.program) else {
        let (older, newer) = (told(&older.diagnostics), told(&made.diagnostics));
        return Err(format!("does not compile: {older}{newer}\n{both}"));
    };
    let bytes = |of: &mut Checked| of.program().stored_bytes() as u16;
    let sizes = (bytes(&mut older), bytes(&mut newer));
    let mut plcs = [Plc::new(older.lend()), Plc::new(newer.lend())];
    let mut machine = Machine::new(&tree);
    let mut random = Random(seed ^ 0x5EED);
    let (mut points, mut now) = (0, 0);
    for scan in 0..SCANS {
        for bit in 0..POINTS {
            if random.percent(35) {
                points ^= 1 << bit;
            }
            let on = points >> bit & 1 != 0;
            machine.set_cell(bit, Value::truth(on));
        }
        for plc in &mut plcs {
            let ran = plc.scan(Inputs::from(Image(points)), now);
            ran.map_err(|fault| format!("{fault:?}\n{both}"))?;
        }
        let ended = machine.scan(now.into());
        ended.map_err(|stop| format!("{stop:?}\n{both}"))?;
        let [before, behind] = [&plcs[0], &plcs[1]].map(shown);
        let on_pc = of_machine(&machine);
        if behind != on_pc || behind != before {
            let of = format!("older {before:?}\nnewer {behind:?}\non a PC {on_pc:?}");
            return Err(format!("seed {seed}, scan {scan}:\n{of}\n{both}"));
        }
        now += random.below(60) as u32;
    }
    match sizes.1 <= sizes.0 {
        true => Ok(sizes),
        false => Err(format!("seed {seed}: {sizes:?} bytes\n{both}")),
    }
}

#[test]
fn counters_and_timers_do_what_the_older_compiler_has_them_do() {
    let (mut wrong, mut sum) = (Vec::new(), (0_u32, 0_u32));
    for seed in 1..=u64::from(rounds(PROGRAMS)) {
        match compared(seed) {
            Ok((older, newer)) => sum = (sum.0 + u32::from(older), sum.1 + u32::from(newer)),
            Err(why) => wrong.push((why, seed)),
        }
    }
    wrong.sort_by_key(|(why, _)| why.len());
    println!("{} and {} bytes, {} differ", sum.0, sum.1, wrong.len());
    if let Some((shortest, seed)) = wrong.first() {
        let least = least(|| compared(*seed)).err();
        panic!("{}", least.as_ref().unwrap_or(shortest));
    }
}
