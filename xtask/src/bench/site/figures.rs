//! What is measured of a site.

use serde::Deserialize;

/// What `tools/cli/examples/scale` says of programs that read boards.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Scale {
    pub boards: u32,
    pub up: u32,
    pub gateways: u32,
    /// Points read a second, and for each second of a processor.
    pub readings: f64,
    pub per_processor_second: f64,
    /// Processors in use, and memory.
    pub core: f64,
    pub megabytes: f64,
}

/// What it says of a line.
#[derive(Deserialize)]
pub struct Line {
    pub boards: u32,
    pub up: u32,
    pub rate: u32,
    /// Boards read a second.
    pub readings: f64,
    /// As parts of the time: bytes on the wires; these, and the silences that Modbus wants between frames.
    pub bytes: f64,
    pub used: f64,
}

/// What `tools/history/examples/trend.rs` says.
#[derive(Deserialize)]
pub struct Trend {
    pub samples: u64,
    /// To write them, and what they take.
    pub seconds: f64,
    pub bytes: u64,
    pub rows: u32,
    /// Trends, ms.
    pub median: f64,
    pub longest: f64,
}

/// All that was measured.
pub struct Measured {
    pub scale: Scale,
    pub few: Scale,
    pub node_red: Scale,
    pub lines: Vec<Line>,
    pub trend: Trend,
    /// Programs that waited for a processor on average, at the beginning and at the end; and how many processors there are.
    pub load: [f64; 2],
    pub processors: usize,
}
