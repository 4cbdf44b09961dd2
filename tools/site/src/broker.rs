//! Where a broker is, and as what a gateway comes to it.

use std::fmt;

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
    pub(crate) fn of(text: &str) -> Option<Broker> {
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
