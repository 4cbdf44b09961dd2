//! `unoclp serve`, with the page inside: it is built before (`cargo xtask lab --build`).
#![cfg(unix)]

#[path = "../../report/tests/it/broker.rs"]
#[allow(dead_code, reason = "each test uses its part")]
mod broker;
#[path = "../../history/tests/it/server.rs"]
#[allow(dead_code, reason = "each test uses its part")]
mod database;
#[path = "it/pty.rs"]
#[allow(unused_imports, reason = "each test uses its part")]
mod pty;

#[path = "serve/astray.rs"]
mod astray;
#[path = "serve/mega.rs"]
mod mega;
#[path = "serve/steps.rs"]
mod steps;

use broker::{Broker, Listener};
use pty::{Board, Fake};
use std::io::{BufRead, BufReader, Lines, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, ChildStdout, Command, Stdio};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};
use unoclp_modbus::client::{Reply, Request};

/// A server, what it has not said yet, and where it is.
struct Server {
    child: Child,
    says: Lines<BufReader<ChildStdout>>,
    address: String,
}

impl Server {
    fn new(http: &str, more: &[&str]) -> Server {
        Server::of(unoclp(http).args(more))
    }

    fn of(command: &mut Command) -> Server {
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let says = BufReader::new(child.stdout.take().unwrap()).lines();
        // From here on it ends with the test, whatever it says.
        let mut server = Server {
            child,
            says,
            address: String::new(),
        };
        let mut said = Vec::new();
        // A board may be told of before the page: its line is opened meanwhile.
        while server.address.is_empty() {
            let line = server.says.next().unwrap_or_else(|| panic!("{said:?}"));
            said.push(line.unwrap());
            let last = said.last().unwrap();
            let Some((_, address)) = last.split_once("://") else {
                continue;
            };
            let (address, fragment) = address.split_once('/').unwrap();
            assert!(["", "#board"].contains(&fragment), "{said:?}");
            server.address = address.into();
        }
        server
    }

    fn line(&mut self) -> String {
        let line = self.says.next().unwrap().unwrap();
        match line.starts_with("all boards: ") {
            true => self.line(),
            false => line,
        }
    }

    fn visitor(&self, token: &str) -> WebSocket<TcpStream> {
        self.visitor_of("", token)
    }

    fn visitor_of(&self, board: &str, token: &str) -> WebSocket<TcpStream> {
        let port = self.address.rsplit_once(':').unwrap().1;
        let stream = TcpStream::connect(format!("127.0.0.1:{port}")).unwrap();
        let request = format!("ws://127.0.0.1:{port}/line{board}").into_client_request();
        let (mut socket, _) = tungstenite::client(request.unwrap(), stream).unwrap();
        socket.send(Message::text(token.to_owned())).unwrap();
        while socket.read().unwrap() != Message::text(r#"{"board":true}"#) {}
        socket
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn unoclp_site(file: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
    command.args(["serve", "--site", file]).env("LC_ALL", "C");
    command
}

fn unoclp(http: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
    command.args(["serve", "--http", http]).env("LC_ALL", "C");
    command
}

/// A site of these lines, whose page is at any port.
fn site(name: &str, lines: &str) -> String {
    let folder = env!("CARGO_TARGET_TMPDIR");
    let program = "PROGRAM p VAR lamp AT %QX0.0 : BOOL; END_VAR lamp := TRUE; END_PROGRAM\n";
    std::fs::write(format!("{folder}/lamp.st"), program).unwrap();
    let file = format!("{folder}/{name}.toml");
    let text =
        format!("[http]\nlisten = \"127.0.0.1:0\"\n[modbus]\nlisten = \"127.0.0.1:0\"\n{lines}");
    std::fs::write(&file, text).unwrap();
    file
}

/// What is answered at this path.
fn http(address: &str, path: &str) -> String {
    let mut stream = TcpStream::connect(address).unwrap();
    let head = format!("Host: {address}\r\nConnection: close\r\n");
    write!(stream, "GET {path} HTTP/1.1\r\n{head}\r\n").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

/// The same of one that brings something, with this token.
fn post(address: &str, path: &str, token: &str, body: &str) -> String {
    let mut stream = TcpStream::connect(address).unwrap();
    let length = body.len();
    let head = format!(
        "Host: {address}\r\nAuthorization: Bearer {token}\r\nContent-Length: {length}\r\nConnection: close\r\n"
    );
    write!(stream, "POST {path} HTTP/1.1\r\n{head}\r\n{body}").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

/// STOP by command (docs/modbus.md).
fn stop() -> Request {
    Request::write_word(1, 400, 2)
}

/// The board's answer to a request.
fn ask<T>(
    socket: &mut WebSocket<TcpStream>,
    request: &Request,
    take: impl FnOnce(Reply<'_>) -> T,
) -> Option<T> {
    socket
        .send(Message::binary(request.bytes().to_vec()))
        .unwrap();
    match socket.read().unwrap() {
        Message::Binary(answer) => request.answer(&answer).unwrap().ok().map(take),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_page_comes_from_inside_the_program() {
    let server = Server::new("127.0.0.1:0", &[]);
    let mut stream = TcpStream::connect(&server.address).unwrap();
    let request = format!(
        "GET / HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n",
        server.address
    );
    stream.write_all(request.as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    assert!(answer.starts_with("HTTP/1.1 200 OK"), "{answer}");
    assert!(answer.contains("<html"), "{answer}");
}

#[test]
fn the_board_at_a_port_is_read_and_stopped_from_this_pc() {
    let fake = Fake::new(Board::default());
    let mut server = Server::new("127.0.0.1:0", &["--port", fake.path()]);
    let alone = format!("the board at {} is shared with this PC only", fake.path());
    assert_eq!(server.line(), alone);
    let mut visitor = server.visitor("");
    let product = ask(&mut visitor, &Request::identify(1), |reply| {
        reply.texts().nth(1).map(<[u8]>::to_vec)
    });
    assert_eq!(product.flatten().as_deref(), Some(&b"unoclp UNO"[..]));
    assert!(ask(&mut visitor, &stop(), |_| ()).is_some());
    assert_eq!(fake.board().state, pty::STOP);
}

#[test]
fn in_a_network_each_token_lets_do_its_own() {
    let fake = Fake::new(Board::default());
    let mut server = Server::new("0.0.0.0:0", &["--port", fake.path()]);
    let mut token = |begin: &str| {
        let line = server.line();
        let (before, token) = line.split_once("#board=").unwrap();
        assert!(before.starts_with(begin), "{line}");
        token.to_owned()
    };
    let [watch, control] = [token("to watch:   http://"), token("to control: http://")];
    assert!(ask(&mut server.visitor(&watch), &stop(), |_| ()).is_none());
    assert_ne!(fake.board().state, pty::STOP);
    assert!(ask(&mut server.visitor(&control), &stop(), |_| ()).is_some());
    assert_eq!(fake.board().state, pty::STOP);
}

/// In a real Chromium: what the page makes of a board that is shared.
#[test]
fn a_browser_watches_or_controls_the_board() {
    let visit = |address: &str, role: &str| {
        let visited = Command::new("node")
            .arg(concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/../../page/web/test/shared/visit.mjs"
            ))
            .args([address, role])
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&visited.stderr);
        assert!(visited.status.success(), "{role}: {said}");
    };
    let fake = Fake::new(Board::default());
    let here = Server::new("127.0.0.1:0", &["--port", fake.path()]);
    visit(&format!("http://{}/#board", here.address), "control");
    assert_eq!(fake.board().state, pty::STOP);
    drop(here);
    fake.board().state = pty::RUN;
    let mut open = Server::new("0.0.0.0:0", &["--port", fake.path()]);
    let watch = open.line().replace("to watch:   ", "");
    visit(&watch.replace("0.0.0.0", "127.0.0.1"), "watch");
    assert_eq!(fake.board().state, pty::RUN);
    drop(open);
    // The second board of a site, by its name.
    let lines = format!(
        "[[line]]\nport = \"/dev/none\"\n[[line.board]]\nname = \"none\"\nunit = 2\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"here\"\n",
        fake.path()
    );
    let of_site = Server::of(&mut unoclp_site(&site("browser", &lines)));
    visit(
        &format!("http://{}/#board/here", of_site.address),
        "control",
    );
    assert_eq!(fake.board().state, pty::STOP);
}

/// In a real Chromium: what the screens of a site make of a gateway.
#[test]
fn a_browser_operates_a_site_by_its_screens() {
    let fake = Fake::new(Board::default());
    fake.board().outputs = 4;
    let lines = format!(
        "[[panel]]\nfile = \"screens.panel.toml\"\n[history]\nstore = \"screens.db\"\n\
         [[alarm]]\nname = \"lit\"\nwhen = \"one.Q3\"\ntext = \"it is lit\"\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
        fake.path()
    );
    let file = site("screens", &lines);
    forget(&file);
    let panel = "[[item]]\nshow = \"switch\"\npoint = \"one.Q1\"\nlabel = { en = \"Lamp\", pt = \"Lâmpada\" }\n\
        [[item]]\nshow = \"button\"\npoint = \"one.Q2\"\nlabel = \"Horn\"\n";
    std::fs::write(file.replace(".toml", ".panel.toml"), panel).unwrap();
    let server = Server::of(&mut unoclp_site(&file));
    let address = format!("http://{}/site.html", server.address);
    let visited = Command::new("node")
        .arg(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../page/web/test/shared/site.mjs"
        ))
        .arg(address)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&visited.stderr);
    assert!(visited.status.success(), "{said}");
    assert_eq!(fake.board().outputs, 5);
}

#[test]
fn the_boards_of_a_site_are_served_each_by_its_name() {
    let [one, two] = [(); 2].map(|()| Fake::new(Board::default()));
    let lines = format!(
        "[[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nprogram = \"lamp.st\"\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"two\"\nunit = 2\n",
        one.path(),
        two.path()
    );
    let file = site("two_boards", &lines);
    let mut server = Server::of(&mut unoclp_site(&file));
    let told = server.line();
    assert_eq!(
        told,
        "board two: the same page with #board/two instead of #board"
    );
    let modbus = server.line().replace("Modbus TCP: ", "");
    let mut said = Vec::new();
    while said.len() < 3 {
        said.push(server.line());
    }
    said.sort();
    let other = "one: has a program other than lamp.st, so the names in that file do not apply; upload the file";
    assert_eq!(said, ["one: found", other, "two: found"]);
    assert!(ask(&mut server.visitor_of("/two", ""), &stop(), |_| ()).is_some());
    assert_eq!(two.board().state, pty::STOP);
    assert_ne!(one.board().state, pty::STOP);
    // STOP has no name, so it does not pass here.
    let mut client = TcpStream::connect(modbus).unwrap();
    client
        .write_all(&[0, 1, 0, 0, 0, 6, 1, 6, 0x01, 0x90, 0, 2])
        .unwrap();
    let mut answer = [0; 9];
    client.read_exact(&mut answer).unwrap();
    assert_eq!(answer[7..], [0x86, 1]);
}

#[test]
fn the_boards_of_a_line_are_served_over_tcp_too() {
    let board = |address: u16| {
        let mut board = Board::default();
        board.settings[0] = address;
        Fake::new(board)
    };
    let near = board(7);
    let lines = format!(
        "[[line]]\nport = {:?}\nrate = 115200\n[[line.board]]\nname = \"near\"\naddress = 7\nunit = 9\n",
        near.path()
    );
    let mut first = Server::of(&mut unoclp_site(&site("near", &lines)));
    let modbus = first.line().replace("Modbus TCP: ", "");
    let lines =
        format!("[[line]]\ntcp = {modbus:?}\n[[line.board]]\nname = \"far\"\naddress = 9\n");
    let second = Server::of(&mut unoclp_site(&site("far", &lines)));
    let mut visitor = second.visitor_of("/far", "");
    let product = ask(&mut visitor, &Request::identify(9), |reply| {
        reply.texts().nth(1).map(<[u8]>::to_vec)
    });
    assert_eq!(product.flatten().as_deref(), Some(&b"unoclp UNO"[..]));
}

#[test]
fn what_a_board_was_is_kept_and_printed() {
    let fake = Fake::new(Board::default());
    fake.board().outputs = 4;
    let lines = format!(
        "[history]\nstore = \"kept.db\"\n[[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
        fake.path()
    );
    let file = site("kept", &lines);
    forget(&file);
    let server = Server::of(&mut unoclp_site(&file));
    let printed = |point: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
        let output = command
            .args(["site", "history", &file, point])
            .env("LC_ALL", "C")
            .output()
            .unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    // It is written together with what comes within a second.
    while !printed("one.Q3").ends_with(",1,1,1\n") {}
    fake.board().outputs = 0;
    while !printed("one.Q3").ends_with(",0,0,0\n") {}
    assert_eq!(
        printed("one.Q3")
            .lines()
            .filter(|line| line.ends_with(",1,1,1"))
            .count(),
        1
    );
    assert!(printed("one.Q1").ends_with(",0,0,0\n"));
    // The same over HTTP.
    let csv = http(
        &server.address,
        "/api/history.csv?board=one&point=Q3&last=1h",
    );
    let (_, csv) = csv.split_once("\r\n\r\n").unwrap();
    assert_eq!(csv, printed("one.Q3"));
}

#[test]
fn a_broker_is_told_what_a_board_is_and_sets_what_the_site_names() {
    let mut broker = Broker::new();
    let fake = Fake::new(Board::default());
    fake.board().outputs = 4;
    let lines = format!(
        "[mqtt]\nbroker = \"mqtt://127.0.0.1:{}\"\nwrite = [\"one.Q1\"]\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
        broker.port,
        fake.path()
    );
    let listener = Listener::new(&broker, "unoclp/#");
    let mut server = Server::of(&mut unoclp_site(&site("mqtt", &lines)));
    listener.until("one/Q3", "\"v\":true");
    broker.publish("unoclp/one/Q1/set", b"true", &[]);
    listener.until("one/Q1", "\"v\":true");
    assert_eq!(fake.board().outputs, 5);
    broker.publish("unoclp/one/Q2/set", b"true", &[]);
    let refused = listener.next_at("$refused").text();
    assert_eq!(refused, r#"{"point":"Q2","why":"not allowed"}"#);
    let metrics = http(&server.address, "/metrics");
    assert!(metrics.contains("unoclp_mqtt_connected 1\n"), "{metrics}");
    let url = format!("mqtt://127.0.0.1:{}", broker.port);
    while server.line() != format!("{url}: connected") {}
    broker.kill();
    while !server
        .line()
        .starts_with(&format!("{url}: not reachable: "))
    {}
}

/// The signal that stops a service.
fn terminate(server: &Server) {
    let pid = server.child.id().to_string();
    let sent = Command::new("kill").args(["-TERM", &pid]).status();
    assert!(sent.unwrap().success());
}

/// The files that a site keeps are those of the last time, if there was one.
fn forget(file: &str) {
    for end in [
        "journal",
        "journal-wal",
        "db",
        "db-wal",
        "db-shm",
        "record",
        "record-wal",
        "record-shm",
    ] {
        let _ = std::fs::remove_file(file.replace("toml", end));
    }
}

#[test]
fn a_gateway_that_is_asked_to_end_says_goodbye_and_keeps_what_it_has_read() {
    let broker = Broker::new();
    let fake = Fake::new(Board::default());
    let lines = format!(
        "[history]\nstore = \"ends.db\"\n[journal]\nevery = \"1m\"\n[mqtt]\nbroker = \"mqtt://127.0.0.1:{}\"\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
        broker.port,
        fake.path()
    );
    let file = site("ends", &lines);
    forget(&file);
    let listener = Listener::new(&broker, "unoclp/$status");
    let mut server = Server::of(&mut unoclp_site(&file));
    assert_eq!(listener.next().text(), "online");
    // What is read first is committed at once, what comes after it not within a minute.
    while !http(&server.address, "/metrics").contains("unoclp_history_waiting 0\n") {}
    while http(&server.address, "/metrics").contains("unoclp_history_rows_total 0\n") {}
    fake.board().outputs = 4;
    while !http(&server.address, "/metrics")
        .contains("unoclp_point{board=\"one\",point=\"Q3\"} 1\n")
    {}
    terminate(&server);
    assert_eq!(listener.next().text(), "offline");
    assert!(server.child.wait().unwrap().success());
    while server.line() != "ended" {}
    let printed = Command::new(env!("CARGO_BIN_EXE_unoclp"))
        .args(["site", "history", &file, "one.Q3"])
        .output()
        .unwrap();
    let printed = String::from_utf8(printed.stdout).unwrap();
    assert!(
        printed.ends_with(",0,0,0\n") || printed.ends_with(",1,1,1\n"),
        "{printed}"
    );
    assert_eq!(printed.matches(",1,1,1\n").count(), 1, "{printed}");
}

#[test]
fn a_gateway_that_is_killed_again_and_again_loses_no_committed_sample() {
    let mut broker = Broker::new();
    let fake = Fake::new(Board::default());
    let lines = format!(
        "[history]\nstore = \"killed.db\"\n[mqtt]\nbroker = \"mqtt://127.0.0.1:{}\"\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"10ms\"\n",
        broker.port,
        fake.path()
    );
    let file = site("killed", &lines);
    forget(&file);
    broker.kill();
    let mut least = 0;
    for kill in 0..5_u16 {
        let server = Server::of(&mut unoclp_site(&file));
        let mut committed = 0;
        while committed < 20 {
            fake.board().outputs ^= 7;
            let metrics = http(&server.address, "/metrics");
            let line = metrics
                .lines()
                .find_map(|line| line.strip_prefix("unoclp_journal_samples_total "));
            committed = line.map_or(0, |count| count.parse::<u64>().unwrap());
        }
        least += committed;
        // Dropping it kills it (SIGKILL), while it goes on.
        drop(server);
        assert!(fake.board().outputs < 8, "kill {kill}");
    }
    // All of that is told in order once the broker is there, and the history has the same.
    broker.begin();
    let listener = Listener::new(&broker, "unoclp/one/+");
    let server = Server::of(&mut unoclp_site(&file));
    let mut numbers = Vec::new();
    while numbers.last() < Some(&least) {
        let heard = listener.next();
        let text = heard.text();
        let number = text
            .rsplit_once("\"n\":")
            .map(|(_, number)| number.trim_end_matches('}'));
        if !heard.retained
            && let Some(number) = number
        {
            numbers.push(number.parse::<u64>().unwrap());
        }
    }
    let first = numbers[0];
    assert!(
        numbers
            .iter()
            .copied()
            .eq(first..first + numbers.len() as u64),
        "{numbers:?}"
    );
    terminate(&server);
    drop(listener);
    let mut server = server;
    assert!(server.child.wait().unwrap().success());
    let mut rows = 0;
    for point in 1..=4 {
        let printed = Command::new(env!("CARGO_BIN_EXE_unoclp"))
            .args(["site", "history", &file, &format!("one.Q{point}")])
            .output()
            .unwrap();
        let printed = String::from_utf8(printed.stdout).unwrap();
        rows += printed.lines().skip(1).count() as u64;
        // A change is another value than before, but where the gateway began again.
        let values: Vec<&str> = printed
            .lines()
            .skip(1)
            .filter_map(|line| line.split(',').nth(3))
            .collect();
        let same = values.windows(2).filter(|pair| pair[0] == pair[1]).count();
        assert!(same <= 6, "{same} of {}", values.len());
    }
    assert!(rows > 20, "{rows}");
}

#[test]
fn a_history_moves_to_a_database_and_goes_on_there() {
    let database = database::Server::new();
    database.psql("postgres", "CREATE DATABASE plant");
    let fake = Fake::new(Board::default());
    let of = |store: &str| {
        let lines = format!(
            "[history]\nstore = \"{store}\"\n[[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
            fake.path()
        );
        site("moves", &lines)
    };
    let old = of("moves.db");
    forget(&old);
    let mut server = Server::of(&mut unoclp_site(&old));
    let has_rows = |server: &Server| {
        let metrics = http(&server.address, "/metrics");
        let is_there = |line: &str| metrics.lines().any(|of| of == line);
        !is_there("unoclp_history_rows_total 0") && is_there("unoclp_history_waiting 0")
    };
    while !has_rows(&server) {}
    let moving = |file: &str| {
        let from = old.replace("toml", "db");
        let output = Command::new(env!("CARGO_BIN_EXE_unoclp"))
            .args(["site", "move", file, &from])
            .env("LC_ALL", "C")
            .output()
            .unwrap();
        let said = [output.stdout, output.stderr].concat();
        (output.status.code(), String::from_utf8(said).unwrap())
    };
    let (code, said) = moving(&old);
    assert_eq!(code, Some(2));
    assert!(
        said.contains("keeps its history in a file; first name a database under [history]"),
        "{said}"
    );
    let new = of(&format!(
        "postgres://unoclp@127.0.0.1:{}/plant",
        database.port
    ));
    // Not while a gateway runs.
    let (code, said) = moving(&new);
    assert_eq!(code, Some(2));
    assert!(
        said.contains("another `unoclp serve` uses this journal"),
        "{said}"
    );
    terminate(&server);
    assert!(server.child.wait().unwrap().success());
    let (code, said) = moving(&new);
    assert_eq!(code, Some(0), "{said}");
    assert!(
        said.contains("/plant (points: 17, rows: 17); start unoclp serve again"),
        "{said}"
    );
    let count = || {
        database.psql(
            "plant",
            "SELECT count(*), count(DISTINCT (point, at, seq)) FROM unoclp.sample",
        )
    };
    let moved = count();
    let (code, said) = moving(&new);
    assert_eq!((code, count()), (Some(2), moved.clone()));
    assert!(said.contains("has samples of one."), "{said}");
    let mut server = Server::of(&mut unoclp_site(&new));
    while !has_rows(&server) {}
    let csv = http(&server.address, "/api/history.csv?board=one&point=Q3");
    assert!(
        csv.contains("time,least,most,last\r\n") || csv.contains("time,least,most,last\n"),
        "{csv}"
    );
    terminate(&server);
    assert!(server.child.wait().unwrap().success());
    assert_ne!(count(), moved);
}

#[test]
fn an_encrypted_page_is_known_by_its_certificate_which_stays() {
    let folder = env!("CARGO_TARGET_TMPDIR");
    let lines = "[[line]]\nport = \"/dev/none\"\n[[line.board]]\nname = \"one\"\n";
    let of = |tls: &str| {
        let file = site("encrypted", lines);
        let text = std::fs::read_to_string(&file).unwrap();
        std::fs::write(
            &file,
            text.replace("[modbus]", &format!("tls = {tls}\n[modbus]")),
        )
        .unwrap();
        file
    };
    for end in ["cert.pem", "key.pem"] {
        let _ = std::fs::remove_file(format!("{folder}/encrypted.{end}"));
    }
    let curl = |server: &Server, more: &[&str], path: &str| {
        let url = format!("https://{}{path}", server.address);
        let output = Command::new("curl")
            .args([
                "--silent",
                "--cacert",
                &format!("{folder}/encrypted.cert.pem"),
            ])
            .args(more)
            .arg(url)
            .output()
            .expect("`cargo xtask setup` brings curl");
        (
            output.status.success(),
            String::from_utf8_lossy(&output.stdout).into_owned(),
        )
    };
    let mut server = Server::of(&mut unoclp_site(&of("\"self-signed\"")));
    let sum = server.line();
    assert!(sum.starts_with("certificate: SHA-256 "), "{sum}");
    let (is_trusted, page) = curl(&server, &[], "/");
    assert!(is_trusted && page.contains("<html"), "{page}");
    let origin = |scheme: &str| format!("Origin: {scheme}://{}", server.address);
    let status = ["--write-out", "%{http_code}", "--output", "/dev/null"];
    for (scheme, code) in [("https", "200"), ("http", "403")] {
        let header = origin(scheme);
        let more = [&status[..], &["--header", &header]].concat();
        assert_eq!(curl(&server, &more, "/health").1, code, "{scheme}");
    }
    // What is not encrypted gets no answer, and holds up nobody.
    let mut plain = TcpStream::connect(&server.address).unwrap();
    plain
        .write_all(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
        .unwrap();
    let mut answer = Vec::new();
    let _ = plain.read_to_end(&mut answer);
    assert!(!answer.starts_with(b"HTTP"), "{answer:?}");
    drop(server);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let key = std::fs::metadata(format!("{folder}/encrypted.key.pem")).unwrap();
        assert_eq!(key.permissions().mode() & 0o777, 0o600);
    }
    // The same after a restart, by its files too.
    let files = "{ cert = \"encrypted.cert.pem\", key = \"encrypted.key.pem\" }";
    for tls in ["\"self-signed\"", files] {
        let mut again = Server::of(&mut unoclp_site(&of(tls)));
        assert_eq!(again.line(), sum);
    }
    let refused = unoclp_site(&of(
        "{ cert = \"encrypted.key.pem\", key = \"encrypted.key.pem\" }",
    ))
    .output();
    let refused = refused.unwrap();
    assert_eq!(refused.status.code(), Some(2));
    let said = String::from_utf8(refused.stderr).unwrap();
    assert!(
        said.contains("encrypted.key.pem contains no PEM certificate"),
        "{said}"
    );
}

#[test]
fn two_gateways_of_one_site_do_not_run_at_once() {
    let lines = "[history]\nstore = \"twice.db\"\n[[line]]\nport = \"/dev/none\"\n[[line.board]]\nname = \"one\"\n";
    let file = site("twice", lines);
    let _first = Server::of(&mut unoclp_site(&file));
    let second = unoclp_site(&file).output().unwrap();
    assert_eq!(second.status.code(), Some(2));
    let said = String::from_utf8(second.stderr).unwrap();
    assert!(
        said.contains("twice.journal: another `unoclp serve` uses this journal"),
        "{said}"
    );
}

#[test]
fn a_site_file_with_a_mistake_is_not_served() {
    let file = site("wrong", "[[line]]\nport = \"/dev/none\"\n");
    let refused = unoclp_site(&file).output().unwrap();
    assert_eq!(refused.status.code(), Some(1));
    let said = String::from_utf8(refused.stderr).unwrap();
    assert!(
        said.starts_with(&format!("{file}:5: this line has no boards;")),
        "{said}"
    );
}

#[test]
fn an_address_that_is_taken_is_told_with_what_to_do() {
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = taken.local_addr().unwrap().to_string();
    let refused = unoclp(&address).output().unwrap();
    assert_eq!(refused.status.code(), Some(2));
    let said = String::from_utf8(refused.stderr).unwrap();
    assert!(
        said.contains(&address) && said.contains("--http 127.0.0.1:0"),
        "{said}"
    );
}

/// A teacher's exercises and machines stand before those of the page, as they are at that moment; solutions stay at home.
#[test]
fn a_teachers_folder_stands_in_the_page() {
    let folder = format!("{}/own-exercises", env!("CARGO_TARGET_TMPDIR"));
    drop(std::fs::remove_dir_all(&folder));
    std::fs::create_dir(&folder).unwrap();
    let put = |name: &str, text: &str| std::fs::write(format!("{folder}/{name}"), text).unwrap();
    let programs = format!("{}/../../programs", env!("CARGO_MANIFEST_DIR"));
    let ours = |name: &str| std::fs::read_to_string(format!("{programs}/{name}")).unwrap();
    put("motor.toml", &ours("plants/motor.toml"));
    put(
        "welded.toml",
        &ours("exercises/find/01-motor.toml").replace("../../plants/", ""),
    );
    put("01-motor.il", &ours("exercises/find/01-motor.il"));
    let bell = "title = \"A bell of mine\"\nprogram = \"bell.st\"\nuntil = 5\n";
    put("bell.toml", bell);
    put(
        "bell.st",
        "PROGRAM secret VAR q AT %QX1 : BOOL; END_VAR q := TRUE; END_PROGRAM",
    );
    put("broken.toml", "until = [\n");
    put(
        "no-machine.toml",
        "title = \"x\"\nplant = \"gone.toml\"\nuntil = 5\n",
    );
    let mut command = unoclp("127.0.0.1:0");
    command
        .args(["--exercises", &folder])
        .stderr(Stdio::piped());
    let mut server = Server::of(&mut command);
    let mut told = BufReader::new(server.child.stderr.take().unwrap()).lines();
    let mut line = || told.next().unwrap().unwrap();
    assert!(line().contains("broken.toml:"));
    assert!(line().contains("gone.toml cannot be read"));
    assert!(line().ends_with("adds exercises (2) and machines (1)"));

    let page = http(&server.address, "/exercises.json");
    let place = |what: &str| {
        page.find(what)
            .unwrap_or_else(|| panic!("{what} is not there"))
    };
    let (own, find, first) = (place("own/bell"), place("own/welded"), place("01-contacts"));
    assert!(own < find && find < first);
    assert!(page.contains("\"language\":\"st\"") && !page.contains("PROGRAM secret"));
    // The program of a machine with a hidden fault is right, and given.
    assert!(page[find..first].contains("\"program\":{\"name\":\"01-motor.il\""));
    let machines = http(&server.address, "/machines.json");
    assert!(machines.contains("\"isOwn\":true"));
    assert!(machines.find("motor.toml") < machines.find("batch.toml"));

    // Files that have not changed are not read again; those that have are, with what stands beside them.
    assert!(http(&server.address, "/exercises.json").contains("A bell of mine"));
    put("bell.toml", &bell.replace("A bell of mine", "Both bells"));
    put("01-motor.il", "LD I1\nST Q1\n");
    let changed = http(&server.address, "/exercises.json");
    assert!(changed.contains("Both bells") && !changed.contains("A bell of mine"));
    assert!(changed.contains("LD I1\\nST Q1"));
    std::fs::remove_file(format!("{folder}/bell.toml")).unwrap();
    assert!(!http(&server.address, "/exercises.json").contains("own/bell"));
    put("bell.toml", &bell.replace("A bell of mine", "Two bells"));
    assert!(http(&server.address, "/exercises.json").contains("Two bells"));
    assert!(http(&server.address, "/index.html").contains("<title>"));

    let none = unoclp("127.0.0.1:0")
        .args(["--exercises", "/no/such/folder"])
        .output()
        .unwrap();
    let told = String::from_utf8(none.stderr).unwrap();
    assert!(
        !none.status.success() && told.contains("/no/such/folder cannot be read"),
        "{told}"
    );
}

/// A user of this name, as `unoclp site key` makes one: the token, and what the site file has.
fn user(name: &str, role: &str) -> (String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
    command.args(["site", "key", name, "--role", role]);
    let output = command.env("LC_ALL", "C").output().unwrap();
    let said = String::from_utf8(output.stdout).unwrap();
    let (token, of_file) = said.split_once("\n").unwrap();
    let (_, token) = token.rsplit_once(": ").unwrap();
    let (_, of_file) = of_file.split_once("\n\n").unwrap();
    (token.to_owned(), of_file.to_owned())
}

#[test]
fn an_alarm_outlasts_a_gateway_that_is_killed_and_who_acknowledged_it_is_known() {
    let broker = Broker::new();
    let fake = Fake::new(Board::default());
    let (ana, of_ana) = user("ana", "watch");
    let (eva, of_eva) = user("eva", "operate");
    let lines = format!(
        "[mqtt]\nbroker = \"mqtt://127.0.0.1:{}\"\n{of_ana}{of_eva}\
         [[alarm]]\nname = \"lit\"\nwhen = \"one.Q3\"\ntext = \"the lamp is on\"\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
        broker.port,
        fake.path()
    );
    let file = site("alarms", &lines);
    forget(&file);
    let listener = Listener::new(&broker, "unoclp/#");
    let acknowledge = |server: &Server, token: &str| {
        let path = "/api/alarms/acknowledge";
        let answer = post(&server.address, path, token, r#"{"alarm":"lit"}"#);
        answer.split(' ').nth(1).unwrap().to_owned()
    };
    let mut server = Server::of(&mut unoclp_site(&file));
    assert!(server.line().starts_with("users: http://"));
    listener.until("lit", r#""state":"normal""#);
    fake.board().outputs = 4;
    listener.until("lit", r#""state":"active""#);
    while server.line() != "alarm lit: the lamp is on" {}
    // Dropping it kills it (SIGKILL); it goes on as it was.
    drop(server);
    listener.until("$status", "offline");
    let server = Server::of(&mut unoclp_site(&file));
    listener.until("$status", "online");
    listener.until("lit", r#""state":"active""#);
    assert_eq!(acknowledge(&server, ""), "401");
    assert_eq!(acknowledge(&server, &ana), "403");
    assert_eq!(acknowledge(&server, &eva), "200");
    listener.until("lit", r#""state":"acknowledged""#);
    assert_eq!(acknowledge(&server, &eva), "409");
    drop(server);
    fake.board().outputs = 0;
    let mut server = Server::of(&mut unoclp_site(&file));
    listener.until("lit", r#""state":"normal""#);
    while server.line() != "alarm lit: cleared" {}
    terminate(&server);
    assert!(server.child.wait().unwrap().success());
    let server = Server::of(&mut unoclp_site(&file));
    let csv = |path: &str| {
        let mut stream = TcpStream::connect(&server.address).unwrap();
        let head = format!(
            "Host: {}\r\nAuthorization: Bearer {ana}\r\nConnection: close\r\n",
            server.address
        );
        write!(stream, "GET {path} HTTP/1.1\r\n{head}\r\n").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        let (_, csv) = answer.split_once("\r\n\r\n").unwrap();
        let rows = csv.lines().skip(1);
        let rows = rows.map(|row| row.split_once(',').unwrap().1.to_owned());
        rows.collect::<Vec<_>>()
    };
    let expected = [
        "lit,came,active,",
        "lit,acknowledged,acknowledged,eva",
        "lit,gone,normal,",
    ];
    assert_eq!(csv("/api/alarms/history.csv"), expected);
    assert_eq!(csv("/api/deeds.csv"), ["eva,127.0.0.1,lit,acknowledge,"]);
}

#[test]
fn an_alarm_is_acknowledged_over_a_broker_where_the_site_says_so() {
    let broker = Broker::new();
    let fake = Fake::new(Board::default());
    let lines = |acknowledge: &str| {
        format!(
            "[mqtt]\nbroker = \"mqtt://127.0.0.1:{}\"\n{acknowledge}\
             [[alarm]]\nname = \"lit\"\nwhen = \"one.Q3\"\ntext = \"the lamp is on\"\n\
             [[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
            broker.port,
            fake.path()
        )
    };
    let file = site("acknowledged", &lines(""));
    forget(&file);
    let listener = Listener::new(&broker, "unoclp/#");
    let acknowledge = || broker.publish("unoclp/$alarm/lit/acknowledge", b"true", &[]);
    fake.board().outputs = 4;
    let server = Server::of(&mut unoclp_site(&file));
    listener.until("lit", r#""state":"active""#);
    acknowledge();
    let refused = listener.next_at("$refused").text();
    assert_eq!(refused, r#"{"alarm":"lit","why":"not allowed"}"#);
    drop(server);
    // The state may have been told twice: only what comes after this is of the next gateway.
    listener.until("$status", "offline");
    site("acknowledged", &lines("acknowledge = true\n"));
    let server = Server::of(&mut unoclp_site(&file));
    listener.until("$status", "online");
    listener.until("lit", r#""state":"active""#);
    acknowledge();
    listener.until("lit", r#""state":"acknowledged""#);
    acknowledge();
    let refused = listener.next_at("$refused").text();
    assert_eq!(refused, r#"{"alarm":"lit","why":"nothing to acknowledge"}"#);
    let deeds = http(&server.address, "/api/deeds.csv");
    assert!(deeds.contains(",$mqtt,,lit,acknowledge,"), "{deeds}");
}

#[test]
fn a_port_that_is_gone_or_another_device_is_told_and_the_others_go_on() {
    let meter = Board {
        identity: ["ACME", "Meter", "3"],
        ..Board::default()
    };
    let [good, meter] = [Board::default(), meter].map(Fake::new);
    let paths = [
        good.path(),
        "/dev/ttyNone9",
        env!("CARGO_MANIFEST_DIR"),
        meter.path(),
    ];
    let names = ["good", "none", "folder", "meter"];
    let mut lines = String::new();
    for (at, (name, path)) in names.iter().zip(paths).enumerate() {
        let unit = at + 1;
        lines += &format!(
            "[[line]]\nport = {path:?}\n[[line.board]]\nname = \"{name}\"\nunit = {unit}\n"
        );
    }
    let mut server = Server::of(&mut unoclp_site(&site("ports", &lines)));
    let mut wanted = vec![
        ("good: found", ""),
        ("none: ", "/dev/ttyNone9"),
        ("folder: ", "is not a serial port"),
        ("meter: ", "does not run unoclp"),
    ];
    while !wanted.is_empty() {
        let line = server.line();
        wanted.retain(|(name, why)| !(line.starts_with(name) && line.contains(why)));
    }
}
