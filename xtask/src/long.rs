//! The tests that take ten seconds or more on one processor.
//!
//! Owns their names. Must not know how tests are run.

/// Those that go through as many rounds or cases as they are told to: a quick run makes few of them.
const OF_CASES: [&str; 19] = [
    "suite::every_scenario_in_lockstep",
    "suite::every_scenario_in_lockstep_on_avr8js",
    "lockstep::random_programs_behave_alike",
    "lockstep::random_programs_behave_alike_on_avr8js",
    "lockstep::random_programs_behave_alike_on_a_nano",
    "watchdog::a_stalled_scan_turns_the_outputs_off_within_150_ms",
    "watchdog::a_stalled_scan_turns_the_outputs_off_behind_a_boot_loader_too",
    "fault_matrix::every_fault_at_every_command_and_block",
    "modbus_frames::mutated_frames",
    "modbus_frames::random_frames",
    "modbus_boundaries::in_fault",
    "modbus_boundaries::in_run",
    "modbus_boundaries::in_stop",
    "run_memory::a_program_that_changes_in_run_memory_is_a_fault",
    "boot_loaders::on_a_line_that_drops_delays_and_changes_bytes_the_next_try_works",
    "cards::every_card_and_volume",
    "any_text::mutated_listings",
    "any_text::random_words",
    "languages::every_language_passes_the_scenario",
];

/// The others, which a quick run leaves out.
pub const WHOLE: [&str; 11] = [
    "any_text_takes_work_in_proportion_to_its_size",
    "boot_loaders::the_firmware_goes_through_each_boot_loader_and_runs_a_program",
    "boot_loaders::the_firmware_goes_through_a_pseudo_terminal",
    "suite::programs_and_timers_on_the_running_clock",
    "suite::every_scenario_in_lockstep_on_a_nano",
    "suite::every_scenario_in_lockstep_before_the_firmware_is_shortened",
    "start_up::a_dead_card_is_given_up_within_2_s",
    "modbus_line::settings_cut_by_a_power_failure_are_the_old_ones_or_the_new_ones",
    "retentive::a_marker_that_always_changes_does_not_wear_the_eeprom_out",
    "state::a_still_board_saves_each_minute",
    "state_power::a_power_cut_in_a_save_damages_nothing",
];

/// Whether a test makes as many rounds, or goes through as many cases, as it is told to.
pub fn is_of_cases(name: &str) -> bool {
    OF_CASES.iter().any(|long| name.ends_with(long)) || is_random(name)
}

/// Whether a test makes as many rounds of what is random as it is told to: its name says so.
pub fn is_random(name: &str) -> bool {
    ["random", "mutated", "a_long_run"]
        .iter()
        .any(|word| name.contains(word))
}

/// All of them.
pub fn all() -> impl Iterator<Item = &'static str> {
    OF_CASES.iter().chain(&WHOLE).copied()
}
