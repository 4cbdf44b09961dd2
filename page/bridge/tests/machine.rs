//! A machine beside the board of a page.

#![cfg(feature = "full")]

mod asked;

use asked::told;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use unoclp_bridge::{Boards, Wires, step};

fn ok(boards: &mut Boards, request: Value) -> Value {
    let told = told(boards, request);
    assert!(told.get("ok").is_some(), "{told}");
    told["ok"].clone()
}

fn file(name: &str) -> String {
    programs(&format!("plants/{name}"))
}

fn programs(path: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    fs::read_to_string(folder.join(path)).unwrap()
}

fn open(boards: &mut Boards, name: &str) -> Value {
    ok(
        boards,
        json!({ "ask": "machine", "name": name, "text": file(name), "speak": "en" }),
    )
}

/// What a person can move of a machine, by its name.
fn hand<'k>(known: &'k Value, name: &str) -> &'k Value {
    let mut hands = known["hands"].as_array().unwrap().iter();
    hands.find(|hand| hand["name"] == name).unwrap()
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
        let mut wires = Wires {
            shares: [255; 100],
            ..Wires::default()
        };
        step(&mut boards, 15, &mut wires, 200).unwrap();
        let look = ok(&mut boards, json!({ "ask": "machineLook" }));
        assert_eq!(look["at"], 200, "{name}");
        count += 1;
    }
    assert_eq!(count, 20);
}

#[test]
fn a_hand_gives_an_input_and_outputs_move_it() {
    let mut boards = Boards::default();
    let known = open(&mut boards, "batch.toml");
    let start = hand(&known, "start");
    let mut wires = Wires::default();
    let mut step = |boards: &mut Boards, levels, ms| step(boards, levels, &mut wires, ms).unwrap();
    assert_eq!(step(&mut boards, 0, 1) & 1, 0);
    let press = |to: i32| json!({ "ask": "machineHand", "part": start["part"], "value": start["value"], "to": to });
    ok(&mut boards, press(1));
    assert_eq!(step(&mut boards, 1, 1) & 1, 1);
    ok(&mut boards, press(0));
    // The inlet stays open, and nobody closes it.
    for _ in 0..160 {
        step(&mut boards, 1, 250);
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
        assert_eq!(step(&mut boards, 0, 250) & 1, 0);
    }
}

/// What passes besides levels: the share of an output that is dimmed, and a reading; without a machine, nothing.
#[test]
fn shares_drive_a_machine_and_readings_come_back() {
    let mut boards = Boards::default();
    let mut wires = Wires::default();
    assert_eq!(step(&mut boards, 15, &mut wires, 250), None);
    let known = open(&mut boards, "oven.toml");
    let sensed = known["uses"][1][0].as_u64().unwrap() as usize;
    let mut warmed = |share: u8| {
        ok(&mut boards, json!({ "ask": "machineReset" }));
        wires.shares = [share; 100];
        for _ in 0..400 {
            step(&mut boards, 0, &mut wires, 250);
        }
        wires.readings[sensed]
    };
    let [cold, warm, hot] = [0, 120, 255].map(&mut warmed);
    assert!(
        cold < warm && warm < hot && hot < 1024,
        "{cold} {warm} {hot}"
    );
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

/// A fault is hidden in the machine: it shows, no list mends it, and it is found by its name alone.
#[test]
fn a_hidden_fault_is_looked_for() {
    let mut boards = Boards::default();
    let known = ok(
        &mut boards,
        json!({ "ask": "machine", "name": "motor.toml", "text": file("motor.toml"), "speak": "en", "find": programs("exercises/find/01-motor.toml") }),
    );
    let faults = known["faults"].as_array().unwrap();
    let welded = faults.iter().find(|fault| fault[1] == "welded").unwrap();
    let part = welded[0].as_u64().unwrap();
    assert_eq!(
        (&known["names"][part as usize], &welded[2]["pt"]),
        (&json!("k1"), &json!("contatos soldados"))
    );
    let start = hand(&known, "start");
    for to in [1, 0] {
        ok(
            &mut boards,
            json!({ "ask": "machineHand", "part": start["part"], "value": start["value"], "to": to }),
        );
    }
    ok(&mut boards, json!({ "ask": "machineForced" }));
    let search =
        |boards: &mut Boards| ok(boards, json!({ "ask": "machineLook" }))["search"].clone();
    assert_eq!(
        search(&mut boards),
        json!({ "steps": 2, "tries": 0, "found": false })
    );
    // Once the contactor has pulled in, it stays so without its output.
    let drop_out = |boards: &mut Boards| {
        for levels in [1, 0] {
            step(boards, levels, &mut Wires::default(), 250);
        }
        ok(boards, json!({ "ask": "machineLook" }))["changes"].to_string()
    };
    ok(
        &mut boards,
        json!({ "ask": "machineFault", "part": part, "fault": "welded", "is": false }),
    );
    drop_out(&mut boards);
    ok(&mut boards, json!({ "ask": "machineReset" }));
    let name = |fault: &str| json!({ "ask": "machineName", "part": part, "fault": fault });
    assert_eq!(ok(&mut boards, name("open"))["found"], false);
    assert_eq!(
        ok(&mut boards, name("rusty"))["tries"],
        1,
        "no fault, no try"
    );
    let found = ok(&mut boards, name("welded"));
    assert_eq!(found, json!({ "steps": 2, "tries": 2, "found": true }));
    // One that hides nothing, one that the machine cannot have.
    for find in [
        "until = 5\n".to_owned(),
        programs("exercises/find/02-two-tanks.toml"),
    ] {
        let told = told(
            &mut boards,
            json!({ "ask": "machine", "name": "motor.toml", "text": file("motor.toml"), "speak": "en", "find": find }),
        );
        assert!(told["error"]["pt"].is_string(), "{told}");
    }
    // Without a search there is nothing to be named.
    open(&mut boards, "motor.toml");
    assert_eq!(ok(&mut boards, name("welded")), Value::Null);
    assert_eq!(search(&mut boards), Value::Null);
}

/// What breaks a rule is seen again from two seconds before, and its points beneath.
#[test]
fn a_broken_rule_is_seen_again() {
    let mut boards = Boards::default();
    let with = |ask: &str, program: &str, more: Value| {
        let mut request = json!({ "ask": ask, "name": "p.st", "text": programs(program), "plant": "reversing.toml", "plantText": file("reversing.toml") });
        request
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        request
    };
    let right = ok(&mut boards, with("trial", "plants/reversing.st", json!({})));
    assert_eq!(right, json!({ "passed": true, "why": null, "at": null }));
    let wrong = ok(
        &mut boards,
        with("trial", "plants/wrong/reversing-lock.st", json!({})),
    );
    let at = wrong["at"].as_u64().unwrap();
    let why = wrong["why"]["en"].as_str().unwrap();
    assert!(at > 0 && why.contains("a rule was broken"), "{wrong}");
    let again = with(
        "replay",
        "plants/wrong/reversing-lock.st",
        json!({ "at": at, "why": why, "speak": "en", "scenario": programs("exercises/06-reverse.toml") }),
    );
    let replay = ok(&mut boards, again);
    assert_eq!(replay["from"], at.saturating_sub(2000));
    let frames = replay["frames"].as_array().unwrap();
    let span = replay["until"].as_u64().unwrap() - replay["from"].as_u64().unwrap();
    assert_eq!(
        frames.len() as u64,
        span / replay["every"].as_u64().unwrap()
    );
    assert!(
        frames
            .iter()
            .any(|frame| !frame.as_array().unwrap().is_empty())
    );
    assert!(replay["svg"].as_str().unwrap().contains("data-part"));
    let diagram = replay["diagram"].as_str().unwrap();
    for part in ["class=\"cursor\"", "I1 ", "Q2", why] {
        assert!(diagram.contains(part), "{part}: {diagram}");
    }
    // A time that never comes, and a program that does not run, are no panic.
    let late = with(
        "replay",
        "plants/reversing.st",
        json!({ "at": u32::MAX, "why": "", "speak": "pt" }),
    );
    assert!(ok(&mut boards, late)["svg"].is_string());
    let none = told(
        &mut boards,
        with(
            "replay",
            "plants/reversing.toml",
            json!({ "at": 1, "why": "", "speak": "pt" }),
        ),
    );
    assert!(none["error"].is_object());
}

/// The exercises of the two other kinds say what they are; what is written again has to be in its language.
#[test]
fn each_kind_of_exercise_is_told() {
    let mut boards = Boards::default();
    let sheet = |boards: &mut Boards, path: &str| {
        ok(
            boards,
            json!({ "ask": "sheet", "title": "x", "scenario": programs(path) }),
        )
    };
    let find = sheet(&mut boards, "exercises/find/01-motor.toml");
    assert_eq!(
        (&find["kind"], &find["given"]),
        (&json!("find"), &Value::Null)
    );
    assert!(
        !find.to_string().contains("welded"),
        "it gives nothing away"
    );
    let write = sheet(&mut boards, "exercises/write/01-into-text.toml");
    assert_eq!(
        (
            &write["kind"],
            &write["given"]["language"],
            &write["given"]["answerIn"]
        ),
        (&json!("write"), &json!("il"), &json!("st"))
    );
    assert_eq!(
        sheet(&mut boards, "exercises/01-contacts.toml")["kind"],
        "program"
    );
    let mut answer = |name: &str, text: &str| {
        told(
            &mut boards,
            json!({ "ask": "exercise", "name": name, "text": text, "title": "x", "scenario": programs("exercises/write/01-into-text.toml") }),
        )
    };
    let right = answer("a.st", &programs("exercises/write/01-into-text.st"));
    assert_eq!(right["ok"]["passed"], true, "{right}");
    let given = write["given"]["text"].as_str().unwrap();
    let same = answer("a.il", given);
    assert!(
        same["error"]["en"].as_str().unwrap().contains("`st`"),
        "{same}"
    );
}

/// What chance brings in a hidden run stays hidden: that it went wrong is told, and neither what, nor when, nor by which
/// number; nothing is shown of it. A case that is hidden is told by its title.
#[test]
fn what_is_hidden_of_an_exercise_is_not_told() {
    let machine = "title = \"Belt\"\nuntil = \"12 s\"\nseed = 4\n\
        [[part]]\nname = \"belt\"\nkind = \"belt\"\nrun = \"Q1\"\nonto = \"rest\"\nlong = \"1 m\"\nspeed = \"400 mm/s\"\n\
        [[part]]\nname = \"feeder\"\nkind = \"feeder\"\nonto = \"belt\"\nevery = \"400 mm\"\nthings = \"mixed\"\nmost = 1\n\
        [[part]]\nname = \"rest\"\nkind = \"bin\"\nwants = \"plastic\"\n\
        [[never]]\nwhen = \"rest.wrong > 0\"\ntext = \"No metal\"\n";
    let exercise = |seeds: &str, expected: u8| {
        let scenario = format!(
            "title = \"Belt\"\nplant = \"belt.toml\"\nseeds = [{seeds}]\n[[case]]\ntitle = \"It runs\"\nhidden = true\nuntil = 20\nstep = [{{ at = 7, expect = {{ Q1 = {expected} }} }}]\n"
        );
        json!({ "ask": "exercise", "name": "p.il", "text": "LDN M1\nST Q1\n", "title": "belt", "scenario": scenario,
            "plant": "belt.toml", "plantText": machine })
    };
    let mut boards = Boards::default();
    let well = ok(&mut boards, exercise("5, 6", 1));
    assert_eq!(well["passed"], true, "{well}");
    let came = ok(&mut boards, exercise("5, 2", 1));
    assert_eq!(came["passed"], false);
    let fared = &came["machine"];
    assert_eq!(fared["at"], Value::Null, "{came}");
    let why = fared["why"].to_string();
    assert!(why.contains("other, hidden random values"), "{why}");
    for told in ["metal", "2.599", "(2)"] {
        assert!(!came.to_string().contains(told), "{told}: {came}");
    }
    let failed = ok(&mut boards, exercise("5", 0));
    assert_eq!(failed["failing"]["shown"], Value::Null, "{failed}");
}
