//! An answer as it goes out.

use super::answers::Wrong;
use super::past::No;
use axum::body::Body;
use axum::http::header::{
    CACHE_CONTROL, CONTENT_DISPOSITION, CONTENT_SECURITY_POLICY, CONTENT_TYPE, REFERRER_POLICY,
    X_CONTENT_TYPE_OPTIONS,
};
use axum::http::{HeaderValue, Response, StatusCode};

pub(super) const JSON: &str = "application/json";
pub(super) const CSV: &str = "text/csv; charset=utf-8";

/// A text of this kind.
pub(super) fn text(kind: &'static str, text: String) -> Response<Body> {
    let mut response = Response::new(text.into());
    let kind = HeaderValue::from_static(kind);
    response.headers_mut().insert(CONTENT_TYPE, kind);
    response
}

/// Comma-separated values, which a browser keeps as a file of this name.
pub(super) fn csv_file(name: &str, values: String) -> Response<Body> {
    let mut response = text(CSV, values);
    let plain = |ch: char| match ch.is_ascii_alphanumeric() || "-_.".contains(ch) {
        true => ch,
        false => '_',
    };
    let name: String = name.chars().map(plain).collect();
    let file = format!("attachment; filename=\"{name}.csv\"");
    if let Ok(file) = HeaderValue::from_str(&file) {
        response.headers_mut().insert(CONTENT_DISPOSITION, file);
    }
    response
}

/// The same answer as one that nobody keeps, that is no page, and around which none stands.
pub(super) fn guarded(mut answer: Response<Body>) -> Response<Body> {
    for (name, value) in [
        (CACHE_CONTROL, "no-store"),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (
            CONTENT_SECURITY_POLICY,
            "default-src 'none'; frame-ancestors 'none'",
        ),
        (REFERRER_POLICY, "no-referrer"),
    ] {
        let value = HeaderValue::from_static(value);
        answer.headers_mut().insert(name, value);
    }
    answer
}

/// Why there is no answer.
pub(super) fn wrong(no: No) -> Response<Body> {
    let why = Wrong { why: no.word() };
    let text = serde_json::to_string(&why).unwrap_or_default();
    let mut response = Response::new(text.into());
    *response.status_mut() = match no {
        No::Time | No::Number | No::Value => StatusCode::BAD_REQUEST,
        No::History | No::Point | No::Alarm | No::Record | No::Panel => StatusCode::NOT_FOUND,
        No::Role => StatusCode::FORBIDDEN,
        No::Acknowledged | No::Held | No::Controlled | No::Program => StatusCode::CONFLICT,
        No::Away | No::Busy | No::Failing => StatusCode::SERVICE_UNAVAILABLE,
    };
    let kind = HeaderValue::from_static(JSON);
    response.headers_mut().insert(CONTENT_TYPE, kind);
    response
}
