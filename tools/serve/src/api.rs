//! What other programs read over HTTP: `/health`, `/metrics` for Prometheus, `/api/boards` as JSON.
//!
//! Owns these texts, and that whoever asks may watch. Must not know where a value comes from.

use crate::doors;
use crate::gateway::Gateway;
use crate::tokens::Role;
use axum::body::Body;
use axum::http::header::{AUTHORIZATION, CACHE_CONTROL, CONTENT_TYPE, X_CONTENT_TYPE_OPTIONS};
use axum::http::{HeaderMap, HeaderValue, Response, StatusCode};
use axum::response::IntoResponse;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::sync::Arc;

/// A number of the gateway itself, for `/metrics`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Metric {
    /// Its name, behind `unoclp_`.
    pub name: &'static str,
    /// What it counts.
    pub help: &'static str,
    /// Whether it only grows.
    pub is_counter: bool,
    /// The number.
    pub value: u64,
}

/// Gives the numbers of what stands behind the gateway.
pub type Metrics = Arc<dyn Fn() -> Vec<Metric> + Send + Sync>;

/// What these texts are made of.
#[derive(Clone)]
pub(crate) struct Api {
    pub gateways: Arc<[Arc<Gateway>]>,
    pub is_local: bool,
    pub metrics: Option<Metrics>,
}

const JSON: &str = "application/json";
/// As Prometheus asks for it.
const PROMETHEUS: &str = "text/plain; version=0.0.4; charset=utf-8";

impl Api {
    /// Whether the boards are there: so many of all.
    pub fn health(&self, headers: &HeaderMap) -> Response<Body> {
        self.answer(headers, JSON, || {
            let all = self.gateways.iter();
            let up = all.filter(|gateway| gateway.line.presence().borrow().is_ok());
            json!({ "boards": self.gateways.len(), "up": up.count() }).to_string()
        })
    }

    /// Each board: whether it is there, and what its points are.
    pub fn boards(&self, headers: &HeaderMap) -> Response<Body> {
        self.answer(headers, JSON, || {
            let boards: Vec<Value> = self.gateways.iter().map(|gateway| board(gateway)).collect();
            Value::from(boards).to_string()
        })
    }

    /// The same, and the numbers of the gateway, as Prometheus reads them.
    pub fn metrics(&self, headers: &HeaderMap) -> Response<Body> {
        self.answer(headers, PROMETHEUS, || self.text())
    }

    fn text(&self) -> String {
        let mut text = String::new();
        head(&mut text, "board_up", "Whether the board answers", false);
        for gateway in &*self.gateways {
            let is_up = u8::from(gateway.line.presence().borrow().is_ok());
            line(&mut text, "board_up", &[("board", &gateway.name)], is_up);
        }
        head(
            &mut text,
            "point",
            "What a point of a board was when it was last read",
            false,
        );
        for gateway in &*self.gateways {
            for (point, value) in &*gateway.values() {
                if let Some(value) = value {
                    let labels = [("board", &*gateway.name), ("point", point)];
                    line(&mut text, "point", &labels, value);
                }
            }
        }
        let more = self.metrics.as_ref().map(|metrics| metrics());
        for Metric {
            name,
            help,
            is_counter,
            value,
        } in more.unwrap_or_default()
        {
            head(&mut text, name, help, is_counter);
            line(&mut text, name, &[], value);
        }
        text
    }

    /// A text for whoever may watch.
    fn answer(
        &self,
        headers: &HeaderMap,
        kind: &'static str,
        text: impl FnOnce() -> String,
    ) -> Response<Body> {
        if !doors::lets_in(headers, self.is_local) {
            return StatusCode::FORBIDDEN.into_response();
        }
        let Some(first) = self.gateways.first() else {
            return StatusCode::NOT_FOUND.into_response();
        };
        if role(headers, first).is_none() {
            return StatusCode::UNAUTHORIZED.into_response();
        }
        let mut response = Response::new(text().into());
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
}

/// What whoever sends these headers may do: `Authorization: Bearer TOKEN`, where a token is asked for.
fn role(headers: &HeaderMap, gateway: &Gateway) -> Option<Role> {
    let given = headers
        .get(AUTHORIZATION)
        .and_then(|value| value.to_str().ok());
    let token = given.and_then(|given| given.strip_prefix("Bearer "));
    gateway.role(token.unwrap_or_default())
}

fn board(gateway: &Gateway) -> Value {
    let presence = gateway.line.presence().borrow().clone();
    let values = gateway.values();
    let points = values
        .iter()
        .map(|(point, value)| (point.clone(), json!(value)));
    let points: Map<String, Value> = points.collect();
    let mut board = json!({ "name": gateway.name, "up": presence.is_ok(), "points": points });
    if let Err(why) = presence {
        board["why"] = why.into();
    }
    board
}

fn head(text: &mut String, name: &str, help: &str, is_counter: bool) {
    let kind = if is_counter { "counter" } else { "gauge" };
    // To a string nothing fails.
    let _ = writeln!(
        text,
        "# HELP unoclp_{name} {help}\n# TYPE unoclp_{name} {kind}"
    );
}

fn line(text: &mut String, name: &str, labels: &[(&str, &str)], value: impl std::fmt::Display) {
    let labels: Vec<String> = labels
        .iter()
        .map(|(label, value)| {
            format!(
                "{label}=\"{}\"",
                value.replace('\\', "\\\\").replace('"', "\\\"")
            )
        })
        .collect();
    let labels = match labels.is_empty() {
        true => String::new(),
        false => format!("{{{}}}", labels.join(",")),
    };
    let _ = writeln!(text, "unoclp_{name}{labels} {value}");
}
