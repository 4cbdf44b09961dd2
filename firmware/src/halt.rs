//! The last resort: outputs off, and stop.
//!
//! Nothing in the firmware should get here. If it does, by a panic that was thought impossible,
//! the outputs must not keep what they had.

#[cfg(not(mega))]
use avr_device::atmega328p::Peripherals;
use core::panic::PanicInfo;

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    abort()
}

/// Takes the place of the C library's `abort`, which is what a panic compiles to in this build.
#[allow(
    clippy::empty_loop,
    reason = "there is nothing to wait for, and a simulator knows a jump to itself for the end"
)]
#[unsafe(no_mangle)]
extern "C" fn abort() -> ! {
    avr_device::interrupt::disable();
    // The watchdog resets the chip soon; what ended here must not run again.
    crate::board::watchdog::scan_is_overdue();
    #[cfg(not(mega))]
    {
        // SAFETY: nothing else runs any more, so nobody else uses the ports.
        let chip = unsafe { Peripherals::steal() };
        let _ = crate::board::pins::Pins::new(chip.PORTB, chip.PORTC, chip.PORTD);
        crate::board::pwm::set_d6(&chip.TC0, 0);
        crate::board::pwm::set_d9(&chip.TC1, 0);
    }
    #[cfg(mega)]
    crate::board::switch_off();
    loop {}
}
