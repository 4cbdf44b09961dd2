//! `unoclp site`.

use crate::outcome::Outcome;
use crate::{messages, site_file, stores};
use anyhow::anyhow;
use clap::{Args, Subcommand};
use std::path::{Path, PathBuf};
use std::time::Duration;
use unoclp_history::{Database, Failure, NotMoved, Postgres, Query, Sqlite, csv};
use unoclp_journal::{File, now};
use unoclp_program::shown;
use unoclp_site::{Site, Store, duration, plan};

/// What may be done with a site file.
#[derive(Subcommand)]
pub enum OfSite {
    /// Show what a gateway would do with the file, or every error with its line
    Check {
        /// The site file (.toml)
        #[arg(value_name = "SITE.toml")]
        site: PathBuf,
    },
    /// Copy a history file into the database that the site file names; stop unoclp serve first
    Move {
        /// The site file (.toml), with the database under [history]
        #[arg(value_name = "SITE.toml")]
        site: PathBuf,
        /// The file that has held the history so far
        #[arg(value_name = "HISTORY.db")]
        from: PathBuf,
    },
    /// Make a token for a user, and its key for the site file
    Key {
        /// The user: a letter, then letters, digits, - or _
        #[arg(value_name = "NAME")]
        name: String,
        /// What the user may do: watch, operate, or engineer (also change programs)
        #[arg(long, default_value = "operate", value_parser = ["watch", "operate", "engineer"])]
        role: String,
    },
    /// Print the history of a point for a spreadsheet: comma-separated values
    History {
        #[command(flatten)]
        asked: Asked,
    },
}

/// What is asked of the history.
#[derive(Args)]
pub struct Asked {
    /// The site file (.toml)
    #[arg(value_name = "SITE.toml")]
    site: PathBuf,
    /// Board and point: estufa.level
    #[arg(value_name = "BOARD.POINT")]
    point: String,
    /// The period shown, up to now: 90s, 15m, 1h, 30d
    #[arg(long, value_name = "TIME", default_value = "1h")]
    last: String,
    /// One row for each interval, with the minimum, the maximum and the last value; by default, every change
    #[arg(long, value_name = "TIME")]
    step: Option<String>,
}

/// Does it.
pub fn site(of: &OfSite) -> Outcome {
    match of {
        OfSite::Check { site } => check(site),
        OfSite::Move { site, from } => move_history(site, from),
        OfSite::Key { name, role } => key(name, role),
        OfSite::History { asked } => history(asked),
    }
}

/// The site of a file; its mistakes are told.
fn open(path: &Path) -> anyhow::Result<Option<Site>> {
    let site = site_file::open(path)?;
    if let Err(mistakes) = &site {
        for mistake in mistakes {
            say!("{mistake}");
        }
    }
    Ok(site.ok())
}

fn check(path: &Path) -> Outcome {
    let site = open(path)?;
    if let Some(site) = &site {
        say!("{}", plan(site, messages::spoken()).trim_end());
    }
    Ok(site.is_some())
}

/// Copies a history from a file into a database.
fn move_history(path: &Path, from: &Path) -> Outcome {
    let Some(site) = open(path)? else {
        return Ok(false);
    };
    let kept = site.history.as_ref().map(|history| &history.store);
    let kept = kept.filter(|store| matches!(store, Store::Server { .. }));
    let store = kept.ok_or_else(|| anyhow!(messages::nothing_to_move()))?;
    let (file, database) = (shown(from), stores::name(path, store));
    // Whoever serves the site has its journal.
    let journal = stores::journal_file(path, &site);
    let held = File::open(&journal);
    let _held = held.map_err(|why| anyhow!(messages::journal_failure(&journal, &why)))?;
    let from_wrong = |why: Failure| anyhow!(messages::store_failure(&file, &why));
    let to_wrong = |why: Failure| anyhow!(messages::store_failure(&database, &why));
    // One of an older version is brought to this one first.
    std::fs::metadata(from)
        .map_err(|why| anyhow!(messages::cannot_read(&file, messages::io(&why))))?;
    let old = Sqlite::open(from).map_err(from_wrong)?;
    let Database::Server(address) = stores::database(path, store)? else {
        anyhow::bail!(messages::nothing_to_move());
    };
    let mut new = Postgres::open(&address).map_err(to_wrong)?;
    let moved = unoclp_history::move_all(&old, &mut new).map_err(|why| match why {
        NotMoved::Known(board, point) => {
            anyhow!(messages::known_there(&database, format!("{board}.{point}")))
        }
        NotMoved::From(why) => from_wrong(why),
        NotMoved::To(why) => to_wrong(why),
    })?;
    say!(
        "{}",
        messages::moved(&file, moved.points, moved.rows, &database)
    );
    Ok(true)
}

/// Makes a token and its key.
fn key(name: &str, role: &str) -> Outcome {
    let may_be = |ch: char| ch.is_ascii_alphanumeric() || matches!(ch, '-' | '_');
    let is_name = name.len() <= 32
        && name.starts_with(|ch: char| ch.is_ascii_alphabetic())
        && name.chars().all(may_be);
    if !is_name {
        anyhow::bail!(messages::no_user_name(name));
    }
    let made = unoclp_key::make(name).map_err(|why| anyhow!(messages::no_key(why.0)))?;
    say!("{}", messages::user_key(made.token, name, role, made.key));
    Ok(true)
}

fn history(asked: &Asked) -> Outcome {
    let Some(site) = open(&asked.site)? else {
        return Ok(false);
    };
    let kept = site
        .history
        .ok_or_else(|| anyhow!(messages::no_history()))?;
    let (board, point) = asked.point.split_once('.').unwrap_or_default();
    let time = |text: &str| duration(text).ok_or_else(|| anyhow!(messages::no_time(text)));
    let last = ms(time(&asked.last)?);
    let step = asked.step.as_deref().map(time).transpose()?;
    let name = stores::name(&asked.site, &kept.store);
    let wrong = |why: Failure| anyhow!(messages::store_failure(&name, &why));
    let database = stores::database(&asked.site, &kept.store)?;
    let mut store = database.read().map_err(wrong)?;
    let points = store.points().map_err(wrong)?;
    if !points
        .iter()
        .any(|(of, name)| (&**of, &**name) == (board, point))
    {
        let names: Vec<String> = points
            .iter()
            .map(|(of, name)| format!("{of}.{name}"))
            .collect();
        anyhow::bail!(messages::not_in_history(&asked.point, names.join(", ")));
    }
    let now = now();
    let rows = store.rows(&Query {
        board: board.to_owned(),
        point: point.to_owned(),
        from: now.saturating_sub(last),
        to: i64::MAX,
        step: step.map_or(0, ms),
        most: usize::MAX,
    });
    let rows = rows.map_err(wrong)?;
    say!("{}", csv(&rows).trim_end());
    Ok(true)
}

fn ms(time: Duration) -> i64 {
    i64::try_from(time.as_millis()).unwrap_or(i64::MAX)
}
