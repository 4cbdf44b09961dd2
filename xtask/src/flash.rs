//! `cargo xtask flash`: writes the firmware to a board, through avrdude and the UNO's boot loader.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, ensure};
use unoclp_boot::Model;

use crate::shell::{self, say};
use crate::{firmware, setup};

/// `cargo xtask flash`
#[derive(clap::Args)]
pub struct Args {
    /// The serial port of the board: /dev/ttyACM0 or /dev/ttyUSB0 on Linux, /dev/cu.usbmodem… on
    /// macOS, COM3 or the like on Windows
    #[arg(long)]
    port: PathBuf,
    /// Write this file rather than a new build
    #[arg(long, value_name = "FILE")]
    hex: Option<PathBuf>,
}

/// Builds the firmware where no file is named, and writes it.
///
/// # Errors
/// If the board or avrdude is not there, the build fails, or avrdude does.
pub fn run(args: &Args) -> Result<()> {
    ensure!(
        shell::output(Command::new("avrdude").arg("-?")).is_some(),
        "avrdude is not installed, or not in PATH: on Debian and Ubuntu, `sudo apt-get install avrdude`"
    );
    // A port of Windows is no file.
    ensure!(
        cfg!(windows) || args.port.exists(),
        "there is no port {}: is the board connected? Unplug it and see which port goes away",
        args.port.display()
    );
    let hex = match &args.hex {
        Some(hex) => hex.clone(),
        None => firmware::build(&setup::for_firmware()?, Model::Uno)?.hex,
    };
    ensure!(hex.is_file(), "there is no file {}", hex.display());

    say(&format!("flash: writing {}", hex.display()));
    shell::run(Command::new("avrdude").args(avrdude(&args.port, &hex)))
}

/// The boot loader speaks the protocol `arduino` at 115,200 baud, and erases as it writes (-D).
fn avrdude(port: &Path, hex: &Path) -> Vec<OsString> {
    let mut flash = OsString::from("flash:w:");
    flash.push(hex);
    flash.push(":i");
    let mut arguments: Vec<OsString> = ["-c", "arduino", "-p", "m328p", "-b", "115200", "-P"]
        .map(OsString::from)
        .into();
    arguments.extend([port.into(), "-D".into(), "-U".into(), flash]);
    arguments
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::avrdude;

    #[test]
    fn avrdude_is_told_board_port_and_file() {
        let arguments = avrdude(Path::new("/dev/ttyACM0"), Path::new("a b/unoclp.hex"));
        let expected = [
            "-c",
            "arduino",
            "-p",
            "m328p",
            "-b",
            "115200",
            "-P",
            "/dev/ttyACM0",
            "-D",
            "-U",
            "flash:w:a b/unoclp.hex:i",
        ];
        assert_eq!(arguments, expected);
    }
}
