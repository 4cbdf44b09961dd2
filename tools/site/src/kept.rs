//! The tables `history`, `journal` and `record` of a site file.

use crate::broker::Secret;
use crate::database::Server;
use crate::keys::{Amiss, At, Keys, time};
use crate::mistake::Wrong;
use crate::site::{History, Journal, Store};
use crate::size::size;
use std::time::Duration;

/// How long every change is kept, unless the file says otherwise.
const KEEP: Duration = Duration::from_secs(400 * 86_400);
/// What a history may have that is in a database.
const OF_SERVER: [&str; 3] = ["password", "ca", "tls"];

/// From one commit to the next, unless the file says otherwise.
const EVERY: Duration = Duration::from_millis(200);
/// How large the journal gets at most, unless the file says otherwise.
const BOUND: u64 = 256_000_000;
/// The same of the record.
const RECORD_BOUND: u64 = 1_000_000_000;

/// The table `history`, as far as it is right.
pub(crate) fn history(keys: &Keys<'_>) -> Option<History> {
    let example = "{ store = \"history.db\" }";
    let history = keys.table("history", example)?;
    history.known(&["store", "keep", "password", "ca", "tls"]);
    let keep = time(&history, "keep", "\"400d\"", ["1h", "36500d"]);
    let password = history.text("password", "\"…\"");
    let ca = history.text("ca", "\"ca.pem\"");
    let tls = tls(&history);
    let At { value, place } = history.needed("store", "\"history.db\"")?;
    let store = match value.contains("://") {
        true => {
            let Some(server) = Server::of(&value) else {
                let wrong = match value.contains('@') {
                    // What may hold a password is not repeated.
                    true => Wrong::DatabaseSecret,
                    false => Wrong::NoDatabase { given: value },
                };
                keys.notes.wrong(&place, wrong);
                return None;
            };
            Store::Server {
                password: password.map(|password| Secret(password.value)),
                tls: ca.is_some() || !(server.is_here() || tls.is_some()),
                ca: ca.map(|ca| ca.value),
                server,
            }
        }
        false => {
            for key in OF_SERVER {
                if let Some(place) = history.at(key) {
                    keys.notes.wrong(&place, Wrong::OfServer { key });
                }
            }
            file(keys, "store", "\"history.db\"", &At { value, place })?
        }
    };
    Some(History {
        store,
        keep: keep.map_or(KEEP, |keep| keep.value),
    })
}

/// Whether it says that nothing is encrypted.
fn tls(history: &Keys<'_>) -> Option<()> {
    let At { value, place } = history.text("tls", "\"none\"")?;
    if value == "none" {
        return Some(());
    }
    let wrong = Amiss::Choice {
        key: "tls".to_owned(),
        given: value,
        known: "\"none\"".to_owned(),
    };
    history.notes.wrong(&place, wrong);
    None
}

fn file(keys: &Keys<'_>, key: &'static str, known: &str, given: &At<String>) -> Option<Store> {
    if given.value.is_empty() {
        let wrong = Amiss::Choice {
            key: key.to_owned(),
            given: format!("{:?}", given.value),
            known: known.to_owned(),
        };
        keys.notes.wrong(&given.place, wrong);
        return None;
    }
    Some(Store::File(given.value.clone()))
}

/// The table `journal`, as far as it is right; what it does not say is usual.
pub(crate) fn journal(keys: &Keys<'_>, history: Option<&History>) -> Journal {
    let usual = Journal {
        store: None,
        every: EVERY,
        bound: BOUND,
    };
    let example = "{ bound = \"256MB\" }";
    let Some(journal) = keys.table("journal", example) else {
        return usual;
    };
    journal.known(&["store", "every", "bound"]);
    let every = time(&journal, "every", "\"200ms\"", ["10ms", "1m"]);
    let store = journal.text("store", "\"site.journal\"");
    let store = store.filter(|given| {
        let known = "\"site.journal\"";
        let is_file = file(keys, "store", known, given).is_some() && !given.value.contains("://");
        let is_other = history.is_none_or(|of| of.store != Store::File(given.value.clone()));
        if is_file && !is_other {
            let file = given.value.clone();
            keys.notes.wrong(&given.place, Wrong::OneFile { file });
        }
        is_file && is_other
    });
    Journal {
        store: store.map(|store| store.value),
        every: every.map_or(EVERY, |every| every.value),
        bound: bound(&journal).unwrap_or(BOUND),
    }
}

/// How large the record gets at most, bytes, whether there is one or not.
pub(crate) fn record_bound(keys: &Keys<'_>) -> u64 {
    let record = keys.table("record", "{ bound = \"1GB\" }");
    let given = record.and_then(|record| {
        record.known(&["bound"]);
        bound(&record)
    });
    given.unwrap_or(RECORD_BOUND)
}

fn bound(of: &Keys<'_>) -> Option<u64> {
    let At { value, place } = of.text("bound", "\"256MB\"")?;
    let bytes = size(&value).filter(|bytes| (1_000_000..=1_000_000_000_000).contains(bytes));
    if bytes.is_none() {
        of.notes.wrong(&place, Wrong::NoSize { given: value });
    }
    bytes
}
