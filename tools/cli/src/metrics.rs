//! The metrics of journal, history, broker and record for Prometheus. Its words are English everywhere, as those of the other metrics.

use crate::kept::Kept;
use std::sync::Arc;
use unoclp_history::Keeper;
use unoclp_record::Record;
use unoclp_report::Reporter;
use unoclp_serve::{Metric, Metrics};

/// How it stands with what there is of them, in numbers.
pub(crate) fn metrics(
    kept: Option<Arc<Kept>>,
    reporter: Option<Arc<Reporter>>,
    record: Option<Arc<Record>>,
) -> Metrics {
    Arc::new(move || {
        let journal = kept.iter().flat_map(|kept| of_journal(kept));
        let history = kept
            .iter()
            .filter_map(|kept| Some(of_history(kept, kept.keeper.as_ref()?)))
            .flatten();
        let broker = reporter.iter().flat_map(|reporter| of_broker(reporter));
        let record = record.iter().flat_map(|record| of_record(record));
        journal.chain(history).chain(broker).chain(record).collect()
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
            "Samples waiting for the broker",
            false,
            state.waiting,
        ),
        number(
            "mqtt_dropped_total",
            "Samples discarded because the broker accepted nothing for too long",
            true,
            state.dropped,
        ),
    ]
}

fn of_journal(kept: &Kept) -> Vec<Metric> {
    let state = kept.journal.state();
    vec![
        number(
            "journal_samples_total",
            "Samples committed to the journal",
            true,
            state.committed,
        ),
        number(
            "journal_dropped_total",
            "Samples discarded before they reached the journal",
            true,
            state.dropped,
        ),
        number(
            "journal_waiting",
            "Samples in memory, waiting for the journal",
            false,
            state.waiting as u64,
        ),
        number(
            "journal_bytes",
            "Bytes in use in the journal",
            false,
            state.used,
        ),
        number(
            "journal_failing",
            "Whether writing to the journal currently fails",
            false,
            state.failure.is_some().into(),
        ),
    ]
}

fn of_history(kept: &Kept, keeper: &Keeper) -> Vec<Metric> {
    let state = keeper.state();
    let reader = kept.history();
    vec![
        number(
            "history_rows_total",
            "Rows written to the history",
            true,
            state.taken,
        ),
        number(
            "history_dropped_total",
            "Rows discarded because the history accepted nothing for too long",
            true,
            reader.dropped(),
        ),
        number(
            "history_waiting",
            "Rows in the journal, waiting for the history",
            false,
            reader.last().saturating_sub(reader.place()),
        ),
        number(
            "history_failing",
            "Whether writing to the history currently fails",
            false,
            state.failure.is_some().into(),
        ),
    ]
}

fn of_record(record: &Record) -> Vec<Metric> {
    let state = record.state();
    vec![
        number(
            "record_rows_total",
            "Entries written to the record, about alarms and actions",
            true,
            state.written,
        ),
        number(
            "record_dropped_total",
            "Entries lost from the record: not written for too long, or deleted as the oldest",
            true,
            state.dropped,
        ),
        number("record_bytes", "Bytes of the record", false, state.bytes),
        number(
            "record_failing",
            "Whether writing to the record currently fails",
            false,
            state.failure.is_some().into(),
        ),
    ]
}
