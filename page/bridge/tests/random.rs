//! Requests that nobody meant: an answer always comes.

#![cfg(feature = "full")]

use serde_json::{Value, json};
use unoclp_bridge::{Boards, Wires, answer, step};
use unoclp_testing::{Random, rounds};

/// An answer is JSON, and says one of three things.
fn is_answered(request: &[u8], boards: &mut Boards) {
    let told = answer(request, boards);
    let told: Value = serde_json::from_str(&told).expect("an answer is JSON");
    let keys: Vec<&String> = told.as_object().expect("an object").keys().collect();
    assert!(matches!(keys[..], [key] if ["ok", "error", "more"].contains(&key.as_str())));
}

/// One good request of each kind.
fn requests() -> Vec<Value> {
    let text = json!({ "name": "a.il", "text": "LD I1\nTON T1, 20\nST Q1\n" });
    let with = |mut request: Value| {
        let more = text.as_object().unwrap().clone();
        request.as_object_mut().unwrap().extend(more);
        request
    };
    let order = |order: Value| json!({ "ask": "order", "board": 1, "order": order });
    vec![
        with(json!({ "ask": "check" })),
        with(json!({ "ask": "ladder", "width": 64, "speak": "pt" })),
        with(json!({ "ask": "list", "as": "svg", "width": 64, "speak": "en" })),
        with(json!({ "ask": "list", "as": "xml", "width": 64, "speak": "pt" })),
        with(json!({ "ask": "adapt" })),
        with(json!({ "ask": "pages", "letter": true, "width": 64, "speak": "en" })),
        with(
            json!({ "ask": "exercise", "title": "x", "scenario": "until = 5\n[[expect]]\nat = 1\n" }),
        ),
        json!({ "ask": "card", "program": "0\n787600\n", "state": true }),
        json!({ "ask": "read", "blocks": [[0, "00ff"], [7, ""]], "name": "STATE.TXT" }),
        json!({ "ask": "open", "program": text, "reset": true, "rate": 9600, "parity": 1, "address": 3 }),
        json!({ "ask": "open", "core": true, "board": "pc", "program": null, "reset": false }),
        json!({ "ask": "step", "board": 2, "now": 90, "came": [] }),
        json!({ "ask": "order", "board": 2, "order": { "do": "press", "input": 99, "closed": true } }),
        json!({ "ask": "order", "board": 2, "order": { "do": "turn", "input": 3, "reading": 512 } }),
        json!({ "ask": "order", "board": 2, "order": { "do": "set", "point": "T1", "value": 5 } }),
        json!({ "ask": "order", "board": 2, "order": { "do": "upload", "name": "a.il", "text": "LD I99\nTON T1, 20\nST Q9\n", "board": "pc" } }),
        json!({ "ask": "step", "board": 1, "now": 12.5, "came": [1, 3, 2, 0, 7, 255] }),
        order(json!({ "do": "run" })),
        order(json!({ "do": "fetch" })),
        order(json!({ "do": "force", "output": true, "number": 1, "to": null })),
        order(json!({ "do": "set", "point": "D1", "value": -7 })),
        order(with(json!({ "do": "upload", "stay": true }))),
        order(with(json!({ "do": "watch" }))),
        order(
            json!({ "do": "settle", "settings": { "address": 1, "rate": 9600, "parity": 0, "direction": false, "lock": null } }),
        ),
        order(json!({ "do": "flash", "hex": ":00000001FF", "model": "uno" })),
        json!({ "ask": "machine", "name": "m.toml", "text": include_str!("../../../programs/plants/motor.toml"), "speak": "pt", "keep": false }),
        json!({ "ask": "machineHand", "part": 1, "value": 0, "to": 1 }),
        json!({ "ask": "machineFault", "part": 2, "fault": "welded", "is": true }),
        json!({ "ask": "machineLook" }),
        json!({ "ask": "machineReset" }),
        json!({ "ask": "machineClose" }),
        json!({ "ask": "machine", "name": "m.toml", "text": include_str!("../../../programs/plants/motor.toml"), "speak": "pt", "find": include_str!("../../../programs/exercises/find/01-motor.toml") }),
        json!({ "ask": "machineName", "part": 2, "fault": "welded" }),
        json!({ "ask": "machineForced" }),
        with(
            json!({ "ask": "trial", "plant": "m.toml", "plantText": include_str!("../../../programs/exercises/machines/34-oscillator.toml") }),
        ),
        with(
            json!({ "ask": "trace", "ms": 9, "plant": "m.toml", "plantText": include_str!("../../../programs/plants/motor.toml") }),
        ),
        with(
            json!({ "ask": "replay", "at": 7, "why": "x", "speak": "en", "plant": "m.toml", "plantText": include_str!("../../../programs/plants/motor.toml") }),
        ),
        json!({ "ask": "picture", "name": "m.toml", "text": include_str!("../../../programs/plants/motor.toml"), "speak": "pt" }),
        json!({ "ask": "lose", "board": 1, "why": "gone" }),
        json!({ "ask": "close", "board": 1 }),
    ]
}

/// A value that is seldom the one that is wanted.
fn odd(random: &mut Random) -> Value {
    let values = [
        Value::Null,
        json!(true),
        json!(-1),
        json!(1e300),
        json!(u64::MAX),
        json!(256),
        json!(""),
        json!("é😀"),
        json!([]),
        json!([[0, "zz"], 7]),
        json!({}),
        json!("pt"),
    ];
    values[random.below(values.len())].clone()
}

/// Puts something odd in the place of a part, wherever it is, or takes it away.
fn change(value: &mut Value, random: &mut Random) {
    match value {
        Value::Object(values) if !values.is_empty() && random.below(8) > 0 => {
            let key = values.keys().nth(random.below(values.len())).cloned();
            let key = key.expect("a key of those that are there");
            match random.below(4) {
                0 => drop(values.remove(&key)),
                _ => change(&mut values[&key], random),
            }
        }
        Value::Array(values) if !values.is_empty() && random.below(4) > 0 => {
            let at = random.below(values.len());
            change(&mut values[at], random);
        }
        value => *value = odd(random),
    }
}

#[test]
fn random_requests_are_answered() {
    let mut random = Random(17);
    let mut boards = Boards::default();
    for _ in 0..rounds(20_000) {
        let bytes = (0..random.below(40)).map(|_| random.pick(b"{}[]\":,askopentr1e9-\\u \xFF"));
        is_answered(&bytes.collect::<Vec<u8>>(), &mut boards);
    }
}

#[test]
fn mutated_requests_are_answered() {
    let mut random = Random(18);
    let mut boards = Boards::default();
    let mut wires = Wires::default();
    let requests = requests();
    for request in &requests {
        is_answered(request.to_string().as_bytes(), &mut boards);
    }
    for _ in 0..rounds(4_000) {
        let mut request = requests[random.below(requests.len())].clone();
        for _ in 0..=random.below(3) {
            change(&mut request, &mut random);
        }
        let mut bytes = request.to_string().into_bytes();
        if random.below(3) == 0 && !bytes.is_empty() {
            let at = random.below(bytes.len());
            match random.below(3) {
                0 => drop(bytes.remove(at)),
                1 => bytes[at] = random.bits() as u8,
                _ => bytes.truncate(at),
            }
        }
        is_answered(&bytes, &mut boards);
        // Whatever was asked, a machine goes on, or there is none.
        wires.shares = [random.bits() as u8; 100];
        let (levels, ms) = (random.bits() as u32, random.bits() as u32);
        step(&mut boards, levels, &mut wires, ms);
    }
}
