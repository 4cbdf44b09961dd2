//! A pseudo-terminal: to its user a serial port.

use rustix::fs::{Mode, OFlags};
use rustix::io::{Errno, ioctl_fionbio, read, write};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{LocalModes, OptionalActions, OutputModes, tcgetattr, tcsetattr};
use std::ffi::OsString;
use std::io;
use std::os::fd::OwnedFd;
use std::os::unix::ffi::OsStringExt;
use std::path::{Path, PathBuf};

/// Bytes that wait for a user who does not read. What comes then is lost.
const WAITING: usize = 65_536;
/// Bytes that are read at once.
const CHUNK: usize = 4096;

/// Our end of it.
pub(super) struct Pty {
    end: OwnedFd,
    path: PathBuf,
    /// Somebody has it open.
    in_use: bool,
    waiting: Vec<u8>,
}

impl Pty {
    /// A new one, which nobody has open.
    pub fn new() -> io::Result<Pty> {
        let end = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC)?;
        grantpt(&end)?;
        unlockpt(&end)?;
        ioctl_fionbio(&end, true)?;
        let path = ptsname(&end, Vec::new())?.into_bytes();
        let path = PathBuf::from(OsString::from_vec(path));
        // Linux tells that nobody has it open only after somebody had.
        let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
        drop(rustix::fs::open(&path, flags, Mode::empty())?);
        Ok(Pty {
            end,
            path,
            in_use: false,
            waiting: Vec::new(),
        })
    }

    /// What the user opens.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Somebody has it open, as far as the last call of [`Pty::receive`] has seen.
    pub fn is_in_use(&self) -> bool {
        self.in_use
    }

    /// What the user has sent since the last call.
    pub fn receive(&mut self) -> io::Result<Vec<u8>> {
        let mut bytes = vec![0; CHUNK];
        let (in_use, count) = match read(&self.end, &mut bytes) {
            Ok(count) => (true, count),
            Err(Errno::AGAIN | Errno::INTR) => (true, 0),
            // Nobody has it open.
            Err(Errno::IO) => (false, 0),
            Err(other) => return Err(other.into()),
        };
        if in_use && !self.in_use {
            self.make_raw()?;
        }
        self.in_use = in_use;
        bytes.truncate(count);
        Ok(bytes)
    }

    /// Sends to the user. Without one it is lost, as from a port that nobody has open.
    pub fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        if !self.in_use {
            self.waiting.clear();
            return Ok(());
        }
        let room = WAITING.saturating_sub(self.waiting.len());
        self.waiting.extend(&bytes[..bytes.len().min(room)]);
        if self.waiting.is_empty() {
            return Ok(());
        }
        match write(&self.end, &self.waiting) {
            Ok(count) => drop(self.waiting.drain(..count)),
            Err(Errno::AGAIN | Errno::INTR | Errno::IO) => {}
            Err(other) => return Err(other.into()),
        }
        Ok(())
    }

    /// Takes echo, line editing and the second byte behind a line feed away, which it has again for each user, where the
    /// user has not done so already.
    fn make_raw(&self) -> io::Result<()> {
        let mut modes = tcgetattr(&self.end)?;
        let is_edited = modes
            .local_modes
            .intersects(LocalModes::ECHO | LocalModes::ICANON);
        if is_edited || modes.output_modes.contains(OutputModes::OPOST) {
            modes.make_raw();
            tcsetattr(&self.end, OptionalActions::Now, &modes)?;
        }
        Ok(())
    }
}
