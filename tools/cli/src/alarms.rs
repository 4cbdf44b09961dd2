//! The alarms of a site, and the record of what happens.
//!
//! Owns how record, alarms, broker and this program's output are wired. Must not know when an alarm comes.

use crate::messages;
use crate::stores::record_file;
use anyhow::anyhow;
use std::path::Path;
use std::sync::Arc;
use unoclp_alarm::{Alarms, Standing, Turn};
use unoclp_program::shown;
use unoclp_record::{Failure, Record};
use unoclp_report::{Alarm, Reporter};
use unoclp_site::Site;

/// Opens the record of a site, if it has one.
///
/// # Errors
/// Where the file cannot be used.
pub fn record(file: &Path, site: &Site) -> anyhow::Result<Option<Arc<Record>>> {
    if !site.has_record() {
        return Ok(None);
    }
    let path = record_file(file);
    let told = path.clone();
    let tell = Box::new(move |failure: Option<&Failure>| match failure {
        Some(why) => println!("{}", messages::record_failure(&told, why)),
        None => println!("{}", messages::history_again(shown(&told))),
    });
    let begun = Record::begin(&path, site.record_bound, tell);
    let record = begun.map_err(|why| anyhow!(messages::record_failure(&path, &why)))?;
    Ok(Some(Arc::new(record)))
}

/// Begins to judge the alarms of a site, if it has some. Tells them to the broker.
///
/// # Errors
/// Where the record cannot be read.
pub fn alarms(
    file: &Path,
    site: &Site,
    record: Option<&Arc<Record>>,
    reporter: Option<Arc<Reporter>>,
) -> anyhow::Result<Option<Arc<Alarms>>> {
    let Some(record) = record.filter(|_| !site.alarms.is_empty()) else {
        return Ok(None);
    };
    let hear = Box::new(move |of: &Standing, turn: Option<Turn>| {
        if let Some(reporter) = &reporter {
            reporter.alarm(&told(of));
        }
        if let Some(turn) = turn {
            println!("{}", said(of, turn));
        }
    });
    let begun = Alarms::begin(site.alarms.clone(), record.clone(), hear);
    let wrong = |why| anyhow!(messages::record_failure(&record_file(file), &why));
    Ok(Some(Arc::new(begun.map_err(wrong)?)))
}

/// An alarm, as a broker is told.
fn told(of: &Standing) -> Alarm {
    Alarm {
        name: of.name.clone(),
        state: of.state.word(),
        severity: of.severity.word(),
        text: of.text.clone(),
        since: of.since,
        who: of.who.clone(),
    }
}

/// What becomes of an alarm, in words.
fn said(of: &Standing, turn: Turn) -> String {
    match turn {
        Turn::Came => messages::alarm_came(&of.name, of.text.of(messages::spoken())),
        Turn::Gone => messages::alarm_gone(&of.name),
        Turn::Acknowledged => {
            messages::alarm_acknowledged(&of.name, of.who.as_deref().unwrap_or_default())
        }
    }
}
