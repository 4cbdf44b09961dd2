//! Suggestions for an undeclared word.

/// The name that is a slip of the hand away, two in a long one.
pub fn nearest<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let wrong = wrong.to_uppercase();
    let length = wrong.chars().count();
    let slips = (length / 3).min(2);
    names
        .filter(|name| name.len().abs_diff(wrong.len()) <= slips)
        .map(|name| (strsim::osa_distance(&name.to_uppercase(), &wrong), name))
        .filter(|(distance, _)| (1..=slips).contains(distance))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}
