//! `cargo xtask dist`: what is handed out, in `target/dist/`. `unoclp` for the machine that this runs on, with the page
//! and the tested firmware inside; it and the page as archives, with the licences of all that they contain; and the page
//! as a folder and as a single file, which a double click opens; the tested firmware as hex files; the extension of the
//! editor. On Debian it is a package too, with a service. A bill of materials and the sums of the files lie beside them.

use std::env::consts::{ARCH, EXE_SUFFIX, OS};
use std::fs::{self, File};
use std::io::{Seek, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use crate::notice::Parts;
use crate::shell::{self, cargo, root, say};
use crate::{deb, lab, node, sbom, vsix};

/// Where all of it lies.
const FOLDER: &str = "target/dist";
/// The page, as `cargo xtask lab` builds it.
const PAGE: &str = "target/lab/page";
/// The page as a single file, beside the others of the page.
const SINGLE: &str = "unoclp.html";
/// What it may weigh, bytes.
const MOST: usize = 6_000_000;
/// The page as an archive, for a server or a computer of a school.
const ARCHIVE: &str = "unoclp-page.zip";
/// Where it is unpacked to be proven.
const UNPACKED: &str = "target/lab/unpacked";
/// The firmware that was tested, for each board.
const FIRMWARE: &str = "firmware";
/// What goes with each copy.
const PAPERS: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "NOTICE"];

/// The words after `cargo xtask dist`.
#[derive(clap::Args)]
pub struct Args {
    /// Open the built page in Chromium, from the disk and without a network
    #[arg(long)]
    prove: bool,
}

/// A file of an archive.
#[derive(Clone)]
struct Entry {
    name: String,
    bytes: Vec<u8>,
    runs: bool,
}

/// Builds all of it again, and says how large it is.
///
/// # Errors
/// If a step fails.
pub fn run(args: &Args) -> Result<()> {
    lab::build()?;
    let page = page()?;
    say("unoclp with the page inside");
    let built = program()?;
    let folder = root().join(FOLDER);
    if folder.exists() {
        fs::remove_dir_all(&folder).with_context(|| format!("cannot empty {FOLDER}"))?;
    }
    fs::create_dir_all(&folder).with_context(|| format!("cannot create {FOLDER}"))?;
    let name = format!("unoclp{EXE_SUFFIX}");
    let program = folder.join(&name);
    fs::copy(&built, &program).with_context(|| format!("cannot write {}", program.display()))?;

    let parts = Parts::find()?;
    let papers = papers(&parts)?;
    let for_this_machine = folder.join(format!("unoclp-{OS}-{ARCH}.zip"));
    let for_debian = papers.clone();
    let mut entries = [papers.clone(), exercises()?].concat();
    entries.push(entry(name, &program, true)?);
    write(&for_this_machine, entries)?;
    let page = [papers, page].concat();
    lay_out(&folder.join("page"), &page)?;
    let for_a_server = folder.join(ARCHIVE);
    write(&for_a_server, page)?;
    let single = folder.join(SINGLE);
    let whole =
        fs::read_to_string(root().join(PAGE).join(SINGLE)).context("no page in a single file")?;
    let whole = with_licences(&whole, &parts.texts()?);
    ensure!(
        whole.len() <= MOST,
        "{SINGLE} is too large for an e-mail: {} bytes",
        whole.len()
    );
    fs::write(&single, whole).with_context(|| format!("cannot write {}", single.display()))?;
    let mut made = vec![program.clone(), for_this_machine, for_a_server, single];
    match deb::can_be_made() {
        true => {
            let papers: Vec<_> = for_debian
                .into_iter()
                .map(|of| (of.name, of.bytes))
                .collect();
            made.push(deb::make(&program, &papers, &folder)?);
        }
        false => say("no Debian package: dpkg-deb is not installed"),
    }
    let extension = folder.join("unoclp.vsix");
    fs::copy(vsix::make()?, &extension).context("cannot copy the extension")?;
    made.push(extension);
    for hex in node::files(&root().join(FIRMWARE), ".hex")? {
        let copy = folder.join(hex.file_name().unwrap_or_default());
        fs::copy(&hex, &copy).with_context(|| format!("cannot copy {}", hex.display()))?;
        made.push(copy);
    }
    let name = format!("unoclp-{OS}-{ARCH}");
    let about = sbom::write(&parts, &made, &name, &folder)?;
    made.extend(about);
    for file in made {
        let size = fs::metadata(&file).map_or(0, |file| file.len());
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        say(&format!("{FOLDER}/{name}: {} KB", size.div_ceil(1000)));
    }
    match args.prove {
        true => prove(&folder),
        false => Ok(()),
    }
}

/// Opens the unpacked archive and the single file in Chromium, as a student does who has no network.
fn prove(folder: &Path) -> Result<()> {
    say("the page from the disk, in Chromium");
    let unpacked = root().join(UNPACKED);
    if unpacked.exists() {
        fs::remove_dir_all(&unpacked).with_context(|| format!("cannot empty {UNPACKED}"))?;
    }
    let file = File::open(folder.join(ARCHIVE)).context("no archive of the page")?;
    ZipArchive::new(file)?.extract(&unpacked)?;
    let mut node = Command::new("node");
    node.args(["--test", "--test-force-exit", "test/page/disk.test.mjs"]);
    node.env("PAGE_FOLDER", unpacked);
    node.env("PAGE_FILE", folder.join(SINGLE));
    shell::run(node.current_dir(node::folder()))
}

/// The files of the page. What only helps to look for errors in it is taken away.
fn page() -> Result<Vec<Entry>> {
    let folder = root().join(PAGE);
    for map in node::files(&folder, ".map")? {
        fs::remove_file(&map).with_context(|| format!("cannot remove {}", map.display()))?;
    }
    let files = node::files(&folder, "")?;
    let named = |file: PathBuf| {
        let name = file.strip_prefix(&folder).unwrap_or(&file);
        let name = name.to_string_lossy().replace('\\', "/");
        entry(name, &file, false)
    };
    files.into_iter().map(named).collect()
}

/// The exercises of the page and their machines, which a teacher grades a class by.
fn exercises() -> Result<Vec<Entry>> {
    let mut entries = Vec::new();
    for folder in ["programs/exercises", "programs/plants"] {
        for file in node::files(&root().join(folder), "")? {
            let name = file.strip_prefix(root()).unwrap_or(&file);
            let name = name.to_string_lossy().replace('\\', "/");
            // Wrong programs, for our own tests.
            if !name.contains("/wrong/") {
                entries.push(entry(name, &file, false)?);
            }
        }
    }
    Ok(entries)
}

/// Builds `unoclp`, and says where cargo has put it.
fn program() -> Result<PathBuf> {
    let mut build = cargo();
    build.args(["build", "--release", "--locked", "--package", "unoclp-cli"]);
    build.args([
        "--features",
        "page",
        "--message-format=json-render-diagnostics",
    ]);
    build.env("CARGO_PROFILE_RELEASE_STRIP", "symbols");
    let output = build
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| shell::not_started(&build, error))?;
    ensure!(output.status.success(), "unoclp does not compile");
    let text = String::from_utf8_lossy(&output.stdout);
    for line in text.lines().rev() {
        let message: Value = serde_json::from_str(line).unwrap_or_default();
        if let Some(path) = message["executable"].as_str() {
            return Ok(path.into());
        }
    }
    bail!("cargo names no program")
}

fn papers(parts: &Parts) -> Result<Vec<Entry>> {
    let mut papers = vec![Entry {
        name: "LICENCES-OF-OTHERS.txt".into(),
        bytes: parts.texts()?.into_bytes(),
        runs: false,
    }];
    for name in PAPERS {
        papers.push(entry(name.into(), &root().join(name), false)?);
    }
    Ok(papers)
}

/// The single page with the licences in it, where no reader of the page meets them: no paper goes with it.
fn with_licences(page: &str, licences: &str) -> String {
    let licences = licences.replace('<', "&lt;");
    format!("{page}<template id=\"licences\">\n{licences}\n</template>\n")
}

fn entry(name: String, file: &Path, runs: bool) -> Result<Entry> {
    let bytes = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    Ok(Entry { name, bytes, runs })
}

/// The entries as files, for who publishes them as they are.
fn lay_out(folder: &Path, entries: &[Entry]) -> Result<()> {
    for Entry { name, bytes, .. } in entries {
        let file = folder.join(name);
        shell::make_folder_of(&file)?;
        fs::write(&file, bytes).with_context(|| format!("cannot write {}", file.display()))?;
    }
    Ok(())
}

fn write(file: &Path, entries: Vec<Entry>) -> Result<()> {
    let cannot = || format!("cannot write {}", file.display());
    archive(entries, File::create(file).with_context(cannot)?).with_context(cannot)
}

/// The same entries make the same bytes: they are sorted, and none has a time.
fn archive(mut entries: Vec<Entry>, to: impl Write + Seek) -> Result<()> {
    entries.sort_by(|one, other| one.name.cmp(&other.name));
    let mut zip = ZipWriter::new(to);
    for Entry { name, bytes, runs } in entries {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(DateTime::default())
            .unix_permissions(if runs { 0o755 } else { 0o644 });
        zip.start_file(name, options)?;
        zip.write_all(&bytes)?;
    }
    zip.finish()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Cursor, Read};

    fn made(names: &[&str]) -> Vec<u8> {
        let entry = |name: &&str| Entry {
            name: (*name).into(),
            bytes: name.repeat(100).into_bytes(),
            runs: *name == "unoclp",
        };
        let mut to = Cursor::new(Vec::new());
        archive(names.iter().map(entry).collect(), &mut to).unwrap();
        to.into_inner()
    }

    #[test]
    fn a_teacher_has_the_exercises_with_their_machines() {
        let names: Vec<String> = exercises().unwrap().into_iter().map(|it| it.name).collect();
        for name in [
            "programs/exercises/05-motor.toml",
            "programs/exercises/find/01-motor.toml",
            "programs/exercises/machines/05-motor.toml",
            "programs/plants/elevator.toml",
        ] {
            assert!(names.iter().any(|it| it == name), "{name}");
        }
        assert!(!names.iter().any(|it| it.contains("wrong")), "{names:?}");
    }

    #[test]
    fn a_single_page_keeps_licences_from_being_markup() {
        let page = with_licences("<html></html>\n", "<b>MIT</template>");
        let (_, paper) = page.split_once("<template id=\"licences\">").unwrap();
        assert_eq!(paper, "\n&lt;b>MIT&lt;/template>\n</template>\n");
    }

    #[test]
    fn an_archive_has_its_files_in_order_and_no_times() {
        let bytes = made(&["unoclp", "NOTICE"]);
        assert_eq!(bytes, made(&["NOTICE", "unoclp"]));
        let mut zip = ZipArchive::new(Cursor::new(bytes)).unwrap();
        assert_eq!(
            zip.file_names().map(Result::unwrap).collect::<Vec<_>>(),
            ["NOTICE", "unoclp"]
        );
        let mut file = zip.by_name("unoclp").unwrap();
        assert_eq!(file.unix_mode().map(|mode| mode & 0o777), Some(0o755));
        assert_eq!(file.last_modified(), Some(DateTime::default()));
        let mut text = String::new();
        file.read_to_string(&mut text).unwrap();
        assert_eq!(text, "unoclp".repeat(100));
    }
}
