//! What is asked over HTTP, and the page that describes it.

use super::answers::{BoardNow, Health, PastOf, PastRow, PointOf, Wrong};
use super::gate::Api;
use super::past::{Asked, No};
use super::text::{CSV, text, wrong};
use axum::Router;
use axum::body::Body;
use axum::extract::rejection::QueryRejection;
use axum::extract::{Query, State};
use axum::http::header::CONTENT_DISPOSITION;
use axum::http::{HeaderMap, HeaderValue, Response};
use axum::routing::get;
use unoclp_history::{Row, csv};
use utoipa::OpenApi;

/// The page that describes what is asked.
#[derive(OpenApi)]
#[openapi(
    info(
        title = "unoclp serve",
        description = "The boards of a site. See docs/site.md."
    ),
    paths(health, boards, points, history, history_csv, metrics, description),
    components(schemas(Health, BoardNow, PointOf, PastOf, PastRow, Wrong))
)]
struct Description;

/// The ways to all of it.
pub(crate) fn routes(api: Api) -> Router {
    Router::new()
        .route("/health", get(health))
        .route("/metrics", get(metrics))
        .route("/api/boards", get(boards))
        .route("/api/points", get(points))
        .route("/api/history", get(history))
        .route("/api/history.csv", get(history_csv))
        .route("/api/openapi.json", get(description))
        .with_state(api)
}

#[utoipa::path(get, path = "/health", responses((status = 200, description = "How many boards answer", body = Health)))]
async fn health(State(api): State<Api>, headers: HeaderMap) -> Response<Body> {
    api.json(&headers, async { Ok(api.health()) }).await
}

#[utoipa::path(get, path = "/api/boards", responses((status = 200, description = "Each board, and what its points are", body = Vec<BoardNow>)))]
async fn boards(State(api): State<Api>, headers: HeaderMap) -> Response<Body> {
    api.json(&headers, async { Ok(api.boards()) }).await
}

#[utoipa::path(get, path = "/metrics", responses((status = 200, description = "The same for Prometheus", content_type = "text/plain")))]
async fn metrics(State(api): State<Api>, headers: HeaderMap) -> Response<Body> {
    api.metrics(&headers)
}

#[utoipa::path(get, path = "/api/openapi.json", responses((status = 200, description = "This description", content_type = "application/json")))]
async fn description(State(api): State<Api>, headers: HeaderMap) -> Response<Body> {
    api.json(&headers, async { Ok(Description::openapi()) })
        .await
}

#[utoipa::path(get, path = "/api/points", responses(
    (status = 200, description = "The points that the history has", body = Vec<PointOf>),
    (status = 404, description = "The site keeps no history", body = Wrong),
    (status = 503, description = "The history cannot be read now", body = Wrong)))]
async fn points(State(api): State<Api>, headers: HeaderMap) -> Response<Body> {
    api.json(&headers, api.archive.points()).await
}

#[utoipa::path(get, path = "/api/history", params(
    ("board" = String, Query, description = "The board"),
    ("point" = String, Query, description = "The point"),
    ("from" = Option<i64>, Query, description = "From this moment on, ms since 1970"),
    ("to" = Option<i64>, Query, description = "Until before this moment, ms since 1970"),
    ("last" = Option<String>, Query, description = "In place of `from`: how far back, 90s, 15m, 1h, 30d; 1h without both"),
    ("step" = Option<String>, Query, description = "One row for so long; without it, each change"),
    ("most" = Option<u32>, Query, description = "At most so many rows, 1 to 100000; 10000 without it")),
    responses(
    (status = 200, description = "What the point was", body = PastOf),
    (status = 400, description = "What is asked makes no sense", body = Wrong),
    (status = 404, description = "The history has no such point", body = Wrong),
    (status = 503, description = "The history cannot be read now", body = Wrong)))]
async fn history(
    State(api): State<Api>,
    headers: HeaderMap,
    asked: Result<Query<Asked>, QueryRejection>,
) -> Response<Body> {
    api.json(&headers, past(&api, asked)).await
}

#[utoipa::path(get, path = "/api/history.csv", params(
    ("board" = String, Query, description = "The board"),
    ("point" = String, Query, description = "The point"),
    ("from" = Option<i64>, Query, description = "From this moment on, ms since 1970"),
    ("to" = Option<i64>, Query, description = "Until before this moment, ms since 1970"),
    ("last" = Option<String>, Query, description = "In place of `from`: how far back, 90s, 15m, 1h, 30d; 1h without both"),
    ("step" = Option<String>, Query, description = "One row for so long; without it, each change"),
    ("most" = Option<u32>, Query, description = "At most so many rows, 1 to 100000; 10000 without it")),
    responses(
    (status = 200, description = "The same as comma-separated values, to be kept as a file", content_type = "text/csv"),
    (status = 400, description = "What is asked makes no sense", body = Wrong),
    (status = 404, description = "The history has no such point", body = Wrong),
    (status = 503, description = "The history cannot be read now", body = Wrong)))]
async fn history_csv(
    State(api): State<Api>,
    headers: HeaderMap,
    asked: Result<Query<Asked>, QueryRejection>,
) -> Response<Body> {
    if let Some(refused) = api.refused(&headers) {
        return refused;
    }
    match past(&api, asked).await {
        Err(no) => wrong(no),
        Ok(PastOf {
            board, point, rows, ..
        }) => {
            let row = |row: &PastRow| Row {
                at: row.at,
                least: row.least,
                most: row.most,
                last: row.last,
            };
            let rows: Vec<Row> = rows.iter().map(row).collect();
            let mut response = text(CSV, csv(&rows));
            let plain = |ch: char| match ch.is_ascii_alphanumeric() || "-_.".contains(ch) {
                true => ch,
                false => '_',
            };
            let name: String = format!("{board}.{point}").chars().map(plain).collect();
            let file = format!("attachment; filename=\"{name}.csv\"");
            if let Ok(file) = HeaderValue::from_str(&file) {
                response.headers_mut().insert(CONTENT_DISPOSITION, file);
            }
            response
        }
    }
}

async fn past(api: &Api, asked: Result<Query<Asked>, QueryRejection>) -> Result<PastOf, No> {
    let Query(asked) = asked.map_err(|_| No::Point)?;
    api.archive.rows(asked).await
}
