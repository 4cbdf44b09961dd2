//! The broker of a site file: where it is, and what is reported to it.

use crate::grants::grants;
use crate::keys::{At, Keys};
use crate::mistake::Wrong;
use crate::site::{Grant, Line};
use std::fmt;
use std::time::Duration;

/// How often all values are told again, unless the file says otherwise.
const EVERY: Duration = Duration::from_secs(60);
const EXAMPLE: &str = "{ broker = \"mqtt://10.0.0.7:1883\" }";
const BROKER: &str = "\"mqtts://broker.example:8883\"";
const GROUP: &str = "{ group = \"lab\" }";

/// What is reported over MQTT.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mqtt {
    /// To whom.
    pub broker: Broker,
    /// As which user; without one, as nobody.
    pub user: Option<String>,
    /// The user's password.
    pub password: Option<Secret>,
    /// The file of the certificate that signs the broker's, in PEM; without it, those that the system trusts.
    pub ca: Option<String>,
    /// The topic above all others; no other gateway at this broker has it.
    pub topic: String,
    /// How often every value is told again.
    pub every: Duration,
    /// Whether Home Assistant is told which boards there are.
    pub home_assistant: bool,
    /// The edge node that is reported as Sparkplug B too, if one is.
    pub sparkplug: Option<Sparkplug>,
    /// What may be written; nothing else is.
    pub write: Vec<Grant>,
}

/// Where a broker is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Broker {
    /// Its name or address.
    pub host: String,
    /// Its port.
    pub port: u16,
    /// Whether the connection is encrypted.
    pub tls: bool,
}

/// An edge node of Sparkplug B; its devices are the boards.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sparkplug {
    /// Its group.
    pub group: String,
    /// Its name, which no other node of the group has.
    pub node: String,
    /// The host application without which nothing is reported, if there is one.
    pub host: Option<String>,
}

/// A text that is not shown.
#[derive(Clone, PartialEq, Eq)]
pub struct Secret(pub String);

impl fmt::Debug for Secret {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Secret")
    }
}

impl fmt::Display for Broker {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Broker { host, port, tls } = self;
        let scheme = if *tls { "mqtts" } else { "mqtt" };
        match host.contains(':') {
            true => write!(f, "{scheme}://[{host}]:{port}"),
            false => write!(f, "{scheme}://{host}:{port}"),
        }
    }
}

impl Broker {
    /// Whether it is at this PC.
    pub fn is_here(&self) -> bool {
        let address = self.host.parse::<std::net::IpAddr>();
        self.host == "localhost" || address.is_ok_and(|address| address.is_loopback())
    }

    /// The broker of this text; none of what is none.
    fn of(text: &str) -> Option<Broker> {
        let (scheme, rest) = text.split_once("://")?;
        let (tls, usual) = match scheme {
            "mqtt" => (false, 1883),
            "mqtts" => (true, 8883),
            _ => return None,
        };
        let rest = rest.strip_suffix('/').unwrap_or(rest);
        let (host, port) = match rest.strip_prefix('[') {
            // An address of IPv6.
            Some(rest) => rest.split_once(']')?,
            None => rest.split_at(rest.find(':').unwrap_or(rest.len())),
        };
        let port = match port.strip_prefix(':') {
            Some(port) => port.parse().ok().filter(|&port| port > 0)?,
            None if port.is_empty() => usual,
            None => return None,
        };
        let may_be = |ch: char| ch.is_ascii_alphanumeric() || "-._:".contains(ch);
        let is_host = !host.is_empty() && host.chars().all(may_be);
        is_host.then(|| Broker {
            host: host.to_owned(),
            port,
            tls,
        })
    }
}

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
    ];
    let mqtt = keys.table("mqtt", EXAMPLE, &known)?;
    let boards: Vec<_> = lines.iter().flat_map(|line| &line.boards).collect();
    let write = grants(&mqtt, &boards);
    let topic = name(&mqtt, "topic", "\"unoclp\"").unwrap_or_else(|| "unoclp".to_owned());
    let sparkplug = sparkplug(&mqtt, &topic);
    let every = mqtt.time("every", "\"1m\"", ["1s", "1d"]);
    let home_assistant = mqtt.flag("home_assistant").is_some_and(|flag| flag.value);
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
    let table = mqtt.table("sparkplug", GROUP, &["group", "node", "host"])?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broker_is_a_scheme_a_host_and_a_port() {
        for (text, told, here) in [
            ("mqtt://localhost", "mqtt://localhost:1883", true),
            ("mqtts://a.b-c", "mqtts://a.b-c:8883", false),
            ("mqtts://10.0.0.7:1/", "mqtts://10.0.0.7:1", false),
            ("mqtt://[::1]:7", "mqtt://[::1]:7", true),
            ("mqtt://[::1]", "mqtt://[::1]:1883", true),
        ] {
            let broker = Broker::of(text).expect(text);
            assert_eq!((&*broker.to_string(), broker.is_here()), (told, here));
        }
        for text in [
            "",
            "localhost",
            "http://a",
            "mqtt://",
            "mqtt://:1883",
            "mqtt://a:0",
            "mqtt://a:65536",
            "mqtt://a:b",
            "mqtt://u:p@a",
            "mqtt://a/b",
            "mqtt://[::1",
            "mqtt://[::1]7",
        ] {
            assert_eq!(Broker::of(text), None, "{text}");
        }
    }
}
