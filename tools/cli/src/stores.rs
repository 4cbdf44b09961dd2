//! Where journal and history of a site are.
//!
//! Owns what a site file's names mean on this PC. Must not know what is there.

use crate::messages;
use crate::site_file::beside;
use anyhow::anyhow;
use std::path::{Path, PathBuf};
use unoclp_history::{Address, Database, Trust};
use unoclp_program::shown;
use unoclp_site::{Site, Store};

/// The file of a site's journal.
pub fn journal_file(file: &Path, site: &Site) -> PathBuf {
    match &site.journal.store {
        Some(name) => beside(file, name),
        None => file.with_extension("journal"),
    }
}

/// The file of what happens at a site.
pub fn record_file(file: &Path) -> PathBuf {
    file.with_extension("record")
}

/// What the history of a site file is called.
pub fn name(file: &Path, store: &Store) -> String {
    match store {
        Store::File(name) => shown(&beside(file, name)),
        Store::Server { server, .. } => server.to_string(),
    }
}

/// Where the history of a site file is.
///
/// # Errors
/// Where the certificate that it names cannot be read.
pub fn database(file: &Path, store: &Store) -> anyhow::Result<Database> {
    let (server, password, tls, ca) = match store {
        Store::File(name) => return Ok(Database::File(beside(file, name))),
        Store::Server {
            server,
            password,
            tls,
            ca,
        } => (server, password, tls, ca),
    };
    let ca = ca.as_ref().map(|name| beside(file, name));
    let pem = ca.map(|ca| {
        let wrong = |why| anyhow!(messages::cannot_read(shown(&ca), messages::io(&why)));
        std::fs::read(&ca).map_err(wrong)
    });
    let ca = pem.transpose()?;
    Ok(Database::Server(Address {
        host: server.host.clone(),
        port: server.port,
        user: server.user.clone(),
        database: server.database.clone(),
        password: password.as_ref().map(|password| password.0.clone()),
        tls: tls.then_some(Trust { ca }),
    }))
}
