//! What Prometheus is told of the history and of the broker. Its words are English everywhere, as those of the other metrics.

use std::sync::Arc;
use unoclp_history::Keeper;
use unoclp_report::Reporter;
use unoclp_serve::{Metric, Metrics};

/// How it stands with what there is of them, in numbers.
pub(crate) fn metrics(keeper: Option<Arc<Keeper>>, reporter: Option<Arc<Reporter>>) -> Metrics {
    Arc::new(move || {
        let history = keeper.iter().flat_map(|keeper| of_history(keeper));
        let broker = reporter.iter().flat_map(|reporter| of_broker(reporter));
        history.chain(broker).collect()
    })
}

fn number(name: &'static str, help: &'static str, is_counter: bool, value: u64) -> Metric {
    Metric {
        name,
        help,
        is_counter,
        value,
    }
}

fn of_broker(reporter: &Reporter) -> Vec<Metric> {
    let state = reporter.state();
    vec![
        number(
            "mqtt_connected",
            "Whether the broker is connected",
            false,
            (state.connected == state.wanted).into(),
        ),
        number(
            "mqtt_waiting",
            "Samples that wait for the broker",
            false,
            state.waiting,
        ),
        number(
            "mqtt_dropped_total",
            "Samples given up, since the broker took nothing for too long",
            true,
            state.dropped,
        ),
    ]
}

fn of_history(keeper: &Keeper) -> Vec<Metric> {
    let state = keeper.state();
    vec![
        number(
            "history_rows_total",
            "Rows written to the history",
            true,
            state.written,
        ),
        number(
            "history_dropped_total",
            "Rows given up, since the history took nothing for too long",
            true,
            state.dropped,
        ),
        number(
            "history_waiting",
            "Rows that wait for the history",
            false,
            state.waiting as u64,
        ),
        number(
            "history_failing",
            "Whether the history takes nothing at present",
            false,
            state.failure.is_some().into(),
        ),
    ]
}
