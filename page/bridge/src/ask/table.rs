//! The asks.

#[cfg(feature = "full")]
use super::field::{Blocks, Log, Steps, Text, Trail};
use super::{Below, Columns, asks};
#[cfg(feature = "full")]
use crate::adapt::Adapted;
#[cfg(feature = "full")]
use crate::assist::{Change, Meant, Mended, Offers, UsedAt};
#[cfg(feature = "full")]
use crate::board::Live;
use crate::board::Step;
#[cfg(feature = "full")]
use crate::card::Card;
#[cfg(feature = "full")]
use crate::chart::Charted;
#[cfg(feature = "full")]
use crate::draw::As;
use crate::draw::{LadderDrawn, Speak};
#[cfg(feature = "full")]
use crate::edit::View;
#[cfg(feature = "full")]
use crate::exercise::{self, Fared, Outcome};
use crate::facts::Facts;
#[cfg(feature = "full")]
use crate::machine::{Known, Look, Searched};
use crate::program::Checked;
#[cfg(feature = "full")]
use crate::project::{Project, UnitShown};
#[cfg(feature = "full")]
use crate::replay::Replay;
#[cfg(feature = "full")]
use crate::slow::Stood;
use unoclp_core::Board;
#[cfg(feature = "full")]
use unoclp_edit::Shelf;
#[cfg(feature = "full")]
use unoclp_program::drawn::WriteAs;
use unoclp_workspace::Version;

asks! {
    /// What both modules are asked.
    First -> Answer;
    /// What a board has: each limit of its points and its memory, so that a page needs to know none.
    Board "board" { board: Board } -> Facts;
    /// The version of a text: all else that is asked of it names that.
    Text "text" { name: String, text: String, board: Board } -> u32;
    /// What there is to say of a text: its problems, or its program.
    Check "check" { version: Version } -> Box<Checked>;
    /// Its ladder, for a page that shows it live, in so many columns where that is enough; or the same as a block diagram.
    Ladder "ladder" { version: Version, width: Columns, is_blocks as "isBlocks": Option<bool>, speak: Speak } -> LadderDrawn;
    /// A conversation with a board, which is said to run this text; `core`: this computer runs its programs, and there is no line.
    Open "open" {
        version: Option<Version>, reset: bool, core: Option<bool>, board: Board, address: Option<u8>, rate: Option<u32>,
        parity: Option<u16>
    } -> u32;
    /// A step of it: what has come since the last one, at this time in ms since any moment.
    Step "step" { board: u32, now: f64, came: Vec<u8> } -> Step;
    /// Something to be done by the board.
    Order "order" { board: u32, order: Below } -> u32;
    /// The line is gone, and why.
    Lose "lose" { board: u32, why: String } -> ();
    /// The end of a conversation.
    Close "close" { board: u32 } -> ();
}

/// What takes the module that has everything.
pub const MORE: [&str; 37] = [
    "list",
    "adapt",
    "pages",
    "sheet",
    "exercise",
    "trial",
    "trace",
    "replay",
    "picture",
    "card",
    "read",
    "free",
    "machine",
    "machineLook",
    "machineHand",
    "machineFault",
    "machineForced",
    "machineName",
    "machineReset",
    "machineClose",
    "palette",
    "draw",
    "edit",
    "drawn",
    "find",
    "complete",
    "meant",
    "uses",
    "rename",
    "form",
    "remedies",
    "chart",
    "slow",
    "slowly",
    "project",
    "unit",
    "alter",
];

#[cfg(feature = "full")]
asks! {
    /// What takes the module that has everything.
    More -> MoreAnswer;
    /// Its program in another form. Instruction List that is made is compiled again, by all that there is.
    List "list" { version: Version, form as "as": As, width: Columns, speak: Speak } -> String;
    /// A text of another PLC with free points in the place of those that its board lacks, and those that found none; null in
    /// a language whose points are names of its own.
    Adapt "adapt" { version: Version } -> Option<Adapted>;
    /// The ladder on pages of paper.
    Pages "pages" { version: Version, letter: bool, width: Columns, speak: Speak } -> Vec<String>;
    /// What an exercise asks.
    Sheet "sheet" { title: String, scenario: String, board: Board } -> exercise::Sheet;
    /// Whether its program does what the cases of a scenario file expect, and its machine too.
    Exercise "exercise" {
        version: Version, title: String, scenario: String, plant: Option<String>, plant_text as "plantText": Option<String>
    } -> Outcome;
    /// Whether its program does what a machine asks, through the script of that.
    Trial "trial" { version: Version, plant: String, plant_text as "plantText": String } -> Fared;
    /// A number for all that a machine is with it in each of so many ms.
    Trace "trace" { version: Version, plant: String, plant_text as "plantText": String, ms: u32 } -> String;
    /// What a machine did with it about a time at which something went wrong.
    Replay "replay" {
        version: Version, plant: String, plant_text as "plantText": String, scenario: Option<String>, at: u32, why: String,
        speak: Speak
    } -> Replay;
    /// The picture of a machine that stands.
    Picture "picture" { name: String, text: String, board: Board, speak: Speak } -> String;
    /// The image of a card with this PROGRAM.TXT.
    Card "card" { program: String, state: bool, board: Board } -> Card;
    /// A file of a card, by its name, from the blocks that are not empty; null where there is none.
    Read "read" { blocks: Blocks, name: String } -> Option<String>;
    /// Bytes that are free on a card; null where it has no FAT16 or FAT32.
    Free "free" { blocks: Blocks } -> Option<u64>;
    /// A machine to control, from its file; it stands until it is stepped. `keep`: the one that is open goes on, and is told
    /// in this language; `find`: a scenario that hides a fault in it.
    Machine "machine" {
        name: String, text: String, speak: Speak, keep: Option<bool>, find: Option<String>, board: Board
    } -> Known;
    /// What has changed of its picture.
    MachineLook "machineLook" {} -> Look;
    /// A person there changes something.
    MachineHand "machineHand" { part: usize, value: usize, to: i32 } -> ();
    /// A part of it fails, or is mended.
    MachineFault "machineFault" { part: usize, fault: String, is: bool } -> ();
    /// A person forces a point of the board: a step of a search.
    MachineForced "machineForced" {} -> ();
    /// A person names the fault that is hidden in it; how far they are.
    MachineName "machineName" { part: usize, fault: String } -> Option<Searched>;
    /// As it was at first.
    MachineReset "machineReset" {} -> ();
    /// There is none any longer.
    MachineClose "machineClose" {} -> ();
    /// The elements that can be drawn.
    Palette "palette" {} -> Vec<Shelf>;
    /// A drawing, of a text and what was done to it; `name`: what its file is called now; `isBlocks`: as a block diagram.
    Draw "draw" {
        base: Text, log: Log, name: Option<String>, board: Board, width: Columns, is_blocks as "isBlocks": Option<bool>, speak: Speak
    } -> Box<View>;
    /// Something done to it; what a page shows of it then.
    Edit "edit" {
        act: Option<Below>, name: Option<String>, board: Board, width: Columns, is_blocks as "isBlocks": Option<bool>, speak: Speak
    } -> Box<View>;
    /// Its text in another form.
    Drawn "drawn" { form as "as": WriteAs } -> String;
    /// What of it has these words in it.
    Find "find" { words: String } -> Vec<u32>;
    /// What may stand at a place of a text, in units of UTF-16 from its beginning.
    Complete "complete" { version: Version, at: usize, speak: Speak } -> Offers;
    /// What stands there; null where nothing is known of it.
    Meant "meant" { version: Version, at: usize, speak: Speak } -> Option<Meant>;
    /// Where that is used, its declaration among them.
    Uses "uses" { version: Version, at: usize } -> Vec<UsedAt>;
    /// What gives the name there another.
    Rename "rename" { version: Version, at: usize, to: String } -> Vec<Change>;
    /// What places the words of a text well.
    Form "form" { version: Version } -> Vec<Change>;
    /// What can be done about the mistakes between two places.
    Remedies "remedies" { version: Version, from: usize, to: usize, speak: Speak } -> Vec<Mended>;
    /// Its charts, in the look of IEC 61131-3 or of GRAFCET; `what` is done `at` a part of one of them, and gives another text.
    Chart "chart" {
        version: Version, look: Option<String>, chart: u32, what: Option<String>, at: Option<String>, say: Option<String>,
        qualifier: Option<String>, time: Option<String>
    } -> Box<Charted>;
    /// What there is to show of it while a board stands in the middle of a scan, which has left this so far.
    Slow "slow" { version: Version, left: Trail } -> Live;
    /// The scan that this computer makes goes on, to where one of these instructions comes next, or any; `through` the ends of scans,
    /// or else to the end of this one. Null where it has not come there yet.
    Slowly "slowly" { board: u32, to: Steps, through: bool } -> Option<Stood>;
    /// The units of a project, and their variables.
    Project "project" { version: Version } -> Box<Project>;
    /// The body of a unit of a project; null where it has none.
    Unit "unit" { version: Version, unit: String } -> Option<UnitShown>;
    /// A project in which something is another: of a variable of a unit, or a global one, `name`, `kind`, `first`, `place`,
    /// `comment`, `retained`, or all of it by `add` and `remove`; of an element of a drawn body `written`, `negated`, `edge`,
    /// `storage`; the `body` of a unit in text.
    Alter "alter" { version: Version, unit: Option<String>, what: String, at: String, to: String } -> String;
}
