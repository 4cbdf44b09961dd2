// The paper that one prints on.

/** Whether it is Letter, as in the United States; else it is A4. */
export function isLetter(): boolean {
  return navigator.language === "en-US";
}
