//! What a page asks and is answered, without a browser.

#![cfg(feature = "full")]

mod asked;

use asked::told;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use unoclp_bridge::{Boards, answer};
use unoclp_lang::Lang;

fn ask(request: Value) -> Value {
    told(&mut Boards::default(), request)
}

fn ok(request: Value) -> Value {
    let told = ask(request);
    assert!(told["ok"] != Value::Null, "{told}");
    told["ok"].clone()
}

fn file(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    fs::read_to_string(folder.join(name)).unwrap()
}

#[test]
fn a_board_tells_what_it_has() {
    let uno = ok(json!({ "ask": "board" }));
    assert_eq!(
        uno,
        json!({
            "id": "uno", "name": "UNO", "all": ["uno", "nano", "mega", "pc"], "firmware": true, "real": true,
            "inputs": 8, "outputs": 4, "analogue": 5, "pwm": [1, 4],
            "shared": [[5, 0], [6, 1], [7, 2], [8, 3]],
            "markers": 64, "retentive": [57, 64], "registers": 98, "nearRegisters": 32,
            "counters": 16, "timers": 99, "labels": 32, "stored": 900, "linked": 960,
        })
    );
    assert_eq!(ok(json!({ "ask": "board", "board": "uno" })), uno);
    let nano = ok(json!({ "ask": "board", "board": "nano" }));
    assert_eq!(
        (&nano["id"], &nano["real"]),
        (&json!("nano"), &json!(false))
    );
    let told = ask(json!({ "ask": "board", "board": "giga" }));
    assert!(
        told["error"]["en"].as_str().unwrap().contains("giga"),
        "{told}"
    );
}

/// A text is checked for the board that the request names, and only what is for a board goes on a card.
#[test]
fn a_request_names_the_board_that_a_text_is_for() {
    let text = "LD I99\nST Q65\n";
    let check =
        |board: Value| ok(json!({ "ask": "check", "name": "a.il", "text": text, "board": board }));
    assert_eq!(check(json!(null))["program"], json!(null));
    assert_eq!(check(json!("uno"))["program"], json!(null));
    let program = &check(json!("pc"))["program"];
    assert_eq!(program["uses"]["inputs"], json!([99]));
    assert_eq!(program["size"]["all"], 32_768);
    let card = |board: &str| {
        ask(json!({ "ask": "card", "program": program["code"], "state": false, "board": board }))
    };
    let told = card("pc")["error"]["en"].to_string();
    assert!(
        told.contains("the UNO lacks inputs 99; outputs 65"),
        "{told}"
    );
}

#[test]
fn a_problem_is_told_with_its_place_and_in_both_languages() {
    // Before the place stand characters of one, two and four bytes: 1, 1 and 2 units of UTF-16.
    let text = "(* aé😀 *) STT Q1\n";
    let checked = ok(json!({ "ask": "check", "name": "a.il", "text": text }));
    let problem = &checked["problems"][0];
    assert_eq!(problem["line"], 1);
    let from = problem["from"].as_u64().unwrap() as usize;
    let to = problem["to"].as_u64().unwrap() as usize;
    let units: Vec<u16> = text.encode_utf16().collect();
    assert_eq!(String::from_utf16(&units[from..to]).unwrap(), "STT");
    assert_ne!(problem["message"]["en"], problem["message"]["pt"]);
    assert_eq!(checked["program"], Value::Null);
}

#[test]
fn a_fault_of_numeric_code_is_told_with_its_place() {
    let text = "0\n787600\n  827401\n877901\n";
    let checked = ok(json!({ "ask": "check", "name": "P.TXT", "text": text }));
    assert_eq!(checked["language"], "numeric");
    let problem = &checked["problems"][0];
    let place = ["number", "line", "column", "from", "to"].map(|key| problem[key].to_string());
    assert_eq!(place, ["\"24\"", "3", "3", "11", "17"]);
    let help = problem["help"]["pt"].as_str().unwrap();
    assert!(help.contains("827301"), "{help}");
}

/// What the page saves and puts on a card has a seal, and a file whose end is missing is no program.
#[test]
fn a_program_file_is_sealed_and_one_that_was_cut_is_told() {
    let text = "LD I1\nST Q1\nLD I2\nST Q2\n";
    let checked = ok(json!({ "ask": "check", "name": "a.il", "text": text }));
    let code = checked["program"]["code"].as_str().unwrap();
    let check = |text: &str| ok(json!({ "ask": "check", "name": "PROGRAM.TXT", "text": text }));
    assert_eq!(check(code)["problems"], json!([]));
    let end = code.find("877901").unwrap();
    let end = end + code[end..].find('\n').unwrap() + 1;
    let cut = check(&code[..end]);
    assert_eq!(cut["program"], Value::Null);
    assert_eq!(cut["problems"][0]["severity"], "error");
    let changed = check(&code.replace("877902", "877903"));
    assert!(changed["program"].is_object());
    assert_eq!(changed["problems"][0]["severity"], "warning");
}

#[test]
fn a_program_comes_with_its_code_names_and_map() {
    let text = file("motor.il");
    let checked = ok(json!({ "ask": "check", "name": "motor.il", "text": text }));
    let program = &checked["program"];
    assert!(program["code"].as_str().unwrap().contains("787600"));
    assert_eq!(checked["language"], "il");
    assert!(program["symbols"].as_object().unwrap().contains_key("Q1"));
    let lines = text.lines().count() as u64;
    let steps = program["map"].as_array().unwrap().iter();
    let mut places = steps.map(|step| step[0].as_u64().unwrap());
    assert!(places.all(|line| (1..=lines).contains(&line)));
}

/// What is coloured, and as what: 0 a comment, 1 a text, 2 a point, 3 a number, 4 a word.
fn coloured(name: &str, text: &str) -> Vec<(String, u64)> {
    let checked = ok(json!({ "ask": "check", "name": name, "text": text }));
    let numbers = checked["colours"].as_array().unwrap();
    let numbers: Vec<u64> = numbers.iter().map(|n| n.as_u64().unwrap()).collect();
    let units: Vec<u16> = text.encode_utf16().collect();
    let mut at = 0;
    let part = |part: &[u64]| {
        let from = at + part[0] as usize;
        at = from + part[1] as usize;
        (String::from_utf16(&units[from..at]).unwrap(), part[2])
    };
    numbers.chunks(3).map(part).collect()
}

#[test]
fn words_are_coloured_as_the_lexer_of_their_language_reads_them() {
    type Case<'t> = (&'t str, &'t str, &'t [(&'t str, u64)]);
    let cases: [Case<'_>; 7] = [
        (
            "a.il",
            "(* é😀 *) VAR on AT %IX1 : BOOL; END_VAR // x\nL1: LD on\nST Q1 ; LD\nLD T#2s\n",
            &[
                ("(* é😀 *)", 0),
                ("VAR", 4),
                ("AT", 4),
                ("%IX1", 2),
                ("BOOL", 4),
                ("END_VAR", 4),
                ("// x", 0),
                ("LD", 4),
                ("ST", 4),
                ("Q1", 2),
                ("; LD", 0),
                ("LD", 4),
                ("T#2s", 3),
            ],
        ),
        (
            "a.st",
            "VAR t : TON; END_VAR t(IN := %IX1, PT := T#1s); (* a (* b *) *)",
            &[
                ("VAR", 4),
                ("TON", 4),
                ("END_VAR", 4),
                ("%IX1", 2),
                ("T#1s", 3),
                ("(* a (* b *) *)", 0),
            ],
        ),
        ("a.scl", "#x := 'it' ; // y", &[("'it'", 1), ("// y", 0)]),
        (
            "a.iscl",
            "BLOCO INT x; x := 16#F; // n\nEND_BLOCK",
            &[
                ("BLOCO", 4),
                ("INT", 4),
                ("16#F", 3),
                ("// n", 0),
                ("END_BLOCK", 4),
            ],
        ),
        (
            "a.lce",
            "clp x rede um dois\naciona Q0.0, I0.1; fim",
            &[
                ("clp", 4),
                ("rede", 4),
                ("um dois", 1),
                ("aciona", 4),
                ("Q0.0", 2),
                ("I0.1", 2),
                ("fim", 4),
            ],
        ),
        (
            "P.TXT",
            "0 / é\n -787600\n/ all",
            &[("0", 3), ("/ é", 0), ("-787600", 3), ("/ all", 0)],
        ),
        ("a.il", "(* open", &[("(* open", 0)]),
    ];
    for (name, text, expected) in cases {
        let told = coloured(name, text);
        let told: Vec<(&str, u64)> = told.iter().map(|(part, of)| (part.as_str(), *of)).collect();
        assert_eq!(told, expected, "{name}");
    }
}

#[test]
fn a_ladder_names_its_nets_and_steps() {
    let text = "LD I1\nOR Q1\nANDN I2\nST Q1\n";
    let request = json!({ "ask": "ladder", "name": "a.il", "text": text, "width": 64 });
    let drawn = ok(request.clone());
    let svg = drawn["svg"].as_str().unwrap();
    for part in [
        "class=\"ladder\"",
        "data-point=\"I1\"",
        "data-point=\"Q1\"",
        "data-rung=\"1\"",
        "data-nets=\"0\"",
        "data-lines=\"1-4\"",
        "class=\"wire n",
    ] {
        assert!(svg.contains(part), "{part} in {svg}");
    }
    let has_colour = svg.contains("fill=") || svg.contains("stroke=\"");
    assert!(!has_colour, "colours are the page's");
    let mut portuguese = request;
    portuguese["speak"] = "pt".into();
    assert!(ok(portuguese)["svg"].as_str().unwrap().contains("Degrau 1"));
}

#[test]
fn every_program_is_drawn_and_listed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    let mut drawn = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name == "STATE.TXT" || !name.ends_with(".il") && !name.ends_with(".txt") {
            continue;
        }
        let text = file(&name);
        ok(json!({ "ask": "ladder", "name": name, "text": text, "width": 64 }));
        for form in ["ladder", "il", "st", "numeric", "svg"] {
            ok(json!({ "ask": "list", "name": name, "text": text, "as": form, "width": 80 }));
        }
        let pages =
            ok(json!({ "ask": "pages", "name": name, "text": text, "letter": true, "width": 80 }));
        assert!(!pages.as_array().unwrap().is_empty(), "{name}");
        drawn += 1;
    }
    assert!(drawn > 15, "{drawn}");
}

#[test]
fn steps_and_solutions_of_the_tutorial_pass_and_other_programs_do_not() {
    let exercise = |program: &str, scenario: &str| {
        let text = file(&format!("tutorial/{program}"));
        let told = file(&format!("tutorial/{scenario}"));
        ok(
            json!({ "ask": "exercise", "name": program, "text": text, "title": scenario, "scenario": told }),
        )
    };
    let passed = |outcome: &Value| outcome["passed"].as_bool().unwrap();
    let step = exercise("01-lamp.il", "01-lamp.toml");
    assert!(passed(&step), "{step}");
    let solution = exercise("solutions/01-pair.il", "solutions/01-pair.toml");
    assert!(passed(&solution), "{solution}");
    let other = exercise("01-lamp.il", "solutions/01-pair.toml");
    assert!(!passed(&other));
    assert_eq!(other["failing"]["case"], 0);
    let shown = &other["failing"]["shown"];
    let first = &shown["unmet"];
    assert_ne!(first["expected"], first["came"], "{other}");
    for lang in ["en", "pt"] {
        assert!(shown["svg"][lang].as_str().unwrap().starts_with("<svg"));
        assert!(
            shown["why"][lang]
                .as_str()
                .unwrap()
                .contains(first["place"].as_str().unwrap())
        );
    }
    let hidden = "scan_ms = 10\ntitle = { en = \"a\", pt = \"b\" }\nhints = [{ en = \"h\", pt = \"d\" }]\n\
        [[case]]\nhidden = true\ntitle = { en = \"On\", pt = \"Liga\" }\nstep = [{ at = 770, expect = { Q4 = 1 } }]";
    let sheet = ok(json!({ "ask": "sheet", "title": "x", "scenario": hidden }));
    assert_eq!(sheet["cases"][0]["title"]["pt"], "Liga");
    assert_eq!(sheet["hints"][0]["en"], "h");
    let failed = ok(
        json!({ "ask": "exercise", "name": "a.il", "text": "LD I1\nST Q1", "title": "x", "scenario": hidden }),
    );
    assert_eq!(failed["failing"], json!({ "case": 0, "shown": null }));
    assert!(!failed.to_string().contains("770") && !sheet.to_string().contains("770"));
    let wrong = json!({ "ask": "exercise", "name": "a.il", "text": "LD I1\nST Q1", "title": "x", "scenario": "until = 5" });
    let wrong = ask(wrong);
    assert!(wrong["error"]["pt"].is_string(), "{wrong}");
}

#[test]
fn a_card_holds_the_program() {
    let program = "0 / é\n787600\n827301\n877901\n";
    let card = ok(json!({ "ask": "card", "program": program, "state": true }));
    let blocks = &card["blocks"];
    assert!(
        blocks.as_array().unwrap().len() < 100,
        "empty blocks are left out"
    );
    let read = |name: &str| {
        let request = json!({ "ask": "read", "blocks": blocks, "name": name });
        ask(request)["ok"].clone()
    };
    assert_eq!(read("PROGRAM.TXT"), program);
    assert!(read("STATE.TXT").is_string());
    assert_eq!(read("OTHER.TXT"), Value::Null);
}

#[test]
fn the_room_on_a_card_is_counted_whatever_stands_on_it() {
    let free = |blocks: &Value| ask(json!({ "ask": "free", "blocks": blocks }))["ok"].clone();
    let card = ok(json!({ "ask": "card", "program": "0\n", "state": false }));
    let more = ok(json!({ "ask": "card", "program": "0\n".repeat(512), "state": false }));
    let room = free(&card["blocks"]).as_u64().unwrap();
    assert!(room > 1 << 20, "{room}");
    let fresh = room - free(&more["blocks"]).as_u64().unwrap();
    assert_eq!(fresh, 512, "one block more");

    // Every entry of its FAT, after the boot sector and what is reserved, stands for a cluster in use.
    let mut full = card["blocks"].clone();
    let blocks = full.as_array_mut().unwrap();
    blocks.retain(|block| block[0] == 0 || block[0] == 2048);
    blocks.extend((2049..2100).map(|number| json!([number, "ff".repeat(512)])));
    assert_eq!(free(&full), 0);

    let zeros = [(0, "00".repeat(512))];
    let garbage = [(0, "ff".repeat(512))];
    let boot = format!("{}55aa", "ff".repeat(510));
    for none in [json!([]), json!(zeros), json!(garbage), json!([[0, boot]])] {
        assert_eq!(free(&none), Value::Null);
    }
}

#[test]
fn a_conversation_asks_waits_and_tells_that_nobody_answers() {
    let mut boards = Boards::default();
    let mut ask = |request: Value| told(&mut boards, request)["ok"].clone();
    let program = json!({ "name": "a.il", "text": "LD I1\nST Q1\n" });
    let board = ask(json!({ "ask": "open", "program": program, "reset": false }));
    let order = json!({ "ask": "order", "board": board, "order": { "do": "run" } });
    let order = ask(order);
    let (mut now, mut sent, mut news) = (0.0, Vec::new(), Vec::new());
    while !news.iter().any(|one: &Value| one["news"] == "undone") {
        let step = ask(json!({ "ask": "step", "board": board, "now": now, "came": [] }));
        sent.extend(step["send"].as_array().unwrap().clone());
        news.extend(step["news"].as_array().unwrap().clone());
        now = step["until"].as_f64().unwrap().max(now + 0.1);
        assert!(now < 60_000.0, "{news:?}");
    }
    assert_eq!(
        sent[..5],
        [1, 43, 14, 1, 0].map(Value::from),
        "identification"
    );
    assert_eq!(news[0]["news"], "lost");
    assert_eq!(news[1]["order"], order);
    ask(json!({ "ask": "close", "board": board }));
}

#[test]
fn nothing_that_is_asked_panics() {
    let mut boards = Boards::default();
    let mut told = |request: Value| told(&mut boards, request);
    let deep = "(".repeat(10_000);
    let long = "LD I1\n".repeat(300_000);
    let texts = [
        "",
        "\u{FEFF}",
        "\0",
        "é",
        "0\n99999999999",
        "PROGRAM",
        "BLOCO",
        &deep,
        &long,
    ];
    for name in [
        "", "a", "a.il", "a.st", "a.scl", "a.iscl", "a.lce", "../..", "é.st",
    ] {
        for text in texts {
            for (what, width) in [
                ("check", 0),
                ("ladder", 0),
                ("ladder", usize::MAX),
                ("list", 1),
                ("exercise", 0),
                ("sheet", 0),
            ] {
                if text.len() > 1000 && what != "check" {
                    continue;
                }
                let request = json!({
                    "ask": what, "name": name, "text": text, "width": width, "as": "ladder", "scenario": text,
                    "title": name,
                });
                told(request);
            }
        }
    }
    for request in [
        "",
        "{",
        "[]",
        "null",
        "\u{FFFF}",
        "{\"ask\":\"none\"}",
        "{\"ask\":\"check\"}",
        "{\"ask\":\"step\",\"board\":7,\"now\":-1e300,\"came\":[]}",
        "{\"ask\":\"step\",\"board\":7,\"now\":0,\"came\":[300]}",
        "{\"ask\":\"read\",\"blocks\":[[0,\"zz\"],[4294967295,\"é\"]],\"name\":\"éééééééé.é\"}",
    ] {
        let answer = answer(request.as_bytes(), &mut Boards::default());
        assert!(
            answer.starts_with("{\"error\"") || answer == "{\"ok\":null}",
            "{request}: {answer}"
        );
    }
    let open = told(json!({ "ask": "open", "reset": true, "rate": 0, "parity": 9 }));
    let board = &open["ok"];
    let noise: Vec<u8> = (0..=255).collect();
    for now in [0.0, 1e308, -5.0, 1e-300] {
        told(json!({ "ask": "step", "board": board, "now": now, "came": noise }));
    }
    for order in [
        json!({ "do": "force", "output": true, "number": 255, "to": true }),
        json!({ "do": "set", "point": "é9", "value": 0 }),
        json!({ "do": "upload", "name": "", "text": "" }),
    ] {
        told(json!({ "ask": "order", "board": board, "order": order }));
    }
    told(json!({ "ask": "step", "board": board, "now": 9e9, "came": [] }));
}

/// The page has checked it for a Mega; the board at the port is a UNO.
#[test]
fn a_program_that_the_board_at_hand_lacks_points_for_is_not_sent() {
    let mut boards = Boards::default();
    let mut told = |request: Value| told(&mut boards, request);
    let session = told(json!({ "ask": "open", "reset": false }))["ok"].clone();
    for (name, text) in [
        ("far.il", "LD I1\nST Q1\nLD I24\nST Q16\n"),
        ("far.txt", "0\n827301\n827324\n877901\n"),
    ] {
        let mut upload = |board: &str| {
            let order = json!({ "do": "upload", "name": name, "text": text, "board": board });
            told(json!({ "ask": "order", "board": session, "order": order }))
        };
        let uno = upload("uno");
        for (lang, parts) in [
            (
                "en",
                [
                    "the UNO cannot run this program: line 3: ",
                    "the Mega has",
                    "; nothing was sent",
                ],
            ),
            (
                "pt",
                [
                    "o UNO não executa este programa: linha 3: ",
                    "a placa Mega tem",
                    "; nada foi enviado",
                ],
            ),
        ] {
            let said = uno["error"][lang].as_str().unwrap();
            assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        }
        assert!(upload("mega")["ok"].is_number());
    }
}

#[test]
fn firmware_that_is_none_is_refused_and_a_board_that_is_silent_is_told() {
    let mut boards = Boards::default();
    let mut told = |request: Value| told(&mut boards, request);
    let hex = fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware/unoclp-uno.hex"),
    );
    let hex = hex.unwrap();
    let board = told(json!({ "ask": "open", "reset": false }))["ok"].clone();
    let mut flash = |hex: &str, model: &str| {
        let order = json!({ "do": "flash", "hex": hex, "model": model });
        told(json!({ "ask": "order", "board": board, "order": order }))
    };
    let none = flash("what", "uno");
    assert!(none["error"]["pt"].is_string(), "{none}");
    let none = flash(&hex, "mega");
    assert!(none["error"]["en"].as_str().unwrap().contains("mega"));
    let order = flash(&hex, "uno")["ok"].clone();
    let (mut now, mut resets) = (0.0, 0);
    let why = loop {
        let step = told(json!({ "ask": "step", "board": board, "now": now, "came": [] }));
        let step = &step["ok"];
        resets += u32::from(step["reset"] == true);
        assert_eq!(step["rate"], 115_200);
        let news = step["news"].as_array().unwrap();
        if let Some(undone) = news.iter().find(|news| news["news"] == "undone") {
            assert_eq!(undone["order"], order);
            break undone["why"].clone();
        }
        now = step["until"].as_f64().unwrap().max(now + 0.1);
        assert!(now < 120_000.0);
    };
    assert!(resets > 0);
    assert_ne!(why["en"], why["pt"]);
    assert!(why["en"].as_str().unwrap().starts_with("FW-21"), "{why}");
}

/// What a page sees after acts on a drawing of this text.
fn drawn(base: &str, acts: &Value) -> (Value, Boards) {
    let mut boards = Boards::default();
    let base = json!({ "name": "a.il", "text": base });
    let draw = json!({ "ask": "draw", "base": base, "log": acts, "width": 64 });
    let told = told(&mut boards, draw);
    assert!(told["ok"] != Value::Null, "{told}");
    (told["ok"].clone(), boards)
}

#[test]
fn what_is_drawn_is_a_text_with_names_and_a_log_draws_it_again() {
    let mut acts = vec![
        json!({ "do": "insert", "what": "contact", "place": "behind" }),
        json!({ "do": "edit", "fields": [{ "key": "point", "value": "I1 start" }] }),
        json!({ "do": "insert", "what": "ton", "place": "behind" }),
    ];
    let (view, _) = drawn("", &json!(acts));
    assert_eq!(view["text"], Value::Null);
    assert_eq!(view["mistakes"][0]["error"], true);
    assert_eq!(view["at"]["fields"].as_array().unwrap().len(), 3);
    acts.push(json!({ "do": "edit", "fields": [
        { "key": "point", "value": "Q1" }, { "key": "name", "value": "lamp" }, { "key": "line0", "value": "2000" },
    ] }));
    let (view, mut boards) = drawn("", &json!(acts));
    let text = "VAR\n    start AT I1 : BOOL;\n    lamp AT Q1 : BOOL;\nEND_VAR\n\nLD    start\nTON   T1, 2000\nST    lamp\n";
    assert_eq!(view["text"], text);
    assert_eq!(
        (&view["undo"], &view["isProgram"]),
        (&json!(4), &json!(true))
    );
    let mut ask = |request: Value| told(&mut boards, request)["ok"].clone();
    assert_eq!(
        ask(json!({ "ask": "find", "words": "LAMP" }))
            .as_array()
            .unwrap()
            .len(),
        1
    );
    let undo = json!({ "ask": "edit", "act": { "do": "undo" }, "width": 64 });
    let views: Vec<Value> = (0..4).map(|_| ask(undo.clone())).collect();
    assert_eq!(
        (&views[3]["undo"], &views[3]["text"]),
        (&json!(0), &json!(""))
    );
    assert_eq!(ask(undo), Value::Null);
}

#[test]
fn a_text_of_a_person_stays_as_it_is_until_it_is_drawn_in() {
    let text = file("motor.il");
    let (view, mut boards) = drawn(&text, &json!([]));
    assert_eq!(view["text"], text);
    let mut edit = |act: Value| {
        let request = json!({ "ask": "edit", "act": act, "width": 64 });
        told(&mut boards, request)["ok"].clone()
    };
    let moved = edit(json!({ "do": "move", "to": "right" }));
    assert_eq!(
        (&moved["text"], &moved["sheet"]),
        (&json!(text), &Value::Null)
    );
    assert_ne!(edit(json!({ "do": "toggle" }))["text"], text);
    assert_eq!(
        edit(json!({ "do": "text", "name": "a.il", "text": "LD I1\nST Q1" }))["text"],
        "LD I1\nST Q1"
    );
    edit(json!({ "do": "undo" }));
    assert_eq!(edit(json!({ "do": "undo" }))["text"], text);
}

#[test]
fn a_name_that_cannot_be_one_is_refused_with_what_to_do() {
    let (_, mut boards) = drawn(
        "",
        &json!([{ "do": "insert", "what": "contact", "place": "behind" }]),
    );
    for value in ["start", "I1 a-b", "I1 I2", "X9"] {
        let act = json!({ "do": "edit", "fields": [{ "key": "point", "value": value }] });
        let told = told(
            &mut boards,
            json!({ "ask": "edit", "act": act, "width": 64 }),
        );
        assert_ne!(told["error"]["en"], Value::Null, "{value}: {told}");
        assert_ne!(told["error"]["en"], told["error"]["pt"]);
    }
}

/// What a text in Instruction List is told of the same point.
fn of_a_text(point: &str) -> (String, String) {
    let compiled = unoclp_lang::compile_text(
        &format!("LD {point}\nST Q1\n"),
        unoclp_lang::TextLanguage::Il,
        unoclp_core::Board::UNO,
    );
    let said = |lang| {
        let told = &compiled.diagnostics[0];
        format!("{}: {}", told.message(lang), told.help(lang))
    };
    (said(Lang::En), said(Lang::Pt))
}

#[test]
fn a_point_that_the_board_lacks_is_told_as_in_a_text() {
    let (_, mut boards) = drawn(
        "",
        &json!([{ "do": "insert", "what": "contact", "place": "behind" }]),
    );
    for point in ["I9", "Q5", "M99", "M0"] {
        let act = json!({ "do": "edit", "fields": [{ "key": "point", "value": point }] });
        let told = told(
            &mut boards,
            json!({ "ask": "edit", "act": act, "width": 64 }),
        );
        let (en, pt) = of_a_text(point);
        assert_eq!(told["error"]["en"], en, "{told}");
        assert_eq!(told["error"]["pt"], pt, "{told}");
    }
}

#[test]
fn each_element_of_the_palette_can_be_inserted() {
    let shelves = ok(json!({ "ask": "palette" }));
    let items = shelves
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|shelf| shelf["items"].as_array().unwrap());
    let mut seen = 0;
    for item in items {
        let act = json!([{ "do": "insert", "what": item["id"], "place": "behind" }]);
        let (view, _) = drawn("", &act);
        assert_eq!(view["undo"], 1, "{item}");
        assert!(
            view["sheet"]["rungs"][0]["drawn"]["svg"]
                .as_str()
                .unwrap()
                .contains("data-id"),
            "{item}"
        );
        seen += 1;
    }
    assert!(seen > 60, "{seen}");
}

/// What comes of a field that a person fills in: an offer, or what a row of the table or the text then says.
#[test]
fn a_mistake_in_a_form_is_told_at_its_field_with_what_could_stand_there() {
    let cases = [
        ("contact", "point", "liga", Err(("point", "I1 liga"))),
        ("coil", "point", "lamp", Err(("point", "Q1 lamp"))),
        ("contact", "point", "S1", Err(("point", "I1 S_1"))),
        ("contact", "point", "T1", Ok("LD    T1")),
        ("ton", "point", "T1", Err(("point", "M1"))),
        ("ton", "point", "I1", Err(("point", ""))),
        ("ton", "line0", "4s", Ok("T1, 4000")),
        ("ton", "line0", "T#1m30s", Ok("T1, 90000")),
        ("ton", "line0", "0,5 s", Ok("T1, 500")),
        ("ton", "line0", "soon", Err(("line0", ""))),
        ("ctu", "line0", "4s", Err(("line0", ""))),
        ("ctu", "point", "parts", Err(("point", "C1 parts"))),
    ];
    for (what, key, value, wanted) in cases {
        // A timer that is read has to be there.
        let timer = json!([
            { "do": "insert", "what": "ton", "place": "behind" },
            { "do": "edit", "fields": [{ "key": "point", "value": "M9" }, { "key": "line0", "value": "1" }] },
            { "do": "insertRung", "along": "forth" },
        ]);
        let (_, mut boards) = drawn(
            "",
            &if value == "T1" && what == "contact" {
                timer
            } else {
                json!([])
            },
        );
        let mut act = |act: Value| {
            let request = json!({ "ask": "edit", "act": act, "width": 64 });
            told(&mut boards, request)
        };
        act(json!({ "do": "insert", "what": what, "place": "behind" }));
        let mut fields = vec![json!({ "key": key, "value": value })];
        if key == "line0" {
            let point = if what == "ton" { "M1" } else { "C1" };
            fields.push(json!({ "key": "point", "value": point }));
        }
        let told = act(json!({ "do": "edit", "fields": fields }));
        match wanted {
            Ok(line) => {
                act(json!({ "do": "insert", "what": "coil", "place": "behind" }));
                let view =
                    act(json!({ "do": "edit", "fields": [{ "key": "point", "value": "Q2" }] }));
                let text = view["ok"]["text"].as_str().unwrap_or_default();
                assert!(text.contains(line), "{what} {value}: {told} {view}");
            }
            Err((field, offer)) => {
                assert_eq!(told["error"]["field"], field, "{what} {value}: {told}");
                let first = told["error"]["offers"][0]["value"].as_str();
                assert_eq!(first.unwrap_or_default(), offer, "{what} {value}: {told}");
            }
        }
    }
}

/// It resets or loads one that counts: an output would make another coil of it.
#[test]
fn the_coil_of_a_counter_is_offered_no_output() {
    let point = |value| json!({ "do": "edit", "fields": [{ "key": "point", "value": value }] });
    let (_, mut boards) = drawn(
        "",
        &json!([
            { "do": "insert", "what": "ctu", "place": "behind" }, point("C1"),
            { "do": "insertRung", "along": "forth" },
            { "do": "insert", "what": "reset", "place": "behind" }, point("C1"),
        ]),
    );
    let request = json!({ "ask": "edit", "act": point("parts"), "width": 64 });
    let told = told(&mut boards, request);
    assert_eq!(told["error"]["field"], "point", "{told}");
    assert_eq!(told["error"]["offers"], Value::Null, "{told}");
}

#[test]
fn a_system_marker_is_taken_by_a_person_who_is_sure_and_by_a_log() {
    let insert = json!({ "do": "insert", "what": "contact", "place": "behind" });
    let fields = json!([{ "key": "point", "value": "S1" }]);
    let (_, mut boards) = drawn("", &json!([insert]));
    let act = json!({ "do": "edit", "fields": fields, "sure": true });
    let request = json!({ "ask": "edit", "act": act, "width": 64 });
    assert_ne!(told(&mut boards, request)["ok"], Value::Null);
    // A log of an earlier version does not say so.
    drawn("", &json!([insert, { "do": "edit", "fields": fields }]));
    let name = json!({ "do": "name", "point": "S2", "name": "liga", "comment": "" });
    let request = json!({ "ask": "edit", "act": name, "width": 64 });
    assert_eq!(told(&mut boards, request)["error"]["field"], "point");
}

#[test]
fn each_exercise_begins_as_an_empty_drawing_with_its_names() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/exercises");
    let mut seen = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "toml") {
            continue;
        }
        let scenario = fs::read_to_string(&path).unwrap();
        let sheet = ok(json!({ "ask": "sheet", "scenario": scenario, "title": "a" }));
        for text in [&sheet["begin"]["en"], &sheet["begin"]["pt"]] {
            let checked = ok(json!({ "ask": "check", "name": "a.il", "text": text }));
            assert_eq!(checked["blank"], true, "{}: {text}", path.display());
            let (view, _) = drawn(text.as_str().unwrap(), &json!([]));
            let table = view["table"].as_array().unwrap();
            for point in sheet["names"].as_object().unwrap().keys() {
                let has = |row: &Value| row["point"] == *point && row["name"] != "";
                // A PWM output has no name of its own.
                let is_pwm = point.starts_with('P');
                assert!(
                    is_pwm || table.iter().any(has),
                    "{}: {point}\n{text}",
                    path.display()
                );
            }
            assert_eq!(view["text"], *text);
        }
        seen += 1;
    }
    assert_eq!(seen, 51);
}

#[test]
fn a_contact_after_a_coil_keeps_the_names_and_is_told() {
    let text = "VAR\n    start AT I1 : BOOL;\n    stop AT I2 : BOOL;\n    spare AT I3 : BOOL; (* later *)\n    motor AT Q1 : BOOL;\nEND_VAR\n\nLD    start\nST    motor\n";
    let acts = json!([
        { "do": "move", "to": "right" }, { "do": "move", "to": "right" },
        { "do": "insert", "what": "contact", "place": "behind" },
        { "do": "edit", "fields": [{ "key": "point", "value": "stop" }] },
    ]);
    let (view, _) = drawn(text, &acts);
    let written = view["text"].as_str().unwrap();
    assert!(
        written.contains("LD    start\nST    motor\nCODE 827302 "),
        "{written}"
    );
    assert_eq!(view["mistakes"][0]["error"], false);
    let checked = ok(json!({ "ask": "check", "name": "a.il", "text": written }));
    let told: Vec<&str> = checked["problems"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["number"].as_str().unwrap())
        .collect();
    // The third one is declared, and nothing reads it.
    assert_eq!(told, ["IL-63"]);
    let (again, _) = drawn(written, &json!([]));
    assert_eq!(again["table"], view["table"]);
    assert_eq!(again["table"].as_array().unwrap().len(), 4);
}
