//! Whatever bytes come as a request: the server answers as the oracle does, in slices of whatever size.

use crate::common::compare;

/// What holds of all bytes, the first of which is the size of the slices; the target `modbus` of `proof/fuzz/`
/// looks for those of which it does not.
pub fn hold(bytes: &[u8]) {
    let Some((&most, request)) = bytes.split_first() else {
        return;
    };
    // Longer frames are given up before they are looked at; the checksum takes two bytes.
    let request = &request[..request.len().min(254)];
    assert!(compare(request, most), "{request:02x?}");
}

#[test]
fn every_file_of_the_corpus() {
    unoclp_testing::each_of_corpus("modbus", hold);
}
