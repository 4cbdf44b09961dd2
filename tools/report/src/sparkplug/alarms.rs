//! The alarms of a site as metrics of the edge node: how each stands, whether its condition holds, and, where the site lets
//! alarms be acknowledged, one by which a host does so.

use super::payload::{Held, Metric, datatype, time};
use crate::alarm::Alarm;
use std::collections::BTreeMap;
use unoclp_site::Site;

/// The first part of the name of each metric of an alarm, and its last parts.
const ABOVE: &str = "Alarms/";
const STATE: &str = "/State";
const ACTIVE: &str = "/Active";
const ACKNOWLEDGE: &str = "/Acknowledge";

/// The alarms, each once somebody has said how it stands.
#[derive(Debug)]
pub(super) struct Alarms {
    all: BTreeMap<String, Option<Alarm>>,
    may_be_acknowledged: bool,
}

/// The alarm that this metric acknowledges; none of another metric.
pub(super) fn acknowledged(metric: &str) -> Option<&str> {
    metric.strip_prefix(ABOVE)?.strip_suffix(ACKNOWLEDGE)
}

impl Alarms {
    pub fn new(site: &Site, may_be_acknowledged: bool) -> Alarms {
        let names = site.alarms.iter().map(|alarm| (alarm.name.clone(), None));
        Alarms {
            all: names.collect(),
            may_be_acknowledged,
        }
    }

    /// An alarm stands so from now on.
    pub fn take(&mut self, alarm: &Alarm) {
        self.all.insert(alarm.name.clone(), Some(alarm.clone()));
    }

    /// All metrics.
    pub fn metrics(&self, now: i64) -> impl Iterator<Item = Metric> {
        let names = self.all.keys();
        names.flat_map(move |name| self.metrics_of(name, now))
    }

    /// Those of an alarm.
    pub fn metrics_of(&self, name: &str, now: i64) -> Vec<Metric> {
        let Some(alarm) = self.all.get(name) else {
            return Vec::new();
        };
        let since = alarm.as_ref().and_then(|alarm| alarm.since);
        let metric = |end: &str, datatype, value: Option<Held>| Metric {
            name: Some(format!("{ABOVE}{name}{end}")),
            timestamp: Some(time(since.unwrap_or(now))),
            datatype: Some(datatype),
            is_null: value.is_none().then_some(true),
            value,
            ..Metric::default()
        };
        let state = alarm.as_ref().map(|alarm| alarm.state);
        let holds = state.map(|state| Held::Boolean(["active", "acknowledged"].contains(&state)));
        let state = state.map(|state| Held::Text(state.to_owned()));
        let mut metrics = vec![
            metric(STATE, datatype::STRING, state),
            metric(ACTIVE, datatype::BOOLEAN, holds),
        ];
        if self.may_be_acknowledged {
            let is_asked = Some(Held::Boolean(false));
            metrics.push(metric(ACKNOWLEDGE, datatype::BOOLEAN, is_asked));
        }
        metrics
    }
}
