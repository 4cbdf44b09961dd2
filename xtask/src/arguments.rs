//! No function of a Mega's firmware takes an argument on the stack: the compiler looks for it a byte too low there
//! (`docs/avr-codegen.md`).

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};

/// Checks the compiler's assembly of a whole firmware.
///
/// # Errors
/// Where a function reaches beyond its frame: that is where an argument would stand.
pub fn accept(assembly: &Path) -> Result<()> {
    let text = fs::read_to_string(assembly)
        .with_context(|| format!("cannot read {}", assembly.display()))?;
    let found = beyond_frames(&text);
    ensure!(
        found.is_empty(),
        "arguments on the stack, which the compiler does not find on this chip: {}",
        found.join(", ")
    );
    Ok(())
}

/// The functions that reach beyond their frames, which Y points before.
fn beyond_frames(text: &str) -> Vec<String> {
    let (mut found, mut name, mut frame, mut low) = (Vec::new(), "", None, None);
    for line in text.lines() {
        if let Some((label, _)) = line.split_once(':')
            && !label.starts_with(['.', ' ', '\t'])
        {
            (name, frame, low) = (label, None, None);
        }
        let line = line.trim();
        let number = |before: &str| line.strip_prefix(before)?.trim().parse::<u32>().ok();
        if line == "in\tr28, 61" {
            frame = Some(0);
        } else if let (Some(0), Some(bytes)) = (frame, number("sbiw\tr28,")) {
            frame = Some(bytes);
        } else if let (Some(0), Some(bytes)) = (frame, number("subi\tr28,")) {
            low = Some(bytes);
        } else if let (Some(bytes), Some(high)) = (low, number("sbci\tr29,")) {
            (frame, low) = (Some(bytes + 256 * high), None);
        }
        let place = line.split_once("Y+").map(|(_, place)| place);
        let digits = place.map(|place| place.split(|c: char| !c.is_ascii_digit()).next());
        let place = digits
            .flatten()
            .and_then(|digits| digits.parse::<u32>().ok());
        let is_beyond = matches!((frame, place), (Some(frame), Some(place)) if place > frame);
        if is_beyond && found.last().is_none_or(|last| last != name) {
            found.push(name.to_owned());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::beyond_frames;

    #[test]
    fn what_stands_beyond_the_frame_is_an_argument() {
        let taken = "last:\n\tpush\tr28\n\tin\tr28, 61\n\tin\tr29, 62\n\tldd\tr24, Y+9\n\tret\n";
        assert_eq!(beyond_frames(taken), ["last"]);
        let own = "own:\n\tin\tr28, 61\n\tin\tr29, 62\n\tsbiw\tr28, 9\n\tldd\tr24, Y+9\n\tstd\tY+1, r24\n\tret\n";
        assert_eq!(beyond_frames(own), [""; 0]);
        let large =
            "large:\n\tin\tr28, 61\n\tsubi\tr28, 4\n\tsbci\tr29, 1\n\tldd\tr24, Y+63\n\tret\n";
        assert_eq!(beyond_frames(large), [""; 0]);
        // Y as a pointer, in assembly.
        assert_eq!(
            beyond_frames("put:\n\tmovw\tr28, r24\n\tldd\tr24, Y+30\n"),
            [""; 0]
        );
    }
}
