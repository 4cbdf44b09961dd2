//! What is asked over HTTP, and the page that describes it.

use super::alarms::{LONGEST, Span};
use super::answers::{
    AlarmNow, AlarmPast, Asker, BindOf, BoardNow, DeedOf, Done, Health, ItemOf, NameOf, PanelOf,
    PastOf, PastRow, PointOf, Taken, Texts, Wrong,
};
use super::gate::{Api, Caller, enter, json};
use super::past::{Asked, No};
use super::text::{csv_file, wrong};
use crate::guard::Who;
use axum::body::{Body, Bytes};
use axum::extract::rejection::{BytesRejection, QueryRejection};
use axum::extract::{DefaultBodyLimit, Query, State};
use axum::http::Response;
use axum::routing::{get, post};
use axum::{Extension, Router, middleware};
use unoclp_history::{Row, csv};
use unoclp_record::{csv_of_alarms, csv_of_deeds};
use utoipa::OpenApi;

/// The page that describes what is asked.
#[derive(OpenApi)]
#[openapi(
    info(
        title = "unoclp serve",
        description = "The boards of a site. See docs/site.md."
    ),
    paths(
        health,
        boards,
        points,
        history,
        history_csv,
        alarms,
        alarms_past,
        alarms_csv,
        acknowledge,
        deeds,
        deeds_csv,
        asker,
        names,
        panels,
        write,
        metrics,
        description
    ),
    components(schemas(
        Health, BoardNow, PointOf, PastOf, PastRow, AlarmNow, AlarmPast, DeedOf, Done, Texts,
        Wrong, Asker, NameOf, PanelOf, ItemOf, BindOf, Taken
    ))
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
        .route("/api/alarms", get(alarms))
        .route("/api/alarms/history", get(alarms_past))
        .route("/api/alarms/history.csv", get(alarms_csv))
        .route("/api/alarms/acknowledge", post(acknowledge))
        .route("/api/deeds", get(deeds))
        .route("/api/deeds.csv", get(deeds_csv))
        .route("/api/who", get(asker))
        .route("/api/names", get(names))
        .route("/api/panels", get(panels))
        .route("/api/write", post(write))
        .route("/api/openapi.json", get(description))
        .layer(DefaultBodyLimit::max(LONGEST))
        .route_layer(middleware::from_fn_with_state(api.clone(), enter))
        .with_state(api)
}

#[utoipa::path(get, path = "/health", responses((status = 200, description = "How many boards answer", body = Health)))]
async fn health(State(api): State<Api>) -> Response<Body> {
    json(Ok(api.health()))
}

#[utoipa::path(get, path = "/api/boards", responses((status = 200, description = "Each board, and the values of its points", body = Vec<BoardNow>)))]
async fn boards(State(api): State<Api>) -> Response<Body> {
    json(Ok(api.boards()))
}

#[utoipa::path(get, path = "/metrics", responses((status = 200, description = "The same for Prometheus", content_type = "text/plain")))]
async fn metrics(State(api): State<Api>) -> Response<Body> {
    api.metrics()
}

#[utoipa::path(get, path = "/api/openapi.json", responses((status = 200, description = "This description", content_type = "application/json")))]
async fn description() -> Response<Body> {
    json(Ok(Description::openapi()))
}

#[utoipa::path(get, path = "/api/points", responses(
    (status = 200, description = "The points that the history has", body = Vec<PointOf>),
    (status = 404, description = "The site keeps no history", body = Wrong),
    (status = 503, description = "The history cannot be read now", body = Wrong)))]
async fn points(State(api): State<Api>) -> Response<Body> {
    json(api.archive.points().await)
}

#[utoipa::path(get, path = "/api/history", params(
    ("board" = String, Query, description = "The board"),
    ("point" = String, Query, description = "The point"),
    ("from" = Option<i64>, Query, description = "From this time on, in ms since 1970"),
    ("to" = Option<i64>, Query, description = "Up to this time, not included, in ms since 1970"),
    ("last" = Option<String>, Query, description = "Instead of `from`: how far back, such as 90s, 15m, 1h or 30d; the default is 1h"),
    ("step" = Option<String>, Query, description = "One row for each interval of this length; by default, one row for each change"),
    ("most" = Option<u32>, Query, description = "The maximum number of rows, 1 to 100000; the default is 10000")),
    responses(
    (status = 200, description = "The values of the point", body = PastOf),
    (status = 400, description = "The request is not valid", body = Wrong),
    (status = 404, description = "The history has no such point", body = Wrong),
    (status = 503, description = "The history cannot be read now", body = Wrong)))]
async fn history(
    State(api): State<Api>,
    asked: Result<Query<Asked>, QueryRejection>,
) -> Response<Body> {
    json(past(&api, asked).await)
}

#[utoipa::path(get, path = "/api/history.csv", params(
    ("board" = String, Query, description = "The board"),
    ("point" = String, Query, description = "The point"),
    ("from" = Option<i64>, Query, description = "From this time on, in ms since 1970"),
    ("to" = Option<i64>, Query, description = "Up to this time, not included, in ms since 1970"),
    ("last" = Option<String>, Query, description = "Instead of `from`: how far back, such as 90s, 15m, 1h or 30d; the default is 1h"),
    ("step" = Option<String>, Query, description = "One row for each interval of this length; by default, one row for each change"),
    ("most" = Option<u32>, Query, description = "The maximum number of rows, 1 to 100000; the default is 10000")),
    responses(
    (status = 200, description = "The same as comma-separated values, to save as a file", content_type = "text/csv"),
    (status = 400, description = "The request is not valid", body = Wrong),
    (status = 404, description = "The history has no such point", body = Wrong),
    (status = 503, description = "The history cannot be read now", body = Wrong)))]
async fn history_csv(
    State(api): State<Api>,
    asked: Result<Query<Asked>, QueryRejection>,
) -> Response<Body> {
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
            csv_file(&format!("{board}.{point}"), csv(&rows))
        }
    }
}

async fn past(api: &Api, asked: Result<Query<Asked>, QueryRejection>) -> Result<PastOf, No> {
    let Query(asked) = asked.map_err(|_| No::Point)?;
    api.archive.rows(asked).await
}

#[utoipa::path(get, path = "/api/alarms", responses((status = 200, description = "The state of each alarm", body = Vec<AlarmNow>)))]
async fn alarms(State(api): State<Api>) -> Response<Body> {
    json(Ok(api.alarms_now()))
}

#[utoipa::path(get, path = "/api/alarms/history", params(
    ("from" = Option<i64>, Query, description = "From this time on, in ms since 1970"),
    ("to" = Option<i64>, Query, description = "Up to this time, not included, in ms since 1970"),
    ("last" = Option<String>, Query, description = "Instead of `from`: how far back, such as 90s, 15m, 1h or 30d; by default, everything"),
    ("most" = Option<u32>, Query, description = "The number of latest rows, 1 to 100000; the default is 10000")),
    responses(
    (status = 200, description = "The history of the alarms", body = Vec<AlarmPast>),
    (status = 400, description = "The request is not valid", body = Wrong),
    (status = 404, description = "The site keeps no record", body = Wrong),
    (status = 503, description = "The record cannot be read now", body = Wrong)))]
async fn alarms_past(
    State(api): State<Api>,
    span: Result<Query<Span>, QueryRejection>,
) -> Response<Body> {
    let rows = api.alarms_past(of(span)).await;
    json(rows.map(|rows| rows.into_iter().map(AlarmPast::from).collect::<Vec<_>>()))
}

#[utoipa::path(get, path = "/api/alarms/history.csv", params(
    ("from" = Option<i64>, Query, description = "From this time on, in ms since 1970"),
    ("to" = Option<i64>, Query, description = "Up to this time, not included, in ms since 1970"),
    ("last" = Option<String>, Query, description = "Instead of `from`: how far back, such as 90s, 15m, 1h or 30d; by default, everything"),
    ("most" = Option<u32>, Query, description = "The number of latest rows, 1 to 100000; the default is 10000")),
    responses(
    (status = 200, description = "The same as comma-separated values", content_type = "text/csv"),
    (status = 400, description = "The request is not valid", body = Wrong),
    (status = 404, description = "The site keeps no record", body = Wrong),
    (status = 503, description = "The record cannot be read now", body = Wrong)))]
async fn alarms_csv(
    State(api): State<Api>,
    span: Result<Query<Span>, QueryRejection>,
) -> Response<Body> {
    match api.alarms_past(of(span)).await {
        Ok(rows) => csv_file("alarms", csv_of_alarms(&rows)),
        Err(no) => wrong(no),
    }
}

#[utoipa::path(post, path = "/api/alarms/acknowledge",
    request_body(content = String, content_type = "application/json", description = "{\"alarm\": NAME}"),
    responses(
    (status = 200, description = "The alarm is acknowledged; the answer has its state", body = Done),
    (status = 400, description = "The request names no alarm", body = Wrong),
    (status = 403, description = "This needs the role operate", body = Wrong),
    (status = 404, description = "There is no such alarm", body = Wrong),
    (status = 409, description = "There is nothing to acknowledge", body = Wrong),
    (status = 503, description = "Alarms are not evaluated at present", body = Wrong)))]
async fn acknowledge(
    State(api): State<Api>,
    Extension(who): Extension<Who>,
    from: Option<Extension<Caller>>,
    body: Result<Bytes, BytesRejection>,
) -> Response<Body> {
    let from = from.map_or(Caller::nowhere(), |Extension(from)| from);
    match body {
        Ok(body) => json(api.acknowledge(who, from, &body).await),
        // It is too long.
        Err(_) => wrong(No::Value),
    }
}

#[utoipa::path(get, path = "/api/deeds", params(
    ("from" = Option<i64>, Query, description = "From this time on, in ms since 1970"),
    ("to" = Option<i64>, Query, description = "Up to this time, not included, in ms since 1970"),
    ("last" = Option<String>, Query, description = "Instead of `from`: how far back, such as 90s, 15m, 1h or 30d; by default, everything"),
    ("most" = Option<u32>, Query, description = "The number of latest rows, 1 to 100000; the default is 10000")),
    responses(
    (status = 200, description = "Who did what", body = Vec<DeedOf>),
    (status = 400, description = "The request is not valid", body = Wrong),
    (status = 404, description = "The site keeps no record", body = Wrong),
    (status = 503, description = "The record cannot be read now", body = Wrong)))]
async fn deeds(
    State(api): State<Api>,
    span: Result<Query<Span>, QueryRejection>,
) -> Response<Body> {
    let rows = api.deeds(of(span)).await;
    json(rows.map(|rows| rows.into_iter().map(DeedOf::from).collect::<Vec<_>>()))
}

#[utoipa::path(get, path = "/api/deeds.csv", params(
    ("from" = Option<i64>, Query, description = "From this time on, in ms since 1970"),
    ("to" = Option<i64>, Query, description = "Up to this time, not included, in ms since 1970"),
    ("last" = Option<String>, Query, description = "Instead of `from`: how far back, such as 90s, 15m, 1h or 30d; by default, everything"),
    ("most" = Option<u32>, Query, description = "The number of latest rows, 1 to 100000; the default is 10000")),
    responses(
    (status = 200, description = "The same as comma-separated values", content_type = "text/csv"),
    (status = 400, description = "The request is not valid", body = Wrong),
    (status = 404, description = "The site keeps no record", body = Wrong),
    (status = 503, description = "The record cannot be read now", body = Wrong)))]
async fn deeds_csv(
    State(api): State<Api>,
    span: Result<Query<Span>, QueryRejection>,
) -> Response<Body> {
    match api.deeds(of(span)).await {
        Ok(rows) => csv_file("deeds", csv_of_deeds(&rows)),
        Err(no) => wrong(no),
    }
}

#[utoipa::path(get, path = "/api/who", responses((status = 200, description = "The user who sends the request, and this user's rights", body = Asker)))]
async fn asker(Extension(who): Extension<Who>) -> Response<Body> {
    json(Ok(Asker {
        name: who.name.to_string(),
        may: who.may.word(),
    }))
}

#[utoipa::path(get, path = "/api/names", responses((status = 200, description = "The points of each board", body = Vec<NameOf>)))]
async fn names(State(api): State<Api>) -> Response<Body> {
    json(Ok(api.sheets.names()))
}

#[utoipa::path(get, path = "/api/panels", responses((status = 200, description = "The panels", body = Vec<PanelOf>)))]
async fn panels(State(api): State<Api>) -> Response<Body> {
    json(Ok(api.sheets.panels()))
}

#[utoipa::path(post, path = "/api/write",
    request_body(content = String, content_type = "application/json", description = "{\"board\": NAME, \"point\": NAME, \"value\": NUMBER}; with \"hold\": \"begin\", the gateway writes 0 unless it hears \"hold\": \"still\" every 3 s"),
    responses(
    (status = 200, description = "The board has accepted the value", body = Taken),
    (status = 400, description = "The value is not valid for this point", body = Wrong),
    (status = 403, description = "This needs the role operate", body = Wrong),
    (status = 404, description = "No panel allows writing to this point", body = Wrong),
    (status = 409, description = "Somebody else controls the board, it has another program, or the button is no longer held", body = Wrong),
    (status = 503, description = "The board does not answer", body = Wrong)))]
async fn write(
    State(api): State<Api>,
    Extension(who): Extension<Who>,
    from: Option<Extension<Caller>>,
    body: Result<Bytes, BytesRejection>,
) -> Response<Body> {
    let from = from.map_or(Caller::nowhere(), |Extension(from)| from);
    match body {
        Ok(body) => json(api.write(who, from, &body).await),
        // It is too long.
        Err(_) => wrong(No::Value),
    }
}

fn of(span: Result<Query<Span>, QueryRejection>) -> Result<Span, No> {
    span.map(|Query(span)| span).map_err(|_| No::Time)
}
