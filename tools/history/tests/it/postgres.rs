//! A database of PostgreSQL.
#![cfg(unix)]

use crate::server::Server;
use crate::store;
use unoclp_history::{Address, Failure, Moved, NotMoved, Postgres, Sqlite, Store, Trust, move_all};

#[test]
fn a_database_holds_what_a_file_holds() {
    let server = Server::new();
    let address = server.database("a");
    let each = |check: &dyn Fn(&mut dyn Store)| {
        server.psql("a", "DROP SCHEMA IF EXISTS unoclp CASCADE");
        assert_eq!(Postgres::read(&address).err(), Some(Failure::Foreign));
        check(&mut Postgres::open(&address).unwrap());
        assert!(Postgres::read(&address).is_ok());
    };
    each(&store::a_clock_that_is_set_back_loses_nothing);
    each(&|store| store::thinned(store, 1));
    each(&store::changes_come_back_and_steps_of_them);
    // What others read by SQL.
    let sql = "SELECT board, name, extract(epoch FROM time), value FROM unoclp.value ORDER BY time LIMIT 1";
    assert_eq!(server.psql("a", sql), "estufa|level|0.005000|1");
    // Two gateways at once, each its own boards.
    each(&store::each_entry_is_taken_once);
    let [mut one, mut two] = [(); 2].map(|()| Postgres::open(&address).unwrap());
    for number in 2..20 {
        one.take("b", &[store::entry(number, 200, 1.0)]).unwrap();
        two.take("z", &[store::entry(number, 300, 2.0)]).unwrap();
    }
    assert_eq!(
        (one.taken("z"), two.taken("b")),
        (Ok(Some(19)), Ok(Some(19)))
    );
    // Tables of something else, and of another version, are left as they are.
    server.psql("a", "UPDATE unoclp.form SET version = 7");
    let opened = Postgres::open(&address).err();
    assert_eq!(opened, Some(Failure::Version(7)));
    server.psql(
        "a",
        "UPDATE unoclp.form SET version = 1; ALTER TABLE unoclp.form RENAME TO mine",
    );
    assert_eq!(Postgres::open(&address).err(), Some(Failure::Foreign));
    server.psql(
        "a",
        "ALTER TABLE unoclp.mine RENAME TO form; ALTER DATABASE a SET default_transaction_read_only = on",
    );
    let mut store = Postgres::open(&address).unwrap();
    let entry = [store::entry(1, 1, 1.0)];
    assert_eq!(store.take("s", &entry), Err(Failure::ReadOnly));
}

/// TimescaleDB is not in Debian. What stands here for it has its name, and notes what it is asked.
#[test]
fn where_timescaledb_is_installed_samples_are_in_chunks() {
    let server = Server::new();
    let known = "INSERT INTO pg_extension (oid, extname, extowner, extnamespace, extrelocatable, extversion)
        VALUES (99999, 'timescaledb', 10, 'scale'::regnamespace, false, '2.17.2')";
    // The first parameters, and those by name, as in its documentation.
    let function = |does: &str| {
        format!(
            "CREATE FUNCTION scale.create_hypertable(relation regclass, time_column_name name, partitioning_column name = NULL,
                chunk_time_interval anyelement = NULL::bigint, create_default_indexes boolean = true) RETURNS text
                LANGUAGE plpgsql AS $$ BEGIN {does}; RETURN 'done'; END $$"
        )
    };
    let told = "SELECT relation = 'unoclp.sample'::regclass, name, each FROM scale.asked";
    for (name, does, asked) in [
        (
            "chunks",
            "INSERT INTO scale.asked VALUES (relation, time_column_name, chunk_time_interval)",
            "t|at|604800000",
        ),
        ("refused", "RAISE EXCEPTION 'no licence'", ""),
    ] {
        let address = server.database(name);
        for sql in [
            "CREATE SCHEMA scale",
            "CREATE TABLE scale.asked (relation regclass, name name, each bigint)",
            &*function(does),
            known,
        ] {
            server.psql(name, sql);
        }
        let mut store = Postgres::open(&address).unwrap();
        assert_eq!(server.psql(name, told), asked);
        store::changes_come_back_and_steps_of_them(&mut store);
        // Tables that are there are taken as they are.
        drop(store);
        assert!(Postgres::open(&address).is_ok());
        assert_eq!(server.psql(name, told), asked);
    }
}

#[test]
fn a_file_moves_into_a_database_all_or_nothing() {
    let server = Server::new();
    let folder = tempfile::tempdir().unwrap();
    let mut file = Sqlite::open(&folder.path().join("h.db")).unwrap();
    store::thinned(&mut file, 3);
    let mut number = file.taken("test").unwrap().unwrap();
    for value in 0..50 {
        number += 1;
        let at = 5_000_000_000 - value;
        file.take("test", &[store::entry(number, at, value as f64)])
            .unwrap();
    }
    let address = server.database("a");
    let mut database = Postgres::open(&address).unwrap();
    let all = store::query(-10_000_000, i64::MAX, 0);
    let rows = file.rows(&all).unwrap();
    let moved = move_all(&file, &mut database).unwrap();
    let rows_moved = Moved {
        points: 1,
        rows: rows.len() as u64,
    };
    assert_eq!(moved, rows_moved);
    assert_eq!(database.rows(&all).unwrap(), rows);
    assert_eq!(database.taken("test"), Ok(Some(number)));
    // Where such points are already, nothing is doubled.
    let again = move_all(&file, &mut database);
    assert!(
        matches!(again, Err(NotMoved::Known(board, point)) if (&*board, &*point) == ("estufa", "level"))
    );
    assert_eq!(database.rows(&all).unwrap(), rows);
}

#[test]
fn an_encrypted_database_is_trusted_by_its_certificate() {
    let signed = || rcgen::generate_simple_self_signed(vec!["localhost".to_owned()]).unwrap();
    let own = signed();
    let server = Server::encrypted(&own.cert.pem(), &own.signing_key.serialize_pem());
    let address = server.database("a");
    store::each_entry_is_taken_once(&mut Postgres::open(&address).unwrap());
    let sql = "CREATE ROLE gateway LOGIN PASSWORD 'secret'; GRANT ALL ON DATABASE a TO gateway;
        GRANT ALL ON SCHEMA unoclp TO gateway; GRANT ALL ON ALL TABLES IN SCHEMA unoclp TO gateway";
    server.psql("a", sql);
    let of = |password: Option<&str>| Address {
        user: "gateway".into(),
        password: password.map(str::to_owned),
        ..address.clone()
    };
    let opened = Postgres::open(&of(Some("secret"))).unwrap();
    let sql = "SELECT DISTINCT ssl FROM pg_stat_ssl JOIN pg_stat_activity USING (pid) WHERE application_name = 'unoclp'";
    assert_eq!(server.psql("a", sql), "t");
    drop(opened);
    let other = Trust {
        ca: Some(signed().cert.pem().into()),
    };
    let plain = Server::new();
    let refused = [
        of(Some("wrong")),
        of(None),
        // It is not encrypted, is signed by another, has another name, or cannot be encrypted.
        Address {
            tls: None,
            ..address.clone()
        },
        Address {
            tls: Some(other),
            ..address.clone()
        },
        Address {
            host: "127.0.0.1".into(),
            ..address.clone()
        },
        Address {
            tls: address.tls.clone(),
            ..plain.address("postgres")
        },
    ];
    for address in refused {
        let why = Postgres::open(&address).err();
        assert!(
            matches!(why, Some(Failure::Other(_))),
            "{address:?}: {why:?}"
        );
    }
}
