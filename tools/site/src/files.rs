//! The files that a site file names, as whoever has them lends them.

/// The files that a site file names.
pub trait Files {
    /// The bytes of this file, whose name counts from the folder of the site file.
    ///
    /// # Errors
    /// Why there are none, for people.
    fn bytes(&self, name: &str) -> Result<Vec<u8>, String>;
}
