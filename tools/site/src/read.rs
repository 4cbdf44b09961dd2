//! From the text of a site file to a site.

use crate::alarms::alarms;
use crate::files::Files;
use crate::grants::grants;
use crate::kept::{history, journal, record_bound};
use crate::keys::{Amiss, At, Keys, address};
use crate::lines::lines;
use crate::mistake::{Mistake, Wrong};
use crate::mqtt::mqtt;
use crate::panels::panels;
use crate::site::{Encryption, Http, Modbus, Site};
use crate::users::users;
use std::net::{Ipv4Addr, SocketAddr};
use unoclp_keyed::keyed;

/// Reads the text of a site file.
///
/// # Errors
/// All that is wrong with it, in the order of the lines.
pub fn read(text: &str, files: &dyn Files) -> Result<Site, Vec<Mistake>> {
    keyed(text, |keys: &Keys<'_>| {
        keys.known(&[
            "http", "line", "modbus", "mqtt", "history", "journal", "record", "alarm", "panel",
            "user",
        ]);
        site(keys, files)
    })
}

/// As much of it as is right.
fn site(keys: &Keys<'_>, files: &dyn Files) -> Site {
    let (http, tls) = http(keys);
    let lines = lines(keys, files);
    let modbus = modbus(keys, &lines, &http);
    let mqtt = mqtt(keys, &lines);
    let history = history(keys);
    let alarms = alarms(keys, &lines);
    let panels = panels(keys, &lines, files);
    Site {
        http: Http {
            listen: http.value,
            tls,
        },
        lines,
        modbus,
        mqtt,
        journal: journal(keys, history.as_ref()),
        record_bound: record_bound(keys),
        history,
        alarms,
        panels,
        users: users(keys),
    }
}

/// Where the page is served, and with which certificate; 127.0.0.1:8420 without any, unless the file says otherwise.
fn http(keys: &Keys<'_>) -> (At<SocketAddr>, Encryption) {
    let usual = At {
        value: (Ipv4Addr::LOCALHOST, 8420).into(),
        place: 0..0,
    };
    let example = "{ listen = \"127.0.0.1:8420\" }";
    let Some(http) = keys.table("http", example) else {
        return (usual, Encryption::None);
    };
    http.known(&["listen", "tls"]);
    let tls = encryption(&http);
    let listen = address(&http, "listen", "\"127.0.0.1:8420\"");
    if let Some(At { value, place }) = &listen
        && !value.ip().is_loopback()
        && !http.has("tls")
    {
        let listen = value.to_string();
        keys.notes.wrong(place, Wrong::Open { listen });
    }
    (listen.unwrap_or(usual), tls.unwrap_or(Encryption::None))
}

const ENCRYPTIONS: &str = "\"self-signed\", { cert = \"cert.pem\", key = \"key.pem\" }, \"none\"";

fn encryption(http: &Keys<'_>) -> Option<Encryption> {
    if http.is_table("tls") {
        let files = http.table("tls", "\"self-signed\"")?;
        files.known(&["cert", "key"]);
        let cert = files.needed("cert", "\"cert.pem\"");
        let key = files.needed("key", "\"key.pem\"");
        return Some(Encryption::Files {
            cert: cert?.value,
            key: key?.value,
        });
    }
    let At { value, place } = http.text("tls", "\"self-signed\"")?;
    match &*value {
        "none" => Some(Encryption::None),
        "self-signed" => Some(Encryption::SelfSigned),
        _ => {
            let wrong = Amiss::Choice {
                key: "tls".to_owned(),
                given: value,
                known: ENCRYPTIONS.to_owned(),
            };
            http.notes.wrong(&place, wrong);
            None
        }
    }
}

fn modbus(keys: &Keys<'_>, lines: &[crate::Line], http: &At<SocketAddr>) -> Option<Modbus> {
    let example = "{ listen = \"127.0.0.1:1502\" }";
    let modbus = keys.table("modbus", example)?;
    modbus.known(&["listen", "write"]);
    let boards: Vec<_> = lines.iter().flat_map(|line| &line.boards).collect();
    let write = grants(&modbus, &boards);
    let listen = address(&modbus, "listen", "\"127.0.0.1:1502\"")?;
    // Port 0 is another one each time.
    if listen.value == http.value && listen.value.port() != 0 {
        let address = listen.value.to_string();
        keys.notes
            .wrong(&listen.place, Wrong::TwoServers { address });
    }
    Some(Modbus {
        listen: listen.value,
        write,
    })
}
