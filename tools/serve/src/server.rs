//! The server: connections within limits, files, and visitors.

use crate::control::{Control, Visitor};
use crate::doors;
use crate::gateway::{self, Gateway, LONGEST};
use crate::line::Line;
use crate::page::{self, Pages};
use crate::tokens::Tokens;
use axum::Router;
use axum::body::Body;
use axum::extract::{State, WebSocketUpgrade};
use axum::http::{HeaderMap, Response, StatusCode, Uri};
use axum::response::IntoResponse;
use axum::routing::get;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::io;
use std::net::{SocketAddr, TcpListener};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tokio::sync::Semaphore;

/// Connections at a time; more wait.
const CONNECTIONS: usize = 128;
/// Visitors of the board at a time; more are refused.
const VISITORS: usize = 64;
/// Within this the head of a request has come.
const HEAD: Duration = Duration::from_secs(10);
/// The longest head, bytes.
const LONGEST_HEAD: usize = 16 << 10;

/// A board that is shared.
#[derive(Debug)]
pub struct Sharing {
    /// The line to it.
    pub line: Line,
    /// What it is called in the page.
    pub name: String,
    /// Who may do what; without them, everybody on this PC may do all. Only then is the server bound to this PC.
    pub tokens: Option<Tokens>,
}

/// A server that is bound to its address.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
}

/// What every request is answered from.
#[derive(Clone)]
struct Shared {
    pages: Pages,
    is_local: bool,
    gateway: Option<Arc<Gateway>>,
    /// The number of the next visitor.
    next: Arc<AtomicU64>,
    /// For how many more there is room.
    room: Arc<Semaphore>,
}

impl Server {
    /// Takes this address; port 0 takes a free one.
    ///
    /// # Errors
    /// Where it is somebody else's, or none of this PC.
    pub fn bind(address: SocketAddr) -> io::Result<Server> {
        let listener = TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok(Server { listener, address })
    }

    /// Where it is.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Whether only this PC reaches it.
    pub fn is_local(&self) -> bool {
        self.address.ip().is_loopback()
    }

    /// Serves the page, and shares the board if there is one, for ever.
    ///
    /// # Errors
    /// Where the system takes the address away.
    pub fn run(self, pages: Pages, sharing: Option<Sharing>) -> io::Result<()> {
        let is_local = self.is_local();
        let gateway = sharing.map(|Sharing { line, name, tokens }| {
            let control = Mutex::new(Control::default());
            Arc::new(Gateway {
                line,
                name,
                control,
                tokens,
            })
        });
        let shared = Shared {
            pages,
            is_local,
            gateway,
            next: Arc::default(),
            room: Arc::new(Semaphore::new(VISITORS)),
        };
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()?;
        runtime.block_on(take_connections(self.listener, shared))
    }
}

async fn take_connections(listener: TcpListener, shared: Shared) -> io::Result<()> {
    let listener = tokio::net::TcpListener::from_std(listener)?;
    let routes = Router::new()
        .route("/line", get(line))
        .fallback(get(file))
        .with_state(shared);
    let room = Arc::new(Semaphore::new(CONNECTIONS));
    loop {
        // It is closed by nobody.
        let Ok(place) = room.clone().acquire_owned().await else {
            return Ok(());
        };
        let stream = match listener.accept().await {
            Ok((stream, _)) => stream,
            // A visitor that is gone already, or too many open files: the next one may come.
            Err(_) => {
                tokio::time::sleep(Duration::from_millis(10)).await;
                continue;
            }
        };
        let service = TowerToHyperService::new(routes.clone());
        tokio::spawn(async move {
            let served = hyper::server::conn::http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(HEAD)
                .max_buf_size(LONGEST_HEAD)
                .serve_connection(TokioIo::new(stream), service)
                .with_upgrades()
                .await;
            // How a visitor has left is nobody's concern.
            drop(served);
            drop(place);
        });
    }
}

async fn file(State(shared): State<Shared>, headers: HeaderMap, uri: Uri) -> Response<Body> {
    if !doors::lets_in(&headers, shared.is_local) {
        return StatusCode::FORBIDDEN.into_response();
    }
    page::file(shared.pages, uri.path())
}

async fn line(
    State(shared): State<Shared>,
    headers: HeaderMap,
    upgrade: WebSocketUpgrade,
) -> Response<Body> {
    if !doors::lets_in(&headers, shared.is_local) {
        return StatusCode::FORBIDDEN.into_response();
    }
    let Some(gateway) = shared.gateway else {
        return StatusCode::NOT_FOUND.into_response();
    };
    let Ok(place) = shared.room.try_acquire_owned() else {
        return StatusCode::SERVICE_UNAVAILABLE.into_response();
    };
    let visitor: Visitor = shared.next.fetch_add(1, Ordering::Relaxed);
    upgrade
        .max_message_size(LONGEST)
        .max_frame_size(LONGEST)
        .write_buffer_size(LONGEST)
        .max_write_buffer_size(64 * LONGEST)
        .on_upgrade(async move |socket| {
            gateway::serve(gateway, visitor, socket).await;
            drop(place);
        })
}
