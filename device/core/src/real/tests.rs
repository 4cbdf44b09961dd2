use super::*;

const ERROR: (i32, bool) = (0, true);
const LEAST: f32 = f32::MIN_POSITIVE;

fn bits(number: f32) -> i32 {
    number.to_bits().cast_signed()
}

fn is(number: f32) -> (i32, bool) {
    (bits(number), false)
}

#[test]
fn what_is_not_finite_is_0_and_an_error() {
    let (one, zero) = (bits(1.0), 0);
    let none = [f32::INFINITY, f32::NEG_INFINITY, f32::NAN, -f32::NAN].map(bits);
    for x in none {
        for operation in [add, subtract, multiply] {
            assert_eq!(operation(x, one), ERROR);
            assert_eq!(operation(one, x), ERROR);
        }
        for operation in [square_root, round, cut, negate, absolute] {
            assert_eq!(operation(x), ERROR);
        }
        assert_eq!(divide(x, one), ERROR);
        assert_eq!(multiply(x, zero), ERROR);
    }
    assert_eq!(add(bits(f32::MAX), bits(f32::MAX)), ERROR);
    assert_eq!(divide(one, zero), ERROR);
    assert_eq!(divide(zero, zero), ERROR);
    assert_eq!(square_root(bits(-1.0)), ERROR);
}

#[test]
fn zeros_and_infinities_have_signs() {
    assert_eq!(divide(bits(1.0), bits(f32::NEG_INFINITY)), is(-0.0));
    assert_eq!(add(bits(-0.0), 0), is(0.0));
    assert_eq!(add(bits(-0.0), bits(-0.0)), is(-0.0));
    assert_eq!(subtract(bits(1.0), bits(1.0)), is(0.0));
    assert_eq!(multiply(bits(-1.0), 0), is(-0.0));
    assert_eq!(square_root(bits(-0.0)), is(-0.0));
    assert_eq!(negate(0), is(-0.0));
    assert_eq!(absolute(bits(-0.0)), is(0.0));
}

#[test]
fn halves_go_to_the_even_integer() {
    let cases = [
        (0.5, 0, 0),
        (1.5, 2, 1),
        (2.5, 2, 2),
        (-0.5, 0, 0),
        (-1.5, -2, -1),
        (-2.500_000_2, -3, -2),
        (8_388_607.5, 8_388_608, 8_388_607),
        (-2_147_483_648.0, i32::MIN, i32::MIN),
        (2_147_483_520.0, 2_147_483_520, 2_147_483_520),
    ];
    for (number, nearest, whole) in cases {
        assert_eq!(round(bits(number)), (nearest, false), "{number}");
        assert_eq!(cut(bits(number)), (whole, false), "{number}");
    }
    for number in [2_147_483_648.0, -2_147_483_904.0, f32::MAX] {
        assert_eq!(round(bits(number)), ERROR);
        assert_eq!(cut(bits(number)), ERROR);
    }
}

#[test]
fn integers_become_the_nearest_real() {
    assert_eq!(from_signed(-16_777_217), is(-16_777_216.0));
    assert_eq!(from_signed(16_777_219), is(16_777_220.0));
    assert_eq!(from_signed(i32::MIN), is(-2_147_483_648.0));
    assert_eq!(from_unsigned(-1), is(4_294_967_296.0));
    assert_eq!(from_unsigned(0), is(0.0));
}

#[test]
fn roots_of_squares_are_exact() {
    for root in (1..16_777_216).step_by(997) {
        let root = root as f32;
        for root in [root, root / 1_048_576.0] {
            let (square, error) = multiply(bits(root), bits(root));
            assert!(!error);
            let came = real(square_root(square).0);
            assert!((came - root).abs() <= root * f32::EPSILON, "{root}: {came}");
        }
    }
    assert_eq!(square_root(bits(2.0)), is(core::f32::consts::SQRT_2));
    assert_eq!(square_root(1), is(3.743_392e-23));
}

#[test]
fn only_the_least_results_forget_digits() {
    assert_eq!(multiply(bits(LEAST), bits(0.5)), is(LEAST / 2.0));
    assert_eq!(multiply(bits(LEAST), bits(1.5)), is(LEAST * 1.5));
    assert_eq!(divide(bits(LEAST), bits(2.0)), is(LEAST / 2.0));
    assert_eq!(divide(bits(-LEAST), bits(f32::MAX)), is(-0.0));
    // 2,396,744.57 steps: the chip forgets them after 2,396,744.5.
    assert_eq!(divide(0x7F_FFFE, bits(3.5)), (0x24_9248, false));
    assert_eq!(multiply(1, 1), is(0.0));
    assert_eq!(multiply(1, bits(-1.0)), is(-f32::from_bits(1)));
}

#[test]
fn comparable_integers_have_the_order_of_reals() {
    let numbers = [
        f32::NEG_INFINITY,
        f32::MIN,
        -1.5,
        -1.0,
        -f32::from_bits(1),
        0.0,
        1e-40,
        LEAST,
        1.0,
        f32::MAX,
    ];
    assert!(
        numbers
            .map(|number| comparable(bits(number)))
            .is_sorted_by(|a, b| a < b)
    );
    assert_eq!(comparable(bits(-0.0)), 0);
}
