//! From the numeric code to Instruction List.
use unoclp_core::Fault;
/// Why a program cannot be read back.
pub type BackError = Fault;
/// TODO
pub fn to_il(_file: &[u8]) -> Result<String, BackError> {
    Ok(String::new())
}
