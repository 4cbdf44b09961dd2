//! Node-RED, which reads the same points by the nodes of node-red-contrib-modbus.
//!
//! It reads outputs and values of each board as a gateway does, and a function makes numbers of the registers. Nothing is kept.

use crate::boards::{FIRST, Lines, OUTPUTS, VALUES};
use crate::process::Process;
use serde_json::{Value, json};
use std::fs;
use std::io;
use std::net::TcpListener;
use std::path::Path;
use std::process::{Command, Stdio};

/// Makes numbers of 32 bits of registers, the more significant first, and notes them.
const NUMBERS: &str = "const words = msg.payload; const values = new Array(words.length / 2);
for (let at = 0; at < values.length; at++) values[at] = (words[2 * at] << 16) | words[2 * at + 1];
flow.set(msg.topic, values); return null;";
/// Notes bits.
const BITS: &str = "flow.set(msg.topic, msg.payload); return null;";

/// Begins it, as it is installed in this folder.
pub fn begin(installed: &Path, folder: &Path, lines: &Lines) -> io::Result<Process> {
    let flows = serde_json::to_string(&flow(lines))?;
    fs::write(folder.join("flows.json"), flows)?;
    // A port that is free, until Node-RED takes it.
    let port = TcpListener::bind("127.0.0.1:0")?.local_addr()?.port();
    let nodes = fs::canonicalize(installed.join("node_modules"))?;
    // It looks for further nodes beside its files.
    std::os::unix::fs::symlink(&nodes, folder.join("node_modules"))?;
    let settings = format!(
        "module.exports = {{ uiPort: {port}, uiHost: '127.0.0.1', flowFile: 'flows.json', disableEditor: true, telemetry: {{ enabled: false }}, logging: {{ console: {{ level: 'warn' }} }} }};\n"
    );
    fs::write(folder.join("settings.js"), settings)?;
    let mut command = Command::new("node");
    command.arg(nodes.join("node-red/red.js"));
    command.arg("--settings").arg(folder.join("settings.js"));
    command.arg("--userDir").arg(folder);
    command.stdout(Stdio::null()).spawn().map(Process)
}

/// A client for each line, two readings for each board, and two functions.
fn flow(lines: &Lines) -> Value {
    let function = |id: &str, body: &str| json!({ "id": id, "type": "function", "z": "tab", "name": "", "func": body, "outputs": 1, "wires": [[]] });
    let mut nodes = vec![
        json!({ "id": "tab", "type": "tab", "label": "scale" }),
        function("numbers", NUMBERS),
        function("bits", BITS),
    ];
    for (line, server) in lines.servers.iter().enumerate() {
        let client = format!("client{line}");
        nodes.push(json!({
            "id": client, "type": "modbus-client", "name": "", "clienttype": "tcp", "bufferCommands": true,
            "stateLogEnabled": false, "queueLogEnabled": false, "failureLogEnabled": true,
            "tcpHost": server.ip().to_string(), "tcpPort": server.port().to_string(), "tcpType": "DEFAULT",
            "unit_id": "1", "commandDelay": "1", "clientTimeout": "2000", "reconnectOnTimeout": true,
            "reconnectTimeout": "2000", "parallelUnitIdsAllowed": true,
        }));
        for board in 1..=lines.count(line) {
            let mut reading = |kind: &str, data: &str, first: u16, quantity: u16, to: &str| {
                let id = format!("{kind}{line}x{board}");
                nodes.push(json!({
                    "id": id, "type": "modbus-read", "z": "tab", "name": "", "topic": format!("of {id}"), "showStatusActivities": false,
                    "logIOActivities": false, "showErrors": true, "showWarnings": false, "unitid": board.to_string(),
                    "dataType": data, "adr": first.to_string(), "quantity": quantity.to_string(), "rate": "500",
                    "rateUnit": "ms", "delayOnStart": false, "startDelayTime": "", "server": client, "useIOFile": false,
                    "ioFile": "", "useIOForPayload": false, "emptyMsgOnFail": false, "wires": [[to], []],
                }));
            };
            reading("values", "HoldingRegister", FIRST, 2 * VALUES, "numbers");
            reading("outputs", "Coil", 0, OUTPUTS, "bits");
        }
    }
    nodes.into()
}
