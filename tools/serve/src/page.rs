//! The files of the page.

use axum::body::{Body, Bytes};
use axum::http::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, REFERRER_POLICY, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::{HeaderValue, Response, StatusCode};
use std::borrow::Cow;

/// The content of a file of the page by its path, without a slash before it; `None` where there is none.
pub trait Pages: Fn(&str) -> Option<Cow<'static, [u8]>> + Send + Sync + 'static {}

impl<P: Fn(&str) -> Option<Cow<'static, [u8]>> + Send + Sync + 'static> Pages for P {}

/// What the page may load: its own files, workers made of them, and no page may stand around it.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; \
     img-src 'self' data: blob:; worker-src 'self' blob:; connect-src 'self' data: blob:; frame-ancestors 'none'; base-uri 'none'";

/// The file at this path of an address.
pub(crate) fn file(pages: &dyn Pages, path: &str) -> Response<Body> {
    let path = path.trim_start_matches('/');
    let path = if path.is_empty() { "index.html" } else { path };
    let Some(content) = pages(path) else {
        return answer(StatusCode::NOT_FOUND, "text/plain", "404\n");
    };
    let kind = mime_guess::from_path(path).first_or_octet_stream();
    let content = match content {
        // However many take it, it is there once.
        Cow::Borrowed(content) => Bytes::from_static(content),
        Cow::Owned(content) => content.into(),
    };
    answer(StatusCode::OK, kind.essence_str(), content)
}

fn answer(status: StatusCode, kind: &str, content: impl Into<Body>) -> Response<Body> {
    let mut response = Response::new(content.into());
    *response.status_mut() = status;
    let text = match kind {
        "text/html" | "text/css" | "text/javascript" | "text/plain" => "; charset=utf-8",
        _ => "",
    };
    let headers = response.headers_mut();
    if let Ok(kind) = HeaderValue::from_str(&format!("{kind}{text}")) {
        headers.insert(CONTENT_TYPE, kind);
    }
    for (name, value) in [
        (CACHE_CONTROL, "no-cache"),
        (CONTENT_SECURITY_POLICY, POLICY),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (REFERRER_POLICY, "no-referrer"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}
