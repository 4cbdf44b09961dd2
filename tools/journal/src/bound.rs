//! How much a journal holds at most.

use rusqlite::{Connection, Error};

/// Of too much, so large a part goes at once: the oldest.
const PART: u64 = 20;

/// The bytes of a file's pages that hold something.
pub(crate) fn used(file: &Connection) -> Result<u64, Error> {
    let number = |name| file.pragma_query_value(None, name, |row| row.get::<_, i64>(0));
    let pages = number("page_count")? - number("freelist_count")?;
    Ok(u64::try_from(pages * number("page_size")?).unwrap_or(0))
}

/// Up to which number entries go, where there are those from `first` to `last` and they are too much.
pub(crate) fn up_to(first: u64, last: u64) -> u64 {
    first + (last - first) / PART
}
