//! What a block diagram says is what its program does: each wire, in each scan of random programs.

use super::{Graph, Kind, Placed};
use crate::{Ladder, Symbol};
use std::collections::BTreeMap;
use std::fmt::Write;
use unoclp_core::{Board, Image, Loader, Plc};
use unoclp_point::Address;
use unoclp_testing::{Random, rounds};

/// A random series of contacts, paths, blocks and NOT.
fn series(random: &mut Random, depth: usize, codes: &mut String) {
    for _ in 0..=random.below(3) {
        match random.below(12) {
            0..=1 if depth < 3 => {
                let open = random.pick(&[40, 40, 40, 6540, 8840]);
                let _ = write!(codes, "{open} ");
                series(random, depth + 1, codes);
                codes.push_str("41 ");
            }
            2 => codes.push_str("787984 "),
            3 if depth == 0 => coil(random, codes),
            _ => {
                let sign = if random.percent(40) { "-" } else { "" };
                let point = random.pick(&[8273, 8277, 8279]);
                let number = 1 + random.below(3);
                let _ = write!(codes, "{sign}{point}{number:02} ");
            }
        }
    }
}

fn coil(random: &mut Random, codes: &mut String) {
    let coil = random.pick(&["8779", "8777", "-8779", "838779", "828779"]);
    let number = 1 + random.below(3);
    let _ = write!(codes, "{coil}{number:02} ");
}

/// What an image holds of a point.
fn bit(point: Address, images: &BTreeMap<Address, bool>) -> bool {
    images.get(&point).copied().unwrap_or(false)
}

/// What `|2 I1 !I2` says of these points.
fn said(words: &mut std::str::Split<'_, char>, images: &BTreeMap<Address, bool>) -> bool {
    let word = words.next().unwrap();
    if let Some(rest) = word.strip_prefix('!') {
        return !told(rest, words, images);
    }
    told(word, words, images)
}

fn told(
    word: &str,
    words: &mut std::str::Split<'_, char>,
    images: &BTreeMap<Address, bool>,
) -> bool {
    let gate = word.split_at(1);
    match gate {
        ("|" | "&", count) => {
            let count: usize = count.parse().unwrap();
            let values: Vec<bool> = (0..count).map(|_| said(words, images)).collect();
            match gate.0 {
                "|" => values.contains(&true),
                _ => !values.contains(&false),
            }
        }
        _ => bit(Address::parse(word).unwrap(), images),
    }
}

#[test]
fn each_wire_of_random_programs_says_what_the_scan_has() {
    let mut seen = 0;
    for seed in 0..rounds(400) {
        let mut random = Random(u64::from(seed) + 1);
        let mut codes = String::new();
        for rung in 0..=random.below(2) {
            codes.push_str(if rung == 0 { "" } else { "787600 " });
            series(&mut random, 0, &mut codes);
            coil(&mut random, &mut codes);
        }
        let mut memory = vec![0; 4_000];
        let mut loader = Loader::new(&mut memory, Board::UNO);
        let file = format!("0\n{}\n", codes.trim().replace(' ', "\n"));
        let loaded = file.bytes().try_for_each(|byte| loader.push(byte));
        let program = loaded.and_then(|()| loader.finish());
        let program = program.unwrap_or_else(|fault| panic!("{fault}: {codes}"));
        let ladder = Ladder::new(program.steps());
        let count = program.steps().count();
        let mut plc = Plc::new(program);
        let mut images: BTreeMap<Address, bool> = BTreeMap::new();
        for _ in 0..20 {
            let inputs = random.below(8) as u128;
            for number in 1..=3_u8 {
                images.insert(Address::Input(number), inputs >> (number - 1) & 1 == 1);
            }
            let mut flow = vec![None; count];
            let outputs = plc.scan_observed(Image(inputs), 0, |step, after| {
                flow[step] = Some(after.acc);
            });
            let outputs = outputs.unwrap().0;
            let power = ladder.nets.power(&flow);
            for rung in &ladder.rungs {
                let graph = Graph::of(&ladder, rung);
                let mut values: Vec<bool> = Vec::new();
                for vertex in &graph.vertices {
                    let mut pins = vertex
                        .inputs
                        .iter()
                        .map(|pin| values[pin.from] != pin.negated);
                    let value = match &vertex.kind {
                        Kind::Value(index) => bit(ladder.elements[*index].point.unwrap(), &images),
                        Kind::Named(name) => name == "1",
                        Kind::Gate("&", _) => pins.all(|pin| pin),
                        Kind::Gate("≥1", _) => pins.any(|pin| pin),
                        Kind::Gate(..) => pins.fold(false, |one, other| one != other),
                        Kind::Box(_) => !pins.next().unwrap(),
                        Kind::Store(_) => pins.next().unwrap(),
                        Kind::Output(index) => {
                            let element = &ladder.elements[*index];
                            let (pin, point) = (pins.next().unwrap(), element.point.unwrap());
                            let Symbol::Coil { letter, .. } = element.symbol else {
                                unreachable!("{codes}");
                            };
                            match (letter, pin) {
                                (' ', pin) => drop(images.insert(point, pin)),
                                ('/', pin) => drop(images.insert(point, !pin)),
                                ('S', true) => drop(images.insert(point, true)),
                                ('R', true) => drop(images.insert(point, false)),
                                _ => {}
                            }
                            pin
                        }
                    };
                    match &vertex.says {
                        Some(says) => {
                            assert_eq!(
                                said(&mut says.split(' '), &images),
                                value,
                                "{codes}: {says}"
                            );
                            seen += 1;
                        }
                        // A wire that is negated at its end is the power before that.
                        None if matches!(vertex.kind, Kind::Value(_)) => {}
                        None => assert_eq!(power.at(vertex.net), value, "{codes}"),
                    }
                    values.push(value);
                }
            }
            for number in 1..=3_u8 {
                let output = bit(Address::Output(number), &images);
                assert_eq!(output, outputs >> (number - 1) & 1 == 1, "{codes}");
            }
        }
    }
    assert!(seen > 1_000);
}

#[test]
fn no_two_blocks_and_no_wires_of_two_blocks_share_a_place() {
    for seed in 0..rounds(400) {
        let mut random = Random(u64::from(seed) + 1);
        let mut codes = String::new();
        series(&mut random, 0, &mut codes);
        coil(&mut random, &mut codes);
        let mut memory = vec![0; 4_000];
        let mut loader = Loader::new(&mut memory, Board::UNO);
        let file = format!("0\n{}\n", codes.trim().replace(' ', "\n"));
        file.bytes().for_each(|byte| loader.push(byte).unwrap());
        let program = loader.finish().unwrap();
        let ladder = Ladder::new(program.steps());
        let graph = Graph::of(&ladder, &ladder.rungs[0]);
        let placed = Placed::of(&graph, &|_| 1);
        let mut taken: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        let mut take = |column, row, by: usize| {
            let before = taken.insert((column, row), by);
            assert!(before.is_none_or(|before| before == by), "{codes}");
        };
        for (at, vertex) in graph.vertices.iter().enumerate() {
            let spot = &placed.spots[at];
            (spot.row..=spot.last()).for_each(|row| take(spot.column, row, at));
            for (pin, route) in vertex.inputs.iter().zip(&spot.routes) {
                let from = placed.spots[pin.from].column;
                // What goes on in a row is the wire's, which is known by what it leads to.
                (from + 1..spot.column).for_each(|column| take(column, route.row, 1_000 + at));
            }
        }
    }
}
