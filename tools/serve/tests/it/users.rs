//! Users of a site: each with a token of its own, and as much as its role says.

use crate::alarms::{of, site};
use crate::common::{Visitor, http};
use crate::site::{More, Site};
use serde_json::json;
use std::net::SocketAddr;
use unoclp_modbus::client::Request;
use unoclp_serve::{Guard, Users};
use unoclp_site::{Role, Secret, User};

/// Ana, Eva and Rui, who may do more one after the other, and their tokens.
pub fn users() -> (Guard, [String; 3]) {
    let made = ["ana", "eva", "rui"].map(|name| (name, unoclp_key::make(name).unwrap()));
    let users = made.iter().zip(Role::ALL).map(|((name, made), role)| User {
        name: (*name).into(),
        role,
        key: Secret(made.key.clone()),
    });
    let users = Users::new(users.collect()).unwrap();
    (Guard::Users(users), made.map(|(_, made)| made.token))
}

fn status(page: SocketAddr, path: &str, token: &str) -> u16 {
    let head = format!("Host: {page}\r\nAuthorization: Bearer {token}\r\n");
    of(&http(page, path, &head)).0
}

#[test]
fn each_user_does_as_much_as_its_role_says_and_it_is_recorded() {
    let (guard, [ana, eva, rui]) = users();
    let (site, _folder) = site(Some(guard));
    let visitor = |token: &str, told: &str| {
        let (visitor, said) = Visitor::new_at(site.page, "/line/one", token);
        assert_eq!(said, told);
        visitor
    };
    let stop = Request::write_word(3, 400, 2);
    let upload = Request::write_word(3, 400, 5);
    let settings = Request::write_word(3, 411, 1);
    let set = Request::write_words(3, 2000, &[0, 5]).unwrap();
    let mut watches = visitor(
        &ana,
        r#"{"address":3,"may":"watch","name":"one","role":"watch","user":"ana"}"#,
    );
    assert_eq!(watches.ask(&stop), [3, 0x86, 1]);
    let mut operates = visitor(
        &eva,
        r#"{"address":3,"may":"operate","name":"one","role":"control","user":"eva"}"#,
    );
    assert_eq!(operates.ask(&upload), [3, 0x86, 1]);
    assert_eq!(operates.ask(&settings), [3, 0x86, 1]);
    assert_eq!(operates.ask(&stop)[1], 6);
    assert_eq!(operates.ask(&set)[1], 16);
    drop(operates);
    let mut engineers = visitor(
        &rui,
        r#"{"address":3,"may":"engineer","name":"one","role":"control","user":"rui"}"#,
    );
    // The server knows a moment later that nobody else controls.
    while engineers.ask(&upload) == [3, 0x86, 6] {}
    let record = site.record.as_ref().unwrap();
    record.end();
    let head = format!("Host: {}\r\nAuthorization: Bearer {ana}\r\n", site.page);
    let (_, deeds) = of(&http(site.page, "/api/deeds", &head));
    let told: Vec<_> = deeds
        .as_array()
        .unwrap()
        .iter()
        .map(|deed| ["who", "from", "of", "what", "detail"].map(|key| deed[key].as_str().unwrap()))
        .collect();
    assert_eq!(
        told,
        [
            ["eva", "127.0.0.1", "one", "stop", ""],
            ["eva", "127.0.0.1", "one", "write", "register 2000 = 0 5"],
            ["rui", "127.0.0.1", "one", "upload", ""],
        ]
    );
}

#[test]
fn a_token_is_tried_a_few_times_and_those_that_are_known_go_on() {
    let (guard, [ana, eva, _]) = users();
    let more = More {
        guard: Some(guard),
        ..More::default()
    };
    let site = Site::with(Vec::new(), more);
    assert_eq!(status(site.page, "/health", &ana), 200);
    // What cannot be a token is no try.
    for _ in 0..20 {
        assert_eq!(status(site.page, "/health", ""), 401);
    }
    for wrong in [
        format!("{ana}0"),
        ana.replace("ana", "eva"),
        "nobody.0".into(),
        format!("{eva}x"),
        "ANA.x".into(),
    ] {
        assert_eq!(status(site.page, "/health", &wrong), 401, "{wrong}");
    }
    assert_eq!(status(site.page, "/health", "ana.0"), 429);
    assert_eq!(status(site.page, "/health", &eva), 429, "not now");
    assert_eq!(status(site.page, "/health", &ana), 200);
    let mut late = Visitor::silent(site.page);
    late.send("ana.0");
    assert_eq!(late.farewell(), "too many tries");
    let (_, told) = Visitor::new_at(site.page, "/line/two", &ana);
    assert!(told.contains(r#""user":"ana""#), "{told}");
}

#[test]
fn no_answer_is_kept_framed_or_taken_for_something_else() {
    let (guard, [ana, ..]) = users();
    let (site, _folder) = site(Some(guard));
    let host = format!("Host: {}\r\n", site.page);
    let with = format!("{host}Authorization: Bearer {ana}\r\n");
    for path in [
        "/health",
        "/metrics",
        "/api/alarms",
        "/api/deeds.csv",
        "/api/history?board=x&point=y",
    ] {
        for (head, status) in [(&with, None), (&host, Some(401))] {
            let answer = http(site.page, path, head);
            let told = of(&answer).0;
            assert!(status.is_none_or(|status| status == told), "{path}: {told}");
            for header in [
                "cache-control: no-store",
                "x-content-type-options: nosniff",
                "referrer-policy: no-referrer",
                "content-security-policy: default-src 'none'; frame-ancestors 'none'",
            ] {
                assert!(answer.contains(header), "{path}: {header}\n{answer}");
            }
        }
    }
    // A token in an address, where servers log it, is none.
    let answer = http(site.page, &format!("/health?token={ana}"), &host);
    assert_eq!(of(&answer), (401, json!(null)));
}
