//! What other programs read over HTTP: `/health`, `/metrics` for Prometheus, boards and history as JSON.
//!
//! - `paths`: what is asked, and the page of OpenAPI that says so; `answers`: what is answered
//! - `past`: what points were; `gate`: who is answered; `text`: an answer as it goes out
//!
//! Owns these texts, and that whoever asks may watch. Must not know where a value comes from.

mod answers;
mod gate;
mod past;
mod paths;
mod text;

pub(crate) use gate::Api;
pub use gate::{Metric, Metrics};
pub(crate) use past::Archive;
pub use past::Past;
pub(crate) use paths::routes;
