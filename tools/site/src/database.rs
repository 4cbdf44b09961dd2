//! Where a database of PostgreSQL is.

use std::fmt;

/// A database of PostgreSQL, and as whom a gateway comes to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Server {
    /// Its name or address.
    pub host: String,
    /// Its port.
    pub port: u16,
    /// The user.
    pub user: String,
    /// The database.
    pub database: String,
}

impl fmt::Display for Server {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Server {
            host,
            port,
            user,
            database,
        } = self;
        match host.contains(':') {
            true => write!(f, "postgres://{user}@[{host}]:{port}/{database}"),
            false => write!(f, "postgres://{user}@{host}:{port}/{database}"),
        }
    }
}

impl Server {
    /// Whether it is at this PC.
    pub fn is_here(&self) -> bool {
        let address = self.host.parse::<std::net::IpAddr>();
        self.host == "localhost" || address.is_ok_and(|address| address.is_loopback())
    }

    /// The database of this text; none of what is none.
    pub(crate) fn of(text: &str) -> Option<Server> {
        let rest = text
            .strip_prefix("postgres://")
            .or_else(|| text.strip_prefix("postgresql://"))?;
        let (user, rest) = rest.split_once('@')?;
        let (host, database) = rest.split_once('/')?;
        let (host, port) = match host.strip_prefix('[') {
            // An address of IPv6.
            Some(rest) => rest.split_once(']')?,
            None => host.split_at(host.find(':').unwrap_or(host.len())),
        };
        let port = match port.strip_prefix(':') {
            Some(port) => port.parse().ok().filter(|&port| port > 0)?,
            None if port.is_empty() => 5432,
            None => return None,
        };
        let is_name = |text: &str, more: &str| {
            let may_be = |ch: char| ch.is_ascii_alphanumeric() || more.contains(ch);
            !text.is_empty() && text.chars().all(may_be)
        };
        let is_right = is_name(user, "-_.") && is_name(host, "-._:") && is_name(database, "-_");
        is_right.then(|| Server {
            host: host.to_owned(),
            port,
            user: user.to_owned(),
            database: database.to_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_database_is_a_user_a_host_a_port_and_a_name() {
        for (text, told, here) in [
            (
                "postgres://me@localhost/plant",
                "postgres://me@localhost:5432/plant",
                true,
            ),
            (
                "postgresql://me@a.b-c:7/p_1",
                "postgres://me@a.b-c:7/p_1",
                false,
            ),
            ("postgres://me@[::1]:7/p", "postgres://me@[::1]:7/p", true),
            ("postgres://me@[::1]/p", "postgres://me@[::1]:5432/p", true),
        ] {
            let server = Server::of(text).expect(text);
            assert_eq!((&*server.to_string(), server.is_here()), (told, here));
        }
        for text in [
            "postgres://",
            "postgres://localhost/p",
            "postgres://me@/p",
            "postgres://me@a",
            "postgres://me@a/",
            "postgres://me@a:0/p",
            "postgres://me@a:b/p",
            "postgres://me:secret@a/p",
            "postgres://me@a/p?x=1",
            "postgres://me@[::1/p",
            "mysql://me@a/p",
        ] {
            assert_eq!(Server::of(text), None, "{text}");
        }
    }
}
