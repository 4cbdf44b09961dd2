//! The tables of a database, all in the schema `unoclp`.

use super::failure::failure;
use ::postgres::{Client, GenericClient, Transaction};
use unoclp_journal::Failure;

/// The version of the form. Another one is refused as it is.
const VERSION: i32 = 1;
/// While this is locked, nobody else makes tables: `uncl`.
const LOCK: i64 = 0x756e_636c;

const FORM: &str = "
    CREATE SCHEMA unoclp;
    CREATE TABLE unoclp.form (version int NOT NULL);
    INSERT INTO unoclp.form VALUES (1);
    CREATE TABLE unoclp.point (id serial PRIMARY KEY, board text NOT NULL, name text NOT NULL, UNIQUE (board, name));
    CREATE TABLE unoclp.sample (point int NOT NULL REFERENCES unoclp.point, at bigint NOT NULL, seq bigserial, value float8,
        PRIMARY KEY (point, at, seq));
    CREATE TABLE unoclp.thinned (point int NOT NULL REFERENCES unoclp.point, at bigint NOT NULL, width bigint NOT NULL,
        least float8, most float8, last float8, PRIMARY KEY (point, at));
    CREATE TABLE unoclp.taken (source text PRIMARY KEY, n bigint NOT NULL);
    CREATE INDEX sample_at ON unoclp.sample USING brin (at);
    CREATE VIEW unoclp.value AS SELECT board, name, to_timestamp(at / 1000.0) AS time, value
        FROM unoclp.sample JOIN unoclp.point ON point.id = sample.point;
";

/// A chunk of samples has those of a week, where TimescaleDB is installed: ms.
const CHUNK: i64 = 7 * 86_400_000;

/// Makes the tables where they are not there.
pub(super) fn bring(client: &mut Client) -> Result<(), Failure> {
    let mut all = client.transaction().map_err(failure)?;
    all.execute("SELECT pg_advisory_xact_lock($1)", &[&LOCK])
        .map_err(failure)?;
    match is_there(&mut all)? {
        true => checked(&mut all),
        false => {
            all.batch_execute(FORM).map_err(failure)?;
            divide(&mut all)?;
            all.commit().map_err(failure)
        }
    }
}

/// Where the database has TimescaleDB, it keeps the samples in chunks, each with its own index. Where it does not take them,
/// the table stays one: samples go there all the same.
fn divide(all: &mut Transaction<'_>) -> Result<(), Failure> {
    let sql = "SELECT quote_ident(nspname) FROM pg_extension JOIN pg_namespace ON pg_namespace.oid = extnamespace
        WHERE extname = 'timescaledb'";
    let Some(found) = all.query_opt(sql, &[]).map_err(failure)? else {
        return Ok(());
    };
    let schema: String = found.get(0);
    let sql = format!(
        "SELECT {schema}.create_hypertable('unoclp.sample', 'at', chunk_time_interval => {CHUNK}::bigint,
            create_default_indexes => false)"
    );
    let mut tried = all.transaction().map_err(failure)?;
    match tried.batch_execute(&sql) {
        Ok(()) => tried.commit().map_err(failure),
        Err(_) => tried.rollback().map_err(failure),
    }
}

/// Looks whether the tables are there.
pub(super) fn check(client: &mut Client) -> Result<(), Failure> {
    match is_there(client)? {
        true => checked(client),
        false => Err(Failure::Foreign),
    }
}

fn is_there(client: &mut impl GenericClient) -> Result<bool, Failure> {
    let sql = "SELECT to_regnamespace('unoclp') IS NOT NULL";
    Ok(client.query_one(sql, &[]).map_err(failure)?.get(0))
}

/// Whether a schema of this name is of this version.
fn checked(client: &mut impl GenericClient) -> Result<(), Failure> {
    let sql = "SELECT to_regclass('unoclp.form') IS NOT NULL";
    if !client
        .query_one(sql, &[])
        .map_err(failure)?
        .get::<_, bool>(0)
    {
        return Err(Failure::Foreign);
    }
    let version = client.query_one("SELECT version FROM unoclp.form", &[]);
    match version.map_err(failure)?.get(0) {
        VERSION => Ok(()),
        other => Err(Failure::Version(other.into())),
    }
}
