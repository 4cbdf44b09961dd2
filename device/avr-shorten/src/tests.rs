//! Each rule on the cases of its file in `cases/`: `== what`, functions, `=>`, what becomes of them. Where
//! nothing may change it says `unchanged`. What has changed must still do the same when it runs.

use super::assembly::{Code, Function, Item, Line, Unit, body_of};
use super::equivalence::{Difference, Pair};
use super::machine::Program;
use super::saves::routine;
use super::{copies, decide, jumps, parts, reach, saves, tails};

/// The functions of a text. A label that is not local begins the next one, but for that of the scan and the
/// entries of the shared routines.
fn unit(text: &str) -> Unit {
    let mut functions: Vec<(String, Vec<&str>)> = Vec::new();
    for line in text.lines().filter(|line| !line.trim().is_empty()) {
        let entry = |name: &str| name.starts_with("__") && name.contains("_r");
        let begins = |name: &&str| !name.starts_with(".L") && *name != "scan_begin" && !entry(name);
        match line.trim().strip_suffix(':').filter(begins) {
            Some(name) => functions.push((name.to_owned(), Vec::new())),
            None => functions.last_mut().expect("a function").1.push(line),
        }
    }
    let functions = functions.into_iter().map(|(name, lines)| {
        let body = body_of(&lines).expect("a body");
        Item::Function(routine(&name, body))
    });
    Unit {
        items: functions.collect(),
    }
}

/// The functions of a unit, as in the files.
fn text(unit: &Unit) -> String {
    let lines = |function: &Function| {
        let body = function
            .body
            .iter()
            .filter(|line| !matches!(line, Line::Other(_)));
        let body = body.map(|line| match line {
            Line::Label(_) => format!("{line}\n"),
            _ => format!("        {}\n", line.to_string().trim().replace('\t', " ")),
        });
        format!("{}:\n{}", function.name, body.collect::<String>())
    };
    unit.functions().map(lines).collect()
}

fn check(file: &str, rule: impl Fn(&mut Unit)) {
    let mut cases = 0;
    for case in file.split("\n== ").skip(1) {
        let (what, case) = case.split_once('\n').expect("a title");
        let (before, after) = case.split_once("=>").expect("an arrow");
        let before = unit(before);
        let mut changed = before.clone();
        rule(&mut changed);
        let expected = match after.trim() {
            "unchanged" => text(&before),
            _ => text(&unit(after)),
        };
        assert_eq!(text(&changed), expected, "{what}");
        if let Some(difference) = difference(&before, &changed) {
            panic!("{what}: {difference}");
        }
        cases += 1;
    }
    assert!(cases > 0);
}

/// Runs each function before and after, many times. Says what was different first.
fn difference(before: &Unit, after: &Unit) -> Option<Difference> {
    let program = |unit| Program::new(unit).unwrap_or_else(|error| panic!("{error}"));
    let mut pair = Pair::of_fragments(program(before), program(after));
    let explore = |function: &Function| pair.explore(&function.name, 200).err();
    before.functions().find_map(explore)
}

/// A unit with a change that a rule might make by mistake, as long as it can make one.
fn with_mistake(unit: &Unit, mistake: impl Fn(&mut Vec<Line>)) -> Unit {
    let mut wrong = unit.clone();
    wrong.functions_mut().for_each(|f| mistake(&mut f.body));
    wrong
}

/// Mistakes, each with code that shows it.
#[test]
fn a_rule_that_is_wrong_is_caught() {
    let drop = |name: &'static str| {
        move |body: &mut Vec<Line>| {
            let at = body
                .iter()
                .position(|line| line.instruction().is_some_and(|c| c.name == name));
            body.remove(at.expect(name));
        }
    };
    let replace = |old: &'static str, new: &'static str| {
        move |body: &mut Vec<Line>| {
            let at = body.iter().position(|line| *line == Line::code(old));
            body[at.expect(old)] = Line::code(new);
        }
    };
    type Mistake = Box<dyn Fn(&mut Vec<Line>)>;
    let cases: [(&str, &str, Mistake); 13] = [
        (
            "a comparison whose carry is needed",
            "f:\n andi r24, 32\n cpi r24, 0\n cpc r25, r1\n breq .L1\n call g\n.L1:\n nop\n ret",
            Box::new(drop("cpi")),
        ),
        (
            "the other condition",
            "f:\n tst r24\n breq .L1\n call g\n.L1:\n nop\n ret",
            Box::new(replace("breq .L1", "brne .L1")),
        ),
        (
            "a condition that differs at a borrow only",
            "f:\n cp r24, r22\n brlt .L1\n ldi r24, 1\n.L1:\n ret",
            Box::new(replace("brlt .L1", "brlo .L1")),
        ),
        (
            "a register that is kept for the caller",
            "f:\n push r16\n ldi r16, 1\n call g\n pop r16\n ret",
            Box::new(move |body| {
                drop("push")(body);
                drop("pop")(body);
            }),
        ),
        (
            "a push without its pop",
            "f:\n push r16\n call g\n pop r16\n ret",
            Box::new(drop("pop")),
        ),
        (
            "a register that a call changes",
            "f:\n movw r26, r14\n call g\n movw r26, r14\n ld r24, X\n ret",
            Box::new(move |body| {
                body.remove(2);
            }),
        ),
        (
            "an argument",
            "f:\n ldi r22, 7\n call g\n ret",
            Box::new(drop("ldi")),
        ),
        (
            "a write",
            "f:\n std Z+1, r24\n std Z+2, r24\n ret",
            Box::new(drop("std")),
        ),
        (
            "the order of writes",
            "f:\n sts 100, r24\n sts 101, r24\n ret",
            Box::new(|body| body.swap(0, 1)),
        ),
        (
            "a read of an I/O register that nothing needs",
            "f:\n lds r26, 198\n ret",
            Box::new(drop("lds")),
        ),
        (
            "a read by a pointer that may be of I/O",
            "f:\n ldd r27, Y+3\n ret",
            Box::new(drop("ldd")),
        ),
        (
            "interrupts that stay off",
            "f:\n in r0, 63\n cli\n sts 300, r24\n out 63, r0\n ret",
            Box::new(drop("out")),
        ),
        (
            "a write that comes too late",
            "f:\n ldi r25, 24\n sts 96, r25\n sts 96, r1\n ret",
            Box::new(|body| body.insert(2, Line::code("nop"))),
        ),
    ];
    for (what, text, mistake) in cases {
        let before = unit(text);
        assert!(difference(&before, &before).is_none(), "{what}");
        let wrong = with_mistake(&before, mistake);
        assert!(difference(&before, &wrong).is_some(), "{what}");
    }
}

#[test]
fn an_instruction_that_the_machine_does_not_know_is_an_error() {
    for code in [
        "des 3",
        "mul r24, r25",
        "mov r24, counter",
        "ldd r24, Y-3",
        "in r24, 200",
    ] {
        let before = unit(&format!("f:\n {code}\n ret"));
        let error = Program::new(&before).err().expect(code);
        assert_eq!(
            (error.function.as_str(), error.code),
            ("f", Code::parse(code))
        );
    }
}

#[test]
fn jumps_are_dropped_where_they_lead_nowhere_new() {
    check(include_str!("cases/jumps.s"), |unit| {
        jumps::shorten(unit);
    });
}

#[test]
fn decisions_are_made_once() {
    check(include_str!("cases/decide.s"), |unit| {
        decide::drop_known(unit, &mut 0);
        jumps::shorten(unit);
        copies::drop_superfluous(unit);
        jumps::shorten(unit);
    });
}

#[test]
fn copies_of_what_is_there_are_dropped() {
    check(include_str!("cases/copies.s"), |unit| {
        copies::drop_superfluous(unit);
    });
}

#[test]
fn entries_and_exits_are_shared() {
    check(include_str!("cases/saves.s"), |unit| {
        saves::share(unit);
    });
}

#[test]
fn equal_ends_are_merged() {
    check(include_str!("cases/tails.s"), |unit| {
        tails::merge(unit, &mut 0);
    });
}

#[test]
fn equal_parts_are_taken_out() {
    check(include_str!("cases/parts.s"), |unit| {
        parts::take_out(unit, &mut 0);
    });
}

/// `nops N` stands for so many.
#[test]
fn branches_reach() {
    let mut file = String::new();
    for line in include_str!("cases/reach.s").lines() {
        let nops = line.trim().strip_prefix("nops ");
        let count = nops.map_or(1, |count| count.parse().expect("a number"));
        let line = if nops.is_some() { "        nop" } else { line };
        file.push_str(&format!("{line}\n").repeat(count));
    }
    check(&file, |unit| {
        reach::mend(unit);
    });
}

/// As LLVM prints it.
const PRINTED: &str = "\
__SREG__ = 63
\t.section\t.text.by_hand,\"ax\",@progbits
\t.type\tby_hand,@function
by_hand:
\tret
\t.section\t.text.f,\"ax\",@progbits
\t.globl\tf
\t.p2align\t1
\t.type\tf,@function
f:
\tldi\tr24, 1\t; a comment
\t;APP
\twdr
\t;NO_APP
\tret
.Lfunc_end0:
\t.size\tf, .Lfunc_end0-f
\t.section\t.text.table,\"ax\",@progbits
\t.type\ttable,@function
table:
\t.short\t1
.Lfunc_end1:
\t.size\ttable, .Lfunc_end1-table
";

#[test]
fn only_functions_of_the_compiler_without_data_are_taken_apart() {
    let unit = Unit::parse(PRINTED);
    assert_eq!(unit.to_string(), PRINTED.replace("\t; a comment", ""));
    let functions: Vec<&Function> = unit.functions().collect();
    assert_eq!(functions.len(), 1);
    assert_eq!(functions[0].name, "f");
    assert_eq!(
        functions[0].head.first(),
        Some(&"\t.section\t.text.f,\"ax\",@progbits".to_owned())
    );
    let by_hand = functions[0]
        .body
        .iter()
        .filter(|line| matches!(line, Line::Fixed(_)));
    assert_eq!(by_hand.count(), 1);
}

#[test]
fn the_same_text_gives_the_same() {
    let file = include_str!("cases/parts.s")
        .replace("==", ";")
        .replace("=>", ";");
    let once = super::shorten(&file).text;
    assert_eq!(once, super::shorten(&file).text);
}

#[test]
fn functions_that_call_one_another_stand_together() {
    let body = |calls: &str, words: usize| {
        let mut lines = vec![Line::code("nop"); words];
        lines.push(Line::code(calls));
        lines.push(Line::code("ret"));
        lines
    };
    let function = |name, calls, words| Item::Function(routine(name, body(calls, words)));
    let mut unit = Unit {
        items: vec![
            function("a", "call b", 10),
            function("far", "nop", 2_100),
            function("b", "call a", 10),
        ],
    };
    super::order::arrange(&mut unit);
    let Some(Item::Verbatim(order)) = unit.items.first() else {
        panic!("no order");
    };
    let at = |name: &str| {
        let found = order
            .iter()
            .position(|line| line.contains(&format!(".text.{name},")));
        found.expect(name)
    };
    assert_eq!(at("a").abs_diff(at("b")), 1, "{order:?}");
    assert_eq!(order.len(), 3);
}
