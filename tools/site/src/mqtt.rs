//! The table `mqtt` of a site file.

use crate::broker::{Broker, Secret, Sparkplug};
use crate::grants::grants;
use crate::keys::{At, Keys, time};
use crate::mistake::Wrong;
use crate::site::{Line, Mqtt};
use std::time::Duration;

/// How often all values are told again, unless the file says otherwise.
const EVERY: Duration = Duration::from_secs(60);
const EXAMPLE: &str = "{ broker = \"mqtt://10.0.0.7:1883\" }";
const BROKER: &str = "\"mqtts://broker.example:8883\"";
const GROUP: &str = "{ group = \"lab\" }";

/// The table `mqtt`, as far as it is right.
pub(crate) fn mqtt(keys: &Keys<'_>, lines: &[Line]) -> Option<Mqtt> {
    let known = [
        "broker",
        "user",
        "password",
        "ca",
        "topic",
        "every",
        "home_assistant",
        "sparkplug",
        "write",
        "acknowledge",
    ];
    let mqtt = keys.table("mqtt", EXAMPLE)?;
    mqtt.known(&known);
    let boards: Vec<_> = lines.iter().flat_map(|line| &line.boards).collect();
    let write = grants(&mqtt, &boards);
    let topic = name(&mqtt, "topic", "\"unoclp\"").unwrap_or_else(|| "unoclp".to_owned());
    let sparkplug = sparkplug(&mqtt, &topic);
    let every = time(&mqtt, "every", "\"1m\"", ["1s", "1d"]);
    let home_assistant = mqtt.flag("home_assistant").is_some_and(|flag| flag.value);
    let acknowledge = mqtt.flag("acknowledge").is_some_and(|flag| flag.value);
    let user = mqtt.text("user", "\"gateway\"");
    let password = mqtt.text("password", "\"…\"");
    if let (None, Some(At { place, .. })) = (&user, &password) {
        mqtt.notes.wrong(place, Wrong::NoUser);
    }
    let ca = mqtt.text("ca", "\"ca.pem\"");
    let broker = broker(&mqtt)?;
    if let (false, Some(At { place, .. })) = (broker.tls, &ca) {
        mqtt.notes.wrong(place, Wrong::CaWithoutTls);
    }
    Some(Mqtt {
        broker,
        user: user.map(|user| user.value),
        password: password.map(|password| Secret(password.value)),
        ca: ca.map(|ca| ca.value),
        topic,
        every: every.map_or(EVERY, |every| every.value),
        home_assistant,
        sparkplug,
        write,
        acknowledge,
    })
}

fn broker(mqtt: &Keys<'_>) -> Option<Broker> {
    let At { value, place } = mqtt.needed("broker", BROKER)?;
    let broker = Broker::of(&value);
    if broker.is_none() {
        // What holds a password is not repeated.
        let wrong = match value.contains('@') {
            true => Wrong::BrokerSecret,
            false => Wrong::NoBroker { given: value },
        };
        mqtt.notes.wrong(&place, wrong);
    }
    broker
}

fn sparkplug(mqtt: &Keys<'_>, topic: &str) -> Option<Sparkplug> {
    let table = mqtt.table("sparkplug", GROUP)?;
    table.known(&["group", "node", "host"]);
    let node = name(&table, "node", "\"room1\"");
    let host = name(&table, "host", "\"scada\"");
    table.needed("group", "\"lab\"")?;
    Some(Sparkplug {
        group: name(&table, "group", "\"lab\"")?,
        node: node.unwrap_or_else(|| topic.to_owned()),
        host,
    })
}

/// A part of a topic, if the key is there.
fn name(keys: &Keys<'_>, key: &'static str, example: &'static str) -> Option<String> {
    let At { value, place } = keys.text(key, example)?;
    let may_be = |ch: char| ch.is_ascii_alphanumeric() || "-_".contains(ch);
    if (1..=32).contains(&value.len()) && value.chars().all(may_be) {
        return Some(value);
    }
    let given = format!("{value:?}");
    keys.notes.wrong(&place, Wrong::NoTopic { key, given });
    None
}
