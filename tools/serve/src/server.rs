//! The server: connections within limits, files, and visitors.

use crate::api::{self, Api, Archive, Caller, Sheets};
use crate::doors::{self, Door};
use crate::gateway::{self, Gateway, LONGEST, PROMPT};
use crate::holding::Holding;
use crate::modbus;
use crate::news;
use crate::orders;
use crate::page::{self, Pages};
use crate::poll;
use crate::release;
use crate::sharing::{Sharing, Unit, Wired};
use crate::slots::{Slot, Slots};
use crate::tls::Tls;
use crate::tokens::Visitor;
use axum::body::Body;
use axum::extract::{Path, State, WebSocketUpgrade};
use axum::http::{HeaderMap, Request, Response, StatusCode, Uri};
use axum::response::IntoResponse;
use axum::routing::get;
use axum::{Extension, Router};
use hyper::body::Incoming;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::io;
use std::net::{IpAddr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_io_timeout::TimeoutStream;
use tower::ServiceExt;

/// Connections at a time that have shown no token: for files of the page, or to show one. One more takes the place of another.
const CONNECTIONS: usize = 128;
/// Those of one address. A browser takes six.
const CONNECTIONS_EACH: usize = 32;
/// The longest head, bytes.
const LONGEST_HEAD: usize = 16 << 10;

/// A server that is bound to its address.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    tls: Option<Tls>,
}

/// What every request is answered from.
#[derive(Clone)]
struct Shared {
    pages: Arc<dyn Pages>,
    door: Door,
    gateways: Arc<[Arc<Gateway>]>,
    api: Api,
    /// The number of the next visitor.
    next: Arc<AtomicU64>,
}

/// A connection that has shown no token yet.
#[derive(Clone)]
struct Connection {
    slot: Arc<Slot>,
    address: IpAddr,
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
        Ok(Server {
            listener,
            address,
            tls: None,
        })
    }

    /// The same, with encrypted connections alone.
    #[must_use]
    pub fn encrypted(self, tls: Option<Tls>) -> Server {
        Server { tls, ..self }
    }

    /// Where it is.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Whether only this PC reaches it.
    pub fn is_local(&self) -> bool {
        self.address.ip().is_loopback()
    }

    /// Serves the page, and shares the boards if there are some, until `end` comes. Then all connections are cut.
    ///
    /// # Errors
    /// Where the system takes the address away.
    pub fn run(
        self,
        pages: impl Pages,
        sharing: Option<Sharing>,
        end: impl Future<Output = ()>,
    ) -> io::Result<()> {
        let door = Door {
            is_local: self.is_local(),
            is_tls: self.tls.is_some(),
        };
        let Wired {
            boards,
            modbus,
            orders,
            metrics,
            past,
            alarms,
            panels,
            keep,
            tell,
        } = sharing.map(Sharing::wire).unwrap_or_default();
        let holding = Arc::new(Holding::default());
        let gateways: Arc<[_]> = boards.iter().map(|board| board.gateway.clone()).collect();
        let sheets = boards
            .iter()
            .map(|board| (board.unit, &*board.gateway, board.watched.as_ref()));
        let api = Api {
            gateways: gateways.clone(),
            door,
            metrics,
            archive: Archive::new(past),
            alarms: alarms.clone(),
            sheets: Sheets::new(panels, sheets),
            holding: holding.clone(),
        };
        let shared = Shared {
            pages: Arc::new(pages),
            api,
            door,
            gateways,
            next: Arc::default(),
        };
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()?;
        runtime.block_on(async {
            for Unit {
                gateway,
                program,
                watched,
                ..
            } in &boards
            {
                tokio::spawn(release::attend(gateway.clone()));
                if let Some(watched) = watched {
                    let watching = poll::attend(gateway.clone(), watched.clone(), keep.clone());
                    tokio::spawn(watching);
                }
                if let Some(tell) = &tell {
                    tokio::spawn(news::attend(gateway.clone(), *program, tell.clone()));
                }
            }
            let units = boards.into_iter().map(|board| (board.unit, board.gateway));
            let units: Vec<_> = units.collect();
            if let Some(orders) = orders {
                tokio::spawn(orders::attend(orders, units.clone(), alarms));
            }
            let held = holding.clone();
            tokio::spawn(async move { held.attend().await });
            let pages = take_connections(self.listener, self.tls, shared);
            let served = async {
                match modbus {
                    Some(modbus) => {
                        let units = modbus::serve(modbus, units);
                        tokio::try_join!(pages, units).map(drop)
                    }
                    None => pages.await,
                }
            };
            tokio::select! {
                served = served => served,
                () = end => {
                    // A board that does not answer by then keeps what it has.
                    let _ = timeout(PROMPT, holding.end()).await;
                    Ok(())
                }
            }
        })
    }
}

async fn take_connections(
    listener: TcpListener,
    tls: Option<Tls>,
    shared: Shared,
) -> io::Result<()> {
    let listener = tokio::net::TcpListener::from_std(listener)?;
    let routes = Router::new()
        .route("/line", get(first))
        .route("/line/{board}", get(named))
        .fallback(get(file))
        .with_state(shared.clone())
        .merge(api::routes(shared.api));
    let slots = Slots::new(CONNECTIONS, CONNECTIONS_EACH);
    loop {
        match listener.accept().await {
            Ok((stream, from)) => {
                let address = from.ip();
                let slot = Arc::new(slots.take(address));
                let connection = Connection { slot, address };
                tokio::spawn(serve(stream, tls.clone(), routes.clone(), connection));
            }
            // A visitor that is gone already, or too many open files: the next one may come.
            Err(_) => tokio::time::sleep(Duration::from_millis(10)).await,
        }
    }
}

/// Serves a connection until it ends, is too slow, or another takes its place.
async fn serve(stream: TcpStream, tls: Option<Tls>, routes: Router, connection: Connection) {
    let slot = connection.slot.clone();
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(PROMPT));
    let stream = Box::pin(stream);
    let served = async {
        match tls {
            None => speak(stream, routes, connection).await,
            Some(tls) => {
                // Who does not agree on it in time is not served.
                if let Ok(Ok(stream)) = timeout(PROMPT, tls.acceptor.accept(stream)).await {
                    speak(stream, routes, connection).await;
                }
            }
        }
    };
    tokio::select! {
        () = served => {}
        () = slot.is_given_up() => {}
    }
}

/// Speaks HTTP.
async fn speak<S>(stream: S, routes: Router, connection: Connection)
where
    S: AsyncRead + AsyncWrite + Unpin + Send + 'static,
{
    let service = routes.map_request(move |mut request: Request<Incoming>| {
        connection.slot.is_used();
        request.extensions_mut().insert(Caller(connection.address));
        request.extensions_mut().insert(connection.clone());
        request
    });
    let served = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(PROMPT)
        .max_buf_size(LONGEST_HEAD)
        .serve_connection(TokioIo::new(stream), TowerToHyperService::new(service))
        .with_upgrades();
    // How a connection has ended is nobody's concern.
    drop(served.await);
}

async fn file(State(shared): State<Shared>, headers: HeaderMap, uri: Uri) -> Response<Body> {
    if !doors::lets_in(&headers, shared.door) {
        return StatusCode::FORBIDDEN.into_response();
    }
    page::file(&*shared.pages, uri.path())
}

/// A visitor of the first board.
async fn first(
    State(shared): State<Shared>,
    Extension(connection): Extension<Connection>,
    headers: HeaderMap,
    upgrade: WebSocketUpgrade,
) -> Response<Body> {
    let gateway = shared.gateways.first().cloned();
    visit(shared, connection, &headers, upgrade, gateway)
}

/// A visitor of the board of this name.
async fn named(
    State(shared): State<Shared>,
    Path(name): Path<String>,
    Extension(connection): Extension<Connection>,
    headers: HeaderMap,
    upgrade: WebSocketUpgrade,
) -> Response<Body> {
    let of_name = |gateway: &&Arc<Gateway>| gateway.name == name;
    let gateway = shared.gateways.iter().find(of_name).cloned();
    visit(shared, connection, &headers, upgrade, gateway)
}

fn visit(
    shared: Shared,
    Connection { slot, address }: Connection,
    headers: &HeaderMap,
    upgrade: WebSocketUpgrade,
    gateway: Option<Arc<Gateway>>,
) -> Response<Body> {
    if !doors::lets_in(headers, shared.door) {
        return StatusCode::FORBIDDEN.into_response();
    }
    let Some(gateway) = gateway else {
        return StatusCode::NOT_FOUND.into_response();
    };
    let visitor: Visitor = shared.next.fetch_add(1, Ordering::Relaxed);
    upgrade
        .max_message_size(LONGEST)
        .max_frame_size(LONGEST)
        .write_buffer_size(LONGEST)
        .max_write_buffer_size(64 * LONGEST)
        .on_upgrade(async move |socket| {
            gateway::serve(gateway, visitor, address, slot, socket).await;
        })
}
