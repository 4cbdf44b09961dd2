//! Points, and images of them.

use unoclp_core::{Board, Image, Point};

#[test]
fn a_point_has_its_number_and_the_index_before_it() {
    for number in 1..=Point::MOST {
        let point = Point::new(number, Point::MOST).unwrap();
        assert_eq!((point.number(), point.index()), (number, number - 1));
    }
    assert_eq!(Point::new(0, 8), None);
    assert_eq!(Point::new(9, 8), None);
    assert_eq!(Point::new(100, 255), None);
}

#[test]
fn an_image_has_a_bit_for_each_point() {
    for number in 1..=Point::MOST {
        let point = Point::new(number, Point::MOST).unwrap();
        let mut image = Image::default();
        image.set(point, true);
        assert_eq!(image.0, 1 << (number - 1));
        assert!(image.get(point));
        image.set(point, false);
        assert_eq!(image, Image::default());
    }
}

#[test]
fn an_analogue_input_of_an_uno_shares_the_pin_of_an_input() {
    let shared = |board: Board| (0..6).map(move |analogue| board.shares(analogue));
    assert!(shared(Board::UNO).eq([Some(5), Some(6), Some(7), Some(8), None, None]));
    assert!(shared(Board::MEGA).all(|input| input.is_none()));
}
