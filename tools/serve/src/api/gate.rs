//! Who is answered, and with what: boards, and the numbers for Prometheus.

use super::answers::{BoardNow, Health};
use super::past::{Archive, No};
use super::sheets::Sheets;
use super::text::{JSON, guarded, text, wrong};

use crate::doors::{self, Door};
use crate::gateway::Gateway;
use crate::guard::{Stays, Who};
use crate::holding::Holding;
use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::header::AUTHORIZATION;
use axum::http::{HeaderMap, Response, StatusCode};
use axum::middleware::Next;
use axum::response::IntoResponse;
use serde::Serialize;
use std::fmt::Write;
use std::net::{IpAddr, Ipv4Addr};
use std::sync::Arc;
use unoclp_alarm::Alarms;

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
    pub alarms: Option<Arc<Alarms>>,
    pub sheets: Sheets,
    pub holding: Arc<Holding>,
}

/// The address that a request comes from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Caller(pub IpAddr);

impl Caller {
    /// What stands for one that is not known.
    pub(super) fn nowhere() -> Caller {
        Caller(Ipv4Addr::UNSPECIFIED.into())
    }

    /// That of a request.
    fn of(request: &Request) -> Caller {
        let from = request.extensions().get::<Caller>().copied();
        from.unwrap_or(Caller::nowhere())
    }
}

/// Lets a request pass whose sender may watch; who that is goes with it.
pub(super) async fn enter(
    State(api): State<Api>,
    mut request: Request,
    next: Next,
) -> Response<Body> {
    let answer = match api.who(request.headers(), Caller::of(&request)).await {
        Ok(who) => {
            request.extensions_mut().insert(who);
            next.run(request).await
        }
        Err(status) => status.into_response(),
    };
    guarded(answer)
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
    pub(super) fn metrics(&self) -> Response<Body> {
        text(PROMETHEUS, self.text())
    }

    /// Who sends these headers, from this address; else why it is told nothing.
    async fn who(&self, headers: &HeaderMap, Caller(from): Caller) -> Result<Who, StatusCode> {
        if !doors::lets_in(headers, self.door) {
            return Err(StatusCode::FORBIDDEN);
        }
        let first = self.gateways.first().ok_or(StatusCode::NOT_FOUND)?;
        let who = first.guard.who(token(headers), from).await;
        who.map_err(|stays| match stays {
            Stays::Wrong => StatusCode::UNAUTHORIZED,
            Stays::Often => StatusCode::TOO_MANY_REQUESTS,
        })
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
            "The last value read from a point of a board",
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
        self.alarms_to(&mut text);
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

    fn alarms_to(&self, text: &mut String) {
        let Some(alarms) = &self.alarms else {
            return;
        };
        let standing = alarms.standing();
        let mut tell = |name, help, is: fn(unoclp_alarm::State) -> bool| {
            head(text, name, help, false);
            for of in &standing {
                let labels = [("alarm", &*of.name), ("severity", of.severity.word())];
                line(text, name, &labels, u8::from(is(of.state)));
            }
        };
        tell(
            "alarm_active",
            "Whether the condition of an alarm holds",
            unoclp_alarm::State::holds,
        );
        tell(
            "alarm_unacknowledged",
            "Whether an alarm waits to be acknowledged",
            unoclp_alarm::State::waits,
        );
    }
}

/// An answer as JSON.
pub(super) fn json<T: Serialize>(answer: Result<T, No>) -> Response<Body> {
    match answer {
        Ok(answer) => match serde_json::to_string(&answer) {
            Ok(answer) => text(JSON, answer),
            Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
        },
        Err(no) => wrong(no),
    }
}

/// The token of these headers: `Authorization: Bearer TOKEN`, where a token is asked for.
fn token(headers: &HeaderMap) -> &str {
    let given = headers
        .get(AUTHORIZATION)
        .and_then(|value| value.to_str().ok());
    let token = given.and_then(|given| given.strip_prefix("Bearer "));
    token.unwrap_or_default()
}

fn board(gateway: &Gateway) -> BoardNow {
    let presence = gateway.line.presence().borrow().clone();
    let doing = gateway.condition().filter(|_| presence.is_ok());
    BoardNow {
        name: gateway.name.clone(),
        up: presence.is_ok(),
        doing: doing.map(|doing| doing.state.name()),
        fault: doing.map(|doing| doing.fault).filter(|fault| *fault != 0),
        line: doing.map(|doing| doing.line).filter(|line| *line != 0),
        forced: doing.is_some_and(|doing| doing.is_forced),
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
