//! From which pages a browser may reach the gateway.
//!
//! A browser lets every page open a WebSocket to every host, and says in `Origin` which page does. So that no foreign page
//! drives the board through somebody's browser, the page must be ours: of the host that the request itself names. On
//! 127.0.0.1, where no token is asked for, that host must be this PC too, or a foreign name could be made to point here.

use axum::http::header::{HOST, ORIGIN};
use axum::http::{HeaderMap, HeaderName};

/// A way to the gateway.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Door {
    /// Only this PC is served.
    pub is_local: bool,
    /// Connections are encrypted.
    pub is_tls: bool,
}

/// Whether a request with these headers may pass.
pub(crate) fn lets_in(headers: &HeaderMap, door: Door) -> bool {
    let Some(host) = one(headers, HOST) else {
        return false;
    };
    if door.is_local && !is_this_pc(host) {
        return false;
    }
    let scheme = if door.is_tls { "https://" } else { "http://" };
    // Other programs than browsers send none.
    match headers.get_all(ORIGIN).iter().count() {
        0 => true,
        1 => one(headers, ORIGIN).and_then(|origin| origin.strip_prefix(scheme)) == Some(host),
        _ => false,
    }
}

/// The header that may be there once.
fn one(headers: &HeaderMap, name: HeaderName) -> Option<&str> {
    let mut all = headers.get_all(name).iter();
    match (all.next(), all.next()) {
        (Some(value), None) => value.to_str().ok(),
        _ => None,
    }
}

/// Whether this is `localhost`, 127.0.0.1 or [::1], with a port or without.
pub(crate) fn is_this_pc(host: &str) -> bool {
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
        _ => host,
    };
    matches!(name, "localhost" | "127.0.0.1" | "[::1]")
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

    #[test]
    fn only_pages_of_the_same_host_pass() {
        for (host, origin, is_local, passes) in [
            (
                Some("127.0.0.1:8420"),
                Some("http://127.0.0.1:8420"),
                true,
                true,
            ),
            (
                Some("localhost:8420"),
                Some("http://localhost:8420"),
                true,
                true,
            ),
            (Some("[::1]:8420"), Some("http://[::1]:8420"), true, true),
            (Some("127.0.0.1:8420"), None, true, true),
            (
                Some("127.0.0.1:8420"),
                Some("http://evil.example"),
                true,
                false,
            ),
            (
                Some("127.0.0.1:8420"),
                Some("http://127.0.0.1:8421"),
                true,
                false,
            ),
            (Some("127.0.0.1:8420"), Some("null"), true, false),
            (
                Some("evil.example:8420"),
                Some("http://evil.example:8420"),
                true,
                false,
            ),
            (Some("evil.example"), None, true, false),
            (None, Some("http://127.0.0.1:8420"), true, false),
            (
                Some("192.168.0.7:80"),
                Some("http://192.168.0.7:80"),
                false,
                true,
            ),
            (
                Some("192.168.0.7:80"),
                Some("http://192.168.0.8:80"),
                false,
                false,
            ),
        ] {
            let mut headers = HeaderMap::new();
            for (name, value) in [(HOST, host), (ORIGIN, origin)] {
                if let Some(value) = value {
                    headers.insert(name, HeaderValue::from_static(value));
                }
            }
            let door = |is_tls| Door { is_local, is_tls };
            assert_eq!(
                lets_in(&headers, door(false)),
                passes,
                "{host:?} {origin:?}"
            );
            // An encrypted page is another one than the same without encryption.
            let is_encrypted = lets_in(&headers, door(true));
            assert_eq!(is_encrypted, passes && origin.is_none());
            if let Some(origin) = origin {
                let origin = origin.replace("http:", "https:");
                headers.insert(ORIGIN, HeaderValue::from_str(&origin).unwrap());
                assert_eq!(lets_in(&headers, door(true)), passes);
            }
        }
    }

    #[test]
    fn a_header_that_comes_twice_passes_nowhere() {
        for name in [HOST, ORIGIN] {
            let mut headers = HeaderMap::new();
            headers.insert(HOST, HeaderValue::from_static("127.0.0.1"));
            headers.append(&name, HeaderValue::from_static("127.0.0.1"));
            headers.append(&name, HeaderValue::from_static("127.0.0.1"));
            let door = Door {
                is_local: true,
                is_tls: false,
            };
            assert!(!lets_in(&headers, door), "{name}");
        }
    }
}
