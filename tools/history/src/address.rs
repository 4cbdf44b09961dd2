//! Where a database of PostgreSQL is.

/// A database of PostgreSQL.
#[derive(Clone)]
pub struct Address {
    /// The server's name or address.
    pub host: String,
    /// Its port.
    pub port: u16,
    /// As whom we come.
    pub user: String,
    /// The database.
    pub database: String,
    /// The user's password, if it has one.
    pub password: Option<String>,
    /// Whom an encrypted connection trusts; none: it is not encrypted.
    pub tls: Option<Trust>,
}

/// Whom an encrypted connection trusts.
#[derive(Clone, Debug, Default)]
pub struct Trust {
    /// The authority that has signed the server's certificate, in PEM; none: those that the system trusts.
    pub ca: Option<Vec<u8>>,
}

impl std::fmt::Debug for Address {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Address {
            host,
            port,
            user,
            database,
            ..
        } = self;
        write!(f, "postgres://{user}@{host}:{port}/{database}")
    }
}
