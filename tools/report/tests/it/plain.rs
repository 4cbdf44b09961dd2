//! Values, commands and availability, over a broker that is killed too.

use crate::broker::{Broker, Listener};
use crate::site::{HOT, Reporting, hot, site};
use unoclp_report::Refusal;

fn url(broker: &Broker) -> String {
    format!("mqtt://127.0.0.1:{}", broker.port)
}

const TANK: &[(&str, Option<f64>)] = &[
    ("level", Some(21.1)),
    ("target", Some(7.0)),
    ("valve", Some(1.0)),
];

#[test]
fn a_point_is_told_as_it_changes_and_kept_by_the_broker() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "#");
    let reporting = Reporting::new(&site(&url(&broker), ""), None, Ok(()));
    listener.until("unoclp/$status", "online");
    reporting.reporter.presence("tank", true);
    reporting.change("tank", TANK, 1_700_000_000_123);
    let mut said: Vec<_> = (0..4).map(|_| listener.next()).collect();
    said.sort_by(|a, b| a.topic.cmp(&b.topic));
    let said: Vec<_> = said
        .iter()
        .map(|heard| (&*heard.topic, heard.qos, heard.text()))
        .collect();
    let value = |text: &str| text.to_owned();
    assert_eq!(
        said,
        [
            ("unoclp/tank/$status", 1, value("online")),
            (
                "unoclp/tank/level",
                1,
                value(r#"{"v":21.1,"t":1700000000123,"q":"good","n":1}"#)
            ),
            (
                "unoclp/tank/target",
                1,
                value(r#"{"v":7,"t":1700000000123,"q":"good","n":2}"#)
            ),
            (
                "unoclp/tank/valve",
                1,
                value(r#"{"v":true,"t":1700000000123,"q":"good","n":3}"#)
            ),
        ]
    );
    reporting.change("tank", &[("level", None)], 1_700_000_000_200);
    assert_eq!(
        listener.next_at("/level").text(),
        r#"{"v":null,"t":1700000000200,"q":"bad","n":4}"#
    );
    // Whoever comes later is told all of it.
    let later = Listener::new(&broker, "unoclp/#");
    let kept: Vec<_> = (0..5).map(|_| later.next()).collect();
    assert!(kept.iter().all(|heard| heard.retained), "{kept:?}");
    // A goodbye that is meant says so too.
    drop(reporting);
    assert_eq!(listener.next_at("unoclp/$status").text(), "offline");
}

#[test]
fn what_a_broker_that_is_killed_has_not_taken_comes_after_in_order() {
    let mut broker = Broker::new();
    let reporting = Reporting::new(&site(&url(&broker), ""), None, Ok(()));
    reporting.until(|state| state.connected == 1);
    let count = |number: i32| {
        reporting.change("tank", &[("target", Some(number.into()))], number.into());
    };
    (0..200).for_each(count);
    broker.kill();
    (200..400).for_each(count);
    reporting.until(|state| state.connected == 0 && state.waiting >= 200);
    broker.begin();
    let listener = Listener::new(&broker, "unoclp/tank/target");
    // The broker has forgotten all: those after its end come in order, then the last one once more.
    let mut seen = Vec::new();
    while seen.last() != Some(&399) {
        let text = listener.next().text();
        let number: i32 = text["{\"v\":".len()..]
            .split(',')
            .next()
            .unwrap()
            .parse()
            .unwrap();
        seen.push(number);
    }
    let first = seen[0];
    assert!(first <= 200, "{first}");
    assert_eq!(seen, (first..400).collect::<Vec<_>>());
    assert_eq!(reporting.reporter.state().dropped, 0);
}

#[test]
fn what_waits_for_a_broker_outlasts_a_restart_of_the_gateway() {
    let mut broker = Broker::new();
    let of_site = site(&url(&broker), "");
    let mut reporting = Reporting::new(&of_site, None, Ok(()));
    let count = |reporting: &Reporting, from: i32| {
        for number in from..from + 300 {
            reporting.change("tank", &[("target", Some(number.into()))], number.into());
        }
    };
    count(&reporting, 0);
    while reporting.journal.state().committed < 300 {
        std::thread::yield_now();
    }
    reporting.until(|state| state.connected == 1 && state.waiting == 0);
    broker.kill();
    // Each time with more that nobody has heard.
    for from in [300, 600, 900] {
        count(&reporting, from);
        reporting = reporting.again(&of_site);
    }
    broker.begin();
    let listener = Listener::new(&broker, "unoclp/tank/target");
    let mut seen: Vec<(u64, u64)> = Vec::new();
    while seen.last() != Some(&(1199, 1200)) {
        let told: serde_json::Value = serde_json::from_str(&listener.next().text()).unwrap();
        seen.push((told["v"].as_u64().unwrap(), told["n"].as_u64().unwrap()));
    }
    // Whoever listens late hears the last that was kept first; then all in order, each with its number.
    let first = seen[0].0;
    assert!((300..=1199).contains(&first), "{first}");
    let all: Vec<(u64, u64)> = (first..1200).map(|number| (number, number + 1)).collect();
    assert_eq!(seen, all);
    reporting.until(|state| state.waiting == 0);
    assert_eq!(reporting.reporter.state().dropped, 0);
}

#[test]
fn a_gateway_that_is_killed_is_said_to_be_offline() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "unoclp/$status");
    // A client of ours that ends without a word has the same will; here a connection is cut.
    let (cut, through) = crate::tls::cut(broker.port);
    let reporting = Reporting::new(&site(&format!("mqtt://{through}"), ""), None, Ok(()));
    assert_eq!(listener.next().text(), "online");
    cut();
    assert_eq!(listener.next().text(), "offline");
    drop(reporting);
}

#[test]
fn a_command_is_carried_where_the_site_lets_it_and_refused_elsewhere() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "unoclp/+/$refused");
    let more = "write = [\"tank.target\", \"lamp.Q1\"]\n";
    // What the broker has kept is commanded by nobody now; once that is told, we are subscribed.
    broker.publish("unoclp/lamp/Q1/set", b"true", &["-r"]);
    let reporting = Reporting::new(&site(&url(&broker), more), None, Ok(()));
    let retained = r#"{"point":"Q1","why":"retained"}"#;
    assert_eq!(listener.next().text(), retained);
    for (topic, payload, refused) in [
        ("unoclp/tank/target/set", "41", None),
        ("unoclp/tank/target/set", "{\"v\":42}", None),
        ("unoclp/lamp/Q1/set", "false", None),
        ("unoclp/tank/target/set", "on", Some("no value")),
        ("unoclp/tank/target/set", "0.5", Some("out of range")),
        ("unoclp/tank/target/set", "3000000000", Some("out of range")),
        ("unoclp/lamp/Q1/set", "2", Some("out of range")),
        ("unoclp/tank/valve/set", "true", Some("not allowed")),
        ("unoclp/lamp/Q2/set", "true", Some("not allowed")),
        ("unoclp/tank/x/set", "true", Some("not allowed")),
    ] {
        broker.publish(topic, payload.as_bytes(), &[]);
        match refused {
            None => {
                let command = reporting.commands.recv().unwrap();
                let point = format!("unoclp/{}/{}/set", command.board, command.grant.point);
                assert_eq!(point, topic);
            }
            Some(why) => {
                let told = listener.next().text();
                assert!(
                    told.contains(&format!(r#""why":"{why}""#)),
                    "{payload}: {told}"
                );
            }
        }
    }
    assert!(reporting.commands.try_recv().is_err());
}

#[test]
fn who_has_sent_a_command_is_told_what_the_board_says() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "unoclp/+/$refused");
    let more = "write = [\"tank.target\"]\n";
    let outcome = Err(Refusal::Controlled);
    broker.publish("unoclp/tank/target/set", b"1", &["-r"]);
    let reporting = Reporting::new(&site(&url(&broker), more), None, outcome);
    assert!(listener.next().text().contains("retained"));
    broker.publish("unoclp/tank/target/set", b"2", &[]);
    let told = listener.next().text();
    assert_eq!(told, r#"{"point":"target","why":"controlled"}"#);
    assert_eq!(reporting.commands.recv().unwrap().value, 2.0);
}

#[test]
fn home_assistant_finds_boards_once_their_points_are_known_and_again_when_it_asks() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "homeassistant/device/#");
    let more = "home_assistant = true\nwrite = [\"tank.target\", \"tank.valve\"]\n";
    let reporting = Reporting::new(&site(&url(&broker), more), None, Ok(()));
    reporting.change("tank", TANK, 5);
    let config = listener.next();
    assert_eq!(config.topic, "homeassistant/device/unoclp_tank/config");
    let told: serde_json::Value = serde_json::from_str(&config.text()).unwrap();
    assert_eq!(told["o"]["name"], "unoclp");
    assert_eq!(told["dev"]["ids"][0], "unoclp_tank");
    assert_eq!(told["cmps"].as_object().unwrap().len(), 3);
    let platform = |point: &str| told["cmps"][point]["p"].as_str().unwrap().to_owned();
    assert_eq!(
        ["level", "target", "valve"].map(platform),
        ["sensor", "number", "switch"]
    );
    assert_eq!(
        told["cmps"]["target"]["command_topic"],
        "unoclp/tank/target/set"
    );
    assert_eq!(told["cmps"]["level"]["unique_id"], "unoclp_tank_level");
    let topics: Vec<_> = told["availability"].as_array().unwrap().iter().collect();
    assert_eq!(topics.len(), 2);
    broker.publish("homeassistant/status", b"online", &[]);
    assert_eq!(listener.next().text(), config.text());
    // The board keeps another program now: points have their own names, and those of before are removed.
    let own: Vec<(&str, Option<f64>)> = TANK
        .iter()
        .map(|(name, _)| (*name, None))
        .chain([("I1", Some(0.0)), ("Q1", Some(1.0))])
        .collect();
    reporting.change("tank", &own, 6);
    let told: serde_json::Value = serde_json::from_str(&listener.next().text()).unwrap();
    assert_eq!(told["cmps"]["level"], serde_json::json!({ "p": "sensor" }));
    assert_eq!(told["cmps"]["I1"]["p"], "binary_sensor");
}

#[test]
fn home_assistant_finds_alarms_as_problems_and_forgets_those_that_are_no_more() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "homeassistant/device/unoclp/#");
    // A site of before had another alarm.
    broker.publish("unoclp/$alarm/cold", b"{\"state\":\"normal\"}", &["-r"]);
    let more = format!("home_assistant = true\nacknowledge = true\n{HOT}");
    let reporting = Reporting::new(&site(&url(&broker), &more), None, Ok(()));
    let told = || -> serde_json::Value { serde_json::from_str(&listener.next().text()).unwrap() };
    let first = told();
    let problem = &first["cmps"]["hot"];
    assert_eq!(
        [
            &problem["p"],
            &problem["device_class"],
            &problem["state_topic"]
        ],
        ["binary_sensor", "problem", "unoclp/$alarm/hot"]
    );
    let button = &first["cmps"]["hot$acknowledge"];
    assert_eq!(
        [
            &button["p"],
            &button["command_topic"],
            &button["payload_press"]
        ],
        ["button", "unoclp/$alarm/hot/acknowledge", "true"]
    );
    let second = told();
    assert_eq!(
        second["cmps"]["cold"],
        serde_json::json!({ "p": "binary_sensor" })
    );
    assert_eq!(&second["cmps"]["hot"], problem);
    // What Home Assistant says where its button is pressed.
    broker.publish("unoclp/$alarm/hot/acknowledge", b"true", &[]);
    assert_eq!(reporting.acknowledged.recv().unwrap(), "hot");
}

#[test]
fn an_alarm_is_acknowledged_where_the_site_lets_it_and_refused_elsewhere() {
    for (more, outcome, sent) in [
        (
            "acknowledge = true\n",
            Err(Refusal::Nothing),
            &[
                ("hot", "0", "no value"),
                ("hot", "please", "no value"),
                ("cold", "true", "no alarm"),
                ("hot", "1", "nothing to acknowledge"),
            ][..],
        ),
        ("", Ok(()), &[("hot", "true", "not allowed")][..]),
    ] {
        let broker = Broker::new();
        let listener = Listener::new(&broker, "unoclp/$alarm/$refused");
        broker.publish("unoclp/$alarm/hot/acknowledge", b"true", &["-r"]);
        let of_site = site(&url(&broker), &format!("{more}{HOT}"));
        let reporting = Reporting::new(&of_site, None, outcome);
        reporting.reporter.alarm(&hot("active", 5));
        let refused = |alarm, why| format!(r#"{{"alarm":"{alarm}","why":"{why}"}}"#);
        assert_eq!(listener.next().text(), refused("hot", "retained"));
        for (alarm, payload, why) in sent {
            let topic = format!("unoclp/$alarm/{alarm}/acknowledge");
            broker.publish(&topic, payload.as_bytes(), &[]);
            assert_eq!(listener.next().text(), refused(alarm, why), "{payload}");
        }
        assert_eq!(reporting.acknowledged.try_recv().is_ok(), outcome.is_err());
    }
}
