//! The history of the points of a site, over HTTP.

use std::sync::{Mutex, PoisonError};
use unoclp_history::{Database, Failure, Query, Row, Store};
use unoclp_serve::Past;

/// A history that is opened again where it has failed.
#[derive(Debug)]
pub struct Archive {
    database: Database,
    open: Mutex<Option<Box<dyn Store>>>,
}

impl Archive {
    /// That of this database.
    pub fn new(database: Database) -> Archive {
        Archive {
            database,
            open: Mutex::default(),
        }
    }

    fn ask<T>(&self, ask: impl FnOnce(&mut dyn Store) -> Result<T, Failure>) -> Result<T, Failure> {
        let mut open = self.open.lock().unwrap_or_else(PoisonError::into_inner);
        let mut store = match open.take() {
            Some(store) => store,
            None => self.database.read()?,
        };
        // Who writes there says what is wrong with it.
        let answer = ask(&mut *store)?;
        *open = Some(store);
        Ok(answer)
    }
}

impl Past for Archive {
    fn points(&self) -> Result<Vec<(String, String)>, Failure> {
        self.ask(|store| store.points())
    }

    fn rows(&self, query: &Query) -> Result<Vec<Row>, Failure> {
        self.ask(|store| store.rows(query))
    }
}
