//! What a gateway would do by a site file, in words.

use crate::alarm::{Alarm, Severity};
use crate::broker::Sparkplug;
use crate::duration::written;
use crate::grant::Grant;
use crate::site::{Board, Encryption, Journal, Line, Modbus, Mqtt, Site, Store, Way};
use crate::size;
use crate::users::{Role, User};
use crate::words;
use unoclp_modbus::map::Parity;
use unoclp_program::Lang;

/// What a gateway would do, line by line, in this language.
pub fn plan(site: &Site, lang: Lang) -> String {
    let listen = site.http.listen;
    let mut lines = vec![match listen.ip().is_loopback() {
        true if site.http.tls == Encryption::None => words::page_here(lang, listen),
        true => words::page_here_tls(lang, listen),
        false if site.http.tls == Encryption::None => words::page_open(lang, listen),
        false => words::page_open_tls(lang, listen),
    }];
    for line in &site.lines {
        lines.push(way(line, lang));
        for of in &line.boards {
            lines.extend(board(of, lang));
        }
    }
    if let Some(of) = &site.history {
        lines.push(words::history(lang, &of.store, written(of.keep)));
        if let Store::Server {
            server, tls: false, ..
        } = &of.store
            && !server.is_here()
        {
            lines.push(words::history_open(lang));
        }
    }
    if site.has_journal() {
        let Journal { every, bound, .. } = &site.journal;
        lines.push(words::journal(lang, written(*every), size::written(*bound)));
    }
    if let Some(of) = &site.modbus {
        lines.push(modbus(of, lang));
    }
    if let Some(of) = &site.mqtt {
        lines.extend(mqtt(of, lang));
    }
    lines.extend(site.alarms.iter().map(|of| alarm(of, lang)));
    let of_files = site.panels.iter().filter(|panel| !panel.is_made);
    lines.extend(of_files.map(|of| words::panel(lang, &of.name, of.items.len() + of.binds.len())));
    lines.extend(site.users.iter().map(|of| user(of, lang)));
    if site.has_record() {
        lines.push(words::record(lang, size::written(site.record_bound)));
    }
    lines.iter().map(|line| format!("{line}\n")).collect()
}

fn way(line: &Line, lang: Lang) -> String {
    match &line.way {
        Way::Tcp { server } => words::tcp(lang, server),
        Way::Serial { port, rate, parity } => {
            let parity = match parity {
                Parity::None => words::parity_none(lang),
                Parity::Even => words::parity_even(lang),
                Parity::Odd => words::parity_odd(lang),
            };
            words::serial(lang, port, rate, parity)
        }
    }
}

fn board(of: &Board, lang: Lang) -> [String; 2] {
    let Board {
        name,
        address,
        unit,
        points,
        ..
    } = of;
    let program = match (&of.program, points.program) {
        (Some(program), Some(kept)) => {
            let sum = format!("{:04X}", kept.sum);
            words::board_program(lang, program, points.named.len(), sum)
        }
        _ => words::board_alone(lang),
    };
    let kind = points.board.name;
    let board = words::board(lang, name, kind, address, unit, written(of.every));
    [board, program]
}

fn modbus(of: &Modbus, lang: Lang) -> String {
    match of.write.is_empty() {
        true => words::modbus_reads(lang, of.listen),
        false => words::modbus_writes(lang, of.listen, names(&of.write)),
    }
}

fn names(grants: &[Grant]) -> String {
    let names: Vec<&str> = grants.iter().map(|grant| &*grant.name).collect();
    names.join(", ")
}

fn mqtt(of: &Mqtt, lang: Lang) -> Vec<String> {
    let mut lines = vec![words::mqtt(lang, &of.broker, &of.topic)];
    if !of.broker.tls && !of.broker.is_here() {
        lines.push(words::mqtt_open(lang));
    }
    lines.push(match of.write.is_empty() {
        true => words::mqtt_reads(lang),
        false => words::mqtt_writes(lang, names(&of.write)),
    });
    if of.acknowledge {
        lines.push(words::mqtt_acknowledges(lang));
    }
    if of.home_assistant {
        lines.push(words::home_assistant(lang));
    }
    if let Some(Sparkplug { group, node, host }) = &of.sparkplug {
        lines.push(match host {
            None => words::sparkplug(lang, group, node),
            Some(host) => words::sparkplug_host(lang, group, node, host),
        });
    }
    lines
}

fn alarm(of: &Alarm, lang: Lang) -> String {
    let severity = match of.severity {
        Severity::Low => words::severity_low(lang),
        Severity::Medium => words::severity_medium(lang),
        Severity::High => words::severity_high(lang),
    };
    match of.lasts.is_zero() {
        true => words::alarm(lang, &of.name, severity, &of.when.text),
        false => words::alarm_for(lang, &of.name, severity, &of.when.text, written(of.lasts)),
    }
}

fn user(of: &User, lang: Lang) -> String {
    match of.role {
        Role::Watch => words::user_watch(lang, &of.name),
        Role::Operate => words::user_operate(lang, &of.name),
        Role::Engineer => words::user_engineer(lang, &of.name),
    }
}
