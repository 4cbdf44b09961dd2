//! A run of a machine as an animated GIF.
//!
//! Owns how pictures become one. Must not know what they show.

use unoclp_plant::Picture;

/// An animation has no more pictures than these.
const MOST: u64 = 240;
/// Nor more than one each 100 ms, which a browser shows.
const LEAST: u64 = 100;

/// How far its pictures are from each other, ms, where it goes on for so long.
pub fn every(span: u64) -> u64 {
    span.div_ceil(MOST).max(LEAST).next_multiple_of(10)
}

#[cfg(feature = "gif")]
mod made {
    use super::Picture;
    use resvg::{tiny_skia, usvg};
    use std::sync::Arc;

    /// An animation that is being made.
    pub struct Film {
        options: usvg::Options<'static>,
        /// The pixels of each picture, and its size.
        frames: Vec<Vec<u8>>,
        size: (u32, u32),
    }

    impl Film {
        /// One without a picture.
        #[expect(
            clippy::new_without_default,
            reason = "it looks for the fonts of this PC"
        )]
        pub fn new() -> Film {
            let mut fonts = usvg::fontdb::Database::new();
            fonts.load_system_fonts();
            Film {
                options: usvg::Options {
                    fontdb: Arc::new(fonts),
                    ..usvg::Options::default()
                },
                frames: Vec::new(),
                size: (0, 0),
            }
        }

        /// Adds a picture.
        ///
        /// # Errors
        /// Why it cannot be drawn.
        pub fn add(&mut self, picture: &Picture) -> Result<(), String> {
            let tree = usvg::Tree::from_str(&picture.svg(), &self.options);
            let tree = tree.map_err(|error| error.to_string())?;
            let (width, height) = picture.size();
            let map = tiny_skia::Pixmap::new(width, height);
            let mut map = map.ok_or_else(|| format!("{width} × {height}"))?;
            resvg::render(&tree, tiny_skia::Transform::identity(), &mut map.as_mut());
            self.size = (width, height);
            // All are opaque, so that colours stand as they are.
            self.frames.push(map.take());
            Ok(())
        }

        /// The file; each picture is shown for so long, ms.
        ///
        /// # Errors
        /// What the writer says.
        pub fn finish(self, every: u64) -> Result<Vec<u8>, String> {
            let (width, height) = self.size;
            let told = |error: gif::EncodingError| error.to_string();
            let side = |side: u32| u16::try_from(side).map_err(|error| error.to_string());
            let (w, h) = (side(width)?, side(height)?);
            let palette = palette(&self.frames);
            let mut bytes = Vec::new();
            let mut encoder =
                gif::Encoder::new(&mut bytes, w, h, &palette.colours).map_err(told)?;
            encoder.set_repeat(gif::Repeat::Infinite).map_err(told)?;
            let delay = u16::try_from(every / 10).unwrap_or(u16::MAX);
            let mut before: Option<Vec<u8>> = None;
            for pixels in &self.frames {
                let now = palette.places(pixels);
                let frame = changed(&now, before.as_deref(), width, delay);
                encoder.write_frame(&frame).map_err(told)?;
                before = Some(now);
            }
            drop(encoder);
            Ok(bytes)
        }
    }

    /// The colour that leaves what was there.
    const CLEAR: u8 = 255;

    struct Palette {
        colours: Vec<u8>,
        /// For each colour of 15 bits, its place.
        places: Vec<u8>,
    }

    /// A colour of 15 bits.
    fn short(pixel: &[u8]) -> usize {
        let part = |at: usize| usize::from(pixel.get(at).copied().unwrap_or(0) >> 3);
        part(0) << 10 | part(1) << 5 | part(2)
    }

    /// The 255 colours that stand most often, with the others put to the nearest.
    fn palette(frames: &[Vec<u8>]) -> Palette {
        let mut counts = vec![0_u64; 1 << 15];
        let mut sums = vec![[0_u64; 3]; 1 << 15];
        for pixel in frames.iter().flat_map(|frame| frame.chunks_exact(4)) {
            let at = short(pixel);
            counts[at] += 1;
            for (sum, part) in sums[at].iter_mut().zip(pixel) {
                *sum += u64::from(*part);
            }
        }
        let mut most: Vec<usize> = (0..counts.len()).filter(|at| counts[*at] > 0).collect();
        most.sort_by_key(|at| std::cmp::Reverse(counts[*at]));
        most.truncate(usize::from(CLEAR));
        let mean = |at: &usize| sums[*at].map(|sum| (sum / counts[*at].max(1)) as u8);
        let colours: Vec<[u8; 3]> = most.iter().map(mean).collect();
        let nearest = |at: usize| {
            let own = [at >> 10 & 31, at >> 5 & 31, at & 31].map(|part| (part * 8 + 4) as i32);
            let far = |colour: &[u8; 3]| -> i32 {
                let parts = colour.iter().zip(own);
                parts
                    .map(|(part, own)| (i32::from(*part) - own).pow(2))
                    .sum()
            };
            let best = colours
                .iter()
                .enumerate()
                .min_by_key(|(_, colour)| far(colour));
            best.map_or(0, |(place, _)| place as u8)
        };
        let is_used = |at: usize| counts[at] > 0;
        let places = (0..counts.len()).map(|at| if is_used(at) { nearest(at) } else { 0 });
        Palette {
            places: places.collect(),
            colours: colours.concat(),
        }
    }

    impl Palette {
        fn places(&self, pixels: &[u8]) -> Vec<u8> {
            let place = |pixel: &[u8]| self.places.get(short(pixel)).copied().unwrap_or(0);
            pixels.chunks_exact(4).map(place).collect()
        }
    }

    /// The frame of what has changed alone.
    fn changed(now: &[u8], before: Option<&[u8]>, width: u32, delay: u16) -> gif::Frame<'static> {
        let wide = width as usize;
        let differs = |at: usize| before.is_none_or(|before| before.get(at) != now.get(at));
        let (mut left, mut top, mut right, mut bottom) = (wide, usize::MAX, 0, 0);
        for at in (0..now.len()).filter(|at| differs(*at)) {
            let (x, y) = (at % wide, at / wide);
            (left, right) = (left.min(x), right.max(x + 1));
            (top, bottom) = (top.min(y), bottom.max(y + 1));
        }
        if right == 0 {
            (left, top, right, bottom) = (0, 0, 1, 1);
        }
        let row = |y: usize| (left..right).map(move |x| y * wide + x);
        let pixel = |at: usize| match differs(at) {
            true => now.get(at).copied().unwrap_or(0),
            false => CLEAR,
        };
        let buffer: Vec<u8> = (top..bottom).flat_map(row).map(pixel).collect();
        gif::Frame {
            delay,
            dispose: gif::DisposalMethod::Keep,
            transparent: Some(CLEAR),
            left: left as u16,
            top: top as u16,
            width: (right - left) as u16,
            height: (bottom - top) as u16,
            buffer: buffer.into(),
            ..gif::Frame::default()
        }
    }
}

#[cfg(not(feature = "gif"))]
mod made {
    use super::Picture;

    /// None can be made: this program is built without.
    pub struct Film;

    impl Film {
        /// None.
        #[expect(clippy::new_without_default, reason = "as the other one")]
        pub fn new() -> Film {
            Film
        }

        /// # Errors
        /// Always.
        pub fn add(&mut self, _: &Picture) -> Result<(), String> {
            Err(crate::messages::built_without_gif())
        }

        /// # Errors
        /// Always.
        pub fn finish(self, _: u64) -> Result<Vec<u8>, String> {
            Err(crate::messages::built_without_gif())
        }
    }
}

pub use made::Film;
