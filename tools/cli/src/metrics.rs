//! What Prometheus is told of the history. Its words are English everywhere, as those of the other metrics.

use std::sync::Arc;
use unoclp_history::Keeper;
use unoclp_serve::{Metric, Metrics};

/// How it stands with the history, in numbers.
pub(crate) fn metrics(keeper: Arc<Keeper>) -> Metrics {
    Arc::new(move || {
        let state = keeper.state();
        let number = |name, help, is_counter, value| Metric {
            name,
            help,
            is_counter,
            value,
        };
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
    })
}
