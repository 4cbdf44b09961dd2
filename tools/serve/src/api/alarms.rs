//! How alarms stand and stood, that one is acknowledged, and what was done.

use super::answers::{AlarmNow, AlarmPast, DeedOf, Done, Texts};
use super::gate::{Api, Caller};
use super::past::{MOST, No, ROWS, ms};
use crate::guard::Who;
use crate::orders;
use serde::Deserialize;
use unoclp_alarm::{NotDone, Standing};
use unoclp_record::{Deed, Happening, now};
use unoclp_site::{Role as May, duration};

/// The longest text that acknowledges, bytes.
pub(super) const LONGEST: usize = 1_000;

/// Which rows are asked for.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct Span {
    from: Option<String>,
    to: Option<String>,
    last: Option<String>,
    most: Option<String>,
}

/// Which alarm is acknowledged.
#[derive(Debug, Deserialize)]
struct Acknowledged {
    alarm: String,
}

impl Api {
    /// How each alarm stands.
    pub(super) fn alarms_now(&self) -> Vec<AlarmNow> {
        let now = |of: Standing| AlarmNow {
            name: of.name,
            state: of.state.word(),
            severity: of.severity.word(),
            text: Texts {
                en: of.text.en,
                pt: of.text.pt,
            },
            boards: of.boards,
            since: of.since,
            who: of.who,
        };
        let alarms = self.alarms.iter().flat_map(|alarms| alarms.standing());
        alarms.map(now).collect()
    }

    /// What became of alarms: the latest of a span.
    pub(super) async fn alarms_past(&self, span: Result<Span, No>) -> Result<Vec<Happening>, No> {
        let asked = span?.asked()?;
        let alarms = self.alarms.clone().ok_or(No::Record)?;
        self.archive.when_free(move || alarms.past(&asked)).await
    }

    /// What was done: the latest of a span.
    pub(super) async fn deeds(&self, span: Result<Span, No>) -> Result<Vec<Deed>, No> {
        let asked = span?.asked()?;
        let first = self.gateways.first().ok_or(No::Record)?;
        let record = first.deeds.past().ok_or(No::Record)?;
        self.archive.when_free(move || record.deeds(&asked)).await
    }

    /// Somebody acknowledges an alarm.
    pub(super) async fn acknowledge(
        &self,
        who: Who,
        Caller(from): Caller,
        body: &[u8],
    ) -> Result<Done, No> {
        if who.may < May::Operate {
            return Err(No::Role);
        }
        let asked: Acknowledged = serde_json::from_slice(body).map_err(|_| No::Value)?;
        let done = orders::acknowledge(self.alarms.clone(), &asked.alarm, &who.name).await;
        let state = done.map_err(|why| match why {
            NotDone::NoAlarm => No::Alarm,
            NotDone::Nothing => No::Acknowledged,
            NotDone::Ended => No::Failing,
        })?;
        if let Some(first) = self.gateways.first() {
            first.deeds.acknowledged(&who, from, &asked.alarm);
            first.deeds.settle().await;
        }
        Ok(Done {
            state: state.word(),
        })
    }
}

impl Span {
    fn asked(&self) -> Result<unoclp_record::Asked, No> {
        let moment = |text: &Option<String>| match text {
            Some(text) => text.parse::<i64>().map(Some).map_err(|_| No::Time),
            None => Ok(None),
        };
        let last = match &self.last {
            Some(text) => Some(duration(text).ok_or(No::Time)?),
            None => None,
        };
        let to = moment(&self.to)?.unwrap_or(i64::MAX);
        let since = last.map(|last| now().min(to).saturating_sub(ms(last)));
        let from = moment(&self.from)?.or(since).unwrap_or(i64::MIN);
        let most = match &self.most {
            Some(text) => text.parse().map_err(|_| No::Number)?,
            None => ROWS,
        };
        match (1..=MOST).contains(&most) {
            true => Ok(unoclp_record::Asked { from, to, most }),
            false => Err(No::Number),
        }
    }
}

impl From<Happening> for AlarmPast {
    fn from(of: Happening) -> AlarmPast {
        AlarmPast {
            at: of.at,
            alarm: of.alarm,
            change: of.change,
            state: of.state,
            who: of.who,
        }
    }
}

impl From<Deed> for DeedOf {
    fn from(of: Deed) -> DeedOf {
        DeedOf {
            at: of.at,
            who: of.who,
            from: of.from,
            of: of.of,
            what: of.what,
            detail: of.detail,
        }
    }
}
