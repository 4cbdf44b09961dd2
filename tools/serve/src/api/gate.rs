//! Who is answered, and with what: boards, and the numbers for Prometheus.

use super::answers::{BoardNow, Health};
use super::past::{Archive, No};
use super::text::{JSON, text, wrong};

use crate::doors::{self, Door};
use crate::gateway::Gateway;
use crate::tokens::Role;
use axum::body::Body;
use axum::http::header::AUTHORIZATION;
use axum::http::{HeaderMap, Response, StatusCode};
use axum::response::IntoResponse;
use serde::Serialize;
use std::fmt::Write;
use std::sync::Arc;

/// A number of the gateway itself, for `/metrics`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Metric {
    /// Its name, after `unoclp_`.
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
    pub door: Door,
    pub metrics: Option<Metrics>,
    pub archive: Archive,
}

/// As Prometheus asks for it.
const PROMETHEUS: &str = "text/plain; version=0.0.4; charset=utf-8";

impl Api {
    /// Whether the boards are there: so many of all.
    pub(super) fn health(&self) -> Health {
        let up = |gateway: &&Arc<Gateway>| gateway.line.presence().borrow().is_ok();
        Health {
            boards: self.gateways.len(),
            up: self.gateways.iter().filter(up).count(),
        }
    }

    /// Each board: whether it is there, and what its points are.
    pub(super) fn boards(&self) -> Vec<BoardNow> {
        self.gateways.iter().map(|gateway| board(gateway)).collect()
    }

    /// The same, and the numbers of the gateway, as Prometheus reads them.
    pub(super) fn metrics(&self, headers: &HeaderMap) -> Response<Body> {
        match self.refused(headers) {
            Some(refused) => refused,
            None => text(PROMETHEUS, self.text()),
        }
    }

    /// An answer for whoever may watch.
    pub(super) async fn json<T: Serialize>(
        &self,
        headers: &HeaderMap,
        answer: impl Future<Output = Result<T, No>>,
    ) -> Response<Body> {
        if let Some(refused) = self.refused(headers) {
            return refused;
        }
        match answer.await {
            Ok(answer) => match serde_json::to_string(&answer) {
                Ok(answer) => text(JSON, answer),
                Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
            },
            Err(no) => wrong(no),
        }
    }

    /// Why whoever sends these headers is told nothing.
    pub(super) fn refused(&self, headers: &HeaderMap) -> Option<Response<Body>> {
        let status = if !doors::lets_in(headers, self.door) {
            StatusCode::FORBIDDEN
        } else if let Some(first) = self.gateways.first() {
            match role(headers, first) {
                Some(_) => return None,
                None => StatusCode::UNAUTHORIZED,
            }
        } else {
            StatusCode::NOT_FOUND
        };
        Some(status.into_response())
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
}

/// What whoever sends these headers may do: `Authorization: Bearer TOKEN`, where a token is asked for.
fn role(headers: &HeaderMap, gateway: &Gateway) -> Option<Role> {
    let given = headers
        .get(AUTHORIZATION)
        .and_then(|value| value.to_str().ok());
    let token = given.and_then(|given| given.strip_prefix("Bearer "));
    gateway.role(token.unwrap_or_default())
}

fn board(gateway: &Gateway) -> BoardNow {
    let presence = gateway.line.presence().borrow().clone();
    BoardNow {
        name: gateway.name.clone(),
        up: presence.is_ok(),
        why: presence.err(),
        points: gateway.values().clone(),
    }
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
