//! An answer as it goes out.

use super::answers::Wrong;
use super::past::No;
use axum::body::Body;
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE, X_CONTENT_TYPE_OPTIONS};
use axum::http::{HeaderValue, Response, StatusCode};

pub(super) const JSON: &str = "application/json";
pub(super) const CSV: &str = "text/csv; charset=utf-8";

/// A text of this kind, which nobody keeps.
pub(super) fn text(kind: &'static str, text: String) -> Response<Body> {
    let mut response = Response::new(text.into());
    for (name, value) in [
        (CONTENT_TYPE, kind),
        (CACHE_CONTROL, "no-store"),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
    ] {
        let value = HeaderValue::from_static(value);
        response.headers_mut().insert(name, value);
    }
    response
}

/// Why there is no answer.
pub(super) fn wrong(no: No) -> Response<Body> {
    let why = Wrong { why: no.word() };
    let text = serde_json::to_string(&why).unwrap_or_default();
    let mut response = Response::new(text.into());
    *response.status_mut() = match no {
        No::Time | No::Number => StatusCode::BAD_REQUEST,
        No::History | No::Point => StatusCode::NOT_FOUND,
        No::Busy | No::Failing => StatusCode::SERVICE_UNAVAILABLE,
    };
    let kind = HeaderValue::from_static(JSON);
    response.headers_mut().insert(CONTENT_TYPE, kind);
    response
}
