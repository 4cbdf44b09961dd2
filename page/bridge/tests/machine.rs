//! A machine beside the board of a page.

#![cfg(feature = "full")]

use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use unoclp_bridge::{Boards, answer};

fn told(boards: &mut Boards, request: Value) -> Value {
    serde_json::from_str(&answer(request.to_string().as_bytes(), boards)).unwrap()
}

fn ok(boards: &mut Boards, request: Value) -> Value {
    let told = told(boards, request);
    assert!(told.get("ok").is_some(), "{told}");
    told["ok"].clone()
}

fn file(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/plants");
    fs::read_to_string(folder.join(name)).unwrap()
}

fn open(boards: &mut Boards, name: &str) -> Value {
    ok(
        boards,
        json!({ "ask": "machine", "name": name, "text": file(name), "speak": "en" }),
    )
}

/// Each that is shipped is drawn, and each of its symbols that a hand moves is found by its name.
#[test]
fn each_machine_is_shown() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/plants");
    let names = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name());
    let names = names.map(|name| name.into_string().unwrap());
    let mut count = 0;
    for name in names.filter(|name| name.ends_with(".toml")) {
        let mut boards = Boards::default();
        let known = open(&mut boards, &name);
        let svg = known["svg"].as_str().unwrap();
        for hand in known["hands"].as_array().unwrap() {
            let part = format!("data-part=\"{}\"", hand["name"].as_str().unwrap());
            assert!(svg.contains(&part), "{name}: {part}");
        }
        assert!(!known["rules"].as_array().unwrap().is_empty(), "{name}");
        assert!(!known["uses"][2].as_array().unwrap().is_empty(), "{name}");
        ok(
            &mut boards,
            json!({ "ask": "machineStep", "levels": 15, "shares": [255, 255, 255, 255], "ms": 200 }),
        );
        let look = ok(&mut boards, json!({ "ask": "machineLook" }));
        assert_eq!(look["at"], 200, "{name}");
        count += 1;
    }
    assert_eq!(count, 16);
}

#[test]
fn a_hand_gives_an_input_and_outputs_move_it() {
    let mut boards = Boards::default();
    let known = open(&mut boards, "batch.toml");
    let start = known["hands"]
        .as_array()
        .unwrap()
        .iter()
        .find(|hand| hand["name"] == "start")
        .unwrap();
    let step = |levels: u32, ms: u32| json!({ "ask": "machineStep", "levels": levels, "shares": [], "ms": ms });
    let before = ok(&mut boards, step(0, 1));
    assert!(
        !before["inputs"].as_array().unwrap().contains(&json!(1)),
        "{before}"
    );
    let press = |to: i32| json!({ "ask": "machineHand", "part": start["part"], "value": start["value"], "to": to });
    ok(&mut boards, press(1));
    let pressed = ok(&mut boards, step(1, 1));
    assert!(
        pressed["inputs"].as_array().unwrap().contains(&json!(1)),
        "{pressed}"
    );
    ok(&mut boards, press(0));
    // The inlet stays open, and nobody closes it.
    for _ in 0..160 {
        ok(&mut boards, step(1, 250));
    }
    let look = ok(&mut boards, json!({ "ask": "machineLook" }));
    assert_eq!(look["broken"][0][0], 0, "it overflows: {look}");
    assert!(!look["changes"].as_array().unwrap().is_empty());
    // In another language it goes on; again, it begins.
    let again = json!({ "ask": "machine", "name": "batch.toml", "text": file("batch.toml"), "speak": "pt", "keep": true });
    assert_eq!(
        ok(&mut boards, again)["title"]["pt"],
        "Encher, misturar, esvaziar"
    );
    assert!(ok(&mut boards, json!({ "ask": "machineLook" }))["at"].as_u64() > Some(40_000));
    ok(&mut boards, json!({ "ask": "machineReset" }));
    let look = ok(&mut boards, json!({ "ask": "machineLook" }));
    assert_eq!((&look["at"], &look["broken"]), (&json!(0), &json!([])));
    // The script of the file moves nothing here: whoever is there does.
    for _ in 0..8 {
        let still = ok(&mut boards, step(0, 250));
        assert!(
            !still["inputs"].as_array().unwrap().contains(&json!(1)),
            "{still}"
        );
    }
}

#[test]
fn the_core_moves_a_machine_with_its_program() {
    let mut boards = Boards::default();
    let open_core =
        json!({ "ask": "open", "core": true, "board": "pc", "program": null, "reset": false });
    let board = ok(&mut boards, open_core);
    let known = open(&mut boards, "batch.toml");
    let hands = known["hands"].as_array().unwrap();
    let start = hands.iter().find(|hand| hand["name"] == "start").unwrap();
    let upload =
        json!({ "do": "upload", "name": "batch.st", "text": file("batch.st"), "board": "pc" });
    ok(
        &mut boards,
        json!({ "ask": "order", "board": board, "order": upload }),
    );
    let mut now = 0;
    let mut go = |boards: &mut Boards, ms: u64| {
        let mut last = Value::Null;
        for _ in 0..ms / 50 {
            now += 50;
            last = ok(
                boards,
                json!({ "ask": "step", "board": board, "now": now, "came": [] }),
            );
        }
        last
    };
    go(&mut boards, 100);
    let press = |to: i32| json!({ "ask": "machineHand", "part": start["part"], "value": start["value"], "to": to });
    ok(&mut boards, press(1));
    go(&mut boards, 300);
    ok(&mut boards, press(0));
    go(&mut boards, 60_000);
    let look = ok(&mut boards, json!({ "ask": "machineLook" }));
    assert_eq!(look["broken"], json!([]), "{look}");
    assert!(
        look["met"]
            .as_array()
            .unwrap()
            .iter()
            .all(|met| met.as_u64() >= Some(1)),
        "{look}"
    );
}

#[test]
fn what_is_no_machine_is_told_with_its_line() {
    let mut boards = Boards::default();
    for text in [
        "",
        "title = 3",
        "[[part]]\nkind = \"unknown\"\n",
        "<p>",
        "[[part]",
    ] {
        let told = told(
            &mut boards,
            json!({ "ask": "machine", "name": "bad.toml", "text": text, "speak": "en" }),
        );
        let why = told["error"]["en"].as_str().unwrap_or_default();
        assert!(why.contains("bad.toml:"), "{text}: {told}");
    }
    for ask in ["machineLook", "machineReset"] {
        assert!(told(&mut boards, json!({ "ask": ask }))["error"]["pt"].is_string());
    }
}
