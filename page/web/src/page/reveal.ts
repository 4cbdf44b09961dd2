// Scrolling into view. A phone shows the three areas as pages side by side: these turn when the user asks for it, and stay when
// something is drawn anew or takes the keyboard.

import { EditorView } from "@codemirror/view";

/** The shortest way, px, to bring both edges of something into its room; each edge is given from the same edge of the room. */
function way(first: number, last: number): number {
  return first < 0 ? Math.min(0, Math.max(first, last)) : Math.max(0, Math.min(first, last));
}

/** Has an element be seen on its page. */
export function reveal(element: Element): void {
  const page = element.closest("main > *");
  if (element === page) return;
  for (let room = element.parentElement; room; room = room === page ? null : room.parentElement) {
    const [at, on] = [element.getBoundingClientRect(), room.getBoundingClientRect()];
    const [left, top] = [on.left + room.clientLeft, on.top + room.clientTop];
    room.scrollBy(way(at.left - left, at.right - left - room.clientWidth), way(at.top - top, at.bottom - top - room.clientHeight));
  }
}

/** Turns a phone to the page of this area. */
export function turnTo(area: HTMLElement): void {
  area.scrollIntoView({ inline: "start", block: "nearest" });
}

/** Gives the keyboard back to an element, unless the user has gone on to another area with it. */
export function attend(element: HTMLElement): void {
  const now = document.activeElement;
  const isElsewhere = now !== null && now !== document.body && !element.closest("main > *")?.contains(now);
  if (!isElsewhere) element.focus({ preventScroll: true });
}

/** The editor's text scrolls alone as long as its page is not the one shown. */
export const scrollsAlone = EditorView.scrollHandler.of((view, { head }) => {
  const { left, right } = view.dom.getBoundingClientRect();
  if (right > 0 && left < innerWidth) return false;
  const { top, bottom } = view.lineBlockAt(head);
  const from = view.scrollDOM.scrollTop - view.documentPadding.top;
  view.scrollDOM.scrollTop += way(top - from, bottom - from - view.scrollDOM.clientHeight);
  return true;
});
