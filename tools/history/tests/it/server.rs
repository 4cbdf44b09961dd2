//! A PostgreSQL on a free port, which can be killed and begun again.

use std::net::{TcpListener, TcpStream};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};
use unoclp_history::{Address, Trust};

/// No test waits for longer: what is not there by then does not come.
const PATIENCE: Duration = Duration::from_secs(30);

/// A server whose user `unoclp` needs no password.
pub struct Server {
    folder: tempfile::TempDir,
    child: Option<Child>,
    pub port: u16,
    /// The certificate of one that takes encrypted connections alone.
    certificate: Option<String>,
    /// Where it has a disk of its own, of so many MB.
    tight: Option<(PathBuf, u32)>,
}

/// Where Debian keeps the programs of the server: no path leads there.
fn program(name: &str) -> PathBuf {
    let versions = std::fs::read_dir("/usr/lib/postgresql").into_iter();
    let versions = versions.flatten().flatten();
    let found = versions.map(|version| version.path().join("bin").join(name));
    found.max().expect("`cargo xtask setup` brings postgresql")
}

/// The server lets no root begin it.
fn command(name: &str) -> Command {
    let program = program(name);
    if !is_root() {
        return Command::new(program);
    }
    let mut command = Command::new("setpriv");
    command
        .args([
            "--reuid",
            "postgres",
            "--regid",
            "postgres",
            "--clear-groups",
        ])
        .arg(program);
    command
}

fn is_root() -> bool {
    std::fs::metadata("/proc/self").is_ok_and(|of| {
        use std::os::unix::fs::MetadataExt;
        of.uid() == 0
    })
}

/// The same command with a file system in memory at this folder, of so many MB: it alone sees it.
fn on_disk(command: &Command, folder: &Path, megabytes: u32) -> Command {
    let owner = if is_root() { "postgres" } else { "" };
    let mount = format!(
        "mount -t tmpfs -o size={megabytes}m,mode=700,uid=$(id -u {owner}),gid=$(id -g {owner}) tight \"$0\" && exec \"$@\""
    );
    let mut own = Command::new("unshare");
    if !is_root() {
        own.args(["--user", "--map-current-user", "--keep-caps"]);
    }
    own.args(["--mount", "sh", "-c", &mount]).arg(folder);
    own.arg(command.get_program()).args(command.get_args());
    own
}

fn give_away(folder: &Path) {
    // Where there is no such user, the folder is ours, and so is the server.
    let _ = Command::new("chown")
        .arg("postgres:postgres")
        .arg(folder)
        .stderr(Stdio::null())
        .status();
}

/// The files of a new server. To make them takes seconds, so it is done once, and they are copied.
fn files() -> PathBuf {
    let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join("postgres");
    if made.is_dir() {
        return made;
    }
    let folder = tempfile::tempdir().unwrap();
    give_away(folder.path());
    let data = folder.path().join("data");
    let initialised = command("initdb")
        .args([
            "--no-sync",
            "--auth=trust",
            "--username=unoclp",
            "--no-locale",
        ])
        .args(["--encoding=UTF8", "-D"])
        .arg(&data)
        .stdout(Stdio::null())
        .current_dir("/")
        .status()
        .unwrap();
    assert!(initialised.success());
    let own = made.with_extension(format!(
        "{}.{:?}",
        std::process::id(),
        thread::current().id()
    ));
    copy(&data, &own);
    // Where another test has made them meanwhile, its files are as good.
    if std::fs::rename(&own, &made).is_err() {
        std::fs::remove_dir_all(&own).unwrap();
    }
    made
}

/// Copies a folder with all that its files are.
fn copy(from: &Path, to: &Path) {
    let copied = Command::new("cp").arg("-a").arg(from).arg(to).status();
    assert!(copied.unwrap().success());
}

impl Server {
    pub fn new() -> Server {
        Server::of(None, None)
    }

    /// One with a tablespace `tight` on a disk of so many MB, which is gone when it ends.
    pub fn tight(megabytes: u32) -> Server {
        let server = Server::of(None, Some(megabytes));
        let (disk, _) = server.tight.as_ref().unwrap();
        let sql = format!("CREATE TABLESPACE tight LOCATION '{}'", disk.display());
        server.psql("postgres", &sql);
        server
    }

    /// One that takes encrypted connections alone, with this certificate and its key. Its user `gateway` needs a password.
    pub fn encrypted(certificate: &str, key: &str) -> Server {
        Server::of(Some((certificate, key)), None)
    }

    fn of(tls: Option<(&str, &str)>, tight: Option<u32>) -> Server {
        let folder = tempfile::tempdir().unwrap();
        give_away(folder.path());
        let data = folder.path().join("data");
        copy(&files(), &data);
        if let Some((certificate, key)) = tls {
            let who = "hostssl all gateway all scram-sha-256\nhostssl all unoclp all trust\n";
            for (name, text) in [
                ("server.crt", certificate),
                ("server.key", key),
                ("pg_hba.conf", who),
            ] {
                let path = data.join(name);
                std::fs::write(&path, text).unwrap();
                // It takes no key that others may read.
                std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o600)).unwrap();
                give_away(&path);
            }
        }
        let tight = tight.map(|megabytes| {
            let disk = folder.path().join("tight");
            std::fs::create_dir(&disk).unwrap();
            (disk, megabytes)
        });
        let free = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = free.local_addr().unwrap().port();
        drop(free);
        let mut server = Server {
            folder,
            child: None,
            port,
            certificate: tls.map(|(certificate, _)| certificate.to_owned()),
            tight,
        };
        server.begin();
        server
    }

    /// Begins it, at the same port each time. What one that was killed has left behind may hold its memory for a moment more:
    /// then it ends at once, and is begun again.
    pub fn begin(&mut self) {
        let begun = Instant::now();
        self.child = Some(self.spawn());
        while !self.is_ready() {
            let child = self.child.as_mut().unwrap();
            if child.try_wait().unwrap().is_some() {
                self.child = Some(self.spawn());
            }
            assert!(begun.elapsed() < PATIENCE, "postgres takes no connection");
            thread::yield_now();
        }
    }

    fn spawn(&self) -> Child {
        let mut program = match &self.tight {
            None => command("postgres"),
            Some((disk, megabytes)) => on_disk(&command("postgres"), disk, *megabytes),
        };
        program
            .arg("-D")
            .arg(self.folder.path().join("data"))
            .args(["-p", &self.port.to_string(), "-k", ""])
            .args(["-c", "listen_addresses=127.0.0.1", "-c", "fsync=off"])
            .args(["-c", "shared_buffers=16MB", "-c", "max_connections=20"])
            .args(self.certificate.iter().flat_map(|_| ["-c", "ssl=on"]))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .current_dir("/")
            .spawn()
            .unwrap()
    }

    fn is_ready(&self) -> bool {
        TcpStream::connect(("127.0.0.1", self.port)).is_ok()
            && unoclp_history::Database::Server(self.address("postgres"))
                .read()
                .is_err_and(|why| why == unoclp_history::Failure::Foreign)
    }

    /// Kills it: nothing is written any more.
    pub fn kill(&mut self) {
        if let Some(mut child) = self.child.take() {
            child.kill().unwrap();
            child.wait().unwrap();
        }
    }

    /// Makes a database, on the disk of its own if it has one.
    pub fn database(&self, name: &str) -> Address {
        let at = if self.tight.is_some() {
            " TABLESPACE tight"
        } else {
            ""
        };
        self.psql("postgres", &format!("CREATE DATABASE {name}{at}"));
        self.address(name)
    }

    pub fn address(&self, database: &str) -> Address {
        let encrypted = |certificate: &String| Trust {
            ca: Some(certificate.clone().into()),
        };
        Address {
            // As its certificate calls it.
            host: "localhost".into(),
            port: self.port,
            user: "unoclp".into(),
            database: database.into(),
            password: None,
            tls: self.certificate.as_ref().map(encrypted),
        }
    }

    /// What its own client prints of a statement.
    pub fn psql(&self, database: &str, sql: &str) -> String {
        let output = Command::new("psql")
            .args([
                "-h",
                "127.0.0.1",
                "-p",
                &self.port.to_string(),
                "-U",
                "unoclp",
            ])
            .args([
                "-d",
                database,
                "-X",
                "-q",
                "-t",
                "-A",
                "-v",
                "ON_ERROR_STOP=1",
            ])
            .args(["-c", sql])
            .output()
            .expect("`cargo xtask setup` brings psql");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}");
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.kill();
    }
}
