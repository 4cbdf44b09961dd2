//! The page inside this program, and the boards at lines of this PC as the gateway takes them.

use crate::alarms;
use crate::archive::Archive;
use crate::broker;
use crate::ended;
use crate::identity;
use crate::kept::Kept;
use crate::messages;
use crate::metrics::metrics;
use crate::port::{Found, NotFound, Place, Port, find};
use crate::stores;
use anyhow::{Context, anyhow};
use rust_embed::RustEmbed;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use unoclp_alarm::Alarms;
use unoclp_client::identity::Identity;
use unoclp_client::{Failure, Patience};
use unoclp_core::Board as Kind;
use unoclp_journal::Sample;
use unoclp_modbus::client::Request;
use unoclp_report::Reporter;
use unoclp_serve::{
    Absent, Board, Change, Guard, Keep, Line, Modbus, News, NoAnswer, Pages, Past, Remote, Server,
    SharedBoard, Sharing, Tell, Tokens, Users, Watched,
};
use unoclp_site::{Site, Way};

/// What `cargo xtask lab --build` has built.
#[derive(RustEmbed)]
#[folder = "../../target/lab/page"]
struct Files;

/// A file of the page.
pub fn page(path: &str) -> Option<Cow<'static, [u8]>> {
    Files::get(path).map(|file| file.data)
}

/// Serves the page at this address, and shares the board at this place, until somebody ends it. Says where.
///
/// # Errors
/// Where the address cannot be served from.
pub fn share(http: SocketAddr, place: Option<Place>, pages: impl Pages) -> anyhow::Result<()> {
    let wrong = |error| anyhow!(messages::not_served(http, messages::io(&error)));
    let server = Server::bind(http).map_err(wrong)?;
    let page = format!("http://{}/", server.address());
    // By the fragment the page knows that there is a board behind it.
    let board = if place.is_some() && server.is_local() {
        "#board"
    } else {
        ""
    };
    println!("{page}{board}");
    let sharing = match place {
        None => None,
        Some(place) => {
            let guard = guard(&server, &page)?;
            if matches!(guard, Guard::ThisPc) {
                println!("{}", messages::shared(&place.port));
            }
            let address = place.line.address;
            let name = place.port.clone();
            let board = AtPort::new(place, Vec::new());
            Some(Sharing {
                boards: vec![SharedBoard {
                    line: Line::begin(board, address),
                    name,
                    unit: address,
                    program: None,
                    watched: None,
                }],
                guard,
                modbus: None,
                orders: None,
                metrics: None,
                past: None,
                alarms: None,
                panels: Vec::new(),
                record: None,
                keep: None,
                tell: None,
            })
        }
    };
    server.run(pages, sharing, ended::asked()).map_err(wrong)
}

/// Who is let in: everybody on this PC, if it is served alone; else who has a token, and says where they lead.
fn guard(server: &Server, page: &str) -> anyhow::Result<Guard> {
    if server.is_local() {
        return Ok(Guard::ThisPc);
    }
    let tokens = Tokens::random().context("getrandom")?;
    let with = |token: &str| format!("{page}#board={token}");
    println!("{}", messages::watch_at(with(&tokens.watch)));
    println!("{}", messages::control_at(with(&tokens.control)));
    println!("{}", messages::open_to_network());
    Ok(Guard::Tokens(tokens))
}

/// The same of a site, whose users go before all others.
fn guard_of(site: &Site, server: &Server, page: &str) -> anyhow::Result<Guard> {
    if site.users.is_empty() {
        return guard(server, page);
    }
    let users = Users::new(site.users.clone()).map_err(|why| anyhow!(messages::no_key(why.0)))?;
    println!("{}", messages::users_at(page));
    Ok(Guard::Users(users))
}

/// Serves the page, and shares the boards of this site, until somebody ends it. Says where, and what becomes of the boards.
///
/// # Errors
/// Where an address cannot be served from.
pub fn share_site(file: &Path, site: &Site, pages: impl Pages) -> anyhow::Result<()> {
    let wrong = |at, error| anyhow!(messages::not_served_site(at, messages::io(&error)));
    let listen = site.http.listen;
    let tls = identity::tls(file, site)?;
    let server = Server::bind(listen).map_err(|error| wrong(listen, error))?;
    let scheme = if tls.is_some() { "https" } else { "http" };
    let modbus = site.modbus.as_ref().map(|modbus| {
        let bound = Modbus::bind(modbus.listen, modbus.write.clone());
        bound.map_err(|error| wrong(modbus.listen, error))
    });
    let modbus = modbus.transpose()?;
    let kept = site.has_journal().then(|| Kept::begin(file, site));
    let kept = kept.transpose()?.map(Arc::new);
    let record = alarms::record(file, site)?;
    // It ends here, behind the server: the client of a database must not end while a server runs on the same thread.
    let past = archive(file, site)?;
    let page = format!("{scheme}://{}/", server.address());
    println!("{page}{}", if server.is_local() { "#board" } else { "" });
    if let Some(tls) = &tls {
        println!("{}", messages::fingerprint(tls.fingerprint()));
    }
    let guard = guard_of(site, &server, &page)?;
    let server = server.encrypted(tls);
    println!("{}", messages::overview_at(&page));
    for board in site.boards().skip(1) {
        println!("{}", messages::page_of_board(&board.name));
    }
    if let Some(modbus) = &modbus {
        println!("{}", messages::modbus_at(modbus.address()));
    }
    // From here on others say something too.
    let broker = site.mqtt.as_ref().zip(kept.as_ref());
    let broker = broker.map(|(mqtt, kept)| broker::begin(file, site, mqtt, &kept.journal));
    let (reporter, ordered) = broker.transpose()?.unzip();
    let alarms = alarms::alarms(file, site, record.as_ref(), reporter.clone())?;
    let metrics = metrics(kept.clone(), reporter.clone(), record.clone());
    let keep = keep(kept.as_deref(), reporter.clone(), alarms.clone());
    let programs: BTreeMap<_, _> = site
        .boards()
        .cloned()
        .map(|of| (of.name, of.program))
        .collect();
    let of_boards = alarms.clone();
    let tell: Tell = Arc::new(move |board: &str, news| {
        let program = programs.get(board).cloned().flatten().unwrap_or_default();
        match (&reporter, &news) {
            (Some(reporter), News::Found) => reporter.presence(board, true),
            (Some(reporter), News::Away(_)) => reporter.presence(board, false),
            _ => {}
        }
        match (&of_boards, &news) {
            (Some(alarms), News::Found) => alarms.presence(board, true),
            (Some(alarms), News::Away(_)) => alarms.presence(board, false),
            _ => {}
        }
        println!("{}", told(board, &program, news));
    });
    let sharing = Sharing {
        boards: site.lines.iter().flat_map(boards).collect(),
        guard,
        modbus,
        orders: ordered,
        metrics: Some(metrics),
        past: past.clone(),
        alarms: alarms.clone(),
        panels: site.panels.clone(),
        record: record.clone(),
        keep: Some(keep),
        tell: Some(tell),
    };
    let ended = server.run(pages, Some(sharing), ended::asked());
    ended::at_once();
    drop(past);
    if let Some(alarms) = alarms {
        alarms.end();
    }
    if let Some(record) = record {
        record.end();
    }
    // The last of it tells the broker goodbye, and what has come is on disk.
    if let Some(kept) = kept {
        kept.end();
    }
    println!("{}", messages::ended());
    ended.map_err(|error| wrong(listen, error))
}

/// The history of a site, for who asks over HTTP.
fn archive(file: &Path, site: &Site) -> anyhow::Result<Option<Arc<dyn Past>>> {
    let history = site.history.as_ref();
    let database = history.map(|history| stores::database(file, &history.store));
    let archive = database.transpose()?.map(Archive::new);
    Ok(archive.map(|archive| Arc::new(archive) as Arc<dyn Past>))
}

/// Puts what has changed into the journal, and tells it to the broker and the alarms.
fn keep(kept: Option<&Kept>, reporter: Option<Arc<Reporter>>, alarms: Option<Arc<Alarms>>) -> Keep {
    let journal = kept.map(|kept| kept.journal.clone());
    let sample = |change: Change| Sample {
        board: change.board,
        point: change.point,
        at: change.at,
        value: change.value,
    };
    let value = |change: &Change| unoclp_alarm::Value {
        board: change.board.clone(),
        point: change.point.clone(),
        value: change.value,
    };
    Arc::new(move |changes: Vec<Change>| {
        if let Some(alarms) = &alarms {
            alarms.changed(changes.iter().map(value).collect());
        }
        let samples: Vec<Sample> = changes.into_iter().map(sample).collect();
        if let Some(journal) = &journal {
            journal.put(samples.clone());
        }
        if let Some(reporter) = &reporter {
            reporter.changed(samples);
        }
    })
}

/// What has become of a board, in words.
fn told(board: &str, program: &str, news: News) -> String {
    match news {
        News::Found => messages::board_found(board),
        News::Away(why) => messages::board_away(board, why),
        News::Program => messages::board_keeps(board, program),
        News::OtherProgram => messages::board_keeps_other(board, program),
    }
}

/// The boards of a line of a site, each with its way there.
fn boards(line: &unoclp_site::Line) -> impl Iterator<Item = SharedBoard> {
    let addresses: Vec<u8> = line.boards.iter().map(|board| board.address).collect();
    let lines = match &line.way {
        Way::Serial { port, rate, parity } => {
            let place = Place {
                port: port.clone(),
                line: unoclp_client::Line {
                    rate: *rate,
                    parity: *parity,
                    ..unoclp_client::Line::default()
                },
            };
            let kinds = line.boards.iter();
            let kinds = kinds.map(|board| (board.address, board.points.board));
            Line::begin_shared(AtPort::new(place, kinds.collect()), &addresses)
        }
        Way::Tcp { server } => Line::begin_shared(Remote::new(server.clone(), absent), &addresses),
    };
    line.boards
        .iter()
        .zip(lines)
        .map(|(board, line)| SharedBoard {
            line,
            name: board.name.clone(),
            unit: board.unit,
            program: board.points.program,
            watched: Some(Watched {
                points: board.points.clone(),
                every: board.every,
            }),
        })
}

/// Why a board is not behind a server, in words.
fn absent(server: &str, why: Absent) -> String {
    match why {
        Absent::Unreached(error) => messages::not_reached(server, messages::io(&error)),
        Absent::Silent(address) => messages::silent_behind(server, address),
        Absent::Foreign(foreign) => {
            messages::no_unoclp(server, messages::foreign(foreign.as_ref()))
        }
    }
}

/// How long an answer is waited for that a visitor has asked for. A visitor asks again, so it is sent once.
const PATIENCE: Patience = Patience {
    answer: Duration::from_secs(1),
    attempts: 1,
    start: Duration::from_secs(8),
    store: Duration::from_secs(8),
};

/// The boards at a serial port.
struct AtPort {
    place: Place,
    port: Option<Port>,
    /// What a site file says that the boards at these addresses are.
    kinds: Vec<(u8, Kind)>,
}

impl AtPort {
    fn new(place: Place, kinds: Vec<(u8, Kind)>) -> AtPort {
        AtPort {
            place,
            port: None,
            kinds,
        }
    }

    /// Whether the board at this address has the points that a site file expects of it.
    fn has_points(&self, address: u8, identity: &Identity) -> Result<(), String> {
        let expected = self.kinds.iter().find(|(of, _)| *of == address);
        let (Some((_, expected)), Some(found)) = (expected, identity.board()) else {
            return Ok(());
        };
        match found.inputs < expected.inputs || found.outputs < expected.outputs {
            true => Err(messages::board_is_less(identity, expected.name)),
            false => Ok(()),
        }
    }
}

impl Board for AtPort {
    fn find(&mut self, address: u8) -> Result<(), String> {
        self.place.line.address = address;
        let found = match &mut self.port {
            Some(port) => port.seek(&self.place, false),
            None => find(&self.place, PATIENCE).map(|Found { port, identity, .. }| {
                self.port = Some(port);
                identity
            }),
        };
        if let Err(NotFound::Failed {
            failure: Failure::Lost(_),
            ..
        }) = found
        {
            self.port = None;
        }
        self.has_points(address, &found.map_err(|why| why.to_string())?)
    }

    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
        let Some(port) = &mut self.port else {
            return Err(NoAnswer::Silent);
        };
        let answered = port.talk(async |client| {
            // Storing a program takes longer than any answer to a question.
            match request.only_reads() {
                true => client.forward(request).await,
                false => client.forward_within(PATIENCE.store, request).await,
            }
        });
        answered.map_err(|failure| match failure {
            Failure::Lost(_) => {
                self.port = None;
                NoAnswer::Gone(messages::failure(&failure))
            }
            _ => NoAnswer::Silent,
        })
    }
}
