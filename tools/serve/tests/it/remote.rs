//! Boards behind a Modbus TCP server, which is a gateway too.

use crate::common::Visitor;
use crate::site::{LISTEN, Site, register};
use unoclp_modbus::client::Request;
use unoclp_serve::{Absent, Line, Remote};

/// What is told of a board behind a server, in a word.
fn told(_: &str, why: Absent) -> String {
    match why {
        Absent::Unreached(_) => "unreached".into(),
        Absent::Silent(address) => format!("silent {address}"),
        Absent::Foreign(_) => "foreign".into(),
    }
}

#[test]
fn a_line_may_be_another_gateway() {
    let near = Site::new(vec![register(0, None)]);
    let server = near.modbus.to_string();
    // Its units are the addresses here.
    let lines = Line::begin_shared(Remote::new(server, told), &[1, 2]);
    let far = Site::of(
        near.boards.clone(),
        lines,
        vec![register(0, None)],
        None,
        None,
    );
    near.boards.board(4).inputs = 0x42;
    assert_eq!(far.ask(2, &[2, 0, 0, 0, 8]), [2, 1, 0x42]);
    assert_eq!(
        far.ask(1, &[16, 0, 0, 0, 2, 4, 0, 1, 0, 5]),
        [16, 0, 0, 0, 2]
    );
    assert_eq!(near.ask(1, &[3, 0, 0, 0, 2]), [3, 4, 0, 1, 0, 5]);
    // A person at the far one is a machine to the near one.
    let mut person = Visitor::at(far.page, "/line/one", "");
    assert_eq!(person.ask(&Request::write_word(1, 400, 2)), [1, 0x86, 1]);
    // A board that is gone there is silent here.
    near.boards.unplug(true);
    while far.ask(1, &[3, 0, 0, 0, 1]) != [0x83, 0x0B] {}
    near.boards.unplug(false);
    while far.ask(1, &[3, 0, 0, 0, 1])[0] != 3 {}
}

#[test]
fn a_board_that_is_not_behind_a_server_is_told_why() {
    use unoclp_serve::Board;
    let site = Site::new(Vec::new());
    let find = |server: String, address| Remote::new(server, told).find(address);
    let server = site.modbus.to_string();
    assert_eq!(find(server.clone(), 1), Ok(()));
    assert_eq!(find(server.clone(), 9), Err("silent 9".into()));
    site.boards.board(3).identity = ["ACME", "Meter", "3"];
    // The answer of a moment ago serves for 50 ms.
    while find(server.clone(), 1) != Err("foreign".into()) {}
    let page = site.page.to_string();
    assert_eq!(
        find(page, 1),
        Err("unreached".into()),
        "it speaks something else"
    );
    let free = std::net::TcpListener::bind(LISTEN)
        .unwrap()
        .local_addr()
        .unwrap();
    assert_eq!(find(free.to_string(), 1), Err("unreached".into()));
}
