//! The steps of `docs/site.md`, one after the other, with its own files and commands: only ports and hosts are those of this test.

use crate::broker::Broker;
use crate::pty::{Board, Fake};
use crate::{Server, forget, post, site, unoclp_site};
use std::path::Path;
use std::process::Command;
use unoclp_client::diagnostics::Kept;
use unoclp_site::Files;

const PAGE: &str = include_str!("../../../../docs/site.md");
const PROGRAM: &str = include_str!("../../../../docs/site/estufa.st");

/// The blocks of the page in this language, of a part of it.
fn blocks<'p>(page: &'p str, language: &str) -> Vec<&'p str> {
    let fence = format!("```{language}\n");
    let blocks = page.split(&*fence).skip(1);
    blocks
        .filter_map(|block| block.split("```").next())
        .collect()
}

struct Folder;

impl Files for Folder {
    fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
        Ok(PROGRAM.into())
    }
}

/// How a board keeps the program of the page.
fn kept() -> Kept {
    let first = blocks(PAGE, "toml")[0];
    let site = unoclp_site::read(first, &Folder).unwrap();
    site.boards().next().unwrap().points.program.unwrap()
}

/// A board at this address.
fn board(address: u16) -> Board {
    let mut board = Board::default();
    board.settings[0] = address;
    board
}

/// Whether a command of the page ends well, what it prints, and what it says is wrong.
fn printed(command: &str) -> (bool, String, String) {
    let mut shell = Command::new("sh");
    let output = shell
        .args(["-c", command])
        .env("LC_ALL", "C")
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (
        output.status.success(),
        text(output.stdout),
        text(output.stderr),
    )
}

/// What a command of the page prints; it ends well.
fn run(command: &str) -> String {
    let (is_well, text, wrong) = printed(command);
    assert!(is_well, "{command}: {wrong}");
    text
}

#[test]
fn the_steps_of_the_page_are_done_one_after_the_other() {
    let steps = PAGE.split("## In steps").nth(1).unwrap();
    let steps = steps.split("\n## ").next().unwrap();
    let program = env!("CARGO_BIN_EXE_unoclp");
    let broker = Broker::new();
    let mut estufa = Board::default();
    (estufa.kept, estufa.outputs) = (kept(), 1);
    let [estufa, forno, bomba, far] = [estufa, board(1), board(11), board(1)].map(Fake::new);
    // The room down the corridor.
    let lines = format!(
        "[[line]]\nport = {:?}\n[[line.board]]\nname = \"there\"\n",
        far.path()
    );
    let mut room = Server::of(&mut unoclp_site(&site("steps_room", &lines)));
    let room_at = room.line().replace("Modbus TCP: ", "");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("steps");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let put = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    put("estufa.st", PROGRAM);
    put(
        "estufa.panel.toml",
        include_str!("../../../../docs/site/estufa.panel.toml"),
    );
    put(
        "estufa.svg",
        include_str!("../../../../docs/site/estufa.svg"),
    );
    let file = folder.join("site.toml");
    let file = file.to_str().unwrap();
    forget(file);
    // The key of the page is that of a token which nobody has.
    let made = run(&format!("{program} site key ana --role operate"));
    let token = made
        .split_whitespace()
        .find(|word| word.starts_with("ana."))
        .unwrap();
    let key = made
        .lines()
        .find(|line| line.starts_with("key = "))
        .unwrap();
    let here = |block: &str| {
        let block: Vec<&str> = block
            .lines()
            .map(|line| match line.starts_with("key = ") {
                true => key,
                false => line,
            })
            .collect();
        block
            .join("\n")
            .replace("/dev/ttyACM0", estufa.path())
            .replace("/dev/ttyACM1", forno.path())
            .replace("/dev/ttyUSB0", bomba.path())
            .replace("rate = 38400\nparity = \"even\"", "rate = 115200")
            .replace("10.0.0.7:1502", &room_at)
            .replace("0.0.0.0:1502", "127.0.0.1:0")
            .replace(
                "mqtts://broker.example",
                &format!("mqtt://127.0.0.1:{}", broker.port),
            )
    };
    let first = blocks(PAGE.split("## In steps").next().unwrap(), "toml");
    let mut text = String::new();
    // Each step makes a right file of the one before.
    for block in first.into_iter().chain(blocks(steps, "toml")) {
        text += &here(block);
        text.push('\n');
        put("site.toml", &text);
        let plan = run(&format!("{program} site check {file}"));
        assert!(plan.contains("board estufa"), "{plan}");
    }
    // Encrypted, as the page says; then as this test can read it.
    text = text.replace("0.0.0.0:8420", "127.0.0.1:0");
    put("site.toml", &text);
    let mut server = Server::of(&mut unoclp_site(file));
    assert!(server.line().contains("SHA-256"));
    drop(server);
    put("site.toml", &text.replace("tls = \"self-signed\"\n", ""));
    let mut server = Server::of(&mut unoclp_site(file));
    let mut wanted = vec![
        "estufa: found",
        "estufa: has estufa.st",
        "forno: found",
        "bomba: found",
        "lab2: found",
    ];
    // The page says so too.
    let words: Vec<&str> = PAGE.split_whitespace().collect();
    for told in &wanted[..2] {
        assert!(words.join(" ").contains(&format!("`{told}`")), "{told}");
    }
    while !wanted.is_empty() {
        let line = server.line();
        wanted.retain(|wanted| *wanted != line);
    }
    // The commands of the steps, but those that begin the gateway or need the system's PostgreSQL.
    let told = format!("127.0.0.1 -p {}", broker.port);
    let commands: Vec<String> = blocks(steps, "sh")
        .concat()
        .lines()
        .filter(|line| !line.starts_with("sudo"))
        .map(|line| {
            let line = line.split(" #").next().unwrap_or(line);
            let line = line
                .replace("broker.example", &told)
                .replace("site.toml", file);
            // It listens forever otherwise.
            let line = line.replace("mosquitto_sub", "mosquitto_sub -C 1 -W 60");
            line.replace("unoclp site", &format!("{program} site"))
        })
        .collect();
    assert!(commands.len() >= 4, "{commands:?}");
    let [changes, steps, hears, sets] = &commands[..] else {
        panic!("{commands:?}");
    };
    assert!(run(hears).starts_with("unoclp/"));
    let first = estufa.board().words.clone();
    while estufa.board().words == first {
        run(sets);
    }
    // It is written together with what comes within a second, the point itself too.
    while !printed(changes).1.ends_with(",25,25,25\n") {}
    assert!(run(steps).contains(",25"));
    // An alarm comes after five seconds, and who operates acknowledges it.
    run(&sets.replace("-m 25", "-m 81"));
    let alarms = PAGE.split("\n## Alarms").nth(1).unwrap();
    let asked = blocks(alarms, "sh")[0].replace("127.0.0.1:8420", &server.address);
    let asked = asked.replace(
        "curl ",
        &format!("curl -s -H 'Authorization: Bearer {token}' "),
    );
    let (state, acknowledges) = asked.split_once('\n').unwrap();
    while !run(state).contains(r#""name":"target-high","state":"active""#) {}
    assert_eq!(run(acknowledges.trim_end()), r#"{"state":"acknowledged"}"#);
    // The panel sets what it has, and nothing else.
    let set = |value: u32| {
        let body = format!(r#"{{"board":"estufa","point":"target","value":{value}}}"#);
        post(&server.address, "/api/write", token, &body)
    };
    assert!(set(30).ends_with(r#"{"value":30.0}"#));
    assert!(set(41).ends_with(r#"{"why":"no value"}"#));
}
