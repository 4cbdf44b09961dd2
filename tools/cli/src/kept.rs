//! What is kept of a site: its journal, and its history after that.
//!
//! Owns where they are, how they begin and end, and the words for what is wrong. Must not know their forms.

use crate::messages;
use crate::stores::{database, journal_file, name};
use anyhow::anyhow;
use std::path::Path;
use std::sync::Arc;
use unoclp_history::{Database, Failure, Keeper};
use unoclp_journal::{File, Journal, Policy, Reader};
use unoclp_program::shown;
use unoclp_report::Reporter;
use unoclp_site::Site;

/// Who reads the journal for the history.
const HISTORY: &str = "history";

/// What is kept of a site.
#[derive(Debug)]
pub struct Kept {
    /// What has not reached all who want it.
    pub journal: Arc<Journal>,
    /// Who brings it to the history, if there is one.
    pub keeper: Option<Keeper>,
}

impl Kept {
    /// Opens the journal of a site, and begins to bring what it has to the history.
    ///
    /// # Errors
    /// Where a file cannot be used. A database may be away.
    pub fn begin(file: &Path, site: &Site) -> anyhow::Result<Kept> {
        let journal = Arc::new(journal(file, site)?);
        let keeper = keeper(file, site, &journal)?;
        Ok(Kept { journal, keeper })
    }

    /// The journal as the history reads it.
    pub fn history(&self) -> Reader {
        self.journal.reader(HISTORY)
    }

    /// All that has come is on disk; what the history takes still is there.
    pub fn end(&self) {
        self.journal.end();
        if let Some(keeper) = &self.keeper {
            keeper.end();
        }
    }
}

fn journal(file: &Path, site: &Site) -> anyhow::Result<Journal> {
    let path = journal_file(file, site);
    let wrong = |why: &Failure| anyhow!(messages::journal_failure(&path, why));
    let opened = File::open(&path).map_err(|why| wrong(&why))?;
    let policy = Policy {
        every: site.journal.every,
        bound: site.journal.bound,
    };
    let history = site.history.iter().map(|_| HISTORY);
    let broker = site.mqtt.iter().flat_map(Reporter::readers);
    let readers: Vec<&str> = history.chain(broker).collect();
    let told = path.clone();
    let tell = Box::new(move |failure: Option<&Failure>| match failure {
        Some(why) => println!("{}", messages::journal_failure(&told, why)),
        None => println!("{}", messages::history_again(shown(&told))),
    });
    Journal::begin(opened, policy, &readers, tell).map_err(|why| wrong(&why))
}

fn keeper(file: &Path, site: &Site, journal: &Journal) -> anyhow::Result<Option<Keeper>> {
    let Some(history) = &site.history else {
        return Ok(None);
    };
    let name = name(file, &history.store);
    let database = database(file, &history.store)?;
    // A file that cannot be used will not get better; a server may.
    let first = match (&database, database.open()) {
        (_, Ok(store)) => Some(store),
        (Database::Server(_), Err(Failure::Other(_))) => None,
        (_, Err(why)) => anyhow::bail!(messages::store_failure(&name, &why)),
    };
    let tell = Box::new(move |failure: Option<&Failure>| match failure {
        Some(why) => println!("{}", messages::store_failure(&name, why)),
        None => println!("{}", messages::history_again(&name)),
    });
    let open = Box::new(move || database.open());
    let reader = journal.reader(HISTORY);
    let keeper = Keeper::begin(first, open, reader, history.keep, tell);
    Ok(Some(keeper.map_err(|why| anyhow!(messages::io(&why)))?))
}
