//! A history in PostgreSQL, in a schema of its own. Several gateways may keep theirs in the same one.
//!
//! - `form`: the tables; `tls`: whom an encrypted connection trusts; `failure`: what the server says
//! - `rows`: what is asked; `thin`: what is left of old rows

mod failure;
mod form;
mod rows;
mod thin;
mod tls;

use crate::address::Address;
use crate::query::{Query, Row};
use crate::store::Store;
use ::postgres::{Client, Config, NoTls, Transaction};
pub(crate) use failure::failure;
use std::collections::HashMap;
use std::fmt;
use std::time::Duration;
use unoclp_journal::{Entry, Failure, Sample};

/// How long a server has to take a connection, and to take what is sent.
const PATIENCE: Duration = Duration::from_secs(10);

/// A connection to a database of samples.
pub struct Postgres {
    pub(crate) client: Client,
    /// The numbers of points that are known.
    points: HashMap<(String, String), i32>,
}

impl fmt::Debug for Postgres {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Postgres")
    }
}

impl Postgres {
    /// Connects, and makes the tables where they are not there.
    ///
    /// # Errors
    /// [`Failure`]; the database is then as it was.
    pub fn open(address: &Address) -> Result<Postgres, Failure> {
        let mut client = connect(address)?;
        form::bring(&mut client)?;
        Ok(Postgres {
            client,
            points: HashMap::new(),
        })
    }

    /// The same to read alone: nothing is made.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(address: &Address) -> Result<Postgres, Failure> {
        let mut client = connect(address)?;
        form::check(&mut client)?;
        Ok(Postgres {
            client,
            points: HashMap::new(),
        })
    }
}

fn connect(address: &Address) -> Result<Client, Failure> {
    let Address {
        host,
        port,
        user,
        database,
        password,
        tls,
    } = address;
    let mut config = Config::new();
    config
        .host(host)
        .port(*port)
        .user(user)
        .dbname(database)
        .application_name("unoclp")
        .connect_timeout(PATIENCE)
        .tcp_user_timeout(3 * PATIENCE)
        .keepalives_idle(PATIENCE)
        // A statement that waits for longer has met somebody who holds a table.
        .options("-c statement_timeout=60s -c client_min_messages=warning");
    if let Some(password) = password {
        config.password(password);
    }
    match tls {
        None => {
            config.ssl_mode(::postgres::config::SslMode::Disable);
            config.connect(NoTls).map_err(failure)
        }
        Some(trust) => {
            config.ssl_mode(::postgres::config::SslMode::Require);
            let connect = tls::connector(trust.ca.as_deref())?;
            config.connect(connect).map_err(failure)
        }
    }
}

impl Store for Postgres {
    fn taken(&mut self, source: &str) -> Result<Option<u64>, Failure> {
        let sql = "SELECT n FROM unoclp.taken WHERE source = $1";
        let taken = self.client.query_opt(sql, &[&source]).map_err(failure)?;
        Ok(taken.and_then(|row| u64::try_from(row.get::<_, i64>(0)).ok()))
    }

    fn take(&mut self, source: &str, entries: &[Entry]) -> Result<(), Failure> {
        let Postgres { client, points } = self;
        let mut all = client.transaction().map_err(failure)?;
        // Who else writes of this journal waits here, and then sees what was taken.
        let sql = "INSERT INTO unoclp.taken VALUES ($1, 0) ON CONFLICT (source) DO UPDATE SET n = taken.n RETURNING n";
        let before: i64 = all.query_one(sql, &[&source]).map_err(failure)?.get(0);
        let before = u64::try_from(before).unwrap_or(0);
        let new = entries.iter().filter(|entry| entry.number > before);
        let known = points.clone();
        let appended = append(&mut all, points, new.map(|entry| &entry.sample));
        let taken = appended.and_then(|()| {
            let last = entries.last().map_or(0, |last| last.number).max(before);
            let number = i64::try_from(last).unwrap_or(i64::MAX);
            let sql = "UPDATE unoclp.taken SET n = $2 WHERE source = $1";
            all.execute(sql, &[&source, &number]).map_err(failure)?;
            all.commit().map_err(failure)
        });
        if taken.is_err() {
            // What was new in it may have been undone.
            *points = known;
        }
        taken
    }

    fn points(&mut self) -> Result<Vec<(String, String)>, Failure> {
        let sql =
            "SELECT board, name FROM unoclp.point ORDER BY board COLLATE \"C\", name COLLATE \"C\"";
        let points = self.client.query(sql, &[]).map_err(failure)?;
        Ok(points.iter().map(|row| (row.get(0), row.get(1))).collect())
    }

    fn rows(&mut self, query: &Query) -> Result<Vec<Row>, Failure> {
        rows::rows(&mut self.client, query)
    }

    fn thin(&mut self, now: i64, keep: i64) -> Result<bool, Failure> {
        thin::thin(&mut self.client, now, keep)
    }
}

/// Each sample gets a number of its own, in the order of writing: a clock that is set back changes no order.
fn append<'s>(
    all: &mut Transaction<'_>,
    points: &mut HashMap<(String, String), i32>,
    samples: impl Iterator<Item = &'s Sample>,
) -> Result<(), Failure> {
    let (mut ids, mut moments, mut values) = (Vec::new(), Vec::new(), Vec::new());
    for Sample {
        board,
        point,
        at,
        value,
    } in samples
    {
        ids.push(id(all, points, board, point)?);
        moments.push(*at);
        values.push(*value);
    }
    let sql = "INSERT INTO unoclp.sample (point, at, value)
        SELECT p, a, v FROM unnest($1::int[], $2::bigint[], $3::float8[]) WITH ORDINALITY AS new (p, a, v, o) ORDER BY o";
    let written = all.execute(sql, &[&ids, &moments, &values]);
    written.map(drop).map_err(failure)
}

/// The number of a point, a new one where it has none.
pub(crate) fn id(
    all: &mut Transaction<'_>,
    points: &mut HashMap<(String, String), i32>,
    board: &str,
    name: &str,
) -> Result<i32, Failure> {
    let point = (board.to_owned(), name.to_owned());
    if let Some(id) = points.get(&point) {
        return Ok(*id);
    }
    let sql = "INSERT INTO unoclp.point (board, name) VALUES ($1, $2)
        ON CONFLICT (board, name) DO UPDATE SET name = excluded.name RETURNING id";
    let id = all
        .query_one(sql, &[&board, &name])
        .map_err(failure)?
        .get(0);
    points.insert(point, id);
    Ok(id)
}
