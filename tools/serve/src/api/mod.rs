//! What other programs read over HTTP: `/health`, `/metrics` for Prometheus, boards, history, alarms and deeds as JSON; and
//! that an alarm is acknowledged, and a value set on a panel.
//!
//! - `paths`: what is asked, and the page of OpenAPI that says so; `answers`: what is answered
//! - `past`: what points were; `alarms`: how alarms stand and stood, and what was done; `sheets`: what stands on panels; `panels`: what is set there; `gate`: who is answered; `text`: an answer as it goes out
//!
//! Owns these texts, and who may ask for them. Must not know where a value comes from.

mod alarms;
mod answers;
mod gate;
mod panels;
mod past;
mod paths;
mod sheets;
mod text;

pub(crate) use gate::{Api, Caller};
pub use gate::{Metric, Metrics};
pub(crate) use past::Archive;
pub use past::Past;
pub(crate) use paths::routes;
pub(crate) use sheets::Sheets;
