/** What the sheet of a chart tells, up through the page, when its parts have become other instructions. */
export const DRAWN = "chart-drawn";
