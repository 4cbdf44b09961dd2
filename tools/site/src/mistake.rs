//! What can be wrong with a site file, as values and in words.

use crate::words;
use unoclp_keyed::{Amiss, Reason};
use unoclp_lang::Diagnostic;
use unoclp_program::Lang;

/// A mistake in a site file, and where it stands.
pub type Mistake = unoclp_keyed::Mistake<Wrong>;

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// What is wrong with any file.
    Keys(Amiss),
    /// A number is out of its range.
    Range {
        /// The key.
        key: &'static str,
        /// The least.
        from: i64,
        /// The most.
        to: i64,
    },
    /// No address and port.
    NoAddress {
        /// What was given.
        given: String,
    },
    /// No host and port.
    NoHost {
        /// What was given.
        given: String,
    },
    /// No time.
    NoTime {
        /// What was given.
        given: String,
        /// The least.
        from: &'static str,
        /// The most.
        to: &'static str,
    },
    /// The page is served beyond this PC, and the file does not say that nothing is encrypted.
    Open {
        /// Where.
        listen: String,
    },
    /// There is no line.
    NoLine,
    /// A line names both a port and a server, or neither.
    WayOfLine,
    /// A line over TCP has a rate or a parity.
    FormatOfTcp {
        /// Which.
        key: &'static str,
    },
    /// A line has no board.
    NoBoard,
    /// Two lines are reached by the same way.
    TwoLines {
        /// The way.
        way: String,
    },
    /// A name that cannot be one.
    Name {
        /// What was given.
        given: String,
    },
    /// Two boards are called the same.
    TwoNames {
        /// The name.
        name: String,
    },
    /// Two boards of a line have the same address.
    TwoAddresses {
        /// The address.
        address: u8,
        /// The other board.
        other: String,
    },
    /// Two boards of the site have the same unit.
    TwoUnits {
        /// The unit.
        unit: u8,
        /// The other board.
        other: String,
    },
    /// Two servers have the same address.
    TwoServers {
        /// The address.
        address: String,
    },
    /// No broker.
    NoBroker {
        /// What was given.
        given: String,
    },
    /// A broker's address has a password in it.
    BrokerSecret,
    /// A broker over a connection without encryption has a certificate.
    CaWithoutTls,
    /// A password without a user.
    NoUser,
    /// No database.
    NoDatabase {
        /// What was given.
        given: String,
    },
    /// A database's address has more in it than user, host, port and name.
    DatabaseSecret,
    /// A history in a file has a key of one in a database.
    OfServer {
        /// The key.
        key: &'static str,
    },
    /// History and journal are in one file.
    OneFile {
        /// The file.
        file: String,
    },
    /// No size.
    NoSize {
        /// What was given.
        given: String,
    },
    /// No name of a topic.
    NoTopic {
        /// The key.
        key: &'static str,
        /// What was given.
        given: String,
    },
    /// A program cannot be read.
    Unreadable {
        /// Its file.
        file: String,
        /// Why.
        why: String,
    },
    /// A program has errors.
    Faulty {
        /// Its file.
        file: String,
    },
    /// No board and point.
    NoPath {
        /// What was given.
        given: String,
    },
    /// There is no board of this name.
    NoSuchBoard {
        /// The name.
        name: String,
        /// Those that there are.
        known: String,
    },
    /// A board has no point of this name.
    NoSuchPoint {
        /// The board.
        board: String,
        /// The point.
        point: String,
        /// Those that can be written.
        known: String,
    },
    /// What no alarm and no user can be called.
    NoName {
        /// What was given.
        given: String,
    },
    /// Two alarms are called the same.
    TwoAlarms {
        /// The name.
        name: String,
    },
    /// An alarm's condition is none.
    NoCondition {
        /// What the language says of it.
        told: Option<Box<Diagnostic>>,
    },
    /// An alarm's condition reads no point.
    ReadsNothing,
    /// An alarm's condition is too long.
    LongCondition {
        /// The most, characters.
        most: usize,
    },
    /// An alarm says nothing.
    NoText,
    /// A file of a panel, or its drawing, cannot be read.
    NoPanel {
        /// The file.
        file: String,
        /// Why.
        why: String,
    },
    /// It is no text, or too long.
    NoTextFile {
        /// The file.
        file: String,
    },
    /// Something is wrong in the file of a panel.
    InPanel {
        /// The file.
        file: String,
        /// The line.
        line: usize,
        /// What.
        wrong: Box<Wrong>,
    },
    /// Two panels are called the same.
    TwoPanels {
        /// The name.
        name: String,
    },
    /// A board records no point of this name.
    NotRecorded {
        /// The board.
        board: String,
        /// The point.
        point: String,
        /// Those that it does.
        known: String,
    },
    /// The least value is not below the most.
    NoRange,
    /// A label is too long.
    LongLabel {
        /// The most, characters.
        most: usize,
    },
    /// Two users are called the same.
    TwoUsers {
        /// The name.
        name: String,
    },
    /// No key of a user.
    NoKeyOfUser,
    /// A point cannot be written.
    ReadOnly {
        /// The point.
        point: String,
        /// Those that can be written.
        known: String,
    },
}

impl From<Amiss> for Wrong {
    fn from(amiss: Amiss) -> Wrong {
        Wrong::Keys(amiss)
    }
}

impl Reason for Wrong {
    fn text(&self, lang: Lang) -> String {
        match self {
            Wrong::Keys(amiss) => amiss.text(lang),
            Wrong::Range { key, from, to } => words::range(lang, key, from, to),
            Wrong::NoAddress { given } => words::no_address(lang, given),
            Wrong::NoHost { given } => words::no_host(lang, given),
            Wrong::NoTime { given, from, to } => words::no_time(lang, given, from, to),
            Wrong::Open { listen } => words::open(lang, listen),
            Wrong::NoLine => words::no_line(lang),
            Wrong::WayOfLine => words::way_of_line(lang),
            Wrong::FormatOfTcp { key } => words::format_of_tcp(lang, key),
            Wrong::NoBoard => words::no_board(lang),
            Wrong::TwoLines { way } => words::two_lines(lang, way),
            Wrong::Name { given } => words::name(lang, given),
            Wrong::TwoNames { name } => words::two_names(lang, name),
            Wrong::TwoAddresses { address, other } => words::two_addresses(lang, address, other),
            Wrong::TwoUnits { unit, other } => words::two_units(lang, unit, other),
            Wrong::TwoServers { address } => words::two_servers(lang, address),
            Wrong::NoBroker { given } => words::no_broker(lang, given),
            Wrong::BrokerSecret => words::broker_secret(lang),
            Wrong::CaWithoutTls => words::ca_without_tls(lang),
            Wrong::NoDatabase { given } => words::no_database(lang, given),
            Wrong::DatabaseSecret => words::database_secret(lang),
            Wrong::OfServer { key } => words::of_server(lang, key),
            Wrong::OneFile { file } => words::one_file(lang, file),
            Wrong::NoSize { given } => words::no_size(lang, given),
            Wrong::NoUser => words::no_user(lang),
            Wrong::NoTopic { key, given } => words::no_topic(lang, key, given),
            Wrong::Unreadable { file, why } => words::unreadable(lang, file, why),
            Wrong::Faulty { file } => words::faulty(lang, file),
            Wrong::NoPath { given } => words::no_path(lang, given),
            Wrong::NoSuchBoard { name, known } => words::no_such_board(lang, name, known),
            Wrong::NoSuchPoint {
                board,
                point,
                known,
            } => words::no_such_point(lang, board, point, known),
            Wrong::NoName { given } => words::no_name(lang, given),
            Wrong::TwoAlarms { name } => words::two_alarms(lang, name),
            Wrong::NoCondition { told } => {
                let message = told.as_ref().map(|told| told.message(lang));
                let help = told.as_ref().map(|told| told.help(lang));
                let help = help.filter(|help| !help.is_empty());
                let help = help.map(|help| format!("; {help}")).unwrap_or_default();
                words::no_condition(lang, message.unwrap_or_default(), help)
            }
            Wrong::ReadsNothing => words::reads_nothing(lang),
            Wrong::LongCondition { most } => words::long_condition(lang, most),
            Wrong::NoText => words::no_text(lang),
            Wrong::NoPanel { file, why } => words::no_panel(lang, file, why),
            Wrong::NoTextFile { file } => words::no_text_file(lang, file),
            Wrong::InPanel { file, line, wrong } => {
                format!("{file}:{line}: {}", wrong.text(lang))
            }
            Wrong::TwoPanels { name } => words::two_panels(lang, name),
            Wrong::NotRecorded {
                board,
                point,
                known,
            } => words::not_recorded(lang, board, point, known),
            Wrong::NoRange => words::no_range(lang),
            Wrong::LongLabel { most } => words::long_label(lang, most),
            Wrong::TwoUsers { name } => words::two_users(lang, name),
            Wrong::NoKeyOfUser => words::no_key_of_user(lang),
            Wrong::ReadOnly { point, known } => words::read_only(lang, point, known),
        }
    }
}
